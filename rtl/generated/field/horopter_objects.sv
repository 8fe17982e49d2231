// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Objects<horopter::hls::profiles::field>, hls/stages/objects.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 593 bits, pipeline 196 bits, memories 5658 bits.
module horopter_objects (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic first_i,
  input  logic last_i,
  input  logic idle_i,
  input  logic [16:0] cfg_object_limit_i,
  output logic valid_o,
  output logic ended_o,
  output logic [16:0] object_pixels_o,
  output logic [8:0] object_left_o,
  output logic [8:0] object_right_o,
  output logic [8:0] object_top_o,
  output logic [8:0] object_bottom_o,
  output logic [25:0] object_columns_o,
  output logic [25:0] object_rows_o,
  output logic alarm_o,
  output logic overflow_o,
  output logic done_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q;
  logic s0_en, s1_en, s2_en, s3_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [8:0] raster_column_q;
  logic raster_rows_q;
  logic raster_row_ended_q;
  // hls/stages/objects.hpp:198
  logic or_259;
  assign or_259 = first_i | raster_row_ended_q;
  logic [8:0] x;
  assign x = or_259 ? 9'h0 : (raster_column_q + 9'h1);
  // hls/stages/objects.hpp:78
  logic not_262;
  assign not_262 = ~idle_i;
  // hls/stages/objects.hpp:198
  logic and_281;
  assign and_281 = raster_rows_q & (~first_i);

  // Memory above, 378 x 1, DISTANCE 16, hls/stages/objects.hpp:422; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic above_mem [0:377];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 378; i++) above_mem[i] = 1'b0;
