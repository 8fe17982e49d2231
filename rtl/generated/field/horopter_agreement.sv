// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1894 bits, pipeline 618 bits, memories 31188 bits.
module horopter_agreement (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic present_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [8:0] cfg_width_i,
  input  logic [8:0] cfg_height_i,
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {2'h0, cfg_width_i[8:3]} + 8'hff;
  logic [5:0] sum_1960;
  assign sum_1960 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_2323;
  assign difference_2323 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2558;
  assign less_2558 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2559;
  assign sum_2559 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_2560;
  assign select_2560 = less_2558 ? {sum_2559, cfg_height_i[5:3]} : 8'h0;
  logic not_2595;
  assign not_2595 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic left_first_q;
  logic right_q;
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [2:0] raster_at_x_q;
  logic [2:0] raster_at_y_q;
  logic [5:0] raster_at_column_q;
  logic [5:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [8:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [7:0] averager_place_q;
  logic averager_running_mask_q;
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
  logic [5:0] last_q;
  logic [5:0] least_q;
  logic [6:0] whole_q;
  logic [6:0] drawn_q;
  logic [6:0] age_q;
  logic [2:0] slot_q;
  logic ends_cell_q;
  logic ends_q;
  logic final_row_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_328;
  assign select_328 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_330;
  assign select_330 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_333;
  assign select_333 = ({select_330, select_328} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_334;
  assign select_334 = select_328[0] ? averager_place_q : select_333;
  // hls/stages/census.hpp:41
  logic or_335;
  assign or_335 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:394
  logic and_341;
  assign and_341 = (~((~or_335) | (~select_328[0]))) & (select_334 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_346;
  assign select_346 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:394
  logic whole;
  assign whole = select_328[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:255
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_330 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_363;
  assign equal_363 = select_328 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_364;
  assign equal_364 = select_346 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_365;
  assign and_365 = equal_364 & and_341;
  // hls/stages/agreement.hpp:255
  logic and_367;
  assign and_367 = sample_pair_whole_q & (equal_363 & and_365);
  // hls/stages/agreement.hpp:181
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:598
  logic equal_387;
  assign equal_387 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:569
  logic or_388;
  assign or_388 = so | equal_387;
  // hls/stages/agreement.hpp:719
  logic not_389;
  assign not_389 = ~or_388;
  // hls/stages/agreement.hpp:589
  logic equal_390;
  assign equal_390 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:590
  logic equal_392;
  assign equal_392 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:567
  logic [7:0] sum_393;
  assign sum_393 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:569
  logic [7:0] select_394;
  assign select_394 = run_shift_q[5] ? x_q : sum_393;
  logic less_395;
  assign less_395 = {2'h0, last_q} < select_394;
  // hls/stages/agreement.hpp:209
  logic not_396;
  assign not_396 = ~less_395;
  // hls/stages/agreement.hpp:137
  logic and_397;
  assign and_397 = equal_392 & not_396;
  logic and_399;
  assign and_399 = not_389 & ((~equal_390) & and_397);
  // hls/stages/census.hpp:41
  logic [5:0] select_426;
  assign select_426 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:255
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_426 : 6'h0;
  // hls/stages/agreement.hpp:137
  logic select_483;
  assign select_483 = equal_390 ? not_396 : and_397;
  // hls/stages/agreement.hpp:788
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:785
  logic [6:0] sum_503;
  assign sum_503 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:137
  logic and_508;
  assign and_508 = equal_390 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_503} < select_394))));
  logic select_509;
  assign select_509 = or_388 ? not_396 : and_508;
  // hls/stages/agreement.hpp:793
  logic equal_512;
  assign equal_512 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:797
  logic or_514;
  assign or_514 = equal_512 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:809
  logic [5:0] right;
  assign right = sum_393[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:175
  logic and_1509;
  assign and_1509 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:255
  logic [2:0] select_1610;
  assign select_1610 = sample_pair_whole_q ? (sample_last_q ? (select_346 + 3'h1) : select_346) : raster_at_y_q;
  logic [5:0] select_1612;
  assign select_1612 = sample_pair_whole_q ? (select_330 + {5'h0, equal_363}) : raster_at_column_q;
  logic [5:0] select_1615;
  assign select_1615 = sample_pair_whole_q ? (sample_last_q ? (select_426 + {5'h0, equal_364}) : select_426) : raster_at_row_q;
  logic select_1619;
  assign select_1619 = sample_pair_whole_q ? (sample_last_q ? (or_335 & (~raster_final_row_q)) : or_335) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_1621;
  assign select_1621 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:255
  logic select_1625;
  assign select_1625 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:435
  logic equal_1866;
  assign equal_1866 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:440
  logic and_1867;
  assign and_1867 = and_367 & equal_1866;
  // hls/stages/agreement.hpp:498
  logic select_1870;
  assign select_1870 = (and_1867 | (~ends_cell_q)) ? and_1867 : ends_q;
  // hls/stages/agreement.hpp:504
  logic [2:0] now;
  assign now = select_1870 ? (and_1867 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:509
  logic [5:0] select_1874;
  assign select_1874 = select_1870 ? (and_1867 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_1877;
  assign select_1877 = select_1870 ? (following_last_shift_q & (~and_1867)) : run_last_shift_q;
  // hls/stages/agreement.hpp:582
  logic and_1880;
  assign and_1880 = run_last_shift_q & equal_390;
  // hls/stages/agreement.hpp:591
  logic select_1882;
  assign select_1882 = equal_390 ? (~run_last_shift_q) : equal_392;
  // hls/stages/agreement.hpp:595
  logic equal_1883;
  assign equal_1883 = run_phase_q == 3'h1;
  logic not_1886;
  assign not_1886 = ~select_1882;
  // hls/stages/agreement.hpp:598
  logic equal_1888;
  assign equal_1888 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:582
  logic and_1889;
  assign and_1889 = final_row_q & so;
  // hls/stages/agreement.hpp:595
  logic [1:0] select_1890;
  assign select_1890 = equal_1888 ? 2'h1 : {2{and_1889}};
  logic [2:0] select_1892;
  assign select_1892 = (and_1880 | (select_1882 | equal_1883)) ? (equal_1883 ? 3'h2 : {not_1886, {2{select_1882}}}) : (equal_387 ? 3'h6 : {select_1890[0], select_1890});
  // hls/stages/agreement.hpp:582
  logic and_1895;
  assign and_1895 = select_1882 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:605
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1898;
  assign select_1898 = (plan_shift_q[5] & select_1882) ? value : 7'h0;
  logic [1:0] or_1899;
  assign or_1899 = {2{so}} | select_1898[5:4];
  // hls/stages/agreement.hpp:608
  logic [7:0] select_1900;
  assign select_1900 = select_1882 ? plan_columns_q : 8'h0;
  logic [6:0] or_1903;
  assign or_1903 = select_1900[6:0] | ((equal_1883 | equal_1888) ? whole_q : 7'h0);
  logic [1:0] or_1904;
  assign or_1904 = {2{and_1880}} | or_1903[3:2];
  // hls/stages/agreement.hpp:609
  logic [6:0] or_1906;
  assign or_1906 = {or_1903[6:4], or_1904, or_1903[1:0]} | (equal_387 ? drawn_q : 7'h0);
  logic [4:0] or_1907;
  assign or_1907 = {5{so}} | {or_1906[6], or_1906[3:0]};
  // hls/stages/agreement.hpp:615
  logic not_1911;
  assign not_1911 = ~run_shift_q[5];
  logic [6:0] difference_1913;
  assign difference_1913 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_1914;
  assign select_1914 = equal_390 ? ({{7{not_1911}}, 1'b1} + run_span_q) : {difference_1913[6], difference_1913};
  // hls/stages/agreement.hpp:498
  logic [6:0] select_1918;
  assign select_1918 = and_1867 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:501
  logic [7:0] select_1920;
  assign select_1920 = select_1870 ? {select_1918[6], select_1918} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_1923;
  assign select_1923 = select_1870 ? (and_1867 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:495
  logic [5:0] select_1931;
  assign select_1931 = and_367 ? (equal_1866 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_1934;
  assign select_1934 = and_367 ? (equal_1866 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_1937;
  assign select_1937 = and_367 ? (equal_1866 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:506
  logic select_1951;
  assign select_1951 = (ends_cell_q | select_1870) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_390 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:501
  logic and_1955;
  assign and_1955 = (~select_1870) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:451
  logic [6:0] sum_1956;
  assign sum_1956 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:436
  logic select_1958;
  assign select_1958 = equal_1866 ? ({sum_1956[6], cfg_height_i[8:3]} == {1'b0, sum_1956[5:0]}) : final_row_q;

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_399;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1299; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (or_388 ? not_396 : select_483);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1300; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_390 ? sum_393[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_389 & select_483);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 46, DISTANCE 12, hls/stages/agreement.hpp:1301; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 46'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_388 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_509;
  logic [45:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_first_q <= 1'b0;
      right_q <= 1'b0;
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 3'h0;
      raster_at_y_q <= 3'h0;
      raster_at_column_q <= 6'h0;
      raster_at_row_q <= 6'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 8'h0;
      averager_running_mask_q <= 1'b0;
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
      last_q <= 6'h0;
      least_q <= 6'h0;
      whole_q <= 7'h0;
      drawn_q <= 7'h0;
      age_q <= 7'h0;
      slot_q <= 3'h0;
      ends_cell_q <= 1'b1;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
    end else if (s0_en) begin
      left_first_q <= and_1509 ? left_first_q : marks_first_i;
      right_q <= (~and_1509) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1509;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_328 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1610;
      raster_at_column_q <= select_1612;
      raster_at_row_q <= select_1615;
      raster_at_live_q <= select_1619;
      raster_rows_left_q <= sample_pair_whole_q ? select_1621 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1625;
      averager_place_q <= sample_pair_whole_q ? select_334 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= now;
      run_shift_q <= select_1874;
      run_last_shift_q <= select_1877;
      run_span_q <= select_1870 ? (and_1867 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_1892;
      following_shift_q <= select_1882 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_1895;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1898[6], or_1899, select_1898[3:0]};
      following_columns_q <= {select_1900[7], or_1907[4], or_1906[5:4], or_1907[3:0]};
      plan_shift_q <= equal_390 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_1914;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_1920;
      columns_left_q <= select_1923;
      last_q <= and_367 ? (equal_1866 ? column : last_q) : last_q;
      least_q <= select_1931;
      whole_q <= select_1934;
      drawn_q <= select_1937;
      age_q <= select_1870 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_1870 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_1951;
      ends_q <= and_1955;
      final_row_q <= and_367 ? select_1958 : final_row_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [5:0] last_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic select_328_s1_q;
  logic [7:0] select_334_s1_q;
  logic and_341_s1_q;
  logic equal_347_s1_q;
  logic whole_s1_q;
  logic [5:0] column_s1_q;
  logic and_365_s1_q;
  logic and_367_s1_q;
  logic equal_370_s1_q;
  logic so_s1_q;
  logic equal_387_s1_q;
  logic or_388_s1_q;
  logic equal_390_s1_q;
  logic less_395_s1_q;
  logic not_396_s1_q;
  logic and_399_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_509_s1_q;
  logic select_516_s1_q;
  logic and_1318_s1_q;
  logic [5:0] right_s1_q;
  logic select_1327_s1_q;
  logic equal_1336_s1_q;
  logic equal_1866_s1_q;
  logic and_1867_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      last_s1_q <= last_q;
      age_s1_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s1_q <= slot_q;
      ends_cell_s1_q <= ends_cell_q;
      select_328_s1_q <= select_328[0];
      select_334_s1_q <= select_334;
      and_341_s1_q <= and_341;
      equal_347_s1_q <= select_346 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_365_s1_q <= and_365;
      and_367_s1_q <= and_367;
      equal_370_s1_q <= select_328 == 3'h1;
      so_s1_q <= so;
      equal_387_s1_q <= equal_387;
      or_388_s1_q <= or_388;
      equal_390_s1_q <= equal_390;
      less_395_s1_q <= less_395;
      not_396_s1_q <= not_396;
      and_399_s1_q <= and_399;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_509_s1_q <= select_509;
      select_516_s1_q <= or_514 ? equal_512 : (~age_q[3]);
      and_1318_s1_q <= not_389 & and_508;
      right_s1_q <= right;
      select_1327_s1_q <= or_514 ? equal_512 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1336_s1_q <= run_phase_q == 3'h7;
      equal_1866_s1_q <= equal_1866;
      and_1867_s1_q <= and_1867;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
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
  // hls/stages/census.hpp:119
  logic and_342;
  assign and_342 = sample_pair_whole_s1_q & and_341_s1_q;
  // hls/stages/agreement.hpp:641
  logic not_487;
  assign not_487 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:644
  logic and_488;
  assign and_488 = left_rdata_q[12] & not_487;
  logic and_489;
  assign and_489 = left_rdata_q[28] & not_487;
  logic and_490;
  assign and_490 = left_rdata_q[44] & not_487;
  logic and_491;
  assign and_491 = left_rdata_q[60] & not_487;
  // hls/stages/agreement.hpp:645
  logic and_495;
  assign and_495 = right_codes_rdata_q[12] & not_487;
  logic and_496;
  assign and_496 = right_codes_rdata_q[25] & not_487;
  logic and_497;
  assign and_497 = right_codes_rdata_q[38] & not_487;
  logic and_498;
  assign and_498 = right_codes_rdata_q[51] & not_487;
  logic and_499;
  assign and_499 = right_codes_rdata_q[64] & not_487;
  logic and_500;
  assign and_500 = right_codes_rdata_q[77] & not_487;
  // hls/stages/agreement.hpp:205
  logic and_522;
  assign and_522 = left_rdata_q[44] & not_396_s1_q;
  logic and_523;
  assign and_523 = right_codes_rdata_q[38] & not_396_s1_q;
  logic [11:0] select_524;
  assign select_524 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_525;
  assign select_525 = less_395_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_529;
  assign select_529 = and_522 ? (and_523 ? (~(select_524 ^ select_525)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_535;
  assign parity_535 = ^select_529[5:3];
  logic parity_538;
  assign parity_538 = ^select_529[8:6];
  logic parity_541;
  assign parity_541 = ^select_529[11:3];
  // hls/stages/agreement.hpp:205
  logic and_545;
  assign and_545 = left_rdata_q[60] & not_396_s1_q;
  logic and_546;
  assign and_546 = right_codes_rdata_q[51] & not_396_s1_q;
  logic [11:0] select_547;
  assign select_547 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_548;
  assign select_548 = less_395_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_552;
  assign select_552 = and_545 ? (and_546 ? (~(select_547 ^ select_548)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_555;
  assign parity_555 = ^select_552[8:6];
  logic parity_558;
  assign parity_558 = ^select_552[11:9];
  // hls/stages/agreement.hpp:205
  logic and_562;
  assign and_562 = left_rdata_q[76] & not_396_s1_q;
  logic and_563;
  assign and_563 = right_codes_rdata_q[64] & not_396_s1_q;
  logic [11:0] select_564;
  assign select_564 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_565;
  assign select_565 = less_395_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_569;
  assign select_569 = and_562 ? (and_563 ? (~(select_564 ^ select_565)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_575;
  assign parity_575 = ^select_569[2:0];
  logic parity_578;
  assign parity_578 = ^select_569[5:3];
  logic parity_581;
  assign parity_581 = ^select_569[8:0];
  logic parity_587;
  assign parity_587 = ^select_569[11:9];
  logic parity_590;
  assign parity_590 = ^select_552[2:0];
  logic parity_593;
  assign parity_593 = ^{select_569[11:9], select_552[5:0]};
  logic parity_596;
  assign parity_596 = ^{select_569, select_552, select_529[2:0]};
  logic xor_597;
  assign xor_597 = parity_541 ^ parity_596;
  // hls/stages/agreement.hpp:671
  logic or_601;
  assign or_601 = (select_529[1:0] == 2'h3) | (select_529[2] & (select_529[0] | select_529[1]));
  // hls/stages/agreement.hpp:673
  logic or_605;
  assign or_605 = (select_552[7:6] == 2'h3) | (select_552[8] & (select_552[6] | select_552[7]));
  logic or_609;
  assign or_609 = (select_552[10:9] == 2'h3) | (select_552[11] & (select_552[9] | select_552[10]));
  // hls/stages/agreement.hpp:671
  logic or_617;
  assign or_617 = (select_569[7:6] == 2'h3) | (select_569[8] & (~(select_569[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_621;
  assign or_621 = (select_569[1:0] == 2'h3) | (select_569[2] & (select_569[0] | select_569[1]));
  logic or_625;
  assign or_625 = (select_569[4:3] == 2'h3) | (select_569[5] & (select_569[3] | select_569[4]));
  // hls/stages/agreement.hpp:672
  logic parity_628;
  assign parity_628 = ^{or_625, or_621, or_617};
  // hls/stages/agreement.hpp:671
  logic or_632;
  assign or_632 = (select_552[4:3] == 2'h3) | (select_552[5] & (select_552[3] | select_552[4]));
  // hls/stages/agreement.hpp:673
  logic or_636;
  assign or_636 = (select_569[10:9] == 2'h3) | (select_569[11] & (select_569[9] | select_569[10]));
  logic or_640;
  assign or_640 = (select_552[1:0] == 2'h3) | (select_552[2] & (select_552[0] | select_552[1]));
  // hls/stages/agreement.hpp:672
  logic parity_643;
  assign parity_643 = ^{or_640, or_636, or_632};
  logic parity_646;
  assign parity_646 = ^{or_640, or_636, or_632, or_625, or_621, or_617, or_609, or_605, or_601};
  // hls/stages/agreement.hpp:673
  logic and_647;
  assign and_647 = parity_541 & parity_596;
  logic or_651;
  assign or_651 = (parity_535 & parity_538) | ((^select_529[11:9]) & (parity_535 | parity_538));
  logic and_654;
  assign and_654 = (^{select_552[11:6], select_529[2:0]}) & (parity_581 | parity_593);
  logic or_655;
  assign or_655 = (parity_581 & parity_593) | and_654;
  // hls/stages/agreement.hpp:671
  logic or_662;
  assign or_662 = (select_529[10:9] == 2'h3) | (select_529[11] & (select_529[9] | select_529[10]));
  // hls/stages/agreement.hpp:673
  logic or_666;
  assign or_666 = (select_529[4:3] == 2'h3) | (select_529[5] & (select_529[3] | select_529[4]));
  logic or_670;
  assign or_670 = (select_529[7:6] == 2'h3) | (select_529[8] & (select_529[6] | select_529[7]));
  // hls/stages/agreement.hpp:672
  logic parity_673;
  assign parity_673 = ^{or_670, or_666, or_662};
  // hls/stages/agreement.hpp:673
  logic or_677;
  assign or_677 = (parity_555 & parity_558) | ((^select_529[2:0]) & (parity_555 | parity_558));
  logic or_681;
  assign or_681 = (parity_575 & parity_578) | ((^select_569[8:6]) & (parity_575 | parity_578));
  logic or_685;
  assign or_685 = (parity_587 & parity_590) | ((^select_552[5:3]) & (parity_587 | parity_590));
  // hls/stages/agreement.hpp:672
  logic parity_688;
  assign parity_688 = ^{or_685, or_681, or_677};
  logic parity_691;
  assign parity_691 = ^{or_685, or_681, or_677, or_670, or_666, or_662, or_655, or_651, and_647};
  logic xor_692;
  assign xor_692 = parity_646 ^ parity_691;
  // hls/stages/agreement.hpp:673
  logic and_693;
  assign and_693 = parity_646 & parity_691;
  logic or_697;
  assign or_697 = (parity_628 & parity_643) | ((^{or_609, or_605, or_601}) & (parity_628 | parity_643));
  logic or_701;
  assign or_701 = (parity_673 & parity_688) | ((^{or_655, or_651, and_647}) & (parity_673 | parity_688));
  logic or_708;
  assign or_708 = (or_605 & or_609) | (or_601 & (or_605 | or_609));
  logic or_712;
  assign or_712 = (or_621 & or_625) | (or_617 & (or_621 | or_625));
  logic or_716;
  assign or_716 = (or_636 & or_640) | (or_632 & (or_636 | or_640));
  // hls/stages/agreement.hpp:672
  logic parity_719;
  assign parity_719 = ^{or_716, or_712, or_708};
  // hls/stages/agreement.hpp:673
  logic or_723;
  assign or_723 = (or_651 & or_655) | (and_647 & (or_651 | or_655));
  logic or_727;
  assign or_727 = (or_666 & or_670) | (or_662 & (or_666 | or_670));
  logic or_731;
  assign or_731 = (or_681 & or_685) | (or_677 & (or_681 | or_685));
  // hls/stages/agreement.hpp:672
  logic parity_734;
  assign parity_734 = ^{or_731, or_727, or_723};
  logic parity_737;
  assign parity_737 = ^{or_731, or_727, or_723, or_716, or_712, or_708, or_701, or_697, and_693};
  // hls/stages/agreement.hpp:673
  logic or_741;
  assign or_741 = (parity_719 & parity_734) | ((^{or_701, or_697, and_693}) & (parity_719 | parity_734));
  logic or_745;
  assign or_745 = (or_697 & or_701) | (and_693 & (or_697 | or_701));
  logic or_749;
  assign or_749 = (or_712 & or_716) | (or_708 & (or_712 | or_716));
  logic or_753;
  assign or_753 = (or_727 & or_731) | (or_723 & (or_727 | or_731));
  // hls/stages/agreement.hpp:672
  logic parity_758;
  assign parity_758 = ^{or_753, or_749, or_745, or_741};
  // hls/stages/agreement.hpp:673
  logic or_762;
  assign or_762 = (or_749 & or_753) | (or_745 & (or_749 | or_753));
  logic and_763;
  assign and_763 = or_741 & (^{or_753, or_749, or_745});
  // hls/stages/agreement.hpp:672
  logic xor_764;
  assign xor_764 = or_762 ^ and_763;
  // hls/stages/agreement.hpp:675
  logic and_765;
  assign and_765 = or_762 & and_763;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_766;
  assign select_766 = equal_390_s1_q ? {and_765, xor_764, parity_758, parity_737, xor_692, xor_597} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_388_s1_q ? 6'h0 : select_766;
  // hls/stages/agreement.hpp:657
  logic [11:0] select_777;
  assign select_777 = (slot_s1_q[0] ? and_563 : and_546) ? (~(select_525 ^ (slot_s1_q[0] ? select_564 : select_547))) : 12'h0;
  logic [11:0] select_778;
  assign select_778 = and_522 ? select_777 : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_784;
  assign parity_784 = ^select_778[5:3];
  logic parity_787;
  assign parity_787 = ^select_778[8:6];
  logic parity_790;
  assign parity_790 = ^select_778[11:3];
  // hls/stages/agreement.hpp:205
  logic and_794;
  assign and_794 = right_codes_rdata_q[77] & not_396_s1_q;
  logic [11:0] select_796;
  assign select_796 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_800;
  assign select_800 = (slot_s1_q[0] ? and_794 : and_563) ? (~(select_548 ^ (slot_s1_q[0] ? select_796 : select_564))) : 12'h0;
  logic [11:0] select_801;
  assign select_801 = and_545 ? select_800 : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_804;
  assign parity_804 = ^select_801[8:6];
  logic parity_807;
  assign parity_807 = ^select_801[11:9];
  // hls/stages/agreement.hpp:733
  logic select_812;
  assign select_812 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_396_s1_q) : and_794;
  logic [11:0] select_814;
  assign select_814 = slot_s1_q[0] ? (less_395_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_796;
  // hls/stages/agreement.hpp:657
  logic [11:0] select_818;
  assign select_818 = and_562 ? (select_812 ? (~(select_565 ^ select_814)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_824;
  assign parity_824 = ^select_818[2:0];
  logic parity_827;
  assign parity_827 = ^select_818[5:3];
  logic parity_830;
  assign parity_830 = ^select_818[8:0];
  logic parity_836;
  assign parity_836 = ^select_818[11:9];
  logic parity_839;
  assign parity_839 = ^select_801[2:0];
  logic parity_842;
  assign parity_842 = ^{select_818[11:9], select_801[5:0]};
  logic parity_845;
  assign parity_845 = ^{select_818, select_801, select_778[2:0]};
  logic xor_846;
  assign xor_846 = parity_790 ^ parity_845;
  // hls/stages/agreement.hpp:671
  logic or_850;
  assign or_850 = (select_778[1:0] == 2'h3) | (select_778[2] & (select_778[0] | select_778[1]));
  // hls/stages/agreement.hpp:673
  logic or_854;
  assign or_854 = (select_801[7:6] == 2'h3) | (select_801[8] & (select_801[6] | select_801[7]));
  logic or_858;
  assign or_858 = (select_801[10:9] == 2'h3) | (select_801[11] & (select_801[9] | select_801[10]));
  // hls/stages/agreement.hpp:671
  logic or_866;
  assign or_866 = (select_818[7:6] == 2'h3) | (select_818[8] & (~(select_818[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_870;
  assign or_870 = (select_818[1:0] == 2'h3) | (select_818[2] & (select_818[0] | select_818[1]));
  logic or_874;
  assign or_874 = (select_818[4:3] == 2'h3) | (select_818[5] & (select_818[3] | select_818[4]));
  // hls/stages/agreement.hpp:672
  logic parity_877;
  assign parity_877 = ^{or_874, or_870, or_866};
  // hls/stages/agreement.hpp:671
  logic or_881;
  assign or_881 = (select_801[4:3] == 2'h3) | (select_801[5] & (select_801[3] | select_801[4]));
  // hls/stages/agreement.hpp:673
  logic or_885;
  assign or_885 = (select_818[10:9] == 2'h3) | (select_818[11] & (select_818[9] | select_818[10]));
  logic or_889;
  assign or_889 = (select_801[1:0] == 2'h3) | (select_801[2] & (select_801[0] | select_801[1]));
  // hls/stages/agreement.hpp:672
  logic parity_892;
  assign parity_892 = ^{or_889, or_885, or_881};
  logic parity_895;
  assign parity_895 = ^{or_889, or_885, or_881, or_874, or_870, or_866, or_858, or_854, or_850};
  // hls/stages/agreement.hpp:673
  logic and_896;
  assign and_896 = parity_790 & parity_845;
  logic or_900;
  assign or_900 = (parity_784 & parity_787) | ((^select_778[11:9]) & (parity_784 | parity_787));
  logic and_903;
  assign and_903 = (^{select_801[11:6], select_778[2:0]}) & (parity_830 | parity_842);
  logic or_904;
  assign or_904 = (parity_830 & parity_842) | and_903;
  // hls/stages/agreement.hpp:671
  logic or_911;
  assign or_911 = (select_778[10:9] == 2'h3) | (select_778[11] & (select_778[9] | select_778[10]));
  // hls/stages/agreement.hpp:673
  logic or_915;
  assign or_915 = (select_778[4:3] == 2'h3) | (select_778[5] & (select_778[3] | select_778[4]));
  logic or_919;
  assign or_919 = (select_778[7:6] == 2'h3) | (select_778[8] & (select_778[6] | select_778[7]));
  // hls/stages/agreement.hpp:672
  logic parity_922;
  assign parity_922 = ^{or_919, or_915, or_911};
  // hls/stages/agreement.hpp:673
  logic or_926;
  assign or_926 = (parity_804 & parity_807) | ((^select_778[2:0]) & (parity_804 | parity_807));
  logic or_930;
  assign or_930 = (parity_824 & parity_827) | ((^select_818[8:6]) & (parity_824 | parity_827));
  logic or_934;
  assign or_934 = (parity_836 & parity_839) | ((^select_801[5:3]) & (parity_836 | parity_839));
  // hls/stages/agreement.hpp:672
  logic parity_937;
  assign parity_937 = ^{or_934, or_930, or_926};
  logic parity_940;
  assign parity_940 = ^{or_934, or_930, or_926, or_919, or_915, or_911, or_904, or_900, and_896};
  logic xor_941;
  assign xor_941 = parity_895 ^ parity_940;
  // hls/stages/agreement.hpp:673
  logic and_942;
  assign and_942 = parity_895 & parity_940;
  logic or_946;
  assign or_946 = (parity_877 & parity_892) | ((^{or_858, or_854, or_850}) & (parity_877 | parity_892));
  logic or_950;
  assign or_950 = (parity_922 & parity_937) | ((^{or_904, or_900, and_896}) & (parity_922 | parity_937));
  logic or_957;
  assign or_957 = (or_854 & or_858) | (or_850 & (or_854 | or_858));
  logic or_961;
  assign or_961 = (or_870 & or_874) | (or_866 & (or_870 | or_874));
  logic or_965;
  assign or_965 = (or_885 & or_889) | (or_881 & (or_885 | or_889));
  // hls/stages/agreement.hpp:672
  logic parity_968;
  assign parity_968 = ^{or_965, or_961, or_957};
  // hls/stages/agreement.hpp:673
  logic or_972;
  assign or_972 = (or_900 & or_904) | (and_896 & (or_900 | or_904));
  logic or_976;
  assign or_976 = (or_915 & or_919) | (or_911 & (or_915 | or_919));
  logic or_980;
  assign or_980 = (or_930 & or_934) | (or_926 & (or_930 | or_934));
  // hls/stages/agreement.hpp:672
  logic parity_983;
  assign parity_983 = ^{or_980, or_976, or_972};
  logic parity_986;
  assign parity_986 = ^{or_980, or_976, or_972, or_965, or_961, or_957, or_950, or_946, and_942};
  // hls/stages/agreement.hpp:673
  logic or_990;
  assign or_990 = (parity_968 & parity_983) | ((^{or_950, or_946, and_942}) & (parity_968 | parity_983));
  logic or_994;
  assign or_994 = (or_946 & or_950) | (and_942 & (or_946 | or_950));
  logic or_998;
  assign or_998 = (or_961 & or_965) | (or_957 & (or_961 | or_965));
  logic or_1002;
  assign or_1002 = (or_976 & or_980) | (or_972 & (or_976 | or_980));
  // hls/stages/agreement.hpp:672
  logic parity_1007;
  assign parity_1007 = ^{or_1002, or_998, or_994, or_990};
  // hls/stages/agreement.hpp:673
  logic or_1011;
  assign or_1011 = (or_998 & or_1002) | (or_994 & (or_998 | or_1002));
  logic and_1012;
  assign and_1012 = or_990 & (^{or_1002, or_998, or_994});
  // hls/stages/agreement.hpp:672
  logic xor_1013;
  assign xor_1013 = or_1011 ^ and_1012;
  // hls/stages/agreement.hpp:675
  logic and_1014;
  assign and_1014 = or_1011 & and_1012;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1015;
  assign select_1015 = equal_390_s1_q ? {and_1014, xor_1013, parity_1007, parity_986, xor_941, xor_846} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_388_s1_q ? 6'h0 : select_1015;
  // hls/stages/agreement.hpp:205
  logic and_1023;
  assign and_1023 = right_codes_rdata_q[25] & not_396_s1_q;
  // hls/stages/agreement.hpp:733
  logic select_1024;
  assign select_1024 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_396_s1_q) : and_1023;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1026;
  assign select_1026 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:733
  logic [11:0] select_1027;
  assign select_1027 = slot_s1_q[0] ? (less_395_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1026;
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1031;
  assign select_1031 = and_522 ? (select_1024 ? (~(select_525 ^ select_1027)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1037;
  assign parity_1037 = ^select_1031[5:3];
  logic parity_1040;
  assign parity_1040 = ^select_1031[8:6];
  logic parity_1043;
  assign parity_1043 = ^select_1031[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1051;
  assign select_1051 = (slot_s1_q[0] ? and_1023 : and_523) ? (~(select_548 ^ (slot_s1_q[0] ? select_1026 : select_524))) : 12'h0;
  logic [11:0] select_1052;
  assign select_1052 = and_545 ? select_1051 : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1055;
  assign parity_1055 = ^select_1052[8:6];
  logic parity_1058;
  assign parity_1058 = ^select_1052[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1066;
  assign select_1066 = (slot_s1_q[0] ? and_523 : and_546) ? (~(select_565 ^ (slot_s1_q[0] ? select_524 : select_547))) : 12'h0;
  logic [11:0] select_1067;
  assign select_1067 = and_562 ? select_1066 : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1073;
  assign parity_1073 = ^select_1067[2:0];
  logic parity_1076;
  assign parity_1076 = ^select_1067[5:3];
  logic parity_1079;
  assign parity_1079 = ^select_1067[8:0];
  logic parity_1085;
  assign parity_1085 = ^select_1067[11:9];
  logic parity_1088;
  assign parity_1088 = ^select_1052[2:0];
  logic parity_1091;
  assign parity_1091 = ^{select_1067[11:9], select_1052[5:0]};
  logic parity_1094;
  assign parity_1094 = ^{select_1067, select_1052, select_1031[2:0]};
  logic xor_1095;
  assign xor_1095 = parity_1043 ^ parity_1094;
  // hls/stages/agreement.hpp:671
  logic or_1099;
  assign or_1099 = (select_1031[1:0] == 2'h3) | (select_1031[2] & (select_1031[0] | select_1031[1]));
  // hls/stages/agreement.hpp:673
  logic or_1103;
  assign or_1103 = (select_1052[7:6] == 2'h3) | (select_1052[8] & (select_1052[6] | select_1052[7]));
  logic or_1107;
  assign or_1107 = (select_1052[10:9] == 2'h3) | (select_1052[11] & (select_1052[9] | select_1052[10]));
  // hls/stages/agreement.hpp:671
  logic or_1115;
  assign or_1115 = (select_1067[7:6] == 2'h3) | (select_1067[8] & (~(select_1067[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_1119;
  assign or_1119 = (select_1067[1:0] == 2'h3) | (select_1067[2] & (select_1067[0] | select_1067[1]));
  logic or_1123;
  assign or_1123 = (select_1067[4:3] == 2'h3) | (select_1067[5] & (select_1067[3] | select_1067[4]));
  // hls/stages/agreement.hpp:672
  logic parity_1126;
  assign parity_1126 = ^{or_1123, or_1119, or_1115};
  // hls/stages/agreement.hpp:671
  logic or_1130;
  assign or_1130 = (select_1052[4:3] == 2'h3) | (select_1052[5] & (select_1052[3] | select_1052[4]));
  // hls/stages/agreement.hpp:673
  logic or_1134;
  assign or_1134 = (select_1067[10:9] == 2'h3) | (select_1067[11] & (select_1067[9] | select_1067[10]));
  logic or_1138;
  assign or_1138 = (select_1052[1:0] == 2'h3) | (select_1052[2] & (select_1052[0] | select_1052[1]));
  // hls/stages/agreement.hpp:672
  logic parity_1141;
  assign parity_1141 = ^{or_1138, or_1134, or_1130};
  logic parity_1144;
  assign parity_1144 = ^{or_1138, or_1134, or_1130, or_1123, or_1119, or_1115, or_1107, or_1103, or_1099};
  // hls/stages/agreement.hpp:673
  logic and_1145;
  assign and_1145 = parity_1043 & parity_1094;
  logic or_1149;
  assign or_1149 = (parity_1037 & parity_1040) | ((^select_1031[11:9]) & (parity_1037 | parity_1040));
  logic and_1152;
  assign and_1152 = (^{select_1052[11:6], select_1031[2:0]}) & (parity_1079 | parity_1091);
  logic or_1153;
  assign or_1153 = (parity_1079 & parity_1091) | and_1152;
  // hls/stages/agreement.hpp:671
  logic or_1160;
  assign or_1160 = (select_1031[10:9] == 2'h3) | (select_1031[11] & (select_1031[9] | select_1031[10]));
  // hls/stages/agreement.hpp:673
  logic or_1164;
  assign or_1164 = (select_1031[4:3] == 2'h3) | (select_1031[5] & (select_1031[3] | select_1031[4]));
  logic or_1168;
  assign or_1168 = (select_1031[7:6] == 2'h3) | (select_1031[8] & (select_1031[6] | select_1031[7]));
  // hls/stages/agreement.hpp:672
  logic parity_1171;
  assign parity_1171 = ^{or_1168, or_1164, or_1160};
  // hls/stages/agreement.hpp:673
  logic or_1175;
  assign or_1175 = (parity_1055 & parity_1058) | ((^select_1031[2:0]) & (parity_1055 | parity_1058));
  logic or_1179;
  assign or_1179 = (parity_1073 & parity_1076) | ((^select_1067[8:6]) & (parity_1073 | parity_1076));
  logic or_1183;
  assign or_1183 = (parity_1085 & parity_1088) | ((^select_1052[5:3]) & (parity_1085 | parity_1088));
  // hls/stages/agreement.hpp:672
  logic parity_1186;
  assign parity_1186 = ^{or_1183, or_1179, or_1175};
  logic parity_1189;
  assign parity_1189 = ^{or_1183, or_1179, or_1175, or_1168, or_1164, or_1160, or_1153, or_1149, and_1145};
  logic xor_1190;
  assign xor_1190 = parity_1144 ^ parity_1189;
  // hls/stages/agreement.hpp:673
  logic and_1191;
  assign and_1191 = parity_1144 & parity_1189;
  logic or_1195;
  assign or_1195 = (parity_1126 & parity_1141) | ((^{or_1107, or_1103, or_1099}) & (parity_1126 | parity_1141));
  logic or_1199;
  assign or_1199 = (parity_1171 & parity_1186) | ((^{or_1153, or_1149, and_1145}) & (parity_1171 | parity_1186));
  logic or_1206;
  assign or_1206 = (or_1103 & or_1107) | (or_1099 & (or_1103 | or_1107));
  logic or_1210;
  assign or_1210 = (or_1119 & or_1123) | (or_1115 & (or_1119 | or_1123));
  logic or_1214;
  assign or_1214 = (or_1134 & or_1138) | (or_1130 & (or_1134 | or_1138));
  // hls/stages/agreement.hpp:672
  logic parity_1217;
  assign parity_1217 = ^{or_1214, or_1210, or_1206};
  // hls/stages/agreement.hpp:673
  logic or_1221;
  assign or_1221 = (or_1149 & or_1153) | (and_1145 & (or_1149 | or_1153));
  logic or_1225;
  assign or_1225 = (or_1164 & or_1168) | (or_1160 & (or_1164 | or_1168));
  logic or_1229;
  assign or_1229 = (or_1179 & or_1183) | (or_1175 & (or_1179 | or_1183));
  // hls/stages/agreement.hpp:672
  logic parity_1232;
  assign parity_1232 = ^{or_1229, or_1225, or_1221};
  logic parity_1235;
  assign parity_1235 = ^{or_1229, or_1225, or_1221, or_1214, or_1210, or_1206, or_1199, or_1195, and_1191};
  // hls/stages/agreement.hpp:673
  logic or_1239;
  assign or_1239 = (parity_1217 & parity_1232) | ((^{or_1199, or_1195, and_1191}) & (parity_1217 | parity_1232));
  logic or_1243;
  assign or_1243 = (or_1195 & or_1199) | (and_1191 & (or_1195 | or_1199));
  logic or_1247;
  assign or_1247 = (or_1210 & or_1214) | (or_1206 & (or_1210 | or_1214));
  logic or_1251;
  assign or_1251 = (or_1225 & or_1229) | (or_1221 & (or_1225 | or_1229));
  // hls/stages/agreement.hpp:672
  logic parity_1256;
  assign parity_1256 = ^{or_1251, or_1247, or_1243, or_1239};
  // hls/stages/agreement.hpp:673
  logic or_1260;
  assign or_1260 = (or_1247 & or_1251) | (or_1243 & (or_1247 | or_1251));
  logic and_1261;
  assign and_1261 = or_1239 & (^{or_1251, or_1247, or_1243});
  // hls/stages/agreement.hpp:672
  logic xor_1262;
  assign xor_1262 = or_1260 ^ and_1261;
  // hls/stages/agreement.hpp:675
  logic and_1263;
  assign and_1263 = or_1260 & and_1261;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1264;
  assign select_1264 = equal_390_s1_q ? {and_1263, xor_1262, parity_1256, parity_1235, xor_1190, xor_1095} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_388_s1_q ? 6'h0 : select_1264;
  // hls/stages/agreement.hpp:942
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:943
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:944
  logic [5:0] select_1322;
  assign select_1322 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:947
  logic and_1342;
  assign and_1342 = (or_388_s1_q & (left_rdata_q[61] & not_396_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:228
  logic or_1364;
  assign or_1364 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:392
  logic [5:0] select_1375;
  assign select_1375 = so_s1_q ? x_s1_q[5:0] : (or_388_s1_q ? (less_395_s1_q ? 6'h0 : select_1322) : 6'h0);
  // hls/stages/agreement.hpp:970
  logic [4:0] sum_1418;
  assign sum_1418 = {1'b0, last_s1_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:392
  logic and_1597;
  assign and_1597 = ((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & (~({1'b0, sum_1418, last_s1_q[1:0]} < x_s1_q));
  // hls/stages/agreement.hpp:436
  logic select_1963;
  assign select_1963 = equal_1866_s1_q ? (~({row_s1_q, 1'b0} < {sum_1960, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:495
  logic and_2191;
  assign and_2191 = and_367_s1_q & (equal_1866_s1_q & (row_s1_q[5:2] == 4'h0));

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_334_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_342;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1302; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_388_s1_q ? select_1322 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_509_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_399_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_491, left_rdata_q[59:45], and_490, left_rdata_q[43:29], and_489, left_rdata_q[27:13], and_488, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 6'd47) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 6'd47) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [5:0] right_codes_waddr;
  assign right_codes_waddr = x_s1_q[5:0];
  logic right_codes_we;
  assign right_codes_we = s1_en & and_399_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_500, right_codes_rdata_q[76:65], and_499, right_codes_rdata_q[63:52], and_498, right_codes_rdata_q[50:39], and_497, right_codes_rdata_q[37:26], and_496, right_codes_rdata_q[24:13], and_495, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 6'd47) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 6'd47) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 6'h0;
      lower_half_q <= 1'b0;
    end else if (s1_en) begin
      row_q <= and_367_s1_q ? (equal_1866_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_367_s1_q ? select_1963 : lower_half_q;
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
    if (s1_en) begin
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

  logic [7:0] pixel_0_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic left_first_s2_q;
  logic sample_pair_whole_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [3:0] age_s2_q;
  logic [2:0] slot_s2_q;
  logic ends_cell_s2_q;
  logic lower_half_s2_q;
  logic select_328_s2_q;
  logic [7:0] select_334_s2_q;
  logic and_341_s2_q;
  logic and_342_s2_q;
  logic equal_347_s2_q;
  logic whole_s2_q;
  logic [5:0] column_s2_q;
  logic and_365_s2_q;
  logic and_367_s2_q;
  logic equal_370_s2_q;
  logic so_s2_q;
  logic equal_387_s2_q;
  logic or_388_s2_q;
  logic less_395_s2_q;
  logic not_396_s2_q;
  logic equal_428_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_516_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1017_s2_q;
  logic [5:0] select_1266_s2_q;
  logic and_1318_s2_q;
  logic [5:0] right_s2_q;
  logic select_1327_s2_q;
  logic equal_1336_s2_q;
  logic and_1343_s2_q;
  logic and_1346_s2_q;
  logic and_1350_s2_q;
  logic or_1364_s2_q;
  logic [5:0] select_1375_s2_q;
  logic less_1419_s2_q;
  logic equal_1459_s2_q;
  logic and_1509_s2_q;
  logic and_1599_s2_q;
  logic equal_1745_s2_q;
  logic equal_1866_s2_q;
  logic less_2120_s2_q;
  logic and_2192_s2_q;
  logic and_2194_s2_q;
  logic less_2301_s2_q;
  logic equal_2508_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      age_s2_q <= age_s1_q;
      slot_s2_q <= slot_s1_q;
      ends_cell_s2_q <= ends_cell_s1_q;
      lower_half_s2_q <= lower_half_q;
      select_328_s2_q <= select_328_s1_q;
      select_334_s2_q <= select_334_s1_q;
      and_341_s2_q <= and_341_s1_q;
      and_342_s2_q <= and_342;
      equal_347_s2_q <= equal_347_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_365_s2_q <= and_365_s1_q;
      and_367_s2_q <= and_367_s1_q;
      equal_370_s2_q <= equal_370_s1_q;
      so_s2_q <= so_s1_q;
      equal_387_s2_q <= equal_387_s1_q;
      or_388_s2_q <= or_388_s1_q;
      less_395_s2_q <= less_395_s1_q;
      not_396_s2_q <= not_396_s1_q;
      equal_428_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_516_s2_q <= select_516_s1_q;
      column_2_s2_q <= column_2;
      select_1017_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1266_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1318_s2_q <= and_1318_s1_q;
      right_s2_q <= right_s1_q;
      select_1327_s2_q <= select_1327_s1_q;
      equal_1336_s2_q <= equal_1336_s1_q;
      and_1343_s2_q <= not_396_s1_q & and_1342;
      and_1346_s2_q <= (or_388_s1_q & (left_rdata_q[62] & not_396_s1_q)) & and_1342;
      and_1350_s2_q <= not_396_s1_q & (or_388_s1_q & (left_rdata_q[63] & not_396_s1_q));
      or_1364_s2_q <= or_1364;
      select_1375_s2_q <= select_1375;
      less_1419_s2_q <= {2'h0, sum_1418, last_s1_q[1]} < x_s1_q;
      equal_1459_s2_q <= x_s1_q == {2'h0, last_s1_q};
      and_1509_s2_q <= sample_pair_whole_q;
      and_1599_s2_q <= so_s1_q & (ends_cell_s1_q & and_1597);
      equal_1745_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_1866_s2_q <= equal_1866_s1_q;
      less_2120_s2_q <= 5'h4 < row_q[5:1];
      and_2192_s2_q <= and_1867_s1_q & and_2191;
      and_2194_s2_q <= and_1867_s1_q & (~and_2191);
      less_2301_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2508_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [5:0] middle_sum_columns_values_0_q;
  logic [5:0] middle_sum_columns_values_1_q;
  logic [5:0] middle_sum_columns_values_2_q;
  logic [5:0] middle_sum_columns_values_3_q;
  logic [5:0] middle_sum_columns_values_4_q;
  logic [5:0] middle_sum_columns_values_5_q;
  logic [5:0] middle_sum_columns_values_6_q;
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [7:0] chosen_score_q;
  logic [6:0] chosen_near_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  // hls/stages/census.hpp:112
  logic [11:0] select_345;
  assign select_345 = select_328_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_349;
  assign sum_349 = select_345 + (equal_347_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_351;
  assign sum_351 = {4'h0, sample_pair_pixel_1_q} + (select_328_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_353;
  assign sum_353 = sum_351 + (equal_347_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:122
  logic and_357;
  assign and_357 = whole_s2_q & (averager_memory_rdata_q[24] | equal_347_s2_q);
  // hls/stages/agreement.hpp:394
  logic all_of_skin;
  assign all_of_skin = select_328_s2_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_361;
  assign and_361 = all_of_skin & (averager_memory_rdata_q[25] | equal_347_s2_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_341_s2_q ? sum_349[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_341_s2_q ? sum_353[11:3] : 9'h0;
  logic and_378;
  assign and_378 = and_341_s2_q & and_357;
  // hls/stages/census.hpp:126
  logic select_380;
  assign select_380 = equal_370_s2_q ? and_378 : (averager_mask_q & and_378);
  // hls/stages/agreement.hpp:255
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_380;
  // hls/stages/census.hpp:206
  logic and_382;
  assign and_382 = and_341_s2_q & and_361;
  // hls/stages/census.hpp:126
  logic select_384;
  assign select_384 = equal_370_s2_q ? and_382 : (averager_of_skin_q & and_382);
  // hls/stages/agreement.hpp:787
  logic not_518;
  assign not_518 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_519;
  assign less_519 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:224
  logic and_521;
  assign and_521 = not_518 & (~less_519);
  // hls/stages/agreement.hpp:777
  logic [5:0] select_768;
  assign select_768 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_769;
  assign difference_769 = {1'b0, column_2_s2_q} - {1'b0, select_768};
  logic [7:0] sum_771;
  assign sum_771 = {difference_769[6], difference_769} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:754
  logic [7:0] select_772;
  assign select_772 = slot_s2_q[0] ? chosen_score_q : sum_771;
  // hls/stages/agreement.hpp:777
  logic [6:0] difference_1018;
  assign difference_1018 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1017_s2_q};
  // hls/stages/agreement.hpp:748
  logic equal_1019;
  assign equal_1019 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:777
  logic [7:0] sum_1021;
  assign sum_1021 = {difference_1018[6], difference_1018} + (equal_1019 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1267;
  assign difference_1267 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1266_s2_q};
  logic [7:0] sum_1269;
  assign sum_1269 = {difference_1267[6], difference_1267} + (equal_1019 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:750
  logic less_1270;
  assign less_1270 = sum_1021 < sum_1269;
  logic [7:0] select_1271;
  assign select_1271 = less_1270 ? sum_1269 : sum_1021;
  logic less_1272;
  assign less_1272 = select_772 < select_1271;
  // hls/stages/agreement.hpp:791
  logic [7:0] of_best;
  assign of_best = and_521 ? (less_1272 ? select_1271 : select_772) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic or_1276;
  assign or_1276 = select_516_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:803
  logic [5:0] select_1277;
  assign select_1277 = or_1276 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:719
  logic not_1278;
  assign not_1278 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:751
  logic [1:0] select_1279;
  assign select_1279 = less_1270 ? {slot_s2_q[0], not_1278} : 2'h0;
  logic [2:0] select_1281;
  assign select_1281 = less_1272 ? {select_1279, not_1278} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:803
  logic [2:0] select_1282;
  assign select_1282 = or_1276 ? select_1281 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1283;
  assign select_1283 = or_1276 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:800
  logic equal_1284;
  assign equal_1284 = select_1281 == 3'h1;
  logic equal_1285;
  assign equal_1285 = select_1281 == 3'h2;
  logic not_1286;
  assign not_1286 = ~equal_1285;
  logic [2:0] select_1287;
  assign select_1287 = equal_1284 ? 3'h2 : {not_1286, {2{equal_1285}}};
  logic [7:0] select_1289;
  assign select_1289 = select_1287[1] ? sum_1269 : (select_1287[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1292;
  assign sum_1292 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1293;
  assign sum_1293 = {1'b0, before_v} + sum_1292;
  // hls/stages/agreement.hpp:754
  logic [6:0] select_1294;
  assign select_1294 = slot_s2_q[0] ? chosen_near_q : sum_1293;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1296;
  assign sum_1296 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1297;
  assign sum_1297 = {1'b0, before_v_2} + sum_1296;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1299;
  assign sum_1299 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1300;
  assign sum_1300 = {1'b0, before_v_3} + sum_1299;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1302;
  assign select_1302 = (sum_1297 < sum_1300) ? sum_1300 : sum_1297;
  logic [6:0] select_1304;
  assign select_1304 = (select_1294 < select_1302) ? select_1302 : select_1294;
  // hls/stages/agreement.hpp:800
  logic [6:0] select_1305;
  assign select_1305 = select_1287[0] ? {4'h0, select_1281} : select_1304;
  logic [7:0] select_1306;
  assign select_1306 = select_1287[1] ? (select_1287[0] ? before_1_q : sum_1021) : {1'b0, select_1305};
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1308;
  assign select_1308 = or_1276 ? (select_1287[2] ? select_1289 : select_1306) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:801
  logic [1:0] select_1309;
  assign select_1309 = equal_1284 ? 2'h0 : {not_1286, equal_1285};
  logic [7:0] select_1311;
  assign select_1311 = select_1309[1] ? sum_1269 : (select_1309[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1312;
  assign select_1312 = or_1276 ? select_1311 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:792
  logic [6:0] of_near;
  assign of_near = and_521 ? select_1304 : 7'h0;
  // hls/stages/agreement.hpp:803
  logic or_1315;
  assign or_1315 = select_516_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:807
  logic [6:0] select_1316;
  assign select_1316 = or_1315 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1317;
  assign select_1317 = or_1315 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:812
  logic or_1329;
  assign or_1329 = select_1327_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:816
  logic [7:0] select_1330;
  assign select_1330 = or_1329 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1331;
  assign select_1331 = or_1329 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1333;
  assign or_1333 = select_1327_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:820
  logic [6:0] select_1334;
  assign select_1334 = or_1333 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1335;
  assign select_1335 = or_1333 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:970
  logic not_1337;
  assign not_1337 = ~equal_1336_s2_q;
  // hls/stages/agreement.hpp:228
  logic and_1347;
  assign and_1347 = not_396_s2_q & and_1346_s2_q;
  // hls/stages/agreement.hpp:950
  logic select_1353;
  assign select_1353 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:951
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:957
  logic [8:0] difference_1356;
  assign difference_1356 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:958
  logic [9:0] sum_1357;
  assign sum_1357 = {difference_1356[8], difference_1356} + 10'h1;
  // hls/stages/agreement.hpp:228
  logic and_1359;
  assign and_1359 = (and_1346_s2_q & select_1353) & ({{22{sum_1357[9]}}, sum_1357} < 32'h3);
  logic and_1360;
  assign and_1360 = not_396_s2_q & and_1359;
  logic and_1366;
  assign and_1366 = not_396_s2_q & (and_1359 & or_1364_s2_q);
  // hls/stages/agreement.hpp:137
  logic [8:0] select_1367;
  assign select_1367 = less_395_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_388_s2_q ? {select_1367, and_1366, and_1360, and_1350_s2_q, and_1347, and_1343_s2_q, not_396_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:392
  logic and_1369;
  assign and_1369 = ends_cell_s2_q & inside_v[0];
  logic and_1371;
  assign and_1371 = not_1337 & (so_s2_q & and_1369);
  // hls/stages/agreement.hpp:243
  logic right_2;
  assign right_2 = inside_v[0] & less_1419_s2_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:255
  logic select_1658;
  assign select_1658 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1660;
  assign select_1660 = sample_pair_whole_s2_q ? (and_365_s2_q ? select_380 : averager_mask_q) : averager_mask_q;
  logic select_1662;
  assign select_1662 = sample_pair_whole_s2_q ? (and_365_s2_q ? select_384 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:220
  logic [5:0] select_1966;
  assign select_1966 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_1967;
  assign select_1967 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1968;
  assign select_1968 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_1969;
  assign select_1969 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1970;
  assign select_1970 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1971;
  assign select_1971 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_1975;
  assign select_1975 = slot_s2_q[0] ? 8'h0 : sum_771;
  // hls/stages/agreement.hpp:750
  logic less_1976;
  assign less_1976 = select_1975 < select_1271;
  // hls/stages/agreement.hpp:220
  logic [6:0] select_1978;
  assign select_1978 = slot_s2_q[0] ? 7'h0 : sum_1293;
  // hls/stages/registration.hpp:76
  logic less_2067;
  assign less_2067 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:137
  logic [7:0] select_2069;
  assign select_2069 = or_388_s2_q ? (less_395_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2071;
  assign select_2071 = or_388_s2_q ? (less_395_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2073;
  assign select_2073 = or_388_s2_q ? (less_395_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2071} - {1'b0, select_2073};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2075;
  assign select_2075 = rise[8] ? select_2071 : select_2073;
  logic [8:0] difference_2076;
  assign difference_2076 = {1'b0, select_2069} - {1'b0, select_2075};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2076[8] ? 8'h0 : difference_2076[7:0];
  // hls/stages/registration.hpp:37
  logic not_2078;
  assign not_2078 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2067 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2078};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2080;
  assign xor_2080 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2080};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2086;
  assign select_2086 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2067 ? {taken, 1'b1} : {not_2078, select_2086, not_2078};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2088;
  assign sum_2088 = {left, 1'b1} + {taken_2, less_2067};
  // hls/stages/agreement.hpp:238
  logic [4:0] select_2090;
  assign select_2090 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = column_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_367_s2_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1303; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1371;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1329; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1371;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_334_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_342_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_361, and_357, sum_353, sum_349};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 8'd189) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 8'd189) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1318_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1317, select_1316, select_1312, select_1308, select_1283, select_1282, select_1277};
  end
`ifndef SYNTHESIS
  logic [5:0] best_left_raddr_s1_sim;
  logic best_left_re_s1_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s1_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s1_sim <= best_left_re;
      best_left_raddr_s1_sim <= best_left_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s1_sim && best_left_raddr_s1_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_waddr >= 6'd47) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 6'd47) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [5:0] best_right_waddr;
  assign best_right_waddr = right_s2_q;
  logic best_right_we;
  assign best_right_we = s2_en & and_1318_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1335, select_1334, select_1331, select_1330};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 6'd47) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 6'd47) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      chosen_score_q <= 8'h0;
      chosen_near_q <= 7'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_of_skin_q <= select_1658;
      averager_mask_q <= select_1660;
      averager_of_skin_q <= select_1662;
      chosen_score_q <= less_1976 ? select_1271 : select_1975;
      chosen_near_q <= (select_1978 < select_1302) ? select_1302 : select_1978;
      chosen_place_q <= less_1976 ? {select_1279, not_1278} : 3'h2;
      before_0_q <= select_1975;
      before_1_q <= sum_1021;
      before_2_q <= sum_1269;
      registration_displacement_over_q <= so_s2_q ? sum_2088[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2090;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
    middle_sum_columns_values_0_q = 6'h0;
    middle_sum_columns_values_1_q = 6'h0;
    middle_sum_columns_values_2_q = 6'h0;
    middle_sum_columns_values_3_q = 6'h0;
    middle_sum_columns_values_4_q = 6'h0;
    middle_sum_columns_values_5_q = 6'h0;
    middle_sum_columns_values_6_q = 6'h0;
    middle_sum_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_1_q = 8'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_1_sum_sums_values_1_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      left_pixel_q <= and_1509_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_345 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_351 : averager_running_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_1966;
      middle_sum_columns_values_2_q <= select_1967;
      middle_sum_columns_values_3_q <= select_1968;
      middle_sum_columns_values_4_q <= select_1969;
      middle_sum_columns_values_5_q <= select_1970;
      middle_sum_columns_values_6_q <= select_1971;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_771;
      sums_0_sum_sums_values_0_q <= sum_1021;
      sums_0_sum_sums_values_1_q <= equal_1019 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1269;
      sums_1_sum_sums_values_1_q <= equal_1019 ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic [5:0] column_s3_q;
  logic and_365_s3_q;
  logic and_367_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_370_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic and_385_s3_q;
  logic so_s3_q;
  logic equal_428_s3_q;
  logic equal_1336_s3_q;
  logic not_1337_s3_q;
  logic [13:0] inside_v_s3_q;
  logic and_1371_s3_q;
  logic [5:0] select_1375_s3_q;
  logic and_1380_s3_q;
  logic right_2_s3_q;
  logic equal_1459_s3_q;
  logic textured_s3_q;
  logic and_1509_s3_q;
  logic and_1600_s3_q;
  logic equal_1745_s3_q;
  logic equal_1866_s3_q;
  logic and_2121_s3_q;
  logic less_2126_s3_q;
  logic and_2192_s3_q;
  logic and_2194_s3_q;
  logic less_2301_s3_q;
  logic equal_2508_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[2];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      column_s3_q <= column_s2_q;
      and_365_s3_q <= and_365_s2_q;
      and_367_s3_q <= and_367_s2_q;
      grey_s3_q <= grey;
      equal_370_s3_q <= equal_370_s2_q;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      and_385_s3_q <= sample_pair_whole_s2_q & select_384;
      so_s3_q <= so_s2_q;
      equal_428_s3_q <= equal_428_s2_q;
      equal_1336_s3_q <= equal_1336_s2_q;
      not_1337_s3_q <= not_1337;
      inside_v_s3_q <= {inside_v[14:3], inside_v[1:0]};
      and_1371_s3_q <= and_1371;
      select_1375_s3_q <= select_1375_s2_q;
      and_1380_s3_q <= not_1337 & (so_s2_q ? and_1369 : (equal_387_s2_q & inside_v[4]));
      right_2_s3_q <= right_2;
      equal_1459_s3_q <= equal_1459_s2_q;
      textured_s3_q <= textured;
      and_1509_s3_q <= and_1509_s2_q;
      and_1600_s3_q <= not_1337 & and_1599_s2_q;
      equal_1745_s3_q <= equal_1745_s2_q;
      equal_1866_s3_q <= equal_1866_s2_q;
      and_2121_s3_q <= inside_v[4] & less_2120_s2_q;
      less_2126_s3_q <= select_2071 < select_2073;
      and_2192_s3_q <= and_2192_s2_q;
      and_2194_s3_q <= and_2194_s2_q;
      less_2301_s3_q <= less_2301_s2_q;
      equal_2508_s3_q <= equal_2508_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
  logic census_columns_values_0_cell_0_mask_q;
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
  logic census_columns_values_1_cell_0_mask_q;
  logic [8:0] census_columns_values_1_cell_1_left_q;
  logic [8:0] census_columns_values_1_cell_1_right_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic [8:0] census_columns_values_1_cell_2_left_q;
  logic [8:0] census_columns_values_1_cell_2_right_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] census_columns_values_1_cell_3_left_q;
  logic [8:0] census_columns_values_1_cell_3_right_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic [8:0] census_columns_values_1_cell_4_left_q;
  logic [8:0] census_columns_values_1_cell_4_right_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic [8:0] census_columns_values_2_cell_0_left_q;
  logic [8:0] census_columns_values_2_cell_0_right_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic [8:0] census_columns_values_2_cell_1_left_q;
  logic [8:0] census_columns_values_2_cell_1_right_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [8:0] census_columns_values_2_cell_2_left_q;
  logic [8:0] census_columns_values_2_cell_2_right_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic [8:0] census_columns_values_2_cell_3_left_q;
  logic [8:0] census_columns_values_2_cell_3_right_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic [8:0] census_columns_values_2_cell_4_left_q;
  logic [8:0] census_columns_values_2_cell_4_right_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic [8:0] census_columns_values_3_cell_1_left_q;
  logic [8:0] census_columns_values_3_cell_1_right_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic [8:0] census_columns_values_3_cell_3_left_q;
  logic [8:0] census_columns_values_3_cell_3_right_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic census_columns_values_3_cell_4_mask_q;
  logic [3:0] census_filled_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic [7:0] registration_slope_here_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [3:0] registration_fresh_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_across_rest_q;
  logic [6:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [7:0] columns_begin_rest_q;
  logic [6:0] columns_begin_back_q;
  logic [8:0] region_down_rest_q;
  logic [6:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic [2:0] box_textured_columns_values_0_q;
  logic [2:0] box_textured_columns_values_1_q;
  logic [2:0] box_textured_columns_values_2_q;
  logic [2:0] box_textured_columns_values_3_q;
  logic [2:0] box_textured_columns_values_4_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [2:0] box_explained_columns_values_0_q;
  logic [2:0] box_explained_columns_values_1_q;
  logic [2:0] box_explained_columns_values_2_q;
  logic [2:0] box_explained_columns_values_3_q;
  logic [2:0] box_explained_columns_values_4_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [2:0] box_shown_columns_values_0_q;
  logic [2:0] box_shown_columns_values_1_q;
  logic [2:0] box_shown_columns_values_2_q;
  logic [2:0] box_shown_columns_values_3_q;
  logic [2:0] box_shown_columns_values_4_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [2:0] box_nearer_columns_values_0_q;
  logic [2:0] box_nearer_columns_values_1_q;
  logic [2:0] box_nearer_columns_values_2_q;
  logic [2:0] box_nearer_columns_values_3_q;
  logic [2:0] box_nearer_columns_values_4_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  logic [10:0] map_row_q;
  logic [5:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  logic [9:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  logic began_q;
  logic [2:0] seen_x_q;
  logic [2:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [10:0] seen_base_q;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey_s3_q} + (equal_370_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:255
  logic [8:0] select_373;
  assign select_373 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_370_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:255
  logic [8:0] select_377;
  assign select_377 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:294
  logic less_401;
  assign less_401 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_402;
  assign less_402 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_403;
  assign less_403 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_404;
  assign less_404 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_405;
  assign less_405 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_406;
  assign less_406 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_407;
  assign less_407 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_408;
  assign less_408 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_409;
  assign less_409 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_410;
  assign less_410 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_411;
  assign less_411 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_412;
  assign less_412 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_413;
  assign less_413 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_414;
  assign less_414 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_415;
  assign less_415 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_416;
  assign less_416 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_417;
  assign less_417 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_418;
  assign less_418 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_419;
  assign less_419 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_420;
  assign less_420 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_421;
  assign less_421 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_422;
  assign less_422 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_423;
  assign less_423 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_424;
  assign less_424 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:431
  logic equal_425;
  assign equal_425 = column_s3_q == 6'h0;
  logic [3:0] select_429;
  assign select_429 = equal_428_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:432
  logic [4:0] select_430;
  assign select_430 = equal_425 ? {select_429, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_431;
  assign select_431 = equal_425 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_432;
  assign and_432 = select_430[4] & select_431[3];
  // hls/stages/census.hpp:286
  logic and_434;
  assign and_434 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_436;
  assign and_436 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_434);
  // hls/stages/agreement.hpp:432
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_436;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_q & whole_9;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_q & whole_16;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:270
  logic [9:0] difference_459;
  assign difference_459 = {1'b0, select_373} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_460;
  assign xor_460 = difference_459[8:0] ^ {9{difference_459[9]}};
  logic [9:0] sum_461;
  assign sum_461 = {9'h0, difference_459[9]} + {1'b0, xor_460};
  logic [9:0] difference_462;
  assign difference_462 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_463;
  assign xor_463 = difference_462[8:0] ^ {9{difference_462[9]}};
  logic [9:0] sum_464;
  assign sum_464 = {9'h0, difference_462[9]} + {1'b0, xor_463};
  logic [9:0] difference_466;
  assign difference_466 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_467;
  assign xor_467 = difference_466[8:0] ^ {9{difference_466[9]}};
  logic [9:0] sum_468;
  assign sum_468 = {9'h0, difference_466[9]} + {1'b0, xor_467};
  logic [10:0] sum_469;
  assign sum_469 = ({1'b0, sum_461} + {1'b0, sum_464}) + {1'b0, sum_468};
  logic [9:0] difference_470;
  assign difference_470 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_471;
  assign xor_471 = difference_470[8:0] ^ {9{difference_470[9]}};
  logic [9:0] sum_472;
  assign sum_472 = {9'h0, difference_470[9]} + {1'b0, xor_471};
  logic [9:0] difference_474;
  assign difference_474 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_475;
  assign xor_475 = difference_474[8:0] ^ {9{difference_474[9]}};
  logic [9:0] sum_476;
  assign sum_476 = {9'h0, difference_474[9]} + {1'b0, xor_475};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_469} + {2'h0, sum_472}) + {2'h0, sum_476};
  // hls/stages/agreement.hpp:186
  logic not_1376;
  assign not_1376 = ~so_s3_q;
  // hls/stages/agreement.hpp:392
  logic and_1377;
  assign and_1377 = not_1376 & inside_v_s3_q[4];
  // hls/stages/agreement.hpp:1082
  logic equal_1381;
  assign equal_1381 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1122
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1083
  logic [1:0] select_1384;
  assign select_1384 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1095
  logic [3:0] select_1386;
  assign select_1386 = equal_1381 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1384});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1387;
  assign sum_1387 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_1388;
  assign select_1388 = equal_1336_s3_q ? select_1386 : {sum_1387, lower_half_s3_q, registration_of_right_q};
  // hls/stages/agreement.hpp:1120
  logic equal_1389;
  assign equal_1389 = x_s3_q[5:0] == 6'h3e;
  logic equal_1391;
  assign equal_1391 = x_s3_q[5:0] == 6'h3d;
  logic equal_1393;
  assign equal_1393 = x_s3_q[5:0] == 6'h3c;
  logic equal_1395;
  assign equal_1395 = x_s3_q[5:0] == 6'h3b;
  logic equal_1397;
  assign equal_1397 = x_s3_q[5:0] == 6'h36;
  logic equal_1399;
  assign equal_1399 = x_s3_q[5:0] == 6'h35;
  logic equal_1401;
  assign equal_1401 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1122
  logic and_1405;
  assign and_1405 = (~equal_1395) & ((~equal_1397) & ((~equal_1399) & (~equal_1401)));
  // hls/stages/agreement.hpp:1083
  logic less_1409;
  assign less_1409 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_1413;
  assign or_1413 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1095
  logic select_1416;
  assign select_1416 = equal_1381 ? ((~equal_1389) & ((~equal_1391) & ((~equal_1393) & and_1405))) : (less_1409 & (~or_1413));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1424;
  assign sum_1424 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1426;
  assign and_1426 = half_ends & ({{3{sum_1424[4]}}, sum_1424} < 8'h3);
  // hls/stages/agreement.hpp:392
  logic and_1427;
  assign and_1427 = so_s3_q & and_1426;
  // hls/stages/registration.hpp:253
  logic not_1430;
  assign not_1430 = ~lower_half_s3_q;
  logic [3:0] select_1431;
  assign select_1431 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1430, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1430};
  // hls/stages/agreement.hpp:190
  logic [7:0] select_1444;
  assign select_1444 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1004
  logic or_1447;
  assign or_1447 = select_1444[7] | (~({select_1444[5], select_1444[3], select_1444[1]} == 3'h0));
  // hls/stages/agreement.hpp:1003
  logic or_1450;
  assign or_1450 = select_1444[7] | (~({select_1444[6], select_1444[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1002
  logic or_1453;
  assign or_1453 = select_1444[7] | (~(select_1444[6:4] == 3'h0));
  // hls/stages/agreement.hpp:392
  logic [5:0] select_1454;
  assign select_1454 = equal_1336_s3_q ? x_s3_q[5:0] : {region_row_q, or_1453, or_1450, or_1447};
  // hls/stages/agreement.hpp:1082
  logic not_1455;
  assign not_1455 = ~equal_1381;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1457;
  assign sum_1457 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1012
  logic or_1460;
  assign or_1460 = (~sum_1457[5]) | equal_1459_s3_q;
  // hls/stages/agreement.hpp:392
  logic and_1463;
  assign and_1463 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & or_1460));
  // hls/stages/agreement.hpp:243
  logic explained;
  assign explained = inside_v_s3_q[0] & inside_v_s3_q[3];
  logic and_1477;
  assign and_1477 = inside_v_s3_q[0] & ({inside_v_s3_q[4], inside_v_s3_q[2]} == 2'h3);
  logic and_1484;
  assign and_1484 = inside_v_s3_q[0] & inside_v_s3_q[2];
  // hls/stages/agreement.hpp:975
  logic select_1485;
  assign select_1485 = slot_s3_q[2] ? shown_shown_q : inside_v_s3_q[3];
  // hls/stages/agreement.hpp:243
  logic shown;
  assign shown = inside_v_s3_q[0] & (shown_right_rdata_q[0] | select_1485);
  // hls/stages/agreement.hpp:975
  logic select_1488;
  assign select_1488 = slot_s3_q[2] ? shown_nearer_q : inside_v_s3_q[4];
  // hls/stages/agreement.hpp:243
  logic near;
  assign near = inside_v_s3_q[0] & (select_1485 ? select_1488 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1203
  logic select_1491;
  assign select_1491 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1207
  logic select_1492;
  assign select_1492 = left_first_s3_q ? select_1491 : read_half_q;
  logic or_1493;
  assign or_1493 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1208
  logic [8:0] select_1494;
  assign select_1494 = or_1493 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1209
  logic [9:0] select_1496;
  assign select_1496 = left_first_s3_q ? 10'h1 : (or_1493 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1212
  logic and_1497;
  assign and_1497 = select_1494[8] & select_1496[9];
  // hls/stages/agreement.hpp:411
  logic next_row;
  assign next_row = and_1497 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1223
  logic [5:0] select_1500;
  assign select_1500 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1502;
  assign select_1502 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1500});
  // hls/stages/agreement.hpp:1233
  logic equal_1503;
  assign equal_1503 = seen_x_q == 3'h7;
  logic [7:0] select_1505;
  assign select_1505 = and_1497 ? 8'h0 : (seen_column_q + {7'h0, equal_1503});
  // hls/stages/agreement.hpp:1240
  logic [10:0] index;
  assign index = select_1502 + {3'h0, select_1505};
  // hls/stages/agreement.hpp:1193
  logic [11:0] sum_1507;
  assign sum_1507 = {1'b0, {2{select_1492}}, 2'h0, {2{select_1492}}, 1'b0, {2{select_1492}}, 1'b0, select_1492} + {1'b0, index};
  // hls/stages/agreement.hpp:1206
  logic not_1510;
  assign not_1510 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:411
  logic and_1512;
  assign and_1512 = not_1510 & (began_q | and_1497);
  // hls/stages/agreement.hpp:1234
  logic [2:0] select_1514;
  assign select_1514 = and_1497 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1239
  logic and_1516;
  assign and_1516 = and_1512 & (select_1514 == 3'h0);
  logic less_1517;
  assign less_1517 = select_1505 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:413
  logic and_1518;
  assign and_1518 = and_1516 & less_1517;
  logic and_1519;
  assign and_1519 = and_1509_s3_q & and_1518;
  // hls/stages/agreement.hpp:257
  logic select_1521;
  assign select_1521 = and_1509_s3_q ? (left_first_s3_q ? and_1518 : and_1519) : and_1519;
  // hls/stages/agreement.hpp:1065
  logic [7:0] sum_1523;
  assign sum_1523 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1523[7], sum_1523, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1193
  logic [11:0] sum_1525;
  assign sum_1525 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:988
  logic and_1526;
  assign and_1526 = seen_columns_rdata_q[14] & inside_v_s3_q[0];
  logic and_1527;
  assign and_1527 = seen_columns_rdata_q[10] & inside_v_s3_q[0];
  logic and_1528;
  assign and_1528 = seen_columns_rdata_q[5] & inside_v_s3_q[0];
  logic and_1529;
  assign and_1529 = seen_columns_rdata_q[0] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_1531;
  assign sum_1531 = {1'b0, and_1528} + ({1'b0, textured_s3_q} + {1'b0, and_1529});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1526} + ({2'h0, and_1527} + {1'b0, sum_1531});
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_1534;
  assign select_1534 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1535;
  assign difference_1535 = {1'b0, textured_2} - {1'b0, select_1534};
  // hls/stages/agreement.hpp:1046
  logic equal_1536;
  assign equal_1536 = x_s3_q == 8'h0;
  // hls/stages/agreement.hpp:1048
  logic [4:0] t;
  assign t = {difference_1535[3], difference_1535} + (equal_1536 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] select_1541;
  assign select_1541 = inside_v_s3_q[0] ? (sum_1457[5] ? select_1444 : {select_1444[6:0], 1'b0}) : select_1444;
  // hls/stages/agreement.hpp:1004
  logic or_1544;
  assign or_1544 = select_1541[7] | (~({select_1541[5], select_1541[3], select_1541[1]} == 3'h0));
  // hls/stages/agreement.hpp:988
  logic and_1561;
  assign and_1561 = seen_columns_rdata_q[16] & inside_v_s3_q[0];
  logic and_1562;
  assign and_1562 = seen_columns_rdata_q[12] & inside_v_s3_q[0];
  logic and_1563;
  assign and_1563 = seen_columns_rdata_q[8] & inside_v_s3_q[0];
  logic and_1564;
  assign and_1564 = seen_columns_rdata_q[3] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1043
  logic [1:0] sum_1566;
  assign sum_1566 = {1'b0, and_1563} + ({1'b0, shown} + {1'b0, and_1564});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1561} + ({2'h0, and_1562} + {1'b0, sum_1566});
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_1569;
  assign select_1569 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_1570;
  assign difference_1570 = {1'b0, shown_2} - {1'b0, select_1569};
  logic [4:0] around;
  assign around = {difference_1570[3], difference_1570} + (equal_1536 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_1573;
  assign sum_1573 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:988
  logic and_1577;
  assign and_1577 = seen_columns_rdata_q[17] & inside_v_s3_q[0];
  logic and_1578;
  assign and_1578 = seen_columns_rdata_q[13] & inside_v_s3_q[0];
  logic and_1579;
  assign and_1579 = seen_columns_rdata_q[9] & inside_v_s3_q[0];
  logic and_1580;
  assign and_1580 = seen_columns_rdata_q[4] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1044
  logic [1:0] sum_1582;
  assign sum_1582 = {1'b0, and_1579} + ({1'b0, near} + {1'b0, and_1580});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1577} + ({2'h0, and_1578} + {1'b0, sum_1582});
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_1585;
  assign select_1585 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_1586;
  assign difference_1586 = {1'b0, near_2} - {1'b0, select_1585};
  logic [4:0] n;
  assign n = {difference_1586[3], difference_1586} + (equal_1536 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:255
  logic [10:0] select_1637;
  assign select_1637 = sample_pair_whole_s3_q ? (and_365_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1639;
  assign select_1639 = sample_pair_whole_s3_q ? (and_365_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:495
  logic [8:0] select_1663;
  assign select_1663 = and_367_s3_q ? select_373 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1664;
  assign select_1664 = and_367_s3_q ? select_377 : census_columns_values_0_cell_0_right_q;
  logic select_1665;
  assign select_1665 = and_367_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1666;
  assign select_1666 = and_367_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1667;
  assign select_1667 = and_367_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1668;
  assign select_1668 = and_367_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1669;
  assign select_1669 = and_367_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1670;
  assign select_1670 = and_367_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1671;
  assign select_1671 = and_367_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1672;
  assign select_1672 = and_367_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1673;
  assign select_1673 = and_367_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1674;
  assign select_1674 = and_367_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1675;
  assign select_1675 = and_367_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1676;
  assign select_1676 = and_367_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1677;
  assign select_1677 = and_367_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1678;
  assign select_1678 = and_367_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1679;
  assign select_1679 = and_367_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1680;
  assign select_1680 = and_367_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1681;
  assign select_1681 = and_367_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1682;
  assign select_1682 = and_367_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1683;
  assign select_1683 = and_367_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1684;
  assign select_1684 = and_367_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1685;
  assign select_1685 = and_367_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1686;
  assign select_1686 = and_367_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1687;
  assign select_1687 = and_367_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1688;
  assign select_1688 = and_367_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1689;
  assign select_1689 = and_367_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1690;
  assign select_1690 = and_367_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1691;
  assign select_1691 = and_367_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1692;
  assign select_1692 = and_367_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1693;
  assign select_1693 = and_367_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1694;
  assign select_1694 = and_367_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1695;
  assign select_1695 = and_367_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1696;
  assign select_1696 = and_367_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1697;
  assign select_1697 = and_367_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1698;
  assign select_1698 = and_367_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1699;
  assign select_1699 = and_367_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1700;
  assign select_1700 = and_367_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1701;
  assign select_1701 = and_367_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1702;
  assign select_1702 = and_367_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1703;
  assign select_1703 = and_367_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1704;
  assign select_1704 = and_367_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1705;
  assign select_1705 = and_367_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1706;
  assign select_1706 = and_367_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1707;
  assign select_1707 = and_367_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1708;
  assign select_1708 = and_367_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1709;
  assign select_1709 = and_367_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1710;
  assign select_1710 = and_367_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1711;
  assign select_1711 = and_367_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1712;
  assign select_1712 = and_367_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1713;
  assign select_1713 = and_367_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1714;
  assign select_1714 = and_367_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1715;
  assign select_1715 = and_367_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1716;
  assign select_1716 = and_367_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1717;
  assign select_1717 = and_367_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1718;
  assign select_1718 = and_367_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_1720;
  assign difference_1720 = {1'b0, select_377} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1721;
  assign xor_1721 = difference_1720[8:0] ^ {9{difference_1720[9]}};
  logic [9:0] sum_1722;
  assign sum_1722 = {9'h0, difference_1720[9]} + {1'b0, xor_1721};
  logic [9:0] difference_1723;
  assign difference_1723 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1724;
  assign xor_1724 = difference_1723[8:0] ^ {9{difference_1723[9]}};
  logic [9:0] sum_1725;
  assign sum_1725 = {9'h0, difference_1723[9]} + {1'b0, xor_1724};
  logic [9:0] difference_1727;
  assign difference_1727 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1728;
  assign xor_1728 = difference_1727[8:0] ^ {9{difference_1727[9]}};
  logic [9:0] sum_1729;
  assign sum_1729 = {9'h0, difference_1727[9]} + {1'b0, xor_1728};
  logic [10:0] sum_1730;
  assign sum_1730 = ({1'b0, sum_1722} + {1'b0, sum_1725}) + {1'b0, sum_1729};
  logic [9:0] difference_1731;
  assign difference_1731 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1732;
  assign xor_1732 = difference_1731[8:0] ^ {9{difference_1731[9]}};
  logic [9:0] sum_1733;
  assign sum_1733 = {9'h0, difference_1731[9]} + {1'b0, xor_1732};
  logic [9:0] difference_1735;
  assign difference_1735 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1736;
  assign xor_1736 = difference_1735[8:0] ^ {9{difference_1735[9]}};
  logic [9:0] sum_1737;
  assign sum_1737 = {9'h0, difference_1735[9]} + {1'b0, xor_1736};
  // hls/stages/census.hpp:353
  logic [9:0] difference_1765;
  assign difference_1765 = {1'b0, select_373} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1765[9]} + (difference_1765[8:0] ^ {9{difference_1765[9]}});
  logic [9:0] difference_1776;
  assign difference_1776 = {1'b0, select_377} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1776[9]} + (difference_1776[8:0] ^ {9{difference_1776[9]}});
  // hls/stages/agreement.hpp:495
  logic and_1983;
  assign and_1983 = and_367_s3_q & (equal_428_s3_q & equal_1866_s3_q);
  // hls/stages/agreement.hpp:392
  logic and_1986;
  assign and_1986 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & inside_v_s3_q[1]));
  // hls/stages/agreement.hpp:988
  logic and_2007;
  assign and_2007 = seen_columns_rdata_q[15] & inside_v_s3_q[0];
  logic and_2008;
  assign and_2008 = seen_columns_rdata_q[11] & inside_v_s3_q[0];
  logic and_2009;
  assign and_2009 = seen_columns_rdata_q[7] & inside_v_s3_q[0];
  logic and_2010;
  assign and_2010 = seen_columns_rdata_q[2] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_2012;
  assign sum_2012 = {1'b0, and_2009} + ({1'b0, explained} + {1'b0, and_2010});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2007} + ({2'h0, and_2008} + {1'b0, sum_2012});
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2015;
  assign select_2015 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2016;
  assign difference_2016 = {1'b0, explained_2} - {1'b0, select_2015};
  logic [4:0] e;
  assign e = {difference_2016[3], difference_2016} + (equal_1536 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1056
  logic [5:0] sum_2019;
  assign sum_2019 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:392
  logic and_2047;
  assign and_2047 = ends_cell_s3_q & (inside_v_s3_q[0] & (inside_v_s3_q[2:1] == 2'h3));
  // hls/stages/registration.hpp:83
  logic equal_2091;
  assign equal_2091 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:213
  logic [16:0] select_2093;
  assign select_2093 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2093[16:7])) ? 8'h7f : select_2093[7:0];
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2091 ? registration_slope_here_q : change;
  // hls/stages/registration.hpp:208
  logic [7:0] select_2097;
  assign select_2097 = inside_v_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2098;
  assign select_2098 = inside_v_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2099;
  assign difference_2099 = {{2{select_2097[7]}}, select_2097[7:1]} - {select_2098[7], select_2098};
  // hls/stages/registration.hpp:206
  logic [6:0] select_2100;
  assign select_2100 = inside_v_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2101;
  assign select_2101 = inside_v_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2102;
  assign sum_2102 = {{2{select_2100[6]}}, select_2100} + {select_2101[7], select_2101};
  // hls/stages/registration.hpp:207
  logic [7:0] select_2103;
  assign select_2103 = inside_v_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2104;
  assign select_2104 = inside_v_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2105;
  assign sum_2105 = {{2{select_2103[7]}}, select_2103[7:1]} + {select_2104[7], select_2104};
  // hls/stages/registration.hpp:209
  logic [10:0] sum_2106;
  assign sum_2106 = {{3{sum_2102[8]}}, sum_2102[8:1]} + {sum_2105[8], sum_2105, select_2103[0]};
  logic [9:0] sum_2107;
  assign sum_2107 = {difference_2099, select_2097[0]} + {sum_2106[10], sum_2106[10:2]};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2108;
  assign sum_2108 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_2107[9]}}, sum_2107[9:2]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2111;
  assign select_2111 = ($signed(sum_2108[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2108[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] select_2113;
  assign select_2113 = equal_2091 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2108[12:7])) ? 8'h7f : select_2111);
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2115;
  assign select_2115 = equal_1336_s3_q ? registration_slope_here_q : (so_s3_q ? select_2113 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2116;
  assign equal_2116 = slot_s3_q == 3'h4;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2125;
  assign sum_2125 = inside_v_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2127;
  assign difference_2127 = {sum_2125, inside_v_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2128;
  assign select_2128 = less_2126_s3_q ? difference_2127 : {sum_2125, inside_v_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2129;
  assign select_2129 = ((inside_v_s3_q[13:11] == 3'h0) | (inside_v_s3_q[13:11] == 3'h4)) ? {sum_2125, inside_v_s3_q[11], 5'h0} : select_2128;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2129[7]}}, select_2129} - {sum_2107[9], sum_2107, sum_2106[1]};
  // hls/stages/registration.hpp:213
  logic [11:0] select_2132;
  assign select_2132 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2132[11:7])) ? 12'h7f : select_2132;
  // hls/stages/agreement.hpp:392
  logic select_2176;
  assign select_2176 = so_s3_q ? (equal_2116 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2179;
  assign select_2179 = so_s3_q ? (equal_2091 ? inside_v_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:264
  logic [3:0] select_2184;
  assign select_2184 = (sum_1387 == 2'h2) ? (registration_fresh_q & (~select_1431)) : registration_fresh_q;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_2186;
  assign select_2186 = so_s3_q ? (and_1426 ? select_2184 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:237
  logic [3:0] select_2188;
  assign select_2188 = and_1983 ? 4'hf : (equal_1336_s3_q ? registration_fresh_q : select_2186);
  // hls/stages/registration.hpp:128
  logic [15:0] select_2195;
  assign select_2195 = and_2194_s3_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2197;
  assign select_2197 = and_2192_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2195[15]}}, select_2195});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2198;
  assign select_2198 = and_2194_s3_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2198[15]}}, select_2198};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2200;
  assign select_2200 = and_2192_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:137
  logic and_2201;
  assign and_2201 = ends_cell_s3_q & so_s3_q;
  // hls/stages/registration.hpp:124
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2201 ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:1083
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1384;
  // hls/stages/registration.hpp:253
  logic not_2209;
  assign not_2209 = ~quarter_2[1];
  logic [3:0] select_2210;
  assign select_2210 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2209, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2209};
  // hls/stages/agreement.hpp:392
  logic select_2298;
  assign select_2298 = equal_1336_s3_q ? shown_shown_q : (so_s3_q ? select_1485 : shown_shown_q);
  logic select_2300;
  assign select_2300 = equal_1336_s3_q ? shown_nearer_q : (so_s3_q ? select_1488 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2302;
  assign sum_2302 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:436
  logic [2:0] select_2304;
  assign select_2304 = less_2301_s3_q ? (sum_2302[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2306;
  assign select_2306 = equal_1866_s3_q ? (equal_428_s3_q ? 3'h0 : select_2304) : region_row_q;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2311;
  assign select_2311 = equal_1336_s3_q ? select_1444 : (so_s3_q ? (ends_cell_s3_q ? select_1541 : select_1444) : 8'h1);
  // hls/stages/agreement.hpp:190
  logic [8:0] select_2313;
  assign select_2313 = so_s3_q ? (and_2201 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_2315;
  assign sum_2315 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2316;
  assign select_2316 = sum_1457[5] ? {1'b1, sum_1457[4:0], region_across_rest_q[2:0]} : sum_2315;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_2318;
  assign select_2318 = equal_1866_s3_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_2321;
  assign select_2321 = equal_1866_s3_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  logic [8:0] select_2325;
  assign select_2325 = equal_428_s3_q ? {{2{difference_2323[6]}}, difference_2323} : (less_2301_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:495
  logic [8:0] select_2327;
  assign select_2327 = and_367_s3_q ? (equal_1866_s3_q ? select_2325 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:436
  logic [6:0] select_2329;
  assign select_2329 = equal_428_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2331;
  assign select_2331 = and_367_s3_q ? (equal_1866_s3_q ? select_2329 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2332;
  assign sum_2332 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2333;
  assign select_2333 = sum_2302[7] ? {1'b1, sum_2302[6:0], region_down_rest_q[0]} : sum_2332;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2302[7];
  // hls/stages/agreement.hpp:436
  logic select_2337;
  assign select_2337 = equal_1866_s3_q ? (equal_428_s3_q | (less_2301_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:190
  logic or_2342;
  assign or_2342 = segment_starts_q | not_1376;
  // hls/stages/agreement.hpp:988
  logic select_2345;
  assign select_2345 = inside_v_s3_q[0] ? (sum_1457[5] ? (equal_1459_s3_q & or_1460) : or_1460) : or_2342;
  // hls/stages/agreement.hpp:392
  logic select_2348;
  assign select_2348 = equal_1336_s3_q ? or_2342 : (so_s3_q ? (ends_cell_s3_q ? select_2345 : or_2342) : or_2342);
  // hls/stages/agreement.hpp:1095
  logic equal_2373;
  assign equal_2373 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:392
  logic [2:0] select_2424;
  assign select_2424 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_2426;
  assign select_2426 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2428;
  assign select_2428 = equal_1336_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_2426 : box_textured_columns_values_1_q);
  logic [2:0] select_2429;
  assign select_2429 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2431;
  assign select_2431 = equal_1336_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_2429 : box_textured_columns_values_2_q);
  logic [2:0] select_2432;
  assign select_2432 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2434;
  assign select_2434 = equal_1336_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_2432 : box_textured_columns_values_3_q);
  logic [2:0] select_2435;
  assign select_2435 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2437;
  assign select_2437 = equal_1336_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_2435 : box_textured_columns_values_4_q);
  logic [4:0] select_2439;
  assign select_2439 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_2442;
  assign select_2442 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_2444;
  assign select_2444 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2446;
  assign select_2446 = equal_1336_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_2444 : box_explained_columns_values_1_q);
  logic [2:0] select_2447;
  assign select_2447 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2449;
  assign select_2449 = equal_1336_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_2447 : box_explained_columns_values_2_q);
  logic [2:0] select_2450;
  assign select_2450 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2452;
  assign select_2452 = equal_1336_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_2450 : box_explained_columns_values_3_q);
  logic [2:0] select_2453;
  assign select_2453 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2455;
  assign select_2455 = equal_1336_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_2453 : box_explained_columns_values_4_q);
  logic [4:0] select_2457;
  assign select_2457 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2458;
  assign select_2458 = equal_1336_s3_q ? box_explained_sum_sums_values_0_q : select_2457;
  logic [2:0] select_2460;
  assign select_2460 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2462;
  assign select_2462 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2464;
  assign select_2464 = equal_1336_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_2462 : box_shown_columns_values_1_q);
  logic [2:0] select_2465;
  assign select_2465 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2467;
  assign select_2467 = equal_1336_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_2465 : box_shown_columns_values_2_q);
  logic [2:0] select_2468;
  assign select_2468 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2470;
  assign select_2470 = equal_1336_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_2468 : box_shown_columns_values_3_q);
  logic [2:0] select_2471;
  assign select_2471 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2473;
  assign select_2473 = equal_1336_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_2471 : box_shown_columns_values_4_q);
  logic [4:0] select_2475;
  assign select_2475 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_2478;
  assign select_2478 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2480;
  assign select_2480 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2482;
  assign select_2482 = equal_1336_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_2480 : box_nearer_columns_values_1_q);
  logic [2:0] select_2483;
  assign select_2483 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2485;
  assign select_2485 = equal_1336_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_2483 : box_nearer_columns_values_2_q);
  logic [2:0] select_2486;
  assign select_2486 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2488;
  assign select_2488 = equal_1336_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_2486 : box_nearer_columns_values_3_q);
  logic [2:0] select_2489;
  assign select_2489 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2491;
  assign select_2491 = equal_1336_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_2489 : box_nearer_columns_values_4_q);
  logic [4:0] select_2493;
  assign select_2493 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_2496;
  assign select_2496 = so_s3_q ? (ends_cell_s3_q ? and_1528 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2499;
  assign select_2499 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & inside_v_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_2501;
  assign select_2501 = equal_1336_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_2499 : centres_values_0_of_skin_q);
  logic select_2502;
  assign select_2502 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2504;
  assign select_2504 = equal_1336_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_2502 : centres_values_1_textured_q);
  logic select_2505;
  assign select_2505 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2507;
  assign select_2507 = equal_1336_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_2505 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:436
  logic [10:0] select_2511;
  assign select_2511 = equal_1866_s3_q ? (equal_2508_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:495
  logic [5:0] select_2514;
  assign select_2514 = and_367_s3_q ? (equal_1866_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1203
  logic xor_2515;
  assign xor_2515 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:413
  logic select_2517;
  assign select_2517 = and_1509_s3_q ? (left_first_s3_q ? xor_2515 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:257
  logic select_2519;
  assign select_2519 = and_1509_s3_q ? (left_first_s3_q ? xor_2515 : select_2517) : write_half_q;
  logic select_2521;
  assign select_2521 = left_first_s3_q ? select_1491 : (and_1509_s3_q ? select_1492 : read_half_q);
  logic and_2525;
  assign and_2525 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_2534;
  assign select_2534 = left_first_s3_q ? 10'h1 : (and_1509_s3_q ? select_1496 : rows_passed_q);
  logic [8:0] select_2537;
  assign select_2537 = left_first_s3_q ? {select_1494[7:0], or_1493} : (and_1509_s3_q ? {select_1494[7:0], or_1493} : columns_passed_q);
  logic select_2540;
  assign select_2540 = left_first_s3_q ? marks_last_s3_q : (and_1509_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_2543;
  assign select_2543 = left_first_s3_q ? and_1512 : (and_1509_s3_q ? and_1512 : began_q);
  logic [2:0] select_2546;
  assign select_2546 = left_first_s3_q ? select_1514 : (and_1509_s3_q ? select_1514 : seen_x_q);
  // hls/stages/agreement.hpp:1232
  logic [2:0] select_2551;
  assign select_2551 = left_first_s3_q ? 3'h0 : (and_1497 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:257
  logic [2:0] select_2553;
  assign select_2553 = left_first_s3_q ? 3'h0 : (and_1509_s3_q ? select_2551 : seen_y_q);
  logic [7:0] select_2556;
  assign select_2556 = left_first_s3_q ? select_1505 : (and_1509_s3_q ? select_1505 : seen_column_q);
  // hls/stages/agreement.hpp:411
  logic [7:0] select_2562;
  assign select_2562 = left_first_s3_q ? select_2560 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:257
  logic [7:0] select_2564;
  assign select_2564 = left_first_s3_q ? select_2560 : (and_1509_s3_q ? select_2562 : seen_rows_left_q);
  // hls/stages/agreement.hpp:411
  logic and_2569;
  assign and_2569 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:257
  logic select_2571;
  assign select_2571 = left_first_s3_q ? and_2569 : (and_1509_s3_q ? and_2569 : at_cell_end_q);
  logic select_2574;
  assign select_2574 = left_first_s3_q ? next_row : (and_1509_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_2577;
  assign select_2577 = left_first_s3_q ? 11'h0 : (and_1509_s3_q ? select_1502 : seen_base_q);
  // hls/stages/registration.hpp:253
  logic not_2638;
  assign not_2638 = ~quarter[1];
  logic [3:0] select_2639;
  assign select_2639 = quarter[0] ? {quarter[1], 1'b0, not_2638, 1'b0} : {1'b0, quarter[1], 1'b0, not_2638};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:271; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1388;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & (equal_1336_s3_q ? (x_s3_q[6] & select_1416) : and_1427);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1322; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1454;
  logic regions_re;
  assign regions_re = s3_en & (equal_1336_s3_q ? (x_s3_q[6] & not_1455) : and_1463);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1333; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1507;
  logic map_re;
  assign map_re = s3_en & select_1521;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory census_memory, write
  logic [5:0] census_memory_waddr;
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_367_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_385_s3_q, whole_2_s3_q, select_377, select_373};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 6'd47) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 6'd47) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory shown_right, write
  logic [5:0] shown_right_waddr;
  assign shown_right_waddr = select_1375_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1380_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1377, not_1376};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 6'd47) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 6'd47) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_1371_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1484, textured_s3_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 6'd47) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 6'd47) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      registration_fresh_q <= 4'hf;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 7'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 7'h0;
      region_down_next_q <= 9'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
      map_row_q <= 11'h0;
      map_width_q <= 6'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
      rows_passed_q <= 10'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
      began_q <= 1'b0;
      seen_x_q <= 3'h0;
      seen_y_q <= 3'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 11'h0;
    end else if (s3_en) begin
      census_filled_q <= and_367_s3_q ? {select_431[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_367_s3_q ? select_430 : rows_passed_above_q;
      registration_slope_here_q <= select_2115;
      registration_of_right_q <= equal_1336_s3_q ? registration_of_right_q : select_2176;
      registration_was_inside_q <= equal_1336_s3_q ? registration_was_inside_q : select_2179;
      registration_fresh_q <= select_2188;
      registration_slope_row_q <= select_2197;
      registration_slope_change_q <= select_2200;
      registration_slope_q <= so_s3_q ? column_5 : {registration_slope_row_q, 4'h0};
      shown_shown_q <= select_2298;
      shown_nearer_q <= select_2300;
      region_row_q <= and_367_s3_q ? select_2306 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_2311;
      region_across_rest_q <= select_2313;
      region_across_back_q <= so_s3_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2316;
      columns_begin_rest_q <= and_367_s3_q ? select_2318 : columns_begin_rest_q;
      columns_begin_back_q <= and_367_s3_q ? select_2321 : columns_begin_back_q;
      region_down_rest_q <= select_2327;
      region_down_back_q <= select_2331;
      region_down_next_q <= select_2333;
      region_fresh_q <= and_367_s3_q ? select_2337 : region_fresh_q;
      segment_starts_q <= select_2348;
      centres_values_0_textured_q <= equal_1336_s3_q ? centres_values_0_textured_q : select_2496;
      centres_values_0_of_skin_q <= select_2501;
      centres_values_1_textured_q <= select_2504;
      centres_values_1_of_skin_q <= select_2507;
      map_row_q <= and_367_s3_q ? select_2511 : map_row_q;
      map_width_q <= select_2514;
      write_half_q <= select_2519;
      read_half_q <= and_1509_s3_q ? select_2521 : read_half_q;
      done_q <= and_1509_s3_q ? (not_1510 & and_2525) : and_2525;
      drew_q <= so_s3_q;
      said_q <= equal_1336_s3_q & equal_2373;
      rows_passed_q <= and_1509_s3_q ? select_2534 : rows_passed_q;
      columns_passed_q <= and_1509_s3_q ? select_2537 : columns_passed_q;
      line_ended_q <= and_1509_s3_q ? select_2540 : line_ended_q;
      began_q <= and_1509_s3_q ? select_2543 : began_q;
      seen_x_q <= and_1509_s3_q ? select_2546 : seen_x_q;
      seen_y_q <= and_1509_s3_q ? select_2553 : seen_y_q;
      seen_column_q <= and_1509_s3_q ? select_2556 : seen_column_q;
      seen_rows_left_q <= and_1509_s3_q ? select_2564 : seen_rows_left_q;
      at_cell_end_q <= and_1509_s3_q ? select_2571 : at_cell_end_q;
      was_next_row_q <= and_1509_s3_q ? select_2574 : was_next_row_q;
      seen_base_q <= and_1509_s3_q ? select_2577 : seen_base_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
    census_columns_values_0_cell_0_left_q = 9'h0;
    census_columns_values_0_cell_0_right_q = 9'h0;
    census_columns_values_0_cell_0_mask_q = 1'b0;
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
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_1_left_q = 9'h0;
    census_columns_values_1_cell_1_right_q = 9'h0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_2_left_q = 9'h0;
    census_columns_values_1_cell_2_right_q = 9'h0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_1_cell_2_of_skin_q = 1'b0;
    census_columns_values_1_cell_3_left_q = 9'h0;
    census_columns_values_1_cell_3_right_q = 9'h0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_4_left_q = 9'h0;
    census_columns_values_1_cell_4_right_q = 9'h0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_0_left_q = 9'h0;
    census_columns_values_2_cell_0_right_q = 9'h0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_1_left_q = 9'h0;
    census_columns_values_2_cell_1_right_q = 9'h0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
    census_columns_values_2_cell_2_left_q = 9'h0;
    census_columns_values_2_cell_2_right_q = 9'h0;
    census_columns_values_2_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_3_left_q = 9'h0;
    census_columns_values_2_cell_3_right_q = 9'h0;
    census_columns_values_2_cell_3_mask_q = 1'b0;
    census_columns_values_2_cell_4_left_q = 9'h0;
    census_columns_values_2_cell_4_right_q = 9'h0;
    census_columns_values_2_cell_4_mask_q = 1'b0;
    census_columns_values_3_cell_0_mask_q = 1'b0;
    census_columns_values_3_cell_1_left_q = 9'h0;
    census_columns_values_3_cell_1_right_q = 9'h0;
    census_columns_values_3_cell_1_mask_q = 1'b0;
    census_columns_values_3_cell_2_mask_q = 1'b0;
    census_columns_values_3_cell_3_left_q = 9'h0;
    census_columns_values_3_cell_3_right_q = 9'h0;
    census_columns_values_3_cell_3_mask_q = 1'b0;
    census_columns_values_3_cell_4_mask_q = 1'b0;
    sharpness_last_mean_0_q = 9'h0;
    sharpness_last_mean_1_q = 9'h0;
    box_textured_columns_values_0_q = 3'h0;
    box_textured_columns_values_1_q = 3'h0;
    box_textured_columns_values_2_q = 3'h0;
    box_textured_columns_values_3_q = 3'h0;
    box_textured_columns_values_4_q = 3'h0;
    box_textured_sum_sums_values_0_q = 5'h0;
    box_explained_columns_values_0_q = 3'h0;
    box_explained_columns_values_1_q = 3'h0;
    box_explained_columns_values_2_q = 3'h0;
    box_explained_columns_values_3_q = 3'h0;
    box_explained_columns_values_4_q = 3'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_shown_columns_values_0_q = 3'h0;
    box_shown_columns_values_1_q = 3'h0;
    box_shown_columns_values_2_q = 3'h0;
    box_shown_columns_values_3_q = 3'h0;
    box_shown_columns_values_4_q = 3'h0;
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_columns_values_0_q = 3'h0;
    box_nearer_columns_values_1_q = 3'h0;
    box_nearer_columns_values_2_q = 3'h0;
    box_nearer_columns_values_3_q = 3'h0;
    box_nearer_columns_values_4_q = 3'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      averager_total_0_q <= select_1637;
      averager_total_1_q <= select_1639;
      census_columns_values_0_cell_0_left_q <= select_1663;
      census_columns_values_0_cell_0_right_q <= select_1664;
      census_columns_values_0_cell_0_mask_q <= select_1665;
      census_columns_values_0_cell_1_left_q <= select_1666;
      census_columns_values_0_cell_1_right_q <= select_1667;
      census_columns_values_0_cell_1_mask_q <= select_1668;
      census_columns_values_0_cell_2_left_q <= select_1669;
      census_columns_values_0_cell_2_right_q <= select_1670;
      census_columns_values_0_cell_2_mask_q <= select_1671;
      census_columns_values_0_cell_2_of_skin_q <= select_1672;
      census_columns_values_0_cell_3_left_q <= select_1673;
      census_columns_values_0_cell_3_right_q <= select_1674;
      census_columns_values_0_cell_3_mask_q <= select_1675;
      census_columns_values_0_cell_4_left_q <= select_1676;
      census_columns_values_0_cell_4_right_q <= select_1677;
      census_columns_values_0_cell_4_mask_q <= select_1678;
      census_columns_values_1_cell_0_left_q <= select_1679;
      census_columns_values_1_cell_0_right_q <= select_1680;
      census_columns_values_1_cell_0_mask_q <= select_1681;
      census_columns_values_1_cell_1_left_q <= select_1682;
      census_columns_values_1_cell_1_right_q <= select_1683;
      census_columns_values_1_cell_1_mask_q <= select_1684;
      census_columns_values_1_cell_2_left_q <= select_1685;
      census_columns_values_1_cell_2_right_q <= select_1686;
      census_columns_values_1_cell_2_mask_q <= select_1687;
      census_columns_values_1_cell_2_of_skin_q <= select_1688;
      census_columns_values_1_cell_3_left_q <= select_1689;
      census_columns_values_1_cell_3_right_q <= select_1690;
      census_columns_values_1_cell_3_mask_q <= select_1691;
      census_columns_values_1_cell_4_left_q <= select_1692;
      census_columns_values_1_cell_4_right_q <= select_1693;
      census_columns_values_1_cell_4_mask_q <= select_1694;
      census_columns_values_2_cell_0_left_q <= select_1695;
      census_columns_values_2_cell_0_right_q <= select_1696;
      census_columns_values_2_cell_0_mask_q <= select_1697;
      census_columns_values_2_cell_1_left_q <= select_1698;
      census_columns_values_2_cell_1_right_q <= select_1699;
      census_columns_values_2_cell_1_mask_q <= select_1700;
      census_columns_values_2_cell_2_left_q <= select_1701;
      census_columns_values_2_cell_2_right_q <= select_1702;
      census_columns_values_2_cell_2_mask_q <= select_1703;
      census_columns_values_2_cell_3_left_q <= select_1704;
      census_columns_values_2_cell_3_right_q <= select_1705;
      census_columns_values_2_cell_3_mask_q <= select_1706;
      census_columns_values_2_cell_4_left_q <= select_1707;
      census_columns_values_2_cell_4_right_q <= select_1708;
      census_columns_values_2_cell_4_mask_q <= select_1709;
      census_columns_values_3_cell_0_mask_q <= select_1710;
      census_columns_values_3_cell_1_left_q <= select_1711;
      census_columns_values_3_cell_1_right_q <= select_1712;
      census_columns_values_3_cell_1_mask_q <= select_1713;
      census_columns_values_3_cell_2_mask_q <= select_1714;
      census_columns_values_3_cell_3_left_q <= select_1715;
      census_columns_values_3_cell_3_right_q <= select_1716;
      census_columns_values_3_cell_3_mask_q <= select_1717;
      census_columns_values_3_cell_4_mask_q <= select_1718;
      sharpness_last_mean_0_q <= and_367_s3_q ? select_373 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_367_s3_q ? select_377 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1336_s3_q ? box_textured_columns_values_0_q : select_2424;
      box_textured_columns_values_1_q <= select_2428;
      box_textured_columns_values_2_q <= select_2431;
      box_textured_columns_values_3_q <= select_2434;
      box_textured_columns_values_4_q <= select_2437;
      box_textured_sum_sums_values_0_q <= equal_1336_s3_q ? box_textured_sum_sums_values_0_q : select_2439;
      box_explained_columns_values_0_q <= equal_1336_s3_q ? box_explained_columns_values_0_q : select_2442;
      box_explained_columns_values_1_q <= select_2446;
      box_explained_columns_values_2_q <= select_2449;
      box_explained_columns_values_3_q <= select_2452;
      box_explained_columns_values_4_q <= select_2455;
      box_explained_sum_sums_values_0_q <= select_2458;
      box_shown_columns_values_0_q <= equal_1336_s3_q ? box_shown_columns_values_0_q : select_2460;
      box_shown_columns_values_1_q <= select_2464;
      box_shown_columns_values_2_q <= select_2467;
      box_shown_columns_values_3_q <= select_2470;
      box_shown_columns_values_4_q <= select_2473;
      box_shown_sum_sums_values_0_q <= equal_1336_s3_q ? box_shown_sum_sums_values_0_q : select_2475;
      box_nearer_columns_values_0_q <= equal_1336_s3_q ? box_nearer_columns_values_0_q : select_2478;
      box_nearer_columns_values_1_q <= select_2482;
      box_nearer_columns_values_2_q <= select_2485;
      box_nearer_columns_values_3_q <= select_2488;
      box_nearer_columns_values_4_q <= select_2491;
      box_nearer_sum_sums_values_0_q <= equal_1336_s3_q ? box_nearer_sum_sums_values_0_q : select_2493;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic left_first_s4_q;
  logic sample_pair_whole_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [7:0] x_s4_q;
  logic [2:0] slot_s4_q;
  logic ends_cell_s4_q;
  logic lower_half_s4_q;
  logic registration_of_right_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic centres_values_1_textured_s4_q;
  logic centres_values_1_of_skin_s4_q;
  logic done_s4_q;
  logic [5:0] column_s4_q;
  logic and_365_s4_q;
  logic and_367_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_370_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic less_401_s4_q;
  logic less_402_s4_q;
  logic less_403_s4_q;
  logic less_404_s4_q;
  logic less_405_s4_q;
  logic less_406_s4_q;
  logic less_407_s4_q;
  logic less_408_s4_q;
  logic less_409_s4_q;
  logic less_410_s4_q;
  logic less_411_s4_q;
  logic less_412_s4_q;
  logic less_413_s4_q;
  logic less_414_s4_q;
  logic less_415_s4_q;
  logic less_416_s4_q;
  logic less_417_s4_q;
  logic less_418_s4_q;
  logic less_419_s4_q;
  logic less_420_s4_q;
  logic less_421_s4_q;
  logic less_422_s4_q;
  logic less_423_s4_q;
  logic less_424_s4_q;
  logic and_432_s4_q;
  logic and_457_s4_q;
  logic and_458_s4_q;
  logic [11:0] texture_s4_q;
  logic equal_1336_s4_q;
  logic not_1337_s4_q;
  logic equal_1381_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1387_s4_q;
  logic equal_1389_s4_q;
  logic equal_1391_s4_q;
  logic equal_1393_s4_q;
  logic equal_1395_s4_q;
  logic equal_1397_s4_q;
  logic equal_1399_s4_q;
  logic equal_1401_s4_q;
  logic less_1409_s4_q;
  logic or_1413_s4_q;
  logic equal_1433_s4_q;
  logic and_1443_s4_q;
  logic or_1447_s4_q;
  logic or_1450_s4_q;
  logic or_1453_s4_q;
  logic not_1455_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1477_s4_q;
  logic and_1482_s4_q;
  logic and_1509_s4_q;
  logic and_1516_s4_q;
  logic less_1517_s4_q;
  logic [11:0] sum_1525_s4_q;
  logic equal_1539_s4_q;
  logic or_1544_s4_q;
  logic or_1547_s4_q;
  logic or_1550_s4_q;
  logic not_1575_s4_q;
  logic less_1589_s4_q;
  logic and_1600_s4_q;
  logic [11:0] sum_1738_s4_q;
  logic equal_1745_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_1983_s4_q;
  logic and_1987_s4_q;
  logic not_2021_s4_q;
  logic and_2049_s4_q;
  logic equal_2091_s4_q;
  logic and_2119_s4_q;
  logic and_2121_s4_q;
  logic [11:0] residual_s4_q;
  logic equal_2212_s4_q;
  logic equal_2373_s4_q;
  logic and_2580_s4_q;
  logic equal_2641_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      left_first_s4_q <= left_first_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s4_q <= x_s3_q;
      slot_s4_q <= slot_s3_q;
      ends_cell_s4_q <= ends_cell_s3_q;
      lower_half_s4_q <= lower_half_s3_q;
      registration_of_right_s4_q <= registration_of_right_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      done_s4_q <= done_q;
      column_s4_q <= column_s3_q;
      and_365_s4_q <= and_365_s3_q;
      and_367_s4_q <= and_367_s3_q;
      grey_s4_q <= grey_s3_q;
      equal_370_s4_q <= equal_370_s3_q;
      grey_2_s4_q <= grey_2_s3_q;
      whole_2_s4_q <= whole_2_s3_q;
      less_401_s4_q <= less_401;
      less_402_s4_q <= less_402;
      less_403_s4_q <= less_403;
      less_404_s4_q <= less_404;
      less_405_s4_q <= less_405;
      less_406_s4_q <= less_406;
      less_407_s4_q <= less_407;
      less_408_s4_q <= less_408;
      less_409_s4_q <= less_409;
      less_410_s4_q <= less_410;
      less_411_s4_q <= less_411;
      less_412_s4_q <= less_412;
      less_413_s4_q <= less_413;
      less_414_s4_q <= less_414;
      less_415_s4_q <= less_415;
      less_416_s4_q <= less_416;
      less_417_s4_q <= less_417;
      less_418_s4_q <= less_418;
      less_419_s4_q <= less_419;
      less_420_s4_q <= less_420;
      less_421_s4_q <= less_421;
      less_422_s4_q <= less_422;
      less_423_s4_q <= less_423;
      less_424_s4_q <= less_424;
      and_432_s4_q <= and_432;
      and_457_s4_q <= whole_22 & and_432;
      and_458_s4_q <= census_columns_values_1_cell_2_mask_q & and_432;
      texture_s4_q <= texture;
      equal_1336_s4_q <= equal_1336_s3_q;
      not_1337_s4_q <= not_1337_s3_q;
      equal_1381_s4_q <= equal_1381;
      all_s4_q <= all;
      sum_1387_s4_q <= sum_1387;
      equal_1389_s4_q <= equal_1389;
      equal_1391_s4_q <= equal_1391;
      equal_1393_s4_q <= equal_1393;
      equal_1395_s4_q <= equal_1395;
      equal_1397_s4_q <= equal_1397;
      equal_1399_s4_q <= equal_1399;
      equal_1401_s4_q <= equal_1401;
      less_1409_s4_q <= less_1409;
      or_1413_s4_q <= or_1413;
      equal_1433_s4_q <= (registration_fresh_q & select_1431) == 4'h0;
      and_1443_s4_q <= not_1337_s3_q & and_1427;
      or_1447_s4_q <= or_1447;
      or_1450_s4_q <= or_1450;
      or_1453_s4_q <= or_1453;
      not_1455_s4_q <= not_1455;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1477_s4_q <= and_1477;
      and_1482_s4_q <= not_1337_s3_q & and_1463;
      and_1509_s4_q <= and_1509_s3_q;
      and_1516_s4_q <= and_1516;
      less_1517_s4_q <= less_1517;
      sum_1525_s4_q <= sum_1525;
      equal_1539_s4_q <= t[4:1] == 4'h0;
      or_1544_s4_q <= or_1544;
      or_1547_s4_q <= select_1541[7] | (~({select_1541[6], select_1541[3:2]} == 3'h0));
      or_1550_s4_q <= select_1541[7] | (~(select_1541[6:4] == 3'h0));
      not_1575_s4_q <= ~({sum_1573, around[0]} < {2'h0, t});
      less_1589_s4_q <= {1'b0, around[4:1]} < n;
      and_1600_s4_q <= and_1600_s3_q;
      sum_1738_s4_q <= ({1'b0, sum_1730} + {2'h0, sum_1733}) + {2'h0, sum_1737};
      equal_1745_s4_q <= equal_1745_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_1983_s4_q <= and_1983;
      and_1987_s4_q <= not_1337_s3_q & and_1986;
      not_2021_s4_q <= ~({sum_2019, e[0]} < {2'h0, t});
      and_2049_s4_q <= not_1337_s3_q & (so_s3_q & and_2047);
      equal_2091_s4_q <= equal_2091;
      and_2119_s4_q <= not_1337_s3_q & (so_s3_q & (half_ends & equal_2116));
      and_2121_s4_q <= and_2121_s3_q;
      residual_s4_q <= residual;
      equal_2212_s4_q <= (registration_fresh_q & select_2210) == 4'h0;
      equal_2373_s4_q <= equal_2373;
      and_2580_s4_q <= and_1600_s3_q & (sum_1525 == sum_1507);
      equal_2641_s4_q <= (registration_fresh_q & select_2639) == 4'h0;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_quarter_1_0_q;
  logic [8:0] averager_quarter_1_1_q;
  logic [8:0] averager_quarter_2_0_q;
  logic [8:0] averager_quarter_2_1_q;
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [19:0] census_left_misses_q;
  logic sharpness_last_mask_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_explained_q;
  logic [13:0] counts_nearer_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
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
  logic registration_moved_q;
  logic [5:0] segment_textured_q;
  logic [5:0] segment_explained_q;
  logic [5:0] segment_nearer_q;
  logic segment_started_q;
  logic [47:0] good_q;
  logic good_known_q;
  logic [7:0] hidden_for_q;
  logic [13:0] product_q;
  logic product_rest_q;
  logic disagree_q;
  logic too_much_q;
  logic hides_q;
  logic proven_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:281
  logic [12:0] sum_478;
  assign sum_478 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_480;
  assign sum_480 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_478});
  // hls/stages/census.hpp:303
  logic less_481;
  assign less_481 = 9'h4 < sum_480[13:5];
  logic and_482;
  assign and_482 = and_432_s4_q & less_481;
  // hls/stages/registration.hpp:260
  logic equal_1435;
  assign equal_1435 = sum_1387_s4_q == 2'h0;
  // hls/stages/registration.hpp:258
  logic [6:0] down;
  assign down = sum_1387_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:260
  logic [13:0] select_1437;
  assign select_1437 = equal_1435 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1438;
  assign sum_1438 = (equal_1433_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1437[13]}}, select_1437};
  // hls/stages/registration.hpp:259
  logic [6:0] up;
  assign up = sum_1387_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:261
  logic [6:0] select_1441;
  assign select_1441 = equal_1435 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1442;
  assign sum_1442 = (equal_1433_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1441[6]}}, select_1441};
  // hls/stages/agreement.hpp:881
  logic [5:0] select_1467;
  assign select_1467 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:882
  logic [5:0] sum_1468;
  assign sum_1468 = {5'h0, textured_s4_q} + select_1467;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_1470;
  assign sum_1470 = {4'h0, sum_1468} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:881
  logic [5:0] select_1472;
  assign select_1472 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:882
  logic [5:0] sum_1473;
  assign sum_1473 = {5'h0, explained_s4_q} + select_1472;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_1475;
  assign sum_1475 = {4'h0, sum_1473} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:881
  logic [5:0] select_1478;
  assign select_1478 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:883
  logic [5:0] sum_1479;
  assign sum_1479 = {5'h0, and_1477_s4_q} + select_1478;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_1481;
  assign sum_1481 = {4'h0, sum_1479} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1055
  logic not_1551;
  assign not_1551 = ~region_row_s4_q[2];
  logic [2:0] select_1552;
  assign select_1552 = region_row_s4_q[1] ? {1'b0, not_1551, 1'b0} : {region_row_s4_q[2], 1'b0, not_1551};
  logic [5:0] select_1553;
  assign select_1553 = region_row_s4_q[0] ? {select_1552[2], 1'b0, select_1552[1], 1'b0, select_1552[0], 1'b0} : {1'b0, select_1552[2], 1'b0, select_1552[1], 1'b0, select_1552[0]};
  logic [11:0] select_1554;
  assign select_1554 = or_1550_s4_q ? {select_1553[5], 1'b0, select_1553[4], 1'b0, select_1553[3], 1'b0, select_1553[2], 1'b0, select_1553[1], 1'b0, select_1553[0], 1'b0} : {1'b0, select_1553[5], 1'b0, select_1553[4], 1'b0, select_1553[3], 1'b0, select_1553[2], 1'b0, select_1553[1], 1'b0, select_1553[0]};
  logic [23:0] select_1555;
  assign select_1555 = or_1547_s4_q ? {select_1554[11], 1'b0, select_1554[10], 1'b0, select_1554[9], 1'b0, select_1554[8], 1'b0, select_1554[7], 1'b0, select_1554[6], 1'b0, select_1554[5], 1'b0, select_1554[4], 1'b0, select_1554[3], 1'b0, select_1554[2], 1'b0, select_1554[1], 1'b0, select_1554[0], 1'b0} : {1'b0, select_1554[11], 1'b0, select_1554[10], 1'b0, select_1554[9], 1'b0, select_1554[8], 1'b0, select_1554[7], 1'b0, select_1554[6], 1'b0, select_1554[5], 1'b0, select_1554[4], 1'b0, select_1554[3], 1'b0, select_1554[2], 1'b0, select_1554[1], 1'b0, select_1554[0]};
  logic [47:0] select_1556;
  assign select_1556 = or_1544_s4_q ? {select_1555[23], 1'b0, select_1555[22], 1'b0, select_1555[21], 1'b0, select_1555[20], 1'b0, select_1555[19], 1'b0, select_1555[18], 1'b0, select_1555[17], 1'b0, select_1555[16], 1'b0, select_1555[15], 1'b0, select_1555[14], 1'b0, select_1555[13], 1'b0, select_1555[12], 1'b0, select_1555[11], 1'b0, select_1555[10], 1'b0, select_1555[9], 1'b0, select_1555[8], 1'b0, select_1555[7], 1'b0, select_1555[6], 1'b0, select_1555[5], 1'b0, select_1555[4], 1'b0, select_1555[3], 1'b0, select_1555[2], 1'b0, select_1555[1], 1'b0, select_1555[0], 1'b0} : {1'b0, select_1555[23], 1'b0, select_1555[22], 1'b0, select_1555[21], 1'b0, select_1555[20], 1'b0, select_1555[19], 1'b0, select_1555[18], 1'b0, select_1555[17], 1'b0, select_1555[16], 1'b0, select_1555[15], 1'b0, select_1555[14], 1'b0, select_1555[13], 1'b0, select_1555[12], 1'b0, select_1555[11], 1'b0, select_1555[10], 1'b0, select_1555[9], 1'b0, select_1555[8], 1'b0, select_1555[7], 1'b0, select_1555[6], 1'b0, select_1555[5], 1'b0, select_1555[4], 1'b0, select_1555[3], 1'b0, select_1555[2], 1'b0, select_1555[1], 1'b0, select_1555[0]};
  // hls/stages/agreement.hpp:988
  logic and_1560;
  assign and_1560 = good_known_q & (~((good_q & select_1556) == 48'h0));
  // hls/stages/agreement.hpp:1057
  logic is_seen;
  assign is_seen = equal_1539_s4_q ? and_1560 : not_1575_s4_q;
  // hls/stages/agreement.hpp:1066
  logic and_1590;
  assign and_1590 = is_seen & less_1589_s4_q;
  // hls/stages/agreement.hpp:255
  logic [8:0] select_1629;
  assign select_1629 = sample_pair_whole_s4_q ? (and_365_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1631;
  assign select_1631 = sample_pair_whole_s4_q ? (and_365_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1633;
  assign select_1633 = sample_pair_whole_s4_q ? (and_365_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1635;
  assign select_1635 = sample_pair_whole_s4_q ? (and_365_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_1640;
  assign sum_1640 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1641;
  assign difference_1641 = {1'b0, sum_1640[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_1642;
  assign xor_1642 = {difference_1641[8:0], sum_1640[0]} ^ {10{difference_1641[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_1641[9]} + {1'b0, xor_1642};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_370_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_1647;
  assign select_1647 = sample_pair_whole_s4_q ? (and_365_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_1648;
  assign sum_1648 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1649;
  assign difference_1649 = {1'b0, sum_1648[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_1650;
  assign xor_1650 = {difference_1649[8:0], sum_1648[0]} ^ {10{difference_1649[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1649[9]} + {1'b0, xor_1650};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_370_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_1655;
  assign select_1655 = sample_pair_whole_s4_q ? (and_365_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:495
  logic [11:0] select_1740;
  assign select_1740 = and_367_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1741;
  assign select_1741 = and_367_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1742;
  assign select_1742 = and_367_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1743;
  assign select_1743 = and_367_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_1746;
  assign sum_1746 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1738_s4_q};
  logic [13:0] sum_1748;
  assign sum_1748 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1746});
  // hls/stages/census.hpp:305
  logic and_1750;
  assign and_1750 = and_457_s4_q & (9'h4 < sum_1748[13:5]);
  // hls/stages/census.hpp:306
  logic and_1751;
  assign and_1751 = and_457_s4_q & less_481;
  // hls/stages/census.hpp:307
  logic [19:0] sum_1752;
  assign sum_1752 = census_left_misses_q + {{17{and_1751}}, and_1750, 1'b0, and_1750};
  // hls/stages/agreement.hpp:495
  logic [19:0] select_1754;
  assign select_1754 = and_367_s4_q ? (equal_1745_s4_q ? 20'h0 : sum_1752) : census_left_misses_q;
  // hls/stages/agreement.hpp:255
  logic [27:0] select_1759;
  assign select_1759 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:355
  logic and_1764;
  assign and_1764 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:433
  logic and_1770;
  assign and_1770 = and_1764 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1759[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_1772;
  assign select_1772 = and_1770 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_1774;
  assign select_1774 = equal_1745_s4_q ? {11'h0, select_1772} : (sharpness_sums_detail_0_q + {11'h0, select_1772});
  // hls/stages/agreement.hpp:433
  logic and_1781;
  assign and_1781 = and_1764 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1759[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_1783;
  assign select_1783 = and_1781 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_1785;
  assign select_1785 = equal_1745_s4_q ? {11'h0, select_1783} : (sharpness_sums_detail_1_q + {11'h0, select_1783});
  logic [8:0] select_1788;
  assign select_1788 = and_1770 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1789;
  assign sum_1789 = (equal_1745_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1788};
  logic [8:0] select_1792;
  assign select_1792 = and_1781 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1793;
  assign sum_1793 = (equal_1745_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1792};
  // hls/stages/agreement.hpp:196
  logic equal_1795;
  assign equal_1795 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:369
  logic less_1796;
  assign less_1796 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:408
  logic less_1797;
  assign less_1797 = x_s4_q[4:0] < 5'h3;
  logic not_1798;
  assign not_1798 = ~x_s4_q[1];
  logic [2:0] select_1799;
  assign select_1799 = x_s4_q[0] ? {1'b0, not_1798, 1'b0} : {x_s4_q[1], 1'b0, not_1798};
  logic [5:0] select_1800;
  assign select_1800 = slot_s4_q[2] ? {select_1799[2], 1'b0, select_1799[1], 1'b0, select_1799[0], 1'b0} : {1'b0, select_1799[2], 1'b0, select_1799[1], 1'b0, select_1799[0]};
  logic [11:0] select_1801;
  assign select_1801 = slot_s4_q[1] ? {select_1800[5], 1'b0, select_1800[4], 1'b0, select_1800[3], 1'b0, select_1800[2], 1'b0, select_1800[1], 1'b0, select_1800[0], 1'b0} : {1'b0, select_1800[5], 1'b0, select_1800[4], 1'b0, select_1800[3], 1'b0, select_1800[2], 1'b0, select_1800[1], 1'b0, select_1800[0]};
  logic [23:0] select_1802;
  assign select_1802 = slot_s4_q[0] ? {select_1801[11], 1'b0, select_1801[10], 1'b0, select_1801[9], 1'b0, select_1801[8], 1'b0, select_1801[7], 1'b0, select_1801[6], 1'b0, select_1801[5], 1'b0, select_1801[4], 1'b0, select_1801[3], 1'b0, select_1801[2], 1'b0, select_1801[1], 1'b0, select_1801[0], 1'b0} : {1'b0, select_1801[11], 1'b0, select_1801[10], 1'b0, select_1801[9], 1'b0, select_1801[8], 1'b0, select_1801[7], 1'b0, select_1801[6], 1'b0, select_1801[5], 1'b0, select_1801[4], 1'b0, select_1801[3], 1'b0, select_1801[2], 1'b0, select_1801[1], 1'b0, select_1801[0]};
  // hls/stages/census.hpp:371
  logic and_1806;
  assign and_1806 = less_1797 & (~((sharpness_sums_contrast_1_q & select_1802) == 24'h0));
  // hls/stages/census.hpp:376
  logic [17:0] select_1808;
  assign select_1808 = (less_1796 & and_1806) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1808};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_1811;
  assign select_1811 = equal_1795 ? (less_1796 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:371
  logic and_1816;
  assign and_1816 = less_1797 & (~((sharpness_sums_contrast_0_q & select_1802) == 24'h0));
  // hls/stages/census.hpp:376
  logic [17:0] select_1818;
  assign select_1818 = (less_1796 & and_1816) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1818};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_1821;
  assign select_1821 = equal_1795 ? (less_1796 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_1823;
  assign select_1823 = equal_1795 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_1825;
  assign select_1825 = equal_1795 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_1827;
  assign select_1827 = equal_1795 ? {sharpness_comparing_contrast_0_q[0], and_1816} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_1829;
  assign select_1829 = equal_1795 ? {sharpness_comparing_contrast_1_q[0], and_1806} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:382
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:200
  logic select_1834;
  assign select_1834 = drew_q ? (equal_1795 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:382
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:200
  logic select_1838;
  assign select_1838 = drew_q ? (equal_1795 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:368
  logic equal_1839;
  assign equal_1839 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:384
  logic xor_1840;
  assign xor_1840 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_1843;
  assign select_1843 = (equal_1839 | xor_1840) ? (five_times[0] & xor_1840) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:200
  logic select_1845;
  assign select_1845 = drew_q ? (equal_1795 ? select_1843 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:384
  logic xor_1846;
  assign xor_1846 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_1849;
  assign select_1849 = (equal_1839 | xor_1846) ? (five_times_2[0] & xor_1846) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:200
  logic select_1851;
  assign select_1851 = drew_q ? (equal_1795 ? select_1849 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:385
  logic xor_1852;
  assign xor_1852 = sharpness_comparing_contrast_0_q[1] ^ and_1806;
  logic select_1855;
  assign select_1855 = (equal_1839 | xor_1852) ? (and_1806 & xor_1852) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:200
  logic select_1857;
  assign select_1857 = drew_q ? (equal_1795 ? select_1855 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:385
  logic xor_1858;
  assign xor_1858 = sharpness_comparing_contrast_1_q[1] ^ and_1816;
  logic select_1861;
  assign select_1861 = (equal_1839 | xor_1858) ? (and_1816 & xor_1858) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:200
  logic select_1863;
  assign select_1863 = drew_q ? (equal_1795 ? select_1861 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_1989;
  assign select_1989 = and_1983_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1987_s4_q});
  // hls/stages/agreement.hpp:392
  logic and_1992;
  assign and_1992 = not_1337_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_1997;
  assign and_1997 = not_1337_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2002;
  assign and_2002 = not_1337_s4_q & (drew_q & (ends_cell_s4_q & and_1477_s4_q));
  // hls/stages/agreement.hpp:1059
  logic not_2006;
  assign not_2006 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1060
  logic not_2023;
  assign not_2023 = ~(equal_1539_s4_q ? and_1560 : not_2021_s4_q);
  // hls/stages/agreement.hpp:392
  logic and_2026;
  assign and_2026 = ends_cell_s4_q & (not_2006 & (centres_values_1_textured_s4_q & not_2023));
  logic and_2028;
  assign and_2028 = not_1337_s4_q & (drew_q & and_2026);
  // hls/stages/agreement.hpp:1085
  logic less_2031;
  assign less_2031 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2032;
  assign select_2032 = less_2031 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2035;
  assign select_2035 = less_2031 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1086
  logic [10:0] sum_2036;
  assign sum_2036 = {1'b0, select_2035} + {3'h0, select_2035[9:2]};
  logic and_2038;
  assign and_2038 = (~(select_2032[9:4] == 6'h0)) & ({sum_2036, select_2035[1:0]} < {3'h0, select_2032});
  // hls/stages/agreement.hpp:1095
  logic [9:0] select_2041;
  assign select_2041 = x_s4_q[6] ? (equal_1381_s4_q ? 10'h0 : (and_2038 ? select_2032 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:392
  logic [9:0] select_2042;
  assign select_2042 = equal_1336_s4_q ? select_2041 : 10'h0;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2044;
  assign select_2044 = and_1983_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2042});
  logic [13:0] select_2051;
  assign select_2051 = and_1983_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2049_s4_q});
  // hls/stages/agreement.hpp:1064
  logic and_2053;
  assign and_2053 = not_2006 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:392
  logic and_2056;
  assign and_2056 = not_1337_s4_q & (drew_q & (ends_cell_s4_q & and_2053));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2058;
  assign select_2058 = and_1983_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2056});
  // hls/stages/agreement.hpp:1064
  logic and_2060;
  assign and_2060 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2023);
  // hls/stages/agreement.hpp:392
  logic and_2064;
  assign and_2064 = not_1337_s4_q & (drew_q & (ends_cell_s4_q & (not_2006 & and_2060)));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2066;
  assign select_2066 = and_1983_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2064});
  // hls/stages/registration.hpp:106
  logic [7:0] select_2136;
  assign select_2136 = equal_2091_s4_q ? (and_2121_s4_q ? residual_s4_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2138;
  assign select_2138 = equal_1336_s4_q ? 8'h0 : (drew_q ? select_2136 : 8'h0);
  // hls/stages/registration.hpp:133
  logic [13:0] select_2140;
  assign select_2140 = and_2119_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2138[7]}}, select_2138});
  // hls/stages/agreement.hpp:392
  logic and_2143;
  assign and_2143 = not_1337_s4_q & (drew_q & (and_2121_s4_q & equal_2091_s4_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2145;
  assign select_2145 = and_2119_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2143});
  // hls/stages/registration.hpp:106
  logic and_2147;
  assign and_2147 = and_2121_s4_q & ($signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2149;
  assign select_2149 = drew_q ? (equal_2091_s4_q ? {and_2147, and_2121_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2150;
  assign select_2150 = equal_1336_s4_q ? 2'h0 : select_2149;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2151;
  assign sum_2151 = registration_half_votes_down_q + {{5{select_2150[1]}}, select_2150};
  // hls/stages/registration.hpp:200
  logic [12:0] difference_2153;
  assign difference_2153 = 13'h0 - {residual_s4_q[11], residual_s4_q};
  // hls/stages/registration.hpp:106
  logic and_2155;
  assign and_2155 = and_2121_s4_q & ($signed(difference_2153) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2157;
  assign select_2157 = drew_q ? (equal_2091_s4_q ? {and_2155, and_2121_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2158;
  assign select_2158 = equal_1336_s4_q ? 2'h0 : select_2157;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2159;
  assign sum_2159 = registration_half_votes_up_q + {{5{select_2158[1]}}, select_2158};
  // hls/stages/registration.hpp:200
  logic less_2161;
  assign less_2161 = $signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2162;
  assign and_2162 = and_2121_s4_q & less_2161;
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2164;
  assign select_2164 = drew_q ? (equal_2091_s4_q ? {and_2162, and_2121_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2165;
  assign select_2165 = equal_1336_s4_q ? 2'h0 : select_2164;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2166;
  assign sum_2166 = registration_half_half_votes_down_q + {{5{select_2165[1]}}, select_2165};
  // hls/stages/registration.hpp:200
  logic less_2168;
  assign less_2168 = $signed(difference_2153) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2169;
  assign and_2169 = and_2121_s4_q & less_2168;
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2171;
  assign select_2171 = drew_q ? (equal_2091_s4_q ? {and_2169, and_2121_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2172;
  assign select_2172 = equal_1336_s4_q ? 2'h0 : select_2171;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2173;
  assign sum_2173 = registration_half_half_votes_up_q + {{5{select_2172[1]}}, select_2172};
  // hls/stages/agreement.hpp:392
  logic and_2207;
  assign and_2207 = equal_1336_s4_q & (x_s4_q[6] & (not_1455_s4_q & less_1409_s4_q));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2214;
  assign select_2214 = or_1413_s4_q ? 12'h0 : (equal_2212_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2217;
  assign select_2217 = x_s4_q[6] ? (equal_1381_s4_q ? 12'h0 : (less_1409_s4_q ? select_2214 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2218;
  assign select_2218 = equal_1336_s4_q ? select_2217 : 12'h0;
  // hls/stages/registration.hpp:152
  logic and_2219;
  assign and_2219 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1095
  logic and_2222;
  assign and_2222 = not_1455_s4_q & (less_1409_s4_q & ({and_2219, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:392
  logic and_2224;
  assign and_2224 = equal_1336_s4_q & (x_s4_q[6] & and_2222);
  // hls/stages/registration.hpp:247
  logic [13:0] sum_2226;
  assign sum_2226 = {{2{select_2218[11]}}, select_2218} + (and_2224 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2229;
  assign select_2229 = or_1413_s4_q ? 12'h0 : (equal_2212_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2232;
  assign select_2232 = x_s4_q[6] ? (equal_1381_s4_q ? 12'h0 : (less_1409_s4_q ? select_2229 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2233;
  assign select_2233 = equal_1336_s4_q ? select_2232 : 12'h0;
  // hls/stages/registration.hpp:248
  logic [13:0] sum_2235;
  assign sum_2235 = {{2{select_2233[11]}}, select_2233} + (and_2224 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:149
  logic not_2237;
  assign not_2237 = ~all_s4_q;
  // hls/stages/agreement.hpp:1095
  logic and_2240;
  assign and_2240 = not_1455_s4_q & (less_1409_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2237, 1'b0}));
  // hls/stages/agreement.hpp:392
  logic and_2246;
  assign and_2246 = equal_1336_s4_q & (x_s4_q[6] & (not_1455_s4_q & (less_1409_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:241
  logic not_2247;
  assign not_2247 = ~and_2246;
  logic less_2248;
  assign less_2248 = $signed({9'h1, {2{not_2247}}, and_2246}) < $signed(registration_up_q[13:2]);
  logic select_2249;
  assign select_2249 = (equal_1336_s4_q & (x_s4_q[6] & and_2240)) ? less_2248 : registration_enough_q;
  // hls/stages/agreement.hpp:1095
  logic and_2253;
  assign and_2253 = x_s4_q[6] & (not_1455_s4_q & (less_1409_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:392
  logic and_2254;
  assign and_2254 = equal_1336_s4_q & and_2253;
  // hls/stages/registration.hpp:237
  logic less_2255;
  assign less_2255 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2257;
  assign less_2257 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1095
  logic and_2262;
  assign and_2262 = x_s4_q[6] & (not_1455_s4_q & (less_1409_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:392
  logic and_2263;
  assign and_2263 = equal_1336_s4_q & and_2262;
  // hls/stages/agreement.hpp:1095
  logic and_2270;
  assign and_2270 = x_s4_q[6] & (not_1455_s4_q & (less_1409_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:156
  logic equal_2273;
  assign equal_2273 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1095
  logic and_2276;
  assign and_2276 = not_1455_s4_q & (less_1409_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2273));
  // hls/stages/registration.hpp:239
  logic and_2280;
  assign and_2280 = (equal_1336_s4_q & (x_s4_q[6] & and_2276)) & (less_2257 | less_2255);
  // hls/stages/agreement.hpp:1095
  logic and_2285;
  assign and_2285 = not_1455_s4_q & (less_1409_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2273)));
  // hls/stages/registration.hpp:239
  logic and_2288;
  assign and_2288 = registration_votes_up_q & registration_other_down_q;
  logic select_2290;
  assign select_2290 = registration_votes_down_q ? (registration_other_up_q | and_2288) : and_2288;
  // hls/stages/registration.hpp:137
  logic and_2292;
  assign and_2292 = (equal_1336_s4_q & (x_s4_q[6] & and_2285)) & (registration_other_enough_q & select_2290);
  // hls/stages/registration.hpp:240
  logic or_2295;
  assign or_2295 = registration_moved_q | (registration_enough_q & (and_2280 | and_2292));
  // hls/stages/agreement.hpp:1132
  logic or_2353;
  assign or_2353 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1154
  logic equal_2355;
  assign equal_2355 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1160
  logic equal_2356;
  assign equal_2356 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1163
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1164
  logic select_2362;
  assign select_2362 = (equal_2355 & equal_2356) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2365;
  assign sum_2365 = {1'b0, select_2035} + {2'h0, select_2035[9:1]};
  logic select_2368;
  assign select_2368 = (select_2032[9:3] == 7'h0) ? ((~or_2353) & (~select_2362)) : (~({sum_2365, select_2035[0]} < {2'h0, select_2032}));
  // hls/stages/agreement.hpp:1095
  logic [47:0] select_2370;
  assign select_2370 = x_s4_q[6] ? (equal_1381_s4_q ? good_q : {select_2368, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:392
  logic select_2375;
  assign select_2375 = equal_1336_s4_q ? ((x_s4_q[6] & good_known_q) | equal_2373_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1154
  logic equal_2376;
  assign equal_2376 = x_s4_q[6:3] == 4'ha;
  logic equal_2378;
  assign equal_2378 = x_s4_q[6:3] == 4'h9;
  logic equal_2379;
  assign equal_2379 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2381;
  assign select_2381 = equal_2378 ? counts_skin_unproven_q : (equal_2379 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2376 ? counts_nearer_q : select_2381;
  // hls/stages/agreement.hpp:1159
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1167
  logic select_2384;
  assign select_2384 = (equal_2376 & equal_2356) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1096
  logic not_2385;
  assign not_2385 = ~hidden_for_q[7];
  logic [7:0] select_2387;
  assign select_2387 = select_2384 ? (hidden_for_q + {7'h0, not_2385}) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2389;
  assign select_2389 = equal_1336_s4_q ? (equal_2373_s4_q ? select_2387 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2390;
  assign select_2390 = equal_2356 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1079
  logic [7:0] select_2392;
  assign select_2392 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2394;
  assign select_2394 = equal_2379 ? cfg_unproven_skin_limit_i : (equal_2355 ? cfg_unproven_limit_i : select_2392);
  logic [7:0] limit;
  assign limit = equal_2376 ? cfg_regions_limit_i : (equal_2378 ? cfg_hidden_limit_i : select_2394);
  // hls/stages/agreement.hpp:1167
  logic not_2397;
  assign not_2397 = ~x_s4_q[2];
  logic [3:0] select_2398;
  assign select_2398 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_2397, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_2397};
  logic [7:0] select_2399;
  assign select_2399 = x_s4_q[0] ? {select_2398[3], 1'b0, select_2398[2], 1'b0, select_2398[1], 1'b0, select_2398[0], 1'b0} : {1'b0, select_2398[3], 1'b0, select_2398[2], 1'b0, select_2398[1], 1'b0, select_2398[0]};
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2403;
  assign select_2403 = equal_2378 ? counts_skin_supervised_q : (equal_2379 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2376 ? counts_textured_q : select_2403;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2405;
  assign select_2405 = ((limit & select_2399) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2390} + {1'b0, select_2405};
  // hls/stages/agreement.hpp:392
  logic select_2410;
  assign select_2410 = equal_1336_s4_q ? (equal_2356 ? sum_3[0] : (product_rest_q | sum_3[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1165
  logic and_2415;
  assign and_2415 = too_much_q & (~(equal_2379 & equal_2356));
  // hls/stages/agreement.hpp:1166
  logic select_2420;
  assign select_2420 = (over[14] & equal_2356) ? (and_2415 | ((equal_2379 | equal_2378) | (x_s4_q[6:3] == 4'hf))) : and_2415;
  // hls/stages/agreement.hpp:1207
  logic select_2528;
  assign select_2528 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:257
  logic select_2530;
  assign select_2530 = left_first_s4_q ? done_s4_q : (and_1509_s4_q ? select_2528 : proven_q);
  // hls/stages/agreement.hpp:1240
  logic [1:0] select_2581;
  assign select_2581 = and_2580_s4_q ? {and_1590, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1241
  logic and_2582;
  assign and_2582 = select_2528 & less_2558;
  // hls/stages/agreement.hpp:413
  logic select_2585;
  assign select_2585 = and_1516_s4_q ? (less_1517_s4_q ? (select_2581[0] & and_2582) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:257
  logic select_2587;
  assign select_2587 = left_first_s4_q ? select_2585 : (and_1509_s4_q ? select_2585 : seen_q);
  logic select_2588;
  assign select_2588 = and_1509_s4_q ? select_2587 : seen_q;
  // hls/stages/agreement.hpp:413
  logic select_2591;
  assign select_2591 = and_1516_s4_q ? (less_1517_s4_q ? (select_2581[1] & and_2582) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:257
  logic select_2593;
  assign select_2593 = left_first_s4_q ? select_2591 : (and_1509_s4_q ? select_2591 : nearer_q);
  logic select_2594;
  assign select_2594 = and_1509_s4_q ? select_2593 : nearer_q;
  // hls/stages/agreement.hpp:392
  logic and_2601;
  assign and_2601 = equal_1336_s4_q & (equal_2373_s4_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:1176
  logic not_2606;
  assign not_2606 = ~(or_2353 | not_2595);
  // hls/stages/agreement.hpp:392
  logic and_2610;
  assign and_2610 = equal_1336_s4_q & (equal_2373_s4_q & (not_2606 & (select_2362 | select_2420)));
  logic and_2613;
  assign and_2613 = equal_1336_s4_q & (equal_2373_s4_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:1098
  logic or_2616;
  assign or_2616 = select_1845 | (select_1857 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:392
  logic and_2623;
  assign and_2623 = equal_1336_s4_q & (equal_2373_s4_q & (not_2606 & (select_1851 | select_1863)));
  // hls/stages/agreement.hpp:1098
  logic and_2628;
  assign and_2628 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2387 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:392
  logic and_2635;
  assign and_2635 = equal_1336_s4_q & (x_s4_q[6] & (not_1455_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1093
  logic [31:0] select_2643;
  assign select_2643 = equal_1401_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_2641_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_2644;
  assign select_2644 = equal_1399_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_2643;
  logic [31:0] select_2645;
  assign select_2645 = equal_1397_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_2644;
  logic [31:0] select_2646;
  assign select_2646 = equal_1395_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_2645;
  logic [31:0] select_2647;
  assign select_2647 = equal_1393_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_2646;
  logic [31:0] select_2648;
  assign select_2648 = equal_1391_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_2647;
  logic [31:0] select_2649;
  assign select_2649 = equal_1389_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_2648;
  // hls/stages/agreement.hpp:1091
  logic [9:0] select_2650;
  assign select_2650 = less_2031 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_2651;
  assign select_2651 = equal_1381_s4_q ? select_2649 : {2'h0, select_2650, select_2035, select_2032};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_367_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_482, and_458_s4_q, and_457_s4_q, and_432_s4_q, less_424_s4_q, less_423_s4_q, less_422_s4_q, less_421_s4_q, less_420_s4_q, less_419_s4_q, less_418_s4_q, less_417_s4_q, less_416_s4_q, less_415_s4_q, less_414_s4_q, less_413_s4_q, less_412_s4_q, less_411_s4_q, less_410_s4_q, less_409_s4_q, less_408_s4_q, less_407_s4_q, less_406_s4_q, less_405_s4_q, less_404_s4_q, less_403_s4_q, less_402_s4_q, less_401_s4_q};
  end
`ifndef SYNTHESIS
  logic [5:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [5:0] fresh_raddr_s2_sim;
  logic fresh_re_s2_sim;
  logic [5:0] fresh_raddr_s3_sim;
  logic fresh_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s1_sim <= 1'b0;
      fresh_re_s2_sim <= 1'b0;
      fresh_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s1_sim <= fresh_re;
      fresh_raddr_s1_sim <= fresh_raddr;
      fresh_re_s2_sim <= fresh_re_s1_sim;
      fresh_raddr_s2_sim <= fresh_raddr_s1_sim;
      fresh_re_s3_sim <= fresh_re_s2_sim;
      fresh_raddr_s3_sim <= fresh_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s1_sim && fresh_raddr_s1_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s2_sim && fresh_raddr_s2_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s3_sim && fresh_raddr_s3_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_waddr >= 6'd47) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 6'd47) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1387_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1443_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1442, sum_1438};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_waddr >= 4'd12) $error("registration_sums: write outside, address %0d", registration_sums_waddr);
    end
    if (rst_ni && registration_sums_re && registration_sums_raddr >= 4'd12) $error("registration_sums: read outside, address %0d", registration_sums_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_1453_s4_q, or_1450_s4_q, or_1447_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1482_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1481, sum_1475, sum_1470};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  // Memory map, write
  logic [11:0] map_waddr;
  assign map_waddr = sum_1525_s4_q;
  logic map_we;
  assign map_we = s4_en & and_1600_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1590, is_seen};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && map_we) begin
      if (map_re && map_raddr == map_waddr) begin
        $error("map: address %0d is read less than DISTANCE steps after its write", map_waddr);
      end
      if (map_waddr >= 12'd3290) $error("map: write outside, address %0d", map_waddr);
    end
    if (rst_ni && map_re && map_raddr >= 12'd3290) $error("map: read outside, address %0d", map_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_left_misses_q <= 20'h0;
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_contrast_0_q <= 2'h0;
      sharpness_comparing_contrast_1_q <= 2'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      sharpness_comparing_less_contrast_0_q <= 1'b0;
      sharpness_comparing_less_contrast_1_q <= 1'b0;
      counts_supervised_q <= 14'h0;
      counts_textured_q <= 14'h0;
      counts_explained_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
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
      registration_moved_q <= 1'b0;
      segment_textured_q <= 6'h0;
      segment_explained_q <= 6'h0;
      segment_nearer_q <= 6'h0;
      segment_started_q <= 1'b0;
      good_q <= 48'h0;
      good_known_q <= 1'b0;
      hidden_for_q <= 8'h0;
      product_q <= 14'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      too_much_q <= 1'b0;
      hides_q <= 1'b0;
      proven_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s4_en) begin
      census_left_misses_q <= select_1754;
      sharpness_sums_detail_0_q <= and_367_s4_q ? select_1774 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_367_s4_q ? select_1785 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_367_s4_q ? sum_1789 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_367_s4_q ? sum_1793 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_1811 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_1821 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_1823 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_1825 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_1827 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_1829 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_1834;
      sharpness_comparing_carry_1_q <= select_1838;
      sharpness_comparing_less_detail_0_q <= select_1845;
      sharpness_comparing_less_detail_1_q <= select_1851;
      sharpness_comparing_less_contrast_0_q <= select_1857;
      sharpness_comparing_less_contrast_1_q <= select_1863;
      counts_supervised_q <= select_1989;
      counts_textured_q <= and_1983_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1992});
      counts_explained_q <= and_1983_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_1997});
      counts_nearer_q <= and_1983_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2002});
      counts_unproven_q <= and_1983_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2028});
      counts_regions_bad_q <= select_2044;
      counts_skin_supervised_q <= select_2051;
      counts_skin_textured_q <= select_2058;
      counts_skin_unproven_q <= select_2066;
      registration_half_across_q <= select_2140;
      registration_half_measured_q <= select_2145;
      registration_half_votes_down_q <= and_2119_s4_q ? 7'h0 : sum_2151;
      registration_half_votes_up_q <= and_2119_s4_q ? 7'h0 : sum_2159;
      registration_half_half_votes_down_q <= and_2119_s4_q ? 7'h0 : sum_2166;
      registration_half_half_votes_up_q <= and_2119_s4_q ? 7'h0 : sum_2173;
      registration_down_q <= and_2207 ? sum_2226 : registration_down_q;
      registration_up_q <= and_2207 ? sum_2235 : registration_up_q;
      registration_enough_q <= select_2249;
      registration_votes_down_q <= and_2254 ? less_2255 : registration_votes_down_q;
      registration_votes_up_q <= and_2254 ? less_2257 : registration_votes_up_q;
      registration_other_enough_q <= and_2263 ? select_2249 : registration_other_enough_q;
      registration_other_down_q <= and_2263 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2263 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1336_s4_q & and_2270)) & or_2295;
      segment_textured_q <= select_1467 + {5'h0, and_1992};
      segment_explained_q <= select_1472 + {5'h0, and_1997};
      segment_nearer_q <= select_1478 + {5'h0, and_2002};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1336_s4_q ? select_2370 : good_q;
      good_known_q <= select_2375;
      hidden_for_q <= select_2389;
      product_q <= equal_1336_s4_q ? sum_3[14:1] : product_q;
      product_rest_q <= select_2410;
      disagree_q <= equal_1336_s4_q ? select_2362 : disagree_q;
      too_much_q <= equal_1336_s4_q ? select_2420 : too_much_q;
      hides_q <= equal_1336_s4_q ? select_2384 : hides_q;
      proven_q <= and_1509_s4_q ? select_2530 : proven_q;
      seen_q <= select_2588;
      nearer_q <= select_2594;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_quarter_1_0_q = 9'h0;
    averager_quarter_1_1_q = 9'h0;
    averager_quarter_2_0_q = 9'h0;
    averager_quarter_2_1_q = 9'h0;
    averager_detail_0_q = 14'h0;
    averager_detail_1_q = 14'h0;
    census_changes_values_0_left_q = 12'h0;
    census_changes_values_0_right_q = 12'h0;
    census_changes_values_1_left_q = 12'h0;
    census_changes_values_1_right_q = 12'h0;
    census_changes_values_2_left_q = 12'h0;
    census_changes_values_2_right_q = 12'h0;
    sharpness_last_mask_q = 1'b0;
    sharpness_last_detail_0_q = 14'h0;
    sharpness_last_detail_1_q = 14'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s4_en) begin
      averager_quarter_1_0_q <= select_1629;
      averager_quarter_1_1_q <= select_1631;
      averager_quarter_2_0_q <= select_1633;
      averager_quarter_2_1_q <= select_1635;
      averager_detail_0_q <= select_1647;
      averager_detail_1_q <= select_1655;
      census_changes_values_0_left_q <= and_367_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_367_s4_q ? sum_1738_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1740;
      census_changes_values_1_right_q <= select_1741;
      census_changes_values_2_left_q <= select_1742;
      census_changes_values_2_right_q <= select_1743;
      sharpness_last_mask_q <= and_367_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_367_s4_q ? select_1759[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_367_s4_q ? select_1759[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_2532_s5_q;
  logic or_2596_s5_q;
  logic and_2597_s5_q;
  logic and_2601_s5_q;
  logic and_2604_s5_q;
  logic and_2610_s5_q;
  logic and_2613_s5_q;
  logic and_2619_s5_q;
  logic and_2623_s5_q;
  logic and_2631_s5_q;
  logic and_2635_s5_q;
  logic [5:0] select_2637_s5_q;
  logic [31:0] select_2653_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_2532_s5_q <= said_q;
      or_2596_s5_q <= not_2595 | select_2588;
      and_2597_s5_q <= cfg_prove_i & select_2594;
      and_2601_s5_q <= and_2601;
      and_2604_s5_q <= equal_1336_s4_q & (equal_2373_s4_q & (cfg_prove_i & or_2353));
      and_2610_s5_q <= and_2610;
      and_2613_s5_q <= and_2613;
      and_2619_s5_q <= equal_1336_s4_q & (equal_2373_s4_q & (not_2606 & or_2616));
      and_2623_s5_q <= and_2623;
      and_2631_s5_q <= equal_1336_s4_q & (equal_2373_s4_q & (cfg_prove_i & and_2628));
      and_2635_s5_q <= and_2635;
      select_2637_s5_q <= equal_1336_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_2653_s5_q <= equal_1336_s4_q ? (x_s4_q[6] ? select_2651 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_2596_s5_q;
  assign marks_nearer_o = and_2597_s5_q;
  assign verdict_valid_o = and_2532_s5_q;
  assign verdict_unproven_yet_o = and_2601_s5_q;
  assign verdict_untextured_o = and_2604_s5_q;
  assign verdict_disagree_o = and_2610_s5_q;
  assign verdict_moved_o = and_2613_s5_q;
  assign verdict_unsharp_left_o = and_2619_s5_q;
  assign verdict_unsharp_right_o = and_2623_s5_q;
  assign verdict_hidden_o = and_2631_s5_q;
  assign frame_valid_o = and_2635_s5_q;
  assign frame_index_o = select_2637_s5_q;
  assign frame_word_o = select_2653_s5_q;
  assign valid_o = valid_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], sum_2106[0], sum_2102[0], sum_2088[0], detail_4[1:0], detail_3[1:0], sum_1748[4:0], sum_480[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
