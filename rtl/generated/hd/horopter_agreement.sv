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
  logic [6:0] sum_1961;
  assign sum_1961 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_2333;
  assign difference_2333 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_2537;
  assign less_2537 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_2538;
  assign sum_2538 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_2556;
  assign not_2556 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_328;
  assign select_328 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_328 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_328_s1_q;
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
      select_328_s1_q <= select_328;
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
  logic equal_329;
  assign equal_329 = select_328_s1_q[1:0] == 2'h0;
  // hls/stages/census.hpp:35
  logic [6:0] select_331;
  assign select_331 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:41
  logic or_336;
  assign or_336 = sample_pair_first_s1_q | raster_at_live_q;
  logic [3:0] select_349;
  assign select_349 = sample_pair_first_s1_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = equal_329 ? sample_present_s1_q : (sample_present_s1_q & averager_running_mask_q);
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_s1_q ? select_331 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_366;
  assign equal_366 = select_328_s1_q == 4'hf;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1608;
  assign select_1608 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (select_349 + 4'h1) : select_349) : raster_at_y_q;
  logic [6:0] select_1610;
  assign select_1610 = sample_pair_whole_s1_q ? (select_331 + {6'h0, equal_366}) : raster_at_column_q;
  logic select_1617;
  assign select_1617 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_336 & (~raster_final_row_q)) : or_336) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_1619;
  assign select_1619 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:263
  logic select_1623;
  assign select_1623 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      raster_at_column_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
    end else if (s1_en) begin
      raster_at_y_q <= select_1608;
      raster_at_column_q <= select_1610;
      raster_at_live_q <= select_1617;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_1619 : raster_rows_left_q;
      raster_final_row_q <= select_1623;
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
  logic equal_329_s2_q;
  logic equal_332_s2_q;
  logic not_341_s2_q;
  logic equal_350_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic equal_366_s2_q;
  logic equal_367_s2_q;
  logic equal_373_s2_q;
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
      equal_329_s2_q <= equal_329;
      equal_332_s2_q <= {select_331, select_328_s1_q} == 11'h0;
      not_341_s2_q <= ~((~or_336) | (~(select_328_s1_q[1:0] == 2'h3)));
      equal_350_s2_q <= select_349 == 4'h0;
      whole_s2_q <= whole;
      column_s2_q <= column;
      equal_366_s2_q <= equal_366;
      equal_367_s2_q <= select_349 == 4'hf;
      equal_373_s2_q <= select_328_s1_q == 4'h3;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:116
  logic [8:0] select_335;
  assign select_335 = equal_329_s2_q ? (equal_332_s2_q ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/census.hpp:41
  logic [6:0] select_429;
  assign select_429 = sample_pair_first_s2_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] row;
  assign row = sample_pair_whole_s2_q ? select_429 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_1612;
  assign select_1612 = sample_last_s2_q ? (select_429 + {6'h0, equal_367_s2_q}) : select_429;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_row_q <= sample_pair_whole_s2_q ? select_1612 : raster_at_row_q;
      averager_place_q <= sample_pair_whole_s2_q ? select_335 : averager_place_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic equal_329_s3_q;
  logic [8:0] select_335_s3_q;
  logic not_341_s3_q;
  logic equal_350_s3_q;
  logic whole_s3_q;
  logic [6:0] column_s3_q;
  logic equal_366_s3_q;
  logic equal_367_s3_q;
  logic equal_373_s3_q;
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
      equal_329_s3_q <= equal_329_s2_q;
      select_335_s3_q <= select_335;
      not_341_s3_q <= not_341_s2_q;
      equal_350_s3_q <= equal_350_s2_q;
      whole_s3_q <= whole_s2_q;
      column_s3_q <= column_s2_q;
      equal_366_s3_q <= equal_366_s2_q;
      equal_367_s3_q <= equal_367_s2_q;
      equal_373_s3_q <= equal_373_s2_q;
      row_s3_q <= row;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:404
  logic and_344;
  assign and_344 = not_341_s3_q & (~(select_335_s3_q[8:5] == 4'hf));
  // hls/stages/census.hpp:126
  logic and_368;
  assign and_368 = equal_367_s3_q & and_344;
  // hls/stages/agreement.hpp:263
  logic and_370;
  assign and_370 = sample_pair_whole_s3_q & (equal_366_s3_q & and_368);
  // hls/stages/agreement.hpp:446
  logic equal_1867;
  assign equal_1867 = {last[7], column_s3_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:463
  logic [7:0] sum_1957;
  assign sum_1957 = {1'b0, row_s3_q} + 8'h1;

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic sample_pair_whole_s4_q;
  logic equal_329_s4_q;
  logic [8:0] select_335_s4_q;
  logic and_344_s4_q;
  logic equal_350_s4_q;
  logic whole_s4_q;
  logic [6:0] column_s4_q;
  logic and_368_s4_q;
  logic and_370_s4_q;
  logic equal_373_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1867_s4_q;
  logic and_1868_s4_q;
  logic equal_1958_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      equal_329_s4_q <= equal_329_s3_q;
      select_335_s4_q <= select_335_s3_q;
      and_344_s4_q <= and_344;
      equal_350_s4_q <= equal_350_s3_q;
      whole_s4_q <= whole_s3_q;
      column_s4_q <= column_s3_q;
      and_368_s4_q <= and_368;
      and_370_s4_q <= and_370;
      equal_373_s4_q <= equal_373_s3_q;
      row_s4_q <= row_s3_q;
      equal_1867_s4_q <= equal_1867;
      and_1868_s4_q <= and_370 & equal_1867;
      equal_1958_s4_q <= {sum_1957[7], cfg_height_i[10:4]} == {1'b0, sum_1957[6:0]};
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
  logic equal_390;
  assign equal_390 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:601
  logic equal_393;
  assign equal_393 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_395;
  assign equal_395 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:510
  logic select_1871;
  assign select_1871 = (and_1868_s4_q | (~ends_cell_q)) ? and_1868_s4_q : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_1871 ? (and_1868_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_1875;
  assign select_1875 = select_1871 ? (and_1868_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_1878;
  assign select_1878 = select_1871 ? (following_last_shift_q & (~and_1868_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:522
  logic [7:0] select_1880;
  assign select_1880 = select_1871 ? (and_1868_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:594
  logic and_1881;
  assign and_1881 = run_last_shift_q & equal_393;
  // hls/stages/agreement.hpp:603
  logic select_1883;
  assign select_1883 = equal_393 ? (~run_last_shift_q) : equal_395;
  // hls/stages/agreement.hpp:607
  logic equal_1884;
  assign equal_1884 = run_phase_q == 3'h1;
  logic not_1887;
  assign not_1887 = ~select_1883;
  // hls/stages/agreement.hpp:610
  logic equal_1889;
  assign equal_1889 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_1890;
  assign and_1890 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_1891;
  assign select_1891 = equal_1889 ? 2'h1 : {2{and_1890}};
  logic [2:0] select_1893;
  assign select_1893 = (and_1881 | (select_1883 | equal_1884)) ? (equal_1884 ? 3'h2 : {not_1887, {2{select_1883}}}) : (equal_390 ? 3'h6 : {select_1891[0], select_1891});
  // hls/stages/agreement.hpp:594
  logic and_1896;
  assign and_1896 = select_1883 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1899;
  assign select_1899 = (plan_shift_q[5] & select_1883) ? value : 7'h0;
  logic [1:0] or_1900;
  assign or_1900 = {2{so}} | select_1899[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_1904;
  assign or_1904 = (select_1883 ? plan_columns_q : 8'h0) | ((equal_1884 | equal_1889) ? whole_q : 8'h0);
  logic [1:0] or_1905;
  assign or_1905 = {2{and_1881}} | or_1904[4:3];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_1907;
  assign or_1907 = {or_1904[7:5], or_1905, or_1904[2:0]} | (equal_390 ? drawn_q : 8'h0);
  logic [4:0] or_1908;
  assign or_1908 = {5{so}} | {or_1907[6], or_1907[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_1912;
  assign not_1912 = ~run_shift_q[5];
  logic [7:0] select_1915;
  assign select_1915 = equal_393 ? ({{7{not_1912}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_1919;
  assign select_1919 = and_1868_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_1921;
  assign select_1921 = select_1871 ? {select_1919[6], select_1919} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_1924;
  assign select_1924 = select_1871 ? (and_1868_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:447
  logic [6:0] select_1931;
  assign select_1931 = equal_1867_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_1935;
  assign select_1935 = and_370_s4_q ? (equal_1867_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_1938;
  assign select_1938 = and_370_s4_q ? (equal_1867_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_1952;
  assign select_1952 = (ends_cell_q | select_1871) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_393 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_1956;
  assign and_1956 = (~select_1871) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:507
  logic select_1960;
  assign select_1960 = and_370_s4_q ? (equal_1867_s4_q ? equal_1958_s4_q : final_row_q) : final_row_q;

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
      run_shift_q <= select_1875;
      run_last_shift_q <= select_1878;
      run_span_q <= select_1880;
      following_phase_q <= select_1893;
      following_shift_q <= select_1883 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_1896;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1899[6], or_1900, select_1899[3:0]};
      following_columns_q <= {or_1907[7], or_1908[4], or_1907[5:4], or_1908[3:0]};
      plan_shift_q <= equal_393 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_1915;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_1921;
      columns_left_q <= select_1924;
      last_q <= and_370_s4_q ? (equal_1867_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_370_s4_q ? select_1931 : least_q;
      whole_q <= select_1935;
      drawn_q <= select_1938;
      slot_q <= select_1871 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_1952;
      ends_q <= and_1956;
      final_row_q <= select_1960;
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
  logic equal_329_s5_q;
  logic [8:0] select_335_s5_q;
  logic and_344_s5_q;
  logic equal_350_s5_q;
  logic whole_s5_q;
  logic [6:0] column_s5_q;
  logic and_368_s5_q;
  logic and_370_s5_q;
  logic equal_373_s5_q;
  logic so_s5_q;
  logic equal_390_s5_q;
  logic equal_393_s5_q;
  logic equal_395_s5_q;
  logic [7:0] sum_396_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_506_s5_q;
  logic equal_515_s5_q;
  logic equal_1339_s5_q;
  logic equal_1867_s5_q;
  logic and_1868_s5_q;
  logic select_1871_s5_q;
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
      equal_329_s5_q <= equal_329_s4_q;
      select_335_s5_q <= select_335_s4_q;
      and_344_s5_q <= and_344_s4_q;
      equal_350_s5_q <= equal_350_s4_q;
      whole_s5_q <= whole_s4_q;
      column_s5_q <= column_s4_q;
      and_368_s5_q <= and_368_s4_q;
      and_370_s5_q <= and_370_s4_q;
      equal_373_s5_q <= equal_373_s4_q;
      so_s5_q <= so;
      equal_390_s5_q <= equal_390;
      equal_393_s5_q <= equal_393;
      equal_395_s5_q <= equal_395;
      sum_396_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_506_s5_q <= {1'b0, last_q} + 8'h3;
      equal_515_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_1339_s5_q <= run_phase_q == 3'h7;
      equal_1867_s5_q <= equal_1867_s4_q;
      and_1868_s5_q <= and_1868_s4_q;
      select_1871_s5_q <= select_1871;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_397;
  assign select_397 = run_shift_s5_q[5] ? x_s5_q : sum_396_s5_q;
  logic less_398;
  assign less_398 = {1'b0, last_s5_q} < select_397;
  // hls/stages/agreement.hpp:216
  logic not_399;
  assign not_399 = ~less_398;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:515
  logic [6:0] select_1940;
  assign select_1940 = select_1871_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_1940;
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
  logic equal_329_s6_q;
  logic [8:0] select_335_s6_q;
  logic and_344_s6_q;
  logic equal_350_s6_q;
  logic whole_s6_q;
  logic [6:0] column_s6_q;
  logic and_368_s6_q;
  logic and_370_s6_q;
  logic equal_373_s6_q;
  logic so_s6_q;
  logic equal_390_s6_q;
  logic equal_393_s6_q;
  logic [6:0] sum_396_s6_q;
  logic less_398_s6_q;
  logic not_399_s6_q;
  logic and_400_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_510_s6_q;
  logic equal_515_s6_q;
  logic equal_1329_s6_q;
  logic equal_1339_s6_q;
  logic equal_1867_s6_q;
  logic and_1868_s6_q;
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
      equal_329_s6_q <= equal_329_s5_q;
      select_335_s6_q <= select_335_s5_q;
      and_344_s6_q <= and_344_s5_q;
      equal_350_s6_q <= equal_350_s5_q;
      whole_s6_q <= whole_s5_q;
      column_s6_q <= column_s5_q;
      and_368_s6_q <= and_368_s5_q;
      and_370_s6_q <= and_370_s5_q;
      equal_373_s6_q <= equal_373_s5_q;
      so_s6_q <= so_s5_q;
      equal_390_s6_q <= equal_390_s5_q;
      equal_393_s6_q <= equal_393_s5_q;
      sum_396_s6_q <= sum_396_s5_q[6:0];
      less_398_s6_q <= less_398;
      not_399_s6_q <= not_399;
      and_400_s6_q <= equal_395_s5_q & not_399;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_510_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_506_s5_q < select_397)));
      equal_515_s6_q <= equal_515_s5_q;
      equal_1329_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1339_s6_q <= equal_1339_s5_q;
      equal_1867_s6_q <= equal_1867_s5_q;
      and_1868_s6_q <= and_1868_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:581
  logic or_391;
  assign or_391 = so_s6_q | equal_390_s6_q;
  // hls/stages/agreement.hpp:704
  logic not_392;
  assign not_392 = ~or_391;
  // hls/stages/agreement.hpp:141
  logic select_486;
  assign select_486 = equal_393_s6_q ? not_399_s6_q : and_400_s6_q;
  logic and_511;
  assign and_511 = equal_393_s6_q & and_510_s6_q;
  logic select_512;
  assign select_512 = or_391 ? not_399_s6_q : and_511;
  // hls/stages/agreement.hpp:782
  logic or_517;
  assign or_517 = equal_515_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_396_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1294; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_391 ? not_399_s6_q : select_486);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1295; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_393_s6_q ? sum_396_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_392 & select_486);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1296; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 46'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_391 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_512;
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
  logic equal_329_s7_q;
  logic [8:0] select_335_s7_q;
  logic and_344_s7_q;
  logic equal_350_s7_q;
  logic whole_s7_q;
  logic [6:0] column_s7_q;
  logic and_368_s7_q;
  logic and_370_s7_q;
  logic equal_373_s7_q;
  logic so_s7_q;
  logic equal_390_s7_q;
  logic or_391_s7_q;
  logic equal_393_s7_q;
  logic less_398_s7_q;
  logic not_399_s7_q;
  logic and_402_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_512_s7_q;
  logic select_519_s7_q;
  logic and_1321_s7_q;
  logic [6:0] right_s7_q;
  logic select_1330_s7_q;
  logic equal_1339_s7_q;
  logic equal_1867_s7_q;
  logic and_1868_s7_q;
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
      equal_329_s7_q <= equal_329_s6_q;
      select_335_s7_q <= select_335_s6_q;
      and_344_s7_q <= and_344_s6_q;
      equal_350_s7_q <= equal_350_s6_q;
      whole_s7_q <= whole_s6_q;
      column_s7_q <= column_s6_q;
      and_368_s7_q <= and_368_s6_q;
      and_370_s7_q <= and_370_s6_q;
      equal_373_s7_q <= equal_373_s6_q;
      so_s7_q <= so_s6_q;
      equal_390_s7_q <= equal_390_s6_q;
      or_391_s7_q <= or_391;
      equal_393_s7_q <= equal_393_s6_q;
      less_398_s7_q <= less_398_s6_q;
      not_399_s7_q <= not_399_s6_q;
      and_402_s7_q <= not_392 & ((~equal_393_s6_q) & and_400_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_512_s7_q <= select_512;
      select_519_s7_q <= or_517 ? equal_515_s6_q : (~age_s6_q[1]);
      and_1321_s7_q <= not_392 & and_511;
      right_s7_q <= right;
      select_1330_s7_q <= or_517 ? equal_515_s6_q : equal_1329_s6_q;
      equal_1339_s7_q <= equal_1339_s6_q;
      equal_1867_s7_q <= equal_1867_s6_q;
      and_1868_s7_q <= and_1868_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1293; read in stage 7, written in stage 26: 7 < 26 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_402_s7_q;
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
  logic equal_329_s8_q;
  logic [8:0] select_335_s8_q;
  logic and_344_s8_q;
  logic equal_350_s8_q;
  logic whole_s8_q;
  logic [6:0] column_s8_q;
  logic and_368_s8_q;
  logic and_370_s8_q;
  logic equal_373_s8_q;
  logic so_s8_q;
  logic equal_390_s8_q;
  logic or_391_s8_q;
  logic equal_393_s8_q;
  logic less_398_s8_q;
  logic not_399_s8_q;
  logic and_402_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_512_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic select_519_s8_q;
  logic and_1321_s8_q;
  logic [6:0] right_s8_q;
  logic select_1330_s8_q;
  logic equal_1339_s8_q;
  logic equal_1867_s8_q;
  logic and_1868_s8_q;
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
      equal_329_s8_q <= equal_329_s7_q;
      select_335_s8_q <= select_335_s7_q;
      and_344_s8_q <= and_344_s7_q;
      equal_350_s8_q <= equal_350_s7_q;
      whole_s8_q <= whole_s7_q;
      column_s8_q <= column_s7_q;
      and_368_s8_q <= and_368_s7_q;
      and_370_s8_q <= and_370_s7_q;
      equal_373_s8_q <= equal_373_s7_q;
      so_s8_q <= so_s7_q;
      equal_390_s8_q <= equal_390_s7_q;
      or_391_s8_q <= or_391_s7_q;
      equal_393_s8_q <= equal_393_s7_q;
      less_398_s8_q <= less_398_s7_q;
      not_399_s8_q <= not_399_s7_q;
      and_402_s8_q <= and_402_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_512_s8_q <= select_512_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      select_519_s8_q <= select_519_s7_q;
      and_1321_s8_q <= and_1321_s7_q;
      right_s8_q <= right_s7_q;
      select_1330_s8_q <= select_1330_s7_q;
      equal_1339_s8_q <= equal_1339_s7_q;
      equal_1867_s8_q <= equal_1867_s7_q;
      and_1868_s8_q <= and_1868_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:653
  logic not_490;
  assign not_490 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:212
  logic and_525;
  assign and_525 = left_rdata_s8_q[44] & not_399_s8_q;
  logic and_526;
  assign and_526 = right_codes_rdata_s8_q[38] & not_399_s8_q;
  logic [11:0] select_527;
  assign select_527 = less_398_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_528;
  assign select_528 = less_398_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_532;
  assign select_532 = and_525 ? (and_526 ? (~(select_527 ^ select_528)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_548;
  assign and_548 = left_rdata_s8_q[60] & not_399_s8_q;
  logic and_549;
  assign and_549 = right_codes_rdata_s8_q[51] & not_399_s8_q;
  logic [11:0] select_550;
  assign select_550 = less_398_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_551;
  assign select_551 = less_398_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_555;
  assign select_555 = and_548 ? (and_549 ? (~(select_550 ^ select_551)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_565;
  assign and_565 = left_rdata_s8_q[76] & not_399_s8_q;
  logic and_566;
  assign and_566 = right_codes_rdata_s8_q[64] & not_399_s8_q;
  logic [11:0] select_567;
  assign select_567 = less_398_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_568;
  assign select_568 = less_398_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_572;
  assign select_572 = and_565 ? (and_566 ? (~(select_567 ^ select_568)) : 12'h0) : 12'h0;
  logic [11:0] select_780;
  assign select_780 = (slot_s8_q[0] ? and_566 : and_549) ? (~(select_528 ^ (slot_s8_q[0] ? select_567 : select_550))) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_797;
  assign and_797 = right_codes_rdata_s8_q[77] & not_399_s8_q;
  logic [11:0] select_799;
  assign select_799 = less_398_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_803;
  assign select_803 = (slot_s8_q[0] ? and_797 : and_566) ? (~(select_551 ^ (slot_s8_q[0] ? select_799 : select_567))) : 12'h0;
  // hls/stages/agreement.hpp:718
  logic select_815;
  assign select_815 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_399_s8_q) : and_797;
  logic [11:0] select_817;
  assign select_817 = slot_s8_q[0] ? (less_398_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_799;
  // hls/stages/agreement.hpp:212
  logic and_1026;
  assign and_1026 = right_codes_rdata_s8_q[25] & not_399_s8_q;
  // hls/stages/agreement.hpp:718
  logic select_1027;
  assign select_1027 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_399_s8_q) : and_1026;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1029;
  assign select_1029 = less_398_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1030;
  assign select_1030 = slot_s8_q[0] ? (less_398_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1029;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1054;
  assign select_1054 = (slot_s8_q[0] ? and_1026 : and_526) ? (~(select_551 ^ (slot_s8_q[0] ? select_1029 : select_527))) : 12'h0;
  logic [11:0] select_1069;
  assign select_1069 = (slot_s8_q[0] ? and_526 : and_549) ? (~(select_568 ^ (slot_s8_q[0] ? select_527 : select_550))) : 12'h0;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:932
  logic and_1345;
  assign and_1345 = (or_391_s8_q & (left_rdata_s8_q[61] & not_399_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:235
  logic and_1353;
  assign and_1353 = not_399_s8_q & (or_391_s8_q & (left_rdata_s8_q[63] & not_399_s8_q));
  // hls/stages/agreement.hpp:447
  logic select_1964;
  assign select_1964 = equal_1867_s8_q ? (~({row_s8_q, 1'b0} < {sum_1961, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2201;
  assign and_2201 = and_370_s8_q & (equal_1867_s8_q & (row_s8_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s8_en) begin
      row_q <= and_370_s8_q ? (equal_1867_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_370_s8_q ? select_1964 : lower_half_q;
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
  logic equal_329_s9_q;
  logic [8:0] select_335_s9_q;
  logic and_344_s9_q;
  logic equal_350_s9_q;
  logic whole_s9_q;
  logic [6:0] column_s9_q;
  logic and_368_s9_q;
  logic and_370_s9_q;
  logic equal_373_s9_q;
  logic so_s9_q;
  logic equal_390_s9_q;
  logic or_391_s9_q;
  logic equal_393_s9_q;
  logic less_398_s9_q;
  logic not_399_s9_q;
  logic and_402_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic equal_431_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_491_s9_q;
  logic and_492_s9_q;
  logic and_493_s9_q;
  logic and_494_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_498_s9_q;
  logic and_499_s9_q;
  logic and_500_s9_q;
  logic and_501_s9_q;
  logic and_502_s9_q;
  logic and_503_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_512_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic select_519_s9_q;
  logic and_525_s9_q;
  logic [11:0] select_532_s9_q;
  logic and_548_s9_q;
  logic [11:0] select_555_s9_q;
  logic and_565_s9_q;
  logic [11:0] select_572_s9_q;
  logic [11:0] select_780_s9_q;
  logic [11:0] select_803_s9_q;
  logic [11:0] select_820_s9_q;
  logic [11:0] select_1033_s9_q;
  logic [11:0] select_1054_s9_q;
  logic [11:0] select_1069_s9_q;
  logic and_1321_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic select_1330_s9_q;
  logic equal_1339_s9_q;
  logic and_1346_s9_q;
  logic and_1349_s9_q;
  logic and_1353_s9_q;
  logic and_1597_s9_q;
  logic equal_1743_s9_q;
  logic equal_1867_s9_q;
  logic less_2119_s9_q;
  logic and_2202_s9_q;
  logic and_2204_s9_q;
  logic less_2311_s9_q;
  logic equal_2518_s9_q;
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
      equal_329_s9_q <= equal_329_s8_q;
      select_335_s9_q <= select_335_s8_q;
      and_344_s9_q <= and_344_s8_q;
      equal_350_s9_q <= equal_350_s8_q;
      whole_s9_q <= whole_s8_q;
      column_s9_q <= column_s8_q;
      and_368_s9_q <= and_368_s8_q;
      and_370_s9_q <= and_370_s8_q;
      equal_373_s9_q <= equal_373_s8_q;
      so_s9_q <= so_s8_q;
      equal_390_s9_q <= equal_390_s8_q;
      or_391_s9_q <= or_391_s8_q;
      equal_393_s9_q <= equal_393_s8_q;
      less_398_s9_q <= less_398_s8_q;
      not_399_s9_q <= not_399_s8_q;
      and_402_s9_q <= and_402_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_431_s9_q <= row_s8_q == 7'h0;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_491_s9_q <= left_rdata_s8_q[12] & not_490;
      and_492_s9_q <= left_rdata_s8_q[28] & not_490;
      and_493_s9_q <= left_rdata_s8_q[44] & not_490;
      and_494_s9_q <= left_rdata_s8_q[60] & not_490;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_498_s9_q <= right_codes_rdata_s8_q[12] & not_490;
      and_499_s9_q <= right_codes_rdata_s8_q[25] & not_490;
      and_500_s9_q <= right_codes_rdata_s8_q[38] & not_490;
      and_501_s9_q <= right_codes_rdata_s8_q[51] & not_490;
      and_502_s9_q <= right_codes_rdata_s8_q[64] & not_490;
      and_503_s9_q <= right_codes_rdata_s8_q[77] & not_490;
      x_s9_2_q <= x_s8_2_q;
      select_512_s9_q <= select_512_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_519_s9_q <= select_519_s8_q;
      and_525_s9_q <= and_525;
      select_532_s9_q <= select_532;
      and_548_s9_q <= and_548;
      select_555_s9_q <= select_555;
      and_565_s9_q <= and_565;
      select_572_s9_q <= select_572;
      select_780_s9_q <= select_780;
      select_803_s9_q <= select_803;
      select_820_s9_q <= select_815 ? (~(select_568 ^ select_817)) : 12'h0;
      select_1033_s9_q <= select_1027 ? (~(select_528 ^ select_1030)) : 12'h0;
      select_1054_s9_q <= select_1054;
      select_1069_s9_q <= select_1069;
      and_1321_s9_q <= and_1321_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      select_1330_s9_q <= select_1330_s8_q;
      equal_1339_s9_q <= equal_1339_s8_q;
      and_1346_s9_q <= not_399_s8_q & and_1345;
      and_1349_s9_q <= (or_391_s8_q & (left_rdata_s8_q[62] & not_399_s8_q)) & and_1345;
      and_1353_s9_q <= and_1353;
      and_1597_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_1743_s9_q <= (column_s8_q | row_s8_q) == 7'h0;
      equal_1867_s9_q <= equal_1867_s8_q;
      less_2119_s9_q <= 6'h4 < row_q[6:1];
      and_2202_s9_q <= and_1868_s8_q & and_2201;
      and_2204_s9_q <= and_1868_s8_q & (~and_2201);
      less_2311_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_2518_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/count_bits.hpp:24
  logic parity_538;
  assign parity_538 = ^select_532_s9_q[5:3];
  logic parity_541;
  assign parity_541 = ^select_532_s9_q[8:6];
  logic parity_544;
  assign parity_544 = ^select_532_s9_q[11:3];
  logic parity_558;
  assign parity_558 = ^select_555_s9_q[8:6];
  logic parity_561;
  assign parity_561 = ^select_555_s9_q[11:9];
  logic parity_578;
  assign parity_578 = ^select_572_s9_q[2:0];
  logic parity_581;
  assign parity_581 = ^select_572_s9_q[5:3];
  logic parity_584;
  assign parity_584 = ^select_572_s9_q[8:0];
  logic parity_590;
  assign parity_590 = ^select_572_s9_q[11:9];
  logic parity_593;
  assign parity_593 = ^select_555_s9_q[2:0];
  logic parity_596;
  assign parity_596 = ^{select_572_s9_q[11:9], select_555_s9_q[5:0]};
  logic parity_599;
  assign parity_599 = ^{select_572_s9_q, select_555_s9_q, select_532_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_604;
  assign or_604 = (select_532_s9_q[1:0] == 2'h3) | (select_532_s9_q[2] & (select_532_s9_q[0] | select_532_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_608;
  assign or_608 = (select_555_s9_q[7:6] == 2'h3) | (select_555_s9_q[8] & (select_555_s9_q[6] | select_555_s9_q[7]));
  logic or_612;
  assign or_612 = (select_555_s9_q[10:9] == 2'h3) | (select_555_s9_q[11] & (select_555_s9_q[9] | select_555_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_620;
  assign or_620 = (select_572_s9_q[7:6] == 2'h3) | (select_572_s9_q[8] & (~(select_572_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_624;
  assign or_624 = (select_572_s9_q[1:0] == 2'h3) | (select_572_s9_q[2] & (select_572_s9_q[0] | select_572_s9_q[1]));
  logic or_628;
  assign or_628 = (select_572_s9_q[4:3] == 2'h3) | (select_572_s9_q[5] & (select_572_s9_q[3] | select_572_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_631;
  assign parity_631 = ^{or_628, or_624, or_620};
  // hls/stages/count_bits.hpp:23
  logic or_635;
  assign or_635 = (select_555_s9_q[4:3] == 2'h3) | (select_555_s9_q[5] & (select_555_s9_q[3] | select_555_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_639;
  assign or_639 = (select_572_s9_q[10:9] == 2'h3) | (select_572_s9_q[11] & (select_572_s9_q[9] | select_572_s9_q[10]));
  logic or_643;
  assign or_643 = (select_555_s9_q[1:0] == 2'h3) | (select_555_s9_q[2] & (select_555_s9_q[0] | select_555_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_646;
  assign parity_646 = ^{or_643, or_639, or_635};
  logic parity_649;
  assign parity_649 = ^{or_643, or_639, or_635, or_628, or_624, or_620, or_612, or_608, or_604};
  // hls/stages/count_bits.hpp:25
  logic or_654;
  assign or_654 = (parity_538 & parity_541) | ((^select_532_s9_q[11:9]) & (parity_538 | parity_541));
  logic and_657;
  assign and_657 = (^{select_555_s9_q[11:6], select_532_s9_q[2:0]}) & (parity_584 | parity_596);
  // hls/stages/count_bits.hpp:23
  logic or_665;
  assign or_665 = (select_532_s9_q[10:9] == 2'h3) | (select_532_s9_q[11] & (select_532_s9_q[9] | select_532_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_669;
  assign or_669 = (select_532_s9_q[4:3] == 2'h3) | (select_532_s9_q[5] & (select_532_s9_q[3] | select_532_s9_q[4]));
  logic or_673;
  assign or_673 = (select_532_s9_q[7:6] == 2'h3) | (select_532_s9_q[8] & (select_532_s9_q[6] | select_532_s9_q[7]));
  logic or_680;
  assign or_680 = (parity_558 & parity_561) | ((^select_532_s9_q[2:0]) & (parity_558 | parity_561));
  logic or_684;
  assign or_684 = (parity_578 & parity_581) | ((^select_572_s9_q[8:6]) & (parity_578 | parity_581));
  logic or_688;
  assign or_688 = (parity_590 & parity_593) | ((^select_555_s9_q[5:3]) & (parity_590 | parity_593));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_781;
  assign select_781 = and_525_s9_q ? select_780_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_787;
  assign parity_787 = ^select_781[5:3];
  logic parity_790;
  assign parity_790 = ^select_781[8:6];
  logic parity_793;
  assign parity_793 = ^select_781[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_804;
  assign select_804 = and_548_s9_q ? select_803_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_807;
  assign parity_807 = ^select_804[8:6];
  logic parity_810;
  assign parity_810 = ^select_804[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_821;
  assign select_821 = and_565_s9_q ? select_820_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_827;
  assign parity_827 = ^select_821[2:0];
  logic parity_830;
  assign parity_830 = ^select_821[5:3];
  logic parity_833;
  assign parity_833 = ^select_821[8:0];
  logic parity_839;
  assign parity_839 = ^select_821[11:9];
  logic parity_842;
  assign parity_842 = ^select_804[2:0];
  logic parity_845;
  assign parity_845 = ^{select_821[11:9], select_804[5:0]};
  logic parity_848;
  assign parity_848 = ^{select_821, select_804, select_781[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_853;
  assign or_853 = (select_781[1:0] == 2'h3) | (select_781[2] & (select_781[0] | select_781[1]));
  // hls/stages/count_bits.hpp:25
  logic or_857;
  assign or_857 = (select_804[7:6] == 2'h3) | (select_804[8] & (select_804[6] | select_804[7]));
  logic or_861;
  assign or_861 = (select_804[10:9] == 2'h3) | (select_804[11] & (select_804[9] | select_804[10]));
  // hls/stages/count_bits.hpp:23
  logic or_869;
  assign or_869 = (select_821[7:6] == 2'h3) | (select_821[8] & (~(select_821[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_873;
  assign or_873 = (select_821[1:0] == 2'h3) | (select_821[2] & (select_821[0] | select_821[1]));
  logic or_877;
  assign or_877 = (select_821[4:3] == 2'h3) | (select_821[5] & (select_821[3] | select_821[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_880;
  assign parity_880 = ^{or_877, or_873, or_869};
  // hls/stages/count_bits.hpp:23
  logic or_884;
  assign or_884 = (select_804[4:3] == 2'h3) | (select_804[5] & (select_804[3] | select_804[4]));
  // hls/stages/count_bits.hpp:25
  logic or_888;
  assign or_888 = (select_821[10:9] == 2'h3) | (select_821[11] & (select_821[9] | select_821[10]));
  logic or_892;
  assign or_892 = (select_804[1:0] == 2'h3) | (select_804[2] & (select_804[0] | select_804[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_895;
  assign parity_895 = ^{or_892, or_888, or_884};
  logic parity_898;
  assign parity_898 = ^{or_892, or_888, or_884, or_877, or_873, or_869, or_861, or_857, or_853};
  // hls/stages/count_bits.hpp:25
  logic or_903;
  assign or_903 = (parity_787 & parity_790) | ((^select_781[11:9]) & (parity_787 | parity_790));
  logic and_906;
  assign and_906 = (^{select_804[11:6], select_781[2:0]}) & (parity_833 | parity_845);
  // hls/stages/count_bits.hpp:23
  logic or_914;
  assign or_914 = (select_781[10:9] == 2'h3) | (select_781[11] & (select_781[9] | select_781[10]));
  // hls/stages/count_bits.hpp:25
  logic or_918;
  assign or_918 = (select_781[4:3] == 2'h3) | (select_781[5] & (select_781[3] | select_781[4]));
  logic or_922;
  assign or_922 = (select_781[7:6] == 2'h3) | (select_781[8] & (select_781[6] | select_781[7]));
  logic or_929;
  assign or_929 = (parity_807 & parity_810) | ((^select_781[2:0]) & (parity_807 | parity_810));
  logic or_933;
  assign or_933 = (parity_827 & parity_830) | ((^select_821[8:6]) & (parity_827 | parity_830));
  logic or_937;
  assign or_937 = (parity_839 & parity_842) | ((^select_804[5:3]) & (parity_839 | parity_842));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1034;
  assign select_1034 = and_525_s9_q ? select_1033_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1040;
  assign parity_1040 = ^select_1034[5:3];
  logic parity_1043;
  assign parity_1043 = ^select_1034[8:6];
  logic parity_1046;
  assign parity_1046 = ^select_1034[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1055;
  assign select_1055 = and_548_s9_q ? select_1054_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1058;
  assign parity_1058 = ^select_1055[8:6];
  logic parity_1061;
  assign parity_1061 = ^select_1055[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1070;
  assign select_1070 = and_565_s9_q ? select_1069_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1076;
  assign parity_1076 = ^select_1070[2:0];
  logic parity_1079;
  assign parity_1079 = ^select_1070[5:3];
  logic parity_1082;
  assign parity_1082 = ^select_1070[8:0];
  logic parity_1088;
  assign parity_1088 = ^select_1070[11:9];
  logic parity_1091;
  assign parity_1091 = ^select_1055[2:0];
  logic parity_1094;
  assign parity_1094 = ^{select_1070[11:9], select_1055[5:0]};
  logic parity_1097;
  assign parity_1097 = ^{select_1070, select_1055, select_1034[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1102;
  assign or_1102 = (select_1034[1:0] == 2'h3) | (select_1034[2] & (select_1034[0] | select_1034[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1106;
  assign or_1106 = (select_1055[7:6] == 2'h3) | (select_1055[8] & (select_1055[6] | select_1055[7]));
  logic or_1110;
  assign or_1110 = (select_1055[10:9] == 2'h3) | (select_1055[11] & (select_1055[9] | select_1055[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1118;
  assign or_1118 = (select_1070[7:6] == 2'h3) | (select_1070[8] & (~(select_1070[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1122;
  assign or_1122 = (select_1070[1:0] == 2'h3) | (select_1070[2] & (select_1070[0] | select_1070[1]));
  logic or_1126;
  assign or_1126 = (select_1070[4:3] == 2'h3) | (select_1070[5] & (select_1070[3] | select_1070[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1129;
  assign parity_1129 = ^{or_1126, or_1122, or_1118};
  // hls/stages/count_bits.hpp:23
  logic or_1133;
  assign or_1133 = (select_1055[4:3] == 2'h3) | (select_1055[5] & (select_1055[3] | select_1055[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1137;
  assign or_1137 = (select_1070[10:9] == 2'h3) | (select_1070[11] & (select_1070[9] | select_1070[10]));
  logic or_1141;
  assign or_1141 = (select_1055[1:0] == 2'h3) | (select_1055[2] & (select_1055[0] | select_1055[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1144;
  assign parity_1144 = ^{or_1141, or_1137, or_1133};
  logic parity_1147;
  assign parity_1147 = ^{or_1141, or_1137, or_1133, or_1126, or_1122, or_1118, or_1110, or_1106, or_1102};
  // hls/stages/count_bits.hpp:25
  logic or_1152;
  assign or_1152 = (parity_1040 & parity_1043) | ((^select_1034[11:9]) & (parity_1040 | parity_1043));
  logic and_1155;
  assign and_1155 = (^{select_1055[11:6], select_1034[2:0]}) & (parity_1082 | parity_1094);
  // hls/stages/count_bits.hpp:23
  logic or_1163;
  assign or_1163 = (select_1034[10:9] == 2'h3) | (select_1034[11] & (select_1034[9] | select_1034[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1167;
  assign or_1167 = (select_1034[4:3] == 2'h3) | (select_1034[5] & (select_1034[3] | select_1034[4]));
  logic or_1171;
  assign or_1171 = (select_1034[7:6] == 2'h3) | (select_1034[8] & (select_1034[6] | select_1034[7]));
  logic or_1178;
  assign or_1178 = (parity_1058 & parity_1061) | ((^select_1034[2:0]) & (parity_1058 | parity_1061));
  logic or_1182;
  assign or_1182 = (parity_1076 & parity_1079) | ((^select_1070[8:6]) & (parity_1076 | parity_1079));
  logic or_1186;
  assign or_1186 = (parity_1088 & parity_1091) | ((^select_1055[5:3]) & (parity_1088 | parity_1091));
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:235
  logic or_1367;
  assign or_1367 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_1424;
  assign sum_1424 = {1'b0, last_s9_q[6:2]} + 6'h1;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_402_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_494_s9_q, left_rdata_s9_q[56:42], and_493_s9_q, left_rdata_s9_q[41:27], and_492_s9_q, left_rdata_s9_q[26:12], and_491_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_402_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_503_s9_q, right_codes_rdata_s9_q[71:60], and_502_s9_q, right_codes_rdata_s9_q[59:48], and_501_s9_q, right_codes_rdata_s9_q[47:36], and_500_s9_q, right_codes_rdata_s9_q[35:24], and_499_s9_q, right_codes_rdata_s9_q[23:12], and_498_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
  logic equal_329_s10_q;
  logic [8:0] select_335_s10_q;
  logic and_344_s10_q;
  logic equal_350_s10_q;
  logic whole_s10_q;
  logic [6:0] column_s10_q;
  logic and_368_s10_q;
  logic and_370_s10_q;
  logic equal_373_s10_q;
  logic so_s10_q;
  logic equal_390_s10_q;
  logic or_391_s10_q;
  logic equal_393_s10_q;
  logic less_398_s10_q;
  logic not_399_s10_q;
  logic equal_431_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_512_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic select_519_s10_q;
  logic xor_600_s10_q;
  logic parity_649_s10_q;
  logic and_650_s10_q;
  logic or_654_s10_q;
  logic or_658_s10_q;
  logic or_665_s10_q;
  logic or_669_s10_q;
  logic or_673_s10_q;
  logic or_680_s10_q;
  logic or_684_s10_q;
  logic or_688_s10_q;
  logic and_697_s10_q;
  logic and_699_s10_q;
  logic or_711_s10_q;
  logic or_715_s10_q;
  logic or_719_s10_q;
  logic xor_849_s10_q;
  logic parity_864_s10_q;
  logic parity_898_s10_q;
  logic and_899_s10_q;
  logic or_903_s10_q;
  logic or_907_s10_q;
  logic or_914_s10_q;
  logic or_918_s10_q;
  logic or_922_s10_q;
  logic or_929_s10_q;
  logic or_933_s10_q;
  logic or_937_s10_q;
  logic and_946_s10_q;
  logic or_947_s10_q;
  logic or_960_s10_q;
  logic or_964_s10_q;
  logic or_968_s10_q;
  logic xor_1098_s10_q;
  logic parity_1113_s10_q;
  logic parity_1147_s10_q;
  logic and_1148_s10_q;
  logic or_1152_s10_q;
  logic or_1156_s10_q;
  logic or_1163_s10_q;
  logic or_1167_s10_q;
  logic or_1171_s10_q;
  logic or_1178_s10_q;
  logic or_1182_s10_q;
  logic or_1186_s10_q;
  logic and_1195_s10_q;
  logic or_1196_s10_q;
  logic or_1209_s10_q;
  logic or_1213_s10_q;
  logic or_1217_s10_q;
  logic and_1321_s10_q;
  logic [6:0] select_1325_s10_q;
  logic [6:0] right_s10_q;
  logic select_1330_s10_q;
  logic equal_1339_s10_q;
  logic and_1346_s10_q;
  logic and_1349_s10_q;
  logic and_1353_s10_q;
  logic or_1367_s10_q;
  logic less_1425_s10_q;
  logic equal_1465_s10_q;
  logic and_1600_s10_q;
  logic equal_1743_s10_q;
  logic equal_1867_s10_q;
  logic less_2119_s10_q;
  logic and_2202_s10_q;
  logic and_2204_s10_q;
  logic less_2311_s10_q;
  logic equal_2518_s10_q;
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
      equal_329_s10_q <= equal_329_s9_q;
      select_335_s10_q <= select_335_s9_q;
      and_344_s10_q <= and_344_s9_q;
      equal_350_s10_q <= equal_350_s9_q;
      whole_s10_q <= whole_s9_q;
      column_s10_q <= column_s9_q;
      and_368_s10_q <= and_368_s9_q;
      and_370_s10_q <= and_370_s9_q;
      equal_373_s10_q <= equal_373_s9_q;
      so_s10_q <= so_s9_q;
      equal_390_s10_q <= equal_390_s9_q;
      or_391_s10_q <= or_391_s9_q;
      equal_393_s10_q <= equal_393_s9_q;
      less_398_s10_q <= less_398_s9_q;
      not_399_s10_q <= not_399_s9_q;
      equal_431_s10_q <= equal_431_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_512_s10_q <= select_512_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_519_s10_q <= select_519_s9_q;
      xor_600_s10_q <= parity_544 ^ parity_599;
      parity_649_s10_q <= parity_649;
      and_650_s10_q <= parity_544 & parity_599;
      or_654_s10_q <= or_654;
      or_658_s10_q <= (parity_584 & parity_596) | and_657;
      or_665_s10_q <= or_665;
      or_669_s10_q <= or_669;
      or_673_s10_q <= or_673;
      or_680_s10_q <= or_680;
      or_684_s10_q <= or_684;
      or_688_s10_q <= or_688;
      and_697_s10_q <= parity_631 & parity_646;
      and_699_s10_q <= (^{or_612, or_608, or_604}) & (parity_631 | parity_646);
      or_711_s10_q <= (or_608 & or_612) | (or_604 & (or_608 | or_612));
      or_715_s10_q <= (or_624 & or_628) | (or_620 & (or_624 | or_628));
      or_719_s10_q <= (or_639 & or_643) | (or_635 & (or_639 | or_643));
      xor_849_s10_q <= parity_793 ^ parity_848;
      parity_864_s10_q <= ^{or_861, or_857, or_853};
      parity_898_s10_q <= parity_898;
      and_899_s10_q <= parity_793 & parity_848;
      or_903_s10_q <= or_903;
      or_907_s10_q <= (parity_833 & parity_845) | and_906;
      or_914_s10_q <= or_914;
      or_918_s10_q <= or_918;
      or_922_s10_q <= or_922;
      or_929_s10_q <= or_929;
      or_933_s10_q <= or_933;
      or_937_s10_q <= or_937;
      and_946_s10_q <= parity_880 & parity_895;
      or_947_s10_q <= parity_880 | parity_895;
      or_960_s10_q <= (or_857 & or_861) | (or_853 & (or_857 | or_861));
      or_964_s10_q <= (or_873 & or_877) | (or_869 & (or_873 | or_877));
      or_968_s10_q <= (or_888 & or_892) | (or_884 & (or_888 | or_892));
      xor_1098_s10_q <= parity_1046 ^ parity_1097;
      parity_1113_s10_q <= ^{or_1110, or_1106, or_1102};
      parity_1147_s10_q <= parity_1147;
      and_1148_s10_q <= parity_1046 & parity_1097;
      or_1152_s10_q <= or_1152;
      or_1156_s10_q <= (parity_1082 & parity_1094) | and_1155;
      or_1163_s10_q <= or_1163;
      or_1167_s10_q <= or_1167;
      or_1171_s10_q <= or_1171;
      or_1178_s10_q <= or_1178;
      or_1182_s10_q <= or_1182;
      or_1186_s10_q <= or_1186;
      and_1195_s10_q <= parity_1129 & parity_1144;
      or_1196_s10_q <= parity_1129 | parity_1144;
      or_1209_s10_q <= (or_1106 & or_1110) | (or_1102 & (or_1106 | or_1110));
      or_1213_s10_q <= (or_1122 & or_1126) | (or_1118 & (or_1122 | or_1126));
      or_1217_s10_q <= (or_1137 & or_1141) | (or_1133 & (or_1137 | or_1141));
      and_1321_s10_q <= and_1321_s9_q;
      select_1325_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      select_1330_s10_q <= select_1330_s9_q;
      equal_1339_s10_q <= equal_1339_s9_q;
      and_1346_s10_q <= and_1346_s9_q;
      and_1349_s10_q <= and_1349_s9_q;
      and_1353_s10_q <= and_1353_s9_q;
      or_1367_s10_q <= or_1367;
      less_1425_s10_q <= {1'b0, sum_1424, last_s9_q[1]} < x_s9_q;
      equal_1465_s10_q <= x_s9_q == {1'b0, last_s9_q};
      and_1600_s10_q <= and_1597_s9_q & (~({sum_1424, last_s9_q[1:0]} < x_s9_q));
      equal_1743_s10_q <= equal_1743_s9_q;
      equal_1867_s10_q <= equal_1867_s9_q;
      less_2119_s10_q <= less_2119_s9_q;
      and_2202_s10_q <= and_2202_s9_q;
      and_2204_s10_q <= and_2204_s9_q;
      less_2311_s10_q <= less_2311_s9_q;
      equal_2518_s10_q <= equal_2518_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/count_bits.hpp:24
  logic parity_676;
  assign parity_676 = ^{or_673_s10_q, or_669_s10_q, or_665_s10_q};
  logic parity_691;
  assign parity_691 = ^{or_688_s10_q, or_684_s10_q, or_680_s10_q};
  logic parity_694;
  assign parity_694 = ^{or_688_s10_q, or_684_s10_q, or_680_s10_q, or_673_s10_q, or_669_s10_q, or_665_s10_q, or_658_s10_q, or_654_s10_q, and_650_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_696;
  assign and_696 = parity_649_s10_q & parity_694;
  logic or_700;
  assign or_700 = and_697_s10_q | and_699_s10_q;
  logic and_703;
  assign and_703 = (^{or_658_s10_q, or_654_s10_q, and_650_s10_q}) & (parity_676 | parity_691);
  logic or_704;
  assign or_704 = (parity_676 & parity_691) | and_703;
  // hls/stages/count_bits.hpp:24
  logic parity_722;
  assign parity_722 = ^{or_719_s10_q, or_715_s10_q, or_711_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_726;
  assign or_726 = (or_654_s10_q & or_658_s10_q) | (and_650_s10_q & (or_654_s10_q | or_658_s10_q));
  logic or_730;
  assign or_730 = (or_669_s10_q & or_673_s10_q) | (or_665_s10_q & (or_669_s10_q | or_673_s10_q));
  logic or_734;
  assign or_734 = (or_684_s10_q & or_688_s10_q) | (or_680_s10_q & (or_684_s10_q | or_688_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_737;
  assign parity_737 = ^{or_734, or_730, or_726};
  logic parity_740;
  assign parity_740 = ^{or_734, or_730, or_726, or_719_s10_q, or_715_s10_q, or_711_s10_q, or_704, or_700, and_696};
  // hls/stages/count_bits.hpp:25
  logic or_752;
  assign or_752 = (or_715_s10_q & or_719_s10_q) | (or_711_s10_q & (or_715_s10_q | or_719_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_925;
  assign parity_925 = ^{or_922_s10_q, or_918_s10_q, or_914_s10_q};
  logic parity_940;
  assign parity_940 = ^{or_937_s10_q, or_933_s10_q, or_929_s10_q};
  logic parity_943;
  assign parity_943 = ^{or_937_s10_q, or_933_s10_q, or_929_s10_q, or_922_s10_q, or_918_s10_q, or_914_s10_q, or_907_s10_q, or_903_s10_q, and_899_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_945;
  assign and_945 = parity_898_s10_q & parity_943;
  logic or_949;
  assign or_949 = and_946_s10_q | (parity_864_s10_q & or_947_s10_q);
  logic and_952;
  assign and_952 = (^{or_907_s10_q, or_903_s10_q, and_899_s10_q}) & (parity_925 | parity_940);
  logic or_953;
  assign or_953 = (parity_925 & parity_940) | and_952;
  // hls/stages/count_bits.hpp:24
  logic parity_971;
  assign parity_971 = ^{or_968_s10_q, or_964_s10_q, or_960_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_975;
  assign or_975 = (or_903_s10_q & or_907_s10_q) | (and_899_s10_q & (or_903_s10_q | or_907_s10_q));
  logic or_979;
  assign or_979 = (or_918_s10_q & or_922_s10_q) | (or_914_s10_q & (or_918_s10_q | or_922_s10_q));
  logic or_983;
  assign or_983 = (or_933_s10_q & or_937_s10_q) | (or_929_s10_q & (or_933_s10_q | or_937_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_986;
  assign parity_986 = ^{or_983, or_979, or_975};
  logic parity_989;
  assign parity_989 = ^{or_983, or_979, or_975, or_968_s10_q, or_964_s10_q, or_960_s10_q, or_953, or_949, and_945};
  // hls/stages/count_bits.hpp:25
  logic or_1001;
  assign or_1001 = (or_964_s10_q & or_968_s10_q) | (or_960_s10_q & (or_964_s10_q | or_968_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1174;
  assign parity_1174 = ^{or_1171_s10_q, or_1167_s10_q, or_1163_s10_q};
  logic parity_1189;
  assign parity_1189 = ^{or_1186_s10_q, or_1182_s10_q, or_1178_s10_q};
  logic parity_1192;
  assign parity_1192 = ^{or_1186_s10_q, or_1182_s10_q, or_1178_s10_q, or_1171_s10_q, or_1167_s10_q, or_1163_s10_q, or_1156_s10_q, or_1152_s10_q, and_1148_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1194;
  assign and_1194 = parity_1147_s10_q & parity_1192;
  logic or_1198;
  assign or_1198 = and_1195_s10_q | (parity_1113_s10_q & or_1196_s10_q);
  logic and_1201;
  assign and_1201 = (^{or_1156_s10_q, or_1152_s10_q, and_1148_s10_q}) & (parity_1174 | parity_1189);
  logic or_1202;
  assign or_1202 = (parity_1174 & parity_1189) | and_1201;
  // hls/stages/count_bits.hpp:24
  logic parity_1220;
  assign parity_1220 = ^{or_1217_s10_q, or_1213_s10_q, or_1209_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1224;
  assign or_1224 = (or_1152_s10_q & or_1156_s10_q) | (and_1148_s10_q & (or_1152_s10_q | or_1156_s10_q));
  logic or_1228;
  assign or_1228 = (or_1167_s10_q & or_1171_s10_q) | (or_1163_s10_q & (or_1167_s10_q | or_1171_s10_q));
  logic or_1232;
  assign or_1232 = (or_1182_s10_q & or_1186_s10_q) | (or_1178_s10_q & (or_1182_s10_q | or_1186_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1235;
  assign parity_1235 = ^{or_1232, or_1228, or_1224};
  logic parity_1238;
  assign parity_1238 = ^{or_1232, or_1228, or_1224, or_1217_s10_q, or_1213_s10_q, or_1209_s10_q, or_1202, or_1198, and_1194};
  // hls/stages/count_bits.hpp:25
  logic or_1250;
  assign or_1250 = (or_1213_s10_q & or_1217_s10_q) | (or_1209_s10_q & (or_1213_s10_q | or_1217_s10_q));
  // hls/stages/agreement.hpp:141
  logic [6:0] select_1377;
  assign select_1377 = or_391_s10_q ? (less_398_s10_q ? 7'h0 : select_1325_s10_q) : 7'h0;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1297; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_391_s10_q ? select_1325_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_512_s10_q;
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
  logic equal_329_s11_q;
  logic [8:0] select_335_s11_q;
  logic and_344_s11_q;
  logic equal_350_s11_q;
  logic whole_s11_q;
  logic [6:0] column_s11_q;
  logic and_368_s11_q;
  logic and_370_s11_q;
  logic equal_373_s11_q;
  logic so_s11_q;
  logic equal_390_s11_q;
  logic or_391_s11_q;
  logic equal_393_s11_q;
  logic less_398_s11_q;
  logic not_399_s11_q;
  logic equal_431_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic select_519_s11_q;
  logic xor_600_s11_q;
  logic xor_695_s11_q;
  logic parity_740_s11_q;
  logic and_741_s11_q;
  logic and_743_s11_q;
  logic and_745_s11_q;
  logic and_747_s11_q;
  logic or_752_s11_q;
  logic or_756_s11_q;
  logic xor_849_s11_q;
  logic xor_944_s11_q;
  logic parity_989_s11_q;
  logic and_990_s11_q;
  logic and_992_s11_q;
  logic and_994_s11_q;
  logic and_996_s11_q;
  logic or_1001_s11_q;
  logic or_1005_s11_q;
  logic xor_1098_s11_q;
  logic xor_1193_s11_q;
  logic parity_1238_s11_q;
  logic and_1239_s11_q;
  logic and_1241_s11_q;
  logic and_1243_s11_q;
  logic and_1245_s11_q;
  logic or_1250_s11_q;
  logic or_1254_s11_q;
  logic and_1321_s11_q;
  logic [6:0] right_s11_q;
  logic select_1330_s11_q;
  logic equal_1339_s11_q;
  logic and_1346_s11_q;
  logic and_1349_s11_q;
  logic and_1353_s11_q;
  logic or_1367_s11_q;
  logic [6:0] select_1378_s11_q;
  logic less_1425_s11_q;
  logic equal_1465_s11_q;
  logic and_1602_s11_q;
  logic equal_1743_s11_q;
  logic equal_1867_s11_q;
  logic less_2119_s11_q;
  logic and_2202_s11_q;
  logic and_2204_s11_q;
  logic less_2311_s11_q;
  logic equal_2518_s11_q;
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
      equal_329_s11_q <= equal_329_s10_q;
      select_335_s11_q <= select_335_s10_q;
      and_344_s11_q <= and_344_s10_q;
      equal_350_s11_q <= equal_350_s10_q;
      whole_s11_q <= whole_s10_q;
      column_s11_q <= column_s10_q;
      and_368_s11_q <= and_368_s10_q;
      and_370_s11_q <= and_370_s10_q;
      equal_373_s11_q <= equal_373_s10_q;
      so_s11_q <= so_s10_q;
      equal_390_s11_q <= equal_390_s10_q;
      or_391_s11_q <= or_391_s10_q;
      equal_393_s11_q <= equal_393_s10_q;
      less_398_s11_q <= less_398_s10_q;
      not_399_s11_q <= not_399_s10_q;
      equal_431_s11_q <= equal_431_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_519_s11_q <= select_519_s10_q;
      xor_600_s11_q <= xor_600_s10_q;
      xor_695_s11_q <= parity_649_s10_q ^ parity_694;
      parity_740_s11_q <= parity_740;
      and_741_s11_q <= parity_722 & parity_737;
      and_743_s11_q <= (^{or_704, or_700, and_696}) & (parity_722 | parity_737);
      and_745_s11_q <= or_700 & or_704;
      and_747_s11_q <= and_696 & (or_700 | or_704);
      or_752_s11_q <= or_752;
      or_756_s11_q <= (or_730 & or_734) | (or_726 & (or_730 | or_734));
      xor_849_s11_q <= xor_849_s10_q;
      xor_944_s11_q <= parity_898_s10_q ^ parity_943;
      parity_989_s11_q <= parity_989;
      and_990_s11_q <= parity_971 & parity_986;
      and_992_s11_q <= (^{or_953, or_949, and_945}) & (parity_971 | parity_986);
      and_994_s11_q <= or_949 & or_953;
      and_996_s11_q <= and_945 & (or_949 | or_953);
      or_1001_s11_q <= or_1001;
      or_1005_s11_q <= (or_979 & or_983) | (or_975 & (or_979 | or_983));
      xor_1098_s11_q <= xor_1098_s10_q;
      xor_1193_s11_q <= parity_1147_s10_q ^ parity_1192;
      parity_1238_s11_q <= parity_1238;
      and_1239_s11_q <= parity_1220 & parity_1235;
      and_1241_s11_q <= (^{or_1202, or_1198, and_1194}) & (parity_1220 | parity_1235);
      and_1243_s11_q <= or_1198 & or_1202;
      and_1245_s11_q <= and_1194 & (or_1198 | or_1202);
      or_1250_s11_q <= or_1250;
      or_1254_s11_q <= (or_1228 & or_1232) | (or_1224 & (or_1228 | or_1232));
      and_1321_s11_q <= and_1321_s10_q;
      right_s11_q <= right_s10_q;
      select_1330_s11_q <= select_1330_s10_q;
      equal_1339_s11_q <= equal_1339_s10_q;
      and_1346_s11_q <= and_1346_s10_q;
      and_1349_s11_q <= and_1349_s10_q;
      and_1353_s11_q <= and_1353_s10_q;
      or_1367_s11_q <= or_1367_s10_q;
      select_1378_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1377;
      less_1425_s11_q <= less_1425_s10_q;
      equal_1465_s11_q <= equal_1465_s10_q;
      and_1602_s11_q <= so_s10_q & (ends_cell_s10_q & and_1600_s10_q);
      equal_1743_s11_q <= equal_1743_s10_q;
      equal_1867_s11_q <= equal_1867_s10_q;
      less_2119_s11_q <= less_2119_s10_q;
      and_2202_s11_q <= and_2202_s10_q;
      and_2204_s11_q <= and_2204_s10_q;
      less_2311_s11_q <= less_2311_s10_q;
      equal_2518_s11_q <= equal_2518_s10_q;
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
  // hls/stages/count_bits.hpp:25
  logic or_744;
  assign or_744 = and_741_s11_q | and_743_s11_q;
  logic or_748;
  assign or_748 = and_745_s11_q | and_747_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_761;
  assign parity_761 = ^{or_756_s11_q, or_752_s11_q, or_748, or_744};
  // hls/stages/count_bits.hpp:25
  logic or_765;
  assign or_765 = (or_752_s11_q & or_756_s11_q) | (or_748 & (or_752_s11_q | or_756_s11_q));
  logic and_766;
  assign and_766 = or_744 & (^{or_756_s11_q, or_752_s11_q, or_748});
  // hls/stages/count_bits.hpp:24
  logic xor_767;
  assign xor_767 = or_765 ^ and_766;
  // hls/stages/count_bits.hpp:27
  logic and_768;
  assign and_768 = or_765 & and_766;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_769;
  assign select_769 = equal_393_s11_q ? {and_768, xor_767, parity_761, parity_740_s11_q, xor_695_s11_q, xor_600_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_391_s11_q ? 6'h0 : select_769;
  // hls/stages/count_bits.hpp:25
  logic or_993;
  assign or_993 = and_990_s11_q | and_992_s11_q;
  logic or_997;
  assign or_997 = and_994_s11_q | and_996_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1010;
  assign parity_1010 = ^{or_1005_s11_q, or_1001_s11_q, or_997, or_993};
  // hls/stages/count_bits.hpp:25
  logic or_1014;
  assign or_1014 = (or_1001_s11_q & or_1005_s11_q) | (or_997 & (or_1001_s11_q | or_1005_s11_q));
  logic and_1015;
  assign and_1015 = or_993 & (^{or_1005_s11_q, or_1001_s11_q, or_997});
  // hls/stages/count_bits.hpp:24
  logic xor_1016;
  assign xor_1016 = or_1014 ^ and_1015;
  // hls/stages/count_bits.hpp:27
  logic and_1017;
  assign and_1017 = or_1014 & and_1015;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1018;
  assign select_1018 = equal_393_s11_q ? {and_1017, xor_1016, parity_1010, parity_989_s11_q, xor_944_s11_q, xor_849_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_391_s11_q ? 6'h0 : select_1018;
  // hls/stages/count_bits.hpp:25
  logic or_1242;
  assign or_1242 = and_1239_s11_q | and_1241_s11_q;
  logic or_1246;
  assign or_1246 = and_1243_s11_q | and_1245_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1259;
  assign parity_1259 = ^{or_1254_s11_q, or_1250_s11_q, or_1246, or_1242};
  // hls/stages/count_bits.hpp:25
  logic or_1263;
  assign or_1263 = (or_1250_s11_q & or_1254_s11_q) | (or_1246 & (or_1250_s11_q | or_1254_s11_q));
  logic and_1264;
  assign and_1264 = or_1242 & (^{or_1254_s11_q, or_1250_s11_q, or_1246});
  // hls/stages/count_bits.hpp:24
  logic xor_1265;
  assign xor_1265 = or_1263 ^ and_1264;
  // hls/stages/count_bits.hpp:27
  logic and_1266;
  assign and_1266 = or_1263 & and_1264;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1267;
  assign select_1267 = equal_393_s11_q ? {and_1266, xor_1265, parity_1259, parity_1238_s11_q, xor_1193_s11_q, xor_1098_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_391_s11_q ? 6'h0 : select_1267;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1307;
  assign sum_1307 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1310;
  assign sum_1310 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};

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
  logic equal_329_s12_q;
  logic [8:0] select_335_s12_q;
  logic and_344_s12_q;
  logic equal_350_s12_q;
  logic whole_s12_q;
  logic [6:0] column_s12_q;
  logic and_368_s12_q;
  logic and_370_s12_q;
  logic equal_373_s12_q;
  logic so_s12_q;
  logic equal_390_s12_q;
  logic or_391_s12_q;
  logic less_398_s12_q;
  logic not_399_s12_q;
  logic equal_431_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic select_519_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1020_s12_q;
  logic [5:0] select_1269_s12_q;
  logic [6:0] sum_1308_s12_q;
  logic [6:0] sum_1311_s12_q;
  logic and_1321_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic select_1330_s12_q;
  logic equal_1339_s12_q;
  logic and_1346_s12_q;
  logic and_1349_s12_q;
  logic and_1353_s12_q;
  logic or_1367_s12_q;
  logic [6:0] select_1378_s12_q;
  logic less_1425_s12_q;
  logic equal_1465_s12_q;
  logic and_1602_s12_q;
  logic equal_1743_s12_q;
  logic equal_1867_s12_q;
  logic less_2119_s12_q;
  logic and_2202_s12_q;
  logic and_2204_s12_q;
  logic less_2311_s12_q;
  logic equal_2518_s12_q;
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
      equal_329_s12_q <= equal_329_s11_q;
      select_335_s12_q <= select_335_s11_q;
      and_344_s12_q <= and_344_s11_q;
      equal_350_s12_q <= equal_350_s11_q;
      whole_s12_q <= whole_s11_q;
      column_s12_q <= column_s11_q;
      and_368_s12_q <= and_368_s11_q;
      and_370_s12_q <= and_370_s11_q;
      equal_373_s12_q <= equal_373_s11_q;
      so_s12_q <= so_s11_q;
      equal_390_s12_q <= equal_390_s11_q;
      or_391_s12_q <= or_391_s11_q;
      less_398_s12_q <= less_398_s11_q;
      not_399_s12_q <= not_399_s11_q;
      equal_431_s12_q <= equal_431_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_519_s12_q <= select_519_s11_q;
      column_2_s12_q <= column_2;
      select_1020_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1269_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1308_s12_q <= {1'b0, before_v_2} + sum_1307;
      sum_1311_s12_q <= {1'b0, before_v_3} + sum_1310;
      and_1321_s12_q <= and_1321_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      select_1330_s12_q <= select_1330_s11_q;
      equal_1339_s12_q <= equal_1339_s11_q;
      and_1346_s12_q <= and_1346_s11_q;
      and_1349_s12_q <= and_1349_s11_q;
      and_1353_s12_q <= and_1353_s11_q;
      or_1367_s12_q <= or_1367_s11_q;
      select_1378_s12_q <= select_1378_s11_q;
      less_1425_s12_q <= less_1425_s11_q;
      equal_1465_s12_q <= equal_1465_s11_q;
      and_1602_s12_q <= and_1602_s11_q;
      equal_1743_s12_q <= equal_1743_s11_q;
      equal_1867_s12_q <= equal_1867_s11_q;
      less_2119_s12_q <= less_2119_s11_q;
      and_2202_s12_q <= and_2202_s11_q;
      and_2204_s12_q <= and_2204_s11_q;
      less_2311_s12_q <= less_2311_s11_q;
      equal_2518_s12_q <= equal_2518_s11_q;
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
  // hls/stages/agreement.hpp:762
  logic [5:0] select_771;
  assign select_771 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1303;
  assign sum_1303 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1313;
  assign select_1313 = (sum_1308_s12_q < sum_1311_s12_q) ? sum_1311_s12_q : sum_1308_s12_q;
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_1967;
  assign select_1967 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_1968;
  assign select_1968 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1969;
  assign select_1969 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_1970;
  assign select_1970 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1971;
  assign select_1971 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1972;
  assign select_1972 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;

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
      middle_sum_columns_values_1_q <= select_1967;
      middle_sum_columns_values_2_q <= select_1968;
      middle_sum_columns_values_3_q <= select_1969;
      middle_sum_columns_values_4_q <= select_1970;
      middle_sum_columns_values_5_q <= select_1971;
      middle_sum_columns_values_6_q <= select_1972;
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
  logic equal_329_s13_q;
  logic [8:0] select_335_s13_q;
  logic and_344_s13_q;
  logic equal_350_s13_q;
  logic whole_s13_q;
  logic [6:0] column_s13_q;
  logic and_368_s13_q;
  logic and_370_s13_q;
  logic equal_373_s13_q;
  logic so_s13_q;
  logic equal_390_s13_q;
  logic or_391_s13_q;
  logic less_398_s13_q;
  logic not_399_s13_q;
  logic equal_431_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_519_s13_q;
  logic [6:0] difference_772_s13_q;
  logic [6:0] difference_1021_s13_q;
  logic equal_1022_s13_q;
  logic [6:0] difference_1270_s13_q;
  logic [6:0] sum_1304_s13_q;
  logic [6:0] select_1313_s13_q;
  logic and_1321_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1330_s13_q;
  logic equal_1339_s13_q;
  logic and_1346_s13_q;
  logic and_1349_s13_q;
  logic and_1353_s13_q;
  logic less_1354_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1367_s13_q;
  logic [6:0] select_1378_s13_q;
  logic less_1425_s13_q;
  logic equal_1465_s13_q;
  logic and_1602_s13_q;
  logic equal_1743_s13_q;
  logic equal_1867_s13_q;
  logic less_2119_s13_q;
  logic and_2202_s13_q;
  logic and_2204_s13_q;
  logic less_2311_s13_q;
  logic equal_2518_s13_q;
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
      equal_329_s13_q <= equal_329_s12_q;
      select_335_s13_q <= select_335_s12_q;
      and_344_s13_q <= and_344_s12_q;
      equal_350_s13_q <= equal_350_s12_q;
      whole_s13_q <= whole_s12_q;
      column_s13_q <= column_s12_q;
      and_368_s13_q <= and_368_s12_q;
      and_370_s13_q <= and_370_s12_q;
      equal_373_s13_q <= equal_373_s12_q;
      so_s13_q <= so_s12_q;
      equal_390_s13_q <= equal_390_s12_q;
      or_391_s13_q <= or_391_s12_q;
      less_398_s13_q <= less_398_s12_q;
      not_399_s13_q <= not_399_s12_q;
      equal_431_s13_q <= equal_431_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_519_s13_q <= select_519_s12_q;
      difference_772_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_771};
      difference_1021_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1020_s12_q};
      equal_1022_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1270_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1269_s12_q};
      sum_1304_s13_q <= {1'b0, before_v} + sum_1303;
      select_1313_s13_q <= select_1313;
      and_1321_s13_q <= and_1321_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1330_s13_q <= select_1330_s12_q;
      equal_1339_s13_q <= equal_1339_s12_q;
      and_1346_s13_q <= and_1346_s12_q;
      and_1349_s13_q <= and_1349_s12_q;
      and_1353_s13_q <= and_1353_s12_q;
      less_1354_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1367_s13_q <= or_1367_s12_q;
      select_1378_s13_q <= select_1378_s12_q;
      less_1425_s13_q <= less_1425_s12_q;
      equal_1465_s13_q <= equal_1465_s12_q;
      and_1602_s13_q <= and_1602_s12_q;
      equal_1743_s13_q <= equal_1743_s12_q;
      equal_1867_s13_q <= equal_1867_s12_q;
      less_2119_s13_q <= less_2119_s12_q;
      and_2202_s13_q <= and_2202_s12_q;
      and_2204_s13_q <= and_2204_s12_q;
      less_2311_s13_q <= less_2311_s12_q;
      equal_2518_s13_q <= equal_2518_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [6:0] chosen_near_q;
  // hls/stages/agreement.hpp:772
  logic less_520;
  assign less_520 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_522;
  assign less_522 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:231
  logic and_524;
  assign and_524 = (~less_520) & (~less_522);
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_774;
  assign sum_774 = {difference_772_s13_q[6], difference_772_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1024;
  assign sum_1024 = {difference_1021_s13_q[6], difference_1021_s13_q} + (equal_1022_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1272;
  assign sum_1272 = {difference_1270_s13_q[6], difference_1270_s13_q} + (equal_1022_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1305;
  assign select_1305 = slot_s13_q[0] ? chosen_near_q : sum_1304_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1315;
  assign select_1315 = (select_1305 < select_1313_s13_q) ? select_1313_s13_q : select_1305;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_524 ? select_1315 : 7'h0;
  // hls/stages/agreement.hpp:935
  logic select_1356;
  assign select_1356 = slot_s13_q[2] ? less_1354_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1359;
  assign difference_1359 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/agreement.hpp:227
  logic [6:0] select_1978;
  assign select_1978 = slot_s13_q[0] ? 7'h0 : sum_1304_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1980;
  assign select_1980 = (select_1978 < select_1313_s13_q) ? select_1313_s13_q : select_1978;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_near_q <= 7'h0;
    end else if (s13_en) begin
      chosen_near_q <= select_1980;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_774;
      sums_0_sum_sums_values_0_q <= sum_1024;
      sums_0_sum_sums_values_1_q <= equal_1022_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1272;
      sums_1_sum_sums_values_1_q <= equal_1022_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic equal_329_s14_q;
  logic [8:0] select_335_s14_q;
  logic and_344_s14_q;
  logic equal_350_s14_q;
  logic whole_s14_q;
  logic [6:0] column_s14_q;
  logic and_368_s14_q;
  logic and_370_s14_q;
  logic equal_373_s14_q;
  logic so_s14_q;
  logic equal_390_s14_q;
  logic or_391_s14_q;
  logic less_398_s14_q;
  logic not_399_s14_q;
  logic equal_431_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_519_s14_q;
  logic and_524_s14_q;
  logic [7:0] sum_774_s14_q;
  logic less_1273_s14_q;
  logic [6:0] of_near_s14_q;
  logic and_1321_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1330_s14_q;
  logic equal_1339_s14_q;
  logic and_1346_s14_q;
  logic and_1349_s14_q;
  logic and_1353_s14_q;
  logic select_1356_s14_q;
  logic [9:0] sum_1360_s14_q;
  logic or_1367_s14_q;
  logic [6:0] select_1378_s14_q;
  logic less_1425_s14_q;
  logic equal_1465_s14_q;
  logic and_1602_s14_q;
  logic equal_1743_s14_q;
  logic equal_1867_s14_q;
  logic less_2119_s14_q;
  logic and_2202_s14_q;
  logic and_2204_s14_q;
  logic and_2211_s14_q;
  logic less_2311_s14_q;
  logic equal_2518_s14_q;
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
      equal_329_s14_q <= equal_329_s13_q;
      select_335_s14_q <= select_335_s13_q;
      and_344_s14_q <= and_344_s13_q;
      equal_350_s14_q <= equal_350_s13_q;
      whole_s14_q <= whole_s13_q;
      column_s14_q <= column_s13_q;
      and_368_s14_q <= and_368_s13_q;
      and_370_s14_q <= and_370_s13_q;
      equal_373_s14_q <= equal_373_s13_q;
      so_s14_q <= so_s13_q;
      equal_390_s14_q <= equal_390_s13_q;
      or_391_s14_q <= or_391_s13_q;
      less_398_s14_q <= less_398_s13_q;
      not_399_s14_q <= not_399_s13_q;
      equal_431_s14_q <= equal_431_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_519_s14_q <= select_519_s13_q;
      and_524_s14_q <= and_524;
      sum_774_s14_q <= sum_774;
      less_1273_s14_q <= sum_1024 < sum_1272;
      of_near_s14_q <= of_near;
      and_1321_s14_q <= and_1321_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1330_s14_q <= select_1330_s13_q;
      equal_1339_s14_q <= equal_1339_s13_q;
      and_1346_s14_q <= and_1346_s13_q;
      and_1349_s14_q <= and_1349_s13_q;
      and_1353_s14_q <= and_1353_s13_q;
      select_1356_s14_q <= select_1356;
      sum_1360_s14_q <= {difference_1359[8], difference_1359} + 10'h1;
      or_1367_s14_q <= or_1367_s13_q;
      select_1378_s14_q <= select_1378_s13_q;
      less_1425_s14_q <= less_1425_s13_q;
      equal_1465_s14_q <= equal_1465_s13_q;
      and_1602_s14_q <= and_1602_s13_q;
      equal_1743_s14_q <= equal_1743_s13_q;
      equal_1867_s14_q <= equal_1867_s13_q;
      less_2119_s14_q <= less_2119_s13_q;
      and_2202_s14_q <= and_2202_s13_q;
      and_2204_s14_q <= and_2204_s13_q;
      and_2211_s14_q <= ends_cell_s13_q & so_s13_q;
      less_2311_s14_q <= less_2311_s13_q;
      equal_2518_s14_q <= equal_2518_s13_q;
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
  // hls/stages/agreement.hpp:739
  logic [7:0] select_775;
  assign select_775 = slot_s14_q[0] ? chosen_score_q : sum_774_s14_q;
  // hls/stages/agreement.hpp:735
  logic [7:0] select_1274;
  assign select_1274 = less_1273_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1275;
  assign less_1275 = select_775 < select_1274;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_524_s14_q ? (less_1275 ? select_1274 : select_775) : 8'h0;
  // hls/stages/agreement.hpp:704
  logic not_1281;
  assign not_1281 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1282;
  assign select_1282 = less_1273_s14_q ? {slot_s14_q[0], not_1281} : 2'h0;
  logic [2:0] select_1284;
  assign select_1284 = less_1275 ? {select_1282, not_1281} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1293;
  assign select_1293 = slot_s14_q[0] ? 8'h0 : sum_774_s14_q;
  // hls/stages/agreement.hpp:788
  logic or_1318;
  assign or_1318 = select_519_s14_q | (best_left_rdata_s14_q[39:33] < of_near_s14_q);
  // hls/stages/agreement.hpp:801
  logic or_1336;
  assign or_1336 = select_1330_s14_q | (best_right_rdata_s14_q[21:15] < of_near_s14_q);
  // hls/stages/agreement.hpp:235
  logic and_1362;
  assign and_1362 = (and_1349_s14_q & select_1356_s14_q) & ({{22{sum_1360_s14_q[9]}}, sum_1360_s14_q} < 32'h3);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1463;
  assign sum_1463 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:735
  logic less_1976;
  assign less_1976 = select_1293 < select_1274;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2071;
  assign select_2071 = or_391_s14_q ? (less_398_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2073;
  assign select_2073 = or_391_s14_q ? (less_398_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_2093;
  assign select_2093 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/registration.hpp:129
  logic [15:0] select_2205;
  assign select_2205 = and_2204_s14_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2207;
  assign select_2207 = and_2202_s14_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2205[15]}}, select_2205});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2208;
  assign select_2208 = and_2204_s14_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2208[15]}}, select_2208};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2210;
  assign select_2210 = and_2202_s14_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2211_s14_q ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:197
  logic [8:0] select_2323;
  assign select_2323 = so_s14_q ? (and_2211_s14_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2325;
  assign sum_2325 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2326;
  assign select_2326 = sum_1463[5] ? {1'b1, sum_1463[4:0], region_across_rest_q[2:0]} : sum_2325;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_2328;
  assign select_2328 = equal_1867_s14_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_2331;
  assign select_2331 = equal_1867_s14_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

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
      chosen_score_q <= less_1976 ? select_1274 : select_1293;
      chosen_place_q <= less_1976 ? {select_1282, not_1281} : 3'h2;
      before_0_q <= select_1293;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      registration_slope_row_q <= select_2207;
      registration_slope_change_q <= select_2210;
      registration_slope_q <= so_s14_q ? column_5 : {registration_slope_row_q, 4'h0};
      region_across_rest_q <= select_2323;
      region_across_back_q <= so_s14_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2326;
      columns_begin_rest_q <= and_370_s14_q ? select_2328 : columns_begin_rest_q;
      columns_begin_back_q <= and_370_s14_q ? select_2331 : columns_begin_back_q;
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
  logic equal_329_s15_q;
  logic [8:0] select_335_s15_q;
  logic and_344_s15_q;
  logic equal_350_s15_q;
  logic whole_s15_q;
  logic [6:0] column_s15_q;
  logic and_368_s15_q;
  logic and_370_s15_q;
  logic equal_373_s15_q;
  logic so_s15_q;
  logic equal_390_s15_q;
  logic or_391_s15_q;
  logic less_398_s15_q;
  logic not_399_s15_q;
  logic equal_431_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_519_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1284_s15_q;
  logic [6:0] of_near_s15_q;
  logic or_1318_s15_q;
  logic and_1321_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1330_s15_q;
  logic or_1336_s15_q;
  logic equal_1339_s15_q;
  logic and_1346_s15_q;
  logic and_1350_s15_q;
  logic and_1353_s15_q;
  logic and_1363_s15_q;
  logic and_1368_s15_q;
  logic [6:0] select_1378_s15_q;
  logic less_1425_s15_q;
  logic sum_1463_s15_q;
  logic equal_1465_s15_q;
  logic and_1602_s15_q;
  logic equal_1743_s15_q;
  logic equal_1867_s15_q;
  logic [7:0] select_2071_s15_q;
  logic [7:0] select_2073_s15_q;
  logic [16:0] select_2093_s15_q;
  logic less_2119_s15_q;
  logic less_2311_s15_q;
  logic equal_2518_s15_q;
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
      equal_329_s15_q <= equal_329_s14_q;
      select_335_s15_q <= select_335_s14_q;
      and_344_s15_q <= and_344_s14_q;
      equal_350_s15_q <= equal_350_s14_q;
      whole_s15_q <= whole_s14_q;
      column_s15_q <= column_s14_q;
      and_368_s15_q <= and_368_s14_q;
      and_370_s15_q <= and_370_s14_q;
      equal_373_s15_q <= equal_373_s14_q;
      so_s15_q <= so_s14_q;
      equal_390_s15_q <= equal_390_s14_q;
      or_391_s15_q <= or_391_s14_q;
      less_398_s15_q <= less_398_s14_q;
      not_399_s15_q <= not_399_s14_q;
      equal_431_s15_q <= equal_431_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_519_s15_q <= select_519_s14_q;
      of_best_s15_q <= of_best;
      select_1284_s15_q <= select_1284;
      of_near_s15_q <= of_near_s14_q;
      or_1318_s15_q <= or_1318;
      and_1321_s15_q <= and_1321_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1330_s15_q <= select_1330_s14_q;
      or_1336_s15_q <= or_1336;
      equal_1339_s15_q <= equal_1339_s14_q;
      and_1346_s15_q <= and_1346_s14_q;
      and_1350_s15_q <= not_399_s14_q & and_1349_s14_q;
      and_1353_s15_q <= and_1353_s14_q;
      and_1363_s15_q <= not_399_s14_q & and_1362;
      and_1368_s15_q <= and_1362 & or_1367_s14_q;
      select_1378_s15_q <= select_1378_s14_q;
      less_1425_s15_q <= less_1425_s14_q;
      sum_1463_s15_q <= sum_1463[5];
      equal_1465_s15_q <= equal_1465_s14_q;
      and_1602_s15_q <= and_1602_s14_q;
      equal_1743_s15_q <= equal_1743_s14_q;
      equal_1867_s15_q <= equal_1867_s14_q;
      select_2071_s15_q <= select_2071;
      select_2073_s15_q <= select_2073;
      select_2093_s15_q <= select_2093;
      less_2119_s15_q <= less_2119_s14_q;
      less_2311_s15_q <= less_2311_s14_q;
      equal_2518_s15_q <= equal_2518_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:785
  logic equal_1287;
  assign equal_1287 = select_1284_s15_q == 3'h1;
  logic equal_1288;
  assign equal_1288 = select_1284_s15_q == 3'h2;
  logic not_1289;
  assign not_1289 = ~equal_1288;
  logic [2:0] select_1290;
  assign select_1290 = equal_1287 ? 3'h2 : {not_1289, {2{equal_1288}}};
  logic [7:0] select_1295;
  assign select_1295 = select_1290[1] ? (select_1290[0] ? before_1_s15_q : before_1_q) : (select_1290[0] ? before_1_q : before_0_q);
  logic [7:0] select_1296;
  assign select_1296 = select_1290[2] ? (select_1290[0] ? before_2_s15_q : before_0_s15_q) : select_1295;
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1298;
  assign select_1298 = equal_1287 ? 2'h0 : {not_1289, equal_1288};
  logic [7:0] select_1300;
  assign select_1300 = select_1298[1] ? before_2_q : (select_1298[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:797
  logic or_1332;
  assign or_1332 = select_1330_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:235
  logic and_1369;
  assign and_1369 = not_399_s15_q & and_1368_s15_q;
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1370;
  assign select_1370 = less_398_s15_q ? 9'h0 : best_left_rdata_s15_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_391_s15_q ? {select_1370, and_1369, and_1363_s15_q, and_1353_s15_q, and_1350_s15_q, and_1346_s15_q, not_399_s15_q} : 15'h0;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = inside_v[0] & less_1425_s15_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2069;
  assign select_2069 = or_391_s15_q ? (less_398_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2071_s15_q} - {1'b0, select_2073_s15_q};
  // hls/stages/registration.hpp:218
  logic [13:0] select_2095;
  assign select_2095 = ($signed(10'h0) < $signed(select_2093_s15_q[16:7])) ? 14'h7f : select_2093_s15_q[13:0];

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
  logic equal_329_s16_q;
  logic [8:0] select_335_s16_q;
  logic and_344_s16_q;
  logic equal_350_s16_q;
  logic whole_s16_q;
  logic [6:0] column_s16_q;
  logic and_368_s16_q;
  logic and_370_s16_q;
  logic equal_373_s16_q;
  logic so_s16_q;
  logic equal_431_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1279_s16_q;
  logic [2:0] select_1284_s16_q;
  logic [7:0] select_1296_s16_q;
  logic [7:0] select_1300_s16_q;
  logic [6:0] select_1319_s16_q;
  logic [5:0] select_1320_s16_q;
  logic and_1321_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1332_s16_q;
  logic [6:0] select_1337_s16_q;
  logic [6:0] select_1338_s16_q;
  logic equal_1339_s16_q;
  logic [13:0] inside_v_s16_q;
  logic [6:0] select_1378_s16_q;
  logic and_1381_s16_q;
  logic right_2_s16_q;
  logic sum_1463_s16_q;
  logic equal_1465_s16_q;
  logic textured_s16_q;
  logic and_1602_s16_q;
  logic equal_1743_s16_q;
  logic equal_1867_s16_q;
  logic [7:0] select_2069_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2075_s16_q;
  logic [7:0] xor_2080_s16_q;
  logic [13:0] select_2095_s16_q;
  logic and_2120_s16_q;
  logic less_2125_s16_q;
  logic less_2311_s16_q;
  logic equal_2518_s16_q;
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
      equal_329_s16_q <= equal_329_s15_q;
      select_335_s16_q <= select_335_s15_q;
      and_344_s16_q <= and_344_s15_q;
      equal_350_s16_q <= equal_350_s15_q;
      whole_s16_q <= whole_s15_q;
      column_s16_q <= column_s15_q;
      and_368_s16_q <= and_368_s15_q;
      and_370_s16_q <= and_370_s15_q;
      equal_373_s16_q <= equal_373_s15_q;
      so_s16_q <= so_s15_q;
      equal_431_s16_q <= equal_431_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1279_s16_q <= select_519_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1284_s16_q <= select_1284_s15_q;
      select_1296_s16_q <= select_1296;
      select_1300_s16_q <= select_1300;
      select_1319_s16_q <= or_1318_s15_q ? of_near_s15_q : best_left_rdata_s15_q[39:33];
      select_1320_s16_q <= or_1318_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      and_1321_s16_q <= and_1321_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1332_s16_q <= or_1332;
      select_1337_s16_q <= or_1336_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1338_s16_q <= or_1336_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1339_s16_q <= equal_1339_s15_q;
      inside_v_s16_q <= {inside_v[14:3], inside_v[1:0]};
      select_1378_s16_q <= select_1378_s15_q;
      and_1381_s16_q <= equal_390_s15_q & inside_v[4];
      right_2_s16_q <= right_2;
      sum_1463_s16_q <= sum_1463_s15_q;
      equal_1465_s16_q <= equal_1465_s15_q;
      textured_s16_q <= textured;
      and_1602_s16_q <= and_1602_s15_q;
      equal_1743_s16_q <= equal_1743_s15_q;
      equal_1867_s16_q <= equal_1867_s15_q;
      select_2069_s16_q <= select_2069;
      rise_s16_q <= rise[8];
      select_2075_s16_q <= rise[8] ? select_2071_s15_q : select_2073_s15_q;
      xor_2080_s16_q <= rise[7:0] ^ {8{rise[8]}};
      select_2095_s16_q <= select_2095;
      and_2120_s16_q <= inside_v[4] & less_2119_s15_q;
      less_2125_s16_q <= select_2071_s15_q < select_2073_s15_q;
      less_2311_s16_q <= less_2311_s15_q;
      equal_2518_s16_q <= equal_2518_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:119
  logic and_345;
  assign and_345 = sample_pair_whole_s16_q & and_344_s16_q;
  // hls/stages/agreement.hpp:955
  logic not_1340;
  assign not_1340 = ~equal_1339_s16_q;
  // hls/stages/agreement.hpp:402
  logic and_1372;
  assign and_1372 = ends_cell_s16_q & inside_v_s16_q[0];
  logic and_1374;
  assign and_1374 = not_1340 & (so_s16_q & and_1372);
  // hls/stages/agreement.hpp:1000
  logic or_1466;
  assign or_1466 = (~sum_1463_s16_q) | equal_1465_s16_q;
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2076;
  assign difference_2076 = {1'b0, select_2069_s16_q} - {1'b0, select_2075_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2076[8] ? 8'h0 : difference_2076[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2080_s16_q};
  // hls/stages/registration.hpp:213
  logic [9:0] select_2096;
  assign select_2096 = inside_v_s16_q[9] ? select_2095_s16_q[9:0] : 10'h0;
  logic [8:0] difference_2098;
  assign difference_2098 = select_2096[9:1] - (inside_v_s16_q[10] ? select_2095_s16_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:211
  logic [12:0] sum_2101;
  assign sum_2101 = (inside_v_s16_q[5] ? select_2095_s16_q[13:1] : 13'h0) + (inside_v_s16_q[6] ? select_2095_s16_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_2102;
  assign select_2102 = inside_v_s16_q[7] ? select_2095_s16_q[11:0] : 12'h0;
  logic [10:0] sum_2104;
  assign sum_2104 = select_2102[11:1] + (inside_v_s16_q[8] ? select_2095_s16_q[10:0] : 11'h0);

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_335_s16_q;
  logic averager_memory_re;
  assign averager_memory_re = s16_en & and_345;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1298; read in stage 16, written in stage 17: 16 < 17 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s16_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s16_en & and_1374;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1325; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s16_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s16_en & and_1374;
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
  logic equal_329_s17_q;
  logic [8:0] select_335_s17_q;
  logic and_344_s17_q;
  logic and_345_s17_q;
  logic equal_350_s17_q;
  logic whole_s17_q;
  logic [6:0] column_s17_q;
  logic and_368_s17_q;
  logic and_370_s17_q;
  logic equal_373_s17_q;
  logic so_s17_q;
  logic equal_431_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1280_s17_q;
  logic [2:0] select_1285_s17_q;
  logic [7:0] select_1286_s17_q;
  logic [7:0] select_1297_s17_q;
  logic [7:0] select_1301_s17_q;
  logic [6:0] select_1319_s17_q;
  logic [5:0] select_1320_s17_q;
  logic and_1321_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1333_s17_q;
  logic [6:0] select_1334_s17_q;
  logic [6:0] select_1337_s17_q;
  logic [6:0] select_1338_s17_q;
  logic equal_1339_s17_q;
  logic not_1340_s17_q;
  logic [13:0] inside_v_s17_q;
  logic and_1374_s17_q;
  logic [6:0] select_1378_s17_q;
  logic and_1383_s17_q;
  logic right_2_s17_q;
  logic sum_1463_s17_q;
  logic and_1469_s17_q;
  logic textured_s17_q;
  logic and_1603_s17_q;
  logic equal_1743_s17_q;
  logic equal_1867_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] size_3_s17_q;
  logic select_2096_s17_q;
  logic [8:0] difference_2098_s17_q;
  logic [11:0] sum_2101_s17_q;
  logic select_2102_s17_q;
  logic [10:0] sum_2104_s17_q;
  logic and_2120_s17_q;
  logic less_2125_s17_q;
  logic less_2311_s17_q;
  logic select_2354_s17_q;
  logic equal_2518_s17_q;
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
      equal_329_s17_q <= equal_329_s16_q;
      select_335_s17_q <= select_335_s16_q;
      and_344_s17_q <= and_344_s16_q;
      and_345_s17_q <= and_345;
      equal_350_s17_q <= equal_350_s16_q;
      whole_s17_q <= whole_s16_q;
      column_s17_q <= column_s16_q;
      and_368_s17_q <= and_368_s16_q;
      and_370_s17_q <= and_370_s16_q;
      equal_373_s17_q <= equal_373_s16_q;
      so_s17_q <= so_s16_q;
      equal_431_s17_q <= equal_431_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1280_s17_q <= or_1279_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1285_s17_q <= or_1279_s16_q ? select_1284_s16_q : best_left_rdata_s16_q[8:6];
      select_1286_s17_q <= or_1279_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1297_s17_q <= or_1279_s16_q ? select_1296_s16_q : best_left_rdata_s16_q[24:17];
      select_1301_s17_q <= or_1279_s16_q ? select_1300_s16_q : best_left_rdata_s16_q[32:25];
      select_1319_s17_q <= select_1319_s16_q;
      select_1320_s17_q <= select_1320_s16_q;
      and_1321_s17_q <= and_1321_s16_q;
      right_s17_q <= right_s16_q;
      select_1333_s17_q <= or_1332_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1334_s17_q <= or_1332_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1337_s17_q <= select_1337_s16_q;
      select_1338_s17_q <= select_1338_s16_q;
      equal_1339_s17_q <= equal_1339_s16_q;
      not_1340_s17_q <= not_1340;
      inside_v_s17_q <= inside_v_s16_q;
      and_1374_s17_q <= and_1374;
      select_1378_s17_q <= select_1378_s16_q;
      and_1383_s17_q <= not_1340 & (so_s16_q ? and_1372 : and_1381_s16_q);
      right_2_s17_q <= right_2_s16_q;
      sum_1463_s17_q <= sum_1463_s16_q;
      and_1469_s17_q <= so_s16_q & (ends_cell_s16_q & (inside_v_s16_q[0] & or_1466));
      textured_s17_q <= textured_s16_q;
      and_1603_s17_q <= not_1340 & and_1602_s16_q;
      equal_1743_s17_q <= equal_1743_s16_q;
      equal_1867_s17_q <= equal_1867_s16_q;
      wide_s17_q <= wide;
      size_3_s17_q <= size_3;
      select_2096_s17_q <= select_2096[0];
      difference_2098_s17_q <= difference_2098;
      sum_2101_s17_q <= sum_2101[12:1];
      select_2102_s17_q <= select_2102[0];
      sum_2104_s17_q <= sum_2104;
      and_2120_s17_q <= and_2120_s16_q;
      less_2125_s17_q <= less_2125_s16_q;
      less_2311_s17_q <= less_2311_s16_q;
      select_2354_s17_q <= sum_1463_s16_q ? (equal_1465_s16_q & or_1466) : or_1466;
      equal_2518_s17_q <= equal_2518_s16_q;
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
  logic [13:0] select_348;
  assign select_348 = equal_329_s17_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_354;
  assign sum_354 = {6'h0, sample_pair_pixel_1_q} + (equal_329_s17_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = equal_329_s17_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/agreement.hpp:193
  logic not_1379;
  assign not_1379 = ~so_s17_q;
  // hls/stages/agreement.hpp:402
  logic and_1380;
  assign and_1380 = not_1379 & inside_v_s17_q[4];
  // hls/stages/agreement.hpp:263
  logic select_1656;
  assign select_1656 = sample_pair_whole_s17_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2083;
  assign select_2083 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2083;
  // hls/stages/registration.hpp:214
  logic [11:0] sum_2105;
  assign sum_2105 = sum_2101_s17_q + {sum_2104_s17_q, select_2102_s17_q};
  logic [9:0] sum_2106;
  assign sum_2106 = {difference_2098_s17_q, select_2096_s17_q} + sum_2105[11:2];
  // hls/stages/agreement.hpp:197
  logic or_2352;
  assign or_2352 = segment_starts_q | not_1379;
  // hls/stages/agreement.hpp:402
  logic select_2356;
  assign select_2356 = ends_cell_s17_q ? (inside_v_s17_q[0] ? select_2354_s17_q : or_2352) : or_2352;

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1321_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1320_s17_q, select_1319_s17_q, select_1301_s17_q, select_1297_s17_q, select_1286_s17_q, select_1285_s17_q, select_1280_s17_q};
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
  assign best_right_we = s17_en & and_1321_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1338_s17_q, select_1337_s17_q, select_1334_s17_q, select_1333_s17_q};
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
  assign shown_right_waddr = select_1378_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1383_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1380, not_1379};
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
      averager_running_of_skin_q <= select_1656;
      segment_starts_q <= equal_1339_s17_q ? or_2352 : (so_s17_q ? select_2356 : or_2352);
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
      averager_running_0_q <= sample_pair_whole_s17_q ? select_348 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s17_q ? sum_354 : averager_running_1_q;
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
  logic [8:0] select_335_s18_q;
  logic and_344_s18_q;
  logic and_345_s18_q;
  logic [29:0] averager_memory_rdata_s18_q;
  logic [13:0] select_348_s18_q;
  logic equal_350_s18_q;
  logic [13:0] sum_354_s18_q;
  logic whole_s18_q;
  logic all_of_skin_s18_q;
  logic [6:0] column_s18_q;
  logic and_368_s18_q;
  logic and_370_s18_q;
  logic equal_373_s18_q;
  logic so_s18_q;
  logic equal_431_s18_q;
  logic equal_1339_s18_q;
  logic not_1340_s18_q;
  logic [13:0] inside_v_s18_q;
  logic and_1374_s18_q;
  logic [1:0] shown_right_rdata_s18_q;
  logic right_2_s18_q;
  logic sum_1463_s18_q;
  logic and_1469_s18_q;
  logic textured_s18_q;
  logic [17:0] seen_columns_rdata_s18_q;
  logic and_1603_s18_q;
  logic equal_1743_s18_q;
  logic equal_1867_s18_q;
  logic less_2067_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2085_s18_q;
  logic [7:0] sum_2106_s18_q;
  logic and_2120_s18_q;
  logic less_2125_s18_q;
  logic less_2311_s18_q;
  logic equal_2518_s18_q;
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
      select_335_s18_q <= select_335_s17_q;
      and_344_s18_q <= and_344_s17_q;
      and_345_s18_q <= and_345_s17_q;
      averager_memory_rdata_s18_q <= averager_memory_rdata_q;
      select_348_s18_q <= select_348;
      equal_350_s18_q <= equal_350_s17_q;
      sum_354_s18_q <= sum_354;
      whole_s18_q <= whole_s17_q;
      all_of_skin_s18_q <= all_of_skin;
      column_s18_q <= column_s17_q;
      and_368_s18_q <= and_368_s17_q;
      and_370_s18_q <= and_370_s17_q;
      equal_373_s18_q <= equal_373_s17_q;
      so_s18_q <= so_s17_q;
      equal_431_s18_q <= equal_431_s17_q;
      equal_1339_s18_q <= equal_1339_s17_q;
      not_1340_s18_q <= not_1340_s17_q;
      inside_v_s18_q <= inside_v_s17_q;
      and_1374_s18_q <= and_1374_s17_q;
      shown_right_rdata_s18_q <= shown_right_rdata_q;
      right_2_s18_q <= right_2_s17_q;
      sum_1463_s18_q <= sum_1463_s17_q;
      and_1469_s18_q <= and_1469_s17_q;
      textured_s18_q <= textured_s17_q;
      seen_columns_rdata_s18_q <= seen_columns_rdata_q;
      and_1603_s18_q <= and_1603_s17_q;
      equal_1743_s18_q <= equal_1743_s17_q;
      equal_1867_s18_q <= equal_1867_s17_q;
      less_2067_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2085_s18_q <= ~wide_s17_q;
      sum_2106_s18_q <= sum_2106[9:2];
      and_2120_s18_q <= and_2120_s17_q;
      less_2125_s18_q <= less_2125_s17_q;
      less_2311_s18_q <= less_2311_s17_q;
      equal_2518_s18_q <= equal_2518_s17_q;
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
  logic [13:0] sum_352;
  assign sum_352 = select_348_s18_q + (equal_350_s18_q ? 14'h0 : averager_memory_rdata_s18_q[13:0]);
  logic [13:0] sum_356;
  assign sum_356 = sum_354_s18_q + (equal_350_s18_q ? 14'h0 : averager_memory_rdata_s18_q[27:14]);
  // hls/stages/census.hpp:122
  logic and_360;
  assign and_360 = whole_s18_q & (averager_memory_rdata_s18_q[28] | equal_350_s18_q);
  // hls/stages/census.hpp:123
  logic and_364;
  assign and_364 = all_of_skin_s18_q & (averager_memory_rdata_s18_q[29] | equal_350_s18_q);
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1450;
  assign select_1450 = so_s18_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_1453;
  assign or_1453 = select_1450[7] | (~({select_1450[5], select_1450[3], select_1450[1]} == 3'h0));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = inside_v_s18_q[0] & inside_v_s18_q[3];
  logic and_1483;
  assign and_1483 = inside_v_s18_q[0] & ({inside_v_s18_q[4], inside_v_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:960
  logic select_1491;
  assign select_1491 = slot_s18_q[2] ? shown_shown_q : inside_v_s18_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = inside_v_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1491);
  // hls/stages/agreement.hpp:960
  logic select_1494;
  assign select_1494 = slot_s18_q[2] ? shown_nearer_q : inside_v_s18_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = inside_v_s18_q[0] & (select_1491 ? select_1494 : shown_right_rdata_s18_q[1]);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_1544;
  assign select_1544 = inside_v_s18_q[0] ? (sum_1463_s18_q ? select_1450 : {select_1450[6:0], 1'b0}) : select_1450;
  // hls/stages/agreement.hpp:992
  logic or_1547;
  assign or_1547 = select_1544[7] | (~({select_1544[5], select_1544[3], select_1544[1]} == 3'h0));
  // hls/stages/agreement.hpp:976
  logic and_2009;
  assign and_2009 = seen_columns_rdata_s18_q[7] & inside_v_s18_q[0];
  logic and_2010;
  assign and_2010 = seen_columns_rdata_s18_q[2] & inside_v_s18_q[0];
  // hls/stages/registration.hpp:37
  logic not_2078;
  assign not_2078 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2067_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2078};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2086;
  assign select_2086 = registration_displacement_over_q[9] ? wide_s18_q : not_2085_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2067_s18_q ? {taken_s18_q, 1'b1} : {not_2078, select_2086, not_2078};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2088;
  assign sum_2088 = {left, 1'b1} + {taken_2, less_2067_s18_q};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2107;
  assign sum_2107 = {registration_slope_s18_q[11], registration_slope_s18_q} + {{5{sum_2106_s18_q[7]}}, sum_2106_s18_q};
  // hls/stages/agreement.hpp:402
  logic select_2308;
  assign select_2308 = equal_1339_s18_q ? shown_shown_q : (so_s18_q ? select_1491 : shown_shown_q);
  logic select_2310;
  assign select_2310 = equal_1339_s18_q ? shown_nearer_q : (so_s18_q ? select_1494 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2312;
  assign sum_2312 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:402
  logic [7:0] select_2321;
  assign select_2321 = equal_1339_s18_q ? select_1450 : (so_s18_q ? (ends_cell_s18_q ? select_1544 : select_1450) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_2335;
  assign select_2335 = equal_431_s18_q ? {difference_2333[7], difference_2333} : (less_2311_s18_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2337;
  assign select_2337 = and_370_s18_q ? (equal_1867_s18_q ? select_2335 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_2339;
  assign select_2339 = equal_431_s18_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_2341;
  assign select_2341 = and_370_s18_q ? (equal_1867_s18_q ? select_2339 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_2343;
  assign select_2343 = sum_2312[7] ? {1'b1, sum_2312[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

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
  assign census_memory_re = s18_en & and_370_s18_q;
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
      registration_displacement_over_q <= so_s18_q ? sum_2088[10:1] : registration_displacement_over_q;
      shown_shown_q <= select_2308;
      shown_nearer_q <= select_2310;
      region_columns_q <= select_2321;
      region_down_rest_q <= select_2337;
      region_down_back_q <= select_2341;
      region_down_next_q <= select_2343;
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
  logic [8:0] select_335_s19_q;
  logic and_344_s19_q;
  logic and_345_s19_q;
  logic [13:0] sum_352_s19_q;
  logic [13:0] sum_356_s19_q;
  logic and_360_s19_q;
  logic and_364_s19_q;
  logic [6:0] column_s19_q;
  logic and_368_s19_q;
  logic and_370_s19_q;
  logic equal_373_s19_q;
  logic so_s19_q;
  logic equal_431_s19_q;
  logic equal_1339_s19_q;
  logic not_1340_s19_q;
  logic [11:0] inside_v_s19_q;
  logic and_1374_s19_q;
  logic equal_1384_s19_q;
  logic right_2_s19_q;
  logic or_1453_s19_q;
  logic or_1456_s19_q;
  logic or_1459_s19_q;
  logic and_1469_s19_q;
  logic textured_s19_q;
  logic explained_s19_q;
  logic and_1483_s19_q;
  logic [12:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_1529_s19_q;
  logic and_1531_s19_q;
  logic or_1547_s19_q;
  logic or_1550_s19_q;
  logic or_1553_s19_q;
  logic and_1564_s19_q;
  logic and_1566_s19_q;
  logic and_1567_s19_q;
  logic and_1580_s19_q;
  logic and_1582_s19_q;
  logic and_1583_s19_q;
  logic and_1603_s19_q;
  logic equal_1743_s19_q;
  logic equal_1867_s19_q;
  logic and_2007_s19_q;
  logic and_2008_s19_q;
  logic [1:0] sum_2012_s19_q;
  logic [7:0] sum_2107_s19_q;
  logic less_2108_s19_q;
  logic less_2109_s19_q;
  logic and_2120_s19_q;
  logic less_2125_s19_q;
  logic less_2311_s19_q;
  logic sum_2312_s19_q;
  logic and_2508_s19_q;
  logic equal_2518_s19_q;
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
      select_335_s19_q <= select_335_s18_q;
      and_344_s19_q <= and_344_s18_q;
      and_345_s19_q <= and_345_s18_q;
      sum_352_s19_q <= sum_352;
      sum_356_s19_q <= sum_356;
      and_360_s19_q <= and_360;
      and_364_s19_q <= and_364;
      column_s19_q <= column_s18_q;
      and_368_s19_q <= and_368_s18_q;
      and_370_s19_q <= and_370_s18_q;
      equal_373_s19_q <= equal_373_s18_q;
      so_s19_q <= so_s18_q;
      equal_431_s19_q <= equal_431_s18_q;
      equal_1339_s19_q <= equal_1339_s18_q;
      not_1340_s19_q <= not_1340_s18_q;
      inside_v_s19_q <= {inside_v_s18_q[13:5], inside_v_s18_q[2:0]};
      and_1374_s19_q <= and_1374_s18_q;
      equal_1384_s19_q <= x_s18_q[6:4] == 3'h7;
      right_2_s19_q <= right_2_s18_q;
      or_1453_s19_q <= or_1453;
      or_1456_s19_q <= select_1450[7] | (~({select_1450[6], select_1450[3:2]} == 3'h0));
      or_1459_s19_q <= select_1450[7] | (~(select_1450[6:4] == 3'h0));
      and_1469_s19_q <= and_1469_s18_q;
      textured_s19_q <= textured_s18_q;
      explained_s19_q <= explained;
      and_1483_s19_q <= and_1483;
      seen_columns_rdata_s19_q <= {seen_columns_rdata_s18_q[13:7], seen_columns_rdata_s18_q[5:0]};
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_1529_s19_q <= seen_columns_rdata_s18_q[14] & inside_v_s18_q[0];
      and_1531_s19_q <= seen_columns_rdata_s18_q[5] & inside_v_s18_q[0];
      or_1547_s19_q <= or_1547;
      or_1550_s19_q <= select_1544[7] | (~({select_1544[6], select_1544[3:2]} == 3'h0));
      or_1553_s19_q <= select_1544[7] | (~(select_1544[6:4] == 3'h0));
      and_1564_s19_q <= seen_columns_rdata_s18_q[16] & inside_v_s18_q[0];
      and_1566_s19_q <= seen_columns_rdata_s18_q[8] & inside_v_s18_q[0];
      and_1567_s19_q <= seen_columns_rdata_s18_q[3] & inside_v_s18_q[0];
      and_1580_s19_q <= seen_columns_rdata_s18_q[17] & inside_v_s18_q[0];
      and_1582_s19_q <= seen_columns_rdata_s18_q[9] & inside_v_s18_q[0];
      and_1583_s19_q <= seen_columns_rdata_s18_q[4] & inside_v_s18_q[0];
      and_1603_s19_q <= and_1603_s18_q;
      equal_1743_s19_q <= equal_1743_s18_q;
      equal_1867_s19_q <= equal_1867_s18_q;
      and_2007_s19_q <= seen_columns_rdata_s18_q[15] & inside_v_s18_q[0];
      and_2008_s19_q <= seen_columns_rdata_s18_q[11] & inside_v_s18_q[0];
      sum_2012_s19_q <= {1'b0, and_2009} + ({1'b0, explained} + {1'b0, and_2010});
      sum_2107_s19_q <= sum_2107[7:0];
      less_2108_s19_q <= $signed(6'h0) < $signed(sum_2107[12:7]);
      less_2109_s19_q <= $signed(sum_2107[12:7]) < $signed(6'h3f);
      and_2120_s19_q <= and_2120_s18_q;
      less_2125_s19_q <= less_2125_s18_q;
      less_2311_s19_q <= less_2311_s18_q;
      sum_2312_s19_q <= sum_2312[7];
      and_2508_s19_q <= seen_columns_rdata_s18_q[6] & inside_v_s18_q[0];
      equal_2518_s19_q <= equal_2518_s18_q;
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
  assign grey = and_344_s19_q ? sum_352_s19_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_373_s19_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_344_s19_q ? sum_356_s19_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_373_s19_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_381;
  assign and_381 = and_344_s19_q & and_360_s19_q;
  // hls/stages/census.hpp:126
  logic select_383;
  assign select_383 = equal_373_s19_q ? and_381 : (averager_mask_q & and_381);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s19_q & select_383;
  // hls/stages/census.hpp:206
  logic and_385;
  assign and_385 = and_344_s19_q & and_364_s19_q;
  // hls/stages/census.hpp:126
  logic select_387;
  assign select_387 = equal_373_s19_q ? and_385 : (averager_of_skin_q & and_385);
  // hls/stages/agreement.hpp:402
  logic [5:0] select_1460;
  assign select_1460 = equal_1339_s19_q ? x_s19_q[5:0] : {region_row_q, or_1459_s19_q, or_1456_s19_q, or_1453_s19_q};
  // hls/stages/agreement.hpp:1070
  logic not_1461;
  assign not_1461 = ~equal_1384_s19_q;
  // hls/stages/agreement.hpp:250
  logic and_1490;
  assign and_1490 = inside_v_s19_q[0] & inside_v_s19_q[2];
  // hls/stages/agreement.hpp:976
  logic and_1532;
  assign and_1532 = seen_columns_rdata_s19_q[0] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_1534;
  assign sum_1534 = {1'b0, and_1531_s19_q} + ({1'b0, textured_s19_q} + {1'b0, and_1532});
  // hls/stages/agreement.hpp:976
  logic and_1565;
  assign and_1565 = seen_columns_rdata_s19_q[11] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1569;
  assign sum_1569 = {1'b0, and_1566_s19_q} + ({1'b0, shown_s19_q} + {1'b0, and_1567_s19_q});
  // hls/stages/agreement.hpp:976
  logic and_1581;
  assign and_1581 = seen_columns_rdata_s19_q[12] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_1585;
  assign sum_1585 = {1'b0, and_1582_s19_q} + ({1'b0, near_s19_q} + {1'b0, and_1583_s19_q});
  // hls/stages/agreement.hpp:263
  logic [10:0] select_1635;
  assign select_1635 = sample_pair_whole_s19_q ? (and_368_s19_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1637;
  assign select_1637 = sample_pair_whole_s19_q ? (and_368_s19_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_1658;
  assign select_1658 = sample_pair_whole_s19_q ? (and_368_s19_q ? select_383 : averager_mask_q) : averager_mask_q;
  logic select_1660;
  assign select_1660 = sample_pair_whole_s19_q ? (and_368_s19_q ? select_387 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:402
  logic and_1986;
  assign and_1986 = so_s19_q & (ends_cell_s19_q & (inside_v_s19_q[0] & inside_v_s19_q[1]));
  // hls/stages/agreement.hpp:1047
  logic not_2006;
  assign not_2006 = ~(x_s19_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1030
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2007_s19_q} + ({2'h0, and_2008_s19_q} + {1'b0, sum_2012_s19_q});
  // hls/stages/agreement.hpp:402
  logic and_2047;
  assign and_2047 = ends_cell_s19_q & (inside_v_s19_q[0] & (inside_v_s19_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:1052
  logic and_2053;
  assign and_2053 = not_2006 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2090;
  assign select_2090 = so_s19_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_s19_q} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:83
  logic equal_2091;
  assign equal_2091 = slot_s19_q == 3'h7;
  // hls/stages/registration.hpp:218
  logic [7:0] select_2111;
  assign select_2111 = less_2108_s19_q ? 8'h7f : (less_2109_s19_q ? 8'h80 : sum_2107_s19_q);
  // hls/stages/agreement.hpp:402
  logic [7:0] select_2113;
  assign select_2113 = so_s19_q ? (equal_2091 ? registration_slope_here_q : select_2111) : registration_slope_here_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2129;
  assign select_2129 = inside_v_s19_q[3] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_2130;
  assign select_2130 = inside_v_s19_q[4] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2131;
  assign sum_2131 = {{2{select_2129[6]}}, select_2129} + {select_2130[7], select_2130};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2132;
  assign select_2132 = inside_v_s19_q[5] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2133;
  assign select_2133 = inside_v_s19_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2134;
  assign sum_2134 = {{2{select_2132[7]}}, select_2132[7:1]} + {select_2133[7], select_2133};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2136;
  assign select_2136 = inside_v_s19_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2137;
  assign select_2137 = inside_v_s19_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_2138;
  assign difference_2138 = {{2{select_2136[7]}}, select_2136[7:1]} - {select_2137[7], select_2137};
  // hls/stages/agreement.hpp:447
  logic [2:0] select_2314;
  assign select_2314 = less_2311_s19_q ? (sum_2312_s19_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2316;
  assign select_2316 = equal_1867_s19_q ? (equal_431_s19_q ? 3'h0 : select_2314) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2312_s19_q;
  // hls/stages/agreement.hpp:447
  logic select_2347;
  assign select_2347 = equal_1867_s19_q ? (equal_431_s19_q | (less_2311_s19_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1148
  logic equal_2365;
  assign equal_2365 = x_s19_q[6:3] == 4'h7;
  logic equal_2389;
  assign equal_2389 = x_s19_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_2402;
  assign select_2402 = (x_s19_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2404;
  assign select_2404 = equal_2389 ? cfg_unproven_skin_limit_i : (equal_2365 ? cfg_unproven_limit_i : select_2402);
  // hls/stages/agreement.hpp:402
  logic select_2506;
  assign select_2506 = so_s19_q ? (ends_cell_s19_q ? and_1531_s19_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2510;
  assign select_2510 = so_s19_q ? (ends_cell_s19_q ? and_2508_s19_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_2512;
  assign select_2512 = ends_cell_s19_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2514;
  assign select_2514 = equal_1339_s19_q ? centres_values_1_textured_q : (so_s19_q ? select_2512 : centres_values_1_textured_q);
  logic select_2515;
  assign select_2515 = ends_cell_s19_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2517;
  assign select_2517 = equal_1339_s19_q ? centres_values_1_of_skin_q : (so_s19_q ? select_2515 : centres_values_1_of_skin_q);

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1318; read in stage 19, written in stage 22: 19 < 22 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1460;
  logic regions_re;
  assign regions_re = s19_en & (equal_1339_s19_q ? (x_s19_q[6] & not_1461) : and_1469_s19_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_335_s19_q;
  logic averager_memory_we;
  assign averager_memory_we = s19_en & and_345_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_364_s19_q, and_360_s19_q, sum_356_s19_q, sum_352_s19_q};
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
  assign seen_columns_we = s19_en & and_1374_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q, near_s19_q, shown_s19_q, explained_s19_q, and_1490, textured_s19_q};
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
      averager_mask_q <= select_1658;
      averager_of_skin_q <= select_1660;
      registration_displacement_fraction_q <= select_2090;
      registration_slope_here_q <= equal_1339_s19_q ? registration_slope_here_q : select_2113;
      region_row_q <= and_370_s19_q ? select_2316 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_370_s19_q ? select_2347 : region_fresh_q;
      centres_values_0_textured_q <= equal_1339_s19_q ? centres_values_0_textured_q : select_2506;
      centres_values_0_of_skin_q <= equal_1339_s19_q ? centres_values_0_of_skin_q : select_2510;
      centres_values_1_textured_q <= select_2514;
      centres_values_1_of_skin_q <= select_2517;
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
      averager_total_0_q <= select_1635;
      averager_total_1_q <= select_1637;
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
  logic and_368_s20_q;
  logic and_370_s20_q;
  logic [77:0] census_memory_rdata_s20_q;
  logic [8:0] grey_s20_q;
  logic equal_373_s20_q;
  logic [8:0] select_376_s20_q;
  logic [8:0] grey_2_s20_q;
  logic [8:0] select_380_s20_q;
  logic whole_2_s20_q;
  logic and_388_s20_q;
  logic so_s20_q;
  logic equal_431_s20_q;
  logic equal_1339_s20_q;
  logic not_1340_s20_q;
  logic [1:0] inside_v_s20_q;
  logic equal_1384_s20_q;
  logic right_2_s20_q;
  logic or_1453_s20_q;
  logic or_1456_s20_q;
  logic or_1459_s20_q;
  logic not_1461_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1483_s20_q;
  logic and_1488_s20_q;
  logic and_1529_s20_q;
  logic and_1530_s20_q;
  logic [1:0] sum_1534_s20_q;
  logic or_1547_s20_q;
  logic or_1550_s20_q;
  logic or_1553_s20_q;
  logic and_1564_s20_q;
  logic [2:0] sum_1570_s20_q;
  logic and_1580_s20_q;
  logic [2:0] sum_1586_s20_q;
  logic and_1603_s20_q;
  logic equal_1743_s20_q;
  logic equal_1867_s20_q;
  logic and_1987_s20_q;
  logic not_2006_s20_q;
  logic [2:0] explained_2_s20_q;
  logic and_2049_s20_q;
  logic and_2056_s20_q;
  logic equal_2091_s20_q;
  logic and_2120_s20_q;
  logic or_2123_s20_q;
  logic [1:0] sum_2124_s20_q;
  logic less_2125_s20_q;
  logic [7:0] sum_2131_s20_q;
  logic select_2132_s20_q;
  logic [8:0] sum_2134_s20_q;
  logic select_2136_s20_q;
  logic [8:0] difference_2138_s20_q;
  logic equal_2365_s20_q;
  logic equal_2388_s20_q;
  logic equal_2389_s20_q;
  logic [7:0] select_2404_s20_q;
  logic equal_2518_s20_q;
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
      and_368_s20_q <= and_368_s19_q;
      and_370_s20_q <= and_370_s19_q;
      census_memory_rdata_s20_q <= census_memory_rdata_q;
      grey_s20_q <= grey;
      equal_373_s20_q <= equal_373_s19_q;
      select_376_s20_q <= sample_pair_whole_s19_q ? total[10:2] : 9'h0;
      grey_2_s20_q <= grey_2;
      select_380_s20_q <= sample_pair_whole_s19_q ? total_2[10:2] : 9'h0;
      whole_2_s20_q <= whole_2;
      and_388_s20_q <= sample_pair_whole_s19_q & select_387;
      so_s20_q <= so_s19_q;
      equal_431_s20_q <= equal_431_s19_q;
      equal_1339_s20_q <= equal_1339_s19_q;
      not_1340_s20_q <= not_1340_s19_q;
      inside_v_s20_q <= {inside_v_s19_q[9], inside_v_s19_q[0]};
      equal_1384_s20_q <= equal_1384_s19_q;
      right_2_s20_q <= right_2_s19_q;
      or_1453_s20_q <= or_1453_s19_q;
      or_1456_s20_q <= or_1456_s19_q;
      or_1459_s20_q <= or_1459_s19_q;
      not_1461_s20_q <= not_1461;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained_s19_q;
      and_1483_s20_q <= and_1483_s19_q;
      and_1488_s20_q <= not_1340_s19_q & and_1469_s19_q;
      and_1529_s20_q <= and_1529_s19_q;
      and_1530_s20_q <= seen_columns_rdata_s19_q[9] & inside_v_s19_q[0];
      sum_1534_s20_q <= sum_1534;
      or_1547_s20_q <= or_1547_s19_q;
      or_1550_s20_q <= or_1550_s19_q;
      or_1553_s20_q <= or_1553_s19_q;
      and_1564_s20_q <= and_1564_s19_q;
      sum_1570_s20_q <= {2'h0, and_1565} + {1'b0, sum_1569};
      and_1580_s20_q <= and_1580_s19_q;
      sum_1586_s20_q <= {2'h0, and_1581} + {1'b0, sum_1585};
      and_1603_s20_q <= and_1603_s19_q;
      equal_1743_s20_q <= equal_1743_s19_q;
      equal_1867_s20_q <= equal_1867_s19_q;
      and_1987_s20_q <= not_1340_s19_q & and_1986;
      not_2006_s20_q <= not_2006;
      explained_2_s20_q <= explained_2;
      and_2049_s20_q <= not_1340_s19_q & (so_s19_q & and_2047);
      and_2056_s20_q <= not_1340_s19_q & (so_s19_q & (ends_cell_s19_q & and_2053));
      equal_2091_s20_q <= equal_2091;
      and_2120_s20_q <= and_2120_s19_q;
      or_2123_s20_q <= (inside_v_s19_q[11:9] == 3'h0) | (inside_v_s19_q[11:9] == 3'h4);
      sum_2124_s20_q <= inside_v_s19_q[11:10] + 2'h3;
      less_2125_s20_q <= less_2125_s19_q;
      sum_2131_s20_q <= sum_2131[8:1];
      select_2132_s20_q <= select_2132[0];
      sum_2134_s20_q <= sum_2134;
      select_2136_s20_q <= select_2136[0];
      difference_2138_s20_q <= difference_2138;
      equal_2365_s20_q <= equal_2365;
      equal_2388_s20_q <= x_s19_q[6:3] == 4'h9;
      equal_2389_s20_q <= equal_2389;
      select_2404_s20_q <= select_2404;
      equal_2518_s20_q <= equal_2518_s19_q;
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
  logic less_404;
  assign less_404 = census_memory_rdata_s20_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_405;
  assign less_405 = census_memory_rdata_s20_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_406;
  assign less_406 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_407;
  assign less_407 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_408;
  assign less_408 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_409;
  assign less_409 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_410;
  assign less_410 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_411;
  assign less_411 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_412;
  assign less_412 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_413;
  assign less_413 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_414;
  assign less_414 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_415;
  assign less_415 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_416;
  assign less_416 = census_memory_rdata_s20_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_417;
  assign less_417 = census_memory_rdata_s20_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_418;
  assign less_418 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_419;
  assign less_419 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_420;
  assign less_420 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_421;
  assign less_421 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_422;
  assign less_422 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_423;
  assign less_423 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_424;
  assign less_424 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_425;
  assign less_425 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_426;
  assign less_426 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_427;
  assign less_427 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_428;
  assign equal_428 = column_s20_q == 7'h0;
  logic [3:0] select_432;
  assign select_432 = equal_431_s20_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_433;
  assign select_433 = equal_428 ? {select_432, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_434;
  assign select_434 = equal_428 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:286
  logic and_437;
  assign and_437 = census_memory_rdata_s20_q[38] & (census_memory_rdata_s20_q[18] & whole_2_s20_q);
  logic and_439;
  assign and_439 = census_memory_rdata_s20_q[77] & (census_memory_rdata_s20_q[58] & and_437);
  // hls/stages/census.hpp:270
  logic [9:0] difference_462;
  assign difference_462 = {1'b0, select_376_s20_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_465;
  assign difference_465 = {1'b0, census_memory_rdata_s20_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_469;
  assign difference_469 = {1'b0, census_memory_rdata_s20_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_473;
  assign difference_473 = {1'b0, census_memory_rdata_s20_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_477;
  assign difference_477 = {1'b0, census_memory_rdata_s20_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s20_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1110
  logic equal_1398;
  assign equal_1398 = x_s20_q[5:0] == 6'h3c;
  logic equal_1400;
  assign equal_1400 = x_s20_q[5:0] == 6'h3b;
  logic equal_1402;
  assign equal_1402 = x_s20_q[5:0] == 6'h36;
  logic equal_1404;
  assign equal_1404 = x_s20_q[5:0] == 6'h35;
  logic equal_1406;
  assign equal_1406 = x_s20_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1116
  logic and_1410;
  assign and_1410 = (~equal_1400) & ((~equal_1402) & ((~equal_1404) & (~equal_1406)));
  // hls/stages/agreement.hpp:1029
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1529_s20_q} + ({2'h0, and_1530_s20_q} + {1'b0, sum_1534_s20_q});
  // hls/stages/agreement.hpp:1031
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1564_s20_q} + sum_1570_s20_q;
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1572;
  assign select_1572 = age_s20_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1032
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1580_s20_q} + sum_1586_s20_q;
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_1588;
  assign select_1588 = age_s20_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_1627;
  assign select_1627 = sample_pair_whole_s20_q ? (and_368_s20_q ? grey_s20_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1629;
  assign select_1629 = sample_pair_whole_s20_q ? (and_368_s20_q ? grey_2_s20_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1631;
  assign select_1631 = sample_pair_whole_s20_q ? (and_368_s20_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1633;
  assign select_1633 = sample_pair_whole_s20_q ? (and_368_s20_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_1638;
  assign sum_1638 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s20_q};
  logic [9:0] sum_1646;
  assign sum_1646 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s20_q};
  // hls/stages/agreement.hpp:507
  logic [8:0] select_1661;
  assign select_1661 = and_370_s20_q ? select_376_s20_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1662;
  assign select_1662 = and_370_s20_q ? select_380_s20_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1664;
  assign select_1664 = and_370_s20_q ? census_memory_rdata_s20_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1665;
  assign select_1665 = and_370_s20_q ? census_memory_rdata_s20_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1666;
  assign select_1666 = and_370_s20_q ? census_memory_rdata_s20_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1667;
  assign select_1667 = and_370_s20_q ? census_memory_rdata_s20_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1668;
  assign select_1668 = and_370_s20_q ? census_memory_rdata_s20_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1669;
  assign select_1669 = and_370_s20_q ? census_memory_rdata_s20_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1670;
  assign select_1670 = and_370_s20_q ? census_memory_rdata_s20_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1671;
  assign select_1671 = and_370_s20_q ? census_memory_rdata_s20_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1672;
  assign select_1672 = and_370_s20_q ? census_memory_rdata_s20_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1673;
  assign select_1673 = and_370_s20_q ? census_memory_rdata_s20_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1674;
  assign select_1674 = and_370_s20_q ? census_memory_rdata_s20_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1675;
  assign select_1675 = and_370_s20_q ? census_memory_rdata_s20_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1676;
  assign select_1676 = and_370_s20_q ? census_memory_rdata_s20_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1677;
  assign select_1677 = and_370_s20_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1678;
  assign select_1678 = and_370_s20_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1680;
  assign select_1680 = and_370_s20_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1681;
  assign select_1681 = and_370_s20_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1683;
  assign select_1683 = and_370_s20_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1684;
  assign select_1684 = and_370_s20_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1686;
  assign select_1686 = and_370_s20_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1687;
  assign select_1687 = and_370_s20_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1688;
  assign select_1688 = and_370_s20_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1690;
  assign select_1690 = and_370_s20_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1691;
  assign select_1691 = and_370_s20_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1693;
  assign select_1693 = and_370_s20_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1694;
  assign select_1694 = and_370_s20_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1696;
  assign select_1696 = and_370_s20_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1697;
  assign select_1697 = and_370_s20_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1699;
  assign select_1699 = and_370_s20_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1700;
  assign select_1700 = and_370_s20_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1702;
  assign select_1702 = and_370_s20_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1703;
  assign select_1703 = and_370_s20_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1705;
  assign select_1705 = and_370_s20_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1706;
  assign select_1706 = and_370_s20_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1709;
  assign select_1709 = and_370_s20_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1710;
  assign select_1710 = and_370_s20_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1713;
  assign select_1713 = and_370_s20_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1714;
  assign select_1714 = and_370_s20_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_1718;
  assign difference_1718 = {1'b0, select_380_s20_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1721;
  assign difference_1721 = {1'b0, census_memory_rdata_s20_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1725;
  assign difference_1725 = {1'b0, census_memory_rdata_s20_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1729;
  assign difference_1729 = {1'b0, census_memory_rdata_s20_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1733;
  assign difference_1733 = {1'b0, census_memory_rdata_s20_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_1764;
  assign difference_1764 = {1'b0, select_376_s20_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1776;
  assign difference_1776 = {1'b0, select_380_s20_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:507
  logic and_1983;
  assign and_1983 = and_370_s20_q & (equal_431_s20_q & equal_1867_s20_q);
  // hls/stages/agreement.hpp:402
  logic and_1992;
  assign and_1992 = not_1340_s20_q & (so_s20_q & (ends_cell_s20_q & textured_s20_q));
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2015;
  assign select_2015 = age_s20_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2051;
  assign select_2051 = and_1983 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2049_s20_q});
  logic [13:0] select_2058;
  assign select_2058 = and_1983 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2056_s20_q});
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2126;
  assign difference_2126 = {sum_2124_s20_q, inside_v_s20_q[1], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2127;
  assign select_2127 = less_2125_s20_q ? difference_2126 : {sum_2124_s20_q, inside_v_s20_q[1], registration_displacement_fraction_q};
  logic [7:0] select_2128;
  assign select_2128 = or_2123_s20_q ? {sum_2124_s20_q, inside_v_s20_q[1], 5'h0} : select_2127;
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2135;
  assign sum_2135 = {{3{sum_2131_s20_q[7]}}, sum_2131_s20_q} + {sum_2134_s20_q[8], sum_2134_s20_q, select_2132_s20_q};
  logic [9:0] sum_2139;
  assign sum_2139 = {difference_2138_s20_q, select_2136_s20_q} + {sum_2135[10], sum_2135[10:2]};
  // hls/stages/agreement.hpp:1154
  logic equal_2366;
  assign equal_2366 = x_s20_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1148
  logic equal_2386;
  assign equal_2386 = x_s20_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1067
  logic [7:0] limit;
  assign limit = equal_2386 ? cfg_regions_limit_i : (equal_2388_s20_q ? cfg_hidden_limit_i : select_2404_s20_q);
  // hls/stages/agreement.hpp:1161
  logic not_2407;
  assign not_2407 = ~x_s20_q[2];
  logic [3:0] select_2408;
  assign select_2408 = x_s20_q[1] ? {x_s20_q[2], 1'b0, not_2407, 1'b0} : {1'b0, x_s20_q[2], 1'b0, not_2407};
  logic [7:0] select_2409;
  assign select_2409 = x_s20_q[0] ? {select_2408[3], 1'b0, select_2408[2], 1'b0, select_2408[1], 1'b0, select_2408[0], 1'b0} : {1'b0, select_2408[3], 1'b0, select_2408[2], 1'b0, select_2408[1], 1'b0, select_2408[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_2413;
  assign select_2413 = equal_2388_s20_q ? counts_skin_supervised_q : (equal_2389_s20_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2386 ? counts_textured_q : select_2413;
  // hls/stages/agreement.hpp:402
  logic [2:0] select_2451;
  assign select_2451 = ends_cell_s20_q ? explained_2_s20_q : box_explained_columns_values_0_q;
  logic [2:0] select_2453;
  assign select_2453 = equal_1339_s20_q ? box_explained_columns_values_0_q : (so_s20_q ? select_2451 : box_explained_columns_values_0_q);
  logic [2:0] select_2454;
  assign select_2454 = ends_cell_s20_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2456;
  assign select_2456 = equal_1339_s20_q ? box_explained_columns_values_1_q : (so_s20_q ? select_2454 : box_explained_columns_values_1_q);
  logic [2:0] select_2457;
  assign select_2457 = ends_cell_s20_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2459;
  assign select_2459 = equal_1339_s20_q ? box_explained_columns_values_2_q : (so_s20_q ? select_2457 : box_explained_columns_values_2_q);
  logic [2:0] select_2460;
  assign select_2460 = ends_cell_s20_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2462;
  assign select_2462 = equal_1339_s20_q ? box_explained_columns_values_3_q : (so_s20_q ? select_2460 : box_explained_columns_values_3_q);
  logic [2:0] select_2463;
  assign select_2463 = ends_cell_s20_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2465;
  assign select_2465 = equal_1339_s20_q ? box_explained_columns_values_4_q : (so_s20_q ? select_2463 : box_explained_columns_values_4_q);
  logic [2:0] select_2470;
  assign select_2470 = so_s20_q ? (ends_cell_s20_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2472;
  assign select_2472 = ends_cell_s20_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2474;
  assign select_2474 = equal_1339_s20_q ? box_shown_columns_values_1_q : (so_s20_q ? select_2472 : box_shown_columns_values_1_q);
  logic [2:0] select_2475;
  assign select_2475 = ends_cell_s20_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2477;
  assign select_2477 = equal_1339_s20_q ? box_shown_columns_values_2_q : (so_s20_q ? select_2475 : box_shown_columns_values_2_q);
  logic [2:0] select_2478;
  assign select_2478 = ends_cell_s20_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2480;
  assign select_2480 = equal_1339_s20_q ? box_shown_columns_values_3_q : (so_s20_q ? select_2478 : box_shown_columns_values_3_q);
  logic [2:0] select_2481;
  assign select_2481 = ends_cell_s20_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2483;
  assign select_2483 = equal_1339_s20_q ? box_shown_columns_values_4_q : (so_s20_q ? select_2481 : box_shown_columns_values_4_q);
  logic [2:0] select_2488;
  assign select_2488 = so_s20_q ? (ends_cell_s20_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2490;
  assign select_2490 = ends_cell_s20_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2492;
  assign select_2492 = equal_1339_s20_q ? box_nearer_columns_values_1_q : (so_s20_q ? select_2490 : box_nearer_columns_values_1_q);
  logic [2:0] select_2493;
  assign select_2493 = ends_cell_s20_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2495;
  assign select_2495 = equal_1339_s20_q ? box_nearer_columns_values_2_q : (so_s20_q ? select_2493 : box_nearer_columns_values_2_q);
  logic [2:0] select_2496;
  assign select_2496 = ends_cell_s20_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2498;
  assign select_2498 = equal_1339_s20_q ? box_nearer_columns_values_3_q : (so_s20_q ? select_2496 : box_nearer_columns_values_3_q);
  logic [2:0] select_2499;
  assign select_2499 = ends_cell_s20_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2501;
  assign select_2501 = equal_1339_s20_q ? box_nearer_columns_values_4_q : (so_s20_q ? select_2499 : box_nearer_columns_values_4_q);

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s20_q;
  logic census_memory_we;
  assign census_memory_we = s20_en & and_370_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s20_q[58:40], census_memory_rdata_s20_q[38:0], and_388_s20_q, whole_2_s20_q, select_380_s20_q, select_376_s20_q};
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
      census_filled_q <= and_370_s20_q ? {select_434[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_370_s20_q ? select_433 : rows_passed_above_q;
      counts_textured_q <= and_1983 ? 14'h0 : (counts_textured_q + {13'h0, and_1992});
      counts_skin_supervised_q <= select_2051;
      counts_skin_textured_q <= select_2058;
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
      averager_quarter_1_0_q <= select_1627;
      averager_quarter_1_1_q <= select_1629;
      averager_quarter_2_0_q <= select_1631;
      averager_quarter_2_1_q <= select_1633;
      census_columns_values_0_cell_0_left_q <= select_1661;
      census_columns_values_0_cell_0_right_q <= select_1662;
      census_columns_values_0_cell_1_left_q <= select_1664;
      census_columns_values_0_cell_1_right_q <= select_1665;
      census_columns_values_0_cell_1_mask_q <= select_1666;
      census_columns_values_0_cell_2_left_q <= select_1667;
      census_columns_values_0_cell_2_right_q <= select_1668;
      census_columns_values_0_cell_2_mask_q <= select_1669;
      census_columns_values_0_cell_2_of_skin_q <= select_1670;
      census_columns_values_0_cell_3_left_q <= select_1671;
      census_columns_values_0_cell_3_right_q <= select_1672;
      census_columns_values_0_cell_3_mask_q <= select_1673;
      census_columns_values_0_cell_4_left_q <= select_1674;
      census_columns_values_0_cell_4_right_q <= select_1675;
      census_columns_values_0_cell_4_mask_q <= select_1676;
      census_columns_values_1_cell_0_left_q <= select_1677;
      census_columns_values_1_cell_0_right_q <= select_1678;
      census_columns_values_1_cell_1_left_q <= select_1680;
      census_columns_values_1_cell_1_right_q <= select_1681;
      census_columns_values_1_cell_2_left_q <= select_1683;
      census_columns_values_1_cell_2_right_q <= select_1684;
      census_columns_values_1_cell_2_of_skin_q <= select_1686;
      census_columns_values_1_cell_3_left_q <= select_1687;
      census_columns_values_1_cell_3_right_q <= select_1688;
      census_columns_values_1_cell_4_left_q <= select_1690;
      census_columns_values_1_cell_4_right_q <= select_1691;
      census_columns_values_2_cell_0_left_q <= select_1693;
      census_columns_values_2_cell_0_right_q <= select_1694;
      census_columns_values_2_cell_1_left_q <= select_1696;
      census_columns_values_2_cell_1_right_q <= select_1697;
      census_columns_values_2_cell_2_left_q <= select_1699;
      census_columns_values_2_cell_2_right_q <= select_1700;
      census_columns_values_2_cell_3_left_q <= select_1702;
      census_columns_values_2_cell_3_right_q <= select_1703;
      census_columns_values_2_cell_4_left_q <= select_1705;
      census_columns_values_2_cell_4_right_q <= select_1706;
      census_columns_values_3_cell_1_left_q <= select_1709;
      census_columns_values_3_cell_1_right_q <= select_1710;
      census_columns_values_3_cell_3_left_q <= select_1713;
      census_columns_values_3_cell_3_right_q <= select_1714;
      sharpness_last_mean_0_q <= and_370_s20_q ? select_376_s20_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_370_s20_q ? select_380_s20_q : sharpness_last_mean_1_q;
      box_explained_columns_values_0_q <= select_2453;
      box_explained_columns_values_1_q <= select_2456;
      box_explained_columns_values_2_q <= select_2459;
      box_explained_columns_values_3_q <= select_2462;
      box_explained_columns_values_4_q <= select_2465;
      box_shown_columns_values_0_q <= equal_1339_s20_q ? box_shown_columns_values_0_q : select_2470;
      box_shown_columns_values_1_q <= select_2474;
      box_shown_columns_values_2_q <= select_2477;
      box_shown_columns_values_3_q <= select_2480;
      box_shown_columns_values_4_q <= select_2483;
      box_nearer_columns_values_0_q <= equal_1339_s20_q ? box_nearer_columns_values_0_q : select_2488;
      box_nearer_columns_values_1_q <= select_2492;
      box_nearer_columns_values_2_q <= select_2495;
      box_nearer_columns_values_3_q <= select_2498;
      box_nearer_columns_values_4_q <= select_2501;
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
  logic and_368_s21_q;
  logic and_370_s21_q;
  logic equal_373_s21_q;
  logic whole_2_s21_q;
  logic so_s21_q;
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
  logic less_426_s21_q;
  logic less_427_s21_q;
  logic and_435_s21_q;
  logic and_439_s21_q;
  logic difference_462_s21_q;
  logic [8:0] xor_463_s21_q;
  logic difference_465_s21_q;
  logic [8:0] xor_466_s21_q;
  logic difference_469_s21_q;
  logic [8:0] xor_470_s21_q;
  logic difference_473_s21_q;
  logic [8:0] xor_474_s21_q;
  logic difference_477_s21_q;
  logic [8:0] xor_478_s21_q;
  logic equal_1339_s21_q;
  logic not_1340_s21_q;
  logic inside_v_s21_q;
  logic equal_1384_s21_q;
  logic all_s21_q;
  logic equal_1398_s21_q;
  logic equal_1400_s21_q;
  logic equal_1402_s21_q;
  logic equal_1404_s21_q;
  logic equal_1406_s21_q;
  logic and_1411_s21_q;
  logic right_2_s21_q;
  logic or_1453_s21_q;
  logic or_1456_s21_q;
  logic or_1459_s21_q;
  logic not_1461_s21_q;
  logic [29:0] regions_rdata_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1483_s21_q;
  logic and_1488_s21_q;
  logic [2:0] textured_2_s21_q;
  logic equal_1539_s21_q;
  logic or_1547_s21_q;
  logic or_1550_s21_q;
  logic or_1553_s21_q;
  logic [3:0] difference_1573_s21_q;
  logic [3:0] difference_1589_s21_q;
  logic and_1603_s21_q;
  logic sum_1638_s21_q;
  logic [9:0] difference_1639_s21_q;
  logic sum_1646_s21_q;
  logic [9:0] difference_1647_s21_q;
  logic difference_1718_s21_q;
  logic [8:0] xor_1719_s21_q;
  logic difference_1721_s21_q;
  logic [8:0] xor_1722_s21_q;
  logic difference_1725_s21_q;
  logic [8:0] xor_1726_s21_q;
  logic difference_1729_s21_q;
  logic [8:0] xor_1730_s21_q;
  logic difference_1733_s21_q;
  logic [8:0] xor_1734_s21_q;
  logic equal_1743_s21_q;
  logic difference_1764_s21_q;
  logic [8:0] xor_1765_s21_q;
  logic difference_1776_s21_q;
  logic [8:0] xor_1777_s21_q;
  logic equal_1867_s21_q;
  logic and_1983_s21_q;
  logic and_1987_s21_q;
  logic and_1992_s21_q;
  logic not_2006_s21_q;
  logic [3:0] difference_2016_s21_q;
  logic equal_2091_s21_q;
  logic and_2120_s21_q;
  logic [7:0] select_2128_s21_q;
  logic sum_2135_s21_q;
  logic [9:0] sum_2139_s21_q;
  logic equal_2366_s21_q;
  logic and_2367_s21_q;
  logic equal_2386_s21_q;
  logic equal_2388_s21_q;
  logic equal_2389_s21_q;
  logic equal_2411_s21_q;
  logic [13:0] of_s21_q;
  logic equal_2518_s21_q;
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
      and_368_s21_q <= and_368_s20_q;
      and_370_s21_q <= and_370_s20_q;
      equal_373_s21_q <= equal_373_s20_q;
      whole_2_s21_q <= whole_2_s20_q;
      so_s21_q <= so_s20_q;
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
      less_426_s21_q <= less_426;
      less_427_s21_q <= less_427;
      and_435_s21_q <= select_433[4] & select_434[3];
      and_439_s21_q <= and_439;
      difference_462_s21_q <= difference_462[9];
      xor_463_s21_q <= difference_462[8:0] ^ {9{difference_462[9]}};
      difference_465_s21_q <= difference_465[9];
      xor_466_s21_q <= difference_465[8:0] ^ {9{difference_465[9]}};
      difference_469_s21_q <= difference_469[9];
      xor_470_s21_q <= difference_469[8:0] ^ {9{difference_469[9]}};
      difference_473_s21_q <= difference_473[9];
      xor_474_s21_q <= difference_473[8:0] ^ {9{difference_473[9]}};
      difference_477_s21_q <= difference_477[9];
      xor_478_s21_q <= difference_477[8:0] ^ {9{difference_477[9]}};
      equal_1339_s21_q <= equal_1339_s20_q;
      not_1340_s21_q <= not_1340_s20_q;
      inside_v_s21_q <= inside_v_s20_q[0];
      equal_1384_s21_q <= equal_1384_s20_q;
      all_s21_q <= all;
      equal_1398_s21_q <= equal_1398;
      equal_1400_s21_q <= equal_1400;
      equal_1402_s21_q <= equal_1402;
      equal_1404_s21_q <= equal_1404;
      equal_1406_s21_q <= equal_1406;
      and_1411_s21_q <= (~equal_1398) & and_1410;
      right_2_s21_q <= right_2_s20_q;
      or_1453_s21_q <= or_1453_s20_q;
      or_1456_s21_q <= or_1456_s20_q;
      or_1459_s21_q <= or_1459_s20_q;
      not_1461_s21_q <= not_1461_s20_q;
      regions_rdata_s21_q <= regions_rdata_q;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1483_s21_q <= and_1483_s20_q;
      and_1488_s21_q <= and_1488_s20_q;
      textured_2_s21_q <= textured_2;
      equal_1539_s21_q <= x_s20_q == 8'h0;
      or_1547_s21_q <= or_1547_s20_q;
      or_1550_s21_q <= or_1550_s20_q;
      or_1553_s21_q <= or_1553_s20_q;
      difference_1573_s21_q <= {1'b0, shown_2} - {1'b0, select_1572};
      difference_1589_s21_q <= {1'b0, near_2} - {1'b0, select_1588};
      and_1603_s21_q <= and_1603_s20_q;
      sum_1638_s21_q <= sum_1638[0];
      difference_1639_s21_q <= {1'b0, sum_1638[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1646_s21_q <= sum_1646[0];
      difference_1647_s21_q <= {1'b0, sum_1646[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1718_s21_q <= difference_1718[9];
      xor_1719_s21_q <= difference_1718[8:0] ^ {9{difference_1718[9]}};
      difference_1721_s21_q <= difference_1721[9];
      xor_1722_s21_q <= difference_1721[8:0] ^ {9{difference_1721[9]}};
      difference_1725_s21_q <= difference_1725[9];
      xor_1726_s21_q <= difference_1725[8:0] ^ {9{difference_1725[9]}};
      difference_1729_s21_q <= difference_1729[9];
      xor_1730_s21_q <= difference_1729[8:0] ^ {9{difference_1729[9]}};
      difference_1733_s21_q <= difference_1733[9];
      xor_1734_s21_q <= difference_1733[8:0] ^ {9{difference_1733[9]}};
      equal_1743_s21_q <= equal_1743_s20_q;
      difference_1764_s21_q <= difference_1764[9];
      xor_1765_s21_q <= difference_1764[8:0] ^ {9{difference_1764[9]}};
      difference_1776_s21_q <= difference_1776[9];
      xor_1777_s21_q <= difference_1776[8:0] ^ {9{difference_1776[9]}};
      equal_1867_s21_q <= equal_1867_s20_q;
      and_1983_s21_q <= and_1983;
      and_1987_s21_q <= and_1987_s20_q;
      and_1992_s21_q <= and_1992;
      not_2006_s21_q <= not_2006_s20_q;
      difference_2016_s21_q <= {1'b0, explained_2_s20_q} - {1'b0, select_2015};
      equal_2091_s21_q <= equal_2091_s20_q;
      and_2120_s21_q <= and_2120_s20_q;
      select_2128_s21_q <= select_2128;
      sum_2135_s21_q <= sum_2135[1];
      sum_2139_s21_q <= sum_2139;
      equal_2366_s21_q <= equal_2366;
      and_2367_s21_q <= equal_2365_s20_q & equal_2366;
      equal_2386_s21_q <= equal_2386;
      equal_2388_s21_q <= equal_2388_s20_q;
      equal_2389_s21_q <= equal_2389_s20_q;
      equal_2411_s21_q <= (limit & select_2409) == 8'h0;
      of_s21_q <= of;
      equal_2518_s21_q <= equal_2518_s20_q;
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
  logic [12:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_439_s21_q;
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
  logic [9:0] sum_464;
  assign sum_464 = {9'h0, difference_462_s21_q} + {1'b0, xor_463_s21_q};
  logic [9:0] sum_467;
  assign sum_467 = {9'h0, difference_465_s21_q} + {1'b0, xor_466_s21_q};
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s21_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1387;
  assign select_1387 = x_s21_q[4] ? {x_s21_q[3], x_s21_q[0]} : {x_s21_q[0], x_s21_q[3]};
  // hls/stages/agreement.hpp:1085
  logic [3:0] select_1389;
  assign select_1389 = equal_1384_s21_q ? {2'h0, quarter} : (all_s21_q ? {1'b0, x_s21_q[2:0]} : {x_s21_q[2:1], select_1387});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1390;
  assign sum_1390 = slot_s21_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:402
  logic [3:0] select_1391;
  assign select_1391 = equal_1339_s21_q ? select_1389 : {sum_1390, lower_half_s21_q, registration_of_right_q};
  // hls/stages/agreement.hpp:1110
  logic equal_1392;
  assign equal_1392 = x_s21_q[5:0] == 6'h3f;
  logic equal_1394;
  assign equal_1394 = x_s21_q[5:0] == 6'h3e;
  logic equal_1396;
  assign equal_1396 = x_s21_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1116
  logic and_1414;
  assign and_1414 = (~equal_1392) & ((~equal_1394) & ((~equal_1396) & and_1411_s21_q));
  // hls/stages/agreement.hpp:1071
  logic less_1415;
  assign less_1415 = x_s21_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s21_q ? {1'b0, x_s21_q[2]} : x_s21_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1419;
  assign or_1419 = (kind == 2'h3) | (x_s21_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s21_q ? (right_2_s21_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1430;
  assign sum_1430 = {2'h0, slot_s21_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1436;
  assign not_1436 = ~lower_half_s21_q;
  logic [3:0] select_1437;
  assign select_1437 = registration_of_right_q ? {lower_half_s21_q, 1'b0, not_1436, 1'b0} : {1'b0, lower_half_s21_q, 1'b0, not_1436};
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1473;
  assign select_1473 = segment_started_s21_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1474;
  assign sum_1474 = {6'h0, textured_s21_q} + select_1473;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1476;
  assign sum_1476 = {3'h0, sum_1474} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1478;
  assign select_1478 = segment_started_s21_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1479;
  assign sum_1479 = {6'h0, explained_s21_q} + select_1478;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1481;
  assign sum_1481 = {3'h0, sum_1479} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1484;
  assign select_1484 = segment_started_s21_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_1485;
  assign sum_1485 = {6'h0, and_1483_s21_q} + select_1484;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_1487;
  assign sum_1487 = {3'h0, sum_1485} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[29:20]);
  // hls/stages/agreement.hpp:1201
  logic or_1497;
  assign or_1497 = marks_first_s21_q | line_ended_q;
  // hls/stages/agreement.hpp:1203
  logic [12:0] select_1499;
  assign select_1499 = marks_first_s21_q ? 13'h1 : (or_1497 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1202
  logic [8:0] select_1501;
  assign select_1501 = or_1497 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1210
  logic select_1503;
  assign select_1503 = cfg_compete_i ? (or_1497 & select_1499[12]) : (select_1501[8] & select_1499[9]);
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_1537;
  assign select_1537 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1038
  logic [4:0] around;
  assign around = {difference_1573_s21_q[3], difference_1573_s21_q} + (equal_1539_s21_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1039
  logic [4:0] n;
  assign n = {difference_1589_s21_q[3], difference_1589_s21_q} + (equal_1539_s21_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:209
  logic [9:0] xor_1640;
  assign xor_1640 = {difference_1639_s21_q[8:0], sum_1638_s21_q} ^ {10{difference_1639_s21_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_1639_s21_q[9]} + {1'b0, xor_1640};
  logic [9:0] xor_1648;
  assign xor_1648 = {difference_1647_s21_q[8:0], sum_1646_s21_q} ^ {10{difference_1647_s21_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1647_s21_q[9]} + {1'b0, xor_1648};
  // hls/stages/agreement.hpp:507
  logic select_1663;
  assign select_1663 = and_370_s21_q ? whole_2_s21_q : census_columns_values_0_cell_0_mask_q;
  logic select_1679;
  assign select_1679 = and_370_s21_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1682;
  assign select_1682 = and_370_s21_q ? census_columns_values_0_cell_1_mask_s21_q : census_columns_values_1_cell_1_mask_q;
  logic select_1685;
  assign select_1685 = and_370_s21_q ? census_columns_values_0_cell_2_mask_s21_q : census_columns_values_1_cell_2_mask_q;
  logic select_1689;
  assign select_1689 = and_370_s21_q ? census_columns_values_0_cell_3_mask_s21_q : census_columns_values_1_cell_3_mask_q;
  logic select_1692;
  assign select_1692 = and_370_s21_q ? census_columns_values_0_cell_4_mask_s21_q : census_columns_values_1_cell_4_mask_q;
  logic select_1695;
  assign select_1695 = and_370_s21_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1698;
  assign select_1698 = and_370_s21_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_1720;
  assign sum_1720 = {9'h0, difference_1718_s21_q} + {1'b0, xor_1719_s21_q};
  logic [9:0] sum_1723;
  assign sum_1723 = {9'h0, difference_1721_s21_q} + {1'b0, xor_1722_s21_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1764_s21_q} + xor_1765_s21_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1776_s21_q} + xor_1777_s21_q;
  // hls/stages/agreement.hpp:402
  logic and_1997;
  assign and_1997 = not_1340_s21_q & (so_s21_q & (ends_cell_s21_q & explained_s21_q));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_1999;
  assign select_1999 = and_1983_s21_q ? 14'h0 : (counts_explained_q + {13'h0, and_1997});
  // hls/stages/agreement.hpp:402
  logic and_2002;
  assign and_2002 = not_1340_s21_q & (so_s21_q & (ends_cell_s21_q & and_1483_s21_q));
  // hls/stages/agreement.hpp:1037
  logic [4:0] e;
  assign e = {difference_2016_s21_q[3], difference_2016_s21_q} + (equal_1539_s21_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1074
  logic less_2031;
  assign less_2031 = region_row_s21_q < x_s21_q[5:3];
  // hls/stages/registration.hpp:108
  logic equal_2115;
  assign equal_2115 = slot_s21_q == 3'h4;
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2128_s21_q[7]}}, select_2128_s21_q} - {sum_2139_s21_q[9], sum_2139_s21_q, sum_2135_s21_q};
  // hls/stages/agreement.hpp:402
  logic select_2186;
  assign select_2186 = so_s21_q ? (equal_2115 ? right_2_s21_q : registration_of_right_q) : registration_of_right_q;
  logic select_2189;
  assign select_2189 = so_s21_q ? (equal_2091_s21_q ? inside_v_s21_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all_s21_q ? x_s21_q[1:0] : select_1387;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_2400;
  assign select_2400 = equal_2366_s21_q ? 14'h0 : product_q;
  logic [13:0] select_2415;
  assign select_2415 = equal_2411_s21_q ? 14'h0 : of_s21_q;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2400} + {1'b0, select_2415};
  // hls/stages/agreement.hpp:402
  logic [2:0] select_2433;
  assign select_2433 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_2435;
  assign select_2435 = equal_1339_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_2433 : box_textured_columns_values_0_q);
  logic [2:0] select_2436;
  assign select_2436 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2438;
  assign select_2438 = equal_1339_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_2436 : box_textured_columns_values_1_q);
  logic [2:0] select_2439;
  assign select_2439 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2441;
  assign select_2441 = equal_1339_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_2439 : box_textured_columns_values_2_q);
  logic [2:0] select_2442;
  assign select_2442 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2444;
  assign select_2444 = equal_1339_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_2442 : box_textured_columns_values_3_q);
  logic [2:0] select_2445;
  assign select_2445 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2447;
  assign select_2447 = equal_1339_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_2445 : box_textured_columns_values_4_q);
  logic [4:0] select_2467;
  assign select_2467 = so_s21_q ? (ends_cell_s21_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2468;
  assign select_2468 = equal_1339_s21_q ? box_explained_sum_sums_values_0_q : select_2467;
  logic [4:0] select_2485;
  assign select_2485 = so_s21_q ? (ends_cell_s21_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_2503;
  assign select_2503 = so_s21_q ? (ends_cell_s21_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_explained_q <= 14'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s21_en) begin
      counts_explained_q <= select_1999;
      registration_of_right_q <= equal_1339_s21_q ? registration_of_right_q : select_2186;
      registration_was_inside_q <= equal_1339_s21_q ? registration_was_inside_q : select_2189;
      segment_textured_q <= select_1473 + {6'h0, and_1992_s21_q};
      segment_explained_q <= select_1478 + {6'h0, and_1997};
      segment_nearer_q <= select_1484 + {6'h0, and_2002};
      product_q <= equal_1339_s21_q ? sum_3[14:1] : product_q;
      rows_passed_q <= select_1499;
      columns_passed_q <= {select_1501[7:0], or_1497};
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
      census_columns_values_0_cell_0_mask_q <= select_1663;
      census_columns_values_1_cell_0_mask_q <= select_1679;
      census_columns_values_1_cell_1_mask_q <= select_1682;
      census_columns_values_1_cell_2_mask_q <= select_1685;
      census_columns_values_1_cell_3_mask_q <= select_1689;
      census_columns_values_1_cell_4_mask_q <= select_1692;
      census_columns_values_2_cell_0_mask_q <= select_1695;
      census_columns_values_2_cell_1_mask_q <= select_1698;
      box_textured_columns_values_0_q <= select_2435;
      box_textured_columns_values_1_q <= select_2438;
      box_textured_columns_values_2_q <= select_2441;
      box_textured_columns_values_3_q <= select_2444;
      box_textured_columns_values_4_q <= select_2447;
      box_explained_sum_sums_values_0_q <= select_2468;
      box_shown_sum_sums_values_0_q <= equal_1339_s21_q ? box_shown_sum_sums_values_0_q : select_2485;
      box_nearer_sum_sums_values_0_q <= equal_1339_s21_q ? box_nearer_sum_sums_values_0_q : select_2503;
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
  logic and_368_s22_q;
  logic and_370_s22_q;
  logic equal_373_s22_q;
  logic whole_2_s22_q;
  logic so_s22_q;
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
  logic less_426_s22_q;
  logic less_427_s22_q;
  logic and_435_s22_q;
  logic whole_9_s22_q;
  logic [10:0] sum_468_s22_q;
  logic [9:0] sum_471_s22_q;
  logic [9:0] sum_475_s22_q;
  logic [9:0] sum_479_s22_q;
  logic equal_1339_s22_q;
  logic not_1340_s22_q;
  logic equal_1384_s22_q;
  logic [1:0] quarter_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1390_s22_q;
  logic [3:0] select_1391_s22_q;
  logic equal_1392_s22_q;
  logic equal_1394_s22_q;
  logic equal_1396_s22_q;
  logic equal_1398_s22_q;
  logic equal_1400_s22_q;
  logic equal_1402_s22_q;
  logic equal_1404_s22_q;
  logic equal_1406_s22_q;
  logic less_1415_s22_q;
  logic or_1419_s22_q;
  logic select_1422_s22_q;
  logic and_1432_s22_q;
  logic [3:0] select_1437_s22_q;
  logic or_1453_s22_q;
  logic or_1456_s22_q;
  logic or_1459_s22_q;
  logic not_1461_s22_q;
  logic [9:0] sum_1476_s22_q;
  logic [9:0] sum_1481_s22_q;
  logic [9:0] sum_1487_s22_q;
  logic and_1488_s22_q;
  logic select_1503_s22_q;
  logic [3:0] difference_1538_s22_q;
  logic equal_1539_s22_q;
  logic or_1547_s22_q;
  logic or_1550_s22_q;
  logic or_1553_s22_q;
  logic [4:0] around_s22_q;
  logic less_1592_s22_q;
  logic and_1603_s22_q;
  logic [10:0] size_s22_q;
  logic [10:0] size_2_s22_q;
  logic [10:0] sum_1724_s22_q;
  logic [9:0] sum_1727_s22_q;
  logic [9:0] sum_1731_s22_q;
  logic [9:0] sum_1735_s22_q;
  logic equal_1743_s22_q;
  logic [8:0] contrast_s22_q;
  logic [8:0] contrast_2_s22_q;
  logic equal_1867_s22_q;
  logic and_1983_s22_q;
  logic and_1987_s22_q;
  logic and_2002_s22_q;
  logic not_2006_s22_q;
  logic [4:0] e_s22_q;
  logic [9:0] select_2032_s22_q;
  logic [9:0] select_2035_s22_q;
  logic equal_2091_s22_q;
  logic and_2118_s22_q;
  logic and_2120_s22_q;
  logic [11:0] select_2142_s22_q;
  logic equal_2191_s22_q;
  logic [3:0] not_2192_s22_q;
  logic [1:0] quarter_2_s22_q;
  logic equal_2366_s22_q;
  logic and_2367_s22_q;
  logic less_2368_s22_q;
  logic equal_2369_s22_q;
  logic equal_2386_s22_q;
  logic equal_2388_s22_q;
  logic equal_2389_s22_q;
  logic sum_3_s22_q;
  logic equal_2518_s22_q;
  logic [9:0] select_2612_s22_q;
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
      and_368_s22_q <= and_368_s21_q;
      and_370_s22_q <= and_370_s21_q;
      equal_373_s22_q <= equal_373_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      so_s22_q <= so_s21_q;
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
      less_426_s22_q <= less_426_s21_q;
      less_427_s22_q <= less_427_s21_q;
      and_435_s22_q <= and_435_s21_q;
      whole_9_s22_q <= whole_9;
      sum_468_s22_q <= {1'b0, sum_464} + {1'b0, sum_467};
      sum_471_s22_q <= {9'h0, difference_469_s21_q} + {1'b0, xor_470_s21_q};
      sum_475_s22_q <= {9'h0, difference_473_s21_q} + {1'b0, xor_474_s21_q};
      sum_479_s22_q <= {9'h0, difference_477_s21_q} + {1'b0, xor_478_s21_q};
      equal_1339_s22_q <= equal_1339_s21_q;
      not_1340_s22_q <= not_1340_s21_q;
      equal_1384_s22_q <= equal_1384_s21_q;
      quarter_s22_q <= quarter;
      all_s22_q <= all_s21_q;
      sum_1390_s22_q <= sum_1390;
      select_1391_s22_q <= select_1391;
      equal_1392_s22_q <= equal_1392;
      equal_1394_s22_q <= equal_1394;
      equal_1396_s22_q <= equal_1396;
      equal_1398_s22_q <= equal_1398_s21_q;
      equal_1400_s22_q <= equal_1400_s21_q;
      equal_1402_s22_q <= equal_1402_s21_q;
      equal_1404_s22_q <= equal_1404_s21_q;
      equal_1406_s22_q <= equal_1406_s21_q;
      less_1415_s22_q <= less_1415;
      or_1419_s22_q <= or_1419;
      select_1422_s22_q <= equal_1384_s21_q ? and_1414 : (less_1415 & (~or_1419));
      and_1432_s22_q <= half_ends & ({{3{sum_1430[4]}}, sum_1430} < 8'h3);
      select_1437_s22_q <= select_1437;
      or_1453_s22_q <= or_1453_s21_q;
      or_1456_s22_q <= or_1456_s21_q;
      or_1459_s22_q <= or_1459_s21_q;
      not_1461_s22_q <= not_1461_s21_q;
      sum_1476_s22_q <= sum_1476;
      sum_1481_s22_q <= sum_1481;
      sum_1487_s22_q <= sum_1487;
      and_1488_s22_q <= and_1488_s21_q;
      select_1503_s22_q <= select_1503;
      difference_1538_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1537};
      equal_1539_s22_q <= equal_1539_s21_q;
      or_1547_s22_q <= or_1547_s21_q;
      or_1550_s22_q <= or_1550_s21_q;
      or_1553_s22_q <= or_1553_s21_q;
      around_s22_q <= around;
      less_1592_s22_q <= {1'b0, around[4:1]} < n;
      and_1603_s22_q <= and_1603_s21_q;
      size_s22_q <= size;
      size_2_s22_q <= size_2;
      sum_1724_s22_q <= {1'b0, sum_1720} + {1'b0, sum_1723};
      sum_1727_s22_q <= {9'h0, difference_1725_s21_q} + {1'b0, xor_1726_s21_q};
      sum_1731_s22_q <= {9'h0, difference_1729_s21_q} + {1'b0, xor_1730_s21_q};
      sum_1735_s22_q <= {9'h0, difference_1733_s21_q} + {1'b0, xor_1734_s21_q};
      equal_1743_s22_q <= equal_1743_s21_q;
      contrast_s22_q <= contrast;
      contrast_2_s22_q <= contrast_2;
      equal_1867_s22_q <= equal_1867_s21_q;
      and_1983_s22_q <= and_1983_s21_q;
      and_1987_s22_q <= and_1987_s21_q;
      and_2002_s22_q <= and_2002;
      not_2006_s22_q <= not_2006_s21_q;
      e_s22_q <= e;
      select_2032_s22_q <= less_2031 ? 10'h0 : regions_rdata_s21_q[9:0];
      select_2035_s22_q <= less_2031 ? 10'h0 : regions_rdata_s21_q[19:10];
      equal_2091_s22_q <= equal_2091_s21_q;
      and_2118_s22_q <= not_1340_s21_q & (so_s21_q & (half_ends & equal_2115));
      and_2120_s22_q <= and_2120_s21_q;
      select_2142_s22_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2191_s22_q <= sum_1390 == 2'h2;
      not_2192_s22_q <= ~select_1437;
      quarter_2_s22_q <= quarter_2;
      equal_2366_s22_q <= equal_2366_s21_q;
      and_2367_s22_q <= and_2367_s21_q;
      less_2368_s22_q <= counts_explained_q < product_q;
      equal_2369_s22_q <= counts_explained_q == product_q;
      equal_2386_s22_q <= equal_2386_s21_q;
      equal_2388_s22_q <= equal_2388_s21_q;
      equal_2389_s22_q <= equal_2389_s21_q;
      sum_3_s22_q <= sum_3[0];
      equal_2518_s22_q <= equal_2518_s21_q;
      select_2612_s22_q <= less_2031 ? 10'h0 : regions_rdata_s21_q[29:20];
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
  logic [10:0] sum_472;
  assign sum_472 = sum_468_s22_q + {1'b0, sum_471_s22_q};
  // hls/stages/agreement.hpp:402
  logic and_1433;
  assign and_1433 = so_s22_q & and_1432_s22_q;
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_1503_s22_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1217
  logic [6:0] select_1506;
  assign select_1506 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1227
  logic equal_1509;
  assign equal_1509 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1200
  logic not_1516;
  assign not_1516 = ~marks_first_s22_q;
  // hls/stages/agreement.hpp:1036
  logic [4:0] t;
  assign t = {difference_1538_s22_q[3], difference_1538_s22_q} + (equal_1539_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1043
  logic not_1554;
  assign not_1554 = ~region_row_s22_q[2];
  logic [2:0] select_1555;
  assign select_1555 = region_row_s22_q[1] ? {1'b0, not_1554, 1'b0} : {region_row_s22_q[2], 1'b0, not_1554};
  logic [5:0] select_1556;
  assign select_1556 = region_row_s22_q[0] ? {select_1555[2], 1'b0, select_1555[1], 1'b0, select_1555[0], 1'b0} : {1'b0, select_1555[2], 1'b0, select_1555[1], 1'b0, select_1555[0]};
  logic [11:0] select_1557;
  assign select_1557 = or_1553_s22_q ? {select_1556[5], 1'b0, select_1556[4], 1'b0, select_1556[3], 1'b0, select_1556[2], 1'b0, select_1556[1], 1'b0, select_1556[0], 1'b0} : {1'b0, select_1556[5], 1'b0, select_1556[4], 1'b0, select_1556[3], 1'b0, select_1556[2], 1'b0, select_1556[1], 1'b0, select_1556[0]};
  logic [23:0] select_1558;
  assign select_1558 = or_1550_s22_q ? {select_1557[11], 1'b0, select_1557[10], 1'b0, select_1557[9], 1'b0, select_1557[8], 1'b0, select_1557[7], 1'b0, select_1557[6], 1'b0, select_1557[5], 1'b0, select_1557[4], 1'b0, select_1557[3], 1'b0, select_1557[2], 1'b0, select_1557[1], 1'b0, select_1557[0], 1'b0} : {1'b0, select_1557[11], 1'b0, select_1557[10], 1'b0, select_1557[9], 1'b0, select_1557[8], 1'b0, select_1557[7], 1'b0, select_1557[6], 1'b0, select_1557[5], 1'b0, select_1557[4], 1'b0, select_1557[3], 1'b0, select_1557[2], 1'b0, select_1557[1], 1'b0, select_1557[0]};
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_1576;
  assign sum_1576 = {1'b0, around_s22_q} + {2'h0, around_s22_q[4:1]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s22_q} + (equal_373_s22_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_1645;
  assign select_1645 = sample_pair_whole_s22_q ? (and_368_s22_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s22_q} + (equal_373_s22_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_1653;
  assign select_1653 = sample_pair_whole_s22_q ? (and_368_s22_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:507
  logic select_1701;
  assign select_1701 = and_370_s22_q ? census_columns_values_1_cell_2_mask_s22_q : census_columns_values_2_cell_2_mask_q;
  logic select_1704;
  assign select_1704 = and_370_s22_q ? census_columns_values_1_cell_3_mask_s22_q : census_columns_values_2_cell_3_mask_q;
  logic select_1707;
  assign select_1707 = and_370_s22_q ? census_columns_values_1_cell_4_mask_s22_q : census_columns_values_2_cell_4_mask_q;
  logic select_1708;
  assign select_1708 = and_370_s22_q ? census_columns_values_2_cell_0_mask_s22_q : census_columns_values_3_cell_0_mask_q;
  logic select_1711;
  assign select_1711 = and_370_s22_q ? census_columns_values_2_cell_1_mask_s22_q : census_columns_values_3_cell_1_mask_q;
  logic select_1712;
  assign select_1712 = and_370_s22_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1715;
  assign select_1715 = and_370_s22_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_1728;
  assign sum_1728 = sum_1724_s22_q + {1'b0, sum_1727_s22_q};
  // hls/stages/agreement.hpp:507
  logic select_1760;
  assign select_1760 = and_370_s22_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_1763;
  assign and_1763 = whole_2_s22_q & (~(column_s22_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
  logic and_1769;
  assign and_1769 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s22_q[8:2]));
  logic and_1770;
  assign and_1770 = and_1763 & and_1769;
  logic and_1781;
  assign and_1781 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s22_q[8:2]));
  logic and_1782;
  assign and_1782 = and_1763 & and_1781;
  // hls/stages/census.hpp:409
  logic not_1799;
  assign not_1799 = ~x_s22_q[1];
  logic [2:0] select_1800;
  assign select_1800 = x_s22_q[0] ? {1'b0, not_1799, 1'b0} : {x_s22_q[1], 1'b0, not_1799};
  logic [5:0] select_1801;
  assign select_1801 = slot_s22_q[2] ? {select_1800[2], 1'b0, select_1800[1], 1'b0, select_1800[0], 1'b0} : {1'b0, select_1800[2], 1'b0, select_1800[1], 1'b0, select_1800[0]};
  logic [11:0] select_1802;
  assign select_1802 = slot_s22_q[1] ? {select_1801[5], 1'b0, select_1801[4], 1'b0, select_1801[3], 1'b0, select_1801[2], 1'b0, select_1801[1], 1'b0, select_1801[0], 1'b0} : {1'b0, select_1801[5], 1'b0, select_1801[4], 1'b0, select_1801[3], 1'b0, select_1801[2], 1'b0, select_1801[1], 1'b0, select_1801[0]};
  // hls/stages/agreement.hpp:889
  logic [13:0] select_1989;
  assign select_1989 = and_1983_s22_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1987_s22_q});
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2019;
  assign sum_2019 = {1'b0, e_s22_q} + {2'h0, e_s22_q[4:1]};
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2142_s22_q[11:7])) ? 12'h7f : select_2142_s22_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2194;
  assign select_2194 = equal_2191_s22_q ? (registration_fresh_q & not_2192_s22_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:402
  logic [3:0] select_2196;
  assign select_2196 = so_s22_q ? (and_1432_s22_q ? select_2194 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2198;
  assign select_2198 = and_1983_s22_q ? 4'hf : (equal_1339_s22_q ? registration_fresh_q : select_2196);
  // hls/stages/registration.hpp:258
  logic not_2219;
  assign not_2219 = ~quarter_2_s22_q[1];
  logic [3:0] select_2220;
  assign select_2220 = quarter_2_s22_q[0] ? {quarter_2_s22_q[1], 1'b0, not_2219, 1'b0} : {1'b0, quarter_2_s22_q[1], 1'b0, not_2219};
  // hls/stages/agreement.hpp:1126
  logic or_2363;
  assign or_2363 = ({counts_textured_s22_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s22_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = less_2368_s22_q | (product_rest_q & equal_2369_s22_q);
  // hls/stages/agreement.hpp:1158
  logic select_2372;
  assign select_2372 = and_2367_s22_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_2375;
  assign sum_2375 = {1'b0, select_2035_s22_q} + {2'h0, select_2035_s22_q[9:1]};
  // hls/stages/agreement.hpp:402
  logic select_2420;
  assign select_2420 = equal_1339_s22_q ? (equal_2366_s22_q ? sum_3_s22_q : (product_rest_q | sum_3_s22_q)) : product_rest_q;
  logic [4:0] select_2449;
  assign select_2449 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_2450;
  assign select_2450 = equal_1339_s22_q ? box_textured_sum_sums_values_0_q : select_2449;
  // hls/stages/agreement.hpp:1226
  logic [3:0] select_2535;
  assign select_2535 = select_1503_s22_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_2541;
  assign select_2541 = marks_first_s22_q ? (less_2537 ? {sum_2538, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:258
  logic not_2599;
  assign not_2599 = ~quarter_s22_q[1];
  logic [3:0] select_2600;
  assign select_2600 = quarter_s22_q[0] ? {quarter_s22_q[1], 1'b0, not_2599, 1'b0} : {1'b0, quarter_s22_q[1], 1'b0, not_2599};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 22, written in stage 26: 22 < 26 < 22 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1391_s22_q;
  logic registration_sums_re;
  assign registration_sums_re = s22_en & (equal_1339_s22_q ? (x_s22_q[6] & select_1422_s22_q) : and_1433);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s22_q, or_1459_s22_q, or_1456_s22_q, or_1453_s22_q};
  logic regions_we;
  assign regions_we = s22_en & and_1488_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1487_s22_q, sum_1481_s22_q, sum_1476_s22_q};
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
      sharpness_before_last_mask_q <= select_1760;
      counts_supervised_q <= select_1989;
      registration_fresh_q <= select_2198;
      product_rest_q <= select_2420;
      disagree_q <= equal_1339_s22_q ? select_2372 : disagree_q;
      began_q <= not_1516 & (began_q | select_1503_s22_q);
      seen_x_q <= select_1503_s22_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s22_q ? 4'h0 : select_2535;
      seen_column_q <= select_1503_s22_q ? 8'h0 : (seen_column_q + {7'h0, equal_1509});
      seen_rows_left_q <= select_2541;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s22_q ? 13'h0 : (seen_base_q + {6'h0, select_1506});
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
      averager_detail_0_q <= select_1645;
      averager_detail_1_q <= select_1653;
      census_columns_values_2_cell_2_mask_q <= select_1701;
      census_columns_values_2_cell_3_mask_q <= select_1704;
      census_columns_values_2_cell_4_mask_q <= select_1707;
      census_columns_values_3_cell_0_mask_q <= select_1708;
      census_columns_values_3_cell_1_mask_q <= select_1711;
      census_columns_values_3_cell_2_mask_q <= select_1712;
      census_columns_values_3_cell_3_mask_q <= select_1715;
      sharpness_last_mask_q <= and_370_s22_q ? whole_2_s22_q : sharpness_last_mask_q;
      box_textured_sum_sums_values_0_q <= select_2450;
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
  logic and_370_s23_q;
  logic so_s23_q;
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
  logic less_426_s23_q;
  logic less_427_s23_q;
  logic and_435_s23_q;
  logic whole_16_s23_q;
  logic and_461_s23_q;
  logic [11:0] sum_476_s23_q;
  logic [9:0] sum_479_s23_q;
  logic equal_1339_s23_q;
  logic not_1340_s23_q;
  logic equal_1384_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1390_s23_q;
  logic equal_1392_s23_q;
  logic equal_1394_s23_q;
  logic equal_1396_s23_q;
  logic equal_1398_s23_q;
  logic equal_1400_s23_q;
  logic equal_1402_s23_q;
  logic equal_1404_s23_q;
  logic equal_1406_s23_q;
  logic less_1415_s23_q;
  logic or_1419_s23_q;
  logic equal_1439_s23_q;
  logic and_1449_s23_q;
  logic not_1461_s23_q;
  logic not_1516_s23_q;
  logic [7:0] sum_1526_s23_q;
  logic equal_1542_s23_q;
  logic or_1547_s23_q;
  logic [23:0] select_1558_s23_q;
  logic not_1578_s23_q;
  logic less_1592_s23_q;
  logic and_1603_s23_q;
  logic [11:0] sum_1732_s23_q;
  logic [9:0] sum_1735_s23_q;
  logic equal_1743_s23_q;
  logic [27:0] select_1757_s23_q;
  logic and_1770_s23_q;
  logic and_1782_s23_q;
  logic [8:0] select_1789_s23_q;
  logic [8:0] select_1793_s23_q;
  logic equal_1796_s23_q;
  logic less_1797_s23_q;
  logic [11:0] select_1802_s23_q;
  logic equal_1840_s23_q;
  logic equal_1867_s23_q;
  logic and_1983_s23_q;
  logic and_2002_s23_q;
  logic not_2006_s23_q;
  logic not_2021_s23_q;
  logic [9:0] select_2032_s23_q;
  logic [9:0] select_2035_s23_q;
  logic equal_2091_s23_q;
  logic and_2118_s23_q;
  logic and_2120_s23_q;
  logic [11:0] residual_s23_q;
  logic equal_2222_s23_q;
  logic equal_2360_s23_q;
  logic or_2363_s23_q;
  logic equal_2366_s23_q;
  logic select_2372_s23_q;
  logic not_2377_s23_q;
  logic equal_2386_s23_q;
  logic equal_2388_s23_q;
  logic equal_2389_s23_q;
  logic equal_2518_s23_q;
  logic equal_2602_s23_q;
  logic [9:0] select_2612_s23_q;
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
      and_370_s23_q <= and_370_s22_q;
      so_s23_q <= so_s22_q;
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
      less_426_s23_q <= less_426_s22_q;
      less_427_s23_q <= less_427_s22_q;
      and_435_s23_q <= and_435_s22_q;
      whole_16_s23_q <= whole_16;
      and_461_s23_q <= census_columns_values_1_cell_2_mask_s22_q & and_435_s22_q;
      sum_476_s23_q <= {1'b0, sum_472} + {2'h0, sum_475_s22_q};
      sum_479_s23_q <= sum_479_s22_q;
      equal_1339_s23_q <= equal_1339_s22_q;
      not_1340_s23_q <= not_1340_s22_q;
      equal_1384_s23_q <= equal_1384_s22_q;
      all_s23_q <= all_s22_q;
      sum_1390_s23_q <= sum_1390_s22_q;
      equal_1392_s23_q <= equal_1392_s22_q;
      equal_1394_s23_q <= equal_1394_s22_q;
      equal_1396_s23_q <= equal_1396_s22_q;
      equal_1398_s23_q <= equal_1398_s22_q;
      equal_1400_s23_q <= equal_1400_s22_q;
      equal_1402_s23_q <= equal_1402_s22_q;
      equal_1404_s23_q <= equal_1404_s22_q;
      equal_1406_s23_q <= equal_1406_s22_q;
      less_1415_s23_q <= less_1415_s22_q;
      or_1419_s23_q <= or_1419_s22_q;
      equal_1439_s23_q <= (registration_fresh_q & select_1437_s22_q) == 4'h0;
      and_1449_s23_q <= not_1340_s22_q & and_1433;
      not_1461_s23_q <= not_1461_s22_q;
      not_1516_s23_q <= not_1516;
      sum_1526_s23_q <= {2'h0, x_s22_q[7:2]} + 8'hff;
      equal_1542_s23_q <= t[4:1] == 4'h0;
      or_1547_s23_q <= or_1547_s22_q;
      select_1558_s23_q <= select_1558;
      not_1578_s23_q <= ~({sum_1576, around_s22_q[0]} < {2'h0, t});
      less_1592_s23_q <= less_1592_s22_q;
      and_1603_s23_q <= and_1603_s22_q;
      sum_1732_s23_q <= {1'b0, sum_1728} + {2'h0, sum_1731_s22_q};
      sum_1735_s23_q <= sum_1735_s22_q;
      equal_1743_s23_q <= equal_1743_s22_q;
      select_1757_s23_q <= sample_pair_whole_s22_q ? {detail_2, detail} : 28'h0;
      and_1770_s23_q <= and_1770;
      and_1782_s23_q <= and_1782;
      select_1789_s23_q <= and_1770 ? contrast_s22_q : 9'h0;
      select_1793_s23_q <= and_1782 ? contrast_2_s22_q : 9'h0;
      equal_1796_s23_q <= x_s22_q[7:3] == 5'h0;
      less_1797_s23_q <= 7'h2 < {x_s22_q[4:0], slot_s22_q[2:1]};
      select_1802_s23_q <= select_1802;
      equal_1840_s23_q <= {x_s22_q[4:0], slot_s22_q} == 8'h0;
      equal_1867_s23_q <= equal_1867_s22_q;
      and_1983_s23_q <= and_1983_s22_q;
      and_2002_s23_q <= and_2002_s22_q;
      not_2006_s23_q <= not_2006_s22_q;
      not_2021_s23_q <= ~({sum_2019, e_s22_q[0]} < {2'h0, t});
      select_2032_s23_q <= select_2032_s22_q;
      select_2035_s23_q <= select_2035_s22_q;
      equal_2091_s23_q <= equal_2091_s22_q;
      and_2118_s23_q <= and_2118_s22_q;
      and_2120_s23_q <= and_2120_s22_q;
      residual_s23_q <= residual;
      equal_2222_s23_q <= (registration_fresh_q & select_2220) == 4'h0;
      equal_2360_s23_q <= select_2032_s22_q[9:3] == 7'h0;
      or_2363_s23_q <= or_2363;
      equal_2366_s23_q <= equal_2366_s22_q;
      select_2372_s23_q <= select_2372;
      not_2377_s23_q <= ~({sum_2375, select_2035_s22_q[0]} < {2'h0, select_2032_s22_q});
      equal_2386_s23_q <= equal_2386_s22_q;
      equal_2388_s23_q <= equal_2388_s22_q;
      equal_2389_s23_q <= equal_2389_s22_q;
      equal_2518_s23_q <= equal_2518_s22_q;
      equal_2602_s23_q <= (registration_fresh_q & select_2600) == 4'h0;
      select_2612_s23_q <= select_2612_s22_q;
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
  assign texture = sum_476_s23_q + {2'h0, sum_479_s23_q};
  // hls/stages/agreement.hpp:1234
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1201
  logic select_1514;
  assign select_1514 = marks_first_s23_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1187
  logic [10:0] sum_1515;
  assign sum_1515 = {1'b0, {5{select_1514}}, 1'b0, {2{select_1514}}, 1'b0, select_1514} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1053
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1526_s23_q[7]}}, sum_1526_s23_q, x_s23_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1187
  logic [10:0] sum_1528;
  assign sum_1528 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1043
  logic [47:0] select_1559;
  assign select_1559 = or_1547_s23_q ? {select_1558_s23_q[23], 1'b0, select_1558_s23_q[22], 1'b0, select_1558_s23_q[21], 1'b0, select_1558_s23_q[20], 1'b0, select_1558_s23_q[19], 1'b0, select_1558_s23_q[18], 1'b0, select_1558_s23_q[17], 1'b0, select_1558_s23_q[16], 1'b0, select_1558_s23_q[15], 1'b0, select_1558_s23_q[14], 1'b0, select_1558_s23_q[13], 1'b0, select_1558_s23_q[12], 1'b0, select_1558_s23_q[11], 1'b0, select_1558_s23_q[10], 1'b0, select_1558_s23_q[9], 1'b0, select_1558_s23_q[8], 1'b0, select_1558_s23_q[7], 1'b0, select_1558_s23_q[6], 1'b0, select_1558_s23_q[5], 1'b0, select_1558_s23_q[4], 1'b0, select_1558_s23_q[3], 1'b0, select_1558_s23_q[2], 1'b0, select_1558_s23_q[1], 1'b0, select_1558_s23_q[0], 1'b0} : {1'b0, select_1558_s23_q[23], 1'b0, select_1558_s23_q[22], 1'b0, select_1558_s23_q[21], 1'b0, select_1558_s23_q[20], 1'b0, select_1558_s23_q[19], 1'b0, select_1558_s23_q[18], 1'b0, select_1558_s23_q[17], 1'b0, select_1558_s23_q[16], 1'b0, select_1558_s23_q[15], 1'b0, select_1558_s23_q[14], 1'b0, select_1558_s23_q[13], 1'b0, select_1558_s23_q[12], 1'b0, select_1558_s23_q[11], 1'b0, select_1558_s23_q[10], 1'b0, select_1558_s23_q[9], 1'b0, select_1558_s23_q[8], 1'b0, select_1558_s23_q[7], 1'b0, select_1558_s23_q[6], 1'b0, select_1558_s23_q[5], 1'b0, select_1558_s23_q[4], 1'b0, select_1558_s23_q[3], 1'b0, select_1558_s23_q[2], 1'b0, select_1558_s23_q[1], 1'b0, select_1558_s23_q[0]};
  // hls/stages/agreement.hpp:507
  logic select_1716;
  assign select_1716 = and_370_s23_q ? census_columns_values_2_cell_4_mask_s23_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_1736;
  assign sum_1736 = sum_1732_s23_q + {2'h0, sum_1735_s23_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_1738;
  assign select_1738 = and_370_s23_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1739;
  assign select_1739 = and_370_s23_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_1758;
  assign select_1758 = and_370_s23_q ? select_1757_s23_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_1759;
  assign select_1759 = and_370_s23_q ? select_1757_s23_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1757_s23_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1757_s23_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_1790;
  assign sum_1790 = (equal_1743_s23_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1789_s23_q};
  logic [23:0] sum_1794;
  assign sum_1794 = (equal_1743_s23_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1793_s23_q};
  // hls/stages/census.hpp:409
  logic less_1798;
  assign less_1798 = x_s23_q[4:0] < 5'h3;
  logic [23:0] select_1803;
  assign select_1803 = slot_s23_q ? {select_1802_s23_q[11], 1'b0, select_1802_s23_q[10], 1'b0, select_1802_s23_q[9], 1'b0, select_1802_s23_q[8], 1'b0, select_1802_s23_q[7], 1'b0, select_1802_s23_q[6], 1'b0, select_1802_s23_q[5], 1'b0, select_1802_s23_q[4], 1'b0, select_1802_s23_q[3], 1'b0, select_1802_s23_q[2], 1'b0, select_1802_s23_q[1], 1'b0, select_1802_s23_q[0], 1'b0} : {1'b0, select_1802_s23_q[11], 1'b0, select_1802_s23_q[10], 1'b0, select_1802_s23_q[9], 1'b0, select_1802_s23_q[8], 1'b0, select_1802_s23_q[7], 1'b0, select_1802_s23_q[6], 1'b0, select_1802_s23_q[5], 1'b0, select_1802_s23_q[4], 1'b0, select_1802_s23_q[3], 1'b0, select_1802_s23_q[2], 1'b0, select_1802_s23_q[1], 1'b0, select_1802_s23_q[0]};
  // hls/stages/census.hpp:372
  logic and_1807;
  assign and_1807 = less_1798 & (~((sharpness_sums_contrast_1_q & select_1803) == 24'h0));
  logic and_1817;
  assign and_1817 = less_1798 & (~((sharpness_sums_contrast_0_q & select_1803) == 24'h0));
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2036;
  assign sum_2036 = {1'b0, select_2035_s23_q} + {3'h0, select_2035_s23_q[9:2]};
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2163;
  assign difference_2163 = 13'h0 - {residual_s23_q[11], residual_s23_q};
  logic less_2178;
  assign less_2178 = $signed(difference_2163) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1077
  logic select_2378;
  assign select_2378 = equal_2360_s23_q ? ((~or_2363_s23_q) & (~select_2372_s23_q)) : not_2377_s23_q;
  // hls/stages/agreement.hpp:1085
  logic [47:0] select_2380;
  assign select_2380 = x_s23_q[6] ? (equal_1384_s23_q ? good_q : {select_2378, good_q[47:1]}) : good_q;
  logic equal_2383;
  assign equal_2383 = x_s23_q == 7'h7f;
  // hls/stages/agreement.hpp:447
  logic [12:0] select_2521;
  assign select_2521 = equal_1867_s23_q ? (equal_2518_s23_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_2524;
  assign select_2524 = and_370_s23_q ? (equal_1867_s23_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
      sharpness_sums_contrast_0_q <= and_370_s23_q ? sum_1790 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_370_s23_q ? sum_1794 : sharpness_sums_contrast_1_q;
      good_q <= equal_1339_s23_q ? select_2380 : good_q;
      map_row_q <= and_370_s23_q ? select_2521 : map_row_q;
      map_width_q <= select_2524;
      write_half_q <= marks_first_s23_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1514;
      done_q <= not_1516_s23_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s23_q;
      said_q <= equal_1339_s23_q & equal_2383;
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
      census_columns_values_3_cell_4_mask_q <= select_1716;
      census_changes_values_0_left_q <= and_370_s23_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_370_s23_q ? sum_1736 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1738;
      census_changes_values_1_right_q <= select_1739;
      sharpness_last_detail_0_q <= select_1758;
      sharpness_last_detail_1_q <= select_1759;
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
  logic and_370_s24_q;
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
  logic less_426_s24_q;
  logic less_427_s24_q;
  logic and_435_s24_q;
  logic and_460_s24_q;
  logic and_461_s24_q;
  logic [12:0] sum_481_s24_q;
  logic equal_1339_s24_q;
  logic not_1340_s24_q;
  logic equal_1384_s24_q;
  logic all_s24_q;
  logic [1:0] sum_1390_s24_q;
  logic equal_1392_s24_q;
  logic equal_1394_s24_q;
  logic equal_1396_s24_q;
  logic equal_1398_s24_q;
  logic equal_1400_s24_q;
  logic equal_1402_s24_q;
  logic equal_1404_s24_q;
  logic equal_1406_s24_q;
  logic less_1415_s24_q;
  logic or_1419_s24_q;
  logic [31:0] registration_sums_rdata_s24_q;
  logic equal_1439_s24_q;
  logic and_1449_s24_q;
  logic not_1461_s24_q;
  logic [2:0] index_s24_q;
  logic [10:0] sum_1515_s24_q;
  logic and_1522_s24_q;
  logic less_1523_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1528_s24_q;
  logic equal_1542_s24_q;
  logic not_1562_s24_q;
  logic not_1578_s24_q;
  logic less_1592_s24_q;
  logic and_1603_s24_q;
  logic equal_1743_s24_q;
  logic [12:0] sum_1744_s24_q;
  logic [12:0] select_1772_s24_q;
  logic [12:0] select_1784_s24_q;
  logic equal_1796_s24_q;
  logic less_1797_s24_q;
  logic and_1807_s24_q;
  logic and_1817_s24_q;
  logic equal_1840_s24_q;
  logic and_1983_s24_q;
  logic and_2002_s24_q;
  logic not_2006_s24_q;
  logic not_2021_s24_q;
  logic [9:0] select_2032_s24_q;
  logic [9:0] select_2035_s24_q;
  logic less_2037_s24_q;
  logic equal_2091_s24_q;
  logic and_2118_s24_q;
  logic and_2120_s24_q;
  logic [7:0] residual_s24_q;
  logic less_2164_s24_q;
  logic less_2178_s24_q;
  logic equal_2222_s24_q;
  logic or_2363_s24_q;
  logic equal_2366_s24_q;
  logic select_2372_s24_q;
  logic equal_2383_s24_q;
  logic equal_2386_s24_q;
  logic equal_2388_s24_q;
  logic equal_2389_s24_q;
  logic equal_2602_s24_q;
  logic [9:0] select_2612_s24_q;
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
      and_370_s24_q <= and_370_s23_q;
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
      less_426_s24_q <= less_426_s23_q;
      less_427_s24_q <= less_427_s23_q;
      and_435_s24_q <= and_435_s23_q;
      and_460_s24_q <= whole_22 & and_435_s23_q;
      and_461_s24_q <= and_461_s23_q;
      sum_481_s24_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1339_s24_q <= equal_1339_s23_q;
      not_1340_s24_q <= not_1340_s23_q;
      equal_1384_s24_q <= equal_1384_s23_q;
      all_s24_q <= all_s23_q;
      sum_1390_s24_q <= sum_1390_s23_q;
      equal_1392_s24_q <= equal_1392_s23_q;
      equal_1394_s24_q <= equal_1394_s23_q;
      equal_1396_s24_q <= equal_1396_s23_q;
      equal_1398_s24_q <= equal_1398_s23_q;
      equal_1400_s24_q <= equal_1400_s23_q;
      equal_1402_s24_q <= equal_1402_s23_q;
      equal_1404_s24_q <= equal_1404_s23_q;
      equal_1406_s24_q <= equal_1406_s23_q;
      less_1415_s24_q <= less_1415_s23_q;
      or_1419_s24_q <= or_1419_s23_q;
      registration_sums_rdata_s24_q <= registration_sums_rdata_q;
      equal_1439_s24_q <= equal_1439_s23_q;
      and_1449_s24_q <= and_1449_s23_q;
      not_1461_s24_q <= not_1461_s23_q;
      index_s24_q <= index[2:0];
      sum_1515_s24_q <= sum_1515;
      and_1522_s24_q <= began_q & (seen_x_q == 4'h0);
      less_1523_s24_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s24_q <= index_2[2:0];
      sum_1528_s24_q <= sum_1528;
      equal_1542_s24_q <= equal_1542_s23_q;
      not_1562_s24_q <= ~((good_q & select_1559) == 48'h0);
      not_1578_s24_q <= not_1578_s23_q;
      less_1592_s24_q <= less_1592_s23_q;
      and_1603_s24_q <= and_1603_s23_q;
      equal_1743_s24_q <= equal_1743_s23_q;
      sum_1744_s24_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1736};
      select_1772_s24_q <= and_1770_s23_q ? detail_3[14:2] : 13'h0;
      select_1784_s24_q <= and_1782_s23_q ? detail_4[14:2] : 13'h0;
      equal_1796_s24_q <= equal_1796_s23_q;
      less_1797_s24_q <= less_1797_s23_q;
      and_1807_s24_q <= and_1807;
      and_1817_s24_q <= and_1817;
      equal_1840_s24_q <= equal_1840_s23_q;
      and_1983_s24_q <= and_1983_s23_q;
      and_2002_s24_q <= and_2002_s23_q;
      not_2006_s24_q <= not_2006_s23_q;
      not_2021_s24_q <= not_2021_s23_q;
      select_2032_s24_q <= select_2032_s23_q;
      select_2035_s24_q <= select_2035_s23_q;
      less_2037_s24_q <= {sum_2036, select_2035_s23_q[1:0]} < {3'h0, select_2032_s23_q};
      equal_2091_s24_q <= equal_2091_s23_q;
      and_2118_s24_q <= and_2118_s23_q;
      and_2120_s24_q <= and_2120_s23_q;
      residual_s24_q <= residual_s23_q[7:0];
      less_2164_s24_q <= $signed(difference_2163) < $signed({7'h0, cfg_moved_limit_i});
      less_2178_s24_q <= less_2178;
      equal_2222_s24_q <= equal_2222_s23_q;
      or_2363_s24_q <= or_2363_s23_q;
      equal_2366_s24_q <= equal_2366_s23_q;
      select_2372_s24_q <= select_2372_s23_q;
      equal_2383_s24_q <= equal_2383;
      equal_2386_s24_q <= equal_2386_s23_q;
      equal_2388_s24_q <= equal_2388_s23_q;
      equal_2389_s24_q <= equal_2389_s23_q;
      equal_2602_s24_q <= equal_2602_s23_q;
      select_2612_s24_q <= select_2612_s23_q;
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
  logic [13:0] sum_482;
  assign sum_482 = {2'h0, census_changes_values_1_left_s24_q} + {1'b0, sum_481_s24_q};
  logic [13:0] sum_483;
  assign sum_483 = {2'h0, census_changes_values_2_left_q} + sum_482;
  // hls/stages/agreement.hpp:976
  logic and_1563;
  assign and_1563 = good_known_q & not_1562_s24_q;
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_1542_s24_q ? and_1563 : not_1578_s24_q;
  // hls/stages/agreement.hpp:507
  logic [11:0] select_1740;
  assign select_1740 = and_370_s24_q ? census_changes_values_1_left_s24_q : census_changes_values_2_left_q;
  logic [11:0] select_1741;
  assign select_1741 = and_370_s24_q ? census_changes_values_1_right_s24_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_1745;
  assign sum_1745 = {2'h0, census_changes_values_1_right_s24_q} + {1'b0, sum_1744_s24_q};
  logic [13:0] sum_1746;
  assign sum_1746 = {2'h0, census_changes_values_2_right_q} + sum_1745;
  // hls/stages/census.hpp:357
  logic [23:0] select_1774;
  assign select_1774 = equal_1743_s24_q ? {11'h0, select_1772_s24_q} : (sharpness_sums_detail_0_q + {11'h0, select_1772_s24_q});
  logic [23:0] select_1786;
  assign select_1786 = equal_1743_s24_q ? {11'h0, select_1784_s24_q} : (sharpness_sums_detail_1_q + {11'h0, select_1784_s24_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_1809;
  assign select_1809 = (less_1797_s24_q & and_1807_s24_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_1819;
  assign select_1819 = (less_1797_s24_q & and_1817_s24_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:207
  logic [1:0] select_1828;
  assign select_1828 = equal_1796_s24_q ? {sharpness_comparing_contrast_0_q[0], and_1817_s24_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_1830;
  assign select_1830 = equal_1796_s24_q ? {sharpness_comparing_contrast_1_q[0], and_1807_s24_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_1853;
  assign xor_1853 = sharpness_comparing_contrast_0_q[1] ^ and_1807_s24_q;
  logic select_1856;
  assign select_1856 = (equal_1840_s24_q | xor_1853) ? (and_1807_s24_q & xor_1853) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_1857;
  assign select_1857 = equal_1796_s24_q ? select_1856 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_1859;
  assign xor_1859 = sharpness_comparing_contrast_1_q[1] ^ and_1817_s24_q;
  logic select_1862;
  assign select_1862 = (equal_1840_s24_q | xor_1859) ? (and_1817_s24_q & xor_1859) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_1863;
  assign select_1863 = equal_1796_s24_q ? select_1862 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2004;
  assign select_2004 = and_1983_s24_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2002_s24_q});
  // hls/stages/agreement.hpp:1048
  logic not_2023;
  assign not_2023 = ~(equal_1542_s24_q ? and_1563 : not_2021_s24_q);
  // hls/stages/agreement.hpp:402
  logic and_2026;
  assign and_2026 = ends_cell_s24_q & (not_2006_s24_q & (centres_values_1_textured_s24_q & not_2023));
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_2039;
  assign select_2039 = ((~(select_2032_s24_q[9:4] == 6'h0)) & less_2037_s24_q) ? select_2032_s24_q : 10'h0;
  // hls/stages/agreement.hpp:402
  logic [9:0] select_2042;
  assign select_2042 = equal_1339_s24_q ? (x_s24_q[6] ? (equal_1384_s24_q ? 10'h0 : select_2039) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1052
  logic and_2060;
  assign and_2060 = centres_values_1_textured_s24_q & (centres_values_1_of_skin_s24_q & not_2023);
  // hls/stages/registration.hpp:107
  logic [7:0] select_2146;
  assign select_2146 = equal_2091_s24_q ? (and_2120_s24_q ? residual_s24_q : 8'h0) : 8'h0;
  logic and_2157;
  assign and_2157 = and_2120_s24_q & ($signed(residual_s24_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2171;
  assign less_2171 = $signed(residual_s24_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1074
  logic [11:0] select_2224;
  assign select_2224 = or_1419_s24_q ? 12'h0 : (equal_2222_s24_q ? registration_sums_rdata_s24_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2226;
  assign select_2226 = equal_1384_s24_q ? 12'h0 : (less_1415_s24_q ? select_2224 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2229;
  assign and_2229 = x_s24_q[1] & all_s24_q;
  // hls/stages/agreement.hpp:1085
  logic and_2232;
  assign and_2232 = not_1461_s24_q & (less_1415_s24_q & ({and_2229, x_s24_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1074
  logic [11:0] select_2239;
  assign select_2239 = or_1419_s24_q ? 12'h0 : (equal_2222_s24_q ? registration_sums_rdata_s24_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2241;
  assign select_2241 = equal_1384_s24_q ? 12'h0 : (less_1415_s24_q ? select_2239 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2247;
  assign not_2247 = ~all_s24_q;
  // hls/stages/agreement.hpp:1085
  logic and_2250;
  assign and_2250 = not_1461_s24_q & (less_1415_s24_q & (x_s24_q[2:0] == {all_s24_q, not_2247, 1'b0}));
  // hls/stages/agreement.hpp:402
  logic and_2256;
  assign and_2256 = equal_1339_s24_q & (x_s24_q[6] & (not_1461_s24_q & (less_1415_s24_q & all_s24_q)));
  // hls/stages/registration.hpp:157
  logic equal_2283;
  assign equal_2283 = x_s24_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1085
  logic and_2286;
  assign and_2286 = not_1461_s24_q & (less_1415_s24_q & (x_s24_q[5] ? x_s24_q[3] : equal_2283));
  logic and_2295;
  assign and_2295 = not_1461_s24_q & (less_1415_s24_q & ((~x_s24_q[5]) & (x_s24_q[3] & equal_2283)));
  // hls/stages/agreement.hpp:402
  logic select_2385;
  assign select_2385 = equal_1339_s24_q ? ((x_s24_q[6] & good_known_q) | equal_2383_s24_q) : good_known_q;
  // hls/stages/agreement.hpp:1234
  logic and_2547;
  assign and_2547 = and_1603_s24_q & ({sum_1528_s24_q, index_2_s24_q} == {sum_1515_s24_q, index_s24_q});
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_2604;
  assign select_2604 = equal_1406_s24_q ? {2'h0, counts_explained_s24_q, 2'h0, counts_textured_s24_q} : (equal_2602_s24_q ? registration_sums_rdata_s24_q : 32'h0);
  logic [31:0] select_2605;
  assign select_2605 = equal_1404_s24_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s24_q} : select_2604;

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1329; read in stage 24, written in stage 25: 24 < 25 < 24 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1515_s24_q, index_s24_q};
  logic map_re;
  assign map_re = s24_en & (and_1522_s24_q & less_1523_s24_q);
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
      sharpness_sums_detail_0_q <= and_370_s24_q ? select_1774 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_370_s24_q ? select_1786 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_1828 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_1830 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_1857 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_1863 : sharpness_comparing_less_contrast_1_q;
      counts_nearer_q <= select_2004;
      good_known_q <= select_2385;
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
      census_changes_values_2_left_q <= select_1740;
      census_changes_values_2_right_q <= select_1741;
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
  logic and_370_s25_q;
  logic so_s25_q;
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
  logic less_426_s25_q;
  logic less_427_s25_q;
  logic and_435_s25_q;
  logic and_460_s25_q;
  logic and_461_s25_q;
  logic [8:0] sum_483_s25_q;
  logic equal_1339_s25_q;
  logic not_1340_s25_q;
  logic equal_1384_s25_q;
  logic [1:0] sum_1390_s25_q;
  logic equal_1392_s25_q;
  logic equal_1394_s25_q;
  logic equal_1396_s25_q;
  logic equal_1398_s25_q;
  logic equal_1400_s25_q;
  logic equal_1402_s25_q;
  logic less_1415_s25_q;
  logic [19:0] select_1440_s25_q;
  logic [11:0] select_1445_s25_q;
  logic and_1449_s25_q;
  logic not_1461_s25_q;
  logic and_1522_s25_q;
  logic less_1523_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1528_s25_q;
  logic is_seen_s25_q;
  logic and_1593_s25_q;
  logic and_1603_s25_q;
  logic equal_1743_s25_q;
  logic [8:0] sum_1746_s25_q;
  logic equal_1796_s25_q;
  logic less_1797_s25_q;
  logic [17:0] select_1809_s25_q;
  logic [17:0] select_1819_s25_q;
  logic equal_1840_s25_q;
  logic and_1983_s25_q;
  logic and_2028_s25_q;
  logic [9:0] select_2032_s25_q;
  logic [9:0] select_2035_s25_q;
  logic [9:0] select_2042_s25_q;
  logic and_2063_s25_q;
  logic equal_2091_s25_q;
  logic and_2118_s25_q;
  logic and_2120_s25_q;
  logic [7:0] select_2148_s25_q;
  logic and_2157_s25_q;
  logic and_2165_s25_q;
  logic and_2172_s25_q;
  logic and_2179_s25_q;
  logic [11:0] select_2226_s25_q;
  logic and_2234_s25_q;
  logic [11:0] select_2241_s25_q;
  logic and_2252_s25_q;
  logic and_2256_s25_q;
  logic and_2288_s25_q;
  logic and_2296_s25_q;
  logic or_2363_s25_q;
  logic equal_2366_s25_q;
  logic select_2372_s25_q;
  logic equal_2383_s25_q;
  logic equal_2386_s25_q;
  logic equal_2388_s25_q;
  logic equal_2389_s25_q;
  logic and_2532_s25_q;
  logic and_2547_s25_q;
  logic [31:0] select_2605_s25_q;
  logic [9:0] select_2612_s25_q;
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
      and_370_s25_q <= and_370_s24_q;
      so_s25_q <= drew_q;
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
      less_426_s25_q <= less_426_s24_q;
      less_427_s25_q <= less_427_s24_q;
      and_435_s25_q <= and_435_s24_q;
      and_460_s25_q <= and_460_s24_q;
      and_461_s25_q <= and_461_s24_q;
      sum_483_s25_q <= sum_483[13:5];
      equal_1339_s25_q <= equal_1339_s24_q;
      not_1340_s25_q <= not_1340_s24_q;
      equal_1384_s25_q <= equal_1384_s24_q;
      sum_1390_s25_q <= sum_1390_s24_q;
      equal_1392_s25_q <= equal_1392_s24_q;
      equal_1394_s25_q <= equal_1394_s24_q;
      equal_1396_s25_q <= equal_1396_s24_q;
      equal_1398_s25_q <= equal_1398_s24_q;
      equal_1400_s25_q <= equal_1400_s24_q;
      equal_1402_s25_q <= equal_1402_s24_q;
      less_1415_s25_q <= less_1415_s24_q;
      select_1440_s25_q <= equal_1439_s24_q ? registration_sums_rdata_s24_q[19:0] : 20'h0;
      select_1445_s25_q <= equal_1439_s24_q ? registration_sums_rdata_s24_q[31:20] : 12'h0;
      and_1449_s25_q <= and_1449_s24_q;
      not_1461_s25_q <= not_1461_s24_q;
      and_1522_s25_q <= and_1522_s24_q;
      less_1523_s25_q <= less_1523_s24_q;
      index_2_s25_q <= index_2_s24_q;
      sum_1528_s25_q <= sum_1528_s24_q;
      is_seen_s25_q <= is_seen;
      and_1593_s25_q <= is_seen & less_1592_s24_q;
      and_1603_s25_q <= and_1603_s24_q;
      equal_1743_s25_q <= equal_1743_s24_q;
      sum_1746_s25_q <= sum_1746[13:5];
      equal_1796_s25_q <= equal_1796_s24_q;
      less_1797_s25_q <= less_1797_s24_q;
      select_1809_s25_q <= select_1809;
      select_1819_s25_q <= select_1819;
      equal_1840_s25_q <= equal_1840_s24_q;
      and_1983_s25_q <= and_1983_s24_q;
      and_2028_s25_q <= not_1340_s24_q & (drew_q & and_2026);
      select_2032_s25_q <= select_2032_s24_q;
      select_2035_s25_q <= select_2035_s24_q;
      select_2042_s25_q <= select_2042;
      and_2063_s25_q <= drew_q & (ends_cell_s24_q & (not_2006_s24_q & and_2060));
      equal_2091_s25_q <= equal_2091_s24_q;
      and_2118_s25_q <= and_2118_s24_q;
      and_2120_s25_q <= and_2120_s24_q;
      select_2148_s25_q <= equal_1339_s24_q ? 8'h0 : (drew_q ? select_2146 : 8'h0);
      and_2157_s25_q <= and_2157;
      and_2165_s25_q <= and_2120_s24_q & less_2164_s24_q;
      and_2172_s25_q <= and_2120_s24_q & less_2171;
      and_2179_s25_q <= and_2120_s24_q & less_2178_s24_q;
      select_2226_s25_q <= select_2226;
      and_2234_s25_q <= equal_1339_s24_q & (x_s24_q[6] & and_2232);
      select_2241_s25_q <= select_2241;
      and_2252_s25_q <= equal_1339_s24_q & (x_s24_q[6] & and_2250);
      and_2256_s25_q <= and_2256;
      and_2288_s25_q <= equal_1339_s24_q & (x_s24_q[6] & and_2286);
      and_2296_s25_q <= x_s24_q[6] & and_2295;
      or_2363_s25_q <= or_2363_s24_q;
      equal_2366_s25_q <= equal_2366_s24_q;
      select_2372_s25_q <= select_2372_s24_q;
      equal_2383_s25_q <= equal_2383_s24_q;
      equal_2386_s25_q <= equal_2386_s24_q;
      equal_2388_s25_q <= equal_2388_s24_q;
      equal_2389_s25_q <= equal_2389_s24_q;
      and_2532_s25_q <= said_q;
      and_2547_s25_q <= and_2547;
      select_2605_s25_q <= select_2605;
      select_2612_s25_q <= select_2612_s24_q;
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
  // hls/stages/registration.hpp:265
  logic equal_1441;
  assign equal_1441 = sum_1390_s25_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1390_s25_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1443;
  assign select_1443 = equal_1441 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1390_s25_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1447;
  assign select_1447 = equal_1441 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1809_s25_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_1812;
  assign select_1812 = equal_1796_s25_q ? (less_1797_s25_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1819_s25_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_1822;
  assign select_1822 = equal_1796_s25_q ? (less_1797_s25_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2030;
  assign select_2030 = and_1983_s25_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2028_s25_q});
  logic [13:0] select_2044;
  assign select_2044 = and_1983_s25_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2042_s25_q});
  // hls/stages/agreement.hpp:402
  logic and_2064;
  assign and_2064 = not_1340_s25_q & and_2063_s25_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2066;
  assign select_2066 = and_1983_s25_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2064});
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2149;
  assign sum_2149 = registration_half_across_q + {{6{select_2148_s25_q[7]}}, select_2148_s25_q};
  // hls/stages/agreement.hpp:402
  logic and_2153;
  assign and_2153 = not_1340_s25_q & (so_s25_q & (and_2120_s25_q & equal_2091_s25_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2155;
  assign select_2155 = and_2118_s25_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2153});
  // hls/stages/agreement.hpp:402
  logic [1:0] select_2159;
  assign select_2159 = so_s25_q ? (equal_2091_s25_q ? {and_2157_s25_q, and_2120_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2160;
  assign select_2160 = equal_1339_s25_q ? 2'h0 : select_2159;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2161;
  assign sum_2161 = registration_half_votes_down_q + {{5{select_2160[1]}}, select_2160};
  // hls/stages/agreement.hpp:402
  logic [1:0] select_2167;
  assign select_2167 = so_s25_q ? (equal_2091_s25_q ? {and_2165_s25_q, and_2120_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2168;
  assign select_2168 = equal_1339_s25_q ? 2'h0 : select_2167;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2169;
  assign sum_2169 = registration_half_votes_up_q + {{5{select_2168[1]}}, select_2168};
  // hls/stages/agreement.hpp:402
  logic [1:0] select_2174;
  assign select_2174 = so_s25_q ? (equal_2091_s25_q ? {and_2172_s25_q, and_2120_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2175;
  assign select_2175 = equal_1339_s25_q ? 2'h0 : select_2174;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2176;
  assign sum_2176 = registration_half_half_votes_down_q + {{5{select_2175[1]}}, select_2175};
  // hls/stages/agreement.hpp:402
  logic [1:0] select_2181;
  assign select_2181 = so_s25_q ? (equal_2091_s25_q ? {and_2179_s25_q, and_2120_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2182;
  assign select_2182 = equal_1339_s25_q ? 2'h0 : select_2181;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2183;
  assign sum_2183 = registration_half_half_votes_up_q + {{5{select_2182[1]}}, select_2182};
  // hls/stages/agreement.hpp:402
  logic and_2217;
  assign and_2217 = equal_1339_s25_q & (x_s25_q[6] & (not_1461_s25_q & less_1415_s25_q));
  logic [11:0] select_2228;
  assign select_2228 = equal_1339_s25_q ? (x_s25_q[6] ? select_2226_s25_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2236;
  assign sum_2236 = {{2{select_2228[11]}}, select_2228} + (and_2234_s25_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:402
  logic [11:0] select_2243;
  assign select_2243 = equal_1339_s25_q ? (x_s25_q[6] ? select_2241_s25_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2245;
  assign sum_2245 = {{2{select_2243[11]}}, select_2243} + (and_2234_s25_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2257;
  assign not_2257 = ~and_2256_s25_q;
  logic less_2258;
  assign less_2258 = $signed({9'h1, {2{not_2257}}, and_2256_s25_q}) < $signed(registration_up_q[13:2]);
  logic select_2259;
  assign select_2259 = and_2252_s25_q ? less_2258 : registration_enough_q;
  // hls/stages/agreement.hpp:1085
  logic and_2263;
  assign and_2263 = x_s25_q[6] & (not_1461_s25_q & (less_1415_s25_q & (x_s25_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:402
  logic and_2264;
  assign and_2264 = equal_1339_s25_q & and_2263;
  // hls/stages/registration.hpp:242
  logic less_2265;
  assign less_2265 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2267;
  assign less_2267 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1085
  logic and_2272;
  assign and_2272 = x_s25_q[6] & (not_1461_s25_q & (less_1415_s25_q & (x_s25_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:402
  logic and_2273;
  assign and_2273 = equal_1339_s25_q & and_2272;
  // hls/stages/agreement.hpp:1085
  logic and_2280;
  assign and_2280 = x_s25_q[6] & (not_1461_s25_q & (less_1415_s25_q & (x_s25_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2298;
  assign and_2298 = registration_votes_up_q & registration_other_down_q;
  logic select_2300;
  assign select_2300 = registration_votes_down_q ? (registration_other_up_q | and_2298) : and_2298;
  // hls/stages/registration.hpp:138
  logic and_2302;
  assign and_2302 = (equal_1339_s25_q & and_2296_s25_q) & (registration_other_enough_q & select_2300);
  logic and_2304;
  assign and_2304 = registration_enough_q & ((and_2288_s25_q & (less_2267 | less_2265)) | and_2302);
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_2391;
  assign select_2391 = equal_2388_s25_q ? counts_skin_unproven_q : (equal_2389_s25_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2386_s25_q ? counts_nearer_s25_q : select_2391;
  // hls/stages/agreement.hpp:402
  logic and_2562;
  assign and_2562 = equal_1339_s25_q & (equal_2383_s25_q & (cfg_prove_i & (~proven_q)));
  logic and_2596;
  assign and_2596 = equal_1339_s25_q & (x_s25_q[6] & (not_1461_s25_q | (4'hc < x_s25_q[5:2])));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_2606;
  assign select_2606 = equal_1402_s25_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_2605_s25_q;
  logic [31:0] select_2607;
  assign select_2607 = equal_1400_s25_q ? {8'h0, sharpness_sums_detail_0_s25_q} : select_2606;
  logic [31:0] select_2608;
  assign select_2608 = equal_1398_s25_q ? {8'h0, sharpness_sums_detail_1_s25_q} : select_2607;
  logic [31:0] select_2609;
  assign select_2609 = equal_1396_s25_q ? {8'h0, sharpness_sums_contrast_0_s25_q} : select_2608;
  logic [31:0] select_2610;
  assign select_2610 = equal_1394_s25_q ? {8'h0, sharpness_sums_contrast_1_s25_q} : select_2609;

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1528_s25_q, index_2_s25_q};
  logic map_we;
  assign map_we = s25_en & and_1603_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1593_s25_q, is_seen_s25_q};
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
      sharpness_comparing_rest_0_q <= so_s25_q ? select_1812 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s25_q ? select_1822 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2030;
      counts_regions_bad_q <= select_2044;
      counts_skin_unproven_q <= select_2066;
      registration_half_across_q <= and_2118_s25_q ? 14'h0 : sum_2149;
      registration_half_measured_q <= select_2155;
      registration_half_votes_down_q <= and_2118_s25_q ? 7'h0 : sum_2161;
      registration_half_votes_up_q <= and_2118_s25_q ? 7'h0 : sum_2169;
      registration_half_half_votes_down_q <= and_2118_s25_q ? 7'h0 : sum_2176;
      registration_half_half_votes_up_q <= and_2118_s25_q ? 7'h0 : sum_2183;
      registration_down_q <= and_2217 ? sum_2236 : registration_down_q;
      registration_up_q <= and_2217 ? sum_2245 : registration_up_q;
      registration_enough_q <= select_2259;
      registration_votes_down_q <= and_2264 ? less_2265 : registration_votes_down_q;
      registration_votes_up_q <= and_2264 ? less_2267 : registration_votes_up_q;
      registration_other_enough_q <= and_2273 ? select_2259 : registration_other_enough_q;
      registration_other_down_q <= and_2273 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2273 ? registration_votes_up_q : registration_other_up_q;
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
  logic and_370_s26_q;
  logic so_s26_q;
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
  logic less_426_s26_q;
  logic less_427_s26_q;
  logic and_435_s26_q;
  logic and_460_s26_q;
  logic and_461_s26_q;
  logic less_484_s26_q;
  logic equal_1339_s26_q;
  logic equal_1384_s26_q;
  logic [1:0] sum_1390_s26_q;
  logic equal_1392_s26_q;
  logic [19:0] sum_1444_s26_q;
  logic [11:0] sum_1448_s26_q;
  logic and_1449_s26_q;
  logic and_1522_s26_q;
  logic less_1523_s26_q;
  logic [1:0] map_rdata_s26_q;
  logic is_seen_s26_q;
  logic and_1593_s26_q;
  logic equal_1743_s26_q;
  logic and_1748_s26_q;
  logic equal_1796_s26_q;
  logic sum_s26_q;
  logic sum_2_s26_q;
  logic equal_1840_s26_q;
  logic select_1858_s26_q;
  logic select_1864_s26_q;
  logic [9:0] select_2032_s26_q;
  logic [9:0] select_2035_s26_q;
  logic not_2282_s26_q;
  logic and_2304_s26_q;
  logic or_2363_s26_q;
  logic equal_2366_s26_q;
  logic select_2372_s26_q;
  logic equal_2383_s26_q;
  logic and_2387_s26_q;
  logic [13:0] before_v_4_s26_q;
  logic not_2424_s26_q;
  logic or_2428_s26_q;
  logic and_2532_s26_q;
  logic and_2547_s26_q;
  logic and_2562_s26_q;
  logic and_2596_s26_q;
  logic [5:0] select_2598_s26_q;
  logic [31:0] select_2610_s26_q;
  logic [9:0] select_2612_s26_q;
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
      and_370_s26_q <= and_370_s25_q;
      so_s26_q <= so_s25_q;
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
      less_426_s26_q <= less_426_s25_q;
      less_427_s26_q <= less_427_s25_q;
      and_435_s26_q <= and_435_s25_q;
      and_460_s26_q <= and_460_s25_q;
      and_461_s26_q <= and_461_s25_q;
      less_484_s26_q <= 9'h4 < sum_483_s25_q;
      equal_1339_s26_q <= equal_1339_s25_q;
      equal_1384_s26_q <= equal_1384_s25_q;
      sum_1390_s26_q <= sum_1390_s25_q;
      equal_1392_s26_q <= equal_1392_s25_q;
      sum_1444_s26_q <= select_1440_s25_q + {{6{select_1443[13]}}, select_1443};
      sum_1448_s26_q <= select_1445_s25_q + {{5{select_1447[6]}}, select_1447};
      and_1449_s26_q <= and_1449_s25_q;
      and_1522_s26_q <= and_1522_s25_q;
      less_1523_s26_q <= less_1523_s25_q;
      map_rdata_s26_q <= map_rdata_q;
      is_seen_s26_q <= is_seen_s25_q;
      and_1593_s26_q <= and_1593_s25_q;
      equal_1743_s26_q <= equal_1743_s25_q;
      and_1748_s26_q <= and_460_s25_q & (9'h4 < sum_1746_s25_q);
      equal_1796_s26_q <= equal_1796_s25_q;
      sum_s26_q <= sum[0];
      sum_2_s26_q <= sum_2[0];
      equal_1840_s26_q <= equal_1840_s25_q;
      select_1858_s26_q <= sharpness_comparing_less_contrast_0_q;
      select_1864_s26_q <= sharpness_comparing_less_contrast_1_q;
      select_2032_s26_q <= select_2032_s25_q;
      select_2035_s26_q <= select_2035_s25_q;
      not_2282_s26_q <= ~(equal_1339_s25_q & and_2280);
      and_2304_s26_q <= and_2304;
      or_2363_s26_q <= or_2363_s25_q;
      equal_2366_s26_q <= equal_2366_s25_q;
      select_2372_s26_q <= select_2372_s25_q;
      equal_2383_s26_q <= equal_2383_s25_q;
      and_2387_s26_q <= equal_2386_s25_q & equal_2366_s25_q;
      before_v_4_s26_q <= before_v_4;
      not_2424_s26_q <= ~(equal_2389_s25_q & equal_2366_s25_q);
      or_2428_s26_q <= (equal_2389_s25_q | equal_2388_s25_q) | (x_s25_q[6:3] == 4'hf);
      and_2532_s26_q <= and_2532_s25_q;
      and_2547_s26_q <= and_2547_s25_q;
      and_2562_s26_q <= and_2562;
      and_2596_s26_q <= and_2596;
      select_2598_s26_q <= equal_1339_s25_q ? (x_s25_q[6] ? x_s25_q[5:0] : 6'h0) : 6'h0;
      select_2610_s26_q <= select_2610;
      select_2612_s26_q <= select_2612_s25_q;
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
  logic and_485;
  assign and_485 = and_435_s26_q & less_484_s26_q;
  // hls/stages/census.hpp:306
  logic and_1749;
  assign and_1749 = and_460_s26_q & less_484_s26_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_1750;
  assign sum_1750 = census_left_misses_q + {{17{and_1749}}, and_1748_s26_q, 1'b0, and_1748_s26_q};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_1752;
  assign select_1752 = and_370_s26_q ? (equal_1743_s26_q ? 20'h0 : sum_1750) : census_left_misses_q;
  // hls/stages/agreement.hpp:207
  logic [2:0] select_1824;
  assign select_1824 = equal_1796_s26_q ? {sharpness_comparing_product_0_q[1:0], sum_s26_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_1826;
  assign select_1826 = equal_1796_s26_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s26_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s26_q});
  // hls/stages/agreement.hpp:207
  logic select_1835;
  assign select_1835 = so_s26_q ? (equal_1796_s26_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s26_q});
  // hls/stages/agreement.hpp:207
  logic select_1838;
  assign select_1838 = equal_1796_s26_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_1841;
  assign xor_1841 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_1847;
  assign xor_1847 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_s26_q} - {1'b0, before_v_4_s26_q};
  // hls/stages/agreement.hpp:1161
  logic select_2394;
  assign select_2394 = and_2387_s26_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1234
  logic [1:0] select_2548;
  assign select_2548 = and_2547_s26_q ? {and_1593_s26_q, is_seen_s26_q} : map_rdata_s26_q;
  // hls/stages/agreement.hpp:1235
  logic and_2549;
  assign and_2549 = proven_q & less_2537;
  // hls/stages/agreement.hpp:402
  logic and_2574;
  assign and_2574 = equal_1339_s26_q & (equal_2383_s26_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:1088
  logic or_2576;
  assign or_2576 = select_1858_s26_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:1085
  logic [31:0] select_2613;
  assign select_2613 = equal_1384_s26_q ? (equal_1392_s26_q ? 32'h0 : select_2610_s26_q) : {2'h0, select_2612_s26_q, select_2035_s26_q, select_2032_s26_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s26_q;
  logic fresh_we;
  assign fresh_we = s26_en & and_370_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s26_q, and_485, and_461_s26_q, and_460_s26_q, and_435_s26_q, less_427_s26_q, less_426_s26_q, less_425_s26_q, less_424_s26_q, less_423_s26_q, less_422_s26_q, less_421_s26_q, less_420_s26_q, less_419_s26_q, less_418_s26_q, less_417_s26_q, less_416_s26_q, less_415_s26_q, less_414_s26_q, less_413_s26_q, less_412_s26_q, less_411_s26_q, less_410_s26_q, less_409_s26_q, less_408_s26_q, less_407_s26_q, less_406_s26_q, less_405_s26_q, less_404_s26_q};
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
  assign registration_sums_waddr = {sum_1390_s26_q, lower_half_s26_q, registration_of_right_s26_q};
  logic registration_sums_we;
  assign registration_sums_we = s26_en & and_1449_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1448_s26_q, sum_1444_s26_q};
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
      census_left_misses_q <= select_1752;
      sharpness_comparing_product_0_q <= so_s26_q ? select_1824 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s26_q ? select_1826 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_1835;
      sharpness_comparing_carry_1_q <= so_s26_q ? select_1838 : sharpness_comparing_carry_1_q;
      registration_moved_q <= not_2282_s26_q & (registration_moved_q | and_2304_s26_q);
      hides_q <= equal_1339_s26_q ? select_2394 : hides_q;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic so_s27_q;
  logic equal_1339_s27_q;
  logic and_1522_s27_q;
  logic less_1523_s27_q;
  logic equal_1796_s27_q;
  logic or_1842_s27_q;
  logic and_1843_s27_q;
  logic or_1848_s27_q;
  logic and_1849_s27_q;
  logic select_1864_s27_q;
  logic or_2363_s27_q;
  logic select_2372_s27_q;
  logic equal_2383_s27_q;
  logic select_2394_s27_q;
  logic and_2422_s27_q;
  logic not_2424_s27_q;
  logic or_2428_s27_q;
  logic and_2532_s27_q;
  logic and_2550_s27_q;
  logic and_2553_s27_q;
  logic and_2562_s27_q;
  logic and_2574_s27_q;
  logic or_2576_s27_q;
  logic and_2596_s27_q;
  logic [5:0] select_2598_s27_q;
  logic [31:0] select_2615_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      so_s27_q <= so_s26_q;
      equal_1339_s27_q <= equal_1339_s26_q;
      and_1522_s27_q <= and_1522_s26_q;
      less_1523_s27_q <= less_1523_s26_q;
      equal_1796_s27_q <= equal_1796_s26_q;
      or_1842_s27_q <= equal_1840_s26_q | xor_1841;
      and_1843_s27_q <= five_times[0] & xor_1841;
      or_1848_s27_q <= equal_1840_s26_q | xor_1847;
      and_1849_s27_q <= five_times_2[0] & xor_1847;
      select_1864_s27_q <= select_1864_s26_q;
      or_2363_s27_q <= or_2363_s26_q;
      select_2372_s27_q <= select_2372_s26_q;
      equal_2383_s27_q <= equal_2383_s26_q;
      select_2394_s27_q <= select_2394;
      and_2422_s27_q <= over[14] & equal_2366_s26_q;
      not_2424_s27_q <= not_2424_s26_q;
      or_2428_s27_q <= or_2428_s26_q;
      and_2532_s27_q <= and_2532_s26_q;
      and_2550_s27_q <= select_2548[0] & and_2549;
      and_2553_s27_q <= select_2548[1] & and_2549;
      and_2562_s27_q <= and_2562_s26_q;
      and_2574_s27_q <= and_2574;
      or_2576_s27_q <= or_2576;
      and_2596_s27_q <= and_2596_s26_q;
      select_2598_s27_q <= select_2598_s26_q;
      select_2615_s27_q <= equal_1339_s26_q ? (x_s26_q ? select_2613 : 32'h0) : 32'h0;
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
  logic select_1844;
  assign select_1844 = or_1842_s27_q ? and_1843_s27_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_1845;
  assign select_1845 = equal_1796_s27_q ? select_1844 : sharpness_comparing_less_detail_0_q;
  logic select_1846;
  assign select_1846 = so_s27_q ? select_1845 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_1850;
  assign select_1850 = or_1848_s27_q ? and_1849_s27_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_1851;
  assign select_1851 = equal_1796_s27_q ? select_1850 : sharpness_comparing_less_detail_1_q;
  logic select_1852;
  assign select_1852 = so_s27_q ? select_1851 : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:1086
  logic not_2395;
  assign not_2395 = ~hidden_for_q[7];
  logic [7:0] select_2397;
  assign select_2397 = select_2394_s27_q ? (hidden_for_q + {7'h0, not_2395}) : 8'h0;
  // hls/stages/agreement.hpp:402
  logic [7:0] select_2399;
  assign select_2399 = equal_1339_s27_q ? (equal_2383_s27_q ? select_2397 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1159
  logic and_2425;
  assign and_2425 = too_much_q & not_2424_s27_q;
  // hls/stages/agreement.hpp:1160
  logic select_2430;
  assign select_2430 = and_2422_s27_q ? (and_2425 | or_2428_s27_q) : and_2425;
  // hls/stages/agreement.hpp:424
  logic select_2552;
  assign select_2552 = and_1522_s27_q ? (less_1523_s27_q ? and_2550_s27_q : seen_q) : seen_q;
  logic select_2555;
  assign select_2555 = and_1522_s27_q ? (less_1523_s27_q ? and_2553_s27_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:402
  logic and_2565;
  assign and_2565 = equal_1339_s27_q & (equal_2383_s27_q & (cfg_prove_i & or_2363_s27_q));
  // hls/stages/agreement.hpp:1170
  logic not_2567;
  assign not_2567 = ~(or_2363_s27_q | not_2556);
  // hls/stages/agreement.hpp:402
  logic and_2570;
  assign and_2570 = equal_2383_s27_q & (not_2567 & (select_2372_s27_q | select_2430));
  logic and_2583;
  assign and_2583 = equal_2383_s27_q & (not_2567 & (select_1852 | select_1864_s27_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s27_en) begin
      sharpness_comparing_less_detail_0_q <= select_1846;
      sharpness_comparing_less_detail_1_q <= select_1852;
      hidden_for_q <= select_2399;
      too_much_q <= equal_1339_s27_q ? select_2430 : too_much_q;
      seen_q <= select_2552;
      nearer_q <= select_2555;
    end
  end

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic equal_1339_s28_q;
  logic equal_2383_s28_q;
  logic and_2532_s28_q;
  logic and_2562_s28_q;
  logic and_2565_s28_q;
  logic and_2571_s28_q;
  logic and_2574_s28_q;
  logic and_2579_s28_q;
  logic and_2583_s28_q;
  logic not_2588_s28_q;
  logic and_2596_s28_q;
  logic [5:0] select_2598_s28_q;
  logic [31:0] select_2615_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      equal_1339_s28_q <= equal_1339_s27_q;
      equal_2383_s28_q <= equal_2383_s27_q;
      and_2532_s28_q <= and_2532_s27_q;
      and_2562_s28_q <= and_2562_s27_q;
      and_2565_s28_q <= and_2565;
      and_2571_s28_q <= equal_1339_s27_q & and_2570;
      and_2574_s28_q <= and_2574_s27_q;
      and_2579_s28_q <= equal_2383_s27_q & (not_2567 & (select_1846 | or_2576_s27_q));
      and_2583_s28_q <= and_2583;
      not_2588_s28_q <= ~(select_2397 < cfg_hidden_frames_i);
      and_2596_s28_q <= and_2596_s27_q;
      select_2598_s28_q <= select_2598_s27_q;
      select_2615_s28_q <= select_2615_s27_q;
    end
  end

  // Stage 28 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:1088
  logic and_2590;
  assign and_2590 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_2588_s28_q);

  logic [7:0] pixel_0_s29_q;
  logic [7:0] pixel_1_s29_q;
  logic saturated_s29_q;
  logic mask_s29_q;
  logic marks_first_s29_q;
  logic marks_last_s29_q;
  logic and_2532_s29_q;
  logic or_2557_s29_q;
  logic and_2558_s29_q;
  logic and_2562_s29_q;
  logic and_2565_s29_q;
  logic and_2571_s29_q;
  logic and_2574_s29_q;
  logic and_2580_s29_q;
  logic and_2584_s29_q;
  logic and_2592_s29_q;
  logic and_2596_s29_q;
  logic [5:0] select_2598_s29_q;
  logic [31:0] select_2615_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      and_2532_s29_q <= and_2532_s28_q;
      or_2557_s29_q <= not_2556 | seen_q;
      and_2558_s29_q <= cfg_prove_i & nearer_q;
      and_2562_s29_q <= and_2562_s28_q;
      and_2565_s29_q <= and_2565_s28_q;
      and_2571_s29_q <= and_2571_s28_q;
      and_2574_s29_q <= and_2574_s28_q;
      and_2580_s29_q <= equal_1339_s28_q & and_2579_s28_q;
      and_2584_s29_q <= equal_1339_s28_q & and_2583_s28_q;
      and_2592_s29_q <= equal_1339_s28_q & (equal_2383_s28_q & and_2590);
      and_2596_s29_q <= and_2596_s28_q;
      select_2598_s29_q <= select_2598_s28_q;
      select_2615_s29_q <= select_2615_s28_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s29_q;
  assign pixel_1_o = pixel_1_s29_q;
  assign saturated_o = saturated_s29_q;
  assign mask_o = mask_s29_q;
  assign marks_first_o = marks_first_s29_q;
  assign marks_last_o = marks_last_s29_q;
  assign marks_seen_o = or_2557_s29_q;
  assign marks_nearer_o = and_2558_s29_q;
  assign verdict_valid_o = and_2532_s29_q;
  assign verdict_unproven_yet_o = and_2562_s29_q;
  assign verdict_untextured_o = and_2565_s29_q;
  assign verdict_disagree_o = and_2571_s29_q;
  assign verdict_moved_o = and_2574_s29_q;
  assign verdict_unsharp_left_o = and_2580_s29_q;
  assign verdict_unsharp_right_o = and_2584_s29_q;
  assign verdict_hidden_o = and_2592_s29_q;
  assign frame_valid_o = and_2596_s29_q;
  assign frame_index_o = select_2598_s29_q;
  assign frame_word_o = select_2615_s29_q;
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
  assign unused_bits = ^{over[13:0], sum_2135[0], sum_2131[0], sum_2106[1:0], sum_2105[1:0], sum_2101[0], sum_2088[0], detail_4[1:0], detail_3[1:0], sum_1746[4:0], sum_483[4:0], cfg_patch_limit_i, cfg_width_i[3:0]};

endmodule
