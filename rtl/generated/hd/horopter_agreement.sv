// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 29 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1918 bits, pipeline 6133 bits, memories 93264 bits.
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
  logic [6:0] sum_1957;
  assign sum_1957 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] difference_2329;
  assign difference_2329 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_2533;
  assign less_2533 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_2534;
  assign sum_2534 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_2552;
  assign not_2552 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_327;
  assign select_327 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_327 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_327_s1_q;
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
      select_327_s1_q <= select_327;
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
  logic equal_328;
  assign equal_328 = select_327_s1_q[1:0] == 2'h0;
  // hls/stages/census.hpp:35
  logic [6:0] select_330;
  assign select_330 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:41
  logic or_335;
  assign or_335 = sample_pair_first_s1_q | raster_at_live_q;
  logic [3:0] select_348;
  assign select_348 = sample_pair_first_s1_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:394
  logic whole;
  assign whole = equal_328 ? sample_present_s1_q : (sample_present_s1_q & averager_running_mask_q);
  // hls/stages/agreement.hpp:255
  logic [6:0] column;
  assign column = sample_pair_whole_s1_q ? select_330 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_365;
  assign equal_365 = select_327_s1_q == 4'hf;
  // hls/stages/agreement.hpp:255
  logic [3:0] select_1604;
  assign select_1604 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (select_348 + 4'h1) : select_348) : raster_at_y_q;
  logic [6:0] select_1606;
  assign select_1606 = sample_pair_whole_s1_q ? (select_330 + {6'h0, equal_365}) : raster_at_column_q;
  logic select_1613;
  assign select_1613 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_335 & (~raster_final_row_q)) : or_335) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_1615;
  assign select_1615 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:255
  logic select_1619;
  assign select_1619 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      raster_at_column_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
    end else if (s1_en) begin
      raster_at_y_q <= select_1604;
      raster_at_column_q <= select_1606;
      raster_at_live_q <= select_1613;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_1615 : raster_rows_left_q;
      raster_final_row_q <= select_1619;
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
  logic equal_328_s2_q;
  logic equal_331_s2_q;
  logic not_340_s2_q;
  logic equal_349_s2_q;
  logic whole_s2_q;
  logic [6:0] column_s2_q;
  logic equal_365_s2_q;
  logic equal_366_s2_q;
  logic equal_372_s2_q;
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
      equal_328_s2_q <= equal_328;
      equal_331_s2_q <= {select_330, select_327_s1_q} == 11'h0;
      not_340_s2_q <= ~((~or_335) | (~(select_327_s1_q[1:0] == 2'h3)));
      equal_349_s2_q <= select_348 == 4'h0;
      whole_s2_q <= whole;
      column_s2_q <= column;
      equal_365_s2_q <= equal_365;
      equal_366_s2_q <= select_348 == 4'hf;
      equal_372_s2_q <= select_327_s1_q == 4'h3;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:116
  logic [8:0] select_334;
  assign select_334 = equal_328_s2_q ? (equal_331_s2_q ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/census.hpp:41
  logic [6:0] select_428;
  assign select_428 = sample_pair_first_s2_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:255
  logic [6:0] row;
  assign row = sample_pair_whole_s2_q ? select_428 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_1608;
  assign select_1608 = sample_last_s2_q ? (select_428 + {6'h0, equal_366_s2_q}) : select_428;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_row_q <= sample_pair_whole_s2_q ? select_1608 : raster_at_row_q;
      averager_place_q <= sample_pair_whole_s2_q ? select_334 : averager_place_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic equal_328_s3_q;
  logic [8:0] select_334_s3_q;
  logic not_340_s3_q;
  logic equal_349_s3_q;
  logic whole_s3_q;
  logic [6:0] column_s3_q;
  logic equal_365_s3_q;
  logic equal_366_s3_q;
  logic equal_372_s3_q;
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
      equal_328_s3_q <= equal_328_s2_q;
      select_334_s3_q <= select_334;
      not_340_s3_q <= not_340_s2_q;
      equal_349_s3_q <= equal_349_s2_q;
      whole_s3_q <= whole_s2_q;
      column_s3_q <= column_s2_q;
      equal_365_s3_q <= equal_365_s2_q;
      equal_366_s3_q <= equal_366_s2_q;
      equal_372_s3_q <= equal_372_s2_q;
      row_s3_q <= row;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:394
  logic and_343;
  assign and_343 = not_340_s3_q & (~(select_334_s3_q[8:5] == 4'hf));
  // hls/stages/census.hpp:126
  logic and_367;
  assign and_367 = equal_366_s3_q & and_343;
  // hls/stages/agreement.hpp:255
  logic and_369;
  assign and_369 = sample_pair_whole_s3_q & (equal_365_s3_q & and_367);
  // hls/stages/agreement.hpp:435
  logic equal_1863;
  assign equal_1863 = {last[7], column_s3_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:451
  logic [7:0] sum_1953;
  assign sum_1953 = {1'b0, row_s3_q} + 8'h1;

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic sample_pair_whole_s4_q;
  logic equal_328_s4_q;
  logic [8:0] select_334_s4_q;
  logic and_343_s4_q;
  logic equal_349_s4_q;
  logic whole_s4_q;
  logic [6:0] column_s4_q;
  logic and_367_s4_q;
  logic and_369_s4_q;
  logic equal_372_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1863_s4_q;
  logic and_1864_s4_q;
  logic equal_1954_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      equal_328_s4_q <= equal_328_s3_q;
      select_334_s4_q <= select_334_s3_q;
      and_343_s4_q <= and_343;
      equal_349_s4_q <= equal_349_s3_q;
      whole_s4_q <= whole_s3_q;
      column_s4_q <= column_s3_q;
      and_367_s4_q <= and_367;
      and_369_s4_q <= and_369;
      equal_372_s4_q <= equal_372_s3_q;
      row_s4_q <= row_s3_q;
      equal_1863_s4_q <= equal_1863;
      and_1864_s4_q <= and_369 & equal_1863;
      equal_1954_s4_q <= {sum_1953[7], cfg_height_i[10:4]} == {1'b0, sum_1953[6:0]};
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
  logic equal_389;
  assign equal_389 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:589
  logic equal_392;
  assign equal_392 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:590
  logic equal_394;
  assign equal_394 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:498
  logic select_1867;
  assign select_1867 = (and_1864_s4_q | (~ends_cell_q)) ? and_1864_s4_q : ends_q;
  // hls/stages/agreement.hpp:504
  logic [2:0] now;
  assign now = select_1867 ? (and_1864_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:509
  logic [5:0] select_1871;
  assign select_1871 = select_1867 ? (and_1864_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_1874;
  assign select_1874 = select_1867 ? (following_last_shift_q & (~and_1864_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:510
  logic [7:0] select_1876;
  assign select_1876 = select_1867 ? (and_1864_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:582
  logic and_1877;
  assign and_1877 = run_last_shift_q & equal_392;
  // hls/stages/agreement.hpp:591
  logic select_1879;
  assign select_1879 = equal_392 ? (~run_last_shift_q) : equal_394;
  // hls/stages/agreement.hpp:595
  logic equal_1880;
  assign equal_1880 = run_phase_q == 3'h1;
  logic not_1883;
  assign not_1883 = ~select_1879;
  // hls/stages/agreement.hpp:598
  logic equal_1885;
  assign equal_1885 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:582
  logic and_1886;
  assign and_1886 = final_row_q & so;
  // hls/stages/agreement.hpp:595
  logic [1:0] select_1887;
  assign select_1887 = equal_1885 ? 2'h1 : {2{and_1886}};
  logic [2:0] select_1889;
  assign select_1889 = (and_1877 | (select_1879 | equal_1880)) ? (equal_1880 ? 3'h2 : {not_1883, {2{select_1879}}}) : (equal_389 ? 3'h6 : {select_1887[0], select_1887});
  // hls/stages/agreement.hpp:582
  logic and_1892;
  assign and_1892 = select_1879 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:605
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1895;
  assign select_1895 = (plan_shift_q[5] & select_1879) ? value : 7'h0;
  logic [1:0] or_1896;
  assign or_1896 = {2{so}} | select_1895[5:4];
  // hls/stages/agreement.hpp:608
  logic [7:0] or_1900;
  assign or_1900 = (select_1879 ? plan_columns_q : 8'h0) | ((equal_1880 | equal_1885) ? whole_q : 8'h0);
  logic [1:0] or_1901;
  assign or_1901 = {2{and_1877}} | or_1900[4:3];
  // hls/stages/agreement.hpp:609
  logic [7:0] or_1903;
  assign or_1903 = {or_1900[7:5], or_1901, or_1900[2:0]} | (equal_389 ? drawn_q : 8'h0);
  logic [4:0] or_1904;
  assign or_1904 = {5{so}} | {or_1903[6], or_1903[3:0]};
  // hls/stages/agreement.hpp:615
  logic not_1908;
  assign not_1908 = ~run_shift_q[5];
  logic [7:0] select_1911;
  assign select_1911 = equal_392 ? ({{7{not_1908}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:498
  logic [6:0] select_1915;
  assign select_1915 = and_1864_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:501
  logic [7:0] select_1917;
  assign select_1917 = select_1867 ? {select_1915[6], select_1915} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_1920;
  assign select_1920 = select_1867 ? (and_1864_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:436
  logic [6:0] select_1927;
  assign select_1927 = equal_1863_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:495
  logic [7:0] select_1931;
  assign select_1931 = and_369_s4_q ? (equal_1863_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_1934;
  assign select_1934 = and_369_s4_q ? (equal_1863_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:506
  logic select_1948;
  assign select_1948 = (ends_cell_q | select_1867) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_392 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:501
  logic and_1952;
  assign and_1952 = (~select_1867) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:495
  logic select_1956;
  assign select_1956 = and_369_s4_q ? (equal_1863_s4_q ? equal_1954_s4_q : final_row_q) : final_row_q;

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
      run_shift_q <= select_1871;
      run_last_shift_q <= select_1874;
      run_span_q <= select_1876;
      following_phase_q <= select_1889;
      following_shift_q <= select_1879 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_1892;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1895[6], or_1896, select_1895[3:0]};
      following_columns_q <= {or_1903[7], or_1904[4], or_1903[5:4], or_1904[3:0]};
      plan_shift_q <= equal_392 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_1911;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_1917;
      columns_left_q <= select_1920;
      last_q <= and_369_s4_q ? (equal_1863_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_369_s4_q ? select_1927 : least_q;
      whole_q <= select_1931;
      drawn_q <= select_1934;
      slot_q <= select_1867 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_1948;
      ends_q <= and_1952;
      final_row_q <= select_1956;
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
  logic equal_328_s5_q;
  logic [8:0] select_334_s5_q;
  logic and_343_s5_q;
  logic equal_349_s5_q;
  logic whole_s5_q;
  logic [6:0] column_s5_q;
  logic and_367_s5_q;
  logic and_369_s5_q;
  logic equal_372_s5_q;
  logic so_s5_q;
  logic equal_389_s5_q;
  logic equal_392_s5_q;
  logic equal_394_s5_q;
  logic [7:0] sum_395_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_505_s5_q;
  logic equal_514_s5_q;
  logic equal_1338_s5_q;
  logic equal_1863_s5_q;
  logic and_1864_s5_q;
  logic select_1867_s5_q;
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
      equal_328_s5_q <= equal_328_s4_q;
      select_334_s5_q <= select_334_s4_q;
      and_343_s5_q <= and_343_s4_q;
      equal_349_s5_q <= equal_349_s4_q;
      whole_s5_q <= whole_s4_q;
      column_s5_q <= column_s4_q;
      and_367_s5_q <= and_367_s4_q;
      and_369_s5_q <= and_369_s4_q;
      equal_372_s5_q <= equal_372_s4_q;
      so_s5_q <= so;
      equal_389_s5_q <= equal_389;
      equal_392_s5_q <= equal_392;
      equal_394_s5_q <= equal_394;
      sum_395_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_505_s5_q <= {1'b0, last_q} + 8'h3;
      equal_514_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_1338_s5_q <= run_phase_q == 3'h7;
      equal_1863_s5_q <= equal_1863_s4_q;
      and_1864_s5_q <= and_1864_s4_q;
      select_1867_s5_q <= select_1867;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:569
  logic [7:0] select_396;
  assign select_396 = run_shift_s5_q[5] ? x_s5_q : sum_395_s5_q;
  logic less_397;
  assign less_397 = {1'b0, last_s5_q} < select_396;
  // hls/stages/agreement.hpp:209
  logic not_398;
  assign not_398 = ~less_397;
  // hls/stages/agreement.hpp:788
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:503
  logic [6:0] select_1936;
  assign select_1936 = select_1867_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_1936;
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
  logic equal_328_s6_q;
  logic [8:0] select_334_s6_q;
  logic and_343_s6_q;
  logic equal_349_s6_q;
  logic whole_s6_q;
  logic [6:0] column_s6_q;
  logic and_367_s6_q;
  logic and_369_s6_q;
  logic equal_372_s6_q;
  logic so_s6_q;
  logic equal_389_s6_q;
  logic equal_392_s6_q;
  logic [6:0] sum_395_s6_q;
  logic less_397_s6_q;
  logic not_398_s6_q;
  logic and_399_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_509_s6_q;
  logic equal_514_s6_q;
  logic equal_1328_s6_q;
  logic equal_1338_s6_q;
  logic equal_1863_s6_q;
  logic and_1864_s6_q;
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
      equal_328_s6_q <= equal_328_s5_q;
      select_334_s6_q <= select_334_s5_q;
      and_343_s6_q <= and_343_s5_q;
      equal_349_s6_q <= equal_349_s5_q;
      whole_s6_q <= whole_s5_q;
      column_s6_q <= column_s5_q;
      and_367_s6_q <= and_367_s5_q;
      and_369_s6_q <= and_369_s5_q;
      equal_372_s6_q <= equal_372_s5_q;
      so_s6_q <= so_s5_q;
      equal_389_s6_q <= equal_389_s5_q;
      equal_392_s6_q <= equal_392_s5_q;
      sum_395_s6_q <= sum_395_s5_q[6:0];
      less_397_s6_q <= less_397;
      not_398_s6_q <= not_398;
      and_399_s6_q <= equal_394_s5_q & not_398;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_509_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_505_s5_q < select_396)));
      equal_514_s6_q <= equal_514_s5_q;
      equal_1328_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1338_s6_q <= equal_1338_s5_q;
      equal_1863_s6_q <= equal_1863_s5_q;
      and_1864_s6_q <= and_1864_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:569
  logic or_390;
  assign or_390 = so_s6_q | equal_389_s6_q;
  // hls/stages/agreement.hpp:719
  logic not_391;
  assign not_391 = ~or_390;
  // hls/stages/agreement.hpp:137
  logic select_485;
  assign select_485 = equal_392_s6_q ? not_398_s6_q : and_399_s6_q;
  logic and_510;
  assign and_510 = equal_392_s6_q & and_509_s6_q;
  logic select_511;
  assign select_511 = or_390 ? not_398_s6_q : and_510;
  // hls/stages/agreement.hpp:797
  logic or_516;
  assign or_516 = equal_514_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:809
  logic [6:0] right;
  assign right = sum_395_s6_q + 7'h7d;

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
  assign left_re = s6_en & (or_390 ? not_398_s6_q : select_485);
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
  assign right_codes_raddr = equal_392_s6_q ? sum_395_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_391 & select_485);
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
  assign best_left_raddr = or_390 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_511;
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
  logic equal_328_s7_q;
  logic [8:0] select_334_s7_q;
  logic and_343_s7_q;
  logic equal_349_s7_q;
  logic whole_s7_q;
  logic [6:0] column_s7_q;
  logic and_367_s7_q;
  logic and_369_s7_q;
  logic equal_372_s7_q;
  logic so_s7_q;
  logic equal_389_s7_q;
  logic or_390_s7_q;
  logic equal_392_s7_q;
  logic less_397_s7_q;
  logic not_398_s7_q;
  logic and_401_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_511_s7_q;
  logic select_518_s7_q;
  logic and_1320_s7_q;
  logic [6:0] right_s7_q;
  logic select_1329_s7_q;
  logic equal_1338_s7_q;
  logic equal_1863_s7_q;
  logic and_1864_s7_q;
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
      equal_328_s7_q <= equal_328_s6_q;
      select_334_s7_q <= select_334_s6_q;
      and_343_s7_q <= and_343_s6_q;
      equal_349_s7_q <= equal_349_s6_q;
      whole_s7_q <= whole_s6_q;
      column_s7_q <= column_s6_q;
      and_367_s7_q <= and_367_s6_q;
      and_369_s7_q <= and_369_s6_q;
      equal_372_s7_q <= equal_372_s6_q;
      so_s7_q <= so_s6_q;
      equal_389_s7_q <= equal_389_s6_q;
      or_390_s7_q <= or_390;
      equal_392_s7_q <= equal_392_s6_q;
      less_397_s7_q <= less_397_s6_q;
      not_398_s7_q <= not_398_s6_q;
      and_401_s7_q <= not_391 & ((~equal_392_s6_q) & and_399_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_511_s7_q <= select_511;
      select_518_s7_q <= or_516 ? equal_514_s6_q : (~age_s6_q[1]);
      and_1320_s7_q <= not_391 & and_510;
      right_s7_q <= right;
      select_1329_s7_q <= or_516 ? equal_514_s6_q : equal_1328_s6_q;
      equal_1338_s7_q <= equal_1338_s6_q;
      equal_1863_s7_q <= equal_1863_s6_q;
      and_1864_s7_q <= and_1864_s6_q;
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
  assign fresh_re = s7_en & and_401_s7_q;
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
  logic equal_328_s8_q;
  logic [8:0] select_334_s8_q;
  logic and_343_s8_q;
  logic equal_349_s8_q;
  logic whole_s8_q;
  logic [6:0] column_s8_q;
  logic and_367_s8_q;
  logic and_369_s8_q;
  logic equal_372_s8_q;
  logic so_s8_q;
  logic equal_389_s8_q;
  logic or_390_s8_q;
  logic equal_392_s8_q;
  logic less_397_s8_q;
  logic not_398_s8_q;
  logic and_401_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_511_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic select_518_s8_q;
  logic and_1320_s8_q;
  logic [6:0] right_s8_q;
  logic select_1329_s8_q;
  logic equal_1338_s8_q;
  logic equal_1863_s8_q;
  logic and_1864_s8_q;
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
      equal_328_s8_q <= equal_328_s7_q;
      select_334_s8_q <= select_334_s7_q;
      and_343_s8_q <= and_343_s7_q;
      equal_349_s8_q <= equal_349_s7_q;
      whole_s8_q <= whole_s7_q;
      column_s8_q <= column_s7_q;
      and_367_s8_q <= and_367_s7_q;
      and_369_s8_q <= and_369_s7_q;
      equal_372_s8_q <= equal_372_s7_q;
      so_s8_q <= so_s7_q;
      equal_389_s8_q <= equal_389_s7_q;
      or_390_s8_q <= or_390_s7_q;
      equal_392_s8_q <= equal_392_s7_q;
      less_397_s8_q <= less_397_s7_q;
      not_398_s8_q <= not_398_s7_q;
      and_401_s8_q <= and_401_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_511_s8_q <= select_511_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      select_518_s8_q <= select_518_s7_q;
      and_1320_s8_q <= and_1320_s7_q;
      right_s8_q <= right_s7_q;
      select_1329_s8_q <= select_1329_s7_q;
      equal_1338_s8_q <= equal_1338_s7_q;
      equal_1863_s8_q <= equal_1863_s7_q;
      and_1864_s8_q <= and_1864_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:641
  logic not_489;
  assign not_489 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:205
  logic and_524;
  assign and_524 = left_rdata_s8_q[44] & not_398_s8_q;
  logic and_525;
  assign and_525 = right_codes_rdata_s8_q[38] & not_398_s8_q;
  logic [11:0] select_526;
  assign select_526 = less_397_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_527;
  assign select_527 = less_397_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_531;
  assign select_531 = and_524 ? (and_525 ? (~(select_526 ^ select_527)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:205
  logic and_547;
  assign and_547 = left_rdata_s8_q[60] & not_398_s8_q;
  logic and_548;
  assign and_548 = right_codes_rdata_s8_q[51] & not_398_s8_q;
  logic [11:0] select_549;
  assign select_549 = less_397_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_550;
  assign select_550 = less_397_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_554;
  assign select_554 = and_547 ? (and_548 ? (~(select_549 ^ select_550)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:205
  logic and_564;
  assign and_564 = left_rdata_s8_q[76] & not_398_s8_q;
  logic and_565;
  assign and_565 = right_codes_rdata_s8_q[64] & not_398_s8_q;
  logic [11:0] select_566;
  assign select_566 = less_397_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_567;
  assign select_567 = less_397_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_571;
  assign select_571 = and_564 ? (and_565 ? (~(select_566 ^ select_567)) : 12'h0) : 12'h0;
  logic [11:0] select_779;
  assign select_779 = (slot_s8_q[0] ? and_565 : and_548) ? (~(select_527 ^ (slot_s8_q[0] ? select_566 : select_549))) : 12'h0;
  // hls/stages/agreement.hpp:205
  logic and_796;
  assign and_796 = right_codes_rdata_s8_q[77] & not_398_s8_q;
  logic [11:0] select_798;
  assign select_798 = less_397_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_802;
  assign select_802 = (slot_s8_q[0] ? and_796 : and_565) ? (~(select_550 ^ (slot_s8_q[0] ? select_798 : select_566))) : 12'h0;
  // hls/stages/agreement.hpp:733
  logic select_814;
  assign select_814 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_398_s8_q) : and_796;
  logic [11:0] select_816;
  assign select_816 = slot_s8_q[0] ? (less_397_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_798;
  // hls/stages/agreement.hpp:205
  logic and_1025;
  assign and_1025 = right_codes_rdata_s8_q[25] & not_398_s8_q;
  // hls/stages/agreement.hpp:733
  logic select_1026;
  assign select_1026 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_398_s8_q) : and_1025;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1028;
  assign select_1028 = less_397_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:733
  logic [11:0] select_1029;
  assign select_1029 = slot_s8_q[0] ? (less_397_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1028;
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1053;
  assign select_1053 = (slot_s8_q[0] ? and_1025 : and_525) ? (~(select_550 ^ (slot_s8_q[0] ? select_1028 : select_526))) : 12'h0;
  logic [11:0] select_1068;
  assign select_1068 = (slot_s8_q[0] ? and_525 : and_548) ? (~(select_567 ^ (slot_s8_q[0] ? select_526 : select_549))) : 12'h0;
  // hls/stages/agreement.hpp:942
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:947
  logic and_1344;
  assign and_1344 = (or_390_s8_q & (left_rdata_s8_q[61] & not_398_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:228
  logic and_1352;
  assign and_1352 = not_398_s8_q & (or_390_s8_q & (left_rdata_s8_q[63] & not_398_s8_q));
  // hls/stages/agreement.hpp:436
  logic select_1960;
  assign select_1960 = equal_1863_s8_q ? (~({row_s8_q, 1'b0} < {sum_1957, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:495
  logic and_2197;
  assign and_2197 = and_369_s8_q & (equal_1863_s8_q & (row_s8_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s8_en) begin
      row_q <= and_369_s8_q ? (equal_1863_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_369_s8_q ? select_1960 : lower_half_q;
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
  logic equal_328_s9_q;
  logic [8:0] select_334_s9_q;
  logic and_343_s9_q;
  logic equal_349_s9_q;
  logic whole_s9_q;
  logic [6:0] column_s9_q;
  logic and_367_s9_q;
  logic and_369_s9_q;
  logic equal_372_s9_q;
  logic so_s9_q;
  logic equal_389_s9_q;
  logic or_390_s9_q;
  logic equal_392_s9_q;
  logic less_397_s9_q;
  logic not_398_s9_q;
  logic and_401_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic equal_430_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_490_s9_q;
  logic and_491_s9_q;
  logic and_492_s9_q;
  logic and_493_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_497_s9_q;
  logic and_498_s9_q;
  logic and_499_s9_q;
  logic and_500_s9_q;
  logic and_501_s9_q;
  logic and_502_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_511_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic select_518_s9_q;
  logic and_524_s9_q;
  logic [11:0] select_531_s9_q;
  logic and_547_s9_q;
  logic [11:0] select_554_s9_q;
  logic and_564_s9_q;
  logic [11:0] select_571_s9_q;
  logic [11:0] select_779_s9_q;
  logic [11:0] select_802_s9_q;
  logic [11:0] select_819_s9_q;
  logic [11:0] select_1032_s9_q;
  logic [11:0] select_1053_s9_q;
  logic [11:0] select_1068_s9_q;
  logic and_1320_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic select_1329_s9_q;
  logic equal_1338_s9_q;
  logic and_1345_s9_q;
  logic and_1348_s9_q;
  logic and_1352_s9_q;
  logic and_1593_s9_q;
  logic equal_1739_s9_q;
  logic equal_1863_s9_q;
  logic less_2115_s9_q;
  logic and_2198_s9_q;
  logic and_2200_s9_q;
  logic less_2307_s9_q;
  logic equal_2514_s9_q;
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
      equal_328_s9_q <= equal_328_s8_q;
      select_334_s9_q <= select_334_s8_q;
      and_343_s9_q <= and_343_s8_q;
      equal_349_s9_q <= equal_349_s8_q;
      whole_s9_q <= whole_s8_q;
      column_s9_q <= column_s8_q;
      and_367_s9_q <= and_367_s8_q;
      and_369_s9_q <= and_369_s8_q;
      equal_372_s9_q <= equal_372_s8_q;
      so_s9_q <= so_s8_q;
      equal_389_s9_q <= equal_389_s8_q;
      or_390_s9_q <= or_390_s8_q;
      equal_392_s9_q <= equal_392_s8_q;
      less_397_s9_q <= less_397_s8_q;
      not_398_s9_q <= not_398_s8_q;
      and_401_s9_q <= and_401_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_430_s9_q <= row_s8_q == 7'h0;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_490_s9_q <= left_rdata_s8_q[12] & not_489;
      and_491_s9_q <= left_rdata_s8_q[28] & not_489;
      and_492_s9_q <= left_rdata_s8_q[44] & not_489;
      and_493_s9_q <= left_rdata_s8_q[60] & not_489;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_497_s9_q <= right_codes_rdata_s8_q[12] & not_489;
      and_498_s9_q <= right_codes_rdata_s8_q[25] & not_489;
      and_499_s9_q <= right_codes_rdata_s8_q[38] & not_489;
      and_500_s9_q <= right_codes_rdata_s8_q[51] & not_489;
      and_501_s9_q <= right_codes_rdata_s8_q[64] & not_489;
      and_502_s9_q <= right_codes_rdata_s8_q[77] & not_489;
      x_s9_2_q <= x_s8_2_q;
      select_511_s9_q <= select_511_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_518_s9_q <= select_518_s8_q;
      and_524_s9_q <= and_524;
      select_531_s9_q <= select_531;
      and_547_s9_q <= and_547;
      select_554_s9_q <= select_554;
      and_564_s9_q <= and_564;
      select_571_s9_q <= select_571;
      select_779_s9_q <= select_779;
      select_802_s9_q <= select_802;
      select_819_s9_q <= select_814 ? (~(select_567 ^ select_816)) : 12'h0;
      select_1032_s9_q <= select_1026 ? (~(select_527 ^ select_1029)) : 12'h0;
      select_1053_s9_q <= select_1053;
      select_1068_s9_q <= select_1068;
      and_1320_s9_q <= and_1320_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      select_1329_s9_q <= select_1329_s8_q;
      equal_1338_s9_q <= equal_1338_s8_q;
      and_1345_s9_q <= not_398_s8_q & and_1344;
      and_1348_s9_q <= (or_390_s8_q & (left_rdata_s8_q[62] & not_398_s8_q)) & and_1344;
      and_1352_s9_q <= and_1352;
      and_1593_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_1739_s9_q <= (column_s8_q | row_s8_q) == 7'h0;
      equal_1863_s9_q <= equal_1863_s8_q;
      less_2115_s9_q <= 6'h4 < row_q[6:1];
      and_2198_s9_q <= and_1864_s8_q & and_2197;
      and_2200_s9_q <= and_1864_s8_q & (~and_2197);
      less_2307_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_2514_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:672
  logic parity_537;
  assign parity_537 = ^select_531_s9_q[5:3];
  logic parity_540;
  assign parity_540 = ^select_531_s9_q[8:6];
  logic parity_543;
  assign parity_543 = ^select_531_s9_q[11:3];
  logic parity_557;
  assign parity_557 = ^select_554_s9_q[8:6];
  logic parity_560;
  assign parity_560 = ^select_554_s9_q[11:9];
  logic parity_577;
  assign parity_577 = ^select_571_s9_q[2:0];
  logic parity_580;
  assign parity_580 = ^select_571_s9_q[5:3];
  logic parity_583;
  assign parity_583 = ^select_571_s9_q[8:0];
  logic parity_589;
  assign parity_589 = ^select_571_s9_q[11:9];
  logic parity_592;
  assign parity_592 = ^select_554_s9_q[2:0];
  logic parity_595;
  assign parity_595 = ^{select_571_s9_q[11:9], select_554_s9_q[5:0]};
  logic parity_598;
  assign parity_598 = ^{select_571_s9_q, select_554_s9_q, select_531_s9_q[2:0]};
  // hls/stages/agreement.hpp:671
  logic or_603;
  assign or_603 = (select_531_s9_q[1:0] == 2'h3) | (select_531_s9_q[2] & (select_531_s9_q[0] | select_531_s9_q[1]));
  // hls/stages/agreement.hpp:673
  logic or_607;
  assign or_607 = (select_554_s9_q[7:6] == 2'h3) | (select_554_s9_q[8] & (select_554_s9_q[6] | select_554_s9_q[7]));
  logic or_611;
  assign or_611 = (select_554_s9_q[10:9] == 2'h3) | (select_554_s9_q[11] & (select_554_s9_q[9] | select_554_s9_q[10]));
  // hls/stages/agreement.hpp:671
  logic or_619;
  assign or_619 = (select_571_s9_q[7:6] == 2'h3) | (select_571_s9_q[8] & (~(select_571_s9_q[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_623;
  assign or_623 = (select_571_s9_q[1:0] == 2'h3) | (select_571_s9_q[2] & (select_571_s9_q[0] | select_571_s9_q[1]));
  logic or_627;
  assign or_627 = (select_571_s9_q[4:3] == 2'h3) | (select_571_s9_q[5] & (select_571_s9_q[3] | select_571_s9_q[4]));
  // hls/stages/agreement.hpp:672
  logic parity_630;
  assign parity_630 = ^{or_627, or_623, or_619};
  // hls/stages/agreement.hpp:671
  logic or_634;
  assign or_634 = (select_554_s9_q[4:3] == 2'h3) | (select_554_s9_q[5] & (select_554_s9_q[3] | select_554_s9_q[4]));
  // hls/stages/agreement.hpp:673
  logic or_638;
  assign or_638 = (select_571_s9_q[10:9] == 2'h3) | (select_571_s9_q[11] & (select_571_s9_q[9] | select_571_s9_q[10]));
  logic or_642;
  assign or_642 = (select_554_s9_q[1:0] == 2'h3) | (select_554_s9_q[2] & (select_554_s9_q[0] | select_554_s9_q[1]));
  // hls/stages/agreement.hpp:672
  logic parity_645;
  assign parity_645 = ^{or_642, or_638, or_634};
  logic parity_648;
  assign parity_648 = ^{or_642, or_638, or_634, or_627, or_623, or_619, or_611, or_607, or_603};
  // hls/stages/agreement.hpp:673
  logic or_653;
  assign or_653 = (parity_537 & parity_540) | ((^select_531_s9_q[11:9]) & (parity_537 | parity_540));
  logic and_656;
  assign and_656 = (^{select_554_s9_q[11:6], select_531_s9_q[2:0]}) & (parity_583 | parity_595);
  // hls/stages/agreement.hpp:671
  logic or_664;
  assign or_664 = (select_531_s9_q[10:9] == 2'h3) | (select_531_s9_q[11] & (select_531_s9_q[9] | select_531_s9_q[10]));
  // hls/stages/agreement.hpp:673
  logic or_668;
  assign or_668 = (select_531_s9_q[4:3] == 2'h3) | (select_531_s9_q[5] & (select_531_s9_q[3] | select_531_s9_q[4]));
  logic or_672;
  assign or_672 = (select_531_s9_q[7:6] == 2'h3) | (select_531_s9_q[8] & (select_531_s9_q[6] | select_531_s9_q[7]));
  logic or_679;
  assign or_679 = (parity_557 & parity_560) | ((^select_531_s9_q[2:0]) & (parity_557 | parity_560));
  logic or_683;
  assign or_683 = (parity_577 & parity_580) | ((^select_571_s9_q[8:6]) & (parity_577 | parity_580));
  logic or_687;
  assign or_687 = (parity_589 & parity_592) | ((^select_554_s9_q[5:3]) & (parity_589 | parity_592));
  // hls/stages/agreement.hpp:657
  logic [11:0] select_780;
  assign select_780 = and_524_s9_q ? select_779_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_786;
  assign parity_786 = ^select_780[5:3];
  logic parity_789;
  assign parity_789 = ^select_780[8:6];
  logic parity_792;
  assign parity_792 = ^select_780[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_803;
  assign select_803 = and_547_s9_q ? select_802_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_806;
  assign parity_806 = ^select_803[8:6];
  logic parity_809;
  assign parity_809 = ^select_803[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_820;
  assign select_820 = and_564_s9_q ? select_819_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_826;
  assign parity_826 = ^select_820[2:0];
  logic parity_829;
  assign parity_829 = ^select_820[5:3];
  logic parity_832;
  assign parity_832 = ^select_820[8:0];
  logic parity_838;
  assign parity_838 = ^select_820[11:9];
  logic parity_841;
  assign parity_841 = ^select_803[2:0];
  logic parity_844;
  assign parity_844 = ^{select_820[11:9], select_803[5:0]};
  logic parity_847;
  assign parity_847 = ^{select_820, select_803, select_780[2:0]};
  // hls/stages/agreement.hpp:671
  logic or_852;
  assign or_852 = (select_780[1:0] == 2'h3) | (select_780[2] & (select_780[0] | select_780[1]));
  // hls/stages/agreement.hpp:673
  logic or_856;
  assign or_856 = (select_803[7:6] == 2'h3) | (select_803[8] & (select_803[6] | select_803[7]));
  logic or_860;
  assign or_860 = (select_803[10:9] == 2'h3) | (select_803[11] & (select_803[9] | select_803[10]));
  // hls/stages/agreement.hpp:671
  logic or_868;
  assign or_868 = (select_820[7:6] == 2'h3) | (select_820[8] & (~(select_820[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_872;
  assign or_872 = (select_820[1:0] == 2'h3) | (select_820[2] & (select_820[0] | select_820[1]));
  logic or_876;
  assign or_876 = (select_820[4:3] == 2'h3) | (select_820[5] & (select_820[3] | select_820[4]));
  // hls/stages/agreement.hpp:672
  logic parity_879;
  assign parity_879 = ^{or_876, or_872, or_868};
  // hls/stages/agreement.hpp:671
  logic or_883;
  assign or_883 = (select_803[4:3] == 2'h3) | (select_803[5] & (select_803[3] | select_803[4]));
  // hls/stages/agreement.hpp:673
  logic or_887;
  assign or_887 = (select_820[10:9] == 2'h3) | (select_820[11] & (select_820[9] | select_820[10]));
  logic or_891;
  assign or_891 = (select_803[1:0] == 2'h3) | (select_803[2] & (select_803[0] | select_803[1]));
  // hls/stages/agreement.hpp:672
  logic parity_894;
  assign parity_894 = ^{or_891, or_887, or_883};
  logic parity_897;
  assign parity_897 = ^{or_891, or_887, or_883, or_876, or_872, or_868, or_860, or_856, or_852};
  // hls/stages/agreement.hpp:673
  logic or_902;
  assign or_902 = (parity_786 & parity_789) | ((^select_780[11:9]) & (parity_786 | parity_789));
  logic and_905;
  assign and_905 = (^{select_803[11:6], select_780[2:0]}) & (parity_832 | parity_844);
  // hls/stages/agreement.hpp:671
  logic or_913;
  assign or_913 = (select_780[10:9] == 2'h3) | (select_780[11] & (select_780[9] | select_780[10]));
  // hls/stages/agreement.hpp:673
  logic or_917;
  assign or_917 = (select_780[4:3] == 2'h3) | (select_780[5] & (select_780[3] | select_780[4]));
  logic or_921;
  assign or_921 = (select_780[7:6] == 2'h3) | (select_780[8] & (select_780[6] | select_780[7]));
  logic or_928;
  assign or_928 = (parity_806 & parity_809) | ((^select_780[2:0]) & (parity_806 | parity_809));
  logic or_932;
  assign or_932 = (parity_826 & parity_829) | ((^select_820[8:6]) & (parity_826 | parity_829));
  logic or_936;
  assign or_936 = (parity_838 & parity_841) | ((^select_803[5:3]) & (parity_838 | parity_841));
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1033;
  assign select_1033 = and_524_s9_q ? select_1032_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1039;
  assign parity_1039 = ^select_1033[5:3];
  logic parity_1042;
  assign parity_1042 = ^select_1033[8:6];
  logic parity_1045;
  assign parity_1045 = ^select_1033[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1054;
  assign select_1054 = and_547_s9_q ? select_1053_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1057;
  assign parity_1057 = ^select_1054[8:6];
  logic parity_1060;
  assign parity_1060 = ^select_1054[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1069;
  assign select_1069 = and_564_s9_q ? select_1068_s9_q : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1075;
  assign parity_1075 = ^select_1069[2:0];
  logic parity_1078;
  assign parity_1078 = ^select_1069[5:3];
  logic parity_1081;
  assign parity_1081 = ^select_1069[8:0];
  logic parity_1087;
  assign parity_1087 = ^select_1069[11:9];
  logic parity_1090;
  assign parity_1090 = ^select_1054[2:0];
  logic parity_1093;
  assign parity_1093 = ^{select_1069[11:9], select_1054[5:0]};
  logic parity_1096;
  assign parity_1096 = ^{select_1069, select_1054, select_1033[2:0]};
  // hls/stages/agreement.hpp:671
  logic or_1101;
  assign or_1101 = (select_1033[1:0] == 2'h3) | (select_1033[2] & (select_1033[0] | select_1033[1]));
  // hls/stages/agreement.hpp:673
  logic or_1105;
  assign or_1105 = (select_1054[7:6] == 2'h3) | (select_1054[8] & (select_1054[6] | select_1054[7]));
  logic or_1109;
  assign or_1109 = (select_1054[10:9] == 2'h3) | (select_1054[11] & (select_1054[9] | select_1054[10]));
  // hls/stages/agreement.hpp:671
  logic or_1117;
  assign or_1117 = (select_1069[7:6] == 2'h3) | (select_1069[8] & (~(select_1069[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1121;
  assign or_1121 = (select_1069[1:0] == 2'h3) | (select_1069[2] & (select_1069[0] | select_1069[1]));
  logic or_1125;
  assign or_1125 = (select_1069[4:3] == 2'h3) | (select_1069[5] & (select_1069[3] | select_1069[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1128;
  assign parity_1128 = ^{or_1125, or_1121, or_1117};
  // hls/stages/agreement.hpp:671
  logic or_1132;
  assign or_1132 = (select_1054[4:3] == 2'h3) | (select_1054[5] & (select_1054[3] | select_1054[4]));
  // hls/stages/agreement.hpp:673
  logic or_1136;
  assign or_1136 = (select_1069[10:9] == 2'h3) | (select_1069[11] & (select_1069[9] | select_1069[10]));
  logic or_1140;
  assign or_1140 = (select_1054[1:0] == 2'h3) | (select_1054[2] & (select_1054[0] | select_1054[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1143;
  assign parity_1143 = ^{or_1140, or_1136, or_1132};
  logic parity_1146;
  assign parity_1146 = ^{or_1140, or_1136, or_1132, or_1125, or_1121, or_1117, or_1109, or_1105, or_1101};
  // hls/stages/agreement.hpp:673
  logic or_1151;
  assign or_1151 = (parity_1039 & parity_1042) | ((^select_1033[11:9]) & (parity_1039 | parity_1042));
  logic and_1154;
  assign and_1154 = (^{select_1054[11:6], select_1033[2:0]}) & (parity_1081 | parity_1093);
  // hls/stages/agreement.hpp:671
  logic or_1162;
  assign or_1162 = (select_1033[10:9] == 2'h3) | (select_1033[11] & (select_1033[9] | select_1033[10]));
  // hls/stages/agreement.hpp:673
  logic or_1166;
  assign or_1166 = (select_1033[4:3] == 2'h3) | (select_1033[5] & (select_1033[3] | select_1033[4]));
  logic or_1170;
  assign or_1170 = (select_1033[7:6] == 2'h3) | (select_1033[8] & (select_1033[6] | select_1033[7]));
  logic or_1177;
  assign or_1177 = (parity_1057 & parity_1060) | ((^select_1033[2:0]) & (parity_1057 | parity_1060));
  logic or_1181;
  assign or_1181 = (parity_1075 & parity_1078) | ((^select_1069[8:6]) & (parity_1075 | parity_1078));
  logic or_1185;
  assign or_1185 = (parity_1087 & parity_1090) | ((^select_1054[5:3]) & (parity_1087 | parity_1090));
  // hls/stages/agreement.hpp:943
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:228
  logic or_1366;
  assign or_1366 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));
  // hls/stages/agreement.hpp:970
  logic [5:0] sum_1420;
  assign sum_1420 = {1'b0, last_s9_q[6:2]} + 6'h1;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_401_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_493_s9_q, left_rdata_s9_q[56:42], and_492_s9_q, left_rdata_s9_q[41:27], and_491_s9_q, left_rdata_s9_q[26:12], and_490_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_401_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_502_s9_q, right_codes_rdata_s9_q[71:60], and_501_s9_q, right_codes_rdata_s9_q[59:48], and_500_s9_q, right_codes_rdata_s9_q[47:36], and_499_s9_q, right_codes_rdata_s9_q[35:24], and_498_s9_q, right_codes_rdata_s9_q[23:12], and_497_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
  logic equal_328_s10_q;
  logic [8:0] select_334_s10_q;
  logic and_343_s10_q;
  logic equal_349_s10_q;
  logic whole_s10_q;
  logic [6:0] column_s10_q;
  logic and_367_s10_q;
  logic and_369_s10_q;
  logic equal_372_s10_q;
  logic so_s10_q;
  logic equal_389_s10_q;
  logic or_390_s10_q;
  logic equal_392_s10_q;
  logic less_397_s10_q;
  logic not_398_s10_q;
  logic equal_430_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_511_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic select_518_s10_q;
  logic xor_599_s10_q;
  logic parity_648_s10_q;
  logic and_649_s10_q;
  logic or_653_s10_q;
  logic or_657_s10_q;
  logic or_664_s10_q;
  logic or_668_s10_q;
  logic or_672_s10_q;
  logic or_679_s10_q;
  logic or_683_s10_q;
  logic or_687_s10_q;
  logic and_696_s10_q;
  logic and_698_s10_q;
  logic or_710_s10_q;
  logic or_714_s10_q;
  logic or_718_s10_q;
  logic xor_848_s10_q;
  logic parity_863_s10_q;
  logic parity_897_s10_q;
  logic and_898_s10_q;
  logic or_902_s10_q;
  logic or_906_s10_q;
  logic or_913_s10_q;
  logic or_917_s10_q;
  logic or_921_s10_q;
  logic or_928_s10_q;
  logic or_932_s10_q;
  logic or_936_s10_q;
  logic and_945_s10_q;
  logic or_946_s10_q;
  logic or_959_s10_q;
  logic or_963_s10_q;
  logic or_967_s10_q;
  logic xor_1097_s10_q;
  logic parity_1112_s10_q;
  logic parity_1146_s10_q;
  logic and_1147_s10_q;
  logic or_1151_s10_q;
  logic or_1155_s10_q;
  logic or_1162_s10_q;
  logic or_1166_s10_q;
  logic or_1170_s10_q;
  logic or_1177_s10_q;
  logic or_1181_s10_q;
  logic or_1185_s10_q;
  logic and_1194_s10_q;
  logic or_1195_s10_q;
  logic or_1208_s10_q;
  logic or_1212_s10_q;
  logic or_1216_s10_q;
  logic and_1320_s10_q;
  logic [6:0] select_1324_s10_q;
  logic [6:0] right_s10_q;
  logic select_1329_s10_q;
  logic equal_1338_s10_q;
  logic and_1345_s10_q;
  logic and_1348_s10_q;
  logic and_1352_s10_q;
  logic or_1366_s10_q;
  logic less_1421_s10_q;
  logic equal_1461_s10_q;
  logic and_1596_s10_q;
  logic equal_1739_s10_q;
  logic equal_1863_s10_q;
  logic less_2115_s10_q;
  logic and_2198_s10_q;
  logic and_2200_s10_q;
  logic less_2307_s10_q;
  logic equal_2514_s10_q;
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
      equal_328_s10_q <= equal_328_s9_q;
      select_334_s10_q <= select_334_s9_q;
      and_343_s10_q <= and_343_s9_q;
      equal_349_s10_q <= equal_349_s9_q;
      whole_s10_q <= whole_s9_q;
      column_s10_q <= column_s9_q;
      and_367_s10_q <= and_367_s9_q;
      and_369_s10_q <= and_369_s9_q;
      equal_372_s10_q <= equal_372_s9_q;
      so_s10_q <= so_s9_q;
      equal_389_s10_q <= equal_389_s9_q;
      or_390_s10_q <= or_390_s9_q;
      equal_392_s10_q <= equal_392_s9_q;
      less_397_s10_q <= less_397_s9_q;
      not_398_s10_q <= not_398_s9_q;
      equal_430_s10_q <= equal_430_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_511_s10_q <= select_511_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_518_s10_q <= select_518_s9_q;
      xor_599_s10_q <= parity_543 ^ parity_598;
      parity_648_s10_q <= parity_648;
      and_649_s10_q <= parity_543 & parity_598;
      or_653_s10_q <= or_653;
      or_657_s10_q <= (parity_583 & parity_595) | and_656;
      or_664_s10_q <= or_664;
      or_668_s10_q <= or_668;
      or_672_s10_q <= or_672;
      or_679_s10_q <= or_679;
      or_683_s10_q <= or_683;
      or_687_s10_q <= or_687;
      and_696_s10_q <= parity_630 & parity_645;
      and_698_s10_q <= (^{or_611, or_607, or_603}) & (parity_630 | parity_645);
      or_710_s10_q <= (or_607 & or_611) | (or_603 & (or_607 | or_611));
      or_714_s10_q <= (or_623 & or_627) | (or_619 & (or_623 | or_627));
      or_718_s10_q <= (or_638 & or_642) | (or_634 & (or_638 | or_642));
      xor_848_s10_q <= parity_792 ^ parity_847;
      parity_863_s10_q <= ^{or_860, or_856, or_852};
      parity_897_s10_q <= parity_897;
      and_898_s10_q <= parity_792 & parity_847;
      or_902_s10_q <= or_902;
      or_906_s10_q <= (parity_832 & parity_844) | and_905;
      or_913_s10_q <= or_913;
      or_917_s10_q <= or_917;
      or_921_s10_q <= or_921;
      or_928_s10_q <= or_928;
      or_932_s10_q <= or_932;
      or_936_s10_q <= or_936;
      and_945_s10_q <= parity_879 & parity_894;
      or_946_s10_q <= parity_879 | parity_894;
      or_959_s10_q <= (or_856 & or_860) | (or_852 & (or_856 | or_860));
      or_963_s10_q <= (or_872 & or_876) | (or_868 & (or_872 | or_876));
      or_967_s10_q <= (or_887 & or_891) | (or_883 & (or_887 | or_891));
      xor_1097_s10_q <= parity_1045 ^ parity_1096;
      parity_1112_s10_q <= ^{or_1109, or_1105, or_1101};
      parity_1146_s10_q <= parity_1146;
      and_1147_s10_q <= parity_1045 & parity_1096;
      or_1151_s10_q <= or_1151;
      or_1155_s10_q <= (parity_1081 & parity_1093) | and_1154;
      or_1162_s10_q <= or_1162;
      or_1166_s10_q <= or_1166;
      or_1170_s10_q <= or_1170;
      or_1177_s10_q <= or_1177;
      or_1181_s10_q <= or_1181;
      or_1185_s10_q <= or_1185;
      and_1194_s10_q <= parity_1128 & parity_1143;
      or_1195_s10_q <= parity_1128 | parity_1143;
      or_1208_s10_q <= (or_1105 & or_1109) | (or_1101 & (or_1105 | or_1109));
      or_1212_s10_q <= (or_1121 & or_1125) | (or_1117 & (or_1121 | or_1125));
      or_1216_s10_q <= (or_1136 & or_1140) | (or_1132 & (or_1136 | or_1140));
      and_1320_s10_q <= and_1320_s9_q;
      select_1324_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      select_1329_s10_q <= select_1329_s9_q;
      equal_1338_s10_q <= equal_1338_s9_q;
      and_1345_s10_q <= and_1345_s9_q;
      and_1348_s10_q <= and_1348_s9_q;
      and_1352_s10_q <= and_1352_s9_q;
      or_1366_s10_q <= or_1366;
      less_1421_s10_q <= {1'b0, sum_1420, last_s9_q[1]} < x_s9_q;
      equal_1461_s10_q <= x_s9_q == {1'b0, last_s9_q};
      and_1596_s10_q <= and_1593_s9_q & (~({sum_1420, last_s9_q[1:0]} < x_s9_q));
      equal_1739_s10_q <= equal_1739_s9_q;
      equal_1863_s10_q <= equal_1863_s9_q;
      less_2115_s10_q <= less_2115_s9_q;
      and_2198_s10_q <= and_2198_s9_q;
      and_2200_s10_q <= and_2200_s9_q;
      less_2307_s10_q <= less_2307_s9_q;
      equal_2514_s10_q <= equal_2514_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:672
  logic parity_675;
  assign parity_675 = ^{or_672_s10_q, or_668_s10_q, or_664_s10_q};
  logic parity_690;
  assign parity_690 = ^{or_687_s10_q, or_683_s10_q, or_679_s10_q};
  logic parity_693;
  assign parity_693 = ^{or_687_s10_q, or_683_s10_q, or_679_s10_q, or_672_s10_q, or_668_s10_q, or_664_s10_q, or_657_s10_q, or_653_s10_q, and_649_s10_q};
  // hls/stages/agreement.hpp:673
  logic and_695;
  assign and_695 = parity_648_s10_q & parity_693;
  logic or_699;
  assign or_699 = and_696_s10_q | and_698_s10_q;
  logic and_702;
  assign and_702 = (^{or_657_s10_q, or_653_s10_q, and_649_s10_q}) & (parity_675 | parity_690);
  logic or_703;
  assign or_703 = (parity_675 & parity_690) | and_702;
  // hls/stages/agreement.hpp:672
  logic parity_721;
  assign parity_721 = ^{or_718_s10_q, or_714_s10_q, or_710_s10_q};
  // hls/stages/agreement.hpp:673
  logic or_725;
  assign or_725 = (or_653_s10_q & or_657_s10_q) | (and_649_s10_q & (or_653_s10_q | or_657_s10_q));
  logic or_729;
  assign or_729 = (or_668_s10_q & or_672_s10_q) | (or_664_s10_q & (or_668_s10_q | or_672_s10_q));
  logic or_733;
  assign or_733 = (or_683_s10_q & or_687_s10_q) | (or_679_s10_q & (or_683_s10_q | or_687_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_736;
  assign parity_736 = ^{or_733, or_729, or_725};
  logic parity_739;
  assign parity_739 = ^{or_733, or_729, or_725, or_718_s10_q, or_714_s10_q, or_710_s10_q, or_703, or_699, and_695};
  // hls/stages/agreement.hpp:673
  logic or_751;
  assign or_751 = (or_714_s10_q & or_718_s10_q) | (or_710_s10_q & (or_714_s10_q | or_718_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_924;
  assign parity_924 = ^{or_921_s10_q, or_917_s10_q, or_913_s10_q};
  logic parity_939;
  assign parity_939 = ^{or_936_s10_q, or_932_s10_q, or_928_s10_q};
  logic parity_942;
  assign parity_942 = ^{or_936_s10_q, or_932_s10_q, or_928_s10_q, or_921_s10_q, or_917_s10_q, or_913_s10_q, or_906_s10_q, or_902_s10_q, and_898_s10_q};
  // hls/stages/agreement.hpp:673
  logic and_944;
  assign and_944 = parity_897_s10_q & parity_942;
  logic or_948;
  assign or_948 = and_945_s10_q | (parity_863_s10_q & or_946_s10_q);
  logic and_951;
  assign and_951 = (^{or_906_s10_q, or_902_s10_q, and_898_s10_q}) & (parity_924 | parity_939);
  logic or_952;
  assign or_952 = (parity_924 & parity_939) | and_951;
  // hls/stages/agreement.hpp:672
  logic parity_970;
  assign parity_970 = ^{or_967_s10_q, or_963_s10_q, or_959_s10_q};
  // hls/stages/agreement.hpp:673
  logic or_974;
  assign or_974 = (or_902_s10_q & or_906_s10_q) | (and_898_s10_q & (or_902_s10_q | or_906_s10_q));
  logic or_978;
  assign or_978 = (or_917_s10_q & or_921_s10_q) | (or_913_s10_q & (or_917_s10_q | or_921_s10_q));
  logic or_982;
  assign or_982 = (or_932_s10_q & or_936_s10_q) | (or_928_s10_q & (or_932_s10_q | or_936_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_985;
  assign parity_985 = ^{or_982, or_978, or_974};
  logic parity_988;
  assign parity_988 = ^{or_982, or_978, or_974, or_967_s10_q, or_963_s10_q, or_959_s10_q, or_952, or_948, and_944};
  // hls/stages/agreement.hpp:673
  logic or_1000;
  assign or_1000 = (or_963_s10_q & or_967_s10_q) | (or_959_s10_q & (or_963_s10_q | or_967_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_1173;
  assign parity_1173 = ^{or_1170_s10_q, or_1166_s10_q, or_1162_s10_q};
  logic parity_1188;
  assign parity_1188 = ^{or_1185_s10_q, or_1181_s10_q, or_1177_s10_q};
  logic parity_1191;
  assign parity_1191 = ^{or_1185_s10_q, or_1181_s10_q, or_1177_s10_q, or_1170_s10_q, or_1166_s10_q, or_1162_s10_q, or_1155_s10_q, or_1151_s10_q, and_1147_s10_q};
  // hls/stages/agreement.hpp:673
  logic and_1193;
  assign and_1193 = parity_1146_s10_q & parity_1191;
  logic or_1197;
  assign or_1197 = and_1194_s10_q | (parity_1112_s10_q & or_1195_s10_q);
  logic and_1200;
  assign and_1200 = (^{or_1155_s10_q, or_1151_s10_q, and_1147_s10_q}) & (parity_1173 | parity_1188);
  logic or_1201;
  assign or_1201 = (parity_1173 & parity_1188) | and_1200;
  // hls/stages/agreement.hpp:672
  logic parity_1219;
  assign parity_1219 = ^{or_1216_s10_q, or_1212_s10_q, or_1208_s10_q};
  // hls/stages/agreement.hpp:673
  logic or_1223;
  assign or_1223 = (or_1151_s10_q & or_1155_s10_q) | (and_1147_s10_q & (or_1151_s10_q | or_1155_s10_q));
  logic or_1227;
  assign or_1227 = (or_1166_s10_q & or_1170_s10_q) | (or_1162_s10_q & (or_1166_s10_q | or_1170_s10_q));
  logic or_1231;
  assign or_1231 = (or_1181_s10_q & or_1185_s10_q) | (or_1177_s10_q & (or_1181_s10_q | or_1185_s10_q));
  // hls/stages/agreement.hpp:672
  logic parity_1234;
  assign parity_1234 = ^{or_1231, or_1227, or_1223};
  logic parity_1237;
  assign parity_1237 = ^{or_1231, or_1227, or_1223, or_1216_s10_q, or_1212_s10_q, or_1208_s10_q, or_1201, or_1197, and_1193};
  // hls/stages/agreement.hpp:673
  logic or_1249;
  assign or_1249 = (or_1212_s10_q & or_1216_s10_q) | (or_1208_s10_q & (or_1212_s10_q | or_1216_s10_q));
  // hls/stages/agreement.hpp:137
  logic [6:0] select_1376;
  assign select_1376 = or_390_s10_q ? (less_397_s10_q ? 7'h0 : select_1324_s10_q) : 7'h0;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1302; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_390_s10_q ? select_1324_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_511_s10_q;
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
  logic equal_328_s11_q;
  logic [8:0] select_334_s11_q;
  logic and_343_s11_q;
  logic equal_349_s11_q;
  logic whole_s11_q;
  logic [6:0] column_s11_q;
  logic and_367_s11_q;
  logic and_369_s11_q;
  logic equal_372_s11_q;
  logic so_s11_q;
  logic equal_389_s11_q;
  logic or_390_s11_q;
  logic equal_392_s11_q;
  logic less_397_s11_q;
  logic not_398_s11_q;
  logic equal_430_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic select_518_s11_q;
  logic xor_599_s11_q;
  logic xor_694_s11_q;
  logic parity_739_s11_q;
  logic and_740_s11_q;
  logic and_742_s11_q;
  logic and_744_s11_q;
  logic and_746_s11_q;
  logic or_751_s11_q;
  logic or_755_s11_q;
  logic xor_848_s11_q;
  logic xor_943_s11_q;
  logic parity_988_s11_q;
  logic and_989_s11_q;
  logic and_991_s11_q;
  logic and_993_s11_q;
  logic and_995_s11_q;
  logic or_1000_s11_q;
  logic or_1004_s11_q;
  logic xor_1097_s11_q;
  logic xor_1192_s11_q;
  logic parity_1237_s11_q;
  logic and_1238_s11_q;
  logic and_1240_s11_q;
  logic and_1242_s11_q;
  logic and_1244_s11_q;
  logic or_1249_s11_q;
  logic or_1253_s11_q;
  logic and_1320_s11_q;
  logic [6:0] right_s11_q;
  logic select_1329_s11_q;
  logic equal_1338_s11_q;
  logic and_1345_s11_q;
  logic and_1348_s11_q;
  logic and_1352_s11_q;
  logic or_1366_s11_q;
  logic [6:0] select_1377_s11_q;
  logic less_1421_s11_q;
  logic equal_1461_s11_q;
  logic and_1598_s11_q;
  logic equal_1739_s11_q;
  logic equal_1863_s11_q;
  logic less_2115_s11_q;
  logic and_2198_s11_q;
  logic and_2200_s11_q;
  logic less_2307_s11_q;
  logic equal_2514_s11_q;
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
      equal_328_s11_q <= equal_328_s10_q;
      select_334_s11_q <= select_334_s10_q;
      and_343_s11_q <= and_343_s10_q;
      equal_349_s11_q <= equal_349_s10_q;
      whole_s11_q <= whole_s10_q;
      column_s11_q <= column_s10_q;
      and_367_s11_q <= and_367_s10_q;
      and_369_s11_q <= and_369_s10_q;
      equal_372_s11_q <= equal_372_s10_q;
      so_s11_q <= so_s10_q;
      equal_389_s11_q <= equal_389_s10_q;
      or_390_s11_q <= or_390_s10_q;
      equal_392_s11_q <= equal_392_s10_q;
      less_397_s11_q <= less_397_s10_q;
      not_398_s11_q <= not_398_s10_q;
      equal_430_s11_q <= equal_430_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_518_s11_q <= select_518_s10_q;
      xor_599_s11_q <= xor_599_s10_q;
      xor_694_s11_q <= parity_648_s10_q ^ parity_693;
      parity_739_s11_q <= parity_739;
      and_740_s11_q <= parity_721 & parity_736;
      and_742_s11_q <= (^{or_703, or_699, and_695}) & (parity_721 | parity_736);
      and_744_s11_q <= or_699 & or_703;
      and_746_s11_q <= and_695 & (or_699 | or_703);
      or_751_s11_q <= or_751;
      or_755_s11_q <= (or_729 & or_733) | (or_725 & (or_729 | or_733));
      xor_848_s11_q <= xor_848_s10_q;
      xor_943_s11_q <= parity_897_s10_q ^ parity_942;
      parity_988_s11_q <= parity_988;
      and_989_s11_q <= parity_970 & parity_985;
      and_991_s11_q <= (^{or_952, or_948, and_944}) & (parity_970 | parity_985);
      and_993_s11_q <= or_948 & or_952;
      and_995_s11_q <= and_944 & (or_948 | or_952);
      or_1000_s11_q <= or_1000;
      or_1004_s11_q <= (or_978 & or_982) | (or_974 & (or_978 | or_982));
      xor_1097_s11_q <= xor_1097_s10_q;
      xor_1192_s11_q <= parity_1146_s10_q ^ parity_1191;
      parity_1237_s11_q <= parity_1237;
      and_1238_s11_q <= parity_1219 & parity_1234;
      and_1240_s11_q <= (^{or_1201, or_1197, and_1193}) & (parity_1219 | parity_1234);
      and_1242_s11_q <= or_1197 & or_1201;
      and_1244_s11_q <= and_1193 & (or_1197 | or_1201);
      or_1249_s11_q <= or_1249;
      or_1253_s11_q <= (or_1227 & or_1231) | (or_1223 & (or_1227 | or_1231));
      and_1320_s11_q <= and_1320_s10_q;
      right_s11_q <= right_s10_q;
      select_1329_s11_q <= select_1329_s10_q;
      equal_1338_s11_q <= equal_1338_s10_q;
      and_1345_s11_q <= and_1345_s10_q;
      and_1348_s11_q <= and_1348_s10_q;
      and_1352_s11_q <= and_1352_s10_q;
      or_1366_s11_q <= or_1366_s10_q;
      select_1377_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1376;
      less_1421_s11_q <= less_1421_s10_q;
      equal_1461_s11_q <= equal_1461_s10_q;
      and_1598_s11_q <= so_s10_q & (ends_cell_s10_q & and_1596_s10_q);
      equal_1739_s11_q <= equal_1739_s10_q;
      equal_1863_s11_q <= equal_1863_s10_q;
      less_2115_s11_q <= less_2115_s10_q;
      and_2198_s11_q <= and_2198_s10_q;
      and_2200_s11_q <= and_2200_s10_q;
      less_2307_s11_q <= less_2307_s10_q;
      equal_2514_s11_q <= equal_2514_s10_q;
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
  logic or_743;
  assign or_743 = and_740_s11_q | and_742_s11_q;
  logic or_747;
  assign or_747 = and_744_s11_q | and_746_s11_q;
  // hls/stages/agreement.hpp:672
  logic parity_760;
  assign parity_760 = ^{or_755_s11_q, or_751_s11_q, or_747, or_743};
  // hls/stages/agreement.hpp:673
  logic or_764;
  assign or_764 = (or_751_s11_q & or_755_s11_q) | (or_747 & (or_751_s11_q | or_755_s11_q));
  logic and_765;
  assign and_765 = or_743 & (^{or_755_s11_q, or_751_s11_q, or_747});
  // hls/stages/agreement.hpp:672
  logic xor_766;
  assign xor_766 = or_764 ^ and_765;
  // hls/stages/agreement.hpp:675
  logic and_767;
  assign and_767 = or_764 & and_765;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_768;
  assign select_768 = equal_392_s11_q ? {and_767, xor_766, parity_760, parity_739_s11_q, xor_694_s11_q, xor_599_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_390_s11_q ? 6'h0 : select_768;
  // hls/stages/agreement.hpp:673
  logic or_992;
  assign or_992 = and_989_s11_q | and_991_s11_q;
  logic or_996;
  assign or_996 = and_993_s11_q | and_995_s11_q;
  // hls/stages/agreement.hpp:672
  logic parity_1009;
  assign parity_1009 = ^{or_1004_s11_q, or_1000_s11_q, or_996, or_992};
  // hls/stages/agreement.hpp:673
  logic or_1013;
  assign or_1013 = (or_1000_s11_q & or_1004_s11_q) | (or_996 & (or_1000_s11_q | or_1004_s11_q));
  logic and_1014;
  assign and_1014 = or_992 & (^{or_1004_s11_q, or_1000_s11_q, or_996});
  // hls/stages/agreement.hpp:672
  logic xor_1015;
  assign xor_1015 = or_1013 ^ and_1014;
  // hls/stages/agreement.hpp:675
  logic and_1016;
  assign and_1016 = or_1013 & and_1014;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1017;
  assign select_1017 = equal_392_s11_q ? {and_1016, xor_1015, parity_1009, parity_988_s11_q, xor_943_s11_q, xor_848_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_390_s11_q ? 6'h0 : select_1017;
  // hls/stages/agreement.hpp:673
  logic or_1241;
  assign or_1241 = and_1238_s11_q | and_1240_s11_q;
  logic or_1245;
  assign or_1245 = and_1242_s11_q | and_1244_s11_q;
  // hls/stages/agreement.hpp:672
  logic parity_1258;
  assign parity_1258 = ^{or_1253_s11_q, or_1249_s11_q, or_1245, or_1241};
  // hls/stages/agreement.hpp:673
  logic or_1262;
  assign or_1262 = (or_1249_s11_q & or_1253_s11_q) | (or_1245 & (or_1249_s11_q | or_1253_s11_q));
  logic and_1263;
  assign and_1263 = or_1241 & (^{or_1253_s11_q, or_1249_s11_q, or_1245});
  // hls/stages/agreement.hpp:672
  logic xor_1264;
  assign xor_1264 = or_1262 ^ and_1263;
  // hls/stages/agreement.hpp:675
  logic and_1265;
  assign and_1265 = or_1262 & and_1263;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1266;
  assign select_1266 = equal_392_s11_q ? {and_1265, xor_1264, parity_1258, parity_1237_s11_q, xor_1192_s11_q, xor_1097_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_390_s11_q ? 6'h0 : select_1266;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1306;
  assign sum_1306 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1309;
  assign sum_1309 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};

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
  logic equal_328_s12_q;
  logic [8:0] select_334_s12_q;
  logic and_343_s12_q;
  logic equal_349_s12_q;
  logic whole_s12_q;
  logic [6:0] column_s12_q;
  logic and_367_s12_q;
  logic and_369_s12_q;
  logic equal_372_s12_q;
  logic so_s12_q;
  logic equal_389_s12_q;
  logic or_390_s12_q;
  logic less_397_s12_q;
  logic not_398_s12_q;
  logic equal_430_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic select_518_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1019_s12_q;
  logic [5:0] select_1268_s12_q;
  logic [6:0] sum_1307_s12_q;
  logic [6:0] sum_1310_s12_q;
  logic and_1320_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic select_1329_s12_q;
  logic equal_1338_s12_q;
  logic and_1345_s12_q;
  logic and_1348_s12_q;
  logic and_1352_s12_q;
  logic or_1366_s12_q;
  logic [6:0] select_1377_s12_q;
  logic less_1421_s12_q;
  logic equal_1461_s12_q;
  logic and_1598_s12_q;
  logic equal_1739_s12_q;
  logic equal_1863_s12_q;
  logic less_2115_s12_q;
  logic and_2198_s12_q;
  logic and_2200_s12_q;
  logic less_2307_s12_q;
  logic equal_2514_s12_q;
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
      equal_328_s12_q <= equal_328_s11_q;
      select_334_s12_q <= select_334_s11_q;
      and_343_s12_q <= and_343_s11_q;
      equal_349_s12_q <= equal_349_s11_q;
      whole_s12_q <= whole_s11_q;
      column_s12_q <= column_s11_q;
      and_367_s12_q <= and_367_s11_q;
      and_369_s12_q <= and_369_s11_q;
      equal_372_s12_q <= equal_372_s11_q;
      so_s12_q <= so_s11_q;
      equal_389_s12_q <= equal_389_s11_q;
      or_390_s12_q <= or_390_s11_q;
      less_397_s12_q <= less_397_s11_q;
      not_398_s12_q <= not_398_s11_q;
      equal_430_s12_q <= equal_430_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_518_s12_q <= select_518_s11_q;
      column_2_s12_q <= column_2;
      select_1019_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1268_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1307_s12_q <= {1'b0, before_v_2} + sum_1306;
      sum_1310_s12_q <= {1'b0, before_v_3} + sum_1309;
      and_1320_s12_q <= and_1320_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      select_1329_s12_q <= select_1329_s11_q;
      equal_1338_s12_q <= equal_1338_s11_q;
      and_1345_s12_q <= and_1345_s11_q;
      and_1348_s12_q <= and_1348_s11_q;
      and_1352_s12_q <= and_1352_s11_q;
      or_1366_s12_q <= or_1366_s11_q;
      select_1377_s12_q <= select_1377_s11_q;
      less_1421_s12_q <= less_1421_s11_q;
      equal_1461_s12_q <= equal_1461_s11_q;
      and_1598_s12_q <= and_1598_s11_q;
      equal_1739_s12_q <= equal_1739_s11_q;
      equal_1863_s12_q <= equal_1863_s11_q;
      less_2115_s12_q <= less_2115_s11_q;
      and_2198_s12_q <= and_2198_s11_q;
      and_2200_s12_q <= and_2200_s11_q;
      less_2307_s12_q <= less_2307_s11_q;
      equal_2514_s12_q <= equal_2514_s11_q;
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
  logic [5:0] select_770;
  assign select_770 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1302;
  assign sum_1302 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1312;
  assign select_1312 = (sum_1307_s12_q < sum_1310_s12_q) ? sum_1310_s12_q : sum_1307_s12_q;
  // hls/stages/agreement.hpp:951
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:220
  logic [5:0] select_1963;
  assign select_1963 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_1964;
  assign select_1964 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1965;
  assign select_1965 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_1966;
  assign select_1966 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1967;
  assign select_1967 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1968;
  assign select_1968 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;

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
      middle_sum_columns_values_1_q <= select_1963;
      middle_sum_columns_values_2_q <= select_1964;
      middle_sum_columns_values_3_q <= select_1965;
      middle_sum_columns_values_4_q <= select_1966;
      middle_sum_columns_values_5_q <= select_1967;
      middle_sum_columns_values_6_q <= select_1968;
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
  logic equal_328_s13_q;
  logic [8:0] select_334_s13_q;
  logic and_343_s13_q;
  logic equal_349_s13_q;
  logic whole_s13_q;
  logic [6:0] column_s13_q;
  logic and_367_s13_q;
  logic and_369_s13_q;
  logic equal_372_s13_q;
  logic so_s13_q;
  logic equal_389_s13_q;
  logic or_390_s13_q;
  logic less_397_s13_q;
  logic not_398_s13_q;
  logic equal_430_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_518_s13_q;
  logic [6:0] difference_771_s13_q;
  logic [6:0] difference_1020_s13_q;
  logic equal_1021_s13_q;
  logic [6:0] difference_1269_s13_q;
  logic [6:0] sum_1303_s13_q;
  logic [6:0] select_1312_s13_q;
  logic and_1320_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1329_s13_q;
  logic equal_1338_s13_q;
  logic and_1345_s13_q;
  logic and_1348_s13_q;
  logic and_1352_s13_q;
  logic less_1353_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1366_s13_q;
  logic [6:0] select_1377_s13_q;
  logic less_1421_s13_q;
  logic equal_1461_s13_q;
  logic and_1598_s13_q;
  logic equal_1739_s13_q;
  logic equal_1863_s13_q;
  logic less_2115_s13_q;
  logic and_2198_s13_q;
  logic and_2200_s13_q;
  logic less_2307_s13_q;
  logic equal_2514_s13_q;
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
      equal_328_s13_q <= equal_328_s12_q;
      select_334_s13_q <= select_334_s12_q;
      and_343_s13_q <= and_343_s12_q;
      equal_349_s13_q <= equal_349_s12_q;
      whole_s13_q <= whole_s12_q;
      column_s13_q <= column_s12_q;
      and_367_s13_q <= and_367_s12_q;
      and_369_s13_q <= and_369_s12_q;
      equal_372_s13_q <= equal_372_s12_q;
      so_s13_q <= so_s12_q;
      equal_389_s13_q <= equal_389_s12_q;
      or_390_s13_q <= or_390_s12_q;
      less_397_s13_q <= less_397_s12_q;
      not_398_s13_q <= not_398_s12_q;
      equal_430_s13_q <= equal_430_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_518_s13_q <= select_518_s12_q;
      difference_771_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_770};
      difference_1020_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1019_s12_q};
      equal_1021_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1269_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1268_s12_q};
      sum_1303_s13_q <= {1'b0, before_v} + sum_1302;
      select_1312_s13_q <= select_1312;
      and_1320_s13_q <= and_1320_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1329_s13_q <= select_1329_s12_q;
      equal_1338_s13_q <= equal_1338_s12_q;
      and_1345_s13_q <= and_1345_s12_q;
      and_1348_s13_q <= and_1348_s12_q;
      and_1352_s13_q <= and_1352_s12_q;
      less_1353_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1366_s13_q <= or_1366_s12_q;
      select_1377_s13_q <= select_1377_s12_q;
      less_1421_s13_q <= less_1421_s12_q;
      equal_1461_s13_q <= equal_1461_s12_q;
      and_1598_s13_q <= and_1598_s12_q;
      equal_1739_s13_q <= equal_1739_s12_q;
      equal_1863_s13_q <= equal_1863_s12_q;
      less_2115_s13_q <= less_2115_s12_q;
      and_2198_s13_q <= and_2198_s12_q;
      and_2200_s13_q <= and_2200_s12_q;
      less_2307_s13_q <= less_2307_s12_q;
      equal_2514_s13_q <= equal_2514_s12_q;
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
  logic less_519;
  assign less_519 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_521;
  assign less_521 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:224
  logic and_523;
  assign and_523 = (~less_519) & (~less_521);
  // hls/stages/agreement.hpp:777
  logic [7:0] sum_773;
  assign sum_773 = {difference_771_s13_q[6], difference_771_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1023;
  assign sum_1023 = {difference_1020_s13_q[6], difference_1020_s13_q} + (equal_1021_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1271;
  assign sum_1271 = {difference_1269_s13_q[6], difference_1269_s13_q} + (equal_1021_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:754
  logic [6:0] select_1304;
  assign select_1304 = slot_s13_q[0] ? chosen_near_q : sum_1303_s13_q;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1314;
  assign select_1314 = (select_1304 < select_1312_s13_q) ? select_1312_s13_q : select_1304;
  // hls/stages/agreement.hpp:792
  logic [6:0] of_near;
  assign of_near = and_523 ? select_1314 : 7'h0;
  // hls/stages/agreement.hpp:950
  logic select_1355;
  assign select_1355 = slot_s13_q[2] ? less_1353_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:957
  logic [8:0] difference_1358;
  assign difference_1358 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/agreement.hpp:220
  logic [6:0] select_1974;
  assign select_1974 = slot_s13_q[0] ? 7'h0 : sum_1303_s13_q;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1976;
  assign select_1976 = (select_1974 < select_1312_s13_q) ? select_1312_s13_q : select_1974;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_near_q <= 7'h0;
    end else if (s13_en) begin
      chosen_near_q <= select_1976;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_773;
      sums_0_sum_sums_values_0_q <= sum_1023;
      sums_0_sum_sums_values_1_q <= equal_1021_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1271;
      sums_1_sum_sums_values_1_q <= equal_1021_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic equal_328_s14_q;
  logic [8:0] select_334_s14_q;
  logic and_343_s14_q;
  logic equal_349_s14_q;
  logic whole_s14_q;
  logic [6:0] column_s14_q;
  logic and_367_s14_q;
  logic and_369_s14_q;
  logic equal_372_s14_q;
  logic so_s14_q;
  logic equal_389_s14_q;
  logic or_390_s14_q;
  logic less_397_s14_q;
  logic not_398_s14_q;
  logic equal_430_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_518_s14_q;
  logic and_523_s14_q;
  logic [7:0] sum_773_s14_q;
  logic less_1272_s14_q;
  logic [6:0] of_near_s14_q;
  logic and_1320_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1329_s14_q;
  logic equal_1338_s14_q;
  logic and_1345_s14_q;
  logic and_1348_s14_q;
  logic and_1352_s14_q;
  logic select_1355_s14_q;
  logic [9:0] sum_1359_s14_q;
  logic or_1366_s14_q;
  logic [6:0] select_1377_s14_q;
  logic less_1421_s14_q;
  logic equal_1461_s14_q;
  logic and_1598_s14_q;
  logic equal_1739_s14_q;
  logic equal_1863_s14_q;
  logic less_2115_s14_q;
  logic and_2198_s14_q;
  logic and_2200_s14_q;
  logic and_2207_s14_q;
  logic less_2307_s14_q;
  logic equal_2514_s14_q;
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
      equal_328_s14_q <= equal_328_s13_q;
      select_334_s14_q <= select_334_s13_q;
      and_343_s14_q <= and_343_s13_q;
      equal_349_s14_q <= equal_349_s13_q;
      whole_s14_q <= whole_s13_q;
      column_s14_q <= column_s13_q;
      and_367_s14_q <= and_367_s13_q;
      and_369_s14_q <= and_369_s13_q;
      equal_372_s14_q <= equal_372_s13_q;
      so_s14_q <= so_s13_q;
      equal_389_s14_q <= equal_389_s13_q;
      or_390_s14_q <= or_390_s13_q;
      less_397_s14_q <= less_397_s13_q;
      not_398_s14_q <= not_398_s13_q;
      equal_430_s14_q <= equal_430_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_518_s14_q <= select_518_s13_q;
      and_523_s14_q <= and_523;
      sum_773_s14_q <= sum_773;
      less_1272_s14_q <= sum_1023 < sum_1271;
      of_near_s14_q <= of_near;
      and_1320_s14_q <= and_1320_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1329_s14_q <= select_1329_s13_q;
      equal_1338_s14_q <= equal_1338_s13_q;
      and_1345_s14_q <= and_1345_s13_q;
      and_1348_s14_q <= and_1348_s13_q;
      and_1352_s14_q <= and_1352_s13_q;
      select_1355_s14_q <= select_1355;
      sum_1359_s14_q <= {difference_1358[8], difference_1358} + 10'h1;
      or_1366_s14_q <= or_1366_s13_q;
      select_1377_s14_q <= select_1377_s13_q;
      less_1421_s14_q <= less_1421_s13_q;
      equal_1461_s14_q <= equal_1461_s13_q;
      and_1598_s14_q <= and_1598_s13_q;
      equal_1739_s14_q <= equal_1739_s13_q;
      equal_1863_s14_q <= equal_1863_s13_q;
      less_2115_s14_q <= less_2115_s13_q;
      and_2198_s14_q <= and_2198_s13_q;
      and_2200_s14_q <= and_2200_s13_q;
      and_2207_s14_q <= ends_cell_s13_q & so_s13_q;
      less_2307_s14_q <= less_2307_s13_q;
      equal_2514_s14_q <= equal_2514_s13_q;
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
  logic [7:0] select_774;
  assign select_774 = slot_s14_q[0] ? chosen_score_q : sum_773_s14_q;
  // hls/stages/agreement.hpp:750
  logic [7:0] select_1273;
  assign select_1273 = less_1272_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1274;
  assign less_1274 = select_774 < select_1273;
  // hls/stages/agreement.hpp:791
  logic [7:0] of_best;
  assign of_best = and_523_s14_q ? (less_1274 ? select_1273 : select_774) : 8'h0;
  // hls/stages/agreement.hpp:719
  logic not_1280;
  assign not_1280 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:751
  logic [1:0] select_1281;
  assign select_1281 = less_1272_s14_q ? {slot_s14_q[0], not_1280} : 2'h0;
  logic [2:0] select_1283;
  assign select_1283 = less_1274 ? {select_1281, not_1280} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:220
  logic [7:0] select_1292;
  assign select_1292 = slot_s14_q[0] ? 8'h0 : sum_773_s14_q;
  // hls/stages/agreement.hpp:803
  logic or_1317;
  assign or_1317 = select_518_s14_q | (best_left_rdata_s14_q[39:33] < of_near_s14_q);
  // hls/stages/agreement.hpp:816
  logic or_1335;
  assign or_1335 = select_1329_s14_q | (best_right_rdata_s14_q[21:15] < of_near_s14_q);
  // hls/stages/agreement.hpp:228
  logic and_1361;
  assign and_1361 = (and_1348_s14_q & select_1355_s14_q) & ({{22{sum_1359_s14_q[9]}}, sum_1359_s14_q} < 32'h3);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1459;
  assign sum_1459 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:750
  logic less_1972;
  assign less_1972 = select_1292 < select_1273;
  // hls/stages/agreement.hpp:137
  logic [7:0] select_2067;
  assign select_2067 = or_390_s14_q ? (less_397_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2069;
  assign select_2069 = or_390_s14_q ? (less_397_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:213
  logic [16:0] select_2089;
  assign select_2089 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/registration.hpp:128
  logic [15:0] select_2201;
  assign select_2201 = and_2200_s14_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2203;
  assign select_2203 = and_2198_s14_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2201[15]}}, select_2201});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2204;
  assign select_2204 = and_2200_s14_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2204[15]}}, select_2204};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2206;
  assign select_2206 = and_2198_s14_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:124
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2207_s14_q ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:190
  logic [8:0] select_2319;
  assign select_2319 = so_s14_q ? (and_2207_s14_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2321;
  assign sum_2321 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2322;
  assign select_2322 = sum_1459[5] ? {1'b1, sum_1459[4:0], region_across_rest_q[2:0]} : sum_2321;
  // hls/stages/agreement.hpp:436
  logic [8:0] select_2324;
  assign select_2324 = equal_1863_s14_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_2327;
  assign select_2327 = equal_1863_s14_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

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
      chosen_score_q <= less_1972 ? select_1273 : select_1292;
      chosen_place_q <= less_1972 ? {select_1281, not_1280} : 3'h2;
      before_0_q <= select_1292;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      registration_slope_row_q <= select_2203;
      registration_slope_change_q <= select_2206;
      registration_slope_q <= so_s14_q ? column_5 : {registration_slope_row_q, 4'h0};
      region_across_rest_q <= select_2319;
      region_across_back_q <= so_s14_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2322;
      columns_begin_rest_q <= and_369_s14_q ? select_2324 : columns_begin_rest_q;
      columns_begin_back_q <= and_369_s14_q ? select_2327 : columns_begin_back_q;
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
  logic equal_328_s15_q;
  logic [8:0] select_334_s15_q;
  logic and_343_s15_q;
  logic equal_349_s15_q;
  logic whole_s15_q;
  logic [6:0] column_s15_q;
  logic and_367_s15_q;
  logic and_369_s15_q;
  logic equal_372_s15_q;
  logic so_s15_q;
  logic equal_389_s15_q;
  logic or_390_s15_q;
  logic less_397_s15_q;
  logic not_398_s15_q;
  logic equal_430_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_518_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1283_s15_q;
  logic [6:0] of_near_s15_q;
  logic or_1317_s15_q;
  logic and_1320_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1329_s15_q;
  logic or_1335_s15_q;
  logic equal_1338_s15_q;
  logic and_1345_s15_q;
  logic and_1349_s15_q;
  logic and_1352_s15_q;
  logic and_1362_s15_q;
  logic and_1367_s15_q;
  logic [6:0] select_1377_s15_q;
  logic less_1421_s15_q;
  logic sum_1459_s15_q;
  logic equal_1461_s15_q;
  logic and_1598_s15_q;
  logic equal_1739_s15_q;
  logic equal_1863_s15_q;
  logic [7:0] select_2067_s15_q;
  logic [7:0] select_2069_s15_q;
  logic [16:0] select_2089_s15_q;
  logic less_2115_s15_q;
  logic less_2307_s15_q;
  logic equal_2514_s15_q;
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
      equal_328_s15_q <= equal_328_s14_q;
      select_334_s15_q <= select_334_s14_q;
      and_343_s15_q <= and_343_s14_q;
      equal_349_s15_q <= equal_349_s14_q;
      whole_s15_q <= whole_s14_q;
      column_s15_q <= column_s14_q;
      and_367_s15_q <= and_367_s14_q;
      and_369_s15_q <= and_369_s14_q;
      equal_372_s15_q <= equal_372_s14_q;
      so_s15_q <= so_s14_q;
      equal_389_s15_q <= equal_389_s14_q;
      or_390_s15_q <= or_390_s14_q;
      less_397_s15_q <= less_397_s14_q;
      not_398_s15_q <= not_398_s14_q;
      equal_430_s15_q <= equal_430_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_518_s15_q <= select_518_s14_q;
      of_best_s15_q <= of_best;
      select_1283_s15_q <= select_1283;
      of_near_s15_q <= of_near_s14_q;
      or_1317_s15_q <= or_1317;
      and_1320_s15_q <= and_1320_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1329_s15_q <= select_1329_s14_q;
      or_1335_s15_q <= or_1335;
      equal_1338_s15_q <= equal_1338_s14_q;
      and_1345_s15_q <= and_1345_s14_q;
      and_1349_s15_q <= not_398_s14_q & and_1348_s14_q;
      and_1352_s15_q <= and_1352_s14_q;
      and_1362_s15_q <= not_398_s14_q & and_1361;
      and_1367_s15_q <= and_1361 & or_1366_s14_q;
      select_1377_s15_q <= select_1377_s14_q;
      less_1421_s15_q <= less_1421_s14_q;
      sum_1459_s15_q <= sum_1459[5];
      equal_1461_s15_q <= equal_1461_s14_q;
      and_1598_s15_q <= and_1598_s14_q;
      equal_1739_s15_q <= equal_1739_s14_q;
      equal_1863_s15_q <= equal_1863_s14_q;
      select_2067_s15_q <= select_2067;
      select_2069_s15_q <= select_2069;
      select_2089_s15_q <= select_2089;
      less_2115_s15_q <= less_2115_s14_q;
      less_2307_s15_q <= less_2307_s14_q;
      equal_2514_s15_q <= equal_2514_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:800
  logic equal_1286;
  assign equal_1286 = select_1283_s15_q == 3'h1;
  logic equal_1287;
  assign equal_1287 = select_1283_s15_q == 3'h2;
  logic not_1288;
  assign not_1288 = ~equal_1287;
  logic [2:0] select_1289;
  assign select_1289 = equal_1286 ? 3'h2 : {not_1288, {2{equal_1287}}};
  logic [7:0] select_1294;
  assign select_1294 = select_1289[1] ? (select_1289[0] ? before_1_s15_q : before_1_q) : (select_1289[0] ? before_1_q : before_0_q);
  logic [7:0] select_1295;
  assign select_1295 = select_1289[2] ? (select_1289[0] ? before_2_s15_q : before_0_s15_q) : select_1294;
  // hls/stages/agreement.hpp:801
  logic [1:0] select_1297;
  assign select_1297 = equal_1286 ? 2'h0 : {not_1288, equal_1287};
  logic [7:0] select_1299;
  assign select_1299 = select_1297[1] ? before_2_q : (select_1297[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:812
  logic or_1331;
  assign or_1331 = select_1329_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:228
  logic and_1368;
  assign and_1368 = not_398_s15_q & and_1367_s15_q;
  // hls/stages/agreement.hpp:137
  logic [8:0] select_1369;
  assign select_1369 = less_397_s15_q ? 9'h0 : best_left_rdata_s15_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_390_s15_q ? {select_1369, and_1368, and_1362_s15_q, and_1352_s15_q, and_1349_s15_q, and_1345_s15_q, not_398_s15_q} : 15'h0;
  // hls/stages/agreement.hpp:243
  logic right_2;
  assign right_2 = inside_v[0] & less_1421_s15_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:137
  logic [7:0] select_2065;
  assign select_2065 = or_390_s15_q ? (less_397_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2067_s15_q} - {1'b0, select_2069_s15_q};
  // hls/stages/registration.hpp:213
  logic [13:0] select_2091;
  assign select_2091 = ($signed(10'h0) < $signed(select_2089_s15_q[16:7])) ? 14'h7f : select_2089_s15_q[13:0];

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
  logic equal_328_s16_q;
  logic [8:0] select_334_s16_q;
  logic and_343_s16_q;
  logic equal_349_s16_q;
  logic whole_s16_q;
  logic [6:0] column_s16_q;
  logic and_367_s16_q;
  logic and_369_s16_q;
  logic equal_372_s16_q;
  logic so_s16_q;
  logic equal_430_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1278_s16_q;
  logic [2:0] select_1283_s16_q;
  logic [7:0] select_1295_s16_q;
  logic [7:0] select_1299_s16_q;
  logic [6:0] select_1318_s16_q;
  logic [5:0] select_1319_s16_q;
  logic and_1320_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1331_s16_q;
  logic [6:0] select_1336_s16_q;
  logic [6:0] select_1337_s16_q;
  logic equal_1338_s16_q;
  logic [13:0] inside_v_s16_q;
  logic [6:0] select_1377_s16_q;
  logic and_1380_s16_q;
  logic right_2_s16_q;
  logic sum_1459_s16_q;
  logic equal_1461_s16_q;
  logic textured_s16_q;
  logic and_1598_s16_q;
  logic equal_1739_s16_q;
  logic equal_1863_s16_q;
  logic [7:0] select_2065_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2071_s16_q;
  logic [7:0] xor_2076_s16_q;
  logic [13:0] select_2091_s16_q;
  logic and_2116_s16_q;
  logic less_2121_s16_q;
  logic less_2307_s16_q;
  logic equal_2514_s16_q;
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
      equal_328_s16_q <= equal_328_s15_q;
      select_334_s16_q <= select_334_s15_q;
      and_343_s16_q <= and_343_s15_q;
      equal_349_s16_q <= equal_349_s15_q;
      whole_s16_q <= whole_s15_q;
      column_s16_q <= column_s15_q;
      and_367_s16_q <= and_367_s15_q;
      and_369_s16_q <= and_369_s15_q;
      equal_372_s16_q <= equal_372_s15_q;
      so_s16_q <= so_s15_q;
      equal_430_s16_q <= equal_430_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1278_s16_q <= select_518_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1283_s16_q <= select_1283_s15_q;
      select_1295_s16_q <= select_1295;
      select_1299_s16_q <= select_1299;
      select_1318_s16_q <= or_1317_s15_q ? of_near_s15_q : best_left_rdata_s15_q[39:33];
      select_1319_s16_q <= or_1317_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      and_1320_s16_q <= and_1320_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1331_s16_q <= or_1331;
      select_1336_s16_q <= or_1335_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1337_s16_q <= or_1335_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1338_s16_q <= equal_1338_s15_q;
      inside_v_s16_q <= {inside_v[14:3], inside_v[1:0]};
      select_1377_s16_q <= select_1377_s15_q;
      and_1380_s16_q <= equal_389_s15_q & inside_v[4];
      right_2_s16_q <= right_2;
      sum_1459_s16_q <= sum_1459_s15_q;
      equal_1461_s16_q <= equal_1461_s15_q;
      textured_s16_q <= textured;
      and_1598_s16_q <= and_1598_s15_q;
      equal_1739_s16_q <= equal_1739_s15_q;
      equal_1863_s16_q <= equal_1863_s15_q;
      select_2065_s16_q <= select_2065;
      rise_s16_q <= rise[8];
      select_2071_s16_q <= rise[8] ? select_2067_s15_q : select_2069_s15_q;
      xor_2076_s16_q <= rise[7:0] ^ {8{rise[8]}};
      select_2091_s16_q <= select_2091;
      and_2116_s16_q <= inside_v[4] & less_2115_s15_q;
      less_2121_s16_q <= select_2067_s15_q < select_2069_s15_q;
      less_2307_s16_q <= less_2307_s15_q;
      equal_2514_s16_q <= equal_2514_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:119
  logic and_344;
  assign and_344 = sample_pair_whole_s16_q & and_343_s16_q;
  // hls/stages/agreement.hpp:970
  logic not_1339;
  assign not_1339 = ~equal_1338_s16_q;
  // hls/stages/agreement.hpp:392
  logic and_1371;
  assign and_1371 = ends_cell_s16_q & inside_v_s16_q[0];
  logic and_1373;
  assign and_1373 = not_1339 & (so_s16_q & and_1371);
  // hls/stages/agreement.hpp:1012
  logic or_1462;
  assign or_1462 = (~sum_1459_s16_q) | equal_1461_s16_q;
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2072;
  assign difference_2072 = {1'b0, select_2065_s16_q} - {1'b0, select_2071_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2072[8] ? 8'h0 : difference_2072[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2076_s16_q};
  // hls/stages/registration.hpp:208
  logic [9:0] select_2092;
  assign select_2092 = inside_v_s16_q[9] ? select_2091_s16_q[9:0] : 10'h0;
  logic [8:0] difference_2094;
  assign difference_2094 = select_2092[9:1] - (inside_v_s16_q[10] ? select_2091_s16_q[8:0] : 9'h0);
  // hls/stages/registration.hpp:206
  logic [12:0] sum_2097;
  assign sum_2097 = (inside_v_s16_q[5] ? select_2091_s16_q[13:1] : 13'h0) + (inside_v_s16_q[6] ? select_2091_s16_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:207
  logic [11:0] select_2098;
  assign select_2098 = inside_v_s16_q[7] ? select_2091_s16_q[11:0] : 12'h0;
  logic [10:0] sum_2100;
  assign sum_2100 = select_2098[11:1] + (inside_v_s16_q[8] ? select_2091_s16_q[10:0] : 11'h0);

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_334_s16_q;
  logic averager_memory_re;
  assign averager_memory_re = s16_en & and_344;
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
  assign shown_right_re = s16_en & and_1373;
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
  assign seen_columns_re = s16_en & and_1373;
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
  logic equal_328_s17_q;
  logic [8:0] select_334_s17_q;
  logic and_343_s17_q;
  logic and_344_s17_q;
  logic equal_349_s17_q;
  logic whole_s17_q;
  logic [6:0] column_s17_q;
  logic and_367_s17_q;
  logic and_369_s17_q;
  logic equal_372_s17_q;
  logic so_s17_q;
  logic equal_430_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1279_s17_q;
  logic [2:0] select_1284_s17_q;
  logic [7:0] select_1285_s17_q;
  logic [7:0] select_1296_s17_q;
  logic [7:0] select_1300_s17_q;
  logic [6:0] select_1318_s17_q;
  logic [5:0] select_1319_s17_q;
  logic and_1320_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1332_s17_q;
  logic [6:0] select_1333_s17_q;
  logic [6:0] select_1336_s17_q;
  logic [6:0] select_1337_s17_q;
  logic equal_1338_s17_q;
  logic not_1339_s17_q;
  logic [13:0] inside_v_s17_q;
  logic and_1373_s17_q;
  logic [6:0] select_1377_s17_q;
  logic and_1382_s17_q;
  logic right_2_s17_q;
  logic sum_1459_s17_q;
  logic and_1465_s17_q;
  logic textured_s17_q;
  logic and_1599_s17_q;
  logic equal_1739_s17_q;
  logic equal_1863_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] size_3_s17_q;
  logic select_2092_s17_q;
  logic [8:0] difference_2094_s17_q;
  logic [11:0] sum_2097_s17_q;
  logic select_2098_s17_q;
  logic [10:0] sum_2100_s17_q;
  logic and_2116_s17_q;
  logic less_2121_s17_q;
  logic less_2307_s17_q;
  logic select_2350_s17_q;
  logic equal_2514_s17_q;
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
      equal_328_s17_q <= equal_328_s16_q;
      select_334_s17_q <= select_334_s16_q;
      and_343_s17_q <= and_343_s16_q;
      and_344_s17_q <= and_344;
      equal_349_s17_q <= equal_349_s16_q;
      whole_s17_q <= whole_s16_q;
      column_s17_q <= column_s16_q;
      and_367_s17_q <= and_367_s16_q;
      and_369_s17_q <= and_369_s16_q;
      equal_372_s17_q <= equal_372_s16_q;
      so_s17_q <= so_s16_q;
      equal_430_s17_q <= equal_430_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1279_s17_q <= or_1278_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1284_s17_q <= or_1278_s16_q ? select_1283_s16_q : best_left_rdata_s16_q[8:6];
      select_1285_s17_q <= or_1278_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1296_s17_q <= or_1278_s16_q ? select_1295_s16_q : best_left_rdata_s16_q[24:17];
      select_1300_s17_q <= or_1278_s16_q ? select_1299_s16_q : best_left_rdata_s16_q[32:25];
      select_1318_s17_q <= select_1318_s16_q;
      select_1319_s17_q <= select_1319_s16_q;
      and_1320_s17_q <= and_1320_s16_q;
      right_s17_q <= right_s16_q;
      select_1332_s17_q <= or_1331_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1333_s17_q <= or_1331_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1336_s17_q <= select_1336_s16_q;
      select_1337_s17_q <= select_1337_s16_q;
      equal_1338_s17_q <= equal_1338_s16_q;
      not_1339_s17_q <= not_1339;
      inside_v_s17_q <= inside_v_s16_q;
      and_1373_s17_q <= and_1373;
      select_1377_s17_q <= select_1377_s16_q;
      and_1382_s17_q <= not_1339 & (so_s16_q ? and_1371 : and_1380_s16_q);
      right_2_s17_q <= right_2_s16_q;
      sum_1459_s17_q <= sum_1459_s16_q;
      and_1465_s17_q <= so_s16_q & (ends_cell_s16_q & (inside_v_s16_q[0] & or_1462));
      textured_s17_q <= textured_s16_q;
      and_1599_s17_q <= not_1339 & and_1598_s16_q;
      equal_1739_s17_q <= equal_1739_s16_q;
      equal_1863_s17_q <= equal_1863_s16_q;
      wide_s17_q <= wide;
      size_3_s17_q <= size_3;
      select_2092_s17_q <= select_2092[0];
      difference_2094_s17_q <= difference_2094;
      sum_2097_s17_q <= sum_2097[12:1];
      select_2098_s17_q <= select_2098[0];
      sum_2100_s17_q <= sum_2100;
      and_2116_s17_q <= and_2116_s16_q;
      less_2121_s17_q <= less_2121_s16_q;
      less_2307_s17_q <= less_2307_s16_q;
      select_2350_s17_q <= sum_1459_s16_q ? (equal_1461_s16_q & or_1462) : or_1462;
      equal_2514_s17_q <= equal_2514_s16_q;
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
  logic [13:0] select_347;
  assign select_347 = equal_328_s17_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_353;
  assign sum_353 = {6'h0, sample_pair_pixel_1_q} + (equal_328_s17_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:394
  logic all_of_skin;
  assign all_of_skin = equal_328_s17_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/agreement.hpp:186
  logic not_1378;
  assign not_1378 = ~so_s17_q;
  // hls/stages/agreement.hpp:392
  logic and_1379;
  assign and_1379 = not_1378 & inside_v_s17_q[4];
  // hls/stages/agreement.hpp:255
  logic select_1652;
  assign select_1652 = sample_pair_whole_s17_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2079;
  assign select_2079 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2079;
  // hls/stages/registration.hpp:209
  logic [11:0] sum_2101;
  assign sum_2101 = sum_2097_s17_q + {sum_2100_s17_q, select_2098_s17_q};
  logic [9:0] sum_2102;
  assign sum_2102 = {difference_2094_s17_q, select_2092_s17_q} + sum_2101[11:2];
  // hls/stages/agreement.hpp:190
  logic or_2348;
  assign or_2348 = segment_starts_q | not_1378;
  // hls/stages/agreement.hpp:392
  logic select_2352;
  assign select_2352 = ends_cell_s17_q ? (inside_v_s17_q[0] ? select_2350_s17_q : or_2348) : or_2348;

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1320_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1319_s17_q, select_1318_s17_q, select_1300_s17_q, select_1296_s17_q, select_1285_s17_q, select_1284_s17_q, select_1279_s17_q};
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
  assign best_right_we = s17_en & and_1320_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1337_s17_q, select_1336_s17_q, select_1333_s17_q, select_1332_s17_q};
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
  assign shown_right_waddr = select_1377_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1382_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1379, not_1378};
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
      averager_running_of_skin_q <= select_1652;
      segment_starts_q <= equal_1338_s17_q ? or_2348 : (so_s17_q ? select_2352 : or_2348);
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
      averager_running_0_q <= sample_pair_whole_s17_q ? select_347 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s17_q ? sum_353 : averager_running_1_q;
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
  logic [8:0] select_334_s18_q;
  logic and_343_s18_q;
  logic and_344_s18_q;
  logic [29:0] averager_memory_rdata_s18_q;
  logic [13:0] select_347_s18_q;
  logic equal_349_s18_q;
  logic [13:0] sum_353_s18_q;
  logic whole_s18_q;
  logic all_of_skin_s18_q;
  logic [6:0] column_s18_q;
  logic and_367_s18_q;
  logic and_369_s18_q;
  logic equal_372_s18_q;
  logic so_s18_q;
  logic equal_430_s18_q;
  logic equal_1338_s18_q;
  logic not_1339_s18_q;
  logic [13:0] inside_v_s18_q;
  logic and_1373_s18_q;
  logic [1:0] shown_right_rdata_s18_q;
  logic right_2_s18_q;
  logic sum_1459_s18_q;
  logic and_1465_s18_q;
  logic textured_s18_q;
  logic [17:0] seen_columns_rdata_s18_q;
  logic and_1599_s18_q;
  logic equal_1739_s18_q;
  logic equal_1863_s18_q;
  logic less_2063_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2081_s18_q;
  logic [7:0] sum_2102_s18_q;
  logic and_2116_s18_q;
  logic less_2121_s18_q;
  logic less_2307_s18_q;
  logic equal_2514_s18_q;
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
      select_334_s18_q <= select_334_s17_q;
      and_343_s18_q <= and_343_s17_q;
      and_344_s18_q <= and_344_s17_q;
      averager_memory_rdata_s18_q <= averager_memory_rdata_q;
      select_347_s18_q <= select_347;
      equal_349_s18_q <= equal_349_s17_q;
      sum_353_s18_q <= sum_353;
      whole_s18_q <= whole_s17_q;
      all_of_skin_s18_q <= all_of_skin;
      column_s18_q <= column_s17_q;
      and_367_s18_q <= and_367_s17_q;
      and_369_s18_q <= and_369_s17_q;
      equal_372_s18_q <= equal_372_s17_q;
      so_s18_q <= so_s17_q;
      equal_430_s18_q <= equal_430_s17_q;
      equal_1338_s18_q <= equal_1338_s17_q;
      not_1339_s18_q <= not_1339_s17_q;
      inside_v_s18_q <= inside_v_s17_q;
      and_1373_s18_q <= and_1373_s17_q;
      shown_right_rdata_s18_q <= shown_right_rdata_q;
      right_2_s18_q <= right_2_s17_q;
      sum_1459_s18_q <= sum_1459_s17_q;
      and_1465_s18_q <= and_1465_s17_q;
      textured_s18_q <= textured_s17_q;
      seen_columns_rdata_s18_q <= seen_columns_rdata_q;
      and_1599_s18_q <= and_1599_s17_q;
      equal_1739_s18_q <= equal_1739_s17_q;
      equal_1863_s18_q <= equal_1863_s17_q;
      less_2063_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2081_s18_q <= ~wide_s17_q;
      sum_2102_s18_q <= sum_2102[9:2];
      and_2116_s18_q <= and_2116_s17_q;
      less_2121_s18_q <= less_2121_s17_q;
      less_2307_s18_q <= less_2307_s17_q;
      equal_2514_s18_q <= equal_2514_s17_q;
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
  logic [13:0] sum_351;
  assign sum_351 = select_347_s18_q + (equal_349_s18_q ? 14'h0 : averager_memory_rdata_s18_q[13:0]);
  logic [13:0] sum_355;
  assign sum_355 = sum_353_s18_q + (equal_349_s18_q ? 14'h0 : averager_memory_rdata_s18_q[27:14]);
  // hls/stages/census.hpp:122
  logic and_359;
  assign and_359 = whole_s18_q & (averager_memory_rdata_s18_q[28] | equal_349_s18_q);
  // hls/stages/census.hpp:123
  logic and_363;
  assign and_363 = all_of_skin_s18_q & (averager_memory_rdata_s18_q[29] | equal_349_s18_q);
  // hls/stages/agreement.hpp:190
  logic [7:0] select_1446;
  assign select_1446 = so_s18_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1004
  logic or_1449;
  assign or_1449 = select_1446[7] | (~({select_1446[5], select_1446[3], select_1446[1]} == 3'h0));
  // hls/stages/agreement.hpp:243
  logic explained;
  assign explained = inside_v_s18_q[0] & inside_v_s18_q[3];
  logic and_1479;
  assign and_1479 = inside_v_s18_q[0] & ({inside_v_s18_q[4], inside_v_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:975
  logic select_1487;
  assign select_1487 = slot_s18_q[2] ? shown_shown_q : inside_v_s18_q[3];
  // hls/stages/agreement.hpp:243
  logic shown;
  assign shown = inside_v_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1487);
  // hls/stages/agreement.hpp:975
  logic select_1490;
  assign select_1490 = slot_s18_q[2] ? shown_nearer_q : inside_v_s18_q[4];
  // hls/stages/agreement.hpp:243
  logic near;
  assign near = inside_v_s18_q[0] & (select_1487 ? select_1490 : shown_right_rdata_s18_q[1]);
  // hls/stages/agreement.hpp:988
  logic [7:0] select_1540;
  assign select_1540 = inside_v_s18_q[0] ? (sum_1459_s18_q ? select_1446 : {select_1446[6:0], 1'b0}) : select_1446;
  // hls/stages/agreement.hpp:1004
  logic or_1543;
  assign or_1543 = select_1540[7] | (~({select_1540[5], select_1540[3], select_1540[1]} == 3'h0));
  // hls/stages/agreement.hpp:988
  logic and_2005;
  assign and_2005 = seen_columns_rdata_s18_q[7] & inside_v_s18_q[0];
  logic and_2006;
  assign and_2006 = seen_columns_rdata_s18_q[2] & inside_v_s18_q[0];
  // hls/stages/registration.hpp:37
  logic not_2074;
  assign not_2074 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2063_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2074};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2082;
  assign select_2082 = registration_displacement_over_q[9] ? wide_s18_q : not_2081_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2063_s18_q ? {taken_s18_q, 1'b1} : {not_2074, select_2082, not_2074};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2084;
  assign sum_2084 = {left, 1'b1} + {taken_2, less_2063_s18_q};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2103;
  assign sum_2103 = {registration_slope_s18_q[11], registration_slope_s18_q} + {{5{sum_2102_s18_q[7]}}, sum_2102_s18_q};
  // hls/stages/agreement.hpp:392
  logic select_2304;
  assign select_2304 = equal_1338_s18_q ? shown_shown_q : (so_s18_q ? select_1487 : shown_shown_q);
  logic select_2306;
  assign select_2306 = equal_1338_s18_q ? shown_nearer_q : (so_s18_q ? select_1490 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2308;
  assign sum_2308 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2317;
  assign select_2317 = equal_1338_s18_q ? select_1446 : (so_s18_q ? (ends_cell_s18_q ? select_1540 : select_1446) : 8'h1);
  // hls/stages/agreement.hpp:436
  logic [8:0] select_2331;
  assign select_2331 = equal_430_s18_q ? {difference_2329[7], difference_2329} : (less_2307_s18_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:495
  logic [8:0] select_2333;
  assign select_2333 = and_369_s18_q ? (equal_1863_s18_q ? select_2331 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_2335;
  assign select_2335 = equal_430_s18_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:495
  logic [7:0] select_2337;
  assign select_2337 = and_369_s18_q ? (equal_1863_s18_q ? select_2335 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_2339;
  assign select_2339 = sum_2308[7] ? {1'b1, sum_2308[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

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
  assign census_memory_re = s18_en & and_369_s18_q;
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
      registration_displacement_over_q <= so_s18_q ? sum_2084[10:1] : registration_displacement_over_q;
      shown_shown_q <= select_2304;
      shown_nearer_q <= select_2306;
      region_columns_q <= select_2317;
      region_down_rest_q <= select_2333;
      region_down_back_q <= select_2337;
      region_down_next_q <= select_2339;
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
  logic [8:0] select_334_s19_q;
  logic and_343_s19_q;
  logic and_344_s19_q;
  logic [13:0] sum_351_s19_q;
  logic [13:0] sum_355_s19_q;
  logic and_359_s19_q;
  logic and_363_s19_q;
  logic [6:0] column_s19_q;
  logic and_367_s19_q;
  logic and_369_s19_q;
  logic equal_372_s19_q;
  logic so_s19_q;
  logic equal_430_s19_q;
  logic equal_1338_s19_q;
  logic not_1339_s19_q;
  logic [11:0] inside_v_s19_q;
  logic and_1373_s19_q;
  logic equal_1383_s19_q;
  logic right_2_s19_q;
  logic or_1449_s19_q;
  logic or_1452_s19_q;
  logic or_1455_s19_q;
  logic and_1465_s19_q;
  logic textured_s19_q;
  logic explained_s19_q;
  logic and_1479_s19_q;
  logic [12:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_1525_s19_q;
  logic and_1527_s19_q;
  logic or_1543_s19_q;
  logic or_1546_s19_q;
  logic or_1549_s19_q;
  logic and_1560_s19_q;
  logic and_1562_s19_q;
  logic and_1563_s19_q;
  logic and_1576_s19_q;
  logic and_1578_s19_q;
  logic and_1579_s19_q;
  logic and_1599_s19_q;
  logic equal_1739_s19_q;
  logic equal_1863_s19_q;
  logic and_2003_s19_q;
  logic and_2004_s19_q;
  logic [1:0] sum_2008_s19_q;
  logic [7:0] sum_2103_s19_q;
  logic less_2104_s19_q;
  logic less_2105_s19_q;
  logic and_2116_s19_q;
  logic less_2121_s19_q;
  logic less_2307_s19_q;
  logic sum_2308_s19_q;
  logic and_2504_s19_q;
  logic equal_2514_s19_q;
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
      select_334_s19_q <= select_334_s18_q;
      and_343_s19_q <= and_343_s18_q;
      and_344_s19_q <= and_344_s18_q;
      sum_351_s19_q <= sum_351;
      sum_355_s19_q <= sum_355;
      and_359_s19_q <= and_359;
      and_363_s19_q <= and_363;
      column_s19_q <= column_s18_q;
      and_367_s19_q <= and_367_s18_q;
      and_369_s19_q <= and_369_s18_q;
      equal_372_s19_q <= equal_372_s18_q;
      so_s19_q <= so_s18_q;
      equal_430_s19_q <= equal_430_s18_q;
      equal_1338_s19_q <= equal_1338_s18_q;
      not_1339_s19_q <= not_1339_s18_q;
      inside_v_s19_q <= {inside_v_s18_q[13:5], inside_v_s18_q[2:0]};
      and_1373_s19_q <= and_1373_s18_q;
      equal_1383_s19_q <= x_s18_q[6:4] == 3'h7;
      right_2_s19_q <= right_2_s18_q;
      or_1449_s19_q <= or_1449;
      or_1452_s19_q <= select_1446[7] | (~({select_1446[6], select_1446[3:2]} == 3'h0));
      or_1455_s19_q <= select_1446[7] | (~(select_1446[6:4] == 3'h0));
      and_1465_s19_q <= and_1465_s18_q;
      textured_s19_q <= textured_s18_q;
      explained_s19_q <= explained;
      and_1479_s19_q <= and_1479;
      seen_columns_rdata_s19_q <= {seen_columns_rdata_s18_q[13:7], seen_columns_rdata_s18_q[5:0]};
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_1525_s19_q <= seen_columns_rdata_s18_q[14] & inside_v_s18_q[0];
      and_1527_s19_q <= seen_columns_rdata_s18_q[5] & inside_v_s18_q[0];
      or_1543_s19_q <= or_1543;
      or_1546_s19_q <= select_1540[7] | (~({select_1540[6], select_1540[3:2]} == 3'h0));
      or_1549_s19_q <= select_1540[7] | (~(select_1540[6:4] == 3'h0));
      and_1560_s19_q <= seen_columns_rdata_s18_q[16] & inside_v_s18_q[0];
      and_1562_s19_q <= seen_columns_rdata_s18_q[8] & inside_v_s18_q[0];
      and_1563_s19_q <= seen_columns_rdata_s18_q[3] & inside_v_s18_q[0];
      and_1576_s19_q <= seen_columns_rdata_s18_q[17] & inside_v_s18_q[0];
      and_1578_s19_q <= seen_columns_rdata_s18_q[9] & inside_v_s18_q[0];
      and_1579_s19_q <= seen_columns_rdata_s18_q[4] & inside_v_s18_q[0];
      and_1599_s19_q <= and_1599_s18_q;
      equal_1739_s19_q <= equal_1739_s18_q;
      equal_1863_s19_q <= equal_1863_s18_q;
      and_2003_s19_q <= seen_columns_rdata_s18_q[15] & inside_v_s18_q[0];
      and_2004_s19_q <= seen_columns_rdata_s18_q[11] & inside_v_s18_q[0];
      sum_2008_s19_q <= {1'b0, and_2005} + ({1'b0, explained} + {1'b0, and_2006});
      sum_2103_s19_q <= sum_2103[7:0];
      less_2104_s19_q <= $signed(6'h0) < $signed(sum_2103[12:7]);
      less_2105_s19_q <= $signed(sum_2103[12:7]) < $signed(6'h3f);
      and_2116_s19_q <= and_2116_s18_q;
      less_2121_s19_q <= less_2121_s18_q;
      less_2307_s19_q <= less_2307_s18_q;
      sum_2308_s19_q <= sum_2308[7];
      and_2504_s19_q <= seen_columns_rdata_s18_q[6] & inside_v_s18_q[0];
      equal_2514_s19_q <= equal_2514_s18_q;
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
  assign grey = and_343_s19_q ? sum_351_s19_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_372_s19_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_343_s19_q ? sum_355_s19_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_372_s19_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_380;
  assign and_380 = and_343_s19_q & and_359_s19_q;
  // hls/stages/census.hpp:126
  logic select_382;
  assign select_382 = equal_372_s19_q ? and_380 : (averager_mask_q & and_380);
  // hls/stages/agreement.hpp:255
  logic whole_2;
  assign whole_2 = sample_pair_whole_s19_q & select_382;
  // hls/stages/census.hpp:206
  logic and_384;
  assign and_384 = and_343_s19_q & and_363_s19_q;
  // hls/stages/census.hpp:126
  logic select_386;
  assign select_386 = equal_372_s19_q ? and_384 : (averager_of_skin_q & and_384);
  // hls/stages/agreement.hpp:392
  logic [5:0] select_1456;
  assign select_1456 = equal_1338_s19_q ? x_s19_q[5:0] : {region_row_q, or_1455_s19_q, or_1452_s19_q, or_1449_s19_q};
  // hls/stages/agreement.hpp:1082
  logic not_1457;
  assign not_1457 = ~equal_1383_s19_q;
  // hls/stages/agreement.hpp:243
  logic and_1486;
  assign and_1486 = inside_v_s19_q[0] & inside_v_s19_q[2];
  // hls/stages/agreement.hpp:988
  logic and_1528;
  assign and_1528 = seen_columns_rdata_s19_q[0] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_1530;
  assign sum_1530 = {1'b0, and_1527_s19_q} + ({1'b0, textured_s19_q} + {1'b0, and_1528});
  // hls/stages/agreement.hpp:988
  logic and_1561;
  assign and_1561 = seen_columns_rdata_s19_q[11] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1043
  logic [1:0] sum_1565;
  assign sum_1565 = {1'b0, and_1562_s19_q} + ({1'b0, shown_s19_q} + {1'b0, and_1563_s19_q});
  // hls/stages/agreement.hpp:988
  logic and_1577;
  assign and_1577 = seen_columns_rdata_s19_q[12] & inside_v_s19_q[0];
  // hls/stages/agreement.hpp:1044
  logic [1:0] sum_1581;
  assign sum_1581 = {1'b0, and_1578_s19_q} + ({1'b0, near_s19_q} + {1'b0, and_1579_s19_q});
  // hls/stages/agreement.hpp:255
  logic [10:0] select_1631;
  assign select_1631 = sample_pair_whole_s19_q ? (and_367_s19_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1633;
  assign select_1633 = sample_pair_whole_s19_q ? (and_367_s19_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_1654;
  assign select_1654 = sample_pair_whole_s19_q ? (and_367_s19_q ? select_382 : averager_mask_q) : averager_mask_q;
  logic select_1656;
  assign select_1656 = sample_pair_whole_s19_q ? (and_367_s19_q ? select_386 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:392
  logic and_1982;
  assign and_1982 = so_s19_q & (ends_cell_s19_q & (inside_v_s19_q[0] & inside_v_s19_q[1]));
  // hls/stages/agreement.hpp:1059
  logic not_2002;
  assign not_2002 = ~(x_s19_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1042
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2003_s19_q} + ({2'h0, and_2004_s19_q} + {1'b0, sum_2008_s19_q});
  // hls/stages/agreement.hpp:392
  logic and_2043;
  assign and_2043 = ends_cell_s19_q & (inside_v_s19_q[0] & (inside_v_s19_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:1064
  logic and_2049;
  assign and_2049 = not_2002 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:238
  logic [4:0] select_2086;
  assign select_2086 = so_s19_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_s19_q} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:83
  logic equal_2087;
  assign equal_2087 = slot_s19_q == 3'h7;
  // hls/stages/registration.hpp:213
  logic [7:0] select_2107;
  assign select_2107 = less_2104_s19_q ? 8'h7f : (less_2105_s19_q ? 8'h80 : sum_2103_s19_q);
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2109;
  assign select_2109 = so_s19_q ? (equal_2087 ? registration_slope_here_q : select_2107) : registration_slope_here_q;
  // hls/stages/registration.hpp:206
  logic [6:0] select_2125;
  assign select_2125 = inside_v_s19_q[3] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_2126;
  assign select_2126 = inside_v_s19_q[4] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2127;
  assign sum_2127 = {{2{select_2125[6]}}, select_2125} + {select_2126[7], select_2126};
  // hls/stages/registration.hpp:207
  logic [7:0] select_2128;
  assign select_2128 = inside_v_s19_q[5] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2129;
  assign select_2129 = inside_v_s19_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_2130;
  assign sum_2130 = {{2{select_2128[7]}}, select_2128[7:1]} + {select_2129[7], select_2129};
  // hls/stages/registration.hpp:208
  logic [7:0] select_2132;
  assign select_2132 = inside_v_s19_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_2133;
  assign select_2133 = inside_v_s19_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_2134;
  assign difference_2134 = {{2{select_2132[7]}}, select_2132[7:1]} - {select_2133[7], select_2133};
  // hls/stages/agreement.hpp:436
  logic [2:0] select_2310;
  assign select_2310 = less_2307_s19_q ? (sum_2308_s19_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2312;
  assign select_2312 = equal_1863_s19_q ? (equal_430_s19_q ? 3'h0 : select_2310) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2308_s19_q;
  // hls/stages/agreement.hpp:436
  logic select_2343;
  assign select_2343 = equal_1863_s19_q ? (equal_430_s19_q | (less_2307_s19_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1154
  logic equal_2361;
  assign equal_2361 = x_s19_q[6:3] == 4'h7;
  logic equal_2385;
  assign equal_2385 = x_s19_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1079
  logic [7:0] select_2398;
  assign select_2398 = (x_s19_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2400;
  assign select_2400 = equal_2385 ? cfg_unproven_skin_limit_i : (equal_2361 ? cfg_unproven_limit_i : select_2398);
  // hls/stages/agreement.hpp:392
  logic select_2502;
  assign select_2502 = so_s19_q ? (ends_cell_s19_q ? and_1527_s19_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2506;
  assign select_2506 = so_s19_q ? (ends_cell_s19_q ? and_2504_s19_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_2508;
  assign select_2508 = ends_cell_s19_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2510;
  assign select_2510 = equal_1338_s19_q ? centres_values_1_textured_q : (so_s19_q ? select_2508 : centres_values_1_textured_q);
  logic select_2511;
  assign select_2511 = ends_cell_s19_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2513;
  assign select_2513 = equal_1338_s19_q ? centres_values_1_of_skin_q : (so_s19_q ? select_2511 : centres_values_1_of_skin_q);

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1322; read in stage 19, written in stage 22: 19 < 22 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1456;
  logic regions_re;
  assign regions_re = s19_en & (equal_1338_s19_q ? (x_s19_q[6] & not_1457) : and_1465_s19_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_334_s19_q;
  logic averager_memory_we;
  assign averager_memory_we = s19_en & and_344_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_363_s19_q, and_359_s19_q, sum_355_s19_q, sum_351_s19_q};
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
  assign seen_columns_we = s19_en & and_1373_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q, near_s19_q, shown_s19_q, explained_s19_q, and_1486, textured_s19_q};
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
      averager_mask_q <= select_1654;
      averager_of_skin_q <= select_1656;
      registration_displacement_fraction_q <= select_2086;
      registration_slope_here_q <= equal_1338_s19_q ? registration_slope_here_q : select_2109;
      region_row_q <= and_369_s19_q ? select_2312 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_369_s19_q ? select_2343 : region_fresh_q;
      centres_values_0_textured_q <= equal_1338_s19_q ? centres_values_0_textured_q : select_2502;
      centres_values_0_of_skin_q <= equal_1338_s19_q ? centres_values_0_of_skin_q : select_2506;
      centres_values_1_textured_q <= select_2510;
      centres_values_1_of_skin_q <= select_2513;
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
      averager_total_0_q <= select_1631;
      averager_total_1_q <= select_1633;
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
  logic and_367_s20_q;
  logic and_369_s20_q;
  logic [77:0] census_memory_rdata_s20_q;
  logic [8:0] grey_s20_q;
  logic equal_372_s20_q;
  logic [8:0] select_375_s20_q;
  logic [8:0] grey_2_s20_q;
  logic [8:0] select_379_s20_q;
  logic whole_2_s20_q;
  logic and_387_s20_q;
  logic so_s20_q;
  logic equal_430_s20_q;
  logic equal_1338_s20_q;
  logic not_1339_s20_q;
  logic [1:0] inside_v_s20_q;
  logic equal_1383_s20_q;
  logic right_2_s20_q;
  logic or_1449_s20_q;
  logic or_1452_s20_q;
  logic or_1455_s20_q;
  logic not_1457_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1479_s20_q;
  logic and_1484_s20_q;
  logic and_1525_s20_q;
  logic and_1526_s20_q;
  logic [1:0] sum_1530_s20_q;
  logic or_1543_s20_q;
  logic or_1546_s20_q;
  logic or_1549_s20_q;
  logic and_1560_s20_q;
  logic [2:0] sum_1566_s20_q;
  logic and_1576_s20_q;
  logic [2:0] sum_1582_s20_q;
  logic and_1599_s20_q;
  logic equal_1739_s20_q;
  logic equal_1863_s20_q;
  logic and_1983_s20_q;
  logic not_2002_s20_q;
  logic [2:0] explained_2_s20_q;
  logic and_2045_s20_q;
  logic and_2052_s20_q;
  logic equal_2087_s20_q;
  logic and_2116_s20_q;
  logic or_2119_s20_q;
  logic [1:0] sum_2120_s20_q;
  logic less_2121_s20_q;
  logic [7:0] sum_2127_s20_q;
  logic select_2128_s20_q;
  logic [8:0] sum_2130_s20_q;
  logic select_2132_s20_q;
  logic [8:0] difference_2134_s20_q;
  logic equal_2361_s20_q;
  logic equal_2384_s20_q;
  logic equal_2385_s20_q;
  logic [7:0] select_2400_s20_q;
  logic equal_2514_s20_q;
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
      and_367_s20_q <= and_367_s19_q;
      and_369_s20_q <= and_369_s19_q;
      census_memory_rdata_s20_q <= census_memory_rdata_q;
      grey_s20_q <= grey;
      equal_372_s20_q <= equal_372_s19_q;
      select_375_s20_q <= sample_pair_whole_s19_q ? total[10:2] : 9'h0;
      grey_2_s20_q <= grey_2;
      select_379_s20_q <= sample_pair_whole_s19_q ? total_2[10:2] : 9'h0;
      whole_2_s20_q <= whole_2;
      and_387_s20_q <= sample_pair_whole_s19_q & select_386;
      so_s20_q <= so_s19_q;
      equal_430_s20_q <= equal_430_s19_q;
      equal_1338_s20_q <= equal_1338_s19_q;
      not_1339_s20_q <= not_1339_s19_q;
      inside_v_s20_q <= {inside_v_s19_q[9], inside_v_s19_q[0]};
      equal_1383_s20_q <= equal_1383_s19_q;
      right_2_s20_q <= right_2_s19_q;
      or_1449_s20_q <= or_1449_s19_q;
      or_1452_s20_q <= or_1452_s19_q;
      or_1455_s20_q <= or_1455_s19_q;
      not_1457_s20_q <= not_1457;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained_s19_q;
      and_1479_s20_q <= and_1479_s19_q;
      and_1484_s20_q <= not_1339_s19_q & and_1465_s19_q;
      and_1525_s20_q <= and_1525_s19_q;
      and_1526_s20_q <= seen_columns_rdata_s19_q[9] & inside_v_s19_q[0];
      sum_1530_s20_q <= sum_1530;
      or_1543_s20_q <= or_1543_s19_q;
      or_1546_s20_q <= or_1546_s19_q;
      or_1549_s20_q <= or_1549_s19_q;
      and_1560_s20_q <= and_1560_s19_q;
      sum_1566_s20_q <= {2'h0, and_1561} + {1'b0, sum_1565};
      and_1576_s20_q <= and_1576_s19_q;
      sum_1582_s20_q <= {2'h0, and_1577} + {1'b0, sum_1581};
      and_1599_s20_q <= and_1599_s19_q;
      equal_1739_s20_q <= equal_1739_s19_q;
      equal_1863_s20_q <= equal_1863_s19_q;
      and_1983_s20_q <= not_1339_s19_q & and_1982;
      not_2002_s20_q <= not_2002;
      explained_2_s20_q <= explained_2;
      and_2045_s20_q <= not_1339_s19_q & (so_s19_q & and_2043);
      and_2052_s20_q <= not_1339_s19_q & (so_s19_q & (ends_cell_s19_q & and_2049));
      equal_2087_s20_q <= equal_2087;
      and_2116_s20_q <= and_2116_s19_q;
      or_2119_s20_q <= (inside_v_s19_q[11:9] == 3'h0) | (inside_v_s19_q[11:9] == 3'h4);
      sum_2120_s20_q <= inside_v_s19_q[11:10] + 2'h3;
      less_2121_s20_q <= less_2121_s19_q;
      sum_2127_s20_q <= sum_2127[8:1];
      select_2128_s20_q <= select_2128[0];
      sum_2130_s20_q <= sum_2130;
      select_2132_s20_q <= select_2132[0];
      difference_2134_s20_q <= difference_2134;
      equal_2361_s20_q <= equal_2361;
      equal_2384_s20_q <= x_s19_q[6:3] == 4'h9;
      equal_2385_s20_q <= equal_2385;
      select_2400_s20_q <= select_2400;
      equal_2514_s20_q <= equal_2514_s19_q;
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
  logic less_403;
  assign less_403 = census_memory_rdata_s20_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_404;
  assign less_404 = census_memory_rdata_s20_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_405;
  assign less_405 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_406;
  assign less_406 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_407;
  assign less_407 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_408;
  assign less_408 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_409;
  assign less_409 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_410;
  assign less_410 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_411;
  assign less_411 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_412;
  assign less_412 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_413;
  assign less_413 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_414;
  assign less_414 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_415;
  assign less_415 = census_memory_rdata_s20_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_416;
  assign less_416 = census_memory_rdata_s20_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_417;
  assign less_417 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_418;
  assign less_418 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_419;
  assign less_419 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_420;
  assign less_420 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_421;
  assign less_421 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_422;
  assign less_422 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_423;
  assign less_423 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_424;
  assign less_424 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_425;
  assign less_425 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_426;
  assign less_426 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:431
  logic equal_427;
  assign equal_427 = column_s20_q == 7'h0;
  logic [3:0] select_431;
  assign select_431 = equal_430_s20_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:432
  logic [4:0] select_432;
  assign select_432 = equal_427 ? {select_431, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_433;
  assign select_433 = equal_427 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:286
  logic and_436;
  assign and_436 = census_memory_rdata_s20_q[38] & (census_memory_rdata_s20_q[18] & whole_2_s20_q);
  logic and_438;
  assign and_438 = census_memory_rdata_s20_q[77] & (census_memory_rdata_s20_q[58] & and_436);
  // hls/stages/census.hpp:270
  logic [9:0] difference_461;
  assign difference_461 = {1'b0, select_375_s20_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_464;
  assign difference_464 = {1'b0, census_memory_rdata_s20_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_468;
  assign difference_468 = {1'b0, census_memory_rdata_s20_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_472;
  assign difference_472 = {1'b0, census_memory_rdata_s20_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_476;
  assign difference_476 = {1'b0, census_memory_rdata_s20_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s20_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1041
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1525_s20_q} + ({2'h0, and_1526_s20_q} + {1'b0, sum_1530_s20_q});
  // hls/stages/agreement.hpp:1043
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1560_s20_q} + sum_1566_s20_q;
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_1568;
  assign select_1568 = age_s20_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1044
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1576_s20_q} + sum_1582_s20_q;
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_1584;
  assign select_1584 = age_s20_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:255
  logic [8:0] select_1623;
  assign select_1623 = sample_pair_whole_s20_q ? (and_367_s20_q ? grey_s20_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1625;
  assign select_1625 = sample_pair_whole_s20_q ? (and_367_s20_q ? grey_2_s20_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1627;
  assign select_1627 = sample_pair_whole_s20_q ? (and_367_s20_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1629;
  assign select_1629 = sample_pair_whole_s20_q ? (and_367_s20_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_1634;
  assign sum_1634 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s20_q};
  logic [9:0] sum_1642;
  assign sum_1642 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s20_q};
  // hls/stages/agreement.hpp:495
  logic [8:0] select_1657;
  assign select_1657 = and_369_s20_q ? select_375_s20_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1658;
  assign select_1658 = and_369_s20_q ? select_379_s20_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1660;
  assign select_1660 = and_369_s20_q ? census_memory_rdata_s20_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1661;
  assign select_1661 = and_369_s20_q ? census_memory_rdata_s20_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1662;
  assign select_1662 = and_369_s20_q ? census_memory_rdata_s20_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1663;
  assign select_1663 = and_369_s20_q ? census_memory_rdata_s20_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1664;
  assign select_1664 = and_369_s20_q ? census_memory_rdata_s20_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1665;
  assign select_1665 = and_369_s20_q ? census_memory_rdata_s20_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1666;
  assign select_1666 = and_369_s20_q ? census_memory_rdata_s20_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1667;
  assign select_1667 = and_369_s20_q ? census_memory_rdata_s20_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1668;
  assign select_1668 = and_369_s20_q ? census_memory_rdata_s20_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1669;
  assign select_1669 = and_369_s20_q ? census_memory_rdata_s20_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1670;
  assign select_1670 = and_369_s20_q ? census_memory_rdata_s20_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1671;
  assign select_1671 = and_369_s20_q ? census_memory_rdata_s20_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1672;
  assign select_1672 = and_369_s20_q ? census_memory_rdata_s20_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1673;
  assign select_1673 = and_369_s20_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1674;
  assign select_1674 = and_369_s20_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1676;
  assign select_1676 = and_369_s20_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1677;
  assign select_1677 = and_369_s20_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1679;
  assign select_1679 = and_369_s20_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1680;
  assign select_1680 = and_369_s20_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1682;
  assign select_1682 = and_369_s20_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1683;
  assign select_1683 = and_369_s20_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1684;
  assign select_1684 = and_369_s20_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1686;
  assign select_1686 = and_369_s20_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1687;
  assign select_1687 = and_369_s20_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1689;
  assign select_1689 = and_369_s20_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1690;
  assign select_1690 = and_369_s20_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1692;
  assign select_1692 = and_369_s20_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1693;
  assign select_1693 = and_369_s20_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1695;
  assign select_1695 = and_369_s20_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1696;
  assign select_1696 = and_369_s20_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1698;
  assign select_1698 = and_369_s20_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1699;
  assign select_1699 = and_369_s20_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1701;
  assign select_1701 = and_369_s20_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1702;
  assign select_1702 = and_369_s20_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1705;
  assign select_1705 = and_369_s20_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1706;
  assign select_1706 = and_369_s20_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1709;
  assign select_1709 = and_369_s20_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1710;
  assign select_1710 = and_369_s20_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_1714;
  assign difference_1714 = {1'b0, select_379_s20_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1717;
  assign difference_1717 = {1'b0, census_memory_rdata_s20_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1721;
  assign difference_1721 = {1'b0, census_memory_rdata_s20_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1725;
  assign difference_1725 = {1'b0, census_memory_rdata_s20_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1729;
  assign difference_1729 = {1'b0, census_memory_rdata_s20_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_1760;
  assign difference_1760 = {1'b0, select_375_s20_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1772;
  assign difference_1772 = {1'b0, select_379_s20_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:495
  logic and_1979;
  assign and_1979 = and_369_s20_q & (equal_430_s20_q & equal_1863_s20_q);
  // hls/stages/agreement.hpp:392
  logic and_1988;
  assign and_1988 = not_1339_s20_q & (so_s20_q & (ends_cell_s20_q & textured_s20_q));
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2011;
  assign select_2011 = age_s20_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2047;
  assign select_2047 = and_1979 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2045_s20_q});
  logic [13:0] select_2054;
  assign select_2054 = and_1979 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2052_s20_q});
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2122;
  assign difference_2122 = {sum_2120_s20_q, inside_v_s20_q[1], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2123;
  assign select_2123 = less_2121_s20_q ? difference_2122 : {sum_2120_s20_q, inside_v_s20_q[1], registration_displacement_fraction_q};
  logic [7:0] select_2124;
  assign select_2124 = or_2119_s20_q ? {sum_2120_s20_q, inside_v_s20_q[1], 5'h0} : select_2123;
  // hls/stages/registration.hpp:209
  logic [10:0] sum_2131;
  assign sum_2131 = {{3{sum_2127_s20_q[7]}}, sum_2127_s20_q} + {sum_2130_s20_q[8], sum_2130_s20_q, select_2128_s20_q};
  logic [9:0] sum_2135;
  assign sum_2135 = {difference_2134_s20_q, select_2132_s20_q} + {sum_2131[10], sum_2131[10:2]};
  // hls/stages/agreement.hpp:1160
  logic equal_2362;
  assign equal_2362 = x_s20_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1154
  logic equal_2382;
  assign equal_2382 = x_s20_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1079
  logic [7:0] limit;
  assign limit = equal_2382 ? cfg_regions_limit_i : (equal_2384_s20_q ? cfg_hidden_limit_i : select_2400_s20_q);
  // hls/stages/agreement.hpp:1167
  logic not_2403;
  assign not_2403 = ~x_s20_q[2];
  logic [3:0] select_2404;
  assign select_2404 = x_s20_q[1] ? {x_s20_q[2], 1'b0, not_2403, 1'b0} : {1'b0, x_s20_q[2], 1'b0, not_2403};
  logic [7:0] select_2405;
  assign select_2405 = x_s20_q[0] ? {select_2404[3], 1'b0, select_2404[2], 1'b0, select_2404[1], 1'b0, select_2404[0], 1'b0} : {1'b0, select_2404[3], 1'b0, select_2404[2], 1'b0, select_2404[1], 1'b0, select_2404[0]};
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2409;
  assign select_2409 = equal_2384_s20_q ? counts_skin_supervised_q : (equal_2385_s20_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2382 ? counts_textured_q : select_2409;
  // hls/stages/agreement.hpp:392
  logic [2:0] select_2447;
  assign select_2447 = ends_cell_s20_q ? explained_2_s20_q : box_explained_columns_values_0_q;
  logic [2:0] select_2449;
  assign select_2449 = equal_1338_s20_q ? box_explained_columns_values_0_q : (so_s20_q ? select_2447 : box_explained_columns_values_0_q);
  logic [2:0] select_2450;
  assign select_2450 = ends_cell_s20_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2452;
  assign select_2452 = equal_1338_s20_q ? box_explained_columns_values_1_q : (so_s20_q ? select_2450 : box_explained_columns_values_1_q);
  logic [2:0] select_2453;
  assign select_2453 = ends_cell_s20_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2455;
  assign select_2455 = equal_1338_s20_q ? box_explained_columns_values_2_q : (so_s20_q ? select_2453 : box_explained_columns_values_2_q);
  logic [2:0] select_2456;
  assign select_2456 = ends_cell_s20_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2458;
  assign select_2458 = equal_1338_s20_q ? box_explained_columns_values_3_q : (so_s20_q ? select_2456 : box_explained_columns_values_3_q);
  logic [2:0] select_2459;
  assign select_2459 = ends_cell_s20_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2461;
  assign select_2461 = equal_1338_s20_q ? box_explained_columns_values_4_q : (so_s20_q ? select_2459 : box_explained_columns_values_4_q);
  logic [2:0] select_2466;
  assign select_2466 = so_s20_q ? (ends_cell_s20_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2468;
  assign select_2468 = ends_cell_s20_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2470;
  assign select_2470 = equal_1338_s20_q ? box_shown_columns_values_1_q : (so_s20_q ? select_2468 : box_shown_columns_values_1_q);
  logic [2:0] select_2471;
  assign select_2471 = ends_cell_s20_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2473;
  assign select_2473 = equal_1338_s20_q ? box_shown_columns_values_2_q : (so_s20_q ? select_2471 : box_shown_columns_values_2_q);
  logic [2:0] select_2474;
  assign select_2474 = ends_cell_s20_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2476;
  assign select_2476 = equal_1338_s20_q ? box_shown_columns_values_3_q : (so_s20_q ? select_2474 : box_shown_columns_values_3_q);
  logic [2:0] select_2477;
  assign select_2477 = ends_cell_s20_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2479;
  assign select_2479 = equal_1338_s20_q ? box_shown_columns_values_4_q : (so_s20_q ? select_2477 : box_shown_columns_values_4_q);
  logic [2:0] select_2484;
  assign select_2484 = so_s20_q ? (ends_cell_s20_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2486;
  assign select_2486 = ends_cell_s20_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2488;
  assign select_2488 = equal_1338_s20_q ? box_nearer_columns_values_1_q : (so_s20_q ? select_2486 : box_nearer_columns_values_1_q);
  logic [2:0] select_2489;
  assign select_2489 = ends_cell_s20_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2491;
  assign select_2491 = equal_1338_s20_q ? box_nearer_columns_values_2_q : (so_s20_q ? select_2489 : box_nearer_columns_values_2_q);
  logic [2:0] select_2492;
  assign select_2492 = ends_cell_s20_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2494;
  assign select_2494 = equal_1338_s20_q ? box_nearer_columns_values_3_q : (so_s20_q ? select_2492 : box_nearer_columns_values_3_q);
  logic [2:0] select_2495;
  assign select_2495 = ends_cell_s20_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2497;
  assign select_2497 = equal_1338_s20_q ? box_nearer_columns_values_4_q : (so_s20_q ? select_2495 : box_nearer_columns_values_4_q);

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s20_q;
  logic census_memory_we;
  assign census_memory_we = s20_en & and_369_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s20_q[58:40], census_memory_rdata_s20_q[38:0], and_387_s20_q, whole_2_s20_q, select_379_s20_q, select_375_s20_q};
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
      census_filled_q <= and_369_s20_q ? {select_433[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_369_s20_q ? select_432 : rows_passed_above_q;
      counts_textured_q <= and_1979 ? 14'h0 : (counts_textured_q + {13'h0, and_1988});
      counts_skin_supervised_q <= select_2047;
      counts_skin_textured_q <= select_2054;
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
      averager_quarter_1_0_q <= select_1623;
      averager_quarter_1_1_q <= select_1625;
      averager_quarter_2_0_q <= select_1627;
      averager_quarter_2_1_q <= select_1629;
      census_columns_values_0_cell_0_left_q <= select_1657;
      census_columns_values_0_cell_0_right_q <= select_1658;
      census_columns_values_0_cell_1_left_q <= select_1660;
      census_columns_values_0_cell_1_right_q <= select_1661;
      census_columns_values_0_cell_1_mask_q <= select_1662;
      census_columns_values_0_cell_2_left_q <= select_1663;
      census_columns_values_0_cell_2_right_q <= select_1664;
      census_columns_values_0_cell_2_mask_q <= select_1665;
      census_columns_values_0_cell_2_of_skin_q <= select_1666;
      census_columns_values_0_cell_3_left_q <= select_1667;
      census_columns_values_0_cell_3_right_q <= select_1668;
      census_columns_values_0_cell_3_mask_q <= select_1669;
      census_columns_values_0_cell_4_left_q <= select_1670;
      census_columns_values_0_cell_4_right_q <= select_1671;
      census_columns_values_0_cell_4_mask_q <= select_1672;
      census_columns_values_1_cell_0_left_q <= select_1673;
      census_columns_values_1_cell_0_right_q <= select_1674;
      census_columns_values_1_cell_1_left_q <= select_1676;
      census_columns_values_1_cell_1_right_q <= select_1677;
      census_columns_values_1_cell_2_left_q <= select_1679;
      census_columns_values_1_cell_2_right_q <= select_1680;
      census_columns_values_1_cell_2_of_skin_q <= select_1682;
      census_columns_values_1_cell_3_left_q <= select_1683;
      census_columns_values_1_cell_3_right_q <= select_1684;
      census_columns_values_1_cell_4_left_q <= select_1686;
      census_columns_values_1_cell_4_right_q <= select_1687;
      census_columns_values_2_cell_0_left_q <= select_1689;
      census_columns_values_2_cell_0_right_q <= select_1690;
      census_columns_values_2_cell_1_left_q <= select_1692;
      census_columns_values_2_cell_1_right_q <= select_1693;
      census_columns_values_2_cell_2_left_q <= select_1695;
      census_columns_values_2_cell_2_right_q <= select_1696;
      census_columns_values_2_cell_3_left_q <= select_1698;
      census_columns_values_2_cell_3_right_q <= select_1699;
      census_columns_values_2_cell_4_left_q <= select_1701;
      census_columns_values_2_cell_4_right_q <= select_1702;
      census_columns_values_3_cell_1_left_q <= select_1705;
      census_columns_values_3_cell_1_right_q <= select_1706;
      census_columns_values_3_cell_3_left_q <= select_1709;
      census_columns_values_3_cell_3_right_q <= select_1710;
      sharpness_last_mean_0_q <= and_369_s20_q ? select_375_s20_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_369_s20_q ? select_379_s20_q : sharpness_last_mean_1_q;
      box_explained_columns_values_0_q <= select_2449;
      box_explained_columns_values_1_q <= select_2452;
      box_explained_columns_values_2_q <= select_2455;
      box_explained_columns_values_3_q <= select_2458;
      box_explained_columns_values_4_q <= select_2461;
      box_shown_columns_values_0_q <= equal_1338_s20_q ? box_shown_columns_values_0_q : select_2466;
      box_shown_columns_values_1_q <= select_2470;
      box_shown_columns_values_2_q <= select_2473;
      box_shown_columns_values_3_q <= select_2476;
      box_shown_columns_values_4_q <= select_2479;
      box_nearer_columns_values_0_q <= equal_1338_s20_q ? box_nearer_columns_values_0_q : select_2484;
      box_nearer_columns_values_1_q <= select_2488;
      box_nearer_columns_values_2_q <= select_2491;
      box_nearer_columns_values_3_q <= select_2494;
      box_nearer_columns_values_4_q <= select_2497;
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
  logic and_367_s21_q;
  logic and_369_s21_q;
  logic equal_372_s21_q;
  logic whole_2_s21_q;
  logic so_s21_q;
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
  logic less_426_s21_q;
  logic and_434_s21_q;
  logic and_438_s21_q;
  logic difference_461_s21_q;
  logic [8:0] xor_462_s21_q;
  logic difference_464_s21_q;
  logic [8:0] xor_465_s21_q;
  logic difference_468_s21_q;
  logic [8:0] xor_469_s21_q;
  logic difference_472_s21_q;
  logic [8:0] xor_473_s21_q;
  logic difference_476_s21_q;
  logic [8:0] xor_477_s21_q;
  logic equal_1338_s21_q;
  logic not_1339_s21_q;
  logic inside_v_s21_q;
  logic equal_1383_s21_q;
  logic all_s21_q;
  logic equal_1397_s21_q;
  logic equal_1399_s21_q;
  logic equal_1401_s21_q;
  logic equal_1403_s21_q;
  logic right_2_s21_q;
  logic or_1449_s21_q;
  logic or_1452_s21_q;
  logic or_1455_s21_q;
  logic not_1457_s21_q;
  logic [29:0] regions_rdata_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1479_s21_q;
  logic and_1484_s21_q;
  logic [2:0] textured_2_s21_q;
  logic equal_1535_s21_q;
  logic or_1543_s21_q;
  logic or_1546_s21_q;
  logic or_1549_s21_q;
  logic [3:0] difference_1569_s21_q;
  logic [3:0] difference_1585_s21_q;
  logic and_1599_s21_q;
  logic sum_1634_s21_q;
  logic [9:0] difference_1635_s21_q;
  logic sum_1642_s21_q;
  logic [9:0] difference_1643_s21_q;
  logic difference_1714_s21_q;
  logic [8:0] xor_1715_s21_q;
  logic difference_1717_s21_q;
  logic [8:0] xor_1718_s21_q;
  logic difference_1721_s21_q;
  logic [8:0] xor_1722_s21_q;
  logic difference_1725_s21_q;
  logic [8:0] xor_1726_s21_q;
  logic difference_1729_s21_q;
  logic [8:0] xor_1730_s21_q;
  logic equal_1739_s21_q;
  logic difference_1760_s21_q;
  logic [8:0] xor_1761_s21_q;
  logic difference_1772_s21_q;
  logic [8:0] xor_1773_s21_q;
  logic equal_1863_s21_q;
  logic and_1979_s21_q;
  logic and_1983_s21_q;
  logic and_1988_s21_q;
  logic not_2002_s21_q;
  logic [3:0] difference_2012_s21_q;
  logic equal_2087_s21_q;
  logic and_2116_s21_q;
  logic [7:0] select_2124_s21_q;
  logic sum_2131_s21_q;
  logic [9:0] sum_2135_s21_q;
  logic equal_2362_s21_q;
  logic and_2363_s21_q;
  logic equal_2382_s21_q;
  logic equal_2384_s21_q;
  logic equal_2385_s21_q;
  logic equal_2407_s21_q;
  logic [13:0] of_s21_q;
  logic equal_2514_s21_q;
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
      and_367_s21_q <= and_367_s20_q;
      and_369_s21_q <= and_369_s20_q;
      equal_372_s21_q <= equal_372_s20_q;
      whole_2_s21_q <= whole_2_s20_q;
      so_s21_q <= so_s20_q;
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
      less_426_s21_q <= less_426;
      and_434_s21_q <= select_432[4] & select_433[3];
      and_438_s21_q <= and_438;
      difference_461_s21_q <= difference_461[9];
      xor_462_s21_q <= difference_461[8:0] ^ {9{difference_461[9]}};
      difference_464_s21_q <= difference_464[9];
      xor_465_s21_q <= difference_464[8:0] ^ {9{difference_464[9]}};
      difference_468_s21_q <= difference_468[9];
      xor_469_s21_q <= difference_468[8:0] ^ {9{difference_468[9]}};
      difference_472_s21_q <= difference_472[9];
      xor_473_s21_q <= difference_472[8:0] ^ {9{difference_472[9]}};
      difference_476_s21_q <= difference_476[9];
      xor_477_s21_q <= difference_476[8:0] ^ {9{difference_476[9]}};
      equal_1338_s21_q <= equal_1338_s20_q;
      not_1339_s21_q <= not_1339_s20_q;
      inside_v_s21_q <= inside_v_s20_q[0];
      equal_1383_s21_q <= equal_1383_s20_q;
      all_s21_q <= all;
      equal_1397_s21_q <= x_s20_q[5:0] == 6'h3b;
      equal_1399_s21_q <= x_s20_q[5:0] == 6'h36;
      equal_1401_s21_q <= x_s20_q[5:0] == 6'h35;
      equal_1403_s21_q <= x_s20_q[5:0] == 6'h34;
      right_2_s21_q <= right_2_s20_q;
      or_1449_s21_q <= or_1449_s20_q;
      or_1452_s21_q <= or_1452_s20_q;
      or_1455_s21_q <= or_1455_s20_q;
      not_1457_s21_q <= not_1457_s20_q;
      regions_rdata_s21_q <= regions_rdata_q;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1479_s21_q <= and_1479_s20_q;
      and_1484_s21_q <= and_1484_s20_q;
      textured_2_s21_q <= textured_2;
      equal_1535_s21_q <= x_s20_q == 8'h0;
      or_1543_s21_q <= or_1543_s20_q;
      or_1546_s21_q <= or_1546_s20_q;
      or_1549_s21_q <= or_1549_s20_q;
      difference_1569_s21_q <= {1'b0, shown_2} - {1'b0, select_1568};
      difference_1585_s21_q <= {1'b0, near_2} - {1'b0, select_1584};
      and_1599_s21_q <= and_1599_s20_q;
      sum_1634_s21_q <= sum_1634[0];
      difference_1635_s21_q <= {1'b0, sum_1634[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1642_s21_q <= sum_1642[0];
      difference_1643_s21_q <= {1'b0, sum_1642[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1714_s21_q <= difference_1714[9];
      xor_1715_s21_q <= difference_1714[8:0] ^ {9{difference_1714[9]}};
      difference_1717_s21_q <= difference_1717[9];
      xor_1718_s21_q <= difference_1717[8:0] ^ {9{difference_1717[9]}};
      difference_1721_s21_q <= difference_1721[9];
      xor_1722_s21_q <= difference_1721[8:0] ^ {9{difference_1721[9]}};
      difference_1725_s21_q <= difference_1725[9];
      xor_1726_s21_q <= difference_1725[8:0] ^ {9{difference_1725[9]}};
      difference_1729_s21_q <= difference_1729[9];
      xor_1730_s21_q <= difference_1729[8:0] ^ {9{difference_1729[9]}};
      equal_1739_s21_q <= equal_1739_s20_q;
      difference_1760_s21_q <= difference_1760[9];
      xor_1761_s21_q <= difference_1760[8:0] ^ {9{difference_1760[9]}};
      difference_1772_s21_q <= difference_1772[9];
      xor_1773_s21_q <= difference_1772[8:0] ^ {9{difference_1772[9]}};
      equal_1863_s21_q <= equal_1863_s20_q;
      and_1979_s21_q <= and_1979;
      and_1983_s21_q <= and_1983_s20_q;
      and_1988_s21_q <= and_1988;
      not_2002_s21_q <= not_2002_s20_q;
      difference_2012_s21_q <= {1'b0, explained_2_s20_q} - {1'b0, select_2011};
      equal_2087_s21_q <= equal_2087_s20_q;
      and_2116_s21_q <= and_2116_s20_q;
      select_2124_s21_q <= select_2124;
      sum_2131_s21_q <= sum_2131[1];
      sum_2135_s21_q <= sum_2135;
      equal_2362_s21_q <= equal_2362;
      and_2363_s21_q <= equal_2361_s20_q & equal_2362;
      equal_2382_s21_q <= equal_2382;
      equal_2384_s21_q <= equal_2384_s20_q;
      equal_2385_s21_q <= equal_2385_s20_q;
      equal_2407_s21_q <= (limit & select_2405) == 8'h0;
      of_s21_q <= of;
      equal_2514_s21_q <= equal_2514_s20_q;
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
  // hls/stages/agreement.hpp:432
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_438_s21_q;
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
  logic [9:0] sum_463;
  assign sum_463 = {9'h0, difference_461_s21_q} + {1'b0, xor_462_s21_q};
  logic [9:0] sum_466;
  assign sum_466 = {9'h0, difference_464_s21_q} + {1'b0, xor_465_s21_q};
  // hls/stages/agreement.hpp:1122
  logic [1:0] quarter;
  assign quarter = x_s21_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1083
  logic [1:0] select_1386;
  assign select_1386 = x_s21_q[4] ? {x_s21_q[3], x_s21_q[0]} : {x_s21_q[0], x_s21_q[3]};
  // hls/stages/agreement.hpp:1095
  logic [3:0] select_1388;
  assign select_1388 = equal_1383_s21_q ? {2'h0, quarter} : (all_s21_q ? {1'b0, x_s21_q[2:0]} : {x_s21_q[2:1], select_1386});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1389;
  assign sum_1389 = slot_s21_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_1390;
  assign select_1390 = equal_1338_s21_q ? select_1388 : {sum_1389, lower_half_s21_q, registration_of_right_q};
  // hls/stages/agreement.hpp:1120
  logic equal_1391;
  assign equal_1391 = x_s21_q[5:0] == 6'h3e;
  logic equal_1393;
  assign equal_1393 = x_s21_q[5:0] == 6'h3d;
  logic equal_1395;
  assign equal_1395 = x_s21_q[5:0] == 6'h3c;
  // hls/stages/agreement.hpp:1122
  logic and_1406;
  assign and_1406 = (~equal_1399_s21_q) & ((~equal_1401_s21_q) & (~equal_1403_s21_q));
  logic and_1409;
  assign and_1409 = (~equal_1393) & ((~equal_1395) & ((~equal_1397_s21_q) & and_1406));
  // hls/stages/agreement.hpp:1083
  logic less_1411;
  assign less_1411 = x_s21_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all_s21_q ? {1'b0, x_s21_q[2]} : x_s21_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_1415;
  assign or_1415 = (kind == 2'h3) | (x_s21_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1095
  logic select_1418;
  assign select_1418 = equal_1383_s21_q ? ((~equal_1391) & and_1409) : (less_1411 & (~or_1415));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s21_q ? (right_2_s21_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1426;
  assign sum_1426 = {2'h0, slot_s21_q} + 5'h1f;
  // hls/stages/registration.hpp:253
  logic not_1432;
  assign not_1432 = ~lower_half_s21_q;
  logic [3:0] select_1433;
  assign select_1433 = registration_of_right_q ? {lower_half_s21_q, 1'b0, not_1432, 1'b0} : {1'b0, lower_half_s21_q, 1'b0, not_1432};
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1469;
  assign select_1469 = segment_started_s21_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:882
  logic [6:0] sum_1470;
  assign sum_1470 = {6'h0, textured_s21_q} + select_1469;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_1472;
  assign sum_1472 = {3'h0, sum_1470} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[9:0]);
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1474;
  assign select_1474 = segment_started_s21_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:882
  logic [6:0] sum_1475;
  assign sum_1475 = {6'h0, explained_s21_q} + select_1474;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_1477;
  assign sum_1477 = {3'h0, sum_1475} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[19:10]);
  // hls/stages/agreement.hpp:881
  logic [6:0] select_1480;
  assign select_1480 = segment_started_s21_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:883
  logic [6:0] sum_1481;
  assign sum_1481 = {6'h0, and_1479_s21_q} + select_1480;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_1483;
  assign sum_1483 = {3'h0, sum_1481} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[29:20]);
  // hls/stages/agreement.hpp:1207
  logic or_1493;
  assign or_1493 = marks_first_s21_q | line_ended_q;
  // hls/stages/agreement.hpp:1209
  logic [12:0] select_1495;
  assign select_1495 = marks_first_s21_q ? 13'h1 : (or_1493 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1208
  logic [8:0] select_1497;
  assign select_1497 = or_1493 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1216
  logic select_1499;
  assign select_1499 = cfg_compete_i ? (or_1493 & select_1495[12]) : (select_1497[8] & select_1495[9]);
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_1533;
  assign select_1533 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1050
  logic [4:0] around;
  assign around = {difference_1569_s21_q[3], difference_1569_s21_q} + (equal_1535_s21_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1051
  logic [4:0] n;
  assign n = {difference_1585_s21_q[3], difference_1585_s21_q} + (equal_1535_s21_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:209
  logic [9:0] xor_1636;
  assign xor_1636 = {difference_1635_s21_q[8:0], sum_1634_s21_q} ^ {10{difference_1635_s21_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_1635_s21_q[9]} + {1'b0, xor_1636};
  logic [9:0] xor_1644;
  assign xor_1644 = {difference_1643_s21_q[8:0], sum_1642_s21_q} ^ {10{difference_1643_s21_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1643_s21_q[9]} + {1'b0, xor_1644};
  // hls/stages/agreement.hpp:495
  logic select_1659;
  assign select_1659 = and_369_s21_q ? whole_2_s21_q : census_columns_values_0_cell_0_mask_q;
  logic select_1675;
  assign select_1675 = and_369_s21_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1678;
  assign select_1678 = and_369_s21_q ? census_columns_values_0_cell_1_mask_s21_q : census_columns_values_1_cell_1_mask_q;
  logic select_1681;
  assign select_1681 = and_369_s21_q ? census_columns_values_0_cell_2_mask_s21_q : census_columns_values_1_cell_2_mask_q;
  logic select_1685;
  assign select_1685 = and_369_s21_q ? census_columns_values_0_cell_3_mask_s21_q : census_columns_values_1_cell_3_mask_q;
  logic select_1688;
  assign select_1688 = and_369_s21_q ? census_columns_values_0_cell_4_mask_s21_q : census_columns_values_1_cell_4_mask_q;
  logic select_1691;
  assign select_1691 = and_369_s21_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1694;
  assign select_1694 = and_369_s21_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_1716;
  assign sum_1716 = {9'h0, difference_1714_s21_q} + {1'b0, xor_1715_s21_q};
  logic [9:0] sum_1719;
  assign sum_1719 = {9'h0, difference_1717_s21_q} + {1'b0, xor_1718_s21_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1760_s21_q} + xor_1761_s21_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1772_s21_q} + xor_1773_s21_q;
  // hls/stages/agreement.hpp:392
  logic and_1993;
  assign and_1993 = not_1339_s21_q & (so_s21_q & (ends_cell_s21_q & explained_s21_q));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_1995;
  assign select_1995 = and_1979_s21_q ? 14'h0 : (counts_explained_q + {13'h0, and_1993});
  // hls/stages/agreement.hpp:392
  logic and_1998;
  assign and_1998 = not_1339_s21_q & (so_s21_q & (ends_cell_s21_q & and_1479_s21_q));
  // hls/stages/agreement.hpp:1049
  logic [4:0] e;
  assign e = {difference_2012_s21_q[3], difference_2012_s21_q} + (equal_1535_s21_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1085
  logic less_2027;
  assign less_2027 = region_row_s21_q < x_s21_q[5:3];
  // hls/stages/registration.hpp:107
  logic equal_2111;
  assign equal_2111 = slot_s21_q == 3'h4;
  // hls/stages/registration.hpp:101
  logic [11:0] value_2;
  assign value_2 = {{4{select_2124_s21_q[7]}}, select_2124_s21_q} - {sum_2135_s21_q[9], sum_2135_s21_q, sum_2131_s21_q};
  // hls/stages/agreement.hpp:392
  logic select_2182;
  assign select_2182 = so_s21_q ? (equal_2111 ? right_2_s21_q : registration_of_right_q) : registration_of_right_q;
  logic select_2185;
  assign select_2185 = so_s21_q ? (equal_2087_s21_q ? inside_v_s21_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1083
  logic [1:0] quarter_2;
  assign quarter_2 = all_s21_q ? x_s21_q[1:0] : select_1386;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2396;
  assign select_2396 = equal_2362_s21_q ? 14'h0 : product_q;
  logic [13:0] select_2411;
  assign select_2411 = equal_2407_s21_q ? 14'h0 : of_s21_q;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2396} + {1'b0, select_2411};
  // hls/stages/agreement.hpp:392
  logic [2:0] select_2429;
  assign select_2429 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_2431;
  assign select_2431 = equal_1338_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_2429 : box_textured_columns_values_0_q);
  logic [2:0] select_2432;
  assign select_2432 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2434;
  assign select_2434 = equal_1338_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_2432 : box_textured_columns_values_1_q);
  logic [2:0] select_2435;
  assign select_2435 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2437;
  assign select_2437 = equal_1338_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_2435 : box_textured_columns_values_2_q);
  logic [2:0] select_2438;
  assign select_2438 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2440;
  assign select_2440 = equal_1338_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_2438 : box_textured_columns_values_3_q);
  logic [2:0] select_2441;
  assign select_2441 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2443;
  assign select_2443 = equal_1338_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_2441 : box_textured_columns_values_4_q);
  logic [4:0] select_2463;
  assign select_2463 = so_s21_q ? (ends_cell_s21_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2464;
  assign select_2464 = equal_1338_s21_q ? box_explained_sum_sums_values_0_q : select_2463;
  logic [4:0] select_2481;
  assign select_2481 = so_s21_q ? (ends_cell_s21_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_2499;
  assign select_2499 = so_s21_q ? (ends_cell_s21_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;

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
      counts_explained_q <= select_1995;
      registration_of_right_q <= equal_1338_s21_q ? registration_of_right_q : select_2182;
      registration_was_inside_q <= equal_1338_s21_q ? registration_was_inside_q : select_2185;
      segment_textured_q <= select_1469 + {6'h0, and_1988_s21_q};
      segment_explained_q <= select_1474 + {6'h0, and_1993};
      segment_nearer_q <= select_1480 + {6'h0, and_1998};
      product_q <= equal_1338_s21_q ? sum_3[14:1] : product_q;
      rows_passed_q <= select_1495;
      columns_passed_q <= {select_1497[7:0], or_1493};
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
      census_columns_values_0_cell_0_mask_q <= select_1659;
      census_columns_values_1_cell_0_mask_q <= select_1675;
      census_columns_values_1_cell_1_mask_q <= select_1678;
      census_columns_values_1_cell_2_mask_q <= select_1681;
      census_columns_values_1_cell_3_mask_q <= select_1685;
      census_columns_values_1_cell_4_mask_q <= select_1688;
      census_columns_values_2_cell_0_mask_q <= select_1691;
      census_columns_values_2_cell_1_mask_q <= select_1694;
      box_textured_columns_values_0_q <= select_2431;
      box_textured_columns_values_1_q <= select_2434;
      box_textured_columns_values_2_q <= select_2437;
      box_textured_columns_values_3_q <= select_2440;
      box_textured_columns_values_4_q <= select_2443;
      box_explained_sum_sums_values_0_q <= select_2464;
      box_shown_sum_sums_values_0_q <= equal_1338_s21_q ? box_shown_sum_sums_values_0_q : select_2481;
      box_nearer_sum_sums_values_0_q <= equal_1338_s21_q ? box_nearer_sum_sums_values_0_q : select_2499;
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
  logic and_367_s22_q;
  logic and_369_s22_q;
  logic equal_372_s22_q;
  logic whole_2_s22_q;
  logic so_s22_q;
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
  logic less_426_s22_q;
  logic and_434_s22_q;
  logic whole_9_s22_q;
  logic [10:0] sum_467_s22_q;
  logic [9:0] sum_470_s22_q;
  logic [9:0] sum_474_s22_q;
  logic [9:0] sum_478_s22_q;
  logic equal_1338_s22_q;
  logic not_1339_s22_q;
  logic equal_1383_s22_q;
  logic [1:0] quarter_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1389_s22_q;
  logic [3:0] select_1390_s22_q;
  logic equal_1391_s22_q;
  logic equal_1393_s22_q;
  logic equal_1395_s22_q;
  logic equal_1397_s22_q;
  logic equal_1399_s22_q;
  logic equal_1401_s22_q;
  logic equal_1403_s22_q;
  logic less_1411_s22_q;
  logic or_1415_s22_q;
  logic select_1418_s22_q;
  logic and_1428_s22_q;
  logic [3:0] select_1433_s22_q;
  logic or_1449_s22_q;
  logic or_1452_s22_q;
  logic or_1455_s22_q;
  logic not_1457_s22_q;
  logic [9:0] sum_1472_s22_q;
  logic [9:0] sum_1477_s22_q;
  logic [9:0] sum_1483_s22_q;
  logic and_1484_s22_q;
  logic select_1499_s22_q;
  logic [3:0] difference_1534_s22_q;
  logic equal_1535_s22_q;
  logic or_1543_s22_q;
  logic or_1546_s22_q;
  logic or_1549_s22_q;
  logic [4:0] around_s22_q;
  logic less_1588_s22_q;
  logic and_1599_s22_q;
  logic [10:0] size_s22_q;
  logic [10:0] size_2_s22_q;
  logic [10:0] sum_1720_s22_q;
  logic [9:0] sum_1723_s22_q;
  logic [9:0] sum_1727_s22_q;
  logic [9:0] sum_1731_s22_q;
  logic equal_1739_s22_q;
  logic [8:0] contrast_s22_q;
  logic [8:0] contrast_2_s22_q;
  logic equal_1863_s22_q;
  logic and_1979_s22_q;
  logic and_1983_s22_q;
  logic and_1998_s22_q;
  logic not_2002_s22_q;
  logic [4:0] e_s22_q;
  logic [9:0] select_2028_s22_q;
  logic [9:0] select_2031_s22_q;
  logic equal_2087_s22_q;
  logic and_2114_s22_q;
  logic and_2116_s22_q;
  logic [11:0] select_2138_s22_q;
  logic equal_2187_s22_q;
  logic [3:0] not_2188_s22_q;
  logic [1:0] quarter_2_s22_q;
  logic equal_2362_s22_q;
  logic and_2363_s22_q;
  logic less_2364_s22_q;
  logic equal_2365_s22_q;
  logic equal_2382_s22_q;
  logic equal_2384_s22_q;
  logic equal_2385_s22_q;
  logic sum_3_s22_q;
  logic equal_2514_s22_q;
  logic [9:0] select_2607_s22_q;
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
      and_367_s22_q <= and_367_s21_q;
      and_369_s22_q <= and_369_s21_q;
      equal_372_s22_q <= equal_372_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      so_s22_q <= so_s21_q;
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
      less_426_s22_q <= less_426_s21_q;
      and_434_s22_q <= and_434_s21_q;
      whole_9_s22_q <= whole_9;
      sum_467_s22_q <= {1'b0, sum_463} + {1'b0, sum_466};
      sum_470_s22_q <= {9'h0, difference_468_s21_q} + {1'b0, xor_469_s21_q};
      sum_474_s22_q <= {9'h0, difference_472_s21_q} + {1'b0, xor_473_s21_q};
      sum_478_s22_q <= {9'h0, difference_476_s21_q} + {1'b0, xor_477_s21_q};
      equal_1338_s22_q <= equal_1338_s21_q;
      not_1339_s22_q <= not_1339_s21_q;
      equal_1383_s22_q <= equal_1383_s21_q;
      quarter_s22_q <= quarter;
      all_s22_q <= all_s21_q;
      sum_1389_s22_q <= sum_1389;
      select_1390_s22_q <= select_1390;
      equal_1391_s22_q <= equal_1391;
      equal_1393_s22_q <= equal_1393;
      equal_1395_s22_q <= equal_1395;
      equal_1397_s22_q <= equal_1397_s21_q;
      equal_1399_s22_q <= equal_1399_s21_q;
      equal_1401_s22_q <= equal_1401_s21_q;
      equal_1403_s22_q <= equal_1403_s21_q;
      less_1411_s22_q <= less_1411;
      or_1415_s22_q <= or_1415;
      select_1418_s22_q <= select_1418;
      and_1428_s22_q <= half_ends & ({{3{sum_1426[4]}}, sum_1426} < 8'h3);
      select_1433_s22_q <= select_1433;
      or_1449_s22_q <= or_1449_s21_q;
      or_1452_s22_q <= or_1452_s21_q;
      or_1455_s22_q <= or_1455_s21_q;
      not_1457_s22_q <= not_1457_s21_q;
      sum_1472_s22_q <= sum_1472;
      sum_1477_s22_q <= sum_1477;
      sum_1483_s22_q <= sum_1483;
      and_1484_s22_q <= and_1484_s21_q;
      select_1499_s22_q <= select_1499;
      difference_1534_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1533};
      equal_1535_s22_q <= equal_1535_s21_q;
      or_1543_s22_q <= or_1543_s21_q;
      or_1546_s22_q <= or_1546_s21_q;
      or_1549_s22_q <= or_1549_s21_q;
      around_s22_q <= around;
      less_1588_s22_q <= {1'b0, around[4:1]} < n;
      and_1599_s22_q <= and_1599_s21_q;
      size_s22_q <= size;
      size_2_s22_q <= size_2;
      sum_1720_s22_q <= {1'b0, sum_1716} + {1'b0, sum_1719};
      sum_1723_s22_q <= {9'h0, difference_1721_s21_q} + {1'b0, xor_1722_s21_q};
      sum_1727_s22_q <= {9'h0, difference_1725_s21_q} + {1'b0, xor_1726_s21_q};
      sum_1731_s22_q <= {9'h0, difference_1729_s21_q} + {1'b0, xor_1730_s21_q};
      equal_1739_s22_q <= equal_1739_s21_q;
      contrast_s22_q <= contrast;
      contrast_2_s22_q <= contrast_2;
      equal_1863_s22_q <= equal_1863_s21_q;
      and_1979_s22_q <= and_1979_s21_q;
      and_1983_s22_q <= and_1983_s21_q;
      and_1998_s22_q <= and_1998;
      not_2002_s22_q <= not_2002_s21_q;
      e_s22_q <= e;
      select_2028_s22_q <= less_2027 ? 10'h0 : regions_rdata_s21_q[9:0];
      select_2031_s22_q <= less_2027 ? 10'h0 : regions_rdata_s21_q[19:10];
      equal_2087_s22_q <= equal_2087_s21_q;
      and_2114_s22_q <= not_1339_s21_q & (so_s21_q & (half_ends & equal_2111));
      and_2116_s22_q <= and_2116_s21_q;
      select_2138_s22_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2187_s22_q <= sum_1389 == 2'h2;
      not_2188_s22_q <= ~select_1433;
      quarter_2_s22_q <= quarter_2;
      equal_2362_s22_q <= equal_2362_s21_q;
      and_2363_s22_q <= and_2363_s21_q;
      less_2364_s22_q <= counts_explained_q < product_q;
      equal_2365_s22_q <= counts_explained_q == product_q;
      equal_2382_s22_q <= equal_2382_s21_q;
      equal_2384_s22_q <= equal_2384_s21_q;
      equal_2385_s22_q <= equal_2385_s21_q;
      sum_3_s22_q <= sum_3[0];
      equal_2514_s22_q <= equal_2514_s21_q;
      select_2607_s22_q <= less_2027 ? 10'h0 : regions_rdata_s21_q[29:20];
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
  logic [10:0] sum_471;
  assign sum_471 = sum_467_s22_q + {1'b0, sum_470_s22_q};
  // hls/stages/agreement.hpp:392
  logic and_1429;
  assign and_1429 = so_s22_q & and_1428_s22_q;
  // hls/stages/agreement.hpp:411
  logic next_row;
  assign next_row = select_1499_s22_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1223
  logic [6:0] select_1502;
  assign select_1502 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1233
  logic equal_1505;
  assign equal_1505 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1206
  logic not_1512;
  assign not_1512 = ~marks_first_s22_q;
  // hls/stages/agreement.hpp:1048
  logic [4:0] t;
  assign t = {difference_1534_s22_q[3], difference_1534_s22_q} + (equal_1535_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1055
  logic not_1550;
  assign not_1550 = ~region_row_s22_q[2];
  logic [2:0] select_1551;
  assign select_1551 = region_row_s22_q[1] ? {1'b0, not_1550, 1'b0} : {region_row_s22_q[2], 1'b0, not_1550};
  logic [5:0] select_1552;
  assign select_1552 = region_row_s22_q[0] ? {select_1551[2], 1'b0, select_1551[1], 1'b0, select_1551[0], 1'b0} : {1'b0, select_1551[2], 1'b0, select_1551[1], 1'b0, select_1551[0]};
  logic [11:0] select_1553;
  assign select_1553 = or_1549_s22_q ? {select_1552[5], 1'b0, select_1552[4], 1'b0, select_1552[3], 1'b0, select_1552[2], 1'b0, select_1552[1], 1'b0, select_1552[0], 1'b0} : {1'b0, select_1552[5], 1'b0, select_1552[4], 1'b0, select_1552[3], 1'b0, select_1552[2], 1'b0, select_1552[1], 1'b0, select_1552[0]};
  logic [23:0] select_1554;
  assign select_1554 = or_1546_s22_q ? {select_1553[11], 1'b0, select_1553[10], 1'b0, select_1553[9], 1'b0, select_1553[8], 1'b0, select_1553[7], 1'b0, select_1553[6], 1'b0, select_1553[5], 1'b0, select_1553[4], 1'b0, select_1553[3], 1'b0, select_1553[2], 1'b0, select_1553[1], 1'b0, select_1553[0], 1'b0} : {1'b0, select_1553[11], 1'b0, select_1553[10], 1'b0, select_1553[9], 1'b0, select_1553[8], 1'b0, select_1553[7], 1'b0, select_1553[6], 1'b0, select_1553[5], 1'b0, select_1553[4], 1'b0, select_1553[3], 1'b0, select_1553[2], 1'b0, select_1553[1], 1'b0, select_1553[0]};
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_1572;
  assign sum_1572 = {1'b0, around_s22_q} + {2'h0, around_s22_q[4:1]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s22_q} + (equal_372_s22_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_1641;
  assign select_1641 = sample_pair_whole_s22_q ? (and_367_s22_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s22_q} + (equal_372_s22_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_1649;
  assign select_1649 = sample_pair_whole_s22_q ? (and_367_s22_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:495
  logic select_1697;
  assign select_1697 = and_369_s22_q ? census_columns_values_1_cell_2_mask_s22_q : census_columns_values_2_cell_2_mask_q;
  logic select_1700;
  assign select_1700 = and_369_s22_q ? census_columns_values_1_cell_3_mask_s22_q : census_columns_values_2_cell_3_mask_q;
  logic select_1703;
  assign select_1703 = and_369_s22_q ? census_columns_values_1_cell_4_mask_s22_q : census_columns_values_2_cell_4_mask_q;
  logic select_1704;
  assign select_1704 = and_369_s22_q ? census_columns_values_2_cell_0_mask_s22_q : census_columns_values_3_cell_0_mask_q;
  logic select_1707;
  assign select_1707 = and_369_s22_q ? census_columns_values_2_cell_1_mask_s22_q : census_columns_values_3_cell_1_mask_q;
  logic select_1708;
  assign select_1708 = and_369_s22_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1711;
  assign select_1711 = and_369_s22_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_1724;
  assign sum_1724 = sum_1720_s22_q + {1'b0, sum_1723_s22_q};
  // hls/stages/agreement.hpp:495
  logic select_1756;
  assign select_1756 = and_369_s22_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_1759;
  assign and_1759 = whole_2_s22_q & (~(column_s22_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:433
  logic and_1765;
  assign and_1765 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s22_q[8:2]));
  logic and_1766;
  assign and_1766 = and_1759 & and_1765;
  logic and_1777;
  assign and_1777 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s22_q[8:2]));
  logic and_1778;
  assign and_1778 = and_1759 & and_1777;
  // hls/stages/census.hpp:409
  logic not_1795;
  assign not_1795 = ~x_s22_q[1];
  logic [2:0] select_1796;
  assign select_1796 = x_s22_q[0] ? {1'b0, not_1795, 1'b0} : {x_s22_q[1], 1'b0, not_1795};
  logic [5:0] select_1797;
  assign select_1797 = slot_s22_q[2] ? {select_1796[2], 1'b0, select_1796[1], 1'b0, select_1796[0], 1'b0} : {1'b0, select_1796[2], 1'b0, select_1796[1], 1'b0, select_1796[0]};
  logic [11:0] select_1798;
  assign select_1798 = slot_s22_q[1] ? {select_1797[5], 1'b0, select_1797[4], 1'b0, select_1797[3], 1'b0, select_1797[2], 1'b0, select_1797[1], 1'b0, select_1797[0], 1'b0} : {1'b0, select_1797[5], 1'b0, select_1797[4], 1'b0, select_1797[3], 1'b0, select_1797[2], 1'b0, select_1797[1], 1'b0, select_1797[0]};
  // hls/stages/agreement.hpp:904
  logic [13:0] select_1985;
  assign select_1985 = and_1979_s22_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1983_s22_q});
  // hls/stages/agreement.hpp:1056
  logic [5:0] sum_2015;
  assign sum_2015 = {1'b0, e_s22_q} + {2'h0, e_s22_q[4:1]};
  // hls/stages/registration.hpp:213
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2138_s22_q[11:7])) ? 12'h7f : select_2138_s22_q;
  // hls/stages/registration.hpp:264
  logic [3:0] select_2190;
  assign select_2190 = equal_2187_s22_q ? (registration_fresh_q & not_2188_s22_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_2192;
  assign select_2192 = so_s22_q ? (and_1428_s22_q ? select_2190 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:237
  logic [3:0] select_2194;
  assign select_2194 = and_1979_s22_q ? 4'hf : (equal_1338_s22_q ? registration_fresh_q : select_2192);
  // hls/stages/registration.hpp:253
  logic not_2215;
  assign not_2215 = ~quarter_2_s22_q[1];
  logic [3:0] select_2216;
  assign select_2216 = quarter_2_s22_q[0] ? {quarter_2_s22_q[1], 1'b0, not_2215, 1'b0} : {1'b0, quarter_2_s22_q[1], 1'b0, not_2215};
  // hls/stages/agreement.hpp:1132
  logic or_2359;
  assign or_2359 = ({counts_textured_s22_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s22_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1163
  logic too_little;
  assign too_little = less_2364_s22_q | (product_rest_q & equal_2365_s22_q);
  // hls/stages/agreement.hpp:1164
  logic select_2368;
  assign select_2368 = and_2363_s22_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2371;
  assign sum_2371 = {1'b0, select_2031_s22_q} + {2'h0, select_2031_s22_q[9:1]};
  // hls/stages/agreement.hpp:392
  logic select_2416;
  assign select_2416 = equal_1338_s22_q ? (equal_2362_s22_q ? sum_3_s22_q : (product_rest_q | sum_3_s22_q)) : product_rest_q;
  logic [4:0] select_2445;
  assign select_2445 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_2446;
  assign select_2446 = equal_1338_s22_q ? box_textured_sum_sums_values_0_q : select_2445;
  // hls/stages/agreement.hpp:1232
  logic [3:0] select_2531;
  assign select_2531 = select_1499_s22_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:411
  logic [7:0] select_2537;
  assign select_2537 = marks_first_s22_q ? (less_2533 ? {sum_2534, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:253
  logic not_2595;
  assign not_2595 = ~quarter_s22_q[1];
  logic [3:0] select_2596;
  assign select_2596 = quarter_s22_q[0] ? {quarter_s22_q[1], 1'b0, not_2595, 1'b0} : {1'b0, quarter_s22_q[1], 1'b0, not_2595};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:271; read in stage 22, written in stage 26: 22 < 26 < 22 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1390_s22_q;
  logic registration_sums_re;
  assign registration_sums_re = s22_en & (equal_1338_s22_q ? (x_s22_q[6] & select_1418_s22_q) : and_1429);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s22_q, or_1455_s22_q, or_1452_s22_q, or_1449_s22_q};
  logic regions_we;
  assign regions_we = s22_en & and_1484_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1483_s22_q, sum_1477_s22_q, sum_1472_s22_q};
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
      sharpness_before_last_mask_q <= select_1756;
      counts_supervised_q <= select_1985;
      registration_fresh_q <= select_2194;
      product_rest_q <= select_2416;
      disagree_q <= equal_1338_s22_q ? select_2368 : disagree_q;
      began_q <= not_1512 & (began_q | select_1499_s22_q);
      seen_x_q <= select_1499_s22_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s22_q ? 4'h0 : select_2531;
      seen_column_q <= select_1499_s22_q ? 8'h0 : (seen_column_q + {7'h0, equal_1505});
      seen_rows_left_q <= select_2537;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s22_q ? 13'h0 : (seen_base_q + {6'h0, select_1502});
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
      averager_detail_0_q <= select_1641;
      averager_detail_1_q <= select_1649;
      census_columns_values_2_cell_2_mask_q <= select_1697;
      census_columns_values_2_cell_3_mask_q <= select_1700;
      census_columns_values_2_cell_4_mask_q <= select_1703;
      census_columns_values_3_cell_0_mask_q <= select_1704;
      census_columns_values_3_cell_1_mask_q <= select_1707;
      census_columns_values_3_cell_2_mask_q <= select_1708;
      census_columns_values_3_cell_3_mask_q <= select_1711;
      sharpness_last_mask_q <= and_369_s22_q ? whole_2_s22_q : sharpness_last_mask_q;
      box_textured_sum_sums_values_0_q <= select_2446;
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
  logic and_369_s23_q;
  logic so_s23_q;
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
  logic less_426_s23_q;
  logic and_434_s23_q;
  logic whole_16_s23_q;
  logic and_460_s23_q;
  logic [11:0] sum_475_s23_q;
  logic [9:0] sum_478_s23_q;
  logic equal_1338_s23_q;
  logic not_1339_s23_q;
  logic equal_1383_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1389_s23_q;
  logic equal_1391_s23_q;
  logic equal_1393_s23_q;
  logic equal_1395_s23_q;
  logic equal_1397_s23_q;
  logic equal_1399_s23_q;
  logic equal_1401_s23_q;
  logic equal_1403_s23_q;
  logic less_1411_s23_q;
  logic or_1415_s23_q;
  logic equal_1435_s23_q;
  logic and_1445_s23_q;
  logic not_1457_s23_q;
  logic not_1512_s23_q;
  logic [7:0] sum_1522_s23_q;
  logic equal_1538_s23_q;
  logic or_1543_s23_q;
  logic [23:0] select_1554_s23_q;
  logic not_1574_s23_q;
  logic less_1588_s23_q;
  logic and_1599_s23_q;
  logic [11:0] sum_1728_s23_q;
  logic [9:0] sum_1731_s23_q;
  logic equal_1739_s23_q;
  logic [27:0] select_1753_s23_q;
  logic and_1766_s23_q;
  logic and_1778_s23_q;
  logic [8:0] select_1785_s23_q;
  logic [8:0] select_1789_s23_q;
  logic equal_1792_s23_q;
  logic less_1793_s23_q;
  logic [11:0] select_1798_s23_q;
  logic equal_1836_s23_q;
  logic equal_1863_s23_q;
  logic and_1979_s23_q;
  logic and_1998_s23_q;
  logic not_2002_s23_q;
  logic not_2017_s23_q;
  logic [9:0] select_2028_s23_q;
  logic [9:0] select_2031_s23_q;
  logic equal_2087_s23_q;
  logic and_2114_s23_q;
  logic and_2116_s23_q;
  logic [11:0] residual_s23_q;
  logic equal_2218_s23_q;
  logic equal_2356_s23_q;
  logic or_2359_s23_q;
  logic equal_2362_s23_q;
  logic select_2368_s23_q;
  logic not_2373_s23_q;
  logic equal_2382_s23_q;
  logic equal_2384_s23_q;
  logic equal_2385_s23_q;
  logic equal_2514_s23_q;
  logic equal_2598_s23_q;
  logic [9:0] select_2607_s23_q;
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
      and_369_s23_q <= and_369_s22_q;
      so_s23_q <= so_s22_q;
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
      less_426_s23_q <= less_426_s22_q;
      and_434_s23_q <= and_434_s22_q;
      whole_16_s23_q <= whole_16;
      and_460_s23_q <= census_columns_values_1_cell_2_mask_s22_q & and_434_s22_q;
      sum_475_s23_q <= {1'b0, sum_471} + {2'h0, sum_474_s22_q};
      sum_478_s23_q <= sum_478_s22_q;
      equal_1338_s23_q <= equal_1338_s22_q;
      not_1339_s23_q <= not_1339_s22_q;
      equal_1383_s23_q <= equal_1383_s22_q;
      all_s23_q <= all_s22_q;
      sum_1389_s23_q <= sum_1389_s22_q;
      equal_1391_s23_q <= equal_1391_s22_q;
      equal_1393_s23_q <= equal_1393_s22_q;
      equal_1395_s23_q <= equal_1395_s22_q;
      equal_1397_s23_q <= equal_1397_s22_q;
      equal_1399_s23_q <= equal_1399_s22_q;
      equal_1401_s23_q <= equal_1401_s22_q;
      equal_1403_s23_q <= equal_1403_s22_q;
      less_1411_s23_q <= less_1411_s22_q;
      or_1415_s23_q <= or_1415_s22_q;
      equal_1435_s23_q <= (registration_fresh_q & select_1433_s22_q) == 4'h0;
      and_1445_s23_q <= not_1339_s22_q & and_1429;
      not_1457_s23_q <= not_1457_s22_q;
      not_1512_s23_q <= not_1512;
      sum_1522_s23_q <= {2'h0, x_s22_q[7:2]} + 8'hff;
      equal_1538_s23_q <= t[4:1] == 4'h0;
      or_1543_s23_q <= or_1543_s22_q;
      select_1554_s23_q <= select_1554;
      not_1574_s23_q <= ~({sum_1572, around_s22_q[0]} < {2'h0, t});
      less_1588_s23_q <= less_1588_s22_q;
      and_1599_s23_q <= and_1599_s22_q;
      sum_1728_s23_q <= {1'b0, sum_1724} + {2'h0, sum_1727_s22_q};
      sum_1731_s23_q <= sum_1731_s22_q;
      equal_1739_s23_q <= equal_1739_s22_q;
      select_1753_s23_q <= sample_pair_whole_s22_q ? {detail_2, detail} : 28'h0;
      and_1766_s23_q <= and_1766;
      and_1778_s23_q <= and_1778;
      select_1785_s23_q <= and_1766 ? contrast_s22_q : 9'h0;
      select_1789_s23_q <= and_1778 ? contrast_2_s22_q : 9'h0;
      equal_1792_s23_q <= x_s22_q[7:3] == 5'h0;
      less_1793_s23_q <= 7'h2 < {x_s22_q[4:0], slot_s22_q[2:1]};
      select_1798_s23_q <= select_1798;
      equal_1836_s23_q <= {x_s22_q[4:0], slot_s22_q} == 8'h0;
      equal_1863_s23_q <= equal_1863_s22_q;
      and_1979_s23_q <= and_1979_s22_q;
      and_1998_s23_q <= and_1998_s22_q;
      not_2002_s23_q <= not_2002_s22_q;
      not_2017_s23_q <= ~({sum_2015, e_s22_q[0]} < {2'h0, t});
      select_2028_s23_q <= select_2028_s22_q;
      select_2031_s23_q <= select_2031_s22_q;
      equal_2087_s23_q <= equal_2087_s22_q;
      and_2114_s23_q <= and_2114_s22_q;
      and_2116_s23_q <= and_2116_s22_q;
      residual_s23_q <= residual;
      equal_2218_s23_q <= (registration_fresh_q & select_2216) == 4'h0;
      equal_2356_s23_q <= select_2028_s22_q[9:3] == 7'h0;
      or_2359_s23_q <= or_2359;
      equal_2362_s23_q <= equal_2362_s22_q;
      select_2368_s23_q <= select_2368;
      not_2373_s23_q <= ~({sum_2371, select_2031_s22_q[0]} < {2'h0, select_2028_s22_q});
      equal_2382_s23_q <= equal_2382_s22_q;
      equal_2384_s23_q <= equal_2384_s22_q;
      equal_2385_s23_q <= equal_2385_s22_q;
      equal_2514_s23_q <= equal_2514_s22_q;
      equal_2598_s23_q <= (registration_fresh_q & select_2596) == 4'h0;
      select_2607_s23_q <= select_2607_s22_q;
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
  assign texture = sum_475_s23_q + {2'h0, sum_478_s23_q};
  // hls/stages/agreement.hpp:1240
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1207
  logic select_1510;
  assign select_1510 = marks_first_s23_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1193
  logic [10:0] sum_1511;
  assign sum_1511 = {1'b0, {5{select_1510}}, 1'b0, {2{select_1510}}, 1'b0, select_1510} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1065
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1522_s23_q[7]}}, sum_1522_s23_q, x_s23_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1193
  logic [10:0] sum_1524;
  assign sum_1524 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1055
  logic [47:0] select_1555;
  assign select_1555 = or_1543_s23_q ? {select_1554_s23_q[23], 1'b0, select_1554_s23_q[22], 1'b0, select_1554_s23_q[21], 1'b0, select_1554_s23_q[20], 1'b0, select_1554_s23_q[19], 1'b0, select_1554_s23_q[18], 1'b0, select_1554_s23_q[17], 1'b0, select_1554_s23_q[16], 1'b0, select_1554_s23_q[15], 1'b0, select_1554_s23_q[14], 1'b0, select_1554_s23_q[13], 1'b0, select_1554_s23_q[12], 1'b0, select_1554_s23_q[11], 1'b0, select_1554_s23_q[10], 1'b0, select_1554_s23_q[9], 1'b0, select_1554_s23_q[8], 1'b0, select_1554_s23_q[7], 1'b0, select_1554_s23_q[6], 1'b0, select_1554_s23_q[5], 1'b0, select_1554_s23_q[4], 1'b0, select_1554_s23_q[3], 1'b0, select_1554_s23_q[2], 1'b0, select_1554_s23_q[1], 1'b0, select_1554_s23_q[0], 1'b0} : {1'b0, select_1554_s23_q[23], 1'b0, select_1554_s23_q[22], 1'b0, select_1554_s23_q[21], 1'b0, select_1554_s23_q[20], 1'b0, select_1554_s23_q[19], 1'b0, select_1554_s23_q[18], 1'b0, select_1554_s23_q[17], 1'b0, select_1554_s23_q[16], 1'b0, select_1554_s23_q[15], 1'b0, select_1554_s23_q[14], 1'b0, select_1554_s23_q[13], 1'b0, select_1554_s23_q[12], 1'b0, select_1554_s23_q[11], 1'b0, select_1554_s23_q[10], 1'b0, select_1554_s23_q[9], 1'b0, select_1554_s23_q[8], 1'b0, select_1554_s23_q[7], 1'b0, select_1554_s23_q[6], 1'b0, select_1554_s23_q[5], 1'b0, select_1554_s23_q[4], 1'b0, select_1554_s23_q[3], 1'b0, select_1554_s23_q[2], 1'b0, select_1554_s23_q[1], 1'b0, select_1554_s23_q[0]};
  // hls/stages/agreement.hpp:495
  logic select_1712;
  assign select_1712 = and_369_s23_q ? census_columns_values_2_cell_4_mask_s23_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_1732;
  assign sum_1732 = sum_1728_s23_q + {2'h0, sum_1731_s23_q};
  // hls/stages/agreement.hpp:495
  logic [11:0] select_1734;
  assign select_1734 = and_369_s23_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1735;
  assign select_1735 = and_369_s23_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_1754;
  assign select_1754 = and_369_s23_q ? select_1753_s23_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_1755;
  assign select_1755 = and_369_s23_q ? select_1753_s23_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1753_s23_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1753_s23_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_1786;
  assign sum_1786 = (equal_1739_s23_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1785_s23_q};
  logic [23:0] sum_1790;
  assign sum_1790 = (equal_1739_s23_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1789_s23_q};
  // hls/stages/census.hpp:409
  logic less_1794;
  assign less_1794 = x_s23_q[4:0] < 5'h3;
  logic [23:0] select_1799;
  assign select_1799 = slot_s23_q ? {select_1798_s23_q[11], 1'b0, select_1798_s23_q[10], 1'b0, select_1798_s23_q[9], 1'b0, select_1798_s23_q[8], 1'b0, select_1798_s23_q[7], 1'b0, select_1798_s23_q[6], 1'b0, select_1798_s23_q[5], 1'b0, select_1798_s23_q[4], 1'b0, select_1798_s23_q[3], 1'b0, select_1798_s23_q[2], 1'b0, select_1798_s23_q[1], 1'b0, select_1798_s23_q[0], 1'b0} : {1'b0, select_1798_s23_q[11], 1'b0, select_1798_s23_q[10], 1'b0, select_1798_s23_q[9], 1'b0, select_1798_s23_q[8], 1'b0, select_1798_s23_q[7], 1'b0, select_1798_s23_q[6], 1'b0, select_1798_s23_q[5], 1'b0, select_1798_s23_q[4], 1'b0, select_1798_s23_q[3], 1'b0, select_1798_s23_q[2], 1'b0, select_1798_s23_q[1], 1'b0, select_1798_s23_q[0]};
  // hls/stages/census.hpp:372
  logic and_1803;
  assign and_1803 = less_1794 & (~((sharpness_sums_contrast_1_q & select_1799) == 24'h0));
  logic and_1813;
  assign and_1813 = less_1794 & (~((sharpness_sums_contrast_0_q & select_1799) == 24'h0));
  // hls/stages/agreement.hpp:1086
  logic [10:0] sum_2032;
  assign sum_2032 = {1'b0, select_2031_s23_q} + {3'h0, select_2031_s23_q[9:2]};
  // hls/stages/registration.hpp:200
  logic [12:0] difference_2159;
  assign difference_2159 = 13'h0 - {residual_s23_q[11], residual_s23_q};
  logic less_2174;
  assign less_2174 = $signed(difference_2159) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1088
  logic select_2374;
  assign select_2374 = equal_2356_s23_q ? ((~or_2359_s23_q) & (~select_2368_s23_q)) : not_2373_s23_q;
  // hls/stages/agreement.hpp:1095
  logic [47:0] select_2376;
  assign select_2376 = x_s23_q[6] ? (equal_1383_s23_q ? good_q : {select_2374, good_q[47:1]}) : good_q;
  logic equal_2379;
  assign equal_2379 = x_s23_q == 7'h7f;
  // hls/stages/agreement.hpp:436
  logic [12:0] select_2517;
  assign select_2517 = equal_1863_s23_q ? (equal_2514_s23_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2520;
  assign select_2520 = and_369_s23_q ? (equal_1863_s23_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
      sharpness_sums_contrast_0_q <= and_369_s23_q ? sum_1786 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_369_s23_q ? sum_1790 : sharpness_sums_contrast_1_q;
      good_q <= equal_1338_s23_q ? select_2376 : good_q;
      map_row_q <= and_369_s23_q ? select_2517 : map_row_q;
      map_width_q <= select_2520;
      write_half_q <= marks_first_s23_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1510;
      done_q <= not_1512_s23_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s23_q;
      said_q <= equal_1338_s23_q & equal_2379;
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
      census_columns_values_3_cell_4_mask_q <= select_1712;
      census_changes_values_0_left_q <= and_369_s23_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_369_s23_q ? sum_1732 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1734;
      census_changes_values_1_right_q <= select_1735;
      sharpness_last_detail_0_q <= select_1754;
      sharpness_last_detail_1_q <= select_1755;
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
  logic and_369_s24_q;
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
  logic less_426_s24_q;
  logic and_434_s24_q;
  logic and_459_s24_q;
  logic and_460_s24_q;
  logic [12:0] sum_480_s24_q;
  logic equal_1338_s24_q;
  logic not_1339_s24_q;
  logic equal_1383_s24_q;
  logic all_s24_q;
  logic [1:0] sum_1389_s24_q;
  logic equal_1391_s24_q;
  logic equal_1393_s24_q;
  logic equal_1395_s24_q;
  logic equal_1397_s24_q;
  logic equal_1399_s24_q;
  logic equal_1401_s24_q;
  logic equal_1403_s24_q;
  logic less_1411_s24_q;
  logic or_1415_s24_q;
  logic [31:0] registration_sums_rdata_s24_q;
  logic equal_1435_s24_q;
  logic and_1445_s24_q;
  logic not_1457_s24_q;
  logic [2:0] index_s24_q;
  logic [10:0] sum_1511_s24_q;
  logic and_1518_s24_q;
  logic less_1519_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1524_s24_q;
  logic equal_1538_s24_q;
  logic not_1558_s24_q;
  logic not_1574_s24_q;
  logic less_1588_s24_q;
  logic and_1599_s24_q;
  logic equal_1739_s24_q;
  logic [12:0] sum_1740_s24_q;
  logic [12:0] select_1768_s24_q;
  logic [12:0] select_1780_s24_q;
  logic equal_1792_s24_q;
  logic less_1793_s24_q;
  logic and_1803_s24_q;
  logic and_1813_s24_q;
  logic equal_1836_s24_q;
  logic and_1979_s24_q;
  logic and_1998_s24_q;
  logic not_2002_s24_q;
  logic not_2017_s24_q;
  logic [9:0] select_2028_s24_q;
  logic [9:0] select_2031_s24_q;
  logic less_2033_s24_q;
  logic equal_2087_s24_q;
  logic and_2114_s24_q;
  logic and_2116_s24_q;
  logic [7:0] residual_s24_q;
  logic less_2160_s24_q;
  logic less_2174_s24_q;
  logic equal_2218_s24_q;
  logic or_2359_s24_q;
  logic equal_2362_s24_q;
  logic select_2368_s24_q;
  logic equal_2379_s24_q;
  logic equal_2382_s24_q;
  logic equal_2384_s24_q;
  logic equal_2385_s24_q;
  logic equal_2598_s24_q;
  logic [9:0] select_2607_s24_q;
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
      and_369_s24_q <= and_369_s23_q;
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
      less_426_s24_q <= less_426_s23_q;
      and_434_s24_q <= and_434_s23_q;
      and_459_s24_q <= whole_22 & and_434_s23_q;
      and_460_s24_q <= and_460_s23_q;
      sum_480_s24_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1338_s24_q <= equal_1338_s23_q;
      not_1339_s24_q <= not_1339_s23_q;
      equal_1383_s24_q <= equal_1383_s23_q;
      all_s24_q <= all_s23_q;
      sum_1389_s24_q <= sum_1389_s23_q;
      equal_1391_s24_q <= equal_1391_s23_q;
      equal_1393_s24_q <= equal_1393_s23_q;
      equal_1395_s24_q <= equal_1395_s23_q;
      equal_1397_s24_q <= equal_1397_s23_q;
      equal_1399_s24_q <= equal_1399_s23_q;
      equal_1401_s24_q <= equal_1401_s23_q;
      equal_1403_s24_q <= equal_1403_s23_q;
      less_1411_s24_q <= less_1411_s23_q;
      or_1415_s24_q <= or_1415_s23_q;
      registration_sums_rdata_s24_q <= registration_sums_rdata_q;
      equal_1435_s24_q <= equal_1435_s23_q;
      and_1445_s24_q <= and_1445_s23_q;
      not_1457_s24_q <= not_1457_s23_q;
      index_s24_q <= index[2:0];
      sum_1511_s24_q <= sum_1511;
      and_1518_s24_q <= began_q & (seen_x_q == 4'h0);
      less_1519_s24_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s24_q <= index_2[2:0];
      sum_1524_s24_q <= sum_1524;
      equal_1538_s24_q <= equal_1538_s23_q;
      not_1558_s24_q <= ~((good_q & select_1555) == 48'h0);
      not_1574_s24_q <= not_1574_s23_q;
      less_1588_s24_q <= less_1588_s23_q;
      and_1599_s24_q <= and_1599_s23_q;
      equal_1739_s24_q <= equal_1739_s23_q;
      sum_1740_s24_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1732};
      select_1768_s24_q <= and_1766_s23_q ? detail_3[14:2] : 13'h0;
      select_1780_s24_q <= and_1778_s23_q ? detail_4[14:2] : 13'h0;
      equal_1792_s24_q <= equal_1792_s23_q;
      less_1793_s24_q <= less_1793_s23_q;
      and_1803_s24_q <= and_1803;
      and_1813_s24_q <= and_1813;
      equal_1836_s24_q <= equal_1836_s23_q;
      and_1979_s24_q <= and_1979_s23_q;
      and_1998_s24_q <= and_1998_s23_q;
      not_2002_s24_q <= not_2002_s23_q;
      not_2017_s24_q <= not_2017_s23_q;
      select_2028_s24_q <= select_2028_s23_q;
      select_2031_s24_q <= select_2031_s23_q;
      less_2033_s24_q <= {sum_2032, select_2031_s23_q[1:0]} < {3'h0, select_2028_s23_q};
      equal_2087_s24_q <= equal_2087_s23_q;
      and_2114_s24_q <= and_2114_s23_q;
      and_2116_s24_q <= and_2116_s23_q;
      residual_s24_q <= residual_s23_q[7:0];
      less_2160_s24_q <= $signed(difference_2159) < $signed({7'h0, cfg_moved_limit_i});
      less_2174_s24_q <= less_2174;
      equal_2218_s24_q <= equal_2218_s23_q;
      or_2359_s24_q <= or_2359_s23_q;
      equal_2362_s24_q <= equal_2362_s23_q;
      select_2368_s24_q <= select_2368_s23_q;
      equal_2379_s24_q <= equal_2379;
      equal_2382_s24_q <= equal_2382_s23_q;
      equal_2384_s24_q <= equal_2384_s23_q;
      equal_2385_s24_q <= equal_2385_s23_q;
      equal_2598_s24_q <= equal_2598_s23_q;
      select_2607_s24_q <= select_2607_s23_q;
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
  logic [13:0] sum_481;
  assign sum_481 = {2'h0, census_changes_values_1_left_s24_q} + {1'b0, sum_480_s24_q};
  logic [13:0] sum_482;
  assign sum_482 = {2'h0, census_changes_values_2_left_q} + sum_481;
  // hls/stages/agreement.hpp:988
  logic and_1559;
  assign and_1559 = good_known_q & not_1558_s24_q;
  // hls/stages/agreement.hpp:1057
  logic is_seen;
  assign is_seen = equal_1538_s24_q ? and_1559 : not_1574_s24_q;
  // hls/stages/agreement.hpp:495
  logic [11:0] select_1736;
  assign select_1736 = and_369_s24_q ? census_changes_values_1_left_s24_q : census_changes_values_2_left_q;
  logic [11:0] select_1737;
  assign select_1737 = and_369_s24_q ? census_changes_values_1_right_s24_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_1741;
  assign sum_1741 = {2'h0, census_changes_values_1_right_s24_q} + {1'b0, sum_1740_s24_q};
  logic [13:0] sum_1742;
  assign sum_1742 = {2'h0, census_changes_values_2_right_q} + sum_1741;
  // hls/stages/census.hpp:357
  logic [23:0] select_1770;
  assign select_1770 = equal_1739_s24_q ? {11'h0, select_1768_s24_q} : (sharpness_sums_detail_0_q + {11'h0, select_1768_s24_q});
  logic [23:0] select_1782;
  assign select_1782 = equal_1739_s24_q ? {11'h0, select_1780_s24_q} : (sharpness_sums_detail_1_q + {11'h0, select_1780_s24_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_1805;
  assign select_1805 = (less_1793_s24_q & and_1803_s24_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_1815;
  assign select_1815 = (less_1793_s24_q & and_1813_s24_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:200
  logic [1:0] select_1824;
  assign select_1824 = equal_1792_s24_q ? {sharpness_comparing_contrast_0_q[0], and_1813_s24_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_1826;
  assign select_1826 = equal_1792_s24_q ? {sharpness_comparing_contrast_1_q[0], and_1803_s24_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_1849;
  assign xor_1849 = sharpness_comparing_contrast_0_q[1] ^ and_1803_s24_q;
  logic select_1852;
  assign select_1852 = (equal_1836_s24_q | xor_1849) ? (and_1803_s24_q & xor_1849) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:200
  logic select_1853;
  assign select_1853 = equal_1792_s24_q ? select_1852 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_1855;
  assign xor_1855 = sharpness_comparing_contrast_1_q[1] ^ and_1813_s24_q;
  logic select_1858;
  assign select_1858 = (equal_1836_s24_q | xor_1855) ? (and_1813_s24_q & xor_1855) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:200
  logic select_1859;
  assign select_1859 = equal_1792_s24_q ? select_1858 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2000;
  assign select_2000 = and_1979_s24_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1998_s24_q});
  // hls/stages/agreement.hpp:1060
  logic not_2019;
  assign not_2019 = ~(equal_1538_s24_q ? and_1559 : not_2017_s24_q);
  // hls/stages/agreement.hpp:392
  logic and_2022;
  assign and_2022 = ends_cell_s24_q & (not_2002_s24_q & (centres_values_1_textured_s24_q & not_2019));
  // hls/stages/agreement.hpp:1091
  logic [9:0] select_2035;
  assign select_2035 = ((~(select_2028_s24_q[9:4] == 6'h0)) & less_2033_s24_q) ? select_2028_s24_q : 10'h0;
  // hls/stages/agreement.hpp:392
  logic [9:0] select_2038;
  assign select_2038 = equal_1338_s24_q ? (x_s24_q[6] ? (equal_1383_s24_q ? 10'h0 : select_2035) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1064
  logic and_2056;
  assign and_2056 = centres_values_1_textured_s24_q & (centres_values_1_of_skin_s24_q & not_2019);
  // hls/stages/registration.hpp:106
  logic [7:0] select_2142;
  assign select_2142 = equal_2087_s24_q ? (and_2116_s24_q ? residual_s24_q : 8'h0) : 8'h0;
  logic and_2153;
  assign and_2153 = and_2116_s24_q & ($signed(residual_s24_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:200
  logic less_2167;
  assign less_2167 = $signed(residual_s24_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2220;
  assign select_2220 = or_1415_s24_q ? 12'h0 : (equal_2218_s24_q ? registration_sums_rdata_s24_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2222;
  assign select_2222 = equal_1383_s24_q ? 12'h0 : (less_1411_s24_q ? select_2220 : 12'h0);
  // hls/stages/registration.hpp:152
  logic and_2225;
  assign and_2225 = x_s24_q[1] & all_s24_q;
  // hls/stages/agreement.hpp:1095
  logic and_2228;
  assign and_2228 = not_1457_s24_q & (less_1411_s24_q & ({and_2225, x_s24_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2235;
  assign select_2235 = or_1415_s24_q ? 12'h0 : (equal_2218_s24_q ? registration_sums_rdata_s24_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2237;
  assign select_2237 = equal_1383_s24_q ? 12'h0 : (less_1411_s24_q ? select_2235 : 12'h0);
  // hls/stages/registration.hpp:149
  logic not_2243;
  assign not_2243 = ~all_s24_q;
  // hls/stages/agreement.hpp:1095
  logic and_2246;
  assign and_2246 = not_1457_s24_q & (less_1411_s24_q & (x_s24_q[2:0] == {all_s24_q, not_2243, 1'b0}));
  // hls/stages/agreement.hpp:392
  logic and_2252;
  assign and_2252 = equal_1338_s24_q & (x_s24_q[6] & (not_1457_s24_q & (less_1411_s24_q & all_s24_q)));
  // hls/stages/registration.hpp:156
  logic equal_2279;
  assign equal_2279 = x_s24_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1095
  logic and_2282;
  assign and_2282 = not_1457_s24_q & (less_1411_s24_q & (x_s24_q[5] ? x_s24_q[3] : equal_2279));
  logic and_2291;
  assign and_2291 = not_1457_s24_q & (less_1411_s24_q & ((~x_s24_q[5]) & (x_s24_q[3] & equal_2279)));
  // hls/stages/agreement.hpp:392
  logic select_2381;
  assign select_2381 = equal_1338_s24_q ? ((x_s24_q[6] & good_known_q) | equal_2379_s24_q) : good_known_q;
  // hls/stages/agreement.hpp:1240
  logic and_2543;
  assign and_2543 = and_1599_s24_q & ({sum_1524_s24_q, index_2_s24_q} == {sum_1511_s24_q, index_s24_q});
  // hls/stages/agreement.hpp:1093
  logic [31:0] select_2600;
  assign select_2600 = equal_1403_s24_q ? {2'h0, counts_explained_s24_q, 2'h0, counts_textured_s24_q} : (equal_2598_s24_q ? registration_sums_rdata_s24_q : 32'h0);
  logic [31:0] select_2601;
  assign select_2601 = equal_1401_s24_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s24_q} : select_2600;

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1333; read in stage 24, written in stage 25: 24 < 25 < 24 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1511_s24_q, index_s24_q};
  logic map_re;
  assign map_re = s24_en & (and_1518_s24_q & less_1519_s24_q);
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
      sharpness_sums_detail_0_q <= and_369_s24_q ? select_1770 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_369_s24_q ? select_1782 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_1824 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_1826 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_1853 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_1859 : sharpness_comparing_less_contrast_1_q;
      counts_nearer_q <= select_2000;
      good_known_q <= select_2381;
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
      census_changes_values_2_left_q <= select_1736;
      census_changes_values_2_right_q <= select_1737;
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
  logic and_369_s25_q;
  logic so_s25_q;
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
  logic less_426_s25_q;
  logic and_434_s25_q;
  logic and_459_s25_q;
  logic and_460_s25_q;
  logic [8:0] sum_482_s25_q;
  logic equal_1338_s25_q;
  logic not_1339_s25_q;
  logic equal_1383_s25_q;
  logic [1:0] sum_1389_s25_q;
  logic equal_1391_s25_q;
  logic equal_1393_s25_q;
  logic equal_1395_s25_q;
  logic equal_1397_s25_q;
  logic equal_1399_s25_q;
  logic less_1411_s25_q;
  logic [19:0] select_1436_s25_q;
  logic [11:0] select_1441_s25_q;
  logic and_1445_s25_q;
  logic not_1457_s25_q;
  logic and_1518_s25_q;
  logic less_1519_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1524_s25_q;
  logic is_seen_s25_q;
  logic and_1589_s25_q;
  logic and_1599_s25_q;
  logic equal_1739_s25_q;
  logic [8:0] sum_1742_s25_q;
  logic equal_1792_s25_q;
  logic less_1793_s25_q;
  logic [17:0] select_1805_s25_q;
  logic [17:0] select_1815_s25_q;
  logic equal_1836_s25_q;
  logic and_1979_s25_q;
  logic and_2024_s25_q;
  logic [9:0] select_2028_s25_q;
  logic [9:0] select_2031_s25_q;
  logic [9:0] select_2038_s25_q;
  logic and_2059_s25_q;
  logic equal_2087_s25_q;
  logic and_2114_s25_q;
  logic and_2116_s25_q;
  logic [7:0] select_2144_s25_q;
  logic and_2153_s25_q;
  logic and_2161_s25_q;
  logic and_2168_s25_q;
  logic and_2175_s25_q;
  logic [11:0] select_2222_s25_q;
  logic and_2230_s25_q;
  logic [11:0] select_2237_s25_q;
  logic and_2248_s25_q;
  logic and_2252_s25_q;
  logic and_2284_s25_q;
  logic and_2292_s25_q;
  logic or_2359_s25_q;
  logic equal_2362_s25_q;
  logic select_2368_s25_q;
  logic equal_2379_s25_q;
  logic equal_2382_s25_q;
  logic equal_2384_s25_q;
  logic equal_2385_s25_q;
  logic and_2528_s25_q;
  logic and_2543_s25_q;
  logic [31:0] select_2601_s25_q;
  logic [9:0] select_2607_s25_q;
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
      and_369_s25_q <= and_369_s24_q;
      so_s25_q <= drew_q;
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
      less_426_s25_q <= less_426_s24_q;
      and_434_s25_q <= and_434_s24_q;
      and_459_s25_q <= and_459_s24_q;
      and_460_s25_q <= and_460_s24_q;
      sum_482_s25_q <= sum_482[13:5];
      equal_1338_s25_q <= equal_1338_s24_q;
      not_1339_s25_q <= not_1339_s24_q;
      equal_1383_s25_q <= equal_1383_s24_q;
      sum_1389_s25_q <= sum_1389_s24_q;
      equal_1391_s25_q <= equal_1391_s24_q;
      equal_1393_s25_q <= equal_1393_s24_q;
      equal_1395_s25_q <= equal_1395_s24_q;
      equal_1397_s25_q <= equal_1397_s24_q;
      equal_1399_s25_q <= equal_1399_s24_q;
      less_1411_s25_q <= less_1411_s24_q;
      select_1436_s25_q <= equal_1435_s24_q ? registration_sums_rdata_s24_q[19:0] : 20'h0;
      select_1441_s25_q <= equal_1435_s24_q ? registration_sums_rdata_s24_q[31:20] : 12'h0;
      and_1445_s25_q <= and_1445_s24_q;
      not_1457_s25_q <= not_1457_s24_q;
      and_1518_s25_q <= and_1518_s24_q;
      less_1519_s25_q <= less_1519_s24_q;
      index_2_s25_q <= index_2_s24_q;
      sum_1524_s25_q <= sum_1524_s24_q;
      is_seen_s25_q <= is_seen;
      and_1589_s25_q <= is_seen & less_1588_s24_q;
      and_1599_s25_q <= and_1599_s24_q;
      equal_1739_s25_q <= equal_1739_s24_q;
      sum_1742_s25_q <= sum_1742[13:5];
      equal_1792_s25_q <= equal_1792_s24_q;
      less_1793_s25_q <= less_1793_s24_q;
      select_1805_s25_q <= select_1805;
      select_1815_s25_q <= select_1815;
      equal_1836_s25_q <= equal_1836_s24_q;
      and_1979_s25_q <= and_1979_s24_q;
      and_2024_s25_q <= not_1339_s24_q & (drew_q & and_2022);
      select_2028_s25_q <= select_2028_s24_q;
      select_2031_s25_q <= select_2031_s24_q;
      select_2038_s25_q <= select_2038;
      and_2059_s25_q <= drew_q & (ends_cell_s24_q & (not_2002_s24_q & and_2056));
      equal_2087_s25_q <= equal_2087_s24_q;
      and_2114_s25_q <= and_2114_s24_q;
      and_2116_s25_q <= and_2116_s24_q;
      select_2144_s25_q <= equal_1338_s24_q ? 8'h0 : (drew_q ? select_2142 : 8'h0);
      and_2153_s25_q <= and_2153;
      and_2161_s25_q <= and_2116_s24_q & less_2160_s24_q;
      and_2168_s25_q <= and_2116_s24_q & less_2167;
      and_2175_s25_q <= and_2116_s24_q & less_2174_s24_q;
      select_2222_s25_q <= select_2222;
      and_2230_s25_q <= equal_1338_s24_q & (x_s24_q[6] & and_2228);
      select_2237_s25_q <= select_2237;
      and_2248_s25_q <= equal_1338_s24_q & (x_s24_q[6] & and_2246);
      and_2252_s25_q <= and_2252;
      and_2284_s25_q <= equal_1338_s24_q & (x_s24_q[6] & and_2282);
      and_2292_s25_q <= x_s24_q[6] & and_2291;
      or_2359_s25_q <= or_2359_s24_q;
      equal_2362_s25_q <= equal_2362_s24_q;
      select_2368_s25_q <= select_2368_s24_q;
      equal_2379_s25_q <= equal_2379_s24_q;
      equal_2382_s25_q <= equal_2382_s24_q;
      equal_2384_s25_q <= equal_2384_s24_q;
      equal_2385_s25_q <= equal_2385_s24_q;
      and_2528_s25_q <= said_q;
      and_2543_s25_q <= and_2543;
      select_2601_s25_q <= select_2601;
      select_2607_s25_q <= select_2607_s24_q;
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
  logic equal_1437;
  assign equal_1437 = sum_1389_s25_q == 2'h0;
  // hls/stages/registration.hpp:258
  logic [6:0] down;
  assign down = sum_1389_s25_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:260
  logic [13:0] select_1439;
  assign select_1439 = equal_1437 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:259
  logic [6:0] up;
  assign up = sum_1389_s25_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:261
  logic [6:0] select_1443;
  assign select_1443 = equal_1437 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1805_s25_q};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_1808;
  assign select_1808 = equal_1792_s25_q ? (less_1793_s25_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1815_s25_q};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_1818;
  assign select_1818 = equal_1792_s25_q ? (less_1793_s25_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2026;
  assign select_2026 = and_1979_s25_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2024_s25_q});
  logic [13:0] select_2040;
  assign select_2040 = and_1979_s25_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2038_s25_q});
  // hls/stages/agreement.hpp:392
  logic and_2060;
  assign and_2060 = not_1339_s25_q & and_2059_s25_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2062;
  assign select_2062 = and_1979_s25_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2060});
  // hls/stages/registration.hpp:132
  logic [13:0] sum_2145;
  assign sum_2145 = registration_half_across_q + {{6{select_2144_s25_q[7]}}, select_2144_s25_q};
  // hls/stages/agreement.hpp:392
  logic and_2149;
  assign and_2149 = not_1339_s25_q & (so_s25_q & (and_2116_s25_q & equal_2087_s25_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2151;
  assign select_2151 = and_2114_s25_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2149});
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2155;
  assign select_2155 = so_s25_q ? (equal_2087_s25_q ? {and_2153_s25_q, and_2116_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2156;
  assign select_2156 = equal_1338_s25_q ? 2'h0 : select_2155;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2157;
  assign sum_2157 = registration_half_votes_down_q + {{5{select_2156[1]}}, select_2156};
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2163;
  assign select_2163 = so_s25_q ? (equal_2087_s25_q ? {and_2161_s25_q, and_2116_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2164;
  assign select_2164 = equal_1338_s25_q ? 2'h0 : select_2163;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2165;
  assign sum_2165 = registration_half_votes_up_q + {{5{select_2164[1]}}, select_2164};
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2170;
  assign select_2170 = so_s25_q ? (equal_2087_s25_q ? {and_2168_s25_q, and_2116_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2171;
  assign select_2171 = equal_1338_s25_q ? 2'h0 : select_2170;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2172;
  assign sum_2172 = registration_half_half_votes_down_q + {{5{select_2171[1]}}, select_2171};
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2177;
  assign select_2177 = so_s25_q ? (equal_2087_s25_q ? {and_2175_s25_q, and_2116_s25_q} : 2'h0) : 2'h0;
  logic [1:0] select_2178;
  assign select_2178 = equal_1338_s25_q ? 2'h0 : select_2177;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2179;
  assign sum_2179 = registration_half_half_votes_up_q + {{5{select_2178[1]}}, select_2178};
  // hls/stages/agreement.hpp:392
  logic and_2213;
  assign and_2213 = equal_1338_s25_q & (x_s25_q[6] & (not_1457_s25_q & less_1411_s25_q));
  logic [11:0] select_2224;
  assign select_2224 = equal_1338_s25_q ? (x_s25_q[6] ? select_2222_s25_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:247
  logic [13:0] sum_2232;
  assign sum_2232 = {{2{select_2224[11]}}, select_2224} + (and_2230_s25_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2239;
  assign select_2239 = equal_1338_s25_q ? (x_s25_q[6] ? select_2237_s25_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:248
  logic [13:0] sum_2241;
  assign sum_2241 = {{2{select_2239[11]}}, select_2239} + (and_2230_s25_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:241
  logic not_2253;
  assign not_2253 = ~and_2252_s25_q;
  logic less_2254;
  assign less_2254 = $signed({9'h1, {2{not_2253}}, and_2252_s25_q}) < $signed(registration_up_q[13:2]);
  logic select_2255;
  assign select_2255 = and_2248_s25_q ? less_2254 : registration_enough_q;
  // hls/stages/agreement.hpp:1095
  logic and_2259;
  assign and_2259 = x_s25_q[6] & (not_1457_s25_q & (less_1411_s25_q & (x_s25_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:392
  logic and_2260;
  assign and_2260 = equal_1338_s25_q & and_2259;
  // hls/stages/registration.hpp:237
  logic less_2261;
  assign less_2261 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2263;
  assign less_2263 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1095
  logic and_2268;
  assign and_2268 = x_s25_q[6] & (not_1457_s25_q & (less_1411_s25_q & (x_s25_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:392
  logic and_2269;
  assign and_2269 = equal_1338_s25_q & and_2268;
  // hls/stages/agreement.hpp:1095
  logic and_2276;
  assign and_2276 = x_s25_q[6] & (not_1457_s25_q & (less_1411_s25_q & (x_s25_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:239
  logic and_2294;
  assign and_2294 = registration_votes_up_q & registration_other_down_q;
  logic select_2296;
  assign select_2296 = registration_votes_down_q ? (registration_other_up_q | and_2294) : and_2294;
  // hls/stages/registration.hpp:137
  logic and_2298;
  assign and_2298 = (equal_1338_s25_q & and_2292_s25_q) & (registration_other_enough_q & select_2296);
  logic and_2300;
  assign and_2300 = registration_enough_q & ((and_2284_s25_q & (less_2263 | less_2261)) | and_2298);
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2387;
  assign select_2387 = equal_2384_s25_q ? counts_skin_unproven_q : (equal_2385_s25_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2382_s25_q ? counts_nearer_s25_q : select_2387;
  // hls/stages/agreement.hpp:392
  logic and_2558;
  assign and_2558 = equal_1338_s25_q & (equal_2379_s25_q & (cfg_prove_i & (~proven_q)));
  logic and_2592;
  assign and_2592 = equal_1338_s25_q & (x_s25_q[6] & (not_1457_s25_q | (4'hc < x_s25_q[5:2])));
  // hls/stages/agreement.hpp:1093
  logic [31:0] select_2602;
  assign select_2602 = equal_1399_s25_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_2601_s25_q;
  logic [31:0] select_2603;
  assign select_2603 = equal_1397_s25_q ? {8'h0, sharpness_sums_detail_0_s25_q} : select_2602;
  logic [31:0] select_2604;
  assign select_2604 = equal_1395_s25_q ? {8'h0, sharpness_sums_detail_1_s25_q} : select_2603;
  logic [31:0] select_2605;
  assign select_2605 = equal_1393_s25_q ? {8'h0, sharpness_sums_contrast_0_s25_q} : select_2604;
  logic [31:0] select_2606;
  assign select_2606 = equal_1391_s25_q ? {8'h0, sharpness_sums_contrast_1_s25_q} : select_2605;

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1524_s25_q, index_2_s25_q};
  logic map_we;
  assign map_we = s25_en & and_1599_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1589_s25_q, is_seen_s25_q};
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
      sharpness_comparing_rest_0_q <= so_s25_q ? select_1808 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s25_q ? select_1818 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2026;
      counts_regions_bad_q <= select_2040;
      counts_skin_unproven_q <= select_2062;
      registration_half_across_q <= and_2114_s25_q ? 14'h0 : sum_2145;
      registration_half_measured_q <= select_2151;
      registration_half_votes_down_q <= and_2114_s25_q ? 7'h0 : sum_2157;
      registration_half_votes_up_q <= and_2114_s25_q ? 7'h0 : sum_2165;
      registration_half_half_votes_down_q <= and_2114_s25_q ? 7'h0 : sum_2172;
      registration_half_half_votes_up_q <= and_2114_s25_q ? 7'h0 : sum_2179;
      registration_down_q <= and_2213 ? sum_2232 : registration_down_q;
      registration_up_q <= and_2213 ? sum_2241 : registration_up_q;
      registration_enough_q <= select_2255;
      registration_votes_down_q <= and_2260 ? less_2261 : registration_votes_down_q;
      registration_votes_up_q <= and_2260 ? less_2263 : registration_votes_up_q;
      registration_other_enough_q <= and_2269 ? select_2255 : registration_other_enough_q;
      registration_other_down_q <= and_2269 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2269 ? registration_votes_up_q : registration_other_up_q;
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
  logic and_369_s26_q;
  logic so_s26_q;
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
  logic less_426_s26_q;
  logic and_434_s26_q;
  logic and_459_s26_q;
  logic and_460_s26_q;
  logic less_483_s26_q;
  logic equal_1338_s26_q;
  logic equal_1383_s26_q;
  logic [1:0] sum_1389_s26_q;
  logic [19:0] sum_1440_s26_q;
  logic [11:0] sum_1444_s26_q;
  logic and_1445_s26_q;
  logic and_1518_s26_q;
  logic less_1519_s26_q;
  logic [1:0] map_rdata_s26_q;
  logic is_seen_s26_q;
  logic and_1589_s26_q;
  logic equal_1739_s26_q;
  logic and_1744_s26_q;
  logic equal_1792_s26_q;
  logic sum_s26_q;
  logic sum_2_s26_q;
  logic equal_1836_s26_q;
  logic select_1854_s26_q;
  logic select_1860_s26_q;
  logic [9:0] select_2028_s26_q;
  logic [9:0] select_2031_s26_q;
  logic not_2278_s26_q;
  logic and_2300_s26_q;
  logic or_2359_s26_q;
  logic equal_2362_s26_q;
  logic select_2368_s26_q;
  logic equal_2379_s26_q;
  logic and_2383_s26_q;
  logic [13:0] before_v_4_s26_q;
  logic not_2420_s26_q;
  logic or_2424_s26_q;
  logic and_2528_s26_q;
  logic and_2543_s26_q;
  logic and_2558_s26_q;
  logic and_2592_s26_q;
  logic [5:0] select_2594_s26_q;
  logic [31:0] select_2606_s26_q;
  logic [9:0] select_2607_s26_q;
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
      and_369_s26_q <= and_369_s25_q;
      so_s26_q <= so_s25_q;
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
      less_426_s26_q <= less_426_s25_q;
      and_434_s26_q <= and_434_s25_q;
      and_459_s26_q <= and_459_s25_q;
      and_460_s26_q <= and_460_s25_q;
      less_483_s26_q <= 9'h4 < sum_482_s25_q;
      equal_1338_s26_q <= equal_1338_s25_q;
      equal_1383_s26_q <= equal_1383_s25_q;
      sum_1389_s26_q <= sum_1389_s25_q;
      sum_1440_s26_q <= select_1436_s25_q + {{6{select_1439[13]}}, select_1439};
      sum_1444_s26_q <= select_1441_s25_q + {{5{select_1443[6]}}, select_1443};
      and_1445_s26_q <= and_1445_s25_q;
      and_1518_s26_q <= and_1518_s25_q;
      less_1519_s26_q <= less_1519_s25_q;
      map_rdata_s26_q <= map_rdata_q;
      is_seen_s26_q <= is_seen_s25_q;
      and_1589_s26_q <= and_1589_s25_q;
      equal_1739_s26_q <= equal_1739_s25_q;
      and_1744_s26_q <= and_459_s25_q & (9'h4 < sum_1742_s25_q);
      equal_1792_s26_q <= equal_1792_s25_q;
      sum_s26_q <= sum[0];
      sum_2_s26_q <= sum_2[0];
      equal_1836_s26_q <= equal_1836_s25_q;
      select_1854_s26_q <= sharpness_comparing_less_contrast_0_q;
      select_1860_s26_q <= sharpness_comparing_less_contrast_1_q;
      select_2028_s26_q <= select_2028_s25_q;
      select_2031_s26_q <= select_2031_s25_q;
      not_2278_s26_q <= ~(equal_1338_s25_q & and_2276);
      and_2300_s26_q <= and_2300;
      or_2359_s26_q <= or_2359_s25_q;
      equal_2362_s26_q <= equal_2362_s25_q;
      select_2368_s26_q <= select_2368_s25_q;
      equal_2379_s26_q <= equal_2379_s25_q;
      and_2383_s26_q <= equal_2382_s25_q & equal_2362_s25_q;
      before_v_4_s26_q <= before_v_4;
      not_2420_s26_q <= ~(equal_2385_s25_q & equal_2362_s25_q);
      or_2424_s26_q <= (equal_2385_s25_q | equal_2384_s25_q) | (x_s25_q[6:3] == 4'hf);
      and_2528_s26_q <= and_2528_s25_q;
      and_2543_s26_q <= and_2543_s25_q;
      and_2558_s26_q <= and_2558;
      and_2592_s26_q <= and_2592;
      select_2594_s26_q <= equal_1338_s25_q ? (x_s25_q[6] ? x_s25_q[5:0] : 6'h0) : 6'h0;
      select_2606_s26_q <= select_2606;
      select_2607_s26_q <= select_2607_s25_q;
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
  logic and_484;
  assign and_484 = and_434_s26_q & less_483_s26_q;
  // hls/stages/census.hpp:306
  logic and_1745;
  assign and_1745 = and_459_s26_q & less_483_s26_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_1746;
  assign sum_1746 = census_left_misses_q + {{17{and_1745}}, and_1744_s26_q, 1'b0, and_1744_s26_q};
  // hls/stages/agreement.hpp:495
  logic [19:0] select_1748;
  assign select_1748 = and_369_s26_q ? (equal_1739_s26_q ? 20'h0 : sum_1746) : census_left_misses_q;
  // hls/stages/agreement.hpp:200
  logic [2:0] select_1820;
  assign select_1820 = equal_1792_s26_q ? {sharpness_comparing_product_0_q[1:0], sum_s26_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_1822;
  assign select_1822 = equal_1792_s26_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s26_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s26_q});
  // hls/stages/agreement.hpp:200
  logic select_1831;
  assign select_1831 = so_s26_q ? (equal_1792_s26_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s26_q});
  // hls/stages/agreement.hpp:200
  logic select_1834;
  assign select_1834 = equal_1792_s26_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_1837;
  assign xor_1837 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_1843;
  assign xor_1843 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/agreement.hpp:1159
  logic [14:0] over;
  assign over = {1'b0, product_s26_q} - {1'b0, before_v_4_s26_q};
  // hls/stages/agreement.hpp:1167
  logic select_2390;
  assign select_2390 = and_2383_s26_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1240
  logic [1:0] select_2544;
  assign select_2544 = and_2543_s26_q ? {and_1589_s26_q, is_seen_s26_q} : map_rdata_s26_q;
  // hls/stages/agreement.hpp:1241
  logic and_2545;
  assign and_2545 = proven_q & less_2533;
  // hls/stages/agreement.hpp:392
  logic and_2570;
  assign and_2570 = equal_1338_s26_q & (equal_2379_s26_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:1098
  logic or_2572;
  assign or_2572 = select_1854_s26_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_2608;
  assign select_2608 = equal_1383_s26_q ? select_2606_s26_q : {2'h0, select_2607_s26_q, select_2031_s26_q, select_2028_s26_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s26_q;
  logic fresh_we;
  assign fresh_we = s26_en & and_369_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s26_q, and_484, and_460_s26_q, and_459_s26_q, and_434_s26_q, less_426_s26_q, less_425_s26_q, less_424_s26_q, less_423_s26_q, less_422_s26_q, less_421_s26_q, less_420_s26_q, less_419_s26_q, less_418_s26_q, less_417_s26_q, less_416_s26_q, less_415_s26_q, less_414_s26_q, less_413_s26_q, less_412_s26_q, less_411_s26_q, less_410_s26_q, less_409_s26_q, less_408_s26_q, less_407_s26_q, less_406_s26_q, less_405_s26_q, less_404_s26_q, less_403_s26_q};
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
  assign registration_sums_waddr = {sum_1389_s26_q, lower_half_s26_q, registration_of_right_s26_q};
  logic registration_sums_we;
  assign registration_sums_we = s26_en & and_1445_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1444_s26_q, sum_1440_s26_q};
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
      census_left_misses_q <= select_1748;
      sharpness_comparing_product_0_q <= so_s26_q ? select_1820 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s26_q ? select_1822 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_1831;
      sharpness_comparing_carry_1_q <= so_s26_q ? select_1834 : sharpness_comparing_carry_1_q;
      registration_moved_q <= not_2278_s26_q & (registration_moved_q | and_2300_s26_q);
      hides_q <= equal_1338_s26_q ? select_2390 : hides_q;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic so_s27_q;
  logic equal_1338_s27_q;
  logic and_1518_s27_q;
  logic less_1519_s27_q;
  logic equal_1792_s27_q;
  logic or_1838_s27_q;
  logic and_1839_s27_q;
  logic or_1844_s27_q;
  logic and_1845_s27_q;
  logic select_1860_s27_q;
  logic or_2359_s27_q;
  logic select_2368_s27_q;
  logic equal_2379_s27_q;
  logic select_2390_s27_q;
  logic and_2418_s27_q;
  logic not_2420_s27_q;
  logic or_2424_s27_q;
  logic and_2528_s27_q;
  logic and_2546_s27_q;
  logic and_2549_s27_q;
  logic and_2558_s27_q;
  logic and_2570_s27_q;
  logic or_2572_s27_q;
  logic and_2592_s27_q;
  logic [5:0] select_2594_s27_q;
  logic [31:0] select_2610_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      so_s27_q <= so_s26_q;
      equal_1338_s27_q <= equal_1338_s26_q;
      and_1518_s27_q <= and_1518_s26_q;
      less_1519_s27_q <= less_1519_s26_q;
      equal_1792_s27_q <= equal_1792_s26_q;
      or_1838_s27_q <= equal_1836_s26_q | xor_1837;
      and_1839_s27_q <= five_times[0] & xor_1837;
      or_1844_s27_q <= equal_1836_s26_q | xor_1843;
      and_1845_s27_q <= five_times_2[0] & xor_1843;
      select_1860_s27_q <= select_1860_s26_q;
      or_2359_s27_q <= or_2359_s26_q;
      select_2368_s27_q <= select_2368_s26_q;
      equal_2379_s27_q <= equal_2379_s26_q;
      select_2390_s27_q <= select_2390;
      and_2418_s27_q <= over[14] & equal_2362_s26_q;
      not_2420_s27_q <= not_2420_s26_q;
      or_2424_s27_q <= or_2424_s26_q;
      and_2528_s27_q <= and_2528_s26_q;
      and_2546_s27_q <= select_2544[0] & and_2545;
      and_2549_s27_q <= select_2544[1] & and_2545;
      and_2558_s27_q <= and_2558_s26_q;
      and_2570_s27_q <= and_2570;
      or_2572_s27_q <= or_2572;
      and_2592_s27_q <= and_2592_s26_q;
      select_2594_s27_q <= select_2594_s26_q;
      select_2610_s27_q <= equal_1338_s26_q ? (x_s26_q ? select_2608 : 32'h0) : 32'h0;
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
  logic select_1840;
  assign select_1840 = or_1838_s27_q ? and_1839_s27_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:200
  logic select_1841;
  assign select_1841 = equal_1792_s27_q ? select_1840 : sharpness_comparing_less_detail_0_q;
  logic select_1842;
  assign select_1842 = so_s27_q ? select_1841 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_1846;
  assign select_1846 = or_1844_s27_q ? and_1845_s27_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:200
  logic select_1847;
  assign select_1847 = equal_1792_s27_q ? select_1846 : sharpness_comparing_less_detail_1_q;
  logic select_1848;
  assign select_1848 = so_s27_q ? select_1847 : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:1096
  logic not_2391;
  assign not_2391 = ~hidden_for_q[7];
  logic [7:0] select_2393;
  assign select_2393 = select_2390_s27_q ? (hidden_for_q + {7'h0, not_2391}) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2395;
  assign select_2395 = equal_1338_s27_q ? (equal_2379_s27_q ? select_2393 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1165
  logic and_2421;
  assign and_2421 = too_much_q & not_2420_s27_q;
  // hls/stages/agreement.hpp:1166
  logic select_2426;
  assign select_2426 = and_2418_s27_q ? (and_2421 | or_2424_s27_q) : and_2421;
  // hls/stages/agreement.hpp:413
  logic select_2548;
  assign select_2548 = and_1518_s27_q ? (less_1519_s27_q ? and_2546_s27_q : seen_q) : seen_q;
  logic select_2551;
  assign select_2551 = and_1518_s27_q ? (less_1519_s27_q ? and_2549_s27_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:392
  logic and_2561;
  assign and_2561 = equal_1338_s27_q & (equal_2379_s27_q & (cfg_prove_i & or_2359_s27_q));
  // hls/stages/agreement.hpp:1176
  logic not_2563;
  assign not_2563 = ~(or_2359_s27_q | not_2552);
  // hls/stages/agreement.hpp:392
  logic and_2566;
  assign and_2566 = equal_2379_s27_q & (not_2563 & (select_2368_s27_q | select_2426));
  logic and_2579;
  assign and_2579 = equal_2379_s27_q & (not_2563 & (select_1848 | select_1860_s27_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s27_en) begin
      sharpness_comparing_less_detail_0_q <= select_1842;
      sharpness_comparing_less_detail_1_q <= select_1848;
      hidden_for_q <= select_2395;
      too_much_q <= equal_1338_s27_q ? select_2426 : too_much_q;
      seen_q <= select_2548;
      nearer_q <= select_2551;
    end
  end

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic equal_1338_s28_q;
  logic equal_2379_s28_q;
  logic and_2528_s28_q;
  logic and_2558_s28_q;
  logic and_2561_s28_q;
  logic and_2567_s28_q;
  logic and_2570_s28_q;
  logic and_2575_s28_q;
  logic and_2579_s28_q;
  logic not_2584_s28_q;
  logic and_2592_s28_q;
  logic [5:0] select_2594_s28_q;
  logic [31:0] select_2610_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      equal_1338_s28_q <= equal_1338_s27_q;
      equal_2379_s28_q <= equal_2379_s27_q;
      and_2528_s28_q <= and_2528_s27_q;
      and_2558_s28_q <= and_2558_s27_q;
      and_2561_s28_q <= and_2561;
      and_2567_s28_q <= equal_1338_s27_q & and_2566;
      and_2570_s28_q <= and_2570_s27_q;
      and_2575_s28_q <= equal_2379_s27_q & (not_2563 & (select_1842 | or_2572_s27_q));
      and_2579_s28_q <= and_2579;
      not_2584_s28_q <= ~(select_2393 < cfg_hidden_frames_i);
      and_2592_s28_q <= and_2592_s27_q;
      select_2594_s28_q <= select_2594_s27_q;
      select_2610_s28_q <= select_2610_s27_q;
    end
  end

  // Stage 28 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:1098
  logic and_2586;
  assign and_2586 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_2584_s28_q);

  logic [7:0] pixel_0_s29_q;
  logic [7:0] pixel_1_s29_q;
  logic saturated_s29_q;
  logic mask_s29_q;
  logic marks_first_s29_q;
  logic marks_last_s29_q;
  logic and_2528_s29_q;
  logic or_2553_s29_q;
  logic and_2554_s29_q;
  logic and_2558_s29_q;
  logic and_2561_s29_q;
  logic and_2567_s29_q;
  logic and_2570_s29_q;
  logic and_2576_s29_q;
  logic and_2580_s29_q;
  logic and_2588_s29_q;
  logic and_2592_s29_q;
  logic [5:0] select_2594_s29_q;
  logic [31:0] select_2610_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      and_2528_s29_q <= and_2528_s28_q;
      or_2553_s29_q <= not_2552 | seen_q;
      and_2554_s29_q <= cfg_prove_i & nearer_q;
      and_2558_s29_q <= and_2558_s28_q;
      and_2561_s29_q <= and_2561_s28_q;
      and_2567_s29_q <= and_2567_s28_q;
      and_2570_s29_q <= and_2570_s28_q;
      and_2576_s29_q <= equal_1338_s28_q & and_2575_s28_q;
      and_2580_s29_q <= equal_1338_s28_q & and_2579_s28_q;
      and_2588_s29_q <= equal_1338_s28_q & (equal_2379_s28_q & and_2586);
      and_2592_s29_q <= and_2592_s28_q;
      select_2594_s29_q <= select_2594_s28_q;
      select_2610_s29_q <= select_2610_s28_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s29_q;
  assign pixel_1_o = pixel_1_s29_q;
  assign saturated_o = saturated_s29_q;
  assign mask_o = mask_s29_q;
  assign marks_first_o = marks_first_s29_q;
  assign marks_last_o = marks_last_s29_q;
  assign marks_seen_o = or_2553_s29_q;
  assign marks_nearer_o = and_2554_s29_q;
  assign verdict_valid_o = and_2528_s29_q;
  assign verdict_unproven_yet_o = and_2558_s29_q;
  assign verdict_untextured_o = and_2561_s29_q;
  assign verdict_disagree_o = and_2567_s29_q;
  assign verdict_moved_o = and_2570_s29_q;
  assign verdict_unsharp_left_o = and_2576_s29_q;
  assign verdict_unsharp_right_o = and_2580_s29_q;
  assign verdict_hidden_o = and_2588_s29_q;
  assign frame_valid_o = and_2592_s29_q;
  assign frame_index_o = select_2594_s29_q;
  assign frame_word_o = select_2610_s29_q;
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
  assign unused_bits = ^{over[13:0], sum_2131[0], sum_2127[0], sum_2102[1:0], sum_2101[1:0], sum_2097[0], sum_2084[0], detail_4[1:0], detail_3[1:0], sum_1742[4:0], sum_482[4:0], cfg_width_i[3:0]};

endmodule
