// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 29 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2891 bits, pipeline 8426 bits, memories 120207 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q, valid_s28_q, valid_s29_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en, s27_en, s28_en;
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

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_2331;
  assign sum_2331 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3334;
  assign difference_3334 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [7:0] difference_3554;
  assign difference_3554 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_3756;
  assign less_3756 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_3757;
  assign sum_3757 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_3775;
  assign not_3775 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_458;
  assign select_458 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_458 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_458_s1_q;
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
      select_458_s1_q <= select_458;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:35
  logic [6:0] select_461;
  assign select_461 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:50
  logic equal_493;
  assign equal_493 = select_458_s1_q == 4'hf;
  // hls/stages/agreement.hpp:263
  logic [6:0] select_1980;
  assign select_1980 = sample_pair_whole_s1_q ? (select_461 + {6'h0, equal_493}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_1980;
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
  logic [3:0] select_458_s2_q;
  logic [6:0] select_461_s2_q;
  logic equal_493_s2_q;
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
      select_458_s2_q <= select_458_s1_q;
      select_461_s2_q <= select_461;
      equal_493_s2_q <= equal_493;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:109
  logic equal_459;
  assign equal_459 = select_458_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:115
  logic [8:0] select_464;
  assign select_464 = ({select_461_s2_q, select_458_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_465;
  assign select_465 = equal_459 ? select_464 : averager_place_q;
  // hls/stages/census.hpp:41
  logic [3:0] select_476;
  assign select_476 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1978;
  assign select_1978 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_476 + 4'h1) : select_476) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_1978;
      averager_place_q <= sample_pair_whole_s2_q ? select_465 : averager_place_q;
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
  logic [3:0] select_458_s3_q;
  logic equal_459_s3_q;
  logic [6:0] select_461_s3_q;
  logic [8:0] select_465_s3_q;
  logic equal_467_s3_q;
  logic [3:0] select_476_s3_q;
  logic equal_493_s3_q;
  logic equal_494_s3_q;
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
      select_458_s3_q <= select_458_s2_q;
      equal_459_s3_q <= equal_459;
      select_461_s3_q <= select_461_s2_q;
      select_465_s3_q <= select_465;
      equal_467_s3_q <= select_458_s2_q[1:0] == 2'h3;
      select_476_s3_q <= select_476;
      equal_493_s3_q <= equal_493_s2_q;
      equal_494_s3_q <= select_476 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:41
  logic or_466;
  assign or_466 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_471;
  assign and_471 = (or_466 & equal_467_s3_q) & (~(select_465_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_461_s3_q : 7'h0;
  // hls/stages/census.hpp:126
  logic and_495;
  assign and_495 = equal_494_s3_q & and_471;
  // hls/stages/agreement.hpp:263
  logic and_497;
  assign and_497 = sample_pair_whole_s3_q & (equal_493_s3_q & and_495);
  // hls/stages/census.hpp:41
  logic [6:0] select_556;
  assign select_556 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_556 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_1982;
  assign select_1982 = sample_last_s3_q ? (select_556 + {6'h0, equal_494_s3_q}) : select_556;
  // hls/stages/agreement.hpp:263
  logic select_1987;
  assign select_1987 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_466 & (~raster_final_row_q)) : or_466) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_1989;
  assign select_1989 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:263
  logic select_1993;
  assign select_1993 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2237;
  assign equal_2237 = {last[7], column} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_1982 : raster_at_row_q;
      raster_at_live_q <= select_1987;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_1989 : raster_rows_left_q;
      raster_final_row_q <= select_1993;
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
  logic [3:0] select_458_s4_q;
  logic equal_459_s4_q;
  logic [6:0] select_461_s4_q;
  logic [8:0] select_465_s4_q;
  logic and_471_s4_q;
  logic [3:0] select_476_s4_q;
  logic [6:0] column_s4_q;
  logic and_495_s4_q;
  logic and_497_s4_q;
  logic [3:0] select_556_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1585_s4_q;
  logic equal_2237_s4_q;
  logic and_2238_s4_q;
  logic [7:0] sum_2327_s4_q;
  logic [2:0] or_2720_s4_q;
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
      select_458_s4_q <= select_458_s3_q;
      equal_459_s4_q <= equal_459_s3_q;
      select_461_s4_q <= select_461_s3_q;
      select_465_s4_q <= select_465_s3_q;
      and_471_s4_q <= and_471;
      select_476_s4_q <= select_476_s3_q;
      column_s4_q <= column;
      and_495_s4_q <= and_495;
      and_497_s4_q <= and_497;
      select_556_s4_q <= select_556[3:0];
      row_s4_q <= row;
      equal_1585_s4_q <= {or_466, select_476_s3_q} == 5'h18;
      equal_2237_s4_q <= equal_2237;
      and_2238_s4_q <= and_497 & equal_2237;
      sum_2327_s4_q <= {1'b0, row} + 8'h1;
      or_2720_s4_q <= select_461_s3_q[2:0] | select_556[6:4];
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
  logic equal_517;
  assign equal_517 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:601
  logic equal_520;
  assign equal_520 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_522;
  assign equal_522 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:510
  logic select_2241;
  assign select_2241 = (and_2238_s4_q | (~ends_cell_q)) ? and_2238_s4_q : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2241 ? (and_2238_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2245;
  assign select_2245 = select_2241 ? (and_2238_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2248;
  assign select_2248 = select_2241 ? (following_last_shift_q & (~and_2238_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:522
  logic [7:0] select_2250;
  assign select_2250 = select_2241 ? (and_2238_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:594
  logic and_2251;
  assign and_2251 = run_last_shift_q & equal_520;
  // hls/stages/agreement.hpp:603
  logic select_2253;
  assign select_2253 = equal_520 ? (~run_last_shift_q) : equal_522;
  // hls/stages/agreement.hpp:607
  logic equal_2254;
  assign equal_2254 = run_phase_q == 3'h1;
  logic not_2257;
  assign not_2257 = ~select_2253;
  // hls/stages/agreement.hpp:610
  logic equal_2259;
  assign equal_2259 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2260;
  assign and_2260 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2261;
  assign select_2261 = equal_2259 ? 2'h1 : {2{and_2260}};
  logic [2:0] select_2263;
  assign select_2263 = (and_2251 | (select_2253 | equal_2254)) ? (equal_2254 ? 3'h2 : {not_2257, {2{select_2253}}}) : (equal_517 ? 3'h6 : {select_2261[0], select_2261});
  // hls/stages/agreement.hpp:594
  logic and_2266;
  assign and_2266 = select_2253 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2269;
  assign select_2269 = (plan_shift_q[5] & select_2253) ? value : 7'h0;
  logic [1:0] or_2270;
  assign or_2270 = {2{so}} | select_2269[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_2274;
  assign or_2274 = (select_2253 ? plan_columns_q : 8'h0) | ((equal_2254 | equal_2259) ? whole_q : 8'h0);
  logic [1:0] or_2275;
  assign or_2275 = {2{and_2251}} | or_2274[4:3];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2277;
  assign or_2277 = {or_2274[7:5], or_2275, or_2274[2:0]} | (equal_517 ? drawn_q : 8'h0);
  logic [4:0] or_2278;
  assign or_2278 = {5{so}} | {or_2277[6], or_2277[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2282;
  assign not_2282 = ~run_shift_q[5];
  logic [7:0] select_2285;
  assign select_2285 = equal_520 ? ({{7{not_2282}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2289;
  assign select_2289 = and_2238_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2291;
  assign select_2291 = select_2241 ? {select_2289[6], select_2289} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2294;
  assign select_2294 = select_2241 ? (and_2238_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:447
  logic [6:0] select_2301;
  assign select_2301 = equal_2237_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_2305;
  assign select_2305 = and_497_s4_q ? (equal_2237_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2308;
  assign select_2308 = and_497_s4_q ? (equal_2237_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2322;
  assign select_2322 = (ends_cell_q | select_2241) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_520 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2326;
  assign and_2326 = (~select_2241) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic equal_2328;
  assign equal_2328 = {sum_2327_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2327_s4_q[6:0]};
  // hls/stages/agreement.hpp:507
  logic select_2330;
  assign select_2330 = and_497_s4_q ? (equal_2237_s4_q ? equal_2328 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:325
  logic [8:0] sum_2721;
  assign sum_2721 = {1'b0, select_461_s4_q[3], or_2720_s4_q, select_556_s4_q} + 9'h1;

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
      run_shift_q <= select_2245;
      run_last_shift_q <= select_2248;
      run_span_q <= select_2250;
      following_phase_q <= select_2263;
      following_shift_q <= select_2253 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2266;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2269[6], or_2270, select_2269[3:0]};
      following_columns_q <= {or_2277[7], or_2278[4], or_2277[5:4], or_2278[3:0]};
      plan_shift_q <= equal_520 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2285;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2291;
      columns_left_q <= select_2294;
      last_q <= and_497_s4_q ? (equal_2237_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_497_s4_q ? select_2301 : least_q;
      whole_q <= select_2305;
      drawn_q <= select_2308;
      slot_q <= select_2241 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2322;
      ends_q <= and_2326;
      final_row_q <= select_2330;
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
  logic [3:0] select_458_s5_q;
  logic equal_459_s5_q;
  logic [6:0] select_461_s5_q;
  logic [8:0] select_465_s5_q;
  logic and_471_s5_q;
  logic equal_477_s5_q;
  logic [6:0] column_s5_q;
  logic and_495_s5_q;
  logic and_497_s5_q;
  logic so_s5_q;
  logic equal_517_s5_q;
  logic equal_520_s5_q;
  logic equal_522_s5_q;
  logic [7:0] sum_523_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_633_s5_q;
  logic equal_642_s5_q;
  logic equal_1466_s5_q;
  logic equal_1585_s5_q;
  logic equal_2237_s5_q;
  logic and_2238_s5_q;
  logic select_2241_s5_q;
  logic not_2723_s5_q;
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
      select_458_s5_q <= select_458_s4_q;
      equal_459_s5_q <= equal_459_s4_q;
      select_461_s5_q <= select_461_s4_q;
      select_465_s5_q <= select_465_s4_q;
      and_471_s5_q <= and_471_s4_q;
      equal_477_s5_q <= select_476_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_495_s5_q <= and_495_s4_q;
      and_497_s5_q <= and_497_s4_q;
      so_s5_q <= so;
      equal_517_s5_q <= equal_517;
      equal_520_s5_q <= equal_520;
      equal_522_s5_q <= equal_522;
      sum_523_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_633_s5_q <= {1'b0, last_q} + 8'h3;
      equal_642_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_1466_s5_q <= run_phase_q == 3'h7;
      equal_1585_s5_q <= equal_1585_s4_q;
      equal_2237_s5_q <= equal_2237_s4_q;
      and_2238_s5_q <= and_2238_s4_q;
      select_2241_s5_q <= select_2241;
      not_2723_s5_q <= ~({sum_2721, select_476_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_524;
  assign select_524 = run_shift_s5_q[5] ? x_s5_q : sum_523_s5_q;
  logic less_525;
  assign less_525 = {1'b0, last_s5_q} < select_524;
  // hls/stages/agreement.hpp:216
  logic not_526;
  assign not_526 = ~less_525;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:515
  logic [6:0] select_2310;
  assign select_2310 = select_2241_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2310;
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
  logic [3:0] select_458_s6_q;
  logic equal_459_s6_q;
  logic [6:0] select_461_s6_q;
  logic [8:0] select_465_s6_q;
  logic and_471_s6_q;
  logic equal_477_s6_q;
  logic [6:0] column_s6_q;
  logic and_495_s6_q;
  logic and_497_s6_q;
  logic so_s6_q;
  logic equal_517_s6_q;
  logic equal_520_s6_q;
  logic [6:0] sum_523_s6_q;
  logic less_525_s6_q;
  logic not_526_s6_q;
  logic and_527_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_637_s6_q;
  logic equal_642_s6_q;
  logic equal_1456_s6_q;
  logic equal_1466_s6_q;
  logic equal_1585_s6_q;
  logic equal_2237_s6_q;
  logic and_2238_s6_q;
  logic not_2723_s6_q;
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
      select_458_s6_q <= select_458_s5_q;
      equal_459_s6_q <= equal_459_s5_q;
      select_461_s6_q <= select_461_s5_q;
      select_465_s6_q <= select_465_s5_q;
      and_471_s6_q <= and_471_s5_q;
      equal_477_s6_q <= equal_477_s5_q;
      column_s6_q <= column_s5_q;
      and_495_s6_q <= and_495_s5_q;
      and_497_s6_q <= and_497_s5_q;
      so_s6_q <= so_s5_q;
      equal_517_s6_q <= equal_517_s5_q;
      equal_520_s6_q <= equal_520_s5_q;
      sum_523_s6_q <= sum_523_s5_q[6:0];
      less_525_s6_q <= less_525;
      not_526_s6_q <= not_526;
      and_527_s6_q <= equal_522_s5_q & not_526;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_637_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_633_s5_q < select_524)));
      equal_642_s6_q <= equal_642_s5_q;
      equal_1456_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1466_s6_q <= equal_1466_s5_q;
      equal_1585_s6_q <= equal_1585_s5_q;
      equal_2237_s6_q <= equal_2237_s5_q;
      and_2238_s6_q <= and_2238_s5_q;
      not_2723_s6_q <= not_2723_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:581
  logic or_518;
  assign or_518 = so_s6_q | equal_517_s6_q;
  // hls/stages/agreement.hpp:704
  logic not_519;
  assign not_519 = ~or_518;
  // hls/stages/agreement.hpp:141
  logic select_613;
  assign select_613 = equal_520_s6_q ? not_526_s6_q : and_527_s6_q;
  logic and_638;
  assign and_638 = equal_520_s6_q & and_637_s6_q;
  logic select_639;
  assign select_639 = or_518 ? not_526_s6_q : and_638;
  // hls/stages/agreement.hpp:782
  logic or_644;
  assign or_644 = equal_642_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_523_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1293; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_518 ? not_526_s6_q : select_613);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1294; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_520_s6_q ? sum_523_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_519 & select_613);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1295; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 46'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_518 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_639;
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
  logic [3:0] select_458_s7_q;
  logic equal_459_s7_q;
  logic [6:0] select_461_s7_q;
  logic [8:0] select_465_s7_q;
  logic and_471_s7_q;
  logic equal_477_s7_q;
  logic [6:0] column_s7_q;
  logic and_495_s7_q;
  logic and_497_s7_q;
  logic so_s7_q;
  logic equal_517_s7_q;
  logic or_518_s7_q;
  logic equal_520_s7_q;
  logic less_525_s7_q;
  logic not_526_s7_q;
  logic and_529_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_639_s7_q;
  logic select_646_s7_q;
  logic and_1448_s7_q;
  logic [6:0] right_s7_q;
  logic select_1457_s7_q;
  logic equal_1466_s7_q;
  logic equal_1585_s7_q;
  logic equal_2237_s7_q;
  logic and_2238_s7_q;
  logic not_2723_s7_q;
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
      select_458_s7_q <= select_458_s6_q;
      equal_459_s7_q <= equal_459_s6_q;
      select_461_s7_q <= select_461_s6_q;
      select_465_s7_q <= select_465_s6_q;
      and_471_s7_q <= and_471_s6_q;
      equal_477_s7_q <= equal_477_s6_q;
      column_s7_q <= column_s6_q;
      and_495_s7_q <= and_495_s6_q;
      and_497_s7_q <= and_497_s6_q;
      so_s7_q <= so_s6_q;
      equal_517_s7_q <= equal_517_s6_q;
      or_518_s7_q <= or_518;
      equal_520_s7_q <= equal_520_s6_q;
      less_525_s7_q <= less_525_s6_q;
      not_526_s7_q <= not_526_s6_q;
      and_529_s7_q <= not_519 & ((~equal_520_s6_q) & and_527_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_639_s7_q <= select_639;
      select_646_s7_q <= or_644 ? equal_642_s6_q : (~age_s6_q[1]);
      and_1448_s7_q <= not_519 & and_638;
      right_s7_q <= right;
      select_1457_s7_q <= or_644 ? equal_642_s6_q : equal_1456_s6_q;
      equal_1466_s7_q <= equal_1466_s6_q;
      equal_1585_s7_q <= equal_1585_s6_q;
      equal_2237_s7_q <= equal_2237_s6_q;
      and_2238_s7_q <= and_2238_s6_q;
      not_2723_s7_q <= not_2723_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_phase_q;
  // hls/stages/patches.hpp:94
  logic and_1579;
  assign and_1579 = (select_458_s7_q == 4'h0) & (select_461_s7_q == 7'h0);
  // hls/stages/patches.hpp:282
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:98
  logic [3:0] select_2657;
  assign select_2657 = and_1579 ? (sample_pair_first_s7_q ? phase : patches_phase_q) : patches_phase_q;

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1292; read in stage 7, written in stage 26: 7 < 26 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_529_s7_q;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_phase_q <= 4'h0;
    end else if (s7_en) begin
      patches_phase_q <= sample_pair_whole_s7_q ? select_2657 : patches_phase_q;
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
  logic [3:0] select_458_s8_q;
  logic equal_459_s8_q;
  logic [6:0] select_461_s8_q;
  logic [8:0] select_465_s8_q;
  logic and_471_s8_q;
  logic equal_477_s8_q;
  logic [6:0] column_s8_q;
  logic and_495_s8_q;
  logic and_497_s8_q;
  logic so_s8_q;
  logic equal_517_s8_q;
  logic or_518_s8_q;
  logic equal_520_s8_q;
  logic less_525_s8_q;
  logic not_526_s8_q;
  logic and_529_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_639_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic select_646_s8_q;
  logic and_1448_s8_q;
  logic [6:0] right_s8_q;
  logic select_1457_s8_q;
  logic equal_1466_s8_q;
  logic and_1579_s8_q;
  logic equal_1585_s8_q;
  logic equal_2237_s8_q;
  logic and_2238_s8_q;
  logic [3:0] phase_s8_q;
  logic not_2723_s8_q;
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
      select_458_s8_q <= select_458_s7_q;
      equal_459_s8_q <= equal_459_s7_q;
      select_461_s8_q <= select_461_s7_q;
      select_465_s8_q <= select_465_s7_q;
      and_471_s8_q <= and_471_s7_q;
      equal_477_s8_q <= equal_477_s7_q;
      column_s8_q <= column_s7_q;
      and_495_s8_q <= and_495_s7_q;
      and_497_s8_q <= and_497_s7_q;
      so_s8_q <= so_s7_q;
      equal_517_s8_q <= equal_517_s7_q;
      or_518_s8_q <= or_518_s7_q;
      equal_520_s8_q <= equal_520_s7_q;
      less_525_s8_q <= less_525_s7_q;
      not_526_s8_q <= not_526_s7_q;
      and_529_s8_q <= and_529_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_639_s8_q <= select_639_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      select_646_s8_q <= select_646_s7_q;
      and_1448_s8_q <= and_1448_s7_q;
      right_s8_q <= right_s7_q;
      select_1457_s8_q <= select_1457_s7_q;
      equal_1466_s8_q <= equal_1466_s7_q;
      and_1579_s8_q <= and_1579;
      equal_1585_s8_q <= equal_1585_s7_q;
      equal_2237_s8_q <= equal_2237_s7_q;
      and_2238_s8_q <= and_2238_s7_q;
      phase_s8_q <= phase;
      not_2723_s8_q <= not_2723_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:653
  logic not_617;
  assign not_617 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:212
  logic and_652;
  assign and_652 = left_rdata_s8_q[44] & not_526_s8_q;
  logic and_653;
  assign and_653 = right_codes_rdata_s8_q[38] & not_526_s8_q;
  logic [11:0] select_654;
  assign select_654 = less_525_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_655;
  assign select_655 = less_525_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_659;
  assign select_659 = and_652 ? (and_653 ? (~(select_654 ^ select_655)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_675;
  assign and_675 = left_rdata_s8_q[60] & not_526_s8_q;
  logic and_676;
  assign and_676 = right_codes_rdata_s8_q[51] & not_526_s8_q;
  logic [11:0] select_677;
  assign select_677 = less_525_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_678;
  assign select_678 = less_525_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_682;
  assign select_682 = and_675 ? (and_676 ? (~(select_677 ^ select_678)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_692;
  assign and_692 = left_rdata_s8_q[76] & not_526_s8_q;
  logic and_693;
  assign and_693 = right_codes_rdata_s8_q[64] & not_526_s8_q;
  logic [11:0] select_694;
  assign select_694 = less_525_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_695;
  assign select_695 = less_525_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_699;
  assign select_699 = and_692 ? (and_693 ? (~(select_694 ^ select_695)) : 12'h0) : 12'h0;
  logic [11:0] select_907;
  assign select_907 = (slot_s8_q[0] ? and_693 : and_676) ? (~(select_655 ^ (slot_s8_q[0] ? select_694 : select_677))) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_924;
  assign and_924 = right_codes_rdata_s8_q[77] & not_526_s8_q;
  logic [11:0] select_926;
  assign select_926 = less_525_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_930;
  assign select_930 = (slot_s8_q[0] ? and_924 : and_693) ? (~(select_678 ^ (slot_s8_q[0] ? select_926 : select_694))) : 12'h0;
  // hls/stages/agreement.hpp:718
  logic select_942;
  assign select_942 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_526_s8_q) : and_924;
  logic [11:0] select_944;
  assign select_944 = slot_s8_q[0] ? (less_525_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_926;
  // hls/stages/agreement.hpp:212
  logic and_1153;
  assign and_1153 = right_codes_rdata_s8_q[25] & not_526_s8_q;
  // hls/stages/agreement.hpp:718
  logic select_1154;
  assign select_1154 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_526_s8_q) : and_1153;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1156;
  assign select_1156 = less_525_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1157;
  assign select_1157 = slot_s8_q[0] ? (less_525_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1156;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1181;
  assign select_1181 = (slot_s8_q[0] ? and_1153 : and_653) ? (~(select_678 ^ (slot_s8_q[0] ? select_1156 : select_654))) : 12'h0;
  logic [11:0] select_1196;
  assign select_1196 = (slot_s8_q[0] ? and_653 : and_676) ? (~(select_695 ^ (slot_s8_q[0] ? select_654 : select_677))) : 12'h0;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:932
  logic and_1472;
  assign and_1472 = (or_518_s8_q & (left_rdata_s8_q[61] & not_526_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:235
  logic and_1480;
  assign and_1480 = not_526_s8_q & (or_518_s8_q & (left_rdata_s8_q[63] & not_526_s8_q));
  // hls/stages/agreement.hpp:447
  logic select_2334;
  assign select_2334 = equal_2237_s8_q ? (~({row_s8_q, 1'b0} < {sum_2331, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2547;
  assign and_2547 = and_497_s8_q & (equal_2237_s8_q & (row_s8_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s8_en) begin
      row_q <= and_497_s8_q ? (equal_2237_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_497_s8_q ? select_2334 : lower_half_q;
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
  logic lower_half_s9_q;
  logic [3:0] select_458_s9_q;
  logic equal_459_s9_q;
  logic [6:0] select_461_s9_q;
  logic [8:0] select_465_s9_q;
  logic and_471_s9_q;
  logic equal_477_s9_q;
  logic [6:0] column_s9_q;
  logic and_495_s9_q;
  logic and_497_s9_q;
  logic so_s9_q;
  logic equal_517_s9_q;
  logic or_518_s9_q;
  logic equal_520_s9_q;
  logic less_525_s9_q;
  logic not_526_s9_q;
  logic and_529_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic equal_558_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_618_s9_q;
  logic and_619_s9_q;
  logic and_620_s9_q;
  logic and_621_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_625_s9_q;
  logic and_626_s9_q;
  logic and_627_s9_q;
  logic and_628_s9_q;
  logic and_629_s9_q;
  logic and_630_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_639_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic select_646_s9_q;
  logic and_652_s9_q;
  logic [11:0] select_659_s9_q;
  logic and_675_s9_q;
  logic [11:0] select_682_s9_q;
  logic and_692_s9_q;
  logic [11:0] select_699_s9_q;
  logic [11:0] select_907_s9_q;
  logic [11:0] select_930_s9_q;
  logic [11:0] select_947_s9_q;
  logic [11:0] select_1160_s9_q;
  logic [11:0] select_1181_s9_q;
  logic [11:0] select_1196_s9_q;
  logic and_1448_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic select_1457_s9_q;
  logic equal_1466_s9_q;
  logic and_1473_s9_q;
  logic and_1476_s9_q;
  logic and_1480_s9_q;
  logic and_1579_s9_q;
  logic equal_1585_s9_q;
  logic less_1606_s9_q;
  logic and_1967_s9_q;
  logic equal_2113_s9_q;
  logic equal_2237_s9_q;
  logic and_2548_s9_q;
  logic and_2550_s9_q;
  logic [3:0] phase_s9_q;
  logic equal_2677_s9_q;
  logic [3:0] select_2680_s9_q;
  logic less_2691_s9_q;
  logic not_2723_s9_q;
  logic less_3532_s9_q;
  logic equal_3737_s9_q;
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
      lower_half_s9_q <= lower_half_q;
      select_458_s9_q <= select_458_s8_q;
      equal_459_s9_q <= equal_459_s8_q;
      select_461_s9_q <= select_461_s8_q;
      select_465_s9_q <= select_465_s8_q;
      and_471_s9_q <= and_471_s8_q;
      equal_477_s9_q <= equal_477_s8_q;
      column_s9_q <= column_s8_q;
      and_495_s9_q <= and_495_s8_q;
      and_497_s9_q <= and_497_s8_q;
      so_s9_q <= so_s8_q;
      equal_517_s9_q <= equal_517_s8_q;
      or_518_s9_q <= or_518_s8_q;
      equal_520_s9_q <= equal_520_s8_q;
      less_525_s9_q <= less_525_s8_q;
      not_526_s9_q <= not_526_s8_q;
      and_529_s9_q <= and_529_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_558_s9_q <= row_s8_q == 7'h0;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_618_s9_q <= left_rdata_s8_q[12] & not_617;
      and_619_s9_q <= left_rdata_s8_q[28] & not_617;
      and_620_s9_q <= left_rdata_s8_q[44] & not_617;
      and_621_s9_q <= left_rdata_s8_q[60] & not_617;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_625_s9_q <= right_codes_rdata_s8_q[12] & not_617;
      and_626_s9_q <= right_codes_rdata_s8_q[25] & not_617;
      and_627_s9_q <= right_codes_rdata_s8_q[38] & not_617;
      and_628_s9_q <= right_codes_rdata_s8_q[51] & not_617;
      and_629_s9_q <= right_codes_rdata_s8_q[64] & not_617;
      and_630_s9_q <= right_codes_rdata_s8_q[77] & not_617;
      x_s9_2_q <= x_s8_2_q;
      select_639_s9_q <= select_639_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_646_s9_q <= select_646_s8_q;
      and_652_s9_q <= and_652;
      select_659_s9_q <= select_659;
      and_675_s9_q <= and_675;
      select_682_s9_q <= select_682;
      and_692_s9_q <= and_692;
      select_699_s9_q <= select_699;
      select_907_s9_q <= select_907;
      select_930_s9_q <= select_930;
      select_947_s9_q <= select_942 ? (~(select_695 ^ select_944)) : 12'h0;
      select_1160_s9_q <= select_1154 ? (~(select_655 ^ select_1157)) : 12'h0;
      select_1181_s9_q <= select_1181;
      select_1196_s9_q <= select_1196;
      and_1448_s9_q <= and_1448_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      select_1457_s9_q <= select_1457_s8_q;
      equal_1466_s9_q <= equal_1466_s8_q;
      and_1473_s9_q <= not_526_s8_q & and_1472;
      and_1476_s9_q <= (or_518_s8_q & (left_rdata_s8_q[62] & not_526_s8_q)) & and_1472;
      and_1480_s9_q <= and_1480;
      and_1579_s9_q <= and_1579_s8_q;
      equal_1585_s9_q <= equal_1585_s8_q;
      less_1606_s9_q <= 6'h4 < row_q[6:1];
      and_1967_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2113_s9_q <= (column_s8_q | row_s8_q) == 7'h0;
      equal_2237_s9_q <= equal_2237_s8_q;
      and_2548_s9_q <= and_2238_s8_q & and_2547;
      and_2550_s9_q <= and_2238_s8_q & (~and_2547);
      phase_s9_q <= phase_s8_q;
      equal_2677_s9_q <= row_s8_q == 7'h3;
      select_2680_s9_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      less_2691_s9_q <= 7'h2 < row_s8_q;
      not_2723_s9_q <= not_2723_s8_q;
      less_3532_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_3737_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_choosing_rows_to_next_q;
  logic patches_chooses_q;
  // hls/stages/count_bits.hpp:24
  logic parity_665;
  assign parity_665 = ^select_659_s9_q[5:3];
  logic parity_668;
  assign parity_668 = ^select_659_s9_q[8:6];
  logic parity_671;
  assign parity_671 = ^select_659_s9_q[11:3];
  logic parity_685;
  assign parity_685 = ^select_682_s9_q[8:6];
  logic parity_688;
  assign parity_688 = ^select_682_s9_q[11:9];
  logic parity_705;
  assign parity_705 = ^select_699_s9_q[2:0];
  logic parity_708;
  assign parity_708 = ^select_699_s9_q[5:3];
  logic parity_711;
  assign parity_711 = ^select_699_s9_q[8:0];
  logic parity_717;
  assign parity_717 = ^select_699_s9_q[11:9];
  logic parity_720;
  assign parity_720 = ^select_682_s9_q[2:0];
  logic parity_723;
  assign parity_723 = ^{select_699_s9_q[11:9], select_682_s9_q[5:0]};
  logic parity_726;
  assign parity_726 = ^{select_699_s9_q, select_682_s9_q, select_659_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_731;
  assign or_731 = (select_659_s9_q[1:0] == 2'h3) | (select_659_s9_q[2] & (select_659_s9_q[0] | select_659_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_735;
  assign or_735 = (select_682_s9_q[7:6] == 2'h3) | (select_682_s9_q[8] & (select_682_s9_q[6] | select_682_s9_q[7]));
  logic or_739;
  assign or_739 = (select_682_s9_q[10:9] == 2'h3) | (select_682_s9_q[11] & (select_682_s9_q[9] | select_682_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_747;
  assign or_747 = (select_699_s9_q[7:6] == 2'h3) | (select_699_s9_q[8] & (~(select_699_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_751;
  assign or_751 = (select_699_s9_q[1:0] == 2'h3) | (select_699_s9_q[2] & (select_699_s9_q[0] | select_699_s9_q[1]));
  logic or_755;
  assign or_755 = (select_699_s9_q[4:3] == 2'h3) | (select_699_s9_q[5] & (select_699_s9_q[3] | select_699_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_758;
  assign parity_758 = ^{or_755, or_751, or_747};
  // hls/stages/count_bits.hpp:23
  logic or_762;
  assign or_762 = (select_682_s9_q[4:3] == 2'h3) | (select_682_s9_q[5] & (select_682_s9_q[3] | select_682_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_766;
  assign or_766 = (select_699_s9_q[10:9] == 2'h3) | (select_699_s9_q[11] & (select_699_s9_q[9] | select_699_s9_q[10]));
  logic or_770;
  assign or_770 = (select_682_s9_q[1:0] == 2'h3) | (select_682_s9_q[2] & (select_682_s9_q[0] | select_682_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_773;
  assign parity_773 = ^{or_770, or_766, or_762};
  logic parity_776;
  assign parity_776 = ^{or_770, or_766, or_762, or_755, or_751, or_747, or_739, or_735, or_731};
  // hls/stages/count_bits.hpp:25
  logic or_781;
  assign or_781 = (parity_665 & parity_668) | ((^select_659_s9_q[11:9]) & (parity_665 | parity_668));
  logic and_784;
  assign and_784 = (^{select_682_s9_q[11:6], select_659_s9_q[2:0]}) & (parity_711 | parity_723);
  // hls/stages/count_bits.hpp:23
  logic or_792;
  assign or_792 = (select_659_s9_q[10:9] == 2'h3) | (select_659_s9_q[11] & (select_659_s9_q[9] | select_659_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_796;
  assign or_796 = (select_659_s9_q[4:3] == 2'h3) | (select_659_s9_q[5] & (select_659_s9_q[3] | select_659_s9_q[4]));
  logic or_800;
  assign or_800 = (select_659_s9_q[7:6] == 2'h3) | (select_659_s9_q[8] & (select_659_s9_q[6] | select_659_s9_q[7]));
  logic or_807;
  assign or_807 = (parity_685 & parity_688) | ((^select_659_s9_q[2:0]) & (parity_685 | parity_688));
  logic or_811;
  assign or_811 = (parity_705 & parity_708) | ((^select_699_s9_q[8:6]) & (parity_705 | parity_708));
  logic or_815;
  assign or_815 = (parity_717 & parity_720) | ((^select_682_s9_q[5:3]) & (parity_717 | parity_720));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_908;
  assign select_908 = and_652_s9_q ? select_907_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_914;
  assign parity_914 = ^select_908[5:3];
  logic parity_917;
  assign parity_917 = ^select_908[8:6];
  logic parity_920;
  assign parity_920 = ^select_908[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_931;
  assign select_931 = and_675_s9_q ? select_930_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_934;
  assign parity_934 = ^select_931[8:6];
  logic parity_937;
  assign parity_937 = ^select_931[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_948;
  assign select_948 = and_692_s9_q ? select_947_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_954;
  assign parity_954 = ^select_948[2:0];
  logic parity_957;
  assign parity_957 = ^select_948[5:3];
  logic parity_960;
  assign parity_960 = ^select_948[8:0];
  logic parity_966;
  assign parity_966 = ^select_948[11:9];
  logic parity_969;
  assign parity_969 = ^select_931[2:0];
  logic parity_972;
  assign parity_972 = ^{select_948[11:9], select_931[5:0]};
  logic parity_975;
  assign parity_975 = ^{select_948, select_931, select_908[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_980;
  assign or_980 = (select_908[1:0] == 2'h3) | (select_908[2] & (select_908[0] | select_908[1]));
  // hls/stages/count_bits.hpp:25
  logic or_984;
  assign or_984 = (select_931[7:6] == 2'h3) | (select_931[8] & (select_931[6] | select_931[7]));
  logic or_988;
  assign or_988 = (select_931[10:9] == 2'h3) | (select_931[11] & (select_931[9] | select_931[10]));
  // hls/stages/count_bits.hpp:23
  logic or_996;
  assign or_996 = (select_948[7:6] == 2'h3) | (select_948[8] & (~(select_948[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1000;
  assign or_1000 = (select_948[1:0] == 2'h3) | (select_948[2] & (select_948[0] | select_948[1]));
  logic or_1004;
  assign or_1004 = (select_948[4:3] == 2'h3) | (select_948[5] & (select_948[3] | select_948[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1007;
  assign parity_1007 = ^{or_1004, or_1000, or_996};
  // hls/stages/count_bits.hpp:23
  logic or_1011;
  assign or_1011 = (select_931[4:3] == 2'h3) | (select_931[5] & (select_931[3] | select_931[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1015;
  assign or_1015 = (select_948[10:9] == 2'h3) | (select_948[11] & (select_948[9] | select_948[10]));
  logic or_1019;
  assign or_1019 = (select_931[1:0] == 2'h3) | (select_931[2] & (select_931[0] | select_931[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1022;
  assign parity_1022 = ^{or_1019, or_1015, or_1011};
  logic parity_1025;
  assign parity_1025 = ^{or_1019, or_1015, or_1011, or_1004, or_1000, or_996, or_988, or_984, or_980};
  // hls/stages/count_bits.hpp:25
  logic or_1030;
  assign or_1030 = (parity_914 & parity_917) | ((^select_908[11:9]) & (parity_914 | parity_917));
  logic and_1033;
  assign and_1033 = (^{select_931[11:6], select_908[2:0]}) & (parity_960 | parity_972);
  // hls/stages/count_bits.hpp:23
  logic or_1041;
  assign or_1041 = (select_908[10:9] == 2'h3) | (select_908[11] & (select_908[9] | select_908[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1045;
  assign or_1045 = (select_908[4:3] == 2'h3) | (select_908[5] & (select_908[3] | select_908[4]));
  logic or_1049;
  assign or_1049 = (select_908[7:6] == 2'h3) | (select_908[8] & (select_908[6] | select_908[7]));
  logic or_1056;
  assign or_1056 = (parity_934 & parity_937) | ((^select_908[2:0]) & (parity_934 | parity_937));
  logic or_1060;
  assign or_1060 = (parity_954 & parity_957) | ((^select_948[8:6]) & (parity_954 | parity_957));
  logic or_1064;
  assign or_1064 = (parity_966 & parity_969) | ((^select_931[5:3]) & (parity_966 | parity_969));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1161;
  assign select_1161 = and_652_s9_q ? select_1160_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1167;
  assign parity_1167 = ^select_1161[5:3];
  logic parity_1170;
  assign parity_1170 = ^select_1161[8:6];
  logic parity_1173;
  assign parity_1173 = ^select_1161[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1182;
  assign select_1182 = and_675_s9_q ? select_1181_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1185;
  assign parity_1185 = ^select_1182[8:6];
  logic parity_1188;
  assign parity_1188 = ^select_1182[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1197;
  assign select_1197 = and_692_s9_q ? select_1196_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1203;
  assign parity_1203 = ^select_1197[2:0];
  logic parity_1206;
  assign parity_1206 = ^select_1197[5:3];
  logic parity_1209;
  assign parity_1209 = ^select_1197[8:0];
  logic parity_1215;
  assign parity_1215 = ^select_1197[11:9];
  logic parity_1218;
  assign parity_1218 = ^select_1182[2:0];
  logic parity_1221;
  assign parity_1221 = ^{select_1197[11:9], select_1182[5:0]};
  logic parity_1224;
  assign parity_1224 = ^{select_1197, select_1182, select_1161[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1229;
  assign or_1229 = (select_1161[1:0] == 2'h3) | (select_1161[2] & (select_1161[0] | select_1161[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1233;
  assign or_1233 = (select_1182[7:6] == 2'h3) | (select_1182[8] & (select_1182[6] | select_1182[7]));
  logic or_1237;
  assign or_1237 = (select_1182[10:9] == 2'h3) | (select_1182[11] & (select_1182[9] | select_1182[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1245;
  assign or_1245 = (select_1197[7:6] == 2'h3) | (select_1197[8] & (~(select_1197[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1249;
  assign or_1249 = (select_1197[1:0] == 2'h3) | (select_1197[2] & (select_1197[0] | select_1197[1]));
  logic or_1253;
  assign or_1253 = (select_1197[4:3] == 2'h3) | (select_1197[5] & (select_1197[3] | select_1197[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1256;
  assign parity_1256 = ^{or_1253, or_1249, or_1245};
  // hls/stages/count_bits.hpp:23
  logic or_1260;
  assign or_1260 = (select_1182[4:3] == 2'h3) | (select_1182[5] & (select_1182[3] | select_1182[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1264;
  assign or_1264 = (select_1197[10:9] == 2'h3) | (select_1197[11] & (select_1197[9] | select_1197[10]));
  logic or_1268;
  assign or_1268 = (select_1182[1:0] == 2'h3) | (select_1182[2] & (select_1182[0] | select_1182[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1271;
  assign parity_1271 = ^{or_1268, or_1264, or_1260};
  logic parity_1274;
  assign parity_1274 = ^{or_1268, or_1264, or_1260, or_1253, or_1249, or_1245, or_1237, or_1233, or_1229};
  // hls/stages/count_bits.hpp:25
  logic or_1279;
  assign or_1279 = (parity_1167 & parity_1170) | ((^select_1161[11:9]) & (parity_1167 | parity_1170));
  logic and_1282;
  assign and_1282 = (^{select_1182[11:6], select_1161[2:0]}) & (parity_1209 | parity_1221);
  // hls/stages/count_bits.hpp:23
  logic or_1290;
  assign or_1290 = (select_1161[10:9] == 2'h3) | (select_1161[11] & (select_1161[9] | select_1161[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1294;
  assign or_1294 = (select_1161[4:3] == 2'h3) | (select_1161[5] & (select_1161[3] | select_1161[4]));
  logic or_1298;
  assign or_1298 = (select_1161[7:6] == 2'h3) | (select_1161[8] & (select_1161[6] | select_1161[7]));
  logic or_1305;
  assign or_1305 = (parity_1185 & parity_1188) | ((^select_1161[2:0]) & (parity_1185 | parity_1188));
  logic or_1309;
  assign or_1309 = (parity_1203 & parity_1206) | ((^select_1197[8:6]) & (parity_1203 | parity_1206));
  logic or_1313;
  assign or_1313 = (parity_1215 & parity_1218) | ((^select_1182[5:3]) & (parity_1215 | parity_1218));
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:235
  logic or_1494;
  assign or_1494 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));
  // hls/stages/patches.hpp:64
  logic [3:0] select_2681;
  assign select_2681 = equal_2677_s9_q ? select_2680_s9_q : patches_choosing_rows_to_next_q;
  logic equal_2682;
  assign equal_2682 = select_2681 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2685;
  assign select_2685 = equal_2237_s9_q ? (equal_2682 ? 4'h2 : (select_2681 + 4'hf)) : patches_choosing_rows_to_next_q;
  logic select_2693;
  assign select_2693 = equal_2237_s9_q ? (less_2691_s9_q & equal_2682) : patches_chooses_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_529_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_621_s9_q, left_rdata_s9_q[56:42], and_620_s9_q, left_rdata_s9_q[41:27], and_619_s9_q, left_rdata_s9_q[26:12], and_618_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_529_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_630_s9_q, right_codes_rdata_s9_q[71:60], and_629_s9_q, right_codes_rdata_s9_q[59:48], and_628_s9_q, right_codes_rdata_s9_q[47:36], and_627_s9_q, right_codes_rdata_s9_q[35:24], and_626_s9_q, right_codes_rdata_s9_q[23:12], and_625_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_chooses_q <= 1'b0;
    end else if (s9_en) begin
      patches_choosing_rows_to_next_q <= and_497_s9_q ? select_2685 : patches_choosing_rows_to_next_q;
      patches_chooses_q <= and_497_s9_q ? select_2693 : patches_chooses_q;
    end
  end

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
  logic lower_half_s10_q;
  logic [3:0] patches_choosing_rows_to_next_s10_q;
  logic patches_chooses_s10_q;
  logic [3:0] select_458_s10_q;
  logic equal_459_s10_q;
  logic [6:0] select_461_s10_q;
  logic [8:0] select_465_s10_q;
  logic and_471_s10_q;
  logic equal_477_s10_q;
  logic [6:0] column_s10_q;
  logic and_495_s10_q;
  logic and_497_s10_q;
  logic so_s10_q;
  logic equal_517_s10_q;
  logic or_518_s10_q;
  logic equal_520_s10_q;
  logic less_525_s10_q;
  logic not_526_s10_q;
  logic equal_558_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_639_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic select_646_s10_q;
  logic xor_727_s10_q;
  logic parity_776_s10_q;
  logic and_777_s10_q;
  logic or_781_s10_q;
  logic or_785_s10_q;
  logic or_792_s10_q;
  logic or_796_s10_q;
  logic or_800_s10_q;
  logic or_807_s10_q;
  logic or_811_s10_q;
  logic or_815_s10_q;
  logic and_824_s10_q;
  logic and_826_s10_q;
  logic or_838_s10_q;
  logic or_842_s10_q;
  logic or_846_s10_q;
  logic xor_976_s10_q;
  logic parity_991_s10_q;
  logic parity_1025_s10_q;
  logic and_1026_s10_q;
  logic or_1030_s10_q;
  logic or_1034_s10_q;
  logic or_1041_s10_q;
  logic or_1045_s10_q;
  logic or_1049_s10_q;
  logic or_1056_s10_q;
  logic or_1060_s10_q;
  logic or_1064_s10_q;
  logic and_1073_s10_q;
  logic or_1074_s10_q;
  logic or_1087_s10_q;
  logic or_1091_s10_q;
  logic or_1095_s10_q;
  logic xor_1225_s10_q;
  logic parity_1240_s10_q;
  logic parity_1274_s10_q;
  logic and_1275_s10_q;
  logic or_1279_s10_q;
  logic or_1283_s10_q;
  logic or_1290_s10_q;
  logic or_1294_s10_q;
  logic or_1298_s10_q;
  logic or_1305_s10_q;
  logic or_1309_s10_q;
  logic or_1313_s10_q;
  logic and_1322_s10_q;
  logic or_1323_s10_q;
  logic or_1336_s10_q;
  logic or_1340_s10_q;
  logic or_1344_s10_q;
  logic and_1448_s10_q;
  logic [6:0] select_1452_s10_q;
  logic [6:0] right_s10_q;
  logic select_1457_s10_q;
  logic equal_1466_s10_q;
  logic and_1473_s10_q;
  logic and_1476_s10_q;
  logic and_1480_s10_q;
  logic or_1494_s10_q;
  logic and_1579_s10_q;
  logic equal_1585_s10_q;
  logic less_1606_s10_q;
  logic and_1967_s10_q;
  logic equal_2113_s10_q;
  logic equal_2237_s10_q;
  logic and_2548_s10_q;
  logic and_2550_s10_q;
  logic [3:0] phase_s10_q;
  logic equal_2677_s10_q;
  logic equal_2682_s10_q;
  logic not_2723_s10_q;
  logic less_3532_s10_q;
  logic equal_3737_s10_q;
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
      lower_half_s10_q <= lower_half_s9_q;
      patches_choosing_rows_to_next_s10_q <= patches_choosing_rows_to_next_q;
      patches_chooses_s10_q <= patches_chooses_q;
      select_458_s10_q <= select_458_s9_q;
      equal_459_s10_q <= equal_459_s9_q;
      select_461_s10_q <= select_461_s9_q;
      select_465_s10_q <= select_465_s9_q;
      and_471_s10_q <= and_471_s9_q;
      equal_477_s10_q <= equal_477_s9_q;
      column_s10_q <= column_s9_q;
      and_495_s10_q <= and_495_s9_q;
      and_497_s10_q <= and_497_s9_q;
      so_s10_q <= so_s9_q;
      equal_517_s10_q <= equal_517_s9_q;
      or_518_s10_q <= or_518_s9_q;
      equal_520_s10_q <= equal_520_s9_q;
      less_525_s10_q <= less_525_s9_q;
      not_526_s10_q <= not_526_s9_q;
      equal_558_s10_q <= equal_558_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_639_s10_q <= select_639_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_646_s10_q <= select_646_s9_q;
      xor_727_s10_q <= parity_671 ^ parity_726;
      parity_776_s10_q <= parity_776;
      and_777_s10_q <= parity_671 & parity_726;
      or_781_s10_q <= or_781;
      or_785_s10_q <= (parity_711 & parity_723) | and_784;
      or_792_s10_q <= or_792;
      or_796_s10_q <= or_796;
      or_800_s10_q <= or_800;
      or_807_s10_q <= or_807;
      or_811_s10_q <= or_811;
      or_815_s10_q <= or_815;
      and_824_s10_q <= parity_758 & parity_773;
      and_826_s10_q <= (^{or_739, or_735, or_731}) & (parity_758 | parity_773);
      or_838_s10_q <= (or_735 & or_739) | (or_731 & (or_735 | or_739));
      or_842_s10_q <= (or_751 & or_755) | (or_747 & (or_751 | or_755));
      or_846_s10_q <= (or_766 & or_770) | (or_762 & (or_766 | or_770));
      xor_976_s10_q <= parity_920 ^ parity_975;
      parity_991_s10_q <= ^{or_988, or_984, or_980};
      parity_1025_s10_q <= parity_1025;
      and_1026_s10_q <= parity_920 & parity_975;
      or_1030_s10_q <= or_1030;
      or_1034_s10_q <= (parity_960 & parity_972) | and_1033;
      or_1041_s10_q <= or_1041;
      or_1045_s10_q <= or_1045;
      or_1049_s10_q <= or_1049;
      or_1056_s10_q <= or_1056;
      or_1060_s10_q <= or_1060;
      or_1064_s10_q <= or_1064;
      and_1073_s10_q <= parity_1007 & parity_1022;
      or_1074_s10_q <= parity_1007 | parity_1022;
      or_1087_s10_q <= (or_984 & or_988) | (or_980 & (or_984 | or_988));
      or_1091_s10_q <= (or_1000 & or_1004) | (or_996 & (or_1000 | or_1004));
      or_1095_s10_q <= (or_1015 & or_1019) | (or_1011 & (or_1015 | or_1019));
      xor_1225_s10_q <= parity_1173 ^ parity_1224;
      parity_1240_s10_q <= ^{or_1237, or_1233, or_1229};
      parity_1274_s10_q <= parity_1274;
      and_1275_s10_q <= parity_1173 & parity_1224;
      or_1279_s10_q <= or_1279;
      or_1283_s10_q <= (parity_1209 & parity_1221) | and_1282;
      or_1290_s10_q <= or_1290;
      or_1294_s10_q <= or_1294;
      or_1298_s10_q <= or_1298;
      or_1305_s10_q <= or_1305;
      or_1309_s10_q <= or_1309;
      or_1313_s10_q <= or_1313;
      and_1322_s10_q <= parity_1256 & parity_1271;
      or_1323_s10_q <= parity_1256 | parity_1271;
      or_1336_s10_q <= (or_1233 & or_1237) | (or_1229 & (or_1233 | or_1237));
      or_1340_s10_q <= (or_1249 & or_1253) | (or_1245 & (or_1249 | or_1253));
      or_1344_s10_q <= (or_1264 & or_1268) | (or_1260 & (or_1264 | or_1268));
      and_1448_s10_q <= and_1448_s9_q;
      select_1452_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      select_1457_s10_q <= select_1457_s9_q;
      equal_1466_s10_q <= equal_1466_s9_q;
      and_1473_s10_q <= and_1473_s9_q;
      and_1476_s10_q <= and_1476_s9_q;
      and_1480_s10_q <= and_1480_s9_q;
      or_1494_s10_q <= or_1494;
      and_1579_s10_q <= and_1579_s9_q;
      equal_1585_s10_q <= equal_1585_s9_q;
      less_1606_s10_q <= less_1606_s9_q;
      and_1967_s10_q <= and_1967_s9_q;
      equal_2113_s10_q <= equal_2113_s9_q;
      equal_2237_s10_q <= equal_2237_s9_q;
      and_2548_s10_q <= and_2548_s9_q;
      and_2550_s10_q <= and_2550_s9_q;
      phase_s10_q <= phase_s9_q;
      equal_2677_s10_q <= equal_2677_s9_q;
      equal_2682_s10_q <= equal_2682;
      not_2723_s10_q <= not_2723_s9_q;
      less_3532_s10_q <= less_3532_s9_q;
      equal_3737_s10_q <= equal_3737_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_band_rows_rows_to_next_q;
  logic [4:0] patches_band_rows_number_q;
  logic [3:0] patches_next_band_rows_to_next_q;
  logic [4:0] patches_next_band_number_q;
  logic [3:0] patches_first_band_rows_to_next_q;
  logic patches_first_band_number_q;
  logic [4:0] patches_choosing_number_q;
  logic [4:0] patches_choosing_band_q;
  // hls/stages/count_bits.hpp:24
  logic parity_803;
  assign parity_803 = ^{or_800_s10_q, or_796_s10_q, or_792_s10_q};
  logic parity_818;
  assign parity_818 = ^{or_815_s10_q, or_811_s10_q, or_807_s10_q};
  logic parity_821;
  assign parity_821 = ^{or_815_s10_q, or_811_s10_q, or_807_s10_q, or_800_s10_q, or_796_s10_q, or_792_s10_q, or_785_s10_q, or_781_s10_q, and_777_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_823;
  assign and_823 = parity_776_s10_q & parity_821;
  logic or_827;
  assign or_827 = and_824_s10_q | and_826_s10_q;
  logic and_830;
  assign and_830 = (^{or_785_s10_q, or_781_s10_q, and_777_s10_q}) & (parity_803 | parity_818);
  logic or_831;
  assign or_831 = (parity_803 & parity_818) | and_830;
  // hls/stages/count_bits.hpp:24
  logic parity_849;
  assign parity_849 = ^{or_846_s10_q, or_842_s10_q, or_838_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_853;
  assign or_853 = (or_781_s10_q & or_785_s10_q) | (and_777_s10_q & (or_781_s10_q | or_785_s10_q));
  logic or_857;
  assign or_857 = (or_796_s10_q & or_800_s10_q) | (or_792_s10_q & (or_796_s10_q | or_800_s10_q));
  logic or_861;
  assign or_861 = (or_811_s10_q & or_815_s10_q) | (or_807_s10_q & (or_811_s10_q | or_815_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_864;
  assign parity_864 = ^{or_861, or_857, or_853};
  logic parity_867;
  assign parity_867 = ^{or_861, or_857, or_853, or_846_s10_q, or_842_s10_q, or_838_s10_q, or_831, or_827, and_823};
  // hls/stages/count_bits.hpp:25
  logic or_879;
  assign or_879 = (or_842_s10_q & or_846_s10_q) | (or_838_s10_q & (or_842_s10_q | or_846_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1052;
  assign parity_1052 = ^{or_1049_s10_q, or_1045_s10_q, or_1041_s10_q};
  logic parity_1067;
  assign parity_1067 = ^{or_1064_s10_q, or_1060_s10_q, or_1056_s10_q};
  logic parity_1070;
  assign parity_1070 = ^{or_1064_s10_q, or_1060_s10_q, or_1056_s10_q, or_1049_s10_q, or_1045_s10_q, or_1041_s10_q, or_1034_s10_q, or_1030_s10_q, and_1026_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1072;
  assign and_1072 = parity_1025_s10_q & parity_1070;
  logic or_1076;
  assign or_1076 = and_1073_s10_q | (parity_991_s10_q & or_1074_s10_q);
  logic and_1079;
  assign and_1079 = (^{or_1034_s10_q, or_1030_s10_q, and_1026_s10_q}) & (parity_1052 | parity_1067);
  logic or_1080;
  assign or_1080 = (parity_1052 & parity_1067) | and_1079;
  // hls/stages/count_bits.hpp:24
  logic parity_1098;
  assign parity_1098 = ^{or_1095_s10_q, or_1091_s10_q, or_1087_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1102;
  assign or_1102 = (or_1030_s10_q & or_1034_s10_q) | (and_1026_s10_q & (or_1030_s10_q | or_1034_s10_q));
  logic or_1106;
  assign or_1106 = (or_1045_s10_q & or_1049_s10_q) | (or_1041_s10_q & (or_1045_s10_q | or_1049_s10_q));
  logic or_1110;
  assign or_1110 = (or_1060_s10_q & or_1064_s10_q) | (or_1056_s10_q & (or_1060_s10_q | or_1064_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1113;
  assign parity_1113 = ^{or_1110, or_1106, or_1102};
  logic parity_1116;
  assign parity_1116 = ^{or_1110, or_1106, or_1102, or_1095_s10_q, or_1091_s10_q, or_1087_s10_q, or_1080, or_1076, and_1072};
  // hls/stages/count_bits.hpp:25
  logic or_1128;
  assign or_1128 = (or_1091_s10_q & or_1095_s10_q) | (or_1087_s10_q & (or_1091_s10_q | or_1095_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1301;
  assign parity_1301 = ^{or_1298_s10_q, or_1294_s10_q, or_1290_s10_q};
  logic parity_1316;
  assign parity_1316 = ^{or_1313_s10_q, or_1309_s10_q, or_1305_s10_q};
  logic parity_1319;
  assign parity_1319 = ^{or_1313_s10_q, or_1309_s10_q, or_1305_s10_q, or_1298_s10_q, or_1294_s10_q, or_1290_s10_q, or_1283_s10_q, or_1279_s10_q, and_1275_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1321;
  assign and_1321 = parity_1274_s10_q & parity_1319;
  logic or_1325;
  assign or_1325 = and_1322_s10_q | (parity_1240_s10_q & or_1323_s10_q);
  logic and_1328;
  assign and_1328 = (^{or_1283_s10_q, or_1279_s10_q, and_1275_s10_q}) & (parity_1301 | parity_1316);
  logic or_1329;
  assign or_1329 = (parity_1301 & parity_1316) | and_1328;
  // hls/stages/count_bits.hpp:24
  logic parity_1347;
  assign parity_1347 = ^{or_1344_s10_q, or_1340_s10_q, or_1336_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1351;
  assign or_1351 = (or_1279_s10_q & or_1283_s10_q) | (and_1275_s10_q & (or_1279_s10_q | or_1283_s10_q));
  logic or_1355;
  assign or_1355 = (or_1294_s10_q & or_1298_s10_q) | (or_1290_s10_q & (or_1294_s10_q | or_1298_s10_q));
  logic or_1359;
  assign or_1359 = (or_1309_s10_q & or_1313_s10_q) | (or_1305_s10_q & (or_1309_s10_q | or_1313_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1362;
  assign parity_1362 = ^{or_1359, or_1355, or_1351};
  logic parity_1365;
  assign parity_1365 = ^{or_1359, or_1355, or_1351, or_1344_s10_q, or_1340_s10_q, or_1336_s10_q, or_1329, or_1325, and_1321};
  // hls/stages/count_bits.hpp:25
  logic or_1377;
  assign or_1377 = (or_1340_s10_q & or_1344_s10_q) | (or_1336_s10_q & (or_1340_s10_q | or_1344_s10_q));
  // hls/stages/agreement.hpp:141
  logic [6:0] select_1504;
  assign select_1504 = or_518_s10_q ? (less_525_s10_q ? 7'h0 : select_1452_s10_q) : 7'h0;
  // hls/stages/census.hpp:31
  logic not_1583;
  assign not_1583 = ~sample_pair_first_s10_q;
  // hls/stages/patches.hpp:276
  logic equal_1587;
  assign equal_1587 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:327
  logic and_2659;
  assign and_2659 = not_1583 & equal_1585_s10_q;
  logic [8:0] select_2660;
  assign select_2660 = and_2659 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s10_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2661;
  assign select_2661 = and_2659 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2662;
  assign select_2662 = sample_pair_first_s10_q ? select_2660 : select_2661;
  // hls/stages/patches.hpp:98
  logic [3:0] select_2663;
  assign select_2663 = and_1579_s10_q ? select_2662[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2664;
  assign select_2664 = sample_pair_whole_s10_q ? select_2663 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2666;
  assign select_2666 = sample_pair_whole_s10_q ? (and_1579_s10_q ? select_2662[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2669;
  assign select_2669 = sample_pair_whole_s10_q ? (equal_1587 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2671;
  assign select_2671 = sample_pair_whole_s10_q ? (patches_band_rows_number_q + {4'h0, equal_1587}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:294
  logic equal_2672;
  assign equal_2672 = phase_s10_q == 4'h0;
  // hls/stages/patches.hpp:295
  logic not_2673;
  assign not_2673 = ~equal_2672;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2675;
  assign select_2675 = sample_pair_whole_s10_q ? (phase_s10_q + {{2{not_2673}}, 1'b1, not_2673}) : patches_first_band_rows_to_next_q;
  logic select_2676;
  assign select_2676 = sample_pair_whole_s10_q ? equal_2672 : patches_first_band_number_q;
  // hls/stages/patches.hpp:64
  logic [4:0] select_2687;
  assign select_2687 = equal_2677_s10_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2689;
  assign select_2689 = equal_2237_s10_q ? (select_2687 + {4'h0, equal_2682_s10_q}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2696;
  assign select_2696 = and_497_s10_q ? (equal_2237_s10_q ? select_2687 : patches_choosing_band_q) : patches_choosing_band_q;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1296; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_518_s10_q ? select_1452_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_639_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
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
      patches_choosing_band_q <= 5'h0;
    end else if (s10_en) begin
      patches_band_rows_rows_to_next_q <= select_2664;
      patches_band_rows_number_q <= select_2666;
      patches_next_band_rows_to_next_q <= select_2669;
      patches_next_band_number_q <= select_2671;
      patches_first_band_rows_to_next_q <= select_2675;
      patches_first_band_number_q <= select_2676;
      patches_choosing_number_q <= and_497_s10_q ? select_2689 : patches_choosing_number_q;
      patches_choosing_band_q <= select_2696;
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
  logic [6:0] last_s11_q;
  logic [3:0] age_s11_q;
  logic [2:0] slot_s11_q;
  logic ends_cell_s11_q;
  logic lower_half_s11_q;
  logic [4:0] patches_band_rows_number_s11_q;
  logic patches_chooses_s11_q;
  logic [4:0] patches_choosing_band_s11_q;
  logic [3:0] select_458_s11_q;
  logic equal_459_s11_q;
  logic [6:0] select_461_s11_q;
  logic [8:0] select_465_s11_q;
  logic and_471_s11_q;
  logic equal_477_s11_q;
  logic [6:0] column_s11_q;
  logic and_495_s11_q;
  logic and_497_s11_q;
  logic so_s11_q;
  logic equal_517_s11_q;
  logic or_518_s11_q;
  logic equal_520_s11_q;
  logic less_525_s11_q;
  logic not_526_s11_q;
  logic equal_558_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic select_646_s11_q;
  logic xor_727_s11_q;
  logic xor_822_s11_q;
  logic parity_867_s11_q;
  logic and_868_s11_q;
  logic and_870_s11_q;
  logic and_872_s11_q;
  logic and_874_s11_q;
  logic or_879_s11_q;
  logic or_883_s11_q;
  logic xor_976_s11_q;
  logic xor_1071_s11_q;
  logic parity_1116_s11_q;
  logic and_1117_s11_q;
  logic and_1119_s11_q;
  logic and_1121_s11_q;
  logic and_1123_s11_q;
  logic or_1128_s11_q;
  logic or_1132_s11_q;
  logic xor_1225_s11_q;
  logic xor_1320_s11_q;
  logic parity_1365_s11_q;
  logic and_1366_s11_q;
  logic and_1368_s11_q;
  logic and_1370_s11_q;
  logic and_1372_s11_q;
  logic or_1377_s11_q;
  logic or_1381_s11_q;
  logic and_1448_s11_q;
  logic [6:0] right_s11_q;
  logic select_1457_s11_q;
  logic equal_1466_s11_q;
  logic and_1473_s11_q;
  logic and_1476_s11_q;
  logic and_1480_s11_q;
  logic or_1494_s11_q;
  logic [6:0] select_1505_s11_q;
  logic and_1579_s11_q;
  logic not_1583_s11_q;
  logic or_1589_s11_q;
  logic less_1606_s11_q;
  logic and_1967_s11_q;
  logic equal_2113_s11_q;
  logic equal_2237_s11_q;
  logic and_2548_s11_q;
  logic and_2550_s11_q;
  logic not_2723_s11_q;
  logic less_3532_s11_q;
  logic equal_3737_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
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
      last_s11_q <= last_s10_q;
      age_s11_q <= age_s10_q;
      slot_s11_q <= slot_s10_q;
      ends_cell_s11_q <= ends_cell_s10_q;
      lower_half_s11_q <= lower_half_s10_q;
      patches_band_rows_number_s11_q <= patches_band_rows_number_q;
      patches_chooses_s11_q <= patches_chooses_s10_q;
      patches_choosing_band_s11_q <= patches_choosing_band_q;
      select_458_s11_q <= select_458_s10_q;
      equal_459_s11_q <= equal_459_s10_q;
      select_461_s11_q <= select_461_s10_q;
      select_465_s11_q <= select_465_s10_q;
      and_471_s11_q <= and_471_s10_q;
      equal_477_s11_q <= equal_477_s10_q;
      column_s11_q <= column_s10_q;
      and_495_s11_q <= and_495_s10_q;
      and_497_s11_q <= and_497_s10_q;
      so_s11_q <= so_s10_q;
      equal_517_s11_q <= equal_517_s10_q;
      or_518_s11_q <= or_518_s10_q;
      equal_520_s11_q <= equal_520_s10_q;
      less_525_s11_q <= less_525_s10_q;
      not_526_s11_q <= not_526_s10_q;
      equal_558_s11_q <= equal_558_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_646_s11_q <= select_646_s10_q;
      xor_727_s11_q <= xor_727_s10_q;
      xor_822_s11_q <= parity_776_s10_q ^ parity_821;
      parity_867_s11_q <= parity_867;
      and_868_s11_q <= parity_849 & parity_864;
      and_870_s11_q <= (^{or_831, or_827, and_823}) & (parity_849 | parity_864);
      and_872_s11_q <= or_827 & or_831;
      and_874_s11_q <= and_823 & (or_827 | or_831);
      or_879_s11_q <= or_879;
      or_883_s11_q <= (or_857 & or_861) | (or_853 & (or_857 | or_861));
      xor_976_s11_q <= xor_976_s10_q;
      xor_1071_s11_q <= parity_1025_s10_q ^ parity_1070;
      parity_1116_s11_q <= parity_1116;
      and_1117_s11_q <= parity_1098 & parity_1113;
      and_1119_s11_q <= (^{or_1080, or_1076, and_1072}) & (parity_1098 | parity_1113);
      and_1121_s11_q <= or_1076 & or_1080;
      and_1123_s11_q <= and_1072 & (or_1076 | or_1080);
      or_1128_s11_q <= or_1128;
      or_1132_s11_q <= (or_1106 & or_1110) | (or_1102 & (or_1106 | or_1110));
      xor_1225_s11_q <= xor_1225_s10_q;
      xor_1320_s11_q <= parity_1274_s10_q ^ parity_1319;
      parity_1365_s11_q <= parity_1365;
      and_1366_s11_q <= parity_1347 & parity_1362;
      and_1368_s11_q <= (^{or_1329, or_1325, and_1321}) & (parity_1347 | parity_1362);
      and_1370_s11_q <= or_1325 & or_1329;
      and_1372_s11_q <= and_1321 & (or_1325 | or_1329);
      or_1377_s11_q <= or_1377;
      or_1381_s11_q <= (or_1355 & or_1359) | (or_1351 & (or_1355 | or_1359));
      and_1448_s11_q <= and_1448_s10_q;
      right_s11_q <= right_s10_q;
      select_1457_s11_q <= select_1457_s10_q;
      equal_1466_s11_q <= equal_1466_s10_q;
      and_1473_s11_q <= and_1473_s10_q;
      and_1476_s11_q <= and_1476_s10_q;
      and_1480_s11_q <= and_1480_s10_q;
      or_1494_s11_q <= or_1494_s10_q;
      select_1505_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1504;
      and_1579_s11_q <= and_1579_s10_q;
      not_1583_s11_q <= not_1583;
      or_1589_s11_q <= (~equal_1585_s10_q) | (~equal_1587);
      less_1606_s11_q <= less_1606_s10_q;
      and_1967_s11_q <= and_1967_s10_q;
      equal_2113_s11_q <= equal_2113_s10_q;
      equal_2237_s11_q <= equal_2237_s10_q;
      and_2548_s11_q <= and_2548_s10_q;
      and_2550_s11_q <= and_2550_s10_q;
      not_2723_s11_q <= not_2723_s10_q;
      less_3532_s11_q <= less_3532_s10_q;
      equal_3737_s11_q <= equal_3737_s10_q;
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
  // hls/stages/count_bits.hpp:25
  logic or_871;
  assign or_871 = and_868_s11_q | and_870_s11_q;
  logic or_875;
  assign or_875 = and_872_s11_q | and_874_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_888;
  assign parity_888 = ^{or_883_s11_q, or_879_s11_q, or_875, or_871};
  // hls/stages/count_bits.hpp:25
  logic or_892;
  assign or_892 = (or_879_s11_q & or_883_s11_q) | (or_875 & (or_879_s11_q | or_883_s11_q));
  logic and_893;
  assign and_893 = or_871 & (^{or_883_s11_q, or_879_s11_q, or_875});
  // hls/stages/count_bits.hpp:24
  logic xor_894;
  assign xor_894 = or_892 ^ and_893;
  // hls/stages/count_bits.hpp:27
  logic and_895;
  assign and_895 = or_892 & and_893;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_896;
  assign select_896 = equal_520_s11_q ? {and_895, xor_894, parity_888, parity_867_s11_q, xor_822_s11_q, xor_727_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_518_s11_q ? 6'h0 : select_896;
  // hls/stages/count_bits.hpp:25
  logic or_1120;
  assign or_1120 = and_1117_s11_q | and_1119_s11_q;
  logic or_1124;
  assign or_1124 = and_1121_s11_q | and_1123_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1137;
  assign parity_1137 = ^{or_1132_s11_q, or_1128_s11_q, or_1124, or_1120};
  // hls/stages/count_bits.hpp:25
  logic or_1141;
  assign or_1141 = (or_1128_s11_q & or_1132_s11_q) | (or_1124 & (or_1128_s11_q | or_1132_s11_q));
  logic and_1142;
  assign and_1142 = or_1120 & (^{or_1132_s11_q, or_1128_s11_q, or_1124});
  // hls/stages/count_bits.hpp:24
  logic xor_1143;
  assign xor_1143 = or_1141 ^ and_1142;
  // hls/stages/count_bits.hpp:27
  logic and_1144;
  assign and_1144 = or_1141 & and_1142;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1145;
  assign select_1145 = equal_520_s11_q ? {and_1144, xor_1143, parity_1137, parity_1116_s11_q, xor_1071_s11_q, xor_976_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_518_s11_q ? 6'h0 : select_1145;
  // hls/stages/count_bits.hpp:25
  logic or_1369;
  assign or_1369 = and_1366_s11_q | and_1368_s11_q;
  logic or_1373;
  assign or_1373 = and_1370_s11_q | and_1372_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1386;
  assign parity_1386 = ^{or_1381_s11_q, or_1377_s11_q, or_1373, or_1369};
  // hls/stages/count_bits.hpp:25
  logic or_1390;
  assign or_1390 = (or_1377_s11_q & or_1381_s11_q) | (or_1373 & (or_1377_s11_q | or_1381_s11_q));
  logic and_1391;
  assign and_1391 = or_1369 & (^{or_1381_s11_q, or_1377_s11_q, or_1373});
  // hls/stages/count_bits.hpp:24
  logic xor_1392;
  assign xor_1392 = or_1390 ^ and_1391;
  // hls/stages/count_bits.hpp:27
  logic and_1393;
  assign and_1393 = or_1390 & and_1391;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1394;
  assign select_1394 = equal_520_s11_q ? {and_1393, xor_1392, parity_1386, parity_1365_s11_q, xor_1320_s11_q, xor_1225_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_518_s11_q ? 6'h0 : select_1394;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1434;
  assign sum_1434 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1437;
  assign sum_1437 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/patches.hpp:346
  logic not_1580;
  assign not_1580 = ~patches_begins_q;
  // hls/stages/patches.hpp:316
  logic and_1584;
  assign and_1584 = patches_capturing_q & not_1583_s11_q;
  // hls/stages/patches.hpp:97
  logic and_1592;
  assign and_1592 = (not_1580 & (patches_work_q == 3'h0)) & (~(and_1584 | or_1589_s11_q));
  // hls/stages/patches.hpp:454
  logic equal_1672;
  assign equal_1672 = patches_work_q == 3'h4;
  logic equal_1674;
  assign equal_1674 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:143
  logic equal_1676;
  assign equal_1676 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:454
  logic equal_1677;
  assign equal_1677 = patches_work_q == 3'h2;
  logic or_1678;
  assign or_1678 = equal_1676 | equal_1677;
  // hls/stages/patches.hpp:403
  logic not_1679;
  assign not_1679 = ~patches_second_q;
  // hls/stages/patches.hpp:327
  logic [4:0] select_1698;
  assign select_1698 = and_1592 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:98
  logic [4:0] select_1699;
  assign select_1699 = and_1579_s11_q ? select_1698 : patches_row_q;
  // hls/stages/patches.hpp:97
  logic and_1701;
  assign and_1701 = and_1584 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:98
  logic select_1705;
  assign select_1705 = and_1579_s11_q ? (and_1592 | (and_1584 & (~and_1701))) : patches_capturing_q;
  // hls/stages/patches.hpp:143
  logic not_1727;
  assign not_1727 = ~equal_1676;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1739;
  assign select_1739 = and_1579_s11_q ? {select_1698[4], select_1698[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:466
  logic less_1804;
  assign less_1804 = patches_step_q[4:0] < 5'h11;
  logic equal_1805;
  assign equal_1805 = patches_step_q[6:5] == 2'h0;
  logic not_1806;
  assign not_1806 = ~equal_1805;
  logic equal_1807;
  assign equal_1807 = patches_step_q[6:5] == 2'h3;
  logic not_1808;
  assign not_1808 = ~equal_1807;
  // hls/stages/patches.hpp:480
  logic select_1811;
  assign select_1811 = equal_1807 ? (less_1804 & (less_1804 & not_1808)) : less_1804;
  // hls/stages/patches.hpp:347
  logic or_2762;
  assign or_2762 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:349
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:163
  logic and_2768;
  assign and_2768 = equal_1672 & not_1679;
  // hls/stages/patches.hpp:353
  logic and_2769;
  assign and_2769 = not_1727 & and_2768;
  logic [1:0] select_2771;
  assign select_2771 = equal_1674 ? 2'h0 : (equal_1677 ? 2'h3 : {equal_1676, and_2769});
  // hls/stages/patches.hpp:244
  logic equal_2773;
  assign equal_2773 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:242
  logic not_2774;
  assign not_2774 = ~equal_2773;
  // hls/stages/patches.hpp:244
  logic equal_2775;
  assign equal_2775 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:240
  logic not_2776;
  assign not_2776 = ~equal_2775;
  // hls/stages/patches.hpp:248
  logic not_2778;
  assign not_2778 = ~(patches_following_q == 3'h2);
  logic and_2781;
  assign and_2781 = (~(patches_following_q == 3'h1)) & not_2778;
  // hls/stages/patches.hpp:351
  logic [1:0] select_2782;
  assign select_2782 = equal_2775 ? 2'h2 : {and_2781, not_2778};
  logic [3:0] select_2783;
  assign select_2783 = equal_2773 ? 4'h2 : {select_2782, {2{not_2776}}};
  // hls/stages/patches.hpp:359
  logic not_2786;
  assign not_2786 = ~or_2762;
  // hls/stages/patches.hpp:348
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:360
  logic [11:0] select_2791;
  assign select_2791 = or_2762 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
    end else if (s11_en) begin
      patches_capturing_q <= sample_pair_whole_s11_q ? select_1705 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s11_q ? select_1699 : patches_row_q;
      patches_work_q <= or_2762 ? following : patches_work_q;
      patches_second_q <= not_1580 & (patches_second_q | (patches_ends_q & equal_1672));
      patches_following_q <= equal_1672 ? {2'h0, and_2768} : {equal_1674, select_2771};
      patches_following_beats_q <= {select_2783, not_2774};
      patches_begins_q <= sample_pair_whole_s11_q & (and_1579_s11_q & and_1701);
      patches_ends_q <= not_2786 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2791;
      patches_step_q <= or_2762 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic sample_pair_whole_s12_q;
  logic sample_present_s12_q;
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [6:0] last_s12_q;
  logic [3:0] age_s12_q;
  logic [2:0] slot_s12_q;
  logic ends_cell_s12_q;
  logic lower_half_s12_q;
  logic [4:0] patches_band_rows_number_s12_q;
  logic patches_chooses_s12_q;
  logic [4:0] patches_choosing_band_s12_q;
  logic patches_second_s12_q;
  logic [4:0] patches_step_s12_q;
  logic [3:0] select_458_s12_q;
  logic equal_459_s12_q;
  logic [6:0] select_461_s12_q;
  logic [8:0] select_465_s12_q;
  logic and_471_s12_q;
  logic equal_477_s12_q;
  logic [6:0] column_s12_q;
  logic and_495_s12_q;
  logic and_497_s12_q;
  logic so_s12_q;
  logic equal_517_s12_q;
  logic or_518_s12_q;
  logic less_525_s12_q;
  logic not_526_s12_q;
  logic equal_558_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic select_646_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1147_s12_q;
  logic [5:0] select_1396_s12_q;
  logic [6:0] sum_1435_s12_q;
  logic [6:0] sum_1438_s12_q;
  logic and_1448_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic select_1457_s12_q;
  logic equal_1466_s12_q;
  logic and_1473_s12_q;
  logic and_1476_s12_q;
  logic and_1480_s12_q;
  logic or_1494_s12_q;
  logic [6:0] select_1505_s12_q;
  logic and_1579_s12_q;
  logic and_1592_s12_q;
  logic less_1606_s12_q;
  logic equal_1672_s12_q;
  logic equal_1674_s12_q;
  logic equal_1676_s12_q;
  logic or_1678_s12_q;
  logic and_1681_s12_q;
  logic [4:0] select_1699_s12_q;
  logic select_1705_s12_q;
  logic and_1711_s12_q;
  logic and_1728_s12_q;
  logic [3:0] select_1739_s12_q;
  logic less_1804_s12_q;
  logic equal_1805_s12_q;
  logic not_1806_s12_q;
  logic equal_1807_s12_q;
  logic not_1808_s12_q;
  logic select_1811_s12_q;
  logic and_1812_s12_q;
  logic and_1967_s12_q;
  logic equal_2113_s12_q;
  logic equal_2237_s12_q;
  logic and_2548_s12_q;
  logic and_2550_s12_q;
  logic not_2723_s12_q;
  logic or_2762_s12_q;
  logic not_2786_s12_q;
  logic and_3250_s12_q;
  logic equal_3257_s12_q;
  logic less_3532_s12_q;
  logic equal_3737_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
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
      last_s12_q <= last_s11_q;
      age_s12_q <= age_s11_q;
      slot_s12_q <= slot_s11_q;
      ends_cell_s12_q <= ends_cell_s11_q;
      lower_half_s12_q <= lower_half_s11_q;
      patches_band_rows_number_s12_q <= patches_band_rows_number_s11_q;
      patches_chooses_s12_q <= patches_chooses_s11_q;
      patches_choosing_band_s12_q <= patches_choosing_band_s11_q;
      patches_second_s12_q <= patches_second_q;
      patches_step_s12_q <= patches_step_q[4:0];
      select_458_s12_q <= select_458_s11_q;
      equal_459_s12_q <= equal_459_s11_q;
      select_461_s12_q <= select_461_s11_q;
      select_465_s12_q <= select_465_s11_q;
      and_471_s12_q <= and_471_s11_q;
      equal_477_s12_q <= equal_477_s11_q;
      column_s12_q <= column_s11_q;
      and_495_s12_q <= and_495_s11_q;
      and_497_s12_q <= and_497_s11_q;
      so_s12_q <= so_s11_q;
      equal_517_s12_q <= equal_517_s11_q;
      or_518_s12_q <= or_518_s11_q;
      less_525_s12_q <= less_525_s11_q;
      not_526_s12_q <= not_526_s11_q;
      equal_558_s12_q <= equal_558_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_646_s12_q <= select_646_s11_q;
      column_2_s12_q <= column_2;
      select_1147_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1396_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1435_s12_q <= {1'b0, before_v_2} + sum_1434;
      sum_1438_s12_q <= {1'b0, before_v_3} + sum_1437;
      and_1448_s12_q <= and_1448_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      select_1457_s12_q <= select_1457_s11_q;
      equal_1466_s12_q <= equal_1466_s11_q;
      and_1473_s12_q <= and_1473_s11_q;
      and_1476_s12_q <= and_1476_s11_q;
      and_1480_s12_q <= and_1480_s11_q;
      or_1494_s12_q <= or_1494_s11_q;
      select_1505_s12_q <= select_1505_s11_q;
      and_1579_s12_q <= and_1579_s11_q;
      and_1592_s12_q <= and_1592;
      less_1606_s12_q <= less_1606_s11_q;
      equal_1672_s12_q <= equal_1672;
      equal_1674_s12_q <= equal_1674;
      equal_1676_s12_q <= equal_1676;
      or_1678_s12_q <= or_1678;
      and_1681_s12_q <= or_1678 & (equal_1676 & not_1679);
      select_1699_s12_q <= select_1699;
      select_1705_s12_q <= select_1705;
      and_1711_s12_q <= or_1678 & (patches_second_q & equal_1676);
      and_1728_s12_q <= not_1727 & or_1678;
      select_1739_s12_q <= select_1739;
      less_1804_s12_q <= less_1804;
      equal_1805_s12_q <= equal_1805;
      not_1806_s12_q <= not_1806;
      equal_1807_s12_q <= equal_1807;
      not_1808_s12_q <= not_1808;
      select_1811_s12_q <= select_1811;
      and_1812_s12_q <= not_1806 & select_1811;
      and_1967_s12_q <= and_1967_s11_q;
      equal_2113_s12_q <= equal_2113_s11_q;
      equal_2237_s12_q <= equal_2237_s11_q;
      and_2548_s12_q <= and_2548_s11_q;
      and_2550_s12_q <= and_2550_s11_q;
      not_2723_s12_q <= not_2723_s11_q;
      or_2762_s12_q <= or_2762;
      not_2786_s12_q <= not_2786;
      and_3250_s12_q <= less_1804 & (patches_step_q[6:5] == 2'h1);
      equal_3257_s12_q <= patches_step_q[6:5] == 2'h2;
      less_3532_s12_q <= less_3532_s11_q;
      equal_3737_s12_q <= equal_3737_s11_q;
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
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_898;
  assign select_898 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1430;
  assign sum_1430 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1440;
  assign select_1440 = (sum_1435_s12_q < sum_1438_s12_q) ? sum_1438_s12_q : sum_1435_s12_q;
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/patches.hpp:435
  logic not_1673;
  assign not_1673 = ~equal_1672_s12_q;
  // hls/stages/patches.hpp:401
  logic not_1675;
  assign not_1675 = ~equal_1674_s12_q;
  logic and_1749;
  assign and_1749 = not_1673 & (or_1678_s12_q & not_1675);
  // hls/stages/patches.hpp:160
  logic and_1814;
  assign and_1814 = equal_1672_s12_q & (less_1804_s12_q ? and_1812_s12_q : select_1811_s12_q);
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2337;
  assign select_2337 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2338;
  assign select_2338 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2339;
  assign select_2339 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2340;
  assign select_2340 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2341;
  assign select_2341 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2342;
  assign select_2342 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/patches.hpp:98
  logic select_2725;
  assign select_2725 = and_1579_s12_q ? (and_1592_s12_q ? not_2723_s12_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:163
  logic [4:0] select_2793;
  assign select_2793 = or_2762_s12_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:477
  logic select_3252;
  assign select_3252 = less_1804_s12_q ? (not_1808_s12_q & and_3250_s12_q) : and_3250_s12_q;
  // hls/stages/patches.hpp:480
  logic select_3253;
  assign select_3253 = equal_1807_s12_q ? select_3252 : and_3250_s12_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:677; read in stage 12, written in stage 24: 12 < 24 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s12_en & (not_1673 & (not_1675 & and_1681_s12_q));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:677; read in stage 12, written in stage 24: 12 < 24 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s12_en & (not_1673 & (not_1675 & and_1711_s12_q));
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:689; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 32'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s12_en & and_1749;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:708; read in stage 12, written in stage 26: 12 < 26 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_s12_q;
  logic patches_rows_re;
  assign patches_rows_re = s12_en & and_1814;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_lower_q <= 1'b0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
    end else if (s12_en) begin
      patches_lower_q <= sample_pair_whole_s12_q ? select_2725 : patches_lower_q;
      patches_code_row_q <= select_2793;
      patches_column_q <= or_2762_s12_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2786_s12_q & (patches_column_q == 5'h1e);
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
      middle_sum_columns_values_1_q <= select_2337;
      middle_sum_columns_values_2_q <= select_2338;
      middle_sum_columns_values_3_q <= select_2339;
      middle_sum_columns_values_4_q <= select_2340;
      middle_sum_columns_values_5_q <= select_2341;
      middle_sum_columns_values_6_q <= select_2342;
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
  logic [6:0] last_s13_q;
  logic [1:0] age_s13_q;
  logic [2:0] slot_s13_q;
  logic ends_cell_s13_q;
  logic lower_half_s13_q;
  logic [4:0] patches_band_rows_number_s13_q;
  logic patches_chooses_s13_q;
  logic [4:0] patches_choosing_band_s13_q;
  logic patches_lower_s13_q;
  logic patches_second_s13_q;
  logic [4:0] patches_code_row_s13_q;
  logic [4:0] patches_column_s13_q;
  logic [4:0] patches_step_s13_q;
  logic [3:0] select_458_s13_q;
  logic equal_459_s13_q;
  logic [6:0] select_461_s13_q;
  logic [8:0] select_465_s13_q;
  logic and_471_s13_q;
  logic equal_477_s13_q;
  logic [6:0] column_s13_q;
  logic and_495_s13_q;
  logic and_497_s13_q;
  logic so_s13_q;
  logic equal_517_s13_q;
  logic or_518_s13_q;
  logic less_525_s13_q;
  logic not_526_s13_q;
  logic equal_558_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_646_s13_q;
  logic [6:0] difference_899_s13_q;
  logic [6:0] difference_1148_s13_q;
  logic equal_1149_s13_q;
  logic [6:0] difference_1397_s13_q;
  logic [6:0] sum_1431_s13_q;
  logic [6:0] select_1440_s13_q;
  logic and_1448_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1457_s13_q;
  logic equal_1466_s13_q;
  logic and_1473_s13_q;
  logic and_1476_s13_q;
  logic and_1480_s13_q;
  logic less_1481_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1494_s13_q;
  logic [6:0] select_1505_s13_q;
  logic and_1579_s13_q;
  logic and_1592_s13_q;
  logic less_1606_s13_q;
  logic equal_1672_s13_q;
  logic not_1673_s13_q;
  logic equal_1674_s13_q;
  logic not_1675_s13_q;
  logic equal_1676_s13_q;
  logic or_1678_s13_q;
  logic [4:0] select_1699_s13_q;
  logic select_1705_s13_q;
  logic and_1730_s13_q;
  logic [3:0] select_1739_s13_q;
  logic and_1749_s13_q;
  logic less_1804_s13_q;
  logic equal_1805_s13_q;
  logic not_1806_s13_q;
  logic equal_1807_s13_q;
  logic not_1808_s13_q;
  logic and_1967_s13_q;
  logic equal_2113_s13_q;
  logic equal_2237_s13_q;
  logic and_2548_s13_q;
  logic and_2550_s13_q;
  logic and_2557_s13_q;
  logic or_2762_s13_q;
  logic not_2786_s13_q;
  logic select_3255_s13_q;
  logic equal_3257_s13_q;
  logic less_3532_s13_q;
  logic equal_3737_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
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
      last_s13_q <= last_s12_q;
      age_s13_q <= {age_s12_q[2], age_s12_q[0]};
      slot_s13_q <= slot_s12_q;
      ends_cell_s13_q <= ends_cell_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      patches_band_rows_number_s13_q <= patches_band_rows_number_s12_q;
      patches_chooses_s13_q <= patches_chooses_s12_q;
      patches_choosing_band_s13_q <= patches_choosing_band_s12_q;
      patches_lower_s13_q <= patches_lower_q;
      patches_second_s13_q <= patches_second_s12_q;
      patches_code_row_s13_q <= patches_code_row_q;
      patches_column_s13_q <= patches_column_q;
      patches_step_s13_q <= patches_step_s12_q;
      select_458_s13_q <= select_458_s12_q;
      equal_459_s13_q <= equal_459_s12_q;
      select_461_s13_q <= select_461_s12_q;
      select_465_s13_q <= select_465_s12_q;
      and_471_s13_q <= and_471_s12_q;
      equal_477_s13_q <= equal_477_s12_q;
      column_s13_q <= column_s12_q;
      and_495_s13_q <= and_495_s12_q;
      and_497_s13_q <= and_497_s12_q;
      so_s13_q <= so_s12_q;
      equal_517_s13_q <= equal_517_s12_q;
      or_518_s13_q <= or_518_s12_q;
      less_525_s13_q <= less_525_s12_q;
      not_526_s13_q <= not_526_s12_q;
      equal_558_s13_q <= equal_558_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_646_s13_q <= select_646_s12_q;
      difference_899_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_898};
      difference_1148_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1147_s12_q};
      equal_1149_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1397_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1396_s12_q};
      sum_1431_s13_q <= {1'b0, before_v} + sum_1430;
      select_1440_s13_q <= select_1440;
      and_1448_s13_q <= and_1448_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1457_s13_q <= select_1457_s12_q;
      equal_1466_s13_q <= equal_1466_s12_q;
      and_1473_s13_q <= and_1473_s12_q;
      and_1476_s13_q <= and_1476_s12_q;
      and_1480_s13_q <= and_1480_s12_q;
      less_1481_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1494_s13_q <= or_1494_s12_q;
      select_1505_s13_q <= select_1505_s12_q;
      and_1579_s13_q <= and_1579_s12_q;
      and_1592_s13_q <= and_1592_s12_q;
      less_1606_s13_q <= less_1606_s12_q;
      equal_1672_s13_q <= equal_1672_s12_q;
      not_1673_s13_q <= not_1673;
      equal_1674_s13_q <= equal_1674_s12_q;
      not_1675_s13_q <= not_1675;
      equal_1676_s13_q <= equal_1676_s12_q;
      or_1678_s13_q <= or_1678_s12_q;
      select_1699_s13_q <= select_1699_s12_q;
      select_1705_s13_q <= select_1705_s12_q;
      and_1730_s13_q <= not_1673 & (not_1675 & and_1728_s12_q);
      select_1739_s13_q <= select_1739_s12_q;
      and_1749_s13_q <= and_1749;
      less_1804_s13_q <= less_1804_s12_q;
      equal_1805_s13_q <= equal_1805_s12_q;
      not_1806_s13_q <= not_1806_s12_q;
      equal_1807_s13_q <= equal_1807_s12_q;
      not_1808_s13_q <= not_1808_s12_q;
      and_1967_s13_q <= and_1967_s12_q;
      equal_2113_s13_q <= equal_2113_s12_q;
      equal_2237_s13_q <= equal_2237_s12_q;
      and_2548_s13_q <= and_2548_s12_q;
      and_2550_s13_q <= and_2550_s12_q;
      and_2557_s13_q <= ends_cell_s12_q & so_s12_q;
      or_2762_s13_q <= or_2762_s12_q;
      not_2786_s13_q <= not_2786_s12_q;
      select_3255_s13_q <= less_1804_s12_q ? (not_1806_s12_q & select_3253) : select_3253;
      equal_3257_s13_q <= equal_3257_s12_q;
      less_3532_s13_q <= less_3532_s12_q;
      equal_3737_s13_q <= equal_3737_s12_q;
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
  logic patches_read_searches_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/agreement.hpp:772
  logic less_647;
  assign less_647 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_649;
  assign less_649 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:231
  logic and_651;
  assign and_651 = (~less_647) & (~less_649);
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_901;
  assign sum_901 = {difference_899_s13_q[6], difference_899_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1151;
  assign sum_1151 = {difference_1148_s13_q[6], difference_1148_s13_q} + (equal_1149_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1399;
  assign sum_1399 = {difference_1397_s13_q[6], difference_1397_s13_q} + (equal_1149_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1432;
  assign select_1432 = slot_s13_q[0] ? chosen_near_q : sum_1431_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1442;
  assign select_1442 = (select_1432 < select_1440_s13_q) ? select_1440_s13_q : select_1432;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_651 ? select_1442 : 7'h0;
  // hls/stages/agreement.hpp:935
  logic select_1483;
  assign select_1483 = slot_s13_q[2] ? less_1481_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1486;
  assign difference_1486 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/registration.hpp:215
  logic [16:0] select_1640;
  assign select_1640 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1835;
  assign sum_1835 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2348;
  assign select_2348 = slot_s13_q[0] ? 7'h0 : sum_1431_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_2350;
  assign select_2350 = (select_2348 < select_1440_s13_q) ? select_1440_s13_q : select_2348;
  // hls/stages/registration.hpp:128
  logic [15:0] select_2551;
  assign select_2551 = and_2550_s13_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2553;
  assign select_2553 = and_2548_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2551[15]}}, select_2551});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2554;
  assign select_2554 = and_2550_s13_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2554[15]}}, select_2554};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2556;
  assign select_2556 = and_2548_s13_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:124
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2557_s13_q ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3544;
  assign select_3544 = so_s13_q ? (and_2557_s13_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3546;
  assign sum_3546 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3547;
  assign select_3547 = sum_1835[5] ? {1'b1, sum_1835[4:0], region_across_rest_q[2:0]} : sum_3546;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3549;
  assign select_3549 = equal_2237_s13_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3552;
  assign select_3552 = equal_2237_s13_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:678; read in stage 13, written in stage 23: 13 < 23 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s13_q, patches_code_row_s13_q[3:0], patches_column_s13_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s13_en & and_1730_s13_q;
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_near_q <= 7'h0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      patches_read_searches_q <= 1'b0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s13_en) begin
      chosen_near_q <= select_2350;
      registration_slope_row_q <= select_2553;
      registration_slope_change_q <= select_2556;
      registration_slope_q <= so_s13_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_read_searches_q <= equal_1672_s13_q ? select_3255_s13_q : patches_read_searches_q;
      region_across_rest_q <= select_3544;
      region_across_back_q <= so_s13_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3547;
      columns_begin_rest_q <= and_497_s13_q ? select_3549 : columns_begin_rest_q;
      columns_begin_back_q <= and_497_s13_q ? select_3552 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_901;
      sums_0_sum_sums_values_0_q <= sum_1151;
      sums_0_sum_sums_values_1_q <= equal_1149_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1399;
      sums_1_sum_sums_values_1_q <= equal_1149_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic patches_lower_s14_q;
  logic patches_second_s14_q;
  logic [4:0] patches_code_row_s14_q;
  logic [4:0] patches_column_s14_q;
  logic [4:0] patches_step_s14_q;
  logic patches_read_searches_s14_q;
  logic [3:0] select_458_s14_q;
  logic equal_459_s14_q;
  logic [6:0] select_461_s14_q;
  logic [8:0] select_465_s14_q;
  logic and_471_s14_q;
  logic equal_477_s14_q;
  logic [6:0] column_s14_q;
  logic and_495_s14_q;
  logic and_497_s14_q;
  logic so_s14_q;
  logic equal_517_s14_q;
  logic or_518_s14_q;
  logic less_525_s14_q;
  logic not_526_s14_q;
  logic equal_558_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_646_s14_q;
  logic and_651_s14_q;
  logic [7:0] sum_901_s14_q;
  logic less_1400_s14_q;
  logic [6:0] of_near_s14_q;
  logic and_1448_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1457_s14_q;
  logic equal_1466_s14_q;
  logic and_1473_s14_q;
  logic and_1476_s14_q;
  logic and_1480_s14_q;
  logic select_1483_s14_q;
  logic [9:0] sum_1487_s14_q;
  logic or_1494_s14_q;
  logic [6:0] select_1505_s14_q;
  logic and_1579_s14_q;
  logic and_1592_s14_q;
  logic less_1606_s14_q;
  logic [16:0] select_1640_s14_q;
  logic equal_1672_s14_q;
  logic not_1673_s14_q;
  logic equal_1674_s14_q;
  logic not_1675_s14_q;
  logic equal_1676_s14_q;
  logic or_1678_s14_q;
  logic [7:0] patches_right_0_rdata_s14_q;
  logic [4:0] select_1699_s14_q;
  logic select_1705_s14_q;
  logic [7:0] patches_right_1_rdata_s14_q;
  logic [3:0] select_1739_s14_q;
  logic and_1749_s14_q;
  logic [31:0] patches_columns_above_rdata_s14_q;
  logic less_1804_s14_q;
  logic equal_1805_s14_q;
  logic not_1806_s14_q;
  logic equal_1807_s14_q;
  logic not_1808_s14_q;
  logic [14:0] patches_rows_rdata_s14_q;
  logic sum_1835_s14_q;
  logic and_1967_s14_q;
  logic equal_2113_s14_q;
  logic equal_2237_s14_q;
  logic or_2762_s14_q;
  logic not_2786_s14_q;
  logic equal_3257_s14_q;
  logic less_3532_s14_q;
  logic equal_3737_s14_q;
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
      patches_band_rows_number_s14_q <= patches_band_rows_number_s13_q;
      patches_chooses_s14_q <= patches_chooses_s13_q;
      patches_choosing_band_s14_q <= patches_choosing_band_s13_q;
      patches_lower_s14_q <= patches_lower_s13_q;
      patches_second_s14_q <= patches_second_s13_q;
      patches_code_row_s14_q <= patches_code_row_s13_q;
      patches_column_s14_q <= patches_column_s13_q;
      patches_step_s14_q <= patches_step_s13_q;
      patches_read_searches_s14_q <= patches_read_searches_q;
      select_458_s14_q <= select_458_s13_q;
      equal_459_s14_q <= equal_459_s13_q;
      select_461_s14_q <= select_461_s13_q;
      select_465_s14_q <= select_465_s13_q;
      and_471_s14_q <= and_471_s13_q;
      equal_477_s14_q <= equal_477_s13_q;
      column_s14_q <= column_s13_q;
      and_495_s14_q <= and_495_s13_q;
      and_497_s14_q <= and_497_s13_q;
      so_s14_q <= so_s13_q;
      equal_517_s14_q <= equal_517_s13_q;
      or_518_s14_q <= or_518_s13_q;
      less_525_s14_q <= less_525_s13_q;
      not_526_s14_q <= not_526_s13_q;
      equal_558_s14_q <= equal_558_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_646_s14_q <= select_646_s13_q;
      and_651_s14_q <= and_651;
      sum_901_s14_q <= sum_901;
      less_1400_s14_q <= sum_1151 < sum_1399;
      of_near_s14_q <= of_near;
      and_1448_s14_q <= and_1448_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1457_s14_q <= select_1457_s13_q;
      equal_1466_s14_q <= equal_1466_s13_q;
      and_1473_s14_q <= and_1473_s13_q;
      and_1476_s14_q <= and_1476_s13_q;
      and_1480_s14_q <= and_1480_s13_q;
      select_1483_s14_q <= select_1483;
      sum_1487_s14_q <= {difference_1486[8], difference_1486} + 10'h1;
      or_1494_s14_q <= or_1494_s13_q;
      select_1505_s14_q <= select_1505_s13_q;
      and_1579_s14_q <= and_1579_s13_q;
      and_1592_s14_q <= and_1592_s13_q;
      less_1606_s14_q <= less_1606_s13_q;
      select_1640_s14_q <= select_1640;
      equal_1672_s14_q <= equal_1672_s13_q;
      not_1673_s14_q <= not_1673_s13_q;
      equal_1674_s14_q <= equal_1674_s13_q;
      not_1675_s14_q <= not_1675_s13_q;
      equal_1676_s14_q <= equal_1676_s13_q;
      or_1678_s14_q <= or_1678_s13_q;
      patches_right_0_rdata_s14_q <= patches_right_0_rdata_q;
      select_1699_s14_q <= select_1699_s13_q;
      select_1705_s14_q <= select_1705_s13_q;
      patches_right_1_rdata_s14_q <= patches_right_1_rdata_q;
      select_1739_s14_q <= select_1739_s13_q;
      and_1749_s14_q <= and_1749_s13_q;
      patches_columns_above_rdata_s14_q <= patches_columns_above_rdata_q;
      less_1804_s14_q <= less_1804_s13_q;
      equal_1805_s14_q <= equal_1805_s13_q;
      not_1806_s14_q <= not_1806_s13_q;
      equal_1807_s14_q <= equal_1807_s13_q;
      not_1808_s14_q <= not_1808_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_q;
      sum_1835_s14_q <= sum_1835[5];
      and_1967_s14_q <= and_1967_s13_q;
      equal_2113_s14_q <= equal_2113_s13_q;
      equal_2237_s14_q <= equal_2237_s13_q;
      or_2762_s14_q <= or_2762_s13_q;
      not_2786_s14_q <= not_2786_s13_q;
      equal_3257_s14_q <= equal_3257_s13_q;
      less_3532_s14_q <= less_3532_s13_q;
      equal_3737_s14_q <= equal_3737_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [7:0] chosen_score_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  // hls/stages/agreement.hpp:739
  logic [7:0] select_902;
  assign select_902 = slot_s14_q[0] ? chosen_score_q : sum_901_s14_q;
  // hls/stages/agreement.hpp:735
  logic [7:0] select_1401;
  assign select_1401 = less_1400_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1402;
  assign less_1402 = select_902 < select_1401;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_651_s14_q ? (less_1402 ? select_1401 : select_902) : 8'h0;
  // hls/stages/agreement.hpp:704
  logic not_1408;
  assign not_1408 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1409;
  assign select_1409 = less_1400_s14_q ? {slot_s14_q[0], not_1408} : 2'h0;
  logic [2:0] select_1411;
  assign select_1411 = less_1402 ? {select_1409, not_1408} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1420;
  assign select_1420 = slot_s14_q[0] ? 8'h0 : sum_901_s14_q;
  // hls/stages/agreement.hpp:788
  logic or_1445;
  assign or_1445 = select_646_s14_q | (best_left_rdata_s14_q[39:33] < of_near_s14_q);
  // hls/stages/agreement.hpp:801
  logic or_1463;
  assign or_1463 = select_1457_s14_q | (best_right_rdata_s14_q[21:15] < of_near_s14_q);
  // hls/stages/agreement.hpp:235
  logic and_1489;
  assign and_1489 = (and_1476_s14_q & select_1483_s14_q) & ({{22{sum_1487_s14_q[9]}}, sum_1487_s14_q} < 32'h3);
  // hls/stages/registration.hpp:215
  logic [13:0] select_1642;
  assign select_1642 = ($signed(10'h0) < $signed(select_1640_s14_q[16:7])) ? 14'h7f : select_1640_s14_q[13:0];
  // hls/stages/patches.hpp:148
  logic [7:0] pixel;
  assign pixel = equal_1676_s14_q ? (patches_second_s14_q ? 8'h0 : patches_right_0_rdata_s14_q) : 8'h0;
  // hls/stages/patches.hpp:410
  logic [8:0] sum_1771;
  assign sum_1771 = {1'b0, patches_columns_above_rdata_s14_q[23:16]} + {3'h0, patches_columns_above_rdata_s14_q[31:26]};
  // hls/stages/agreement.hpp:735
  logic less_2346;
  assign less_2346 = select_1420 < select_1401;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2441;
  assign select_2441 = or_518_s14_q ? (less_525_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2443;
  assign select_2443 = or_518_s14_q ? (less_525_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:476
  logic [9:0] select_3220;
  assign select_3220 = less_1804_s14_q ? patches_rows_rdata_s14_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:477
  logic [9:0] select_3222;
  assign select_3222 = less_1804_s14_q ? (equal_1807_s14_q ? 10'h0 : select_3220) : 10'h0;
  // hls/stages/patches.hpp:476
  logic [4:0] select_3227;
  assign select_3227 = less_1804_s14_q ? patches_rows_rdata_s14_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:480
  logic [4:0] select_3230;
  assign select_3230 = equal_1807_s14_q ? (less_1804_s14_q ? (equal_1807_s14_q ? 5'h0 : select_3227) : 5'h0) : select_3227;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_score_q <= 8'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
    end else if (s14_en) begin
      chosen_score_q <= less_2346 ? select_1401 : select_1420;
      chosen_place_q <= less_2346 ? {select_1409, not_1408} : 3'h2;
      before_0_q <= select_1420;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
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
  logic patches_lower_s15_q;
  logic patches_second_s15_q;
  logic [4:0] patches_code_row_s15_q;
  logic [4:0] patches_column_s15_q;
  logic [4:0] patches_step_s15_q;
  logic patches_read_searches_s15_q;
  logic [3:0] select_458_s15_q;
  logic equal_459_s15_q;
  logic [6:0] select_461_s15_q;
  logic [8:0] select_465_s15_q;
  logic and_471_s15_q;
  logic equal_477_s15_q;
  logic [6:0] column_s15_q;
  logic and_495_s15_q;
  logic and_497_s15_q;
  logic so_s15_q;
  logic equal_517_s15_q;
  logic or_518_s15_q;
  logic less_525_s15_q;
  logic not_526_s15_q;
  logic equal_558_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_646_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1411_s15_q;
  logic [6:0] of_near_s15_q;
  logic or_1445_s15_q;
  logic and_1448_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1457_s15_q;
  logic or_1463_s15_q;
  logic equal_1466_s15_q;
  logic and_1473_s15_q;
  logic and_1477_s15_q;
  logic and_1480_s15_q;
  logic and_1490_s15_q;
  logic and_1495_s15_q;
  logic [8:0] select_1497_s15_q;
  logic [6:0] select_1505_s15_q;
  logic and_1579_s15_q;
  logic and_1592_s15_q;
  logic less_1606_s15_q;
  logic [13:0] select_1642_s15_q;
  logic equal_1672_s15_q;
  logic not_1673_s15_q;
  logic equal_1674_s15_q;
  logic not_1675_s15_q;
  logic equal_1676_s15_q;
  logic or_1678_s15_q;
  logic [4:0] select_1699_s15_q;
  logic select_1705_s15_q;
  logic [7:0] patches_left_rdata_s15_q;
  logic [3:0] select_1739_s15_q;
  logic and_1749_s15_q;
  logic [31:0] patches_columns_above_rdata_s15_q;
  logic [7:0] select_1753_s15_q;
  logic [8:0] sum_1771_s15_q;
  logic less_1804_s15_q;
  logic equal_1805_s15_q;
  logic not_1806_s15_q;
  logic equal_1807_s15_q;
  logic not_1808_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic sum_1835_s15_q;
  logic and_1967_s15_q;
  logic equal_2113_s15_q;
  logic equal_2237_s15_q;
  logic [7:0] select_2441_s15_q;
  logic [7:0] select_2443_s15_q;
  logic or_2762_s15_q;
  logic not_2786_s15_q;
  logic [9:0] select_3223_s15_q;
  logic [4:0] select_3230_s15_q;
  logic equal_3257_s15_q;
  logic less_3532_s15_q;
  logic equal_3737_s15_q;
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
      patches_lower_s15_q <= patches_lower_s14_q;
      patches_second_s15_q <= patches_second_s14_q;
      patches_code_row_s15_q <= patches_code_row_s14_q;
      patches_column_s15_q <= patches_column_s14_q;
      patches_step_s15_q <= patches_step_s14_q;
      patches_read_searches_s15_q <= patches_read_searches_s14_q;
      select_458_s15_q <= select_458_s14_q;
      equal_459_s15_q <= equal_459_s14_q;
      select_461_s15_q <= select_461_s14_q;
      select_465_s15_q <= select_465_s14_q;
      and_471_s15_q <= and_471_s14_q;
      equal_477_s15_q <= equal_477_s14_q;
      column_s15_q <= column_s14_q;
      and_495_s15_q <= and_495_s14_q;
      and_497_s15_q <= and_497_s14_q;
      so_s15_q <= so_s14_q;
      equal_517_s15_q <= equal_517_s14_q;
      or_518_s15_q <= or_518_s14_q;
      less_525_s15_q <= less_525_s14_q;
      not_526_s15_q <= not_526_s14_q;
      equal_558_s15_q <= equal_558_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_646_s15_q <= select_646_s14_q;
      of_best_s15_q <= of_best;
      select_1411_s15_q <= select_1411;
      of_near_s15_q <= of_near_s14_q;
      or_1445_s15_q <= or_1445;
      and_1448_s15_q <= and_1448_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1457_s15_q <= select_1457_s14_q;
      or_1463_s15_q <= or_1463;
      equal_1466_s15_q <= equal_1466_s14_q;
      and_1473_s15_q <= and_1473_s14_q;
      and_1477_s15_q <= not_526_s14_q & and_1476_s14_q;
      and_1480_s15_q <= and_1480_s14_q;
      and_1490_s15_q <= not_526_s14_q & and_1489;
      and_1495_s15_q <= and_1489 & or_1494_s14_q;
      select_1497_s15_q <= less_525_s14_q ? 9'h0 : best_left_rdata_s14_q[8:0];
      select_1505_s15_q <= select_1505_s14_q;
      and_1579_s15_q <= and_1579_s14_q;
      and_1592_s15_q <= and_1592_s14_q;
      less_1606_s15_q <= less_1606_s14_q;
      select_1642_s15_q <= select_1642;
      equal_1672_s15_q <= equal_1672_s14_q;
      not_1673_s15_q <= not_1673_s14_q;
      equal_1674_s15_q <= equal_1674_s14_q;
      not_1675_s15_q <= not_1675_s14_q;
      equal_1676_s15_q <= equal_1676_s14_q;
      or_1678_s15_q <= or_1678_s14_q;
      select_1699_s15_q <= select_1699_s14_q;
      select_1705_s15_q <= select_1705_s14_q;
      patches_left_rdata_s15_q <= patches_left_rdata_q;
      select_1739_s15_q <= select_1739_s14_q;
      and_1749_s15_q <= and_1749_s14_q;
      patches_columns_above_rdata_s15_q <= patches_columns_above_rdata_s14_q;
      select_1753_s15_q <= patches_second_s14_q ? patches_right_1_rdata_s14_q : pixel;
      sum_1771_s15_q <= sum_1771;
      less_1804_s15_q <= less_1804_s14_q;
      equal_1805_s15_q <= equal_1805_s14_q;
      not_1806_s15_q <= not_1806_s14_q;
      equal_1807_s15_q <= equal_1807_s14_q;
      not_1808_s15_q <= not_1808_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q[9:0];
      sum_1835_s15_q <= sum_1835_s14_q;
      and_1967_s15_q <= and_1967_s14_q;
      equal_2113_s15_q <= equal_2113_s14_q;
      equal_2237_s15_q <= equal_2237_s14_q;
      select_2441_s15_q <= select_2441;
      select_2443_s15_q <= select_2443;
      or_2762_s15_q <= or_2762_s14_q;
      not_2786_s15_q <= not_2786_s14_q;
      select_3223_s15_q <= equal_1807_s14_q ? select_3222 : select_3220;
      select_3230_s15_q <= select_3230;
      equal_3257_s15_q <= equal_3257_s14_q;
      less_3532_s15_q <= less_3532_s14_q;
      equal_3737_s15_q <= equal_3737_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [15:0] patches_chance_q;
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
  // hls/stages/agreement.hpp:785
  logic equal_1414;
  assign equal_1414 = select_1411_s15_q == 3'h1;
  logic equal_1415;
  assign equal_1415 = select_1411_s15_q == 3'h2;
  logic not_1416;
  assign not_1416 = ~equal_1415;
  logic [2:0] select_1417;
  assign select_1417 = equal_1414 ? 3'h2 : {not_1416, {2{equal_1415}}};
  logic [7:0] select_1422;
  assign select_1422 = select_1417[1] ? (select_1417[0] ? before_1_s15_q : before_1_q) : (select_1417[0] ? before_1_q : before_0_q);
  logic [7:0] select_1423;
  assign select_1423 = select_1417[2] ? (select_1417[0] ? before_2_s15_q : before_0_s15_q) : select_1422;
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1425;
  assign select_1425 = equal_1414 ? 2'h0 : {not_1416, equal_1415};
  logic [7:0] select_1427;
  assign select_1427 = select_1425[1] ? before_2_q : (select_1425[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:797
  logic or_1459;
  assign or_1459 = select_1457_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:235
  logic and_1496;
  assign and_1496 = not_526_s15_q & and_1495_s15_q;
  // hls/stages/agreement.hpp:141
  logic [14:0] shift_2;
  assign shift_2 = or_518_s15_q ? {select_1497_s15_q, and_1496, and_1490_s15_q, and_1480_s15_q, and_1477_s15_q, and_1473_s15_q, not_526_s15_q} : 15'h0;
  // hls/stages/patches.hpp:75
  logic right_3;
  assign right_3 = {2'h0, last_s15_q[6:1]} < x_s15_q;
  // hls/stages/registration.hpp:210
  logic [9:0] select_1643;
  assign select_1643 = shift_2[10] ? select_1642_s15_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:208
  logic [12:0] sum_1648;
  assign sum_1648 = (shift_2[6] ? select_1642_s15_q[13:1] : 13'h0) + (shift_2[7] ? select_1642_s15_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:209
  logic [11:0] select_1649;
  assign select_1649 = shift_2[8] ? select_1642_s15_q[11:0] : 12'h0;
  logic [10:0] sum_1651;
  assign sum_1651 = select_1649[11:1] + (shift_2[9] ? select_1642_s15_q[10:0] : 11'h0);
  // hls/stages/patches.hpp:148
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1676_s15_q ? select_1753_s15_q : patches_left_rdata_s15_q;
  // hls/stages/patches.hpp:410
  logic [9:0] sum_1772;
  assign sum_1772 = {2'h0, patches_columns_above_rdata_s15_q[15:8]} + {1'b0, sum_1771_s15_q};
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2439;
  assign select_2439 = or_518_s15_q ? (less_525_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2441_s15_q} - {1'b0, select_2443_s15_q};
  // hls/stages/patches.hpp:68
  logic parity_2700;
  assign parity_2700 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2701;
  assign select_2701 = equal_2237_s15_q ? {patches_chance_q[14:0], parity_2700} : patches_chance_q;
  // hls/stages/patches.hpp:80
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:81
  logic [5:0] further;
  assign further = last_s15_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:480
  logic [9:0] select_3225;
  assign select_3225 = less_1804_s15_q ? (equal_1805_s15_q ? 10'h0 : select_3223_s15_q) : select_3223_s15_q;
  logic [4:0] select_3232;
  assign select_3232 = less_1804_s15_q ? (equal_1805_s15_q ? 5'h0 : select_3230_s15_q) : select_3230_s15_q;
  // hls/stages/patches.hpp:476
  logic and_3242;
  assign and_3242 = less_1804_s15_q & (patches_step_s15_q == 5'h0);
  // hls/stages/patches.hpp:480
  logic select_3245;
  assign select_3245 = equal_1807_s15_q ? (less_1804_s15_q ? (not_1808_s15_q & and_3242) : and_3242) : and_3242;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_chance_q <= 16'h1;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
    end else if (s15_en) begin
      patches_chance_q <= and_497_s15_q ? select_2701 : patches_chance_q;
      patches_read_row_differing_q <= equal_1672_s15_q ? select_3225 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1672_s15_q ? select_3232 : patches_read_row_column_q;
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
  logic [9:0] patches_read_row_differing_s16_q;
  logic [4:0] patches_read_row_column_s16_q;
  logic patches_read_searches_s16_q;
  logic [3:0] select_458_s16_q;
  logic equal_459_s16_q;
  logic [6:0] select_461_s16_q;
  logic [8:0] select_465_s16_q;
  logic and_471_s16_q;
  logic equal_477_s16_q;
  logic [6:0] column_s16_q;
  logic and_495_s16_q;
  logic and_497_s16_q;
  logic so_s16_q;
  logic equal_558_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1406_s16_q;
  logic [2:0] select_1411_s16_q;
  logic [7:0] select_1423_s16_q;
  logic [7:0] select_1427_s16_q;
  logic [6:0] select_1446_s16_q;
  logic [5:0] select_1447_s16_q;
  logic and_1448_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1459_s16_q;
  logic [6:0] select_1464_s16_q;
  logic [6:0] select_1465_s16_q;
  logic equal_1466_s16_q;
  logic [13:0] shift_2_s16_q;
  logic [6:0] select_1505_s16_q;
  logic and_1508_s16_q;
  logic and_1579_s16_q;
  logic and_1592_s16_q;
  logic right_3_s16_q;
  logic and_1607_s16_q;
  logic less_1609_s16_q;
  logic select_1643_s16_q;
  logic [8:0] difference_1645_s16_q;
  logic [11:0] sum_1648_s16_q;
  logic select_1649_s16_q;
  logic [10:0] sum_1651_s16_q;
  logic equal_1672_s16_q;
  logic not_1673_s16_q;
  logic equal_1674_s16_q;
  logic not_1675_s16_q;
  logic equal_1676_s16_q;
  logic or_1678_s16_q;
  logic [4:0] select_1699_s16_q;
  logic select_1705_s16_q;
  logic [3:0] select_1739_s16_q;
  logic and_1749_s16_q;
  logic [31:0] patches_columns_above_rdata_s16_q;
  logic [7:0] pixel_2_s16_q;
  logic [9:0] sum_1772_s16_q;
  logic less_1804_s16_q;
  logic equal_1805_s16_q;
  logic not_1806_s16_q;
  logic equal_1807_s16_q;
  logic not_1808_s16_q;
  logic [9:0] patches_rows_rdata_s16_q;
  logic sum_1835_s16_q;
  logic textured_s16_q;
  logic and_1967_s16_q;
  logic equal_2113_s16_q;
  logic equal_2237_s16_q;
  logic [7:0] select_2439_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2445_s16_q;
  logic [7:0] xor_2450_s16_q;
  logic less_2471_s16_q;
  logic [5:0] further_s16_q;
  logic or_2762_s16_q;
  logic not_2786_s16_q;
  logic select_3245_s16_q;
  logic equal_3257_s16_q;
  logic less_3532_s16_q;
  logic equal_3737_s16_q;
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
      patches_lower_s16_q <= patches_lower_s15_q;
      patches_second_s16_q <= patches_second_s15_q;
      patches_code_row_s16_q <= patches_code_row_s15_q;
      patches_column_s16_q <= patches_column_s15_q;
      patches_step_s16_q <= patches_step_s15_q;
      patches_read_row_differing_s16_q <= patches_read_row_differing_q;
      patches_read_row_column_s16_q <= patches_read_row_column_q;
      patches_read_searches_s16_q <= patches_read_searches_s15_q;
      select_458_s16_q <= select_458_s15_q;
      equal_459_s16_q <= equal_459_s15_q;
      select_461_s16_q <= select_461_s15_q;
      select_465_s16_q <= select_465_s15_q;
      and_471_s16_q <= and_471_s15_q;
      equal_477_s16_q <= equal_477_s15_q;
      column_s16_q <= column_s15_q;
      and_495_s16_q <= and_495_s15_q;
      and_497_s16_q <= and_497_s15_q;
      so_s16_q <= so_s15_q;
      equal_558_s16_q <= equal_558_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1406_s16_q <= select_646_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1411_s16_q <= select_1411_s15_q;
      select_1423_s16_q <= select_1423;
      select_1427_s16_q <= select_1427;
      select_1446_s16_q <= or_1445_s15_q ? of_near_s15_q : best_left_rdata_s15_q[39:33];
      select_1447_s16_q <= or_1445_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      and_1448_s16_q <= and_1448_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1459_s16_q <= or_1459;
      select_1464_s16_q <= or_1463_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1465_s16_q <= or_1463_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1466_s16_q <= equal_1466_s15_q;
      shift_2_s16_q <= {shift_2[14:3], shift_2[1:0]};
      select_1505_s16_q <= select_1505_s15_q;
      and_1508_s16_q <= equal_517_s15_q & shift_2[4];
      and_1579_s16_q <= and_1579_s15_q;
      and_1592_s16_q <= and_1592_s15_q;
      right_3_s16_q <= right_3;
      and_1607_s16_q <= shift_2[4] & less_1606_s15_q;
      less_1609_s16_q <= {3'h0, last_s15_q[6:1]} < ({1'b0, x_s15_q} + 9'h1);
      select_1643_s16_q <= select_1643[0];
      difference_1645_s16_q <= select_1643[9:1] - (shift_2[11] ? select_1642_s15_q[8:0] : 9'h0);
      sum_1648_s16_q <= sum_1648[12:1];
      select_1649_s16_q <= select_1649[0];
      sum_1651_s16_q <= sum_1651;
      equal_1672_s16_q <= equal_1672_s15_q;
      not_1673_s16_q <= not_1673_s15_q;
      equal_1674_s16_q <= equal_1674_s15_q;
      not_1675_s16_q <= not_1675_s15_q;
      equal_1676_s16_q <= equal_1676_s15_q;
      or_1678_s16_q <= or_1678_s15_q;
      select_1699_s16_q <= select_1699_s15_q;
      select_1705_s16_q <= select_1705_s15_q;
      select_1739_s16_q <= select_1739_s15_q;
      and_1749_s16_q <= and_1749_s15_q;
      patches_columns_above_rdata_s16_q <= patches_columns_above_rdata_s15_q;
      pixel_2_s16_q <= pixel_2;
      sum_1772_s16_q <= sum_1772;
      less_1804_s16_q <= less_1804_s15_q;
      equal_1805_s16_q <= equal_1805_s15_q;
      not_1806_s16_q <= not_1806_s15_q;
      equal_1807_s16_q <= equal_1807_s15_q;
      not_1808_s16_q <= not_1808_s15_q;
      patches_rows_rdata_s16_q <= patches_rows_rdata_s15_q;
      sum_1835_s16_q <= sum_1835_s15_q;
      textured_s16_q <= textured;
      and_1967_s16_q <= and_1967_s15_q;
      equal_2113_s16_q <= equal_2113_s15_q;
      equal_2237_s16_q <= equal_2237_s15_q;
      select_2439_s16_q <= select_2439;
      rise_s16_q <= rise[8];
      select_2445_s16_q <= rise[8] ? select_2441_s15_q : select_2443_s15_q;
      xor_2450_s16_q <= rise[7:0] ^ {8{rise[8]}};
      less_2471_s16_q <= select_2441_s15_q < select_2443_s15_q;
      further_s16_q <= further;
      or_2762_s16_q <= or_2762_s15_q;
      not_2786_s16_q <= not_2786_s15_q;
      select_3245_s16_q <= select_3245;
      equal_3257_s16_q <= equal_3257_s15_q;
      less_3532_s16_q <= less_3532_s15_q;
      equal_3737_s16_q <= equal_3737_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic [4:0] patches_band_q;
  logic [1:0] patches_fetch_q;
  logic patches_read_first_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  // hls/stages/census.hpp:119
  logic and_472;
  assign and_472 = sample_pair_whole_s16_q & and_471_s16_q;
  // hls/stages/agreement.hpp:955
  logic not_1467;
  assign not_1467 = ~equal_1466_s16_q;
  // hls/stages/patches.hpp:303
  logic and_1499;
  assign and_1499 = ends_cell_s16_q & shift_2_s16_q[0];
  logic and_1501;
  assign and_1501 = not_1467 & (so_s16_q & and_1499);
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_1551;
  assign sum_1551 = {1'b0, last_s16_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s16_q[0] & ({1'b0, sum_1551, last_s16_q[1]} < x_s16_q);
  // hls/stages/patches.hpp:327
  logic [1:0] select_1593;
  assign select_1593 = and_1592_s16_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1594;
  assign select_1594 = and_1592_s16_q ? patches_band_rows_number_s16_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1595;
  assign select_1595 = and_1579_s16_q ? {select_1594, select_1593[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:98
  logic [1:0] select_1596;
  assign select_1596 = and_1579_s16_q ? select_1593 : patches_fetch_q;
  logic equal_1597;
  assign equal_1597 = select_1596 == 2'h0;
  // hls/stages/patches.hpp:303
  logic and_1604;
  assign and_1604 = so_s16_q & (ends_cell_s16_q & (shift_2_s16_q[0] & right_3_s16_q));
  logic and_1605;
  assign and_1605 = not_1467 & and_1604;
  // hls/stages/patches.hpp:74
  logic [9:0] sum_1618;
  assign sum_1618 = {2'h0, x_s16_q} + {{4{shift_2_s16_q[10]}}, shift_2_s16_q[10:5]};
  // hls/stages/registration.hpp:211
  logic [11:0] sum_1652;
  assign sum_1652 = sum_1648_s16_q + {sum_1651_s16_q, select_1649_s16_q};
  logic [9:0] sum_1653;
  assign sum_1653 = {difference_1645_s16_q, select_1643_s16_q} + sum_1652[11:2];
  // hls/stages/patches.hpp:98
  logic [4:0] select_1685;
  assign select_1685 = and_1579_s16_q ? select_1594 : patches_band_q;
  // hls/stages/patches.hpp:100
  logic equal_1686;
  assign equal_1686 = {patches_choosing_band_s16_q, and_1605} == {select_1685, select_1596[1]};
  // hls/stages/patches.hpp:412
  logic [8:0] sum_1761;
  assign sum_1761 = {1'b0, patches_columns_above_rdata_s16_q[7:0]} + {2'h0, pixel_2_s16_q[7:1]};
  logic [8:0] sum_1762;
  assign sum_1762 = {1'b0, patches_columns_above_rdata_s16_q[23:16]} + {2'h0, patches_columns_above_rdata_s16_q[31:25]};
  // hls/stages/patches.hpp:410
  logic [10:0] sum_1773;
  assign sum_1773 = {3'h0, patches_columns_above_rdata_s16_q[15:8]} + {sum_1772_s16_q, patches_columns_above_rdata_s16_q[25]};
  // hls/stages/patches.hpp:148
  logic and_1785;
  assign and_1785 = (~(patches_code_row_s16_q[4:2] == 3'h0)) & (~(patches_column_s16_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:160
  logic and_1789;
  assign and_1789 = or_1678_s16_q & ((equal_1676_s16_q & and_1785) & (patches_column_s16_q == 5'h1f));
  // hls/stages/patches.hpp:425
  logic or_1795;
  assign or_1795 = equal_1676_s16_q | (~and_1785);
  // hls/stages/patches.hpp:429
  logic and_1800;
  assign and_1800 = (~or_1795) & ((~patches_column_s16_q[4]) & (patches_column_s16_q == 5'hf));
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2446;
  assign difference_2446 = {1'b0, select_2439_s16_q} - {1'b0, select_2445_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2446[8] ? 8'h0 : difference_2446[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2450_s16_q};
  // hls/stages/patches.hpp:82
  logic [5:0] select_2706;
  assign select_2706 = right_3_s16_q ? last_s16_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s16_q} + {1'b0, select_2706};
  // hls/stages/patches.hpp:101
  logic not_2729;
  assign not_2729 = ~select_1596[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2731;
  assign select_2731 = sample_pair_whole_s16_q ? (equal_1597 ? select_1596 : {not_2729, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:476
  logic [4:0] select_3234;
  assign select_3234 = less_1804_s16_q ? patches_step_s16_q : 5'h0;
  // hls/stages/patches.hpp:480
  logic [4:0] select_3237;
  assign select_3237 = equal_1807_s16_q ? (less_1804_s16_q ? (equal_1807_s16_q ? 5'h0 : select_3234) : 5'h0) : select_3234;
  logic [4:0] select_3239;
  assign select_3239 = less_1804_s16_q ? (equal_1805_s16_q ? 5'h0 : select_3237) : select_3237;
  logic select_3247;
  assign select_3247 = less_1804_s16_q ? (not_1806_s16_q & select_3245_s16_q) : select_3245_s16_q;
  // hls/stages/patches.hpp:154
  logic or_3259;
  assign or_3259 = patches_read_first_q | (patches_read_row_differing_s16_q < patches_peak_best_differing_q);
  logic and_3260;
  assign and_3260 = patches_read_searches_s16_q & or_3259;
  // hls/stages/patches.hpp:459
  logic [14:0] select_3292;
  assign select_3292 = and_3260 ? {patches_read_row_column_s16_q, patches_read_row_differing_s16_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:160
  logic [9:0] select_3293;
  assign select_3293 = equal_1672_s16_q ? select_3292[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3294;
  assign select_3294 = equal_1672_s16_q ? select_3292[14:10] : patches_peak_best_column_q;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_465_s16_q;
  logic averager_memory_re;
  assign averager_memory_re = s16_en & and_472;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1297; read in stage 16, written in stage 17: 16 < 17 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s16_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s16_en & and_1501;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1324; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s16_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s16_en & and_1501;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s16_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s16_en & and_1749_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_s16_q[23:0], pixel_2_s16_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_columns_above_raddr_s13_sim;
  logic patches_columns_above_re_s13_sim;
  logic [4:0] patches_columns_above_raddr_s14_sim;
  logic patches_columns_above_re_s14_sim;
  logic [4:0] patches_columns_above_raddr_s15_sim;
  logic patches_columns_above_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_columns_above_re_s13_sim <= 1'b0;
      patches_columns_above_re_s14_sim <= 1'b0;
      patches_columns_above_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      patches_columns_above_re_s13_sim <= patches_columns_above_re;
      patches_columns_above_raddr_s13_sim <= patches_columns_above_raddr;
      patches_columns_above_re_s14_sim <= patches_columns_above_re_s13_sim;
      patches_columns_above_raddr_s14_sim <= patches_columns_above_raddr_s13_sim;
      patches_columns_above_re_s15_sim <= patches_columns_above_re_s14_sim;
      patches_columns_above_raddr_s15_sim <= patches_columns_above_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s13_sim && patches_columns_above_raddr_s13_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s14_sim && patches_columns_above_raddr_s14_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s15_sim && patches_columns_above_raddr_s15_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_band_q <= 5'h0;
      patches_fetch_q <= 2'h0;
      patches_read_first_q <= 1'b0;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
    end else if (s16_en) begin
      patches_band_q <= sample_pair_whole_s16_q ? select_1685 : patches_band_q;
      patches_fetch_q <= select_2731;
      patches_read_first_q <= equal_1672_s16_q ? select_3247 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3293;
      patches_peak_best_column_q <= select_3294;
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
  logic patches_chooses_s17_q;
  logic [4:0] patches_choosing_band_s17_q;
  logic patches_lower_s17_q;
  logic patches_second_s17_q;
  logic [4:0] patches_code_row_s17_q;
  logic patches_column_s17_q;
  logic [4:0] patches_step_s17_q;
  logic [9:0] patches_read_row_differing_s17_q;
  logic patches_read_first_s17_q;
  logic [3:0] select_458_s17_q;
  logic equal_459_s17_q;
  logic [6:0] select_461_s17_q;
  logic [8:0] select_465_s17_q;
  logic and_471_s17_q;
  logic and_472_s17_q;
  logic equal_477_s17_q;
  logic [6:0] column_s17_q;
  logic and_495_s17_q;
  logic and_497_s17_q;
  logic so_s17_q;
  logic equal_558_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1407_s17_q;
  logic [2:0] select_1412_s17_q;
  logic [7:0] select_1413_s17_q;
  logic [7:0] select_1424_s17_q;
  logic [7:0] select_1428_s17_q;
  logic [6:0] select_1446_s17_q;
  logic [5:0] select_1447_s17_q;
  logic and_1448_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1460_s17_q;
  logic [6:0] select_1461_s17_q;
  logic [6:0] select_1464_s17_q;
  logic [6:0] select_1465_s17_q;
  logic equal_1466_s17_q;
  logic not_1467_s17_q;
  logic [13:0] shift_2_s17_q;
  logic and_1501_s17_q;
  logic [6:0] select_1505_s17_q;
  logic and_1510_s17_q;
  logic right_2_s17_q;
  logic and_1579_s17_q;
  logic [5:0] select_1595_s17_q;
  logic select_1596_s17_q;
  logic equal_1597_s17_q;
  logic and_1605_s17_q;
  logic and_1607_s17_q;
  logic and_1611_s17_q;
  logic not_1614_s17_q;
  logic less_1619_s17_q;
  logic less_1620_s17_q;
  logic [7:0] sum_1653_s17_q;
  logic equal_1665_s17_q;
  logic equal_1672_s17_q;
  logic not_1673_s17_q;
  logic equal_1674_s17_q;
  logic equal_1676_s17_q;
  logic or_1678_s17_q;
  logic equal_1686_s17_q;
  logic [4:0] select_1699_s17_q;
  logic select_1705_s17_q;
  logic [3:0] select_1739_s17_q;
  logic [8:0] patches_columns_above_rdata_s17_q;
  logic [7:0] pixel_2_s17_q;
  logic [8:0] sum_1761_s17_q;
  logic [8:0] sum_1762_s17_q;
  logic [10:0] sum_1773_s17_q;
  logic and_1790_s17_q;
  logic or_1795_s17_q;
  logic and_1802_s17_q;
  logic less_1804_s17_q;
  logic equal_1805_s17_q;
  logic not_1806_s17_q;
  logic equal_1807_s17_q;
  logic not_1808_s17_q;
  logic [9:0] patches_rows_rdata_s17_q;
  logic sum_1835_s17_q;
  logic textured_s17_q;
  logic and_1970_s17_q;
  logic equal_2113_s17_q;
  logic equal_2237_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] size_3_s17_q;
  logic less_2471_s17_q;
  logic not_2709_s17_q;
  logic or_2762_s17_q;
  logic not_2786_s17_q;
  logic [4:0] select_3239_s17_q;
  logic equal_3257_s17_q;
  logic and_3260_s17_q;
  logic [14:0] select_3292_s17_q;
  logic less_3532_s17_q;
  logic equal_3737_s17_q;
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
      patches_chooses_s17_q <= patches_chooses_s16_q;
      patches_choosing_band_s17_q <= patches_choosing_band_s16_q;
      patches_lower_s17_q <= patches_lower_s16_q;
      patches_second_s17_q <= patches_second_s16_q;
      patches_code_row_s17_q <= patches_code_row_s16_q;
      patches_column_s17_q <= patches_column_s16_q[4];
      patches_step_s17_q <= patches_step_s16_q;
      patches_read_row_differing_s17_q <= patches_read_row_differing_s16_q;
      patches_read_first_s17_q <= patches_read_first_q;
      select_458_s17_q <= select_458_s16_q;
      equal_459_s17_q <= equal_459_s16_q;
      select_461_s17_q <= select_461_s16_q;
      select_465_s17_q <= select_465_s16_q;
      and_471_s17_q <= and_471_s16_q;
      and_472_s17_q <= and_472;
      equal_477_s17_q <= equal_477_s16_q;
      column_s17_q <= column_s16_q;
      and_495_s17_q <= and_495_s16_q;
      and_497_s17_q <= and_497_s16_q;
      so_s17_q <= so_s16_q;
      equal_558_s17_q <= equal_558_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1407_s17_q <= or_1406_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1412_s17_q <= or_1406_s16_q ? select_1411_s16_q : best_left_rdata_s16_q[8:6];
      select_1413_s17_q <= or_1406_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1424_s17_q <= or_1406_s16_q ? select_1423_s16_q : best_left_rdata_s16_q[24:17];
      select_1428_s17_q <= or_1406_s16_q ? select_1427_s16_q : best_left_rdata_s16_q[32:25];
      select_1446_s17_q <= select_1446_s16_q;
      select_1447_s17_q <= select_1447_s16_q;
      and_1448_s17_q <= and_1448_s16_q;
      right_s17_q <= right_s16_q;
      select_1460_s17_q <= or_1459_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1461_s17_q <= or_1459_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1464_s17_q <= select_1464_s16_q;
      select_1465_s17_q <= select_1465_s16_q;
      equal_1466_s17_q <= equal_1466_s16_q;
      not_1467_s17_q <= not_1467;
      shift_2_s17_q <= shift_2_s16_q;
      and_1501_s17_q <= and_1501;
      select_1505_s17_q <= select_1505_s16_q;
      and_1510_s17_q <= not_1467 & (so_s16_q ? and_1499 : and_1508_s16_q);
      right_2_s17_q <= right_2;
      and_1579_s17_q <= and_1579_s16_q;
      select_1595_s17_q <= select_1595;
      select_1596_s17_q <= select_1596[1];
      equal_1597_s17_q <= equal_1597;
      and_1605_s17_q <= and_1605;
      and_1607_s17_q <= and_1607_s16_q;
      and_1611_s17_q <= less_1609_s16_q & (~right_3_s16_q);
      not_1614_s17_q <= ~(x_s16_q < {1'b0, last_s16_q});
      less_1619_s17_q <= $signed(10'h0) < $signed(sum_1618);
      less_1620_s17_q <= $signed(sum_1618) < $signed({3'h0, last_s16_q});
      sum_1653_s17_q <= sum_1653[9:2];
      equal_1665_s17_q <= x_s16_q == {1'b0, last_s16_q};
      equal_1672_s17_q <= equal_1672_s16_q;
      not_1673_s17_q <= not_1673_s16_q;
      equal_1674_s17_q <= equal_1674_s16_q;
      equal_1676_s17_q <= equal_1676_s16_q;
      or_1678_s17_q <= or_1678_s16_q;
      equal_1686_s17_q <= equal_1686;
      select_1699_s17_q <= select_1699_s16_q;
      select_1705_s17_q <= select_1705_s16_q;
      select_1739_s17_q <= select_1739_s16_q;
      patches_columns_above_rdata_s17_q <= {patches_columns_above_rdata_s16_q[24], patches_columns_above_rdata_s16_q[7:0]};
      pixel_2_s17_q <= pixel_2_s16_q;
      sum_1761_s17_q <= sum_1761;
      sum_1762_s17_q <= sum_1762;
      sum_1773_s17_q <= sum_1773;
      and_1790_s17_q <= not_1675_s16_q & and_1789;
      or_1795_s17_q <= or_1795;
      and_1802_s17_q <= not_1675_s16_q & (or_1678_s16_q & and_1800);
      less_1804_s17_q <= less_1804_s16_q;
      equal_1805_s17_q <= equal_1805_s16_q;
      not_1806_s17_q <= not_1806_s16_q;
      equal_1807_s17_q <= equal_1807_s16_q;
      not_1808_s17_q <= not_1808_s16_q;
      patches_rows_rdata_s17_q <= patches_rows_rdata_s16_q;
      sum_1835_s17_q <= sum_1835_s16_q;
      textured_s17_q <= textured_s16_q;
      and_1970_s17_q <= and_1967_s16_q & (~({sum_1551, last_s16_q[1:0]} < x_s16_q));
      equal_2113_s17_q <= equal_2113_s16_q;
      equal_2237_s17_q <= equal_2237_s16_q;
      wide_s17_q <= wide;
      size_3_s17_q <= size_3;
      less_2471_s17_q <= less_2471_s16_q;
      not_2709_s17_q <= ~(x_s16_q < {1'b0, from});
      or_2762_s17_q <= or_2762_s16_q;
      not_2786_s17_q <= not_2786_s16_q;
      select_3239_s17_q <= select_3239;
      equal_3257_s17_q <= equal_3257_s16_q;
      and_3260_s17_q <= and_3260;
      select_3292_s17_q <= select_3292;
      less_3532_s17_q <= less_3532_s16_q;
      equal_3737_s17_q <= equal_3737_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic [4:0] patches_read_at_q;
  logic [4:0] patches_peak_row_q;
  // hls/stages/census.hpp:112
  logic [13:0] select_475;
  assign select_475 = equal_459_s17_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_481;
  assign sum_481 = {6'h0, sample_pair_pixel_1_q} + (equal_459_s17_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:193
  logic not_1506;
  assign not_1506 = ~so_s17_q;
  // hls/stages/patches.hpp:303
  logic and_1507;
  assign and_1507 = not_1506 & shift_2_s17_q[4];
  // hls/stages/patches.hpp:77
  logic equal_1612;
  assign equal_1612 = x_s17_q == 8'h0;
  // hls/stages/agreement.hpp:963
  logic and_1622;
  assign and_1622 = (~(and_1611_s17_q | (equal_1612 | not_1614_s17_q))) & (less_1619_s17_q & less_1620_s17_q);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1654;
  assign sum_1654 = {registration_slope_s17_q[11], registration_slope_s17_q} + {{5{sum_1653_s17_q[7]}}, sum_1653_s17_q};
  // hls/stages/patches.hpp:303
  logic and_1668;
  assign and_1668 = ends_cell_s17_q & (shift_2_s17_q[0] & (and_1611_s17_q | equal_1665_s17_q));
  logic and_1670;
  assign and_1670 = not_1467_s17_q & (so_s17_q & and_1668);
  // hls/stages/patches.hpp:307
  logic and_1671;
  assign and_1671 = patches_chooses_s17_q & and_1670;
  // hls/stages/patches.hpp:412
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1761_s17_q, pixel_2_s17_q[0]} - {1'b0, sum_1762_s17_q, patches_columns_above_rdata_s17_q[8]};
  // hls/stages/patches.hpp:410
  logic [9:0] sum_1774;
  assign sum_1774 = {2'h0, patches_columns_above_rdata_s17_q[7:0]} + sum_1773_s17_q[10:1];
  // hls/stages/agreement.hpp:999
  logic or_1837;
  assign or_1837 = (~sum_1835_s17_q) | equal_1665_s17_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2453;
  assign select_2453 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2453;
  // hls/stages/patches.hpp:303
  logic and_2712;
  assign and_2712 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & not_2709_s17_q));
  // hls/stages/patches.hpp:460
  logic [4:0] select_3261;
  assign select_3261 = and_3260_s17_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:467
  logic [5:0] away;
  assign away = {1'b0, patches_step_s17_q} - {1'b0, select_3261};

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:665; read in stage 17, written in stage 19: 17 < 19 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1595_s17_q;
  logic patches_choices_re;
  assign patches_choices_re = s17_en & (sample_pair_whole_s17_q & (~equal_1597_s17_q));
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1448_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1447_s17_q, select_1446_s17_q, select_1428_s17_q, select_1424_s17_q, select_1413_s17_q, select_1412_s17_q, select_1407_s17_q};
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
  assign best_right_we = s17_en & and_1448_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1465_s17_q, select_1464_s17_q, select_1461_s17_q, select_1460_s17_q};
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
  assign shown_right_waddr = select_1505_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1510_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1507, not_1506};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      patches_read_at_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
    end else if (s17_en) begin
      sample_pair_pixel_0_q <= pixel_0_s17_q;
      sample_pair_pixel_1_q <= pixel_1_s17_q;
      patches_read_at_q <= equal_1672_s17_q ? select_3239_s17_q : patches_read_at_q;
      patches_peak_row_q <= equal_1672_s17_q ? select_3261 : patches_peak_row_q;
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
    if (s17_en) begin
      averager_running_0_q <= sample_pair_whole_s17_q ? select_475 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s17_q ? sum_481 : averager_running_1_q;
    end
  end

  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic [7:0] sample_pair_pixel_0_s18_q;
  logic [7:0] sample_pair_pixel_1_s18_q;
  logic sample_pair_whole_s18_q;
  logic sample_present_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic [2:0] slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic [4:0] patches_choosing_band_s18_q;
  logic patches_lower_s18_q;
  logic patches_second_s18_q;
  logic [4:0] patches_code_row_s18_q;
  logic patches_column_s18_q;
  logic [9:0] patches_read_row_differing_s18_q;
  logic patches_read_first_s18_q;
  logic [3:0] select_458_s18_q;
  logic equal_459_s18_q;
  logic [6:0] select_461_s18_q;
  logic [8:0] select_465_s18_q;
  logic and_471_s18_q;
  logic and_472_s18_q;
  logic [29:0] averager_memory_rdata_s18_q;
  logic [13:0] select_475_s18_q;
  logic equal_477_s18_q;
  logic [13:0] sum_481_s18_q;
  logic [6:0] column_s18_q;
  logic and_495_s18_q;
  logic and_497_s18_q;
  logic so_s18_q;
  logic equal_558_s18_q;
  logic equal_1466_s18_q;
  logic not_1467_s18_q;
  logic [13:0] shift_2_s18_q;
  logic and_1501_s18_q;
  logic [1:0] shown_right_rdata_s18_q;
  logic not_1506_s18_q;
  logic right_2_s18_q;
  logic and_1579_s18_q;
  logic select_1596_s18_q;
  logic equal_1597_s18_q;
  logic and_1605_s18_q;
  logic and_1607_s18_q;
  logic equal_1612_s18_q;
  logic and_1624_s18_q;
  logic [7:0] sum_1654_s18_q;
  logic less_1655_s18_q;
  logic less_1656_s18_q;
  logic and_1670_s18_q;
  logic and_1671_s18_q;
  logic equal_1672_s18_q;
  logic not_1673_s18_q;
  logic equal_1674_s18_q;
  logic equal_1676_s18_q;
  logic or_1678_s18_q;
  logic and_1687_s18_q;
  logic [4:0] select_1699_s18_q;
  logic select_1705_s18_q;
  logic [3:0] select_1739_s18_q;
  logic patches_columns_above_rdata_s18_q;
  logic [7:0] pixel_2_s18_q;
  logic [10:0] down_2_s18_q;
  logic sum_1773_s18_q;
  logic [9:0] sum_1774_s18_q;
  logic and_1791_s18_q;
  logic or_1795_s18_q;
  logic and_1803_s18_q;
  logic less_1804_s18_q;
  logic equal_1805_s18_q;
  logic not_1806_s18_q;
  logic equal_1807_s18_q;
  logic not_1808_s18_q;
  logic [9:0] patches_rows_rdata_s18_q;
  logic sum_1835_s18_q;
  logic and_1840_s18_q;
  logic textured_s18_q;
  logic [17:0] seen_columns_rdata_s18_q;
  logic and_1973_s18_q;
  logic equal_2113_s18_q;
  logic equal_2237_s18_q;
  logic less_2437_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2455_s18_q;
  logic less_2471_s18_q;
  logic and_2713_s18_q;
  logic or_2762_s18_q;
  logic not_2786_s18_q;
  logic equal_3257_s18_q;
  logic [4:0] select_3261_s18_q;
  logic [5:0] away_s18_q;
  logic equal_3263_s18_q;
  logic equal_3272_s18_q;
  logic [14:0] select_3292_s18_q;
  logic less_3532_s18_q;
  logic select_3575_s18_q;
  logic equal_3737_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      sample_pair_pixel_0_s18_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s18_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      sample_present_s18_q <= sample_present_s17_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      slot_s18_q <= slot_s17_q;
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      patches_choosing_band_s18_q <= patches_choosing_band_s17_q;
      patches_lower_s18_q <= patches_lower_s17_q;
      patches_second_s18_q <= patches_second_s17_q;
      patches_code_row_s18_q <= patches_code_row_s17_q;
      patches_column_s18_q <= patches_column_s17_q;
      patches_read_row_differing_s18_q <= patches_read_row_differing_s17_q;
      patches_read_first_s18_q <= patches_read_first_s17_q;
      select_458_s18_q <= select_458_s17_q;
      equal_459_s18_q <= equal_459_s17_q;
      select_461_s18_q <= select_461_s17_q;
      select_465_s18_q <= select_465_s17_q;
      and_471_s18_q <= and_471_s17_q;
      and_472_s18_q <= and_472_s17_q;
      averager_memory_rdata_s18_q <= averager_memory_rdata_q;
      select_475_s18_q <= select_475;
      equal_477_s18_q <= equal_477_s17_q;
      sum_481_s18_q <= sum_481;
      column_s18_q <= column_s17_q;
      and_495_s18_q <= and_495_s17_q;
      and_497_s18_q <= and_497_s17_q;
      so_s18_q <= so_s17_q;
      equal_558_s18_q <= equal_558_s17_q;
      equal_1466_s18_q <= equal_1466_s17_q;
      not_1467_s18_q <= not_1467_s17_q;
      shift_2_s18_q <= shift_2_s17_q;
      and_1501_s18_q <= and_1501_s17_q;
      shown_right_rdata_s18_q <= shown_right_rdata_q;
      not_1506_s18_q <= not_1506;
      right_2_s18_q <= right_2_s17_q;
      and_1579_s18_q <= and_1579_s17_q;
      select_1596_s18_q <= select_1596_s17_q;
      equal_1597_s18_q <= equal_1597_s17_q;
      and_1605_s18_q <= and_1605_s17_q;
      and_1607_s18_q <= and_1607_s17_q;
      equal_1612_s18_q <= equal_1612;
      and_1624_s18_q <= shift_2_s17_q[0] & (and_1607_s17_q & and_1622);
      sum_1654_s18_q <= sum_1654[7:0];
      less_1655_s18_q <= $signed(6'h0) < $signed(sum_1654[12:7]);
      less_1656_s18_q <= $signed(sum_1654[12:7]) < $signed(6'h3f);
      and_1670_s18_q <= and_1670;
      and_1671_s18_q <= and_1671;
      equal_1672_s18_q <= equal_1672_s17_q;
      not_1673_s18_q <= not_1673_s17_q;
      equal_1674_s18_q <= equal_1674_s17_q;
      equal_1676_s18_q <= equal_1676_s17_q;
      or_1678_s18_q <= or_1678_s17_q;
      and_1687_s18_q <= and_1671 & equal_1686_s17_q;
      select_1699_s18_q <= select_1699_s17_q;
      select_1705_s18_q <= select_1705_s17_q;
      select_1739_s18_q <= select_1739_s17_q;
      patches_columns_above_rdata_s18_q <= patches_columns_above_rdata_s17_q[8];
      pixel_2_s18_q <= pixel_2_s17_q;
      down_2_s18_q <= down_2;
      sum_1773_s18_q <= sum_1773_s17_q[0];
      sum_1774_s18_q <= sum_1774;
      and_1791_s18_q <= not_1673_s17_q & and_1790_s17_q;
      or_1795_s18_q <= or_1795_s17_q;
      and_1803_s18_q <= not_1673_s17_q & and_1802_s17_q;
      less_1804_s18_q <= less_1804_s17_q;
      equal_1805_s18_q <= equal_1805_s17_q;
      not_1806_s18_q <= not_1806_s17_q;
      equal_1807_s18_q <= equal_1807_s17_q;
      not_1808_s18_q <= not_1808_s17_q;
      patches_rows_rdata_s18_q <= patches_rows_rdata_s17_q;
      sum_1835_s18_q <= sum_1835_s17_q;
      and_1840_s18_q <= so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & or_1837));
      textured_s18_q <= textured_s17_q;
      seen_columns_rdata_s18_q <= seen_columns_rdata_q;
      and_1973_s18_q <= not_1467_s17_q & (so_s17_q & (ends_cell_s17_q & and_1970_s17_q));
      equal_2113_s18_q <= equal_2113_s17_q;
      equal_2237_s18_q <= equal_2237_s17_q;
      less_2437_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2455_s18_q <= ~wide_s17_q;
      less_2471_s18_q <= less_2471_s17_q;
      and_2713_s18_q <= not_1467_s17_q & and_2712;
      or_2762_s18_q <= or_2762_s17_q;
      not_2786_s18_q <= not_2786_s17_q;
      equal_3257_s18_q <= equal_3257_s17_q;
      select_3261_s18_q <= select_3261;
      away_s18_q <= away;
      equal_3263_s18_q <= away == 6'h3f;
      equal_3272_s18_q <= away == 6'h1;
      select_3292_s18_q <= select_3292_s17_q;
      less_3532_s18_q <= less_3532_s17_q;
      select_3575_s18_q <= sum_1835_s17_q ? (equal_1665_s17_q & or_1837) : or_1837;
      equal_3737_s18_q <= equal_3737_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic sample_of_skin_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [7:0] registration_slope_here_q;
  logic patches_along_ends_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [4:0] patches_along_q;
  logic [4:0] patches_summed_row_column_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic segment_starts_q;
  // hls/stages/census.hpp:121
  logic [13:0] sum_479;
  assign sum_479 = select_475_s18_q + (equal_477_s18_q ? 14'h0 : averager_memory_rdata_s18_q[13:0]);
  logic [13:0] sum_483;
  assign sum_483 = sum_481_s18_q + (equal_477_s18_q ? 14'h0 : averager_memory_rdata_s18_q[27:14]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = equal_459_s18_q ? sample_present_s18_q : (sample_present_s18_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_459_s18_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:123
  logic and_491;
  assign and_491 = all_of_skin & (averager_memory_rdata_s18_q[29] | equal_477_s18_q);
  // hls/stages/patches.hpp:303
  logic [7:0] select_1632;
  assign select_1632 = so_s18_q ? (ends_cell_s18_q ? (shift_2_s18_q[0] ? x_s18_q : 8'h0) : 8'h0) : 8'h0;
  logic [5:0] select_1635;
  assign select_1635 = ends_cell_s18_q ? (shift_2_s18_q[0] ? shift_2_s18_q[10:5] : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:83
  logic equal_1638;
  assign equal_1638 = slot_s18_q == 3'h7;
  // hls/stages/registration.hpp:215
  logic [7:0] select_1658;
  assign select_1658 = less_1655_s18_q ? 8'h7f : (less_1656_s18_q ? 8'h80 : sum_1654_s18_q);
  // hls/stages/registration.hpp:106
  logic [7:0] slope;
  assign slope = equal_1638 ? registration_slope_here_q : select_1658;
  // hls/stages/patches.hpp:303
  logic [7:0] select_1662;
  assign select_1662 = so_s18_q ? (ends_cell_s18_q ? (shift_2_s18_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:435
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  // hls/stages/patches.hpp:414
  logic [11:0] sum_1764;
  assign sum_1764 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1765;
  assign sum_1765 = {{4{down_2_s18_q[10]}}, down_2_s18_q[10:2]} + {sum_1764[11], sum_1764};
  // hls/stages/patches.hpp:411
  logic [11:0] smooth;
  assign smooth = {sum_1774_s18_q, sum_1773_s18_q, patches_columns_above_rdata_s18_q} + {4'h0, pixel_2_s18_q};
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1822;
  assign select_1822 = so_s18_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:991
  logic or_1825;
  assign or_1825 = select_1822[7] | (~({select_1822[5], select_1822[3], select_1822[1]} == 3'h0));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s18_q[0] & shift_2_s18_q[3];
  logic and_1854;
  assign and_1854 = shift_2_s18_q[0] & ({shift_2_s18_q[4], shift_2_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:960
  logic select_1862;
  assign select_1862 = slot_s18_q[2] ? shown_shown_q : shift_2_s18_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1862);
  // hls/stages/agreement.hpp:960
  logic select_1865;
  assign select_1865 = slot_s18_q[2] ? shown_nearer_q : shift_2_s18_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s18_q[0] & (select_1862 ? select_1865 : shown_right_rdata_s18_q[1]);
  // hls/stages/agreement.hpp:975
  logic [7:0] select_1914;
  assign select_1914 = shift_2_s18_q[0] ? (sum_1835_s18_q ? select_1822 : {select_1822[6:0], 1'b0}) : select_1822;
  // hls/stages/agreement.hpp:991
  logic or_1917;
  assign or_1917 = select_1914[7] | (~({select_1914[5], select_1914[3], select_1914[1]} == 3'h0));
  // hls/stages/agreement.hpp:263
  logic select_2026;
  assign select_2026 = sample_pair_whole_s18_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:975
  logic and_2379;
  assign and_2379 = seen_columns_rdata_s18_q[7] & shift_2_s18_q[0];
  logic and_2380;
  assign and_2380 = seen_columns_rdata_s18_q[2] & shift_2_s18_q[0];
  // hls/stages/registration.hpp:37
  logic not_2448;
  assign not_2448 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2437_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2448};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2456;
  assign select_2456 = registration_displacement_over_q[9] ? wide_s18_q : not_2455_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2437_s18_q ? {taken_s18_q, 1'b1} : {not_2448, select_2456, not_2448};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2458;
  assign sum_2458 = {left, 1'b1} + {taken_2, less_2437_s18_q};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2460;
  assign select_2460 = so_s18_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/patches.hpp:303
  logic [7:0] select_2462;
  assign select_2462 = equal_1466_s18_q ? registration_slope_here_q : (so_s18_q ? slope : registration_slope_here_q);
  // hls/stages/registration.hpp:208
  logic [6:0] select_2475;
  assign select_2475 = shift_2_s18_q[5] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_2476;
  assign select_2476 = shift_2_s18_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2477;
  assign sum_2477 = {{2{select_2475[6]}}, select_2475} + {select_2476[7], select_2476};
  // hls/stages/registration.hpp:209
  logic [7:0] select_2478;
  assign select_2478 = shift_2_s18_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2479;
  assign select_2479 = shift_2_s18_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2480;
  assign sum_2480 = {{2{select_2478[7]}}, select_2478[7:1]} + {select_2479[7], select_2479};
  // hls/stages/registration.hpp:210
  logic [7:0] select_2482;
  assign select_2482 = shift_2_s18_q[9] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2483;
  assign select_2483 = shift_2_s18_q[10] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_2484;
  assign difference_2484 = {{2{select_2482[7]}}, select_2482[7:1]} - {select_2483[7], select_2483};
  // hls/stages/patches.hpp:160
  logic [10:0] select_2816;
  assign select_2816 = equal_1674_s18_q ? patches_down_values_0_q : (or_1678_s18_q ? down_2_s18_q : patches_down_values_0_q);
  logic [10:0] select_2818;
  assign select_2818 = or_1678_s18_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_2820;
  assign select_2820 = equal_1672_s18_q ? patches_down_values_1_q : (equal_1674_s18_q ? patches_down_values_1_q : select_2818);
  // hls/stages/patches.hpp:367
  logic [4:0] select_2859;
  assign select_2859 = or_2762_s18_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:160
  logic [4:0] select_3211;
  assign select_3211 = equal_1672_s18_q ? patches_summed_row_column_q : (equal_1674_s18_q ? patches_along_q : patches_summed_row_column_q);
  // hls/stages/patches.hpp:476
  logic and_3265;
  assign and_3265 = less_1804_s18_q & (equal_3257_s18_q & equal_3263_s18_q);
  // hls/stages/patches.hpp:480
  logic select_3268;
  assign select_3268 = equal_1807_s18_q ? (less_1804_s18_q ? (not_1808_s18_q & and_3265) : and_3265) : and_3265;
  // hls/stages/patches.hpp:476
  logic and_3274;
  assign and_3274 = less_1804_s18_q & (equal_3257_s18_q & equal_3272_s18_q);
  // hls/stages/patches.hpp:480
  logic select_3277;
  assign select_3277 = equal_1807_s18_q ? (less_1804_s18_q ? (not_1808_s18_q & and_3274) : and_3274) : and_3274;
  // hls/stages/patches.hpp:473
  logic [6:0] sum_3281;
  assign sum_3281 = {away_s18_q[5], away_s18_q} + 7'h7d;
  // hls/stages/patches.hpp:303
  logic select_3529;
  assign select_3529 = equal_1466_s18_q ? shown_shown_q : (so_s18_q ? select_1862 : shown_shown_q);
  logic select_3531;
  assign select_3531 = equal_1466_s18_q ? shown_nearer_q : (so_s18_q ? select_1865 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3533;
  assign sum_3533 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/patches.hpp:303
  logic [7:0] select_3542;
  assign select_3542 = equal_1466_s18_q ? select_1822 : (so_s18_q ? (ends_cell_s18_q ? select_1914 : select_1822) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3556;
  assign select_3556 = equal_558_s18_q ? {difference_3554[7], difference_3554} : (less_3532_s18_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3558;
  assign select_3558 = and_497_s18_q ? (equal_2237_s18_q ? select_3556 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3560;
  assign select_3560 = equal_558_s18_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_3562;
  assign select_3562 = and_497_s18_q ? (equal_2237_s18_q ? select_3560 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3564;
  assign select_3564 = sum_3533[7] ? {1'b1, sum_3533[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});
  // hls/stages/agreement.hpp:197
  logic or_3573;
  assign or_3573 = segment_starts_q | not_1506_s18_q;
  // hls/stages/patches.hpp:303
  logic select_3577;
  assign select_3577 = ends_cell_s18_q ? (shift_2_s18_q[0] ? select_3575_s18_q : or_3573) : or_3573;

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 18, written in stage 20: 18 < 20 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s18_q;
  logic census_memory_re;
  assign census_memory_re = s18_en & and_497_s18_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_of_skin_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      patches_along_ends_q <= 1'b0;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      patches_along_q <= 5'h0;
      patches_summed_row_column_q <= 5'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
      segment_starts_q <= 1'b1;
    end else if (s18_en) begin
      sample_of_skin_q <= mask_s18_q;
      averager_running_mask_q <= sample_pair_whole_s18_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2026;
      registration_displacement_over_q <= so_s18_q ? sum_2458[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2460;
      registration_slope_here_q <= select_2462;
      patches_along_ends_q <= not_2786_s18_q & (patches_along_q == 5'hf);
      patches_down_values_0_q <= equal_1672_s18_q ? patches_down_values_0_q : select_2816;
      patches_down_values_1_q <= select_2820;
      patches_along_q <= select_2859;
      patches_summed_row_column_q <= select_3211;
      shown_shown_q <= select_3529;
      shown_nearer_q <= select_3531;
      region_columns_q <= select_3542;
      region_down_rest_q <= select_3558;
      region_down_back_q <= select_3562;
      region_down_next_q <= select_3564;
      segment_starts_q <= equal_1466_s18_q ? or_3573 : (so_s18_q ? select_3577 : or_3573);
    end
  end

  logic [7:0] pixel_0_s19_q;
  logic [7:0] pixel_1_s19_q;
  logic saturated_s19_q;
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
  logic [4:0] patches_choosing_band_s19_q;
  logic patches_lower_s19_q;
  logic patches_second_s19_q;
  logic [4:0] patches_code_row_s19_q;
  logic patches_column_s19_q;
  logic patches_along_ends_s19_q;
  logic [10:0] patches_down_values_1_s19_q;
  logic [4:0] patches_summed_row_column_s19_q;
  logic [9:0] patches_read_row_differing_s19_q;
  logic patches_read_first_s19_q;
  logic [3:0] select_458_s19_q;
  logic [6:0] select_461_s19_q;
  logic [8:0] select_465_s19_q;
  logic and_471_s19_q;
  logic and_472_s19_q;
  logic [13:0] sum_479_s19_q;
  logic [13:0] sum_483_s19_q;
  logic and_487_s19_q;
  logic and_491_s19_q;
  logic [6:0] column_s19_q;
  logic and_495_s19_q;
  logic and_497_s19_q;
  logic equal_500_s19_q;
  logic so_s19_q;
  logic equal_558_s19_q;
  logic equal_1466_s19_q;
  logic not_1467_s19_q;
  logic [3:0] shift_2_s19_q;
  logic and_1501_s19_q;
  logic equal_1511_s19_q;
  logic right_2_s19_q;
  logic and_1579_s19_q;
  logic select_1596_s19_q;
  logic equal_1597_s19_q;
  logic [22:0] patches_choices_rdata_s19_q;
  logic and_1605_s19_q;
  logic and_1607_s19_q;
  logic equal_1612_s19_q;
  logic and_1627_s19_q;
  logic [7:0] select_1633_s19_q;
  logic [5:0] select_1637_s19_q;
  logic equal_1638_s19_q;
  logic [7:0] select_1663_s19_q;
  logic and_1670_s19_q;
  logic and_1671_s19_q;
  logic equal_1672_s19_q;
  logic not_1673_s19_q;
  logic equal_1674_s19_q;
  logic equal_1676_s19_q;
  logic or_1678_s19_q;
  logic and_1687_s19_q;
  logic [4:0] select_1699_s19_q;
  logic select_1705_s19_q;
  logic [3:0] select_1739_s19_q;
  logic new_row_s19_q;
  logic [1:0] down_2_s19_q;
  logic [12:0] sum_1765_s19_q;
  logic [11:0] smooth_s19_q;
  logic and_1791_s19_q;
  logic or_1795_s19_q;
  logic and_1803_s19_q;
  logic less_1804_s19_q;
  logic equal_1805_s19_q;
  logic not_1806_s19_q;
  logic equal_1807_s19_q;
  logic [9:0] patches_rows_rdata_s19_q;
  logic or_1825_s19_q;
  logic or_1828_s19_q;
  logic or_1831_s19_q;
  logic and_1840_s19_q;
  logic textured_s19_q;
  logic explained_s19_q;
  logic and_1854_s19_q;
  logic [12:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_1900_s19_q;
  logic and_1902_s19_q;
  logic or_1917_s19_q;
  logic or_1920_s19_q;
  logic or_1923_s19_q;
  logic and_1934_s19_q;
  logic and_1936_s19_q;
  logic and_1937_s19_q;
  logic and_1950_s19_q;
  logic and_1952_s19_q;
  logic and_1953_s19_q;
  logic and_1973_s19_q;
  logic equal_2113_s19_q;
  logic equal_2237_s19_q;
  logic and_2377_s19_q;
  logic and_2378_s19_q;
  logic [1:0] sum_2382_s19_q;
  logic or_2469_s19_q;
  logic [1:0] sum_2470_s19_q;
  logic less_2471_s19_q;
  logic [7:0] sum_2477_s19_q;
  logic select_2478_s19_q;
  logic [8:0] sum_2480_s19_q;
  logic select_2482_s19_q;
  logic [8:0] difference_2484_s19_q;
  logic and_2713_s19_q;
  logic or_2762_s19_q;
  logic not_2786_s19_q;
  logic [4:0] select_3261_s19_q;
  logic select_3268_s19_q;
  logic select_3277_s19_q;
  logic and_3283_s19_q;
  logic [14:0] select_3292_s19_q;
  logic less_3532_s19_q;
  logic sum_3533_s19_q;
  logic and_3727_s19_q;
  logic equal_3737_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      pixel_0_s19_q <= sample_pair_pixel_0_q;
      pixel_1_s19_q <= sample_pair_pixel_1_q;
      saturated_s19_q <= saturated_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
      sample_pair_pixel_0_s19_q <= sample_pair_pixel_0_s18_q;
      sample_pair_pixel_1_s19_q <= sample_pair_pixel_1_s18_q;
      sample_pair_whole_s19_q <= sample_pair_whole_s18_q;
      sample_present_s19_q <= sample_present_s18_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      slot_s19_q <= slot_s18_q;
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      patches_choosing_band_s19_q <= patches_choosing_band_s18_q;
      patches_lower_s19_q <= patches_lower_s18_q;
      patches_second_s19_q <= patches_second_s18_q;
      patches_code_row_s19_q <= patches_code_row_s18_q;
      patches_column_s19_q <= patches_column_s18_q;
      patches_along_ends_s19_q <= patches_along_ends_q;
      patches_down_values_1_s19_q <= patches_down_values_1_q;
      patches_summed_row_column_s19_q <= patches_summed_row_column_q;
      patches_read_row_differing_s19_q <= patches_read_row_differing_s18_q;
      patches_read_first_s19_q <= patches_read_first_s18_q;
      select_458_s19_q <= select_458_s18_q;
      select_461_s19_q <= select_461_s18_q;
      select_465_s19_q <= select_465_s18_q;
      and_471_s19_q <= and_471_s18_q;
      and_472_s19_q <= and_472_s18_q;
      sum_479_s19_q <= sum_479;
      sum_483_s19_q <= sum_483;
      and_487_s19_q <= whole & (averager_memory_rdata_s18_q[28] | equal_477_s18_q);
      and_491_s19_q <= and_491;
      column_s19_q <= column_s18_q;
      and_495_s19_q <= and_495_s18_q;
      and_497_s19_q <= and_497_s18_q;
      equal_500_s19_q <= select_458_s18_q == 4'h3;
      so_s19_q <= so_s18_q;
      equal_558_s19_q <= equal_558_s18_q;
      equal_1466_s19_q <= equal_1466_s18_q;
      not_1467_s19_q <= not_1467_s18_q;
      shift_2_s19_q <= {shift_2_s18_q[11], shift_2_s18_q[2:0]};
      and_1501_s19_q <= and_1501_s18_q;
      equal_1511_s19_q <= x_s18_q[6:4] == 3'h7;
      right_2_s19_q <= right_2_s18_q;
      and_1579_s19_q <= and_1579_s18_q;
      select_1596_s19_q <= select_1596_s18_q;
      equal_1597_s19_q <= equal_1597_s18_q;
      patches_choices_rdata_s19_q <= patches_choices_rdata_q;
      and_1605_s19_q <= and_1605_s18_q;
      and_1607_s19_q <= and_1607_s18_q;
      equal_1612_s19_q <= equal_1612_s18_q;
      and_1627_s19_q <= not_1467_s18_q & (so_s18_q & (ends_cell_s18_q & and_1624_s18_q));
      select_1633_s19_q <= equal_1466_s18_q ? 8'h0 : select_1632;
      select_1637_s19_q <= equal_1466_s18_q ? 6'h0 : (so_s18_q ? select_1635 : 6'h0);
      equal_1638_s19_q <= equal_1638;
      select_1663_s19_q <= equal_1466_s18_q ? 8'h0 : select_1662;
      and_1670_s19_q <= and_1670_s18_q;
      and_1671_s19_q <= and_1671_s18_q;
      equal_1672_s19_q <= equal_1672_s18_q;
      not_1673_s19_q <= not_1673_s18_q;
      equal_1674_s19_q <= equal_1674_s18_q;
      equal_1676_s19_q <= equal_1676_s18_q;
      or_1678_s19_q <= or_1678_s18_q;
      and_1687_s19_q <= and_1687_s18_q;
      select_1699_s19_q <= select_1699_s18_q;
      select_1705_s19_q <= select_1705_s18_q;
      select_1739_s19_q <= select_1739_s18_q;
      new_row_s19_q <= new_row;
      down_2_s19_q <= down_2_s18_q[1:0];
      sum_1765_s19_q <= sum_1765;
      smooth_s19_q <= smooth;
      and_1791_s19_q <= and_1791_s18_q;
      or_1795_s19_q <= or_1795_s18_q;
      and_1803_s19_q <= and_1803_s18_q;
      less_1804_s19_q <= less_1804_s18_q;
      equal_1805_s19_q <= equal_1805_s18_q;
      not_1806_s19_q <= not_1806_s18_q;
      equal_1807_s19_q <= equal_1807_s18_q;
      patches_rows_rdata_s19_q <= patches_rows_rdata_s18_q;
      or_1825_s19_q <= or_1825;
      or_1828_s19_q <= select_1822[7] | (~({select_1822[6], select_1822[3:2]} == 3'h0));
      or_1831_s19_q <= select_1822[7] | (~(select_1822[6:4] == 3'h0));
      and_1840_s19_q <= and_1840_s18_q;
      textured_s19_q <= textured_s18_q;
      explained_s19_q <= explained;
      and_1854_s19_q <= and_1854;
      seen_columns_rdata_s19_q <= {seen_columns_rdata_s18_q[13:7], seen_columns_rdata_s18_q[5:0]};
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_1900_s19_q <= seen_columns_rdata_s18_q[14] & shift_2_s18_q[0];
      and_1902_s19_q <= seen_columns_rdata_s18_q[5] & shift_2_s18_q[0];
      or_1917_s19_q <= or_1917;
      or_1920_s19_q <= select_1914[7] | (~({select_1914[6], select_1914[3:2]} == 3'h0));
      or_1923_s19_q <= select_1914[7] | (~(select_1914[6:4] == 3'h0));
      and_1934_s19_q <= seen_columns_rdata_s18_q[16] & shift_2_s18_q[0];
      and_1936_s19_q <= seen_columns_rdata_s18_q[8] & shift_2_s18_q[0];
      and_1937_s19_q <= seen_columns_rdata_s18_q[3] & shift_2_s18_q[0];
      and_1950_s19_q <= seen_columns_rdata_s18_q[17] & shift_2_s18_q[0];
      and_1952_s19_q <= seen_columns_rdata_s18_q[9] & shift_2_s18_q[0];
      and_1953_s19_q <= seen_columns_rdata_s18_q[4] & shift_2_s18_q[0];
      and_1973_s19_q <= and_1973_s18_q;
      equal_2113_s19_q <= equal_2113_s18_q;
      equal_2237_s19_q <= equal_2237_s18_q;
      and_2377_s19_q <= seen_columns_rdata_s18_q[15] & shift_2_s18_q[0];
      and_2378_s19_q <= seen_columns_rdata_s18_q[11] & shift_2_s18_q[0];
      sum_2382_s19_q <= {1'b0, and_2379} + ({1'b0, explained} + {1'b0, and_2380});
      or_2469_s19_q <= (shift_2_s18_q[13:11] == 3'h0) | (shift_2_s18_q[13:11] == 3'h4);
      sum_2470_s19_q <= shift_2_s18_q[13:12] + 2'h3;
      less_2471_s19_q <= less_2471_s18_q;
      sum_2477_s19_q <= sum_2477[8:1];
      select_2478_s19_q <= select_2478[0];
      sum_2480_s19_q <= sum_2480;
      select_2482_s19_q <= select_2482[0];
      difference_2484_s19_q <= difference_2484;
      and_2713_s19_q <= and_2713_s18_q;
      or_2762_s19_q <= or_2762_s18_q;
      not_2786_s19_q <= not_2786_s18_q;
      select_3261_s19_q <= select_3261_s18_q;
      select_3268_s19_q <= select_3268;
      select_3277_s19_q <= select_3277;
      and_3283_s19_q <= equal_3257_s18_q & ({sum_3281[6], sum_3281} < 8'hfb);
      select_3292_s19_q <= select_3292_s18_q;
      less_3532_s19_q <= less_3532_s18_q;
      sum_3533_s19_q <= sum_3533[7];
      and_3727_s19_q <= seen_columns_rdata_s18_q[6] & shift_2_s18_q[0];
      equal_3737_s19_q <= equal_3737_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [7:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic patches_match_row_ends_q;
  logic [11:0] patches_smooth_values_0_q;
  logic [11:0] patches_smooth_values_1_q;
  logic [11:0] patches_smooth_values_2_q;
  logic [11:0] patches_smooth_values_3_q;
  logic [10:0] patches_down_values_2_q;
  logic [10:0] patches_down_values_3_q;
  logic [4:0] patches_down_by_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic [4:0] patches_summed_down_by_q;
  logic patches_read_above_q;
  logic patches_read_below_q;
  logic [9:0] patches_peak_above_q;
  logic [9:0] patches_peak_below_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic region_fresh_q;
  logic segment_started_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_471_s19_q ? sum_479_s19_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_500_s19_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_471_s19_q ? sum_483_s19_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_500_s19_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_508;
  assign and_508 = and_471_s19_q & and_487_s19_q;
  // hls/stages/census.hpp:126
  logic select_510;
  assign select_510 = equal_500_s19_q ? and_508 : (averager_mask_q & and_508);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s19_q & select_510;
  // hls/stages/census.hpp:206
  logic and_512;
  assign and_512 = and_471_s19_q & and_491_s19_q;
  // hls/stages/census.hpp:126
  logic select_514;
  assign select_514 = equal_500_s19_q ? and_512 : (averager_of_skin_q & and_512);
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s19_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:184
  logic equal_1525;
  assign equal_1525 = x_s19_q[5:0] == 6'h3c;
  logic equal_1527;
  assign equal_1527 = x_s19_q[5:0] == 6'h3b;
  logic equal_1529;
  assign equal_1529 = x_s19_q[5:0] == 6'h36;
  logic equal_1531;
  assign equal_1531 = x_s19_q[5:0] == 6'h35;
  logic equal_1533;
  assign equal_1533 = x_s19_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1115
  logic and_1537;
  assign and_1537 = (~equal_1527) & ((~equal_1529) & ((~equal_1531) & (~equal_1533)));
  // hls/stages/patches.hpp:133
  logic and_1629;
  assign and_1629 = and_1627_s19_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:306
  logic [22:0] select_1664;
  assign select_1664 = and_1629 ? {select_1663_s19_q, select_1637_s19_q, select_1633_s19_q, and_1627_s19_q} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:160
  logic and_1758;
  assign and_1758 = not_1673_s19_q & (equal_1674_s19_q & new_row_s19_q);
  // hls/stages/patches.hpp:414
  logic [13:0] sum_1766;
  assign sum_1766 = {{3{patches_down_values_1_s19_q[10]}}, patches_down_values_1_s19_q} + {sum_1765_s19_q, down_2_s19_q[1]};
  logic [12:0] sum_1767;
  assign sum_1767 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1766[13:1];
  // hls/stages/patches.hpp:413
  logic [12:0] sum_1776;
  assign sum_1776 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s19_q[11:1]};
  logic [12:0] sum_1777;
  assign sum_1777 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1778;
  assign difference_1778 = {1'b0, sum_1776, smooth_s19_q[0]} - {1'b0, sum_1777, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:303
  logic [5:0] select_1832;
  assign select_1832 = equal_1466_s19_q ? x_s19_q[5:0] : {region_row_q, or_1831_s19_q, or_1828_s19_q, or_1825_s19_q};
  // hls/stages/agreement.hpp:1069
  logic not_1833;
  assign not_1833 = ~equal_1511_s19_q;
  // hls/stages/agreement.hpp:250
  logic and_1861;
  assign and_1861 = shift_2_s19_q[0] & shift_2_s19_q[2];
  // hls/stages/agreement.hpp:975
  logic and_1903;
  assign and_1903 = seen_columns_rdata_s19_q[0] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1028
  logic [1:0] sum_1905;
  assign sum_1905 = {1'b0, and_1902_s19_q} + ({1'b0, textured_s19_q} + {1'b0, and_1903});
  // hls/stages/agreement.hpp:975
  logic and_1935;
  assign and_1935 = seen_columns_rdata_s19_q[11] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_1939;
  assign sum_1939 = {1'b0, and_1936_s19_q} + ({1'b0, shown_s19_q} + {1'b0, and_1937_s19_q});
  // hls/stages/agreement.hpp:975
  logic and_1951;
  assign and_1951 = seen_columns_rdata_s19_q[12] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1955;
  assign sum_1955 = {1'b0, and_1952_s19_q} + ({1'b0, near_s19_q} + {1'b0, and_1953_s19_q});
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2005;
  assign select_2005 = sample_pair_whole_s19_q ? (and_495_s19_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2007;
  assign select_2007 = sample_pair_whole_s19_q ? (and_495_s19_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2028;
  assign select_2028 = sample_pair_whole_s19_q ? (and_495_s19_q ? select_510 : averager_mask_q) : averager_mask_q;
  logic select_2030;
  assign select_2030 = sample_pair_whole_s19_q ? (and_495_s19_q ? select_514 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/patches.hpp:303
  logic and_2356;
  assign and_2356 = so_s19_q & (ends_cell_s19_q & (shift_2_s19_q[0] & shift_2_s19_q[1]));
  // hls/stages/agreement.hpp:1046
  logic not_2376;
  assign not_2376 = ~(x_s19_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1029
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2377_s19_q} + ({2'h0, and_2378_s19_q} + {1'b0, sum_2382_s19_q});
  // hls/stages/patches.hpp:303
  logic and_2417;
  assign and_2417 = ends_cell_s19_q & (shift_2_s19_q[0] & (shift_2_s19_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:1051
  logic and_2423;
  assign and_2423 = not_2376 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2472;
  assign difference_2472 = {sum_2470_s19_q, shift_2_s19_q[3], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2473;
  assign select_2473 = less_2471_s19_q ? difference_2472 : {sum_2470_s19_q, shift_2_s19_q[3], registration_displacement_fraction_q};
  logic [7:0] select_2474;
  assign select_2474 = or_2469_s19_q ? {sum_2470_s19_q, shift_2_s19_q[3], 5'h0} : select_2473;
  // hls/stages/registration.hpp:211
  logic [10:0] sum_2481;
  assign sum_2481 = {{3{sum_2477_s19_q[7]}}, sum_2477_s19_q} + {sum_2480_s19_q[8], sum_2480_s19_q, select_2478_s19_q};
  logic [9:0] sum_2485;
  assign sum_2485 = {difference_2484_s19_q, select_2482_s19_q} + {sum_2481[10], sum_2481[10:2]};
  // hls/stages/patches.hpp:308
  logic not_2703;
  assign not_2703 = ~and_1670_s19_q;
  // hls/stages/patches.hpp:163
  logic select_2801;
  assign select_2801 = patches_along_ends_s19_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:160
  logic [11:0] select_2804;
  assign select_2804 = equal_1674_s19_q ? patches_smooth_values_0_q : (or_1678_s19_q ? smooth_s19_q : patches_smooth_values_0_q);
  logic [11:0] select_2806;
  assign select_2806 = or_1678_s19_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2808;
  assign select_2808 = equal_1672_s19_q ? patches_smooth_values_1_q : (equal_1674_s19_q ? patches_smooth_values_1_q : select_2806);
  logic [11:0] select_2809;
  assign select_2809 = or_1678_s19_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2811;
  assign select_2811 = equal_1672_s19_q ? patches_smooth_values_2_q : (equal_1674_s19_q ? patches_smooth_values_2_q : select_2809);
  logic [11:0] select_2812;
  assign select_2812 = or_1678_s19_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2814;
  assign select_2814 = equal_1672_s19_q ? patches_smooth_values_3_q : (equal_1674_s19_q ? patches_smooth_values_3_q : select_2812);
  logic [10:0] select_2821;
  assign select_2821 = or_1678_s19_q ? patches_down_values_1_s19_q : patches_down_values_2_q;
  logic [10:0] select_2823;
  assign select_2823 = equal_1672_s19_q ? patches_down_values_2_q : (equal_1674_s19_q ? patches_down_values_2_q : select_2821);
  logic [10:0] select_2824;
  assign select_2824 = or_1678_s19_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_2826;
  assign select_2826 = equal_1672_s19_q ? patches_down_values_3_q : (equal_1674_s19_q ? patches_down_values_3_q : select_2824);
  // hls/stages/patches.hpp:151
  logic and_2854;
  assign and_2854 = patches_along_ends_s19_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:369
  logic [3:0] select_2861;
  assign select_2861 = and_2854 ? 4'h0 : ({3'h0, patches_along_ends_s19_q} + patches_match_row_q);
  // hls/stages/patches.hpp:160
  logic [4:0] select_3217;
  assign select_3217 = equal_1672_s19_q ? patches_summed_down_by_q : (equal_1674_s19_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:480
  logic select_3270;
  assign select_3270 = less_1804_s19_q ? (not_1806_s19_q & select_3268_s19_q) : select_3268_s19_q;
  logic select_3279;
  assign select_3279 = less_1804_s19_q ? (not_1806_s19_q & select_3277_s19_q) : select_3277_s19_q;
  // hls/stages/patches.hpp:476
  logic [9:0] select_3285;
  assign select_3285 = less_1804_s19_q ? (and_3283_s19_q ? patches_rows_rdata_s19_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:461
  logic [9:0] select_3296;
  assign select_3296 = patches_read_above_q ? patches_read_row_differing_s19_q : patches_peak_above_q;
  // hls/stages/patches.hpp:462
  logic [9:0] select_3298;
  assign select_3298 = patches_read_below_q ? patches_read_row_differing_s19_q : patches_peak_below_q;
  // hls/stages/patches.hpp:499
  logic less_3335;
  assign less_3335 = select_3296 < select_3298;
  // hls/stages/patches.hpp:500
  logic [9:0] high;
  assign high = less_3335 ? select_3298 : select_3296;
  logic [9:0] low;
  assign low = (select_3298 < select_3296) ? select_3298 : select_3296;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3535;
  assign select_3535 = less_3532_s19_q ? (sum_3533_s19_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3537;
  assign select_3537 = equal_2237_s19_q ? (equal_558_s19_q ? 3'h0 : select_3535) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3533_s19_q;
  // hls/stages/agreement.hpp:447
  logic select_3568;
  assign select_3568 = equal_2237_s19_q ? (equal_558_s19_q | (less_3532_s19_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1147
  logic equal_3586;
  assign equal_3586 = x_s19_q[6:3] == 4'h7;
  logic equal_3608;
  assign equal_3608 = x_s19_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1066
  logic [7:0] select_3621;
  assign select_3621 = (x_s19_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3623;
  assign select_3623 = equal_3608 ? cfg_unproven_skin_limit_i : (equal_3586 ? cfg_unproven_limit_i : select_3621);
  // hls/stages/patches.hpp:303
  logic select_3725;
  assign select_3725 = so_s19_q ? (ends_cell_s19_q ? and_1902_s19_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3729;
  assign select_3729 = so_s19_q ? (ends_cell_s19_q ? and_3727_s19_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_3731;
  assign select_3731 = ends_cell_s19_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3733;
  assign select_3733 = equal_1466_s19_q ? centres_values_1_textured_q : (so_s19_q ? select_3731 : centres_values_1_textured_q);
  logic select_3734;
  assign select_3734 = ends_cell_s19_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3736;
  assign select_3736 = equal_1466_s19_q ? centres_values_1_of_skin_q : (so_s19_q ? select_3734 : centres_values_1_of_skin_q);

  // Memory patches_right_codes, 28 x 112, DISTANCE 24, hls/stages/patches.hpp:693; read in stage 19, written in stage 21: 19 < 21 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [111:0] patches_right_codes_mem [0:27];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 28; i++) patches_right_codes_mem[i] = 112'h0;
`endif
  logic [4:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = patches_down_by_q + {1'b0, patches_match_row_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s19_en & and_1758;
  logic [111:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:694; read in stage 19, written in stage 21: 19 < 21 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s19_en & and_1758;
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1317; read in stage 19, written in stage 22: 19 < 22 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1832;
  logic regions_re;
  assign regions_re = s19_en & (equal_1466_s19_q ? (x_s19_q[6] & not_1833) : and_1840_s19_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_465_s19_q;
  logic averager_memory_we;
  assign averager_memory_we = s19_en & and_472_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_491_s19_q, and_487_s19_q, sum_483_s19_q, sum_479_s19_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s17_sim;
  logic averager_memory_re_s17_sim;
  logic [8:0] averager_memory_raddr_s18_sim;
  logic averager_memory_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s17_sim <= 1'b0;
      averager_memory_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s17_sim <= averager_memory_re;
      averager_memory_raddr_s17_sim <= averager_memory_raddr;
      averager_memory_re_s18_sim <= averager_memory_re_s17_sim;
      averager_memory_raddr_s18_sim <= averager_memory_raddr_s17_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s17_sim && averager_memory_raddr_s17_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s18_sim && averager_memory_raddr_s18_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s19_q, and_1605_s19_q};
  logic patches_choices_we;
  assign patches_choices_we = s19_en & and_1671_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= select_1664;
  end
`ifndef SYNTHESIS
  logic [5:0] patches_choices_raddr_s18_sim;
  logic patches_choices_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choices_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      patches_choices_re_s18_sim <= patches_choices_re;
      patches_choices_raddr_s18_sim <= patches_choices_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_choices_we) begin
      if (patches_choices_re && patches_choices_raddr == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
      if (patches_choices_re_s18_sim && patches_choices_raddr_s18_sim == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
    end
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s19_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s19_en & and_1501_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q, near_s19_q, shown_s19_q, explained_s19_q, and_1861, textured_s19_q};
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
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_match_row_ends_q <= 1'b0;
      patches_smooth_values_0_q <= 12'h0;
      patches_smooth_values_1_q <= 12'h0;
      patches_smooth_values_2_q <= 12'h0;
      patches_smooth_values_3_q <= 12'h0;
      patches_down_values_2_q <= 11'h0;
      patches_down_values_3_q <= 11'h0;
      patches_down_by_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_last_q <= 1'b0;
      patches_summed_down_by_q <= 5'h0;
      patches_read_above_q <= 1'b0;
      patches_read_below_q <= 1'b0;
      patches_peak_above_q <= 10'h0;
      patches_peak_below_q <= 10'h0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      segment_started_q <= 1'b0;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s19_en) begin
      averager_mask_q <= select_2028;
      averager_of_skin_q <= select_2030;
      patches_fixed_q <= not_2703 & (patches_fixed_q | (and_2713_s19_q & and_1629));
      patches_choice_valid_q <= and_1670_s19_q ? (select_1664[0] & not_2703) : select_1664[0];
      patches_choice_column_q <= select_1664[8:1];
      patches_choice_shift_q <= select_1664[14:9];
      patches_choice_slope_q <= select_1664[22:15];
      patches_match_row_ends_q <= not_2786_s19_q & select_2801;
      patches_smooth_values_0_q <= equal_1672_s19_q ? patches_smooth_values_0_q : select_2804;
      patches_smooth_values_1_q <= select_2808;
      patches_smooth_values_2_q <= select_2811;
      patches_smooth_values_3_q <= select_2814;
      patches_down_values_2_q <= select_2823;
      patches_down_values_3_q <= select_2826;
      patches_down_by_q <= or_2762_s19_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2854});
      patches_match_row_q <= or_2762_s19_q ? 4'h0 : select_2861;
      patches_summed_last_q <= not_1673_s19_q & (equal_1674_s19_q & and_2854);
      patches_summed_down_by_q <= select_3217;
      patches_read_above_q <= equal_1672_s19_q ? select_3270 : patches_read_above_q;
      patches_read_below_q <= equal_1672_s19_q ? select_3279 : patches_read_below_q;
      patches_peak_above_q <= equal_1672_s19_q ? select_3296 : patches_peak_above_q;
      patches_peak_below_q <= equal_1672_s19_q ? select_3298 : patches_peak_below_q;
      region_row_q <= and_497_s19_q ? select_3537 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_497_s19_q ? select_3568 : region_fresh_q;
      segment_started_q <= ~segment_starts_q;
      centres_values_0_textured_q <= equal_1466_s19_q ? centres_values_0_textured_q : select_3725;
      centres_values_0_of_skin_q <= equal_1466_s19_q ? centres_values_0_of_skin_q : select_3729;
      centres_values_1_textured_q <= select_3733;
      centres_values_1_of_skin_q <= select_3736;
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
    if (s19_en) begin
      averager_total_0_q <= select_2005;
      averager_total_1_q <= select_2007;
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
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic [2:0] slot_s20_q;
  logic ends_cell_s20_q;
  logic lower_half_s20_q;
  logic patches_lower_s20_q;
  logic patches_second_s20_q;
  logic [4:0] patches_code_row_s20_q;
  logic patches_column_s20_q;
  logic [10:0] patches_down_values_3_s20_q;
  logic [4:0] patches_summed_row_column_s20_q;
  logic patches_summed_last_s20_q;
  logic [4:0] patches_summed_down_by_s20_q;
  logic patches_read_first_s20_q;
  logic [2:0] region_row_s20_q;
  logic region_fresh_s20_q;
  logic segment_started_s20_q;
  logic centres_values_1_textured_s20_q;
  logic centres_values_1_of_skin_s20_q;
  logic [3:0] select_458_s20_q;
  logic [6:0] select_461_s20_q;
  logic [6:0] column_s20_q;
  logic and_495_s20_q;
  logic and_497_s20_q;
  logic [77:0] census_memory_rdata_s20_q;
  logic [8:0] grey_s20_q;
  logic equal_500_s20_q;
  logic [8:0] select_503_s20_q;
  logic [8:0] grey_2_s20_q;
  logic [8:0] select_507_s20_q;
  logic whole_2_s20_q;
  logic and_515_s20_q;
  logic so_s20_q;
  logic equal_558_s20_q;
  logic equal_1466_s20_q;
  logic not_1467_s20_q;
  logic shift_2_s20_q;
  logic equal_1511_s20_q;
  logic all_s20_q;
  logic equal_1525_s20_q;
  logic equal_1527_s20_q;
  logic equal_1529_s20_q;
  logic equal_1531_s20_q;
  logic equal_1533_s20_q;
  logic and_1538_s20_q;
  logic right_2_s20_q;
  logic and_1579_s20_q;
  logic select_1596_s20_q;
  logic equal_1597_s20_q;
  logic and_1607_s20_q;
  logic equal_1612_s20_q;
  logic equal_1638_s20_q;
  logic equal_1672_s20_q;
  logic equal_1674_s20_q;
  logic equal_1676_s20_q;
  logic or_1678_s20_q;
  logic [22:0] select_1688_s20_q;
  logic [4:0] select_1699_s20_q;
  logic select_1705_s20_q;
  logic [3:0] select_1739_s20_q;
  logic new_row_s20_q;
  logic down_2_s20_q;
  logic sum_1766_s20_q;
  logic [12:0] sum_1767_s20_q;
  logic [14:0] difference_1778_s20_q;
  logic and_1791_s20_q;
  logic or_1795_s20_q;
  logic and_1803_s20_q;
  logic less_1804_s20_q;
  logic equal_1805_s20_q;
  logic not_1806_s20_q;
  logic equal_1807_s20_q;
  logic or_1825_s20_q;
  logic or_1828_s20_q;
  logic or_1831_s20_q;
  logic not_1833_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1854_s20_q;
  logic and_1859_s20_q;
  logic and_1900_s20_q;
  logic and_1901_s20_q;
  logic [1:0] sum_1905_s20_q;
  logic or_1917_s20_q;
  logic or_1920_s20_q;
  logic or_1923_s20_q;
  logic and_1934_s20_q;
  logic [2:0] sum_1940_s20_q;
  logic and_1950_s20_q;
  logic [2:0] sum_1956_s20_q;
  logic and_1973_s20_q;
  logic equal_2113_s20_q;
  logic equal_2237_s20_q;
  logic and_2357_s20_q;
  logic not_2376_s20_q;
  logic [2:0] explained_2_s20_q;
  logic and_2419_s20_q;
  logic and_2426_s20_q;
  logic [7:0] select_2474_s20_q;
  logic sum_2481_s20_q;
  logic [9:0] sum_2485_s20_q;
  logic equal_3173_s20_q;
  logic [4:0] select_3261_s20_q;
  logic [9:0] select_3285_s20_q;
  logic [14:0] select_3292_s20_q;
  logic less_3335_s20_q;
  logic [9:0] high_s20_q;
  logic [9:0] low_s20_q;
  logic equal_3586_s20_q;
  logic equal_3607_s20_q;
  logic equal_3608_s20_q;
  logic [7:0] select_3623_s20_q;
  logic equal_3737_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      pixel_0_s20_q <= pixel_0_s19_q;
      pixel_1_s20_q <= pixel_1_s19_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= sample_of_skin_q;
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
      patches_lower_s20_q <= patches_lower_s19_q;
      patches_second_s20_q <= patches_second_s19_q;
      patches_code_row_s20_q <= patches_code_row_s19_q;
      patches_column_s20_q <= patches_column_s19_q;
      patches_down_values_3_s20_q <= patches_down_values_3_q;
      patches_summed_row_column_s20_q <= patches_summed_row_column_s19_q;
      patches_summed_last_s20_q <= patches_summed_last_q;
      patches_summed_down_by_s20_q <= patches_summed_down_by_q;
      patches_read_first_s20_q <= patches_read_first_s19_q;
      region_row_s20_q <= region_row_q;
      region_fresh_s20_q <= region_fresh_q;
      segment_started_s20_q <= segment_started_q;
      centres_values_1_textured_s20_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s20_q <= centres_values_1_of_skin_q;
      select_458_s20_q <= select_458_s19_q;
      select_461_s20_q <= select_461_s19_q;
      column_s20_q <= column_s19_q;
      and_495_s20_q <= and_495_s19_q;
      and_497_s20_q <= and_497_s19_q;
      census_memory_rdata_s20_q <= census_memory_rdata_q;
      grey_s20_q <= grey;
      equal_500_s20_q <= equal_500_s19_q;
      select_503_s20_q <= sample_pair_whole_s19_q ? total[10:2] : 9'h0;
      grey_2_s20_q <= grey_2;
      select_507_s20_q <= sample_pair_whole_s19_q ? total_2[10:2] : 9'h0;
      whole_2_s20_q <= whole_2;
      and_515_s20_q <= sample_pair_whole_s19_q & select_514;
      so_s20_q <= so_s19_q;
      equal_558_s20_q <= equal_558_s19_q;
      equal_1466_s20_q <= equal_1466_s19_q;
      not_1467_s20_q <= not_1467_s19_q;
      shift_2_s20_q <= shift_2_s19_q[0];
      equal_1511_s20_q <= equal_1511_s19_q;
      all_s20_q <= all;
      equal_1525_s20_q <= equal_1525;
      equal_1527_s20_q <= equal_1527;
      equal_1529_s20_q <= equal_1529;
      equal_1531_s20_q <= equal_1531;
      equal_1533_s20_q <= equal_1533;
      and_1538_s20_q <= (~equal_1525) & and_1537;
      right_2_s20_q <= right_2_s19_q;
      and_1579_s20_q <= and_1579_s19_q;
      select_1596_s20_q <= select_1596_s19_q;
      equal_1597_s20_q <= equal_1597_s19_q;
      and_1607_s20_q <= and_1607_s19_q;
      equal_1612_s20_q <= equal_1612_s19_q;
      equal_1638_s20_q <= equal_1638_s19_q;
      equal_1672_s20_q <= equal_1672_s19_q;
      equal_1674_s20_q <= equal_1674_s19_q;
      equal_1676_s20_q <= equal_1676_s19_q;
      or_1678_s20_q <= or_1678_s19_q;
      select_1688_s20_q <= and_1687_s19_q ? select_1664 : patches_choices_rdata_s19_q;
      select_1699_s20_q <= select_1699_s19_q;
      select_1705_s20_q <= select_1705_s19_q;
      select_1739_s20_q <= select_1739_s19_q;
      new_row_s20_q <= new_row_s19_q;
      down_2_s20_q <= down_2_s19_q[0];
      sum_1766_s20_q <= sum_1766[0];
      sum_1767_s20_q <= sum_1767;
      difference_1778_s20_q <= difference_1778;
      and_1791_s20_q <= and_1791_s19_q;
      or_1795_s20_q <= or_1795_s19_q;
      and_1803_s20_q <= and_1803_s19_q;
      less_1804_s20_q <= less_1804_s19_q;
      equal_1805_s20_q <= equal_1805_s19_q;
      not_1806_s20_q <= not_1806_s19_q;
      equal_1807_s20_q <= equal_1807_s19_q;
      or_1825_s20_q <= or_1825_s19_q;
      or_1828_s20_q <= or_1828_s19_q;
      or_1831_s20_q <= or_1831_s19_q;
      not_1833_s20_q <= not_1833;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained_s19_q;
      and_1854_s20_q <= and_1854_s19_q;
      and_1859_s20_q <= not_1467_s19_q & and_1840_s19_q;
      and_1900_s20_q <= and_1900_s19_q;
      and_1901_s20_q <= seen_columns_rdata_s19_q[9] & shift_2_s19_q[0];
      sum_1905_s20_q <= sum_1905;
      or_1917_s20_q <= or_1917_s19_q;
      or_1920_s20_q <= or_1920_s19_q;
      or_1923_s20_q <= or_1923_s19_q;
      and_1934_s20_q <= and_1934_s19_q;
      sum_1940_s20_q <= {2'h0, and_1935} + {1'b0, sum_1939};
      and_1950_s20_q <= and_1950_s19_q;
      sum_1956_s20_q <= {2'h0, and_1951} + {1'b0, sum_1955};
      and_1973_s20_q <= and_1973_s19_q;
      equal_2113_s20_q <= equal_2113_s19_q;
      equal_2237_s20_q <= equal_2237_s19_q;
      and_2357_s20_q <= not_1467_s19_q & and_2356;
      not_2376_s20_q <= not_2376;
      explained_2_s20_q <= explained_2;
      and_2419_s20_q <= not_1467_s19_q & (so_s19_q & and_2417);
      and_2426_s20_q <= not_1467_s19_q & (so_s19_q & (ends_cell_s19_q & and_2423));
      select_2474_s20_q <= select_2474;
      sum_2481_s20_q <= sum_2481[1];
      sum_2485_s20_q <= sum_2485;
      equal_3173_s20_q <= patches_match_row_q == 4'h0;
      select_3261_s20_q <= select_3261_s19_q;
      select_3285_s20_q <= select_3285;
      select_3292_s20_q <= select_3292_s19_q;
      less_3335_s20_q <= less_3335;
      high_s20_q <= high;
      low_s20_q <= low;
      equal_3586_s20_q <= equal_3586;
      equal_3607_s20_q <= x_s19_q[6:3] == 4'h9;
      equal_3608_s20_q <= equal_3608;
      select_3623_s20_q <= select_3623;
      equal_3737_s20_q <= equal_3737_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
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
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [7:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic [7:0] patches_place_1_column_q;
  logic [5:0] patches_place_1_shift_q;
  logic [7:0] patches_place_1_slope_q;
  logic [9:0] patches_read_far_q;
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
  // hls/stages/census.hpp:294
  logic less_531;
  assign less_531 = census_memory_rdata_s20_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_532;
  assign less_532 = census_memory_rdata_s20_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_533;
  assign less_533 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_534;
  assign less_534 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_535;
  assign less_535 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_536;
  assign less_536 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_537;
  assign less_537 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_538;
  assign less_538 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_540;
  assign less_540 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_541;
  assign less_541 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_542;
  assign less_542 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_543;
  assign less_543 = census_memory_rdata_s20_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_544;
  assign less_544 = census_memory_rdata_s20_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_545;
  assign less_545 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_546;
  assign less_546 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_547;
  assign less_547 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_548;
  assign less_548 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_549;
  assign less_549 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_550;
  assign less_550 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_552;
  assign less_552 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_553;
  assign less_553 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_554;
  assign less_554 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_555;
  assign equal_555 = column_s20_q == 7'h0;
  logic [3:0] select_559;
  assign select_559 = equal_558_s20_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_560;
  assign select_560 = equal_555 ? {select_559, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_561;
  assign select_561 = equal_555 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:286
  logic and_564;
  assign and_564 = census_memory_rdata_s20_q[38] & (census_memory_rdata_s20_q[18] & whole_2_s20_q);
  logic and_566;
  assign and_566 = census_memory_rdata_s20_q[77] & (census_memory_rdata_s20_q[58] & and_564);
  // hls/stages/census.hpp:270
  logic [9:0] difference_589;
  assign difference_589 = {1'b0, select_503_s20_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_592;
  assign difference_592 = {1'b0, census_memory_rdata_s20_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_596;
  assign difference_596 = {1'b0, census_memory_rdata_s20_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_600;
  assign difference_600 = {1'b0, census_memory_rdata_s20_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_604;
  assign difference_604 = {1'b0, census_memory_rdata_s20_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/agreement.hpp:1115
  logic [1:0] quarter;
  assign quarter = x_s20_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1070
  logic [1:0] select_1514;
  assign select_1514 = x_s20_q[4] ? {x_s20_q[3], x_s20_q[0]} : {x_s20_q[0], x_s20_q[3]};
  // hls/stages/agreement.hpp:1083
  logic [3:0] select_1516;
  assign select_1516 = equal_1511_s20_q ? {2'h0, quarter} : (all_s20_q ? {1'b0, x_s20_q[2:0]} : {x_s20_q[2:1], select_1514});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1517;
  assign sum_1517 = slot_s20_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:303
  logic [3:0] select_1518;
  assign select_1518 = equal_1466_s20_q ? select_1516 : {sum_1517, lower_half_s20_q, registration_of_right_q};
  // hls/stages/patches.hpp:184
  logic equal_1519;
  assign equal_1519 = x_s20_q[5:0] == 6'h3f;
  logic equal_1521;
  assign equal_1521 = x_s20_q[5:0] == 6'h3e;
  logic equal_1523;
  assign equal_1523 = x_s20_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1115
  logic and_1541;
  assign and_1541 = (~equal_1519) & ((~equal_1521) & ((~equal_1523) & and_1538_s20_q));
  // hls/stages/agreement.hpp:1070
  logic less_1542;
  assign less_1542 = x_s20_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all_s20_q ? {1'b0, x_s20_q[2]} : x_s20_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_1546;
  assign or_1546 = (kind == 2'h3) | (x_s20_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s20_q ? (right_2_s20_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1557;
  assign sum_1557 = {2'h0, slot_s20_q} + 5'h1f;
  // hls/stages/registration.hpp:255
  logic not_1563;
  assign not_1563 = ~lower_half_s20_q;
  logic [3:0] select_1564;
  assign select_1564 = registration_of_right_q ? {lower_half_s20_q, 1'b0, not_1563, 1'b0} : {1'b0, lower_half_s20_q, 1'b0, not_1563};
  // hls/stages/patches.hpp:101
  logic [21:0] select_1689;
  assign select_1689 = select_1596_s20_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1688_s20_q[22:1];
  // hls/stages/patches.hpp:105
  logic [7:0] select_1690;
  assign select_1690 = equal_1597_s20_q ? patches_place_0_column_q : select_1689[7:0];
  logic [5:0] select_1691;
  assign select_1691 = equal_1597_s20_q ? patches_place_0_shift_q : select_1689[13:8];
  // hls/stages/patches.hpp:101
  logic [21:0] select_1715;
  assign select_1715 = select_1596_s20_q ? select_1688_s20_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:105
  logic [7:0] select_1716;
  assign select_1716 = equal_1597_s20_q ? patches_place_1_column_q : select_1715[7:0];
  logic [5:0] select_1717;
  assign select_1717 = equal_1597_s20_q ? patches_place_1_shift_q : select_1715[13:8];
  // hls/stages/patches.hpp:109
  logic equal_1732;
  assign equal_1732 = {select_1690[7], select_461_s20_q, select_458_s20_q} == {1'b0, select_1690[6:0], 4'h0};
  logic equal_1735;
  assign equal_1735 = {select_1716[7], select_461_s20_q, select_458_s20_q} == {1'b0, select_1716[6:0], 4'h0};
  // hls/stages/patches.hpp:414
  logic [14:0] sum_1768;
  assign sum_1768 = {{4{patches_down_values_3_s20_q[10]}}, patches_down_values_3_s20_q} + {sum_1767_s20_q, sum_1766_s20_q, down_2_s20_q};
  // hls/stages/agreement.hpp:1028
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1900_s20_q} + ({2'h0, and_1901_s20_q} + {1'b0, sum_1905_s20_q});
  // hls/stages/agreement.hpp:1030
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1934_s20_q} + sum_1940_s20_q;
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_1942;
  assign select_1942 = age_s20_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1031
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1950_s20_q} + sum_1956_s20_q;
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1958;
  assign select_1958 = age_s20_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_1997;
  assign select_1997 = sample_pair_whole_s20_q ? (and_495_s20_q ? grey_s20_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1999;
  assign select_1999 = sample_pair_whole_s20_q ? (and_495_s20_q ? grey_2_s20_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2001;
  assign select_2001 = sample_pair_whole_s20_q ? (and_495_s20_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2003;
  assign select_2003 = sample_pair_whole_s20_q ? (and_495_s20_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2008;
  assign sum_2008 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s20_q};
  logic [9:0] sum_2016;
  assign sum_2016 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s20_q};
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2031;
  assign select_2031 = and_497_s20_q ? select_503_s20_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2032;
  assign select_2032 = and_497_s20_q ? select_507_s20_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2034;
  assign select_2034 = and_497_s20_q ? census_memory_rdata_s20_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2035;
  assign select_2035 = and_497_s20_q ? census_memory_rdata_s20_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2036;
  assign select_2036 = and_497_s20_q ? census_memory_rdata_s20_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2037;
  assign select_2037 = and_497_s20_q ? census_memory_rdata_s20_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2038;
  assign select_2038 = and_497_s20_q ? census_memory_rdata_s20_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2039;
  assign select_2039 = and_497_s20_q ? census_memory_rdata_s20_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2040;
  assign select_2040 = and_497_s20_q ? census_memory_rdata_s20_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2041;
  assign select_2041 = and_497_s20_q ? census_memory_rdata_s20_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2042;
  assign select_2042 = and_497_s20_q ? census_memory_rdata_s20_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2043;
  assign select_2043 = and_497_s20_q ? census_memory_rdata_s20_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2044;
  assign select_2044 = and_497_s20_q ? census_memory_rdata_s20_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2045;
  assign select_2045 = and_497_s20_q ? census_memory_rdata_s20_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2046;
  assign select_2046 = and_497_s20_q ? census_memory_rdata_s20_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2047;
  assign select_2047 = and_497_s20_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2048;
  assign select_2048 = and_497_s20_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2050;
  assign select_2050 = and_497_s20_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2051;
  assign select_2051 = and_497_s20_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2053;
  assign select_2053 = and_497_s20_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2054;
  assign select_2054 = and_497_s20_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2056;
  assign select_2056 = and_497_s20_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2057;
  assign select_2057 = and_497_s20_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2058;
  assign select_2058 = and_497_s20_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2060;
  assign select_2060 = and_497_s20_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2061;
  assign select_2061 = and_497_s20_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2063;
  assign select_2063 = and_497_s20_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2064;
  assign select_2064 = and_497_s20_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2066;
  assign select_2066 = and_497_s20_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2067;
  assign select_2067 = and_497_s20_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2069;
  assign select_2069 = and_497_s20_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2070;
  assign select_2070 = and_497_s20_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2072;
  assign select_2072 = and_497_s20_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2073;
  assign select_2073 = and_497_s20_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2075;
  assign select_2075 = and_497_s20_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2076;
  assign select_2076 = and_497_s20_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2079;
  assign select_2079 = and_497_s20_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2080;
  assign select_2080 = and_497_s20_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2083;
  assign select_2083 = and_497_s20_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2084;
  assign select_2084 = and_497_s20_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2088;
  assign difference_2088 = {1'b0, select_507_s20_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2091;
  assign difference_2091 = {1'b0, census_memory_rdata_s20_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2095;
  assign difference_2095 = {1'b0, census_memory_rdata_s20_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2099;
  assign difference_2099 = {1'b0, census_memory_rdata_s20_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2103;
  assign difference_2103 = {1'b0, census_memory_rdata_s20_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2134;
  assign difference_2134 = {1'b0, select_503_s20_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2146;
  assign difference_2146 = {1'b0, select_507_s20_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:507
  logic and_2353;
  assign and_2353 = and_497_s20_q & (equal_558_s20_q & equal_2237_s20_q);
  // hls/stages/patches.hpp:303
  logic and_2362;
  assign and_2362 = not_1467_s20_q & (so_s20_q & (ends_cell_s20_q & textured_s20_q));
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_2385;
  assign select_2385 = age_s20_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2421;
  assign select_2421 = and_2353 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2419_s20_q});
  logic [13:0] select_2428;
  assign select_2428 = and_2353 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2426_s20_q});
  // hls/stages/registration.hpp:107
  logic equal_2463;
  assign equal_2463 = slot_s20_q == 3'h4;
  // hls/stages/registration.hpp:101
  logic [11:0] value_2;
  assign value_2 = {{4{select_2474_s20_q[7]}}, select_2474_s20_q} - {sum_2485_s20_q[9], sum_2485_s20_q, sum_2481_s20_q};
  // hls/stages/patches.hpp:303
  logic select_2532;
  assign select_2532 = so_s20_q ? (equal_2463 ? right_2_s20_q : registration_of_right_q) : registration_of_right_q;
  logic select_2535;
  assign select_2535 = so_s20_q ? (equal_1638_s20_q ? shift_2_s20_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1070
  logic [1:0] quarter_2;
  assign quarter_2 = all_s20_q ? x_s20_q[1:0] : select_1514;
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2735;
  assign select_2735 = sample_pair_whole_s20_q ? (equal_1597_s20_q ? patches_place_0_slope_q : select_1689[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_2739;
  assign select_2739 = sample_pair_whole_s20_q ? (equal_1597_s20_q ? patches_place_1_slope_q : select_1715[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:477
  logic [9:0] select_3287;
  assign select_3287 = less_1804_s20_q ? (equal_1807_s20_q ? 10'h3ff : select_3285_s20_q) : 10'h3ff;
  // hls/stages/patches.hpp:480
  logic [9:0] select_3288;
  assign select_3288 = equal_1807_s20_q ? select_3287 : select_3285_s20_q;
  logic [9:0] select_3290;
  assign select_3290 = less_1804_s20_q ? (equal_1805_s20_q ? 10'h3ff : select_3288) : select_3288;
  // hls/stages/patches.hpp:501
  logic [9:0] eight;
  assign eight = high_s20_q - low_s20_q;
  logic [9:0] fall;
  assign fall = high_s20_q - select_3292_s20_q[9:0];
  // hls/stages/patches.hpp:517
  logic [7:0] select_3358;
  assign select_3358 = patches_second_s20_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:516
  logic [3:0] sum_3359;
  assign sum_3359 = {2'h0, select_3292_s20_q[14:13]} + 4'hf;
  logic [5:0] select_3360;
  assign select_3360 = patches_second_s20_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3361;
  assign sum_3361 = {select_3360[5], select_3360} + {{4{sum_3359[3]}}, sum_3359[3:1]};
  // hls/stages/agreement.hpp:1153
  logic equal_3414;
  assign equal_3414 = x_s20_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1147
  logic equal_3605;
  assign equal_3605 = x_s20_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1066
  logic [7:0] limit;
  assign limit = equal_3605 ? cfg_regions_limit_i : (equal_3607_s20_q ? cfg_hidden_limit_i : select_3623_s20_q);
  // hls/stages/agreement.hpp:1160
  logic not_3626;
  assign not_3626 = ~x_s20_q[2];
  logic [3:0] select_3627;
  assign select_3627 = x_s20_q[1] ? {x_s20_q[2], 1'b0, not_3626, 1'b0} : {1'b0, x_s20_q[2], 1'b0, not_3626};
  logic [7:0] select_3628;
  assign select_3628 = x_s20_q[0] ? {select_3627[3], 1'b0, select_3627[2], 1'b0, select_3627[1], 1'b0, select_3627[0], 1'b0} : {1'b0, select_3627[3], 1'b0, select_3627[2], 1'b0, select_3627[1], 1'b0, select_3627[0]};
  // hls/stages/agreement.hpp:1066
  logic [13:0] select_3632;
  assign select_3632 = equal_3607_s20_q ? counts_skin_supervised_q : (equal_3608_s20_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3605 ? counts_textured_q : select_3632;
  // hls/stages/patches.hpp:303
  logic [2:0] select_3670;
  assign select_3670 = ends_cell_s20_q ? explained_2_s20_q : box_explained_columns_values_0_q;
  logic [2:0] select_3672;
  assign select_3672 = equal_1466_s20_q ? box_explained_columns_values_0_q : (so_s20_q ? select_3670 : box_explained_columns_values_0_q);
  logic [2:0] select_3673;
  assign select_3673 = ends_cell_s20_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3675;
  assign select_3675 = equal_1466_s20_q ? box_explained_columns_values_1_q : (so_s20_q ? select_3673 : box_explained_columns_values_1_q);
  logic [2:0] select_3676;
  assign select_3676 = ends_cell_s20_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3678;
  assign select_3678 = equal_1466_s20_q ? box_explained_columns_values_2_q : (so_s20_q ? select_3676 : box_explained_columns_values_2_q);
  logic [2:0] select_3679;
  assign select_3679 = ends_cell_s20_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3681;
  assign select_3681 = equal_1466_s20_q ? box_explained_columns_values_3_q : (so_s20_q ? select_3679 : box_explained_columns_values_3_q);
  logic [2:0] select_3682;
  assign select_3682 = ends_cell_s20_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3684;
  assign select_3684 = equal_1466_s20_q ? box_explained_columns_values_4_q : (so_s20_q ? select_3682 : box_explained_columns_values_4_q);
  logic [2:0] select_3689;
  assign select_3689 = so_s20_q ? (ends_cell_s20_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3691;
  assign select_3691 = ends_cell_s20_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3693;
  assign select_3693 = equal_1466_s20_q ? box_shown_columns_values_1_q : (so_s20_q ? select_3691 : box_shown_columns_values_1_q);
  logic [2:0] select_3694;
  assign select_3694 = ends_cell_s20_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3696;
  assign select_3696 = equal_1466_s20_q ? box_shown_columns_values_2_q : (so_s20_q ? select_3694 : box_shown_columns_values_2_q);
  logic [2:0] select_3697;
  assign select_3697 = ends_cell_s20_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3699;
  assign select_3699 = equal_1466_s20_q ? box_shown_columns_values_3_q : (so_s20_q ? select_3697 : box_shown_columns_values_3_q);
  logic [2:0] select_3700;
  assign select_3700 = ends_cell_s20_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3702;
  assign select_3702 = equal_1466_s20_q ? box_shown_columns_values_4_q : (so_s20_q ? select_3700 : box_shown_columns_values_4_q);
  logic [2:0] select_3707;
  assign select_3707 = so_s20_q ? (ends_cell_s20_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3709;
  assign select_3709 = ends_cell_s20_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3711;
  assign select_3711 = equal_1466_s20_q ? box_nearer_columns_values_1_q : (so_s20_q ? select_3709 : box_nearer_columns_values_1_q);
  logic [2:0] select_3712;
  assign select_3712 = ends_cell_s20_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3714;
  assign select_3714 = equal_1466_s20_q ? box_nearer_columns_values_2_q : (so_s20_q ? select_3712 : box_nearer_columns_values_2_q);
  logic [2:0] select_3715;
  assign select_3715 = ends_cell_s20_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3717;
  assign select_3717 = equal_1466_s20_q ? box_nearer_columns_values_3_q : (so_s20_q ? select_3715 : box_nearer_columns_values_3_q);
  logic [2:0] select_3718;
  assign select_3718 = ends_cell_s20_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3720;
  assign select_3720 = equal_1466_s20_q ? box_nearer_columns_values_4_q : (so_s20_q ? select_3718 : box_nearer_columns_values_4_q);

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s20_q;
  logic census_memory_we;
  assign census_memory_we = s20_en & and_497_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s20_q[58:40], census_memory_rdata_s20_q[38:0], and_515_s20_q, whole_2_s20_q, select_507_s20_q, select_503_s20_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s19_sim;
  logic census_memory_re_s19_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s19_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s19_sim <= census_memory_re;
      census_memory_raddr_s19_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s19_sim && census_memory_raddr_s19_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_textured_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      patches_place_0_column_q <= 8'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_column_q <= 8'h0;
      patches_place_1_shift_q <= 6'h0;
      patches_place_1_slope_q <= 8'h0;
      patches_read_far_q <= 10'h3ff;
    end else if (s20_en) begin
      census_filled_q <= and_497_s20_q ? {select_561[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_497_s20_q ? select_560 : rows_passed_above_q;
      counts_textured_q <= and_2353 ? 14'h0 : (counts_textured_q + {13'h0, and_2362});
      counts_skin_supervised_q <= select_2421;
      counts_skin_textured_q <= select_2428;
      registration_of_right_q <= equal_1466_s20_q ? registration_of_right_q : select_2532;
      registration_was_inside_q <= equal_1466_s20_q ? registration_was_inside_q : select_2535;
      patches_place_0_column_q <= sample_pair_whole_s20_q ? select_1690 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s20_q ? select_1691 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2735;
      patches_place_1_column_q <= sample_pair_whole_s20_q ? select_1716 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s20_q ? select_1717 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2739;
      patches_read_far_q <= equal_1672_s20_q ? select_3290 : patches_read_far_q;
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
    if (s20_en) begin
      averager_quarter_1_0_q <= select_1997;
      averager_quarter_1_1_q <= select_1999;
      averager_quarter_2_0_q <= select_2001;
      averager_quarter_2_1_q <= select_2003;
      census_columns_values_0_cell_0_left_q <= select_2031;
      census_columns_values_0_cell_0_right_q <= select_2032;
      census_columns_values_0_cell_1_left_q <= select_2034;
      census_columns_values_0_cell_1_right_q <= select_2035;
      census_columns_values_0_cell_1_mask_q <= select_2036;
      census_columns_values_0_cell_2_left_q <= select_2037;
      census_columns_values_0_cell_2_right_q <= select_2038;
      census_columns_values_0_cell_2_mask_q <= select_2039;
      census_columns_values_0_cell_2_of_skin_q <= select_2040;
      census_columns_values_0_cell_3_left_q <= select_2041;
      census_columns_values_0_cell_3_right_q <= select_2042;
      census_columns_values_0_cell_3_mask_q <= select_2043;
      census_columns_values_0_cell_4_left_q <= select_2044;
      census_columns_values_0_cell_4_right_q <= select_2045;
      census_columns_values_0_cell_4_mask_q <= select_2046;
      census_columns_values_1_cell_0_left_q <= select_2047;
      census_columns_values_1_cell_0_right_q <= select_2048;
      census_columns_values_1_cell_1_left_q <= select_2050;
      census_columns_values_1_cell_1_right_q <= select_2051;
      census_columns_values_1_cell_2_left_q <= select_2053;
      census_columns_values_1_cell_2_right_q <= select_2054;
      census_columns_values_1_cell_2_of_skin_q <= select_2056;
      census_columns_values_1_cell_3_left_q <= select_2057;
      census_columns_values_1_cell_3_right_q <= select_2058;
      census_columns_values_1_cell_4_left_q <= select_2060;
      census_columns_values_1_cell_4_right_q <= select_2061;
      census_columns_values_2_cell_0_left_q <= select_2063;
      census_columns_values_2_cell_0_right_q <= select_2064;
      census_columns_values_2_cell_1_left_q <= select_2066;
      census_columns_values_2_cell_1_right_q <= select_2067;
      census_columns_values_2_cell_2_left_q <= select_2069;
      census_columns_values_2_cell_2_right_q <= select_2070;
      census_columns_values_2_cell_3_left_q <= select_2072;
      census_columns_values_2_cell_3_right_q <= select_2073;
      census_columns_values_2_cell_4_left_q <= select_2075;
      census_columns_values_2_cell_4_right_q <= select_2076;
      census_columns_values_3_cell_1_left_q <= select_2079;
      census_columns_values_3_cell_1_right_q <= select_2080;
      census_columns_values_3_cell_3_left_q <= select_2083;
      census_columns_values_3_cell_3_right_q <= select_2084;
      sharpness_last_mean_0_q <= and_497_s20_q ? select_503_s20_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_497_s20_q ? select_507_s20_q : sharpness_last_mean_1_q;
      box_explained_columns_values_0_q <= select_3672;
      box_explained_columns_values_1_q <= select_3675;
      box_explained_columns_values_2_q <= select_3678;
      box_explained_columns_values_3_q <= select_3681;
      box_explained_columns_values_4_q <= select_3684;
      box_shown_columns_values_0_q <= equal_1466_s20_q ? box_shown_columns_values_0_q : select_3689;
      box_shown_columns_values_1_q <= select_3693;
      box_shown_columns_values_2_q <= select_3696;
      box_shown_columns_values_3_q <= select_3699;
      box_shown_columns_values_4_q <= select_3702;
      box_nearer_columns_values_0_q <= equal_1466_s20_q ? box_nearer_columns_values_0_q : select_3707;
      box_nearer_columns_values_1_q <= select_3711;
      box_nearer_columns_values_2_q <= select_3714;
      box_nearer_columns_values_3_q <= select_3717;
      box_nearer_columns_values_4_q <= select_3720;
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
  logic census_columns_values_0_cell_1_mask_s21_q;
  logic census_columns_values_0_cell_2_mask_s21_q;
  logic census_columns_values_0_cell_3_mask_s21_q;
  logic census_columns_values_0_cell_4_mask_s21_q;
  logic census_columns_values_1_cell_2_of_skin_s21_q;
  logic [7:0] x_s21_q;
  logic age_s21_q;
  logic [2:0] slot_s21_q;
  logic ends_cell_s21_q;
  logic lower_half_s21_q;
  logic [13:0] counts_textured_s21_q;
  logic registration_of_right_s21_q;
  logic patches_lower_s21_q;
  logic patches_second_s21_q;
  logic [4:0] patches_code_row_s21_q;
  logic patches_column_s21_q;
  logic [4:0] patches_summed_row_column_s21_q;
  logic patches_summed_last_s21_q;
  logic [4:0] patches_summed_down_by_s21_q;
  logic patches_read_first_s21_q;
  logic [9:0] patches_read_far_s21_q;
  logic [2:0] region_row_s21_q;
  logic region_fresh_s21_q;
  logic segment_started_s21_q;
  logic centres_values_1_textured_s21_q;
  logic centres_values_1_of_skin_s21_q;
  logic [3:0] select_458_s21_q;
  logic [6:0] select_461_s21_q;
  logic [6:0] column_s21_q;
  logic and_495_s21_q;
  logic and_497_s21_q;
  logic equal_500_s21_q;
  logic whole_2_s21_q;
  logic so_s21_q;
  logic less_531_s21_q;
  logic less_532_s21_q;
  logic less_533_s21_q;
  logic less_534_s21_q;
  logic less_535_s21_q;
  logic less_536_s21_q;
  logic less_537_s21_q;
  logic less_538_s21_q;
  logic less_539_s21_q;
  logic less_540_s21_q;
  logic less_541_s21_q;
  logic less_542_s21_q;
  logic less_543_s21_q;
  logic less_544_s21_q;
  logic less_545_s21_q;
  logic less_546_s21_q;
  logic less_547_s21_q;
  logic less_548_s21_q;
  logic less_549_s21_q;
  logic less_550_s21_q;
  logic less_551_s21_q;
  logic less_552_s21_q;
  logic less_553_s21_q;
  logic less_554_s21_q;
  logic and_562_s21_q;
  logic and_566_s21_q;
  logic difference_589_s21_q;
  logic [8:0] xor_590_s21_q;
  logic difference_592_s21_q;
  logic [8:0] xor_593_s21_q;
  logic difference_596_s21_q;
  logic [8:0] xor_597_s21_q;
  logic difference_600_s21_q;
  logic [8:0] xor_601_s21_q;
  logic difference_604_s21_q;
  logic [8:0] xor_605_s21_q;
  logic equal_1466_s21_q;
  logic not_1467_s21_q;
  logic equal_1511_s21_q;
  logic [1:0] quarter_s21_q;
  logic all_s21_q;
  logic [1:0] sum_1517_s21_q;
  logic [3:0] select_1518_s21_q;
  logic equal_1519_s21_q;
  logic equal_1521_s21_q;
  logic equal_1523_s21_q;
  logic equal_1525_s21_q;
  logic equal_1527_s21_q;
  logic equal_1529_s21_q;
  logic equal_1531_s21_q;
  logic equal_1533_s21_q;
  logic less_1542_s21_q;
  logic or_1546_s21_q;
  logic select_1549_s21_q;
  logic and_1559_s21_q;
  logic [3:0] select_1564_s21_q;
  logic and_1579_s21_q;
  logic select_1596_s21_q;
  logic equal_1597_s21_q;
  logic and_1607_s21_q;
  logic equal_1612_s21_q;
  logic equal_1638_s21_q;
  logic equal_1672_s21_q;
  logic equal_1674_s21_q;
  logic equal_1676_s21_q;
  logic or_1678_s21_q;
  logic select_1688_s21_q;
  logic [7:0] sum_1692_s21_q;
  logic [4:0] select_1699_s21_q;
  logic select_1705_s21_q;
  logic [7:0] sum_1718_s21_q;
  logic equal_1732_s21_q;
  logic equal_1735_s21_q;
  logic [3:0] select_1739_s21_q;
  logic new_row_s21_q;
  logic [111:0] patches_right_codes_rdata_s21_q;
  logic less_1769_s21_q;
  logic less_1770_s21_q;
  logic less_1779_s21_q;
  logic less_1780_s21_q;
  logic and_1791_s21_q;
  logic [47:0] patches_left_codes_rdata_s21_q;
  logic or_1795_s21_q;
  logic and_1803_s21_q;
  logic less_1804_s21_q;
  logic equal_1805_s21_q;
  logic not_1806_s21_q;
  logic equal_1807_s21_q;
  logic or_1825_s21_q;
  logic or_1828_s21_q;
  logic or_1831_s21_q;
  logic not_1833_s21_q;
  logic [29:0] regions_rdata_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1854_s21_q;
  logic and_1859_s21_q;
  logic [2:0] textured_2_s21_q;
  logic or_1917_s21_q;
  logic or_1920_s21_q;
  logic or_1923_s21_q;
  logic [3:0] difference_1943_s21_q;
  logic [3:0] difference_1959_s21_q;
  logic and_1973_s21_q;
  logic sum_2008_s21_q;
  logic [9:0] difference_2009_s21_q;
  logic sum_2016_s21_q;
  logic [9:0] difference_2017_s21_q;
  logic difference_2088_s21_q;
  logic [8:0] xor_2089_s21_q;
  logic difference_2091_s21_q;
  logic [8:0] xor_2092_s21_q;
  logic difference_2095_s21_q;
  logic [8:0] xor_2096_s21_q;
  logic difference_2099_s21_q;
  logic [8:0] xor_2100_s21_q;
  logic difference_2103_s21_q;
  logic [8:0] xor_2104_s21_q;
  logic equal_2113_s21_q;
  logic difference_2134_s21_q;
  logic [8:0] xor_2135_s21_q;
  logic difference_2146_s21_q;
  logic [8:0] xor_2147_s21_q;
  logic equal_2237_s21_q;
  logic and_2353_s21_q;
  logic and_2357_s21_q;
  logic and_2362_s21_q;
  logic not_2376_s21_q;
  logic [3:0] difference_2386_s21_q;
  logic and_2466_s21_q;
  logic [11:0] select_2488_s21_q;
  logic equal_2537_s21_q;
  logic [3:0] not_2538_s21_q;
  logic [1:0] quarter_2_s21_q;
  logic equal_3173_s21_q;
  logic [4:0] select_3261_s21_q;
  logic [12:0] select_3292_s21_q;
  logic less_3335_s21_q;
  logic [9:0] eight_s21_q;
  logic [9:0] fall_s21_q;
  logic [7:0] select_3358_s21_q;
  logic sum_3359_s21_q;
  logic [6:0] sum_3361_s21_q;
  logic equal_3414_s21_q;
  logic and_3587_s21_q;
  logic equal_3605_s21_q;
  logic equal_3607_s21_q;
  logic equal_3608_s21_q;
  logic equal_3630_s21_q;
  logic [13:0] of_s21_q;
  logic equal_3737_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
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
      census_columns_values_0_cell_1_mask_s21_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s21_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s21_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s21_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s21_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s21_q <= x_s20_q;
      age_s21_q <= age_s20_q;
      slot_s21_q <= slot_s20_q;
      ends_cell_s21_q <= ends_cell_s20_q;
      lower_half_s21_q <= lower_half_s20_q;
      counts_textured_s21_q <= counts_textured_q;
      registration_of_right_s21_q <= registration_of_right_q;
      patches_lower_s21_q <= patches_lower_s20_q;
      patches_second_s21_q <= patches_second_s20_q;
      patches_code_row_s21_q <= patches_code_row_s20_q;
      patches_column_s21_q <= patches_column_s20_q;
      patches_summed_row_column_s21_q <= patches_summed_row_column_s20_q;
      patches_summed_last_s21_q <= patches_summed_last_s20_q;
      patches_summed_down_by_s21_q <= patches_summed_down_by_s20_q;
      patches_read_first_s21_q <= patches_read_first_s20_q;
      patches_read_far_s21_q <= patches_read_far_q;
      region_row_s21_q <= region_row_s20_q;
      region_fresh_s21_q <= region_fresh_s20_q;
      segment_started_s21_q <= segment_started_s20_q;
      centres_values_1_textured_s21_q <= centres_values_1_textured_s20_q;
      centres_values_1_of_skin_s21_q <= centres_values_1_of_skin_s20_q;
      select_458_s21_q <= select_458_s20_q;
      select_461_s21_q <= select_461_s20_q;
      column_s21_q <= column_s20_q;
      and_495_s21_q <= and_495_s20_q;
      and_497_s21_q <= and_497_s20_q;
      equal_500_s21_q <= equal_500_s20_q;
      whole_2_s21_q <= whole_2_s20_q;
      so_s21_q <= so_s20_q;
      less_531_s21_q <= less_531;
      less_532_s21_q <= less_532;
      less_533_s21_q <= less_533;
      less_534_s21_q <= less_534;
      less_535_s21_q <= less_535;
      less_536_s21_q <= less_536;
      less_537_s21_q <= less_537;
      less_538_s21_q <= less_538;
      less_539_s21_q <= less_539;
      less_540_s21_q <= less_540;
      less_541_s21_q <= less_541;
      less_542_s21_q <= less_542;
      less_543_s21_q <= less_543;
      less_544_s21_q <= less_544;
      less_545_s21_q <= less_545;
      less_546_s21_q <= less_546;
      less_547_s21_q <= less_547;
      less_548_s21_q <= less_548;
      less_549_s21_q <= less_549;
      less_550_s21_q <= less_550;
      less_551_s21_q <= less_551;
      less_552_s21_q <= less_552;
      less_553_s21_q <= less_553;
      less_554_s21_q <= less_554;
      and_562_s21_q <= select_560[4] & select_561[3];
      and_566_s21_q <= and_566;
      difference_589_s21_q <= difference_589[9];
      xor_590_s21_q <= difference_589[8:0] ^ {9{difference_589[9]}};
      difference_592_s21_q <= difference_592[9];
      xor_593_s21_q <= difference_592[8:0] ^ {9{difference_592[9]}};
      difference_596_s21_q <= difference_596[9];
      xor_597_s21_q <= difference_596[8:0] ^ {9{difference_596[9]}};
      difference_600_s21_q <= difference_600[9];
      xor_601_s21_q <= difference_600[8:0] ^ {9{difference_600[9]}};
      difference_604_s21_q <= difference_604[9];
      xor_605_s21_q <= difference_604[8:0] ^ {9{difference_604[9]}};
      equal_1466_s21_q <= equal_1466_s20_q;
      not_1467_s21_q <= not_1467_s20_q;
      equal_1511_s21_q <= equal_1511_s20_q;
      quarter_s21_q <= quarter;
      all_s21_q <= all_s20_q;
      sum_1517_s21_q <= sum_1517;
      select_1518_s21_q <= select_1518;
      equal_1519_s21_q <= equal_1519;
      equal_1521_s21_q <= equal_1521;
      equal_1523_s21_q <= equal_1523;
      equal_1525_s21_q <= equal_1525_s20_q;
      equal_1527_s21_q <= equal_1527_s20_q;
      equal_1529_s21_q <= equal_1529_s20_q;
      equal_1531_s21_q <= equal_1531_s20_q;
      equal_1533_s21_q <= equal_1533_s20_q;
      less_1542_s21_q <= less_1542;
      or_1546_s21_q <= or_1546;
      select_1549_s21_q <= equal_1511_s20_q ? and_1541 : (less_1542 & (~or_1546));
      and_1559_s21_q <= half_ends & ({{3{sum_1557[4]}}, sum_1557} < 8'h3);
      select_1564_s21_q <= select_1564;
      and_1579_s21_q <= and_1579_s20_q;
      select_1596_s21_q <= select_1596_s20_q;
      equal_1597_s21_q <= equal_1597_s20_q;
      and_1607_s21_q <= and_1607_s20_q;
      equal_1612_s21_q <= equal_1612_s20_q;
      equal_1638_s21_q <= equal_1638_s20_q;
      equal_1672_s21_q <= equal_1672_s20_q;
      equal_1674_s21_q <= equal_1674_s20_q;
      equal_1676_s21_q <= equal_1676_s20_q;
      or_1678_s21_q <= or_1678_s20_q;
      select_1688_s21_q <= select_1688_s20_q[0];
      sum_1692_s21_q <= select_1690 + {{2{select_1691[5]}}, select_1691};
      select_1699_s21_q <= select_1699_s20_q;
      select_1705_s21_q <= select_1705_s20_q;
      sum_1718_s21_q <= select_1716 + {{2{select_1717[5]}}, select_1717};
      equal_1732_s21_q <= equal_1732;
      equal_1735_s21_q <= equal_1735;
      select_1739_s21_q <= select_1739_s20_q;
      new_row_s21_q <= new_row_s20_q;
      patches_right_codes_rdata_s21_q <= patches_right_codes_rdata_q;
      less_1769_s21_q <= $signed(15'h100) < $signed(sum_1768);
      less_1770_s21_q <= $signed(sum_1768[14:8]) < $signed(7'h7f);
      less_1779_s21_q <= $signed(15'h100) < $signed(difference_1778_s20_q);
      less_1780_s21_q <= $signed(difference_1778_s20_q[14:8]) < $signed(7'h7f);
      and_1791_s21_q <= and_1791_s20_q;
      patches_left_codes_rdata_s21_q <= patches_left_codes_rdata_q;
      or_1795_s21_q <= or_1795_s20_q;
      and_1803_s21_q <= and_1803_s20_q;
      less_1804_s21_q <= less_1804_s20_q;
      equal_1805_s21_q <= equal_1805_s20_q;
      not_1806_s21_q <= not_1806_s20_q;
      equal_1807_s21_q <= equal_1807_s20_q;
      or_1825_s21_q <= or_1825_s20_q;
      or_1828_s21_q <= or_1828_s20_q;
      or_1831_s21_q <= or_1831_s20_q;
      not_1833_s21_q <= not_1833_s20_q;
      regions_rdata_s21_q <= regions_rdata_q;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1854_s21_q <= and_1854_s20_q;
      and_1859_s21_q <= and_1859_s20_q;
      textured_2_s21_q <= textured_2;
      or_1917_s21_q <= or_1917_s20_q;
      or_1920_s21_q <= or_1920_s20_q;
      or_1923_s21_q <= or_1923_s20_q;
      difference_1943_s21_q <= {1'b0, shown_2} - {1'b0, select_1942};
      difference_1959_s21_q <= {1'b0, near_2} - {1'b0, select_1958};
      and_1973_s21_q <= and_1973_s20_q;
      sum_2008_s21_q <= sum_2008[0];
      difference_2009_s21_q <= {1'b0, sum_2008[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2016_s21_q <= sum_2016[0];
      difference_2017_s21_q <= {1'b0, sum_2016[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2088_s21_q <= difference_2088[9];
      xor_2089_s21_q <= difference_2088[8:0] ^ {9{difference_2088[9]}};
      difference_2091_s21_q <= difference_2091[9];
      xor_2092_s21_q <= difference_2091[8:0] ^ {9{difference_2091[9]}};
      difference_2095_s21_q <= difference_2095[9];
      xor_2096_s21_q <= difference_2095[8:0] ^ {9{difference_2095[9]}};
      difference_2099_s21_q <= difference_2099[9];
      xor_2100_s21_q <= difference_2099[8:0] ^ {9{difference_2099[9]}};
      difference_2103_s21_q <= difference_2103[9];
      xor_2104_s21_q <= difference_2103[8:0] ^ {9{difference_2103[9]}};
      equal_2113_s21_q <= equal_2113_s20_q;
      difference_2134_s21_q <= difference_2134[9];
      xor_2135_s21_q <= difference_2134[8:0] ^ {9{difference_2134[9]}};
      difference_2146_s21_q <= difference_2146[9];
      xor_2147_s21_q <= difference_2146[8:0] ^ {9{difference_2146[9]}};
      equal_2237_s21_q <= equal_2237_s20_q;
      and_2353_s21_q <= and_2353;
      and_2357_s21_q <= and_2357_s20_q;
      and_2362_s21_q <= and_2362;
      not_2376_s21_q <= not_2376_s20_q;
      difference_2386_s21_q <= {1'b0, explained_2_s20_q} - {1'b0, select_2385};
      and_2466_s21_q <= not_1467_s20_q & (so_s20_q & (half_ends & equal_2463));
      select_2488_s21_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2537_s21_q <= sum_1517 == 2'h2;
      not_2538_s21_q <= ~select_1564;
      quarter_2_s21_q <= quarter_2;
      equal_3173_s21_q <= equal_3173_s20_q;
      select_3261_s21_q <= select_3261_s20_q;
      select_3292_s21_q <= select_3292_s20_q[12:0];
      less_3335_s21_q <= less_3335_s20_q;
      eight_s21_q <= eight;
      fall_s21_q <= fall;
      select_3358_s21_q <= select_3358;
      sum_3359_s21_q <= sum_3359[0];
      sum_3361_s21_q <= sum_3361;
      equal_3414_s21_q <= equal_3414;
      and_3587_s21_q <= equal_3586_s20_q & equal_3414;
      equal_3605_s21_q <= equal_3605;
      equal_3607_s21_q <= equal_3607_s20_q;
      equal_3608_s21_q <= equal_3608_s20_q;
      equal_3630_s21_q <= (limit & select_3628) == 8'h0;
      of_s21_q <= of;
      equal_3737_s21_q <= equal_3737_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [13:0] counts_explained_q;
  logic [3:0] registration_fresh_q;
  logic [51:0] patches_codes_low_q;
  logic [55:0] patches_codes_high_q;
  logic [47:0] patches_left_row_q;
  logic patches_summed_first_q;
  logic [9:0] patches_peak_far_q;
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
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_566_s21_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s21_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s21_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s21_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s21_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:270
  logic [9:0] sum_591;
  assign sum_591 = {9'h0, difference_589_s21_q} + {1'b0, xor_590_s21_q};
  logic [9:0] sum_594;
  assign sum_594 = {9'h0, difference_592_s21_q} + {1'b0, xor_593_s21_q};
  // hls/stages/patches.hpp:303
  logic and_1560;
  assign and_1560 = so_s21_q & and_1559_s21_q;
  // hls/stages/patches.hpp:288
  logic [7:0] sum_1693;
  assign sum_1693 = sum_1692_s21_q + 8'hff;
  // hls/stages/patches.hpp:109
  logic equal_1694;
  assign equal_1694 = {sum_1693[7], select_461_s21_q, select_458_s21_q} == {1'b0, sum_1693[6:0], 4'h8};
  // hls/stages/patches.hpp:288
  logic [7:0] sum_1719;
  assign sum_1719 = sum_1718_s21_q + 8'hff;
  // hls/stages/patches.hpp:109
  logic equal_1720;
  assign equal_1720 = {sum_1719[7], select_461_s21_q, select_458_s21_q} == {1'b0, sum_1719[6:0], 4'h8};
  // hls/stages/patches.hpp:423
  logic [2:0] sum_1760;
  assign sum_1760 = patches_code_row_s21_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:427
  logic [1:0] sum_1793;
  assign sum_1793 = patches_code_row_s21_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1844;
  assign select_1844 = segment_started_s21_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1845;
  assign sum_1845 = {6'h0, textured_s21_q} + select_1844;
  // hls/stages/agreement.hpp:1002
  logic [9:0] sum_1847;
  assign sum_1847 = {3'h0, sum_1845} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1849;
  assign select_1849 = segment_started_s21_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1850;
  assign sum_1850 = {6'h0, explained_s21_q} + select_1849;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1852;
  assign sum_1852 = {3'h0, sum_1850} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1855;
  assign select_1855 = segment_started_s21_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_1856;
  assign sum_1856 = {6'h0, and_1854_s21_q} + select_1855;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1858;
  assign sum_1858 = {3'h0, sum_1856} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[29:20]);
  // hls/stages/agreement.hpp:1200
  logic or_1868;
  assign or_1868 = marks_first_s21_q | line_ended_q;
  // hls/stages/agreement.hpp:1202
  logic [12:0] select_1870;
  assign select_1870 = marks_first_s21_q ? 13'h1 : (or_1868 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1201
  logic [8:0] select_1872;
  assign select_1872 = or_1868 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1209
  logic select_1874;
  assign select_1874 = cfg_compete_i ? (or_1868 & select_1870[12]) : (select_1872[8] & select_1870[9]);
  // hls/stages/agreement.hpp:1035
  logic [2:0] select_1908;
  assign select_1908 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1037
  logic [4:0] around;
  assign around = {difference_1943_s21_q[3], difference_1943_s21_q} + (equal_1612_s21_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1038
  logic [4:0] n;
  assign n = {difference_1959_s21_q[3], difference_1959_s21_q} + (equal_1612_s21_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:209
  logic [9:0] xor_2010;
  assign xor_2010 = {difference_2009_s21_q[8:0], sum_2008_s21_q} ^ {10{difference_2009_s21_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2009_s21_q[9]} + {1'b0, xor_2010};
  logic [9:0] xor_2018;
  assign xor_2018 = {difference_2017_s21_q[8:0], sum_2016_s21_q} ^ {10{difference_2017_s21_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2017_s21_q[9]} + {1'b0, xor_2018};
  // hls/stages/agreement.hpp:507
  logic select_2033;
  assign select_2033 = and_497_s21_q ? whole_2_s21_q : census_columns_values_0_cell_0_mask_q;
  logic select_2049;
  assign select_2049 = and_497_s21_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2052;
  assign select_2052 = and_497_s21_q ? census_columns_values_0_cell_1_mask_s21_q : census_columns_values_1_cell_1_mask_q;
  logic select_2055;
  assign select_2055 = and_497_s21_q ? census_columns_values_0_cell_2_mask_s21_q : census_columns_values_1_cell_2_mask_q;
  logic select_2059;
  assign select_2059 = and_497_s21_q ? census_columns_values_0_cell_3_mask_s21_q : census_columns_values_1_cell_3_mask_q;
  logic select_2062;
  assign select_2062 = and_497_s21_q ? census_columns_values_0_cell_4_mask_s21_q : census_columns_values_1_cell_4_mask_q;
  logic select_2065;
  assign select_2065 = and_497_s21_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2068;
  assign select_2068 = and_497_s21_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_2090;
  assign sum_2090 = {9'h0, difference_2088_s21_q} + {1'b0, xor_2089_s21_q};
  logic [9:0] sum_2093;
  assign sum_2093 = {9'h0, difference_2091_s21_q} + {1'b0, xor_2092_s21_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2134_s21_q} + xor_2135_s21_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2146_s21_q} + xor_2147_s21_q;
  // hls/stages/patches.hpp:303
  logic and_2367;
  assign and_2367 = not_1467_s21_q & (so_s21_q & (ends_cell_s21_q & explained_s21_q));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2369;
  assign select_2369 = and_2353_s21_q ? 14'h0 : (counts_explained_q + {13'h0, and_2367});
  // hls/stages/patches.hpp:303
  logic and_2372;
  assign and_2372 = not_1467_s21_q & (so_s21_q & (ends_cell_s21_q & and_1854_s21_q));
  // hls/stages/agreement.hpp:1036
  logic [4:0] e;
  assign e = {difference_2386_s21_q[3], difference_2386_s21_q} + (equal_1612_s21_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1073
  logic less_2401;
  assign less_2401 = region_row_s21_q < x_s21_q[5:3];
  // hls/stages/registration.hpp:215
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2488_s21_q[11:7])) ? 12'h7f : select_2488_s21_q;
  // hls/stages/registration.hpp:266
  logic [3:0] select_2540;
  assign select_2540 = equal_2537_s21_q ? (registration_fresh_q & not_2538_s21_q) : registration_fresh_q;
  // hls/stages/patches.hpp:303
  logic [3:0] select_2542;
  assign select_2542 = so_s21_q ? (and_1559_s21_q ? select_2540 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:239
  logic [3:0] select_2544;
  assign select_2544 = and_2353_s21_q ? 4'hf : (equal_1466_s21_q ? registration_fresh_q : select_2542);
  // hls/stages/registration.hpp:255
  logic not_2565;
  assign not_2565 = ~quarter_2_s21_q[1];
  logic [3:0] select_2566;
  assign select_2566 = quarter_2_s21_q[0] ? {quarter_2_s21_q[1], 1'b0, not_2565, 1'b0} : {1'b0, quarter_2_s21_q[1], 1'b0, not_2565};
  // hls/stages/patches.hpp:443
  logic [55:0] other;
  assign other = new_row_s21_q ? patches_right_codes_rdata_s21_q[55:0] : {patches_codes_high_q[3:0], patches_codes_low_q};
  // hls/stages/patches.hpp:160
  logic [51:0] select_2828;
  assign select_2828 = or_1678_s21_q ? {patches_codes_high_q[3:0], patches_codes_low_q[51:4]} : patches_codes_low_q;
  logic [51:0] select_2830;
  assign select_2830 = equal_1672_s21_q ? patches_codes_low_q : (equal_1674_s21_q ? other[55:4] : select_2828);
  // hls/stages/patches.hpp:443
  logic [55:0] select_2831;
  assign select_2831 = new_row_s21_q ? patches_right_codes_rdata_s21_q[111:56] : {4'h0, patches_codes_high_q[55:4]};
  // hls/stages/patches.hpp:160
  logic [55:0] select_2832;
  assign select_2832 = or_1678_s21_q ? {less_1780_s21_q, less_1779_s21_q, less_1770_s21_q, less_1769_s21_q, patches_codes_high_q[55:4]} : patches_codes_high_q;
  logic [55:0] select_2834;
  assign select_2834 = equal_1672_s21_q ? patches_codes_high_q : (equal_1674_s21_q ? select_2831 : select_2832);
  // hls/stages/count_bits.hpp:24
  logic parity_2839;
  assign parity_2839 = ^{less_1780_s21_q, less_1779_s21_q, less_1770_s21_q, less_1769_s21_q};
  // hls/stages/count_bits.hpp:25
  logic or_2843;
  assign or_2843 = ({less_1770_s21_q, less_1769_s21_q} == 2'h3) | (less_1779_s21_q & (less_1770_s21_q | less_1769_s21_q));
  logic and_2844;
  assign and_2844 = less_1780_s21_q & (^{less_1779_s21_q, less_1770_s21_q, less_1769_s21_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2845;
  assign xor_2845 = or_2843 ^ and_2844;
  // hls/stages/count_bits.hpp:27
  logic and_2846;
  assign and_2846 = or_2843 & and_2844;
  // hls/stages/patches.hpp:429
  logic [2:0] select_2848;
  assign select_2848 = or_1795_s21_q ? 3'h0 : (patches_column_s21_q ? 3'h0 : {and_2846, xor_2845, parity_2839});
  // hls/stages/patches.hpp:444
  logic [47:0] select_2863;
  assign select_2863 = new_row_s21_q ? patches_left_codes_rdata_s21_q : patches_left_row_q;
  // hls/stages/patches.hpp:160
  logic [47:0] select_2865;
  assign select_2865 = equal_1672_s21_q ? patches_left_row_q : (equal_1674_s21_q ? select_2863 : patches_left_row_q);
  // hls/stages/patches.hpp:444
  logic [47:0] bits;
  assign bits = select_2863 ^ other[47:0];
  // hls/stages/patches.hpp:160
  logic select_3213;
  assign select_3213 = equal_1672_s21_q ? patches_summed_first_q : (equal_1674_s21_q ? new_row_s21_q : patches_summed_first_q);
  // hls/stages/patches.hpp:463
  logic [9:0] select_3301;
  assign select_3301 = (patches_read_far_s21_q < patches_peak_far_q) ? patches_read_far_s21_q : patches_peak_far_q;
  logic [9:0] select_3302;
  assign select_3302 = patches_read_first_s21_q ? patches_read_far_s21_q : select_3301;
  // hls/stages/patches.hpp:503
  logic [10:0] sum_3344;
  assign sum_3344 = {1'b0, fall_s21_q} + {2'h0, fall_s21_q[9:1]};
  // hls/stages/patches.hpp:504
  logic [10:0] sum_3348;
  assign sum_3348 = {1'b0, fall_s21_q} + {3'h0, fall_s21_q[9:2]};
  logic not_3353;
  assign not_3353 = ~({eight_s21_q, 3'h0} < ({fall_s21_q, 3'h0} - {3'h0, fall_s21_q}));
  // hls/stages/patches.hpp:517
  logic [18:0] product_3362;
  assign product_3362 = $signed({{11{select_3358_s21_q[7]}}, select_3358_s21_q}) * $signed({{8{sum_3361_s21_q[6]}}, sum_3361_s21_q, sum_3359_s21_q, select_3292_s21_q[12:10]});
  // hls/stages/agreement.hpp:1160
  logic [13:0] select_3619;
  assign select_3619 = equal_3414_s21_q ? 14'h0 : product_q;
  logic [13:0] select_3634;
  assign select_3634 = equal_3630_s21_q ? 14'h0 : of_s21_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3619} + {1'b0, select_3634};
  // hls/stages/patches.hpp:303
  logic [2:0] select_3652;
  assign select_3652 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_3654;
  assign select_3654 = equal_1466_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_3652 : box_textured_columns_values_0_q);
  logic [2:0] select_3655;
  assign select_3655 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3657;
  assign select_3657 = equal_1466_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_3655 : box_textured_columns_values_1_q);
  logic [2:0] select_3658;
  assign select_3658 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3660;
  assign select_3660 = equal_1466_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_3658 : box_textured_columns_values_2_q);
  logic [2:0] select_3661;
  assign select_3661 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3663;
  assign select_3663 = equal_1466_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_3661 : box_textured_columns_values_3_q);
  logic [2:0] select_3664;
  assign select_3664 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3666;
  assign select_3666 = equal_1466_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_3664 : box_textured_columns_values_4_q);
  logic [4:0] select_3686;
  assign select_3686 = so_s21_q ? (ends_cell_s21_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3687;
  assign select_3687 = equal_1466_s21_q ? box_explained_sum_sums_values_0_q : select_3686;
  logic [4:0] select_3704;
  assign select_3704 = so_s21_q ? (ends_cell_s21_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_3722;
  assign select_3722 = so_s21_q ? (ends_cell_s21_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/registration.hpp:255
  logic not_3819;
  assign not_3819 = ~quarter_s21_q[1];
  logic [3:0] select_3820;
  assign select_3820 = quarter_s21_q[0] ? {quarter_s21_q[1], 1'b0, not_3819, 1'b0} : {1'b0, quarter_s21_q[1], 1'b0, not_3819};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:273; read in stage 21, written in stage 25: 21 < 25 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1518_s21_q;
  logic registration_sums_re;
  assign registration_sums_re = s21_en & (equal_1466_s21_q ? (x_s21_q[6] & select_1549_s21_q) : and_1560);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_right_codes, write
  logic [4:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1760, patches_code_row_s21_q[1:0]};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s21_en & and_1791_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1780_s21_q, less_1779_s21_q, less_1770_s21_q, less_1769_s21_q, patches_codes_high_q, patches_codes_low_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_right_codes_raddr_s20_sim;
  logic patches_right_codes_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_codes_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_codes_re_s20_sim <= patches_right_codes_re;
      patches_right_codes_raddr_s20_sim <= patches_right_codes_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s20_sim && patches_right_codes_raddr_s20_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 5'd28) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 5'd28) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1793, patches_code_row_s21_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s21_en & and_1803_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1780_s21_q, less_1779_s21_q, less_1770_s21_q, less_1769_s21_q, patches_codes_high_q[55:12]};
  end
`ifndef SYNTHESIS
  logic [3:0] patches_left_codes_raddr_s20_sim;
  logic patches_left_codes_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_codes_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_codes_re_s20_sim <= patches_left_codes_re;
      patches_left_codes_raddr_s20_sim <= patches_left_codes_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s20_sim && patches_left_codes_raddr_s20_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_explained_q <= 14'h0;
      registration_fresh_q <= 4'hf;
      patches_codes_low_q <= 52'h0;
      patches_codes_high_q <= 56'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_first_q <= 1'b0;
      patches_peak_far_q <= 10'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s21_en) begin
      counts_explained_q <= select_2369;
      registration_fresh_q <= select_2544;
      patches_codes_low_q <= select_2830;
      patches_codes_high_q <= select_2834;
      patches_left_row_q <= select_2865;
      patches_summed_first_q <= select_3213;
      patches_peak_far_q <= equal_1672_s21_q ? select_3302 : patches_peak_far_q;
      segment_textured_q <= select_1844 + {6'h0, and_2362_s21_q};
      segment_explained_q <= select_1849 + {6'h0, and_2367};
      segment_nearer_q <= select_1855 + {6'h0, and_2372};
      product_q <= equal_1466_s21_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_1870;
      columns_passed_q <= {select_1872[7:0], or_1868};
      line_ended_q <= marks_last_s21_q;
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
      census_columns_values_0_cell_0_mask_q <= select_2033;
      census_columns_values_1_cell_0_mask_q <= select_2049;
      census_columns_values_1_cell_1_mask_q <= select_2052;
      census_columns_values_1_cell_2_mask_q <= select_2055;
      census_columns_values_1_cell_3_mask_q <= select_2059;
      census_columns_values_1_cell_4_mask_q <= select_2062;
      census_columns_values_2_cell_0_mask_q <= select_2065;
      census_columns_values_2_cell_1_mask_q <= select_2068;
      box_textured_columns_values_0_q <= select_3654;
      box_textured_columns_values_1_q <= select_3657;
      box_textured_columns_values_2_q <= select_3660;
      box_textured_columns_values_3_q <= select_3663;
      box_textured_columns_values_4_q <= select_3666;
      box_explained_sum_sums_values_0_q <= select_3687;
      box_shown_sum_sums_values_0_q <= equal_1466_s21_q ? box_shown_sum_sums_values_0_q : select_3704;
      box_nearer_sum_sums_values_0_q <= equal_1466_s21_q ? box_nearer_sum_sums_values_0_q : select_3722;
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
  logic census_columns_values_1_cell_2_mask_s22_q;
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic census_columns_values_1_cell_3_mask_s22_q;
  logic census_columns_values_1_cell_4_mask_s22_q;
  logic census_columns_values_2_cell_0_mask_s22_q;
  logic census_columns_values_2_cell_1_mask_s22_q;
  logic [7:0] x_s22_q;
  logic [2:0] slot_s22_q;
  logic ends_cell_s22_q;
  logic lower_half_s22_q;
  logic [13:0] counts_textured_s22_q;
  logic [13:0] counts_explained_s22_q;
  logic registration_of_right_s22_q;
  logic patches_lower_s22_q;
  logic patches_second_s22_q;
  logic [4:0] patches_summed_row_column_s22_q;
  logic patches_summed_first_s22_q;
  logic patches_summed_last_s22_q;
  logic [4:0] patches_summed_down_by_s22_q;
  logic [2:0] region_row_s22_q;
  logic [13:0] product_s22_q;
  logic centres_values_1_textured_s22_q;
  logic centres_values_1_of_skin_s22_q;
  logic [6:0] column_s22_q;
  logic and_495_s22_q;
  logic and_497_s22_q;
  logic equal_500_s22_q;
  logic whole_2_s22_q;
  logic so_s22_q;
  logic less_531_s22_q;
  logic less_532_s22_q;
  logic less_533_s22_q;
  logic less_534_s22_q;
  logic less_535_s22_q;
  logic less_536_s22_q;
  logic less_537_s22_q;
  logic less_538_s22_q;
  logic less_539_s22_q;
  logic less_540_s22_q;
  logic less_541_s22_q;
  logic less_542_s22_q;
  logic less_543_s22_q;
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
  logic and_562_s22_q;
  logic whole_9_s22_q;
  logic [10:0] sum_595_s22_q;
  logic [9:0] sum_598_s22_q;
  logic [9:0] sum_602_s22_q;
  logic [9:0] sum_606_s22_q;
  logic equal_1466_s22_q;
  logic not_1467_s22_q;
  logic equal_1511_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1517_s22_q;
  logic equal_1519_s22_q;
  logic equal_1521_s22_q;
  logic equal_1523_s22_q;
  logic equal_1525_s22_q;
  logic equal_1527_s22_q;
  logic equal_1529_s22_q;
  logic equal_1531_s22_q;
  logic equal_1533_s22_q;
  logic less_1542_s22_q;
  logic or_1546_s22_q;
  logic equal_1566_s22_q;
  logic and_1576_s22_q;
  logic and_1579_s22_q;
  logic select_1596_s22_q;
  logic equal_1597_s22_q;
  logic and_1607_s22_q;
  logic equal_1612_s22_q;
  logic equal_1638_s22_q;
  logic equal_1672_s22_q;
  logic equal_1674_s22_q;
  logic equal_1676_s22_q;
  logic select_1688_s22_q;
  logic equal_1694_s22_q;
  logic [4:0] select_1699_s22_q;
  logic select_1705_s22_q;
  logic equal_1720_s22_q;
  logic or_1733_s22_q;
  logic or_1736_s22_q;
  logic [3:0] select_1739_s22_q;
  logic less_1804_s22_q;
  logic equal_1805_s22_q;
  logic not_1806_s22_q;
  logic equal_1807_s22_q;
  logic or_1825_s22_q;
  logic or_1828_s22_q;
  logic or_1831_s22_q;
  logic not_1833_s22_q;
  logic [9:0] sum_1847_s22_q;
  logic [9:0] sum_1852_s22_q;
  logic [9:0] sum_1858_s22_q;
  logic and_1859_s22_q;
  logic select_1874_s22_q;
  logic [3:0] difference_1909_s22_q;
  logic or_1917_s22_q;
  logic or_1920_s22_q;
  logic or_1923_s22_q;
  logic [4:0] around_s22_q;
  logic less_1962_s22_q;
  logic and_1973_s22_q;
  logic [10:0] size_s22_q;
  logic [10:0] size_2_s22_q;
  logic [10:0] sum_2094_s22_q;
  logic [9:0] sum_2097_s22_q;
  logic [9:0] sum_2101_s22_q;
  logic [9:0] sum_2105_s22_q;
  logic equal_2113_s22_q;
  logic [8:0] contrast_s22_q;
  logic [8:0] contrast_2_s22_q;
  logic equal_2237_s22_q;
  logic and_2353_s22_q;
  logic and_2357_s22_q;
  logic and_2372_s22_q;
  logic not_2376_s22_q;
  logic [4:0] e_s22_q;
  logic [9:0] select_2402_s22_q;
  logic [9:0] select_2405_s22_q;
  logic and_2466_s22_q;
  logic [11:0] residual_s22_q;
  logic equal_2568_s22_q;
  logic [20:0] other_s22_q;
  logic [2:0] select_2849_s22_q;
  logic [20:0] select_2863_s22_q;
  logic bits_s22_q;
  logic xor_2869_s22_q;
  logic xor_2872_s22_q;
  logic xor_2875_s22_q;
  logic parity_2877_s22_q;
  logic xor_2881_s22_q;
  logic xor_2887_s22_q;
  logic xor_2890_s22_q;
  logic xor_2899_s22_q;
  logic xor_2902_s22_q;
  logic xor_2905_s22_q;
  logic xor_2911_s22_q;
  logic xor_2914_s22_q;
  logic xor_2917_s22_q;
  logic parity_2919_s22_q;
  logic xor_2923_s22_q;
  logic xor_2926_s22_q;
  logic xor_2929_s22_q;
  logic parity_2931_s22_q;
  logic equal_2942_s22_q;
  logic and_2944_s22_q;
  logic equal_2953_s22_q;
  logic and_2955_s22_q;
  logic equal_2957_s22_q;
  logic and_2959_s22_q;
  logic equal_2961_s22_q;
  logic and_2963_s22_q;
  logic equal_2968_s22_q;
  logic and_2970_s22_q;
  logic equal_2972_s22_q;
  logic and_2974_s22_q;
  logic equal_2976_s22_q;
  logic and_2978_s22_q;
  logic equal_2986_s22_q;
  logic and_2988_s22_q;
  logic equal_2990_s22_q;
  logic and_2992_s22_q;
  logic equal_2994_s22_q;
  logic and_2996_s22_q;
  logic equal_3001_s22_q;
  logic not_3003_s22_q;
  logic equal_3006_s22_q;
  logic and_3008_s22_q;
  logic equal_3010_s22_q;
  logic and_3012_s22_q;
  logic equal_3017_s22_q;
  logic and_3019_s22_q;
  logic equal_3021_s22_q;
  logic and_3023_s22_q;
  logic equal_3025_s22_q;
  logic and_3027_s22_q;
  logic equal_3173_s22_q;
  logic [4:0] select_3261_s22_q;
  logic [9:0] select_3292_s22_q;
  logic [9:0] select_3302_s22_q;
  logic less_3335_s22_q;
  logic not_3343_s22_q;
  logic not_3346_s22_q;
  logic not_3350_s22_q;
  logic not_3353_s22_q;
  logic [13:0] product_3362_s22_q;
  logic equal_3414_s22_q;
  logic and_3587_s22_q;
  logic less_3588_s22_q;
  logic equal_3589_s22_q;
  logic equal_3605_s22_q;
  logic equal_3607_s22_q;
  logic equal_3608_s22_q;
  logic sum_4_s22_q;
  logic equal_3737_s22_q;
  logic equal_3822_s22_q;
  logic [9:0] select_3832_s22_q;
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
      census_columns_values_1_cell_2_mask_s22_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_s21_q;
      census_columns_values_1_cell_3_mask_s22_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s22_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s22_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s22_q <= census_columns_values_2_cell_1_mask_q;
      x_s22_q <= x_s21_q;
      slot_s22_q <= slot_s21_q;
      ends_cell_s22_q <= ends_cell_s21_q;
      lower_half_s22_q <= lower_half_s21_q;
      counts_textured_s22_q <= counts_textured_s21_q;
      counts_explained_s22_q <= counts_explained_q;
      registration_of_right_s22_q <= registration_of_right_s21_q;
      patches_lower_s22_q <= patches_lower_s21_q;
      patches_second_s22_q <= patches_second_s21_q;
      patches_summed_row_column_s22_q <= patches_summed_row_column_s21_q;
      patches_summed_first_s22_q <= patches_summed_first_q;
      patches_summed_last_s22_q <= patches_summed_last_s21_q;
      patches_summed_down_by_s22_q <= patches_summed_down_by_s21_q;
      region_row_s22_q <= region_row_s21_q;
      product_s22_q <= product_q;
      centres_values_1_textured_s22_q <= centres_values_1_textured_s21_q;
      centres_values_1_of_skin_s22_q <= centres_values_1_of_skin_s21_q;
      column_s22_q <= column_s21_q;
      and_495_s22_q <= and_495_s21_q;
      and_497_s22_q <= and_497_s21_q;
      equal_500_s22_q <= equal_500_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      so_s22_q <= so_s21_q;
      less_531_s22_q <= less_531_s21_q;
      less_532_s22_q <= less_532_s21_q;
      less_533_s22_q <= less_533_s21_q;
      less_534_s22_q <= less_534_s21_q;
      less_535_s22_q <= less_535_s21_q;
      less_536_s22_q <= less_536_s21_q;
      less_537_s22_q <= less_537_s21_q;
      less_538_s22_q <= less_538_s21_q;
      less_539_s22_q <= less_539_s21_q;
      less_540_s22_q <= less_540_s21_q;
      less_541_s22_q <= less_541_s21_q;
      less_542_s22_q <= less_542_s21_q;
      less_543_s22_q <= less_543_s21_q;
      less_544_s22_q <= less_544_s21_q;
      less_545_s22_q <= less_545_s21_q;
      less_546_s22_q <= less_546_s21_q;
      less_547_s22_q <= less_547_s21_q;
      less_548_s22_q <= less_548_s21_q;
      less_549_s22_q <= less_549_s21_q;
      less_550_s22_q <= less_550_s21_q;
      less_551_s22_q <= less_551_s21_q;
      less_552_s22_q <= less_552_s21_q;
      less_553_s22_q <= less_553_s21_q;
      less_554_s22_q <= less_554_s21_q;
      and_562_s22_q <= and_562_s21_q;
      whole_9_s22_q <= whole_9;
      sum_595_s22_q <= {1'b0, sum_591} + {1'b0, sum_594};
      sum_598_s22_q <= {9'h0, difference_596_s21_q} + {1'b0, xor_597_s21_q};
      sum_602_s22_q <= {9'h0, difference_600_s21_q} + {1'b0, xor_601_s21_q};
      sum_606_s22_q <= {9'h0, difference_604_s21_q} + {1'b0, xor_605_s21_q};
      equal_1466_s22_q <= equal_1466_s21_q;
      not_1467_s22_q <= not_1467_s21_q;
      equal_1511_s22_q <= equal_1511_s21_q;
      all_s22_q <= all_s21_q;
      sum_1517_s22_q <= sum_1517_s21_q;
      equal_1519_s22_q <= equal_1519_s21_q;
      equal_1521_s22_q <= equal_1521_s21_q;
      equal_1523_s22_q <= equal_1523_s21_q;
      equal_1525_s22_q <= equal_1525_s21_q;
      equal_1527_s22_q <= equal_1527_s21_q;
      equal_1529_s22_q <= equal_1529_s21_q;
      equal_1531_s22_q <= equal_1531_s21_q;
      equal_1533_s22_q <= equal_1533_s21_q;
      less_1542_s22_q <= less_1542_s21_q;
      or_1546_s22_q <= or_1546_s21_q;
      equal_1566_s22_q <= (registration_fresh_q & select_1564_s21_q) == 4'h0;
      and_1576_s22_q <= not_1467_s21_q & and_1560;
      and_1579_s22_q <= and_1579_s21_q;
      select_1596_s22_q <= select_1596_s21_q;
      equal_1597_s22_q <= equal_1597_s21_q;
      and_1607_s22_q <= and_1607_s21_q;
      equal_1612_s22_q <= equal_1612_s21_q;
      equal_1638_s22_q <= equal_1638_s21_q;
      equal_1672_s22_q <= equal_1672_s21_q;
      equal_1674_s22_q <= equal_1674_s21_q;
      equal_1676_s22_q <= equal_1676_s21_q;
      select_1688_s22_q <= select_1688_s21_q;
      equal_1694_s22_q <= equal_1694;
      select_1699_s22_q <= select_1699_s21_q;
      select_1705_s22_q <= select_1705_s21_q;
      equal_1720_s22_q <= equal_1720;
      or_1733_s22_q <= and_1579_s21_q | equal_1732_s21_q;
      or_1736_s22_q <= and_1579_s21_q | equal_1735_s21_q;
      select_1739_s22_q <= select_1739_s21_q;
      less_1804_s22_q <= less_1804_s21_q;
      equal_1805_s22_q <= equal_1805_s21_q;
      not_1806_s22_q <= not_1806_s21_q;
      equal_1807_s22_q <= equal_1807_s21_q;
      or_1825_s22_q <= or_1825_s21_q;
      or_1828_s22_q <= or_1828_s21_q;
      or_1831_s22_q <= or_1831_s21_q;
      not_1833_s22_q <= not_1833_s21_q;
      sum_1847_s22_q <= sum_1847;
      sum_1852_s22_q <= sum_1852;
      sum_1858_s22_q <= sum_1858;
      and_1859_s22_q <= and_1859_s21_q;
      select_1874_s22_q <= select_1874;
      difference_1909_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1908};
      or_1917_s22_q <= or_1917_s21_q;
      or_1920_s22_q <= or_1920_s21_q;
      or_1923_s22_q <= or_1923_s21_q;
      around_s22_q <= around;
      less_1962_s22_q <= {1'b0, around[4:1]} < n;
      and_1973_s22_q <= and_1973_s21_q;
      size_s22_q <= size;
      size_2_s22_q <= size_2;
      sum_2094_s22_q <= {1'b0, sum_2090} + {1'b0, sum_2093};
      sum_2097_s22_q <= {9'h0, difference_2095_s21_q} + {1'b0, xor_2096_s21_q};
      sum_2101_s22_q <= {9'h0, difference_2099_s21_q} + {1'b0, xor_2100_s21_q};
      sum_2105_s22_q <= {9'h0, difference_2103_s21_q} + {1'b0, xor_2104_s21_q};
      equal_2113_s22_q <= equal_2113_s21_q;
      contrast_s22_q <= contrast;
      contrast_2_s22_q <= contrast_2;
      equal_2237_s22_q <= equal_2237_s21_q;
      and_2353_s22_q <= and_2353_s21_q;
      and_2357_s22_q <= and_2357_s21_q;
      and_2372_s22_q <= and_2372;
      not_2376_s22_q <= not_2376_s21_q;
      e_s22_q <= e;
      select_2402_s22_q <= less_2401 ? 10'h0 : regions_rdata_s21_q[9:0];
      select_2405_s22_q <= less_2401 ? 10'h0 : regions_rdata_s21_q[19:10];
      and_2466_s22_q <= and_2466_s21_q;
      residual_s22_q <= residual;
      equal_2568_s22_q <= (registration_fresh_q & select_2566) == 4'h0;
      other_s22_q <= {other[47:36], other[8:0]};
      select_2849_s22_q <= or_1678_s21_q ? select_2848 : 3'h0;
      select_2863_s22_q <= {select_2863[47:36], select_2863[8:0]};
      bits_s22_q <= bits[8];
      xor_2869_s22_q <= bits[17] ^ (^{select_2863[16:15], other[16:15]});
      xor_2872_s22_q <= bits[11] ^ (^{select_2863[10:9], other[10:9]});
      xor_2875_s22_q <= bits[14] ^ (^{select_2863[13:12], other[13:12]});
      parity_2877_s22_q <= ^{select_2863[14:9], other[14:9]};
      xor_2881_s22_q <= bits[47] ^ (^{select_2863[46:45], other[46:45]});
      xor_2887_s22_q <= bits[2] ^ (^{select_2863[1:0], other[1:0]});
      xor_2890_s22_q <= bits[5] ^ (^{select_2863[4:3], other[4:3]});
      xor_2899_s22_q <= bits[44] ^ (^{select_2863[43:42], other[43:42]});
      xor_2902_s22_q <= bits[38] ^ (^{select_2863[37:36], other[37:36]});
      xor_2905_s22_q <= bits[41] ^ (^{select_2863[40:39], other[40:39]});
      xor_2911_s22_q <= bits[26] ^ (^{select_2863[25:24], other[25:24]});
      xor_2914_s22_q <= bits[20] ^ (^{select_2863[19:18], other[19:18]});
      xor_2917_s22_q <= bits[23] ^ (^{select_2863[22:21], other[22:21]});
      parity_2919_s22_q <= ^{select_2863[23:18], other[23:18]};
      xor_2923_s22_q <= bits[35] ^ (^{select_2863[34:33], other[34:33]});
      xor_2926_s22_q <= bits[29] ^ (^{select_2863[28:27], other[28:27]});
      xor_2929_s22_q <= bits[32] ^ (^{select_2863[31:30], other[31:30]});
      parity_2931_s22_q <= ^{select_2863[32:27], other[32:27]};
      equal_2942_s22_q <= bits[46:45] == 2'h3;
      and_2944_s22_q <= bits[47] & (bits[45] | bits[46]);
      equal_2953_s22_q <= bits[34:33] == 2'h3;
      and_2955_s22_q <= bits[35] & (bits[33] | bits[34]);
      equal_2957_s22_q <= bits[28:27] == 2'h3;
      and_2959_s22_q <= bits[29] & (bits[27] | bits[28]);
      equal_2961_s22_q <= bits[31:30] == 2'h3;
      and_2963_s22_q <= bits[32] & (bits[30] | bits[31]);
      equal_2968_s22_q <= bits[43:42] == 2'h3;
      and_2970_s22_q <= bits[44] & (bits[42] | bits[43]);
      equal_2972_s22_q <= bits[37:36] == 2'h3;
      and_2974_s22_q <= bits[38] & (bits[36] | bits[37]);
      equal_2976_s22_q <= bits[40:39] == 2'h3;
      and_2978_s22_q <= bits[41] & (bits[39] | bits[40]);
      equal_2986_s22_q <= bits[25:24] == 2'h3;
      and_2988_s22_q <= bits[26] & (bits[24] | bits[25]);
      equal_2990_s22_q <= bits[19:18] == 2'h3;
      and_2992_s22_q <= bits[20] & (bits[18] | bits[19]);
      equal_2994_s22_q <= bits[22:21] == 2'h3;
      and_2996_s22_q <= bits[23] & (bits[21] | bits[22]);
      equal_3001_s22_q <= bits[7:6] == 2'h3;
      not_3003_s22_q <= ~(bits[7:6] == 2'h0);
      equal_3006_s22_q <= bits[1:0] == 2'h3;
      and_3008_s22_q <= bits[2] & (bits[0] | bits[1]);
      equal_3010_s22_q <= bits[4:3] == 2'h3;
      and_3012_s22_q <= bits[5] & (bits[3] | bits[4]);
      equal_3017_s22_q <= bits[16:15] == 2'h3;
      and_3019_s22_q <= bits[17] & (bits[15] | bits[16]);
      equal_3021_s22_q <= bits[10:9] == 2'h3;
      and_3023_s22_q <= bits[11] & (bits[9] | bits[10]);
      equal_3025_s22_q <= bits[13:12] == 2'h3;
      and_3027_s22_q <= bits[14] & (bits[12] | bits[13]);
      equal_3173_s22_q <= equal_3173_s21_q;
      select_3261_s22_q <= select_3261_s21_q;
      select_3292_s22_q <= select_3292_s21_q[9:0];
      select_3302_s22_q <= select_3302;
      less_3335_s22_q <= less_3335_s21_q;
      not_3343_s22_q <= ~({eight_s21_q, 3'h0} < {3'h0, fall_s21_q});
      not_3346_s22_q <= ~({eight_s21_q, 3'h0} < {1'b0, sum_3344, fall_s21_q[0]});
      not_3350_s22_q <= ~({eight_s21_q, 3'h0} < {sum_3348, fall_s21_q[1:0]});
      not_3353_s22_q <= not_3353;
      product_3362_s22_q <= product_3362[18:5];
      equal_3414_s22_q <= equal_3414_s21_q;
      and_3587_s22_q <= and_3587_s21_q;
      less_3588_s22_q <= counts_explained_q < product_q;
      equal_3589_s22_q <= counts_explained_q == product_q;
      equal_3605_s22_q <= equal_3605_s21_q;
      equal_3607_s22_q <= equal_3607_s21_q;
      equal_3608_s22_q <= equal_3608_s21_q;
      sum_4_s22_q <= sum_4[0];
      equal_3737_s22_q <= equal_3737_s21_q;
      equal_3822_s22_q <= (registration_fresh_q & select_3820) == 4'h0;
      select_3832_s22_q <= less_2401 ? 10'h0 : regions_rdata_s21_q[29:20];
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  logic [13:0] counts_supervised_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
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
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s22_q & whole_9_s22_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s22_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s22_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s22_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s22_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:270
  logic [10:0] sum_599;
  assign sum_599 = sum_595_s22_q + {1'b0, sum_598_s22_q};
  // hls/stages/patches.hpp:111
  logic [4:0] select_1734;
  assign select_1734 = or_1733_s22_q ? {and_1579_s22_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1737;
  assign select_1737 = or_1736_s22_q ? {and_1579_s22_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:119
  logic [3:0] column_5;
  assign column_5 = select_1734[4] ? select_1737[3:0] : select_1734[3:0];
  logic and_1742;
  assign and_1742 = select_1705_s22_q & (select_1699_s22_q[3] ^ select_1699_s22_q[4]);
  logic and_1747;
  assign and_1747 = sample_pair_whole_s22_q & (and_1742 & ((~select_1734[4]) | (~select_1737[4])));
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_1874_s22_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1216
  logic [6:0] select_1877;
  assign select_1877 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1226
  logic equal_1880;
  assign equal_1880 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1199
  logic not_1887;
  assign not_1887 = ~marks_first_s22_q;
  // hls/stages/agreement.hpp:1035
  logic [4:0] t;
  assign t = {difference_1909_s22_q[3], difference_1909_s22_q} + (equal_1612_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1042
  logic not_1924;
  assign not_1924 = ~region_row_s22_q[2];
  logic [2:0] select_1925;
  assign select_1925 = region_row_s22_q[1] ? {1'b0, not_1924, 1'b0} : {region_row_s22_q[2], 1'b0, not_1924};
  logic [5:0] select_1926;
  assign select_1926 = region_row_s22_q[0] ? {select_1925[2], 1'b0, select_1925[1], 1'b0, select_1925[0], 1'b0} : {1'b0, select_1925[2], 1'b0, select_1925[1], 1'b0, select_1925[0]};
  logic [11:0] select_1927;
  assign select_1927 = or_1923_s22_q ? {select_1926[5], 1'b0, select_1926[4], 1'b0, select_1926[3], 1'b0, select_1926[2], 1'b0, select_1926[1], 1'b0, select_1926[0], 1'b0} : {1'b0, select_1926[5], 1'b0, select_1926[4], 1'b0, select_1926[3], 1'b0, select_1926[2], 1'b0, select_1926[1], 1'b0, select_1926[0]};
  logic [23:0] select_1928;
  assign select_1928 = or_1920_s22_q ? {select_1927[11], 1'b0, select_1927[10], 1'b0, select_1927[9], 1'b0, select_1927[8], 1'b0, select_1927[7], 1'b0, select_1927[6], 1'b0, select_1927[5], 1'b0, select_1927[4], 1'b0, select_1927[3], 1'b0, select_1927[2], 1'b0, select_1927[1], 1'b0, select_1927[0], 1'b0} : {1'b0, select_1927[11], 1'b0, select_1927[10], 1'b0, select_1927[9], 1'b0, select_1927[8], 1'b0, select_1927[7], 1'b0, select_1927[6], 1'b0, select_1927[5], 1'b0, select_1927[4], 1'b0, select_1927[3], 1'b0, select_1927[2], 1'b0, select_1927[1], 1'b0, select_1927[0]};
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_1946;
  assign sum_1946 = {1'b0, around_s22_q} + {2'h0, around_s22_q[4:1]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s22_q} + (equal_500_s22_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2015;
  assign select_2015 = sample_pair_whole_s22_q ? (and_495_s22_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s22_q} + (equal_500_s22_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2023;
  assign select_2023 = sample_pair_whole_s22_q ? (and_495_s22_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:507
  logic select_2071;
  assign select_2071 = and_497_s22_q ? census_columns_values_1_cell_2_mask_s22_q : census_columns_values_2_cell_2_mask_q;
  logic select_2074;
  assign select_2074 = and_497_s22_q ? census_columns_values_1_cell_3_mask_s22_q : census_columns_values_2_cell_3_mask_q;
  logic select_2077;
  assign select_2077 = and_497_s22_q ? census_columns_values_1_cell_4_mask_s22_q : census_columns_values_2_cell_4_mask_q;
  logic select_2078;
  assign select_2078 = and_497_s22_q ? census_columns_values_2_cell_0_mask_s22_q : census_columns_values_3_cell_0_mask_q;
  logic select_2081;
  assign select_2081 = and_497_s22_q ? census_columns_values_2_cell_1_mask_s22_q : census_columns_values_3_cell_1_mask_q;
  logic select_2082;
  assign select_2082 = and_497_s22_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2085;
  assign select_2085 = and_497_s22_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_2098;
  assign sum_2098 = sum_2094_s22_q + {1'b0, sum_2097_s22_q};
  // hls/stages/agreement.hpp:507
  logic select_2130;
  assign select_2130 = and_497_s22_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2133;
  assign and_2133 = whole_2_s22_q & (~(column_s22_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
  logic and_2139;
  assign and_2139 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s22_q[8:2]));
  logic and_2140;
  assign and_2140 = and_2133 & and_2139;
  logic and_2151;
  assign and_2151 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s22_q[8:2]));
  logic and_2152;
  assign and_2152 = and_2133 & and_2151;
  // hls/stages/census.hpp:409
  logic not_2169;
  assign not_2169 = ~x_s22_q[1];
  logic [2:0] select_2170;
  assign select_2170 = x_s22_q[0] ? {1'b0, not_2169, 1'b0} : {x_s22_q[1], 1'b0, not_2169};
  logic [5:0] select_2171;
  assign select_2171 = slot_s22_q[2] ? {select_2170[2], 1'b0, select_2170[1], 1'b0, select_2170[0], 1'b0} : {1'b0, select_2170[2], 1'b0, select_2170[1], 1'b0, select_2170[0]};
  logic [11:0] select_2172;
  assign select_2172 = slot_s22_q[1] ? {select_2171[5], 1'b0, select_2171[4], 1'b0, select_2171[3], 1'b0, select_2171[2], 1'b0, select_2171[1], 1'b0, select_2171[0], 1'b0} : {1'b0, select_2171[5], 1'b0, select_2171[4], 1'b0, select_2171[3], 1'b0, select_2171[2], 1'b0, select_2171[1], 1'b0, select_2171[0]};
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2359;
  assign select_2359 = and_2353_s22_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2357_s22_q});
  // hls/stages/agreement.hpp:1043
  logic [5:0] sum_2389;
  assign sum_2389 = {1'b0, e_s22_q} + {2'h0, e_s22_q[4:1]};
  // hls/stages/registration.hpp:202
  logic [12:0] difference_2509;
  assign difference_2509 = 13'h0 - {residual_s22_q[11], residual_s22_q};
  logic less_2524;
  assign less_2524 = $signed(difference_2509) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2758;
  assign select_2758 = sample_pair_whole_s22_q ? (select_1734[4] ? {1'b1, select_1734[3:0]} : (select_1734 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2761;
  assign select_2761 = sample_pair_whole_s22_q ? (select_1737[4] ? {1'b1, select_1737[3:0]} : (select_1737 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:160
  logic [2:0] select_2851;
  assign select_2851 = equal_1672_s22_q ? 3'h0 : (equal_1674_s22_q ? 3'h0 : select_2849_s22_q);
  // hls/stages/patches.hpp:143
  logic [9:0] sum_2853;
  assign sum_2853 = {7'h0, patches_set_q} + (equal_1676_s22_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_2878;
  assign xor_2878 = xor_2869_s22_q ^ parity_2877_s22_q;
  logic xor_2884;
  assign xor_2884 = bits_s22_q ^ (^{select_2863_s22_q[7:6], other_s22_q[7:6]});
  logic xor_2893;
  assign xor_2893 = xor_2884 ^ (^{select_2863_s22_q[5:0], other_s22_q[5:0]});
  logic parity_2895;
  assign parity_2895 = ^{select_2863_s22_q[20:18], select_2863_s22_q[8:0], other_s22_q[20:18], other_s22_q[8:0]};
  logic xor_2896;
  assign xor_2896 = xor_2878 ^ parity_2895;
  logic xor_2920;
  assign xor_2920 = xor_2911_s22_q ^ parity_2919_s22_q;
  logic xor_2932;
  assign xor_2932 = xor_2923_s22_q ^ parity_2931_s22_q;
  logic xor_2933;
  assign xor_2933 = xor_2920 ^ xor_2932;
  // hls/stages/count_bits.hpp:25
  logic or_2941;
  assign or_2941 = (xor_2872_s22_q & xor_2875_s22_q) | (xor_2869_s22_q & (xor_2872_s22_q | xor_2875_s22_q));
  logic or_2949;
  assign or_2949 = (xor_2887_s22_q & xor_2890_s22_q) | (xor_2884 & (xor_2887_s22_q | xor_2890_s22_q));
  logic or_3038;
  assign or_3038 = (xor_2902_s22_q & xor_2905_s22_q) | (xor_2899_s22_q & (xor_2902_s22_q | xor_2905_s22_q));
  logic or_3042;
  assign or_3042 = (xor_2914_s22_q & xor_2917_s22_q) | (xor_2911_s22_q & (xor_2914_s22_q | xor_2917_s22_q));
  logic or_3046;
  assign or_3046 = (xor_2926_s22_q & xor_2929_s22_q) | (xor_2923_s22_q & (xor_2926_s22_q | xor_2929_s22_q));
  logic and_3050;
  assign and_3050 = xor_2896 & (^{xor_2933, select_2863_s22_q[17:9], other_s22_q[17:9]});
  logic or_3054;
  assign or_3054 = (xor_2881_s22_q & xor_2893) | (xor_2878 & (xor_2881_s22_q | xor_2893));
  logic and_3057;
  assign and_3057 = (xor_2899_s22_q ^ (^{select_2863_s22_q[14:9], other_s22_q[14:9]})) & (xor_2920 | xor_2932);
  // hls/stages/patches.hpp:503
  logic [1:0] sum_3347;
  assign sum_3347 = {1'b0, not_3343_s22_q} + {1'b0, not_3346_s22_q};
  // hls/stages/patches.hpp:504
  logic [1:0] sum_3354;
  assign sum_3354 = {1'b0, not_3350_s22_q} + {1'b0, not_3353_s22_q};
  // hls/stages/patches.hpp:503
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3347} + {1'b0, sum_3354};
  // hls/stages/agreement.hpp:1125
  logic or_3584;
  assign or_3584 = ({counts_textured_s22_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s22_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1156
  logic too_little;
  assign too_little = less_3588_s22_q | (product_rest_q & equal_3589_s22_q);
  // hls/stages/agreement.hpp:1157
  logic select_3592;
  assign select_3592 = and_3587_s22_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1076
  logic [10:0] sum_3595;
  assign sum_3595 = {1'b0, select_2405_s22_q} + {2'h0, select_2405_s22_q[9:1]};
  // hls/stages/patches.hpp:303
  logic select_3639;
  assign select_3639 = equal_1466_s22_q ? (equal_3414_s22_q ? sum_4_s22_q : (product_rest_q | sum_4_s22_q)) : product_rest_q;
  logic [4:0] select_3668;
  assign select_3668 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_3669;
  assign select_3669 = equal_1466_s22_q ? box_textured_sum_sums_values_0_q : select_3668;
  // hls/stages/agreement.hpp:1225
  logic [3:0] select_3754;
  assign select_3754 = select_1874_s22_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3760;
  assign select_3760 = marks_first_s22_q ? (less_3756 ? {sum_3757, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s22_q, or_1831_s22_q, or_1828_s22_q, or_1825_s22_q};
  logic regions_we;
  assign regions_we = s22_en & and_1859_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1858_s22_q, sum_1852_s22_q, sum_1847_s22_q};
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
      sharpness_before_last_mask_q <= 1'b0;
      counts_supervised_q <= 14'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
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
    end else if (s22_en) begin
      sharpness_before_last_mask_q <= select_2130;
      counts_supervised_q <= select_2359;
      patches_left_next_0_q <= select_2758;
      patches_left_next_1_q <= select_2761;
      patches_set_q <= select_2851;
      patches_size_q <= sum_2853;
      product_rest_q <= select_3639;
      disagree_q <= equal_1466_s22_q ? select_3592 : disagree_q;
      began_q <= not_1887 & (began_q | select_1874_s22_q);
      seen_x_q <= select_1874_s22_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s22_q ? 4'h0 : select_3754;
      seen_column_q <= select_1874_s22_q ? 8'h0 : (seen_column_q + {7'h0, equal_1880});
      seen_rows_left_q <= select_3760;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s22_q ? 13'h0 : (seen_base_q + {6'h0, select_1877});
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
    box_textured_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s22_en) begin
      averager_detail_0_q <= select_2015;
      averager_detail_1_q <= select_2023;
      census_columns_values_2_cell_2_mask_q <= select_2071;
      census_columns_values_2_cell_3_mask_q <= select_2074;
      census_columns_values_2_cell_4_mask_q <= select_2077;
      census_columns_values_3_cell_0_mask_q <= select_2078;
      census_columns_values_3_cell_1_mask_q <= select_2081;
      census_columns_values_3_cell_2_mask_q <= select_2082;
      census_columns_values_3_cell_3_mask_q <= select_2085;
      sharpness_last_mask_q <= and_497_s22_q ? whole_2_s22_q : sharpness_last_mask_q;
      box_textured_sum_sums_values_0_q <= select_3669;
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
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic census_columns_values_2_cell_4_mask_s23_q;
  logic census_columns_values_3_cell_0_mask_s23_q;
  logic census_columns_values_3_cell_1_mask_s23_q;
  logic census_columns_values_3_cell_2_mask_s23_q;
  logic census_columns_values_3_cell_3_mask_s23_q;
  logic [6:0] x_s23_q;
  logic slot_s23_q;
  logic ends_cell_s23_q;
  logic lower_half_s23_q;
  logic [13:0] counts_supervised_s23_q;
  logic [13:0] counts_textured_s23_q;
  logic [13:0] counts_explained_s23_q;
  logic registration_of_right_s23_q;
  logic patches_lower_s23_q;
  logic patches_second_s23_q;
  logic [4:0] patches_summed_row_column_s23_q;
  logic patches_summed_first_s23_q;
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic [13:0] product_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic [6:0] column_s23_q;
  logic and_497_s23_q;
  logic so_s23_q;
  logic less_531_s23_q;
  logic less_532_s23_q;
  logic less_533_s23_q;
  logic less_534_s23_q;
  logic less_535_s23_q;
  logic less_536_s23_q;
  logic less_537_s23_q;
  logic less_538_s23_q;
  logic less_539_s23_q;
  logic less_540_s23_q;
  logic less_541_s23_q;
  logic less_542_s23_q;
  logic less_543_s23_q;
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
  logic and_562_s23_q;
  logic whole_16_s23_q;
  logic and_588_s23_q;
  logic [11:0] sum_603_s23_q;
  logic [9:0] sum_606_s23_q;
  logic equal_1466_s23_q;
  logic not_1467_s23_q;
  logic equal_1511_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1517_s23_q;
  logic equal_1519_s23_q;
  logic equal_1521_s23_q;
  logic equal_1523_s23_q;
  logic equal_1525_s23_q;
  logic equal_1527_s23_q;
  logic equal_1529_s23_q;
  logic equal_1531_s23_q;
  logic equal_1533_s23_q;
  logic less_1542_s23_q;
  logic or_1546_s23_q;
  logic [31:0] registration_sums_rdata_s23_q;
  logic equal_1566_s23_q;
  logic and_1576_s23_q;
  logic and_1579_s23_q;
  logic select_1596_s23_q;
  logic equal_1597_s23_q;
  logic and_1607_s23_q;
  logic equal_1638_s23_q;
  logic equal_1672_s23_q;
  logic equal_1674_s23_q;
  logic select_1688_s23_q;
  logic or_1695_s23_q;
  logic [4:0] select_1699_s23_q;
  logic select_1705_s23_q;
  logic or_1721_s23_q;
  logic [3:0] column_5_s23_q;
  logic [3:0] select_1739_s23_q;
  logic select_1740_s23_q;
  logic and_1747_s23_q;
  logic less_1804_s23_q;
  logic equal_1805_s23_q;
  logic not_1806_s23_q;
  logic equal_1807_s23_q;
  logic not_1833_s23_q;
  logic not_1887_s23_q;
  logic [7:0] sum_1897_s23_q;
  logic equal_1912_s23_q;
  logic or_1917_s23_q;
  logic [23:0] select_1928_s23_q;
  logic not_1948_s23_q;
  logic less_1962_s23_q;
  logic and_1973_s23_q;
  logic [11:0] sum_2102_s23_q;
  logic [9:0] sum_2105_s23_q;
  logic equal_2113_s23_q;
  logic [27:0] select_2127_s23_q;
  logic and_2140_s23_q;
  logic and_2152_s23_q;
  logic [8:0] select_2159_s23_q;
  logic [8:0] select_2163_s23_q;
  logic equal_2166_s23_q;
  logic less_2167_s23_q;
  logic [11:0] select_2172_s23_q;
  logic equal_2210_s23_q;
  logic equal_2237_s23_q;
  logic and_2353_s23_q;
  logic and_2372_s23_q;
  logic not_2376_s23_q;
  logic not_2391_s23_q;
  logic [9:0] select_2402_s23_q;
  logic [9:0] select_2405_s23_q;
  logic and_2466_s23_q;
  logic [7:0] residual_s23_q;
  logic less_2510_s23_q;
  logic less_2524_s23_q;
  logic equal_2568_s23_q;
  logic [8:0] other_s23_q;
  logic [8:0] select_2863_s23_q;
  logic xor_2896_s23_q;
  logic xor_2933_s23_q;
  logic or_2941_s23_q;
  logic or_2945_s23_q;
  logic or_2949_s23_q;
  logic or_2956_s23_q;
  logic or_2960_s23_q;
  logic or_2964_s23_q;
  logic or_2971_s23_q;
  logic or_2975_s23_q;
  logic or_2979_s23_q;
  logic or_2989_s23_q;
  logic or_2993_s23_q;
  logic or_2997_s23_q;
  logic or_3005_s23_q;
  logic or_3009_s23_q;
  logic or_3013_s23_q;
  logic or_3020_s23_q;
  logic or_3024_s23_q;
  logic or_3028_s23_q;
  logic or_3038_s23_q;
  logic or_3042_s23_q;
  logic or_3046_s23_q;
  logic and_3050_s23_q;
  logic or_3054_s23_q;
  logic or_3058_s23_q;
  logic equal_3173_s23_q;
  logic [4:0] select_3261_s23_q;
  logic [9:0] select_3292_s23_q;
  logic [9:0] difference_3305_s23_q;
  logic less_3307_s23_q;
  logic less_3335_s23_q;
  logic [2:0] fraction_s23_q;
  logic [13:0] product_3362_s23_q;
  logic equal_3414_s23_q;
  logic equal_3581_s23_q;
  logic or_3584_s23_q;
  logic select_3592_s23_q;
  logic not_3597_s23_q;
  logic equal_3605_s23_q;
  logic equal_3607_s23_q;
  logic equal_3608_s23_q;
  logic equal_3737_s23_q;
  logic equal_3822_s23_q;
  logic [9:0] select_3832_s23_q;
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
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_s22_q;
      census_columns_values_2_cell_4_mask_s23_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s23_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s23_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s23_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s23_q <= census_columns_values_3_cell_3_mask_q;
      x_s23_q <= x_s22_q[6:0];
      slot_s23_q <= slot_s22_q[0];
      ends_cell_s23_q <= ends_cell_s22_q;
      lower_half_s23_q <= lower_half_s22_q;
      counts_supervised_s23_q <= counts_supervised_q;
      counts_textured_s23_q <= counts_textured_s22_q;
      counts_explained_s23_q <= counts_explained_s22_q;
      registration_of_right_s23_q <= registration_of_right_s22_q;
      patches_lower_s23_q <= patches_lower_s22_q;
      patches_second_s23_q <= patches_second_s22_q;
      patches_summed_row_column_s23_q <= patches_summed_row_column_s22_q;
      patches_summed_first_s23_q <= patches_summed_first_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_s22_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_s22_q;
      product_s23_q <= product_s22_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_s22_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_s22_q;
      column_s23_q <= column_s22_q;
      and_497_s23_q <= and_497_s22_q;
      so_s23_q <= so_s22_q;
      less_531_s23_q <= less_531_s22_q;
      less_532_s23_q <= less_532_s22_q;
      less_533_s23_q <= less_533_s22_q;
      less_534_s23_q <= less_534_s22_q;
      less_535_s23_q <= less_535_s22_q;
      less_536_s23_q <= less_536_s22_q;
      less_537_s23_q <= less_537_s22_q;
      less_538_s23_q <= less_538_s22_q;
      less_539_s23_q <= less_539_s22_q;
      less_540_s23_q <= less_540_s22_q;
      less_541_s23_q <= less_541_s22_q;
      less_542_s23_q <= less_542_s22_q;
      less_543_s23_q <= less_543_s22_q;
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
      and_562_s23_q <= and_562_s22_q;
      whole_16_s23_q <= whole_16;
      and_588_s23_q <= census_columns_values_1_cell_2_mask_s22_q & and_562_s22_q;
      sum_603_s23_q <= {1'b0, sum_599} + {2'h0, sum_602_s22_q};
      sum_606_s23_q <= sum_606_s22_q;
      equal_1466_s23_q <= equal_1466_s22_q;
      not_1467_s23_q <= not_1467_s22_q;
      equal_1511_s23_q <= equal_1511_s22_q;
      all_s23_q <= all_s22_q;
      sum_1517_s23_q <= sum_1517_s22_q;
      equal_1519_s23_q <= equal_1519_s22_q;
      equal_1521_s23_q <= equal_1521_s22_q;
      equal_1523_s23_q <= equal_1523_s22_q;
      equal_1525_s23_q <= equal_1525_s22_q;
      equal_1527_s23_q <= equal_1527_s22_q;
      equal_1529_s23_q <= equal_1529_s22_q;
      equal_1531_s23_q <= equal_1531_s22_q;
      equal_1533_s23_q <= equal_1533_s22_q;
      less_1542_s23_q <= less_1542_s22_q;
      or_1546_s23_q <= or_1546_s22_q;
      registration_sums_rdata_s23_q <= registration_sums_rdata_q;
      equal_1566_s23_q <= equal_1566_s22_q;
      and_1576_s23_q <= and_1576_s22_q;
      and_1579_s23_q <= and_1579_s22_q;
      select_1596_s23_q <= select_1596_s22_q;
      equal_1597_s23_q <= equal_1597_s22_q;
      and_1607_s23_q <= and_1607_s22_q;
      equal_1638_s23_q <= equal_1638_s22_q;
      equal_1672_s23_q <= equal_1672_s22_q;
      equal_1674_s23_q <= equal_1674_s22_q;
      select_1688_s23_q <= select_1688_s22_q;
      or_1695_s23_q <= and_1579_s22_q | equal_1694_s22_q;
      select_1699_s23_q <= select_1699_s22_q;
      select_1705_s23_q <= select_1705_s22_q;
      or_1721_s23_q <= and_1579_s22_q | equal_1720_s22_q;
      column_5_s23_q <= column_5;
      select_1739_s23_q <= select_1739_s22_q;
      select_1740_s23_q <= or_1733_s22_q ? and_1579_s22_q : patches_left_next_0_q[4];
      and_1747_s23_q <= and_1747;
      less_1804_s23_q <= less_1804_s22_q;
      equal_1805_s23_q <= equal_1805_s22_q;
      not_1806_s23_q <= not_1806_s22_q;
      equal_1807_s23_q <= equal_1807_s22_q;
      not_1833_s23_q <= not_1833_s22_q;
      not_1887_s23_q <= not_1887;
      sum_1897_s23_q <= {2'h0, x_s22_q[7:2]} + 8'hff;
      equal_1912_s23_q <= t[4:1] == 4'h0;
      or_1917_s23_q <= or_1917_s22_q;
      select_1928_s23_q <= select_1928;
      not_1948_s23_q <= ~({sum_1946, around_s22_q[0]} < {2'h0, t});
      less_1962_s23_q <= less_1962_s22_q;
      and_1973_s23_q <= and_1973_s22_q;
      sum_2102_s23_q <= {1'b0, sum_2098} + {2'h0, sum_2101_s22_q};
      sum_2105_s23_q <= sum_2105_s22_q;
      equal_2113_s23_q <= equal_2113_s22_q;
      select_2127_s23_q <= sample_pair_whole_s22_q ? {detail_2, detail} : 28'h0;
      and_2140_s23_q <= and_2140;
      and_2152_s23_q <= and_2152;
      select_2159_s23_q <= and_2140 ? contrast_s22_q : 9'h0;
      select_2163_s23_q <= and_2152 ? contrast_2_s22_q : 9'h0;
      equal_2166_s23_q <= x_s22_q[7:3] == 5'h0;
      less_2167_s23_q <= 7'h2 < {x_s22_q[4:0], slot_s22_q[2:1]};
      select_2172_s23_q <= select_2172;
      equal_2210_s23_q <= {x_s22_q[4:0], slot_s22_q} == 8'h0;
      equal_2237_s23_q <= equal_2237_s22_q;
      and_2353_s23_q <= and_2353_s22_q;
      and_2372_s23_q <= and_2372_s22_q;
      not_2376_s23_q <= not_2376_s22_q;
      not_2391_s23_q <= ~({sum_2389, e_s22_q[0]} < {2'h0, t});
      select_2402_s23_q <= select_2402_s22_q;
      select_2405_s23_q <= select_2405_s22_q;
      and_2466_s23_q <= and_2466_s22_q;
      residual_s23_q <= residual_s22_q[7:0];
      less_2510_s23_q <= $signed(difference_2509) < $signed({7'h0, cfg_moved_limit_i});
      less_2524_s23_q <= less_2524;
      equal_2568_s23_q <= equal_2568_s22_q;
      other_s23_q <= other_s22_q[17:9];
      select_2863_s23_q <= select_2863_s22_q[17:9];
      xor_2896_s23_q <= xor_2896;
      xor_2933_s23_q <= xor_2933;
      or_2941_s23_q <= or_2941;
      or_2945_s23_q <= equal_2942_s22_q | and_2944_s22_q;
      or_2949_s23_q <= or_2949;
      or_2956_s23_q <= equal_2953_s22_q | and_2955_s22_q;
      or_2960_s23_q <= equal_2957_s22_q | and_2959_s22_q;
      or_2964_s23_q <= equal_2961_s22_q | and_2963_s22_q;
      or_2971_s23_q <= equal_2968_s22_q | and_2970_s22_q;
      or_2975_s23_q <= equal_2972_s22_q | and_2974_s22_q;
      or_2979_s23_q <= equal_2976_s22_q | and_2978_s22_q;
      or_2989_s23_q <= equal_2986_s22_q | and_2988_s22_q;
      or_2993_s23_q <= equal_2990_s22_q | and_2992_s22_q;
      or_2997_s23_q <= equal_2994_s22_q | and_2996_s22_q;
      or_3005_s23_q <= equal_3001_s22_q | (bits_s22_q & not_3003_s22_q);
      or_3009_s23_q <= equal_3006_s22_q | and_3008_s22_q;
      or_3013_s23_q <= equal_3010_s22_q | and_3012_s22_q;
      or_3020_s23_q <= equal_3017_s22_q | and_3019_s22_q;
      or_3024_s23_q <= equal_3021_s22_q | and_3023_s22_q;
      or_3028_s23_q <= equal_3025_s22_q | and_3027_s22_q;
      or_3038_s23_q <= or_3038;
      or_3042_s23_q <= or_3042;
      or_3046_s23_q <= or_3046;
      and_3050_s23_q <= and_3050;
      or_3054_s23_q <= or_3054;
      or_3058_s23_q <= (xor_2920 & xor_2932) | and_3057;
      equal_3173_s23_q <= equal_3173_s22_q;
      select_3261_s23_q <= select_3261_s22_q;
      select_3292_s23_q <= select_3292_s22_q;
      difference_3305_s23_q <= select_3302_s22_q - select_3292_s22_q;
      less_3307_s23_q <= select_3302_s22_q < select_3292_s22_q;
      less_3335_s23_q <= less_3335_s22_q;
      fraction_s23_q <= fraction;
      product_3362_s23_q <= product_3362_s22_q;
      equal_3414_s23_q <= equal_3414_s22_q;
      equal_3581_s23_q <= select_2402_s22_q[9:3] == 7'h0;
      or_3584_s23_q <= or_3584;
      select_3592_s23_q <= select_3592;
      not_3597_s23_q <= ~({sum_3595, select_2405_s22_q[0]} < {2'h0, select_2402_s22_q});
      equal_3605_s23_q <= equal_3605_s22_q;
      equal_3607_s23_q <= equal_3607_s22_q;
      equal_3608_s23_q <= equal_3608_s22_q;
      equal_3737_s23_q <= equal_3737_s22_q;
      equal_3822_s23_q <= equal_3822_s22_q;
      select_3832_s23_q <= select_3832_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_3_cell_4_mask_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [13:0] counts_nearer_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic [47:0] good_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:443
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s23_q & whole_16_s23_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s23_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s23_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s23_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s23_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:270
  logic [11:0] texture;
  assign texture = sum_603_s23_q + {2'h0, sum_606_s23_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_1706;
  assign select_1706 = or_1695_s23_q ? {and_1579_s23_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:114
  logic and_1708;
  assign and_1708 = select_1705_s23_q & (~select_1706[5]);
  // hls/stages/patches.hpp:110
  logic [5:0] select_1723;
  assign select_1723 = or_1721_s23_q ? {and_1579_s23_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:114
  logic and_1725;
  assign and_1725 = select_1705_s23_q & (~select_1723[5]);
  // hls/stages/agreement.hpp:1233
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1200
  logic select_1885;
  assign select_1885 = marks_first_s23_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1186
  logic [10:0] sum_1886;
  assign sum_1886 = {1'b0, {5{select_1885}}, 1'b0, {2{select_1885}}, 1'b0, select_1885} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1052
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1897_s23_q[7]}}, sum_1897_s23_q, x_s23_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1186
  logic [10:0] sum_1899;
  assign sum_1899 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1042
  logic [47:0] select_1929;
  assign select_1929 = or_1917_s23_q ? {select_1928_s23_q[23], 1'b0, select_1928_s23_q[22], 1'b0, select_1928_s23_q[21], 1'b0, select_1928_s23_q[20], 1'b0, select_1928_s23_q[19], 1'b0, select_1928_s23_q[18], 1'b0, select_1928_s23_q[17], 1'b0, select_1928_s23_q[16], 1'b0, select_1928_s23_q[15], 1'b0, select_1928_s23_q[14], 1'b0, select_1928_s23_q[13], 1'b0, select_1928_s23_q[12], 1'b0, select_1928_s23_q[11], 1'b0, select_1928_s23_q[10], 1'b0, select_1928_s23_q[9], 1'b0, select_1928_s23_q[8], 1'b0, select_1928_s23_q[7], 1'b0, select_1928_s23_q[6], 1'b0, select_1928_s23_q[5], 1'b0, select_1928_s23_q[4], 1'b0, select_1928_s23_q[3], 1'b0, select_1928_s23_q[2], 1'b0, select_1928_s23_q[1], 1'b0, select_1928_s23_q[0], 1'b0} : {1'b0, select_1928_s23_q[23], 1'b0, select_1928_s23_q[22], 1'b0, select_1928_s23_q[21], 1'b0, select_1928_s23_q[20], 1'b0, select_1928_s23_q[19], 1'b0, select_1928_s23_q[18], 1'b0, select_1928_s23_q[17], 1'b0, select_1928_s23_q[16], 1'b0, select_1928_s23_q[15], 1'b0, select_1928_s23_q[14], 1'b0, select_1928_s23_q[13], 1'b0, select_1928_s23_q[12], 1'b0, select_1928_s23_q[11], 1'b0, select_1928_s23_q[10], 1'b0, select_1928_s23_q[9], 1'b0, select_1928_s23_q[8], 1'b0, select_1928_s23_q[7], 1'b0, select_1928_s23_q[6], 1'b0, select_1928_s23_q[5], 1'b0, select_1928_s23_q[4], 1'b0, select_1928_s23_q[3], 1'b0, select_1928_s23_q[2], 1'b0, select_1928_s23_q[1], 1'b0, select_1928_s23_q[0]};
  // hls/stages/agreement.hpp:507
  logic select_2086;
  assign select_2086 = and_497_s23_q ? census_columns_values_2_cell_4_mask_s23_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2106;
  assign sum_2106 = sum_2102_s23_q + {2'h0, sum_2105_s23_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2108;
  assign select_2108 = and_497_s23_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2109;
  assign select_2109 = and_497_s23_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2128;
  assign select_2128 = and_497_s23_q ? select_2127_s23_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2129;
  assign select_2129 = and_497_s23_q ? select_2127_s23_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2127_s23_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2127_s23_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_2160;
  assign sum_2160 = (equal_2113_s23_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2159_s23_q};
  logic [23:0] sum_2164;
  assign sum_2164 = (equal_2113_s23_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2163_s23_q};
  // hls/stages/census.hpp:409
  logic less_2168;
  assign less_2168 = x_s23_q[4:0] < 5'h3;
  logic [23:0] select_2173;
  assign select_2173 = slot_s23_q ? {select_2172_s23_q[11], 1'b0, select_2172_s23_q[10], 1'b0, select_2172_s23_q[9], 1'b0, select_2172_s23_q[8], 1'b0, select_2172_s23_q[7], 1'b0, select_2172_s23_q[6], 1'b0, select_2172_s23_q[5], 1'b0, select_2172_s23_q[4], 1'b0, select_2172_s23_q[3], 1'b0, select_2172_s23_q[2], 1'b0, select_2172_s23_q[1], 1'b0, select_2172_s23_q[0], 1'b0} : {1'b0, select_2172_s23_q[11], 1'b0, select_2172_s23_q[10], 1'b0, select_2172_s23_q[9], 1'b0, select_2172_s23_q[8], 1'b0, select_2172_s23_q[7], 1'b0, select_2172_s23_q[6], 1'b0, select_2172_s23_q[5], 1'b0, select_2172_s23_q[4], 1'b0, select_2172_s23_q[3], 1'b0, select_2172_s23_q[2], 1'b0, select_2172_s23_q[1], 1'b0, select_2172_s23_q[0]};
  // hls/stages/census.hpp:372
  logic and_2177;
  assign and_2177 = less_2168 & (~((sharpness_sums_contrast_1_q & select_2173) == 24'h0));
  logic and_2187;
  assign and_2187 = less_2168 & (~((sharpness_sums_contrast_0_q & select_2173) == 24'h0));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2374;
  assign select_2374 = and_2353_s23_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2372_s23_q});
  // hls/stages/agreement.hpp:1074
  logic [10:0] sum_2406;
  assign sum_2406 = {1'b0, select_2405_s23_q} + {3'h0, select_2405_s23_q[9:2]};
  // hls/stages/registration.hpp:106
  logic [7:0] select_2492;
  assign select_2492 = equal_1638_s23_q ? (and_1607_s23_q ? residual_s23_q : 8'h0) : 8'h0;
  logic and_2503;
  assign and_2503 = and_1607_s23_q & ($signed(residual_s23_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:202
  logic less_2517;
  assign less_2517 = $signed(residual_s23_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1071
  logic [11:0] select_2570;
  assign select_2570 = or_1546_s23_q ? 12'h0 : (equal_2568_s23_q ? registration_sums_rdata_s23_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1083
  logic [11:0] select_2572;
  assign select_2572 = equal_1511_s23_q ? 12'h0 : (less_1542_s23_q ? select_2570 : 12'h0);
  // hls/stages/registration.hpp:152
  logic and_2575;
  assign and_2575 = x_s23_q[1] & all_s23_q;
  // hls/stages/agreement.hpp:1083
  logic and_2578;
  assign and_2578 = not_1833_s23_q & (less_1542_s23_q & ({and_2575, x_s23_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1071
  logic [11:0] select_2585;
  assign select_2585 = or_1546_s23_q ? 12'h0 : (equal_2568_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1083
  logic [11:0] select_2587;
  assign select_2587 = equal_1511_s23_q ? 12'h0 : (less_1542_s23_q ? select_2585 : 12'h0);
  // hls/stages/registration.hpp:149
  logic not_2593;
  assign not_2593 = ~all_s23_q;
  // hls/stages/agreement.hpp:1083
  logic and_2596;
  assign and_2596 = not_1833_s23_q & (less_1542_s23_q & (x_s23_q[2:0] == {all_s23_q, not_2593, 1'b0}));
  // hls/stages/patches.hpp:303
  logic and_2602;
  assign and_2602 = equal_1466_s23_q & (x_s23_q[6] & (not_1833_s23_q & (less_1542_s23_q & all_s23_q)));
  // hls/stages/registration.hpp:156
  logic equal_2629;
  assign equal_2629 = x_s23_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1083
  logic and_2632;
  assign and_2632 = not_1833_s23_q & (less_1542_s23_q & (x_s23_q[5] ? x_s23_q[3] : equal_2629));
  logic and_2641;
  assign and_2641 = not_1833_s23_q & (less_1542_s23_q & ((~x_s23_q[5]) & (x_s23_q[3] & equal_2629)));
  // hls/stages/patches.hpp:105
  logic select_2741;
  assign select_2741 = equal_1597_s23_q ? patches_valid_0_q : (select_1596_s23_q ? patches_valid_0_q : select_1688_s23_q);
  // hls/stages/agreement.hpp:263
  logic select_2744;
  assign select_2744 = sample_pair_whole_s23_q ? (and_1708 ? (sample_present_s23_q & select_2741) : select_2741) : patches_valid_0_q;
  // hls/stages/patches.hpp:105
  logic select_2746;
  assign select_2746 = equal_1597_s23_q ? patches_valid_1_q : (select_1596_s23_q ? select_1688_s23_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2749;
  assign select_2749 = sample_pair_whole_s23_q ? (and_1725 ? (sample_present_s23_q & select_2746) : select_2746) : patches_valid_1_q;
  logic [5:0] select_2752;
  assign select_2752 = sample_pair_whole_s23_q ? (select_1706[5] ? {1'b1, select_1706[4:0]} : (select_1706 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2755;
  assign select_2755 = sample_pair_whole_s23_q ? (select_1723[5] ? {1'b1, select_1723[4:0]} : (select_1723 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_2937;
  assign parity_2937 = ^{xor_2933_s23_q, xor_2896_s23_q, select_2863_s23_q, other_s23_q};
  logic parity_2967;
  assign parity_2967 = ^{or_2964_s23_q, or_2960_s23_q, or_2956_s23_q};
  logic parity_2982;
  assign parity_2982 = ^{or_2979_s23_q, or_2975_s23_q, or_2971_s23_q};
  logic parity_2985;
  assign parity_2985 = ^{or_2979_s23_q, or_2975_s23_q, or_2971_s23_q, or_2964_s23_q, or_2960_s23_q, or_2956_s23_q, or_2949_s23_q, or_2945_s23_q, or_2941_s23_q};
  logic parity_3016;
  assign parity_3016 = ^{or_3013_s23_q, or_3009_s23_q, or_3005_s23_q};
  logic parity_3031;
  assign parity_3031 = ^{or_3028_s23_q, or_3024_s23_q, or_3020_s23_q};
  logic parity_3034;
  assign parity_3034 = ^{or_3028_s23_q, or_3024_s23_q, or_3020_s23_q, or_3013_s23_q, or_3009_s23_q, or_3005_s23_q, or_2997_s23_q, or_2993_s23_q, or_2989_s23_q};
  logic parity_3049;
  assign parity_3049 = ^{or_3046_s23_q, or_3042_s23_q, or_3038_s23_q};
  logic parity_3061;
  assign parity_3061 = ^{or_3058_s23_q, or_3054_s23_q, and_3050_s23_q};
  logic parity_3064;
  assign parity_3064 = ^{or_3058_s23_q, or_3054_s23_q, and_3050_s23_q, or_3046_s23_q, or_3042_s23_q, or_3038_s23_q, or_3028_s23_q, or_3024_s23_q, or_3020_s23_q, or_3013_s23_q, or_3009_s23_q, or_3005_s23_q, or_2997_s23_q, or_2993_s23_q, or_2989_s23_q};
  logic parity_3066;
  assign parity_3066 = ^{or_3058_s23_q, or_3054_s23_q, and_3050_s23_q, or_3046_s23_q, or_3042_s23_q, or_3038_s23_q, or_3028_s23_q, or_3024_s23_q, or_3020_s23_q, or_3013_s23_q, or_3009_s23_q, or_3005_s23_q, or_2997_s23_q, or_2993_s23_q, or_2989_s23_q, or_2979_s23_q, or_2975_s23_q, or_2971_s23_q, or_2964_s23_q, or_2960_s23_q, or_2956_s23_q, or_2949_s23_q, or_2945_s23_q, or_2941_s23_q};
  // hls/stages/count_bits.hpp:25
  logic and_3067;
  assign and_3067 = parity_2985 & parity_3064;
  logic and_3070;
  assign and_3070 = (^{or_2949_s23_q, or_2945_s23_q, or_2941_s23_q}) & (parity_2967 | parity_2982);
  logic or_3071;
  assign or_3071 = (parity_2967 & parity_2982) | and_3070;
  logic or_3075;
  assign or_3075 = (parity_3049 & parity_3061) | (parity_3034 & (parity_3049 | parity_3061));
  logic and_3081;
  assign and_3081 = (^{or_2997_s23_q, or_2993_s23_q, or_2989_s23_q}) & (parity_3016 | parity_3031);
  logic or_3082;
  assign or_3082 = (parity_3016 & parity_3031) | and_3081;
  logic or_3086;
  assign or_3086 = (or_3042_s23_q & or_3046_s23_q) | (or_3038_s23_q & (or_3042_s23_q | or_3046_s23_q));
  logic or_3090;
  assign or_3090 = (or_3054_s23_q & or_3058_s23_q) | (and_3050_s23_q & (or_3054_s23_q | or_3058_s23_q));
  // hls/stages/count_bits.hpp:23
  logic or_3097;
  assign or_3097 = (or_2993_s23_q & or_2997_s23_q) | (or_2989_s23_q & (or_2993_s23_q | or_2997_s23_q));
  // hls/stages/count_bits.hpp:25
  logic or_3101;
  assign or_3101 = (or_3009_s23_q & or_3013_s23_q) | (or_3005_s23_q & (or_3009_s23_q | or_3013_s23_q));
  logic or_3105;
  assign or_3105 = (or_3024_s23_q & or_3028_s23_q) | (or_3020_s23_q & (or_3024_s23_q | or_3028_s23_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3108;
  assign parity_3108 = ^{or_3105, or_3101, or_3097};
  // hls/stages/count_bits.hpp:23
  logic or_3112;
  assign or_3112 = (or_2945_s23_q & or_2949_s23_q) | (or_2941_s23_q & (or_2945_s23_q | or_2949_s23_q));
  // hls/stages/count_bits.hpp:25
  logic or_3116;
  assign or_3116 = (or_2960_s23_q & or_2964_s23_q) | (or_2956_s23_q & (or_2960_s23_q | or_2964_s23_q));
  logic or_3120;
  assign or_3120 = (or_2975_s23_q & or_2979_s23_q) | (or_2971_s23_q & (or_2975_s23_q | or_2979_s23_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3123;
  assign parity_3123 = ^{or_3120, or_3116, or_3112};
  logic parity_3126;
  assign parity_3126 = ^{or_3120, or_3116, or_3112, or_3105, or_3101, or_3097, or_3090, or_3086, or_3082};
  // hls/stages/patches.hpp:519
  logic or_3312;
  assign or_3312 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3292_s23_q);
  logic or_3313;
  assign or_3313 = (~(patches_second_s23_q ? patches_valid_1_q : patches_valid_0_q)) | or_3312;
  logic or_3315;
  assign or_3315 = ({difference_3305_s23_q, 2'h0} < {2'h0, patches_size_q}) | (less_3307_s23_q | or_3313);
  // hls/stages/patches.hpp:505
  logic [1:0] sum_3336;
  assign sum_3336 = select_3261_s23_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:506
  logic [7:0] difference_3356;
  assign difference_3356 = {sum_3336, select_3261_s23_q[2:0], 3'h0} - {5'h0, fraction_s23_q};
  logic [7:0] select_3357;
  assign select_3357 = less_3335_s23_q ? difference_3356 : {sum_3336, select_3261_s23_q[2:0], fraction_s23_q};
  // hls/stages/agreement.hpp:1085
  logic equal_3513;
  assign equal_3513 = x_s23_q == 7'h7f;
  // hls/stages/agreement.hpp:1076
  logic select_3598;
  assign select_3598 = equal_3581_s23_q ? ((~or_3584_s23_q) & (~select_3592_s23_q)) : not_3597_s23_q;
  // hls/stages/agreement.hpp:1083
  logic [47:0] select_3600;
  assign select_3600 = x_s23_q[6] ? (equal_1511_s23_q ? good_q : {select_3598, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:447
  logic [12:0] select_3740;
  assign select_3740 = equal_2237_s23_q ? (equal_3737_s23_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3743;
  assign select_3743 = and_497_s23_q ? (equal_2237_s23_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1081
  logic [31:0] select_3824;
  assign select_3824 = equal_1533_s23_q ? {2'h0, counts_explained_s23_q, 2'h0, counts_textured_s23_q} : (equal_3822_s23_q ? registration_sums_rdata_s23_q : 32'h0);
  logic [31:0] select_3825;
  assign select_3825 = equal_1531_s23_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s23_q} : select_3824;

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1740_s23_q, select_1739_s23_q, column_5_s23_q};
  logic patches_left_we;
  assign patches_left_we = s23_en & and_1747_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s23_q;
  end
`ifndef SYNTHESIS
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
  logic [8:0] patches_left_raddr_s22_sim;
  logic patches_left_re_s22_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_re_s14_sim <= 1'b0;
      patches_left_re_s15_sim <= 1'b0;
      patches_left_re_s16_sim <= 1'b0;
      patches_left_re_s17_sim <= 1'b0;
      patches_left_re_s18_sim <= 1'b0;
      patches_left_re_s19_sim <= 1'b0;
      patches_left_re_s20_sim <= 1'b0;
      patches_left_re_s21_sim <= 1'b0;
      patches_left_re_s22_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_re_s14_sim <= patches_left_re;
      patches_left_raddr_s14_sim <= patches_left_raddr;
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
      patches_left_re_s22_sim <= patches_left_re_s21_sim;
      patches_left_raddr_s22_sim <= patches_left_raddr_s21_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_we) begin
      if (patches_left_re && patches_left_raddr == patches_left_waddr) begin
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
      if (patches_left_re_s22_sim && patches_left_raddr_s22_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      counts_nearer_q <= 14'h0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s23_en) begin
      sharpness_sums_contrast_0_q <= and_497_s23_q ? sum_2160 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_497_s23_q ? sum_2164 : sharpness_sums_contrast_1_q;
      counts_nearer_q <= select_2374;
      patches_valid_0_q <= select_2744;
      patches_valid_1_q <= select_2749;
      patches_right_next_0_q <= select_2752;
      patches_right_next_1_q <= select_2755;
      good_q <= equal_1466_s23_q ? select_3600 : good_q;
      map_row_q <= and_497_s23_q ? select_3740 : map_row_q;
      map_width_q <= select_3743;
      write_half_q <= marks_first_s23_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1885;
      done_q <= not_1887_s23_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s23_q;
      said_q <= equal_1466_s23_q & equal_3513;
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
    if (s23_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2086;
      census_changes_values_0_left_q <= and_497_s23_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_497_s23_q ? sum_2106 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2108;
      census_changes_values_1_right_q <= select_2109;
      sharpness_last_detail_0_q <= select_2128;
      sharpness_last_detail_1_q <= select_2129;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic [7:0] sample_pair_pixel_1_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic [11:0] census_changes_values_1_left_s24_q;
  logic [11:0] census_changes_values_1_right_s24_q;
  logic [23:0] sharpness_sums_contrast_0_s24_q;
  logic [23:0] sharpness_sums_contrast_1_s24_q;
  logic [6:0] x_s24_q;
  logic ends_cell_s24_q;
  logic lower_half_s24_q;
  logic [13:0] counts_nearer_s24_q;
  logic registration_of_right_s24_q;
  logic patches_lower_s24_q;
  logic patches_second_s24_q;
  logic [4:0] patches_summed_row_column_s24_q;
  logic patches_summed_first_s24_q;
  logic patches_summed_last_s24_q;
  logic [4:0] patches_summed_down_by_s24_q;
  logic [13:0] product_s24_q;
  logic centres_values_1_textured_s24_q;
  logic centres_values_1_of_skin_s24_q;
  logic done_s24_q;
  logic [6:0] column_s24_q;
  logic and_497_s24_q;
  logic less_531_s24_q;
  logic less_532_s24_q;
  logic less_533_s24_q;
  logic less_534_s24_q;
  logic less_535_s24_q;
  logic less_536_s24_q;
  logic less_537_s24_q;
  logic less_538_s24_q;
  logic less_539_s24_q;
  logic less_540_s24_q;
  logic less_541_s24_q;
  logic less_542_s24_q;
  logic less_543_s24_q;
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
  logic and_562_s24_q;
  logic and_587_s24_q;
  logic and_588_s24_q;
  logic [12:0] sum_608_s24_q;
  logic equal_1466_s24_q;
  logic not_1467_s24_q;
  logic equal_1511_s24_q;
  logic [1:0] sum_1517_s24_q;
  logic equal_1519_s24_q;
  logic equal_1521_s24_q;
  logic equal_1523_s24_q;
  logic equal_1525_s24_q;
  logic equal_1527_s24_q;
  logic equal_1529_s24_q;
  logic less_1542_s24_q;
  logic [19:0] select_1567_s24_q;
  logic [11:0] select_1572_s24_q;
  logic and_1576_s24_q;
  logic and_1607_s24_q;
  logic equal_1638_s24_q;
  logic equal_1672_s24_q;
  logic equal_1674_s24_q;
  logic [4:0] select_1696_s24_q;
  logic [4:0] select_1699_s24_q;
  logic and_1709_s24_q;
  logic [4:0] select_1722_s24_q;
  logic and_1726_s24_q;
  logic less_1804_s24_q;
  logic equal_1805_s24_q;
  logic not_1806_s24_q;
  logic equal_1807_s24_q;
  logic not_1833_s24_q;
  logic [2:0] index_s24_q;
  logic [10:0] sum_1886_s24_q;
  logic and_1893_s24_q;
  logic less_1894_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1899_s24_q;
  logic equal_1912_s24_q;
  logic not_1932_s24_q;
  logic not_1948_s24_q;
  logic less_1962_s24_q;
  logic and_1973_s24_q;
  logic equal_2113_s24_q;
  logic [12:0] sum_2114_s24_q;
  logic [12:0] select_2142_s24_q;
  logic [12:0] select_2154_s24_q;
  logic equal_2166_s24_q;
  logic less_2167_s24_q;
  logic and_2177_s24_q;
  logic and_2187_s24_q;
  logic equal_2210_s24_q;
  logic and_2353_s24_q;
  logic not_2376_s24_q;
  logic not_2391_s24_q;
  logic [9:0] select_2402_s24_q;
  logic [9:0] select_2405_s24_q;
  logic less_2407_s24_q;
  logic and_2466_s24_q;
  logic [7:0] select_2494_s24_q;
  logic and_2503_s24_q;
  logic and_2511_s24_q;
  logic and_2518_s24_q;
  logic and_2525_s24_q;
  logic [11:0] select_2572_s24_q;
  logic and_2580_s24_q;
  logic [11:0] select_2587_s24_q;
  logic and_2598_s24_q;
  logic and_2602_s24_q;
  logic equal_2629_s24_q;
  logic and_2634_s24_q;
  logic and_2642_s24_q;
  logic parity_2937_s24_q;
  logic parity_3066_s24_q;
  logic and_3067_s24_q;
  logic or_3071_s24_q;
  logic or_3075_s24_q;
  logic or_3082_s24_q;
  logic or_3086_s24_q;
  logic or_3090_s24_q;
  logic or_3097_s24_q;
  logic or_3101_s24_q;
  logic or_3105_s24_q;
  logic or_3112_s24_q;
  logic or_3116_s24_q;
  logic or_3120_s24_q;
  logic parity_3126_s24_q;
  logic or_3136_s24_q;
  logic or_3140_s24_q;
  logic and_3147_s24_q;
  logic and_3149_s24_q;
  logic and_3151_s24_q;
  logic equal_3173_s24_q;
  logic equal_3304_s24_q;
  logic or_3315_s24_q;
  logic [7:0] select_3357_s24_q;
  logic [13:0] product_3362_s24_q;
  logic equal_3414_s24_q;
  logic equal_3513_s24_q;
  logic or_3584_s24_q;
  logic select_3592_s24_q;
  logic equal_3605_s24_q;
  logic equal_3607_s24_q;
  logic equal_3608_s24_q;
  logic [31:0] select_3825_s24_q;
  logic [9:0] select_3832_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      sample_pair_pixel_1_s24_q <= sample_pair_pixel_1_s23_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      census_changes_values_1_left_s24_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s24_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s24_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s24_q <= sharpness_sums_contrast_1_q;
      x_s24_q <= x_s23_q;
      ends_cell_s24_q <= ends_cell_s23_q;
      lower_half_s24_q <= lower_half_s23_q;
      counts_nearer_s24_q <= counts_nearer_q;
      registration_of_right_s24_q <= registration_of_right_s23_q;
      patches_lower_s24_q <= patches_lower_s23_q;
      patches_second_s24_q <= patches_second_s23_q;
      patches_summed_row_column_s24_q <= patches_summed_row_column_s23_q;
      patches_summed_first_s24_q <= patches_summed_first_s23_q;
      patches_summed_last_s24_q <= patches_summed_last_s23_q;
      patches_summed_down_by_s24_q <= patches_summed_down_by_s23_q;
      product_s24_q <= product_s23_q;
      centres_values_1_textured_s24_q <= centres_values_1_textured_s23_q;
      centres_values_1_of_skin_s24_q <= centres_values_1_of_skin_s23_q;
      done_s24_q <= done_q;
      column_s24_q <= column_s23_q;
      and_497_s24_q <= and_497_s23_q;
      less_531_s24_q <= less_531_s23_q;
      less_532_s24_q <= less_532_s23_q;
      less_533_s24_q <= less_533_s23_q;
      less_534_s24_q <= less_534_s23_q;
      less_535_s24_q <= less_535_s23_q;
      less_536_s24_q <= less_536_s23_q;
      less_537_s24_q <= less_537_s23_q;
      less_538_s24_q <= less_538_s23_q;
      less_539_s24_q <= less_539_s23_q;
      less_540_s24_q <= less_540_s23_q;
      less_541_s24_q <= less_541_s23_q;
      less_542_s24_q <= less_542_s23_q;
      less_543_s24_q <= less_543_s23_q;
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
      and_562_s24_q <= and_562_s23_q;
      and_587_s24_q <= whole_22 & and_562_s23_q;
      and_588_s24_q <= and_588_s23_q;
      sum_608_s24_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1466_s24_q <= equal_1466_s23_q;
      not_1467_s24_q <= not_1467_s23_q;
      equal_1511_s24_q <= equal_1511_s23_q;
      sum_1517_s24_q <= sum_1517_s23_q;
      equal_1519_s24_q <= equal_1519_s23_q;
      equal_1521_s24_q <= equal_1521_s23_q;
      equal_1523_s24_q <= equal_1523_s23_q;
      equal_1525_s24_q <= equal_1525_s23_q;
      equal_1527_s24_q <= equal_1527_s23_q;
      equal_1529_s24_q <= equal_1529_s23_q;
      less_1542_s24_q <= less_1542_s23_q;
      select_1567_s24_q <= equal_1566_s23_q ? registration_sums_rdata_s23_q[19:0] : 20'h0;
      select_1572_s24_q <= equal_1566_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0;
      and_1576_s24_q <= and_1576_s23_q;
      and_1607_s24_q <= and_1607_s23_q;
      equal_1638_s24_q <= equal_1638_s23_q;
      equal_1672_s24_q <= equal_1672_s23_q;
      equal_1674_s24_q <= equal_1674_s23_q;
      select_1696_s24_q <= or_1695_s23_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1699_s24_q <= select_1699_s23_q;
      and_1709_s24_q <= sample_pair_whole_s23_q & and_1708;
      select_1722_s24_q <= or_1721_s23_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1726_s24_q <= sample_pair_whole_s23_q & and_1725;
      less_1804_s24_q <= less_1804_s23_q;
      equal_1805_s24_q <= equal_1805_s23_q;
      not_1806_s24_q <= not_1806_s23_q;
      equal_1807_s24_q <= equal_1807_s23_q;
      not_1833_s24_q <= not_1833_s23_q;
      index_s24_q <= index[2:0];
      sum_1886_s24_q <= sum_1886;
      and_1893_s24_q <= began_q & (seen_x_q == 4'h0);
      less_1894_s24_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s24_q <= index_2[2:0];
      sum_1899_s24_q <= sum_1899;
      equal_1912_s24_q <= equal_1912_s23_q;
      not_1932_s24_q <= ~((good_q & select_1929) == 48'h0);
      not_1948_s24_q <= not_1948_s23_q;
      less_1962_s24_q <= less_1962_s23_q;
      and_1973_s24_q <= and_1973_s23_q;
      equal_2113_s24_q <= equal_2113_s23_q;
      sum_2114_s24_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2106};
      select_2142_s24_q <= and_2140_s23_q ? detail_3[14:2] : 13'h0;
      select_2154_s24_q <= and_2152_s23_q ? detail_4[14:2] : 13'h0;
      equal_2166_s24_q <= equal_2166_s23_q;
      less_2167_s24_q <= less_2167_s23_q;
      and_2177_s24_q <= and_2177;
      and_2187_s24_q <= and_2187;
      equal_2210_s24_q <= equal_2210_s23_q;
      and_2353_s24_q <= and_2353_s23_q;
      not_2376_s24_q <= not_2376_s23_q;
      not_2391_s24_q <= not_2391_s23_q;
      select_2402_s24_q <= select_2402_s23_q;
      select_2405_s24_q <= select_2405_s23_q;
      less_2407_s24_q <= {sum_2406, select_2405_s23_q[1:0]} < {3'h0, select_2402_s23_q};
      and_2466_s24_q <= and_2466_s23_q;
      select_2494_s24_q <= equal_1466_s23_q ? 8'h0 : (so_s23_q ? select_2492 : 8'h0);
      and_2503_s24_q <= and_2503;
      and_2511_s24_q <= and_1607_s23_q & less_2510_s23_q;
      and_2518_s24_q <= and_1607_s23_q & less_2517;
      and_2525_s24_q <= and_1607_s23_q & less_2524_s23_q;
      select_2572_s24_q <= select_2572;
      and_2580_s24_q <= equal_1466_s23_q & (x_s23_q[6] & and_2578);
      select_2587_s24_q <= select_2587;
      and_2598_s24_q <= equal_1466_s23_q & (x_s23_q[6] & and_2596);
      and_2602_s24_q <= and_2602;
      equal_2629_s24_q <= equal_2629;
      and_2634_s24_q <= equal_1466_s23_q & (x_s23_q[6] & and_2632);
      and_2642_s24_q <= x_s23_q[6] & and_2641;
      parity_2937_s24_q <= parity_2937;
      parity_3066_s24_q <= parity_3066;
      and_3067_s24_q <= and_3067;
      or_3071_s24_q <= or_3071;
      or_3075_s24_q <= or_3075;
      or_3082_s24_q <= or_3082;
      or_3086_s24_q <= or_3086;
      or_3090_s24_q <= or_3090;
      or_3097_s24_q <= or_3097;
      or_3101_s24_q <= or_3101;
      or_3105_s24_q <= or_3105;
      or_3112_s24_q <= or_3112;
      or_3116_s24_q <= or_3116;
      or_3120_s24_q <= or_3120;
      parity_3126_s24_q <= parity_3126;
      or_3136_s24_q <= (or_3101 & or_3105) | (or_3097 & (or_3101 | or_3105));
      or_3140_s24_q <= (or_3116 & or_3120) | (or_3112 & (or_3116 | or_3120));
      and_3147_s24_q <= and_3067 & (or_3071 | or_3075);
      and_3149_s24_q <= parity_3108 & parity_3123;
      and_3151_s24_q <= (^{or_3090, or_3086, or_3082}) & (parity_3108 | parity_3123);
      equal_3173_s24_q <= equal_3173_s23_q;
      equal_3304_s24_q <= select_3261_s23_q[3:0] == 4'h0;
      or_3315_s24_q <= or_3315;
      select_3357_s24_q <= select_3357;
      product_3362_s24_q <= product_3362_s23_q;
      equal_3414_s24_q <= equal_3414_s23_q;
      equal_3513_s24_q <= equal_3513;
      or_3584_s24_q <= or_3584_s23_q;
      select_3592_s24_q <= select_3592_s23_q;
      equal_3605_s24_q <= equal_3605_s23_q;
      equal_3607_s24_q <= equal_3607_s23_q;
      equal_3608_s24_q <= equal_3608_s23_q;
      select_3825_s24_q <= select_3825;
      select_3832_s24_q <= select_3832_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
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
  logic good_known_q;
  // hls/stages/census.hpp:281
  logic [13:0] sum_609;
  assign sum_609 = {2'h0, census_changes_values_1_left_s24_q} + {1'b0, sum_608_s24_q};
  logic [13:0] sum_610;
  assign sum_610 = {2'h0, census_changes_values_2_left_q} + sum_609;
  // hls/stages/registration.hpp:262
  logic equal_1568;
  assign equal_1568 = sum_1517_s24_q == 2'h0;
  // hls/stages/registration.hpp:260
  logic [6:0] down;
  assign down = sum_1517_s24_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:262
  logic [13:0] select_1570;
  assign select_1570 = equal_1568 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:261
  logic [6:0] up;
  assign up = sum_1517_s24_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:263
  logic [6:0] select_1574;
  assign select_1574 = equal_1568 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/agreement.hpp:975
  logic and_1933;
  assign and_1933 = good_known_q & not_1932_s24_q;
  // hls/stages/agreement.hpp:1044
  logic is_seen;
  assign is_seen = equal_1912_s24_q ? and_1933 : not_1948_s24_q;
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2110;
  assign select_2110 = and_497_s24_q ? census_changes_values_1_left_s24_q : census_changes_values_2_left_q;
  logic [11:0] select_2111;
  assign select_2111 = and_497_s24_q ? census_changes_values_1_right_s24_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_2115;
  assign sum_2115 = {2'h0, census_changes_values_1_right_s24_q} + {1'b0, sum_2114_s24_q};
  logic [13:0] sum_2116;
  assign sum_2116 = {2'h0, census_changes_values_2_right_q} + sum_2115;
  // hls/stages/census.hpp:357
  logic [23:0] select_2144;
  assign select_2144 = equal_2113_s24_q ? {11'h0, select_2142_s24_q} : (sharpness_sums_detail_0_q + {11'h0, select_2142_s24_q});
  logic [23:0] select_2156;
  assign select_2156 = equal_2113_s24_q ? {11'h0, select_2154_s24_q} : (sharpness_sums_detail_1_q + {11'h0, select_2154_s24_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_2179;
  assign select_2179 = (less_2167_s24_q & and_2177_s24_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2189;
  assign select_2189 = (less_2167_s24_q & and_2187_s24_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:207
  logic [1:0] select_2198;
  assign select_2198 = equal_2166_s24_q ? {sharpness_comparing_contrast_0_q[0], and_2187_s24_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2200;
  assign select_2200 = equal_2166_s24_q ? {sharpness_comparing_contrast_1_q[0], and_2177_s24_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_2223;
  assign xor_2223 = sharpness_comparing_contrast_0_q[1] ^ and_2177_s24_q;
  logic select_2226;
  assign select_2226 = (equal_2210_s24_q | xor_2223) ? (and_2177_s24_q & xor_2223) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2227;
  assign select_2227 = equal_2166_s24_q ? select_2226 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2229;
  assign xor_2229 = sharpness_comparing_contrast_1_q[1] ^ and_2187_s24_q;
  logic select_2232;
  assign select_2232 = (equal_2210_s24_q | xor_2229) ? (and_2187_s24_q & xor_2229) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2233;
  assign select_2233 = equal_2166_s24_q ? select_2232 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1047
  logic not_2393;
  assign not_2393 = ~(equal_1912_s24_q ? and_1933 : not_2391_s24_q);
  // hls/stages/patches.hpp:303
  logic and_2396;
  assign and_2396 = ends_cell_s24_q & (not_2376_s24_q & (centres_values_1_textured_s24_q & not_2393));
  // hls/stages/agreement.hpp:1079
  logic [9:0] select_2409;
  assign select_2409 = ((~(select_2402_s24_q[9:4] == 6'h0)) & less_2407_s24_q) ? select_2402_s24_q : 10'h0;
  // hls/stages/patches.hpp:303
  logic [9:0] select_2412;
  assign select_2412 = equal_1466_s24_q ? (x_s24_q[6] ? (equal_1511_s24_q ? 10'h0 : select_2409) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1051
  logic and_2430;
  assign and_2430 = centres_values_1_textured_s24_q & (centres_values_1_of_skin_s24_q & not_2393);
  // hls/stages/registration.hpp:132
  logic [13:0] sum_2495;
  assign sum_2495 = registration_half_across_q + {{6{select_2494_s24_q[7]}}, select_2494_s24_q};
  // hls/stages/patches.hpp:303
  logic and_2499;
  assign and_2499 = not_1467_s24_q & (drew_q & (and_1607_s24_q & equal_1638_s24_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2501;
  assign select_2501 = and_2466_s24_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2499});
  // hls/stages/patches.hpp:303
  logic [1:0] select_2505;
  assign select_2505 = drew_q ? (equal_1638_s24_q ? {and_2503_s24_q, and_1607_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2506;
  assign select_2506 = equal_1466_s24_q ? 2'h0 : select_2505;
  // hls/stages/registration.hpp:181
  logic [6:0] sum_2507;
  assign sum_2507 = registration_half_votes_down_q + {{5{select_2506[1]}}, select_2506};
  // hls/stages/patches.hpp:303
  logic [1:0] select_2513;
  assign select_2513 = drew_q ? (equal_1638_s24_q ? {and_2511_s24_q, and_1607_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2514;
  assign select_2514 = equal_1466_s24_q ? 2'h0 : select_2513;
  // hls/stages/registration.hpp:182
  logic [6:0] sum_2515;
  assign sum_2515 = registration_half_votes_up_q + {{5{select_2514[1]}}, select_2514};
  // hls/stages/patches.hpp:303
  logic [1:0] select_2520;
  assign select_2520 = drew_q ? (equal_1638_s24_q ? {and_2518_s24_q, and_1607_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2521;
  assign select_2521 = equal_1466_s24_q ? 2'h0 : select_2520;
  // hls/stages/registration.hpp:181
  logic [6:0] sum_2522;
  assign sum_2522 = registration_half_half_votes_down_q + {{5{select_2521[1]}}, select_2521};
  // hls/stages/patches.hpp:303
  logic [1:0] select_2527;
  assign select_2527 = drew_q ? (equal_1638_s24_q ? {and_2525_s24_q, and_1607_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2528;
  assign select_2528 = equal_1466_s24_q ? 2'h0 : select_2527;
  // hls/stages/registration.hpp:182
  logic [6:0] sum_2529;
  assign sum_2529 = registration_half_half_votes_up_q + {{5{select_2528[1]}}, select_2528};
  // hls/stages/patches.hpp:303
  logic and_2563;
  assign and_2563 = equal_1466_s24_q & (x_s24_q[6] & (not_1833_s24_q & less_1542_s24_q));
  logic [11:0] select_2574;
  assign select_2574 = equal_1466_s24_q ? (x_s24_q[6] ? select_2572_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:249
  logic [13:0] sum_2582;
  assign sum_2582 = {{2{select_2574[11]}}, select_2574} + (and_2580_s24_q ? 14'h0 : registration_down_q);
  // hls/stages/patches.hpp:303
  logic [11:0] select_2589;
  assign select_2589 = equal_1466_s24_q ? (x_s24_q[6] ? select_2587_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:250
  logic [13:0] sum_2591;
  assign sum_2591 = {{2{select_2589[11]}}, select_2589} + (and_2580_s24_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:243
  logic not_2603;
  assign not_2603 = ~and_2602_s24_q;
  logic less_2604;
  assign less_2604 = $signed({9'h1, {2{not_2603}}, and_2602_s24_q}) < $signed(registration_up_q[13:2]);
  logic select_2605;
  assign select_2605 = and_2598_s24_q ? less_2604 : registration_enough_q;
  // hls/stages/agreement.hpp:1083
  logic and_2609;
  assign and_2609 = x_s24_q[6] & (not_1833_s24_q & (less_1542_s24_q & (x_s24_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:303
  logic and_2610;
  assign and_2610 = equal_1466_s24_q & and_2609;
  // hls/stages/registration.hpp:239
  logic less_2611;
  assign less_2611 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2613;
  assign less_2613 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1083
  logic and_2618;
  assign and_2618 = x_s24_q[6] & (not_1833_s24_q & (less_1542_s24_q & (x_s24_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:303
  logic and_2619;
  assign and_2619 = equal_1466_s24_q & and_2618;
  // hls/stages/agreement.hpp:1083
  logic and_2626;
  assign and_2626 = x_s24_q[6] & (not_1833_s24_q & (less_1542_s24_q & (x_s24_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:241
  logic and_2644;
  assign and_2644 = registration_votes_up_q & registration_other_down_q;
  logic select_2646;
  assign select_2646 = registration_votes_down_q ? (registration_other_up_q | and_2644) : and_2644;
  // hls/stages/registration.hpp:137
  logic and_2648;
  assign and_2648 = (equal_1466_s24_q & and_2642_s24_q) & (registration_other_enough_q & select_2646);
  logic and_2650;
  assign and_2650 = registration_enough_q & ((and_2634_s24_q & (less_2613 | less_2611)) | and_2648);
  // hls/stages/count_bits.hpp:24
  logic parity_3128;
  assign parity_3128 = ^{or_3120_s24_q, or_3116_s24_q, or_3112_s24_q, or_3105_s24_q, or_3101_s24_q, or_3097_s24_q, or_3090_s24_q, or_3086_s24_q, or_3082_s24_q, or_3075_s24_q, or_3071_s24_q, and_3067_s24_q};
  // hls/stages/count_bits.hpp:25
  logic or_3132;
  assign or_3132 = (or_3086_s24_q & or_3090_s24_q) | (or_3082_s24_q & (or_3086_s24_q | or_3090_s24_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3143;
  assign parity_3143 = ^{or_3140_s24_q, or_3136_s24_q, or_3132};
  // hls/stages/count_bits.hpp:25
  logic and_3144;
  assign and_3144 = (^{or_3075_s24_q, or_3071_s24_q, and_3067_s24_q}) & parity_3126_s24_q;
  logic or_3148;
  assign or_3148 = (or_3071_s24_q & or_3075_s24_q) | and_3147_s24_q;
  logic or_3152;
  assign or_3152 = and_3149_s24_q | and_3151_s24_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3155;
  assign parity_3155 = ^{or_3152, or_3148, and_3144};
  // hls/stages/count_bits.hpp:25
  logic and_3157;
  assign and_3157 = parity_3143 & parity_3155;
  logic or_3161;
  assign or_3161 = (or_3136_s24_q & or_3140_s24_q) | (or_3132 & (or_3136_s24_q | or_3140_s24_q));
  logic or_3165;
  assign or_3165 = (or_3148 & or_3152) | (and_3144 & (or_3148 | or_3152));
  // hls/stages/patches.hpp:518
  logic [14:0] difference_3363;
  assign difference_3363 = {{7{select_3357_s24_q[7]}}, select_3357_s24_q} - {product_3362_s24_q[13], product_3362_s24_q};
  // hls/stages/patches.hpp:524
  logic less_3364;
  assign less_3364 = $signed({{8{difference_3334[6]}}, difference_3334}) < $signed(difference_3363);
  // hls/stages/patches.hpp:303
  logic select_3604;
  assign select_3604 = equal_1466_s24_q ? ((x_s24_q[6] & good_known_q) | equal_3513_s24_q) : good_known_q;
  // hls/stages/agreement.hpp:1233
  logic and_3766;
  assign and_3766 = and_1973_s24_q & ({sum_1899_s24_q, index_2_s24_q} == {sum_1886_s24_q, index_s24_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1328; read in stage 24, written in stage 25: 24 < 25 < 24 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1886_s24_q, index_s24_q};
  logic map_re;
  assign map_re = s24_en & (and_1893_s24_q & less_1894_s24_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1699_s24_q, select_1696_s24_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s24_en & and_1709_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s24_q;
  end
`ifndef SYNTHESIS
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
  logic [9:0] patches_right_0_raddr_s23_sim;
  logic patches_right_0_re_s23_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      patches_right_0_re_s23_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_0_re_s13_sim <= patches_right_0_re;
      patches_right_0_raddr_s13_sim <= patches_right_0_raddr;
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
      patches_right_0_re_s23_sim <= patches_right_0_re_s22_sim;
      patches_right_0_raddr_s23_sim <= patches_right_0_raddr_s22_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_0_we) begin
      if (patches_right_0_re && patches_right_0_raddr == patches_right_0_waddr) begin
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
      if (patches_right_0_re_s23_sim && patches_right_0_raddr_s23_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_1699_s24_q, select_1722_s24_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s24_en & and_1726_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s24_q;
  end
`ifndef SYNTHESIS
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
  logic [9:0] patches_right_1_raddr_s23_sim;
  logic patches_right_1_re_s23_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      patches_right_1_re_s23_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_1_re_s13_sim <= patches_right_1_re;
      patches_right_1_raddr_s13_sim <= patches_right_1_raddr;
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
      patches_right_1_re_s23_sim <= patches_right_1_re_s22_sim;
      patches_right_1_raddr_s23_sim <= patches_right_1_raddr_s22_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_1_we) begin
      if (patches_right_1_re && patches_right_1_raddr == patches_right_1_waddr) begin
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
      if (patches_right_1_re_s23_sim && patches_right_1_raddr_s23_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
    end
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
      good_known_q <= 1'b0;
    end else if (s24_en) begin
      sharpness_sums_detail_0_q <= and_497_s24_q ? select_2144 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_497_s24_q ? select_2156 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2198 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2200 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_2227 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_2233 : sharpness_comparing_less_contrast_1_q;
      registration_half_across_q <= and_2466_s24_q ? 14'h0 : sum_2495;
      registration_half_measured_q <= select_2501;
      registration_half_votes_down_q <= and_2466_s24_q ? 7'h0 : sum_2507;
      registration_half_votes_up_q <= and_2466_s24_q ? 7'h0 : sum_2515;
      registration_half_half_votes_down_q <= and_2466_s24_q ? 7'h0 : sum_2522;
      registration_half_half_votes_up_q <= and_2466_s24_q ? 7'h0 : sum_2529;
      registration_down_q <= and_2563 ? sum_2582 : registration_down_q;
      registration_up_q <= and_2563 ? sum_2591 : registration_up_q;
      registration_enough_q <= select_2605;
      registration_votes_down_q <= and_2610 ? less_2611 : registration_votes_down_q;
      registration_votes_up_q <= and_2610 ? less_2613 : registration_votes_up_q;
      registration_other_enough_q <= and_2619 ? select_2605 : registration_other_enough_q;
      registration_other_down_q <= and_2619 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2619 ? registration_votes_up_q : registration_other_up_q;
      good_known_q <= select_3604;
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
    if (s24_en) begin
      census_changes_values_2_left_q <= select_2110;
      census_changes_values_2_right_q <= select_2111;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic census_columns_values_1_cell_2_of_skin_s25_q;
  logic [23:0] sharpness_sums_detail_0_s25_q;
  logic [23:0] sharpness_sums_detail_1_s25_q;
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
  logic [6:0] column_s25_q;
  logic and_497_s25_q;
  logic so_s25_q;
  logic less_531_s25_q;
  logic less_532_s25_q;
  logic less_533_s25_q;
  logic less_534_s25_q;
  logic less_535_s25_q;
  logic less_536_s25_q;
  logic less_537_s25_q;
  logic less_538_s25_q;
  logic less_539_s25_q;
  logic less_540_s25_q;
  logic less_541_s25_q;
  logic less_542_s25_q;
  logic less_543_s25_q;
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
  logic and_562_s25_q;
  logic and_587_s25_q;
  logic and_588_s25_q;
  logic [8:0] sum_610_s25_q;
  logic equal_1466_s25_q;
  logic not_1467_s25_q;
  logic equal_1511_s25_q;
  logic [1:0] sum_1517_s25_q;
  logic equal_1519_s25_q;
  logic equal_1521_s25_q;
  logic equal_1523_s25_q;
  logic equal_1525_s25_q;
  logic equal_1527_s25_q;
  logic equal_1529_s25_q;
  logic [19:0] sum_1571_s25_q;
  logic [11:0] sum_1575_s25_q;
  logic and_1576_s25_q;
  logic equal_1672_s25_q;
  logic equal_1674_s25_q;
  logic less_1804_s25_q;
  logic equal_1805_s25_q;
  logic not_1806_s25_q;
  logic equal_1807_s25_q;
  logic not_1833_s25_q;
  logic and_1893_s25_q;
  logic less_1894_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1899_s25_q;
  logic is_seen_s25_q;
  logic and_1963_s25_q;
  logic and_1973_s25_q;
  logic equal_2113_s25_q;
  logic [8:0] sum_2116_s25_q;
  logic equal_2166_s25_q;
  logic less_2167_s25_q;
  logic [17:0] select_2179_s25_q;
  logic [17:0] select_2189_s25_q;
  logic equal_2210_s25_q;
  logic and_2353_s25_q;
  logic and_2398_s25_q;
  logic [9:0] select_2402_s25_q;
  logic [9:0] select_2405_s25_q;
  logic [9:0] select_2412_s25_q;
  logic and_2433_s25_q;
  logic not_2628_s25_q;
  logic equal_2629_s25_q;
  logic and_2650_s25_q;
  logic parity_2937_s25_q;
  logic parity_3066_s25_q;
  logic parity_3128_s25_q;
  logic xor_3156_s25_q;
  logic parity_3168_s25_q;
  logic and_3169_s25_q;
  logic and_3171_s25_q;
  logic equal_3173_s25_q;
  logic or_3316_s25_q;
  logic [5:0] difference_3363_s25_q;
  logic not_3365_s25_q;
  logic not_3375_s25_q;
  logic equal_3414_s25_q;
  logic less_3484_s25_q;
  logic less_3485_s25_q;
  logic equal_3513_s25_q;
  logic or_3584_s25_q;
  logic select_3592_s25_q;
  logic equal_3605_s25_q;
  logic equal_3607_s25_q;
  logic equal_3608_s25_q;
  logic and_3751_s25_q;
  logic and_3766_s25_q;
  logic [31:0] select_3825_s25_q;
  logic [9:0] select_3832_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      census_columns_values_1_cell_2_of_skin_s25_q <= census_columns_values_1_cell_2_of_skin_s24_q;
      sharpness_sums_detail_0_s25_q <= sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_s25_q <= sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_s25_q <= sharpness_sums_contrast_0_s24_q;
      sharpness_sums_contrast_1_s25_q <= sharpness_sums_contrast_1_s24_q;
      x_s25_q <= x_s24_q;
      lower_half_s25_q <= lower_half_s24_q;
      counts_nearer_s25_q <= counts_nearer_s24_q;
      registration_of_right_s25_q <= registration_of_right_s24_q;
      patches_lower_s25_q <= patches_lower_s24_q;
      patches_second_s25_q <= patches_second_s24_q;
      patches_summed_row_column_s25_q <= patches_summed_row_column_s24_q;
      patches_summed_first_s25_q <= patches_summed_first_s24_q;
      patches_summed_last_s25_q <= patches_summed_last_s24_q;
      patches_summed_down_by_s25_q <= patches_summed_down_by_s24_q;
      product_s25_q <= product_s24_q;
      done_s25_q <= done_s24_q;
      column_s25_q <= column_s24_q;
      and_497_s25_q <= and_497_s24_q;
      so_s25_q <= drew_q;
      less_531_s25_q <= less_531_s24_q;
      less_532_s25_q <= less_532_s24_q;
      less_533_s25_q <= less_533_s24_q;
      less_534_s25_q <= less_534_s24_q;
      less_535_s25_q <= less_535_s24_q;
      less_536_s25_q <= less_536_s24_q;
      less_537_s25_q <= less_537_s24_q;
      less_538_s25_q <= less_538_s24_q;
      less_539_s25_q <= less_539_s24_q;
      less_540_s25_q <= less_540_s24_q;
      less_541_s25_q <= less_541_s24_q;
      less_542_s25_q <= less_542_s24_q;
      less_543_s25_q <= less_543_s24_q;
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
      and_562_s25_q <= and_562_s24_q;
      and_587_s25_q <= and_587_s24_q;
      and_588_s25_q <= and_588_s24_q;
      sum_610_s25_q <= sum_610[13:5];
      equal_1466_s25_q <= equal_1466_s24_q;
      not_1467_s25_q <= not_1467_s24_q;
      equal_1511_s25_q <= equal_1511_s24_q;
      sum_1517_s25_q <= sum_1517_s24_q;
      equal_1519_s25_q <= equal_1519_s24_q;
      equal_1521_s25_q <= equal_1521_s24_q;
      equal_1523_s25_q <= equal_1523_s24_q;
      equal_1525_s25_q <= equal_1525_s24_q;
      equal_1527_s25_q <= equal_1527_s24_q;
      equal_1529_s25_q <= equal_1529_s24_q;
      sum_1571_s25_q <= select_1567_s24_q + {{6{select_1570[13]}}, select_1570};
      sum_1575_s25_q <= select_1572_s24_q + {{5{select_1574[6]}}, select_1574};
      and_1576_s25_q <= and_1576_s24_q;
      equal_1672_s25_q <= equal_1672_s24_q;
      equal_1674_s25_q <= equal_1674_s24_q;
      less_1804_s25_q <= less_1804_s24_q;
      equal_1805_s25_q <= equal_1805_s24_q;
      not_1806_s25_q <= not_1806_s24_q;
      equal_1807_s25_q <= equal_1807_s24_q;
      not_1833_s25_q <= not_1833_s24_q;
      and_1893_s25_q <= and_1893_s24_q;
      less_1894_s25_q <= less_1894_s24_q;
      index_2_s25_q <= index_2_s24_q;
      sum_1899_s25_q <= sum_1899_s24_q;
      is_seen_s25_q <= is_seen;
      and_1963_s25_q <= is_seen & less_1962_s24_q;
      and_1973_s25_q <= and_1973_s24_q;
      equal_2113_s25_q <= equal_2113_s24_q;
      sum_2116_s25_q <= sum_2116[13:5];
      equal_2166_s25_q <= equal_2166_s24_q;
      less_2167_s25_q <= less_2167_s24_q;
      select_2179_s25_q <= select_2179;
      select_2189_s25_q <= select_2189;
      equal_2210_s25_q <= equal_2210_s24_q;
      and_2353_s25_q <= and_2353_s24_q;
      and_2398_s25_q <= not_1467_s24_q & (drew_q & and_2396);
      select_2402_s25_q <= select_2402_s24_q;
      select_2405_s25_q <= select_2405_s24_q;
      select_2412_s25_q <= select_2412;
      and_2433_s25_q <= drew_q & (ends_cell_s24_q & (not_2376_s24_q & and_2430));
      not_2628_s25_q <= ~(equal_1466_s24_q & and_2626);
      equal_2629_s25_q <= equal_2629_s24_q;
      and_2650_s25_q <= and_2650;
      parity_2937_s25_q <= parity_2937_s24_q;
      parity_3066_s25_q <= parity_3066_s24_q;
      parity_3128_s25_q <= parity_3128;
      xor_3156_s25_q <= parity_3143 ^ parity_3155;
      parity_3168_s25_q <= ^{or_3165, or_3161, and_3157};
      and_3169_s25_q <= or_3161 & or_3165;
      and_3171_s25_q <= and_3157 & (or_3161 | or_3165);
      equal_3173_s25_q <= equal_3173_s24_q;
      or_3316_s25_q <= equal_3304_s24_q | or_3315_s24_q;
      difference_3363_s25_q <= difference_3363[5:0];
      not_3365_s25_q <= ~less_3364;
      not_3375_s25_q <= ~($signed(difference_3363) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3414_s25_q <= equal_3414_s24_q;
      less_3484_s25_q <= $signed(15'h10) < $signed(difference_3363);
      less_3485_s25_q <= $signed(difference_3363[14:4]) < $signed(11'h7ff);
      equal_3513_s25_q <= equal_3513_s24_q;
      or_3584_s25_q <= or_3584_s24_q;
      select_3592_s25_q <= select_3592_s24_q;
      equal_3605_s25_q <= equal_3605_s24_q;
      equal_3607_s25_q <= equal_3607_s24_q;
      equal_3608_s25_q <= equal_3608_s24_q;
      and_3751_s25_q <= said_q;
      and_3766_s25_q <= and_3766;
      select_3825_s25_q <= select_3825_s24_q;
      select_3832_s25_q <= select_3832_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_unproven_q;
  logic registration_moved_q;
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
  logic proven_q;
  // hls/stages/patches.hpp:160
  logic less_1816;
  assign less_1816 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:161
  logic not_1817;
  assign not_1817 = ~less_1816;
  logic [1:0] select_1818;
  assign select_1818 = patches_summed_first_s25_q ? 2'h2 : {less_1816, not_1817};
  logic [12:0] select_1819;
  assign select_1819 = select_1818[0] ? {4'h0, patches_summed_first_s25_q, 3'h0, patches_summed_row_column_s25_q} : {patches_summed_row_column_s25_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1820;
  assign select_1820 = select_1818[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1821;
  assign select_1821 = select_1818[1] ? {select_1819[12:8], patches_sums_values_0_q[9:8], select_1819[7:0]} : select_1820;
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2179_s25_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2182;
  assign select_2182 = equal_2166_s25_q ? (less_2167_s25_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2189_s25_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2192;
  assign select_2192 = equal_2166_s25_q ? (less_2167_s25_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2400;
  assign select_2400 = and_2353_s25_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2398_s25_q});
  logic [13:0] select_2414;
  assign select_2414 = and_2353_s25_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2412_s25_q});
  // hls/stages/patches.hpp:303
  logic and_2434;
  assign and_2434 = not_1467_s25_q & and_2433_s25_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2436;
  assign select_2436 = and_2353_s25_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2434});
  // hls/stages/count_bits.hpp:27
  logic or_3172;
  assign or_3172 = and_3169_s25_q | and_3171_s25_q;
  // hls/stages/patches.hpp:445
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3172, parity_3168_s25_q, xor_3156_s25_q, parity_3128_s25_q, parity_3066_s25_q, parity_2937_s25_q} + (equal_3173_s25_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:160
  logic [9:0] select_3177;
  assign select_3177 = equal_1672_s25_q ? patches_sums_values_0_q : (equal_1674_s25_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3178;
  assign select_3178 = equal_1674_s25_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3180;
  assign select_3180 = equal_1674_s25_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3182;
  assign select_3182 = equal_1674_s25_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3184;
  assign select_3184 = equal_1674_s25_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3186;
  assign select_3186 = equal_1674_s25_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3188;
  assign select_3188 = equal_1674_s25_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3190;
  assign select_3190 = equal_1674_s25_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3192;
  assign select_3192 = equal_1674_s25_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3194;
  assign select_3194 = equal_1674_s25_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3196;
  assign select_3196 = equal_1674_s25_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3198;
  assign select_3198 = equal_1674_s25_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3200;
  assign select_3200 = equal_1674_s25_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3202;
  assign select_3202 = equal_1674_s25_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3204;
  assign select_3204 = equal_1674_s25_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3206;
  assign select_3206 = equal_1674_s25_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3208;
  assign select_3208 = equal_1674_s25_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:499
  logic not_3317;
  assign not_3317 = ~or_3316_s25_q;
  // hls/stages/patches.hpp:480
  logic and_3318;
  assign and_3318 = equal_1807_s25_q & not_3317;
  // hls/stages/patches.hpp:160
  logic and_3321;
  assign and_3321 = equal_1672_s25_q & (less_1804_s25_q ? (not_1806_s25_q & and_3318) : and_3318);
  // hls/stages/patches.hpp:480
  logic and_3324;
  assign and_3324 = equal_1807_s25_q & (patches_second_s25_q & not_3317);
  // hls/stages/patches.hpp:160
  logic and_3327;
  assign and_3327 = equal_1672_s25_q & (less_1804_s25_q ? (not_1806_s25_q & and_3324) : and_3324);
  // hls/stages/patches.hpp:480
  logic and_3367;
  assign and_3367 = equal_1807_s25_q & (not_3317 & not_3365_s25_q);
  // hls/stages/patches.hpp:160
  logic and_3370;
  assign and_3370 = equal_1672_s25_q & (less_1804_s25_q ? (not_1806_s25_q & and_3367) : and_3367);
  // hls/stages/patches.hpp:480
  logic and_3377;
  assign and_3377 = equal_1807_s25_q & (not_3317 & not_3375_s25_q);
  // hls/stages/patches.hpp:160
  logic and_3380;
  assign and_3380 = equal_1672_s25_q & (less_1804_s25_q ? (not_1806_s25_q & and_3377) : and_3377);
  // hls/stages/agreement.hpp:1071
  logic less_3413;
  assign less_3413 = x_s25_q[5:3] < 3'h5;
  // hls/stages/registration.hpp:149
  logic not_3415;
  assign not_3415 = ~x_s25_q[4];
  // hls/stages/registration.hpp:156
  logic not_3416;
  assign not_3416 = ~x_s25_q[3];
  // hls/stages/patches.hpp:175
  logic and_3417;
  assign and_3417 = not_3415 & not_3416;
  logic [1:0] select_3418;
  assign select_3418 = x_s25_q[4] ? {1'b1, x_s25_q[3]} : {not_3416, 1'b1};
  logic [3:0] select_3419;
  assign select_3419 = x_s25_q[5] ? {{2{and_3417}}, 2'h0} : {not_3416, not_3415, select_3418};
  // hls/stages/agreement.hpp:1083
  logic and_3422;
  assign and_3422 = not_1833_s25_q & (less_3413 & (equal_3414_s25_q & select_3419[0]));
  // hls/stages/patches.hpp:175
  logic equal_3426;
  assign equal_3426 = x_s25_q[2:0] == 3'h1;
  // hls/stages/agreement.hpp:1083
  logic and_3430;
  assign and_3430 = x_s25_q[6] & (not_1833_s25_q & (less_3413 & (select_3419[1] & equal_3426)));
  logic and_3437;
  assign and_3437 = not_1833_s25_q & (less_3413 & (select_3419[2] & (x_s25_q[2:0] == 3'h2)));
  logic and_3445;
  assign and_3445 = not_1833_s25_q & (less_3413 & (select_3419[3] & (x_s25_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:179
  logic [4:0] sum_3464;
  assign sum_3464 = {2'h0, x_s25_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:303
  logic and_3473;
  assign and_3473 = equal_1466_s25_q & (x_s25_q[6] & (not_1833_s25_q & (less_3413 & equal_3426)));
  // hls/stages/patches.hpp:525
  logic [5:0] select_3487;
  assign select_3487 = less_3484_s25_q ? 6'h10 : (less_3485_s25_q ? 6'h30 : difference_3363_s25_q);
  // hls/stages/patches.hpp:480
  logic [5:0] select_3489;
  assign select_3489 = equal_1807_s25_q ? (or_3316_s25_q ? 6'h0 : select_3487) : 6'h0;
  logic [5:0] select_3491;
  assign select_3491 = less_1804_s25_q ? (equal_1805_s25_q ? 6'h0 : select_3489) : select_3489;
  // hls/stages/patches.hpp:303
  logic and_3498;
  assign and_3498 = equal_1466_s25_q & (x_s25_q[6] & (not_1833_s25_q & (equal_2629_s25_q & less_3413)));
  // hls/stages/agreement.hpp:1083
  logic and_3502;
  assign and_3502 = x_s25_q[6] & (not_1833_s25_q & (less_3413 & (x_s25_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:1066
  logic [13:0] select_3610;
  assign select_3610 = equal_3607_s25_q ? counts_skin_unproven_q : (equal_3608_s25_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3605_s25_q ? counts_nearer_s25_q : select_3610;
  // hls/stages/patches.hpp:303
  logic and_3781;
  assign and_3781 = equal_1466_s25_q & (equal_3513_s25_q & (cfg_prove_i & (~proven_q)));
  logic and_3816;
  assign and_3816 = equal_1466_s25_q & (x_s25_q[6] & (not_1833_s25_q | (4'hc < x_s25_q[5:2])));
  // hls/stages/agreement.hpp:1081
  logic [31:0] select_3826;
  assign select_3826 = equal_1529_s25_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3825_s25_q;
  logic [31:0] select_3827;
  assign select_3827 = equal_1527_s25_q ? {8'h0, sharpness_sums_detail_0_s25_q} : select_3826;
  logic [31:0] select_3828;
  assign select_3828 = equal_1525_s25_q ? {8'h0, sharpness_sums_detail_1_s25_q} : select_3827;
  logic [31:0] select_3829;
  assign select_3829 = equal_1523_s25_q ? {8'h0, sharpness_sums_contrast_0_s25_q} : select_3828;
  logic [31:0] select_3830;
  assign select_3830 = equal_1521_s25_q ? {8'h0, sharpness_sums_contrast_1_s25_q} : select_3829;

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1517_s25_q, lower_half_s25_q, registration_of_right_s25_q};
  logic registration_sums_we;
  assign registration_sums_we = s25_en & and_1576_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1575_s25_q, sum_1571_s25_q};
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
  assign map_waddr = {sum_1899_s25_q, index_2_s25_q};
  logic map_we;
  assign map_we = s25_en & and_1973_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1963_s25_q, is_seen_s25_q};
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
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_unproven_q <= 14'h0;
      registration_moved_q <= 1'b0;
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
      proven_q <= 1'b0;
    end else if (s25_en) begin
      sharpness_comparing_rest_0_q <= so_s25_q ? select_2182 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s25_q ? select_2192 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2400;
      counts_regions_bad_q <= select_2414;
      counts_skin_unproven_q <= select_2436;
      registration_moved_q <= not_2628_s25_q & (registration_moved_q | and_2650_s25_q);
      patches_sums_values_0_q <= select_3177;
      patches_sums_values_1_q <= equal_1672_s25_q ? patches_sums_values_1_q : select_3178;
      patches_sums_values_2_q <= equal_1672_s25_q ? patches_sums_values_2_q : select_3180;
      patches_sums_values_3_q <= equal_1672_s25_q ? patches_sums_values_3_q : select_3182;
      patches_sums_values_4_q <= equal_1672_s25_q ? patches_sums_values_4_q : select_3184;
      patches_sums_values_5_q <= equal_1672_s25_q ? patches_sums_values_5_q : select_3186;
      patches_sums_values_6_q <= equal_1672_s25_q ? patches_sums_values_6_q : select_3188;
      patches_sums_values_7_q <= equal_1672_s25_q ? patches_sums_values_7_q : select_3190;
      patches_sums_values_8_q <= equal_1672_s25_q ? patches_sums_values_8_q : select_3192;
      patches_sums_values_9_q <= equal_1672_s25_q ? patches_sums_values_9_q : select_3194;
      patches_sums_values_10_q <= equal_1672_s25_q ? patches_sums_values_10_q : select_3196;
      patches_sums_values_11_q <= equal_1672_s25_q ? patches_sums_values_11_q : select_3198;
      patches_sums_values_12_q <= equal_1672_s25_q ? patches_sums_values_12_q : select_3200;
      patches_sums_values_13_q <= equal_1672_s25_q ? patches_sums_values_13_q : select_3202;
      patches_sums_values_14_q <= equal_1672_s25_q ? patches_sums_values_14_q : select_3204;
      patches_sums_values_15_q <= equal_1672_s25_q ? patches_sums_values_15_q : select_3206;
      patches_sums_values_16_q <= equal_1672_s25_q ? patches_sums_values_16_q : select_3208;
      patches_best_differing_q <= select_1821[9:0];
      patches_best_column_q <= select_1821[14:10];
      proven_q <= marks_first_s25_q ? done_s25_q : proven_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s25_en) begin
      left_pixel_q <= left_pixel_q;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic census_columns_values_1_cell_2_of_skin_s26_q;
  logic [6:0] x_s26_q;
  logic registration_moved_s26_q;
  logic patches_lower_s26_q;
  logic patches_summed_last_s26_q;
  logic [4:0] patches_summed_down_by_s26_q;
  logic [13:0] product_s26_q;
  logic [6:0] column_s26_q;
  logic and_497_s26_q;
  logic so_s26_q;
  logic less_531_s26_q;
  logic less_532_s26_q;
  logic less_533_s26_q;
  logic less_534_s26_q;
  logic less_535_s26_q;
  logic less_536_s26_q;
  logic less_537_s26_q;
  logic less_538_s26_q;
  logic less_539_s26_q;
  logic less_540_s26_q;
  logic less_541_s26_q;
  logic less_542_s26_q;
  logic less_543_s26_q;
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
  logic and_562_s26_q;
  logic and_587_s26_q;
  logic and_588_s26_q;
  logic less_611_s26_q;
  logic equal_1466_s26_q;
  logic equal_1511_s26_q;
  logic equal_1519_s26_q;
  logic and_1893_s26_q;
  logic less_1894_s26_q;
  logic [1:0] map_rdata_s26_q;
  logic is_seen_s26_q;
  logic and_1963_s26_q;
  logic equal_2113_s26_q;
  logic and_2118_s26_q;
  logic equal_2166_s26_q;
  logic sum_s26_q;
  logic sum_2_s26_q;
  logic equal_2210_s26_q;
  logic select_2228_s26_q;
  logic select_2234_s26_q;
  logic [9:0] select_2402_s26_q;
  logic [9:0] select_2405_s26_q;
  logic and_3321_s26_q;
  logic and_3327_s26_q;
  logic and_3370_s26_q;
  logic and_3380_s26_q;
  logic equal_3414_s26_q;
  logic and_3423_s26_q;
  logic and_3430_s26_q;
  logic and_3438_s26_q;
  logic and_3446_s26_q;
  logic and_3467_s26_q;
  logic and_3473_s26_q;
  logic [5:0] select_3492_s26_q;
  logic and_3498_s26_q;
  logic and_3503_s26_q;
  logic equal_3513_s26_q;
  logic or_3584_s26_q;
  logic select_3592_s26_q;
  logic and_3606_s26_q;
  logic [13:0] before_v_4_s26_q;
  logic not_3643_s26_q;
  logic or_3647_s26_q;
  logic and_3751_s26_q;
  logic and_3766_s26_q;
  logic and_3781_s26_q;
  logic and_3816_s26_q;
  logic [31:0] select_3830_s26_q;
  logic [9:0] select_3832_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      census_columns_values_1_cell_2_of_skin_s26_q <= census_columns_values_1_cell_2_of_skin_s25_q;
      x_s26_q <= x_s25_q;
      registration_moved_s26_q <= registration_moved_q;
      patches_lower_s26_q <= patches_lower_s25_q;
      patches_summed_last_s26_q <= patches_summed_last_s25_q;
      patches_summed_down_by_s26_q <= patches_summed_down_by_s25_q;
      product_s26_q <= product_s25_q;
      column_s26_q <= column_s25_q;
      and_497_s26_q <= and_497_s25_q;
      so_s26_q <= so_s25_q;
      less_531_s26_q <= less_531_s25_q;
      less_532_s26_q <= less_532_s25_q;
      less_533_s26_q <= less_533_s25_q;
      less_534_s26_q <= less_534_s25_q;
      less_535_s26_q <= less_535_s25_q;
      less_536_s26_q <= less_536_s25_q;
      less_537_s26_q <= less_537_s25_q;
      less_538_s26_q <= less_538_s25_q;
      less_539_s26_q <= less_539_s25_q;
      less_540_s26_q <= less_540_s25_q;
      less_541_s26_q <= less_541_s25_q;
      less_542_s26_q <= less_542_s25_q;
      less_543_s26_q <= less_543_s25_q;
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
      and_562_s26_q <= and_562_s25_q;
      and_587_s26_q <= and_587_s25_q;
      and_588_s26_q <= and_588_s25_q;
      less_611_s26_q <= 9'h4 < sum_610_s25_q;
      equal_1466_s26_q <= equal_1466_s25_q;
      equal_1511_s26_q <= equal_1511_s25_q;
      equal_1519_s26_q <= equal_1519_s25_q;
      and_1893_s26_q <= and_1893_s25_q;
      less_1894_s26_q <= less_1894_s25_q;
      map_rdata_s26_q <= map_rdata_q;
      is_seen_s26_q <= is_seen_s25_q;
      and_1963_s26_q <= and_1963_s25_q;
      equal_2113_s26_q <= equal_2113_s25_q;
      and_2118_s26_q <= and_587_s25_q & (9'h4 < sum_2116_s25_q);
      equal_2166_s26_q <= equal_2166_s25_q;
      sum_s26_q <= sum[0];
      sum_2_s26_q <= sum_2[0];
      equal_2210_s26_q <= equal_2210_s25_q;
      select_2228_s26_q <= sharpness_comparing_less_contrast_0_q;
      select_2234_s26_q <= sharpness_comparing_less_contrast_1_q;
      select_2402_s26_q <= select_2402_s25_q;
      select_2405_s26_q <= select_2405_s25_q;
      and_3321_s26_q <= and_3321;
      and_3327_s26_q <= and_3327;
      and_3370_s26_q <= and_3370;
      and_3380_s26_q <= and_3380;
      equal_3414_s26_q <= equal_3414_s25_q;
      and_3423_s26_q <= x_s25_q[6] & and_3422;
      and_3430_s26_q <= and_3430;
      and_3438_s26_q <= x_s25_q[6] & and_3437;
      and_3446_s26_q <= x_s25_q[6] & and_3445;
      and_3467_s26_q <= not_1833_s25_q & (less_3413 & (sum_3464[4:2] == 3'h0));
      and_3473_s26_q <= and_3473;
      select_3492_s26_q <= equal_1672_s25_q ? select_3491 : 6'h0;
      and_3498_s26_q <= and_3498;
      and_3503_s26_q <= equal_1466_s25_q & and_3502;
      equal_3513_s26_q <= equal_3513_s25_q;
      or_3584_s26_q <= or_3584_s25_q;
      select_3592_s26_q <= select_3592_s25_q;
      and_3606_s26_q <= equal_3605_s25_q & equal_3414_s25_q;
      before_v_4_s26_q <= before_v_4;
      not_3643_s26_q <= ~(equal_3608_s25_q & equal_3414_s25_q);
      or_3647_s26_q <= (equal_3608_s25_q | equal_3607_s25_q) | (x_s25_q[6:3] == 4'hf);
      and_3751_s26_q <= and_3751_s25_q;
      and_3766_s26_q <= and_3766_s25_q;
      and_3781_s26_q <= and_3781;
      and_3816_s26_q <= and_3816;
      select_3830_s26_q <= select_3830;
      select_3832_s26_q <= select_3832_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
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
  logic patches_complete_q;
  logic patches_round_ends_q;
  logic [4:0] patches_found_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [4:0] patches_round_moved_q;
  logic patches_moved_q;
  logic hides_q;
  // hls/stages/census.hpp:303
  logic and_612;
  assign and_612 = and_562_s26_q & less_611_s26_q;
  // hls/stages/census.hpp:306
  logic and_2119;
  assign and_2119 = and_587_s26_q & less_611_s26_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2120;
  assign sum_2120 = census_left_misses_q + {{17{and_2119}}, and_2118_s26_q, 1'b0, and_2118_s26_q};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2122;
  assign select_2122 = and_497_s26_q ? (equal_2113_s26_q ? 20'h0 : sum_2120) : census_left_misses_q;
  // hls/stages/agreement.hpp:207
  logic [2:0] select_2194;
  assign select_2194 = equal_2166_s26_q ? {sharpness_comparing_product_0_q[1:0], sum_s26_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2196;
  assign select_2196 = equal_2166_s26_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s26_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s26_q});
  // hls/stages/agreement.hpp:207
  logic select_2205;
  assign select_2205 = so_s26_q ? (equal_2166_s26_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s26_q});
  // hls/stages/agreement.hpp:207
  logic select_2208;
  assign select_2208 = equal_2166_s26_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_2211;
  assign xor_2211 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2217;
  assign xor_2217 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:557
  logic not_3322;
  assign not_3322 = ~patches_lower_s26_q;
  logic not_3328;
  assign not_3328 = ~and_3327_s26_q;
  // hls/stages/patches.hpp:164
  logic and_3330;
  assign and_3330 = and_3321_s26_q & (not_3322 & not_3328);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3332;
  assign sum_3332 = {7'h0, and_3330} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:560
  logic and_3371;
  assign and_3371 = and_3370_s26_q & and_3330;
  logic [7:0] sum_3372;
  assign sum_3372 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3371};
  // hls/stages/patches.hpp:561
  logic and_3381;
  assign and_3381 = and_3380_s26_q & and_3330;
  logic [7:0] sum_3382;
  assign sum_3382 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3381};
  // hls/stages/patches.hpp:164
  logic and_3384;
  assign and_3384 = and_3321_s26_q & (and_3327_s26_q & not_3322);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3386;
  assign sum_3386 = {7'h0, and_3384} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:560
  logic and_3388;
  assign and_3388 = and_3370_s26_q & and_3384;
  logic [7:0] sum_3389;
  assign sum_3389 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3388};
  // hls/stages/patches.hpp:561
  logic and_3391;
  assign and_3391 = and_3380_s26_q & and_3384;
  logic [7:0] sum_3392;
  assign sum_3392 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3391};
  // hls/stages/patches.hpp:164
  logic and_3394;
  assign and_3394 = and_3321_s26_q & (patches_lower_s26_q & not_3328);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3396;
  assign sum_3396 = {7'h0, and_3394} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:560
  logic and_3398;
  assign and_3398 = and_3370_s26_q & and_3394;
  logic [7:0] sum_3399;
  assign sum_3399 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3398};
  // hls/stages/patches.hpp:561
  logic and_3401;
  assign and_3401 = and_3380_s26_q & and_3394;
  logic [7:0] sum_3402;
  assign sum_3402 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3401};
  // hls/stages/patches.hpp:164
  logic and_3404;
  assign and_3404 = and_3321_s26_q & (patches_lower_s26_q & and_3327_s26_q);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3406;
  assign sum_3406 = {7'h0, and_3404} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:560
  logic and_3408;
  assign and_3408 = and_3370_s26_q & and_3404;
  logic [7:0] sum_3409;
  assign sum_3409 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3408};
  // hls/stages/patches.hpp:561
  logic and_3411;
  assign and_3411 = and_3380_s26_q & and_3404;
  logic [7:0] sum_3412;
  assign sum_3412 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3411};
  // hls/stages/patches.hpp:303
  logic and_3424;
  assign and_3424 = equal_1466_s26_q & and_3423_s26_q;
  logic and_3431;
  assign and_3431 = equal_1466_s26_q & and_3430_s26_q;
  // hls/stages/patches.hpp:541
  logic [7:0] or_3433;
  assign or_3433 = (and_3424 ? patches_quarters_0_places_q : 8'h0) | (and_3431 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/patches.hpp:303
  logic and_3439;
  assign and_3439 = equal_1466_s26_q & and_3438_s26_q;
  logic and_3447;
  assign and_3447 = equal_1466_s26_q & and_3446_s26_q;
  // hls/stages/patches.hpp:541
  logic [7:0] or_3449;
  assign or_3449 = (or_3433 | (and_3439 ? patches_quarters_2_places_q : 8'h0)) | (and_3447 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:542
  logic [7:0] or_3452;
  assign or_3452 = (and_3424 ? patches_quarters_0_up_q : 8'h0) | (and_3431 ? patches_quarters_1_up_q : 8'h0);
  logic [7:0] or_3456;
  assign or_3456 = (or_3452 | (and_3439 ? patches_quarters_2_up_q : 8'h0)) | (and_3447 ? patches_quarters_3_up_q : 8'h0);
  // hls/stages/patches.hpp:543
  logic [7:0] or_3459;
  assign or_3459 = (and_3424 ? patches_quarters_0_down_q : 8'h0) | (and_3431 ? patches_quarters_1_down_q : 8'h0);
  logic [7:0] or_3463;
  assign or_3463 = (or_3459 | (and_3439 ? patches_quarters_2_down_q : 8'h0)) | (and_3447 ? patches_quarters_3_down_q : 8'h0);
  // hls/stages/patches.hpp:303
  logic and_3469;
  assign and_3469 = equal_1466_s26_q & (x_s26_q[6] & and_3467_s26_q);
  // hls/stages/patches.hpp:536
  logic [7:0] sum_3475;
  assign sum_3475 = patches_word_places_q + (and_3473_s26_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:538
  logic [7:0] select_3479;
  assign select_3479 = and_3469 ? (patches_word_up_q + (and_3473_s26_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3481;
  assign sum_3481 = patches_word_down_q + (and_3473_s26_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:563
  logic [5:0] select_3493;
  assign select_3493 = and_3321_s26_q ? select_3492_s26_q : 6'h0;
  logic [11:0] sum_3494;
  assign sum_3494 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3493[5]}}, select_3493};
  // hls/stages/patches.hpp:552
  logic [7:0] select_3505;
  assign select_3505 = and_3498_s26_q ? (and_3503_s26_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:554
  logic or_3509;
  assign or_3509 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:551
  logic select_3511;
  assign select_3511 = and_3498_s26_q ? (and_3503_s26_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:164
  logic and_3517;
  assign and_3517 = patches_complete_q & (equal_1466_s26_q & ((x_s26_q == 7'h70) & (~equal_3513_s26_q)));
  logic and_3518;
  assign and_3518 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3519;
  assign select_3519 = and_3498_s26_q ? {and_3518, patches_found_q[4:1]} : patches_found_q;
  logic [4:0] select_3521;
  assign select_3521 = and_3498_s26_q ? (and_3503_s26_q ? {and_3518, patches_found_q[4:1]} : select_3519) : patches_found_q;
  // hls/stages/patches.hpp:550
  logic select_3527;
  assign select_3527 = patches_round_ends_q ? (~(patches_found_q == 5'h0)) : patches_moved_q;
  // hls/stages/agreement.hpp:1152
  logic [14:0] over;
  assign over = {1'b0, product_s26_q} - {1'b0, before_v_4_s26_q};
  // hls/stages/agreement.hpp:1160
  logic select_3613;
  assign select_3613 = and_3606_s26_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1233
  logic [1:0] select_3767;
  assign select_3767 = and_3766_s26_q ? {and_1963_s26_q, is_seen_s26_q} : map_rdata_s26_q;
  // hls/stages/agreement.hpp:1234
  logic and_3768;
  assign and_3768 = proven_q & less_3756;
  // hls/stages/patches.hpp:303
  logic and_3793;
  assign and_3793 = equal_3513_s26_q & (cfg_prove_i & (registration_moved_s26_q | patches_moved_q));
  // hls/stages/agreement.hpp:1087
  logic or_3796;
  assign or_3796 = select_2228_s26_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:1081
  logic [31:0] select_3831;
  assign select_3831 = equal_1519_s26_q ? {7'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3830_s26_q;
  // hls/stages/agreement.hpp:1083
  logic [31:0] select_3833;
  assign select_3833 = equal_1511_s26_q ? select_3831 : {2'h0, select_3832_s26_q, select_2405_s26_q, select_2402_s26_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s26_q;
  logic fresh_we;
  assign fresh_we = s26_en & and_497_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s26_q, and_612, and_588_s26_q, and_587_s26_q, and_562_s26_q, less_554_s26_q, less_553_s26_q, less_552_s26_q, less_551_s26_q, less_550_s26_q, less_549_s26_q, less_548_s26_q, less_547_s26_q, less_546_s26_q, less_545_s26_q, less_544_s26_q, less_543_s26_q, less_542_s26_q, less_541_s26_q, less_540_s26_q, less_539_s26_q, less_538_s26_q, less_537_s26_q, less_536_s26_q, less_535_s26_q, less_534_s26_q, less_533_s26_q, less_532_s26_q, less_531_s26_q};
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
      if (fresh_waddr >= 7'd120) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd120) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s26_q;
  logic patches_rows_we;
  assign patches_rows_we = s26_en & patches_summed_last_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= {patches_best_column_q, patches_best_differing_q};
  end
`ifndef SYNTHESIS
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
  logic [4:0] patches_rows_raddr_s25_sim;
  logic patches_rows_re_s25_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      patches_rows_re_s25_sim <= 1'b0;
    end else if (en_i) begin
      patches_rows_re_s13_sim <= patches_rows_re;
      patches_rows_raddr_s13_sim <= patches_rows_raddr;
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
      patches_rows_re_s25_sim <= patches_rows_re_s24_sim;
      patches_rows_raddr_s25_sim <= patches_rows_raddr_s24_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
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
      if (patches_rows_re_s25_sim && patches_rows_raddr_s25_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_left_misses_q <= 20'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
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
      patches_complete_q <= 1'b0;
      patches_round_ends_q <= 1'b0;
      patches_found_q <= 5'h0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 5'h0;
      patches_moved_q <= 1'b0;
      hides_q <= 1'b0;
    end else if (s26_en) begin
      census_left_misses_q <= select_2122;
      sharpness_comparing_product_0_q <= so_s26_q ? select_2194 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s26_q ? select_2196 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2205;
      sharpness_comparing_carry_1_q <= so_s26_q ? select_2208 : sharpness_comparing_carry_1_q;
      patches_quarters_0_places_q <= sum_3332;
      patches_quarters_0_up_q <= sum_3372;
      patches_quarters_0_down_q <= sum_3382;
      patches_quarters_1_places_q <= sum_3386;
      patches_quarters_1_up_q <= sum_3389;
      patches_quarters_1_down_q <= sum_3392;
      patches_quarters_2_places_q <= sum_3396;
      patches_quarters_2_up_q <= sum_3399;
      patches_quarters_2_down_q <= sum_3402;
      patches_quarters_3_places_q <= sum_3406;
      patches_quarters_3_up_q <= sum_3409;
      patches_quarters_3_down_q <= sum_3412;
      patches_word_places_q <= or_3449;
      patches_word_up_q <= or_3456;
      patches_word_down_q <= or_3463;
      patches_sum_places_q <= and_3469 ? sum_3475 : patches_sum_places_q;
      patches_sum_up_q <= select_3479;
      patches_sum_down_q <= and_3469 ? sum_3481 : patches_sum_down_q;
      patches_across_q <= sum_3494;
      patches_places_q <= select_3505;
      patches_enough_q <= {4'h0, and_3503_s26_q} < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3509;
      patches_complete_q <= select_3511;
      patches_round_ends_q <= and_3517;
      patches_found_q <= select_3521;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_moved_q <= select_3527;
      hides_q <= equal_1466_s26_q ? select_3613 : hides_q;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic so_s27_q;
  logic equal_1466_s27_q;
  logic and_1893_s27_q;
  logic less_1894_s27_q;
  logic equal_2166_s27_q;
  logic or_2212_s27_q;
  logic and_2213_s27_q;
  logic or_2218_s27_q;
  logic and_2219_s27_q;
  logic select_2234_s27_q;
  logic equal_3513_s27_q;
  logic or_3584_s27_q;
  logic select_3592_s27_q;
  logic select_3613_s27_q;
  logic and_3641_s27_q;
  logic not_3643_s27_q;
  logic or_3647_s27_q;
  logic and_3751_s27_q;
  logic and_3769_s27_q;
  logic and_3772_s27_q;
  logic and_3781_s27_q;
  logic and_3794_s27_q;
  logic or_3796_s27_q;
  logic and_3816_s27_q;
  logic [5:0] select_3818_s27_q;
  logic [31:0] select_3835_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      so_s27_q <= so_s26_q;
      equal_1466_s27_q <= equal_1466_s26_q;
      and_1893_s27_q <= and_1893_s26_q;
      less_1894_s27_q <= less_1894_s26_q;
      equal_2166_s27_q <= equal_2166_s26_q;
      or_2212_s27_q <= equal_2210_s26_q | xor_2211;
      and_2213_s27_q <= five_times[0] & xor_2211;
      or_2218_s27_q <= equal_2210_s26_q | xor_2217;
      and_2219_s27_q <= five_times_2[0] & xor_2217;
      select_2234_s27_q <= select_2234_s26_q;
      equal_3513_s27_q <= equal_3513_s26_q;
      or_3584_s27_q <= or_3584_s26_q;
      select_3592_s27_q <= select_3592_s26_q;
      select_3613_s27_q <= select_3613;
      and_3641_s27_q <= over[14] & equal_3414_s26_q;
      not_3643_s27_q <= not_3643_s26_q;
      or_3647_s27_q <= or_3647_s26_q;
      and_3751_s27_q <= and_3751_s26_q;
      and_3769_s27_q <= select_3767[0] & and_3768;
      and_3772_s27_q <= select_3767[1] & and_3768;
      and_3781_s27_q <= and_3781_s26_q;
      and_3794_s27_q <= equal_1466_s26_q & and_3793;
      or_3796_s27_q <= or_3796;
      and_3816_s27_q <= and_3816_s26_q;
      select_3818_s27_q <= equal_1466_s26_q ? (x_s26_q[6] ? x_s26_q[5:0] : 6'h0) : 6'h0;
      select_3835_s27_q <= equal_1466_s26_q ? (x_s26_q[6] ? select_3833 : 32'h0) : 32'h0;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:385
  logic select_2214;
  assign select_2214 = or_2212_s27_q ? and_2213_s27_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2215;
  assign select_2215 = equal_2166_s27_q ? select_2214 : sharpness_comparing_less_detail_0_q;
  logic select_2216;
  assign select_2216 = so_s27_q ? select_2215 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_2220;
  assign select_2220 = or_2218_s27_q ? and_2219_s27_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2221;
  assign select_2221 = equal_2166_s27_q ? select_2220 : sharpness_comparing_less_detail_1_q;
  logic select_2222;
  assign select_2222 = so_s27_q ? select_2221 : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:1085
  logic not_3614;
  assign not_3614 = ~hidden_for_q[7];
  logic [7:0] select_3616;
  assign select_3616 = select_3613_s27_q ? (hidden_for_q + {7'h0, not_3614}) : 8'h0;
  // hls/stages/patches.hpp:303
  logic [7:0] select_3618;
  assign select_3618 = equal_1466_s27_q ? (equal_3513_s27_q ? select_3616 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1158
  logic and_3644;
  assign and_3644 = too_much_q & not_3643_s27_q;
  // hls/stages/agreement.hpp:1159
  logic select_3649;
  assign select_3649 = and_3641_s27_q ? (and_3644 | or_3647_s27_q) : and_3644;
  // hls/stages/agreement.hpp:424
  logic select_3771;
  assign select_3771 = and_1893_s27_q ? (less_1894_s27_q ? and_3769_s27_q : seen_q) : seen_q;
  logic select_3774;
  assign select_3774 = and_1893_s27_q ? (less_1894_s27_q ? and_3772_s27_q : nearer_q) : nearer_q;
  // hls/stages/patches.hpp:303
  logic and_3784;
  assign and_3784 = equal_1466_s27_q & (equal_3513_s27_q & (cfg_prove_i & or_3584_s27_q));
  // hls/stages/agreement.hpp:1169
  logic not_3786;
  assign not_3786 = ~(or_3584_s27_q | not_3775);
  // hls/stages/patches.hpp:303
  logic and_3789;
  assign and_3789 = equal_3513_s27_q & (not_3786 & (select_3592_s27_q | select_3649));
  logic and_3803;
  assign and_3803 = equal_3513_s27_q & (not_3786 & (select_2222 | select_2234_s27_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s27_en) begin
      sharpness_comparing_less_detail_0_q <= select_2216;
      sharpness_comparing_less_detail_1_q <= select_2222;
      hidden_for_q <= select_3618;
      too_much_q <= equal_1466_s27_q ? select_3649 : too_much_q;
      seen_q <= select_3771;
      nearer_q <= select_3774;
    end
  end

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic equal_1466_s28_q;
  logic equal_3513_s28_q;
  logic and_3751_s28_q;
  logic and_3781_s28_q;
  logic and_3784_s28_q;
  logic and_3790_s28_q;
  logic and_3794_s28_q;
  logic and_3799_s28_q;
  logic and_3803_s28_q;
  logic not_3808_s28_q;
  logic and_3816_s28_q;
  logic [5:0] select_3818_s28_q;
  logic [31:0] select_3835_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      equal_1466_s28_q <= equal_1466_s27_q;
      equal_3513_s28_q <= equal_3513_s27_q;
      and_3751_s28_q <= and_3751_s27_q;
      and_3781_s28_q <= and_3781_s27_q;
      and_3784_s28_q <= and_3784;
      and_3790_s28_q <= equal_1466_s27_q & and_3789;
      and_3794_s28_q <= and_3794_s27_q;
      and_3799_s28_q <= equal_3513_s27_q & (not_3786 & (select_2216 | or_3796_s27_q));
      and_3803_s28_q <= and_3803;
      not_3808_s28_q <= ~(select_3616 < cfg_hidden_frames_i);
      and_3816_s28_q <= and_3816_s27_q;
      select_3818_s28_q <= select_3818_s27_q;
      select_3835_s28_q <= select_3835_s27_q;
    end
  end

  // Stage 28 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:1087
  logic and_3810;
  assign and_3810 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_3808_s28_q);

  logic [7:0] pixel_0_s29_q;
  logic [7:0] pixel_1_s29_q;
  logic saturated_s29_q;
  logic mask_s29_q;
  logic marks_first_s29_q;
  logic marks_last_s29_q;
  logic and_3751_s29_q;
  logic or_3776_s29_q;
  logic and_3777_s29_q;
  logic and_3781_s29_q;
  logic and_3784_s29_q;
  logic and_3790_s29_q;
  logic and_3794_s29_q;
  logic and_3800_s29_q;
  logic and_3804_s29_q;
  logic and_3812_s29_q;
  logic and_3816_s29_q;
  logic [5:0] select_3818_s29_q;
  logic [31:0] select_3835_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      and_3751_s29_q <= and_3751_s28_q;
      or_3776_s29_q <= not_3775 | seen_q;
      and_3777_s29_q <= cfg_prove_i & nearer_q;
      and_3781_s29_q <= and_3781_s28_q;
      and_3784_s29_q <= and_3784_s28_q;
      and_3790_s29_q <= and_3790_s28_q;
      and_3794_s29_q <= and_3794_s28_q;
      and_3800_s29_q <= equal_1466_s28_q & and_3799_s28_q;
      and_3804_s29_q <= equal_1466_s28_q & and_3803_s28_q;
      and_3812_s29_q <= equal_1466_s28_q & (equal_3513_s28_q & and_3810);
      and_3816_s29_q <= and_3816_s28_q;
      select_3818_s29_q <= select_3818_s28_q;
      select_3835_s29_q <= select_3835_s28_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s29_q;
  assign pixel_1_o = pixel_1_s29_q;
  assign saturated_o = saturated_s29_q;
  assign mask_o = mask_s29_q;
  assign marks_first_o = marks_first_s29_q;
  assign marks_last_o = marks_last_s29_q;
  assign marks_seen_o = or_3776_s29_q;
  assign marks_nearer_o = and_3777_s29_q;
  assign verdict_valid_o = and_3751_s29_q;
  assign verdict_unproven_yet_o = and_3781_s29_q;
  assign verdict_untextured_o = and_3784_s29_q;
  assign verdict_disagree_o = and_3790_s29_q;
  assign verdict_moved_o = and_3794_s29_q;
  assign verdict_unsharp_left_o = and_3800_s29_q;
  assign verdict_unsharp_right_o = and_3804_s29_q;
  assign verdict_hidden_o = and_3812_s29_q;
  assign frame_valid_o = and_3816_s29_q;
  assign frame_index_o = select_3818_s29_q;
  assign frame_word_o = select_3835_s29_q;
  assign valid_o = valid_s29_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], sum_3464[1:0], product_3362[4:0], sum_2481[0], sum_2477[0], sum_2458[0], detail_4[1:0], detail_3[1:0], sum_2116[4:0], sum_1653[1:0], sum_1652[1:0], sum_1648[0], sum_610[4:0], cfg_width_i[3:0]};

endmodule
