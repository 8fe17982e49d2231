// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1895 bits, pipeline 618 bits, memories 31188 bits.
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
  logic [5:0] sum_1964;
  assign sum_1964 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_2326;
  assign difference_2326 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2561;
  assign less_2561 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2562;
  assign sum_2562 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_2563;
  assign select_2563 = less_2561 ? {sum_2562, cfg_height_i[5:3]} : 8'h0;
  logic not_2598;
  assign not_2598 = ~cfg_prove_i;

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
  logic [2:0] select_329;
  assign select_329 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_331;
  assign select_331 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_334;
  assign select_334 = ({select_331, select_329} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_335;
  assign select_335 = select_329[0] ? averager_place_q : select_334;
  // hls/stages/census.hpp:41
  logic or_336;
  assign or_336 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:394
  logic and_342;
  assign and_342 = (~((~or_336) | (~select_329[0]))) & (select_335 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_347;
  assign select_347 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:394
  logic whole;
  assign whole = select_329[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:255
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_331 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_364;
  assign equal_364 = select_329 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_365;
  assign equal_365 = select_347 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_366;
  assign and_366 = equal_365 & and_342;
  // hls/stages/agreement.hpp:255
  logic and_368;
  assign and_368 = sample_pair_whole_q & (equal_364 & and_366);
  // hls/stages/agreement.hpp:181
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:598
  logic equal_388;
  assign equal_388 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:569
  logic or_389;
  assign or_389 = so | equal_388;
  // hls/stages/agreement.hpp:719
  logic not_390;
  assign not_390 = ~or_389;
  // hls/stages/agreement.hpp:589
  logic equal_391;
  assign equal_391 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:590
  logic equal_393;
  assign equal_393 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:567
  logic [7:0] sum_394;
  assign sum_394 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:569
  logic [7:0] select_395;
  assign select_395 = run_shift_q[5] ? x_q : sum_394;
  logic less_396;
  assign less_396 = {2'h0, last_q} < select_395;
  // hls/stages/agreement.hpp:209
  logic not_397;
  assign not_397 = ~less_396;
  // hls/stages/agreement.hpp:137
  logic and_398;
  assign and_398 = equal_393 & not_397;
  logic and_400;
  assign and_400 = not_390 & ((~equal_391) & and_398);
  // hls/stages/census.hpp:41
  logic [5:0] select_427;
  assign select_427 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:255
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_427 : 6'h0;
  // hls/stages/agreement.hpp:137
  logic select_484;
  assign select_484 = equal_391 ? not_397 : and_398;
  // hls/stages/agreement.hpp:788
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:785
  logic [6:0] sum_504;
  assign sum_504 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:137
  logic and_509;
  assign and_509 = equal_391 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_504} < select_395))));
  logic select_510;
  assign select_510 = or_389 ? not_397 : and_509;
  // hls/stages/agreement.hpp:793
  logic equal_513;
  assign equal_513 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:797
  logic or_515;
  assign or_515 = equal_513 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:809
  logic [5:0] right;
  assign right = sum_394[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:175
  logic and_1510;
  assign and_1510 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:255
  logic [2:0] select_1611;
  assign select_1611 = sample_pair_whole_q ? (sample_last_q ? (select_347 + 3'h1) : select_347) : raster_at_y_q;
  logic [5:0] select_1613;
  assign select_1613 = sample_pair_whole_q ? (select_331 + {5'h0, equal_364}) : raster_at_column_q;
  logic [5:0] select_1616;
  assign select_1616 = sample_pair_whole_q ? (sample_last_q ? (select_427 + {5'h0, equal_365}) : select_427) : raster_at_row_q;
  logic select_1620;
  assign select_1620 = sample_pair_whole_q ? (sample_last_q ? (or_336 & (~raster_final_row_q)) : or_336) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_1622;
  assign select_1622 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:255
  logic select_1626;
  assign select_1626 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:435
  logic equal_1870;
  assign equal_1870 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:440
  logic and_1871;
  assign and_1871 = and_368 & equal_1870;
  // hls/stages/agreement.hpp:498
  logic select_1874;
  assign select_1874 = (and_1871 | (~ends_cell_q)) ? and_1871 : ends_q;
  // hls/stages/agreement.hpp:504
  logic [2:0] now;
  assign now = select_1874 ? (and_1871 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:509
  logic [5:0] select_1878;
  assign select_1878 = select_1874 ? (and_1871 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_1881;
  assign select_1881 = select_1874 ? (following_last_shift_q & (~and_1871)) : run_last_shift_q;
  // hls/stages/agreement.hpp:582
  logic and_1884;
  assign and_1884 = run_last_shift_q & equal_391;
  // hls/stages/agreement.hpp:591
  logic select_1886;
  assign select_1886 = equal_391 ? (~run_last_shift_q) : equal_393;
  // hls/stages/agreement.hpp:595
  logic equal_1887;
  assign equal_1887 = run_phase_q == 3'h1;
  logic not_1890;
  assign not_1890 = ~select_1886;
  // hls/stages/agreement.hpp:598
  logic equal_1892;
  assign equal_1892 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:582
  logic and_1893;
  assign and_1893 = final_row_q & so;
  // hls/stages/agreement.hpp:595
  logic [1:0] select_1894;
  assign select_1894 = equal_1892 ? 2'h1 : {2{and_1893}};
  logic [2:0] select_1896;
  assign select_1896 = (and_1884 | (select_1886 | equal_1887)) ? (equal_1887 ? 3'h2 : {not_1890, {2{select_1886}}}) : (equal_388 ? 3'h6 : {select_1894[0], select_1894});
  // hls/stages/agreement.hpp:582
  logic and_1899;
  assign and_1899 = select_1886 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:605
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1902;
  assign select_1902 = (plan_shift_q[5] & select_1886) ? value : 7'h0;
  logic [1:0] or_1903;
  assign or_1903 = {2{so}} | select_1902[5:4];
  // hls/stages/agreement.hpp:608
  logic [7:0] select_1904;
  assign select_1904 = select_1886 ? plan_columns_q : 8'h0;
  logic [6:0] or_1907;
  assign or_1907 = select_1904[6:0] | ((equal_1887 | equal_1892) ? whole_q : 7'h0);
  logic [1:0] or_1908;
  assign or_1908 = {2{and_1884}} | or_1907[3:2];
  // hls/stages/agreement.hpp:609
  logic [6:0] or_1910;
  assign or_1910 = {or_1907[6:4], or_1908, or_1907[1:0]} | (equal_388 ? drawn_q : 7'h0);
  logic [4:0] or_1911;
  assign or_1911 = {5{so}} | {or_1910[6], or_1910[3:0]};
  // hls/stages/agreement.hpp:615
  logic not_1915;
  assign not_1915 = ~run_shift_q[5];
  logic [6:0] difference_1917;
  assign difference_1917 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_1918;
  assign select_1918 = equal_391 ? ({{7{not_1915}}, 1'b1} + run_span_q) : {difference_1917[6], difference_1917};
  // hls/stages/agreement.hpp:498
  logic [6:0] select_1922;
  assign select_1922 = and_1871 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:501
  logic [7:0] select_1924;
  assign select_1924 = select_1874 ? {select_1922[6], select_1922} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_1927;
  assign select_1927 = select_1874 ? (and_1871 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:495
  logic [5:0] select_1935;
  assign select_1935 = and_368 ? (equal_1870 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_1938;
  assign select_1938 = and_368 ? (equal_1870 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_1941;
  assign select_1941 = and_368 ? (equal_1870 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:506
  logic select_1955;
  assign select_1955 = (ends_cell_q | select_1874) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_391 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:501
  logic and_1959;
  assign and_1959 = (~select_1874) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:451
  logic [6:0] sum_1960;
  assign sum_1960 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:436
  logic select_1962;
  assign select_1962 = equal_1870 ? ({sum_1960[6], cfg_height_i[8:3]} == {1'b0, sum_1960[5:0]}) : final_row_q;

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
  assign fresh_re = s0_en & and_400;
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
  assign left_re = s0_en & (or_389 ? not_397 : select_484);
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
  assign right_codes_raddr = equal_391 ? sum_394[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_390 & select_484);
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
  assign best_left_raddr = or_389 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_510;
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
      left_first_q <= and_1510 ? left_first_q : marks_first_i;
      right_q <= (~and_1510) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1510;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_329 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1611;
      raster_at_column_q <= select_1613;
      raster_at_row_q <= select_1616;
      raster_at_live_q <= select_1620;
      raster_rows_left_q <= sample_pair_whole_q ? select_1622 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1626;
      averager_place_q <= sample_pair_whole_q ? select_335 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= now;
      run_shift_q <= select_1878;
      run_last_shift_q <= select_1881;
      run_span_q <= select_1874 ? (and_1871 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_1896;
      following_shift_q <= select_1886 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_1899;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1902[6], or_1903, select_1902[3:0]};
      following_columns_q <= {select_1904[7], or_1911[4], or_1910[5:4], or_1911[3:0]};
      plan_shift_q <= equal_391 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_1918;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_1924;
      columns_left_q <= select_1927;
      last_q <= and_368 ? (equal_1870 ? column : last_q) : last_q;
      least_q <= select_1935;
      whole_q <= select_1938;
      drawn_q <= select_1941;
      age_q <= select_1874 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_1874 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_1955;
      ends_q <= and_1959;
      final_row_q <= and_368 ? select_1962 : final_row_q;
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
  logic select_329_s1_q;
  logic [7:0] select_335_s1_q;
  logic and_342_s1_q;
  logic equal_348_s1_q;
  logic whole_s1_q;
  logic [5:0] column_s1_q;
  logic and_366_s1_q;
  logic and_368_s1_q;
  logic equal_371_s1_q;
  logic so_s1_q;
  logic equal_388_s1_q;
  logic or_389_s1_q;
  logic equal_391_s1_q;
  logic less_396_s1_q;
  logic not_397_s1_q;
  logic and_400_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_510_s1_q;
  logic select_517_s1_q;
  logic and_1319_s1_q;
  logic [5:0] right_s1_q;
  logic select_1328_s1_q;
  logic equal_1337_s1_q;
  logic equal_1870_s1_q;
  logic and_1871_s1_q;
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
      select_329_s1_q <= select_329[0];
      select_335_s1_q <= select_335;
      and_342_s1_q <= and_342;
      equal_348_s1_q <= select_347 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_366_s1_q <= and_366;
      and_368_s1_q <= and_368;
      equal_371_s1_q <= select_329 == 3'h1;
      so_s1_q <= so;
      equal_388_s1_q <= equal_388;
      or_389_s1_q <= or_389;
      equal_391_s1_q <= equal_391;
      less_396_s1_q <= less_396;
      not_397_s1_q <= not_397;
      and_400_s1_q <= and_400;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_510_s1_q <= select_510;
      select_517_s1_q <= or_515 ? equal_513 : (~age_q[3]);
      and_1319_s1_q <= not_390 & and_509;
      right_s1_q <= right;
      select_1328_s1_q <= or_515 ? equal_513 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1337_s1_q <= run_phase_q == 3'h7;
      equal_1870_s1_q <= equal_1870;
      and_1871_s1_q <= and_1871;
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
  logic and_343;
  assign and_343 = sample_pair_whole_s1_q & and_342_s1_q;
  // hls/stages/agreement.hpp:641
  logic not_488;
  assign not_488 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:644
  logic and_489;
  assign and_489 = left_rdata_q[12] & not_488;
  logic and_490;
  assign and_490 = left_rdata_q[28] & not_488;
  logic and_491;
  assign and_491 = left_rdata_q[44] & not_488;
  logic and_492;
  assign and_492 = left_rdata_q[60] & not_488;
  // hls/stages/agreement.hpp:645
  logic and_496;
  assign and_496 = right_codes_rdata_q[12] & not_488;
  logic and_497;
  assign and_497 = right_codes_rdata_q[25] & not_488;
  logic and_498;
  assign and_498 = right_codes_rdata_q[38] & not_488;
  logic and_499;
  assign and_499 = right_codes_rdata_q[51] & not_488;
  logic and_500;
  assign and_500 = right_codes_rdata_q[64] & not_488;
  logic and_501;
  assign and_501 = right_codes_rdata_q[77] & not_488;
  // hls/stages/agreement.hpp:205
  logic and_523;
  assign and_523 = left_rdata_q[44] & not_397_s1_q;
  logic and_524;
  assign and_524 = right_codes_rdata_q[38] & not_397_s1_q;
  logic [11:0] select_525;
  assign select_525 = less_396_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_526;
  assign select_526 = less_396_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_530;
  assign select_530 = and_523 ? (and_524 ? (~(select_525 ^ select_526)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_536;
  assign parity_536 = ^select_530[5:3];
  logic parity_539;
  assign parity_539 = ^select_530[8:6];
  logic parity_542;
  assign parity_542 = ^select_530[11:3];
  // hls/stages/agreement.hpp:205
  logic and_546;
  assign and_546 = left_rdata_q[60] & not_397_s1_q;
  logic and_547;
  assign and_547 = right_codes_rdata_q[51] & not_397_s1_q;
  logic [11:0] select_548;
  assign select_548 = less_396_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_549;
  assign select_549 = less_396_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_553;
  assign select_553 = and_546 ? (and_547 ? (~(select_548 ^ select_549)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_556;
  assign parity_556 = ^select_553[8:6];
  logic parity_559;
  assign parity_559 = ^select_553[11:9];
  // hls/stages/agreement.hpp:205
  logic and_563;
  assign and_563 = left_rdata_q[76] & not_397_s1_q;
  logic and_564;
  assign and_564 = right_codes_rdata_q[64] & not_397_s1_q;
  logic [11:0] select_565;
  assign select_565 = less_396_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_566;
  assign select_566 = less_396_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_570;
  assign select_570 = and_563 ? (and_564 ? (~(select_565 ^ select_566)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_576;
  assign parity_576 = ^select_570[2:0];
  logic parity_579;
  assign parity_579 = ^select_570[5:3];
  logic parity_582;
  assign parity_582 = ^select_570[8:0];
  logic parity_588;
  assign parity_588 = ^select_570[11:9];
  logic parity_591;
  assign parity_591 = ^select_553[2:0];
  logic parity_594;
  assign parity_594 = ^{select_570[11:9], select_553[5:0]};
  logic parity_597;
  assign parity_597 = ^{select_570, select_553, select_530[2:0]};
  logic xor_598;
  assign xor_598 = parity_542 ^ parity_597;
  // hls/stages/agreement.hpp:671
  logic or_602;
  assign or_602 = (select_530[1:0] == 2'h3) | (select_530[2] & (select_530[0] | select_530[1]));
  // hls/stages/agreement.hpp:673
  logic or_606;
  assign or_606 = (select_553[7:6] == 2'h3) | (select_553[8] & (select_553[6] | select_553[7]));
  logic or_610;
  assign or_610 = (select_553[10:9] == 2'h3) | (select_553[11] & (select_553[9] | select_553[10]));
  // hls/stages/agreement.hpp:671
  logic or_618;
  assign or_618 = (select_570[7:6] == 2'h3) | (select_570[8] & (~(select_570[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:673
  logic or_622;
  assign or_622 = (select_570[1:0] == 2'h3) | (select_570[2] & (select_570[0] | select_570[1]));
  logic or_626;
  assign or_626 = (select_570[4:3] == 2'h3) | (select_570[5] & (select_570[3] | select_570[4]));
  // hls/stages/agreement.hpp:672
  logic parity_629;
  assign parity_629 = ^{or_626, or_622, or_618};
  // hls/stages/agreement.hpp:671
  logic or_633;
  assign or_633 = (select_553[4:3] == 2'h3) | (select_553[5] & (select_553[3] | select_553[4]));
  // hls/stages/agreement.hpp:673
  logic or_637;
  assign or_637 = (select_570[10:9] == 2'h3) | (select_570[11] & (select_570[9] | select_570[10]));
  logic or_641;
  assign or_641 = (select_553[1:0] == 2'h3) | (select_553[2] & (select_553[0] | select_553[1]));
  // hls/stages/agreement.hpp:672
  logic parity_644;
  assign parity_644 = ^{or_641, or_637, or_633};
  logic parity_647;
  assign parity_647 = ^{or_641, or_637, or_633, or_626, or_622, or_618, or_610, or_606, or_602};
  // hls/stages/agreement.hpp:673
  logic and_648;
  assign and_648 = parity_542 & parity_597;
  logic or_652;
  assign or_652 = (parity_536 & parity_539) | ((^select_530[11:9]) & (parity_536 | parity_539));
  logic and_655;
  assign and_655 = (^{select_553[11:6], select_530[2:0]}) & (parity_582 | parity_594);
  logic or_656;
  assign or_656 = (parity_582 & parity_594) | and_655;
  // hls/stages/agreement.hpp:671
  logic or_663;
  assign or_663 = (select_530[10:9] == 2'h3) | (select_530[11] & (select_530[9] | select_530[10]));
  // hls/stages/agreement.hpp:673
  logic or_667;
  assign or_667 = (select_530[4:3] == 2'h3) | (select_530[5] & (select_530[3] | select_530[4]));
  logic or_671;
  assign or_671 = (select_530[7:6] == 2'h3) | (select_530[8] & (select_530[6] | select_530[7]));
  // hls/stages/agreement.hpp:672
  logic parity_674;
  assign parity_674 = ^{or_671, or_667, or_663};
  // hls/stages/agreement.hpp:673
  logic or_678;
  assign or_678 = (parity_556 & parity_559) | ((^select_530[2:0]) & (parity_556 | parity_559));
  logic or_682;
  assign or_682 = (parity_576 & parity_579) | ((^select_570[8:6]) & (parity_576 | parity_579));
  logic or_686;
  assign or_686 = (parity_588 & parity_591) | ((^select_553[5:3]) & (parity_588 | parity_591));
  // hls/stages/agreement.hpp:672
  logic parity_689;
  assign parity_689 = ^{or_686, or_682, or_678};
  logic parity_692;
  assign parity_692 = ^{or_686, or_682, or_678, or_671, or_667, or_663, or_656, or_652, and_648};
  logic xor_693;
  assign xor_693 = parity_647 ^ parity_692;
  // hls/stages/agreement.hpp:673
  logic and_694;
  assign and_694 = parity_647 & parity_692;
  logic or_698;
  assign or_698 = (parity_629 & parity_644) | ((^{or_610, or_606, or_602}) & (parity_629 | parity_644));
  logic or_702;
  assign or_702 = (parity_674 & parity_689) | ((^{or_656, or_652, and_648}) & (parity_674 | parity_689));
  logic or_709;
  assign or_709 = (or_606 & or_610) | (or_602 & (or_606 | or_610));
  logic or_713;
  assign or_713 = (or_622 & or_626) | (or_618 & (or_622 | or_626));
  logic or_717;
  assign or_717 = (or_637 & or_641) | (or_633 & (or_637 | or_641));
  // hls/stages/agreement.hpp:672
  logic parity_720;
  assign parity_720 = ^{or_717, or_713, or_709};
  // hls/stages/agreement.hpp:673
  logic or_724;
  assign or_724 = (or_652 & or_656) | (and_648 & (or_652 | or_656));
  logic or_728;
  assign or_728 = (or_667 & or_671) | (or_663 & (or_667 | or_671));
  logic or_732;
  assign or_732 = (or_682 & or_686) | (or_678 & (or_682 | or_686));
  // hls/stages/agreement.hpp:672
  logic parity_735;
  assign parity_735 = ^{or_732, or_728, or_724};
  logic parity_738;
  assign parity_738 = ^{or_732, or_728, or_724, or_717, or_713, or_709, or_702, or_698, and_694};
  // hls/stages/agreement.hpp:673
  logic or_742;
  assign or_742 = (parity_720 & parity_735) | ((^{or_702, or_698, and_694}) & (parity_720 | parity_735));
  logic or_746;
  assign or_746 = (or_698 & or_702) | (and_694 & (or_698 | or_702));
  logic or_750;
  assign or_750 = (or_713 & or_717) | (or_709 & (or_713 | or_717));
  logic or_754;
  assign or_754 = (or_728 & or_732) | (or_724 & (or_728 | or_732));
  // hls/stages/agreement.hpp:672
  logic parity_759;
  assign parity_759 = ^{or_754, or_750, or_746, or_742};
  // hls/stages/agreement.hpp:673
  logic or_763;
  assign or_763 = (or_750 & or_754) | (or_746 & (or_750 | or_754));
  logic and_764;
  assign and_764 = or_742 & (^{or_754, or_750, or_746});
  // hls/stages/agreement.hpp:672
  logic xor_765;
  assign xor_765 = or_763 ^ and_764;
  // hls/stages/agreement.hpp:675
  logic and_766;
  assign and_766 = or_763 & and_764;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_767;
  assign select_767 = equal_391_s1_q ? {and_766, xor_765, parity_759, parity_738, xor_693, xor_598} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_389_s1_q ? 6'h0 : select_767;
  // hls/stages/agreement.hpp:657
  logic [11:0] select_778;
  assign select_778 = (slot_s1_q[0] ? and_564 : and_547) ? (~(select_526 ^ (slot_s1_q[0] ? select_565 : select_548))) : 12'h0;
  logic [11:0] select_779;
  assign select_779 = and_523 ? select_778 : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_785;
  assign parity_785 = ^select_779[5:3];
  logic parity_788;
  assign parity_788 = ^select_779[8:6];
  logic parity_791;
  assign parity_791 = ^select_779[11:3];
  // hls/stages/agreement.hpp:205
  logic and_795;
  assign and_795 = right_codes_rdata_q[77] & not_397_s1_q;
  logic [11:0] select_797;
  assign select_797 = less_396_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_801;
  assign select_801 = (slot_s1_q[0] ? and_795 : and_564) ? (~(select_549 ^ (slot_s1_q[0] ? select_797 : select_565))) : 12'h0;
  logic [11:0] select_802;
  assign select_802 = and_546 ? select_801 : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_805;
  assign parity_805 = ^select_802[8:6];
  logic parity_808;
  assign parity_808 = ^select_802[11:9];
  // hls/stages/agreement.hpp:733
  logic select_813;
  assign select_813 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_397_s1_q) : and_795;
  logic [11:0] select_815;
  assign select_815 = slot_s1_q[0] ? (less_396_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_797;
  // hls/stages/agreement.hpp:657
  logic [11:0] select_819;
  assign select_819 = and_563 ? (select_813 ? (~(select_566 ^ select_815)) : 12'h0) : 12'h0;
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
  logic xor_847;
  assign xor_847 = parity_791 ^ parity_846;
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
  logic and_897;
  assign and_897 = parity_791 & parity_846;
  logic or_901;
  assign or_901 = (parity_785 & parity_788) | ((^select_779[11:9]) & (parity_785 | parity_788));
  logic and_904;
  assign and_904 = (^{select_802[11:6], select_779[2:0]}) & (parity_831 | parity_843);
  logic or_905;
  assign or_905 = (parity_831 & parity_843) | and_904;
  // hls/stages/agreement.hpp:671
  logic or_912;
  assign or_912 = (select_779[10:9] == 2'h3) | (select_779[11] & (select_779[9] | select_779[10]));
  // hls/stages/agreement.hpp:673
  logic or_916;
  assign or_916 = (select_779[4:3] == 2'h3) | (select_779[5] & (select_779[3] | select_779[4]));
  logic or_920;
  assign or_920 = (select_779[7:6] == 2'h3) | (select_779[8] & (select_779[6] | select_779[7]));
  // hls/stages/agreement.hpp:672
  logic parity_923;
  assign parity_923 = ^{or_920, or_916, or_912};
  // hls/stages/agreement.hpp:673
  logic or_927;
  assign or_927 = (parity_805 & parity_808) | ((^select_779[2:0]) & (parity_805 | parity_808));
  logic or_931;
  assign or_931 = (parity_825 & parity_828) | ((^select_819[8:6]) & (parity_825 | parity_828));
  logic or_935;
  assign or_935 = (parity_837 & parity_840) | ((^select_802[5:3]) & (parity_837 | parity_840));
  // hls/stages/agreement.hpp:672
  logic parity_938;
  assign parity_938 = ^{or_935, or_931, or_927};
  logic parity_941;
  assign parity_941 = ^{or_935, or_931, or_927, or_920, or_916, or_912, or_905, or_901, and_897};
  logic xor_942;
  assign xor_942 = parity_896 ^ parity_941;
  // hls/stages/agreement.hpp:673
  logic and_943;
  assign and_943 = parity_896 & parity_941;
  logic or_947;
  assign or_947 = (parity_878 & parity_893) | ((^{or_859, or_855, or_851}) & (parity_878 | parity_893));
  logic or_951;
  assign or_951 = (parity_923 & parity_938) | ((^{or_905, or_901, and_897}) & (parity_923 | parity_938));
  logic or_958;
  assign or_958 = (or_855 & or_859) | (or_851 & (or_855 | or_859));
  logic or_962;
  assign or_962 = (or_871 & or_875) | (or_867 & (or_871 | or_875));
  logic or_966;
  assign or_966 = (or_886 & or_890) | (or_882 & (or_886 | or_890));
  // hls/stages/agreement.hpp:672
  logic parity_969;
  assign parity_969 = ^{or_966, or_962, or_958};
  // hls/stages/agreement.hpp:673
  logic or_973;
  assign or_973 = (or_901 & or_905) | (and_897 & (or_901 | or_905));
  logic or_977;
  assign or_977 = (or_916 & or_920) | (or_912 & (or_916 | or_920));
  logic or_981;
  assign or_981 = (or_931 & or_935) | (or_927 & (or_931 | or_935));
  // hls/stages/agreement.hpp:672
  logic parity_984;
  assign parity_984 = ^{or_981, or_977, or_973};
  logic parity_987;
  assign parity_987 = ^{or_981, or_977, or_973, or_966, or_962, or_958, or_951, or_947, and_943};
  // hls/stages/agreement.hpp:673
  logic or_991;
  assign or_991 = (parity_969 & parity_984) | ((^{or_951, or_947, and_943}) & (parity_969 | parity_984));
  logic or_995;
  assign or_995 = (or_947 & or_951) | (and_943 & (or_947 | or_951));
  logic or_999;
  assign or_999 = (or_962 & or_966) | (or_958 & (or_962 | or_966));
  logic or_1003;
  assign or_1003 = (or_977 & or_981) | (or_973 & (or_977 | or_981));
  // hls/stages/agreement.hpp:672
  logic parity_1008;
  assign parity_1008 = ^{or_1003, or_999, or_995, or_991};
  // hls/stages/agreement.hpp:673
  logic or_1012;
  assign or_1012 = (or_999 & or_1003) | (or_995 & (or_999 | or_1003));
  logic and_1013;
  assign and_1013 = or_991 & (^{or_1003, or_999, or_995});
  // hls/stages/agreement.hpp:672
  logic xor_1014;
  assign xor_1014 = or_1012 ^ and_1013;
  // hls/stages/agreement.hpp:675
  logic and_1015;
  assign and_1015 = or_1012 & and_1013;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1016;
  assign select_1016 = equal_391_s1_q ? {and_1015, xor_1014, parity_1008, parity_987, xor_942, xor_847} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_389_s1_q ? 6'h0 : select_1016;
  // hls/stages/agreement.hpp:205
  logic and_1024;
  assign and_1024 = right_codes_rdata_q[25] & not_397_s1_q;
  // hls/stages/agreement.hpp:733
  logic select_1025;
  assign select_1025 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_397_s1_q) : and_1024;
  // hls/stages/agreement.hpp:205
  logic [11:0] select_1027;
  assign select_1027 = less_396_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:733
  logic [11:0] select_1028;
  assign select_1028 = slot_s1_q[0] ? (less_396_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1027;
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1032;
  assign select_1032 = and_523 ? (select_1025 ? (~(select_526 ^ select_1028)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1038;
  assign parity_1038 = ^select_1032[5:3];
  logic parity_1041;
  assign parity_1041 = ^select_1032[8:6];
  logic parity_1044;
  assign parity_1044 = ^select_1032[11:3];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1052;
  assign select_1052 = (slot_s1_q[0] ? and_1024 : and_524) ? (~(select_549 ^ (slot_s1_q[0] ? select_1027 : select_525))) : 12'h0;
  logic [11:0] select_1053;
  assign select_1053 = and_546 ? select_1052 : 12'h0;
  // hls/stages/agreement.hpp:672
  logic parity_1056;
  assign parity_1056 = ^select_1053[8:6];
  logic parity_1059;
  assign parity_1059 = ^select_1053[11:9];
  // hls/stages/agreement.hpp:657
  logic [11:0] select_1067;
  assign select_1067 = (slot_s1_q[0] ? and_524 : and_547) ? (~(select_566 ^ (slot_s1_q[0] ? select_525 : select_548))) : 12'h0;
  logic [11:0] select_1068;
  assign select_1068 = and_563 ? select_1067 : 12'h0;
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
  logic xor_1096;
  assign xor_1096 = parity_1044 ^ parity_1095;
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
  logic and_1146;
  assign and_1146 = parity_1044 & parity_1095;
  logic or_1150;
  assign or_1150 = (parity_1038 & parity_1041) | ((^select_1032[11:9]) & (parity_1038 | parity_1041));
  logic and_1153;
  assign and_1153 = (^{select_1053[11:6], select_1032[2:0]}) & (parity_1080 | parity_1092);
  logic or_1154;
  assign or_1154 = (parity_1080 & parity_1092) | and_1153;
  // hls/stages/agreement.hpp:671
  logic or_1161;
  assign or_1161 = (select_1032[10:9] == 2'h3) | (select_1032[11] & (select_1032[9] | select_1032[10]));
  // hls/stages/agreement.hpp:673
  logic or_1165;
  assign or_1165 = (select_1032[4:3] == 2'h3) | (select_1032[5] & (select_1032[3] | select_1032[4]));
  logic or_1169;
  assign or_1169 = (select_1032[7:6] == 2'h3) | (select_1032[8] & (select_1032[6] | select_1032[7]));
  // hls/stages/agreement.hpp:672
  logic parity_1172;
  assign parity_1172 = ^{or_1169, or_1165, or_1161};
  // hls/stages/agreement.hpp:673
  logic or_1176;
  assign or_1176 = (parity_1056 & parity_1059) | ((^select_1032[2:0]) & (parity_1056 | parity_1059));
  logic or_1180;
  assign or_1180 = (parity_1074 & parity_1077) | ((^select_1068[8:6]) & (parity_1074 | parity_1077));
  logic or_1184;
  assign or_1184 = (parity_1086 & parity_1089) | ((^select_1053[5:3]) & (parity_1086 | parity_1089));
  // hls/stages/agreement.hpp:672
  logic parity_1187;
  assign parity_1187 = ^{or_1184, or_1180, or_1176};
  logic parity_1190;
  assign parity_1190 = ^{or_1184, or_1180, or_1176, or_1169, or_1165, or_1161, or_1154, or_1150, and_1146};
  logic xor_1191;
  assign xor_1191 = parity_1145 ^ parity_1190;
  // hls/stages/agreement.hpp:673
  logic and_1192;
  assign and_1192 = parity_1145 & parity_1190;
  logic or_1196;
  assign or_1196 = (parity_1127 & parity_1142) | ((^{or_1108, or_1104, or_1100}) & (parity_1127 | parity_1142));
  logic or_1200;
  assign or_1200 = (parity_1172 & parity_1187) | ((^{or_1154, or_1150, and_1146}) & (parity_1172 | parity_1187));
  logic or_1207;
  assign or_1207 = (or_1104 & or_1108) | (or_1100 & (or_1104 | or_1108));
  logic or_1211;
  assign or_1211 = (or_1120 & or_1124) | (or_1116 & (or_1120 | or_1124));
  logic or_1215;
  assign or_1215 = (or_1135 & or_1139) | (or_1131 & (or_1135 | or_1139));
  // hls/stages/agreement.hpp:672
  logic parity_1218;
  assign parity_1218 = ^{or_1215, or_1211, or_1207};
  // hls/stages/agreement.hpp:673
  logic or_1222;
  assign or_1222 = (or_1150 & or_1154) | (and_1146 & (or_1150 | or_1154));
  logic or_1226;
  assign or_1226 = (or_1165 & or_1169) | (or_1161 & (or_1165 | or_1169));
  logic or_1230;
  assign or_1230 = (or_1180 & or_1184) | (or_1176 & (or_1180 | or_1184));
  // hls/stages/agreement.hpp:672
  logic parity_1233;
  assign parity_1233 = ^{or_1230, or_1226, or_1222};
  logic parity_1236;
  assign parity_1236 = ^{or_1230, or_1226, or_1222, or_1215, or_1211, or_1207, or_1200, or_1196, and_1192};
  // hls/stages/agreement.hpp:673
  logic or_1240;
  assign or_1240 = (parity_1218 & parity_1233) | ((^{or_1200, or_1196, and_1192}) & (parity_1218 | parity_1233));
  logic or_1244;
  assign or_1244 = (or_1196 & or_1200) | (and_1192 & (or_1196 | or_1200));
  logic or_1248;
  assign or_1248 = (or_1211 & or_1215) | (or_1207 & (or_1211 | or_1215));
  logic or_1252;
  assign or_1252 = (or_1226 & or_1230) | (or_1222 & (or_1226 | or_1230));
  // hls/stages/agreement.hpp:672
  logic parity_1257;
  assign parity_1257 = ^{or_1252, or_1248, or_1244, or_1240};
  // hls/stages/agreement.hpp:673
  logic or_1261;
  assign or_1261 = (or_1248 & or_1252) | (or_1244 & (or_1248 | or_1252));
  logic and_1262;
  assign and_1262 = or_1240 & (^{or_1252, or_1248, or_1244});
  // hls/stages/agreement.hpp:672
  logic xor_1263;
  assign xor_1263 = or_1261 ^ and_1262;
  // hls/stages/agreement.hpp:675
  logic and_1264;
  assign and_1264 = or_1261 & and_1262;
  // hls/stages/agreement.hpp:137
  logic [5:0] select_1265;
  assign select_1265 = equal_391_s1_q ? {and_1264, xor_1263, parity_1257, parity_1236, xor_1191, xor_1096} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_389_s1_q ? 6'h0 : select_1265;
  // hls/stages/agreement.hpp:942
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:943
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:944
  logic [5:0] select_1323;
  assign select_1323 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:947
  logic and_1343;
  assign and_1343 = (or_389_s1_q & (left_rdata_q[61] & not_397_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:228
  logic or_1365;
  assign or_1365 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:392
  logic [5:0] select_1376;
  assign select_1376 = so_s1_q ? x_s1_q[5:0] : (or_389_s1_q ? (less_396_s1_q ? 6'h0 : select_1323) : 6'h0);
  // hls/stages/agreement.hpp:970
  logic [4:0] sum_1419;
  assign sum_1419 = {1'b0, last_s1_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:392
  logic and_1598;
  assign and_1598 = ((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & (~({1'b0, sum_1419, last_s1_q[1:0]} < x_s1_q));
  // hls/stages/agreement.hpp:436
  logic select_1967;
  assign select_1967 = equal_1870_s1_q ? (~({row_s1_q, 1'b0} < {sum_1964, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:495
  logic and_2194;
  assign and_2194 = and_368_s1_q & (equal_1870_s1_q & (row_s1_q[5:2] == 4'h0));

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_335_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_343;
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
  assign best_right_raddr = or_389_s1_q ? select_1323 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_510_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_400_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_492, left_rdata_q[59:45], and_491, left_rdata_q[43:29], and_490, left_rdata_q[27:13], and_489, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_400_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_501, right_codes_rdata_q[76:65], and_500, right_codes_rdata_q[63:52], and_499, right_codes_rdata_q[50:39], and_498, right_codes_rdata_q[37:26], and_497, right_codes_rdata_q[24:13], and_496, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_368_s1_q ? (equal_1870_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_368_s1_q ? select_1967 : lower_half_q;
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
  logic select_329_s2_q;
  logic [7:0] select_335_s2_q;
  logic and_342_s2_q;
  logic and_343_s2_q;
  logic equal_348_s2_q;
  logic whole_s2_q;
  logic [5:0] column_s2_q;
  logic and_366_s2_q;
  logic and_368_s2_q;
  logic equal_371_s2_q;
  logic so_s2_q;
  logic equal_388_s2_q;
  logic or_389_s2_q;
  logic less_396_s2_q;
  logic not_397_s2_q;
  logic equal_429_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_517_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1018_s2_q;
  logic [5:0] select_1267_s2_q;
  logic and_1319_s2_q;
  logic [5:0] right_s2_q;
  logic select_1328_s2_q;
  logic equal_1337_s2_q;
  logic and_1344_s2_q;
  logic and_1347_s2_q;
  logic and_1351_s2_q;
  logic or_1365_s2_q;
  logic [5:0] select_1376_s2_q;
  logic less_1420_s2_q;
  logic equal_1460_s2_q;
  logic and_1510_s2_q;
  logic and_1600_s2_q;
  logic equal_1746_s2_q;
  logic equal_1870_s2_q;
  logic less_2123_s2_q;
  logic and_2195_s2_q;
  logic and_2197_s2_q;
  logic less_2304_s2_q;
  logic equal_2511_s2_q;
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
      select_329_s2_q <= select_329_s1_q;
      select_335_s2_q <= select_335_s1_q;
      and_342_s2_q <= and_342_s1_q;
      and_343_s2_q <= and_343;
      equal_348_s2_q <= equal_348_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_366_s2_q <= and_366_s1_q;
      and_368_s2_q <= and_368_s1_q;
      equal_371_s2_q <= equal_371_s1_q;
      so_s2_q <= so_s1_q;
      equal_388_s2_q <= equal_388_s1_q;
      or_389_s2_q <= or_389_s1_q;
      less_396_s2_q <= less_396_s1_q;
      not_397_s2_q <= not_397_s1_q;
      equal_429_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_517_s2_q <= select_517_s1_q;
      column_2_s2_q <= column_2;
      select_1018_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1267_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1319_s2_q <= and_1319_s1_q;
      right_s2_q <= right_s1_q;
      select_1328_s2_q <= select_1328_s1_q;
      equal_1337_s2_q <= equal_1337_s1_q;
      and_1344_s2_q <= not_397_s1_q & and_1343;
      and_1347_s2_q <= (or_389_s1_q & (left_rdata_q[62] & not_397_s1_q)) & and_1343;
      and_1351_s2_q <= not_397_s1_q & (or_389_s1_q & (left_rdata_q[63] & not_397_s1_q));
      or_1365_s2_q <= or_1365;
      select_1376_s2_q <= select_1376;
      less_1420_s2_q <= {2'h0, sum_1419, last_s1_q[1]} < x_s1_q;
      equal_1460_s2_q <= x_s1_q == {2'h0, last_s1_q};
      and_1510_s2_q <= sample_pair_whole_q;
      and_1600_s2_q <= so_s1_q & (ends_cell_s1_q & and_1598);
      equal_1746_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_1870_s2_q <= equal_1870_s1_q;
      less_2123_s2_q <= 5'h4 < row_q[5:1];
      and_2195_s2_q <= and_1871_s1_q & and_2194;
      and_2197_s2_q <= and_1871_s1_q & (~and_2194);
      less_2304_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2511_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [11:0] select_346;
  assign select_346 = select_329_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_350;
  assign sum_350 = select_346 + (equal_348_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_352;
  assign sum_352 = {4'h0, sample_pair_pixel_1_q} + (select_329_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_354;
  assign sum_354 = sum_352 + (equal_348_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:122
  logic and_358;
  assign and_358 = whole_s2_q & (averager_memory_rdata_q[24] | equal_348_s2_q);
  // hls/stages/agreement.hpp:394
  logic all_of_skin;
  assign all_of_skin = select_329_s2_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_362;
  assign and_362 = all_of_skin & (averager_memory_rdata_q[25] | equal_348_s2_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_342_s2_q ? sum_350[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_342_s2_q ? sum_354[11:3] : 9'h0;
  logic and_379;
  assign and_379 = and_342_s2_q & and_358;
  // hls/stages/census.hpp:126
  logic select_381;
  assign select_381 = equal_371_s2_q ? and_379 : (averager_mask_q & and_379);
  // hls/stages/agreement.hpp:255
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_381;
  // hls/stages/census.hpp:206
  logic and_383;
  assign and_383 = and_342_s2_q & and_362;
  // hls/stages/census.hpp:126
  logic select_385;
  assign select_385 = equal_371_s2_q ? and_383 : (averager_of_skin_q & and_383);
  // hls/stages/agreement.hpp:787
  logic not_519;
  assign not_519 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_520;
  assign less_520 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:224
  logic and_522;
  assign and_522 = not_519 & (~less_520);
  // hls/stages/agreement.hpp:777
  logic [5:0] select_769;
  assign select_769 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_770;
  assign difference_770 = {1'b0, column_2_s2_q} - {1'b0, select_769};
  logic [7:0] sum_772;
  assign sum_772 = {difference_770[6], difference_770} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:754
  logic [7:0] select_773;
  assign select_773 = slot_s2_q[0] ? chosen_score_q : sum_772;
  // hls/stages/agreement.hpp:777
  logic [6:0] difference_1019;
  assign difference_1019 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1018_s2_q};
  // hls/stages/agreement.hpp:748
  logic equal_1020;
  assign equal_1020 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:777
  logic [7:0] sum_1022;
  assign sum_1022 = {difference_1019[6], difference_1019} + (equal_1020 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1268;
  assign difference_1268 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1267_s2_q};
  logic [7:0] sum_1270;
  assign sum_1270 = {difference_1268[6], difference_1268} + (equal_1020 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:750
  logic less_1271;
  assign less_1271 = sum_1022 < sum_1270;
  logic [7:0] select_1272;
  assign select_1272 = less_1271 ? sum_1270 : sum_1022;
  logic less_1273;
  assign less_1273 = select_773 < select_1272;
  // hls/stages/agreement.hpp:791
  logic [7:0] of_best;
  assign of_best = and_522 ? (less_1273 ? select_1272 : select_773) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic or_1277;
  assign or_1277 = select_517_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:803
  logic [5:0] select_1278;
  assign select_1278 = or_1277 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:719
  logic not_1279;
  assign not_1279 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:751
  logic [1:0] select_1280;
  assign select_1280 = less_1271 ? {slot_s2_q[0], not_1279} : 2'h0;
  logic [2:0] select_1282;
  assign select_1282 = less_1273 ? {select_1280, not_1279} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:803
  logic [2:0] select_1283;
  assign select_1283 = or_1277 ? select_1282 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1284;
  assign select_1284 = or_1277 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:800
  logic equal_1285;
  assign equal_1285 = select_1282 == 3'h1;
  logic equal_1286;
  assign equal_1286 = select_1282 == 3'h2;
  logic not_1287;
  assign not_1287 = ~equal_1286;
  logic [2:0] select_1288;
  assign select_1288 = equal_1285 ? 3'h2 : {not_1287, {2{equal_1286}}};
  // hls/stages/agreement.hpp:220
  logic [7:0] select_1291;
  assign select_1291 = slot_s2_q[0] ? 8'h0 : sum_772;
  // hls/stages/agreement.hpp:800
  logic [7:0] select_1293;
  assign select_1293 = select_1288[1] ? (select_1288[0] ? before_1_q : sum_1022) : (select_1288[0] ? sum_1022 : select_1291);
  logic [7:0] select_1294;
  assign select_1294 = select_1288[2] ? (select_1288[0] ? before_2_q : before_0_q) : select_1293;
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1295;
  assign select_1295 = or_1277 ? select_1294 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:801
  logic [1:0] select_1296;
  assign select_1296 = equal_1285 ? 2'h0 : {not_1287, equal_1286};
  logic [7:0] select_1298;
  assign select_1298 = select_1296[1] ? sum_1270 : (select_1296[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1299;
  assign select_1299 = or_1277 ? select_1298 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1301;
  assign sum_1301 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1302;
  assign sum_1302 = {1'b0, before_v} + sum_1301;
  // hls/stages/agreement.hpp:754
  logic [6:0] select_1303;
  assign select_1303 = slot_s2_q[0] ? chosen_near_q : sum_1302;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1305;
  assign sum_1305 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1306;
  assign sum_1306 = {1'b0, before_v_2} + sum_1305;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1308;
  assign sum_1308 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1309;
  assign sum_1309 = {1'b0, before_v_3} + sum_1308;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1311;
  assign select_1311 = (sum_1306 < sum_1309) ? sum_1309 : sum_1306;
  // hls/stages/agreement.hpp:792
  logic [6:0] of_near;
  assign of_near = and_522 ? ((select_1303 < select_1311) ? select_1311 : select_1303) : 7'h0;
  // hls/stages/agreement.hpp:803
  logic or_1316;
  assign or_1316 = select_517_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:807
  logic [6:0] select_1317;
  assign select_1317 = or_1316 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1318;
  assign select_1318 = or_1316 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:812
  logic or_1330;
  assign or_1330 = select_1328_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:816
  logic [7:0] select_1331;
  assign select_1331 = or_1330 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1332;
  assign select_1332 = or_1330 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1334;
  assign or_1334 = select_1328_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:820
  logic [6:0] select_1335;
  assign select_1335 = or_1334 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1336;
  assign select_1336 = or_1334 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:970
  logic not_1338;
  assign not_1338 = ~equal_1337_s2_q;
  // hls/stages/agreement.hpp:228
  logic and_1348;
  assign and_1348 = not_397_s2_q & and_1347_s2_q;
  // hls/stages/agreement.hpp:950
  logic select_1354;
  assign select_1354 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:951
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:957
  logic [8:0] difference_1357;
  assign difference_1357 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:958
  logic [9:0] sum_1358;
  assign sum_1358 = {difference_1357[8], difference_1357} + 10'h1;
  // hls/stages/agreement.hpp:228
  logic and_1360;
  assign and_1360 = (and_1347_s2_q & select_1354) & ({{22{sum_1358[9]}}, sum_1358} < 32'h3);
  logic and_1361;
  assign and_1361 = not_397_s2_q & and_1360;
  logic and_1367;
  assign and_1367 = not_397_s2_q & (and_1360 & or_1365_s2_q);
  // hls/stages/agreement.hpp:137
  logic [8:0] select_1368;
  assign select_1368 = less_396_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_389_s2_q ? {select_1368, and_1367, and_1361, and_1351_s2_q, and_1348, and_1344_s2_q, not_397_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:392
  logic and_1370;
  assign and_1370 = ends_cell_s2_q & inside_v[0];
  logic and_1372;
  assign and_1372 = not_1338 & (so_s2_q & and_1370);
  // hls/stages/agreement.hpp:243
  logic right_2;
  assign right_2 = inside_v[0] & less_1420_s2_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:255
  logic select_1659;
  assign select_1659 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1661;
  assign select_1661 = sample_pair_whole_s2_q ? (and_366_s2_q ? select_381 : averager_mask_q) : averager_mask_q;
  logic select_1663;
  assign select_1663 = sample_pair_whole_s2_q ? (and_366_s2_q ? select_385 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:220
  logic [5:0] select_1970;
  assign select_1970 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_1971;
  assign select_1971 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1972;
  assign select_1972 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_1973;
  assign select_1973 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1974;
  assign select_1974 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1975;
  assign select_1975 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:750
  logic less_1979;
  assign less_1979 = select_1291 < select_1272;
  // hls/stages/agreement.hpp:220
  logic [6:0] select_1981;
  assign select_1981 = slot_s2_q[0] ? 7'h0 : sum_1302;
  // hls/stages/registration.hpp:76
  logic less_2070;
  assign less_2070 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:137
  logic [7:0] select_2072;
  assign select_2072 = or_389_s2_q ? (less_396_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2074;
  assign select_2074 = or_389_s2_q ? (less_396_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2076;
  assign select_2076 = or_389_s2_q ? (less_396_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2074} - {1'b0, select_2076};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2078;
  assign select_2078 = rise[8] ? select_2074 : select_2076;
  logic [8:0] difference_2079;
  assign difference_2079 = {1'b0, select_2072} - {1'b0, select_2078};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2079[8] ? 8'h0 : difference_2079[7:0];
  // hls/stages/registration.hpp:37
  logic not_2081;
  assign not_2081 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2070 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2081};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2083;
  assign xor_2083 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2083};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2089;
  assign select_2089 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2070 ? {taken, 1'b1} : {not_2081, select_2089, not_2081};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2091;
  assign sum_2091 = {left, 1'b1} + {taken_2, less_2070};
  // hls/stages/agreement.hpp:238
  logic [4:0] select_2093;
  assign select_2093 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;

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
  assign census_memory_re = s2_en & and_368_s2_q;
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
  assign shown_right_re = s2_en & and_1372;
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
  assign seen_columns_re = s2_en & and_1372;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_335_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_343_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_362, and_358, sum_354, sum_350};
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
  assign best_left_we = s2_en & and_1319_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1318, select_1317, select_1299, select_1295, select_1284, select_1283, select_1278};
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
  assign best_right_we = s2_en & and_1319_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1336, select_1335, select_1332, select_1331};
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
      averager_running_of_skin_q <= select_1659;
      averager_mask_q <= select_1661;
      averager_of_skin_q <= select_1663;
      chosen_score_q <= less_1979 ? select_1272 : select_1291;
      chosen_near_q <= (select_1981 < select_1311) ? select_1311 : select_1981;
      chosen_place_q <= less_1979 ? {select_1280, not_1279} : 3'h2;
      before_0_q <= select_1291;
      before_1_q <= sum_1022;
      before_2_q <= sum_1270;
      registration_displacement_over_q <= so_s2_q ? sum_2091[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2093;
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
      left_pixel_q <= and_1510_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_346 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_352 : averager_running_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_1970;
      middle_sum_columns_values_2_q <= select_1971;
      middle_sum_columns_values_3_q <= select_1972;
      middle_sum_columns_values_4_q <= select_1973;
      middle_sum_columns_values_5_q <= select_1974;
      middle_sum_columns_values_6_q <= select_1975;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_772;
      sums_0_sum_sums_values_0_q <= sum_1022;
      sums_0_sum_sums_values_1_q <= equal_1020 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1270;
      sums_1_sum_sums_values_1_q <= equal_1020 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic and_366_s3_q;
  logic and_368_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_371_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic and_386_s3_q;
  logic so_s3_q;
  logic equal_429_s3_q;
  logic equal_1337_s3_q;
  logic not_1338_s3_q;
  logic [13:0] inside_v_s3_q;
  logic and_1372_s3_q;
  logic [5:0] select_1376_s3_q;
  logic and_1381_s3_q;
  logic right_2_s3_q;
  logic equal_1460_s3_q;
  logic textured_s3_q;
  logic and_1510_s3_q;
  logic and_1601_s3_q;
  logic equal_1746_s3_q;
  logic equal_1870_s3_q;
  logic and_2124_s3_q;
  logic less_2129_s3_q;
  logic and_2195_s3_q;
  logic and_2197_s3_q;
  logic less_2304_s3_q;
  logic equal_2511_s3_q;
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
      and_366_s3_q <= and_366_s2_q;
      and_368_s3_q <= and_368_s2_q;
      grey_s3_q <= grey;
      equal_371_s3_q <= equal_371_s2_q;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      and_386_s3_q <= sample_pair_whole_s2_q & select_385;
      so_s3_q <= so_s2_q;
      equal_429_s3_q <= equal_429_s2_q;
      equal_1337_s3_q <= equal_1337_s2_q;
      not_1338_s3_q <= not_1338;
      inside_v_s3_q <= {inside_v[14:3], inside_v[1:0]};
      and_1372_s3_q <= and_1372;
      select_1376_s3_q <= select_1376_s2_q;
      and_1381_s3_q <= not_1338 & (so_s2_q ? and_1370 : (equal_388_s2_q & inside_v[4]));
      right_2_s3_q <= right_2;
      equal_1460_s3_q <= equal_1460_s2_q;
      textured_s3_q <= textured;
      and_1510_s3_q <= and_1510_s2_q;
      and_1601_s3_q <= not_1338 & and_1600_s2_q;
      equal_1746_s3_q <= equal_1746_s2_q;
      equal_1870_s3_q <= equal_1870_s2_q;
      and_2124_s3_q <= inside_v[4] & less_2123_s2_q;
      less_2129_s3_q <= select_2074 < select_2076;
      and_2195_s3_q <= and_2195_s2_q;
      and_2197_s3_q <= and_2197_s2_q;
      less_2304_s3_q <= less_2304_s2_q;
      equal_2511_s3_q <= equal_2511_s2_q;
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
  assign total = {2'h0, grey_s3_q} + (equal_371_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:255
  logic [8:0] select_374;
  assign select_374 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_371_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:255
  logic [8:0] select_378;
  assign select_378 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:294
  logic less_402;
  assign less_402 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_403;
  assign less_403 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
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
  assign less_414 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_415;
  assign less_415 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
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
  assign equal_426 = column_s3_q == 6'h0;
  logic [3:0] select_430;
  assign select_430 = equal_429_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:432
  logic [4:0] select_431;
  assign select_431 = equal_426 ? {select_430, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_432;
  assign select_432 = equal_426 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_433;
  assign and_433 = select_431[4] & select_432[3];
  // hls/stages/census.hpp:286
  logic and_435;
  assign and_435 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_437;
  assign and_437 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_435);
  // hls/stages/agreement.hpp:432
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_437;
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
  logic [9:0] difference_460;
  assign difference_460 = {1'b0, select_374} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_461;
  assign xor_461 = difference_460[8:0] ^ {9{difference_460[9]}};
  logic [9:0] sum_462;
  assign sum_462 = {9'h0, difference_460[9]} + {1'b0, xor_461};
  logic [9:0] difference_463;
  assign difference_463 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_464;
  assign xor_464 = difference_463[8:0] ^ {9{difference_463[9]}};
  logic [9:0] sum_465;
  assign sum_465 = {9'h0, difference_463[9]} + {1'b0, xor_464};
  logic [9:0] difference_467;
  assign difference_467 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_468;
  assign xor_468 = difference_467[8:0] ^ {9{difference_467[9]}};
  logic [9:0] sum_469;
  assign sum_469 = {9'h0, difference_467[9]} + {1'b0, xor_468};
  logic [10:0] sum_470;
  assign sum_470 = ({1'b0, sum_462} + {1'b0, sum_465}) + {1'b0, sum_469};
  logic [9:0] difference_471;
  assign difference_471 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_472;
  assign xor_472 = difference_471[8:0] ^ {9{difference_471[9]}};
  logic [9:0] sum_473;
  assign sum_473 = {9'h0, difference_471[9]} + {1'b0, xor_472};
  logic [9:0] difference_475;
  assign difference_475 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_476;
  assign xor_476 = difference_475[8:0] ^ {9{difference_475[9]}};
  logic [9:0] sum_477;
  assign sum_477 = {9'h0, difference_475[9]} + {1'b0, xor_476};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_470} + {2'h0, sum_473}) + {2'h0, sum_477};
  // hls/stages/agreement.hpp:186
  logic not_1377;
  assign not_1377 = ~so_s3_q;
  // hls/stages/agreement.hpp:392
  logic and_1378;
  assign and_1378 = not_1377 & inside_v_s3_q[4];
  // hls/stages/agreement.hpp:1082
  logic equal_1382;
  assign equal_1382 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1122
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1083
  logic [1:0] select_1385;
  assign select_1385 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1095
  logic [3:0] select_1387;
  assign select_1387 = equal_1382 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1385});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1388;
  assign sum_1388 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_1389;
  assign select_1389 = equal_1337_s3_q ? select_1387 : {sum_1388, lower_half_s3_q, registration_of_right_q};
  // hls/stages/agreement.hpp:1120
  logic equal_1390;
  assign equal_1390 = x_s3_q[5:0] == 6'h3e;
  logic equal_1392;
  assign equal_1392 = x_s3_q[5:0] == 6'h3d;
  logic equal_1394;
  assign equal_1394 = x_s3_q[5:0] == 6'h3c;
  logic equal_1396;
  assign equal_1396 = x_s3_q[5:0] == 6'h3b;
  logic equal_1398;
  assign equal_1398 = x_s3_q[5:0] == 6'h36;
  logic equal_1400;
  assign equal_1400 = x_s3_q[5:0] == 6'h35;
  logic equal_1402;
  assign equal_1402 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1122
  logic and_1406;
  assign and_1406 = (~equal_1396) & ((~equal_1398) & ((~equal_1400) & (~equal_1402)));
  // hls/stages/agreement.hpp:1083
  logic less_1410;
  assign less_1410 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_1414;
  assign or_1414 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1095
  logic select_1417;
  assign select_1417 = equal_1382 ? ((~equal_1390) & ((~equal_1392) & ((~equal_1394) & and_1406))) : (less_1410 & (~or_1414));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1425;
  assign sum_1425 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1427;
  assign and_1427 = half_ends & ({{3{sum_1425[4]}}, sum_1425} < 8'h3);
  // hls/stages/agreement.hpp:392
  logic and_1428;
  assign and_1428 = so_s3_q & and_1427;
  // hls/stages/registration.hpp:253
  logic not_1431;
  assign not_1431 = ~lower_half_s3_q;
  logic [3:0] select_1432;
  assign select_1432 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1431, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1431};
  // hls/stages/agreement.hpp:190
  logic [7:0] select_1445;
  assign select_1445 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1004
  logic or_1448;
  assign or_1448 = select_1445[7] | (~({select_1445[5], select_1445[3], select_1445[1]} == 3'h0));
  // hls/stages/agreement.hpp:1003
  logic or_1451;
  assign or_1451 = select_1445[7] | (~({select_1445[6], select_1445[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1002
  logic or_1454;
  assign or_1454 = select_1445[7] | (~(select_1445[6:4] == 3'h0));
  // hls/stages/agreement.hpp:392
  logic [5:0] select_1455;
  assign select_1455 = equal_1337_s3_q ? x_s3_q[5:0] : {region_row_q, or_1454, or_1451, or_1448};
  // hls/stages/agreement.hpp:1082
  logic not_1456;
  assign not_1456 = ~equal_1382;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1458;
  assign sum_1458 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1012
  logic or_1461;
  assign or_1461 = (~sum_1458[5]) | equal_1460_s3_q;
  // hls/stages/agreement.hpp:392
  logic and_1464;
  assign and_1464 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & or_1461));
  // hls/stages/agreement.hpp:243
  logic explained;
  assign explained = inside_v_s3_q[0] & inside_v_s3_q[3];
  logic and_1478;
  assign and_1478 = inside_v_s3_q[0] & ({inside_v_s3_q[4], inside_v_s3_q[2]} == 2'h3);
  logic and_1485;
  assign and_1485 = inside_v_s3_q[0] & inside_v_s3_q[2];
  // hls/stages/agreement.hpp:975
  logic select_1486;
  assign select_1486 = slot_s3_q[2] ? shown_shown_q : inside_v_s3_q[3];
  // hls/stages/agreement.hpp:243
  logic shown;
  assign shown = inside_v_s3_q[0] & (shown_right_rdata_q[0] | select_1486);
  // hls/stages/agreement.hpp:975
  logic select_1489;
  assign select_1489 = slot_s3_q[2] ? shown_nearer_q : inside_v_s3_q[4];
  // hls/stages/agreement.hpp:243
  logic near;
  assign near = inside_v_s3_q[0] & (select_1486 ? select_1489 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1203
  logic select_1492;
  assign select_1492 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1207
  logic select_1493;
  assign select_1493 = left_first_s3_q ? select_1492 : read_half_q;
  logic or_1494;
  assign or_1494 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1208
  logic [8:0] select_1495;
  assign select_1495 = or_1494 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1209
  logic [9:0] select_1497;
  assign select_1497 = left_first_s3_q ? 10'h1 : (or_1494 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1212
  logic and_1498;
  assign and_1498 = select_1495[8] & select_1497[9];
  // hls/stages/agreement.hpp:411
  logic next_row;
  assign next_row = and_1498 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1223
  logic [5:0] select_1501;
  assign select_1501 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1503;
  assign select_1503 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1501});
  // hls/stages/agreement.hpp:1233
  logic equal_1504;
  assign equal_1504 = seen_x_q == 3'h7;
  logic [7:0] select_1506;
  assign select_1506 = and_1498 ? 8'h0 : (seen_column_q + {7'h0, equal_1504});
  // hls/stages/agreement.hpp:1240
  logic [10:0] index;
  assign index = select_1503 + {3'h0, select_1506};
  // hls/stages/agreement.hpp:1193
  logic [11:0] sum_1508;
  assign sum_1508 = {1'b0, {2{select_1493}}, 2'h0, {2{select_1493}}, 1'b0, {2{select_1493}}, 1'b0, select_1493} + {1'b0, index};
  // hls/stages/agreement.hpp:1206
  logic not_1511;
  assign not_1511 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:411
  logic and_1513;
  assign and_1513 = not_1511 & (began_q | and_1498);
  // hls/stages/agreement.hpp:1234
  logic [2:0] select_1515;
  assign select_1515 = and_1498 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1239
  logic and_1517;
  assign and_1517 = and_1513 & (select_1515 == 3'h0);
  logic less_1518;
  assign less_1518 = select_1506 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:413
  logic and_1519;
  assign and_1519 = and_1517 & less_1518;
  logic and_1520;
  assign and_1520 = and_1510_s3_q & and_1519;
  // hls/stages/agreement.hpp:257
  logic select_1522;
  assign select_1522 = and_1510_s3_q ? (left_first_s3_q ? and_1519 : and_1520) : and_1520;
  // hls/stages/agreement.hpp:1065
  logic [7:0] sum_1524;
  assign sum_1524 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1524[7], sum_1524, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1193
  logic [11:0] sum_1526;
  assign sum_1526 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:988
  logic and_1527;
  assign and_1527 = seen_columns_rdata_q[14] & inside_v_s3_q[0];
  logic and_1528;
  assign and_1528 = seen_columns_rdata_q[10] & inside_v_s3_q[0];
  logic and_1529;
  assign and_1529 = seen_columns_rdata_q[5] & inside_v_s3_q[0];
  logic and_1530;
  assign and_1530 = seen_columns_rdata_q[0] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_1532;
  assign sum_1532 = {1'b0, and_1529} + ({1'b0, textured_s3_q} + {1'b0, and_1530});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1527} + ({2'h0, and_1528} + {1'b0, sum_1532});
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_1535;
  assign select_1535 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1536;
  assign difference_1536 = {1'b0, textured_2} - {1'b0, select_1535};
  // hls/stages/agreement.hpp:1046
  logic equal_1537;
  assign equal_1537 = x_s3_q == 8'h0;
  // hls/stages/agreement.hpp:1048
  logic [4:0] t;
  assign t = {difference_1536[3], difference_1536} + (equal_1537 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] select_1542;
  assign select_1542 = inside_v_s3_q[0] ? (sum_1458[5] ? select_1445 : {select_1445[6:0], 1'b0}) : select_1445;
  // hls/stages/agreement.hpp:1004
  logic or_1545;
  assign or_1545 = select_1542[7] | (~({select_1542[5], select_1542[3], select_1542[1]} == 3'h0));
  // hls/stages/agreement.hpp:988
  logic and_1562;
  assign and_1562 = seen_columns_rdata_q[16] & inside_v_s3_q[0];
  logic and_1563;
  assign and_1563 = seen_columns_rdata_q[12] & inside_v_s3_q[0];
  logic and_1564;
  assign and_1564 = seen_columns_rdata_q[8] & inside_v_s3_q[0];
  logic and_1565;
  assign and_1565 = seen_columns_rdata_q[3] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1043
  logic [1:0] sum_1567;
  assign sum_1567 = {1'b0, and_1564} + ({1'b0, shown} + {1'b0, and_1565});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1562} + ({2'h0, and_1563} + {1'b0, sum_1567});
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_1570;
  assign select_1570 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_1571;
  assign difference_1571 = {1'b0, shown_2} - {1'b0, select_1570};
  logic [4:0] around;
  assign around = {difference_1571[3], difference_1571} + (equal_1537 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_1574;
  assign sum_1574 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:988
  logic and_1578;
  assign and_1578 = seen_columns_rdata_q[17] & inside_v_s3_q[0];
  logic and_1579;
  assign and_1579 = seen_columns_rdata_q[13] & inside_v_s3_q[0];
  logic and_1580;
  assign and_1580 = seen_columns_rdata_q[9] & inside_v_s3_q[0];
  logic and_1581;
  assign and_1581 = seen_columns_rdata_q[4] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1044
  logic [1:0] sum_1583;
  assign sum_1583 = {1'b0, and_1580} + ({1'b0, near} + {1'b0, and_1581});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1578} + ({2'h0, and_1579} + {1'b0, sum_1583});
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_1586;
  assign select_1586 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_1587;
  assign difference_1587 = {1'b0, near_2} - {1'b0, select_1586};
  logic [4:0] n;
  assign n = {difference_1587[3], difference_1587} + (equal_1537 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:255
  logic [10:0] select_1638;
  assign select_1638 = sample_pair_whole_s3_q ? (and_366_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1640;
  assign select_1640 = sample_pair_whole_s3_q ? (and_366_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:495
  logic [8:0] select_1664;
  assign select_1664 = and_368_s3_q ? select_374 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1665;
  assign select_1665 = and_368_s3_q ? select_378 : census_columns_values_0_cell_0_right_q;
  logic select_1666;
  assign select_1666 = and_368_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1667;
  assign select_1667 = and_368_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1668;
  assign select_1668 = and_368_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1669;
  assign select_1669 = and_368_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1670;
  assign select_1670 = and_368_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1671;
  assign select_1671 = and_368_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1672;
  assign select_1672 = and_368_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1673;
  assign select_1673 = and_368_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1674;
  assign select_1674 = and_368_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1675;
  assign select_1675 = and_368_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1676;
  assign select_1676 = and_368_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1677;
  assign select_1677 = and_368_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1678;
  assign select_1678 = and_368_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1679;
  assign select_1679 = and_368_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1680;
  assign select_1680 = and_368_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1681;
  assign select_1681 = and_368_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1682;
  assign select_1682 = and_368_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1683;
  assign select_1683 = and_368_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1684;
  assign select_1684 = and_368_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1685;
  assign select_1685 = and_368_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1686;
  assign select_1686 = and_368_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1687;
  assign select_1687 = and_368_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1688;
  assign select_1688 = and_368_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1689;
  assign select_1689 = and_368_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1690;
  assign select_1690 = and_368_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1691;
  assign select_1691 = and_368_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1692;
  assign select_1692 = and_368_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1693;
  assign select_1693 = and_368_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1694;
  assign select_1694 = and_368_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1695;
  assign select_1695 = and_368_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1696;
  assign select_1696 = and_368_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1697;
  assign select_1697 = and_368_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1698;
  assign select_1698 = and_368_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1699;
  assign select_1699 = and_368_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1700;
  assign select_1700 = and_368_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1701;
  assign select_1701 = and_368_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1702;
  assign select_1702 = and_368_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1703;
  assign select_1703 = and_368_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1704;
  assign select_1704 = and_368_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1705;
  assign select_1705 = and_368_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1706;
  assign select_1706 = and_368_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1707;
  assign select_1707 = and_368_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1708;
  assign select_1708 = and_368_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1709;
  assign select_1709 = and_368_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1710;
  assign select_1710 = and_368_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1711;
  assign select_1711 = and_368_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1712;
  assign select_1712 = and_368_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1713;
  assign select_1713 = and_368_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1714;
  assign select_1714 = and_368_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1715;
  assign select_1715 = and_368_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1716;
  assign select_1716 = and_368_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1717;
  assign select_1717 = and_368_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1718;
  assign select_1718 = and_368_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1719;
  assign select_1719 = and_368_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_1721;
  assign difference_1721 = {1'b0, select_378} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1722;
  assign xor_1722 = difference_1721[8:0] ^ {9{difference_1721[9]}};
  logic [9:0] sum_1723;
  assign sum_1723 = {9'h0, difference_1721[9]} + {1'b0, xor_1722};
  logic [9:0] difference_1724;
  assign difference_1724 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1725;
  assign xor_1725 = difference_1724[8:0] ^ {9{difference_1724[9]}};
  logic [9:0] sum_1726;
  assign sum_1726 = {9'h0, difference_1724[9]} + {1'b0, xor_1725};
  logic [9:0] difference_1728;
  assign difference_1728 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1729;
  assign xor_1729 = difference_1728[8:0] ^ {9{difference_1728[9]}};
  logic [9:0] sum_1730;
  assign sum_1730 = {9'h0, difference_1728[9]} + {1'b0, xor_1729};
  logic [10:0] sum_1731;
  assign sum_1731 = ({1'b0, sum_1723} + {1'b0, sum_1726}) + {1'b0, sum_1730};
  logic [9:0] difference_1732;
  assign difference_1732 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1733;
  assign xor_1733 = difference_1732[8:0] ^ {9{difference_1732[9]}};
  logic [9:0] sum_1734;
  assign sum_1734 = {9'h0, difference_1732[9]} + {1'b0, xor_1733};
  logic [9:0] difference_1736;
  assign difference_1736 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1737;
  assign xor_1737 = difference_1736[8:0] ^ {9{difference_1736[9]}};
  logic [9:0] sum_1738;
  assign sum_1738 = {9'h0, difference_1736[9]} + {1'b0, xor_1737};
  // hls/stages/census.hpp:353
  logic [9:0] difference_1767;
  assign difference_1767 = {1'b0, select_374} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1767[9]} + (difference_1767[8:0] ^ {9{difference_1767[9]}});
  logic [9:0] difference_1779;
  assign difference_1779 = {1'b0, select_378} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1779[9]} + (difference_1779[8:0] ^ {9{difference_1779[9]}});
  // hls/stages/agreement.hpp:495
  logic and_1986;
  assign and_1986 = and_368_s3_q & (equal_429_s3_q & equal_1870_s3_q);
  // hls/stages/agreement.hpp:392
  logic and_1989;
  assign and_1989 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & inside_v_s3_q[1]));
  // hls/stages/agreement.hpp:988
  logic and_2010;
  assign and_2010 = seen_columns_rdata_q[15] & inside_v_s3_q[0];
  logic and_2011;
  assign and_2011 = seen_columns_rdata_q[11] & inside_v_s3_q[0];
  logic and_2012;
  assign and_2012 = seen_columns_rdata_q[7] & inside_v_s3_q[0];
  logic and_2013;
  assign and_2013 = seen_columns_rdata_q[2] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_2015;
  assign sum_2015 = {1'b0, and_2012} + ({1'b0, explained} + {1'b0, and_2013});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2010} + ({2'h0, and_2011} + {1'b0, sum_2015});
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2018;
  assign select_2018 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2019;
  assign difference_2019 = {1'b0, explained_2} - {1'b0, select_2018};
  logic [4:0] e;
  assign e = {difference_2019[3], difference_2019} + (equal_1537 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1056
  logic [5:0] sum_2022;
  assign sum_2022 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:392
  logic and_2050;
  assign and_2050 = ends_cell_s3_q & (inside_v_s3_q[0] & (inside_v_s3_q[2:1] == 2'h3));
  // hls/stages/registration.hpp:83
  logic equal_2094;
  assign equal_2094 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:213
  logic [16:0] select_2096;
  assign select_2096 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2096[16:7])) ? 8'h7f : select_2096[7:0];
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2094 ? registration_slope_here_q : change;
  // hls/stages/registration.hpp:208
  logic [7:0] select_2100;
  assign select_2100 = inside_v_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2101;
  assign select_2101 = inside_v_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2102;
  assign difference_2102 = {{2{select_2100[7]}}, select_2100[7:1]} - {select_2101[7], select_2101};
  // hls/stages/registration.hpp:206
  logic [6:0] select_2103;
  assign select_2103 = inside_v_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2104;
  assign select_2104 = inside_v_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2105;
  assign sum_2105 = {{2{select_2103[6]}}, select_2103} + {select_2104[7], select_2104};
  // hls/stages/registration.hpp:207
  logic [7:0] select_2106;
  assign select_2106 = inside_v_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2107;
  assign select_2107 = inside_v_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2108;
  assign sum_2108 = {{2{select_2106[7]}}, select_2106[7:1]} + {select_2107[7], select_2107};
  // hls/stages/registration.hpp:209
  logic [10:0] sum_2109;
  assign sum_2109 = {{3{sum_2105[8]}}, sum_2105[8:1]} + {sum_2108[8], sum_2108, select_2106[0]};
  logic [9:0] sum_2110;
  assign sum_2110 = {difference_2102, select_2100[0]} + {sum_2109[10], sum_2109[10:2]};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2111;
  assign sum_2111 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_2110[9]}}, sum_2110[9:2]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2114;
  assign select_2114 = ($signed(sum_2111[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2111[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] select_2116;
  assign select_2116 = equal_2094 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2111[12:7])) ? 8'h7f : select_2114);
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2118;
  assign select_2118 = equal_1337_s3_q ? registration_slope_here_q : (so_s3_q ? select_2116 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2119;
  assign equal_2119 = slot_s3_q == 3'h4;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2128;
  assign sum_2128 = inside_v_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2130;
  assign difference_2130 = {sum_2128, inside_v_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2131;
  assign select_2131 = less_2129_s3_q ? difference_2130 : {sum_2128, inside_v_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2132;
  assign select_2132 = ((inside_v_s3_q[13:11] == 3'h0) | (inside_v_s3_q[13:11] == 3'h4)) ? {sum_2128, inside_v_s3_q[11], 5'h0} : select_2131;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2132[7]}}, select_2132} - {sum_2110[9], sum_2110, sum_2109[1]};
  // hls/stages/registration.hpp:213
  logic [11:0] select_2135;
  assign select_2135 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2135[11:7])) ? 12'h7f : select_2135;
  // hls/stages/agreement.hpp:392
  logic select_2179;
  assign select_2179 = so_s3_q ? (equal_2119 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2182;
  assign select_2182 = so_s3_q ? (equal_2094 ? inside_v_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:264
  logic [3:0] select_2187;
  assign select_2187 = (sum_1388 == 2'h2) ? (registration_fresh_q & (~select_1432)) : registration_fresh_q;
  // hls/stages/agreement.hpp:392
  logic [3:0] select_2189;
  assign select_2189 = so_s3_q ? (and_1427 ? select_2187 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:237
  logic [3:0] select_2191;
  assign select_2191 = and_1986 ? 4'hf : (equal_1337_s3_q ? registration_fresh_q : select_2189);
  // hls/stages/registration.hpp:128
  logic [15:0] select_2198;
  assign select_2198 = and_2197_s3_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2200;
  assign select_2200 = and_2195_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2198[15]}}, select_2198});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2201;
  assign select_2201 = and_2197_s3_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2201[15]}}, select_2201};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2203;
  assign select_2203 = and_2195_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:137
  logic and_2204;
  assign and_2204 = ends_cell_s3_q & so_s3_q;
  // hls/stages/registration.hpp:124
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2204 ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:1083
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1385;
  // hls/stages/registration.hpp:253
  logic not_2212;
  assign not_2212 = ~quarter_2[1];
  logic [3:0] select_2213;
  assign select_2213 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2212, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2212};
  // hls/stages/agreement.hpp:392
  logic select_2301;
  assign select_2301 = equal_1337_s3_q ? shown_shown_q : (so_s3_q ? select_1486 : shown_shown_q);
  logic select_2303;
  assign select_2303 = equal_1337_s3_q ? shown_nearer_q : (so_s3_q ? select_1489 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2305;
  assign sum_2305 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:436
  logic [2:0] select_2307;
  assign select_2307 = less_2304_s3_q ? (sum_2305[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2309;
  assign select_2309 = equal_1870_s3_q ? (equal_429_s3_q ? 3'h0 : select_2307) : region_row_q;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2314;
  assign select_2314 = equal_1337_s3_q ? select_1445 : (so_s3_q ? (ends_cell_s3_q ? select_1542 : select_1445) : 8'h1);
  // hls/stages/agreement.hpp:190
  logic [8:0] select_2316;
  assign select_2316 = so_s3_q ? (and_2204 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_2318;
  assign sum_2318 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2319;
  assign select_2319 = sum_1458[5] ? {1'b1, sum_1458[4:0], region_across_rest_q[2:0]} : sum_2318;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_2321;
  assign select_2321 = equal_1870_s3_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_2324;
  assign select_2324 = equal_1870_s3_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  logic [8:0] select_2328;
  assign select_2328 = equal_429_s3_q ? {{2{difference_2326[6]}}, difference_2326} : (less_2304_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:495
  logic [8:0] select_2330;
  assign select_2330 = and_368_s3_q ? (equal_1870_s3_q ? select_2328 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:436
  logic [6:0] select_2332;
  assign select_2332 = equal_429_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:495
  logic [6:0] select_2334;
  assign select_2334 = and_368_s3_q ? (equal_1870_s3_q ? select_2332 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2335;
  assign sum_2335 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2336;
  assign select_2336 = sum_2305[7] ? {1'b1, sum_2305[6:0], region_down_rest_q[0]} : sum_2335;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2305[7];
  // hls/stages/agreement.hpp:436
  logic select_2340;
  assign select_2340 = equal_1870_s3_q ? (equal_429_s3_q | (less_2304_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:190
  logic or_2345;
  assign or_2345 = segment_starts_q | not_1377;
  // hls/stages/agreement.hpp:988
  logic select_2348;
  assign select_2348 = inside_v_s3_q[0] ? (sum_1458[5] ? (equal_1460_s3_q & or_1461) : or_1461) : or_2345;
  // hls/stages/agreement.hpp:392
  logic select_2351;
  assign select_2351 = equal_1337_s3_q ? or_2345 : (so_s3_q ? (ends_cell_s3_q ? select_2348 : or_2345) : or_2345);
  // hls/stages/agreement.hpp:1095
  logic equal_2376;
  assign equal_2376 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:392
  logic [2:0] select_2427;
  assign select_2427 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_2429;
  assign select_2429 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2431;
  assign select_2431 = equal_1337_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_2429 : box_textured_columns_values_1_q);
  logic [2:0] select_2432;
  assign select_2432 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2434;
  assign select_2434 = equal_1337_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_2432 : box_textured_columns_values_2_q);
  logic [2:0] select_2435;
  assign select_2435 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2437;
  assign select_2437 = equal_1337_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_2435 : box_textured_columns_values_3_q);
  logic [2:0] select_2438;
  assign select_2438 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2440;
  assign select_2440 = equal_1337_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_2438 : box_textured_columns_values_4_q);
  logic [4:0] select_2442;
  assign select_2442 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_2445;
  assign select_2445 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_2447;
  assign select_2447 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2449;
  assign select_2449 = equal_1337_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_2447 : box_explained_columns_values_1_q);
  logic [2:0] select_2450;
  assign select_2450 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2452;
  assign select_2452 = equal_1337_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_2450 : box_explained_columns_values_2_q);
  logic [2:0] select_2453;
  assign select_2453 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2455;
  assign select_2455 = equal_1337_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_2453 : box_explained_columns_values_3_q);
  logic [2:0] select_2456;
  assign select_2456 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2458;
  assign select_2458 = equal_1337_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_2456 : box_explained_columns_values_4_q);
  logic [4:0] select_2460;
  assign select_2460 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2461;
  assign select_2461 = equal_1337_s3_q ? box_explained_sum_sums_values_0_q : select_2460;
  logic [2:0] select_2463;
  assign select_2463 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2465;
  assign select_2465 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2467;
  assign select_2467 = equal_1337_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_2465 : box_shown_columns_values_1_q);
  logic [2:0] select_2468;
  assign select_2468 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2470;
  assign select_2470 = equal_1337_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_2468 : box_shown_columns_values_2_q);
  logic [2:0] select_2471;
  assign select_2471 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2473;
  assign select_2473 = equal_1337_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_2471 : box_shown_columns_values_3_q);
  logic [2:0] select_2474;
  assign select_2474 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2476;
  assign select_2476 = equal_1337_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_2474 : box_shown_columns_values_4_q);
  logic [4:0] select_2478;
  assign select_2478 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_2481;
  assign select_2481 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2483;
  assign select_2483 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2485;
  assign select_2485 = equal_1337_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_2483 : box_nearer_columns_values_1_q);
  logic [2:0] select_2486;
  assign select_2486 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2488;
  assign select_2488 = equal_1337_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_2486 : box_nearer_columns_values_2_q);
  logic [2:0] select_2489;
  assign select_2489 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2491;
  assign select_2491 = equal_1337_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_2489 : box_nearer_columns_values_3_q);
  logic [2:0] select_2492;
  assign select_2492 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2494;
  assign select_2494 = equal_1337_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_2492 : box_nearer_columns_values_4_q);
  logic [4:0] select_2496;
  assign select_2496 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_2499;
  assign select_2499 = so_s3_q ? (ends_cell_s3_q ? and_1529 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2502;
  assign select_2502 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & inside_v_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_2504;
  assign select_2504 = equal_1337_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_2502 : centres_values_0_of_skin_q);
  logic select_2505;
  assign select_2505 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2507;
  assign select_2507 = equal_1337_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_2505 : centres_values_1_textured_q);
  logic select_2508;
  assign select_2508 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2510;
  assign select_2510 = equal_1337_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_2508 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:436
  logic [10:0] select_2514;
  assign select_2514 = equal_1870_s3_q ? (equal_2511_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:495
  logic [5:0] select_2517;
  assign select_2517 = and_368_s3_q ? (equal_1870_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1203
  logic xor_2518;
  assign xor_2518 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:413
  logic select_2520;
  assign select_2520 = and_1510_s3_q ? (left_first_s3_q ? xor_2518 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:257
  logic select_2522;
  assign select_2522 = and_1510_s3_q ? (left_first_s3_q ? xor_2518 : select_2520) : write_half_q;
  logic select_2524;
  assign select_2524 = left_first_s3_q ? select_1492 : (and_1510_s3_q ? select_1493 : read_half_q);
  logic and_2528;
  assign and_2528 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_2537;
  assign select_2537 = left_first_s3_q ? 10'h1 : (and_1510_s3_q ? select_1497 : rows_passed_q);
  logic [8:0] select_2540;
  assign select_2540 = left_first_s3_q ? {select_1495[7:0], or_1494} : (and_1510_s3_q ? {select_1495[7:0], or_1494} : columns_passed_q);
  logic select_2543;
  assign select_2543 = left_first_s3_q ? marks_last_s3_q : (and_1510_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_2546;
  assign select_2546 = left_first_s3_q ? and_1513 : (and_1510_s3_q ? and_1513 : began_q);
  logic [2:0] select_2549;
  assign select_2549 = left_first_s3_q ? select_1515 : (and_1510_s3_q ? select_1515 : seen_x_q);
  // hls/stages/agreement.hpp:1232
  logic [2:0] select_2554;
  assign select_2554 = left_first_s3_q ? 3'h0 : (and_1498 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:257
  logic [2:0] select_2556;
  assign select_2556 = left_first_s3_q ? 3'h0 : (and_1510_s3_q ? select_2554 : seen_y_q);
  logic [7:0] select_2559;
  assign select_2559 = left_first_s3_q ? select_1506 : (and_1510_s3_q ? select_1506 : seen_column_q);
  // hls/stages/agreement.hpp:411
  logic [7:0] select_2565;
  assign select_2565 = left_first_s3_q ? select_2563 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:257
  logic [7:0] select_2567;
  assign select_2567 = left_first_s3_q ? select_2563 : (and_1510_s3_q ? select_2565 : seen_rows_left_q);
  // hls/stages/agreement.hpp:411
  logic and_2572;
  assign and_2572 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:257
  logic select_2574;
  assign select_2574 = left_first_s3_q ? and_2572 : (and_1510_s3_q ? and_2572 : at_cell_end_q);
  logic select_2577;
  assign select_2577 = left_first_s3_q ? next_row : (and_1510_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_2580;
  assign select_2580 = left_first_s3_q ? 11'h0 : (and_1510_s3_q ? select_1503 : seen_base_q);
  // hls/stages/registration.hpp:253
  logic not_2641;
  assign not_2641 = ~quarter[1];
  logic [3:0] select_2642;
  assign select_2642 = quarter[0] ? {quarter[1], 1'b0, not_2641, 1'b0} : {1'b0, quarter[1], 1'b0, not_2641};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:271; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1389;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & (equal_1337_s3_q ? (x_s3_q[6] & select_1417) : and_1428);
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
  assign regions_raddr = select_1455;
  logic regions_re;
  assign regions_re = s3_en & (equal_1337_s3_q ? (x_s3_q[6] & not_1456) : and_1464);
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
  assign map_raddr = sum_1508;
  logic map_re;
  assign map_re = s3_en & select_1522;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory census_memory, write
  logic [5:0] census_memory_waddr;
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_368_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_386_s3_q, whole_2_s3_q, select_378, select_374};
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
  assign shown_right_waddr = select_1376_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1381_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1378, not_1377};
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
  assign seen_columns_we = s3_en & and_1372_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1485, textured_s3_q};
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
      census_filled_q <= and_368_s3_q ? {select_432[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_368_s3_q ? select_431 : rows_passed_above_q;
      registration_slope_here_q <= select_2118;
      registration_of_right_q <= equal_1337_s3_q ? registration_of_right_q : select_2179;
      registration_was_inside_q <= equal_1337_s3_q ? registration_was_inside_q : select_2182;
      registration_fresh_q <= select_2191;
      registration_slope_row_q <= select_2200;
      registration_slope_change_q <= select_2203;
      registration_slope_q <= so_s3_q ? column_5 : {registration_slope_row_q, 4'h0};
      shown_shown_q <= select_2301;
      shown_nearer_q <= select_2303;
      region_row_q <= and_368_s3_q ? select_2309 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_2314;
      region_across_rest_q <= select_2316;
      region_across_back_q <= so_s3_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2319;
      columns_begin_rest_q <= and_368_s3_q ? select_2321 : columns_begin_rest_q;
      columns_begin_back_q <= and_368_s3_q ? select_2324 : columns_begin_back_q;
      region_down_rest_q <= select_2330;
      region_down_back_q <= select_2334;
      region_down_next_q <= select_2336;
      region_fresh_q <= and_368_s3_q ? select_2340 : region_fresh_q;
      segment_starts_q <= select_2351;
      centres_values_0_textured_q <= equal_1337_s3_q ? centres_values_0_textured_q : select_2499;
      centres_values_0_of_skin_q <= select_2504;
      centres_values_1_textured_q <= select_2507;
      centres_values_1_of_skin_q <= select_2510;
      map_row_q <= and_368_s3_q ? select_2514 : map_row_q;
      map_width_q <= select_2517;
      write_half_q <= select_2522;
      read_half_q <= and_1510_s3_q ? select_2524 : read_half_q;
      done_q <= and_1510_s3_q ? (not_1511 & and_2528) : and_2528;
      drew_q <= so_s3_q;
      said_q <= equal_1337_s3_q & equal_2376;
      rows_passed_q <= and_1510_s3_q ? select_2537 : rows_passed_q;
      columns_passed_q <= and_1510_s3_q ? select_2540 : columns_passed_q;
      line_ended_q <= and_1510_s3_q ? select_2543 : line_ended_q;
      began_q <= and_1510_s3_q ? select_2546 : began_q;
      seen_x_q <= and_1510_s3_q ? select_2549 : seen_x_q;
      seen_y_q <= and_1510_s3_q ? select_2556 : seen_y_q;
      seen_column_q <= and_1510_s3_q ? select_2559 : seen_column_q;
      seen_rows_left_q <= and_1510_s3_q ? select_2567 : seen_rows_left_q;
      at_cell_end_q <= and_1510_s3_q ? select_2574 : at_cell_end_q;
      was_next_row_q <= and_1510_s3_q ? select_2577 : was_next_row_q;
      seen_base_q <= and_1510_s3_q ? select_2580 : seen_base_q;
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
      averager_total_0_q <= select_1638;
      averager_total_1_q <= select_1640;
      census_columns_values_0_cell_0_left_q <= select_1664;
      census_columns_values_0_cell_0_right_q <= select_1665;
      census_columns_values_0_cell_0_mask_q <= select_1666;
      census_columns_values_0_cell_1_left_q <= select_1667;
      census_columns_values_0_cell_1_right_q <= select_1668;
      census_columns_values_0_cell_1_mask_q <= select_1669;
      census_columns_values_0_cell_2_left_q <= select_1670;
      census_columns_values_0_cell_2_right_q <= select_1671;
      census_columns_values_0_cell_2_mask_q <= select_1672;
      census_columns_values_0_cell_2_of_skin_q <= select_1673;
      census_columns_values_0_cell_3_left_q <= select_1674;
      census_columns_values_0_cell_3_right_q <= select_1675;
      census_columns_values_0_cell_3_mask_q <= select_1676;
      census_columns_values_0_cell_4_left_q <= select_1677;
      census_columns_values_0_cell_4_right_q <= select_1678;
      census_columns_values_0_cell_4_mask_q <= select_1679;
      census_columns_values_1_cell_0_left_q <= select_1680;
      census_columns_values_1_cell_0_right_q <= select_1681;
      census_columns_values_1_cell_0_mask_q <= select_1682;
      census_columns_values_1_cell_1_left_q <= select_1683;
      census_columns_values_1_cell_1_right_q <= select_1684;
      census_columns_values_1_cell_1_mask_q <= select_1685;
      census_columns_values_1_cell_2_left_q <= select_1686;
      census_columns_values_1_cell_2_right_q <= select_1687;
      census_columns_values_1_cell_2_mask_q <= select_1688;
      census_columns_values_1_cell_2_of_skin_q <= select_1689;
      census_columns_values_1_cell_3_left_q <= select_1690;
      census_columns_values_1_cell_3_right_q <= select_1691;
      census_columns_values_1_cell_3_mask_q <= select_1692;
      census_columns_values_1_cell_4_left_q <= select_1693;
      census_columns_values_1_cell_4_right_q <= select_1694;
      census_columns_values_1_cell_4_mask_q <= select_1695;
      census_columns_values_2_cell_0_left_q <= select_1696;
      census_columns_values_2_cell_0_right_q <= select_1697;
      census_columns_values_2_cell_0_mask_q <= select_1698;
      census_columns_values_2_cell_1_left_q <= select_1699;
      census_columns_values_2_cell_1_right_q <= select_1700;
      census_columns_values_2_cell_1_mask_q <= select_1701;
      census_columns_values_2_cell_2_left_q <= select_1702;
      census_columns_values_2_cell_2_right_q <= select_1703;
      census_columns_values_2_cell_2_mask_q <= select_1704;
      census_columns_values_2_cell_3_left_q <= select_1705;
      census_columns_values_2_cell_3_right_q <= select_1706;
      census_columns_values_2_cell_3_mask_q <= select_1707;
      census_columns_values_2_cell_4_left_q <= select_1708;
      census_columns_values_2_cell_4_right_q <= select_1709;
      census_columns_values_2_cell_4_mask_q <= select_1710;
      census_columns_values_3_cell_0_mask_q <= select_1711;
      census_columns_values_3_cell_1_left_q <= select_1712;
      census_columns_values_3_cell_1_right_q <= select_1713;
      census_columns_values_3_cell_1_mask_q <= select_1714;
      census_columns_values_3_cell_2_mask_q <= select_1715;
      census_columns_values_3_cell_3_left_q <= select_1716;
      census_columns_values_3_cell_3_right_q <= select_1717;
      census_columns_values_3_cell_3_mask_q <= select_1718;
      census_columns_values_3_cell_4_mask_q <= select_1719;
      sharpness_last_mean_0_q <= and_368_s3_q ? select_374 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_368_s3_q ? select_378 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1337_s3_q ? box_textured_columns_values_0_q : select_2427;
      box_textured_columns_values_1_q <= select_2431;
      box_textured_columns_values_2_q <= select_2434;
      box_textured_columns_values_3_q <= select_2437;
      box_textured_columns_values_4_q <= select_2440;
      box_textured_sum_sums_values_0_q <= equal_1337_s3_q ? box_textured_sum_sums_values_0_q : select_2442;
      box_explained_columns_values_0_q <= equal_1337_s3_q ? box_explained_columns_values_0_q : select_2445;
      box_explained_columns_values_1_q <= select_2449;
      box_explained_columns_values_2_q <= select_2452;
      box_explained_columns_values_3_q <= select_2455;
      box_explained_columns_values_4_q <= select_2458;
      box_explained_sum_sums_values_0_q <= select_2461;
      box_shown_columns_values_0_q <= equal_1337_s3_q ? box_shown_columns_values_0_q : select_2463;
      box_shown_columns_values_1_q <= select_2467;
      box_shown_columns_values_2_q <= select_2470;
      box_shown_columns_values_3_q <= select_2473;
      box_shown_columns_values_4_q <= select_2476;
      box_shown_sum_sums_values_0_q <= equal_1337_s3_q ? box_shown_sum_sums_values_0_q : select_2478;
      box_nearer_columns_values_0_q <= equal_1337_s3_q ? box_nearer_columns_values_0_q : select_2481;
      box_nearer_columns_values_1_q <= select_2485;
      box_nearer_columns_values_2_q <= select_2488;
      box_nearer_columns_values_3_q <= select_2491;
      box_nearer_columns_values_4_q <= select_2494;
      box_nearer_sum_sums_values_0_q <= equal_1337_s3_q ? box_nearer_sum_sums_values_0_q : select_2496;
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
  logic and_366_s4_q;
  logic and_368_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_371_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_425_s4_q;
  logic and_433_s4_q;
  logic and_458_s4_q;
  logic and_459_s4_q;
  logic [11:0] texture_s4_q;
  logic equal_1337_s4_q;
  logic not_1338_s4_q;
  logic equal_1382_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1388_s4_q;
  logic equal_1390_s4_q;
  logic equal_1392_s4_q;
  logic equal_1394_s4_q;
  logic equal_1396_s4_q;
  logic equal_1398_s4_q;
  logic equal_1400_s4_q;
  logic equal_1402_s4_q;
  logic less_1410_s4_q;
  logic or_1414_s4_q;
  logic equal_1434_s4_q;
  logic and_1444_s4_q;
  logic or_1448_s4_q;
  logic or_1451_s4_q;
  logic or_1454_s4_q;
  logic not_1456_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1478_s4_q;
  logic and_1483_s4_q;
  logic and_1510_s4_q;
  logic and_1517_s4_q;
  logic less_1518_s4_q;
  logic [11:0] sum_1526_s4_q;
  logic equal_1540_s4_q;
  logic or_1545_s4_q;
  logic or_1548_s4_q;
  logic or_1551_s4_q;
  logic not_1576_s4_q;
  logic less_1590_s4_q;
  logic and_1601_s4_q;
  logic [11:0] sum_1739_s4_q;
  logic equal_1746_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_1986_s4_q;
  logic and_1990_s4_q;
  logic not_2024_s4_q;
  logic and_2052_s4_q;
  logic equal_2094_s4_q;
  logic and_2122_s4_q;
  logic and_2124_s4_q;
  logic [11:0] residual_s4_q;
  logic equal_2215_s4_q;
  logic equal_2376_s4_q;
  logic and_2583_s4_q;
  logic equal_2644_s4_q;
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
      and_366_s4_q <= and_366_s3_q;
      and_368_s4_q <= and_368_s3_q;
      grey_s4_q <= grey_s3_q;
      equal_371_s4_q <= equal_371_s3_q;
      grey_2_s4_q <= grey_2_s3_q;
      whole_2_s4_q <= whole_2_s3_q;
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
      less_425_s4_q <= less_425;
      and_433_s4_q <= and_433;
      and_458_s4_q <= whole_22 & and_433;
      and_459_s4_q <= census_columns_values_1_cell_2_mask_q & and_433;
      texture_s4_q <= texture;
      equal_1337_s4_q <= equal_1337_s3_q;
      not_1338_s4_q <= not_1338_s3_q;
      equal_1382_s4_q <= equal_1382;
      all_s4_q <= all;
      sum_1388_s4_q <= sum_1388;
      equal_1390_s4_q <= equal_1390;
      equal_1392_s4_q <= equal_1392;
      equal_1394_s4_q <= equal_1394;
      equal_1396_s4_q <= equal_1396;
      equal_1398_s4_q <= equal_1398;
      equal_1400_s4_q <= equal_1400;
      equal_1402_s4_q <= equal_1402;
      less_1410_s4_q <= less_1410;
      or_1414_s4_q <= or_1414;
      equal_1434_s4_q <= (registration_fresh_q & select_1432) == 4'h0;
      and_1444_s4_q <= not_1338_s3_q & and_1428;
      or_1448_s4_q <= or_1448;
      or_1451_s4_q <= or_1451;
      or_1454_s4_q <= or_1454;
      not_1456_s4_q <= not_1456;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1478_s4_q <= and_1478;
      and_1483_s4_q <= not_1338_s3_q & and_1464;
      and_1510_s4_q <= and_1510_s3_q;
      and_1517_s4_q <= and_1517;
      less_1518_s4_q <= less_1518;
      sum_1526_s4_q <= sum_1526;
      equal_1540_s4_q <= t[4:1] == 4'h0;
      or_1545_s4_q <= or_1545;
      or_1548_s4_q <= select_1542[7] | (~({select_1542[6], select_1542[3:2]} == 3'h0));
      or_1551_s4_q <= select_1542[7] | (~(select_1542[6:4] == 3'h0));
      not_1576_s4_q <= ~({sum_1574, around[0]} < {2'h0, t});
      less_1590_s4_q <= {1'b0, around[4:1]} < n;
      and_1601_s4_q <= and_1601_s3_q;
      sum_1739_s4_q <= ({1'b0, sum_1731} + {2'h0, sum_1734}) + {2'h0, sum_1738};
      equal_1746_s4_q <= equal_1746_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_1986_s4_q <= and_1986;
      and_1990_s4_q <= not_1338_s3_q & and_1989;
      not_2024_s4_q <= ~({sum_2022, e[0]} < {2'h0, t});
      and_2052_s4_q <= not_1338_s3_q & (so_s3_q & and_2050);
      equal_2094_s4_q <= equal_2094;
      and_2122_s4_q <= not_1338_s3_q & (so_s3_q & (half_ends & equal_2119));
      and_2124_s4_q <= and_2124_s3_q;
      residual_s4_q <= residual;
      equal_2215_s4_q <= (registration_fresh_q & select_2213) == 4'h0;
      equal_2376_s4_q <= equal_2376;
      and_2583_s4_q <= and_1601_s3_q & (sum_1526 == sum_1508);
      equal_2644_s4_q <= (registration_fresh_q & select_2642) == 4'h0;
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
  logic sharpness_before_last_mask_q;
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
  logic [12:0] sum_479;
  assign sum_479 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_481;
  assign sum_481 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_479});
  // hls/stages/census.hpp:303
  logic less_482;
  assign less_482 = 9'h4 < sum_481[13:5];
  logic and_483;
  assign and_483 = and_433_s4_q & less_482;
  // hls/stages/registration.hpp:260
  logic equal_1436;
  assign equal_1436 = sum_1388_s4_q == 2'h0;
  // hls/stages/registration.hpp:258
  logic [6:0] down;
  assign down = sum_1388_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:260
  logic [13:0] select_1438;
  assign select_1438 = equal_1436 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1439;
  assign sum_1439 = (equal_1434_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1438[13]}}, select_1438};
  // hls/stages/registration.hpp:259
  logic [6:0] up;
  assign up = sum_1388_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:261
  logic [6:0] select_1442;
  assign select_1442 = equal_1436 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1443;
  assign sum_1443 = (equal_1434_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1442[6]}}, select_1442};
  // hls/stages/agreement.hpp:881
  logic [5:0] select_1468;
  assign select_1468 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:882
  logic [5:0] sum_1469;
  assign sum_1469 = {5'h0, textured_s4_q} + select_1468;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_1471;
  assign sum_1471 = {4'h0, sum_1469} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:881
  logic [5:0] select_1473;
  assign select_1473 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:882
  logic [5:0] sum_1474;
  assign sum_1474 = {5'h0, explained_s4_q} + select_1473;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_1476;
  assign sum_1476 = {4'h0, sum_1474} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:881
  logic [5:0] select_1479;
  assign select_1479 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:883
  logic [5:0] sum_1480;
  assign sum_1480 = {5'h0, and_1478_s4_q} + select_1479;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_1482;
  assign sum_1482 = {4'h0, sum_1480} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1055
  logic not_1552;
  assign not_1552 = ~region_row_s4_q[2];
  logic [2:0] select_1553;
  assign select_1553 = region_row_s4_q[1] ? {1'b0, not_1552, 1'b0} : {region_row_s4_q[2], 1'b0, not_1552};
  logic [5:0] select_1554;
  assign select_1554 = region_row_s4_q[0] ? {select_1553[2], 1'b0, select_1553[1], 1'b0, select_1553[0], 1'b0} : {1'b0, select_1553[2], 1'b0, select_1553[1], 1'b0, select_1553[0]};
  logic [11:0] select_1555;
  assign select_1555 = or_1551_s4_q ? {select_1554[5], 1'b0, select_1554[4], 1'b0, select_1554[3], 1'b0, select_1554[2], 1'b0, select_1554[1], 1'b0, select_1554[0], 1'b0} : {1'b0, select_1554[5], 1'b0, select_1554[4], 1'b0, select_1554[3], 1'b0, select_1554[2], 1'b0, select_1554[1], 1'b0, select_1554[0]};
  logic [23:0] select_1556;
  assign select_1556 = or_1548_s4_q ? {select_1555[11], 1'b0, select_1555[10], 1'b0, select_1555[9], 1'b0, select_1555[8], 1'b0, select_1555[7], 1'b0, select_1555[6], 1'b0, select_1555[5], 1'b0, select_1555[4], 1'b0, select_1555[3], 1'b0, select_1555[2], 1'b0, select_1555[1], 1'b0, select_1555[0], 1'b0} : {1'b0, select_1555[11], 1'b0, select_1555[10], 1'b0, select_1555[9], 1'b0, select_1555[8], 1'b0, select_1555[7], 1'b0, select_1555[6], 1'b0, select_1555[5], 1'b0, select_1555[4], 1'b0, select_1555[3], 1'b0, select_1555[2], 1'b0, select_1555[1], 1'b0, select_1555[0]};
  logic [47:0] select_1557;
  assign select_1557 = or_1545_s4_q ? {select_1556[23], 1'b0, select_1556[22], 1'b0, select_1556[21], 1'b0, select_1556[20], 1'b0, select_1556[19], 1'b0, select_1556[18], 1'b0, select_1556[17], 1'b0, select_1556[16], 1'b0, select_1556[15], 1'b0, select_1556[14], 1'b0, select_1556[13], 1'b0, select_1556[12], 1'b0, select_1556[11], 1'b0, select_1556[10], 1'b0, select_1556[9], 1'b0, select_1556[8], 1'b0, select_1556[7], 1'b0, select_1556[6], 1'b0, select_1556[5], 1'b0, select_1556[4], 1'b0, select_1556[3], 1'b0, select_1556[2], 1'b0, select_1556[1], 1'b0, select_1556[0], 1'b0} : {1'b0, select_1556[23], 1'b0, select_1556[22], 1'b0, select_1556[21], 1'b0, select_1556[20], 1'b0, select_1556[19], 1'b0, select_1556[18], 1'b0, select_1556[17], 1'b0, select_1556[16], 1'b0, select_1556[15], 1'b0, select_1556[14], 1'b0, select_1556[13], 1'b0, select_1556[12], 1'b0, select_1556[11], 1'b0, select_1556[10], 1'b0, select_1556[9], 1'b0, select_1556[8], 1'b0, select_1556[7], 1'b0, select_1556[6], 1'b0, select_1556[5], 1'b0, select_1556[4], 1'b0, select_1556[3], 1'b0, select_1556[2], 1'b0, select_1556[1], 1'b0, select_1556[0]};
  // hls/stages/agreement.hpp:988
  logic and_1561;
  assign and_1561 = good_known_q & (~((good_q & select_1557) == 48'h0));
  // hls/stages/agreement.hpp:1057
  logic is_seen;
  assign is_seen = equal_1540_s4_q ? and_1561 : not_1576_s4_q;
  // hls/stages/agreement.hpp:1066
  logic and_1591;
  assign and_1591 = is_seen & less_1590_s4_q;
  // hls/stages/agreement.hpp:255
  logic [8:0] select_1630;
  assign select_1630 = sample_pair_whole_s4_q ? (and_366_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1632;
  assign select_1632 = sample_pair_whole_s4_q ? (and_366_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1634;
  assign select_1634 = sample_pair_whole_s4_q ? (and_366_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1636;
  assign select_1636 = sample_pair_whole_s4_q ? (and_366_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_1641;
  assign sum_1641 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1642;
  assign difference_1642 = {1'b0, sum_1641[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_1643;
  assign xor_1643 = {difference_1642[8:0], sum_1641[0]} ^ {10{difference_1642[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_1642[9]} + {1'b0, xor_1643};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_371_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_1648;
  assign select_1648 = sample_pair_whole_s4_q ? (and_366_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_1649;
  assign sum_1649 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1650;
  assign difference_1650 = {1'b0, sum_1649[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_1651;
  assign xor_1651 = {difference_1650[8:0], sum_1649[0]} ^ {10{difference_1650[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1650[9]} + {1'b0, xor_1651};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_371_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:255
  logic [13:0] select_1656;
  assign select_1656 = sample_pair_whole_s4_q ? (and_366_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:495
  logic [11:0] select_1741;
  assign select_1741 = and_368_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1742;
  assign select_1742 = and_368_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1743;
  assign select_1743 = and_368_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1744;
  assign select_1744 = and_368_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_1747;
  assign sum_1747 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1739_s4_q};
  logic [13:0] sum_1749;
  assign sum_1749 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1747});
  // hls/stages/census.hpp:305
  logic and_1751;
  assign and_1751 = and_458_s4_q & (9'h4 < sum_1749[13:5]);
  // hls/stages/census.hpp:306
  logic and_1752;
  assign and_1752 = and_458_s4_q & less_482;
  // hls/stages/census.hpp:307
  logic [19:0] sum_1753;
  assign sum_1753 = census_left_misses_q + {{17{and_1752}}, and_1751, 1'b0, and_1751};
  // hls/stages/agreement.hpp:495
  logic [19:0] select_1755;
  assign select_1755 = and_368_s4_q ? (equal_1746_s4_q ? 20'h0 : sum_1753) : census_left_misses_q;
  // hls/stages/agreement.hpp:255
  logic [27:0] select_1760;
  assign select_1760 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:495
  logic select_1763;
  assign select_1763 = and_368_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_1766;
  assign and_1766 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:433
  logic and_1772;
  assign and_1772 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_1773;
  assign and_1773 = and_1766 & and_1772;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1760[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_1775;
  assign select_1775 = and_1773 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_1777;
  assign select_1777 = equal_1746_s4_q ? {11'h0, select_1775} : (sharpness_sums_detail_0_q + {11'h0, select_1775});
  // hls/stages/agreement.hpp:433
  logic and_1784;
  assign and_1784 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_1785;
  assign and_1785 = and_1766 & and_1784;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1760[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_1787;
  assign select_1787 = and_1785 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_1789;
  assign select_1789 = equal_1746_s4_q ? {11'h0, select_1787} : (sharpness_sums_detail_1_q + {11'h0, select_1787});
  logic [8:0] select_1792;
  assign select_1792 = and_1773 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1793;
  assign sum_1793 = (equal_1746_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1792};
  logic [8:0] select_1796;
  assign select_1796 = and_1785 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1797;
  assign sum_1797 = (equal_1746_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1796};
  // hls/stages/agreement.hpp:196
  logic equal_1799;
  assign equal_1799 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_1800;
  assign less_1800 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_1801;
  assign less_1801 = x_s4_q[4:0] < 5'h3;
  logic not_1802;
  assign not_1802 = ~x_s4_q[1];
  logic [2:0] select_1803;
  assign select_1803 = x_s4_q[0] ? {1'b0, not_1802, 1'b0} : {x_s4_q[1], 1'b0, not_1802};
  logic [5:0] select_1804;
  assign select_1804 = slot_s4_q[2] ? {select_1803[2], 1'b0, select_1803[1], 1'b0, select_1803[0], 1'b0} : {1'b0, select_1803[2], 1'b0, select_1803[1], 1'b0, select_1803[0]};
  logic [11:0] select_1805;
  assign select_1805 = slot_s4_q[1] ? {select_1804[5], 1'b0, select_1804[4], 1'b0, select_1804[3], 1'b0, select_1804[2], 1'b0, select_1804[1], 1'b0, select_1804[0], 1'b0} : {1'b0, select_1804[5], 1'b0, select_1804[4], 1'b0, select_1804[3], 1'b0, select_1804[2], 1'b0, select_1804[1], 1'b0, select_1804[0]};
  logic [23:0] select_1806;
  assign select_1806 = slot_s4_q[0] ? {select_1805[11], 1'b0, select_1805[10], 1'b0, select_1805[9], 1'b0, select_1805[8], 1'b0, select_1805[7], 1'b0, select_1805[6], 1'b0, select_1805[5], 1'b0, select_1805[4], 1'b0, select_1805[3], 1'b0, select_1805[2], 1'b0, select_1805[1], 1'b0, select_1805[0], 1'b0} : {1'b0, select_1805[11], 1'b0, select_1805[10], 1'b0, select_1805[9], 1'b0, select_1805[8], 1'b0, select_1805[7], 1'b0, select_1805[6], 1'b0, select_1805[5], 1'b0, select_1805[4], 1'b0, select_1805[3], 1'b0, select_1805[2], 1'b0, select_1805[1], 1'b0, select_1805[0]};
  // hls/stages/census.hpp:372
  logic and_1810;
  assign and_1810 = less_1801 & (~((sharpness_sums_contrast_1_q & select_1806) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_1812;
  assign select_1812 = (less_1800 & and_1810) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1812};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_1815;
  assign select_1815 = equal_1799 ? (less_1800 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_1820;
  assign and_1820 = less_1801 & (~((sharpness_sums_contrast_0_q & select_1806) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_1822;
  assign select_1822 = (less_1800 & and_1820) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1822};
  // hls/stages/agreement.hpp:200
  logic [17:0] select_1825;
  assign select_1825 = equal_1799 ? (less_1800 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_1827;
  assign select_1827 = equal_1799 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_1829;
  assign select_1829 = equal_1799 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_1831;
  assign select_1831 = equal_1799 ? {sharpness_comparing_contrast_0_q[0], and_1820} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_1833;
  assign select_1833 = equal_1799 ? {sharpness_comparing_contrast_1_q[0], and_1810} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:200
  logic select_1838;
  assign select_1838 = drew_q ? (equal_1799 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:200
  logic select_1842;
  assign select_1842 = drew_q ? (equal_1799 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_1843;
  assign equal_1843 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_1844;
  assign xor_1844 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_1847;
  assign select_1847 = (equal_1843 | xor_1844) ? (five_times[0] & xor_1844) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:200
  logic select_1849;
  assign select_1849 = drew_q ? (equal_1799 ? select_1847 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_1850;
  assign xor_1850 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_1853;
  assign select_1853 = (equal_1843 | xor_1850) ? (five_times_2[0] & xor_1850) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:200
  logic select_1855;
  assign select_1855 = drew_q ? (equal_1799 ? select_1853 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_1856;
  assign xor_1856 = sharpness_comparing_contrast_0_q[1] ^ and_1810;
  logic select_1859;
  assign select_1859 = (equal_1843 | xor_1856) ? (and_1810 & xor_1856) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:200
  logic select_1861;
  assign select_1861 = drew_q ? (equal_1799 ? select_1859 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_1862;
  assign xor_1862 = sharpness_comparing_contrast_1_q[1] ^ and_1820;
  logic select_1865;
  assign select_1865 = (equal_1843 | xor_1862) ? (and_1820 & xor_1862) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:200
  logic select_1867;
  assign select_1867 = drew_q ? (equal_1799 ? select_1865 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_1992;
  assign select_1992 = and_1986_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1990_s4_q});
  // hls/stages/agreement.hpp:392
  logic and_1995;
  assign and_1995 = not_1338_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2000;
  assign and_2000 = not_1338_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2005;
  assign and_2005 = not_1338_s4_q & (drew_q & (ends_cell_s4_q & and_1478_s4_q));
  // hls/stages/agreement.hpp:1059
  logic not_2009;
  assign not_2009 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1060
  logic not_2026;
  assign not_2026 = ~(equal_1540_s4_q ? and_1561 : not_2024_s4_q);
  // hls/stages/agreement.hpp:392
  logic and_2029;
  assign and_2029 = ends_cell_s4_q & (not_2009 & (centres_values_1_textured_s4_q & not_2026));
  logic and_2031;
  assign and_2031 = not_1338_s4_q & (drew_q & and_2029);
  // hls/stages/agreement.hpp:1085
  logic less_2034;
  assign less_2034 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2035;
  assign select_2035 = less_2034 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2038;
  assign select_2038 = less_2034 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1086
  logic [10:0] sum_2039;
  assign sum_2039 = {1'b0, select_2038} + {3'h0, select_2038[9:2]};
  logic and_2041;
  assign and_2041 = (~(select_2035[9:4] == 6'h0)) & ({sum_2039, select_2038[1:0]} < {3'h0, select_2035});
  // hls/stages/agreement.hpp:1095
  logic [9:0] select_2044;
  assign select_2044 = x_s4_q[6] ? (equal_1382_s4_q ? 10'h0 : (and_2041 ? select_2035 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:392
  logic [9:0] select_2045;
  assign select_2045 = equal_1337_s4_q ? select_2044 : 10'h0;
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2047;
  assign select_2047 = and_1986_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2045});
  logic [13:0] select_2054;
  assign select_2054 = and_1986_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2052_s4_q});
  // hls/stages/agreement.hpp:1064
  logic and_2056;
  assign and_2056 = not_2009 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:392
  logic and_2059;
  assign and_2059 = not_1338_s4_q & (drew_q & (ends_cell_s4_q & and_2056));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2061;
  assign select_2061 = and_1986_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2059});
  // hls/stages/agreement.hpp:1064
  logic and_2063;
  assign and_2063 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2026);
  // hls/stages/agreement.hpp:392
  logic and_2067;
  assign and_2067 = not_1338_s4_q & (drew_q & (ends_cell_s4_q & (not_2009 & and_2063)));
  // hls/stages/agreement.hpp:904
  logic [13:0] select_2069;
  assign select_2069 = and_1986_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2067});
  // hls/stages/registration.hpp:106
  logic [7:0] select_2139;
  assign select_2139 = equal_2094_s4_q ? (and_2124_s4_q ? residual_s4_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2141;
  assign select_2141 = equal_1337_s4_q ? 8'h0 : (drew_q ? select_2139 : 8'h0);
  // hls/stages/registration.hpp:133
  logic [13:0] select_2143;
  assign select_2143 = and_2122_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2141[7]}}, select_2141});
  // hls/stages/agreement.hpp:392
  logic and_2146;
  assign and_2146 = not_1338_s4_q & (drew_q & (and_2124_s4_q & equal_2094_s4_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2148;
  assign select_2148 = and_2122_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2146});
  // hls/stages/registration.hpp:106
  logic and_2150;
  assign and_2150 = and_2124_s4_q & ($signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2152;
  assign select_2152 = drew_q ? (equal_2094_s4_q ? {and_2150, and_2124_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2153;
  assign select_2153 = equal_1337_s4_q ? 2'h0 : select_2152;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2154;
  assign sum_2154 = registration_half_votes_down_q + {{5{select_2153[1]}}, select_2153};
  // hls/stages/registration.hpp:200
  logic [12:0] difference_2156;
  assign difference_2156 = 13'h0 - {residual_s4_q[11], residual_s4_q};
  // hls/stages/registration.hpp:106
  logic and_2158;
  assign and_2158 = and_2124_s4_q & ($signed(difference_2156) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2160;
  assign select_2160 = drew_q ? (equal_2094_s4_q ? {and_2158, and_2124_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2161;
  assign select_2161 = equal_1337_s4_q ? 2'h0 : select_2160;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2162;
  assign sum_2162 = registration_half_votes_up_q + {{5{select_2161[1]}}, select_2161};
  // hls/stages/registration.hpp:200
  logic less_2164;
  assign less_2164 = $signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2165;
  assign and_2165 = and_2124_s4_q & less_2164;
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2167;
  assign select_2167 = drew_q ? (equal_2094_s4_q ? {and_2165, and_2124_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2168;
  assign select_2168 = equal_1337_s4_q ? 2'h0 : select_2167;
  // hls/stages/registration.hpp:179
  logic [6:0] sum_2169;
  assign sum_2169 = registration_half_half_votes_down_q + {{5{select_2168[1]}}, select_2168};
  // hls/stages/registration.hpp:200
  logic less_2171;
  assign less_2171 = $signed(difference_2156) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2172;
  assign and_2172 = and_2124_s4_q & less_2171;
  // hls/stages/agreement.hpp:392
  logic [1:0] select_2174;
  assign select_2174 = drew_q ? (equal_2094_s4_q ? {and_2172, and_2124_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2175;
  assign select_2175 = equal_1337_s4_q ? 2'h0 : select_2174;
  // hls/stages/registration.hpp:180
  logic [6:0] sum_2176;
  assign sum_2176 = registration_half_half_votes_up_q + {{5{select_2175[1]}}, select_2175};
  // hls/stages/agreement.hpp:392
  logic and_2210;
  assign and_2210 = equal_1337_s4_q & (x_s4_q[6] & (not_1456_s4_q & less_1410_s4_q));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2217;
  assign select_2217 = or_1414_s4_q ? 12'h0 : (equal_2215_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2220;
  assign select_2220 = x_s4_q[6] ? (equal_1382_s4_q ? 12'h0 : (less_1410_s4_q ? select_2217 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2221;
  assign select_2221 = equal_1337_s4_q ? select_2220 : 12'h0;
  // hls/stages/registration.hpp:152
  logic and_2222;
  assign and_2222 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1095
  logic and_2225;
  assign and_2225 = not_1456_s4_q & (less_1410_s4_q & ({and_2222, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:392
  logic and_2227;
  assign and_2227 = equal_1337_s4_q & (x_s4_q[6] & and_2225);
  // hls/stages/registration.hpp:247
  logic [13:0] sum_2229;
  assign sum_2229 = {{2{select_2221[11]}}, select_2221} + (and_2227 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2232;
  assign select_2232 = or_1414_s4_q ? 12'h0 : (equal_2215_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1095
  logic [11:0] select_2235;
  assign select_2235 = x_s4_q[6] ? (equal_1382_s4_q ? 12'h0 : (less_1410_s4_q ? select_2232 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:392
  logic [11:0] select_2236;
  assign select_2236 = equal_1337_s4_q ? select_2235 : 12'h0;
  // hls/stages/registration.hpp:248
  logic [13:0] sum_2238;
  assign sum_2238 = {{2{select_2236[11]}}, select_2236} + (and_2227 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:149
  logic not_2240;
  assign not_2240 = ~all_s4_q;
  // hls/stages/agreement.hpp:1095
  logic and_2243;
  assign and_2243 = not_1456_s4_q & (less_1410_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2240, 1'b0}));
  // hls/stages/agreement.hpp:392
  logic and_2249;
  assign and_2249 = equal_1337_s4_q & (x_s4_q[6] & (not_1456_s4_q & (less_1410_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:241
  logic not_2250;
  assign not_2250 = ~and_2249;
  logic less_2251;
  assign less_2251 = $signed({9'h1, {2{not_2250}}, and_2249}) < $signed(registration_up_q[13:2]);
  logic select_2252;
  assign select_2252 = (equal_1337_s4_q & (x_s4_q[6] & and_2243)) ? less_2251 : registration_enough_q;
  // hls/stages/agreement.hpp:1095
  logic and_2256;
  assign and_2256 = x_s4_q[6] & (not_1456_s4_q & (less_1410_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:392
  logic and_2257;
  assign and_2257 = equal_1337_s4_q & and_2256;
  // hls/stages/registration.hpp:237
  logic less_2258;
  assign less_2258 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2260;
  assign less_2260 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1095
  logic and_2265;
  assign and_2265 = x_s4_q[6] & (not_1456_s4_q & (less_1410_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:392
  logic and_2266;
  assign and_2266 = equal_1337_s4_q & and_2265;
  // hls/stages/agreement.hpp:1095
  logic and_2273;
  assign and_2273 = x_s4_q[6] & (not_1456_s4_q & (less_1410_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:156
  logic equal_2276;
  assign equal_2276 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1095
  logic and_2279;
  assign and_2279 = not_1456_s4_q & (less_1410_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2276));
  // hls/stages/registration.hpp:239
  logic and_2283;
  assign and_2283 = (equal_1337_s4_q & (x_s4_q[6] & and_2279)) & (less_2260 | less_2258);
  // hls/stages/agreement.hpp:1095
  logic and_2288;
  assign and_2288 = not_1456_s4_q & (less_1410_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2276)));
  // hls/stages/registration.hpp:239
  logic and_2291;
  assign and_2291 = registration_votes_up_q & registration_other_down_q;
  logic select_2293;
  assign select_2293 = registration_votes_down_q ? (registration_other_up_q | and_2291) : and_2291;
  // hls/stages/registration.hpp:137
  logic and_2295;
  assign and_2295 = (equal_1337_s4_q & (x_s4_q[6] & and_2288)) & (registration_other_enough_q & select_2293);
  // hls/stages/registration.hpp:240
  logic or_2298;
  assign or_2298 = registration_moved_q | (registration_enough_q & (and_2283 | and_2295));
  // hls/stages/agreement.hpp:1132
  logic or_2356;
  assign or_2356 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1154
  logic equal_2358;
  assign equal_2358 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1160
  logic equal_2359;
  assign equal_2359 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1163
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1164
  logic select_2365;
  assign select_2365 = (equal_2358 & equal_2359) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2368;
  assign sum_2368 = {1'b0, select_2038} + {2'h0, select_2038[9:1]};
  logic select_2371;
  assign select_2371 = (select_2035[9:3] == 7'h0) ? ((~or_2356) & (~select_2365)) : (~({sum_2368, select_2038[0]} < {2'h0, select_2035}));
  // hls/stages/agreement.hpp:1095
  logic [47:0] select_2373;
  assign select_2373 = x_s4_q[6] ? (equal_1382_s4_q ? good_q : {select_2371, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:392
  logic select_2378;
  assign select_2378 = equal_1337_s4_q ? ((x_s4_q[6] & good_known_q) | equal_2376_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1154
  logic equal_2379;
  assign equal_2379 = x_s4_q[6:3] == 4'ha;
  logic equal_2381;
  assign equal_2381 = x_s4_q[6:3] == 4'h9;
  logic equal_2382;
  assign equal_2382 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2384;
  assign select_2384 = equal_2381 ? counts_skin_unproven_q : (equal_2382 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2379 ? counts_nearer_q : select_2384;
  // hls/stages/agreement.hpp:1159
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1167
  logic select_2387;
  assign select_2387 = (equal_2379 & equal_2359) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1096
  logic not_2388;
  assign not_2388 = ~hidden_for_q[7];
  logic [7:0] select_2390;
  assign select_2390 = select_2387 ? (hidden_for_q + {7'h0, not_2388}) : 8'h0;
  // hls/stages/agreement.hpp:392
  logic [7:0] select_2392;
  assign select_2392 = equal_1337_s4_q ? (equal_2376_s4_q ? select_2390 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2393;
  assign select_2393 = equal_2359 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1079
  logic [7:0] select_2395;
  assign select_2395 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2397;
  assign select_2397 = equal_2382 ? cfg_unproven_skin_limit_i : (equal_2358 ? cfg_unproven_limit_i : select_2395);
  logic [7:0] limit;
  assign limit = equal_2379 ? cfg_regions_limit_i : (equal_2381 ? cfg_hidden_limit_i : select_2397);
  // hls/stages/agreement.hpp:1167
  logic not_2400;
  assign not_2400 = ~x_s4_q[2];
  logic [3:0] select_2401;
  assign select_2401 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_2400, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_2400};
  logic [7:0] select_2402;
  assign select_2402 = x_s4_q[0] ? {select_2401[3], 1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0], 1'b0} : {1'b0, select_2401[3], 1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0]};
  // hls/stages/agreement.hpp:1079
  logic [13:0] select_2406;
  assign select_2406 = equal_2381 ? counts_skin_supervised_q : (equal_2382 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2379 ? counts_textured_q : select_2406;
  // hls/stages/agreement.hpp:1167
  logic [13:0] select_2408;
  assign select_2408 = ((limit & select_2402) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2393} + {1'b0, select_2408};
  // hls/stages/agreement.hpp:392
  logic select_2413;
  assign select_2413 = equal_1337_s4_q ? (equal_2359 ? sum_3[0] : (product_rest_q | sum_3[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1165
  logic and_2418;
  assign and_2418 = too_much_q & (~(equal_2382 & equal_2359));
  // hls/stages/agreement.hpp:1166
  logic select_2423;
  assign select_2423 = (over[14] & equal_2359) ? (and_2418 | ((equal_2382 | equal_2381) | (x_s4_q[6:3] == 4'hf))) : and_2418;
  // hls/stages/agreement.hpp:1207
  logic select_2531;
  assign select_2531 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:257
  logic select_2533;
  assign select_2533 = left_first_s4_q ? done_s4_q : (and_1510_s4_q ? select_2531 : proven_q);
  // hls/stages/agreement.hpp:1240
  logic [1:0] select_2584;
  assign select_2584 = and_2583_s4_q ? {and_1591, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1241
  logic and_2585;
  assign and_2585 = select_2531 & less_2561;
  // hls/stages/agreement.hpp:413
  logic select_2588;
  assign select_2588 = and_1517_s4_q ? (less_1518_s4_q ? (select_2584[0] & and_2585) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:257
  logic select_2590;
  assign select_2590 = left_first_s4_q ? select_2588 : (and_1510_s4_q ? select_2588 : seen_q);
  logic select_2591;
  assign select_2591 = and_1510_s4_q ? select_2590 : seen_q;
  // hls/stages/agreement.hpp:413
  logic select_2594;
  assign select_2594 = and_1517_s4_q ? (less_1518_s4_q ? (select_2584[1] & and_2585) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:257
  logic select_2596;
  assign select_2596 = left_first_s4_q ? select_2594 : (and_1510_s4_q ? select_2594 : nearer_q);
  logic select_2597;
  assign select_2597 = and_1510_s4_q ? select_2596 : nearer_q;
  // hls/stages/agreement.hpp:392
  logic and_2604;
  assign and_2604 = equal_1337_s4_q & (equal_2376_s4_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:1176
  logic not_2609;
  assign not_2609 = ~(or_2356 | not_2598);
  // hls/stages/agreement.hpp:392
  logic and_2613;
  assign and_2613 = equal_1337_s4_q & (equal_2376_s4_q & (not_2609 & (select_2365 | select_2423)));
  logic and_2616;
  assign and_2616 = equal_1337_s4_q & (equal_2376_s4_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:1098
  logic or_2619;
  assign or_2619 = select_1849 | (select_1861 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:392
  logic and_2626;
  assign and_2626 = equal_1337_s4_q & (equal_2376_s4_q & (not_2609 & (select_1855 | select_1867)));
  // hls/stages/agreement.hpp:1098
  logic and_2631;
  assign and_2631 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2390 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:392
  logic and_2638;
  assign and_2638 = equal_1337_s4_q & (x_s4_q[6] & (not_1456_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1093
  logic [31:0] select_2646;
  assign select_2646 = equal_1402_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_2644_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_2647;
  assign select_2647 = equal_1400_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_2646;
  logic [31:0] select_2648;
  assign select_2648 = equal_1398_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_2647;
  logic [31:0] select_2649;
  assign select_2649 = equal_1396_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_2648;
  logic [31:0] select_2650;
  assign select_2650 = equal_1394_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_2649;
  logic [31:0] select_2651;
  assign select_2651 = equal_1392_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_2650;
  logic [31:0] select_2652;
  assign select_2652 = equal_1390_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_2651;
  // hls/stages/agreement.hpp:1091
  logic [9:0] select_2653;
  assign select_2653 = less_2034 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_2654;
  assign select_2654 = equal_1382_s4_q ? select_2652 : {2'h0, select_2653, select_2038, select_2035};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_368_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_483, and_459_s4_q, and_458_s4_q, and_433_s4_q, less_425_s4_q, less_424_s4_q, less_423_s4_q, less_422_s4_q, less_421_s4_q, less_420_s4_q, less_419_s4_q, less_418_s4_q, less_417_s4_q, less_416_s4_q, less_415_s4_q, less_414_s4_q, less_413_s4_q, less_412_s4_q, less_411_s4_q, less_410_s4_q, less_409_s4_q, less_408_s4_q, less_407_s4_q, less_406_s4_q, less_405_s4_q, less_404_s4_q, less_403_s4_q, less_402_s4_q};
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
  assign registration_sums_waddr = {sum_1388_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1444_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1443, sum_1439};
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
  assign regions_waddr = {region_row_s4_q, or_1454_s4_q, or_1451_s4_q, or_1448_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1483_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1482, sum_1476, sum_1471};
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
  assign map_waddr = sum_1526_s4_q;
  logic map_we;
  assign map_we = s4_en & and_1601_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1591, is_seen};
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
      sharpness_before_last_mask_q <= 1'b0;
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
      census_left_misses_q <= select_1755;
      sharpness_before_last_mask_q <= select_1763;
      sharpness_sums_detail_0_q <= and_368_s4_q ? select_1777 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_368_s4_q ? select_1789 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_368_s4_q ? sum_1793 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_368_s4_q ? sum_1797 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_1815 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_1825 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_1827 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_1829 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_1831 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_1833 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_1838;
      sharpness_comparing_carry_1_q <= select_1842;
      sharpness_comparing_less_detail_0_q <= select_1849;
      sharpness_comparing_less_detail_1_q <= select_1855;
      sharpness_comparing_less_contrast_0_q <= select_1861;
      sharpness_comparing_less_contrast_1_q <= select_1867;
      counts_supervised_q <= select_1992;
      counts_textured_q <= and_1986_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1995});
      counts_explained_q <= and_1986_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2000});
      counts_nearer_q <= and_1986_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2005});
      counts_unproven_q <= and_1986_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2031});
      counts_regions_bad_q <= select_2047;
      counts_skin_supervised_q <= select_2054;
      counts_skin_textured_q <= select_2061;
      counts_skin_unproven_q <= select_2069;
      registration_half_across_q <= select_2143;
      registration_half_measured_q <= select_2148;
      registration_half_votes_down_q <= and_2122_s4_q ? 7'h0 : sum_2154;
      registration_half_votes_up_q <= and_2122_s4_q ? 7'h0 : sum_2162;
      registration_half_half_votes_down_q <= and_2122_s4_q ? 7'h0 : sum_2169;
      registration_half_half_votes_up_q <= and_2122_s4_q ? 7'h0 : sum_2176;
      registration_down_q <= and_2210 ? sum_2229 : registration_down_q;
      registration_up_q <= and_2210 ? sum_2238 : registration_up_q;
      registration_enough_q <= select_2252;
      registration_votes_down_q <= and_2257 ? less_2258 : registration_votes_down_q;
      registration_votes_up_q <= and_2257 ? less_2260 : registration_votes_up_q;
      registration_other_enough_q <= and_2266 ? select_2252 : registration_other_enough_q;
      registration_other_down_q <= and_2266 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2266 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1337_s4_q & and_2273)) & or_2298;
      segment_textured_q <= select_1468 + {5'h0, and_1995};
      segment_explained_q <= select_1473 + {5'h0, and_2000};
      segment_nearer_q <= select_1479 + {5'h0, and_2005};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1337_s4_q ? select_2373 : good_q;
      good_known_q <= select_2378;
      hidden_for_q <= select_2392;
      product_q <= equal_1337_s4_q ? sum_3[14:1] : product_q;
      product_rest_q <= select_2413;
      disagree_q <= equal_1337_s4_q ? select_2365 : disagree_q;
      too_much_q <= equal_1337_s4_q ? select_2423 : too_much_q;
      hides_q <= equal_1337_s4_q ? select_2387 : hides_q;
      proven_q <= and_1510_s4_q ? select_2533 : proven_q;
      seen_q <= select_2591;
      nearer_q <= select_2597;
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
      averager_quarter_1_0_q <= select_1630;
      averager_quarter_1_1_q <= select_1632;
      averager_quarter_2_0_q <= select_1634;
      averager_quarter_2_1_q <= select_1636;
      averager_detail_0_q <= select_1648;
      averager_detail_1_q <= select_1656;
      census_changes_values_0_left_q <= and_368_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_368_s4_q ? sum_1739_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1741;
      census_changes_values_1_right_q <= select_1742;
      census_changes_values_2_left_q <= select_1743;
      census_changes_values_2_right_q <= select_1744;
      sharpness_last_mask_q <= and_368_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_368_s4_q ? select_1760[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_368_s4_q ? select_1760[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_2535_s5_q;
  logic or_2599_s5_q;
  logic and_2600_s5_q;
  logic and_2604_s5_q;
  logic and_2607_s5_q;
  logic and_2613_s5_q;
  logic and_2616_s5_q;
  logic and_2622_s5_q;
  logic and_2626_s5_q;
  logic and_2634_s5_q;
  logic and_2638_s5_q;
  logic [5:0] select_2640_s5_q;
  logic [31:0] select_2656_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_2535_s5_q <= said_q;
      or_2599_s5_q <= not_2598 | select_2591;
      and_2600_s5_q <= cfg_prove_i & select_2597;
      and_2604_s5_q <= and_2604;
      and_2607_s5_q <= equal_1337_s4_q & (equal_2376_s4_q & (cfg_prove_i & or_2356));
      and_2613_s5_q <= and_2613;
      and_2616_s5_q <= and_2616;
      and_2622_s5_q <= equal_1337_s4_q & (equal_2376_s4_q & (not_2609 & or_2619));
      and_2626_s5_q <= and_2626;
      and_2634_s5_q <= equal_1337_s4_q & (equal_2376_s4_q & (cfg_prove_i & and_2631));
      and_2638_s5_q <= and_2638;
      select_2640_s5_q <= equal_1337_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_2656_s5_q <= equal_1337_s4_q ? (x_s4_q[6] ? select_2654 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_2599_s5_q;
  assign marks_nearer_o = and_2600_s5_q;
  assign verdict_valid_o = and_2535_s5_q;
  assign verdict_unproven_yet_o = and_2604_s5_q;
  assign verdict_untextured_o = and_2607_s5_q;
  assign verdict_disagree_o = and_2613_s5_q;
  assign verdict_moved_o = and_2616_s5_q;
  assign verdict_unsharp_left_o = and_2622_s5_q;
  assign verdict_unsharp_right_o = and_2626_s5_q;
  assign verdict_hidden_o = and_2634_s5_q;
  assign frame_valid_o = and_2638_s5_q;
  assign frame_index_o = select_2640_s5_q;
  assign frame_word_o = select_2656_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_2109[0], sum_2105[0], sum_2091[0], detail_4[1:0], detail_3[1:0], sum_1749[4:0], sum_481[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
