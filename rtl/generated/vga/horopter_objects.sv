// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Objects<horopter::hls::profiles::vga>, hls/stages/objects.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 607 bits, pipeline 209 bits, memories 6336 bits.
module horopter_objects (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic occupied_i,
  input  logic first_i,
  input  logic last_i,
  input  logic idle_i,
  input  logic [18:0] cfg_object_limit_i,
  output logic valid_o,
  output logic ended_o,
  output logic [18:0] object_pixels_o,
  output logic [9:0] object_left_o,
  output logic [9:0] object_right_o,
  output logic [8:0] object_top_o,
  output logic [8:0] object_bottom_o,
  output logic [28:0] object_columns_o,
  output logic [27:0] object_rows_o,
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
  logic [9:0] raster_column_q;
  logic raster_rows_q;
  logic raster_row_ended_q;
  // hls/stages/objects.hpp:199
  logic or_259;
  assign or_259 = first_i | raster_row_ended_q;
  logic [9:0] x;
  assign x = or_259 ? 10'h0 : (raster_column_q + 10'h1);
  // hls/stages/objects.hpp:79
  logic not_262;
  assign not_262 = ~idle_i;
  // hls/stages/objects.hpp:199
  logic and_280;
  assign and_280 = raster_rows_q & (~first_i);

  // Memory above, 640 x 1, DISTANCE 16, hls/stages/objects.hpp:423; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic above_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) above_mem[i] = 1'b0;
