// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 28 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1918 bits, pipeline 6067 bits, memories 93264 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q, valid_s28_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en, s27_en;
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

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_1951;
  assign sum_1951 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_2324;
  assign difference_2324 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_2528;
  assign less_2528 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_2529;
  assign sum_2529 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_2547;
  assign not_2547 = ~cfg_prove_i;

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
  // hls/stages/census.hpp:88
  logic equal_327;
  assign equal_327 = select_326_s1_q[1:0] == 2'h0;
  // hls/stages/census.hpp:35
  logic [6:0] select_329;
  assign select_329 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:40
  logic or_334;
  assign or_334 = sample_pair_first_s1_q | raster_at_live_q;
  logic [3:0] select_347;
  assign select_347 = sample_pair_first_s1_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:213
  logic whole;
  assign whole = equal_327 ? sample_present_s1_q : (sample_present_s1_q & averager_running_mask_q);
  // hls/stages/agreement.hpp:215
  logic [6:0] column;
  assign column = sample_pair_whole_s1_q ? select_329 : 7'h0;
  // hls/stages/census.hpp:45
  logic equal_364;
  assign equal_364 = select_326_s1_q == 4'hf;
  // hls/stages/agreement.hpp:215
  logic [3:0] select_1601;
  assign select_1601 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (select_347 + 4'h1) : select_347) : raster_at_y_q;
  logic [6:0] select_1603;
  assign select_1603 = sample_pair_whole_s1_q ? (select_329 + {6'h0, equal_364}) : raster_at_column_q;
  logic select_1610;
  assign select_1610 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_334 & (~raster_final_row_q)) : or_334) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [10:0] select_1612;
  assign select_1612 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:215
  logic select_1616;
  assign select_1616 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      raster_at_column_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
    end else if (s1_en) begin
      raster_at_y_q <= select_1601;
      raster_at_column_q <= select_1603;
      raster_at_live_q <= select_1610;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_1612 : raster_rows_left_q;
      raster_final_row_q <= select_1616;
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
  // hls/stages/census.hpp:95
  logic [8:0] select_333;
  assign select_333 = equal_327_s2_q ? (equal_330_s2_q ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/census.hpp:40
  logic [6:0] select_427;
  assign select_427 = sample_pair_first_s2_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:215
  logic [6:0] row;
  assign row = sample_pair_whole_s2_q ? select_427 : 7'h0;
  // hls/stages/census.hpp:52
  logic [6:0] select_1605;
  assign select_1605 = sample_last_s2_q ? (select_427 + {6'h0, equal_365_s2_q}) : select_427;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_row_q <= sample_pair_whole_s2_q ? select_1605 : raster_at_row_q;
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
  // hls/stages/agreement.hpp:213
  logic and_342;
  assign and_342 = not_339_s3_q & (~(select_333_s3_q[8:5] == 4'hf));
  // hls/stages/census.hpp:105
  logic and_366;
  assign and_366 = equal_365_s3_q & and_342;
  // hls/stages/agreement.hpp:215
  logic and_368;
  assign and_368 = sample_pair_whole_s3_q & (equal_364_s3_q & and_366);
  // hls/stages/agreement.hpp:313
  logic equal_1857;
  assign equal_1857 = {last[7], column_s3_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:329
  logic [7:0] sum_1947;
  assign sum_1947 = {1'b0, row_s3_q} + 8'h1;

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
  logic equal_1857_s4_q;
  logic and_1858_s4_q;
  logic equal_1948_s4_q;
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
      equal_1857_s4_q <= equal_1857;
      and_1858_s4_q <= and_368 & equal_1857;
      equal_1948_s4_q <= {sum_1947[7], cfg_height_i[10:4]} == {1'b0, sum_1947[6:0]};
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
  // hls/stages/agreement.hpp:134
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:406
  logic equal_388;
  assign equal_388 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:397
  logic equal_391;
  assign equal_391 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:398
  logic equal_393;
  assign equal_393 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:368
  logic select_1861;
  assign select_1861 = (and_1858_s4_q | (~ends_cell_q)) ? and_1858_s4_q : ends_q;
  // hls/stages/agreement.hpp:374
  logic [2:0] now;
  assign now = select_1861 ? (and_1858_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:379
  logic [5:0] select_1865;
  assign select_1865 = select_1861 ? (and_1858_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_1868;
  assign select_1868 = select_1861 ? (following_last_shift_q & (~and_1858_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:380
  logic [7:0] select_1870;
  assign select_1870 = select_1861 ? (and_1858_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:146
  logic and_1871;
  assign and_1871 = run_last_shift_q & equal_391;
  // hls/stages/agreement.hpp:399
  logic select_1873;
  assign select_1873 = equal_391 ? (~run_last_shift_q) : equal_393;
  // hls/stages/agreement.hpp:403
  logic equal_1874;
  assign equal_1874 = run_phase_q == 3'h1;
  logic not_1877;
  assign not_1877 = ~select_1873;
  // hls/stages/agreement.hpp:406
  logic equal_1879;
  assign equal_1879 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:146
  logic and_1880;
  assign and_1880 = final_row_q & so;
  // hls/stages/agreement.hpp:403
  logic [1:0] select_1881;
  assign select_1881 = equal_1879 ? 2'h1 : {2{and_1880}};
  logic [2:0] select_1883;
  assign select_1883 = (and_1871 | (select_1873 | equal_1874)) ? (equal_1874 ? 3'h2 : {not_1877, {2{select_1873}}}) : (equal_388 ? 3'h6 : {select_1881[0], select_1881});
  // hls/stages/agreement.hpp:146
  logic and_1886;
  assign and_1886 = select_1873 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:413
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1889;
  assign select_1889 = (plan_shift_q[5] & select_1873) ? value : 7'h0;
  logic [1:0] or_1890;
  assign or_1890 = {2{so}} | select_1889[5:4];
  // hls/stages/agreement.hpp:416
  logic [7:0] or_1894;
  assign or_1894 = (select_1873 ? plan_columns_q : 8'h0) | ((equal_1874 | equal_1879) ? whole_q : 8'h0);
  logic [1:0] or_1895;
  assign or_1895 = {2{and_1871}} | or_1894[4:3];
  // hls/stages/agreement.hpp:417
  logic [7:0] or_1897;
  assign or_1897 = {or_1894[7:5], or_1895, or_1894[2:0]} | (equal_388 ? drawn_q : 8'h0);
  logic [4:0] or_1898;
  assign or_1898 = {5{so}} | {or_1897[6], or_1897[3:0]};
  // hls/stages/agreement.hpp:423
  logic not_1902;
  assign not_1902 = ~run_shift_q[5];
  logic [7:0] select_1905;
  assign select_1905 = equal_391 ? ({{7{not_1902}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:368
  logic [6:0] select_1909;
  assign select_1909 = and_1858_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:371
  logic [7:0] select_1911;
  assign select_1911 = select_1861 ? {select_1909[6], select_1909} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_1914;
  assign select_1914 = select_1861 ? (and_1858_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:314
  logic [6:0] select_1921;
  assign select_1921 = equal_1857_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:365
  logic [7:0] select_1925;
  assign select_1925 = and_368_s4_q ? (equal_1857_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_1928;
  assign select_1928 = and_368_s4_q ? (equal_1857_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:376
  logic select_1942;
  assign select_1942 = (ends_cell_q | select_1861) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_391 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:371
  logic and_1946;
  assign and_1946 = (~select_1861) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:365
  logic select_1950;
  assign select_1950 = and_368_s4_q ? (equal_1857_s4_q ? equal_1948_s4_q : final_row_q) : final_row_q;

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
      run_shift_q <= select_1865;
      run_last_shift_q <= select_1868;
      run_span_q <= select_1870;
      following_phase_q <= select_1883;
      following_shift_q <= select_1873 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_1886;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1889[6], or_1890, select_1889[3:0]};
      following_columns_q <= {or_1897[7], or_1898[4], or_1897[5:4], or_1898[3:0]};
      plan_shift_q <= equal_391 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_1905;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_1911;
      columns_left_q <= select_1914;
      last_q <= and_368_s4_q ? (equal_1857_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_368_s4_q ? select_1921 : least_q;
      whole_q <= select_1925;
      drawn_q <= select_1928;
      slot_q <= select_1861 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_1942;
      ends_q <= and_1946;
      final_row_q <= select_1950;
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
  logic equal_1335_s5_q;
  logic equal_1857_s5_q;
  logic and_1858_s5_q;
  logic select_1861_s5_q;
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
      equal_1335_s5_q <= run_phase_q == 3'h7;
      equal_1857_s5_q <= equal_1857_s4_q;
      and_1858_s5_q <= and_1858_s4_q;
      select_1861_s5_q <= select_1861;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:391
  logic [7:0] select_395;
  assign select_395 = run_shift_s5_q[5] ? x_s5_q : sum_394_s5_q;
  logic less_396;
  assign less_396 = {1'b0, last_s5_q} < select_395;
  // hls/stages/agreement.hpp:163
  logic not_397;
  assign not_397 = ~less_396;
  // hls/stages/agreement.hpp:596
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:746
  logic [5:0] sum_1417;
  assign sum_1417 = {1'b0, last_s5_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:373
  logic [6:0] select_1930;
  assign select_1930 = select_1861_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_1930;
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
  logic equal_1325_s6_q;
  logic equal_1335_s6_q;
  logic less_1418_s6_q;
  logic equal_1458_s6_q;
  logic not_1592_s6_q;
  logic equal_1857_s6_q;
  logic and_1858_s6_q;
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
      equal_1325_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1335_s6_q <= equal_1335_s5_q;
      less_1418_s6_q <= {1'b0, sum_1417, last_s5_q[1]} < x_s5_q;
      equal_1458_s6_q <= x_s5_q == {1'b0, last_s5_q};
      not_1592_s6_q <= ~({sum_1417, last_s5_q[1:0]} < x_s5_q);
      equal_1857_s6_q <= equal_1857_s5_q;
      and_1858_s6_q <= and_1858_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:391
  logic or_389;
  assign or_389 = so_s6_q | equal_388_s6_q;
  // hls/stages/agreement.hpp:527
  logic not_390;
  assign not_390 = ~or_389;
  // hls/stages/agreement.hpp:551
  logic select_484;
  assign select_484 = equal_391_s6_q ? not_397_s6_q : and_398_s6_q;
  // hls/stages/agreement.hpp:191
  logic and_509;
  assign and_509 = equal_391_s6_q & and_508_s6_q;
  logic select_510;
  assign select_510 = or_389 ? not_397_s6_q : and_509;
  // hls/stages/agreement.hpp:605
  logic or_515;
  assign or_515 = equal_513_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:617
  logic [6:0] right;
  assign right = sum_394_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1071; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
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

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1072; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
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

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1073; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
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
  logic select_1326_s7_q;
  logic equal_1335_s7_q;
  logic less_1418_s7_q;
  logic equal_1458_s7_q;
  logic not_1592_s7_q;
  logic equal_1857_s7_q;
  logic and_1858_s7_q;
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
      select_1326_s7_q <= or_515 ? equal_513_s6_q : equal_1325_s6_q;
      equal_1335_s7_q <= equal_1335_s6_q;
      less_1418_s7_q <= less_1418_s6_q;
      equal_1458_s7_q <= equal_1458_s6_q;
      not_1592_s7_q <= not_1592_s6_q;
      equal_1857_s7_q <= equal_1857_s6_q;
      and_1858_s7_q <= and_1858_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1070; read in stage 7, written in stage 25: 7 < 25 < 7 + DISTANCE.
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
  logic select_1326_s8_q;
  logic equal_1335_s8_q;
  logic less_1418_s8_q;
  logic equal_1458_s8_q;
  logic not_1592_s8_q;
  logic equal_1857_s8_q;
  logic and_1858_s8_q;
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
      select_1326_s8_q <= select_1326_s7_q;
      equal_1335_s8_q <= equal_1335_s7_q;
      less_1418_s8_q <= less_1418_s7_q;
      equal_1458_s8_q <= equal_1458_s7_q;
      not_1592_s8_q <= not_1592_s7_q;
      equal_1857_s8_q <= equal_1857_s7_q;
      and_1858_s8_q <= and_1858_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:449
  logic not_488;
  assign not_488 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:159
  logic and_523;
  assign and_523 = left_rdata_s8_q[44] & not_397_s8_q;
  logic and_524;
  assign and_524 = right_codes_rdata_s8_q[38] & not_397_s8_q;
  logic [11:0] select_525;
  assign select_525 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_526;
  assign select_526 = less_396_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_530;
  assign select_530 = and_523 ? (and_524 ? (~(select_525 ^ select_526)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:159
  logic and_546;
  assign and_546 = left_rdata_s8_q[60] & not_397_s8_q;
  logic and_547;
  assign and_547 = right_codes_rdata_s8_q[51] & not_397_s8_q;
  logic [11:0] select_548;
  assign select_548 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_549;
  assign select_549 = less_396_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_553;
  assign select_553 = and_546 ? (and_547 ? (~(select_548 ^ select_549)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:159
  logic and_563;
  assign and_563 = left_rdata_s8_q[76] & not_397_s8_q;
  logic and_564;
  assign and_564 = right_codes_rdata_s8_q[64] & not_397_s8_q;
  logic [11:0] select_565;
  assign select_565 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_566;
  assign select_566 = less_396_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_570;
  assign select_570 = and_563 ? (and_564 ? (~(select_565 ^ select_566)) : 12'h0) : 12'h0;
  logic [11:0] select_778;
  assign select_778 = (slot_s8_q[0] ? and_564 : and_547) ? (~(select_526 ^ (slot_s8_q[0] ? select_565 : select_548))) : 12'h0;
  // hls/stages/agreement.hpp:159
  logic and_795;
  assign and_795 = right_codes_rdata_s8_q[77] & not_397_s8_q;
  logic [11:0] select_797;
  assign select_797 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_801;
  assign select_801 = (slot_s8_q[0] ? and_795 : and_564) ? (~(select_549 ^ (slot_s8_q[0] ? select_797 : select_565))) : 12'h0;
  // hls/stages/agreement.hpp:541
  logic select_813;
  assign select_813 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_397_s8_q) : and_795;
  logic [11:0] select_815;
  assign select_815 = slot_s8_q[0] ? (less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_797;
  // hls/stages/agreement.hpp:159
  logic and_1024;
  assign and_1024 = right_codes_rdata_s8_q[25] & not_397_s8_q;
  // hls/stages/agreement.hpp:541
  logic select_1025;
  assign select_1025 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_397_s8_q) : and_1024;
  // hls/stages/agreement.hpp:159
  logic [11:0] select_1027;
  assign select_1027 = less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:541
  logic [11:0] select_1028;
  assign select_1028 = slot_s8_q[0] ? (less_396_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1027;
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1052;
  assign select_1052 = (slot_s8_q[0] ? and_1024 : and_524) ? (~(select_549 ^ (slot_s8_q[0] ? select_1027 : select_525))) : 12'h0;
  logic [11:0] select_1067;
  assign select_1067 = (slot_s8_q[0] ? and_524 : and_547) ? (~(select_566 ^ (slot_s8_q[0] ? select_525 : select_548))) : 12'h0;
  // hls/stages/agreement.hpp:719
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:723
  logic and_1341;
  assign and_1341 = (or_389_s8_q & (left_rdata_s8_q[61] & not_397_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:182
  logic and_1349;
  assign and_1349 = not_397_s8_q & (or_389_s8_q & (left_rdata_s8_q[63] & not_397_s8_q));
  // hls/stages/agreement.hpp:211
  logic and_1594;
  assign and_1594 = ends_cell_s8_q & (((7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0))) & not_1592_s8_q);
  // hls/stages/agreement.hpp:314
  logic select_1954;
  assign select_1954 = equal_1857_s8_q ? (~({row_s8_q, 1'b0} < {sum_1951, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:365
  logic and_2192;
  assign and_2192 = and_368_s8_q & (equal_1857_s8_q & (row_s8_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s8_en) begin
      row_q <= and_368_s8_q ? (equal_1857_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_368_s8_q ? select_1954 : lower_half_q;
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
  logic [6:0] sum_1321_s9_q;
  logic [6:0] right_s9_q;
  logic select_1326_s9_q;
  logic equal_1335_s9_q;
  logic and_1342_s9_q;
  logic and_1345_s9_q;
  logic and_1349_s9_q;
  logic and_1360_s9_q;
  logic less_1361_s9_q;
  logic less_1418_s9_q;
  logic equal_1458_s9_q;
  logic and_1595_s9_q;
  logic equal_1736_s9_q;
  logic equal_1857_s9_q;
  logic less_2110_s9_q;
  logic and_2193_s9_q;
  logic and_2195_s9_q;
  logic less_2302_s9_q;
  logic equal_2509_s9_q;
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
      sum_1321_s9_q <= x_s8_q[6:0] + {shift[5], shift};
      right_s9_q <= right_s8_q;
      select_1326_s9_q <= select_1326_s8_q;
      equal_1335_s9_q <= equal_1335_s8_q;
      and_1342_s9_q <= not_397_s8_q & and_1341;
      and_1345_s9_q <= (or_389_s8_q & (left_rdata_s8_q[62] & not_397_s8_q)) & and_1341;
      and_1349_s9_q <= and_1349;
      and_1360_s9_q <= cfg_nearer_below_i & shift[5];
      less_1361_s9_q <= $signed(6'h0) < $signed(shift);
      less_1418_s9_q <= less_1418_s8_q;
      equal_1458_s9_q <= equal_1458_s8_q;
      and_1595_s9_q <= so_s8_q & and_1594;
      equal_1736_s9_q <= (column_s8_q | row_s8_q) == 7'h0;
      equal_1857_s9_q <= equal_1857_s8_q;
      less_2110_s9_q <= 6'h4 < row_q[6:1];
      and_2193_s9_q <= and_1858_s8_q & and_2192;
      and_2195_s9_q <= and_1858_s8_q & (~and_2192);
      less_2302_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_2509_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:480
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
  // hls/stages/agreement.hpp:479
  logic or_602;
  assign or_602 = (select_530_s9_q[1:0] == 2'h3) | (select_530_s9_q[2] & (select_530_s9_q[0] | select_530_s9_q[1]));
  // hls/stages/agreement.hpp:481
  logic or_606;
  assign or_606 = (select_553_s9_q[7:6] == 2'h3) | (select_553_s9_q[8] & (select_553_s9_q[6] | select_553_s9_q[7]));
  logic or_610;
  assign or_610 = (select_553_s9_q[10:9] == 2'h3) | (select_553_s9_q[11] & (select_553_s9_q[9] | select_553_s9_q[10]));
  // hls/stages/agreement.hpp:479
  logic or_618;
  assign or_618 = (select_570_s9_q[7:6] == 2'h3) | (select_570_s9_q[8] & (~(select_570_s9_q[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_622;
  assign or_622 = (select_570_s9_q[1:0] == 2'h3) | (select_570_s9_q[2] & (select_570_s9_q[0] | select_570_s9_q[1]));
  logic or_626;
  assign or_626 = (select_570_s9_q[4:3] == 2'h3) | (select_570_s9_q[5] & (select_570_s9_q[3] | select_570_s9_q[4]));
  // hls/stages/agreement.hpp:480
  logic parity_629;
  assign parity_629 = ^{or_626, or_622, or_618};
  // hls/stages/agreement.hpp:479
  logic or_633;
  assign or_633 = (select_553_s9_q[4:3] == 2'h3) | (select_553_s9_q[5] & (select_553_s9_q[3] | select_553_s9_q[4]));
  // hls/stages/agreement.hpp:481
  logic or_637;
  assign or_637 = (select_570_s9_q[10:9] == 2'h3) | (select_570_s9_q[11] & (select_570_s9_q[9] | select_570_s9_q[10]));
  logic or_641;
  assign or_641 = (select_553_s9_q[1:0] == 2'h3) | (select_553_s9_q[2] & (select_553_s9_q[0] | select_553_s9_q[1]));
  // hls/stages/agreement.hpp:480
  logic parity_644;
  assign parity_644 = ^{or_641, or_637, or_633};
  logic parity_647;
  assign parity_647 = ^{or_641, or_637, or_633, or_626, or_622, or_618, or_610, or_606, or_602};
  // hls/stages/agreement.hpp:481
  logic or_652;
  assign or_652 = (parity_536 & parity_539) | ((^select_530_s9_q[11:9]) & (parity_536 | parity_539));
  logic and_655;
  assign and_655 = (^{select_553_s9_q[11:6], select_530_s9_q[2:0]}) & (parity_582 | parity_594);
  // hls/stages/agreement.hpp:479
  logic or_663;
  assign or_663 = (select_530_s9_q[10:9] == 2'h3) | (select_530_s9_q[11] & (select_530_s9_q[9] | select_530_s9_q[10]));
  // hls/stages/agreement.hpp:481
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
  // hls/stages/agreement.hpp:465
  logic [11:0] select_779;
  assign select_779 = and_523_s9_q ? select_778_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_785;
  assign parity_785 = ^select_779[5:3];
  logic parity_788;
  assign parity_788 = ^select_779[8:6];
  logic parity_791;
  assign parity_791 = ^select_779[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_802;
  assign select_802 = and_546_s9_q ? select_801_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_805;
  assign parity_805 = ^select_802[8:6];
  logic parity_808;
  assign parity_808 = ^select_802[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_819;
  assign select_819 = and_563_s9_q ? select_818_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
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
  // hls/stages/agreement.hpp:479
  logic or_851;
  assign or_851 = (select_779[1:0] == 2'h3) | (select_779[2] & (select_779[0] | select_779[1]));
  // hls/stages/agreement.hpp:481
  logic or_855;
  assign or_855 = (select_802[7:6] == 2'h3) | (select_802[8] & (select_802[6] | select_802[7]));
  logic or_859;
  assign or_859 = (select_802[10:9] == 2'h3) | (select_802[11] & (select_802[9] | select_802[10]));
  // hls/stages/agreement.hpp:479
  logic or_867;
  assign or_867 = (select_819[7:6] == 2'h3) | (select_819[8] & (~(select_819[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_871;
  assign or_871 = (select_819[1:0] == 2'h3) | (select_819[2] & (select_819[0] | select_819[1]));
  logic or_875;
  assign or_875 = (select_819[4:3] == 2'h3) | (select_819[5] & (select_819[3] | select_819[4]));
  // hls/stages/agreement.hpp:480
  logic parity_878;
  assign parity_878 = ^{or_875, or_871, or_867};
  // hls/stages/agreement.hpp:479
  logic or_882;
  assign or_882 = (select_802[4:3] == 2'h3) | (select_802[5] & (select_802[3] | select_802[4]));
  // hls/stages/agreement.hpp:481
  logic or_886;
  assign or_886 = (select_819[10:9] == 2'h3) | (select_819[11] & (select_819[9] | select_819[10]));
  logic or_890;
  assign or_890 = (select_802[1:0] == 2'h3) | (select_802[2] & (select_802[0] | select_802[1]));
  // hls/stages/agreement.hpp:480
  logic parity_893;
  assign parity_893 = ^{or_890, or_886, or_882};
  logic parity_896;
  assign parity_896 = ^{or_890, or_886, or_882, or_875, or_871, or_867, or_859, or_855, or_851};
  // hls/stages/agreement.hpp:481
  logic or_901;
  assign or_901 = (parity_785 & parity_788) | ((^select_779[11:9]) & (parity_785 | parity_788));
  logic and_904;
  assign and_904 = (^{select_802[11:6], select_779[2:0]}) & (parity_831 | parity_843);
  // hls/stages/agreement.hpp:479
  logic or_912;
  assign or_912 = (select_779[10:9] == 2'h3) | (select_779[11] & (select_779[9] | select_779[10]));
  // hls/stages/agreement.hpp:481
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
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1032;
  assign select_1032 = and_523_s9_q ? select_1031_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1038;
  assign parity_1038 = ^select_1032[5:3];
  logic parity_1041;
  assign parity_1041 = ^select_1032[8:6];
  logic parity_1044;
  assign parity_1044 = ^select_1032[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1053;
  assign select_1053 = and_546_s9_q ? select_1052_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1056;
  assign parity_1056 = ^select_1053[8:6];
  logic parity_1059;
  assign parity_1059 = ^select_1053[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1068;
  assign select_1068 = and_563_s9_q ? select_1067_s9_q : 12'h0;
  // hls/stages/agreement.hpp:480
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
  // hls/stages/agreement.hpp:479
  logic or_1100;
  assign or_1100 = (select_1032[1:0] == 2'h3) | (select_1032[2] & (select_1032[0] | select_1032[1]));
  // hls/stages/agreement.hpp:481
  logic or_1104;
  assign or_1104 = (select_1053[7:6] == 2'h3) | (select_1053[8] & (select_1053[6] | select_1053[7]));
  logic or_1108;
  assign or_1108 = (select_1053[10:9] == 2'h3) | (select_1053[11] & (select_1053[9] | select_1053[10]));
  // hls/stages/agreement.hpp:479
  logic or_1116;
  assign or_1116 = (select_1068[7:6] == 2'h3) | (select_1068[8] & (~(select_1068[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1120;
  assign or_1120 = (select_1068[1:0] == 2'h3) | (select_1068[2] & (select_1068[0] | select_1068[1]));
  logic or_1124;
  assign or_1124 = (select_1068[4:3] == 2'h3) | (select_1068[5] & (select_1068[3] | select_1068[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1127;
  assign parity_1127 = ^{or_1124, or_1120, or_1116};
  // hls/stages/agreement.hpp:479
  logic or_1131;
  assign or_1131 = (select_1053[4:3] == 2'h3) | (select_1053[5] & (select_1053[3] | select_1053[4]));
  // hls/stages/agreement.hpp:481
  logic or_1135;
  assign or_1135 = (select_1068[10:9] == 2'h3) | (select_1068[11] & (select_1068[9] | select_1068[10]));
  logic or_1139;
  assign or_1139 = (select_1053[1:0] == 2'h3) | (select_1053[2] & (select_1053[0] | select_1053[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1142;
  assign parity_1142 = ^{or_1139, or_1135, or_1131};
  logic parity_1145;
  assign parity_1145 = ^{or_1139, or_1135, or_1131, or_1124, or_1120, or_1116, or_1108, or_1104, or_1100};
  // hls/stages/agreement.hpp:481
  logic or_1150;
  assign or_1150 = (parity_1038 & parity_1041) | ((^select_1032[11:9]) & (parity_1038 | parity_1041));
  logic and_1153;
  assign and_1153 = (^{select_1053[11:6], select_1032[2:0]}) & (parity_1080 | parity_1092);
  // hls/stages/agreement.hpp:479
  logic or_1161;
  assign or_1161 = (select_1032[10:9] == 2'h3) | (select_1032[11] & (select_1032[9] | select_1032[10]));
  // hls/stages/agreement.hpp:481
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
  // hls/stages/agreement.hpp:211
  logic [6:0] select_1374;
  assign select_1374 = so_s9_q ? x_s9_q[6:0] : (or_389_s9_q ? (less_396_s9_q ? 7'h0 : sum_1321_s9_q) : 7'h0);

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1074; read in stage 9, written in stage 17: 9 < 17 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_389_s9_q ? sum_1321_s9_q : right_s9_q;
  logic best_right_re;
  assign best_right_re = s9_en & select_510_s9_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

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
  logic [6:0] right_s10_q;
  logic select_1326_s10_q;
  logic equal_1335_s10_q;
  logic and_1342_s10_q;
  logic and_1345_s10_q;
  logic and_1349_s10_q;
  logic or_1363_s10_q;
  logic [6:0] select_1374_s10_q;
  logic less_1418_s10_q;
  logic equal_1458_s10_q;
  logic and_1595_s10_q;
  logic equal_1736_s10_q;
  logic equal_1857_s10_q;
  logic less_2110_s10_q;
  logic and_2193_s10_q;
  logic and_2195_s10_q;
  logic less_2302_s10_q;
  logic equal_2509_s10_q;
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
      right_s10_q <= right_s9_q;
      select_1326_s10_q <= select_1326_s9_q;
      equal_1335_s10_q <= equal_1335_s9_q;
      and_1342_s10_q <= and_1342_s9_q;
      and_1345_s10_q <= and_1345_s9_q;
      and_1349_s10_q <= and_1349_s9_q;
      or_1363_s10_q <= and_1360_s9_q | (cfg_nearer_above_i & less_1361_s9_q);
      select_1374_s10_q <= select_1374;
      less_1418_s10_q <= less_1418_s9_q;
      equal_1458_s10_q <= equal_1458_s9_q;
      and_1595_s10_q <= and_1595_s9_q;
      equal_1736_s10_q <= equal_1736_s9_q;
      equal_1857_s10_q <= equal_1857_s9_q;
      less_2110_s10_q <= less_2110_s9_q;
      and_2193_s10_q <= and_2193_s9_q;
      and_2195_s10_q <= and_2195_s9_q;
      less_2302_s10_q <= less_2302_s9_q;
      equal_2509_s10_q <= equal_2509_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:480
  logic parity_674;
  assign parity_674 = ^{or_671_s10_q, or_667_s10_q, or_663_s10_q};
  logic parity_689;
  assign parity_689 = ^{or_686_s10_q, or_682_s10_q, or_678_s10_q};
  logic parity_692;
  assign parity_692 = ^{or_686_s10_q, or_682_s10_q, or_678_s10_q, or_671_s10_q, or_667_s10_q, or_663_s10_q, or_656_s10_q, or_652_s10_q, and_648_s10_q};
  // hls/stages/agreement.hpp:481
  logic and_694;
  assign and_694 = parity_647_s10_q & parity_692;
  logic or_698;
  assign or_698 = and_695_s10_q | and_697_s10_q;
  logic and_701;
  assign and_701 = (^{or_656_s10_q, or_652_s10_q, and_648_s10_q}) & (parity_674 | parity_689);
  logic or_702;
  assign or_702 = (parity_674 & parity_689) | and_701;
  // hls/stages/agreement.hpp:480
  logic parity_720;
  assign parity_720 = ^{or_717_s10_q, or_713_s10_q, or_709_s10_q};
  // hls/stages/agreement.hpp:481
  logic or_724;
  assign or_724 = (or_652_s10_q & or_656_s10_q) | (and_648_s10_q & (or_652_s10_q | or_656_s10_q));
  logic or_728;
  assign or_728 = (or_667_s10_q & or_671_s10_q) | (or_663_s10_q & (or_667_s10_q | or_671_s10_q));
  logic or_732;
  assign or_732 = (or_682_s10_q & or_686_s10_q) | (or_678_s10_q & (or_682_s10_q | or_686_s10_q));
  // hls/stages/agreement.hpp:480
  logic parity_735;
  assign parity_735 = ^{or_732, or_728, or_724};
  logic parity_738;
  assign parity_738 = ^{or_732, or_728, or_724, or_717_s10_q, or_713_s10_q, or_709_s10_q, or_702, or_698, and_694};
  // hls/stages/agreement.hpp:481
  logic or_750;
  assign or_750 = (or_713_s10_q & or_717_s10_q) | (or_709_s10_q & (or_713_s10_q | or_717_s10_q));
  // hls/stages/agreement.hpp:480
  logic parity_923;
  assign parity_923 = ^{or_920_s10_q, or_916_s10_q, or_912_s10_q};
  logic parity_938;
  assign parity_938 = ^{or_935_s10_q, or_931_s10_q, or_927_s10_q};
  logic parity_941;
  assign parity_941 = ^{or_935_s10_q, or_931_s10_q, or_927_s10_q, or_920_s10_q, or_916_s10_q, or_912_s10_q, or_905_s10_q, or_901_s10_q, and_897_s10_q};
  // hls/stages/agreement.hpp:481
  logic and_943;
  assign and_943 = parity_896_s10_q & parity_941;
  logic or_947;
  assign or_947 = and_944_s10_q | (parity_862_s10_q & or_945_s10_q);
  logic and_950;
  assign and_950 = (^{or_905_s10_q, or_901_s10_q, and_897_s10_q}) & (parity_923 | parity_938);
  logic or_951;
  assign or_951 = (parity_923 & parity_938) | and_950;
  // hls/stages/agreement.hpp:480
  logic parity_969;
  assign parity_969 = ^{or_966_s10_q, or_962_s10_q, or_958_s10_q};
  // hls/stages/agreement.hpp:481
  logic or_973;
  assign or_973 = (or_901_s10_q & or_905_s10_q) | (and_897_s10_q & (or_901_s10_q | or_905_s10_q));
  logic or_977;
  assign or_977 = (or_916_s10_q & or_920_s10_q) | (or_912_s10_q & (or_916_s10_q | or_920_s10_q));
  logic or_981;
  assign or_981 = (or_931_s10_q & or_935_s10_q) | (or_927_s10_q & (or_931_s10_q | or_935_s10_q));
  // hls/stages/agreement.hpp:480
  logic parity_984;
  assign parity_984 = ^{or_981, or_977, or_973};
  logic parity_987;
  assign parity_987 = ^{or_981, or_977, or_973, or_966_s10_q, or_962_s10_q, or_958_s10_q, or_951, or_947, and_943};
  // hls/stages/agreement.hpp:481
  logic or_999;
  assign or_999 = (or_962_s10_q & or_966_s10_q) | (or_958_s10_q & (or_962_s10_q | or_966_s10_q));
  // hls/stages/agreement.hpp:480
  logic parity_1172;
  assign parity_1172 = ^{or_1169_s10_q, or_1165_s10_q, or_1161_s10_q};
  logic parity_1187;
  assign parity_1187 = ^{or_1184_s10_q, or_1180_s10_q, or_1176_s10_q};
  logic parity_1190;
  assign parity_1190 = ^{or_1184_s10_q, or_1180_s10_q, or_1176_s10_q, or_1169_s10_q, or_1165_s10_q, or_1161_s10_q, or_1154_s10_q, or_1150_s10_q, and_1146_s10_q};
  // hls/stages/agreement.hpp:481
  logic and_1192;
  assign and_1192 = parity_1145_s10_q & parity_1190;
  logic or_1196;
  assign or_1196 = and_1193_s10_q | (parity_1111_s10_q & or_1194_s10_q);
  logic and_1199;
  assign and_1199 = (^{or_1154_s10_q, or_1150_s10_q, and_1146_s10_q}) & (parity_1172 | parity_1187);
  logic or_1200;
  assign or_1200 = (parity_1172 & parity_1187) | and_1199;
  // hls/stages/agreement.hpp:480
  logic parity_1218;
  assign parity_1218 = ^{or_1215_s10_q, or_1211_s10_q, or_1207_s10_q};
  // hls/stages/agreement.hpp:481
  logic or_1222;
  assign or_1222 = (or_1150_s10_q & or_1154_s10_q) | (and_1146_s10_q & (or_1150_s10_q | or_1154_s10_q));
  logic or_1226;
  assign or_1226 = (or_1165_s10_q & or_1169_s10_q) | (or_1161_s10_q & (or_1165_s10_q | or_1169_s10_q));
  logic or_1230;
  assign or_1230 = (or_1180_s10_q & or_1184_s10_q) | (or_1176_s10_q & (or_1180_s10_q | or_1184_s10_q));
  // hls/stages/agreement.hpp:480
  logic parity_1233;
  assign parity_1233 = ^{or_1230, or_1226, or_1222};
  logic parity_1236;
  assign parity_1236 = ^{or_1230, or_1226, or_1222, or_1215_s10_q, or_1211_s10_q, or_1207_s10_q, or_1200, or_1196, and_1192};
  // hls/stages/agreement.hpp:481
  logic or_1248;
  assign or_1248 = (or_1211_s10_q & or_1215_s10_q) | (or_1207_s10_q & (or_1211_s10_q | or_1215_s10_q));

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
  logic [28:0] best_right_rdata_s11_q;
  logic select_1326_s11_q;
  logic equal_1335_s11_q;
  logic and_1342_s11_q;
  logic and_1345_s11_q;
  logic and_1349_s11_q;
  logic or_1363_s11_q;
  logic [6:0] select_1374_s11_q;
  logic less_1418_s11_q;
  logic equal_1458_s11_q;
  logic and_1595_s11_q;
  logic equal_1736_s11_q;
  logic equal_1857_s11_q;
  logic less_2110_s11_q;
  logic and_2193_s11_q;
  logic and_2195_s11_q;
  logic less_2302_s11_q;
  logic equal_2509_s11_q;
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
      best_right_rdata_s11_q <= best_right_rdata_q;
      select_1326_s11_q <= select_1326_s10_q;
      equal_1335_s11_q <= equal_1335_s10_q;
      and_1342_s11_q <= and_1342_s10_q;
      and_1345_s11_q <= and_1345_s10_q;
      and_1349_s11_q <= and_1349_s10_q;
      or_1363_s11_q <= or_1363_s10_q;
      select_1374_s11_q <= select_1374_s10_q;
      less_1418_s11_q <= less_1418_s10_q;
      equal_1458_s11_q <= equal_1458_s10_q;
      and_1595_s11_q <= and_1595_s10_q;
      equal_1736_s11_q <= equal_1736_s10_q;
      equal_1857_s11_q <= equal_1857_s10_q;
      less_2110_s11_q <= less_2110_s10_q;
      and_2193_s11_q <= and_2193_s10_q;
      and_2195_s11_q <= and_2195_s10_q;
      less_2302_s11_q <= less_2302_s10_q;
      equal_2509_s11_q <= equal_2509_s10_q;
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
  // hls/stages/agreement.hpp:481
  logic or_742;
  assign or_742 = and_739_s11_q | and_741_s11_q;
  logic or_746;
  assign or_746 = and_743_s11_q | and_745_s11_q;
  // hls/stages/agreement.hpp:480
  logic parity_759;
  assign parity_759 = ^{or_754_s11_q, or_750_s11_q, or_746, or_742};
  // hls/stages/agreement.hpp:481
  logic or_763;
  assign or_763 = (or_750_s11_q & or_754_s11_q) | (or_746 & (or_750_s11_q | or_754_s11_q));
  logic and_764;
  assign and_764 = or_742 & (^{or_754_s11_q, or_750_s11_q, or_746});
  // hls/stages/agreement.hpp:480
  logic xor_765;
  assign xor_765 = or_763 ^ and_764;
  // hls/stages/agreement.hpp:483
  logic and_766;
  assign and_766 = or_763 & and_764;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_767;
  assign select_767 = equal_391_s11_q ? {and_766, xor_765, parity_759, parity_738_s11_q, xor_693_s11_q, xor_598_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_389_s11_q ? 6'h0 : select_767;
  // hls/stages/agreement.hpp:481
  logic or_991;
  assign or_991 = and_988_s11_q | and_990_s11_q;
  logic or_995;
  assign or_995 = and_992_s11_q | and_994_s11_q;
  // hls/stages/agreement.hpp:480
  logic parity_1008;
  assign parity_1008 = ^{or_1003_s11_q, or_999_s11_q, or_995, or_991};
  // hls/stages/agreement.hpp:481
  logic or_1012;
  assign or_1012 = (or_999_s11_q & or_1003_s11_q) | (or_995 & (or_999_s11_q | or_1003_s11_q));
  logic and_1013;
  assign and_1013 = or_991 & (^{or_1003_s11_q, or_999_s11_q, or_995});
  // hls/stages/agreement.hpp:480
  logic xor_1014;
  assign xor_1014 = or_1012 ^ and_1013;
  // hls/stages/agreement.hpp:483
  logic and_1015;
  assign and_1015 = or_1012 & and_1013;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_1016;
  assign select_1016 = equal_391_s11_q ? {and_1015, xor_1014, parity_1008, parity_987_s11_q, xor_942_s11_q, xor_847_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_389_s11_q ? 6'h0 : select_1016;
  // hls/stages/agreement.hpp:481
  logic or_1240;
  assign or_1240 = and_1237_s11_q | and_1239_s11_q;
  logic or_1244;
  assign or_1244 = and_1241_s11_q | and_1243_s11_q;
  // hls/stages/agreement.hpp:480
  logic parity_1257;
  assign parity_1257 = ^{or_1252_s11_q, or_1248_s11_q, or_1244, or_1240};
  // hls/stages/agreement.hpp:481
  logic or_1261;
  assign or_1261 = (or_1248_s11_q & or_1252_s11_q) | (or_1244 & (or_1248_s11_q | or_1252_s11_q));
  logic and_1262;
  assign and_1262 = or_1240 & (^{or_1252_s11_q, or_1248_s11_q, or_1244});
  // hls/stages/agreement.hpp:480
  logic xor_1263;
  assign xor_1263 = or_1261 ^ and_1262;
  // hls/stages/agreement.hpp:483
  logic and_1264;
  assign and_1264 = or_1261 & and_1262;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_1265;
  assign select_1265 = equal_391_s11_q ? {and_1264, xor_1263, parity_1257, parity_1236_s11_q, xor_1191_s11_q, xor_1096_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_389_s11_q ? 6'h0 : select_1265;
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1297;
  assign sum_1297 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1300;
  assign sum_1300 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:727
  logic [6:0] chosen;
  assign chosen = slot_s11_q[2] ? best_right_rdata_s11_q[14:8] : best_right_rdata_s11_q[28:22];

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
  logic select_1326_s12_q;
  logic equal_1335_s12_q;
  logic and_1342_s12_q;
  logic and_1345_s12_q;
  logic and_1349_s12_q;
  logic less_1350_s12_q;
  logic [6:0] chosen_s12_q;
  logic or_1363_s12_q;
  logic [6:0] select_1374_s12_q;
  logic less_1418_s12_q;
  logic equal_1458_s12_q;
  logic and_1595_s12_q;
  logic equal_1736_s12_q;
  logic equal_1857_s12_q;
  logic less_2110_s12_q;
  logic and_2193_s12_q;
  logic and_2195_s12_q;
  logic less_2302_s12_q;
  logic equal_2509_s12_q;
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
      best_right_rdata_s12_q <= best_right_rdata_s11_q;
      select_1326_s12_q <= select_1326_s11_q;
      equal_1335_s12_q <= equal_1335_s11_q;
      and_1342_s12_q <= and_1342_s11_q;
      and_1345_s12_q <= and_1345_s11_q;
      and_1349_s12_q <= and_1349_s11_q;
      less_1350_s12_q <= 8'hb6 < best_left_rdata_s11_q[16:9];
      chosen_s12_q <= chosen;
      or_1363_s12_q <= or_1363_s11_q;
      select_1374_s12_q <= select_1374_s11_q;
      less_1418_s12_q <= less_1418_s11_q;
      equal_1458_s12_q <= equal_1458_s11_q;
      and_1595_s12_q <= and_1595_s11_q;
      equal_1736_s12_q <= equal_1736_s11_q;
      equal_1857_s12_q <= equal_1857_s11_q;
      less_2110_s12_q <= less_2110_s11_q;
      and_2193_s12_q <= and_2193_s11_q;
      and_2195_s12_q <= and_2195_s11_q;
      less_2302_s12_q <= less_2302_s11_q;
      equal_2509_s12_q <= equal_2509_s11_q;
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
  // hls/stages/agreement.hpp:585
  logic [5:0] select_769;
  assign select_769 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1293;
  assign sum_1293 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1303;
  assign select_1303 = (sum_1298_s12_q < sum_1301_s12_q) ? sum_1301_s12_q : sum_1298_s12_q;
  // hls/stages/agreement.hpp:726
  logic select_1352;
  assign select_1352 = slot_s12_q[2] ? less_1350_s12_q : (6'h2a < best_left_rdata_s12_q[39:34]);
  // hls/stages/agreement.hpp:733
  logic [8:0] difference_1355;
  assign difference_1355 = {2'h0, chosen_s12_q} - {1'b0, x_s12_q};
  // hls/stages/agreement.hpp:174
  logic [5:0] select_1957;
  assign select_1957 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_1958;
  assign select_1958 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1959;
  assign select_1959 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_1960;
  assign select_1960 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1961;
  assign select_1961 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1962;
  assign select_1962 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;

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
      middle_sum_columns_values_1_q <= select_1957;
      middle_sum_columns_values_2_q <= select_1958;
      middle_sum_columns_values_3_q <= select_1959;
      middle_sum_columns_values_4_q <= select_1960;
      middle_sum_columns_values_5_q <= select_1961;
      middle_sum_columns_values_6_q <= select_1962;
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
  logic select_1326_s13_q;
  logic equal_1335_s13_q;
  logic and_1342_s13_q;
  logic and_1345_s13_q;
  logic and_1349_s13_q;
  logic select_1352_s13_q;
  logic [9:0] sum_1356_s13_q;
  logic or_1363_s13_q;
  logic [6:0] select_1374_s13_q;
  logic less_1418_s13_q;
  logic equal_1458_s13_q;
  logic and_1595_s13_q;
  logic equal_1736_s13_q;
  logic equal_1857_s13_q;
  logic less_2110_s13_q;
  logic and_2193_s13_q;
  logic and_2195_s13_q;
  logic and_2202_s13_q;
  logic less_2302_s13_q;
  logic equal_2509_s13_q;
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
      select_1326_s13_q <= select_1326_s12_q;
      equal_1335_s13_q <= equal_1335_s12_q;
      and_1342_s13_q <= and_1342_s12_q;
      and_1345_s13_q <= and_1345_s12_q;
      and_1349_s13_q <= and_1349_s12_q;
      select_1352_s13_q <= select_1352;
      sum_1356_s13_q <= {difference_1355[8], difference_1355} + 10'h1;
      or_1363_s13_q <= or_1363_s12_q;
      select_1374_s13_q <= select_1374_s12_q;
      less_1418_s13_q <= less_1418_s12_q;
      equal_1458_s13_q <= equal_1458_s12_q;
      and_1595_s13_q <= and_1595_s12_q;
      equal_1736_s13_q <= equal_1736_s12_q;
      equal_1857_s13_q <= equal_1857_s12_q;
      less_2110_s13_q <= less_2110_s12_q;
      and_2193_s13_q <= and_2193_s12_q;
      and_2195_s13_q <= and_2195_s12_q;
      and_2202_s13_q <= ends_cell_s12_q & so_s12_q;
      less_2302_s13_q <= less_2302_s12_q;
      equal_2509_s13_q <= equal_2509_s12_q;
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
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/agreement.hpp:595
  logic less_518;
  assign less_518 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_520;
  assign less_520 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:585
  logic [7:0] sum_772;
  assign sum_772 = {difference_770_s13_q[6], difference_770_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1022;
  assign sum_1022 = {difference_1019_s13_q[6], difference_1019_s13_q} + (equal_1020_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1270;
  assign sum_1270 = {difference_1268_s13_q[6], difference_1268_s13_q} + (equal_1020_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:562
  logic [6:0] select_1295;
  assign select_1295 = slot_s13_q[0] ? chosen_near_q : sum_1294_s13_q;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1305;
  assign select_1305 = (select_1295 < select_1303_s13_q) ? select_1303_s13_q : select_1295;
  // hls/stages/agreement.hpp:182
  logic and_1358;
  assign and_1358 = (and_1345_s13_q & select_1352_s13_q) & ({{22{sum_1356_s13_q[9]}}, sum_1356_s13_q} < 32'h3);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1456;
  assign sum_1456 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:174
  logic [6:0] select_1969;
  assign select_1969 = slot_s13_q[0] ? 7'h0 : sum_1294_s13_q;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1971;
  assign select_1971 = (select_1969 < select_1303_s13_q) ? select_1303_s13_q : select_1969;
  // hls/stages/agreement.hpp:191
  logic [7:0] select_2062;
  assign select_2062 = or_389_s13_q ? (less_396_s13_q ? 8'h0 : best_left_rdata_s13_q[32:25]) : 8'h0;
  logic [7:0] select_2064;
  assign select_2064 = or_389_s13_q ? (less_396_s13_q ? 8'h0 : best_left_rdata_s13_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:206
  logic [16:0] select_2084;
  assign select_2084 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/registration.hpp:121
  logic [15:0] select_2196;
  assign select_2196 = and_2195_s13_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:124
  logic [23:0] select_2198;
  assign select_2198 = and_2193_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2196[15]}}, select_2196});
  // hls/stages/registration.hpp:122
  logic [15:0] select_2199;
  assign select_2199 = and_2195_s13_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2199[15]}}, select_2199};
  // hls/stages/registration.hpp:124
  logic [27:0] select_2201;
  assign select_2201 = and_2193_s13_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:117
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2202_s13_q ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:143
  logic [8:0] select_2314;
  assign select_2314 = so_s13_q ? (and_2202_s13_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2316;
  assign sum_2316 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2317;
  assign select_2317 = sum_1456[5] ? {1'b1, sum_1456[4:0], region_across_rest_q[2:0]} : sum_2316;
  // hls/stages/agreement.hpp:314
  logic [8:0] select_2319;
  assign select_2319 = equal_1857_s13_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_2322;
  assign select_2322 = equal_1857_s13_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_near_q <= 7'h0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s13_en) begin
      chosen_near_q <= select_1971;
      registration_slope_row_q <= select_2198;
      registration_slope_change_q <= select_2201;
      registration_slope_q <= so_s13_q ? column_5 : {registration_slope_row_q, 4'h0};
      region_across_rest_q <= select_2314;
      region_across_back_q <= so_s13_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2317;
      columns_begin_rest_q <= and_368_s13_q ? select_2319 : columns_begin_rest_q;
      columns_begin_back_q <= and_368_s13_q ? select_2322 : columns_begin_back_q;
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
  logic [11:0] registration_slope_s14_q;
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
  logic select_1326_s14_q;
  logic equal_1335_s14_q;
  logic and_1342_s14_q;
  logic and_1346_s14_q;
  logic and_1349_s14_q;
  logic and_1359_s14_q;
  logic and_1364_s14_q;
  logic [6:0] select_1374_s14_q;
  logic less_1418_s14_q;
  logic sum_1456_s14_q;
  logic equal_1458_s14_q;
  logic and_1595_s14_q;
  logic equal_1736_s14_q;
  logic equal_1857_s14_q;
  logic [7:0] select_2062_s14_q;
  logic [7:0] select_2064_s14_q;
  logic [16:0] select_2084_s14_q;
  logic less_2110_s14_q;
  logic less_2302_s14_q;
  logic equal_2509_s14_q;
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
      registration_slope_s14_q <= registration_slope_q[27:16];
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
      select_1326_s14_q <= select_1326_s13_q;
      equal_1335_s14_q <= equal_1335_s13_q;
      and_1342_s14_q <= and_1342_s13_q;
      and_1346_s14_q <= not_397_s13_q & and_1345_s13_q;
      and_1349_s14_q <= and_1349_s13_q;
      and_1359_s14_q <= not_397_s13_q & and_1358;
      and_1364_s14_q <= and_1358 & or_1363_s13_q;
      select_1374_s14_q <= select_1374_s13_q;
      less_1418_s14_q <= less_1418_s13_q;
      sum_1456_s14_q <= sum_1456[5];
      equal_1458_s14_q <= equal_1458_s13_q;
      and_1595_s14_q <= and_1595_s13_q;
      equal_1736_s14_q <= equal_1736_s13_q;
      equal_1857_s14_q <= equal_1857_s13_q;
      select_2062_s14_q <= select_2062;
      select_2064_s14_q <= select_2064;
      select_2084_s14_q <= select_2084;
      less_2110_s14_q <= less_2110_s13_q;
      less_2302_s14_q <= less_2302_s13_q;
      equal_2509_s14_q <= equal_2509_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [7:0] chosen_score_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  // hls/stages/agreement.hpp:562
  logic [7:0] select_773;
  assign select_773 = slot_s14_q[0] ? chosen_score_q : sum_772_s14_q;
  // hls/stages/agreement.hpp:558
  logic [7:0] select_1272;
  assign select_1272 = less_1271_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1273;
  assign less_1273 = select_773 < select_1272;
  // hls/stages/agreement.hpp:599
  logic [7:0] of_best;
  assign of_best = and_522_s14_q ? (less_1273 ? select_1272 : select_773) : 8'h0;
  // hls/stages/agreement.hpp:527
  logic not_1279;
  assign not_1279 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:559
  logic [1:0] select_1280;
  assign select_1280 = less_1271_s14_q ? {slot_s14_q[0], not_1279} : 2'h0;
  logic [2:0] select_1282;
  assign select_1282 = less_1273 ? {select_1280, not_1279} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:600
  logic [6:0] of_near;
  assign of_near = and_522_s14_q ? select_1305_s14_q : 7'h0;
  // hls/stages/agreement.hpp:182
  logic and_1365;
  assign and_1365 = not_397_s14_q & and_1364_s14_q;
  // hls/stages/agreement.hpp:191
  logic [8:0] select_1366;
  assign select_1366 = less_396_s14_q ? 9'h0 : best_left_rdata_s14_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_389_s14_q ? {select_1366, and_1365, and_1359_s14_q, and_1349_s14_q, and_1346_s14_q, and_1342_s14_q, not_397_s14_q} : 15'h0;
  // hls/stages/agreement.hpp:197
  logic right_2;
  assign right_2 = inside_v[0] & less_1418_s14_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:174
  logic [7:0] select_1966;
  assign select_1966 = slot_s14_q[0] ? 8'h0 : sum_772_s14_q;
  // hls/stages/agreement.hpp:558
  logic less_1967;
  assign less_1967 = select_1966 < select_1272;
  // hls/stages/agreement.hpp:191
  logic [7:0] select_2060;
  assign select_2060 = or_389_s14_q ? (less_396_s14_q ? 8'h0 : best_left_rdata_s14_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2062_s14_q} - {1'b0, select_2064_s14_q};
  // hls/stages/registration.hpp:206
  logic [13:0] select_2086;
  assign select_2086 = ($signed(10'h0) < $signed(select_2084_s14_q[16:7])) ? 14'h7f : select_2084_s14_q[13:0];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_score_q <= 8'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
    end else if (s14_en) begin
      chosen_score_q <= less_1967 ? select_1272 : select_1966;
      chosen_place_q <= less_1967 ? {select_1280, not_1279} : 3'h2;
      before_0_q <= select_1966;
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
  logic select_1326_s15_q;
  logic or_1332_s15_q;
  logic equal_1335_s15_q;
  logic [13:0] inside_v_s15_q;
  logic [6:0] select_1374_s15_q;
  logic and_1377_s15_q;
  logic right_2_s15_q;
  logic sum_1456_s15_q;
  logic equal_1458_s15_q;
  logic textured_s15_q;
  logic and_1595_s15_q;
  logic equal_1736_s15_q;
  logic equal_1857_s15_q;
  logic [7:0] select_2060_s15_q;
  logic rise_s15_q;
  logic [7:0] select_2066_s15_q;
  logic [7:0] xor_2071_s15_q;
  logic [13:0] select_2086_s15_q;
  logic and_2111_s15_q;
  logic less_2116_s15_q;
  logic less_2302_s15_q;
  logic equal_2509_s15_q;
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
      registration_slope_s15_q <= registration_slope_s14_q;
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
      select_1326_s15_q <= select_1326_s14_q;
      or_1332_s15_q <= select_1326_s14_q | (best_right_rdata_s14_q[21:15] < of_near);
      equal_1335_s15_q <= equal_1335_s14_q;
      inside_v_s15_q <= {inside_v[14:3], inside_v[1:0]};
      select_1374_s15_q <= select_1374_s14_q;
      and_1377_s15_q <= equal_388_s14_q & inside_v[4];
      right_2_s15_q <= right_2;
      sum_1456_s15_q <= sum_1456_s14_q;
      equal_1458_s15_q <= equal_1458_s14_q;
      textured_s15_q <= textured;
      and_1595_s15_q <= and_1595_s14_q;
      equal_1736_s15_q <= equal_1736_s14_q;
      equal_1857_s15_q <= equal_1857_s14_q;
      select_2060_s15_q <= select_2060;
      rise_s15_q <= rise[8];
      select_2066_s15_q <= rise[8] ? select_2062_s14_q : select_2064_s14_q;
      xor_2071_s15_q <= rise[7:0] ^ {8{rise[8]}};
      select_2086_s15_q <= select_2086;
      and_2111_s15_q <= inside_v[4] & less_2110_s14_q;
      less_2116_s15_q <= select_2062_s14_q < select_2064_s14_q;
      less_2302_s15_q <= less_2302_s14_q;
      equal_2509_s15_q <= equal_2509_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:98
  logic and_343;
  assign and_343 = sample_pair_whole_s15_q & and_342_s15_q;
  // hls/stages/agreement.hpp:608
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
  // hls/stages/agreement.hpp:609
  logic [1:0] select_1310;
  assign select_1310 = equal_1285 ? 2'h0 : {not_1287, equal_1286};
  logic [7:0] select_1312;
  assign select_1312 = select_1310[1] ? before_2_q : (select_1310[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:620
  logic or_1328;
  assign or_1328 = select_1326_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:746
  logic not_1336;
  assign not_1336 = ~equal_1335_s15_q;
  // hls/stages/agreement.hpp:211
  logic and_1368;
  assign and_1368 = ends_cell_s15_q & inside_v_s15_q[0];
  logic and_1370;
  assign and_1370 = not_1336 & (so_s15_q & and_1368);
  // hls/stages/agreement.hpp:788
  logic or_1459;
  assign or_1459 = (~sum_1456_s15_q) | equal_1458_s15_q;
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2067;
  assign difference_2067 = {1'b0, select_2060_s15_q} - {1'b0, select_2066_s15_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2067[8] ? 8'h0 : difference_2067[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s15_q} + {1'b0, xor_2071_s15_q};
  // hls/stages/registration.hpp:201
  logic [9:0] select_2087;
  assign select_2087 = inside_v_s15_q[9] ? select_2086_s15_q[9:0] : 10'h0;
  logic [8:0] difference_2089;
  assign difference_2089 = select_2087[9:1] - (inside_v_s15_q[10] ? select_2086_s15_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:199
  logic [12:0] sum_2092;
  assign sum_2092 = (inside_v_s15_q[5] ? select_2086_s15_q[13:1] : 13'h0) + (inside_v_s15_q[6] ? select_2086_s15_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:200
  logic [11:0] select_2093;
  assign select_2093 = inside_v_s15_q[7] ? select_2086_s15_q[11:0] : 12'h0;
  logic [10:0] sum_2095;
  assign sum_2095 = select_2093[11:1] + (inside_v_s15_q[8] ? select_2086_s15_q[10:0] : 11'h0);

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:146; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_333_s15_q;
  logic averager_memory_re;
  assign averager_memory_re = s15_en & and_343;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1075; read in stage 15, written in stage 16: 15 < 16 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s15_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s15_en & and_1370;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1099; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s15_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s15_en & and_1370;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

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
  logic and_343_s16_q;
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
  logic or_1328_s16_q;
  logic [6:0] select_1333_s16_q;
  logic [6:0] select_1334_s16_q;
  logic equal_1335_s16_q;
  logic not_1336_s16_q;
  logic [13:0] inside_v_s16_q;
  logic and_1370_s16_q;
  logic [6:0] select_1374_s16_q;
  logic and_1379_s16_q;
  logic right_2_s16_q;
  logic sum_1456_s16_q;
  logic and_1462_s16_q;
  logic textured_s16_q;
  logic and_1596_s16_q;
  logic equal_1736_s16_q;
  logic equal_1857_s16_q;
  logic [7:0] wide_s16_q;
  logic [8:0] size_3_s16_q;
  logic select_2087_s16_q;
  logic [8:0] difference_2089_s16_q;
  logic [11:0] sum_2092_s16_q;
  logic select_2093_s16_q;
  logic [10:0] sum_2095_s16_q;
  logic and_2111_s16_q;
  logic less_2116_s16_q;
  logic less_2302_s16_q;
  logic select_2345_s16_q;
  logic equal_2509_s16_q;
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
      and_343_s16_q <= and_343;
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
      or_1328_s16_q <= or_1328;
      select_1333_s16_q <= or_1332_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1334_s16_q <= or_1332_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1335_s16_q <= equal_1335_s15_q;
      not_1336_s16_q <= not_1336;
      inside_v_s16_q <= inside_v_s15_q;
      and_1370_s16_q <= and_1370;
      select_1374_s16_q <= select_1374_s15_q;
      and_1379_s16_q <= not_1336 & (so_s15_q ? and_1368 : and_1377_s15_q);
      right_2_s16_q <= right_2_s15_q;
      sum_1456_s16_q <= sum_1456_s15_q;
      and_1462_s16_q <= so_s15_q & (ends_cell_s15_q & (inside_v_s15_q[0] & or_1459));
      textured_s16_q <= textured_s15_q;
      and_1596_s16_q <= not_1336 & and_1595_s15_q;
      equal_1736_s16_q <= equal_1736_s15_q;
      equal_1857_s16_q <= equal_1857_s15_q;
      wide_s16_q <= wide;
      size_3_s16_q <= size_3;
      select_2087_s16_q <= select_2087[0];
      difference_2089_s16_q <= difference_2089;
      sum_2092_s16_q <= sum_2092[12:1];
      select_2093_s16_q <= select_2093[0];
      sum_2095_s16_q <= sum_2095;
      and_2111_s16_q <= and_2111_s15_q;
      less_2116_s16_q <= less_2116_s15_q;
      less_2302_s16_q <= less_2302_s15_q;
      select_2345_s16_q <= sum_1456_s15_q ? (equal_1458_s15_q & or_1459) : or_1459;
      equal_2509_s16_q <= equal_2509_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic segment_starts_q;
  // hls/stages/census.hpp:91
  logic [13:0] select_346;
  assign select_346 = equal_327_s16_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_352;
  assign sum_352 = {6'h0, sample_pair_pixel_1_q} + (equal_327_s16_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:213
  logic all_of_skin;
  assign all_of_skin = equal_327_s16_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/agreement.hpp:139
  logic not_1375;
  assign not_1375 = ~so_s16_q;
  // hls/stages/agreement.hpp:211
  logic and_1376;
  assign and_1376 = not_1375 & inside_v_s16_q[4];
  // hls/stages/agreement.hpp:215
  logic select_1649;
  assign select_1649 = sample_pair_whole_s16_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2074;
  assign select_2074 = ({wide_s16_q, 1'b0} < size_3_s16_q) ? {wide_s16_q, 1'b0} : size_3_s16_q;
  logic [8:0] taken;
  assign taken = ~select_2074;
  // hls/stages/registration.hpp:202
  logic [11:0] sum_2096;
  assign sum_2096 = sum_2092_s16_q + {sum_2095_s16_q, select_2093_s16_q};
  logic [9:0] sum_2097;
  assign sum_2097 = {difference_2089_s16_q, select_2087_s16_q} + sum_2096[11:2];
  // hls/stages/agreement.hpp:143
  logic or_2343;
  assign or_2343 = segment_starts_q | not_1375;
  // hls/stages/agreement.hpp:211
  logic select_2347;
  assign select_2347 = ends_cell_s16_q ? (inside_v_s16_q[0] ? select_2345_s16_q : or_2343) : or_2343;

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1374_s16_q;
  logic shown_right_we;
  assign shown_right_we = s16_en & and_1379_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1376, not_1375};
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
    end else if (s16_en) begin
      sample_pair_pixel_0_q <= pixel_0_s16_q;
      sample_pair_pixel_1_q <= pixel_1_s16_q;
      sample_of_skin_q <= mask_s16_q;
      averager_running_of_skin_q <= select_1649;
      segment_starts_q <= equal_1335_s16_q ? or_2343 : (so_s16_q ? select_2347 : or_2343);
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
    if (s16_en) begin
      averager_running_0_q <= sample_pair_whole_s16_q ? select_346 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s16_q ? sum_352 : averager_running_1_q;
    end
  end

  logic saturated_s17_q;
  logic marks_first_s17_q;
  logic marks_last_s17_q;
  logic sample_pair_whole_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic [2:0] slot_s17_q;
  logic ends_cell_s17_q;
  logic lower_half_s17_q;
  logic [11:0] registration_slope_s17_q;
  logic [8:0] select_333_s17_q;
  logic and_342_s17_q;
  logic and_343_s17_q;
  logic [29:0] averager_memory_rdata_s17_q;
  logic [13:0] select_346_s17_q;
  logic equal_348_s17_q;
  logic [13:0] sum_352_s17_q;
  logic whole_s17_q;
  logic all_of_skin_s17_q;
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
  logic [7:0] select_1329_s17_q;
  logic [6:0] select_1330_s17_q;
  logic [6:0] select_1333_s17_q;
  logic [6:0] select_1334_s17_q;
  logic equal_1335_s17_q;
  logic not_1336_s17_q;
  logic [13:0] inside_v_s17_q;
  logic and_1370_s17_q;
  logic [1:0] shown_right_rdata_s17_q;
  logic right_2_s17_q;
  logic sum_1456_s17_q;
  logic and_1462_s17_q;
  logic textured_s17_q;
  logic [17:0] seen_columns_rdata_s17_q;
  logic and_1596_s17_q;
  logic equal_1736_s17_q;
  logic equal_1857_s17_q;
  logic less_2058_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] taken_s17_q;
  logic [7:0] not_2076_s17_q;
  logic [7:0] sum_2097_s17_q;
  logic and_2111_s17_q;
  logic less_2116_s17_q;
  logic less_2302_s17_q;
  logic equal_2509_s17_q;
  always_ff @(posedge clk_i) begin
    if (s16_en) begin
      saturated_s17_q <= saturated_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      sample_pair_whole_s17_q <= sample_pair_whole_s16_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      slot_s17_q <= slot_s16_q;
      ends_cell_s17_q <= ends_cell_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      registration_slope_s17_q <= registration_slope_s16_q;
      select_333_s17_q <= select_333_s16_q;
      and_342_s17_q <= and_342_s16_q;
      and_343_s17_q <= and_343_s16_q;
      averager_memory_rdata_s17_q <= averager_memory_rdata_q;
      select_346_s17_q <= select_346;
      equal_348_s17_q <= equal_348_s16_q;
      sum_352_s17_q <= sum_352;
      whole_s17_q <= whole_s16_q;
      all_of_skin_s17_q <= all_of_skin;
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
      select_1329_s17_q <= or_1328_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1330_s17_q <= or_1328_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1333_s17_q <= select_1333_s16_q;
      select_1334_s17_q <= select_1334_s16_q;
      equal_1335_s17_q <= equal_1335_s16_q;
      not_1336_s17_q <= not_1336_s16_q;
      inside_v_s17_q <= inside_v_s16_q;
      and_1370_s17_q <= and_1370_s16_q;
      shown_right_rdata_s17_q <= shown_right_rdata_q;
      right_2_s17_q <= right_2_s16_q;
      sum_1456_s17_q <= sum_1456_s16_q;
      and_1462_s17_q <= and_1462_s16_q;
      textured_s17_q <= textured_s16_q;
      seen_columns_rdata_s17_q <= seen_columns_rdata_q;
      and_1596_s17_q <= and_1596_s16_q;
      equal_1736_s17_q <= equal_1736_s16_q;
      equal_1857_s17_q <= equal_1857_s16_q;
      less_2058_s17_q <= slot_s16_q < 3'h3;
      wide_s17_q <= wide_s16_q;
      taken_s17_q <= taken;
      not_2076_s17_q <= ~wide_s16_q;
      sum_2097_s17_q <= sum_2097[9:2];
      and_2111_s17_q <= and_2111_s16_q;
      less_2116_s17_q <= less_2116_s16_q;
      less_2302_s17_q <= less_2302_s16_q;
      equal_2509_s17_q <= equal_2509_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic [9:0] registration_displacement_over_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic segment_started_q;
  // hls/stages/census.hpp:100
  logic [13:0] sum_350;
  assign sum_350 = select_346_s17_q + (equal_348_s17_q ? 14'h0 : averager_memory_rdata_s17_q[13:0]);
  logic [13:0] sum_354;
  assign sum_354 = sum_352_s17_q + (equal_348_s17_q ? 14'h0 : averager_memory_rdata_s17_q[27:14]);
  // hls/stages/census.hpp:101
  logic and_358;
  assign and_358 = whole_s17_q & (averager_memory_rdata_s17_q[28] | equal_348_s17_q);
  // hls/stages/census.hpp:102
  logic and_362;
  assign and_362 = all_of_skin_s17_q & (averager_memory_rdata_s17_q[29] | equal_348_s17_q);
  // hls/stages/agreement.hpp:143
  logic [7:0] select_1443;
  assign select_1443 = so_s17_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:780
  logic or_1446;
  assign or_1446 = select_1443[7] | (~({select_1443[5], select_1443[3], select_1443[1]} == 3'h0));
  // hls/stages/agreement.hpp:197
  logic explained;
  assign explained = inside_v_s17_q[0] & inside_v_s17_q[3];
  logic and_1476;
  assign and_1476 = inside_v_s17_q[0] & ({inside_v_s17_q[4], inside_v_s17_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:751
  logic select_1484;
  assign select_1484 = slot_s17_q[2] ? shown_shown_q : inside_v_s17_q[3];
  // hls/stages/agreement.hpp:197
  logic shown;
  assign shown = inside_v_s17_q[0] & (shown_right_rdata_s17_q[0] | select_1484);
  // hls/stages/agreement.hpp:751
  logic select_1487;
  assign select_1487 = slot_s17_q[2] ? shown_nearer_q : inside_v_s17_q[4];
  // hls/stages/agreement.hpp:197
  logic near;
  assign near = inside_v_s17_q[0] & (select_1484 ? select_1487 : shown_right_rdata_s17_q[1]);
  // hls/stages/agreement.hpp:764
  logic [7:0] select_1537;
  assign select_1537 = inside_v_s17_q[0] ? (sum_1456_s17_q ? select_1443 : {select_1443[6:0], 1'b0}) : select_1443;
  // hls/stages/agreement.hpp:780
  logic or_1540;
  assign or_1540 = select_1537[7] | (~({select_1537[5], select_1537[3], select_1537[1]} == 3'h0));
  // hls/stages/agreement.hpp:764
  logic and_2000;
  assign and_2000 = seen_columns_rdata_s17_q[7] & inside_v_s17_q[0];
  logic and_2001;
  assign and_2001 = seen_columns_rdata_s17_q[2] & inside_v_s17_q[0];
  // hls/stages/registration.hpp:37
  logic not_2069;
  assign not_2069 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2058_s17_q ? {1'b0, wide_s17_q, 1'b0} : {registration_displacement_over_q[8:0], not_2069};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2077;
  assign select_2077 = registration_displacement_over_q[9] ? wide_s17_q : not_2076_s17_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2058_s17_q ? {taken_s17_q, 1'b1} : {not_2069, select_2077, not_2069};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2079;
  assign sum_2079 = {left, 1'b1} + {taken_2, less_2058_s17_q};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2098;
  assign sum_2098 = {registration_slope_s17_q[11], registration_slope_s17_q} + {{5{sum_2097_s17_q[7]}}, sum_2097_s17_q};
  // hls/stages/agreement.hpp:211
  logic select_2299;
  assign select_2299 = equal_1335_s17_q ? shown_shown_q : (so_s17_q ? select_1484 : shown_shown_q);
  logic select_2301;
  assign select_2301 = equal_1335_s17_q ? shown_nearer_q : (so_s17_q ? select_1487 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2303;
  assign sum_2303 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2312;
  assign select_2312 = equal_1335_s17_q ? select_1443 : (so_s17_q ? (ends_cell_s17_q ? select_1537 : select_1443) : 8'h1);
  // hls/stages/agreement.hpp:314
  logic [8:0] select_2326;
  assign select_2326 = equal_429_s17_q ? {difference_2324[7], difference_2324} : (less_2302_s17_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2328;
  assign select_2328 = and_368_s17_q ? (equal_1857_s17_q ? select_2326 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:314
  logic [7:0] select_2330;
  assign select_2330 = equal_429_s17_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:365
  logic [7:0] select_2332;
  assign select_2332 = and_368_s17_q ? (equal_1857_s17_q ? select_2330 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_2334;
  assign select_2334 = sum_2303[7] ? {1'b1, sum_2303[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 17, written in stage 19: 17 < 19 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s17_q;
  logic census_memory_re;
  assign census_memory_re = s17_en & and_368_s17_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

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
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1334_s17_q, select_1333_s17_q, select_1330_s17_q, select_1329_s17_q};
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
  logic [6:0] best_right_raddr_s16_sim;
  logic best_right_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s10_sim <= 1'b0;
      best_right_re_s11_sim <= 1'b0;
      best_right_re_s12_sim <= 1'b0;
      best_right_re_s13_sim <= 1'b0;
      best_right_re_s14_sim <= 1'b0;
      best_right_re_s15_sim <= 1'b0;
      best_right_re_s16_sim <= 1'b0;
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
      best_right_re_s16_sim <= best_right_re_s15_sim;
      best_right_raddr_s16_sim <= best_right_raddr_s15_sim;
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
      if (best_right_re_s16_sim && best_right_raddr_s16_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 7'd120) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd120) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

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
    end else if (s17_en) begin
      registration_displacement_over_q <= so_s17_q ? sum_2079[10:1] : registration_displacement_over_q;
      shown_shown_q <= select_2299;
      shown_nearer_q <= select_2301;
      region_columns_q <= select_2312;
      region_down_rest_q <= select_2328;
      region_down_back_q <= select_2332;
      region_down_next_q <= select_2334;
      segment_started_q <= ~segment_starts_q;
    end
  end

  logic [7:0] pixel_0_s18_q;
  logic [7:0] pixel_1_s18_q;
  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic sample_pair_whole_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic [2:0] slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic registration_displacement_over_s18_q;
  logic segment_started_s18_q;
  logic [8:0] select_333_s18_q;
  logic and_342_s18_q;
  logic and_343_s18_q;
  logic [13:0] sum_350_s18_q;
  logic [13:0] sum_354_s18_q;
  logic and_358_s18_q;
  logic and_362_s18_q;
  logic [6:0] column_s18_q;
  logic and_366_s18_q;
  logic and_368_s18_q;
  logic equal_371_s18_q;
  logic so_s18_q;
  logic equal_429_s18_q;
  logic equal_1335_s18_q;
  logic not_1336_s18_q;
  logic [11:0] inside_v_s18_q;
  logic and_1370_s18_q;
  logic equal_1380_s18_q;
  logic right_2_s18_q;
  logic or_1446_s18_q;
  logic or_1449_s18_q;
  logic or_1452_s18_q;
  logic and_1462_s18_q;
  logic textured_s18_q;
  logic explained_s18_q;
  logic and_1476_s18_q;
  logic [12:0] seen_columns_rdata_s18_q;
  logic shown_s18_q;
  logic near_s18_q;
  logic and_1522_s18_q;
  logic and_1524_s18_q;
  logic or_1540_s18_q;
  logic or_1543_s18_q;
  logic or_1546_s18_q;
  logic and_1557_s18_q;
  logic and_1559_s18_q;
  logic and_1560_s18_q;
  logic and_1573_s18_q;
  logic and_1575_s18_q;
  logic and_1576_s18_q;
  logic and_1596_s18_q;
  logic equal_1736_s18_q;
  logic equal_1857_s18_q;
  logic and_1998_s18_q;
  logic and_1999_s18_q;
  logic [1:0] sum_2003_s18_q;
  logic [7:0] sum_2098_s18_q;
  logic less_2099_s18_q;
  logic less_2100_s18_q;
  logic and_2111_s18_q;
  logic less_2116_s18_q;
  logic less_2302_s18_q;
  logic sum_2303_s18_q;
  logic and_2499_s18_q;
  logic equal_2509_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      pixel_0_s18_q <= sample_pair_pixel_0_q;
      pixel_1_s18_q <= sample_pair_pixel_1_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= sample_of_skin_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      slot_s18_q <= slot_s17_q;
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      registration_displacement_over_s18_q <= registration_displacement_over_q[9];
      segment_started_s18_q <= segment_started_q;
      select_333_s18_q <= select_333_s17_q;
      and_342_s18_q <= and_342_s17_q;
      and_343_s18_q <= and_343_s17_q;
      sum_350_s18_q <= sum_350;
      sum_354_s18_q <= sum_354;
      and_358_s18_q <= and_358;
      and_362_s18_q <= and_362;
      column_s18_q <= column_s17_q;
      and_366_s18_q <= and_366_s17_q;
      and_368_s18_q <= and_368_s17_q;
      equal_371_s18_q <= equal_371_s17_q;
      so_s18_q <= so_s17_q;
      equal_429_s18_q <= equal_429_s17_q;
      equal_1335_s18_q <= equal_1335_s17_q;
      not_1336_s18_q <= not_1336_s17_q;
      inside_v_s18_q <= {inside_v_s17_q[13:5], inside_v_s17_q[2:0]};
      and_1370_s18_q <= and_1370_s17_q;
      equal_1380_s18_q <= x_s17_q[6:4] == 3'h7;
      right_2_s18_q <= right_2_s17_q;
      or_1446_s18_q <= or_1446;
      or_1449_s18_q <= select_1443[7] | (~({select_1443[6], select_1443[3:2]} == 3'h0));
      or_1452_s18_q <= select_1443[7] | (~(select_1443[6:4] == 3'h0));
      and_1462_s18_q <= and_1462_s17_q;
      textured_s18_q <= textured_s17_q;
      explained_s18_q <= explained;
      and_1476_s18_q <= and_1476;
      seen_columns_rdata_s18_q <= {seen_columns_rdata_s17_q[13:7], seen_columns_rdata_s17_q[5:0]};
      shown_s18_q <= shown;
      near_s18_q <= near;
      and_1522_s18_q <= seen_columns_rdata_s17_q[14] & inside_v_s17_q[0];
      and_1524_s18_q <= seen_columns_rdata_s17_q[5] & inside_v_s17_q[0];
      or_1540_s18_q <= or_1540;
      or_1543_s18_q <= select_1537[7] | (~({select_1537[6], select_1537[3:2]} == 3'h0));
      or_1546_s18_q <= select_1537[7] | (~(select_1537[6:4] == 3'h0));
      and_1557_s18_q <= seen_columns_rdata_s17_q[16] & inside_v_s17_q[0];
      and_1559_s18_q <= seen_columns_rdata_s17_q[8] & inside_v_s17_q[0];
      and_1560_s18_q <= seen_columns_rdata_s17_q[3] & inside_v_s17_q[0];
      and_1573_s18_q <= seen_columns_rdata_s17_q[17] & inside_v_s17_q[0];
      and_1575_s18_q <= seen_columns_rdata_s17_q[9] & inside_v_s17_q[0];
      and_1576_s18_q <= seen_columns_rdata_s17_q[4] & inside_v_s17_q[0];
      and_1596_s18_q <= and_1596_s17_q;
      equal_1736_s18_q <= equal_1736_s17_q;
      equal_1857_s18_q <= equal_1857_s17_q;
      and_1998_s18_q <= seen_columns_rdata_s17_q[15] & inside_v_s17_q[0];
      and_1999_s18_q <= seen_columns_rdata_s17_q[11] & inside_v_s17_q[0];
      sum_2003_s18_q <= {1'b0, and_2000} + ({1'b0, explained} + {1'b0, and_2001});
      sum_2098_s18_q <= sum_2098[7:0];
      less_2099_s18_q <= $signed(6'h0) < $signed(sum_2098[12:7]);
      less_2100_s18_q <= $signed(sum_2098[12:7]) < $signed(6'h3f);
      and_2111_s18_q <= and_2111_s17_q;
      less_2116_s18_q <= less_2116_s17_q;
      less_2302_s18_q <= less_2302_s17_q;
      sum_2303_s18_q <= sum_2303[7];
      and_2499_s18_q <= seen_columns_rdata_s17_q[6] & inside_v_s17_q[0];
      equal_2509_s18_q <= equal_2509_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_342_s18_q ? sum_350_s18_q[13:5] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_371_s18_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey_2;
  assign grey_2 = and_342_s18_q ? sum_354_s18_q[13:5] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_371_s18_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:126
  logic and_379;
  assign and_379 = and_342_s18_q & and_358_s18_q;
  // hls/stages/census.hpp:105
  logic select_381;
  assign select_381 = equal_371_s18_q ? and_379 : (averager_mask_q & and_379);
  // hls/stages/agreement.hpp:215
  logic whole_2;
  assign whole_2 = sample_pair_whole_s18_q & select_381;
  // hls/stages/census.hpp:126
  logic and_383;
  assign and_383 = and_342_s18_q & and_362_s18_q;
  // hls/stages/census.hpp:105
  logic select_385;
  assign select_385 = equal_371_s18_q ? and_383 : (averager_of_skin_q & and_383);
  // hls/stages/agreement.hpp:211
  logic [5:0] select_1453;
  assign select_1453 = equal_1335_s18_q ? x_s18_q[5:0] : {region_row_q, or_1452_s18_q, or_1449_s18_q, or_1446_s18_q};
  // hls/stages/agreement.hpp:858
  logic not_1454;
  assign not_1454 = ~equal_1380_s18_q;
  // hls/stages/agreement.hpp:197
  logic and_1483;
  assign and_1483 = inside_v_s18_q[0] & inside_v_s18_q[2];
  // hls/stages/agreement.hpp:764
  logic and_1525;
  assign and_1525 = seen_columns_rdata_s18_q[0] & inside_v_s18_q[0];
  // hls/stages/agreement.hpp:817
  logic [1:0] sum_1527;
  assign sum_1527 = {1'b0, and_1524_s18_q} + ({1'b0, textured_s18_q} + {1'b0, and_1525});
  // hls/stages/agreement.hpp:764
  logic and_1558;
  assign and_1558 = seen_columns_rdata_s18_q[11] & inside_v_s18_q[0];
  // hls/stages/agreement.hpp:819
  logic [1:0] sum_1562;
  assign sum_1562 = {1'b0, and_1559_s18_q} + ({1'b0, shown_s18_q} + {1'b0, and_1560_s18_q});
  // hls/stages/agreement.hpp:764
  logic and_1574;
  assign and_1574 = seen_columns_rdata_s18_q[12] & inside_v_s18_q[0];
  // hls/stages/agreement.hpp:820
  logic [1:0] sum_1578;
  assign sum_1578 = {1'b0, and_1575_s18_q} + ({1'b0, near_s18_q} + {1'b0, and_1576_s18_q});
  // hls/stages/agreement.hpp:215
  logic [10:0] select_1628;
  assign select_1628 = sample_pair_whole_s18_q ? (and_366_s18_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1630;
  assign select_1630 = sample_pair_whole_s18_q ? (and_366_s18_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_1651;
  assign select_1651 = sample_pair_whole_s18_q ? (and_366_s18_q ? select_381 : averager_mask_q) : averager_mask_q;
  logic select_1653;
  assign select_1653 = sample_pair_whole_s18_q ? (and_366_s18_q ? select_385 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:211
  logic and_1977;
  assign and_1977 = so_s18_q & (ends_cell_s18_q & (inside_v_s18_q[0] & inside_v_s18_q[1]));
  // hls/stages/agreement.hpp:835
  logic not_1997;
  assign not_1997 = ~(x_s18_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:818
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_1998_s18_q} + ({2'h0, and_1999_s18_q} + {1'b0, sum_2003_s18_q});
  // hls/stages/agreement.hpp:211
  logic and_2038;
  assign and_2038 = ends_cell_s18_q & (inside_v_s18_q[0] & (inside_v_s18_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:840
  logic and_2044;
  assign and_2044 = not_1997 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:192
  logic [4:0] select_2081;
  assign select_2081 = so_s18_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_s18_q} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:83
  logic equal_2082;
  assign equal_2082 = slot_s18_q == 3'h7;
  // hls/stages/registration.hpp:206
  logic [7:0] select_2102;
  assign select_2102 = less_2099_s18_q ? 8'h7f : (less_2100_s18_q ? 8'h80 : sum_2098_s18_q);
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2104;
  assign select_2104 = so_s18_q ? (equal_2082 ? registration_slope_here_q : select_2102) : registration_slope_here_q;
  // hls/stages/registration.hpp:199
  logic [6:0] select_2120;
  assign select_2120 = inside_v_s18_q[3] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_2121;
  assign select_2121 = inside_v_s18_q[4] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2122;
  assign sum_2122 = {{2{select_2120[6]}}, select_2120} + {select_2121[7], select_2121};
  // hls/stages/registration.hpp:200
  logic [7:0] select_2123;
  assign select_2123 = inside_v_s18_q[5] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2124;
  assign select_2124 = inside_v_s18_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2125;
  assign sum_2125 = {{2{select_2123[7]}}, select_2123[7:1]} + {select_2124[7], select_2124};
  // hls/stages/registration.hpp:201
  logic [7:0] select_2127;
  assign select_2127 = inside_v_s18_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2128;
  assign select_2128 = inside_v_s18_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_2129;
  assign difference_2129 = {{2{select_2127[7]}}, select_2127[7:1]} - {select_2128[7], select_2128};
  // hls/stages/agreement.hpp:314
  logic [2:0] select_2305;
  assign select_2305 = less_2302_s18_q ? (sum_2303_s18_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2307;
  assign select_2307 = equal_1857_s18_q ? (equal_429_s18_q ? 3'h0 : select_2305) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2303_s18_q;
  // hls/stages/agreement.hpp:314
  logic select_2338;
  assign select_2338 = equal_1857_s18_q ? (equal_429_s18_q | (less_2302_s18_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:930
  logic equal_2356;
  assign equal_2356 = x_s18_q[6:3] == 4'h7;
  logic equal_2380;
  assign equal_2380 = x_s18_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:855
  logic [7:0] select_2393;
  assign select_2393 = (x_s18_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2395;
  assign select_2395 = equal_2380 ? cfg_unproven_skin_limit_i : (equal_2356 ? cfg_unproven_limit_i : select_2393);
  // hls/stages/agreement.hpp:211
  logic select_2497;
  assign select_2497 = so_s18_q ? (ends_cell_s18_q ? and_1524_s18_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2501;
  assign select_2501 = so_s18_q ? (ends_cell_s18_q ? and_2499_s18_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_2503;
  assign select_2503 = ends_cell_s18_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2505;
  assign select_2505 = equal_1335_s18_q ? centres_values_1_textured_q : (so_s18_q ? select_2503 : centres_values_1_textured_q);
  logic select_2506;
  assign select_2506 = ends_cell_s18_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2508;
  assign select_2508 = equal_1335_s18_q ? centres_values_1_of_skin_q : (so_s18_q ? select_2506 : centres_values_1_of_skin_q);

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1092; read in stage 18, written in stage 21: 18 < 21 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1453;
  logic regions_re;
  assign regions_re = s18_en & (equal_1335_s18_q ? (x_s18_q[6] & not_1454) : and_1462_s18_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_333_s18_q;
  logic averager_memory_we;
  assign averager_memory_we = s18_en & and_343_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_362_s18_q, and_358_s18_q, sum_354_s18_q, sum_350_s18_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s16_sim;
  logic averager_memory_re_s16_sim;
  logic [8:0] averager_memory_raddr_s17_sim;
  logic averager_memory_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s16_sim <= 1'b0;
      averager_memory_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s16_sim <= averager_memory_re;
      averager_memory_raddr_s16_sim <= averager_memory_raddr;
      averager_memory_re_s17_sim <= averager_memory_re_s16_sim;
      averager_memory_raddr_s17_sim <= averager_memory_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s16_sim && averager_memory_raddr_s16_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s17_sim && averager_memory_raddr_s17_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s18_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s18_en & and_1370_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s18_q, near_s18_q, shown_s18_q, explained_s18_q, and_1483, textured_s18_q};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s16_sim;
  logic seen_columns_re_s16_sim;
  logic [6:0] seen_columns_raddr_s17_sim;
  logic seen_columns_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s16_sim <= 1'b0;
      seen_columns_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s16_sim <= seen_columns_re;
      seen_columns_raddr_s16_sim <= seen_columns_raddr;
      seen_columns_re_s17_sim <= seen_columns_re_s16_sim;
      seen_columns_raddr_s17_sim <= seen_columns_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s16_sim && seen_columns_raddr_s16_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s17_sim && seen_columns_raddr_s17_sim == seen_columns_waddr) begin
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
    end else if (s18_en) begin
      averager_mask_q <= select_1651;
      averager_of_skin_q <= select_1653;
      registration_displacement_fraction_q <= select_2081;
      registration_slope_here_q <= equal_1335_s18_q ? registration_slope_here_q : select_2104;
      region_row_q <= and_368_s18_q ? select_2307 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_368_s18_q ? select_2338 : region_fresh_q;
      centres_values_0_textured_q <= equal_1335_s18_q ? centres_values_0_textured_q : select_2497;
      centres_values_0_of_skin_q <= equal_1335_s18_q ? centres_values_0_of_skin_q : select_2501;
      centres_values_1_textured_q <= select_2505;
      centres_values_1_of_skin_q <= select_2508;
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
    if (s18_en) begin
      averager_total_0_q <= select_1628;
      averager_total_1_q <= select_1630;
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
  logic [2:0] region_row_s19_q;
  logic region_fresh_s19_q;
  logic segment_started_s19_q;
  logic centres_values_1_textured_s19_q;
  logic centres_values_1_of_skin_s19_q;
  logic [6:0] column_s19_q;
  logic and_366_s19_q;
  logic and_368_s19_q;
  logic [77:0] census_memory_rdata_s19_q;
  logic [8:0] grey_s19_q;
  logic equal_371_s19_q;
  logic [8:0] select_374_s19_q;
  logic [8:0] grey_2_s19_q;
  logic [8:0] select_378_s19_q;
  logic whole_2_s19_q;
  logic and_386_s19_q;
  logic so_s19_q;
  logic equal_429_s19_q;
  logic equal_1335_s19_q;
  logic not_1336_s19_q;
  logic [1:0] inside_v_s19_q;
  logic equal_1380_s19_q;
  logic right_2_s19_q;
  logic or_1446_s19_q;
  logic or_1449_s19_q;
  logic or_1452_s19_q;
  logic not_1454_s19_q;
  logic textured_s19_q;
  logic explained_s19_q;
  logic and_1476_s19_q;
  logic and_1481_s19_q;
  logic and_1522_s19_q;
  logic and_1523_s19_q;
  logic [1:0] sum_1527_s19_q;
  logic or_1540_s19_q;
  logic or_1543_s19_q;
  logic or_1546_s19_q;
  logic and_1557_s19_q;
  logic [2:0] sum_1563_s19_q;
  logic and_1573_s19_q;
  logic [2:0] sum_1579_s19_q;
  logic and_1596_s19_q;
  logic equal_1736_s19_q;
  logic equal_1857_s19_q;
  logic and_1978_s19_q;
  logic not_1997_s19_q;
  logic [2:0] explained_2_s19_q;
  logic and_2040_s19_q;
  logic and_2047_s19_q;
  logic equal_2082_s19_q;
  logic and_2111_s19_q;
  logic or_2114_s19_q;
  logic [1:0] sum_2115_s19_q;
  logic less_2116_s19_q;
  logic [7:0] sum_2122_s19_q;
  logic select_2123_s19_q;
  logic [8:0] sum_2125_s19_q;
  logic select_2127_s19_q;
  logic [8:0] difference_2129_s19_q;
  logic equal_2356_s19_q;
  logic equal_2379_s19_q;
  logic equal_2380_s19_q;
  logic [7:0] select_2395_s19_q;
  logic equal_2509_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      pixel_0_s19_q <= pixel_0_s18_q;
      pixel_1_s19_q <= pixel_1_s18_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
      sample_pair_whole_s19_q <= sample_pair_whole_s18_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      slot_s19_q <= slot_s18_q;
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      region_row_s19_q <= region_row_q;
      region_fresh_s19_q <= region_fresh_q;
      segment_started_s19_q <= segment_started_s18_q;
      centres_values_1_textured_s19_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s19_q <= centres_values_1_of_skin_q;
      column_s19_q <= column_s18_q;
      and_366_s19_q <= and_366_s18_q;
      and_368_s19_q <= and_368_s18_q;
      census_memory_rdata_s19_q <= census_memory_rdata_q;
      grey_s19_q <= grey;
      equal_371_s19_q <= equal_371_s18_q;
      select_374_s19_q <= sample_pair_whole_s18_q ? total[10:2] : 9'h0;
      grey_2_s19_q <= grey_2;
      select_378_s19_q <= sample_pair_whole_s18_q ? total_2[10:2] : 9'h0;
      whole_2_s19_q <= whole_2;
      and_386_s19_q <= sample_pair_whole_s18_q & select_385;
      so_s19_q <= so_s18_q;
      equal_429_s19_q <= equal_429_s18_q;
      equal_1335_s19_q <= equal_1335_s18_q;
      not_1336_s19_q <= not_1336_s18_q;
      inside_v_s19_q <= {inside_v_s18_q[9], inside_v_s18_q[0]};
      equal_1380_s19_q <= equal_1380_s18_q;
      right_2_s19_q <= right_2_s18_q;
      or_1446_s19_q <= or_1446_s18_q;
      or_1449_s19_q <= or_1449_s18_q;
      or_1452_s19_q <= or_1452_s18_q;
      not_1454_s19_q <= not_1454;
      textured_s19_q <= textured_s18_q;
      explained_s19_q <= explained_s18_q;
      and_1476_s19_q <= and_1476_s18_q;
      and_1481_s19_q <= not_1336_s18_q & and_1462_s18_q;
      and_1522_s19_q <= and_1522_s18_q;
      and_1523_s19_q <= seen_columns_rdata_s18_q[9] & inside_v_s18_q[0];
      sum_1527_s19_q <= sum_1527;
      or_1540_s19_q <= or_1540_s18_q;
      or_1543_s19_q <= or_1543_s18_q;
      or_1546_s19_q <= or_1546_s18_q;
      and_1557_s19_q <= and_1557_s18_q;
      sum_1563_s19_q <= {2'h0, and_1558} + {1'b0, sum_1562};
      and_1573_s19_q <= and_1573_s18_q;
      sum_1579_s19_q <= {2'h0, and_1574} + {1'b0, sum_1578};
      and_1596_s19_q <= and_1596_s18_q;
      equal_1736_s19_q <= equal_1736_s18_q;
      equal_1857_s19_q <= equal_1857_s18_q;
      and_1978_s19_q <= not_1336_s18_q & and_1977;
      not_1997_s19_q <= not_1997;
      explained_2_s19_q <= explained_2;
      and_2040_s19_q <= not_1336_s18_q & (so_s18_q & and_2038);
      and_2047_s19_q <= not_1336_s18_q & (so_s18_q & (ends_cell_s18_q & and_2044));
      equal_2082_s19_q <= equal_2082;
      and_2111_s19_q <= and_2111_s18_q;
      or_2114_s19_q <= (inside_v_s18_q[11:9] == 3'h0) | (inside_v_s18_q[11:9] == 3'h4);
      sum_2115_s19_q <= inside_v_s18_q[11:10] + 2'h3;
      less_2116_s19_q <= less_2116_s18_q;
      sum_2122_s19_q <= sum_2122[8:1];
      select_2123_s19_q <= select_2123[0];
      sum_2125_s19_q <= sum_2125;
      select_2127_s19_q <= select_2127[0];
      difference_2129_s19_q <= difference_2129;
      equal_2356_s19_q <= equal_2356;
      equal_2379_s19_q <= x_s18_q[6:3] == 4'h9;
      equal_2380_s19_q <= equal_2380;
      select_2395_s19_q <= select_2395;
      equal_2509_s19_q <= equal_2509_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:214
  logic less_402;
  assign less_402 = census_memory_rdata_s19_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_403;
  assign less_403 = census_memory_rdata_s19_q[48:40] < census_columns_values_1_cell_2_left_q;
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
  // hls/stages/census.hpp:215
  logic less_414;
  assign less_414 = census_memory_rdata_s19_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_415;
  assign less_415 = census_memory_rdata_s19_q[57:49] < census_columns_values_1_cell_2_right_q;
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
  // hls/stages/agreement.hpp:309
  logic equal_426;
  assign equal_426 = column_s19_q == 7'h0;
  logic [3:0] select_430;
  assign select_430 = equal_429_s19_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:310
  logic [4:0] select_431;
  assign select_431 = equal_426 ? {select_430, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_432;
  assign select_432 = equal_426 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:206
  logic and_435;
  assign and_435 = census_memory_rdata_s19_q[38] & (census_memory_rdata_s19_q[18] & whole_2_s19_q);
  logic and_437;
  assign and_437 = census_memory_rdata_s19_q[77] & (census_memory_rdata_s19_q[58] & and_435);
  // hls/stages/census.hpp:190
  logic [9:0] difference_460;
  assign difference_460 = {1'b0, select_374_s19_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_463;
  assign difference_463 = {1'b0, census_memory_rdata_s19_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_467;
  assign difference_467 = {1'b0, census_memory_rdata_s19_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_471;
  assign difference_471 = {1'b0, census_memory_rdata_s19_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_475;
  assign difference_475 = {1'b0, census_memory_rdata_s19_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/registration.hpp:139
  logic all;
  assign all = x_s19_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:817
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1522_s19_q} + ({2'h0, and_1523_s19_q} + {1'b0, sum_1527_s19_q});
  // hls/stages/agreement.hpp:819
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1557_s19_q} + sum_1563_s19_q;
  // hls/stages/agreement.hpp:826
  logic [2:0] select_1565;
  assign select_1565 = age_s19_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:820
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1573_s19_q} + sum_1579_s19_q;
  // hls/stages/agreement.hpp:827
  logic [2:0] select_1581;
  assign select_1581 = age_s19_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:215
  logic [8:0] select_1620;
  assign select_1620 = sample_pair_whole_s19_q ? (and_366_s19_q ? grey_s19_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1622;
  assign select_1622 = sample_pair_whole_s19_q ? (and_366_s19_q ? grey_2_s19_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1624;
  assign select_1624 = sample_pair_whole_s19_q ? (and_366_s19_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1626;
  assign select_1626 = sample_pair_whole_s19_q ? (and_366_s19_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1631;
  assign sum_1631 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s19_q};
  logic [9:0] sum_1639;
  assign sum_1639 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s19_q};
  // hls/stages/agreement.hpp:365
  logic [8:0] select_1654;
  assign select_1654 = and_368_s19_q ? select_374_s19_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1655;
  assign select_1655 = and_368_s19_q ? select_378_s19_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1657;
  assign select_1657 = and_368_s19_q ? census_memory_rdata_s19_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1658;
  assign select_1658 = and_368_s19_q ? census_memory_rdata_s19_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1659;
  assign select_1659 = and_368_s19_q ? census_memory_rdata_s19_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1660;
  assign select_1660 = and_368_s19_q ? census_memory_rdata_s19_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1661;
  assign select_1661 = and_368_s19_q ? census_memory_rdata_s19_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1662;
  assign select_1662 = and_368_s19_q ? census_memory_rdata_s19_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1663;
  assign select_1663 = and_368_s19_q ? census_memory_rdata_s19_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1664;
  assign select_1664 = and_368_s19_q ? census_memory_rdata_s19_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1665;
  assign select_1665 = and_368_s19_q ? census_memory_rdata_s19_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1666;
  assign select_1666 = and_368_s19_q ? census_memory_rdata_s19_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1667;
  assign select_1667 = and_368_s19_q ? census_memory_rdata_s19_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1668;
  assign select_1668 = and_368_s19_q ? census_memory_rdata_s19_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1669;
  assign select_1669 = and_368_s19_q ? census_memory_rdata_s19_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1670;
  assign select_1670 = and_368_s19_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1671;
  assign select_1671 = and_368_s19_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1673;
  assign select_1673 = and_368_s19_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1674;
  assign select_1674 = and_368_s19_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1676;
  assign select_1676 = and_368_s19_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1677;
  assign select_1677 = and_368_s19_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1679;
  assign select_1679 = and_368_s19_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1680;
  assign select_1680 = and_368_s19_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1681;
  assign select_1681 = and_368_s19_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1683;
  assign select_1683 = and_368_s19_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1684;
  assign select_1684 = and_368_s19_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1686;
  assign select_1686 = and_368_s19_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1687;
  assign select_1687 = and_368_s19_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1689;
  assign select_1689 = and_368_s19_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1690;
  assign select_1690 = and_368_s19_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1692;
  assign select_1692 = and_368_s19_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1693;
  assign select_1693 = and_368_s19_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1695;
  assign select_1695 = and_368_s19_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1696;
  assign select_1696 = and_368_s19_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1698;
  assign select_1698 = and_368_s19_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1699;
  assign select_1699 = and_368_s19_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1702;
  assign select_1702 = and_368_s19_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1703;
  assign select_1703 = and_368_s19_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1706;
  assign select_1706 = and_368_s19_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1707;
  assign select_1707 = and_368_s19_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1711;
  assign difference_1711 = {1'b0, select_378_s19_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1714;
  assign difference_1714 = {1'b0, census_memory_rdata_s19_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1718;
  assign difference_1718 = {1'b0, census_memory_rdata_s19_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1722;
  assign difference_1722 = {1'b0, census_memory_rdata_s19_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1726;
  assign difference_1726 = {1'b0, census_memory_rdata_s19_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1756;
  assign difference_1756 = {1'b0, select_374_s19_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1767;
  assign difference_1767 = {1'b0, select_378_s19_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:365
  logic and_1974;
  assign and_1974 = and_368_s19_q & (equal_429_s19_q & equal_1857_s19_q);
  // hls/stages/agreement.hpp:211
  logic and_1983;
  assign and_1983 = not_1336_s19_q & (so_s19_q & (ends_cell_s19_q & textured_s19_q));
  // hls/stages/agreement.hpp:825
  logic [2:0] select_2006;
  assign select_2006 = age_s19_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2042;
  assign select_2042 = and_1974 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2040_s19_q});
  logic [13:0] select_2049;
  assign select_2049 = and_1974 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2047_s19_q});
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2117;
  assign difference_2117 = {sum_2115_s19_q, inside_v_s19_q[1], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2118;
  assign select_2118 = less_2116_s19_q ? difference_2117 : {sum_2115_s19_q, inside_v_s19_q[1], registration_displacement_fraction_q};
  logic [7:0] select_2119;
  assign select_2119 = or_2114_s19_q ? {sum_2115_s19_q, inside_v_s19_q[1], 5'h0} : select_2118;
  // hls/stages/registration.hpp:202
  logic [10:0] sum_2126;
  assign sum_2126 = {{3{sum_2122_s19_q[7]}}, sum_2122_s19_q} + {sum_2125_s19_q[8], sum_2125_s19_q, select_2123_s19_q};
  logic [9:0] sum_2130;
  assign sum_2130 = {difference_2129_s19_q, select_2127_s19_q} + {sum_2126[10], sum_2126[10:2]};
  // hls/stages/agreement.hpp:936
  logic equal_2357;
  assign equal_2357 = x_s19_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:930
  logic equal_2377;
  assign equal_2377 = x_s19_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:855
  logic [7:0] limit;
  assign limit = equal_2377 ? cfg_regions_limit_i : (equal_2379_s19_q ? cfg_hidden_limit_i : select_2395_s19_q);
  // hls/stages/agreement.hpp:943
  logic not_2398;
  assign not_2398 = ~x_s19_q[2];
  logic [3:0] select_2399;
  assign select_2399 = x_s19_q[1] ? {x_s19_q[2], 1'b0, not_2398, 1'b0} : {1'b0, x_s19_q[2], 1'b0, not_2398};
  logic [7:0] select_2400;
  assign select_2400 = x_s19_q[0] ? {select_2399[3], 1'b0, select_2399[2], 1'b0, select_2399[1], 1'b0, select_2399[0], 1'b0} : {1'b0, select_2399[3], 1'b0, select_2399[2], 1'b0, select_2399[1], 1'b0, select_2399[0]};
  // hls/stages/agreement.hpp:855
  logic [13:0] select_2404;
  assign select_2404 = equal_2379_s19_q ? counts_skin_supervised_q : (equal_2380_s19_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2377 ? counts_textured_q : select_2404;
  // hls/stages/agreement.hpp:211
  logic [2:0] select_2442;
  assign select_2442 = ends_cell_s19_q ? explained_2_s19_q : box_explained_columns_values_0_q;
  logic [2:0] select_2444;
  assign select_2444 = equal_1335_s19_q ? box_explained_columns_values_0_q : (so_s19_q ? select_2442 : box_explained_columns_values_0_q);
  logic [2:0] select_2445;
  assign select_2445 = ends_cell_s19_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2447;
  assign select_2447 = equal_1335_s19_q ? box_explained_columns_values_1_q : (so_s19_q ? select_2445 : box_explained_columns_values_1_q);
  logic [2:0] select_2448;
  assign select_2448 = ends_cell_s19_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2450;
  assign select_2450 = equal_1335_s19_q ? box_explained_columns_values_2_q : (so_s19_q ? select_2448 : box_explained_columns_values_2_q);
  logic [2:0] select_2451;
  assign select_2451 = ends_cell_s19_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2453;
  assign select_2453 = equal_1335_s19_q ? box_explained_columns_values_3_q : (so_s19_q ? select_2451 : box_explained_columns_values_3_q);
  logic [2:0] select_2454;
  assign select_2454 = ends_cell_s19_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2456;
  assign select_2456 = equal_1335_s19_q ? box_explained_columns_values_4_q : (so_s19_q ? select_2454 : box_explained_columns_values_4_q);
  logic [2:0] select_2461;
  assign select_2461 = so_s19_q ? (ends_cell_s19_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2463;
  assign select_2463 = ends_cell_s19_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2465;
  assign select_2465 = equal_1335_s19_q ? box_shown_columns_values_1_q : (so_s19_q ? select_2463 : box_shown_columns_values_1_q);
  logic [2:0] select_2466;
  assign select_2466 = ends_cell_s19_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2468;
  assign select_2468 = equal_1335_s19_q ? box_shown_columns_values_2_q : (so_s19_q ? select_2466 : box_shown_columns_values_2_q);
  logic [2:0] select_2469;
  assign select_2469 = ends_cell_s19_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2471;
  assign select_2471 = equal_1335_s19_q ? box_shown_columns_values_3_q : (so_s19_q ? select_2469 : box_shown_columns_values_3_q);
  logic [2:0] select_2472;
  assign select_2472 = ends_cell_s19_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2474;
  assign select_2474 = equal_1335_s19_q ? box_shown_columns_values_4_q : (so_s19_q ? select_2472 : box_shown_columns_values_4_q);
  logic [2:0] select_2479;
  assign select_2479 = so_s19_q ? (ends_cell_s19_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2481;
  assign select_2481 = ends_cell_s19_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2483;
  assign select_2483 = equal_1335_s19_q ? box_nearer_columns_values_1_q : (so_s19_q ? select_2481 : box_nearer_columns_values_1_q);
  logic [2:0] select_2484;
  assign select_2484 = ends_cell_s19_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2486;
  assign select_2486 = equal_1335_s19_q ? box_nearer_columns_values_2_q : (so_s19_q ? select_2484 : box_nearer_columns_values_2_q);
  logic [2:0] select_2487;
  assign select_2487 = ends_cell_s19_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2489;
  assign select_2489 = equal_1335_s19_q ? box_nearer_columns_values_3_q : (so_s19_q ? select_2487 : box_nearer_columns_values_3_q);
  logic [2:0] select_2490;
  assign select_2490 = ends_cell_s19_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2492;
  assign select_2492 = equal_1335_s19_q ? box_nearer_columns_values_4_q : (so_s19_q ? select_2490 : box_nearer_columns_values_4_q);

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s19_q;
  logic census_memory_we;
  assign census_memory_we = s19_en & and_368_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s19_q[58:40], census_memory_rdata_s19_q[38:0], and_386_s19_q, whole_2_s19_q, select_378_s19_q, select_374_s19_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s18_sim;
  logic census_memory_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s18_sim <= census_memory_re;
      census_memory_raddr_s18_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s18_sim && census_memory_raddr_s18_sim == census_memory_waddr) begin
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
    end else if (s19_en) begin
      census_filled_q <= and_368_s19_q ? {select_432[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_368_s19_q ? select_431 : rows_passed_above_q;
      counts_textured_q <= and_1974 ? 14'h0 : (counts_textured_q + {13'h0, and_1983});
      counts_skin_supervised_q <= select_2042;
      counts_skin_textured_q <= select_2049;
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
    if (s19_en) begin
      averager_quarter_1_0_q <= select_1620;
      averager_quarter_1_1_q <= select_1622;
      averager_quarter_2_0_q <= select_1624;
      averager_quarter_2_1_q <= select_1626;
      census_columns_values_0_cell_0_left_q <= select_1654;
      census_columns_values_0_cell_0_right_q <= select_1655;
      census_columns_values_0_cell_1_left_q <= select_1657;
      census_columns_values_0_cell_1_right_q <= select_1658;
      census_columns_values_0_cell_1_mask_q <= select_1659;
      census_columns_values_0_cell_2_left_q <= select_1660;
      census_columns_values_0_cell_2_right_q <= select_1661;
      census_columns_values_0_cell_2_mask_q <= select_1662;
      census_columns_values_0_cell_2_of_skin_q <= select_1663;
      census_columns_values_0_cell_3_left_q <= select_1664;
      census_columns_values_0_cell_3_right_q <= select_1665;
      census_columns_values_0_cell_3_mask_q <= select_1666;
      census_columns_values_0_cell_4_left_q <= select_1667;
      census_columns_values_0_cell_4_right_q <= select_1668;
      census_columns_values_0_cell_4_mask_q <= select_1669;
      census_columns_values_1_cell_0_left_q <= select_1670;
      census_columns_values_1_cell_0_right_q <= select_1671;
      census_columns_values_1_cell_1_left_q <= select_1673;
      census_columns_values_1_cell_1_right_q <= select_1674;
      census_columns_values_1_cell_2_left_q <= select_1676;
      census_columns_values_1_cell_2_right_q <= select_1677;
      census_columns_values_1_cell_2_of_skin_q <= select_1679;
      census_columns_values_1_cell_3_left_q <= select_1680;
      census_columns_values_1_cell_3_right_q <= select_1681;
      census_columns_values_1_cell_4_left_q <= select_1683;
      census_columns_values_1_cell_4_right_q <= select_1684;
      census_columns_values_2_cell_0_left_q <= select_1686;
      census_columns_values_2_cell_0_right_q <= select_1687;
      census_columns_values_2_cell_1_left_q <= select_1689;
      census_columns_values_2_cell_1_right_q <= select_1690;
      census_columns_values_2_cell_2_left_q <= select_1692;
      census_columns_values_2_cell_2_right_q <= select_1693;
      census_columns_values_2_cell_3_left_q <= select_1695;
      census_columns_values_2_cell_3_right_q <= select_1696;
      census_columns_values_2_cell_4_left_q <= select_1698;
      census_columns_values_2_cell_4_right_q <= select_1699;
      census_columns_values_3_cell_1_left_q <= select_1702;
      census_columns_values_3_cell_1_right_q <= select_1703;
      census_columns_values_3_cell_3_left_q <= select_1706;
      census_columns_values_3_cell_3_right_q <= select_1707;
      sharpness_last_mean_0_q <= and_368_s19_q ? select_374_s19_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_368_s19_q ? select_378_s19_q : sharpness_last_mean_1_q;
      box_explained_columns_values_0_q <= select_2444;
      box_explained_columns_values_1_q <= select_2447;
      box_explained_columns_values_2_q <= select_2450;
      box_explained_columns_values_3_q <= select_2453;
      box_explained_columns_values_4_q <= select_2456;
      box_shown_columns_values_0_q <= equal_1335_s19_q ? box_shown_columns_values_0_q : select_2461;
      box_shown_columns_values_1_q <= select_2465;
      box_shown_columns_values_2_q <= select_2468;
      box_shown_columns_values_3_q <= select_2471;
      box_shown_columns_values_4_q <= select_2474;
      box_nearer_columns_values_0_q <= equal_1335_s19_q ? box_nearer_columns_values_0_q : select_2479;
      box_nearer_columns_values_1_q <= select_2483;
      box_nearer_columns_values_2_q <= select_2486;
      box_nearer_columns_values_3_q <= select_2489;
      box_nearer_columns_values_4_q <= select_2492;
    end
  end

  logic [7:0] pixel_0_s20_q;
  logic [7:0] pixel_1_s20_q;
  logic saturated_s20_q;
  logic mask_s20_q;
  logic marks_first_s20_q;
  logic marks_last_s20_q;
  logic sample_pair_whole_s20_q;
  logic census_columns_values_0_cell_1_mask_s20_q;
  logic census_columns_values_0_cell_2_mask_s20_q;
  logic census_columns_values_0_cell_3_mask_s20_q;
  logic census_columns_values_0_cell_4_mask_s20_q;
  logic census_columns_values_1_cell_2_of_skin_s20_q;
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic [2:0] slot_s20_q;
  logic ends_cell_s20_q;
  logic lower_half_s20_q;
  logic [13:0] counts_textured_s20_q;
  logic [2:0] region_row_s20_q;
  logic region_fresh_s20_q;
  logic segment_started_s20_q;
  logic centres_values_1_textured_s20_q;
  logic centres_values_1_of_skin_s20_q;
  logic [6:0] column_s20_q;
  logic and_366_s20_q;
  logic and_368_s20_q;
  logic equal_371_s20_q;
  logic whole_2_s20_q;
  logic so_s20_q;
  logic less_402_s20_q;
  logic less_403_s20_q;
  logic less_404_s20_q;
  logic less_405_s20_q;
  logic less_406_s20_q;
  logic less_407_s20_q;
  logic less_408_s20_q;
  logic less_409_s20_q;
  logic less_410_s20_q;
  logic less_411_s20_q;
  logic less_412_s20_q;
  logic less_413_s20_q;
  logic less_414_s20_q;
  logic less_415_s20_q;
  logic less_416_s20_q;
  logic less_417_s20_q;
  logic less_418_s20_q;
  logic less_419_s20_q;
  logic less_420_s20_q;
  logic less_421_s20_q;
  logic less_422_s20_q;
  logic less_423_s20_q;
  logic less_424_s20_q;
  logic less_425_s20_q;
  logic and_433_s20_q;
  logic and_437_s20_q;
  logic difference_460_s20_q;
  logic [8:0] xor_461_s20_q;
  logic difference_463_s20_q;
  logic [8:0] xor_464_s20_q;
  logic difference_467_s20_q;
  logic [8:0] xor_468_s20_q;
  logic difference_471_s20_q;
  logic [8:0] xor_472_s20_q;
  logic difference_475_s20_q;
  logic [8:0] xor_476_s20_q;
  logic equal_1335_s20_q;
  logic not_1336_s20_q;
  logic inside_v_s20_q;
  logic equal_1380_s20_q;
  logic all_s20_q;
  logic equal_1394_s20_q;
  logic equal_1396_s20_q;
  logic equal_1398_s20_q;
  logic equal_1400_s20_q;
  logic right_2_s20_q;
  logic or_1446_s20_q;
  logic or_1449_s20_q;
  logic or_1452_s20_q;
  logic not_1454_s20_q;
  logic [29:0] regions_rdata_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1476_s20_q;
  logic and_1481_s20_q;
  logic [2:0] textured_2_s20_q;
  logic equal_1532_s20_q;
  logic or_1540_s20_q;
  logic or_1543_s20_q;
  logic or_1546_s20_q;
  logic [3:0] difference_1566_s20_q;
  logic [3:0] difference_1582_s20_q;
  logic and_1596_s20_q;
  logic sum_1631_s20_q;
  logic [9:0] difference_1632_s20_q;
  logic sum_1639_s20_q;
  logic [9:0] difference_1640_s20_q;
  logic difference_1711_s20_q;
  logic [8:0] xor_1712_s20_q;
  logic difference_1714_s20_q;
  logic [8:0] xor_1715_s20_q;
  logic difference_1718_s20_q;
  logic [8:0] xor_1719_s20_q;
  logic difference_1722_s20_q;
  logic [8:0] xor_1723_s20_q;
  logic difference_1726_s20_q;
  logic [8:0] xor_1727_s20_q;
  logic equal_1736_s20_q;
  logic difference_1756_s20_q;
  logic [8:0] xor_1757_s20_q;
  logic difference_1767_s20_q;
  logic [8:0] xor_1768_s20_q;
  logic equal_1857_s20_q;
  logic and_1974_s20_q;
  logic and_1978_s20_q;
  logic and_1983_s20_q;
  logic not_1997_s20_q;
  logic [3:0] difference_2007_s20_q;
  logic equal_2082_s20_q;
  logic and_2111_s20_q;
  logic [7:0] select_2119_s20_q;
  logic sum_2126_s20_q;
  logic [9:0] sum_2130_s20_q;
  logic equal_2357_s20_q;
  logic and_2358_s20_q;
  logic equal_2377_s20_q;
  logic equal_2379_s20_q;
  logic equal_2380_s20_q;
  logic equal_2402_s20_q;
  logic [13:0] of_s20_q;
  logic equal_2509_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      pixel_0_s20_q <= pixel_0_s19_q;
      pixel_1_s20_q <= pixel_1_s19_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= mask_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      sample_pair_whole_s20_q <= sample_pair_whole_s19_q;
      census_columns_values_0_cell_1_mask_s20_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s20_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s20_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s20_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s20_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s20_q <= x_s19_q;
      age_s20_q <= age_s19_q;
      slot_s20_q <= slot_s19_q;
      ends_cell_s20_q <= ends_cell_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      counts_textured_s20_q <= counts_textured_q;
      region_row_s20_q <= region_row_s19_q;
      region_fresh_s20_q <= region_fresh_s19_q;
      segment_started_s20_q <= segment_started_s19_q;
      centres_values_1_textured_s20_q <= centres_values_1_textured_s19_q;
      centres_values_1_of_skin_s20_q <= centres_values_1_of_skin_s19_q;
      column_s20_q <= column_s19_q;
      and_366_s20_q <= and_366_s19_q;
      and_368_s20_q <= and_368_s19_q;
      equal_371_s20_q <= equal_371_s19_q;
      whole_2_s20_q <= whole_2_s19_q;
      so_s20_q <= so_s19_q;
      less_402_s20_q <= less_402;
      less_403_s20_q <= less_403;
      less_404_s20_q <= less_404;
      less_405_s20_q <= less_405;
      less_406_s20_q <= less_406;
      less_407_s20_q <= less_407;
      less_408_s20_q <= less_408;
      less_409_s20_q <= less_409;
      less_410_s20_q <= less_410;
      less_411_s20_q <= less_411;
      less_412_s20_q <= less_412;
      less_413_s20_q <= less_413;
      less_414_s20_q <= less_414;
      less_415_s20_q <= less_415;
      less_416_s20_q <= less_416;
      less_417_s20_q <= less_417;
      less_418_s20_q <= less_418;
      less_419_s20_q <= less_419;
      less_420_s20_q <= less_420;
      less_421_s20_q <= less_421;
      less_422_s20_q <= less_422;
      less_423_s20_q <= less_423;
      less_424_s20_q <= less_424;
      less_425_s20_q <= less_425;
      and_433_s20_q <= select_431[4] & select_432[3];
      and_437_s20_q <= and_437;
      difference_460_s20_q <= difference_460[9];
      xor_461_s20_q <= difference_460[8:0] ^ {9{difference_460[9]}};
      difference_463_s20_q <= difference_463[9];
      xor_464_s20_q <= difference_463[8:0] ^ {9{difference_463[9]}};
      difference_467_s20_q <= difference_467[9];
      xor_468_s20_q <= difference_467[8:0] ^ {9{difference_467[9]}};
      difference_471_s20_q <= difference_471[9];
      xor_472_s20_q <= difference_471[8:0] ^ {9{difference_471[9]}};
      difference_475_s20_q <= difference_475[9];
      xor_476_s20_q <= difference_475[8:0] ^ {9{difference_475[9]}};
      equal_1335_s20_q <= equal_1335_s19_q;
      not_1336_s20_q <= not_1336_s19_q;
      inside_v_s20_q <= inside_v_s19_q[0];
      equal_1380_s20_q <= equal_1380_s19_q;
      all_s20_q <= all;
      equal_1394_s20_q <= x_s19_q[5:0] == 6'h3b;
      equal_1396_s20_q <= x_s19_q[5:0] == 6'h36;
      equal_1398_s20_q <= x_s19_q[5:0] == 6'h35;
      equal_1400_s20_q <= x_s19_q[5:0] == 6'h34;
      right_2_s20_q <= right_2_s19_q;
      or_1446_s20_q <= or_1446_s19_q;
      or_1449_s20_q <= or_1449_s19_q;
      or_1452_s20_q <= or_1452_s19_q;
      not_1454_s20_q <= not_1454_s19_q;
      regions_rdata_s20_q <= regions_rdata_q;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained_s19_q;
      and_1476_s20_q <= and_1476_s19_q;
      and_1481_s20_q <= and_1481_s19_q;
      textured_2_s20_q <= textured_2;
      equal_1532_s20_q <= x_s19_q == 8'h0;
      or_1540_s20_q <= or_1540_s19_q;
      or_1543_s20_q <= or_1543_s19_q;
      or_1546_s20_q <= or_1546_s19_q;
      difference_1566_s20_q <= {1'b0, shown_2} - {1'b0, select_1565};
      difference_1582_s20_q <= {1'b0, near_2} - {1'b0, select_1581};
      and_1596_s20_q <= and_1596_s19_q;
      sum_1631_s20_q <= sum_1631[0];
      difference_1632_s20_q <= {1'b0, sum_1631[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1639_s20_q <= sum_1639[0];
      difference_1640_s20_q <= {1'b0, sum_1639[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1711_s20_q <= difference_1711[9];
      xor_1712_s20_q <= difference_1711[8:0] ^ {9{difference_1711[9]}};
      difference_1714_s20_q <= difference_1714[9];
      xor_1715_s20_q <= difference_1714[8:0] ^ {9{difference_1714[9]}};
      difference_1718_s20_q <= difference_1718[9];
      xor_1719_s20_q <= difference_1718[8:0] ^ {9{difference_1718[9]}};
      difference_1722_s20_q <= difference_1722[9];
      xor_1723_s20_q <= difference_1722[8:0] ^ {9{difference_1722[9]}};
      difference_1726_s20_q <= difference_1726[9];
      xor_1727_s20_q <= difference_1726[8:0] ^ {9{difference_1726[9]}};
      equal_1736_s20_q <= equal_1736_s19_q;
      difference_1756_s20_q <= difference_1756[9];
      xor_1757_s20_q <= difference_1756[8:0] ^ {9{difference_1756[9]}};
      difference_1767_s20_q <= difference_1767[9];
      xor_1768_s20_q <= difference_1767[8:0] ^ {9{difference_1767[9]}};
      equal_1857_s20_q <= equal_1857_s19_q;
      and_1974_s20_q <= and_1974;
      and_1978_s20_q <= and_1978_s19_q;
      and_1983_s20_q <= and_1983;
      not_1997_s20_q <= not_1997_s19_q;
      difference_2007_s20_q <= {1'b0, explained_2_s19_q} - {1'b0, select_2006};
      equal_2082_s20_q <= equal_2082_s19_q;
      and_2111_s20_q <= and_2111_s19_q;
      select_2119_s20_q <= select_2119;
      sum_2126_s20_q <= sum_2126[1];
      sum_2130_s20_q <= sum_2130;
      equal_2357_s20_q <= equal_2357;
      and_2358_s20_q <= equal_2356_s19_q & equal_2357;
      equal_2377_s20_q <= equal_2377;
      equal_2379_s20_q <= equal_2379_s19_q;
      equal_2380_s20_q <= equal_2380_s19_q;
      equal_2402_s20_q <= (limit & select_2400) == 8'h0;
      of_s20_q <= of;
      equal_2509_s20_q <= equal_2509_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:310
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_437_s20_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s20_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s20_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s20_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s20_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:190
  logic [9:0] sum_462;
  assign sum_462 = {9'h0, difference_460_s20_q} + {1'b0, xor_461_s20_q};
  logic [9:0] sum_465;
  assign sum_465 = {9'h0, difference_463_s20_q} + {1'b0, xor_464_s20_q};
  // hls/stages/agreement.hpp:898
  logic [1:0] quarter;
  assign quarter = x_s20_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:859
  logic [1:0] select_1383;
  assign select_1383 = x_s20_q[4] ? {x_s20_q[3], x_s20_q[0]} : {x_s20_q[0], x_s20_q[3]};
  // hls/stages/agreement.hpp:871
  logic [3:0] select_1385;
  assign select_1385 = equal_1380_s20_q ? {2'h0, quarter} : (all_s20_q ? {1'b0, x_s20_q[2:0]} : {x_s20_q[2:1], select_1383});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1386;
  assign sum_1386 = slot_s20_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_1387;
  assign select_1387 = equal_1335_s20_q ? select_1385 : {sum_1386, lower_half_s20_q, registration_of_right_q};
  // hls/stages/agreement.hpp:896
  logic equal_1388;
  assign equal_1388 = x_s20_q[5:0] == 6'h3e;
  logic equal_1390;
  assign equal_1390 = x_s20_q[5:0] == 6'h3d;
  logic equal_1392;
  assign equal_1392 = x_s20_q[5:0] == 6'h3c;
  // hls/stages/agreement.hpp:898
  logic and_1403;
  assign and_1403 = (~equal_1396_s20_q) & ((~equal_1398_s20_q) & (~equal_1400_s20_q));
  logic and_1406;
  assign and_1406 = (~equal_1390) & ((~equal_1392) & ((~equal_1394_s20_q) & and_1403));
  // hls/stages/agreement.hpp:859
  logic less_1408;
  assign less_1408 = x_s20_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:140
  logic [1:0] kind;
  assign kind = all_s20_q ? {1'b0, x_s20_q[2]} : x_s20_q[2:1];
  // hls/stages/registration.hpp:152
  logic or_1412;
  assign or_1412 = (kind == 2'h3) | (x_s20_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:871
  logic select_1415;
  assign select_1415 = equal_1380_s20_q ? ((~equal_1388) & and_1406) : (less_1408 & (~or_1412));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s20_q ? (right_2_s20_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1423;
  assign sum_1423 = {2'h0, slot_s20_q} + 5'h1f;
  // hls/stages/registration.hpp:243
  logic not_1429;
  assign not_1429 = ~lower_half_s20_q;
  logic [3:0] select_1430;
  assign select_1430 = registration_of_right_q ? {lower_half_s20_q, 1'b0, not_1429, 1'b0} : {1'b0, lower_half_s20_q, 1'b0, not_1429};
  // hls/stages/agreement.hpp:658
  logic [6:0] select_1466;
  assign select_1466 = segment_started_s20_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:659
  logic [6:0] sum_1467;
  assign sum_1467 = {6'h0, textured_s20_q} + select_1466;
  // hls/stages/agreement.hpp:791
  logic [9:0] sum_1469;
  assign sum_1469 = {3'h0, sum_1467} + (region_fresh_s20_q ? 10'h0 : regions_rdata_s20_q[9:0]);
  // hls/stages/agreement.hpp:658
  logic [6:0] select_1471;
  assign select_1471 = segment_started_s20_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:659
  logic [6:0] sum_1472;
  assign sum_1472 = {6'h0, explained_s20_q} + select_1471;
  // hls/stages/agreement.hpp:792
  logic [9:0] sum_1474;
  assign sum_1474 = {3'h0, sum_1472} + (region_fresh_s20_q ? 10'h0 : regions_rdata_s20_q[19:10]);
  // hls/stages/agreement.hpp:658
  logic [6:0] select_1477;
  assign select_1477 = segment_started_s20_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:660
  logic [6:0] sum_1478;
  assign sum_1478 = {6'h0, and_1476_s20_q} + select_1477;
  // hls/stages/agreement.hpp:793
  logic [9:0] sum_1480;
  assign sum_1480 = {3'h0, sum_1478} + (region_fresh_s20_q ? 10'h0 : regions_rdata_s20_q[29:20]);
  // hls/stages/agreement.hpp:983
  logic or_1490;
  assign or_1490 = marks_first_s20_q | line_ended_q;
  // hls/stages/agreement.hpp:985
  logic [13:0] select_1492;
  assign select_1492 = marks_first_s20_q ? 14'h1 : (or_1490 ? {rows_passed_q[12:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:984
  logic [8:0] select_1494;
  assign select_1494 = or_1490 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:992
  logic select_1496;
  assign select_1496 = cfg_compete_i ? (or_1490 & select_1492[13]) : (select_1494[8] & select_1492[9]);
  // hls/stages/agreement.hpp:824
  logic [2:0] select_1530;
  assign select_1530 = age_s20_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:826
  logic [4:0] around;
  assign around = {difference_1566_s20_q[3], difference_1566_s20_q} + (equal_1532_s20_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:827
  logic [4:0] n;
  assign n = {difference_1582_s20_q[3], difference_1582_s20_q} + (equal_1532_s20_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:129
  logic [9:0] xor_1633;
  assign xor_1633 = {difference_1632_s20_q[8:0], sum_1631_s20_q} ^ {10{difference_1632_s20_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_1632_s20_q[9]} + {1'b0, xor_1633};
  logic [9:0] xor_1641;
  assign xor_1641 = {difference_1640_s20_q[8:0], sum_1639_s20_q} ^ {10{difference_1640_s20_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1640_s20_q[9]} + {1'b0, xor_1641};
  // hls/stages/agreement.hpp:365
  logic select_1656;
  assign select_1656 = and_368_s20_q ? whole_2_s20_q : census_columns_values_0_cell_0_mask_q;
  logic select_1672;
  assign select_1672 = and_368_s20_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1675;
  assign select_1675 = and_368_s20_q ? census_columns_values_0_cell_1_mask_s20_q : census_columns_values_1_cell_1_mask_q;
  logic select_1678;
  assign select_1678 = and_368_s20_q ? census_columns_values_0_cell_2_mask_s20_q : census_columns_values_1_cell_2_mask_q;
  logic select_1682;
  assign select_1682 = and_368_s20_q ? census_columns_values_0_cell_3_mask_s20_q : census_columns_values_1_cell_3_mask_q;
  logic select_1685;
  assign select_1685 = and_368_s20_q ? census_columns_values_0_cell_4_mask_s20_q : census_columns_values_1_cell_4_mask_q;
  logic select_1688;
  assign select_1688 = and_368_s20_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1691;
  assign select_1691 = and_368_s20_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] sum_1713;
  assign sum_1713 = {9'h0, difference_1711_s20_q} + {1'b0, xor_1712_s20_q};
  logic [9:0] sum_1716;
  assign sum_1716 = {9'h0, difference_1714_s20_q} + {1'b0, xor_1715_s20_q};
  // hls/stages/census.hpp:273
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1756_s20_q} + xor_1757_s20_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1767_s20_q} + xor_1768_s20_q;
  // hls/stages/agreement.hpp:211
  logic and_1988;
  assign and_1988 = not_1336_s20_q & (so_s20_q & (ends_cell_s20_q & explained_s20_q));
  // hls/stages/agreement.hpp:681
  logic [13:0] select_1990;
  assign select_1990 = and_1974_s20_q ? 14'h0 : (counts_explained_q + {13'h0, and_1988});
  // hls/stages/agreement.hpp:211
  logic and_1993;
  assign and_1993 = not_1336_s20_q & (so_s20_q & (ends_cell_s20_q & and_1476_s20_q));
  // hls/stages/agreement.hpp:825
  logic [4:0] e;
  assign e = {difference_2007_s20_q[3], difference_2007_s20_q} + (equal_1532_s20_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:861
  logic less_2022;
  assign less_2022 = region_row_s20_q < x_s20_q[5:3];
  // hls/stages/registration.hpp:107
  logic equal_2106;
  assign equal_2106 = slot_s20_q == 3'h4;
  // hls/stages/registration.hpp:101
  logic [11:0] value_2;
  assign value_2 = {{4{select_2119_s20_q[7]}}, select_2119_s20_q} - {sum_2130_s20_q[9], sum_2130_s20_q, sum_2126_s20_q};
  // hls/stages/agreement.hpp:211
  logic select_2177;
  assign select_2177 = so_s20_q ? (equal_2106 ? right_2_s20_q : registration_of_right_q) : registration_of_right_q;
  logic select_2180;
  assign select_2180 = so_s20_q ? (equal_2082_s20_q ? inside_v_s20_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:859
  logic [1:0] quarter_2;
  assign quarter_2 = all_s20_q ? x_s20_q[1:0] : select_1383;
  // hls/stages/agreement.hpp:943
  logic [13:0] select_2391;
  assign select_2391 = equal_2357_s20_q ? 14'h0 : product_q;
  logic [13:0] select_2406;
  assign select_2406 = equal_2402_s20_q ? 14'h0 : of_s20_q;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2391} + {1'b0, select_2406};
  // hls/stages/agreement.hpp:211
  logic [2:0] select_2424;
  assign select_2424 = ends_cell_s20_q ? textured_2_s20_q : box_textured_columns_values_0_q;
  logic [2:0] select_2426;
  assign select_2426 = equal_1335_s20_q ? box_textured_columns_values_0_q : (so_s20_q ? select_2424 : box_textured_columns_values_0_q);
  logic [2:0] select_2427;
  assign select_2427 = ends_cell_s20_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2429;
  assign select_2429 = equal_1335_s20_q ? box_textured_columns_values_1_q : (so_s20_q ? select_2427 : box_textured_columns_values_1_q);
  logic [2:0] select_2430;
  assign select_2430 = ends_cell_s20_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2432;
  assign select_2432 = equal_1335_s20_q ? box_textured_columns_values_2_q : (so_s20_q ? select_2430 : box_textured_columns_values_2_q);
  logic [2:0] select_2433;
  assign select_2433 = ends_cell_s20_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2435;
  assign select_2435 = equal_1335_s20_q ? box_textured_columns_values_3_q : (so_s20_q ? select_2433 : box_textured_columns_values_3_q);
  logic [2:0] select_2436;
  assign select_2436 = ends_cell_s20_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2438;
  assign select_2438 = equal_1335_s20_q ? box_textured_columns_values_4_q : (so_s20_q ? select_2436 : box_textured_columns_values_4_q);
  logic [4:0] select_2458;
  assign select_2458 = so_s20_q ? (ends_cell_s20_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2459;
  assign select_2459 = equal_1335_s20_q ? box_explained_sum_sums_values_0_q : select_2458;
  logic [4:0] select_2476;
  assign select_2476 = so_s20_q ? (ends_cell_s20_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_2494;
  assign select_2494 = so_s20_q ? (ends_cell_s20_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;

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
    end else if (s20_en) begin
      counts_explained_q <= select_1990;
      registration_of_right_q <= equal_1335_s20_q ? registration_of_right_q : select_2177;
      registration_was_inside_q <= equal_1335_s20_q ? registration_was_inside_q : select_2180;
      segment_textured_q <= select_1466 + {6'h0, and_1983_s20_q};
      segment_explained_q <= select_1471 + {6'h0, and_1988};
      segment_nearer_q <= select_1477 + {6'h0, and_1993};
      product_q <= equal_1335_s20_q ? sum_3[14:1] : product_q;
      rows_passed_q <= select_1492;
      columns_passed_q <= {select_1494[7:0], or_1490};
      line_ended_q <= marks_last_s20_q;
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
    if (s20_en) begin
      census_columns_values_0_cell_0_mask_q <= select_1656;
      census_columns_values_1_cell_0_mask_q <= select_1672;
      census_columns_values_1_cell_1_mask_q <= select_1675;
      census_columns_values_1_cell_2_mask_q <= select_1678;
      census_columns_values_1_cell_3_mask_q <= select_1682;
      census_columns_values_1_cell_4_mask_q <= select_1685;
      census_columns_values_2_cell_0_mask_q <= select_1688;
      census_columns_values_2_cell_1_mask_q <= select_1691;
      box_textured_columns_values_0_q <= select_2426;
      box_textured_columns_values_1_q <= select_2429;
      box_textured_columns_values_2_q <= select_2432;
      box_textured_columns_values_3_q <= select_2435;
      box_textured_columns_values_4_q <= select_2438;
      box_explained_sum_sums_values_0_q <= select_2459;
      box_shown_sum_sums_values_0_q <= equal_1335_s20_q ? box_shown_sum_sums_values_0_q : select_2476;
      box_nearer_sum_sums_values_0_q <= equal_1335_s20_q ? box_nearer_sum_sums_values_0_q : select_2494;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
  logic mask_s21_q;
  logic marks_first_s21_q;
  logic sample_pair_whole_s21_q;
  logic census_columns_values_1_cell_2_mask_s21_q;
  logic census_columns_values_1_cell_2_of_skin_s21_q;
  logic census_columns_values_1_cell_3_mask_s21_q;
  logic census_columns_values_1_cell_4_mask_s21_q;
  logic census_columns_values_2_cell_0_mask_s21_q;
  logic census_columns_values_2_cell_1_mask_s21_q;
  logic [7:0] x_s21_q;
  logic [2:0] slot_s21_q;
  logic ends_cell_s21_q;
  logic lower_half_s21_q;
  logic [13:0] counts_textured_s21_q;
  logic [13:0] counts_explained_s21_q;
  logic registration_of_right_s21_q;
  logic [2:0] region_row_s21_q;
  logic [13:0] product_s21_q;
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
  logic whole_9_s21_q;
  logic [10:0] sum_466_s21_q;
  logic [9:0] sum_469_s21_q;
  logic [9:0] sum_473_s21_q;
  logic [9:0] sum_477_s21_q;
  logic equal_1335_s21_q;
  logic not_1336_s21_q;
  logic equal_1380_s21_q;
  logic [1:0] quarter_s21_q;
  logic all_s21_q;
  logic [1:0] sum_1386_s21_q;
  logic [3:0] select_1387_s21_q;
  logic equal_1388_s21_q;
  logic equal_1390_s21_q;
  logic equal_1392_s21_q;
  logic equal_1394_s21_q;
  logic equal_1396_s21_q;
  logic equal_1398_s21_q;
  logic equal_1400_s21_q;
  logic less_1408_s21_q;
  logic or_1412_s21_q;
  logic select_1415_s21_q;
  logic and_1425_s21_q;
  logic [3:0] select_1430_s21_q;
  logic or_1446_s21_q;
  logic or_1449_s21_q;
  logic or_1452_s21_q;
  logic not_1454_s21_q;
  logic [9:0] sum_1469_s21_q;
  logic [9:0] sum_1474_s21_q;
  logic [9:0] sum_1480_s21_q;
  logic and_1481_s21_q;
  logic select_1496_s21_q;
  logic [3:0] difference_1531_s21_q;
  logic equal_1532_s21_q;
  logic or_1540_s21_q;
  logic or_1543_s21_q;
  logic or_1546_s21_q;
  logic [4:0] around_s21_q;
  logic less_1585_s21_q;
  logic and_1596_s21_q;
  logic [10:0] size_s21_q;
  logic [10:0] size_2_s21_q;
  logic [10:0] sum_1717_s21_q;
  logic [9:0] sum_1720_s21_q;
  logic [9:0] sum_1724_s21_q;
  logic [9:0] sum_1728_s21_q;
  logic equal_1736_s21_q;
  logic [8:0] contrast_s21_q;
  logic [8:0] contrast_2_s21_q;
  logic equal_1857_s21_q;
  logic and_1974_s21_q;
  logic and_1978_s21_q;
  logic and_1993_s21_q;
  logic not_1997_s21_q;
  logic [4:0] e_s21_q;
  logic [9:0] select_2023_s21_q;
  logic [9:0] select_2026_s21_q;
  logic equal_2082_s21_q;
  logic and_2109_s21_q;
  logic and_2111_s21_q;
  logic [11:0] select_2133_s21_q;
  logic equal_2182_s21_q;
  logic [3:0] not_2183_s21_q;
  logic [1:0] quarter_2_s21_q;
  logic equal_2357_s21_q;
  logic and_2358_s21_q;
  logic less_2359_s21_q;
  logic equal_2360_s21_q;
  logic equal_2377_s21_q;
  logic equal_2379_s21_q;
  logic equal_2380_s21_q;
  logic sum_3_s21_q;
  logic equal_2509_s21_q;
  logic [9:0] select_2602_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= mask_s20_q;
      marks_first_s21_q <= marks_first_s20_q;
      sample_pair_whole_s21_q <= sample_pair_whole_s20_q;
      census_columns_values_1_cell_2_mask_s21_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s21_q <= census_columns_values_1_cell_2_of_skin_s20_q;
      census_columns_values_1_cell_3_mask_s21_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s21_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s21_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s21_q <= census_columns_values_2_cell_1_mask_q;
      x_s21_q <= x_s20_q;
      slot_s21_q <= slot_s20_q;
      ends_cell_s21_q <= ends_cell_s20_q;
      lower_half_s21_q <= lower_half_s20_q;
      counts_textured_s21_q <= counts_textured_s20_q;
      counts_explained_s21_q <= counts_explained_q;
      registration_of_right_s21_q <= registration_of_right_q;
      region_row_s21_q <= region_row_s20_q;
      product_s21_q <= product_q;
      centres_values_1_textured_s21_q <= centres_values_1_textured_s20_q;
      centres_values_1_of_skin_s21_q <= centres_values_1_of_skin_s20_q;
      column_s21_q <= column_s20_q;
      and_366_s21_q <= and_366_s20_q;
      and_368_s21_q <= and_368_s20_q;
      equal_371_s21_q <= equal_371_s20_q;
      whole_2_s21_q <= whole_2_s20_q;
      so_s21_q <= so_s20_q;
      less_402_s21_q <= less_402_s20_q;
      less_403_s21_q <= less_403_s20_q;
      less_404_s21_q <= less_404_s20_q;
      less_405_s21_q <= less_405_s20_q;
      less_406_s21_q <= less_406_s20_q;
      less_407_s21_q <= less_407_s20_q;
      less_408_s21_q <= less_408_s20_q;
      less_409_s21_q <= less_409_s20_q;
      less_410_s21_q <= less_410_s20_q;
      less_411_s21_q <= less_411_s20_q;
      less_412_s21_q <= less_412_s20_q;
      less_413_s21_q <= less_413_s20_q;
      less_414_s21_q <= less_414_s20_q;
      less_415_s21_q <= less_415_s20_q;
      less_416_s21_q <= less_416_s20_q;
      less_417_s21_q <= less_417_s20_q;
      less_418_s21_q <= less_418_s20_q;
      less_419_s21_q <= less_419_s20_q;
      less_420_s21_q <= less_420_s20_q;
      less_421_s21_q <= less_421_s20_q;
      less_422_s21_q <= less_422_s20_q;
      less_423_s21_q <= less_423_s20_q;
      less_424_s21_q <= less_424_s20_q;
      less_425_s21_q <= less_425_s20_q;
      and_433_s21_q <= and_433_s20_q;
      whole_9_s21_q <= whole_9;
      sum_466_s21_q <= {1'b0, sum_462} + {1'b0, sum_465};
      sum_469_s21_q <= {9'h0, difference_467_s20_q} + {1'b0, xor_468_s20_q};
      sum_473_s21_q <= {9'h0, difference_471_s20_q} + {1'b0, xor_472_s20_q};
      sum_477_s21_q <= {9'h0, difference_475_s20_q} + {1'b0, xor_476_s20_q};
      equal_1335_s21_q <= equal_1335_s20_q;
      not_1336_s21_q <= not_1336_s20_q;
      equal_1380_s21_q <= equal_1380_s20_q;
      quarter_s21_q <= quarter;
      all_s21_q <= all_s20_q;
      sum_1386_s21_q <= sum_1386;
      select_1387_s21_q <= select_1387;
      equal_1388_s21_q <= equal_1388;
      equal_1390_s21_q <= equal_1390;
      equal_1392_s21_q <= equal_1392;
      equal_1394_s21_q <= equal_1394_s20_q;
      equal_1396_s21_q <= equal_1396_s20_q;
      equal_1398_s21_q <= equal_1398_s20_q;
      equal_1400_s21_q <= equal_1400_s20_q;
      less_1408_s21_q <= less_1408;
      or_1412_s21_q <= or_1412;
      select_1415_s21_q <= select_1415;
      and_1425_s21_q <= half_ends & ({{3{sum_1423[4]}}, sum_1423} < 8'h3);
      select_1430_s21_q <= select_1430;
      or_1446_s21_q <= or_1446_s20_q;
      or_1449_s21_q <= or_1449_s20_q;
      or_1452_s21_q <= or_1452_s20_q;
      not_1454_s21_q <= not_1454_s20_q;
      sum_1469_s21_q <= sum_1469;
      sum_1474_s21_q <= sum_1474;
      sum_1480_s21_q <= sum_1480;
      and_1481_s21_q <= and_1481_s20_q;
      select_1496_s21_q <= select_1496;
      difference_1531_s21_q <= {1'b0, textured_2_s20_q} - {1'b0, select_1530};
      equal_1532_s21_q <= equal_1532_s20_q;
      or_1540_s21_q <= or_1540_s20_q;
      or_1543_s21_q <= or_1543_s20_q;
      or_1546_s21_q <= or_1546_s20_q;
      around_s21_q <= around;
      less_1585_s21_q <= {1'b0, around[4:1]} < n;
      and_1596_s21_q <= and_1596_s20_q;
      size_s21_q <= size;
      size_2_s21_q <= size_2;
      sum_1717_s21_q <= {1'b0, sum_1713} + {1'b0, sum_1716};
      sum_1720_s21_q <= {9'h0, difference_1718_s20_q} + {1'b0, xor_1719_s20_q};
      sum_1724_s21_q <= {9'h0, difference_1722_s20_q} + {1'b0, xor_1723_s20_q};
      sum_1728_s21_q <= {9'h0, difference_1726_s20_q} + {1'b0, xor_1727_s20_q};
      equal_1736_s21_q <= equal_1736_s20_q;
      contrast_s21_q <= contrast;
      contrast_2_s21_q <= contrast_2;
      equal_1857_s21_q <= equal_1857_s20_q;
      and_1974_s21_q <= and_1974_s20_q;
      and_1978_s21_q <= and_1978_s20_q;
      and_1993_s21_q <= and_1993;
      not_1997_s21_q <= not_1997_s20_q;
      e_s21_q <= e;
      select_2023_s21_q <= less_2022 ? 10'h0 : regions_rdata_s20_q[9:0];
      select_2026_s21_q <= less_2022 ? 10'h0 : regions_rdata_s20_q[19:10];
      equal_2082_s21_q <= equal_2082_s20_q;
      and_2109_s21_q <= not_1336_s20_q & (so_s20_q & (half_ends & equal_2106));
      and_2111_s21_q <= and_2111_s20_q;
      select_2133_s21_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2182_s21_q <= sum_1386 == 2'h2;
      not_2183_s21_q <= ~select_1430;
      quarter_2_s21_q <= quarter_2;
      equal_2357_s21_q <= equal_2357_s20_q;
      and_2358_s21_q <= and_2358_s20_q;
      less_2359_s21_q <= counts_explained_q < product_q;
      equal_2360_s21_q <= counts_explained_q == product_q;
      equal_2377_s21_q <= equal_2377_s20_q;
      equal_2379_s21_q <= equal_2379_s20_q;
      equal_2380_s21_q <= equal_2380_s20_q;
      sum_3_s21_q <= sum_3[0];
      equal_2509_s21_q <= equal_2509_s20_q;
      select_2602_s21_q <= less_2022 ? 10'h0 : regions_rdata_s20_q[29:20];
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:310
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s21_q & whole_9_s21_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s21_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s21_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s21_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s21_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:190
  logic [10:0] sum_470;
  assign sum_470 = sum_466_s21_q + {1'b0, sum_469_s21_q};
  // hls/stages/agreement.hpp:211
  logic and_1426;
  assign and_1426 = so_s21_q & and_1425_s21_q;
  // hls/stages/agreement.hpp:218
  logic next_row;
  assign next_row = select_1496_s21_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:999
  logic [6:0] select_1499;
  assign select_1499 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1009
  logic equal_1502;
  assign equal_1502 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:982
  logic not_1509;
  assign not_1509 = ~marks_first_s21_q;
  // hls/stages/agreement.hpp:824
  logic [4:0] t;
  assign t = {difference_1531_s21_q[3], difference_1531_s21_q} + (equal_1532_s21_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:831
  logic not_1547;
  assign not_1547 = ~region_row_s21_q[2];
  logic [2:0] select_1548;
  assign select_1548 = region_row_s21_q[1] ? {1'b0, not_1547, 1'b0} : {region_row_s21_q[2], 1'b0, not_1547};
  logic [5:0] select_1549;
  assign select_1549 = region_row_s21_q[0] ? {select_1548[2], 1'b0, select_1548[1], 1'b0, select_1548[0], 1'b0} : {1'b0, select_1548[2], 1'b0, select_1548[1], 1'b0, select_1548[0]};
  logic [11:0] select_1550;
  assign select_1550 = or_1546_s21_q ? {select_1549[5], 1'b0, select_1549[4], 1'b0, select_1549[3], 1'b0, select_1549[2], 1'b0, select_1549[1], 1'b0, select_1549[0], 1'b0} : {1'b0, select_1549[5], 1'b0, select_1549[4], 1'b0, select_1549[3], 1'b0, select_1549[2], 1'b0, select_1549[1], 1'b0, select_1549[0]};
  logic [23:0] select_1551;
  assign select_1551 = or_1543_s21_q ? {select_1550[11], 1'b0, select_1550[10], 1'b0, select_1550[9], 1'b0, select_1550[8], 1'b0, select_1550[7], 1'b0, select_1550[6], 1'b0, select_1550[5], 1'b0, select_1550[4], 1'b0, select_1550[3], 1'b0, select_1550[2], 1'b0, select_1550[1], 1'b0, select_1550[0], 1'b0} : {1'b0, select_1550[11], 1'b0, select_1550[10], 1'b0, select_1550[9], 1'b0, select_1550[8], 1'b0, select_1550[7], 1'b0, select_1550[6], 1'b0, select_1550[5], 1'b0, select_1550[4], 1'b0, select_1550[3], 1'b0, select_1550[2], 1'b0, select_1550[1], 1'b0, select_1550[0]};
  // hls/stages/agreement.hpp:833
  logic [5:0] sum_1569;
  assign sum_1569 = {1'b0, around_s21_q} + {2'h0, around_s21_q[4:1]};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_s21_q} + (equal_371_s21_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_1638;
  assign select_1638 = sample_pair_whole_s21_q ? (and_366_s21_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s21_q} + (equal_371_s21_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_1646;
  assign select_1646 = sample_pair_whole_s21_q ? (and_366_s21_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:365
  logic select_1694;
  assign select_1694 = and_368_s21_q ? census_columns_values_1_cell_2_mask_s21_q : census_columns_values_2_cell_2_mask_q;
  logic select_1697;
  assign select_1697 = and_368_s21_q ? census_columns_values_1_cell_3_mask_s21_q : census_columns_values_2_cell_3_mask_q;
  logic select_1700;
  assign select_1700 = and_368_s21_q ? census_columns_values_1_cell_4_mask_s21_q : census_columns_values_2_cell_4_mask_q;
  logic select_1701;
  assign select_1701 = and_368_s21_q ? census_columns_values_2_cell_0_mask_s21_q : census_columns_values_3_cell_0_mask_q;
  logic select_1704;
  assign select_1704 = and_368_s21_q ? census_columns_values_2_cell_1_mask_s21_q : census_columns_values_3_cell_1_mask_q;
  logic select_1705;
  assign select_1705 = and_368_s21_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1708;
  assign select_1708 = and_368_s21_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:192
  logic [10:0] sum_1721;
  assign sum_1721 = sum_1717_s21_q + {1'b0, sum_1720_s21_q};
  // hls/stages/census.hpp:275
  logic and_1755;
  assign and_1755 = whole_2_s21_q & (~(column_s21_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:311
  logic and_1761;
  assign and_1761 = and_1755 & (sharpness_last_mask_q & (7'h2 < contrast_s21_q[8:2]));
  logic and_1772;
  assign and_1772 = and_1755 & (sharpness_last_mask_q & (7'h2 < contrast_2_s21_q[8:2]));
  // hls/stages/census.hpp:328
  logic not_1789;
  assign not_1789 = ~x_s21_q[1];
  logic [2:0] select_1790;
  assign select_1790 = x_s21_q[0] ? {1'b0, not_1789, 1'b0} : {x_s21_q[1], 1'b0, not_1789};
  logic [5:0] select_1791;
  assign select_1791 = slot_s21_q[2] ? {select_1790[2], 1'b0, select_1790[1], 1'b0, select_1790[0], 1'b0} : {1'b0, select_1790[2], 1'b0, select_1790[1], 1'b0, select_1790[0]};
  logic [11:0] select_1792;
  assign select_1792 = slot_s21_q[1] ? {select_1791[5], 1'b0, select_1791[4], 1'b0, select_1791[3], 1'b0, select_1791[2], 1'b0, select_1791[1], 1'b0, select_1791[0], 1'b0} : {1'b0, select_1791[5], 1'b0, select_1791[4], 1'b0, select_1791[3], 1'b0, select_1791[2], 1'b0, select_1791[1], 1'b0, select_1791[0]};
  // hls/stages/agreement.hpp:681
  logic [13:0] select_1980;
  assign select_1980 = and_1974_s21_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1978_s21_q});
  // hls/stages/agreement.hpp:832
  logic [5:0] sum_2010;
  assign sum_2010 = {1'b0, e_s21_q} + {2'h0, e_s21_q[4:1]};
  // hls/stages/registration.hpp:206
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2133_s21_q[11:7])) ? 12'h7f : select_2133_s21_q;
  // hls/stages/registration.hpp:254
  logic [3:0] select_2185;
  assign select_2185 = equal_2182_s21_q ? (registration_fresh_q & not_2183_s21_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_2187;
  assign select_2187 = so_s21_q ? (and_1425_s21_q ? select_2185 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:227
  logic [3:0] select_2189;
  assign select_2189 = and_1974_s21_q ? 4'hf : (equal_1335_s21_q ? registration_fresh_q : select_2187);
  // hls/stages/registration.hpp:243
  logic not_2210;
  assign not_2210 = ~quarter_2_s21_q[1];
  logic [3:0] select_2211;
  assign select_2211 = quarter_2_s21_q[0] ? {quarter_2_s21_q[1], 1'b0, not_2210, 1'b0} : {1'b0, quarter_2_s21_q[1], 1'b0, not_2210};
  // hls/stages/agreement.hpp:908
  logic or_2354;
  assign or_2354 = ({counts_textured_s21_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s21_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:939
  logic too_little;
  assign too_little = less_2359_s21_q | (product_rest_q & equal_2360_s21_q);
  // hls/stages/agreement.hpp:940
  logic select_2363;
  assign select_2363 = and_2358_s21_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:864
  logic [10:0] sum_2366;
  assign sum_2366 = {1'b0, select_2026_s21_q} + {2'h0, select_2026_s21_q[9:1]};
  // hls/stages/agreement.hpp:211
  logic select_2411;
  assign select_2411 = equal_1335_s21_q ? (equal_2357_s21_q ? sum_3_s21_q : (product_rest_q | sum_3_s21_q)) : product_rest_q;
  logic [4:0] select_2440;
  assign select_2440 = so_s21_q ? (ends_cell_s21_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_2441;
  assign select_2441 = equal_1335_s21_q ? box_textured_sum_sums_values_0_q : select_2440;
  // hls/stages/agreement.hpp:1008
  logic [3:0] select_2526;
  assign select_2526 = select_1496_s21_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:218
  logic [7:0] select_2532;
  assign select_2532 = marks_first_s21_q ? (less_2528 ? {sum_2529, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:243
  logic not_2590;
  assign not_2590 = ~quarter_s21_q[1];
  logic [3:0] select_2591;
  assign select_2591 = quarter_s21_q[0] ? {quarter_s21_q[1], 1'b0, not_2590, 1'b0} : {1'b0, quarter_s21_q[1], 1'b0, not_2590};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:261; read in stage 21, written in stage 25: 21 < 25 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1387_s21_q;
  logic registration_sums_re;
  assign registration_sums_re = s21_en & (equal_1335_s21_q ? (x_s21_q[6] & select_1415_s21_q) : and_1426);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s21_q, or_1452_s21_q, or_1449_s21_q, or_1446_s21_q};
  logic regions_we;
  assign regions_we = s21_en & and_1481_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1480_s21_q, sum_1474_s21_q, sum_1469_s21_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s19_sim;
  logic regions_re_s19_sim;
  logic [5:0] regions_raddr_s20_sim;
  logic regions_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s19_sim <= 1'b0;
      regions_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s19_sim <= regions_re;
      regions_raddr_s19_sim <= regions_raddr;
      regions_re_s20_sim <= regions_re_s19_sim;
      regions_raddr_s20_sim <= regions_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s19_sim && regions_raddr_s19_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s20_sim && regions_raddr_s20_sim == regions_waddr) begin
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
    end else if (s21_en) begin
      counts_supervised_q <= select_1980;
      registration_fresh_q <= select_2189;
      product_rest_q <= select_2411;
      disagree_q <= equal_1335_s21_q ? select_2363 : disagree_q;
      began_q <= not_1509 & (began_q | select_1496_s21_q);
      seen_x_q <= select_1496_s21_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s21_q ? 4'h0 : select_2526;
      seen_column_q <= select_1496_s21_q ? 8'h0 : (seen_column_q + {7'h0, equal_1502});
      seen_rows_left_q <= select_2532;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s21_q ? 13'h0 : (seen_base_q + {6'h0, select_1499});
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
    if (s21_en) begin
      averager_detail_0_q <= select_1638;
      averager_detail_1_q <= select_1646;
      census_columns_values_2_cell_2_mask_q <= select_1694;
      census_columns_values_2_cell_3_mask_q <= select_1697;
      census_columns_values_2_cell_4_mask_q <= select_1700;
      census_columns_values_3_cell_0_mask_q <= select_1701;
      census_columns_values_3_cell_1_mask_q <= select_1704;
      census_columns_values_3_cell_2_mask_q <= select_1705;
      census_columns_values_3_cell_3_mask_q <= select_1708;
      sharpness_last_mask_q <= and_368_s21_q ? whole_2_s21_q : sharpness_last_mask_q;
      box_textured_sum_sums_values_0_q <= select_2441;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic census_columns_values_2_cell_4_mask_s22_q;
  logic census_columns_values_3_cell_0_mask_s22_q;
  logic census_columns_values_3_cell_1_mask_s22_q;
  logic census_columns_values_3_cell_2_mask_s22_q;
  logic census_columns_values_3_cell_3_mask_s22_q;
  logic [6:0] x_s22_q;
  logic slot_s22_q;
  logic ends_cell_s22_q;
  logic lower_half_s22_q;
  logic [13:0] counts_supervised_s22_q;
  logic [13:0] counts_textured_s22_q;
  logic [13:0] counts_explained_s22_q;
  logic registration_of_right_s22_q;
  logic [13:0] product_s22_q;
  logic centres_values_1_textured_s22_q;
  logic centres_values_1_of_skin_s22_q;
  logic [6:0] column_s22_q;
  logic and_368_s22_q;
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
  logic whole_16_s22_q;
  logic and_459_s22_q;
  logic [11:0] sum_474_s22_q;
  logic [9:0] sum_477_s22_q;
  logic equal_1335_s22_q;
  logic not_1336_s22_q;
  logic equal_1380_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1386_s22_q;
  logic equal_1388_s22_q;
  logic equal_1390_s22_q;
  logic equal_1392_s22_q;
  logic equal_1394_s22_q;
  logic equal_1396_s22_q;
  logic equal_1398_s22_q;
  logic equal_1400_s22_q;
  logic less_1408_s22_q;
  logic or_1412_s22_q;
  logic equal_1432_s22_q;
  logic and_1442_s22_q;
  logic not_1454_s22_q;
  logic not_1509_s22_q;
  logic [7:0] sum_1519_s22_q;
  logic equal_1535_s22_q;
  logic or_1540_s22_q;
  logic [23:0] select_1551_s22_q;
  logic not_1571_s22_q;
  logic less_1585_s22_q;
  logic and_1596_s22_q;
  logic [11:0] sum_1725_s22_q;
  logic [9:0] sum_1728_s22_q;
  logic equal_1736_s22_q;
  logic [27:0] select_1750_s22_q;
  logic and_1761_s22_q;
  logic and_1772_s22_q;
  logic [8:0] select_1779_s22_q;
  logic [8:0] select_1783_s22_q;
  logic equal_1786_s22_q;
  logic less_1787_s22_q;
  logic [11:0] select_1792_s22_q;
  logic equal_1830_s22_q;
  logic equal_1857_s22_q;
  logic and_1974_s22_q;
  logic and_1993_s22_q;
  logic not_1997_s22_q;
  logic not_2012_s22_q;
  logic [9:0] select_2023_s22_q;
  logic [9:0] select_2026_s22_q;
  logic equal_2082_s22_q;
  logic and_2109_s22_q;
  logic and_2111_s22_q;
  logic [11:0] residual_s22_q;
  logic equal_2213_s22_q;
  logic equal_2351_s22_q;
  logic or_2354_s22_q;
  logic equal_2357_s22_q;
  logic select_2363_s22_q;
  logic not_2368_s22_q;
  logic equal_2377_s22_q;
  logic equal_2379_s22_q;
  logic equal_2380_s22_q;
  logic equal_2509_s22_q;
  logic equal_2593_s22_q;
  logic [9:0] select_2602_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= line_ended_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_s21_q;
      census_columns_values_2_cell_4_mask_s22_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s22_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s22_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s22_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s22_q <= census_columns_values_3_cell_3_mask_q;
      x_s22_q <= x_s21_q[6:0];
      slot_s22_q <= slot_s21_q[0];
      ends_cell_s22_q <= ends_cell_s21_q;
      lower_half_s22_q <= lower_half_s21_q;
      counts_supervised_s22_q <= counts_supervised_q;
      counts_textured_s22_q <= counts_textured_s21_q;
      counts_explained_s22_q <= counts_explained_s21_q;
      registration_of_right_s22_q <= registration_of_right_s21_q;
      product_s22_q <= product_s21_q;
      centres_values_1_textured_s22_q <= centres_values_1_textured_s21_q;
      centres_values_1_of_skin_s22_q <= centres_values_1_of_skin_s21_q;
      column_s22_q <= column_s21_q;
      and_368_s22_q <= and_368_s21_q;
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
      whole_16_s22_q <= whole_16;
      and_459_s22_q <= census_columns_values_1_cell_2_mask_s21_q & and_433_s21_q;
      sum_474_s22_q <= {1'b0, sum_470} + {2'h0, sum_473_s21_q};
      sum_477_s22_q <= sum_477_s21_q;
      equal_1335_s22_q <= equal_1335_s21_q;
      not_1336_s22_q <= not_1336_s21_q;
      equal_1380_s22_q <= equal_1380_s21_q;
      all_s22_q <= all_s21_q;
      sum_1386_s22_q <= sum_1386_s21_q;
      equal_1388_s22_q <= equal_1388_s21_q;
      equal_1390_s22_q <= equal_1390_s21_q;
      equal_1392_s22_q <= equal_1392_s21_q;
      equal_1394_s22_q <= equal_1394_s21_q;
      equal_1396_s22_q <= equal_1396_s21_q;
      equal_1398_s22_q <= equal_1398_s21_q;
      equal_1400_s22_q <= equal_1400_s21_q;
      less_1408_s22_q <= less_1408_s21_q;
      or_1412_s22_q <= or_1412_s21_q;
      equal_1432_s22_q <= (registration_fresh_q & select_1430_s21_q) == 4'h0;
      and_1442_s22_q <= not_1336_s21_q & and_1426;
      not_1454_s22_q <= not_1454_s21_q;
      not_1509_s22_q <= not_1509;
      sum_1519_s22_q <= {2'h0, x_s21_q[7:2]} + 8'hff;
      equal_1535_s22_q <= t[4:1] == 4'h0;
      or_1540_s22_q <= or_1540_s21_q;
      select_1551_s22_q <= select_1551;
      not_1571_s22_q <= ~({sum_1569, around_s21_q[0]} < {2'h0, t});
      less_1585_s22_q <= less_1585_s21_q;
      and_1596_s22_q <= and_1596_s21_q;
      sum_1725_s22_q <= {1'b0, sum_1721} + {2'h0, sum_1724_s21_q};
      sum_1728_s22_q <= sum_1728_s21_q;
      equal_1736_s22_q <= equal_1736_s21_q;
      select_1750_s22_q <= sample_pair_whole_s21_q ? {detail_2, detail} : 28'h0;
      and_1761_s22_q <= and_1761;
      and_1772_s22_q <= and_1772;
      select_1779_s22_q <= and_1761 ? contrast_s21_q : 9'h0;
      select_1783_s22_q <= and_1772 ? contrast_2_s21_q : 9'h0;
      equal_1786_s22_q <= x_s21_q[7:3] == 5'h0;
      less_1787_s22_q <= 7'h2 < {x_s21_q[4:0], slot_s21_q[2:1]};
      select_1792_s22_q <= select_1792;
      equal_1830_s22_q <= {x_s21_q[4:0], slot_s21_q} == 8'h0;
      equal_1857_s22_q <= equal_1857_s21_q;
      and_1974_s22_q <= and_1974_s21_q;
      and_1993_s22_q <= and_1993_s21_q;
      not_1997_s22_q <= not_1997_s21_q;
      not_2012_s22_q <= ~({sum_2010, e_s21_q[0]} < {2'h0, t});
      select_2023_s22_q <= select_2023_s21_q;
      select_2026_s22_q <= select_2026_s21_q;
      equal_2082_s22_q <= equal_2082_s21_q;
      and_2109_s22_q <= and_2109_s21_q;
      and_2111_s22_q <= and_2111_s21_q;
      residual_s22_q <= residual;
      equal_2213_s22_q <= (registration_fresh_q & select_2211) == 4'h0;
      equal_2351_s22_q <= select_2023_s21_q[9:3] == 7'h0;
      or_2354_s22_q <= or_2354;
      equal_2357_s22_q <= equal_2357_s21_q;
      select_2363_s22_q <= select_2363;
      not_2368_s22_q <= ~({sum_2366, select_2026_s21_q[0]} < {2'h0, select_2023_s21_q});
      equal_2377_s22_q <= equal_2377_s21_q;
      equal_2379_s22_q <= equal_2379_s21_q;
      equal_2380_s22_q <= equal_2380_s21_q;
      equal_2509_s22_q <= equal_2509_s21_q;
      equal_2593_s22_q <= (registration_fresh_q & select_2591) == 4'h0;
      select_2602_s22_q <= select_2602_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:310
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s22_q & whole_16_s22_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s22_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s22_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s22_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s22_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:190
  logic [11:0] texture;
  assign texture = sum_474_s22_q + {2'h0, sum_477_s22_q};
  // hls/stages/agreement.hpp:1012
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:983
  logic select_1507;
  assign select_1507 = marks_first_s22_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:969
  logic [10:0] sum_1508;
  assign sum_1508 = {1'b0, {5{select_1507}}, 1'b0, {2{select_1507}}, 1'b0, select_1507} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:841
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1519_s22_q[7]}}, sum_1519_s22_q, x_s22_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:969
  logic [10:0] sum_1521;
  assign sum_1521 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:831
  logic [47:0] select_1552;
  assign select_1552 = or_1540_s22_q ? {select_1551_s22_q[23], 1'b0, select_1551_s22_q[22], 1'b0, select_1551_s22_q[21], 1'b0, select_1551_s22_q[20], 1'b0, select_1551_s22_q[19], 1'b0, select_1551_s22_q[18], 1'b0, select_1551_s22_q[17], 1'b0, select_1551_s22_q[16], 1'b0, select_1551_s22_q[15], 1'b0, select_1551_s22_q[14], 1'b0, select_1551_s22_q[13], 1'b0, select_1551_s22_q[12], 1'b0, select_1551_s22_q[11], 1'b0, select_1551_s22_q[10], 1'b0, select_1551_s22_q[9], 1'b0, select_1551_s22_q[8], 1'b0, select_1551_s22_q[7], 1'b0, select_1551_s22_q[6], 1'b0, select_1551_s22_q[5], 1'b0, select_1551_s22_q[4], 1'b0, select_1551_s22_q[3], 1'b0, select_1551_s22_q[2], 1'b0, select_1551_s22_q[1], 1'b0, select_1551_s22_q[0], 1'b0} : {1'b0, select_1551_s22_q[23], 1'b0, select_1551_s22_q[22], 1'b0, select_1551_s22_q[21], 1'b0, select_1551_s22_q[20], 1'b0, select_1551_s22_q[19], 1'b0, select_1551_s22_q[18], 1'b0, select_1551_s22_q[17], 1'b0, select_1551_s22_q[16], 1'b0, select_1551_s22_q[15], 1'b0, select_1551_s22_q[14], 1'b0, select_1551_s22_q[13], 1'b0, select_1551_s22_q[12], 1'b0, select_1551_s22_q[11], 1'b0, select_1551_s22_q[10], 1'b0, select_1551_s22_q[9], 1'b0, select_1551_s22_q[8], 1'b0, select_1551_s22_q[7], 1'b0, select_1551_s22_q[6], 1'b0, select_1551_s22_q[5], 1'b0, select_1551_s22_q[4], 1'b0, select_1551_s22_q[3], 1'b0, select_1551_s22_q[2], 1'b0, select_1551_s22_q[1], 1'b0, select_1551_s22_q[0]};
  // hls/stages/agreement.hpp:365
  logic select_1709;
  assign select_1709 = and_368_s22_q ? census_columns_values_2_cell_4_mask_s22_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [11:0] sum_1729;
  assign sum_1729 = sum_1725_s22_q + {2'h0, sum_1728_s22_q};
  // hls/stages/agreement.hpp:365
  logic [11:0] select_1731;
  assign select_1731 = and_368_s22_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1732;
  assign select_1732 = and_368_s22_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_1751;
  assign select_1751 = and_368_s22_q ? select_1750_s22_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_1752;
  assign select_1752 = and_368_s22_q ? select_1750_s22_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1750_s22_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1750_s22_q[27:14]};
  // hls/stages/census.hpp:277
  logic [23:0] sum_1780;
  assign sum_1780 = (equal_1736_s22_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1779_s22_q};
  logic [23:0] sum_1784;
  assign sum_1784 = (equal_1736_s22_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1783_s22_q};
  // hls/stages/census.hpp:328
  logic less_1788;
  assign less_1788 = x_s22_q[4:0] < 5'h3;
  logic [23:0] select_1793;
  assign select_1793 = slot_s22_q ? {select_1792_s22_q[11], 1'b0, select_1792_s22_q[10], 1'b0, select_1792_s22_q[9], 1'b0, select_1792_s22_q[8], 1'b0, select_1792_s22_q[7], 1'b0, select_1792_s22_q[6], 1'b0, select_1792_s22_q[5], 1'b0, select_1792_s22_q[4], 1'b0, select_1792_s22_q[3], 1'b0, select_1792_s22_q[2], 1'b0, select_1792_s22_q[1], 1'b0, select_1792_s22_q[0], 1'b0} : {1'b0, select_1792_s22_q[11], 1'b0, select_1792_s22_q[10], 1'b0, select_1792_s22_q[9], 1'b0, select_1792_s22_q[8], 1'b0, select_1792_s22_q[7], 1'b0, select_1792_s22_q[6], 1'b0, select_1792_s22_q[5], 1'b0, select_1792_s22_q[4], 1'b0, select_1792_s22_q[3], 1'b0, select_1792_s22_q[2], 1'b0, select_1792_s22_q[1], 1'b0, select_1792_s22_q[0]};
  // hls/stages/census.hpp:291
  logic and_1797;
  assign and_1797 = less_1788 & (~((sharpness_sums_contrast_1_q & select_1793) == 24'h0));
  logic and_1807;
  assign and_1807 = less_1788 & (~((sharpness_sums_contrast_0_q & select_1793) == 24'h0));
  // hls/stages/agreement.hpp:862
  logic [10:0] sum_2027;
  assign sum_2027 = {1'b0, select_2026_s22_q} + {3'h0, select_2026_s22_q[9:2]};
  // hls/stages/registration.hpp:193
  logic [12:0] difference_2154;
  assign difference_2154 = 13'h0 - {residual_s22_q[11], residual_s22_q};
  logic less_2169;
  assign less_2169 = $signed(difference_2154) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:864
  logic select_2369;
  assign select_2369 = equal_2351_s22_q ? ((~or_2354_s22_q) & (~select_2363_s22_q)) : not_2368_s22_q;
  // hls/stages/agreement.hpp:871
  logic [47:0] select_2371;
  assign select_2371 = x_s22_q[6] ? (equal_1380_s22_q ? good_q : {select_2369, good_q[47:1]}) : good_q;
  logic equal_2374;
  assign equal_2374 = x_s22_q == 7'h7f;
  // hls/stages/agreement.hpp:314
  logic [12:0] select_2512;
  assign select_2512 = equal_1857_s22_q ? (equal_2509_s22_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:365
  logic [6:0] select_2515;
  assign select_2515 = and_368_s22_q ? (equal_1857_s22_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
    end else if (s22_en) begin
      sharpness_sums_contrast_0_q <= and_368_s22_q ? sum_1780 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_368_s22_q ? sum_1784 : sharpness_sums_contrast_1_q;
      good_q <= equal_1335_s22_q ? select_2371 : good_q;
      map_row_q <= and_368_s22_q ? select_2512 : map_row_q;
      map_width_q <= select_2515;
      write_half_q <= marks_first_s22_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1507;
      done_q <= not_1509_s22_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s22_q;
      said_q <= equal_1335_s22_q & equal_2374;
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
    if (s22_en) begin
      census_columns_values_3_cell_4_mask_q <= select_1709;
      census_changes_values_0_left_q <= and_368_s22_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_368_s22_q ? sum_1729 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1731;
      census_changes_values_1_right_q <= select_1732;
      sharpness_last_detail_0_q <= select_1751;
      sharpness_last_detail_1_q <= select_1752;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic [11:0] census_changes_values_1_left_s23_q;
  logic [11:0] census_changes_values_1_right_s23_q;
  logic [23:0] sharpness_sums_contrast_0_s23_q;
  logic [23:0] sharpness_sums_contrast_1_s23_q;
  logic [6:0] x_s23_q;
  logic ends_cell_s23_q;
  logic lower_half_s23_q;
  logic [13:0] counts_supervised_s23_q;
  logic [13:0] counts_textured_s23_q;
  logic [13:0] counts_explained_s23_q;
  logic registration_of_right_s23_q;
  logic [13:0] product_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic done_s23_q;
  logic [6:0] column_s23_q;
  logic and_368_s23_q;
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
  logic and_458_s23_q;
  logic and_459_s23_q;
  logic [12:0] sum_479_s23_q;
  logic equal_1335_s23_q;
  logic not_1336_s23_q;
  logic equal_1380_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1386_s23_q;
  logic equal_1388_s23_q;
  logic equal_1390_s23_q;
  logic equal_1392_s23_q;
  logic equal_1394_s23_q;
  logic equal_1396_s23_q;
  logic equal_1398_s23_q;
  logic equal_1400_s23_q;
  logic less_1408_s23_q;
  logic or_1412_s23_q;
  logic [31:0] registration_sums_rdata_s23_q;
  logic equal_1432_s23_q;
  logic and_1442_s23_q;
  logic not_1454_s23_q;
  logic [2:0] index_s23_q;
  logic [10:0] sum_1508_s23_q;
  logic and_1515_s23_q;
  logic less_1516_s23_q;
  logic [2:0] index_2_s23_q;
  logic [10:0] sum_1521_s23_q;
  logic equal_1535_s23_q;
  logic not_1555_s23_q;
  logic not_1571_s23_q;
  logic less_1585_s23_q;
  logic and_1596_s23_q;
  logic equal_1736_s23_q;
  logic [12:0] sum_1737_s23_q;
  logic [12:0] select_1763_s23_q;
  logic [12:0] select_1774_s23_q;
  logic equal_1786_s23_q;
  logic less_1787_s23_q;
  logic and_1797_s23_q;
  logic and_1807_s23_q;
  logic equal_1830_s23_q;
  logic and_1974_s23_q;
  logic and_1993_s23_q;
  logic not_1997_s23_q;
  logic not_2012_s23_q;
  logic [9:0] select_2023_s23_q;
  logic [9:0] select_2026_s23_q;
  logic less_2028_s23_q;
  logic equal_2082_s23_q;
  logic and_2109_s23_q;
  logic and_2111_s23_q;
  logic [7:0] residual_s23_q;
  logic less_2155_s23_q;
  logic less_2169_s23_q;
  logic equal_2213_s23_q;
  logic or_2354_s23_q;
  logic equal_2357_s23_q;
  logic select_2363_s23_q;
  logic equal_2374_s23_q;
  logic equal_2377_s23_q;
  logic equal_2379_s23_q;
  logic equal_2380_s23_q;
  logic equal_2593_s23_q;
  logic [9:0] select_2602_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_s22_q;
      census_changes_values_1_left_s23_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s23_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s23_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s23_q <= sharpness_sums_contrast_1_q;
      x_s23_q <= x_s22_q;
      ends_cell_s23_q <= ends_cell_s22_q;
      lower_half_s23_q <= lower_half_s22_q;
      counts_supervised_s23_q <= counts_supervised_s22_q;
      counts_textured_s23_q <= counts_textured_s22_q;
      counts_explained_s23_q <= counts_explained_s22_q;
      registration_of_right_s23_q <= registration_of_right_s22_q;
      product_s23_q <= product_s22_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_s22_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_s22_q;
      done_s23_q <= done_q;
      column_s23_q <= column_s22_q;
      and_368_s23_q <= and_368_s22_q;
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
      and_458_s23_q <= whole_22 & and_433_s22_q;
      and_459_s23_q <= and_459_s22_q;
      sum_479_s23_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1335_s23_q <= equal_1335_s22_q;
      not_1336_s23_q <= not_1336_s22_q;
      equal_1380_s23_q <= equal_1380_s22_q;
      all_s23_q <= all_s22_q;
      sum_1386_s23_q <= sum_1386_s22_q;
      equal_1388_s23_q <= equal_1388_s22_q;
      equal_1390_s23_q <= equal_1390_s22_q;
      equal_1392_s23_q <= equal_1392_s22_q;
      equal_1394_s23_q <= equal_1394_s22_q;
      equal_1396_s23_q <= equal_1396_s22_q;
      equal_1398_s23_q <= equal_1398_s22_q;
      equal_1400_s23_q <= equal_1400_s22_q;
      less_1408_s23_q <= less_1408_s22_q;
      or_1412_s23_q <= or_1412_s22_q;
      registration_sums_rdata_s23_q <= registration_sums_rdata_q;
      equal_1432_s23_q <= equal_1432_s22_q;
      and_1442_s23_q <= and_1442_s22_q;
      not_1454_s23_q <= not_1454_s22_q;
      index_s23_q <= index[2:0];
      sum_1508_s23_q <= sum_1508;
      and_1515_s23_q <= began_q & (seen_x_q == 4'h0);
      less_1516_s23_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s23_q <= index_2[2:0];
      sum_1521_s23_q <= sum_1521;
      equal_1535_s23_q <= equal_1535_s22_q;
      not_1555_s23_q <= ~((good_q & select_1552) == 48'h0);
      not_1571_s23_q <= not_1571_s22_q;
      less_1585_s23_q <= less_1585_s22_q;
      and_1596_s23_q <= and_1596_s22_q;
      equal_1736_s23_q <= equal_1736_s22_q;
      sum_1737_s23_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1729};
      select_1763_s23_q <= and_1761_s22_q ? detail_3[14:2] : 13'h0;
      select_1774_s23_q <= and_1772_s22_q ? detail_4[14:2] : 13'h0;
      equal_1786_s23_q <= equal_1786_s22_q;
      less_1787_s23_q <= less_1787_s22_q;
      and_1797_s23_q <= and_1797;
      and_1807_s23_q <= and_1807;
      equal_1830_s23_q <= equal_1830_s22_q;
      and_1974_s23_q <= and_1974_s22_q;
      and_1993_s23_q <= and_1993_s22_q;
      not_1997_s23_q <= not_1997_s22_q;
      not_2012_s23_q <= not_2012_s22_q;
      select_2023_s23_q <= select_2023_s22_q;
      select_2026_s23_q <= select_2026_s22_q;
      less_2028_s23_q <= {sum_2027, select_2026_s22_q[1:0]} < {3'h0, select_2023_s22_q};
      equal_2082_s23_q <= equal_2082_s22_q;
      and_2109_s23_q <= and_2109_s22_q;
      and_2111_s23_q <= and_2111_s22_q;
      residual_s23_q <= residual_s22_q[7:0];
      less_2155_s23_q <= $signed(difference_2154) < $signed({7'h0, cfg_moved_limit_i});
      less_2169_s23_q <= less_2169;
      equal_2213_s23_q <= equal_2213_s22_q;
      or_2354_s23_q <= or_2354_s22_q;
      equal_2357_s23_q <= equal_2357_s22_q;
      select_2363_s23_q <= select_2363_s22_q;
      equal_2374_s23_q <= equal_2374;
      equal_2377_s23_q <= equal_2377_s22_q;
      equal_2379_s23_q <= equal_2379_s22_q;
      equal_2380_s23_q <= equal_2380_s22_q;
      equal_2593_s23_q <= equal_2593_s22_q;
      select_2602_s23_q <= select_2602_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:201
  logic [13:0] sum_480;
  assign sum_480 = {2'h0, census_changes_values_1_left_s23_q} + {1'b0, sum_479_s23_q};
  logic [13:0] sum_481;
  assign sum_481 = {2'h0, census_changes_values_2_left_q} + sum_480;
  // hls/stages/agreement.hpp:764
  logic and_1556;
  assign and_1556 = good_known_q & not_1555_s23_q;
  // hls/stages/agreement.hpp:833
  logic is_seen;
  assign is_seen = equal_1535_s23_q ? and_1556 : not_1571_s23_q;
  // hls/stages/agreement.hpp:365
  logic [11:0] select_1733;
  assign select_1733 = and_368_s23_q ? census_changes_values_1_left_s23_q : census_changes_values_2_left_q;
  logic [11:0] select_1734;
  assign select_1734 = and_368_s23_q ? census_changes_values_1_right_s23_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [13:0] sum_1738;
  assign sum_1738 = {2'h0, census_changes_values_1_right_s23_q} + {1'b0, sum_1737_s23_q};
  logic [13:0] sum_1739;
  assign sum_1739 = {2'h0, census_changes_values_2_right_q} + sum_1738;
  // hls/stages/census.hpp:277
  logic [23:0] select_1765;
  assign select_1765 = equal_1736_s23_q ? {11'h0, select_1763_s23_q} : (sharpness_sums_detail_0_q + {11'h0, select_1763_s23_q});
  logic [23:0] select_1776;
  assign select_1776 = equal_1736_s23_q ? {11'h0, select_1774_s23_q} : (sharpness_sums_detail_1_q + {11'h0, select_1774_s23_q});
  // hls/stages/census.hpp:296
  logic [17:0] select_1799;
  assign select_1799 = (less_1787_s23_q & and_1797_s23_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_1809;
  assign select_1809 = (less_1787_s23_q & and_1807_s23_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:154
  logic [1:0] select_1818;
  assign select_1818 = equal_1786_s23_q ? {sharpness_comparing_contrast_0_q[0], and_1807_s23_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_1820;
  assign select_1820 = equal_1786_s23_q ? {sharpness_comparing_contrast_1_q[0], and_1797_s23_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:305
  logic xor_1843;
  assign xor_1843 = sharpness_comparing_contrast_0_q[1] ^ and_1797_s23_q;
  logic select_1846;
  assign select_1846 = (equal_1830_s23_q | xor_1843) ? (and_1797_s23_q & xor_1843) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:154
  logic select_1847;
  assign select_1847 = equal_1786_s23_q ? select_1846 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:305
  logic xor_1849;
  assign xor_1849 = sharpness_comparing_contrast_1_q[1] ^ and_1807_s23_q;
  logic select_1852;
  assign select_1852 = (equal_1830_s23_q | xor_1849) ? (and_1807_s23_q & xor_1849) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:154
  logic select_1853;
  assign select_1853 = equal_1786_s23_q ? select_1852 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:681
  logic [13:0] select_1995;
  assign select_1995 = and_1974_s23_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1993_s23_q});
  // hls/stages/agreement.hpp:836
  logic not_2014;
  assign not_2014 = ~(equal_1535_s23_q ? and_1556 : not_2012_s23_q);
  // hls/stages/agreement.hpp:211
  logic and_2017;
  assign and_2017 = ends_cell_s23_q & (not_1997_s23_q & (centres_values_1_textured_s23_q & not_2014));
  // hls/stages/agreement.hpp:867
  logic [9:0] select_2030;
  assign select_2030 = ((~(select_2023_s23_q[9:4] == 6'h0)) & less_2028_s23_q) ? select_2023_s23_q : 10'h0;
  // hls/stages/agreement.hpp:211
  logic [9:0] select_2033;
  assign select_2033 = equal_1335_s23_q ? (x_s23_q[6] ? (equal_1380_s23_q ? 10'h0 : select_2030) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:840
  logic and_2051;
  assign and_2051 = centres_values_1_textured_s23_q & (centres_values_1_of_skin_s23_q & not_2014);
  // hls/stages/registration.hpp:106
  logic [7:0] select_2137;
  assign select_2137 = equal_2082_s23_q ? (and_2111_s23_q ? residual_s23_q : 8'h0) : 8'h0;
  logic and_2148;
  assign and_2148 = and_2111_s23_q & ($signed(residual_s23_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:193
  logic less_2162;
  assign less_2162 = $signed(residual_s23_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:861
  logic [11:0] select_2215;
  assign select_2215 = or_1412_s23_q ? 12'h0 : (equal_2213_s23_q ? registration_sums_rdata_s23_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:871
  logic [11:0] select_2217;
  assign select_2217 = equal_1380_s23_q ? 12'h0 : (less_1408_s23_q ? select_2215 : 12'h0);
  // hls/stages/registration.hpp:145
  logic and_2220;
  assign and_2220 = x_s23_q[1] & all_s23_q;
  // hls/stages/agreement.hpp:871
  logic and_2223;
  assign and_2223 = not_1454_s23_q & (less_1408_s23_q & ({and_2220, x_s23_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:861
  logic [11:0] select_2230;
  assign select_2230 = or_1412_s23_q ? 12'h0 : (equal_2213_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:871
  logic [11:0] select_2232;
  assign select_2232 = equal_1380_s23_q ? 12'h0 : (less_1408_s23_q ? select_2230 : 12'h0);
  // hls/stages/registration.hpp:142
  logic not_2238;
  assign not_2238 = ~all_s23_q;
  // hls/stages/agreement.hpp:871
  logic and_2241;
  assign and_2241 = not_1454_s23_q & (less_1408_s23_q & (x_s23_q[2:0] == {all_s23_q, not_2238, 1'b0}));
  // hls/stages/agreement.hpp:211
  logic and_2247;
  assign and_2247 = equal_1335_s23_q & (x_s23_q[6] & (not_1454_s23_q & (less_1408_s23_q & all_s23_q)));
  // hls/stages/registration.hpp:149
  logic equal_2274;
  assign equal_2274 = x_s23_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:871
  logic and_2277;
  assign and_2277 = not_1454_s23_q & (less_1408_s23_q & (x_s23_q[5] ? x_s23_q[3] : equal_2274));
  logic and_2286;
  assign and_2286 = not_1454_s23_q & (less_1408_s23_q & ((~x_s23_q[5]) & (x_s23_q[3] & equal_2274)));
  // hls/stages/agreement.hpp:211
  logic select_2376;
  assign select_2376 = equal_1335_s23_q ? ((x_s23_q[6] & good_known_q) | equal_2374_s23_q) : good_known_q;
  // hls/stages/agreement.hpp:1012
  logic and_2538;
  assign and_2538 = and_1596_s23_q & ({sum_1521_s23_q, index_2_s23_q} == {sum_1508_s23_q, index_s23_q});
  // hls/stages/agreement.hpp:869
  logic [31:0] select_2595;
  assign select_2595 = equal_1400_s23_q ? {2'h0, counts_explained_s23_q, 2'h0, counts_textured_s23_q} : (equal_2593_s23_q ? registration_sums_rdata_s23_q : 32'h0);
  logic [31:0] select_2596;
  assign select_2596 = equal_1398_s23_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s23_q} : select_2595;

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1103; read in stage 23, written in stage 24: 23 < 24 < 23 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1508_s23_q, index_s23_q};
  logic map_re;
  assign map_re = s23_en & (and_1515_s23_q & less_1516_s23_q);
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
    end else if (s23_en) begin
      sharpness_sums_detail_0_q <= and_368_s23_q ? select_1765 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_368_s23_q ? select_1776 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_1818 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_1820 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_1847 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_1853 : sharpness_comparing_less_contrast_1_q;
      counts_nearer_q <= select_1995;
      good_known_q <= select_2376;
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
    if (s23_en) begin
      census_changes_values_2_left_q <= select_1733;
      census_changes_values_2_right_q <= select_1734;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic [23:0] sharpness_sums_detail_0_s24_q;
  logic [23:0] sharpness_sums_detail_1_s24_q;
  logic [23:0] sharpness_sums_contrast_0_s24_q;
  logic [23:0] sharpness_sums_contrast_1_s24_q;
  logic [6:0] x_s24_q;
  logic lower_half_s24_q;
  logic [13:0] counts_nearer_s24_q;
  logic registration_of_right_s24_q;
  logic [13:0] product_s24_q;
  logic done_s24_q;
  logic [6:0] column_s24_q;
  logic and_368_s24_q;
  logic so_s24_q;
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
  logic [8:0] sum_481_s24_q;
  logic equal_1335_s24_q;
  logic not_1336_s24_q;
  logic equal_1380_s24_q;
  logic [1:0] sum_1386_s24_q;
  logic equal_1388_s24_q;
  logic equal_1390_s24_q;
  logic equal_1392_s24_q;
  logic equal_1394_s24_q;
  logic equal_1396_s24_q;
  logic less_1408_s24_q;
  logic [19:0] select_1433_s24_q;
  logic [11:0] select_1438_s24_q;
  logic and_1442_s24_q;
  logic not_1454_s24_q;
  logic and_1515_s24_q;
  logic less_1516_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1521_s24_q;
  logic is_seen_s24_q;
  logic and_1586_s24_q;
  logic and_1596_s24_q;
  logic equal_1736_s24_q;
  logic [8:0] sum_1739_s24_q;
  logic equal_1786_s24_q;
  logic less_1787_s24_q;
  logic [17:0] select_1799_s24_q;
  logic [17:0] select_1809_s24_q;
  logic equal_1830_s24_q;
  logic and_1974_s24_q;
  logic and_2019_s24_q;
  logic [9:0] select_2023_s24_q;
  logic [9:0] select_2026_s24_q;
  logic [9:0] select_2033_s24_q;
  logic and_2054_s24_q;
  logic equal_2082_s24_q;
  logic and_2109_s24_q;
  logic and_2111_s24_q;
  logic [7:0] select_2139_s24_q;
  logic and_2148_s24_q;
  logic and_2156_s24_q;
  logic and_2163_s24_q;
  logic and_2170_s24_q;
  logic [11:0] select_2217_s24_q;
  logic and_2225_s24_q;
  logic [11:0] select_2232_s24_q;
  logic and_2243_s24_q;
  logic and_2247_s24_q;
  logic and_2279_s24_q;
  logic and_2287_s24_q;
  logic or_2354_s24_q;
  logic equal_2357_s24_q;
  logic select_2363_s24_q;
  logic equal_2374_s24_q;
  logic equal_2377_s24_q;
  logic equal_2379_s24_q;
  logic equal_2380_s24_q;
  logic and_2523_s24_q;
  logic and_2538_s24_q;
  logic [31:0] select_2596_s24_q;
  logic [9:0] select_2602_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      sharpness_sums_detail_0_s24_q <= sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_s24_q <= sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_s24_q <= sharpness_sums_contrast_0_s23_q;
      sharpness_sums_contrast_1_s24_q <= sharpness_sums_contrast_1_s23_q;
      x_s24_q <= x_s23_q;
      lower_half_s24_q <= lower_half_s23_q;
      counts_nearer_s24_q <= counts_nearer_q;
      registration_of_right_s24_q <= registration_of_right_s23_q;
      product_s24_q <= product_s23_q;
      done_s24_q <= done_s23_q;
      column_s24_q <= column_s23_q;
      and_368_s24_q <= and_368_s23_q;
      so_s24_q <= drew_q;
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
      and_458_s24_q <= and_458_s23_q;
      and_459_s24_q <= and_459_s23_q;
      sum_481_s24_q <= sum_481[13:5];
      equal_1335_s24_q <= equal_1335_s23_q;
      not_1336_s24_q <= not_1336_s23_q;
      equal_1380_s24_q <= equal_1380_s23_q;
      sum_1386_s24_q <= sum_1386_s23_q;
      equal_1388_s24_q <= equal_1388_s23_q;
      equal_1390_s24_q <= equal_1390_s23_q;
      equal_1392_s24_q <= equal_1392_s23_q;
      equal_1394_s24_q <= equal_1394_s23_q;
      equal_1396_s24_q <= equal_1396_s23_q;
      less_1408_s24_q <= less_1408_s23_q;
      select_1433_s24_q <= equal_1432_s23_q ? registration_sums_rdata_s23_q[19:0] : 20'h0;
      select_1438_s24_q <= equal_1432_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0;
      and_1442_s24_q <= and_1442_s23_q;
      not_1454_s24_q <= not_1454_s23_q;
      and_1515_s24_q <= and_1515_s23_q;
      less_1516_s24_q <= less_1516_s23_q;
      index_2_s24_q <= index_2_s23_q;
      sum_1521_s24_q <= sum_1521_s23_q;
      is_seen_s24_q <= is_seen;
      and_1586_s24_q <= is_seen & less_1585_s23_q;
      and_1596_s24_q <= and_1596_s23_q;
      equal_1736_s24_q <= equal_1736_s23_q;
      sum_1739_s24_q <= sum_1739[13:5];
      equal_1786_s24_q <= equal_1786_s23_q;
      less_1787_s24_q <= less_1787_s23_q;
      select_1799_s24_q <= select_1799;
      select_1809_s24_q <= select_1809;
      equal_1830_s24_q <= equal_1830_s23_q;
      and_1974_s24_q <= and_1974_s23_q;
      and_2019_s24_q <= not_1336_s23_q & (drew_q & and_2017);
      select_2023_s24_q <= select_2023_s23_q;
      select_2026_s24_q <= select_2026_s23_q;
      select_2033_s24_q <= select_2033;
      and_2054_s24_q <= drew_q & (ends_cell_s23_q & (not_1997_s23_q & and_2051));
      equal_2082_s24_q <= equal_2082_s23_q;
      and_2109_s24_q <= and_2109_s23_q;
      and_2111_s24_q <= and_2111_s23_q;
      select_2139_s24_q <= equal_1335_s23_q ? 8'h0 : (drew_q ? select_2137 : 8'h0);
      and_2148_s24_q <= and_2148;
      and_2156_s24_q <= and_2111_s23_q & less_2155_s23_q;
      and_2163_s24_q <= and_2111_s23_q & less_2162;
      and_2170_s24_q <= and_2111_s23_q & less_2169_s23_q;
      select_2217_s24_q <= select_2217;
      and_2225_s24_q <= equal_1335_s23_q & (x_s23_q[6] & and_2223);
      select_2232_s24_q <= select_2232;
      and_2243_s24_q <= equal_1335_s23_q & (x_s23_q[6] & and_2241);
      and_2247_s24_q <= and_2247;
      and_2279_s24_q <= equal_1335_s23_q & (x_s23_q[6] & and_2277);
      and_2287_s24_q <= x_s23_q[6] & and_2286;
      or_2354_s24_q <= or_2354_s23_q;
      equal_2357_s24_q <= equal_2357_s23_q;
      select_2363_s24_q <= select_2363_s23_q;
      equal_2374_s24_q <= equal_2374_s23_q;
      equal_2377_s24_q <= equal_2377_s23_q;
      equal_2379_s24_q <= equal_2379_s23_q;
      equal_2380_s24_q <= equal_2380_s23_q;
      and_2523_s24_q <= said_q;
      and_2538_s24_q <= and_2538;
      select_2596_s24_q <= select_2596;
      select_2602_s24_q <= select_2602_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/registration.hpp:250
  logic equal_1434;
  assign equal_1434 = sum_1386_s24_q == 2'h0;
  // hls/stages/registration.hpp:248
  logic [6:0] down;
  assign down = sum_1386_s24_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:250
  logic [13:0] select_1436;
  assign select_1436 = equal_1434 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:249
  logic [6:0] up;
  assign up = sum_1386_s24_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:251
  logic [6:0] select_1440;
  assign select_1440 = equal_1434 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/census.hpp:296
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1799_s24_q};
  // hls/stages/agreement.hpp:154
  logic [17:0] select_1802;
  assign select_1802 = equal_1786_s24_q ? (less_1787_s24_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:296
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1809_s24_q};
  // hls/stages/agreement.hpp:154
  logic [17:0] select_1812;
  assign select_1812 = equal_1786_s24_q ? (less_1787_s24_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2021;
  assign select_2021 = and_1974_s24_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2019_s24_q});
  logic [13:0] select_2035;
  assign select_2035 = and_1974_s24_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2033_s24_q});
  // hls/stages/agreement.hpp:211
  logic and_2055;
  assign and_2055 = not_1336_s24_q & and_2054_s24_q;
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2057;
  assign select_2057 = and_1974_s24_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2055});
  // hls/stages/registration.hpp:125
  logic [13:0] sum_2140;
  assign sum_2140 = registration_half_across_q + {{6{select_2139_s24_q[7]}}, select_2139_s24_q};
  // hls/stages/agreement.hpp:211
  logic and_2144;
  assign and_2144 = not_1336_s24_q & (so_s24_q & (and_2111_s24_q & equal_2082_s24_q));
  // hls/stages/registration.hpp:126
  logic [5:0] select_2146;
  assign select_2146 = and_2109_s24_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2144});
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2150;
  assign select_2150 = so_s24_q ? (equal_2082_s24_q ? {and_2148_s24_q, and_2111_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2151;
  assign select_2151 = equal_1335_s24_q ? 2'h0 : select_2150;
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2152;
  assign sum_2152 = registration_half_votes_down_q + {{5{select_2151[1]}}, select_2151};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2158;
  assign select_2158 = so_s24_q ? (equal_2082_s24_q ? {and_2156_s24_q, and_2111_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2159;
  assign select_2159 = equal_1335_s24_q ? 2'h0 : select_2158;
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2160;
  assign sum_2160 = registration_half_votes_up_q + {{5{select_2159[1]}}, select_2159};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2165;
  assign select_2165 = so_s24_q ? (equal_2082_s24_q ? {and_2163_s24_q, and_2111_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2166;
  assign select_2166 = equal_1335_s24_q ? 2'h0 : select_2165;
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2167;
  assign sum_2167 = registration_half_half_votes_down_q + {{5{select_2166[1]}}, select_2166};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2172;
  assign select_2172 = so_s24_q ? (equal_2082_s24_q ? {and_2170_s24_q, and_2111_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2173;
  assign select_2173 = equal_1335_s24_q ? 2'h0 : select_2172;
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2174;
  assign sum_2174 = registration_half_half_votes_up_q + {{5{select_2173[1]}}, select_2173};
  // hls/stages/agreement.hpp:211
  logic and_2208;
  assign and_2208 = equal_1335_s24_q & (x_s24_q[6] & (not_1454_s24_q & less_1408_s24_q));
  logic [11:0] select_2219;
  assign select_2219 = equal_1335_s24_q ? (x_s24_q[6] ? select_2217_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:237
  logic [13:0] sum_2227;
  assign sum_2227 = {{2{select_2219[11]}}, select_2219} + (and_2225_s24_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:211
  logic [11:0] select_2234;
  assign select_2234 = equal_1335_s24_q ? (x_s24_q[6] ? select_2232_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:238
  logic [13:0] sum_2236;
  assign sum_2236 = {{2{select_2234[11]}}, select_2234} + (and_2225_s24_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:231
  logic not_2248;
  assign not_2248 = ~and_2247_s24_q;
  logic less_2249;
  assign less_2249 = $signed({9'h1, {2{not_2248}}, and_2247_s24_q}) < $signed(registration_up_q[13:2]);
  logic select_2250;
  assign select_2250 = and_2243_s24_q ? less_2249 : registration_enough_q;
  // hls/stages/agreement.hpp:871
  logic and_2254;
  assign and_2254 = x_s24_q[6] & (not_1454_s24_q & (less_1408_s24_q & (x_s24_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:211
  logic and_2255;
  assign and_2255 = equal_1335_s24_q & and_2254;
  // hls/stages/registration.hpp:227
  logic less_2256;
  assign less_2256 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2258;
  assign less_2258 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:871
  logic and_2263;
  assign and_2263 = x_s24_q[6] & (not_1454_s24_q & (less_1408_s24_q & (x_s24_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:211
  logic and_2264;
  assign and_2264 = equal_1335_s24_q & and_2263;
  // hls/stages/agreement.hpp:871
  logic and_2271;
  assign and_2271 = x_s24_q[6] & (not_1454_s24_q & (less_1408_s24_q & (x_s24_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:229
  logic and_2289;
  assign and_2289 = registration_votes_up_q & registration_other_down_q;
  logic select_2291;
  assign select_2291 = registration_votes_down_q ? (registration_other_up_q | and_2289) : and_2289;
  // hls/stages/registration.hpp:130
  logic and_2293;
  assign and_2293 = (equal_1335_s24_q & and_2287_s24_q) & (registration_other_enough_q & select_2291);
  logic and_2295;
  assign and_2295 = registration_enough_q & ((and_2279_s24_q & (less_2258 | less_2256)) | and_2293);
  // hls/stages/agreement.hpp:855
  logic [13:0] select_2382;
  assign select_2382 = equal_2379_s24_q ? counts_skin_unproven_q : (equal_2380_s24_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2377_s24_q ? counts_nearer_s24_q : select_2382;
  // hls/stages/agreement.hpp:211
  logic and_2553;
  assign and_2553 = equal_1335_s24_q & (equal_2374_s24_q & (cfg_prove_i & (~proven_q)));
  logic and_2587;
  assign and_2587 = equal_1335_s24_q & (x_s24_q[6] & (not_1454_s24_q | (4'hc < x_s24_q[5:2])));
  // hls/stages/agreement.hpp:869
  logic [31:0] select_2597;
  assign select_2597 = equal_1396_s24_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_2596_s24_q;
  logic [31:0] select_2598;
  assign select_2598 = equal_1394_s24_q ? {8'h0, sharpness_sums_detail_0_s24_q} : select_2597;
  logic [31:0] select_2599;
  assign select_2599 = equal_1392_s24_q ? {8'h0, sharpness_sums_detail_1_s24_q} : select_2598;
  logic [31:0] select_2600;
  assign select_2600 = equal_1390_s24_q ? {8'h0, sharpness_sums_contrast_0_s24_q} : select_2599;
  logic [31:0] select_2601;
  assign select_2601 = equal_1388_s24_q ? {8'h0, sharpness_sums_contrast_1_s24_q} : select_2600;

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1521_s24_q, index_2_s24_q};
  logic map_we;
  assign map_we = s24_en & and_1596_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1586_s24_q, is_seen_s24_q};
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
    end else if (s24_en) begin
      sharpness_comparing_rest_0_q <= so_s24_q ? select_1802 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s24_q ? select_1812 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2021;
      counts_regions_bad_q <= select_2035;
      counts_skin_unproven_q <= select_2057;
      registration_half_across_q <= and_2109_s24_q ? 14'h0 : sum_2140;
      registration_half_measured_q <= select_2146;
      registration_half_votes_down_q <= and_2109_s24_q ? 7'h0 : sum_2152;
      registration_half_votes_up_q <= and_2109_s24_q ? 7'h0 : sum_2160;
      registration_half_half_votes_down_q <= and_2109_s24_q ? 7'h0 : sum_2167;
      registration_half_half_votes_up_q <= and_2109_s24_q ? 7'h0 : sum_2174;
      registration_down_q <= and_2208 ? sum_2227 : registration_down_q;
      registration_up_q <= and_2208 ? sum_2236 : registration_up_q;
      registration_enough_q <= select_2250;
      registration_votes_down_q <= and_2255 ? less_2256 : registration_votes_down_q;
      registration_votes_up_q <= and_2255 ? less_2258 : registration_votes_up_q;
      registration_other_enough_q <= and_2264 ? select_2250 : registration_other_enough_q;
      registration_other_down_q <= and_2264 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2264 ? registration_votes_up_q : registration_other_up_q;
      proven_q <= marks_first_s24_q ? done_s24_q : proven_q;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic census_columns_values_1_cell_2_of_skin_s25_q;
  logic x_s25_q;
  logic lower_half_s25_q;
  logic registration_of_right_s25_q;
  logic [13:0] product_s25_q;
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
  logic less_482_s25_q;
  logic equal_1335_s25_q;
  logic equal_1380_s25_q;
  logic [1:0] sum_1386_s25_q;
  logic [19:0] sum_1437_s25_q;
  logic [11:0] sum_1441_s25_q;
  logic and_1442_s25_q;
  logic and_1515_s25_q;
  logic less_1516_s25_q;
  logic [1:0] map_rdata_s25_q;
  logic is_seen_s25_q;
  logic and_1586_s25_q;
  logic equal_1736_s25_q;
  logic and_1741_s25_q;
  logic equal_1786_s25_q;
  logic sum_s25_q;
  logic sum_2_s25_q;
  logic equal_1830_s25_q;
  logic select_1848_s25_q;
  logic select_1854_s25_q;
  logic [9:0] select_2023_s25_q;
  logic [9:0] select_2026_s25_q;
  logic not_2273_s25_q;
  logic and_2295_s25_q;
  logic or_2354_s25_q;
  logic equal_2357_s25_q;
  logic select_2363_s25_q;
  logic equal_2374_s25_q;
  logic and_2378_s25_q;
  logic [13:0] before_v_4_s25_q;
  logic not_2415_s25_q;
  logic or_2419_s25_q;
  logic and_2523_s25_q;
  logic and_2538_s25_q;
  logic and_2553_s25_q;
  logic and_2587_s25_q;
  logic [5:0] select_2589_s25_q;
  logic [31:0] select_2601_s25_q;
  logic [9:0] select_2602_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      census_columns_values_1_cell_2_of_skin_s25_q <= census_columns_values_1_cell_2_of_skin_s24_q;
      x_s25_q <= x_s24_q[6];
      lower_half_s25_q <= lower_half_s24_q;
      registration_of_right_s25_q <= registration_of_right_s24_q;
      product_s25_q <= product_s24_q;
      column_s25_q <= column_s24_q;
      and_368_s25_q <= and_368_s24_q;
      so_s25_q <= so_s24_q;
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
      less_482_s25_q <= 9'h4 < sum_481_s24_q;
      equal_1335_s25_q <= equal_1335_s24_q;
      equal_1380_s25_q <= equal_1380_s24_q;
      sum_1386_s25_q <= sum_1386_s24_q;
      sum_1437_s25_q <= select_1433_s24_q + {{6{select_1436[13]}}, select_1436};
      sum_1441_s25_q <= select_1438_s24_q + {{5{select_1440[6]}}, select_1440};
      and_1442_s25_q <= and_1442_s24_q;
      and_1515_s25_q <= and_1515_s24_q;
      less_1516_s25_q <= less_1516_s24_q;
      map_rdata_s25_q <= map_rdata_q;
      is_seen_s25_q <= is_seen_s24_q;
      and_1586_s25_q <= and_1586_s24_q;
      equal_1736_s25_q <= equal_1736_s24_q;
      and_1741_s25_q <= and_458_s24_q & (9'h4 < sum_1739_s24_q);
      equal_1786_s25_q <= equal_1786_s24_q;
      sum_s25_q <= sum[0];
      sum_2_s25_q <= sum_2[0];
      equal_1830_s25_q <= equal_1830_s24_q;
      select_1848_s25_q <= sharpness_comparing_less_contrast_0_q;
      select_1854_s25_q <= sharpness_comparing_less_contrast_1_q;
      select_2023_s25_q <= select_2023_s24_q;
      select_2026_s25_q <= select_2026_s24_q;
      not_2273_s25_q <= ~(equal_1335_s24_q & and_2271);
      and_2295_s25_q <= and_2295;
      or_2354_s25_q <= or_2354_s24_q;
      equal_2357_s25_q <= equal_2357_s24_q;
      select_2363_s25_q <= select_2363_s24_q;
      equal_2374_s25_q <= equal_2374_s24_q;
      and_2378_s25_q <= equal_2377_s24_q & equal_2357_s24_q;
      before_v_4_s25_q <= before_v_4;
      not_2415_s25_q <= ~(equal_2380_s24_q & equal_2357_s24_q);
      or_2419_s25_q <= (equal_2380_s24_q | equal_2379_s24_q) | (x_s24_q[6:3] == 4'hf);
      and_2523_s25_q <= and_2523_s24_q;
      and_2538_s25_q <= and_2538_s24_q;
      and_2553_s25_q <= and_2553;
      and_2587_s25_q <= and_2587;
      select_2589_s25_q <= equal_1335_s24_q ? (x_s24_q[6] ? x_s24_q[5:0] : 6'h0) : 6'h0;
      select_2601_s25_q <= select_2601;
      select_2602_s25_q <= select_2602_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
  logic registration_moved_q;
  logic hides_q;
  // hls/stages/census.hpp:223
  logic and_483;
  assign and_483 = and_433_s25_q & less_482_s25_q;
  // hls/stages/census.hpp:226
  logic and_1742;
  assign and_1742 = and_458_s25_q & less_482_s25_q;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1743;
  assign sum_1743 = census_left_misses_q + {{17{and_1742}}, and_1741_s25_q, 1'b0, and_1741_s25_q};
  // hls/stages/agreement.hpp:365
  logic [19:0] select_1745;
  assign select_1745 = and_368_s25_q ? (equal_1736_s25_q ? 20'h0 : sum_1743) : census_left_misses_q;
  // hls/stages/agreement.hpp:154
  logic [2:0] select_1814;
  assign select_1814 = equal_1786_s25_q ? {sharpness_comparing_product_0_q[1:0], sum_s25_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_1816;
  assign select_1816 = equal_1786_s25_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s25_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:302
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s25_q});
  // hls/stages/agreement.hpp:154
  logic select_1825;
  assign select_1825 = so_s25_q ? (equal_1786_s25_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:302
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s25_q});
  // hls/stages/agreement.hpp:154
  logic select_1828;
  assign select_1828 = equal_1786_s25_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:304
  logic xor_1831;
  assign xor_1831 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_1837;
  assign xor_1837 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/agreement.hpp:935
  logic [14:0] over;
  assign over = {1'b0, product_s25_q} - {1'b0, before_v_4_s25_q};
  // hls/stages/agreement.hpp:943
  logic select_2385;
  assign select_2385 = and_2378_s25_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1012
  logic [1:0] select_2539;
  assign select_2539 = and_2538_s25_q ? {and_1586_s25_q, is_seen_s25_q} : map_rdata_s25_q;
  // hls/stages/agreement.hpp:1013
  logic and_2540;
  assign and_2540 = proven_q & less_2528;
  // hls/stages/agreement.hpp:211
  logic and_2565;
  assign and_2565 = equal_1335_s25_q & (equal_2374_s25_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:874
  logic or_2567;
  assign or_2567 = select_1848_s25_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:871
  logic [31:0] select_2603;
  assign select_2603 = equal_1380_s25_q ? select_2601_s25_q : {2'h0, select_2602_s25_q, select_2026_s25_q, select_2023_s25_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s25_q;
  logic fresh_we;
  assign fresh_we = s25_en & and_368_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s25_q, and_483, and_459_s25_q, and_458_s25_q, and_433_s25_q, less_425_s25_q, less_424_s25_q, less_423_s25_q, less_422_s25_q, less_421_s25_q, less_420_s25_q, less_419_s25_q, less_418_s25_q, less_417_s25_q, less_416_s25_q, less_415_s25_q, less_414_s25_q, less_413_s25_q, less_412_s25_q, less_411_s25_q, less_410_s25_q, less_409_s25_q, less_408_s25_q, less_407_s25_q, less_406_s25_q, less_405_s25_q, less_404_s25_q, less_403_s25_q, less_402_s25_q};
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
      if (fresh_waddr >= 7'd120) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd120) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1386_s25_q, lower_half_s25_q, registration_of_right_s25_q};
  logic registration_sums_we;
  assign registration_sums_we = s25_en & and_1442_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1441_s25_q, sum_1437_s25_q};
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
      census_left_misses_q <= 20'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
      registration_moved_q <= 1'b0;
      hides_q <= 1'b0;
    end else if (s25_en) begin
      census_left_misses_q <= select_1745;
      sharpness_comparing_product_0_q <= so_s25_q ? select_1814 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s25_q ? select_1816 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_1825;
      sharpness_comparing_carry_1_q <= so_s25_q ? select_1828 : sharpness_comparing_carry_1_q;
      registration_moved_q <= not_2273_s25_q & (registration_moved_q | and_2295_s25_q);
      hides_q <= equal_1335_s25_q ? select_2385 : hides_q;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic so_s26_q;
  logic equal_1335_s26_q;
  logic and_1515_s26_q;
  logic less_1516_s26_q;
  logic equal_1786_s26_q;
  logic or_1832_s26_q;
  logic and_1833_s26_q;
  logic or_1838_s26_q;
  logic and_1839_s26_q;
  logic select_1854_s26_q;
  logic or_2354_s26_q;
  logic select_2363_s26_q;
  logic equal_2374_s26_q;
  logic select_2385_s26_q;
  logic and_2413_s26_q;
  logic not_2415_s26_q;
  logic or_2419_s26_q;
  logic and_2523_s26_q;
  logic and_2541_s26_q;
  logic and_2544_s26_q;
  logic and_2553_s26_q;
  logic and_2565_s26_q;
  logic or_2567_s26_q;
  logic and_2587_s26_q;
  logic [5:0] select_2589_s26_q;
  logic [31:0] select_2605_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      so_s26_q <= so_s25_q;
      equal_1335_s26_q <= equal_1335_s25_q;
      and_1515_s26_q <= and_1515_s25_q;
      less_1516_s26_q <= less_1516_s25_q;
      equal_1786_s26_q <= equal_1786_s25_q;
      or_1832_s26_q <= equal_1830_s25_q | xor_1831;
      and_1833_s26_q <= five_times[0] & xor_1831;
      or_1838_s26_q <= equal_1830_s25_q | xor_1837;
      and_1839_s26_q <= five_times_2[0] & xor_1837;
      select_1854_s26_q <= select_1854_s25_q;
      or_2354_s26_q <= or_2354_s25_q;
      select_2363_s26_q <= select_2363_s25_q;
      equal_2374_s26_q <= equal_2374_s25_q;
      select_2385_s26_q <= select_2385;
      and_2413_s26_q <= over[14] & equal_2357_s25_q;
      not_2415_s26_q <= not_2415_s25_q;
      or_2419_s26_q <= or_2419_s25_q;
      and_2523_s26_q <= and_2523_s25_q;
      and_2541_s26_q <= select_2539[0] & and_2540;
      and_2544_s26_q <= select_2539[1] & and_2540;
      and_2553_s26_q <= and_2553_s25_q;
      and_2565_s26_q <= and_2565;
      or_2567_s26_q <= or_2567;
      and_2587_s26_q <= and_2587_s25_q;
      select_2589_s26_q <= select_2589_s25_q;
      select_2605_s26_q <= equal_1335_s25_q ? (x_s25_q ? select_2603 : 32'h0) : 32'h0;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:304
  logic select_1834;
  assign select_1834 = or_1832_s26_q ? and_1833_s26_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:154
  logic select_1835;
  assign select_1835 = equal_1786_s26_q ? select_1834 : sharpness_comparing_less_detail_0_q;
  logic select_1836;
  assign select_1836 = so_s26_q ? select_1835 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:304
  logic select_1840;
  assign select_1840 = or_1838_s26_q ? and_1839_s26_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:154
  logic select_1841;
  assign select_1841 = equal_1786_s26_q ? select_1840 : sharpness_comparing_less_detail_1_q;
  logic select_1842;
  assign select_1842 = so_s26_q ? select_1841 : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:872
  logic not_2386;
  assign not_2386 = ~hidden_for_q[7];
  logic [7:0] select_2388;
  assign select_2388 = select_2385_s26_q ? (hidden_for_q + {7'h0, not_2386}) : 8'h0;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2390;
  assign select_2390 = equal_1335_s26_q ? (equal_2374_s26_q ? select_2388 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:941
  logic and_2416;
  assign and_2416 = too_much_q & not_2415_s26_q;
  // hls/stages/agreement.hpp:942
  logic select_2421;
  assign select_2421 = and_2413_s26_q ? (and_2416 | or_2419_s26_q) : and_2416;
  // hls/stages/agreement.hpp:220
  logic select_2543;
  assign select_2543 = and_1515_s26_q ? (less_1516_s26_q ? and_2541_s26_q : seen_q) : seen_q;
  logic select_2546;
  assign select_2546 = and_1515_s26_q ? (less_1516_s26_q ? and_2544_s26_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:211
  logic and_2556;
  assign and_2556 = equal_1335_s26_q & (equal_2374_s26_q & (cfg_prove_i & or_2354_s26_q));
  // hls/stages/agreement.hpp:952
  logic not_2558;
  assign not_2558 = ~(or_2354_s26_q | not_2547);
  // hls/stages/agreement.hpp:211
  logic and_2561;
  assign and_2561 = equal_2374_s26_q & (not_2558 & (select_2363_s26_q | select_2421));
  logic and_2574;
  assign and_2574 = equal_2374_s26_q & (not_2558 & (select_1842 | select_1854_s26_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s26_en) begin
      sharpness_comparing_less_detail_0_q <= select_1836;
      sharpness_comparing_less_detail_1_q <= select_1842;
      hidden_for_q <= select_2390;
      too_much_q <= equal_1335_s26_q ? select_2421 : too_much_q;
      seen_q <= select_2543;
      nearer_q <= select_2546;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic equal_1335_s27_q;
  logic equal_2374_s27_q;
  logic and_2523_s27_q;
  logic and_2553_s27_q;
  logic and_2556_s27_q;
  logic and_2562_s27_q;
  logic and_2565_s27_q;
  logic and_2570_s27_q;
  logic and_2574_s27_q;
  logic not_2579_s27_q;
  logic and_2587_s27_q;
  logic [5:0] select_2589_s27_q;
  logic [31:0] select_2605_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      equal_1335_s27_q <= equal_1335_s26_q;
      equal_2374_s27_q <= equal_2374_s26_q;
      and_2523_s27_q <= and_2523_s26_q;
      and_2553_s27_q <= and_2553_s26_q;
      and_2556_s27_q <= and_2556;
      and_2562_s27_q <= equal_1335_s26_q & and_2561;
      and_2565_s27_q <= and_2565_s26_q;
      and_2570_s27_q <= equal_2374_s26_q & (not_2558 & (select_1836 | or_2567_s26_q));
      and_2574_s27_q <= and_2574;
      not_2579_s27_q <= ~(select_2388 < cfg_hidden_frames_i);
      and_2587_s27_q <= and_2587_s26_q;
      select_2589_s27_q <= select_2589_s26_q;
      select_2605_s27_q <= select_2605_s26_q;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:874
  logic and_2581;
  assign and_2581 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_2579_s27_q);

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic and_2523_s28_q;
  logic or_2548_s28_q;
  logic and_2549_s28_q;
  logic and_2553_s28_q;
  logic and_2556_s28_q;
  logic and_2562_s28_q;
  logic and_2565_s28_q;
  logic and_2571_s28_q;
  logic and_2575_s28_q;
  logic and_2583_s28_q;
  logic and_2587_s28_q;
  logic [5:0] select_2589_s28_q;
  logic [31:0] select_2605_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      and_2523_s28_q <= and_2523_s27_q;
      or_2548_s28_q <= not_2547 | seen_q;
      and_2549_s28_q <= cfg_prove_i & nearer_q;
      and_2553_s28_q <= and_2553_s27_q;
      and_2556_s28_q <= and_2556_s27_q;
      and_2562_s28_q <= and_2562_s27_q;
      and_2565_s28_q <= and_2565_s27_q;
      and_2571_s28_q <= equal_1335_s27_q & and_2570_s27_q;
      and_2575_s28_q <= equal_1335_s27_q & and_2574_s27_q;
      and_2583_s28_q <= equal_1335_s27_q & (equal_2374_s27_q & and_2581);
      and_2587_s28_q <= and_2587_s27_q;
      select_2589_s28_q <= select_2589_s27_q;
      select_2605_s28_q <= select_2605_s27_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s28_q;
  assign pixel_1_o = pixel_1_s28_q;
  assign saturated_o = saturated_s28_q;
  assign mask_o = mask_s28_q;
  assign marks_first_o = marks_first_s28_q;
  assign marks_last_o = marks_last_s28_q;
  assign marks_seen_o = or_2548_s28_q;
  assign marks_nearer_o = and_2549_s28_q;
  assign verdict_valid_o = and_2523_s28_q;
  assign verdict_unproven_yet_o = and_2553_s28_q;
  assign verdict_untextured_o = and_2556_s28_q;
  assign verdict_disagree_o = and_2562_s28_q;
  assign verdict_moved_o = and_2565_s28_q;
  assign verdict_unsharp_left_o = and_2571_s28_q;
  assign verdict_unsharp_right_o = and_2575_s28_q;
  assign verdict_hidden_o = and_2583_s28_q;
  assign frame_valid_o = and_2587_s28_q;
  assign frame_index_o = select_2589_s28_q;
  assign frame_word_o = select_2605_s28_q;
  assign valid_o = valid_s28_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], sum_2126[0], sum_2122[0], sum_2097[1:0], sum_2096[1:0], sum_2092[0], sum_2079[0], detail_4[1:0], detail_3[1:0], sum_1739[4:0], sum_481[4:0], cfg_width_i[3:0]};

endmodule
