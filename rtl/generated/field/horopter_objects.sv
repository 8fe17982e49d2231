// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Objects<horopter::hls::profiles::field>, hls/stages/objects.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 718 bits, pipeline 301 bits, memories 9658 bits.
module horopter_objects (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic occupied_i,
  input  logic first_i,
  input  logic last_i,
  input  logic idle_i,
  input  logic [7:0] area_i,
  input  logic blind_i,
  input  logic [16:0] cfg_object_limit_i,
  input  logic [31:0] cfg_object_area_limit_i,
  output logic valid_o,
  output logic ended_o,
  output logic [16:0] object_pixels_o,
  output logic [16:0] object_blind_o,
  output logic [31:0] object_area_o,
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

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [8:0] raster_column_q;
  logic raster_rows_q;
  logic raster_row_ended_q;
  // hls/stages/objects.hpp:213
  logic or_268;
  assign or_268 = first_i | raster_row_ended_q;
  logic [8:0] x;
  assign x = or_268 ? 9'h0 : (raster_column_q + 9'h1);
  // hls/stages/objects.hpp:87
  logic not_271;
  assign not_271 = ~idle_i;
  // hls/stages/objects.hpp:213
  logic and_289;
  assign and_289 = raster_rows_q & (~first_i);

  // Memory above, 378 x 1, DISTANCE 16, hls/stages/objects.hpp:448; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic above_mem [0:377];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 378; i++) above_mem[i] = 1'b0;
`endif
  logic [8:0] above_raddr;
  assign above_raddr = x;
`ifndef SYNTHESIS
  logic above_re;
  assign above_re = s0_en & not_271;
`endif
  logic above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 9'h0;
      raster_rows_q <= 1'b0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= idle_i ? raster_column_q : x;
      raster_rows_q <= idle_i ? raster_rows_q : (last_i | and_289);
      raster_row_ended_q <= idle_i ? raster_row_ended_q : last_i;
    end
  end

  logic occupied_s1_q;
  logic idle_s1_q;
  logic [7:0] area_s1_q;
  logic blind_s1_q;
  logic [8:0] x_s1_q;
  logic not_271_s1_q;
  logic and_273_s1_q;
  logic or_282_s1_q;
  logic and_289_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      occupied_s1_q <= occupied_i;
      idle_s1_q <= idle_i;
      area_s1_q <= area_i;
      blind_s1_q <= blind_i;
      x_s1_q <= x;
      not_271_s1_q <= not_271;
      and_273_s1_q <= first_i & not_271;
      or_282_s1_q <= idle_i | or_268;
      and_289_s1_q <= and_289;
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
  // hls/stages/objects.hpp:88
  logic not_274;
  assign not_274 = ~and_273_s1_q;
  // hls/stages/objects.hpp:272
  logic equal_275;
  assign equal_275 = phase_q == 2'h0;
  // hls/stages/objects.hpp:374
  logic equal_276;
  assign equal_276 = read_q == visible_q;
  logic not_277;
  assign not_277 = ~equal_276;
  // hls/stages/objects.hpp:225
  logic and_281;
  assign and_281 = ended_q & not_274;
  // hls/stages/objects.hpp:223
  logic not_283;
  assign not_283 = ~or_282_s1_q;
  // hls/stages/objects.hpp:225
  logic and_285;
  assign and_285 = before_v_q & not_274;
  logic select_286;
  assign select_286 = (and_281 | not_283) ? and_281 : and_285;
  logic and_287;
  assign and_287 = over_before_q & not_274;
  // hls/stages/objects.hpp:100
  logic and_291;
  assign and_291 = not_271_s1_q & (above_rdata_q & and_289_s1_q);
  // hls/stages/objects.hpp:223
  logic and_292;
  assign and_292 = and_291 & not_283;
  // hls/stages/objects.hpp:100
  logic and_294;
  assign and_294 = occupied_s1_q & not_271_s1_q;
  logic and_297;
  assign and_297 = (and_287 | and_292) & (not_283 & (and_294 | and_285));
  // hls/stages/objects.hpp:230
  logic and_300;
  assign and_300 = (met_q & not_274) & (~select_286);
  // hls/stages/objects.hpp:231
  logic and_302;
  assign and_302 = and_297 & (~and_300);
  // hls/stages/objects.hpp:226
  logic and_304;
  assign and_304 = and_287 & (~and_292);
  // hls/stages/objects.hpp:232
  logic or_306;
  assign or_306 = and_304 | (select_286 | and_302);
  // hls/stages/objects.hpp:243
  logic [8:0] select_382;
  assign select_382 = (idle_s1_q | not_283) ? row_q : (and_273_s1_q ? 9'h0 : (row_q + 9'h1));
  // hls/stages/objects.hpp:240
  logic [5:0] select_409;
  assign select_409 = and_273_s1_q ? 6'h0 : (or_306 ? (little_room_q ? write_q : (write_q + 6'h1)) : write_q);
  // hls/stages/objects.hpp:99
  logic [5:0] select_413;
  assign select_413 = and_273_s1_q ? 6'h0 : (equal_275 ? (equal_276 ? read_q : (read_q + 6'h1)) : read_q);
  // hls/stages/objects.hpp:89
  logic [5:0] room;
  assign room = read_q - write_q;
  // hls/stages/objects.hpp:88
  logic little_room;
  assign little_room = not_274 & (({2'h0, room_q} + 8'hff) < 8'h7);
  // hls/stages/objects.hpp:327
  logic and_430;
  assign and_430 = (write_q == read_q) & ((~before_v_q) & ((~over_before_q) & (~ended_q)));

  // Memory queue, 64 x 68, DISTANCE 4, hls/stages/objects.hpp:455; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [67:0] queue_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) queue_mem[i] = 68'h0;
`endif
  logic [5:0] queue_raddr;
  assign queue_raddr = read_q;
