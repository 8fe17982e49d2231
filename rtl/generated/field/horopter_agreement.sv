// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2921 bits, pipeline 894 bits, memories 58067 bits.
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
  logic [5:0] sum_2381;
  assign sum_2381 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3394;
  assign difference_3394 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_3642;
  assign difference_3642 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3875;
  assign less_3875 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3876;
  assign sum_3876 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3877;
  assign select_3877 = less_3875 ? {sum_3876, cfg_height_i[5:3]} : 8'h0;
  logic not_3912;
  assign not_3912 = ~cfg_prove_i;

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
  logic shift_first_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_475;
  assign select_475 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_477;
  assign select_477 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_480;
  assign select_480 = ({select_477, select_475} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_481;
  assign select_481 = select_475[0] ? averager_place_q : select_480;
  // hls/stages/census.hpp:41
  logic or_482;
  assign or_482 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:405
  logic and_485;
  assign and_485 = (select_475[0] & or_482) & (select_481 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_490;
  assign select_490 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:264
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_477 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_507;
  assign equal_507 = select_475 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_508;
  assign equal_508 = select_490 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_509;
  assign and_509 = equal_508 & and_485;
  // hls/stages/agreement.hpp:264
  logic and_511;
  assign and_511 = sample_pair_whole_q & (equal_507 & and_509);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:611
  logic equal_531;
  assign equal_531 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:582
  logic or_532;
  assign or_532 = so | equal_531;
  // hls/stages/agreement.hpp:705
  logic not_533;
  assign not_533 = ~or_532;
  // hls/stages/agreement.hpp:602
  logic equal_534;
  assign equal_534 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:603
  logic equal_536;
  assign equal_536 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:580
  logic [7:0] sum_537;
  assign sum_537 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:582
  logic [7:0] select_538;
  assign select_538 = run_shift_q[5] ? x_q : sum_537;
  logic less_539;
  assign less_539 = {2'h0, last_q} < select_538;
  // hls/stages/agreement.hpp:216
  logic not_540;
  assign not_540 = ~less_539;
  // hls/stages/agreement.hpp:141
  logic and_541;
  assign and_541 = equal_536 & not_540;
  logic and_543;
  assign and_543 = not_533 & ((~equal_534) & and_541);
  // hls/stages/census.hpp:41
  logic [5:0] select_570;
  assign select_570 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:264
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_570 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_627;
  assign select_627 = equal_534 ? not_540 : and_541;
  // hls/stages/agreement.hpp:783
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_647;
  assign sum_647 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:141
  logic and_652;
  assign and_652 = equal_534 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_647} < select_538))));
  logic select_653;
  assign select_653 = or_532 ? not_540 : and_652;
  // hls/stages/agreement.hpp:804
  logic [5:0] right;
  assign right = sum_537[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:182
  logic and_1863;
  assign and_1863 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:264
  logic [2:0] select_2028;
  assign select_2028 = sample_pair_whole_q ? (sample_last_q ? (select_490 + 3'h1) : select_490) : raster_at_y_q;
  logic [5:0] select_2030;
  assign select_2030 = sample_pair_whole_q ? (select_477 + {5'h0, equal_507}) : raster_at_column_q;
  logic [5:0] select_2033;
  assign select_2033 = sample_pair_whole_q ? (sample_last_q ? (select_570 + {5'h0, equal_508}) : select_570) : raster_at_row_q;
  logic select_2037;
  assign select_2037 = sample_pair_whole_q ? (sample_last_q ? (or_482 & (~raster_final_row_q)) : or_482) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2039;
  assign select_2039 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:264
  logic select_2043;
  assign select_2043 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:447
  logic equal_2287;
  assign equal_2287 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:452
  logic and_2288;
  assign and_2288 = and_511 & equal_2287;
  // hls/stages/agreement.hpp:511
  logic select_2291;
  assign select_2291 = (and_2288 | (~ends_cell_q)) ? and_2288 : ends_q;
  // hls/stages/agreement.hpp:517
  logic [2:0] now;
  assign now = select_2291 ? (and_2288 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:522
  logic [5:0] select_2295;
  assign select_2295 = select_2291 ? (and_2288 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2298;
  assign select_2298 = select_2291 ? (following_last_shift_q & (~and_2288)) : run_last_shift_q;
  // hls/stages/agreement.hpp:595
  logic and_2301;
  assign and_2301 = run_last_shift_q & equal_534;
  // hls/stages/agreement.hpp:604
  logic select_2303;
  assign select_2303 = equal_534 ? (~run_last_shift_q) : equal_536;
  // hls/stages/agreement.hpp:608
  logic equal_2304;
  assign equal_2304 = run_phase_q == 3'h1;
  logic not_2307;
  assign not_2307 = ~select_2303;
  // hls/stages/agreement.hpp:611
  logic equal_2309;
  assign equal_2309 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:595
  logic and_2310;
  assign and_2310 = final_row_q & so;
  // hls/stages/agreement.hpp:608
  logic [1:0] select_2311;
  assign select_2311 = equal_2309 ? 2'h1 : {2{and_2310}};
  logic [2:0] select_2313;
  assign select_2313 = (and_2301 | (select_2303 | equal_2304)) ? (equal_2304 ? 3'h2 : {not_2307, {2{select_2303}}}) : (equal_531 ? 3'h6 : {select_2311[0], select_2311});
  // hls/stages/agreement.hpp:595
  logic and_2316;
  assign and_2316 = select_2303 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:618
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2319;
  assign select_2319 = (plan_shift_q[5] & select_2303) ? value : 7'h0;
  logic [1:0] or_2320;
  assign or_2320 = {2{so}} | select_2319[5:4];
  // hls/stages/agreement.hpp:621
  logic [7:0] select_2321;
  assign select_2321 = select_2303 ? plan_columns_q : 8'h0;
  logic [6:0] or_2324;
  assign or_2324 = select_2321[6:0] | ((equal_2304 | equal_2309) ? whole_q : 7'h0);
  logic [1:0] or_2325;
  assign or_2325 = {2{and_2301}} | or_2324[3:2];
  // hls/stages/agreement.hpp:622
  logic [6:0] or_2327;
  assign or_2327 = {or_2324[6:4], or_2325, or_2324[1:0]} | (equal_531 ? drawn_q : 7'h0);
  logic [4:0] or_2328;
  assign or_2328 = {5{so}} | {or_2327[6], or_2327[3:0]};
  // hls/stages/agreement.hpp:628
  logic not_2332;
  assign not_2332 = ~run_shift_q[5];
  logic [6:0] difference_2334;
  assign difference_2334 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2335;
  assign select_2335 = equal_534 ? ({{7{not_2332}}, 1'b1} + run_span_q) : {difference_2334[6], difference_2334};
  // hls/stages/agreement.hpp:511
  logic [6:0] select_2339;
  assign select_2339 = and_2288 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:514
  logic [7:0] select_2341;
  assign select_2341 = select_2291 ? {select_2339[6], select_2339} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2344;
  assign select_2344 = select_2291 ? (and_2288 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:508
  logic [5:0] select_2352;
  assign select_2352 = and_511 ? (equal_2287 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2355;
  assign select_2355 = and_511 ? (equal_2287 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2358;
  assign select_2358 = and_511 ? (equal_2287 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:519
  logic select_2372;
  assign select_2372 = (ends_cell_q | select_2291) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_534 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:514
  logic and_2376;
  assign and_2376 = (~select_2291) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:464
  logic [6:0] sum_2377;
  assign sum_2377 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:448
  logic select_2379;
  assign select_2379 = equal_2287 ? ({sum_2377[6], cfg_height_i[8:3]} == {1'b0, sum_2377[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:361
  logic or_2770;
  assign or_2770 = select_477[0] | select_570[5];
  logic [7:0] sum_2771;
  assign sum_2771 = {1'b0, select_477[2:1], or_2770, select_570[4:1]} + 8'h1;
  logic less_2772;
  assign less_2772 = {sum_2771, select_570[0], select_490, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1305; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_543;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1306; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (or_532 ? not_540 : select_627);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1307; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_534 ? sum_537[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_533 & select_627);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 46, DISTANCE 12, hls/stages/agreement.hpp:1308; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [45:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 46'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_532 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_653;
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
      shift_first_q <= 1'b0;
    end else if (s0_en) begin
      left_first_q <= and_1863 ? left_first_q : marks_first_i;
      right_q <= (~and_1863) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1863;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_475 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2028;
      raster_at_column_q <= select_2030;
      raster_at_row_q <= select_2033;
      raster_at_live_q <= select_2037;
      raster_rows_left_q <= sample_pair_whole_q ? select_2039 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2043;
      averager_place_q <= sample_pair_whole_q ? select_481 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2295;
      run_last_shift_q <= select_2298;
      run_span_q <= select_2291 ? (and_2288 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2313;
      following_shift_q <= select_2303 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2316;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2319[6], or_2320, select_2319[3:0]};
      following_columns_q <= {select_2321[7], or_2328[4], or_2327[5:4], or_2328[3:0]};
      plan_shift_q <= equal_534 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2335;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2341;
      columns_left_q <= select_2344;
      last_q <= and_511 ? (equal_2287 ? column : last_q) : last_q;
      least_q <= select_2352;
      whole_q <= select_2355;
      drawn_q <= select_2358;
      age_q <= select_2291 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2291 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2372;
      ends_q <= and_2376;
      final_row_q <= and_511 ? select_2379 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
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
  logic shift_first_s1_q;
  logic [2:0] select_475_s1_q;
  logic [5:0] select_477_s1_q;
  logic [7:0] select_481_s1_q;
  logic and_485_s1_q;
  logic equal_491_s1_q;
  logic [5:0] column_s1_q;
  logic and_509_s1_q;
  logic and_511_s1_q;
  logic so_s1_q;
  logic equal_531_s1_q;
  logic or_532_s1_q;
  logic equal_534_s1_q;
  logic less_539_s1_q;
  logic not_540_s1_q;
  logic and_543_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_653_s1_q;
  logic and_1451_s1_q;
  logic [5:0] right_s1_q;
  logic equal_1459_s1_q;
  logic equal_1469_s1_q;
  logic equal_1588_s1_q;
  logic equal_2287_s1_q;
  logic and_2288_s1_q;
  logic not_2773_s1_q;
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
      shift_first_s1_q <= shift_first_q;
      select_475_s1_q <= select_475;
      select_477_s1_q <= select_477;
      select_481_s1_q <= select_481;
      and_485_s1_q <= and_485;
      equal_491_s1_q <= select_490 == 3'h0;
      column_s1_q <= column;
      and_509_s1_q <= and_509;
      and_511_s1_q <= and_511;
      so_s1_q <= so;
      equal_531_s1_q <= equal_531;
      or_532_s1_q <= or_532;
      equal_534_s1_q <= equal_534;
      less_539_s1_q <= less_539;
      not_540_s1_q <= not_540;
      and_543_s1_q <= and_543;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_653_s1_q <= select_653;
      and_1451_s1_q <= not_533 & and_652;
      right_s1_q <= right;
      equal_1459_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      equal_1469_s1_q <= run_phase_q == 3'h7;
      equal_1588_s1_q <= {or_482, select_490} == 4'hc;
      equal_2287_s1_q <= equal_2287;
      and_2288_s1_q <= and_2288;
      not_2773_s1_q <= ~less_2772;
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
  // hls/stages/agreement.hpp:654
  logic not_631;
  assign not_631 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:657
  logic and_632;
  assign and_632 = left_rdata_q[12] & not_631;
  logic and_633;
  assign and_633 = left_rdata_q[28] & not_631;
  logic and_634;
  assign and_634 = left_rdata_q[44] & not_631;
  logic and_635;
  assign and_635 = left_rdata_q[60] & not_631;
  // hls/stages/agreement.hpp:658
  logic and_639;
  assign and_639 = right_codes_rdata_q[12] & not_631;
  logic and_640;
  assign and_640 = right_codes_rdata_q[25] & not_631;
  logic and_641;
  assign and_641 = right_codes_rdata_q[38] & not_631;
  logic and_642;
  assign and_642 = right_codes_rdata_q[51] & not_631;
  logic and_643;
  assign and_643 = right_codes_rdata_q[64] & not_631;
  logic and_644;
  assign and_644 = right_codes_rdata_q[77] & not_631;
  // hls/stages/agreement.hpp:212
  logic and_659;
  assign and_659 = left_rdata_q[44] & not_540_s1_q;
  logic and_660;
  assign and_660 = right_codes_rdata_q[38] & not_540_s1_q;
  logic [11:0] select_661;
  assign select_661 = less_539_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_662;
  assign select_662 = less_539_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_666;
  assign select_666 = and_659 ? (and_660 ? (~(select_661 ^ select_662)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_672;
  assign parity_672 = ^select_666[5:3];
  logic parity_675;
  assign parity_675 = ^select_666[8:6];
  logic parity_678;
  assign parity_678 = ^select_666[11:3];
  // hls/stages/agreement.hpp:212
  logic and_682;
  assign and_682 = left_rdata_q[60] & not_540_s1_q;
  logic and_683;
  assign and_683 = right_codes_rdata_q[51] & not_540_s1_q;
  logic [11:0] select_684;
  assign select_684 = less_539_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_685;
  assign select_685 = less_539_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_689;
  assign select_689 = and_682 ? (and_683 ? (~(select_684 ^ select_685)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_692;
  assign parity_692 = ^select_689[8:6];
  logic parity_695;
  assign parity_695 = ^select_689[11:9];
  // hls/stages/agreement.hpp:212
  logic and_699;
  assign and_699 = left_rdata_q[76] & not_540_s1_q;
  logic and_700;
  assign and_700 = right_codes_rdata_q[64] & not_540_s1_q;
  logic [11:0] select_701;
  assign select_701 = less_539_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_702;
  assign select_702 = less_539_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_706;
  assign select_706 = and_699 ? (and_700 ? (~(select_701 ^ select_702)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_712;
  assign parity_712 = ^select_706[2:0];
  logic parity_715;
  assign parity_715 = ^select_706[5:3];
  logic parity_718;
  assign parity_718 = ^select_706[8:0];
  logic parity_724;
  assign parity_724 = ^select_706[11:9];
  logic parity_727;
  assign parity_727 = ^select_689[2:0];
  logic parity_730;
  assign parity_730 = ^{select_706[11:9], select_689[5:0]};
  logic parity_733;
  assign parity_733 = ^{select_706, select_689, select_666[2:0]};
  logic xor_734;
  assign xor_734 = parity_678 ^ parity_733;
  // hls/stages/count_bits.hpp:23
  logic or_738;
  assign or_738 = (select_666[1:0] == 2'h3) | (select_666[2] & (select_666[0] | select_666[1]));
  // hls/stages/count_bits.hpp:25
  logic or_742;
  assign or_742 = (select_689[7:6] == 2'h3) | (select_689[8] & (select_689[6] | select_689[7]));
  logic or_746;
  assign or_746 = (select_689[10:9] == 2'h3) | (select_689[11] & (select_689[9] | select_689[10]));
  // hls/stages/count_bits.hpp:23
  logic or_754;
  assign or_754 = (select_706[7:6] == 2'h3) | (select_706[8] & (~(select_706[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_758;
  assign or_758 = (select_706[1:0] == 2'h3) | (select_706[2] & (select_706[0] | select_706[1]));
  logic or_762;
  assign or_762 = (select_706[4:3] == 2'h3) | (select_706[5] & (select_706[3] | select_706[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_765;
  assign parity_765 = ^{or_762, or_758, or_754};
  // hls/stages/count_bits.hpp:23
  logic or_769;
  assign or_769 = (select_689[4:3] == 2'h3) | (select_689[5] & (select_689[3] | select_689[4]));
  // hls/stages/count_bits.hpp:25
  logic or_773;
  assign or_773 = (select_706[10:9] == 2'h3) | (select_706[11] & (select_706[9] | select_706[10]));
  logic or_777;
  assign or_777 = (select_689[1:0] == 2'h3) | (select_689[2] & (select_689[0] | select_689[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_780;
  assign parity_780 = ^{or_777, or_773, or_769};
  logic parity_783;
  assign parity_783 = ^{or_777, or_773, or_769, or_762, or_758, or_754, or_746, or_742, or_738};
  // hls/stages/count_bits.hpp:25
  logic and_784;
  assign and_784 = parity_678 & parity_733;
  logic or_788;
  assign or_788 = (parity_672 & parity_675) | ((^select_666[11:9]) & (parity_672 | parity_675));
  logic and_791;
  assign and_791 = (^{select_689[11:6], select_666[2:0]}) & (parity_718 | parity_730);
  logic or_792;
  assign or_792 = (parity_718 & parity_730) | and_791;
  // hls/stages/count_bits.hpp:23
  logic or_799;
  assign or_799 = (select_666[10:9] == 2'h3) | (select_666[11] & (select_666[9] | select_666[10]));
  // hls/stages/count_bits.hpp:25
  logic or_803;
  assign or_803 = (select_666[4:3] == 2'h3) | (select_666[5] & (select_666[3] | select_666[4]));
  logic or_807;
  assign or_807 = (select_666[7:6] == 2'h3) | (select_666[8] & (select_666[6] | select_666[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_810;
  assign parity_810 = ^{or_807, or_803, or_799};
  // hls/stages/count_bits.hpp:25
  logic or_814;
  assign or_814 = (parity_692 & parity_695) | ((^select_666[2:0]) & (parity_692 | parity_695));
  logic or_818;
  assign or_818 = (parity_712 & parity_715) | ((^select_706[8:6]) & (parity_712 | parity_715));
  logic or_822;
  assign or_822 = (parity_724 & parity_727) | ((^select_689[5:3]) & (parity_724 | parity_727));
  // hls/stages/count_bits.hpp:24
  logic parity_825;
  assign parity_825 = ^{or_822, or_818, or_814};
  logic parity_828;
  assign parity_828 = ^{or_822, or_818, or_814, or_807, or_803, or_799, or_792, or_788, and_784};
  logic xor_829;
  assign xor_829 = parity_783 ^ parity_828;
  // hls/stages/count_bits.hpp:25
  logic and_830;
  assign and_830 = parity_783 & parity_828;
  logic or_834;
  assign or_834 = (parity_765 & parity_780) | ((^{or_746, or_742, or_738}) & (parity_765 | parity_780));
  logic or_838;
  assign or_838 = (parity_810 & parity_825) | ((^{or_792, or_788, and_784}) & (parity_810 | parity_825));
  logic or_845;
  assign or_845 = (or_742 & or_746) | (or_738 & (or_742 | or_746));
  logic or_849;
  assign or_849 = (or_758 & or_762) | (or_754 & (or_758 | or_762));
  logic or_853;
  assign or_853 = (or_773 & or_777) | (or_769 & (or_773 | or_777));
  // hls/stages/count_bits.hpp:24
  logic parity_856;
  assign parity_856 = ^{or_853, or_849, or_845};
  // hls/stages/count_bits.hpp:25
  logic or_860;
  assign or_860 = (or_788 & or_792) | (and_784 & (or_788 | or_792));
  logic or_864;
  assign or_864 = (or_803 & or_807) | (or_799 & (or_803 | or_807));
  logic or_868;
  assign or_868 = (or_818 & or_822) | (or_814 & (or_818 | or_822));
  // hls/stages/count_bits.hpp:24
  logic parity_871;
  assign parity_871 = ^{or_868, or_864, or_860};
  logic parity_874;
  assign parity_874 = ^{or_868, or_864, or_860, or_853, or_849, or_845, or_838, or_834, and_830};
  // hls/stages/count_bits.hpp:25
  logic or_878;
  assign or_878 = (parity_856 & parity_871) | ((^{or_838, or_834, and_830}) & (parity_856 | parity_871));
  logic or_882;
  assign or_882 = (or_834 & or_838) | (and_830 & (or_834 | or_838));
  logic or_886;
  assign or_886 = (or_849 & or_853) | (or_845 & (or_849 | or_853));
  logic or_890;
  assign or_890 = (or_864 & or_868) | (or_860 & (or_864 | or_868));
  // hls/stages/count_bits.hpp:24
  logic parity_895;
  assign parity_895 = ^{or_890, or_886, or_882, or_878};
  // hls/stages/count_bits.hpp:25
  logic or_899;
  assign or_899 = (or_886 & or_890) | (or_882 & (or_886 | or_890));
  logic and_900;
  assign and_900 = or_878 & (^{or_890, or_886, or_882});
  // hls/stages/count_bits.hpp:24
  logic xor_901;
  assign xor_901 = or_899 ^ and_900;
  // hls/stages/count_bits.hpp:27
  logic and_902;
  assign and_902 = or_899 & and_900;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_903;
  assign select_903 = equal_534_s1_q ? {and_902, xor_901, parity_895, parity_874, xor_829, xor_734} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_532_s1_q ? 6'h0 : select_903;
  // hls/stages/agreement.hpp:670
  logic [11:0] select_914;
  assign select_914 = (slot_s1_q[0] ? and_700 : and_683) ? (~(select_662 ^ (slot_s1_q[0] ? select_701 : select_684))) : 12'h0;
  logic [11:0] select_915;
  assign select_915 = and_659 ? select_914 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_921;
  assign parity_921 = ^select_915[5:3];
  logic parity_924;
  assign parity_924 = ^select_915[8:6];
  logic parity_927;
  assign parity_927 = ^select_915[11:3];
  // hls/stages/agreement.hpp:212
  logic and_931;
  assign and_931 = right_codes_rdata_q[77] & not_540_s1_q;
  logic [11:0] select_933;
  assign select_933 = less_539_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_937;
  assign select_937 = (slot_s1_q[0] ? and_931 : and_700) ? (~(select_685 ^ (slot_s1_q[0] ? select_933 : select_701))) : 12'h0;
  logic [11:0] select_938;
  assign select_938 = and_682 ? select_937 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_941;
  assign parity_941 = ^select_938[8:6];
  logic parity_944;
  assign parity_944 = ^select_938[11:9];
  // hls/stages/agreement.hpp:719
  logic select_949;
  assign select_949 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_540_s1_q) : and_931;
  logic [11:0] select_951;
  assign select_951 = slot_s1_q[0] ? (less_539_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_933;
  // hls/stages/agreement.hpp:670
  logic [11:0] select_955;
  assign select_955 = and_699 ? (select_949 ? (~(select_702 ^ select_951)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_961;
  assign parity_961 = ^select_955[2:0];
  logic parity_964;
  assign parity_964 = ^select_955[5:3];
  logic parity_967;
  assign parity_967 = ^select_955[8:0];
  logic parity_973;
  assign parity_973 = ^select_955[11:9];
  logic parity_976;
  assign parity_976 = ^select_938[2:0];
  logic parity_979;
  assign parity_979 = ^{select_955[11:9], select_938[5:0]};
  logic parity_982;
  assign parity_982 = ^{select_955, select_938, select_915[2:0]};
  logic xor_983;
  assign xor_983 = parity_927 ^ parity_982;
  // hls/stages/count_bits.hpp:23
  logic or_987;
  assign or_987 = (select_915[1:0] == 2'h3) | (select_915[2] & (select_915[0] | select_915[1]));
  // hls/stages/count_bits.hpp:25
  logic or_991;
  assign or_991 = (select_938[7:6] == 2'h3) | (select_938[8] & (select_938[6] | select_938[7]));
  logic or_995;
  assign or_995 = (select_938[10:9] == 2'h3) | (select_938[11] & (select_938[9] | select_938[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1003;
  assign or_1003 = (select_955[7:6] == 2'h3) | (select_955[8] & (~(select_955[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1007;
  assign or_1007 = (select_955[1:0] == 2'h3) | (select_955[2] & (select_955[0] | select_955[1]));
  logic or_1011;
  assign or_1011 = (select_955[4:3] == 2'h3) | (select_955[5] & (select_955[3] | select_955[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1014;
  assign parity_1014 = ^{or_1011, or_1007, or_1003};
  // hls/stages/count_bits.hpp:23
  logic or_1018;
  assign or_1018 = (select_938[4:3] == 2'h3) | (select_938[5] & (select_938[3] | select_938[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1022;
  assign or_1022 = (select_955[10:9] == 2'h3) | (select_955[11] & (select_955[9] | select_955[10]));
  logic or_1026;
  assign or_1026 = (select_938[1:0] == 2'h3) | (select_938[2] & (select_938[0] | select_938[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1029;
  assign parity_1029 = ^{or_1026, or_1022, or_1018};
  logic parity_1032;
  assign parity_1032 = ^{or_1026, or_1022, or_1018, or_1011, or_1007, or_1003, or_995, or_991, or_987};
  // hls/stages/count_bits.hpp:25
  logic and_1033;
  assign and_1033 = parity_927 & parity_982;
  logic or_1037;
  assign or_1037 = (parity_921 & parity_924) | ((^select_915[11:9]) & (parity_921 | parity_924));
  logic and_1040;
  assign and_1040 = (^{select_938[11:6], select_915[2:0]}) & (parity_967 | parity_979);
  logic or_1041;
  assign or_1041 = (parity_967 & parity_979) | and_1040;
  // hls/stages/count_bits.hpp:23
  logic or_1048;
  assign or_1048 = (select_915[10:9] == 2'h3) | (select_915[11] & (select_915[9] | select_915[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1052;
  assign or_1052 = (select_915[4:3] == 2'h3) | (select_915[5] & (select_915[3] | select_915[4]));
  logic or_1056;
  assign or_1056 = (select_915[7:6] == 2'h3) | (select_915[8] & (select_915[6] | select_915[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1059;
  assign parity_1059 = ^{or_1056, or_1052, or_1048};
  // hls/stages/count_bits.hpp:25
  logic or_1063;
  assign or_1063 = (parity_941 & parity_944) | ((^select_915[2:0]) & (parity_941 | parity_944));
  logic or_1067;
  assign or_1067 = (parity_961 & parity_964) | ((^select_955[8:6]) & (parity_961 | parity_964));
  logic or_1071;
  assign or_1071 = (parity_973 & parity_976) | ((^select_938[5:3]) & (parity_973 | parity_976));
  // hls/stages/count_bits.hpp:24
  logic parity_1074;
  assign parity_1074 = ^{or_1071, or_1067, or_1063};
  logic parity_1077;
  assign parity_1077 = ^{or_1071, or_1067, or_1063, or_1056, or_1052, or_1048, or_1041, or_1037, and_1033};
  logic xor_1078;
  assign xor_1078 = parity_1032 ^ parity_1077;
  // hls/stages/count_bits.hpp:25
  logic and_1079;
  assign and_1079 = parity_1032 & parity_1077;
  logic or_1083;
  assign or_1083 = (parity_1014 & parity_1029) | ((^{or_995, or_991, or_987}) & (parity_1014 | parity_1029));
  logic or_1087;
  assign or_1087 = (parity_1059 & parity_1074) | ((^{or_1041, or_1037, and_1033}) & (parity_1059 | parity_1074));
  logic or_1094;
  assign or_1094 = (or_991 & or_995) | (or_987 & (or_991 | or_995));
  logic or_1098;
  assign or_1098 = (or_1007 & or_1011) | (or_1003 & (or_1007 | or_1011));
  logic or_1102;
  assign or_1102 = (or_1022 & or_1026) | (or_1018 & (or_1022 | or_1026));
  // hls/stages/count_bits.hpp:24
  logic parity_1105;
  assign parity_1105 = ^{or_1102, or_1098, or_1094};
  // hls/stages/count_bits.hpp:25
  logic or_1109;
  assign or_1109 = (or_1037 & or_1041) | (and_1033 & (or_1037 | or_1041));
  logic or_1113;
  assign or_1113 = (or_1052 & or_1056) | (or_1048 & (or_1052 | or_1056));
  logic or_1117;
  assign or_1117 = (or_1067 & or_1071) | (or_1063 & (or_1067 | or_1071));
  // hls/stages/count_bits.hpp:24
  logic parity_1120;
  assign parity_1120 = ^{or_1117, or_1113, or_1109};
  logic parity_1123;
  assign parity_1123 = ^{or_1117, or_1113, or_1109, or_1102, or_1098, or_1094, or_1087, or_1083, and_1079};
  // hls/stages/count_bits.hpp:25
  logic or_1127;
  assign or_1127 = (parity_1105 & parity_1120) | ((^{or_1087, or_1083, and_1079}) & (parity_1105 | parity_1120));
  logic or_1131;
  assign or_1131 = (or_1083 & or_1087) | (and_1079 & (or_1083 | or_1087));
  logic or_1135;
  assign or_1135 = (or_1098 & or_1102) | (or_1094 & (or_1098 | or_1102));
  logic or_1139;
  assign or_1139 = (or_1113 & or_1117) | (or_1109 & (or_1113 | or_1117));
  // hls/stages/count_bits.hpp:24
  logic parity_1144;
  assign parity_1144 = ^{or_1139, or_1135, or_1131, or_1127};
  // hls/stages/count_bits.hpp:25
  logic or_1148;
  assign or_1148 = (or_1135 & or_1139) | (or_1131 & (or_1135 | or_1139));
  logic and_1149;
  assign and_1149 = or_1127 & (^{or_1139, or_1135, or_1131});
  // hls/stages/count_bits.hpp:24
  logic xor_1150;
  assign xor_1150 = or_1148 ^ and_1149;
  // hls/stages/count_bits.hpp:27
  logic and_1151;
  assign and_1151 = or_1148 & and_1149;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1152;
  assign select_1152 = equal_534_s1_q ? {and_1151, xor_1150, parity_1144, parity_1123, xor_1078, xor_983} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_532_s1_q ? 6'h0 : select_1152;
  // hls/stages/agreement.hpp:212
  logic and_1160;
  assign and_1160 = right_codes_rdata_q[25] & not_540_s1_q;
  // hls/stages/agreement.hpp:719
  logic select_1161;
  assign select_1161 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_540_s1_q) : and_1160;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1163;
  assign select_1163 = less_539_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:719
  logic [11:0] select_1164;
  assign select_1164 = slot_s1_q[0] ? (less_539_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1163;
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1168;
  assign select_1168 = and_659 ? (select_1161 ? (~(select_662 ^ select_1164)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1174;
  assign parity_1174 = ^select_1168[5:3];
  logic parity_1177;
  assign parity_1177 = ^select_1168[8:6];
  logic parity_1180;
  assign parity_1180 = ^select_1168[11:3];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1188;
  assign select_1188 = (slot_s1_q[0] ? and_1160 : and_660) ? (~(select_685 ^ (slot_s1_q[0] ? select_1163 : select_661))) : 12'h0;
  logic [11:0] select_1189;
  assign select_1189 = and_682 ? select_1188 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1192;
  assign parity_1192 = ^select_1189[8:6];
  logic parity_1195;
  assign parity_1195 = ^select_1189[11:9];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1203;
  assign select_1203 = (slot_s1_q[0] ? and_660 : and_683) ? (~(select_702 ^ (slot_s1_q[0] ? select_661 : select_684))) : 12'h0;
  logic [11:0] select_1204;
  assign select_1204 = and_699 ? select_1203 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1210;
  assign parity_1210 = ^select_1204[2:0];
  logic parity_1213;
  assign parity_1213 = ^select_1204[5:3];
  logic parity_1216;
  assign parity_1216 = ^select_1204[8:0];
  logic parity_1222;
  assign parity_1222 = ^select_1204[11:9];
  logic parity_1225;
  assign parity_1225 = ^select_1189[2:0];
  logic parity_1228;
  assign parity_1228 = ^{select_1204[11:9], select_1189[5:0]};
  logic parity_1231;
  assign parity_1231 = ^{select_1204, select_1189, select_1168[2:0]};
  logic xor_1232;
  assign xor_1232 = parity_1180 ^ parity_1231;
  // hls/stages/count_bits.hpp:23
  logic or_1236;
  assign or_1236 = (select_1168[1:0] == 2'h3) | (select_1168[2] & (select_1168[0] | select_1168[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1240;
  assign or_1240 = (select_1189[7:6] == 2'h3) | (select_1189[8] & (select_1189[6] | select_1189[7]));
  logic or_1244;
  assign or_1244 = (select_1189[10:9] == 2'h3) | (select_1189[11] & (select_1189[9] | select_1189[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1252;
  assign or_1252 = (select_1204[7:6] == 2'h3) | (select_1204[8] & (~(select_1204[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1256;
  assign or_1256 = (select_1204[1:0] == 2'h3) | (select_1204[2] & (select_1204[0] | select_1204[1]));
  logic or_1260;
  assign or_1260 = (select_1204[4:3] == 2'h3) | (select_1204[5] & (select_1204[3] | select_1204[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1263;
  assign parity_1263 = ^{or_1260, or_1256, or_1252};
  // hls/stages/count_bits.hpp:23
  logic or_1267;
  assign or_1267 = (select_1189[4:3] == 2'h3) | (select_1189[5] & (select_1189[3] | select_1189[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1271;
  assign or_1271 = (select_1204[10:9] == 2'h3) | (select_1204[11] & (select_1204[9] | select_1204[10]));
  logic or_1275;
  assign or_1275 = (select_1189[1:0] == 2'h3) | (select_1189[2] & (select_1189[0] | select_1189[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1278;
  assign parity_1278 = ^{or_1275, or_1271, or_1267};
  logic parity_1281;
  assign parity_1281 = ^{or_1275, or_1271, or_1267, or_1260, or_1256, or_1252, or_1244, or_1240, or_1236};
  // hls/stages/count_bits.hpp:25
  logic and_1282;
  assign and_1282 = parity_1180 & parity_1231;
  logic or_1286;
  assign or_1286 = (parity_1174 & parity_1177) | ((^select_1168[11:9]) & (parity_1174 | parity_1177));
  logic and_1289;
  assign and_1289 = (^{select_1189[11:6], select_1168[2:0]}) & (parity_1216 | parity_1228);
  logic or_1290;
  assign or_1290 = (parity_1216 & parity_1228) | and_1289;
  // hls/stages/count_bits.hpp:23
  logic or_1297;
  assign or_1297 = (select_1168[10:9] == 2'h3) | (select_1168[11] & (select_1168[9] | select_1168[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1301;
  assign or_1301 = (select_1168[4:3] == 2'h3) | (select_1168[5] & (select_1168[3] | select_1168[4]));
  logic or_1305;
  assign or_1305 = (select_1168[7:6] == 2'h3) | (select_1168[8] & (select_1168[6] | select_1168[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1308;
  assign parity_1308 = ^{or_1305, or_1301, or_1297};
  // hls/stages/count_bits.hpp:25
  logic or_1312;
  assign or_1312 = (parity_1192 & parity_1195) | ((^select_1168[2:0]) & (parity_1192 | parity_1195));
  logic or_1316;
  assign or_1316 = (parity_1210 & parity_1213) | ((^select_1204[8:6]) & (parity_1210 | parity_1213));
  logic or_1320;
  assign or_1320 = (parity_1222 & parity_1225) | ((^select_1189[5:3]) & (parity_1222 | parity_1225));
  // hls/stages/count_bits.hpp:24
  logic parity_1323;
  assign parity_1323 = ^{or_1320, or_1316, or_1312};
  logic parity_1326;
  assign parity_1326 = ^{or_1320, or_1316, or_1312, or_1305, or_1301, or_1297, or_1290, or_1286, and_1282};
  logic xor_1327;
  assign xor_1327 = parity_1281 ^ parity_1326;
  // hls/stages/count_bits.hpp:25
  logic and_1328;
  assign and_1328 = parity_1281 & parity_1326;
  logic or_1332;
  assign or_1332 = (parity_1263 & parity_1278) | ((^{or_1244, or_1240, or_1236}) & (parity_1263 | parity_1278));
  logic or_1336;
  assign or_1336 = (parity_1308 & parity_1323) | ((^{or_1290, or_1286, and_1282}) & (parity_1308 | parity_1323));
  logic or_1343;
  assign or_1343 = (or_1240 & or_1244) | (or_1236 & (or_1240 | or_1244));
  logic or_1347;
  assign or_1347 = (or_1256 & or_1260) | (or_1252 & (or_1256 | or_1260));
  logic or_1351;
  assign or_1351 = (or_1271 & or_1275) | (or_1267 & (or_1271 | or_1275));
  // hls/stages/count_bits.hpp:24
  logic parity_1354;
  assign parity_1354 = ^{or_1351, or_1347, or_1343};
  // hls/stages/count_bits.hpp:25
  logic or_1358;
  assign or_1358 = (or_1286 & or_1290) | (and_1282 & (or_1286 | or_1290));
  logic or_1362;
  assign or_1362 = (or_1301 & or_1305) | (or_1297 & (or_1301 | or_1305));
  logic or_1366;
  assign or_1366 = (or_1316 & or_1320) | (or_1312 & (or_1316 | or_1320));
  // hls/stages/count_bits.hpp:24
  logic parity_1369;
  assign parity_1369 = ^{or_1366, or_1362, or_1358};
  logic parity_1372;
  assign parity_1372 = ^{or_1366, or_1362, or_1358, or_1351, or_1347, or_1343, or_1336, or_1332, and_1328};
  // hls/stages/count_bits.hpp:25
  logic or_1376;
  assign or_1376 = (parity_1354 & parity_1369) | ((^{or_1336, or_1332, and_1328}) & (parity_1354 | parity_1369));
  logic or_1380;
  assign or_1380 = (or_1332 & or_1336) | (and_1328 & (or_1332 | or_1336));
  logic or_1384;
  assign or_1384 = (or_1347 & or_1351) | (or_1343 & (or_1347 | or_1351));
  logic or_1388;
  assign or_1388 = (or_1362 & or_1366) | (or_1358 & (or_1362 | or_1366));
  // hls/stages/count_bits.hpp:24
  logic parity_1393;
  assign parity_1393 = ^{or_1388, or_1384, or_1380, or_1376};
  // hls/stages/count_bits.hpp:25
  logic or_1397;
  assign or_1397 = (or_1384 & or_1388) | (or_1380 & (or_1384 | or_1388));
  logic and_1398;
  assign and_1398 = or_1376 & (^{or_1388, or_1384, or_1380});
  // hls/stages/count_bits.hpp:24
  logic xor_1399;
  assign xor_1399 = or_1397 ^ and_1398;
  // hls/stages/count_bits.hpp:27
  logic and_1400;
  assign and_1400 = or_1397 & and_1398;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1401;
  assign select_1401 = equal_534_s1_q ? {and_1400, xor_1399, parity_1393, parity_1372, xor_1327, xor_1232} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_532_s1_q ? 6'h0 : select_1401;
  // hls/stages/agreement.hpp:937
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:938
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:939
  logic [5:0] select_1455;
  assign select_1455 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:942
  logic and_1475;
  assign and_1475 = (or_532_s1_q & (left_rdata_q[61] & not_540_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1497;
  assign or_1497 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:773
  logic [5:0] select_1508;
  assign select_1508 = so_s1_q ? x_s1_q[5:0] : (or_532_s1_q ? (less_539_s1_q ? 6'h0 : select_1455) : 6'h0);
  // hls/stages/patches.hpp:114
  logic and_1582;
  assign and_1582 = (select_475_s1_q == 3'h0) & (select_477_s1_q == 6'h0);
  // hls/stages/patches.hpp:382
  logic not_1583;
  assign not_1583 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_1586;
  assign not_1586 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:352
  logic and_1587;
  assign and_1587 = patches_capturing_q & not_1586;
  // hls/stages/patches.hpp:302
  logic equal_1590;
  assign equal_1590 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:117
  logic and_1595;
  assign and_1595 = (not_1583 & (patches_work_q == 3'h0)) & (~(and_1587 | ((~equal_1588_s1_q) | (~equal_1590))));
  // hls/stages/patches.hpp:520
  logic equal_1682;
  assign equal_1682 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:498
  logic not_1683;
  assign not_1683 = ~equal_1682;
  // hls/stages/patches.hpp:491
  logic equal_1684;
  assign equal_1684 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:444
  logic not_1685;
  assign not_1685 = ~equal_1684;
  // hls/stages/patches.hpp:485
  logic equal_1686;
  assign equal_1686 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:159
  logic equal_1687;
  assign equal_1687 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:520
  logic or_1688;
  assign or_1688 = equal_1686 | equal_1687;
  // hls/stages/patches.hpp:446
  logic not_1689;
  assign not_1689 = ~patches_second_q;
  // hls/stages/patches.hpp:363
  logic [4:0] select_1711;
  assign select_1711 = and_1595 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:118
  logic [4:0] select_1712;
  assign select_1712 = and_1582 ? select_1711 : patches_row_q;
  // hls/stages/patches.hpp:117
  logic and_1714;
  assign and_1714 = and_1587 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:118
  logic select_1718;
  assign select_1718 = and_1582 ? (and_1595 | (and_1587 & (~and_1714))) : patches_capturing_q;
  // hls/stages/patches.hpp:176
  logic and_1726;
  assign and_1726 = not_1683 & (not_1685 & (or_1688 & (patches_second_q & equal_1687)));
  // hls/stages/patches.hpp:159
  logic not_1743;
  assign not_1743 = ~equal_1687;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_1759;
  assign select_1759 = and_1582 ? {select_1711[4], select_1711[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:444
  logic and_1769;
  assign and_1769 = not_1683 & (or_1688 & not_1685);
  // hls/stages/agreement.hpp:448
  logic select_2384;
  assign select_2384 = equal_2287_s1_q ? (~({row_s1_q, 1'b0} < {sum_2381, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:508
  logic and_2598;
  assign and_2598 = and_511_s1_q & (equal_2287_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:308
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:118
  logic [3:0] select_2708;
  assign select_2708 = and_1582 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_2709;
  assign select_2709 = sample_pair_whole_s1_q ? select_2708 : patches_phase_q;
  // hls/stages/patches.hpp:363
  logic and_2710;
  assign and_2710 = not_1586 & equal_1588_s1_q;
  logic [8:0] select_2711;
  assign select_2711 = and_2710 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2712;
  assign select_2712 = and_2710 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2713;
  assign select_2713 = sample_pair_first_s1_q ? select_2711 : select_2712;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_2715;
  assign select_2715 = sample_pair_whole_s1_q ? (and_1582 ? select_2713[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2717;
  assign select_2717 = sample_pair_whole_s1_q ? (and_1582 ? select_2713[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2720;
  assign select_2720 = sample_pair_whole_s1_q ? (equal_1590 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2722;
  assign select_2722 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_1590}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:321
  logic equal_2723;
  assign equal_2723 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:322
  logic not_2724;
  assign not_2724 = ~equal_2723;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_2726;
  assign select_2726 = sample_pair_whole_s1_q ? (phase + {not_2724, 1'b1, not_2724, equal_2723}) : patches_first_band_rows_to_next_q;
  logic select_2727;
  assign select_2727 = sample_pair_whole_s1_q ? equal_2723 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:458
  logic equal_2728;
  assign equal_2728 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:79
  logic [3:0] select_2732;
  assign select_2732 = equal_2728 ? ((select_2709 == 4'h6) ? 4'h0 : (select_2709 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2733;
  assign equal_2733 = select_2732 == 4'h0;
  // hls/stages/agreement.hpp:448
  logic [3:0] select_2736;
  assign select_2736 = equal_2287_s1_q ? (equal_2733 ? 4'h6 : (select_2732 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:79
  logic [4:0] select_2738;
  assign select_2738 = equal_2728 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:448
  logic [4:0] select_2740;
  assign select_2740 = equal_2287_s1_q ? (select_2738 + {4'h0, equal_2733}) : patches_choosing_number_q;
  logic select_2744;
  assign select_2744 = equal_2287_s1_q ? ((6'h2 < row_s1_q) & equal_2733) : patches_chooses_q;
  // hls/stages/agreement.hpp:508
  logic [4:0] select_2747;
  assign select_2747 = and_511_s1_q ? (equal_2287_s1_q ? select_2738 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:118
  logic select_2775;
  assign select_2775 = and_1582 ? (and_1595 ? not_2773_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:383
  logic or_2814;
  assign or_2814 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:385
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:179
  logic and_2820;
  assign and_2820 = equal_1682 & not_1689;
  // hls/stages/patches.hpp:389
  logic and_2821;
  assign and_2821 = not_1743 & and_2820;
  logic [1:0] select_2823;
  assign select_2823 = equal_1684 ? 2'h0 : (equal_1686 ? 2'h3 : {equal_1687, and_2821});
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
  // hls/stages/patches.hpp:179
  logic [4:0] select_2845;
  assign select_2845 = or_2814 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1309; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_532_s1_q ? select_1455 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_653_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:757; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_1683 & (not_1685 & (or_1688 & (equal_1687 & not_1689))));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:757; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_1726;
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:758; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_1683 & (not_1685 & (not_1743 & or_1688)));
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:769; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_columns_above_re = s1_en & and_1769;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_543_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_635, left_rdata_q[59:45], and_634, left_rdata_q[43:29], and_633, left_rdata_q[27:13], and_632, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_543_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_644, right_codes_rdata_q[76:65], and_643, right_codes_rdata_q[63:52], and_642, right_codes_rdata_q[50:39], and_641, right_codes_rdata_q[37:26], and_640, right_codes_rdata_q[24:13], and_639, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_511_s1_q ? (equal_2287_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_511_s1_q ? select_2384 : lower_half_q;
      patches_phase_q <= select_2709;
      patches_band_rows_rows_to_next_q <= select_2715;
      patches_band_rows_number_q <= select_2717;
      patches_next_band_rows_to_next_q <= select_2720;
      patches_next_band_number_q <= select_2722;
      patches_first_band_rows_to_next_q <= select_2726;
      patches_first_band_number_q <= select_2727;
      patches_choosing_rows_to_next_q <= and_511_s1_q ? select_2736 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_511_s1_q ? select_2740 : patches_choosing_number_q;
      patches_chooses_q <= and_511_s1_q ? select_2744 : patches_chooses_q;
      patches_choosing_band_q <= select_2747;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_1718 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_2775 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_1712 : patches_row_q;
      patches_work_q <= or_2814 ? following : patches_work_q;
      patches_second_q <= not_1583 & (patches_second_q | (patches_ends_q & equal_1682));
      patches_following_q <= equal_1682 ? {2'h0, and_2820} : {equal_1684, select_2823};
      patches_following_beats_q <= {select_2835, not_2826};
      patches_begins_q <= sample_pair_whole_s1_q & (and_1582 & and_1714);
      patches_ends_q <= not_2838 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2843;
      patches_code_row_q <= select_2845;
      patches_column_q <= or_2814 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2838 & (patches_column_q == 5'h1e);
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
  logic shift_first_s2_q;
  logic [4:0] patches_band_rows_number_s2_q;
  logic patches_chooses_s2_q;
  logic [4:0] patches_choosing_band_s2_q;
  logic patches_lower_s2_q;
  logic patches_second_s2_q;
  logic [4:0] patches_code_row_s2_q;
  logic [4:0] patches_column_s2_q;
  logic [2:0] select_475_s2_q;
  logic [5:0] select_477_s2_q;
  logic [7:0] select_481_s2_q;
  logic and_485_s2_q;
  logic equal_491_s2_q;
  logic [5:0] column_s2_q;
  logic and_509_s2_q;
  logic and_511_s2_q;
  logic so_s2_q;
  logic equal_531_s2_q;
  logic or_532_s2_q;
  logic less_539_s2_q;
  logic not_540_s2_q;
  logic equal_572_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1154_s2_q;
  logic [5:0] select_1403_s2_q;
  logic and_1451_s2_q;
  logic [5:0] right_s2_q;
  logic equal_1459_s2_q;
  logic equal_1469_s2_q;
  logic and_1476_s2_q;
  logic and_1479_s2_q;
  logic and_1483_s2_q;
  logic or_1497_s2_q;
  logic [5:0] select_1508_s2_q;
  logic and_1582_s2_q;
  logic and_1595_s2_q;
  logic less_1609_s2_q;
  logic equal_1682_s2_q;
  logic not_1683_s2_q;
  logic equal_1684_s2_q;
  logic not_1685_s2_q;
  logic equal_1686_s2_q;
  logic equal_1687_s2_q;
  logic or_1688_s2_q;
  logic [4:0] select_1712_s2_q;
  logic select_1718_s2_q;
  logic [3:0] select_1759_s2_q;
  logic and_1769_s2_q;
  logic and_1863_s2_q;
  logic select_1865_s2_q;
  logic and_1868_s2_q;
  logic and_2017_s2_q;
  logic equal_2163_s2_q;
  logic equal_2287_s2_q;
  logic and_2599_s2_q;
  logic and_2601_s2_q;
  logic or_2814_s2_q;
  logic not_2838_s2_q;
  logic less_3620_s2_q;
  logic equal_3825_s2_q;
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
      shift_first_s2_q <= shift_first_s1_q;
      patches_band_rows_number_s2_q <= patches_band_rows_number_q;
      patches_chooses_s2_q <= patches_chooses_q;
      patches_choosing_band_s2_q <= patches_choosing_band_q;
      patches_lower_s2_q <= patches_lower_q;
      patches_second_s2_q <= patches_second_q;
      patches_code_row_s2_q <= patches_code_row_q;
      patches_column_s2_q <= patches_column_q;
      select_475_s2_q <= select_475_s1_q;
      select_477_s2_q <= select_477_s1_q;
      select_481_s2_q <= select_481_s1_q;
      and_485_s2_q <= and_485_s1_q;
      equal_491_s2_q <= equal_491_s1_q;
      column_s2_q <= column_s1_q;
      and_509_s2_q <= and_509_s1_q;
      and_511_s2_q <= and_511_s1_q;
      so_s2_q <= so_s1_q;
      equal_531_s2_q <= equal_531_s1_q;
      or_532_s2_q <= or_532_s1_q;
      less_539_s2_q <= less_539_s1_q;
      not_540_s2_q <= not_540_s1_q;
      equal_572_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      column_2_s2_q <= column_2;
      select_1154_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1403_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1451_s2_q <= and_1451_s1_q;
      right_s2_q <= right_s1_q;
      equal_1459_s2_q <= equal_1459_s1_q;
      equal_1469_s2_q <= equal_1469_s1_q;
      and_1476_s2_q <= not_540_s1_q & and_1475;
      and_1479_s2_q <= (or_532_s1_q & (left_rdata_q[62] & not_540_s1_q)) & and_1475;
      and_1483_s2_q <= not_540_s1_q & (or_532_s1_q & (left_rdata_q[63] & not_540_s1_q));
      or_1497_s2_q <= or_1497;
      select_1508_s2_q <= select_1508;
      and_1582_s2_q <= and_1582;
      and_1595_s2_q <= and_1595;
      less_1609_s2_q <= 5'h4 < row_q[5:1];
      equal_1682_s2_q <= equal_1682;
      not_1683_s2_q <= not_1683;
      equal_1684_s2_q <= equal_1684;
      not_1685_s2_q <= not_1685;
      equal_1686_s2_q <= equal_1686;
      equal_1687_s2_q <= equal_1687;
      or_1688_s2_q <= or_1688;
      select_1712_s2_q <= select_1712;
      select_1718_s2_q <= select_1718;
      select_1759_s2_q <= select_1759;
      and_1769_s2_q <= and_1769;
      and_1863_s2_q <= sample_pair_whole_q;
      select_1865_s2_q <= left_first_q;
      and_1868_s2_q <= right_q;
      and_2017_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2163_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2287_s2_q <= equal_2287_s1_q;
      and_2599_s2_q <= and_2288_s1_q & and_2598;
      and_2601_s2_q <= and_2288_s1_q & (~and_2598);
      or_2814_s2_q <= or_2814;
      not_2838_s2_q <= not_2838;
      less_3620_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3825_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic shift_allowed_q;
  logic shift_not_right_q;
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
  logic and_486;
  assign and_486 = sample_pair_whole_s2_q & and_485_s2_q;
  // hls/stages/agreement.hpp:792
  logic or_656;
  assign or_656 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:793
  logic select_658;
  assign select_658 = or_656 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:763
  logic [5:0] select_905;
  assign select_905 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_906;
  assign difference_906 = {1'b0, column_2_s2_q} - {1'b0, select_905};
  logic [7:0] sum_908;
  assign sum_908 = {difference_906[6], difference_906} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:740
  logic [7:0] select_909;
  assign select_909 = slot_s2_q[0] ? chosen_score_q : sum_908;
  // hls/stages/agreement.hpp:763
  logic [6:0] difference_1155;
  assign difference_1155 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1154_s2_q};
  // hls/stages/agreement.hpp:734
  logic equal_1156;
  assign equal_1156 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:763
  logic [7:0] sum_1158;
  assign sum_1158 = {difference_1155[6], difference_1155} + (equal_1156 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1404;
  assign difference_1404 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1403_s2_q};
  logic [7:0] sum_1406;
  assign sum_1406 = {difference_1404[6], difference_1404} + (equal_1156 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:736
  logic less_1407;
  assign less_1407 = sum_1158 < sum_1406;
  logic [7:0] select_1408;
  assign select_1408 = less_1407 ? sum_1406 : sum_1158;
  logic less_1409;
  assign less_1409 = select_909 < select_1408;
  // hls/stages/agreement.hpp:786
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1409 ? select_1408 : select_909) : 8'h0;
  // hls/stages/agreement.hpp:793
  logic or_1413;
  assign or_1413 = select_658 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1414;
  assign select_1414 = or_1413 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:705
  logic not_1415;
  assign not_1415 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:737
  logic [1:0] select_1416;
  assign select_1416 = less_1407 ? {slot_s2_q[0], not_1415} : 2'h0;
  logic [2:0] select_1418;
  assign select_1418 = less_1409 ? {select_1416, not_1415} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:798
  logic [2:0] select_1419;
  assign select_1419 = or_1413 ? select_1418 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1420;
  assign select_1420 = or_1413 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:795
  logic equal_1421;
  assign equal_1421 = select_1418 == 3'h1;
  logic or_1424;
  assign or_1424 = equal_1421 | (~(select_1418 == 3'h2));
  logic [7:0] select_1426;
  assign select_1426 = or_1424 ? before_0_q : before_1_q;
  logic [7:0] select_1427;
  assign select_1427 = equal_1421 ? (or_1424 ? sum_1158 : {7'h0, shift_not_right_q}) : select_1426;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1428;
  assign select_1428 = or_1413 ? select_1427 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1431;
  assign select_1431 = or_1413 ? (equal_1421 ? select_1426 : (or_1424 ? sum_1406 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1433;
  assign sum_1433 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1434;
  assign sum_1434 = {1'b0, before_v} + sum_1433;
  // hls/stages/agreement.hpp:740
  logic [6:0] select_1435;
  assign select_1435 = slot_s2_q[0] ? chosen_near_q : sum_1434;
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1437;
  assign sum_1437 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1438;
  assign sum_1438 = {1'b0, before_v_2} + sum_1437;
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1440;
  assign sum_1440 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1441;
  assign sum_1441 = {1'b0, before_v_3} + sum_1440;
  // hls/stages/agreement.hpp:736
  logic [6:0] select_1443;
  assign select_1443 = (sum_1438 < sum_1441) ? sum_1441 : sum_1438;
  // hls/stages/agreement.hpp:787
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1435 < select_1443) ? select_1443 : select_1435) : 7'h0;
  // hls/stages/agreement.hpp:798
  logic or_1448;
  assign or_1448 = select_658 | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:802
  logic [6:0] select_1449;
  assign select_1449 = or_1448 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1450;
  assign select_1450 = or_1448 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:806
  logic select_1460;
  assign select_1460 = or_656 ? shift_first_s2_q : equal_1459_s2_q;
  // hls/stages/agreement.hpp:807
  logic or_1462;
  assign or_1462 = select_1460 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:811
  logic [7:0] select_1463;
  assign select_1463 = or_1462 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1464;
  assign select_1464 = or_1462 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1466;
  assign or_1466 = select_1460 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:815
  logic [6:0] select_1467;
  assign select_1467 = or_1466 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1468;
  assign select_1468 = or_1466 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:965
  logic not_1470;
  assign not_1470 = ~equal_1469_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1480;
  assign and_1480 = not_540_s2_q & and_1479_s2_q;
  // hls/stages/agreement.hpp:945
  logic select_1486;
  assign select_1486 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:946
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:952
  logic [8:0] difference_1489;
  assign difference_1489 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:953
  logic [9:0] sum_1490;
  assign sum_1490 = {difference_1489[8], difference_1489} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1492;
  assign and_1492 = (and_1479_s2_q & select_1486) & ({{22{sum_1490[9]}}, sum_1490} < 32'h3);
  logic and_1493;
  assign and_1493 = not_540_s2_q & and_1492;
  logic and_1499;
  assign and_1499 = not_540_s2_q & (and_1492 & or_1497_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1500;
  assign select_1500 = less_539_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_532_s2_q ? {select_1500, and_1499, and_1493, and_1483_s2_q, and_1480, and_1476_s2_q, not_540_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:773
  logic and_1502;
  assign and_1502 = ends_cell_s2_q & shift_2[0];
  logic and_1504;
  assign and_1504 = not_1470 & (so_s2_q & and_1502);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1612;
  assign select_1612 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1612[16:7])) ? 8'h7f : select_1612[7:0];
  // hls/stages/patches.hpp:164
  logic [7:0] pixel;
  assign pixel = equal_1687_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1687_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:486
  logic less_1775;
  assign less_1775 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:487
  logic or_1776;
  assign or_1776 = equal_1686_s2_q | less_1775;
  // hls/stages/patches.hpp:490
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1781;
  assign select_1781 = equal_1686_s2_q ? patches_column_s2_q[0] : (or_1776 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1782;
  assign not_1782 = ~or_1776;
  // hls/stages/patches.hpp:487
  logic [4:0] sum_1783;
  assign sum_1783 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:489
  logic [4:0] select_1786;
  assign select_1786 = or_1776 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1783) + 5'h1) : sum_1783;
  // hls/stages/patches.hpp:491
  logic [4:0] select_1787;
  assign select_1787 = equal_1686_s2_q ? 5'h0 : select_1786;
  logic or_1788;
  assign or_1788 = equal_1686_s2_q | equal_1684_s2_q;
  // hls/stages/patches.hpp:467
  logic equal_1790;
  assign equal_1790 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_1792;
  assign equal_1792 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:469
  logic and_1794;
  assign and_1794 = of_row & (~equal_1792);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1790 ? 2'h3 : {equal_1792, and_1794};
  // hls/stages/patches.hpp:455
  logic [8:0] sum_1797;
  assign sum_1797 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1798;
  assign sum_1798 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1797, pixel_2[0]} - {1'b0, sum_1798, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:457
  logic [11:0] sum_1800;
  assign sum_1800 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1801;
  assign sum_1801 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1800[11], sum_1800};
  logic [13:0] sum_1802;
  assign sum_1802 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1801, down_2[1]};
  logic [12:0] sum_1803;
  assign sum_1803 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1802[13:1];
  logic [14:0] sum_1804;
  assign sum_1804 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1803, sum_1802[0], down_2[0]};
  // hls/stages/patches.hpp:453
  logic [8:0] sum_1807;
  assign sum_1807 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1808;
  assign sum_1808 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1807};
  logic [10:0] sum_1809;
  assign sum_1809 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1808, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1810;
  assign sum_1810 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1809[10:1];
  // hls/stages/patches.hpp:454
  logic [11:0] smooth;
  assign smooth = {sum_1810, sum_1809[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:456
  logic [12:0] sum_1812;
  assign sum_1812 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1813;
  assign sum_1813 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1814;
  assign difference_1814 = {1'b0, sum_1812, smooth[0]} - {1'b0, sum_1813, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:468
  logic or_1820;
  assign or_1820 = (((patches_column_s2_q == 5'ha) | of_row) | equal_1792) | equal_1790;
  // hls/stages/patches.hpp:463
  logic and_1825;
  assign and_1825 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:176
  logic and_1829;
  assign and_1829 = not_1685_s2_q & (or_1688_s2_q & (or_1820 & (equal_1687_s2_q & and_1825)));
  // hls/stages/patches.hpp:164
  logic and_1839;
  assign and_1839 = (~(equal_1687_s2_q | (~and_1825))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:176
  logic and_1843;
  assign and_1843 = not_1685_s2_q & (or_1688_s2_q & (and_1839 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:532
  logic less_1845;
  assign less_1845 = patches_step_q[4:0] < 5'h11;
  logic equal_1846;
  assign equal_1846 = patches_step_q[6:5] == 2'h0;
  logic not_1847;
  assign not_1847 = ~equal_1846;
  logic equal_1848;
  assign equal_1848 = patches_step_q[6:5] == 2'h3;
  logic not_1849;
  assign not_1849 = ~equal_1848;
  // hls/stages/patches.hpp:546
  logic select_1852;
  assign select_1852 = equal_1848 ? (less_1845 & (less_1845 & not_1849)) : less_1845;
  // hls/stages/patches.hpp:176
  logic and_1855;
  assign and_1855 = equal_1682_s2_q & (less_1845 ? (not_1847 & select_1852) : select_1852);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1884;
  assign sum_1884 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2387;
  assign select_2387 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2388;
  assign select_2388 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2389;
  assign select_2389 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2390;
  assign select_2390 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2391;
  assign select_2391 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2392;
  assign select_2392 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2396;
  assign select_2396 = slot_s2_q[0] ? 8'h0 : sum_908;
  // hls/stages/agreement.hpp:736
  logic less_2397;
  assign less_2397 = select_2396 < select_1408;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2399;
  assign select_2399 = slot_s2_q[0] ? 7'h0 : sum_1434;
  // hls/stages/agreement.hpp:773
  logic not_2404;
  assign not_2404 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2405;
  assign less_2405 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/registration.hpp:76
  logic less_2496;
  assign less_2496 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2498;
  assign select_2498 = or_532_s2_q ? (less_539_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2500;
  assign select_2500 = or_532_s2_q ? (less_539_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2502;
  assign select_2502 = or_532_s2_q ? (less_539_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2500} - {1'b0, select_2502};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2504;
  assign select_2504 = rise[8] ? select_2500 : select_2502;
  logic [8:0] difference_2505;
  assign difference_2505 = {1'b0, select_2498} - {1'b0, select_2504};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2505[8] ? 8'h0 : difference_2505[7:0];
  // hls/stages/registration.hpp:37
  logic not_2507;
  assign not_2507 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2496 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2507};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2509;
  assign xor_2509 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2509};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2515;
  assign select_2515 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2496 ? {taken, 1'b1} : {not_2507, select_2515, not_2507};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2517;
  assign sum_2517 = {left, 1'b1} + {taken_2, less_2496};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2519;
  assign select_2519 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2602;
  assign select_2602 = and_2601_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2604;
  assign select_2604 = and_2599_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2602[15]}}, select_2602});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2605;
  assign select_2605 = and_2601_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2605[15]}}, select_2605};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2607;
  assign select_2607 = and_2599_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_2608;
  assign and_2608 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2608 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:179
  logic select_2853;
  assign select_2853 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:176
  logic [11:0] select_2856;
  assign select_2856 = equal_1684_s2_q ? patches_smooth_values_0_q : (or_1688_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_2858;
  assign select_2858 = or_1688_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2860;
  assign select_2860 = equal_1682_s2_q ? patches_smooth_values_1_q : (equal_1684_s2_q ? patches_smooth_values_1_q : select_2858);
  logic [11:0] select_2861;
  assign select_2861 = or_1688_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2863;
  assign select_2863 = equal_1682_s2_q ? patches_smooth_values_2_q : (equal_1684_s2_q ? patches_smooth_values_2_q : select_2861);
  logic [11:0] select_2864;
  assign select_2864 = or_1688_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2866;
  assign select_2866 = equal_1682_s2_q ? patches_smooth_values_3_q : (equal_1684_s2_q ? patches_smooth_values_3_q : select_2864);
  logic [10:0] select_2868;
  assign select_2868 = equal_1684_s2_q ? patches_down_values_0_q : (or_1688_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_2871;
  assign select_2871 = equal_1684_s2_q ? patches_down_values_1_q : (or_1688_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_2874;
  assign select_2874 = equal_1684_s2_q ? patches_down_values_2_q : (or_1688_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_2877;
  assign select_2877 = equal_1684_s2_q ? patches_down_values_3_q : (or_1688_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:167
  logic and_2914;
  assign and_2914 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:403
  logic [4:0] select_2919;
  assign select_2919 = or_2814_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:405
  logic [3:0] select_2921;
  assign select_2921 = and_2914 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:176
  logic [4:0] select_3277;
  assign select_3277 = equal_1682_s2_q ? patches_summed_down_by_q : (equal_1684_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:542
  logic and_3310;
  assign and_3310 = less_1845 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:546
  logic select_3313;
  assign select_3313 = equal_1848 ? (less_1845 ? (not_1849 & and_3310) : and_3310) : and_3310;
  // hls/stages/patches.hpp:176
  logic select_3316;
  assign select_3316 = equal_1682_s2_q ? (less_1845 ? (not_1847 & select_3313) : select_3313) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3632;
  assign select_3632 = so_s2_q ? (and_2608 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3634;
  assign sum_3634 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3635;
  assign select_3635 = sum_1884[5] ? {1'b1, sum_1884[4:0], region_across_rest_q[2:0]} : sum_3634;
  // hls/stages/agreement.hpp:448
  logic [7:0] select_3637;
  assign select_3637 = equal_2287_s2_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3640;
  assign select_3640 = equal_2287_s2_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_481_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_486;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = column_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_511_s2_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1310; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1504;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1787, not_1782, select_1781};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & or_1788;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s2_en & (not_1683_s2_q & (new_row & equal_1684_s2_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s2_en & and_1855;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1337; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1504;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1451_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1450, select_1449, select_1431, select_1428, select_1420, select_1419, select_1414};
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
  assign best_right_we = s2_en & and_1451_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1468, select_1467, select_1464, select_1463};
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
  assign patches_columns_above_we = s2_en & and_1769_s2_q;
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
      shift_allowed_q <= 1'b0;
      shift_not_right_q <= 1'b0;
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
      chosen_score_q <= less_2397 ? select_1408 : select_2396;
      chosen_near_q <= (select_2399 < select_1443) ? select_1443 : select_2399;
      chosen_place_q <= less_2397 ? {select_1416, not_1415} : 3'h2;
      before_0_q <= select_2396;
      before_1_q <= sum_1158;
      before_2_q <= sum_1406;
      shift_allowed_q <= not_2404 & (~less_2405);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s2_q ? sum_2517[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2519;
      registration_slope_row_q <= select_2604;
      registration_slope_change_q <= select_2607;
      registration_slope_q <= so_s2_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_2838_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2838_s2_q & select_2853;
      patches_smooth_values_0_q <= equal_1682_s2_q ? patches_smooth_values_0_q : select_2856;
      patches_smooth_values_1_q <= select_2860;
      patches_smooth_values_2_q <= select_2863;
      patches_smooth_values_3_q <= select_2866;
      patches_down_values_0_q <= equal_1682_s2_q ? patches_down_values_0_q : select_2868;
      patches_down_values_1_q <= equal_1682_s2_q ? patches_down_values_1_q : select_2871;
      patches_down_values_2_q <= equal_1682_s2_q ? patches_down_values_2_q : select_2874;
      patches_down_values_3_q <= equal_1682_s2_q ? patches_down_values_3_q : select_2877;
      patches_down_by_q <= or_2814_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2914});
      patches_along_q <= select_2919;
      patches_match_row_q <= or_2814_s2_q ? 4'h0 : select_2921;
      patches_summed_last_q <= not_1683_s2_q & (equal_1684_s2_q & and_2914);
      patches_summed_down_by_q <= select_3277;
      patches_step_q <= or_2814_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3316;
      region_across_rest_q <= select_3632;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3635;
      columns_begin_rest_q <= and_511_s2_q ? select_3637 : columns_begin_rest_q;
      columns_begin_back_q <= and_511_s2_q ? select_3640 : columns_begin_back_q;
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
      middle_sum_columns_values_1_q <= select_2387;
      middle_sum_columns_values_2_q <= select_2388;
      middle_sum_columns_values_3_q <= select_2389;
      middle_sum_columns_values_4_q <= select_2390;
      middle_sum_columns_values_5_q <= select_2391;
      middle_sum_columns_values_6_q <= select_2392;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_908;
      sums_0_sum_sums_values_0_q <= sum_1158;
      sums_0_sum_sums_values_1_q <= equal_1156 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1406;
      sums_1_sum_sums_values_1_q <= equal_1156 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [4:0] patches_along_s3_q;
  logic patches_summed_last_s3_q;
  logic [4:0] patches_summed_down_by_s3_q;
  logic [4:0] patches_step_s3_q;
  logic patches_read_searches_s3_q;
  logic [2:0] select_475_s3_q;
  logic [5:0] select_477_s3_q;
  logic [7:0] select_481_s3_q;
  logic and_485_s3_q;
  logic and_486_s3_q;
  logic equal_491_s3_q;
  logic [5:0] column_s3_q;
  logic and_509_s3_q;
  logic and_511_s3_q;
  logic so_s3_q;
  logic equal_572_s3_q;
  logic equal_1469_s3_q;
  logic not_1470_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1504_s3_q;
  logic [5:0] select_1508_s3_q;
  logic and_1513_s3_q;
  logic and_1582_s3_q;
  logic and_1595_s3_q;
  logic less_1609_s3_q;
  logic [7:0] change_s3_q;
  logic equal_1682_s3_q;
  logic equal_1684_s3_q;
  logic equal_1687_s3_q;
  logic or_1688_s3_q;
  logic [4:0] select_1712_s3_q;
  logic select_1718_s3_q;
  logic [3:0] select_1759_s3_q;
  logic less_1775_s3_q;
  logic new_row_s3_q;
  logic or_1788_s3_q;
  logic [1:0] of_row_2_s3_q;
  logic less_1805_s3_q;
  logic less_1806_s3_q;
  logic less_1815_s3_q;
  logic less_1816_s3_q;
  logic and_1830_s3_q;
  logic and_1839_s3_q;
  logic and_1844_s3_q;
  logic less_1845_s3_q;
  logic equal_1846_s3_q;
  logic not_1847_s3_q;
  logic equal_1848_s3_q;
  logic not_1849_s3_q;
  logic and_1863_s3_q;
  logic select_1865_s3_q;
  logic and_1868_s3_q;
  logic sum_1884_s3_q;
  logic textured_s3_q;
  logic and_2017_s3_q;
  logic equal_2163_s3_q;
  logic equal_2287_s3_q;
  logic less_2533_s3_q;
  logic less_2890_s3_q;
  logic equal_3233_s3_q;
  logic equal_3317_s3_q;
  logic less_3620_s3_q;
  logic equal_3825_s3_q;
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
      patches_along_s3_q <= patches_along_q;
      patches_summed_last_s3_q <= patches_summed_last_q;
      patches_summed_down_by_s3_q <= patches_summed_down_by_q;
      patches_step_s3_q <= patches_step_q[4:0];
      patches_read_searches_s3_q <= patches_read_searches_q;
      select_475_s3_q <= select_475_s2_q;
      select_477_s3_q <= select_477_s2_q;
      select_481_s3_q <= select_481_s2_q;
      and_485_s3_q <= and_485_s2_q;
      and_486_s3_q <= and_486;
      equal_491_s3_q <= equal_491_s2_q;
      column_s3_q <= column_s2_q;
      and_509_s3_q <= and_509_s2_q;
      and_511_s3_q <= and_511_s2_q;
      so_s3_q <= so_s2_q;
      equal_572_s3_q <= equal_572_s2_q;
      equal_1469_s3_q <= equal_1469_s2_q;
      not_1470_s3_q <= not_1470;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1504_s3_q <= and_1504;
      select_1508_s3_q <= select_1508_s2_q;
      and_1513_s3_q <= not_1470 & (so_s2_q ? and_1502 : (equal_531_s2_q & shift_2[4]));
      and_1582_s3_q <= and_1582_s2_q;
      and_1595_s3_q <= and_1595_s2_q;
      less_1609_s3_q <= less_1609_s2_q;
      change_s3_q <= change;
      equal_1682_s3_q <= equal_1682_s2_q;
      equal_1684_s3_q <= equal_1684_s2_q;
      equal_1687_s3_q <= equal_1687_s2_q;
      or_1688_s3_q <= or_1688_s2_q;
      select_1712_s3_q <= select_1712_s2_q;
      select_1718_s3_q <= select_1718_s2_q;
      select_1759_s3_q <= select_1759_s2_q;
      less_1775_s3_q <= less_1775;
      new_row_s3_q <= new_row;
      or_1788_s3_q <= or_1788;
      of_row_2_s3_q <= of_row_2;
      less_1805_s3_q <= $signed(15'h100) < $signed(sum_1804);
      less_1806_s3_q <= $signed(sum_1804[14:8]) < $signed(7'h7f);
      less_1815_s3_q <= $signed(15'h100) < $signed(difference_1814);
      less_1816_s3_q <= $signed(difference_1814[14:8]) < $signed(7'h7f);
      and_1830_s3_q <= not_1683_s2_q & and_1829;
      and_1839_s3_q <= and_1839;
      and_1844_s3_q <= not_1683_s2_q & and_1843;
      less_1845_s3_q <= less_1845;
      equal_1846_s3_q <= equal_1846;
      not_1847_s3_q <= not_1847;
      equal_1848_s3_q <= equal_1848;
      not_1849_s3_q <= not_1849;
      and_1863_s3_q <= and_1863_s2_q;
      select_1865_s3_q <= select_1865_s2_q;
      and_1868_s3_q <= and_1868_s2_q;
      sum_1884_s3_q <= sum_1884[5];
      textured_s3_q <= textured;
      and_2017_s3_q <= and_2017_s2_q;
      equal_2163_s3_q <= equal_2163_s2_q;
      equal_2287_s3_q <= equal_2287_s2_q;
      less_2533_s3_q <= select_2500 < select_2502;
      less_2890_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3233_s3_q <= patches_match_row_q == 4'h0;
      equal_3317_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3620_s3_q <= less_3620_s2_q;
      equal_3825_s3_q <= equal_3825_s2_q;
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
  logic [10:0] registration_expected_q;
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
  logic [51:0] patches_codes_at_q;
  logic [27:0] patches_codes_further_q;
  logic [55:0] patches_next_codes_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
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
  logic [11:0] select_489;
  assign select_489 = select_475_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_493;
  assign sum_493 = select_489 + (equal_491_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_495;
  assign sum_495 = {4'h0, sample_pair_pixel_1_q} + (select_475_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_497;
  assign sum_497 = sum_495 + (equal_491_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:405
  logic whole;
  assign whole = select_475_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_501;
  assign and_501 = whole & (averager_memory_rdata_q[24] | equal_491_s3_q);
  // hls/stages/agreement.hpp:405
  logic all_of_skin;
  assign all_of_skin = select_475_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_505;
  assign and_505 = all_of_skin & (averager_memory_rdata_q[25] | equal_491_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_485_s3_q ? sum_493[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_514;
  assign equal_514 = select_475_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_514 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:264
  logic [8:0] select_517;
  assign select_517 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_485_s3_q ? sum_497[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_514 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:264
  logic [8:0] select_521;
  assign select_521 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_522;
  assign and_522 = and_485_s3_q & and_501;
  // hls/stages/census.hpp:126
  logic select_524;
  assign select_524 = equal_514 ? and_522 : (averager_mask_q & and_522);
  // hls/stages/agreement.hpp:264
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_524;
  // hls/stages/census.hpp:206
  logic and_526;
  assign and_526 = and_485_s3_q & and_505;
  // hls/stages/census.hpp:126
  logic select_528;
  assign select_528 = equal_514 ? and_526 : (averager_of_skin_q & and_526);
  // hls/stages/agreement.hpp:264
  logic and_529;
  assign and_529 = sample_pair_whole_s3_q & select_528;
  // hls/stages/census.hpp:294
  logic less_545;
  assign less_545 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_546;
  assign less_546 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_547;
  assign less_547 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_548;
  assign less_548 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_549;
  assign less_549 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_550;
  assign less_550 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_551;
  assign less_551 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_552;
  assign less_552 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_553;
  assign less_553 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_554;
  assign less_554 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_555;
  assign less_555 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_556;
  assign less_556 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_557;
  assign less_557 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_558;
  assign less_558 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_559;
  assign less_559 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_560;
  assign less_560 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_561;
  assign less_561 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_562;
  assign less_562 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_563;
  assign less_563 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_564;
  assign less_564 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_565;
  assign less_565 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_566;
  assign less_566 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_567;
  assign less_567 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_568;
  assign less_568 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:443
  logic equal_569;
  assign equal_569 = column_s3_q == 6'h0;
  logic [3:0] select_573;
  assign select_573 = equal_572_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:444
  logic [4:0] select_574;
  assign select_574 = equal_569 ? {select_573, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_575;
  assign select_575 = equal_569 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_576;
  assign and_576 = select_574[4] & select_575[3];
  // hls/stages/census.hpp:286
  logic and_578;
  assign and_578 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_580;
  assign and_580 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_578);
  // hls/stages/agreement.hpp:444
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_580;
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
  logic [9:0] difference_603;
  assign difference_603 = {1'b0, select_517} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_604;
  assign xor_604 = difference_603[8:0] ^ {9{difference_603[9]}};
  logic [9:0] sum_605;
  assign sum_605 = {9'h0, difference_603[9]} + {1'b0, xor_604};
  logic [9:0] difference_606;
  assign difference_606 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_607;
  assign xor_607 = difference_606[8:0] ^ {9{difference_606[9]}};
  logic [9:0] sum_608;
  assign sum_608 = {9'h0, difference_606[9]} + {1'b0, xor_607};
  logic [9:0] difference_610;
  assign difference_610 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_611;
  assign xor_611 = difference_610[8:0] ^ {9{difference_610[9]}};
  logic [9:0] sum_612;
  assign sum_612 = {9'h0, difference_610[9]} + {1'b0, xor_611};
  logic [10:0] sum_613;
  assign sum_613 = ({1'b0, sum_605} + {1'b0, sum_608}) + {1'b0, sum_612};
  logic [9:0] difference_614;
  assign difference_614 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_615;
  assign xor_615 = difference_614[8:0] ^ {9{difference_614[9]}};
  logic [9:0] sum_616;
  assign sum_616 = {9'h0, difference_614[9]} + {1'b0, xor_615};
  logic [9:0] difference_618;
  assign difference_618 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_619;
  assign xor_619 = difference_618[8:0] ^ {9{difference_618[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1509;
  assign not_1509 = ~so_s3_q;
  // hls/stages/agreement.hpp:773
  logic and_1510;
  assign and_1510 = not_1509 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1080
  logic equal_1514;
  assign equal_1514 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1126
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1081
  logic [1:0] select_1517;
  assign select_1517 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1094
  logic [3:0] select_1519;
  assign select_1519 = equal_1514 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1517});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1520;
  assign sum_1520 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:773
  logic [3:0] select_1521;
  assign select_1521 = equal_1469_s3_q ? select_1519 : {sum_1520, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:201
  logic equal_1522;
  assign equal_1522 = x_s3_q[5:0] == 6'h3f;
  logic equal_1524;
  assign equal_1524 = x_s3_q[5:0] == 6'h3e;
  logic equal_1526;
  assign equal_1526 = x_s3_q[5:0] == 6'h3d;
  logic equal_1528;
  assign equal_1528 = x_s3_q[5:0] == 6'h3c;
  logic equal_1530;
  assign equal_1530 = x_s3_q[5:0] == 6'h3b;
  logic equal_1532;
  assign equal_1532 = x_s3_q[5:0] == 6'h36;
  logic equal_1534;
  assign equal_1534 = x_s3_q[5:0] == 6'h35;
  logic equal_1536;
  assign equal_1536 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1126
  logic and_1540;
  assign and_1540 = (~equal_1530) & ((~equal_1532) & ((~equal_1534) & (~equal_1536)));
  logic and_1544;
  assign and_1544 = (~equal_1522) & ((~equal_1524) & ((~equal_1526) & ((~equal_1528) & and_1540)));
  // hls/stages/agreement.hpp:1081
  logic less_1545;
  assign less_1545 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1549;
  assign or_1549 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:965
  logic [4:0] sum_1554;
  assign sum_1554 = {1'b0, last_s3_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s3_q[0] & ({2'h0, sum_1554, last_s3_q[1]} < x_s3_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1560;
  assign sum_1560 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1562;
  assign and_1562 = half_ends & ({{3{sum_1560[4]}}, sum_1560} < 8'h3);
  // hls/stages/agreement.hpp:773
  logic and_1563;
  assign and_1563 = so_s3_q & and_1562;
  logic select_1564;
  assign select_1564 = equal_1469_s3_q ? (x_s3_q[6] & (equal_1514 ? and_1544 : (less_1545 & (~or_1549)))) : and_1563;
  // hls/stages/registration.hpp:258
  logic not_1566;
  assign not_1566 = ~lower_half_s3_q;
  logic [3:0] select_1567;
  assign select_1567 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1566, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1566};
  // hls/stages/patches.hpp:363
  logic [1:0] select_1596;
  assign select_1596 = and_1595_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1597;
  assign select_1597 = and_1595_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:264
  logic [5:0] select_1598;
  assign select_1598 = and_1582_s3_q ? {select_1597, select_1596[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:118
  logic [1:0] select_1599;
  assign select_1599 = and_1582_s3_q ? select_1596 : patches_fetch_q;
  logic equal_1600;
  assign equal_1600 = select_1599 == 2'h0;
  // hls/stages/patches.hpp:95
  logic right_3;
  assign right_3 = {3'h0, last_s3_q[5:1]} < x_s3_q;
  // hls/stages/agreement.hpp:773
  logic and_1608;
  assign and_1608 = not_1470_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1610;
  assign equal_1610 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1610 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1616;
  assign select_1616 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_1617;
  assign select_1617 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_1618;
  assign sum_1618 = {{2{select_1616[6]}}, select_1616} + {select_1617[7], select_1617};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1619;
  assign select_1619 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_1620;
  assign select_1620 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_1621;
  assign sum_1621 = {{2{select_1619[7]}}, select_1619[7:1]} + {select_1620[7], select_1620};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1622;
  assign sum_1622 = {{3{sum_1618[8]}}, sum_1618[8:1]} + {sum_1621[8], sum_1621, select_1619[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1623;
  assign select_1623 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_1624;
  assign select_1624 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_1625;
  assign difference_1625 = {{2{select_1623[7]}}, select_1623[7:1]} - {select_1624[7], select_1624};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1626;
  assign sum_1626 = {difference_1625, select_1623[0]} + {sum_1622[10], sum_1622[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1610 ? {sum_1626, sum_1622[1]} : registration_expected_q;
  // hls/stages/patches.hpp:90
  logic [9:0] sum_1628;
  assign sum_1628 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:974
  logic and_1630;
  assign and_1630 = shift_2_s3_q[3] & ({{4{sum_1628[9]}}, sum_1628, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:96
  logic and_1635;
  assign and_1635 = ({4'h0, last_s3_q[5:1]} < ({1'b0, x_s3_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:98
  logic equal_1636;
  assign equal_1636 = x_s3_q == 8'h0;
  // hls/stages/patches.hpp:94
  logic [9:0] sum_1642;
  assign sum_1642 = {2'h0, x_s3_q} + {{4{shift_2_s3_q[10]}}, shift_2_s3_q[10:5]};
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1644;
  assign sum_1644 = {sum_1642[9], sum_1642[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:974
  logic and_1647;
  assign and_1647 = ($signed(9'h0) < $signed(sum_1642[9:1])) & (~($signed({5'h0, last_s3_q}) < $signed({sum_1644, sum_1642[0]})));
  logic and_1648;
  assign and_1648 = (~(and_1635 | (equal_1636 | (~(x_s3_q < {2'h0, last_s3_q}))))) & and_1647;
  // hls/stages/agreement.hpp:773
  logic and_1651;
  assign and_1651 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_1609_s3_q & and_1630) & and_1648));
  logic and_1653;
  assign and_1653 = not_1470_s3_q & (so_s3_q & and_1651);
  // hls/stages/patches.hpp:148
  logic and_1655;
  assign and_1655 = and_1653 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:773
  logic [6:0] select_1658;
  assign select_1658 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  logic [6:0] select_1659;
  assign select_1659 = equal_1469_s3_q ? 7'h0 : select_1658;
  logic [5:0] select_1661;
  assign select_1661 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_1663;
  assign select_1663 = equal_1469_s3_q ? 6'h0 : (so_s3_q ? select_1661 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1664;
  assign sum_1664 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_1626[9]}}, sum_1626[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1667;
  assign select_1667 = ($signed(sum_1664[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1664[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1610 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1664[12:7])) ? 8'h7f : select_1667);
  // hls/stages/agreement.hpp:773
  logic [7:0] select_1672;
  assign select_1672 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1673;
  assign select_1673 = equal_1469_s3_q ? 8'h0 : select_1672;
  // hls/stages/patches.hpp:333
  logic [21:0] select_1674;
  assign select_1674 = and_1655 ? {select_1673, select_1663, select_1659, and_1653} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:105
  logic equal_1675;
  assign equal_1675 = x_s3_q == {2'h0, last_s3_q};
  // hls/stages/agreement.hpp:773
  logic and_1679;
  assign and_1679 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (and_1635 | equal_1675)));
  logic and_1680;
  assign and_1680 = not_1470_s3_q & and_1679;
  // hls/stages/patches.hpp:334
  logic and_1681;
  assign and_1681 = patches_chooses_s3_q & and_1680;
  // hls/stages/patches.hpp:118
  logic [4:0] select_1695;
  assign select_1695 = and_1582_s3_q ? select_1597 : patches_band_q;
  // hls/stages/patches.hpp:343
  logic equal_1696;
  assign equal_1696 = {patches_choosing_band_s3_q, and_1608} == {select_1695, select_1599[1]};
  // hls/stages/patches.hpp:472
  logic [2:0] sum_1796;
  assign sum_1796 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:476
  logic [1:0] sum_1834;
  assign sum_1834 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1871;
  assign select_1871 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1002
  logic or_1874;
  assign or_1874 = select_1871[7] | (~({select_1871[5], select_1871[3], select_1871[1]} == 3'h0));
  // hls/stages/agreement.hpp:1001
  logic or_1877;
  assign or_1877 = select_1871[7] | (~({select_1871[6], select_1871[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1000
  logic or_1880;
  assign or_1880 = select_1871[7] | (~(select_1871[6:4] == 3'h0));
  // hls/stages/agreement.hpp:773
  logic [5:0] select_1881;
  assign select_1881 = equal_1469_s3_q ? x_s3_q[5:0] : {region_row_q, or_1880, or_1877, or_1874};
  // hls/stages/agreement.hpp:1080
  logic not_1882;
  assign not_1882 = ~equal_1514;
  // hls/stages/agreement.hpp:1010
  logic or_1886;
  assign or_1886 = (~sum_1884_s3_q) | equal_1675;
  // hls/stages/agreement.hpp:773
  logic and_1889;
  assign and_1889 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_1886));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_1910;
  assign and_1910 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:970
  logic select_1911;
  assign select_1911 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_1911);
  // hls/stages/agreement.hpp:970
  logic select_1914;
  assign select_1914 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_1911 ? select_1914 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1208
  logic select_1917;
  assign select_1917 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1212
  logic select_1918;
  assign select_1918 = left_first_s3_q ? select_1917 : read_half_q;
  logic or_1919;
  assign or_1919 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1213
  logic [8:0] select_1920;
  assign select_1920 = or_1919 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1214
  logic [9:0] select_1922;
  assign select_1922 = left_first_s3_q ? 10'h1 : (or_1919 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1217
  logic and_1923;
  assign and_1923 = select_1920[8] & select_1922[9];
  // hls/stages/agreement.hpp:423
  logic next_row;
  assign next_row = and_1923 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1228
  logic [5:0] select_1926;
  assign select_1926 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1928;
  assign select_1928 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1926});
  // hls/stages/agreement.hpp:1238
  logic equal_1929;
  assign equal_1929 = seen_x_q == 3'h7;
  logic [7:0] select_1931;
  assign select_1931 = and_1923 ? 8'h0 : (seen_column_q + {7'h0, equal_1929});
  // hls/stages/agreement.hpp:1245
  logic [10:0] index;
  assign index = select_1928 + {3'h0, select_1931};
  // hls/stages/agreement.hpp:1198
  logic [11:0] sum_1933;
  assign sum_1933 = {1'b0, {2{select_1918}}, 2'h0, {2{select_1918}}, 1'b0, {2{select_1918}}, 1'b0, select_1918} + {1'b0, index};
  // hls/stages/agreement.hpp:1211
  logic not_1934;
  assign not_1934 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:423
  logic and_1936;
  assign and_1936 = not_1934 & (began_q | and_1923);
  // hls/stages/agreement.hpp:1239
  logic [2:0] select_1938;
  assign select_1938 = and_1923 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1244
  logic and_1940;
  assign and_1940 = and_1936 & (select_1938 == 3'h0);
  logic less_1941;
  assign less_1941 = select_1931 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:425
  logic and_1942;
  assign and_1942 = and_1940 & less_1941;
  logic and_1943;
  assign and_1943 = and_1863_s3_q & and_1942;
  // hls/stages/agreement.hpp:266
  logic select_1945;
  assign select_1945 = and_1863_s3_q ? (left_first_s3_q ? and_1942 : and_1943) : and_1943;
  // hls/stages/agreement.hpp:1063
  logic [7:0] sum_1947;
  assign sum_1947 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1947[7], sum_1947, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1198
  logic [11:0] sum_1949;
  assign sum_1949 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:986
  logic and_1950;
  assign and_1950 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_1951;
  assign and_1951 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_1952;
  assign and_1952 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_1953;
  assign and_1953 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1039
  logic [1:0] sum_1955;
  assign sum_1955 = {1'b0, and_1952} + ({1'b0, textured_s3_q} + {1'b0, and_1953});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1950} + ({2'h0, and_1951} + {1'b0, sum_1955});
  // hls/stages/agreement.hpp:1046
  logic [2:0] select_1958;
  assign select_1958 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1959;
  assign difference_1959 = {1'b0, textured_2} - {1'b0, select_1958};
  logic [4:0] t;
  assign t = {difference_1959[3], difference_1959} + (equal_1636 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:986
  logic [7:0] select_1964;
  assign select_1964 = shift_2_s3_q[0] ? (sum_1884_s3_q ? select_1871 : {select_1871[6:0], 1'b0}) : select_1871;
  // hls/stages/agreement.hpp:1002
  logic or_1967;
  assign or_1967 = select_1964[7] | (~({select_1964[5], select_1964[3], select_1964[1]} == 3'h0));
  // hls/stages/agreement.hpp:986
  logic and_1984;
  assign and_1984 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_1985;
  assign and_1985 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_1986;
  assign and_1986 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_1987;
  assign and_1987 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_1989;
  assign sum_1989 = {1'b0, and_1986} + ({1'b0, shown} + {1'b0, and_1987});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1984} + ({2'h0, and_1985} + {1'b0, sum_1989});
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_1992;
  assign select_1992 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_1993;
  assign difference_1993 = {1'b0, shown_2} - {1'b0, select_1992};
  logic [4:0] around;
  assign around = {difference_1993[3], difference_1993} + (equal_1636 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1055
  logic [5:0] sum_1996;
  assign sum_1996 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:986
  logic and_2000;
  assign and_2000 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2001;
  assign and_2001 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2002;
  assign and_2002 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2003;
  assign and_2003 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_2005;
  assign sum_2005 = {1'b0, and_2002} + ({1'b0, near} + {1'b0, and_2003});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2000} + ({2'h0, and_2001} + {1'b0, sum_2005});
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2008;
  assign select_2008 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2009;
  assign difference_2009 = {1'b0, near_2} - {1'b0, select_2008};
  logic [4:0] n;
  assign n = {difference_2009[3], difference_2009} + (equal_1636 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:773
  logic and_2021;
  assign and_2021 = ends_cell_s3_q & (and_2017_s3_q & (~({1'b0, sum_1554, last_s3_q[1:0]} < x_s3_q)));
  logic and_2023;
  assign and_2023 = not_1470_s3_q & (so_s3_q & and_2021);
  // hls/stages/agreement.hpp:264
  logic [10:0] select_2055;
  assign select_2055 = sample_pair_whole_s3_q ? (and_509_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2057;
  assign select_2057 = sample_pair_whole_s3_q ? (and_509_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2076;
  assign select_2076 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2078;
  assign select_2078 = sample_pair_whole_s3_q ? (and_509_s3_q ? select_524 : averager_mask_q) : averager_mask_q;
  logic select_2080;
  assign select_2080 = sample_pair_whole_s3_q ? (and_509_s3_q ? select_528 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:508
  logic [8:0] select_2081;
  assign select_2081 = and_511_s3_q ? select_517 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2082;
  assign select_2082 = and_511_s3_q ? select_521 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2084;
  assign select_2084 = and_511_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2085;
  assign select_2085 = and_511_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2086;
  assign select_2086 = and_511_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2087;
  assign select_2087 = and_511_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2088;
  assign select_2088 = and_511_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2089;
  assign select_2089 = and_511_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2090;
  assign select_2090 = and_511_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2091;
  assign select_2091 = and_511_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2092;
  assign select_2092 = and_511_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2093;
  assign select_2093 = and_511_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2094;
  assign select_2094 = and_511_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2095;
  assign select_2095 = and_511_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2096;
  assign select_2096 = and_511_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2097;
  assign select_2097 = and_511_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2098;
  assign select_2098 = and_511_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2099;
  assign select_2099 = and_511_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2100;
  assign select_2100 = and_511_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2101;
  assign select_2101 = and_511_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2102;
  assign select_2102 = and_511_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2103;
  assign select_2103 = and_511_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2104;
  assign select_2104 = and_511_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2105;
  assign select_2105 = and_511_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2106;
  assign select_2106 = and_511_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2107;
  assign select_2107 = and_511_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2108;
  assign select_2108 = and_511_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2109;
  assign select_2109 = and_511_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2110;
  assign select_2110 = and_511_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2111;
  assign select_2111 = and_511_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2112;
  assign select_2112 = and_511_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2113;
  assign select_2113 = and_511_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2114;
  assign select_2114 = and_511_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2115;
  assign select_2115 = and_511_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2116;
  assign select_2116 = and_511_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2117;
  assign select_2117 = and_511_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2118;
  assign select_2118 = and_511_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2119;
  assign select_2119 = and_511_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2120;
  assign select_2120 = and_511_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2121;
  assign select_2121 = and_511_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2122;
  assign select_2122 = and_511_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2123;
  assign select_2123 = and_511_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2124;
  assign select_2124 = and_511_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2125;
  assign select_2125 = and_511_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2126;
  assign select_2126 = and_511_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2127;
  assign select_2127 = and_511_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2128;
  assign select_2128 = and_511_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2129;
  assign select_2129 = and_511_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2130;
  assign select_2130 = and_511_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2131;
  assign select_2131 = and_511_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2132;
  assign select_2132 = and_511_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2133;
  assign select_2133 = and_511_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2134;
  assign select_2134 = and_511_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2135;
  assign select_2135 = and_511_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2136;
  assign select_2136 = and_511_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2138;
  assign difference_2138 = {1'b0, select_521} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2139;
  assign xor_2139 = difference_2138[8:0] ^ {9{difference_2138[9]}};
  logic [9:0] sum_2140;
  assign sum_2140 = {9'h0, difference_2138[9]} + {1'b0, xor_2139};
  logic [9:0] difference_2141;
  assign difference_2141 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2142;
  assign xor_2142 = difference_2141[8:0] ^ {9{difference_2141[9]}};
  logic [9:0] sum_2143;
  assign sum_2143 = {9'h0, difference_2141[9]} + {1'b0, xor_2142};
  logic [9:0] difference_2145;
  assign difference_2145 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2146;
  assign xor_2146 = difference_2145[8:0] ^ {9{difference_2145[9]}};
  logic [9:0] sum_2147;
  assign sum_2147 = {9'h0, difference_2145[9]} + {1'b0, xor_2146};
  logic [10:0] sum_2148;
  assign sum_2148 = ({1'b0, sum_2140} + {1'b0, sum_2143}) + {1'b0, sum_2147};
  logic [9:0] difference_2149;
  assign difference_2149 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2150;
  assign xor_2150 = difference_2149[8:0] ^ {9{difference_2149[9]}};
  logic [9:0] sum_2151;
  assign sum_2151 = {9'h0, difference_2149[9]} + {1'b0, xor_2150};
  logic [9:0] difference_2153;
  assign difference_2153 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2154;
  assign xor_2154 = difference_2153[8:0] ^ {9{difference_2153[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2184;
  assign difference_2184 = {1'b0, select_517} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2184[9]} + (difference_2184[8:0] ^ {9{difference_2184[9]}});
  logic [9:0] difference_2196;
  assign difference_2196 = {1'b0, select_521} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2196[9]} + (difference_2196[8:0] ^ {9{difference_2196[9]}});
  // hls/stages/agreement.hpp:508
  logic and_2412;
  assign and_2412 = and_511_s3_q & (equal_572_s3_q & equal_2287_s3_q);
  // hls/stages/agreement.hpp:773
  logic and_2416;
  assign and_2416 = not_1470_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:986
  logic and_2436;
  assign and_2436 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2437;
  assign and_2437 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2438;
  assign and_2438 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2439;
  assign and_2439 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1040
  logic [1:0] sum_2441;
  assign sum_2441 = {1'b0, and_2438} + ({1'b0, explained} + {1'b0, and_2439});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2436} + ({2'h0, and_2437} + {1'b0, sum_2441});
  // hls/stages/agreement.hpp:1047
  logic [2:0] select_2444;
  assign select_2444 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2445;
  assign difference_2445 = {1'b0, explained_2} - {1'b0, select_2444};
  logic [4:0] e;
  assign e = {difference_2445[3], difference_2445} + (equal_1636 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1054
  logic [5:0] sum_2448;
  assign sum_2448 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:773
  logic and_2477;
  assign and_2477 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2521;
  assign select_2521 = equal_1469_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2523;
  assign select_2523 = equal_1469_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2524;
  assign equal_2524 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2528;
  assign and_2528 = shift_2_s3_q[3] & less_1609_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2532;
  assign sum_2532 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2534;
  assign difference_2534 = {sum_2532, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2535;
  assign select_2535 = less_2533_s3_q ? difference_2534 : {sum_2532, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2536;
  assign select_2536 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2532, shift_2_s3_q[11], 5'h0} : select_2535;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2536[7]}}, select_2536} - {sum_1626[9], sum_1626, sum_1622[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2539;
  assign select_2539 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2539[11:7])) ? 12'h7f : select_2539;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2560;
  assign difference_2560 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2562;
  assign and_2562 = and_2528 & ($signed(difference_2560) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2575;
  assign less_2575 = $signed(difference_2560) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:773
  logic select_2583;
  assign select_2583 = so_s3_q ? (equal_2524 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2586;
  assign select_2586 = so_s3_q ? (equal_1610 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2591;
  assign select_2591 = (sum_1520 == 2'h2) ? (registration_fresh_q & (~select_1567)) : registration_fresh_q;
  // hls/stages/agreement.hpp:773
  logic [3:0] select_2593;
  assign select_2593 = so_s3_q ? (and_1562 ? select_2591 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2595;
  assign select_2595 = and_2412 ? 4'hf : (equal_1469_s3_q ? registration_fresh_q : select_2593);
  // hls/stages/agreement.hpp:1081
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1517;
  // hls/stages/registration.hpp:258
  logic not_2616;
  assign not_2616 = ~quarter_2[1];
  logic [3:0] select_2617;
  assign select_2617 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2616, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2616};
  // hls/stages/patches.hpp:83
  logic parity_2751;
  assign parity_2751 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:448
  logic [15:0] select_2752;
  assign select_2752 = equal_2287_s3_q ? {patches_chance_q[14:0], parity_2751} : patches_chance_q;
  // hls/stages/patches.hpp:335
  logic not_2754;
  assign not_2754 = ~and_1680;
  // hls/stages/patches.hpp:100
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:102
  logic [4:0] select_2756;
  assign select_2756 = right_3 ? last_s3_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2756};
  // hls/stages/agreement.hpp:773
  logic and_2762;
  assign and_2762 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (~(x_s3_q < {2'h0, from}))));
  // hls/stages/patches.hpp:148
  logic and_2766;
  assign and_2766 = not_2754 & (patches_fixed_q | ((not_1470_s3_q & and_2762) & and_1655));
  // hls/stages/patches.hpp:344
  logic not_2779;
  assign not_2779 = ~select_1599[1];
  // hls/stages/agreement.hpp:264
  logic [1:0] select_2781;
  assign select_2781 = sample_pair_whole_s3_q ? (equal_1600 ? select_1599 : {not_2779, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:508
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:176
  logic [51:0] select_2880;
  assign select_2880 = or_1688_s3_q ? {less_1816_s3_q, less_1815_s3_q, less_1806_s3_q, less_1805_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2882;
  assign select_2882 = equal_1682_s3_q ? patches_codes_at_q : (equal_1684_s3_q ? other[55:4] : select_2880);
  // hls/stages/patches.hpp:491
  logic [27:0] word;
  assign word = or_1788_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:507
  logic [27:0] select_2885;
  assign select_2885 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:176
  logic [27:0] select_2887;
  assign select_2887 = equal_1684_s3_q ? (new_row_s3_q ? word : select_2885) : patches_codes_further_q;
  // hls/stages/patches.hpp:509
  logic [55:0] select_2889;
  assign select_2889 = less_1775_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:479
  logic [55:0] select_2891;
  assign select_2891 = less_2890_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:176
  logic [55:0] select_2893;
  assign select_2893 = or_1688_s3_q ? (equal_1687_s3_q ? patches_next_codes_q : select_2891) : patches_next_codes_q;
  logic [55:0] select_2895;
  assign select_2895 = equal_1682_s3_q ? patches_next_codes_q : (equal_1684_s3_q ? select_2889 : select_2893);
  // hls/stages/count_bits.hpp:24
  logic parity_2900;
  assign parity_2900 = ^{less_1816_s3_q, less_1815_s3_q, less_1806_s3_q, less_1805_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_2904;
  assign or_2904 = ({less_1806_s3_q, less_1805_s3_q} == 2'h3) | (less_1815_s3_q & (less_1806_s3_q | less_1805_s3_q));
  logic and_2905;
  assign and_2905 = less_1816_s3_q & (^{less_1815_s3_q, less_1806_s3_q, less_1805_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2906;
  assign xor_2906 = or_2904 ^ and_2905;
  // hls/stages/count_bits.hpp:27
  logic and_2907;
  assign and_2907 = or_2904 & and_2905;
  // hls/stages/patches.hpp:176
  logic [2:0] select_2909;
  assign select_2909 = or_1688_s3_q ? (and_1839_s3_q ? {and_2907, xor_2906, parity_2900} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:159
  logic [9:0] sum_2913;
  assign sum_2913 = {7'h0, patches_set_q} + (equal_1687_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:508
  logic [47:0] select_2923;
  assign select_2923 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:176
  logic [47:0] select_2925;
  assign select_2925 = equal_1682_s3_q ? patches_left_row_q : (equal_1684_s3_q ? select_2923 : patches_left_row_q);
  // hls/stages/patches.hpp:510
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2923;
  // hls/stages/count_bits.hpp:24
  logic xor_2929;
  assign xor_2929 = bits[17] ^ (^{select_2923[16:15], other[16:15]});
  logic xor_2932;
  assign xor_2932 = bits[11] ^ (^{select_2923[10:9], other[10:9]});
  logic xor_2935;
  assign xor_2935 = bits[14] ^ (^{select_2923[13:12], other[13:12]});
  logic xor_2938;
  assign xor_2938 = xor_2929 ^ (^{select_2923[14:9], other[14:9]});
  logic xor_2941;
  assign xor_2941 = bits[47] ^ (^{select_2923[46:45], other[46:45]});
  logic xor_2944;
  assign xor_2944 = bits[8] ^ (^{select_2923[7:6], other[7:6]});
  logic xor_2947;
  assign xor_2947 = bits[2] ^ (^{select_2923[1:0], other[1:0]});
  logic xor_2950;
  assign xor_2950 = bits[5] ^ (^{select_2923[4:3], other[4:3]});
  logic xor_2953;
  assign xor_2953 = xor_2944 ^ (^{select_2923[5:0], other[5:0]});
  logic parity_2955;
  assign parity_2955 = ^{select_2923[47:45], select_2923[8:0], other[47:45], other[8:0]};
  logic xor_2956;
  assign xor_2956 = xor_2938 ^ parity_2955;
  logic xor_2959;
  assign xor_2959 = bits[44] ^ (^{select_2923[43:42], other[43:42]});
  logic xor_2962;
  assign xor_2962 = bits[38] ^ (^{select_2923[37:36], other[37:36]});
  logic xor_2965;
  assign xor_2965 = bits[41] ^ (^{select_2923[40:39], other[40:39]});
  logic xor_2971;
  assign xor_2971 = bits[26] ^ (^{select_2923[25:24], other[25:24]});
  logic xor_2974;
  assign xor_2974 = bits[20] ^ (^{select_2923[19:18], other[19:18]});
  logic xor_2977;
  assign xor_2977 = bits[23] ^ (^{select_2923[22:21], other[22:21]});
  logic xor_2980;
  assign xor_2980 = xor_2971 ^ (^{select_2923[23:18], other[23:18]});
  logic xor_2983;
  assign xor_2983 = bits[35] ^ (^{select_2923[34:33], other[34:33]});
  logic xor_2986;
  assign xor_2986 = bits[29] ^ (^{select_2923[28:27], other[28:27]});
  logic xor_2989;
  assign xor_2989 = bits[32] ^ (^{select_2923[31:30], other[31:30]});
  logic xor_2992;
  assign xor_2992 = xor_2983 ^ (^{select_2923[32:27], other[32:27]});
  logic xor_2993;
  assign xor_2993 = xor_2980 ^ xor_2992;
  // hls/stages/count_bits.hpp:25
  logic or_3001;
  assign or_3001 = (xor_2932 & xor_2935) | (xor_2929 & (xor_2932 | xor_2935));
  logic or_3005;
  assign or_3005 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3009;
  assign or_3009 = (xor_2947 & xor_2950) | (xor_2944 & (xor_2947 | xor_2950));
  // hls/stages/count_bits.hpp:23
  logic or_3016;
  assign or_3016 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3020;
  assign or_3020 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3024;
  assign or_3024 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3027;
  assign parity_3027 = ^{or_3024, or_3020, or_3016};
  // hls/stages/count_bits.hpp:23
  logic or_3031;
  assign or_3031 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3035;
  assign or_3035 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3039;
  assign or_3039 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3042;
  assign parity_3042 = ^{or_3039, or_3035, or_3031};
  logic parity_3045;
  assign parity_3045 = ^{or_3039, or_3035, or_3031, or_3024, or_3020, or_3016, or_3009, or_3005, or_3001};
  // hls/stages/count_bits.hpp:23
  logic or_3049;
  assign or_3049 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3053;
  assign or_3053 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3057;
  assign or_3057 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3065;
  assign or_3065 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3069;
  assign or_3069 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3073;
  assign or_3073 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3076;
  assign parity_3076 = ^{or_3073, or_3069, or_3065};
  // hls/stages/count_bits.hpp:23
  logic or_3080;
  assign or_3080 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3084;
  assign or_3084 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3088;
  assign or_3088 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3091;
  assign parity_3091 = ^{or_3088, or_3084, or_3080};
  logic parity_3094;
  assign parity_3094 = ^{or_3088, or_3084, or_3080, or_3073, or_3069, or_3065, or_3057, or_3053, or_3049};
  // hls/stages/count_bits.hpp:25
  logic or_3098;
  assign or_3098 = (xor_2962 & xor_2965) | (xor_2959 & (xor_2962 | xor_2965));
  logic or_3102;
  assign or_3102 = (xor_2974 & xor_2977) | (xor_2971 & (xor_2974 | xor_2977));
  logic or_3106;
  assign or_3106 = (xor_2986 & xor_2989) | (xor_2983 & (xor_2986 | xor_2989));
  // hls/stages/count_bits.hpp:24
  logic parity_3109;
  assign parity_3109 = ^{or_3106, or_3102, or_3098};
  // hls/stages/count_bits.hpp:25
  logic and_3110;
  assign and_3110 = xor_2956 & (^{xor_2993, select_2923[44:36], other[44:36]});
  logic or_3114;
  assign or_3114 = (xor_2941 & xor_2953) | (xor_2938 & (xor_2941 | xor_2953));
  logic and_3117;
  assign and_3117 = (xor_2959 ^ (^{select_2923[41:36], other[41:36]})) & (xor_2980 | xor_2992);
  logic or_3118;
  assign or_3118 = (xor_2980 & xor_2992) | and_3117;
  // hls/stages/count_bits.hpp:24
  logic parity_3121;
  assign parity_3121 = ^{or_3118, or_3114, and_3110};
  logic parity_3124;
  assign parity_3124 = ^{or_3118, or_3114, and_3110, or_3106, or_3102, or_3098, or_3088, or_3084, or_3080, or_3073, or_3069, or_3065, or_3057, or_3053, or_3049};
  logic parity_3126;
  assign parity_3126 = ^{or_3118, or_3114, and_3110, or_3106, or_3102, or_3098, or_3088, or_3084, or_3080, or_3073, or_3069, or_3065, or_3057, or_3053, or_3049, or_3039, or_3035, or_3031, or_3024, or_3020, or_3016, or_3009, or_3005, or_3001};
  // hls/stages/count_bits.hpp:25
  logic and_3127;
  assign and_3127 = parity_3045 & parity_3124;
  logic or_3131;
  assign or_3131 = (parity_3027 & parity_3042) | ((^{or_3009, or_3005, or_3001}) & (parity_3027 | parity_3042));
  logic or_3135;
  assign or_3135 = (parity_3109 & parity_3121) | (parity_3094 & (parity_3109 | parity_3121));
  logic or_3142;
  assign or_3142 = (parity_3076 & parity_3091) | ((^{or_3057, or_3053, or_3049}) & (parity_3076 | parity_3091));
  logic or_3146;
  assign or_3146 = (or_3102 & or_3106) | (or_3098 & (or_3102 | or_3106));
  logic or_3150;
  assign or_3150 = (or_3114 & or_3118) | (and_3110 & (or_3114 | or_3118));
  // hls/stages/count_bits.hpp:23
  logic or_3157;
  assign or_3157 = (or_3053 & or_3057) | (or_3049 & (or_3053 | or_3057));
  // hls/stages/count_bits.hpp:25
  logic or_3161;
  assign or_3161 = (or_3069 & or_3073) | (or_3065 & (or_3069 | or_3073));
  logic or_3165;
  assign or_3165 = (or_3084 & or_3088) | (or_3080 & (or_3084 | or_3088));
  // hls/stages/count_bits.hpp:24
  logic parity_3168;
  assign parity_3168 = ^{or_3165, or_3161, or_3157};
  // hls/stages/count_bits.hpp:23
  logic or_3172;
  assign or_3172 = (or_3005 & or_3009) | (or_3001 & (or_3005 | or_3009));
  // hls/stages/count_bits.hpp:25
  logic or_3176;
  assign or_3176 = (or_3020 & or_3024) | (or_3016 & (or_3020 | or_3024));
  logic or_3180;
  assign or_3180 = (or_3035 & or_3039) | (or_3031 & (or_3035 | or_3039));
  // hls/stages/count_bits.hpp:24
  logic parity_3183;
  assign parity_3183 = ^{or_3180, or_3176, or_3172};
  logic parity_3186;
  assign parity_3186 = ^{or_3180, or_3176, or_3172, or_3165, or_3161, or_3157, or_3150, or_3146, or_3142};
  logic parity_3188;
  assign parity_3188 = ^{or_3180, or_3176, or_3172, or_3165, or_3161, or_3157, or_3150, or_3146, or_3142, or_3135, or_3131, and_3127};
  // hls/stages/count_bits.hpp:25
  logic or_3192;
  assign or_3192 = (or_3146 & or_3150) | (or_3142 & (or_3146 | or_3150));
  logic or_3196;
  assign or_3196 = (or_3161 & or_3165) | (or_3157 & (or_3161 | or_3165));
  logic or_3200;
  assign or_3200 = (or_3176 & or_3180) | (or_3172 & (or_3176 | or_3180));
  // hls/stages/count_bits.hpp:24
  logic parity_3203;
  assign parity_3203 = ^{or_3200, or_3196, or_3192};
  // hls/stages/count_bits.hpp:25
  logic and_3204;
  assign and_3204 = (^{or_3135, or_3131, and_3127}) & parity_3186;
  logic or_3208;
  assign or_3208 = (or_3131 & or_3135) | (and_3127 & (or_3131 | or_3135));
  logic or_3212;
  assign or_3212 = (parity_3168 & parity_3183) | ((^{or_3150, or_3146, or_3142}) & (parity_3168 | parity_3183));
  // hls/stages/count_bits.hpp:24
  logic parity_3215;
  assign parity_3215 = ^{or_3212, or_3208, and_3204};
  // hls/stages/count_bits.hpp:25
  logic and_3217;
  assign and_3217 = parity_3203 & parity_3215;
  logic or_3221;
  assign or_3221 = (or_3196 & or_3200) | (or_3192 & (or_3196 | or_3200));
  logic or_3225;
  assign or_3225 = (or_3208 & or_3212) | (and_3204 & (or_3208 | or_3212));
  // hls/stages/patches.hpp:176
  logic [4:0] select_3270;
  assign select_3270 = equal_1684_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3273;
  assign select_3273 = equal_1682_s3_q ? patches_summed_first_q : (equal_1684_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:542
  logic [9:0] select_3280;
  assign select_3280 = less_1845_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3283;
  assign select_3283 = equal_1848_s3_q ? (less_1845_s3_q ? (equal_1848_s3_q ? 10'h0 : select_3280) : 10'h0) : select_3280;
  logic [9:0] select_3285;
  assign select_3285 = less_1845_s3_q ? (equal_1846_s3_q ? 10'h0 : select_3283) : select_3283;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3287;
  assign select_3287 = less_1845_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3290;
  assign select_3290 = equal_1848_s3_q ? (less_1845_s3_q ? (equal_1848_s3_q ? 5'h0 : select_3287) : 5'h0) : select_3287;
  logic [4:0] select_3292;
  assign select_3292 = less_1845_s3_q ? (equal_1846_s3_q ? 5'h0 : select_3290) : select_3290;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3294;
  assign select_3294 = less_1845_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3297;
  assign select_3297 = equal_1848_s3_q ? (less_1845_s3_q ? (equal_1848_s3_q ? 5'h0 : select_3294) : 5'h0) : select_3294;
  logic [4:0] select_3299;
  assign select_3299 = less_1845_s3_q ? (equal_1846_s3_q ? 5'h0 : select_3297) : select_3297;
  // hls/stages/patches.hpp:542
  logic and_3302;
  assign and_3302 = less_1845_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:546
  logic select_3305;
  assign select_3305 = equal_1848_s3_q ? (less_1845_s3_q ? (not_1849_s3_q & and_3302) : and_3302) : and_3302;
  // hls/stages/patches.hpp:176
  logic select_3308;
  assign select_3308 = equal_1682_s3_q ? (less_1845_s3_q ? (not_1847_s3_q & select_3305) : select_3305) : patches_read_first_q;
  // hls/stages/patches.hpp:170
  logic or_3319;
  assign or_3319 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3320;
  assign and_3320 = patches_read_searches_s3_q & or_3319;
  // hls/stages/patches.hpp:526
  logic [4:0] select_3321;
  assign select_3321 = and_3320 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:533
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3321};
  // hls/stages/patches.hpp:542
  logic and_3325;
  assign and_3325 = less_1845_s3_q & (equal_3317_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:546
  logic select_3328;
  assign select_3328 = equal_1848_s3_q ? (less_1845_s3_q ? (not_1849_s3_q & and_3325) : and_3325) : and_3325;
  // hls/stages/patches.hpp:176
  logic select_3331;
  assign select_3331 = equal_1682_s3_q ? (less_1845_s3_q ? (not_1847_s3_q & select_3328) : select_3328) : patches_read_above_q;
  // hls/stages/patches.hpp:542
  logic and_3334;
  assign and_3334 = less_1845_s3_q & (equal_3317_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:546
  logic select_3337;
  assign select_3337 = equal_1848_s3_q ? (less_1845_s3_q ? (not_1849_s3_q & and_3334) : and_3334) : and_3334;
  // hls/stages/patches.hpp:176
  logic select_3340;
  assign select_3340 = equal_1682_s3_q ? (less_1845_s3_q ? (not_1847_s3_q & select_3337) : select_3337) : patches_read_below_q;
  // hls/stages/patches.hpp:539
  logic [6:0] sum_3341;
  assign sum_3341 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:540
  logic [9:0] select_3344;
  assign select_3344 = (equal_3317_s3_q & ({sum_3341[6], sum_3341} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3345;
  assign select_3345 = less_1845_s3_q ? select_3344 : 10'h3ff;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3347;
  assign select_3347 = less_1845_s3_q ? (equal_1848_s3_q ? 10'h3ff : select_3345) : 10'h3ff;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3348;
  assign select_3348 = equal_1848_s3_q ? select_3347 : select_3345;
  logic [9:0] select_3350;
  assign select_3350 = less_1845_s3_q ? (equal_1846_s3_q ? 10'h3ff : select_3348) : select_3348;
  // hls/stages/patches.hpp:525
  logic [14:0] select_3352;
  assign select_3352 = and_3320 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:176
  logic [9:0] select_3353;
  assign select_3353 = equal_1682_s3_q ? select_3352[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3354;
  assign select_3354 = equal_1682_s3_q ? select_3352[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:527
  logic [9:0] select_3356;
  assign select_3356 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:528
  logic [9:0] select_3358;
  assign select_3358 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:529
  logic [9:0] select_3361;
  assign select_3361 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3362;
  assign select_3362 = patches_read_first_q ? patches_read_far_q : select_3361;
  // hls/stages/patches.hpp:580
  logic [9:0] difference_3365;
  assign difference_3365 = select_3362 - select_3352[9:0];
  // hls/stages/patches.hpp:565
  logic less_3395;
  assign less_3395 = select_3356 < select_3358;
  // hls/stages/patches.hpp:571
  logic [1:0] sum_3396;
  assign sum_3396 = select_3321[4:3] + 2'h3;
  // hls/stages/patches.hpp:566
  logic [9:0] high;
  assign high = less_3395 ? select_3358 : select_3356;
  logic [9:0] low;
  assign low = (select_3358 < select_3356) ? select_3358 : select_3356;
  // hls/stages/patches.hpp:567
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3352[9:0];
  // hls/stages/patches.hpp:569
  logic not_3403;
  assign not_3403 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3404;
  assign sum_3404 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3406;
  assign not_3406 = ~({eight, 3'h0} < {1'b0, sum_3404, fall[0]});
  logic [1:0] sum_3407;
  assign sum_3407 = {1'b0, not_3403} + {1'b0, not_3406};
  // hls/stages/patches.hpp:570
  logic [10:0] sum_3408;
  assign sum_3408 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3410;
  assign not_3410 = ~({eight, 3'h0} < {sum_3408, fall[1:0]});
  logic not_3413;
  assign not_3413 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3414;
  assign sum_3414 = {1'b0, not_3410} + {1'b0, not_3413};
  // hls/stages/patches.hpp:569
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3407} + {1'b0, sum_3414};
  // hls/stages/patches.hpp:572
  logic [7:0] select_3417;
  assign select_3417 = less_3395 ? ({sum_3396, select_3321[2:0], 3'h0} - {5'h0, fraction}) : {sum_3396, select_3321[2:0], fraction};
  // hls/stages/agreement.hpp:1096
  logic equal_3580;
  assign equal_3580 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:773
  logic select_3617;
  assign select_3617 = equal_1469_s3_q ? shown_shown_q : (so_s3_q ? select_1911 : shown_shown_q);
  logic select_3619;
  assign select_3619 = equal_1469_s3_q ? shown_nearer_q : (so_s3_q ? select_1914 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3621;
  assign sum_3621 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:448
  logic [2:0] select_3623;
  assign select_3623 = less_3620_s3_q ? (sum_3621[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3625;
  assign select_3625 = equal_2287_s3_q ? (equal_572_s3_q ? 3'h0 : select_3623) : region_row_q;
  // hls/stages/agreement.hpp:773
  logic [7:0] select_3630;
  assign select_3630 = equal_1469_s3_q ? select_1871 : (so_s3_q ? (ends_cell_s3_q ? select_1964 : select_1871) : 8'h1);
  // hls/stages/agreement.hpp:448
  logic [8:0] select_3644;
  assign select_3644 = equal_572_s3_q ? {{2{difference_3642[6]}}, difference_3642} : (less_3620_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:508
  logic [8:0] select_3646;
  assign select_3646 = and_511_s3_q ? (equal_2287_s3_q ? select_3644 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:448
  logic [6:0] select_3648;
  assign select_3648 = equal_572_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:508
  logic [6:0] select_3650;
  assign select_3650 = and_511_s3_q ? (equal_2287_s3_q ? select_3648 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3651;
  assign sum_3651 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3652;
  assign select_3652 = sum_3621[7] ? {1'b1, sum_3621[6:0], region_down_rest_q[0]} : sum_3651;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3621[7];
  // hls/stages/agreement.hpp:448
  logic select_3656;
  assign select_3656 = equal_2287_s3_q ? (equal_572_s3_q | (less_3620_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_3661;
  assign or_3661 = segment_starts_q | not_1509;
  // hls/stages/agreement.hpp:986
  logic select_3664;
  assign select_3664 = shift_2_s3_q[0] ? (sum_1884_s3_q ? (equal_1675 & or_1886) : or_1886) : or_3661;
  // hls/stages/agreement.hpp:773
  logic select_3667;
  assign select_3667 = equal_1469_s3_q ? or_3661 : (so_s3_q ? (ends_cell_s3_q ? select_3664 : or_3661) : or_3661);
  logic [2:0] select_3741;
  assign select_3741 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_3743;
  assign select_3743 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3745;
  assign select_3745 = equal_1469_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3743 : box_textured_columns_values_1_q);
  logic [2:0] select_3746;
  assign select_3746 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3748;
  assign select_3748 = equal_1469_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3746 : box_textured_columns_values_2_q);
  logic [2:0] select_3749;
  assign select_3749 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3751;
  assign select_3751 = equal_1469_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3749 : box_textured_columns_values_3_q);
  logic [2:0] select_3752;
  assign select_3752 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3754;
  assign select_3754 = equal_1469_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3752 : box_textured_columns_values_4_q);
  logic [4:0] select_3756;
  assign select_3756 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3759;
  assign select_3759 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3761;
  assign select_3761 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3763;
  assign select_3763 = equal_1469_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3761 : box_explained_columns_values_1_q);
  logic [2:0] select_3764;
  assign select_3764 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3766;
  assign select_3766 = equal_1469_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3764 : box_explained_columns_values_2_q);
  logic [2:0] select_3767;
  assign select_3767 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3769;
  assign select_3769 = equal_1469_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3767 : box_explained_columns_values_3_q);
  logic [2:0] select_3770;
  assign select_3770 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3772;
  assign select_3772 = equal_1469_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3770 : box_explained_columns_values_4_q);
  logic [4:0] select_3774;
  assign select_3774 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3775;
  assign select_3775 = equal_1469_s3_q ? box_explained_sum_sums_values_0_q : select_3774;
  logic [2:0] select_3777;
  assign select_3777 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3779;
  assign select_3779 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3781;
  assign select_3781 = equal_1469_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3779 : box_shown_columns_values_1_q);
  logic [2:0] select_3782;
  assign select_3782 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3784;
  assign select_3784 = equal_1469_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3782 : box_shown_columns_values_2_q);
  logic [2:0] select_3785;
  assign select_3785 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3787;
  assign select_3787 = equal_1469_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3785 : box_shown_columns_values_3_q);
  logic [2:0] select_3788;
  assign select_3788 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3790;
  assign select_3790 = equal_1469_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3788 : box_shown_columns_values_4_q);
  logic [4:0] select_3792;
  assign select_3792 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3795;
  assign select_3795 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3797;
  assign select_3797 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3799;
  assign select_3799 = equal_1469_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3797 : box_nearer_columns_values_1_q);
  logic [2:0] select_3800;
  assign select_3800 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3802;
  assign select_3802 = equal_1469_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3800 : box_nearer_columns_values_2_q);
  logic [2:0] select_3803;
  assign select_3803 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3805;
  assign select_3805 = equal_1469_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3803 : box_nearer_columns_values_3_q);
  logic [2:0] select_3806;
  assign select_3806 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3808;
  assign select_3808 = equal_1469_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3806 : box_nearer_columns_values_4_q);
  logic [4:0] select_3810;
  assign select_3810 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3813;
  assign select_3813 = so_s3_q ? (ends_cell_s3_q ? and_1952 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3816;
  assign select_3816 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3818;
  assign select_3818 = equal_1469_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3816 : centres_values_0_of_skin_q);
  logic select_3819;
  assign select_3819 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3821;
  assign select_3821 = equal_1469_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3819 : centres_values_1_textured_q);
  logic select_3822;
  assign select_3822 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3824;
  assign select_3824 = equal_1469_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3822 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:448
  logic [10:0] select_3828;
  assign select_3828 = equal_2287_s3_q ? (equal_3825_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:508
  logic [5:0] select_3831;
  assign select_3831 = and_511_s3_q ? (equal_2287_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1208
  logic xor_3832;
  assign xor_3832 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:425
  logic select_3834;
  assign select_3834 = and_1863_s3_q ? (left_first_s3_q ? xor_3832 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:266
  logic select_3836;
  assign select_3836 = and_1863_s3_q ? (left_first_s3_q ? xor_3832 : select_3834) : write_half_q;
  logic select_3838;
  assign select_3838 = left_first_s3_q ? select_1917 : (and_1863_s3_q ? select_1918 : read_half_q);
  logic and_3842;
  assign and_3842 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3851;
  assign select_3851 = left_first_s3_q ? 10'h1 : (and_1863_s3_q ? select_1922 : rows_passed_q);
  logic [8:0] select_3854;
  assign select_3854 = left_first_s3_q ? {select_1920[7:0], or_1919} : (and_1863_s3_q ? {select_1920[7:0], or_1919} : columns_passed_q);
  logic select_3857;
  assign select_3857 = left_first_s3_q ? marks_last_s3_q : (and_1863_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_3860;
  assign select_3860 = left_first_s3_q ? and_1936 : (and_1863_s3_q ? and_1936 : began_q);
  logic [2:0] select_3863;
  assign select_3863 = left_first_s3_q ? select_1938 : (and_1863_s3_q ? select_1938 : seen_x_q);
  // hls/stages/agreement.hpp:1237
  logic [2:0] select_3868;
  assign select_3868 = left_first_s3_q ? 3'h0 : (and_1923 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:266
  logic [2:0] select_3870;
  assign select_3870 = left_first_s3_q ? 3'h0 : (and_1863_s3_q ? select_3868 : seen_y_q);
  logic [7:0] select_3873;
  assign select_3873 = left_first_s3_q ? select_1931 : (and_1863_s3_q ? select_1931 : seen_column_q);
  // hls/stages/agreement.hpp:423
  logic [7:0] select_3879;
  assign select_3879 = left_first_s3_q ? select_3877 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:266
  logic [7:0] select_3881;
  assign select_3881 = left_first_s3_q ? select_3877 : (and_1863_s3_q ? select_3879 : seen_rows_left_q);
  // hls/stages/agreement.hpp:423
  logic and_3886;
  assign and_3886 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:266
  logic select_3888;
  assign select_3888 = left_first_s3_q ? and_3886 : (and_1863_s3_q ? and_3886 : at_cell_end_q);
  logic select_3891;
  assign select_3891 = left_first_s3_q ? next_row : (and_1863_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_3894;
  assign select_3894 = left_first_s3_q ? 11'h0 : (and_1863_s3_q ? select_1928 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_3960;
  assign not_3960 = ~quarter[1];
  logic [3:0] select_3961;
  assign select_3961 = quarter[0] ? {quarter[1], 1'b0, not_3960, 1'b0} : {1'b0, quarter[1], 1'b0, not_3960};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1521;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_1564;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:745; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1598;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_1600));
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1330; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
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
  assign regions_re = s3_en & (equal_1469_s3_q ? (x_s3_q[6] & not_1882) : and_1889);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1341; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1933;
  logic map_re;
  assign map_re = s3_en & select_1945;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_481_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_486_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_505, and_501, sum_497, sum_493};
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
  assign census_memory_we = s3_en & and_511_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_529, whole_2, select_521, select_517};
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
  assign shown_right_waddr = select_1508_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1513_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1510, not_1509};
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
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1796, patches_code_row_s3_q[1:0], of_row_2_s3_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_1830_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1816_s3_q, less_1815_s3_q, less_1806_s3_q, less_1805_s3_q, patches_codes_at_q[51:28]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 7'd112) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 7'd112) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1834, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_1844_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1816_s3_q, less_1815_s3_q, less_1806_s3_q, less_1805_s3_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s3_en & and_1504_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1910, textured_s3_q};
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
      registration_expected_q <= 11'h0;
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
      patches_codes_at_q <= 52'h0;
      patches_codes_further_q <= 28'h0;
      patches_next_codes_q <= 56'h0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
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
      averager_running_of_skin_q <= select_2076;
      averager_mask_q <= select_2078;
      averager_of_skin_q <= select_2080;
      census_filled_q <= and_511_s3_q ? {select_575[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_511_s3_q ? select_574 : rows_passed_above_q;
      registration_slope_here_q <= select_2521;
      registration_expected_q <= select_2523;
      registration_of_right_q <= equal_1469_s3_q ? registration_of_right_q : select_2583;
      registration_was_inside_q <= equal_1469_s3_q ? registration_was_inside_q : select_2586;
      registration_fresh_q <= select_2595;
      patches_chance_q <= and_511_s3_q ? select_2752 : patches_chance_q;
      patches_fixed_q <= and_2766;
      patches_choice_valid_q <= and_1680 ? (select_1674[0] & not_2754) : select_1674[0];
      patches_choice_column_q <= select_1674[7:1];
      patches_choice_shift_q <= select_1674[13:8];
      patches_choice_slope_q <= select_1674[21:14];
      patches_band_q <= sample_pair_whole_s3_q ? select_1695 : patches_band_q;
      patches_fetch_q <= select_2781;
      patches_codes_at_q <= select_2882;
      patches_codes_further_q <= equal_1682_s3_q ? patches_codes_further_q : select_2887;
      patches_next_codes_q <= select_2895;
      patches_set_q <= equal_1682_s3_q ? 3'h0 : (equal_1684_s3_q ? 3'h0 : select_2909);
      patches_size_q <= sum_2913;
      patches_left_row_q <= select_2925;
      patches_summed_row_column_q <= equal_1682_s3_q ? patches_summed_row_column_q : select_3270;
      patches_summed_first_q <= select_3273;
      patches_read_row_differing_q <= equal_1682_s3_q ? select_3285 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1682_s3_q ? select_3292 : patches_read_row_column_q;
      patches_read_at_q <= equal_1682_s3_q ? select_3299 : patches_read_at_q;
      patches_read_first_q <= select_3308;
      patches_read_above_q <= select_3331;
      patches_read_below_q <= select_3340;
      patches_read_far_q <= equal_1682_s3_q ? select_3350 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3353;
      patches_peak_best_column_q <= select_3354;
      patches_peak_row_q <= equal_1682_s3_q ? select_3321 : patches_peak_row_q;
      patches_peak_above_q <= equal_1682_s3_q ? select_3356 : patches_peak_above_q;
      patches_peak_below_q <= equal_1682_s3_q ? select_3358 : patches_peak_below_q;
      patches_peak_far_q <= equal_1682_s3_q ? select_3362 : patches_peak_far_q;
      shown_shown_q <= select_3617;
      shown_nearer_q <= select_3619;
      region_row_q <= and_511_s3_q ? select_3625 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3630;
      region_down_rest_q <= select_3646;
      region_down_back_q <= select_3650;
      region_down_next_q <= select_3652;
      region_fresh_q <= and_511_s3_q ? select_3656 : region_fresh_q;
      segment_starts_q <= select_3667;
      centres_values_0_textured_q <= equal_1469_s3_q ? centres_values_0_textured_q : select_3813;
      centres_values_0_of_skin_q <= select_3818;
      centres_values_1_textured_q <= select_3821;
      centres_values_1_of_skin_q <= select_3824;
      map_row_q <= and_511_s3_q ? select_3828 : map_row_q;
      map_width_q <= select_3831;
      write_half_q <= select_3836;
      read_half_q <= and_1863_s3_q ? select_3838 : read_half_q;
      done_q <= and_1863_s3_q ? (not_1934 & and_3842) : and_3842;
      drew_q <= so_s3_q;
      said_q <= equal_1469_s3_q & equal_3580;
      rows_passed_q <= and_1863_s3_q ? select_3851 : rows_passed_q;
      columns_passed_q <= and_1863_s3_q ? select_3854 : columns_passed_q;
      line_ended_q <= and_1863_s3_q ? select_3857 : line_ended_q;
      began_q <= and_1863_s3_q ? select_3860 : began_q;
      seen_x_q <= and_1863_s3_q ? select_3863 : seen_x_q;
      seen_y_q <= and_1863_s3_q ? select_3870 : seen_y_q;
      seen_column_q <= and_1863_s3_q ? select_3873 : seen_column_q;
      seen_rows_left_q <= and_1863_s3_q ? select_3881 : seen_rows_left_q;
      at_cell_end_q <= and_1863_s3_q ? select_3888 : at_cell_end_q;
      was_next_row_q <= and_1863_s3_q ? select_3891 : was_next_row_q;
      seen_base_q <= and_1863_s3_q ? select_3894 : seen_base_q;
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
      left_pixel_q <= and_1863_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= sample_pair_whole_s3_q ? select_489 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_495 : averager_running_1_q;
      averager_total_0_q <= select_2055;
      averager_total_1_q <= select_2057;
      census_columns_values_0_cell_0_left_q <= select_2081;
      census_columns_values_0_cell_0_right_q <= select_2082;
      census_columns_values_0_cell_0_mask_q <= and_511_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2084;
      census_columns_values_0_cell_1_right_q <= select_2085;
      census_columns_values_0_cell_1_mask_q <= select_2086;
      census_columns_values_0_cell_2_left_q <= select_2087;
      census_columns_values_0_cell_2_right_q <= select_2088;
      census_columns_values_0_cell_2_mask_q <= select_2089;
      census_columns_values_0_cell_2_of_skin_q <= select_2090;
      census_columns_values_0_cell_3_left_q <= select_2091;
      census_columns_values_0_cell_3_right_q <= select_2092;
      census_columns_values_0_cell_3_mask_q <= select_2093;
      census_columns_values_0_cell_4_left_q <= select_2094;
      census_columns_values_0_cell_4_right_q <= select_2095;
      census_columns_values_0_cell_4_mask_q <= select_2096;
      census_columns_values_1_cell_0_left_q <= select_2097;
      census_columns_values_1_cell_0_right_q <= select_2098;
      census_columns_values_1_cell_0_mask_q <= select_2099;
      census_columns_values_1_cell_1_left_q <= select_2100;
      census_columns_values_1_cell_1_right_q <= select_2101;
      census_columns_values_1_cell_1_mask_q <= select_2102;
      census_columns_values_1_cell_2_left_q <= select_2103;
      census_columns_values_1_cell_2_right_q <= select_2104;
      census_columns_values_1_cell_2_mask_q <= select_2105;
      census_columns_values_1_cell_2_of_skin_q <= select_2106;
      census_columns_values_1_cell_3_left_q <= select_2107;
      census_columns_values_1_cell_3_right_q <= select_2108;
      census_columns_values_1_cell_3_mask_q <= select_2109;
      census_columns_values_1_cell_4_left_q <= select_2110;
      census_columns_values_1_cell_4_right_q <= select_2111;
      census_columns_values_1_cell_4_mask_q <= select_2112;
      census_columns_values_2_cell_0_left_q <= select_2113;
      census_columns_values_2_cell_0_right_q <= select_2114;
      census_columns_values_2_cell_0_mask_q <= select_2115;
      census_columns_values_2_cell_1_left_q <= select_2116;
      census_columns_values_2_cell_1_right_q <= select_2117;
      census_columns_values_2_cell_1_mask_q <= select_2118;
      census_columns_values_2_cell_2_left_q <= select_2119;
      census_columns_values_2_cell_2_right_q <= select_2120;
      census_columns_values_2_cell_2_mask_q <= select_2121;
      census_columns_values_2_cell_3_left_q <= select_2122;
      census_columns_values_2_cell_3_right_q <= select_2123;
      census_columns_values_2_cell_3_mask_q <= select_2124;
      census_columns_values_2_cell_4_left_q <= select_2125;
      census_columns_values_2_cell_4_right_q <= select_2126;
      census_columns_values_2_cell_4_mask_q <= select_2127;
      census_columns_values_3_cell_0_mask_q <= select_2128;
      census_columns_values_3_cell_1_left_q <= select_2129;
      census_columns_values_3_cell_1_right_q <= select_2130;
      census_columns_values_3_cell_1_mask_q <= select_2131;
      census_columns_values_3_cell_2_mask_q <= select_2132;
      census_columns_values_3_cell_3_left_q <= select_2133;
      census_columns_values_3_cell_3_right_q <= select_2134;
      census_columns_values_3_cell_3_mask_q <= select_2135;
      census_columns_values_3_cell_4_mask_q <= select_2136;
      sharpness_last_mean_0_q <= and_511_s3_q ? select_517 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_511_s3_q ? select_521 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1469_s3_q ? box_textured_columns_values_0_q : select_3741;
      box_textured_columns_values_1_q <= select_3745;
      box_textured_columns_values_2_q <= select_3748;
      box_textured_columns_values_3_q <= select_3751;
      box_textured_columns_values_4_q <= select_3754;
      box_textured_sum_sums_values_0_q <= equal_1469_s3_q ? box_textured_sum_sums_values_0_q : select_3756;
      box_explained_columns_values_0_q <= equal_1469_s3_q ? box_explained_columns_values_0_q : select_3759;
      box_explained_columns_values_1_q <= select_3763;
      box_explained_columns_values_2_q <= select_3766;
      box_explained_columns_values_3_q <= select_3769;
      box_explained_columns_values_4_q <= select_3772;
      box_explained_sum_sums_values_0_q <= select_3775;
      box_shown_columns_values_0_q <= equal_1469_s3_q ? box_shown_columns_values_0_q : select_3777;
      box_shown_columns_values_1_q <= select_3781;
      box_shown_columns_values_2_q <= select_3784;
      box_shown_columns_values_3_q <= select_3787;
      box_shown_columns_values_4_q <= select_3790;
      box_shown_sum_sums_values_0_q <= equal_1469_s3_q ? box_shown_sum_sums_values_0_q : select_3792;
      box_nearer_columns_values_0_q <= equal_1469_s3_q ? box_nearer_columns_values_0_q : select_3795;
      box_nearer_columns_values_1_q <= select_3799;
      box_nearer_columns_values_2_q <= select_3802;
      box_nearer_columns_values_3_q <= select_3805;
      box_nearer_columns_values_4_q <= select_3808;
      box_nearer_sum_sums_values_0_q <= equal_1469_s3_q ? box_nearer_sum_sums_values_0_q : select_3810;
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
  logic [2:0] select_475_s4_q;
  logic [5:0] select_477_s4_q;
  logic [5:0] column_s4_q;
  logic and_509_s4_q;
  logic and_511_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_514_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic less_545_s4_q;
  logic less_546_s4_q;
  logic less_547_s4_q;
  logic less_548_s4_q;
  logic less_549_s4_q;
  logic less_550_s4_q;
  logic less_551_s4_q;
  logic less_552_s4_q;
  logic less_553_s4_q;
  logic less_554_s4_q;
  logic less_555_s4_q;
  logic less_556_s4_q;
  logic less_557_s4_q;
  logic less_558_s4_q;
  logic less_559_s4_q;
  logic less_560_s4_q;
  logic less_561_s4_q;
  logic less_562_s4_q;
  logic less_563_s4_q;
  logic less_564_s4_q;
  logic less_565_s4_q;
  logic less_566_s4_q;
  logic less_567_s4_q;
  logic less_568_s4_q;
  logic and_576_s4_q;
  logic and_601_s4_q;
  logic and_602_s4_q;
  logic [11:0] sum_617_s4_q;
  logic [9:0] sum_620_s4_q;
  logic equal_1469_s4_q;
  logic not_1470_s4_q;
  logic equal_1514_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1520_s4_q;
  logic equal_1522_s4_q;
  logic equal_1524_s4_q;
  logic equal_1526_s4_q;
  logic equal_1528_s4_q;
  logic equal_1530_s4_q;
  logic equal_1532_s4_q;
  logic equal_1534_s4_q;
  logic equal_1536_s4_q;
  logic less_1545_s4_q;
  logic or_1549_s4_q;
  logic equal_1569_s4_q;
  logic and_1579_s4_q;
  logic and_1582_s4_q;
  logic select_1599_s4_q;
  logic equal_1600_s4_q;
  logic and_1608_s4_q;
  logic equal_1610_s4_q;
  logic select_1674_s4_q;
  logic and_1681_s4_q;
  logic equal_1682_s4_q;
  logic equal_1684_s4_q;
  logic and_1697_s4_q;
  logic [4:0] select_1712_s4_q;
  logic select_1718_s4_q;
  logic [3:0] select_1759_s4_q;
  logic less_1845_s4_q;
  logic equal_1846_s4_q;
  logic not_1847_s4_q;
  logic equal_1848_s4_q;
  logic and_1863_s4_q;
  logic select_1865_s4_q;
  logic and_1868_s4_q;
  logic or_1874_s4_q;
  logic or_1877_s4_q;
  logic or_1880_s4_q;
  logic not_1882_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1903_s4_q;
  logic and_1908_s4_q;
  logic and_1940_s4_q;
  logic less_1941_s4_q;
  logic [11:0] sum_1949_s4_q;
  logic equal_1962_s4_q;
  logic or_1967_s4_q;
  logic or_1970_s4_q;
  logic or_1973_s4_q;
  logic not_1998_s4_q;
  logic less_2012_s4_q;
  logic and_2023_s4_q;
  logic [11:0] sum_2152_s4_q;
  logic [9:0] sum_2155_s4_q;
  logic equal_2163_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2412_s4_q;
  logic and_2416_s4_q;
  logic not_2450_s4_q;
  logic and_2478_s4_q;
  logic and_2527_s4_q;
  logic and_2528_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2562_s4_q;
  logic and_2576_s4_q;
  logic equal_2619_s4_q;
  logic parity_2997_s4_q;
  logic parity_3126_s4_q;
  logic parity_3188_s4_q;
  logic xor_3216_s4_q;
  logic parity_3228_s4_q;
  logic or_3232_s4_q;
  logic equal_3233_s4_q;
  logic [4:0] select_3352_s4_q;
  logic equal_3364_s4_q;
  logic less_3366_s4_q;
  logic less_3367_s4_q;
  logic or_3372_s4_q;
  logic [7:0] select_3417_s4_q;
  logic equal_3580_s4_q;
  logic and_3897_s4_q;
  logic equal_3963_s4_q;
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
      patches_summed_row_column_s4_q <= patches_summed_row_column_q;
      patches_summed_first_s4_q <= patches_summed_first_q;
      patches_summed_last_s4_q <= patches_summed_last_s3_q;
      patches_summed_down_by_s4_q <= patches_summed_down_by_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      done_s4_q <= done_q;
      select_475_s4_q <= select_475_s3_q;
      select_477_s4_q <= select_477_s3_q;
      column_s4_q <= column_s3_q;
      and_509_s4_q <= and_509_s3_q;
      and_511_s4_q <= and_511_s3_q;
      grey_s4_q <= grey;
      equal_514_s4_q <= equal_514;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      less_545_s4_q <= less_545;
      less_546_s4_q <= less_546;
      less_547_s4_q <= less_547;
      less_548_s4_q <= less_548;
      less_549_s4_q <= less_549;
      less_550_s4_q <= less_550;
      less_551_s4_q <= less_551;
      less_552_s4_q <= less_552;
      less_553_s4_q <= less_553;
      less_554_s4_q <= less_554;
      less_555_s4_q <= less_555;
      less_556_s4_q <= less_556;
      less_557_s4_q <= less_557;
      less_558_s4_q <= less_558;
      less_559_s4_q <= less_559;
      less_560_s4_q <= less_560;
      less_561_s4_q <= less_561;
      less_562_s4_q <= less_562;
      less_563_s4_q <= less_563;
      less_564_s4_q <= less_564;
      less_565_s4_q <= less_565;
      less_566_s4_q <= less_566;
      less_567_s4_q <= less_567;
      less_568_s4_q <= less_568;
      and_576_s4_q <= and_576;
      and_601_s4_q <= whole_22 & and_576;
      and_602_s4_q <= census_columns_values_1_cell_2_mask_q & and_576;
      sum_617_s4_q <= {1'b0, sum_613} + {2'h0, sum_616};
      sum_620_s4_q <= {9'h0, difference_618[9]} + {1'b0, xor_619};
      equal_1469_s4_q <= equal_1469_s3_q;
      not_1470_s4_q <= not_1470_s3_q;
      equal_1514_s4_q <= equal_1514;
      all_s4_q <= all;
      sum_1520_s4_q <= sum_1520;
      equal_1522_s4_q <= equal_1522;
      equal_1524_s4_q <= equal_1524;
      equal_1526_s4_q <= equal_1526;
      equal_1528_s4_q <= equal_1528;
      equal_1530_s4_q <= equal_1530;
      equal_1532_s4_q <= equal_1532;
      equal_1534_s4_q <= equal_1534;
      equal_1536_s4_q <= equal_1536;
      less_1545_s4_q <= less_1545;
      or_1549_s4_q <= or_1549;
      equal_1569_s4_q <= (registration_fresh_q & select_1567) == 4'h0;
      and_1579_s4_q <= not_1470_s3_q & and_1563;
      and_1582_s4_q <= and_1582_s3_q;
      select_1599_s4_q <= select_1599[1];
      equal_1600_s4_q <= equal_1600;
      and_1608_s4_q <= and_1608;
      equal_1610_s4_q <= equal_1610;
      select_1674_s4_q <= select_1674[0];
      and_1681_s4_q <= and_1681;
      equal_1682_s4_q <= equal_1682_s3_q;
      equal_1684_s4_q <= equal_1684_s3_q;
      and_1697_s4_q <= and_1681 & equal_1696;
      select_1712_s4_q <= select_1712_s3_q;
      select_1718_s4_q <= select_1718_s3_q;
      select_1759_s4_q <= select_1759_s3_q;
      less_1845_s4_q <= less_1845_s3_q;
      equal_1846_s4_q <= equal_1846_s3_q;
      not_1847_s4_q <= not_1847_s3_q;
      equal_1848_s4_q <= equal_1848_s3_q;
      and_1863_s4_q <= and_1863_s3_q;
      select_1865_s4_q <= select_1865_s3_q;
      and_1868_s4_q <= and_1868_s3_q;
      or_1874_s4_q <= or_1874;
      or_1877_s4_q <= or_1877;
      or_1880_s4_q <= or_1880;
      not_1882_s4_q <= not_1882;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1903_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_1908_s4_q <= not_1470_s3_q & and_1889;
      and_1940_s4_q <= and_1940;
      less_1941_s4_q <= less_1941;
      sum_1949_s4_q <= sum_1949;
      equal_1962_s4_q <= t[4:1] == 4'h0;
      or_1967_s4_q <= or_1967;
      or_1970_s4_q <= select_1964[7] | (~({select_1964[6], select_1964[3:2]} == 3'h0));
      or_1973_s4_q <= select_1964[7] | (~(select_1964[6:4] == 3'h0));
      not_1998_s4_q <= ~({sum_1996, around[0]} < {2'h0, t});
      less_2012_s4_q <= {1'b0, around[4:1]} < n;
      and_2023_s4_q <= and_2023;
      sum_2152_s4_q <= {1'b0, sum_2148} + {2'h0, sum_2151};
      sum_2155_s4_q <= {9'h0, difference_2153[9]} + {1'b0, xor_2154};
      equal_2163_s4_q <= equal_2163_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2412_s4_q <= and_2412;
      and_2416_s4_q <= and_2416;
      not_2450_s4_q <= ~({sum_2448, e[0]} < {2'h0, t});
      and_2478_s4_q <= not_1470_s3_q & and_2477;
      and_2527_s4_q <= not_1470_s3_q & (so_s3_q & (half_ends & equal_2524));
      and_2528_s4_q <= and_2528;
      residual_s4_q <= residual[7:0];
      and_2562_s4_q <= and_2562;
      and_2576_s4_q <= and_2528 & less_2575;
      equal_2619_s4_q <= (registration_fresh_q & select_2617) == 4'h0;
      parity_2997_s4_q <= ^{xor_2993, xor_2956, select_2923[44:36], other[44:36]};
      parity_3126_s4_q <= parity_3126;
      parity_3188_s4_q <= parity_3188;
      xor_3216_s4_q <= parity_3203 ^ parity_3215;
      parity_3228_s4_q <= ^{or_3225, or_3221, and_3217};
      or_3232_s4_q <= (or_3221 & or_3225) | (and_3217 & (or_3221 | or_3225));
      equal_3233_s4_q <= equal_3233_s3_q;
      select_3352_s4_q <= select_3352[14:10];
      equal_3364_s4_q <= select_3321[3:0] == 4'h0;
      less_3366_s4_q <= {difference_3365, 3'h0} < {3'h0, sum_2913};
      less_3367_s4_q <= select_3362 < select_3352[9:0];
      or_3372_s4_q <= (sum_2913 < 10'h39) | ({1'b0, sum_2913[9:1]} < select_3352[9:0]);
      select_3417_s4_q <= select_3417;
      equal_3580_s4_q <= equal_3580;
      and_3897_s4_q <= and_2023 & (sum_1949 == sum_1933);
      equal_3963_s4_q <= (registration_fresh_q & select_3961) == 4'h0;
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
  logic patches_place_0_valid_q;
  logic [6:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic patches_place_1_valid_q;
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
  logic patches_partly_q;
  logic [6:0] patches_clear_limit_q;
  logic patches_complete_q;
  logic patches_frame_ended_q;
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
  assign texture = sum_617_s4_q + {2'h0, sum_620_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_622;
  assign sum_622 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_624;
  assign sum_624 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_622});
  // hls/stages/census.hpp:303
  logic less_625;
  assign less_625 = 9'h4 < sum_624[13:5];
  logic and_626;
  assign and_626 = and_576_s4_q & less_625;
  // hls/stages/registration.hpp:265
  logic equal_1571;
  assign equal_1571 = sum_1520_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1520_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1573;
  assign select_1573 = equal_1571 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1574;
  assign sum_1574 = (equal_1569_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1573[13]}}, select_1573};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1520_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1577;
  assign select_1577 = equal_1571 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1578;
  assign sum_1578 = (equal_1569_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1577[6]}}, select_1577};
  // hls/stages/patches.hpp:343
  logic [21:0] select_1698;
  assign select_1698 = and_1697_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1674_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:119
  logic select_1700;
  assign select_1700 = equal_1600_s4_q ? patches_place_0_valid_q : (select_1599_s4_q ? patches_place_0_valid_q : select_1698[0]);
  // hls/stages/patches.hpp:344
  logic [20:0] select_1701;
  assign select_1701 = select_1599_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1698[21:1];
  // hls/stages/patches.hpp:119
  logic [6:0] select_1702;
  assign select_1702 = equal_1600_s4_q ? patches_place_0_column_q : select_1701[6:0];
  logic [5:0] select_1703;
  assign select_1703 = equal_1600_s4_q ? patches_place_0_shift_q : select_1701[12:7];
  // hls/stages/patches.hpp:314
  logic [6:0] sum_1704;
  assign sum_1704 = select_1702 + {select_1703[5], select_1703};
  // hls/stages/patches.hpp:315
  logic [5:0] sum_1705;
  assign sum_1705 = sum_1704[6:1] + 6'h3f;
  // hls/stages/patches.hpp:123
  logic equal_1706;
  assign equal_1706 = {sum_1705[5], select_477_s4_q, select_475_s4_q} == {1'b0, sum_1705[4:0], sum_1704[0], 3'h4};
  // hls/stages/patches.hpp:125
  logic or_1708;
  assign or_1708 = and_1582_s4_q | (select_1700 & equal_1706);
  // hls/stages/agreement.hpp:264
  logic [4:0] select_1709;
  assign select_1709 = or_1708 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:125
  logic [5:0] select_1719;
  assign select_1719 = or_1708 ? {and_1582_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:129
  logic and_1721;
  assign and_1721 = select_1718_s4_q & (~select_1719[5]);
  // hls/stages/patches.hpp:119
  logic select_1729;
  assign select_1729 = equal_1600_s4_q ? patches_place_1_valid_q : (select_1599_s4_q ? select_1698[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:344
  logic [20:0] select_1730;
  assign select_1730 = select_1599_s4_q ? select_1698[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:119
  logic [6:0] select_1731;
  assign select_1731 = equal_1600_s4_q ? patches_place_1_column_q : select_1730[6:0];
  logic [5:0] select_1732;
  assign select_1732 = equal_1600_s4_q ? patches_place_1_shift_q : select_1730[12:7];
  // hls/stages/patches.hpp:314
  logic [6:0] sum_1733;
  assign sum_1733 = select_1731 + {select_1732[5], select_1732};
  // hls/stages/patches.hpp:315
  logic [5:0] sum_1734;
  assign sum_1734 = sum_1733[6:1] + 6'h3f;
  // hls/stages/patches.hpp:123
  logic equal_1735;
  assign equal_1735 = {sum_1734[5], select_477_s4_q, select_475_s4_q} == {1'b0, sum_1734[4:0], sum_1733[0], 3'h4};
  // hls/stages/patches.hpp:125
  logic or_1737;
  assign or_1737 = and_1582_s4_q | (select_1729 & equal_1735);
  // hls/stages/agreement.hpp:264
  logic [4:0] select_1738;
  assign select_1738 = or_1737 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:125
  logic [5:0] select_1739;
  assign select_1739 = or_1737 ? {and_1582_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:129
  logic and_1741;
  assign and_1741 = select_1718_s4_q & (~select_1739[5]);
  // hls/stages/patches.hpp:310
  logic [6:0] sum_1748;
  assign sum_1748 = select_1702 + 7'h7f;
  // hls/stages/patches.hpp:124
  logic equal_1749;
  assign equal_1749 = {sum_1748[6], select_477_s4_q, select_475_s4_q} == {1'b0, sum_1748[5:0], 3'h4};
  // hls/stages/patches.hpp:126
  logic or_1751;
  assign or_1751 = and_1582_s4_q | (select_1700 & equal_1749);
  logic [4:0] select_1752;
  assign select_1752 = or_1751 ? {and_1582_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:310
  logic [6:0] sum_1753;
  assign sum_1753 = select_1731 + 7'h7f;
  // hls/stages/patches.hpp:124
  logic equal_1754;
  assign equal_1754 = {sum_1753[6], select_477_s4_q, select_475_s4_q} == {1'b0, sum_1753[5:0], 3'h4};
  // hls/stages/patches.hpp:126
  logic [4:0] select_1757;
  assign select_1757 = (and_1582_s4_q | (select_1729 & equal_1754)) ? {and_1582_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:134
  logic [3:0] column_5;
  assign column_5 = select_1752[4] ? select_1757[3:0] : select_1752[3:0];
  // hls/stages/agreement.hpp:264
  logic select_1760;
  assign select_1760 = or_1751 ? and_1582_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:134
  logic and_1766;
  assign and_1766 = (select_1718_s4_q & (select_1712_s4_q[3] ^ select_1712_s4_q[4])) & ((~select_1752[4]) | (~select_1757[4]));
  // hls/stages/patches.hpp:176
  logic less_1857;
  assign less_1857 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:177
  logic not_1858;
  assign not_1858 = ~less_1857;
  logic [1:0] select_1859;
  assign select_1859 = patches_summed_first_s4_q ? 2'h2 : {less_1857, not_1858};
  logic [12:0] select_1861;
  assign select_1861 = select_1859[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1869;
  assign select_1869 = select_1859[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1868_s4_q, 1'b0, select_1865_s4_q, left_pixel_q};
  logic [14:0] select_1870;
  assign select_1870 = (select_1859 == 2'h2) ? {select_1861[12:8], patches_sums_values_0_q[9:8], select_1861[7:0]} : select_1869;
  // hls/stages/agreement.hpp:876
  logic [5:0] select_1893;
  assign select_1893 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:877
  logic [5:0] sum_1894;
  assign sum_1894 = {5'h0, textured_s4_q} + select_1893;
  // hls/stages/agreement.hpp:1013
  logic [9:0] sum_1896;
  assign sum_1896 = {4'h0, sum_1894} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:876
  logic [5:0] select_1898;
  assign select_1898 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:877
  logic [5:0] sum_1899;
  assign sum_1899 = {5'h0, explained_s4_q} + select_1898;
  // hls/stages/agreement.hpp:1014
  logic [9:0] sum_1901;
  assign sum_1901 = {4'h0, sum_1899} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:876
  logic [5:0] select_1904;
  assign select_1904 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:878
  logic [5:0] sum_1905;
  assign sum_1905 = {5'h0, and_1903_s4_q} + select_1904;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_1907;
  assign sum_1907 = {4'h0, sum_1905} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1053
  logic not_1974;
  assign not_1974 = ~region_row_s4_q[2];
  logic [2:0] select_1975;
  assign select_1975 = region_row_s4_q[1] ? {1'b0, not_1974, 1'b0} : {region_row_s4_q[2], 1'b0, not_1974};
  logic [5:0] select_1976;
  assign select_1976 = region_row_s4_q[0] ? {select_1975[2], 1'b0, select_1975[1], 1'b0, select_1975[0], 1'b0} : {1'b0, select_1975[2], 1'b0, select_1975[1], 1'b0, select_1975[0]};
  logic [11:0] select_1977;
  assign select_1977 = or_1973_s4_q ? {select_1976[5], 1'b0, select_1976[4], 1'b0, select_1976[3], 1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0], 1'b0} : {1'b0, select_1976[5], 1'b0, select_1976[4], 1'b0, select_1976[3], 1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0]};
  logic [23:0] select_1978;
  assign select_1978 = or_1970_s4_q ? {select_1977[11], 1'b0, select_1977[10], 1'b0, select_1977[9], 1'b0, select_1977[8], 1'b0, select_1977[7], 1'b0, select_1977[6], 1'b0, select_1977[5], 1'b0, select_1977[4], 1'b0, select_1977[3], 1'b0, select_1977[2], 1'b0, select_1977[1], 1'b0, select_1977[0], 1'b0} : {1'b0, select_1977[11], 1'b0, select_1977[10], 1'b0, select_1977[9], 1'b0, select_1977[8], 1'b0, select_1977[7], 1'b0, select_1977[6], 1'b0, select_1977[5], 1'b0, select_1977[4], 1'b0, select_1977[3], 1'b0, select_1977[2], 1'b0, select_1977[1], 1'b0, select_1977[0]};
  logic [47:0] select_1979;
  assign select_1979 = or_1967_s4_q ? {select_1978[23], 1'b0, select_1978[22], 1'b0, select_1978[21], 1'b0, select_1978[20], 1'b0, select_1978[19], 1'b0, select_1978[18], 1'b0, select_1978[17], 1'b0, select_1978[16], 1'b0, select_1978[15], 1'b0, select_1978[14], 1'b0, select_1978[13], 1'b0, select_1978[12], 1'b0, select_1978[11], 1'b0, select_1978[10], 1'b0, select_1978[9], 1'b0, select_1978[8], 1'b0, select_1978[7], 1'b0, select_1978[6], 1'b0, select_1978[5], 1'b0, select_1978[4], 1'b0, select_1978[3], 1'b0, select_1978[2], 1'b0, select_1978[1], 1'b0, select_1978[0], 1'b0} : {1'b0, select_1978[23], 1'b0, select_1978[22], 1'b0, select_1978[21], 1'b0, select_1978[20], 1'b0, select_1978[19], 1'b0, select_1978[18], 1'b0, select_1978[17], 1'b0, select_1978[16], 1'b0, select_1978[15], 1'b0, select_1978[14], 1'b0, select_1978[13], 1'b0, select_1978[12], 1'b0, select_1978[11], 1'b0, select_1978[10], 1'b0, select_1978[9], 1'b0, select_1978[8], 1'b0, select_1978[7], 1'b0, select_1978[6], 1'b0, select_1978[5], 1'b0, select_1978[4], 1'b0, select_1978[3], 1'b0, select_1978[2], 1'b0, select_1978[1], 1'b0, select_1978[0]};
  // hls/stages/agreement.hpp:986
  logic and_1983;
  assign and_1983 = good_known_q & (~((good_q & select_1979) == 48'h0));
  // hls/stages/agreement.hpp:1055
  logic is_seen;
  assign is_seen = equal_1962_s4_q ? and_1983 : not_1998_s4_q;
  // hls/stages/agreement.hpp:1064
  logic and_2013;
  assign and_2013 = is_seen & less_2012_s4_q;
  // hls/stages/agreement.hpp:264
  logic [8:0] select_2047;
  assign select_2047 = sample_pair_whole_s4_q ? (and_509_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2049;
  assign select_2049 = sample_pair_whole_s4_q ? (and_509_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2051;
  assign select_2051 = sample_pair_whole_s4_q ? (and_509_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2053;
  assign select_2053 = sample_pair_whole_s4_q ? (and_509_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2058;
  assign sum_2058 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2059;
  assign difference_2059 = {1'b0, sum_2058[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2060;
  assign xor_2060 = {difference_2059[8:0], sum_2058[0]} ^ {10{difference_2059[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2059[9]} + {1'b0, xor_2060};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_514_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:264
  logic [13:0] select_2065;
  assign select_2065 = sample_pair_whole_s4_q ? (and_509_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2066;
  assign sum_2066 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2067;
  assign difference_2067 = {1'b0, sum_2066[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2068;
  assign xor_2068 = {difference_2067[8:0], sum_2066[0]} ^ {10{difference_2067[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2067[9]} + {1'b0, xor_2068};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_514_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:264
  logic [13:0] select_2073;
  assign select_2073 = sample_pair_whole_s4_q ? (and_509_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2156;
  assign sum_2156 = sum_2152_s4_q + {2'h0, sum_2155_s4_q};
  // hls/stages/agreement.hpp:508
  logic [11:0] select_2158;
  assign select_2158 = and_511_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2159;
  assign select_2159 = and_511_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2160;
  assign select_2160 = and_511_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2161;
  assign select_2161 = and_511_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2164;
  assign sum_2164 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2156};
  logic [13:0] sum_2166;
  assign sum_2166 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2164});
  // hls/stages/census.hpp:305
  logic and_2168;
  assign and_2168 = and_601_s4_q & (9'h4 < sum_2166[13:5]);
  // hls/stages/census.hpp:306
  logic and_2169;
  assign and_2169 = and_601_s4_q & less_625;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2170;
  assign sum_2170 = census_left_misses_q + {{17{and_2169}}, and_2168, 1'b0, and_2168};
  // hls/stages/agreement.hpp:508
  logic [19:0] select_2172;
  assign select_2172 = and_511_s4_q ? (equal_2163_s4_q ? 20'h0 : sum_2170) : census_left_misses_q;
  // hls/stages/agreement.hpp:264
  logic [27:0] select_2177;
  assign select_2177 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:508
  logic select_2180;
  assign select_2180 = and_511_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2183;
  assign and_2183 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:445
  logic and_2189;
  assign and_2189 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2190;
  assign and_2190 = and_2183 & and_2189;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2177[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2192;
  assign select_2192 = and_2190 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2194;
  assign select_2194 = equal_2163_s4_q ? {11'h0, select_2192} : (sharpness_sums_detail_0_q + {11'h0, select_2192});
  // hls/stages/agreement.hpp:445
  logic and_2201;
  assign and_2201 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2202;
  assign and_2202 = and_2183 & and_2201;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2177[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2204;
  assign select_2204 = and_2202 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2206;
  assign select_2206 = equal_2163_s4_q ? {11'h0, select_2204} : (sharpness_sums_detail_1_q + {11'h0, select_2204});
  logic [8:0] select_2209;
  assign select_2209 = and_2190 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2210;
  assign sum_2210 = (equal_2163_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2209};
  logic [8:0] select_2213;
  assign select_2213 = and_2202 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2214;
  assign sum_2214 = (equal_2163_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2213};
  // hls/stages/agreement.hpp:203
  logic equal_2216;
  assign equal_2216 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2217;
  assign less_2217 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2218;
  assign less_2218 = x_s4_q[4:0] < 5'h3;
  logic not_2219;
  assign not_2219 = ~x_s4_q[1];
  logic [2:0] select_2220;
  assign select_2220 = x_s4_q[0] ? {1'b0, not_2219, 1'b0} : {x_s4_q[1], 1'b0, not_2219};
  logic [5:0] select_2221;
  assign select_2221 = slot_s4_q[2] ? {select_2220[2], 1'b0, select_2220[1], 1'b0, select_2220[0], 1'b0} : {1'b0, select_2220[2], 1'b0, select_2220[1], 1'b0, select_2220[0]};
  logic [11:0] select_2222;
  assign select_2222 = slot_s4_q[1] ? {select_2221[5], 1'b0, select_2221[4], 1'b0, select_2221[3], 1'b0, select_2221[2], 1'b0, select_2221[1], 1'b0, select_2221[0], 1'b0} : {1'b0, select_2221[5], 1'b0, select_2221[4], 1'b0, select_2221[3], 1'b0, select_2221[2], 1'b0, select_2221[1], 1'b0, select_2221[0]};
  logic [23:0] select_2223;
  assign select_2223 = slot_s4_q[0] ? {select_2222[11], 1'b0, select_2222[10], 1'b0, select_2222[9], 1'b0, select_2222[8], 1'b0, select_2222[7], 1'b0, select_2222[6], 1'b0, select_2222[5], 1'b0, select_2222[4], 1'b0, select_2222[3], 1'b0, select_2222[2], 1'b0, select_2222[1], 1'b0, select_2222[0], 1'b0} : {1'b0, select_2222[11], 1'b0, select_2222[10], 1'b0, select_2222[9], 1'b0, select_2222[8], 1'b0, select_2222[7], 1'b0, select_2222[6], 1'b0, select_2222[5], 1'b0, select_2222[4], 1'b0, select_2222[3], 1'b0, select_2222[2], 1'b0, select_2222[1], 1'b0, select_2222[0]};
  // hls/stages/census.hpp:372
  logic and_2227;
  assign and_2227 = less_2218 & (~((sharpness_sums_contrast_1_q & select_2223) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2229;
  assign select_2229 = (less_2217 & and_2227) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2229};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2232;
  assign select_2232 = equal_2216 ? (less_2217 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2237;
  assign and_2237 = less_2218 & (~((sharpness_sums_contrast_0_q & select_2223) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2239;
  assign select_2239 = (less_2217 & and_2237) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2239};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2242;
  assign select_2242 = equal_2216 ? (less_2217 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2244;
  assign select_2244 = equal_2216 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2246;
  assign select_2246 = equal_2216 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2248;
  assign select_2248 = equal_2216 ? {sharpness_comparing_contrast_0_q[0], and_2237} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2250;
  assign select_2250 = equal_2216 ? {sharpness_comparing_contrast_1_q[0], and_2227} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2255;
  assign select_2255 = drew_q ? (equal_2216 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2259;
  assign select_2259 = drew_q ? (equal_2216 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2260;
  assign equal_2260 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2261;
  assign xor_2261 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2264;
  assign select_2264 = (equal_2260 | xor_2261) ? (five_times[0] & xor_2261) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2266;
  assign select_2266 = drew_q ? (equal_2216 ? select_2264 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2267;
  assign xor_2267 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2270;
  assign select_2270 = (equal_2260 | xor_2267) ? (five_times_2[0] & xor_2267) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2272;
  assign select_2272 = drew_q ? (equal_2216 ? select_2270 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2273;
  assign xor_2273 = sharpness_comparing_contrast_0_q[1] ^ and_2227;
  logic select_2276;
  assign select_2276 = (equal_2260 | xor_2273) ? (and_2227 & xor_2273) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2278;
  assign select_2278 = drew_q ? (equal_2216 ? select_2276 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2279;
  assign xor_2279 = sharpness_comparing_contrast_1_q[1] ^ and_2237;
  logic select_2282;
  assign select_2282 = (equal_2260 | xor_2279) ? (and_2237 & xor_2279) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2284;
  assign select_2284 = drew_q ? (equal_2216 ? select_2282 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2418;
  assign select_2418 = and_2412_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2416_s4_q});
  // hls/stages/agreement.hpp:773
  logic and_2421;
  assign and_2421 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2426;
  assign and_2426 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2431;
  assign and_2431 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & and_1903_s4_q));
  // hls/stages/agreement.hpp:1057
  logic not_2435;
  assign not_2435 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1058
  logic not_2452;
  assign not_2452 = ~(equal_1962_s4_q ? and_1983 : not_2450_s4_q);
  // hls/stages/agreement.hpp:773
  logic and_2455;
  assign and_2455 = ends_cell_s4_q & (not_2435 & (centres_values_1_textured_s4_q & not_2452));
  logic and_2457;
  assign and_2457 = not_1470_s4_q & (drew_q & and_2455);
  // hls/stages/agreement.hpp:1084
  logic less_2460;
  assign less_2460 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2461;
  assign select_2461 = less_2460 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2464;
  assign select_2464 = less_2460 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1085
  logic [10:0] sum_2465;
  assign sum_2465 = {1'b0, select_2464} + {3'h0, select_2464[9:2]};
  logic and_2467;
  assign and_2467 = (~(select_2461[9:4] == 6'h0)) & ({sum_2465, select_2464[1:0]} < {3'h0, select_2461});
  // hls/stages/agreement.hpp:1094
  logic [9:0] select_2470;
  assign select_2470 = x_s4_q[6] ? (equal_1514_s4_q ? 10'h0 : (and_2467 ? select_2461 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:773
  logic [9:0] select_2471;
  assign select_2471 = equal_1469_s4_q ? select_2470 : 10'h0;
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2473;
  assign select_2473 = and_2412_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2471});
  logic [13:0] select_2480;
  assign select_2480 = and_2412_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2478_s4_q});
  // hls/stages/agreement.hpp:1062
  logic and_2482;
  assign and_2482 = not_2435 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:773
  logic and_2485;
  assign and_2485 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & and_2482));
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2487;
  assign select_2487 = and_2412_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2485});
  // hls/stages/agreement.hpp:1062
  logic and_2489;
  assign and_2489 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2452);
  // hls/stages/agreement.hpp:773
  logic and_2493;
  assign and_2493 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & (not_2435 & and_2489)));
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2495;
  assign select_2495 = and_2412_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2493});
  // hls/stages/agreement.hpp:773
  logic [7:0] select_2544;
  assign select_2544 = drew_q ? (equal_1610_s4_q ? (and_2528_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2545;
  assign select_2545 = equal_1469_s4_q ? 8'h0 : select_2544;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2547;
  assign select_2547 = and_2527_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2545[7]}}, select_2545});
  // hls/stages/agreement.hpp:773
  logic and_2550;
  assign and_2550 = not_1470_s4_q & (drew_q & (and_2528_s4_q & equal_1610_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2552;
  assign select_2552 = and_2527_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2550});
  // hls/stages/registration.hpp:107
  logic and_2554;
  assign and_2554 = and_2528_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2556;
  assign select_2556 = drew_q ? (equal_1610_s4_q ? {and_2554, and_2528_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2557;
  assign select_2557 = equal_1469_s4_q ? 2'h0 : select_2556;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2558;
  assign sum_2558 = registration_half_votes_down_q + {{5{select_2557[1]}}, select_2557};
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2564;
  assign select_2564 = drew_q ? (equal_1610_s4_q ? {and_2562_s4_q, and_2528_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2565;
  assign select_2565 = equal_1469_s4_q ? 2'h0 : select_2564;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2566;
  assign sum_2566 = registration_half_votes_up_q + {{5{select_2565[1]}}, select_2565};
  // hls/stages/registration.hpp:107
  logic and_2569;
  assign and_2569 = and_2528_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2571;
  assign select_2571 = drew_q ? (equal_1610_s4_q ? {and_2569, and_2528_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2572;
  assign select_2572 = equal_1469_s4_q ? 2'h0 : select_2571;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2573;
  assign sum_2573 = registration_half_half_votes_down_q + {{5{select_2572[1]}}, select_2572};
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2578;
  assign select_2578 = drew_q ? (equal_1610_s4_q ? {and_2576_s4_q, and_2528_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2579;
  assign select_2579 = equal_1469_s4_q ? 2'h0 : select_2578;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2580;
  assign sum_2580 = registration_half_half_votes_up_q + {{5{select_2579[1]}}, select_2579};
  // hls/stages/agreement.hpp:773
  logic and_2614;
  assign and_2614 = equal_1469_s4_q & (x_s4_q[6] & (not_1882_s4_q & less_1545_s4_q));
  // hls/stages/agreement.hpp:1082
  logic [11:0] select_2621;
  assign select_2621 = or_1549_s4_q ? 12'h0 : (equal_2619_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1094
  logic [11:0] select_2624;
  assign select_2624 = x_s4_q[6] ? (equal_1514_s4_q ? 12'h0 : (less_1545_s4_q ? select_2621 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:773
  logic [11:0] select_2625;
  assign select_2625 = equal_1469_s4_q ? select_2624 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2626;
  assign and_2626 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1094
  logic and_2629;
  assign and_2629 = not_1882_s4_q & (less_1545_s4_q & ({and_2626, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:773
  logic and_2631;
  assign and_2631 = equal_1469_s4_q & (x_s4_q[6] & and_2629);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2633;
  assign sum_2633 = {{2{select_2625[11]}}, select_2625} + (and_2631 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1082
  logic [11:0] select_2636;
  assign select_2636 = or_1549_s4_q ? 12'h0 : (equal_2619_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1094
  logic [11:0] select_2639;
  assign select_2639 = x_s4_q[6] ? (equal_1514_s4_q ? 12'h0 : (less_1545_s4_q ? select_2636 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:773
  logic [11:0] select_2640;
  assign select_2640 = equal_1469_s4_q ? select_2639 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2642;
  assign sum_2642 = {{2{select_2640[11]}}, select_2640} + (and_2631 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2644;
  assign not_2644 = ~all_s4_q;
  // hls/stages/agreement.hpp:1094
  logic and_2647;
  assign and_2647 = not_1882_s4_q & (less_1545_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2644, 1'b0}));
  // hls/stages/agreement.hpp:773
  logic and_2653;
  assign and_2653 = equal_1469_s4_q & (x_s4_q[6] & (not_1882_s4_q & (less_1545_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_2654;
  assign not_2654 = ~and_2653;
  logic less_2655;
  assign less_2655 = $signed({9'h1, {2{not_2654}}, and_2653}) < $signed(registration_up_q[13:2]);
  logic select_2656;
  assign select_2656 = (equal_1469_s4_q & (x_s4_q[6] & and_2647)) ? less_2655 : registration_enough_q;
  // hls/stages/agreement.hpp:1094
  logic and_2660;
  assign and_2660 = x_s4_q[6] & (not_1882_s4_q & (less_1545_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:773
  logic and_2661;
  assign and_2661 = equal_1469_s4_q & and_2660;
  // hls/stages/registration.hpp:242
  logic less_2662;
  assign less_2662 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2664;
  assign less_2664 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2666;
  assign equal_2666 = x_s4_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:773
  logic and_2670;
  assign and_2670 = equal_1469_s4_q & (x_s4_q[6] & (not_1882_s4_q & (less_1545_s4_q & equal_2666)));
  // hls/stages/agreement.hpp:1094
  logic and_2677;
  assign and_2677 = x_s4_q[6] & (not_1882_s4_q & (less_1545_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2680;
  assign equal_2680 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1094
  logic and_2683;
  assign and_2683 = not_1882_s4_q & (less_1545_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2680));
  // hls/stages/registration.hpp:244
  logic and_2687;
  assign and_2687 = (equal_1469_s4_q & (x_s4_q[6] & and_2683)) & (less_2664 | less_2662);
  // hls/stages/agreement.hpp:1094
  logic and_2692;
  assign and_2692 = not_1882_s4_q & (less_1545_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2680)));
  // hls/stages/registration.hpp:244
  logic and_2695;
  assign and_2695 = registration_votes_up_q & registration_other_down_q;
  logic select_2697;
  assign select_2697 = registration_votes_down_q ? (registration_other_up_q | and_2695) : and_2695;
  // hls/stages/registration.hpp:138
  logic and_2699;
  assign and_2699 = (equal_1469_s4_q & (x_s4_q[6] & and_2692)) & (registration_other_enough_q & select_2697);
  // hls/stages/registration.hpp:245
  logic or_2702;
  assign or_2702 = registration_moved_q | (registration_enough_q & (and_2687 | and_2699));
  // hls/stages/agreement.hpp:264
  logic [7:0] select_2786;
  assign select_2786 = sample_pair_whole_s4_q ? (equal_1600_s4_q ? patches_place_0_slope_q : select_1701[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2791;
  assign select_2791 = sample_pair_whole_s4_q ? (equal_1600_s4_q ? patches_place_1_slope_q : select_1730[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:119
  logic select_2793;
  assign select_2793 = equal_1600_s4_q ? patches_valid_0_q : (select_1599_s4_q ? patches_valid_0_q : select_1698[0]);
  // hls/stages/agreement.hpp:264
  logic select_2796;
  assign select_2796 = sample_pair_whole_s4_q ? (and_1721 ? (sample_present_s4_q & select_2793) : select_2793) : patches_valid_0_q;
  // hls/stages/patches.hpp:119
  logic select_2798;
  assign select_2798 = equal_1600_s4_q ? patches_valid_1_q : (select_1599_s4_q ? select_1698[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:264
  logic select_2801;
  assign select_2801 = sample_pair_whole_s4_q ? (and_1741 ? (sample_present_s4_q & select_2798) : select_2798) : patches_valid_1_q;
  logic [5:0] select_2804;
  assign select_2804 = sample_pair_whole_s4_q ? (select_1719[5] ? {1'b1, select_1719[4:0]} : (select_1719 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2807;
  assign select_2807 = sample_pair_whole_s4_q ? (select_1739[5] ? {1'b1, select_1739[4:0]} : (select_1739 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2810;
  assign select_2810 = sample_pair_whole_s4_q ? (select_1752[4] ? {1'b1, select_1752[3:0]} : (select_1752 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2813;
  assign select_2813 = sample_pair_whole_s4_q ? (select_1757[4] ? {1'b1, select_1757[3:0]} : (select_1757 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:511
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3232_s4_q, parity_3228_s4_q, xor_3216_s4_q, parity_3188_s4_q, parity_3126_s4_q, parity_2997_s4_q} + (equal_3233_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:176
  logic [9:0] select_3237;
  assign select_3237 = equal_1682_s4_q ? patches_sums_values_0_q : (equal_1684_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3238;
  assign select_3238 = equal_1684_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3240;
  assign select_3240 = equal_1684_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3242;
  assign select_3242 = equal_1684_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3244;
  assign select_3244 = equal_1684_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3246;
  assign select_3246 = equal_1684_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3248;
  assign select_3248 = equal_1684_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3250;
  assign select_3250 = equal_1684_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3252;
  assign select_3252 = equal_1684_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3254;
  assign select_3254 = equal_1684_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3256;
  assign select_3256 = equal_1684_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3258;
  assign select_3258 = equal_1684_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3260;
  assign select_3260 = equal_1684_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3262;
  assign select_3262 = equal_1684_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3264;
  assign select_3264 = equal_1684_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3266;
  assign select_3266 = equal_1684_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3268;
  assign select_3268 = equal_1684_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:585
  logic or_3373;
  assign or_3373 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3372_s4_q;
  logic or_3376;
  assign or_3376 = equal_3364_s4_q | (less_3366_s4_q | (less_3367_s4_q | or_3373));
  // hls/stages/patches.hpp:565
  logic not_3377;
  assign not_3377 = ~or_3376;
  // hls/stages/patches.hpp:546
  logic and_3378;
  assign and_3378 = equal_1848_s4_q & not_3377;
  // hls/stages/patches.hpp:176
  logic and_3381;
  assign and_3381 = equal_1682_s4_q & (less_1845_s4_q ? (not_1847_s4_q & and_3378) : and_3378);
  // hls/stages/patches.hpp:636
  logic not_3382;
  assign not_3382 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:546
  logic and_3384;
  assign and_3384 = equal_1848_s4_q & (patches_second_s4_q & not_3377);
  // hls/stages/patches.hpp:176
  logic and_3387;
  assign and_3387 = equal_1682_s4_q & (less_1845_s4_q ? (not_1847_s4_q & and_3384) : and_3384);
  // hls/stages/patches.hpp:636
  logic not_3388;
  assign not_3388 = ~and_3387;
  // hls/stages/patches.hpp:180
  logic and_3390;
  assign and_3390 = and_3381 & (not_3382 & not_3388);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3392;
  assign sum_3392 = {7'h0, and_3390} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:583
  logic [7:0] select_3418;
  assign select_3418 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3419;
  assign select_3419 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3420;
  assign sum_3420 = {2'h0, select_3352_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3421;
  assign sum_3421 = {select_3419[5], select_3419} + {{3{sum_3420[3]}}, sum_3420};
  // hls/stages/patches.hpp:583
  logic [17:0] product_3422;
  assign product_3422 = $signed({{10{select_3418[7]}}, select_3418}) * $signed({{8{sum_3421[6]}}, sum_3421, select_3352_s4_q[2:0]});
  // hls/stages/patches.hpp:584
  logic [13:0] difference_3423;
  assign difference_3423 = {{6{select_3417_s4_q[7]}}, select_3417_s4_q} - {product_3422[17], product_3422[17:5]};
  // hls/stages/patches.hpp:590
  logic less_3424;
  assign less_3424 = $signed({{7{difference_3394[6]}}, difference_3394}) < $signed(difference_3423);
  // hls/stages/patches.hpp:546
  logic and_3427;
  assign and_3427 = equal_1848_s4_q & (not_3377 & (~less_3424));
  // hls/stages/patches.hpp:176
  logic and_3430;
  assign and_3430 = equal_1682_s4_q & (less_1845_s4_q ? (not_1847_s4_q & and_3427) : and_3427);
  // hls/stages/patches.hpp:639
  logic and_3431;
  assign and_3431 = and_3430 & and_3390;
  logic [7:0] sum_3432;
  assign sum_3432 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3431};
  // hls/stages/patches.hpp:546
  logic and_3436;
  assign and_3436 = not_3377 & (~($signed(difference_3423) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3437;
  assign and_3437 = equal_1848_s4_q & and_3436;
  // hls/stages/patches.hpp:176
  logic and_3440;
  assign and_3440 = equal_1682_s4_q & (less_1845_s4_q ? (not_1847_s4_q & and_3437) : and_3437);
  // hls/stages/patches.hpp:640
  logic and_3441;
  assign and_3441 = and_3440 & and_3390;
  logic [7:0] sum_3442;
  assign sum_3442 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3441};
  // hls/stages/patches.hpp:180
  logic and_3444;
  assign and_3444 = and_3381 & (and_3387 & not_3382);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3446;
  assign sum_3446 = {7'h0, and_3444} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:639
  logic and_3448;
  assign and_3448 = and_3430 & and_3444;
  logic [7:0] sum_3449;
  assign sum_3449 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3448};
  // hls/stages/patches.hpp:640
  logic and_3451;
  assign and_3451 = and_3440 & and_3444;
  logic [7:0] sum_3452;
  assign sum_3452 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3451};
  // hls/stages/patches.hpp:180
  logic and_3454;
  assign and_3454 = and_3381 & (patches_lower_s4_q & not_3388);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3456;
  assign sum_3456 = {7'h0, and_3454} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:639
  logic and_3458;
  assign and_3458 = and_3430 & and_3454;
  logic [7:0] sum_3459;
  assign sum_3459 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3458};
  // hls/stages/patches.hpp:640
  logic and_3461;
  assign and_3461 = and_3440 & and_3454;
  logic [7:0] sum_3462;
  assign sum_3462 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3461};
  // hls/stages/patches.hpp:180
  logic and_3464;
  assign and_3464 = and_3381 & (patches_lower_s4_q & and_3387);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3466;
  assign sum_3466 = {7'h0, and_3464} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:639
  logic and_3468;
  assign and_3468 = and_3430 & and_3464;
  logic [7:0] sum_3469;
  assign sum_3469 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3468};
  // hls/stages/patches.hpp:640
  logic and_3471;
  assign and_3471 = and_3440 & and_3464;
  logic [7:0] sum_3472;
  assign sum_3472 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3471};
  // hls/stages/agreement.hpp:1164
  logic equal_3473;
  assign equal_3473 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1082
  logic less_3474;
  assign less_3474 = x_s4_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:773
  logic and_3478;
  assign and_3478 = equal_1469_s4_q & (x_s4_q[6] & (not_1882_s4_q & (equal_3473 & less_3474)));
  // hls/stages/agreement.hpp:1094
  logic and_3483;
  assign and_3483 = x_s4_q[6] & (not_1882_s4_q & (less_3474 & (x_s4_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:773
  logic and_3484;
  assign and_3484 = equal_1469_s4_q & and_3483;
  // hls/stages/patches.hpp:607
  logic [7:0] or_3486;
  assign or_3486 = (and_3478 ? patches_quarters_0_places_q : 8'h0) | (and_3484 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1094
  logic and_3490;
  assign and_3490 = x_s4_q[6] & (not_1882_s4_q & (less_3474 & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:773
  logic and_3491;
  assign and_3491 = equal_1469_s4_q & and_3490;
  // hls/stages/agreement.hpp:1094
  logic and_3497;
  assign and_3497 = x_s4_q[6] & (not_1882_s4_q & (less_3474 & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:773
  logic and_3498;
  assign and_3498 = equal_1469_s4_q & and_3497;
  // hls/stages/patches.hpp:607
  logic [7:0] or_3500;
  assign or_3500 = (or_3486 | (and_3491 ? patches_quarters_2_places_q : 8'h0)) | (and_3498 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:191
  logic select_3504;
  assign select_3504 = (x_s4_q[5:3] == 3'h2) ? x_s4_q[1] : (x_s4_q[0] & (x_s4_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:773
  logic and_3508;
  assign and_3508 = equal_1469_s4_q & (x_s4_q[6] & (not_1882_s4_q & (less_3474 & select_3504)));
  // hls/stages/patches.hpp:608
  logic [7:0] select_3510;
  assign select_3510 = and_3478 ? (and_3508 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3512;
  assign select_3512 = and_3484 ? (and_3508 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3515;
  assign select_3515 = and_3491 ? (and_3508 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3518;
  assign select_3518 = and_3498 ? (and_3508 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:609
  logic [7:0] select_3521;
  assign select_3521 = and_3478 ? (and_3508 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3523;
  assign select_3523 = and_3484 ? (and_3508 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3526;
  assign select_3526 = and_3491 ? (and_3508 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3529;
  assign select_3529 = and_3498 ? (and_3508 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:194
  logic [4:0] sum_3531;
  assign sum_3531 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1094
  logic and_3535;
  assign and_3535 = x_s4_q[6] & (not_1882_s4_q & (less_3474 & (sum_3531[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:773
  logic and_3536;
  assign and_3536 = equal_1469_s4_q & and_3535;
  // hls/stages/patches.hpp:604
  logic [7:0] select_3539;
  assign select_3539 = and_3536 ? (patches_word_places_q + (and_3484 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3542;
  assign select_3542 = and_3536 ? (patches_word_up_q + (and_3484 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3545;
  assign select_3545 = and_3536 ? (patches_word_down_q + (and_3484 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3549;
  assign select_3549 = ($signed(difference_3423[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3423[5:0];
  logic [5:0] select_3550;
  assign select_3550 = ($signed(14'h10) < $signed(difference_3423)) ? 6'h10 : select_3549;
  // hls/stages/patches.hpp:546
  logic [5:0] select_3552;
  assign select_3552 = equal_1848_s4_q ? (or_3376 ? 6'h0 : select_3550) : 6'h0;
  logic [5:0] select_3554;
  assign select_3554 = less_1845_s4_q ? (equal_1846_s4_q ? 6'h0 : select_3552) : select_3552;
  // hls/stages/patches.hpp:642
  logic [5:0] select_3556;
  assign select_3556 = and_3381 ? (equal_1682_s4_q ? select_3554 : 6'h0) : 6'h0;
  logic [11:0] sum_3557;
  assign sum_3557 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3556[5]}}, select_3556};
  // hls/stages/agreement.hpp:773
  logic and_3561;
  assign and_3561 = equal_1469_s4_q & (x_s4_q[6] & (not_1882_s4_q & (equal_2666 & less_3474)));
  // hls/stages/agreement.hpp:1094
  logic and_3565;
  assign and_3565 = x_s4_q[6] & (not_1882_s4_q & (less_3474 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:773
  logic and_3566;
  assign and_3566 = equal_1469_s4_q & and_3565;
  // hls/stages/patches.hpp:629
  logic [7:0] select_3568;
  assign select_3568 = and_3561 ? (and_3566 ? patches_sum_places_q : patches_places_q) : patches_places_q;
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
  assign select_3578 = and_3561 ? (and_3566 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/agreement.hpp:773
  logic and_3583;
  assign and_3583 = equal_1469_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3580_s4_q));
  // hls/stages/patches.hpp:180
  logic and_3585;
  assign and_3585 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:628
  logic [2:0] select_3587;
  assign select_3587 = and_3566 ? {and_3585, patches_found_q[2:1]} : (and_3561 ? {and_3585, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:627
  logic or_3591;
  assign or_3591 = patches_partly_q | (patches_doubted_q & (~and_3566));
  // hls/stages/patches.hpp:628
  logic select_3594;
  assign select_3594 = and_3561 ? (and_3566 ? or_3591 : (and_3561 ? or_3591 : patches_doubted_q)) : patches_doubted_q;
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
  assign and_3611 = patches_frame_ended_q & (~patches_age_q[9]);
  logic [9:0] sum_3612;
  assign sum_3612 = patches_age_q + {9'h0, and_3611};
  logic [9:0] select_3615;
  assign select_3615 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3612)) : sum_3612;
  // hls/stages/agreement.hpp:1136
  logic or_3672;
  assign or_3672 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1158
  logic equal_3674;
  assign equal_3674 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1167
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1168
  logic select_3680;
  assign select_3680 = (equal_3674 & equal_3473) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1087
  logic [10:0] sum_3683;
  assign sum_3683 = {1'b0, select_2464} + {2'h0, select_2464[9:1]};
  logic select_3686;
  assign select_3686 = (select_2461[9:3] == 7'h0) ? ((~or_3672) & (~select_3680)) : (~({sum_3683, select_2464[0]} < {2'h0, select_2461}));
  // hls/stages/agreement.hpp:1094
  logic [47:0] select_3688;
  assign select_3688 = x_s4_q[6] ? (equal_1514_s4_q ? good_q : {select_3686, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:773
  logic select_3692;
  assign select_3692 = equal_1469_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3580_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1158
  logic equal_3693;
  assign equal_3693 = x_s4_q[6:3] == 4'ha;
  logic equal_3695;
  assign equal_3695 = x_s4_q[6:3] == 4'h9;
  logic equal_3696;
  assign equal_3696 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1077
  logic [13:0] select_3698;
  assign select_3698 = equal_3695 ? counts_skin_unproven_q : (equal_3696 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3693 ? counts_nearer_q : select_3698;
  // hls/stages/agreement.hpp:1163
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1171
  logic select_3701;
  assign select_3701 = (equal_3693 & equal_3473) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1096
  logic not_3702;
  assign not_3702 = ~hidden_for_q[7];
  logic [7:0] select_3704;
  assign select_3704 = select_3701 ? (hidden_for_q + {7'h0, not_3702}) : 8'h0;
  // hls/stages/agreement.hpp:773
  logic [7:0] select_3706;
  assign select_3706 = equal_1469_s4_q ? (equal_3580_s4_q ? select_3704 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1171
  logic [13:0] select_3707;
  assign select_3707 = equal_3473 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1077
  logic [7:0] select_3709;
  assign select_3709 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3711;
  assign select_3711 = equal_3696 ? cfg_unproven_skin_limit_i : (equal_3674 ? cfg_unproven_limit_i : select_3709);
  logic [7:0] limit;
  assign limit = equal_3693 ? cfg_regions_limit_i : (equal_3695 ? cfg_hidden_limit_i : select_3711);
  // hls/stages/agreement.hpp:1171
  logic not_3714;
  assign not_3714 = ~x_s4_q[2];
  logic [3:0] select_3715;
  assign select_3715 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_3714, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_3714};
  logic [7:0] select_3716;
  assign select_3716 = x_s4_q[0] ? {select_3715[3], 1'b0, select_3715[2], 1'b0, select_3715[1], 1'b0, select_3715[0], 1'b0} : {1'b0, select_3715[3], 1'b0, select_3715[2], 1'b0, select_3715[1], 1'b0, select_3715[0]};
  // hls/stages/agreement.hpp:1077
  logic [13:0] select_3720;
  assign select_3720 = equal_3695 ? counts_skin_supervised_q : (equal_3696 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3693 ? counts_textured_q : select_3720;
  // hls/stages/agreement.hpp:1171
  logic [13:0] select_3722;
  assign select_3722 = ((limit & select_3716) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3707} + {1'b0, select_3722};
  // hls/stages/agreement.hpp:773
  logic select_3727;
  assign select_3727 = equal_1469_s4_q ? (equal_3473 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1169
  logic and_3732;
  assign and_3732 = too_much_q & (~(equal_3696 & equal_3473));
  // hls/stages/agreement.hpp:1170
  logic select_3737;
  assign select_3737 = (over[14] & equal_3473) ? (and_3732 | ((equal_3696 | equal_3695) | (x_s4_q[6:3] == 4'hf))) : and_3732;
  // hls/stages/agreement.hpp:1212
  logic select_3845;
  assign select_3845 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:266
  logic select_3847;
  assign select_3847 = left_first_s4_q ? done_s4_q : (and_1863_s4_q ? select_3845 : proven_q);
  // hls/stages/agreement.hpp:1245
  logic [1:0] select_3898;
  assign select_3898 = and_3897_s4_q ? {and_2013, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1246
  logic and_3899;
  assign and_3899 = select_3845 & less_3875;
  // hls/stages/agreement.hpp:425
  logic select_3902;
  assign select_3902 = and_1940_s4_q ? (less_1941_s4_q ? (select_3898[0] & and_3899) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:266
  logic select_3904;
  assign select_3904 = left_first_s4_q ? select_3902 : (and_1863_s4_q ? select_3902 : seen_q);
  logic select_3905;
  assign select_3905 = and_1863_s4_q ? select_3904 : seen_q;
  // hls/stages/agreement.hpp:425
  logic select_3908;
  assign select_3908 = and_1940_s4_q ? (less_1941_s4_q ? (select_3898[1] & and_3899) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:266
  logic select_3910;
  assign select_3910 = left_first_s4_q ? select_3908 : (and_1863_s4_q ? select_3908 : nearer_q);
  logic select_3911;
  assign select_3911 = and_1863_s4_q ? select_3910 : nearer_q;
  // hls/stages/agreement.hpp:1179
  logic or_3919;
  assign or_3919 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1181
  logic not_3927;
  assign not_3927 = ~(or_3672 | not_3912);
  // hls/stages/agreement.hpp:773
  logic and_3931;
  assign and_3931 = equal_1469_s4_q & (equal_3580_s4_q & (not_3927 & (select_3680 | select_3737)));
  logic and_3934;
  assign and_3934 = equal_3580_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1098
  logic or_3938;
  assign or_3938 = select_2266 | (select_2278 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:773
  logic and_3945;
  assign and_3945 = equal_1469_s4_q & (equal_3580_s4_q & (not_3927 & (select_2272 | select_2284)));
  // hls/stages/agreement.hpp:1098
  logic and_3950;
  assign and_3950 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3704 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:773
  logic and_3957;
  assign and_3957 = equal_1469_s4_q & (x_s4_q[6] & (not_1882_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1092
  logic [31:0] select_3965;
  assign select_3965 = equal_1536_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3963_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3966;
  assign select_3966 = equal_1534_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3965;
  logic [31:0] select_3967;
  assign select_3967 = equal_1532_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3966;
  logic [31:0] select_3968;
  assign select_3968 = equal_1530_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3967;
  logic [31:0] select_3969;
  assign select_3969 = equal_1528_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3968;
  logic [31:0] select_3970;
  assign select_3970 = equal_1526_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3969;
  logic [31:0] select_3971;
  assign select_3971 = equal_1524_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3970;
  logic [31:0] select_3972;
  assign select_3972 = equal_1522_s4_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3971;
  // hls/stages/agreement.hpp:1090
  logic [9:0] select_3973;
  assign select_3973 = less_2460 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1094
  logic [31:0] select_3974;
  assign select_3974 = equal_1514_s4_q ? select_3972 : {2'h0, select_3973, select_2464, select_2461};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_511_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_626, and_602_s4_q, and_601_s4_q, and_576_s4_q, less_568_s4_q, less_567_s4_q, less_566_s4_q, less_565_s4_q, less_564_s4_q, less_563_s4_q, less_562_s4_q, less_561_s4_q, less_560_s4_q, less_559_s4_q, less_558_s4_q, less_557_s4_q, less_556_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q};
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
  assign registration_sums_waddr = {sum_1520_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1579_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1578, sum_1574};
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
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_1608_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_1681_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1674_s4_q};
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
  assign patches_right_0_waddr = {select_1712_s4_q, select_1709};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_1721);
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
  assign patches_right_1_waddr = {select_1712_s4_q, select_1738};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_1741);
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
  assign patches_left_waddr = {select_1760, select_1759_s4_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_1766);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1870;
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
  assign regions_waddr = {region_row_s4_q, or_1880_s4_q, or_1877_s4_q, or_1874_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1908_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1907, sum_1901, sum_1896};
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
  assign map_waddr = sum_1949_s4_q;
  logic map_we;
  assign map_we = s4_en & and_2023_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2013, is_seen};
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
      patches_place_0_valid_q <= 1'b0;
      patches_place_0_column_q <= 7'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_valid_q <= 1'b0;
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
      patches_partly_q <= 1'b0;
      patches_clear_limit_q <= 7'h0;
      patches_complete_q <= 1'b0;
      patches_frame_ended_q <= 1'b0;
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
      census_left_misses_q <= select_2172;
      sharpness_before_last_mask_q <= select_2180;
      sharpness_sums_detail_0_q <= and_511_s4_q ? select_2194 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_511_s4_q ? select_2206 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_511_s4_q ? sum_2210 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_511_s4_q ? sum_2214 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2232 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2242 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2244 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2246 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2248 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2250 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2255;
      sharpness_comparing_carry_1_q <= select_2259;
      sharpness_comparing_less_detail_0_q <= select_2266;
      sharpness_comparing_less_detail_1_q <= select_2272;
      sharpness_comparing_less_contrast_0_q <= select_2278;
      sharpness_comparing_less_contrast_1_q <= select_2284;
      counts_supervised_q <= select_2418;
      counts_textured_q <= and_2412_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2421});
      counts_explained_q <= and_2412_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2426});
      counts_nearer_q <= and_2412_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2431});
      counts_unproven_q <= and_2412_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2457});
      counts_regions_bad_q <= select_2473;
      counts_skin_supervised_q <= select_2480;
      counts_skin_textured_q <= select_2487;
      counts_skin_unproven_q <= select_2495;
      registration_half_across_q <= select_2547;
      registration_half_measured_q <= select_2552;
      registration_half_votes_down_q <= and_2527_s4_q ? 7'h0 : sum_2558;
      registration_half_votes_up_q <= and_2527_s4_q ? 7'h0 : sum_2566;
      registration_half_half_votes_down_q <= and_2527_s4_q ? 7'h0 : sum_2573;
      registration_half_half_votes_up_q <= and_2527_s4_q ? 7'h0 : sum_2580;
      registration_down_q <= and_2614 ? sum_2633 : registration_down_q;
      registration_up_q <= and_2614 ? sum_2642 : registration_up_q;
      registration_enough_q <= select_2656;
      registration_votes_down_q <= and_2661 ? less_2662 : registration_votes_down_q;
      registration_votes_up_q <= and_2661 ? less_2664 : registration_votes_up_q;
      registration_other_enough_q <= and_2670 ? select_2656 : registration_other_enough_q;
      registration_other_down_q <= and_2670 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2670 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1469_s4_q & and_2677)) & or_2702;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_1700 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_1702 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_1703 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2786;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_1729 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_1731 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_1732 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2791;
      patches_valid_0_q <= select_2796;
      patches_valid_1_q <= select_2801;
      patches_right_next_0_q <= select_2804;
      patches_right_next_1_q <= select_2807;
      patches_left_next_0_q <= select_2810;
      patches_left_next_1_q <= select_2813;
      patches_sums_values_0_q <= select_3237;
      patches_sums_values_1_q <= equal_1682_s4_q ? patches_sums_values_1_q : select_3238;
      patches_sums_values_2_q <= equal_1682_s4_q ? patches_sums_values_2_q : select_3240;
      patches_sums_values_3_q <= equal_1682_s4_q ? patches_sums_values_3_q : select_3242;
      patches_sums_values_4_q <= equal_1682_s4_q ? patches_sums_values_4_q : select_3244;
      patches_sums_values_5_q <= equal_1682_s4_q ? patches_sums_values_5_q : select_3246;
      patches_sums_values_6_q <= equal_1682_s4_q ? patches_sums_values_6_q : select_3248;
      patches_sums_values_7_q <= equal_1682_s4_q ? patches_sums_values_7_q : select_3250;
      patches_sums_values_8_q <= equal_1682_s4_q ? patches_sums_values_8_q : select_3252;
      patches_sums_values_9_q <= equal_1682_s4_q ? patches_sums_values_9_q : select_3254;
      patches_sums_values_10_q <= equal_1682_s4_q ? patches_sums_values_10_q : select_3256;
      patches_sums_values_11_q <= equal_1682_s4_q ? patches_sums_values_11_q : select_3258;
      patches_sums_values_12_q <= equal_1682_s4_q ? patches_sums_values_12_q : select_3260;
      patches_sums_values_13_q <= equal_1682_s4_q ? patches_sums_values_13_q : select_3262;
      patches_sums_values_14_q <= equal_1682_s4_q ? patches_sums_values_14_q : select_3264;
      patches_sums_values_15_q <= equal_1682_s4_q ? patches_sums_values_15_q : select_3266;
      patches_sums_values_16_q <= equal_1682_s4_q ? patches_sums_values_16_q : select_3268;
      patches_best_differing_q <= select_1870[9:0];
      patches_best_column_q <= select_1870[14:10];
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
      patches_sum_places_q <= select_3539;
      patches_sum_up_q <= select_3542;
      patches_sum_down_q <= select_3545;
      patches_across_q <= sum_3557;
      patches_places_q <= select_3568;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3572;
      patches_partly_q <= or_3575;
      patches_clear_limit_q <= sum_3576[8:2];
      patches_complete_q <= select_3578;
      patches_frame_ended_q <= and_3583;
      patches_round_ends_q <= patches_complete_q & and_3583;
      patches_found_q <= and_3561 ? select_3587 : patches_found_q;
      patches_doubted_q <= select_3594;
      patches_doubted_before_q <= select_3595;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3605;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3615;
      segment_textured_q <= select_1893 + {5'h0, and_2421};
      segment_explained_q <= select_1898 + {5'h0, and_2426};
      segment_nearer_q <= select_1904 + {5'h0, and_2431};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1469_s4_q ? select_3688 : good_q;
      good_known_q <= select_3692;
      hidden_for_q <= select_3706;
      product_q <= equal_1469_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3727;
      disagree_q <= equal_1469_s4_q ? select_3680 : disagree_q;
      too_much_q <= equal_1469_s4_q ? select_3737 : too_much_q;
      hides_q <= equal_1469_s4_q ? select_3701 : hides_q;
      proven_q <= and_1863_s4_q ? select_3847 : proven_q;
      seen_q <= select_3905;
      nearer_q <= select_3911;
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
      averager_quarter_1_0_q <= select_2047;
      averager_quarter_1_1_q <= select_2049;
      averager_quarter_2_0_q <= select_2051;
      averager_quarter_2_1_q <= select_2053;
      averager_detail_0_q <= select_2065;
      averager_detail_1_q <= select_2073;
      census_changes_values_0_left_q <= and_511_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_511_s4_q ? sum_2156 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2158;
      census_changes_values_1_right_q <= select_2159;
      census_changes_values_2_left_q <= select_2160;
      census_changes_values_2_right_q <= select_2161;
      sharpness_last_mask_q <= and_511_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_511_s4_q ? select_2177[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_511_s4_q ? select_2177[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3849_s5_q;
  logic or_3913_s5_q;
  logic and_3914_s5_q;
  logic and_3922_s5_q;
  logic and_3925_s5_q;
  logic and_3931_s5_q;
  logic and_3935_s5_q;
  logic and_3941_s5_q;
  logic and_3945_s5_q;
  logic and_3953_s5_q;
  logic and_3957_s5_q;
  logic [5:0] select_3959_s5_q;
  logic [31:0] select_3976_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_3849_s5_q <= said_q;
      or_3913_s5_q <= not_3912 | select_3905;
      and_3914_s5_q <= cfg_prove_i & select_3911;
      and_3922_s5_q <= equal_1469_s4_q & (equal_3580_s4_q & (cfg_prove_i & or_3919));
      and_3925_s5_q <= equal_1469_s4_q & (equal_3580_s4_q & (cfg_prove_i & or_3672));
      and_3931_s5_q <= and_3931;
      and_3935_s5_q <= equal_1469_s4_q & and_3934;
      and_3941_s5_q <= equal_1469_s4_q & (equal_3580_s4_q & (not_3927 & or_3938));
      and_3945_s5_q <= and_3945;
      and_3953_s5_q <= equal_1469_s4_q & (equal_3580_s4_q & (cfg_prove_i & and_3950));
      and_3957_s5_q <= and_3957;
      select_3959_s5_q <= equal_1469_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3976_s5_q <= equal_1469_s4_q ? (x_s4_q[6] ? select_3974 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3913_s5_q;
  assign marks_nearer_o = and_3914_s5_q;
  assign verdict_valid_o = and_3849_s5_q;
  assign verdict_unproven_yet_o = and_3922_s5_q;
  assign verdict_untextured_o = and_3925_s5_q;
  assign verdict_disagree_o = and_3931_s5_q;
  assign verdict_moved_o = and_3935_s5_q;
  assign verdict_unsharp_left_o = and_3941_s5_q;
  assign verdict_unsharp_right_o = and_3945_s5_q;
  assign verdict_hidden_o = and_3953_s5_q;
  assign frame_valid_o = and_3957_s5_q;
  assign frame_index_o = select_3959_s5_q;
  assign frame_word_o = select_3976_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3576[1:0], sum_3531[1:0], product_3422[4:0], sum_2517[0], detail_4[1:0], detail_3[1:0], sum_2166[4:0], sum_1622[0], sum_1618[0], sum_624[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
