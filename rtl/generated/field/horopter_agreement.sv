// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2857 bits, pipeline 889 bits, memories 58067 bits.
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
  input  logic [5:0] cfg_patch_limit_i,
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
  logic [5:0] sum_2343;
  assign sum_2343 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3334;
  assign difference_3334 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_3554;
  assign difference_3554 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3787;
  assign less_3787 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3788;
  assign sum_3788 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3789;
  assign select_3789 = less_3787 ? {sum_3788, cfg_height_i[5:3]} : 8'h0;
  logic not_3824;
  assign not_3824 = ~cfg_prove_i;

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
  logic [2:0] select_459;
  assign select_459 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_461;
  assign select_461 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_464;
  assign select_464 = ({select_461, select_459} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_465;
  assign select_465 = select_459[0] ? averager_place_q : select_464;
  // hls/stages/census.hpp:41
  logic or_466;
  assign or_466 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_469;
  assign and_469 = (select_459[0] & or_466) & (select_465 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_474;
  assign select_474 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_461 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_491;
  assign equal_491 = select_459 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_492;
  assign equal_492 = select_474 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_493;
  assign and_493 = equal_492 & and_469;
  // hls/stages/agreement.hpp:263
  logic and_495;
  assign and_495 = sample_pair_whole_q & (equal_491 & and_493);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_515;
  assign equal_515 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:581
  logic or_516;
  assign or_516 = so | equal_515;
  // hls/stages/agreement.hpp:704
  logic not_517;
  assign not_517 = ~or_516;
  // hls/stages/agreement.hpp:601
  logic equal_518;
  assign equal_518 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_520;
  assign equal_520 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:579
  logic [7:0] sum_521;
  assign sum_521 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_522;
  assign select_522 = run_shift_q[5] ? x_q : sum_521;
  logic less_523;
  assign less_523 = {2'h0, last_q} < select_522;
  // hls/stages/agreement.hpp:216
  logic not_524;
  assign not_524 = ~less_523;
  // hls/stages/agreement.hpp:141
  logic and_525;
  assign and_525 = equal_520 & not_524;
  logic and_527;
  assign and_527 = not_517 & ((~equal_518) & and_525);
  // hls/stages/census.hpp:41
  logic [5:0] select_554;
  assign select_554 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_554 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_611;
  assign select_611 = equal_518 ? not_524 : and_525;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:770
  logic [6:0] sum_631;
  assign sum_631 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:141
  logic and_636;
  assign and_636 = equal_518 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_631} < select_522))));
  logic select_637;
  assign select_637 = or_516 ? not_524 : and_636;
  // hls/stages/agreement.hpp:778
  logic equal_640;
  assign equal_640 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_642;
  assign or_642 = equal_640 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [5:0] right;
  assign right = sum_521[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:182
  logic and_1825;
  assign and_1825 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:263
  logic [2:0] select_1990;
  assign select_1990 = sample_pair_whole_q ? (sample_last_q ? (select_474 + 3'h1) : select_474) : raster_at_y_q;
  logic [5:0] select_1992;
  assign select_1992 = sample_pair_whole_q ? (select_461 + {5'h0, equal_491}) : raster_at_column_q;
  logic [5:0] select_1995;
  assign select_1995 = sample_pair_whole_q ? (sample_last_q ? (select_554 + {5'h0, equal_492}) : select_554) : raster_at_row_q;
  logic select_1999;
  assign select_1999 = sample_pair_whole_q ? (sample_last_q ? (or_466 & (~raster_final_row_q)) : or_466) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2001;
  assign select_2001 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2005;
  assign select_2005 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2249;
  assign equal_2249 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:451
  logic and_2250;
  assign and_2250 = and_495 & equal_2249;
  // hls/stages/agreement.hpp:510
  logic select_2253;
  assign select_2253 = (and_2250 | (~ends_cell_q)) ? and_2250 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2253 ? (and_2250 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2257;
  assign select_2257 = select_2253 ? (and_2250 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2260;
  assign select_2260 = select_2253 ? (following_last_shift_q & (~and_2250)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2263;
  assign and_2263 = run_last_shift_q & equal_518;
  // hls/stages/agreement.hpp:603
  logic select_2265;
  assign select_2265 = equal_518 ? (~run_last_shift_q) : equal_520;
  // hls/stages/agreement.hpp:607
  logic equal_2266;
  assign equal_2266 = run_phase_q == 3'h1;
  logic not_2269;
  assign not_2269 = ~select_2265;
  // hls/stages/agreement.hpp:610
  logic equal_2271;
  assign equal_2271 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2272;
  assign and_2272 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2273;
  assign select_2273 = equal_2271 ? 2'h1 : {2{and_2272}};
  logic [2:0] select_2275;
  assign select_2275 = (and_2263 | (select_2265 | equal_2266)) ? (equal_2266 ? 3'h2 : {not_2269, {2{select_2265}}}) : (equal_515 ? 3'h6 : {select_2273[0], select_2273});
  // hls/stages/agreement.hpp:594
  logic and_2278;
  assign and_2278 = select_2265 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2281;
  assign select_2281 = (plan_shift_q[5] & select_2265) ? value : 7'h0;
  logic [1:0] or_2282;
  assign or_2282 = {2{so}} | select_2281[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] select_2283;
  assign select_2283 = select_2265 ? plan_columns_q : 8'h0;
  logic [6:0] or_2286;
  assign or_2286 = select_2283[6:0] | ((equal_2266 | equal_2271) ? whole_q : 7'h0);
  logic [1:0] or_2287;
  assign or_2287 = {2{and_2263}} | or_2286[3:2];
  // hls/stages/agreement.hpp:621
  logic [6:0] or_2289;
  assign or_2289 = {or_2286[6:4], or_2287, or_2286[1:0]} | (equal_515 ? drawn_q : 7'h0);
  logic [4:0] or_2290;
  assign or_2290 = {5{so}} | {or_2289[6], or_2289[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2294;
  assign not_2294 = ~run_shift_q[5];
  logic [6:0] difference_2296;
  assign difference_2296 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2297;
  assign select_2297 = equal_518 ? ({{7{not_2294}}, 1'b1} + run_span_q) : {difference_2296[6], difference_2296};
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2301;
  assign select_2301 = and_2250 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2303;
  assign select_2303 = select_2253 ? {select_2301[6], select_2301} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2306;
  assign select_2306 = select_2253 ? (and_2250 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [5:0] select_2314;
  assign select_2314 = and_495 ? (equal_2249 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2317;
  assign select_2317 = and_495 ? (equal_2249 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2320;
  assign select_2320 = and_495 ? (equal_2249 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2334;
  assign select_2334 = (ends_cell_q | select_2253) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_518 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2338;
  assign and_2338 = (~select_2253) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2339;
  assign sum_2339 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2341;
  assign select_2341 = equal_2249 ? ({sum_2339[6], cfg_height_i[8:3]} == {1'b0, sum_2339[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:325
  logic or_2720;
  assign or_2720 = select_461[0] | select_554[5];
  logic [7:0] sum_2721;
  assign sum_2721 = {1'b0, select_461[2:1], or_2720, select_554[4:1]} + 8'h1;
  logic less_2722;
  assign less_2722 = {sum_2721, select_554[0], select_474, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1292; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_527;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1293; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (or_516 ? not_524 : select_611);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1294; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_518 ? sum_521[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_517 & select_611);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 46, DISTANCE 12, hls/stages/agreement.hpp:1295; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 46'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_516 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_637;
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
      left_first_q <= and_1825 ? left_first_q : marks_first_i;
      right_q <= (~and_1825) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1825;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_459 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_1990;
      raster_at_column_q <= select_1992;
      raster_at_row_q <= select_1995;
      raster_at_live_q <= select_1999;
      raster_rows_left_q <= sample_pair_whole_q ? select_2001 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2005;
      averager_place_q <= sample_pair_whole_q ? select_465 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2257;
      run_last_shift_q <= select_2260;
      run_span_q <= select_2253 ? (and_2250 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2275;
      following_shift_q <= select_2265 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2278;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2281[6], or_2282, select_2281[3:0]};
      following_columns_q <= {select_2283[7], or_2290[4], or_2289[5:4], or_2290[3:0]};
      plan_shift_q <= equal_518 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2297;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2303;
      columns_left_q <= select_2306;
      last_q <= and_495 ? (equal_2249 ? column : last_q) : last_q;
      least_q <= select_2314;
      whole_q <= select_2317;
      drawn_q <= select_2320;
      age_q <= select_2253 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2253 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2334;
      ends_q <= and_2338;
      final_row_q <= and_495 ? select_2341 : final_row_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic sample_pair_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_present_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [5:0] last_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic [2:0] select_459_s1_q;
  logic [5:0] select_461_s1_q;
  logic [7:0] select_465_s1_q;
  logic and_469_s1_q;
  logic equal_475_s1_q;
  logic [5:0] column_s1_q;
  logic and_493_s1_q;
  logic and_495_s1_q;
  logic so_s1_q;
  logic equal_515_s1_q;
  logic or_516_s1_q;
  logic equal_518_s1_q;
  logic less_523_s1_q;
  logic not_524_s1_q;
  logic and_527_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_637_s1_q;
  logic select_644_s1_q;
  logic and_1446_s1_q;
  logic [5:0] right_s1_q;
  logic select_1455_s1_q;
  logic equal_1464_s1_q;
  logic equal_1583_s1_q;
  logic equal_2249_s1_q;
  logic and_2250_s1_q;
  logic not_2723_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      sample_pair_first_s1_q <= sample_pair_first_q;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_present_s1_q <= sample_present_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      last_s1_q <= last_q;
      age_s1_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s1_q <= slot_q;
      ends_cell_s1_q <= ends_cell_q;
      select_459_s1_q <= select_459;
      select_461_s1_q <= select_461;
      select_465_s1_q <= select_465;
      and_469_s1_q <= and_469;
      equal_475_s1_q <= select_474 == 3'h0;
      column_s1_q <= column;
      and_493_s1_q <= and_493;
      and_495_s1_q <= and_495;
      so_s1_q <= so;
      equal_515_s1_q <= equal_515;
      or_516_s1_q <= or_516;
      equal_518_s1_q <= equal_518;
      less_523_s1_q <= less_523;
      not_524_s1_q <= not_524;
      and_527_s1_q <= and_527;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_637_s1_q <= select_637;
      select_644_s1_q <= or_642 ? equal_640 : (~age_q[3]);
      and_1446_s1_q <= not_517 & and_636;
      right_s1_q <= right;
      select_1455_s1_q <= or_642 ? equal_640 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1464_s1_q <= run_phase_q == 3'h7;
      equal_1583_s1_q <= {or_466, select_474} == 4'hc;
      equal_2249_s1_q <= equal_2249;
      and_2250_s1_q <= and_2250;
      not_2723_s1_q <= ~less_2722;
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
  logic [3:0] patches_phase_q;
  logic [3:0] patches_band_rows_rows_to_next_q;
  logic [4:0] patches_band_rows_number_q;
  logic [3:0] patches_next_band_rows_to_next_q;
  logic [4:0] patches_next_band_number_q;
  logic [3:0] patches_first_band_rows_to_next_q;
  logic patches_first_band_number_q;
  logic [3:0] patches_choosing_rows_to_next_q;
  logic [4:0] patches_choosing_number_q;
  logic patches_chooses_q;
  logic [4:0] patches_choosing_band_q;
  logic patches_capturing_q;
  logic patches_lower_q;
  logic [4:0] patches_row_q;
  logic [2:0] patches_work_q;
  logic patches_second_q;
  logic [2:0] patches_following_q;
  logic [4:0] patches_following_beats_q;
  logic patches_begins_q;
  logic patches_ends_q;
  logic [11:0] patches_remaining_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:653
  logic not_615;
  assign not_615 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:656
  logic and_616;
  assign and_616 = left_rdata_q[12] & not_615;
  logic and_617;
  assign and_617 = left_rdata_q[28] & not_615;
  logic and_618;
  assign and_618 = left_rdata_q[44] & not_615;
  logic and_619;
  assign and_619 = left_rdata_q[60] & not_615;
  // hls/stages/agreement.hpp:657
  logic and_623;
  assign and_623 = right_codes_rdata_q[12] & not_615;
  logic and_624;
  assign and_624 = right_codes_rdata_q[25] & not_615;
  logic and_625;
  assign and_625 = right_codes_rdata_q[38] & not_615;
  logic and_626;
  assign and_626 = right_codes_rdata_q[51] & not_615;
  logic and_627;
  assign and_627 = right_codes_rdata_q[64] & not_615;
  logic and_628;
  assign and_628 = right_codes_rdata_q[77] & not_615;
  // hls/stages/agreement.hpp:212
  logic and_650;
  assign and_650 = left_rdata_q[44] & not_524_s1_q;
  logic and_651;
  assign and_651 = right_codes_rdata_q[38] & not_524_s1_q;
  logic [11:0] select_652;
  assign select_652 = less_523_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_653;
  assign select_653 = less_523_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_657;
  assign select_657 = and_650 ? (and_651 ? (~(select_652 ^ select_653)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_663;
  assign parity_663 = ^select_657[5:3];
  logic parity_666;
  assign parity_666 = ^select_657[8:6];
  logic parity_669;
  assign parity_669 = ^select_657[11:3];
  // hls/stages/agreement.hpp:212
  logic and_673;
  assign and_673 = left_rdata_q[60] & not_524_s1_q;
  logic and_674;
  assign and_674 = right_codes_rdata_q[51] & not_524_s1_q;
  logic [11:0] select_675;
  assign select_675 = less_523_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_676;
  assign select_676 = less_523_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_680;
  assign select_680 = and_673 ? (and_674 ? (~(select_675 ^ select_676)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_683;
  assign parity_683 = ^select_680[8:6];
  logic parity_686;
  assign parity_686 = ^select_680[11:9];
  // hls/stages/agreement.hpp:212
  logic and_690;
  assign and_690 = left_rdata_q[76] & not_524_s1_q;
  logic and_691;
  assign and_691 = right_codes_rdata_q[64] & not_524_s1_q;
  logic [11:0] select_692;
  assign select_692 = less_523_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_693;
  assign select_693 = less_523_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_697;
  assign select_697 = and_690 ? (and_691 ? (~(select_692 ^ select_693)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_703;
  assign parity_703 = ^select_697[2:0];
  logic parity_706;
  assign parity_706 = ^select_697[5:3];
  logic parity_709;
  assign parity_709 = ^select_697[8:0];
  logic parity_715;
  assign parity_715 = ^select_697[11:9];
  logic parity_718;
  assign parity_718 = ^select_680[2:0];
  logic parity_721;
  assign parity_721 = ^{select_697[11:9], select_680[5:0]};
  logic parity_724;
  assign parity_724 = ^{select_697, select_680, select_657[2:0]};
  logic xor_725;
  assign xor_725 = parity_669 ^ parity_724;
  // hls/stages/count_bits.hpp:23
  logic or_729;
  assign or_729 = (select_657[1:0] == 2'h3) | (select_657[2] & (select_657[0] | select_657[1]));
  // hls/stages/count_bits.hpp:25
  logic or_733;
  assign or_733 = (select_680[7:6] == 2'h3) | (select_680[8] & (select_680[6] | select_680[7]));
  logic or_737;
  assign or_737 = (select_680[10:9] == 2'h3) | (select_680[11] & (select_680[9] | select_680[10]));
  // hls/stages/count_bits.hpp:23
  logic or_745;
  assign or_745 = (select_697[7:6] == 2'h3) | (select_697[8] & (~(select_697[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_749;
  assign or_749 = (select_697[1:0] == 2'h3) | (select_697[2] & (select_697[0] | select_697[1]));
  logic or_753;
  assign or_753 = (select_697[4:3] == 2'h3) | (select_697[5] & (select_697[3] | select_697[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_756;
  assign parity_756 = ^{or_753, or_749, or_745};
  // hls/stages/count_bits.hpp:23
  logic or_760;
  assign or_760 = (select_680[4:3] == 2'h3) | (select_680[5] & (select_680[3] | select_680[4]));
  // hls/stages/count_bits.hpp:25
  logic or_764;
  assign or_764 = (select_697[10:9] == 2'h3) | (select_697[11] & (select_697[9] | select_697[10]));
  logic or_768;
  assign or_768 = (select_680[1:0] == 2'h3) | (select_680[2] & (select_680[0] | select_680[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_771;
  assign parity_771 = ^{or_768, or_764, or_760};
  logic parity_774;
  assign parity_774 = ^{or_768, or_764, or_760, or_753, or_749, or_745, or_737, or_733, or_729};
  // hls/stages/count_bits.hpp:25
  logic and_775;
  assign and_775 = parity_669 & parity_724;
  logic or_779;
  assign or_779 = (parity_663 & parity_666) | ((^select_657[11:9]) & (parity_663 | parity_666));
  logic and_782;
  assign and_782 = (^{select_680[11:6], select_657[2:0]}) & (parity_709 | parity_721);
  logic or_783;
  assign or_783 = (parity_709 & parity_721) | and_782;
  // hls/stages/count_bits.hpp:23
  logic or_790;
  assign or_790 = (select_657[10:9] == 2'h3) | (select_657[11] & (select_657[9] | select_657[10]));
  // hls/stages/count_bits.hpp:25
  logic or_794;
  assign or_794 = (select_657[4:3] == 2'h3) | (select_657[5] & (select_657[3] | select_657[4]));
  logic or_798;
  assign or_798 = (select_657[7:6] == 2'h3) | (select_657[8] & (select_657[6] | select_657[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_801;
  assign parity_801 = ^{or_798, or_794, or_790};
  // hls/stages/count_bits.hpp:25
  logic or_805;
  assign or_805 = (parity_683 & parity_686) | ((^select_657[2:0]) & (parity_683 | parity_686));
  logic or_809;
  assign or_809 = (parity_703 & parity_706) | ((^select_697[8:6]) & (parity_703 | parity_706));
  logic or_813;
  assign or_813 = (parity_715 & parity_718) | ((^select_680[5:3]) & (parity_715 | parity_718));
  // hls/stages/count_bits.hpp:24
  logic parity_816;
  assign parity_816 = ^{or_813, or_809, or_805};
  logic parity_819;
  assign parity_819 = ^{or_813, or_809, or_805, or_798, or_794, or_790, or_783, or_779, and_775};
  logic xor_820;
  assign xor_820 = parity_774 ^ parity_819;
  // hls/stages/count_bits.hpp:25
  logic and_821;
  assign and_821 = parity_774 & parity_819;
  logic or_825;
  assign or_825 = (parity_756 & parity_771) | ((^{or_737, or_733, or_729}) & (parity_756 | parity_771));
  logic or_829;
  assign or_829 = (parity_801 & parity_816) | ((^{or_783, or_779, and_775}) & (parity_801 | parity_816));
  logic or_836;
  assign or_836 = (or_733 & or_737) | (or_729 & (or_733 | or_737));
  logic or_840;
  assign or_840 = (or_749 & or_753) | (or_745 & (or_749 | or_753));
  logic or_844;
  assign or_844 = (or_764 & or_768) | (or_760 & (or_764 | or_768));
  // hls/stages/count_bits.hpp:24
  logic parity_847;
  assign parity_847 = ^{or_844, or_840, or_836};
  // hls/stages/count_bits.hpp:25
  logic or_851;
  assign or_851 = (or_779 & or_783) | (and_775 & (or_779 | or_783));
  logic or_855;
  assign or_855 = (or_794 & or_798) | (or_790 & (or_794 | or_798));
  logic or_859;
  assign or_859 = (or_809 & or_813) | (or_805 & (or_809 | or_813));
  // hls/stages/count_bits.hpp:24
  logic parity_862;
  assign parity_862 = ^{or_859, or_855, or_851};
  logic parity_865;
  assign parity_865 = ^{or_859, or_855, or_851, or_844, or_840, or_836, or_829, or_825, and_821};
  // hls/stages/count_bits.hpp:25
  logic or_869;
  assign or_869 = (parity_847 & parity_862) | ((^{or_829, or_825, and_821}) & (parity_847 | parity_862));
  logic or_873;
  assign or_873 = (or_825 & or_829) | (and_821 & (or_825 | or_829));
  logic or_877;
  assign or_877 = (or_840 & or_844) | (or_836 & (or_840 | or_844));
  logic or_881;
  assign or_881 = (or_855 & or_859) | (or_851 & (or_855 | or_859));
  // hls/stages/count_bits.hpp:24
  logic parity_886;
  assign parity_886 = ^{or_881, or_877, or_873, or_869};
  // hls/stages/count_bits.hpp:25
  logic or_890;
  assign or_890 = (or_877 & or_881) | (or_873 & (or_877 | or_881));
  logic and_891;
  assign and_891 = or_869 & (^{or_881, or_877, or_873});
  // hls/stages/count_bits.hpp:24
  logic xor_892;
  assign xor_892 = or_890 ^ and_891;
  // hls/stages/count_bits.hpp:27
  logic and_893;
  assign and_893 = or_890 & and_891;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_894;
  assign select_894 = equal_518_s1_q ? {and_893, xor_892, parity_886, parity_865, xor_820, xor_725} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_516_s1_q ? 6'h0 : select_894;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_905;
  assign select_905 = (slot_s1_q[0] ? and_691 : and_674) ? (~(select_653 ^ (slot_s1_q[0] ? select_692 : select_675))) : 12'h0;
  logic [11:0] select_906;
  assign select_906 = and_650 ? select_905 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_912;
  assign parity_912 = ^select_906[5:3];
  logic parity_915;
  assign parity_915 = ^select_906[8:6];
  logic parity_918;
  assign parity_918 = ^select_906[11:3];
  // hls/stages/agreement.hpp:212
  logic and_922;
  assign and_922 = right_codes_rdata_q[77] & not_524_s1_q;
  logic [11:0] select_924;
  assign select_924 = less_523_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_928;
  assign select_928 = (slot_s1_q[0] ? and_922 : and_691) ? (~(select_676 ^ (slot_s1_q[0] ? select_924 : select_692))) : 12'h0;
  logic [11:0] select_929;
  assign select_929 = and_673 ? select_928 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_932;
  assign parity_932 = ^select_929[8:6];
  logic parity_935;
  assign parity_935 = ^select_929[11:9];
  // hls/stages/agreement.hpp:718
  logic select_940;
  assign select_940 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_524_s1_q) : and_922;
  logic [11:0] select_942;
  assign select_942 = slot_s1_q[0] ? (less_523_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_924;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_946;
  assign select_946 = and_690 ? (select_940 ? (~(select_693 ^ select_942)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_952;
  assign parity_952 = ^select_946[2:0];
  logic parity_955;
  assign parity_955 = ^select_946[5:3];
  logic parity_958;
  assign parity_958 = ^select_946[8:0];
  logic parity_964;
  assign parity_964 = ^select_946[11:9];
  logic parity_967;
  assign parity_967 = ^select_929[2:0];
  logic parity_970;
  assign parity_970 = ^{select_946[11:9], select_929[5:0]};
  logic parity_973;
  assign parity_973 = ^{select_946, select_929, select_906[2:0]};
  logic xor_974;
  assign xor_974 = parity_918 ^ parity_973;
  // hls/stages/count_bits.hpp:23
  logic or_978;
  assign or_978 = (select_906[1:0] == 2'h3) | (select_906[2] & (select_906[0] | select_906[1]));
  // hls/stages/count_bits.hpp:25
  logic or_982;
  assign or_982 = (select_929[7:6] == 2'h3) | (select_929[8] & (select_929[6] | select_929[7]));
  logic or_986;
  assign or_986 = (select_929[10:9] == 2'h3) | (select_929[11] & (select_929[9] | select_929[10]));
  // hls/stages/count_bits.hpp:23
  logic or_994;
  assign or_994 = (select_946[7:6] == 2'h3) | (select_946[8] & (~(select_946[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_998;
  assign or_998 = (select_946[1:0] == 2'h3) | (select_946[2] & (select_946[0] | select_946[1]));
  logic or_1002;
  assign or_1002 = (select_946[4:3] == 2'h3) | (select_946[5] & (select_946[3] | select_946[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1005;
  assign parity_1005 = ^{or_1002, or_998, or_994};
  // hls/stages/count_bits.hpp:23
  logic or_1009;
  assign or_1009 = (select_929[4:3] == 2'h3) | (select_929[5] & (select_929[3] | select_929[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1013;
  assign or_1013 = (select_946[10:9] == 2'h3) | (select_946[11] & (select_946[9] | select_946[10]));
  logic or_1017;
  assign or_1017 = (select_929[1:0] == 2'h3) | (select_929[2] & (select_929[0] | select_929[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1020;
  assign parity_1020 = ^{or_1017, or_1013, or_1009};
  logic parity_1023;
  assign parity_1023 = ^{or_1017, or_1013, or_1009, or_1002, or_998, or_994, or_986, or_982, or_978};
  // hls/stages/count_bits.hpp:25
  logic and_1024;
  assign and_1024 = parity_918 & parity_973;
  logic or_1028;
  assign or_1028 = (parity_912 & parity_915) | ((^select_906[11:9]) & (parity_912 | parity_915));
  logic and_1031;
  assign and_1031 = (^{select_929[11:6], select_906[2:0]}) & (parity_958 | parity_970);
  logic or_1032;
  assign or_1032 = (parity_958 & parity_970) | and_1031;
  // hls/stages/count_bits.hpp:23
  logic or_1039;
  assign or_1039 = (select_906[10:9] == 2'h3) | (select_906[11] & (select_906[9] | select_906[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1043;
  assign or_1043 = (select_906[4:3] == 2'h3) | (select_906[5] & (select_906[3] | select_906[4]));
  logic or_1047;
  assign or_1047 = (select_906[7:6] == 2'h3) | (select_906[8] & (select_906[6] | select_906[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1050;
  assign parity_1050 = ^{or_1047, or_1043, or_1039};
  // hls/stages/count_bits.hpp:25
  logic or_1054;
  assign or_1054 = (parity_932 & parity_935) | ((^select_906[2:0]) & (parity_932 | parity_935));
  logic or_1058;
  assign or_1058 = (parity_952 & parity_955) | ((^select_946[8:6]) & (parity_952 | parity_955));
  logic or_1062;
  assign or_1062 = (parity_964 & parity_967) | ((^select_929[5:3]) & (parity_964 | parity_967));
  // hls/stages/count_bits.hpp:24
  logic parity_1065;
  assign parity_1065 = ^{or_1062, or_1058, or_1054};
  logic parity_1068;
  assign parity_1068 = ^{or_1062, or_1058, or_1054, or_1047, or_1043, or_1039, or_1032, or_1028, and_1024};
  logic xor_1069;
  assign xor_1069 = parity_1023 ^ parity_1068;
  // hls/stages/count_bits.hpp:25
  logic and_1070;
  assign and_1070 = parity_1023 & parity_1068;
  logic or_1074;
  assign or_1074 = (parity_1005 & parity_1020) | ((^{or_986, or_982, or_978}) & (parity_1005 | parity_1020));
  logic or_1078;
  assign or_1078 = (parity_1050 & parity_1065) | ((^{or_1032, or_1028, and_1024}) & (parity_1050 | parity_1065));
  logic or_1085;
  assign or_1085 = (or_982 & or_986) | (or_978 & (or_982 | or_986));
  logic or_1089;
  assign or_1089 = (or_998 & or_1002) | (or_994 & (or_998 | or_1002));
  logic or_1093;
  assign or_1093 = (or_1013 & or_1017) | (or_1009 & (or_1013 | or_1017));
  // hls/stages/count_bits.hpp:24
  logic parity_1096;
  assign parity_1096 = ^{or_1093, or_1089, or_1085};
  // hls/stages/count_bits.hpp:25
  logic or_1100;
  assign or_1100 = (or_1028 & or_1032) | (and_1024 & (or_1028 | or_1032));
  logic or_1104;
  assign or_1104 = (or_1043 & or_1047) | (or_1039 & (or_1043 | or_1047));
  logic or_1108;
  assign or_1108 = (or_1058 & or_1062) | (or_1054 & (or_1058 | or_1062));
  // hls/stages/count_bits.hpp:24
  logic parity_1111;
  assign parity_1111 = ^{or_1108, or_1104, or_1100};
  logic parity_1114;
  assign parity_1114 = ^{or_1108, or_1104, or_1100, or_1093, or_1089, or_1085, or_1078, or_1074, and_1070};
  // hls/stages/count_bits.hpp:25
  logic or_1118;
  assign or_1118 = (parity_1096 & parity_1111) | ((^{or_1078, or_1074, and_1070}) & (parity_1096 | parity_1111));
  logic or_1122;
  assign or_1122 = (or_1074 & or_1078) | (and_1070 & (or_1074 | or_1078));
  logic or_1126;
  assign or_1126 = (or_1089 & or_1093) | (or_1085 & (or_1089 | or_1093));
  logic or_1130;
  assign or_1130 = (or_1104 & or_1108) | (or_1100 & (or_1104 | or_1108));
  // hls/stages/count_bits.hpp:24
  logic parity_1135;
  assign parity_1135 = ^{or_1130, or_1126, or_1122, or_1118};
  // hls/stages/count_bits.hpp:25
  logic or_1139;
  assign or_1139 = (or_1126 & or_1130) | (or_1122 & (or_1126 | or_1130));
  logic and_1140;
  assign and_1140 = or_1118 & (^{or_1130, or_1126, or_1122});
  // hls/stages/count_bits.hpp:24
  logic xor_1141;
  assign xor_1141 = or_1139 ^ and_1140;
  // hls/stages/count_bits.hpp:27
  logic and_1142;
  assign and_1142 = or_1139 & and_1140;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1143;
  assign select_1143 = equal_518_s1_q ? {and_1142, xor_1141, parity_1135, parity_1114, xor_1069, xor_974} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_516_s1_q ? 6'h0 : select_1143;
  // hls/stages/agreement.hpp:212
  logic and_1151;
  assign and_1151 = right_codes_rdata_q[25] & not_524_s1_q;
  // hls/stages/agreement.hpp:718
  logic select_1152;
  assign select_1152 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_524_s1_q) : and_1151;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1154;
  assign select_1154 = less_523_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1155;
  assign select_1155 = slot_s1_q[0] ? (less_523_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1154;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1159;
  assign select_1159 = and_650 ? (select_1152 ? (~(select_653 ^ select_1155)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1165;
  assign parity_1165 = ^select_1159[5:3];
  logic parity_1168;
  assign parity_1168 = ^select_1159[8:6];
  logic parity_1171;
  assign parity_1171 = ^select_1159[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1179;
  assign select_1179 = (slot_s1_q[0] ? and_1151 : and_651) ? (~(select_676 ^ (slot_s1_q[0] ? select_1154 : select_652))) : 12'h0;
  logic [11:0] select_1180;
  assign select_1180 = and_673 ? select_1179 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1183;
  assign parity_1183 = ^select_1180[8:6];
  logic parity_1186;
  assign parity_1186 = ^select_1180[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1194;
  assign select_1194 = (slot_s1_q[0] ? and_651 : and_674) ? (~(select_693 ^ (slot_s1_q[0] ? select_652 : select_675))) : 12'h0;
  logic [11:0] select_1195;
  assign select_1195 = and_690 ? select_1194 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1201;
  assign parity_1201 = ^select_1195[2:0];
  logic parity_1204;
  assign parity_1204 = ^select_1195[5:3];
  logic parity_1207;
  assign parity_1207 = ^select_1195[8:0];
  logic parity_1213;
  assign parity_1213 = ^select_1195[11:9];
  logic parity_1216;
  assign parity_1216 = ^select_1180[2:0];
  logic parity_1219;
  assign parity_1219 = ^{select_1195[11:9], select_1180[5:0]};
  logic parity_1222;
  assign parity_1222 = ^{select_1195, select_1180, select_1159[2:0]};
  logic xor_1223;
  assign xor_1223 = parity_1171 ^ parity_1222;
  // hls/stages/count_bits.hpp:23
  logic or_1227;
  assign or_1227 = (select_1159[1:0] == 2'h3) | (select_1159[2] & (select_1159[0] | select_1159[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1231;
  assign or_1231 = (select_1180[7:6] == 2'h3) | (select_1180[8] & (select_1180[6] | select_1180[7]));
  logic or_1235;
  assign or_1235 = (select_1180[10:9] == 2'h3) | (select_1180[11] & (select_1180[9] | select_1180[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1243;
  assign or_1243 = (select_1195[7:6] == 2'h3) | (select_1195[8] & (~(select_1195[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1247;
  assign or_1247 = (select_1195[1:0] == 2'h3) | (select_1195[2] & (select_1195[0] | select_1195[1]));
  logic or_1251;
  assign or_1251 = (select_1195[4:3] == 2'h3) | (select_1195[5] & (select_1195[3] | select_1195[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1254;
  assign parity_1254 = ^{or_1251, or_1247, or_1243};
  // hls/stages/count_bits.hpp:23
  logic or_1258;
  assign or_1258 = (select_1180[4:3] == 2'h3) | (select_1180[5] & (select_1180[3] | select_1180[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1262;
  assign or_1262 = (select_1195[10:9] == 2'h3) | (select_1195[11] & (select_1195[9] | select_1195[10]));
  logic or_1266;
  assign or_1266 = (select_1180[1:0] == 2'h3) | (select_1180[2] & (select_1180[0] | select_1180[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1269;
  assign parity_1269 = ^{or_1266, or_1262, or_1258};
  logic parity_1272;
  assign parity_1272 = ^{or_1266, or_1262, or_1258, or_1251, or_1247, or_1243, or_1235, or_1231, or_1227};
  // hls/stages/count_bits.hpp:25
  logic and_1273;
  assign and_1273 = parity_1171 & parity_1222;
  logic or_1277;
  assign or_1277 = (parity_1165 & parity_1168) | ((^select_1159[11:9]) & (parity_1165 | parity_1168));
  logic and_1280;
  assign and_1280 = (^{select_1180[11:6], select_1159[2:0]}) & (parity_1207 | parity_1219);
  logic or_1281;
  assign or_1281 = (parity_1207 & parity_1219) | and_1280;
  // hls/stages/count_bits.hpp:23
  logic or_1288;
  assign or_1288 = (select_1159[10:9] == 2'h3) | (select_1159[11] & (select_1159[9] | select_1159[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1292;
  assign or_1292 = (select_1159[4:3] == 2'h3) | (select_1159[5] & (select_1159[3] | select_1159[4]));
  logic or_1296;
  assign or_1296 = (select_1159[7:6] == 2'h3) | (select_1159[8] & (select_1159[6] | select_1159[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1299;
  assign parity_1299 = ^{or_1296, or_1292, or_1288};
  // hls/stages/count_bits.hpp:25
  logic or_1303;
  assign or_1303 = (parity_1183 & parity_1186) | ((^select_1159[2:0]) & (parity_1183 | parity_1186));
  logic or_1307;
  assign or_1307 = (parity_1201 & parity_1204) | ((^select_1195[8:6]) & (parity_1201 | parity_1204));
  logic or_1311;
  assign or_1311 = (parity_1213 & parity_1216) | ((^select_1180[5:3]) & (parity_1213 | parity_1216));
  // hls/stages/count_bits.hpp:24
  logic parity_1314;
  assign parity_1314 = ^{or_1311, or_1307, or_1303};
  logic parity_1317;
  assign parity_1317 = ^{or_1311, or_1307, or_1303, or_1296, or_1292, or_1288, or_1281, or_1277, and_1273};
  logic xor_1318;
  assign xor_1318 = parity_1272 ^ parity_1317;
  // hls/stages/count_bits.hpp:25
  logic and_1319;
  assign and_1319 = parity_1272 & parity_1317;
  logic or_1323;
  assign or_1323 = (parity_1254 & parity_1269) | ((^{or_1235, or_1231, or_1227}) & (parity_1254 | parity_1269));
  logic or_1327;
  assign or_1327 = (parity_1299 & parity_1314) | ((^{or_1281, or_1277, and_1273}) & (parity_1299 | parity_1314));
  logic or_1334;
  assign or_1334 = (or_1231 & or_1235) | (or_1227 & (or_1231 | or_1235));
  logic or_1338;
  assign or_1338 = (or_1247 & or_1251) | (or_1243 & (or_1247 | or_1251));
  logic or_1342;
  assign or_1342 = (or_1262 & or_1266) | (or_1258 & (or_1262 | or_1266));
  // hls/stages/count_bits.hpp:24
  logic parity_1345;
  assign parity_1345 = ^{or_1342, or_1338, or_1334};
  // hls/stages/count_bits.hpp:25
  logic or_1349;
  assign or_1349 = (or_1277 & or_1281) | (and_1273 & (or_1277 | or_1281));
  logic or_1353;
  assign or_1353 = (or_1292 & or_1296) | (or_1288 & (or_1292 | or_1296));
  logic or_1357;
  assign or_1357 = (or_1307 & or_1311) | (or_1303 & (or_1307 | or_1311));
  // hls/stages/count_bits.hpp:24
  logic parity_1360;
  assign parity_1360 = ^{or_1357, or_1353, or_1349};
  logic parity_1363;
  assign parity_1363 = ^{or_1357, or_1353, or_1349, or_1342, or_1338, or_1334, or_1327, or_1323, and_1319};
  // hls/stages/count_bits.hpp:25
  logic or_1367;
  assign or_1367 = (parity_1345 & parity_1360) | ((^{or_1327, or_1323, and_1319}) & (parity_1345 | parity_1360));
  logic or_1371;
  assign or_1371 = (or_1323 & or_1327) | (and_1319 & (or_1323 | or_1327));
  logic or_1375;
  assign or_1375 = (or_1338 & or_1342) | (or_1334 & (or_1338 | or_1342));
  logic or_1379;
  assign or_1379 = (or_1353 & or_1357) | (or_1349 & (or_1353 | or_1357));
  // hls/stages/count_bits.hpp:24
  logic parity_1384;
  assign parity_1384 = ^{or_1379, or_1375, or_1371, or_1367};
  // hls/stages/count_bits.hpp:25
  logic or_1388;
  assign or_1388 = (or_1375 & or_1379) | (or_1371 & (or_1375 | or_1379));
  logic and_1389;
  assign and_1389 = or_1367 & (^{or_1379, or_1375, or_1371});
  // hls/stages/count_bits.hpp:24
  logic xor_1390;
  assign xor_1390 = or_1388 ^ and_1389;
  // hls/stages/count_bits.hpp:27
  logic and_1391;
  assign and_1391 = or_1388 & and_1389;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1392;
  assign select_1392 = equal_518_s1_q ? {and_1391, xor_1390, parity_1384, parity_1363, xor_1318, xor_1223} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_516_s1_q ? 6'h0 : select_1392;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [5:0] select_1450;
  assign select_1450 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:932
  logic and_1470;
  assign and_1470 = (or_516_s1_q & (left_rdata_q[61] & not_524_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1492;
  assign or_1492 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:303
  logic [5:0] select_1503;
  assign select_1503 = so_s1_q ? x_s1_q[5:0] : (or_516_s1_q ? (less_523_s1_q ? 6'h0 : select_1450) : 6'h0);
  // hls/stages/patches.hpp:94
  logic and_1577;
  assign and_1577 = (select_459_s1_q == 3'h0) & (select_461_s1_q == 6'h0);
  // hls/stages/patches.hpp:346
  logic not_1578;
  assign not_1578 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_1581;
  assign not_1581 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:316
  logic and_1582;
  assign and_1582 = patches_capturing_q & not_1581;
  // hls/stages/patches.hpp:276
  logic equal_1585;
  assign equal_1585 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:97
  logic and_1590;
  assign and_1590 = (not_1578 & (patches_work_q == 3'h0)) & (~(and_1582 | ((~equal_1583_s1_q) | (~equal_1585))));
  // hls/stages/patches.hpp:454
  logic equal_1673;
  assign equal_1673 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:435
  logic not_1674;
  assign not_1674 = ~equal_1673;
  // hls/stages/patches.hpp:454
  logic equal_1675;
  assign equal_1675 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:401
  logic not_1676;
  assign not_1676 = ~equal_1675;
  // hls/stages/patches.hpp:143
  logic equal_1677;
  assign equal_1677 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:454
  logic equal_1678;
  assign equal_1678 = patches_work_q == 3'h2;
  logic or_1679;
  assign or_1679 = equal_1677 | equal_1678;
  // hls/stages/patches.hpp:403
  logic not_1680;
  assign not_1680 = ~patches_second_q;
  // hls/stages/patches.hpp:327
  logic [4:0] select_1699;
  assign select_1699 = and_1590 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:98
  logic [4:0] select_1700;
  assign select_1700 = and_1577 ? select_1699 : patches_row_q;
  // hls/stages/patches.hpp:97
  logic and_1702;
  assign and_1702 = and_1582 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:98
  logic select_1706;
  assign select_1706 = and_1577 ? (and_1590 | (and_1582 & (~and_1702))) : patches_capturing_q;
  // hls/stages/patches.hpp:160
  logic and_1714;
  assign and_1714 = not_1674 & (not_1676 & (or_1679 & (patches_second_q & equal_1677)));
  // hls/stages/patches.hpp:143
  logic not_1728;
  assign not_1728 = ~equal_1677;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1742;
  assign select_1742 = and_1577 ? {select_1699[4], select_1699[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:401
  logic and_1752;
  assign and_1752 = not_1674 & (or_1679 & not_1676);
  // hls/stages/agreement.hpp:447
  logic select_2346;
  assign select_2346 = equal_2249_s1_q ? (~({row_s1_q, 1'b0} < {sum_2343, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2548;
  assign and_2548 = and_495_s1_q & (equal_2249_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:282
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:98
  logic [3:0] select_2658;
  assign select_2658 = and_1577 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2659;
  assign select_2659 = sample_pair_whole_s1_q ? select_2658 : patches_phase_q;
  // hls/stages/patches.hpp:327
  logic and_2660;
  assign and_2660 = not_1581 & equal_1583_s1_q;
  logic [8:0] select_2661;
  assign select_2661 = and_2660 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2662;
  assign select_2662 = and_2660 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2663;
  assign select_2663 = sample_pair_first_s1_q ? select_2661 : select_2662;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2665;
  assign select_2665 = sample_pair_whole_s1_q ? (and_1577 ? select_2663[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2667;
  assign select_2667 = sample_pair_whole_s1_q ? (and_1577 ? select_2663[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2670;
  assign select_2670 = sample_pair_whole_s1_q ? (equal_1585 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2672;
  assign select_2672 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_1585}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:294
  logic equal_2673;
  assign equal_2673 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:295
  logic not_2674;
  assign not_2674 = ~equal_2673;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2676;
  assign select_2676 = sample_pair_whole_s1_q ? (phase + {not_2674, 1'b1, not_2674, equal_2673}) : patches_first_band_rows_to_next_q;
  logic select_2677;
  assign select_2677 = sample_pair_whole_s1_q ? equal_2673 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_2678;
  assign equal_2678 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:64
  logic [3:0] select_2682;
  assign select_2682 = equal_2678 ? ((select_2659 == 4'h6) ? 4'h0 : (select_2659 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2683;
  assign equal_2683 = select_2682 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2686;
  assign select_2686 = equal_2249_s1_q ? (equal_2683 ? 4'h6 : (select_2682 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:64
  logic [4:0] select_2688;
  assign select_2688 = equal_2678 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2690;
  assign select_2690 = equal_2249_s1_q ? (select_2688 + {4'h0, equal_2683}) : patches_choosing_number_q;
  logic select_2694;
  assign select_2694 = equal_2249_s1_q ? ((6'h2 < row_s1_q) & equal_2683) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2697;
  assign select_2697 = and_495_s1_q ? (equal_2249_s1_q ? select_2688 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:98
  logic select_2725;
  assign select_2725 = and_1577 ? (and_1590 ? not_2723_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:347
  logic or_2762;
  assign or_2762 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:349
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:163
  logic and_2768;
  assign and_2768 = equal_1673 & not_1680;
  // hls/stages/patches.hpp:353
  logic and_2769;
  assign and_2769 = not_1728 & and_2768;
  logic [1:0] select_2771;
  assign select_2771 = equal_1675 ? 2'h0 : (equal_1678 ? 2'h3 : {equal_1677, and_2769});
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
  // hls/stages/patches.hpp:163
  logic [4:0] select_2793;
  assign select_2793 = or_2762 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1296; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_516_s1_q ? select_1450 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_637_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:677; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_1674 & (not_1676 & (or_1679 & (equal_1677 & not_1680))));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:677; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_1714;
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:678; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_1674 & (not_1676 & (not_1728 & or_1679)));
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:689; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 32'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s1_en & and_1752;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_527_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_619, left_rdata_q[59:45], and_618, left_rdata_q[43:29], and_617, left_rdata_q[27:13], and_616, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_527_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_628, right_codes_rdata_q[76:65], and_627, right_codes_rdata_q[63:52], and_626, right_codes_rdata_q[50:39], and_625, right_codes_rdata_q[37:26], and_624, right_codes_rdata_q[24:13], and_623, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      patches_phase_q <= 4'h0;
      patches_band_rows_rows_to_next_q <= 4'h0;
      patches_band_rows_number_q <= 5'h0;
      patches_next_band_rows_to_next_q <= 4'h0;
      patches_next_band_number_q <= 5'h0;
      patches_first_band_rows_to_next_q <= 4'h0;
      patches_first_band_number_q <= 1'b0;
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_choosing_number_q <= 5'h0;
      patches_chooses_q <= 1'b0;
      patches_choosing_band_q <= 5'h0;
      patches_capturing_q <= 1'b0;
      patches_lower_q <= 1'b0;
      patches_row_q <= 5'h0;
      patches_work_q <= 3'h0;
      patches_second_q <= 1'b0;
      patches_following_q <= 3'h0;
      patches_following_beats_q <= 5'h0;
      patches_begins_q <= 1'b0;
      patches_ends_q <= 1'b0;
      patches_remaining_q <= 12'h0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
    end else if (s1_en) begin
      row_q <= and_495_s1_q ? (equal_2249_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_495_s1_q ? select_2346 : lower_half_q;
      patches_phase_q <= select_2659;
      patches_band_rows_rows_to_next_q <= select_2665;
      patches_band_rows_number_q <= select_2667;
      patches_next_band_rows_to_next_q <= select_2670;
      patches_next_band_number_q <= select_2672;
      patches_first_band_rows_to_next_q <= select_2676;
      patches_first_band_number_q <= select_2677;
      patches_choosing_rows_to_next_q <= and_495_s1_q ? select_2686 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_495_s1_q ? select_2690 : patches_choosing_number_q;
      patches_chooses_q <= and_495_s1_q ? select_2694 : patches_chooses_q;
      patches_choosing_band_q <= select_2697;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_1706 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_2725 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_1700 : patches_row_q;
      patches_work_q <= or_2762 ? following : patches_work_q;
      patches_second_q <= not_1578 & (patches_second_q | (patches_ends_q & equal_1673));
      patches_following_q <= equal_1673 ? {2'h0, and_2768} : {equal_1675, select_2771};
      patches_following_beats_q <= {select_2783, not_2774};
      patches_begins_q <= sample_pair_whole_s1_q & (and_1577 & and_1702);
      patches_ends_q <= not_2786 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2791;
      patches_code_row_q <= select_2793;
      patches_column_q <= or_2762 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2786 & (patches_column_q == 5'h1e);
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
  logic sample_present_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [5:0] last_s2_q;
  logic [3:0] age_s2_q;
  logic [2:0] slot_s2_q;
  logic ends_cell_s2_q;
  logic lower_half_s2_q;
  logic [4:0] patches_band_rows_number_s2_q;
  logic patches_chooses_s2_q;
  logic [4:0] patches_choosing_band_s2_q;
  logic patches_lower_s2_q;
  logic patches_second_s2_q;
  logic [4:0] patches_code_row_s2_q;
  logic [4:0] patches_column_s2_q;
  logic [2:0] select_459_s2_q;
  logic [5:0] select_461_s2_q;
  logic [7:0] select_465_s2_q;
  logic and_469_s2_q;
  logic equal_475_s2_q;
  logic [5:0] column_s2_q;
  logic and_493_s2_q;
  logic and_495_s2_q;
  logic so_s2_q;
  logic equal_515_s2_q;
  logic or_516_s2_q;
  logic less_523_s2_q;
  logic not_524_s2_q;
  logic equal_556_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_644_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1145_s2_q;
  logic [5:0] select_1394_s2_q;
  logic and_1446_s2_q;
  logic [5:0] right_s2_q;
  logic select_1455_s2_q;
  logic equal_1464_s2_q;
  logic and_1471_s2_q;
  logic and_1474_s2_q;
  logic and_1478_s2_q;
  logic or_1492_s2_q;
  logic [5:0] select_1503_s2_q;
  logic and_1577_s2_q;
  logic and_1590_s2_q;
  logic less_1604_s2_q;
  logic equal_1673_s2_q;
  logic not_1674_s2_q;
  logic equal_1675_s2_q;
  logic not_1676_s2_q;
  logic equal_1677_s2_q;
  logic or_1679_s2_q;
  logic [4:0] select_1700_s2_q;
  logic select_1706_s2_q;
  logic [3:0] select_1742_s2_q;
  logic and_1752_s2_q;
  logic and_1825_s2_q;
  logic select_1827_s2_q;
  logic and_1830_s2_q;
  logic and_1979_s2_q;
  logic equal_2125_s2_q;
  logic equal_2249_s2_q;
  logic and_2549_s2_q;
  logic and_2551_s2_q;
  logic or_2762_s2_q;
  logic not_2786_s2_q;
  logic less_3532_s2_q;
  logic equal_3737_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      last_s2_q <= last_s1_q;
      age_s2_q <= age_s1_q;
      slot_s2_q <= slot_s1_q;
      ends_cell_s2_q <= ends_cell_s1_q;
      lower_half_s2_q <= lower_half_q;
      patches_band_rows_number_s2_q <= patches_band_rows_number_q;
      patches_chooses_s2_q <= patches_chooses_q;
      patches_choosing_band_s2_q <= patches_choosing_band_q;
      patches_lower_s2_q <= patches_lower_q;
      patches_second_s2_q <= patches_second_q;
      patches_code_row_s2_q <= patches_code_row_q;
      patches_column_s2_q <= patches_column_q;
      select_459_s2_q <= select_459_s1_q;
      select_461_s2_q <= select_461_s1_q;
      select_465_s2_q <= select_465_s1_q;
      and_469_s2_q <= and_469_s1_q;
      equal_475_s2_q <= equal_475_s1_q;
      column_s2_q <= column_s1_q;
      and_493_s2_q <= and_493_s1_q;
      and_495_s2_q <= and_495_s1_q;
      so_s2_q <= so_s1_q;
      equal_515_s2_q <= equal_515_s1_q;
      or_516_s2_q <= or_516_s1_q;
      less_523_s2_q <= less_523_s1_q;
      not_524_s2_q <= not_524_s1_q;
      equal_556_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_644_s2_q <= select_644_s1_q;
      column_2_s2_q <= column_2;
      select_1145_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1394_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1446_s2_q <= and_1446_s1_q;
      right_s2_q <= right_s1_q;
      select_1455_s2_q <= select_1455_s1_q;
      equal_1464_s2_q <= equal_1464_s1_q;
      and_1471_s2_q <= not_524_s1_q & and_1470;
      and_1474_s2_q <= (or_516_s1_q & (left_rdata_q[62] & not_524_s1_q)) & and_1470;
      and_1478_s2_q <= not_524_s1_q & (or_516_s1_q & (left_rdata_q[63] & not_524_s1_q));
      or_1492_s2_q <= or_1492;
      select_1503_s2_q <= select_1503;
      and_1577_s2_q <= and_1577;
      and_1590_s2_q <= and_1590;
      less_1604_s2_q <= 5'h4 < row_q[5:1];
      equal_1673_s2_q <= equal_1673;
      not_1674_s2_q <= not_1674;
      equal_1675_s2_q <= equal_1675;
      not_1676_s2_q <= not_1676;
      equal_1677_s2_q <= equal_1677;
      or_1679_s2_q <= or_1679;
      select_1700_s2_q <= select_1700;
      select_1706_s2_q <= select_1706;
      select_1742_s2_q <= select_1742;
      and_1752_s2_q <= and_1752;
      and_1825_s2_q <= sample_pair_whole_q;
      select_1827_s2_q <= left_first_q;
      and_1830_s2_q <= right_q;
      and_1979_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2125_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2249_s2_q <= equal_2249_s1_q;
      and_2549_s2_q <= and_2250_s1_q & and_2548;
      and_2551_s2_q <= and_2250_s1_q & (~and_2548);
      or_2762_s2_q <= or_2762;
      not_2786_s2_q <= not_2786;
      less_3532_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3737_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
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
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [11:0] patches_smooth_values_0_q;
  logic [11:0] patches_smooth_values_1_q;
  logic [11:0] patches_smooth_values_2_q;
  logic [11:0] patches_smooth_values_3_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [10:0] patches_down_values_2_q;
  logic [10:0] patches_down_values_3_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic [4:0] patches_summed_row_column_q;
  logic patches_summed_last_q;
  logic [4:0] patches_summed_down_by_q;
  logic [6:0] patches_step_q;
  logic patches_read_searches_q;
  logic [8:0] region_across_rest_q;
  logic [6:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [7:0] columns_begin_rest_q;
  logic [6:0] columns_begin_back_q;
  // hls/stages/census.hpp:119
  logic and_470;
  assign and_470 = sample_pair_whole_s2_q & and_469_s2_q;
  // hls/stages/agreement.hpp:772
  logic not_646;
  assign not_646 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_647;
  assign less_647 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:231
  logic and_649;
  assign and_649 = not_646 & (~less_647);
  // hls/stages/agreement.hpp:762
  logic [5:0] select_896;
  assign select_896 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_897;
  assign difference_897 = {1'b0, column_2_s2_q} - {1'b0, select_896};
  logic [7:0] sum_899;
  assign sum_899 = {difference_897[6], difference_897} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:739
  logic [7:0] select_900;
  assign select_900 = slot_s2_q[0] ? chosen_score_q : sum_899;
  // hls/stages/agreement.hpp:762
  logic [6:0] difference_1146;
  assign difference_1146 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1145_s2_q};
  // hls/stages/agreement.hpp:733
  logic equal_1147;
  assign equal_1147 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_1149;
  assign sum_1149 = {difference_1146[6], difference_1146} + (equal_1147 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1395;
  assign difference_1395 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1394_s2_q};
  logic [7:0] sum_1397;
  assign sum_1397 = {difference_1395[6], difference_1395} + (equal_1147 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:735
  logic less_1398;
  assign less_1398 = sum_1149 < sum_1397;
  logic [7:0] select_1399;
  assign select_1399 = less_1398 ? sum_1397 : sum_1149;
  logic less_1400;
  assign less_1400 = select_900 < select_1399;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_649 ? (less_1400 ? select_1399 : select_900) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1404;
  assign or_1404 = select_644_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1405;
  assign select_1405 = or_1404 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:704
  logic not_1406;
  assign not_1406 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1407;
  assign select_1407 = less_1398 ? {slot_s2_q[0], not_1406} : 2'h0;
  logic [2:0] select_1409;
  assign select_1409 = less_1400 ? {select_1407, not_1406} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1410;
  assign select_1410 = or_1404 ? select_1409 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1411;
  assign select_1411 = or_1404 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1412;
  assign equal_1412 = select_1409 == 3'h1;
  logic equal_1413;
  assign equal_1413 = select_1409 == 3'h2;
  logic not_1414;
  assign not_1414 = ~equal_1413;
  logic [2:0] select_1415;
  assign select_1415 = equal_1412 ? 3'h2 : {not_1414, {2{equal_1413}}};
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1418;
  assign select_1418 = slot_s2_q[0] ? 8'h0 : sum_899;
  // hls/stages/agreement.hpp:785
  logic [7:0] select_1420;
  assign select_1420 = select_1415[1] ? (select_1415[0] ? before_1_q : sum_1149) : (select_1415[0] ? sum_1149 : select_1418);
  logic [7:0] select_1421;
  assign select_1421 = select_1415[2] ? (select_1415[0] ? before_2_q : before_0_q) : select_1420;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1422;
  assign select_1422 = or_1404 ? select_1421 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1423;
  assign select_1423 = equal_1412 ? 2'h0 : {not_1414, equal_1413};
  logic [7:0] select_1425;
  assign select_1425 = select_1423[1] ? sum_1397 : (select_1423[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1426;
  assign select_1426 = or_1404 ? select_1425 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1428;
  assign sum_1428 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1429;
  assign sum_1429 = {1'b0, before_v} + sum_1428;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1430;
  assign select_1430 = slot_s2_q[0] ? chosen_near_q : sum_1429;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1432;
  assign sum_1432 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1433;
  assign sum_1433 = {1'b0, before_v_2} + sum_1432;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1435;
  assign sum_1435 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1436;
  assign sum_1436 = {1'b0, before_v_3} + sum_1435;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1438;
  assign select_1438 = (sum_1433 < sum_1436) ? sum_1436 : sum_1433;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_649 ? ((select_1430 < select_1438) ? select_1438 : select_1430) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1443;
  assign or_1443 = select_644_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1444;
  assign select_1444 = or_1443 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1445;
  assign select_1445 = or_1443 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1457;
  assign or_1457 = select_1455_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1458;
  assign select_1458 = or_1457 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1459;
  assign select_1459 = or_1457 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1461;
  assign or_1461 = select_1455_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1462;
  assign select_1462 = or_1461 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1463;
  assign select_1463 = or_1461 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1465;
  assign not_1465 = ~equal_1464_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1475;
  assign and_1475 = not_524_s2_q & and_1474_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1481;
  assign select_1481 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1484;
  assign difference_1484 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1485;
  assign sum_1485 = {difference_1484[8], difference_1484} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1487;
  assign and_1487 = (and_1474_s2_q & select_1481) & ({{22{sum_1485[9]}}, sum_1485} < 32'h3);
  logic and_1488;
  assign and_1488 = not_524_s2_q & and_1487;
  logic and_1494;
  assign and_1494 = not_524_s2_q & (and_1487 & or_1492_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1495;
  assign select_1495 = less_523_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_516_s2_q ? {select_1495, and_1494, and_1488, and_1478_s2_q, and_1475, and_1471_s2_q, not_524_s2_q} : 15'h0;
  // hls/stages/patches.hpp:303
  logic and_1497;
  assign and_1497 = ends_cell_s2_q & shift_2[0];
  logic and_1499;
  assign and_1499 = not_1465 & (so_s2_q & and_1497);
  // hls/stages/registration.hpp:215
  logic [16:0] select_1640;
  assign select_1640 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1640[16:7])) ? 8'h7f : select_1640[7:0];
  // hls/stages/patches.hpp:148
  logic [7:0] pixel;
  assign pixel = equal_1677_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1677_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:435
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  // hls/stages/patches.hpp:160
  logic and_1761;
  assign and_1761 = not_1674_s2_q & (equal_1675_s2_q & new_row);
  // hls/stages/patches.hpp:412
  logic [8:0] sum_1764;
  assign sum_1764 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1765;
  assign sum_1765 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1764, pixel_2[0]} - {1'b0, sum_1765, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:414
  logic [11:0] sum_1767;
  assign sum_1767 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1768;
  assign sum_1768 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1767[11], sum_1767};
  logic [13:0] sum_1769;
  assign sum_1769 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1768, down_2[1]};
  logic [12:0] sum_1770;
  assign sum_1770 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1769[13:1];
  logic [14:0] sum_1771;
  assign sum_1771 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1770, sum_1769[0], down_2[0]};
  // hls/stages/patches.hpp:410
  logic [8:0] sum_1774;
  assign sum_1774 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1775;
  assign sum_1775 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1774};
  logic [10:0] sum_1776;
  assign sum_1776 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1775, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1777;
  assign sum_1777 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1776[10:1];
  // hls/stages/patches.hpp:411
  logic [11:0] smooth;
  assign smooth = {sum_1777, sum_1776[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:413
  logic [12:0] sum_1779;
  assign sum_1779 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1780;
  assign sum_1780 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1781;
  assign difference_1781 = {1'b0, sum_1779, smooth[0]} - {1'b0, sum_1780, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:148
  logic and_1788;
  assign and_1788 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:160
  logic and_1792;
  assign and_1792 = or_1679_s2_q & ((equal_1677_s2_q & and_1788) & (patches_column_s2_q == 5'h1f));
  // hls/stages/patches.hpp:425
  logic or_1798;
  assign or_1798 = equal_1677_s2_q | (~and_1788);
  // hls/stages/patches.hpp:429
  logic and_1803;
  assign and_1803 = (~or_1798) & ((~patches_column_s2_q[4]) & (patches_column_s2_q == 5'hf));
  // hls/stages/patches.hpp:466
  logic less_1807;
  assign less_1807 = patches_step_q[4:0] < 5'h11;
  logic equal_1808;
  assign equal_1808 = patches_step_q[6:5] == 2'h0;
  logic not_1809;
  assign not_1809 = ~equal_1808;
  logic equal_1810;
  assign equal_1810 = patches_step_q[6:5] == 2'h3;
  logic not_1811;
  assign not_1811 = ~equal_1810;
  // hls/stages/patches.hpp:480
  logic select_1814;
  assign select_1814 = equal_1810 ? (less_1807 & (less_1807 & not_1811)) : less_1807;
  // hls/stages/patches.hpp:160
  logic and_1817;
  assign and_1817 = equal_1673_s2_q & (less_1807 ? (not_1809 & select_1814) : select_1814);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1846;
  assign sum_1846 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2349;
  assign select_2349 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2350;
  assign select_2350 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2351;
  assign select_2351 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2352;
  assign select_2352 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2353;
  assign select_2353 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2354;
  assign select_2354 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:735
  logic less_2358;
  assign less_2358 = select_1418 < select_1399;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2360;
  assign select_2360 = slot_s2_q[0] ? 7'h0 : sum_1429;
  // hls/stages/registration.hpp:76
  logic less_2449;
  assign less_2449 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2451;
  assign select_2451 = or_516_s2_q ? (less_523_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2453;
  assign select_2453 = or_516_s2_q ? (less_523_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2455;
  assign select_2455 = or_516_s2_q ? (less_523_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2453} - {1'b0, select_2455};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2457;
  assign select_2457 = rise[8] ? select_2453 : select_2455;
  logic [8:0] difference_2458;
  assign difference_2458 = {1'b0, select_2451} - {1'b0, select_2457};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2458[8] ? 8'h0 : difference_2458[7:0];
  // hls/stages/registration.hpp:37
  logic not_2460;
  assign not_2460 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2449 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2460};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2462;
  assign xor_2462 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2462};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2468;
  assign select_2468 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2449 ? {taken, 1'b1} : {not_2460, select_2468, not_2460};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2470;
  assign sum_2470 = {left, 1'b1} + {taken_2, less_2449};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2472;
  assign select_2472 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:128
  logic [15:0] select_2552;
  assign select_2552 = and_2551_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2554;
  assign select_2554 = and_2549_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2552[15]}}, select_2552});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2555;
  assign select_2555 = and_2551_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2555[15]}}, select_2555};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2557;
  assign select_2557 = and_2549_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_2558;
  assign and_2558 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:124
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2558 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:163
  logic select_2801;
  assign select_2801 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:160
  logic [11:0] select_2804;
  assign select_2804 = equal_1675_s2_q ? patches_smooth_values_0_q : (or_1679_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_2806;
  assign select_2806 = or_1679_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2808;
  assign select_2808 = equal_1673_s2_q ? patches_smooth_values_1_q : (equal_1675_s2_q ? patches_smooth_values_1_q : select_2806);
  logic [11:0] select_2809;
  assign select_2809 = or_1679_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2811;
  assign select_2811 = equal_1673_s2_q ? patches_smooth_values_2_q : (equal_1675_s2_q ? patches_smooth_values_2_q : select_2809);
  logic [11:0] select_2812;
  assign select_2812 = or_1679_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2814;
  assign select_2814 = equal_1673_s2_q ? patches_smooth_values_3_q : (equal_1675_s2_q ? patches_smooth_values_3_q : select_2812);
  logic [10:0] select_2816;
  assign select_2816 = equal_1675_s2_q ? patches_down_values_0_q : (or_1679_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_2819;
  assign select_2819 = equal_1675_s2_q ? patches_down_values_1_q : (or_1679_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_2822;
  assign select_2822 = equal_1675_s2_q ? patches_down_values_2_q : (or_1679_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_2825;
  assign select_2825 = equal_1675_s2_q ? patches_down_values_3_q : (or_1679_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:151
  logic and_2854;
  assign and_2854 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:367
  logic [4:0] select_2859;
  assign select_2859 = or_2762_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:369
  logic [3:0] select_2861;
  assign select_2861 = and_2854 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:160
  logic [4:0] select_3211;
  assign select_3211 = equal_1673_s2_q ? patches_summed_row_column_q : (equal_1675_s2_q ? patches_along_q : patches_summed_row_column_q);
  logic [4:0] select_3217;
  assign select_3217 = equal_1673_s2_q ? patches_summed_down_by_q : (equal_1675_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:476
  logic and_3250;
  assign and_3250 = less_1807 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:480
  logic select_3253;
  assign select_3253 = equal_1810 ? (less_1807 ? (not_1811 & and_3250) : and_3250) : and_3250;
  // hls/stages/patches.hpp:160
  logic select_3256;
  assign select_3256 = equal_1673_s2_q ? (less_1807 ? (not_1809 & select_3253) : select_3253) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3544;
  assign select_3544 = so_s2_q ? (and_2558 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3546;
  assign sum_3546 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3547;
  assign select_3547 = sum_1846[5] ? {1'b1, sum_1846[4:0], region_across_rest_q[2:0]} : sum_3546;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3549;
  assign select_3549 = equal_2249_s2_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3552;
  assign select_3552 = equal_2249_s2_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_465_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_470;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

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
  assign census_memory_re = s2_en & and_495_s2_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1297; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1499;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_right_codes, 28 x 112, DISTANCE 12, hls/stages/patches.hpp:693; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [111:0] patches_right_codes_mem [0:27];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 28; i++) patches_right_codes_mem[i] = 112'h0;
`endif
  logic [4:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = patches_down_by_q + {1'b0, patches_match_row_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & and_1761;
  logic [111:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:694; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s2_en & and_1761;
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:708; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s2_en & and_1817;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1324; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1499;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1446_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1445, select_1444, select_1426, select_1422, select_1411, select_1410, select_1405};
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
  assign best_right_we = s2_en & and_1446_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1463, select_1462, select_1459, select_1458};
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

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s2_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s2_en & and_1752_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_q[23:0], pixel_2};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_score_q <= 8'h0;
      chosen_near_q <= 7'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      patches_along_ends_q <= 1'b0;
      patches_match_row_ends_q <= 1'b0;
      patches_smooth_values_0_q <= 12'h0;
      patches_smooth_values_1_q <= 12'h0;
      patches_smooth_values_2_q <= 12'h0;
      patches_smooth_values_3_q <= 12'h0;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      patches_down_values_2_q <= 11'h0;
      patches_down_values_3_q <= 11'h0;
      patches_down_by_q <= 5'h0;
      patches_along_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_row_column_q <= 5'h0;
      patches_summed_last_q <= 1'b0;
      patches_summed_down_by_q <= 5'h0;
      patches_step_q <= 7'h0;
      patches_read_searches_q <= 1'b0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 7'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
    end else if (s2_en) begin
      chosen_score_q <= less_2358 ? select_1399 : select_1418;
      chosen_near_q <= (select_2360 < select_1438) ? select_1438 : select_2360;
      chosen_place_q <= less_2358 ? {select_1407, not_1406} : 3'h2;
      before_0_q <= select_1418;
      before_1_q <= sum_1149;
      before_2_q <= sum_1397;
      registration_displacement_over_q <= so_s2_q ? sum_2470[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2472;
      registration_slope_row_q <= select_2554;
      registration_slope_change_q <= select_2557;
      registration_slope_q <= so_s2_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_2786_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2786_s2_q & select_2801;
      patches_smooth_values_0_q <= equal_1673_s2_q ? patches_smooth_values_0_q : select_2804;
      patches_smooth_values_1_q <= select_2808;
      patches_smooth_values_2_q <= select_2811;
      patches_smooth_values_3_q <= select_2814;
      patches_down_values_0_q <= equal_1673_s2_q ? patches_down_values_0_q : select_2816;
      patches_down_values_1_q <= equal_1673_s2_q ? patches_down_values_1_q : select_2819;
      patches_down_values_2_q <= equal_1673_s2_q ? patches_down_values_2_q : select_2822;
      patches_down_values_3_q <= equal_1673_s2_q ? patches_down_values_3_q : select_2825;
      patches_down_by_q <= or_2762_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2854});
      patches_along_q <= select_2859;
      patches_match_row_q <= or_2762_s2_q ? 4'h0 : select_2861;
      patches_summed_row_column_q <= select_3211;
      patches_summed_last_q <= not_1674_s2_q & (equal_1675_s2_q & and_2854);
      patches_summed_down_by_q <= select_3217;
      patches_step_q <= or_2762_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3256;
      region_across_rest_q <= select_3544;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3547;
      columns_begin_rest_q <= and_495_s2_q ? select_3549 : columns_begin_rest_q;
      columns_begin_back_q <= and_495_s2_q ? select_3552 : columns_begin_back_q;
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
    middle_sum_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_1_q = 8'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_1_sum_sums_values_1_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_2349;
      middle_sum_columns_values_2_q <= select_2350;
      middle_sum_columns_values_3_q <= select_2351;
      middle_sum_columns_values_4_q <= select_2352;
      middle_sum_columns_values_5_q <= select_2353;
      middle_sum_columns_values_6_q <= select_2354;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_899;
      sums_0_sum_sums_values_0_q <= sum_1149;
      sums_0_sum_sums_values_1_q <= equal_1147 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1397;
      sums_1_sum_sums_values_1_q <= equal_1147 ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic [7:0] x_s3_q;
  logic [5:0] last_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic [11:0] registration_slope_s3_q;
  logic [4:0] patches_band_rows_number_s3_q;
  logic patches_chooses_s3_q;
  logic [4:0] patches_choosing_band_s3_q;
  logic patches_lower_s3_q;
  logic patches_second_s3_q;
  logic [4:0] patches_code_row_s3_q;
  logic patches_column_s3_q;
  logic [4:0] patches_summed_row_column_s3_q;
  logic patches_summed_last_s3_q;
  logic [4:0] patches_summed_down_by_s3_q;
  logic [4:0] patches_step_s3_q;
  logic patches_read_searches_s3_q;
  logic [2:0] select_459_s3_q;
  logic [5:0] select_461_s3_q;
  logic [7:0] select_465_s3_q;
  logic and_469_s3_q;
  logic and_470_s3_q;
  logic equal_475_s3_q;
  logic [5:0] column_s3_q;
  logic and_493_s3_q;
  logic and_495_s3_q;
  logic so_s3_q;
  logic equal_556_s3_q;
  logic equal_1464_s3_q;
  logic not_1465_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1499_s3_q;
  logic [5:0] select_1503_s3_q;
  logic and_1508_s3_q;
  logic and_1577_s3_q;
  logic and_1590_s3_q;
  logic and_1605_s3_q;
  logic [7:0] change_s3_q;
  logic equal_1673_s3_q;
  logic equal_1675_s3_q;
  logic equal_1677_s3_q;
  logic or_1679_s3_q;
  logic [4:0] select_1700_s3_q;
  logic select_1706_s3_q;
  logic [3:0] select_1742_s3_q;
  logic new_row_s3_q;
  logic less_1772_s3_q;
  logic less_1773_s3_q;
  logic less_1782_s3_q;
  logic less_1783_s3_q;
  logic and_1794_s3_q;
  logic or_1798_s3_q;
  logic and_1806_s3_q;
  logic less_1807_s3_q;
  logic equal_1808_s3_q;
  logic not_1809_s3_q;
  logic equal_1810_s3_q;
  logic not_1811_s3_q;
  logic and_1825_s3_q;
  logic select_1827_s3_q;
  logic and_1830_s3_q;
  logic sum_1846_s3_q;
  logic textured_s3_q;
  logic and_1979_s3_q;
  logic equal_2125_s3_q;
  logic equal_2249_s3_q;
  logic less_2483_s3_q;
  logic equal_3173_s3_q;
  logic equal_3257_s3_q;
  logic less_3532_s3_q;
  logic equal_3737_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      x_s3_q <= x_s2_q;
      last_s3_q <= last_s2_q;
      age_s3_q <= age_s2_q[2];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      registration_slope_s3_q <= registration_slope_q[27:16];
      patches_band_rows_number_s3_q <= patches_band_rows_number_s2_q;
      patches_chooses_s3_q <= patches_chooses_s2_q;
      patches_choosing_band_s3_q <= patches_choosing_band_s2_q;
      patches_lower_s3_q <= patches_lower_s2_q;
      patches_second_s3_q <= patches_second_s2_q;
      patches_code_row_s3_q <= patches_code_row_s2_q;
      patches_column_s3_q <= patches_column_s2_q[4];
      patches_summed_row_column_s3_q <= patches_summed_row_column_q;
      patches_summed_last_s3_q <= patches_summed_last_q;
      patches_summed_down_by_s3_q <= patches_summed_down_by_q;
      patches_step_s3_q <= patches_step_q[4:0];
      patches_read_searches_s3_q <= patches_read_searches_q;
      select_459_s3_q <= select_459_s2_q;
      select_461_s3_q <= select_461_s2_q;
      select_465_s3_q <= select_465_s2_q;
      and_469_s3_q <= and_469_s2_q;
      and_470_s3_q <= and_470;
      equal_475_s3_q <= equal_475_s2_q;
      column_s3_q <= column_s2_q;
      and_493_s3_q <= and_493_s2_q;
      and_495_s3_q <= and_495_s2_q;
      so_s3_q <= so_s2_q;
      equal_556_s3_q <= equal_556_s2_q;
      equal_1464_s3_q <= equal_1464_s2_q;
      not_1465_s3_q <= not_1465;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1499_s3_q <= and_1499;
      select_1503_s3_q <= select_1503_s2_q;
      and_1508_s3_q <= not_1465 & (so_s2_q ? and_1497 : (equal_515_s2_q & shift_2[4]));
      and_1577_s3_q <= and_1577_s2_q;
      and_1590_s3_q <= and_1590_s2_q;
      and_1605_s3_q <= shift_2[4] & less_1604_s2_q;
      change_s3_q <= change;
      equal_1673_s3_q <= equal_1673_s2_q;
      equal_1675_s3_q <= equal_1675_s2_q;
      equal_1677_s3_q <= equal_1677_s2_q;
      or_1679_s3_q <= or_1679_s2_q;
      select_1700_s3_q <= select_1700_s2_q;
      select_1706_s3_q <= select_1706_s2_q;
      select_1742_s3_q <= select_1742_s2_q;
      new_row_s3_q <= new_row;
      less_1772_s3_q <= $signed(15'h100) < $signed(sum_1771);
      less_1773_s3_q <= $signed(sum_1771[14:8]) < $signed(7'h7f);
      less_1782_s3_q <= $signed(15'h100) < $signed(difference_1781);
      less_1783_s3_q <= $signed(difference_1781[14:8]) < $signed(7'h7f);
      and_1794_s3_q <= not_1674_s2_q & (not_1676_s2_q & and_1792);
      or_1798_s3_q <= or_1798;
      and_1806_s3_q <= not_1674_s2_q & (not_1676_s2_q & (or_1679_s2_q & and_1803));
      less_1807_s3_q <= less_1807;
      equal_1808_s3_q <= equal_1808;
      not_1809_s3_q <= not_1809;
      equal_1810_s3_q <= equal_1810;
      not_1811_s3_q <= not_1811;
      and_1825_s3_q <= and_1825_s2_q;
      select_1827_s3_q <= select_1827_s2_q;
      and_1830_s3_q <= and_1830_s2_q;
      sum_1846_s3_q <= sum_1846[5];
      textured_s3_q <= textured;
      and_1979_s3_q <= and_1979_s2_q;
      equal_2125_s3_q <= equal_2125_s2_q;
      equal_2249_s3_q <= equal_2249_s2_q;
      less_2483_s3_q <= select_2453 < select_2455;
      equal_3173_s3_q <= patches_match_row_q == 4'h0;
      equal_3257_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3532_s3_q <= less_3532_s2_q;
      equal_3737_s3_q <= equal_3737_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
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
  logic [15:0] patches_chance_q;
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [6:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic [4:0] patches_band_q;
  logic [1:0] patches_fetch_q;
  logic [51:0] patches_codes_low_q;
  logic [55:0] patches_codes_high_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic [47:0] patches_left_row_q;
  logic patches_summed_first_q;
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
  logic [4:0] patches_read_at_q;
  logic patches_read_first_q;
  logic patches_read_above_q;
  logic patches_read_below_q;
  logic [9:0] patches_read_far_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  logic [4:0] patches_peak_row_q;
  logic [9:0] patches_peak_above_q;
  logic [9:0] patches_peak_below_q;
  logic [9:0] patches_peak_far_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
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
  // hls/stages/census.hpp:112
  logic [11:0] select_473;
  assign select_473 = select_459_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_477;
  assign sum_477 = select_473 + (equal_475_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_479;
  assign sum_479 = {4'h0, sample_pair_pixel_1_q} + (select_459_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_481;
  assign sum_481 = sum_479 + (equal_475_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = select_459_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_485;
  assign and_485 = whole & (averager_memory_rdata_q[24] | equal_475_s3_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = select_459_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_489;
  assign and_489 = all_of_skin & (averager_memory_rdata_q[25] | equal_475_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_469_s3_q ? sum_477[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_498;
  assign equal_498 = select_459_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_498 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_501;
  assign select_501 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_469_s3_q ? sum_481[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_498 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_505;
  assign select_505 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_506;
  assign and_506 = and_469_s3_q & and_485;
  // hls/stages/census.hpp:126
  logic select_508;
  assign select_508 = equal_498 ? and_506 : (averager_mask_q & and_506);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_508;
  // hls/stages/census.hpp:206
  logic and_510;
  assign and_510 = and_469_s3_q & and_489;
  // hls/stages/census.hpp:126
  logic select_512;
  assign select_512 = equal_498 ? and_510 : (averager_of_skin_q & and_510);
  // hls/stages/agreement.hpp:263
  logic and_513;
  assign and_513 = sample_pair_whole_s3_q & select_512;
  // hls/stages/census.hpp:294
  logic less_529;
  assign less_529 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_530;
  assign less_530 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_531;
  assign less_531 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_532;
  assign less_532 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_533;
  assign less_533 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_534;
  assign less_534 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_535;
  assign less_535 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_536;
  assign less_536 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_537;
  assign less_537 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_538;
  assign less_538 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_540;
  assign less_540 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_541;
  assign less_541 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_542;
  assign less_542 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_543;
  assign less_543 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_544;
  assign less_544 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_545;
  assign less_545 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_546;
  assign less_546 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_547;
  assign less_547 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_548;
  assign less_548 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_549;
  assign less_549 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_550;
  assign less_550 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_552;
  assign less_552 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_553;
  assign equal_553 = column_s3_q == 6'h0;
  logic [3:0] select_557;
  assign select_557 = equal_556_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_558;
  assign select_558 = equal_553 ? {select_557, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_559;
  assign select_559 = equal_553 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_560;
  assign and_560 = select_558[4] & select_559[3];
  // hls/stages/census.hpp:286
  logic and_562;
  assign and_562 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_564;
  assign and_564 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_562);
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_564;
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
  logic [9:0] difference_587;
  assign difference_587 = {1'b0, select_501} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_588;
  assign xor_588 = difference_587[8:0] ^ {9{difference_587[9]}};
  logic [9:0] sum_589;
  assign sum_589 = {9'h0, difference_587[9]} + {1'b0, xor_588};
  logic [9:0] difference_590;
  assign difference_590 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_591;
  assign xor_591 = difference_590[8:0] ^ {9{difference_590[9]}};
  logic [9:0] sum_592;
  assign sum_592 = {9'h0, difference_590[9]} + {1'b0, xor_591};
  logic [9:0] difference_594;
  assign difference_594 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_595;
  assign xor_595 = difference_594[8:0] ^ {9{difference_594[9]}};
  logic [9:0] sum_596;
  assign sum_596 = {9'h0, difference_594[9]} + {1'b0, xor_595};
  logic [10:0] sum_597;
  assign sum_597 = ({1'b0, sum_589} + {1'b0, sum_592}) + {1'b0, sum_596};
  logic [9:0] difference_598;
  assign difference_598 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_599;
  assign xor_599 = difference_598[8:0] ^ {9{difference_598[9]}};
  logic [9:0] sum_600;
  assign sum_600 = {9'h0, difference_598[9]} + {1'b0, xor_599};
  logic [9:0] difference_602;
  assign difference_602 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_603;
  assign xor_603 = difference_602[8:0] ^ {9{difference_602[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1504;
  assign not_1504 = ~so_s3_q;
  // hls/stages/patches.hpp:303
  logic and_1505;
  assign and_1505 = not_1504 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1069
  logic equal_1509;
  assign equal_1509 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1115
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1070
  logic [1:0] select_1512;
  assign select_1512 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1083
  logic [3:0] select_1514;
  assign select_1514 = equal_1509 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1512});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1515;
  assign sum_1515 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:303
  logic [3:0] select_1516;
  assign select_1516 = equal_1464_s3_q ? select_1514 : {sum_1515, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:184
  logic equal_1517;
  assign equal_1517 = x_s3_q[5:0] == 6'h3f;
  logic equal_1519;
  assign equal_1519 = x_s3_q[5:0] == 6'h3e;
  logic equal_1521;
  assign equal_1521 = x_s3_q[5:0] == 6'h3d;
  logic equal_1523;
  assign equal_1523 = x_s3_q[5:0] == 6'h3c;
  logic equal_1525;
  assign equal_1525 = x_s3_q[5:0] == 6'h3b;
  logic equal_1527;
  assign equal_1527 = x_s3_q[5:0] == 6'h36;
  logic equal_1529;
  assign equal_1529 = x_s3_q[5:0] == 6'h35;
  logic equal_1531;
  assign equal_1531 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1115
  logic and_1535;
  assign and_1535 = (~equal_1525) & ((~equal_1527) & ((~equal_1529) & (~equal_1531)));
  logic and_1539;
  assign and_1539 = (~equal_1517) & ((~equal_1519) & ((~equal_1521) & ((~equal_1523) & and_1535)));
  // hls/stages/agreement.hpp:1070
  logic less_1540;
  assign less_1540 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_1544;
  assign or_1544 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:955
  logic [4:0] sum_1549;
  assign sum_1549 = {1'b0, last_s3_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s3_q[0] & ({2'h0, sum_1549, last_s3_q[1]} < x_s3_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1555;
  assign sum_1555 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1557;
  assign and_1557 = half_ends & ({{3{sum_1555[4]}}, sum_1555} < 8'h3);
  // hls/stages/patches.hpp:303
  logic and_1558;
  assign and_1558 = so_s3_q & and_1557;
  logic select_1559;
  assign select_1559 = equal_1464_s3_q ? (x_s3_q[6] & (equal_1509 ? and_1539 : (less_1540 & (~or_1544)))) : and_1558;
  // hls/stages/registration.hpp:255
  logic not_1561;
  assign not_1561 = ~lower_half_s3_q;
  logic [3:0] select_1562;
  assign select_1562 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1561, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1561};
  // hls/stages/patches.hpp:327
  logic [1:0] select_1591;
  assign select_1591 = and_1590_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1592;
  assign select_1592 = and_1590_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1593;
  assign select_1593 = and_1577_s3_q ? {select_1592, select_1591[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:98
  logic [1:0] select_1594;
  assign select_1594 = and_1577_s3_q ? select_1591 : patches_fetch_q;
  logic equal_1595;
  assign equal_1595 = select_1594 == 2'h0;
  // hls/stages/patches.hpp:75
  logic right_3;
  assign right_3 = {3'h0, last_s3_q[5:1]} < x_s3_q;
  // hls/stages/patches.hpp:303
  logic and_1603;
  assign and_1603 = not_1465_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & right_3)));
  // hls/stages/patches.hpp:76
  logic and_1609;
  assign and_1609 = ({4'h0, last_s3_q[5:1]} < ({1'b0, x_s3_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:77
  logic equal_1610;
  assign equal_1610 = x_s3_q == 8'h0;
  // hls/stages/patches.hpp:74
  logic [9:0] sum_1616;
  assign sum_1616 = {2'h0, x_s3_q} + {{4{shift_2_s3_q[10]}}, shift_2_s3_q[10:5]};
  // hls/stages/patches.hpp:78
  logic [9:0] sum_1618;
  assign sum_1618 = {sum_1616[9], sum_1616[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:963
  logic and_1621;
  assign and_1621 = ($signed(9'h0) < $signed(sum_1616[9:1])) & (~($signed({5'h0, last_s3_q}) < $signed({sum_1618, sum_1616[0]})));
  logic and_1622;
  assign and_1622 = (~(and_1609 | (equal_1610 | (~(x_s3_q < {2'h0, last_s3_q}))))) & and_1621;
  // hls/stages/patches.hpp:303
  logic and_1626;
  assign and_1626 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (and_1605_s3_q & and_1622)));
  logic and_1627;
  assign and_1627 = not_1465_s3_q & and_1626;
  // hls/stages/patches.hpp:133
  logic and_1629;
  assign and_1629 = and_1627 & (~patches_fixed_q);
  // hls/stages/patches.hpp:303
  logic [6:0] select_1632;
  assign select_1632 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  logic [6:0] select_1633;
  assign select_1633 = equal_1464_s3_q ? 7'h0 : select_1632;
  logic [5:0] select_1635;
  assign select_1635 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_1637;
  assign select_1637 = equal_1464_s3_q ? 6'h0 : (so_s3_q ? select_1635 : 6'h0);
  // hls/stages/registration.hpp:83
  logic equal_1638;
  assign equal_1638 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1638 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:210
  logic [7:0] select_1644;
  assign select_1644 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_1645;
  assign select_1645 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_1646;
  assign difference_1646 = {{2{select_1644[7]}}, select_1644[7:1]} - {select_1645[7], select_1645};
  // hls/stages/registration.hpp:208
  logic [6:0] select_1647;
  assign select_1647 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_1648;
  assign select_1648 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_1649;
  assign sum_1649 = {{2{select_1647[6]}}, select_1647} + {select_1648[7], select_1648};
  // hls/stages/registration.hpp:209
  logic [7:0] select_1650;
  assign select_1650 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_1651;
  assign select_1651 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_1652;
  assign sum_1652 = {{2{select_1650[7]}}, select_1650[7:1]} + {select_1651[7], select_1651};
  // hls/stages/registration.hpp:211
  logic [10:0] sum_1653;
  assign sum_1653 = {{3{sum_1649[8]}}, sum_1649[8:1]} + {sum_1652[8], sum_1652, select_1650[0]};
  logic [9:0] sum_1654;
  assign sum_1654 = {difference_1646, select_1644[0]} + {sum_1653[10], sum_1653[10:2]};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1655;
  assign sum_1655 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_1654[9]}}, sum_1654[9:2]};
  // hls/stages/registration.hpp:215
  logic [7:0] select_1658;
  assign select_1658 = ($signed(sum_1655[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1655[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] slope;
  assign slope = equal_1638 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1655[12:7])) ? 8'h7f : select_1658);
  // hls/stages/patches.hpp:303
  logic [7:0] select_1663;
  assign select_1663 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1664;
  assign select_1664 = equal_1464_s3_q ? 8'h0 : select_1663;
  // hls/stages/patches.hpp:306
  logic [21:0] select_1665;
  assign select_1665 = and_1629 ? {select_1664, select_1637, select_1633, and_1627} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:85
  logic equal_1666;
  assign equal_1666 = x_s3_q == {2'h0, last_s3_q};
  // hls/stages/patches.hpp:303
  logic and_1670;
  assign and_1670 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (and_1609 | equal_1666)));
  logic and_1671;
  assign and_1671 = not_1465_s3_q & and_1670;
  // hls/stages/patches.hpp:307
  logic and_1672;
  assign and_1672 = patches_chooses_s3_q & and_1671;
  // hls/stages/patches.hpp:98
  logic [4:0] select_1686;
  assign select_1686 = and_1577_s3_q ? select_1592 : patches_band_q;
  // hls/stages/patches.hpp:100
  logic equal_1687;
  assign equal_1687 = {patches_choosing_band_s3_q, and_1603} == {select_1686, select_1594[1]};
  // hls/stages/patches.hpp:423
  logic [2:0] sum_1763;
  assign sum_1763 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:427
  logic [1:0] sum_1796;
  assign sum_1796 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1833;
  assign select_1833 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:991
  logic or_1836;
  assign or_1836 = select_1833[7] | (~({select_1833[5], select_1833[3], select_1833[1]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_1839;
  assign or_1839 = select_1833[7] | (~({select_1833[6], select_1833[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:989
  logic or_1842;
  assign or_1842 = select_1833[7] | (~(select_1833[6:4] == 3'h0));
  // hls/stages/patches.hpp:303
  logic [5:0] select_1843;
  assign select_1843 = equal_1464_s3_q ? x_s3_q[5:0] : {region_row_q, or_1842, or_1839, or_1836};
  // hls/stages/agreement.hpp:1069
  logic not_1844;
  assign not_1844 = ~equal_1509;
  // hls/stages/agreement.hpp:999
  logic or_1848;
  assign or_1848 = (~sum_1846_s3_q) | equal_1666;
  // hls/stages/patches.hpp:303
  logic and_1851;
  assign and_1851 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_1848));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_1872;
  assign and_1872 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_1873;
  assign select_1873 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_1873);
  // hls/stages/agreement.hpp:960
  logic select_1876;
  assign select_1876 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_1873 ? select_1876 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1196
  logic select_1879;
  assign select_1879 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1200
  logic select_1880;
  assign select_1880 = left_first_s3_q ? select_1879 : read_half_q;
  logic or_1881;
  assign or_1881 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1201
  logic [8:0] select_1882;
  assign select_1882 = or_1881 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1202
  logic [9:0] select_1884;
  assign select_1884 = left_first_s3_q ? 10'h1 : (or_1881 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1205
  logic and_1885;
  assign and_1885 = select_1882[8] & select_1884[9];
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = and_1885 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1216
  logic [5:0] select_1888;
  assign select_1888 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1890;
  assign select_1890 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1888});
  // hls/stages/agreement.hpp:1226
  logic equal_1891;
  assign equal_1891 = seen_x_q == 3'h7;
  logic [7:0] select_1893;
  assign select_1893 = and_1885 ? 8'h0 : (seen_column_q + {7'h0, equal_1891});
  // hls/stages/agreement.hpp:1233
  logic [10:0] index;
  assign index = select_1890 + {3'h0, select_1893};
  // hls/stages/agreement.hpp:1186
  logic [11:0] sum_1895;
  assign sum_1895 = {1'b0, {2{select_1880}}, 2'h0, {2{select_1880}}, 1'b0, {2{select_1880}}, 1'b0, select_1880} + {1'b0, index};
  // hls/stages/agreement.hpp:1199
  logic not_1896;
  assign not_1896 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_1898;
  assign and_1898 = not_1896 & (began_q | and_1885);
  // hls/stages/agreement.hpp:1227
  logic [2:0] select_1900;
  assign select_1900 = and_1885 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1232
  logic and_1902;
  assign and_1902 = and_1898 & (select_1900 == 3'h0);
  logic less_1903;
  assign less_1903 = select_1893 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:424
  logic and_1904;
  assign and_1904 = and_1902 & less_1903;
  logic and_1905;
  assign and_1905 = and_1825_s3_q & and_1904;
  // hls/stages/agreement.hpp:265
  logic select_1907;
  assign select_1907 = and_1825_s3_q ? (left_first_s3_q ? and_1904 : and_1905) : and_1905;
  // hls/stages/agreement.hpp:1052
  logic [7:0] sum_1909;
  assign sum_1909 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1909[7], sum_1909, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1186
  logic [11:0] sum_1911;
  assign sum_1911 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:975
  logic and_1912;
  assign and_1912 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_1913;
  assign and_1913 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_1914;
  assign and_1914 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_1915;
  assign and_1915 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1028
  logic [1:0] sum_1917;
  assign sum_1917 = {1'b0, and_1914} + ({1'b0, textured_s3_q} + {1'b0, and_1915});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1912} + ({2'h0, and_1913} + {1'b0, sum_1917});
  // hls/stages/agreement.hpp:1035
  logic [2:0] select_1920;
  assign select_1920 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1921;
  assign difference_1921 = {1'b0, textured_2} - {1'b0, select_1920};
  logic [4:0] t;
  assign t = {difference_1921[3], difference_1921} + (equal_1610 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:975
  logic [7:0] select_1926;
  assign select_1926 = shift_2_s3_q[0] ? (sum_1846_s3_q ? select_1833 : {select_1833[6:0], 1'b0}) : select_1833;
  // hls/stages/agreement.hpp:991
  logic or_1929;
  assign or_1929 = select_1926[7] | (~({select_1926[5], select_1926[3], select_1926[1]} == 3'h0));
  // hls/stages/agreement.hpp:975
  logic and_1946;
  assign and_1946 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_1947;
  assign and_1947 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_1948;
  assign and_1948 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_1949;
  assign and_1949 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_1951;
  assign sum_1951 = {1'b0, and_1948} + ({1'b0, shown} + {1'b0, and_1949});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1946} + ({2'h0, and_1947} + {1'b0, sum_1951});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_1954;
  assign select_1954 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_1955;
  assign difference_1955 = {1'b0, shown_2} - {1'b0, select_1954};
  logic [4:0] around;
  assign around = {difference_1955[3], difference_1955} + (equal_1610 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_1958;
  assign sum_1958 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:975
  logic and_1962;
  assign and_1962 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_1963;
  assign and_1963 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_1964;
  assign and_1964 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_1965;
  assign and_1965 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1967;
  assign sum_1967 = {1'b0, and_1964} + ({1'b0, near} + {1'b0, and_1965});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1962} + ({2'h0, and_1963} + {1'b0, sum_1967});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1970;
  assign select_1970 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_1971;
  assign difference_1971 = {1'b0, near_2} - {1'b0, select_1970};
  logic [4:0] n;
  assign n = {difference_1971[3], difference_1971} + (equal_1610 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/patches.hpp:303
  logic and_1983;
  assign and_1983 = ends_cell_s3_q & (and_1979_s3_q & (~({1'b0, sum_1549, last_s3_q[1:0]} < x_s3_q)));
  logic and_1985;
  assign and_1985 = not_1465_s3_q & (so_s3_q & and_1983);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2017;
  assign select_2017 = sample_pair_whole_s3_q ? (and_493_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2019;
  assign select_2019 = sample_pair_whole_s3_q ? (and_493_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2038;
  assign select_2038 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2040;
  assign select_2040 = sample_pair_whole_s3_q ? (and_493_s3_q ? select_508 : averager_mask_q) : averager_mask_q;
  logic select_2042;
  assign select_2042 = sample_pair_whole_s3_q ? (and_493_s3_q ? select_512 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2043;
  assign select_2043 = and_495_s3_q ? select_501 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2044;
  assign select_2044 = and_495_s3_q ? select_505 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2046;
  assign select_2046 = and_495_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2047;
  assign select_2047 = and_495_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2048;
  assign select_2048 = and_495_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2049;
  assign select_2049 = and_495_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2050;
  assign select_2050 = and_495_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2051;
  assign select_2051 = and_495_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2052;
  assign select_2052 = and_495_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2053;
  assign select_2053 = and_495_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2054;
  assign select_2054 = and_495_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2055;
  assign select_2055 = and_495_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2056;
  assign select_2056 = and_495_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2057;
  assign select_2057 = and_495_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2058;
  assign select_2058 = and_495_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2059;
  assign select_2059 = and_495_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2060;
  assign select_2060 = and_495_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2061;
  assign select_2061 = and_495_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2062;
  assign select_2062 = and_495_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2063;
  assign select_2063 = and_495_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2064;
  assign select_2064 = and_495_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2065;
  assign select_2065 = and_495_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2066;
  assign select_2066 = and_495_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2067;
  assign select_2067 = and_495_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2068;
  assign select_2068 = and_495_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2069;
  assign select_2069 = and_495_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2070;
  assign select_2070 = and_495_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2071;
  assign select_2071 = and_495_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2072;
  assign select_2072 = and_495_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2073;
  assign select_2073 = and_495_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2074;
  assign select_2074 = and_495_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2075;
  assign select_2075 = and_495_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2076;
  assign select_2076 = and_495_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2077;
  assign select_2077 = and_495_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2078;
  assign select_2078 = and_495_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2079;
  assign select_2079 = and_495_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2080;
  assign select_2080 = and_495_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2081;
  assign select_2081 = and_495_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2082;
  assign select_2082 = and_495_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2083;
  assign select_2083 = and_495_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2084;
  assign select_2084 = and_495_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2085;
  assign select_2085 = and_495_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2086;
  assign select_2086 = and_495_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2087;
  assign select_2087 = and_495_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2088;
  assign select_2088 = and_495_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2089;
  assign select_2089 = and_495_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2090;
  assign select_2090 = and_495_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2091;
  assign select_2091 = and_495_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2092;
  assign select_2092 = and_495_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2093;
  assign select_2093 = and_495_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2094;
  assign select_2094 = and_495_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2095;
  assign select_2095 = and_495_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2096;
  assign select_2096 = and_495_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2097;
  assign select_2097 = and_495_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2098;
  assign select_2098 = and_495_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2100;
  assign difference_2100 = {1'b0, select_505} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2101;
  assign xor_2101 = difference_2100[8:0] ^ {9{difference_2100[9]}};
  logic [9:0] sum_2102;
  assign sum_2102 = {9'h0, difference_2100[9]} + {1'b0, xor_2101};
  logic [9:0] difference_2103;
  assign difference_2103 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2104;
  assign xor_2104 = difference_2103[8:0] ^ {9{difference_2103[9]}};
  logic [9:0] sum_2105;
  assign sum_2105 = {9'h0, difference_2103[9]} + {1'b0, xor_2104};
  logic [9:0] difference_2107;
  assign difference_2107 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2108;
  assign xor_2108 = difference_2107[8:0] ^ {9{difference_2107[9]}};
  logic [9:0] sum_2109;
  assign sum_2109 = {9'h0, difference_2107[9]} + {1'b0, xor_2108};
  logic [10:0] sum_2110;
  assign sum_2110 = ({1'b0, sum_2102} + {1'b0, sum_2105}) + {1'b0, sum_2109};
  logic [9:0] difference_2111;
  assign difference_2111 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2112;
  assign xor_2112 = difference_2111[8:0] ^ {9{difference_2111[9]}};
  logic [9:0] sum_2113;
  assign sum_2113 = {9'h0, difference_2111[9]} + {1'b0, xor_2112};
  logic [9:0] difference_2115;
  assign difference_2115 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2116;
  assign xor_2116 = difference_2115[8:0] ^ {9{difference_2115[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2146;
  assign difference_2146 = {1'b0, select_501} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2146[9]} + (difference_2146[8:0] ^ {9{difference_2146[9]}});
  logic [9:0] difference_2158;
  assign difference_2158 = {1'b0, select_505} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2158[9]} + (difference_2158[8:0] ^ {9{difference_2158[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2365;
  assign and_2365 = and_495_s3_q & (equal_556_s3_q & equal_2249_s3_q);
  // hls/stages/patches.hpp:303
  logic and_2369;
  assign and_2369 = not_1465_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:975
  logic and_2389;
  assign and_2389 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2390;
  assign and_2390 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2391;
  assign and_2391 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2392;
  assign and_2392 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_2394;
  assign sum_2394 = {1'b0, and_2391} + ({1'b0, explained} + {1'b0, and_2392});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2389} + ({2'h0, and_2390} + {1'b0, sum_2394});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_2397;
  assign select_2397 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2398;
  assign difference_2398 = {1'b0, explained_2} - {1'b0, select_2397};
  logic [4:0] e;
  assign e = {difference_2398[3], difference_2398} + (equal_1610 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1043
  logic [5:0] sum_2401;
  assign sum_2401 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:303
  logic and_2430;
  assign and_2430 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2474;
  assign select_2474 = equal_1464_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2475;
  assign equal_2475 = slot_s3_q == 3'h4;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2482;
  assign sum_2482 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2484;
  assign difference_2484 = {sum_2482, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2485;
  assign select_2485 = less_2483_s3_q ? difference_2484 : {sum_2482, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2486;
  assign select_2486 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2482, shift_2_s3_q[11], 5'h0} : select_2485;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2486[7]}}, select_2486} - {sum_1654[9], sum_1654, sum_1653[1]};
  // hls/stages/registration.hpp:215
  logic [11:0] select_2489;
  assign select_2489 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2489[11:7])) ? 12'h7f : select_2489;
  // hls/stages/registration.hpp:202
  logic [12:0] difference_2510;
  assign difference_2510 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:106
  logic and_2512;
  assign and_2512 = and_1605_s3_q & ($signed(difference_2510) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:202
  logic less_2525;
  assign less_2525 = $signed(difference_2510) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:303
  logic select_2533;
  assign select_2533 = so_s3_q ? (equal_2475 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2536;
  assign select_2536 = so_s3_q ? (equal_1638 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:266
  logic [3:0] select_2541;
  assign select_2541 = (sum_1515 == 2'h2) ? (registration_fresh_q & (~select_1562)) : registration_fresh_q;
  // hls/stages/patches.hpp:303
  logic [3:0] select_2543;
  assign select_2543 = so_s3_q ? (and_1557 ? select_2541 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:239
  logic [3:0] select_2545;
  assign select_2545 = and_2365 ? 4'hf : (equal_1464_s3_q ? registration_fresh_q : select_2543);
  // hls/stages/agreement.hpp:1070
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1512;
  // hls/stages/registration.hpp:255
  logic not_2566;
  assign not_2566 = ~quarter_2[1];
  logic [3:0] select_2567;
  assign select_2567 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2566, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2566};
  // hls/stages/patches.hpp:68
  logic parity_2701;
  assign parity_2701 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2702;
  assign select_2702 = equal_2249_s3_q ? {patches_chance_q[14:0], parity_2701} : patches_chance_q;
  // hls/stages/patches.hpp:308
  logic not_2704;
  assign not_2704 = ~and_1671;
  // hls/stages/patches.hpp:80
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:82
  logic [4:0] select_2706;
  assign select_2706 = right_3 ? last_s3_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2706};
  // hls/stages/patches.hpp:303
  logic and_2712;
  assign and_2712 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (~(x_s3_q < {2'h0, from}))));
  // hls/stages/patches.hpp:133
  logic and_2716;
  assign and_2716 = not_2704 & (patches_fixed_q | ((not_1465_s3_q & and_2712) & and_1629));
  // hls/stages/patches.hpp:101
  logic not_2729;
  assign not_2729 = ~select_1594[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2731;
  assign select_2731 = sample_pair_whole_s3_q ? (equal_1595 ? select_1594 : {not_2729, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:443
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_right_codes_rdata_q[55:0] : {patches_codes_high_q[3:0], patches_codes_low_q};
  // hls/stages/patches.hpp:160
  logic [51:0] select_2828;
  assign select_2828 = or_1679_s3_q ? {patches_codes_high_q[3:0], patches_codes_low_q[51:4]} : patches_codes_low_q;
  logic [51:0] select_2830;
  assign select_2830 = equal_1673_s3_q ? patches_codes_low_q : (equal_1675_s3_q ? other[55:4] : select_2828);
  // hls/stages/patches.hpp:443
  logic [55:0] select_2831;
  assign select_2831 = new_row_s3_q ? patches_right_codes_rdata_q[111:56] : {4'h0, patches_codes_high_q[55:4]};
  // hls/stages/patches.hpp:160
  logic [55:0] select_2832;
  assign select_2832 = or_1679_s3_q ? {less_1783_s3_q, less_1782_s3_q, less_1773_s3_q, less_1772_s3_q, patches_codes_high_q[55:4]} : patches_codes_high_q;
  logic [55:0] select_2834;
  assign select_2834 = equal_1673_s3_q ? patches_codes_high_q : (equal_1675_s3_q ? select_2831 : select_2832);
  // hls/stages/count_bits.hpp:24
  logic parity_2839;
  assign parity_2839 = ^{less_1783_s3_q, less_1782_s3_q, less_1773_s3_q, less_1772_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_2843;
  assign or_2843 = ({less_1773_s3_q, less_1772_s3_q} == 2'h3) | (less_1782_s3_q & (less_1773_s3_q | less_1772_s3_q));
  logic and_2844;
  assign and_2844 = less_1783_s3_q & (^{less_1782_s3_q, less_1773_s3_q, less_1772_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2845;
  assign xor_2845 = or_2843 ^ and_2844;
  // hls/stages/count_bits.hpp:27
  logic and_2846;
  assign and_2846 = or_2843 & and_2844;
  // hls/stages/patches.hpp:429
  logic [2:0] select_2848;
  assign select_2848 = or_1798_s3_q ? 3'h0 : (patches_column_s3_q ? 3'h0 : {and_2846, xor_2845, parity_2839});
  // hls/stages/patches.hpp:160
  logic [2:0] select_2851;
  assign select_2851 = equal_1673_s3_q ? 3'h0 : (equal_1675_s3_q ? 3'h0 : (or_1679_s3_q ? select_2848 : 3'h0));
  // hls/stages/patches.hpp:143
  logic [9:0] sum_2853;
  assign sum_2853 = {7'h0, patches_set_q} + (equal_1677_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:444
  logic [47:0] select_2863;
  assign select_2863 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:160
  logic [47:0] select_2865;
  assign select_2865 = equal_1673_s3_q ? patches_left_row_q : (equal_1675_s3_q ? select_2863 : patches_left_row_q);
  // hls/stages/patches.hpp:444
  logic [47:0] bits;
  assign bits = select_2863 ^ other[47:0];
  // hls/stages/count_bits.hpp:24
  logic xor_2869;
  assign xor_2869 = bits[17] ^ (^{select_2863[16:15], other[16:15]});
  logic xor_2872;
  assign xor_2872 = bits[11] ^ (^{select_2863[10:9], other[10:9]});
  logic xor_2875;
  assign xor_2875 = bits[14] ^ (^{select_2863[13:12], other[13:12]});
  logic xor_2878;
  assign xor_2878 = xor_2869 ^ (^{select_2863[14:9], other[14:9]});
  logic xor_2881;
  assign xor_2881 = bits[47] ^ (^{select_2863[46:45], other[46:45]});
  logic xor_2884;
  assign xor_2884 = bits[8] ^ (^{select_2863[7:6], other[7:6]});
  logic xor_2887;
  assign xor_2887 = bits[2] ^ (^{select_2863[1:0], other[1:0]});
  logic xor_2890;
  assign xor_2890 = bits[5] ^ (^{select_2863[4:3], other[4:3]});
  logic xor_2893;
  assign xor_2893 = xor_2884 ^ (^{select_2863[5:0], other[5:0]});
  logic parity_2895;
  assign parity_2895 = ^{select_2863[47:45], select_2863[8:0], other[47:45], other[8:0]};
  logic xor_2896;
  assign xor_2896 = xor_2878 ^ parity_2895;
  logic xor_2899;
  assign xor_2899 = bits[44] ^ (^{select_2863[43:42], other[43:42]});
  logic xor_2902;
  assign xor_2902 = bits[38] ^ (^{select_2863[37:36], other[37:36]});
  logic xor_2905;
  assign xor_2905 = bits[41] ^ (^{select_2863[40:39], other[40:39]});
  logic xor_2911;
  assign xor_2911 = bits[26] ^ (^{select_2863[25:24], other[25:24]});
  logic xor_2914;
  assign xor_2914 = bits[20] ^ (^{select_2863[19:18], other[19:18]});
  logic xor_2917;
  assign xor_2917 = bits[23] ^ (^{select_2863[22:21], other[22:21]});
  logic xor_2920;
  assign xor_2920 = xor_2911 ^ (^{select_2863[23:18], other[23:18]});
  logic xor_2923;
  assign xor_2923 = bits[35] ^ (^{select_2863[34:33], other[34:33]});
  logic xor_2926;
  assign xor_2926 = bits[29] ^ (^{select_2863[28:27], other[28:27]});
  logic xor_2929;
  assign xor_2929 = bits[32] ^ (^{select_2863[31:30], other[31:30]});
  logic xor_2932;
  assign xor_2932 = xor_2923 ^ (^{select_2863[32:27], other[32:27]});
  logic xor_2933;
  assign xor_2933 = xor_2920 ^ xor_2932;
  // hls/stages/count_bits.hpp:25
  logic or_2941;
  assign or_2941 = (xor_2872 & xor_2875) | (xor_2869 & (xor_2872 | xor_2875));
  logic or_2945;
  assign or_2945 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_2949;
  assign or_2949 = (xor_2887 & xor_2890) | (xor_2884 & (xor_2887 | xor_2890));
  // hls/stages/count_bits.hpp:23
  logic or_2956;
  assign or_2956 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_2960;
  assign or_2960 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_2964;
  assign or_2964 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_2967;
  assign parity_2967 = ^{or_2964, or_2960, or_2956};
  // hls/stages/count_bits.hpp:23
  logic or_2971;
  assign or_2971 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_2975;
  assign or_2975 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_2979;
  assign or_2979 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_2982;
  assign parity_2982 = ^{or_2979, or_2975, or_2971};
  logic parity_2985;
  assign parity_2985 = ^{or_2979, or_2975, or_2971, or_2964, or_2960, or_2956, or_2949, or_2945, or_2941};
  // hls/stages/count_bits.hpp:23
  logic or_2989;
  assign or_2989 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_2993;
  assign or_2993 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_2997;
  assign or_2997 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3005;
  assign or_3005 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3009;
  assign or_3009 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3013;
  assign or_3013 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3016;
  assign parity_3016 = ^{or_3013, or_3009, or_3005};
  // hls/stages/count_bits.hpp:23
  logic or_3020;
  assign or_3020 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3024;
  assign or_3024 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3028;
  assign or_3028 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3031;
  assign parity_3031 = ^{or_3028, or_3024, or_3020};
  logic parity_3034;
  assign parity_3034 = ^{or_3028, or_3024, or_3020, or_3013, or_3009, or_3005, or_2997, or_2993, or_2989};
  // hls/stages/count_bits.hpp:25
  logic or_3038;
  assign or_3038 = (xor_2902 & xor_2905) | (xor_2899 & (xor_2902 | xor_2905));
  logic or_3042;
  assign or_3042 = (xor_2914 & xor_2917) | (xor_2911 & (xor_2914 | xor_2917));
  logic or_3046;
  assign or_3046 = (xor_2926 & xor_2929) | (xor_2923 & (xor_2926 | xor_2929));
  // hls/stages/count_bits.hpp:24
  logic parity_3049;
  assign parity_3049 = ^{or_3046, or_3042, or_3038};
  // hls/stages/count_bits.hpp:25
  logic and_3050;
  assign and_3050 = xor_2896 & (^{xor_2933, select_2863[44:36], other[44:36]});
  logic or_3054;
  assign or_3054 = (xor_2881 & xor_2893) | (xor_2878 & (xor_2881 | xor_2893));
  logic and_3057;
  assign and_3057 = (xor_2899 ^ (^{select_2863[41:36], other[41:36]})) & (xor_2920 | xor_2932);
  logic or_3058;
  assign or_3058 = (xor_2920 & xor_2932) | and_3057;
  // hls/stages/count_bits.hpp:24
  logic parity_3061;
  assign parity_3061 = ^{or_3058, or_3054, and_3050};
  logic parity_3064;
  assign parity_3064 = ^{or_3058, or_3054, and_3050, or_3046, or_3042, or_3038, or_3028, or_3024, or_3020, or_3013, or_3009, or_3005, or_2997, or_2993, or_2989};
  logic parity_3066;
  assign parity_3066 = ^{or_3058, or_3054, and_3050, or_3046, or_3042, or_3038, or_3028, or_3024, or_3020, or_3013, or_3009, or_3005, or_2997, or_2993, or_2989, or_2979, or_2975, or_2971, or_2964, or_2960, or_2956, or_2949, or_2945, or_2941};
  // hls/stages/count_bits.hpp:25
  logic and_3067;
  assign and_3067 = parity_2985 & parity_3064;
  logic or_3071;
  assign or_3071 = (parity_2967 & parity_2982) | ((^{or_2949, or_2945, or_2941}) & (parity_2967 | parity_2982));
  logic or_3075;
  assign or_3075 = (parity_3049 & parity_3061) | (parity_3034 & (parity_3049 | parity_3061));
  logic or_3082;
  assign or_3082 = (parity_3016 & parity_3031) | ((^{or_2997, or_2993, or_2989}) & (parity_3016 | parity_3031));
  logic or_3086;
  assign or_3086 = (or_3042 & or_3046) | (or_3038 & (or_3042 | or_3046));
  logic or_3090;
  assign or_3090 = (or_3054 & or_3058) | (and_3050 & (or_3054 | or_3058));
  // hls/stages/count_bits.hpp:23
  logic or_3097;
  assign or_3097 = (or_2993 & or_2997) | (or_2989 & (or_2993 | or_2997));
  // hls/stages/count_bits.hpp:25
  logic or_3101;
  assign or_3101 = (or_3009 & or_3013) | (or_3005 & (or_3009 | or_3013));
  logic or_3105;
  assign or_3105 = (or_3024 & or_3028) | (or_3020 & (or_3024 | or_3028));
  // hls/stages/count_bits.hpp:24
  logic parity_3108;
  assign parity_3108 = ^{or_3105, or_3101, or_3097};
  // hls/stages/count_bits.hpp:23
  logic or_3112;
  assign or_3112 = (or_2945 & or_2949) | (or_2941 & (or_2945 | or_2949));
  // hls/stages/count_bits.hpp:25
  logic or_3116;
  assign or_3116 = (or_2960 & or_2964) | (or_2956 & (or_2960 | or_2964));
  logic or_3120;
  assign or_3120 = (or_2975 & or_2979) | (or_2971 & (or_2975 | or_2979));
  // hls/stages/count_bits.hpp:24
  logic parity_3123;
  assign parity_3123 = ^{or_3120, or_3116, or_3112};
  logic parity_3126;
  assign parity_3126 = ^{or_3120, or_3116, or_3112, or_3105, or_3101, or_3097, or_3090, or_3086, or_3082};
  logic parity_3128;
  assign parity_3128 = ^{or_3120, or_3116, or_3112, or_3105, or_3101, or_3097, or_3090, or_3086, or_3082, or_3075, or_3071, and_3067};
  // hls/stages/count_bits.hpp:25
  logic or_3132;
  assign or_3132 = (or_3086 & or_3090) | (or_3082 & (or_3086 | or_3090));
  logic or_3136;
  assign or_3136 = (or_3101 & or_3105) | (or_3097 & (or_3101 | or_3105));
  logic or_3140;
  assign or_3140 = (or_3116 & or_3120) | (or_3112 & (or_3116 | or_3120));
  // hls/stages/count_bits.hpp:24
  logic parity_3143;
  assign parity_3143 = ^{or_3140, or_3136, or_3132};
  // hls/stages/count_bits.hpp:25
  logic and_3144;
  assign and_3144 = (^{or_3075, or_3071, and_3067}) & parity_3126;
  logic or_3148;
  assign or_3148 = (or_3071 & or_3075) | (and_3067 & (or_3071 | or_3075));
  logic or_3152;
  assign or_3152 = (parity_3108 & parity_3123) | ((^{or_3090, or_3086, or_3082}) & (parity_3108 | parity_3123));
  // hls/stages/count_bits.hpp:24
  logic parity_3155;
  assign parity_3155 = ^{or_3152, or_3148, and_3144};
  // hls/stages/count_bits.hpp:25
  logic and_3157;
  assign and_3157 = parity_3143 & parity_3155;
  logic or_3161;
  assign or_3161 = (or_3136 & or_3140) | (or_3132 & (or_3136 | or_3140));
  logic or_3165;
  assign or_3165 = (or_3148 & or_3152) | (and_3144 & (or_3148 | or_3152));
  // hls/stages/patches.hpp:160
  logic select_3213;
  assign select_3213 = equal_1673_s3_q ? patches_summed_first_q : (equal_1675_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:476
  logic [9:0] select_3220;
  assign select_3220 = less_1807_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:480
  logic [9:0] select_3223;
  assign select_3223 = equal_1810_s3_q ? (less_1807_s3_q ? (equal_1810_s3_q ? 10'h0 : select_3220) : 10'h0) : select_3220;
  logic [9:0] select_3225;
  assign select_3225 = less_1807_s3_q ? (equal_1808_s3_q ? 10'h0 : select_3223) : select_3223;
  // hls/stages/patches.hpp:476
  logic [4:0] select_3227;
  assign select_3227 = less_1807_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:480
  logic [4:0] select_3230;
  assign select_3230 = equal_1810_s3_q ? (less_1807_s3_q ? (equal_1810_s3_q ? 5'h0 : select_3227) : 5'h0) : select_3227;
  logic [4:0] select_3232;
  assign select_3232 = less_1807_s3_q ? (equal_1808_s3_q ? 5'h0 : select_3230) : select_3230;
  // hls/stages/patches.hpp:476
  logic [4:0] select_3234;
  assign select_3234 = less_1807_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:480
  logic [4:0] select_3237;
  assign select_3237 = equal_1810_s3_q ? (less_1807_s3_q ? (equal_1810_s3_q ? 5'h0 : select_3234) : 5'h0) : select_3234;
  logic [4:0] select_3239;
  assign select_3239 = less_1807_s3_q ? (equal_1808_s3_q ? 5'h0 : select_3237) : select_3237;
  // hls/stages/patches.hpp:476
  logic and_3242;
  assign and_3242 = less_1807_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:480
  logic select_3245;
  assign select_3245 = equal_1810_s3_q ? (less_1807_s3_q ? (not_1811_s3_q & and_3242) : and_3242) : and_3242;
  // hls/stages/patches.hpp:160
  logic select_3248;
  assign select_3248 = equal_1673_s3_q ? (less_1807_s3_q ? (not_1809_s3_q & select_3245) : select_3245) : patches_read_first_q;
  // hls/stages/patches.hpp:154
  logic or_3259;
  assign or_3259 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3260;
  assign and_3260 = patches_read_searches_s3_q & or_3259;
  // hls/stages/patches.hpp:460
  logic [4:0] select_3261;
  assign select_3261 = and_3260 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:467
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3261};
  // hls/stages/patches.hpp:476
  logic and_3265;
  assign and_3265 = less_1807_s3_q & (equal_3257_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:480
  logic select_3268;
  assign select_3268 = equal_1810_s3_q ? (less_1807_s3_q ? (not_1811_s3_q & and_3265) : and_3265) : and_3265;
  // hls/stages/patches.hpp:160
  logic select_3271;
  assign select_3271 = equal_1673_s3_q ? (less_1807_s3_q ? (not_1809_s3_q & select_3268) : select_3268) : patches_read_above_q;
  // hls/stages/patches.hpp:476
  logic and_3274;
  assign and_3274 = less_1807_s3_q & (equal_3257_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:480
  logic select_3277;
  assign select_3277 = equal_1810_s3_q ? (less_1807_s3_q ? (not_1811_s3_q & and_3274) : and_3274) : and_3274;
  // hls/stages/patches.hpp:160
  logic select_3280;
  assign select_3280 = equal_1673_s3_q ? (less_1807_s3_q ? (not_1809_s3_q & select_3277) : select_3277) : patches_read_below_q;
  // hls/stages/patches.hpp:473
  logic [6:0] sum_3281;
  assign sum_3281 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:474
  logic [9:0] select_3284;
  assign select_3284 = (equal_3257_s3_q & ({sum_3281[6], sum_3281} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:476
  logic [9:0] select_3285;
  assign select_3285 = less_1807_s3_q ? select_3284 : 10'h3ff;
  // hls/stages/patches.hpp:477
  logic [9:0] select_3287;
  assign select_3287 = less_1807_s3_q ? (equal_1810_s3_q ? 10'h3ff : select_3285) : 10'h3ff;
  // hls/stages/patches.hpp:480
  logic [9:0] select_3288;
  assign select_3288 = equal_1810_s3_q ? select_3287 : select_3285;
  logic [9:0] select_3290;
  assign select_3290 = less_1807_s3_q ? (equal_1808_s3_q ? 10'h3ff : select_3288) : select_3288;
  // hls/stages/patches.hpp:459
  logic [14:0] select_3292;
  assign select_3292 = and_3260 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:160
  logic [9:0] select_3293;
  assign select_3293 = equal_1673_s3_q ? select_3292[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3294;
  assign select_3294 = equal_1673_s3_q ? select_3292[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:461
  logic [9:0] select_3296;
  assign select_3296 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:462
  logic [9:0] select_3298;
  assign select_3298 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:463
  logic [9:0] select_3301;
  assign select_3301 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3302;
  assign select_3302 = patches_read_first_q ? patches_read_far_q : select_3301;
  // hls/stages/patches.hpp:514
  logic [9:0] difference_3305;
  assign difference_3305 = select_3302 - select_3292[9:0];
  // hls/stages/patches.hpp:499
  logic less_3335;
  assign less_3335 = select_3296 < select_3298;
  // hls/stages/patches.hpp:505
  logic [1:0] sum_3336;
  assign sum_3336 = select_3261[4:3] + 2'h3;
  // hls/stages/patches.hpp:500
  logic [9:0] high;
  assign high = less_3335 ? select_3298 : select_3296;
  logic [9:0] low;
  assign low = (select_3298 < select_3296) ? select_3298 : select_3296;
  // hls/stages/patches.hpp:501
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3292[9:0];
  // hls/stages/patches.hpp:503
  logic not_3343;
  assign not_3343 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3344;
  assign sum_3344 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3346;
  assign not_3346 = ~({eight, 3'h0} < {1'b0, sum_3344, fall[0]});
  logic [1:0] sum_3347;
  assign sum_3347 = {1'b0, not_3343} + {1'b0, not_3346};
  // hls/stages/patches.hpp:504
  logic [10:0] sum_3348;
  assign sum_3348 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3350;
  assign not_3350 = ~({eight, 3'h0} < {sum_3348, fall[1:0]});
  logic not_3353;
  assign not_3353 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3354;
  assign sum_3354 = {1'b0, not_3350} + {1'b0, not_3353};
  // hls/stages/patches.hpp:503
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3347} + {1'b0, sum_3354};
  // hls/stages/patches.hpp:506
  logic [7:0] select_3357;
  assign select_3357 = less_3335 ? ({sum_3336, select_3261[2:0], 3'h0} - {5'h0, fraction}) : {sum_3336, select_3261[2:0], fraction};
  // hls/stages/agreement.hpp:1085
  logic equal_3513;
  assign equal_3513 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:303
  logic select_3529;
  assign select_3529 = equal_1464_s3_q ? shown_shown_q : (so_s3_q ? select_1873 : shown_shown_q);
  logic select_3531;
  assign select_3531 = equal_1464_s3_q ? shown_nearer_q : (so_s3_q ? select_1876 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3533;
  assign sum_3533 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3535;
  assign select_3535 = less_3532_s3_q ? (sum_3533[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3537;
  assign select_3537 = equal_2249_s3_q ? (equal_556_s3_q ? 3'h0 : select_3535) : region_row_q;
  // hls/stages/patches.hpp:303
  logic [7:0] select_3542;
  assign select_3542 = equal_1464_s3_q ? select_1833 : (so_s3_q ? (ends_cell_s3_q ? select_1926 : select_1833) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3556;
  assign select_3556 = equal_556_s3_q ? {{2{difference_3554[6]}}, difference_3554} : (less_3532_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3558;
  assign select_3558 = and_495_s3_q ? (equal_2249_s3_q ? select_3556 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_3560;
  assign select_3560 = equal_556_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3562;
  assign select_3562 = and_495_s3_q ? (equal_2249_s3_q ? select_3560 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3563;
  assign sum_3563 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3564;
  assign select_3564 = sum_3533[7] ? {1'b1, sum_3533[6:0], region_down_rest_q[0]} : sum_3563;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3533[7];
  // hls/stages/agreement.hpp:447
  logic select_3568;
  assign select_3568 = equal_2249_s3_q ? (equal_556_s3_q | (less_3532_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_3573;
  assign or_3573 = segment_starts_q | not_1504;
  // hls/stages/agreement.hpp:975
  logic select_3576;
  assign select_3576 = shift_2_s3_q[0] ? (sum_1846_s3_q ? (equal_1666 & or_1848) : or_1848) : or_3573;
  // hls/stages/patches.hpp:303
  logic select_3579;
  assign select_3579 = equal_1464_s3_q ? or_3573 : (so_s3_q ? (ends_cell_s3_q ? select_3576 : or_3573) : or_3573);
  logic [2:0] select_3653;
  assign select_3653 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_3655;
  assign select_3655 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3657;
  assign select_3657 = equal_1464_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3655 : box_textured_columns_values_1_q);
  logic [2:0] select_3658;
  assign select_3658 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3660;
  assign select_3660 = equal_1464_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3658 : box_textured_columns_values_2_q);
  logic [2:0] select_3661;
  assign select_3661 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3663;
  assign select_3663 = equal_1464_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3661 : box_textured_columns_values_3_q);
  logic [2:0] select_3664;
  assign select_3664 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3666;
  assign select_3666 = equal_1464_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3664 : box_textured_columns_values_4_q);
  logic [4:0] select_3668;
  assign select_3668 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3671;
  assign select_3671 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3673;
  assign select_3673 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3675;
  assign select_3675 = equal_1464_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3673 : box_explained_columns_values_1_q);
  logic [2:0] select_3676;
  assign select_3676 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3678;
  assign select_3678 = equal_1464_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3676 : box_explained_columns_values_2_q);
  logic [2:0] select_3679;
  assign select_3679 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3681;
  assign select_3681 = equal_1464_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3679 : box_explained_columns_values_3_q);
  logic [2:0] select_3682;
  assign select_3682 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3684;
  assign select_3684 = equal_1464_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3682 : box_explained_columns_values_4_q);
  logic [4:0] select_3686;
  assign select_3686 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3687;
  assign select_3687 = equal_1464_s3_q ? box_explained_sum_sums_values_0_q : select_3686;
  logic [2:0] select_3689;
  assign select_3689 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3691;
  assign select_3691 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3693;
  assign select_3693 = equal_1464_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3691 : box_shown_columns_values_1_q);
  logic [2:0] select_3694;
  assign select_3694 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3696;
  assign select_3696 = equal_1464_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3694 : box_shown_columns_values_2_q);
  logic [2:0] select_3697;
  assign select_3697 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3699;
  assign select_3699 = equal_1464_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3697 : box_shown_columns_values_3_q);
  logic [2:0] select_3700;
  assign select_3700 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3702;
  assign select_3702 = equal_1464_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3700 : box_shown_columns_values_4_q);
  logic [4:0] select_3704;
  assign select_3704 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3707;
  assign select_3707 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3709;
  assign select_3709 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3711;
  assign select_3711 = equal_1464_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3709 : box_nearer_columns_values_1_q);
  logic [2:0] select_3712;
  assign select_3712 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3714;
  assign select_3714 = equal_1464_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3712 : box_nearer_columns_values_2_q);
  logic [2:0] select_3715;
  assign select_3715 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3717;
  assign select_3717 = equal_1464_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3715 : box_nearer_columns_values_3_q);
  logic [2:0] select_3718;
  assign select_3718 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3720;
  assign select_3720 = equal_1464_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3718 : box_nearer_columns_values_4_q);
  logic [4:0] select_3722;
  assign select_3722 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3725;
  assign select_3725 = so_s3_q ? (ends_cell_s3_q ? and_1914 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3728;
  assign select_3728 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3730;
  assign select_3730 = equal_1464_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3728 : centres_values_0_of_skin_q);
  logic select_3731;
  assign select_3731 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3733;
  assign select_3733 = equal_1464_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3731 : centres_values_1_textured_q);
  logic select_3734;
  assign select_3734 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3736;
  assign select_3736 = equal_1464_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3734 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [10:0] select_3740;
  assign select_3740 = equal_2249_s3_q ? (equal_3737_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [5:0] select_3743;
  assign select_3743 = and_495_s3_q ? (equal_2249_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1196
  logic xor_3744;
  assign xor_3744 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:424
  logic select_3746;
  assign select_3746 = and_1825_s3_q ? (left_first_s3_q ? xor_3744 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:265
  logic select_3748;
  assign select_3748 = and_1825_s3_q ? (left_first_s3_q ? xor_3744 : select_3746) : write_half_q;
  logic select_3750;
  assign select_3750 = left_first_s3_q ? select_1879 : (and_1825_s3_q ? select_1880 : read_half_q);
  logic and_3754;
  assign and_3754 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3763;
  assign select_3763 = left_first_s3_q ? 10'h1 : (and_1825_s3_q ? select_1884 : rows_passed_q);
  logic [8:0] select_3766;
  assign select_3766 = left_first_s3_q ? {select_1882[7:0], or_1881} : (and_1825_s3_q ? {select_1882[7:0], or_1881} : columns_passed_q);
  logic select_3769;
  assign select_3769 = left_first_s3_q ? marks_last_s3_q : (and_1825_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_3772;
  assign select_3772 = left_first_s3_q ? and_1898 : (and_1825_s3_q ? and_1898 : began_q);
  logic [2:0] select_3775;
  assign select_3775 = left_first_s3_q ? select_1900 : (and_1825_s3_q ? select_1900 : seen_x_q);
  // hls/stages/agreement.hpp:1225
  logic [2:0] select_3780;
  assign select_3780 = left_first_s3_q ? 3'h0 : (and_1885 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:265
  logic [2:0] select_3782;
  assign select_3782 = left_first_s3_q ? 3'h0 : (and_1825_s3_q ? select_3780 : seen_y_q);
  logic [7:0] select_3785;
  assign select_3785 = left_first_s3_q ? select_1893 : (and_1825_s3_q ? select_1893 : seen_column_q);
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3791;
  assign select_3791 = left_first_s3_q ? select_3789 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:265
  logic [7:0] select_3793;
  assign select_3793 = left_first_s3_q ? select_3789 : (and_1825_s3_q ? select_3791 : seen_rows_left_q);
  // hls/stages/agreement.hpp:422
  logic and_3798;
  assign and_3798 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:265
  logic select_3800;
  assign select_3800 = left_first_s3_q ? and_3798 : (and_1825_s3_q ? and_3798 : at_cell_end_q);
  logic select_3803;
  assign select_3803 = left_first_s3_q ? next_row : (and_1825_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_3806;
  assign select_3806 = left_first_s3_q ? 11'h0 : (and_1825_s3_q ? select_1890 : seen_base_q);
  // hls/stages/registration.hpp:255
  logic not_3868;
  assign not_3868 = ~quarter[1];
  logic [3:0] select_3869;
  assign select_3869 = quarter[0] ? {quarter[1], 1'b0, not_3868, 1'b0} : {1'b0, quarter[1], 1'b0, not_3868};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:273; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1516;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_1559;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:665; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1593;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_1595));
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1317; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1843;
  logic regions_re;
  assign regions_re = s3_en & (equal_1464_s3_q ? (x_s3_q[6] & not_1844) : and_1851);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1328; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1895;
  logic map_re;
  assign map_re = s3_en & select_1907;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_465_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_470_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_489, and_485, sum_481, sum_477};
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

  // Memory census_memory, write
  logic [5:0] census_memory_waddr;
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_495_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_513, whole_2, select_505, select_501};
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
  assign shown_right_waddr = select_1503_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1508_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1505, not_1504};
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

  // Memory patches_right_codes, write
  logic [4:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1763, patches_code_row_s3_q[1:0]};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_1794_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1783_s3_q, less_1782_s3_q, less_1773_s3_q, less_1772_s3_q, patches_codes_high_q, patches_codes_low_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 5'd28) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 5'd28) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1796, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_1806_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1783_s3_q, less_1782_s3_q, less_1773_s3_q, less_1772_s3_q, patches_codes_high_q[55:12]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_1499_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1872, textured_s3_q};
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
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      registration_fresh_q <= 4'hf;
      patches_chance_q <= 16'h1;
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 7'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_band_q <= 5'h0;
      patches_fetch_q <= 2'h0;
      patches_codes_low_q <= 52'h0;
      patches_codes_high_q <= 56'h0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_first_q <= 1'b0;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
      patches_read_at_q <= 5'h0;
      patches_read_first_q <= 1'b0;
      patches_read_above_q <= 1'b0;
      patches_read_below_q <= 1'b0;
      patches_read_far_q <= 10'h3ff;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
      patches_peak_above_q <= 10'h0;
      patches_peak_below_q <= 10'h0;
      patches_peak_far_q <= 10'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
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
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s3_q;
      sample_of_skin_q <= mask_s3_q;
      averager_running_mask_q <= sample_pair_whole_s3_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2038;
      averager_mask_q <= select_2040;
      averager_of_skin_q <= select_2042;
      census_filled_q <= and_495_s3_q ? {select_559[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_495_s3_q ? select_558 : rows_passed_above_q;
      registration_slope_here_q <= select_2474;
      registration_of_right_q <= equal_1464_s3_q ? registration_of_right_q : select_2533;
      registration_was_inside_q <= equal_1464_s3_q ? registration_was_inside_q : select_2536;
      registration_fresh_q <= select_2545;
      patches_chance_q <= and_495_s3_q ? select_2702 : patches_chance_q;
      patches_fixed_q <= and_2716;
      patches_choice_valid_q <= and_1671 ? (select_1665[0] & not_2704) : select_1665[0];
      patches_choice_column_q <= select_1665[7:1];
      patches_choice_shift_q <= select_1665[13:8];
      patches_choice_slope_q <= select_1665[21:14];
      patches_band_q <= sample_pair_whole_s3_q ? select_1686 : patches_band_q;
      patches_fetch_q <= select_2731;
      patches_codes_low_q <= select_2830;
      patches_codes_high_q <= select_2834;
      patches_set_q <= select_2851;
      patches_size_q <= sum_2853;
      patches_left_row_q <= select_2865;
      patches_summed_first_q <= select_3213;
      patches_read_row_differing_q <= equal_1673_s3_q ? select_3225 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1673_s3_q ? select_3232 : patches_read_row_column_q;
      patches_read_at_q <= equal_1673_s3_q ? select_3239 : patches_read_at_q;
      patches_read_first_q <= select_3248;
      patches_read_above_q <= select_3271;
      patches_read_below_q <= select_3280;
      patches_read_far_q <= equal_1673_s3_q ? select_3290 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3293;
      patches_peak_best_column_q <= select_3294;
      patches_peak_row_q <= equal_1673_s3_q ? select_3261 : patches_peak_row_q;
      patches_peak_above_q <= equal_1673_s3_q ? select_3296 : patches_peak_above_q;
      patches_peak_below_q <= equal_1673_s3_q ? select_3298 : patches_peak_below_q;
      patches_peak_far_q <= equal_1673_s3_q ? select_3302 : patches_peak_far_q;
      shown_shown_q <= select_3529;
      shown_nearer_q <= select_3531;
      region_row_q <= and_495_s3_q ? select_3537 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3542;
      region_down_rest_q <= select_3558;
      region_down_back_q <= select_3562;
      region_down_next_q <= select_3564;
      region_fresh_q <= and_495_s3_q ? select_3568 : region_fresh_q;
      segment_starts_q <= select_3579;
      centres_values_0_textured_q <= equal_1464_s3_q ? centres_values_0_textured_q : select_3725;
      centres_values_0_of_skin_q <= select_3730;
      centres_values_1_textured_q <= select_3733;
      centres_values_1_of_skin_q <= select_3736;
      map_row_q <= and_495_s3_q ? select_3740 : map_row_q;
      map_width_q <= select_3743;
      write_half_q <= select_3748;
      read_half_q <= and_1825_s3_q ? select_3750 : read_half_q;
      done_q <= and_1825_s3_q ? (not_1896 & and_3754) : and_3754;
      drew_q <= so_s3_q;
      said_q <= equal_1464_s3_q & equal_3513;
      rows_passed_q <= and_1825_s3_q ? select_3763 : rows_passed_q;
      columns_passed_q <= and_1825_s3_q ? select_3766 : columns_passed_q;
      line_ended_q <= and_1825_s3_q ? select_3769 : line_ended_q;
      began_q <= and_1825_s3_q ? select_3772 : began_q;
      seen_x_q <= and_1825_s3_q ? select_3775 : seen_x_q;
      seen_y_q <= and_1825_s3_q ? select_3782 : seen_y_q;
      seen_column_q <= and_1825_s3_q ? select_3785 : seen_column_q;
      seen_rows_left_q <= and_1825_s3_q ? select_3793 : seen_rows_left_q;
      at_cell_end_q <= and_1825_s3_q ? select_3800 : at_cell_end_q;
      was_next_row_q <= and_1825_s3_q ? select_3803 : was_next_row_q;
      seen_base_q <= and_1825_s3_q ? select_3806 : seen_base_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
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
      left_pixel_q <= and_1825_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= sample_pair_whole_s3_q ? select_473 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_479 : averager_running_1_q;
      averager_total_0_q <= select_2017;
      averager_total_1_q <= select_2019;
      census_columns_values_0_cell_0_left_q <= select_2043;
      census_columns_values_0_cell_0_right_q <= select_2044;
      census_columns_values_0_cell_0_mask_q <= and_495_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2046;
      census_columns_values_0_cell_1_right_q <= select_2047;
      census_columns_values_0_cell_1_mask_q <= select_2048;
      census_columns_values_0_cell_2_left_q <= select_2049;
      census_columns_values_0_cell_2_right_q <= select_2050;
      census_columns_values_0_cell_2_mask_q <= select_2051;
      census_columns_values_0_cell_2_of_skin_q <= select_2052;
      census_columns_values_0_cell_3_left_q <= select_2053;
      census_columns_values_0_cell_3_right_q <= select_2054;
      census_columns_values_0_cell_3_mask_q <= select_2055;
      census_columns_values_0_cell_4_left_q <= select_2056;
      census_columns_values_0_cell_4_right_q <= select_2057;
      census_columns_values_0_cell_4_mask_q <= select_2058;
      census_columns_values_1_cell_0_left_q <= select_2059;
      census_columns_values_1_cell_0_right_q <= select_2060;
      census_columns_values_1_cell_0_mask_q <= select_2061;
      census_columns_values_1_cell_1_left_q <= select_2062;
      census_columns_values_1_cell_1_right_q <= select_2063;
      census_columns_values_1_cell_1_mask_q <= select_2064;
      census_columns_values_1_cell_2_left_q <= select_2065;
      census_columns_values_1_cell_2_right_q <= select_2066;
      census_columns_values_1_cell_2_mask_q <= select_2067;
      census_columns_values_1_cell_2_of_skin_q <= select_2068;
      census_columns_values_1_cell_3_left_q <= select_2069;
      census_columns_values_1_cell_3_right_q <= select_2070;
      census_columns_values_1_cell_3_mask_q <= select_2071;
      census_columns_values_1_cell_4_left_q <= select_2072;
      census_columns_values_1_cell_4_right_q <= select_2073;
      census_columns_values_1_cell_4_mask_q <= select_2074;
      census_columns_values_2_cell_0_left_q <= select_2075;
      census_columns_values_2_cell_0_right_q <= select_2076;
      census_columns_values_2_cell_0_mask_q <= select_2077;
      census_columns_values_2_cell_1_left_q <= select_2078;
      census_columns_values_2_cell_1_right_q <= select_2079;
      census_columns_values_2_cell_1_mask_q <= select_2080;
      census_columns_values_2_cell_2_left_q <= select_2081;
      census_columns_values_2_cell_2_right_q <= select_2082;
      census_columns_values_2_cell_2_mask_q <= select_2083;
      census_columns_values_2_cell_3_left_q <= select_2084;
      census_columns_values_2_cell_3_right_q <= select_2085;
      census_columns_values_2_cell_3_mask_q <= select_2086;
      census_columns_values_2_cell_4_left_q <= select_2087;
      census_columns_values_2_cell_4_right_q <= select_2088;
      census_columns_values_2_cell_4_mask_q <= select_2089;
      census_columns_values_3_cell_0_mask_q <= select_2090;
      census_columns_values_3_cell_1_left_q <= select_2091;
      census_columns_values_3_cell_1_right_q <= select_2092;
      census_columns_values_3_cell_1_mask_q <= select_2093;
      census_columns_values_3_cell_2_mask_q <= select_2094;
      census_columns_values_3_cell_3_left_q <= select_2095;
      census_columns_values_3_cell_3_right_q <= select_2096;
      census_columns_values_3_cell_3_mask_q <= select_2097;
      census_columns_values_3_cell_4_mask_q <= select_2098;
      sharpness_last_mean_0_q <= and_495_s3_q ? select_501 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_495_s3_q ? select_505 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1464_s3_q ? box_textured_columns_values_0_q : select_3653;
      box_textured_columns_values_1_q <= select_3657;
      box_textured_columns_values_2_q <= select_3660;
      box_textured_columns_values_3_q <= select_3663;
      box_textured_columns_values_4_q <= select_3666;
      box_textured_sum_sums_values_0_q <= equal_1464_s3_q ? box_textured_sum_sums_values_0_q : select_3668;
      box_explained_columns_values_0_q <= equal_1464_s3_q ? box_explained_columns_values_0_q : select_3671;
      box_explained_columns_values_1_q <= select_3675;
      box_explained_columns_values_2_q <= select_3678;
      box_explained_columns_values_3_q <= select_3681;
      box_explained_columns_values_4_q <= select_3684;
      box_explained_sum_sums_values_0_q <= select_3687;
      box_shown_columns_values_0_q <= equal_1464_s3_q ? box_shown_columns_values_0_q : select_3689;
      box_shown_columns_values_1_q <= select_3693;
      box_shown_columns_values_2_q <= select_3696;
      box_shown_columns_values_3_q <= select_3699;
      box_shown_columns_values_4_q <= select_3702;
      box_shown_sum_sums_values_0_q <= equal_1464_s3_q ? box_shown_sum_sums_values_0_q : select_3704;
      box_nearer_columns_values_0_q <= equal_1464_s3_q ? box_nearer_columns_values_0_q : select_3707;
      box_nearer_columns_values_1_q <= select_3711;
      box_nearer_columns_values_2_q <= select_3714;
      box_nearer_columns_values_3_q <= select_3717;
      box_nearer_columns_values_4_q <= select_3720;
      box_nearer_sum_sums_values_0_q <= equal_1464_s3_q ? box_nearer_sum_sums_values_0_q : select_3722;
    end
  end

  logic saturated_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic left_first_s4_q;
  logic [7:0] sample_pair_pixel_0_s4_q;
  logic [7:0] sample_pair_pixel_1_s4_q;
  logic sample_pair_whole_s4_q;
  logic sample_present_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [7:0] x_s4_q;
  logic [2:0] slot_s4_q;
  logic ends_cell_s4_q;
  logic lower_half_s4_q;
  logic registration_of_right_s4_q;
  logic [4:0] patches_choosing_band_s4_q;
  logic patches_lower_s4_q;
  logic patches_second_s4_q;
  logic [4:0] patches_summed_row_column_s4_q;
  logic patches_summed_first_s4_q;
  logic patches_summed_last_s4_q;
  logic [4:0] patches_summed_down_by_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic centres_values_1_textured_s4_q;
  logic centres_values_1_of_skin_s4_q;
  logic done_s4_q;
  logic [2:0] select_459_s4_q;
  logic [5:0] select_461_s4_q;
  logic [5:0] column_s4_q;
  logic and_493_s4_q;
  logic and_495_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_498_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic less_529_s4_q;
  logic less_530_s4_q;
  logic less_531_s4_q;
  logic less_532_s4_q;
  logic less_533_s4_q;
  logic less_534_s4_q;
  logic less_535_s4_q;
  logic less_536_s4_q;
  logic less_537_s4_q;
  logic less_538_s4_q;
  logic less_539_s4_q;
  logic less_540_s4_q;
  logic less_541_s4_q;
  logic less_542_s4_q;
  logic less_543_s4_q;
  logic less_544_s4_q;
  logic less_545_s4_q;
  logic less_546_s4_q;
  logic less_547_s4_q;
  logic less_548_s4_q;
  logic less_549_s4_q;
  logic less_550_s4_q;
  logic less_551_s4_q;
  logic less_552_s4_q;
  logic and_560_s4_q;
  logic and_585_s4_q;
  logic and_586_s4_q;
  logic [11:0] sum_601_s4_q;
  logic [9:0] sum_604_s4_q;
  logic equal_1464_s4_q;
  logic not_1465_s4_q;
  logic equal_1509_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1515_s4_q;
  logic equal_1517_s4_q;
  logic equal_1519_s4_q;
  logic equal_1521_s4_q;
  logic equal_1523_s4_q;
  logic equal_1525_s4_q;
  logic equal_1527_s4_q;
  logic equal_1529_s4_q;
  logic equal_1531_s4_q;
  logic less_1540_s4_q;
  logic or_1544_s4_q;
  logic equal_1564_s4_q;
  logic and_1574_s4_q;
  logic and_1577_s4_q;
  logic select_1594_s4_q;
  logic equal_1595_s4_q;
  logic and_1603_s4_q;
  logic and_1605_s4_q;
  logic equal_1638_s4_q;
  logic select_1665_s4_q;
  logic and_1672_s4_q;
  logic equal_1673_s4_q;
  logic equal_1675_s4_q;
  logic and_1688_s4_q;
  logic [4:0] select_1700_s4_q;
  logic select_1706_s4_q;
  logic [3:0] select_1742_s4_q;
  logic less_1807_s4_q;
  logic equal_1808_s4_q;
  logic not_1809_s4_q;
  logic equal_1810_s4_q;
  logic and_1825_s4_q;
  logic select_1827_s4_q;
  logic and_1830_s4_q;
  logic or_1836_s4_q;
  logic or_1839_s4_q;
  logic or_1842_s4_q;
  logic not_1844_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1865_s4_q;
  logic and_1870_s4_q;
  logic and_1902_s4_q;
  logic less_1903_s4_q;
  logic [11:0] sum_1911_s4_q;
  logic equal_1924_s4_q;
  logic or_1929_s4_q;
  logic or_1932_s4_q;
  logic or_1935_s4_q;
  logic not_1960_s4_q;
  logic less_1974_s4_q;
  logic and_1985_s4_q;
  logic [11:0] sum_2114_s4_q;
  logic [9:0] sum_2117_s4_q;
  logic equal_2125_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2365_s4_q;
  logic and_2369_s4_q;
  logic not_2403_s4_q;
  logic and_2431_s4_q;
  logic and_2478_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2512_s4_q;
  logic and_2526_s4_q;
  logic equal_2569_s4_q;
  logic parity_2937_s4_q;
  logic parity_3066_s4_q;
  logic parity_3128_s4_q;
  logic xor_3156_s4_q;
  logic parity_3168_s4_q;
  logic or_3172_s4_q;
  logic equal_3173_s4_q;
  logic [4:0] select_3292_s4_q;
  logic equal_3304_s4_q;
  logic less_3306_s4_q;
  logic less_3307_s4_q;
  logic or_3312_s4_q;
  logic [7:0] select_3357_s4_q;
  logic equal_3513_s4_q;
  logic and_3809_s4_q;
  logic equal_3871_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      saturated_s4_q <= saturated_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      left_first_s4_q <= left_first_s3_q;
      sample_pair_pixel_0_s4_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s4_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      sample_present_s4_q <= sample_present_s3_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s4_q <= x_s3_q;
      slot_s4_q <= slot_s3_q;
      ends_cell_s4_q <= ends_cell_s3_q;
      lower_half_s4_q <= lower_half_s3_q;
      registration_of_right_s4_q <= registration_of_right_q;
      patches_choosing_band_s4_q <= patches_choosing_band_s3_q;
      patches_lower_s4_q <= patches_lower_s3_q;
      patches_second_s4_q <= patches_second_s3_q;
      patches_summed_row_column_s4_q <= patches_summed_row_column_s3_q;
      patches_summed_first_s4_q <= patches_summed_first_q;
      patches_summed_last_s4_q <= patches_summed_last_s3_q;
      patches_summed_down_by_s4_q <= patches_summed_down_by_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      done_s4_q <= done_q;
      select_459_s4_q <= select_459_s3_q;
      select_461_s4_q <= select_461_s3_q;
      column_s4_q <= column_s3_q;
      and_493_s4_q <= and_493_s3_q;
      and_495_s4_q <= and_495_s3_q;
      grey_s4_q <= grey;
      equal_498_s4_q <= equal_498;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      less_529_s4_q <= less_529;
      less_530_s4_q <= less_530;
      less_531_s4_q <= less_531;
      less_532_s4_q <= less_532;
      less_533_s4_q <= less_533;
      less_534_s4_q <= less_534;
      less_535_s4_q <= less_535;
      less_536_s4_q <= less_536;
      less_537_s4_q <= less_537;
      less_538_s4_q <= less_538;
      less_539_s4_q <= less_539;
      less_540_s4_q <= less_540;
      less_541_s4_q <= less_541;
      less_542_s4_q <= less_542;
      less_543_s4_q <= less_543;
      less_544_s4_q <= less_544;
      less_545_s4_q <= less_545;
      less_546_s4_q <= less_546;
      less_547_s4_q <= less_547;
      less_548_s4_q <= less_548;
      less_549_s4_q <= less_549;
      less_550_s4_q <= less_550;
      less_551_s4_q <= less_551;
      less_552_s4_q <= less_552;
      and_560_s4_q <= and_560;
      and_585_s4_q <= whole_22 & and_560;
      and_586_s4_q <= census_columns_values_1_cell_2_mask_q & and_560;
      sum_601_s4_q <= {1'b0, sum_597} + {2'h0, sum_600};
      sum_604_s4_q <= {9'h0, difference_602[9]} + {1'b0, xor_603};
      equal_1464_s4_q <= equal_1464_s3_q;
      not_1465_s4_q <= not_1465_s3_q;
      equal_1509_s4_q <= equal_1509;
      all_s4_q <= all;
      sum_1515_s4_q <= sum_1515;
      equal_1517_s4_q <= equal_1517;
      equal_1519_s4_q <= equal_1519;
      equal_1521_s4_q <= equal_1521;
      equal_1523_s4_q <= equal_1523;
      equal_1525_s4_q <= equal_1525;
      equal_1527_s4_q <= equal_1527;
      equal_1529_s4_q <= equal_1529;
      equal_1531_s4_q <= equal_1531;
      less_1540_s4_q <= less_1540;
      or_1544_s4_q <= or_1544;
      equal_1564_s4_q <= (registration_fresh_q & select_1562) == 4'h0;
      and_1574_s4_q <= not_1465_s3_q & and_1558;
      and_1577_s4_q <= and_1577_s3_q;
      select_1594_s4_q <= select_1594[1];
      equal_1595_s4_q <= equal_1595;
      and_1603_s4_q <= and_1603;
      and_1605_s4_q <= and_1605_s3_q;
      equal_1638_s4_q <= equal_1638;
      select_1665_s4_q <= select_1665[0];
      and_1672_s4_q <= and_1672;
      equal_1673_s4_q <= equal_1673_s3_q;
      equal_1675_s4_q <= equal_1675_s3_q;
      and_1688_s4_q <= and_1672 & equal_1687;
      select_1700_s4_q <= select_1700_s3_q;
      select_1706_s4_q <= select_1706_s3_q;
      select_1742_s4_q <= select_1742_s3_q;
      less_1807_s4_q <= less_1807_s3_q;
      equal_1808_s4_q <= equal_1808_s3_q;
      not_1809_s4_q <= not_1809_s3_q;
      equal_1810_s4_q <= equal_1810_s3_q;
      and_1825_s4_q <= and_1825_s3_q;
      select_1827_s4_q <= select_1827_s3_q;
      and_1830_s4_q <= and_1830_s3_q;
      or_1836_s4_q <= or_1836;
      or_1839_s4_q <= or_1839;
      or_1842_s4_q <= or_1842;
      not_1844_s4_q <= not_1844;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1865_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_1870_s4_q <= not_1465_s3_q & and_1851;
      and_1902_s4_q <= and_1902;
      less_1903_s4_q <= less_1903;
      sum_1911_s4_q <= sum_1911;
      equal_1924_s4_q <= t[4:1] == 4'h0;
      or_1929_s4_q <= or_1929;
      or_1932_s4_q <= select_1926[7] | (~({select_1926[6], select_1926[3:2]} == 3'h0));
      or_1935_s4_q <= select_1926[7] | (~(select_1926[6:4] == 3'h0));
      not_1960_s4_q <= ~({sum_1958, around[0]} < {2'h0, t});
      less_1974_s4_q <= {1'b0, around[4:1]} < n;
      and_1985_s4_q <= and_1985;
      sum_2114_s4_q <= {1'b0, sum_2110} + {2'h0, sum_2113};
      sum_2117_s4_q <= {9'h0, difference_2115[9]} + {1'b0, xor_2116};
      equal_2125_s4_q <= equal_2125_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2365_s4_q <= and_2365;
      and_2369_s4_q <= and_2369;
      not_2403_s4_q <= ~({sum_2401, e[0]} < {2'h0, t});
      and_2431_s4_q <= not_1465_s3_q & and_2430;
      and_2478_s4_q <= not_1465_s3_q & (so_s3_q & (half_ends & equal_2475));
      residual_s4_q <= residual[7:0];
      and_2512_s4_q <= and_2512;
      and_2526_s4_q <= and_1605_s3_q & less_2525;
      equal_2569_s4_q <= (registration_fresh_q & select_2567) == 4'h0;
      parity_2937_s4_q <= ^{xor_2933, xor_2896, select_2863[44:36], other[44:36]};
      parity_3066_s4_q <= parity_3066;
      parity_3128_s4_q <= parity_3128;
      xor_3156_s4_q <= parity_3143 ^ parity_3155;
      parity_3168_s4_q <= ^{or_3165, or_3161, and_3157};
      or_3172_s4_q <= (or_3161 & or_3165) | (and_3157 & (or_3161 | or_3165));
      equal_3173_s4_q <= equal_3173_s3_q;
      select_3292_s4_q <= select_3292[14:10];
      equal_3304_s4_q <= select_3261[3:0] == 4'h0;
      less_3306_s4_q <= {difference_3305, 2'h0} < {2'h0, sum_2853};
      less_3307_s4_q <= select_3302 < select_3292[9:0];
      or_3312_s4_q <= (sum_2853 < 10'h39) | ({1'b0, sum_2853[9:1]} < select_3292[9:0]);
      select_3357_s4_q <= select_3357;
      equal_3513_s4_q <= equal_3513;
      and_3809_s4_q <= and_1985 & (sum_1911 == sum_1895);
      equal_3871_s4_q <= (registration_fresh_q & select_3869) == 4'h0;
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
  logic [6:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic [6:0] patches_place_1_column_q;
  logic [5:0] patches_place_1_shift_q;
  logic [7:0] patches_place_1_slope_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
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
  // hls/stages/census.hpp:270
  logic [11:0] texture;
  assign texture = sum_601_s4_q + {2'h0, sum_604_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_606;
  assign sum_606 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_608;
  assign sum_608 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_606});
  // hls/stages/census.hpp:303
  logic less_609;
  assign less_609 = 9'h4 < sum_608[13:5];
  logic and_610;
  assign and_610 = and_560_s4_q & less_609;
  // hls/stages/registration.hpp:262
  logic equal_1566;
  assign equal_1566 = sum_1515_s4_q == 2'h0;
  // hls/stages/registration.hpp:260
  logic [6:0] down;
  assign down = sum_1515_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:262
  logic [13:0] select_1568;
  assign select_1568 = equal_1566 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1569;
  assign sum_1569 = (equal_1564_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1568[13]}}, select_1568};
  // hls/stages/registration.hpp:261
  logic [6:0] up;
  assign up = sum_1515_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:263
  logic [6:0] select_1572;
  assign select_1572 = equal_1566 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1573;
  assign sum_1573 = (equal_1564_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1572[6]}}, select_1572};
  // hls/stages/patches.hpp:100
  logic [21:0] select_1689;
  assign select_1689 = and_1688_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1665_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:101
  logic [20:0] select_1690;
  assign select_1690 = select_1594_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1689[21:1];
  // hls/stages/patches.hpp:105
  logic [6:0] select_1691;
  assign select_1691 = equal_1595_s4_q ? patches_place_0_column_q : select_1690[6:0];
  logic [5:0] select_1692;
  assign select_1692 = equal_1595_s4_q ? patches_place_0_shift_q : select_1690[12:7];
  // hls/stages/patches.hpp:287
  logic [6:0] sum_1693;
  assign sum_1693 = select_1691 + {select_1692[5], select_1692};
  // hls/stages/patches.hpp:288
  logic [5:0] sum_1694;
  assign sum_1694 = sum_1693[6:1] + 6'h3f;
  // hls/stages/patches.hpp:109
  logic equal_1695;
  assign equal_1695 = {sum_1694[5], select_461_s4_q, select_459_s4_q} == {1'b0, sum_1694[4:0], sum_1693[0], 3'h4};
  // hls/stages/patches.hpp:110
  logic or_1696;
  assign or_1696 = and_1577_s4_q | equal_1695;
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1697;
  assign select_1697 = or_1696 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:110
  logic [5:0] select_1707;
  assign select_1707 = or_1696 ? {and_1577_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:114
  logic and_1709;
  assign and_1709 = select_1706_s4_q & (~select_1707[5]);
  // hls/stages/patches.hpp:101
  logic [20:0] select_1716;
  assign select_1716 = select_1594_s4_q ? select_1689[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:105
  logic [6:0] select_1717;
  assign select_1717 = equal_1595_s4_q ? patches_place_1_column_q : select_1716[6:0];
  logic [5:0] select_1718;
  assign select_1718 = equal_1595_s4_q ? patches_place_1_shift_q : select_1716[12:7];
  // hls/stages/patches.hpp:287
  logic [6:0] sum_1719;
  assign sum_1719 = select_1717 + {select_1718[5], select_1718};
  // hls/stages/patches.hpp:288
  logic [5:0] sum_1720;
  assign sum_1720 = sum_1719[6:1] + 6'h3f;
  // hls/stages/patches.hpp:109
  logic equal_1721;
  assign equal_1721 = {sum_1720[5], select_461_s4_q, select_459_s4_q} == {1'b0, sum_1720[4:0], sum_1719[0], 3'h4};
  // hls/stages/patches.hpp:110
  logic or_1722;
  assign or_1722 = and_1577_s4_q | equal_1721;
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1723;
  assign select_1723 = or_1722 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:110
  logic [5:0] select_1724;
  assign select_1724 = or_1722 ? {and_1577_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:114
  logic and_1726;
  assign and_1726 = select_1706_s4_q & (~select_1724[5]);
  // hls/stages/patches.hpp:284
  logic [6:0] sum_1733;
  assign sum_1733 = select_1691 + 7'h7f;
  // hls/stages/patches.hpp:109
  logic equal_1734;
  assign equal_1734 = {sum_1733[6], select_461_s4_q, select_459_s4_q} == {1'b0, sum_1733[5:0], 3'h4};
  // hls/stages/patches.hpp:111
  logic or_1735;
  assign or_1735 = and_1577_s4_q | equal_1734;
  logic [4:0] select_1736;
  assign select_1736 = or_1735 ? {and_1577_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:284
  logic [6:0] sum_1737;
  assign sum_1737 = select_1717 + 7'h7f;
  // hls/stages/patches.hpp:109
  logic equal_1738;
  assign equal_1738 = {sum_1737[6], select_461_s4_q, select_459_s4_q} == {1'b0, sum_1737[5:0], 3'h4};
  // hls/stages/patches.hpp:111
  logic [4:0] select_1740;
  assign select_1740 = (and_1577_s4_q | equal_1738) ? {and_1577_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:119
  logic [3:0] column_5;
  assign column_5 = select_1736[4] ? select_1740[3:0] : select_1736[3:0];
  // hls/stages/agreement.hpp:263
  logic select_1743;
  assign select_1743 = or_1735 ? and_1577_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:119
  logic and_1749;
  assign and_1749 = (select_1706_s4_q & (select_1700_s4_q[3] ^ select_1700_s4_q[4])) & ((~select_1736[4]) | (~select_1740[4]));
  // hls/stages/patches.hpp:160
  logic less_1819;
  assign less_1819 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:161
  logic not_1820;
  assign not_1820 = ~less_1819;
  logic [1:0] select_1821;
  assign select_1821 = patches_summed_first_s4_q ? 2'h2 : {less_1819, not_1820};
  logic [12:0] select_1823;
  assign select_1823 = select_1821[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1831;
  assign select_1831 = select_1821[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1830_s4_q, 1'b0, select_1827_s4_q, left_pixel_q};
  logic [14:0] select_1832;
  assign select_1832 = (select_1821 == 2'h2) ? {select_1823[12:8], patches_sums_values_0_q[9:8], select_1823[7:0]} : select_1831;
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1855;
  assign select_1855 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1856;
  assign sum_1856 = {5'h0, textured_s4_q} + select_1855;
  // hls/stages/agreement.hpp:1002
  logic [9:0] sum_1858;
  assign sum_1858 = {4'h0, sum_1856} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1860;
  assign select_1860 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1861;
  assign sum_1861 = {5'h0, explained_s4_q} + select_1860;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1863;
  assign sum_1863 = {4'h0, sum_1861} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1866;
  assign select_1866 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:868
  logic [5:0] sum_1867;
  assign sum_1867 = {5'h0, and_1865_s4_q} + select_1866;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1869;
  assign sum_1869 = {4'h0, sum_1867} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1042
  logic not_1936;
  assign not_1936 = ~region_row_s4_q[2];
  logic [2:0] select_1937;
  assign select_1937 = region_row_s4_q[1] ? {1'b0, not_1936, 1'b0} : {region_row_s4_q[2], 1'b0, not_1936};
  logic [5:0] select_1938;
  assign select_1938 = region_row_s4_q[0] ? {select_1937[2], 1'b0, select_1937[1], 1'b0, select_1937[0], 1'b0} : {1'b0, select_1937[2], 1'b0, select_1937[1], 1'b0, select_1937[0]};
  logic [11:0] select_1939;
  assign select_1939 = or_1935_s4_q ? {select_1938[5], 1'b0, select_1938[4], 1'b0, select_1938[3], 1'b0, select_1938[2], 1'b0, select_1938[1], 1'b0, select_1938[0], 1'b0} : {1'b0, select_1938[5], 1'b0, select_1938[4], 1'b0, select_1938[3], 1'b0, select_1938[2], 1'b0, select_1938[1], 1'b0, select_1938[0]};
  logic [23:0] select_1940;
  assign select_1940 = or_1932_s4_q ? {select_1939[11], 1'b0, select_1939[10], 1'b0, select_1939[9], 1'b0, select_1939[8], 1'b0, select_1939[7], 1'b0, select_1939[6], 1'b0, select_1939[5], 1'b0, select_1939[4], 1'b0, select_1939[3], 1'b0, select_1939[2], 1'b0, select_1939[1], 1'b0, select_1939[0], 1'b0} : {1'b0, select_1939[11], 1'b0, select_1939[10], 1'b0, select_1939[9], 1'b0, select_1939[8], 1'b0, select_1939[7], 1'b0, select_1939[6], 1'b0, select_1939[5], 1'b0, select_1939[4], 1'b0, select_1939[3], 1'b0, select_1939[2], 1'b0, select_1939[1], 1'b0, select_1939[0]};
  logic [47:0] select_1941;
  assign select_1941 = or_1929_s4_q ? {select_1940[23], 1'b0, select_1940[22], 1'b0, select_1940[21], 1'b0, select_1940[20], 1'b0, select_1940[19], 1'b0, select_1940[18], 1'b0, select_1940[17], 1'b0, select_1940[16], 1'b0, select_1940[15], 1'b0, select_1940[14], 1'b0, select_1940[13], 1'b0, select_1940[12], 1'b0, select_1940[11], 1'b0, select_1940[10], 1'b0, select_1940[9], 1'b0, select_1940[8], 1'b0, select_1940[7], 1'b0, select_1940[6], 1'b0, select_1940[5], 1'b0, select_1940[4], 1'b0, select_1940[3], 1'b0, select_1940[2], 1'b0, select_1940[1], 1'b0, select_1940[0], 1'b0} : {1'b0, select_1940[23], 1'b0, select_1940[22], 1'b0, select_1940[21], 1'b0, select_1940[20], 1'b0, select_1940[19], 1'b0, select_1940[18], 1'b0, select_1940[17], 1'b0, select_1940[16], 1'b0, select_1940[15], 1'b0, select_1940[14], 1'b0, select_1940[13], 1'b0, select_1940[12], 1'b0, select_1940[11], 1'b0, select_1940[10], 1'b0, select_1940[9], 1'b0, select_1940[8], 1'b0, select_1940[7], 1'b0, select_1940[6], 1'b0, select_1940[5], 1'b0, select_1940[4], 1'b0, select_1940[3], 1'b0, select_1940[2], 1'b0, select_1940[1], 1'b0, select_1940[0]};
  // hls/stages/agreement.hpp:975
  logic and_1945;
  assign and_1945 = good_known_q & (~((good_q & select_1941) == 48'h0));
  // hls/stages/agreement.hpp:1044
  logic is_seen;
  assign is_seen = equal_1924_s4_q ? and_1945 : not_1960_s4_q;
  // hls/stages/agreement.hpp:1053
  logic and_1975;
  assign and_1975 = is_seen & less_1974_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2009;
  assign select_2009 = sample_pair_whole_s4_q ? (and_493_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2011;
  assign select_2011 = sample_pair_whole_s4_q ? (and_493_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2013;
  assign select_2013 = sample_pair_whole_s4_q ? (and_493_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2015;
  assign select_2015 = sample_pair_whole_s4_q ? (and_493_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2020;
  assign sum_2020 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2021;
  assign difference_2021 = {1'b0, sum_2020[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2022;
  assign xor_2022 = {difference_2021[8:0], sum_2020[0]} ^ {10{difference_2021[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2021[9]} + {1'b0, xor_2022};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_498_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2027;
  assign select_2027 = sample_pair_whole_s4_q ? (and_493_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2028;
  assign sum_2028 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2029;
  assign difference_2029 = {1'b0, sum_2028[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2030;
  assign xor_2030 = {difference_2029[8:0], sum_2028[0]} ^ {10{difference_2029[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2029[9]} + {1'b0, xor_2030};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_498_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2035;
  assign select_2035 = sample_pair_whole_s4_q ? (and_493_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2118;
  assign sum_2118 = sum_2114_s4_q + {2'h0, sum_2117_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2120;
  assign select_2120 = and_495_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2121;
  assign select_2121 = and_495_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2122;
  assign select_2122 = and_495_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2123;
  assign select_2123 = and_495_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2126;
  assign sum_2126 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2118};
  logic [13:0] sum_2128;
  assign sum_2128 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2126});
  // hls/stages/census.hpp:305
  logic and_2130;
  assign and_2130 = and_585_s4_q & (9'h4 < sum_2128[13:5]);
  // hls/stages/census.hpp:306
  logic and_2131;
  assign and_2131 = and_585_s4_q & less_609;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2132;
  assign sum_2132 = census_left_misses_q + {{17{and_2131}}, and_2130, 1'b0, and_2130};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2134;
  assign select_2134 = and_495_s4_q ? (equal_2125_s4_q ? 20'h0 : sum_2132) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2139;
  assign select_2139 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2142;
  assign select_2142 = and_495_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2145;
  assign and_2145 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:444
  logic and_2151;
  assign and_2151 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2152;
  assign and_2152 = and_2145 & and_2151;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2139[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2154;
  assign select_2154 = and_2152 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2156;
  assign select_2156 = equal_2125_s4_q ? {11'h0, select_2154} : (sharpness_sums_detail_0_q + {11'h0, select_2154});
  // hls/stages/agreement.hpp:444
  logic and_2163;
  assign and_2163 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2164;
  assign and_2164 = and_2145 & and_2163;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2139[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2166;
  assign select_2166 = and_2164 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2168;
  assign select_2168 = equal_2125_s4_q ? {11'h0, select_2166} : (sharpness_sums_detail_1_q + {11'h0, select_2166});
  logic [8:0] select_2171;
  assign select_2171 = and_2152 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2172;
  assign sum_2172 = (equal_2125_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2171};
  logic [8:0] select_2175;
  assign select_2175 = and_2164 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2176;
  assign sum_2176 = (equal_2125_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2175};
  // hls/stages/agreement.hpp:203
  logic equal_2178;
  assign equal_2178 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2179;
  assign less_2179 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2180;
  assign less_2180 = x_s4_q[4:0] < 5'h3;
  logic not_2181;
  assign not_2181 = ~x_s4_q[1];
  logic [2:0] select_2182;
  assign select_2182 = x_s4_q[0] ? {1'b0, not_2181, 1'b0} : {x_s4_q[1], 1'b0, not_2181};
  logic [5:0] select_2183;
  assign select_2183 = slot_s4_q[2] ? {select_2182[2], 1'b0, select_2182[1], 1'b0, select_2182[0], 1'b0} : {1'b0, select_2182[2], 1'b0, select_2182[1], 1'b0, select_2182[0]};
  logic [11:0] select_2184;
  assign select_2184 = slot_s4_q[1] ? {select_2183[5], 1'b0, select_2183[4], 1'b0, select_2183[3], 1'b0, select_2183[2], 1'b0, select_2183[1], 1'b0, select_2183[0], 1'b0} : {1'b0, select_2183[5], 1'b0, select_2183[4], 1'b0, select_2183[3], 1'b0, select_2183[2], 1'b0, select_2183[1], 1'b0, select_2183[0]};
  logic [23:0] select_2185;
  assign select_2185 = slot_s4_q[0] ? {select_2184[11], 1'b0, select_2184[10], 1'b0, select_2184[9], 1'b0, select_2184[8], 1'b0, select_2184[7], 1'b0, select_2184[6], 1'b0, select_2184[5], 1'b0, select_2184[4], 1'b0, select_2184[3], 1'b0, select_2184[2], 1'b0, select_2184[1], 1'b0, select_2184[0], 1'b0} : {1'b0, select_2184[11], 1'b0, select_2184[10], 1'b0, select_2184[9], 1'b0, select_2184[8], 1'b0, select_2184[7], 1'b0, select_2184[6], 1'b0, select_2184[5], 1'b0, select_2184[4], 1'b0, select_2184[3], 1'b0, select_2184[2], 1'b0, select_2184[1], 1'b0, select_2184[0]};
  // hls/stages/census.hpp:372
  logic and_2189;
  assign and_2189 = less_2180 & (~((sharpness_sums_contrast_1_q & select_2185) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2191;
  assign select_2191 = (less_2179 & and_2189) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2191};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2194;
  assign select_2194 = equal_2178 ? (less_2179 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2199;
  assign and_2199 = less_2180 & (~((sharpness_sums_contrast_0_q & select_2185) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2201;
  assign select_2201 = (less_2179 & and_2199) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2201};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2204;
  assign select_2204 = equal_2178 ? (less_2179 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2206;
  assign select_2206 = equal_2178 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2208;
  assign select_2208 = equal_2178 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2210;
  assign select_2210 = equal_2178 ? {sharpness_comparing_contrast_0_q[0], and_2199} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2212;
  assign select_2212 = equal_2178 ? {sharpness_comparing_contrast_1_q[0], and_2189} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2217;
  assign select_2217 = drew_q ? (equal_2178 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2221;
  assign select_2221 = drew_q ? (equal_2178 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2222;
  assign equal_2222 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2223;
  assign xor_2223 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2226;
  assign select_2226 = (equal_2222 | xor_2223) ? (five_times[0] & xor_2223) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2228;
  assign select_2228 = drew_q ? (equal_2178 ? select_2226 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2229;
  assign xor_2229 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2232;
  assign select_2232 = (equal_2222 | xor_2229) ? (five_times_2[0] & xor_2229) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2234;
  assign select_2234 = drew_q ? (equal_2178 ? select_2232 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2235;
  assign xor_2235 = sharpness_comparing_contrast_0_q[1] ^ and_2189;
  logic select_2238;
  assign select_2238 = (equal_2222 | xor_2235) ? (and_2189 & xor_2235) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2240;
  assign select_2240 = drew_q ? (equal_2178 ? select_2238 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2241;
  assign xor_2241 = sharpness_comparing_contrast_1_q[1] ^ and_2199;
  logic select_2244;
  assign select_2244 = (equal_2222 | xor_2241) ? (and_2199 & xor_2241) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2246;
  assign select_2246 = drew_q ? (equal_2178 ? select_2244 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2371;
  assign select_2371 = and_2365_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2369_s4_q});
  // hls/stages/patches.hpp:303
  logic and_2374;
  assign and_2374 = not_1465_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2379;
  assign and_2379 = not_1465_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2384;
  assign and_2384 = not_1465_s4_q & (drew_q & (ends_cell_s4_q & and_1865_s4_q));
  // hls/stages/agreement.hpp:1046
  logic not_2388;
  assign not_2388 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1047
  logic not_2405;
  assign not_2405 = ~(equal_1924_s4_q ? and_1945 : not_2403_s4_q);
  // hls/stages/patches.hpp:303
  logic and_2408;
  assign and_2408 = ends_cell_s4_q & (not_2388 & (centres_values_1_textured_s4_q & not_2405));
  logic and_2410;
  assign and_2410 = not_1465_s4_q & (drew_q & and_2408);
  // hls/stages/agreement.hpp:1073
  logic less_2413;
  assign less_2413 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2414;
  assign select_2414 = less_2413 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2417;
  assign select_2417 = less_2413 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1074
  logic [10:0] sum_2418;
  assign sum_2418 = {1'b0, select_2417} + {3'h0, select_2417[9:2]};
  logic and_2420;
  assign and_2420 = (~(select_2414[9:4] == 6'h0)) & ({sum_2418, select_2417[1:0]} < {3'h0, select_2414});
  // hls/stages/agreement.hpp:1083
  logic [9:0] select_2423;
  assign select_2423 = x_s4_q[6] ? (equal_1509_s4_q ? 10'h0 : (and_2420 ? select_2414 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:303
  logic [9:0] select_2424;
  assign select_2424 = equal_1464_s4_q ? select_2423 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2426;
  assign select_2426 = and_2365_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2424});
  logic [13:0] select_2433;
  assign select_2433 = and_2365_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2431_s4_q});
  // hls/stages/agreement.hpp:1051
  logic and_2435;
  assign and_2435 = not_2388 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:303
  logic and_2438;
  assign and_2438 = not_1465_s4_q & (drew_q & (ends_cell_s4_q & and_2435));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2440;
  assign select_2440 = and_2365_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2438});
  // hls/stages/agreement.hpp:1051
  logic and_2442;
  assign and_2442 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2405);
  // hls/stages/patches.hpp:303
  logic and_2446;
  assign and_2446 = not_1465_s4_q & (drew_q & (ends_cell_s4_q & (not_2388 & and_2442)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2448;
  assign select_2448 = and_2365_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2446});
  // hls/stages/patches.hpp:303
  logic [7:0] select_2494;
  assign select_2494 = drew_q ? (equal_1638_s4_q ? (and_1605_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2495;
  assign select_2495 = equal_1464_s4_q ? 8'h0 : select_2494;
  // hls/stages/registration.hpp:133
  logic [13:0] select_2497;
  assign select_2497 = and_2478_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2495[7]}}, select_2495});
  // hls/stages/patches.hpp:303
  logic and_2500;
  assign and_2500 = not_1465_s4_q & (drew_q & (and_1605_s4_q & equal_1638_s4_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2502;
  assign select_2502 = and_2478_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2500});
  // hls/stages/registration.hpp:106
  logic and_2504;
  assign and_2504 = and_1605_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:303
  logic [1:0] select_2506;
  assign select_2506 = drew_q ? (equal_1638_s4_q ? {and_2504, and_1605_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2507;
  assign select_2507 = equal_1464_s4_q ? 2'h0 : select_2506;
  // hls/stages/registration.hpp:181
  logic [6:0] sum_2508;
  assign sum_2508 = registration_half_votes_down_q + {{5{select_2507[1]}}, select_2507};
  // hls/stages/patches.hpp:303
  logic [1:0] select_2514;
  assign select_2514 = drew_q ? (equal_1638_s4_q ? {and_2512_s4_q, and_1605_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2515;
  assign select_2515 = equal_1464_s4_q ? 2'h0 : select_2514;
  // hls/stages/registration.hpp:182
  logic [6:0] sum_2516;
  assign sum_2516 = registration_half_votes_up_q + {{5{select_2515[1]}}, select_2515};
  // hls/stages/registration.hpp:106
  logic and_2519;
  assign and_2519 = and_1605_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:303
  logic [1:0] select_2521;
  assign select_2521 = drew_q ? (equal_1638_s4_q ? {and_2519, and_1605_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2522;
  assign select_2522 = equal_1464_s4_q ? 2'h0 : select_2521;
  // hls/stages/registration.hpp:181
  logic [6:0] sum_2523;
  assign sum_2523 = registration_half_half_votes_down_q + {{5{select_2522[1]}}, select_2522};
  // hls/stages/patches.hpp:303
  logic [1:0] select_2528;
  assign select_2528 = drew_q ? (equal_1638_s4_q ? {and_2526_s4_q, and_1605_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2529;
  assign select_2529 = equal_1464_s4_q ? 2'h0 : select_2528;
  // hls/stages/registration.hpp:182
  logic [6:0] sum_2530;
  assign sum_2530 = registration_half_half_votes_up_q + {{5{select_2529[1]}}, select_2529};
  // hls/stages/patches.hpp:303
  logic and_2564;
  assign and_2564 = equal_1464_s4_q & (x_s4_q[6] & (not_1844_s4_q & less_1540_s4_q));
  // hls/stages/agreement.hpp:1071
  logic [11:0] select_2571;
  assign select_2571 = or_1544_s4_q ? 12'h0 : (equal_2569_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1083
  logic [11:0] select_2574;
  assign select_2574 = x_s4_q[6] ? (equal_1509_s4_q ? 12'h0 : (less_1540_s4_q ? select_2571 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:303
  logic [11:0] select_2575;
  assign select_2575 = equal_1464_s4_q ? select_2574 : 12'h0;
  // hls/stages/registration.hpp:152
  logic and_2576;
  assign and_2576 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1083
  logic and_2579;
  assign and_2579 = not_1844_s4_q & (less_1540_s4_q & ({and_2576, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:303
  logic and_2581;
  assign and_2581 = equal_1464_s4_q & (x_s4_q[6] & and_2579);
  // hls/stages/registration.hpp:249
  logic [13:0] sum_2583;
  assign sum_2583 = {{2{select_2575[11]}}, select_2575} + (and_2581 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1071
  logic [11:0] select_2586;
  assign select_2586 = or_1544_s4_q ? 12'h0 : (equal_2569_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1083
  logic [11:0] select_2589;
  assign select_2589 = x_s4_q[6] ? (equal_1509_s4_q ? 12'h0 : (less_1540_s4_q ? select_2586 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:303
  logic [11:0] select_2590;
  assign select_2590 = equal_1464_s4_q ? select_2589 : 12'h0;
  // hls/stages/registration.hpp:250
  logic [13:0] sum_2592;
  assign sum_2592 = {{2{select_2590[11]}}, select_2590} + (and_2581 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:149
  logic not_2594;
  assign not_2594 = ~all_s4_q;
  // hls/stages/agreement.hpp:1083
  logic and_2597;
  assign and_2597 = not_1844_s4_q & (less_1540_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2594, 1'b0}));
  // hls/stages/patches.hpp:303
  logic and_2603;
  assign and_2603 = equal_1464_s4_q & (x_s4_q[6] & (not_1844_s4_q & (less_1540_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:243
  logic not_2604;
  assign not_2604 = ~and_2603;
  logic less_2605;
  assign less_2605 = $signed({9'h1, {2{not_2604}}, and_2603}) < $signed(registration_up_q[13:2]);
  logic select_2606;
  assign select_2606 = (equal_1464_s4_q & (x_s4_q[6] & and_2597)) ? less_2605 : registration_enough_q;
  // hls/stages/agreement.hpp:1083
  logic and_2610;
  assign and_2610 = x_s4_q[6] & (not_1844_s4_q & (less_1540_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:303
  logic and_2611;
  assign and_2611 = equal_1464_s4_q & and_2610;
  // hls/stages/registration.hpp:239
  logic less_2612;
  assign less_2612 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2614;
  assign less_2614 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1083
  logic and_2619;
  assign and_2619 = x_s4_q[6] & (not_1844_s4_q & (less_1540_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:303
  logic and_2620;
  assign and_2620 = equal_1464_s4_q & and_2619;
  // hls/stages/agreement.hpp:1083
  logic and_2627;
  assign and_2627 = x_s4_q[6] & (not_1844_s4_q & (less_1540_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:156
  logic equal_2630;
  assign equal_2630 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1083
  logic and_2633;
  assign and_2633 = not_1844_s4_q & (less_1540_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2630));
  // hls/stages/registration.hpp:241
  logic and_2637;
  assign and_2637 = (equal_1464_s4_q & (x_s4_q[6] & and_2633)) & (less_2614 | less_2612);
  // hls/stages/agreement.hpp:1083
  logic and_2642;
  assign and_2642 = not_1844_s4_q & (less_1540_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2630)));
  // hls/stages/registration.hpp:241
  logic and_2645;
  assign and_2645 = registration_votes_up_q & registration_other_down_q;
  logic select_2647;
  assign select_2647 = registration_votes_down_q ? (registration_other_up_q | and_2645) : and_2645;
  // hls/stages/registration.hpp:137
  logic and_2649;
  assign and_2649 = (equal_1464_s4_q & (x_s4_q[6] & and_2642)) & (registration_other_enough_q & select_2647);
  // hls/stages/registration.hpp:242
  logic or_2652;
  assign or_2652 = registration_moved_q | (registration_enough_q & (and_2637 | and_2649));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2735;
  assign select_2735 = sample_pair_whole_s4_q ? (equal_1595_s4_q ? patches_place_0_slope_q : select_1690[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2739;
  assign select_2739 = sample_pair_whole_s4_q ? (equal_1595_s4_q ? patches_place_1_slope_q : select_1716[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:105
  logic select_2741;
  assign select_2741 = equal_1595_s4_q ? patches_valid_0_q : (select_1594_s4_q ? patches_valid_0_q : select_1689[0]);
  // hls/stages/agreement.hpp:263
  logic select_2744;
  assign select_2744 = sample_pair_whole_s4_q ? (and_1709 ? (sample_present_s4_q & select_2741) : select_2741) : patches_valid_0_q;
  // hls/stages/patches.hpp:105
  logic select_2746;
  assign select_2746 = equal_1595_s4_q ? patches_valid_1_q : (select_1594_s4_q ? select_1689[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2749;
  assign select_2749 = sample_pair_whole_s4_q ? (and_1726 ? (sample_present_s4_q & select_2746) : select_2746) : patches_valid_1_q;
  logic [5:0] select_2752;
  assign select_2752 = sample_pair_whole_s4_q ? (select_1707[5] ? {1'b1, select_1707[4:0]} : (select_1707 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2755;
  assign select_2755 = sample_pair_whole_s4_q ? (select_1724[5] ? {1'b1, select_1724[4:0]} : (select_1724 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2758;
  assign select_2758 = sample_pair_whole_s4_q ? (select_1736[4] ? {1'b1, select_1736[3:0]} : (select_1736 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2761;
  assign select_2761 = sample_pair_whole_s4_q ? (select_1740[4] ? {1'b1, select_1740[3:0]} : (select_1740 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:445
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3172_s4_q, parity_3168_s4_q, xor_3156_s4_q, parity_3128_s4_q, parity_3066_s4_q, parity_2937_s4_q} + (equal_3173_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:160
  logic [9:0] select_3177;
  assign select_3177 = equal_1673_s4_q ? patches_sums_values_0_q : (equal_1675_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3178;
  assign select_3178 = equal_1675_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3180;
  assign select_3180 = equal_1675_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3182;
  assign select_3182 = equal_1675_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3184;
  assign select_3184 = equal_1675_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3186;
  assign select_3186 = equal_1675_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3188;
  assign select_3188 = equal_1675_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3190;
  assign select_3190 = equal_1675_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3192;
  assign select_3192 = equal_1675_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3194;
  assign select_3194 = equal_1675_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3196;
  assign select_3196 = equal_1675_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3198;
  assign select_3198 = equal_1675_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3200;
  assign select_3200 = equal_1675_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3202;
  assign select_3202 = equal_1675_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3204;
  assign select_3204 = equal_1675_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3206;
  assign select_3206 = equal_1675_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3208;
  assign select_3208 = equal_1675_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:519
  logic or_3313;
  assign or_3313 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3312_s4_q;
  logic or_3316;
  assign or_3316 = equal_3304_s4_q | (less_3306_s4_q | (less_3307_s4_q | or_3313));
  // hls/stages/patches.hpp:499
  logic not_3317;
  assign not_3317 = ~or_3316;
  // hls/stages/patches.hpp:480
  logic and_3318;
  assign and_3318 = equal_1810_s4_q & not_3317;
  // hls/stages/patches.hpp:160
  logic and_3321;
  assign and_3321 = equal_1673_s4_q & (less_1807_s4_q ? (not_1809_s4_q & and_3318) : and_3318);
  // hls/stages/patches.hpp:557
  logic not_3322;
  assign not_3322 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:480
  logic and_3324;
  assign and_3324 = equal_1810_s4_q & (patches_second_s4_q & not_3317);
  // hls/stages/patches.hpp:160
  logic and_3327;
  assign and_3327 = equal_1673_s4_q & (less_1807_s4_q ? (not_1809_s4_q & and_3324) : and_3324);
  // hls/stages/patches.hpp:557
  logic not_3328;
  assign not_3328 = ~and_3327;
  // hls/stages/patches.hpp:164
  logic and_3330;
  assign and_3330 = and_3321 & (not_3322 & not_3328);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3332;
  assign sum_3332 = {7'h0, and_3330} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:517
  logic [7:0] select_3358;
  assign select_3358 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:516
  logic [5:0] select_3359;
  assign select_3359 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3360;
  assign sum_3360 = {2'h0, select_3292_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3361;
  assign sum_3361 = {select_3359[5], select_3359} + {{3{sum_3360[3]}}, sum_3360};
  // hls/stages/patches.hpp:517
  logic [17:0] product_3362;
  assign product_3362 = $signed({{10{select_3358[7]}}, select_3358}) * $signed({{8{sum_3361[6]}}, sum_3361, select_3292_s4_q[2:0]});
  // hls/stages/patches.hpp:518
  logic [13:0] difference_3363;
  assign difference_3363 = {{6{select_3357_s4_q[7]}}, select_3357_s4_q} - {product_3362[17], product_3362[17:5]};
  // hls/stages/patches.hpp:524
  logic less_3364;
  assign less_3364 = $signed({{7{difference_3334[6]}}, difference_3334}) < $signed(difference_3363);
  // hls/stages/patches.hpp:480
  logic and_3367;
  assign and_3367 = equal_1810_s4_q & (not_3317 & (~less_3364));
  // hls/stages/patches.hpp:160
  logic and_3370;
  assign and_3370 = equal_1673_s4_q & (less_1807_s4_q ? (not_1809_s4_q & and_3367) : and_3367);
  // hls/stages/patches.hpp:560
  logic and_3371;
  assign and_3371 = and_3370 & and_3330;
  logic [7:0] sum_3372;
  assign sum_3372 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3371};
  // hls/stages/patches.hpp:480
  logic and_3376;
  assign and_3376 = not_3317 & (~($signed(difference_3363) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3377;
  assign and_3377 = equal_1810_s4_q & and_3376;
  // hls/stages/patches.hpp:160
  logic and_3380;
  assign and_3380 = equal_1673_s4_q & (less_1807_s4_q ? (not_1809_s4_q & and_3377) : and_3377);
  // hls/stages/patches.hpp:561
  logic and_3381;
  assign and_3381 = and_3380 & and_3330;
  logic [7:0] sum_3382;
  assign sum_3382 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3381};
  // hls/stages/patches.hpp:164
  logic and_3384;
  assign and_3384 = and_3321 & (and_3327 & not_3322);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3386;
  assign sum_3386 = {7'h0, and_3384} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:560
  logic and_3388;
  assign and_3388 = and_3370 & and_3384;
  logic [7:0] sum_3389;
  assign sum_3389 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3388};
  // hls/stages/patches.hpp:561
  logic and_3391;
  assign and_3391 = and_3380 & and_3384;
  logic [7:0] sum_3392;
  assign sum_3392 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3391};
  // hls/stages/patches.hpp:164
  logic and_3394;
  assign and_3394 = and_3321 & (patches_lower_s4_q & not_3328);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3396;
  assign sum_3396 = {7'h0, and_3394} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:560
  logic and_3398;
  assign and_3398 = and_3370 & and_3394;
  logic [7:0] sum_3399;
  assign sum_3399 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3398};
  // hls/stages/patches.hpp:561
  logic and_3401;
  assign and_3401 = and_3380 & and_3394;
  logic [7:0] sum_3402;
  assign sum_3402 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3401};
  // hls/stages/patches.hpp:164
  logic and_3404;
  assign and_3404 = and_3321 & (patches_lower_s4_q & and_3327);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3406;
  assign sum_3406 = {7'h0, and_3404} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:560
  logic and_3408;
  assign and_3408 = and_3370 & and_3404;
  logic [7:0] sum_3409;
  assign sum_3409 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3408};
  // hls/stages/patches.hpp:561
  logic and_3411;
  assign and_3411 = and_3380 & and_3404;
  logic [7:0] sum_3412;
  assign sum_3412 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3411};
  // hls/stages/agreement.hpp:1071
  logic less_3413;
  assign less_3413 = x_s4_q[5:3] < 3'h5;
  // hls/stages/agreement.hpp:1153
  logic equal_3414;
  assign equal_3414 = x_s4_q[2:0] == 3'h0;
  // hls/stages/registration.hpp:149
  logic not_3415;
  assign not_3415 = ~x_s4_q[4];
  // hls/stages/registration.hpp:156
  logic not_3416;
  assign not_3416 = ~x_s4_q[3];
  // hls/stages/patches.hpp:175
  logic and_3417;
  assign and_3417 = not_3415 & not_3416;
  logic [1:0] select_3418;
  assign select_3418 = x_s4_q[4] ? {1'b1, x_s4_q[3]} : {not_3416, 1'b1};
  logic [3:0] select_3419;
  assign select_3419 = x_s4_q[5] ? {{2{and_3417}}, 2'h0} : {not_3416, not_3415, select_3418};
  // hls/stages/agreement.hpp:1083
  logic and_3423;
  assign and_3423 = x_s4_q[6] & (not_1844_s4_q & (less_3413 & (equal_3414 & select_3419[0])));
  // hls/stages/patches.hpp:303
  logic and_3424;
  assign and_3424 = equal_1464_s4_q & and_3423;
  // hls/stages/patches.hpp:175
  logic equal_3426;
  assign equal_3426 = x_s4_q[2:0] == 3'h1;
  // hls/stages/agreement.hpp:1083
  logic and_3430;
  assign and_3430 = x_s4_q[6] & (not_1844_s4_q & (less_3413 & (select_3419[1] & equal_3426)));
  // hls/stages/patches.hpp:303
  logic and_3431;
  assign and_3431 = equal_1464_s4_q & and_3430;
  // hls/stages/patches.hpp:541
  logic [7:0] or_3433;
  assign or_3433 = (and_3424 ? patches_quarters_0_places_q : 8'h0) | (and_3431 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1083
  logic and_3437;
  assign and_3437 = not_1844_s4_q & (less_3413 & (select_3419[2] & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:303
  logic and_3439;
  assign and_3439 = equal_1464_s4_q & (x_s4_q[6] & and_3437);
  // hls/stages/agreement.hpp:1083
  logic and_3445;
  assign and_3445 = not_1844_s4_q & (less_3413 & (select_3419[3] & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:303
  logic and_3447;
  assign and_3447 = equal_1464_s4_q & (x_s4_q[6] & and_3445);
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
  // hls/stages/patches.hpp:179
  logic [4:0] sum_3464;
  assign sum_3464 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1083
  logic and_3468;
  assign and_3468 = x_s4_q[6] & (not_1844_s4_q & (less_3413 & (sum_3464[4:2] == 3'h0)));
  // hls/stages/patches.hpp:303
  logic and_3469;
  assign and_3469 = equal_1464_s4_q & and_3468;
  logic and_3473;
  assign and_3473 = equal_1464_s4_q & (x_s4_q[6] & (not_1844_s4_q & (less_3413 & equal_3426)));
  // hls/stages/patches.hpp:538
  logic [7:0] select_3476;
  assign select_3476 = and_3469 ? (patches_word_places_q + (and_3473 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3479;
  assign select_3479 = and_3469 ? (patches_word_up_q + (and_3473 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3482;
  assign select_3482 = and_3469 ? (patches_word_down_q + (and_3473 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:525
  logic [5:0] select_3486;
  assign select_3486 = ($signed(difference_3363[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3363[5:0];
  logic [5:0] select_3487;
  assign select_3487 = ($signed(14'h10) < $signed(difference_3363)) ? 6'h10 : select_3486;
  // hls/stages/patches.hpp:480
  logic [5:0] select_3489;
  assign select_3489 = equal_1810_s4_q ? (or_3316 ? 6'h0 : select_3487) : 6'h0;
  logic [5:0] select_3491;
  assign select_3491 = less_1807_s4_q ? (equal_1808_s4_q ? 6'h0 : select_3489) : select_3489;
  // hls/stages/patches.hpp:563
  logic [5:0] select_3493;
  assign select_3493 = and_3321 ? (equal_1673_s4_q ? select_3491 : 6'h0) : 6'h0;
  logic [11:0] sum_3494;
  assign sum_3494 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3493[5]}}, select_3493};
  // hls/stages/patches.hpp:303
  logic and_3498;
  assign and_3498 = equal_1464_s4_q & (x_s4_q[6] & (not_1844_s4_q & (equal_2630 & less_3413)));
  // hls/stages/agreement.hpp:1083
  logic and_3502;
  assign and_3502 = x_s4_q[6] & (not_1844_s4_q & (less_3413 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:303
  logic and_3503;
  assign and_3503 = equal_1464_s4_q & and_3502;
  // hls/stages/patches.hpp:552
  logic [7:0] select_3505;
  assign select_3505 = and_3498 ? (and_3503 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:554
  logic or_3509;
  assign or_3509 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:551
  logic select_3511;
  assign select_3511 = and_3498 ? (and_3503 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:164
  logic and_3517;
  assign and_3517 = patches_complete_q & (equal_1464_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3513_s4_q)));
  logic and_3518;
  assign and_3518 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3520;
  assign select_3520 = and_3503 ? {and_3518, patches_found_q[4:1]} : (and_3498 ? {and_3518, patches_found_q[4:1]} : patches_found_q);
  // hls/stages/patches.hpp:550
  logic select_3527;
  assign select_3527 = patches_round_ends_q ? (~(patches_found_q == 5'h0)) : patches_moved_q;
  // hls/stages/agreement.hpp:1125
  logic or_3584;
  assign or_3584 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1147
  logic equal_3586;
  assign equal_3586 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1156
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1157
  logic select_3592;
  assign select_3592 = (equal_3586 & equal_3414) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1076
  logic [10:0] sum_3595;
  assign sum_3595 = {1'b0, select_2417} + {2'h0, select_2417[9:1]};
  logic select_3598;
  assign select_3598 = (select_2414[9:3] == 7'h0) ? ((~or_3584) & (~select_3592)) : (~({sum_3595, select_2417[0]} < {2'h0, select_2414}));
  // hls/stages/agreement.hpp:1083
  logic [47:0] select_3600;
  assign select_3600 = x_s4_q[6] ? (equal_1509_s4_q ? good_q : {select_3598, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:303
  logic select_3604;
  assign select_3604 = equal_1464_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3513_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1147
  logic equal_3605;
  assign equal_3605 = x_s4_q[6:3] == 4'ha;
  logic equal_3607;
  assign equal_3607 = x_s4_q[6:3] == 4'h9;
  logic equal_3608;
  assign equal_3608 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1066
  logic [13:0] select_3610;
  assign select_3610 = equal_3607 ? counts_skin_unproven_q : (equal_3608 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3605 ? counts_nearer_q : select_3610;
  // hls/stages/agreement.hpp:1152
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1160
  logic select_3613;
  assign select_3613 = (equal_3605 & equal_3414) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1085
  logic not_3614;
  assign not_3614 = ~hidden_for_q[7];
  logic [7:0] select_3616;
  assign select_3616 = select_3613 ? (hidden_for_q + {7'h0, not_3614}) : 8'h0;
  // hls/stages/patches.hpp:303
  logic [7:0] select_3618;
  assign select_3618 = equal_1464_s4_q ? (equal_3513_s4_q ? select_3616 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1160
  logic [13:0] select_3619;
  assign select_3619 = equal_3414 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1066
  logic [7:0] select_3621;
  assign select_3621 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3623;
  assign select_3623 = equal_3608 ? cfg_unproven_skin_limit_i : (equal_3586 ? cfg_unproven_limit_i : select_3621);
  logic [7:0] limit;
  assign limit = equal_3605 ? cfg_regions_limit_i : (equal_3607 ? cfg_hidden_limit_i : select_3623);
  // hls/stages/agreement.hpp:1160
  logic not_3626;
  assign not_3626 = ~x_s4_q[2];
  logic [3:0] select_3627;
  assign select_3627 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_3626, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_3626};
  logic [7:0] select_3628;
  assign select_3628 = x_s4_q[0] ? {select_3627[3], 1'b0, select_3627[2], 1'b0, select_3627[1], 1'b0, select_3627[0], 1'b0} : {1'b0, select_3627[3], 1'b0, select_3627[2], 1'b0, select_3627[1], 1'b0, select_3627[0]};
  // hls/stages/agreement.hpp:1066
  logic [13:0] select_3632;
  assign select_3632 = equal_3607 ? counts_skin_supervised_q : (equal_3608 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3605 ? counts_textured_q : select_3632;
  // hls/stages/agreement.hpp:1160
  logic [13:0] select_3634;
  assign select_3634 = ((limit & select_3628) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3619} + {1'b0, select_3634};
  // hls/stages/patches.hpp:303
  logic select_3639;
  assign select_3639 = equal_1464_s4_q ? (equal_3414 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1158
  logic and_3644;
  assign and_3644 = too_much_q & (~(equal_3608 & equal_3414));
  // hls/stages/agreement.hpp:1159
  logic select_3649;
  assign select_3649 = (over[14] & equal_3414) ? (and_3644 | ((equal_3608 | equal_3607) | (x_s4_q[6:3] == 4'hf))) : and_3644;
  // hls/stages/agreement.hpp:1200
  logic select_3757;
  assign select_3757 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:265
  logic select_3759;
  assign select_3759 = left_first_s4_q ? done_s4_q : (and_1825_s4_q ? select_3757 : proven_q);
  // hls/stages/agreement.hpp:1233
  logic [1:0] select_3810;
  assign select_3810 = and_3809_s4_q ? {and_1975, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1234
  logic and_3811;
  assign and_3811 = select_3757 & less_3787;
  // hls/stages/agreement.hpp:424
  logic select_3814;
  assign select_3814 = and_1902_s4_q ? (less_1903_s4_q ? (select_3810[0] & and_3811) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:265
  logic select_3816;
  assign select_3816 = left_first_s4_q ? select_3814 : (and_1825_s4_q ? select_3814 : seen_q);
  logic select_3817;
  assign select_3817 = and_1825_s4_q ? select_3816 : seen_q;
  // hls/stages/agreement.hpp:424
  logic select_3820;
  assign select_3820 = and_1902_s4_q ? (less_1903_s4_q ? (select_3810[1] & and_3811) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:265
  logic select_3822;
  assign select_3822 = left_first_s4_q ? select_3820 : (and_1825_s4_q ? select_3820 : nearer_q);
  logic select_3823;
  assign select_3823 = and_1825_s4_q ? select_3822 : nearer_q;
  // hls/stages/patches.hpp:303
  logic and_3830;
  assign and_3830 = equal_1464_s4_q & (equal_3513_s4_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:1169
  logic not_3835;
  assign not_3835 = ~(or_3584 | not_3824);
  // hls/stages/patches.hpp:303
  logic and_3839;
  assign and_3839 = equal_1464_s4_q & (equal_3513_s4_q & (not_3835 & (select_3592 | select_3649)));
  logic and_3842;
  assign and_3842 = equal_3513_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1087
  logic or_3846;
  assign or_3846 = select_2228 | (select_2240 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:303
  logic and_3853;
  assign and_3853 = equal_1464_s4_q & (equal_3513_s4_q & (not_3835 & (select_2234 | select_2246)));
  // hls/stages/agreement.hpp:1087
  logic and_3858;
  assign and_3858 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3616 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:303
  logic and_3865;
  assign and_3865 = equal_1464_s4_q & (x_s4_q[6] & (not_1844_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1081
  logic [31:0] select_3873;
  assign select_3873 = equal_1531_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3871_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3874;
  assign select_3874 = equal_1529_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3873;
  logic [31:0] select_3875;
  assign select_3875 = equal_1527_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3874;
  logic [31:0] select_3876;
  assign select_3876 = equal_1525_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3875;
  logic [31:0] select_3877;
  assign select_3877 = equal_1523_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3876;
  logic [31:0] select_3878;
  assign select_3878 = equal_1521_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3877;
  logic [31:0] select_3879;
  assign select_3879 = equal_1519_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3878;
  logic [31:0] select_3880;
  assign select_3880 = equal_1517_s4_q ? {7'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3879;
  // hls/stages/agreement.hpp:1079
  logic [9:0] select_3881;
  assign select_3881 = less_2413 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1083
  logic [31:0] select_3882;
  assign select_3882 = equal_1509_s4_q ? select_3880 : {2'h0, select_3881, select_2417, select_2414};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_495_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_610, and_586_s4_q, and_585_s4_q, and_560_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q, less_537_s4_q, less_536_s4_q, less_535_s4_q, less_534_s4_q, less_533_s4_q, less_532_s4_q, less_531_s4_q, less_530_s4_q, less_529_s4_q};
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
  assign registration_sums_waddr = {sum_1515_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1574_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1573, sum_1569};
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

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_1603_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_1672_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1665_s4_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_choices_we) begin
      if (patches_choices_re && patches_choices_raddr == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
    end
  end
`endif

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1700_s4_q, select_1697};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_1709);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s4_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_0_raddr_s2_sim;
  logic patches_right_0_re_s2_sim;
  logic [9:0] patches_right_0_raddr_s3_sim;
  logic patches_right_0_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_0_re_s2_sim <= 1'b0;
      patches_right_0_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_0_re_s2_sim <= patches_right_0_re;
      patches_right_0_raddr_s2_sim <= patches_right_0_raddr;
      patches_right_0_re_s3_sim <= patches_right_0_re_s2_sim;
      patches_right_0_raddr_s3_sim <= patches_right_0_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_0_we) begin
      if (patches_right_0_re && patches_right_0_raddr == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s2_sim && patches_right_0_raddr_s2_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s3_sim && patches_right_0_raddr_s3_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_1700_s4_q, select_1723};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_1726);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s4_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_1_raddr_s2_sim;
  logic patches_right_1_re_s2_sim;
  logic [9:0] patches_right_1_raddr_s3_sim;
  logic patches_right_1_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_1_re_s2_sim <= 1'b0;
      patches_right_1_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_1_re_s2_sim <= patches_right_1_re;
      patches_right_1_raddr_s2_sim <= patches_right_1_raddr;
      patches_right_1_re_s3_sim <= patches_right_1_re_s2_sim;
      patches_right_1_raddr_s3_sim <= patches_right_1_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_1_we) begin
      if (patches_right_1_re && patches_right_1_raddr == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s2_sim && patches_right_1_raddr_s2_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s3_sim && patches_right_1_raddr_s3_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
    end
  end
`endif

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1743, select_1742_s4_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_1749);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s4_q;
  end
`ifndef SYNTHESIS
  logic [8:0] patches_left_raddr_s2_sim;
  logic patches_left_re_s2_sim;
  logic [8:0] patches_left_raddr_s3_sim;
  logic patches_left_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_re_s2_sim <= 1'b0;
      patches_left_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_re_s2_sim <= patches_left_re;
      patches_left_raddr_s2_sim <= patches_left_raddr;
      patches_left_re_s3_sim <= patches_left_re_s2_sim;
      patches_left_raddr_s3_sim <= patches_left_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_we) begin
      if (patches_left_re && patches_left_raddr == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s2_sim && patches_left_raddr_s2_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s3_sim && patches_left_raddr_s3_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
    end
  end
`endif

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s4_q;
  logic patches_rows_we;
  assign patches_rows_we = s4_en & patches_summed_last_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1832;
  end
`ifndef SYNTHESIS
  logic [4:0] patches_rows_raddr_s3_sim;
  logic patches_rows_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_rows_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      patches_rows_re_s3_sim <= patches_rows_re;
      patches_rows_raddr_s3_sim <= patches_rows_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s3_sim && patches_rows_raddr_s3_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_1842_s4_q, or_1839_s4_q, or_1836_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1870_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1869, sum_1863, sum_1858};
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
  assign map_waddr = sum_1911_s4_q;
  logic map_we;
  assign map_we = s4_en & and_1985_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1975, is_seen};
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
      patches_place_0_column_q <= 7'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_column_q <= 7'h0;
      patches_place_1_shift_q <= 6'h0;
      patches_place_1_slope_q <= 8'h0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
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
      census_left_misses_q <= select_2134;
      sharpness_before_last_mask_q <= select_2142;
      sharpness_sums_detail_0_q <= and_495_s4_q ? select_2156 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_495_s4_q ? select_2168 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_495_s4_q ? sum_2172 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_495_s4_q ? sum_2176 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2194 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2204 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2206 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2208 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2210 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2212 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2217;
      sharpness_comparing_carry_1_q <= select_2221;
      sharpness_comparing_less_detail_0_q <= select_2228;
      sharpness_comparing_less_detail_1_q <= select_2234;
      sharpness_comparing_less_contrast_0_q <= select_2240;
      sharpness_comparing_less_contrast_1_q <= select_2246;
      counts_supervised_q <= select_2371;
      counts_textured_q <= and_2365_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2374});
      counts_explained_q <= and_2365_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2379});
      counts_nearer_q <= and_2365_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2384});
      counts_unproven_q <= and_2365_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2410});
      counts_regions_bad_q <= select_2426;
      counts_skin_supervised_q <= select_2433;
      counts_skin_textured_q <= select_2440;
      counts_skin_unproven_q <= select_2448;
      registration_half_across_q <= select_2497;
      registration_half_measured_q <= select_2502;
      registration_half_votes_down_q <= and_2478_s4_q ? 7'h0 : sum_2508;
      registration_half_votes_up_q <= and_2478_s4_q ? 7'h0 : sum_2516;
      registration_half_half_votes_down_q <= and_2478_s4_q ? 7'h0 : sum_2523;
      registration_half_half_votes_up_q <= and_2478_s4_q ? 7'h0 : sum_2530;
      registration_down_q <= and_2564 ? sum_2583 : registration_down_q;
      registration_up_q <= and_2564 ? sum_2592 : registration_up_q;
      registration_enough_q <= select_2606;
      registration_votes_down_q <= and_2611 ? less_2612 : registration_votes_down_q;
      registration_votes_up_q <= and_2611 ? less_2614 : registration_votes_up_q;
      registration_other_enough_q <= and_2620 ? select_2606 : registration_other_enough_q;
      registration_other_down_q <= and_2620 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2620 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1464_s4_q & and_2627)) & or_2652;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_1691 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_1692 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2735;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_1717 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_1718 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2739;
      patches_valid_0_q <= select_2744;
      patches_valid_1_q <= select_2749;
      patches_right_next_0_q <= select_2752;
      patches_right_next_1_q <= select_2755;
      patches_left_next_0_q <= select_2758;
      patches_left_next_1_q <= select_2761;
      patches_sums_values_0_q <= select_3177;
      patches_sums_values_1_q <= equal_1673_s4_q ? patches_sums_values_1_q : select_3178;
      patches_sums_values_2_q <= equal_1673_s4_q ? patches_sums_values_2_q : select_3180;
      patches_sums_values_3_q <= equal_1673_s4_q ? patches_sums_values_3_q : select_3182;
      patches_sums_values_4_q <= equal_1673_s4_q ? patches_sums_values_4_q : select_3184;
      patches_sums_values_5_q <= equal_1673_s4_q ? patches_sums_values_5_q : select_3186;
      patches_sums_values_6_q <= equal_1673_s4_q ? patches_sums_values_6_q : select_3188;
      patches_sums_values_7_q <= equal_1673_s4_q ? patches_sums_values_7_q : select_3190;
      patches_sums_values_8_q <= equal_1673_s4_q ? patches_sums_values_8_q : select_3192;
      patches_sums_values_9_q <= equal_1673_s4_q ? patches_sums_values_9_q : select_3194;
      patches_sums_values_10_q <= equal_1673_s4_q ? patches_sums_values_10_q : select_3196;
      patches_sums_values_11_q <= equal_1673_s4_q ? patches_sums_values_11_q : select_3198;
      patches_sums_values_12_q <= equal_1673_s4_q ? patches_sums_values_12_q : select_3200;
      patches_sums_values_13_q <= equal_1673_s4_q ? patches_sums_values_13_q : select_3202;
      patches_sums_values_14_q <= equal_1673_s4_q ? patches_sums_values_14_q : select_3204;
      patches_sums_values_15_q <= equal_1673_s4_q ? patches_sums_values_15_q : select_3206;
      patches_sums_values_16_q <= equal_1673_s4_q ? patches_sums_values_16_q : select_3208;
      patches_best_differing_q <= select_1832[9:0];
      patches_best_column_q <= select_1832[14:10];
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
      patches_sum_places_q <= select_3476;
      patches_sum_up_q <= select_3479;
      patches_sum_down_q <= select_3482;
      patches_across_q <= sum_3494;
      patches_places_q <= select_3505;
      patches_enough_q <= {4'h0, and_3503} < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3509;
      patches_complete_q <= select_3511;
      patches_round_ends_q <= and_3517;
      patches_found_q <= and_3498 ? select_3520 : patches_found_q;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_moved_q <= select_3527;
      segment_textured_q <= select_1855 + {5'h0, and_2374};
      segment_explained_q <= select_1860 + {5'h0, and_2379};
      segment_nearer_q <= select_1866 + {5'h0, and_2384};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1464_s4_q ? select_3600 : good_q;
      good_known_q <= select_3604;
      hidden_for_q <= select_3618;
      product_q <= equal_1464_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3639;
      disagree_q <= equal_1464_s4_q ? select_3592 : disagree_q;
      too_much_q <= equal_1464_s4_q ? select_3649 : too_much_q;
      hides_q <= equal_1464_s4_q ? select_3613 : hides_q;
      proven_q <= and_1825_s4_q ? select_3759 : proven_q;
      seen_q <= select_3817;
      nearer_q <= select_3823;
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
      averager_quarter_1_0_q <= select_2009;
      averager_quarter_1_1_q <= select_2011;
      averager_quarter_2_0_q <= select_2013;
      averager_quarter_2_1_q <= select_2015;
      averager_detail_0_q <= select_2027;
      averager_detail_1_q <= select_2035;
      census_changes_values_0_left_q <= and_495_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_495_s4_q ? sum_2118 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2120;
      census_changes_values_1_right_q <= select_2121;
      census_changes_values_2_left_q <= select_2122;
      census_changes_values_2_right_q <= select_2123;
      sharpness_last_mask_q <= and_495_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_495_s4_q ? select_2139[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_495_s4_q ? select_2139[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3761_s5_q;
  logic or_3825_s5_q;
  logic and_3826_s5_q;
  logic and_3830_s5_q;
  logic and_3833_s5_q;
  logic and_3839_s5_q;
  logic and_3843_s5_q;
  logic and_3849_s5_q;
  logic and_3853_s5_q;
  logic and_3861_s5_q;
  logic and_3865_s5_q;
  logic [5:0] select_3867_s5_q;
  logic [31:0] select_3884_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_3761_s5_q <= said_q;
      or_3825_s5_q <= not_3824 | select_3817;
      and_3826_s5_q <= cfg_prove_i & select_3823;
      and_3830_s5_q <= and_3830;
      and_3833_s5_q <= equal_1464_s4_q & (equal_3513_s4_q & (cfg_prove_i & or_3584));
      and_3839_s5_q <= and_3839;
      and_3843_s5_q <= equal_1464_s4_q & and_3842;
      and_3849_s5_q <= equal_1464_s4_q & (equal_3513_s4_q & (not_3835 & or_3846));
      and_3853_s5_q <= and_3853;
      and_3861_s5_q <= equal_1464_s4_q & (equal_3513_s4_q & (cfg_prove_i & and_3858));
      and_3865_s5_q <= and_3865;
      select_3867_s5_q <= equal_1464_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3884_s5_q <= equal_1464_s4_q ? (x_s4_q[6] ? select_3882 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3825_s5_q;
  assign marks_nearer_o = and_3826_s5_q;
  assign verdict_valid_o = and_3761_s5_q;
  assign verdict_unproven_yet_o = and_3830_s5_q;
  assign verdict_untextured_o = and_3833_s5_q;
  assign verdict_disagree_o = and_3839_s5_q;
  assign verdict_moved_o = and_3843_s5_q;
  assign verdict_unsharp_left_o = and_3849_s5_q;
  assign verdict_unsharp_right_o = and_3853_s5_q;
  assign verdict_hidden_o = and_3861_s5_q;
  assign frame_valid_o = and_3865_s5_q;
  assign frame_index_o = select_3867_s5_q;
  assign frame_word_o = select_3884_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3464[1:0], product_3362[4:0], sum_2470[0], detail_4[1:0], detail_3[1:0], sum_2128[4:0], sum_1653[0], sum_1649[0], sum_608[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