`endif
  logic [9:0] above_raddr;
  assign above_raddr = x;
  logic above_re;
  assign above_re = s0_en & not_262;
  logic above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (above_re) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 10'h0;
      raster_rows_q <= 1'b0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= idle_i ? raster_column_q : x;
      raster_rows_q <= idle_i ? raster_rows_q : (last_i | and_280);
      raster_row_ended_q <= idle_i ? raster_row_ended_q : last_i;
    end
  end

  logic occupied_s1_q;
  logic idle_s1_q;
  logic [9:0] x_s1_q;
  logic not_262_s1_q;
  logic and_264_s1_q;
  logic or_273_s1_q;
  logic and_280_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      occupied_s1_q <= occupied_i;
      idle_s1_q <= idle_i;
      x_s1_q <= x;
      not_262_s1_q <= not_262;
      and_264_s1_q <= first_i & not_262;
      or_273_s1_q <= idle_i | or_259;
      and_280_s1_q <= and_280;
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
  // hls/stages/objects.hpp:80
  logic not_265;
  assign not_265 = ~and_264_s1_q;
  // hls/stages/objects.hpp:252
  logic equal_266;
  assign equal_266 = phase_q == 2'h0;
  // hls/stages/objects.hpp:354
  logic equal_267;
  assign equal_267 = read_q == visible_q;
  logic not_268;
  assign not_268 = ~equal_267;
  // hls/stages/objects.hpp:211
  logic and_272;
  assign and_272 = ended_q & not_265;
  // hls/stages/objects.hpp:209
  logic not_274;
  assign not_274 = ~or_273_s1_q;
  // hls/stages/objects.hpp:211
  logic and_276;
  assign and_276 = before_v_q & not_265;
  logic select_277;
  assign select_277 = (and_272 | not_274) ? and_272 : and_276;
  logic and_278;
  assign and_278 = over_before_q & not_265;
  // hls/stages/objects.hpp:92
  logic and_282;
  assign and_282 = not_262_s1_q & (above_rdata_q & and_280_s1_q);
  // hls/stages/objects.hpp:209
  logic and_283;
  assign and_283 = and_282 & not_274;
  // hls/stages/objects.hpp:92
  logic and_285;
  assign and_285 = occupied_s1_q & not_262_s1_q;
  logic and_288;
  assign and_288 = (and_278 | and_283) & (not_274 & (and_285 | and_276));
  // hls/stages/objects.hpp:216
  logic and_291;
  assign and_291 = (met_q & not_265) & (~select_277);
  // hls/stages/objects.hpp:217
  logic and_293;
  assign and_293 = and_288 & (~and_291);
  // hls/stages/objects.hpp:212
  logic and_295;
  assign and_295 = and_278 & (~and_283);
  // hls/stages/objects.hpp:218
  logic or_297;
  assign or_297 = and_295 | (select_277 | and_293);
  // hls/stages/objects.hpp:229
  logic [8:0] select_376;
  assign select_376 = (idle_s1_q | not_274) ? row_q : (and_264_s1_q ? 9'h0 : (row_q + 9'h1));
  // hls/stages/objects.hpp:226
  logic [5:0] select_387;
  assign select_387 = and_264_s1_q ? 6'h0 : (or_297 ? (little_room_q ? write_q : (write_q + 6'h1)) : write_q);
  // hls/stages/objects.hpp:91
  logic [5:0] select_391;
  assign select_391 = and_264_s1_q ? 6'h0 : (equal_266 ? (equal_267 ? read_q : (read_q + 6'h1)) : read_q);
  // hls/stages/objects.hpp:81
  logic [5:0] room;
  assign room = read_q - write_q;
  // hls/stages/objects.hpp:80
  logic little_room;
  assign little_room = not_265 & (({2'h0, room_q} + 8'hff) < 8'h7);
  // hls/stages/objects.hpp:307
  logic and_408;
  assign and_408 = (write_q == read_q) & ((~before_v_q) & ((~over_before_q) & (~ended_q)));

  // Memory queue, 64 x 32, DISTANCE 4, hls/stages/objects.hpp:430; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] queue_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) queue_mem[i] = 32'h0;
`endif
  logic [5:0] queue_raddr;
  assign queue_raddr = read_q;
  logic queue_re;
  assign queue_re = s1_en & (not_265 & (equal_266 & not_268));
  logic [31:0] queue_rdata_q;
  always_ff @(posedge clk_i) begin
    if (queue_re) queue_rdata_q <= queue_mem[queue_raddr];
  end

  // Memory above, write
  logic [9:0] above_waddr;
  assign above_waddr = x_s1_q;
  logic above_we;
  assign above_we = s1_en & not_262_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= occupied_s1_q;
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && above_we) begin
      if (above_re && above_raddr == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
      if (above_waddr >= 10'd640) $error("above: write outside, address %0d", above_waddr);
    end
    if (rst_ni && above_re && above_raddr >= 10'd640) $error("above: read outside, address %0d", above_raddr);
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
      before_v_q <= and_285;
      over_before_q <= and_282;
      ended_q <= not_274 & (and_276 & (~and_285));
      met_q <= (and_288 | and_291) & (~and_295);
      row_q <= select_376;
      write_q <= select_387;
      read_q <= select_391;
      visible_q <= and_264_s1_q ? 6'h0 : (equal_266 ? write_q : visible_q);
      room_q <= and_264_s1_q ? 6'h0 : room;
      little_room_q <= little_room;
      phase_q <= phase_q + 2'h1;
    end
  end

  logic idle_s2_q;
  logic [5:0] write_s2_q;
  logic [1:0] phase_s2_q;
  logic [9:0] x_s2_q;
  logic and_264_s2_q;
  logic not_265_s2_q;
  logic equal_266_s2_q;
  logic equal_267_s2_q;
  logic not_268_s2_q;
  logic select_277_s2_q;
  logic and_293_s2_q;
  logic and_295_s2_q;
  logic and_299_s2_q;
  logic or_378_s2_q;
  logic and_409_s2_q;
  logic and_1658_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      idle_s2_q <= idle_s1_q;
      write_s2_q <= write_q;
      phase_s2_q <= phase_q;
      x_s2_q <= x_s1_q;
      and_264_s2_q <= and_264_s1_q;
      not_265_s2_q <= not_265;
      equal_266_s2_q <= equal_266;
      equal_267_s2_q <= equal_267;
      not_268_s2_q <= not_268;
      select_277_s2_q <= select_277;
      and_293_s2_q <= and_293;
      and_295_s2_q <= and_295;
      and_299_s2_q <= or_297 & (~little_room_q);
      or_378_s2_q <= or_273_s1_q | (~and_276);
      and_409_s2_q <= (~(not_262_s1_q | not_268)) & and_408;
      and_1658_s2_q <= little_room_q & or_297;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [9:0] last_run_left_q;
  logic [9:0] last_run_right_q;
  logic [8:0] last_run_row_q;
  logic busy_q;
  logic draining_q;
  logic done_q;
  logic event_ends_q;
  logic event_meets_q;
  logic event_passes_q;
  logic [9:0] event_run_left_q;
  logic [9:0] event_run_right_q;
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
  // hls/stages/objects.hpp:371
  logic equal_300;
  assign equal_300 = phase_s2_q == 2'h1;
  logic and_301;
  assign and_301 = second_q & equal_300;
  // hls/stages/objects.hpp:380
  logic not_302;
  assign not_302 = ~joined_q;
  logic [2:0] select_303;
  assign select_303 = and_301 ? 3'h6 : {not_302, {2{joined_q}}};
  logic select_305;
  assign select_305 = select_303[0] ? others_q : same_30_q;
  logic [4:0] select_306;
  assign select_306 = select_303[1] ? (select_303[0] ? {4'h0, second_ends_q} : other_q) : {4'h0, select_305};
  logic select_309;
  assign select_309 = select_303[1] ? (select_303[0] ? same_28_q : same_26_q) : (select_303[0] ? same_24_q : same_22_q);
  logic select_311;
  assign select_311 = select_303[0] ? same_4_q : same_2_q;
  logic [4:0] select_313;
  assign select_313 = select_303[1] ? {4'h0, select_311} : (select_303[0] ? {4'h0, same_0_q} : label_q);
  logic select_315;
  assign select_315 = select_303[0] ? group_7_q : group_5_q;
  logic [4:0] select_316;
  assign select_316 = select_303[1] ? (select_303[0] ? front_label_q : {1'b0, looked_q}) : {4'h0, select_315};
  logic [4:0] label;
  assign label = and_301 ? (select_303[2] ? select_306 : {4'h0, select_309}) : (select_303[2] ? select_313 : select_316);
  // hls/stages/objects.hpp:372
  logic and_320;
  assign and_320 = busy_q & (phase_s2_q == 2'h3);
  logic and_322;
  assign and_322 = and_320 & (event_ends_q | joined_q);
  // hls/stages/objects.hpp:379
  logic or_323;
  assign or_323 = and_301 | and_322;
  // hls/stages/objects.hpp:92
  logic [9:0] x_2;
  assign x_2 = idle_s2_q ? last_run_right_q : x_s2_q;
  // hls/stages/objects.hpp:234
  logic [9:0] select_381;
  assign select_381 = before_v_q ? (or_378_s2_q ? x_2 : last_run_left_q) : last_run_left_q;
  // hls/stages/objects.hpp:91
  logic and_412;
  assign and_412 = not_265_s2_q & (equal_266_s2_q ? (not_268_s2_q | and_409_s2_q) : busy_q);
  logic select_414;
  assign select_414 = and_264_s2_q ? draining_q : (equal_266_s2_q ? and_409_s2_q : draining_q);
  // hls/stages/objects.hpp:251
  logic and_416;
  assign and_416 = busy_q & (phase_s2_q == 2'h2);
  // hls/stages/objects.hpp:91
  logic and_420;
  assign and_420 = not_265_s2_q & (and_416 ? (draining_q & (~front_there_q)) : done_q);
  logic select_422;
  assign select_422 = equal_266_s2_q ? (queue_rdata_q[0] & not_268_s2_q) : event_ends_q;
  logic select_425;
  assign select_425 = equal_266_s2_q ? (queue_rdata_q[1] & not_268_s2_q) : event_meets_q;
  logic select_428;
  assign select_428 = equal_266_s2_q ? (queue_rdata_q[2] | equal_267_s2_q) : event_passes_q;
  logic [9:0] select_431;
  assign select_431 = equal_266_s2_q ? (equal_267_s2_q ? event_run_left_q : queue_rdata_q[12:3]) : event_run_left_q;
  logic [9:0] select_434;
  assign select_434 = equal_266_s2_q ? (equal_267_s2_q ? event_run_right_q : queue_rdata_q[22:13]) : event_run_right_q;
  logic [8:0] select_437;
  assign select_437 = equal_266_s2_q ? (equal_267_s2_q ? event_run_row_q : queue_rdata_q[31:23]) : event_run_row_q;
  // hls/stages/objects.hpp:251
  logic and_439;
  assign and_439 = busy_q & equal_300;
  // hls/stages/objects.hpp:255
  logic and_440;
  assign and_440 = event_ends_q & and_439;
  // hls/stages/objects.hpp:295
  logic and_441;
  assign and_441 = end_0_q & and_440;
  // hls/stages/objects.hpp:275
  logic and_442;
  assign and_442 = joined_q & and_320;
  // hls/stages/objects.hpp:256
  logic [4:0] ended;
  assign ended = run_there_q ? run_label_q : free_label_q;
  // hls/stages/objects.hpp:290
  logic [4:0] label_2;
  assign label_2 = and_440 ? ended : run_label_q;
  // hls/stages/objects.hpp:297
  logic [4:0] select_448;
  assign select_448 = (and_441 | (and_442 & (begin_0_q | same_0_q))) ? label_2 : entries_0_label_q;
  // hls/stages/objects.hpp:252
  logic and_449;
  assign and_449 = busy_q & equal_266_s2_q;
  // hls/stages/objects.hpp:281
  logic and_451;
  assign and_451 = front_there_q & (event_passes_q & and_449);
  // hls/stages/objects.hpp:297
  logic and_456;
  assign and_456 = not_265_s2_q & (and_441 | (entries_0_there_q & (~(begin_0_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_457;
  assign and_457 = end_1_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_461;
  assign select_461 = (and_457 | (and_442 & (begin_1_q | same_1_q))) ? label_2 : entries_1_label_q;
  logic and_466;
  assign and_466 = not_265_s2_q & (and_457 | (entries_1_there_q & (~(begin_1_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_467;
  assign and_467 = end_2_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_471;
  assign select_471 = (and_467 | (and_442 & (begin_2_q | same_2_q))) ? label_2 : entries_2_label_q;
  logic and_476;
  assign and_476 = not_265_s2_q & (and_467 | (entries_2_there_q & (~(begin_2_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_477;
  assign and_477 = end_3_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_481;
  assign select_481 = (and_477 | (and_442 & (begin_3_q | same_3_q))) ? label_2 : entries_3_label_q;
  logic and_486;
  assign and_486 = not_265_s2_q & (and_477 | (entries_3_there_q & (~(begin_3_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_487;
  assign and_487 = end_4_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_491;
  assign select_491 = (and_487 | (and_442 & (begin_4_q | same_4_q))) ? label_2 : entries_4_label_q;
  logic and_496;
  assign and_496 = not_265_s2_q & (and_487 | (entries_4_there_q & (~(begin_4_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_497;
  assign and_497 = end_5_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_501;
  assign select_501 = (and_497 | (and_442 & (begin_5_q | same_5_q))) ? label_2 : entries_5_label_q;
  logic and_506;
  assign and_506 = not_265_s2_q & (and_497 | (entries_5_there_q & (~(begin_5_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_507;
  assign and_507 = end_6_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_511;
  assign select_511 = (and_507 | (and_442 & (begin_6_q | same_6_q))) ? label_2 : entries_6_label_q;
  logic and_516;
  assign and_516 = not_265_s2_q & (and_507 | (entries_6_there_q & (~(begin_6_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_517;
  assign and_517 = end_7_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_521;
  assign select_521 = (and_517 | (and_442 & (begin_7_q | same_7_q))) ? label_2 : entries_7_label_q;
  logic and_526;
  assign and_526 = not_265_s2_q & (and_517 | (entries_7_there_q & (~(begin_7_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_527;
  assign and_527 = end_8_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_531;
  assign select_531 = (and_527 | (and_442 & (begin_8_q | same_8_q))) ? label_2 : entries_8_label_q;
  logic and_536;
  assign and_536 = not_265_s2_q & (and_527 | (entries_8_there_q & (~(begin_8_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_537;
  assign and_537 = end_9_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_541;
  assign select_541 = (and_537 | (and_442 & (begin_9_q | same_9_q))) ? label_2 : entries_9_label_q;
  logic and_546;
  assign and_546 = not_265_s2_q & (and_537 | (entries_9_there_q & (~(begin_9_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_547;
  assign and_547 = end_10_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_551;
  assign select_551 = (and_547 | (and_442 & (begin_10_q | same_10_q))) ? label_2 : entries_10_label_q;
  logic and_556;
  assign and_556 = not_265_s2_q & (and_547 | (entries_10_there_q & (~(begin_10_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_557;
  assign and_557 = end_11_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_561;
  assign select_561 = (and_557 | (and_442 & (begin_11_q | same_11_q))) ? label_2 : entries_11_label_q;
  logic and_566;
  assign and_566 = not_265_s2_q & (and_557 | (entries_11_there_q & (~(begin_11_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_567;
  assign and_567 = end_12_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_571;
  assign select_571 = (and_567 | (and_442 & (begin_12_q | same_12_q))) ? label_2 : entries_12_label_q;
  logic and_576;
  assign and_576 = not_265_s2_q & (and_567 | (entries_12_there_q & (~(begin_12_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_577;
  assign and_577 = end_13_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_581;
  assign select_581 = (and_577 | (and_442 & (begin_13_q | same_13_q))) ? label_2 : entries_13_label_q;
  logic and_586;
  assign and_586 = not_265_s2_q & (and_577 | (entries_13_there_q & (~(begin_13_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_587;
  assign and_587 = end_14_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_591;
  assign select_591 = (and_587 | (and_442 & (begin_14_q | same_14_q))) ? label_2 : entries_14_label_q;
  logic and_596;
  assign and_596 = not_265_s2_q & (and_587 | (entries_14_there_q & (~(begin_14_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_597;
  assign and_597 = end_15_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_601;
  assign select_601 = (and_597 | (and_442 & (begin_15_q | same_15_q))) ? label_2 : entries_15_label_q;
  logic and_606;
  assign and_606 = not_265_s2_q & (and_597 | (entries_15_there_q & (~(begin_15_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_607;
  assign and_607 = end_16_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_611;
  assign select_611 = (and_607 | (and_442 & (begin_16_q | same_16_q))) ? label_2 : entries_16_label_q;
  logic and_616;
  assign and_616 = not_265_s2_q & (and_607 | (entries_16_there_q & (~(begin_16_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_617;
  assign and_617 = end_17_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_621;
  assign select_621 = (and_617 | (and_442 & (begin_17_q | same_17_q))) ? label_2 : entries_17_label_q;
  logic and_626;
  assign and_626 = not_265_s2_q & (and_617 | (entries_17_there_q & (~(begin_17_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_627;
  assign and_627 = end_18_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_631;
  assign select_631 = (and_627 | (and_442 & (begin_18_q | same_18_q))) ? label_2 : entries_18_label_q;
  logic and_636;
  assign and_636 = not_265_s2_q & (and_627 | (entries_18_there_q & (~(begin_18_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_637;
  assign and_637 = end_19_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_641;
  assign select_641 = (and_637 | (and_442 & (begin_19_q | same_19_q))) ? label_2 : entries_19_label_q;
  logic and_646;
  assign and_646 = not_265_s2_q & (and_637 | (entries_19_there_q & (~(begin_19_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_647;
  assign and_647 = end_20_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_651;
  assign select_651 = (and_647 | (and_442 & (begin_20_q | same_20_q))) ? label_2 : entries_20_label_q;
  logic and_656;
  assign and_656 = not_265_s2_q & (and_647 | (entries_20_there_q & (~(begin_20_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_657;
  assign and_657 = end_21_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_661;
  assign select_661 = (and_657 | (and_442 & (begin_21_q | same_21_q))) ? label_2 : entries_21_label_q;
  logic and_666;
  assign and_666 = not_265_s2_q & (and_657 | (entries_21_there_q & (~(begin_21_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_667;
  assign and_667 = end_22_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_671;
  assign select_671 = (and_667 | (and_442 & (begin_22_q | same_22_q))) ? label_2 : entries_22_label_q;
  logic and_676;
  assign and_676 = not_265_s2_q & (and_667 | (entries_22_there_q & (~(begin_22_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_677;
  assign and_677 = end_23_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_681;
  assign select_681 = (and_677 | (and_442 & (begin_23_q | same_23_q))) ? label_2 : entries_23_label_q;
  logic and_686;
  assign and_686 = not_265_s2_q & (and_677 | (entries_23_there_q & (~(begin_23_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_687;
  assign and_687 = end_24_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_691;
  assign select_691 = (and_687 | (and_442 & (begin_24_q | same_24_q))) ? label_2 : entries_24_label_q;
  logic and_696;
  assign and_696 = not_265_s2_q & (and_687 | (entries_24_there_q & (~(begin_24_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_697;
  assign and_697 = end_25_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_701;
  assign select_701 = (and_697 | (and_442 & (begin_25_q | same_25_q))) ? label_2 : entries_25_label_q;
  logic and_706;
  assign and_706 = not_265_s2_q & (and_697 | (entries_25_there_q & (~(begin_25_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_707;
  assign and_707 = end_26_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_711;
  assign select_711 = (and_707 | (and_442 & (begin_26_q | same_26_q))) ? label_2 : entries_26_label_q;
  logic and_716;
  assign and_716 = not_265_s2_q & (and_707 | (entries_26_there_q & (~(begin_26_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_717;
  assign and_717 = end_27_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_721;
  assign select_721 = (and_717 | (and_442 & (begin_27_q | same_27_q))) ? label_2 : entries_27_label_q;
  logic and_726;
  assign and_726 = not_265_s2_q & (and_717 | (entries_27_there_q & (~(begin_27_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_727;
  assign and_727 = end_28_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_731;
  assign select_731 = (and_727 | (and_442 & (begin_28_q | same_28_q))) ? label_2 : entries_28_label_q;
  logic and_736;
  assign and_736 = not_265_s2_q & (and_727 | (entries_28_there_q & (~(begin_28_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_737;
  assign and_737 = end_29_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_741;
  assign select_741 = (and_737 | (and_442 & (begin_29_q | same_29_q))) ? label_2 : entries_29_label_q;
  logic and_746;
  assign and_746 = not_265_s2_q & (and_737 | (entries_29_there_q & (~(begin_29_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_747;
  assign and_747 = end_30_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_751;
  assign select_751 = (and_747 | (and_442 & (begin_30_q | same_30_q))) ? label_2 : entries_30_label_q;
  logic and_756;
  assign and_756 = not_265_s2_q & (and_747 | (entries_30_there_q & (~(begin_30_q & and_451))));
  // hls/stages/objects.hpp:295
  logic and_757;
  assign and_757 = end_31_q & and_440;
  // hls/stages/objects.hpp:297
  logic [4:0] select_761;
  assign select_761 = (and_757 | (and_442 & (begin_31_q | same_31_q))) ? label_2 : entries_31_label_q;
  logic and_766;
  assign and_766 = not_265_s2_q & (and_757 | (entries_31_there_q & (~(begin_31_q & and_451))));
  // hls/stages/objects.hpp:301
  logic or_767;
  assign or_767 = and_264_s2_q | and_451;
  // hls/stages/objects.hpp:302
  logic or_832;
  assign or_832 = and_264_s2_q | and_440;
  // hls/stages/objects.hpp:255
  logic not_897;
  assign not_897 = ~run_there_q;
  // hls/stages/objects.hpp:266
  logic and_899;
  assign and_899 = not_897 & (event_meets_q & and_416);
  // hls/stages/objects.hpp:273
  logic and_905;
  assign and_905 = not_265_s2_q & ((run_there_q & (~and_440)) | (front_there_q & and_899));
  // hls/stages/objects.hpp:282
  logic closes;
  assign closes = (not_302 & and_451) & (~others_q);
  logic frees;
  assign frees = closes | (joined_q & and_449);
  // hls/stages/objects.hpp:298
  logic not_913;
  assign not_913 = ~frees;
  // hls/stages/objects.hpp:319
  logic and_916;
  assign and_916 = looked_there_q & not_265_s2_q;
  // hls/stages/objects.hpp:317
  logic equal_917;
  assign equal_917 = looked_q == 4'hf;
  // hls/stages/objects.hpp:320
  logic and_919;
  assign and_919 = and_916 & (~equal_917);
  // hls/stages/objects.hpp:316
  logic not_920;
  assign not_920 = ~looked_q[0];
  // hls/stages/objects.hpp:299
  logic or_923;
  assign or_923 = (used_0_q & ((~(front_label_q == 5'h0)) | not_913)) | (and_919 & (group_0_q & not_920));
  // hls/stages/objects.hpp:316
  logic equal_929;
  assign equal_929 = looked_q[1:0] == 2'h1;
  // hls/stages/objects.hpp:299
  logic or_932;
  assign or_932 = (used_1_q & (not_913 | (~(front_label_q == 5'h1)))) | (and_919 & (group_0_q & equal_929));
  // hls/stages/objects.hpp:316
  logic equal_938;
  assign equal_938 = looked_q[2:0] == 3'h3;
  // hls/stages/objects.hpp:299
  logic or_941;
  assign or_941 = (used_2_q & (not_913 | (~(front_label_q == 5'h2)))) | (and_919 & (group_0_q & equal_938));
  // hls/stages/objects.hpp:316
  logic equal_947;
  assign equal_947 = looked_q == 4'h7;
  // hls/stages/objects.hpp:299
  logic or_950;
  assign or_950 = (used_3_q & (not_913 | (~(front_label_q == 5'h3)))) | (and_919 & (group_0_q & equal_947));
  logic or_958;
  assign or_958 = (used_4_q & (not_913 | (~(front_label_q == 5'h4)))) | (and_919 & (group_1_q & not_920));
  logic or_966;
  assign or_966 = (used_5_q & (not_913 | (~(front_label_q == 5'h5)))) | (and_919 & (group_1_q & equal_929));
  logic or_974;
  assign or_974 = (used_6_q & (not_913 | (~(front_label_q == 5'h6)))) | (and_919 & (group_1_q & equal_938));
  logic or_982;
  assign or_982 = (used_7_q & (not_913 | (~(front_label_q == 5'h7)))) | (and_919 & (group_1_q & equal_947));
  logic or_990;
  assign or_990 = (used_8_q & (not_913 | (~(front_label_q == 5'h8)))) | (and_919 & (group_2_q & not_920));
  logic or_998;
  assign or_998 = (used_9_q & (not_913 | (~(front_label_q == 5'h9)))) | (and_919 & (group_2_q & equal_929));
  logic or_1006;
  assign or_1006 = (used_10_q & (not_913 | (~(front_label_q == 5'ha)))) | (and_919 & (group_2_q & equal_938));
  logic or_1014;
  assign or_1014 = (used_11_q & (not_913 | (~(front_label_q == 5'hb)))) | (and_919 & (group_2_q & equal_947));
  logic or_1022;
  assign or_1022 = (used_12_q & (not_913 | (~(front_label_q == 5'hc)))) | (and_919 & (group_3_q & not_920));
  logic or_1030;
  assign or_1030 = (used_13_q & (not_913 | (~(front_label_q == 5'hd)))) | (and_919 & (group_3_q & equal_929));
  logic or_1038;
  assign or_1038 = (used_14_q & (not_913 | (~(front_label_q == 5'he)))) | (and_919 & (group_3_q & equal_938));
  logic or_1046;
  assign or_1046 = (used_15_q & (not_913 | (~(front_label_q == 5'hf)))) | (and_919 & (group_3_q & equal_947));
  logic or_1054;
  assign or_1054 = (used_16_q & (not_913 | (~(front_label_q == 5'h10)))) | (and_919 & (group_4_q & not_920));
  logic or_1062;
  assign or_1062 = (used_17_q & (not_913 | (~(front_label_q == 5'h11)))) | (and_919 & (group_4_q & equal_929));
  logic or_1070;
  assign or_1070 = (used_18_q & (not_913 | (~(front_label_q == 5'h12)))) | (and_919 & (group_4_q & equal_938));
  logic or_1078;
  assign or_1078 = (used_19_q & (not_913 | (~(front_label_q == 5'h13)))) | (and_919 & (group_4_q & equal_947));
  logic or_1086;
  assign or_1086 = (used_20_q & (not_913 | (~(front_label_q == 5'h14)))) | (and_919 & (group_5_q & not_920));
  logic or_1094;
  assign or_1094 = (used_21_q & (not_913 | (~(front_label_q == 5'h15)))) | (and_919 & (group_5_q & equal_929));
  logic or_1102;
  assign or_1102 = (used_22_q & (not_913 | (~(front_label_q == 5'h16)))) | (and_919 & (group_5_q & equal_938));
  logic or_1110;
  assign or_1110 = (used_23_q & (not_913 | (~(front_label_q == 5'h17)))) | (and_919 & (group_5_q & equal_947));
  logic or_1118;
  assign or_1118 = (used_24_q & (not_913 | (~(front_label_q == 5'h18)))) | (and_919 & (group_6_q & not_920));
  logic or_1126;
  assign or_1126 = (used_25_q & (not_913 | (~(front_label_q == 5'h19)))) | (and_919 & (group_6_q & equal_929));
  logic or_1134;
  assign or_1134 = (used_26_q & (not_913 | (~(front_label_q == 5'h1a)))) | (and_919 & (group_6_q & equal_938));
  logic or_1142;
  assign or_1142 = (used_27_q & (not_913 | (~(front_label_q == 5'h1b)))) | (and_919 & (group_6_q & equal_947));
  logic or_1150;
  assign or_1150 = (used_28_q & (not_913 | (~(front_label_q == 5'h1c)))) | (and_919 & (group_7_q & not_920));
  logic or_1158;
  assign or_1158 = (used_29_q & (not_913 | (~(front_label_q == 5'h1d)))) | (and_919 & (group_7_q & equal_929));
  logic or_1166;
  assign or_1166 = (used_30_q & (not_913 | (~(front_label_q == 5'h1e)))) | (and_919 & (group_7_q & equal_938));
  logic or_1174;
  assign or_1174 = (used_31_q & (not_913 | (~(front_label_q == 5'h1f)))) | (and_919 & (group_7_q & equal_947));
  // hls/stages/objects.hpp:255
  logic and_1176;
  assign and_1176 = and_440 & not_897;
  // hls/stages/objects.hpp:262
  logic not_1177;
  assign not_1177 = ~free_there_q;
  // hls/stages/objects.hpp:322
  logic and_1179;
  assign and_1179 = found_there_q & (and_1176 | not_1177);
  // hls/stages/objects.hpp:325
  logic or_1185;
  assign or_1185 = equal_929 | equal_947;
  logic or_1186;
  assign or_1186 = equal_938 | equal_947;
  // hls/stages/objects.hpp:344
  logic and_1191;
  assign and_1191 = equal_917 & and_916;
  // hls/stages/objects.hpp:337
  logic and_1210;
  assign and_1210 = used_0_q & group_0_q;
  logic and_1211;
  assign and_1211 = used_1_q & group_0_q;
  logic and_1212;
  assign and_1212 = used_2_q & group_0_q;
  logic and_1213;
  assign and_1213 = used_3_q & group_0_q;
  logic and_1214;
  assign and_1214 = used_4_q & group_1_q;
  logic and_1215;
  assign and_1215 = used_5_q & group_1_q;
  logic and_1216;
  assign and_1216 = used_6_q & group_1_q;
  logic and_1217;
  assign and_1217 = used_7_q & group_1_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used;
  assign used = {and_1213, and_1212, and_1211, and_1210} | {and_1217, and_1216, and_1215, and_1214};
  // hls/stages/objects.hpp:337
  logic and_1219;
  assign and_1219 = used_8_q & group_2_q;
  logic and_1220;
  assign and_1220 = used_9_q & group_2_q;
  logic and_1221;
  assign and_1221 = used_10_q & group_2_q;
  logic and_1222;
  assign and_1222 = used_11_q & group_2_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_2;
  assign used_2 = used | {and_1222, and_1221, and_1220, and_1219};
  // hls/stages/objects.hpp:337
  logic and_1224;
  assign and_1224 = used_12_q & group_3_q;
  logic and_1225;
  assign and_1225 = used_13_q & group_3_q;
  logic and_1226;
  assign and_1226 = used_14_q & group_3_q;
  logic and_1227;
  assign and_1227 = used_15_q & group_3_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_3;
  assign used_3 = used_2 | {and_1227, and_1226, and_1225, and_1224};
  // hls/stages/objects.hpp:337
  logic and_1229;
  assign and_1229 = used_16_q & group_4_q;
  logic and_1230;
  assign and_1230 = used_17_q & group_4_q;
  logic and_1231;
  assign and_1231 = used_18_q & group_4_q;
  logic and_1232;
  assign and_1232 = used_19_q & group_4_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_4;
  assign used_4 = used_3 | {and_1232, and_1231, and_1230, and_1229};
  // hls/stages/objects.hpp:337
  logic and_1234;
  assign and_1234 = used_20_q & group_5_q;
  logic and_1235;
  assign and_1235 = used_21_q & group_5_q;
  logic and_1236;
  assign and_1236 = used_22_q & group_5_q;
  logic and_1237;
  assign and_1237 = used_23_q & group_5_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_5;
  assign used_5 = used_4 | {and_1237, and_1236, and_1235, and_1234};
  // hls/stages/objects.hpp:337
  logic and_1239;
  assign and_1239 = used_24_q & group_6_q;
  logic and_1240;
  assign and_1240 = used_25_q & group_6_q;
  logic and_1241;
  assign and_1241 = used_26_q & group_6_q;
  logic and_1242;
  assign and_1242 = used_27_q & group_6_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_6;
  assign used_6 = used_5 | {and_1242, and_1241, and_1240, and_1239};
  // hls/stages/objects.hpp:337
  logic and_1244;
  assign and_1244 = used_28_q & group_7_q;
  logic and_1245;
  assign and_1245 = used_29_q & group_7_q;
  logic and_1246;
  assign and_1246 = used_30_q & group_7_q;
  logic and_1247;
  assign and_1247 = used_31_q & group_7_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_7;
  assign used_7 = used_6 | {and_1247, and_1246, and_1245, and_1244};
  // hls/stages/objects.hpp:342
  logic and_1253;
  assign and_1253 = not_265_s2_q & ((~looked_there_q) & (and_1179 | (~found_there_q)));
  // hls/stages/objects.hpp:167
  logic [4:0] or_1256;
  assign or_1256 = (begin_0_q ? entries_0_label_q : 5'h0) | (begin_1_q ? entries_1_label_q : 5'h0);
  logic [4:0] or_1259;
  assign or_1259 = (begin_2_q ? entries_2_label_q : 5'h0) | (begin_3_q ? entries_3_label_q : 5'h0);
  logic [4:0] or_1263;
  assign or_1263 = (begin_4_q ? entries_4_label_q : 5'h0) | (begin_5_q ? entries_5_label_q : 5'h0);
  logic [4:0] or_1266;
  assign or_1266 = (begin_6_q ? entries_6_label_q : 5'h0) | (begin_7_q ? entries_7_label_q : 5'h0);
  logic [4:0] or_1271;
  assign or_1271 = (begin_8_q ? entries_8_label_q : 5'h0) | (begin_9_q ? entries_9_label_q : 5'h0);
  logic [4:0] or_1274;
  assign or_1274 = (begin_10_q ? entries_10_label_q : 5'h0) | (begin_11_q ? entries_11_label_q : 5'h0);
  logic [4:0] or_1278;
  assign or_1278 = (begin_12_q ? entries_12_label_q : 5'h0) | (begin_13_q ? entries_13_label_q : 5'h0);
  logic [4:0] or_1281;
  assign or_1281 = (begin_14_q ? entries_14_label_q : 5'h0) | (begin_15_q ? entries_15_label_q : 5'h0);
  logic [4:0] or_1284;
  assign or_1284 = ((or_1256 | or_1259) | (or_1263 | or_1266)) | ((or_1271 | or_1274) | (or_1278 | or_1281));
  logic [4:0] or_1287;
  assign or_1287 = (begin_16_q ? entries_16_label_q : 5'h0) | (begin_17_q ? entries_17_label_q : 5'h0);
  logic [4:0] or_1290;
  assign or_1290 = (begin_18_q ? entries_18_label_q : 5'h0) | (begin_19_q ? entries_19_label_q : 5'h0);
  logic [4:0] or_1294;
  assign or_1294 = (begin_20_q ? entries_20_label_q : 5'h0) | (begin_21_q ? entries_21_label_q : 5'h0);
  logic [4:0] or_1297;
  assign or_1297 = (begin_22_q ? entries_22_label_q : 5'h0) | (begin_23_q ? entries_23_label_q : 5'h0);
  logic [4:0] or_1302;
  assign or_1302 = (begin_24_q ? entries_24_label_q : 5'h0) | (begin_25_q ? entries_25_label_q : 5'h0);
  logic [4:0] or_1305;
  assign or_1305 = (begin_26_q ? entries_26_label_q : 5'h0) | (begin_27_q ? entries_27_label_q : 5'h0);
  logic [4:0] or_1309;
  assign or_1309 = (begin_28_q ? entries_28_label_q : 5'h0) | (begin_29_q ? entries_29_label_q : 5'h0);
  logic [4:0] or_1312;
  assign or_1312 = (begin_30_q ? entries_30_label_q : 5'h0) | (begin_31_q ? entries_31_label_q : 5'h0);
  logic [4:0] or_1315;
  assign or_1315 = ((or_1287 | or_1290) | (or_1294 | or_1297)) | ((or_1302 | or_1305) | (or_1309 | or_1312));
  // hls/stages/objects.hpp:168
  logic or_1320;
  assign or_1320 = (entries_0_there_q & begin_0_q) | (entries_1_there_q & begin_1_q);
  logic or_1323;
  assign or_1323 = (entries_2_there_q & begin_2_q) | (entries_3_there_q & begin_3_q);
  logic or_1327;
  assign or_1327 = (entries_4_there_q & begin_4_q) | (entries_5_there_q & begin_5_q);
  logic or_1330;
  assign or_1330 = (entries_6_there_q & begin_6_q) | (entries_7_there_q & begin_7_q);
  logic or_1335;
  assign or_1335 = (entries_8_there_q & begin_8_q) | (entries_9_there_q & begin_9_q);
  logic or_1338;
  assign or_1338 = (entries_10_there_q & begin_10_q) | (entries_11_there_q & begin_11_q);
  logic or_1342;
  assign or_1342 = (entries_12_there_q & begin_12_q) | (entries_13_there_q & begin_13_q);
  logic or_1345;
  assign or_1345 = (entries_14_there_q & begin_14_q) | (entries_15_there_q & begin_15_q);
  logic or_1348;
  assign or_1348 = ((or_1320 | or_1323) | (or_1327 | or_1330)) | ((or_1335 | or_1338) | (or_1342 | or_1345));
  logic or_1351;
  assign or_1351 = (entries_16_there_q & begin_16_q) | (entries_17_there_q & begin_17_q);
  logic or_1354;
  assign or_1354 = (entries_18_there_q & begin_18_q) | (entries_19_there_q & begin_19_q);
  logic or_1358;
  assign or_1358 = (entries_20_there_q & begin_20_q) | (entries_21_there_q & begin_21_q);
  logic or_1361;
  assign or_1361 = (entries_22_there_q & begin_22_q) | (entries_23_there_q & begin_23_q);
  logic or_1366;
  assign or_1366 = (entries_24_there_q & begin_24_q) | (entries_25_there_q & begin_25_q);
  logic or_1369;
  assign or_1369 = (entries_26_there_q & begin_26_q) | (entries_27_there_q & begin_27_q);
  logic or_1373;
  assign or_1373 = (entries_28_there_q & begin_28_q) | (entries_29_there_q & begin_29_q);
  logic or_1376;
  assign or_1376 = (entries_30_there_q & begin_30_q) | (entries_31_there_q & begin_31_q);
  logic or_1379;
  assign or_1379 = ((or_1351 | or_1354) | (or_1358 | or_1361)) | ((or_1366 | or_1369) | (or_1373 | or_1376));
  // hls/stages/objects.hpp:174
  logic and_1386;
  assign and_1386 = (entries_0_there_q & front_there_q) & (entries_0_label_q == front_label_q);
  logic and_1392;
  assign and_1392 = (entries_1_there_q & front_there_q) & (entries_1_label_q == front_label_q);
  logic and_1398;
  assign and_1398 = (entries_2_there_q & front_there_q) & (entries_2_label_q == front_label_q);
  logic and_1404;
  assign and_1404 = (entries_3_there_q & front_there_q) & (entries_3_label_q == front_label_q);
  logic and_1410;
  assign and_1410 = (entries_4_there_q & front_there_q) & (entries_4_label_q == front_label_q);
  logic and_1416;
  assign and_1416 = (entries_5_there_q & front_there_q) & (entries_5_label_q == front_label_q);
  logic and_1422;
  assign and_1422 = (entries_6_there_q & front_there_q) & (entries_6_label_q == front_label_q);
  logic and_1428;
  assign and_1428 = (entries_7_there_q & front_there_q) & (entries_7_label_q == front_label_q);
  logic and_1434;
  assign and_1434 = (entries_8_there_q & front_there_q) & (entries_8_label_q == front_label_q);
  logic and_1440;
  assign and_1440 = (entries_9_there_q & front_there_q) & (entries_9_label_q == front_label_q);
  logic and_1446;
  assign and_1446 = (entries_10_there_q & front_there_q) & (entries_10_label_q == front_label_q);
  logic and_1452;
  assign and_1452 = (entries_11_there_q & front_there_q) & (entries_11_label_q == front_label_q);
  logic and_1458;
  assign and_1458 = (entries_12_there_q & front_there_q) & (entries_12_label_q == front_label_q);
  logic and_1464;
  assign and_1464 = (entries_13_there_q & front_there_q) & (entries_13_label_q == front_label_q);
  logic and_1470;
  assign and_1470 = (entries_14_there_q & front_there_q) & (entries_14_label_q == front_label_q);
  logic and_1476;
  assign and_1476 = (entries_15_there_q & front_there_q) & (entries_15_label_q == front_label_q);
  logic and_1482;
  assign and_1482 = (entries_16_there_q & front_there_q) & (entries_16_label_q == front_label_q);
  logic and_1488;
  assign and_1488 = (entries_17_there_q & front_there_q) & (entries_17_label_q == front_label_q);
  logic and_1494;
  assign and_1494 = (entries_18_there_q & front_there_q) & (entries_18_label_q == front_label_q);
  logic and_1500;
  assign and_1500 = (entries_19_there_q & front_there_q) & (entries_19_label_q == front_label_q);
  logic and_1506;
  assign and_1506 = (entries_20_there_q & front_there_q) & (entries_20_label_q == front_label_q);
  logic and_1512;
  assign and_1512 = (entries_21_there_q & front_there_q) & (entries_21_label_q == front_label_q);
  logic and_1518;
  assign and_1518 = (entries_22_there_q & front_there_q) & (entries_22_label_q == front_label_q);
  logic and_1524;
  assign and_1524 = (entries_23_there_q & front_there_q) & (entries_23_label_q == front_label_q);
  logic and_1530;
  assign and_1530 = (entries_24_there_q & front_there_q) & (entries_24_label_q == front_label_q);
  logic and_1536;
  assign and_1536 = (entries_25_there_q & front_there_q) & (entries_25_label_q == front_label_q);
  logic and_1542;
  assign and_1542 = (entries_26_there_q & front_there_q) & (entries_26_label_q == front_label_q);
  logic and_1548;
  assign and_1548 = (entries_27_there_q & front_there_q) & (entries_27_label_q == front_label_q);
  logic and_1554;
  assign and_1554 = (entries_28_there_q & front_there_q) & (entries_28_label_q == front_label_q);
  logic and_1560;
  assign and_1560 = (entries_29_there_q & front_there_q) & (entries_29_label_q == front_label_q);
  logic and_1566;
  assign and_1566 = (entries_30_there_q & front_there_q) & (entries_30_label_q == front_label_q);
  logic and_1572;
  assign and_1572 = (entries_31_there_q & front_there_q) & (entries_31_label_q == front_label_q);
  // hls/stages/objects.hpp:277
  logic equal_1576;
  assign equal_1576 = {same_31_q, same_30_q, same_29_q, same_28_q, same_27_q, same_26_q, same_25_q, same_24_q, same_23_q, same_22_q, same_21_q, same_20_q, same_19_q, same_18_q, same_17_q, same_16_q, same_15_q, same_14_q, same_13_q, same_12_q, same_11_q, same_10_q, same_9_q, same_8_q, same_7_q, same_6_q, same_5_q, same_4_q, same_3_q, same_2_q, same_1_q, same_0_q} == 32'h0;
  // hls/stages/objects.hpp:268
  logic equal_1578;
  assign equal_1578 = run_label_q == front_label_q;
  // hls/stages/objects.hpp:281
  logic select_1582;
  assign select_1582 = and_320 ? ((~equal_1576) | (equal_1578 & (run_there_q & front_there_q))) : others_q;
  // hls/stages/objects.hpp:272
  logic select_1587;
  assign select_1587 = and_416 ? ((front_there_q & (event_meets_q & run_there_q)) & (~equal_1578)) : joined_q;
  // hls/stages/objects.hpp:168
  logic or_1598;
  assign or_1598 = ((entries_0_there_q & end_0_q) | (entries_1_there_q & end_1_q)) | ((entries_2_there_q & end_2_q) | (entries_3_there_q & end_3_q));
  logic or_1605;
  assign or_1605 = ((entries_4_there_q & end_4_q) | (entries_5_there_q & end_5_q)) | ((entries_6_there_q & end_6_q) | (entries_7_there_q & end_7_q));
  logic or_1612;
  assign or_1612 = (entries_10_there_q & end_10_q) | (entries_11_there_q & end_11_q);
  logic or_1613;
  assign or_1613 = ((entries_8_there_q & end_8_q) | (entries_9_there_q & end_9_q)) | or_1612;
  logic or_1616;
  assign or_1616 = (entries_12_there_q & end_12_q) | (entries_13_there_q & end_13_q);
  logic or_1619;
  assign or_1619 = (entries_14_there_q & end_14_q) | (entries_15_there_q & end_15_q);
  logic or_1625;
  assign or_1625 = (entries_16_there_q & end_16_q) | (entries_17_there_q & end_17_q);
  logic or_1628;
  assign or_1628 = (entries_18_there_q & end_18_q) | (entries_19_there_q & end_19_q);
  logic or_1632;
  assign or_1632 = (entries_20_there_q & end_20_q) | (entries_21_there_q & end_21_q);
  logic or_1635;
  assign or_1635 = (entries_22_there_q & end_22_q) | (entries_23_there_q & end_23_q);
  logic or_1640;
  assign or_1640 = (entries_24_there_q & end_24_q) | (entries_25_there_q & end_25_q);
  logic or_1643;
  assign or_1643 = (entries_26_there_q & end_26_q) | (entries_27_there_q & end_27_q);
  logic or_1647;
  assign or_1647 = (entries_28_there_q & end_28_q) | (entries_29_there_q & end_29_q);
  logic or_1650;
  assign or_1650 = (entries_30_there_q & end_30_q) | (entries_31_there_q & end_31_q);
  logic or_1653;
  assign or_1653 = ((or_1625 | or_1628) | (or_1632 | or_1635)) | ((or_1640 | or_1643) | (or_1647 | or_1650));
  logic or_1654;
  assign or_1654 = ((or_1598 | or_1605) | (or_1613 | (or_1616 | or_1619))) | or_1653;
  // hls/stages/objects.hpp:96
  logic or_1663;
  assign or_1663 = ((and_440 & (or_1654 | (not_897 & not_1177))) | and_1658_s2_q) | (~(and_264_s2_q | (~overflow_q)));

  // Memory objects, 32 x 114, DISTANCE 2, hls/stages/objects.hpp:458; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [113:0] objects_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) objects_mem[i] = 114'h0;
`endif
  logic [4:0] objects_raddr;
  assign objects_raddr = label;
  logic objects_re;
  assign objects_re = s2_en & or_323;
  logic [113:0] objects_rdata_q;
  always_ff @(posedge clk_i) begin
    if (objects_re) objects_rdata_q <= objects_mem[objects_raddr];
  end

  // Memory queue, write
  logic [5:0] queue_waddr;
  assign queue_waddr = write_s2_q;
  logic queue_we;
  assign queue_we = s2_en & and_299_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (queue_we) queue_mem[queue_waddr] <= {last_run_row_q, last_run_right_q, last_run_left_q, and_295_s2_q, and_293_s2_q, select_277_s2_q};
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
      last_run_left_q <= 10'h0;
      last_run_right_q <= 10'h0;
      last_run_row_q <= 9'h0;
      busy_q <= 1'b0;
      draining_q <= 1'b0;
      done_q <= 1'b0;
      event_ends_q <= 1'b0;
      event_meets_q <= 1'b0;
      event_passes_q <= 1'b0;
      event_run_left_q <= 10'h0;
      event_run_right_q <= 10'h0;
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
      last_run_left_q <= select_381;
      last_run_right_q <= before_v_q ? x_2 : last_run_right_q;
      last_run_row_q <= before_v_q ? row_q : last_run_row_q;
      busy_q <= and_412;
      draining_q <= select_414;
      done_q <= and_420;
      event_ends_q <= and_264_s2_q ? event_ends_q : select_422;
      event_meets_q <= and_264_s2_q ? event_meets_q : select_425;
      event_passes_q <= and_264_s2_q ? event_passes_q : select_428;
      event_run_left_q <= and_264_s2_q ? event_run_left_q : select_431;
      event_run_right_q <= and_264_s2_q ? event_run_right_q : select_434;
      event_run_row_q <= and_264_s2_q ? event_run_row_q : select_437;
      entries_0_label_q <= select_448;
      entries_0_there_q <= and_456;
      entries_1_label_q <= select_461;
      entries_1_there_q <= and_466;
      entries_2_label_q <= select_471;
      entries_2_there_q <= and_476;
      entries_3_label_q <= select_481;
      entries_3_there_q <= and_486;
      entries_4_label_q <= select_491;
      entries_4_there_q <= and_496;
      entries_5_label_q <= select_501;
      entries_5_there_q <= and_506;
      entries_6_label_q <= select_511;
      entries_6_there_q <= and_516;
      entries_7_label_q <= select_521;
      entries_7_there_q <= and_526;
      entries_8_label_q <= select_531;
      entries_8_there_q <= and_536;
      entries_9_label_q <= select_541;
      entries_9_there_q <= and_546;
      entries_10_label_q <= select_551;
      entries_10_there_q <= and_556;
      entries_11_label_q <= select_561;
      entries_11_there_q <= and_566;
      entries_12_label_q <= select_571;
      entries_12_there_q <= and_576;
      entries_13_label_q <= select_581;
      entries_13_there_q <= and_586;
      entries_14_label_q <= select_591;
      entries_14_there_q <= and_596;
      entries_15_label_q <= select_601;
      entries_15_there_q <= and_606;
      entries_16_label_q <= select_611;
      entries_16_there_q <= and_616;
      entries_17_label_q <= select_621;
      entries_17_there_q <= and_626;
      entries_18_label_q <= select_631;
      entries_18_there_q <= and_636;
      entries_19_label_q <= select_641;
      entries_19_there_q <= and_646;
      entries_20_label_q <= select_651;
      entries_20_there_q <= and_656;
      entries_21_label_q <= select_661;
      entries_21_there_q <= and_666;
      entries_22_label_q <= select_671;
      entries_22_there_q <= and_676;
      entries_23_label_q <= select_681;
      entries_23_there_q <= and_686;
      entries_24_label_q <= select_691;
      entries_24_there_q <= and_696;
      entries_25_label_q <= select_701;
      entries_25_there_q <= and_706;
      entries_26_label_q <= select_711;
      entries_26_there_q <= and_716;
      entries_27_label_q <= select_721;
      entries_27_there_q <= and_726;
      entries_28_label_q <= select_731;
      entries_28_there_q <= and_736;
      entries_29_label_q <= select_741;
      entries_29_there_q <= and_746;
      entries_30_label_q <= select_751;
      entries_30_there_q <= and_756;
      entries_31_label_q <= select_761;
      entries_31_there_q <= and_766;
      begin_0_q <= or_767 ? (begin_31_q | and_264_s2_q) : begin_0_q;
      begin_1_q <= or_767 ? (begin_0_q & not_265_s2_q) : begin_1_q;
      begin_2_q <= or_767 ? (begin_1_q & not_265_s2_q) : begin_2_q;
      begin_3_q <= or_767 ? (begin_2_q & not_265_s2_q) : begin_3_q;
      begin_4_q <= or_767 ? (begin_3_q & not_265_s2_q) : begin_4_q;
      begin_5_q <= or_767 ? (begin_4_q & not_265_s2_q) : begin_5_q;
      begin_6_q <= or_767 ? (begin_5_q & not_265_s2_q) : begin_6_q;
      begin_7_q <= or_767 ? (begin_6_q & not_265_s2_q) : begin_7_q;
      begin_8_q <= or_767 ? (begin_7_q & not_265_s2_q) : begin_8_q;
      begin_9_q <= or_767 ? (begin_8_q & not_265_s2_q) : begin_9_q;
      begin_10_q <= or_767 ? (begin_9_q & not_265_s2_q) : begin_10_q;
      begin_11_q <= or_767 ? (begin_10_q & not_265_s2_q) : begin_11_q;
      begin_12_q <= or_767 ? (begin_11_q & not_265_s2_q) : begin_12_q;
      begin_13_q <= or_767 ? (begin_12_q & not_265_s2_q) : begin_13_q;
      begin_14_q <= or_767 ? (begin_13_q & not_265_s2_q) : begin_14_q;
      begin_15_q <= or_767 ? (begin_14_q & not_265_s2_q) : begin_15_q;
      begin_16_q <= or_767 ? (begin_15_q & not_265_s2_q) : begin_16_q;
      begin_17_q <= or_767 ? (begin_16_q & not_265_s2_q) : begin_17_q;
      begin_18_q <= or_767 ? (begin_17_q & not_265_s2_q) : begin_18_q;
      begin_19_q <= or_767 ? (begin_18_q & not_265_s2_q) : begin_19_q;
      begin_20_q <= or_767 ? (begin_19_q & not_265_s2_q) : begin_20_q;
      begin_21_q <= or_767 ? (begin_20_q & not_265_s2_q) : begin_21_q;
      begin_22_q <= or_767 ? (begin_21_q & not_265_s2_q) : begin_22_q;
      begin_23_q <= or_767 ? (begin_22_q & not_265_s2_q) : begin_23_q;
      begin_24_q <= or_767 ? (begin_23_q & not_265_s2_q) : begin_24_q;
      begin_25_q <= or_767 ? (begin_24_q & not_265_s2_q) : begin_25_q;
      begin_26_q <= or_767 ? (begin_25_q & not_265_s2_q) : begin_26_q;
      begin_27_q <= or_767 ? (begin_26_q & not_265_s2_q) : begin_27_q;
      begin_28_q <= or_767 ? (begin_27_q & not_265_s2_q) : begin_28_q;
      begin_29_q <= or_767 ? (begin_28_q & not_265_s2_q) : begin_29_q;
      begin_30_q <= or_767 ? (begin_29_q & not_265_s2_q) : begin_30_q;
      begin_31_q <= or_767 ? (begin_30_q & not_265_s2_q) : begin_31_q;
      end_0_q <= or_832 ? (end_31_q | and_264_s2_q) : end_0_q;
      end_1_q <= or_832 ? (end_0_q & not_265_s2_q) : end_1_q;
      end_2_q <= or_832 ? (end_1_q & not_265_s2_q) : end_2_q;
      end_3_q <= or_832 ? (end_2_q & not_265_s2_q) : end_3_q;
      end_4_q <= or_832 ? (end_3_q & not_265_s2_q) : end_4_q;
      end_5_q <= or_832 ? (end_4_q & not_265_s2_q) : end_5_q;
      end_6_q <= or_832 ? (end_5_q & not_265_s2_q) : end_6_q;
      end_7_q <= or_832 ? (end_6_q & not_265_s2_q) : end_7_q;
      end_8_q <= or_832 ? (end_7_q & not_265_s2_q) : end_8_q;
      end_9_q <= or_832 ? (end_8_q & not_265_s2_q) : end_9_q;
      end_10_q <= or_832 ? (end_9_q & not_265_s2_q) : end_10_q;
      end_11_q <= or_832 ? (end_10_q & not_265_s2_q) : end_11_q;
      end_12_q <= or_832 ? (end_11_q & not_265_s2_q) : end_12_q;
      end_13_q <= or_832 ? (end_12_q & not_265_s2_q) : end_13_q;
      end_14_q <= or_832 ? (end_13_q & not_265_s2_q) : end_14_q;
      end_15_q <= or_832 ? (end_14_q & not_265_s2_q) : end_15_q;
      end_16_q <= or_832 ? (end_15_q & not_265_s2_q) : end_16_q;
      end_17_q <= or_832 ? (end_16_q & not_265_s2_q) : end_17_q;
      end_18_q <= or_832 ? (end_17_q & not_265_s2_q) : end_18_q;
      end_19_q <= or_832 ? (end_18_q & not_265_s2_q) : end_19_q;
      end_20_q <= or_832 ? (end_19_q & not_265_s2_q) : end_20_q;
      end_21_q <= or_832 ? (end_20_q & not_265_s2_q) : end_21_q;
      end_22_q <= or_832 ? (end_21_q & not_265_s2_q) : end_22_q;
      end_23_q <= or_832 ? (end_22_q & not_265_s2_q) : end_23_q;
      end_24_q <= or_832 ? (end_23_q & not_265_s2_q) : end_24_q;
      end_25_q <= or_832 ? (end_24_q & not_265_s2_q) : end_25_q;
      end_26_q <= or_832 ? (end_25_q & not_265_s2_q) : end_26_q;
      end_27_q <= or_832 ? (end_26_q & not_265_s2_q) : end_27_q;
      end_28_q <= or_832 ? (end_27_q & not_265_s2_q) : end_28_q;
      end_29_q <= or_832 ? (end_28_q & not_265_s2_q) : end_29_q;
      end_30_q <= or_832 ? (end_29_q & not_265_s2_q) : end_30_q;
      end_31_q <= or_832 ? (end_30_q & not_265_s2_q) : end_31_q;
      run_label_q <= and_899 ? front_label_q : run_label_q;
      run_there_q <= and_905;
      used_0_q <= not_265_s2_q & or_923;
      used_1_q <= not_265_s2_q & or_932;
      used_2_q <= not_265_s2_q & or_941;
      used_3_q <= not_265_s2_q & or_950;
      used_4_q <= not_265_s2_q & or_958;
      used_5_q <= not_265_s2_q & or_966;
      used_6_q <= not_265_s2_q & or_974;
      used_7_q <= not_265_s2_q & or_982;
      used_8_q <= not_265_s2_q & or_990;
      used_9_q <= not_265_s2_q & or_998;
      used_10_q <= not_265_s2_q & or_1006;
      used_11_q <= not_265_s2_q & or_1014;
      used_12_q <= not_265_s2_q & or_1022;
      used_13_q <= not_265_s2_q & or_1030;
      used_14_q <= not_265_s2_q & or_1038;
      used_15_q <= not_265_s2_q & or_1046;
      used_16_q <= not_265_s2_q & or_1054;
      used_17_q <= not_265_s2_q & or_1062;
      used_18_q <= not_265_s2_q & or_1070;
      used_19_q <= not_265_s2_q & or_1078;
      used_20_q <= not_265_s2_q & or_1086;
      used_21_q <= not_265_s2_q & or_1094;
      used_22_q <= not_265_s2_q & or_1102;
      used_23_q <= not_265_s2_q & or_1110;
      used_24_q <= not_265_s2_q & or_1118;
      used_25_q <= not_265_s2_q & or_1126;
      used_26_q <= not_265_s2_q & or_1134;
      used_27_q <= not_265_s2_q & or_1142;
      used_28_q <= not_265_s2_q & or_1150;
      used_29_q <= not_265_s2_q & or_1158;
      used_30_q <= not_265_s2_q & or_1166;
      used_31_q <= not_265_s2_q & or_1174;
      free_label_q <= and_1179 ? found_label_q : free_label_q;
      free_there_q <= not_265_s2_q & (and_1179 | (free_there_q & (~and_1176)));
      found_label_q <= and_919 ? {at_group_q, or_1186, or_1185} : found_label_q;
      found_there_q <= not_265_s2_q & (and_919 | (found_there_q ^ and_1179));
      group_0_q <= and_264_s2_q | (and_1191 ? group_7_q : group_0_q);
      group_1_q <= not_265_s2_q & (and_1191 ? group_0_q : group_1_q);
      group_2_q <= not_265_s2_q & (and_1191 ? group_1_q : group_2_q);
      group_3_q <= not_265_s2_q & (and_1191 ? group_2_q : group_3_q);
      group_4_q <= not_265_s2_q & (and_1191 ? group_3_q : group_4_q);
      group_5_q <= not_265_s2_q & (and_1191 ? group_4_q : group_5_q);
      group_6_q <= not_265_s2_q & (and_1191 ? group_5_q : group_6_q);
      group_7_q <= not_265_s2_q & (and_1191 ? group_6_q : group_7_q);
      at_group_q <= and_264_s2_q ? 3'h0 : (at_group_q + {2'h0, and_1191});
      looked_q <= used_7;
      looked_there_q <= and_1253;
      front_label_q <= and_439 ? (or_1284 | or_1315) : front_label_q;
      front_there_q <= and_439 ? (or_1348 | or_1379) : front_there_q;
      label_q <= and_439 ? ended : label_q;
      fresh_q <= and_439 ? not_897 : fresh_q;
      same_0_q <= and_416 ? (and_1386 & (~begin_0_q)) : same_0_q;
      same_1_q <= and_416 ? (and_1392 & (~begin_1_q)) : same_1_q;
      same_2_q <= and_416 ? (and_1398 & (~begin_2_q)) : same_2_q;
      same_3_q <= and_416 ? (and_1404 & (~begin_3_q)) : same_3_q;
      same_4_q <= and_416 ? (and_1410 & (~begin_4_q)) : same_4_q;
      same_5_q <= and_416 ? (and_1416 & (~begin_5_q)) : same_5_q;
      same_6_q <= and_416 ? (and_1422 & (~begin_6_q)) : same_6_q;
      same_7_q <= and_416 ? (and_1428 & (~begin_7_q)) : same_7_q;
      same_8_q <= and_416 ? (and_1434 & (~begin_8_q)) : same_8_q;
      same_9_q <= and_416 ? (and_1440 & (~begin_9_q)) : same_9_q;
      same_10_q <= and_416 ? (and_1446 & (~begin_10_q)) : same_10_q;
      same_11_q <= and_416 ? (and_1452 & (~begin_11_q)) : same_11_q;
      same_12_q <= and_416 ? (and_1458 & (~begin_12_q)) : same_12_q;
      same_13_q <= and_416 ? (and_1464 & (~begin_13_q)) : same_13_q;
      same_14_q <= and_416 ? (and_1470 & (~begin_14_q)) : same_14_q;
      same_15_q <= and_416 ? (and_1476 & (~begin_15_q)) : same_15_q;
      same_16_q <= and_416 ? (and_1482 & (~begin_16_q)) : same_16_q;
      same_17_q <= and_416 ? (and_1488 & (~begin_17_q)) : same_17_q;
      same_18_q <= and_416 ? (and_1494 & (~begin_18_q)) : same_18_q;
      same_19_q <= and_416 ? (and_1500 & (~begin_19_q)) : same_19_q;
      same_20_q <= and_416 ? (and_1506 & (~begin_20_q)) : same_20_q;
      same_21_q <= and_416 ? (and_1512 & (~begin_21_q)) : same_21_q;
      same_22_q <= and_416 ? (and_1518 & (~begin_22_q)) : same_22_q;
      same_23_q <= and_416 ? (and_1524 & (~begin_23_q)) : same_23_q;
      same_24_q <= and_416 ? (and_1530 & (~begin_24_q)) : same_24_q;
      same_25_q <= and_416 ? (and_1536 & (~begin_25_q)) : same_25_q;
      same_26_q <= and_416 ? (and_1542 & (~begin_26_q)) : same_26_q;
      same_27_q <= and_416 ? (and_1548 & (~begin_27_q)) : same_27_q;
      same_28_q <= and_416 ? (and_1554 & (~begin_28_q)) : same_28_q;
      same_29_q <= and_416 ? (and_1560 & (~begin_29_q)) : same_29_q;
      same_30_q <= and_416 ? (and_1566 & (~begin_30_q)) : same_30_q;
      same_31_q <= and_416 ? (and_1572 & (~begin_31_q)) : same_31_q;
      others_q <= select_1582;
      joined_q <= select_1587;
      other_q <= and_320 ? (joined_q ? run_label_q : front_label_q) : other_q;
      second_q <= equal_266_s2_q ? frees : second_q;
      second_ends_q <= equal_266_s2_q ? closes : second_ends_q;
      overflow_q <= or_1663;
    end
  end

  logic [9:0] event_run_left_s3_q;
  logic [9:0] event_run_right_s3_q;
  logic [8:0] event_run_row_s3_q;
  logic not_265_s3_q;
  logic and_301_s3_q;
  logic [4:0] label_s3_q;
  logic or_323_s3_q;
  logic and_325_s3_q;
  logic not_361_s3_q;
  logic and_1677_s3_q;
  logic and_1685_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      event_run_left_s3_q <= event_run_left_q;
      event_run_right_s3_q <= event_run_right_q;
      event_run_row_s3_q <= event_run_row_q;
      not_265_s3_q <= not_265_s2_q;
      and_301_s3_q <= and_301;
      label_s3_q <= label;
      or_323_s3_q <= or_323;
      and_325_s3_q <= fresh_q & and_322;
      not_361_s3_q <= ~(and_301 ? second_ends_q : joined_q);
      and_1677_s3_q <= second_ends_q & and_301;
      and_1685_s3_q <= idle_s2_q & and_420;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [18:0] joining_pixels_q;
  logic [9:0] joining_left_q;
  logic [9:0] joining_right_q;
  logic [8:0] joining_top_q;
  logic [8:0] joining_bottom_q;
  logic [28:0] joining_columns_q;
  logic [27:0] joining_rows_q;
  logic alarm_q;
  // hls/stages/objects.hpp:394
  logic [9:0] pixels;
  assign pixels = (event_run_right_s3_q - event_run_left_s3_q) + 10'h1;
  // hls/stages/objects.hpp:405
  logic [18:0] sum_329;
  assign sum_329 = objects_rdata_q[18:0] + (and_301_s3_q ? joining_pixels_q : {9'h0, pixels});
  // hls/stages/objects.hpp:383
  logic [18:0] select_330;
  assign select_330 = and_325_s3_q ? {9'h0, pixels} : sum_329;
  // hls/stages/objects.hpp:377
  logic [9:0] select_331;
  assign select_331 = and_301_s3_q ? joining_left_q : event_run_left_s3_q;
  // hls/stages/objects.hpp:406
  logic [9:0] select_333;
  assign select_333 = (select_331 < objects_rdata_q[28:19]) ? select_331 : objects_rdata_q[28:19];
  // hls/stages/objects.hpp:383
  logic [9:0] select_334;
  assign select_334 = and_325_s3_q ? event_run_left_s3_q : select_333;
  // hls/stages/objects.hpp:377
  logic [9:0] select_335;
  assign select_335 = and_301_s3_q ? joining_right_q : event_run_right_s3_q;
  // hls/stages/objects.hpp:407
  logic [9:0] select_337;
  assign select_337 = (objects_rdata_q[38:29] < select_335) ? select_335 : objects_rdata_q[38:29];
  // hls/stages/objects.hpp:383
  logic [9:0] select_338;
  assign select_338 = and_325_s3_q ? event_run_right_s3_q : select_337;
  // hls/stages/objects.hpp:377
  logic [8:0] select_339;
  assign select_339 = and_301_s3_q ? joining_top_q : event_run_row_s3_q;
  // hls/stages/objects.hpp:408
  logic [8:0] select_341;
  assign select_341 = (select_339 < objects_rdata_q[47:39]) ? select_339 : objects_rdata_q[47:39];
  // hls/stages/objects.hpp:383
  logic [8:0] select_342;
  assign select_342 = and_325_s3_q ? event_run_row_s3_q : select_341;
  // hls/stages/objects.hpp:377
  logic [8:0] select_343;
  assign select_343 = and_301_s3_q ? joining_bottom_q : event_run_row_s3_q;
  // hls/stages/objects.hpp:409
  logic [8:0] select_345;
  assign select_345 = (objects_rdata_q[56:48] < select_343) ? select_343 : objects_rdata_q[56:48];
  // hls/stages/objects.hpp:383
  logic [8:0] select_346;
  assign select_346 = and_325_s3_q ? event_run_row_s3_q : select_345;
  // hls/stages/objects.hpp:399
  logic [10:0] sum_347;
  assign sum_347 = {1'b0, event_run_left_s3_q} + {1'b0, event_run_right_s3_q};
  logic [20:0] product_348;
  assign product_348 = {11'h0, pixels} * {10'h0, sum_347};
  // hls/stages/objects.hpp:377
  logic [28:0] b;
  assign b = and_301_s3_q ? joining_columns_q : {9'h0, product_348[20:1]};
  // hls/stages/objects.hpp:417
  logic [16:0] low;
  assign low = {1'b0, objects_rdata_q[72:57]} + {1'b0, b[15:0]};
  // hls/stages/objects.hpp:419
  logic [12:0] sum_352;
  assign sum_352 = {12'h0, low[16]} + (objects_rdata_q[85:73] + b[28:16]);
  // hls/stages/objects.hpp:383
  logic [28:0] select_353;
  assign select_353 = and_325_s3_q ? {9'h0, product_348[20:1]} : {sum_352, low[15:0]};
  // hls/stages/objects.hpp:400
  logic [18:0] product_354;
  assign product_354 = {10'h0, event_run_row_s3_q} * {9'h0, pixels};
  // hls/stages/objects.hpp:377
  logic [27:0] b_2;
  assign b_2 = and_301_s3_q ? joining_rows_q : {9'h0, product_354};
  // hls/stages/objects.hpp:417
  logic [16:0] low_2;
  assign low_2 = {1'b0, objects_rdata_q[101:86]} + {1'b0, b_2[15:0]};
  // hls/stages/objects.hpp:419
  logic [11:0] sum_358;
  assign sum_358 = {11'h0, low_2[16]} + (objects_rdata_q[113:102] + b_2[27:16]);
  // hls/stages/objects.hpp:383
  logic [27:0] select_359;
  assign select_359 = and_325_s3_q ? {9'h0, product_354} : {sum_358, low_2[15:0]};
  // hls/stages/objects.hpp:88
  logic and_1674;
  assign and_1674 = or_323_s3_q & (not_361_s3_q & (~(select_330 < cfg_object_limit_i)));

  // Memory objects, write
  logic [4:0] objects_waddr;
  assign objects_waddr = label_s3_q;
  logic objects_we;
  assign objects_we = s3_en & (not_361_s3_q & or_323_s3_q);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (objects_we) objects_mem[objects_waddr] <= {select_359, select_353, select_346, select_342, select_338, select_334, select_330};
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
      joining_pixels_q <= 19'h0;
      joining_left_q <= 10'h0;
      joining_right_q <= 10'h0;
      joining_top_q <= 9'h0;
      joining_bottom_q <= 9'h0;
      joining_columns_q <= 29'h0;
      joining_rows_q <= 28'h0;
      alarm_q <= 1'b0;
    end else if (s3_en) begin
      joining_pixels_q <= or_323_s3_q ? objects_rdata_q[18:0] : joining_pixels_q;
      joining_left_q <= or_323_s3_q ? objects_rdata_q[28:19] : joining_left_q;
      joining_right_q <= or_323_s3_q ? objects_rdata_q[38:29] : joining_right_q;
      joining_top_q <= or_323_s3_q ? objects_rdata_q[47:39] : joining_top_q;
      joining_bottom_q <= or_323_s3_q ? objects_rdata_q[56:48] : joining_bottom_q;
      joining_columns_q <= or_323_s3_q ? objects_rdata_q[85:57] : joining_columns_q;
      joining_rows_q <= or_323_s3_q ? objects_rdata_q[113:86] : joining_rows_q;
      alarm_q <= and_1674 | (alarm_q & not_265_s3_q);
    end
  end

  logic or_1663_s4_q;
  logic and_1677_s4_q;
  logic [18:0] select_1678_s4_q;
  logic [9:0] select_1679_s4_q;
  logic [9:0] select_1680_s4_q;
  logic [8:0] select_1681_s4_q;
  logic [8:0] select_1682_s4_q;
  logic [28:0] select_1683_s4_q;
  logic [27:0] select_1684_s4_q;
  logic and_1685_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      or_1663_s4_q <= overflow_q;
      and_1677_s4_q <= and_1677_s3_q;
      select_1678_s4_q <= or_323_s3_q ? objects_rdata_q[18:0] : 19'h0;
      select_1679_s4_q <= or_323_s3_q ? objects_rdata_q[28:19] : 10'h0;
      select_1680_s4_q <= or_323_s3_q ? objects_rdata_q[38:29] : 10'h0;
      select_1681_s4_q <= or_323_s3_q ? objects_rdata_q[47:39] : 9'h0;
      select_1682_s4_q <= or_323_s3_q ? objects_rdata_q[56:48] : 9'h0;
      select_1683_s4_q <= or_323_s3_q ? objects_rdata_q[85:57] : 29'h0;
      select_1684_s4_q <= or_323_s3_q ? objects_rdata_q[113:86] : 28'h0;
      and_1685_s4_q <= and_1685_s3_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign ended_o = and_1677_s4_q;
  assign object_pixels_o = select_1678_s4_q;
  assign object_left_o = select_1679_s4_q;
  assign object_right_o = select_1680_s4_q;
  assign object_top_o = select_1681_s4_q;
  assign object_bottom_o = select_1682_s4_q;
  assign object_columns_o = select_1683_s4_q;
  assign object_rows_o = select_1684_s4_q;
  assign alarm_o = alarm_q;
  assign overflow_o = or_1663_s4_q;
  assign done_o = and_1685_s4_q;
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
  assign unused_bits = ^product_348[0];

endmodule
