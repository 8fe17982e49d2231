// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 1894 bits, pipeline 615 bits, memories 31188 bits.
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
  logic [5:0] sum_1958;
  assign sum_1958 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_2321;
  assign difference_2321 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2556;
  assign less_2556 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2557;
  assign sum_2557 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_2558;
  assign select_2558 = less_2556 ? {sum_2557, cfg_height_i[5:3]} : 8'h0;
  logic not_2593;
  assign not_2593 = ~cfg_prove_i;

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
  // hls/stages/census.hpp:94
  logic [7:0] select_333;
  assign select_333 = ({select_330, select_328} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:95
  logic [7:0] select_334;
  assign select_334 = select_328[0] ? averager_place_q : select_333;
  // hls/stages/census.hpp:40
  logic or_335;
  assign or_335 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:213
  logic and_341;
  assign and_341 = (~((~or_335) | (~select_328[0]))) & (select_334 < 8'hbd);
  // hls/stages/census.hpp:40
  logic [2:0] select_346;
  assign select_346 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:213
  logic whole;
  assign whole = select_328[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:215
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_330 : 6'h0;
  // hls/stages/census.hpp:45
  logic equal_363;
  assign equal_363 = select_328 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_364;
  assign equal_364 = select_346 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_365;
  assign and_365 = equal_364 & and_341;
  // hls/stages/agreement.hpp:215
  logic and_367;
  assign and_367 = sample_pair_whole_q & (equal_363 & and_365);
  // hls/stages/agreement.hpp:134
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:406
  logic equal_387;
  assign equal_387 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:391
  logic or_388;
  assign or_388 = so | equal_387;
  // hls/stages/agreement.hpp:527
  logic not_389;
  assign not_389 = ~or_388;
  // hls/stages/agreement.hpp:397
  logic equal_390;
  assign equal_390 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:398
  logic equal_392;
  assign equal_392 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:389
  logic [7:0] sum_393;
  assign sum_393 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:391
  logic [7:0] select_394;
  assign select_394 = run_shift_q[5] ? x_q : sum_393;
  logic less_395;
  assign less_395 = {2'h0, last_q} < select_394;
  // hls/stages/agreement.hpp:163
  logic not_396;
  assign not_396 = ~less_395;
  // hls/stages/agreement.hpp:551
  logic and_397;
  assign and_397 = equal_392 & not_396;
  logic and_399;
  assign and_399 = not_389 & ((~equal_390) & and_397);
  // hls/stages/census.hpp:40
  logic [5:0] select_426;
  assign select_426 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:215
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_426 : 6'h0;
  // hls/stages/agreement.hpp:551
  logic select_483;
  assign select_483 = equal_390 ? not_396 : and_397;
  // hls/stages/agreement.hpp:596
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:593
  logic [6:0] sum_503;
  assign sum_503 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:191
  logic and_508;
  assign and_508 = equal_390 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_503} < select_394))));
  logic select_509;
  assign select_509 = or_388 ? not_396 : and_508;
  // hls/stages/agreement.hpp:601
  logic equal_512;
  assign equal_512 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:605
  logic or_514;
  assign or_514 = equal_512 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:617
  logic [5:0] right;
  assign right = sum_393[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:746
  logic [4:0] sum_1416;
  assign sum_1416 = {1'b0, last_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:123
  logic and_1507;
  assign and_1507 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:215
  logic [2:0] select_1608;
  assign select_1608 = sample_pair_whole_q ? (sample_last_q ? (select_346 + 3'h1) : select_346) : raster_at_y_q;
  logic [5:0] select_1610;
  assign select_1610 = sample_pair_whole_q ? (select_330 + {5'h0, equal_363}) : raster_at_column_q;
  logic [5:0] select_1613;
  assign select_1613 = sample_pair_whole_q ? (sample_last_q ? (select_426 + {5'h0, equal_364}) : select_426) : raster_at_row_q;
  logic select_1617;
  assign select_1617 = sample_pair_whole_q ? (sample_last_q ? (or_335 & (~raster_final_row_q)) : or_335) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_1619;
  assign select_1619 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:215
  logic select_1623;
  assign select_1623 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:313
  logic equal_1864;
  assign equal_1864 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:318
  logic and_1865;
  assign and_1865 = and_367 & equal_1864;
  // hls/stages/agreement.hpp:368
  logic select_1868;
  assign select_1868 = (and_1865 | (~ends_cell_q)) ? and_1865 : ends_q;
  // hls/stages/agreement.hpp:374
  logic [2:0] now;
  assign now = select_1868 ? (and_1865 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:379
  logic [5:0] select_1872;
  assign select_1872 = select_1868 ? (and_1865 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_1875;
  assign select_1875 = select_1868 ? (following_last_shift_q & (~and_1865)) : run_last_shift_q;
  // hls/stages/agreement.hpp:146
  logic and_1878;
  assign and_1878 = run_last_shift_q & equal_390;
  // hls/stages/agreement.hpp:399
  logic select_1880;
  assign select_1880 = equal_390 ? (~run_last_shift_q) : equal_392;
  // hls/stages/agreement.hpp:403
  logic equal_1881;
  assign equal_1881 = run_phase_q == 3'h1;
  logic not_1884;
  assign not_1884 = ~select_1880;
  // hls/stages/agreement.hpp:406
  logic equal_1886;
  assign equal_1886 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:146
  logic and_1887;
  assign and_1887 = final_row_q & so;
  // hls/stages/agreement.hpp:403
  logic [1:0] select_1888;
  assign select_1888 = equal_1886 ? 2'h1 : {2{and_1887}};
  logic [2:0] select_1890;
  assign select_1890 = (and_1878 | (select_1880 | equal_1881)) ? (equal_1881 ? 3'h2 : {not_1884, {2{select_1880}}}) : (equal_387 ? 3'h6 : {select_1888[0], select_1888});
  // hls/stages/agreement.hpp:146
  logic and_1893;
  assign and_1893 = select_1880 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:413
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1896;
  assign select_1896 = (plan_shift_q[5] & select_1880) ? value : 7'h0;
  logic [1:0] or_1897;
  assign or_1897 = {2{so}} | select_1896[5:4];
  // hls/stages/agreement.hpp:416
  logic [7:0] select_1898;
  assign select_1898 = select_1880 ? plan_columns_q : 8'h0;
  logic [6:0] or_1901;
  assign or_1901 = select_1898[6:0] | ((equal_1881 | equal_1886) ? whole_q : 7'h0);
  logic [1:0] or_1902;
  assign or_1902 = {2{and_1878}} | or_1901[3:2];
  // hls/stages/agreement.hpp:417
  logic [6:0] or_1904;
  assign or_1904 = {or_1901[6:4], or_1902, or_1901[1:0]} | (equal_387 ? drawn_q : 7'h0);
  logic [4:0] or_1905;
  assign or_1905 = {5{so}} | {or_1904[6], or_1904[3:0]};
  // hls/stages/agreement.hpp:423
  logic not_1909;
  assign not_1909 = ~run_shift_q[5];
  logic [6:0] difference_1911;
  assign difference_1911 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_1912;
  assign select_1912 = equal_390 ? ({{7{not_1909}}, 1'b1} + run_span_q) : {difference_1911[6], difference_1911};
  // hls/stages/agreement.hpp:368
  logic [6:0] select_1916;
  assign select_1916 = and_1865 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:371
  logic [7:0] select_1918;
  assign select_1918 = select_1868 ? {select_1916[6], select_1916} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_1921;
  assign select_1921 = select_1868 ? (and_1865 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:365
  logic [5:0] select_1929;
  assign select_1929 = and_367 ? (equal_1864 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_1932;
  assign select_1932 = and_367 ? (equal_1864 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_1935;
  assign select_1935 = and_367 ? (equal_1864 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:376
  logic select_1949;
  assign select_1949 = (ends_cell_q | select_1868) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_390 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:371
  logic and_1953;
  assign and_1953 = (~select_1868) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:329
  logic [6:0] sum_1954;
  assign sum_1954 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:314
  logic select_1956;
  assign select_1956 = equal_1864 ? ({sum_1954[6], cfg_height_i[8:3]} == {1'b0, sum_1954[5:0]}) : final_row_q;

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1070; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
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

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1071; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1072; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory best_left, 47 x 46, DISTANCE 12, hls/stages/agreement.hpp:1073; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
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
      left_first_q <= and_1507 ? left_first_q : marks_first_i;
      right_q <= (~and_1507) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1507;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_328 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1608;
      raster_at_column_q <= select_1610;
      raster_at_row_q <= select_1613;
      raster_at_live_q <= select_1617;
      raster_rows_left_q <= sample_pair_whole_q ? select_1619 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_1623;
      averager_place_q <= sample_pair_whole_q ? select_334 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      run_phase_q <= now;
      run_shift_q <= select_1872;
      run_last_shift_q <= select_1875;
      run_span_q <= select_1868 ? (and_1865 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_1890;
      following_shift_q <= select_1880 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_1893;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1896[6], or_1897, select_1896[3:0]};
      following_columns_q <= {select_1898[7], or_1905[4], or_1904[5:4], or_1905[3:0]};
      plan_shift_q <= equal_390 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_1912;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_1918;
      columns_left_q <= select_1921;
      last_q <= and_367 ? (equal_1864 ? column : last_q) : last_q;
      least_q <= select_1929;
      whole_q <= select_1932;
      drawn_q <= select_1935;
      age_q <= select_1868 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_1868 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_1949;
      ends_q <= and_1953;
      final_row_q <= and_367 ? select_1956 : final_row_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
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
  logic select_1325_s1_q;
  logic equal_1334_s1_q;
  logic less_1417_s1_q;
  logic equal_1457_s1_q;
  logic not_1594_s1_q;
  logic equal_1864_s1_q;
  logic and_1865_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
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
      select_1325_s1_q <= or_514 ? equal_512 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1334_s1_q <= run_phase_q == 3'h7;
      less_1417_s1_q <= {2'h0, sum_1416, last_q[1]} < x_q;
      equal_1457_s1_q <= x_q == {2'h0, last_q};
      not_1594_s1_q <= ~({1'b0, sum_1416, last_q[1:0]} < x_q);
      equal_1864_s1_q <= equal_1864;
      and_1865_s1_q <= and_1865;
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
  // hls/stages/census.hpp:98
  logic and_342;
  assign and_342 = sample_pair_whole_s1_q & and_341_s1_q;
  // hls/stages/agreement.hpp:449
  logic not_487;
  assign not_487 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:452
  logic and_488;
  assign and_488 = left_rdata_q[12] & not_487;
  logic and_489;
  assign and_489 = left_rdata_q[28] & not_487;
  logic and_490;
  assign and_490 = left_rdata_q[44] & not_487;
  logic and_491;
  assign and_491 = left_rdata_q[60] & not_487;
  // hls/stages/agreement.hpp:453
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
  // hls/stages/agreement.hpp:159
  logic and_522;
  assign and_522 = left_rdata_q[44] & not_396_s1_q;
  logic and_523;
  assign and_523 = right_codes_rdata_q[38] & not_396_s1_q;
  logic [11:0] select_524;
  assign select_524 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_525;
  assign select_525 = less_395_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_529;
  assign select_529 = and_522 ? (and_523 ? (~(select_524 ^ select_525)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_535;
  assign parity_535 = ^select_529[5:3];
  logic parity_538;
  assign parity_538 = ^select_529[8:6];
  logic parity_541;
  assign parity_541 = ^select_529[11:3];
  // hls/stages/agreement.hpp:159
  logic and_545;
  assign and_545 = left_rdata_q[60] & not_396_s1_q;
  logic and_546;
  assign and_546 = right_codes_rdata_q[51] & not_396_s1_q;
  logic [11:0] select_547;
  assign select_547 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_548;
  assign select_548 = less_395_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_552;
  assign select_552 = and_545 ? (and_546 ? (~(select_547 ^ select_548)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_555;
  assign parity_555 = ^select_552[8:6];
  logic parity_558;
  assign parity_558 = ^select_552[11:9];
  // hls/stages/agreement.hpp:159
  logic and_562;
  assign and_562 = left_rdata_q[76] & not_396_s1_q;
  logic and_563;
  assign and_563 = right_codes_rdata_q[64] & not_396_s1_q;
  logic [11:0] select_564;
  assign select_564 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_565;
  assign select_565 = less_395_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_569;
  assign select_569 = and_562 ? (and_563 ? (~(select_564 ^ select_565)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
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
  // hls/stages/agreement.hpp:479
  logic or_601;
  assign or_601 = (select_529[1:0] == 2'h3) | (select_529[2] & (select_529[0] | select_529[1]));
  // hls/stages/agreement.hpp:481
  logic or_605;
  assign or_605 = (select_552[7:6] == 2'h3) | (select_552[8] & (select_552[6] | select_552[7]));
  logic or_609;
  assign or_609 = (select_552[10:9] == 2'h3) | (select_552[11] & (select_552[9] | select_552[10]));
  // hls/stages/agreement.hpp:479
  logic or_617;
  assign or_617 = (select_569[7:6] == 2'h3) | (select_569[8] & (~(select_569[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_621;
  assign or_621 = (select_569[1:0] == 2'h3) | (select_569[2] & (select_569[0] | select_569[1]));
  logic or_625;
  assign or_625 = (select_569[4:3] == 2'h3) | (select_569[5] & (select_569[3] | select_569[4]));
  // hls/stages/agreement.hpp:480
  logic parity_628;
  assign parity_628 = ^{or_625, or_621, or_617};
  // hls/stages/agreement.hpp:479
  logic or_632;
  assign or_632 = (select_552[4:3] == 2'h3) | (select_552[5] & (select_552[3] | select_552[4]));
  // hls/stages/agreement.hpp:481
  logic or_636;
  assign or_636 = (select_569[10:9] == 2'h3) | (select_569[11] & (select_569[9] | select_569[10]));
  logic or_640;
  assign or_640 = (select_552[1:0] == 2'h3) | (select_552[2] & (select_552[0] | select_552[1]));
  // hls/stages/agreement.hpp:480
  logic parity_643;
  assign parity_643 = ^{or_640, or_636, or_632};
  logic parity_646;
  assign parity_646 = ^{or_640, or_636, or_632, or_625, or_621, or_617, or_609, or_605, or_601};
  // hls/stages/agreement.hpp:481
  logic and_647;
  assign and_647 = parity_541 & parity_596;
  logic or_651;
  assign or_651 = (parity_535 & parity_538) | ((^select_529[11:9]) & (parity_535 | parity_538));
  logic and_654;
  assign and_654 = (^{select_552[11:6], select_529[2:0]}) & (parity_581 | parity_593);
  logic or_655;
  assign or_655 = (parity_581 & parity_593) | and_654;
  // hls/stages/agreement.hpp:479
  logic or_662;
  assign or_662 = (select_529[10:9] == 2'h3) | (select_529[11] & (select_529[9] | select_529[10]));
  // hls/stages/agreement.hpp:481
  logic or_666;
  assign or_666 = (select_529[4:3] == 2'h3) | (select_529[5] & (select_529[3] | select_529[4]));
  logic or_670;
  assign or_670 = (select_529[7:6] == 2'h3) | (select_529[8] & (select_529[6] | select_529[7]));
  // hls/stages/agreement.hpp:480
  logic parity_673;
  assign parity_673 = ^{or_670, or_666, or_662};
  // hls/stages/agreement.hpp:481
  logic or_677;
  assign or_677 = (parity_555 & parity_558) | ((^select_529[2:0]) & (parity_555 | parity_558));
  logic or_681;
  assign or_681 = (parity_575 & parity_578) | ((^select_569[8:6]) & (parity_575 | parity_578));
  logic or_685;
  assign or_685 = (parity_587 & parity_590) | ((^select_552[5:3]) & (parity_587 | parity_590));
  // hls/stages/agreement.hpp:480
  logic parity_688;
  assign parity_688 = ^{or_685, or_681, or_677};
  logic parity_691;
  assign parity_691 = ^{or_685, or_681, or_677, or_670, or_666, or_662, or_655, or_651, and_647};
  logic xor_692;
  assign xor_692 = parity_646 ^ parity_691;
  // hls/stages/agreement.hpp:481
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
  // hls/stages/agreement.hpp:480
  logic parity_719;
  assign parity_719 = ^{or_716, or_712, or_708};
  // hls/stages/agreement.hpp:481
  logic or_723;
  assign or_723 = (or_651 & or_655) | (and_647 & (or_651 | or_655));
  logic or_727;
  assign or_727 = (or_666 & or_670) | (or_662 & (or_666 | or_670));
  logic or_731;
  assign or_731 = (or_681 & or_685) | (or_677 & (or_681 | or_685));
  // hls/stages/agreement.hpp:480
  logic parity_734;
  assign parity_734 = ^{or_731, or_727, or_723};
  logic parity_737;
  assign parity_737 = ^{or_731, or_727, or_723, or_716, or_712, or_708, or_701, or_697, and_693};
  // hls/stages/agreement.hpp:481
  logic or_741;
  assign or_741 = (parity_719 & parity_734) | ((^{or_701, or_697, and_693}) & (parity_719 | parity_734));
  logic or_745;
  assign or_745 = (or_697 & or_701) | (and_693 & (or_697 | or_701));
  logic or_749;
  assign or_749 = (or_712 & or_716) | (or_708 & (or_712 | or_716));
  logic or_753;
  assign or_753 = (or_727 & or_731) | (or_723 & (or_727 | or_731));
  // hls/stages/agreement.hpp:480
  logic parity_758;
  assign parity_758 = ^{or_753, or_749, or_745, or_741};
  // hls/stages/agreement.hpp:481
  logic or_762;
  assign or_762 = (or_749 & or_753) | (or_745 & (or_749 | or_753));
  logic and_763;
  assign and_763 = or_741 & (^{or_753, or_749, or_745});
  // hls/stages/agreement.hpp:480
  logic xor_764;
  assign xor_764 = or_762 ^ and_763;
  // hls/stages/agreement.hpp:483
  logic and_765;
  assign and_765 = or_762 & and_763;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_766;
  assign select_766 = equal_390_s1_q ? {and_765, xor_764, parity_758, parity_737, xor_692, xor_597} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_388_s1_q ? 6'h0 : select_766;
  // hls/stages/agreement.hpp:465
  logic [11:0] select_777;
  assign select_777 = (slot_s1_q[0] ? and_563 : and_546) ? (~(select_525 ^ (slot_s1_q[0] ? select_564 : select_547))) : 12'h0;
  logic [11:0] select_778;
  assign select_778 = and_522 ? select_777 : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_784;
  assign parity_784 = ^select_778[5:3];
  logic parity_787;
  assign parity_787 = ^select_778[8:6];
  logic parity_790;
  assign parity_790 = ^select_778[11:3];
  // hls/stages/agreement.hpp:159
  logic and_794;
  assign and_794 = right_codes_rdata_q[77] & not_396_s1_q;
  logic [11:0] select_796;
  assign select_796 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_800;
  assign select_800 = (slot_s1_q[0] ? and_794 : and_563) ? (~(select_548 ^ (slot_s1_q[0] ? select_796 : select_564))) : 12'h0;
  logic [11:0] select_801;
  assign select_801 = and_545 ? select_800 : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_804;
  assign parity_804 = ^select_801[8:6];
  logic parity_807;
  assign parity_807 = ^select_801[11:9];
  // hls/stages/agreement.hpp:541
  logic select_812;
  assign select_812 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_396_s1_q) : and_794;
  logic [11:0] select_814;
  assign select_814 = slot_s1_q[0] ? (less_395_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_796;
  // hls/stages/agreement.hpp:465
  logic [11:0] select_818;
  assign select_818 = and_562 ? (select_812 ? (~(select_565 ^ select_814)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
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
  // hls/stages/agreement.hpp:479
  logic or_850;
  assign or_850 = (select_778[1:0] == 2'h3) | (select_778[2] & (select_778[0] | select_778[1]));
  // hls/stages/agreement.hpp:481
  logic or_854;
  assign or_854 = (select_801[7:6] == 2'h3) | (select_801[8] & (select_801[6] | select_801[7]));
  logic or_858;
  assign or_858 = (select_801[10:9] == 2'h3) | (select_801[11] & (select_801[9] | select_801[10]));
  // hls/stages/agreement.hpp:479
  logic or_866;
  assign or_866 = (select_818[7:6] == 2'h3) | (select_818[8] & (~(select_818[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_870;
  assign or_870 = (select_818[1:0] == 2'h3) | (select_818[2] & (select_818[0] | select_818[1]));
  logic or_874;
  assign or_874 = (select_818[4:3] == 2'h3) | (select_818[5] & (select_818[3] | select_818[4]));
  // hls/stages/agreement.hpp:480
  logic parity_877;
  assign parity_877 = ^{or_874, or_870, or_866};
  // hls/stages/agreement.hpp:479
  logic or_881;
  assign or_881 = (select_801[4:3] == 2'h3) | (select_801[5] & (select_801[3] | select_801[4]));
  // hls/stages/agreement.hpp:481
  logic or_885;
  assign or_885 = (select_818[10:9] == 2'h3) | (select_818[11] & (select_818[9] | select_818[10]));
  logic or_889;
  assign or_889 = (select_801[1:0] == 2'h3) | (select_801[2] & (select_801[0] | select_801[1]));
  // hls/stages/agreement.hpp:480
  logic parity_892;
  assign parity_892 = ^{or_889, or_885, or_881};
  logic parity_895;
  assign parity_895 = ^{or_889, or_885, or_881, or_874, or_870, or_866, or_858, or_854, or_850};
  // hls/stages/agreement.hpp:481
  logic and_896;
  assign and_896 = parity_790 & parity_845;
  logic or_900;
  assign or_900 = (parity_784 & parity_787) | ((^select_778[11:9]) & (parity_784 | parity_787));
  logic and_903;
  assign and_903 = (^{select_801[11:6], select_778[2:0]}) & (parity_830 | parity_842);
  logic or_904;
  assign or_904 = (parity_830 & parity_842) | and_903;
  // hls/stages/agreement.hpp:479
  logic or_911;
  assign or_911 = (select_778[10:9] == 2'h3) | (select_778[11] & (select_778[9] | select_778[10]));
  // hls/stages/agreement.hpp:481
  logic or_915;
  assign or_915 = (select_778[4:3] == 2'h3) | (select_778[5] & (select_778[3] | select_778[4]));
  logic or_919;
  assign or_919 = (select_778[7:6] == 2'h3) | (select_778[8] & (select_778[6] | select_778[7]));
  // hls/stages/agreement.hpp:480
  logic parity_922;
  assign parity_922 = ^{or_919, or_915, or_911};
  // hls/stages/agreement.hpp:481
  logic or_926;
  assign or_926 = (parity_804 & parity_807) | ((^select_778[2:0]) & (parity_804 | parity_807));
  logic or_930;
  assign or_930 = (parity_824 & parity_827) | ((^select_818[8:6]) & (parity_824 | parity_827));
  logic or_934;
  assign or_934 = (parity_836 & parity_839) | ((^select_801[5:3]) & (parity_836 | parity_839));
  // hls/stages/agreement.hpp:480
  logic parity_937;
  assign parity_937 = ^{or_934, or_930, or_926};
  logic parity_940;
  assign parity_940 = ^{or_934, or_930, or_926, or_919, or_915, or_911, or_904, or_900, and_896};
  logic xor_941;
  assign xor_941 = parity_895 ^ parity_940;
  // hls/stages/agreement.hpp:481
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
  // hls/stages/agreement.hpp:480
  logic parity_968;
  assign parity_968 = ^{or_965, or_961, or_957};
  // hls/stages/agreement.hpp:481
  logic or_972;
  assign or_972 = (or_900 & or_904) | (and_896 & (or_900 | or_904));
  logic or_976;
  assign or_976 = (or_915 & or_919) | (or_911 & (or_915 | or_919));
  logic or_980;
  assign or_980 = (or_930 & or_934) | (or_926 & (or_930 | or_934));
  // hls/stages/agreement.hpp:480
  logic parity_983;
  assign parity_983 = ^{or_980, or_976, or_972};
  logic parity_986;
  assign parity_986 = ^{or_980, or_976, or_972, or_965, or_961, or_957, or_950, or_946, and_942};
  // hls/stages/agreement.hpp:481
  logic or_990;
  assign or_990 = (parity_968 & parity_983) | ((^{or_950, or_946, and_942}) & (parity_968 | parity_983));
  logic or_994;
  assign or_994 = (or_946 & or_950) | (and_942 & (or_946 | or_950));
  logic or_998;
  assign or_998 = (or_961 & or_965) | (or_957 & (or_961 | or_965));
  logic or_1002;
  assign or_1002 = (or_976 & or_980) | (or_972 & (or_976 | or_980));
  // hls/stages/agreement.hpp:480
  logic parity_1007;
  assign parity_1007 = ^{or_1002, or_998, or_994, or_990};
  // hls/stages/agreement.hpp:481
  logic or_1011;
  assign or_1011 = (or_998 & or_1002) | (or_994 & (or_998 | or_1002));
  logic and_1012;
  assign and_1012 = or_990 & (^{or_1002, or_998, or_994});
  // hls/stages/agreement.hpp:480
  logic xor_1013;
  assign xor_1013 = or_1011 ^ and_1012;
  // hls/stages/agreement.hpp:483
  logic and_1014;
  assign and_1014 = or_1011 & and_1012;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_1015;
  assign select_1015 = equal_390_s1_q ? {and_1014, xor_1013, parity_1007, parity_986, xor_941, xor_846} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_388_s1_q ? 6'h0 : select_1015;
  // hls/stages/agreement.hpp:159
  logic and_1023;
  assign and_1023 = right_codes_rdata_q[25] & not_396_s1_q;
  // hls/stages/agreement.hpp:541
  logic select_1024;
  assign select_1024 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_396_s1_q) : and_1023;
  // hls/stages/agreement.hpp:159
  logic [11:0] select_1026;
  assign select_1026 = less_395_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:541
  logic [11:0] select_1027;
  assign select_1027 = slot_s1_q[0] ? (less_395_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1026;
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1031;
  assign select_1031 = and_522 ? (select_1024 ? (~(select_525 ^ select_1027)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1037;
  assign parity_1037 = ^select_1031[5:3];
  logic parity_1040;
  assign parity_1040 = ^select_1031[8:6];
  logic parity_1043;
  assign parity_1043 = ^select_1031[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1051;
  assign select_1051 = (slot_s1_q[0] ? and_1023 : and_523) ? (~(select_548 ^ (slot_s1_q[0] ? select_1026 : select_524))) : 12'h0;
  logic [11:0] select_1052;
  assign select_1052 = and_545 ? select_1051 : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1055;
  assign parity_1055 = ^select_1052[8:6];
  logic parity_1058;
  assign parity_1058 = ^select_1052[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1066;
  assign select_1066 = (slot_s1_q[0] ? and_523 : and_546) ? (~(select_565 ^ (slot_s1_q[0] ? select_524 : select_547))) : 12'h0;
  logic [11:0] select_1067;
  assign select_1067 = and_562 ? select_1066 : 12'h0;
  // hls/stages/agreement.hpp:480
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
  // hls/stages/agreement.hpp:479
  logic or_1099;
  assign or_1099 = (select_1031[1:0] == 2'h3) | (select_1031[2] & (select_1031[0] | select_1031[1]));
  // hls/stages/agreement.hpp:481
  logic or_1103;
  assign or_1103 = (select_1052[7:6] == 2'h3) | (select_1052[8] & (select_1052[6] | select_1052[7]));
  logic or_1107;
  assign or_1107 = (select_1052[10:9] == 2'h3) | (select_1052[11] & (select_1052[9] | select_1052[10]));
  // hls/stages/agreement.hpp:479
  logic or_1115;
  assign or_1115 = (select_1067[7:6] == 2'h3) | (select_1067[8] & (~(select_1067[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1119;
  assign or_1119 = (select_1067[1:0] == 2'h3) | (select_1067[2] & (select_1067[0] | select_1067[1]));
  logic or_1123;
  assign or_1123 = (select_1067[4:3] == 2'h3) | (select_1067[5] & (select_1067[3] | select_1067[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1126;
  assign parity_1126 = ^{or_1123, or_1119, or_1115};
  // hls/stages/agreement.hpp:479
  logic or_1130;
  assign or_1130 = (select_1052[4:3] == 2'h3) | (select_1052[5] & (select_1052[3] | select_1052[4]));
  // hls/stages/agreement.hpp:481
  logic or_1134;
  assign or_1134 = (select_1067[10:9] == 2'h3) | (select_1067[11] & (select_1067[9] | select_1067[10]));
  logic or_1138;
  assign or_1138 = (select_1052[1:0] == 2'h3) | (select_1052[2] & (select_1052[0] | select_1052[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1141;
  assign parity_1141 = ^{or_1138, or_1134, or_1130};
  logic parity_1144;
  assign parity_1144 = ^{or_1138, or_1134, or_1130, or_1123, or_1119, or_1115, or_1107, or_1103, or_1099};
  // hls/stages/agreement.hpp:481
  logic and_1145;
  assign and_1145 = parity_1043 & parity_1094;
  logic or_1149;
  assign or_1149 = (parity_1037 & parity_1040) | ((^select_1031[11:9]) & (parity_1037 | parity_1040));
  logic and_1152;
  assign and_1152 = (^{select_1052[11:6], select_1031[2:0]}) & (parity_1079 | parity_1091);
  logic or_1153;
  assign or_1153 = (parity_1079 & parity_1091) | and_1152;
  // hls/stages/agreement.hpp:479
  logic or_1160;
  assign or_1160 = (select_1031[10:9] == 2'h3) | (select_1031[11] & (select_1031[9] | select_1031[10]));
  // hls/stages/agreement.hpp:481
  logic or_1164;
  assign or_1164 = (select_1031[4:3] == 2'h3) | (select_1031[5] & (select_1031[3] | select_1031[4]));
  logic or_1168;
  assign or_1168 = (select_1031[7:6] == 2'h3) | (select_1031[8] & (select_1031[6] | select_1031[7]));
  // hls/stages/agreement.hpp:480
  logic parity_1171;
  assign parity_1171 = ^{or_1168, or_1164, or_1160};
  // hls/stages/agreement.hpp:481
  logic or_1175;
  assign or_1175 = (parity_1055 & parity_1058) | ((^select_1031[2:0]) & (parity_1055 | parity_1058));
  logic or_1179;
  assign or_1179 = (parity_1073 & parity_1076) | ((^select_1067[8:6]) & (parity_1073 | parity_1076));
  logic or_1183;
  assign or_1183 = (parity_1085 & parity_1088) | ((^select_1052[5:3]) & (parity_1085 | parity_1088));
  // hls/stages/agreement.hpp:480
  logic parity_1186;
  assign parity_1186 = ^{or_1183, or_1179, or_1175};
  logic parity_1189;
  assign parity_1189 = ^{or_1183, or_1179, or_1175, or_1168, or_1164, or_1160, or_1153, or_1149, and_1145};
  logic xor_1190;
  assign xor_1190 = parity_1144 ^ parity_1189;
  // hls/stages/agreement.hpp:481
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
  // hls/stages/agreement.hpp:480
  logic parity_1217;
  assign parity_1217 = ^{or_1214, or_1210, or_1206};
  // hls/stages/agreement.hpp:481
  logic or_1221;
  assign or_1221 = (or_1149 & or_1153) | (and_1145 & (or_1149 | or_1153));
  logic or_1225;
  assign or_1225 = (or_1164 & or_1168) | (or_1160 & (or_1164 | or_1168));
  logic or_1229;
  assign or_1229 = (or_1179 & or_1183) | (or_1175 & (or_1179 | or_1183));
  // hls/stages/agreement.hpp:480
  logic parity_1232;
  assign parity_1232 = ^{or_1229, or_1225, or_1221};
  logic parity_1235;
  assign parity_1235 = ^{or_1229, or_1225, or_1221, or_1214, or_1210, or_1206, or_1199, or_1195, and_1191};
  // hls/stages/agreement.hpp:481
  logic or_1239;
  assign or_1239 = (parity_1217 & parity_1232) | ((^{or_1199, or_1195, and_1191}) & (parity_1217 | parity_1232));
  logic or_1243;
  assign or_1243 = (or_1195 & or_1199) | (and_1191 & (or_1195 | or_1199));
  logic or_1247;
  assign or_1247 = (or_1210 & or_1214) | (or_1206 & (or_1210 | or_1214));
  logic or_1251;
  assign or_1251 = (or_1225 & or_1229) | (or_1221 & (or_1225 | or_1229));
  // hls/stages/agreement.hpp:480
  logic parity_1256;
  assign parity_1256 = ^{or_1251, or_1247, or_1243, or_1239};
  // hls/stages/agreement.hpp:481
  logic or_1260;
  assign or_1260 = (or_1247 & or_1251) | (or_1243 & (or_1247 | or_1251));
  logic and_1261;
  assign and_1261 = or_1239 & (^{or_1251, or_1247, or_1243});
  // hls/stages/agreement.hpp:480
  logic xor_1262;
  assign xor_1262 = or_1260 ^ and_1261;
  // hls/stages/agreement.hpp:483
  logic and_1263;
  assign and_1263 = or_1260 & and_1261;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_1264;
  assign select_1264 = equal_390_s1_q ? {and_1263, xor_1262, parity_1256, parity_1235, xor_1190, xor_1095} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_388_s1_q ? 6'h0 : select_1264;
  // hls/stages/agreement.hpp:719
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:720
  logic [5:0] sum_1320;
  assign sum_1320 = x_s1_q[5:0] + shift;
  // hls/stages/agreement.hpp:723
  logic and_1340;
  assign and_1340 = (or_388_s1_q & (left_rdata_q[61] & not_396_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:182
  logic or_1362;
  assign or_1362 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:211
  logic [5:0] select_1373;
  assign select_1373 = so_s1_q ? x_s1_q[5:0] : (or_388_s1_q ? (less_395_s1_q ? 6'h0 : sum_1320) : 6'h0);
  logic and_1596;
  assign and_1596 = ends_cell_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1594_s1_q);
  // hls/stages/agreement.hpp:314
  logic select_1961;
  assign select_1961 = equal_1864_s1_q ? (~({row_s1_q, 1'b0} < {sum_1958, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:365
  logic and_2189;
  assign and_2189 = and_367_s1_q & (equal_1864_s1_q & (row_s1_q[5:2] == 4'h0));

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:146; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1074; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_388_s1_q ? sum_1320 : right_s1_q;
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
      row_q <= and_367_s1_q ? (equal_1864_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_367_s1_q ? select_1961 : lower_half_q;
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
  logic select_1325_s2_q;
  logic equal_1334_s2_q;
  logic and_1341_s2_q;
  logic and_1344_s2_q;
  logic and_1348_s2_q;
  logic or_1362_s2_q;
  logic [5:0] select_1373_s2_q;
  logic less_1417_s2_q;
  logic equal_1457_s2_q;
  logic and_1507_s2_q;
  logic and_1597_s2_q;
  logic equal_1743_s2_q;
  logic equal_1864_s2_q;
  logic less_2118_s2_q;
  logic and_2190_s2_q;
  logic and_2192_s2_q;
  logic less_2299_s2_q;
  logic equal_2506_s2_q;
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
      select_1325_s2_q <= select_1325_s1_q;
      equal_1334_s2_q <= equal_1334_s1_q;
      and_1341_s2_q <= not_396_s1_q & and_1340;
      and_1344_s2_q <= (or_388_s1_q & (left_rdata_q[62] & not_396_s1_q)) & and_1340;
      and_1348_s2_q <= not_396_s1_q & (or_388_s1_q & (left_rdata_q[63] & not_396_s1_q));
      or_1362_s2_q <= or_1362;
      select_1373_s2_q <= select_1373;
      less_1417_s2_q <= less_1417_s1_q;
      equal_1457_s2_q <= equal_1457_s1_q;
      and_1507_s2_q <= sample_pair_whole_q;
      and_1597_s2_q <= so_s1_q & and_1596;
      equal_1743_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_1864_s2_q <= equal_1864_s1_q;
      less_2118_s2_q <= 5'h4 < row_q[5:1];
      and_2190_s2_q <= and_1865_s1_q & and_2189;
      and_2192_s2_q <= and_1865_s1_q & (~and_2189);
      less_2299_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2506_s2_q <= row_s1_q[5:3] == 3'h0;
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
  // hls/stages/census.hpp:91
  logic [11:0] select_345;
  assign select_345 = select_328_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_349;
  assign sum_349 = select_345 + (equal_347_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_351;
  assign sum_351 = {4'h0, sample_pair_pixel_1_q} + (select_328_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_353;
  assign sum_353 = sum_351 + (equal_347_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_357;
  assign and_357 = whole_s2_q & (averager_memory_rdata_q[24] | equal_347_s2_q);
  // hls/stages/agreement.hpp:213
  logic all_of_skin;
  assign all_of_skin = select_328_s2_q ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:102
  logic and_361;
  assign and_361 = all_of_skin & (averager_memory_rdata_q[25] | equal_347_s2_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_341_s2_q ? sum_349[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_341_s2_q ? sum_353[11:3] : 9'h0;
  logic and_378;
  assign and_378 = and_341_s2_q & and_357;
  // hls/stages/census.hpp:105
  logic select_380;
  assign select_380 = equal_370_s2_q ? and_378 : (averager_mask_q & and_378);
  // hls/stages/agreement.hpp:215
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_380;
  // hls/stages/census.hpp:126
  logic and_382;
  assign and_382 = and_341_s2_q & and_361;
  // hls/stages/census.hpp:105
  logic select_384;
  assign select_384 = equal_370_s2_q ? and_382 : (averager_of_skin_q & and_382);
  // hls/stages/agreement.hpp:595
  logic not_518;
  assign not_518 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_519;
  assign less_519 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:178
  logic and_521;
  assign and_521 = not_518 & (~less_519);
  // hls/stages/agreement.hpp:585
  logic [5:0] select_768;
  assign select_768 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_769;
  assign difference_769 = {1'b0, column_2_s2_q} - {1'b0, select_768};
  logic [7:0] sum_771;
  assign sum_771 = {difference_769[6], difference_769} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:562
  logic [7:0] select_772;
  assign select_772 = slot_s2_q[0] ? chosen_score_q : sum_771;
  // hls/stages/agreement.hpp:585
  logic [6:0] difference_1018;
  assign difference_1018 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1017_s2_q};
  // hls/stages/agreement.hpp:556
  logic equal_1019;
  assign equal_1019 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:585
  logic [7:0] sum_1021;
  assign sum_1021 = {difference_1018[6], difference_1018} + (equal_1019 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1267;
  assign difference_1267 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1266_s2_q};
  logic [7:0] sum_1269;
  assign sum_1269 = {difference_1267[6], difference_1267} + (equal_1019 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:558
  logic less_1270;
  assign less_1270 = sum_1021 < sum_1269;
  logic [7:0] select_1271;
  assign select_1271 = less_1270 ? sum_1269 : sum_1021;
  logic less_1272;
  assign less_1272 = select_772 < select_1271;
  // hls/stages/agreement.hpp:599
  logic [7:0] of_best;
  assign of_best = and_521 ? (less_1272 ? select_1271 : select_772) : 8'h0;
  // hls/stages/agreement.hpp:606
  logic or_1276;
  assign or_1276 = select_516_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:611
  logic [5:0] select_1277;
  assign select_1277 = or_1276 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:527
  logic not_1278;
  assign not_1278 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:559
  logic [1:0] select_1279;
  assign select_1279 = less_1270 ? {slot_s2_q[0], not_1278} : 2'h0;
  logic [2:0] select_1281;
  assign select_1281 = less_1272 ? {select_1279, not_1278} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:611
  logic [2:0] select_1282;
  assign select_1282 = or_1276 ? select_1281 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1283;
  assign select_1283 = or_1276 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:608
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
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1292;
  assign sum_1292 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1293;
  assign sum_1293 = {1'b0, before_v} + sum_1292;
  // hls/stages/agreement.hpp:562
  logic [6:0] select_1294;
  assign select_1294 = slot_s2_q[0] ? chosen_near_q : sum_1293;
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1296;
  assign sum_1296 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1297;
  assign sum_1297 = {1'b0, before_v_2} + sum_1296;
  // hls/stages/agreement.hpp:586
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:587
  logic [6:0] sum_1299;
  assign sum_1299 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1300;
  assign sum_1300 = {1'b0, before_v_3} + sum_1299;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1302;
  assign select_1302 = (sum_1297 < sum_1300) ? sum_1300 : sum_1297;
  logic [6:0] select_1304;
  assign select_1304 = (select_1294 < select_1302) ? select_1302 : select_1294;
  // hls/stages/agreement.hpp:608
  logic [6:0] select_1305;
  assign select_1305 = select_1287[0] ? {4'h0, select_1281} : select_1304;
  logic [7:0] select_1306;
  assign select_1306 = select_1287[1] ? (select_1287[0] ? before_1_q : sum_1021) : {1'b0, select_1305};
  // hls/stages/agreement.hpp:611
  logic [7:0] select_1308;
  assign select_1308 = or_1276 ? (select_1287[2] ? select_1289 : select_1306) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:609
  logic [1:0] select_1309;
  assign select_1309 = equal_1284 ? 2'h0 : {not_1286, equal_1285};
  logic [7:0] select_1311;
  assign select_1311 = select_1309[1] ? sum_1269 : (select_1309[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:611
  logic [7:0] select_1312;
  assign select_1312 = or_1276 ? select_1311 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:600
  logic [6:0] of_near;
  assign of_near = and_521 ? select_1304 : 7'h0;
  // hls/stages/agreement.hpp:611
  logic or_1315;
  assign or_1315 = select_516_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:615
  logic [6:0] select_1316;
  assign select_1316 = or_1315 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1317;
  assign select_1317 = or_1315 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:620
  logic or_1327;
  assign or_1327 = select_1325_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:624
  logic [7:0] select_1328;
  assign select_1328 = or_1327 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1329;
  assign select_1329 = or_1327 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1331;
  assign or_1331 = select_1325_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:628
  logic [6:0] select_1332;
  assign select_1332 = or_1331 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1333;
  assign select_1333 = or_1331 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:746
  logic not_1335;
  assign not_1335 = ~equal_1334_s2_q;
  // hls/stages/agreement.hpp:182
  logic and_1345;
  assign and_1345 = not_396_s2_q & and_1344_s2_q;
  // hls/stages/agreement.hpp:726
  logic select_1351;
  assign select_1351 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:727
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:733
  logic [8:0] difference_1354;
  assign difference_1354 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:734
  logic [9:0] sum_1355;
  assign sum_1355 = {difference_1354[8], difference_1354} + 10'h1;
  // hls/stages/agreement.hpp:182
  logic and_1357;
  assign and_1357 = (and_1344_s2_q & select_1351) & ({{22{sum_1355[9]}}, sum_1355} < 32'h3);
  logic and_1358;
  assign and_1358 = not_396_s2_q & and_1357;
  logic and_1364;
  assign and_1364 = not_396_s2_q & (and_1357 & or_1362_s2_q);
  // hls/stages/agreement.hpp:191
  logic [8:0] select_1365;
  assign select_1365 = less_395_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_388_s2_q ? {select_1365, and_1364, and_1358, and_1348_s2_q, and_1345, and_1341_s2_q, not_396_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:211
  logic and_1367;
  assign and_1367 = ends_cell_s2_q & inside_v[0];
  logic and_1369;
  assign and_1369 = not_1335 & (so_s2_q & and_1367);
  // hls/stages/agreement.hpp:197
  logic right_2;
  assign right_2 = inside_v[0] & less_1417_s2_q;
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:215
  logic select_1656;
  assign select_1656 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_1658;
  assign select_1658 = sample_pair_whole_s2_q ? (and_365_s2_q ? select_380 : averager_mask_q) : averager_mask_q;
  logic select_1660;
  assign select_1660 = sample_pair_whole_s2_q ? (and_365_s2_q ? select_384 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:174
  logic [5:0] select_1964;
  assign select_1964 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_1965;
  assign select_1965 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1966;
  assign select_1966 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_1967;
  assign select_1967 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1968;
  assign select_1968 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1969;
  assign select_1969 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_1973;
  assign select_1973 = slot_s2_q[0] ? 8'h0 : sum_771;
  // hls/stages/agreement.hpp:558
  logic less_1974;
  assign less_1974 = select_1973 < select_1271;
  // hls/stages/agreement.hpp:174
  logic [6:0] select_1976;
  assign select_1976 = slot_s2_q[0] ? 7'h0 : sum_1293;
  // hls/stages/registration.hpp:76
  logic less_2065;
  assign less_2065 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:191
  logic [7:0] select_2067;
  assign select_2067 = or_388_s2_q ? (less_395_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2069;
  assign select_2069 = or_388_s2_q ? (less_395_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2071;
  assign select_2071 = or_388_s2_q ? (less_395_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2069} - {1'b0, select_2071};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2073;
  assign select_2073 = rise[8] ? select_2069 : select_2071;
  logic [8:0] difference_2074;
  assign difference_2074 = {1'b0, select_2067} - {1'b0, select_2073};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2074[8] ? 8'h0 : difference_2074[7:0];
  // hls/stages/registration.hpp:37
  logic not_2076;
  assign not_2076 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2065 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2076};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2078;
  assign xor_2078 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2078};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2084;
  assign select_2084 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2065 ? {taken, 1'b1} : {not_2076, select_2084, not_2076};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2086;
  assign sum_2086 = {left, 1'b1} + {taken_2, less_2065};
  // hls/stages/agreement.hpp:192
  logic [4:0] select_2088;
  assign select_2088 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1075; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1369;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1099; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1369;
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
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1333, select_1332, select_1329, select_1328};
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
      averager_running_of_skin_q <= select_1656;
      averager_mask_q <= select_1658;
      averager_of_skin_q <= select_1660;
      chosen_score_q <= less_1974 ? select_1271 : select_1973;
      chosen_near_q <= (select_1976 < select_1302) ? select_1302 : select_1976;
      chosen_place_q <= less_1974 ? {select_1279, not_1278} : 3'h2;
      before_0_q <= select_1973;
      before_1_q <= sum_1021;
      before_2_q <= sum_1269;
      registration_displacement_over_q <= so_s2_q ? sum_2086[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2088;
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
      left_pixel_q <= and_1507_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_345 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_351 : averager_running_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_1964;
      middle_sum_columns_values_2_q <= select_1965;
      middle_sum_columns_values_3_q <= select_1966;
      middle_sum_columns_values_4_q <= select_1967;
      middle_sum_columns_values_5_q <= select_1968;
      middle_sum_columns_values_6_q <= select_1969;
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
  logic equal_1334_s3_q;
  logic not_1335_s3_q;
  logic [13:0] inside_v_s3_q;
  logic and_1369_s3_q;
  logic [5:0] select_1373_s3_q;
  logic and_1378_s3_q;
  logic right_2_s3_q;
  logic equal_1457_s3_q;
  logic textured_s3_q;
  logic and_1507_s3_q;
  logic and_1598_s3_q;
  logic equal_1743_s3_q;
  logic equal_1864_s3_q;
  logic and_2119_s3_q;
  logic less_2124_s3_q;
  logic and_2190_s3_q;
  logic and_2192_s3_q;
  logic less_2299_s3_q;
  logic equal_2506_s3_q;
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
      equal_1334_s3_q <= equal_1334_s2_q;
      not_1335_s3_q <= not_1335;
      inside_v_s3_q <= {inside_v[14:3], inside_v[1:0]};
      and_1369_s3_q <= and_1369;
      select_1373_s3_q <= select_1373_s2_q;
      and_1378_s3_q <= not_1335 & (so_s2_q ? and_1367 : (equal_387_s2_q & inside_v[4]));
      right_2_s3_q <= right_2;
      equal_1457_s3_q <= equal_1457_s2_q;
      textured_s3_q <= textured;
      and_1507_s3_q <= and_1507_s2_q;
      and_1598_s3_q <= not_1335 & and_1597_s2_q;
      equal_1743_s3_q <= equal_1743_s2_q;
      equal_1864_s3_q <= equal_1864_s2_q;
      and_2119_s3_q <= inside_v[4] & less_2118_s2_q;
      less_2124_s3_q <= select_2069 < select_2071;
      and_2190_s3_q <= and_2190_s2_q;
      and_2192_s3_q <= and_2192_s2_q;
      less_2299_s3_q <= less_2299_s2_q;
      equal_2506_s3_q <= equal_2506_s2_q;
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
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey_s3_q} + (equal_370_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_373;
  assign select_373 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_370_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_377;
  assign select_377 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:214
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
  // hls/stages/census.hpp:215
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
  // hls/stages/agreement.hpp:309
  logic equal_425;
  assign equal_425 = column_s3_q == 6'h0;
  logic [3:0] select_429;
  assign select_429 = equal_428_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:310
  logic [4:0] select_430;
  assign select_430 = equal_425 ? {select_429, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_431;
  assign select_431 = equal_425 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:219
  logic and_432;
  assign and_432 = select_430[4] & select_431[3];
  // hls/stages/census.hpp:206
  logic and_434;
  assign and_434 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_436;
  assign and_436 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_434);
  // hls/stages/agreement.hpp:310
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
  // hls/stages/census.hpp:190
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
  // hls/stages/agreement.hpp:139
  logic not_1374;
  assign not_1374 = ~so_s3_q;
  // hls/stages/agreement.hpp:211
  logic and_1375;
  assign and_1375 = not_1374 & inside_v_s3_q[4];
  // hls/stages/agreement.hpp:858
  logic equal_1379;
  assign equal_1379 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:898
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:139
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:859
  logic [1:0] select_1382;
  assign select_1382 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:871
  logic [3:0] select_1384;
  assign select_1384 = equal_1379 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1382});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1385;
  assign sum_1385 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_1386;
  assign select_1386 = equal_1334_s3_q ? select_1384 : {sum_1385, lower_half_s3_q, registration_of_right_q};
  // hls/stages/agreement.hpp:896
  logic equal_1387;
  assign equal_1387 = x_s3_q[5:0] == 6'h3e;
  logic equal_1389;
  assign equal_1389 = x_s3_q[5:0] == 6'h3d;
  logic equal_1391;
  assign equal_1391 = x_s3_q[5:0] == 6'h3c;
  logic equal_1393;
  assign equal_1393 = x_s3_q[5:0] == 6'h3b;
  logic equal_1395;
  assign equal_1395 = x_s3_q[5:0] == 6'h36;
  logic equal_1397;
  assign equal_1397 = x_s3_q[5:0] == 6'h35;
  logic equal_1399;
  assign equal_1399 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:898
  logic and_1403;
  assign and_1403 = (~equal_1393) & ((~equal_1395) & ((~equal_1397) & (~equal_1399)));
  // hls/stages/agreement.hpp:859
  logic less_1407;
  assign less_1407 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:140
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:152
  logic or_1411;
  assign or_1411 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:871
  logic select_1414;
  assign select_1414 = equal_1379 ? ((~equal_1387) & ((~equal_1389) & ((~equal_1391) & and_1403))) : (less_1407 & (~or_1411));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1422;
  assign sum_1422 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1424;
  assign and_1424 = half_ends & ({{3{sum_1422[4]}}, sum_1422} < 8'h3);
  // hls/stages/agreement.hpp:211
  logic and_1425;
  assign and_1425 = so_s3_q & and_1424;
  // hls/stages/registration.hpp:243
  logic not_1428;
  assign not_1428 = ~lower_half_s3_q;
  logic [3:0] select_1429;
  assign select_1429 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1428, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1428};
  // hls/stages/agreement.hpp:143
  logic [7:0] select_1442;
  assign select_1442 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:780
  logic or_1445;
  assign or_1445 = select_1442[7] | (~({select_1442[5], select_1442[3], select_1442[1]} == 3'h0));
  // hls/stages/agreement.hpp:779
  logic or_1448;
  assign or_1448 = select_1442[7] | (~({select_1442[6], select_1442[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:778
  logic or_1451;
  assign or_1451 = select_1442[7] | (~(select_1442[6:4] == 3'h0));
  // hls/stages/agreement.hpp:211
  logic [5:0] select_1452;
  assign select_1452 = equal_1334_s3_q ? x_s3_q[5:0] : {region_row_q, or_1451, or_1448, or_1445};
  // hls/stages/agreement.hpp:858
  logic not_1453;
  assign not_1453 = ~equal_1379;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1455;
  assign sum_1455 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:788
  logic or_1458;
  assign or_1458 = (~sum_1455[5]) | equal_1457_s3_q;
  // hls/stages/agreement.hpp:211
  logic and_1461;
  assign and_1461 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & or_1458));
  // hls/stages/agreement.hpp:197
  logic explained;
  assign explained = inside_v_s3_q[0] & inside_v_s3_q[3];
  logic and_1475;
  assign and_1475 = inside_v_s3_q[0] & ({inside_v_s3_q[4], inside_v_s3_q[2]} == 2'h3);
  logic and_1482;
  assign and_1482 = inside_v_s3_q[0] & inside_v_s3_q[2];
  // hls/stages/agreement.hpp:751
  logic select_1483;
  assign select_1483 = slot_s3_q[2] ? shown_shown_q : inside_v_s3_q[3];
  // hls/stages/agreement.hpp:197
  logic shown;
  assign shown = inside_v_s3_q[0] & (shown_right_rdata_q[0] | select_1483);
  // hls/stages/agreement.hpp:751
  logic select_1486;
  assign select_1486 = slot_s3_q[2] ? shown_nearer_q : inside_v_s3_q[4];
  // hls/stages/agreement.hpp:197
  logic near;
  assign near = inside_v_s3_q[0] & (select_1483 ? select_1486 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:979
  logic select_1489;
  assign select_1489 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:983
  logic select_1490;
  assign select_1490 = left_first_s3_q ? select_1489 : read_half_q;
  logic or_1491;
  assign or_1491 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:984
  logic [8:0] select_1492;
  assign select_1492 = or_1491 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:985
  logic [9:0] select_1494;
  assign select_1494 = left_first_s3_q ? 10'h1 : (or_1491 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:988
  logic and_1495;
  assign and_1495 = select_1492[8] & select_1494[9];
  // hls/stages/agreement.hpp:218
  logic next_row;
  assign next_row = and_1495 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:999
  logic [5:0] select_1498;
  assign select_1498 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1500;
  assign select_1500 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1498});
  // hls/stages/agreement.hpp:1009
  logic equal_1501;
  assign equal_1501 = seen_x_q == 3'h7;
  logic [7:0] select_1503;
  assign select_1503 = and_1495 ? 8'h0 : (seen_column_q + {7'h0, equal_1501});
  // hls/stages/agreement.hpp:1012
  logic [10:0] index;
  assign index = select_1500 + {3'h0, select_1503};
  // hls/stages/agreement.hpp:969
  logic [11:0] sum_1505;
  assign sum_1505 = {1'b0, {2{select_1490}}, 2'h0, {2{select_1490}}, 1'b0, {2{select_1490}}, 1'b0, select_1490} + {1'b0, index};
  // hls/stages/agreement.hpp:982
  logic not_1508;
  assign not_1508 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:218
  logic and_1510;
  assign and_1510 = not_1508 & (began_q | and_1495);
  // hls/stages/agreement.hpp:1010
  logic [2:0] select_1512;
  assign select_1512 = and_1495 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1011
  logic and_1514;
  assign and_1514 = and_1510 & (select_1512 == 3'h0);
  logic less_1515;
  assign less_1515 = select_1503 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:220
  logic and_1516;
  assign and_1516 = and_1514 & less_1515;
  logic and_1517;
  assign and_1517 = and_1507_s3_q & and_1516;
  logic select_1519;
  assign select_1519 = and_1507_s3_q ? (left_first_s3_q ? and_1516 : and_1517) : and_1517;
  // hls/stages/agreement.hpp:841
  logic [7:0] sum_1521;
  assign sum_1521 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1521[7], sum_1521, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:969
  logic [11:0] sum_1523;
  assign sum_1523 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:764
  logic and_1524;
  assign and_1524 = seen_columns_rdata_q[14] & inside_v_s3_q[0];
  logic and_1525;
  assign and_1525 = seen_columns_rdata_q[10] & inside_v_s3_q[0];
  logic and_1526;
  assign and_1526 = seen_columns_rdata_q[5] & inside_v_s3_q[0];
  logic and_1527;
  assign and_1527 = seen_columns_rdata_q[0] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:817
  logic [1:0] sum_1529;
  assign sum_1529 = {1'b0, and_1526} + ({1'b0, textured_s3_q} + {1'b0, and_1527});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1524} + ({2'h0, and_1525} + {1'b0, sum_1529});
  // hls/stages/agreement.hpp:824
  logic [2:0] select_1532;
  assign select_1532 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1533;
  assign difference_1533 = {1'b0, textured_2} - {1'b0, select_1532};
  // hls/stages/agreement.hpp:822
  logic equal_1534;
  assign equal_1534 = x_s3_q == 8'h0;
  // hls/stages/agreement.hpp:824
  logic [4:0] t;
  assign t = {difference_1533[3], difference_1533} + (equal_1534 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:764
  logic [7:0] select_1539;
  assign select_1539 = inside_v_s3_q[0] ? (sum_1455[5] ? select_1442 : {select_1442[6:0], 1'b0}) : select_1442;
  // hls/stages/agreement.hpp:780
  logic or_1542;
  assign or_1542 = select_1539[7] | (~({select_1539[5], select_1539[3], select_1539[1]} == 3'h0));
  // hls/stages/agreement.hpp:764
  logic and_1559;
  assign and_1559 = seen_columns_rdata_q[16] & inside_v_s3_q[0];
  logic and_1560;
  assign and_1560 = seen_columns_rdata_q[12] & inside_v_s3_q[0];
  logic and_1561;
  assign and_1561 = seen_columns_rdata_q[8] & inside_v_s3_q[0];
  logic and_1562;
  assign and_1562 = seen_columns_rdata_q[3] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:819
  logic [1:0] sum_1564;
  assign sum_1564 = {1'b0, and_1561} + ({1'b0, shown} + {1'b0, and_1562});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1559} + ({2'h0, and_1560} + {1'b0, sum_1564});
  // hls/stages/agreement.hpp:826
  logic [2:0] select_1567;
  assign select_1567 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_1568;
  assign difference_1568 = {1'b0, shown_2} - {1'b0, select_1567};
  logic [4:0] around;
  assign around = {difference_1568[3], difference_1568} + (equal_1534 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:833
  logic [5:0] sum_1571;
  assign sum_1571 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:764
  logic and_1575;
  assign and_1575 = seen_columns_rdata_q[17] & inside_v_s3_q[0];
  logic and_1576;
  assign and_1576 = seen_columns_rdata_q[13] & inside_v_s3_q[0];
  logic and_1577;
  assign and_1577 = seen_columns_rdata_q[9] & inside_v_s3_q[0];
  logic and_1578;
  assign and_1578 = seen_columns_rdata_q[4] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:820
  logic [1:0] sum_1580;
  assign sum_1580 = {1'b0, and_1577} + ({1'b0, near} + {1'b0, and_1578});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1575} + ({2'h0, and_1576} + {1'b0, sum_1580});
  // hls/stages/agreement.hpp:827
  logic [2:0] select_1583;
  assign select_1583 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_1584;
  assign difference_1584 = {1'b0, near_2} - {1'b0, select_1583};
  logic [4:0] n;
  assign n = {difference_1584[3], difference_1584} + (equal_1534 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:215
  logic [10:0] select_1635;
  assign select_1635 = sample_pair_whole_s3_q ? (and_365_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_1637;
  assign select_1637 = sample_pair_whole_s3_q ? (and_365_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/agreement.hpp:365
  logic [8:0] select_1661;
  assign select_1661 = and_367_s3_q ? select_373 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1662;
  assign select_1662 = and_367_s3_q ? select_377 : census_columns_values_0_cell_0_right_q;
  logic select_1663;
  assign select_1663 = and_367_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_1664;
  assign select_1664 = and_367_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1665;
  assign select_1665 = and_367_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1666;
  assign select_1666 = and_367_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1667;
  assign select_1667 = and_367_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1668;
  assign select_1668 = and_367_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_1669;
  assign select_1669 = and_367_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_1670;
  assign select_1670 = and_367_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_1671;
  assign select_1671 = and_367_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1672;
  assign select_1672 = and_367_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_1673;
  assign select_1673 = and_367_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1674;
  assign select_1674 = and_367_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1675;
  assign select_1675 = and_367_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_1676;
  assign select_1676 = and_367_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1677;
  assign select_1677 = and_367_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1678;
  assign select_1678 = and_367_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_1679;
  assign select_1679 = and_367_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_1680;
  assign select_1680 = and_367_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1681;
  assign select_1681 = and_367_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_1682;
  assign select_1682 = and_367_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_1683;
  assign select_1683 = and_367_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1684;
  assign select_1684 = and_367_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_1685;
  assign select_1685 = and_367_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_1686;
  assign select_1686 = and_367_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_1687;
  assign select_1687 = and_367_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1688;
  assign select_1688 = and_367_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_1689;
  assign select_1689 = and_367_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_1690;
  assign select_1690 = and_367_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1691;
  assign select_1691 = and_367_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_1692;
  assign select_1692 = and_367_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_1693;
  assign select_1693 = and_367_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1694;
  assign select_1694 = and_367_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_1695;
  assign select_1695 = and_367_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_1696;
  assign select_1696 = and_367_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1697;
  assign select_1697 = and_367_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_1698;
  assign select_1698 = and_367_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_1699;
  assign select_1699 = and_367_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1700;
  assign select_1700 = and_367_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_1701;
  assign select_1701 = and_367_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_1702;
  assign select_1702 = and_367_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1703;
  assign select_1703 = and_367_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_1704;
  assign select_1704 = and_367_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_1705;
  assign select_1705 = and_367_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1706;
  assign select_1706 = and_367_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_1707;
  assign select_1707 = and_367_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_1708;
  assign select_1708 = and_367_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_1709;
  assign select_1709 = and_367_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1710;
  assign select_1710 = and_367_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_1711;
  assign select_1711 = and_367_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_1712;
  assign select_1712 = and_367_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_1713;
  assign select_1713 = and_367_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1714;
  assign select_1714 = and_367_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_1715;
  assign select_1715 = and_367_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_1716;
  assign select_1716 = and_367_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1718;
  assign difference_1718 = {1'b0, select_377} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1719;
  assign xor_1719 = difference_1718[8:0] ^ {9{difference_1718[9]}};
  logic [9:0] sum_1720;
  assign sum_1720 = {9'h0, difference_1718[9]} + {1'b0, xor_1719};
  logic [9:0] difference_1721;
  assign difference_1721 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1722;
  assign xor_1722 = difference_1721[8:0] ^ {9{difference_1721[9]}};
  logic [9:0] sum_1723;
  assign sum_1723 = {9'h0, difference_1721[9]} + {1'b0, xor_1722};
  logic [9:0] difference_1725;
  assign difference_1725 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1726;
  assign xor_1726 = difference_1725[8:0] ^ {9{difference_1725[9]}};
  logic [9:0] sum_1727;
  assign sum_1727 = {9'h0, difference_1725[9]} + {1'b0, xor_1726};
  logic [10:0] sum_1728;
  assign sum_1728 = ({1'b0, sum_1720} + {1'b0, sum_1723}) + {1'b0, sum_1727};
  logic [9:0] difference_1729;
  assign difference_1729 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1730;
  assign xor_1730 = difference_1729[8:0] ^ {9{difference_1729[9]}};
  logic [9:0] sum_1731;
  assign sum_1731 = {9'h0, difference_1729[9]} + {1'b0, xor_1730};
  logic [9:0] difference_1733;
  assign difference_1733 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1734;
  assign xor_1734 = difference_1733[8:0] ^ {9{difference_1733[9]}};
  logic [9:0] sum_1735;
  assign sum_1735 = {9'h0, difference_1733[9]} + {1'b0, xor_1734};
  // hls/stages/census.hpp:273
  logic [9:0] difference_1763;
  assign difference_1763 = {1'b0, select_373} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1763[9]} + (difference_1763[8:0] ^ {9{difference_1763[9]}});
  logic [9:0] difference_1774;
  assign difference_1774 = {1'b0, select_377} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1774[9]} + (difference_1774[8:0] ^ {9{difference_1774[9]}});
  // hls/stages/agreement.hpp:365
  logic and_1981;
  assign and_1981 = and_367_s3_q & (equal_428_s3_q & equal_1864_s3_q);
  // hls/stages/agreement.hpp:211
  logic and_1984;
  assign and_1984 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & inside_v_s3_q[1]));
  // hls/stages/agreement.hpp:764
  logic and_2005;
  assign and_2005 = seen_columns_rdata_q[15] & inside_v_s3_q[0];
  logic and_2006;
  assign and_2006 = seen_columns_rdata_q[11] & inside_v_s3_q[0];
  logic and_2007;
  assign and_2007 = seen_columns_rdata_q[7] & inside_v_s3_q[0];
  logic and_2008;
  assign and_2008 = seen_columns_rdata_q[2] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:818
  logic [1:0] sum_2010;
  assign sum_2010 = {1'b0, and_2007} + ({1'b0, explained} + {1'b0, and_2008});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2005} + ({2'h0, and_2006} + {1'b0, sum_2010});
  // hls/stages/agreement.hpp:825
  logic [2:0] select_2013;
  assign select_2013 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2014;
  assign difference_2014 = {1'b0, explained_2} - {1'b0, select_2013};
  logic [4:0] e;
  assign e = {difference_2014[3], difference_2014} + (equal_1534 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:832
  logic [5:0] sum_2017;
  assign sum_2017 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:211
  logic and_2045;
  assign and_2045 = ends_cell_s3_q & (inside_v_s3_q[0] & (inside_v_s3_q[2:1] == 2'h3));
  // hls/stages/registration.hpp:83
  logic equal_2089;
  assign equal_2089 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:206
  logic [16:0] select_2091;
  assign select_2091 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2091[16:7])) ? 8'h7f : select_2091[7:0];
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2089 ? registration_slope_here_q : change;
  // hls/stages/registration.hpp:201
  logic [7:0] select_2095;
  assign select_2095 = inside_v_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2096;
  assign select_2096 = inside_v_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2097;
  assign difference_2097 = {{2{select_2095[7]}}, select_2095[7:1]} - {select_2096[7], select_2096};
  // hls/stages/registration.hpp:199
  logic [6:0] select_2098;
  assign select_2098 = inside_v_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2099;
  assign select_2099 = inside_v_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2100;
  assign sum_2100 = {{2{select_2098[6]}}, select_2098} + {select_2099[7], select_2099};
  // hls/stages/registration.hpp:200
  logic [7:0] select_2101;
  assign select_2101 = inside_v_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2102;
  assign select_2102 = inside_v_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2103;
  assign sum_2103 = {{2{select_2101[7]}}, select_2101[7:1]} + {select_2102[7], select_2102};
  // hls/stages/registration.hpp:202
  logic [10:0] sum_2104;
  assign sum_2104 = {{3{sum_2100[8]}}, sum_2100[8:1]} + {sum_2103[8], sum_2103, select_2101[0]};
  logic [9:0] sum_2105;
  assign sum_2105 = {difference_2097, select_2095[0]} + {sum_2104[10], sum_2104[10:2]};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2106;
  assign sum_2106 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_2105[9]}}, sum_2105[9:2]};
  // hls/stages/registration.hpp:206
  logic [7:0] select_2109;
  assign select_2109 = ($signed(sum_2106[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2106[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] select_2111;
  assign select_2111 = equal_2089 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2106[12:7])) ? 8'h7f : select_2109);
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2113;
  assign select_2113 = equal_1334_s3_q ? registration_slope_here_q : (so_s3_q ? select_2111 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2114;
  assign equal_2114 = slot_s3_q == 3'h4;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2123;
  assign sum_2123 = inside_v_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2125;
  assign difference_2125 = {sum_2123, inside_v_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2126;
  assign select_2126 = less_2124_s3_q ? difference_2125 : {sum_2123, inside_v_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2127;
  assign select_2127 = ((inside_v_s3_q[13:11] == 3'h0) | (inside_v_s3_q[13:11] == 3'h4)) ? {sum_2123, inside_v_s3_q[11], 5'h0} : select_2126;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2127[7]}}, select_2127} - {sum_2105[9], sum_2105, sum_2104[1]};
  // hls/stages/registration.hpp:206
  logic [11:0] select_2130;
  assign select_2130 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2130[11:7])) ? 12'h7f : select_2130;
  // hls/stages/agreement.hpp:211
  logic select_2174;
  assign select_2174 = so_s3_q ? (equal_2114 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2177;
  assign select_2177 = so_s3_q ? (equal_2089 ? inside_v_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:254
  logic [3:0] select_2182;
  assign select_2182 = (sum_1385 == 2'h2) ? (registration_fresh_q & (~select_1429)) : registration_fresh_q;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_2184;
  assign select_2184 = so_s3_q ? (and_1424 ? select_2182 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:227
  logic [3:0] select_2186;
  assign select_2186 = and_1981 ? 4'hf : (equal_1334_s3_q ? registration_fresh_q : select_2184);
  // hls/stages/registration.hpp:121
  logic [15:0] select_2193;
  assign select_2193 = and_2192_s3_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:124
  logic [23:0] select_2195;
  assign select_2195 = and_2190_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2193[15]}}, select_2193});
  // hls/stages/registration.hpp:122
  logic [15:0] select_2196;
  assign select_2196 = and_2192_s3_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2196[15]}}, select_2196};
  // hls/stages/registration.hpp:124
  logic [27:0] select_2198;
  assign select_2198 = and_2190_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:135
  logic and_2199;
  assign and_2199 = ends_cell_s3_q & so_s3_q;
  // hls/stages/registration.hpp:117
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2199 ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:859
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1382;
  // hls/stages/registration.hpp:243
  logic not_2207;
  assign not_2207 = ~quarter_2[1];
  logic [3:0] select_2208;
  assign select_2208 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2207, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2207};
  // hls/stages/agreement.hpp:211
  logic select_2296;
  assign select_2296 = equal_1334_s3_q ? shown_shown_q : (so_s3_q ? select_1483 : shown_shown_q);
  logic select_2298;
  assign select_2298 = equal_1334_s3_q ? shown_nearer_q : (so_s3_q ? select_1486 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_2300;
  assign sum_2300 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:314
  logic [2:0] select_2302;
  assign select_2302 = less_2299_s3_q ? (sum_2300[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2304;
  assign select_2304 = equal_1864_s3_q ? (equal_428_s3_q ? 3'h0 : select_2302) : region_row_q;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2309;
  assign select_2309 = equal_1334_s3_q ? select_1442 : (so_s3_q ? (ends_cell_s3_q ? select_1539 : select_1442) : 8'h1);
  // hls/stages/agreement.hpp:143
  logic [8:0] select_2311;
  assign select_2311 = so_s3_q ? (and_2199 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_2313;
  assign sum_2313 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2314;
  assign select_2314 = sum_1455[5] ? {1'b1, sum_1455[4:0], region_across_rest_q[2:0]} : sum_2313;
  // hls/stages/agreement.hpp:314
  logic [7:0] select_2316;
  assign select_2316 = equal_1864_s3_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_2319;
  assign select_2319 = equal_1864_s3_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  logic [8:0] select_2323;
  assign select_2323 = equal_428_s3_q ? {{2{difference_2321[6]}}, difference_2321} : (less_2299_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2325;
  assign select_2325 = and_367_s3_q ? (equal_1864_s3_q ? select_2323 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:314
  logic [6:0] select_2327;
  assign select_2327 = equal_428_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:365
  logic [6:0] select_2329;
  assign select_2329 = and_367_s3_q ? (equal_1864_s3_q ? select_2327 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_2330;
  assign sum_2330 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2331;
  assign select_2331 = sum_2300[7] ? {1'b1, sum_2300[6:0], region_down_rest_q[0]} : sum_2330;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2300[7];
  // hls/stages/agreement.hpp:314
  logic select_2335;
  assign select_2335 = equal_1864_s3_q ? (equal_428_s3_q | (less_2299_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:143
  logic or_2340;
  assign or_2340 = segment_starts_q | not_1374;
  // hls/stages/agreement.hpp:764
  logic select_2343;
  assign select_2343 = inside_v_s3_q[0] ? (sum_1455[5] ? (equal_1457_s3_q & or_1458) : or_1458) : or_2340;
  // hls/stages/agreement.hpp:211
  logic select_2346;
  assign select_2346 = equal_1334_s3_q ? or_2340 : (so_s3_q ? (ends_cell_s3_q ? select_2343 : or_2340) : or_2340);
  // hls/stages/agreement.hpp:871
  logic equal_2371;
  assign equal_2371 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:211
  logic [2:0] select_2422;
  assign select_2422 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_2424;
  assign select_2424 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2426;
  assign select_2426 = equal_1334_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_2424 : box_textured_columns_values_1_q);
  logic [2:0] select_2427;
  assign select_2427 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2429;
  assign select_2429 = equal_1334_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_2427 : box_textured_columns_values_2_q);
  logic [2:0] select_2430;
  assign select_2430 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2432;
  assign select_2432 = equal_1334_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_2430 : box_textured_columns_values_3_q);
  logic [2:0] select_2433;
  assign select_2433 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2435;
  assign select_2435 = equal_1334_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_2433 : box_textured_columns_values_4_q);
  logic [4:0] select_2437;
  assign select_2437 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_2440;
  assign select_2440 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_2442;
  assign select_2442 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2444;
  assign select_2444 = equal_1334_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_2442 : box_explained_columns_values_1_q);
  logic [2:0] select_2445;
  assign select_2445 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2447;
  assign select_2447 = equal_1334_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_2445 : box_explained_columns_values_2_q);
  logic [2:0] select_2448;
  assign select_2448 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_2450;
  assign select_2450 = equal_1334_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_2448 : box_explained_columns_values_3_q);
  logic [2:0] select_2451;
  assign select_2451 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_2453;
  assign select_2453 = equal_1334_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_2451 : box_explained_columns_values_4_q);
  logic [4:0] select_2455;
  assign select_2455 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_2456;
  assign select_2456 = equal_1334_s3_q ? box_explained_sum_sums_values_0_q : select_2455;
  logic [2:0] select_2458;
  assign select_2458 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_2460;
  assign select_2460 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_2462;
  assign select_2462 = equal_1334_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_2460 : box_shown_columns_values_1_q);
  logic [2:0] select_2463;
  assign select_2463 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_2465;
  assign select_2465 = equal_1334_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_2463 : box_shown_columns_values_2_q);
  logic [2:0] select_2466;
  assign select_2466 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_2468;
  assign select_2468 = equal_1334_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_2466 : box_shown_columns_values_3_q);
  logic [2:0] select_2469;
  assign select_2469 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_2471;
  assign select_2471 = equal_1334_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_2469 : box_shown_columns_values_4_q);
  logic [4:0] select_2473;
  assign select_2473 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_2476;
  assign select_2476 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_2478;
  assign select_2478 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_2480;
  assign select_2480 = equal_1334_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_2478 : box_nearer_columns_values_1_q);
  logic [2:0] select_2481;
  assign select_2481 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_2483;
  assign select_2483 = equal_1334_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_2481 : box_nearer_columns_values_2_q);
  logic [2:0] select_2484;
  assign select_2484 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_2486;
  assign select_2486 = equal_1334_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_2484 : box_nearer_columns_values_3_q);
  logic [2:0] select_2487;
  assign select_2487 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_2489;
  assign select_2489 = equal_1334_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_2487 : box_nearer_columns_values_4_q);
  logic [4:0] select_2491;
  assign select_2491 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_2494;
  assign select_2494 = so_s3_q ? (ends_cell_s3_q ? and_1526 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_2497;
  assign select_2497 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & inside_v_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_2499;
  assign select_2499 = equal_1334_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_2497 : centres_values_0_of_skin_q);
  logic select_2500;
  assign select_2500 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_2502;
  assign select_2502 = equal_1334_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_2500 : centres_values_1_textured_q);
  logic select_2503;
  assign select_2503 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_2505;
  assign select_2505 = equal_1334_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_2503 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:314
  logic [10:0] select_2509;
  assign select_2509 = equal_1864_s3_q ? (equal_2506_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:365
  logic [5:0] select_2512;
  assign select_2512 = and_367_s3_q ? (equal_1864_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:979
  logic xor_2513;
  assign xor_2513 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:220
  logic select_2515;
  assign select_2515 = and_1507_s3_q ? (left_first_s3_q ? xor_2513 : write_half_q) : write_half_q;
  logic select_2517;
  assign select_2517 = and_1507_s3_q ? (left_first_s3_q ? xor_2513 : select_2515) : write_half_q;
  logic select_2519;
  assign select_2519 = left_first_s3_q ? select_1489 : (and_1507_s3_q ? select_1490 : read_half_q);
  logic and_2523;
  assign and_2523 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_2532;
  assign select_2532 = left_first_s3_q ? 10'h1 : (and_1507_s3_q ? select_1494 : rows_passed_q);
  logic [8:0] select_2535;
  assign select_2535 = left_first_s3_q ? {select_1492[7:0], or_1491} : (and_1507_s3_q ? {select_1492[7:0], or_1491} : columns_passed_q);
  logic select_2538;
  assign select_2538 = left_first_s3_q ? marks_last_s3_q : (and_1507_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_2541;
  assign select_2541 = left_first_s3_q ? and_1510 : (and_1507_s3_q ? and_1510 : began_q);
  logic [2:0] select_2544;
  assign select_2544 = left_first_s3_q ? select_1512 : (and_1507_s3_q ? select_1512 : seen_x_q);
  // hls/stages/agreement.hpp:1008
  logic [2:0] select_2549;
  assign select_2549 = left_first_s3_q ? 3'h0 : (and_1495 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:220
  logic [2:0] select_2551;
  assign select_2551 = left_first_s3_q ? 3'h0 : (and_1507_s3_q ? select_2549 : seen_y_q);
  logic [7:0] select_2554;
  assign select_2554 = left_first_s3_q ? select_1503 : (and_1507_s3_q ? select_1503 : seen_column_q);
  // hls/stages/agreement.hpp:218
  logic [7:0] select_2560;
  assign select_2560 = left_first_s3_q ? select_2558 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:220
  logic [7:0] select_2562;
  assign select_2562 = left_first_s3_q ? select_2558 : (and_1507_s3_q ? select_2560 : seen_rows_left_q);
  // hls/stages/agreement.hpp:218
  logic and_2567;
  assign and_2567 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:220
  logic select_2569;
  assign select_2569 = left_first_s3_q ? and_2567 : (and_1507_s3_q ? and_2567 : at_cell_end_q);
  logic select_2572;
  assign select_2572 = left_first_s3_q ? next_row : (and_1507_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_2575;
  assign select_2575 = left_first_s3_q ? 11'h0 : (and_1507_s3_q ? select_1500 : seen_base_q);
  // hls/stages/registration.hpp:243
  logic not_2636;
  assign not_2636 = ~quarter[1];
  logic [3:0] select_2637;
  assign select_2637 = quarter[0] ? {quarter[1], 1'b0, not_2636, 1'b0} : {1'b0, quarter[1], 1'b0, not_2636};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:261; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1386;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & (equal_1334_s3_q ? (x_s3_q[6] & select_1414) : and_1425);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1092; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1452;
  logic regions_re;
  assign regions_re = s3_en & (equal_1334_s3_q ? (x_s3_q[6] & not_1453) : and_1461);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1103; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1505;
  logic map_re;
  assign map_re = s3_en & select_1519;
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
  assign shown_right_waddr = select_1373_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1378_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1375, not_1374};
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
  assign seen_columns_we = s3_en & and_1369_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1482, textured_s3_q};
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
      registration_slope_here_q <= select_2113;
      registration_of_right_q <= equal_1334_s3_q ? registration_of_right_q : select_2174;
      registration_was_inside_q <= equal_1334_s3_q ? registration_was_inside_q : select_2177;
      registration_fresh_q <= select_2186;
      registration_slope_row_q <= select_2195;
      registration_slope_change_q <= select_2198;
      registration_slope_q <= so_s3_q ? column_5 : {registration_slope_row_q, 4'h0};
      shown_shown_q <= select_2296;
      shown_nearer_q <= select_2298;
      region_row_q <= and_367_s3_q ? select_2304 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_2309;
      region_across_rest_q <= select_2311;
      region_across_back_q <= so_s3_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_2314;
      columns_begin_rest_q <= and_367_s3_q ? select_2316 : columns_begin_rest_q;
      columns_begin_back_q <= and_367_s3_q ? select_2319 : columns_begin_back_q;
      region_down_rest_q <= select_2325;
      region_down_back_q <= select_2329;
      region_down_next_q <= select_2331;
      region_fresh_q <= and_367_s3_q ? select_2335 : region_fresh_q;
      segment_starts_q <= select_2346;
      centres_values_0_textured_q <= equal_1334_s3_q ? centres_values_0_textured_q : select_2494;
      centres_values_0_of_skin_q <= select_2499;
      centres_values_1_textured_q <= select_2502;
      centres_values_1_of_skin_q <= select_2505;
      map_row_q <= and_367_s3_q ? select_2509 : map_row_q;
      map_width_q <= select_2512;
      write_half_q <= select_2517;
      read_half_q <= and_1507_s3_q ? select_2519 : read_half_q;
      done_q <= and_1507_s3_q ? (not_1508 & and_2523) : and_2523;
      drew_q <= so_s3_q;
      said_q <= equal_1334_s3_q & equal_2371;
      rows_passed_q <= and_1507_s3_q ? select_2532 : rows_passed_q;
      columns_passed_q <= and_1507_s3_q ? select_2535 : columns_passed_q;
      line_ended_q <= and_1507_s3_q ? select_2538 : line_ended_q;
      began_q <= and_1507_s3_q ? select_2541 : began_q;
      seen_x_q <= and_1507_s3_q ? select_2544 : seen_x_q;
      seen_y_q <= and_1507_s3_q ? select_2551 : seen_y_q;
      seen_column_q <= and_1507_s3_q ? select_2554 : seen_column_q;
      seen_rows_left_q <= and_1507_s3_q ? select_2562 : seen_rows_left_q;
      at_cell_end_q <= and_1507_s3_q ? select_2569 : at_cell_end_q;
      was_next_row_q <= and_1507_s3_q ? select_2572 : was_next_row_q;
      seen_base_q <= and_1507_s3_q ? select_2575 : seen_base_q;
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
      averager_total_0_q <= select_1635;
      averager_total_1_q <= select_1637;
      census_columns_values_0_cell_0_left_q <= select_1661;
      census_columns_values_0_cell_0_right_q <= select_1662;
      census_columns_values_0_cell_0_mask_q <= select_1663;
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
      census_columns_values_1_cell_0_mask_q <= select_1679;
      census_columns_values_1_cell_1_left_q <= select_1680;
      census_columns_values_1_cell_1_right_q <= select_1681;
      census_columns_values_1_cell_1_mask_q <= select_1682;
      census_columns_values_1_cell_2_left_q <= select_1683;
      census_columns_values_1_cell_2_right_q <= select_1684;
      census_columns_values_1_cell_2_mask_q <= select_1685;
      census_columns_values_1_cell_2_of_skin_q <= select_1686;
      census_columns_values_1_cell_3_left_q <= select_1687;
      census_columns_values_1_cell_3_right_q <= select_1688;
      census_columns_values_1_cell_3_mask_q <= select_1689;
      census_columns_values_1_cell_4_left_q <= select_1690;
      census_columns_values_1_cell_4_right_q <= select_1691;
      census_columns_values_1_cell_4_mask_q <= select_1692;
      census_columns_values_2_cell_0_left_q <= select_1693;
      census_columns_values_2_cell_0_right_q <= select_1694;
      census_columns_values_2_cell_0_mask_q <= select_1695;
      census_columns_values_2_cell_1_left_q <= select_1696;
      census_columns_values_2_cell_1_right_q <= select_1697;
      census_columns_values_2_cell_1_mask_q <= select_1698;
      census_columns_values_2_cell_2_left_q <= select_1699;
      census_columns_values_2_cell_2_right_q <= select_1700;
      census_columns_values_2_cell_2_mask_q <= select_1701;
      census_columns_values_2_cell_3_left_q <= select_1702;
      census_columns_values_2_cell_3_right_q <= select_1703;
      census_columns_values_2_cell_3_mask_q <= select_1704;
      census_columns_values_2_cell_4_left_q <= select_1705;
      census_columns_values_2_cell_4_right_q <= select_1706;
      census_columns_values_2_cell_4_mask_q <= select_1707;
      census_columns_values_3_cell_0_mask_q <= select_1708;
      census_columns_values_3_cell_1_left_q <= select_1709;
      census_columns_values_3_cell_1_right_q <= select_1710;
      census_columns_values_3_cell_1_mask_q <= select_1711;
      census_columns_values_3_cell_2_mask_q <= select_1712;
      census_columns_values_3_cell_3_left_q <= select_1713;
      census_columns_values_3_cell_3_right_q <= select_1714;
      census_columns_values_3_cell_3_mask_q <= select_1715;
      census_columns_values_3_cell_4_mask_q <= select_1716;
      sharpness_last_mean_0_q <= and_367_s3_q ? select_373 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_367_s3_q ? select_377 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1334_s3_q ? box_textured_columns_values_0_q : select_2422;
      box_textured_columns_values_1_q <= select_2426;
      box_textured_columns_values_2_q <= select_2429;
      box_textured_columns_values_3_q <= select_2432;
      box_textured_columns_values_4_q <= select_2435;
      box_textured_sum_sums_values_0_q <= equal_1334_s3_q ? box_textured_sum_sums_values_0_q : select_2437;
      box_explained_columns_values_0_q <= equal_1334_s3_q ? box_explained_columns_values_0_q : select_2440;
      box_explained_columns_values_1_q <= select_2444;
      box_explained_columns_values_2_q <= select_2447;
      box_explained_columns_values_3_q <= select_2450;
      box_explained_columns_values_4_q <= select_2453;
      box_explained_sum_sums_values_0_q <= select_2456;
      box_shown_columns_values_0_q <= equal_1334_s3_q ? box_shown_columns_values_0_q : select_2458;
      box_shown_columns_values_1_q <= select_2462;
      box_shown_columns_values_2_q <= select_2465;
      box_shown_columns_values_3_q <= select_2468;
      box_shown_columns_values_4_q <= select_2471;
      box_shown_sum_sums_values_0_q <= equal_1334_s3_q ? box_shown_sum_sums_values_0_q : select_2473;
      box_nearer_columns_values_0_q <= equal_1334_s3_q ? box_nearer_columns_values_0_q : select_2476;
      box_nearer_columns_values_1_q <= select_2480;
      box_nearer_columns_values_2_q <= select_2483;
      box_nearer_columns_values_3_q <= select_2486;
      box_nearer_columns_values_4_q <= select_2489;
      box_nearer_sum_sums_values_0_q <= equal_1334_s3_q ? box_nearer_sum_sums_values_0_q : select_2491;
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
  logic equal_1334_s4_q;
  logic not_1335_s4_q;
  logic equal_1379_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1385_s4_q;
  logic equal_1387_s4_q;
  logic equal_1389_s4_q;
  logic equal_1391_s4_q;
  logic equal_1393_s4_q;
  logic equal_1395_s4_q;
  logic equal_1397_s4_q;
  logic equal_1399_s4_q;
  logic less_1407_s4_q;
  logic or_1411_s4_q;
  logic equal_1431_s4_q;
  logic and_1441_s4_q;
  logic or_1445_s4_q;
  logic or_1448_s4_q;
  logic or_1451_s4_q;
  logic not_1453_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1475_s4_q;
  logic and_1480_s4_q;
  logic and_1507_s4_q;
  logic and_1514_s4_q;
  logic less_1515_s4_q;
  logic [11:0] sum_1523_s4_q;
  logic equal_1537_s4_q;
  logic or_1542_s4_q;
  logic or_1545_s4_q;
  logic or_1548_s4_q;
  logic not_1573_s4_q;
  logic less_1587_s4_q;
  logic and_1598_s4_q;
  logic [11:0] sum_1736_s4_q;
  logic equal_1743_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_1981_s4_q;
  logic and_1985_s4_q;
  logic not_2019_s4_q;
  logic and_2047_s4_q;
  logic equal_2089_s4_q;
  logic and_2117_s4_q;
  logic and_2119_s4_q;
  logic [11:0] residual_s4_q;
  logic equal_2210_s4_q;
  logic equal_2371_s4_q;
  logic and_2578_s4_q;
  logic equal_2639_s4_q;
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
      equal_1334_s4_q <= equal_1334_s3_q;
      not_1335_s4_q <= not_1335_s3_q;
      equal_1379_s4_q <= equal_1379;
      all_s4_q <= all;
      sum_1385_s4_q <= sum_1385;
      equal_1387_s4_q <= equal_1387;
      equal_1389_s4_q <= equal_1389;
      equal_1391_s4_q <= equal_1391;
      equal_1393_s4_q <= equal_1393;
      equal_1395_s4_q <= equal_1395;
      equal_1397_s4_q <= equal_1397;
      equal_1399_s4_q <= equal_1399;
      less_1407_s4_q <= less_1407;
      or_1411_s4_q <= or_1411;
      equal_1431_s4_q <= (registration_fresh_q & select_1429) == 4'h0;
      and_1441_s4_q <= not_1335_s3_q & and_1425;
      or_1445_s4_q <= or_1445;
      or_1448_s4_q <= or_1448;
      or_1451_s4_q <= or_1451;
      not_1453_s4_q <= not_1453;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1475_s4_q <= and_1475;
      and_1480_s4_q <= not_1335_s3_q & and_1461;
      and_1507_s4_q <= and_1507_s3_q;
      and_1514_s4_q <= and_1514;
      less_1515_s4_q <= less_1515;
      sum_1523_s4_q <= sum_1523;
      equal_1537_s4_q <= t[4:1] == 4'h0;
      or_1542_s4_q <= or_1542;
      or_1545_s4_q <= select_1539[7] | (~({select_1539[6], select_1539[3:2]} == 3'h0));
      or_1548_s4_q <= select_1539[7] | (~(select_1539[6:4] == 3'h0));
      not_1573_s4_q <= ~({sum_1571, around[0]} < {2'h0, t});
      less_1587_s4_q <= {1'b0, around[4:1]} < n;
      and_1598_s4_q <= and_1598_s3_q;
      sum_1736_s4_q <= ({1'b0, sum_1728} + {2'h0, sum_1731}) + {2'h0, sum_1735};
      equal_1743_s4_q <= equal_1743_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_1981_s4_q <= and_1981;
      and_1985_s4_q <= not_1335_s3_q & and_1984;
      not_2019_s4_q <= ~({sum_2017, e[0]} < {2'h0, t});
      and_2047_s4_q <= not_1335_s3_q & (so_s3_q & and_2045);
      equal_2089_s4_q <= equal_2089;
      and_2117_s4_q <= not_1335_s3_q & (so_s3_q & (half_ends & equal_2114));
      and_2119_s4_q <= and_2119_s3_q;
      residual_s4_q <= residual;
      equal_2210_s4_q <= (registration_fresh_q & select_2208) == 4'h0;
      equal_2371_s4_q <= equal_2371;
      and_2578_s4_q <= and_1598_s3_q & (sum_1523 == sum_1505);
      equal_2639_s4_q <= (registration_fresh_q & select_2637) == 4'h0;
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
  // hls/stages/census.hpp:201
  logic [12:0] sum_478;
  assign sum_478 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_480;
  assign sum_480 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_478});
  // hls/stages/census.hpp:223
  logic less_481;
  assign less_481 = 9'h4 < sum_480[13:5];
  logic and_482;
  assign and_482 = and_432_s4_q & less_481;
  // hls/stages/registration.hpp:250
  logic equal_1433;
  assign equal_1433 = sum_1385_s4_q == 2'h0;
  // hls/stages/registration.hpp:248
  logic [6:0] down;
  assign down = sum_1385_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:250
  logic [13:0] select_1435;
  assign select_1435 = equal_1433 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1436;
  assign sum_1436 = (equal_1431_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1435[13]}}, select_1435};
  // hls/stages/registration.hpp:249
  logic [6:0] up;
  assign up = sum_1385_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:251
  logic [6:0] select_1439;
  assign select_1439 = equal_1433 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1440;
  assign sum_1440 = (equal_1431_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1439[6]}}, select_1439};
  // hls/stages/agreement.hpp:658
  logic [5:0] select_1465;
  assign select_1465 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:659
  logic [5:0] sum_1466;
  assign sum_1466 = {5'h0, textured_s4_q} + select_1465;
  // hls/stages/agreement.hpp:791
  logic [9:0] sum_1468;
  assign sum_1468 = {4'h0, sum_1466} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:658
  logic [5:0] select_1470;
  assign select_1470 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:659
  logic [5:0] sum_1471;
  assign sum_1471 = {5'h0, explained_s4_q} + select_1470;
  // hls/stages/agreement.hpp:792
  logic [9:0] sum_1473;
  assign sum_1473 = {4'h0, sum_1471} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:658
  logic [5:0] select_1476;
  assign select_1476 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:660
  logic [5:0] sum_1477;
  assign sum_1477 = {5'h0, and_1475_s4_q} + select_1476;
  // hls/stages/agreement.hpp:793
  logic [9:0] sum_1479;
  assign sum_1479 = {4'h0, sum_1477} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:831
  logic not_1549;
  assign not_1549 = ~region_row_s4_q[2];
  logic [2:0] select_1550;
  assign select_1550 = region_row_s4_q[1] ? {1'b0, not_1549, 1'b0} : {region_row_s4_q[2], 1'b0, not_1549};
  logic [5:0] select_1551;
  assign select_1551 = region_row_s4_q[0] ? {select_1550[2], 1'b0, select_1550[1], 1'b0, select_1550[0], 1'b0} : {1'b0, select_1550[2], 1'b0, select_1550[1], 1'b0, select_1550[0]};
  logic [11:0] select_1552;
  assign select_1552 = or_1548_s4_q ? {select_1551[5], 1'b0, select_1551[4], 1'b0, select_1551[3], 1'b0, select_1551[2], 1'b0, select_1551[1], 1'b0, select_1551[0], 1'b0} : {1'b0, select_1551[5], 1'b0, select_1551[4], 1'b0, select_1551[3], 1'b0, select_1551[2], 1'b0, select_1551[1], 1'b0, select_1551[0]};
  logic [23:0] select_1553;
  assign select_1553 = or_1545_s4_q ? {select_1552[11], 1'b0, select_1552[10], 1'b0, select_1552[9], 1'b0, select_1552[8], 1'b0, select_1552[7], 1'b0, select_1552[6], 1'b0, select_1552[5], 1'b0, select_1552[4], 1'b0, select_1552[3], 1'b0, select_1552[2], 1'b0, select_1552[1], 1'b0, select_1552[0], 1'b0} : {1'b0, select_1552[11], 1'b0, select_1552[10], 1'b0, select_1552[9], 1'b0, select_1552[8], 1'b0, select_1552[7], 1'b0, select_1552[6], 1'b0, select_1552[5], 1'b0, select_1552[4], 1'b0, select_1552[3], 1'b0, select_1552[2], 1'b0, select_1552[1], 1'b0, select_1552[0]};
  logic [47:0] select_1554;
  assign select_1554 = or_1542_s4_q ? {select_1553[23], 1'b0, select_1553[22], 1'b0, select_1553[21], 1'b0, select_1553[20], 1'b0, select_1553[19], 1'b0, select_1553[18], 1'b0, select_1553[17], 1'b0, select_1553[16], 1'b0, select_1553[15], 1'b0, select_1553[14], 1'b0, select_1553[13], 1'b0, select_1553[12], 1'b0, select_1553[11], 1'b0, select_1553[10], 1'b0, select_1553[9], 1'b0, select_1553[8], 1'b0, select_1553[7], 1'b0, select_1553[6], 1'b0, select_1553[5], 1'b0, select_1553[4], 1'b0, select_1553[3], 1'b0, select_1553[2], 1'b0, select_1553[1], 1'b0, select_1553[0], 1'b0} : {1'b0, select_1553[23], 1'b0, select_1553[22], 1'b0, select_1553[21], 1'b0, select_1553[20], 1'b0, select_1553[19], 1'b0, select_1553[18], 1'b0, select_1553[17], 1'b0, select_1553[16], 1'b0, select_1553[15], 1'b0, select_1553[14], 1'b0, select_1553[13], 1'b0, select_1553[12], 1'b0, select_1553[11], 1'b0, select_1553[10], 1'b0, select_1553[9], 1'b0, select_1553[8], 1'b0, select_1553[7], 1'b0, select_1553[6], 1'b0, select_1553[5], 1'b0, select_1553[4], 1'b0, select_1553[3], 1'b0, select_1553[2], 1'b0, select_1553[1], 1'b0, select_1553[0]};
  // hls/stages/agreement.hpp:764
  logic and_1558;
  assign and_1558 = good_known_q & (~((good_q & select_1554) == 48'h0));
  // hls/stages/agreement.hpp:833
  logic is_seen;
  assign is_seen = equal_1537_s4_q ? and_1558 : not_1573_s4_q;
  // hls/stages/agreement.hpp:842
  logic and_1588;
  assign and_1588 = is_seen & less_1587_s4_q;
  // hls/stages/agreement.hpp:215
  logic [8:0] select_1627;
  assign select_1627 = sample_pair_whole_s4_q ? (and_365_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_1629;
  assign select_1629 = sample_pair_whole_s4_q ? (and_365_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_1631;
  assign select_1631 = sample_pair_whole_s4_q ? (and_365_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_1633;
  assign select_1633 = sample_pair_whole_s4_q ? (and_365_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1638;
  assign sum_1638 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1639;
  assign difference_1639 = {1'b0, sum_1638[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1640;
  assign xor_1640 = {difference_1639[8:0], sum_1638[0]} ^ {10{difference_1639[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_1639[9]} + {1'b0, xor_1640};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_370_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_1645;
  assign select_1645 = sample_pair_whole_s4_q ? (and_365_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_1646;
  assign sum_1646 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1647;
  assign difference_1647 = {1'b0, sum_1646[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1648;
  assign xor_1648 = {difference_1647[8:0], sum_1646[0]} ^ {10{difference_1647[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1647[9]} + {1'b0, xor_1648};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_370_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_1653;
  assign select_1653 = sample_pair_whole_s4_q ? (and_365_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:365
  logic [11:0] select_1738;
  assign select_1738 = and_367_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1739;
  assign select_1739 = and_367_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_1740;
  assign select_1740 = and_367_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_1741;
  assign select_1741 = and_367_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_1744;
  assign sum_1744 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1736_s4_q};
  logic [13:0] sum_1746;
  assign sum_1746 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1744});
  // hls/stages/census.hpp:225
  logic and_1748;
  assign and_1748 = and_457_s4_q & (9'h4 < sum_1746[13:5]);
  // hls/stages/census.hpp:226
  logic and_1749;
  assign and_1749 = and_457_s4_q & less_481;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1750;
  assign sum_1750 = census_left_misses_q + {{17{and_1749}}, and_1748, 1'b0, and_1748};
  // hls/stages/agreement.hpp:365
  logic [19:0] select_1752;
  assign select_1752 = and_367_s4_q ? (equal_1743_s4_q ? 20'h0 : sum_1750) : census_left_misses_q;
  // hls/stages/agreement.hpp:215
  logic [27:0] select_1757;
  assign select_1757 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/census.hpp:275
  logic and_1762;
  assign and_1762 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:311
  logic and_1768;
  assign and_1768 = and_1762 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_1757[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1770;
  assign select_1770 = and_1768 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1772;
  assign select_1772 = equal_1743_s4_q ? {11'h0, select_1770} : (sharpness_sums_detail_0_q + {11'h0, select_1770});
  // hls/stages/agreement.hpp:311
  logic and_1779;
  assign and_1779 = and_1762 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_1757[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_1781;
  assign select_1781 = and_1779 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1783;
  assign select_1783 = equal_1743_s4_q ? {11'h0, select_1781} : (sharpness_sums_detail_1_q + {11'h0, select_1781});
  logic [8:0] select_1786;
  assign select_1786 = and_1768 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1787;
  assign sum_1787 = (equal_1743_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1786};
  logic [8:0] select_1790;
  assign select_1790 = and_1779 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1791;
  assign sum_1791 = (equal_1743_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1790};
  // hls/stages/agreement.hpp:150
  logic equal_1793;
  assign equal_1793 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:289
  logic less_1794;
  assign less_1794 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:328
  logic less_1795;
  assign less_1795 = x_s4_q[4:0] < 5'h3;
  logic not_1796;
  assign not_1796 = ~x_s4_q[1];
  logic [2:0] select_1797;
  assign select_1797 = x_s4_q[0] ? {1'b0, not_1796, 1'b0} : {x_s4_q[1], 1'b0, not_1796};
  logic [5:0] select_1798;
  assign select_1798 = slot_s4_q[2] ? {select_1797[2], 1'b0, select_1797[1], 1'b0, select_1797[0], 1'b0} : {1'b0, select_1797[2], 1'b0, select_1797[1], 1'b0, select_1797[0]};
  logic [11:0] select_1799;
  assign select_1799 = slot_s4_q[1] ? {select_1798[5], 1'b0, select_1798[4], 1'b0, select_1798[3], 1'b0, select_1798[2], 1'b0, select_1798[1], 1'b0, select_1798[0], 1'b0} : {1'b0, select_1798[5], 1'b0, select_1798[4], 1'b0, select_1798[3], 1'b0, select_1798[2], 1'b0, select_1798[1], 1'b0, select_1798[0]};
  logic [23:0] select_1800;
  assign select_1800 = slot_s4_q[0] ? {select_1799[11], 1'b0, select_1799[10], 1'b0, select_1799[9], 1'b0, select_1799[8], 1'b0, select_1799[7], 1'b0, select_1799[6], 1'b0, select_1799[5], 1'b0, select_1799[4], 1'b0, select_1799[3], 1'b0, select_1799[2], 1'b0, select_1799[1], 1'b0, select_1799[0], 1'b0} : {1'b0, select_1799[11], 1'b0, select_1799[10], 1'b0, select_1799[9], 1'b0, select_1799[8], 1'b0, select_1799[7], 1'b0, select_1799[6], 1'b0, select_1799[5], 1'b0, select_1799[4], 1'b0, select_1799[3], 1'b0, select_1799[2], 1'b0, select_1799[1], 1'b0, select_1799[0]};
  // hls/stages/census.hpp:291
  logic and_1804;
  assign and_1804 = less_1795 & (~((sharpness_sums_contrast_1_q & select_1800) == 24'h0));
  // hls/stages/census.hpp:296
  logic [17:0] select_1806;
  assign select_1806 = (less_1794 & and_1804) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1806};
  // hls/stages/agreement.hpp:154
  logic [17:0] select_1809;
  assign select_1809 = equal_1793 ? (less_1794 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:291
  logic and_1814;
  assign and_1814 = less_1795 & (~((sharpness_sums_contrast_0_q & select_1800) == 24'h0));
  // hls/stages/census.hpp:296
  logic [17:0] select_1816;
  assign select_1816 = (less_1794 & and_1814) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1816};
  // hls/stages/agreement.hpp:154
  logic [17:0] select_1819;
  assign select_1819 = equal_1793 ? (less_1794 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_1821;
  assign select_1821 = equal_1793 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_1823;
  assign select_1823 = equal_1793 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_1825;
  assign select_1825 = equal_1793 ? {sharpness_comparing_contrast_0_q[0], and_1814} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_1827;
  assign select_1827 = equal_1793 ? {sharpness_comparing_contrast_1_q[0], and_1804} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:302
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:154
  logic select_1832;
  assign select_1832 = drew_q ? (equal_1793 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:302
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:154
  logic select_1836;
  assign select_1836 = drew_q ? (equal_1793 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:288
  logic equal_1837;
  assign equal_1837 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:304
  logic xor_1838;
  assign xor_1838 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_1841;
  assign select_1841 = (equal_1837 | xor_1838) ? (five_times[0] & xor_1838) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:154
  logic select_1843;
  assign select_1843 = drew_q ? (equal_1793 ? select_1841 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:304
  logic xor_1844;
  assign xor_1844 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_1847;
  assign select_1847 = (equal_1837 | xor_1844) ? (five_times_2[0] & xor_1844) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:154
  logic select_1849;
  assign select_1849 = drew_q ? (equal_1793 ? select_1847 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:305
  logic xor_1850;
  assign xor_1850 = sharpness_comparing_contrast_0_q[1] ^ and_1804;
  logic select_1853;
  assign select_1853 = (equal_1837 | xor_1850) ? (and_1804 & xor_1850) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:154
  logic select_1855;
  assign select_1855 = drew_q ? (equal_1793 ? select_1853 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:305
  logic xor_1856;
  assign xor_1856 = sharpness_comparing_contrast_1_q[1] ^ and_1814;
  logic select_1859;
  assign select_1859 = (equal_1837 | xor_1856) ? (and_1814 & xor_1856) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:154
  logic select_1861;
  assign select_1861 = drew_q ? (equal_1793 ? select_1859 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:681
  logic [13:0] select_1987;
  assign select_1987 = and_1981_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1985_s4_q});
  // hls/stages/agreement.hpp:211
  logic and_1990;
  assign and_1990 = not_1335_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_1995;
  assign and_1995 = not_1335_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2000;
  assign and_2000 = not_1335_s4_q & (drew_q & (ends_cell_s4_q & and_1475_s4_q));
  // hls/stages/agreement.hpp:835
  logic not_2004;
  assign not_2004 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:836
  logic not_2021;
  assign not_2021 = ~(equal_1537_s4_q ? and_1558 : not_2019_s4_q);
  // hls/stages/agreement.hpp:211
  logic and_2024;
  assign and_2024 = ends_cell_s4_q & (not_2004 & (centres_values_1_textured_s4_q & not_2021));
  logic and_2026;
  assign and_2026 = not_1335_s4_q & (drew_q & and_2024);
  // hls/stages/agreement.hpp:861
  logic less_2029;
  assign less_2029 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2030;
  assign select_2030 = less_2029 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2033;
  assign select_2033 = less_2029 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:862
  logic [10:0] sum_2034;
  assign sum_2034 = {1'b0, select_2033} + {3'h0, select_2033[9:2]};
  logic and_2036;
  assign and_2036 = (~(select_2030[9:4] == 6'h0)) & ({sum_2034, select_2033[1:0]} < {3'h0, select_2030});
  // hls/stages/agreement.hpp:871
  logic [9:0] select_2039;
  assign select_2039 = x_s4_q[6] ? (equal_1379_s4_q ? 10'h0 : (and_2036 ? select_2030 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:211
  logic [9:0] select_2040;
  assign select_2040 = equal_1334_s4_q ? select_2039 : 10'h0;
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2042;
  assign select_2042 = and_1981_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2040});
  logic [13:0] select_2049;
  assign select_2049 = and_1981_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2047_s4_q});
  // hls/stages/agreement.hpp:840
  logic and_2051;
  assign and_2051 = not_2004 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:211
  logic and_2054;
  assign and_2054 = not_1335_s4_q & (drew_q & (ends_cell_s4_q & and_2051));
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2056;
  assign select_2056 = and_1981_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2054});
  // hls/stages/agreement.hpp:840
  logic and_2058;
  assign and_2058 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2021);
  // hls/stages/agreement.hpp:211
  logic and_2062;
  assign and_2062 = not_1335_s4_q & (drew_q & (ends_cell_s4_q & (not_2004 & and_2058)));
  // hls/stages/agreement.hpp:681
  logic [13:0] select_2064;
  assign select_2064 = and_1981_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2062});
  // hls/stages/registration.hpp:106
  logic [7:0] select_2134;
  assign select_2134 = equal_2089_s4_q ? (and_2119_s4_q ? residual_s4_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2136;
  assign select_2136 = equal_1334_s4_q ? 8'h0 : (drew_q ? select_2134 : 8'h0);
  // hls/stages/registration.hpp:126
  logic [13:0] select_2138;
  assign select_2138 = and_2117_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2136[7]}}, select_2136});
  // hls/stages/agreement.hpp:211
  logic and_2141;
  assign and_2141 = not_1335_s4_q & (drew_q & (and_2119_s4_q & equal_2089_s4_q));
  // hls/stages/registration.hpp:126
  logic [5:0] select_2143;
  assign select_2143 = and_2117_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2141});
  // hls/stages/registration.hpp:106
  logic and_2145;
  assign and_2145 = and_2119_s4_q & ($signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2147;
  assign select_2147 = drew_q ? (equal_2089_s4_q ? {and_2145, and_2119_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2148;
  assign select_2148 = equal_1334_s4_q ? 2'h0 : select_2147;
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2149;
  assign sum_2149 = registration_half_votes_down_q + {{5{select_2148[1]}}, select_2148};
  // hls/stages/registration.hpp:193
  logic [12:0] difference_2151;
  assign difference_2151 = 13'h0 - {residual_s4_q[11], residual_s4_q};
  // hls/stages/registration.hpp:106
  logic and_2153;
  assign and_2153 = and_2119_s4_q & ($signed(difference_2151) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2155;
  assign select_2155 = drew_q ? (equal_2089_s4_q ? {and_2153, and_2119_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2156;
  assign select_2156 = equal_1334_s4_q ? 2'h0 : select_2155;
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2157;
  assign sum_2157 = registration_half_votes_up_q + {{5{select_2156[1]}}, select_2156};
  // hls/stages/registration.hpp:193
  logic less_2159;
  assign less_2159 = $signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2160;
  assign and_2160 = and_2119_s4_q & less_2159;
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2162;
  assign select_2162 = drew_q ? (equal_2089_s4_q ? {and_2160, and_2119_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2163;
  assign select_2163 = equal_1334_s4_q ? 2'h0 : select_2162;
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2164;
  assign sum_2164 = registration_half_half_votes_down_q + {{5{select_2163[1]}}, select_2163};
  // hls/stages/registration.hpp:193
  logic less_2166;
  assign less_2166 = $signed(difference_2151) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2167;
  assign and_2167 = and_2119_s4_q & less_2166;
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2169;
  assign select_2169 = drew_q ? (equal_2089_s4_q ? {and_2167, and_2119_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2170;
  assign select_2170 = equal_1334_s4_q ? 2'h0 : select_2169;
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2171;
  assign sum_2171 = registration_half_half_votes_up_q + {{5{select_2170[1]}}, select_2170};
  // hls/stages/agreement.hpp:211
  logic and_2205;
  assign and_2205 = equal_1334_s4_q & (x_s4_q[6] & (not_1453_s4_q & less_1407_s4_q));
  // hls/stages/agreement.hpp:861
  logic [11:0] select_2212;
  assign select_2212 = or_1411_s4_q ? 12'h0 : (equal_2210_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:871
  logic [11:0] select_2215;
  assign select_2215 = x_s4_q[6] ? (equal_1379_s4_q ? 12'h0 : (less_1407_s4_q ? select_2212 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:211
  logic [11:0] select_2216;
  assign select_2216 = equal_1334_s4_q ? select_2215 : 12'h0;
  // hls/stages/registration.hpp:145
  logic and_2217;
  assign and_2217 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:871
  logic and_2220;
  assign and_2220 = not_1453_s4_q & (less_1407_s4_q & ({and_2217, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:211
  logic and_2222;
  assign and_2222 = equal_1334_s4_q & (x_s4_q[6] & and_2220);
  // hls/stages/registration.hpp:237
  logic [13:0] sum_2224;
  assign sum_2224 = {{2{select_2216[11]}}, select_2216} + (and_2222 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:861
  logic [11:0] select_2227;
  assign select_2227 = or_1411_s4_q ? 12'h0 : (equal_2210_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:871
  logic [11:0] select_2230;
  assign select_2230 = x_s4_q[6] ? (equal_1379_s4_q ? 12'h0 : (less_1407_s4_q ? select_2227 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:211
  logic [11:0] select_2231;
  assign select_2231 = equal_1334_s4_q ? select_2230 : 12'h0;
  // hls/stages/registration.hpp:238
  logic [13:0] sum_2233;
  assign sum_2233 = {{2{select_2231[11]}}, select_2231} + (and_2222 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:142
  logic not_2235;
  assign not_2235 = ~all_s4_q;
  // hls/stages/agreement.hpp:871
  logic and_2238;
  assign and_2238 = not_1453_s4_q & (less_1407_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2235, 1'b0}));
  // hls/stages/agreement.hpp:211
  logic and_2244;
  assign and_2244 = equal_1334_s4_q & (x_s4_q[6] & (not_1453_s4_q & (less_1407_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:231
  logic not_2245;
  assign not_2245 = ~and_2244;
  logic less_2246;
  assign less_2246 = $signed({9'h1, {2{not_2245}}, and_2244}) < $signed(registration_up_q[13:2]);
  logic select_2247;
  assign select_2247 = (equal_1334_s4_q & (x_s4_q[6] & and_2238)) ? less_2246 : registration_enough_q;
  // hls/stages/agreement.hpp:871
  logic and_2251;
  assign and_2251 = x_s4_q[6] & (not_1453_s4_q & (less_1407_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:211
  logic and_2252;
  assign and_2252 = equal_1334_s4_q & and_2251;
  // hls/stages/registration.hpp:227
  logic less_2253;
  assign less_2253 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2255;
  assign less_2255 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:871
  logic and_2260;
  assign and_2260 = x_s4_q[6] & (not_1453_s4_q & (less_1407_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:211
  logic and_2261;
  assign and_2261 = equal_1334_s4_q & and_2260;
  // hls/stages/agreement.hpp:871
  logic and_2268;
  assign and_2268 = x_s4_q[6] & (not_1453_s4_q & (less_1407_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:149
  logic equal_2271;
  assign equal_2271 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:871
  logic and_2274;
  assign and_2274 = not_1453_s4_q & (less_1407_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2271));
  // hls/stages/registration.hpp:229
  logic and_2278;
  assign and_2278 = (equal_1334_s4_q & (x_s4_q[6] & and_2274)) & (less_2255 | less_2253);
  // hls/stages/agreement.hpp:871
  logic and_2283;
  assign and_2283 = not_1453_s4_q & (less_1407_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2271)));
  // hls/stages/registration.hpp:229
  logic and_2286;
  assign and_2286 = registration_votes_up_q & registration_other_down_q;
  logic select_2288;
  assign select_2288 = registration_votes_down_q ? (registration_other_up_q | and_2286) : and_2286;
  // hls/stages/registration.hpp:130
  logic and_2290;
  assign and_2290 = (equal_1334_s4_q & (x_s4_q[6] & and_2283)) & (registration_other_enough_q & select_2288);
  // hls/stages/registration.hpp:230
  logic or_2293;
  assign or_2293 = registration_moved_q | (registration_enough_q & (and_2278 | and_2290));
  // hls/stages/agreement.hpp:908
  logic or_2351;
  assign or_2351 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:930
  logic equal_2353;
  assign equal_2353 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:936
  logic equal_2354;
  assign equal_2354 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:939
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:940
  logic select_2360;
  assign select_2360 = (equal_2353 & equal_2354) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:864
  logic [10:0] sum_2363;
  assign sum_2363 = {1'b0, select_2033} + {2'h0, select_2033[9:1]};
  logic select_2366;
  assign select_2366 = (select_2030[9:3] == 7'h0) ? ((~or_2351) & (~select_2360)) : (~({sum_2363, select_2033[0]} < {2'h0, select_2030}));
  // hls/stages/agreement.hpp:871
  logic [47:0] select_2368;
  assign select_2368 = x_s4_q[6] ? (equal_1379_s4_q ? good_q : {select_2366, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:211
  logic select_2373;
  assign select_2373 = equal_1334_s4_q ? ((x_s4_q[6] & good_known_q) | equal_2371_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:930
  logic equal_2374;
  assign equal_2374 = x_s4_q[6:3] == 4'ha;
  logic equal_2376;
  assign equal_2376 = x_s4_q[6:3] == 4'h9;
  logic equal_2377;
  assign equal_2377 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:855
  logic [13:0] select_2379;
  assign select_2379 = equal_2376 ? counts_skin_unproven_q : (equal_2377 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2374 ? counts_nearer_q : select_2379;
  // hls/stages/agreement.hpp:935
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:943
  logic select_2382;
  assign select_2382 = (equal_2374 & equal_2354) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:872
  logic not_2383;
  assign not_2383 = ~hidden_for_q[7];
  logic [7:0] select_2385;
  assign select_2385 = select_2382 ? (hidden_for_q + {7'h0, not_2383}) : 8'h0;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2387;
  assign select_2387 = equal_1334_s4_q ? (equal_2371_s4_q ? select_2385 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:943
  logic [13:0] select_2388;
  assign select_2388 = equal_2354 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:855
  logic [7:0] select_2390;
  assign select_2390 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2392;
  assign select_2392 = equal_2377 ? cfg_unproven_skin_limit_i : (equal_2353 ? cfg_unproven_limit_i : select_2390);
  logic [7:0] limit;
  assign limit = equal_2374 ? cfg_regions_limit_i : (equal_2376 ? cfg_hidden_limit_i : select_2392);
  // hls/stages/agreement.hpp:943
  logic not_2395;
  assign not_2395 = ~x_s4_q[2];
  logic [3:0] select_2396;
  assign select_2396 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_2395, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_2395};
  logic [7:0] select_2397;
  assign select_2397 = x_s4_q[0] ? {select_2396[3], 1'b0, select_2396[2], 1'b0, select_2396[1], 1'b0, select_2396[0], 1'b0} : {1'b0, select_2396[3], 1'b0, select_2396[2], 1'b0, select_2396[1], 1'b0, select_2396[0]};
  // hls/stages/agreement.hpp:855
  logic [13:0] select_2401;
  assign select_2401 = equal_2376 ? counts_skin_supervised_q : (equal_2377 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2374 ? counts_textured_q : select_2401;
  // hls/stages/agreement.hpp:943
  logic [13:0] select_2403;
  assign select_2403 = ((limit & select_2397) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2388} + {1'b0, select_2403};
  // hls/stages/agreement.hpp:211
  logic select_2408;
  assign select_2408 = equal_1334_s4_q ? (equal_2354 ? sum_3[0] : (product_rest_q | sum_3[0])) : product_rest_q;
  // hls/stages/agreement.hpp:941
  logic and_2413;
  assign and_2413 = too_much_q & (~(equal_2377 & equal_2354));
  // hls/stages/agreement.hpp:942
  logic select_2418;
  assign select_2418 = (over[14] & equal_2354) ? (and_2413 | ((equal_2377 | equal_2376) | (x_s4_q[6:3] == 4'hf))) : and_2413;
  // hls/stages/agreement.hpp:983
  logic select_2526;
  assign select_2526 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:220
  logic select_2528;
  assign select_2528 = left_first_s4_q ? done_s4_q : (and_1507_s4_q ? select_2526 : proven_q);
  // hls/stages/agreement.hpp:1012
  logic [1:0] select_2579;
  assign select_2579 = and_2578_s4_q ? {and_1588, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1013
  logic and_2580;
  assign and_2580 = select_2526 & less_2556;
  // hls/stages/agreement.hpp:220
  logic select_2583;
  assign select_2583 = and_1514_s4_q ? (less_1515_s4_q ? (select_2579[0] & and_2580) : seen_q) : seen_q;
  logic select_2585;
  assign select_2585 = left_first_s4_q ? select_2583 : (and_1507_s4_q ? select_2583 : seen_q);
  logic select_2586;
  assign select_2586 = and_1507_s4_q ? select_2585 : seen_q;
  logic select_2589;
  assign select_2589 = and_1514_s4_q ? (less_1515_s4_q ? (select_2579[1] & and_2580) : nearer_q) : nearer_q;
  logic select_2591;
  assign select_2591 = left_first_s4_q ? select_2589 : (and_1507_s4_q ? select_2589 : nearer_q);
  logic select_2592;
  assign select_2592 = and_1507_s4_q ? select_2591 : nearer_q;
  // hls/stages/agreement.hpp:211
  logic and_2599;
  assign and_2599 = equal_1334_s4_q & (equal_2371_s4_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:952
  logic not_2604;
  assign not_2604 = ~(or_2351 | not_2593);
  // hls/stages/agreement.hpp:211
  logic and_2608;
  assign and_2608 = equal_1334_s4_q & (equal_2371_s4_q & (not_2604 & (select_2360 | select_2418)));
  logic and_2611;
  assign and_2611 = equal_1334_s4_q & (equal_2371_s4_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:874
  logic or_2614;
  assign or_2614 = select_1843 | (select_1855 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:211
  logic and_2621;
  assign and_2621 = equal_1334_s4_q & (equal_2371_s4_q & (not_2604 & (select_1849 | select_1861)));
  // hls/stages/agreement.hpp:874
  logic and_2626;
  assign and_2626 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2385 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:211
  logic and_2633;
  assign and_2633 = equal_1334_s4_q & (x_s4_q[6] & (not_1453_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:869
  logic [31:0] select_2641;
  assign select_2641 = equal_1399_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_2639_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_2642;
  assign select_2642 = equal_1397_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_2641;
  logic [31:0] select_2643;
  assign select_2643 = equal_1395_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_2642;
  logic [31:0] select_2644;
  assign select_2644 = equal_1393_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_2643;
  logic [31:0] select_2645;
  assign select_2645 = equal_1391_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_2644;
  logic [31:0] select_2646;
  assign select_2646 = equal_1389_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_2645;
  logic [31:0] select_2647;
  assign select_2647 = equal_1387_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_2646;
  // hls/stages/agreement.hpp:867
  logic [9:0] select_2648;
  assign select_2648 = less_2029 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:871
  logic [31:0] select_2649;
  assign select_2649 = equal_1379_s4_q ? select_2647 : {2'h0, select_2648, select_2033, select_2030};

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
  assign registration_sums_waddr = {sum_1385_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1441_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1440, sum_1436};
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
  assign regions_waddr = {region_row_s4_q, or_1451_s4_q, or_1448_s4_q, or_1445_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1480_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1479, sum_1473, sum_1468};
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
  assign map_waddr = sum_1523_s4_q;
  logic map_we;
  assign map_we = s4_en & and_1598_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1588, is_seen};
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
      census_left_misses_q <= select_1752;
      sharpness_sums_detail_0_q <= and_367_s4_q ? select_1772 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_367_s4_q ? select_1783 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_367_s4_q ? sum_1787 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_367_s4_q ? sum_1791 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_1809 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_1819 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_1821 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_1823 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_1825 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_1827 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_1832;
      sharpness_comparing_carry_1_q <= select_1836;
      sharpness_comparing_less_detail_0_q <= select_1843;
      sharpness_comparing_less_detail_1_q <= select_1849;
      sharpness_comparing_less_contrast_0_q <= select_1855;
      sharpness_comparing_less_contrast_1_q <= select_1861;
      counts_supervised_q <= select_1987;
      counts_textured_q <= and_1981_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1990});
      counts_explained_q <= and_1981_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_1995});
      counts_nearer_q <= and_1981_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2000});
      counts_unproven_q <= and_1981_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2026});
      counts_regions_bad_q <= select_2042;
      counts_skin_supervised_q <= select_2049;
      counts_skin_textured_q <= select_2056;
      counts_skin_unproven_q <= select_2064;
      registration_half_across_q <= select_2138;
      registration_half_measured_q <= select_2143;
      registration_half_votes_down_q <= and_2117_s4_q ? 7'h0 : sum_2149;
      registration_half_votes_up_q <= and_2117_s4_q ? 7'h0 : sum_2157;
      registration_half_half_votes_down_q <= and_2117_s4_q ? 7'h0 : sum_2164;
      registration_half_half_votes_up_q <= and_2117_s4_q ? 7'h0 : sum_2171;
      registration_down_q <= and_2205 ? sum_2224 : registration_down_q;
      registration_up_q <= and_2205 ? sum_2233 : registration_up_q;
      registration_enough_q <= select_2247;
      registration_votes_down_q <= and_2252 ? less_2253 : registration_votes_down_q;
      registration_votes_up_q <= and_2252 ? less_2255 : registration_votes_up_q;
      registration_other_enough_q <= and_2261 ? select_2247 : registration_other_enough_q;
      registration_other_down_q <= and_2261 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2261 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1334_s4_q & and_2268)) & or_2293;
      segment_textured_q <= select_1465 + {5'h0, and_1990};
      segment_explained_q <= select_1470 + {5'h0, and_1995};
      segment_nearer_q <= select_1476 + {5'h0, and_2000};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1334_s4_q ? select_2368 : good_q;
      good_known_q <= select_2373;
      hidden_for_q <= select_2387;
      product_q <= equal_1334_s4_q ? sum_3[14:1] : product_q;
      product_rest_q <= select_2408;
      disagree_q <= equal_1334_s4_q ? select_2360 : disagree_q;
      too_much_q <= equal_1334_s4_q ? select_2418 : too_much_q;
      hides_q <= equal_1334_s4_q ? select_2382 : hides_q;
      proven_q <= and_1507_s4_q ? select_2528 : proven_q;
      seen_q <= select_2586;
      nearer_q <= select_2592;
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
      averager_quarter_1_0_q <= select_1627;
      averager_quarter_1_1_q <= select_1629;
      averager_quarter_2_0_q <= select_1631;
      averager_quarter_2_1_q <= select_1633;
      averager_detail_0_q <= select_1645;
      averager_detail_1_q <= select_1653;
      census_changes_values_0_left_q <= and_367_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_367_s4_q ? sum_1736_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1738;
      census_changes_values_1_right_q <= select_1739;
      census_changes_values_2_left_q <= select_1740;
      census_changes_values_2_right_q <= select_1741;
      sharpness_last_mask_q <= and_367_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_367_s4_q ? select_1757[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_367_s4_q ? select_1757[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_2530_s5_q;
  logic or_2594_s5_q;
  logic and_2595_s5_q;
  logic and_2599_s5_q;
  logic and_2602_s5_q;
  logic and_2608_s5_q;
  logic and_2611_s5_q;
  logic and_2617_s5_q;
  logic and_2621_s5_q;
  logic and_2629_s5_q;
  logic and_2633_s5_q;
  logic [5:0] select_2635_s5_q;
  logic [31:0] select_2651_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_2530_s5_q <= said_q;
      or_2594_s5_q <= not_2593 | select_2586;
      and_2595_s5_q <= cfg_prove_i & select_2592;
      and_2599_s5_q <= and_2599;
      and_2602_s5_q <= equal_1334_s4_q & (equal_2371_s4_q & (cfg_prove_i & or_2351));
      and_2608_s5_q <= and_2608;
      and_2611_s5_q <= and_2611;
      and_2617_s5_q <= equal_1334_s4_q & (equal_2371_s4_q & (not_2604 & or_2614));
      and_2621_s5_q <= and_2621;
      and_2629_s5_q <= equal_1334_s4_q & (equal_2371_s4_q & (cfg_prove_i & and_2626));
      and_2633_s5_q <= and_2633;
      select_2635_s5_q <= equal_1334_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_2651_s5_q <= equal_1334_s4_q ? (x_s4_q[6] ? select_2649 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_2594_s5_q;
  assign marks_nearer_o = and_2595_s5_q;
  assign verdict_valid_o = and_2530_s5_q;
  assign verdict_unproven_yet_o = and_2599_s5_q;
  assign verdict_untextured_o = and_2602_s5_q;
  assign verdict_disagree_o = and_2608_s5_q;
  assign verdict_moved_o = and_2611_s5_q;
  assign verdict_unsharp_left_o = and_2617_s5_q;
  assign verdict_unsharp_right_o = and_2621_s5_q;
  assign verdict_hidden_o = and_2629_s5_q;
  assign frame_valid_o = and_2633_s5_q;
  assign frame_index_o = select_2635_s5_q;
  assign frame_word_o = select_2651_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_2104[0], sum_2100[0], sum_2086[0], detail_4[1:0], detail_3[1:0], sum_1746[4:0], sum_480[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