`endif
  logic [8:0] above_raddr;
  assign above_raddr = x;
  logic above_re;
  assign above_re = s0_en & not_262;
  logic above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (above_re) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 9'h0;
      raster_rows_q <= 1'b0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= idle_i ? raster_column_q : x;
      raster_rows_q <= idle_i ? raster_rows_q : (last_i | and_281);
      raster_row_ended_q <= idle_i ? raster_row_ended_q : last_i;
    end
  end

  logic idle_s1_q;
  logic [8:0] x_s1_q;
  logic not_262_s1_q;
  logic equal_264_s1_q;
  logic and_265_s1_q;
  logic or_274_s1_q;
  logic and_281_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      idle_s1_q <= idle_i;
      x_s1_q <= x;
      not_262_s1_q <= not_262;
      equal_264_s1_q <= state_i == 2'h1;
      and_265_s1_q <= first_i & not_262;
      or_274_s1_q <= idle_i | or_259;
      and_281_s1_q <= and_281;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic before_v_q;
  logic over_before_q;
  logic ended_q;
  logic met_q;
  logic [8:0] row_q;
  logic [5:0] write_q;
  logic [5:0] read_q;
  logic [5:0] visible_q;
  logic [5:0] room_q;
  logic little_room_q;
  logic [1:0] phase_q;
  // hls/stages/objects.hpp:79
  logic not_266;
  assign not_266 = ~and_265_s1_q;
  // hls/stages/objects.hpp:251
  logic equal_267;
  assign equal_267 = phase_q == 2'h0;
  // hls/stages/objects.hpp:353
  logic equal_268;
  assign equal_268 = read_q == visible_q;
  logic not_269;
  assign not_269 = ~equal_268;
  // hls/stages/objects.hpp:210
  logic and_273;
  assign and_273 = ended_q & not_266;
  // hls/stages/objects.hpp:208
  logic not_275;
  assign not_275 = ~or_274_s1_q;
  // hls/stages/objects.hpp:210
  logic and_277;
  assign and_277 = before_v_q & not_266;
  logic select_278;
  assign select_278 = (and_273 | not_275) ? and_273 : and_277;
  logic and_279;
  assign and_279 = over_before_q & not_266;
  // hls/stages/objects.hpp:91
  logic and_283;
  assign and_283 = not_262_s1_q & (above_rdata_q & and_281_s1_q);
  // hls/stages/objects.hpp:208
  logic and_284;
  assign and_284 = and_283 & not_275;
  // hls/stages/objects.hpp:91
  logic and_286;
  assign and_286 = not_262_s1_q & equal_264_s1_q;
  logic and_289;
  assign and_289 = (and_279 | and_284) & (not_275 & (and_286 | and_277));
  // hls/stages/objects.hpp:215
  logic and_292;
  assign and_292 = (met_q & not_266) & (~select_278);
  // hls/stages/objects.hpp:216
  logic and_294;
  assign and_294 = and_289 & (~and_292);
  // hls/stages/objects.hpp:211
  logic and_296;
  assign and_296 = and_279 & (~and_284);
  // hls/stages/objects.hpp:217
  logic or_298;
  assign or_298 = and_296 | (select_278 | and_294);
  // hls/stages/objects.hpp:228
  logic [8:0] select_377;
  assign select_377 = (idle_s1_q | not_275) ? row_q : (and_265_s1_q ? 9'h0 : (row_q + 9'h1));
  // hls/stages/objects.hpp:225
  logic [5:0] select_388;
  assign select_388 = and_265_s1_q ? 6'h0 : (or_298 ? (little_room_q ? write_q : (write_q + 6'h1)) : write_q);
  // hls/stages/objects.hpp:90
  logic [5:0] select_392;
  assign select_392 = and_265_s1_q ? 6'h0 : (equal_267 ? (equal_268 ? read_q : (read_q + 6'h1)) : read_q);
  // hls/stages/objects.hpp:80
  logic [5:0] room;
  assign room = read_q - write_q;
  // hls/stages/objects.hpp:79
  logic little_room;
  assign little_room = not_266 & (({2'h0, room_q} + 8'hff) < 8'h7);
  // hls/stages/objects.hpp:306
  logic and_409;
  assign and_409 = (write_q == read_q) & ((~before_v_q) & ((~over_before_q) & (~ended_q)));

  // Memory queue, 64 x 30, DISTANCE 4, hls/stages/objects.hpp:429; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] queue_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) queue_mem[i] = 30'h0;
`endif
  logic [5:0] queue_raddr;
  assign queue_raddr = read_q;
  logic queue_re;
  assign queue_re = s1_en & (not_266 & (equal_267 & not_269));
  logic [29:0] queue_rdata_q;
  always_ff @(posedge clk_i) begin
    if (queue_re) queue_rdata_q <= queue_mem[queue_raddr];
  end

  // Memory above, write
  logic [8:0] above_waddr;
  assign above_waddr = x_s1_q;
  logic above_we;
  assign above_we = s1_en & not_262_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= equal_264_s1_q;
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && above_we) begin
      if (above_re && above_raddr == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
      if (above_waddr >= 9'd378) $error("above: write outside, address %0d", above_waddr);
    end
    if (rst_ni && above_re && above_raddr >= 9'd378) $error("above: read outside, address %0d", above_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_v_q <= 1'b0;
      over_before_q <= 1'b0;
      ended_q <= 1'b0;
      met_q <= 1'b0;
      row_q <= 9'h0;
      write_q <= 6'h0;
      read_q <= 6'h0;
      visible_q <= 6'h0;
      room_q <= 6'h0;
      little_room_q <= 1'b0;
      phase_q <= 2'h0;
    end else if (s1_en) begin
      before_v_q <= and_286;
      over_before_q <= and_283;
      ended_q <= not_275 & (and_277 & (~and_286));
      met_q <= (and_289 | and_292) & (~and_296);
      row_q <= select_377;
      write_q <= select_388;
      read_q <= select_392;
      visible_q <= and_265_s1_q ? 6'h0 : (equal_267 ? write_q : visible_q);
      room_q <= and_265_s1_q ? 6'h0 : room;
      little_room_q <= little_room;
      phase_q <= phase_q + 2'h1;
    end
  end

  logic idle_s2_q;
  logic [5:0] write_s2_q;
  logic [1:0] phase_s2_q;
  logic [8:0] x_s2_q;
  logic and_265_s2_q;
  logic not_266_s2_q;
  logic equal_267_s2_q;
  logic equal_268_s2_q;
  logic not_269_s2_q;
  logic select_278_s2_q;
  logic and_294_s2_q;
  logic and_296_s2_q;
  logic and_300_s2_q;
  logic or_379_s2_q;
  logic and_410_s2_q;
  logic and_1659_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      idle_s2_q <= idle_s1_q;
      write_s2_q <= write_q;
      phase_s2_q <= phase_q;
      x_s2_q <= x_s1_q;
      and_265_s2_q <= and_265_s1_q;
      not_266_s2_q <= not_266;
      equal_267_s2_q <= equal_267;
      equal_268_s2_q <= equal_268;
      not_269_s2_q <= not_269;
      select_278_s2_q <= select_278;
      and_294_s2_q <= and_294;
      and_296_s2_q <= and_296;
      and_300_s2_q <= or_298 & (~little_room_q);
      or_379_s2_q <= or_274_s1_q | (~and_277);
      and_410_s2_q <= (~(not_262_s1_q | not_269)) & and_409;
      and_1659_s2_q <= little_room_q & or_298;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [8:0] last_run_left_q;
  logic [8:0] last_run_right_q;
  logic [8:0] last_run_row_q;
  logic busy_q;
  logic draining_q;
  logic done_q;
  logic event_ends_q;
  logic event_meets_q;
  logic event_passes_q;
  logic [8:0] event_run_left_q;
  logic [8:0] event_run_right_q;
  logic [8:0] event_run_row_q;
  logic [4:0] entries_0_label_q;
  logic entries_0_there_q;
  logic [4:0] entries_1_label_q;
  logic entries_1_there_q;
  logic [4:0] entries_2_label_q;
  logic entries_2_there_q;
  logic [4:0] entries_3_label_q;
  logic entries_3_there_q;
  logic [4:0] entries_4_label_q;
  logic entries_4_there_q;
  logic [4:0] entries_5_label_q;
  logic entries_5_there_q;
  logic [4:0] entries_6_label_q;
  logic entries_6_there_q;
  logic [4:0] entries_7_label_q;
  logic entries_7_there_q;
  logic [4:0] entries_8_label_q;
  logic entries_8_there_q;
  logic [4:0] entries_9_label_q;
  logic entries_9_there_q;
  logic [4:0] entries_10_label_q;
  logic entries_10_there_q;
  logic [4:0] entries_11_label_q;
  logic entries_11_there_q;
  logic [4:0] entries_12_label_q;
  logic entries_12_there_q;
  logic [4:0] entries_13_label_q;
  logic entries_13_there_q;
  logic [4:0] entries_14_label_q;
  logic entries_14_there_q;
  logic [4:0] entries_15_label_q;
  logic entries_15_there_q;
  logic [4:0] entries_16_label_q;
  logic entries_16_there_q;
  logic [4:0] entries_17_label_q;
  logic entries_17_there_q;
  logic [4:0] entries_18_label_q;
  logic entries_18_there_q;
  logic [4:0] entries_19_label_q;
  logic entries_19_there_q;
  logic [4:0] entries_20_label_q;
  logic entries_20_there_q;
  logic [4:0] entries_21_label_q;
  logic entries_21_there_q;
  logic [4:0] entries_22_label_q;
  logic entries_22_there_q;
  logic [4:0] entries_23_label_q;
  logic entries_23_there_q;
  logic [4:0] entries_24_label_q;
  logic entries_24_there_q;
  logic [4:0] entries_25_label_q;
  logic entries_25_there_q;
  logic [4:0] entries_26_label_q;
  logic entries_26_there_q;
  logic [4:0] entries_27_label_q;
  logic entries_27_there_q;
  logic [4:0] entries_28_label_q;
  logic entries_28_there_q;
  logic [4:0] entries_29_label_q;
  logic entries_29_there_q;
  logic [4:0] entries_30_label_q;
  logic entries_30_there_q;
  logic [4:0] entries_31_label_q;
  logic entries_31_there_q;
  logic begin_0_q;
  logic begin_1_q;
  logic begin_2_q;
  logic begin_3_q;
  logic begin_4_q;
  logic begin_5_q;
  logic begin_6_q;
  logic begin_7_q;
  logic begin_8_q;
  logic begin_9_q;
  logic begin_10_q;
  logic begin_11_q;
  logic begin_12_q;
  logic begin_13_q;
  logic begin_14_q;
  logic begin_15_q;
  logic begin_16_q;
  logic begin_17_q;
  logic begin_18_q;
  logic begin_19_q;
  logic begin_20_q;
  logic begin_21_q;
  logic begin_22_q;
  logic begin_23_q;
  logic begin_24_q;
  logic begin_25_q;
  logic begin_26_q;
  logic begin_27_q;
  logic begin_28_q;
  logic begin_29_q;
  logic begin_30_q;
  logic begin_31_q;
  logic end_0_q;
  logic end_1_q;
  logic end_2_q;
  logic end_3_q;
  logic end_4_q;
  logic end_5_q;
  logic end_6_q;
  logic end_7_q;
  logic end_8_q;
  logic end_9_q;
  logic end_10_q;
  logic end_11_q;
  logic end_12_q;
  logic end_13_q;
  logic end_14_q;
  logic end_15_q;
  logic end_16_q;
  logic end_17_q;
  logic end_18_q;
  logic end_19_q;
  logic end_20_q;
  logic end_21_q;
  logic end_22_q;
  logic end_23_q;
  logic end_24_q;
  logic end_25_q;
  logic end_26_q;
  logic end_27_q;
  logic end_28_q;
  logic end_29_q;
  logic end_30_q;
  logic end_31_q;
  logic [4:0] run_label_q;
  logic run_there_q;
  logic used_0_q;
  logic used_1_q;
  logic used_2_q;
  logic used_3_q;
  logic used_4_q;
  logic used_5_q;
  logic used_6_q;
  logic used_7_q;
  logic used_8_q;
  logic used_9_q;
  logic used_10_q;
  logic used_11_q;
  logic used_12_q;
  logic used_13_q;
  logic used_14_q;
  logic used_15_q;
  logic used_16_q;
  logic used_17_q;
  logic used_18_q;
  logic used_19_q;
  logic used_20_q;
  logic used_21_q;
  logic used_22_q;
  logic used_23_q;
  logic used_24_q;
  logic used_25_q;
  logic used_26_q;
  logic used_27_q;
  logic used_28_q;
  logic used_29_q;
  logic used_30_q;
  logic used_31_q;
  logic [4:0] free_label_q;
  logic free_there_q;
  logic [4:0] found_label_q;
  logic found_there_q;
  logic group_0_q;
  logic group_1_q;
  logic group_2_q;
  logic group_3_q;
  logic group_4_q;
  logic group_5_q;
  logic group_6_q;
  logic group_7_q;
  logic [2:0] at_group_q;
  logic [3:0] looked_q;
  logic looked_there_q;
  logic [4:0] front_label_q;
  logic front_there_q;
  logic [4:0] label_q;
  logic fresh_q;
  logic same_0_q;
  logic same_1_q;
  logic same_2_q;
  logic same_3_q;
  logic same_4_q;
  logic same_5_q;
  logic same_6_q;
  logic same_7_q;
  logic same_8_q;
  logic same_9_q;
  logic same_10_q;
  logic same_11_q;
  logic same_12_q;
  logic same_13_q;
  logic same_14_q;
  logic same_15_q;
  logic same_16_q;
  logic same_17_q;
  logic same_18_q;
  logic same_19_q;
  logic same_20_q;
  logic same_21_q;
  logic same_22_q;
  logic same_23_q;
  logic same_24_q;
  logic same_25_q;
  logic same_26_q;
  logic same_27_q;
  logic same_28_q;
  logic same_29_q;
  logic same_30_q;
  logic same_31_q;
  logic others_q;
  logic joined_q;
  logic [4:0] other_q;
  logic second_q;
  logic second_ends_q;
  logic overflow_q;
  // hls/stages/objects.hpp:370
  logic equal_301;
  assign equal_301 = phase_s2_q == 2'h1;
  logic and_302;
  assign and_302 = second_q & equal_301;
  // hls/stages/objects.hpp:379
  logic not_303;
  assign not_303 = ~joined_q;
  logic [2:0] select_304;
  assign select_304 = and_302 ? 3'h6 : {not_303, {2{joined_q}}};
  logic select_306;
  assign select_306 = select_304[0] ? others_q : same_30_q;
  logic [4:0] select_307;
  assign select_307 = select_304[1] ? (select_304[0] ? {4'h0, second_ends_q} : other_q) : {4'h0, select_306};
  logic select_310;
  assign select_310 = select_304[1] ? (select_304[0] ? same_28_q : same_26_q) : (select_304[0] ? same_24_q : same_22_q);
  logic select_312;
  assign select_312 = select_304[0] ? same_4_q : same_2_q;
  logic [4:0] select_314;
  assign select_314 = select_304[1] ? {4'h0, select_312} : (select_304[0] ? {4'h0, same_0_q} : label_q);
  logic select_316;
  assign select_316 = select_304[0] ? group_7_q : group_5_q;
  logic [4:0] select_317;
  assign select_317 = select_304[1] ? (select_304[0] ? front_label_q : {1'b0, looked_q}) : {4'h0, select_316};
  logic [4:0] label;
  assign label = and_302 ? (select_304[2] ? select_307 : {4'h0, select_310}) : (select_304[2] ? select_314 : select_317);
  // hls/stages/objects.hpp:371
  logic and_321;
  assign and_321 = busy_q & (phase_s2_q == 2'h3);
  logic and_323;
  assign and_323 = and_321 & (event_ends_q | joined_q);
  // hls/stages/objects.hpp:378
  logic or_324;
  assign or_324 = and_302 | and_323;
  // hls/stages/objects.hpp:91
  logic [8:0] x_2;
  assign x_2 = idle_s2_q ? last_run_right_q : x_s2_q;
  // hls/stages/objects.hpp:233
  logic [8:0] select_382;
  assign select_382 = before_v_q ? (or_379_s2_q ? x_2 : last_run_left_q) : last_run_left_q;
  // hls/stages/objects.hpp:90
  logic and_413;
  assign and_413 = not_266_s2_q & (equal_267_s2_q ? (not_269_s2_q | and_410_s2_q) : busy_q);
  logic select_415;
  assign select_415 = and_265_s2_q ? draining_q : (equal_267_s2_q ? and_410_s2_q : draining_q);
  // hls/stages/objects.hpp:250
  logic and_417;
  assign and_417 = busy_q & (phase_s2_q == 2'h2);
  // hls/stages/objects.hpp:90
  logic and_421;
  assign and_421 = not_266_s2_q & (and_417 ? (draining_q & (~front_there_q)) : done_q);
  logic select_423;
  assign select_423 = equal_267_s2_q ? (queue_rdata_q[0] & not_269_s2_q) : event_ends_q;
  logic select_426;
  assign select_426 = equal_267_s2_q ? (queue_rdata_q[1] & not_269_s2_q) : event_meets_q;
  logic select_429;
  assign select_429 = equal_267_s2_q ? (queue_rdata_q[2] | equal_268_s2_q) : event_passes_q;
  logic [8:0] select_432;
  assign select_432 = equal_267_s2_q ? (equal_268_s2_q ? event_run_left_q : queue_rdata_q[11:3]) : event_run_left_q;
  logic [8:0] select_435;
  assign select_435 = equal_267_s2_q ? (equal_268_s2_q ? event_run_right_q : queue_rdata_q[20:12]) : event_run_right_q;
  logic [8:0] select_438;
  assign select_438 = equal_267_s2_q ? (equal_268_s2_q ? event_run_row_q : queue_rdata_q[29:21]) : event_run_row_q;
  // hls/stages/objects.hpp:250
  logic and_440;
  assign and_440 = busy_q & equal_301;
  // hls/stages/objects.hpp:254
  logic and_441;
  assign and_441 = event_ends_q & and_440;
  // hls/stages/objects.hpp:294
  logic and_442;
  assign and_442 = end_0_q & and_441;
  // hls/stages/objects.hpp:274
  logic and_443;
  assign and_443 = joined_q & and_321;
  // hls/stages/objects.hpp:255
  logic [4:0] ended;
  assign ended = run_there_q ? run_label_q : free_label_q;
  // hls/stages/objects.hpp:289
  logic [4:0] label_2;
  assign label_2 = and_441 ? ended : run_label_q;
  // hls/stages/objects.hpp:296
  logic [4:0] select_449;
  assign select_449 = (and_442 | (and_443 & (begin_0_q | same_0_q))) ? label_2 : entries_0_label_q;
  // hls/stages/objects.hpp:251
  logic and_450;
  assign and_450 = busy_q & equal_267_s2_q;
  // hls/stages/objects.hpp:280
  logic and_452;
  assign and_452 = front_there_q & (event_passes_q & and_450);
  // hls/stages/objects.hpp:296
  logic and_457;
  assign and_457 = not_266_s2_q & (and_442 | (entries_0_there_q & (~(begin_0_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_458;
  assign and_458 = end_1_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_462;
  assign select_462 = (and_458 | (and_443 & (begin_1_q | same_1_q))) ? label_2 : entries_1_label_q;
  logic and_467;
  assign and_467 = not_266_s2_q & (and_458 | (entries_1_there_q & (~(begin_1_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_468;
  assign and_468 = end_2_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_472;
  assign select_472 = (and_468 | (and_443 & (begin_2_q | same_2_q))) ? label_2 : entries_2_label_q;
  logic and_477;
  assign and_477 = not_266_s2_q & (and_468 | (entries_2_there_q & (~(begin_2_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_478;
  assign and_478 = end_3_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_482;
  assign select_482 = (and_478 | (and_443 & (begin_3_q | same_3_q))) ? label_2 : entries_3_label_q;
  logic and_487;
  assign and_487 = not_266_s2_q & (and_478 | (entries_3_there_q & (~(begin_3_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_488;
  assign and_488 = end_4_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_492;
  assign select_492 = (and_488 | (and_443 & (begin_4_q | same_4_q))) ? label_2 : entries_4_label_q;
  logic and_497;
  assign and_497 = not_266_s2_q & (and_488 | (entries_4_there_q & (~(begin_4_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_498;
  assign and_498 = end_5_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_502;
  assign select_502 = (and_498 | (and_443 & (begin_5_q | same_5_q))) ? label_2 : entries_5_label_q;
  logic and_507;
  assign and_507 = not_266_s2_q & (and_498 | (entries_5_there_q & (~(begin_5_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_508;
  assign and_508 = end_6_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_512;
  assign select_512 = (and_508 | (and_443 & (begin_6_q | same_6_q))) ? label_2 : entries_6_label_q;
  logic and_517;
  assign and_517 = not_266_s2_q & (and_508 | (entries_6_there_q & (~(begin_6_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_518;
  assign and_518 = end_7_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_522;
  assign select_522 = (and_518 | (and_443 & (begin_7_q | same_7_q))) ? label_2 : entries_7_label_q;
  logic and_527;
  assign and_527 = not_266_s2_q & (and_518 | (entries_7_there_q & (~(begin_7_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_528;
  assign and_528 = end_8_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_532;
  assign select_532 = (and_528 | (and_443 & (begin_8_q | same_8_q))) ? label_2 : entries_8_label_q;
  logic and_537;
  assign and_537 = not_266_s2_q & (and_528 | (entries_8_there_q & (~(begin_8_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_538;
  assign and_538 = end_9_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_542;
  assign select_542 = (and_538 | (and_443 & (begin_9_q | same_9_q))) ? label_2 : entries_9_label_q;
  logic and_547;
  assign and_547 = not_266_s2_q & (and_538 | (entries_9_there_q & (~(begin_9_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_548;
  assign and_548 = end_10_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_552;
  assign select_552 = (and_548 | (and_443 & (begin_10_q | same_10_q))) ? label_2 : entries_10_label_q;
  logic and_557;
  assign and_557 = not_266_s2_q & (and_548 | (entries_10_there_q & (~(begin_10_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_558;
  assign and_558 = end_11_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_562;
  assign select_562 = (and_558 | (and_443 & (begin_11_q | same_11_q))) ? label_2 : entries_11_label_q;
  logic and_567;
  assign and_567 = not_266_s2_q & (and_558 | (entries_11_there_q & (~(begin_11_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_568;
  assign and_568 = end_12_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_572;
  assign select_572 = (and_568 | (and_443 & (begin_12_q | same_12_q))) ? label_2 : entries_12_label_q;
  logic and_577;
  assign and_577 = not_266_s2_q & (and_568 | (entries_12_there_q & (~(begin_12_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_578;
  assign and_578 = end_13_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_582;
  assign select_582 = (and_578 | (and_443 & (begin_13_q | same_13_q))) ? label_2 : entries_13_label_q;
  logic and_587;
  assign and_587 = not_266_s2_q & (and_578 | (entries_13_there_q & (~(begin_13_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_588;
  assign and_588 = end_14_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_592;
  assign select_592 = (and_588 | (and_443 & (begin_14_q | same_14_q))) ? label_2 : entries_14_label_q;
  logic and_597;
  assign and_597 = not_266_s2_q & (and_588 | (entries_14_there_q & (~(begin_14_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_598;
  assign and_598 = end_15_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_602;
  assign select_602 = (and_598 | (and_443 & (begin_15_q | same_15_q))) ? label_2 : entries_15_label_q;
  logic and_607;
  assign and_607 = not_266_s2_q & (and_598 | (entries_15_there_q & (~(begin_15_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_608;
  assign and_608 = end_16_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_612;
  assign select_612 = (and_608 | (and_443 & (begin_16_q | same_16_q))) ? label_2 : entries_16_label_q;
  logic and_617;
  assign and_617 = not_266_s2_q & (and_608 | (entries_16_there_q & (~(begin_16_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_618;
  assign and_618 = end_17_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_622;
  assign select_622 = (and_618 | (and_443 & (begin_17_q | same_17_q))) ? label_2 : entries_17_label_q;
  logic and_627;
  assign and_627 = not_266_s2_q & (and_618 | (entries_17_there_q & (~(begin_17_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_628;
  assign and_628 = end_18_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_632;
  assign select_632 = (and_628 | (and_443 & (begin_18_q | same_18_q))) ? label_2 : entries_18_label_q;
  logic and_637;
  assign and_637 = not_266_s2_q & (and_628 | (entries_18_there_q & (~(begin_18_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_638;
  assign and_638 = end_19_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_642;
  assign select_642 = (and_638 | (and_443 & (begin_19_q | same_19_q))) ? label_2 : entries_19_label_q;
  logic and_647;
  assign and_647 = not_266_s2_q & (and_638 | (entries_19_there_q & (~(begin_19_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_648;
  assign and_648 = end_20_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_652;
  assign select_652 = (and_648 | (and_443 & (begin_20_q | same_20_q))) ? label_2 : entries_20_label_q;
  logic and_657;
  assign and_657 = not_266_s2_q & (and_648 | (entries_20_there_q & (~(begin_20_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_658;
  assign and_658 = end_21_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_662;
  assign select_662 = (and_658 | (and_443 & (begin_21_q | same_21_q))) ? label_2 : entries_21_label_q;
  logic and_667;
  assign and_667 = not_266_s2_q & (and_658 | (entries_21_there_q & (~(begin_21_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_668;
  assign and_668 = end_22_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_672;
  assign select_672 = (and_668 | (and_443 & (begin_22_q | same_22_q))) ? label_2 : entries_22_label_q;
  logic and_677;
  assign and_677 = not_266_s2_q & (and_668 | (entries_22_there_q & (~(begin_22_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_678;
  assign and_678 = end_23_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_682;
  assign select_682 = (and_678 | (and_443 & (begin_23_q | same_23_q))) ? label_2 : entries_23_label_q;
  logic and_687;
  assign and_687 = not_266_s2_q & (and_678 | (entries_23_there_q & (~(begin_23_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_688;
  assign and_688 = end_24_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_692;
  assign select_692 = (and_688 | (and_443 & (begin_24_q | same_24_q))) ? label_2 : entries_24_label_q;
  logic and_697;
  assign and_697 = not_266_s2_q & (and_688 | (entries_24_there_q & (~(begin_24_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_698;
  assign and_698 = end_25_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_702;
  assign select_702 = (and_698 | (and_443 & (begin_25_q | same_25_q))) ? label_2 : entries_25_label_q;
  logic and_707;
  assign and_707 = not_266_s2_q & (and_698 | (entries_25_there_q & (~(begin_25_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_708;
  assign and_708 = end_26_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_712;
  assign select_712 = (and_708 | (and_443 & (begin_26_q | same_26_q))) ? label_2 : entries_26_label_q;
  logic and_717;
  assign and_717 = not_266_s2_q & (and_708 | (entries_26_there_q & (~(begin_26_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_718;
  assign and_718 = end_27_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_722;
  assign select_722 = (and_718 | (and_443 & (begin_27_q | same_27_q))) ? label_2 : entries_27_label_q;
  logic and_727;
  assign and_727 = not_266_s2_q & (and_718 | (entries_27_there_q & (~(begin_27_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_728;
  assign and_728 = end_28_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_732;
  assign select_732 = (and_728 | (and_443 & (begin_28_q | same_28_q))) ? label_2 : entries_28_label_q;
  logic and_737;
  assign and_737 = not_266_s2_q & (and_728 | (entries_28_there_q & (~(begin_28_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_738;
  assign and_738 = end_29_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_742;
  assign select_742 = (and_738 | (and_443 & (begin_29_q | same_29_q))) ? label_2 : entries_29_label_q;
  logic and_747;
  assign and_747 = not_266_s2_q & (and_738 | (entries_29_there_q & (~(begin_29_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_748;
  assign and_748 = end_30_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_752;
  assign select_752 = (and_748 | (and_443 & (begin_30_q | same_30_q))) ? label_2 : entries_30_label_q;
  logic and_757;
  assign and_757 = not_266_s2_q & (and_748 | (entries_30_there_q & (~(begin_30_q & and_452))));
  // hls/stages/objects.hpp:294
  logic and_758;
  assign and_758 = end_31_q & and_441;
  // hls/stages/objects.hpp:296
  logic [4:0] select_762;
  assign select_762 = (and_758 | (and_443 & (begin_31_q | same_31_q))) ? label_2 : entries_31_label_q;
  logic and_767;
  assign and_767 = not_266_s2_q & (and_758 | (entries_31_there_q & (~(begin_31_q & and_452))));
  // hls/stages/objects.hpp:300
  logic or_768;
  assign or_768 = and_265_s2_q | and_452;
  // hls/stages/objects.hpp:301
  logic or_833;
  assign or_833 = and_265_s2_q | and_441;
  // hls/stages/objects.hpp:254
  logic not_898;
  assign not_898 = ~run_there_q;
  // hls/stages/objects.hpp:265
  logic and_900;
  assign and_900 = not_898 & (event_meets_q & and_417);
  // hls/stages/objects.hpp:272
  logic and_906;
  assign and_906 = not_266_s2_q & ((run_there_q & (~and_441)) | (front_there_q & and_900));
  // hls/stages/objects.hpp:281
  logic closes;
  assign closes = (not_303 & and_452) & (~others_q);
  logic frees;
  assign frees = closes | (joined_q & and_450);
  // hls/stages/objects.hpp:297
  logic not_914;
  assign not_914 = ~frees;
  // hls/stages/objects.hpp:318
  logic and_917;
  assign and_917 = looked_there_q & not_266_s2_q;
  // hls/stages/objects.hpp:316
  logic equal_918;
  assign equal_918 = looked_q == 4'hf;
  // hls/stages/objects.hpp:319
  logic and_920;
  assign and_920 = and_917 & (~equal_918);
  // hls/stages/objects.hpp:315
  logic not_921;
  assign not_921 = ~looked_q[0];
  // hls/stages/objects.hpp:298
  logic or_924;
  assign or_924 = (used_0_q & ((~(front_label_q == 5'h0)) | not_914)) | (and_920 & (group_0_q & not_921));
  // hls/stages/objects.hpp:315
  logic equal_930;
  assign equal_930 = looked_q[1:0] == 2'h1;
  // hls/stages/objects.hpp:298
  logic or_933;
  assign or_933 = (used_1_q & (not_914 | (~(front_label_q == 5'h1)))) | (and_920 & (group_0_q & equal_930));
  // hls/stages/objects.hpp:315
  logic equal_939;
  assign equal_939 = looked_q[2:0] == 3'h3;
  // hls/stages/objects.hpp:298
  logic or_942;
  assign or_942 = (used_2_q & (not_914 | (~(front_label_q == 5'h2)))) | (and_920 & (group_0_q & equal_939));
  // hls/stages/objects.hpp:315
  logic equal_948;
  assign equal_948 = looked_q == 4'h7;
  // hls/stages/objects.hpp:298
  logic or_951;
  assign or_951 = (used_3_q & (not_914 | (~(front_label_q == 5'h3)))) | (and_920 & (group_0_q & equal_948));
  logic or_959;
  assign or_959 = (used_4_q & (not_914 | (~(front_label_q == 5'h4)))) | (and_920 & (group_1_q & not_921));
  logic or_967;
  assign or_967 = (used_5_q & (not_914 | (~(front_label_q == 5'h5)))) | (and_920 & (group_1_q & equal_930));
  logic or_975;
  assign or_975 = (used_6_q & (not_914 | (~(front_label_q == 5'h6)))) | (and_920 & (group_1_q & equal_939));
  logic or_983;
  assign or_983 = (used_7_q & (not_914 | (~(front_label_q == 5'h7)))) | (and_920 & (group_1_q & equal_948));
  logic or_991;
  assign or_991 = (used_8_q & (not_914 | (~(front_label_q == 5'h8)))) | (and_920 & (group_2_q & not_921));
  logic or_999;
  assign or_999 = (used_9_q & (not_914 | (~(front_label_q == 5'h9)))) | (and_920 & (group_2_q & equal_930));
  logic or_1007;
  assign or_1007 = (used_10_q & (not_914 | (~(front_label_q == 5'ha)))) | (and_920 & (group_2_q & equal_939));
  logic or_1015;
  assign or_1015 = (used_11_q & (not_914 | (~(front_label_q == 5'hb)))) | (and_920 & (group_2_q & equal_948));
  logic or_1023;
  assign or_1023 = (used_12_q & (not_914 | (~(front_label_q == 5'hc)))) | (and_920 & (group_3_q & not_921));
  logic or_1031;
  assign or_1031 = (used_13_q & (not_914 | (~(front_label_q == 5'hd)))) | (and_920 & (group_3_q & equal_930));
  logic or_1039;
  assign or_1039 = (used_14_q & (not_914 | (~(front_label_q == 5'he)))) | (and_920 & (group_3_q & equal_939));
  logic or_1047;
  assign or_1047 = (used_15_q & (not_914 | (~(front_label_q == 5'hf)))) | (and_920 & (group_3_q & equal_948));
  logic or_1055;
  assign or_1055 = (used_16_q & (not_914 | (~(front_label_q == 5'h10)))) | (and_920 & (group_4_q & not_921));
  logic or_1063;
  assign or_1063 = (used_17_q & (not_914 | (~(front_label_q == 5'h11)))) | (and_920 & (group_4_q & equal_930));
  logic or_1071;
  assign or_1071 = (used_18_q & (not_914 | (~(front_label_q == 5'h12)))) | (and_920 & (group_4_q & equal_939));
  logic or_1079;
  assign or_1079 = (used_19_q & (not_914 | (~(front_label_q == 5'h13)))) | (and_920 & (group_4_q & equal_948));
  logic or_1087;
  assign or_1087 = (used_20_q & (not_914 | (~(front_label_q == 5'h14)))) | (and_920 & (group_5_q & not_921));
  logic or_1095;
  assign or_1095 = (used_21_q & (not_914 | (~(front_label_q == 5'h15)))) | (and_920 & (group_5_q & equal_930));
  logic or_1103;
  assign or_1103 = (used_22_q & (not_914 | (~(front_label_q == 5'h16)))) | (and_920 & (group_5_q & equal_939));
  logic or_1111;
  assign or_1111 = (used_23_q & (not_914 | (~(front_label_q == 5'h17)))) | (and_920 & (group_5_q & equal_948));
  logic or_1119;
  assign or_1119 = (used_24_q & (not_914 | (~(front_label_q == 5'h18)))) | (and_920 & (group_6_q & not_921));
  logic or_1127;
  assign or_1127 = (used_25_q & (not_914 | (~(front_label_q == 5'h19)))) | (and_920 & (group_6_q & equal_930));
  logic or_1135;
  assign or_1135 = (used_26_q & (not_914 | (~(front_label_q == 5'h1a)))) | (and_920 & (group_6_q & equal_939));
  logic or_1143;
  assign or_1143 = (used_27_q & (not_914 | (~(front_label_q == 5'h1b)))) | (and_920 & (group_6_q & equal_948));
  logic or_1151;
  assign or_1151 = (used_28_q & (not_914 | (~(front_label_q == 5'h1c)))) | (and_920 & (group_7_q & not_921));
  logic or_1159;
  assign or_1159 = (used_29_q & (not_914 | (~(front_label_q == 5'h1d)))) | (and_920 & (group_7_q & equal_930));
  logic or_1167;
  assign or_1167 = (used_30_q & (not_914 | (~(front_label_q == 5'h1e)))) | (and_920 & (group_7_q & equal_939));
  logic or_1175;
  assign or_1175 = (used_31_q & (not_914 | (~(front_label_q == 5'h1f)))) | (and_920 & (group_7_q & equal_948));
  // hls/stages/objects.hpp:254
  logic and_1177;
  assign and_1177 = and_441 & not_898;
  // hls/stages/objects.hpp:261
  logic not_1178;
  assign not_1178 = ~free_there_q;
  // hls/stages/objects.hpp:321
  logic and_1180;
  assign and_1180 = found_there_q & (and_1177 | not_1178);
  // hls/stages/objects.hpp:324
  logic or_1186;
  assign or_1186 = equal_930 | equal_948;
  logic or_1187;
  assign or_1187 = equal_939 | equal_948;
  // hls/stages/objects.hpp:343
  logic and_1192;
  assign and_1192 = equal_918 & and_917;
  // hls/stages/objects.hpp:336
  logic and_1211;
  assign and_1211 = used_0_q & group_0_q;
  logic and_1212;
  assign and_1212 = used_1_q & group_0_q;
  logic and_1213;
  assign and_1213 = used_2_q & group_0_q;
  logic and_1214;
  assign and_1214 = used_3_q & group_0_q;
  logic and_1215;
  assign and_1215 = used_4_q & group_1_q;
  logic and_1216;
  assign and_1216 = used_5_q & group_1_q;
  logic and_1217;
  assign and_1217 = used_6_q & group_1_q;
  logic and_1218;
  assign and_1218 = used_7_q & group_1_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used;
  assign used = {and_1214, and_1213, and_1212, and_1211} | {and_1218, and_1217, and_1216, and_1215};
  // hls/stages/objects.hpp:336
  logic and_1220;
  assign and_1220 = used_8_q & group_2_q;
  logic and_1221;
  assign and_1221 = used_9_q & group_2_q;
  logic and_1222;
  assign and_1222 = used_10_q & group_2_q;
  logic and_1223;
  assign and_1223 = used_11_q & group_2_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_2;
  assign used_2 = used | {and_1223, and_1222, and_1221, and_1220};
  // hls/stages/objects.hpp:336
  logic and_1225;
  assign and_1225 = used_12_q & group_3_q;
  logic and_1226;
  assign and_1226 = used_13_q & group_3_q;
  logic and_1227;
  assign and_1227 = used_14_q & group_3_q;
  logic and_1228;
  assign and_1228 = used_15_q & group_3_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_3;
  assign used_3 = used_2 | {and_1228, and_1227, and_1226, and_1225};
  // hls/stages/objects.hpp:336
  logic and_1230;
  assign and_1230 = used_16_q & group_4_q;
  logic and_1231;
  assign and_1231 = used_17_q & group_4_q;
  logic and_1232;
  assign and_1232 = used_18_q & group_4_q;
  logic and_1233;
  assign and_1233 = used_19_q & group_4_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_4;
  assign used_4 = used_3 | {and_1233, and_1232, and_1231, and_1230};
  // hls/stages/objects.hpp:336
  logic and_1235;
  assign and_1235 = used_20_q & group_5_q;
  logic and_1236;
  assign and_1236 = used_21_q & group_5_q;
  logic and_1237;
  assign and_1237 = used_22_q & group_5_q;
  logic and_1238;
  assign and_1238 = used_23_q & group_5_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_5;
  assign used_5 = used_4 | {and_1238, and_1237, and_1236, and_1235};
  // hls/stages/objects.hpp:336
  logic and_1240;
  assign and_1240 = used_24_q & group_6_q;
  logic and_1241;
  assign and_1241 = used_25_q & group_6_q;
  logic and_1242;
  assign and_1242 = used_26_q & group_6_q;
  logic and_1243;
  assign and_1243 = used_27_q & group_6_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_6;
  assign used_6 = used_5 | {and_1243, and_1242, and_1241, and_1240};
  // hls/stages/objects.hpp:336
  logic and_1245;
  assign and_1245 = used_28_q & group_7_q;
  logic and_1246;
  assign and_1246 = used_29_q & group_7_q;
  logic and_1247;
  assign and_1247 = used_30_q & group_7_q;
  logic and_1248;
  assign and_1248 = used_31_q & group_7_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_7;
  assign used_7 = used_6 | {and_1248, and_1247, and_1246, and_1245};
  // hls/stages/objects.hpp:341
  logic and_1254;
  assign and_1254 = not_266_s2_q & ((~looked_there_q) & (and_1180 | (~found_there_q)));
  // hls/stages/objects.hpp:166
  logic [4:0] or_1257;
  assign or_1257 = (begin_0_q ? entries_0_label_q : 5'h0) | (begin_1_q ? entries_1_label_q : 5'h0);
  logic [4:0] or_1260;
  assign or_1260 = (begin_2_q ? entries_2_label_q : 5'h0) | (begin_3_q ? entries_3_label_q : 5'h0);
  logic [4:0] or_1264;
  assign or_1264 = (begin_4_q ? entries_4_label_q : 5'h0) | (begin_5_q ? entries_5_label_q : 5'h0);
  logic [4:0] or_1267;
  assign or_1267 = (begin_6_q ? entries_6_label_q : 5'h0) | (begin_7_q ? entries_7_label_q : 5'h0);
  logic [4:0] or_1272;
  assign or_1272 = (begin_8_q ? entries_8_label_q : 5'h0) | (begin_9_q ? entries_9_label_q : 5'h0);
  logic [4:0] or_1275;
  assign or_1275 = (begin_10_q ? entries_10_label_q : 5'h0) | (begin_11_q ? entries_11_label_q : 5'h0);
  logic [4:0] or_1279;
  assign or_1279 = (begin_12_q ? entries_12_label_q : 5'h0) | (begin_13_q ? entries_13_label_q : 5'h0);
  logic [4:0] or_1282;
  assign or_1282 = (begin_14_q ? entries_14_label_q : 5'h0) | (begin_15_q ? entries_15_label_q : 5'h0);
  logic [4:0] or_1285;
  assign or_1285 = ((or_1257 | or_1260) | (or_1264 | or_1267)) | ((or_1272 | or_1275) | (or_1279 | or_1282));
  logic [4:0] or_1288;
  assign or_1288 = (begin_16_q ? entries_16_label_q : 5'h0) | (begin_17_q ? entries_17_label_q : 5'h0);
  logic [4:0] or_1291;
  assign or_1291 = (begin_18_q ? entries_18_label_q : 5'h0) | (begin_19_q ? entries_19_label_q : 5'h0);
  logic [4:0] or_1295;
  assign or_1295 = (begin_20_q ? entries_20_label_q : 5'h0) | (begin_21_q ? entries_21_label_q : 5'h0);
  logic [4:0] or_1298;
  assign or_1298 = (begin_22_q ? entries_22_label_q : 5'h0) | (begin_23_q ? entries_23_label_q : 5'h0);
  logic [4:0] or_1303;
  assign or_1303 = (begin_24_q ? entries_24_label_q : 5'h0) | (begin_25_q ? entries_25_label_q : 5'h0);
  logic [4:0] or_1306;
  assign or_1306 = (begin_26_q ? entries_26_label_q : 5'h0) | (begin_27_q ? entries_27_label_q : 5'h0);
  logic [4:0] or_1310;
  assign or_1310 = (begin_28_q ? entries_28_label_q : 5'h0) | (begin_29_q ? entries_29_label_q : 5'h0);
  logic [4:0] or_1313;
  assign or_1313 = (begin_30_q ? entries_30_label_q : 5'h0) | (begin_31_q ? entries_31_label_q : 5'h0);
  logic [4:0] or_1316;
  assign or_1316 = ((or_1288 | or_1291) | (or_1295 | or_1298)) | ((or_1303 | or_1306) | (or_1310 | or_1313));
  // hls/stages/objects.hpp:167
  logic or_1321;
  assign or_1321 = (entries_0_there_q & begin_0_q) | (entries_1_there_q & begin_1_q);
  logic or_1324;
  assign or_1324 = (entries_2_there_q & begin_2_q) | (entries_3_there_q & begin_3_q);
  logic or_1328;
  assign or_1328 = (entries_4_there_q & begin_4_q) | (entries_5_there_q & begin_5_q);
  logic or_1331;
  assign or_1331 = (entries_6_there_q & begin_6_q) | (entries_7_there_q & begin_7_q);
  logic or_1336;
  assign or_1336 = (entries_8_there_q & begin_8_q) | (entries_9_there_q & begin_9_q);
  logic or_1339;
  assign or_1339 = (entries_10_there_q & begin_10_q) | (entries_11_there_q & begin_11_q);
  logic or_1343;
  assign or_1343 = (entries_12_there_q & begin_12_q) | (entries_13_there_q & begin_13_q);
  logic or_1346;
  assign or_1346 = (entries_14_there_q & begin_14_q) | (entries_15_there_q & begin_15_q);
  logic or_1349;
  assign or_1349 = ((or_1321 | or_1324) | (or_1328 | or_1331)) | ((or_1336 | or_1339) | (or_1343 | or_1346));
  logic or_1352;
  assign or_1352 = (entries_16_there_q & begin_16_q) | (entries_17_there_q & begin_17_q);
  logic or_1355;
  assign or_1355 = (entries_18_there_q & begin_18_q) | (entries_19_there_q & begin_19_q);
  logic or_1359;
  assign or_1359 = (entries_20_there_q & begin_20_q) | (entries_21_there_q & begin_21_q);
  logic or_1362;
  assign or_1362 = (entries_22_there_q & begin_22_q) | (entries_23_there_q & begin_23_q);
  logic or_1367;
  assign or_1367 = (entries_24_there_q & begin_24_q) | (entries_25_there_q & begin_25_q);
  logic or_1370;
  assign or_1370 = (entries_26_there_q & begin_26_q) | (entries_27_there_q & begin_27_q);
  logic or_1374;
  assign or_1374 = (entries_28_there_q & begin_28_q) | (entries_29_there_q & begin_29_q);
  logic or_1377;
  assign or_1377 = (entries_30_there_q & begin_30_q) | (entries_31_there_q & begin_31_q);
  logic or_1380;
  assign or_1380 = ((or_1352 | or_1355) | (or_1359 | or_1362)) | ((or_1367 | or_1370) | (or_1374 | or_1377));
  // hls/stages/objects.hpp:173
  logic and_1387;
  assign and_1387 = (entries_0_there_q & front_there_q) & (entries_0_label_q == front_label_q);
  logic and_1393;
  assign and_1393 = (entries_1_there_q & front_there_q) & (entries_1_label_q == front_label_q);
  logic and_1399;
  assign and_1399 = (entries_2_there_q & front_there_q) & (entries_2_label_q == front_label_q);
  logic and_1405;
  assign and_1405 = (entries_3_there_q & front_there_q) & (entries_3_label_q == front_label_q);
  logic and_1411;
  assign and_1411 = (entries_4_there_q & front_there_q) & (entries_4_label_q == front_label_q);
  logic and_1417;
  assign and_1417 = (entries_5_there_q & front_there_q) & (entries_5_label_q == front_label_q);
  logic and_1423;
  assign and_1423 = (entries_6_there_q & front_there_q) & (entries_6_label_q == front_label_q);
  logic and_1429;
  assign and_1429 = (entries_7_there_q & front_there_q) & (entries_7_label_q == front_label_q);
  logic and_1435;
  assign and_1435 = (entries_8_there_q & front_there_q) & (entries_8_label_q == front_label_q);
  logic and_1441;
  assign and_1441 = (entries_9_there_q & front_there_q) & (entries_9_label_q == front_label_q);
  logic and_1447;
  assign and_1447 = (entries_10_there_q & front_there_q) & (entries_10_label_q == front_label_q);
  logic and_1453;
  assign and_1453 = (entries_11_there_q & front_there_q) & (entries_11_label_q == front_label_q);
  logic and_1459;
  assign and_1459 = (entries_12_there_q & front_there_q) & (entries_12_label_q == front_label_q);
  logic and_1465;
  assign and_1465 = (entries_13_there_q & front_there_q) & (entries_13_label_q == front_label_q);
  logic and_1471;
  assign and_1471 = (entries_14_there_q & front_there_q) & (entries_14_label_q == front_label_q);
  logic and_1477;
  assign and_1477 = (entries_15_there_q & front_there_q) & (entries_15_label_q == front_label_q);
  logic and_1483;
  assign and_1483 = (entries_16_there_q & front_there_q) & (entries_16_label_q == front_label_q);
  logic and_1489;
  assign and_1489 = (entries_17_there_q & front_there_q) & (entries_17_label_q == front_label_q);
  logic and_1495;
  assign and_1495 = (entries_18_there_q & front_there_q) & (entries_18_label_q == front_label_q);
  logic and_1501;
  assign and_1501 = (entries_19_there_q & front_there_q) & (entries_19_label_q == front_label_q);
  logic and_1507;
  assign and_1507 = (entries_20_there_q & front_there_q) & (entries_20_label_q == front_label_q);
  logic and_1513;
  assign and_1513 = (entries_21_there_q & front_there_q) & (entries_21_label_q == front_label_q);
  logic and_1519;
  assign and_1519 = (entries_22_there_q & front_there_q) & (entries_22_label_q == front_label_q);
  logic and_1525;
  assign and_1525 = (entries_23_there_q & front_there_q) & (entries_23_label_q == front_label_q);
  logic and_1531;
  assign and_1531 = (entries_24_there_q & front_there_q) & (entries_24_label_q == front_label_q);
  logic and_1537;
  assign and_1537 = (entries_25_there_q & front_there_q) & (entries_25_label_q == front_label_q);
  logic and_1543;
  assign and_1543 = (entries_26_there_q & front_there_q) & (entries_26_label_q == front_label_q);
  logic and_1549;
  assign and_1549 = (entries_27_there_q & front_there_q) & (entries_27_label_q == front_label_q);
  logic and_1555;
  assign and_1555 = (entries_28_there_q & front_there_q) & (entries_28_label_q == front_label_q);
  logic and_1561;
  assign and_1561 = (entries_29_there_q & front_there_q) & (entries_29_label_q == front_label_q);
  logic and_1567;
  assign and_1567 = (entries_30_there_q & front_there_q) & (entries_30_label_q == front_label_q);
  logic and_1573;
  assign and_1573 = (entries_31_there_q & front_there_q) & (entries_31_label_q == front_label_q);
  // hls/stages/objects.hpp:276
  logic equal_1577;
  assign equal_1577 = {same_31_q, same_30_q, same_29_q, same_28_q, same_27_q, same_26_q, same_25_q, same_24_q, same_23_q, same_22_q, same_21_q, same_20_q, same_19_q, same_18_q, same_17_q, same_16_q, same_15_q, same_14_q, same_13_q, same_12_q, same_11_q, same_10_q, same_9_q, same_8_q, same_7_q, same_6_q, same_5_q, same_4_q, same_3_q, same_2_q, same_1_q, same_0_q} == 32'h0;
  // hls/stages/objects.hpp:267
  logic equal_1579;
  assign equal_1579 = run_label_q == front_label_q;
  // hls/stages/objects.hpp:280
  logic select_1583;
  assign select_1583 = and_321 ? ((~equal_1577) | (equal_1579 & (run_there_q & front_there_q))) : others_q;
  // hls/stages/objects.hpp:271
  logic select_1588;
  assign select_1588 = and_417 ? ((front_there_q & (event_meets_q & run_there_q)) & (~equal_1579)) : joined_q;
  // hls/stages/objects.hpp:167
  logic or_1599;
  assign or_1599 = ((entries_0_there_q & end_0_q) | (entries_1_there_q & end_1_q)) | ((entries_2_there_q & end_2_q) | (entries_3_there_q & end_3_q));
  logic or_1606;
  assign or_1606 = ((entries_4_there_q & end_4_q) | (entries_5_there_q & end_5_q)) | ((entries_6_there_q & end_6_q) | (entries_7_there_q & end_7_q));
  logic or_1613;
  assign or_1613 = (entries_10_there_q & end_10_q) | (entries_11_there_q & end_11_q);
  logic or_1614;
  assign or_1614 = ((entries_8_there_q & end_8_q) | (entries_9_there_q & end_9_q)) | or_1613;
  logic or_1617;
  assign or_1617 = (entries_12_there_q & end_12_q) | (entries_13_there_q & end_13_q);
  logic or_1620;
  assign or_1620 = (entries_14_there_q & end_14_q) | (entries_15_there_q & end_15_q);
  logic or_1626;
  assign or_1626 = (entries_16_there_q & end_16_q) | (entries_17_there_q & end_17_q);
  logic or_1629;
  assign or_1629 = (entries_18_there_q & end_18_q) | (entries_19_there_q & end_19_q);
  logic or_1633;
  assign or_1633 = (entries_20_there_q & end_20_q) | (entries_21_there_q & end_21_q);
  logic or_1636;
  assign or_1636 = (entries_22_there_q & end_22_q) | (entries_23_there_q & end_23_q);
  logic or_1641;
  assign or_1641 = (entries_24_there_q & end_24_q) | (entries_25_there_q & end_25_q);
  logic or_1644;
  assign or_1644 = (entries_26_there_q & end_26_q) | (entries_27_there_q & end_27_q);
  logic or_1648;
  assign or_1648 = (entries_28_there_q & end_28_q) | (entries_29_there_q & end_29_q);
  logic or_1651;
  assign or_1651 = (entries_30_there_q & end_30_q) | (entries_31_there_q & end_31_q);
  logic or_1654;
  assign or_1654 = ((or_1626 | or_1629) | (or_1633 | or_1636)) | ((or_1641 | or_1644) | (or_1648 | or_1651));
  logic or_1655;
  assign or_1655 = ((or_1599 | or_1606) | (or_1614 | (or_1617 | or_1620))) | or_1654;
  // hls/stages/objects.hpp:95
  logic or_1664;
  assign or_1664 = ((and_441 & (or_1655 | (not_898 & not_1178))) | and_1659_s2_q) | (~(and_265_s2_q | (~overflow_q)));

  // Memory objects, 32 x 105, DISTANCE 2, hls/stages/objects.hpp:457; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [104:0] objects_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) objects_mem[i] = 105'h0;
`endif
  logic [4:0] objects_raddr;
  assign objects_raddr = label;
  logic objects_re;
  assign objects_re = s2_en & or_324;
  logic [104:0] objects_rdata_q;
  always_ff @(posedge clk_i) begin
    if (objects_re) objects_rdata_q <= objects_mem[objects_raddr];
  end

  // Memory queue, write
  logic [5:0] queue_waddr;
  assign queue_waddr = write_s2_q;
  logic queue_we;
  assign queue_we = s2_en & and_300_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (queue_we) queue_mem[queue_waddr] <= {last_run_row_q, last_run_right_q, last_run_left_q, and_296_s2_q, and_294_s2_q, select_278_s2_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && queue_we) begin
      if (queue_re && queue_raddr == queue_waddr) begin
        $error("queue: address %0d is read less than DISTANCE steps after its write", queue_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      last_run_left_q <= 9'h0;
      last_run_right_q <= 9'h0;
      last_run_row_q <= 9'h0;
      busy_q <= 1'b0;
      draining_q <= 1'b0;
      done_q <= 1'b0;
      event_ends_q <= 1'b0;
      event_meets_q <= 1'b0;
      event_passes_q <= 1'b0;
      event_run_left_q <= 9'h0;
      event_run_right_q <= 9'h0;
      event_run_row_q <= 9'h0;
      entries_0_label_q <= 5'h0;
      entries_0_there_q <= 1'b0;
      entries_1_label_q <= 5'h0;
      entries_1_there_q <= 1'b0;
      entries_2_label_q <= 5'h0;
      entries_2_there_q <= 1'b0;
      entries_3_label_q <= 5'h0;
      entries_3_there_q <= 1'b0;
      entries_4_label_q <= 5'h0;
      entries_4_there_q <= 1'b0;
      entries_5_label_q <= 5'h0;
      entries_5_there_q <= 1'b0;
      entries_6_label_q <= 5'h0;
      entries_6_there_q <= 1'b0;
      entries_7_label_q <= 5'h0;
      entries_7_there_q <= 1'b0;
      entries_8_label_q <= 5'h0;
      entries_8_there_q <= 1'b0;
      entries_9_label_q <= 5'h0;
      entries_9_there_q <= 1'b0;
      entries_10_label_q <= 5'h0;
      entries_10_there_q <= 1'b0;
      entries_11_label_q <= 5'h0;
      entries_11_there_q <= 1'b0;
      entries_12_label_q <= 5'h0;
      entries_12_there_q <= 1'b0;
      entries_13_label_q <= 5'h0;
      entries_13_there_q <= 1'b0;
      entries_14_label_q <= 5'h0;
      entries_14_there_q <= 1'b0;
      entries_15_label_q <= 5'h0;
      entries_15_there_q <= 1'b0;
      entries_16_label_q <= 5'h0;
      entries_16_there_q <= 1'b0;
      entries_17_label_q <= 5'h0;
      entries_17_there_q <= 1'b0;
      entries_18_label_q <= 5'h0;
      entries_18_there_q <= 1'b0;
      entries_19_label_q <= 5'h0;
      entries_19_there_q <= 1'b0;
      entries_20_label_q <= 5'h0;
      entries_20_there_q <= 1'b0;
      entries_21_label_q <= 5'h0;
      entries_21_there_q <= 1'b0;
      entries_22_label_q <= 5'h0;
      entries_22_there_q <= 1'b0;
      entries_23_label_q <= 5'h0;
      entries_23_there_q <= 1'b0;
      entries_24_label_q <= 5'h0;
      entries_24_there_q <= 1'b0;
      entries_25_label_q <= 5'h0;
      entries_25_there_q <= 1'b0;
      entries_26_label_q <= 5'h0;
      entries_26_there_q <= 1'b0;
      entries_27_label_q <= 5'h0;
      entries_27_there_q <= 1'b0;
      entries_28_label_q <= 5'h0;
      entries_28_there_q <= 1'b0;
      entries_29_label_q <= 5'h0;
      entries_29_there_q <= 1'b0;
      entries_30_label_q <= 5'h0;
      entries_30_there_q <= 1'b0;
      entries_31_label_q <= 5'h0;
      entries_31_there_q <= 1'b0;
      begin_0_q <= 1'b1;
      begin_1_q <= 1'b0;
      begin_2_q <= 1'b0;
      begin_3_q <= 1'b0;
      begin_4_q <= 1'b0;
      begin_5_q <= 1'b0;
      begin_6_q <= 1'b0;
      begin_7_q <= 1'b0;
      begin_8_q <= 1'b0;
      begin_9_q <= 1'b0;
      begin_10_q <= 1'b0;
      begin_11_q <= 1'b0;
      begin_12_q <= 1'b0;
      begin_13_q <= 1'b0;
      begin_14_q <= 1'b0;
      begin_15_q <= 1'b0;
      begin_16_q <= 1'b0;
      begin_17_q <= 1'b0;
      begin_18_q <= 1'b0;
      begin_19_q <= 1'b0;
      begin_20_q <= 1'b0;
      begin_21_q <= 1'b0;
      begin_22_q <= 1'b0;
      begin_23_q <= 1'b0;
      begin_24_q <= 1'b0;
      begin_25_q <= 1'b0;
      begin_26_q <= 1'b0;
      begin_27_q <= 1'b0;
      begin_28_q <= 1'b0;
      begin_29_q <= 1'b0;
      begin_30_q <= 1'b0;
      begin_31_q <= 1'b0;
      end_0_q <= 1'b1;
      end_1_q <= 1'b0;
      end_2_q <= 1'b0;
      end_3_q <= 1'b0;
      end_4_q <= 1'b0;
      end_5_q <= 1'b0;
      end_6_q <= 1'b0;
      end_7_q <= 1'b0;
      end_8_q <= 1'b0;
      end_9_q <= 1'b0;
      end_10_q <= 1'b0;
      end_11_q <= 1'b0;
      end_12_q <= 1'b0;
      end_13_q <= 1'b0;
      end_14_q <= 1'b0;
      end_15_q <= 1'b0;
      end_16_q <= 1'b0;
      end_17_q <= 1'b0;
      end_18_q <= 1'b0;
      end_19_q <= 1'b0;
      end_20_q <= 1'b0;
      end_21_q <= 1'b0;
      end_22_q <= 1'b0;
      end_23_q <= 1'b0;
      end_24_q <= 1'b0;
      end_25_q <= 1'b0;
      end_26_q <= 1'b0;
      end_27_q <= 1'b0;
      end_28_q <= 1'b0;
      end_29_q <= 1'b0;
      end_30_q <= 1'b0;
      end_31_q <= 1'b0;
      run_label_q <= 5'h0;
      run_there_q <= 1'b0;
      used_0_q <= 1'b0;
      used_1_q <= 1'b0;
      used_2_q <= 1'b0;
      used_3_q <= 1'b0;
      used_4_q <= 1'b0;
      used_5_q <= 1'b0;
      used_6_q <= 1'b0;
      used_7_q <= 1'b0;
      used_8_q <= 1'b0;
      used_9_q <= 1'b0;
      used_10_q <= 1'b0;
      used_11_q <= 1'b0;
      used_12_q <= 1'b0;
      used_13_q <= 1'b0;
      used_14_q <= 1'b0;
      used_15_q <= 1'b0;
      used_16_q <= 1'b0;
      used_17_q <= 1'b0;
      used_18_q <= 1'b0;
      used_19_q <= 1'b0;
      used_20_q <= 1'b0;
      used_21_q <= 1'b0;
      used_22_q <= 1'b0;
      used_23_q <= 1'b0;
      used_24_q <= 1'b0;
      used_25_q <= 1'b0;
      used_26_q <= 1'b0;
      used_27_q <= 1'b0;
      used_28_q <= 1'b0;
      used_29_q <= 1'b0;
      used_30_q <= 1'b0;
      used_31_q <= 1'b0;
      free_label_q <= 5'h0;
      free_there_q <= 1'b0;
      found_label_q <= 5'h0;
      found_there_q <= 1'b0;
      group_0_q <= 1'b1;
      group_1_q <= 1'b0;
      group_2_q <= 1'b0;
      group_3_q <= 1'b0;
      group_4_q <= 1'b0;
      group_5_q <= 1'b0;
      group_6_q <= 1'b0;
      group_7_q <= 1'b0;
      at_group_q <= 3'h0;
      looked_q <= 4'h0;
      looked_there_q <= 1'b0;
      front_label_q <= 5'h0;
      front_there_q <= 1'b0;
      label_q <= 5'h0;
      fresh_q <= 1'b0;
      same_0_q <= 1'b0;
      same_1_q <= 1'b0;
      same_2_q <= 1'b0;
      same_3_q <= 1'b0;
      same_4_q <= 1'b0;
      same_5_q <= 1'b0;
      same_6_q <= 1'b0;
      same_7_q <= 1'b0;
      same_8_q <= 1'b0;
      same_9_q <= 1'b0;
      same_10_q <= 1'b0;
      same_11_q <= 1'b0;
      same_12_q <= 1'b0;
      same_13_q <= 1'b0;
      same_14_q <= 1'b0;
      same_15_q <= 1'b0;
      same_16_q <= 1'b0;
      same_17_q <= 1'b0;
      same_18_q <= 1'b0;
      same_19_q <= 1'b0;
      same_20_q <= 1'b0;
      same_21_q <= 1'b0;
      same_22_q <= 1'b0;
      same_23_q <= 1'b0;
      same_24_q <= 1'b0;
      same_25_q <= 1'b0;
      same_26_q <= 1'b0;
      same_27_q <= 1'b0;
      same_28_q <= 1'b0;
      same_29_q <= 1'b0;
      same_30_q <= 1'b0;
      same_31_q <= 1'b0;
      others_q <= 1'b0;
      joined_q <= 1'b0;
      other_q <= 5'h0;
      second_q <= 1'b0;
      second_ends_q <= 1'b0;
      overflow_q <= 1'b0;
    end else if (s2_en) begin
      last_run_left_q <= select_382;
      last_run_right_q <= before_v_q ? x_2 : last_run_right_q;
      last_run_row_q <= before_v_q ? row_q : last_run_row_q;
      busy_q <= and_413;
      draining_q <= select_415;
      done_q <= and_421;
      event_ends_q <= and_265_s2_q ? event_ends_q : select_423;
      event_meets_q <= and_265_s2_q ? event_meets_q : select_426;
      event_passes_q <= and_265_s2_q ? event_passes_q : select_429;
      event_run_left_q <= and_265_s2_q ? event_run_left_q : select_432;
      event_run_right_q <= and_265_s2_q ? event_run_right_q : select_435;
      event_run_row_q <= and_265_s2_q ? event_run_row_q : select_438;
      entries_0_label_q <= select_449;
      entries_0_there_q <= and_457;
      entries_1_label_q <= select_462;
      entries_1_there_q <= and_467;
      entries_2_label_q <= select_472;
      entries_2_there_q <= and_477;
      entries_3_label_q <= select_482;
      entries_3_there_q <= and_487;
      entries_4_label_q <= select_492;
      entries_4_there_q <= and_497;
      entries_5_label_q <= select_502;
      entries_5_there_q <= and_507;
      entries_6_label_q <= select_512;
      entries_6_there_q <= and_517;
      entries_7_label_q <= select_522;
      entries_7_there_q <= and_527;
      entries_8_label_q <= select_532;
      entries_8_there_q <= and_537;
      entries_9_label_q <= select_542;
      entries_9_there_q <= and_547;
      entries_10_label_q <= select_552;
      entries_10_there_q <= and_557;
      entries_11_label_q <= select_562;
      entries_11_there_q <= and_567;
      entries_12_label_q <= select_572;
      entries_12_there_q <= and_577;
      entries_13_label_q <= select_582;
      entries_13_there_q <= and_587;
      entries_14_label_q <= select_592;
      entries_14_there_q <= and_597;
      entries_15_label_q <= select_602;
      entries_15_there_q <= and_607;
      entries_16_label_q <= select_612;
      entries_16_there_q <= and_617;
      entries_17_label_q <= select_622;
      entries_17_there_q <= and_627;
      entries_18_label_q <= select_632;
      entries_18_there_q <= and_637;
      entries_19_label_q <= select_642;
      entries_19_there_q <= and_647;
      entries_20_label_q <= select_652;
      entries_20_there_q <= and_657;
      entries_21_label_q <= select_662;
      entries_21_there_q <= and_667;
      entries_22_label_q <= select_672;
      entries_22_there_q <= and_677;
      entries_23_label_q <= select_682;
      entries_23_there_q <= and_687;
      entries_24_label_q <= select_692;
      entries_24_there_q <= and_697;
      entries_25_label_q <= select_702;
      entries_25_there_q <= and_707;
      entries_26_label_q <= select_712;
      entries_26_there_q <= and_717;
      entries_27_label_q <= select_722;
      entries_27_there_q <= and_727;
      entries_28_label_q <= select_732;
      entries_28_there_q <= and_737;
      entries_29_label_q <= select_742;
      entries_29_there_q <= and_747;
      entries_30_label_q <= select_752;
      entries_30_there_q <= and_757;
      entries_31_label_q <= select_762;
      entries_31_there_q <= and_767;
      begin_0_q <= or_768 ? (begin_31_q | and_265_s2_q) : begin_0_q;
      begin_1_q <= or_768 ? (begin_0_q & not_266_s2_q) : begin_1_q;
      begin_2_q <= or_768 ? (begin_1_q & not_266_s2_q) : begin_2_q;
      begin_3_q <= or_768 ? (begin_2_q & not_266_s2_q) : begin_3_q;
      begin_4_q <= or_768 ? (begin_3_q & not_266_s2_q) : begin_4_q;
      begin_5_q <= or_768 ? (begin_4_q & not_266_s2_q) : begin_5_q;
      begin_6_q <= or_768 ? (begin_5_q & not_266_s2_q) : begin_6_q;
      begin_7_q <= or_768 ? (begin_6_q & not_266_s2_q) : begin_7_q;
      begin_8_q <= or_768 ? (begin_7_q & not_266_s2_q) : begin_8_q;
      begin_9_q <= or_768 ? (begin_8_q & not_266_s2_q) : begin_9_q;
      begin_10_q <= or_768 ? (begin_9_q & not_266_s2_q) : begin_10_q;
      begin_11_q <= or_768 ? (begin_10_q & not_266_s2_q) : begin_11_q;
      begin_12_q <= or_768 ? (begin_11_q & not_266_s2_q) : begin_12_q;
      begin_13_q <= or_768 ? (begin_12_q & not_266_s2_q) : begin_13_q;
      begin_14_q <= or_768 ? (begin_13_q & not_266_s2_q) : begin_14_q;
      begin_15_q <= or_768 ? (begin_14_q & not_266_s2_q) : begin_15_q;
      begin_16_q <= or_768 ? (begin_15_q & not_266_s2_q) : begin_16_q;
      begin_17_q <= or_768 ? (begin_16_q & not_266_s2_q) : begin_17_q;
      begin_18_q <= or_768 ? (begin_17_q & not_266_s2_q) : begin_18_q;
      begin_19_q <= or_768 ? (begin_18_q & not_266_s2_q) : begin_19_q;
      begin_20_q <= or_768 ? (begin_19_q & not_266_s2_q) : begin_20_q;
      begin_21_q <= or_768 ? (begin_20_q & not_266_s2_q) : begin_21_q;
      begin_22_q <= or_768 ? (begin_21_q & not_266_s2_q) : begin_22_q;
      begin_23_q <= or_768 ? (begin_22_q & not_266_s2_q) : begin_23_q;
      begin_24_q <= or_768 ? (begin_23_q & not_266_s2_q) : begin_24_q;
      begin_25_q <= or_768 ? (begin_24_q & not_266_s2_q) : begin_25_q;
      begin_26_q <= or_768 ? (begin_25_q & not_266_s2_q) : begin_26_q;
      begin_27_q <= or_768 ? (begin_26_q & not_266_s2_q) : begin_27_q;
      begin_28_q <= or_768 ? (begin_27_q & not_266_s2_q) : begin_28_q;
      begin_29_q <= or_768 ? (begin_28_q & not_266_s2_q) : begin_29_q;
      begin_30_q <= or_768 ? (begin_29_q & not_266_s2_q) : begin_30_q;
      begin_31_q <= or_768 ? (begin_30_q & not_266_s2_q) : begin_31_q;
      end_0_q <= or_833 ? (end_31_q | and_265_s2_q) : end_0_q;
      end_1_q <= or_833 ? (end_0_q & not_266_s2_q) : end_1_q;
      end_2_q <= or_833 ? (end_1_q & not_266_s2_q) : end_2_q;
      end_3_q <= or_833 ? (end_2_q & not_266_s2_q) : end_3_q;
      end_4_q <= or_833 ? (end_3_q & not_266_s2_q) : end_4_q;
      end_5_q <= or_833 ? (end_4_q & not_266_s2_q) : end_5_q;
      end_6_q <= or_833 ? (end_5_q & not_266_s2_q) : end_6_q;
      end_7_q <= or_833 ? (end_6_q & not_266_s2_q) : end_7_q;
      end_8_q <= or_833 ? (end_7_q & not_266_s2_q) : end_8_q;
      end_9_q <= or_833 ? (end_8_q & not_266_s2_q) : end_9_q;
      end_10_q <= or_833 ? (end_9_q & not_266_s2_q) : end_10_q;
      end_11_q <= or_833 ? (end_10_q & not_266_s2_q) : end_11_q;
      end_12_q <= or_833 ? (end_11_q & not_266_s2_q) : end_12_q;
      end_13_q <= or_833 ? (end_12_q & not_266_s2_q) : end_13_q;
      end_14_q <= or_833 ? (end_13_q & not_266_s2_q) : end_14_q;
      end_15_q <= or_833 ? (end_14_q & not_266_s2_q) : end_15_q;
      end_16_q <= or_833 ? (end_15_q & not_266_s2_q) : end_16_q;
      end_17_q <= or_833 ? (end_16_q & not_266_s2_q) : end_17_q;
      end_18_q <= or_833 ? (end_17_q & not_266_s2_q) : end_18_q;
      end_19_q <= or_833 ? (end_18_q & not_266_s2_q) : end_19_q;
      end_20_q <= or_833 ? (end_19_q & not_266_s2_q) : end_20_q;
      end_21_q <= or_833 ? (end_20_q & not_266_s2_q) : end_21_q;
      end_22_q <= or_833 ? (end_21_q & not_266_s2_q) : end_22_q;
      end_23_q <= or_833 ? (end_22_q & not_266_s2_q) : end_23_q;
      end_24_q <= or_833 ? (end_23_q & not_266_s2_q) : end_24_q;
      end_25_q <= or_833 ? (end_24_q & not_266_s2_q) : end_25_q;
      end_26_q <= or_833 ? (end_25_q & not_266_s2_q) : end_26_q;
      end_27_q <= or_833 ? (end_26_q & not_266_s2_q) : end_27_q;
      end_28_q <= or_833 ? (end_27_q & not_266_s2_q) : end_28_q;
      end_29_q <= or_833 ? (end_28_q & not_266_s2_q) : end_29_q;
      end_30_q <= or_833 ? (end_29_q & not_266_s2_q) : end_30_q;
      end_31_q <= or_833 ? (end_30_q & not_266_s2_q) : end_31_q;
      run_label_q <= and_900 ? front_label_q : run_label_q;
      run_there_q <= and_906;
      used_0_q <= not_266_s2_q & or_924;
      used_1_q <= not_266_s2_q & or_933;
      used_2_q <= not_266_s2_q & or_942;
      used_3_q <= not_266_s2_q & or_951;
      used_4_q <= not_266_s2_q & or_959;
      used_5_q <= not_266_s2_q & or_967;
      used_6_q <= not_266_s2_q & or_975;
      used_7_q <= not_266_s2_q & or_983;
      used_8_q <= not_266_s2_q & or_991;
      used_9_q <= not_266_s2_q & or_999;
      used_10_q <= not_266_s2_q & or_1007;
      used_11_q <= not_266_s2_q & or_1015;
      used_12_q <= not_266_s2_q & or_1023;
      used_13_q <= not_266_s2_q & or_1031;
      used_14_q <= not_266_s2_q & or_1039;
      used_15_q <= not_266_s2_q & or_1047;
      used_16_q <= not_266_s2_q & or_1055;
      used_17_q <= not_266_s2_q & or_1063;
      used_18_q <= not_266_s2_q & or_1071;
      used_19_q <= not_266_s2_q & or_1079;
      used_20_q <= not_266_s2_q & or_1087;
      used_21_q <= not_266_s2_q & or_1095;
      used_22_q <= not_266_s2_q & or_1103;
      used_23_q <= not_266_s2_q & or_1111;
      used_24_q <= not_266_s2_q & or_1119;
      used_25_q <= not_266_s2_q & or_1127;
      used_26_q <= not_266_s2_q & or_1135;
      used_27_q <= not_266_s2_q & or_1143;
      used_28_q <= not_266_s2_q & or_1151;
      used_29_q <= not_266_s2_q & or_1159;
      used_30_q <= not_266_s2_q & or_1167;
      used_31_q <= not_266_s2_q & or_1175;
      free_label_q <= and_1180 ? found_label_q : free_label_q;
      free_there_q <= not_266_s2_q & (and_1180 | (free_there_q & (~and_1177)));
      found_label_q <= and_920 ? {at_group_q, or_1187, or_1186} : found_label_q;
      found_there_q <= not_266_s2_q & (and_920 | (found_there_q ^ and_1180));
      group_0_q <= and_265_s2_q | (and_1192 ? group_7_q : group_0_q);
      group_1_q <= not_266_s2_q & (and_1192 ? group_0_q : group_1_q);
      group_2_q <= not_266_s2_q & (and_1192 ? group_1_q : group_2_q);
      group_3_q <= not_266_s2_q & (and_1192 ? group_2_q : group_3_q);
      group_4_q <= not_266_s2_q & (and_1192 ? group_3_q : group_4_q);
      group_5_q <= not_266_s2_q & (and_1192 ? group_4_q : group_5_q);
      group_6_q <= not_266_s2_q & (and_1192 ? group_5_q : group_6_q);
      group_7_q <= not_266_s2_q & (and_1192 ? group_6_q : group_7_q);
      at_group_q <= and_265_s2_q ? 3'h0 : (at_group_q + {2'h0, and_1192});
      looked_q <= used_7;
      looked_there_q <= and_1254;
      front_label_q <= and_440 ? (or_1285 | or_1316) : front_label_q;
      front_there_q <= and_440 ? (or_1349 | or_1380) : front_there_q;
      label_q <= and_440 ? ended : label_q;
      fresh_q <= and_440 ? not_898 : fresh_q;
      same_0_q <= and_417 ? (and_1387 & (~begin_0_q)) : same_0_q;
      same_1_q <= and_417 ? (and_1393 & (~begin_1_q)) : same_1_q;
      same_2_q <= and_417 ? (and_1399 & (~begin_2_q)) : same_2_q;
      same_3_q <= and_417 ? (and_1405 & (~begin_3_q)) : same_3_q;
      same_4_q <= and_417 ? (and_1411 & (~begin_4_q)) : same_4_q;
      same_5_q <= and_417 ? (and_1417 & (~begin_5_q)) : same_5_q;
      same_6_q <= and_417 ? (and_1423 & (~begin_6_q)) : same_6_q;
      same_7_q <= and_417 ? (and_1429 & (~begin_7_q)) : same_7_q;
      same_8_q <= and_417 ? (and_1435 & (~begin_8_q)) : same_8_q;
      same_9_q <= and_417 ? (and_1441 & (~begin_9_q)) : same_9_q;
      same_10_q <= and_417 ? (and_1447 & (~begin_10_q)) : same_10_q;
      same_11_q <= and_417 ? (and_1453 & (~begin_11_q)) : same_11_q;
      same_12_q <= and_417 ? (and_1459 & (~begin_12_q)) : same_12_q;
      same_13_q <= and_417 ? (and_1465 & (~begin_13_q)) : same_13_q;
      same_14_q <= and_417 ? (and_1471 & (~begin_14_q)) : same_14_q;
      same_15_q <= and_417 ? (and_1477 & (~begin_15_q)) : same_15_q;
      same_16_q <= and_417 ? (and_1483 & (~begin_16_q)) : same_16_q;
      same_17_q <= and_417 ? (and_1489 & (~begin_17_q)) : same_17_q;
      same_18_q <= and_417 ? (and_1495 & (~begin_18_q)) : same_18_q;
      same_19_q <= and_417 ? (and_1501 & (~begin_19_q)) : same_19_q;
      same_20_q <= and_417 ? (and_1507 & (~begin_20_q)) : same_20_q;
      same_21_q <= and_417 ? (and_1513 & (~begin_21_q)) : same_21_q;
      same_22_q <= and_417 ? (and_1519 & (~begin_22_q)) : same_22_q;
      same_23_q <= and_417 ? (and_1525 & (~begin_23_q)) : same_23_q;
      same_24_q <= and_417 ? (and_1531 & (~begin_24_q)) : same_24_q;
      same_25_q <= and_417 ? (and_1537 & (~begin_25_q)) : same_25_q;
      same_26_q <= and_417 ? (and_1543 & (~begin_26_q)) : same_26_q;
      same_27_q <= and_417 ? (and_1549 & (~begin_27_q)) : same_27_q;
      same_28_q <= and_417 ? (and_1555 & (~begin_28_q)) : same_28_q;
      same_29_q <= and_417 ? (and_1561 & (~begin_29_q)) : same_29_q;
      same_30_q <= and_417 ? (and_1567 & (~begin_30_q)) : same_30_q;
      same_31_q <= and_417 ? (and_1573 & (~begin_31_q)) : same_31_q;
      others_q <= select_1583;
      joined_q <= select_1588;
      other_q <= and_321 ? (joined_q ? run_label_q : front_label_q) : other_q;
      second_q <= equal_267_s2_q ? frees : second_q;
      second_ends_q <= equal_267_s2_q ? closes : second_ends_q;
      overflow_q <= or_1664;
    end
  end

  logic [8:0] event_run_left_s3_q;
  logic [8:0] event_run_right_s3_q;
  logic [8:0] event_run_row_s3_q;
  logic not_266_s3_q;
  logic and_302_s3_q;
  logic [4:0] label_s3_q;
  logic or_324_s3_q;
  logic and_326_s3_q;
  logic not_362_s3_q;
  logic and_1678_s3_q;
  logic and_1686_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      event_run_left_s3_q <= event_run_left_q;
      event_run_right_s3_q <= event_run_right_q;
      event_run_row_s3_q <= event_run_row_q;
      not_266_s3_q <= not_266_s2_q;
      and_302_s3_q <= and_302;
      label_s3_q <= label;
      or_324_s3_q <= or_324;
      and_326_s3_q <= fresh_q & and_323;
      not_362_s3_q <= ~(and_302 ? second_ends_q : joined_q);
      and_1678_s3_q <= second_ends_q & and_302;
      and_1686_s3_q <= idle_s2_q & and_421;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [16:0] joining_pixels_q;
  logic [8:0] joining_left_q;
  logic [8:0] joining_right_q;
  logic [8:0] joining_top_q;
  logic [8:0] joining_bottom_q;
  logic [25:0] joining_columns_q;
  logic [25:0] joining_rows_q;
  logic alarm_q;
  // hls/stages/objects.hpp:393
  logic [8:0] pixels;
  assign pixels = (event_run_right_s3_q - event_run_left_s3_q) + 9'h1;
  // hls/stages/objects.hpp:404
  logic [16:0] sum_330;
  assign sum_330 = objects_rdata_q[16:0] + (and_302_s3_q ? joining_pixels_q : {8'h0, pixels});
  // hls/stages/objects.hpp:382
  logic [16:0] select_331;
  assign select_331 = and_326_s3_q ? {8'h0, pixels} : sum_330;
  // hls/stages/objects.hpp:376
  logic [8:0] select_332;
  assign select_332 = and_302_s3_q ? joining_left_q : event_run_left_s3_q;
  // hls/stages/objects.hpp:405
  logic [8:0] select_334;
  assign select_334 = (select_332 < objects_rdata_q[25:17]) ? select_332 : objects_rdata_q[25:17];
  // hls/stages/objects.hpp:382
  logic [8:0] select_335;
  assign select_335 = and_326_s3_q ? event_run_left_s3_q : select_334;
  // hls/stages/objects.hpp:376
  logic [8:0] select_336;
  assign select_336 = and_302_s3_q ? joining_right_q : event_run_right_s3_q;
  // hls/stages/objects.hpp:406
  logic [8:0] select_338;
  assign select_338 = (objects_rdata_q[34:26] < select_336) ? select_336 : objects_rdata_q[34:26];
  // hls/stages/objects.hpp:382
  logic [8:0] select_339;
  assign select_339 = and_326_s3_q ? event_run_right_s3_q : select_338;
  // hls/stages/objects.hpp:376
  logic [8:0] select_340;
  assign select_340 = and_302_s3_q ? joining_top_q : event_run_row_s3_q;
  // hls/stages/objects.hpp:407
  logic [8:0] select_342;
  assign select_342 = (select_340 < objects_rdata_q[43:35]) ? select_340 : objects_rdata_q[43:35];
  // hls/stages/objects.hpp:382
  logic [8:0] select_343;
  assign select_343 = and_326_s3_q ? event_run_row_s3_q : select_342;
  // hls/stages/objects.hpp:376
  logic [8:0] select_344;
  assign select_344 = and_302_s3_q ? joining_bottom_q : event_run_row_s3_q;
  // hls/stages/objects.hpp:408
  logic [8:0] select_346;
  assign select_346 = (objects_rdata_q[52:44] < select_344) ? select_344 : objects_rdata_q[52:44];
  // hls/stages/objects.hpp:382
  logic [8:0] select_347;
  assign select_347 = and_326_s3_q ? event_run_row_s3_q : select_346;
  // hls/stages/objects.hpp:398
  logic [9:0] sum_348;
  assign sum_348 = {1'b0, event_run_left_s3_q} + {1'b0, event_run_right_s3_q};
  logic [18:0] product_349;
  assign product_349 = {10'h0, pixels} * {9'h0, sum_348};
  // hls/stages/objects.hpp:376
  logic [25:0] b;
  assign b = and_302_s3_q ? joining_columns_q : {8'h0, product_349[18:1]};
  // hls/stages/objects.hpp:416
  logic [16:0] low;
  assign low = {1'b0, objects_rdata_q[68:53]} + {1'b0, b[15:0]};
  // hls/stages/objects.hpp:418
  logic [9:0] sum_353;
  assign sum_353 = {9'h0, low[16]} + (objects_rdata_q[78:69] + b[25:16]);
  // hls/stages/objects.hpp:382
  logic [25:0] select_354;
  assign select_354 = and_326_s3_q ? {8'h0, product_349[18:1]} : {sum_353, low[15:0]};
  // hls/stages/objects.hpp:399
  logic [17:0] product_355;
  assign product_355 = {9'h0, event_run_row_s3_q} * {9'h0, pixels};
  // hls/stages/objects.hpp:376
  logic [25:0] b_2;
  assign b_2 = and_302_s3_q ? joining_rows_q : {8'h0, product_355};
  // hls/stages/objects.hpp:416
  logic [16:0] low_2;
  assign low_2 = {1'b0, objects_rdata_q[94:79]} + {1'b0, b_2[15:0]};
  // hls/stages/objects.hpp:418
  logic [9:0] sum_359;
  assign sum_359 = {9'h0, low_2[16]} + (objects_rdata_q[104:95] + b_2[25:16]);
  // hls/stages/objects.hpp:382
  logic [25:0] select_360;
  assign select_360 = and_326_s3_q ? {8'h0, product_355} : {sum_359, low_2[15:0]};
  // hls/stages/objects.hpp:87
  logic and_1675;
  assign and_1675 = or_324_s3_q & (not_362_s3_q & (~(select_331 < cfg_object_limit_i)));

  // Memory objects, write
  logic [4:0] objects_waddr;
  assign objects_waddr = label_s3_q;
  logic objects_we;
  assign objects_we = s3_en & (not_362_s3_q & or_324_s3_q);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (objects_we) objects_mem[objects_waddr] <= {select_360, select_354, select_347, select_343, select_339, select_335, select_331};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && objects_we) begin
      if (objects_re && objects_raddr == objects_waddr) begin
        $error("objects: address %0d is read less than DISTANCE steps after its write", objects_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      joining_pixels_q <= 17'h0;
      joining_left_q <= 9'h0;
      joining_right_q <= 9'h0;
      joining_top_q <= 9'h0;
      joining_bottom_q <= 9'h0;
      joining_columns_q <= 26'h0;
      joining_rows_q <= 26'h0;
      alarm_q <= 1'b0;
    end else if (s3_en) begin
      joining_pixels_q <= or_324_s3_q ? objects_rdata_q[16:0] : joining_pixels_q;
      joining_left_q <= or_324_s3_q ? objects_rdata_q[25:17] : joining_left_q;
      joining_right_q <= or_324_s3_q ? objects_rdata_q[34:26] : joining_right_q;
      joining_top_q <= or_324_s3_q ? objects_rdata_q[43:35] : joining_top_q;
      joining_bottom_q <= or_324_s3_q ? objects_rdata_q[52:44] : joining_bottom_q;
      joining_columns_q <= or_324_s3_q ? objects_rdata_q[78:53] : joining_columns_q;
      joining_rows_q <= or_324_s3_q ? objects_rdata_q[104:79] : joining_rows_q;
      alarm_q <= and_1675 | (alarm_q & not_266_s3_q);
    end
  end

  logic or_1664_s4_q;
  logic and_1678_s4_q;
  logic [16:0] select_1679_s4_q;
  logic [8:0] select_1680_s4_q;
  logic [8:0] select_1681_s4_q;
  logic [8:0] select_1682_s4_q;
  logic [8:0] select_1683_s4_q;
  logic [25:0] select_1684_s4_q;
  logic [25:0] select_1685_s4_q;
  logic and_1686_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      or_1664_s4_q <= overflow_q;
      and_1678_s4_q <= and_1678_s3_q;
      select_1679_s4_q <= or_324_s3_q ? objects_rdata_q[16:0] : 17'h0;
      select_1680_s4_q <= or_324_s3_q ? objects_rdata_q[25:17] : 9'h0;
      select_1681_s4_q <= or_324_s3_q ? objects_rdata_q[34:26] : 9'h0;
      select_1682_s4_q <= or_324_s3_q ? objects_rdata_q[43:35] : 9'h0;
      select_1683_s4_q <= or_324_s3_q ? objects_rdata_q[52:44] : 9'h0;
      select_1684_s4_q <= or_324_s3_q ? objects_rdata_q[78:53] : 26'h0;
      select_1685_s4_q <= or_324_s3_q ? objects_rdata_q[104:79] : 26'h0;
      and_1686_s4_q <= and_1686_s3_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign ended_o = and_1678_s4_q;
  assign object_pixels_o = select_1679_s4_q;
  assign object_left_o = select_1680_s4_q;
  assign object_right_o = select_1681_s4_q;
  assign object_top_o = select_1682_s4_q;
  assign object_bottom_o = select_1683_s4_q;
  assign object_columns_o = select_1684_s4_q;
  assign object_rows_o = select_1685_s4_q;
  assign alarm_o = alarm_q;
  assign overflow_o = or_1664_s4_q;
  assign done_o = and_1686_s4_q;
  assign valid_o = valid_s4_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^product_349[0];

endmodule
