// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 29 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1918 bits, pipeline 6140 bits, memories 93264 bits.
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
  logic [6:0] sum_1953;
  assign sum_1953 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_2326;
  assign difference_2326 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_2530;
  assign less_2530 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_2531;
  assign sum_2531 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_2549;
  assign not_2549 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_326;
  assign select_326 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_326 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_326_s1_q;
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
      select_326_s1_q <= select_326;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [6:0] raster_at_column_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  logic averager_running_mask_q;
  // hls/stages/census.hpp:109
  logic equal_327;
  assign equal_327 = select_326_s1_q[1:0] == 2'h0;
  // hls/stages/census.hpp:35
  logic [6:0] select_329;
  assign select_329 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:41
  logic or_334;
  assign or_334 = sample_pair_first_s1_q | raster_at_live_q;
  logic [3:0] select_347;
  assign select_347 = sample_pair_first_s1_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:394
  logic whole;
  assign whole = equal_327 ? sample_present_s1_q : (sample_present_s1_q & averager_running_mask_q);
  // hls/stages/agreement.hpp:255
  logic [6:0] column;
  assign column = sample_pair_whole_s1_q ? select_329 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_364;
  assign equal_364 = select_326_s1_q == 4'hf;
  // hls/stages/agreement.hpp:255
  logic [3:0] select_1603;
  assign select_1603 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (select_347 + 4'h1) : select_347) : raster_at_y_q;
  logic [6:0] select_1605;
  assign select_1605 = sample_pair_whole_s1_q ? (select_329 + {6'h0, equal_364}) : raster_at_column_q;
  logic select_1612;
  assign select_1612 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_334 & (~raster_final_row_q)) : or_334) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_1614;
  assign select_1614 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:255
  logic select_1618;
  assign select_1618 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      raster_at_column_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
    end else if (s1_en) begin
      raster_at_y_q <= select_1603;
      raster_at_column_q <= select_1605;
      raster_at_live_q <= select_1612;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_1614 : raster_rows_left_q;
      raster_final_row_q <= select_1618;
      averager_running_mask_q <= sample_pair_whole_s1_q ? whole : averager_running_mask_q;
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
  logic equal_327_s2_q;
  logic equal_330_s2_q;
  logic not_339_s2_q;
  logic equal_348_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic equal_364_s2_q;
  logic equal_365_s2_q;
  logic equal_371_s2_q;
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
      equal_327_s2_q <= equal_327;
      equal_330_s2_q <= {select_329, select_326_s1_q} == 11'h0;
      not_339_s2_q <= ~((~or_334) | (~(select_326_s1_q[1:0] == 2'h3)));
      equal_348_s2_q <= select_347 == 4'h0;
      whole_s2_q <= whole;
      column_s2_q <= column;
      equal_364_s2_q <= equal_364;
      equal_365_s2_q <= select_347 == 4'hf;
      equal_371_s2_q <= select_326_s1_q == 4'h3;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:116
  logic [8:0] select_333;
  assign select_333 = equal_327_s2_q ? (equal_330_s2_q ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/census.hpp:41
  logic [6:0] select_427;
  assign select_427 = sample_pair_first_s2_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:255
  logic [6:0] row;
  assign row = sample_pair_whole_s2_q ? select_427 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_1607;
  assign select_1607 = sample_last_s2_q ? (select_427 + {6'h0, equal_365_s2_q}) : select_427;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_row_q <= sample_pair_whole_s2_q ? select_1607 : raster_at_row_q;
      averager_place_q <= sample_pair_whole_s2_q ? select_333 : averager_place_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic equal_327_s3_q;
  logic [8:0] select_333_s3_q;
  logic not_339_s3_q;
  logic equal_348_s3_q;
  logic whole_s3_q;
  logic [6:0] column_s3_q;
  logic equal_364_s3_q;
  logic equal_365_s3_q;
  logic equal_371_s3_q;
  logic [6:0] row_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      equal_327_s3_q <= equal_327_s2_q;
      select_333_s3_q <= select_333;
      not_339_s3_q <= not_339_s2_q;
      equal_348_s3_q <= equal_348_s2_q;
      whole_s3_q <= whole_s2_q;
      column_s3_q <= column_s2_q;
      equal_364_s3_q <= equal_364_s2_q;
      equal_365_s3_q <= equal_365_s2_q;
      equal_371_s3_q <= equal_371_s2_q;
      row_s3_q <= row;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:394
  logic and_342;
  assign and_342 = not_339_s3_q & (~(select_333_s3_q[8:5] == 4'hf));
  // hls/stages/census.hpp:126
  logic and_366;
  assign and_366 = equal_365_s3_q & and_342;
  // hls/stages/agreement.hpp:255
  logic and_368;
  assign and_368 = sample_pair_whole_s3_q & (equal_364_s3_q & and_366);
  // hls/stages/agreement.hpp:435
  logic equal_1859;
  assign equal_1859 = {last[7], column_s3_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:451
  logic [7:0] sum_1949;
  assign sum_1949 = {1'b0, row_s3_q} + 8'h1;

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic sample_pair_whole_s4_q;
  logic equal_327_s4_q;
  logic [8:0] select_333_s4_q;
  logic and_342_s4_q;
  logic equal_348_s4_q;
  logic whole_s4_q;
  logic [6:0] column_s4_q;
  logic and_366_s4_q;
  logic and_368_s4_q;
  logic equal_371_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1859_s4_q;
  logic and_1860_s4_q;
  logic equal_1950_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      equal_327_s4_q <= equal_327_s3_q;
      select_333_s4_q <= select_333_s3_q;
      and_342_s4_q <= and_342;
      equal_348_s4_q <= equal_348_s3_q;
      whole_s4_q <= whole_s3_q;
      column_s4_q <= column_s3_q;
      and_366_s4_q <= and_366;
      and_368_s4_q <= and_368;
      equal_371_s4_q <= equal_371_s3_q;
      row_s4_q <= row_s3_q;
      equal_1859_s4_q <= equal_1859;
      and_1860_s4_q <= and_368 & equal_1859;
      equal_1950_s4_q <= {sum_1949[7], cfg_height_i[10:4]} == {1'b0, sum_1949[6:0]};
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
  // hls/stages/agreement.hpp:181
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:598
  logic equal_388;
  assign equal_388 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:589
  logic equal_391;
  assign equal_391 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:590
  logic equal_393;
  assign equal_393 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:498
  logic select_1863;
  assign select_1863 = (and_1860_s4_q | (~ends_cell_q)) ? and_1860_s4_q : ends_q;
  // hls/stages/agreement.hpp:504
  logic [2:0] now;
  assign now = select_1863 ? (and_1860_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:509
  logic [5:0] select_1867;
  assign select_1867 = select_1863 ? (and_1860_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_1870;
  assign select_1870 = select_1863 ? (following_last_shift_q & (~and_1860_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:510
  logic [7:0] select_1872;
  assign select_1872 = select_1863 ? (and_1860_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:582
  logic and_1873;
  assign and_1873 = run_last_shift_q & equal_391;
  // hls/stages/agreement.hpp:591
  logic select_1875;
  assign select_1875 = equal_391 ? (~run_last_shift_q) : equal_393;
  // hls/stages/agreement.hpp:595
  logic equal_1876;
  assign equal_1876 = run_phase_q == 3'h1;
  logic not_1879;
  assign not_1879 = ~select_1875;
  // hls/stages/agreement.hpp:598
  logic equal_1881;
  assign equal_1881 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:582
  logic and_1882;
  assign and_1882 = final_row_q & so;
  // hls/stages/agreement.hpp:595
  logic [1:0] select_1883;
  assign select_1883 = equal_1881 ? 2'h1 : {2{and_1882}};
  logic [2:0] select_1885;
  assign select_1885 = (and_1873 | (select_1875 | equal_1876)) ? (equal_1876 ? 3'h2 : {not_1879, {2{select_1875}}}) : (equal_388 ? 3'h6 : {select_1883[0], select_1883});
  // hls/stages/agreement.hpp:582
  logic and_1888;
  assign and_1888 = select_1875 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:605
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1891;
  assign select_1891 = (plan_shift_q[5] & select_1875) ? value : 7'h0;
  logic [1:0] or_1892;
  assign or_1892 = {2{so}} | select_1891[5:4];
  // hls/stages/agreement.hpp:608
  logic [7:0] or_1896;
  assign or_1896 = (select_1875 ? plan_columns_q : 8'h0) | ((equal_1876 | equal_1881) ? whole_q : 8'h0);
  logic [1:0] or_1897;
  assign or_1897 = {2{and_1873}} | or_1896[4:3];
  // hls/stages/agreement.hpp:609
  logic [7:0] or_1899;
  assign or_1899 = {or_1896[7:5], or_1897, or_1896[2:0]} | (equal_388 ? drawn_q : 8'h0);
  logic [4:0] or_1900;
  assign or_1900 = {5{so}} | {or_1899[6], or_1899[3:0]};
  // hls/stages/agreement.hpp:615
  logic not_1904;
  assign not_1904 = ~run_shift_q[5];
  logic [7:0] select_1907;
  assign select_1907 = equal_391 ? ({{7{not_1904}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:498
  logic [6:0] select_1911;
  assign select_1911 = and_1860_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:501
  logic [7:0] select_1913;
  assign select_1913 = select_1863 ? {select_1911[6], select_1911} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_1916;
  assign select_1916 = select_1863 ? (and_1860_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:436
  logic [6:0] select_1923;
  assign select_1923 = equal_1859_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:495
  logic [7:0] select_1927;
  assign select_1927 = and_368_s4_q ? (equal_1859_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_1930;
  assign select_1930 = and_368_s4_q ? (equal_1859_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:506
  logic select_1944;
  assign select_1944 = (ends_cell_q | select_1863) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_391 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:501
  logic and_1948;
  assign and_1948 = (~select_1863) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:495
  logic select_1952;
  assign select_1952 = and_368_s4_q ? (equal_1859_s4_q ? equal_1950_s4_q : final_row_q) : final_row_q;

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
      run_shift_q <= select_1867;
      run_last_shift_q <= select_1870;
      run_span_q <= select_1872;
      following_phase_q <= select_1885;
      following_shift_q <= select_1875 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_1888;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1891[6], or_1892, select_1891[3:0]};
      following_columns_q <= {or_1899[7], or_1900[4], or_1899[5:4], or_1900[3:0]};
      plan_shift_q <= equal_391 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_1907;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_1913;
      columns_left_q <= select_1916;
      last_q <= and_368_s4_q ? (equal_1859_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_368_s4_q ? select_1923 : least_q;
      whole_q <= select_1927;
      drawn_q <= select_1930;
      slot_q <= select_1863 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_1944;
      ends_q <= and_1948;
      final_row_q <= select_1952;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic sample_pair_whole_s5_q;
  logic [5:0] run_shift_s5_q;
  logic [7:0] x_s5_q;
  logic [6:0] last_s5_q;
  logic [2:0] slot_s5_q;
  logic ends_cell_s5_q;
  logic equal_327_s5_q;
  logic [8:0] select_333_s5_q;
  logic and_342_s5_q;
  logic equal_348_s5_q;
  logic whole_s5_q;
  logic [6:0] column_s5_q;
  logic and_366_s5_q;
  logic and_368_s5_q;
  logic equal_371_s5_q;
  logic so_s5_q;
  logic equal_388_s5_q;
  logic equal_391_s5_q;
  logic equal_393_s5_q;
  logic [7:0] sum_394_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_504_s5_q;
  logic equal_513_s5_q;
  logic equal_1337_s5_q;
  logic equal_1859_s5_q;
  logic and_1860_s5_q;
  logic select_1863_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      sample_pair_whole_s5_q <= sample_pair_whole_s4_q;
      run_shift_s5_q <= run_shift_q;
      x_s5_q <= x_q;
      last_s5_q <= last_q;
      slot_s5_q <= slot_q;
      ends_cell_s5_q <= ends_cell_q;
      equal_327_s5_q <= equal_327_s4_q;
      select_333_s5_q <= select_333_s4_q;
      and_342_s5_q <= and_342_s4_q;
      equal_348_s5_q <= equal_348_s4_q;
      whole_s5_q <= whole_s4_q;
      column_s5_q <= column_s4_q;
      and_366_s5_q <= and_366_s4_q;
      and_368_s5_q <= and_368_s4_q;
      equal_371_s5_q <= equal_371_s4_q;
      so_s5_q <= so;
      equal_388_s5_q <= equal_388;
      equal_391_s5_q <= equal_391;
      equal_393_s5_q <= equal_393;
      sum_394_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_504_s5_q <= {1'b0, last_q} + 8'h3;
      equal_513_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_1337_s5_q <= run_phase_q == 3'h7;
      equal_1859_s5_q <= equal_1859_s4_q;
      and_1860_s5_q <= and_1860_s4_q;
      select_1863_s5_q <= select_1863;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:569
  logic [7:0] select_395;
  assign select_395 = run_shift_s5_q[5] ? x_s5_q : sum_394_s5_q;
  logic less_396;
  assign less_396 = {1'b0, last_s5_q} < select_395;
  // hls/stages/agreement.hpp:209
  logic not_397;
  assign not_397 = ~less_396;
  // hls/stages/agreement.hpp:788
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:503
  logic [6:0] select_1932;
  assign select_1932 = select_1863_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_1932;
    end
  end

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic sample_pair_whole_s6_q;
  logic [5:0] run_shift_s6_q;
  logic [7:0] x_s6_q;
  logic [6:0] last_s6_q;
  logic [3:0] age_s6_q;
  logic [2:0] slot_s6_q;
  logic ends_cell_s6_q;
  logic equal_327_s6_q;
  logic [8:0] select_333_s6_q;
  logic and_342_s6_q;
  logic equal_348_s6_q;
  logic whole_s6_q;
  logic [6:0] column_s6_q;
  logic and_366_s6_q;
  logic and_368_s6_q;
  logic equal_371_s6_q;
  logic so_s6_q;
  logic equal_388_s6_q;
  logic equal_391_s6_q;
  logic [6:0] sum_394_s6_q;
  logic less_396_s6_q;
  logic not_397_s6_q;
  logic and_398_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_508_s6_q;
  logic equal_513_s6_q;
  logic equal_1327_s6_q;
  logic equal_1337_s6_q;
  logic equal_1859_s6_q;
  logic and_1860_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      pixel_1_s6_q <= pixel_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      sample_pair_whole_s6_q <= sample_pair_whole_s5_q;
      run_shift_s6_q <= run_shift_s5_q;
      x_s6_q <= x_s5_q;
      last_s6_q <= last_s5_q;
      age_s6_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s6_q <= slot_s5_q;
      ends_cell_s6_q <= ends_cell_s5_q;
      equal_327_s6_q <= equal_327_s5_q;
      select_333_s6_q <= select_333_s5_q;
      and_342_s6_q <= and_342_s5_q;
      equal_348_s6_q <= equal_348_s5_q;
      whole_s6_q <= whole_s5_q;
      column_s6_q <= column_s5_q;
      and_366_s6_q <= and_366_s5_q;
      and_368_s6_q <= and_368_s5_q;
      equal_371_s6_q <= equal_371_s5_q;
      so_s6_q <= so_s5_q;
      equal_388_s6_q <= equal_388_s5_q;
      equal_391_s6_q <= equal_391_s5_q;
      sum_394_s6_q <= sum_394_s5_q[6:0];
      less_396_s6_q <= less_396;
      not_397_s6_q <= not_397;
      and_398_s6_q <= equal_393_s5_q & not_397;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_508_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_504_s5_q < select_395)));
      equal_513_s6_q <= equal_513_s5_q;
      equal_1327_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1337_s6_q <= equal_1337_s5_q;
      equal_1859_s6_q <= equal_1859_s5_q;
      and_1860_s6_q <= and_1860_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:569
  logic or_389;
  assign or_389 = so_s6_q | equal_388_s6_q;
  // hls/stages/agreement.hpp:719
  logic not_390;
  assign not_390 = ~or_389;
  // hls/stages/agreement.hpp:137
  logic select_484;
  assign select_484 = equal_391_s6_q ? not_397_s6_q : and_398_s6_q;
  logic and_509;
  assign and_509 = equal_391_s6_q & and_508_s6_q;
  logic select_510;
  assign select_510 = or_389 ? not_397_s6_q : and_509;
  // hls/stages/agreement.hpp:797
  logic or_515;
  assign or_515 = equal_513_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:809
  logic [6:0] right;
  assign right = sum_394_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1299; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_389 ? not_397_s6_q : select_484);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1300; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_391_s6_q ? sum_394_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_390 & select_484);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1301; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 46'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_389 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_510;
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
  logic sample_pair_whole_s7_q;
  logic [5:0] run_shift_s7_q;
  logic [7:0] x_s7_q;
  logic [6:0] last_s7_q;
  logic [3:0] age_s7_q;
  logic [2:0] slot_s7_q;
  logic ends_cell_s7_q;
  logic equal_327_s7_q;
  logic [8:0] select_333_s7_q;
  logic and_342_s7_q;
  logic equal_348_s7_q;
  logic whole_s7_q;
  logic [6:0] column_s7_q;
  logic and_366_s7_q;
  logic and_368_s7_q;
  logic equal_371_s7_q;
  logic so_s7_q;
  logic equal_388_s7_q;
  logic or_389_s7_q;
  logic equal_391_s7_q;
  logic less_396_s7_q;
  logic not_397_s7_q;
  logic and_400_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_510_s7_q;
  logic select_517_s7_q;
  logic and_1319_s7_q;
  logic [6:0] right_s7_q;
  logic select_1328_s7_q;
  logic equal_1337_s7_q;
  logic equal_1859_s7_q;
  logic and_1860_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      pixel_0_s7_q <= pixel_0_s6_q;
      pixel_1_s7_q <= pixel_1_s6_q;
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      sample_pair_whole_s7_q <= sample_pair_whole_s6_q;
      run_shift_s7_q <= run_shift_s6_q;
      x_s7_q <= x_s6_q;
      last_s7_q <= last_s6_q;
      age_s7_q <= age_s6_q;
      slot_s7_q <= slot_s6_q;
      ends_cell_s7_q <= ends_cell_s6_q;
      equal_327_s7_q <= equal_327_s6_q;
      select_333_s7_q <= select_333_s6_q;
      and_342_s7_q <= and_342_s6_q;
      equal_348_s7_q <= equal_348_s6_q;
      whole_s7_q <= whole_s6_q;
      column_s7_q <= column_s6_q;
      and_366_s7_q <= and_366_s6_q;
      and_368_s7_q <= and_368_s6_q;
      equal_371_s7_q <= equal_371_s6_q;
      so_s7_q <= so_s6_q;
      equal_388_s7_q <= equal_388_s6_q;
      or_389_s7_q <= or_389;
      equal_391_s7_q <= equal_391_s6_q;
      less_396_s7_q <= less_396_s6_q;
      not_397_s7_q <= not_397_s6_q;
      and_400_s7_q <= not_390 & ((~equal_391_s6_q) & and_398_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_510_s7_q <= select_510;
      select_517_s7_q <= or_515 ? equal_513_s6_q : (~age_s6_q[1]);
      and_1319_s7_q <= not_390 & and_509;
      right_s7_q <= right;
      select_1328_s7_q <= or_515 ? equal_513_s6_q : equal_1327_s6_q;
      equal_1337_s7_q <= equal_1337_s6_q;
      equal_1859_s7_q <= equal_1859_s6_q;
      and_1860_s7_q <= and_1860_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1298; read in stage 7, written in stage 26: 7 < 26 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_400_s7_q;
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
  logic sample_pair_whole_s8_q;
  logic [5:0] run_shift_s8_q;
  logic [7:0] x_s8_q;
  logic [6:0] last_s8_q;
  logic [3:0] age_s8_q;
  logic [2:0] slot_s8_q;
  logic ends_cell_s8_q;
  logic equal_327_s8_q;
  logic [8:0] select_333_s8_q;
  logic and_342_s8_q;
  logic equal_348_s8_q;
  logic whole_s8_q;
  logic [6:0] column_s8_q;
  logic and_366_s8_q;
  logic and_368_s8_q;
  logic equal_371_s8_q;
  logic so_s8_q;
  logic equal_388_s8_q;
  logic or_389_s8_q;
  logic equal_391_s8_q;
  logic less_396_s8_q;
  logic not_397_s8_q;
  logic and_400_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_510_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic select_517_s8_q;
  logic and_1319_s8_q;
  logic [6:0] right_s8_q;
  logic select_1328_s8_q;
  logic equal_1337_s8_q;
  logic equal_1859_s8_q;
  logic and_1860_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      pixel_0_s8_q <= pixel_0_s7_q;
      pixel_1_s8_q <= pixel_1_s7_q;
      saturated_s8_q <= saturated_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      sample_pair_whole_s8_q <= sample_pair_whole_s7_q;
      run_shift_s8_q <= run_shift_s7_q;
      x_s8_q <= x_s7_q;
      last_s8_q <= last_s7_q;
      age_s8_q <= age_s7_q;
      slot_s8_q <= slot_s7_q;
      ends_cell_s8_q <= ends_cell_s7_q;
      equal_327_s8_q <= equal_327_s7_q;
      select_333_s8_q <= select_333_s7_q;
      and_342_s8_q <= and_342_s7_q;
      equal_348_s8_q <= equal_348_s7_q;
      whole_s8_q <= whole_s7_q;
      column_s8_q <= column_s7_q;
      and_366_s8_q <= and_366_s7_q;
      and_368_s8_q <= and_368_s7_q;
      equal_371_s8_q <= equal_371_s7_q;
      so_s8_q <= so_s7_q;
      equal_388_s8_q <= equal_388_s7_q;
      or_389_s8_q <= or_389_s7_q;
      equal_391_s8_q <= equal_391_s7_q;
      less_396_s8_q <= less_396_s7_q;
      not_397_s8_q <= not_397_s7_q;
      and_400_s8_q <= and_400_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_510_s8_q <= select_510_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      select_517_s8_q <= select_517_s7_q;
      and_1319_s8_q <= and_1319_s7_q;
      right_s8_q <= right_s7_q;
      select_1328_s8_q <= select_1328_s7_q;
      equal_1337_s8_q <= equal_1337_s7_q;
      equal_1859_s8_q <= equal_1859_s7_q;
      and_1860_s8_q <= and_1860_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:641
  logic not_488;
  assign not_488 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:205
  logic and_523;
  assign and_523 = left_rdata_s8_q[44] & not_397_s8_q;
  logic and_524;
  assign and_524 = right_codes_rdata_s8_q[38] & not_397_s8_q;
  logic [11:0] select_525;
  assign select_525 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_526;
  assign select_526 = less_396_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_530;
  assign select_530 = and_523 ? (and_524 ? (~(select_525 ^ select_526)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:205
  logic and_546;
  assign and_546 = left_rdata_s8_q[60] & not_397_s8_q;
  logic and_547;
  assign and_547 = right_codes_rdata_s8_q[51] & not_397_s8_q;
  logic [11:0] select_548;
  assign select_548 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_549;
  assign select_549 = less_396_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_553;
  assign select_553 = and_546 ? (and_547 ? (~(select_548 ^ select_549)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:205
  logic and_563;
  assign and_563 = left_rdata_s8_q[76] & not_397_s8_q;
  logic and_564;
  assign and_564 = right_codes_rdata_s8_q[64] & not_397_s8_q;
  logic [11:0] select_565;
  assign select_565 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_566;
  assign select_566 = less_396_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_570;
  assign select_570 = and_563 ? (and_564 ? (~(select_565 ^ select_566)) : 12'h0) : 12'h0;
  logic [11:0] select_778;
  assign select_778 = (slot_s8_q[0] ? and_564 : and_547) ? (~(select_526 ^ (slot_s8_q[0] ? select_565 : select_548))) : 12'h0;
  // hls/stages/agreement.hpp:205
  logic and_795;
  assign and_795 = right_codes_rdata_s8_q[77] & not_397_s8_q;
  logic [11:0] select_797;
  assign select_797 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_801;
  assign select_801 = (slot_s8_q[0] ? and_795 : and_564) ? (~(select_549 ^ (slot_s8_q[0] ? select_797 : select_565))) : 12'h0;
  // hls/stages/agreement.hpp:733
  logic select_813;
  assign select_813 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_397_s8_q) : and_795;
  logic [11:0] select_815;
  assign select_815 = slot_s8_q[0] ? (less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_797;
  // hls/stages/agreement.hpp:205
  logic and_1024;
  assign and_1024 = right_codes_rdata_s8_q[25] & not_397_s8_q;
  // hls/stages/agreement.hpp:733
  logic select_1025;
  assign select_1025 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_397_s8_q) : and_1024;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1027;
  assign select_1027 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:733
  logic [11:0] select_1028;
  assign select_1028 = slot_s8_q[0] ? (less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1027;
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1052;
  assign select_1052 = (slot_s8_q[0] ? and_1024 : and_524) ? (~(select_549 ^ (slot_s8_q[0] ? select_1027 : select_525))) : 12'h0;
  logic [11:0] select_1067;
  assign select_1067 = (slot_s8_q[0] ? and_524 : and_547) ? (~(select_566 ^ (slot_s8_q[0] ? select_525 : select_548))) : 12'h0;
  // hls/stages/agreement.hpp:942
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:947
  logic and_1343;
  assign and_1343 = (or_389_s8_q & (left_rdata_s8_q[61] & not_397_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:228
  logic and_1351;
  assign and_1351 = not_397_s8_q & (or_389_s8_q & (left_rdata_s8_q[63] & not_397_s8_q));
  // hls/stages/agreement.hpp:436
  logic select_1956;
  assign select_1956 = equal_1859_s8_q ? (~({row_s8_q, 1'b0} < {sum_1953, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:495
  logic and_2194;
  assign and_2194 = and_368_s8_q & (equal_1859_s8_q & (row_s8_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s8_en) begin
      row_q <= and_368_s8_q ? (equal_1859_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_368_s8_q ? select_1956 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s9_q;
  logic [7:0] pixel_1_s9_q;
  logic saturated_s9_q;
  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic sample_pair_whole_s9_q;
  logic [5:0] run_shift_s9_q;
  logic [7:0] x_s9_q;
  logic [6:0] last_s9_q;
  logic [3:0] age_s9_q;
  logic [2:0] slot_s9_q;
  logic ends_cell_s9_q;
  logic lower_half_s9_q;
  logic equal_327_s9_q;
  logic [8:0] select_333_s9_q;
  logic and_342_s9_q;
  logic equal_348_s9_q;
  logic whole_s9_q;
  logic [6:0] column_s9_q;
  logic and_366_s9_q;
  logic and_368_s9_q;
  logic equal_371_s9_q;
  logic so_s9_q;
  logic equal_388_s9_q;
  logic or_389_s9_q;
  logic equal_391_s9_q;
  logic less_396_s9_q;
  logic not_397_s9_q;
  logic and_400_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic equal_429_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_489_s9_q;
  logic and_490_s9_q;
  logic and_491_s9_q;
  logic and_492_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_496_s9_q;
  logic and_497_s9_q;
  logic and_498_s9_q;
  logic and_499_s9_q;
  logic and_500_s9_q;
  logic and_501_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_510_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic select_517_s9_q;
  logic and_523_s9_q;
  logic [11:0] select_530_s9_q;
  logic and_546_s9_q;
  logic [11:0] select_553_s9_q;
  logic and_563_s9_q;
  logic [11:0] select_570_s9_q;
  logic [11:0] select_778_s9_q;
  logic [11:0] select_801_s9_q;
  logic [11:0] select_818_s9_q;
  logic [11:0] select_1031_s9_q;
  logic [11:0] select_1052_s9_q;
  logic [11:0] select_1067_s9_q;
  logic and_1319_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic select_1328_s9_q;
  logic equal_1337_s9_q;
  logic and_1344_s9_q;
  logic and_1347_s9_q;
  logic and_1351_s9_q;
  logic and_1592_s9_q;
  logic equal_1738_s9_q;
  logic equal_1859_s9_q;
  logic less_2112_s9_q;
  logic and_2195_s9_q;
  logic and_2197_s9_q;
  logic less_2304_s9_q;
  logic equal_2511_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      pixel_0_s9_q <= pixel_0_s8_q;
      pixel_1_s9_q <= pixel_1_s8_q;
      saturated_s9_q <= saturated_s8_q;
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      sample_pair_whole_s9_q <= sample_pair_whole_s8_q;
      run_shift_s9_q <= run_shift_s8_q;
      x_s9_q <= x_s8_q;
      last_s9_q <= last_s8_q;
      age_s9_q <= age_s8_q;
      slot_s9_q <= slot_s8_q;
      ends_cell_s9_q <= ends_cell_s8_q;
      lower_half_s9_q <= lower_half_q;
      equal_327_s9_q <= equal_327_s8_q;
      select_333_s9_q <= select_333_s8_q;
      and_342_s9_q <= and_342_s8_q;
      equal_348_s9_q <= equal_348_s8_q;
      whole_s9_q <= whole_s8_q;
      column_s9_q <= column_s8_q;
      and_366_s9_q <= and_366_s8_q;
      and_368_s9_q <= and_368_s8_q;
      equal_371_s9_q <= equal_371_s8_q;
      so_s9_q <= so_s8_q;
      equal_388_s9_q <= equal_388_s8_q;
      or_389_s9_q <= or_389_s8_q;
      equal_391_s9_q <= equal_391_s8_q;
      less_396_s9_q <= less_396_s8_q;
      not_397_s9_q <= not_397_s8_q;
      and_400_s9_q <= and_400_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_429_s9_q <= row_s8_q == 7'h0;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_489_s9_q <= left_rdata_s8_q[12] & not_488;
      and_490_s9_q <= left_rdata_s8_q[28] & not_488;
      and_491_s9_q <= left_rdata_s8_q[44] & not_488;
      and_492_s9_q <= left_rdata_s8_q[60] & not_488;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_496_s9_q <= right_codes_rdata_s8_q[12] & not_488;
      and_497_s9_q <= right_codes_rdata_s8_q[25] & not_488;
      and_498_s9_q <= right_codes_rdata_s8_q[38] & not_488;
      and_499_s9_q <= right_codes_rdata_s8_q[51] & not_488;
      and_500_s9_q <= right_codes_rdata_s8_q[64] & not_488;
      and_501_s9_q <= right_codes_rdata_s8_q[77] & not_488;
      x_s9_2_q <= x_s8_2_q;
      select_510_s9_q <= select_510_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_517_s9_q <= select_517_s8_q;
      and_523_s9_q <= and_523;
      select_530_s9_q <= select_530;
      and_546_s9_q <= and_546;
      select_553_s9_q <= select_553;
      and_563_s9_q <= and_563;
      select_570_s9_q <= select_570;
      select_778_s9_q <= select_778;
      select_801_s9_q <= select_801;
      select_818_s9_q <= select_813 ? (~(select_566 ^ select_815)) : 12'h0;
      select_1031_s9_q <= select_1025 ? (~(select_526 ^ select_1028)) : 12'h0;
      select_1052_s9_q <= select_1052;
      select_1067_s9_q <= select_1067;
      and_1319_s9_q <= and_1319_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      select_1328_s9_q <= select_1328_s8_q;
      equal_1337_s9_q <= equal_1337_s8_q;
      and_1344_s9_q <= not_397_s8_q & and_1343;
      and_1347_s9_q <= (or_389_s8_q & (left_rdata_s8_q[62] & not_397_s8_q)) & and_1343;
      and_1351_s9_q <= and_1351;
      and_1592_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_1738_s9_q <= (column_s8_q | row_s8_q) == 7'h0;
      equal_1859_s9_q <= equal_1859_s8_q;
      less_2112_s9_q <= 6'h4 < row_q[6:1];
      and_2195_s9_q <= and_1860_s8_q & and_2194;
      and_2197_s9_q <= and_1860_s8_q & (~and_2194);
      less_2304_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_2511_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:672
  logic parity_536;
  assign parity_536 = ^select_530_s9_q[5:3];
  logic parity_539;
  assign parity_539 = ^select_530_s9_q[8:6];
  logic parity_542;
  assign parity_542 = ^select_530_s9_q[11:3];
  logic parity_556;
  assign parity_556 = ^select_553_s9_q[8:6];
  logic parity_559;
  assign parity_559 = ^select_553_s9_q[11:9];
  logic parity_576;
  assign parity_576 = ^select_570_s9_q[2:0];
  logic parity_579;
  assign parity_579 = ^select_570_s9_q[5:3];
  logic parity_582;
  assign parity_582 = ^select_570_s9_q[8:0];
  logic parity_588;
  assign parity_588 = ^select_570_s9_q[11:9];
  logic parity_591;
  assign parity_591 = ^select_553_s9_q[2:0];
  logic parity_594;
  assign parity_594 = ^{select_570_s9_q[11:9], select_553_s9_q[5:0]};
  logic parity_597;
  assign parity_597 = ^{select_570_s9_q, select_553_s9_q, select_530_s9_q[2:0]};
  // hls/stages/agreement.hpp:671
  logic or_602;
  assign or_602 = (select_530_s9_q[1:0] == 2'h3) | (select_530_s9_q[2] & (select_530_s9_q[0] | select_530_s9_q[1]));
  // hls/stages/agreement.hpp:673
  logic or_606;
  assign or_606 = (select_553_s9_q[7:6] == 2'h3) | (select_553_s9_q[8] & (select_553_s9_q[6] | select_553_s9_q[7]));
  logic or_610;
  assign or_610 = (select_553_s9_q[10:9] == 2'h3) | (select_553_s9_q[11] & (select_553_s9_q[9] | select_553_s9_q[10]));
  // hls/stages/agreement.hpp:671
  logic or_618;
  assign or_618 = (select_570_s9_q[7:6] == 2'h3) | (select_570_s9_q[8] & (~(select_570_s9_q[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_622;
  assign or_622 = (select_570_s9_q[1:0] == 2'h3) | (select_570_s9_q[2] & (select_570_s9_q[0] | select_570_s9_q[1]));
  logic or_626;
  assign or_626 = (select_570_s9_q[4:3] == 2'h3) | (select_570_s9_q[5] & (select_570_s9_q[3] | select_570_s9_q[4]));
  // hls/stages/agreement.hpp:672
  logic parity_629;
  assign parity_629 = ^{or_626, or_622, or_618};
  // hls/stages/agreement.hpp:671
  logic or_633;
  assign or_633 = (select_553_s9_q[4:3] == 2'h3) | (select_553_s9_q[5] & (select_553_s9_q[3] | select_553_s9_q[4]));
  // hls/stages/agreement.hpp:673
  logic or_637;
  assign or_637 = (select_570_s9_q[10:9] == 2'h3) | (select_570_s9_q[11] & (select_570_s9_q[9] | select_570_s9_q[10]));
  logic or_641;
  assign or_641 = (select_553_s9_q[1:0] == 2'h3) | (select_553_s9_q[2] & (select_553_s9_q[0] | select_553_s9_q[1]));
  // hls/stages/agreement.hpp:672
  logic parity_644;
  assign parity_644 = ^{or_641, or_637, or_633};
  logic parity_647;
  assign parity_647 = ^{or_641, or_637, or_633, or_626, or_622, or_618, or_610, or_606, or_602};
  // hls/stages/agreement.hpp:673
  logic or_652;
  assign or_652 = (parity_536 & parity_539) | ((^select_530_s9_q[11:9]) & (parity_536 | parity_539));
  logic and_655;
  assign and_655 = (^{select_553_s9_q[11:6], select_530_s9_q[2:0]}) & (parity_582 | parity_594);
  // hls/stages/agreement.hpp:671
  logic or_663;
  assign or_663 = (select_530_s9_q[10:9] == 2'h3) | (select_530_s9_q[11] & (select_530_s9_q[9] | select_530_s9_q[10]));
  // hls/stages/agreement.hpp:673
  logic or_667;
  assign or_667 = (select_530_s9_q[4:3] == 2'h3) | (select_530_s9_q[5] & (select_530_s9_q[3] | select_530_s9_q[4]));
  logic or_671;
  assign or_671 = (select_530_s9_q[7:6] == 2'h3) | (select_530_s9_q[8] & (select_530_s9_q[6] | select_530_s9_q[7]));
  logic or_678;
  assign or_678 = (parity_556 & parity_559) | ((^select_530_s9_q[2:0]) & (parity_556 | parity_559));
  logic or_682;
  assign or_682 = (parity_576 & parity_579) | ((^select_570_s9_q[8:6]) & (parity_576 | parity_579));
  logic or_686;
  assign or_686 = (parity_588 & parity_591) | ((^select_553_s9_q[5:3]) & (parity_588 | parity_591));
  // hls/stages/agreement.hpp:657
  logic [11:0] select_779;
  assign select_779 = and_523_s9_q ? select_778_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_785;
  assign parity_785 = ^select_779[5:3];
  logic parity_788;
  assign parity_788 = ^select_779[8:6];
  logic parity_791;
  assign parity_791 = ^select_779[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_802;
  assign select_802 = and_546_s9_q ? select_801_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_805;
  assign parity_805 = ^select_802[8:6];
  logic parity_808;
  assign parity_808 = ^select_802[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_819;
  assign select_819 = and_563_s9_q ? select_818_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_825;
  assign parity_825 = ^select_819[2:0];
  logic parity_828;
  assign parity_828 = ^select_819[5:3];
  logic parity_831;
  assign parity_831 = ^select_819[8:0];
  logic parity_837;
  assign parity_837 = ^select_819[11:9];
  logic parity_840;
  assign parity_840 = ^select_802[2:0];
  logic parity_843;
  assign parity_843 = ^{select_819[11:9], select_802[5:0]};
  logic parity_846;
  assign parity_846 = ^{select_819, select_802, select_779[2:0]};
  // hls/stages/agreement.hpp:671
  logic or_851;
  assign or_851 = (select_779[1:0] == 2'h3) | (select_779[2] & (select_779[0] | select_779[1]));
  // hls/stages/agreement.hpp:673
  logic or_855;
  assign or_855 = (select_802[7:6] == 2'h3) | (select_802[8] & (select_802[6] | select_802[7]));
  logic or_859;
  assign or_859 = (select_802[10:9] == 2'h3) | (select_802[11] & (select_802[9] | select_802[10]));
  // hls/stages/agreement.hpp:671
  logic or_867;
  assign or_867 = (select_819[7:6] == 2'h3) | (select_819[8] & (~(select_819[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_871;
  assign or_871 = (select_819[1:0] == 2'h3) | (select_819[2] & (select_819[0] | select_819[1]));
  logic or_875;
  assign or_875 = (select_819[4:3] == 2'h3) | (select_819[5] & (select_819[3] | select_819[4]));
  // hls/stages/agreement.hpp:672
  logic parity_878;
  assign parity_878 = ^{or_875, or_871, or_867};
  // hls/stages/agreement.hpp:671
  logic or_882;
  assign or_882 = (select_802[4:3] == 2'h3) | (select_802[5] & (select_802[3] | select_802[4]));
  // hls/stages/agreement.hpp:673
  logic or_886;
  assign or_886 = (select_819[10:9] == 2'h3) | (select_819[11] & (select_819[9] | select_819[10]));
  logic or_890;
  assign or_890 = (select_802[1:0] == 2'h3) | (select_802[2] & (select_802[0] | select_802[1]));
  // hls/stages/agreement.hpp:672
  logic parity_893;
  assign parity_893 = ^{or_890, or_886, or_882};
  logic parity_896;
  assign parity_896 = ^{or_890, or_886, or_882, or_875, or_871, or_867, or_859, or_855, or_851};
  // hls/stages/agreement.hpp:673
  logic or_901;
  assign or_901 = (parity_785 & parity_788) | ((^select_779[11:9]) & (parity_785 | parity_788));
  logic and_904;
  assign and_904 = (^{select_802[11:6], select_779[2:0]}) & (parity_831 | parity_843);
  // hls/stages/agreement.hpp:671
  logic or_912;
  assign or_912 = (select_779[10:9] == 2'h3) | (select_779[11] & (select_779[9] | select_779[10]));
  // hls/stages/agreement.hpp:673
  logic or_916;
  assign or_916 = (select_779[4:3] == 2'h3) | (select_779[5] & (select_779[3] | select_779[4]));
  logic or_920;
  assign or_920 = (select_779[7:6] == 2'h3) | (select_779[8] & (select_779[6] | select_779[7]));
  logic or_927;
  assign or_927 = (parity_805 & parity_808) | ((^select_779[2:0]) & (parity_805 | parity_808));
  logic or_931;
  assign or_931 = (parity_825 & parity_828) | ((^select_819[8:6]) & (parity_825 | parity_828));
  logic or_935;
  assign or_935 = (parity_837 & parity_840) | ((^select_802[5:3]) & (parity_837 | parity_840));
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1032;
  assign select_1032 = and_523_s9_q ? select_1031_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1038;
  assign parity_1038 = ^select_1032[5:3];
  logic parity_1041;
  assign parity_1041 = ^select_1032[8:6];
  logic parity_1044;
  assign parity_1044 = ^select_1032[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1053;
  assign select_1053 = and_546_s9_q ? select_1052_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1056;
  assign parity_1056 = ^select_1053[8:6];
  logic parity_1059;
  assign parity_1059 = ^select_1053[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1068;
  assign select_1068 = and_563_s9_q ? select_1067_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1074;
  assign parity_1074 = ^select_1068[2:0];
  logic parity_1077;
  assign parity_1077 = ^select_1068[5:3];
  logic parity_1080;
  assign parity_1080 = ^select_1068[8:0];
  logic parity_1086;
  assign parity_1086 = ^select_1068[11:9];
  logic parity_1089;
  assign parity_1089 = ^select_1053[2:0];
  logic parity_1092;
  assign parity_1092 = ^{select_1068[11:9], select_1053[5:0]};
  logic parity_1095;
  assign parity_1095 = ^{select_1068, select_1053, select_1032[2:0]};
  // hls/stages/agreement.hpp:671
  logic or_1100;
  assign or_1100 = (select_1032[1:0] == 2'h3) | (select_1032[2] & (select_1032[0] | select_1032[1]));
  // hls/stages/agreement.hpp:673
  logic or_1104;
  assign or_1104 = (select_1053[7:6] == 2'h3) | (select_1053[8] & (select_1053[6] | select_1053[7]));
  logic or_1108;
  assign or_1108 = (select_1053[10:9] == 2'h3) | (select_1053[11] & (select_1053[9] | select_1053[10]));
  // hls/stages/agreement.hpp:671
  logic or_1116;
  assign or_1116 = (select_1068[7:6] == 2'h3) | (select_1068[8] & (~(select_1068[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1120;
  assign or_1120 = (select_1068[1:0] == 2'h3) | (select_1068[2] & (select_1068[0] | select_1068[1]));
  logic or_1124;
  assign or_1124 = (select_1068[4:3] == 2'h3) | (select_1068[5] & (select_1068[3] | select_1068[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1127;
  assign parity_1127 = ^{or_1124, or_1120, or_1116};
  // hls/stages/agreement.hpp:671
  logic or_1131;
  assign or_1131 = (select_1053[4:3] == 2'h3) | (select_1053[5] & (select_1053[3] | select_1053[4]));
  // hls/stages/agreement.hpp:673
  logic or_1135;
  assign or_1135 = (select_1068[10:9] == 2'h3) | (select_1068[11] & (select_1068[9] | select_1068[10]));
  logic or_1139;
  assign or_1139 = (select_1053[1:0] == 2'h3) | (select_1053[2] & (select_1053[0] | select_1053[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1142;
  assign parity_1142 = ^{or_1139, or_1135, or_1131};
  logic parity_1145;
  assign parity_1145 = ^{or_1139, or_1135, or_1131, or_1124, or_1120, or_1116, or_1108, or_1104, or_1100};
  // hls/stages/agreement.hpp:673
  logic or_1150;
  assign or_1150 = (parity_1038 & parity_1041) | ((^select_1032[11:9]) & (parity_1038 | parity_1041));
  logic and_1153;
  assign and_1153 = (^{select_1053[11:6], select_1032[2:0]}) & (parity_1080 | parity_1092);
  // hls/stages/agreement.hpp:671
  logic or_1161;
  assign or_1161 = (select_1032[10:9] == 2'h3) | (select_1032[11] & (select_1032[9] | select_1032[10]));
  // hls/stages/agreement.hpp:673
  logic or_1165;
  assign or_1165 = (select_1032[4:3] == 2'h3) | (select_1032[5] & (select_1032[3] | select_1032[4]));
  logic or_1169;
  assign or_1169 = (select_1032[7:6] == 2'h3) | (select_1032[8] & (select_1032[6] | select_1032[7]));
  logic or_1176;
  assign or_1176 = (parity_1056 & parity_1059) | ((^select_1032[2:0]) & (parity_1056 | parity_1059));
  logic or_1180;
  assign or_1180 = (parity_1074 & parity_1077) | ((^select_1068[8:6]) & (parity_1074 | parity_1077));
  logic or_1184;
  assign or_1184 = (parity_1086 & parity_1089) | ((^select_1053[5:3]) & (parity_1086 | parity_1089));
  // hls/stages/agreement.hpp:943
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:228
  logic or_1365;
  assign or_1365 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));
  // hls/stages/agreement.hpp:970
  logic [5:0] sum_1419;
  assign sum_1419 = {1'b0, last_s9_q[6:2]} + 6'h1;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_400_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_492_s9_q, left_rdata_s9_q[56:42], and_491_s9_q, left_rdata_s9_q[41:27], and_490_s9_q, left_rdata_s9_q[26:12], and_489_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_400_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_501_s9_q, right_codes_rdata_s9_q[71:60], and_500_s9_q, right_codes_rdata_s9_q[59:48], and_499_s9_q, right_codes_rdata_s9_q[47:36], and_498_s9_q, right_codes_rdata_s9_q[35:24], and_497_s9_q, right_codes_rdata_s9_q[23:12], and_496_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
  logic sample_pair_whole_s10_q;
  logic [5:0] run_shift_s10_q;
  logic [7:0] x_s10_q;
  logic [3:0] age_s10_q;
  logic [2:0] slot_s10_q;
  logic ends_cell_s10_q;
  logic lower_half_s10_q;
  logic equal_327_s10_q;
  logic [8:0] select_333_s10_q;
  logic and_342_s10_q;
  logic equal_348_s10_q;
  logic whole_s10_q;
  logic [6:0] column_s10_q;
  logic and_366_s10_q;
  logic and_368_s10_q;
  logic equal_371_s10_q;
  logic so_s10_q;
  logic equal_388_s10_q;
  logic or_389_s10_q;
  logic equal_391_s10_q;
  logic less_396_s10_q;
  logic not_397_s10_q;
  logic equal_429_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_510_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic select_517_s10_q;
  logic xor_598_s10_q;
  logic parity_647_s10_q;
  logic and_648_s10_q;
  logic or_652_s10_q;
  logic or_656_s10_q;
  logic or_663_s10_q;
  logic or_667_s10_q;
  logic or_671_s10_q;
  logic or_678_s10_q;
  logic or_682_s10_q;
  logic or_686_s10_q;
  logic and_695_s10_q;
  logic and_697_s10_q;
  logic or_709_s10_q;
  logic or_713_s10_q;
  logic or_717_s10_q;
  logic xor_847_s10_q;
  logic parity_862_s10_q;
  logic parity_896_s10_q;
  logic and_897_s10_q;
  logic or_901_s10_q;
  logic or_905_s10_q;
  logic or_912_s10_q;
  logic or_916_s10_q;
  logic or_920_s10_q;
  logic or_927_s10_q;
  logic or_931_s10_q;
  logic or_935_s10_q;
  logic and_944_s10_q;
  logic or_945_s10_q;
  logic or_958_s10_q;
  logic or_962_s10_q;
  logic or_966_s10_q;
  logic xor_1096_s10_q;
  logic parity_1111_s10_q;
  logic parity_1145_s10_q;
  logic and_1146_s10_q;
  logic or_1150_s10_q;
  logic or_1154_s10_q;
  logic or_1161_s10_q;
  logic or_1165_s10_q;
  logic or_1169_s10_q;
  logic or_1176_s10_q;
  logic or_1180_s10_q;
  logic or_1184_s10_q;
  logic and_1193_s10_q;
  logic or_1194_s10_q;
  logic or_1207_s10_q;
  logic or_1211_s10_q;
  logic or_1215_s10_q;
  logic and_1319_s10_q;
  logic [6:0] select_1323_s10_q;
  logic [6:0] right_s10_q;
  logic select_1328_s10_q;
  logic equal_1337_s10_q;
  logic and_1344_s10_q;
  logic and_1347_s10_q;
  logic and_1351_s10_q;
  logic or_1365_s10_q;
  logic less_1420_s10_q;
  logic equal_1460_s10_q;
  logic and_1595_s10_q;
  logic equal_1738_s10_q;
  logic equal_1859_s10_q;
  logic less_2112_s10_q;
  logic and_2195_s10_q;
  logic and_2197_s10_q;
  logic less_2304_s10_q;
  logic equal_2511_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      pixel_0_s10_q <= pixel_0_s9_q;
      pixel_1_s10_q <= pixel_1_s9_q;
      saturated_s10_q <= saturated_s9_q;
      mask_s10_q <= mask_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      sample_pair_whole_s10_q <= sample_pair_whole_s9_q;
      run_shift_s10_q <= run_shift_s9_q;
      x_s10_q <= x_s9_q;
      age_s10_q <= age_s9_q;
      slot_s10_q <= slot_s9_q;
      ends_cell_s10_q <= ends_cell_s9_q;
      lower_half_s10_q <= lower_half_s9_q;
      equal_327_s10_q <= equal_327_s9_q;
      select_333_s10_q <= select_333_s9_q;
      and_342_s10_q <= and_342_s9_q;
      equal_348_s10_q <= equal_348_s9_q;
      whole_s10_q <= whole_s9_q;
      column_s10_q <= column_s9_q;
      and_366_s10_q <= and_366_s9_q;
      and_368_s10_q <= and_368_s9_q;
      equal_371_s10_q <= equal_371_s9_q;
      so_s10_q <= so_s9_q;
      equal_388_s10_q <= equal_388_s9_q;
      or_389_s10_q <= or_389_s9_q;
      equal_391_s10_q <= equal_391_s9_q;
      less_396_s10_q <= less_396_s9_q;
      not_397_s10_q <= not_397_s9_q;
      equal_429_s10_q <= equal_429_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_510_s10_q <= select_510_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_517_s10_q <= select_517_s9_q;
      xor_598_s10_q <= parity_542 ^ parity_597;
      parity_647_s10_q <= parity_647;
      and_648_s10_q <= parity_542 & parity_597;
      or_652_s10_q <= or_652;
      or_656_s10_q <= (parity_582 & parity_594) | and_655;
      or_663_s10_q <= or_663;
      or_667_s10_q <= or_667;
      or_671_s10_q <= or_671;
      or_678_s10_q <= or_678;
      or_682_s10_q <= or_682;
      or_686_s10_q <= or_686;
      and_695_s10_q <= parity_629 & parity_644;
      and_697_s10_q <= (^{or_610, or_606, or_602}) & (parity_629 | parity_644);
      or_709_s10_q <= (or_606 & or_610) | (or_602 & (or_606 | or_610));
      or_713_s10_q <= (or_622 & or_626) | (or_618 & (or_622 | or_626));
      or_717_s10_q <= (or_637 & or_641) | (or_633 & (or_637 | or_641));
      xor_847_s10_q <= parity_791 ^ parity_846;
      parity_862_s10_q <= ^{or_859, or_855, or_851};
      parity_896_s10_q <= parity_896;
      and_897_s10_q <= parity_791 & parity_846;
      or_901_s10_q <= or_901;
      or_905_s10_q <= (parity_831 & parity_843) | and_904;
      or_912_s10_q <= or_912;
      or_916_s10_q <= or_916;
      or_920_s10_q <= or_920;
      or_927_s10_q <= or_927;
      or_931_s10_q <= or_931;
      or_935_s10_q <= or_935;
      and_944_s10_q <= parity_878 & parity_893;
      or_945_s10_q <= parity_878 | parity_893;
      or_958_s10_q <= (or_855 & or_859) | (or_851 & (or_855 | or_859));
      or_962_s10_q <= (or_871 & or_875) | (or_867 & (or_871 | or_875));
      or_966_s10_q <= (or_886 & or_890) | (or_882 & (or_886 | or_890));
      xor_1096_s10_q <= parity_1044 ^ parity_1095;
      parity_1111_s10_q <= ^{or_1108, or_1104, or_1100};
      parity_1145_s10_q <= parity_1145;
      and_1146_s10_q <= parity_1044 & parity_1095;
      or_1150_s10_q <= or_1150;
      or_1154_s10_q <= (parity_1080 & parity_1092) | and_1153;
      or_1161_s10_q <= or_1161;
      or_1165_s10_q <= or_1165;
      or_1169_s10_q <= or_1169;
      or_1176_s10_q <= or_1176;
      or_1180_s10_q <= or_1180;
      or_1184_s10_q <= or_1184;
      and_1193_s10_q <= parity_1127 & parity_1142;
      or_1194_s10_q <= parity_1127 | parity_1142;
      or_1207_s10_q <= (or_1104 & or_1108) | (or_1100 & (or_1104 | or_1108));
      or_1211_s10_q <= (or_1120 & or_1124) | (or_1116 & (or_1120 | or_1124));
      or_1215_s10_q <= (or_1135 & or_1139) | (or_1131 & (or_1135 | or_1139));
      and_1319_s10_q <= and_1319_s9_q;
      select_1323_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      select_1328_s10_q <= select_1328_s9_q;
      equal_1337_s10_q <= equal_1337_s9_q;
      and_1344_s10_q <= and_1344_s9_q;
      and_1347_s10_q <= and_1347_s9_q;
      and_1351_s10_q <= and_1351_s9_q;
      or_1365_s10_q <= or_1365;
      less_1420_s10_q <= {1'b0, sum_1419, last_s9_q[1]} < x_s9_q;
      equal_1460_s10_q <= x_s9_q == {1'b0, last_s9_q};
      and_1595_s10_q <= and_1592_s9_q & (~({sum_1419, last_s9_q[1:0]} < x_s9_q));
      equal_1738_s10_q <= equal_1738_s9_q;
      equal_1859_s10_q <= equal_1859_s9_q;
      less_2112_s10_q <= less_2112_s9_q;
      and_2195_s10_q <= and_2195_s9_q;
      and_2197_s10_q <= and_2197_s9_q;
      less_2304_s10_q <= less_2304_s9_q;
      equal_2511_s10_q <= equal_2511_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:672
  logic parity_674;
  assign parity_674 = ^{or_671_s10_q, or_667_s10_q, or_663_s10_q};
  logic parity_689;
  assign parity_689 = ^{or_686_s10_q, or_682_s10_q, or_678_s10_q};
  logic parity_692;
  assign parity_692 = ^{or_686_s10_q, or_682_s10_q, or_678_s10_q, or_671_s10_q, or_667_s10_q, or_663_s10_q, or_656_s10_q, or_652_s10_q, and_648_s10_q};
  // hls/stages/agreement.hpp:673
  logic and_694;
  assign and_694 = parity_647_s10_q & parity_692;
  logic or_698;
  assign or_698 = and_695_s10_q | and_697_s10_q;
  logic and_701;
  assign and_701 = (^{or_656_s10_q, or_652_s10_q, and_648_s10_q}) & (parity_674 | parity_689);
  logic or_702;
  assign or_702 = (parity_674 & parity_689) | and_701;
  // hls/stages/agreement.hpp:672
  logic parity_720;
  assign parity_720 = ^{or_717_s10_q, or_713_s10_q, or_709_s10_q};
  // hls/stages/agreement.hpp:673
  logic or_724;
  assign or_724 = (or_652_s10_q & or_656_s10_q) | (and_648_s10_q & (or_652_s10_q | or_656_s10_q));
  logic or_728;
  assign or_728 = (or_667_s10_q & or_671_s10_q) | (or_663_s10_q & (or_667_s10_q | or_671_s10_q));
  logic or_732;
  assign or_732 = (or_682_s10_q & or_686_s10_q) | (or_678_s10_q & (or_682_s10_q | or_686_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_735;
  assign parity_735 = ^{or_732, or_728, or_724};
  logic parity_738;
  assign parity_738 = ^{or_732, or_728, or_724, or_717_s10_q, or_713_s10_q, or_709_s10_q, or_702, or_698, and_694};
  // hls/stages/agreement.hpp:673
  logic or_750;
  assign or_750 = (or_713_s10_q & or_717_s10_q) | (or_709_s10_q & (or_713_s10_q | or_717_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_923;
  assign parity_923 = ^{or_920_s10_q, or_916_s10_q, or_912_s10_q};
  logic parity_938;
  assign parity_938 = ^{or_935_s10_q, or_931_s10_q, or_927_s10_q};
  logic parity_941;
  assign parity_941 = ^{or_935_s10_q, or_931_s10_q, or_927_s10_q, or_920_s10_q, or_916_s10_q, or_912_s10_q, or_905_s10_q, or_901_s10_q, and_897_s10_q};
  // hls/stages/agreement.hpp:673
  logic and_943;
  assign and_943 = parity_896_s10_q & parity_941;
  logic or_947;
  assign or_947 = and_944_s10_q | (parity_862_s10_q & or_945_s10_q);
  logic and_950;
  assign and_950 = (^{or_905_s10_q, or_901_s10_q, and_897_s10_q}) & (parity_923 | parity_938);
  logic or_951;
  assign or_951 = (parity_923 & parity_938) | and_950;
  // hls/stages/agreement.hpp:672
  logic parity_969;
  assign parity_969 = ^{or_966_s10_q, or_962_s10_q, or_958_s10_q};
  // hls/stages/agreement.hpp:673
  logic or_973;
  assign or_973 = (or_901_s10_q & or_905_s10_q) | (and_897_s10_q & (or_901_s10_q | or_905_s10_q));
  logic or_977;
  assign or_977 = (or_916_s10_q & or_920_s10_q) | (or_912_s10_q & (or_916_s10_q | or_920_s10_q));
  logic or_981;
  assign or_981 = (or_931_s10_q & or_935_s10_q) | (or_927_s10_q & (or_931_s10_q | or_935_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_984;
  assign parity_984 = ^{or_981, or_977, or_973};
  logic parity_987;
  assign parity_987 = ^{or_981, or_977, or_973, or_966_s10_q, or_962_s10_q, or_958_s10_q, or_951, or_947, and_943};
  // hls/stages/agreement.hpp:673
  logic or_999;
  assign or_999 = (or_962_s10_q & or_966_s10_q) | (or_958_s10_q & (or_962_s10_q | or_966_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_1172;
  assign parity_1172 = ^{or_1169_s10_q, or_1165_s10_q, or_1161_s10_q};
  logic parity_1187;
  assign parity_1187 = ^{or_1184_s10_q, or_1180_s10_q, or_1176_s10_q};
  logic parity_1190;
  assign parity_1190 = ^{or_1184_s10_q, or_1180_s10_q, or_1176_s10_q, or_1169_s10_q, or_1165_s10_q, or_1161_s10_q, or_1154_s10_q, or_1150_s10_q, and_1146_s10_q};
  // hls/stages/agreement.hpp:673
  logic and_1192;
  assign and_1192 = parity_1145_s10_q & parity_1190;
  logic or_1196;
  assign or_1196 = and_1193_s10_q | (parity_1111_s10_q & or_1194_s10_q);
  logic and_1199;
  assign and_1199 = (^{or_1154_s10_q, or_1150_s10_q, and_1146_s10_q}) & (parity_1172 | parity_1187);
  logic or_1200;
  assign or_1200 = (parity_1172 & parity_1187) | and_1199;
  // hls/stages/agreement.hpp:672
  logic parity_1218;
  assign parity_1218 = ^{or_1215_s10_q, or_1211_s10_q, or_1207_s10_q};
  // hls/stages/agreement.hpp:673
  logic or_1222;
  assign or_1222 = (or_1150_s10_q & or_1154_s10_q) | (and_1146_s10_q & (or_1150_s10_q | or_1154_s10_q));
  logic or_1226;
  assign or_1226 = (or_1165_s10_q & or_1169_s10_q) | (or_1161_s10_q & (or_1165_s10_q | or_1169_s10_q));
  logic or_1230;
  assign or_1230 = (or_1180_s10_q & or_1184_s10_q) | (or_1176_s10_q & (or_1180_s10_q | or_1184_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_1233;
  assign parity_1233 = ^{or_1230, or_1226, or_1222};
  logic parity_1236;
  assign parity_1236 = ^{or_1230, or_1226, or_1222, or_1215_s10_q, or_1211_s10_q, or_1207_s10_q, or_1200, or_1196, and_1192};
  // hls/stages/agreement.hpp:673
  logic or_1248;
  assign or_1248 = (or_1211_s10_q & or_1215_s10_q) | (or_1207_s10_q & (or_1211_s10_q | or_1215_s10_q));
  // hls/stages/agreement.hpp:137
  logic [6:0] select_1375;
  assign select_1375 = or_389_s10_q ? (less_396_s10_q ? 7'h0 : select_1323_s10_q) : 7'h0;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1302; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_389_s10_q ? select_1323_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_510_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  logic [7:0] pixel_0_s11_q;
  logic [7:0] pixel_1_s11_q;
  logic saturated_s11_q;
  logic mask_s11_q;
  logic marks_first_s11_q;
  logic marks_last_s11_q;
  logic sample_pair_whole_s11_q;
  logic [5:0] run_shift_s11_q;
  logic [7:0] x_s11_q;
  logic [3:0] age_s11_q;
  logic [2:0] slot_s11_q;
  logic ends_cell_s11_q;
  logic lower_half_s11_q;
  logic equal_327_s11_q;
  logic [8:0] select_333_s11_q;
  logic and_342_s11_q;
  logic equal_348_s11_q;
  logic whole_s11_q;
  logic [6:0] column_s11_q;
  logic and_366_s11_q;
  logic and_368_s11_q;
  logic equal_371_s11_q;
  logic so_s11_q;
  logic equal_388_s11_q;
  logic or_389_s11_q;
  logic equal_391_s11_q;
  logic less_396_s11_q;
  logic not_397_s11_q;
  logic equal_429_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic select_517_s11_q;
  logic xor_598_s11_q;
  logic xor_693_s11_q;
  logic parity_738_s11_q;
  logic and_739_s11_q;
  logic and_741_s11_q;
  logic and_743_s11_q;
  logic and_745_s11_q;
  logic or_750_s11_q;
  logic or_754_s11_q;
  logic xor_847_s11_q;
  logic xor_942_s11_q;
  logic parity_987_s11_q;
  logic and_988_s11_q;
  logic and_990_s11_q;
  logic and_992_s11_q;
  logic and_994_s11_q;
  logic or_999_s11_q;
  logic or_1003_s11_q;
  logic xor_1096_s11_q;
  logic xor_1191_s11_q;
  logic parity_1236_s11_q;
  logic and_1237_s11_q;
  logic and_1239_s11_q;
  logic and_1241_s11_q;
  logic and_1243_s11_q;
  logic or_1248_s11_q;
  logic or_1252_s11_q;
  logic and_1319_s11_q;
  logic [6:0] right_s11_q;
  logic select_1328_s11_q;
  logic equal_1337_s11_q;
  logic and_1344_s11_q;
  logic and_1347_s11_q;
  logic and_1351_s11_q;
  logic or_1365_s11_q;
  logic [6:0] select_1376_s11_q;
  logic less_1420_s11_q;
  logic equal_1460_s11_q;
  logic and_1597_s11_q;
  logic equal_1738_s11_q;
  logic equal_1859_s11_q;
  logic less_2112_s11_q;
  logic and_2195_s11_q;
  logic and_2197_s11_q;
  logic less_2304_s11_q;
  logic equal_2511_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      pixel_0_s11_q <= pixel_0_s10_q;
      pixel_1_s11_q <= pixel_1_s10_q;
      saturated_s11_q <= saturated_s10_q;
      mask_s11_q <= mask_s10_q;
      marks_first_s11_q <= marks_first_s10_q;
      marks_last_s11_q <= marks_last_s10_q;
      sample_pair_whole_s11_q <= sample_pair_whole_s10_q;
      run_shift_s11_q <= run_shift_s10_q;
      x_s11_q <= x_s10_q;
      age_s11_q <= age_s10_q;
      slot_s11_q <= slot_s10_q;
      ends_cell_s11_q <= ends_cell_s10_q;
      lower_half_s11_q <= lower_half_s10_q;
      equal_327_s11_q <= equal_327_s10_q;
      select_333_s11_q <= select_333_s10_q;
      and_342_s11_q <= and_342_s10_q;
      equal_348_s11_q <= equal_348_s10_q;
      whole_s11_q <= whole_s10_q;
      column_s11_q <= column_s10_q;
      and_366_s11_q <= and_366_s10_q;
      and_368_s11_q <= and_368_s10_q;
      equal_371_s11_q <= equal_371_s10_q;
      so_s11_q <= so_s10_q;
      equal_388_s11_q <= equal_388_s10_q;
      or_389_s11_q <= or_389_s10_q;
      equal_391_s11_q <= equal_391_s10_q;
      less_396_s11_q <= less_396_s10_q;
      not_397_s11_q <= not_397_s10_q;
      equal_429_s11_q <= equal_429_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_517_s11_q <= select_517_s10_q;
      xor_598_s11_q <= xor_598_s10_q;
      xor_693_s11_q <= parity_647_s10_q ^ parity_692;
      parity_738_s11_q <= parity_738;
      and_739_s11_q <= parity_720 & parity_735;
      and_741_s11_q <= (^{or_702, or_698, and_694}) & (parity_720 | parity_735);
      and_743_s11_q <= or_698 & or_702;
      and_745_s11_q <= and_694 & (or_698 | or_702);
      or_750_s11_q <= or_750;
      or_754_s11_q <= (or_728 & or_732) | (or_724 & (or_728 | or_732));
      xor_847_s11_q <= xor_847_s10_q;
      xor_942_s11_q <= parity_896_s10_q ^ parity_941;
      parity_987_s11_q <= parity_987;
      and_988_s11_q <= parity_969 & parity_984;
      and_990_s11_q <= (^{or_951, or_947, and_943}) & (parity_969 | parity_984);
      and_992_s11_q <= or_947 & or_951;
      and_994_s11_q <= and_943 & (or_947 | or_951);
      or_999_s11_q <= or_999;
      or_1003_s11_q <= (or_977 & or_981) | (or_973 & (or_977 | or_981));
      xor_1096_s11_q <= xor_1096_s10_q;
      xor_1191_s11_q <= parity_1145_s10_q ^ parity_1190;
      parity_1236_s11_q <= parity_1236;
      and_1237_s11_q <= parity_1218 & parity_1233;
      and_1239_s11_q <= (^{or_1200, or_1196, and_1192}) & (parity_1218 | parity_1233);
      and_1241_s11_q <= or_1196 & or_1200;
      and_1243_s11_q <= and_1192 & (or_1196 | or_1200);
      or_1248_s11_q <= or_1248;
      or_1252_s11_q <= (or_1226 & or_1230) | (or_1222 & (or_1226 | or_1230));
      and_1319_s11_q <= and_1319_s10_q;
      right_s11_q <= right_s10_q;
      select_1328_s11_q <= select_1328_s10_q;
      equal_1337_s11_q <= equal_1337_s10_q;
      and_1344_s11_q <= and_1344_s10_q;
      and_1347_s11_q <= and_1347_s10_q;
      and_1351_s11_q <= and_1351_s10_q;
      or_1365_s11_q <= or_1365_s10_q;
      select_1376_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1375;
      less_1420_s11_q <= less_1420_s10_q;
      equal_1460_s11_q <= equal_1460_s10_q;
      and_1597_s11_q <= so_s10_q & (ends_cell_s10_q & and_1595_s10_q);
      equal_1738_s11_q <= equal_1738_s10_q;
      equal_1859_s11_q <= equal_1859_s10_q;
      less_2112_s11_q <= less_2112_s10_q;
      and_2195_s11_q <= and_2195_s10_q;
      and_2197_s11_q <= and_2197_s10_q;
      less_2304_s11_q <= less_2304_s10_q;
      equal_2511_s11_q <= equal_2511_s10_q;
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
  // hls/stages/agreement.hpp:673
  logic or_742;
  assign or_742 = and_739_s11_q | and_741_s11_q;
  logic or_746;
  assign or_746 = and_743_s11_q | and_745_s11_q;
  // hls/stages/agreement.hpp:672
  logic parity_759;
  assign parity_759 = ^{or_754_s11_q, or_750_s11_q, or_746, or_742};
  // hls/stages/agreement.hpp:673
  logic or_763;
  assign or_763 = (or_750_s11_q & or_754_s11_q) | (or_746 & (or_750_s11_q | or_754_s11_q));
  logic and_764;
  assign and_764 = or_742 & (^{or_754_s11_q, or_750_s11_q, or_746});
  // hls/stages/agreement.hpp:672
  logic xor_765;
  assign xor_765 = or_763 ^ and_764;
  // hls/stages/agreement.hpp:675
  logic and_766;
  assign and_766 = or_763 & and_764;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_767;
  assign select_767 = equal_391_s11_q ? {and_766, xor_765, parity_759, parity_738_s11_q, xor_693_s11_q, xor_598_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_389_s11_q ? 6'h0 : select_767;
  // hls/stages/agreement.hpp:673
  logic or_991;
  assign or_991 = and_988_s11_q | and_990_s11_q;
  logic or_995;
  assign or_995 = and_992_s11_q | and_994_s11_q;
  // hls/stages/agreement.hpp:672
  logic parity_1008;
  assign parity_1008 = ^{or_1003_s11_q, or_999_s11_q, or_995, or_991};
  // hls/stages/agreement.hpp:673
  logic or_1012;
  assign or_1012 = (or_999_s11_q & or_1003_s11_q) | (or_995 & (or_999_s11_q | or_1003_s11_q));
  logic and_1013;
  assign and_1013 = or_991 & (^{or_1003_s11_q, or_999_s11_q, or_995});
  // hls/stages/agreement.hpp:672
  logic xor_1014;
  assign xor_1014 = or_1012 ^ and_1013;
  // hls/stages/agreement.hpp:675
  logic and_1015;
  assign and_1015 = or_1012 & and_1013;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1016;
  assign select_1016 = equal_391_s11_q ? {and_1015, xor_1014, parity_1008, parity_987_s11_q, xor_942_s11_q, xor_847_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_389_s11_q ? 6'h0 : select_1016;
  // hls/stages/agreement.hpp:673
  logic or_1240;
  assign or_1240 = and_1237_s11_q | and_1239_s11_q;
  logic or_1244;
  assign or_1244 = and_1241_s11_q | and_1243_s11_q;
  // hls/stages/agreement.hpp:672
  logic parity_1257;
  assign parity_1257 = ^{or_1252_s11_q, or_1248_s11_q, or_1244, or_1240};
  // hls/stages/agreement.hpp:673
  logic or_1261;
  assign or_1261 = (or_1248_s11_q & or_1252_s11_q) | (or_1244 & (or_1248_s11_q | or_1252_s11_q));
  logic and_1262;
  assign and_1262 = or_1240 & (^{or_1252_s11_q, or_1248_s11_q, or_1244});
  // hls/stages/agreement.hpp:672
  logic xor_1263;
  assign xor_1263 = or_1261 ^ and_1262;
  // hls/stages/agreement.hpp:675
  logic and_1264;
  assign and_1264 = or_1261 & and_1262;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1265;
  assign select_1265 = equal_391_s11_q ? {and_1264, xor_1263, parity_1257, parity_1236_s11_q, xor_1191_s11_q, xor_1096_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_389_s11_q ? 6'h0 : select_1265;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1297;
  assign sum_1297 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1300;
  assign sum_1300 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};

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
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [3:0] age_s12_q;
  logic [2:0] slot_s12_q;
  logic ends_cell_s12_q;
  logic lower_half_s12_q;
  logic equal_327_s12_q;
  logic [8:0] select_333_s12_q;
  logic and_342_s12_q;
  logic equal_348_s12_q;
  logic whole_s12_q;
  logic [6:0] column_s12_q;
  logic and_366_s12_q;
  logic and_368_s12_q;
  logic equal_371_s12_q;
  logic so_s12_q;
  logic equal_388_s12_q;
  logic or_389_s12_q;
  logic less_396_s12_q;
  logic not_397_s12_q;
  logic equal_429_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic select_517_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1018_s12_q;
  logic [5:0] select_1267_s12_q;
  logic [6:0] sum_1298_s12_q;
  logic [6:0] sum_1301_s12_q;
  logic and_1319_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic select_1328_s12_q;
  logic equal_1337_s12_q;
  logic and_1344_s12_q;
  logic and_1347_s12_q;
  logic and_1351_s12_q;
  logic or_1365_s12_q;
  logic [6:0] select_1376_s12_q;
  logic less_1420_s12_q;
  logic equal_1460_s12_q;
  logic and_1597_s12_q;
  logic equal_1738_s12_q;
  logic equal_1859_s12_q;
  logic less_2112_s12_q;
  logic and_2195_s12_q;
  logic and_2197_s12_q;
  logic less_2304_s12_q;
  logic equal_2511_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      pixel_0_s12_q <= pixel_0_s11_q;
      pixel_1_s12_q <= pixel_1_s11_q;
      saturated_s12_q <= saturated_s11_q;
      mask_s12_q <= mask_s11_q;
      marks_first_s12_q <= marks_first_s11_q;
      marks_last_s12_q <= marks_last_s11_q;
      sample_pair_whole_s12_q <= sample_pair_whole_s11_q;
      run_shift_s12_q <= run_shift_s11_q;
      x_s12_q <= x_s11_q;
      age_s12_q <= age_s11_q;
      slot_s12_q <= slot_s11_q;
      ends_cell_s12_q <= ends_cell_s11_q;
      lower_half_s12_q <= lower_half_s11_q;
      equal_327_s12_q <= equal_327_s11_q;
      select_333_s12_q <= select_333_s11_q;
      and_342_s12_q <= and_342_s11_q;
      equal_348_s12_q <= equal_348_s11_q;
      whole_s12_q <= whole_s11_q;
      column_s12_q <= column_s11_q;
      and_366_s12_q <= and_366_s11_q;
      and_368_s12_q <= and_368_s11_q;
      equal_371_s12_q <= equal_371_s11_q;
      so_s12_q <= so_s11_q;
      equal_388_s12_q <= equal_388_s11_q;
      or_389_s12_q <= or_389_s11_q;
      less_396_s12_q <= less_396_s11_q;
      not_397_s12_q <= not_397_s11_q;
      equal_429_s12_q <= equal_429_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_517_s12_q <= select_517_s11_q;
      column_2_s12_q <= column_2;
      select_1018_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1267_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1298_s12_q <= {1'b0, before_v_2} + sum_1297;
      sum_1301_s12_q <= {1'b0, before_v_3} + sum_1300;
      and_1319_s12_q <= and_1319_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      select_1328_s12_q <= select_1328_s11_q;
      equal_1337_s12_q <= equal_1337_s11_q;
      and_1344_s12_q <= and_1344_s11_q;
      and_1347_s12_q <= and_1347_s11_q;
      and_1351_s12_q <= and_1351_s11_q;
      or_1365_s12_q <= or_1365_s11_q;
      select_1376_s12_q <= select_1376_s11_q;
      less_1420_s12_q <= less_1420_s11_q;
      equal_1460_s12_q <= equal_1460_s11_q;
      and_1597_s12_q <= and_1597_s11_q;
      equal_1738_s12_q <= equal_1738_s11_q;
      equal_1859_s12_q <= equal_1859_s11_q;
      less_2112_s12_q <= less_2112_s11_q;
      and_2195_s12_q <= and_2195_s11_q;
      and_2197_s12_q <= and_2197_s11_q;
      less_2304_s12_q <= less_2304_s11_q;
      equal_2511_s12_q <= equal_2511_s11_q;
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
  // hls/stages/agreement.hpp:777
  logic [5:0] select_769;
  assign select_769 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1293;
  assign sum_1293 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1303;
  assign select_1303 = (sum_1298_s12_q < sum_1301_s12_q) ? sum_1301_s12_q : sum_1298_s12_q;
  // hls/stages/agreement.hpp:951
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:220
  logic [5:0] select_1959;
  assign select_1959 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_1960;
  assign select_1960 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1961;
  assign select_1961 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_1962;
  assign select_1962 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1963;
  assign select_1963 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1964;
  assign select_1964 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;

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
      middle_sum_columns_values_1_q <= select_1959;
      middle_sum_columns_values_2_q <= select_1960;
      middle_sum_columns_values_3_q <= select_1961;
      middle_sum_columns_values_4_q <= select_1962;
      middle_sum_columns_values_5_q <= select_1963;
      middle_sum_columns_values_6_q <= select_1964;
    end
  end

  logic [7:0] pixel_0_s13_q;
  logic [7:0] pixel_1_s13_q;
  logic saturated_s13_q;
  logic mask_s13_q;
  logic marks_first_s13_q;
  logic marks_last_s13_q;
  logic sample_pair_whole_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic [1:0] age_s13_q;
  logic [2:0] slot_s13_q;
  logic ends_cell_s13_q;
  logic lower_half_s13_q;
  logic equal_327_s13_q;
  logic [8:0] select_333_s13_q;
  logic and_342_s13_q;
  logic equal_348_s13_q;
  logic whole_s13_q;
  logic [6:0] column_s13_q;
  logic and_366_s13_q;
  logic and_368_s13_q;
  logic equal_371_s13_q;
  logic so_s13_q;
  logic equal_388_s13_q;
  logic or_389_s13_q;
  logic less_396_s13_q;
  logic not_397_s13_q;
  logic equal_429_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_517_s13_q;
  logic [6:0] difference_770_s13_q;
  logic [6:0] difference_1019_s13_q;
  logic equal_1020_s13_q;
  logic [6:0] difference_1268_s13_q;
  logic [6:0] sum_1294_s13_q;
  logic [6:0] select_1303_s13_q;
  logic and_1319_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1328_s13_q;
  logic equal_1337_s13_q;
  logic and_1344_s13_q;
  logic and_1347_s13_q;
  logic and_1351_s13_q;
  logic less_1352_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1365_s13_q;
  logic [6:0] select_1376_s13_q;
  logic less_1420_s13_q;
  logic equal_1460_s13_q;
  logic and_1597_s13_q;
  logic equal_1738_s13_q;
  logic equal_1859_s13_q;
  logic less_2112_s13_q;
  logic and_2195_s13_q;
  logic and_2197_s13_q;
  logic less_2304_s13_q;
  logic equal_2511_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
      pixel_0_s13_q <= pixel_0_s12_q;
      pixel_1_s13_q <= pixel_1_s12_q;
      saturated_s13_q <= saturated_s12_q;
      mask_s13_q <= mask_s12_q;
      marks_first_s13_q <= marks_first_s12_q;
      marks_last_s13_q <= marks_last_s12_q;
      sample_pair_whole_s13_q <= sample_pair_whole_s12_q;
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      age_s13_q <= {age_s12_q[2], age_s12_q[0]};
      slot_s13_q <= slot_s12_q;
      ends_cell_s13_q <= ends_cell_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      equal_327_s13_q <= equal_327_s12_q;
      select_333_s13_q <= select_333_s12_q;
      and_342_s13_q <= and_342_s12_q;
      equal_348_s13_q <= equal_348_s12_q;
      whole_s13_q <= whole_s12_q;
      column_s13_q <= column_s12_q;
      and_366_s13_q <= and_366_s12_q;
      and_368_s13_q <= and_368_s12_q;
      equal_371_s13_q <= equal_371_s12_q;
      so_s13_q <= so_s12_q;
      equal_388_s13_q <= equal_388_s12_q;
      or_389_s13_q <= or_389_s12_q;
      less_396_s13_q <= less_396_s12_q;
      not_397_s13_q <= not_397_s12_q;
      equal_429_s13_q <= equal_429_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_517_s13_q <= select_517_s12_q;
      difference_770_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_769};
      difference_1019_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1018_s12_q};
      equal_1020_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1268_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1267_s12_q};
      sum_1294_s13_q <= {1'b0, before_v} + sum_1293;
      select_1303_s13_q <= select_1303;
      and_1319_s13_q <= and_1319_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1328_s13_q <= select_1328_s12_q;
      equal_1337_s13_q <= equal_1337_s12_q;
      and_1344_s13_q <= and_1344_s12_q;
      and_1347_s13_q <= and_1347_s12_q;
      and_1351_s13_q <= and_1351_s12_q;
      less_1352_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1365_s13_q <= or_1365_s12_q;
      select_1376_s13_q <= select_1376_s12_q;
      less_1420_s13_q <= less_1420_s12_q;
      equal_1460_s13_q <= equal_1460_s12_q;
      and_1597_s13_q <= and_1597_s12_q;
      equal_1738_s13_q <= equal_1738_s12_q;
      equal_1859_s13_q <= equal_1859_s12_q;
      less_2112_s13_q <= less_2112_s12_q;
      and_2195_s13_q <= and_2195_s12_q;
      and_2197_s13_q <= and_2197_s12_q;
      less_2304_s13_q <= less_2304_s12_q;
      equal_2511_s13_q <= equal_2511_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [6:0] chosen_near_q;
  // hls/stages/agreement.hpp:787
  logic less_518;
  assign less_518 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_520;
  assign less_520 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:777
  logic [7:0] sum_772;
  assign sum_772 = {difference_770_s13_q[6], difference_770_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1022;
  assign sum_1022 = {difference_1019_s13_q[6], difference_1019_s13_q} + (equal_1020_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1270;
  assign sum_1270 = {difference_1268_s13_q[6], difference_1268_s13_q} + (equal_1020_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:754
  logic [6:0] select_1295;
  assign select_1295 = slot_s13_q[0] ? chosen_near_q : sum_1294_s13_q;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1305;
  assign select_1305 = (select_1295 < select_1303_s13_q) ? select_1303_s13_q : select_1295;
  // hls/stages/agreement.hpp:950
  logic select_1354;
  assign select_1354 = slot_s13_q[2] ? less_1352_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:957
  logic [8:0] difference_1357;
  assign difference_1357 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/agreement.hpp:220
  logic [6:0] select_1971;
  assign select_1971 = slot_s13_q[0] ? 7'h0 : sum_1294_s13_q;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1973;
  assign select_1973 = (select_1971 < select_1303_s13_q) ? select_1303_s13_q : select_1971;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_near_q <= 7'h0;
    end else if (s13_en) begin
      chosen_near_q <= select_1973;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_772;
      sums_0_sum_sums_values_0_q <= sum_1022;
      sums_0_sum_sums_values_1_q <= equal_1020_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1270;
      sums_1_sum_sums_values_1_q <= equal_1020_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic [7:0] pixel_0_s14_q;
  logic [7:0] pixel_1_s14_q;
  logic saturated_s14_q;
  logic mask_s14_q;
  logic marks_first_s14_q;
  logic marks_last_s14_q;
  logic sample_pair_whole_s14_q;
  logic [5:0] run_shift_s14_q;
  logic [7:0] x_s14_q;
  logic age_s14_q;
  logic [2:0] slot_s14_q;
  logic ends_cell_s14_q;
  logic lower_half_s14_q;
  logic equal_327_s14_q;
  logic [8:0] select_333_s14_q;
  logic and_342_s14_q;
  logic equal_348_s14_q;
  logic whole_s14_q;
  logic [6:0] column_s14_q;
  logic and_366_s14_q;
  logic and_368_s14_q;
  logic equal_371_s14_q;
  logic so_s14_q;
  logic equal_388_s14_q;
  logic or_389_s14_q;
  logic less_396_s14_q;
  logic not_397_s14_q;
  logic equal_429_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_517_s14_q;
  logic and_522_s14_q;
  logic [7:0] sum_772_s14_q;
  logic less_1271_s14_q;
  logic [6:0] select_1305_s14_q;
  logic and_1319_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1328_s14_q;
  logic equal_1337_s14_q;
  logic and_1344_s14_q;
  logic and_1347_s14_q;
  logic and_1351_s14_q;
  logic select_1354_s14_q;
  logic [9:0] sum_1358_s14_q;
  logic or_1365_s14_q;
  logic [6:0] select_1376_s14_q;
  logic less_1420_s14_q;
  logic equal_1460_s14_q;
  logic and_1597_s14_q;
  logic equal_1738_s14_q;
  logic equal_1859_s14_q;
  logic less_2112_s14_q;
  logic and_2195_s14_q;
  logic and_2197_s14_q;
  logic and_2204_s14_q;
  logic less_2304_s14_q;
  logic equal_2511_s14_q;
  always_ff @(posedge clk_i) begin
    if (s13_en) begin
      pixel_0_s14_q <= pixel_0_s13_q;
      pixel_1_s14_q <= pixel_1_s13_q;
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_whole_s14_q <= sample_pair_whole_s13_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      age_s14_q <= age_s13_q[1];
      slot_s14_q <= slot_s13_q;
      ends_cell_s14_q <= ends_cell_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      equal_327_s14_q <= equal_327_s13_q;
      select_333_s14_q <= select_333_s13_q;
      and_342_s14_q <= and_342_s13_q;
      equal_348_s14_q <= equal_348_s13_q;
      whole_s14_q <= whole_s13_q;
      column_s14_q <= column_s13_q;
      and_366_s14_q <= and_366_s13_q;
      and_368_s14_q <= and_368_s13_q;
      equal_371_s14_q <= equal_371_s13_q;
      so_s14_q <= so_s13_q;
      equal_388_s14_q <= equal_388_s13_q;
      or_389_s14_q <= or_389_s13_q;
      less_396_s14_q <= less_396_s13_q;
      not_397_s14_q <= not_397_s13_q;
      equal_429_s14_q <= equal_429_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_517_s14_q <= select_517_s13_q;
      and_522_s14_q <= (~less_518) & (~less_520);
      sum_772_s14_q <= sum_772;
      less_1271_s14_q <= sum_1022 < sum_1270;
      select_1305_s14_q <= select_1305;
      and_1319_s14_q <= and_1319_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1328_s14_q <= select_1328_s13_q;
      equal_1337_s14_q <= equal_1337_s13_q;
      and_1344_s14_q <= and_1344_s13_q;
      and_1347_s14_q <= and_1347_s13_q;
      and_1351_s14_q <= and_1351_s13_q;
      select_1354_s14_q <= select_1354;
      sum_1358_s14_q <= {difference_1357[8], difference_1357} + 10'h1;
      or_1365_s14_q <= or_1365_s13_q;
      select_1376_s14_q <= select_1376_s13_q;
      less_1420_s14_q <= less_1420_s13_q;
      equal_1460_s14_q <= equal_1460_s13_q;
      and_1597_s14_q <= and_1597_s13_q;
      equal_1738_s14_q <= equal_1738_s13_q;
      equal_1859_s14_q <= equal_1859_s13_q;
      less_2112_s14_q <= less_2112_s13_q;
      and_2195_s14_q <= and_2195_s13_q;
      and_2197_s14_q <= and_2197_s13_q;
      and_2204_s14_q <= ends_cell_s13_q & so_s13_q;
      less_2304_s14_q <= less_2304_s13_q;
      equal_2511_s14_q <= equal_2511_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [7:0] chosen_score_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/agreement.hpp:754
  logic [7:0] select_773;
  assign select_773 = slot_s14_q[0] ? chosen_score_q : sum_772_s14_q;
  // hls/stages/agreement.hpp:750
  logic [7:0] select_1272;
  assign select_1272 = less_1271_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1273;
  assign less_1273 = select_773 < select_1272;
  // hls/stages/agreement.hpp:791
  logic [7:0] of_best;
  assign of_best = and_522_s14_q ? (less_1273 ? select_1272 : select_773) : 8'h0;
  // hls/stages/agreement.hpp:719
  logic not_1279;
  assign not_1279 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:751
  logic [1:0] select_1280;
  assign select_1280 = less_1271_s14_q ? {slot_s14_q[0], not_1279} : 2'h0;
  logic [2:0] select_1282;
  assign select_1282 = less_1273 ? {select_1280, not_1279} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:792
  logic [6:0] of_near;
  assign of_near = and_522_s14_q ? select_1305_s14_q : 7'h0;
  // hls/stages/agreement.hpp:228
  logic and_1360;
  assign and_1360 = (and_1347_s14_q & select_1354_s14_q) & ({{22{sum_1358_s14_q[9]}}, sum_1358_s14_q} < 32'h3);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1458;
  assign sum_1458 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:220
  logic [7:0] select_1968;
  assign select_1968 = slot_s14_q[0] ? 8'h0 : sum_772_s14_q;
  // hls/stages/agreement.hpp:750
  logic less_1969;
  assign less_1969 = select_1968 < select_1272;
  // hls/stages/agreement.hpp:137
  logic [7:0] select_2064;
  assign select_2064 = or_389_s14_q ? (less_396_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2066;
  assign select_2066 = or_389_s14_q ? (less_396_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:213
  logic [16:0] select_2086;
  assign select_2086 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/registration.hpp:128
  logic [15:0] select_2198;
  assign select_2198 = and_2197_s14_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2200;
  assign select_2200 = and_2195_s14_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2198[15]}}, select_2198});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2201;
  assign select_2201 = and_2197_s14_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2201[15]}}, select_2201};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2203;
  assign select_2203 = and_2195_s14_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:124
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2204_s14_q ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:190
  logic [8:0] select_2316;
  assign select_2316 = so_s14_q ? (and_2204_s14_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2318;
  assign sum_2318 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2319;
  assign select_2319 = sum_1458[5] ? {1'b1, sum_1458[4:0], region_across_rest_q[2:0]} : sum_2318;
  // hls/stages/agreement.hpp:436
  logic [8:0] select_2321;
  assign select_2321 = equal_1859_s14_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_2324;
  assign select_2324 = equal_1859_s14_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_score_q <= 8'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s14_en) begin
      chosen_score_q <= less_1969 ? select_1272 : select_1968;
      chosen_place_q <= less_1969 ? {select_1280, not_1279} : 3'h2;
      before_0_q <= select_1968;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      registration_slope_row_q <= select_2200;
      registration_slope_change_q <= select_2203;
      registration_slope_q <= so_s14_q ? column_5 : {registration_slope_row_q, 4'h0};
      region_across_rest_q <= select_2316;
      region_across_back_q <= so_s14_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2319;
      columns_begin_rest_q <= and_368_s14_q ? select_2321 : columns_begin_rest_q;
      columns_begin_back_q <= and_368_s14_q ? select_2324 : columns_begin_back_q;
    end
  end

  logic [7:0] pixel_0_s15_q;
  logic [7:0] pixel_1_s15_q;
  logic saturated_s15_q;
  logic mask_s15_q;
  logic marks_first_s15_q;
  logic marks_last_s15_q;
  logic sample_pair_whole_s15_q;
  logic [5:0] run_shift_s15_q;
  logic [7:0] x_s15_q;
  logic age_s15_q;
  logic [2:0] slot_s15_q;
  logic ends_cell_s15_q;
  logic lower_half_s15_q;
  logic [7:0] before_0_s15_q;
  logic [7:0] before_1_s15_q;
  logic [7:0] before_2_s15_q;
  logic [11:0] registration_slope_s15_q;
  logic equal_327_s15_q;
  logic [8:0] select_333_s15_q;
  logic and_342_s15_q;
  logic equal_348_s15_q;
  logic whole_s15_q;
  logic [6:0] column_s15_q;
  logic and_366_s15_q;
  logic and_368_s15_q;
  logic equal_371_s15_q;
  logic so_s15_q;
  logic equal_388_s15_q;
  logic or_389_s15_q;
  logic less_396_s15_q;
  logic not_397_s15_q;
  logic equal_429_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_517_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1282_s15_q;
  logic [6:0] select_1305_s15_q;
  logic [6:0] of_near_s15_q;
  logic or_1316_s15_q;
  logic and_1319_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1328_s15_q;
  logic or_1334_s15_q;
  logic equal_1337_s15_q;
  logic and_1344_s15_q;
  logic and_1348_s15_q;
  logic and_1351_s15_q;
  logic and_1361_s15_q;
  logic and_1366_s15_q;
  logic [6:0] select_1376_s15_q;
  logic less_1420_s15_q;
  logic sum_1458_s15_q;
  logic equal_1460_s15_q;
  logic and_1597_s15_q;
  logic equal_1738_s15_q;
  logic equal_1859_s15_q;
  logic [7:0] select_2064_s15_q;
  logic [7:0] select_2066_s15_q;
  logic [16:0] select_2086_s15_q;
  logic less_2112_s15_q;
  logic less_2304_s15_q;
  logic equal_2511_s15_q;
  always_ff @(posedge clk_i) begin
    if (s14_en) begin
      pixel_0_s15_q <= pixel_0_s14_q;
      pixel_1_s15_q <= pixel_1_s14_q;
      saturated_s15_q <= saturated_s14_q;
      mask_s15_q <= mask_s14_q;
      marks_first_s15_q <= marks_first_s14_q;
      marks_last_s15_q <= marks_last_s14_q;
      sample_pair_whole_s15_q <= sample_pair_whole_s14_q;
      run_shift_s15_q <= run_shift_s14_q;
      x_s15_q <= x_s14_q;
      age_s15_q <= age_s14_q;
      slot_s15_q <= slot_s14_q;
      ends_cell_s15_q <= ends_cell_s14_q;
      lower_half_s15_q <= lower_half_s14_q;
      before_0_s15_q <= before_0_q;
      before_1_s15_q <= before_1_q;
      before_2_s15_q <= before_2_q;
      registration_slope_s15_q <= registration_slope_q[27:16];
      equal_327_s15_q <= equal_327_s14_q;
      select_333_s15_q <= select_333_s14_q;
      and_342_s15_q <= and_342_s14_q;
      equal_348_s15_q <= equal_348_s14_q;
      whole_s15_q <= whole_s14_q;
      column_s15_q <= column_s14_q;
      and_366_s15_q <= and_366_s14_q;
      and_368_s15_q <= and_368_s14_q;
      equal_371_s15_q <= equal_371_s14_q;
      so_s15_q <= so_s14_q;
      equal_388_s15_q <= equal_388_s14_q;
      or_389_s15_q <= or_389_s14_q;
      less_396_s15_q <= less_396_s14_q;
      not_397_s15_q <= not_397_s14_q;
      equal_429_s15_q <= equal_429_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_517_s15_q <= select_517_s14_q;
      of_best_s15_q <= of_best;
      select_1282_s15_q <= select_1282;
      select_1305_s15_q <= select_1305_s14_q;
      of_near_s15_q <= of_near;
      or_1316_s15_q <= select_517_s14_q | (best_left_rdata_s14_q[39:33] < of_near);
      and_1319_s15_q <= and_1319_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1328_s15_q <= select_1328_s14_q;
      or_1334_s15_q <= select_1328_s14_q | (best_right_rdata_s14_q[21:15] < of_near);
      equal_1337_s15_q <= equal_1337_s14_q;
      and_1344_s15_q <= and_1344_s14_q;
      and_1348_s15_q <= not_397_s14_q & and_1347_s14_q;
      and_1351_s15_q <= and_1351_s14_q;
      and_1361_s15_q <= not_397_s14_q & and_1360;
      and_1366_s15_q <= and_1360 & or_1365_s14_q;
      select_1376_s15_q <= select_1376_s14_q;
      less_1420_s15_q <= less_1420_s14_q;
      sum_1458_s15_q <= sum_1458[5];
      equal_1460_s15_q <= equal_1460_s14_q;
      and_1597_s15_q <= and_1597_s14_q;
      equal_1738_s15_q <= equal_1738_s14_q;
      equal_1859_s15_q <= equal_1859_s14_q;
      select_2064_s15_q <= select_2064;
      select_2066_s15_q <= select_2066;
      select_2086_s15_q <= select_2086;
      less_2112_s15_q <= less_2112_s14_q;
      less_2304_s15_q <= less_2304_s14_q;
      equal_2511_s15_q <= equal_2511_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:800
  logic equal_1285;
  assign equal_1285 = select_1282_s15_q == 3'h1;
  logic equal_1286;
  assign equal_1286 = select_1282_s15_q == 3'h2;
  logic not_1287;
  assign not_1287 = ~equal_1286;
  logic [2:0] select_1288;
  assign select_1288 = equal_1285 ? 3'h2 : {not_1287, {2{equal_1286}}};
  logic [7:0] select_1290;
  assign select_1290 = select_1288[1] ? before_2_q : (select_1288[0] ? before_2_s15_q : before_0_s15_q);
  logic [6:0] select_1306;
  assign select_1306 = select_1288[0] ? {4'h0, select_1282_s15_q} : select_1305_s15_q;
  logic [7:0] select_1307;
  assign select_1307 = select_1288[1] ? (select_1288[0] ? before_1_s15_q : before_1_q) : {1'b0, select_1306};
  // hls/stages/agreement.hpp:801
  logic [1:0] select_1310;
  assign select_1310 = equal_1285 ? 2'h0 : {not_1287, equal_1286};
  logic [7:0] select_1312;
  assign select_1312 = select_1310[1] ? before_2_q : (select_1310[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:812
  logic or_1330;
  assign or_1330 = select_1328_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:228
  logic and_1367;
  assign and_1367 = not_397_s15_q & and_1366_s15_q;
  // hls/stages/agreement.hpp:137
  logic [8:0] select_1368;
  assign select_1368 = less_396_s15_q ? 9'h0 : best_left_rdata_s15_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_389_s15_q ? {select_1368, and_1367, and_1361_s15_q, and_1351_s15_q, and_1348_s15_q, and_1344_s15_q, not_397_s15_q} : 15'h0;
  // hls/stages/agreement.hpp:243
  logic right_2;
  assign right_2 = inside_v[0] & less_1420_s15_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:137
  logic [7:0] select_2062;
  assign select_2062 = or_389_s15_q ? (less_396_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2064_s15_q} - {1'b0, select_2066_s15_q};
  // hls/stages/registration.hpp:213
  logic [13:0] select_2088;
  assign select_2088 = ($signed(10'h0) < $signed(select_2086_s15_q[16:7])) ? 14'h7f : select_2086_s15_q[13:0];

  logic [7:0] pixel_0_s16_q;
  logic [7:0] pixel_1_s16_q;
  logic saturated_s16_q;
  logic mask_s16_q;
  logic marks_first_s16_q;
  logic marks_last_s16_q;
  logic sample_pair_whole_s16_q;
  logic [5:0] run_shift_s16_q;
  logic [7:0] x_s16_q;
  logic age_s16_q;
  logic [2:0] slot_s16_q;
  logic ends_cell_s16_q;
  logic lower_half_s16_q;
  logic [11:0] registration_slope_s16_q;
  logic equal_327_s16_q;
  logic [8:0] select_333_s16_q;
  logic and_342_s16_q;
  logic equal_348_s16_q;
  logic whole_s16_q;
  logic [6:0] column_s16_q;
  logic and_366_s16_q;
  logic and_368_s16_q;
  logic equal_371_s16_q;
  logic so_s16_q;
  logic equal_429_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1277_s16_q;
  logic [2:0] select_1282_s16_q;
  logic [7:0] select_1308_s16_q;
  logic [7:0] select_1312_s16_q;
  logic [6:0] select_1317_s16_q;
  logic [5:0] select_1318_s16_q;
  logic and_1319_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1330_s16_q;
  logic [6:0] select_1335_s16_q;
  logic [6:0] select_1336_s16_q;
  logic equal_1337_s16_q;
  logic [13:0] inside_v_s16_q;
  logic [6:0] select_1376_s16_q;
  logic and_1379_s16_q;
  logic right_2_s16_q;
  logic sum_1458_s16_q;
  logic equal_1460_s16_q;
  logic textured_s16_q;
  logic and_1597_s16_q;
  logic equal_1738_s16_q;
  logic equal_1859_s16_q;
  logic [7:0] select_2062_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2068_s16_q;
  logic [7:0] xor_2073_s16_q;
  logic [13:0] select_2088_s16_q;
  logic and_2113_s16_q;
  logic less_2118_s16_q;
  logic less_2304_s16_q;
  logic equal_2511_s16_q;
  always_ff @(posedge clk_i) begin
    if (s15_en) begin
      pixel_0_s16_q <= pixel_0_s15_q;
      pixel_1_s16_q <= pixel_1_s15_q;
      saturated_s16_q <= saturated_s15_q;
      mask_s16_q <= mask_s15_q;
      marks_first_s16_q <= marks_first_s15_q;
      marks_last_s16_q <= marks_last_s15_q;
      sample_pair_whole_s16_q <= sample_pair_whole_s15_q;
      run_shift_s16_q <= run_shift_s15_q;
      x_s16_q <= x_s15_q;
      age_s16_q <= age_s15_q;
      slot_s16_q <= slot_s15_q;
      ends_cell_s16_q <= ends_cell_s15_q;
      lower_half_s16_q <= lower_half_s15_q;
      registration_slope_s16_q <= registration_slope_s15_q;
      equal_327_s16_q <= equal_327_s15_q;
      select_333_s16_q <= select_333_s15_q;
      and_342_s16_q <= and_342_s15_q;
      equal_348_s16_q <= equal_348_s15_q;
      whole_s16_q <= whole_s15_q;
      column_s16_q <= column_s15_q;
      and_366_s16_q <= and_366_s15_q;
      and_368_s16_q <= and_368_s15_q;
      equal_371_s16_q <= equal_371_s15_q;
      so_s16_q <= so_s15_q;
      equal_429_s16_q <= equal_429_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1277_s16_q <= select_517_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1282_s16_q <= select_1282_s15_q;
      select_1308_s16_q <= select_1288[2] ? select_1290 : select_1307;
      select_1312_s16_q <= select_1312;
      select_1317_s16_q <= or_1316_s15_q ? of_near_s15_q : best_left_rdata_s15_q[39:33];
      select_1318_s16_q <= or_1316_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      and_1319_s16_q <= and_1319_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1330_s16_q <= or_1330;
      select_1335_s16_q <= or_1334_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1336_s16_q <= or_1334_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1337_s16_q <= equal_1337_s15_q;
      inside_v_s16_q <= {inside_v[14:3], inside_v[1:0]};
      select_1376_s16_q <= select_1376_s15_q;
      and_1379_s16_q <= equal_388_s15_q & inside_v[4];
      right_2_s16_q <= right_2;
      sum_1458_s16_q <= sum_1458_s15_q;
      equal_1460_s16_q <= equal_1460_s15_q;
      textured_s16_q <= textured;
      and_1597_s16_q <= and_1597_s15_q;
      equal_1738_s16_q <= equal_1738_s15_q;
      equal_1859_s16_q <= equal_1859_s15_q;
      select_2062_s16_q <= select_2062;
      rise_s16_q <= rise[8];
      select_2068_s16_q <= rise[8] ? select_2064_s15_q : select_2066_s15_q;
      xor_2073_s16_q <= rise[7:0] ^ {8{rise[8]}};
      select_2088_s16_q <= select_2088;
      and_2113_s16_q <= inside_v[4] & less_2112_s15_q;
      less_2118_s16_q <= select_2064_s15_q < select_2066_s15_q;
      less_2304_s16_q <= less_2304_s15_q;
      equal_2511_s16_q <= equal_2511_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:119
  logic and_343;
  assign and_343 = sample_pair_whole_s16_q & and_342_s16_q;
  // hls/stages/agreement.hpp:970
  logic not_1338;
  assign not_1338 = ~equal_1337_s16_q;
  // hls/stages/agreement.hpp:392
  logic and_1370;
  assign and_1370 = ends_cell_s16_q & inside_v_s16_q[0];
  logic and_1372;
  assign and_1372 = not_1338 & (so_s16_q & and_1370);
  // hls/stages/agreement.hpp:1012
  logic or_1461;
  assign or_1461 = (~sum_1458_s16_q) | equal_1460_s16_q;
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2069;
  assign difference_2069 = {1'b0, select_2062_s16_q} - {1'b0, select_2068_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2069[8] ? 8'h0 : difference_2069[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2073_s16_q};
  // hls/stages/registration.hpp:208
  logic [9:0] select_2089;
  assign select_2089 = inside_v_s16_q[9] ? select_2088_s16_q[9:0] : 10'h0;
  logic [8:0] difference_2091;
  assign difference_2091 = select_2089[9:1] - (inside_v_s16_q[10] ? select_2088_s16_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:206
  logic [12:0] sum_2094;
  assign sum_2094 = (inside_v_s16_q[5] ? select_2088_s16_q[13:1] : 13'h0) + (inside_v_s16_q[6] ? select_2088_s16_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:207
  logic [11:0] select_2095;
  assign select_2095 = inside_v_s16_q[7] ? select_2088_s16_q[11:0] : 12'h0;
  logic [10:0] sum_2097;
  assign sum_2097 = select_2095[11:1] + (inside_v_s16_q[8] ? select_2088_s16_q[10:0] : 11'h0);

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_333_s16_q;
  logic averager_memory_re;
  assign averager_memory_re = s16_en & and_343;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1303; read in stage 16, written in stage 17: 16 < 17 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s16_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s16_en & and_1372;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1329; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s16_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s16_en & and_1372;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  logic [7:0] pixel_0_s17_q;
  logic [7:0] pixel_1_s17_q;
  logic saturated_s17_q;
  logic mask_s17_q;
  logic marks_first_s17_q;
  logic marks_last_s17_q;
  logic sample_pair_whole_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic [2:0] slot_s17_q;
  logic ends_cell_s17_q;
  logic lower_half_s17_q;
  logic [11:0] registration_slope_s17_q;
  logic equal_327_s17_q;
  logic [8:0] select_333_s17_q;
  logic and_342_s17_q;
  logic and_343_s17_q;
  logic equal_348_s17_q;
  logic whole_s17_q;
  logic [6:0] column_s17_q;
  logic and_366_s17_q;
  logic and_368_s17_q;
  logic equal_371_s17_q;
  logic so_s17_q;
  logic equal_429_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1278_s17_q;
  logic [2:0] select_1283_s17_q;
  logic [7:0] select_1284_s17_q;
  logic [7:0] select_1309_s17_q;
  logic [7:0] select_1313_s17_q;
  logic [6:0] select_1317_s17_q;
  logic [5:0] select_1318_s17_q;
  logic and_1319_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1331_s17_q;
  logic [6:0] select_1332_s17_q;
  logic [6:0] select_1335_s17_q;
  logic [6:0] select_1336_s17_q;
  logic equal_1337_s17_q;
  logic not_1338_s17_q;
  logic [13:0] inside_v_s17_q;
  logic and_1372_s17_q;
  logic [6:0] select_1376_s17_q;
  logic and_1381_s17_q;
  logic right_2_s17_q;
  logic sum_1458_s17_q;
  logic and_1464_s17_q;
  logic textured_s17_q;
  logic and_1598_s17_q;
  logic equal_1738_s17_q;
  logic equal_1859_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] size_3_s17_q;
  logic select_2089_s17_q;
  logic [8:0] difference_2091_s17_q;
  logic [11:0] sum_2094_s17_q;
  logic select_2095_s17_q;
  logic [10:0] sum_2097_s17_q;
  logic and_2113_s17_q;
  logic less_2118_s17_q;
  logic less_2304_s17_q;
  logic select_2347_s17_q;
  logic equal_2511_s17_q;
  always_ff @(posedge clk_i) begin
    if (s16_en) begin
      pixel_0_s17_q <= pixel_0_s16_q;
      pixel_1_s17_q <= pixel_1_s16_q;
      saturated_s17_q <= saturated_s16_q;
      mask_s17_q <= mask_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      sample_pair_whole_s17_q <= sample_pair_whole_s16_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      slot_s17_q <= slot_s16_q;
      ends_cell_s17_q <= ends_cell_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      registration_slope_s17_q <= registration_slope_s16_q;
      equal_327_s17_q <= equal_327_s16_q;
      select_333_s17_q <= select_333_s16_q;
      and_342_s17_q <= and_342_s16_q;
      and_343_s17_q <= and_343;
      equal_348_s17_q <= equal_348_s16_q;
      whole_s17_q <= whole_s16_q;
      column_s17_q <= column_s16_q;
      and_366_s17_q <= and_366_s16_q;
      and_368_s17_q <= and_368_s16_q;
      equal_371_s17_q <= equal_371_s16_q;
      so_s17_q <= so_s16_q;
      equal_429_s17_q <= equal_429_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1278_s17_q <= or_1277_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1283_s17_q <= or_1277_s16_q ? select_1282_s16_q : best_left_rdata_s16_q[8:6];
      select_1284_s17_q <= or_1277_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1309_s17_q <= or_1277_s16_q ? select_1308_s16_q : best_left_rdata_s16_q[24:17];
      select_1313_s17_q <= or_1277_s16_q ? select_1312_s16_q : best_left_rdata_s16_q[32:25];
      select_1317_s17_q <= select_1317_s16_q;
      select_1318_s17_q <= select_1318_s16_q;
      and_1319_s17_q <= and_1319_s16_q;
      right_s17_q <= right_s16_q;
      select_1331_s17_q <= or_1330_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1332_s17_q <= or_1330_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1335_s17_q <= select_1335_s16_q;
      select_1336_s17_q <= select_1336_s16_q;
      equal_1337_s17_q <= equal_1337_s16_q;
      not_1338_s17_q <= not_1338;
      inside_v_s17_q <= inside_v_s16_q;
      and_1372_s17_q <= and_1372;
      select_1376_s17_q <= select_1376_s16_q;
      and_1381_s17_q <= not_1338 & (so_s16_q ? and_1370 : and_1379_s16_q);
      right_2_s17_q <= right_2_s16_q;
      sum_1458_s17_q <= sum_1458_s16_q;
      and_1464_s17_q <= so_s16_q & (ends_cell_s16_q & (inside_v_s16_q[0] & or_1461));
      textured_s17_q <= textured_s16_q;
      and_1598_s17_q <= not_1338 & and_1597_s16_q;
      equal_1738_s17_q <= equal_1738_s16_q;
      equal_1859_s17_q <= equal_1859_s16_q;
      wide_s17_q <= wide;
      size_3_s17_q <= size_3;
      select_2089_s17_q <= select_2089[0];
      difference_2091_s17_q <= difference_2091;
      sum_2094_s17_q <= sum_2094[12:1];
      select_2095_s17_q <= select_2095[0];
      sum_2097_s17_q <= sum_2097;
      and_2113_s17_q <= and_2113_s16_q;
      less_2118_s17_q <= less_2118_s16_q;
      less_2304_s17_q <= less_2304_s16_q;
      select_2347_s17_q <= sum_1458_s16_q ? (equal_1460_s16_q & or_1461) : or_1461;
      equal_2511_s17_q <= equal_2511_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic segment_starts_q;
  // hls/stages/census.hpp:112
  logic [13:0] select_346;
  assign select_346 = equal_327_s17_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_352;
  assign sum_352 = {6'h0, sample_pair_pixel_1_q} + (equal_327_s17_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:394
  logic all_of_skin;
  assign all_of_skin = equal_327_s17_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/agreement.hpp:186
  logic not_1377;
  assign not_1377 = ~so_s17_q;
  // hls/stages/agreement.hpp:392
  logic and_1378;
  assign and_1378 = not_1377 & inside_v_s17_q[4];
  // hls/stages/agreement.hpp:255
  logic select_1651;
  assign select_1651 = sample_pair_whole_s17_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2076;
  assign select_2076 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2076;
  // hls/stages/registration.hpp:209
  logic [11:0] sum_2098;
  assign sum_2098 = sum_2094_s17_q + {sum_2097_s17_q, select_2095_s17_q};
  logic [9:0] sum_2099;
  assign sum_2099 = {difference_2091_s17_q, select_2089_s17_q} + sum_2098[11:2];
  // hls/stages/agreement.hpp:190
  logic or_2345;
  assign or_2345 = segment_starts_q | not_1377;
  // hls/stages/agreement.hpp:392
  logic select_2349;
  assign select_2349 = ends_cell_s17_q ? (inside_v_s17_q[0] ? select_2347_s17_q : or_2345) : or_2345;

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1319_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1318_s17_q, select_1317_s17_q, select_1313_s17_q, select_1309_s17_q, select_1284_s17_q, select_1283_s17_q, select_1278_s17_q};
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
  assign best_right_we = s17_en & and_1319_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1336_s17_q, select_1335_s17_q, select_1332_s17_q, select_1331_s17_q};
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
  assign shown_right_waddr = select_1376_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1381_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1378, not_1377};
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
      sample_of_skin_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      segment_starts_q <= 1'b1;
    end else if (s17_en) begin
      sample_pair_pixel_0_q <= pixel_0_s17_q;
      sample_pair_pixel_1_q <= pixel_1_s17_q;
      sample_of_skin_q <= mask_s17_q;
      averager_running_of_skin_q <= select_1651;
      segment_starts_q <= equal_1337_s17_q ? or_2345 : (so_s17_q ? select_2349 : or_2345);
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
      averager_running_0_q <= sample_pair_whole_s17_q ? select_346 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s17_q ? sum_352 : averager_running_1_q;
    end
  end

  logic saturated_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic sample_pair_whole_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic [2:0] slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic [11:0] registration_slope_s18_q;
  logic [8:0] select_333_s18_q;
  logic and_342_s18_q;
  logic and_343_s18_q;
  logic [29:0] averager_memory_rdata_s18_q;
  logic [13:0] select_346_s18_q;
  logic equal_348_s18_q;
  logic [13:0] sum_352_s18_q;
  logic whole_s18_q;
  logic all_of_skin_s18_q;
  logic [6:0] column_s18_q;
  logic and_366_s18_q;
  logic and_368_s18_q;
  logic equal_371_s18_q;
  logic so_s18_q;
  logic equal_429_s18_q;
  logic equal_1337_s18_q;
  logic not_1338_s18_q;
  logic [13:0] inside_v_s18_q;
  logic and_1372_s18_q;
  logic [1:0] shown_right_rdata_s18_q;
  logic right_2_s18_q;
  logic sum_1458_s18_q;
  logic and_1464_s18_q;
  logic textured_s18_q;
  logic [17:0] seen_columns_rdata_s18_q;
  logic and_1598_s18_q;
  logic equal_1738_s18_q;
  logic equal_1859_s18_q;
  logic less_2060_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2078_s18_q;
  logic [7:0] sum_2099_s18_q;
  logic and_2113_s18_q;
  logic less_2118_s18_q;
  logic less_2304_s18_q;
  logic equal_2511_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      saturated_s18_q <= saturated_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      slot_s18_q <= slot_s17_q;
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      registration_slope_s18_q <= registration_slope_s17_q;
      select_333_s18_q <= select_333_s17_q;
      and_342_s18_q <= and_342_s17_q;
      and_343_s18_q <= and_343_s17_q;
      averager_memory_rdata_s18_q <= averager_memory_rdata_q;
      select_346_s18_q <= select_346;
      equal_348_s18_q <= equal_348_s17_q;
      sum_352_s18_q <= sum_352;
      whole_s18_q <= whole_s17_q;
      all_of_skin_s18_q <= all_of_skin;
      column_s18_q <= column_s17_q;
      and_366_s18_q <= and_366_s17_q;
      and_368_s18_q <= and_368_s17_q;
      equal_371_s18_q <= equal_371_s17_q;
      so_s18_q <= so_s17_q;
      equal_429_s18_q <= equal_429_s17_q;
      equal_1337_s18_q <= equal_1337_s17_q;
      not_1338_s18_q <= not_1338_s17_q;
      inside_v_s18_q <= inside_v_s17_q;
      and_1372_s18_q <= and_1372_s17_q;
      shown_right_rdata_s18_q <= shown_right_rdata_q;
      right_2_s18_q <= right_2_s17_q;
      sum_1458_s18_q <= sum_1458_s17_q;
      and_1464_s18_q <= and_1464_s17_q;
      textured_s18_q <= textured_s17_q;
      seen_columns_rdata_s18_q <= seen_columns_rdata_q;
      and_1598_s18_q <= and_1598_s17_q;
      equal_1738_s18_q <= equal_1738_s17_q;
      equal_1859_s18_q <= equal_1859_s17_q;
      less_2060_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2078_s18_q <= ~wide_s17_q;
      sum_2099_s18_q <= sum_2099[9:2];
      and_2113_s18_q <= and_2113_s17_q;
      less_2118_s18_q <= less_2118_s17_q;
      less_2304_s18_q <= less_2304_s17_q;
      equal_2511_s18_q <= equal_2511_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic [9:0] registration_displacement_over_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic segment_started_q;
  // hls/stages/census.hpp:121
  logic [13:0] sum_350;
  assign sum_350 = select_346_s18_q + (equal_348_s18_q ? 14'h0 : averager_memory_rdata_s18_q[13:0]);
  logic [13:0] sum_354;
  assign sum_354 = sum_352_s18_q + (equal_348_s18_q ? 14'h0 : averager_memory_rdata_s18_q[27:14]);
  // hls/stages/census.hpp:122
  logic and_358;
  assign and_358 = whole_s18_q & (averager_memory_rdata_s18_q[28] | equal_348_s18_q);
  // hls/stages/census.hpp:123
  logic and_362;
  assign and_362 = all_of_skin_s18_q & (averager_memory_rdata_s18_q[29] | equal_348_s18_q);
  // hls/stages/agreement.hpp:190
  logic [7:0] select_1445;
  assign select_1445 = so_s18_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1004
  logic or_1448;
  assign or_1448 = select_1445[7] | (~({select_1445[5], select_1445[3], select_1445[1]} == 3'h0));
  // hls/stages/agreement.hpp:243
  logic explained;
  assign explained = inside_v_s18_q[0] & inside_v_s18_q[3];
  logic and_1478;
  assign and_1478 = inside_v_s18_q[0] & ({inside_v_s18_q[4], inside_v_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:975
  logic select_1486;
  assign select_1486 = slot_s18_q[2] ? shown_shown_q : inside_v_s18_q[3];
  // hls/stages/agreement.hpp:243
  logic shown;
  assign shown = inside_v_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1486);
  // hls/stages/agreement.hpp:975
  logic select_1489;
  assign select_1489 = slot_s18_q[2] ? shown_nearer_q : inside_v_s18_q[4];
  // hls/stages/agreement.hpp:243
  logic near;
  assign near = inside_v_s18_q[0] & (select_1486 ? select_1489 : shown_right_rdata_s18_q[1]);
  // hls/stages/agreement.hpp:988
  logic [7:0] select_1539;
  assign select_1539 = inside_v_s18_q[0] ? (sum_1458_s18_q ? select_1445 : {select_1445[6:0], 1'b0}) : select_1445;
  // hls/stages/agreement.hpp:1004
  logic or_1542;
  assign or_1542 = select_1539[7] | (~({select_1539[5], select_1539[3], select_1539[1]} == 3'h0));
  // hls/stages/agreement.hpp:988
  logic and_2002;
  assign and_2002 = seen_columns_rdata_s18_q[7] & inside_v_s18_q[0];
  logic and_2003;
  assign and_2003 = seen_columns_rdata_s18_q[2] & inside_v_s18_q[0];
  // hls/stages/registration.hpp:37
  logic not_2071;
  assign not_2071 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2060_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2071};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2079;
  assign select_2079 = registration_displacement_over_q[9] ? wide_s18_q : not_2078_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2060_s18_q ? {taken_s18_q, 1'b1} : {not_2071, select_2079, not_2071};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2081;
  assign sum_2081 = {left, 1'b1} + {taken_2, less_2060_s18_q};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2100;
  assign sum_2100 = {registration_slope_s18_q[11], registration_slope_s18_q} + {{5{sum_2099_s18_q[7]}}, sum_2099_s18_q};
  // hls/stages/agreement.hpp:392
  logic select_2301;
  assign select_2301 = equal_1337_s18_q ? shown_shown_q : (so_s18_q ? select_1486 : shown_shown_q);
  logic select_2303;
  assign select_2303 = equal_1337_s18_q ? shown_nearer_q : (so_s18_q ? select_1489 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2305;
  assign sum_2305 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2314;
  assign select_2314 = equal_1337_s18_q ? select_1445 : (so_s18_q ? (ends_cell_s18_q ? select_1539 : select_1445) : 8'h1);
  // hls/stages/agreement.hpp:436
  logic [8:0] select_2328;
  assign select_2328 = equal_429_s18_q ? {difference_2326[7], difference_2326} : (less_2304_s18_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:495
  logic [8:0] select_2330;
  assign select_2330 = and_368_s18_q ? (equal_1859_s18_q ? select_2328 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_2332;
  assign select_2332 = equal_429_s18_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:495
  logic [7:0] select_2334;
  assign select_2334 = and_368_s18_q ? (equal_1859_s18_q ? select_2332 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_2336;
  assign select_2336 = sum_2305[7] ? {1'b1, sum_2305[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

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
  assign census_memory_re = s18_en & and_368_s18_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_displacement_over_q <= 10'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
      segment_started_q <= 1'b0;
    end else if (s18_en) begin
      registration_displacement_over_q <= so_s18_q ? sum_2081[10:1] : registration_displacement_over_q;
      shown_shown_q <= select_2301;
      shown_nearer_q <= select_2303;
      region_columns_q <= select_2314;
      region_down_rest_q <= select_2330;
      region_down_back_q <= select_2334;
      region_down_next_q <= select_2336;
      segment_started_q <= ~segment_starts_q;
    end
  end

  logic [7:0] pixel_0_s19_q;
  logic [7:0] pixel_1_s19_q;
  logic saturated_s19_q;
  logic mask_s19_q;
  logic marks_first_s19_q;
  logic marks_last_s19_q;
  logic sample_pair_whole_s19_q;
  logic [7:0] x_s19_q;
  logic age_s19_q;
  logic [2:0] slot_s19_q;
  logic ends_cell_s19_q;
  logic lower_half_s19_q;
  logic registration_displacement_over_s19_q;
  logic segment_started_s19_q;
  logic [8:0] select_333_s19_q;
  logic and_342_s19_q;
  logic and_343_s19_q;
  logic [13:0] sum_350_s19_q;
  logic [13:0] sum_354_s19_q;
  logic and_358_s19_q;
  logic and_362_s19_q;
  logic [6:0] column_s19_q;
  logic and_366_s19_q;
  logic and_368_s19_q;
  logic equal_371_s19_q;
  logic so_s19_q;
  logic equal_429_s19_q;
  logic equal_1337_s19_q;
  logic not_1338_s19_q;
  logic [11:0] inside_v_s19_q;
  logic and_1372_s19_q;
  logic equal_1382_s19_q;
  logic right_2_s19_q;
  logic or_1448_s19_q;
  logic or_1451_s19_q;
  logic or_1454_s19_q;
  logic and_1464_s19_q;
  logic textured_s19_q;
  logic explained_s19_q;
  logic and_1478_s19_q;
  logic [12:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_1524_s19_q;
  logic and_1526_s19_q;
  logic or_1542_s19_q;
  logic or_1545_s19_q;
  logic or_1548_s19_q;
  logic and_1559_s19_q;
  logic and_1561_s19_q;
  logic and_1562_s19_q;
  logic and_1575_s19_q;
  logic and_1577_s19_q;
  logic and_1578_s19_q;
  logic and_1598_s19_q;
  logic equal_1738_s19_q;
  logic equal_1859_s19_q;
  logic and_2000_s19_q;
  logic and_2001_s19_q;
  logic [1:0] sum_2005_s19_q;
  logic [7:0] sum_2100_s19_q;
  logic less_2101_s19_q;
  logic less_2102_s19_q;
  logic and_2113_s19_q;
  logic less_2118_s19_q;
  logic less_2304_s19_q;
  logic sum_2305_s19_q;
  logic and_2501_s19_q;
  logic equal_2511_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      pixel_0_s19_q <= sample_pair_pixel_0_q;
      pixel_1_s19_q <= sample_pair_pixel_1_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= sample_of_skin_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
      sample_pair_whole_s19_q <= sample_pair_whole_s18_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      slot_s19_q <= slot_s18_q;
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      registration_displacement_over_s19_q <= registration_displacement_over_q[9];
      segment_started_s19_q <= segment_started_q;
      select_333_s19_q <= select_333_s18_q;
      and_342_s19_q <= and_342_s18_q;
      and_343_s19_q <= and_343_s18_q;
      sum_350_s19_q <= sum_350;
      sum_354_s19_q <= sum_354;
      and_358_s19_q <= and_358;
      and_362_s19_q <= and_362;
      column_s19_q <= column_s18_q;
      and_366_s19_q <= and_366_s18_q;
      and_368_s19_q <= and_368_s18_q;
      equal_371_s19_q <= equal_371_s18_q;
      so_s19_q <= so_s18_q;
      equal_429_s19_q <= equal_429_s18_q;
      equal_1337_s19_q <= equal_1337_s18_q;
      not_1338_s19_q <= not_1338_s18_q;
      inside_v_s19_q <= {inside_v_s18_q[13:5], inside_v_s18_q[2:0]};
      and_1372_s19_q <= and_1372_s18_q;
      equal_1382_s19_q <= x_s18_q[6:4] == 3'h7;
      right_2_s19_q <= right_2_s18_q;
      or_1448_s19_q <= or_1448;
      or_1451_s19_q <= select_1445[7] | (~({select_1445[6], select_1445[3:2]} == 3'h0));
      or_1454_s19_q <= select_1445[7] | (~(select_1445[6:4] == 3'h0));
      and_1464_s19_q <= and_1464_s18_q;
      textured_s19_q <= textured_s18_q;
      explained_s19_q <= explained;
      and_1478_s19_q <= and_1478;
      seen_columns_rdata_s19_q <= {seen_columns_rdata_s18_q[13:7], seen_columns_rdata_s18_q[5:0]};
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_1524_s19_q <= seen_columns_rdata_s18_q[14] & inside_v_s18_q[0];
      and_1526_s19_q <= seen_columns_rdata_s18_q[5] & inside_v_s18_q[0];
      or_1542_s19_q <= or_1542;
      or_1545_s19_q <= select_1539[7] | (~({select_1539[6], select_1539[3:2]} == 3'h0));
      or_1548_s19_q <= select_1539[7] | (~(select_1539[6:4] == 3'h0));
      and_1559_s19_q <= seen_columns_rdata_s18_q[16] & inside_v_s18_q[0];
      and_1561_s19_q <= seen_columns_rdata_s18_q[8] & inside_v_s18_q[0];
      and_1562_s19_q <= seen_columns_rdata_s18_q[3] & inside_v_s18_q[0];
      and_1575_s19_q <= seen_columns_rdata_s18_q[17] & inside_v_s18_q[0];
      and_1577_s19_q <= seen_columns_rdata_s18_q[9] & inside_v_s18_q[0];
      and_1578_s19_q <= seen_columns_rdata_s18_q[4] & inside_v_s18_q[0];
      and_1598_s19_q <= and_1598_s18_q;
      equal_1738_s19_q <= equal_1738_s18_q;
      equal_1859_s19_q <= equal_1859_s18_q;
      and_2000_s19_q <= seen_columns_rdata_s18_q[15] & inside_v_s18_q[0];
      and_2001_s19_q <= seen_columns_rdata_s18_q[11] & inside_v_s18_q[0];
      sum_2005_s19_q <= {1'b0, and_2002} + ({1'b0, explained} + {1'b0, and_2003});
      sum_2100_s19_q <= sum_2100[7:0];
      less_2101_s19_q <= $signed(6'h0) < $signed(sum_2100[12:7]);
      less_2102_s19_q <= $signed(sum_2100[12:7]) < $signed(6'h3f);
      and_2113_s19_q <= and_2113_s18_q;
      less_2118_s19_q <= less_2118_s18_q;
      less_2304_s19_q <= less_2304_s18_q;
      sum_2305_s19_q <= sum_2305[7];
      and_2501_s19_q <= seen_columns_rdata_s18_q[6] & inside_v_s18_q[0];
      equal_2511_s19_q <= equal_2511_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [7:0] registration_slope_here_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic region_fresh_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_342_s19_q ? sum_350_s19_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_371_s19_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_342_s19_q ? sum_354_s19_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_371_s19_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_379;
  assign and_379 = and_342_s19_q & and_358_s19_q;
  // hls/stages/census.hpp:126
  logic select_381;
  assign select_381 = equal_371_s19_q ? and_379 : (averager_mask_q & and_379);
  // hls/stages/agreement.hpp:255
  logic whole_2;
  assign whole_2 = sample_pair_whole_s19_q & select_381;
  // hls/stages/census.hpp:206
  logic and_383;
  assign and_383 = and_342_s19_q & and_362_s19_q;
  // hls/stages/census.hpp:126
  logic select_385;
  assign select_385 = equal_371_s19_q ? and_383 : (averager_of_skin_q & and_383);
  // hls/stages/agreement.hpp:392
  logic [5:0] select_1455;
  assign select_1455 = equal_1337_s19_q ? x_s19_q[5:0] : {region_row_q, or_1454_s19_q, or_1451_s19_q, or_1448_s19_q};
  // hls/stages/agreement.hpp:1082
  logic not_1456;
  assign not_1456 = ~equal_1382_s19_q;
  // hls/stages/agreement.hpp:243
  logic and_1485;
  assign and_1485 = inside_v_s19_q[0] & inside_v_s19_q[2];
  // hls/stages/agreement.hpp:988
  logic and_1527;
  assign and_1527 = seen_columns_rdata_s19_q[0] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_1529;
  assign sum_1529 = {1'b0, and_1526_s19_q} + ({1'b0, textured_s19_q} + {1'b0, and_1527});
  // hls/stages/agreement.hpp:988
  logic and_1560;
  assign and_1560 = seen_columns_rdata_s19_q[11] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1043
  logic [1:0] sum_1564;
  assign sum_1564 = {1'b0, and_1561_s19_q} + ({1'b0, shown_s19_q} + {1'b0, and_1562_s19_q});
  // hls/stages/agreement.hpp:988
  logic and_1576;
  assign and_1576 = seen_columns_rdata_s19_q[12] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1044
  logic [1:0] sum_1580;
  assign sum_1580 = {1'b0, and_1577_s19_q} + ({1'b0, near_s19_q} + {1'b0, and_1578_s19_q});
  // hls/stages/agreement.hpp:255
  logic [10:0] select_1630;
  assign select_1630 = sample_pair_whole_s19_q ? (and_366_s19_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1632;
  assign select_1632 = sample_pair_whole_s19_q ? (and_366_s19_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_1653;
  assign select_1653 = sample_pair_whole_s19_q ? (and_366_s19_q ? select_381 : averager_mask_q) : averager_mask_q;
  logic select_1655;
  assign select_1655 = sample_pair_whole_s19_q ? (and_366_s19_q ? select_385 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:392
  logic and_1979;
  assign and_1979 = so_s19_q & (ends_cell_s19_q & (inside_v_s19_q[0] & inside_v_s19_q[1]));
  // hls/stages/agreement.hpp:1059
  logic not_1999;
  assign not_1999 = ~(x_s19_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1042
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2000_s19_q} + ({2'h0, and_2001_s19_q} + {1'b0, sum_2005_s19_q});
  // hls/stages/agreement.hpp:392
  logic and_2040;
  assign and_2040 = ends_cell_s19_q & (inside_v_s19_q[0] & (inside_v_s19_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:1064
  logic and_2046;
  assign and_2046 = not_1999 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:238
  logic [4:0] select_2083;
  assign select_2083 = so_s19_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_s19_q} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:83
  logic equal_2084;
  assign equal_2084 = slot_s19_q == 3'h7;
  // hls/stages/registration.hpp:213
  logic [7:0] select_2104;
  assign select_2104 = less_2101_s19_q ? 8'h7f : (less_2102_s19_q ? 8'h80 : sum_2100_s19_q);
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2106;
  assign select_2106 = so_s19_q ? (equal_2084 ? registration_slope_here_q : select_2104) : registration_slope_here_q;
  // hls/stages/registration.hpp:206
  logic [6:0] select_2122;
  assign select_2122 = inside_v_s19_q[3] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_2123;
  assign select_2123 = inside_v_s19_q[4] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2124;
  assign sum_2124 = {{2{select_2122[6]}}, select_2122} + {select_2123[7], select_2123};
  // hls/stages/registration.hpp:207
  logic [7:0] select_2125;
  assign select_2125 = inside_v_s19_q[5] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2126;
  assign select_2126 = inside_v_s19_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2127;
  assign sum_2127 = {{2{select_2125[7]}}, select_2125[7:1]} + {select_2126[7], select_2126};
  // hls/stages/registration.hpp:208
  logic [7:0] select_2129;
  assign select_2129 = inside_v_s19_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2130;
  assign select_2130 = inside_v_s19_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_2131;
  assign difference_2131 = {{2{select_2129[7]}}, select_2129[7:1]} - {select_2130[7], select_2130};
  // hls/stages/agreement.hpp:436
  logic [2:0] select_2307;
  assign select_2307 = less_2304_s19_q ? (sum_2305_s19_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2309;
  assign select_2309 = equal_1859_s19_q ? (equal_429_s19_q ? 3'h0 : select_2307) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2305_s19_q;
  // hls/stages/agreement.hpp:436
  logic select_2340;
  assign select_2340 = equal_1859_s19_q ? (equal_429_s19_q | (less_2304_s19_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1154
  logic equal_2358;
  assign equal_2358 = x_s19_q[6:3] == 4'h7;
  logic equal_2382;
  assign equal_2382 = x_s19_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1079
  logic [7:0] select_2395;
  assign select_2395 = (x_s19_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2397;
  assign select_2397 = equal_2382 ? cfg_unproven_skin_limit_i : (equal_2358 ? cfg_unproven_limit_i : select_2395);
  // hls/stages/agreement.hpp:392
  logic select_2499;
  assign select_2499 = so_s19_q ? (ends_cell_s19_q ? and_1526_s19_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2503;
  assign select_2503 = so_s19_q ? (ends_cell_s19_q ? and_2501_s19_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_2505;
  assign select_2505 = ends_cell_s19_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2507;
  assign select_2507 = equal_1337_s19_q ? centres_values_1_textured_q : (so_s19_q ? select_2505 : centres_values_1_textured_q);
  logic select_2508;
  assign select_2508 = ends_cell_s19_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2510;
  assign select_2510 = equal_1337_s19_q ? centres_values_1_of_skin_q : (so_s19_q ? select_2508 : centres_values_1_of_skin_q);

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1322; read in stage 19, written in stage 22: 19 < 22 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1455;
  logic regions_re;
  assign regions_re = s19_en & (equal_1337_s19_q ? (x_s19_q[6] & not_1456) : and_1464_s19_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_333_s19_q;
  logic averager_memory_we;
  assign averager_memory_we = s19_en & and_343_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_362_s19_q, and_358_s19_q, sum_354_s19_q, sum_350_s19_q};
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

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s19_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s19_en & and_1372_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q, near_s19_q, shown_s19_q, explained_s19_q, and_1485, textured_s19_q};
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
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s19_en) begin
      averager_mask_q <= select_1653;
      averager_of_skin_q <= select_1655;
      registration_displacement_fraction_q <= select_2083;
      registration_slope_here_q <= equal_1337_s19_q ? registration_slope_here_q : select_2106;
      region_row_q <= and_368_s19_q ? select_2309 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_368_s19_q ? select_2340 : region_fresh_q;
      centres_values_0_textured_q <= equal_1337_s19_q ? centres_values_0_textured_q : select_2499;
      centres_values_0_of_skin_q <= equal_1337_s19_q ? centres_values_0_of_skin_q : select_2503;
      centres_values_1_textured_q <= select_2507;
      centres_values_1_of_skin_q <= select_2510;
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
      averager_total_0_q <= select_1630;
      averager_total_1_q <= select_1632;
    end
  end

  logic [7:0] pixel_0_s20_q;
  logic [7:0] pixel_1_s20_q;
  logic saturated_s20_q;
  logic mask_s20_q;
  logic marks_first_s20_q;
  logic marks_last_s20_q;
  logic sample_pair_whole_s20_q;
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic [2:0] slot_s20_q;
  logic ends_cell_s20_q;
  logic lower_half_s20_q;
  logic [2:0] region_row_s20_q;
  logic region_fresh_s20_q;
  logic segment_started_s20_q;
  logic centres_values_1_textured_s20_q;
  logic centres_values_1_of_skin_s20_q;
  logic [6:0] column_s20_q;
  logic and_366_s20_q;
  logic and_368_s20_q;
  logic [77:0] census_memory_rdata_s20_q;
  logic [8:0] grey_s20_q;
  logic equal_371_s20_q;
  logic [8:0] select_374_s20_q;
  logic [8:0] grey_2_s20_q;
  logic [8:0] select_378_s20_q;
  logic whole_2_s20_q;
  logic and_386_s20_q;
  logic so_s20_q;
  logic equal_429_s20_q;
  logic equal_1337_s20_q;
  logic not_1338_s20_q;
  logic [1:0] inside_v_s20_q;
  logic equal_1382_s20_q;
  logic right_2_s20_q;
  logic or_1448_s20_q;
  logic or_1451_s20_q;
  logic or_1454_s20_q;
  logic not_1456_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1478_s20_q;
  logic and_1483_s20_q;
  logic and_1524_s20_q;
  logic and_1525_s20_q;
  logic [1:0] sum_1529_s20_q;
  logic or_1542_s20_q;
  logic or_1545_s20_q;
  logic or_1548_s20_q;
  logic and_1559_s20_q;
  logic [2:0] sum_1565_s20_q;
  logic and_1575_s20_q;
  logic [2:0] sum_1581_s20_q;
  logic and_1598_s20_q;
  logic equal_1738_s20_q;
  logic equal_1859_s20_q;
  logic and_1980_s20_q;
  logic not_1999_s20_q;
  logic [2:0] explained_2_s20_q;
  logic and_2042_s20_q;
  logic and_2049_s20_q;
  logic equal_2084_s20_q;
  logic and_2113_s20_q;
  logic or_2116_s20_q;
  logic [1:0] sum_2117_s20_q;
  logic less_2118_s20_q;
  logic [7:0] sum_2124_s20_q;
  logic select_2125_s20_q;
  logic [8:0] sum_2127_s20_q;
  logic select_2129_s20_q;
  logic [8:0] difference_2131_s20_q;
  logic equal_2358_s20_q;
  logic equal_2381_s20_q;
  logic equal_2382_s20_q;
  logic [7:0] select_2397_s20_q;
  logic equal_2511_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      pixel_0_s20_q <= pixel_0_s19_q;
      pixel_1_s20_q <= pixel_1_s19_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= mask_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      sample_pair_whole_s20_q <= sample_pair_whole_s19_q;
      x_s20_q <= x_s19_q;
      age_s20_q <= age_s19_q;
      slot_s20_q <= slot_s19_q;
      ends_cell_s20_q <= ends_cell_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      region_row_s20_q <= region_row_q;
      region_fresh_s20_q <= region_fresh_q;
      segment_started_s20_q <= segment_started_s19_q;
      centres_values_1_textured_s20_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s20_q <= centres_values_1_of_skin_q;
      column_s20_q <= column_s19_q;
      and_366_s20_q <= and_366_s19_q;
      and_368_s20_q <= and_368_s19_q;
      census_memory_rdata_s20_q <= census_memory_rdata_q;
      grey_s20_q <= grey;
      equal_371_s20_q <= equal_371_s19_q;
      select_374_s20_q <= sample_pair_whole_s19_q ? total[10:2] : 9'h0;
      grey_2_s20_q <= grey_2;
      select_378_s20_q <= sample_pair_whole_s19_q ? total_2[10:2] : 9'h0;
      whole_2_s20_q <= whole_2;
      and_386_s20_q <= sample_pair_whole_s19_q & select_385;
      so_s20_q <= so_s19_q;
      equal_429_s20_q <= equal_429_s19_q;
      equal_1337_s20_q <= equal_1337_s19_q;
      not_1338_s20_q <= not_1338_s19_q;
      inside_v_s20_q <= {inside_v_s19_q[9], inside_v_s19_q[0]};
      equal_1382_s20_q <= equal_1382_s19_q;
      right_2_s20_q <= right_2_s19_q;
      or_1448_s20_q <= or_1448_s19_q;
      or_1451_s20_q <= or_1451_s19_q;
      or_1454_s20_q <= or_1454_s19_q;
      not_1456_s20_q <= not_1456;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained_s19_q;
      and_1478_s20_q <= and_1478_s19_q;
      and_1483_s20_q <= not_1338_s19_q & and_1464_s19_q;
      and_1524_s20_q <= and_1524_s19_q;
      and_1525_s20_q <= seen_columns_rdata_s19_q[9] & inside_v_s19_q[0];
      sum_1529_s20_q <= sum_1529;
      or_1542_s20_q <= or_1542_s19_q;
      or_1545_s20_q <= or_1545_s19_q;
      or_1548_s20_q <= or_1548_s19_q;
      and_1559_s20_q <= and_1559_s19_q;
      sum_1565_s20_q <= {2'h0, and_1560} + {1'b0, sum_1564};
      and_1575_s20_q <= and_1575_s19_q;
      sum_1581_s20_q <= {2'h0, and_1576} + {1'b0, sum_1580};
      and_1598_s20_q <= and_1598_s19_q;
      equal_1738_s20_q <= equal_1738_s19_q;
      equal_1859_s20_q <= equal_1859_s19_q;
      and_1980_s20_q <= not_1338_s19_q & and_1979;
      not_1999_s20_q <= not_1999;
      explained_2_s20_q <= explained_2;
      and_2042_s20_q <= not_1338_s19_q & (so_s19_q & and_2040);
      and_2049_s20_q <= not_1338_s19_q & (so_s19_q & (ends_cell_s19_q & and_2046));
      equal_2084_s20_q <= equal_2084;
      and_2113_s20_q <= and_2113_s19_q;
      or_2116_s20_q <= (inside_v_s19_q[11:9] == 3'h0) | (inside_v_s19_q[11:9] == 3'h4);
      sum_2117_s20_q <= inside_v_s19_q[11:10] + 2'h3;
      less_2118_s20_q <= less_2118_s19_q;
      sum_2124_s20_q <= sum_2124[8:1];
      select_2125_s20_q <= select_2125[0];
      sum_2127_s20_q <= sum_2127;
      select_2129_s20_q <= select_2129[0];
      difference_2131_s20_q <= difference_2131;
      equal_2358_s20_q <= equal_2358;
      equal_2381_s20_q <= x_s19_q[6:3] == 4'h9;
      equal_2382_s20_q <= equal_2382;
      select_2397_s20_q <= select_2397;
      equal_2511_s20_q <= equal_2511_s19_q;
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
  logic less_402;
  assign less_402 = census_memory_rdata_s20_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_403;
  assign less_403 = census_memory_rdata_s20_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_404;
  assign less_404 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_405;
  assign less_405 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_406;
  assign less_406 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_407;
  assign less_407 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_408;
  assign less_408 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_409;
  assign less_409 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_410;
  assign less_410 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_411;
  assign less_411 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_412;
  assign less_412 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_413;
  assign less_413 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_414;
  assign less_414 = census_memory_rdata_s20_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_415;
  assign less_415 = census_memory_rdata_s20_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_416;
  assign less_416 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_417;
  assign less_417 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_418;
  assign less_418 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_419;
  assign less_419 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_420;
  assign less_420 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_421;
  assign less_421 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_422;
  assign less_422 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_423;
  assign less_423 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_424;
  assign less_424 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_425;
  assign less_425 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:431
  logic equal_426;
  assign equal_426 = column_s20_q == 7'h0;
  logic [3:0] select_430;
  assign select_430 = equal_429_s20_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:432
  logic [4:0] select_431;
  assign select_431 = equal_426 ? {select_430, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_432;
  assign select_432 = equal_426 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:286
  logic and_435;
  assign and_435 = census_memory_rdata_s20_q[38] & (census_memory_rdata_s20_q[18] & whole_2_s20_q);
  logic and_437;
  assign and_437 = census_memory_rdata_s20_q[77] & (census_memory_rdata_s20_q[58] & and_435);
  // hls/stages/census.hpp:270
  logic [9:0] difference_460;
  assign difference_460 = {1'b0, select_374_s20_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_463;
  assign difference_463 = {1'b0, census_memory_rdata_s20_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_467;
  assign difference_467 = {1'b0, census_memory_rdata_s20_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_471;
  assign difference_471 = {1'b0, census_memory_rdata_s20_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_475;
  assign difference_475 = {1'b0, census_memory_rdata_s20_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s20_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1041
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1524_s20_q} + ({2'h0, and_1525_s20_q} + {1'b0, sum_1529_s20_q});
  // hls/stages/agreement.hpp:1043
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1559_s20_q} + sum_1565_s20_q;
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_1567;
  assign select_1567 = age_s20_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1044
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1575_s20_q} + sum_1581_s20_q;
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_1583;
  assign select_1583 = age_s20_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:255
  logic [8:0] select_1622;
  assign select_1622 = sample_pair_whole_s20_q ? (and_366_s20_q ? grey_s20_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1624;
  assign select_1624 = sample_pair_whole_s20_q ? (and_366_s20_q ? grey_2_s20_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1626;
  assign select_1626 = sample_pair_whole_s20_q ? (and_366_s20_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1628;
  assign select_1628 = sample_pair_whole_s20_q ? (and_366_s20_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_1633;
  assign sum_1633 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s20_q};
  logic [9:0] sum_1641;
  assign sum_1641 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s20_q};
  // hls/stages/agreement.hpp:495
  logic [8:0] select_1656;
  assign select_1656 = and_368_s20_q ? select_374_s20_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1657;
  assign select_1657 = and_368_s20_q ? select_378_s20_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1659;
  assign select_1659 = and_368_s20_q ? census_memory_rdata_s20_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1660;
  assign select_1660 = and_368_s20_q ? census_memory_rdata_s20_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1661;
  assign select_1661 = and_368_s20_q ? census_memory_rdata_s20_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1662;
  assign select_1662 = and_368_s20_q ? census_memory_rdata_s20_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1663;
  assign select_1663 = and_368_s20_q ? census_memory_rdata_s20_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1664;
  assign select_1664 = and_368_s20_q ? census_memory_rdata_s20_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1665;
  assign select_1665 = and_368_s20_q ? census_memory_rdata_s20_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1666;
  assign select_1666 = and_368_s20_q ? census_memory_rdata_s20_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1667;
  assign select_1667 = and_368_s20_q ? census_memory_rdata_s20_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1668;
  assign select_1668 = and_368_s20_q ? census_memory_rdata_s20_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1669;
  assign select_1669 = and_368_s20_q ? census_memory_rdata_s20_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1670;
  assign select_1670 = and_368_s20_q ? census_memory_rdata_s20_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1671;
  assign select_1671 = and_368_s20_q ? census_memory_rdata_s20_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1672;
  assign select_1672 = and_368_s20_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1673;
  assign select_1673 = and_368_s20_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1675;
  assign select_1675 = and_368_s20_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1676;
  assign select_1676 = and_368_s20_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1678;
  assign select_1678 = and_368_s20_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1679;
  assign select_1679 = and_368_s20_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1681;
  assign select_1681 = and_368_s20_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1682;
  assign select_1682 = and_368_s20_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1683;
  assign select_1683 = and_368_s20_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1685;
  assign select_1685 = and_368_s20_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1686;
  assign select_1686 = and_368_s20_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1688;
  assign select_1688 = and_368_s20_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1689;
  assign select_1689 = and_368_s20_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1691;
  assign select_1691 = and_368_s20_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1692;
  assign select_1692 = and_368_s20_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1694;
  assign select_1694 = and_368_s20_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1695;
  assign select_1695 = and_368_s20_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1697;
  assign select_1697 = and_368_s20_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1698;
  assign select_1698 = and_368_s20_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1700;
  assign select_1700 = and_368_s20_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1701;
  assign select_1701 = and_368_s20_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1704;
  assign select_1704 = and_368_s20_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1705;
  assign select_1705 = and_368_s20_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1708;
  assign select_1708 = and_368_s20_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1709;
  assign select_1709 = and_368_s20_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_1713;
  assign difference_1713 = {1'b0, select_378_s20_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1716;
  assign difference_1716 = {1'b0, census_memory_rdata_s20_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1720;
  assign difference_1720 = {1'b0, census_memory_rdata_s20_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1724;
  assign difference_1724 = {1'b0, census_memory_rdata_s20_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1728;
  assign difference_1728 = {1'b0, census_memory_rdata_s20_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_1758;
  assign difference_1758 = {1'b0, select_374_s20_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1769;
  assign difference_1769 = {1'b0, select_378_s20_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:495
  logic and_1976;
  assign and_1976 = and_368_s20_q & (equal_429_s20_q & equal_1859_s20_q);
  // hls/stages/agreement.hpp:392
  logic and_1985;
  assign and_1985 = not_1338_s20_q & (so_s20_q & (ends_cell_s20_q & textured_s20_q));
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2008;
  assign select_2008 = age_s20_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2044;
  assign select_2044 = and_1976 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2042_s20_q});
  logic [13:0] select_2051;
  assign select_2051 = and_1976 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2049_s20_q});
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2119;
  assign difference_2119 = {sum_2117_s20_q, inside_v_s20_q[1], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2120;
  assign select_2120 = less_2118_s20_q ? difference_2119 : {sum_2117_s20_q, inside_v_s20_q[1], registration_displacement_fraction_q};
  logic [7:0] select_2121;
  assign select_2121 = or_2116_s20_q ? {sum_2117_s20_q, inside_v_s20_q[1], 5'h0} : select_2120;
  // hls/stages/registration.hpp:209
  logic [10:0] sum_2128;
  assign sum_2128 = {{3{sum_2124_s20_q[7]}}, sum_2124_s20_q} + {sum_2127_s20_q[8], sum_2127_s20_q, select_2125_s20_q};
  logic [9:0] sum_2132;
  assign sum_2132 = {difference_2131_s20_q, select_2129_s20_q} + {sum_2128[10], sum_2128[10:2]};
  // hls/stages/agreement.hpp:1160
  logic equal_2359;
  assign equal_2359 = x_s20_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1154
  logic equal_2379;
  assign equal_2379 = x_s20_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1079
  logic [7:0] limit;
  assign limit = equal_2379 ? cfg_regions_limit_i : (equal_2381_s20_q ? cfg_hidden_limit_i : select_2397_s20_q);
  // hls/stages/agreement.hpp:1167
  logic not_2400;
  assign not_2400 = ~x_s20_q[2];
  logic [3:0] select_2401;
  assign select_2401 = x_s20_q[1] ? {x_s20_q[2], 1'b0, not_2400, 1'b0} : {1'b0, x_s20_q[2], 1'b0, not_2400};
  logic [7:0] select_2402;
  assign select_2402 = x_s20_q[0] ? {select_2401[3], 1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0], 1'b0} : {1'b0, select_2401[3], 1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0]};
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2406;
  assign select_2406 = equal_2381_s20_q ? counts_skin_supervised_q : (equal_2382_s20_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2379 ? counts_textured_q : select_2406;
  // hls/stages/agreement.hpp:392
  logic [2:0] select_2444;
  assign select_2444 = ends_cell_s20_q ? explained_2_s20_q : box_explained_columns_values_0_q;
  logic [2:0] select_2446;
  assign select_2446 = equal_1337_s20_q ? box_explained_columns_values_0_q : (so_s20_q ? select_2444 : box_explained_columns_values_0_q);
  logic [2:0] select_2447;
  assign select_2447 = ends_cell_s20_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2449;
  assign select_2449 = equal_1337_s20_q ? box_explained_columns_values_1_q : (so_s20_q ? select_2447 : box_explained_columns_values_1_q);
  logic [2:0] select_2450;
  assign select_2450 = ends_cell_s20_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2452;
  assign select_2452 = equal_1337_s20_q ? box_explained_columns_values_2_q : (so_s20_q ? select_2450 : box_explained_columns_values_2_q);
  logic [2:0] select_2453;
  assign select_2453 = ends_cell_s20_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2455;
  assign select_2455 = equal_1337_s20_q ? box_explained_columns_values_3_q : (so_s20_q ? select_2453 : box_explained_columns_values_3_q);
  logic [2:0] select_2456;
  assign select_2456 = ends_cell_s20_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2458;
  assign select_2458 = equal_1337_s20_q ? box_explained_columns_values_4_q : (so_s20_q ? select_2456 : box_explained_columns_values_4_q);
  logic [2:0] select_2463;
  assign select_2463 = so_s20_q ? (ends_cell_s20_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2465;
  assign select_2465 = ends_cell_s20_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2467;
  assign select_2467 = equal_1337_s20_q ? box_shown_columns_values_1_q : (so_s20_q ? select_2465 : box_shown_columns_values_1_q);
  logic [2:0] select_2468;
  assign select_2468 = ends_cell_s20_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2470;
  assign select_2470 = equal_1337_s20_q ? box_shown_columns_values_2_q : (so_s20_q ? select_2468 : box_shown_columns_values_2_q);
  logic [2:0] select_2471;
  assign select_2471 = ends_cell_s20_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2473;
  assign select_2473 = equal_1337_s20_q ? box_shown_columns_values_3_q : (so_s20_q ? select_2471 : box_shown_columns_values_3_q);
  logic [2:0] select_2474;
  assign select_2474 = ends_cell_s20_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2476;
  assign select_2476 = equal_1337_s20_q ? box_shown_columns_values_4_q : (so_s20_q ? select_2474 : box_shown_columns_values_4_q);
  logic [2:0] select_2481;
  assign select_2481 = so_s20_q ? (ends_cell_s20_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2483;
  assign select_2483 = ends_cell_s20_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2485;
  assign select_2485 = equal_1337_s20_q ? box_nearer_columns_values_1_q : (so_s20_q ? select_2483 : box_nearer_columns_values_1_q);
  logic [2:0] select_2486;
  assign select_2486 = ends_cell_s20_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2488;
  assign select_2488 = equal_1337_s20_q ? box_nearer_columns_values_2_q : (so_s20_q ? select_2486 : box_nearer_columns_values_2_q);
  logic [2:0] select_2489;
  assign select_2489 = ends_cell_s20_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2491;
  assign select_2491 = equal_1337_s20_q ? box_nearer_columns_values_3_q : (so_s20_q ? select_2489 : box_nearer_columns_values_3_q);
  logic [2:0] select_2492;
  assign select_2492 = ends_cell_s20_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2494;
  assign select_2494 = equal_1337_s20_q ? box_nearer_columns_values_4_q : (so_s20_q ? select_2492 : box_nearer_columns_values_4_q);

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s20_q;
  logic census_memory_we;
  assign census_memory_we = s20_en & and_368_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s20_q[58:40], census_memory_rdata_s20_q[38:0], and_386_s20_q, whole_2_s20_q, select_378_s20_q, select_374_s20_q};
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
    end else if (s20_en) begin
      census_filled_q <= and_368_s20_q ? {select_432[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_368_s20_q ? select_431 : rows_passed_above_q;
      counts_textured_q <= and_1976 ? 14'h0 : (counts_textured_q + {13'h0, and_1985});
      counts_skin_supervised_q <= select_2044;
      counts_skin_textured_q <= select_2051;
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
      averager_quarter_1_0_q <= select_1622;
      averager_quarter_1_1_q <= select_1624;
      averager_quarter_2_0_q <= select_1626;
      averager_quarter_2_1_q <= select_1628;
      census_columns_values_0_cell_0_left_q <= select_1656;
      census_columns_values_0_cell_0_right_q <= select_1657;
      census_columns_values_0_cell_1_left_q <= select_1659;
      census_columns_values_0_cell_1_right_q <= select_1660;
      census_columns_values_0_cell_1_mask_q <= select_1661;
      census_columns_values_0_cell_2_left_q <= select_1662;
      census_columns_values_0_cell_2_right_q <= select_1663;
      census_columns_values_0_cell_2_mask_q <= select_1664;
      census_columns_values_0_cell_2_of_skin_q <= select_1665;
      census_columns_values_0_cell_3_left_q <= select_1666;
      census_columns_values_0_cell_3_right_q <= select_1667;
      census_columns_values_0_cell_3_mask_q <= select_1668;
      census_columns_values_0_cell_4_left_q <= select_1669;
      census_columns_values_0_cell_4_right_q <= select_1670;
      census_columns_values_0_cell_4_mask_q <= select_1671;
      census_columns_values_1_cell_0_left_q <= select_1672;
      census_columns_values_1_cell_0_right_q <= select_1673;
      census_columns_values_1_cell_1_left_q <= select_1675;
      census_columns_values_1_cell_1_right_q <= select_1676;
      census_columns_values_1_cell_2_left_q <= select_1678;
      census_columns_values_1_cell_2_right_q <= select_1679;
      census_columns_values_1_cell_2_of_skin_q <= select_1681;
      census_columns_values_1_cell_3_left_q <= select_1682;
      census_columns_values_1_cell_3_right_q <= select_1683;
      census_columns_values_1_cell_4_left_q <= select_1685;
      census_columns_values_1_cell_4_right_q <= select_1686;
      census_columns_values_2_cell_0_left_q <= select_1688;
      census_columns_values_2_cell_0_right_q <= select_1689;
      census_columns_values_2_cell_1_left_q <= select_1691;
      census_columns_values_2_cell_1_right_q <= select_1692;
      census_columns_values_2_cell_2_left_q <= select_1694;
      census_columns_values_2_cell_2_right_q <= select_1695;
      census_columns_values_2_cell_3_left_q <= select_1697;
      census_columns_values_2_cell_3_right_q <= select_1698;
      census_columns_values_2_cell_4_left_q <= select_1700;
      census_columns_values_2_cell_4_right_q <= select_1701;
      census_columns_values_3_cell_1_left_q <= select_1704;
      census_columns_values_3_cell_1_right_q <= select_1705;
      census_columns_values_3_cell_3_left_q <= select_1708;
      census_columns_values_3_cell_3_right_q <= select_1709;
      sharpness_last_mean_0_q <= and_368_s20_q ? select_374_s20_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_368_s20_q ? select_378_s20_q : sharpness_last_mean_1_q;
      box_explained_columns_values_0_q <= select_2446;
      box_explained_columns_values_1_q <= select_2449;
      box_explained_columns_values_2_q <= select_2452;
      box_explained_columns_values_3_q <= select_2455;
      box_explained_columns_values_4_q <= select_2458;
      box_shown_columns_values_0_q <= equal_1337_s20_q ? box_shown_columns_values_0_q : select_2463;
      box_shown_columns_values_1_q <= select_2467;
      box_shown_columns_values_2_q <= select_2470;
      box_shown_columns_values_3_q <= select_2473;
      box_shown_columns_values_4_q <= select_2476;
      box_nearer_columns_values_0_q <= equal_1337_s20_q ? box_nearer_columns_values_0_q : select_2481;
      box_nearer_columns_values_1_q <= select_2485;
      box_nearer_columns_values_2_q <= select_2488;
      box_nearer_columns_values_3_q <= select_2491;
      box_nearer_columns_values_4_q <= select_2494;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
  logic mask_s21_q;
  logic marks_first_s21_q;
  logic marks_last_s21_q;
  logic sample_pair_whole_s21_q;
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
  logic [2:0] region_row_s21_q;
  logic region_fresh_s21_q;
  logic segment_started_s21_q;
  logic centres_values_1_textured_s21_q;
  logic centres_values_1_of_skin_s21_q;
  logic [6:0] column_s21_q;
  logic and_366_s21_q;
  logic and_368_s21_q;
  logic equal_371_s21_q;
  logic whole_2_s21_q;
  logic so_s21_q;
  logic less_402_s21_q;
  logic less_403_s21_q;
  logic less_404_s21_q;
  logic less_405_s21_q;
  logic less_406_s21_q;
  logic less_407_s21_q;
  logic less_408_s21_q;
  logic less_409_s21_q;
  logic less_410_s21_q;
  logic less_411_s21_q;
  logic less_412_s21_q;
  logic less_413_s21_q;
  logic less_414_s21_q;
  logic less_415_s21_q;
  logic less_416_s21_q;
  logic less_417_s21_q;
  logic less_418_s21_q;
  logic less_419_s21_q;
  logic less_420_s21_q;
  logic less_421_s21_q;
  logic less_422_s21_q;
  logic less_423_s21_q;
  logic less_424_s21_q;
  logic less_425_s21_q;
  logic and_433_s21_q;
  logic and_437_s21_q;
  logic difference_460_s21_q;
  logic [8:0] xor_461_s21_q;
  logic difference_463_s21_q;
  logic [8:0] xor_464_s21_q;
  logic difference_467_s21_q;
  logic [8:0] xor_468_s21_q;
  logic difference_471_s21_q;
  logic [8:0] xor_472_s21_q;
  logic difference_475_s21_q;
  logic [8:0] xor_476_s21_q;
  logic equal_1337_s21_q;
  logic not_1338_s21_q;
  logic inside_v_s21_q;
  logic equal_1382_s21_q;
  logic all_s21_q;
  logic equal_1396_s21_q;
  logic equal_1398_s21_q;
  logic equal_1400_s21_q;
  logic equal_1402_s21_q;
  logic right_2_s21_q;
  logic or_1448_s21_q;
  logic or_1451_s21_q;
  logic or_1454_s21_q;
  logic not_1456_s21_q;
  logic [29:0] regions_rdata_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1478_s21_q;
  logic and_1483_s21_q;
  logic [2:0] textured_2_s21_q;
  logic equal_1534_s21_q;
  logic or_1542_s21_q;
  logic or_1545_s21_q;
  logic or_1548_s21_q;
  logic [3:0] difference_1568_s21_q;
  logic [3:0] difference_1584_s21_q;
  logic and_1598_s21_q;
  logic sum_1633_s21_q;
  logic [9:0] difference_1634_s21_q;
  logic sum_1641_s21_q;
  logic [9:0] difference_1642_s21_q;
  logic difference_1713_s21_q;
  logic [8:0] xor_1714_s21_q;
  logic difference_1716_s21_q;
  logic [8:0] xor_1717_s21_q;
  logic difference_1720_s21_q;
  logic [8:0] xor_1721_s21_q;
  logic difference_1724_s21_q;
  logic [8:0] xor_1725_s21_q;
  logic difference_1728_s21_q;
  logic [8:0] xor_1729_s21_q;
  logic equal_1738_s21_q;
  logic difference_1758_s21_q;
  logic [8:0] xor_1759_s21_q;
  logic difference_1769_s21_q;
  logic [8:0] xor_1770_s21_q;
  logic equal_1859_s21_q;
  logic and_1976_s21_q;
  logic and_1980_s21_q;
  logic and_1985_s21_q;
  logic not_1999_s21_q;
  logic [3:0] difference_2009_s21_q;
  logic equal_2084_s21_q;
  logic and_2113_s21_q;
  logic [7:0] select_2121_s21_q;
  logic sum_2128_s21_q;
  logic [9:0] sum_2132_s21_q;
  logic equal_2359_s21_q;
  logic and_2360_s21_q;
  logic equal_2379_s21_q;
  logic equal_2381_s21_q;
  logic equal_2382_s21_q;
  logic equal_2404_s21_q;
  logic [13:0] of_s21_q;
  logic equal_2511_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= mask_s20_q;
      marks_first_s21_q <= marks_first_s20_q;
      marks_last_s21_q <= marks_last_s20_q;
      sample_pair_whole_s21_q <= sample_pair_whole_s20_q;
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
      region_row_s21_q <= region_row_s20_q;
      region_fresh_s21_q <= region_fresh_s20_q;
      segment_started_s21_q <= segment_started_s20_q;
      centres_values_1_textured_s21_q <= centres_values_1_textured_s20_q;
      centres_values_1_of_skin_s21_q <= centres_values_1_of_skin_s20_q;
      column_s21_q <= column_s20_q;
      and_366_s21_q <= and_366_s20_q;
      and_368_s21_q <= and_368_s20_q;
      equal_371_s21_q <= equal_371_s20_q;
      whole_2_s21_q <= whole_2_s20_q;
      so_s21_q <= so_s20_q;
      less_402_s21_q <= less_402;
      less_403_s21_q <= less_403;
      less_404_s21_q <= less_404;
      less_405_s21_q <= less_405;
      less_406_s21_q <= less_406;
      less_407_s21_q <= less_407;
      less_408_s21_q <= less_408;
      less_409_s21_q <= less_409;
      less_410_s21_q <= less_410;
      less_411_s21_q <= less_411;
      less_412_s21_q <= less_412;
      less_413_s21_q <= less_413;
      less_414_s21_q <= less_414;
      less_415_s21_q <= less_415;
      less_416_s21_q <= less_416;
      less_417_s21_q <= less_417;
      less_418_s21_q <= less_418;
      less_419_s21_q <= less_419;
      less_420_s21_q <= less_420;
      less_421_s21_q <= less_421;
      less_422_s21_q <= less_422;
      less_423_s21_q <= less_423;
      less_424_s21_q <= less_424;
      less_425_s21_q <= less_425;
      and_433_s21_q <= select_431[4] & select_432[3];
      and_437_s21_q <= and_437;
      difference_460_s21_q <= difference_460[9];
      xor_461_s21_q <= difference_460[8:0] ^ {9{difference_460[9]}};
      difference_463_s21_q <= difference_463[9];
      xor_464_s21_q <= difference_463[8:0] ^ {9{difference_463[9]}};
      difference_467_s21_q <= difference_467[9];
      xor_468_s21_q <= difference_467[8:0] ^ {9{difference_467[9]}};
      difference_471_s21_q <= difference_471[9];
      xor_472_s21_q <= difference_471[8:0] ^ {9{difference_471[9]}};
      difference_475_s21_q <= difference_475[9];
      xor_476_s21_q <= difference_475[8:0] ^ {9{difference_475[9]}};
      equal_1337_s21_q <= equal_1337_s20_q;
      not_1338_s21_q <= not_1338_s20_q;
      inside_v_s21_q <= inside_v_s20_q[0];
      equal_1382_s21_q <= equal_1382_s20_q;
      all_s21_q <= all;
      equal_1396_s21_q <= x_s20_q[5:0] == 6'h3b;
      equal_1398_s21_q <= x_s20_q[5:0] == 6'h36;
      equal_1400_s21_q <= x_s20_q[5:0] == 6'h35;
      equal_1402_s21_q <= x_s20_q[5:0] == 6'h34;
      right_2_s21_q <= right_2_s20_q;
      or_1448_s21_q <= or_1448_s20_q;
      or_1451_s21_q <= or_1451_s20_q;
      or_1454_s21_q <= or_1454_s20_q;
      not_1456_s21_q <= not_1456_s20_q;
      regions_rdata_s21_q <= regions_rdata_q;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1478_s21_q <= and_1478_s20_q;
      and_1483_s21_q <= and_1483_s20_q;
      textured_2_s21_q <= textured_2;
      equal_1534_s21_q <= x_s20_q == 8'h0;
      or_1542_s21_q <= or_1542_s20_q;
      or_1545_s21_q <= or_1545_s20_q;
      or_1548_s21_q <= or_1548_s20_q;
      difference_1568_s21_q <= {1'b0, shown_2} - {1'b0, select_1567};
      difference_1584_s21_q <= {1'b0, near_2} - {1'b0, select_1583};
      and_1598_s21_q <= and_1598_s20_q;
      sum_1633_s21_q <= sum_1633[0];
      difference_1634_s21_q <= {1'b0, sum_1633[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1641_s21_q <= sum_1641[0];
      difference_1642_s21_q <= {1'b0, sum_1641[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1713_s21_q <= difference_1713[9];
      xor_1714_s21_q <= difference_1713[8:0] ^ {9{difference_1713[9]}};
      difference_1716_s21_q <= difference_1716[9];
      xor_1717_s21_q <= difference_1716[8:0] ^ {9{difference_1716[9]}};
      difference_1720_s21_q <= difference_1720[9];
      xor_1721_s21_q <= difference_1720[8:0] ^ {9{difference_1720[9]}};
      difference_1724_s21_q <= difference_1724[9];
      xor_1725_s21_q <= difference_1724[8:0] ^ {9{difference_1724[9]}};
      difference_1728_s21_q <= difference_1728[9];
      xor_1729_s21_q <= difference_1728[8:0] ^ {9{difference_1728[9]}};
      equal_1738_s21_q <= equal_1738_s20_q;
      difference_1758_s21_q <= difference_1758[9];
      xor_1759_s21_q <= difference_1758[8:0] ^ {9{difference_1758[9]}};
      difference_1769_s21_q <= difference_1769[9];
      xor_1770_s21_q <= difference_1769[8:0] ^ {9{difference_1769[9]}};
      equal_1859_s21_q <= equal_1859_s20_q;
      and_1976_s21_q <= and_1976;
      and_1980_s21_q <= and_1980_s20_q;
      and_1985_s21_q <= and_1985;
      not_1999_s21_q <= not_1999_s20_q;
      difference_2009_s21_q <= {1'b0, explained_2_s20_q} - {1'b0, select_2008};
      equal_2084_s21_q <= equal_2084_s20_q;
      and_2113_s21_q <= and_2113_s20_q;
      select_2121_s21_q <= select_2121;
      sum_2128_s21_q <= sum_2128[1];
      sum_2132_s21_q <= sum_2132;
      equal_2359_s21_q <= equal_2359;
      and_2360_s21_q <= equal_2358_s20_q & equal_2359;
      equal_2379_s21_q <= equal_2379;
      equal_2381_s21_q <= equal_2381_s20_q;
      equal_2382_s21_q <= equal_2382_s20_q;
      equal_2404_s21_q <= (limit & select_2402) == 8'h0;
      of_s21_q <= of;
      equal_2511_s21_q <= equal_2511_s20_q;
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
  logic registration_of_right_q;
  logic registration_was_inside_q;
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
  logic [13:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/agreement.hpp:432
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_437_s21_q;
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
  logic [9:0] sum_462;
  assign sum_462 = {9'h0, difference_460_s21_q} + {1'b0, xor_461_s21_q};
  logic [9:0] sum_465;
  assign sum_465 = {9'h0, difference_463_s21_q} + {1'b0, xor_464_s21_q};
  // hls/stages/agreement.hpp:1122
  logic [1:0] quarter;
  assign quarter = x_s21_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1083
  logic [1:0] select_1385;
  assign select_1385 = x_s21_q[4] ? {x_s21_q[3], x_s21_q[0]} : {x_s21_q[0], x_s21_q[3]};
  // hls/stages/agreement.hpp:1095
  logic [3:0] select_1387;
  assign select_1387 = equal_1382_s21_q ? {2'h0, quarter} : (all_s21_q ? {1'b0, x_s21_q[2:0]} : {x_s21_q[2:1], select_1385});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1388;
  assign sum_1388 = slot_s21_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_1389;
  assign select_1389 = equal_1337_s21_q ? select_1387 : {sum_1388, lower_half_s21_q, registration_of_right_q};
  // hls/stages/agreement.hpp:1120
  logic equal_1390;
  assign equal_1390 = x_s21_q[5:0] == 6'h3e;
  logic equal_1392;
  assign equal_1392 = x_s21_q[5:0] == 6'h3d;
  logic equal_1394;
  assign equal_1394 = x_s21_q[5:0] == 6'h3c;
  // hls/stages/agreement.hpp:1122
  logic and_1405;
  assign and_1405 = (~equal_1398_s21_q) & ((~equal_1400_s21_q) & (~equal_1402_s21_q));
  logic and_1408;
  assign and_1408 = (~equal_1392) & ((~equal_1394) & ((~equal_1396_s21_q) & and_1405));
  // hls/stages/agreement.hpp:1083
  logic less_1410;
  assign less_1410 = x_s21_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all_s21_q ? {1'b0, x_s21_q[2]} : x_s21_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_1414;
  assign or_1414 = (kind == 2'h3) | (x_s21_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1095
  logic select_1417;
  assign select_1417 = equal_1382_s21_q ? ((~equal_1390) & and_1408) : (less_1410 & (~or_1414));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s21_q ? (right_2_s21_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1425;
  assign sum_1425 = {2'h0, slot_s21_q} + 5'h1f;
  // hls/stages/registration.hpp:253
  logic not_1431;
  assign not_1431 = ~lower_half_s21_q;
  logic [3:0] select_1432;
  assign select_1432 = registration_of_right_q ? {lower_half_s21_q, 1'b0, not_1431, 1'b0} : {1'b0, lower_half_s21_q, 1'b0, not_1431};
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1468;
  assign select_1468 = segment_started_s21_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:882
  logic [6:0] sum_1469;
  assign sum_1469 = {6'h0, textured_s21_q} + select_1468;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_1471;
  assign sum_1471 = {3'h0, sum_1469} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[9:0]);
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1473;
  assign select_1473 = segment_started_s21_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:882
  logic [6:0] sum_1474;
  assign sum_1474 = {6'h0, explained_s21_q} + select_1473;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_1476;
  assign sum_1476 = {3'h0, sum_1474} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[19:10]);
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1479;
  assign select_1479 = segment_started_s21_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:883
  logic [6:0] sum_1480;
  assign sum_1480 = {6'h0, and_1478_s21_q} + select_1479;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_1482;
  assign sum_1482 = {3'h0, sum_1480} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[29:20]);
  // hls/stages/agreement.hpp:1207
  logic or_1492;
  assign or_1492 = marks_first_s21_q | line_ended_q;
  // hls/stages/agreement.hpp:1209
  logic [13:0] select_1494;
  assign select_1494 = marks_first_s21_q ? 14'h1 : (or_1492 ? {rows_passed_q[12:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1208
  logic [8:0] select_1496;
  assign select_1496 = or_1492 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1216
  logic select_1498;
  assign select_1498 = cfg_compete_i ? (or_1492 & select_1494[13]) : (select_1496[8] & select_1494[9]);
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_1532;
  assign select_1532 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1050
  logic [4:0] around;
  assign around = {difference_1568_s21_q[3], difference_1568_s21_q} + (equal_1534_s21_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1051
  logic [4:0] n;
  assign n = {difference_1584_s21_q[3], difference_1584_s21_q} + (equal_1534_s21_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:209
  logic [9:0] xor_1635;
  assign xor_1635 = {difference_1634_s21_q[8:0], sum_1633_s21_q} ^ {10{difference_1634_s21_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_1634_s21_q[9]} + {1'b0, xor_1635};
  logic [9:0] xor_1643;
  assign xor_1643 = {difference_1642_s21_q[8:0], sum_1641_s21_q} ^ {10{difference_1642_s21_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1642_s21_q[9]} + {1'b0, xor_1643};
  // hls/stages/agreement.hpp:495
  logic select_1658;
  assign select_1658 = and_368_s21_q ? whole_2_s21_q : census_columns_values_0_cell_0_mask_q;
  logic select_1674;
  assign select_1674 = and_368_s21_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1677;
  assign select_1677 = and_368_s21_q ? census_columns_values_0_cell_1_mask_s21_q : census_columns_values_1_cell_1_mask_q;
  logic select_1680;
  assign select_1680 = and_368_s21_q ? census_columns_values_0_cell_2_mask_s21_q : census_columns_values_1_cell_2_mask_q;
  logic select_1684;
  assign select_1684 = and_368_s21_q ? census_columns_values_0_cell_3_mask_s21_q : census_columns_values_1_cell_3_mask_q;
  logic select_1687;
  assign select_1687 = and_368_s21_q ? census_columns_values_0_cell_4_mask_s21_q : census_columns_values_1_cell_4_mask_q;
  logic select_1690;
  assign select_1690 = and_368_s21_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1693;
  assign select_1693 = and_368_s21_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_1715;
  assign sum_1715 = {9'h0, difference_1713_s21_q} + {1'b0, xor_1714_s21_q};
  logic [9:0] sum_1718;
  assign sum_1718 = {9'h0, difference_1716_s21_q} + {1'b0, xor_1717_s21_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1758_s21_q} + xor_1759_s21_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1769_s21_q} + xor_1770_s21_q;
  // hls/stages/agreement.hpp:392
  logic and_1990;
  assign and_1990 = not_1338_s21_q & (so_s21_q & (ends_cell_s21_q & explained_s21_q));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_1992;
  assign select_1992 = and_1976_s21_q ? 14'h0 : (counts_explained_q + {13'h0, and_1990});
  // hls/stages/agreement.hpp:392
  logic and_1995;
  assign and_1995 = not_1338_s21_q & (so_s21_q & (ends_cell_s21_q & and_1478_s21_q));
  // hls/stages/agreement.hpp:1049
  logic [4:0] e;
  assign e = {difference_2009_s21_q[3], difference_2009_s21_q} + (equal_1534_s21_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1085
  logic less_2024;
  assign less_2024 = region_row_s21_q < x_s21_q[5:3];
  // hls/stages/registration.hpp:107
  logic equal_2108;
  assign equal_2108 = slot_s21_q == 3'h4;
  // hls/stages/registration.hpp:101
  logic [11:0] value_2;
  assign value_2 = {{4{select_2121_s21_q[7]}}, select_2121_s21_q} - {sum_2132_s21_q[9], sum_2132_s21_q, sum_2128_s21_q};
  // hls/stages/agreement.hpp:392
  logic select_2179;
  assign select_2179 = so_s21_q ? (equal_2108 ? right_2_s21_q : registration_of_right_q) : registration_of_right_q;
  logic select_2182;
  assign select_2182 = so_s21_q ? (equal_2084_s21_q ? inside_v_s21_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1083
  logic [1:0] quarter_2;
  assign quarter_2 = all_s21_q ? x_s21_q[1:0] : select_1385;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2393;
  assign select_2393 = equal_2359_s21_q ? 14'h0 : product_q;
  logic [13:0] select_2408;
  assign select_2408 = equal_2404_s21_q ? 14'h0 : of_s21_q;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2393} + {1'b0, select_2408};
  // hls/stages/agreement.hpp:392
  logic [2:0] select_2426;
  assign select_2426 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_2428;
  assign select_2428 = equal_1337_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_2426 : box_textured_columns_values_0_q);
  logic [2:0] select_2429;
  assign select_2429 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2431;
  assign select_2431 = equal_1337_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_2429 : box_textured_columns_values_1_q);
  logic [2:0] select_2432;
  assign select_2432 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2434;
  assign select_2434 = equal_1337_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_2432 : box_textured_columns_values_2_q);
  logic [2:0] select_2435;
  assign select_2435 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2437;
  assign select_2437 = equal_1337_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_2435 : box_textured_columns_values_3_q);
  logic [2:0] select_2438;
  assign select_2438 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2440;
  assign select_2440 = equal_1337_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_2438 : box_textured_columns_values_4_q);
  logic [4:0] select_2460;
  assign select_2460 = so_s21_q ? (ends_cell_s21_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2461;
  assign select_2461 = equal_1337_s21_q ? box_explained_sum_sums_values_0_q : select_2460;
  logic [4:0] select_2478;
  assign select_2478 = so_s21_q ? (ends_cell_s21_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_2496;
  assign select_2496 = so_s21_q ? (ends_cell_s21_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_explained_q <= 14'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 14'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s21_en) begin
      counts_explained_q <= select_1992;
      registration_of_right_q <= equal_1337_s21_q ? registration_of_right_q : select_2179;
      registration_was_inside_q <= equal_1337_s21_q ? registration_was_inside_q : select_2182;
      segment_textured_q <= select_1468 + {6'h0, and_1985_s21_q};
      segment_explained_q <= select_1473 + {6'h0, and_1990};
      segment_nearer_q <= select_1479 + {6'h0, and_1995};
      product_q <= equal_1337_s21_q ? sum_3[14:1] : product_q;
      rows_passed_q <= select_1494;
      columns_passed_q <= {select_1496[7:0], or_1492};
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
      census_columns_values_0_cell_0_mask_q <= select_1658;
      census_columns_values_1_cell_0_mask_q <= select_1674;
      census_columns_values_1_cell_1_mask_q <= select_1677;
      census_columns_values_1_cell_2_mask_q <= select_1680;
      census_columns_values_1_cell_3_mask_q <= select_1684;
      census_columns_values_1_cell_4_mask_q <= select_1687;
      census_columns_values_2_cell_0_mask_q <= select_1690;
      census_columns_values_2_cell_1_mask_q <= select_1693;
      box_textured_columns_values_0_q <= select_2428;
      box_textured_columns_values_1_q <= select_2431;
      box_textured_columns_values_2_q <= select_2434;
      box_textured_columns_values_3_q <= select_2437;
      box_textured_columns_values_4_q <= select_2440;
      box_explained_sum_sums_values_0_q <= select_2461;
      box_shown_sum_sums_values_0_q <= equal_1337_s21_q ? box_shown_sum_sums_values_0_q : select_2478;
      box_nearer_sum_sums_values_0_q <= equal_1337_s21_q ? box_nearer_sum_sums_values_0_q : select_2496;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic sample_pair_whole_s22_q;
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
  logic [2:0] region_row_s22_q;
  logic [13:0] product_s22_q;
  logic centres_values_1_textured_s22_q;
  logic centres_values_1_of_skin_s22_q;
  logic [6:0] column_s22_q;
  logic and_366_s22_q;
  logic and_368_s22_q;
  logic equal_371_s22_q;
  logic whole_2_s22_q;
  logic so_s22_q;
  logic less_402_s22_q;
  logic less_403_s22_q;
  logic less_404_s22_q;
  logic less_405_s22_q;
  logic less_406_s22_q;
  logic less_407_s22_q;
  logic less_408_s22_q;
  logic less_409_s22_q;
  logic less_410_s22_q;
  logic less_411_s22_q;
  logic less_412_s22_q;
  logic less_413_s22_q;
  logic less_414_s22_q;
  logic less_415_s22_q;
  logic less_416_s22_q;
  logic less_417_s22_q;
  logic less_418_s22_q;
  logic less_419_s22_q;
  logic less_420_s22_q;
  logic less_421_s22_q;
  logic less_422_s22_q;
  logic less_423_s22_q;
  logic less_424_s22_q;
  logic less_425_s22_q;
  logic and_433_s22_q;
  logic whole_9_s22_q;
  logic [10:0] sum_466_s22_q;
  logic [9:0] sum_469_s22_q;
  logic [9:0] sum_473_s22_q;
  logic [9:0] sum_477_s22_q;
  logic equal_1337_s22_q;
  logic not_1338_s22_q;
  logic equal_1382_s22_q;
  logic [1:0] quarter_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1388_s22_q;
  logic [3:0] select_1389_s22_q;
  logic equal_1390_s22_q;
  logic equal_1392_s22_q;
  logic equal_1394_s22_q;
  logic equal_1396_s22_q;
  logic equal_1398_s22_q;
  logic equal_1400_s22_q;
  logic equal_1402_s22_q;
  logic less_1410_s22_q;
  logic or_1414_s22_q;
  logic select_1417_s22_q;
  logic and_1427_s22_q;
  logic [3:0] select_1432_s22_q;
  logic or_1448_s22_q;
  logic or_1451_s22_q;
  logic or_1454_s22_q;
  logic not_1456_s22_q;
  logic [9:0] sum_1471_s22_q;
  logic [9:0] sum_1476_s22_q;
  logic [9:0] sum_1482_s22_q;
  logic and_1483_s22_q;
  logic select_1498_s22_q;
  logic [3:0] difference_1533_s22_q;
  logic equal_1534_s22_q;
  logic or_1542_s22_q;
  logic or_1545_s22_q;
  logic or_1548_s22_q;
  logic [4:0] around_s22_q;
  logic less_1587_s22_q;
  logic and_1598_s22_q;
  logic [10:0] size_s22_q;
  logic [10:0] size_2_s22_q;
  logic [10:0] sum_1719_s22_q;
  logic [9:0] sum_1722_s22_q;
  logic [9:0] sum_1726_s22_q;
  logic [9:0] sum_1730_s22_q;
  logic equal_1738_s22_q;
  logic [8:0] contrast_s22_q;
  logic [8:0] contrast_2_s22_q;
  logic equal_1859_s22_q;
  logic and_1976_s22_q;
  logic and_1980_s22_q;
  logic and_1995_s22_q;
  logic not_1999_s22_q;
  logic [4:0] e_s22_q;
  logic [9:0] select_2025_s22_q;
  logic [9:0] select_2028_s22_q;
  logic equal_2084_s22_q;
  logic and_2111_s22_q;
  logic and_2113_s22_q;
  logic [11:0] select_2135_s22_q;
  logic equal_2184_s22_q;
  logic [3:0] not_2185_s22_q;
  logic [1:0] quarter_2_s22_q;
  logic equal_2359_s22_q;
  logic and_2360_s22_q;
  logic less_2361_s22_q;
  logic equal_2362_s22_q;
  logic equal_2379_s22_q;
  logic equal_2381_s22_q;
  logic equal_2382_s22_q;
  logic sum_3_s22_q;
  logic equal_2511_s22_q;
  logic [9:0] select_2604_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      sample_pair_whole_s22_q <= sample_pair_whole_s21_q;
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
      registration_of_right_s22_q <= registration_of_right_q;
      region_row_s22_q <= region_row_s21_q;
      product_s22_q <= product_q;
      centres_values_1_textured_s22_q <= centres_values_1_textured_s21_q;
      centres_values_1_of_skin_s22_q <= centres_values_1_of_skin_s21_q;
      column_s22_q <= column_s21_q;
      and_366_s22_q <= and_366_s21_q;
      and_368_s22_q <= and_368_s21_q;
      equal_371_s22_q <= equal_371_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      so_s22_q <= so_s21_q;
      less_402_s22_q <= less_402_s21_q;
      less_403_s22_q <= less_403_s21_q;
      less_404_s22_q <= less_404_s21_q;
      less_405_s22_q <= less_405_s21_q;
      less_406_s22_q <= less_406_s21_q;
      less_407_s22_q <= less_407_s21_q;
      less_408_s22_q <= less_408_s21_q;
      less_409_s22_q <= less_409_s21_q;
      less_410_s22_q <= less_410_s21_q;
      less_411_s22_q <= less_411_s21_q;
      less_412_s22_q <= less_412_s21_q;
      less_413_s22_q <= less_413_s21_q;
      less_414_s22_q <= less_414_s21_q;
      less_415_s22_q <= less_415_s21_q;
      less_416_s22_q <= less_416_s21_q;
      less_417_s22_q <= less_417_s21_q;
      less_418_s22_q <= less_418_s21_q;
      less_419_s22_q <= less_419_s21_q;
      less_420_s22_q <= less_420_s21_q;
      less_421_s22_q <= less_421_s21_q;
      less_422_s22_q <= less_422_s21_q;
      less_423_s22_q <= less_423_s21_q;
      less_424_s22_q <= less_424_s21_q;
      less_425_s22_q <= less_425_s21_q;
      and_433_s22_q <= and_433_s21_q;
      whole_9_s22_q <= whole_9;
      sum_466_s22_q <= {1'b0, sum_462} + {1'b0, sum_465};
      sum_469_s22_q <= {9'h0, difference_467_s21_q} + {1'b0, xor_468_s21_q};
      sum_473_s22_q <= {9'h0, difference_471_s21_q} + {1'b0, xor_472_s21_q};
      sum_477_s22_q <= {9'h0, difference_475_s21_q} + {1'b0, xor_476_s21_q};
      equal_1337_s22_q <= equal_1337_s21_q;
      not_1338_s22_q <= not_1338_s21_q;
      equal_1382_s22_q <= equal_1382_s21_q;
      quarter_s22_q <= quarter;
      all_s22_q <= all_s21_q;
      sum_1388_s22_q <= sum_1388;
      select_1389_s22_q <= select_1389;
      equal_1390_s22_q <= equal_1390;
      equal_1392_s22_q <= equal_1392;
      equal_1394_s22_q <= equal_1394;
      equal_1396_s22_q <= equal_1396_s21_q;
      equal_1398_s22_q <= equal_1398_s21_q;
      equal_1400_s22_q <= equal_1400_s21_q;
      equal_1402_s22_q <= equal_1402_s21_q;
      less_1410_s22_q <= less_1410;
      or_1414_s22_q <= or_1414;
      select_1417_s22_q <= select_1417;
      and_1427_s22_q <= half_ends & ({{3{sum_1425[4]}}, sum_1425} < 8'h3);
      select_1432_s22_q <= select_1432;
      or_1448_s22_q <= or_1448_s21_q;
      or_1451_s22_q <= or_1451_s21_q;
      or_1454_s22_q <= or_1454_s21_q;
      not_1456_s22_q <= not_1456_s21_q;
      sum_1471_s22_q <= sum_1471;
      sum_1476_s22_q <= sum_1476;
      sum_1482_s22_q <= sum_1482;
      and_1483_s22_q <= and_1483_s21_q;
      select_1498_s22_q <= select_1498;
      difference_1533_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1532};
      equal_1534_s22_q <= equal_1534_s21_q;
      or_1542_s22_q <= or_1542_s21_q;
      or_1545_s22_q <= or_1545_s21_q;
      or_1548_s22_q <= or_1548_s21_q;
      around_s22_q <= around;
      less_1587_s22_q <= {1'b0, around[4:1]} < n;
      and_1598_s22_q <= and_1598_s21_q;
      size_s22_q <= size;
      size_2_s22_q <= size_2;
      sum_1719_s22_q <= {1'b0, sum_1715} + {1'b0, sum_1718};
      sum_1722_s22_q <= {9'h0, difference_1720_s21_q} + {1'b0, xor_1721_s21_q};
      sum_1726_s22_q <= {9'h0, difference_1724_s21_q} + {1'b0, xor_1725_s21_q};
      sum_1730_s22_q <= {9'h0, difference_1728_s21_q} + {1'b0, xor_1729_s21_q};
      equal_1738_s22_q <= equal_1738_s21_q;
      contrast_s22_q <= contrast;
      contrast_2_s22_q <= contrast_2;
      equal_1859_s22_q <= equal_1859_s21_q;
      and_1976_s22_q <= and_1976_s21_q;
      and_1980_s22_q <= and_1980_s21_q;
      and_1995_s22_q <= and_1995;
      not_1999_s22_q <= not_1999_s21_q;
      e_s22_q <= e;
      select_2025_s22_q <= less_2024 ? 10'h0 : regions_rdata_s21_q[9:0];
      select_2028_s22_q <= less_2024 ? 10'h0 : regions_rdata_s21_q[19:10];
      equal_2084_s22_q <= equal_2084_s21_q;
      and_2111_s22_q <= not_1338_s21_q & (so_s21_q & (half_ends & equal_2108));
      and_2113_s22_q <= and_2113_s21_q;
      select_2135_s22_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2184_s22_q <= sum_1388 == 2'h2;
      not_2185_s22_q <= ~select_1432;
      quarter_2_s22_q <= quarter_2;
      equal_2359_s22_q <= equal_2359_s21_q;
      and_2360_s22_q <= and_2360_s21_q;
      less_2361_s22_q <= counts_explained_q < product_q;
      equal_2362_s22_q <= counts_explained_q == product_q;
      equal_2379_s22_q <= equal_2379_s21_q;
      equal_2381_s22_q <= equal_2381_s21_q;
      equal_2382_s22_q <= equal_2382_s21_q;
      sum_3_s22_q <= sum_3[0];
      equal_2511_s22_q <= equal_2511_s21_q;
      select_2604_s22_q <= less_2024 ? 10'h0 : regions_rdata_s21_q[29:20];
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
  logic [13:0] counts_supervised_q;
  logic [3:0] registration_fresh_q;
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
  // hls/stages/agreement.hpp:432
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
  logic [10:0] sum_470;
  assign sum_470 = sum_466_s22_q + {1'b0, sum_469_s22_q};
  // hls/stages/agreement.hpp:392
  logic and_1428;
  assign and_1428 = so_s22_q & and_1427_s22_q;
  // hls/stages/agreement.hpp:411
  logic next_row;
  assign next_row = select_1498_s22_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1223
  logic [6:0] select_1501;
  assign select_1501 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1233
  logic equal_1504;
  assign equal_1504 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1206
  logic not_1511;
  assign not_1511 = ~marks_first_s22_q;
  // hls/stages/agreement.hpp:1048
  logic [4:0] t;
  assign t = {difference_1533_s22_q[3], difference_1533_s22_q} + (equal_1534_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1055
  logic not_1549;
  assign not_1549 = ~region_row_s22_q[2];
  logic [2:0] select_1550;
  assign select_1550 = region_row_s22_q[1] ? {1'b0, not_1549, 1'b0} : {region_row_s22_q[2], 1'b0, not_1549};
  logic [5:0] select_1551;
  assign select_1551 = region_row_s22_q[0] ? {select_1550[2], 1'b0, select_1550[1], 1'b0, select_1550[0], 1'b0} : {1'b0, select_1550[2], 1'b0, select_1550[1], 1'b0, select_1550[0]};
  logic [11:0] select_1552;
  assign select_1552 = or_1548_s22_q ? {select_1551[5], 1'b0, select_1551[4], 1'b0, select_1551[3], 1'b0, select_1551[2], 1'b0, select_1551[1], 1'b0, select_1551[0], 1'b0} : {1'b0, select_1551[5], 1'b0, select_1551[4], 1'b0, select_1551[3], 1'b0, select_1551[2], 1'b0, select_1551[1], 1'b0, select_1551[0]};
  logic [23:0] select_1553;
  assign select_1553 = or_1545_s22_q ? {select_1552[11], 1'b0, select_1552[10], 1'b0, select_1552[9], 1'b0, select_1552[8], 1'b0, select_1552[7], 1'b0, select_1552[6], 1'b0, select_1552[5], 1'b0, select_1552[4], 1'b0, select_1552[3], 1'b0, select_1552[2], 1'b0, select_1552[1], 1'b0, select_1552[0], 1'b0} : {1'b0, select_1552[11], 1'b0, select_1552[10], 1'b0, select_1552[9], 1'b0, select_1552[8], 1'b0, select_1552[7], 1'b0, select_1552[6], 1'b0, select_1552[5], 1'b0, select_1552[4], 1'b0, select_1552[3], 1'b0, select_1552[2], 1'b0, select_1552[1], 1'b0, select_1552[0]};
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_1571;
  assign sum_1571 = {1'b0, around_s22_q} + {2'h0, around_s22_q[4:1]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s22_q} + (equal_371_s22_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_1640;
  assign select_1640 = sample_pair_whole_s22_q ? (and_366_s22_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s22_q} + (equal_371_s22_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_1648;
  assign select_1648 = sample_pair_whole_s22_q ? (and_366_s22_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:495
  logic select_1696;
  assign select_1696 = and_368_s22_q ? census_columns_values_1_cell_2_mask_s22_q : census_columns_values_2_cell_2_mask_q;
  logic select_1699;
  assign select_1699 = and_368_s22_q ? census_columns_values_1_cell_3_mask_s22_q : census_columns_values_2_cell_3_mask_q;
  logic select_1702;
  assign select_1702 = and_368_s22_q ? census_columns_values_1_cell_4_mask_s22_q : census_columns_values_2_cell_4_mask_q;
  logic select_1703;
  assign select_1703 = and_368_s22_q ? census_columns_values_2_cell_0_mask_s22_q : census_columns_values_3_cell_0_mask_q;
  logic select_1706;
  assign select_1706 = and_368_s22_q ? census_columns_values_2_cell_1_mask_s22_q : census_columns_values_3_cell_1_mask_q;
  logic select_1707;
  assign select_1707 = and_368_s22_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1710;
  assign select_1710 = and_368_s22_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_1723;
  assign sum_1723 = sum_1719_s22_q + {1'b0, sum_1722_s22_q};
  // hls/stages/census.hpp:355
  logic and_1757;
  assign and_1757 = whole_2_s22_q & (~(column_s22_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:433
  logic and_1763;
  assign and_1763 = and_1757 & (sharpness_last_mask_q & (7'h2 < contrast_s22_q[8:2]));
  logic and_1774;
  assign and_1774 = and_1757 & (sharpness_last_mask_q & (7'h2 < contrast_2_s22_q[8:2]));
  // hls/stages/census.hpp:408
  logic not_1791;
  assign not_1791 = ~x_s22_q[1];
  logic [2:0] select_1792;
  assign select_1792 = x_s22_q[0] ? {1'b0, not_1791, 1'b0} : {x_s22_q[1], 1'b0, not_1791};
  logic [5:0] select_1793;
  assign select_1793 = slot_s22_q[2] ? {select_1792[2], 1'b0, select_1792[1], 1'b0, select_1792[0], 1'b0} : {1'b0, select_1792[2], 1'b0, select_1792[1], 1'b0, select_1792[0]};
  logic [11:0] select_1794;
  assign select_1794 = slot_s22_q[1] ? {select_1793[5], 1'b0, select_1793[4], 1'b0, select_1793[3], 1'b0, select_1793[2], 1'b0, select_1793[1], 1'b0, select_1793[0], 1'b0} : {1'b0, select_1793[5], 1'b0, select_1793[4], 1'b0, select_1793[3], 1'b0, select_1793[2], 1'b0, select_1793[1], 1'b0, select_1793[0]};
  // hls/stages/agreement.hpp:904
  logic [13:0] select_1982;
  assign select_1982 = and_1976_s22_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1980_s22_q});
  // hls/stages/agreement.hpp:1056
  logic [5:0] sum_2012;
  assign sum_2012 = {1'b0, e_s22_q} + {2'h0, e_s22_q[4:1]};
  // hls/stages/registration.hpp:213
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2135_s22_q[11:7])) ? 12'h7f : select_2135_s22_q;
  // hls/stages/registration.hpp:264
  logic [3:0] select_2187;
  assign select_2187 = equal_2184_s22_q ? (registration_fresh_q & not_2185_s22_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_2189;
  assign select_2189 = so_s22_q ? (and_1427_s22_q ? select_2187 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:237
  logic [3:0] select_2191;
  assign select_2191 = and_1976_s22_q ? 4'hf : (equal_1337_s22_q ? registration_fresh_q : select_2189);
  // hls/stages/registration.hpp:253
  logic not_2212;
  assign not_2212 = ~quarter_2_s22_q[1];
  logic [3:0] select_2213;
  assign select_2213 = quarter_2_s22_q[0] ? {quarter_2_s22_q[1], 1'b0, not_2212, 1'b0} : {1'b0, quarter_2_s22_q[1], 1'b0, not_2212};
  // hls/stages/agreement.hpp:1132
  logic or_2356;
  assign or_2356 = ({counts_textured_s22_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s22_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1163
  logic too_little;
  assign too_little = less_2361_s22_q | (product_rest_q & equal_2362_s22_q);
  // hls/stages/agreement.hpp:1164
  logic select_2365;
  assign select_2365 = and_2360_s22_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2368;
  assign sum_2368 = {1'b0, select_2028_s22_q} + {2'h0, select_2028_s22_q[9:1]};
  // hls/stages/agreement.hpp:392
  logic select_2413;
  assign select_2413 = equal_1337_s22_q ? (equal_2359_s22_q ? sum_3_s22_q : (product_rest_q | sum_3_s22_q)) : product_rest_q;
  logic [4:0] select_2442;
  assign select_2442 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_2443;
  assign select_2443 = equal_1337_s22_q ? box_textured_sum_sums_values_0_q : select_2442;
  // hls/stages/agreement.hpp:1232
  logic [3:0] select_2528;
  assign select_2528 = select_1498_s22_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:411
  logic [7:0] select_2534;
  assign select_2534 = marks_first_s22_q ? (less_2530 ? {sum_2531, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:253
  logic not_2592;
  assign not_2592 = ~quarter_s22_q[1];
  logic [3:0] select_2593;
  assign select_2593 = quarter_s22_q[0] ? {quarter_s22_q[1], 1'b0, not_2592, 1'b0} : {1'b0, quarter_s22_q[1], 1'b0, not_2592};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:271; read in stage 22, written in stage 26: 22 < 26 < 22 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1389_s22_q;
  logic registration_sums_re;
  assign registration_sums_re = s22_en & (equal_1337_s22_q ? (x_s22_q[6] & select_1417_s22_q) : and_1428);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s22_q, or_1454_s22_q, or_1451_s22_q, or_1448_s22_q};
  logic regions_we;
  assign regions_we = s22_en & and_1483_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1482_s22_q, sum_1476_s22_q, sum_1471_s22_q};
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
      registration_fresh_q <= 4'hf;
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
      counts_supervised_q <= select_1982;
      registration_fresh_q <= select_2191;
      product_rest_q <= select_2413;
      disagree_q <= equal_1337_s22_q ? select_2365 : disagree_q;
      began_q <= not_1511 & (began_q | select_1498_s22_q);
      seen_x_q <= select_1498_s22_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s22_q ? 4'h0 : select_2528;
      seen_column_q <= select_1498_s22_q ? 8'h0 : (seen_column_q + {7'h0, equal_1504});
      seen_rows_left_q <= select_2534;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s22_q ? 13'h0 : (seen_base_q + {6'h0, select_1501});
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
      averager_detail_0_q <= select_1640;
      averager_detail_1_q <= select_1648;
      census_columns_values_2_cell_2_mask_q <= select_1696;
      census_columns_values_2_cell_3_mask_q <= select_1699;
      census_columns_values_2_cell_4_mask_q <= select_1702;
      census_columns_values_3_cell_0_mask_q <= select_1703;
      census_columns_values_3_cell_1_mask_q <= select_1706;
      census_columns_values_3_cell_2_mask_q <= select_1707;
      census_columns_values_3_cell_3_mask_q <= select_1710;
      sharpness_last_mask_q <= and_368_s22_q ? whole_2_s22_q : sharpness_last_mask_q;
      box_textured_sum_sums_values_0_q <= select_2443;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
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
  logic [13:0] product_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic [6:0] column_s23_q;
  logic and_368_s23_q;
  logic so_s23_q;
  logic less_402_s23_q;
  logic less_403_s23_q;
  logic less_404_s23_q;
  logic less_405_s23_q;
  logic less_406_s23_q;
  logic less_407_s23_q;
  logic less_408_s23_q;
  logic less_409_s23_q;
  logic less_410_s23_q;
  logic less_411_s23_q;
  logic less_412_s23_q;
  logic less_413_s23_q;
  logic less_414_s23_q;
  logic less_415_s23_q;
  logic less_416_s23_q;
  logic less_417_s23_q;
  logic less_418_s23_q;
  logic less_419_s23_q;
  logic less_420_s23_q;
  logic less_421_s23_q;
  logic less_422_s23_q;
  logic less_423_s23_q;
  logic less_424_s23_q;
  logic less_425_s23_q;
  logic and_433_s23_q;
  logic whole_16_s23_q;
  logic and_459_s23_q;
  logic [11:0] sum_474_s23_q;
  logic [9:0] sum_477_s23_q;
  logic equal_1337_s23_q;
  logic not_1338_s23_q;
  logic equal_1382_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1388_s23_q;
  logic equal_1390_s23_q;
  logic equal_1392_s23_q;
  logic equal_1394_s23_q;
  logic equal_1396_s23_q;
  logic equal_1398_s23_q;
  logic equal_1400_s23_q;
  logic equal_1402_s23_q;
  logic less_1410_s23_q;
  logic or_1414_s23_q;
  logic equal_1434_s23_q;
  logic and_1444_s23_q;
  logic not_1456_s23_q;
  logic not_1511_s23_q;
  logic [7:0] sum_1521_s23_q;
  logic equal_1537_s23_q;
  logic or_1542_s23_q;
  logic [23:0] select_1553_s23_q;
  logic not_1573_s23_q;
  logic less_1587_s23_q;
  logic and_1598_s23_q;
  logic [11:0] sum_1727_s23_q;
  logic [9:0] sum_1730_s23_q;
  logic equal_1738_s23_q;
  logic [27:0] select_1752_s23_q;
  logic and_1763_s23_q;
  logic and_1774_s23_q;
  logic [8:0] select_1781_s23_q;
  logic [8:0] select_1785_s23_q;
  logic equal_1788_s23_q;
  logic less_1789_s23_q;
  logic [11:0] select_1794_s23_q;
  logic equal_1832_s23_q;
  logic equal_1859_s23_q;
  logic and_1976_s23_q;
  logic and_1995_s23_q;
  logic not_1999_s23_q;
  logic not_2014_s23_q;
  logic [9:0] select_2025_s23_q;
  logic [9:0] select_2028_s23_q;
  logic equal_2084_s23_q;
  logic and_2111_s23_q;
  logic and_2113_s23_q;
  logic [11:0] residual_s23_q;
  logic equal_2215_s23_q;
  logic equal_2353_s23_q;
  logic or_2356_s23_q;
  logic equal_2359_s23_q;
  logic select_2365_s23_q;
  logic not_2370_s23_q;
  logic equal_2379_s23_q;
  logic equal_2381_s23_q;
  logic equal_2382_s23_q;
  logic equal_2511_s23_q;
  logic equal_2595_s23_q;
  logic [9:0] select_2604_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= line_ended_q;
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
      product_s23_q <= product_s22_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_s22_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_s22_q;
      column_s23_q <= column_s22_q;
      and_368_s23_q <= and_368_s22_q;
      so_s23_q <= so_s22_q;
      less_402_s23_q <= less_402_s22_q;
      less_403_s23_q <= less_403_s22_q;
      less_404_s23_q <= less_404_s22_q;
      less_405_s23_q <= less_405_s22_q;
      less_406_s23_q <= less_406_s22_q;
      less_407_s23_q <= less_407_s22_q;
      less_408_s23_q <= less_408_s22_q;
      less_409_s23_q <= less_409_s22_q;
      less_410_s23_q <= less_410_s22_q;
      less_411_s23_q <= less_411_s22_q;
      less_412_s23_q <= less_412_s22_q;
      less_413_s23_q <= less_413_s22_q;
      less_414_s23_q <= less_414_s22_q;
      less_415_s23_q <= less_415_s22_q;
      less_416_s23_q <= less_416_s22_q;
      less_417_s23_q <= less_417_s22_q;
      less_418_s23_q <= less_418_s22_q;
      less_419_s23_q <= less_419_s22_q;
      less_420_s23_q <= less_420_s22_q;
      less_421_s23_q <= less_421_s22_q;
      less_422_s23_q <= less_422_s22_q;
      less_423_s23_q <= less_423_s22_q;
      less_424_s23_q <= less_424_s22_q;
      less_425_s23_q <= less_425_s22_q;
      and_433_s23_q <= and_433_s22_q;
      whole_16_s23_q <= whole_16;
      and_459_s23_q <= census_columns_values_1_cell_2_mask_s22_q & and_433_s22_q;
      sum_474_s23_q <= {1'b0, sum_470} + {2'h0, sum_473_s22_q};
      sum_477_s23_q <= sum_477_s22_q;
      equal_1337_s23_q <= equal_1337_s22_q;
      not_1338_s23_q <= not_1338_s22_q;
      equal_1382_s23_q <= equal_1382_s22_q;
      all_s23_q <= all_s22_q;
      sum_1388_s23_q <= sum_1388_s22_q;
      equal_1390_s23_q <= equal_1390_s22_q;
      equal_1392_s23_q <= equal_1392_s22_q;
      equal_1394_s23_q <= equal_1394_s22_q;
      equal_1396_s23_q <= equal_1396_s22_q;
      equal_1398_s23_q <= equal_1398_s22_q;
      equal_1400_s23_q <= equal_1400_s22_q;
      equal_1402_s23_q <= equal_1402_s22_q;
      less_1410_s23_q <= less_1410_s22_q;
      or_1414_s23_q <= or_1414_s22_q;
      equal_1434_s23_q <= (registration_fresh_q & select_1432_s22_q) == 4'h0;
      and_1444_s23_q <= not_1338_s22_q & and_1428;
      not_1456_s23_q <= not_1456_s22_q;
      not_1511_s23_q <= not_1511;
      sum_1521_s23_q <= {2'h0, x_s22_q[7:2]} + 8'hff;
      equal_1537_s23_q <= t[4:1] == 4'h0;
      or_1542_s23_q <= or_1542_s22_q;
      select_1553_s23_q <= select_1553;
      not_1573_s23_q <= ~({sum_1571, around_s22_q[0]} < {2'h0, t});
      less_1587_s23_q <= less_1587_s22_q;
      and_1598_s23_q <= and_1598_s22_q;
      sum_1727_s23_q <= {1'b0, sum_1723} + {2'h0, sum_1726_s22_q};
      sum_1730_s23_q <= sum_1730_s22_q;
      equal_1738_s23_q <= equal_1738_s22_q;
      select_1752_s23_q <= sample_pair_whole_s22_q ? {detail_2, detail} : 28'h0;
      and_1763_s23_q <= and_1763;
      and_1774_s23_q <= and_1774;
      select_1781_s23_q <= and_1763 ? contrast_s22_q : 9'h0;
      select_1785_s23_q <= and_1774 ? contrast_2_s22_q : 9'h0;
      equal_1788_s23_q <= x_s22_q[7:3] == 5'h0;
      less_1789_s23_q <= 7'h2 < {x_s22_q[4:0], slot_s22_q[2:1]};
      select_1794_s23_q <= select_1794;
      equal_1832_s23_q <= {x_s22_q[4:0], slot_s22_q} == 8'h0;
      equal_1859_s23_q <= equal_1859_s22_q;
      and_1976_s23_q <= and_1976_s22_q;
      and_1995_s23_q <= and_1995_s22_q;
      not_1999_s23_q <= not_1999_s22_q;
      not_2014_s23_q <= ~({sum_2012, e_s22_q[0]} < {2'h0, t});
      select_2025_s23_q <= select_2025_s22_q;
      select_2028_s23_q <= select_2028_s22_q;
      equal_2084_s23_q <= equal_2084_s22_q;
      and_2111_s23_q <= and_2111_s22_q;
      and_2113_s23_q <= and_2113_s22_q;
      residual_s23_q <= residual;
      equal_2215_s23_q <= (registration_fresh_q & select_2213) == 4'h0;
      equal_2353_s23_q <= select_2025_s22_q[9:3] == 7'h0;
      or_2356_s23_q <= or_2356;
      equal_2359_s23_q <= equal_2359_s22_q;
      select_2365_s23_q <= select_2365;
      not_2370_s23_q <= ~({sum_2368, select_2028_s22_q[0]} < {2'h0, select_2025_s22_q});
      equal_2379_s23_q <= equal_2379_s22_q;
      equal_2381_s23_q <= equal_2381_s22_q;
      equal_2382_s23_q <= equal_2382_s22_q;
      equal_2511_s23_q <= equal_2511_s22_q;
      equal_2595_s23_q <= (registration_fresh_q & select_2593) == 4'h0;
      select_2604_s23_q <= select_2604_s22_q;
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
  logic [47:0] good_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:432
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
  assign texture = sum_474_s23_q + {2'h0, sum_477_s23_q};
  // hls/stages/agreement.hpp:1240
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1207
  logic select_1509;
  assign select_1509 = marks_first_s23_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1193
  logic [10:0] sum_1510;
  assign sum_1510 = {1'b0, {5{select_1509}}, 1'b0, {2{select_1509}}, 1'b0, select_1509} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1065
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1521_s23_q[7]}}, sum_1521_s23_q, x_s23_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1193
  logic [10:0] sum_1523;
  assign sum_1523 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1055
  logic [47:0] select_1554;
  assign select_1554 = or_1542_s23_q ? {select_1553_s23_q[23], 1'b0, select_1553_s23_q[22], 1'b0, select_1553_s23_q[21], 1'b0, select_1553_s23_q[20], 1'b0, select_1553_s23_q[19], 1'b0, select_1553_s23_q[18], 1'b0, select_1553_s23_q[17], 1'b0, select_1553_s23_q[16], 1'b0, select_1553_s23_q[15], 1'b0, select_1553_s23_q[14], 1'b0, select_1553_s23_q[13], 1'b0, select_1553_s23_q[12], 1'b0, select_1553_s23_q[11], 1'b0, select_1553_s23_q[10], 1'b0, select_1553_s23_q[9], 1'b0, select_1553_s23_q[8], 1'b0, select_1553_s23_q[7], 1'b0, select_1553_s23_q[6], 1'b0, select_1553_s23_q[5], 1'b0, select_1553_s23_q[4], 1'b0, select_1553_s23_q[3], 1'b0, select_1553_s23_q[2], 1'b0, select_1553_s23_q[1], 1'b0, select_1553_s23_q[0], 1'b0} : {1'b0, select_1553_s23_q[23], 1'b0, select_1553_s23_q[22], 1'b0, select_1553_s23_q[21], 1'b0, select_1553_s23_q[20], 1'b0, select_1553_s23_q[19], 1'b0, select_1553_s23_q[18], 1'b0, select_1553_s23_q[17], 1'b0, select_1553_s23_q[16], 1'b0, select_1553_s23_q[15], 1'b0, select_1553_s23_q[14], 1'b0, select_1553_s23_q[13], 1'b0, select_1553_s23_q[12], 1'b0, select_1553_s23_q[11], 1'b0, select_1553_s23_q[10], 1'b0, select_1553_s23_q[9], 1'b0, select_1553_s23_q[8], 1'b0, select_1553_s23_q[7], 1'b0, select_1553_s23_q[6], 1'b0, select_1553_s23_q[5], 1'b0, select_1553_s23_q[4], 1'b0, select_1553_s23_q[3], 1'b0, select_1553_s23_q[2], 1'b0, select_1553_s23_q[1], 1'b0, select_1553_s23_q[0]};
  // hls/stages/agreement.hpp:495
  logic select_1711;
  assign select_1711 = and_368_s23_q ? census_columns_values_2_cell_4_mask_s23_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_1731;
  assign sum_1731 = sum_1727_s23_q + {2'h0, sum_1730_s23_q};
  // hls/stages/agreement.hpp:495
  logic [11:0] select_1733;
  assign select_1733 = and_368_s23_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1734;
  assign select_1734 = and_368_s23_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_1753;
  assign select_1753 = and_368_s23_q ? select_1752_s23_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_1754;
  assign select_1754 = and_368_s23_q ? select_1752_s23_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1752_s23_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1752_s23_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_1782;
  assign sum_1782 = (equal_1738_s23_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1781_s23_q};
  logic [23:0] sum_1786;
  assign sum_1786 = (equal_1738_s23_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1785_s23_q};
  // hls/stages/census.hpp:408
  logic less_1790;
  assign less_1790 = x_s23_q[4:0] < 5'h3;
  logic [23:0] select_1795;
  assign select_1795 = slot_s23_q ? {select_1794_s23_q[11], 1'b0, select_1794_s23_q[10], 1'b0, select_1794_s23_q[9], 1'b0, select_1794_s23_q[8], 1'b0, select_1794_s23_q[7], 1'b0, select_1794_s23_q[6], 1'b0, select_1794_s23_q[5], 1'b0, select_1794_s23_q[4], 1'b0, select_1794_s23_q[3], 1'b0, select_1794_s23_q[2], 1'b0, select_1794_s23_q[1], 1'b0, select_1794_s23_q[0], 1'b0} : {1'b0, select_1794_s23_q[11], 1'b0, select_1794_s23_q[10], 1'b0, select_1794_s23_q[9], 1'b0, select_1794_s23_q[8], 1'b0, select_1794_s23_q[7], 1'b0, select_1794_s23_q[6], 1'b0, select_1794_s23_q[5], 1'b0, select_1794_s23_q[4], 1'b0, select_1794_s23_q[3], 1'b0, select_1794_s23_q[2], 1'b0, select_1794_s23_q[1], 1'b0, select_1794_s23_q[0]};
  // hls/stages/census.hpp:371
  logic and_1799;
  assign and_1799 = less_1790 & (~((sharpness_sums_contrast_1_q & select_1795) == 24'h0));
  logic and_1809;
  assign and_1809 = less_1790 & (~((sharpness_sums_contrast_0_q & select_1795) == 24'h0));
  // hls/stages/agreement.hpp:1086
  logic [10:0] sum_2029;
  assign sum_2029 = {1'b0, select_2028_s23_q} + {3'h0, select_2028_s23_q[9:2]};
  // hls/stages/registration.hpp:200
  logic [12:0] difference_2156;
  assign difference_2156 = 13'h0 - {residual_s23_q[11], residual_s23_q};
  logic less_2171;
  assign less_2171 = $signed(difference_2156) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1088
  logic select_2371;
  assign select_2371 = equal_2353_s23_q ? ((~or_2356_s23_q) & (~select_2365_s23_q)) : not_2370_s23_q;
  // hls/stages/agreement.hpp:1095
  logic [47:0] select_2373;
  assign select_2373 = x_s23_q[6] ? (equal_1382_s23_q ? good_q : {select_2371, good_q[47:1]}) : good_q;
  logic equal_2376;
  assign equal_2376 = x_s23_q == 7'h7f;
  // hls/stages/agreement.hpp:436
  logic [12:0] select_2514;
  assign select_2514 = equal_1859_s23_q ? (equal_2511_s23_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2517;
  assign select_2517 = and_368_s23_q ? (equal_1859_s23_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s23_en) begin
      sharpness_sums_contrast_0_q <= and_368_s23_q ? sum_1782 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_368_s23_q ? sum_1786 : sharpness_sums_contrast_1_q;
      good_q <= equal_1337_s23_q ? select_2373 : good_q;
      map_row_q <= and_368_s23_q ? select_2514 : map_row_q;
      map_width_q <= select_2517;
      write_half_q <= marks_first_s23_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1509;
      done_q <= not_1511_s23_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s23_q;
      said_q <= equal_1337_s23_q & equal_2376;
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
      census_columns_values_3_cell_4_mask_q <= select_1711;
      census_changes_values_0_left_q <= and_368_s23_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_368_s23_q ? sum_1731 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1733;
      census_changes_values_1_right_q <= select_1734;
      sharpness_last_detail_0_q <= select_1753;
      sharpness_last_detail_1_q <= select_1754;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic [11:0] census_changes_values_1_left_s24_q;
  logic [11:0] census_changes_values_1_right_s24_q;
  logic [23:0] sharpness_sums_contrast_0_s24_q;
  logic [23:0] sharpness_sums_contrast_1_s24_q;
  logic [6:0] x_s24_q;
  logic ends_cell_s24_q;
  logic lower_half_s24_q;
  logic [13:0] counts_supervised_s24_q;
  logic [13:0] counts_textured_s24_q;
  logic [13:0] counts_explained_s24_q;
  logic registration_of_right_s24_q;
  logic [13:0] product_s24_q;
  logic centres_values_1_textured_s24_q;
  logic centres_values_1_of_skin_s24_q;
  logic done_s24_q;
  logic [6:0] column_s24_q;
  logic and_368_s24_q;
  logic less_402_s24_q;
  logic less_403_s24_q;
  logic less_404_s24_q;
  logic less_405_s24_q;
  logic less_406_s24_q;
  logic less_407_s24_q;
  logic less_408_s24_q;
  logic less_409_s24_q;
  logic less_410_s24_q;
  logic less_411_s24_q;
  logic less_412_s24_q;
  logic less_413_s24_q;
  logic less_414_s24_q;
  logic less_415_s24_q;
  logic less_416_s24_q;
  logic less_417_s24_q;
  logic less_418_s24_q;
  logic less_419_s24_q;
  logic less_420_s24_q;
  logic less_421_s24_q;
  logic less_422_s24_q;
  logic less_423_s24_q;
  logic less_424_s24_q;
  logic less_425_s24_q;
  logic and_433_s24_q;
  logic and_458_s24_q;
  logic and_459_s24_q;
  logic [12:0] sum_479_s24_q;
  logic equal_1337_s24_q;
  logic not_1338_s24_q;
  logic equal_1382_s24_q;
  logic all_s24_q;
  logic [1:0] sum_1388_s24_q;
  logic equal_1390_s24_q;
  logic equal_1392_s24_q;
  logic equal_1394_s24_q;
  logic equal_1396_s24_q;
  logic equal_1398_s24_q;
  logic equal_1400_s24_q;
  logic equal_1402_s24_q;
  logic less_1410_s24_q;
  logic or_1414_s24_q;
  logic [31:0] registration_sums_rdata_s24_q;
  logic equal_1434_s24_q;
  logic and_1444_s24_q;
  logic not_1456_s24_q;
  logic [2:0] index_s24_q;
  logic [10:0] sum_1510_s24_q;
  logic and_1517_s24_q;
  logic less_1518_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1523_s24_q;
  logic equal_1537_s24_q;
  logic not_1557_s24_q;
  logic not_1573_s24_q;
  logic less_1587_s24_q;
  logic and_1598_s24_q;
  logic equal_1738_s24_q;
  logic [12:0] sum_1739_s24_q;
  logic [12:0] select_1765_s24_q;
  logic [12:0] select_1776_s24_q;
  logic equal_1788_s24_q;
  logic less_1789_s24_q;
  logic and_1799_s24_q;
  logic and_1809_s24_q;
  logic equal_1832_s24_q;
  logic and_1976_s24_q;
  logic and_1995_s24_q;
  logic not_1999_s24_q;
  logic not_2014_s24_q;
  logic [9:0] select_2025_s24_q;
  logic [9:0] select_2028_s24_q;
  logic less_2030_s24_q;
  logic equal_2084_s24_q;
  logic and_2111_s24_q;
  logic and_2113_s24_q;
  logic [7:0] residual_s24_q;
  logic less_2157_s24_q;
  logic less_2171_s24_q;
  logic equal_2215_s24_q;
  logic or_2356_s24_q;
  logic equal_2359_s24_q;
  logic select_2365_s24_q;
  logic equal_2376_s24_q;
  logic equal_2379_s24_q;
  logic equal_2381_s24_q;
  logic equal_2382_s24_q;
  logic equal_2595_s24_q;
  logic [9:0] select_2604_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      census_changes_values_1_left_s24_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s24_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s24_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s24_q <= sharpness_sums_contrast_1_q;
      x_s24_q <= x_s23_q;
      ends_cell_s24_q <= ends_cell_s23_q;
      lower_half_s24_q <= lower_half_s23_q;
      counts_supervised_s24_q <= counts_supervised_s23_q;
      counts_textured_s24_q <= counts_textured_s23_q;
      counts_explained_s24_q <= counts_explained_s23_q;
      registration_of_right_s24_q <= registration_of_right_s23_q;
      product_s24_q <= product_s23_q;
      centres_values_1_textured_s24_q <= centres_values_1_textured_s23_q;
      centres_values_1_of_skin_s24_q <= centres_values_1_of_skin_s23_q;
      done_s24_q <= done_q;
      column_s24_q <= column_s23_q;
      and_368_s24_q <= and_368_s23_q;
      less_402_s24_q <= less_402_s23_q;
      less_403_s24_q <= less_403_s23_q;
      less_404_s24_q <= less_404_s23_q;
      less_405_s24_q <= less_405_s23_q;
      less_406_s24_q <= less_406_s23_q;
      less_407_s24_q <= less_407_s23_q;
      less_408_s24_q <= less_408_s23_q;
      less_409_s24_q <= less_409_s23_q;
      less_410_s24_q <= less_410_s23_q;
      less_411_s24_q <= less_411_s23_q;
      less_412_s24_q <= less_412_s23_q;
      less_413_s24_q <= less_413_s23_q;
      less_414_s24_q <= less_414_s23_q;
      less_415_s24_q <= less_415_s23_q;
      less_416_s24_q <= less_416_s23_q;
      less_417_s24_q <= less_417_s23_q;
      less_418_s24_q <= less_418_s23_q;
      less_419_s24_q <= less_419_s23_q;
      less_420_s24_q <= less_420_s23_q;
      less_421_s24_q <= less_421_s23_q;
      less_422_s24_q <= less_422_s23_q;
      less_423_s24_q <= less_423_s23_q;
      less_424_s24_q <= less_424_s23_q;
      less_425_s24_q <= less_425_s23_q;
      and_433_s24_q <= and_433_s23_q;
      and_458_s24_q <= whole_22 & and_433_s23_q;
      and_459_s24_q <= and_459_s23_q;
      sum_479_s24_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1337_s24_q <= equal_1337_s23_q;
      not_1338_s24_q <= not_1338_s23_q;
      equal_1382_s24_q <= equal_1382_s23_q;
      all_s24_q <= all_s23_q;
      sum_1388_s24_q <= sum_1388_s23_q;
      equal_1390_s24_q <= equal_1390_s23_q;
      equal_1392_s24_q <= equal_1392_s23_q;
      equal_1394_s24_q <= equal_1394_s23_q;
      equal_1396_s24_q <= equal_1396_s23_q;
      equal_1398_s24_q <= equal_1398_s23_q;
      equal_1400_s24_q <= equal_1400_s23_q;
      equal_1402_s24_q <= equal_1402_s23_q;
      less_1410_s24_q <= less_1410_s23_q;
      or_1414_s24_q <= or_1414_s23_q;
      registration_sums_rdata_s24_q <= registration_sums_rdata_q;
      equal_1434_s24_q <= equal_1434_s23_q;
      and_1444_s24_q <= and_1444_s23_q;
      not_1456_s24_q <= not_1456_s23_q;
      index_s24_q <= index[2:0];
      sum_1510_s24_q <= sum_1510;
      and_1517_s24_q <= began_q & (seen_x_q == 4'h0);
      less_1518_s24_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s24_q <= index_2[2:0];
      sum_1523_s24_q <= sum_1523;
      equal_1537_s24_q <= equal_1537_s23_q;
      not_1557_s24_q <= ~((good_q & select_1554) == 48'h0);
      not_1573_s24_q <= not_1573_s23_q;
      less_1587_s24_q <= less_1587_s23_q;
      and_1598_s24_q <= and_1598_s23_q;
      equal_1738_s24_q <= equal_1738_s23_q;
      sum_1739_s24_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1731};
      select_1765_s24_q <= and_1763_s23_q ? detail_3[14:2] : 13'h0;
      select_1776_s24_q <= and_1774_s23_q ? detail_4[14:2] : 13'h0;
      equal_1788_s24_q <= equal_1788_s23_q;
      less_1789_s24_q <= less_1789_s23_q;
      and_1799_s24_q <= and_1799;
      and_1809_s24_q <= and_1809;
      equal_1832_s24_q <= equal_1832_s23_q;
      and_1976_s24_q <= and_1976_s23_q;
      and_1995_s24_q <= and_1995_s23_q;
      not_1999_s24_q <= not_1999_s23_q;
      not_2014_s24_q <= not_2014_s23_q;
      select_2025_s24_q <= select_2025_s23_q;
      select_2028_s24_q <= select_2028_s23_q;
      less_2030_s24_q <= {sum_2029, select_2028_s23_q[1:0]} < {3'h0, select_2025_s23_q};
      equal_2084_s24_q <= equal_2084_s23_q;
      and_2111_s24_q <= and_2111_s23_q;
      and_2113_s24_q <= and_2113_s23_q;
      residual_s24_q <= residual_s23_q[7:0];
      less_2157_s24_q <= $signed(difference_2156) < $signed({7'h0, cfg_moved_limit_i});
      less_2171_s24_q <= less_2171;
      equal_2215_s24_q <= equal_2215_s23_q;
      or_2356_s24_q <= or_2356_s23_q;
      equal_2359_s24_q <= equal_2359_s23_q;
      select_2365_s24_q <= select_2365_s23_q;
      equal_2376_s24_q <= equal_2376;
      equal_2379_s24_q <= equal_2379_s23_q;
      equal_2381_s24_q <= equal_2381_s23_q;
      equal_2382_s24_q <= equal_2382_s23_q;
      equal_2595_s24_q <= equal_2595_s23_q;
      select_2604_s24_q <= select_2604_s23_q;
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
  logic [13:0] counts_nearer_q;
  logic good_known_q;
  // hls/stages/census.hpp:281
  logic [13:0] sum_480;
  assign sum_480 = {2'h0, census_changes_values_1_left_s24_q} + {1'b0, sum_479_s24_q};
  logic [13:0] sum_481;
  assign sum_481 = {2'h0, census_changes_values_2_left_q} + sum_480;
  // hls/stages/agreement.hpp:988
  logic and_1558;
  assign and_1558 = good_known_q & not_1557_s24_q;
  // hls/stages/agreement.hpp:1057
  logic is_seen;
  assign is_seen = equal_1537_s24_q ? and_1558 : not_1573_s24_q;
  // hls/stages/agreement.hpp:495
  logic [11:0] select_1735;
  assign select_1735 = and_368_s24_q ? census_changes_values_1_left_s24_q : census_changes_values_2_left_q;
  logic [11:0] select_1736;
  assign select_1736 = and_368_s24_q ? census_changes_values_1_right_s24_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_1740;
  assign sum_1740 = {2'h0, census_changes_values_1_right_s24_q} + {1'b0, sum_1739_s24_q};
  logic [13:0] sum_1741;
  assign sum_1741 = {2'h0, census_changes_values_2_right_q} + sum_1740;
  // hls/stages/census.hpp:357
  logic [23:0] select_1767;
  assign select_1767 = equal_1738_s24_q ? {11'h0, select_1765_s24_q} : (sharpness_sums_detail_0_q + {11'h0, select_1765_s24_q});
  logic [23:0] select_1778;
  assign select_1778 = equal_1738_s24_q ? {11'h0, select_1776_s24_q} : (sharpness_sums_detail_1_q + {11'h0, select_1776_s24_q});
  // hls/stages/census.hpp:376
  logic [17:0] select_1801;
  assign select_1801 = (less_1789_s24_q & and_1799_s24_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_1811;
  assign select_1811 = (less_1789_s24_q & and_1809_s24_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:200
  logic [1:0] select_1820;
  assign select_1820 = equal_1788_s24_q ? {sharpness_comparing_contrast_0_q[0], and_1809_s24_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_1822;
  assign select_1822 = equal_1788_s24_q ? {sharpness_comparing_contrast_1_q[0], and_1799_s24_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:385
  logic xor_1845;
  assign xor_1845 = sharpness_comparing_contrast_0_q[1] ^ and_1799_s24_q;
  logic select_1848;
  assign select_1848 = (equal_1832_s24_q | xor_1845) ? (and_1799_s24_q & xor_1845) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:200
  logic select_1849;
  assign select_1849 = equal_1788_s24_q ? select_1848 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:385
  logic xor_1851;
  assign xor_1851 = sharpness_comparing_contrast_1_q[1] ^ and_1809_s24_q;
  logic select_1854;
  assign select_1854 = (equal_1832_s24_q | xor_1851) ? (and_1809_s24_q & xor_1851) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:200
  logic select_1855;
  assign select_1855 = equal_1788_s24_q ? select_1854 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_1997;
  assign select_1997 = and_1976_s24_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1995_s24_q});
  // hls/stages/agreement.hpp:1060
  logic not_2016;
  assign not_2016 = ~(equal_1537_s24_q ? and_1558 : not_2014_s24_q);
  // hls/stages/agreement.hpp:392
  logic and_2019;
  assign and_2019 = ends_cell_s24_q & (not_1999_s24_q & (centres_values_1_textured_s24_q & not_2016));
  // hls/stages/agreement.hpp:1091
  logic [9:0] select_2032;
  assign select_2032 = ((~(select_2025_s24_q[9:4] == 6'h0)) & less_2030_s24_q) ? select_2025_s24_q : 10'h0;
  // hls/stages/agreement.hpp:392
  logic [9:0] select_2035;
  assign select_2035 = equal_1337_s24_q ? (x_s24_q[6] ? (equal_1382_s24_q ? 10'h0 : select_2032) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1064
  logic and_2053;
  assign and_2053 = centres_values_1_textured_s24_q & (centres_values_1_of_skin_s24_q & not_2016);
  // hls/stages/registration.hpp:106
  logic [7:0] select_2139;
  assign select_2139 = equal_2084_s24_q ? (and_2113_s24_q ? residual_s24_q : 8'h0) : 8'h0;
  logic and_2150;
  assign and_2150 = and_2113_s24_q & ($signed(residual_s24_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:200
  logic less_2164;
  assign less_2164 = $signed(residual_s24_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2217;
  assign select_2217 = or_1414_s24_q ? 12'h0 : (equal_2215_s24_q ? registration_sums_rdata_s24_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2219;
  assign select_2219 = equal_1382_s24_q ? 12'h0 : (less_1410_s24_q ? select_2217 : 12'h0);
  // hls/stages/registration.hpp:152
  logic and_2222;
  assign and_2222 = x_s24_q[1] & all_s24_q;
  // hls/stages/agreement.hpp:1095
  logic and_2225;
  assign and_2225 = not_1456_s24_q & (less_1410_s24_q & ({and_2222, x_s24_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2232;
  assign select_2232 = or_1414_s24_q ? 12'h0 : (equal_2215_s24_q ? registration_sums_rdata_s24_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2234;
  assign select_2234 = equal_1382_s24_q ? 12'h0 : (less_1410_s24_q ? select_2232 : 12'h0);
  // hls/stages/registration.hpp:149
  logic not_2240;
  assign not_2240 = ~all_s24_q;
  // hls/stages/agreement.hpp:1095
  logic and_2243;
  assign and_2243 = not_1456_s24_q & (less_1410_s24_q & (x_s24_q[2:0] == {all_s24_q, not_2240, 1'b0}));
  // hls/stages/agreement.hpp:392
  logic and_2249;
  assign and_2249 = equal_1337_s24_q & (x_s24_q[6] & (not_1456_s24_q & (less_1410_s24_q & all_s24_q)));
  // hls/stages/registration.hpp:156
  logic equal_2276;
  assign equal_2276 = x_s24_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1095
  logic and_2279;
  assign and_2279 = not_1456_s24_q & (less_1410_s24_q & (x_s24_q[5] ? x_s24_q[3] : equal_2276));
  logic and_2288;
  assign and_2288 = not_1456_s24_q & (less_1410_s24_q & ((~x_s24_q[5]) & (x_s24_q[3] & equal_2276)));
  // hls/stages/agreement.hpp:392
  logic select_2378;
  assign select_2378 = equal_1337_s24_q ? ((x_s24_q[6] & good_known_q) | equal_2376_s24_q) : good_known_q;
  // hls/stages/agreement.hpp:1240
  logic and_2540;
  assign and_2540 = and_1598_s24_q & ({sum_1523_s24_q, index_2_s24_q} == {sum_1510_s24_q, index_s24_q});
  // hls/stages/agreement.hpp:1093
  logic [31:0] select_2597;
  assign select_2597 = equal_1402_s24_q ? {2'h0, counts_explained_s24_q, 2'h0, counts_textured_s24_q} : (equal_2595_s24_q ? registration_sums_rdata_s24_q : 32'h0);
  logic [31:0] select_2598;
  assign select_2598 = equal_1400_s24_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s24_q} : select_2597;

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1333; read in stage 24, written in stage 25: 24 < 25 < 24 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1510_s24_q, index_s24_q};
  logic map_re;
  assign map_re = s24_en & (and_1517_s24_q & less_1518_s24_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_comparing_contrast_0_q <= 2'h0;
      sharpness_comparing_contrast_1_q <= 2'h0;
      sharpness_comparing_less_contrast_0_q <= 1'b0;
      sharpness_comparing_less_contrast_1_q <= 1'b0;
      counts_nearer_q <= 14'h0;
      good_known_q <= 1'b0;
    end else if (s24_en) begin
      sharpness_sums_detail_0_q <= and_368_s24_q ? select_1767 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_368_s24_q ? select_1778 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_1820 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_1822 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_1849 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_1855 : sharpness_comparing_less_contrast_1_q;
      counts_nearer_q <= select_1997;
      good_known_q <= select_2378;
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
      census_changes_values_2_left_q <= select_1735;
      census_changes_values_2_right_q <= select_1736;
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
  logic [13:0] product_s25_q;
  logic done_s25_q;
  logic [6:0] column_s25_q;
  logic and_368_s25_q;
  logic so_s25_q;
  logic less_402_s25_q;
  logic less_403_s25_q;
  logic less_404_s25_q;
  logic less_405_s25_q;
  logic less_406_s25_q;
  logic less_407_s25_q;
  logic less_408_s25_q;
  logic less_409_s25_q;
  logic less_410_s25_q;
  logic less_411_s25_q;
  logic less_412_s25_q;
  logic less_413_s25_q;
  logic less_414_s25_q;
  logic less_415_s25_q;
  logic less_416_s25_q;
  logic less_417_s25_q;
  logic less_418_s25_q;
  logic less_419_s25_q;
  logic less_420_s25_q;
  logic less_421_s25_q;
  logic less_422_s25_q;
  logic less_423_s25_q;
  logic less_424_s25_q;
  logic less_425_s25_q;
  logic and_433_s25_q;
  logic and_458_s25_q;
  logic and_459_s25_q;
  logic [8:0] sum_481_s25_q;
  logic equal_1337_s25_q;
  logic not_1338_s25_q;
  logic equal_1382_s25_q;
  logic [1:0] sum_1388_s25_q;
  logic equal_1390_s25_q;
  logic equal_1392_s25_q;
  logic equal_1394_s25_q;
  logic equal_1396_s25_q;
  logic equal_1398_s25_q;
  logic less_1410_s25_q;
  logic [19:0] select_1435_s25_q;
  logic [11:0] select_1440_s25_q;
  logic and_1444_s25_q;
  logic not_1456_s25_q;
  logic and_1517_s25_q;
  logic less_1518_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1523_s25_q;
  logic is_seen_s25_q;
  logic and_1588_s25_q;
  logic and_1598_s25_q;
  logic equal_1738_s25_q;
  logic [8:0] sum_1741_s25_q;
  logic equal_1788_s25_q;
  logic less_1789_s25_q;
  logic [17:0] select_1801_s25_q;
  logic [17:0] select_1811_s25_q;
  logic equal_1832_s25_q;
  logic and_1976_s25_q;
  logic and_2021_s25_q;
  logic [9:0] select_2025_s25_q;
  logic [9:0] select_2028_s25_q;
  logic [9:0] select_2035_s25_q;
  logic and_2056_s25_q;
  logic equal_2084_s25_q;
  logic and_2111_s25_q;
  logic and_2113_s25_q;
  logic [7:0] select_2141_s25_q;
  logic and_2150_s25_q;
  logic and_2158_s25_q;
  logic and_2165_s25_q;
  logic and_2172_s25_q;
  logic [11:0] select_2219_s25_q;
  logic and_2227_s25_q;
  logic [11:0] select_2234_s25_q;
  logic and_2245_s25_q;
  logic and_2249_s25_q;
  logic and_2281_s25_q;
  logic and_2289_s25_q;
  logic or_2356_s25_q;
  logic equal_2359_s25_q;
  logic select_2365_s25_q;
  logic equal_2376_s25_q;
  logic equal_2379_s25_q;
  logic equal_2381_s25_q;
  logic equal_2382_s25_q;
  logic and_2525_s25_q;
  logic and_2540_s25_q;
  logic [31:0] select_2598_s25_q;
  logic [9:0] select_2604_s25_q;
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
      counts_nearer_s25_q <= counts_nearer_q;
      registration_of_right_s25_q <= registration_of_right_s24_q;
      product_s25_q <= product_s24_q;
      done_s25_q <= done_s24_q;
      column_s25_q <= column_s24_q;
      and_368_s25_q <= and_368_s24_q;
      so_s25_q <= drew_q;
      less_402_s25_q <= less_402_s24_q;
      less_403_s25_q <= less_403_s24_q;
      less_404_s25_q <= less_404_s24_q;
      less_405_s25_q <= less_405_s24_q;
      less_406_s25_q <= less_406_s24_q;
      less_407_s25_q <= less_407_s24_q;
      less_408_s25_q <= less_408_s24_q;
      less_409_s25_q <= less_409_s24_q;
      less_410_s25_q <= less_410_s24_q;
      less_411_s25_q <= less_411_s24_q;
      less_412_s25_q <= less_412_s24_q;
      less_413_s25_q <= less_413_s24_q;
      less_414_s25_q <= less_414_s24_q;
      less_415_s25_q <= less_415_s24_q;
      less_416_s25_q <= less_416_s24_q;
      less_417_s25_q <= less_417_s24_q;
      less_418_s25_q <= less_418_s24_q;
      less_419_s25_q <= less_419_s24_q;
      less_420_s25_q <= less_420_s24_q;
      less_421_s25_q <= less_421_s24_q;
      less_422_s25_q <= less_422_s24_q;
      less_423_s25_q <= less_423_s24_q;
      less_424_s25_q <= less_424_s24_q;
      less_425_s25_q <= less_425_s24_q;
      and_433_s25_q <= and_433_s24_q;
      and_458_s25_q <= and_458_s24_q;
      and_459_s25_q <= and_459_s24_q;
      sum_481_s25_q <= sum_481[13:5];
      equal_1337_s25_q <= equal_1337_s24_q;
      not_1338_s25_q <= not_1338_s24_q;
      equal_1382_s25_q <= equal_1382_s24_q;
      sum_1388_s25_q <= sum_1388_s24_q;
      equal_1390_s25_q <= equal_1390_s24_q;
      equal_1392_s25_q <= equal_1392_s24_q;
      equal_1394_s25_q <= equal_1394_s24_q;
      equal_1396_s25_q <= equal_1396_s24_q;
      equal_1398_s25_q <= equal_1398_s24_q;
      less_1410_s25_q <= less_1410_s24_q;
      select_1435_s25_q <= equal_1434_s24_q ? registration_sums_rdata_s24_q[19:0] : 20'h0;
      select_1440_s25_q <= equal_1434_s24_q ? registration_sums_rdata_s24_q[31:20] : 12'h0;
      and_1444_s25_q <= and_1444_s24_q;
      not_1456_s25_q <= not_1456_s24_q;
      and_1517_s25_q <= and_1517_s24_q;
      less_1518_s25_q <= less_1518_s24_q;
      index_2_s25_q <= index_2_s24_q;
      sum_1523_s25_q <= sum_1523_s24_q;
      is_seen_s25_q <= is_seen;
      and_1588_s25_q <= is_seen & less_1587_s24_q;
      and_1598_s25_q <= and_1598_s24_q;
      equal_1738_s25_q <= equal_1738_s24_q;
      sum_1741_s25_q <= sum_1741[13:5];
      equal_1788_s25_q <= equal_1788_s24_q;
      less_1789_s25_q <= less_1789_s24_q;
      select_1801_s25_q <= select_1801;
      select_1811_s25_q <= select_1811;
      equal_1832_s25_q <= equal_1832_s24_q;
      and_1976_s25_q <= and_1976_s24_q;
      and_2021_s25_q <= not_1338_s24_q & (drew_q & and_2019);
      select_2025_s25_q <= select_2025_s24_q;
      select_2028_s25_q <= select_2028_s24_q;
      select_2035_s25_q <= select_2035;
      and_2056_s25_q <= drew_q & (ends_cell_s24_q & (not_1999_s24_q & and_2053));
      equal_2084_s25_q <= equal_2084_s24_q;
      and_2111_s25_q <= and_2111_s24_q;
      and_2113_s25_q <= and_2113_s24_q;
      select_2141_s25_q <= equal_1337_s24_q ? 8'h0 : (drew_q ? select_2139 : 8'h0);
      and_2150_s25_q <= and_2150;
      and_2158_s25_q <= and_2113_s24_q & less_2157_s24_q;
      and_2165_s25_q <= and_2113_s24_q & less_2164;
      and_2172_s25_q <= and_2113_s24_q & less_2171_s24_q;
      select_2219_s25_q <= select_2219;
      and_2227_s25_q <= equal_1337_s24_q & (x_s24_q[6] & and_2225);
      select_2234_s25_q <= select_2234;
      and_2245_s25_q <= equal_1337_s24_q & (x_s24_q[6] & and_2243);
      and_2249_s25_q <= and_2249;
      and_2281_s25_q <= equal_1337_s24_q & (x_s24_q[6] & and_2279);
      and_2289_s25_q <= x_s24_q[6] & and_2288;
      or_2356_s25_q <= or_2356_s24_q;
      equal_2359_s25_q <= equal_2359_s24_q;
      select_2365_s25_q <= select_2365_s24_q;
      equal_2376_s25_q <= equal_2376_s24_q;
      equal_2379_s25_q <= equal_2379_s24_q;
      equal_2381_s25_q <= equal_2381_s24_q;
      equal_2382_s25_q <= equal_2382_s24_q;
      and_2525_s25_q <= said_q;
      and_2540_s25_q <= and_2540;
      select_2598_s25_q <= select_2598;
      select_2604_s25_q <= select_2604_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_unproven_q;
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
  logic proven_q;
  // hls/stages/registration.hpp:260
  logic equal_1436;
  assign equal_1436 = sum_1388_s25_q == 2'h0;
  // hls/stages/registration.hpp:258
  logic [6:0] down;
  assign down = sum_1388_s25_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:260
  logic [13:0] select_1438;
  assign select_1438 = equal_1436 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:259
  logic [6:0] up;
  assign up = sum_1388_s25_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:261
  logic [6:0] select_1442;
  assign select_1442 = equal_1436 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/census.hpp:376
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1801_s25_q};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_1804;
  assign select_1804 = equal_1788_s25_q ? (less_1789_s25_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:376
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1811_s25_q};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_1814;
  assign select_1814 = equal_1788_s25_q ? (less_1789_s25_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2023;
  assign select_2023 = and_1976_s25_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2021_s25_q});
  logic [13:0] select_2037;
  assign select_2037 = and_1976_s25_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2035_s25_q});
  // hls/stages/agreement.hpp:392
  logic and_2057;
  assign and_2057 = not_1338_s25_q & and_2056_s25_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2059;
  assign select_2059 = and_1976_s25_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2057});
  // hls/stages/registration.hpp:132
  logic [13:0] sum_2142;
  assign sum_2142 = registration_half_across_q + {{6{select_2141_s25_q[7]}}, select_2141_s25_q};
  // hls/stages/agreement.hpp:392
  logic and_2146;
  assign and_2146 = not_1338_s25_q & (so_s25_q & (and_2113_s25_q & equal_2084_s25_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2148;
  assign select_2148 = and_2111_s25_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2146});
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2152;
  assign select_2152 = so_s25_q ? (equal_2084_s25_q ? {and_2150_s25_q, and_2113_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2153;
  assign select_2153 = equal_1337_s25_q ? 2'h0 : select_2152;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2154;
  assign sum_2154 = registration_half_votes_down_q + {{5{select_2153[1]}}, select_2153};
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2160;
  assign select_2160 = so_s25_q ? (equal_2084_s25_q ? {and_2158_s25_q, and_2113_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2161;
  assign select_2161 = equal_1337_s25_q ? 2'h0 : select_2160;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2162;
  assign sum_2162 = registration_half_votes_up_q + {{5{select_2161[1]}}, select_2161};
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2167;
  assign select_2167 = so_s25_q ? (equal_2084_s25_q ? {and_2165_s25_q, and_2113_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2168;
  assign select_2168 = equal_1337_s25_q ? 2'h0 : select_2167;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2169;
  assign sum_2169 = registration_half_half_votes_down_q + {{5{select_2168[1]}}, select_2168};
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2174;
  assign select_2174 = so_s25_q ? (equal_2084_s25_q ? {and_2172_s25_q, and_2113_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2175;
  assign select_2175 = equal_1337_s25_q ? 2'h0 : select_2174;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2176;
  assign sum_2176 = registration_half_half_votes_up_q + {{5{select_2175[1]}}, select_2175};
  // hls/stages/agreement.hpp:392
  logic and_2210;
  assign and_2210 = equal_1337_s25_q & (x_s25_q[6] & (not_1456_s25_q & less_1410_s25_q));
  logic [11:0] select_2221;
  assign select_2221 = equal_1337_s25_q ? (x_s25_q[6] ? select_2219_s25_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:247
  logic [13:0] sum_2229;
  assign sum_2229 = {{2{select_2221[11]}}, select_2221} + (and_2227_s25_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2236;
  assign select_2236 = equal_1337_s25_q ? (x_s25_q[6] ? select_2234_s25_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:248
  logic [13:0] sum_2238;
  assign sum_2238 = {{2{select_2236[11]}}, select_2236} + (and_2227_s25_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:241
  logic not_2250;
  assign not_2250 = ~and_2249_s25_q;
  logic less_2251;
  assign less_2251 = $signed({9'h1, {2{not_2250}}, and_2249_s25_q}) < $signed(registration_up_q[13:2]);
  logic select_2252;
  assign select_2252 = and_2245_s25_q ? less_2251 : registration_enough_q;
  // hls/stages/agreement.hpp:1095
  logic and_2256;
  assign and_2256 = x_s25_q[6] & (not_1456_s25_q & (less_1410_s25_q & (x_s25_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:392
  logic and_2257;
  assign and_2257 = equal_1337_s25_q & and_2256;
  // hls/stages/registration.hpp:237
  logic less_2258;
  assign less_2258 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2260;
  assign less_2260 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1095
  logic and_2265;
  assign and_2265 = x_s25_q[6] & (not_1456_s25_q & (less_1410_s25_q & (x_s25_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:392
  logic and_2266;
  assign and_2266 = equal_1337_s25_q & and_2265;
  // hls/stages/agreement.hpp:1095
  logic and_2273;
  assign and_2273 = x_s25_q[6] & (not_1456_s25_q & (less_1410_s25_q & (x_s25_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:239
  logic and_2291;
  assign and_2291 = registration_votes_up_q & registration_other_down_q;
  logic select_2293;
  assign select_2293 = registration_votes_down_q ? (registration_other_up_q | and_2291) : and_2291;
  // hls/stages/registration.hpp:137
  logic and_2295;
  assign and_2295 = (equal_1337_s25_q & and_2289_s25_q) & (registration_other_enough_q & select_2293);
  logic and_2297;
  assign and_2297 = registration_enough_q & ((and_2281_s25_q & (less_2260 | less_2258)) | and_2295);
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2384;
  assign select_2384 = equal_2381_s25_q ? counts_skin_unproven_q : (equal_2382_s25_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2379_s25_q ? counts_nearer_s25_q : select_2384;
  // hls/stages/agreement.hpp:392
  logic and_2555;
  assign and_2555 = equal_1337_s25_q & (equal_2376_s25_q & (cfg_prove_i & (~proven_q)));
  logic and_2589;
  assign and_2589 = equal_1337_s25_q & (x_s25_q[6] & (not_1456_s25_q | (4'hc < x_s25_q[5:2])));
  // hls/stages/agreement.hpp:1093
  logic [31:0] select_2599;
  assign select_2599 = equal_1398_s25_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_2598_s25_q;
  logic [31:0] select_2600;
  assign select_2600 = equal_1396_s25_q ? {8'h0, sharpness_sums_detail_0_s25_q} : select_2599;
  logic [31:0] select_2601;
  assign select_2601 = equal_1394_s25_q ? {8'h0, sharpness_sums_detail_1_s25_q} : select_2600;
  logic [31:0] select_2602;
  assign select_2602 = equal_1392_s25_q ? {8'h0, sharpness_sums_contrast_0_s25_q} : select_2601;
  logic [31:0] select_2603;
  assign select_2603 = equal_1390_s25_q ? {8'h0, sharpness_sums_contrast_1_s25_q} : select_2602;

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1523_s25_q, index_2_s25_q};
  logic map_we;
  assign map_we = s25_en & and_1598_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1588_s25_q, is_seen_s25_q};
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
      proven_q <= 1'b0;
    end else if (s25_en) begin
      sharpness_comparing_rest_0_q <= so_s25_q ? select_1804 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s25_q ? select_1814 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2023;
      counts_regions_bad_q <= select_2037;
      counts_skin_unproven_q <= select_2059;
      registration_half_across_q <= and_2111_s25_q ? 14'h0 : sum_2142;
      registration_half_measured_q <= select_2148;
      registration_half_votes_down_q <= and_2111_s25_q ? 7'h0 : sum_2154;
      registration_half_votes_up_q <= and_2111_s25_q ? 7'h0 : sum_2162;
      registration_half_half_votes_down_q <= and_2111_s25_q ? 7'h0 : sum_2169;
      registration_half_half_votes_up_q <= and_2111_s25_q ? 7'h0 : sum_2176;
      registration_down_q <= and_2210 ? sum_2229 : registration_down_q;
      registration_up_q <= and_2210 ? sum_2238 : registration_up_q;
      registration_enough_q <= select_2252;
      registration_votes_down_q <= and_2257 ? less_2258 : registration_votes_down_q;
      registration_votes_up_q <= and_2257 ? less_2260 : registration_votes_up_q;
      registration_other_enough_q <= and_2266 ? select_2252 : registration_other_enough_q;
      registration_other_down_q <= and_2266 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2266 ? registration_votes_up_q : registration_other_up_q;
      proven_q <= marks_first_s25_q ? done_s25_q : proven_q;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic census_columns_values_1_cell_2_of_skin_s26_q;
  logic x_s26_q;
  logic lower_half_s26_q;
  logic registration_of_right_s26_q;
  logic [13:0] product_s26_q;
  logic [6:0] column_s26_q;
  logic and_368_s26_q;
  logic so_s26_q;
  logic less_402_s26_q;
  logic less_403_s26_q;
  logic less_404_s26_q;
  logic less_405_s26_q;
  logic less_406_s26_q;
  logic less_407_s26_q;
  logic less_408_s26_q;
  logic less_409_s26_q;
  logic less_410_s26_q;
  logic less_411_s26_q;
  logic less_412_s26_q;
  logic less_413_s26_q;
  logic less_414_s26_q;
  logic less_415_s26_q;
  logic less_416_s26_q;
  logic less_417_s26_q;
  logic less_418_s26_q;
  logic less_419_s26_q;
  logic less_420_s26_q;
  logic less_421_s26_q;
  logic less_422_s26_q;
  logic less_423_s26_q;
  logic less_424_s26_q;
  logic less_425_s26_q;
  logic and_433_s26_q;
  logic and_458_s26_q;
  logic and_459_s26_q;
  logic less_482_s26_q;
  logic equal_1337_s26_q;
  logic equal_1382_s26_q;
  logic [1:0] sum_1388_s26_q;
  logic [19:0] sum_1439_s26_q;
  logic [11:0] sum_1443_s26_q;
  logic and_1444_s26_q;
  logic and_1517_s26_q;
  logic less_1518_s26_q;
  logic [1:0] map_rdata_s26_q;
  logic is_seen_s26_q;
  logic and_1588_s26_q;
  logic equal_1738_s26_q;
  logic and_1743_s26_q;
  logic equal_1788_s26_q;
  logic sum_s26_q;
  logic sum_2_s26_q;
  logic equal_1832_s26_q;
  logic select_1850_s26_q;
  logic select_1856_s26_q;
  logic [9:0] select_2025_s26_q;
  logic [9:0] select_2028_s26_q;
  logic not_2275_s26_q;
  logic and_2297_s26_q;
  logic or_2356_s26_q;
  logic equal_2359_s26_q;
  logic select_2365_s26_q;
  logic equal_2376_s26_q;
  logic and_2380_s26_q;
  logic [13:0] before_v_4_s26_q;
  logic not_2417_s26_q;
  logic or_2421_s26_q;
  logic and_2525_s26_q;
  logic and_2540_s26_q;
  logic and_2555_s26_q;
  logic and_2589_s26_q;
  logic [5:0] select_2591_s26_q;
  logic [31:0] select_2603_s26_q;
  logic [9:0] select_2604_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      census_columns_values_1_cell_2_of_skin_s26_q <= census_columns_values_1_cell_2_of_skin_s25_q;
      x_s26_q <= x_s25_q[6];
      lower_half_s26_q <= lower_half_s25_q;
      registration_of_right_s26_q <= registration_of_right_s25_q;
      product_s26_q <= product_s25_q;
      column_s26_q <= column_s25_q;
      and_368_s26_q <= and_368_s25_q;
      so_s26_q <= so_s25_q;
      less_402_s26_q <= less_402_s25_q;
      less_403_s26_q <= less_403_s25_q;
      less_404_s26_q <= less_404_s25_q;
      less_405_s26_q <= less_405_s25_q;
      less_406_s26_q <= less_406_s25_q;
      less_407_s26_q <= less_407_s25_q;
      less_408_s26_q <= less_408_s25_q;
      less_409_s26_q <= less_409_s25_q;
      less_410_s26_q <= less_410_s25_q;
      less_411_s26_q <= less_411_s25_q;
      less_412_s26_q <= less_412_s25_q;
      less_413_s26_q <= less_413_s25_q;
      less_414_s26_q <= less_414_s25_q;
      less_415_s26_q <= less_415_s25_q;
      less_416_s26_q <= less_416_s25_q;
      less_417_s26_q <= less_417_s25_q;
      less_418_s26_q <= less_418_s25_q;
      less_419_s26_q <= less_419_s25_q;
      less_420_s26_q <= less_420_s25_q;
      less_421_s26_q <= less_421_s25_q;
      less_422_s26_q <= less_422_s25_q;
      less_423_s26_q <= less_423_s25_q;
      less_424_s26_q <= less_424_s25_q;
      less_425_s26_q <= less_425_s25_q;
      and_433_s26_q <= and_433_s25_q;
      and_458_s26_q <= and_458_s25_q;
      and_459_s26_q <= and_459_s25_q;
      less_482_s26_q <= 9'h4 < sum_481_s25_q;
      equal_1337_s26_q <= equal_1337_s25_q;
      equal_1382_s26_q <= equal_1382_s25_q;
      sum_1388_s26_q <= sum_1388_s25_q;
      sum_1439_s26_q <= select_1435_s25_q + {{6{select_1438[13]}}, select_1438};
      sum_1443_s26_q <= select_1440_s25_q + {{5{select_1442[6]}}, select_1442};
      and_1444_s26_q <= and_1444_s25_q;
      and_1517_s26_q <= and_1517_s25_q;
      less_1518_s26_q <= less_1518_s25_q;
      map_rdata_s26_q <= map_rdata_q;
      is_seen_s26_q <= is_seen_s25_q;
      and_1588_s26_q <= and_1588_s25_q;
      equal_1738_s26_q <= equal_1738_s25_q;
      and_1743_s26_q <= and_458_s25_q & (9'h4 < sum_1741_s25_q);
      equal_1788_s26_q <= equal_1788_s25_q;
      sum_s26_q <= sum[0];
      sum_2_s26_q <= sum_2[0];
      equal_1832_s26_q <= equal_1832_s25_q;
      select_1850_s26_q <= sharpness_comparing_less_contrast_0_q;
      select_1856_s26_q <= sharpness_comparing_less_contrast_1_q;
      select_2025_s26_q <= select_2025_s25_q;
      select_2028_s26_q <= select_2028_s25_q;
      not_2275_s26_q <= ~(equal_1337_s25_q & and_2273);
      and_2297_s26_q <= and_2297;
      or_2356_s26_q <= or_2356_s25_q;
      equal_2359_s26_q <= equal_2359_s25_q;
      select_2365_s26_q <= select_2365_s25_q;
      equal_2376_s26_q <= equal_2376_s25_q;
      and_2380_s26_q <= equal_2379_s25_q & equal_2359_s25_q;
      before_v_4_s26_q <= before_v_4;
      not_2417_s26_q <= ~(equal_2382_s25_q & equal_2359_s25_q);
      or_2421_s26_q <= (equal_2382_s25_q | equal_2381_s25_q) | (x_s25_q[6:3] == 4'hf);
      and_2525_s26_q <= and_2525_s25_q;
      and_2540_s26_q <= and_2540_s25_q;
      and_2555_s26_q <= and_2555;
      and_2589_s26_q <= and_2589;
      select_2591_s26_q <= equal_1337_s25_q ? (x_s25_q[6] ? x_s25_q[5:0] : 6'h0) : 6'h0;
      select_2603_s26_q <= select_2603;
      select_2604_s26_q <= select_2604_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
  logic registration_moved_q;
  logic hides_q;
  // hls/stages/census.hpp:303
  logic and_483;
  assign and_483 = and_433_s26_q & less_482_s26_q;
  // hls/stages/census.hpp:306
  logic and_1744;
  assign and_1744 = and_458_s26_q & less_482_s26_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_1745;
  assign sum_1745 = census_left_misses_q + {{17{and_1744}}, and_1743_s26_q, 1'b0, and_1743_s26_q};
  // hls/stages/agreement.hpp:495
  logic [19:0] select_1747;
  assign select_1747 = and_368_s26_q ? (equal_1738_s26_q ? 20'h0 : sum_1745) : census_left_misses_q;
  // hls/stages/agreement.hpp:200
  logic [2:0] select_1816;
  assign select_1816 = equal_1788_s26_q ? {sharpness_comparing_product_0_q[1:0], sum_s26_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_1818;
  assign select_1818 = equal_1788_s26_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s26_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:382
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s26_q});
  // hls/stages/agreement.hpp:200
  logic select_1827;
  assign select_1827 = so_s26_q ? (equal_1788_s26_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:382
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s26_q});
  // hls/stages/agreement.hpp:200
  logic select_1830;
  assign select_1830 = equal_1788_s26_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:384
  logic xor_1833;
  assign xor_1833 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_1839;
  assign xor_1839 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/agreement.hpp:1159
  logic [14:0] over;
  assign over = {1'b0, product_s26_q} - {1'b0, before_v_4_s26_q};
  // hls/stages/agreement.hpp:1167
  logic select_2387;
  assign select_2387 = and_2380_s26_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1240
  logic [1:0] select_2541;
  assign select_2541 = and_2540_s26_q ? {and_1588_s26_q, is_seen_s26_q} : map_rdata_s26_q;
  // hls/stages/agreement.hpp:1241
  logic and_2542;
  assign and_2542 = proven_q & less_2530;
  // hls/stages/agreement.hpp:392
  logic and_2567;
  assign and_2567 = equal_1337_s26_q & (equal_2376_s26_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:1098
  logic or_2569;
  assign or_2569 = select_1850_s26_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_2605;
  assign select_2605 = equal_1382_s26_q ? select_2603_s26_q : {2'h0, select_2604_s26_q, select_2028_s26_q, select_2025_s26_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s26_q;
  logic fresh_we;
  assign fresh_we = s26_en & and_368_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s26_q, and_483, and_459_s26_q, and_458_s26_q, and_433_s26_q, less_425_s26_q, less_424_s26_q, less_423_s26_q, less_422_s26_q, less_421_s26_q, less_420_s26_q, less_419_s26_q, less_418_s26_q, less_417_s26_q, less_416_s26_q, less_415_s26_q, less_414_s26_q, less_413_s26_q, less_412_s26_q, less_411_s26_q, less_410_s26_q, less_409_s26_q, less_408_s26_q, less_407_s26_q, less_406_s26_q, less_405_s26_q, less_404_s26_q, less_403_s26_q, less_402_s26_q};
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

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1388_s26_q, lower_half_s26_q, registration_of_right_s26_q};
  logic registration_sums_we;
  assign registration_sums_we = s26_en & and_1444_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1443_s26_q, sum_1439_s26_q};
  end
`ifndef SYNTHESIS
  logic [3:0] registration_sums_raddr_s23_sim;
  logic registration_sums_re_s23_sim;
  logic [3:0] registration_sums_raddr_s24_sim;
  logic registration_sums_re_s24_sim;
  logic [3:0] registration_sums_raddr_s25_sim;
  logic registration_sums_re_s25_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_sums_re_s23_sim <= 1'b0;
      registration_sums_re_s24_sim <= 1'b0;
      registration_sums_re_s25_sim <= 1'b0;
    end else if (en_i) begin
      registration_sums_re_s23_sim <= registration_sums_re;
      registration_sums_raddr_s23_sim <= registration_sums_raddr;
      registration_sums_re_s24_sim <= registration_sums_re_s23_sim;
      registration_sums_raddr_s24_sim <= registration_sums_raddr_s23_sim;
      registration_sums_re_s25_sim <= registration_sums_re_s24_sim;
      registration_sums_raddr_s25_sim <= registration_sums_raddr_s24_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s23_sim && registration_sums_raddr_s23_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s24_sim && registration_sums_raddr_s24_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s25_sim && registration_sums_raddr_s25_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_waddr >= 4'd12) $error("registration_sums: write outside, address %0d", registration_sums_waddr);
    end
    if (rst_ni && registration_sums_re && registration_sums_raddr >= 4'd12) $error("registration_sums: read outside, address %0d", registration_sums_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_left_misses_q <= 20'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
      registration_moved_q <= 1'b0;
      hides_q <= 1'b0;
    end else if (s26_en) begin
      census_left_misses_q <= select_1747;
      sharpness_comparing_product_0_q <= so_s26_q ? select_1816 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s26_q ? select_1818 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_1827;
      sharpness_comparing_carry_1_q <= so_s26_q ? select_1830 : sharpness_comparing_carry_1_q;
      registration_moved_q <= not_2275_s26_q & (registration_moved_q | and_2297_s26_q);
      hides_q <= equal_1337_s26_q ? select_2387 : hides_q;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic so_s27_q;
  logic equal_1337_s27_q;
  logic and_1517_s27_q;
  logic less_1518_s27_q;
  logic equal_1788_s27_q;
  logic or_1834_s27_q;
  logic and_1835_s27_q;
  logic or_1840_s27_q;
  logic and_1841_s27_q;
  logic select_1856_s27_q;
  logic or_2356_s27_q;
  logic select_2365_s27_q;
  logic equal_2376_s27_q;
  logic select_2387_s27_q;
  logic and_2415_s27_q;
  logic not_2417_s27_q;
  logic or_2421_s27_q;
  logic and_2525_s27_q;
  logic and_2543_s27_q;
  logic and_2546_s27_q;
  logic and_2555_s27_q;
  logic and_2567_s27_q;
  logic or_2569_s27_q;
  logic and_2589_s27_q;
  logic [5:0] select_2591_s27_q;
  logic [31:0] select_2607_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      so_s27_q <= so_s26_q;
      equal_1337_s27_q <= equal_1337_s26_q;
      and_1517_s27_q <= and_1517_s26_q;
      less_1518_s27_q <= less_1518_s26_q;
      equal_1788_s27_q <= equal_1788_s26_q;
      or_1834_s27_q <= equal_1832_s26_q | xor_1833;
      and_1835_s27_q <= five_times[0] & xor_1833;
      or_1840_s27_q <= equal_1832_s26_q | xor_1839;
      and_1841_s27_q <= five_times_2[0] & xor_1839;
      select_1856_s27_q <= select_1856_s26_q;
      or_2356_s27_q <= or_2356_s26_q;
      select_2365_s27_q <= select_2365_s26_q;
      equal_2376_s27_q <= equal_2376_s26_q;
      select_2387_s27_q <= select_2387;
      and_2415_s27_q <= over[14] & equal_2359_s26_q;
      not_2417_s27_q <= not_2417_s26_q;
      or_2421_s27_q <= or_2421_s26_q;
      and_2525_s27_q <= and_2525_s26_q;
      and_2543_s27_q <= select_2541[0] & and_2542;
      and_2546_s27_q <= select_2541[1] & and_2542;
      and_2555_s27_q <= and_2555_s26_q;
      and_2567_s27_q <= and_2567;
      or_2569_s27_q <= or_2569;
      and_2589_s27_q <= and_2589_s26_q;
      select_2591_s27_q <= select_2591_s26_q;
      select_2607_s27_q <= equal_1337_s26_q ? (x_s26_q ? select_2605 : 32'h0) : 32'h0;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:384
  logic select_1836;
  assign select_1836 = or_1834_s27_q ? and_1835_s27_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:200
  logic select_1837;
  assign select_1837 = equal_1788_s27_q ? select_1836 : sharpness_comparing_less_detail_0_q;
  logic select_1838;
  assign select_1838 = so_s27_q ? select_1837 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:384
  logic select_1842;
  assign select_1842 = or_1840_s27_q ? and_1841_s27_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:200
  logic select_1843;
  assign select_1843 = equal_1788_s27_q ? select_1842 : sharpness_comparing_less_detail_1_q;
  logic select_1844;
  assign select_1844 = so_s27_q ? select_1843 : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:1096
  logic not_2388;
  assign not_2388 = ~hidden_for_q[7];
  logic [7:0] select_2390;
  assign select_2390 = select_2387_s27_q ? (hidden_for_q + {7'h0, not_2388}) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2392;
  assign select_2392 = equal_1337_s27_q ? (equal_2376_s27_q ? select_2390 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1165
  logic and_2418;
  assign and_2418 = too_much_q & not_2417_s27_q;
  // hls/stages/agreement.hpp:1166
  logic select_2423;
  assign select_2423 = and_2415_s27_q ? (and_2418 | or_2421_s27_q) : and_2418;
  // hls/stages/agreement.hpp:413
  logic select_2545;
  assign select_2545 = and_1517_s27_q ? (less_1518_s27_q ? and_2543_s27_q : seen_q) : seen_q;
  logic select_2548;
  assign select_2548 = and_1517_s27_q ? (less_1518_s27_q ? and_2546_s27_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:392
  logic and_2558;
  assign and_2558 = equal_1337_s27_q & (equal_2376_s27_q & (cfg_prove_i & or_2356_s27_q));
  // hls/stages/agreement.hpp:1176
  logic not_2560;
  assign not_2560 = ~(or_2356_s27_q | not_2549);
  // hls/stages/agreement.hpp:392
  logic and_2563;
  assign and_2563 = equal_2376_s27_q & (not_2560 & (select_2365_s27_q | select_2423));
  logic and_2576;
  assign and_2576 = equal_2376_s27_q & (not_2560 & (select_1844 | select_1856_s27_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s27_en) begin
      sharpness_comparing_less_detail_0_q <= select_1838;
      sharpness_comparing_less_detail_1_q <= select_1844;
      hidden_for_q <= select_2392;
      too_much_q <= equal_1337_s27_q ? select_2423 : too_much_q;
      seen_q <= select_2545;
      nearer_q <= select_2548;
    end
  end

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic equal_1337_s28_q;
  logic equal_2376_s28_q;
  logic and_2525_s28_q;
  logic and_2555_s28_q;
  logic and_2558_s28_q;
  logic and_2564_s28_q;
  logic and_2567_s28_q;
  logic and_2572_s28_q;
  logic and_2576_s28_q;
  logic not_2581_s28_q;
  logic and_2589_s28_q;
  logic [5:0] select_2591_s28_q;
  logic [31:0] select_2607_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      equal_1337_s28_q <= equal_1337_s27_q;
      equal_2376_s28_q <= equal_2376_s27_q;
      and_2525_s28_q <= and_2525_s27_q;
      and_2555_s28_q <= and_2555_s27_q;
      and_2558_s28_q <= and_2558;
      and_2564_s28_q <= equal_1337_s27_q & and_2563;
      and_2567_s28_q <= and_2567_s27_q;
      and_2572_s28_q <= equal_2376_s27_q & (not_2560 & (select_1838 | or_2569_s27_q));
      and_2576_s28_q <= and_2576;
      not_2581_s28_q <= ~(select_2390 < cfg_hidden_frames_i);
      and_2589_s28_q <= and_2589_s27_q;
      select_2591_s28_q <= select_2591_s27_q;
      select_2607_s28_q <= select_2607_s27_q;
    end
  end

  // Stage 28 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:1098
  logic and_2583;
  assign and_2583 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_2581_s28_q);

  logic [7:0] pixel_0_s29_q;
  logic [7:0] pixel_1_s29_q;
  logic saturated_s29_q;
  logic mask_s29_q;
  logic marks_first_s29_q;
  logic marks_last_s29_q;
  logic and_2525_s29_q;
  logic or_2550_s29_q;
  logic and_2551_s29_q;
  logic and_2555_s29_q;
  logic and_2558_s29_q;
  logic and_2564_s29_q;
  logic and_2567_s29_q;
  logic and_2573_s29_q;
  logic and_2577_s29_q;
  logic and_2585_s29_q;
  logic and_2589_s29_q;
  logic [5:0] select_2591_s29_q;
  logic [31:0] select_2607_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      and_2525_s29_q <= and_2525_s28_q;
      or_2550_s29_q <= not_2549 | seen_q;
      and_2551_s29_q <= cfg_prove_i & nearer_q;
      and_2555_s29_q <= and_2555_s28_q;
      and_2558_s29_q <= and_2558_s28_q;
      and_2564_s29_q <= and_2564_s28_q;
      and_2567_s29_q <= and_2567_s28_q;
      and_2573_s29_q <= equal_1337_s28_q & and_2572_s28_q;
      and_2577_s29_q <= equal_1337_s28_q & and_2576_s28_q;
      and_2585_s29_q <= equal_1337_s28_q & (equal_2376_s28_q & and_2583);
      and_2589_s29_q <= and_2589_s28_q;
      select_2591_s29_q <= select_2591_s28_q;
      select_2607_s29_q <= select_2607_s28_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s29_q;
  assign pixel_1_o = pixel_1_s29_q;
  assign saturated_o = saturated_s29_q;
  assign mask_o = mask_s29_q;
  assign marks_first_o = marks_first_s29_q;
  assign marks_last_o = marks_last_s29_q;
  assign marks_seen_o = or_2550_s29_q;
  assign marks_nearer_o = and_2551_s29_q;
  assign verdict_valid_o = and_2525_s29_q;
  assign verdict_unproven_yet_o = and_2555_s29_q;
  assign verdict_untextured_o = and_2558_s29_q;
  assign verdict_disagree_o = and_2564_s29_q;
  assign verdict_moved_o = and_2567_s29_q;
  assign verdict_unsharp_left_o = and_2573_s29_q;
  assign verdict_unsharp_right_o = and_2577_s29_q;
  assign verdict_hidden_o = and_2585_s29_q;
  assign frame_valid_o = and_2589_s29_q;
  assign frame_index_o = select_2591_s29_q;
  assign frame_word_o = select_2607_s29_q;
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
  assign unused_bits = ^{over[13:0], sum_2128[0], sum_2124[0], sum_2099[1:0], sum_2098[1:0], sum_2094[0], sum_2081[0], detail_4[1:0], detail_3[1:0], sum_1741[4:0], sum_481[4:0], cfg_width_i[3:0]};

endmodule
