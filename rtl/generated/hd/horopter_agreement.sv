// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 30 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2955 bits, pipeline 8744 bits, memories 120207 bits.
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
  logic [6:0] sum_2380;
  assign sum_2380 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3394;
  assign difference_3394 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [7:0] difference_3642;
  assign difference_3642 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_3844;
  assign less_3844 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_3845;
  assign sum_3845 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_3863;
  assign not_3863 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_474;
  assign select_474 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_474 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_474_s1_q;
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
      select_474_s1_q <= select_474;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:35
  logic [6:0] select_477;
  assign select_477 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:50
  logic equal_509;
  assign equal_509 = select_474_s1_q == 4'hf;
  // hls/stages/agreement.hpp:264
  logic [6:0] select_2029;
  assign select_2029 = sample_pair_whole_s1_q ? (select_477 + {6'h0, equal_509}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2029;
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
  logic [3:0] select_474_s2_q;
  logic [6:0] select_477_s2_q;
  logic equal_509_s2_q;
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
      select_474_s2_q <= select_474_s1_q;
      select_477_s2_q <= select_477;
      equal_509_s2_q <= equal_509;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:109
  logic equal_475;
  assign equal_475 = select_474_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:115
  logic [8:0] select_480;
  assign select_480 = ({select_477_s2_q, select_474_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_481;
  assign select_481 = equal_475 ? select_480 : averager_place_q;
  // hls/stages/census.hpp:41
  logic [3:0] select_492;
  assign select_492 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_2027;
  assign select_2027 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_492 + 4'h1) : select_492) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2027;
      averager_place_q <= sample_pair_whole_s2_q ? select_481 : averager_place_q;
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
  logic [3:0] select_474_s3_q;
  logic equal_475_s3_q;
  logic [6:0] select_477_s3_q;
  logic [8:0] select_481_s3_q;
  logic equal_483_s3_q;
  logic [3:0] select_492_s3_q;
  logic equal_509_s3_q;
  logic equal_510_s3_q;
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
      select_474_s3_q <= select_474_s2_q;
      equal_475_s3_q <= equal_475;
      select_477_s3_q <= select_477_s2_q;
      select_481_s3_q <= select_481;
      equal_483_s3_q <= select_474_s2_q[1:0] == 2'h3;
      select_492_s3_q <= select_492;
      equal_509_s3_q <= equal_509_s2_q;
      equal_510_s3_q <= select_492 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:41
  logic or_482;
  assign or_482 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:405
  logic and_487;
  assign and_487 = (or_482 & equal_483_s3_q) & (~(select_481_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:264
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_477_s3_q : 7'h0;
  // hls/stages/census.hpp:126
  logic and_511;
  assign and_511 = equal_510_s3_q & and_487;
  // hls/stages/agreement.hpp:264
  logic and_513;
  assign and_513 = sample_pair_whole_s3_q & (equal_509_s3_q & and_511);
  // hls/stages/census.hpp:41
  logic [6:0] select_572;
  assign select_572 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:264
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_572 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_2031;
  assign select_2031 = sample_last_s3_q ? (select_572 + {6'h0, equal_510_s3_q}) : select_572;
  // hls/stages/agreement.hpp:264
  logic select_2036;
  assign select_2036 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_482 & (~raster_final_row_q)) : or_482) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_2038;
  assign select_2038 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:264
  logic select_2042;
  assign select_2042 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:447
  logic equal_2286;
  assign equal_2286 = {last[7], column} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2031 : raster_at_row_q;
      raster_at_live_q <= select_2036;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2038 : raster_rows_left_q;
      raster_final_row_q <= select_2042;
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
  logic [3:0] select_474_s4_q;
  logic equal_475_s4_q;
  logic [6:0] select_477_s4_q;
  logic [8:0] select_481_s4_q;
  logic and_487_s4_q;
  logic [3:0] select_492_s4_q;
  logic [6:0] column_s4_q;
  logic and_511_s4_q;
  logic and_513_s4_q;
  logic [3:0] select_572_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1590_s4_q;
  logic equal_2286_s4_q;
  logic and_2287_s4_q;
  logic [7:0] sum_2376_s4_q;
  logic [2:0] or_2770_s4_q;
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
      select_474_s4_q <= select_474_s3_q;
      equal_475_s4_q <= equal_475_s3_q;
      select_477_s4_q <= select_477_s3_q;
      select_481_s4_q <= select_481_s3_q;
      and_487_s4_q <= and_487;
      select_492_s4_q <= select_492_s3_q;
      column_s4_q <= column;
      and_511_s4_q <= and_511;
      and_513_s4_q <= and_513;
      select_572_s4_q <= select_572[3:0];
      row_s4_q <= row;
      equal_1590_s4_q <= {or_482, select_492_s3_q} == 5'h18;
      equal_2286_s4_q <= equal_2286;
      and_2287_s4_q <= and_513 & equal_2286;
      sum_2376_s4_q <= {1'b0, row} + 8'h1;
      or_2770_s4_q <= select_477_s3_q[2:0] | select_572[6:4];
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
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:611
  logic equal_533;
  assign equal_533 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:602
  logic equal_536;
  assign equal_536 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:603
  logic equal_538;
  assign equal_538 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:511
  logic select_2290;
  assign select_2290 = (and_2287_s4_q | (~ends_cell_q)) ? and_2287_s4_q : ends_q;
  // hls/stages/agreement.hpp:517
  logic [2:0] now;
  assign now = select_2290 ? (and_2287_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:522
  logic [5:0] select_2294;
  assign select_2294 = select_2290 ? (and_2287_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2297;
  assign select_2297 = select_2290 ? (following_last_shift_q & (~and_2287_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:523
  logic [7:0] select_2299;
  assign select_2299 = select_2290 ? (and_2287_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:595
  logic and_2300;
  assign and_2300 = run_last_shift_q & equal_536;
  // hls/stages/agreement.hpp:604
  logic select_2302;
  assign select_2302 = equal_536 ? (~run_last_shift_q) : equal_538;
  // hls/stages/agreement.hpp:608
  logic equal_2303;
  assign equal_2303 = run_phase_q == 3'h1;
  logic not_2306;
  assign not_2306 = ~select_2302;
  // hls/stages/agreement.hpp:611
  logic equal_2308;
  assign equal_2308 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:595
  logic and_2309;
  assign and_2309 = final_row_q & so;
  // hls/stages/agreement.hpp:608
  logic [1:0] select_2310;
  assign select_2310 = equal_2308 ? 2'h1 : {2{and_2309}};
  logic [2:0] select_2312;
  assign select_2312 = (and_2300 | (select_2302 | equal_2303)) ? (equal_2303 ? 3'h2 : {not_2306, {2{select_2302}}}) : (equal_533 ? 3'h6 : {select_2310[0], select_2310});
  // hls/stages/agreement.hpp:595
  logic and_2315;
  assign and_2315 = select_2302 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:618
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2318;
  assign select_2318 = (plan_shift_q[5] & select_2302) ? value : 7'h0;
  logic [1:0] or_2319;
  assign or_2319 = {2{so}} | select_2318[5:4];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2323;
  assign or_2323 = (select_2302 ? plan_columns_q : 8'h0) | ((equal_2303 | equal_2308) ? whole_q : 8'h0);
  logic [1:0] or_2324;
  assign or_2324 = {2{and_2300}} | or_2323[4:3];
  // hls/stages/agreement.hpp:622
  logic [7:0] or_2326;
  assign or_2326 = {or_2323[7:5], or_2324, or_2323[2:0]} | (equal_533 ? drawn_q : 8'h0);
  logic [4:0] or_2327;
  assign or_2327 = {5{so}} | {or_2326[6], or_2326[3:0]};
  // hls/stages/agreement.hpp:628
  logic not_2331;
  assign not_2331 = ~run_shift_q[5];
  logic [7:0] select_2334;
  assign select_2334 = equal_536 ? ({{7{not_2331}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:511
  logic [6:0] select_2338;
  assign select_2338 = and_2287_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:514
  logic [7:0] select_2340;
  assign select_2340 = select_2290 ? {select_2338[6], select_2338} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2343;
  assign select_2343 = select_2290 ? (and_2287_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:448
  logic [6:0] select_2350;
  assign select_2350 = equal_2286_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:508
  logic [7:0] select_2354;
  assign select_2354 = and_513_s4_q ? (equal_2286_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2357;
  assign select_2357 = and_513_s4_q ? (equal_2286_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:519
  logic select_2371;
  assign select_2371 = (ends_cell_q | select_2290) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_536 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:514
  logic and_2375;
  assign and_2375 = (~select_2290) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:464
  logic equal_2377;
  assign equal_2377 = {sum_2376_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2376_s4_q[6:0]};
  // hls/stages/agreement.hpp:508
  logic select_2379;
  assign select_2379 = and_513_s4_q ? (equal_2286_s4_q ? equal_2377 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:361
  logic [8:0] sum_2771;
  assign sum_2771 = {1'b0, select_477_s4_q[3], or_2770_s4_q, select_572_s4_q} + 9'h1;

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
    end else if (s4_en) begin
      run_phase_q <= now;
      run_shift_q <= select_2294;
      run_last_shift_q <= select_2297;
      run_span_q <= select_2299;
      following_phase_q <= select_2312;
      following_shift_q <= select_2302 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2315;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2318[6], or_2319, select_2318[3:0]};
      following_columns_q <= {or_2326[7], or_2327[4], or_2326[5:4], or_2327[3:0]};
      plan_shift_q <= equal_536 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2334;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2340;
      columns_left_q <= select_2343;
      last_q <= and_513_s4_q ? (equal_2286_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_513_s4_q ? select_2350 : least_q;
      whole_q <= select_2354;
      drawn_q <= select_2357;
      slot_q <= select_2290 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2371;
      ends_q <= and_2375;
      final_row_q <= select_2379;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
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
  logic [3:0] select_474_s5_q;
  logic equal_475_s5_q;
  logic [6:0] select_477_s5_q;
  logic [8:0] select_481_s5_q;
  logic and_487_s5_q;
  logic equal_493_s5_q;
  logic [6:0] column_s5_q;
  logic and_511_s5_q;
  logic and_513_s5_q;
  logic so_s5_q;
  logic equal_533_s5_q;
  logic equal_536_s5_q;
  logic equal_538_s5_q;
  logic [7:0] sum_539_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_649_s5_q;
  logic equal_1471_s5_q;
  logic equal_1590_s5_q;
  logic equal_2286_s5_q;
  logic and_2287_s5_q;
  logic select_2290_s5_q;
  logic not_2773_s5_q;
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
      shift_first_s5_q <= shift_first_q;
      select_474_s5_q <= select_474_s4_q;
      equal_475_s5_q <= equal_475_s4_q;
      select_477_s5_q <= select_477_s4_q;
      select_481_s5_q <= select_481_s4_q;
      and_487_s5_q <= and_487_s4_q;
      equal_493_s5_q <= select_492_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_511_s5_q <= and_511_s4_q;
      and_513_s5_q <= and_513_s4_q;
      so_s5_q <= so;
      equal_533_s5_q <= equal_533;
      equal_536_s5_q <= equal_536;
      equal_538_s5_q <= equal_538;
      sum_539_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_649_s5_q <= {1'b0, last_q} + 8'h3;
      equal_1471_s5_q <= run_phase_q == 3'h7;
      equal_1590_s5_q <= equal_1590_s4_q;
      equal_2286_s5_q <= equal_2286_s4_q;
      and_2287_s5_q <= and_2287_s4_q;
      select_2290_s5_q <= select_2290;
      not_2773_s5_q <= ~({sum_2771, select_492_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:582
  logic [7:0] select_540;
  assign select_540 = run_shift_s5_q[5] ? x_s5_q : sum_539_s5_q;
  logic less_541;
  assign less_541 = {1'b0, last_s5_q} < select_540;
  // hls/stages/agreement.hpp:216
  logic not_542;
  assign not_542 = ~less_541;
  // hls/stages/agreement.hpp:783
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:516
  logic [6:0] select_2359;
  assign select_2359 = select_2290_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2359;
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
  logic [3:0] select_474_s6_q;
  logic equal_475_s6_q;
  logic [6:0] select_477_s6_q;
  logic [8:0] select_481_s6_q;
  logic and_487_s6_q;
  logic equal_493_s6_q;
  logic [6:0] column_s6_q;
  logic and_511_s6_q;
  logic and_513_s6_q;
  logic so_s6_q;
  logic equal_533_s6_q;
  logic equal_536_s6_q;
  logic [6:0] sum_539_s6_q;
  logic less_541_s6_q;
  logic not_542_s6_q;
  logic and_543_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_653_s6_q;
  logic equal_1461_s6_q;
  logic equal_1471_s6_q;
  logic equal_1590_s6_q;
  logic equal_2286_s6_q;
  logic and_2287_s6_q;
  logic not_2773_s6_q;
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
      shift_first_s6_q <= shift_first_s5_q;
      select_474_s6_q <= select_474_s5_q;
      equal_475_s6_q <= equal_475_s5_q;
      select_477_s6_q <= select_477_s5_q;
      select_481_s6_q <= select_481_s5_q;
      and_487_s6_q <= and_487_s5_q;
      equal_493_s6_q <= equal_493_s5_q;
      column_s6_q <= column_s5_q;
      and_511_s6_q <= and_511_s5_q;
      and_513_s6_q <= and_513_s5_q;
      so_s6_q <= so_s5_q;
      equal_533_s6_q <= equal_533_s5_q;
      equal_536_s6_q <= equal_536_s5_q;
      sum_539_s6_q <= sum_539_s5_q[6:0];
      less_541_s6_q <= less_541;
      not_542_s6_q <= not_542;
      and_543_s6_q <= equal_538_s5_q & not_542;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_653_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_649_s5_q < select_540)));
      equal_1461_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1471_s6_q <= equal_1471_s5_q;
      equal_1590_s6_q <= equal_1590_s5_q;
      equal_2286_s6_q <= equal_2286_s5_q;
      and_2287_s6_q <= and_2287_s5_q;
      not_2773_s6_q <= not_2773_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:582
  logic or_534;
  assign or_534 = so_s6_q | equal_533_s6_q;
  // hls/stages/agreement.hpp:705
  logic not_535;
  assign not_535 = ~or_534;
  // hls/stages/agreement.hpp:141
  logic select_629;
  assign select_629 = equal_536_s6_q ? not_542_s6_q : and_543_s6_q;
  logic and_654;
  assign and_654 = equal_536_s6_q & and_653_s6_q;
  logic select_655;
  assign select_655 = or_534 ? not_542_s6_q : and_654;
  // hls/stages/agreement.hpp:804
  logic [6:0] right;
  assign right = sum_539_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1306; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_534 ? not_542_s6_q : select_629);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1307; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_536_s6_q ? sum_539_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_535 & select_629);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1308; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 46'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_534 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_655;
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
  logic shift_first_s7_q;
  logic [3:0] select_474_s7_q;
  logic equal_475_s7_q;
  logic [6:0] select_477_s7_q;
  logic [8:0] select_481_s7_q;
  logic and_487_s7_q;
  logic equal_493_s7_q;
  logic [6:0] column_s7_q;
  logic and_511_s7_q;
  logic and_513_s7_q;
  logic so_s7_q;
  logic equal_533_s7_q;
  logic or_534_s7_q;
  logic equal_536_s7_q;
  logic less_541_s7_q;
  logic not_542_s7_q;
  logic and_545_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_655_s7_q;
  logic and_1453_s7_q;
  logic [6:0] right_s7_q;
  logic equal_1461_s7_q;
  logic equal_1471_s7_q;
  logic equal_1590_s7_q;
  logic equal_2286_s7_q;
  logic and_2287_s7_q;
  logic not_2773_s7_q;
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
      shift_first_s7_q <= shift_first_s6_q;
      select_474_s7_q <= select_474_s6_q;
      equal_475_s7_q <= equal_475_s6_q;
      select_477_s7_q <= select_477_s6_q;
      select_481_s7_q <= select_481_s6_q;
      and_487_s7_q <= and_487_s6_q;
      equal_493_s7_q <= equal_493_s6_q;
      column_s7_q <= column_s6_q;
      and_511_s7_q <= and_511_s6_q;
      and_513_s7_q <= and_513_s6_q;
      so_s7_q <= so_s6_q;
      equal_533_s7_q <= equal_533_s6_q;
      or_534_s7_q <= or_534;
      equal_536_s7_q <= equal_536_s6_q;
      less_541_s7_q <= less_541_s6_q;
      not_542_s7_q <= not_542_s6_q;
      and_545_s7_q <= not_535 & ((~equal_536_s6_q) & and_543_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_655_s7_q <= select_655;
      and_1453_s7_q <= not_535 & and_654;
      right_s7_q <= right;
      equal_1461_s7_q <= equal_1461_s6_q;
      equal_1471_s7_q <= equal_1471_s6_q;
      equal_1590_s7_q <= equal_1590_s6_q;
      equal_2286_s7_q <= equal_2286_s6_q;
      and_2287_s7_q <= and_2287_s6_q;
      not_2773_s7_q <= not_2773_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1305; read in stage 7, written in stage 27: 7 < 27 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_545_s7_q;
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
  logic shift_first_s8_q;
  logic [3:0] select_474_s8_q;
  logic equal_475_s8_q;
  logic [6:0] select_477_s8_q;
  logic [8:0] select_481_s8_q;
  logic and_487_s8_q;
  logic equal_493_s8_q;
  logic [6:0] column_s8_q;
  logic and_511_s8_q;
  logic and_513_s8_q;
  logic so_s8_q;
  logic equal_533_s8_q;
  logic or_534_s8_q;
  logic equal_536_s8_q;
  logic less_541_s8_q;
  logic not_542_s8_q;
  logic and_545_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_655_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic and_1453_s8_q;
  logic [6:0] right_s8_q;
  logic equal_1461_s8_q;
  logic equal_1471_s8_q;
  logic equal_1590_s8_q;
  logic equal_2286_s8_q;
  logic and_2287_s8_q;
  logic not_2773_s8_q;
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
      shift_first_s8_q <= shift_first_s7_q;
      select_474_s8_q <= select_474_s7_q;
      equal_475_s8_q <= equal_475_s7_q;
      select_477_s8_q <= select_477_s7_q;
      select_481_s8_q <= select_481_s7_q;
      and_487_s8_q <= and_487_s7_q;
      equal_493_s8_q <= equal_493_s7_q;
      column_s8_q <= column_s7_q;
      and_511_s8_q <= and_511_s7_q;
      and_513_s8_q <= and_513_s7_q;
      so_s8_q <= so_s7_q;
      equal_533_s8_q <= equal_533_s7_q;
      or_534_s8_q <= or_534_s7_q;
      equal_536_s8_q <= equal_536_s7_q;
      less_541_s8_q <= less_541_s7_q;
      not_542_s8_q <= not_542_s7_q;
      and_545_s8_q <= and_545_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_655_s8_q <= select_655_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      and_1453_s8_q <= and_1453_s7_q;
      right_s8_q <= right_s7_q;
      equal_1461_s8_q <= equal_1461_s7_q;
      equal_1471_s8_q <= equal_1471_s7_q;
      equal_1590_s8_q <= equal_1590_s7_q;
      equal_2286_s8_q <= equal_2286_s7_q;
      and_2287_s8_q <= and_2287_s7_q;
      not_2773_s8_q <= not_2773_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  // hls/stages/agreement.hpp:654
  logic not_633;
  assign not_633 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:212
  logic and_661;
  assign and_661 = left_rdata_s8_q[44] & not_542_s8_q;
  logic and_662;
  assign and_662 = right_codes_rdata_s8_q[38] & not_542_s8_q;
  logic [11:0] select_663;
  assign select_663 = less_541_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_664;
  assign select_664 = less_541_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_668;
  assign select_668 = and_661 ? (and_662 ? (~(select_663 ^ select_664)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_684;
  assign and_684 = left_rdata_s8_q[60] & not_542_s8_q;
  logic and_685;
  assign and_685 = right_codes_rdata_s8_q[51] & not_542_s8_q;
  logic [11:0] select_686;
  assign select_686 = less_541_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_687;
  assign select_687 = less_541_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_691;
  assign select_691 = and_684 ? (and_685 ? (~(select_686 ^ select_687)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_701;
  assign and_701 = left_rdata_s8_q[76] & not_542_s8_q;
  logic and_702;
  assign and_702 = right_codes_rdata_s8_q[64] & not_542_s8_q;
  logic [11:0] select_703;
  assign select_703 = less_541_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_704;
  assign select_704 = less_541_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_708;
  assign select_708 = and_701 ? (and_702 ? (~(select_703 ^ select_704)) : 12'h0) : 12'h0;
  logic [11:0] select_916;
  assign select_916 = (slot_s8_q[0] ? and_702 : and_685) ? (~(select_664 ^ (slot_s8_q[0] ? select_703 : select_686))) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_933;
  assign and_933 = right_codes_rdata_s8_q[77] & not_542_s8_q;
  logic [11:0] select_935;
  assign select_935 = less_541_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_939;
  assign select_939 = (slot_s8_q[0] ? and_933 : and_702) ? (~(select_687 ^ (slot_s8_q[0] ? select_935 : select_703))) : 12'h0;
  // hls/stages/agreement.hpp:719
  logic select_951;
  assign select_951 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_542_s8_q) : and_933;
  logic [11:0] select_953;
  assign select_953 = slot_s8_q[0] ? (less_541_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_935;
  // hls/stages/agreement.hpp:212
  logic and_1162;
  assign and_1162 = right_codes_rdata_s8_q[25] & not_542_s8_q;
  // hls/stages/agreement.hpp:719
  logic select_1163;
  assign select_1163 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_542_s8_q) : and_1162;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1165;
  assign select_1165 = less_541_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:719
  logic [11:0] select_1166;
  assign select_1166 = slot_s8_q[0] ? (less_541_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1165;
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1190;
  assign select_1190 = (slot_s8_q[0] ? and_1162 : and_662) ? (~(select_687 ^ (slot_s8_q[0] ? select_1165 : select_663))) : 12'h0;
  logic [11:0] select_1205;
  assign select_1205 = (slot_s8_q[0] ? and_662 : and_685) ? (~(select_704 ^ (slot_s8_q[0] ? select_663 : select_686))) : 12'h0;
  // hls/stages/agreement.hpp:937
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:942
  logic and_1477;
  assign and_1477 = (or_534_s8_q & (left_rdata_s8_q[61] & not_542_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:235
  logic and_1485;
  assign and_1485 = not_542_s8_q & (or_534_s8_q & (left_rdata_s8_q[63] & not_542_s8_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
    end else if (s8_en) begin
      row_q <= and_513_s8_q ? (equal_2286_s8_q ? row_s8_q : row_q) : row_q;
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
  logic shift_first_s9_q;
  logic [3:0] select_474_s9_q;
  logic equal_475_s9_q;
  logic [6:0] select_477_s9_q;
  logic [8:0] select_481_s9_q;
  logic and_487_s9_q;
  logic equal_493_s9_q;
  logic [6:0] column_s9_q;
  logic and_511_s9_q;
  logic and_513_s9_q;
  logic so_s9_q;
  logic equal_533_s9_q;
  logic or_534_s9_q;
  logic equal_536_s9_q;
  logic less_541_s9_q;
  logic not_542_s9_q;
  logic and_545_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic [6:0] row_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_634_s9_q;
  logic and_635_s9_q;
  logic and_636_s9_q;
  logic and_637_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_641_s9_q;
  logic and_642_s9_q;
  logic and_643_s9_q;
  logic and_644_s9_q;
  logic and_645_s9_q;
  logic and_646_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_655_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic and_661_s9_q;
  logic [11:0] select_668_s9_q;
  logic and_684_s9_q;
  logic [11:0] select_691_s9_q;
  logic and_701_s9_q;
  logic [11:0] select_708_s9_q;
  logic [11:0] select_916_s9_q;
  logic [11:0] select_939_s9_q;
  logic [11:0] select_956_s9_q;
  logic [11:0] select_1169_s9_q;
  logic [11:0] select_1190_s9_q;
  logic [11:0] select_1205_s9_q;
  logic and_1453_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic equal_1461_s9_q;
  logic equal_1471_s9_q;
  logic and_1478_s9_q;
  logic and_1481_s9_q;
  logic and_1485_s9_q;
  logic equal_1590_s9_q;
  logic less_1611_s9_q;
  logic and_2016_s9_q;
  logic equal_2286_s9_q;
  logic and_2287_s9_q;
  logic not_2773_s9_q;
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
      shift_first_s9_q <= shift_first_s8_q;
      select_474_s9_q <= select_474_s8_q;
      equal_475_s9_q <= equal_475_s8_q;
      select_477_s9_q <= select_477_s8_q;
      select_481_s9_q <= select_481_s8_q;
      and_487_s9_q <= and_487_s8_q;
      equal_493_s9_q <= equal_493_s8_q;
      column_s9_q <= column_s8_q;
      and_511_s9_q <= and_511_s8_q;
      and_513_s9_q <= and_513_s8_q;
      so_s9_q <= so_s8_q;
      equal_533_s9_q <= equal_533_s8_q;
      or_534_s9_q <= or_534_s8_q;
      equal_536_s9_q <= equal_536_s8_q;
      less_541_s9_q <= less_541_s8_q;
      not_542_s9_q <= not_542_s8_q;
      and_545_s9_q <= and_545_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      row_s9_q <= row_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_634_s9_q <= left_rdata_s8_q[12] & not_633;
      and_635_s9_q <= left_rdata_s8_q[28] & not_633;
      and_636_s9_q <= left_rdata_s8_q[44] & not_633;
      and_637_s9_q <= left_rdata_s8_q[60] & not_633;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_641_s9_q <= right_codes_rdata_s8_q[12] & not_633;
      and_642_s9_q <= right_codes_rdata_s8_q[25] & not_633;
      and_643_s9_q <= right_codes_rdata_s8_q[38] & not_633;
      and_644_s9_q <= right_codes_rdata_s8_q[51] & not_633;
      and_645_s9_q <= right_codes_rdata_s8_q[64] & not_633;
      and_646_s9_q <= right_codes_rdata_s8_q[77] & not_633;
      x_s9_2_q <= x_s8_2_q;
      select_655_s9_q <= select_655_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      and_661_s9_q <= and_661;
      select_668_s9_q <= select_668;
      and_684_s9_q <= and_684;
      select_691_s9_q <= select_691;
      and_701_s9_q <= and_701;
      select_708_s9_q <= select_708;
      select_916_s9_q <= select_916;
      select_939_s9_q <= select_939;
      select_956_s9_q <= select_951 ? (~(select_704 ^ select_953)) : 12'h0;
      select_1169_s9_q <= select_1163 ? (~(select_664 ^ select_1166)) : 12'h0;
      select_1190_s9_q <= select_1190;
      select_1205_s9_q <= select_1205;
      and_1453_s9_q <= and_1453_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      equal_1461_s9_q <= equal_1461_s8_q;
      equal_1471_s9_q <= equal_1471_s8_q;
      and_1478_s9_q <= not_542_s8_q & and_1477;
      and_1481_s9_q <= (or_534_s8_q & (left_rdata_s8_q[62] & not_542_s8_q)) & and_1477;
      and_1485_s9_q <= and_1485;
      equal_1590_s9_q <= equal_1590_s8_q;
      less_1611_s9_q <= 6'h4 < row_q[6:1];
      and_2016_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2286_s9_q <= equal_2286_s8_q;
      and_2287_s9_q <= and_2287_s8_q;
      not_2773_s9_q <= not_2773_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/count_bits.hpp:24
  logic parity_674;
  assign parity_674 = ^select_668_s9_q[5:3];
  logic parity_677;
  assign parity_677 = ^select_668_s9_q[8:6];
  logic parity_680;
  assign parity_680 = ^select_668_s9_q[11:3];
  logic parity_694;
  assign parity_694 = ^select_691_s9_q[8:6];
  logic parity_697;
  assign parity_697 = ^select_691_s9_q[11:9];
  logic parity_714;
  assign parity_714 = ^select_708_s9_q[2:0];
  logic parity_717;
  assign parity_717 = ^select_708_s9_q[5:3];
  logic parity_720;
  assign parity_720 = ^select_708_s9_q[8:0];
  logic parity_726;
  assign parity_726 = ^select_708_s9_q[11:9];
  logic parity_729;
  assign parity_729 = ^select_691_s9_q[2:0];
  logic parity_732;
  assign parity_732 = ^{select_708_s9_q[11:9], select_691_s9_q[5:0]};
  logic parity_735;
  assign parity_735 = ^{select_708_s9_q, select_691_s9_q, select_668_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_740;
  assign or_740 = (select_668_s9_q[1:0] == 2'h3) | (select_668_s9_q[2] & (select_668_s9_q[0] | select_668_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_744;
  assign or_744 = (select_691_s9_q[7:6] == 2'h3) | (select_691_s9_q[8] & (select_691_s9_q[6] | select_691_s9_q[7]));
  logic or_748;
  assign or_748 = (select_691_s9_q[10:9] == 2'h3) | (select_691_s9_q[11] & (select_691_s9_q[9] | select_691_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_756;
  assign or_756 = (select_708_s9_q[7:6] == 2'h3) | (select_708_s9_q[8] & (~(select_708_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_760;
  assign or_760 = (select_708_s9_q[1:0] == 2'h3) | (select_708_s9_q[2] & (select_708_s9_q[0] | select_708_s9_q[1]));
  logic or_764;
  assign or_764 = (select_708_s9_q[4:3] == 2'h3) | (select_708_s9_q[5] & (select_708_s9_q[3] | select_708_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_767;
  assign parity_767 = ^{or_764, or_760, or_756};
  // hls/stages/count_bits.hpp:23
  logic or_771;
  assign or_771 = (select_691_s9_q[4:3] == 2'h3) | (select_691_s9_q[5] & (select_691_s9_q[3] | select_691_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_775;
  assign or_775 = (select_708_s9_q[10:9] == 2'h3) | (select_708_s9_q[11] & (select_708_s9_q[9] | select_708_s9_q[10]));
  logic or_779;
  assign or_779 = (select_691_s9_q[1:0] == 2'h3) | (select_691_s9_q[2] & (select_691_s9_q[0] | select_691_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_782;
  assign parity_782 = ^{or_779, or_775, or_771};
  logic parity_785;
  assign parity_785 = ^{or_779, or_775, or_771, or_764, or_760, or_756, or_748, or_744, or_740};
  // hls/stages/count_bits.hpp:25
  logic or_790;
  assign or_790 = (parity_674 & parity_677) | ((^select_668_s9_q[11:9]) & (parity_674 | parity_677));
  logic and_793;
  assign and_793 = (^{select_691_s9_q[11:6], select_668_s9_q[2:0]}) & (parity_720 | parity_732);
  // hls/stages/count_bits.hpp:23
  logic or_801;
  assign or_801 = (select_668_s9_q[10:9] == 2'h3) | (select_668_s9_q[11] & (select_668_s9_q[9] | select_668_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_805;
  assign or_805 = (select_668_s9_q[4:3] == 2'h3) | (select_668_s9_q[5] & (select_668_s9_q[3] | select_668_s9_q[4]));
  logic or_809;
  assign or_809 = (select_668_s9_q[7:6] == 2'h3) | (select_668_s9_q[8] & (select_668_s9_q[6] | select_668_s9_q[7]));
  logic or_816;
  assign or_816 = (parity_694 & parity_697) | ((^select_668_s9_q[2:0]) & (parity_694 | parity_697));
  logic or_820;
  assign or_820 = (parity_714 & parity_717) | ((^select_708_s9_q[8:6]) & (parity_714 | parity_717));
  logic or_824;
  assign or_824 = (parity_726 & parity_729) | ((^select_691_s9_q[5:3]) & (parity_726 | parity_729));
  // hls/stages/agreement.hpp:670
  logic [11:0] select_917;
  assign select_917 = and_661_s9_q ? select_916_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_923;
  assign parity_923 = ^select_917[5:3];
  logic parity_926;
  assign parity_926 = ^select_917[8:6];
  logic parity_929;
  assign parity_929 = ^select_917[11:3];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_940;
  assign select_940 = and_684_s9_q ? select_939_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_943;
  assign parity_943 = ^select_940[8:6];
  logic parity_946;
  assign parity_946 = ^select_940[11:9];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_957;
  assign select_957 = and_701_s9_q ? select_956_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_963;
  assign parity_963 = ^select_957[2:0];
  logic parity_966;
  assign parity_966 = ^select_957[5:3];
  logic parity_969;
  assign parity_969 = ^select_957[8:0];
  logic parity_975;
  assign parity_975 = ^select_957[11:9];
  logic parity_978;
  assign parity_978 = ^select_940[2:0];
  logic parity_981;
  assign parity_981 = ^{select_957[11:9], select_940[5:0]};
  logic parity_984;
  assign parity_984 = ^{select_957, select_940, select_917[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_989;
  assign or_989 = (select_917[1:0] == 2'h3) | (select_917[2] & (select_917[0] | select_917[1]));
  // hls/stages/count_bits.hpp:25
  logic or_993;
  assign or_993 = (select_940[7:6] == 2'h3) | (select_940[8] & (select_940[6] | select_940[7]));
  logic or_997;
  assign or_997 = (select_940[10:9] == 2'h3) | (select_940[11] & (select_940[9] | select_940[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1005;
  assign or_1005 = (select_957[7:6] == 2'h3) | (select_957[8] & (~(select_957[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1009;
  assign or_1009 = (select_957[1:0] == 2'h3) | (select_957[2] & (select_957[0] | select_957[1]));
  logic or_1013;
  assign or_1013 = (select_957[4:3] == 2'h3) | (select_957[5] & (select_957[3] | select_957[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1016;
  assign parity_1016 = ^{or_1013, or_1009, or_1005};
  // hls/stages/count_bits.hpp:23
  logic or_1020;
  assign or_1020 = (select_940[4:3] == 2'h3) | (select_940[5] & (select_940[3] | select_940[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1024;
  assign or_1024 = (select_957[10:9] == 2'h3) | (select_957[11] & (select_957[9] | select_957[10]));
  logic or_1028;
  assign or_1028 = (select_940[1:0] == 2'h3) | (select_940[2] & (select_940[0] | select_940[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1031;
  assign parity_1031 = ^{or_1028, or_1024, or_1020};
  logic parity_1034;
  assign parity_1034 = ^{or_1028, or_1024, or_1020, or_1013, or_1009, or_1005, or_997, or_993, or_989};
  // hls/stages/count_bits.hpp:25
  logic or_1039;
  assign or_1039 = (parity_923 & parity_926) | ((^select_917[11:9]) & (parity_923 | parity_926));
  logic and_1042;
  assign and_1042 = (^{select_940[11:6], select_917[2:0]}) & (parity_969 | parity_981);
  // hls/stages/count_bits.hpp:23
  logic or_1050;
  assign or_1050 = (select_917[10:9] == 2'h3) | (select_917[11] & (select_917[9] | select_917[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1054;
  assign or_1054 = (select_917[4:3] == 2'h3) | (select_917[5] & (select_917[3] | select_917[4]));
  logic or_1058;
  assign or_1058 = (select_917[7:6] == 2'h3) | (select_917[8] & (select_917[6] | select_917[7]));
  logic or_1065;
  assign or_1065 = (parity_943 & parity_946) | ((^select_917[2:0]) & (parity_943 | parity_946));
  logic or_1069;
  assign or_1069 = (parity_963 & parity_966) | ((^select_957[8:6]) & (parity_963 | parity_966));
  logic or_1073;
  assign or_1073 = (parity_975 & parity_978) | ((^select_940[5:3]) & (parity_975 | parity_978));
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1170;
  assign select_1170 = and_661_s9_q ? select_1169_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1176;
  assign parity_1176 = ^select_1170[5:3];
  logic parity_1179;
  assign parity_1179 = ^select_1170[8:6];
  logic parity_1182;
  assign parity_1182 = ^select_1170[11:3];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1191;
  assign select_1191 = and_684_s9_q ? select_1190_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1194;
  assign parity_1194 = ^select_1191[8:6];
  logic parity_1197;
  assign parity_1197 = ^select_1191[11:9];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1206;
  assign select_1206 = and_701_s9_q ? select_1205_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1212;
  assign parity_1212 = ^select_1206[2:0];
  logic parity_1215;
  assign parity_1215 = ^select_1206[5:3];
  logic parity_1218;
  assign parity_1218 = ^select_1206[8:0];
  logic parity_1224;
  assign parity_1224 = ^select_1206[11:9];
  logic parity_1227;
  assign parity_1227 = ^select_1191[2:0];
  logic parity_1230;
  assign parity_1230 = ^{select_1206[11:9], select_1191[5:0]};
  logic parity_1233;
  assign parity_1233 = ^{select_1206, select_1191, select_1170[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1238;
  assign or_1238 = (select_1170[1:0] == 2'h3) | (select_1170[2] & (select_1170[0] | select_1170[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1242;
  assign or_1242 = (select_1191[7:6] == 2'h3) | (select_1191[8] & (select_1191[6] | select_1191[7]));
  logic or_1246;
  assign or_1246 = (select_1191[10:9] == 2'h3) | (select_1191[11] & (select_1191[9] | select_1191[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1254;
  assign or_1254 = (select_1206[7:6] == 2'h3) | (select_1206[8] & (~(select_1206[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1258;
  assign or_1258 = (select_1206[1:0] == 2'h3) | (select_1206[2] & (select_1206[0] | select_1206[1]));
  logic or_1262;
  assign or_1262 = (select_1206[4:3] == 2'h3) | (select_1206[5] & (select_1206[3] | select_1206[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1265;
  assign parity_1265 = ^{or_1262, or_1258, or_1254};
  // hls/stages/count_bits.hpp:23
  logic or_1269;
  assign or_1269 = (select_1191[4:3] == 2'h3) | (select_1191[5] & (select_1191[3] | select_1191[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1273;
  assign or_1273 = (select_1206[10:9] == 2'h3) | (select_1206[11] & (select_1206[9] | select_1206[10]));
  logic or_1277;
  assign or_1277 = (select_1191[1:0] == 2'h3) | (select_1191[2] & (select_1191[0] | select_1191[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1280;
  assign parity_1280 = ^{or_1277, or_1273, or_1269};
  logic parity_1283;
  assign parity_1283 = ^{or_1277, or_1273, or_1269, or_1262, or_1258, or_1254, or_1246, or_1242, or_1238};
  // hls/stages/count_bits.hpp:25
  logic or_1288;
  assign or_1288 = (parity_1176 & parity_1179) | ((^select_1170[11:9]) & (parity_1176 | parity_1179));
  logic and_1291;
  assign and_1291 = (^{select_1191[11:6], select_1170[2:0]}) & (parity_1218 | parity_1230);
  // hls/stages/count_bits.hpp:23
  logic or_1299;
  assign or_1299 = (select_1170[10:9] == 2'h3) | (select_1170[11] & (select_1170[9] | select_1170[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1303;
  assign or_1303 = (select_1170[4:3] == 2'h3) | (select_1170[5] & (select_1170[3] | select_1170[4]));
  logic or_1307;
  assign or_1307 = (select_1170[7:6] == 2'h3) | (select_1170[8] & (select_1170[6] | select_1170[7]));
  logic or_1314;
  assign or_1314 = (parity_1194 & parity_1197) | ((^select_1170[2:0]) & (parity_1194 | parity_1197));
  logic or_1318;
  assign or_1318 = (parity_1212 & parity_1215) | ((^select_1206[8:6]) & (parity_1212 | parity_1215));
  logic or_1322;
  assign or_1322 = (parity_1224 & parity_1227) | ((^select_1191[5:3]) & (parity_1224 | parity_1227));
  // hls/stages/agreement.hpp:938
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:235
  logic or_1499;
  assign or_1499 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_545_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_637_s9_q, left_rdata_s9_q[56:42], and_636_s9_q, left_rdata_s9_q[41:27], and_635_s9_q, left_rdata_s9_q[26:12], and_634_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_545_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_646_s9_q, right_codes_rdata_s9_q[71:60], and_645_s9_q, right_codes_rdata_s9_q[59:48], and_644_s9_q, right_codes_rdata_s9_q[47:36], and_643_s9_q, right_codes_rdata_s9_q[35:24], and_642_s9_q, right_codes_rdata_s9_q[23:12], and_641_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
  logic shift_first_s10_q;
  logic [3:0] select_474_s10_q;
  logic equal_475_s10_q;
  logic [6:0] select_477_s10_q;
  logic [8:0] select_481_s10_q;
  logic and_487_s10_q;
  logic equal_493_s10_q;
  logic [6:0] column_s10_q;
  logic and_511_s10_q;
  logic and_513_s10_q;
  logic so_s10_q;
  logic equal_533_s10_q;
  logic or_534_s10_q;
  logic equal_536_s10_q;
  logic less_541_s10_q;
  logic not_542_s10_q;
  logic [6:0] row_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_655_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic xor_736_s10_q;
  logic parity_785_s10_q;
  logic and_786_s10_q;
  logic or_790_s10_q;
  logic or_794_s10_q;
  logic or_801_s10_q;
  logic or_805_s10_q;
  logic or_809_s10_q;
  logic or_816_s10_q;
  logic or_820_s10_q;
  logic or_824_s10_q;
  logic and_833_s10_q;
  logic and_835_s10_q;
  logic or_847_s10_q;
  logic or_851_s10_q;
  logic or_855_s10_q;
  logic xor_985_s10_q;
  logic parity_1000_s10_q;
  logic parity_1034_s10_q;
  logic and_1035_s10_q;
  logic or_1039_s10_q;
  logic or_1043_s10_q;
  logic or_1050_s10_q;
  logic or_1054_s10_q;
  logic or_1058_s10_q;
  logic or_1065_s10_q;
  logic or_1069_s10_q;
  logic or_1073_s10_q;
  logic and_1082_s10_q;
  logic or_1083_s10_q;
  logic or_1096_s10_q;
  logic or_1100_s10_q;
  logic or_1104_s10_q;
  logic xor_1234_s10_q;
  logic parity_1249_s10_q;
  logic parity_1283_s10_q;
  logic and_1284_s10_q;
  logic or_1288_s10_q;
  logic or_1292_s10_q;
  logic or_1299_s10_q;
  logic or_1303_s10_q;
  logic or_1307_s10_q;
  logic or_1314_s10_q;
  logic or_1318_s10_q;
  logic or_1322_s10_q;
  logic and_1331_s10_q;
  logic or_1332_s10_q;
  logic or_1345_s10_q;
  logic or_1349_s10_q;
  logic or_1353_s10_q;
  logic and_1453_s10_q;
  logic [6:0] select_1457_s10_q;
  logic [6:0] right_s10_q;
  logic equal_1461_s10_q;
  logic equal_1471_s10_q;
  logic and_1478_s10_q;
  logic and_1481_s10_q;
  logic and_1485_s10_q;
  logic or_1499_s10_q;
  logic equal_1590_s10_q;
  logic less_1611_s10_q;
  logic and_2016_s10_q;
  logic equal_2286_s10_q;
  logic and_2287_s10_q;
  logic not_2773_s10_q;
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
      shift_first_s10_q <= shift_first_s9_q;
      select_474_s10_q <= select_474_s9_q;
      equal_475_s10_q <= equal_475_s9_q;
      select_477_s10_q <= select_477_s9_q;
      select_481_s10_q <= select_481_s9_q;
      and_487_s10_q <= and_487_s9_q;
      equal_493_s10_q <= equal_493_s9_q;
      column_s10_q <= column_s9_q;
      and_511_s10_q <= and_511_s9_q;
      and_513_s10_q <= and_513_s9_q;
      so_s10_q <= so_s9_q;
      equal_533_s10_q <= equal_533_s9_q;
      or_534_s10_q <= or_534_s9_q;
      equal_536_s10_q <= equal_536_s9_q;
      less_541_s10_q <= less_541_s9_q;
      not_542_s10_q <= not_542_s9_q;
      row_s10_q <= row_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_655_s10_q <= select_655_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      xor_736_s10_q <= parity_680 ^ parity_735;
      parity_785_s10_q <= parity_785;
      and_786_s10_q <= parity_680 & parity_735;
      or_790_s10_q <= or_790;
      or_794_s10_q <= (parity_720 & parity_732) | and_793;
      or_801_s10_q <= or_801;
      or_805_s10_q <= or_805;
      or_809_s10_q <= or_809;
      or_816_s10_q <= or_816;
      or_820_s10_q <= or_820;
      or_824_s10_q <= or_824;
      and_833_s10_q <= parity_767 & parity_782;
      and_835_s10_q <= (^{or_748, or_744, or_740}) & (parity_767 | parity_782);
      or_847_s10_q <= (or_744 & or_748) | (or_740 & (or_744 | or_748));
      or_851_s10_q <= (or_760 & or_764) | (or_756 & (or_760 | or_764));
      or_855_s10_q <= (or_775 & or_779) | (or_771 & (or_775 | or_779));
      xor_985_s10_q <= parity_929 ^ parity_984;
      parity_1000_s10_q <= ^{or_997, or_993, or_989};
      parity_1034_s10_q <= parity_1034;
      and_1035_s10_q <= parity_929 & parity_984;
      or_1039_s10_q <= or_1039;
      or_1043_s10_q <= (parity_969 & parity_981) | and_1042;
      or_1050_s10_q <= or_1050;
      or_1054_s10_q <= or_1054;
      or_1058_s10_q <= or_1058;
      or_1065_s10_q <= or_1065;
      or_1069_s10_q <= or_1069;
      or_1073_s10_q <= or_1073;
      and_1082_s10_q <= parity_1016 & parity_1031;
      or_1083_s10_q <= parity_1016 | parity_1031;
      or_1096_s10_q <= (or_993 & or_997) | (or_989 & (or_993 | or_997));
      or_1100_s10_q <= (or_1009 & or_1013) | (or_1005 & (or_1009 | or_1013));
      or_1104_s10_q <= (or_1024 & or_1028) | (or_1020 & (or_1024 | or_1028));
      xor_1234_s10_q <= parity_1182 ^ parity_1233;
      parity_1249_s10_q <= ^{or_1246, or_1242, or_1238};
      parity_1283_s10_q <= parity_1283;
      and_1284_s10_q <= parity_1182 & parity_1233;
      or_1288_s10_q <= or_1288;
      or_1292_s10_q <= (parity_1218 & parity_1230) | and_1291;
      or_1299_s10_q <= or_1299;
      or_1303_s10_q <= or_1303;
      or_1307_s10_q <= or_1307;
      or_1314_s10_q <= or_1314;
      or_1318_s10_q <= or_1318;
      or_1322_s10_q <= or_1322;
      and_1331_s10_q <= parity_1265 & parity_1280;
      or_1332_s10_q <= parity_1265 | parity_1280;
      or_1345_s10_q <= (or_1242 & or_1246) | (or_1238 & (or_1242 | or_1246));
      or_1349_s10_q <= (or_1258 & or_1262) | (or_1254 & (or_1258 | or_1262));
      or_1353_s10_q <= (or_1273 & or_1277) | (or_1269 & (or_1273 | or_1277));
      and_1453_s10_q <= and_1453_s9_q;
      select_1457_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      equal_1461_s10_q <= equal_1461_s9_q;
      equal_1471_s10_q <= equal_1471_s9_q;
      and_1478_s10_q <= and_1478_s9_q;
      and_1481_s10_q <= and_1481_s9_q;
      and_1485_s10_q <= and_1485_s9_q;
      or_1499_s10_q <= or_1499;
      equal_1590_s10_q <= equal_1590_s9_q;
      less_1611_s10_q <= less_1611_s9_q;
      and_2016_s10_q <= and_2016_s9_q;
      equal_2286_s10_q <= equal_2286_s9_q;
      and_2287_s10_q <= and_2287_s9_q;
      not_2773_s10_q <= not_2773_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_phase_q;
  // hls/stages/count_bits.hpp:24
  logic parity_812;
  assign parity_812 = ^{or_809_s10_q, or_805_s10_q, or_801_s10_q};
  logic parity_827;
  assign parity_827 = ^{or_824_s10_q, or_820_s10_q, or_816_s10_q};
  logic parity_830;
  assign parity_830 = ^{or_824_s10_q, or_820_s10_q, or_816_s10_q, or_809_s10_q, or_805_s10_q, or_801_s10_q, or_794_s10_q, or_790_s10_q, and_786_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_832;
  assign and_832 = parity_785_s10_q & parity_830;
  logic or_836;
  assign or_836 = and_833_s10_q | and_835_s10_q;
  logic and_839;
  assign and_839 = (^{or_794_s10_q, or_790_s10_q, and_786_s10_q}) & (parity_812 | parity_827);
  logic or_840;
  assign or_840 = (parity_812 & parity_827) | and_839;
  // hls/stages/count_bits.hpp:24
  logic parity_858;
  assign parity_858 = ^{or_855_s10_q, or_851_s10_q, or_847_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_862;
  assign or_862 = (or_790_s10_q & or_794_s10_q) | (and_786_s10_q & (or_790_s10_q | or_794_s10_q));
  logic or_866;
  assign or_866 = (or_805_s10_q & or_809_s10_q) | (or_801_s10_q & (or_805_s10_q | or_809_s10_q));
  logic or_870;
  assign or_870 = (or_820_s10_q & or_824_s10_q) | (or_816_s10_q & (or_820_s10_q | or_824_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_873;
  assign parity_873 = ^{or_870, or_866, or_862};
  logic parity_876;
  assign parity_876 = ^{or_870, or_866, or_862, or_855_s10_q, or_851_s10_q, or_847_s10_q, or_840, or_836, and_832};
  // hls/stages/count_bits.hpp:25
  logic or_888;
  assign or_888 = (or_851_s10_q & or_855_s10_q) | (or_847_s10_q & (or_851_s10_q | or_855_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1061;
  assign parity_1061 = ^{or_1058_s10_q, or_1054_s10_q, or_1050_s10_q};
  logic parity_1076;
  assign parity_1076 = ^{or_1073_s10_q, or_1069_s10_q, or_1065_s10_q};
  logic parity_1079;
  assign parity_1079 = ^{or_1073_s10_q, or_1069_s10_q, or_1065_s10_q, or_1058_s10_q, or_1054_s10_q, or_1050_s10_q, or_1043_s10_q, or_1039_s10_q, and_1035_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1081;
  assign and_1081 = parity_1034_s10_q & parity_1079;
  logic or_1085;
  assign or_1085 = and_1082_s10_q | (parity_1000_s10_q & or_1083_s10_q);
  logic and_1088;
  assign and_1088 = (^{or_1043_s10_q, or_1039_s10_q, and_1035_s10_q}) & (parity_1061 | parity_1076);
  logic or_1089;
  assign or_1089 = (parity_1061 & parity_1076) | and_1088;
  // hls/stages/count_bits.hpp:24
  logic parity_1107;
  assign parity_1107 = ^{or_1104_s10_q, or_1100_s10_q, or_1096_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1111;
  assign or_1111 = (or_1039_s10_q & or_1043_s10_q) | (and_1035_s10_q & (or_1039_s10_q | or_1043_s10_q));
  logic or_1115;
  assign or_1115 = (or_1054_s10_q & or_1058_s10_q) | (or_1050_s10_q & (or_1054_s10_q | or_1058_s10_q));
  logic or_1119;
  assign or_1119 = (or_1069_s10_q & or_1073_s10_q) | (or_1065_s10_q & (or_1069_s10_q | or_1073_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1122;
  assign parity_1122 = ^{or_1119, or_1115, or_1111};
  logic parity_1125;
  assign parity_1125 = ^{or_1119, or_1115, or_1111, or_1104_s10_q, or_1100_s10_q, or_1096_s10_q, or_1089, or_1085, and_1081};
  // hls/stages/count_bits.hpp:25
  logic or_1137;
  assign or_1137 = (or_1100_s10_q & or_1104_s10_q) | (or_1096_s10_q & (or_1100_s10_q | or_1104_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1310;
  assign parity_1310 = ^{or_1307_s10_q, or_1303_s10_q, or_1299_s10_q};
  logic parity_1325;
  assign parity_1325 = ^{or_1322_s10_q, or_1318_s10_q, or_1314_s10_q};
  logic parity_1328;
  assign parity_1328 = ^{or_1322_s10_q, or_1318_s10_q, or_1314_s10_q, or_1307_s10_q, or_1303_s10_q, or_1299_s10_q, or_1292_s10_q, or_1288_s10_q, and_1284_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1330;
  assign and_1330 = parity_1283_s10_q & parity_1328;
  logic or_1334;
  assign or_1334 = and_1331_s10_q | (parity_1249_s10_q & or_1332_s10_q);
  logic and_1337;
  assign and_1337 = (^{or_1292_s10_q, or_1288_s10_q, and_1284_s10_q}) & (parity_1310 | parity_1325);
  logic or_1338;
  assign or_1338 = (parity_1310 & parity_1325) | and_1337;
  // hls/stages/count_bits.hpp:24
  logic parity_1356;
  assign parity_1356 = ^{or_1353_s10_q, or_1349_s10_q, or_1345_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1360;
  assign or_1360 = (or_1288_s10_q & or_1292_s10_q) | (and_1284_s10_q & (or_1288_s10_q | or_1292_s10_q));
  logic or_1364;
  assign or_1364 = (or_1303_s10_q & or_1307_s10_q) | (or_1299_s10_q & (or_1303_s10_q | or_1307_s10_q));
  logic or_1368;
  assign or_1368 = (or_1318_s10_q & or_1322_s10_q) | (or_1314_s10_q & (or_1318_s10_q | or_1322_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1371;
  assign parity_1371 = ^{or_1368, or_1364, or_1360};
  logic parity_1374;
  assign parity_1374 = ^{or_1368, or_1364, or_1360, or_1353_s10_q, or_1349_s10_q, or_1345_s10_q, or_1338, or_1334, and_1330};
  // hls/stages/count_bits.hpp:25
  logic or_1386;
  assign or_1386 = (or_1349_s10_q & or_1353_s10_q) | (or_1345_s10_q & (or_1349_s10_q | or_1353_s10_q));
  // hls/stages/agreement.hpp:141
  logic [6:0] select_1509;
  assign select_1509 = or_534_s10_q ? (less_541_s10_q ? 7'h0 : select_1457_s10_q) : 7'h0;
  // hls/stages/patches.hpp:114
  logic and_1584;
  assign and_1584 = (select_474_s10_q == 4'h0) & (select_477_s10_q == 7'h0);
  // hls/stages/patches.hpp:308
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:118
  logic [3:0] select_2707;
  assign select_2707 = and_1584 ? (sample_pair_first_s10_q ? phase : patches_phase_q) : patches_phase_q;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1309; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_534_s10_q ? select_1457_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_655_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_phase_q <= 4'h0;
    end else if (s10_en) begin
      patches_phase_q <= sample_pair_whole_s10_q ? select_2707 : patches_phase_q;
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
  logic shift_first_s11_q;
  logic [3:0] select_474_s11_q;
  logic equal_475_s11_q;
  logic [6:0] select_477_s11_q;
  logic [8:0] select_481_s11_q;
  logic and_487_s11_q;
  logic equal_493_s11_q;
  logic [6:0] column_s11_q;
  logic and_511_s11_q;
  logic and_513_s11_q;
  logic so_s11_q;
  logic equal_533_s11_q;
  logic or_534_s11_q;
  logic equal_536_s11_q;
  logic less_541_s11_q;
  logic not_542_s11_q;
  logic [6:0] row_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic xor_736_s11_q;
  logic xor_831_s11_q;
  logic parity_876_s11_q;
  logic and_877_s11_q;
  logic and_879_s11_q;
  logic and_881_s11_q;
  logic and_883_s11_q;
  logic or_888_s11_q;
  logic or_892_s11_q;
  logic xor_985_s11_q;
  logic xor_1080_s11_q;
  logic parity_1125_s11_q;
  logic and_1126_s11_q;
  logic and_1128_s11_q;
  logic and_1130_s11_q;
  logic and_1132_s11_q;
  logic or_1137_s11_q;
  logic or_1141_s11_q;
  logic xor_1234_s11_q;
  logic xor_1329_s11_q;
  logic parity_1374_s11_q;
  logic and_1375_s11_q;
  logic and_1377_s11_q;
  logic and_1379_s11_q;
  logic and_1381_s11_q;
  logic or_1386_s11_q;
  logic or_1390_s11_q;
  logic and_1453_s11_q;
  logic [6:0] right_s11_q;
  logic equal_1461_s11_q;
  logic equal_1471_s11_q;
  logic and_1478_s11_q;
  logic and_1481_s11_q;
  logic and_1485_s11_q;
  logic or_1499_s11_q;
  logic [6:0] select_1510_s11_q;
  logic and_1584_s11_q;
  logic equal_1590_s11_q;
  logic less_1611_s11_q;
  logic and_2016_s11_q;
  logic equal_2286_s11_q;
  logic and_2287_s11_q;
  logic [3:0] phase_s11_q;
  logic not_2773_s11_q;
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
      shift_first_s11_q <= shift_first_s10_q;
      select_474_s11_q <= select_474_s10_q;
      equal_475_s11_q <= equal_475_s10_q;
      select_477_s11_q <= select_477_s10_q;
      select_481_s11_q <= select_481_s10_q;
      and_487_s11_q <= and_487_s10_q;
      equal_493_s11_q <= equal_493_s10_q;
      column_s11_q <= column_s10_q;
      and_511_s11_q <= and_511_s10_q;
      and_513_s11_q <= and_513_s10_q;
      so_s11_q <= so_s10_q;
      equal_533_s11_q <= equal_533_s10_q;
      or_534_s11_q <= or_534_s10_q;
      equal_536_s11_q <= equal_536_s10_q;
      less_541_s11_q <= less_541_s10_q;
      not_542_s11_q <= not_542_s10_q;
      row_s11_q <= row_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      xor_736_s11_q <= xor_736_s10_q;
      xor_831_s11_q <= parity_785_s10_q ^ parity_830;
      parity_876_s11_q <= parity_876;
      and_877_s11_q <= parity_858 & parity_873;
      and_879_s11_q <= (^{or_840, or_836, and_832}) & (parity_858 | parity_873);
      and_881_s11_q <= or_836 & or_840;
      and_883_s11_q <= and_832 & (or_836 | or_840);
      or_888_s11_q <= or_888;
      or_892_s11_q <= (or_866 & or_870) | (or_862 & (or_866 | or_870));
      xor_985_s11_q <= xor_985_s10_q;
      xor_1080_s11_q <= parity_1034_s10_q ^ parity_1079;
      parity_1125_s11_q <= parity_1125;
      and_1126_s11_q <= parity_1107 & parity_1122;
      and_1128_s11_q <= (^{or_1089, or_1085, and_1081}) & (parity_1107 | parity_1122);
      and_1130_s11_q <= or_1085 & or_1089;
      and_1132_s11_q <= and_1081 & (or_1085 | or_1089);
      or_1137_s11_q <= or_1137;
      or_1141_s11_q <= (or_1115 & or_1119) | (or_1111 & (or_1115 | or_1119));
      xor_1234_s11_q <= xor_1234_s10_q;
      xor_1329_s11_q <= parity_1283_s10_q ^ parity_1328;
      parity_1374_s11_q <= parity_1374;
      and_1375_s11_q <= parity_1356 & parity_1371;
      and_1377_s11_q <= (^{or_1338, or_1334, and_1330}) & (parity_1356 | parity_1371);
      and_1379_s11_q <= or_1334 & or_1338;
      and_1381_s11_q <= and_1330 & (or_1334 | or_1338);
      or_1386_s11_q <= or_1386;
      or_1390_s11_q <= (or_1364 & or_1368) | (or_1360 & (or_1364 | or_1368));
      and_1453_s11_q <= and_1453_s10_q;
      right_s11_q <= right_s10_q;
      equal_1461_s11_q <= equal_1461_s10_q;
      equal_1471_s11_q <= equal_1471_s10_q;
      and_1478_s11_q <= and_1478_s10_q;
      and_1481_s11_q <= and_1481_s10_q;
      and_1485_s11_q <= and_1485_s10_q;
      or_1499_s11_q <= or_1499_s10_q;
      select_1510_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1509;
      and_1584_s11_q <= and_1584;
      equal_1590_s11_q <= equal_1590_s10_q;
      less_1611_s11_q <= less_1611_s10_q;
      and_2016_s11_q <= and_2016_s10_q;
      equal_2286_s11_q <= equal_2286_s10_q;
      and_2287_s11_q <= and_2287_s10_q;
      phase_s11_q <= phase;
      not_2773_s11_q <= not_2773_s10_q;
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
  logic or_880;
  assign or_880 = and_877_s11_q | and_879_s11_q;
  logic or_884;
  assign or_884 = and_881_s11_q | and_883_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_897;
  assign parity_897 = ^{or_892_s11_q, or_888_s11_q, or_884, or_880};
  // hls/stages/count_bits.hpp:25
  logic or_901;
  assign or_901 = (or_888_s11_q & or_892_s11_q) | (or_884 & (or_888_s11_q | or_892_s11_q));
  logic and_902;
  assign and_902 = or_880 & (^{or_892_s11_q, or_888_s11_q, or_884});
  // hls/stages/count_bits.hpp:24
  logic xor_903;
  assign xor_903 = or_901 ^ and_902;
  // hls/stages/count_bits.hpp:27
  logic and_904;
  assign and_904 = or_901 & and_902;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_905;
  assign select_905 = equal_536_s11_q ? {and_904, xor_903, parity_897, parity_876_s11_q, xor_831_s11_q, xor_736_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_534_s11_q ? 6'h0 : select_905;
  // hls/stages/count_bits.hpp:25
  logic or_1129;
  assign or_1129 = and_1126_s11_q | and_1128_s11_q;
  logic or_1133;
  assign or_1133 = and_1130_s11_q | and_1132_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1146;
  assign parity_1146 = ^{or_1141_s11_q, or_1137_s11_q, or_1133, or_1129};
  // hls/stages/count_bits.hpp:25
  logic or_1150;
  assign or_1150 = (or_1137_s11_q & or_1141_s11_q) | (or_1133 & (or_1137_s11_q | or_1141_s11_q));
  logic and_1151;
  assign and_1151 = or_1129 & (^{or_1141_s11_q, or_1137_s11_q, or_1133});
  // hls/stages/count_bits.hpp:24
  logic xor_1152;
  assign xor_1152 = or_1150 ^ and_1151;
  // hls/stages/count_bits.hpp:27
  logic and_1153;
  assign and_1153 = or_1150 & and_1151;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1154;
  assign select_1154 = equal_536_s11_q ? {and_1153, xor_1152, parity_1146, parity_1125_s11_q, xor_1080_s11_q, xor_985_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_534_s11_q ? 6'h0 : select_1154;
  // hls/stages/count_bits.hpp:25
  logic or_1378;
  assign or_1378 = and_1375_s11_q | and_1377_s11_q;
  logic or_1382;
  assign or_1382 = and_1379_s11_q | and_1381_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1395;
  assign parity_1395 = ^{or_1390_s11_q, or_1386_s11_q, or_1382, or_1378};
  // hls/stages/count_bits.hpp:25
  logic or_1399;
  assign or_1399 = (or_1386_s11_q & or_1390_s11_q) | (or_1382 & (or_1386_s11_q | or_1390_s11_q));
  logic and_1400;
  assign and_1400 = or_1378 & (^{or_1390_s11_q, or_1386_s11_q, or_1382});
  // hls/stages/count_bits.hpp:24
  logic xor_1401;
  assign xor_1401 = or_1399 ^ and_1400;
  // hls/stages/count_bits.hpp:27
  logic and_1402;
  assign and_1402 = or_1399 & and_1400;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1403;
  assign select_1403 = equal_536_s11_q ? {and_1402, xor_1401, parity_1395, parity_1374_s11_q, xor_1329_s11_q, xor_1234_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_534_s11_q ? 6'h0 : select_1403;
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1439;
  assign sum_1439 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1442;
  assign sum_1442 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:448
  logic select_2383;
  assign select_2383 = equal_2286_s11_q ? (~({row_s11_q, 1'b0} < {sum_2380, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:508
  logic and_2597;
  assign and_2597 = and_513_s11_q & (equal_2286_s11_q & (row_s11_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      lower_half_q <= 1'b0;
    end else if (s11_en) begin
      lower_half_q <= and_513_s11_q ? select_2383 : lower_half_q;
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
  logic shift_first_s12_q;
  logic [3:0] select_474_s12_q;
  logic equal_475_s12_q;
  logic [6:0] select_477_s12_q;
  logic [8:0] select_481_s12_q;
  logic and_487_s12_q;
  logic equal_493_s12_q;
  logic [6:0] column_s12_q;
  logic and_511_s12_q;
  logic and_513_s12_q;
  logic so_s12_q;
  logic equal_533_s12_q;
  logic or_534_s12_q;
  logic less_541_s12_q;
  logic not_542_s12_q;
  logic equal_574_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1156_s12_q;
  logic [5:0] select_1405_s12_q;
  logic [6:0] sum_1440_s12_q;
  logic [6:0] sum_1443_s12_q;
  logic and_1453_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic equal_1461_s12_q;
  logic equal_1471_s12_q;
  logic and_1478_s12_q;
  logic and_1481_s12_q;
  logic and_1485_s12_q;
  logic or_1499_s12_q;
  logic [6:0] select_1510_s12_q;
  logic and_1584_s12_q;
  logic equal_1590_s12_q;
  logic less_1611_s12_q;
  logic and_2016_s12_q;
  logic equal_2162_s12_q;
  logic equal_2286_s12_q;
  logic and_2598_s12_q;
  logic and_2600_s12_q;
  logic [3:0] phase_s12_q;
  logic equal_2727_s12_q;
  logic [3:0] select_2730_s12_q;
  logic less_2741_s12_q;
  logic not_2773_s12_q;
  logic less_3620_s12_q;
  logic equal_3825_s12_q;
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
      shift_first_s12_q <= shift_first_s11_q;
      select_474_s12_q <= select_474_s11_q;
      equal_475_s12_q <= equal_475_s11_q;
      select_477_s12_q <= select_477_s11_q;
      select_481_s12_q <= select_481_s11_q;
      and_487_s12_q <= and_487_s11_q;
      equal_493_s12_q <= equal_493_s11_q;
      column_s12_q <= column_s11_q;
      and_511_s12_q <= and_511_s11_q;
      and_513_s12_q <= and_513_s11_q;
      so_s12_q <= so_s11_q;
      equal_533_s12_q <= equal_533_s11_q;
      or_534_s12_q <= or_534_s11_q;
      less_541_s12_q <= less_541_s11_q;
      not_542_s12_q <= not_542_s11_q;
      equal_574_s12_q <= row_s11_q == 7'h0;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      column_2_s12_q <= column_2;
      select_1156_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1405_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1440_s12_q <= {1'b0, before_v_2} + sum_1439;
      sum_1443_s12_q <= {1'b0, before_v_3} + sum_1442;
      and_1453_s12_q <= and_1453_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      equal_1461_s12_q <= equal_1461_s11_q;
      equal_1471_s12_q <= equal_1471_s11_q;
      and_1478_s12_q <= and_1478_s11_q;
      and_1481_s12_q <= and_1481_s11_q;
      and_1485_s12_q <= and_1485_s11_q;
      or_1499_s12_q <= or_1499_s11_q;
      select_1510_s12_q <= select_1510_s11_q;
      and_1584_s12_q <= and_1584_s11_q;
      equal_1590_s12_q <= equal_1590_s11_q;
      less_1611_s12_q <= less_1611_s11_q;
      and_2016_s12_q <= and_2016_s11_q;
      equal_2162_s12_q <= (column_s11_q | row_s11_q) == 7'h0;
      equal_2286_s12_q <= equal_2286_s11_q;
      and_2598_s12_q <= and_2287_s11_q & and_2597;
      and_2600_s12_q <= and_2287_s11_q & (~and_2597);
      phase_s12_q <= phase_s11_q;
      equal_2727_s12_q <= row_s11_q == 7'h3;
      select_2730_s12_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      less_2741_s12_q <= 7'h2 < row_s11_q;
      not_2773_s12_q <= not_2773_s11_q;
      less_3620_s12_q <= 6'h2 < row_s11_q[6:1];
      equal_3825_s12_q <= row_s11_q[6:3] == 4'h0;
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
  logic shift_not_right_q;
  logic [3:0] patches_choosing_rows_to_next_q;
  logic patches_chooses_q;
  // hls/stages/agreement.hpp:792
  logic or_658;
  assign or_658 = shift_first_s12_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:763
  logic [5:0] select_907;
  assign select_907 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1435;
  assign sum_1435 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:736
  logic [6:0] select_1445;
  assign select_1445 = (sum_1440_s12_q < sum_1443_s12_q) ? sum_1443_s12_q : sum_1440_s12_q;
  // hls/stages/agreement.hpp:946
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2386;
  assign select_2386 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2387;
  assign select_2387 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2388;
  assign select_2388 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2389;
  assign select_2389 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2390;
  assign select_2390 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2391;
  assign select_2391 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/patches.hpp:79
  logic [3:0] select_2731;
  assign select_2731 = equal_2727_s12_q ? select_2730_s12_q : patches_choosing_rows_to_next_q;
  logic equal_2732;
  assign equal_2732 = select_2731 == 4'h0;
  // hls/stages/agreement.hpp:448
  logic [3:0] select_2735;
  assign select_2735 = equal_2286_s12_q ? (equal_2732 ? 4'h2 : (select_2731 + 4'hf)) : patches_choosing_rows_to_next_q;
  logic select_2743;
  assign select_2743 = equal_2286_s12_q ? (less_2741_s12_q & equal_2732) : patches_chooses_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      shift_not_right_q <= 1'b0;
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_chooses_q <= 1'b0;
    end else if (s12_en) begin
      shift_not_right_q <= $signed(run_shift_s12_q) < $signed(6'h1);
      patches_choosing_rows_to_next_q <= and_513_s12_q ? select_2735 : patches_choosing_rows_to_next_q;
      patches_chooses_q <= and_513_s12_q ? select_2743 : patches_chooses_q;
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
      middle_sum_columns_values_1_q <= select_2386;
      middle_sum_columns_values_2_q <= select_2387;
      middle_sum_columns_values_3_q <= select_2388;
      middle_sum_columns_values_4_q <= select_2389;
      middle_sum_columns_values_5_q <= select_2390;
      middle_sum_columns_values_6_q <= select_2391;
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
  logic shift_not_right_s13_q;
  logic [3:0] patches_choosing_rows_to_next_s13_q;
  logic patches_chooses_s13_q;
  logic [3:0] select_474_s13_q;
  logic equal_475_s13_q;
  logic [6:0] select_477_s13_q;
  logic [8:0] select_481_s13_q;
  logic and_487_s13_q;
  logic equal_493_s13_q;
  logic [6:0] column_s13_q;
  logic and_511_s13_q;
  logic and_513_s13_q;
  logic so_s13_q;
  logic equal_533_s13_q;
  logic or_534_s13_q;
  logic less_541_s13_q;
  logic not_542_s13_q;
  logic equal_574_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_660_s13_q;
  logic [6:0] difference_908_s13_q;
  logic [6:0] difference_1157_s13_q;
  logic equal_1158_s13_q;
  logic [6:0] difference_1406_s13_q;
  logic [6:0] sum_1436_s13_q;
  logic [6:0] select_1445_s13_q;
  logic and_1453_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1462_s13_q;
  logic equal_1471_s13_q;
  logic and_1478_s13_q;
  logic and_1481_s13_q;
  logic and_1485_s13_q;
  logic less_1486_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1499_s13_q;
  logic [6:0] select_1510_s13_q;
  logic and_1584_s13_q;
  logic equal_1590_s13_q;
  logic less_1611_s13_q;
  logic and_2016_s13_q;
  logic equal_2162_s13_q;
  logic equal_2286_s13_q;
  logic and_2598_s13_q;
  logic and_2600_s13_q;
  logic and_2607_s13_q;
  logic [3:0] phase_s13_q;
  logic equal_2727_s13_q;
  logic equal_2732_s13_q;
  logic not_2773_s13_q;
  logic less_3620_s13_q;
  logic equal_3825_s13_q;
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
      shift_not_right_s13_q <= shift_not_right_q;
      patches_choosing_rows_to_next_s13_q <= patches_choosing_rows_to_next_q;
      patches_chooses_s13_q <= patches_chooses_q;
      select_474_s13_q <= select_474_s12_q;
      equal_475_s13_q <= equal_475_s12_q;
      select_477_s13_q <= select_477_s12_q;
      select_481_s13_q <= select_481_s12_q;
      and_487_s13_q <= and_487_s12_q;
      equal_493_s13_q <= equal_493_s12_q;
      column_s13_q <= column_s12_q;
      and_511_s13_q <= and_511_s12_q;
      and_513_s13_q <= and_513_s12_q;
      so_s13_q <= so_s12_q;
      equal_533_s13_q <= equal_533_s12_q;
      or_534_s13_q <= or_534_s12_q;
      less_541_s13_q <= less_541_s12_q;
      not_542_s13_q <= not_542_s12_q;
      equal_574_s13_q <= equal_574_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_660_s13_q <= or_658 ? shift_first_s12_q : (~age_s12_q[1]);
      difference_908_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_907};
      difference_1157_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1156_s12_q};
      equal_1158_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1406_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1405_s12_q};
      sum_1436_s13_q <= {1'b0, before_v} + sum_1435;
      select_1445_s13_q <= select_1445;
      and_1453_s13_q <= and_1453_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1462_s13_q <= or_658 ? shift_first_s12_q : equal_1461_s12_q;
      equal_1471_s13_q <= equal_1471_s12_q;
      and_1478_s13_q <= and_1478_s12_q;
      and_1481_s13_q <= and_1481_s12_q;
      and_1485_s13_q <= and_1485_s12_q;
      less_1486_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1499_s13_q <= or_1499_s12_q;
      select_1510_s13_q <= select_1510_s12_q;
      and_1584_s13_q <= and_1584_s12_q;
      equal_1590_s13_q <= equal_1590_s12_q;
      less_1611_s13_q <= less_1611_s12_q;
      and_2016_s13_q <= and_2016_s12_q;
      equal_2162_s13_q <= equal_2162_s12_q;
      equal_2286_s13_q <= equal_2286_s12_q;
      and_2598_s13_q <= and_2598_s12_q;
      and_2600_s13_q <= and_2600_s12_q;
      and_2607_s13_q <= ends_cell_s12_q & so_s12_q;
      phase_s13_q <= phase_s12_q;
      equal_2727_s13_q <= equal_2727_s12_q;
      equal_2732_s13_q <= equal_2732;
      not_2773_s13_q <= not_2773_s12_q;
      less_3620_s13_q <= less_3620_s12_q;
      equal_3825_s13_q <= equal_3825_s12_q;
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
  // hls/stages/agreement.hpp:763
  logic [7:0] sum_910;
  assign sum_910 = {difference_908_s13_q[6], difference_908_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1160;
  assign sum_1160 = {difference_1157_s13_q[6], difference_1157_s13_q} + (equal_1158_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1408;
  assign sum_1408 = {difference_1406_s13_q[6], difference_1406_s13_q} + (equal_1158_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:740
  logic [6:0] select_1437;
  assign select_1437 = slot_s13_q[0] ? chosen_near_q : sum_1436_s13_q;
  // hls/stages/agreement.hpp:736
  logic [6:0] select_1447;
  assign select_1447 = (select_1437 < select_1445_s13_q) ? select_1445_s13_q : select_1437;
  // hls/stages/agreement.hpp:945
  logic select_1488;
  assign select_1488 = slot_s13_q[2] ? less_1486_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:952
  logic [8:0] difference_1491;
  assign difference_1491 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/census.hpp:31
  logic not_1588;
  assign not_1588 = ~sample_pair_first_s13_q;
  // hls/stages/patches.hpp:302
  logic equal_1592;
  assign equal_1592 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1660;
  assign select_1660 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1884;
  assign sum_1884 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2398;
  assign select_2398 = slot_s13_q[0] ? 7'h0 : sum_1436_s13_q;
  // hls/stages/agreement.hpp:736
  logic [6:0] select_2400;
  assign select_2400 = (select_2398 < select_1445_s13_q) ? select_1445_s13_q : select_2398;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2601;
  assign select_2601 = and_2600_s13_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2603;
  assign select_2603 = and_2598_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2601[15]}}, select_2601});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2604;
  assign select_2604 = and_2600_s13_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2604[15]}}, select_2604};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2606;
  assign select_2606 = and_2598_s13_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2607_s13_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:363
  logic and_2709;
  assign and_2709 = not_1588 & equal_1590_s13_q;
  logic [8:0] select_2710;
  assign select_2710 = and_2709 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s13_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2711;
  assign select_2711 = and_2709 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2712;
  assign select_2712 = sample_pair_first_s13_q ? select_2710 : select_2711;
  // hls/stages/patches.hpp:118
  logic [3:0] select_2713;
  assign select_2713 = and_1584_s13_q ? select_2712[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_2714;
  assign select_2714 = sample_pair_whole_s13_q ? select_2713 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2716;
  assign select_2716 = sample_pair_whole_s13_q ? (and_1584_s13_q ? select_2712[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2719;
  assign select_2719 = sample_pair_whole_s13_q ? (equal_1592 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2721;
  assign select_2721 = sample_pair_whole_s13_q ? (patches_band_rows_number_q + {4'h0, equal_1592}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:321
  logic equal_2722;
  assign equal_2722 = phase_s13_q == 4'h0;
  // hls/stages/patches.hpp:322
  logic not_2723;
  assign not_2723 = ~equal_2722;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_2725;
  assign select_2725 = sample_pair_whole_s13_q ? (phase_s13_q + {{2{not_2723}}, 1'b1, not_2723}) : patches_first_band_rows_to_next_q;
  logic select_2726;
  assign select_2726 = sample_pair_whole_s13_q ? equal_2722 : patches_first_band_number_q;
  // hls/stages/patches.hpp:79
  logic [4:0] select_2737;
  assign select_2737 = equal_2727_s13_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:448
  logic [4:0] select_2739;
  assign select_2739 = equal_2286_s13_q ? (select_2737 + {4'h0, equal_2732_s13_q}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:508
  logic [4:0] select_2746;
  assign select_2746 = and_513_s13_q ? (equal_2286_s13_q ? select_2737 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3632;
  assign select_3632 = so_s13_q ? (and_2607_s13_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3634;
  assign sum_3634 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3635;
  assign select_3635 = sum_1884[5] ? {1'b1, sum_1884[4:0], region_across_rest_q[2:0]} : sum_3634;
  // hls/stages/agreement.hpp:448
  logic [8:0] select_3637;
  assign select_3637 = equal_2286_s13_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3640;
  assign select_3640 = equal_2286_s13_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

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
      chosen_near_q <= select_2400;
      registration_slope_row_q <= select_2603;
      registration_slope_change_q <= select_2606;
      registration_slope_q <= so_s13_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2714;
      patches_band_rows_number_q <= select_2716;
      patches_next_band_rows_to_next_q <= select_2719;
      patches_next_band_number_q <= select_2721;
      patches_first_band_rows_to_next_q <= select_2725;
      patches_first_band_number_q <= select_2726;
      patches_choosing_number_q <= and_513_s13_q ? select_2739 : patches_choosing_number_q;
      patches_choosing_band_q <= select_2746;
      region_across_rest_q <= select_3632;
      region_across_back_q <= so_s13_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3635;
      columns_begin_rest_q <= and_513_s13_q ? select_3637 : columns_begin_rest_q;
      columns_begin_back_q <= and_513_s13_q ? select_3640 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_910;
      sums_0_sum_sums_values_0_q <= sum_1160;
      sums_0_sum_sums_values_1_q <= equal_1158_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1408;
      sums_1_sum_sums_values_1_q <= equal_1158_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic shift_not_right_s14_q;
  logic [11:0] registration_slope_s14_q;
  logic [4:0] patches_band_rows_number_s14_q;
  logic patches_chooses_s14_q;
  logic [4:0] patches_choosing_band_s14_q;
  logic [3:0] select_474_s14_q;
  logic equal_475_s14_q;
  logic [6:0] select_477_s14_q;
  logic [8:0] select_481_s14_q;
  logic and_487_s14_q;
  logic equal_493_s14_q;
  logic [6:0] column_s14_q;
  logic and_511_s14_q;
  logic and_513_s14_q;
  logic so_s14_q;
  logic equal_533_s14_q;
  logic or_534_s14_q;
  logic less_541_s14_q;
  logic not_542_s14_q;
  logic equal_574_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_660_s14_q;
  logic [7:0] sum_910_s14_q;
  logic less_1409_s14_q;
  logic [6:0] select_1447_s14_q;
  logic and_1453_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1462_s14_q;
  logic equal_1471_s14_q;
  logic and_1478_s14_q;
  logic and_1481_s14_q;
  logic and_1485_s14_q;
  logic select_1488_s14_q;
  logic [9:0] sum_1492_s14_q;
  logic or_1499_s14_q;
  logic [6:0] select_1510_s14_q;
  logic and_1584_s14_q;
  logic not_1588_s14_q;
  logic or_1594_s14_q;
  logic less_1611_s14_q;
  logic [16:0] select_1660_s14_q;
  logic sum_1884_s14_q;
  logic and_2016_s14_q;
  logic equal_2162_s14_q;
  logic equal_2286_s14_q;
  logic not_2773_s14_q;
  logic less_3620_s14_q;
  logic equal_3825_s14_q;
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
      shift_not_right_s14_q <= shift_not_right_s13_q;
      registration_slope_s14_q <= registration_slope_q[27:16];
      patches_band_rows_number_s14_q <= patches_band_rows_number_q;
      patches_chooses_s14_q <= patches_chooses_s13_q;
      patches_choosing_band_s14_q <= patches_choosing_band_q;
      select_474_s14_q <= select_474_s13_q;
      equal_475_s14_q <= equal_475_s13_q;
      select_477_s14_q <= select_477_s13_q;
      select_481_s14_q <= select_481_s13_q;
      and_487_s14_q <= and_487_s13_q;
      equal_493_s14_q <= equal_493_s13_q;
      column_s14_q <= column_s13_q;
      and_511_s14_q <= and_511_s13_q;
      and_513_s14_q <= and_513_s13_q;
      so_s14_q <= so_s13_q;
      equal_533_s14_q <= equal_533_s13_q;
      or_534_s14_q <= or_534_s13_q;
      less_541_s14_q <= less_541_s13_q;
      not_542_s14_q <= not_542_s13_q;
      equal_574_s14_q <= equal_574_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_660_s14_q <= select_660_s13_q;
      sum_910_s14_q <= sum_910;
      less_1409_s14_q <= sum_1160 < sum_1408;
      select_1447_s14_q <= select_1447;
      and_1453_s14_q <= and_1453_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1462_s14_q <= select_1462_s13_q;
      equal_1471_s14_q <= equal_1471_s13_q;
      and_1478_s14_q <= and_1478_s13_q;
      and_1481_s14_q <= and_1481_s13_q;
      and_1485_s14_q <= and_1485_s13_q;
      select_1488_s14_q <= select_1488;
      sum_1492_s14_q <= {difference_1491[8], difference_1491} + 10'h1;
      or_1499_s14_q <= or_1499_s13_q;
      select_1510_s14_q <= select_1510_s13_q;
      and_1584_s14_q <= and_1584_s13_q;
      not_1588_s14_q <= not_1588;
      or_1594_s14_q <= (~equal_1590_s13_q) | (~equal_1592);
      less_1611_s14_q <= less_1611_s13_q;
      select_1660_s14_q <= select_1660;
      sum_1884_s14_q <= sum_1884[5];
      and_2016_s14_q <= and_2016_s13_q;
      equal_2162_s14_q <= equal_2162_s13_q;
      equal_2286_s14_q <= equal_2286_s13_q;
      not_2773_s14_q <= not_2773_s13_q;
      less_3620_s14_q <= less_3620_s13_q;
      equal_3825_s14_q <= equal_3825_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [7:0] chosen_score_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  logic shift_allowed_q;
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
  // hls/stages/agreement.hpp:740
  logic [7:0] select_911;
  assign select_911 = slot_s14_q[0] ? chosen_score_q : sum_910_s14_q;
  // hls/stages/agreement.hpp:736
  logic [7:0] select_1410;
  assign select_1410 = less_1409_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1411;
  assign less_1411 = select_911 < select_1410;
  // hls/stages/agreement.hpp:786
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1411 ? select_1410 : select_911) : 8'h0;
  // hls/stages/agreement.hpp:705
  logic not_1417;
  assign not_1417 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:737
  logic [1:0] select_1418;
  assign select_1418 = less_1409_s14_q ? {slot_s14_q[0], not_1417} : 2'h0;
  logic [2:0] select_1420;
  assign select_1420 = less_1411 ? {select_1418, not_1417} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:787
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1447_s14_q : 7'h0;
  // hls/stages/agreement.hpp:235
  logic and_1494;
  assign and_1494 = (and_1481_s14_q & select_1488_s14_q) & ({{22{sum_1492_s14_q[9]}}, sum_1492_s14_q} < 32'h3);
  // hls/stages/patches.hpp:382
  logic not_1585;
  assign not_1585 = ~patches_begins_q;
  // hls/stages/patches.hpp:352
  logic and_1589;
  assign and_1589 = patches_capturing_q & not_1588_s14_q;
  // hls/stages/patches.hpp:117
  logic and_1597;
  assign and_1597 = (not_1585 & (patches_work_q == 3'h0)) & (~(and_1589 | or_1594_s14_q));
  // hls/stages/registration.hpp:218
  logic [13:0] select_1662;
  assign select_1662 = ($signed(10'h0) < $signed(select_1660_s14_q[16:7])) ? 14'h7f : select_1660_s14_q[13:0];
  // hls/stages/patches.hpp:520
  logic equal_1692;
  assign equal_1692 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:491
  logic equal_1694;
  assign equal_1694 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:485
  logic equal_1696;
  assign equal_1696 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:159
  logic equal_1697;
  assign equal_1697 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:520
  logic or_1698;
  assign or_1698 = equal_1696 | equal_1697;
  // hls/stages/patches.hpp:446
  logic not_1699;
  assign not_1699 = ~patches_second_q;
  // hls/stages/patches.hpp:363
  logic [4:0] select_1721;
  assign select_1721 = and_1597 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:118
  logic [4:0] select_1722;
  assign select_1722 = and_1584_s14_q ? select_1721 : patches_row_q;
  // hls/stages/patches.hpp:117
  logic and_1724;
  assign and_1724 = and_1589 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:118
  logic select_1728;
  assign select_1728 = and_1584_s14_q ? (and_1597 | (and_1589 & (~and_1724))) : patches_capturing_q;
  // hls/stages/patches.hpp:159
  logic not_1753;
  assign not_1753 = ~equal_1697;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_1767;
  assign select_1767 = and_1584_s14_q ? {select_1721[4], select_1721[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:532
  logic less_1853;
  assign less_1853 = patches_step_q[4:0] < 5'h11;
  logic equal_1854;
  assign equal_1854 = patches_step_q[6:5] == 2'h0;
  logic not_1855;
  assign not_1855 = ~equal_1854;
  logic equal_1856;
  assign equal_1856 = patches_step_q[6:5] == 2'h3;
  logic not_1857;
  assign not_1857 = ~equal_1856;
  // hls/stages/patches.hpp:546
  logic select_1860;
  assign select_1860 = equal_1856 ? (less_1853 & (less_1853 & not_1857)) : less_1853;
  // hls/stages/agreement.hpp:227
  logic [7:0] select_2395;
  assign select_2395 = slot_s14_q[0] ? 8'h0 : sum_910_s14_q;
  // hls/stages/agreement.hpp:736
  logic less_2396;
  assign less_2396 = select_2395 < select_1410;
  // hls/stages/agreement.hpp:773
  logic less_2402;
  assign less_2402 = $signed(run_shift_s14_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2404;
  assign less_2404 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s14_q);
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2499;
  assign select_2499 = or_534_s14_q ? (less_541_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2501;
  assign select_2501 = or_534_s14_q ? (less_541_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:383
  logic or_2814;
  assign or_2814 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:385
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:179
  logic and_2820;
  assign and_2820 = equal_1692 & not_1699;
  // hls/stages/patches.hpp:389
  logic and_2821;
  assign and_2821 = not_1753 & and_2820;
  logic [1:0] select_2823;
  assign select_2823 = equal_1694 ? 2'h0 : (equal_1696 ? 2'h3 : {equal_1697, and_2821});
  // hls/stages/patches.hpp:270
  logic equal_2825;
  assign equal_2825 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:268
  logic not_2826;
  assign not_2826 = ~equal_2825;
  // hls/stages/patches.hpp:270
  logic equal_2827;
  assign equal_2827 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:266
  logic not_2828;
  assign not_2828 = ~equal_2827;
  // hls/stages/patches.hpp:274
  logic not_2830;
  assign not_2830 = ~(patches_following_q == 3'h2);
  logic and_2833;
  assign and_2833 = (~(patches_following_q == 3'h1)) & not_2830;
  // hls/stages/patches.hpp:387
  logic [1:0] select_2834;
  assign select_2834 = equal_2827 ? 2'h2 : {and_2833, not_2830};
  logic [3:0] select_2835;
  assign select_2835 = equal_2825 ? 4'h2 : {select_2834, {2{not_2828}}};
  // hls/stages/patches.hpp:395
  logic not_2838;
  assign not_2838 = ~or_2814;
  // hls/stages/patches.hpp:384
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:396
  logic [11:0] select_2843;
  assign select_2843 = or_2814 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_score_q <= 8'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      shift_allowed_q <= 1'b0;
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
      chosen_score_q <= less_2396 ? select_1410 : select_2395;
      chosen_place_q <= less_2396 ? {select_1418, not_1417} : 3'h2;
      before_0_q <= select_2395;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2402) & (~less_2404);
      patches_capturing_q <= sample_pair_whole_s14_q ? select_1728 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s14_q ? select_1722 : patches_row_q;
      patches_work_q <= or_2814 ? following : patches_work_q;
      patches_second_q <= not_1585 & (patches_second_q | (patches_ends_q & equal_1692));
      patches_following_q <= equal_1692 ? {2'h0, and_2820} : {equal_1694, select_2823};
      patches_following_beats_q <= {select_2835, not_2826};
      patches_begins_q <= sample_pair_whole_s14_q & (and_1584_s14_q & and_1724);
      patches_ends_q <= not_2838 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2843;
      patches_step_q <= or_2814 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic shift_not_right_s15_q;
  logic [11:0] registration_slope_s15_q;
  logic [4:0] patches_band_rows_number_s15_q;
  logic patches_chooses_s15_q;
  logic [4:0] patches_choosing_band_s15_q;
  logic patches_second_s15_q;
  logic [4:0] patches_step_s15_q;
  logic [3:0] select_474_s15_q;
  logic equal_475_s15_q;
  logic [6:0] select_477_s15_q;
  logic [8:0] select_481_s15_q;
  logic and_487_s15_q;
  logic equal_493_s15_q;
  logic [6:0] column_s15_q;
  logic and_511_s15_q;
  logic and_513_s15_q;
  logic so_s15_q;
  logic equal_533_s15_q;
  logic or_534_s15_q;
  logic less_541_s15_q;
  logic not_542_s15_q;
  logic equal_574_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_660_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1420_s15_q;
  logic [6:0] of_near_s15_q;
  logic or_1450_s15_q;
  logic and_1453_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1462_s15_q;
  logic or_1468_s15_q;
  logic equal_1471_s15_q;
  logic and_1478_s15_q;
  logic and_1482_s15_q;
  logic and_1485_s15_q;
  logic and_1495_s15_q;
  logic and_1500_s15_q;
  logic [8:0] select_1502_s15_q;
  logic [6:0] select_1510_s15_q;
  logic and_1584_s15_q;
  logic and_1597_s15_q;
  logic less_1611_s15_q;
  logic [13:0] select_1662_s15_q;
  logic equal_1692_s15_q;
  logic equal_1694_s15_q;
  logic equal_1696_s15_q;
  logic equal_1697_s15_q;
  logic or_1698_s15_q;
  logic and_1701_s15_q;
  logic [4:0] select_1722_s15_q;
  logic select_1728_s15_q;
  logic and_1734_s15_q;
  logic and_1754_s15_q;
  logic [3:0] select_1767_s15_q;
  logic less_1853_s15_q;
  logic equal_1854_s15_q;
  logic not_1855_s15_q;
  logic equal_1856_s15_q;
  logic not_1857_s15_q;
  logic select_1860_s15_q;
  logic and_1861_s15_q;
  logic sum_1884_s15_q;
  logic and_2016_s15_q;
  logic equal_2162_s15_q;
  logic equal_2286_s15_q;
  logic [7:0] select_2499_s15_q;
  logic [7:0] select_2501_s15_q;
  logic not_2773_s15_q;
  logic or_2814_s15_q;
  logic not_2838_s15_q;
  logic and_3310_s15_q;
  logic equal_3317_s15_q;
  logic less_3620_s15_q;
  logic equal_3825_s15_q;
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
      shift_not_right_s15_q <= shift_not_right_s14_q;
      registration_slope_s15_q <= registration_slope_s14_q;
      patches_band_rows_number_s15_q <= patches_band_rows_number_s14_q;
      patches_chooses_s15_q <= patches_chooses_s14_q;
      patches_choosing_band_s15_q <= patches_choosing_band_s14_q;
      patches_second_s15_q <= patches_second_q;
      patches_step_s15_q <= patches_step_q[4:0];
      select_474_s15_q <= select_474_s14_q;
      equal_475_s15_q <= equal_475_s14_q;
      select_477_s15_q <= select_477_s14_q;
      select_481_s15_q <= select_481_s14_q;
      and_487_s15_q <= and_487_s14_q;
      equal_493_s15_q <= equal_493_s14_q;
      column_s15_q <= column_s14_q;
      and_511_s15_q <= and_511_s14_q;
      and_513_s15_q <= and_513_s14_q;
      so_s15_q <= so_s14_q;
      equal_533_s15_q <= equal_533_s14_q;
      or_534_s15_q <= or_534_s14_q;
      less_541_s15_q <= less_541_s14_q;
      not_542_s15_q <= not_542_s14_q;
      equal_574_s15_q <= equal_574_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_660_s15_q <= select_660_s14_q;
      of_best_s15_q <= of_best;
      select_1420_s15_q <= select_1420;
      of_near_s15_q <= of_near;
      or_1450_s15_q <= select_660_s14_q | (best_left_rdata_s14_q[39:33] < of_near);
      and_1453_s15_q <= and_1453_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1462_s15_q <= select_1462_s14_q;
      or_1468_s15_q <= select_1462_s14_q | (best_right_rdata_s14_q[21:15] < of_near);
      equal_1471_s15_q <= equal_1471_s14_q;
      and_1478_s15_q <= and_1478_s14_q;
      and_1482_s15_q <= not_542_s14_q & and_1481_s14_q;
      and_1485_s15_q <= and_1485_s14_q;
      and_1495_s15_q <= not_542_s14_q & and_1494;
      and_1500_s15_q <= and_1494 & or_1499_s14_q;
      select_1502_s15_q <= less_541_s14_q ? 9'h0 : best_left_rdata_s14_q[8:0];
      select_1510_s15_q <= select_1510_s14_q;
      and_1584_s15_q <= and_1584_s14_q;
      and_1597_s15_q <= and_1597;
      less_1611_s15_q <= less_1611_s14_q;
      select_1662_s15_q <= select_1662;
      equal_1692_s15_q <= equal_1692;
      equal_1694_s15_q <= equal_1694;
      equal_1696_s15_q <= equal_1696;
      equal_1697_s15_q <= equal_1697;
      or_1698_s15_q <= or_1698;
      and_1701_s15_q <= or_1698 & (equal_1697 & not_1699);
      select_1722_s15_q <= select_1722;
      select_1728_s15_q <= select_1728;
      and_1734_s15_q <= or_1698 & (patches_second_q & equal_1697);
      and_1754_s15_q <= not_1753 & or_1698;
      select_1767_s15_q <= select_1767;
      less_1853_s15_q <= less_1853;
      equal_1854_s15_q <= equal_1854;
      not_1855_s15_q <= not_1855;
      equal_1856_s15_q <= equal_1856;
      not_1857_s15_q <= not_1857;
      select_1860_s15_q <= select_1860;
      and_1861_s15_q <= not_1855 & select_1860;
      sum_1884_s15_q <= sum_1884_s14_q;
      and_2016_s15_q <= and_2016_s14_q;
      equal_2162_s15_q <= equal_2162_s14_q;
      equal_2286_s15_q <= equal_2286_s14_q;
      select_2499_s15_q <= select_2499;
      select_2501_s15_q <= select_2501;
      not_2773_s15_q <= not_2773_s14_q;
      or_2814_s15_q <= or_2814;
      not_2838_s15_q <= not_2838;
      and_3310_s15_q <= less_1853 & (patches_step_q[6:5] == 2'h1);
      equal_3317_s15_q <= patches_step_q[6:5] == 2'h2;
      less_3620_s15_q <= less_3620_s14_q;
      equal_3825_s15_q <= equal_3825_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [15:0] patches_chance_q;
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:795
  logic equal_1423;
  assign equal_1423 = select_1420_s15_q == 3'h1;
  logic or_1426;
  assign or_1426 = equal_1423 | (~(select_1420_s15_q == 3'h2));
  logic [7:0] select_1428;
  assign select_1428 = or_1426 ? before_0_s15_q : before_1_s15_q;
  logic [7:0] select_1429;
  assign select_1429 = equal_1423 ? (or_1426 ? before_1_q : {7'h0, shift_not_right_s15_q}) : select_1428;
  // hls/stages/agreement.hpp:796
  logic [7:0] select_1432;
  assign select_1432 = equal_1423 ? select_1428 : (or_1426 ? before_2_q : before_2_s15_q);
  // hls/stages/agreement.hpp:807
  logic or_1464;
  assign or_1464 = select_1462_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:235
  logic and_1501;
  assign and_1501 = not_542_s15_q & and_1500_s15_q;
  // hls/stages/agreement.hpp:141
  logic [14:0] shift_2;
  assign shift_2 = or_534_s15_q ? {select_1502_s15_q, and_1501, and_1495_s15_q, and_1485_s15_q, and_1482_s15_q, and_1478_s15_q, not_542_s15_q} : 15'h0;
  // hls/stages/patches.hpp:95
  logic right_3;
  assign right_3 = {2'h0, last_s15_q[6:1]} < x_s15_q;
  // hls/stages/registration.hpp:213
  logic [9:0] select_1663;
  assign select_1663 = shift_2[10] ? select_1662_s15_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1668;
  assign sum_1668 = (shift_2[6] ? select_1662_s15_q[13:1] : 13'h0) + (shift_2[7] ? select_1662_s15_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1669;
  assign select_1669 = shift_2[8] ? select_1662_s15_q[11:0] : 12'h0;
  logic [10:0] sum_1671;
  assign sum_1671 = select_1669[11:1] + (shift_2[9] ? select_1662_s15_q[10:0] : 11'h0);
  // hls/stages/patches.hpp:498
  logic not_1693;
  assign not_1693 = ~equal_1692_s15_q;
  // hls/stages/patches.hpp:444
  logic not_1695;
  assign not_1695 = ~equal_1694_s15_q;
  logic and_1777;
  assign and_1777 = not_1693 & (or_1698_s15_q & not_1695);
  // hls/stages/patches.hpp:176
  logic and_1863;
  assign and_1863 = equal_1692_s15_q & (less_1853_s15_q ? and_1861_s15_q : select_1860_s15_q);
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2497;
  assign select_2497 = or_534_s15_q ? (less_541_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2499_s15_q} - {1'b0, select_2501_s15_q};
  // hls/stages/patches.hpp:83
  logic parity_2750;
  assign parity_2750 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:448
  logic [15:0] select_2751;
  assign select_2751 = equal_2286_s15_q ? {patches_chance_q[14:0], parity_2750} : patches_chance_q;
  // hls/stages/patches.hpp:100
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:101
  logic [5:0] further;
  assign further = last_s15_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:118
  logic select_2775;
  assign select_2775 = and_1584_s15_q ? (and_1597_s15_q ? not_2773_s15_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:179
  logic [4:0] select_2845;
  assign select_2845 = or_2814_s15_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:543
  logic select_3312;
  assign select_3312 = less_1853_s15_q ? (not_1857_s15_q & and_3310_s15_q) : and_3310_s15_q;
  // hls/stages/patches.hpp:546
  logic select_3313;
  assign select_3313 = equal_1856_s15_q ? select_3312 : and_3310_s15_q;

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
  assign patches_right_0_re = s15_en & (not_1693 & (not_1695 & and_1701_s15_q));
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
  assign patches_right_1_re = s15_en & (not_1693 & (not_1695 & and_1734_s15_q));
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
  assign patches_columns_above_re = s15_en & and_1777;
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
  assign patches_rows_re = s15_en & and_1863;
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
      patches_chance_q <= and_513_s15_q ? select_2751 : patches_chance_q;
      patches_lower_q <= sample_pair_whole_s15_q ? select_2775 : patches_lower_q;
      patches_code_row_q <= select_2845;
      patches_column_q <= or_2814_s15_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2838_s15_q & (patches_column_q == 5'h1e);
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
  logic [3:0] select_474_s16_q;
  logic equal_475_s16_q;
  logic [6:0] select_477_s16_q;
  logic [8:0] select_481_s16_q;
  logic and_487_s16_q;
  logic equal_493_s16_q;
  logic [6:0] column_s16_q;
  logic and_511_s16_q;
  logic and_513_s16_q;
  logic so_s16_q;
  logic equal_574_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1415_s16_q;
  logic [2:0] select_1420_s16_q;
  logic [7:0] select_1429_s16_q;
  logic [7:0] select_1432_s16_q;
  logic [6:0] select_1451_s16_q;
  logic [5:0] select_1452_s16_q;
  logic and_1453_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1464_s16_q;
  logic [6:0] select_1469_s16_q;
  logic [6:0] select_1470_s16_q;
  logic equal_1471_s16_q;
  logic [13:0] shift_2_s16_q;
  logic [6:0] select_1510_s16_q;
  logic and_1513_s16_q;
  logic and_1584_s16_q;
  logic and_1597_s16_q;
  logic right_3_s16_q;
  logic less_1611_s16_q;
  logic select_1663_s16_q;
  logic [8:0] difference_1665_s16_q;
  logic [11:0] sum_1668_s16_q;
  logic select_1669_s16_q;
  logic [10:0] sum_1671_s16_q;
  logic equal_1692_s16_q;
  logic not_1693_s16_q;
  logic equal_1694_s16_q;
  logic not_1695_s16_q;
  logic equal_1696_s16_q;
  logic equal_1697_s16_q;
  logic or_1698_s16_q;
  logic [4:0] select_1722_s16_q;
  logic select_1728_s16_q;
  logic and_1756_s16_q;
  logic [3:0] select_1767_s16_q;
  logic and_1777_s16_q;
  logic less_1853_s16_q;
  logic equal_1854_s16_q;
  logic not_1855_s16_q;
  logic equal_1856_s16_q;
  logic not_1857_s16_q;
  logic sum_1884_s16_q;
  logic textured_s16_q;
  logic and_2016_s16_q;
  logic equal_2162_s16_q;
  logic equal_2286_s16_q;
  logic [7:0] select_2497_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2503_s16_q;
  logic [7:0] xor_2508_s16_q;
  logic less_2532_s16_q;
  logic [5:0] further_s16_q;
  logic or_2814_s16_q;
  logic not_2838_s16_q;
  logic select_3315_s16_q;
  logic equal_3317_s16_q;
  logic less_3620_s16_q;
  logic equal_3825_s16_q;
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
      select_474_s16_q <= select_474_s15_q;
      equal_475_s16_q <= equal_475_s15_q;
      select_477_s16_q <= select_477_s15_q;
      select_481_s16_q <= select_481_s15_q;
      and_487_s16_q <= and_487_s15_q;
      equal_493_s16_q <= equal_493_s15_q;
      column_s16_q <= column_s15_q;
      and_511_s16_q <= and_511_s15_q;
      and_513_s16_q <= and_513_s15_q;
      so_s16_q <= so_s15_q;
      equal_574_s16_q <= equal_574_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1415_s16_q <= select_660_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1420_s16_q <= select_1420_s15_q;
      select_1429_s16_q <= select_1429;
      select_1432_s16_q <= select_1432;
      select_1451_s16_q <= or_1450_s15_q ? of_near_s15_q : best_left_rdata_s15_q[39:33];
      select_1452_s16_q <= or_1450_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      and_1453_s16_q <= and_1453_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1464_s16_q <= or_1464;
      select_1469_s16_q <= or_1468_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1470_s16_q <= or_1468_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1471_s16_q <= equal_1471_s15_q;
      shift_2_s16_q <= {shift_2[14:3], shift_2[1:0]};
      select_1510_s16_q <= select_1510_s15_q;
      and_1513_s16_q <= equal_533_s15_q & shift_2[4];
      and_1584_s16_q <= and_1584_s15_q;
      and_1597_s16_q <= and_1597_s15_q;
      right_3_s16_q <= right_3;
      less_1611_s16_q <= less_1611_s15_q;
      select_1663_s16_q <= select_1663[0];
      difference_1665_s16_q <= select_1663[9:1] - (shift_2[11] ? select_1662_s15_q[8:0] : 9'h0);
      sum_1668_s16_q <= sum_1668[12:1];
      select_1669_s16_q <= select_1669[0];
      sum_1671_s16_q <= sum_1671;
      equal_1692_s16_q <= equal_1692_s15_q;
      not_1693_s16_q <= not_1693;
      equal_1694_s16_q <= equal_1694_s15_q;
      not_1695_s16_q <= not_1695;
      equal_1696_s16_q <= equal_1696_s15_q;
      equal_1697_s16_q <= equal_1697_s15_q;
      or_1698_s16_q <= or_1698_s15_q;
      select_1722_s16_q <= select_1722_s15_q;
      select_1728_s16_q <= select_1728_s15_q;
      and_1756_s16_q <= not_1693 & (not_1695 & and_1754_s15_q);
      select_1767_s16_q <= select_1767_s15_q;
      and_1777_s16_q <= and_1777;
      less_1853_s16_q <= less_1853_s15_q;
      equal_1854_s16_q <= equal_1854_s15_q;
      not_1855_s16_q <= not_1855_s15_q;
      equal_1856_s16_q <= equal_1856_s15_q;
      not_1857_s16_q <= not_1857_s15_q;
      sum_1884_s16_q <= sum_1884_s15_q;
      textured_s16_q <= textured;
      and_2016_s16_q <= and_2016_s15_q;
      equal_2162_s16_q <= equal_2162_s15_q;
      equal_2286_s16_q <= equal_2286_s15_q;
      select_2497_s16_q <= select_2497;
      rise_s16_q <= rise[8];
      select_2503_s16_q <= rise[8] ? select_2499_s15_q : select_2501_s15_q;
      xor_2508_s16_q <= rise[7:0] ^ {8{rise[8]}};
      less_2532_s16_q <= select_2499_s15_q < select_2501_s15_q;
      further_s16_q <= further;
      or_2814_s16_q <= or_2814_s15_q;
      not_2838_s16_q <= not_2838_s15_q;
      select_3315_s16_q <= less_1853_s15_q ? (not_1855_s15_q & select_3313) : select_3313;
      equal_3317_s16_q <= equal_3317_s15_q;
      less_3620_s16_q <= less_3620_s15_q;
      equal_3825_s16_q <= equal_3825_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/agreement.hpp:965
  logic not_1472;
  assign not_1472 = ~equal_1471_s16_q;
  // hls/stages/agreement.hpp:773
  logic and_1504;
  assign and_1504 = ends_cell_s16_q & shift_2_s16_q[0];
  logic and_1506;
  assign and_1506 = not_1472 & (so_s16_q & and_1504);
  // hls/stages/agreement.hpp:965
  logic [5:0] sum_1556;
  assign sum_1556 = {1'b0, last_s16_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s16_q[0] & ({1'b0, sum_1556, last_s16_q[1]} < x_s16_q);
  // hls/stages/patches.hpp:94
  logic [9:0] sum_1639;
  assign sum_1639 = {2'h0, x_s16_q} + {{4{shift_2_s16_q[10]}}, shift_2_s16_q[10:5]};
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1672;
  assign sum_1672 = sum_1668_s16_q + {sum_1671_s16_q, select_1669_s16_q};
  logic [9:0] sum_1673;
  assign sum_1673 = {difference_1665_s16_q, select_1663_s16_q} + sum_1672[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2504;
  assign difference_2504 = {1'b0, select_2497_s16_q} - {1'b0, select_2503_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2504[8] ? 8'h0 : difference_2504[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2508_s16_q};
  // hls/stages/patches.hpp:102
  logic [5:0] select_2756;
  assign select_2756 = right_3_s16_q ? last_s16_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s16_q} + {1'b0, select_2756};

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1310; read in stage 16, written in stage 17: 16 < 17 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s16_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s16_en & and_1506;
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
  assign patches_left_re = s16_en & and_1756_s16_q;
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1337; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s16_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s16_en & and_1506;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s16_en) begin
      patches_read_searches_q <= equal_1692_s16_q ? select_3315_s16_q : patches_read_searches_q;
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
  logic [3:0] select_474_s17_q;
  logic equal_475_s17_q;
  logic [6:0] select_477_s17_q;
  logic [8:0] select_481_s17_q;
  logic and_487_s17_q;
  logic equal_493_s17_q;
  logic [6:0] column_s17_q;
  logic and_511_s17_q;
  logic and_513_s17_q;
  logic so_s17_q;
  logic equal_574_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1416_s17_q;
  logic [2:0] select_1421_s17_q;
  logic [7:0] select_1422_s17_q;
  logic [7:0] select_1430_s17_q;
  logic [7:0] select_1433_s17_q;
  logic [6:0] select_1451_s17_q;
  logic [5:0] select_1452_s17_q;
  logic and_1453_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1465_s17_q;
  logic [6:0] select_1466_s17_q;
  logic [6:0] select_1469_s17_q;
  logic [6:0] select_1470_s17_q;
  logic equal_1471_s17_q;
  logic not_1472_s17_q;
  logic [13:0] shift_2_s17_q;
  logic and_1506_s17_q;
  logic [6:0] select_1510_s17_q;
  logic and_1515_s17_q;
  logic right_2_s17_q;
  logic and_1584_s17_q;
  logic and_1597_s17_q;
  logic right_3_s17_q;
  logic less_1611_s17_q;
  logic less_1630_s17_q;
  logic not_1635_s17_q;
  logic less_1640_s17_q;
  logic less_1641_s17_q;
  logic [7:0] sum_1673_s17_q;
  logic equal_1685_s17_q;
  logic equal_1692_s17_q;
  logic not_1693_s17_q;
  logic equal_1694_s17_q;
  logic not_1695_s17_q;
  logic equal_1696_s17_q;
  logic equal_1697_s17_q;
  logic or_1698_s17_q;
  logic [7:0] patches_right_0_rdata_s17_q;
  logic [4:0] select_1722_s17_q;
  logic select_1728_s17_q;
  logic [7:0] patches_right_1_rdata_s17_q;
  logic [3:0] select_1767_s17_q;
  logic and_1777_s17_q;
  logic [31:0] patches_columns_above_rdata_s17_q;
  logic less_1853_s17_q;
  logic equal_1854_s17_q;
  logic not_1855_s17_q;
  logic equal_1856_s17_q;
  logic not_1857_s17_q;
  logic [14:0] patches_rows_rdata_s17_q;
  logic sum_1884_s17_q;
  logic textured_s17_q;
  logic and_2019_s17_q;
  logic equal_2162_s17_q;
  logic equal_2286_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] size_3_s17_q;
  logic less_2532_s17_q;
  logic not_2759_s17_q;
  logic or_2814_s17_q;
  logic not_2838_s17_q;
  logic equal_3317_s17_q;
  logic less_3620_s17_q;
  logic equal_3825_s17_q;
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
      select_474_s17_q <= select_474_s16_q;
      equal_475_s17_q <= equal_475_s16_q;
      select_477_s17_q <= select_477_s16_q;
      select_481_s17_q <= select_481_s16_q;
      and_487_s17_q <= and_487_s16_q;
      equal_493_s17_q <= equal_493_s16_q;
      column_s17_q <= column_s16_q;
      and_511_s17_q <= and_511_s16_q;
      and_513_s17_q <= and_513_s16_q;
      so_s17_q <= so_s16_q;
      equal_574_s17_q <= equal_574_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1416_s17_q <= or_1415_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1421_s17_q <= or_1415_s16_q ? select_1420_s16_q : best_left_rdata_s16_q[8:6];
      select_1422_s17_q <= or_1415_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1430_s17_q <= or_1415_s16_q ? select_1429_s16_q : best_left_rdata_s16_q[24:17];
      select_1433_s17_q <= or_1415_s16_q ? select_1432_s16_q : best_left_rdata_s16_q[32:25];
      select_1451_s17_q <= select_1451_s16_q;
      select_1452_s17_q <= select_1452_s16_q;
      and_1453_s17_q <= and_1453_s16_q;
      right_s17_q <= right_s16_q;
      select_1465_s17_q <= or_1464_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1466_s17_q <= or_1464_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1469_s17_q <= select_1469_s16_q;
      select_1470_s17_q <= select_1470_s16_q;
      equal_1471_s17_q <= equal_1471_s16_q;
      not_1472_s17_q <= not_1472;
      shift_2_s17_q <= shift_2_s16_q;
      and_1506_s17_q <= and_1506;
      select_1510_s17_q <= select_1510_s16_q;
      and_1515_s17_q <= not_1472 & (so_s16_q ? and_1504 : and_1513_s16_q);
      right_2_s17_q <= right_2;
      and_1584_s17_q <= and_1584_s16_q;
      and_1597_s17_q <= and_1597_s16_q;
      right_3_s17_q <= right_3_s16_q;
      less_1611_s17_q <= less_1611_s16_q;
      less_1630_s17_q <= {3'h0, last_s16_q[6:1]} < ({1'b0, x_s16_q} + 9'h1);
      not_1635_s17_q <= ~(x_s16_q < {1'b0, last_s16_q});
      less_1640_s17_q <= $signed(10'h0) < $signed(sum_1639);
      less_1641_s17_q <= $signed(sum_1639) < $signed({3'h0, last_s16_q});
      sum_1673_s17_q <= sum_1673[9:2];
      equal_1685_s17_q <= x_s16_q == {1'b0, last_s16_q};
      equal_1692_s17_q <= equal_1692_s16_q;
      not_1693_s17_q <= not_1693_s16_q;
      equal_1694_s17_q <= equal_1694_s16_q;
      not_1695_s17_q <= not_1695_s16_q;
      equal_1696_s17_q <= equal_1696_s16_q;
      equal_1697_s17_q <= equal_1697_s16_q;
      or_1698_s17_q <= or_1698_s16_q;
      patches_right_0_rdata_s17_q <= patches_right_0_rdata_q;
      select_1722_s17_q <= select_1722_s16_q;
      select_1728_s17_q <= select_1728_s16_q;
      patches_right_1_rdata_s17_q <= patches_right_1_rdata_q;
      select_1767_s17_q <= select_1767_s16_q;
      and_1777_s17_q <= and_1777_s16_q;
      patches_columns_above_rdata_s17_q <= patches_columns_above_rdata_q;
      less_1853_s17_q <= less_1853_s16_q;
      equal_1854_s17_q <= equal_1854_s16_q;
      not_1855_s17_q <= not_1855_s16_q;
      equal_1856_s17_q <= equal_1856_s16_q;
      not_1857_s17_q <= not_1857_s16_q;
      patches_rows_rdata_s17_q <= patches_rows_rdata_q;
      sum_1884_s17_q <= sum_1884_s16_q;
      textured_s17_q <= textured_s16_q;
      and_2019_s17_q <= and_2016_s16_q & (~({sum_1556, last_s16_q[1:0]} < x_s16_q));
      equal_2162_s17_q <= equal_2162_s16_q;
      equal_2286_s17_q <= equal_2286_s16_q;
      wide_s17_q <= wide;
      size_3_s17_q <= size_3;
      less_2532_s17_q <= less_2532_s16_q;
      not_2759_s17_q <= ~(x_s16_q < {1'b0, from});
      or_2814_s17_q <= or_2814_s16_q;
      not_2838_s17_q <= not_2838_s16_q;
      equal_3317_s17_q <= equal_3317_s16_q;
      less_3620_s17_q <= less_3620_s16_q;
      equal_3825_s17_q <= equal_3825_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:119
  logic and_488;
  assign and_488 = sample_pair_whole_s17_q & and_487_s17_q;
  // hls/stages/agreement.hpp:193
  logic not_1511;
  assign not_1511 = ~so_s17_q;
  // hls/stages/agreement.hpp:773
  logic and_1512;
  assign and_1512 = not_1511 & shift_2_s17_q[4];
  logic and_1609;
  assign and_1609 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & right_3_s17_q));
  // hls/stages/patches.hpp:96
  logic and_1632;
  assign and_1632 = less_1630_s17_q & (~right_3_s17_q);
  // hls/stages/patches.hpp:98
  logic equal_1633;
  assign equal_1633 = x_s17_q == 8'h0;
  // hls/stages/agreement.hpp:974
  logic and_1643;
  assign and_1643 = (~(and_1632 | (equal_1633 | not_1635_s17_q))) & (less_1640_s17_q & less_1641_s17_q);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1674;
  assign sum_1674 = {registration_slope_s17_q[11], registration_slope_s17_q} + {{5{sum_1673_s17_q[7]}}, sum_1673_s17_q};
  // hls/stages/agreement.hpp:773
  logic and_1688;
  assign and_1688 = ends_cell_s17_q & (shift_2_s17_q[0] & (and_1632 | equal_1685_s17_q));
  logic and_1690;
  assign and_1690 = not_1472_s17_q & (so_s17_q & and_1688);
  // hls/stages/patches.hpp:164
  logic [7:0] pixel;
  assign pixel = equal_1697_s17_q ? (patches_second_s17_q ? 8'h0 : patches_right_0_rdata_s17_q) : 8'h0;
  // hls/stages/patches.hpp:453
  logic [8:0] sum_1815;
  assign sum_1815 = {1'b0, patches_columns_above_rdata_s17_q[23:16]} + {3'h0, patches_columns_above_rdata_s17_q[31:26]};
  // hls/stages/agreement.hpp:1010
  logic or_1886;
  assign or_1886 = (~sum_1884_s17_q) | equal_1685_s17_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2511;
  assign select_2511 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2511;
  // hls/stages/agreement.hpp:773
  logic and_2762;
  assign and_2762 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & not_2759_s17_q));
  // hls/stages/patches.hpp:542
  logic [9:0] select_3280;
  assign select_3280 = less_1853_s17_q ? patches_rows_rdata_s17_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3282;
  assign select_3282 = less_1853_s17_q ? (equal_1856_s17_q ? 10'h0 : select_3280) : 10'h0;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3287;
  assign select_3287 = less_1853_s17_q ? patches_rows_rdata_s17_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3290;
  assign select_3290 = equal_1856_s17_q ? (less_1853_s17_q ? (equal_1856_s17_q ? 5'h0 : select_3287) : 5'h0) : select_3287;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 17, written in stage 20: 17 < 20 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_481_s17_q;
  logic averager_memory_re;
  assign averager_memory_re = s17_en & and_488;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1453_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1452_s17_q, select_1451_s17_q, select_1433_s17_q, select_1430_s17_q, select_1422_s17_q, select_1421_s17_q, select_1416_s17_q};
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
  assign best_right_we = s17_en & and_1453_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1470_s17_q, select_1469_s17_q, select_1466_s17_q, select_1465_s17_q};
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
  assign shown_right_waddr = select_1510_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1515_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1512, not_1511};
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
  logic [3:0] select_474_s18_q;
  logic equal_475_s18_q;
  logic [6:0] select_477_s18_q;
  logic [8:0] select_481_s18_q;
  logic and_487_s18_q;
  logic and_488_s18_q;
  logic equal_493_s18_q;
  logic [6:0] column_s18_q;
  logic and_511_s18_q;
  logic and_513_s18_q;
  logic so_s18_q;
  logic equal_574_s18_q;
  logic equal_1471_s18_q;
  logic not_1472_s18_q;
  logic [13:0] shift_2_s18_q;
  logic and_1506_s18_q;
  logic [1:0] shown_right_rdata_s18_q;
  logic not_1511_s18_q;
  logic right_2_s18_q;
  logic and_1584_s18_q;
  logic and_1597_s18_q;
  logic and_1610_s18_q;
  logic less_1611_s18_q;
  logic equal_1633_s18_q;
  logic and_1643_s18_q;
  logic [7:0] sum_1674_s18_q;
  logic less_1675_s18_q;
  logic less_1676_s18_q;
  logic and_1690_s18_q;
  logic and_1691_s18_q;
  logic equal_1692_s18_q;
  logic not_1693_s18_q;
  logic equal_1694_s18_q;
  logic not_1695_s18_q;
  logic equal_1696_s18_q;
  logic equal_1697_s18_q;
  logic or_1698_s18_q;
  logic [4:0] select_1722_s18_q;
  logic select_1728_s18_q;
  logic [7:0] patches_left_rdata_s18_q;
  logic [3:0] select_1767_s18_q;
  logic and_1777_s18_q;
  logic [31:0] patches_columns_above_rdata_s18_q;
  logic [7:0] select_1781_s18_q;
  logic [8:0] sum_1815_s18_q;
  logic less_1853_s18_q;
  logic equal_1854_s18_q;
  logic not_1855_s18_q;
  logic equal_1856_s18_q;
  logic not_1857_s18_q;
  logic [9:0] patches_rows_rdata_s18_q;
  logic sum_1884_s18_q;
  logic and_1889_s18_q;
  logic textured_s18_q;
  logic [17:0] seen_columns_rdata_s18_q;
  logic and_2022_s18_q;
  logic equal_2162_s18_q;
  logic equal_2286_s18_q;
  logic less_2495_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2513_s18_q;
  logic less_2532_s18_q;
  logic and_2763_s18_q;
  logic or_2814_s18_q;
  logic not_2838_s18_q;
  logic [9:0] select_3283_s18_q;
  logic [4:0] select_3290_s18_q;
  logic equal_3317_s18_q;
  logic less_3620_s18_q;
  logic select_3663_s18_q;
  logic equal_3825_s18_q;
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
      select_474_s18_q <= select_474_s17_q;
      equal_475_s18_q <= equal_475_s17_q;
      select_477_s18_q <= select_477_s17_q;
      select_481_s18_q <= select_481_s17_q;
      and_487_s18_q <= and_487_s17_q;
      and_488_s18_q <= and_488;
      equal_493_s18_q <= equal_493_s17_q;
      column_s18_q <= column_s17_q;
      and_511_s18_q <= and_511_s17_q;
      and_513_s18_q <= and_513_s17_q;
      so_s18_q <= so_s17_q;
      equal_574_s18_q <= equal_574_s17_q;
      equal_1471_s18_q <= equal_1471_s17_q;
      not_1472_s18_q <= not_1472_s17_q;
      shift_2_s18_q <= shift_2_s17_q;
      and_1506_s18_q <= and_1506_s17_q;
      shown_right_rdata_s18_q <= shown_right_rdata_q;
      not_1511_s18_q <= not_1511;
      right_2_s18_q <= right_2_s17_q;
      and_1584_s18_q <= and_1584_s17_q;
      and_1597_s18_q <= and_1597_s17_q;
      and_1610_s18_q <= not_1472_s17_q & and_1609;
      less_1611_s18_q <= less_1611_s17_q;
      equal_1633_s18_q <= equal_1633;
      and_1643_s18_q <= and_1643;
      sum_1674_s18_q <= sum_1674[7:0];
      less_1675_s18_q <= $signed(6'h0) < $signed(sum_1674[12:7]);
      less_1676_s18_q <= $signed(sum_1674[12:7]) < $signed(6'h3f);
      and_1690_s18_q <= and_1690;
      and_1691_s18_q <= patches_chooses_s17_q & and_1690;
      equal_1692_s18_q <= equal_1692_s17_q;
      not_1693_s18_q <= not_1693_s17_q;
      equal_1694_s18_q <= equal_1694_s17_q;
      not_1695_s18_q <= not_1695_s17_q;
      equal_1696_s18_q <= equal_1696_s17_q;
      equal_1697_s18_q <= equal_1697_s17_q;
      or_1698_s18_q <= or_1698_s17_q;
      select_1722_s18_q <= select_1722_s17_q;
      select_1728_s18_q <= select_1728_s17_q;
      patches_left_rdata_s18_q <= patches_left_rdata_q;
      select_1767_s18_q <= select_1767_s17_q;
      and_1777_s18_q <= and_1777_s17_q;
      patches_columns_above_rdata_s18_q <= patches_columns_above_rdata_s17_q;
      select_1781_s18_q <= patches_second_s17_q ? patches_right_1_rdata_s17_q : pixel;
      sum_1815_s18_q <= sum_1815;
      less_1853_s18_q <= less_1853_s17_q;
      equal_1854_s18_q <= equal_1854_s17_q;
      not_1855_s18_q <= not_1855_s17_q;
      equal_1856_s18_q <= equal_1856_s17_q;
      not_1857_s18_q <= not_1857_s17_q;
      patches_rows_rdata_s18_q <= patches_rows_rdata_s17_q[9:0];
      sum_1884_s18_q <= sum_1884_s17_q;
      and_1889_s18_q <= so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & or_1886));
      textured_s18_q <= textured_s17_q;
      seen_columns_rdata_s18_q <= seen_columns_rdata_q;
      and_2022_s18_q <= not_1472_s17_q & (so_s17_q & (ends_cell_s17_q & and_2019_s17_q));
      equal_2162_s18_q <= equal_2162_s17_q;
      equal_2286_s18_q <= equal_2286_s17_q;
      less_2495_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2513_s18_q <= ~wide_s17_q;
      less_2532_s18_q <= less_2532_s17_q;
      and_2763_s18_q <= not_1472_s17_q & and_2762;
      or_2814_s18_q <= or_2814_s17_q;
      not_2838_s18_q <= not_2838_s17_q;
      select_3283_s18_q <= equal_1856_s17_q ? select_3282 : select_3280;
      select_3290_s18_q <= select_3290;
      equal_3317_s18_q <= equal_3317_s17_q;
      less_3620_s18_q <= less_3620_s17_q;
      select_3663_s18_q <= sum_1884_s17_q ? (equal_1685_s17_q & or_1886) : or_1886;
      equal_3825_s18_q <= equal_3825_s17_q;
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
  logic [13:0] select_491;
  assign select_491 = equal_475_s18_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_497;
  assign sum_497 = {6'h0, sample_pair_pixel_1_q} + (equal_475_s18_q ? 14'h0 : averager_running_1_q);
  // hls/stages/registration.hpp:83
  logic equal_1612;
  assign equal_1612 = slot_s18_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1613;
  assign select_1613 = shift_2_s18_q[5] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1614;
  assign select_1614 = shift_2_s18_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1615;
  assign sum_1615 = {{2{select_1613[6]}}, select_1613} + {select_1614[7], select_1614};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1616;
  assign select_1616 = shift_2_s18_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1617;
  assign select_1617 = shift_2_s18_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1618;
  assign sum_1618 = {{2{select_1616[7]}}, select_1616[7:1]} + {select_1617[7], select_1617};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1620;
  assign select_1620 = shift_2_s18_q[9] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1621;
  assign select_1621 = shift_2_s18_q[10] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1622;
  assign difference_1622 = {{2{select_1620[7]}}, select_1620[7:1]} - {select_1621[7], select_1621};
  // hls/stages/agreement.hpp:773
  logic [5:0] select_1656;
  assign select_1656 = ends_cell_s18_q ? (shift_2_s18_q[0] ? shift_2_s18_q[10:5] : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1678;
  assign select_1678 = less_1675_s18_q ? 8'h7f : (less_1676_s18_q ? 8'h80 : sum_1674_s18_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1612 ? registration_slope_here_q : select_1678;
  // hls/stages/agreement.hpp:773
  logic [7:0] select_1682;
  assign select_1682 = so_s18_q ? (ends_cell_s18_q ? (shift_2_s18_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:164
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1697_s18_q ? select_1781_s18_q : patches_left_rdata_s18_q;
  // hls/stages/patches.hpp:453
  logic [9:0] sum_1816;
  assign sum_1816 = {2'h0, patches_columns_above_rdata_s18_q[15:8]} + {1'b0, sum_1815_s18_q};
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1871;
  assign select_1871 = so_s18_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1002
  logic or_1874;
  assign or_1874 = select_1871[7] | (~({select_1871[5], select_1871[3], select_1871[1]} == 3'h0));
  // hls/stages/agreement.hpp:250
  logic and_1903;
  assign and_1903 = shift_2_s18_q[0] & ({shift_2_s18_q[4], shift_2_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:970
  logic select_1911;
  assign select_1911 = slot_s18_q[2] ? shown_shown_q : shift_2_s18_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1911);
  // hls/stages/agreement.hpp:970
  logic select_1914;
  assign select_1914 = slot_s18_q[2] ? shown_nearer_q : shift_2_s18_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s18_q[0] & (select_1911 ? select_1914 : shown_right_rdata_s18_q[1]);
  // hls/stages/agreement.hpp:986
  logic [7:0] select_1963;
  assign select_1963 = shift_2_s18_q[0] ? (sum_1884_s18_q ? select_1871 : {select_1871[6:0], 1'b0}) : select_1871;
  // hls/stages/agreement.hpp:1002
  logic or_1966;
  assign or_1966 = select_1963[7] | (~({select_1963[5], select_1963[3], select_1963[1]} == 3'h0));
  // hls/stages/registration.hpp:37
  logic not_2506;
  assign not_2506 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2495_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2506};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2514;
  assign select_2514 = registration_displacement_over_q[9] ? wide_s18_q : not_2513_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2495_s18_q ? {taken_s18_q, 1'b1} : {not_2506, select_2514, not_2506};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2516;
  assign sum_2516 = {left, 1'b1} + {taken_2, less_2495_s18_q};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2518;
  assign select_2518 = so_s18_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:773
  logic [7:0] select_2520;
  assign select_2520 = equal_1471_s18_q ? registration_slope_here_q : (so_s18_q ? slope : registration_slope_here_q);
  // hls/stages/patches.hpp:546
  logic [9:0] select_3285;
  assign select_3285 = less_1853_s18_q ? (equal_1854_s18_q ? 10'h0 : select_3283_s18_q) : select_3283_s18_q;
  logic [4:0] select_3292;
  assign select_3292 = less_1853_s18_q ? (equal_1854_s18_q ? 5'h0 : select_3290_s18_q) : select_3290_s18_q;
  // hls/stages/patches.hpp:542
  logic and_3302;
  assign and_3302 = less_1853_s18_q & (patches_step_s18_q == 5'h0);
  // hls/stages/patches.hpp:546
  logic select_3305;
  assign select_3305 = equal_1856_s18_q ? (less_1853_s18_q ? (not_1857_s18_q & and_3302) : and_3302) : and_3302;
  // hls/stages/agreement.hpp:773
  logic select_3617;
  assign select_3617 = equal_1471_s18_q ? shown_shown_q : (so_s18_q ? select_1911 : shown_shown_q);
  logic select_3619;
  assign select_3619 = equal_1471_s18_q ? shown_nearer_q : (so_s18_q ? select_1914 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3621;
  assign sum_3621 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:773
  logic [7:0] select_3630;
  assign select_3630 = equal_1471_s18_q ? select_1871 : (so_s18_q ? (ends_cell_s18_q ? select_1963 : select_1871) : 8'h1);
  // hls/stages/agreement.hpp:448
  logic [8:0] select_3644;
  assign select_3644 = equal_574_s18_q ? {difference_3642[7], difference_3642} : (less_3620_s18_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:508
  logic [8:0] select_3646;
  assign select_3646 = and_513_s18_q ? (equal_2286_s18_q ? select_3644 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:448
  logic [7:0] select_3648;
  assign select_3648 = equal_574_s18_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:508
  logic [7:0] select_3650;
  assign select_3650 = and_513_s18_q ? (equal_2286_s18_q ? select_3648 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3652;
  assign select_3652 = sum_3621[7] ? {1'b1, sum_3621[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});
  // hls/stages/agreement.hpp:197
  logic or_3661;
  assign or_3661 = segment_starts_q | not_1511_s18_q;
  // hls/stages/agreement.hpp:773
  logic select_3665;
  assign select_3665 = ends_cell_s18_q ? (shift_2_s18_q[0] ? select_3663_s18_q : or_3661) : or_3661;

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
      registration_displacement_over_q <= so_s18_q ? sum_2516[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2518;
      registration_slope_here_q <= select_2520;
      patches_read_row_differing_q <= equal_1692_s18_q ? select_3285 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1692_s18_q ? select_3292 : patches_read_row_column_q;
      shown_shown_q <= select_3617;
      shown_nearer_q <= select_3619;
      region_columns_q <= select_3630;
      region_down_rest_q <= select_3646;
      region_down_back_q <= select_3650;
      region_down_next_q <= select_3652;
      segment_starts_q <= equal_1471_s18_q ? or_3661 : (so_s18_q ? select_3665 : or_3661);
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
      averager_running_0_q <= sample_pair_whole_s18_q ? select_491 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s18_q ? sum_497 : averager_running_1_q;
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
  logic [3:0] select_474_s19_q;
  logic equal_475_s19_q;
  logic [6:0] select_477_s19_q;
  logic [8:0] select_481_s19_q;
  logic and_487_s19_q;
  logic and_488_s19_q;
  logic [29:0] averager_memory_rdata_s19_q;
  logic [13:0] select_491_s19_q;
  logic equal_493_s19_q;
  logic [13:0] sum_497_s19_q;
  logic [6:0] column_s19_q;
  logic and_511_s19_q;
  logic and_513_s19_q;
  logic so_s19_q;
  logic equal_574_s19_q;
  logic equal_1471_s19_q;
  logic not_1472_s19_q;
  logic [4:0] shift_2_s19_q;
  logic and_1506_s19_q;
  logic equal_1516_s19_q;
  logic right_2_s19_q;
  logic and_1584_s19_q;
  logic and_1597_s19_q;
  logic and_1610_s19_q;
  logic less_1611_s19_q;
  logic equal_1612_s19_q;
  logic [7:0] sum_1615_s19_q;
  logic select_1616_s19_q;
  logic [8:0] sum_1618_s19_q;
  logic select_1620_s19_q;
  logic [8:0] difference_1622_s19_q;
  logic equal_1633_s19_q;
  logic and_1643_s19_q;
  logic [5:0] select_1658_s19_q;
  logic [7:0] select_1683_s19_q;
  logic and_1690_s19_q;
  logic and_1691_s19_q;
  logic equal_1692_s19_q;
  logic not_1693_s19_q;
  logic equal_1694_s19_q;
  logic not_1695_s19_q;
  logic equal_1696_s19_q;
  logic equal_1697_s19_q;
  logic or_1698_s19_q;
  logic [4:0] select_1722_s19_q;
  logic select_1728_s19_q;
  logic [3:0] select_1767_s19_q;
  logic and_1777_s19_q;
  logic [31:0] patches_columns_above_rdata_s19_q;
  logic [7:0] pixel_2_s19_q;
  logic [9:0] sum_1816_s19_q;
  logic less_1853_s19_q;
  logic equal_1854_s19_q;
  logic not_1855_s19_q;
  logic equal_1856_s19_q;
  logic not_1857_s19_q;
  logic [9:0] patches_rows_rdata_s19_q;
  logic or_1874_s19_q;
  logic or_1877_s19_q;
  logic or_1880_s19_q;
  logic and_1889_s19_q;
  logic textured_s19_q;
  logic and_1903_s19_q;
  logic [12:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_1949_s19_q;
  logic and_1951_s19_q;
  logic or_1966_s19_q;
  logic or_1969_s19_q;
  logic or_1972_s19_q;
  logic and_1983_s19_q;
  logic and_1985_s19_q;
  logic and_1986_s19_q;
  logic and_1999_s19_q;
  logic and_2001_s19_q;
  logic and_2002_s19_q;
  logic and_2022_s19_q;
  logic equal_2162_s19_q;
  logic equal_2286_s19_q;
  logic and_2435_s19_q;
  logic and_2437_s19_q;
  logic and_2438_s19_q;
  logic or_2530_s19_q;
  logic [1:0] sum_2531_s19_q;
  logic less_2532_s19_q;
  logic and_2763_s19_q;
  logic or_2814_s19_q;
  logic not_2838_s19_q;
  logic select_3305_s19_q;
  logic equal_3317_s19_q;
  logic less_3620_s19_q;
  logic sum_3621_s19_q;
  logic and_3815_s19_q;
  logic equal_3825_s19_q;
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
      select_474_s19_q <= select_474_s18_q;
      equal_475_s19_q <= equal_475_s18_q;
      select_477_s19_q <= select_477_s18_q;
      select_481_s19_q <= select_481_s18_q;
      and_487_s19_q <= and_487_s18_q;
      and_488_s19_q <= and_488_s18_q;
      averager_memory_rdata_s19_q <= averager_memory_rdata_q;
      select_491_s19_q <= select_491;
      equal_493_s19_q <= equal_493_s18_q;
      sum_497_s19_q <= sum_497;
      column_s19_q <= column_s18_q;
      and_511_s19_q <= and_511_s18_q;
      and_513_s19_q <= and_513_s18_q;
      so_s19_q <= so_s18_q;
      equal_574_s19_q <= equal_574_s18_q;
      equal_1471_s19_q <= equal_1471_s18_q;
      not_1472_s19_q <= not_1472_s18_q;
      shift_2_s19_q <= {shift_2_s18_q[11], shift_2_s18_q[3:0]};
      and_1506_s19_q <= and_1506_s18_q;
      equal_1516_s19_q <= x_s18_q[6:4] == 3'h7;
      right_2_s19_q <= right_2_s18_q;
      and_1584_s19_q <= and_1584_s18_q;
      and_1597_s19_q <= and_1597_s18_q;
      and_1610_s19_q <= and_1610_s18_q;
      less_1611_s19_q <= less_1611_s18_q;
      equal_1612_s19_q <= equal_1612;
      sum_1615_s19_q <= sum_1615[8:1];
      select_1616_s19_q <= select_1616[0];
      sum_1618_s19_q <= sum_1618;
      select_1620_s19_q <= select_1620[0];
      difference_1622_s19_q <= difference_1622;
      equal_1633_s19_q <= equal_1633_s18_q;
      and_1643_s19_q <= and_1643_s18_q;
      select_1658_s19_q <= equal_1471_s18_q ? 6'h0 : (so_s18_q ? select_1656 : 6'h0);
      select_1683_s19_q <= equal_1471_s18_q ? 8'h0 : select_1682;
      and_1690_s19_q <= and_1690_s18_q;
      and_1691_s19_q <= and_1691_s18_q;
      equal_1692_s19_q <= equal_1692_s18_q;
      not_1693_s19_q <= not_1693_s18_q;
      equal_1694_s19_q <= equal_1694_s18_q;
      not_1695_s19_q <= not_1695_s18_q;
      equal_1696_s19_q <= equal_1696_s18_q;
      equal_1697_s19_q <= equal_1697_s18_q;
      or_1698_s19_q <= or_1698_s18_q;
      select_1722_s19_q <= select_1722_s18_q;
      select_1728_s19_q <= select_1728_s18_q;
      select_1767_s19_q <= select_1767_s18_q;
      and_1777_s19_q <= and_1777_s18_q;
      patches_columns_above_rdata_s19_q <= patches_columns_above_rdata_s18_q;
      pixel_2_s19_q <= pixel_2;
      sum_1816_s19_q <= sum_1816;
      less_1853_s19_q <= less_1853_s18_q;
      equal_1854_s19_q <= equal_1854_s18_q;
      not_1855_s19_q <= not_1855_s18_q;
      equal_1856_s19_q <= equal_1856_s18_q;
      not_1857_s19_q <= not_1857_s18_q;
      patches_rows_rdata_s19_q <= patches_rows_rdata_s18_q;
      or_1874_s19_q <= or_1874;
      or_1877_s19_q <= select_1871[7] | (~({select_1871[6], select_1871[3:2]} == 3'h0));
      or_1880_s19_q <= select_1871[7] | (~(select_1871[6:4] == 3'h0));
      and_1889_s19_q <= and_1889_s18_q;
      textured_s19_q <= textured_s18_q;
      and_1903_s19_q <= and_1903;
      seen_columns_rdata_s19_q <= {seen_columns_rdata_s18_q[13:7], seen_columns_rdata_s18_q[5:0]};
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_1949_s19_q <= seen_columns_rdata_s18_q[14] & shift_2_s18_q[0];
      and_1951_s19_q <= seen_columns_rdata_s18_q[5] & shift_2_s18_q[0];
      or_1966_s19_q <= or_1966;
      or_1969_s19_q <= select_1963[7] | (~({select_1963[6], select_1963[3:2]} == 3'h0));
      or_1972_s19_q <= select_1963[7] | (~(select_1963[6:4] == 3'h0));
      and_1983_s19_q <= seen_columns_rdata_s18_q[16] & shift_2_s18_q[0];
      and_1985_s19_q <= seen_columns_rdata_s18_q[8] & shift_2_s18_q[0];
      and_1986_s19_q <= seen_columns_rdata_s18_q[3] & shift_2_s18_q[0];
      and_1999_s19_q <= seen_columns_rdata_s18_q[17] & shift_2_s18_q[0];
      and_2001_s19_q <= seen_columns_rdata_s18_q[9] & shift_2_s18_q[0];
      and_2002_s19_q <= seen_columns_rdata_s18_q[4] & shift_2_s18_q[0];
      and_2022_s19_q <= and_2022_s18_q;
      equal_2162_s19_q <= equal_2162_s18_q;
      equal_2286_s19_q <= equal_2286_s18_q;
      and_2435_s19_q <= seen_columns_rdata_s18_q[15] & shift_2_s18_q[0];
      and_2437_s19_q <= seen_columns_rdata_s18_q[7] & shift_2_s18_q[0];
      and_2438_s19_q <= seen_columns_rdata_s18_q[2] & shift_2_s18_q[0];
      or_2530_s19_q <= (shift_2_s18_q[13:11] == 3'h0) | (shift_2_s18_q[13:11] == 3'h4);
      sum_2531_s19_q <= shift_2_s18_q[13:12] + 2'h3;
      less_2532_s19_q <= less_2532_s18_q;
      and_2763_s19_q <= and_2763_s18_q;
      or_2814_s19_q <= or_2814_s18_q;
      not_2838_s19_q <= not_2838_s18_q;
      select_3305_s19_q <= select_3305;
      equal_3317_s19_q <= equal_3317_s18_q;
      less_3620_s19_q <= less_3620_s18_q;
      sum_3621_s19_q <= sum_3621[7];
      and_3815_s19_q <= seen_columns_rdata_s18_q[6] & shift_2_s18_q[0];
      equal_3825_s19_q <= equal_3825_s18_q;
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
  logic [13:0] sum_495;
  assign sum_495 = select_491_s19_q + (equal_493_s19_q ? 14'h0 : averager_memory_rdata_s19_q[13:0]);
  logic [13:0] sum_499;
  assign sum_499 = sum_497_s19_q + (equal_493_s19_q ? 14'h0 : averager_memory_rdata_s19_q[27:14]);
  // hls/stages/agreement.hpp:405
  logic whole;
  assign whole = equal_475_s19_q ? sample_present_s19_q : (sample_present_s19_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_475_s19_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:123
  logic and_507;
  assign and_507 = all_of_skin & (averager_memory_rdata_s19_q[29] | equal_493_s19_q);
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s19_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:201
  logic equal_1530;
  assign equal_1530 = x_s19_q[5:0] == 6'h3c;
  logic equal_1532;
  assign equal_1532 = x_s19_q[5:0] == 6'h3b;
  logic equal_1534;
  assign equal_1534 = x_s19_q[5:0] == 6'h36;
  logic equal_1536;
  assign equal_1536 = x_s19_q[5:0] == 6'h35;
  logic equal_1538;
  assign equal_1538 = x_s19_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1126
  logic and_1542;
  assign and_1542 = (~equal_1532) & ((~equal_1534) & ((~equal_1536) & (~equal_1538)));
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1619;
  assign sum_1619 = {{3{sum_1615_s19_q[7]}}, sum_1615_s19_q} + {sum_1618_s19_q[8], sum_1618_s19_q, select_1616_s19_q};
  logic [9:0] sum_1623;
  assign sum_1623 = {difference_1622_s19_q, select_1620_s19_q} + {sum_1619[10], sum_1619[10:2]};
  // hls/stages/patches.hpp:455
  logic [8:0] sum_1805;
  assign sum_1805 = {1'b0, patches_columns_above_rdata_s19_q[7:0]} + {2'h0, pixel_2_s19_q[7:1]};
  logic [8:0] sum_1806;
  assign sum_1806 = {1'b0, patches_columns_above_rdata_s19_q[23:16]} + {2'h0, patches_columns_above_rdata_s19_q[31:25]};
  // hls/stages/patches.hpp:453
  logic [10:0] sum_1817;
  assign sum_1817 = {3'h0, patches_columns_above_rdata_s19_q[15:8]} + {sum_1816_s19_q, patches_columns_above_rdata_s19_q[25]};
  // hls/stages/agreement.hpp:773
  logic [5:0] select_1881;
  assign select_1881 = equal_1471_s19_q ? x_s19_q[5:0] : {region_row_q, or_1880_s19_q, or_1877_s19_q, or_1874_s19_q};
  // hls/stages/agreement.hpp:1080
  logic not_1882;
  assign not_1882 = ~equal_1516_s19_q;
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s19_q[0] & shift_2_s19_q[3];
  logic and_1910;
  assign and_1910 = shift_2_s19_q[0] & shift_2_s19_q[2];
  // hls/stages/agreement.hpp:986
  logic and_1952;
  assign and_1952 = seen_columns_rdata_s19_q[0] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1039
  logic [1:0] sum_1954;
  assign sum_1954 = {1'b0, and_1951_s19_q} + ({1'b0, textured_s19_q} + {1'b0, and_1952});
  // hls/stages/agreement.hpp:986
  logic and_1984;
  assign and_1984 = seen_columns_rdata_s19_q[11] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_1988;
  assign sum_1988 = {1'b0, and_1985_s19_q} + ({1'b0, shown_s19_q} + {1'b0, and_1986_s19_q});
  // hls/stages/agreement.hpp:986
  logic and_2000;
  assign and_2000 = seen_columns_rdata_s19_q[12] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_2004;
  assign sum_2004 = {1'b0, and_2001_s19_q} + ({1'b0, near_s19_q} + {1'b0, and_2002_s19_q});
  // hls/stages/agreement.hpp:264
  logic select_2075;
  assign select_2075 = sample_pair_whole_s19_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:773
  logic and_2414;
  assign and_2414 = so_s19_q & (ends_cell_s19_q & (shift_2_s19_q[0] & shift_2_s19_q[1]));
  // hls/stages/agreement.hpp:1057
  logic not_2434;
  assign not_2434 = ~(x_s19_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:986
  logic and_2436;
  assign and_2436 = seen_columns_rdata_s19_q[10] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1040
  logic [1:0] sum_2440;
  assign sum_2440 = {1'b0, and_2437_s19_q} + ({1'b0, explained} + {1'b0, and_2438_s19_q});
  // hls/stages/agreement.hpp:773
  logic and_2475;
  assign and_2475 = ends_cell_s19_q & (shift_2_s19_q[0] & (shift_2_s19_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:1062
  logic and_2481;
  assign and_2481 = not_2434 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2533;
  assign difference_2533 = {sum_2531_s19_q, shift_2_s19_q[4], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2534;
  assign select_2534 = less_2532_s19_q ? difference_2533 : {sum_2531_s19_q, shift_2_s19_q[4], registration_displacement_fraction_q};
  logic [7:0] select_2535;
  assign select_2535 = or_2530_s19_q ? {sum_2531_s19_q, shift_2_s19_q[4], 5'h0} : select_2534;
  // hls/stages/patches.hpp:179
  logic select_2853;
  assign select_2853 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:167
  logic and_2914;
  assign and_2914 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:403
  logic [4:0] select_2919;
  assign select_2919 = or_2814_s19_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:405
  logic [3:0] select_2921;
  assign select_2921 = and_2914 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:542
  logic [4:0] select_3294;
  assign select_3294 = less_1853_s19_q ? patches_step_s19_q : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3297;
  assign select_3297 = equal_1856_s19_q ? (less_1853_s19_q ? (equal_1856_s19_q ? 5'h0 : select_3294) : 5'h0) : select_3294;
  logic [4:0] select_3299;
  assign select_3299 = less_1853_s19_q ? (equal_1854_s19_q ? 5'h0 : select_3297) : select_3297;
  logic select_3307;
  assign select_3307 = less_1853_s19_q ? (not_1855_s19_q & select_3305_s19_q) : select_3305_s19_q;
  // hls/stages/patches.hpp:170
  logic or_3319;
  assign or_3319 = patches_read_first_q | (patches_read_row_differing_s19_q < patches_peak_best_differing_q);
  logic and_3320;
  assign and_3320 = patches_read_searches_s19_q & or_3319;
  // hls/stages/patches.hpp:525
  logic [14:0] select_3352;
  assign select_3352 = and_3320 ? {patches_read_row_column_s19_q, patches_read_row_differing_s19_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:176
  logic [9:0] select_3353;
  assign select_3353 = equal_1692_s19_q ? select_3352[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3354;
  assign select_3354 = equal_1692_s19_q ? select_3352[14:10] : patches_peak_best_column_q;
  // hls/stages/agreement.hpp:448
  logic [2:0] select_3623;
  assign select_3623 = less_3620_s19_q ? (sum_3621_s19_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3625;
  assign select_3625 = equal_2286_s19_q ? (equal_574_s19_q ? 3'h0 : select_3623) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3621_s19_q;
  // hls/stages/agreement.hpp:448
  logic select_3656;
  assign select_3656 = equal_2286_s19_q ? (equal_574_s19_q | (less_3620_s19_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1158
  logic equal_3674;
  assign equal_3674 = x_s19_q[6:3] == 4'h7;
  logic equal_3696;
  assign equal_3696 = x_s19_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1077
  logic [7:0] select_3709;
  assign select_3709 = (x_s19_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3711;
  assign select_3711 = equal_3696 ? cfg_unproven_skin_limit_i : (equal_3674 ? cfg_unproven_limit_i : select_3709);
  // hls/stages/agreement.hpp:773
  logic select_3813;
  assign select_3813 = so_s19_q ? (ends_cell_s19_q ? and_1951_s19_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3817;
  assign select_3817 = so_s19_q ? (ends_cell_s19_q ? and_3815_s19_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_3819;
  assign select_3819 = ends_cell_s19_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3821;
  assign select_3821 = equal_1471_s19_q ? centres_values_1_textured_q : (so_s19_q ? select_3819 : centres_values_1_textured_q);
  logic select_3822;
  assign select_3822 = ends_cell_s19_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3824;
  assign select_3824 = equal_1471_s19_q ? centres_values_1_of_skin_q : (so_s19_q ? select_3822 : centres_values_1_of_skin_q);

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
  assign census_memory_re = s19_en & and_513_s19_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1330; read in stage 19, written in stage 22: 19 < 22 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1881;
  logic regions_re;
  assign regions_re = s19_en & (equal_1471_s19_q ? (x_s19_q[6] & not_1882) : and_1889_s19_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s19_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s19_en & and_1777_s19_q;
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
  assign seen_columns_we = s19_en & and_1506_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q, near_s19_q, shown_s19_q, explained, and_1910, textured_s19_q};
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
      averager_running_of_skin_q <= select_2075;
      patches_along_ends_q <= not_2838_s19_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2838_s19_q & select_2853;
      patches_down_by_q <= or_2814_s19_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2914});
      patches_along_q <= select_2919;
      patches_match_row_q <= or_2814_s19_q ? 4'h0 : select_2921;
      patches_summed_last_q <= not_1693_s19_q & (equal_1694_s19_q & and_2914);
      patches_read_first_q <= equal_1692_s19_q ? select_3307 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3353;
      patches_peak_best_column_q <= select_3354;
      region_row_q <= and_513_s19_q ? select_3625 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_513_s19_q ? select_3656 : region_fresh_q;
      segment_started_q <= ~segment_starts_q;
      centres_values_0_textured_q <= equal_1471_s19_q ? centres_values_0_textured_q : select_3813;
      centres_values_0_of_skin_q <= equal_1471_s19_q ? centres_values_0_of_skin_q : select_3817;
      centres_values_1_textured_q <= select_3821;
      centres_values_1_of_skin_q <= select_3824;
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
  logic [3:0] select_474_s20_q;
  logic [6:0] select_477_s20_q;
  logic [8:0] select_481_s20_q;
  logic and_487_s20_q;
  logic and_488_s20_q;
  logic [13:0] sum_495_s20_q;
  logic [13:0] sum_499_s20_q;
  logic and_503_s20_q;
  logic and_507_s20_q;
  logic [6:0] column_s20_q;
  logic and_511_s20_q;
  logic and_513_s20_q;
  logic equal_516_s20_q;
  logic so_s20_q;
  logic equal_574_s20_q;
  logic equal_1471_s20_q;
  logic not_1472_s20_q;
  logic [1:0] shift_2_s20_q;
  logic equal_1516_s20_q;
  logic all_s20_q;
  logic equal_1530_s20_q;
  logic equal_1532_s20_q;
  logic equal_1534_s20_q;
  logic equal_1536_s20_q;
  logic equal_1538_s20_q;
  logic and_1543_s20_q;
  logic right_2_s20_q;
  logic and_1584_s20_q;
  logic and_1597_s20_q;
  logic and_1610_s20_q;
  logic less_1611_s20_q;
  logic equal_1612_s20_q;
  logic sum_1619_s20_q;
  logic [9:0] sum_1623_s20_q;
  logic equal_1633_s20_q;
  logic and_1643_s20_q;
  logic [5:0] select_1658_s20_q;
  logic [7:0] select_1683_s20_q;
  logic and_1690_s20_q;
  logic and_1691_s20_q;
  logic equal_1692_s20_q;
  logic not_1693_s20_q;
  logic equal_1694_s20_q;
  logic not_1695_s20_q;
  logic equal_1696_s20_q;
  logic equal_1697_s20_q;
  logic or_1698_s20_q;
  logic [4:0] select_1722_s20_q;
  logic select_1728_s20_q;
  logic [3:0] select_1767_s20_q;
  logic [8:0] patches_columns_above_rdata_s20_q;
  logic [7:0] pixel_2_s20_q;
  logic [4:0] sum_1791_s20_q;
  logic [8:0] sum_1805_s20_q;
  logic [8:0] sum_1806_s20_q;
  logic [10:0] sum_1817_s20_q;
  logic less_1853_s20_q;
  logic equal_1854_s20_q;
  logic not_1855_s20_q;
  logic equal_1856_s20_q;
  logic not_1857_s20_q;
  logic [9:0] patches_rows_rdata_s20_q;
  logic or_1874_s20_q;
  logic or_1877_s20_q;
  logic or_1880_s20_q;
  logic not_1882_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1903_s20_q;
  logic and_1908_s20_q;
  logic and_1949_s20_q;
  logic and_1950_s20_q;
  logic [1:0] sum_1954_s20_q;
  logic or_1966_s20_q;
  logic or_1969_s20_q;
  logic or_1972_s20_q;
  logic and_1983_s20_q;
  logic [2:0] sum_1989_s20_q;
  logic and_1999_s20_q;
  logic [2:0] sum_2005_s20_q;
  logic and_2022_s20_q;
  logic equal_2162_s20_q;
  logic equal_2286_s20_q;
  logic and_2415_s20_q;
  logic not_2434_s20_q;
  logic and_2435_s20_q;
  logic [2:0] sum_2441_s20_q;
  logic and_2477_s20_q;
  logic and_2484_s20_q;
  logic [7:0] select_2535_s20_q;
  logic and_2763_s20_q;
  logic [4:0] select_3299_s20_q;
  logic equal_3317_s20_q;
  logic and_3320_s20_q;
  logic [14:0] select_3352_s20_q;
  logic equal_3674_s20_q;
  logic equal_3695_s20_q;
  logic equal_3696_s20_q;
  logic [7:0] select_3711_s20_q;
  logic equal_3825_s20_q;
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
      select_474_s20_q <= select_474_s19_q;
      select_477_s20_q <= select_477_s19_q;
      select_481_s20_q <= select_481_s19_q;
      and_487_s20_q <= and_487_s19_q;
      and_488_s20_q <= and_488_s19_q;
      sum_495_s20_q <= sum_495;
      sum_499_s20_q <= sum_499;
      and_503_s20_q <= whole & (averager_memory_rdata_s19_q[28] | equal_493_s19_q);
      and_507_s20_q <= and_507;
      column_s20_q <= column_s19_q;
      and_511_s20_q <= and_511_s19_q;
      and_513_s20_q <= and_513_s19_q;
      equal_516_s20_q <= select_474_s19_q == 4'h3;
      so_s20_q <= so_s19_q;
      equal_574_s20_q <= equal_574_s19_q;
      equal_1471_s20_q <= equal_1471_s19_q;
      not_1472_s20_q <= not_1472_s19_q;
      shift_2_s20_q <= {shift_2_s19_q[3], shift_2_s19_q[0]};
      equal_1516_s20_q <= equal_1516_s19_q;
      all_s20_q <= all;
      equal_1530_s20_q <= equal_1530;
      equal_1532_s20_q <= equal_1532;
      equal_1534_s20_q <= equal_1534;
      equal_1536_s20_q <= equal_1536;
      equal_1538_s20_q <= equal_1538;
      and_1543_s20_q <= (~equal_1530) & and_1542;
      right_2_s20_q <= right_2_s19_q;
      and_1584_s20_q <= and_1584_s19_q;
      and_1597_s20_q <= and_1597_s19_q;
      and_1610_s20_q <= and_1610_s19_q;
      less_1611_s20_q <= less_1611_s19_q;
      equal_1612_s20_q <= equal_1612_s19_q;
      sum_1619_s20_q <= sum_1619[1];
      sum_1623_s20_q <= sum_1623;
      equal_1633_s20_q <= equal_1633_s19_q;
      and_1643_s20_q <= and_1643_s19_q;
      select_1658_s20_q <= select_1658_s19_q;
      select_1683_s20_q <= select_1683_s19_q;
      and_1690_s20_q <= and_1690_s19_q;
      and_1691_s20_q <= and_1691_s19_q;
      equal_1692_s20_q <= equal_1692_s19_q;
      not_1693_s20_q <= not_1693_s19_q;
      equal_1694_s20_q <= equal_1694_s19_q;
      not_1695_s20_q <= not_1695_s19_q;
      equal_1696_s20_q <= equal_1696_s19_q;
      equal_1697_s20_q <= equal_1697_s19_q;
      or_1698_s20_q <= or_1698_s19_q;
      select_1722_s20_q <= select_1722_s19_q;
      select_1728_s20_q <= select_1728_s19_q;
      select_1767_s20_q <= select_1767_s19_q;
      patches_columns_above_rdata_s20_q <= {patches_columns_above_rdata_s19_q[24], patches_columns_above_rdata_s19_q[7:0]};
      pixel_2_s20_q <= pixel_2_s19_q;
      sum_1791_s20_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1805_s20_q <= sum_1805;
      sum_1806_s20_q <= sum_1806;
      sum_1817_s20_q <= sum_1817;
      less_1853_s20_q <= less_1853_s19_q;
      equal_1854_s20_q <= equal_1854_s19_q;
      not_1855_s20_q <= not_1855_s19_q;
      equal_1856_s20_q <= equal_1856_s19_q;
      not_1857_s20_q <= not_1857_s19_q;
      patches_rows_rdata_s20_q <= patches_rows_rdata_s19_q;
      or_1874_s20_q <= or_1874_s19_q;
      or_1877_s20_q <= or_1877_s19_q;
      or_1880_s20_q <= or_1880_s19_q;
      not_1882_s20_q <= not_1882;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained;
      and_1903_s20_q <= and_1903_s19_q;
      and_1908_s20_q <= not_1472_s19_q & and_1889_s19_q;
      and_1949_s20_q <= and_1949_s19_q;
      and_1950_s20_q <= seen_columns_rdata_s19_q[9] & shift_2_s19_q[0];
      sum_1954_s20_q <= sum_1954;
      or_1966_s20_q <= or_1966_s19_q;
      or_1969_s20_q <= or_1969_s19_q;
      or_1972_s20_q <= or_1972_s19_q;
      and_1983_s20_q <= and_1983_s19_q;
      sum_1989_s20_q <= {2'h0, and_1984} + {1'b0, sum_1988};
      and_1999_s20_q <= and_1999_s19_q;
      sum_2005_s20_q <= {2'h0, and_2000} + {1'b0, sum_2004};
      and_2022_s20_q <= and_2022_s19_q;
      equal_2162_s20_q <= equal_2162_s19_q;
      equal_2286_s20_q <= equal_2286_s19_q;
      and_2415_s20_q <= not_1472_s19_q & and_2414;
      not_2434_s20_q <= not_2434;
      and_2435_s20_q <= and_2435_s19_q;
      sum_2441_s20_q <= {2'h0, and_2436} + {1'b0, sum_2440};
      and_2477_s20_q <= not_1472_s19_q & (so_s19_q & and_2475);
      and_2484_s20_q <= not_1472_s19_q & (so_s19_q & (ends_cell_s19_q & and_2481));
      select_2535_s20_q <= select_2535;
      and_2763_s20_q <= and_2763_s19_q;
      select_3299_s20_q <= select_3299;
      equal_3317_s20_q <= equal_3317_s19_q;
      and_3320_s20_q <= and_3320;
      select_3352_s20_q <= select_3352;
      equal_3674_s20_q <= equal_3674;
      equal_3695_s20_q <= x_s19_q[6:3] == 4'h9;
      equal_3696_s20_q <= equal_3696;
      select_3711_s20_q <= select_3711;
      equal_3825_s20_q <= equal_3825_s19_q;
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
  assign grey = and_487_s20_q ? sum_495_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_516_s20_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_487_s20_q ? sum_499_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_516_s20_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_524;
  assign and_524 = and_487_s20_q & and_503_s20_q;
  // hls/stages/census.hpp:126
  logic select_526;
  assign select_526 = equal_516_s20_q ? and_524 : (averager_mask_q & and_524);
  // hls/stages/agreement.hpp:264
  logic whole_2;
  assign whole_2 = sample_pair_whole_s20_q & select_526;
  // hls/stages/census.hpp:206
  logic and_528;
  assign and_528 = and_487_s20_q & and_507_s20_q;
  // hls/stages/census.hpp:126
  logic select_530;
  assign select_530 = equal_516_s20_q ? and_528 : (averager_of_skin_q & and_528);
  // hls/stages/agreement.hpp:443
  logic equal_571;
  assign equal_571 = column_s20_q == 7'h0;
  logic [3:0] select_575;
  assign select_575 = equal_574_s20_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:444
  logic [4:0] select_576;
  assign select_576 = equal_571 ? {select_575, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_577;
  assign select_577 = equal_571 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:1126
  logic [1:0] quarter;
  assign quarter = x_s20_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1081
  logic [1:0] select_1519;
  assign select_1519 = x_s20_q[4] ? {x_s20_q[3], x_s20_q[0]} : {x_s20_q[0], x_s20_q[3]};
  // hls/stages/agreement.hpp:1094
  logic [3:0] select_1521;
  assign select_1521 = equal_1516_s20_q ? {2'h0, quarter} : (all_s20_q ? {1'b0, x_s20_q[2:0]} : {x_s20_q[2:1], select_1519});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1522;
  assign sum_1522 = slot_s20_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:773
  logic [3:0] select_1523;
  assign select_1523 = equal_1471_s20_q ? select_1521 : {sum_1522, lower_half_s20_q, registration_of_right_q};
  // hls/stages/patches.hpp:201
  logic equal_1524;
  assign equal_1524 = x_s20_q[5:0] == 6'h3f;
  logic equal_1526;
  assign equal_1526 = x_s20_q[5:0] == 6'h3e;
  logic equal_1528;
  assign equal_1528 = x_s20_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1126
  logic and_1546;
  assign and_1546 = (~equal_1524) & ((~equal_1526) & ((~equal_1528) & and_1543_s20_q));
  // hls/stages/agreement.hpp:1081
  logic less_1547;
  assign less_1547 = x_s20_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s20_q ? {1'b0, x_s20_q[2]} : x_s20_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1551;
  assign or_1551 = (kind == 2'h3) | (x_s20_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s20_q[0] ? (right_2_s20_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1562;
  assign sum_1562 = {2'h0, slot_s20_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1568;
  assign not_1568 = ~lower_half_s20_q;
  logic [3:0] select_1569;
  assign select_1569 = registration_of_right_q ? {lower_half_s20_q, 1'b0, not_1568, 1'b0} : {1'b0, lower_half_s20_q, 1'b0, not_1568};
  // hls/stages/patches.hpp:363
  logic [1:0] select_1598;
  assign select_1598 = and_1597_s20_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1599;
  assign select_1599 = and_1597_s20_q ? patches_band_rows_number_s20_q : patches_band_q;
  // hls/stages/agreement.hpp:264
  logic [5:0] select_1600;
  assign select_1600 = and_1584_s20_q ? {select_1599, select_1598[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:118
  logic [1:0] select_1601;
  assign select_1601 = and_1584_s20_q ? select_1598 : patches_fetch_q;
  logic equal_1602;
  assign equal_1602 = select_1601 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1612_s20_q ? {sum_1623_s20_q, sum_1619_s20_q} : registration_expected_q;
  // hls/stages/patches.hpp:118
  logic [4:0] select_1705;
  assign select_1705 = and_1584_s20_q ? select_1599 : patches_band_q;
  // hls/stages/patches.hpp:343
  logic equal_1706;
  assign equal_1706 = {patches_choosing_band_s20_q, and_1610_s20_q} == {select_1705, select_1601[1]};
  // hls/stages/patches.hpp:486
  logic less_1783;
  assign less_1783 = 5'he < patches_along_s20_q;
  // hls/stages/patches.hpp:487
  logic or_1784;
  assign or_1784 = equal_1696_s20_q | less_1783;
  // hls/stages/patches.hpp:490
  logic new_row;
  assign new_row = patches_along_s20_q == 5'h0;
  logic select_1789;
  assign select_1789 = equal_1696_s20_q ? patches_column_s20_q[0] : (or_1784 ? (patches_along_s20_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:488
  logic [4:0] select_1792;
  assign select_1792 = patches_match_row_ends_s20_q ? patches_down_by_s20_q : sum_1791_s20_q;
  // hls/stages/patches.hpp:491
  logic [4:0] select_1795;
  assign select_1795 = equal_1696_s20_q ? 5'h0 : (or_1784 ? (select_1792 + 5'h1) : sum_1791_s20_q);
  // hls/stages/patches.hpp:467
  logic equal_1798;
  assign equal_1798 = patches_column_s20_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s20_q == 5'h11;
  logic equal_1800;
  assign equal_1800 = patches_column_s20_q == 5'h18;
  // hls/stages/patches.hpp:469
  logic and_1802;
  assign and_1802 = of_row & (~equal_1800);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1798 ? 2'h3 : {equal_1800, and_1802};
  // hls/stages/patches.hpp:455
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1805_s20_q, pixel_2_s20_q[0]} - {1'b0, sum_1806_s20_q, patches_columns_above_rdata_s20_q[8]};
  // hls/stages/patches.hpp:453
  logic [9:0] sum_1818;
  assign sum_1818 = {2'h0, patches_columns_above_rdata_s20_q[7:0]} + sum_1817_s20_q[10:1];
  // hls/stages/patches.hpp:468
  logic or_1828;
  assign or_1828 = (((patches_column_s20_q == 5'ha) | of_row) | equal_1800) | equal_1798;
  // hls/stages/patches.hpp:463
  logic and_1833;
  assign and_1833 = (~(patches_code_row_s20_q[4:2] == 3'h0)) & (~(patches_column_s20_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:164
  logic and_1847;
  assign and_1847 = (~(equal_1697_s20_q | (~and_1833))) & (~patches_column_s20_q[4]);
  // hls/stages/agreement.hpp:1039
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1949_s20_q} + ({2'h0, and_1950_s20_q} + {1'b0, sum_1954_s20_q});
  // hls/stages/agreement.hpp:1041
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1983_s20_q} + sum_1989_s20_q;
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_1991;
  assign select_1991 = age_s20_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1042
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1999_s20_q} + sum_2005_s20_q;
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2007;
  assign select_2007 = age_s20_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:264
  logic [10:0] select_2054;
  assign select_2054 = sample_pair_whole_s20_q ? (and_511_s20_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2056;
  assign select_2056 = sample_pair_whole_s20_q ? (and_511_s20_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2077;
  assign select_2077 = sample_pair_whole_s20_q ? (and_511_s20_q ? select_526 : averager_mask_q) : averager_mask_q;
  logic select_2079;
  assign select_2079 = sample_pair_whole_s20_q ? (and_511_s20_q ? select_530 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:508
  logic and_2411;
  assign and_2411 = and_513_s20_q & (equal_574_s20_q & equal_2286_s20_q);
  // hls/stages/agreement.hpp:773
  logic and_2420;
  assign and_2420 = not_1472_s20_q & (so_s20_q & (ends_cell_s20_q & textured_s20_q));
  // hls/stages/agreement.hpp:1040
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2435_s20_q} + sum_2441_s20_q;
  // hls/stages/agreement.hpp:1047
  logic [2:0] select_2443;
  assign select_2443 = age_s20_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2479;
  assign select_2479 = and_2411 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2477_s20_q});
  logic [13:0] select_2486;
  assign select_2486 = and_2411 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2484_s20_q});
  // hls/stages/agreement.hpp:773
  logic [10:0] select_2522;
  assign select_2522 = equal_1471_s20_q ? registration_expected_q : (so_s20_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2523;
  assign equal_2523 = slot_s20_q == 3'h4;
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2535_s20_q[7]}}, select_2535_s20_q} - {sum_1623_s20_q[9], sum_1623_s20_q, sum_1619_s20_q};
  // hls/stages/agreement.hpp:773
  logic select_2582;
  assign select_2582 = so_s20_q ? (equal_2523 ? right_2_s20_q : registration_of_right_q) : registration_of_right_q;
  logic select_2585;
  assign select_2585 = so_s20_q ? (equal_1612_s20_q ? shift_2_s20_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1081
  logic [1:0] quarter_2;
  assign quarter_2 = all_s20_q ? x_s20_q[1:0] : select_1519;
  // hls/stages/patches.hpp:344
  logic not_2779;
  assign not_2779 = ~select_1601[1];
  // hls/stages/agreement.hpp:264
  logic [1:0] select_2781;
  assign select_2781 = sample_pair_whole_s20_q ? (equal_1602 ? select_1601 : {not_2779, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:176
  logic [4:0] select_3276;
  assign select_3276 = equal_1694_s20_q ? patches_down_by_s20_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:526
  logic [4:0] select_3321;
  assign select_3321 = and_3320_s20_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:533
  logic [5:0] away;
  assign away = {1'b0, patches_step_s20_q} - {1'b0, select_3321};
  // hls/stages/agreement.hpp:1164
  logic equal_3473;
  assign equal_3473 = x_s20_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1158
  logic equal_3693;
  assign equal_3693 = x_s20_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1077
  logic [7:0] limit;
  assign limit = equal_3693 ? cfg_regions_limit_i : (equal_3695_s20_q ? cfg_hidden_limit_i : select_3711_s20_q);
  // hls/stages/agreement.hpp:1171
  logic not_3714;
  assign not_3714 = ~x_s20_q[2];
  logic [3:0] select_3715;
  assign select_3715 = x_s20_q[1] ? {x_s20_q[2], 1'b0, not_3714, 1'b0} : {1'b0, x_s20_q[2], 1'b0, not_3714};
  logic [7:0] select_3716;
  assign select_3716 = x_s20_q[0] ? {select_3715[3], 1'b0, select_3715[2], 1'b0, select_3715[1], 1'b0, select_3715[0], 1'b0} : {1'b0, select_3715[3], 1'b0, select_3715[2], 1'b0, select_3715[1], 1'b0, select_3715[0]};
  // hls/stages/agreement.hpp:1077
  logic [13:0] select_3720;
  assign select_3720 = equal_3695_s20_q ? counts_skin_supervised_q : (equal_3696_s20_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3693 ? counts_textured_q : select_3720;
  // hls/stages/agreement.hpp:773
  logic [2:0] select_3759;
  assign select_3759 = so_s20_q ? (ends_cell_s20_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3760;
  assign select_3760 = equal_1471_s20_q ? box_explained_columns_values_0_q : select_3759;
  logic [2:0] select_3761;
  assign select_3761 = ends_cell_s20_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3763;
  assign select_3763 = equal_1471_s20_q ? box_explained_columns_values_1_q : (so_s20_q ? select_3761 : box_explained_columns_values_1_q);
  logic [2:0] select_3764;
  assign select_3764 = ends_cell_s20_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3766;
  assign select_3766 = equal_1471_s20_q ? box_explained_columns_values_2_q : (so_s20_q ? select_3764 : box_explained_columns_values_2_q);
  logic [2:0] select_3767;
  assign select_3767 = ends_cell_s20_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3769;
  assign select_3769 = equal_1471_s20_q ? box_explained_columns_values_3_q : (so_s20_q ? select_3767 : box_explained_columns_values_3_q);
  logic [2:0] select_3770;
  assign select_3770 = ends_cell_s20_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3772;
  assign select_3772 = equal_1471_s20_q ? box_explained_columns_values_4_q : (so_s20_q ? select_3770 : box_explained_columns_values_4_q);
  logic [2:0] select_3777;
  assign select_3777 = so_s20_q ? (ends_cell_s20_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3779;
  assign select_3779 = ends_cell_s20_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3781;
  assign select_3781 = equal_1471_s20_q ? box_shown_columns_values_1_q : (so_s20_q ? select_3779 : box_shown_columns_values_1_q);
  logic [2:0] select_3782;
  assign select_3782 = ends_cell_s20_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3784;
  assign select_3784 = equal_1471_s20_q ? box_shown_columns_values_2_q : (so_s20_q ? select_3782 : box_shown_columns_values_2_q);
  logic [2:0] select_3785;
  assign select_3785 = ends_cell_s20_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3787;
  assign select_3787 = equal_1471_s20_q ? box_shown_columns_values_3_q : (so_s20_q ? select_3785 : box_shown_columns_values_3_q);
  logic [2:0] select_3788;
  assign select_3788 = ends_cell_s20_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3790;
  assign select_3790 = equal_1471_s20_q ? box_shown_columns_values_4_q : (so_s20_q ? select_3788 : box_shown_columns_values_4_q);
  logic [2:0] select_3795;
  assign select_3795 = so_s20_q ? (ends_cell_s20_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3797;
  assign select_3797 = ends_cell_s20_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3799;
  assign select_3799 = equal_1471_s20_q ? box_nearer_columns_values_1_q : (so_s20_q ? select_3797 : box_nearer_columns_values_1_q);
  logic [2:0] select_3800;
  assign select_3800 = ends_cell_s20_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3802;
  assign select_3802 = equal_1471_s20_q ? box_nearer_columns_values_2_q : (so_s20_q ? select_3800 : box_nearer_columns_values_2_q);
  logic [2:0] select_3803;
  assign select_3803 = ends_cell_s20_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3805;
  assign select_3805 = equal_1471_s20_q ? box_nearer_columns_values_3_q : (so_s20_q ? select_3803 : box_nearer_columns_values_3_q);
  logic [2:0] select_3806;
  assign select_3806 = ends_cell_s20_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3808;
  assign select_3808 = equal_1471_s20_q ? box_nearer_columns_values_4_q : (so_s20_q ? select_3806 : box_nearer_columns_values_4_q);

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_481_s20_q;
  logic averager_memory_we;
  assign averager_memory_we = s20_en & and_488_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_507_s20_q, and_503_s20_q, sum_499_s20_q, sum_495_s20_q};
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
      averager_mask_q <= select_2077;
      averager_of_skin_q <= select_2079;
      census_filled_q <= and_513_s20_q ? {select_577[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_513_s20_q ? select_576 : rows_passed_above_q;
      counts_textured_q <= and_2411 ? 14'h0 : (counts_textured_q + {13'h0, and_2420});
      counts_skin_supervised_q <= select_2479;
      counts_skin_textured_q <= select_2486;
      registration_expected_q <= select_2522;
      registration_of_right_q <= equal_1471_s20_q ? registration_of_right_q : select_2582;
      registration_was_inside_q <= equal_1471_s20_q ? registration_was_inside_q : select_2585;
      patches_band_q <= sample_pair_whole_s20_q ? select_1705 : patches_band_q;
      patches_fetch_q <= select_2781;
      patches_summed_down_by_q <= equal_1692_s20_q ? patches_summed_down_by_q : select_3276;
      patches_read_at_q <= equal_1692_s20_q ? select_3299_s20_q : patches_read_at_q;
      patches_peak_row_q <= equal_1692_s20_q ? select_3321 : patches_peak_row_q;
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
      averager_total_0_q <= select_2054;
      averager_total_1_q <= select_2056;
      box_explained_columns_values_0_q <= select_3760;
      box_explained_columns_values_1_q <= select_3763;
      box_explained_columns_values_2_q <= select_3766;
      box_explained_columns_values_3_q <= select_3769;
      box_explained_columns_values_4_q <= select_3772;
      box_shown_columns_values_0_q <= equal_1471_s20_q ? box_shown_columns_values_0_q : select_3777;
      box_shown_columns_values_1_q <= select_3781;
      box_shown_columns_values_2_q <= select_3784;
      box_shown_columns_values_3_q <= select_3787;
      box_shown_columns_values_4_q <= select_3790;
      box_nearer_columns_values_0_q <= equal_1471_s20_q ? box_nearer_columns_values_0_q : select_3795;
      box_nearer_columns_values_1_q <= select_3799;
      box_nearer_columns_values_2_q <= select_3802;
      box_nearer_columns_values_3_q <= select_3805;
      box_nearer_columns_values_4_q <= select_3808;
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
  logic [3:0] select_474_s21_q;
  logic [6:0] select_477_s21_q;
  logic [6:0] column_s21_q;
  logic and_511_s21_q;
  logic and_513_s21_q;
  logic [77:0] census_memory_rdata_s21_q;
  logic [8:0] grey_s21_q;
  logic equal_516_s21_q;
  logic [8:0] select_519_s21_q;
  logic [8:0] grey_2_s21_q;
  logic [8:0] select_523_s21_q;
  logic whole_2_s21_q;
  logic and_531_s21_q;
  logic so_s21_q;
  logic and_578_s21_q;
  logic equal_1471_s21_q;
  logic not_1472_s21_q;
  logic [1:0] shift_2_s21_q;
  logic equal_1516_s21_q;
  logic [1:0] quarter_s21_q;
  logic all_s21_q;
  logic [1:0] sum_1522_s21_q;
  logic [3:0] select_1523_s21_q;
  logic equal_1524_s21_q;
  logic equal_1526_s21_q;
  logic equal_1528_s21_q;
  logic equal_1530_s21_q;
  logic equal_1532_s21_q;
  logic equal_1534_s21_q;
  logic equal_1536_s21_q;
  logic equal_1538_s21_q;
  logic less_1547_s21_q;
  logic or_1551_s21_q;
  logic select_1554_s21_q;
  logic and_1564_s21_q;
  logic [3:0] select_1569_s21_q;
  logic and_1584_s21_q;
  logic [5:0] select_1600_s21_q;
  logic select_1601_s21_q;
  logic equal_1602_s21_q;
  logic and_1610_s21_q;
  logic less_1611_s21_q;
  logic equal_1612_s21_q;
  logic expected_s21_q;
  logic [10:0] sum_1625_s21_q;
  logic equal_1633_s21_q;
  logic and_1643_s21_q;
  logic [5:0] select_1658_s21_q;
  logic [7:0] select_1683_s21_q;
  logic and_1690_s21_q;
  logic and_1691_s21_q;
  logic equal_1692_s21_q;
  logic not_1693_s21_q;
  logic equal_1694_s21_q;
  logic not_1695_s21_q;
  logic equal_1697_s21_q;
  logic or_1698_s21_q;
  logic and_1707_s21_q;
  logic [4:0] select_1722_s21_q;
  logic select_1728_s21_q;
  logic [3:0] select_1767_s21_q;
  logic patches_columns_above_rdata_s21_q;
  logic [7:0] pixel_2_s21_q;
  logic less_1783_s21_q;
  logic new_row_s21_q;
  logic select_1789_s21_q;
  logic not_1790_s21_q;
  logic [4:0] select_1795_s21_q;
  logic or_1796_s21_q;
  logic [1:0] of_row_2_s21_q;
  logic [10:0] down_2_s21_q;
  logic sum_1817_s21_q;
  logic [9:0] sum_1818_s21_q;
  logic and_1836_s21_q;
  logic and_1847_s21_q;
  logic and_1850_s21_q;
  logic less_1853_s21_q;
  logic equal_1854_s21_q;
  logic not_1855_s21_q;
  logic equal_1856_s21_q;
  logic not_1857_s21_q;
  logic [9:0] patches_rows_rdata_s21_q;
  logic or_1874_s21_q;
  logic or_1877_s21_q;
  logic or_1880_s21_q;
  logic not_1882_s21_q;
  logic [29:0] regions_rdata_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1903_s21_q;
  logic and_1908_s21_q;
  logic [2:0] textured_2_s21_q;
  logic or_1966_s21_q;
  logic or_1969_s21_q;
  logic or_1972_s21_q;
  logic [3:0] difference_1992_s21_q;
  logic [3:0] difference_2008_s21_q;
  logic and_2022_s21_q;
  logic equal_2162_s21_q;
  logic equal_2286_s21_q;
  logic and_2411_s21_q;
  logic and_2415_s21_q;
  logic and_2420_s21_q;
  logic not_2434_s21_q;
  logic [3:0] difference_2444_s21_q;
  logic and_2526_s21_q;
  logic [11:0] select_2538_s21_q;
  logic equal_2587_s21_q;
  logic [3:0] not_2588_s21_q;
  logic [1:0] quarter_2_s21_q;
  logic and_2763_s21_q;
  logic less_2890_s21_q;
  logic equal_3317_s21_q;
  logic [4:0] select_3321_s21_q;
  logic [5:0] away_s21_q;
  logic equal_3323_s21_q;
  logic equal_3332_s21_q;
  logic [14:0] select_3352_s21_q;
  logic equal_3473_s21_q;
  logic and_3675_s21_q;
  logic equal_3693_s21_q;
  logic equal_3695_s21_q;
  logic equal_3696_s21_q;
  logic equal_3718_s21_q;
  logic [13:0] of_s21_q;
  logic equal_3825_s21_q;
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
      select_474_s21_q <= select_474_s20_q;
      select_477_s21_q <= select_477_s20_q;
      column_s21_q <= column_s20_q;
      and_511_s21_q <= and_511_s20_q;
      and_513_s21_q <= and_513_s20_q;
      census_memory_rdata_s21_q <= census_memory_rdata_q;
      grey_s21_q <= grey;
      equal_516_s21_q <= equal_516_s20_q;
      select_519_s21_q <= sample_pair_whole_s20_q ? total[10:2] : 9'h0;
      grey_2_s21_q <= grey_2;
      select_523_s21_q <= sample_pair_whole_s20_q ? total_2[10:2] : 9'h0;
      whole_2_s21_q <= whole_2;
      and_531_s21_q <= sample_pair_whole_s20_q & select_530;
      so_s21_q <= so_s20_q;
      and_578_s21_q <= select_576[4] & select_577[3];
      equal_1471_s21_q <= equal_1471_s20_q;
      not_1472_s21_q <= not_1472_s20_q;
      shift_2_s21_q <= shift_2_s20_q;
      equal_1516_s21_q <= equal_1516_s20_q;
      quarter_s21_q <= quarter;
      all_s21_q <= all_s20_q;
      sum_1522_s21_q <= sum_1522;
      select_1523_s21_q <= select_1523;
      equal_1524_s21_q <= equal_1524;
      equal_1526_s21_q <= equal_1526;
      equal_1528_s21_q <= equal_1528;
      equal_1530_s21_q <= equal_1530_s20_q;
      equal_1532_s21_q <= equal_1532_s20_q;
      equal_1534_s21_q <= equal_1534_s20_q;
      equal_1536_s21_q <= equal_1536_s20_q;
      equal_1538_s21_q <= equal_1538_s20_q;
      less_1547_s21_q <= less_1547;
      or_1551_s21_q <= or_1551;
      select_1554_s21_q <= equal_1516_s20_q ? and_1546 : (less_1547 & (~or_1551));
      and_1564_s21_q <= half_ends & ({{3{sum_1562[4]}}, sum_1562} < 8'h3);
      select_1569_s21_q <= select_1569;
      and_1584_s21_q <= and_1584_s20_q;
      select_1600_s21_q <= select_1600;
      select_1601_s21_q <= select_1601[1];
      equal_1602_s21_q <= equal_1602;
      and_1610_s21_q <= and_1610_s20_q;
      less_1611_s21_q <= less_1611_s20_q;
      equal_1612_s21_q <= equal_1612_s20_q;
      expected_s21_q <= expected[0];
      sum_1625_s21_q <= {expected[10], expected[10:1]} + 11'h5;
      equal_1633_s21_q <= equal_1633_s20_q;
      and_1643_s21_q <= and_1643_s20_q;
      select_1658_s21_q <= select_1658_s20_q;
      select_1683_s21_q <= select_1683_s20_q;
      and_1690_s21_q <= and_1690_s20_q;
      and_1691_s21_q <= and_1691_s20_q;
      equal_1692_s21_q <= equal_1692_s20_q;
      not_1693_s21_q <= not_1693_s20_q;
      equal_1694_s21_q <= equal_1694_s20_q;
      not_1695_s21_q <= not_1695_s20_q;
      equal_1697_s21_q <= equal_1697_s20_q;
      or_1698_s21_q <= or_1698_s20_q;
      and_1707_s21_q <= and_1691_s20_q & equal_1706;
      select_1722_s21_q <= select_1722_s20_q;
      select_1728_s21_q <= select_1728_s20_q;
      select_1767_s21_q <= select_1767_s20_q;
      patches_columns_above_rdata_s21_q <= patches_columns_above_rdata_s20_q[8];
      pixel_2_s21_q <= pixel_2_s20_q;
      less_1783_s21_q <= less_1783;
      new_row_s21_q <= new_row;
      select_1789_s21_q <= select_1789;
      not_1790_s21_q <= ~or_1784;
      select_1795_s21_q <= select_1795;
      or_1796_s21_q <= equal_1696_s20_q | equal_1694_s20_q;
      of_row_2_s21_q <= of_row_2;
      down_2_s21_q <= down_2;
      sum_1817_s21_q <= sum_1817_s20_q[0];
      sum_1818_s21_q <= sum_1818;
      and_1836_s21_q <= or_1698_s20_q & (or_1828 & (equal_1697_s20_q & and_1833));
      and_1847_s21_q <= and_1847;
      and_1850_s21_q <= or_1698_s20_q & (and_1847 & (patches_column_s20_q == 5'hf));
      less_1853_s21_q <= less_1853_s20_q;
      equal_1854_s21_q <= equal_1854_s20_q;
      not_1855_s21_q <= not_1855_s20_q;
      equal_1856_s21_q <= equal_1856_s20_q;
      not_1857_s21_q <= not_1857_s20_q;
      patches_rows_rdata_s21_q <= patches_rows_rdata_s20_q;
      or_1874_s21_q <= or_1874_s20_q;
      or_1877_s21_q <= or_1877_s20_q;
      or_1880_s21_q <= or_1880_s20_q;
      not_1882_s21_q <= not_1882_s20_q;
      regions_rdata_s21_q <= regions_rdata_q;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1903_s21_q <= and_1903_s20_q;
      and_1908_s21_q <= and_1908_s20_q;
      textured_2_s21_q <= textured_2;
      or_1966_s21_q <= or_1966_s20_q;
      or_1969_s21_q <= or_1969_s20_q;
      or_1972_s21_q <= or_1972_s20_q;
      difference_1992_s21_q <= {1'b0, shown_2} - {1'b0, select_1991};
      difference_2008_s21_q <= {1'b0, near_2} - {1'b0, select_2007};
      and_2022_s21_q <= and_2022_s20_q;
      equal_2162_s21_q <= equal_2162_s20_q;
      equal_2286_s21_q <= equal_2286_s20_q;
      and_2411_s21_q <= and_2411;
      and_2415_s21_q <= and_2415_s20_q;
      and_2420_s21_q <= and_2420;
      not_2434_s21_q <= not_2434_s20_q;
      difference_2444_s21_q <= {1'b0, explained_2} - {1'b0, select_2443};
      and_2526_s21_q <= not_1472_s20_q & (so_s20_q & (half_ends & equal_2523));
      select_2538_s21_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2587_s21_q <= sum_1522 == 2'h2;
      not_2588_s21_q <= ~select_1569;
      quarter_2_s21_q <= quarter_2;
      and_2763_s21_q <= and_2763_s20_q;
      less_2890_s21_q <= 4'he < patches_column_s20_q[4:1];
      equal_3317_s21_q <= equal_3317_s20_q;
      select_3321_s21_q <= select_3321;
      away_s21_q <= away;
      equal_3323_s21_q <= away == 6'h3f;
      equal_3332_s21_q <= away == 6'h1;
      select_3352_s21_q <= select_3352_s20_q;
      equal_3473_s21_q <= equal_3473;
      and_3675_s21_q <= equal_3674_s20_q & equal_3473;
      equal_3693_s21_q <= equal_3693;
      equal_3695_s21_q <= equal_3695_s20_q;
      equal_3696_s21_q <= equal_3696_s20_q;
      equal_3718_s21_q <= (limit & select_3716) == 8'h0;
      of_s21_q <= of;
      equal_3825_s21_q <= equal_3825_s20_q;
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
  logic less_547;
  assign less_547 = census_memory_rdata_s21_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_548;
  assign less_548 = census_memory_rdata_s21_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_549;
  assign less_549 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_550;
  assign less_550 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_551;
  assign less_551 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_552;
  assign less_552 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_553;
  assign less_553 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_554;
  assign less_554 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_555;
  assign less_555 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_556;
  assign less_556 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_557;
  assign less_557 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_558;
  assign less_558 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_559;
  assign less_559 = census_memory_rdata_s21_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_560;
  assign less_560 = census_memory_rdata_s21_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_561;
  assign less_561 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_562;
  assign less_562 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_563;
  assign less_563 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_564;
  assign less_564 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_565;
  assign less_565 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_566;
  assign less_566 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_567;
  assign less_567 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_568;
  assign less_568 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_569;
  assign less_569 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_570;
  assign less_570 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:286
  logic and_580;
  assign and_580 = census_memory_rdata_s21_q[38] & (census_memory_rdata_s21_q[18] & whole_2_s21_q);
  logic and_582;
  assign and_582 = census_memory_rdata_s21_q[77] & (census_memory_rdata_s21_q[58] & and_580);
  // hls/stages/census.hpp:270
  logic [9:0] difference_605;
  assign difference_605 = {1'b0, select_519_s21_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_608;
  assign difference_608 = {1'b0, census_memory_rdata_s21_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_612;
  assign difference_612 = {1'b0, census_memory_rdata_s21_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_616;
  assign difference_616 = {1'b0, census_memory_rdata_s21_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_620;
  assign difference_620 = {1'b0, census_memory_rdata_s21_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/agreement.hpp:773
  logic and_1565;
  assign and_1565 = so_s21_q & and_1564_s21_q;
  // hls/stages/patches.hpp:90
  logic less_1626;
  assign less_1626 = {{4{sum_1625_s21_q[10]}}, sum_1625_s21_q, expected_s21_q} < 16'h15;
  // hls/stages/patches.hpp:103
  logic and_1644;
  assign and_1644 = (less_1611_s21_q & (shift_2_s21_q[1] & less_1626)) & and_1643_s21_q;
  // hls/stages/patches.hpp:457
  logic [11:0] sum_1808;
  assign sum_1808 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1809;
  assign sum_1809 = {{4{down_2_s21_q[10]}}, down_2_s21_q[10:2]} + {sum_1808[11], sum_1808};
  // hls/stages/patches.hpp:454
  logic [11:0] smooth;
  assign smooth = {sum_1818_s21_q, sum_1817_s21_q, patches_columns_above_rdata_s21_q} + {4'h0, pixel_2_s21_q};
  // hls/stages/agreement.hpp:876
  logic [6:0] select_1893;
  assign select_1893 = segment_started_s21_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:877
  logic [6:0] sum_1894;
  assign sum_1894 = {6'h0, textured_s21_q} + select_1893;
  // hls/stages/agreement.hpp:1013
  logic [9:0] sum_1896;
  assign sum_1896 = {3'h0, sum_1894} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[9:0]);
  // hls/stages/agreement.hpp:876
  logic [6:0] select_1898;
  assign select_1898 = segment_started_s21_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:877
  logic [6:0] sum_1899;
  assign sum_1899 = {6'h0, explained_s21_q} + select_1898;
  // hls/stages/agreement.hpp:1014
  logic [9:0] sum_1901;
  assign sum_1901 = {3'h0, sum_1899} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[19:10]);
  // hls/stages/agreement.hpp:876
  logic [6:0] select_1904;
  assign select_1904 = segment_started_s21_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:878
  logic [6:0] sum_1905;
  assign sum_1905 = {6'h0, and_1903_s21_q} + select_1904;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_1907;
  assign sum_1907 = {3'h0, sum_1905} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[29:20]);
  // hls/stages/agreement.hpp:1212
  logic or_1917;
  assign or_1917 = marks_first_s21_q | line_ended_q;
  // hls/stages/agreement.hpp:1214
  logic [12:0] select_1919;
  assign select_1919 = marks_first_s21_q ? 13'h1 : (or_1917 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1213
  logic [8:0] select_1921;
  assign select_1921 = or_1917 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1221
  logic select_1923;
  assign select_1923 = cfg_compete_i ? (or_1917 & select_1919[12]) : (select_1921[8] & select_1919[9]);
  // hls/stages/agreement.hpp:1046
  logic [2:0] select_1957;
  assign select_1957 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1048
  logic [4:0] around;
  assign around = {difference_1992_s21_q[3], difference_1992_s21_q} + (equal_1633_s21_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1049
  logic [4:0] n;
  assign n = {difference_2008_s21_q[3], difference_2008_s21_q} + (equal_1633_s21_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:264
  logic [8:0] select_2046;
  assign select_2046 = sample_pair_whole_s21_q ? (and_511_s21_q ? grey_s21_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2048;
  assign select_2048 = sample_pair_whole_s21_q ? (and_511_s21_q ? grey_2_s21_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2050;
  assign select_2050 = sample_pair_whole_s21_q ? (and_511_s21_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2052;
  assign select_2052 = sample_pair_whole_s21_q ? (and_511_s21_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2057;
  assign sum_2057 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s21_q};
  logic [9:0] sum_2065;
  assign sum_2065 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s21_q};
  // hls/stages/agreement.hpp:508
  logic [8:0] select_2080;
  assign select_2080 = and_513_s21_q ? select_519_s21_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2081;
  assign select_2081 = and_513_s21_q ? select_523_s21_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2083;
  assign select_2083 = and_513_s21_q ? census_memory_rdata_s21_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2084;
  assign select_2084 = and_513_s21_q ? census_memory_rdata_s21_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2085;
  assign select_2085 = and_513_s21_q ? census_memory_rdata_s21_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2086;
  assign select_2086 = and_513_s21_q ? census_memory_rdata_s21_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2087;
  assign select_2087 = and_513_s21_q ? census_memory_rdata_s21_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2088;
  assign select_2088 = and_513_s21_q ? census_memory_rdata_s21_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2089;
  assign select_2089 = and_513_s21_q ? census_memory_rdata_s21_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2090;
  assign select_2090 = and_513_s21_q ? census_memory_rdata_s21_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2091;
  assign select_2091 = and_513_s21_q ? census_memory_rdata_s21_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2092;
  assign select_2092 = and_513_s21_q ? census_memory_rdata_s21_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2093;
  assign select_2093 = and_513_s21_q ? census_memory_rdata_s21_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2094;
  assign select_2094 = and_513_s21_q ? census_memory_rdata_s21_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2095;
  assign select_2095 = and_513_s21_q ? census_memory_rdata_s21_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2096;
  assign select_2096 = and_513_s21_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2097;
  assign select_2097 = and_513_s21_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2099;
  assign select_2099 = and_513_s21_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2100;
  assign select_2100 = and_513_s21_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2102;
  assign select_2102 = and_513_s21_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2103;
  assign select_2103 = and_513_s21_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2105;
  assign select_2105 = and_513_s21_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2106;
  assign select_2106 = and_513_s21_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2107;
  assign select_2107 = and_513_s21_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2109;
  assign select_2109 = and_513_s21_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2110;
  assign select_2110 = and_513_s21_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2112;
  assign select_2112 = and_513_s21_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2113;
  assign select_2113 = and_513_s21_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2115;
  assign select_2115 = and_513_s21_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2116;
  assign select_2116 = and_513_s21_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2118;
  assign select_2118 = and_513_s21_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2119;
  assign select_2119 = and_513_s21_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2121;
  assign select_2121 = and_513_s21_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2122;
  assign select_2122 = and_513_s21_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2124;
  assign select_2124 = and_513_s21_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2125;
  assign select_2125 = and_513_s21_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2128;
  assign select_2128 = and_513_s21_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2129;
  assign select_2129 = and_513_s21_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2132;
  assign select_2132 = and_513_s21_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2133;
  assign select_2133 = and_513_s21_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2137;
  assign difference_2137 = {1'b0, select_523_s21_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2140;
  assign difference_2140 = {1'b0, census_memory_rdata_s21_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2144;
  assign difference_2144 = {1'b0, census_memory_rdata_s21_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2148;
  assign difference_2148 = {1'b0, census_memory_rdata_s21_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2152;
  assign difference_2152 = {1'b0, census_memory_rdata_s21_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2183;
  assign difference_2183 = {1'b0, select_519_s21_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2195;
  assign difference_2195 = {1'b0, select_523_s21_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:773
  logic and_2425;
  assign and_2425 = not_1472_s21_q & (so_s21_q & (ends_cell_s21_q & explained_s21_q));
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2427;
  assign select_2427 = and_2411_s21_q ? 14'h0 : (counts_explained_q + {13'h0, and_2425});
  // hls/stages/agreement.hpp:773
  logic and_2430;
  assign and_2430 = not_1472_s21_q & (so_s21_q & (ends_cell_s21_q & and_1903_s21_q));
  // hls/stages/agreement.hpp:1047
  logic [4:0] e;
  assign e = {difference_2444_s21_q[3], difference_2444_s21_q} + (equal_1633_s21_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1084
  logic less_2459;
  assign less_2459 = region_row_s21_q < x_s21_q[5:3];
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2538_s21_q[11:7])) ? 12'h7f : select_2538_s21_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2590;
  assign select_2590 = equal_2587_s21_q ? (registration_fresh_q & not_2588_s21_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:773
  logic [3:0] select_2592;
  assign select_2592 = so_s21_q ? (and_1564_s21_q ? select_2590 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2594;
  assign select_2594 = and_2411_s21_q ? 4'hf : (equal_1471_s21_q ? registration_fresh_q : select_2592);
  // hls/stages/registration.hpp:258
  logic not_2615;
  assign not_2615 = ~quarter_2_s21_q[1];
  logic [3:0] select_2616;
  assign select_2616 = quarter_2_s21_q[0] ? {quarter_2_s21_q[1], 1'b0, not_2615, 1'b0} : {1'b0, quarter_2_s21_q[1], 1'b0, not_2615};
  // hls/stages/patches.hpp:176
  logic [10:0] select_2868;
  assign select_2868 = equal_1694_s21_q ? patches_down_values_0_q : (or_1698_s21_q ? down_2_s21_q : patches_down_values_0_q);
  logic [10:0] select_2870;
  assign select_2870 = or_1698_s21_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_2872;
  assign select_2872 = equal_1692_s21_q ? patches_down_values_1_q : (equal_1694_s21_q ? patches_down_values_1_q : select_2870);
  // hls/stages/patches.hpp:542
  logic and_3325;
  assign and_3325 = less_1853_s21_q & (equal_3317_s21_q & equal_3323_s21_q);
  // hls/stages/patches.hpp:546
  logic select_3328;
  assign select_3328 = equal_1856_s21_q ? (less_1853_s21_q ? (not_1857_s21_q & and_3325) : and_3325) : and_3325;
  // hls/stages/patches.hpp:542
  logic and_3334;
  assign and_3334 = less_1853_s21_q & (equal_3317_s21_q & equal_3332_s21_q);
  // hls/stages/patches.hpp:546
  logic select_3337;
  assign select_3337 = equal_1856_s21_q ? (less_1853_s21_q ? (not_1857_s21_q & and_3334) : and_3334) : and_3334;
  // hls/stages/patches.hpp:539
  logic [6:0] sum_3341;
  assign sum_3341 = {away_s21_q[5], away_s21_q} + 7'h7d;
  // hls/stages/agreement.hpp:1171
  logic [13:0] select_3707;
  assign select_3707 = equal_3473_s21_q ? 14'h0 : product_q;
  logic [13:0] select_3722;
  assign select_3722 = equal_3718_s21_q ? 14'h0 : of_s21_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3707} + {1'b0, select_3722};
  // hls/stages/agreement.hpp:773
  logic [2:0] select_3740;
  assign select_3740 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_3742;
  assign select_3742 = equal_1471_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_3740 : box_textured_columns_values_0_q);
  logic [2:0] select_3743;
  assign select_3743 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3745;
  assign select_3745 = equal_1471_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_3743 : box_textured_columns_values_1_q);
  logic [2:0] select_3746;
  assign select_3746 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3748;
  assign select_3748 = equal_1471_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_3746 : box_textured_columns_values_2_q);
  logic [2:0] select_3749;
  assign select_3749 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3751;
  assign select_3751 = equal_1471_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_3749 : box_textured_columns_values_3_q);
  logic [2:0] select_3752;
  assign select_3752 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3754;
  assign select_3754 = equal_1471_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_3752 : box_textured_columns_values_4_q);
  logic [4:0] select_3774;
  assign select_3774 = so_s21_q ? (ends_cell_s21_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3775;
  assign select_3775 = equal_1471_s21_q ? box_explained_sum_sums_values_0_q : select_3774;
  logic [4:0] select_3792;
  assign select_3792 = so_s21_q ? (ends_cell_s21_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_3810;
  assign select_3810 = so_s21_q ? (ends_cell_s21_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/registration.hpp:258
  logic not_3911;
  assign not_3911 = ~quarter_s21_q[1];
  logic [3:0] select_3912;
  assign select_3912 = quarter_s21_q[0] ? {quarter_s21_q[1], 1'b0, not_3911, 1'b0} : {1'b0, quarter_s21_q[1], 1'b0, not_3911};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 21, written in stage 25: 21 < 25 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1523_s21_q;
  logic registration_sums_re;
  assign registration_sums_re = s21_en & (equal_1471_s21_q ? (x_s21_q[6] & select_1554_s21_q) : and_1565);
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
  assign patches_choices_raddr = select_1600_s21_q;
  logic patches_choices_re;
  assign patches_choices_re = s21_en & (sample_pair_whole_s21_q & (~equal_1602_s21_q));
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
  assign patches_right_codes_raddr = {select_1795_s21_q, not_1790_s21_q, select_1789_s21_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s21_en & or_1796_s21_q;
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
  assign patches_left_codes_re = s21_en & (not_1693_s21_q & (new_row_s21_q & equal_1694_s21_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s21_q;
  logic census_memory_we;
  assign census_memory_we = s21_en & and_513_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s21_q[58:40], census_memory_rdata_s21_q[38:0], and_531_s21_q, whole_2_s21_q, select_523_s21_q, select_519_s21_q};
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
      counts_explained_q <= select_2427;
      registration_fresh_q <= select_2594;
      patches_down_values_0_q <= equal_1692_s21_q ? patches_down_values_0_q : select_2868;
      patches_down_values_1_q <= select_2872;
      segment_textured_q <= select_1893 + {6'h0, and_2420_s21_q};
      segment_explained_q <= select_1898 + {6'h0, and_2425};
      segment_nearer_q <= select_1904 + {6'h0, and_2430};
      product_q <= equal_1471_s21_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_1919;
      columns_passed_q <= {select_1921[7:0], or_1917};
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
      averager_quarter_1_0_q <= select_2046;
      averager_quarter_1_1_q <= select_2048;
      averager_quarter_2_0_q <= select_2050;
      averager_quarter_2_1_q <= select_2052;
      census_columns_values_0_cell_0_left_q <= select_2080;
      census_columns_values_0_cell_0_right_q <= select_2081;
      census_columns_values_0_cell_1_left_q <= select_2083;
      census_columns_values_0_cell_1_right_q <= select_2084;
      census_columns_values_0_cell_1_mask_q <= select_2085;
      census_columns_values_0_cell_2_left_q <= select_2086;
      census_columns_values_0_cell_2_right_q <= select_2087;
      census_columns_values_0_cell_2_mask_q <= select_2088;
      census_columns_values_0_cell_2_of_skin_q <= select_2089;
      census_columns_values_0_cell_3_left_q <= select_2090;
      census_columns_values_0_cell_3_right_q <= select_2091;
      census_columns_values_0_cell_3_mask_q <= select_2092;
      census_columns_values_0_cell_4_left_q <= select_2093;
      census_columns_values_0_cell_4_right_q <= select_2094;
      census_columns_values_0_cell_4_mask_q <= select_2095;
      census_columns_values_1_cell_0_left_q <= select_2096;
      census_columns_values_1_cell_0_right_q <= select_2097;
      census_columns_values_1_cell_1_left_q <= select_2099;
      census_columns_values_1_cell_1_right_q <= select_2100;
      census_columns_values_1_cell_2_left_q <= select_2102;
      census_columns_values_1_cell_2_right_q <= select_2103;
      census_columns_values_1_cell_2_of_skin_q <= select_2105;
      census_columns_values_1_cell_3_left_q <= select_2106;
      census_columns_values_1_cell_3_right_q <= select_2107;
      census_columns_values_1_cell_4_left_q <= select_2109;
      census_columns_values_1_cell_4_right_q <= select_2110;
      census_columns_values_2_cell_0_left_q <= select_2112;
      census_columns_values_2_cell_0_right_q <= select_2113;
      census_columns_values_2_cell_1_left_q <= select_2115;
      census_columns_values_2_cell_1_right_q <= select_2116;
      census_columns_values_2_cell_2_left_q <= select_2118;
      census_columns_values_2_cell_2_right_q <= select_2119;
      census_columns_values_2_cell_3_left_q <= select_2121;
      census_columns_values_2_cell_3_right_q <= select_2122;
      census_columns_values_2_cell_4_left_q <= select_2124;
      census_columns_values_2_cell_4_right_q <= select_2125;
      census_columns_values_3_cell_1_left_q <= select_2128;
      census_columns_values_3_cell_1_right_q <= select_2129;
      census_columns_values_3_cell_3_left_q <= select_2132;
      census_columns_values_3_cell_3_right_q <= select_2133;
      sharpness_last_mean_0_q <= and_513_s21_q ? select_519_s21_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_513_s21_q ? select_523_s21_q : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= select_3742;
      box_textured_columns_values_1_q <= select_3745;
      box_textured_columns_values_2_q <= select_3748;
      box_textured_columns_values_3_q <= select_3751;
      box_textured_columns_values_4_q <= select_3754;
      box_explained_sum_sums_values_0_q <= select_3775;
      box_shown_sum_sums_values_0_q <= equal_1471_s21_q ? box_shown_sum_sums_values_0_q : select_3792;
      box_nearer_sum_sums_values_0_q <= equal_1471_s21_q ? box_nearer_sum_sums_values_0_q : select_3810;
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
  logic [3:0] select_474_s22_q;
  logic [6:0] select_477_s22_q;
  logic [6:0] column_s22_q;
  logic and_511_s22_q;
  logic and_513_s22_q;
  logic equal_516_s22_q;
  logic whole_2_s22_q;
  logic so_s22_q;
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
  logic less_568_s22_q;
  logic less_569_s22_q;
  logic less_570_s22_q;
  logic and_578_s22_q;
  logic and_582_s22_q;
  logic difference_605_s22_q;
  logic [8:0] xor_606_s22_q;
  logic difference_608_s22_q;
  logic [8:0] xor_609_s22_q;
  logic difference_612_s22_q;
  logic [8:0] xor_613_s22_q;
  logic difference_616_s22_q;
  logic [8:0] xor_617_s22_q;
  logic difference_620_s22_q;
  logic [8:0] xor_621_s22_q;
  logic equal_1471_s22_q;
  logic not_1472_s22_q;
  logic shift_2_s22_q;
  logic equal_1516_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1522_s22_q;
  logic equal_1524_s22_q;
  logic equal_1526_s22_q;
  logic equal_1528_s22_q;
  logic equal_1530_s22_q;
  logic equal_1532_s22_q;
  logic equal_1534_s22_q;
  logic equal_1536_s22_q;
  logic equal_1538_s22_q;
  logic less_1547_s22_q;
  logic or_1551_s22_q;
  logic equal_1571_s22_q;
  logic and_1581_s22_q;
  logic and_1584_s22_q;
  logic select_1601_s22_q;
  logic equal_1602_s22_q;
  logic and_1610_s22_q;
  logic equal_1612_s22_q;
  logic equal_1633_s22_q;
  logic and_1644_s22_q;
  logic [5:0] select_1658_s22_q;
  logic [7:0] select_1683_s22_q;
  logic and_1690_s22_q;
  logic and_1691_s22_q;
  logic equal_1692_s22_q;
  logic equal_1694_s22_q;
  logic equal_1697_s22_q;
  logic or_1698_s22_q;
  logic and_1707_s22_q;
  logic [4:0] select_1722_s22_q;
  logic select_1728_s22_q;
  logic [3:0] select_1767_s22_q;
  logic less_1783_s22_q;
  logic new_row_s22_q;
  logic or_1796_s22_q;
  logic [1:0] of_row_2_s22_q;
  logic [1:0] down_2_s22_q;
  logic [12:0] sum_1809_s22_q;
  logic [11:0] smooth_s22_q;
  logic and_1838_s22_q;
  logic and_1847_s22_q;
  logic and_1852_s22_q;
  logic less_1853_s22_q;
  logic equal_1854_s22_q;
  logic not_1855_s22_q;
  logic equal_1856_s22_q;
  logic [9:0] patches_rows_rdata_s22_q;
  logic or_1874_s22_q;
  logic or_1877_s22_q;
  logic or_1880_s22_q;
  logic not_1882_s22_q;
  logic [9:0] sum_1896_s22_q;
  logic [9:0] sum_1901_s22_q;
  logic [9:0] sum_1907_s22_q;
  logic and_1908_s22_q;
  logic select_1923_s22_q;
  logic [3:0] difference_1958_s22_q;
  logic or_1966_s22_q;
  logic or_1969_s22_q;
  logic or_1972_s22_q;
  logic [4:0] around_s22_q;
  logic less_2011_s22_q;
  logic and_2022_s22_q;
  logic sum_2057_s22_q;
  logic [9:0] difference_2058_s22_q;
  logic sum_2065_s22_q;
  logic [9:0] difference_2066_s22_q;
  logic difference_2137_s22_q;
  logic [8:0] xor_2138_s22_q;
  logic difference_2140_s22_q;
  logic [8:0] xor_2141_s22_q;
  logic difference_2144_s22_q;
  logic [8:0] xor_2145_s22_q;
  logic difference_2148_s22_q;
  logic [8:0] xor_2149_s22_q;
  logic difference_2152_s22_q;
  logic [8:0] xor_2153_s22_q;
  logic equal_2162_s22_q;
  logic difference_2183_s22_q;
  logic [8:0] xor_2184_s22_q;
  logic difference_2195_s22_q;
  logic [8:0] xor_2196_s22_q;
  logic equal_2286_s22_q;
  logic and_2411_s22_q;
  logic and_2415_s22_q;
  logic and_2430_s22_q;
  logic not_2434_s22_q;
  logic [4:0] e_s22_q;
  logic [9:0] select_2460_s22_q;
  logic [9:0] select_2463_s22_q;
  logic and_2526_s22_q;
  logic and_2527_s22_q;
  logic [11:0] residual_s22_q;
  logic equal_2618_s22_q;
  logic and_2763_s22_q;
  logic less_2890_s22_q;
  logic equal_3233_s22_q;
  logic [4:0] select_3321_s22_q;
  logic select_3328_s22_q;
  logic select_3337_s22_q;
  logic and_3343_s22_q;
  logic [14:0] select_3352_s22_q;
  logic equal_3473_s22_q;
  logic and_3675_s22_q;
  logic less_3676_s22_q;
  logic equal_3677_s22_q;
  logic equal_3693_s22_q;
  logic equal_3695_s22_q;
  logic equal_3696_s22_q;
  logic sum_4_s22_q;
  logic equal_3825_s22_q;
  logic equal_3914_s22_q;
  logic [9:0] select_3924_s22_q;
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
      select_474_s22_q <= select_474_s21_q;
      select_477_s22_q <= select_477_s21_q;
      column_s22_q <= column_s21_q;
      and_511_s22_q <= and_511_s21_q;
      and_513_s22_q <= and_513_s21_q;
      equal_516_s22_q <= equal_516_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      so_s22_q <= so_s21_q;
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
      less_568_s22_q <= less_568;
      less_569_s22_q <= less_569;
      less_570_s22_q <= less_570;
      and_578_s22_q <= and_578_s21_q;
      and_582_s22_q <= and_582;
      difference_605_s22_q <= difference_605[9];
      xor_606_s22_q <= difference_605[8:0] ^ {9{difference_605[9]}};
      difference_608_s22_q <= difference_608[9];
      xor_609_s22_q <= difference_608[8:0] ^ {9{difference_608[9]}};
      difference_612_s22_q <= difference_612[9];
      xor_613_s22_q <= difference_612[8:0] ^ {9{difference_612[9]}};
      difference_616_s22_q <= difference_616[9];
      xor_617_s22_q <= difference_616[8:0] ^ {9{difference_616[9]}};
      difference_620_s22_q <= difference_620[9];
      xor_621_s22_q <= difference_620[8:0] ^ {9{difference_620[9]}};
      equal_1471_s22_q <= equal_1471_s21_q;
      not_1472_s22_q <= not_1472_s21_q;
      shift_2_s22_q <= shift_2_s21_q[0];
      equal_1516_s22_q <= equal_1516_s21_q;
      all_s22_q <= all_s21_q;
      sum_1522_s22_q <= sum_1522_s21_q;
      equal_1524_s22_q <= equal_1524_s21_q;
      equal_1526_s22_q <= equal_1526_s21_q;
      equal_1528_s22_q <= equal_1528_s21_q;
      equal_1530_s22_q <= equal_1530_s21_q;
      equal_1532_s22_q <= equal_1532_s21_q;
      equal_1534_s22_q <= equal_1534_s21_q;
      equal_1536_s22_q <= equal_1536_s21_q;
      equal_1538_s22_q <= equal_1538_s21_q;
      less_1547_s22_q <= less_1547_s21_q;
      or_1551_s22_q <= or_1551_s21_q;
      equal_1571_s22_q <= (registration_fresh_q & select_1569_s21_q) == 4'h0;
      and_1581_s22_q <= not_1472_s21_q & and_1565;
      and_1584_s22_q <= and_1584_s21_q;
      select_1601_s22_q <= select_1601_s21_q;
      equal_1602_s22_q <= equal_1602_s21_q;
      and_1610_s22_q <= and_1610_s21_q;
      equal_1612_s22_q <= equal_1612_s21_q;
      equal_1633_s22_q <= equal_1633_s21_q;
      and_1644_s22_q <= and_1644;
      select_1658_s22_q <= select_1658_s21_q;
      select_1683_s22_q <= select_1683_s21_q;
      and_1690_s22_q <= and_1690_s21_q;
      and_1691_s22_q <= and_1691_s21_q;
      equal_1692_s22_q <= equal_1692_s21_q;
      equal_1694_s22_q <= equal_1694_s21_q;
      equal_1697_s22_q <= equal_1697_s21_q;
      or_1698_s22_q <= or_1698_s21_q;
      and_1707_s22_q <= and_1707_s21_q;
      select_1722_s22_q <= select_1722_s21_q;
      select_1728_s22_q <= select_1728_s21_q;
      select_1767_s22_q <= select_1767_s21_q;
      less_1783_s22_q <= less_1783_s21_q;
      new_row_s22_q <= new_row_s21_q;
      or_1796_s22_q <= or_1796_s21_q;
      of_row_2_s22_q <= of_row_2_s21_q;
      down_2_s22_q <= down_2_s21_q[1:0];
      sum_1809_s22_q <= sum_1809;
      smooth_s22_q <= smooth;
      and_1838_s22_q <= not_1693_s21_q & (not_1695_s21_q & and_1836_s21_q);
      and_1847_s22_q <= and_1847_s21_q;
      and_1852_s22_q <= not_1693_s21_q & (not_1695_s21_q & and_1850_s21_q);
      less_1853_s22_q <= less_1853_s21_q;
      equal_1854_s22_q <= equal_1854_s21_q;
      not_1855_s22_q <= not_1855_s21_q;
      equal_1856_s22_q <= equal_1856_s21_q;
      patches_rows_rdata_s22_q <= patches_rows_rdata_s21_q;
      or_1874_s22_q <= or_1874_s21_q;
      or_1877_s22_q <= or_1877_s21_q;
      or_1880_s22_q <= or_1880_s21_q;
      not_1882_s22_q <= not_1882_s21_q;
      sum_1896_s22_q <= sum_1896;
      sum_1901_s22_q <= sum_1901;
      sum_1907_s22_q <= sum_1907;
      and_1908_s22_q <= and_1908_s21_q;
      select_1923_s22_q <= select_1923;
      difference_1958_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1957};
      or_1966_s22_q <= or_1966_s21_q;
      or_1969_s22_q <= or_1969_s21_q;
      or_1972_s22_q <= or_1972_s21_q;
      around_s22_q <= around;
      less_2011_s22_q <= {1'b0, around[4:1]} < n;
      and_2022_s22_q <= and_2022_s21_q;
      sum_2057_s22_q <= sum_2057[0];
      difference_2058_s22_q <= {1'b0, sum_2057[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2065_s22_q <= sum_2065[0];
      difference_2066_s22_q <= {1'b0, sum_2065[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2137_s22_q <= difference_2137[9];
      xor_2138_s22_q <= difference_2137[8:0] ^ {9{difference_2137[9]}};
      difference_2140_s22_q <= difference_2140[9];
      xor_2141_s22_q <= difference_2140[8:0] ^ {9{difference_2140[9]}};
      difference_2144_s22_q <= difference_2144[9];
      xor_2145_s22_q <= difference_2144[8:0] ^ {9{difference_2144[9]}};
      difference_2148_s22_q <= difference_2148[9];
      xor_2149_s22_q <= difference_2148[8:0] ^ {9{difference_2148[9]}};
      difference_2152_s22_q <= difference_2152[9];
      xor_2153_s22_q <= difference_2152[8:0] ^ {9{difference_2152[9]}};
      equal_2162_s22_q <= equal_2162_s21_q;
      difference_2183_s22_q <= difference_2183[9];
      xor_2184_s22_q <= difference_2183[8:0] ^ {9{difference_2183[9]}};
      difference_2195_s22_q <= difference_2195[9];
      xor_2196_s22_q <= difference_2195[8:0] ^ {9{difference_2195[9]}};
      equal_2286_s22_q <= equal_2286_s21_q;
      and_2411_s22_q <= and_2411_s21_q;
      and_2415_s22_q <= and_2415_s21_q;
      and_2430_s22_q <= and_2430;
      not_2434_s22_q <= not_2434_s21_q;
      e_s22_q <= e;
      select_2460_s22_q <= less_2459 ? 10'h0 : regions_rdata_s21_q[9:0];
      select_2463_s22_q <= less_2459 ? 10'h0 : regions_rdata_s21_q[19:10];
      and_2526_s22_q <= and_2526_s21_q;
      and_2527_s22_q <= shift_2_s21_q[1] & less_1611_s21_q;
      residual_s22_q <= residual;
      equal_2618_s22_q <= (registration_fresh_q & select_2616) == 4'h0;
      and_2763_s22_q <= and_2763_s21_q;
      less_2890_s22_q <= less_2890_s21_q;
      equal_3233_s22_q <= patches_match_row_s21_q == 4'h0;
      select_3321_s22_q <= select_3321_s21_q;
      select_3328_s22_q <= select_3328;
      select_3337_s22_q <= select_3337;
      and_3343_s22_q <= equal_3317_s21_q & ({sum_3341[6], sum_3341} < 8'hfb);
      select_3352_s22_q <= select_3352_s21_q;
      equal_3473_s22_q <= equal_3473_s21_q;
      and_3675_s22_q <= and_3675_s21_q;
      less_3676_s22_q <= counts_explained_q < product_q;
      equal_3677_s22_q <= counts_explained_q == product_q;
      equal_3693_s22_q <= equal_3693_s21_q;
      equal_3695_s22_q <= equal_3695_s21_q;
      equal_3696_s22_q <= equal_3696_s21_q;
      sum_4_s22_q <= sum_4[0];
      equal_3825_s22_q <= equal_3825_s21_q;
      equal_3914_s22_q <= (registration_fresh_q & select_3912) == 4'h0;
      select_3924_s22_q <= less_2459 ? 10'h0 : regions_rdata_s21_q[29:20];
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
  // hls/stages/agreement.hpp:444
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_582_s22_q;
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
  logic [9:0] sum_607;
  assign sum_607 = {9'h0, difference_605_s22_q} + {1'b0, xor_606_s22_q};
  logic [9:0] sum_610;
  assign sum_610 = {9'h0, difference_608_s22_q} + {1'b0, xor_609_s22_q};
  // hls/stages/agreement.hpp:773
  logic and_1648;
  assign and_1648 = not_1472_s22_q & (so_s22_q & (ends_cell_s22_q & (shift_2_s22_q & and_1644_s22_q)));
  logic [7:0] select_1653;
  assign select_1653 = so_s22_q ? (ends_cell_s22_q ? (shift_2_s22_q ? x_s22_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:457
  logic [13:0] sum_1810;
  assign sum_1810 = {{3{patches_down_values_1_s22_q[10]}}, patches_down_values_1_s22_q} + {sum_1809_s22_q, down_2_s22_q[1]};
  logic [12:0] sum_1811;
  assign sum_1811 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1810[13:1];
  // hls/stages/patches.hpp:456
  logic [12:0] sum_1820;
  assign sum_1820 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s22_q[11:1]};
  logic [12:0] sum_1821;
  assign sum_1821 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1822;
  assign difference_1822 = {1'b0, sum_1820, smooth_s22_q[0]} - {1'b0, sum_1821, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:423
  logic next_row;
  assign next_row = select_1923_s22_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1228
  logic [6:0] select_1926;
  assign select_1926 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1238
  logic equal_1929;
  assign equal_1929 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1211
  logic not_1936;
  assign not_1936 = ~marks_first_s22_q;
  // hls/stages/agreement.hpp:1046
  logic [4:0] t;
  assign t = {difference_1958_s22_q[3], difference_1958_s22_q} + (equal_1633_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1053
  logic not_1973;
  assign not_1973 = ~region_row_s22_q[2];
  logic [2:0] select_1974;
  assign select_1974 = region_row_s22_q[1] ? {1'b0, not_1973, 1'b0} : {region_row_s22_q[2], 1'b0, not_1973};
  logic [5:0] select_1975;
  assign select_1975 = region_row_s22_q[0] ? {select_1974[2], 1'b0, select_1974[1], 1'b0, select_1974[0], 1'b0} : {1'b0, select_1974[2], 1'b0, select_1974[1], 1'b0, select_1974[0]};
  logic [11:0] select_1976;
  assign select_1976 = or_1972_s22_q ? {select_1975[5], 1'b0, select_1975[4], 1'b0, select_1975[3], 1'b0, select_1975[2], 1'b0, select_1975[1], 1'b0, select_1975[0], 1'b0} : {1'b0, select_1975[5], 1'b0, select_1975[4], 1'b0, select_1975[3], 1'b0, select_1975[2], 1'b0, select_1975[1], 1'b0, select_1975[0]};
  logic [23:0] select_1977;
  assign select_1977 = or_1969_s22_q ? {select_1976[11], 1'b0, select_1976[10], 1'b0, select_1976[9], 1'b0, select_1976[8], 1'b0, select_1976[7], 1'b0, select_1976[6], 1'b0, select_1976[5], 1'b0, select_1976[4], 1'b0, select_1976[3], 1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0], 1'b0} : {1'b0, select_1976[11], 1'b0, select_1976[10], 1'b0, select_1976[9], 1'b0, select_1976[8], 1'b0, select_1976[7], 1'b0, select_1976[6], 1'b0, select_1976[5], 1'b0, select_1976[4], 1'b0, select_1976[3], 1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0]};
  // hls/stages/agreement.hpp:1055
  logic [5:0] sum_1995;
  assign sum_1995 = {1'b0, around_s22_q} + {2'h0, around_s22_q[4:1]};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2059;
  assign xor_2059 = {difference_2058_s22_q[8:0], sum_2057_s22_q} ^ {10{difference_2058_s22_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2058_s22_q[9]} + {1'b0, xor_2059};
  logic [9:0] xor_2067;
  assign xor_2067 = {difference_2066_s22_q[8:0], sum_2065_s22_q} ^ {10{difference_2066_s22_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2066_s22_q[9]} + {1'b0, xor_2067};
  // hls/stages/agreement.hpp:508
  logic select_2082;
  assign select_2082 = and_513_s22_q ? whole_2_s22_q : census_columns_values_0_cell_0_mask_q;
  logic select_2098;
  assign select_2098 = and_513_s22_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2101;
  assign select_2101 = and_513_s22_q ? census_columns_values_0_cell_1_mask_s22_q : census_columns_values_1_cell_1_mask_q;
  logic select_2104;
  assign select_2104 = and_513_s22_q ? census_columns_values_0_cell_2_mask_s22_q : census_columns_values_1_cell_2_mask_q;
  logic select_2108;
  assign select_2108 = and_513_s22_q ? census_columns_values_0_cell_3_mask_s22_q : census_columns_values_1_cell_3_mask_q;
  logic select_2111;
  assign select_2111 = and_513_s22_q ? census_columns_values_0_cell_4_mask_s22_q : census_columns_values_1_cell_4_mask_q;
  logic select_2114;
  assign select_2114 = and_513_s22_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2117;
  assign select_2117 = and_513_s22_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_2139;
  assign sum_2139 = {9'h0, difference_2137_s22_q} + {1'b0, xor_2138_s22_q};
  logic [9:0] sum_2142;
  assign sum_2142 = {9'h0, difference_2140_s22_q} + {1'b0, xor_2141_s22_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2183_s22_q} + xor_2184_s22_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2195_s22_q} + xor_2196_s22_q;
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2417;
  assign select_2417 = and_2411_s22_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2415_s22_q});
  // hls/stages/agreement.hpp:1054
  logic [5:0] sum_2447;
  assign sum_2447 = {1'b0, e_s22_q} + {2'h0, e_s22_q[4:1]};
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2559;
  assign difference_2559 = 13'h0 - {residual_s22_q[11], residual_s22_q};
  logic less_2574;
  assign less_2574 = $signed(difference_2559) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:176
  logic [11:0] select_2856;
  assign select_2856 = equal_1694_s22_q ? patches_smooth_values_0_q : (or_1698_s22_q ? smooth_s22_q : patches_smooth_values_0_q);
  logic [11:0] select_2858;
  assign select_2858 = or_1698_s22_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2860;
  assign select_2860 = equal_1692_s22_q ? patches_smooth_values_1_q : (equal_1694_s22_q ? patches_smooth_values_1_q : select_2858);
  logic [11:0] select_2861;
  assign select_2861 = or_1698_s22_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2863;
  assign select_2863 = equal_1692_s22_q ? patches_smooth_values_2_q : (equal_1694_s22_q ? patches_smooth_values_2_q : select_2861);
  logic [11:0] select_2864;
  assign select_2864 = or_1698_s22_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2866;
  assign select_2866 = equal_1692_s22_q ? patches_smooth_values_3_q : (equal_1694_s22_q ? patches_smooth_values_3_q : select_2864);
  logic [10:0] select_2873;
  assign select_2873 = or_1698_s22_q ? patches_down_values_1_s22_q : patches_down_values_2_q;
  logic [10:0] select_2875;
  assign select_2875 = equal_1692_s22_q ? patches_down_values_2_q : (equal_1694_s22_q ? patches_down_values_2_q : select_2873);
  logic [10:0] select_2876;
  assign select_2876 = or_1698_s22_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_2878;
  assign select_2878 = equal_1692_s22_q ? patches_down_values_3_q : (equal_1694_s22_q ? patches_down_values_3_q : select_2876);
  // hls/stages/patches.hpp:546
  logic select_3330;
  assign select_3330 = less_1853_s22_q ? (not_1855_s22_q & select_3328_s22_q) : select_3328_s22_q;
  logic select_3339;
  assign select_3339 = less_1853_s22_q ? (not_1855_s22_q & select_3337_s22_q) : select_3337_s22_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3345;
  assign select_3345 = less_1853_s22_q ? (and_3343_s22_q ? patches_rows_rdata_s22_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:527
  logic [9:0] select_3356;
  assign select_3356 = patches_read_above_q ? patches_read_row_differing_s22_q : patches_peak_above_q;
  // hls/stages/patches.hpp:528
  logic [9:0] select_3358;
  assign select_3358 = patches_read_below_q ? patches_read_row_differing_s22_q : patches_peak_below_q;
  // hls/stages/patches.hpp:565
  logic less_3395;
  assign less_3395 = select_3356 < select_3358;
  // hls/stages/patches.hpp:566
  logic [9:0] high;
  assign high = less_3395 ? select_3358 : select_3356;
  logic [9:0] low;
  assign low = (select_3358 < select_3356) ? select_3358 : select_3356;
  // hls/stages/agreement.hpp:1136
  logic or_3672;
  assign or_3672 = ({counts_textured_s22_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s22_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1167
  logic too_little;
  assign too_little = less_3676_s22_q | (product_rest_q & equal_3677_s22_q);
  // hls/stages/agreement.hpp:1168
  logic select_3680;
  assign select_3680 = and_3675_s22_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1087
  logic [10:0] sum_3683;
  assign sum_3683 = {1'b0, select_2463_s22_q} + {2'h0, select_2463_s22_q[9:1]};
  // hls/stages/agreement.hpp:773
  logic select_3727;
  assign select_3727 = equal_1471_s22_q ? (equal_3473_s22_q ? sum_4_s22_q : (product_rest_q | sum_4_s22_q)) : product_rest_q;
  logic [4:0] select_3756;
  assign select_3756 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_3757;
  assign select_3757 = equal_1471_s22_q ? box_textured_sum_sums_values_0_q : select_3756;
  // hls/stages/agreement.hpp:1237
  logic [3:0] select_3842;
  assign select_3842 = select_1923_s22_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:423
  logic [7:0] select_3848;
  assign select_3848 = marks_first_s22_q ? (less_3844 ? {sum_3845, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s22_q, or_1880_s22_q, or_1877_s22_q, or_1874_s22_q};
  logic regions_we;
  assign regions_we = s22_en & and_1908_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1907_s22_q, sum_1901_s22_q, sum_1896_s22_q};
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
      counts_supervised_q <= select_2417;
      patches_smooth_values_0_q <= equal_1692_s22_q ? patches_smooth_values_0_q : select_2856;
      patches_smooth_values_1_q <= select_2860;
      patches_smooth_values_2_q <= select_2863;
      patches_smooth_values_3_q <= select_2866;
      patches_down_values_2_q <= select_2875;
      patches_down_values_3_q <= select_2878;
      patches_read_above_q <= equal_1692_s22_q ? select_3330 : patches_read_above_q;
      patches_read_below_q <= equal_1692_s22_q ? select_3339 : patches_read_below_q;
      patches_peak_above_q <= equal_1692_s22_q ? select_3356 : patches_peak_above_q;
      patches_peak_below_q <= equal_1692_s22_q ? select_3358 : patches_peak_below_q;
      product_rest_q <= select_3727;
      disagree_q <= equal_1471_s22_q ? select_3680 : disagree_q;
      began_q <= not_1936 & (began_q | select_1923_s22_q);
      seen_x_q <= select_1923_s22_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s22_q ? 4'h0 : select_3842;
      seen_column_q <= select_1923_s22_q ? 8'h0 : (seen_column_q + {7'h0, equal_1929});
      seen_rows_left_q <= select_3848;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s22_q ? 13'h0 : (seen_base_q + {6'h0, select_1926});
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
      census_columns_values_0_cell_0_mask_q <= select_2082;
      census_columns_values_1_cell_0_mask_q <= select_2098;
      census_columns_values_1_cell_1_mask_q <= select_2101;
      census_columns_values_1_cell_2_mask_q <= select_2104;
      census_columns_values_1_cell_3_mask_q <= select_2108;
      census_columns_values_1_cell_4_mask_q <= select_2111;
      census_columns_values_2_cell_0_mask_q <= select_2114;
      census_columns_values_2_cell_1_mask_q <= select_2117;
      box_textured_sum_sums_values_0_q <= select_3757;
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
  logic [3:0] select_474_s23_q;
  logic [6:0] select_477_s23_q;
  logic [6:0] column_s23_q;
  logic and_511_s23_q;
  logic and_513_s23_q;
  logic equal_516_s23_q;
  logic whole_2_s23_q;
  logic so_s23_q;
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
  logic less_568_s23_q;
  logic less_569_s23_q;
  logic less_570_s23_q;
  logic and_578_s23_q;
  logic whole_9_s23_q;
  logic [10:0] sum_611_s23_q;
  logic [9:0] sum_614_s23_q;
  logic [9:0] sum_618_s23_q;
  logic [9:0] sum_622_s23_q;
  logic equal_1471_s23_q;
  logic not_1472_s23_q;
  logic equal_1516_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1522_s23_q;
  logic equal_1524_s23_q;
  logic equal_1526_s23_q;
  logic equal_1528_s23_q;
  logic equal_1530_s23_q;
  logic equal_1532_s23_q;
  logic equal_1534_s23_q;
  logic equal_1536_s23_q;
  logic equal_1538_s23_q;
  logic less_1547_s23_q;
  logic or_1551_s23_q;
  logic [31:0] registration_sums_rdata_s23_q;
  logic equal_1571_s23_q;
  logic and_1581_s23_q;
  logic and_1584_s23_q;
  logic select_1601_s23_q;
  logic equal_1602_s23_q;
  logic [22:0] patches_choices_rdata_s23_q;
  logic and_1610_s23_q;
  logic equal_1612_s23_q;
  logic and_1648_s23_q;
  logic [7:0] select_1654_s23_q;
  logic [5:0] select_1658_s23_q;
  logic [7:0] select_1683_s23_q;
  logic and_1690_s23_q;
  logic and_1691_s23_q;
  logic equal_1692_s23_q;
  logic equal_1694_s23_q;
  logic equal_1697_s23_q;
  logic or_1698_s23_q;
  logic and_1707_s23_q;
  logic [4:0] select_1722_s23_q;
  logic select_1728_s23_q;
  logic [3:0] select_1767_s23_q;
  logic less_1783_s23_q;
  logic new_row_s23_q;
  logic or_1796_s23_q;
  logic [27:0] patches_right_codes_rdata_s23_q;
  logic [1:0] of_row_2_s23_q;
  logic down_2_s23_q;
  logic sum_1810_s23_q;
  logic [12:0] sum_1811_s23_q;
  logic [14:0] difference_1822_s23_q;
  logic and_1838_s23_q;
  logic [47:0] patches_left_codes_rdata_s23_q;
  logic and_1847_s23_q;
  logic and_1852_s23_q;
  logic less_1853_s23_q;
  logic equal_1854_s23_q;
  logic not_1855_s23_q;
  logic equal_1856_s23_q;
  logic not_1882_s23_q;
  logic not_1936_s23_q;
  logic [7:0] sum_1946_s23_q;
  logic equal_1961_s23_q;
  logic or_1966_s23_q;
  logic [23:0] select_1977_s23_q;
  logic not_1997_s23_q;
  logic less_2011_s23_q;
  logic and_2022_s23_q;
  logic [10:0] size_s23_q;
  logic [10:0] size_2_s23_q;
  logic [10:0] sum_2143_s23_q;
  logic [9:0] sum_2146_s23_q;
  logic [9:0] sum_2150_s23_q;
  logic [9:0] sum_2154_s23_q;
  logic equal_2162_s23_q;
  logic [8:0] contrast_s23_q;
  logic [8:0] contrast_2_s23_q;
  logic equal_2215_s23_q;
  logic equal_2286_s23_q;
  logic and_2411_s23_q;
  logic and_2430_s23_q;
  logic not_2434_s23_q;
  logic not_2449_s23_q;
  logic [9:0] select_2460_s23_q;
  logic [9:0] select_2463_s23_q;
  logic and_2526_s23_q;
  logic and_2527_s23_q;
  logic [7:0] residual_s23_q;
  logic less_2560_s23_q;
  logic less_2574_s23_q;
  logic equal_2618_s23_q;
  logic and_2763_s23_q;
  logic less_2890_s23_q;
  logic equal_3233_s23_q;
  logic [4:0] select_3321_s23_q;
  logic [9:0] select_3345_s23_q;
  logic [14:0] select_3352_s23_q;
  logic less_3395_s23_q;
  logic [9:0] high_s23_q;
  logic [9:0] low_s23_q;
  logic equal_3473_s23_q;
  logic equal_3669_s23_q;
  logic or_3672_s23_q;
  logic select_3680_s23_q;
  logic not_3685_s23_q;
  logic equal_3693_s23_q;
  logic equal_3695_s23_q;
  logic equal_3696_s23_q;
  logic equal_3825_s23_q;
  logic equal_3914_s23_q;
  logic [9:0] select_3924_s23_q;
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
      select_474_s23_q <= select_474_s22_q;
      select_477_s23_q <= select_477_s22_q;
      column_s23_q <= column_s22_q;
      and_511_s23_q <= and_511_s22_q;
      and_513_s23_q <= and_513_s22_q;
      equal_516_s23_q <= equal_516_s22_q;
      whole_2_s23_q <= whole_2_s22_q;
      so_s23_q <= so_s22_q;
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
      less_568_s23_q <= less_568_s22_q;
      less_569_s23_q <= less_569_s22_q;
      less_570_s23_q <= less_570_s22_q;
      and_578_s23_q <= and_578_s22_q;
      whole_9_s23_q <= whole_9;
      sum_611_s23_q <= {1'b0, sum_607} + {1'b0, sum_610};
      sum_614_s23_q <= {9'h0, difference_612_s22_q} + {1'b0, xor_613_s22_q};
      sum_618_s23_q <= {9'h0, difference_616_s22_q} + {1'b0, xor_617_s22_q};
      sum_622_s23_q <= {9'h0, difference_620_s22_q} + {1'b0, xor_621_s22_q};
      equal_1471_s23_q <= equal_1471_s22_q;
      not_1472_s23_q <= not_1472_s22_q;
      equal_1516_s23_q <= equal_1516_s22_q;
      all_s23_q <= all_s22_q;
      sum_1522_s23_q <= sum_1522_s22_q;
      equal_1524_s23_q <= equal_1524_s22_q;
      equal_1526_s23_q <= equal_1526_s22_q;
      equal_1528_s23_q <= equal_1528_s22_q;
      equal_1530_s23_q <= equal_1530_s22_q;
      equal_1532_s23_q <= equal_1532_s22_q;
      equal_1534_s23_q <= equal_1534_s22_q;
      equal_1536_s23_q <= equal_1536_s22_q;
      equal_1538_s23_q <= equal_1538_s22_q;
      less_1547_s23_q <= less_1547_s22_q;
      or_1551_s23_q <= or_1551_s22_q;
      registration_sums_rdata_s23_q <= registration_sums_rdata_q;
      equal_1571_s23_q <= equal_1571_s22_q;
      and_1581_s23_q <= and_1581_s22_q;
      and_1584_s23_q <= and_1584_s22_q;
      select_1601_s23_q <= select_1601_s22_q;
      equal_1602_s23_q <= equal_1602_s22_q;
      patches_choices_rdata_s23_q <= patches_choices_rdata_q;
      and_1610_s23_q <= and_1610_s22_q;
      equal_1612_s23_q <= equal_1612_s22_q;
      and_1648_s23_q <= and_1648;
      select_1654_s23_q <= equal_1471_s22_q ? 8'h0 : select_1653;
      select_1658_s23_q <= select_1658_s22_q;
      select_1683_s23_q <= select_1683_s22_q;
      and_1690_s23_q <= and_1690_s22_q;
      and_1691_s23_q <= and_1691_s22_q;
      equal_1692_s23_q <= equal_1692_s22_q;
      equal_1694_s23_q <= equal_1694_s22_q;
      equal_1697_s23_q <= equal_1697_s22_q;
      or_1698_s23_q <= or_1698_s22_q;
      and_1707_s23_q <= and_1707_s22_q;
      select_1722_s23_q <= select_1722_s22_q;
      select_1728_s23_q <= select_1728_s22_q;
      select_1767_s23_q <= select_1767_s22_q;
      less_1783_s23_q <= less_1783_s22_q;
      new_row_s23_q <= new_row_s22_q;
      or_1796_s23_q <= or_1796_s22_q;
      patches_right_codes_rdata_s23_q <= patches_right_codes_rdata_q;
      of_row_2_s23_q <= of_row_2_s22_q;
      down_2_s23_q <= down_2_s22_q[0];
      sum_1810_s23_q <= sum_1810[0];
      sum_1811_s23_q <= sum_1811;
      difference_1822_s23_q <= difference_1822;
      and_1838_s23_q <= and_1838_s22_q;
      patches_left_codes_rdata_s23_q <= patches_left_codes_rdata_q;
      and_1847_s23_q <= and_1847_s22_q;
      and_1852_s23_q <= and_1852_s22_q;
      less_1853_s23_q <= less_1853_s22_q;
      equal_1854_s23_q <= equal_1854_s22_q;
      not_1855_s23_q <= not_1855_s22_q;
      equal_1856_s23_q <= equal_1856_s22_q;
      not_1882_s23_q <= not_1882_s22_q;
      not_1936_s23_q <= not_1936;
      sum_1946_s23_q <= {2'h0, x_s22_q[7:2]} + 8'hff;
      equal_1961_s23_q <= t[4:1] == 4'h0;
      or_1966_s23_q <= or_1966_s22_q;
      select_1977_s23_q <= select_1977;
      not_1997_s23_q <= ~({sum_1995, around_s22_q[0]} < {2'h0, t});
      less_2011_s23_q <= less_2011_s22_q;
      and_2022_s23_q <= and_2022_s22_q;
      size_s23_q <= size;
      size_2_s23_q <= size_2;
      sum_2143_s23_q <= {1'b0, sum_2139} + {1'b0, sum_2142};
      sum_2146_s23_q <= {9'h0, difference_2144_s22_q} + {1'b0, xor_2145_s22_q};
      sum_2150_s23_q <= {9'h0, difference_2148_s22_q} + {1'b0, xor_2149_s22_q};
      sum_2154_s23_q <= {9'h0, difference_2152_s22_q} + {1'b0, xor_2153_s22_q};
      equal_2162_s23_q <= equal_2162_s22_q;
      contrast_s23_q <= contrast;
      contrast_2_s23_q <= contrast_2;
      equal_2215_s23_q <= x_s22_q[7:3] == 5'h0;
      equal_2286_s23_q <= equal_2286_s22_q;
      and_2411_s23_q <= and_2411_s22_q;
      and_2430_s23_q <= and_2430_s22_q;
      not_2434_s23_q <= not_2434_s22_q;
      not_2449_s23_q <= ~({sum_2447, e_s22_q[0]} < {2'h0, t});
      select_2460_s23_q <= select_2460_s22_q;
      select_2463_s23_q <= select_2463_s22_q;
      and_2526_s23_q <= and_2526_s22_q;
      and_2527_s23_q <= and_2527_s22_q;
      residual_s23_q <= residual_s22_q[7:0];
      less_2560_s23_q <= $signed(difference_2559) < $signed({7'h0, cfg_moved_limit_i});
      less_2574_s23_q <= less_2574;
      equal_2618_s23_q <= equal_2618_s22_q;
      and_2763_s23_q <= and_2763_s22_q;
      less_2890_s23_q <= less_2890_s22_q;
      equal_3233_s23_q <= equal_3233_s22_q;
      select_3321_s23_q <= select_3321_s22_q;
      select_3345_s23_q <= select_3345;
      select_3352_s23_q <= select_3352_s22_q;
      less_3395_s23_q <= less_3395;
      high_s23_q <= high;
      low_s23_q <= low;
      equal_3473_s23_q <= equal_3473_s22_q;
      equal_3669_s23_q <= select_2460_s22_q[9:3] == 7'h0;
      or_3672_s23_q <= or_3672;
      select_3680_s23_q <= select_3680;
      not_3685_s23_q <= ~({sum_3683, select_2463_s22_q[0]} < {2'h0, select_2460_s22_q});
      equal_3693_s23_q <= equal_3693_s22_q;
      equal_3695_s23_q <= equal_3695_s22_q;
      equal_3696_s23_q <= equal_3696_s22_q;
      equal_3825_s23_q <= equal_3825_s22_q;
      equal_3914_s23_q <= equal_3914_s22_q;
      select_3924_s23_q <= select_3924_s22_q;
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
  // hls/stages/agreement.hpp:444
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
  logic [10:0] sum_615;
  assign sum_615 = sum_611_s23_q + {1'b0, sum_614_s23_q};
  // hls/stages/patches.hpp:148
  logic and_1650;
  assign and_1650 = and_1648_s23_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:333
  logic [22:0] select_1684;
  assign select_1684 = and_1650 ? {select_1683_s23_q, select_1658_s23_q, select_1654_s23_q, and_1648_s23_q} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:457
  logic [14:0] sum_1812;
  assign sum_1812 = {{4{patches_down_values_3_s23_q[10]}}, patches_down_values_3_s23_q} + {sum_1811_s23_q, sum_1810_s23_q, down_2_s23_q};
  // hls/stages/agreement.hpp:1245
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1212
  logic select_1934;
  assign select_1934 = marks_first_s23_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1198
  logic [10:0] sum_1935;
  assign sum_1935 = {1'b0, {5{select_1934}}, 1'b0, {2{select_1934}}, 1'b0, select_1934} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1063
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1946_s23_q[7]}}, sum_1946_s23_q, x_s23_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1198
  logic [10:0] sum_1948;
  assign sum_1948 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1053
  logic [47:0] select_1978;
  assign select_1978 = or_1966_s23_q ? {select_1977_s23_q[23], 1'b0, select_1977_s23_q[22], 1'b0, select_1977_s23_q[21], 1'b0, select_1977_s23_q[20], 1'b0, select_1977_s23_q[19], 1'b0, select_1977_s23_q[18], 1'b0, select_1977_s23_q[17], 1'b0, select_1977_s23_q[16], 1'b0, select_1977_s23_q[15], 1'b0, select_1977_s23_q[14], 1'b0, select_1977_s23_q[13], 1'b0, select_1977_s23_q[12], 1'b0, select_1977_s23_q[11], 1'b0, select_1977_s23_q[10], 1'b0, select_1977_s23_q[9], 1'b0, select_1977_s23_q[8], 1'b0, select_1977_s23_q[7], 1'b0, select_1977_s23_q[6], 1'b0, select_1977_s23_q[5], 1'b0, select_1977_s23_q[4], 1'b0, select_1977_s23_q[3], 1'b0, select_1977_s23_q[2], 1'b0, select_1977_s23_q[1], 1'b0, select_1977_s23_q[0], 1'b0} : {1'b0, select_1977_s23_q[23], 1'b0, select_1977_s23_q[22], 1'b0, select_1977_s23_q[21], 1'b0, select_1977_s23_q[20], 1'b0, select_1977_s23_q[19], 1'b0, select_1977_s23_q[18], 1'b0, select_1977_s23_q[17], 1'b0, select_1977_s23_q[16], 1'b0, select_1977_s23_q[15], 1'b0, select_1977_s23_q[14], 1'b0, select_1977_s23_q[13], 1'b0, select_1977_s23_q[12], 1'b0, select_1977_s23_q[11], 1'b0, select_1977_s23_q[10], 1'b0, select_1977_s23_q[9], 1'b0, select_1977_s23_q[8], 1'b0, select_1977_s23_q[7], 1'b0, select_1977_s23_q[6], 1'b0, select_1977_s23_q[5], 1'b0, select_1977_s23_q[4], 1'b0, select_1977_s23_q[3], 1'b0, select_1977_s23_q[2], 1'b0, select_1977_s23_q[1], 1'b0, select_1977_s23_q[0]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s23_q} + (equal_516_s23_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:264
  logic [13:0] select_2064;
  assign select_2064 = sample_pair_whole_s23_q ? (and_511_s23_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s23_q} + (equal_516_s23_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:264
  logic [13:0] select_2072;
  assign select_2072 = sample_pair_whole_s23_q ? (and_511_s23_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:508
  logic select_2120;
  assign select_2120 = and_513_s23_q ? census_columns_values_1_cell_2_mask_s23_q : census_columns_values_2_cell_2_mask_q;
  logic select_2123;
  assign select_2123 = and_513_s23_q ? census_columns_values_1_cell_3_mask_s23_q : census_columns_values_2_cell_3_mask_q;
  logic select_2126;
  assign select_2126 = and_513_s23_q ? census_columns_values_1_cell_4_mask_s23_q : census_columns_values_2_cell_4_mask_q;
  logic select_2127;
  assign select_2127 = and_513_s23_q ? census_columns_values_2_cell_0_mask_s23_q : census_columns_values_3_cell_0_mask_q;
  logic select_2130;
  assign select_2130 = and_513_s23_q ? census_columns_values_2_cell_1_mask_s23_q : census_columns_values_3_cell_1_mask_q;
  logic select_2131;
  assign select_2131 = and_513_s23_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2134;
  assign select_2134 = and_513_s23_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_2147;
  assign sum_2147 = sum_2143_s23_q + {1'b0, sum_2146_s23_q};
  // hls/stages/agreement.hpp:508
  logic select_2179;
  assign select_2179 = and_513_s23_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2182;
  assign and_2182 = whole_2_s23_q & (~(column_s23_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:445
  logic and_2188;
  assign and_2188 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s23_q[8:2]));
  logic and_2189;
  assign and_2189 = and_2182 & and_2188;
  logic and_2200;
  assign and_2200 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s23_q[8:2]));
  logic and_2201;
  assign and_2201 = and_2182 & and_2200;
  // hls/stages/census.hpp:409
  logic not_2218;
  assign not_2218 = ~x_s23_q[1];
  logic [2:0] select_2219;
  assign select_2219 = x_s23_q[0] ? {1'b0, not_2218, 1'b0} : {x_s23_q[1], 1'b0, not_2218};
  logic [5:0] select_2220;
  assign select_2220 = slot_s23_q[2] ? {select_2219[2], 1'b0, select_2219[1], 1'b0, select_2219[0], 1'b0} : {1'b0, select_2219[2], 1'b0, select_2219[1], 1'b0, select_2219[0]};
  logic [11:0] select_2221;
  assign select_2221 = slot_s23_q[1] ? {select_2220[5], 1'b0, select_2220[4], 1'b0, select_2220[3], 1'b0, select_2220[2], 1'b0, select_2220[1], 1'b0, select_2220[0], 1'b0} : {1'b0, select_2220[5], 1'b0, select_2220[4], 1'b0, select_2220[3], 1'b0, select_2220[2], 1'b0, select_2220[1], 1'b0, select_2220[0]};
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2432;
  assign select_2432 = and_2411_s23_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2430_s23_q});
  // hls/stages/agreement.hpp:1085
  logic [10:0] sum_2464;
  assign sum_2464 = {1'b0, select_2463_s23_q} + {3'h0, select_2463_s23_q[9:2]};
  // hls/stages/registration.hpp:107
  logic [7:0] select_2542;
  assign select_2542 = equal_1612_s23_q ? (and_2527_s23_q ? residual_s23_q : 8'h0) : 8'h0;
  logic and_2553;
  assign and_2553 = and_2527_s23_q & ($signed(residual_s23_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2567;
  assign less_2567 = $signed(residual_s23_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1082
  logic [11:0] select_2620;
  assign select_2620 = or_1551_s23_q ? 12'h0 : (equal_2618_s23_q ? registration_sums_rdata_s23_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1094
  logic [11:0] select_2622;
  assign select_2622 = equal_1516_s23_q ? 12'h0 : (less_1547_s23_q ? select_2620 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2625;
  assign and_2625 = x_s23_q[1] & all_s23_q;
  // hls/stages/agreement.hpp:1094
  logic and_2628;
  assign and_2628 = not_1882_s23_q & (less_1547_s23_q & ({and_2625, x_s23_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1082
  logic [11:0] select_2635;
  assign select_2635 = or_1551_s23_q ? 12'h0 : (equal_2618_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1094
  logic [11:0] select_2637;
  assign select_2637 = equal_1516_s23_q ? 12'h0 : (less_1547_s23_q ? select_2635 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2643;
  assign not_2643 = ~all_s23_q;
  // hls/stages/agreement.hpp:1094
  logic and_2646;
  assign and_2646 = not_1882_s23_q & (less_1547_s23_q & (x_s23_q[2:0] == {all_s23_q, not_2643, 1'b0}));
  // hls/stages/agreement.hpp:773
  logic and_2652;
  assign and_2652 = equal_1471_s23_q & (x_s23_q[6] & (not_1882_s23_q & (less_1547_s23_q & all_s23_q)));
  // hls/stages/registration.hpp:157
  logic equal_2679;
  assign equal_2679 = x_s23_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1094
  logic and_2682;
  assign and_2682 = not_1882_s23_q & (less_1547_s23_q & (x_s23_q[5] ? x_s23_q[3] : equal_2679));
  logic and_2691;
  assign and_2691 = not_1882_s23_q & (less_1547_s23_q & ((~x_s23_q[5]) & (x_s23_q[3] & equal_2679)));
  // hls/stages/patches.hpp:335
  logic not_2753;
  assign not_2753 = ~and_1690_s23_q;
  // hls/stages/patches.hpp:491
  logic [27:0] word;
  assign word = or_1796_s23_q ? patches_right_codes_rdata_s23_q : 28'h0;
  // hls/stages/patches.hpp:508
  logic [47:0] select_2923;
  assign select_2923 = new_row_s23_q ? patches_left_codes_rdata_s23_q : patches_left_row_q;
  // hls/stages/patches.hpp:176
  logic [47:0] select_2925;
  assign select_2925 = equal_1692_s23_q ? patches_left_row_q : (equal_1694_s23_q ? select_2923 : patches_left_row_q);
  logic [4:0] select_3270;
  assign select_3270 = equal_1694_s23_q ? patches_along_s23_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3347;
  assign select_3347 = less_1853_s23_q ? (equal_1856_s23_q ? 10'h3ff : select_3345_s23_q) : 10'h3ff;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3348;
  assign select_3348 = equal_1856_s23_q ? select_3347 : select_3345_s23_q;
  logic [9:0] select_3350;
  assign select_3350 = less_1853_s23_q ? (equal_1854_s23_q ? 10'h3ff : select_3348) : select_3348;
  // hls/stages/patches.hpp:567
  logic [9:0] eight;
  assign eight = high_s23_q - low_s23_q;
  logic [9:0] fall;
  assign fall = high_s23_q - select_3352_s23_q[9:0];
  // hls/stages/agreement.hpp:1096
  logic equal_3580;
  assign equal_3580 = x_s23_q == 7'h7f;
  // hls/stages/agreement.hpp:1087
  logic select_3686;
  assign select_3686 = equal_3669_s23_q ? ((~or_3672_s23_q) & (~select_3680_s23_q)) : not_3685_s23_q;
  // hls/stages/agreement.hpp:1094
  logic [47:0] select_3688;
  assign select_3688 = x_s23_q[6] ? (equal_1516_s23_q ? good_q : {select_3686, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:448
  logic [12:0] select_3828;
  assign select_3828 = equal_2286_s23_q ? (equal_3825_s23_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:508
  logic [6:0] select_3831;
  assign select_3831 = and_513_s23_q ? (equal_2286_s23_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1092
  logic [31:0] select_3916;
  assign select_3916 = equal_1538_s23_q ? {2'h0, counts_explained_s23_q, 2'h0, counts_textured_s23_q} : (equal_3914_s23_q ? registration_sums_rdata_s23_q : 32'h0);
  logic [31:0] select_3917;
  assign select_3917 = equal_1536_s23_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s23_q} : select_3916;

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s23_q, and_1610_s23_q};
  logic patches_choices_we;
  assign patches_choices_we = s23_en & and_1691_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= select_1684;
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
      sharpness_before_last_mask_q <= select_2179;
      counts_nearer_q <= select_2432;
      patches_fixed_q <= not_2753 & (patches_fixed_q | (and_2763_s23_q & and_1650));
      patches_choice_valid_q <= and_1690_s23_q ? (select_1684[0] & not_2753) : select_1684[0];
      patches_choice_column_q <= select_1684[8:1];
      patches_choice_shift_q <= select_1684[14:9];
      patches_choice_slope_q <= select_1684[22:15];
      patches_left_row_q <= select_2925;
      patches_summed_row_column_q <= equal_1692_s23_q ? patches_summed_row_column_q : select_3270;
      patches_read_far_q <= equal_1692_s23_q ? select_3350 : patches_read_far_q;
      good_q <= equal_1471_s23_q ? select_3688 : good_q;
      map_row_q <= and_513_s23_q ? select_3828 : map_row_q;
      map_width_q <= select_3831;
      write_half_q <= marks_first_s23_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1934;
      done_q <= not_1936_s23_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s23_q;
      said_q <= equal_1471_s23_q & equal_3580;
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
      averager_detail_0_q <= select_2064;
      averager_detail_1_q <= select_2072;
      census_columns_values_2_cell_2_mask_q <= select_2120;
      census_columns_values_2_cell_3_mask_q <= select_2123;
      census_columns_values_2_cell_4_mask_q <= select_2126;
      census_columns_values_3_cell_0_mask_q <= select_2127;
      census_columns_values_3_cell_1_mask_q <= select_2130;
      census_columns_values_3_cell_2_mask_q <= select_2131;
      census_columns_values_3_cell_3_mask_q <= select_2134;
      sharpness_last_mask_q <= and_513_s23_q ? whole_2_s23_q : sharpness_last_mask_q;
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
  logic [3:0] select_474_s24_q;
  logic [6:0] select_477_s24_q;
  logic [6:0] column_s24_q;
  logic and_513_s24_q;
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
  logic less_568_s24_q;
  logic less_569_s24_q;
  logic less_570_s24_q;
  logic and_578_s24_q;
  logic whole_16_s24_q;
  logic and_604_s24_q;
  logic [11:0] sum_619_s24_q;
  logic [9:0] sum_622_s24_q;
  logic equal_1471_s24_q;
  logic not_1472_s24_q;
  logic equal_1516_s24_q;
  logic [1:0] sum_1522_s24_q;
  logic equal_1524_s24_q;
  logic equal_1526_s24_q;
  logic equal_1528_s24_q;
  logic equal_1530_s24_q;
  logic equal_1532_s24_q;
  logic equal_1534_s24_q;
  logic less_1547_s24_q;
  logic [19:0] select_1572_s24_q;
  logic [11:0] select_1577_s24_q;
  logic and_1581_s24_q;
  logic and_1584_s24_q;
  logic select_1601_s24_q;
  logic equal_1602_s24_q;
  logic equal_1612_s24_q;
  logic equal_1692_s24_q;
  logic equal_1694_s24_q;
  logic equal_1697_s24_q;
  logic or_1698_s24_q;
  logic [22:0] select_1708_s24_q;
  logic [4:0] select_1722_s24_q;
  logic select_1728_s24_q;
  logic [3:0] select_1767_s24_q;
  logic less_1783_s24_q;
  logic new_row_s24_q;
  logic [1:0] of_row_2_s24_q;
  logic less_1813_s24_q;
  logic less_1814_s24_q;
  logic less_1823_s24_q;
  logic less_1824_s24_q;
  logic and_1838_s24_q;
  logic and_1847_s24_q;
  logic and_1852_s24_q;
  logic less_1853_s24_q;
  logic equal_1854_s24_q;
  logic not_1855_s24_q;
  logic equal_1856_s24_q;
  logic not_1882_s24_q;
  logic [2:0] index_s24_q;
  logic [10:0] sum_1935_s24_q;
  logic and_1942_s24_q;
  logic less_1943_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1948_s24_q;
  logic equal_1961_s24_q;
  logic not_1981_s24_q;
  logic not_1997_s24_q;
  logic less_2011_s24_q;
  logic and_2022_s24_q;
  logic [11:0] sum_2151_s24_q;
  logic [9:0] sum_2154_s24_q;
  logic equal_2162_s24_q;
  logic [27:0] select_2176_s24_q;
  logic and_2189_s24_q;
  logic and_2201_s24_q;
  logic [8:0] select_2208_s24_q;
  logic [8:0] select_2212_s24_q;
  logic equal_2215_s24_q;
  logic less_2216_s24_q;
  logic [11:0] select_2221_s24_q;
  logic equal_2259_s24_q;
  logic and_2411_s24_q;
  logic not_2434_s24_q;
  logic not_2449_s24_q;
  logic [9:0] select_2460_s24_q;
  logic [9:0] select_2463_s24_q;
  logic less_2465_s24_q;
  logic and_2526_s24_q;
  logic and_2527_s24_q;
  logic [7:0] select_2544_s24_q;
  logic and_2553_s24_q;
  logic and_2561_s24_q;
  logic and_2568_s24_q;
  logic and_2575_s24_q;
  logic [11:0] select_2622_s24_q;
  logic and_2630_s24_q;
  logic [11:0] select_2637_s24_q;
  logic and_2648_s24_q;
  logic and_2652_s24_q;
  logic and_2684_s24_q;
  logic and_2692_s24_q;
  logic [27:0] word_s24_q;
  logic equal_2884_s24_q;
  logic less_2890_s24_q;
  logic [47:0] select_2923_s24_q;
  logic equal_3233_s24_q;
  logic [4:0] select_3321_s24_q;
  logic [14:0] select_3352_s24_q;
  logic less_3395_s24_q;
  logic [9:0] eight_s24_q;
  logic [9:0] fall_s24_q;
  logic equal_3473_s24_q;
  logic equal_3580_s24_q;
  logic or_3672_s24_q;
  logic select_3680_s24_q;
  logic equal_3693_s24_q;
  logic equal_3695_s24_q;
  logic equal_3696_s24_q;
  logic [31:0] select_3917_s24_q;
  logic [9:0] select_3924_s24_q;
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
      select_474_s24_q <= select_474_s23_q;
      select_477_s24_q <= select_477_s23_q;
      column_s24_q <= column_s23_q;
      and_513_s24_q <= and_513_s23_q;
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
      less_568_s24_q <= less_568_s23_q;
      less_569_s24_q <= less_569_s23_q;
      less_570_s24_q <= less_570_s23_q;
      and_578_s24_q <= and_578_s23_q;
      whole_16_s24_q <= whole_16;
      and_604_s24_q <= census_columns_values_1_cell_2_mask_s23_q & and_578_s23_q;
      sum_619_s24_q <= {1'b0, sum_615} + {2'h0, sum_618_s23_q};
      sum_622_s24_q <= sum_622_s23_q;
      equal_1471_s24_q <= equal_1471_s23_q;
      not_1472_s24_q <= not_1472_s23_q;
      equal_1516_s24_q <= equal_1516_s23_q;
      sum_1522_s24_q <= sum_1522_s23_q;
      equal_1524_s24_q <= equal_1524_s23_q;
      equal_1526_s24_q <= equal_1526_s23_q;
      equal_1528_s24_q <= equal_1528_s23_q;
      equal_1530_s24_q <= equal_1530_s23_q;
      equal_1532_s24_q <= equal_1532_s23_q;
      equal_1534_s24_q <= equal_1534_s23_q;
      less_1547_s24_q <= less_1547_s23_q;
      select_1572_s24_q <= equal_1571_s23_q ? registration_sums_rdata_s23_q[19:0] : 20'h0;
      select_1577_s24_q <= equal_1571_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0;
      and_1581_s24_q <= and_1581_s23_q;
      and_1584_s24_q <= and_1584_s23_q;
      select_1601_s24_q <= select_1601_s23_q;
      equal_1602_s24_q <= equal_1602_s23_q;
      equal_1612_s24_q <= equal_1612_s23_q;
      equal_1692_s24_q <= equal_1692_s23_q;
      equal_1694_s24_q <= equal_1694_s23_q;
      equal_1697_s24_q <= equal_1697_s23_q;
      or_1698_s24_q <= or_1698_s23_q;
      select_1708_s24_q <= and_1707_s23_q ? select_1684 : patches_choices_rdata_s23_q;
      select_1722_s24_q <= select_1722_s23_q;
      select_1728_s24_q <= select_1728_s23_q;
      select_1767_s24_q <= select_1767_s23_q;
      less_1783_s24_q <= less_1783_s23_q;
      new_row_s24_q <= new_row_s23_q;
      of_row_2_s24_q <= of_row_2_s23_q;
      less_1813_s24_q <= $signed(15'h100) < $signed(sum_1812);
      less_1814_s24_q <= $signed(sum_1812[14:8]) < $signed(7'h7f);
      less_1823_s24_q <= $signed(15'h100) < $signed(difference_1822_s23_q);
      less_1824_s24_q <= $signed(difference_1822_s23_q[14:8]) < $signed(7'h7f);
      and_1838_s24_q <= and_1838_s23_q;
      and_1847_s24_q <= and_1847_s23_q;
      and_1852_s24_q <= and_1852_s23_q;
      less_1853_s24_q <= less_1853_s23_q;
      equal_1854_s24_q <= equal_1854_s23_q;
      not_1855_s24_q <= not_1855_s23_q;
      equal_1856_s24_q <= equal_1856_s23_q;
      not_1882_s24_q <= not_1882_s23_q;
      index_s24_q <= index[2:0];
      sum_1935_s24_q <= sum_1935;
      and_1942_s24_q <= began_q & (seen_x_q == 4'h0);
      less_1943_s24_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s24_q <= index_2[2:0];
      sum_1948_s24_q <= sum_1948;
      equal_1961_s24_q <= equal_1961_s23_q;
      not_1981_s24_q <= ~((good_q & select_1978) == 48'h0);
      not_1997_s24_q <= not_1997_s23_q;
      less_2011_s24_q <= less_2011_s23_q;
      and_2022_s24_q <= and_2022_s23_q;
      sum_2151_s24_q <= {1'b0, sum_2147} + {2'h0, sum_2150_s23_q};
      sum_2154_s24_q <= sum_2154_s23_q;
      equal_2162_s24_q <= equal_2162_s23_q;
      select_2176_s24_q <= sample_pair_whole_s23_q ? {detail_2, detail} : 28'h0;
      and_2189_s24_q <= and_2189;
      and_2201_s24_q <= and_2201;
      select_2208_s24_q <= and_2189 ? contrast_s23_q : 9'h0;
      select_2212_s24_q <= and_2201 ? contrast_2_s23_q : 9'h0;
      equal_2215_s24_q <= equal_2215_s23_q;
      less_2216_s24_q <= 7'h2 < {x_s23_q[4:0], slot_s23_q[2:1]};
      select_2221_s24_q <= select_2221;
      equal_2259_s24_q <= {x_s23_q[4:0], slot_s23_q} == 8'h0;
      and_2411_s24_q <= and_2411_s23_q;
      not_2434_s24_q <= not_2434_s23_q;
      not_2449_s24_q <= not_2449_s23_q;
      select_2460_s24_q <= select_2460_s23_q;
      select_2463_s24_q <= select_2463_s23_q;
      less_2465_s24_q <= {sum_2464, select_2463_s23_q[1:0]} < {3'h0, select_2460_s23_q};
      and_2526_s24_q <= and_2526_s23_q;
      and_2527_s24_q <= and_2527_s23_q;
      select_2544_s24_q <= equal_1471_s23_q ? 8'h0 : (so_s23_q ? select_2542 : 8'h0);
      and_2553_s24_q <= and_2553;
      and_2561_s24_q <= and_2527_s23_q & less_2560_s23_q;
      and_2568_s24_q <= and_2527_s23_q & less_2567;
      and_2575_s24_q <= and_2527_s23_q & less_2574_s23_q;
      select_2622_s24_q <= select_2622;
      and_2630_s24_q <= equal_1471_s23_q & (x_s23_q[6] & and_2628);
      select_2637_s24_q <= select_2637;
      and_2648_s24_q <= equal_1471_s23_q & (x_s23_q[6] & and_2646);
      and_2652_s24_q <= and_2652;
      and_2684_s24_q <= equal_1471_s23_q & (x_s23_q[6] & and_2682);
      and_2692_s24_q <= x_s23_q[6] & and_2691;
      word_s24_q <= word;
      equal_2884_s24_q <= patches_along_s23_q == 5'h7;
      less_2890_s24_q <= less_2890_s23_q;
      select_2923_s24_q <= select_2923;
      equal_3233_s24_q <= equal_3233_s23_q;
      select_3321_s24_q <= select_3321_s23_q;
      select_3352_s24_q <= select_3352_s23_q;
      less_3395_s24_q <= less_3395_s23_q;
      eight_s24_q <= eight;
      fall_s24_q <= fall;
      equal_3473_s24_q <= equal_3473_s23_q;
      equal_3580_s24_q <= equal_3580;
      or_3672_s24_q <= or_3672_s23_q;
      select_3680_s24_q <= select_3680_s23_q;
      equal_3693_s24_q <= equal_3693_s23_q;
      equal_3695_s24_q <= equal_3695_s23_q;
      equal_3696_s24_q <= equal_3696_s23_q;
      select_3917_s24_q <= select_3917;
      select_3924_s24_q <= select_3924_s23_q;
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
  // hls/stages/agreement.hpp:444
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
  assign texture = sum_619_s24_q + {2'h0, sum_622_s24_q};
  // hls/stages/registration.hpp:265
  logic equal_1573;
  assign equal_1573 = sum_1522_s24_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1522_s24_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1575;
  assign select_1575 = equal_1573 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1522_s24_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1579;
  assign select_1579 = equal_1573 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/patches.hpp:344
  logic [21:0] select_1711;
  assign select_1711 = select_1601_s24_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1708_s24_q[22:1];
  // hls/stages/patches.hpp:119
  logic [7:0] select_1712;
  assign select_1712 = equal_1602_s24_q ? patches_place_0_column_q : select_1711[7:0];
  logic [5:0] select_1713;
  assign select_1713 = equal_1602_s24_q ? patches_place_0_shift_q : select_1711[13:8];
  // hls/stages/patches.hpp:344
  logic [21:0] select_1740;
  assign select_1740 = select_1601_s24_q ? select_1708_s24_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:119
  logic [7:0] select_1741;
  assign select_1741 = equal_1602_s24_q ? patches_place_1_column_q : select_1740[7:0];
  logic [5:0] select_1742;
  assign select_1742 = equal_1602_s24_q ? patches_place_1_shift_q : select_1740[13:8];
  // hls/stages/patches.hpp:124
  logic equal_1758;
  assign equal_1758 = {select_1712[7], select_477_s24_q, select_474_s24_q} == {1'b0, select_1712[6:0], 4'h0};
  logic equal_1762;
  assign equal_1762 = {select_1741[7], select_477_s24_q, select_474_s24_q} == {1'b0, select_1741[6:0], 4'h0};
  // hls/stages/patches.hpp:472
  logic [2:0] sum_1804;
  assign sum_1804 = patches_code_row_s24_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:476
  logic [1:0] sum_1842;
  assign sum_1842 = patches_code_row_s24_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:986
  logic and_1982;
  assign and_1982 = good_known_q & not_1981_s24_q;
  // hls/stages/agreement.hpp:1055
  logic is_seen;
  assign is_seen = equal_1961_s24_q ? and_1982 : not_1997_s24_q;
  // hls/stages/agreement.hpp:508
  logic select_2135;
  assign select_2135 = and_513_s24_q ? census_columns_values_2_cell_4_mask_s24_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2155;
  assign sum_2155 = sum_2151_s24_q + {2'h0, sum_2154_s24_q};
  // hls/stages/agreement.hpp:508
  logic [11:0] select_2157;
  assign select_2157 = and_513_s24_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2158;
  assign select_2158 = and_513_s24_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2177;
  assign select_2177 = and_513_s24_q ? select_2176_s24_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2178;
  assign select_2178 = and_513_s24_q ? select_2176_s24_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2176_s24_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2176_s24_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_2209;
  assign sum_2209 = (equal_2162_s24_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2208_s24_q};
  logic [23:0] sum_2213;
  assign sum_2213 = (equal_2162_s24_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2212_s24_q};
  // hls/stages/census.hpp:409
  logic less_2217;
  assign less_2217 = x_s24_q[4:0] < 5'h3;
  logic [23:0] select_2222;
  assign select_2222 = slot_s24_q ? {select_2221_s24_q[11], 1'b0, select_2221_s24_q[10], 1'b0, select_2221_s24_q[9], 1'b0, select_2221_s24_q[8], 1'b0, select_2221_s24_q[7], 1'b0, select_2221_s24_q[6], 1'b0, select_2221_s24_q[5], 1'b0, select_2221_s24_q[4], 1'b0, select_2221_s24_q[3], 1'b0, select_2221_s24_q[2], 1'b0, select_2221_s24_q[1], 1'b0, select_2221_s24_q[0], 1'b0} : {1'b0, select_2221_s24_q[11], 1'b0, select_2221_s24_q[10], 1'b0, select_2221_s24_q[9], 1'b0, select_2221_s24_q[8], 1'b0, select_2221_s24_q[7], 1'b0, select_2221_s24_q[6], 1'b0, select_2221_s24_q[5], 1'b0, select_2221_s24_q[4], 1'b0, select_2221_s24_q[3], 1'b0, select_2221_s24_q[2], 1'b0, select_2221_s24_q[1], 1'b0, select_2221_s24_q[0]};
  // hls/stages/census.hpp:372
  logic and_2226;
  assign and_2226 = less_2217 & (~((sharpness_sums_contrast_1_q & select_2222) == 24'h0));
  logic and_2236;
  assign and_2236 = less_2217 & (~((sharpness_sums_contrast_0_q & select_2222) == 24'h0));
  // hls/stages/agreement.hpp:1058
  logic not_2451;
  assign not_2451 = ~(equal_1961_s24_q ? and_1982 : not_2449_s24_q);
  // hls/stages/agreement.hpp:773
  logic and_2454;
  assign and_2454 = ends_cell_s24_q & (not_2434_s24_q & (centres_values_1_textured_s24_q & not_2451));
  // hls/stages/agreement.hpp:1090
  logic [9:0] select_2467;
  assign select_2467 = ((~(select_2460_s24_q[9:4] == 6'h0)) & less_2465_s24_q) ? select_2460_s24_q : 10'h0;
  // hls/stages/agreement.hpp:773
  logic [9:0] select_2470;
  assign select_2470 = equal_1471_s24_q ? (x_s24_q[6] ? (equal_1516_s24_q ? 10'h0 : select_2467) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1062
  logic and_2488;
  assign and_2488 = centres_values_1_textured_s24_q & (centres_values_1_of_skin_s24_q & not_2451);
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2545;
  assign sum_2545 = registration_half_across_q + {{6{select_2544_s24_q[7]}}, select_2544_s24_q};
  // hls/stages/agreement.hpp:773
  logic and_2549;
  assign and_2549 = not_1472_s24_q & (drew_q & (and_2527_s24_q & equal_1612_s24_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2551;
  assign select_2551 = and_2526_s24_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2549});
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2555;
  assign select_2555 = drew_q ? (equal_1612_s24_q ? {and_2553_s24_q, and_2527_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2556;
  assign select_2556 = equal_1471_s24_q ? 2'h0 : select_2555;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2557;
  assign sum_2557 = registration_half_votes_down_q + {{5{select_2556[1]}}, select_2556};
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2563;
  assign select_2563 = drew_q ? (equal_1612_s24_q ? {and_2561_s24_q, and_2527_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2564;
  assign select_2564 = equal_1471_s24_q ? 2'h0 : select_2563;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2565;
  assign sum_2565 = registration_half_votes_up_q + {{5{select_2564[1]}}, select_2564};
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2570;
  assign select_2570 = drew_q ? (equal_1612_s24_q ? {and_2568_s24_q, and_2527_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2571;
  assign select_2571 = equal_1471_s24_q ? 2'h0 : select_2570;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2572;
  assign sum_2572 = registration_half_half_votes_down_q + {{5{select_2571[1]}}, select_2571};
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2577;
  assign select_2577 = drew_q ? (equal_1612_s24_q ? {and_2575_s24_q, and_2527_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2578;
  assign select_2578 = equal_1471_s24_q ? 2'h0 : select_2577;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2579;
  assign sum_2579 = registration_half_half_votes_up_q + {{5{select_2578[1]}}, select_2578};
  // hls/stages/agreement.hpp:773
  logic and_2613;
  assign and_2613 = equal_1471_s24_q & (x_s24_q[6] & (not_1882_s24_q & less_1547_s24_q));
  logic [11:0] select_2624;
  assign select_2624 = equal_1471_s24_q ? (x_s24_q[6] ? select_2622_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2632;
  assign sum_2632 = {{2{select_2624[11]}}, select_2624} + (and_2630_s24_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:773
  logic [11:0] select_2639;
  assign select_2639 = equal_1471_s24_q ? (x_s24_q[6] ? select_2637_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2641;
  assign sum_2641 = {{2{select_2639[11]}}, select_2639} + (and_2630_s24_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2653;
  assign not_2653 = ~and_2652_s24_q;
  logic less_2654;
  assign less_2654 = $signed({9'h1, {2{not_2653}}, and_2652_s24_q}) < $signed(registration_up_q[13:2]);
  logic select_2655;
  assign select_2655 = and_2648_s24_q ? less_2654 : registration_enough_q;
  // hls/stages/agreement.hpp:1094
  logic and_2659;
  assign and_2659 = x_s24_q[6] & (not_1882_s24_q & (less_1547_s24_q & (x_s24_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:773
  logic and_2660;
  assign and_2660 = equal_1471_s24_q & and_2659;
  // hls/stages/registration.hpp:242
  logic less_2661;
  assign less_2661 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2663;
  assign less_2663 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2665;
  assign equal_2665 = x_s24_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:773
  logic and_2669;
  assign and_2669 = equal_1471_s24_q & (x_s24_q[6] & (not_1882_s24_q & (less_1547_s24_q & equal_2665)));
  // hls/stages/agreement.hpp:1094
  logic and_2676;
  assign and_2676 = x_s24_q[6] & (not_1882_s24_q & (less_1547_s24_q & (x_s24_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2694;
  assign and_2694 = registration_votes_up_q & registration_other_down_q;
  logic select_2696;
  assign select_2696 = registration_votes_down_q ? (registration_other_up_q | and_2694) : and_2694;
  // hls/stages/registration.hpp:138
  logic and_2698;
  assign and_2698 = (equal_1471_s24_q & and_2692_s24_q) & (registration_other_enough_q & select_2696);
  logic and_2700;
  assign and_2700 = registration_enough_q & ((and_2684_s24_q & (less_2663 | less_2661)) | and_2698);
  // hls/stages/agreement.hpp:264
  logic [7:0] select_2786;
  assign select_2786 = sample_pair_whole_s24_q ? (equal_1602_s24_q ? patches_place_0_slope_q : select_1711[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_2791;
  assign select_2791 = sample_pair_whole_s24_q ? (equal_1602_s24_q ? patches_place_1_slope_q : select_1740[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:508
  logic [55:0] other;
  assign other = new_row_s24_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:176
  logic [51:0] select_2880;
  assign select_2880 = or_1698_s24_q ? {less_1824_s24_q, less_1823_s24_q, less_1814_s24_q, less_1813_s24_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2882;
  assign select_2882 = equal_1692_s24_q ? patches_codes_at_q : (equal_1694_s24_q ? other[55:4] : select_2880);
  // hls/stages/patches.hpp:507
  logic [27:0] select_2885;
  assign select_2885 = equal_2884_s24_q ? word_s24_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:176
  logic [27:0] select_2887;
  assign select_2887 = equal_1694_s24_q ? (new_row_s24_q ? word_s24_q : select_2885) : patches_codes_further_q;
  // hls/stages/patches.hpp:509
  logic [55:0] select_2889;
  assign select_2889 = less_1783_s24_q ? {word_s24_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:479
  logic [55:0] select_2891;
  assign select_2891 = less_2890_s24_q ? {word_s24_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:176
  logic [55:0] select_2893;
  assign select_2893 = or_1698_s24_q ? (equal_1697_s24_q ? patches_next_codes_q : select_2891) : patches_next_codes_q;
  logic [55:0] select_2895;
  assign select_2895 = equal_1692_s24_q ? patches_next_codes_q : (equal_1694_s24_q ? select_2889 : select_2893);
  // hls/stages/count_bits.hpp:24
  logic parity_2900;
  assign parity_2900 = ^{less_1824_s24_q, less_1823_s24_q, less_1814_s24_q, less_1813_s24_q};
  // hls/stages/count_bits.hpp:25
  logic or_2904;
  assign or_2904 = ({less_1814_s24_q, less_1813_s24_q} == 2'h3) | (less_1823_s24_q & (less_1814_s24_q | less_1813_s24_q));
  logic and_2905;
  assign and_2905 = less_1824_s24_q & (^{less_1823_s24_q, less_1814_s24_q, less_1813_s24_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2906;
  assign xor_2906 = or_2904 ^ and_2905;
  // hls/stages/count_bits.hpp:27
  logic and_2907;
  assign and_2907 = or_2904 & and_2905;
  // hls/stages/patches.hpp:176
  logic [2:0] select_2909;
  assign select_2909 = or_1698_s24_q ? (and_1847_s24_q ? {and_2907, xor_2906, parity_2900} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:510
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2923_s24_q;
  // hls/stages/count_bits.hpp:24
  logic xor_2929;
  assign xor_2929 = bits[17] ^ (^{select_2923_s24_q[16:15], other[16:15]});
  logic xor_2932;
  assign xor_2932 = bits[11] ^ (^{select_2923_s24_q[10:9], other[10:9]});
  logic xor_2935;
  assign xor_2935 = bits[14] ^ (^{select_2923_s24_q[13:12], other[13:12]});
  logic xor_2938;
  assign xor_2938 = xor_2929 ^ (^{select_2923_s24_q[14:9], other[14:9]});
  logic xor_2941;
  assign xor_2941 = bits[47] ^ (^{select_2923_s24_q[46:45], other[46:45]});
  logic xor_2944;
  assign xor_2944 = bits[8] ^ (^{select_2923_s24_q[7:6], other[7:6]});
  logic xor_2947;
  assign xor_2947 = bits[2] ^ (^{select_2923_s24_q[1:0], other[1:0]});
  logic xor_2950;
  assign xor_2950 = bits[5] ^ (^{select_2923_s24_q[4:3], other[4:3]});
  logic xor_2953;
  assign xor_2953 = xor_2944 ^ (^{select_2923_s24_q[5:0], other[5:0]});
  logic parity_2955;
  assign parity_2955 = ^{select_2923_s24_q[47:45], select_2923_s24_q[8:0], other[47:45], other[8:0]};
  logic xor_2959;
  assign xor_2959 = bits[44] ^ (^{select_2923_s24_q[43:42], other[43:42]});
  logic xor_2962;
  assign xor_2962 = bits[38] ^ (^{select_2923_s24_q[37:36], other[37:36]});
  logic xor_2965;
  assign xor_2965 = bits[41] ^ (^{select_2923_s24_q[40:39], other[40:39]});
  logic xor_2971;
  assign xor_2971 = bits[26] ^ (^{select_2923_s24_q[25:24], other[25:24]});
  logic xor_2974;
  assign xor_2974 = bits[20] ^ (^{select_2923_s24_q[19:18], other[19:18]});
  logic xor_2977;
  assign xor_2977 = bits[23] ^ (^{select_2923_s24_q[22:21], other[22:21]});
  logic xor_2983;
  assign xor_2983 = bits[35] ^ (^{select_2923_s24_q[34:33], other[34:33]});
  logic xor_2986;
  assign xor_2986 = bits[29] ^ (^{select_2923_s24_q[28:27], other[28:27]});
  logic xor_2989;
  assign xor_2989 = bits[32] ^ (^{select_2923_s24_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:176
  logic select_3273;
  assign select_3273 = equal_1692_s24_q ? patches_summed_first_q : (equal_1694_s24_q ? new_row_s24_q : patches_summed_first_q);
  // hls/stages/patches.hpp:529
  logic [9:0] select_3361;
  assign select_3361 = (patches_read_far_s24_q < patches_peak_far_q) ? patches_read_far_s24_q : patches_peak_far_q;
  logic [9:0] select_3362;
  assign select_3362 = patches_read_first_s24_q ? patches_read_far_s24_q : select_3361;
  // hls/stages/patches.hpp:569
  logic [10:0] sum_3404;
  assign sum_3404 = {1'b0, fall_s24_q} + {2'h0, fall_s24_q[9:1]};
  // hls/stages/patches.hpp:570
  logic [10:0] sum_3408;
  assign sum_3408 = {1'b0, fall_s24_q} + {3'h0, fall_s24_q[9:2]};
  logic not_3413;
  assign not_3413 = ~({eight_s24_q, 3'h0} < ({fall_s24_q, 3'h0} - {3'h0, fall_s24_q}));
  // hls/stages/patches.hpp:583
  logic [7:0] select_3418;
  assign select_3418 = patches_second_s24_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:582
  logic [3:0] sum_3419;
  assign sum_3419 = {2'h0, select_3352_s24_q[14:13]} + 4'hf;
  logic [5:0] select_3420;
  assign select_3420 = patches_second_s24_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3421;
  assign sum_3421 = {select_3420[5], select_3420} + {{4{sum_3419[3]}}, sum_3419[3:1]};
  // hls/stages/agreement.hpp:773
  logic select_3692;
  assign select_3692 = equal_1471_s24_q ? ((x_s24_q[6] & good_known_q) | equal_3580_s24_q) : good_known_q;
  // hls/stages/agreement.hpp:1245
  logic and_3854;
  assign and_3854 = and_2022_s24_q & ({sum_1948_s24_q, index_2_s24_q} == {sum_1935_s24_q, index_s24_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1341; read in stage 24, written in stage 25: 24 < 25 < 24 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1935_s24_q, index_s24_q};
  logic map_re;
  assign map_re = s24_en & (and_1942_s24_q & less_1943_s24_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1804, patches_code_row_s24_q[1:0], of_row_2_s24_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s24_en & and_1838_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1824_s24_q, less_1823_s24_q, less_1814_s24_q, less_1813_s24_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1842, patches_code_row_s24_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s24_en & and_1852_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1824_s24_q, less_1823_s24_q, less_1814_s24_q, less_1813_s24_q, patches_codes_at_q[51:8]};
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
      sharpness_sums_contrast_0_q <= and_513_s24_q ? sum_2209 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_513_s24_q ? sum_2213 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2526_s24_q ? 14'h0 : sum_2545;
      registration_half_measured_q <= select_2551;
      registration_half_votes_down_q <= and_2526_s24_q ? 7'h0 : sum_2557;
      registration_half_votes_up_q <= and_2526_s24_q ? 7'h0 : sum_2565;
      registration_half_half_votes_down_q <= and_2526_s24_q ? 7'h0 : sum_2572;
      registration_half_half_votes_up_q <= and_2526_s24_q ? 7'h0 : sum_2579;
      registration_down_q <= and_2613 ? sum_2632 : registration_down_q;
      registration_up_q <= and_2613 ? sum_2641 : registration_up_q;
      registration_enough_q <= select_2655;
      registration_votes_down_q <= and_2660 ? less_2661 : registration_votes_down_q;
      registration_votes_up_q <= and_2660 ? less_2663 : registration_votes_up_q;
      registration_other_enough_q <= and_2669 ? select_2655 : registration_other_enough_q;
      registration_other_down_q <= and_2669 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2669 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_column_q <= sample_pair_whole_s24_q ? select_1712 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s24_q ? select_1713 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2786;
      patches_place_1_column_q <= sample_pair_whole_s24_q ? select_1741 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s24_q ? select_1742 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2791;
      patches_codes_at_q <= select_2882;
      patches_codes_further_q <= equal_1692_s24_q ? patches_codes_further_q : select_2887;
      patches_next_codes_q <= select_2895;
      patches_summed_first_q <= select_3273;
      patches_peak_far_q <= equal_1692_s24_q ? select_3362 : patches_peak_far_q;
      good_known_q <= select_3692;
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
      census_columns_values_3_cell_4_mask_q <= select_2135;
      census_changes_values_0_left_q <= and_513_s24_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_513_s24_q ? sum_2155 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2157;
      census_changes_values_1_right_q <= select_2158;
      sharpness_last_detail_0_q <= select_2177;
      sharpness_last_detail_1_q <= select_2178;
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
  logic [3:0] select_474_s25_q;
  logic [6:0] select_477_s25_q;
  logic [6:0] column_s25_q;
  logic and_513_s25_q;
  logic so_s25_q;
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
  logic less_568_s25_q;
  logic less_569_s25_q;
  logic less_570_s25_q;
  logic and_578_s25_q;
  logic and_603_s25_q;
  logic and_604_s25_q;
  logic [12:0] sum_624_s25_q;
  logic equal_1471_s25_q;
  logic not_1472_s25_q;
  logic equal_1516_s25_q;
  logic [1:0] sum_1522_s25_q;
  logic equal_1524_s25_q;
  logic equal_1526_s25_q;
  logic equal_1528_s25_q;
  logic equal_1530_s25_q;
  logic equal_1532_s25_q;
  logic equal_1534_s25_q;
  logic [19:0] sum_1576_s25_q;
  logic [11:0] sum_1580_s25_q;
  logic and_1581_s25_q;
  logic and_1584_s25_q;
  logic select_1601_s25_q;
  logic equal_1602_s25_q;
  logic equal_1692_s25_q;
  logic equal_1694_s25_q;
  logic equal_1697_s25_q;
  logic select_1708_s25_q;
  logic [7:0] sum_1714_s25_q;
  logic [4:0] select_1722_s25_q;
  logic select_1728_s25_q;
  logic [7:0] sum_1743_s25_q;
  logic equal_1758_s25_q;
  logic equal_1762_s25_q;
  logic [3:0] select_1767_s25_q;
  logic less_1853_s25_q;
  logic equal_1854_s25_q;
  logic not_1855_s25_q;
  logic equal_1856_s25_q;
  logic not_1882_s25_q;
  logic and_1942_s25_q;
  logic less_1943_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1948_s25_q;
  logic is_seen_s25_q;
  logic and_2012_s25_q;
  logic and_2022_s25_q;
  logic equal_2162_s25_q;
  logic [12:0] sum_2163_s25_q;
  logic [12:0] select_2191_s25_q;
  logic [12:0] select_2203_s25_q;
  logic equal_2215_s25_q;
  logic less_2216_s25_q;
  logic and_2226_s25_q;
  logic and_2236_s25_q;
  logic equal_2259_s25_q;
  logic and_2411_s25_q;
  logic and_2456_s25_q;
  logic [9:0] select_2460_s25_q;
  logic [9:0] select_2463_s25_q;
  logic [9:0] select_2470_s25_q;
  logic and_2491_s25_q;
  logic equal_2665_s25_q;
  logic not_2678_s25_q;
  logic and_2700_s25_q;
  logic [8:0] other_s25_q;
  logic [2:0] select_2910_s25_q;
  logic [8:0] select_2923_s25_q;
  logic xor_2938_s25_q;
  logic xor_2956_s25_q;
  logic xor_2968_s25_q;
  logic xor_2980_s25_q;
  logic xor_2992_s25_q;
  logic or_3001_s25_q;
  logic or_3005_s25_q;
  logic or_3009_s25_q;
  logic or_3016_s25_q;
  logic or_3020_s25_q;
  logic or_3024_s25_q;
  logic or_3031_s25_q;
  logic or_3035_s25_q;
  logic or_3039_s25_q;
  logic or_3049_s25_q;
  logic or_3053_s25_q;
  logic or_3057_s25_q;
  logic or_3065_s25_q;
  logic or_3069_s25_q;
  logic or_3073_s25_q;
  logic or_3080_s25_q;
  logic or_3084_s25_q;
  logic or_3088_s25_q;
  logic or_3098_s25_q;
  logic or_3102_s25_q;
  logic or_3106_s25_q;
  logic and_3111_s25_q;
  logic or_3112_s25_q;
  logic equal_3233_s25_q;
  logic [4:0] select_3321_s25_q;
  logic [12:0] select_3352_s25_q;
  logic [9:0] select_3362_s25_q;
  logic less_3395_s25_q;
  logic not_3403_s25_q;
  logic not_3406_s25_q;
  logic not_3410_s25_q;
  logic not_3413_s25_q;
  logic [7:0] select_3418_s25_q;
  logic sum_3419_s25_q;
  logic [6:0] sum_3421_s25_q;
  logic equal_3473_s25_q;
  logic equal_3580_s25_q;
  logic or_3672_s25_q;
  logic select_3680_s25_q;
  logic equal_3693_s25_q;
  logic equal_3695_s25_q;
  logic equal_3696_s25_q;
  logic and_3839_s25_q;
  logic and_3854_s25_q;
  logic [31:0] select_3917_s25_q;
  logic [9:0] select_3924_s25_q;
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
      select_474_s25_q <= select_474_s24_q;
      select_477_s25_q <= select_477_s24_q;
      column_s25_q <= column_s24_q;
      and_513_s25_q <= and_513_s24_q;
      so_s25_q <= drew_q;
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
      less_568_s25_q <= less_568_s24_q;
      less_569_s25_q <= less_569_s24_q;
      less_570_s25_q <= less_570_s24_q;
      and_578_s25_q <= and_578_s24_q;
      and_603_s25_q <= whole_22 & and_578_s24_q;
      and_604_s25_q <= and_604_s24_q;
      sum_624_s25_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1471_s25_q <= equal_1471_s24_q;
      not_1472_s25_q <= not_1472_s24_q;
      equal_1516_s25_q <= equal_1516_s24_q;
      sum_1522_s25_q <= sum_1522_s24_q;
      equal_1524_s25_q <= equal_1524_s24_q;
      equal_1526_s25_q <= equal_1526_s24_q;
      equal_1528_s25_q <= equal_1528_s24_q;
      equal_1530_s25_q <= equal_1530_s24_q;
      equal_1532_s25_q <= equal_1532_s24_q;
      equal_1534_s25_q <= equal_1534_s24_q;
      sum_1576_s25_q <= select_1572_s24_q + {{6{select_1575[13]}}, select_1575};
      sum_1580_s25_q <= select_1577_s24_q + {{5{select_1579[6]}}, select_1579};
      and_1581_s25_q <= and_1581_s24_q;
      and_1584_s25_q <= and_1584_s24_q;
      select_1601_s25_q <= select_1601_s24_q;
      equal_1602_s25_q <= equal_1602_s24_q;
      equal_1692_s25_q <= equal_1692_s24_q;
      equal_1694_s25_q <= equal_1694_s24_q;
      equal_1697_s25_q <= equal_1697_s24_q;
      select_1708_s25_q <= select_1708_s24_q[0];
      sum_1714_s25_q <= select_1712 + {{2{select_1713[5]}}, select_1713};
      select_1722_s25_q <= select_1722_s24_q;
      select_1728_s25_q <= select_1728_s24_q;
      sum_1743_s25_q <= select_1741 + {{2{select_1742[5]}}, select_1742};
      equal_1758_s25_q <= equal_1758;
      equal_1762_s25_q <= equal_1762;
      select_1767_s25_q <= select_1767_s24_q;
      less_1853_s25_q <= less_1853_s24_q;
      equal_1854_s25_q <= equal_1854_s24_q;
      not_1855_s25_q <= not_1855_s24_q;
      equal_1856_s25_q <= equal_1856_s24_q;
      not_1882_s25_q <= not_1882_s24_q;
      and_1942_s25_q <= and_1942_s24_q;
      less_1943_s25_q <= less_1943_s24_q;
      index_2_s25_q <= index_2_s24_q;
      sum_1948_s25_q <= sum_1948_s24_q;
      is_seen_s25_q <= is_seen;
      and_2012_s25_q <= is_seen & less_2011_s24_q;
      and_2022_s25_q <= and_2022_s24_q;
      equal_2162_s25_q <= equal_2162_s24_q;
      sum_2163_s25_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2155};
      select_2191_s25_q <= and_2189_s24_q ? detail_3[14:2] : 13'h0;
      select_2203_s25_q <= and_2201_s24_q ? detail_4[14:2] : 13'h0;
      equal_2215_s25_q <= equal_2215_s24_q;
      less_2216_s25_q <= less_2216_s24_q;
      and_2226_s25_q <= and_2226;
      and_2236_s25_q <= and_2236;
      equal_2259_s25_q <= equal_2259_s24_q;
      and_2411_s25_q <= and_2411_s24_q;
      and_2456_s25_q <= not_1472_s24_q & (drew_q & and_2454);
      select_2460_s25_q <= select_2460_s24_q;
      select_2463_s25_q <= select_2463_s24_q;
      select_2470_s25_q <= select_2470;
      and_2491_s25_q <= drew_q & (ends_cell_s24_q & (not_2434_s24_q & and_2488));
      equal_2665_s25_q <= equal_2665;
      not_2678_s25_q <= ~(equal_1471_s24_q & and_2676);
      and_2700_s25_q <= and_2700;
      other_s25_q <= other[44:36];
      select_2910_s25_q <= equal_1694_s24_q ? 3'h0 : select_2909;
      select_2923_s25_q <= select_2923_s24_q[44:36];
      xor_2938_s25_q <= xor_2938;
      xor_2956_s25_q <= xor_2938 ^ parity_2955;
      xor_2968_s25_q <= xor_2959 ^ (^{select_2923_s24_q[41:36], other[41:36]});
      xor_2980_s25_q <= xor_2971 ^ (^{select_2923_s24_q[23:18], other[23:18]});
      xor_2992_s25_q <= xor_2983 ^ (^{select_2923_s24_q[32:27], other[32:27]});
      or_3001_s25_q <= (xor_2932 & xor_2935) | (xor_2929 & (xor_2932 | xor_2935));
      or_3005_s25_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3009_s25_q <= (xor_2947 & xor_2950) | (xor_2944 & (xor_2947 | xor_2950));
      or_3016_s25_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3020_s25_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3024_s25_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3031_s25_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3035_s25_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3039_s25_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3049_s25_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3053_s25_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3057_s25_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3065_s25_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3069_s25_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3073_s25_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3080_s25_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3084_s25_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3088_s25_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3098_s25_q <= (xor_2962 & xor_2965) | (xor_2959 & (xor_2962 | xor_2965));
      or_3102_s25_q <= (xor_2974 & xor_2977) | (xor_2971 & (xor_2974 | xor_2977));
      or_3106_s25_q <= (xor_2986 & xor_2989) | (xor_2983 & (xor_2986 | xor_2989));
      and_3111_s25_q <= xor_2941 & xor_2953;
      or_3112_s25_q <= xor_2941 | xor_2953;
      equal_3233_s25_q <= equal_3233_s24_q;
      select_3321_s25_q <= select_3321_s24_q;
      select_3352_s25_q <= select_3352_s24_q[12:0];
      select_3362_s25_q <= select_3362;
      less_3395_s25_q <= less_3395_s24_q;
      not_3403_s25_q <= ~({eight_s24_q, 3'h0} < {3'h0, fall_s24_q});
      not_3406_s25_q <= ~({eight_s24_q, 3'h0} < {1'b0, sum_3404, fall_s24_q[0]});
      not_3410_s25_q <= ~({eight_s24_q, 3'h0} < {sum_3408, fall_s24_q[1:0]});
      not_3413_s25_q <= not_3413;
      select_3418_s25_q <= select_3418;
      sum_3419_s25_q <= sum_3419[0];
      sum_3421_s25_q <= sum_3421;
      equal_3473_s25_q <= equal_3473_s24_q;
      equal_3580_s25_q <= equal_3580_s24_q;
      or_3672_s25_q <= or_3672_s24_q;
      select_3680_s25_q <= select_3680_s24_q;
      equal_3693_s25_q <= equal_3693_s24_q;
      equal_3695_s25_q <= equal_3695_s24_q;
      equal_3696_s25_q <= equal_3696_s24_q;
      and_3839_s25_q <= said_q;
      and_3854_s25_q <= and_3854;
      select_3917_s25_q <= select_3917_s24_q;
      select_3924_s25_q <= select_3924_s24_q;
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
  logic [13:0] sum_625;
  assign sum_625 = {2'h0, census_changes_values_1_left_s25_q} + {1'b0, sum_624_s25_q};
  logic [13:0] sum_626;
  assign sum_626 = {2'h0, census_changes_values_2_left_q} + sum_625;
  // hls/stages/patches.hpp:119
  logic select_1710;
  assign select_1710 = equal_1602_s25_q ? patches_place_0_valid_q : (select_1601_s25_q ? patches_place_0_valid_q : select_1708_s25_q);
  // hls/stages/patches.hpp:315
  logic [7:0] sum_1715;
  assign sum_1715 = sum_1714_s25_q + 8'hff;
  // hls/stages/patches.hpp:123
  logic equal_1716;
  assign equal_1716 = {sum_1715[7], select_477_s25_q, select_474_s25_q} == {1'b0, sum_1715[6:0], 4'h8};
  // hls/stages/patches.hpp:119
  logic select_1739;
  assign select_1739 = equal_1602_s25_q ? patches_place_1_valid_q : (select_1601_s25_q ? select_1708_s25_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:315
  logic [7:0] sum_1744;
  assign sum_1744 = sum_1743_s25_q + 8'hff;
  // hls/stages/patches.hpp:123
  logic equal_1745;
  assign equal_1745 = {sum_1744[7], select_477_s25_q, select_474_s25_q} == {1'b0, sum_1744[6:0], 4'h8};
  // hls/stages/agreement.hpp:508
  logic [11:0] select_2159;
  assign select_2159 = and_513_s25_q ? census_changes_values_1_left_s25_q : census_changes_values_2_left_q;
  logic [11:0] select_2160;
  assign select_2160 = and_513_s25_q ? census_changes_values_1_right_s25_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_2164;
  assign sum_2164 = {2'h0, census_changes_values_1_right_s25_q} + {1'b0, sum_2163_s25_q};
  logic [13:0] sum_2165;
  assign sum_2165 = {2'h0, census_changes_values_2_right_q} + sum_2164;
  // hls/stages/census.hpp:357
  logic [23:0] select_2193;
  assign select_2193 = equal_2162_s25_q ? {11'h0, select_2191_s25_q} : (sharpness_sums_detail_0_q + {11'h0, select_2191_s25_q});
  logic [23:0] select_2205;
  assign select_2205 = equal_2162_s25_q ? {11'h0, select_2203_s25_q} : (sharpness_sums_detail_1_q + {11'h0, select_2203_s25_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_2228;
  assign select_2228 = (less_2216_s25_q & and_2226_s25_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2238;
  assign select_2238 = (less_2216_s25_q & and_2236_s25_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:207
  logic [1:0] select_2247;
  assign select_2247 = equal_2215_s25_q ? {sharpness_comparing_contrast_0_q[0], and_2236_s25_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2249;
  assign select_2249 = equal_2215_s25_q ? {sharpness_comparing_contrast_1_q[0], and_2226_s25_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_2272;
  assign xor_2272 = sharpness_comparing_contrast_0_q[1] ^ and_2226_s25_q;
  logic select_2275;
  assign select_2275 = (equal_2259_s25_q | xor_2272) ? (and_2226_s25_q & xor_2272) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2276;
  assign select_2276 = equal_2215_s25_q ? select_2275 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2278;
  assign xor_2278 = sharpness_comparing_contrast_1_q[1] ^ and_2236_s25_q;
  logic select_2281;
  assign select_2281 = (equal_2259_s25_q | xor_2278) ? (and_2236_s25_q & xor_2278) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2282;
  assign select_2282 = equal_2215_s25_q ? select_2281 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2458;
  assign select_2458 = and_2411_s25_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2456_s25_q});
  logic [13:0] select_2472;
  assign select_2472 = and_2411_s25_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2470_s25_q});
  // hls/stages/agreement.hpp:773
  logic and_2492;
  assign and_2492 = not_1472_s25_q & and_2491_s25_q;
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2494;
  assign select_2494 = and_2411_s25_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2492});
  // hls/stages/patches.hpp:159
  logic [9:0] sum_2913;
  assign sum_2913 = {7'h0, patches_set_q} + (equal_1697_s25_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_2993;
  assign xor_2993 = xor_2980_s25_q ^ xor_2992_s25_q;
  // hls/stages/count_bits.hpp:25
  logic or_3118;
  assign or_3118 = (xor_2980_s25_q & xor_2992_s25_q) | (xor_2968_s25_q & (xor_2980_s25_q | xor_2992_s25_q));
  // hls/stages/patches.hpp:569
  logic [1:0] sum_3407;
  assign sum_3407 = {1'b0, not_3403_s25_q} + {1'b0, not_3406_s25_q};
  // hls/stages/patches.hpp:570
  logic [1:0] sum_3414;
  assign sum_3414 = {1'b0, not_3410_s25_q} + {1'b0, not_3413_s25_q};
  // hls/stages/patches.hpp:569
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3407} + {1'b0, sum_3414};
  // hls/stages/patches.hpp:583
  logic [18:0] product_3422;
  assign product_3422 = $signed({{11{select_3418_s25_q[7]}}, select_3418_s25_q}) * $signed({{8{sum_3421_s25_q[6]}}, sum_3421_s25_q, sum_3419_s25_q, select_3352_s25_q[12:10]});
  // hls/stages/agreement.hpp:1077
  logic [13:0] select_3698;
  assign select_3698 = equal_3695_s25_q ? counts_skin_unproven_q : (equal_3696_s25_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3693_s25_q ? counts_nearer_s25_q : select_3698;
  // hls/stages/agreement.hpp:1092
  logic [31:0] select_3918;
  assign select_3918 = equal_1534_s25_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3917_s25_q;
  logic [31:0] select_3919;
  assign select_3919 = equal_1532_s25_q ? {8'h0, sharpness_sums_detail_0_q} : select_3918;
  logic [31:0] select_3920;
  assign select_3920 = equal_1530_s25_q ? {8'h0, sharpness_sums_detail_1_q} : select_3919;
  logic [31:0] select_3921;
  assign select_3921 = equal_1528_s25_q ? {8'h0, sharpness_sums_contrast_0_s25_q} : select_3920;
  logic [31:0] select_3922;
  assign select_3922 = equal_1526_s25_q ? {8'h0, sharpness_sums_contrast_1_s25_q} : select_3921;

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1522_s25_q, lower_half_s25_q, registration_of_right_s25_q};
  logic registration_sums_we;
  assign registration_sums_we = s25_en & and_1581_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1580_s25_q, sum_1576_s25_q};
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
  assign map_waddr = {sum_1948_s25_q, index_2_s25_q};
  logic map_we;
  assign map_we = s25_en & and_2022_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2012_s25_q, is_seen_s25_q};
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
      sharpness_sums_detail_0_q <= and_513_s25_q ? select_2193 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_513_s25_q ? select_2205 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s25_q ? select_2247 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s25_q ? select_2249 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s25_q ? select_2276 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s25_q ? select_2282 : sharpness_comparing_less_contrast_1_q;
      counts_unproven_q <= select_2458;
      counts_regions_bad_q <= select_2472;
      counts_skin_unproven_q <= select_2494;
      registration_moved_q <= not_2678_s25_q & (registration_moved_q | and_2700_s25_q);
      patches_place_0_valid_q <= sample_pair_whole_s25_q ? select_1710 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s25_q ? select_1739 : patches_place_1_valid_q;
      patches_set_q <= equal_1692_s25_q ? 3'h0 : select_2910_s25_q;
      patches_size_q <= sum_2913;
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
      census_changes_values_2_left_q <= select_2159;
      census_changes_values_2_right_q <= select_2160;
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
  logic and_513_s26_q;
  logic so_s26_q;
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
  logic less_568_s26_q;
  logic less_569_s26_q;
  logic less_570_s26_q;
  logic and_578_s26_q;
  logic and_603_s26_q;
  logic and_604_s26_q;
  logic [8:0] sum_626_s26_q;
  logic equal_1471_s26_q;
  logic equal_1516_s26_q;
  logic equal_1524_s26_q;
  logic and_1584_s26_q;
  logic select_1601_s26_q;
  logic equal_1602_s26_q;
  logic equal_1692_s26_q;
  logic equal_1694_s26_q;
  logic select_1708_s26_q;
  logic select_1710_s26_q;
  logic equal_1716_s26_q;
  logic [4:0] select_1722_s26_q;
  logic select_1728_s26_q;
  logic select_1739_s26_q;
  logic equal_1745_s26_q;
  logic or_1760_s26_q;
  logic or_1764_s26_q;
  logic [3:0] select_1767_s26_q;
  logic less_1853_s26_q;
  logic equal_1854_s26_q;
  logic not_1855_s26_q;
  logic equal_1856_s26_q;
  logic not_1882_s26_q;
  logic and_1942_s26_q;
  logic less_1943_s26_q;
  logic [1:0] map_rdata_s26_q;
  logic is_seen_s26_q;
  logic and_2012_s26_q;
  logic equal_2162_s26_q;
  logic [8:0] sum_2165_s26_q;
  logic equal_2215_s26_q;
  logic less_2216_s26_q;
  logic [17:0] select_2228_s26_q;
  logic [17:0] select_2238_s26_q;
  logic equal_2259_s26_q;
  logic [9:0] select_2460_s26_q;
  logic [9:0] select_2463_s26_q;
  logic equal_2665_s26_q;
  logic parity_2997_s26_q;
  logic or_3001_s26_q;
  logic or_3005_s26_q;
  logic or_3009_s26_q;
  logic or_3016_s26_q;
  logic or_3020_s26_q;
  logic or_3024_s26_q;
  logic or_3031_s26_q;
  logic or_3035_s26_q;
  logic or_3039_s26_q;
  logic or_3049_s26_q;
  logic or_3053_s26_q;
  logic or_3057_s26_q;
  logic or_3065_s26_q;
  logic or_3069_s26_q;
  logic or_3073_s26_q;
  logic or_3080_s26_q;
  logic or_3084_s26_q;
  logic or_3088_s26_q;
  logic or_3098_s26_q;
  logic or_3102_s26_q;
  logic or_3106_s26_q;
  logic and_3110_s26_q;
  logic or_3114_s26_q;
  logic or_3118_s26_q;
  logic equal_3233_s26_q;
  logic [4:0] select_3321_s26_q;
  logic [9:0] select_3352_s26_q;
  logic [9:0] select_3362_s26_q;
  logic less_3395_s26_q;
  logic [2:0] fraction_s26_q;
  logic [13:0] product_3422_s26_q;
  logic equal_3473_s26_q;
  logic equal_3580_s26_q;
  logic or_3672_s26_q;
  logic select_3680_s26_q;
  logic and_3694_s26_q;
  logic [13:0] before_v_4_s26_q;
  logic not_3731_s26_q;
  logic or_3735_s26_q;
  logic and_3839_s26_q;
  logic and_3854_s26_q;
  logic not_3869_s26_q;
  logic [31:0] select_3922_s26_q;
  logic [9:0] select_3924_s26_q;
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
      and_513_s26_q <= and_513_s25_q;
      so_s26_q <= so_s25_q;
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
      less_568_s26_q <= less_568_s25_q;
      less_569_s26_q <= less_569_s25_q;
      less_570_s26_q <= less_570_s25_q;
      and_578_s26_q <= and_578_s25_q;
      and_603_s26_q <= and_603_s25_q;
      and_604_s26_q <= and_604_s25_q;
      sum_626_s26_q <= sum_626[13:5];
      equal_1471_s26_q <= equal_1471_s25_q;
      equal_1516_s26_q <= equal_1516_s25_q;
      equal_1524_s26_q <= equal_1524_s25_q;
      and_1584_s26_q <= and_1584_s25_q;
      select_1601_s26_q <= select_1601_s25_q;
      equal_1602_s26_q <= equal_1602_s25_q;
      equal_1692_s26_q <= equal_1692_s25_q;
      equal_1694_s26_q <= equal_1694_s25_q;
      select_1708_s26_q <= select_1708_s25_q;
      select_1710_s26_q <= select_1710;
      equal_1716_s26_q <= equal_1716;
      select_1722_s26_q <= select_1722_s25_q;
      select_1728_s26_q <= select_1728_s25_q;
      select_1739_s26_q <= select_1739;
      equal_1745_s26_q <= equal_1745;
      or_1760_s26_q <= and_1584_s25_q | (select_1710 & equal_1758_s25_q);
      or_1764_s26_q <= and_1584_s25_q | (select_1739 & equal_1762_s25_q);
      select_1767_s26_q <= select_1767_s25_q;
      less_1853_s26_q <= less_1853_s25_q;
      equal_1854_s26_q <= equal_1854_s25_q;
      not_1855_s26_q <= not_1855_s25_q;
      equal_1856_s26_q <= equal_1856_s25_q;
      not_1882_s26_q <= not_1882_s25_q;
      and_1942_s26_q <= and_1942_s25_q;
      less_1943_s26_q <= less_1943_s25_q;
      map_rdata_s26_q <= map_rdata_q;
      is_seen_s26_q <= is_seen_s25_q;
      and_2012_s26_q <= and_2012_s25_q;
      equal_2162_s26_q <= equal_2162_s25_q;
      sum_2165_s26_q <= sum_2165[13:5];
      equal_2215_s26_q <= equal_2215_s25_q;
      less_2216_s26_q <= less_2216_s25_q;
      select_2228_s26_q <= select_2228;
      select_2238_s26_q <= select_2238;
      equal_2259_s26_q <= equal_2259_s25_q;
      select_2460_s26_q <= select_2460_s25_q;
      select_2463_s26_q <= select_2463_s25_q;
      equal_2665_s26_q <= equal_2665_s25_q;
      parity_2997_s26_q <= ^{xor_2993, xor_2956_s25_q, select_2923_s25_q, other_s25_q};
      or_3001_s26_q <= or_3001_s25_q;
      or_3005_s26_q <= or_3005_s25_q;
      or_3009_s26_q <= or_3009_s25_q;
      or_3016_s26_q <= or_3016_s25_q;
      or_3020_s26_q <= or_3020_s25_q;
      or_3024_s26_q <= or_3024_s25_q;
      or_3031_s26_q <= or_3031_s25_q;
      or_3035_s26_q <= or_3035_s25_q;
      or_3039_s26_q <= or_3039_s25_q;
      or_3049_s26_q <= or_3049_s25_q;
      or_3053_s26_q <= or_3053_s25_q;
      or_3057_s26_q <= or_3057_s25_q;
      or_3065_s26_q <= or_3065_s25_q;
      or_3069_s26_q <= or_3069_s25_q;
      or_3073_s26_q <= or_3073_s25_q;
      or_3080_s26_q <= or_3080_s25_q;
      or_3084_s26_q <= or_3084_s25_q;
      or_3088_s26_q <= or_3088_s25_q;
      or_3098_s26_q <= or_3098_s25_q;
      or_3102_s26_q <= or_3102_s25_q;
      or_3106_s26_q <= or_3106_s25_q;
      and_3110_s26_q <= xor_2956_s25_q & (^{xor_2993, select_2923_s25_q, other_s25_q});
      or_3114_s26_q <= and_3111_s25_q | (xor_2938_s25_q & or_3112_s25_q);
      or_3118_s26_q <= or_3118;
      equal_3233_s26_q <= equal_3233_s25_q;
      select_3321_s26_q <= select_3321_s25_q;
      select_3352_s26_q <= select_3352_s25_q[9:0];
      select_3362_s26_q <= select_3362_s25_q;
      less_3395_s26_q <= less_3395_s25_q;
      fraction_s26_q <= fraction;
      product_3422_s26_q <= product_3422[18:5];
      equal_3473_s26_q <= equal_3473_s25_q;
      equal_3580_s26_q <= equal_3580_s25_q;
      or_3672_s26_q <= or_3672_s25_q;
      select_3680_s26_q <= select_3680_s25_q;
      and_3694_s26_q <= equal_3693_s25_q & equal_3473_s25_q;
      before_v_4_s26_q <= before_v_4;
      not_3731_s26_q <= ~(equal_3696_s25_q & equal_3473_s25_q);
      or_3735_s26_q <= (equal_3696_s25_q | equal_3695_s25_q) | (x_s25_q[6:3] == 4'hf);
      and_3839_s26_q <= and_3839_s25_q;
      and_3854_s26_q <= and_3854_s25_q;
      not_3869_s26_q <= ~proven_q;
      select_3922_s26_q <= select_3922;
      select_3924_s26_q <= select_3924_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic hides_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1761;
  assign select_1761 = or_1760_s26_q ? {and_1584_s26_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1765;
  assign select_1765 = or_1764_s26_q ? {and_1584_s26_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:134
  logic [3:0] column_5;
  assign column_5 = select_1761[4] ? select_1765[3:0] : select_1761[3:0];
  logic and_1770;
  assign and_1770 = select_1728_s26_q & (select_1722_s26_q[3] ^ select_1722_s26_q[4]);
  logic and_1775;
  assign and_1775 = sample_pair_whole_s26_q & (and_1770 & ((~select_1761[4]) | (~select_1765[4])));
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2228_s26_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2231;
  assign select_2231 = equal_2215_s26_q ? (less_2216_s26_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2238_s26_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2241;
  assign select_2241 = equal_2215_s26_q ? (less_2216_s26_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:264
  logic [4:0] select_2810;
  assign select_2810 = sample_pair_whole_s26_q ? (select_1761[4] ? {1'b1, select_1761[3:0]} : (select_1761 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2813;
  assign select_2813 = sample_pair_whole_s26_q ? (select_1765[4] ? {1'b1, select_1765[3:0]} : (select_1765 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3027;
  assign parity_3027 = ^{or_3024_s26_q, or_3020_s26_q, or_3016_s26_q};
  logic parity_3042;
  assign parity_3042 = ^{or_3039_s26_q, or_3035_s26_q, or_3031_s26_q};
  logic parity_3045;
  assign parity_3045 = ^{or_3039_s26_q, or_3035_s26_q, or_3031_s26_q, or_3024_s26_q, or_3020_s26_q, or_3016_s26_q, or_3009_s26_q, or_3005_s26_q, or_3001_s26_q};
  logic parity_3076;
  assign parity_3076 = ^{or_3073_s26_q, or_3069_s26_q, or_3065_s26_q};
  logic parity_3091;
  assign parity_3091 = ^{or_3088_s26_q, or_3084_s26_q, or_3080_s26_q};
  logic parity_3094;
  assign parity_3094 = ^{or_3088_s26_q, or_3084_s26_q, or_3080_s26_q, or_3073_s26_q, or_3069_s26_q, or_3065_s26_q, or_3057_s26_q, or_3053_s26_q, or_3049_s26_q};
  logic parity_3109;
  assign parity_3109 = ^{or_3106_s26_q, or_3102_s26_q, or_3098_s26_q};
  logic parity_3121;
  assign parity_3121 = ^{or_3118_s26_q, or_3114_s26_q, and_3110_s26_q};
  logic parity_3124;
  assign parity_3124 = ^{or_3118_s26_q, or_3114_s26_q, and_3110_s26_q, or_3106_s26_q, or_3102_s26_q, or_3098_s26_q, or_3088_s26_q, or_3084_s26_q, or_3080_s26_q, or_3073_s26_q, or_3069_s26_q, or_3065_s26_q, or_3057_s26_q, or_3053_s26_q, or_3049_s26_q};
  logic parity_3126;
  assign parity_3126 = ^{or_3118_s26_q, or_3114_s26_q, and_3110_s26_q, or_3106_s26_q, or_3102_s26_q, or_3098_s26_q, or_3088_s26_q, or_3084_s26_q, or_3080_s26_q, or_3073_s26_q, or_3069_s26_q, or_3065_s26_q, or_3057_s26_q, or_3053_s26_q, or_3049_s26_q, or_3039_s26_q, or_3035_s26_q, or_3031_s26_q, or_3024_s26_q, or_3020_s26_q, or_3016_s26_q, or_3009_s26_q, or_3005_s26_q, or_3001_s26_q};
  // hls/stages/count_bits.hpp:25
  logic and_3127;
  assign and_3127 = parity_3045 & parity_3124;
  logic and_3130;
  assign and_3130 = (^{or_3009_s26_q, or_3005_s26_q, or_3001_s26_q}) & (parity_3027 | parity_3042);
  logic or_3131;
  assign or_3131 = (parity_3027 & parity_3042) | and_3130;
  logic or_3135;
  assign or_3135 = (parity_3109 & parity_3121) | (parity_3094 & (parity_3109 | parity_3121));
  logic and_3141;
  assign and_3141 = (^{or_3057_s26_q, or_3053_s26_q, or_3049_s26_q}) & (parity_3076 | parity_3091);
  logic or_3142;
  assign or_3142 = (parity_3076 & parity_3091) | and_3141;
  logic or_3146;
  assign or_3146 = (or_3102_s26_q & or_3106_s26_q) | (or_3098_s26_q & (or_3102_s26_q | or_3106_s26_q));
  logic or_3150;
  assign or_3150 = (or_3114_s26_q & or_3118_s26_q) | (and_3110_s26_q & (or_3114_s26_q | or_3118_s26_q));
  // hls/stages/count_bits.hpp:23
  logic or_3157;
  assign or_3157 = (or_3053_s26_q & or_3057_s26_q) | (or_3049_s26_q & (or_3053_s26_q | or_3057_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3161;
  assign or_3161 = (or_3069_s26_q & or_3073_s26_q) | (or_3065_s26_q & (or_3069_s26_q | or_3073_s26_q));
  logic or_3165;
  assign or_3165 = (or_3084_s26_q & or_3088_s26_q) | (or_3080_s26_q & (or_3084_s26_q | or_3088_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3168;
  assign parity_3168 = ^{or_3165, or_3161, or_3157};
  // hls/stages/count_bits.hpp:23
  logic or_3172;
  assign or_3172 = (or_3005_s26_q & or_3009_s26_q) | (or_3001_s26_q & (or_3005_s26_q | or_3009_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3176;
  assign or_3176 = (or_3020_s26_q & or_3024_s26_q) | (or_3016_s26_q & (or_3020_s26_q | or_3024_s26_q));
  logic or_3180;
  assign or_3180 = (or_3035_s26_q & or_3039_s26_q) | (or_3031_s26_q & (or_3035_s26_q | or_3039_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3183;
  assign parity_3183 = ^{or_3180, or_3176, or_3172};
  logic parity_3186;
  assign parity_3186 = ^{or_3180, or_3176, or_3172, or_3165, or_3161, or_3157, or_3150, or_3146, or_3142};
  // hls/stages/patches.hpp:580
  logic [9:0] difference_3365;
  assign difference_3365 = select_3362_s26_q - select_3352_s26_q;
  // hls/stages/patches.hpp:585
  logic or_3372;
  assign or_3372 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3352_s26_q);
  // hls/stages/patches.hpp:571
  logic [1:0] sum_3396;
  assign sum_3396 = select_3321_s26_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:572
  logic [7:0] difference_3416;
  assign difference_3416 = {sum_3396, select_3321_s26_q[2:0], 3'h0} - {5'h0, fraction_s26_q};
  logic [7:0] select_3417;
  assign select_3417 = less_3395_s26_q ? difference_3416 : {sum_3396, select_3321_s26_q[2:0], fraction_s26_q};
  // hls/stages/agreement.hpp:1163
  logic [14:0] over;
  assign over = {1'b0, product_s26_q} - {1'b0, before_v_4_s26_q};
  // hls/stages/agreement.hpp:1171
  logic select_3701;
  assign select_3701 = and_3694_s26_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1245
  logic [1:0] select_3855;
  assign select_3855 = and_3854_s26_q ? {and_2012_s26_q, is_seen_s26_q} : map_rdata_s26_q;
  // hls/stages/agreement.hpp:1246
  logic and_3856;
  assign and_3856 = proven_q & less_3844;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      hides_q <= 1'b0;
    end else if (s26_en) begin
      sharpness_comparing_rest_0_q <= so_s26_q ? select_2231 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s26_q ? select_2241 : sharpness_comparing_rest_1_q;
      patches_left_next_0_q <= select_2810;
      patches_left_next_1_q <= select_2813;
      hides_q <= equal_1471_s26_q ? select_3701 : hides_q;
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
  logic and_513_s27_q;
  logic so_s27_q;
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
  logic less_568_s27_q;
  logic less_569_s27_q;
  logic less_570_s27_q;
  logic and_578_s27_q;
  logic and_603_s27_q;
  logic and_604_s27_q;
  logic less_627_s27_q;
  logic equal_1471_s27_q;
  logic equal_1516_s27_q;
  logic equal_1524_s27_q;
  logic and_1584_s27_q;
  logic select_1601_s27_q;
  logic equal_1602_s27_q;
  logic equal_1692_s27_q;
  logic equal_1694_s27_q;
  logic select_1708_s27_q;
  logic or_1718_s27_q;
  logic [4:0] select_1722_s27_q;
  logic select_1728_s27_q;
  logic or_1747_s27_q;
  logic [3:0] column_5_s27_q;
  logic [3:0] select_1767_s27_q;
  logic select_1768_s27_q;
  logic and_1775_s27_q;
  logic less_1853_s27_q;
  logic equal_1854_s27_q;
  logic not_1855_s27_q;
  logic equal_1856_s27_q;
  logic not_1882_s27_q;
  logic and_1942_s27_q;
  logic less_1943_s27_q;
  logic equal_2162_s27_q;
  logic and_2167_s27_q;
  logic equal_2215_s27_q;
  logic sum_s27_q;
  logic sum_2_s27_q;
  logic equal_2259_s27_q;
  logic select_2277_s27_q;
  logic select_2283_s27_q;
  logic [9:0] select_2460_s27_q;
  logic [9:0] select_2463_s27_q;
  logic equal_2665_s27_q;
  logic parity_2997_s27_q;
  logic parity_3126_s27_q;
  logic and_3127_s27_q;
  logic or_3131_s27_q;
  logic or_3135_s27_q;
  logic or_3142_s27_q;
  logic or_3146_s27_q;
  logic or_3150_s27_q;
  logic or_3157_s27_q;
  logic or_3161_s27_q;
  logic or_3165_s27_q;
  logic or_3172_s27_q;
  logic or_3176_s27_q;
  logic or_3180_s27_q;
  logic parity_3186_s27_q;
  logic or_3196_s27_q;
  logic or_3200_s27_q;
  logic and_3207_s27_q;
  logic and_3209_s27_q;
  logic and_3211_s27_q;
  logic equal_3233_s27_q;
  logic equal_3364_s27_q;
  logic less_3366_s27_q;
  logic less_3367_s27_q;
  logic or_3372_s27_q;
  logic [7:0] select_3417_s27_q;
  logic [13:0] product_3422_s27_q;
  logic equal_3473_s27_q;
  logic equal_3580_s27_q;
  logic or_3672_s27_q;
  logic select_3680_s27_q;
  logic select_3701_s27_q;
  logic and_3729_s27_q;
  logic not_3731_s27_q;
  logic or_3735_s27_q;
  logic and_3839_s27_q;
  logic and_3857_s27_q;
  logic and_3860_s27_q;
  logic not_3869_s27_q;
  logic [31:0] select_3922_s27_q;
  logic [9:0] select_3924_s27_q;
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
      and_513_s27_q <= and_513_s26_q;
      so_s27_q <= so_s26_q;
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
      less_568_s27_q <= less_568_s26_q;
      less_569_s27_q <= less_569_s26_q;
      less_570_s27_q <= less_570_s26_q;
      and_578_s27_q <= and_578_s26_q;
      and_603_s27_q <= and_603_s26_q;
      and_604_s27_q <= and_604_s26_q;
      less_627_s27_q <= 9'h4 < sum_626_s26_q;
      equal_1471_s27_q <= equal_1471_s26_q;
      equal_1516_s27_q <= equal_1516_s26_q;
      equal_1524_s27_q <= equal_1524_s26_q;
      and_1584_s27_q <= and_1584_s26_q;
      select_1601_s27_q <= select_1601_s26_q;
      equal_1602_s27_q <= equal_1602_s26_q;
      equal_1692_s27_q <= equal_1692_s26_q;
      equal_1694_s27_q <= equal_1694_s26_q;
      select_1708_s27_q <= select_1708_s26_q;
      or_1718_s27_q <= and_1584_s26_q | (select_1710_s26_q & equal_1716_s26_q);
      select_1722_s27_q <= select_1722_s26_q;
      select_1728_s27_q <= select_1728_s26_q;
      or_1747_s27_q <= and_1584_s26_q | (select_1739_s26_q & equal_1745_s26_q);
      column_5_s27_q <= column_5;
      select_1767_s27_q <= select_1767_s26_q;
      select_1768_s27_q <= or_1760_s26_q ? and_1584_s26_q : patches_left_next_0_q[4];
      and_1775_s27_q <= and_1775;
      less_1853_s27_q <= less_1853_s26_q;
      equal_1854_s27_q <= equal_1854_s26_q;
      not_1855_s27_q <= not_1855_s26_q;
      equal_1856_s27_q <= equal_1856_s26_q;
      not_1882_s27_q <= not_1882_s26_q;
      and_1942_s27_q <= and_1942_s26_q;
      less_1943_s27_q <= less_1943_s26_q;
      equal_2162_s27_q <= equal_2162_s26_q;
      and_2167_s27_q <= and_603_s26_q & (9'h4 < sum_2165_s26_q);
      equal_2215_s27_q <= equal_2215_s26_q;
      sum_s27_q <= sum[0];
      sum_2_s27_q <= sum_2[0];
      equal_2259_s27_q <= equal_2259_s26_q;
      select_2277_s27_q <= sharpness_comparing_less_contrast_0_q;
      select_2283_s27_q <= sharpness_comparing_less_contrast_1_q;
      select_2460_s27_q <= select_2460_s26_q;
      select_2463_s27_q <= select_2463_s26_q;
      equal_2665_s27_q <= equal_2665_s26_q;
      parity_2997_s27_q <= parity_2997_s26_q;
      parity_3126_s27_q <= parity_3126;
      and_3127_s27_q <= and_3127;
      or_3131_s27_q <= or_3131;
      or_3135_s27_q <= or_3135;
      or_3142_s27_q <= or_3142;
      or_3146_s27_q <= or_3146;
      or_3150_s27_q <= or_3150;
      or_3157_s27_q <= or_3157;
      or_3161_s27_q <= or_3161;
      or_3165_s27_q <= or_3165;
      or_3172_s27_q <= or_3172;
      or_3176_s27_q <= or_3176;
      or_3180_s27_q <= or_3180;
      parity_3186_s27_q <= parity_3186;
      or_3196_s27_q <= (or_3161 & or_3165) | (or_3157 & (or_3161 | or_3165));
      or_3200_s27_q <= (or_3176 & or_3180) | (or_3172 & (or_3176 | or_3180));
      and_3207_s27_q <= and_3127 & (or_3131 | or_3135);
      and_3209_s27_q <= parity_3168 & parity_3183;
      and_3211_s27_q <= (^{or_3150, or_3146, or_3142}) & (parity_3168 | parity_3183);
      equal_3233_s27_q <= equal_3233_s26_q;
      equal_3364_s27_q <= select_3321_s26_q[3:0] == 4'h0;
      less_3366_s27_q <= {difference_3365, 3'h0} < {3'h0, patches_size_q};
      less_3367_s27_q <= select_3362_s26_q < select_3352_s26_q;
      or_3372_s27_q <= or_3372;
      select_3417_s27_q <= select_3417;
      product_3422_s27_q <= product_3422_s26_q;
      equal_3473_s27_q <= equal_3473_s26_q;
      equal_3580_s27_q <= equal_3580_s26_q;
      or_3672_s27_q <= or_3672_s26_q;
      select_3680_s27_q <= select_3680_s26_q;
      select_3701_s27_q <= select_3701;
      and_3729_s27_q <= over[14] & equal_3473_s26_q;
      not_3731_s27_q <= not_3731_s26_q;
      or_3735_s27_q <= or_3735_s26_q;
      and_3839_s27_q <= and_3839_s26_q;
      and_3857_s27_q <= select_3855[0] & and_3856;
      and_3860_s27_q <= select_3855[1] & and_3856;
      not_3869_s27_q <= not_3869_s26_q;
      select_3922_s27_q <= select_3922_s26_q;
      select_3924_s27_q <= select_3924_s26_q;
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
  logic and_628;
  assign and_628 = and_578_s27_q & less_627_s27_q;
  // hls/stages/patches.hpp:125
  logic [5:0] select_1729;
  assign select_1729 = or_1718_s27_q ? {and_1584_s27_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:129
  logic and_1731;
  assign and_1731 = select_1728_s27_q & (~select_1729[5]);
  // hls/stages/patches.hpp:125
  logic [5:0] select_1749;
  assign select_1749 = or_1747_s27_q ? {and_1584_s27_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:129
  logic and_1751;
  assign and_1751 = select_1728_s27_q & (~select_1749[5]);
  // hls/stages/census.hpp:306
  logic and_2168;
  assign and_2168 = and_603_s27_q & less_627_s27_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2169;
  assign sum_2169 = census_left_misses_q + {{17{and_2168}}, and_2167_s27_q, 1'b0, and_2167_s27_q};
  // hls/stages/agreement.hpp:508
  logic [19:0] select_2171;
  assign select_2171 = and_513_s27_q ? (equal_2162_s27_q ? 20'h0 : sum_2169) : census_left_misses_q;
  // hls/stages/agreement.hpp:207
  logic [2:0] select_2243;
  assign select_2243 = equal_2215_s27_q ? {sharpness_comparing_product_0_q[1:0], sum_s27_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2245;
  assign select_2245 = equal_2215_s27_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s27_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s27_q});
  // hls/stages/agreement.hpp:207
  logic select_2254;
  assign select_2254 = so_s27_q ? (equal_2215_s27_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s27_q});
  // hls/stages/agreement.hpp:207
  logic select_2257;
  assign select_2257 = equal_2215_s27_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_2260;
  assign xor_2260 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2266;
  assign xor_2266 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:119
  logic select_2793;
  assign select_2793 = equal_1602_s27_q ? patches_valid_0_q : (select_1601_s27_q ? patches_valid_0_q : select_1708_s27_q);
  // hls/stages/agreement.hpp:264
  logic select_2796;
  assign select_2796 = sample_pair_whole_s27_q ? (and_1731 ? (sample_present_s27_q & select_2793) : select_2793) : patches_valid_0_q;
  // hls/stages/patches.hpp:119
  logic select_2798;
  assign select_2798 = equal_1602_s27_q ? patches_valid_1_q : (select_1601_s27_q ? select_1708_s27_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:264
  logic select_2801;
  assign select_2801 = sample_pair_whole_s27_q ? (and_1751 ? (sample_present_s27_q & select_2798) : select_2798) : patches_valid_1_q;
  logic [5:0] select_2804;
  assign select_2804 = sample_pair_whole_s27_q ? (select_1729[5] ? {1'b1, select_1729[4:0]} : (select_1729 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2807;
  assign select_2807 = sample_pair_whole_s27_q ? (select_1749[5] ? {1'b1, select_1749[4:0]} : (select_1749 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3188;
  assign parity_3188 = ^{or_3180_s27_q, or_3176_s27_q, or_3172_s27_q, or_3165_s27_q, or_3161_s27_q, or_3157_s27_q, or_3150_s27_q, or_3146_s27_q, or_3142_s27_q, or_3135_s27_q, or_3131_s27_q, and_3127_s27_q};
  // hls/stages/count_bits.hpp:25
  logic or_3192;
  assign or_3192 = (or_3146_s27_q & or_3150_s27_q) | (or_3142_s27_q & (or_3146_s27_q | or_3150_s27_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3203;
  assign parity_3203 = ^{or_3200_s27_q, or_3196_s27_q, or_3192};
  // hls/stages/count_bits.hpp:25
  logic and_3204;
  assign and_3204 = (^{or_3135_s27_q, or_3131_s27_q, and_3127_s27_q}) & parity_3186_s27_q;
  logic or_3208;
  assign or_3208 = (or_3131_s27_q & or_3135_s27_q) | and_3207_s27_q;
  logic or_3212;
  assign or_3212 = and_3209_s27_q | and_3211_s27_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3215;
  assign parity_3215 = ^{or_3212, or_3208, and_3204};
  // hls/stages/count_bits.hpp:25
  logic and_3217;
  assign and_3217 = parity_3203 & parity_3215;
  logic or_3221;
  assign or_3221 = (or_3196_s27_q & or_3200_s27_q) | (or_3192 & (or_3196_s27_q | or_3200_s27_q));
  logic or_3225;
  assign or_3225 = (or_3208 & or_3212) | (and_3204 & (or_3208 | or_3212));
  // hls/stages/patches.hpp:585
  logic or_3373;
  assign or_3373 = (~(patches_second_s27_q ? patches_valid_1_q : patches_valid_0_q)) | or_3372_s27_q;
  logic or_3376;
  assign or_3376 = equal_3364_s27_q | (less_3366_s27_q | (less_3367_s27_q | or_3373));
  // hls/stages/patches.hpp:584
  logic [14:0] difference_3423;
  assign difference_3423 = {{7{select_3417_s27_q[7]}}, select_3417_s27_q} - {product_3422_s27_q[13], product_3422_s27_q};
  // hls/stages/patches.hpp:590
  logic less_3424;
  assign less_3424 = $signed({{8{difference_3394[6]}}, difference_3394}) < $signed(difference_3423);
  // hls/stages/agreement.hpp:1096
  logic not_3702;
  assign not_3702 = ~hidden_for_q[7];
  logic [7:0] select_3704;
  assign select_3704 = select_3701_s27_q ? (hidden_for_q + {7'h0, not_3702}) : 8'h0;
  // hls/stages/agreement.hpp:773
  logic [7:0] select_3706;
  assign select_3706 = equal_1471_s27_q ? (equal_3580_s27_q ? select_3704 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1169
  logic and_3732;
  assign and_3732 = too_much_q & not_3731_s27_q;
  // hls/stages/agreement.hpp:1170
  logic select_3737;
  assign select_3737 = and_3729_s27_q ? (and_3732 | or_3735_s27_q) : and_3732;
  // hls/stages/agreement.hpp:425
  logic select_3859;
  assign select_3859 = and_1942_s27_q ? (less_1943_s27_q ? and_3857_s27_q : seen_q) : seen_q;
  logic select_3862;
  assign select_3862 = and_1942_s27_q ? (less_1943_s27_q ? and_3860_s27_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1098
  logic or_3888;
  assign or_3888 = select_2277_s27_q | ($signed(20'h0) < $signed(census_left_misses_q));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s27_q;
  logic fresh_we;
  assign fresh_we = s27_en & and_513_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s27_q, and_628, and_604_s27_q, and_603_s27_q, and_578_s27_q, less_570_s27_q, less_569_s27_q, less_568_s27_q, less_567_s27_q, less_566_s27_q, less_565_s27_q, less_564_s27_q, less_563_s27_q, less_562_s27_q, less_561_s27_q, less_560_s27_q, less_559_s27_q, less_558_s27_q, less_557_s27_q, less_556_s27_q, less_555_s27_q, less_554_s27_q, less_553_s27_q, less_552_s27_q, less_551_s27_q, less_550_s27_q, less_549_s27_q, less_548_s27_q, less_547_s27_q};
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
  assign patches_left_waddr = {select_1768_s27_q, select_1767_s27_q, column_5_s27_q};
  logic patches_left_we;
  assign patches_left_we = s27_en & and_1775_s27_q;
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
      census_left_misses_q <= select_2171;
      sharpness_comparing_product_0_q <= so_s27_q ? select_2243 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s27_q ? select_2245 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2254;
      sharpness_comparing_carry_1_q <= so_s27_q ? select_2257 : sharpness_comparing_carry_1_q;
      patches_valid_0_q <= select_2796;
      patches_valid_1_q <= select_2801;
      patches_right_next_0_q <= select_2804;
      patches_right_next_1_q <= select_2807;
      hidden_for_q <= select_3706;
      too_much_q <= equal_1471_s27_q ? select_3737 : too_much_q;
      seen_q <= select_3859;
      nearer_q <= select_3862;
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
  logic equal_1471_s28_q;
  logic equal_1516_s28_q;
  logic equal_1524_s28_q;
  logic equal_1692_s28_q;
  logic equal_1694_s28_q;
  logic [4:0] select_1719_s28_q;
  logic [4:0] select_1722_s28_q;
  logic and_1732_s28_q;
  logic [4:0] select_1748_s28_q;
  logic and_1752_s28_q;
  logic less_1853_s28_q;
  logic equal_1854_s28_q;
  logic not_1855_s28_q;
  logic equal_1856_s28_q;
  logic not_1882_s28_q;
  logic equal_2215_s28_q;
  logic or_2261_s28_q;
  logic and_2262_s28_q;
  logic or_2267_s28_q;
  logic and_2268_s28_q;
  logic select_2283_s28_q;
  logic [9:0] select_2460_s28_q;
  logic [9:0] select_2463_s28_q;
  logic equal_2665_s28_q;
  logic parity_2997_s28_q;
  logic parity_3126_s28_q;
  logic parity_3188_s28_q;
  logic xor_3216_s28_q;
  logic parity_3228_s28_q;
  logic and_3229_s28_q;
  logic and_3231_s28_q;
  logic equal_3233_s28_q;
  logic or_3376_s28_q;
  logic [5:0] difference_3423_s28_q;
  logic not_3425_s28_q;
  logic not_3435_s28_q;
  logic equal_3473_s28_q;
  logic less_3547_s28_q;
  logic less_3548_s28_q;
  logic equal_3580_s28_q;
  logic or_3672_s28_q;
  logic and_3839_s28_q;
  logic not_3869_s28_q;
  logic or_3879_s28_q;
  logic or_3888_s28_q;
  logic not_3900_s28_q;
  logic [31:0] select_3922_s28_q;
  logic [9:0] select_3924_s28_q;
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
      equal_1471_s28_q <= equal_1471_s27_q;
      equal_1516_s28_q <= equal_1516_s27_q;
      equal_1524_s28_q <= equal_1524_s27_q;
      equal_1692_s28_q <= equal_1692_s27_q;
      equal_1694_s28_q <= equal_1694_s27_q;
      select_1719_s28_q <= or_1718_s27_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1722_s28_q <= select_1722_s27_q;
      and_1732_s28_q <= sample_pair_whole_s27_q & and_1731;
      select_1748_s28_q <= or_1747_s27_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1752_s28_q <= sample_pair_whole_s27_q & and_1751;
      less_1853_s28_q <= less_1853_s27_q;
      equal_1854_s28_q <= equal_1854_s27_q;
      not_1855_s28_q <= not_1855_s27_q;
      equal_1856_s28_q <= equal_1856_s27_q;
      not_1882_s28_q <= not_1882_s27_q;
      equal_2215_s28_q <= equal_2215_s27_q;
      or_2261_s28_q <= equal_2259_s27_q | xor_2260;
      and_2262_s28_q <= five_times[0] & xor_2260;
      or_2267_s28_q <= equal_2259_s27_q | xor_2266;
      and_2268_s28_q <= five_times_2[0] & xor_2266;
      select_2283_s28_q <= select_2283_s27_q;
      select_2460_s28_q <= select_2460_s27_q;
      select_2463_s28_q <= select_2463_s27_q;
      equal_2665_s28_q <= equal_2665_s27_q;
      parity_2997_s28_q <= parity_2997_s27_q;
      parity_3126_s28_q <= parity_3126_s27_q;
      parity_3188_s28_q <= parity_3188;
      xor_3216_s28_q <= parity_3203 ^ parity_3215;
      parity_3228_s28_q <= ^{or_3225, or_3221, and_3217};
      and_3229_s28_q <= or_3221 & or_3225;
      and_3231_s28_q <= and_3217 & (or_3221 | or_3225);
      equal_3233_s28_q <= equal_3233_s27_q;
      or_3376_s28_q <= or_3376;
      difference_3423_s28_q <= difference_3423[5:0];
      not_3425_s28_q <= ~less_3424;
      not_3435_s28_q <= ~($signed(difference_3423) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3473_s28_q <= equal_3473_s27_q;
      less_3547_s28_q <= $signed(15'h10) < $signed(difference_3423);
      less_3548_s28_q <= $signed(difference_3423[14:4]) < $signed(11'h7ff);
      equal_3580_s28_q <= equal_3580_s27_q;
      or_3672_s28_q <= or_3672_s27_q;
      and_3839_s28_q <= and_3839_s27_q;
      not_3869_s28_q <= not_3869_s27_q;
      or_3879_s28_q <= select_3680_s27_q | select_3737;
      or_3888_s28_q <= or_3888;
      not_3900_s28_q <= ~(select_3704 < cfg_hidden_frames_i);
      select_3922_s28_q <= select_3922_s27_q;
      select_3924_s28_q <= select_3924_s27_q;
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
  logic less_1865;
  assign less_1865 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:177
  logic not_1866;
  assign not_1866 = ~less_1865;
  logic [1:0] select_1867;
  assign select_1867 = patches_summed_first_s28_q ? 2'h2 : {less_1865, not_1866};
  logic [12:0] select_1868;
  assign select_1868 = select_1867[0] ? {4'h0, patches_summed_first_s28_q, 3'h0, patches_summed_row_column_s28_q} : {patches_summed_row_column_s28_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1869;
  assign select_1869 = select_1867[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1870;
  assign select_1870 = select_1867[1] ? {select_1868[12:8], patches_sums_values_0_q[9:8], select_1868[7:0]} : select_1869;
  // hls/stages/census.hpp:385
  logic select_2263;
  assign select_2263 = or_2261_s28_q ? and_2262_s28_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2264;
  assign select_2264 = equal_2215_s28_q ? select_2263 : sharpness_comparing_less_detail_0_q;
  logic select_2265;
  assign select_2265 = so_s28_q ? select_2264 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_2269;
  assign select_2269 = or_2267_s28_q ? and_2268_s28_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2270;
  assign select_2270 = equal_2215_s28_q ? select_2269 : sharpness_comparing_less_detail_1_q;
  logic select_2271;
  assign select_2271 = so_s28_q ? select_2270 : sharpness_comparing_less_detail_1_q;
  // hls/stages/count_bits.hpp:27
  logic or_3232;
  assign or_3232 = and_3229_s28_q | and_3231_s28_q;
  // hls/stages/patches.hpp:511
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3232, parity_3228_s28_q, xor_3216_s28_q, parity_3188_s28_q, parity_3126_s28_q, parity_2997_s28_q} + (equal_3233_s28_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:176
  logic [9:0] select_3237;
  assign select_3237 = equal_1692_s28_q ? patches_sums_values_0_q : (equal_1694_s28_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3238;
  assign select_3238 = equal_1694_s28_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3240;
  assign select_3240 = equal_1694_s28_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3242;
  assign select_3242 = equal_1694_s28_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3244;
  assign select_3244 = equal_1694_s28_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3246;
  assign select_3246 = equal_1694_s28_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3248;
  assign select_3248 = equal_1694_s28_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3250;
  assign select_3250 = equal_1694_s28_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3252;
  assign select_3252 = equal_1694_s28_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3254;
  assign select_3254 = equal_1694_s28_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3256;
  assign select_3256 = equal_1694_s28_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3258;
  assign select_3258 = equal_1694_s28_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3260;
  assign select_3260 = equal_1694_s28_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3262;
  assign select_3262 = equal_1694_s28_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3264;
  assign select_3264 = equal_1694_s28_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3266;
  assign select_3266 = equal_1694_s28_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3268;
  assign select_3268 = equal_1694_s28_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:565
  logic not_3377;
  assign not_3377 = ~or_3376_s28_q;
  // hls/stages/patches.hpp:546
  logic and_3378;
  assign and_3378 = equal_1856_s28_q & not_3377;
  // hls/stages/patches.hpp:176
  logic and_3381;
  assign and_3381 = equal_1692_s28_q & (less_1853_s28_q ? (not_1855_s28_q & and_3378) : and_3378);
  // hls/stages/patches.hpp:546
  logic and_3384;
  assign and_3384 = equal_1856_s28_q & (patches_second_s28_q & not_3377);
  // hls/stages/patches.hpp:176
  logic and_3387;
  assign and_3387 = equal_1692_s28_q & (less_1853_s28_q ? (not_1855_s28_q & and_3384) : and_3384);
  // hls/stages/patches.hpp:546
  logic and_3427;
  assign and_3427 = equal_1856_s28_q & (not_3377 & not_3425_s28_q);
  // hls/stages/patches.hpp:176
  logic and_3430;
  assign and_3430 = equal_1692_s28_q & (less_1853_s28_q ? (not_1855_s28_q & and_3427) : and_3427);
  // hls/stages/patches.hpp:546
  logic and_3437;
  assign and_3437 = equal_1856_s28_q & (not_3377 & not_3435_s28_q);
  // hls/stages/patches.hpp:176
  logic and_3440;
  assign and_3440 = equal_1692_s28_q & (less_1853_s28_q ? (not_1855_s28_q & and_3437) : and_3437);
  // hls/stages/agreement.hpp:1082
  logic less_3474;
  assign less_3474 = x_s28_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:773
  logic and_3478;
  assign and_3478 = equal_1471_s28_q & (x_s28_q[6] & (not_1882_s28_q & (equal_3473_s28_q & less_3474)));
  // hls/stages/agreement.hpp:1094
  logic and_3483;
  assign and_3483 = x_s28_q[6] & (not_1882_s28_q & (less_3474 & (x_s28_q[2:0] == 3'h1)));
  logic and_3490;
  assign and_3490 = x_s28_q[6] & (not_1882_s28_q & (less_3474 & (x_s28_q[2:0] == 3'h2)));
  logic and_3497;
  assign and_3497 = x_s28_q[6] & (not_1882_s28_q & (less_3474 & (x_s28_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:191
  logic select_3504;
  assign select_3504 = (x_s28_q[5:3] == 3'h2) ? x_s28_q[1] : (x_s28_q[0] & (x_s28_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:194
  logic [4:0] sum_3531;
  assign sum_3531 = {2'h0, x_s28_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3550;
  assign select_3550 = less_3547_s28_q ? 6'h10 : (less_3548_s28_q ? 6'h30 : difference_3423_s28_q);
  // hls/stages/patches.hpp:546
  logic [5:0] select_3552;
  assign select_3552 = equal_1856_s28_q ? (or_3376_s28_q ? 6'h0 : select_3550) : 6'h0;
  logic [5:0] select_3554;
  assign select_3554 = less_1853_s28_q ? (equal_1854_s28_q ? 6'h0 : select_3552) : select_3552;
  // hls/stages/agreement.hpp:773
  logic and_3561;
  assign and_3561 = equal_1471_s28_q & (x_s28_q[6] & (not_1882_s28_q & (equal_2665_s28_q & less_3474)));
  // hls/stages/agreement.hpp:1094
  logic and_3565;
  assign and_3565 = x_s28_q[6] & (not_1882_s28_q & (less_3474 & (x_s28_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:773
  logic and_3876;
  assign and_3876 = equal_1471_s28_q & (equal_3580_s28_q & (cfg_prove_i & or_3672_s28_q));
  // hls/stages/agreement.hpp:1181
  logic not_3878;
  assign not_3878 = ~(or_3672_s28_q | not_3863);
  // hls/stages/agreement.hpp:773
  logic and_3882;
  assign and_3882 = equal_1471_s28_q & (equal_3580_s28_q & (not_3878 & or_3879_s28_q));
  logic and_3895;
  assign and_3895 = equal_3580_s28_q & (not_3878 & (select_2271 | select_2283_s28_q));
  // hls/stages/agreement.hpp:1098
  logic and_3902;
  assign and_3902 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_3900_s28_q);
  // hls/stages/agreement.hpp:773
  logic and_3908;
  assign and_3908 = equal_1471_s28_q & (x_s28_q[6] & (not_1882_s28_q | (4'hc < x_s28_q[5:2])));

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1722_s28_q, select_1719_s28_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s28_en & and_1732_s28_q;
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
  assign patches_right_1_waddr = {select_1722_s28_q, select_1748_s28_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s28_en & and_1752_s28_q;
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
      sharpness_comparing_less_detail_0_q <= select_2265;
      sharpness_comparing_less_detail_1_q <= select_2271;
      patches_sums_values_0_q <= select_3237;
      patches_sums_values_1_q <= equal_1692_s28_q ? patches_sums_values_1_q : select_3238;
      patches_sums_values_2_q <= equal_1692_s28_q ? patches_sums_values_2_q : select_3240;
      patches_sums_values_3_q <= equal_1692_s28_q ? patches_sums_values_3_q : select_3242;
      patches_sums_values_4_q <= equal_1692_s28_q ? patches_sums_values_4_q : select_3244;
      patches_sums_values_5_q <= equal_1692_s28_q ? patches_sums_values_5_q : select_3246;
      patches_sums_values_6_q <= equal_1692_s28_q ? patches_sums_values_6_q : select_3248;
      patches_sums_values_7_q <= equal_1692_s28_q ? patches_sums_values_7_q : select_3250;
      patches_sums_values_8_q <= equal_1692_s28_q ? patches_sums_values_8_q : select_3252;
      patches_sums_values_9_q <= equal_1692_s28_q ? patches_sums_values_9_q : select_3254;
      patches_sums_values_10_q <= equal_1692_s28_q ? patches_sums_values_10_q : select_3256;
      patches_sums_values_11_q <= equal_1692_s28_q ? patches_sums_values_11_q : select_3258;
      patches_sums_values_12_q <= equal_1692_s28_q ? patches_sums_values_12_q : select_3260;
      patches_sums_values_13_q <= equal_1692_s28_q ? patches_sums_values_13_q : select_3262;
      patches_sums_values_14_q <= equal_1692_s28_q ? patches_sums_values_14_q : select_3264;
      patches_sums_values_15_q <= equal_1692_s28_q ? patches_sums_values_15_q : select_3266;
      patches_sums_values_16_q <= equal_1692_s28_q ? patches_sums_values_16_q : select_3268;
      patches_best_differing_q <= select_1870[9:0];
      patches_best_column_q <= select_1870[14:10];
      patches_frame_ended_q <= equal_1471_s28_q & ((x_s28_q == 7'h70) & (~equal_3580_s28_q));
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
  logic equal_1471_s29_q;
  logic equal_1516_s29_q;
  logic equal_1524_s29_q;
  logic [9:0] select_2460_s29_q;
  logic [9:0] select_2463_s29_q;
  logic and_3381_s29_q;
  logic and_3387_s29_q;
  logic and_3430_s29_q;
  logic and_3440_s29_q;
  logic and_3478_s29_q;
  logic and_3484_s29_q;
  logic and_3491_s29_q;
  logic and_3498_s29_q;
  logic and_3507_s29_q;
  logic and_3534_s29_q;
  logic [5:0] select_3555_s29_q;
  logic and_3561_s29_q;
  logic and_3566_s29_q;
  logic equal_3580_s29_q;
  logic and_3839_s29_q;
  logic or_3864_s29_q;
  logic and_3865_s29_q;
  logic not_3869_s29_q;
  logic and_3876_s29_q;
  logic and_3882_s29_q;
  logic and_3891_s29_q;
  logic and_3895_s29_q;
  logic and_3904_s29_q;
  logic and_3908_s29_q;
  logic [5:0] select_3910_s29_q;
  logic [31:0] select_3922_s29_q;
  logic [9:0] select_3924_s29_q;
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
      equal_1471_s29_q <= equal_1471_s28_q;
      equal_1516_s29_q <= equal_1516_s28_q;
      equal_1524_s29_q <= equal_1524_s28_q;
      select_2460_s29_q <= select_2460_s28_q;
      select_2463_s29_q <= select_2463_s28_q;
      and_3381_s29_q <= and_3381;
      and_3387_s29_q <= and_3387;
      and_3430_s29_q <= and_3430;
      and_3440_s29_q <= and_3440;
      and_3478_s29_q <= and_3478;
      and_3484_s29_q <= equal_1471_s28_q & and_3483;
      and_3491_s29_q <= equal_1471_s28_q & and_3490;
      and_3498_s29_q <= equal_1471_s28_q & and_3497;
      and_3507_s29_q <= x_s28_q[6] & (not_1882_s28_q & (less_3474 & select_3504));
      and_3534_s29_q <= not_1882_s28_q & (less_3474 & (sum_3531[4:2] == 3'h0));
      select_3555_s29_q <= equal_1692_s28_q ? select_3554 : 6'h0;
      and_3561_s29_q <= and_3561;
      and_3566_s29_q <= equal_1471_s28_q & and_3565;
      equal_3580_s29_q <= equal_3580_s28_q;
      and_3839_s29_q <= and_3839_s28_q;
      or_3864_s29_q <= not_3863 | seen_q;
      and_3865_s29_q <= cfg_prove_i & nearer_q;
      not_3869_s29_q <= not_3869_s28_q;
      and_3876_s29_q <= and_3876;
      and_3882_s29_q <= and_3882;
      and_3891_s29_q <= equal_3580_s28_q & (not_3878 & (select_2265 | or_3888_s28_q));
      and_3895_s29_q <= and_3895;
      and_3904_s29_q <= equal_1471_s28_q & (equal_3580_s28_q & and_3902);
      and_3908_s29_q <= and_3908;
      select_3910_s29_q <= equal_1471_s28_q ? (x_s28_q[6] ? x_s28_q[5:0] : 6'h0) : 6'h0;
      select_3922_s29_q <= select_3922_s28_q;
      select_3924_s29_q <= select_3924_s28_q;
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
  logic not_3382;
  assign not_3382 = ~patches_lower_s29_q;
  logic not_3388;
  assign not_3388 = ~and_3387_s29_q;
  // hls/stages/patches.hpp:180
  logic and_3390;
  assign and_3390 = and_3381_s29_q & (not_3382 & not_3388);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3392;
  assign sum_3392 = {7'h0, and_3390} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:639
  logic and_3431;
  assign and_3431 = and_3430_s29_q & and_3390;
  logic [7:0] sum_3432;
  assign sum_3432 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3431};
  // hls/stages/patches.hpp:640
  logic and_3441;
  assign and_3441 = and_3440_s29_q & and_3390;
  logic [7:0] sum_3442;
  assign sum_3442 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3441};
  // hls/stages/patches.hpp:180
  logic and_3444;
  assign and_3444 = and_3381_s29_q & (and_3387_s29_q & not_3382);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3446;
  assign sum_3446 = {7'h0, and_3444} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:639
  logic and_3448;
  assign and_3448 = and_3430_s29_q & and_3444;
  logic [7:0] sum_3449;
  assign sum_3449 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3448};
  // hls/stages/patches.hpp:640
  logic and_3451;
  assign and_3451 = and_3440_s29_q & and_3444;
  logic [7:0] sum_3452;
  assign sum_3452 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3451};
  // hls/stages/patches.hpp:180
  logic and_3454;
  assign and_3454 = and_3381_s29_q & (patches_lower_s29_q & not_3388);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3456;
  assign sum_3456 = {7'h0, and_3454} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:639
  logic and_3458;
  assign and_3458 = and_3430_s29_q & and_3454;
  logic [7:0] sum_3459;
  assign sum_3459 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3458};
  // hls/stages/patches.hpp:640
  logic and_3461;
  assign and_3461 = and_3440_s29_q & and_3454;
  logic [7:0] sum_3462;
  assign sum_3462 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3461};
  // hls/stages/patches.hpp:180
  logic and_3464;
  assign and_3464 = and_3381_s29_q & (patches_lower_s29_q & and_3387_s29_q);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3466;
  assign sum_3466 = {7'h0, and_3464} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:639
  logic and_3468;
  assign and_3468 = and_3430_s29_q & and_3464;
  logic [7:0] sum_3469;
  assign sum_3469 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3468};
  // hls/stages/patches.hpp:640
  logic and_3471;
  assign and_3471 = and_3440_s29_q & and_3464;
  logic [7:0] sum_3472;
  assign sum_3472 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3471};
  // hls/stages/patches.hpp:607
  logic [7:0] or_3486;
  assign or_3486 = (and_3478_s29_q ? patches_quarters_0_places_q : 8'h0) | (and_3484_s29_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3500;
  assign or_3500 = (or_3486 | (and_3491_s29_q ? patches_quarters_2_places_q : 8'h0)) | (and_3498_s29_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:773
  logic and_3508;
  assign and_3508 = equal_1471_s29_q & and_3507_s29_q;
  // hls/stages/patches.hpp:608
  logic [7:0] select_3510;
  assign select_3510 = and_3478_s29_q ? (and_3508 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3512;
  assign select_3512 = and_3484_s29_q ? (and_3508 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3515;
  assign select_3515 = and_3491_s29_q ? (and_3508 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3518;
  assign select_3518 = and_3498_s29_q ? (and_3508 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:609
  logic [7:0] select_3521;
  assign select_3521 = and_3478_s29_q ? (and_3508 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3523;
  assign select_3523 = and_3484_s29_q ? (and_3508 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3526;
  assign select_3526 = and_3491_s29_q ? (and_3508 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3529;
  assign select_3529 = and_3498_s29_q ? (and_3508 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:773
  logic and_3536;
  assign and_3536 = equal_1471_s29_q & (x_s29_q & and_3534_s29_q);
  // hls/stages/patches.hpp:602
  logic [7:0] sum_3538;
  assign sum_3538 = patches_word_places_q + (and_3484_s29_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:604
  logic [7:0] select_3542;
  assign select_3542 = and_3536 ? (patches_word_up_q + (and_3484_s29_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3544;
  assign sum_3544 = patches_word_down_q + (and_3484_s29_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:642
  logic [5:0] select_3556;
  assign select_3556 = and_3381_s29_q ? select_3555_s29_q : 6'h0;
  logic [11:0] sum_3557;
  assign sum_3557 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3556[5]}}, select_3556};
  // hls/stages/patches.hpp:629
  logic [7:0] select_3568;
  assign select_3568 = and_3561_s29_q ? (and_3566_s29_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:631
  logic or_3572;
  assign or_3572 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:632
  logic or_3575;
  assign or_3575 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:633
  logic [8:0] sum_3576;
  assign sum_3576 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:628
  logic select_3578;
  assign select_3578 = and_3561_s29_q ? (and_3566_s29_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:180
  logic and_3585;
  assign and_3585 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:628
  logic [2:0] select_3586;
  assign select_3586 = and_3561_s29_q ? {and_3585, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3588;
  assign select_3588 = and_3561_s29_q ? (and_3566_s29_q ? {and_3585, patches_found_q[2:1]} : select_3586) : patches_found_q;
  // hls/stages/patches.hpp:627
  logic or_3591;
  assign or_3591 = patches_partly_q | (patches_doubted_q & (~and_3566_s29_q));
  // hls/stages/patches.hpp:628
  logic select_3593;
  assign select_3593 = and_3566_s29_q ? or_3591 : (and_3561_s29_q ? or_3591 : patches_doubted_q);
  // hls/stages/patches.hpp:626
  logic select_3595;
  assign select_3595 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:617
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:618
  logic select_3605;
  assign select_3605 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:619
  logic and_3611;
  assign and_3611 = patches_frame_ended_s29_q & (~patches_age_q[9]);
  logic [9:0] sum_3612;
  assign sum_3612 = patches_age_q + {9'h0, and_3611};
  logic [9:0] select_3615;
  assign select_3615 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3612)) : sum_3612;
  // hls/stages/agreement.hpp:1179
  logic or_3870;
  assign or_3870 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_3869_s29_q;
  // hls/stages/agreement.hpp:773
  logic and_3885;
  assign and_3885 = equal_3580_s29_q & (cfg_prove_i & (registration_moved_s29_q | patches_moved_q));
  // hls/stages/agreement.hpp:1092
  logic [31:0] select_3923;
  assign select_3923 = equal_1524_s29_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3922_s29_q;
  // hls/stages/agreement.hpp:1094
  logic [31:0] select_3925;
  assign select_3925 = equal_1516_s29_q ? select_3923 : {2'h0, select_3924_s29_q, select_2463_s29_q, select_2460_s29_q};

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
      patches_quarters_0_places_q <= sum_3392;
      patches_quarters_0_up_q <= sum_3432;
      patches_quarters_0_down_q <= sum_3442;
      patches_quarters_1_places_q <= sum_3446;
      patches_quarters_1_up_q <= sum_3449;
      patches_quarters_1_down_q <= sum_3452;
      patches_quarters_2_places_q <= sum_3456;
      patches_quarters_2_up_q <= sum_3459;
      patches_quarters_2_down_q <= sum_3462;
      patches_quarters_3_places_q <= sum_3466;
      patches_quarters_3_up_q <= sum_3469;
      patches_quarters_3_down_q <= sum_3472;
      patches_word_places_q <= or_3500;
      patches_word_up_q <= ((select_3510 | select_3512) | select_3515) | select_3518;
      patches_word_down_q <= ((select_3521 | select_3523) | select_3526) | select_3529;
      patches_sum_places_q <= and_3536 ? sum_3538 : patches_sum_places_q;
      patches_sum_up_q <= select_3542;
      patches_sum_down_q <= and_3536 ? sum_3544 : patches_sum_down_q;
      patches_across_q <= sum_3557;
      patches_places_q <= select_3568;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3572;
      patches_partly_q <= or_3575;
      patches_clear_limit_q <= sum_3576[8:2];
      patches_complete_q <= select_3578;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3588;
      patches_doubted_q <= and_3561_s29_q ? select_3593 : patches_doubted_q;
      patches_doubted_before_q <= select_3595;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3605;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3615;
    end
  end

  logic [7:0] pixel_0_s30_q;
  logic [7:0] pixel_1_s30_q;
  logic saturated_s30_q;
  logic mask_s30_q;
  logic marks_first_s30_q;
  logic marks_last_s30_q;
  logic and_3839_s30_q;
  logic or_3864_s30_q;
  logic and_3865_s30_q;
  logic and_3873_s30_q;
  logic and_3876_s30_q;
  logic and_3882_s30_q;
  logic and_3886_s30_q;
  logic and_3892_s30_q;
  logic and_3896_s30_q;
  logic and_3904_s30_q;
  logic and_3908_s30_q;
  logic [5:0] select_3910_s30_q;
  logic [31:0] select_3927_s30_q;
  always_ff @(posedge clk_i) begin
    if (s29_en) begin
      pixel_0_s30_q <= pixel_0_s29_q;
      pixel_1_s30_q <= pixel_1_s29_q;
      saturated_s30_q <= saturated_s29_q;
      mask_s30_q <= mask_s29_q;
      marks_first_s30_q <= marks_first_s29_q;
      marks_last_s30_q <= marks_last_s29_q;
      and_3839_s30_q <= and_3839_s29_q;
      or_3864_s30_q <= or_3864_s29_q;
      and_3865_s30_q <= and_3865_s29_q;
      and_3873_s30_q <= equal_1471_s29_q & (equal_3580_s29_q & (cfg_prove_i & or_3870));
      and_3876_s30_q <= and_3876_s29_q;
      and_3882_s30_q <= and_3882_s29_q;
      and_3886_s30_q <= equal_1471_s29_q & and_3885;
      and_3892_s30_q <= equal_1471_s29_q & and_3891_s29_q;
      and_3896_s30_q <= equal_1471_s29_q & and_3895_s29_q;
      and_3904_s30_q <= and_3904_s29_q;
      and_3908_s30_q <= and_3908_s29_q;
      select_3910_s30_q <= select_3910_s29_q;
      select_3927_s30_q <= equal_1471_s29_q ? (x_s29_q ? select_3925 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s30_q;
  assign pixel_1_o = pixel_1_s30_q;
  assign saturated_o = saturated_s30_q;
  assign mask_o = mask_s30_q;
  assign marks_first_o = marks_first_s30_q;
  assign marks_last_o = marks_last_s30_q;
  assign marks_seen_o = or_3864_s30_q;
  assign marks_nearer_o = and_3865_s30_q;
  assign verdict_valid_o = and_3839_s30_q;
  assign verdict_unproven_yet_o = and_3873_s30_q;
  assign verdict_untextured_o = and_3876_s30_q;
  assign verdict_disagree_o = and_3882_s30_q;
  assign verdict_moved_o = and_3886_s30_q;
  assign verdict_unsharp_left_o = and_3892_s30_q;
  assign verdict_unsharp_right_o = and_3896_s30_q;
  assign verdict_hidden_o = and_3904_s30_q;
  assign frame_valid_o = and_3908_s30_q;
  assign frame_index_o = select_3910_s30_q;
  assign frame_word_o = select_3927_s30_q;
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
  assign unused_bits = ^{over[13:0], sum_3576[1:0], sum_3531[1:0], product_3422[4:0], sum_2516[0], detail_4[1:0], detail_3[1:0], sum_2165[4:0], sum_1673[1:0], sum_1672[1:0], sum_1668[0], sum_1619[0], sum_1615[0], sum_626[4:0], cfg_width_i[3:0]};

endmodule