`ifndef SYNTHESIS
  logic queue_re;
  assign queue_re = s1_en & (not_274 & (equal_275 & not_277));
`endif
  logic [67:0] queue_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) queue_rdata_q <= queue_mem[queue_raddr];
  end

  // Memory above, write
  logic [8:0] above_waddr;
  assign above_waddr = x_s1_q;
  logic above_we;
  assign above_we = s1_en & not_271_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= occupied_s1_q;
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
      before_v_q <= and_294;
      over_before_q <= and_291;
      ended_q <= not_283 & (and_285 & (~and_294));
      met_q <= (and_297 | and_300) & (~and_304);
      row_q <= select_382;
      write_q <= select_409;
      read_q <= select_413;
      visible_q <= and_273_s1_q ? 6'h0 : (equal_275 ? write_q : visible_q);
      room_q <= and_273_s1_q ? 6'h0 : room;
      little_room_q <= little_room;
      phase_q <= phase_q + 2'h1;
    end
  end

  logic idle_s2_q;
  logic [7:0] area_s2_q;
  logic blind_s2_q;
  logic [5:0] write_s2_q;
  logic [1:0] phase_s2_q;
  logic [8:0] x_s2_q;
  logic and_273_s2_q;
  logic not_274_s2_q;
  logic equal_275_s2_q;
  logic equal_276_s2_q;
  logic not_277_s2_q;
  logic select_286_s2_q;
  logic and_302_s2_q;
  logic and_304_s2_q;
  logic and_308_s2_q;
  logic or_384_s2_q;
  logic and_431_s2_q;
  logic and_1686_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      idle_s2_q <= idle_s1_q;
      area_s2_q <= area_s1_q;
      blind_s2_q <= blind_s1_q;
      write_s2_q <= write_q;
      phase_s2_q <= phase_q;
      x_s2_q <= x_s1_q;
      and_273_s2_q <= and_273_s1_q;
      not_274_s2_q <= not_274;
      equal_275_s2_q <= equal_275;
      equal_276_s2_q <= equal_276;
      not_277_s2_q <= not_277;
      select_286_s2_q <= select_286;
      and_302_s2_q <= and_302;
      and_304_s2_q <= and_304;
      and_308_s2_q <= or_306 & (~little_room_q);
      or_384_s2_q <= or_282_s1_q | (~and_285);
      and_431_s2_q <= (~(not_271_s1_q | not_277)) & and_430;
      and_1686_s2_q <= little_room_q & or_306;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [8:0] last_run_left_q;
  logic [8:0] last_run_right_q;
  logic [8:0] last_run_row_q;
  logic [28:0] last_run_area_q;
  logic [8:0] last_run_blind_q;
  logic busy_q;
  logic draining_q;
  logic done_q;
  logic event_ends_q;
  logic event_meets_q;
  logic event_passes_q;
  logic [8:0] event_run_left_q;
  logic [8:0] event_run_right_q;
  logic [8:0] event_run_row_q;
  logic [28:0] event_run_area_q;
  logic [8:0] event_run_blind_q;
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
  // hls/stages/objects.hpp:391
  logic equal_309;
  assign equal_309 = phase_s2_q == 2'h1;
  logic and_310;
  assign and_310 = second_q & equal_309;
  // hls/stages/objects.hpp:400
  logic not_311;
  assign not_311 = ~joined_q;
  logic or_312;
  assign or_312 = and_310 | not_311;
  logic [4:0] label;
  assign label = and_310 ? (or_312 ? other_q : {4'h0, others_q}) : (or_312 ? label_q : front_label_q);
  // hls/stages/objects.hpp:392
  logic and_317;
  assign and_317 = busy_q & (phase_s2_q == 2'h3);
  logic and_319;
  assign and_319 = and_317 & (event_ends_q | joined_q);
  // hls/stages/objects.hpp:399
  logic or_320;
  assign or_320 = and_310 | and_319;
  // hls/stages/objects.hpp:100
  logic [8:0] x_2;
  assign x_2 = idle_s2_q ? last_run_right_q : x_s2_q;
  // hls/stages/objects.hpp:254
  logic [8:0] select_387;
  assign select_387 = before_v_q ? (or_384_s2_q ? x_2 : last_run_left_q) : last_run_left_q;
  // hls/stages/objects.hpp:249
  logic [3:0] select_392;
  assign select_392 = area_s2_q[3] ? {area_s2_q[2:0], 1'b0} : {1'b1, area_s2_q[2:0]};
  logic [6:0] select_393;
  assign select_393 = area_s2_q[4] ? {area_s2_q[3], select_392, 2'h0} : {2'h0, area_s2_q[3], select_392};
  logic [10:0] select_394;
  assign select_394 = area_s2_q[5] ? {select_393, 4'h0} : {4'h0, select_393};
  logic [18:0] select_395;
  assign select_395 = area_s2_q[6] ? {select_394, 8'h0} : {8'h0, select_394};
  logic [24:0] select_396;
  assign select_396 = area_s2_q[7] ? {select_395[8:0], 16'h0} : {6'h0, select_395};
  logic not_398;
  assign not_398 = ~(select_396[4:0] == 5'h0);
  logic [3:0] sum_399;
  assign sum_399 = select_396[8:5] + {3'h0, not_398};
  logic [19:0] select_400;
  assign select_400 = (4'ha < area_s2_q[7:4]) ? 20'hfffff : {select_396[24:9], sum_399};
  // hls/stages/objects.hpp:254
  logic [28:0] select_402;
  assign select_402 = before_v_q ? ((or_384_s2_q ? 29'h0 : last_run_area_q) + {9'h0, select_400}) : last_run_area_q;
  logic [8:0] select_405;
  assign select_405 = before_v_q ? ({8'h0, blind_s2_q} + (or_384_s2_q ? 9'h0 : last_run_blind_q)) : last_run_blind_q;
  // hls/stages/objects.hpp:99
  logic and_434;
  assign and_434 = not_274_s2_q & (equal_275_s2_q ? (not_277_s2_q | and_431_s2_q) : busy_q);
  logic select_436;
  assign select_436 = and_273_s2_q ? draining_q : (equal_275_s2_q ? and_431_s2_q : draining_q);
  // hls/stages/objects.hpp:271
  logic and_438;
  assign and_438 = busy_q & (phase_s2_q == 2'h2);
  // hls/stages/objects.hpp:99
  logic and_442;
  assign and_442 = not_274_s2_q & (and_438 ? (draining_q & (~front_there_q)) : done_q);
  logic select_444;
  assign select_444 = equal_275_s2_q ? (queue_rdata_q[0] & not_277_s2_q) : event_ends_q;
  logic select_447;
  assign select_447 = equal_275_s2_q ? (queue_rdata_q[1] & not_277_s2_q) : event_meets_q;
  logic select_450;
  assign select_450 = equal_275_s2_q ? (queue_rdata_q[2] | equal_276_s2_q) : event_passes_q;
  logic [8:0] select_453;
  assign select_453 = equal_275_s2_q ? (equal_276_s2_q ? event_run_left_q : queue_rdata_q[11:3]) : event_run_left_q;
  logic [8:0] select_456;
  assign select_456 = equal_275_s2_q ? (equal_276_s2_q ? event_run_right_q : queue_rdata_q[20:12]) : event_run_right_q;
  logic [8:0] select_459;
  assign select_459 = equal_275_s2_q ? (equal_276_s2_q ? event_run_row_q : queue_rdata_q[29:21]) : event_run_row_q;
  logic [28:0] select_462;
  assign select_462 = equal_275_s2_q ? (equal_276_s2_q ? event_run_area_q : queue_rdata_q[58:30]) : event_run_area_q;
  logic [8:0] select_465;
  assign select_465 = equal_275_s2_q ? (equal_276_s2_q ? event_run_blind_q : queue_rdata_q[67:59]) : event_run_blind_q;
  // hls/stages/objects.hpp:271
  logic and_467;
  assign and_467 = busy_q & equal_309;
  // hls/stages/objects.hpp:275
  logic and_468;
  assign and_468 = event_ends_q & and_467;
  // hls/stages/objects.hpp:315
  logic and_469;
  assign and_469 = end_0_q & and_468;
  // hls/stages/objects.hpp:295
  logic and_470;
  assign and_470 = joined_q & and_317;
  // hls/stages/objects.hpp:276
  logic [4:0] ended;
  assign ended = run_there_q ? run_label_q : free_label_q;
  // hls/stages/objects.hpp:310
  logic [4:0] label_2;
  assign label_2 = and_468 ? ended : run_label_q;
  // hls/stages/objects.hpp:317
  logic [4:0] select_476;
  assign select_476 = (and_469 | (and_470 & (begin_0_q | same_0_q))) ? label_2 : entries_0_label_q;
  // hls/stages/objects.hpp:272
  logic and_477;
  assign and_477 = busy_q & equal_275_s2_q;
  // hls/stages/objects.hpp:301
  logic and_479;
  assign and_479 = front_there_q & (event_passes_q & and_477);
  // hls/stages/objects.hpp:317
  logic and_484;
  assign and_484 = not_274_s2_q & (and_469 | (entries_0_there_q & (~(begin_0_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_485;
  assign and_485 = end_1_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_489;
  assign select_489 = (and_485 | (and_470 & (begin_1_q | same_1_q))) ? label_2 : entries_1_label_q;
  logic and_494;
  assign and_494 = not_274_s2_q & (and_485 | (entries_1_there_q & (~(begin_1_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_495;
  assign and_495 = end_2_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_499;
  assign select_499 = (and_495 | (and_470 & (begin_2_q | same_2_q))) ? label_2 : entries_2_label_q;
  logic and_504;
  assign and_504 = not_274_s2_q & (and_495 | (entries_2_there_q & (~(begin_2_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_505;
  assign and_505 = end_3_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_509;
  assign select_509 = (and_505 | (and_470 & (begin_3_q | same_3_q))) ? label_2 : entries_3_label_q;
  logic and_514;
  assign and_514 = not_274_s2_q & (and_505 | (entries_3_there_q & (~(begin_3_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_515;
  assign and_515 = end_4_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_519;
  assign select_519 = (and_515 | (and_470 & (begin_4_q | same_4_q))) ? label_2 : entries_4_label_q;
  logic and_524;
  assign and_524 = not_274_s2_q & (and_515 | (entries_4_there_q & (~(begin_4_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_525;
  assign and_525 = end_5_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_529;
  assign select_529 = (and_525 | (and_470 & (begin_5_q | same_5_q))) ? label_2 : entries_5_label_q;
  logic and_534;
  assign and_534 = not_274_s2_q & (and_525 | (entries_5_there_q & (~(begin_5_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_535;
  assign and_535 = end_6_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_539;
  assign select_539 = (and_535 | (and_470 & (begin_6_q | same_6_q))) ? label_2 : entries_6_label_q;
  logic and_544;
  assign and_544 = not_274_s2_q & (and_535 | (entries_6_there_q & (~(begin_6_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_545;
  assign and_545 = end_7_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_549;
  assign select_549 = (and_545 | (and_470 & (begin_7_q | same_7_q))) ? label_2 : entries_7_label_q;
  logic and_554;
  assign and_554 = not_274_s2_q & (and_545 | (entries_7_there_q & (~(begin_7_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_555;
  assign and_555 = end_8_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_559;
  assign select_559 = (and_555 | (and_470 & (begin_8_q | same_8_q))) ? label_2 : entries_8_label_q;
  logic and_564;
  assign and_564 = not_274_s2_q & (and_555 | (entries_8_there_q & (~(begin_8_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_565;
  assign and_565 = end_9_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_569;
  assign select_569 = (and_565 | (and_470 & (begin_9_q | same_9_q))) ? label_2 : entries_9_label_q;
  logic and_574;
  assign and_574 = not_274_s2_q & (and_565 | (entries_9_there_q & (~(begin_9_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_575;
  assign and_575 = end_10_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_579;
  assign select_579 = (and_575 | (and_470 & (begin_10_q | same_10_q))) ? label_2 : entries_10_label_q;
  logic and_584;
  assign and_584 = not_274_s2_q & (and_575 | (entries_10_there_q & (~(begin_10_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_585;
  assign and_585 = end_11_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_589;
  assign select_589 = (and_585 | (and_470 & (begin_11_q | same_11_q))) ? label_2 : entries_11_label_q;
  logic and_594;
  assign and_594 = not_274_s2_q & (and_585 | (entries_11_there_q & (~(begin_11_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_595;
  assign and_595 = end_12_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_599;
  assign select_599 = (and_595 | (and_470 & (begin_12_q | same_12_q))) ? label_2 : entries_12_label_q;
  logic and_604;
  assign and_604 = not_274_s2_q & (and_595 | (entries_12_there_q & (~(begin_12_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_605;
  assign and_605 = end_13_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_609;
  assign select_609 = (and_605 | (and_470 & (begin_13_q | same_13_q))) ? label_2 : entries_13_label_q;
  logic and_614;
  assign and_614 = not_274_s2_q & (and_605 | (entries_13_there_q & (~(begin_13_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_615;
  assign and_615 = end_14_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_619;
  assign select_619 = (and_615 | (and_470 & (begin_14_q | same_14_q))) ? label_2 : entries_14_label_q;
  logic and_624;
  assign and_624 = not_274_s2_q & (and_615 | (entries_14_there_q & (~(begin_14_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_625;
  assign and_625 = end_15_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_629;
  assign select_629 = (and_625 | (and_470 & (begin_15_q | same_15_q))) ? label_2 : entries_15_label_q;
  logic and_634;
  assign and_634 = not_274_s2_q & (and_625 | (entries_15_there_q & (~(begin_15_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_635;
  assign and_635 = end_16_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_639;
  assign select_639 = (and_635 | (and_470 & (begin_16_q | same_16_q))) ? label_2 : entries_16_label_q;
  logic and_644;
  assign and_644 = not_274_s2_q & (and_635 | (entries_16_there_q & (~(begin_16_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_645;
  assign and_645 = end_17_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_649;
  assign select_649 = (and_645 | (and_470 & (begin_17_q | same_17_q))) ? label_2 : entries_17_label_q;
  logic and_654;
  assign and_654 = not_274_s2_q & (and_645 | (entries_17_there_q & (~(begin_17_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_655;
  assign and_655 = end_18_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_659;
  assign select_659 = (and_655 | (and_470 & (begin_18_q | same_18_q))) ? label_2 : entries_18_label_q;
  logic and_664;
  assign and_664 = not_274_s2_q & (and_655 | (entries_18_there_q & (~(begin_18_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_665;
  assign and_665 = end_19_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_669;
  assign select_669 = (and_665 | (and_470 & (begin_19_q | same_19_q))) ? label_2 : entries_19_label_q;
  logic and_674;
  assign and_674 = not_274_s2_q & (and_665 | (entries_19_there_q & (~(begin_19_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_675;
  assign and_675 = end_20_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_679;
  assign select_679 = (and_675 | (and_470 & (begin_20_q | same_20_q))) ? label_2 : entries_20_label_q;
  logic and_684;
  assign and_684 = not_274_s2_q & (and_675 | (entries_20_there_q & (~(begin_20_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_685;
  assign and_685 = end_21_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_689;
  assign select_689 = (and_685 | (and_470 & (begin_21_q | same_21_q))) ? label_2 : entries_21_label_q;
  logic and_694;
  assign and_694 = not_274_s2_q & (and_685 | (entries_21_there_q & (~(begin_21_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_695;
  assign and_695 = end_22_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_699;
  assign select_699 = (and_695 | (and_470 & (begin_22_q | same_22_q))) ? label_2 : entries_22_label_q;
  logic and_704;
  assign and_704 = not_274_s2_q & (and_695 | (entries_22_there_q & (~(begin_22_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_705;
  assign and_705 = end_23_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_709;
  assign select_709 = (and_705 | (and_470 & (begin_23_q | same_23_q))) ? label_2 : entries_23_label_q;
  logic and_714;
  assign and_714 = not_274_s2_q & (and_705 | (entries_23_there_q & (~(begin_23_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_715;
  assign and_715 = end_24_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_719;
  assign select_719 = (and_715 | (and_470 & (begin_24_q | same_24_q))) ? label_2 : entries_24_label_q;
  logic and_724;
  assign and_724 = not_274_s2_q & (and_715 | (entries_24_there_q & (~(begin_24_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_725;
  assign and_725 = end_25_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_729;
  assign select_729 = (and_725 | (and_470 & (begin_25_q | same_25_q))) ? label_2 : entries_25_label_q;
  logic and_734;
  assign and_734 = not_274_s2_q & (and_725 | (entries_25_there_q & (~(begin_25_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_735;
  assign and_735 = end_26_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_739;
  assign select_739 = (and_735 | (and_470 & (begin_26_q | same_26_q))) ? label_2 : entries_26_label_q;
  logic and_744;
  assign and_744 = not_274_s2_q & (and_735 | (entries_26_there_q & (~(begin_26_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_745;
  assign and_745 = end_27_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_749;
  assign select_749 = (and_745 | (and_470 & (begin_27_q | same_27_q))) ? label_2 : entries_27_label_q;
  logic and_754;
  assign and_754 = not_274_s2_q & (and_745 | (entries_27_there_q & (~(begin_27_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_755;
  assign and_755 = end_28_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_759;
  assign select_759 = (and_755 | (and_470 & (begin_28_q | same_28_q))) ? label_2 : entries_28_label_q;
  logic and_764;
  assign and_764 = not_274_s2_q & (and_755 | (entries_28_there_q & (~(begin_28_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_765;
  assign and_765 = end_29_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_769;
  assign select_769 = (and_765 | (and_470 & (begin_29_q | same_29_q))) ? label_2 : entries_29_label_q;
  logic and_774;
  assign and_774 = not_274_s2_q & (and_765 | (entries_29_there_q & (~(begin_29_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_775;
  assign and_775 = end_30_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_779;
  assign select_779 = (and_775 | (and_470 & (begin_30_q | same_30_q))) ? label_2 : entries_30_label_q;
  logic and_784;
  assign and_784 = not_274_s2_q & (and_775 | (entries_30_there_q & (~(begin_30_q & and_479))));
  // hls/stages/objects.hpp:315
  logic and_785;
  assign and_785 = end_31_q & and_468;
  // hls/stages/objects.hpp:317
  logic [4:0] select_789;
  assign select_789 = (and_785 | (and_470 & (begin_31_q | same_31_q))) ? label_2 : entries_31_label_q;
  logic and_794;
  assign and_794 = not_274_s2_q & (and_785 | (entries_31_there_q & (~(begin_31_q & and_479))));
  // hls/stages/objects.hpp:321
  logic or_795;
  assign or_795 = and_273_s2_q | and_479;
  // hls/stages/objects.hpp:322
  logic or_860;
  assign or_860 = and_273_s2_q | and_468;
  // hls/stages/objects.hpp:275
  logic not_925;
  assign not_925 = ~run_there_q;
  // hls/stages/objects.hpp:286
  logic and_927;
  assign and_927 = not_925 & (event_meets_q & and_438);
  // hls/stages/objects.hpp:293
  logic and_933;
  assign and_933 = not_274_s2_q & ((run_there_q & (~and_468)) | (front_there_q & and_927));
  // hls/stages/objects.hpp:302
  logic closes;
  assign closes = (not_311 & and_479) & (~others_q);
  logic frees;
  assign frees = closes | (joined_q & and_477);
  // hls/stages/objects.hpp:318
  logic not_941;
  assign not_941 = ~frees;
  // hls/stages/objects.hpp:339
  logic and_944;
  assign and_944 = looked_there_q & not_274_s2_q;
  // hls/stages/objects.hpp:337
  logic equal_945;
  assign equal_945 = looked_q == 4'hf;
  // hls/stages/objects.hpp:340
  logic and_947;
  assign and_947 = and_944 & (~equal_945);
  // hls/stages/objects.hpp:336
  logic not_948;
  assign not_948 = ~looked_q[0];
  // hls/stages/objects.hpp:319
  logic or_951;
  assign or_951 = (used_0_q & ((~(front_label_q == 5'h0)) | not_941)) | (and_947 & (group_0_q & not_948));
  // hls/stages/objects.hpp:336
  logic equal_957;
  assign equal_957 = looked_q[1:0] == 2'h1;
  // hls/stages/objects.hpp:319
  logic or_960;
  assign or_960 = (used_1_q & (not_941 | (~(front_label_q == 5'h1)))) | (and_947 & (group_0_q & equal_957));
  // hls/stages/objects.hpp:336
  logic equal_966;
  assign equal_966 = looked_q[2:0] == 3'h3;
  // hls/stages/objects.hpp:319
  logic or_969;
  assign or_969 = (used_2_q & (not_941 | (~(front_label_q == 5'h2)))) | (and_947 & (group_0_q & equal_966));
  // hls/stages/objects.hpp:336
  logic equal_975;
  assign equal_975 = looked_q == 4'h7;
  // hls/stages/objects.hpp:319
  logic or_978;
  assign or_978 = (used_3_q & (not_941 | (~(front_label_q == 5'h3)))) | (and_947 & (group_0_q & equal_975));
  logic or_986;
  assign or_986 = (used_4_q & (not_941 | (~(front_label_q == 5'h4)))) | (and_947 & (group_1_q & not_948));
  logic or_994;
  assign or_994 = (used_5_q & (not_941 | (~(front_label_q == 5'h5)))) | (and_947 & (group_1_q & equal_957));
  logic or_1002;
  assign or_1002 = (used_6_q & (not_941 | (~(front_label_q == 5'h6)))) | (and_947 & (group_1_q & equal_966));
  logic or_1010;
  assign or_1010 = (used_7_q & (not_941 | (~(front_label_q == 5'h7)))) | (and_947 & (group_1_q & equal_975));
  logic or_1018;
  assign or_1018 = (used_8_q & (not_941 | (~(front_label_q == 5'h8)))) | (and_947 & (group_2_q & not_948));
  logic or_1026;
  assign or_1026 = (used_9_q & (not_941 | (~(front_label_q == 5'h9)))) | (and_947 & (group_2_q & equal_957));
  logic or_1034;
  assign or_1034 = (used_10_q & (not_941 | (~(front_label_q == 5'ha)))) | (and_947 & (group_2_q & equal_966));
  logic or_1042;
  assign or_1042 = (used_11_q & (not_941 | (~(front_label_q == 5'hb)))) | (and_947 & (group_2_q & equal_975));
  logic or_1050;
  assign or_1050 = (used_12_q & (not_941 | (~(front_label_q == 5'hc)))) | (and_947 & (group_3_q & not_948));
  logic or_1058;
  assign or_1058 = (used_13_q & (not_941 | (~(front_label_q == 5'hd)))) | (and_947 & (group_3_q & equal_957));
  logic or_1066;
  assign or_1066 = (used_14_q & (not_941 | (~(front_label_q == 5'he)))) | (and_947 & (group_3_q & equal_966));
  logic or_1074;
  assign or_1074 = (used_15_q & (not_941 | (~(front_label_q == 5'hf)))) | (and_947 & (group_3_q & equal_975));
  logic or_1082;
  assign or_1082 = (used_16_q & (not_941 | (~(front_label_q == 5'h10)))) | (and_947 & (group_4_q & not_948));
  logic or_1090;
  assign or_1090 = (used_17_q & (not_941 | (~(front_label_q == 5'h11)))) | (and_947 & (group_4_q & equal_957));
  logic or_1098;
  assign or_1098 = (used_18_q & (not_941 | (~(front_label_q == 5'h12)))) | (and_947 & (group_4_q & equal_966));
  logic or_1106;
  assign or_1106 = (used_19_q & (not_941 | (~(front_label_q == 5'h13)))) | (and_947 & (group_4_q & equal_975));
  logic or_1114;
  assign or_1114 = (used_20_q & (not_941 | (~(front_label_q == 5'h14)))) | (and_947 & (group_5_q & not_948));
  logic or_1122;
  assign or_1122 = (used_21_q & (not_941 | (~(front_label_q == 5'h15)))) | (and_947 & (group_5_q & equal_957));
  logic or_1130;
  assign or_1130 = (used_22_q & (not_941 | (~(front_label_q == 5'h16)))) | (and_947 & (group_5_q & equal_966));
  logic or_1138;
  assign or_1138 = (used_23_q & (not_941 | (~(front_label_q == 5'h17)))) | (and_947 & (group_5_q & equal_975));
  logic or_1146;
  assign or_1146 = (used_24_q & (not_941 | (~(front_label_q == 5'h18)))) | (and_947 & (group_6_q & not_948));
  logic or_1154;
  assign or_1154 = (used_25_q & (not_941 | (~(front_label_q == 5'h19)))) | (and_947 & (group_6_q & equal_957));
  logic or_1162;
  assign or_1162 = (used_26_q & (not_941 | (~(front_label_q == 5'h1a)))) | (and_947 & (group_6_q & equal_966));
  logic or_1170;
  assign or_1170 = (used_27_q & (not_941 | (~(front_label_q == 5'h1b)))) | (and_947 & (group_6_q & equal_975));
  logic or_1178;
  assign or_1178 = (used_28_q & (not_941 | (~(front_label_q == 5'h1c)))) | (and_947 & (group_7_q & not_948));
  logic or_1186;
  assign or_1186 = (used_29_q & (not_941 | (~(front_label_q == 5'h1d)))) | (and_947 & (group_7_q & equal_957));
  logic or_1194;
  assign or_1194 = (used_30_q & (not_941 | (~(front_label_q == 5'h1e)))) | (and_947 & (group_7_q & equal_966));
  logic or_1202;
  assign or_1202 = (used_31_q & (not_941 | (~(front_label_q == 5'h1f)))) | (and_947 & (group_7_q & equal_975));
  // hls/stages/objects.hpp:275
  logic and_1204;
  assign and_1204 = and_468 & not_925;
  // hls/stages/objects.hpp:282
  logic not_1205;
  assign not_1205 = ~free_there_q;
  // hls/stages/objects.hpp:342
  logic and_1207;
  assign and_1207 = found_there_q & (and_1204 | not_1205);
  // hls/stages/objects.hpp:345
  logic or_1213;
  assign or_1213 = equal_957 | equal_975;
  logic or_1214;
  assign or_1214 = equal_966 | equal_975;
  // hls/stages/objects.hpp:364
  logic and_1219;
  assign and_1219 = equal_945 & and_944;
  // hls/stages/objects.hpp:357
  logic and_1238;
  assign and_1238 = used_0_q & group_0_q;
  logic and_1239;
  assign and_1239 = used_1_q & group_0_q;
  logic and_1240;
  assign and_1240 = used_2_q & group_0_q;
  logic and_1241;
  assign and_1241 = used_3_q & group_0_q;
  logic and_1242;
  assign and_1242 = used_4_q & group_1_q;
  logic and_1243;
  assign and_1243 = used_5_q & group_1_q;
  logic and_1244;
  assign and_1244 = used_6_q & group_1_q;
  logic and_1245;
  assign and_1245 = used_7_q & group_1_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used;
  assign used = {and_1241, and_1240, and_1239, and_1238} | {and_1245, and_1244, and_1243, and_1242};
  // hls/stages/objects.hpp:357
  logic and_1247;
  assign and_1247 = used_8_q & group_2_q;
  logic and_1248;
  assign and_1248 = used_9_q & group_2_q;
  logic and_1249;
  assign and_1249 = used_10_q & group_2_q;
  logic and_1250;
  assign and_1250 = used_11_q & group_2_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_2;
  assign used_2 = used | {and_1250, and_1249, and_1248, and_1247};
  // hls/stages/objects.hpp:357
  logic and_1252;
  assign and_1252 = used_12_q & group_3_q;
  logic and_1253;
  assign and_1253 = used_13_q & group_3_q;
  logic and_1254;
  assign and_1254 = used_14_q & group_3_q;
  logic and_1255;
  assign and_1255 = used_15_q & group_3_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_3;
  assign used_3 = used_2 | {and_1255, and_1254, and_1253, and_1252};
  // hls/stages/objects.hpp:357
  logic and_1257;
  assign and_1257 = used_16_q & group_4_q;
  logic and_1258;
  assign and_1258 = used_17_q & group_4_q;
  logic and_1259;
  assign and_1259 = used_18_q & group_4_q;
  logic and_1260;
  assign and_1260 = used_19_q & group_4_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_4;
  assign used_4 = used_3 | {and_1260, and_1259, and_1258, and_1257};
  // hls/stages/objects.hpp:357
  logic and_1262;
  assign and_1262 = used_20_q & group_5_q;
  logic and_1263;
  assign and_1263 = used_21_q & group_5_q;
  logic and_1264;
  assign and_1264 = used_22_q & group_5_q;
  logic and_1265;
  assign and_1265 = used_23_q & group_5_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_5;
  assign used_5 = used_4 | {and_1265, and_1264, and_1263, and_1262};
  // hls/stages/objects.hpp:357
  logic and_1267;
  assign and_1267 = used_24_q & group_6_q;
  logic and_1268;
  assign and_1268 = used_25_q & group_6_q;
  logic and_1269;
  assign and_1269 = used_26_q & group_6_q;
  logic and_1270;
  assign and_1270 = used_27_q & group_6_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_6;
  assign used_6 = used_5 | {and_1270, and_1269, and_1268, and_1267};
  // hls/stages/objects.hpp:357
  logic and_1272;
  assign and_1272 = used_28_q & group_7_q;
  logic and_1273;
  assign and_1273 = used_29_q & group_7_q;
  logic and_1274;
  assign and_1274 = used_30_q & group_7_q;
  logic and_1275;
  assign and_1275 = used_31_q & group_7_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_7;
  assign used_7 = used_6 | {and_1275, and_1274, and_1273, and_1272};
  // hls/stages/objects.hpp:362
  logic and_1281;
  assign and_1281 = not_274_s2_q & ((~looked_there_q) & (and_1207 | (~found_there_q)));
  // hls/stages/objects.hpp:179
  logic [4:0] or_1284;
  assign or_1284 = (begin_0_q ? entries_0_label_q : 5'h0) | (begin_1_q ? entries_1_label_q : 5'h0);
  logic [4:0] or_1287;
  assign or_1287 = (begin_2_q ? entries_2_label_q : 5'h0) | (begin_3_q ? entries_3_label_q : 5'h0);
  logic [4:0] or_1291;
  assign or_1291 = (begin_4_q ? entries_4_label_q : 5'h0) | (begin_5_q ? entries_5_label_q : 5'h0);
  logic [4:0] or_1294;
  assign or_1294 = (begin_6_q ? entries_6_label_q : 5'h0) | (begin_7_q ? entries_7_label_q : 5'h0);
  logic [4:0] or_1299;
  assign or_1299 = (begin_8_q ? entries_8_label_q : 5'h0) | (begin_9_q ? entries_9_label_q : 5'h0);
  logic [4:0] or_1302;
  assign or_1302 = (begin_10_q ? entries_10_label_q : 5'h0) | (begin_11_q ? entries_11_label_q : 5'h0);
  logic [4:0] or_1306;
  assign or_1306 = (begin_12_q ? entries_12_label_q : 5'h0) | (begin_13_q ? entries_13_label_q : 5'h0);
  logic [4:0] or_1309;
  assign or_1309 = (begin_14_q ? entries_14_label_q : 5'h0) | (begin_15_q ? entries_15_label_q : 5'h0);
  logic [4:0] or_1312;
  assign or_1312 = ((or_1284 | or_1287) | (or_1291 | or_1294)) | ((or_1299 | or_1302) | (or_1306 | or_1309));
  logic [4:0] or_1315;
  assign or_1315 = (begin_16_q ? entries_16_label_q : 5'h0) | (begin_17_q ? entries_17_label_q : 5'h0);
  logic [4:0] or_1318;
  assign or_1318 = (begin_18_q ? entries_18_label_q : 5'h0) | (begin_19_q ? entries_19_label_q : 5'h0);
  logic [4:0] or_1322;
  assign or_1322 = (begin_20_q ? entries_20_label_q : 5'h0) | (begin_21_q ? entries_21_label_q : 5'h0);
  logic [4:0] or_1325;
  assign or_1325 = (begin_22_q ? entries_22_label_q : 5'h0) | (begin_23_q ? entries_23_label_q : 5'h0);
  logic [4:0] or_1330;
  assign or_1330 = (begin_24_q ? entries_24_label_q : 5'h0) | (begin_25_q ? entries_25_label_q : 5'h0);
  logic [4:0] or_1333;
  assign or_1333 = (begin_26_q ? entries_26_label_q : 5'h0) | (begin_27_q ? entries_27_label_q : 5'h0);
  logic [4:0] or_1337;
  assign or_1337 = (begin_28_q ? entries_28_label_q : 5'h0) | (begin_29_q ? entries_29_label_q : 5'h0);
  logic [4:0] or_1340;
  assign or_1340 = (begin_30_q ? entries_30_label_q : 5'h0) | (begin_31_q ? entries_31_label_q : 5'h0);
  logic [4:0] or_1343;
  assign or_1343 = ((or_1315 | or_1318) | (or_1322 | or_1325)) | ((or_1330 | or_1333) | (or_1337 | or_1340));
  // hls/stages/objects.hpp:180
  logic or_1348;
  assign or_1348 = (entries_0_there_q & begin_0_q) | (entries_1_there_q & begin_1_q);
  logic or_1351;
  assign or_1351 = (entries_2_there_q & begin_2_q) | (entries_3_there_q & begin_3_q);
  logic or_1355;
  assign or_1355 = (entries_4_there_q & begin_4_q) | (entries_5_there_q & begin_5_q);
  logic or_1358;
  assign or_1358 = (entries_6_there_q & begin_6_q) | (entries_7_there_q & begin_7_q);
  logic or_1363;
  assign or_1363 = (entries_8_there_q & begin_8_q) | (entries_9_there_q & begin_9_q);
  logic or_1366;
  assign or_1366 = (entries_10_there_q & begin_10_q) | (entries_11_there_q & begin_11_q);
  logic or_1370;
  assign or_1370 = (entries_12_there_q & begin_12_q) | (entries_13_there_q & begin_13_q);
  logic or_1373;
  assign or_1373 = (entries_14_there_q & begin_14_q) | (entries_15_there_q & begin_15_q);
  logic or_1376;
  assign or_1376 = ((or_1348 | or_1351) | (or_1355 | or_1358)) | ((or_1363 | or_1366) | (or_1370 | or_1373));
  logic or_1379;
  assign or_1379 = (entries_16_there_q & begin_16_q) | (entries_17_there_q & begin_17_q);
  logic or_1382;
  assign or_1382 = (entries_18_there_q & begin_18_q) | (entries_19_there_q & begin_19_q);
  logic or_1386;
  assign or_1386 = (entries_20_there_q & begin_20_q) | (entries_21_there_q & begin_21_q);
  logic or_1389;
  assign or_1389 = (entries_22_there_q & begin_22_q) | (entries_23_there_q & begin_23_q);
  logic or_1394;
  assign or_1394 = (entries_24_there_q & begin_24_q) | (entries_25_there_q & begin_25_q);
  logic or_1397;
  assign or_1397 = (entries_26_there_q & begin_26_q) | (entries_27_there_q & begin_27_q);
  logic or_1401;
  assign or_1401 = (entries_28_there_q & begin_28_q) | (entries_29_there_q & begin_29_q);
  logic or_1404;
  assign or_1404 = (entries_30_there_q & begin_30_q) | (entries_31_there_q & begin_31_q);
  logic or_1407;
  assign or_1407 = ((or_1379 | or_1382) | (or_1386 | or_1389)) | ((or_1394 | or_1397) | (or_1401 | or_1404));
  // hls/stages/objects.hpp:186
  logic and_1414;
  assign and_1414 = (entries_0_there_q & front_there_q) & (entries_0_label_q == front_label_q);
  logic and_1420;
  assign and_1420 = (entries_1_there_q & front_there_q) & (entries_1_label_q == front_label_q);
  logic and_1426;
  assign and_1426 = (entries_2_there_q & front_there_q) & (entries_2_label_q == front_label_q);
  logic and_1432;
  assign and_1432 = (entries_3_there_q & front_there_q) & (entries_3_label_q == front_label_q);
  logic and_1438;
  assign and_1438 = (entries_4_there_q & front_there_q) & (entries_4_label_q == front_label_q);
  logic and_1444;
  assign and_1444 = (entries_5_there_q & front_there_q) & (entries_5_label_q == front_label_q);
  logic and_1450;
  assign and_1450 = (entries_6_there_q & front_there_q) & (entries_6_label_q == front_label_q);
  logic and_1456;
  assign and_1456 = (entries_7_there_q & front_there_q) & (entries_7_label_q == front_label_q);
  logic and_1462;
  assign and_1462 = (entries_8_there_q & front_there_q) & (entries_8_label_q == front_label_q);
  logic and_1468;
  assign and_1468 = (entries_9_there_q & front_there_q) & (entries_9_label_q == front_label_q);
  logic and_1474;
  assign and_1474 = (entries_10_there_q & front_there_q) & (entries_10_label_q == front_label_q);
  logic and_1480;
  assign and_1480 = (entries_11_there_q & front_there_q) & (entries_11_label_q == front_label_q);
  logic and_1486;
  assign and_1486 = (entries_12_there_q & front_there_q) & (entries_12_label_q == front_label_q);
  logic and_1492;
  assign and_1492 = (entries_13_there_q & front_there_q) & (entries_13_label_q == front_label_q);
  logic and_1498;
  assign and_1498 = (entries_14_there_q & front_there_q) & (entries_14_label_q == front_label_q);
  logic and_1504;
  assign and_1504 = (entries_15_there_q & front_there_q) & (entries_15_label_q == front_label_q);
  logic and_1510;
  assign and_1510 = (entries_16_there_q & front_there_q) & (entries_16_label_q == front_label_q);
  logic and_1516;
  assign and_1516 = (entries_17_there_q & front_there_q) & (entries_17_label_q == front_label_q);
  logic and_1522;
  assign and_1522 = (entries_18_there_q & front_there_q) & (entries_18_label_q == front_label_q);
  logic and_1528;
  assign and_1528 = (entries_19_there_q & front_there_q) & (entries_19_label_q == front_label_q);
  logic and_1534;
  assign and_1534 = (entries_20_there_q & front_there_q) & (entries_20_label_q == front_label_q);
  logic and_1540;
  assign and_1540 = (entries_21_there_q & front_there_q) & (entries_21_label_q == front_label_q);
  logic and_1546;
  assign and_1546 = (entries_22_there_q & front_there_q) & (entries_22_label_q == front_label_q);
  logic and_1552;
  assign and_1552 = (entries_23_there_q & front_there_q) & (entries_23_label_q == front_label_q);
  logic and_1558;
  assign and_1558 = (entries_24_there_q & front_there_q) & (entries_24_label_q == front_label_q);
  logic and_1564;
  assign and_1564 = (entries_25_there_q & front_there_q) & (entries_25_label_q == front_label_q);
  logic and_1570;
  assign and_1570 = (entries_26_there_q & front_there_q) & (entries_26_label_q == front_label_q);
  logic and_1576;
  assign and_1576 = (entries_27_there_q & front_there_q) & (entries_27_label_q == front_label_q);
  logic and_1582;
  assign and_1582 = (entries_28_there_q & front_there_q) & (entries_28_label_q == front_label_q);
  logic and_1588;
  assign and_1588 = (entries_29_there_q & front_there_q) & (entries_29_label_q == front_label_q);
  logic and_1594;
  assign and_1594 = (entries_30_there_q & front_there_q) & (entries_30_label_q == front_label_q);
  logic and_1600;
  assign and_1600 = (entries_31_there_q & front_there_q) & (entries_31_label_q == front_label_q);
  // hls/stages/objects.hpp:297
  logic equal_1604;
  assign equal_1604 = {same_31_q, same_30_q, same_29_q, same_28_q, same_27_q, same_26_q, same_25_q, same_24_q, same_23_q, same_22_q, same_21_q, same_20_q, same_19_q, same_18_q, same_17_q, same_16_q, same_15_q, same_14_q, same_13_q, same_12_q, same_11_q, same_10_q, same_9_q, same_8_q, same_7_q, same_6_q, same_5_q, same_4_q, same_3_q, same_2_q, same_1_q, same_0_q} == 32'h0;
  // hls/stages/objects.hpp:288
  logic equal_1606;
  assign equal_1606 = run_label_q == front_label_q;
  // hls/stages/objects.hpp:301
  logic select_1610;
  assign select_1610 = and_317 ? ((~equal_1604) | (equal_1606 & (run_there_q & front_there_q))) : others_q;
  // hls/stages/objects.hpp:292
  logic select_1615;
  assign select_1615 = and_438 ? ((front_there_q & (event_meets_q & run_there_q)) & (~equal_1606)) : joined_q;
  // hls/stages/objects.hpp:180
  logic or_1626;
  assign or_1626 = ((entries_0_there_q & end_0_q) | (entries_1_there_q & end_1_q)) | ((entries_2_there_q & end_2_q) | (entries_3_there_q & end_3_q));
  logic or_1633;
  assign or_1633 = ((entries_4_there_q & end_4_q) | (entries_5_there_q & end_5_q)) | ((entries_6_there_q & end_6_q) | (entries_7_there_q & end_7_q));
  logic or_1640;
  assign or_1640 = (entries_10_there_q & end_10_q) | (entries_11_there_q & end_11_q);
  logic or_1641;
  assign or_1641 = ((entries_8_there_q & end_8_q) | (entries_9_there_q & end_9_q)) | or_1640;
  logic or_1644;
  assign or_1644 = (entries_12_there_q & end_12_q) | (entries_13_there_q & end_13_q);
  logic or_1647;
  assign or_1647 = (entries_14_there_q & end_14_q) | (entries_15_there_q & end_15_q);
  logic or_1653;
  assign or_1653 = (entries_16_there_q & end_16_q) | (entries_17_there_q & end_17_q);
  logic or_1656;
  assign or_1656 = (entries_18_there_q & end_18_q) | (entries_19_there_q & end_19_q);
  logic or_1660;
  assign or_1660 = (entries_20_there_q & end_20_q) | (entries_21_there_q & end_21_q);
  logic or_1663;
  assign or_1663 = (entries_22_there_q & end_22_q) | (entries_23_there_q & end_23_q);
  logic or_1668;
  assign or_1668 = (entries_24_there_q & end_24_q) | (entries_25_there_q & end_25_q);
  logic or_1671;
  assign or_1671 = (entries_26_there_q & end_26_q) | (entries_27_there_q & end_27_q);
  logic or_1675;
  assign or_1675 = (entries_28_there_q & end_28_q) | (entries_29_there_q & end_29_q);
  logic or_1678;
  assign or_1678 = (entries_30_there_q & end_30_q) | (entries_31_there_q & end_31_q);
  logic or_1681;
  assign or_1681 = ((or_1653 | or_1656) | (or_1660 | or_1663)) | ((or_1668 | or_1671) | (or_1675 | or_1678));
  logic or_1682;
  assign or_1682 = ((or_1626 | or_1633) | (or_1641 | (or_1644 | or_1647))) | or_1681;
  // hls/stages/objects.hpp:104
  logic or_1691;
  assign or_1691 = ((and_468 & (or_1682 | (not_925 & not_1205))) | and_1686_s2_q) | (~(and_273_s2_q | (~overflow_q)));

  // Memory objects, 32 x 154, DISTANCE 2, hls/stages/objects.hpp:483; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [153:0] objects_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) objects_mem[i] = 154'h0;
`endif
  logic [4:0] objects_raddr;
  assign objects_raddr = label;
`ifndef SYNTHESIS
  logic objects_re;
  assign objects_re = s2_en & or_320;
`endif
  logic [153:0] objects_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) objects_rdata_q <= objects_mem[objects_raddr];
  end

  // Memory queue, write
  logic [5:0] queue_waddr;
  assign queue_waddr = write_s2_q;
  logic queue_we;
  assign queue_we = s2_en & and_308_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (queue_we) queue_mem[queue_waddr] <= {last_run_blind_q, last_run_area_q, last_run_row_q, last_run_right_q, last_run_left_q, and_304_s2_q, and_302_s2_q, select_286_s2_q};
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
      last_run_area_q <= 29'h0;
      last_run_blind_q <= 9'h0;
      busy_q <= 1'b0;
      draining_q <= 1'b0;
      done_q <= 1'b0;
      event_ends_q <= 1'b0;
      event_meets_q <= 1'b0;
      event_passes_q <= 1'b0;
      event_run_left_q <= 9'h0;
      event_run_right_q <= 9'h0;
      event_run_row_q <= 9'h0;
      event_run_area_q <= 29'h0;
      event_run_blind_q <= 9'h0;
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
      last_run_left_q <= select_387;
      last_run_right_q <= before_v_q ? x_2 : last_run_right_q;
      last_run_row_q <= before_v_q ? row_q : last_run_row_q;
      last_run_area_q <= select_402;
      last_run_blind_q <= select_405;
      busy_q <= and_434;
      draining_q <= select_436;
      done_q <= and_442;
      event_ends_q <= and_273_s2_q ? event_ends_q : select_444;
      event_meets_q <= and_273_s2_q ? event_meets_q : select_447;
      event_passes_q <= and_273_s2_q ? event_passes_q : select_450;
      event_run_left_q <= and_273_s2_q ? event_run_left_q : select_453;
      event_run_right_q <= and_273_s2_q ? event_run_right_q : select_456;
      event_run_row_q <= and_273_s2_q ? event_run_row_q : select_459;
      event_run_area_q <= and_273_s2_q ? event_run_area_q : select_462;
      event_run_blind_q <= and_273_s2_q ? event_run_blind_q : select_465;
      entries_0_label_q <= select_476;
      entries_0_there_q <= and_484;
      entries_1_label_q <= select_489;
      entries_1_there_q <= and_494;
      entries_2_label_q <= select_499;
      entries_2_there_q <= and_504;
      entries_3_label_q <= select_509;
      entries_3_there_q <= and_514;
      entries_4_label_q <= select_519;
      entries_4_there_q <= and_524;
      entries_5_label_q <= select_529;
      entries_5_there_q <= and_534;
      entries_6_label_q <= select_539;
      entries_6_there_q <= and_544;
      entries_7_label_q <= select_549;
      entries_7_there_q <= and_554;
      entries_8_label_q <= select_559;
      entries_8_there_q <= and_564;
      entries_9_label_q <= select_569;
      entries_9_there_q <= and_574;
      entries_10_label_q <= select_579;
      entries_10_there_q <= and_584;
      entries_11_label_q <= select_589;
      entries_11_there_q <= and_594;
      entries_12_label_q <= select_599;
      entries_12_there_q <= and_604;
      entries_13_label_q <= select_609;
      entries_13_there_q <= and_614;
      entries_14_label_q <= select_619;
      entries_14_there_q <= and_624;
      entries_15_label_q <= select_629;
      entries_15_there_q <= and_634;
      entries_16_label_q <= select_639;
      entries_16_there_q <= and_644;
      entries_17_label_q <= select_649;
      entries_17_there_q <= and_654;
      entries_18_label_q <= select_659;
      entries_18_there_q <= and_664;
      entries_19_label_q <= select_669;
      entries_19_there_q <= and_674;
      entries_20_label_q <= select_679;
      entries_20_there_q <= and_684;
      entries_21_label_q <= select_689;
      entries_21_there_q <= and_694;
      entries_22_label_q <= select_699;
      entries_22_there_q <= and_704;
      entries_23_label_q <= select_709;
      entries_23_there_q <= and_714;
      entries_24_label_q <= select_719;
      entries_24_there_q <= and_724;
      entries_25_label_q <= select_729;
      entries_25_there_q <= and_734;
      entries_26_label_q <= select_739;
      entries_26_there_q <= and_744;
      entries_27_label_q <= select_749;
      entries_27_there_q <= and_754;
      entries_28_label_q <= select_759;
      entries_28_there_q <= and_764;
      entries_29_label_q <= select_769;
      entries_29_there_q <= and_774;
      entries_30_label_q <= select_779;
      entries_30_there_q <= and_784;
      entries_31_label_q <= select_789;
      entries_31_there_q <= and_794;
      begin_0_q <= or_795 ? (begin_31_q | and_273_s2_q) : begin_0_q;
      begin_1_q <= or_795 ? (begin_0_q & not_274_s2_q) : begin_1_q;
      begin_2_q <= or_795 ? (begin_1_q & not_274_s2_q) : begin_2_q;
      begin_3_q <= or_795 ? (begin_2_q & not_274_s2_q) : begin_3_q;
      begin_4_q <= or_795 ? (begin_3_q & not_274_s2_q) : begin_4_q;
      begin_5_q <= or_795 ? (begin_4_q & not_274_s2_q) : begin_5_q;
      begin_6_q <= or_795 ? (begin_5_q & not_274_s2_q) : begin_6_q;
      begin_7_q <= or_795 ? (begin_6_q & not_274_s2_q) : begin_7_q;
      begin_8_q <= or_795 ? (begin_7_q & not_274_s2_q) : begin_8_q;
      begin_9_q <= or_795 ? (begin_8_q & not_274_s2_q) : begin_9_q;
      begin_10_q <= or_795 ? (begin_9_q & not_274_s2_q) : begin_10_q;
      begin_11_q <= or_795 ? (begin_10_q & not_274_s2_q) : begin_11_q;
      begin_12_q <= or_795 ? (begin_11_q & not_274_s2_q) : begin_12_q;
      begin_13_q <= or_795 ? (begin_12_q & not_274_s2_q) : begin_13_q;
      begin_14_q <= or_795 ? (begin_13_q & not_274_s2_q) : begin_14_q;
      begin_15_q <= or_795 ? (begin_14_q & not_274_s2_q) : begin_15_q;
      begin_16_q <= or_795 ? (begin_15_q & not_274_s2_q) : begin_16_q;
      begin_17_q <= or_795 ? (begin_16_q & not_274_s2_q) : begin_17_q;
      begin_18_q <= or_795 ? (begin_17_q & not_274_s2_q) : begin_18_q;
      begin_19_q <= or_795 ? (begin_18_q & not_274_s2_q) : begin_19_q;
      begin_20_q <= or_795 ? (begin_19_q & not_274_s2_q) : begin_20_q;
      begin_21_q <= or_795 ? (begin_20_q & not_274_s2_q) : begin_21_q;
      begin_22_q <= or_795 ? (begin_21_q & not_274_s2_q) : begin_22_q;
      begin_23_q <= or_795 ? (begin_22_q & not_274_s2_q) : begin_23_q;
      begin_24_q <= or_795 ? (begin_23_q & not_274_s2_q) : begin_24_q;
      begin_25_q <= or_795 ? (begin_24_q & not_274_s2_q) : begin_25_q;
      begin_26_q <= or_795 ? (begin_25_q & not_274_s2_q) : begin_26_q;
      begin_27_q <= or_795 ? (begin_26_q & not_274_s2_q) : begin_27_q;
      begin_28_q <= or_795 ? (begin_27_q & not_274_s2_q) : begin_28_q;
      begin_29_q <= or_795 ? (begin_28_q & not_274_s2_q) : begin_29_q;
      begin_30_q <= or_795 ? (begin_29_q & not_274_s2_q) : begin_30_q;
      begin_31_q <= or_795 ? (begin_30_q & not_274_s2_q) : begin_31_q;
      end_0_q <= or_860 ? (end_31_q | and_273_s2_q) : end_0_q;
      end_1_q <= or_860 ? (end_0_q & not_274_s2_q) : end_1_q;
      end_2_q <= or_860 ? (end_1_q & not_274_s2_q) : end_2_q;
      end_3_q <= or_860 ? (end_2_q & not_274_s2_q) : end_3_q;
      end_4_q <= or_860 ? (end_3_q & not_274_s2_q) : end_4_q;
      end_5_q <= or_860 ? (end_4_q & not_274_s2_q) : end_5_q;
      end_6_q <= or_860 ? (end_5_q & not_274_s2_q) : end_6_q;
      end_7_q <= or_860 ? (end_6_q & not_274_s2_q) : end_7_q;
      end_8_q <= or_860 ? (end_7_q & not_274_s2_q) : end_8_q;
      end_9_q <= or_860 ? (end_8_q & not_274_s2_q) : end_9_q;
      end_10_q <= or_860 ? (end_9_q & not_274_s2_q) : end_10_q;
      end_11_q <= or_860 ? (end_10_q & not_274_s2_q) : end_11_q;
      end_12_q <= or_860 ? (end_11_q & not_274_s2_q) : end_12_q;
      end_13_q <= or_860 ? (end_12_q & not_274_s2_q) : end_13_q;
      end_14_q <= or_860 ? (end_13_q & not_274_s2_q) : end_14_q;
      end_15_q <= or_860 ? (end_14_q & not_274_s2_q) : end_15_q;
      end_16_q <= or_860 ? (end_15_q & not_274_s2_q) : end_16_q;
      end_17_q <= or_860 ? (end_16_q & not_274_s2_q) : end_17_q;
      end_18_q <= or_860 ? (end_17_q & not_274_s2_q) : end_18_q;
      end_19_q <= or_860 ? (end_18_q & not_274_s2_q) : end_19_q;
      end_20_q <= or_860 ? (end_19_q & not_274_s2_q) : end_20_q;
      end_21_q <= or_860 ? (end_20_q & not_274_s2_q) : end_21_q;
      end_22_q <= or_860 ? (end_21_q & not_274_s2_q) : end_22_q;
      end_23_q <= or_860 ? (end_22_q & not_274_s2_q) : end_23_q;
      end_24_q <= or_860 ? (end_23_q & not_274_s2_q) : end_24_q;
      end_25_q <= or_860 ? (end_24_q & not_274_s2_q) : end_25_q;
      end_26_q <= or_860 ? (end_25_q & not_274_s2_q) : end_26_q;
      end_27_q <= or_860 ? (end_26_q & not_274_s2_q) : end_27_q;
      end_28_q <= or_860 ? (end_27_q & not_274_s2_q) : end_28_q;
      end_29_q <= or_860 ? (end_28_q & not_274_s2_q) : end_29_q;
      end_30_q <= or_860 ? (end_29_q & not_274_s2_q) : end_30_q;
      end_31_q <= or_860 ? (end_30_q & not_274_s2_q) : end_31_q;
      run_label_q <= and_927 ? front_label_q : run_label_q;
      run_there_q <= and_933;
      used_0_q <= not_274_s2_q & or_951;
      used_1_q <= not_274_s2_q & or_960;
      used_2_q <= not_274_s2_q & or_969;
      used_3_q <= not_274_s2_q & or_978;
      used_4_q <= not_274_s2_q & or_986;
      used_5_q <= not_274_s2_q & or_994;
      used_6_q <= not_274_s2_q & or_1002;
      used_7_q <= not_274_s2_q & or_1010;
      used_8_q <= not_274_s2_q & or_1018;
      used_9_q <= not_274_s2_q & or_1026;
      used_10_q <= not_274_s2_q & or_1034;
      used_11_q <= not_274_s2_q & or_1042;
      used_12_q <= not_274_s2_q & or_1050;
      used_13_q <= not_274_s2_q & or_1058;
      used_14_q <= not_274_s2_q & or_1066;
      used_15_q <= not_274_s2_q & or_1074;
      used_16_q <= not_274_s2_q & or_1082;
      used_17_q <= not_274_s2_q & or_1090;
      used_18_q <= not_274_s2_q & or_1098;
      used_19_q <= not_274_s2_q & or_1106;
      used_20_q <= not_274_s2_q & or_1114;
      used_21_q <= not_274_s2_q & or_1122;
      used_22_q <= not_274_s2_q & or_1130;
      used_23_q <= not_274_s2_q & or_1138;
      used_24_q <= not_274_s2_q & or_1146;
      used_25_q <= not_274_s2_q & or_1154;
      used_26_q <= not_274_s2_q & or_1162;
      used_27_q <= not_274_s2_q & or_1170;
      used_28_q <= not_274_s2_q & or_1178;
      used_29_q <= not_274_s2_q & or_1186;
      used_30_q <= not_274_s2_q & or_1194;
      used_31_q <= not_274_s2_q & or_1202;
      free_label_q <= and_1207 ? found_label_q : free_label_q;
      free_there_q <= not_274_s2_q & (and_1207 | (free_there_q & (~and_1204)));
      found_label_q <= and_947 ? {at_group_q, or_1214, or_1213} : found_label_q;
      found_there_q <= not_274_s2_q & (and_947 | (found_there_q ^ and_1207));
      group_0_q <= and_273_s2_q | (and_1219 ? group_7_q : group_0_q);
      group_1_q <= not_274_s2_q & (and_1219 ? group_0_q : group_1_q);
      group_2_q <= not_274_s2_q & (and_1219 ? group_1_q : group_2_q);
      group_3_q <= not_274_s2_q & (and_1219 ? group_2_q : group_3_q);
      group_4_q <= not_274_s2_q & (and_1219 ? group_3_q : group_4_q);
      group_5_q <= not_274_s2_q & (and_1219 ? group_4_q : group_5_q);
      group_6_q <= not_274_s2_q & (and_1219 ? group_5_q : group_6_q);
      group_7_q <= not_274_s2_q & (and_1219 ? group_6_q : group_7_q);
      at_group_q <= and_273_s2_q ? 3'h0 : (at_group_q + {2'h0, and_1219});
      looked_q <= used_7;
      looked_there_q <= and_1281;
      front_label_q <= and_467 ? (or_1312 | or_1343) : front_label_q;
      front_there_q <= and_467 ? (or_1376 | or_1407) : front_there_q;
      label_q <= and_467 ? ended : label_q;
      fresh_q <= and_467 ? not_925 : fresh_q;
      same_0_q <= and_438 ? (and_1414 & (~begin_0_q)) : same_0_q;
      same_1_q <= and_438 ? (and_1420 & (~begin_1_q)) : same_1_q;
      same_2_q <= and_438 ? (and_1426 & (~begin_2_q)) : same_2_q;
      same_3_q <= and_438 ? (and_1432 & (~begin_3_q)) : same_3_q;
      same_4_q <= and_438 ? (and_1438 & (~begin_4_q)) : same_4_q;
      same_5_q <= and_438 ? (and_1444 & (~begin_5_q)) : same_5_q;
      same_6_q <= and_438 ? (and_1450 & (~begin_6_q)) : same_6_q;
      same_7_q <= and_438 ? (and_1456 & (~begin_7_q)) : same_7_q;
      same_8_q <= and_438 ? (and_1462 & (~begin_8_q)) : same_8_q;
      same_9_q <= and_438 ? (and_1468 & (~begin_9_q)) : same_9_q;
      same_10_q <= and_438 ? (and_1474 & (~begin_10_q)) : same_10_q;
      same_11_q <= and_438 ? (and_1480 & (~begin_11_q)) : same_11_q;
      same_12_q <= and_438 ? (and_1486 & (~begin_12_q)) : same_12_q;
      same_13_q <= and_438 ? (and_1492 & (~begin_13_q)) : same_13_q;
      same_14_q <= and_438 ? (and_1498 & (~begin_14_q)) : same_14_q;
      same_15_q <= and_438 ? (and_1504 & (~begin_15_q)) : same_15_q;
      same_16_q <= and_438 ? (and_1510 & (~begin_16_q)) : same_16_q;
      same_17_q <= and_438 ? (and_1516 & (~begin_17_q)) : same_17_q;
      same_18_q <= and_438 ? (and_1522 & (~begin_18_q)) : same_18_q;
      same_19_q <= and_438 ? (and_1528 & (~begin_19_q)) : same_19_q;
      same_20_q <= and_438 ? (and_1534 & (~begin_20_q)) : same_20_q;
      same_21_q <= and_438 ? (and_1540 & (~begin_21_q)) : same_21_q;
      same_22_q <= and_438 ? (and_1546 & (~begin_22_q)) : same_22_q;
      same_23_q <= and_438 ? (and_1552 & (~begin_23_q)) : same_23_q;
      same_24_q <= and_438 ? (and_1558 & (~begin_24_q)) : same_24_q;
      same_25_q <= and_438 ? (and_1564 & (~begin_25_q)) : same_25_q;
      same_26_q <= and_438 ? (and_1570 & (~begin_26_q)) : same_26_q;
      same_27_q <= and_438 ? (and_1576 & (~begin_27_q)) : same_27_q;
      same_28_q <= and_438 ? (and_1582 & (~begin_28_q)) : same_28_q;
      same_29_q <= and_438 ? (and_1588 & (~begin_29_q)) : same_29_q;
      same_30_q <= and_438 ? (and_1594 & (~begin_30_q)) : same_30_q;
      same_31_q <= and_438 ? (and_1600 & (~begin_31_q)) : same_31_q;
      others_q <= select_1610;
      joined_q <= select_1615;
      other_q <= and_317 ? (joined_q ? run_label_q : front_label_q) : other_q;
      second_q <= equal_275_s2_q ? frees : second_q;
      second_ends_q <= equal_275_s2_q ? closes : second_ends_q;
      overflow_q <= or_1691;
    end
  end

  logic [8:0] event_run_left_s3_q;
  logic [8:0] event_run_right_s3_q;
  logic [8:0] event_run_row_s3_q;
  logic [28:0] event_run_area_s3_q;
  logic [8:0] event_run_blind_s3_q;
  logic not_274_s3_q;
  logic and_310_s3_q;
  logic [4:0] label_s3_q;
  logic or_320_s3_q;
  logic and_322_s3_q;
  logic not_367_s3_q;
  logic and_1713_s3_q;
  logic and_1723_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      event_run_left_s3_q <= event_run_left_q;
      event_run_right_s3_q <= event_run_right_q;
      event_run_row_s3_q <= event_run_row_q;
      event_run_area_s3_q <= event_run_area_q;
      event_run_blind_s3_q <= event_run_blind_q;
      not_274_s3_q <= not_274_s2_q;
      and_310_s3_q <= and_310;
      label_s3_q <= label;
      or_320_s3_q <= or_320;
      and_322_s3_q <= fresh_q & and_319;
      not_367_s3_q <= ~(and_310 ? second_ends_q : joined_q);
      and_1713_s3_q <= second_ends_q & and_310;
      and_1723_s3_q <= idle_s2_q & and_442;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [16:0] joining_pixels_q;
  logic [16:0] joining_blind_q;
  logic [31:0] joining_area_q;
  logic [8:0] joining_left_q;
  logic [8:0] joining_right_q;
  logic [8:0] joining_top_q;
  logic [8:0] joining_bottom_q;
  logic [25:0] joining_columns_q;
  logic [25:0] joining_rows_q;
  logic alarm_q;
  // hls/stages/objects.hpp:415
  logic [8:0] pixels;
  assign pixels = (event_run_right_s3_q - event_run_left_s3_q) + 9'h1;
  // hls/stages/objects.hpp:428
  logic [16:0] sum_326;
  assign sum_326 = objects_rdata_q[16:0] + (and_310_s3_q ? joining_pixels_q : {8'h0, pixels});
  // hls/stages/objects.hpp:403
  logic [16:0] select_327;
  assign select_327 = and_322_s3_q ? {8'h0, pixels} : sum_326;
  // hls/stages/objects.hpp:429
  logic [16:0] sum_329;
  assign sum_329 = objects_rdata_q[33:17] + (and_310_s3_q ? joining_blind_q : {8'h0, event_run_blind_s3_q});
  // hls/stages/objects.hpp:403
  logic [16:0] select_330;
  assign select_330 = and_322_s3_q ? {8'h0, event_run_blind_s3_q} : sum_329;
  // hls/stages/objects.hpp:397
  logic [31:0] select_331;
  assign select_331 = and_310_s3_q ? joining_area_q : {3'h0, event_run_area_s3_q};
  // hls/stages/objects.hpp:430
  logic [16:0] sum_332;
  assign sum_332 = {1'b0, objects_rdata_q[49:34]} + {1'b0, select_331[15:0]};
  logic [16:0] sum_334;
  assign sum_334 = {16'h0, sum_332[16]} + ({1'b0, objects_rdata_q[65:50]} + {1'b0, select_331[31:16]});
  // hls/stages/objects.hpp:403
  logic [31:0] select_336;
  assign select_336 = and_322_s3_q ? {3'h0, event_run_area_s3_q} : (sum_334[16] ? 32'hffffffff : {sum_334[15:0], sum_332[15:0]});
  // hls/stages/objects.hpp:397
  logic [8:0] select_337;
  assign select_337 = and_310_s3_q ? joining_left_q : event_run_left_s3_q;
  // hls/stages/objects.hpp:431
  logic [8:0] select_339;
  assign select_339 = (select_337 < objects_rdata_q[74:66]) ? select_337 : objects_rdata_q[74:66];
  // hls/stages/objects.hpp:403
  logic [8:0] select_340;
  assign select_340 = and_322_s3_q ? event_run_left_s3_q : select_339;
  // hls/stages/objects.hpp:397
  logic [8:0] select_341;
  assign select_341 = and_310_s3_q ? joining_right_q : event_run_right_s3_q;
  // hls/stages/objects.hpp:432
  logic [8:0] select_343;
  assign select_343 = (objects_rdata_q[83:75] < select_341) ? select_341 : objects_rdata_q[83:75];
  // hls/stages/objects.hpp:403
  logic [8:0] select_344;
  assign select_344 = and_322_s3_q ? event_run_right_s3_q : select_343;
  // hls/stages/objects.hpp:397
  logic [8:0] select_345;
  assign select_345 = and_310_s3_q ? joining_top_q : event_run_row_s3_q;
  // hls/stages/objects.hpp:433
  logic [8:0] select_347;
  assign select_347 = (select_345 < objects_rdata_q[92:84]) ? select_345 : objects_rdata_q[92:84];
  // hls/stages/objects.hpp:403
  logic [8:0] select_348;
  assign select_348 = and_322_s3_q ? event_run_row_s3_q : select_347;
  // hls/stages/objects.hpp:397
  logic [8:0] select_349;
  assign select_349 = and_310_s3_q ? joining_bottom_q : event_run_row_s3_q;
  // hls/stages/objects.hpp:434
  logic [8:0] select_351;
  assign select_351 = (objects_rdata_q[101:93] < select_349) ? select_349 : objects_rdata_q[101:93];
  // hls/stages/objects.hpp:403
  logic [8:0] select_352;
  assign select_352 = and_322_s3_q ? event_run_row_s3_q : select_351;
  // hls/stages/objects.hpp:422
  logic [9:0] sum_353;
  assign sum_353 = {1'b0, event_run_left_s3_q} + {1'b0, event_run_right_s3_q};
  logic [18:0] product_354;
  assign product_354 = {10'h0, pixels} * {9'h0, sum_353};
  // hls/stages/objects.hpp:397
  logic [25:0] b;
  assign b = and_310_s3_q ? joining_columns_q : {8'h0, product_354[18:1]};
  // hls/stages/objects.hpp:442
  logic [16:0] low;
  assign low = {1'b0, objects_rdata_q[117:102]} + {1'b0, b[15:0]};
  // hls/stages/objects.hpp:444
  logic [9:0] sum_358;
  assign sum_358 = {9'h0, low[16]} + (objects_rdata_q[127:118] + b[25:16]);
  // hls/stages/objects.hpp:403
  logic [25:0] select_359;
  assign select_359 = and_322_s3_q ? {8'h0, product_354[18:1]} : {sum_358, low[15:0]};
  // hls/stages/objects.hpp:423
  logic [17:0] product_360;
  assign product_360 = {9'h0, event_run_row_s3_q} * {9'h0, pixels};
  // hls/stages/objects.hpp:397
  logic [25:0] b_2;
  assign b_2 = and_310_s3_q ? joining_rows_q : {8'h0, product_360};
  // hls/stages/objects.hpp:442
  logic [16:0] low_2;
  assign low_2 = {1'b0, objects_rdata_q[143:128]} + {1'b0, b_2[15:0]};
  // hls/stages/objects.hpp:444
  logic [9:0] sum_364;
  assign sum_364 = {9'h0, low_2[16]} + (objects_rdata_q[153:144] + b_2[25:16]);
  // hls/stages/objects.hpp:403
  logic [25:0] select_365;
  assign select_365 = and_322_s3_q ? {8'h0, product_360} : {sum_364, low_2[15:0]};
  // hls/stages/objects.hpp:406
  logic and_1705;
  assign and_1705 = (~(select_336 < cfg_object_area_limit_i)) & (~(cfg_object_area_limit_i == 32'hffffffff));
  // hls/stages/objects.hpp:96
  logic and_1710;
  assign and_1710 = or_320_s3_q & (not_367_s3_q & (and_1705 | (~(select_327 < cfg_object_limit_i))));

  // Memory objects, write
  logic [4:0] objects_waddr;
  assign objects_waddr = label_s3_q;
  logic objects_we;
  assign objects_we = s3_en & (not_367_s3_q & or_320_s3_q);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (objects_we) objects_mem[objects_waddr] <= {select_365, select_359, select_352, select_348, select_344, select_340, select_336, select_330, select_327};
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
      joining_blind_q <= 17'h0;
      joining_area_q <= 32'h0;
      joining_left_q <= 9'h0;
      joining_right_q <= 9'h0;
      joining_top_q <= 9'h0;
      joining_bottom_q <= 9'h0;
      joining_columns_q <= 26'h0;
      joining_rows_q <= 26'h0;
      alarm_q <= 1'b0;
    end else if (s3_en) begin
      joining_pixels_q <= or_320_s3_q ? objects_rdata_q[16:0] : joining_pixels_q;
      joining_blind_q <= or_320_s3_q ? objects_rdata_q[33:17] : joining_blind_q;
      joining_area_q <= or_320_s3_q ? objects_rdata_q[65:34] : joining_area_q;
      joining_left_q <= or_320_s3_q ? objects_rdata_q[74:66] : joining_left_q;
      joining_right_q <= or_320_s3_q ? objects_rdata_q[83:75] : joining_right_q;
      joining_top_q <= or_320_s3_q ? objects_rdata_q[92:84] : joining_top_q;
      joining_bottom_q <= or_320_s3_q ? objects_rdata_q[101:93] : joining_bottom_q;
      joining_columns_q <= or_320_s3_q ? objects_rdata_q[127:102] : joining_columns_q;
      joining_rows_q <= or_320_s3_q ? objects_rdata_q[153:128] : joining_rows_q;
      alarm_q <= and_1710 | (alarm_q & not_274_s3_q);
    end
  end

  logic or_1691_s4_q;
  logic and_1713_s4_q;
  logic [16:0] select_1714_s4_q;
  logic [16:0] select_1715_s4_q;
  logic [31:0] select_1716_s4_q;
  logic [8:0] select_1717_s4_q;
  logic [8:0] select_1718_s4_q;
  logic [8:0] select_1719_s4_q;
  logic [8:0] select_1720_s4_q;
  logic [25:0] select_1721_s4_q;
  logic [25:0] select_1722_s4_q;
  logic and_1723_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      or_1691_s4_q <= overflow_q;
      and_1713_s4_q <= and_1713_s3_q;
      select_1714_s4_q <= or_320_s3_q ? objects_rdata_q[16:0] : 17'h0;
      select_1715_s4_q <= or_320_s3_q ? objects_rdata_q[33:17] : 17'h0;
      select_1716_s4_q <= or_320_s3_q ? objects_rdata_q[65:34] : 32'h0;
      select_1717_s4_q <= or_320_s3_q ? objects_rdata_q[74:66] : 9'h0;
      select_1718_s4_q <= or_320_s3_q ? objects_rdata_q[83:75] : 9'h0;
      select_1719_s4_q <= or_320_s3_q ? objects_rdata_q[92:84] : 9'h0;
      select_1720_s4_q <= or_320_s3_q ? objects_rdata_q[101:93] : 9'h0;
      select_1721_s4_q <= or_320_s3_q ? objects_rdata_q[127:102] : 26'h0;
      select_1722_s4_q <= or_320_s3_q ? objects_rdata_q[153:128] : 26'h0;
      and_1723_s4_q <= and_1723_s3_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign ended_o = and_1713_s4_q;
  assign object_pixels_o = select_1714_s4_q;
  assign object_blind_o = select_1715_s4_q;
  assign object_area_o = select_1716_s4_q;
  assign object_left_o = select_1717_s4_q;
  assign object_right_o = select_1718_s4_q;
  assign object_top_o = select_1719_s4_q;
  assign object_bottom_o = select_1720_s4_q;
  assign object_columns_o = select_1721_s4_q;
  assign object_rows_o = select_1722_s4_q;
  assign alarm_o = alarm_q;
  assign overflow_o = or_1691_s4_q;
  assign done_o = and_1723_s4_q;
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
  assign unused_bits = ^product_354[0];

endmodule
