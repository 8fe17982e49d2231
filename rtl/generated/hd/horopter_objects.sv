// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Objects<horopter::hls::profiles::hd>, hls/stages/objects.hpp. Do not edit.
//
// Latency 13 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 635 bits, pipeline 1455 bits, memories 8352 bits.
module horopter_objects (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [1:0] state_i,
  input  logic first_i,
  input  logic last_i,
  input  logic idle_i,
  input  logic [20:0] cfg_object_limit_i,
  output logic valid_o,
  output logic ended_o,
  output logic [20:0] object_pixels_o,
  output logic [10:0] object_left_o,
  output logic [10:0] object_right_o,
  output logic [10:0] object_top_o,
  output logic [10:0] object_bottom_o,
  output logic [31:0] object_columns_o,
  output logic [31:0] object_rows_o,
  output logic alarm_o,
  output logic overflow_o,
  output logic done_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en;
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

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_rows_q;
  logic raster_row_ended_q;
  // hls/stages/objects.hpp:198
  logic or_259;
  assign or_259 = first_i | raster_row_ended_q;
  logic [10:0] x;
  assign x = or_259 ? 11'h0 : raster_column_q;
  // hls/stages/objects.hpp:78
  logic not_261;
  assign not_261 = ~idle_i;
  // hls/stages/objects.hpp:198
  logic and_280;
  assign and_280 = raster_rows_q & (~first_i);

  // Memory above, 1920 x 1, DISTANCE 16, hls/stages/objects.hpp:422; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic above_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) above_mem[i] = 1'b0;
`endif
  logic [10:0] above_raddr;
  assign above_raddr = x;
  logic above_re;
  assign above_re = s0_en & not_261;
  logic above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (above_re) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_rows_q <= 1'b0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= idle_i ? raster_column_q : (x + 11'h1);
      raster_rows_q <= idle_i ? raster_rows_q : (last_i | and_280);
      raster_row_ended_q <= idle_i ? raster_row_ended_q : last_i;
    end
  end

  logic idle_s1_q;
  logic [10:0] x_s1_q;
  logic not_261_s1_q;
  logic equal_263_s1_q;
  logic and_264_s1_q;
  logic or_273_s1_q;
  logic and_280_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      idle_s1_q <= idle_i;
      x_s1_q <= x;
      not_261_s1_q <= not_261;
      equal_263_s1_q <= state_i == 2'h1;
      and_264_s1_q <= first_i & not_261;
      or_273_s1_q <= idle_i | or_259;
      and_280_s1_q <= and_280;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  // Memory above, write
  logic [10:0] above_waddr;
  assign above_waddr = x_s1_q;
  logic above_we;
  assign above_we = s1_en & not_261_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= equal_263_s1_q;
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && above_we) begin
      if (above_re && above_raddr == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
      if (above_waddr >= 11'd1920) $error("above: write outside, address %0d", above_waddr);
    end
    if (rst_ni && above_re && above_raddr >= 11'd1920) $error("above: read outside, address %0d", above_raddr);
  end
`endif

  logic idle_s2_q;
  logic [10:0] x_s2_q;
  logic not_261_s2_q;
  logic above_rdata_s2_q;
  logic and_264_s2_q;
  logic or_273_s2_q;
  logic and_280_s2_q;
  logic and_285_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      idle_s2_q <= idle_s1_q;
      x_s2_q <= x_s1_q;
      not_261_s2_q <= not_261_s1_q;
      above_rdata_s2_q <= above_rdata_q;
      and_264_s2_q <= and_264_s1_q;
      or_273_s2_q <= or_273_s1_q;
      and_280_s2_q <= and_280_s1_q;
      and_285_s2_q <= not_261_s1_q & equal_263_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic before_v_q;
  logic over_before_q;
  logic ended_q;
  // hls/stages/objects.hpp:79
  logic not_265;
  assign not_265 = ~and_264_s2_q;
  // hls/stages/objects.hpp:210
  logic and_272;
  assign and_272 = ended_q & not_265;
  // hls/stages/objects.hpp:208
  logic not_274;
  assign not_274 = ~or_273_s2_q;
  // hls/stages/objects.hpp:210
  logic and_276;
  assign and_276 = before_v_q & not_265;
  logic and_278;
  assign and_278 = over_before_q & not_265;
  // hls/stages/objects.hpp:91
  logic and_282;
  assign and_282 = not_261_s2_q & (above_rdata_s2_q & and_280_s2_q);
  // hls/stages/objects.hpp:208
  logic and_283;
  assign and_283 = and_282 & not_274;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_v_q <= 1'b0;
      over_before_q <= 1'b0;
      ended_q <= 1'b0;
    end else if (s2_en) begin
      before_v_q <= and_285_s2_q;
      over_before_q <= and_282;
      ended_q <= not_274 & (and_276 & (~and_285_s2_q));
    end
  end

  logic idle_s3_q;
  logic [10:0] x_s3_q;
  logic not_261_s3_q;
  logic and_264_s3_q;
  logic not_265_s3_q;
  logic select_277_s3_q;
  logic or_284_s3_q;
  logic and_288_s3_q;
  logic and_296_s3_q;
  logic or_375_s3_q;
  logic or_380_s3_q;
  logic and_409_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      idle_s3_q <= idle_s2_q;
      x_s3_q <= x_s2_q;
      not_261_s3_q <= not_261_s2_q;
      and_264_s3_q <= and_264_s2_q;
      not_265_s3_q <= not_265;
      select_277_s3_q <= (and_272 | not_274) ? and_272 : and_276;
      or_284_s3_q <= and_278 | and_283;
      and_288_s3_q <= not_274 & (and_276 | (and_285_s2_q & not_274));
      and_296_s3_q <= and_278 & (~and_283);
      or_375_s3_q <= idle_s2_q | not_274;
      or_380_s3_q <= or_273_s2_q | (~and_276);
      and_409_s3_q <= (~before_v_q) & ((~over_before_q) & (~ended_q));
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic met_q;
  logic [5:0] write_q;
  logic [5:0] read_q;
  logic [5:0] visible_q;
  logic [5:0] room_q;
  logic little_room_q;
  logic [3:0] phase_q;
  // hls/stages/objects.hpp:305
  logic equal_266;
  assign equal_266 = phase_q == 4'h0;
  // hls/stages/objects.hpp:353
  logic equal_267;
  assign equal_267 = read_q == visible_q;
  logic not_268;
  assign not_268 = ~equal_267;
  // hls/stages/objects.hpp:91
  logic and_289;
  assign and_289 = or_284_s3_q & and_288_s3_q;
  // hls/stages/objects.hpp:215
  logic and_292;
  assign and_292 = (met_q & not_265_s3_q) & (~select_277_s3_q);
  // hls/stages/objects.hpp:216
  logic and_294;
  assign and_294 = and_289 & (~and_292);
  // hls/stages/objects.hpp:217
  logic or_298;
  assign or_298 = and_296_s3_q | (select_277_s3_q | and_294);
  // hls/stages/objects.hpp:225
  logic [5:0] select_389;
  assign select_389 = and_264_s3_q ? 6'h0 : (or_298 ? (little_room_q ? write_q : (write_q + 6'h1)) : write_q);
  // hls/stages/objects.hpp:90
  logic [5:0] select_393;
  assign select_393 = and_264_s3_q ? 6'h0 : (equal_266 ? (equal_267 ? read_q : (read_q + 6'h1)) : read_q);
  // hls/stages/objects.hpp:80
  logic [5:0] room;
  assign room = read_q - write_q;
  // hls/stages/objects.hpp:79
  logic little_room;
  assign little_room = not_265_s3_q & (({2'h0, room_q} + 8'hff) < 8'h7);
  // hls/stages/objects.hpp:306
  logic and_411;
  assign and_411 = (~(not_261_s3_q | not_268)) & ((write_q == read_q) & and_409_s3_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      met_q <= 1'b0;
      write_q <= 6'h0;
      read_q <= 6'h0;
      visible_q <= 6'h0;
      room_q <= 6'h0;
      little_room_q <= 1'b0;
      phase_q <= 4'h0;
    end else if (s3_en) begin
      met_q <= (and_289 | and_292) & (~and_296_s3_q);
      write_q <= select_389;
      read_q <= select_393;
      visible_q <= and_264_s3_q ? 6'h0 : (equal_266 ? write_q : visible_q);
      room_q <= and_264_s3_q ? 6'h0 : room;
      little_room_q <= little_room;
      phase_q <= phase_q + 4'h1;
    end
  end

  logic idle_s4_q;
  logic [5:0] write_s4_q;
  logic [5:0] read_s4_q;
  logic [3:0] phase_s4_q;
  logic [10:0] x_s4_q;
  logic and_264_s4_q;
  logic not_265_s4_q;
  logic equal_266_s4_q;
  logic equal_267_s4_q;
  logic not_268_s4_q;
  logic select_277_s4_q;
  logic and_285_s4_q;
  logic and_294_s4_q;
  logic and_296_s4_q;
  logic and_300_s4_q;
  logic or_375_s4_q;
  logic or_380_s4_q;
  logic and_411_s4_q;
  logic and_1662_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      idle_s4_q <= idle_s3_q;
      write_s4_q <= write_q;
      read_s4_q <= read_q;
      phase_s4_q <= phase_q;
      x_s4_q <= x_s3_q;
      and_264_s4_q <= and_264_s3_q;
      not_265_s4_q <= not_265_s3_q;
      equal_266_s4_q <= equal_266;
      equal_267_s4_q <= equal_267;
      not_268_s4_q <= not_268;
      select_277_s4_q <= select_277_s3_q;
      and_285_s4_q <= before_v_q;
      and_294_s4_q <= and_294;
      and_296_s4_q <= and_296_s3_q;
      and_300_s4_q <= or_298 & (~little_room_q);
      or_375_s4_q <= or_375_s3_q;
      or_380_s4_q <= or_380_s3_q;
      and_411_s4_q <= and_411;
      and_1662_s4_q <= little_room_q & or_298;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [10:0] row_q;

  // Memory queue, 64 x 36, DISTANCE 16, hls/stages/objects.hpp:429; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] queue_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) queue_mem[i] = 36'h0;
`endif
  logic [5:0] queue_raddr;
  assign queue_raddr = read_s4_q;
  logic queue_re;
  assign queue_re = s4_en & (not_265_s4_q & (equal_266_s4_q & not_268_s4_q));
  logic [35:0] queue_rdata_q;
  always_ff @(posedge clk_i) begin
    if (queue_re) queue_rdata_q <= queue_mem[queue_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 11'h0;
    end else if (s4_en) begin
      row_q <= or_375_s4_q ? row_q : (and_264_s4_q ? 11'h0 : (row_q + 11'h1));
    end
  end

  logic idle_s5_q;
  logic [5:0] write_s5_q;
  logic [3:0] phase_s5_q;
  logic [10:0] x_s5_q;
  logic and_264_s5_q;
  logic not_265_s5_q;
  logic equal_266_s5_q;
  logic equal_267_s5_q;
  logic not_268_s5_q;
  logic select_277_s5_q;
  logic and_285_s5_q;
  logic and_294_s5_q;
  logic and_296_s5_q;
  logic and_300_s5_q;
  logic or_380_s5_q;
  logic and_411_s5_q;
  logic and_1662_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      idle_s5_q <= idle_s4_q;
      write_s5_q <= write_s4_q;
      phase_s5_q <= phase_s4_q;
      x_s5_q <= x_s4_q;
      and_264_s5_q <= and_264_s4_q;
      not_265_s5_q <= not_265_s4_q;
      equal_266_s5_q <= equal_266_s4_q;
      equal_267_s5_q <= equal_267_s4_q;
      not_268_s5_q <= not_268_s4_q;
      select_277_s5_q <= select_277_s4_q;
      and_285_s5_q <= and_285_s4_q;
      and_294_s5_q <= and_294_s4_q;
      and_296_s5_q <= and_296_s4_q;
      and_300_s5_q <= and_300_s4_q;
      or_380_s5_q <= or_380_s4_q;
      and_411_s5_q <= and_411_s4_q;
      and_1662_s5_q <= and_1662_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [10:0] last_run_left_q;
  logic [10:0] last_run_right_q;
  logic [10:0] last_run_row_q;
  // hls/stages/objects.hpp:91
  logic [10:0] x_2;
  assign x_2 = idle_s5_q ? last_run_right_q : x_s5_q;
  // hls/stages/objects.hpp:233
  logic [10:0] select_383;
  assign select_383 = and_285_s5_q ? (or_380_s5_q ? x_2 : last_run_left_q) : last_run_left_q;

  // Memory queue, write
  logic [5:0] queue_waddr;
  assign queue_waddr = write_s5_q;
  logic queue_we;
  assign queue_we = s5_en & and_300_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (queue_we) queue_mem[queue_waddr] <= {last_run_row_q, last_run_right_q, last_run_left_q, and_296_s5_q, and_294_s5_q, select_277_s5_q};
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
      last_run_left_q <= 11'h0;
      last_run_right_q <= 11'h0;
      last_run_row_q <= 11'h0;
    end else if (s5_en) begin
      last_run_left_q <= select_383;
      last_run_right_q <= and_285_s5_q ? x_2 : last_run_right_q;
      last_run_row_q <= and_285_s5_q ? row_q : last_run_row_q;
    end
  end

  logic idle_s6_q;
  logic and_264_s6_q;
  logic not_265_s6_q;
  logic equal_266_s6_q;
  logic equal_267_s6_q;
  logic not_268_s6_q;
  logic [35:0] queue_rdata_s6_q;
  logic equal_301_s6_q;
  logic equal_320_s6_q;
  logic and_411_s6_q;
  logic equal_417_s6_q;
  logic equal_441_s6_q;
  logic equal_452_s6_q;
  logic and_1662_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      idle_s6_q <= idle_s5_q;
      and_264_s6_q <= and_264_s5_q;
      not_265_s6_q <= not_265_s5_q;
      equal_266_s6_q <= equal_266_s5_q;
      equal_267_s6_q <= equal_267_s5_q;
      not_268_s6_q <= not_268_s5_q;
      queue_rdata_s6_q <= queue_rdata_q;
      equal_301_s6_q <= phase_s5_q == 4'hb;
      equal_320_s6_q <= phase_s5_q == 4'h3;
      and_411_s6_q <= and_411_s5_q;
      equal_417_s6_q <= phase_s5_q == 4'h2;
      equal_441_s6_q <= phase_s5_q == 4'h1;
      equal_452_s6_q <= phase_s5_q == 4'h4;
      and_1662_s6_q <= and_1662_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic busy_q;
  logic draining_q;
  logic done_q;
  logic event_ends_q;
  logic event_meets_q;
  logic event_passes_q;
  logic [10:0] event_run_left_q;
  logic [10:0] event_run_right_q;
  logic [10:0] event_run_row_q;
  logic entries_0_there_q;
  logic entries_1_there_q;
  logic entries_2_there_q;
  logic entries_3_there_q;
  logic entries_4_there_q;
  logic entries_5_there_q;
  logic entries_6_there_q;
  logic entries_7_there_q;
  logic entries_8_there_q;
  logic entries_9_there_q;
  logic entries_10_there_q;
  logic entries_11_there_q;
  logic entries_12_there_q;
  logic entries_13_there_q;
  logic entries_14_there_q;
  logic entries_15_there_q;
  logic entries_16_there_q;
  logic entries_17_there_q;
  logic entries_18_there_q;
  logic entries_19_there_q;
  logic entries_20_there_q;
  logic entries_21_there_q;
  logic entries_22_there_q;
  logic entries_23_there_q;
  logic entries_24_there_q;
  logic entries_25_there_q;
  logic entries_26_there_q;
  logic entries_27_there_q;
  logic entries_28_there_q;
  logic entries_29_there_q;
  logic entries_30_there_q;
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
  logic front_there_q;
  // hls/stages/objects.hpp:90
  logic and_414;
  assign and_414 = not_265_s6_q & (equal_266_s6_q ? (not_268_s6_q | and_411_s6_q) : busy_q);
  logic select_416;
  assign select_416 = and_264_s6_q ? draining_q : (equal_266_s6_q ? and_411_s6_q : draining_q);
  // hls/stages/objects.hpp:250
  logic and_418;
  assign and_418 = busy_q & equal_417_s6_q;
  // hls/stages/objects.hpp:90
  logic and_422;
  assign and_422 = not_265_s6_q & (and_418 ? (draining_q & (~front_there_q)) : done_q);
  logic select_424;
  assign select_424 = equal_266_s6_q ? (queue_rdata_s6_q[0] & not_268_s6_q) : event_ends_q;
  logic select_427;
  assign select_427 = equal_266_s6_q ? (queue_rdata_s6_q[1] & not_268_s6_q) : event_meets_q;
  logic select_430;
  assign select_430 = equal_266_s6_q ? (queue_rdata_s6_q[2] | equal_267_s6_q) : event_passes_q;
  logic [10:0] select_433;
  assign select_433 = equal_266_s6_q ? (equal_267_s6_q ? event_run_left_q : queue_rdata_s6_q[13:3]) : event_run_left_q;
  logic [10:0] select_436;
  assign select_436 = equal_266_s6_q ? (equal_267_s6_q ? event_run_right_q : queue_rdata_s6_q[24:14]) : event_run_right_q;
  logic [10:0] select_439;
  assign select_439 = equal_266_s6_q ? (equal_267_s6_q ? event_run_row_q : queue_rdata_s6_q[35:25]) : event_run_row_q;
  // hls/stages/objects.hpp:250
  logic and_442;
  assign and_442 = busy_q & equal_441_s6_q;
  // hls/stages/objects.hpp:254
  logic and_443;
  assign and_443 = event_ends_q & and_442;
  // hls/stages/objects.hpp:294
  logic and_444;
  assign and_444 = end_0_q & and_443;
  // hls/stages/objects.hpp:251
  logic and_453;
  assign and_453 = busy_q & equal_452_s6_q;
  // hls/stages/objects.hpp:280
  logic and_455;
  assign and_455 = front_there_q & (event_passes_q & and_453);
  // hls/stages/objects.hpp:296
  logic and_460;
  assign and_460 = not_265_s6_q & (and_444 | (entries_0_there_q & (~(begin_0_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_461;
  assign and_461 = end_1_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_470;
  assign and_470 = not_265_s6_q & (and_461 | (entries_1_there_q & (~(begin_1_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_471;
  assign and_471 = end_2_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_480;
  assign and_480 = not_265_s6_q & (and_471 | (entries_2_there_q & (~(begin_2_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_481;
  assign and_481 = end_3_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_490;
  assign and_490 = not_265_s6_q & (and_481 | (entries_3_there_q & (~(begin_3_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_491;
  assign and_491 = end_4_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_500;
  assign and_500 = not_265_s6_q & (and_491 | (entries_4_there_q & (~(begin_4_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_501;
  assign and_501 = end_5_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_510;
  assign and_510 = not_265_s6_q & (and_501 | (entries_5_there_q & (~(begin_5_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_511;
  assign and_511 = end_6_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_520;
  assign and_520 = not_265_s6_q & (and_511 | (entries_6_there_q & (~(begin_6_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_521;
  assign and_521 = end_7_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_530;
  assign and_530 = not_265_s6_q & (and_521 | (entries_7_there_q & (~(begin_7_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_531;
  assign and_531 = end_8_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_540;
  assign and_540 = not_265_s6_q & (and_531 | (entries_8_there_q & (~(begin_8_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_541;
  assign and_541 = end_9_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_550;
  assign and_550 = not_265_s6_q & (and_541 | (entries_9_there_q & (~(begin_9_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_551;
  assign and_551 = end_10_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_560;
  assign and_560 = not_265_s6_q & (and_551 | (entries_10_there_q & (~(begin_10_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_561;
  assign and_561 = end_11_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_570;
  assign and_570 = not_265_s6_q & (and_561 | (entries_11_there_q & (~(begin_11_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_571;
  assign and_571 = end_12_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_580;
  assign and_580 = not_265_s6_q & (and_571 | (entries_12_there_q & (~(begin_12_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_581;
  assign and_581 = end_13_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_590;
  assign and_590 = not_265_s6_q & (and_581 | (entries_13_there_q & (~(begin_13_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_591;
  assign and_591 = end_14_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_600;
  assign and_600 = not_265_s6_q & (and_591 | (entries_14_there_q & (~(begin_14_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_601;
  assign and_601 = end_15_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_610;
  assign and_610 = not_265_s6_q & (and_601 | (entries_15_there_q & (~(begin_15_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_611;
  assign and_611 = end_16_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_620;
  assign and_620 = not_265_s6_q & (and_611 | (entries_16_there_q & (~(begin_16_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_621;
  assign and_621 = end_17_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_630;
  assign and_630 = not_265_s6_q & (and_621 | (entries_17_there_q & (~(begin_17_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_631;
  assign and_631 = end_18_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_640;
  assign and_640 = not_265_s6_q & (and_631 | (entries_18_there_q & (~(begin_18_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_641;
  assign and_641 = end_19_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_650;
  assign and_650 = not_265_s6_q & (and_641 | (entries_19_there_q & (~(begin_19_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_651;
  assign and_651 = end_20_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_660;
  assign and_660 = not_265_s6_q & (and_651 | (entries_20_there_q & (~(begin_20_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_661;
  assign and_661 = end_21_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_670;
  assign and_670 = not_265_s6_q & (and_661 | (entries_21_there_q & (~(begin_21_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_671;
  assign and_671 = end_22_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_680;
  assign and_680 = not_265_s6_q & (and_671 | (entries_22_there_q & (~(begin_22_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_681;
  assign and_681 = end_23_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_690;
  assign and_690 = not_265_s6_q & (and_681 | (entries_23_there_q & (~(begin_23_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_691;
  assign and_691 = end_24_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_700;
  assign and_700 = not_265_s6_q & (and_691 | (entries_24_there_q & (~(begin_24_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_701;
  assign and_701 = end_25_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_710;
  assign and_710 = not_265_s6_q & (and_701 | (entries_25_there_q & (~(begin_25_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_711;
  assign and_711 = end_26_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_720;
  assign and_720 = not_265_s6_q & (and_711 | (entries_26_there_q & (~(begin_26_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_721;
  assign and_721 = end_27_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_730;
  assign and_730 = not_265_s6_q & (and_721 | (entries_27_there_q & (~(begin_27_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_731;
  assign and_731 = end_28_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_740;
  assign and_740 = not_265_s6_q & (and_731 | (entries_28_there_q & (~(begin_28_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_741;
  assign and_741 = end_29_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_750;
  assign and_750 = not_265_s6_q & (and_741 | (entries_29_there_q & (~(begin_29_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_751;
  assign and_751 = end_30_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_760;
  assign and_760 = not_265_s6_q & (and_751 | (entries_30_there_q & (~(begin_30_q & and_455))));
  // hls/stages/objects.hpp:294
  logic and_761;
  assign and_761 = end_31_q & and_443;
  // hls/stages/objects.hpp:296
  logic and_770;
  assign and_770 = not_265_s6_q & (and_761 | (entries_31_there_q & (~(begin_31_q & and_455))));
  // hls/stages/objects.hpp:300
  logic or_771;
  assign or_771 = and_264_s6_q | and_455;
  // hls/stages/objects.hpp:301
  logic or_836;
  assign or_836 = and_264_s6_q | and_443;
  // hls/stages/objects.hpp:167
  logic or_1324;
  assign or_1324 = (entries_0_there_q & begin_0_q) | (entries_1_there_q & begin_1_q);
  logic or_1327;
  assign or_1327 = (entries_2_there_q & begin_2_q) | (entries_3_there_q & begin_3_q);
  logic or_1331;
  assign or_1331 = (entries_4_there_q & begin_4_q) | (entries_5_there_q & begin_5_q);
  logic or_1334;
  assign or_1334 = (entries_6_there_q & begin_6_q) | (entries_7_there_q & begin_7_q);
  logic or_1339;
  assign or_1339 = (entries_8_there_q & begin_8_q) | (entries_9_there_q & begin_9_q);
  logic or_1342;
  assign or_1342 = (entries_10_there_q & begin_10_q) | (entries_11_there_q & begin_11_q);
  logic or_1346;
  assign or_1346 = (entries_12_there_q & begin_12_q) | (entries_13_there_q & begin_13_q);
  logic or_1349;
  assign or_1349 = (entries_14_there_q & begin_14_q) | (entries_15_there_q & begin_15_q);
  logic or_1352;
  assign or_1352 = ((or_1324 | or_1327) | (or_1331 | or_1334)) | ((or_1339 | or_1342) | (or_1346 | or_1349));
  logic or_1355;
  assign or_1355 = (entries_16_there_q & begin_16_q) | (entries_17_there_q & begin_17_q);
  logic or_1358;
  assign or_1358 = (entries_18_there_q & begin_18_q) | (entries_19_there_q & begin_19_q);
  logic or_1362;
  assign or_1362 = (entries_20_there_q & begin_20_q) | (entries_21_there_q & begin_21_q);
  logic or_1365;
  assign or_1365 = (entries_22_there_q & begin_22_q) | (entries_23_there_q & begin_23_q);
  logic or_1370;
  assign or_1370 = (entries_24_there_q & begin_24_q) | (entries_25_there_q & begin_25_q);
  logic or_1373;
  assign or_1373 = (entries_26_there_q & begin_26_q) | (entries_27_there_q & begin_27_q);
  logic or_1377;
  assign or_1377 = (entries_28_there_q & begin_28_q) | (entries_29_there_q & begin_29_q);
  logic or_1380;
  assign or_1380 = (entries_30_there_q & begin_30_q) | (entries_31_there_q & begin_31_q);
  logic or_1383;
  assign or_1383 = ((or_1355 | or_1358) | (or_1362 | or_1365)) | ((or_1370 | or_1373) | (or_1377 | or_1380));
  logic or_1602;
  assign or_1602 = ((entries_0_there_q & end_0_q) | (entries_1_there_q & end_1_q)) | ((entries_2_there_q & end_2_q) | (entries_3_there_q & end_3_q));
  logic or_1609;
  assign or_1609 = ((entries_4_there_q & end_4_q) | (entries_5_there_q & end_5_q)) | ((entries_6_there_q & end_6_q) | (entries_7_there_q & end_7_q));
  logic or_1616;
  assign or_1616 = (entries_10_there_q & end_10_q) | (entries_11_there_q & end_11_q);
  logic or_1617;
  assign or_1617 = ((entries_8_there_q & end_8_q) | (entries_9_there_q & end_9_q)) | or_1616;
  logic or_1620;
  assign or_1620 = (entries_12_there_q & end_12_q) | (entries_13_there_q & end_13_q);
  logic or_1623;
  assign or_1623 = (entries_14_there_q & end_14_q) | (entries_15_there_q & end_15_q);
  logic or_1629;
  assign or_1629 = (entries_16_there_q & end_16_q) | (entries_17_there_q & end_17_q);
  logic or_1632;
  assign or_1632 = (entries_18_there_q & end_18_q) | (entries_19_there_q & end_19_q);
  logic or_1636;
  assign or_1636 = (entries_20_there_q & end_20_q) | (entries_21_there_q & end_21_q);
  logic or_1639;
  assign or_1639 = (entries_22_there_q & end_22_q) | (entries_23_there_q & end_23_q);
  logic or_1644;
  assign or_1644 = (entries_24_there_q & end_24_q) | (entries_25_there_q & end_25_q);
  logic or_1647;
  assign or_1647 = (entries_26_there_q & end_26_q) | (entries_27_there_q & end_27_q);
  logic or_1651;
  assign or_1651 = (entries_28_there_q & end_28_q) | (entries_29_there_q & end_29_q);
  logic or_1654;
  assign or_1654 = (entries_30_there_q & end_30_q) | (entries_31_there_q & end_31_q);
  logic or_1657;
  assign or_1657 = ((or_1629 | or_1632) | (or_1636 | or_1639)) | ((or_1644 | or_1647) | (or_1651 | or_1654));
  logic or_1658;
  assign or_1658 = ((or_1602 | or_1609) | (or_1617 | (or_1620 | or_1623))) | or_1657;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      draining_q <= 1'b0;
      done_q <= 1'b0;
      event_ends_q <= 1'b0;
      event_meets_q <= 1'b0;
      event_passes_q <= 1'b0;
      event_run_left_q <= 11'h0;
      event_run_right_q <= 11'h0;
      event_run_row_q <= 11'h0;
      entries_0_there_q <= 1'b0;
      entries_1_there_q <= 1'b0;
      entries_2_there_q <= 1'b0;
      entries_3_there_q <= 1'b0;
      entries_4_there_q <= 1'b0;
      entries_5_there_q <= 1'b0;
      entries_6_there_q <= 1'b0;
      entries_7_there_q <= 1'b0;
      entries_8_there_q <= 1'b0;
      entries_9_there_q <= 1'b0;
      entries_10_there_q <= 1'b0;
      entries_11_there_q <= 1'b0;
      entries_12_there_q <= 1'b0;
      entries_13_there_q <= 1'b0;
      entries_14_there_q <= 1'b0;
      entries_15_there_q <= 1'b0;
      entries_16_there_q <= 1'b0;
      entries_17_there_q <= 1'b0;
      entries_18_there_q <= 1'b0;
      entries_19_there_q <= 1'b0;
      entries_20_there_q <= 1'b0;
      entries_21_there_q <= 1'b0;
      entries_22_there_q <= 1'b0;
      entries_23_there_q <= 1'b0;
      entries_24_there_q <= 1'b0;
      entries_25_there_q <= 1'b0;
      entries_26_there_q <= 1'b0;
      entries_27_there_q <= 1'b0;
      entries_28_there_q <= 1'b0;
      entries_29_there_q <= 1'b0;
      entries_30_there_q <= 1'b0;
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
      front_there_q <= 1'b0;
    end else if (s6_en) begin
      busy_q <= and_414;
      draining_q <= select_416;
      done_q <= and_422;
      event_ends_q <= and_264_s6_q ? event_ends_q : select_424;
      event_meets_q <= and_264_s6_q ? event_meets_q : select_427;
      event_passes_q <= and_264_s6_q ? event_passes_q : select_430;
      event_run_left_q <= and_264_s6_q ? event_run_left_q : select_433;
      event_run_right_q <= and_264_s6_q ? event_run_right_q : select_436;
      event_run_row_q <= and_264_s6_q ? event_run_row_q : select_439;
      entries_0_there_q <= and_460;
      entries_1_there_q <= and_470;
      entries_2_there_q <= and_480;
      entries_3_there_q <= and_490;
      entries_4_there_q <= and_500;
      entries_5_there_q <= and_510;
      entries_6_there_q <= and_520;
      entries_7_there_q <= and_530;
      entries_8_there_q <= and_540;
      entries_9_there_q <= and_550;
      entries_10_there_q <= and_560;
      entries_11_there_q <= and_570;
      entries_12_there_q <= and_580;
      entries_13_there_q <= and_590;
      entries_14_there_q <= and_600;
      entries_15_there_q <= and_610;
      entries_16_there_q <= and_620;
      entries_17_there_q <= and_630;
      entries_18_there_q <= and_640;
      entries_19_there_q <= and_650;
      entries_20_there_q <= and_660;
      entries_21_there_q <= and_670;
      entries_22_there_q <= and_680;
      entries_23_there_q <= and_690;
      entries_24_there_q <= and_700;
      entries_25_there_q <= and_710;
      entries_26_there_q <= and_720;
      entries_27_there_q <= and_730;
      entries_28_there_q <= and_740;
      entries_29_there_q <= and_750;
      entries_30_there_q <= and_760;
      entries_31_there_q <= and_770;
      begin_0_q <= or_771 ? (begin_31_q | and_264_s6_q) : begin_0_q;
      begin_1_q <= or_771 ? (begin_0_q & not_265_s6_q) : begin_1_q;
      begin_2_q <= or_771 ? (begin_1_q & not_265_s6_q) : begin_2_q;
      begin_3_q <= or_771 ? (begin_2_q & not_265_s6_q) : begin_3_q;
      begin_4_q <= or_771 ? (begin_3_q & not_265_s6_q) : begin_4_q;
      begin_5_q <= or_771 ? (begin_4_q & not_265_s6_q) : begin_5_q;
      begin_6_q <= or_771 ? (begin_5_q & not_265_s6_q) : begin_6_q;
      begin_7_q <= or_771 ? (begin_6_q & not_265_s6_q) : begin_7_q;
      begin_8_q <= or_771 ? (begin_7_q & not_265_s6_q) : begin_8_q;
      begin_9_q <= or_771 ? (begin_8_q & not_265_s6_q) : begin_9_q;
      begin_10_q <= or_771 ? (begin_9_q & not_265_s6_q) : begin_10_q;
      begin_11_q <= or_771 ? (begin_10_q & not_265_s6_q) : begin_11_q;
      begin_12_q <= or_771 ? (begin_11_q & not_265_s6_q) : begin_12_q;
      begin_13_q <= or_771 ? (begin_12_q & not_265_s6_q) : begin_13_q;
      begin_14_q <= or_771 ? (begin_13_q & not_265_s6_q) : begin_14_q;
      begin_15_q <= or_771 ? (begin_14_q & not_265_s6_q) : begin_15_q;
      begin_16_q <= or_771 ? (begin_15_q & not_265_s6_q) : begin_16_q;
      begin_17_q <= or_771 ? (begin_16_q & not_265_s6_q) : begin_17_q;
      begin_18_q <= or_771 ? (begin_17_q & not_265_s6_q) : begin_18_q;
      begin_19_q <= or_771 ? (begin_18_q & not_265_s6_q) : begin_19_q;
      begin_20_q <= or_771 ? (begin_19_q & not_265_s6_q) : begin_20_q;
      begin_21_q <= or_771 ? (begin_20_q & not_265_s6_q) : begin_21_q;
      begin_22_q <= or_771 ? (begin_21_q & not_265_s6_q) : begin_22_q;
      begin_23_q <= or_771 ? (begin_22_q & not_265_s6_q) : begin_23_q;
      begin_24_q <= or_771 ? (begin_23_q & not_265_s6_q) : begin_24_q;
      begin_25_q <= or_771 ? (begin_24_q & not_265_s6_q) : begin_25_q;
      begin_26_q <= or_771 ? (begin_25_q & not_265_s6_q) : begin_26_q;
      begin_27_q <= or_771 ? (begin_26_q & not_265_s6_q) : begin_27_q;
      begin_28_q <= or_771 ? (begin_27_q & not_265_s6_q) : begin_28_q;
      begin_29_q <= or_771 ? (begin_28_q & not_265_s6_q) : begin_29_q;
      begin_30_q <= or_771 ? (begin_29_q & not_265_s6_q) : begin_30_q;
      begin_31_q <= or_771 ? (begin_30_q & not_265_s6_q) : begin_31_q;
      end_0_q <= or_836 ? (end_31_q | and_264_s6_q) : end_0_q;
      end_1_q <= or_836 ? (end_0_q & not_265_s6_q) : end_1_q;
      end_2_q <= or_836 ? (end_1_q & not_265_s6_q) : end_2_q;
      end_3_q <= or_836 ? (end_2_q & not_265_s6_q) : end_3_q;
      end_4_q <= or_836 ? (end_3_q & not_265_s6_q) : end_4_q;
      end_5_q <= or_836 ? (end_4_q & not_265_s6_q) : end_5_q;
      end_6_q <= or_836 ? (end_5_q & not_265_s6_q) : end_6_q;
      end_7_q <= or_836 ? (end_6_q & not_265_s6_q) : end_7_q;
      end_8_q <= or_836 ? (end_7_q & not_265_s6_q) : end_8_q;
      end_9_q <= or_836 ? (end_8_q & not_265_s6_q) : end_9_q;
      end_10_q <= or_836 ? (end_9_q & not_265_s6_q) : end_10_q;
      end_11_q <= or_836 ? (end_10_q & not_265_s6_q) : end_11_q;
      end_12_q <= or_836 ? (end_11_q & not_265_s6_q) : end_12_q;
      end_13_q <= or_836 ? (end_12_q & not_265_s6_q) : end_13_q;
      end_14_q <= or_836 ? (end_13_q & not_265_s6_q) : end_14_q;
      end_15_q <= or_836 ? (end_14_q & not_265_s6_q) : end_15_q;
      end_16_q <= or_836 ? (end_15_q & not_265_s6_q) : end_16_q;
      end_17_q <= or_836 ? (end_16_q & not_265_s6_q) : end_17_q;
      end_18_q <= or_836 ? (end_17_q & not_265_s6_q) : end_18_q;
      end_19_q <= or_836 ? (end_18_q & not_265_s6_q) : end_19_q;
      end_20_q <= or_836 ? (end_19_q & not_265_s6_q) : end_20_q;
      end_21_q <= or_836 ? (end_20_q & not_265_s6_q) : end_21_q;
      end_22_q <= or_836 ? (end_21_q & not_265_s6_q) : end_22_q;
      end_23_q <= or_836 ? (end_22_q & not_265_s6_q) : end_23_q;
      end_24_q <= or_836 ? (end_23_q & not_265_s6_q) : end_24_q;
      end_25_q <= or_836 ? (end_24_q & not_265_s6_q) : end_25_q;
      end_26_q <= or_836 ? (end_25_q & not_265_s6_q) : end_26_q;
      end_27_q <= or_836 ? (end_26_q & not_265_s6_q) : end_27_q;
      end_28_q <= or_836 ? (end_27_q & not_265_s6_q) : end_28_q;
      end_29_q <= or_836 ? (end_28_q & not_265_s6_q) : end_29_q;
      end_30_q <= or_836 ? (end_29_q & not_265_s6_q) : end_30_q;
      end_31_q <= or_836 ? (end_30_q & not_265_s6_q) : end_31_q;
      front_there_q <= and_442 ? (or_1352 | or_1383) : front_there_q;
    end
  end

  logic event_ends_s7_q;
  logic event_meets_s7_q;
  logic [10:0] event_run_left_s7_q;
  logic [10:0] event_run_right_s7_q;
  logic [10:0] event_run_row_s7_q;
  logic begin_0_s7_q;
  logic begin_1_s7_q;
  logic begin_2_s7_q;
  logic begin_3_s7_q;
  logic begin_4_s7_q;
  logic begin_5_s7_q;
  logic begin_6_s7_q;
  logic begin_7_s7_q;
  logic begin_8_s7_q;
  logic begin_9_s7_q;
  logic begin_10_s7_q;
  logic begin_11_s7_q;
  logic begin_12_s7_q;
  logic begin_13_s7_q;
  logic begin_14_s7_q;
  logic begin_15_s7_q;
  logic begin_16_s7_q;
  logic begin_17_s7_q;
  logic begin_18_s7_q;
  logic begin_19_s7_q;
  logic begin_20_s7_q;
  logic begin_21_s7_q;
  logic begin_22_s7_q;
  logic begin_23_s7_q;
  logic begin_24_s7_q;
  logic begin_25_s7_q;
  logic begin_26_s7_q;
  logic begin_27_s7_q;
  logic begin_28_s7_q;
  logic begin_29_s7_q;
  logic begin_30_s7_q;
  logic begin_31_s7_q;
  logic front_there_s7_q;
  logic and_264_s7_q;
  logic not_265_s7_q;
  logic equal_301_s7_q;
  logic and_321_s7_q;
  logic and_418_s7_q;
  logic and_442_s7_q;
  logic and_443_s7_q;
  logic and_444_s7_q;
  logic equal_452_s7_q;
  logic and_453_s7_q;
  logic and_455_s7_q;
  logic and_461_s7_q;
  logic and_471_s7_q;
  logic and_481_s7_q;
  logic and_491_s7_q;
  logic and_501_s7_q;
  logic and_511_s7_q;
  logic and_521_s7_q;
  logic and_531_s7_q;
  logic and_541_s7_q;
  logic and_551_s7_q;
  logic and_561_s7_q;
  logic and_571_s7_q;
  logic and_581_s7_q;
  logic and_591_s7_q;
  logic and_601_s7_q;
  logic and_611_s7_q;
  logic and_621_s7_q;
  logic and_631_s7_q;
  logic and_641_s7_q;
  logic and_651_s7_q;
  logic and_661_s7_q;
  logic and_671_s7_q;
  logic and_681_s7_q;
  logic and_691_s7_q;
  logic and_701_s7_q;
  logic and_711_s7_q;
  logic and_721_s7_q;
  logic and_731_s7_q;
  logic and_741_s7_q;
  logic and_751_s7_q;
  logic and_761_s7_q;
  logic and_1388_s7_q;
  logic and_1394_s7_q;
  logic and_1400_s7_q;
  logic and_1406_s7_q;
  logic and_1412_s7_q;
  logic and_1418_s7_q;
  logic and_1424_s7_q;
  logic and_1430_s7_q;
  logic and_1436_s7_q;
  logic and_1442_s7_q;
  logic and_1448_s7_q;
  logic and_1454_s7_q;
  logic and_1460_s7_q;
  logic and_1466_s7_q;
  logic and_1472_s7_q;
  logic and_1478_s7_q;
  logic and_1484_s7_q;
  logic and_1490_s7_q;
  logic and_1496_s7_q;
  logic and_1502_s7_q;
  logic and_1508_s7_q;
  logic and_1514_s7_q;
  logic and_1520_s7_q;
  logic and_1526_s7_q;
  logic and_1532_s7_q;
  logic and_1538_s7_q;
  logic and_1544_s7_q;
  logic and_1550_s7_q;
  logic and_1556_s7_q;
  logic and_1562_s7_q;
  logic and_1568_s7_q;
  logic and_1574_s7_q;
  logic or_1658_s7_q;
  logic and_1662_s7_q;
  logic and_1689_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      event_ends_s7_q <= event_ends_q;
      event_meets_s7_q <= event_meets_q;
      event_run_left_s7_q <= event_run_left_q;
      event_run_right_s7_q <= event_run_right_q;
      event_run_row_s7_q <= event_run_row_q;
      begin_0_s7_q <= begin_0_q;
      begin_1_s7_q <= begin_1_q;
      begin_2_s7_q <= begin_2_q;
      begin_3_s7_q <= begin_3_q;
      begin_4_s7_q <= begin_4_q;
      begin_5_s7_q <= begin_5_q;
      begin_6_s7_q <= begin_6_q;
      begin_7_s7_q <= begin_7_q;
      begin_8_s7_q <= begin_8_q;
      begin_9_s7_q <= begin_9_q;
      begin_10_s7_q <= begin_10_q;
      begin_11_s7_q <= begin_11_q;
      begin_12_s7_q <= begin_12_q;
      begin_13_s7_q <= begin_13_q;
      begin_14_s7_q <= begin_14_q;
      begin_15_s7_q <= begin_15_q;
      begin_16_s7_q <= begin_16_q;
      begin_17_s7_q <= begin_17_q;
      begin_18_s7_q <= begin_18_q;
      begin_19_s7_q <= begin_19_q;
      begin_20_s7_q <= begin_20_q;
      begin_21_s7_q <= begin_21_q;
      begin_22_s7_q <= begin_22_q;
      begin_23_s7_q <= begin_23_q;
      begin_24_s7_q <= begin_24_q;
      begin_25_s7_q <= begin_25_q;
      begin_26_s7_q <= begin_26_q;
      begin_27_s7_q <= begin_27_q;
      begin_28_s7_q <= begin_28_q;
      begin_29_s7_q <= begin_29_q;
      begin_30_s7_q <= begin_30_q;
      begin_31_s7_q <= begin_31_q;
      front_there_s7_q <= front_there_q;
      and_264_s7_q <= and_264_s6_q;
      not_265_s7_q <= not_265_s6_q;
      equal_301_s7_q <= equal_301_s6_q;
      and_321_s7_q <= busy_q & equal_320_s6_q;
      and_418_s7_q <= and_418;
      and_442_s7_q <= and_442;
      and_443_s7_q <= and_443;
      and_444_s7_q <= and_444;
      equal_452_s7_q <= equal_452_s6_q;
      and_453_s7_q <= and_453;
      and_455_s7_q <= and_455;
      and_461_s7_q <= and_461;
      and_471_s7_q <= and_471;
      and_481_s7_q <= and_481;
      and_491_s7_q <= and_491;
      and_501_s7_q <= and_501;
      and_511_s7_q <= and_511;
      and_521_s7_q <= and_521;
      and_531_s7_q <= and_531;
      and_541_s7_q <= and_541;
      and_551_s7_q <= and_551;
      and_561_s7_q <= and_561;
      and_571_s7_q <= and_571;
      and_581_s7_q <= and_581;
      and_591_s7_q <= and_591;
      and_601_s7_q <= and_601;
      and_611_s7_q <= and_611;
      and_621_s7_q <= and_621;
      and_631_s7_q <= and_631;
      and_641_s7_q <= and_641;
      and_651_s7_q <= and_651;
      and_661_s7_q <= and_661;
      and_671_s7_q <= and_671;
      and_681_s7_q <= and_681;
      and_691_s7_q <= and_691;
      and_701_s7_q <= and_701;
      and_711_s7_q <= and_711;
      and_721_s7_q <= and_721;
      and_731_s7_q <= and_731;
      and_741_s7_q <= and_741;
      and_751_s7_q <= and_751;
      and_761_s7_q <= and_761;
      and_1388_s7_q <= entries_0_there_q & front_there_q;
      and_1394_s7_q <= entries_1_there_q & front_there_q;
      and_1400_s7_q <= entries_2_there_q & front_there_q;
      and_1406_s7_q <= entries_3_there_q & front_there_q;
      and_1412_s7_q <= entries_4_there_q & front_there_q;
      and_1418_s7_q <= entries_5_there_q & front_there_q;
      and_1424_s7_q <= entries_6_there_q & front_there_q;
      and_1430_s7_q <= entries_7_there_q & front_there_q;
      and_1436_s7_q <= entries_8_there_q & front_there_q;
      and_1442_s7_q <= entries_9_there_q & front_there_q;
      and_1448_s7_q <= entries_10_there_q & front_there_q;
      and_1454_s7_q <= entries_11_there_q & front_there_q;
      and_1460_s7_q <= entries_12_there_q & front_there_q;
      and_1466_s7_q <= entries_13_there_q & front_there_q;
      and_1472_s7_q <= entries_14_there_q & front_there_q;
      and_1478_s7_q <= entries_15_there_q & front_there_q;
      and_1484_s7_q <= entries_16_there_q & front_there_q;
      and_1490_s7_q <= entries_17_there_q & front_there_q;
      and_1496_s7_q <= entries_18_there_q & front_there_q;
      and_1502_s7_q <= entries_19_there_q & front_there_q;
      and_1508_s7_q <= entries_20_there_q & front_there_q;
      and_1514_s7_q <= entries_21_there_q & front_there_q;
      and_1520_s7_q <= entries_22_there_q & front_there_q;
      and_1526_s7_q <= entries_23_there_q & front_there_q;
      and_1532_s7_q <= entries_24_there_q & front_there_q;
      and_1538_s7_q <= entries_25_there_q & front_there_q;
      and_1544_s7_q <= entries_26_there_q & front_there_q;
      and_1550_s7_q <= entries_27_there_q & front_there_q;
      and_1556_s7_q <= entries_28_there_q & front_there_q;
      and_1562_s7_q <= entries_29_there_q & front_there_q;
      and_1568_s7_q <= entries_30_there_q & front_there_q;
      and_1574_s7_q <= entries_31_there_q & front_there_q;
      or_1658_s7_q <= or_1658;
      and_1662_s7_q <= and_1662_s6_q;
      and_1689_s7_q <= idle_s6_q & and_422;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [4:0] entries_0_label_q;
  logic [4:0] entries_1_label_q;
  logic [4:0] entries_2_label_q;
  logic [4:0] entries_3_label_q;
  logic [4:0] entries_4_label_q;
  logic [4:0] entries_5_label_q;
  logic [4:0] entries_6_label_q;
  logic [4:0] entries_7_label_q;
  logic [4:0] entries_8_label_q;
  logic [4:0] entries_9_label_q;
  logic [4:0] entries_10_label_q;
  logic [4:0] entries_11_label_q;
  logic [4:0] entries_12_label_q;
  logic [4:0] entries_13_label_q;
  logic [4:0] entries_14_label_q;
  logic [4:0] entries_15_label_q;
  logic [4:0] entries_16_label_q;
  logic [4:0] entries_17_label_q;
  logic [4:0] entries_18_label_q;
  logic [4:0] entries_19_label_q;
  logic [4:0] entries_20_label_q;
  logic [4:0] entries_21_label_q;
  logic [4:0] entries_22_label_q;
  logic [4:0] entries_23_label_q;
  logic [4:0] entries_24_label_q;
  logic [4:0] entries_25_label_q;
  logic [4:0] entries_26_label_q;
  logic [4:0] entries_27_label_q;
  logic [4:0] entries_28_label_q;
  logic [4:0] entries_29_label_q;
  logic [4:0] entries_30_label_q;
  logic [4:0] entries_31_label_q;
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
  logic and_302;
  assign and_302 = second_q & equal_301_s7_q;
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
  // hls/stages/objects.hpp:371
  logic and_323;
  assign and_323 = and_321_s7_q & (event_ends_s7_q | joined_q);
  // hls/stages/objects.hpp:274
  logic and_445;
  assign and_445 = joined_q & and_321_s7_q;
  // hls/stages/objects.hpp:255
  logic [4:0] ended;
  assign ended = run_there_q ? run_label_q : free_label_q;
  // hls/stages/objects.hpp:289
  logic [4:0] label_2;
  assign label_2 = and_443_s7_q ? ended : run_label_q;
  // hls/stages/objects.hpp:296
  logic [4:0] select_451;
  assign select_451 = (and_444_s7_q | (and_445 & (begin_0_s7_q | same_0_q))) ? label_2 : entries_0_label_q;
  logic [4:0] select_465;
  assign select_465 = (and_461_s7_q | (and_445 & (begin_1_s7_q | same_1_q))) ? label_2 : entries_1_label_q;
  logic [4:0] select_475;
  assign select_475 = (and_471_s7_q | (and_445 & (begin_2_s7_q | same_2_q))) ? label_2 : entries_2_label_q;
  logic [4:0] select_485;
  assign select_485 = (and_481_s7_q | (and_445 & (begin_3_s7_q | same_3_q))) ? label_2 : entries_3_label_q;
  logic [4:0] select_495;
  assign select_495 = (and_491_s7_q | (and_445 & (begin_4_s7_q | same_4_q))) ? label_2 : entries_4_label_q;
  logic [4:0] select_505;
  assign select_505 = (and_501_s7_q | (and_445 & (begin_5_s7_q | same_5_q))) ? label_2 : entries_5_label_q;
  logic [4:0] select_515;
  assign select_515 = (and_511_s7_q | (and_445 & (begin_6_s7_q | same_6_q))) ? label_2 : entries_6_label_q;
  logic [4:0] select_525;
  assign select_525 = (and_521_s7_q | (and_445 & (begin_7_s7_q | same_7_q))) ? label_2 : entries_7_label_q;
  logic [4:0] select_535;
  assign select_535 = (and_531_s7_q | (and_445 & (begin_8_s7_q | same_8_q))) ? label_2 : entries_8_label_q;
  logic [4:0] select_545;
  assign select_545 = (and_541_s7_q | (and_445 & (begin_9_s7_q | same_9_q))) ? label_2 : entries_9_label_q;
  logic [4:0] select_555;
  assign select_555 = (and_551_s7_q | (and_445 & (begin_10_s7_q | same_10_q))) ? label_2 : entries_10_label_q;
  logic [4:0] select_565;
  assign select_565 = (and_561_s7_q | (and_445 & (begin_11_s7_q | same_11_q))) ? label_2 : entries_11_label_q;
  logic [4:0] select_575;
  assign select_575 = (and_571_s7_q | (and_445 & (begin_12_s7_q | same_12_q))) ? label_2 : entries_12_label_q;
  logic [4:0] select_585;
  assign select_585 = (and_581_s7_q | (and_445 & (begin_13_s7_q | same_13_q))) ? label_2 : entries_13_label_q;
  logic [4:0] select_595;
  assign select_595 = (and_591_s7_q | (and_445 & (begin_14_s7_q | same_14_q))) ? label_2 : entries_14_label_q;
  logic [4:0] select_605;
  assign select_605 = (and_601_s7_q | (and_445 & (begin_15_s7_q | same_15_q))) ? label_2 : entries_15_label_q;
  logic [4:0] select_615;
  assign select_615 = (and_611_s7_q | (and_445 & (begin_16_s7_q | same_16_q))) ? label_2 : entries_16_label_q;
  logic [4:0] select_625;
  assign select_625 = (and_621_s7_q | (and_445 & (begin_17_s7_q | same_17_q))) ? label_2 : entries_17_label_q;
  logic [4:0] select_635;
  assign select_635 = (and_631_s7_q | (and_445 & (begin_18_s7_q | same_18_q))) ? label_2 : entries_18_label_q;
  logic [4:0] select_645;
  assign select_645 = (and_641_s7_q | (and_445 & (begin_19_s7_q | same_19_q))) ? label_2 : entries_19_label_q;
  logic [4:0] select_655;
  assign select_655 = (and_651_s7_q | (and_445 & (begin_20_s7_q | same_20_q))) ? label_2 : entries_20_label_q;
  logic [4:0] select_665;
  assign select_665 = (and_661_s7_q | (and_445 & (begin_21_s7_q | same_21_q))) ? label_2 : entries_21_label_q;
  logic [4:0] select_675;
  assign select_675 = (and_671_s7_q | (and_445 & (begin_22_s7_q | same_22_q))) ? label_2 : entries_22_label_q;
  logic [4:0] select_685;
  assign select_685 = (and_681_s7_q | (and_445 & (begin_23_s7_q | same_23_q))) ? label_2 : entries_23_label_q;
  logic [4:0] select_695;
  assign select_695 = (and_691_s7_q | (and_445 & (begin_24_s7_q | same_24_q))) ? label_2 : entries_24_label_q;
  logic [4:0] select_705;
  assign select_705 = (and_701_s7_q | (and_445 & (begin_25_s7_q | same_25_q))) ? label_2 : entries_25_label_q;
  logic [4:0] select_715;
  assign select_715 = (and_711_s7_q | (and_445 & (begin_26_s7_q | same_26_q))) ? label_2 : entries_26_label_q;
  logic [4:0] select_725;
  assign select_725 = (and_721_s7_q | (and_445 & (begin_27_s7_q | same_27_q))) ? label_2 : entries_27_label_q;
  logic [4:0] select_735;
  assign select_735 = (and_731_s7_q | (and_445 & (begin_28_s7_q | same_28_q))) ? label_2 : entries_28_label_q;
  logic [4:0] select_745;
  assign select_745 = (and_741_s7_q | (and_445 & (begin_29_s7_q | same_29_q))) ? label_2 : entries_29_label_q;
  logic [4:0] select_755;
  assign select_755 = (and_751_s7_q | (and_445 & (begin_30_s7_q | same_30_q))) ? label_2 : entries_30_label_q;
  logic [4:0] select_765;
  assign select_765 = (and_761_s7_q | (and_445 & (begin_31_s7_q | same_31_q))) ? label_2 : entries_31_label_q;
  // hls/stages/objects.hpp:254
  logic not_901;
  assign not_901 = ~run_there_q;
  // hls/stages/objects.hpp:265
  logic and_903;
  assign and_903 = not_901 & (event_meets_s7_q & and_418_s7_q);
  // hls/stages/objects.hpp:272
  logic and_909;
  assign and_909 = not_265_s7_q & ((run_there_q & (~and_443_s7_q)) | (front_there_s7_q & and_903));
  // hls/stages/objects.hpp:281
  logic closes;
  assign closes = (not_303 & and_455_s7_q) & (~others_q);
  logic frees;
  assign frees = closes | (joined_q & and_453_s7_q);
  // hls/stages/objects.hpp:297
  logic not_917;
  assign not_917 = ~frees;
  // hls/stages/objects.hpp:318
  logic and_920;
  assign and_920 = looked_there_q & not_265_s7_q;
  // hls/stages/objects.hpp:316
  logic equal_921;
  assign equal_921 = looked_q == 4'hf;
  // hls/stages/objects.hpp:319
  logic and_923;
  assign and_923 = and_920 & (~equal_921);
  // hls/stages/objects.hpp:315
  logic not_924;
  assign not_924 = ~looked_q[0];
  // hls/stages/objects.hpp:298
  logic or_927;
  assign or_927 = (used_0_q & ((~(front_label_q == 5'h0)) | not_917)) | (and_923 & (group_0_q & not_924));
  // hls/stages/objects.hpp:315
  logic equal_933;
  assign equal_933 = looked_q[1:0] == 2'h1;
  // hls/stages/objects.hpp:298
  logic or_936;
  assign or_936 = (used_1_q & (not_917 | (~(front_label_q == 5'h1)))) | (and_923 & (group_0_q & equal_933));
  // hls/stages/objects.hpp:315
  logic equal_942;
  assign equal_942 = looked_q[2:0] == 3'h3;
  // hls/stages/objects.hpp:298
  logic or_945;
  assign or_945 = (used_2_q & (not_917 | (~(front_label_q == 5'h2)))) | (and_923 & (group_0_q & equal_942));
  // hls/stages/objects.hpp:315
  logic equal_951;
  assign equal_951 = looked_q == 4'h7;
  // hls/stages/objects.hpp:298
  logic or_954;
  assign or_954 = (used_3_q & (not_917 | (~(front_label_q == 5'h3)))) | (and_923 & (group_0_q & equal_951));
  logic or_962;
  assign or_962 = (used_4_q & (not_917 | (~(front_label_q == 5'h4)))) | (and_923 & (group_1_q & not_924));
  logic or_970;
  assign or_970 = (used_5_q & (not_917 | (~(front_label_q == 5'h5)))) | (and_923 & (group_1_q & equal_933));
  logic or_978;
  assign or_978 = (used_6_q & (not_917 | (~(front_label_q == 5'h6)))) | (and_923 & (group_1_q & equal_942));
  logic or_986;
  assign or_986 = (used_7_q & (not_917 | (~(front_label_q == 5'h7)))) | (and_923 & (group_1_q & equal_951));
  logic or_994;
  assign or_994 = (used_8_q & (not_917 | (~(front_label_q == 5'h8)))) | (and_923 & (group_2_q & not_924));
  logic or_1002;
  assign or_1002 = (used_9_q & (not_917 | (~(front_label_q == 5'h9)))) | (and_923 & (group_2_q & equal_933));
  logic or_1010;
  assign or_1010 = (used_10_q & (not_917 | (~(front_label_q == 5'ha)))) | (and_923 & (group_2_q & equal_942));
  logic or_1018;
  assign or_1018 = (used_11_q & (not_917 | (~(front_label_q == 5'hb)))) | (and_923 & (group_2_q & equal_951));
  logic or_1026;
  assign or_1026 = (used_12_q & (not_917 | (~(front_label_q == 5'hc)))) | (and_923 & (group_3_q & not_924));
  logic or_1034;
  assign or_1034 = (used_13_q & (not_917 | (~(front_label_q == 5'hd)))) | (and_923 & (group_3_q & equal_933));
  logic or_1042;
  assign or_1042 = (used_14_q & (not_917 | (~(front_label_q == 5'he)))) | (and_923 & (group_3_q & equal_942));
  logic or_1050;
  assign or_1050 = (used_15_q & (not_917 | (~(front_label_q == 5'hf)))) | (and_923 & (group_3_q & equal_951));
  logic or_1058;
  assign or_1058 = (used_16_q & (not_917 | (~(front_label_q == 5'h10)))) | (and_923 & (group_4_q & not_924));
  logic or_1066;
  assign or_1066 = (used_17_q & (not_917 | (~(front_label_q == 5'h11)))) | (and_923 & (group_4_q & equal_933));
  logic or_1074;
  assign or_1074 = (used_18_q & (not_917 | (~(front_label_q == 5'h12)))) | (and_923 & (group_4_q & equal_942));
  logic or_1082;
  assign or_1082 = (used_19_q & (not_917 | (~(front_label_q == 5'h13)))) | (and_923 & (group_4_q & equal_951));
  logic or_1090;
  assign or_1090 = (used_20_q & (not_917 | (~(front_label_q == 5'h14)))) | (and_923 & (group_5_q & not_924));
  logic or_1098;
  assign or_1098 = (used_21_q & (not_917 | (~(front_label_q == 5'h15)))) | (and_923 & (group_5_q & equal_933));
  logic or_1106;
  assign or_1106 = (used_22_q & (not_917 | (~(front_label_q == 5'h16)))) | (and_923 & (group_5_q & equal_942));
  logic or_1114;
  assign or_1114 = (used_23_q & (not_917 | (~(front_label_q == 5'h17)))) | (and_923 & (group_5_q & equal_951));
  logic or_1122;
  assign or_1122 = (used_24_q & (not_917 | (~(front_label_q == 5'h18)))) | (and_923 & (group_6_q & not_924));
  logic or_1130;
  assign or_1130 = (used_25_q & (not_917 | (~(front_label_q == 5'h19)))) | (and_923 & (group_6_q & equal_933));
  logic or_1138;
  assign or_1138 = (used_26_q & (not_917 | (~(front_label_q == 5'h1a)))) | (and_923 & (group_6_q & equal_942));
  logic or_1146;
  assign or_1146 = (used_27_q & (not_917 | (~(front_label_q == 5'h1b)))) | (and_923 & (group_6_q & equal_951));
  logic or_1154;
  assign or_1154 = (used_28_q & (not_917 | (~(front_label_q == 5'h1c)))) | (and_923 & (group_7_q & not_924));
  logic or_1162;
  assign or_1162 = (used_29_q & (not_917 | (~(front_label_q == 5'h1d)))) | (and_923 & (group_7_q & equal_933));
  logic or_1170;
  assign or_1170 = (used_30_q & (not_917 | (~(front_label_q == 5'h1e)))) | (and_923 & (group_7_q & equal_942));
  logic or_1178;
  assign or_1178 = (used_31_q & (not_917 | (~(front_label_q == 5'h1f)))) | (and_923 & (group_7_q & equal_951));
  // hls/stages/objects.hpp:254
  logic and_1180;
  assign and_1180 = and_443_s7_q & not_901;
  // hls/stages/objects.hpp:261
  logic not_1181;
  assign not_1181 = ~free_there_q;
  // hls/stages/objects.hpp:321
  logic and_1183;
  assign and_1183 = found_there_q & (and_1180 | not_1181);
  // hls/stages/objects.hpp:324
  logic or_1189;
  assign or_1189 = equal_933 | equal_951;
  logic or_1190;
  assign or_1190 = equal_942 | equal_951;
  // hls/stages/objects.hpp:343
  logic and_1195;
  assign and_1195 = equal_921 & and_920;
  // hls/stages/objects.hpp:336
  logic and_1214;
  assign and_1214 = used_0_q & group_0_q;
  logic and_1215;
  assign and_1215 = used_1_q & group_0_q;
  logic and_1216;
  assign and_1216 = used_2_q & group_0_q;
  logic and_1217;
  assign and_1217 = used_3_q & group_0_q;
  logic and_1218;
  assign and_1218 = used_4_q & group_1_q;
  logic and_1219;
  assign and_1219 = used_5_q & group_1_q;
  logic and_1220;
  assign and_1220 = used_6_q & group_1_q;
  logic and_1221;
  assign and_1221 = used_7_q & group_1_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used;
  assign used = {and_1217, and_1216, and_1215, and_1214} | {and_1221, and_1220, and_1219, and_1218};
  // hls/stages/objects.hpp:336
  logic and_1223;
  assign and_1223 = used_8_q & group_2_q;
  logic and_1224;
  assign and_1224 = used_9_q & group_2_q;
  logic and_1225;
  assign and_1225 = used_10_q & group_2_q;
  logic and_1226;
  assign and_1226 = used_11_q & group_2_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_2;
  assign used_2 = used | {and_1226, and_1225, and_1224, and_1223};
  // hls/stages/objects.hpp:336
  logic and_1228;
  assign and_1228 = used_12_q & group_3_q;
  logic and_1229;
  assign and_1229 = used_13_q & group_3_q;
  logic and_1230;
  assign and_1230 = used_14_q & group_3_q;
  logic and_1231;
  assign and_1231 = used_15_q & group_3_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_3;
  assign used_3 = used_2 | {and_1231, and_1230, and_1229, and_1228};
  // hls/stages/objects.hpp:336
  logic and_1233;
  assign and_1233 = used_16_q & group_4_q;
  logic and_1234;
  assign and_1234 = used_17_q & group_4_q;
  logic and_1235;
  assign and_1235 = used_18_q & group_4_q;
  logic and_1236;
  assign and_1236 = used_19_q & group_4_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_4;
  assign used_4 = used_3 | {and_1236, and_1235, and_1234, and_1233};
  // hls/stages/objects.hpp:336
  logic and_1238;
  assign and_1238 = used_20_q & group_5_q;
  logic and_1239;
  assign and_1239 = used_21_q & group_5_q;
  logic and_1240;
  assign and_1240 = used_22_q & group_5_q;
  logic and_1241;
  assign and_1241 = used_23_q & group_5_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_5;
  assign used_5 = used_4 | {and_1241, and_1240, and_1239, and_1238};
  // hls/stages/objects.hpp:336
  logic and_1243;
  assign and_1243 = used_24_q & group_6_q;
  logic and_1244;
  assign and_1244 = used_25_q & group_6_q;
  logic and_1245;
  assign and_1245 = used_26_q & group_6_q;
  logic and_1246;
  assign and_1246 = used_27_q & group_6_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_6;
  assign used_6 = used_5 | {and_1246, and_1245, and_1244, and_1243};
  // hls/stages/objects.hpp:336
  logic and_1248;
  assign and_1248 = used_28_q & group_7_q;
  logic and_1249;
  assign and_1249 = used_29_q & group_7_q;
  logic and_1250;
  assign and_1250 = used_30_q & group_7_q;
  logic and_1251;
  assign and_1251 = used_31_q & group_7_q;
  // hls/stages/objects.hpp:337
  logic [3:0] used_7;
  assign used_7 = used_6 | {and_1251, and_1250, and_1249, and_1248};
  // hls/stages/objects.hpp:341
  logic and_1257;
  assign and_1257 = not_265_s7_q & ((~looked_there_q) & (and_1183 | (~found_there_q)));
  // hls/stages/objects.hpp:166
  logic [4:0] or_1260;
  assign or_1260 = (begin_0_s7_q ? entries_0_label_q : 5'h0) | (begin_1_s7_q ? entries_1_label_q : 5'h0);
  logic [4:0] or_1263;
  assign or_1263 = (begin_2_s7_q ? entries_2_label_q : 5'h0) | (begin_3_s7_q ? entries_3_label_q : 5'h0);
  logic [4:0] or_1267;
  assign or_1267 = (begin_4_s7_q ? entries_4_label_q : 5'h0) | (begin_5_s7_q ? entries_5_label_q : 5'h0);
  logic [4:0] or_1270;
  assign or_1270 = (begin_6_s7_q ? entries_6_label_q : 5'h0) | (begin_7_s7_q ? entries_7_label_q : 5'h0);
  logic [4:0] or_1275;
  assign or_1275 = (begin_8_s7_q ? entries_8_label_q : 5'h0) | (begin_9_s7_q ? entries_9_label_q : 5'h0);
  logic [4:0] or_1278;
  assign or_1278 = (begin_10_s7_q ? entries_10_label_q : 5'h0) | (begin_11_s7_q ? entries_11_label_q : 5'h0);
  logic [4:0] or_1282;
  assign or_1282 = (begin_12_s7_q ? entries_12_label_q : 5'h0) | (begin_13_s7_q ? entries_13_label_q : 5'h0);
  logic [4:0] or_1285;
  assign or_1285 = (begin_14_s7_q ? entries_14_label_q : 5'h0) | (begin_15_s7_q ? entries_15_label_q : 5'h0);
  logic [4:0] or_1288;
  assign or_1288 = ((or_1260 | or_1263) | (or_1267 | or_1270)) | ((or_1275 | or_1278) | (or_1282 | or_1285));
  logic [4:0] or_1291;
  assign or_1291 = (begin_16_s7_q ? entries_16_label_q : 5'h0) | (begin_17_s7_q ? entries_17_label_q : 5'h0);
  logic [4:0] or_1294;
  assign or_1294 = (begin_18_s7_q ? entries_18_label_q : 5'h0) | (begin_19_s7_q ? entries_19_label_q : 5'h0);
  logic [4:0] or_1298;
  assign or_1298 = (begin_20_s7_q ? entries_20_label_q : 5'h0) | (begin_21_s7_q ? entries_21_label_q : 5'h0);
  logic [4:0] or_1301;
  assign or_1301 = (begin_22_s7_q ? entries_22_label_q : 5'h0) | (begin_23_s7_q ? entries_23_label_q : 5'h0);
  logic [4:0] or_1306;
  assign or_1306 = (begin_24_s7_q ? entries_24_label_q : 5'h0) | (begin_25_s7_q ? entries_25_label_q : 5'h0);
  logic [4:0] or_1309;
  assign or_1309 = (begin_26_s7_q ? entries_26_label_q : 5'h0) | (begin_27_s7_q ? entries_27_label_q : 5'h0);
  logic [4:0] or_1313;
  assign or_1313 = (begin_28_s7_q ? entries_28_label_q : 5'h0) | (begin_29_s7_q ? entries_29_label_q : 5'h0);
  logic [4:0] or_1316;
  assign or_1316 = (begin_30_s7_q ? entries_30_label_q : 5'h0) | (begin_31_s7_q ? entries_31_label_q : 5'h0);
  logic [4:0] or_1319;
  assign or_1319 = ((or_1291 | or_1294) | (or_1298 | or_1301)) | ((or_1306 | or_1309) | (or_1313 | or_1316));
  // hls/stages/objects.hpp:269
  logic and_1392;
  assign and_1392 = (and_1388_s7_q & (entries_0_label_q == front_label_q)) & (~begin_0_s7_q);
  logic and_1398;
  assign and_1398 = (and_1394_s7_q & (entries_1_label_q == front_label_q)) & (~begin_1_s7_q);
  logic and_1404;
  assign and_1404 = (and_1400_s7_q & (entries_2_label_q == front_label_q)) & (~begin_2_s7_q);
  logic and_1410;
  assign and_1410 = (and_1406_s7_q & (entries_3_label_q == front_label_q)) & (~begin_3_s7_q);
  logic and_1416;
  assign and_1416 = (and_1412_s7_q & (entries_4_label_q == front_label_q)) & (~begin_4_s7_q);
  logic and_1422;
  assign and_1422 = (and_1418_s7_q & (entries_5_label_q == front_label_q)) & (~begin_5_s7_q);
  logic and_1428;
  assign and_1428 = (and_1424_s7_q & (entries_6_label_q == front_label_q)) & (~begin_6_s7_q);
  logic and_1434;
  assign and_1434 = (and_1430_s7_q & (entries_7_label_q == front_label_q)) & (~begin_7_s7_q);
  logic and_1440;
  assign and_1440 = (and_1436_s7_q & (entries_8_label_q == front_label_q)) & (~begin_8_s7_q);
  logic and_1446;
  assign and_1446 = (and_1442_s7_q & (entries_9_label_q == front_label_q)) & (~begin_9_s7_q);
  logic and_1452;
  assign and_1452 = (and_1448_s7_q & (entries_10_label_q == front_label_q)) & (~begin_10_s7_q);
  logic and_1458;
  assign and_1458 = (and_1454_s7_q & (entries_11_label_q == front_label_q)) & (~begin_11_s7_q);
  logic and_1464;
  assign and_1464 = (and_1460_s7_q & (entries_12_label_q == front_label_q)) & (~begin_12_s7_q);
  logic and_1470;
  assign and_1470 = (and_1466_s7_q & (entries_13_label_q == front_label_q)) & (~begin_13_s7_q);
  logic and_1476;
  assign and_1476 = (and_1472_s7_q & (entries_14_label_q == front_label_q)) & (~begin_14_s7_q);
  logic and_1482;
  assign and_1482 = (and_1478_s7_q & (entries_15_label_q == front_label_q)) & (~begin_15_s7_q);
  logic and_1488;
  assign and_1488 = (and_1484_s7_q & (entries_16_label_q == front_label_q)) & (~begin_16_s7_q);
  logic and_1494;
  assign and_1494 = (and_1490_s7_q & (entries_17_label_q == front_label_q)) & (~begin_17_s7_q);
  logic and_1500;
  assign and_1500 = (and_1496_s7_q & (entries_18_label_q == front_label_q)) & (~begin_18_s7_q);
  logic and_1506;
  assign and_1506 = (and_1502_s7_q & (entries_19_label_q == front_label_q)) & (~begin_19_s7_q);
  logic and_1512;
  assign and_1512 = (and_1508_s7_q & (entries_20_label_q == front_label_q)) & (~begin_20_s7_q);
  logic and_1518;
  assign and_1518 = (and_1514_s7_q & (entries_21_label_q == front_label_q)) & (~begin_21_s7_q);
  logic and_1524;
  assign and_1524 = (and_1520_s7_q & (entries_22_label_q == front_label_q)) & (~begin_22_s7_q);
  logic and_1530;
  assign and_1530 = (and_1526_s7_q & (entries_23_label_q == front_label_q)) & (~begin_23_s7_q);
  logic and_1536;
  assign and_1536 = (and_1532_s7_q & (entries_24_label_q == front_label_q)) & (~begin_24_s7_q);
  logic and_1542;
  assign and_1542 = (and_1538_s7_q & (entries_25_label_q == front_label_q)) & (~begin_25_s7_q);
  logic and_1548;
  assign and_1548 = (and_1544_s7_q & (entries_26_label_q == front_label_q)) & (~begin_26_s7_q);
  logic and_1554;
  assign and_1554 = (and_1550_s7_q & (entries_27_label_q == front_label_q)) & (~begin_27_s7_q);
  logic and_1560;
  assign and_1560 = (and_1556_s7_q & (entries_28_label_q == front_label_q)) & (~begin_28_s7_q);
  logic and_1566;
  assign and_1566 = (and_1562_s7_q & (entries_29_label_q == front_label_q)) & (~begin_29_s7_q);
  logic and_1572;
  assign and_1572 = (and_1568_s7_q & (entries_30_label_q == front_label_q)) & (~begin_30_s7_q);
  logic and_1578;
  assign and_1578 = (and_1574_s7_q & (entries_31_label_q == front_label_q)) & (~begin_31_s7_q);
  // hls/stages/objects.hpp:276
  logic equal_1580;
  assign equal_1580 = {same_31_q, same_30_q, same_29_q, same_28_q, same_27_q, same_26_q, same_25_q, same_24_q, same_23_q, same_22_q, same_21_q, same_20_q, same_19_q, same_18_q, same_17_q, same_16_q, same_15_q, same_14_q, same_13_q, same_12_q, same_11_q, same_10_q, same_9_q, same_8_q, same_7_q, same_6_q, same_5_q, same_4_q, same_3_q, same_2_q, same_1_q, same_0_q} == 32'h0;
  // hls/stages/objects.hpp:267
  logic equal_1582;
  assign equal_1582 = run_label_q == front_label_q;
  // hls/stages/objects.hpp:280
  logic select_1586;
  assign select_1586 = and_321_s7_q ? ((~equal_1580) | (equal_1582 & (run_there_q & front_there_s7_q))) : others_q;
  // hls/stages/objects.hpp:267
  logic and_1590;
  assign and_1590 = (front_there_s7_q & (event_meets_s7_q & run_there_q)) & (~equal_1582);
  // hls/stages/objects.hpp:280
  logic [4:0] select_1593;
  assign select_1593 = and_321_s7_q ? (joined_q ? run_label_q : front_label_q) : other_q;
  // hls/stages/objects.hpp:95
  logic or_1663;
  assign or_1663 = (and_443_s7_q & (or_1658_s7_q | (not_901 & not_1181))) | and_1662_s7_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      entries_0_label_q <= 5'h0;
      entries_1_label_q <= 5'h0;
      entries_2_label_q <= 5'h0;
      entries_3_label_q <= 5'h0;
      entries_4_label_q <= 5'h0;
      entries_5_label_q <= 5'h0;
      entries_6_label_q <= 5'h0;
      entries_7_label_q <= 5'h0;
      entries_8_label_q <= 5'h0;
      entries_9_label_q <= 5'h0;
      entries_10_label_q <= 5'h0;
      entries_11_label_q <= 5'h0;
      entries_12_label_q <= 5'h0;
      entries_13_label_q <= 5'h0;
      entries_14_label_q <= 5'h0;
      entries_15_label_q <= 5'h0;
      entries_16_label_q <= 5'h0;
      entries_17_label_q <= 5'h0;
      entries_18_label_q <= 5'h0;
      entries_19_label_q <= 5'h0;
      entries_20_label_q <= 5'h0;
      entries_21_label_q <= 5'h0;
      entries_22_label_q <= 5'h0;
      entries_23_label_q <= 5'h0;
      entries_24_label_q <= 5'h0;
      entries_25_label_q <= 5'h0;
      entries_26_label_q <= 5'h0;
      entries_27_label_q <= 5'h0;
      entries_28_label_q <= 5'h0;
      entries_29_label_q <= 5'h0;
      entries_30_label_q <= 5'h0;
      entries_31_label_q <= 5'h0;
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
    end else if (s7_en) begin
      entries_0_label_q <= select_451;
      entries_1_label_q <= select_465;
      entries_2_label_q <= select_475;
      entries_3_label_q <= select_485;
      entries_4_label_q <= select_495;
      entries_5_label_q <= select_505;
      entries_6_label_q <= select_515;
      entries_7_label_q <= select_525;
      entries_8_label_q <= select_535;
      entries_9_label_q <= select_545;
      entries_10_label_q <= select_555;
      entries_11_label_q <= select_565;
      entries_12_label_q <= select_575;
      entries_13_label_q <= select_585;
      entries_14_label_q <= select_595;
      entries_15_label_q <= select_605;
      entries_16_label_q <= select_615;
      entries_17_label_q <= select_625;
      entries_18_label_q <= select_635;
      entries_19_label_q <= select_645;
      entries_20_label_q <= select_655;
      entries_21_label_q <= select_665;
      entries_22_label_q <= select_675;
      entries_23_label_q <= select_685;
      entries_24_label_q <= select_695;
      entries_25_label_q <= select_705;
      entries_26_label_q <= select_715;
      entries_27_label_q <= select_725;
      entries_28_label_q <= select_735;
      entries_29_label_q <= select_745;
      entries_30_label_q <= select_755;
      entries_31_label_q <= select_765;
      run_label_q <= and_903 ? front_label_q : run_label_q;
      run_there_q <= and_909;
      used_0_q <= not_265_s7_q & or_927;
      used_1_q <= not_265_s7_q & or_936;
      used_2_q <= not_265_s7_q & or_945;
      used_3_q <= not_265_s7_q & or_954;
      used_4_q <= not_265_s7_q & or_962;
      used_5_q <= not_265_s7_q & or_970;
      used_6_q <= not_265_s7_q & or_978;
      used_7_q <= not_265_s7_q & or_986;
      used_8_q <= not_265_s7_q & or_994;
      used_9_q <= not_265_s7_q & or_1002;
      used_10_q <= not_265_s7_q & or_1010;
      used_11_q <= not_265_s7_q & or_1018;
      used_12_q <= not_265_s7_q & or_1026;
      used_13_q <= not_265_s7_q & or_1034;
      used_14_q <= not_265_s7_q & or_1042;
      used_15_q <= not_265_s7_q & or_1050;
      used_16_q <= not_265_s7_q & or_1058;
      used_17_q <= not_265_s7_q & or_1066;
      used_18_q <= not_265_s7_q & or_1074;
      used_19_q <= not_265_s7_q & or_1082;
      used_20_q <= not_265_s7_q & or_1090;
      used_21_q <= not_265_s7_q & or_1098;
      used_22_q <= not_265_s7_q & or_1106;
      used_23_q <= not_265_s7_q & or_1114;
      used_24_q <= not_265_s7_q & or_1122;
      used_25_q <= not_265_s7_q & or_1130;
      used_26_q <= not_265_s7_q & or_1138;
      used_27_q <= not_265_s7_q & or_1146;
      used_28_q <= not_265_s7_q & or_1154;
      used_29_q <= not_265_s7_q & or_1162;
      used_30_q <= not_265_s7_q & or_1170;
      used_31_q <= not_265_s7_q & or_1178;
      free_label_q <= and_1183 ? found_label_q : free_label_q;
      free_there_q <= not_265_s7_q & (and_1183 | (free_there_q & (~and_1180)));
      found_label_q <= and_923 ? {at_group_q, or_1190, or_1189} : found_label_q;
      found_there_q <= not_265_s7_q & (and_923 | (found_there_q ^ and_1183));
      group_0_q <= and_264_s7_q | (and_1195 ? group_7_q : group_0_q);
      group_1_q <= not_265_s7_q & (and_1195 ? group_0_q : group_1_q);
      group_2_q <= not_265_s7_q & (and_1195 ? group_1_q : group_2_q);
      group_3_q <= not_265_s7_q & (and_1195 ? group_2_q : group_3_q);
      group_4_q <= not_265_s7_q & (and_1195 ? group_3_q : group_4_q);
      group_5_q <= not_265_s7_q & (and_1195 ? group_4_q : group_5_q);
      group_6_q <= not_265_s7_q & (and_1195 ? group_5_q : group_6_q);
      group_7_q <= not_265_s7_q & (and_1195 ? group_6_q : group_7_q);
      at_group_q <= and_264_s7_q ? 3'h0 : (at_group_q + {2'h0, and_1195});
      looked_q <= used_7;
      looked_there_q <= and_1257;
      front_label_q <= and_442_s7_q ? (or_1288 | or_1319) : front_label_q;
      label_q <= and_442_s7_q ? ended : label_q;
      fresh_q <= and_442_s7_q ? not_901 : fresh_q;
      same_0_q <= and_418_s7_q ? and_1392 : same_0_q;
      same_1_q <= and_418_s7_q ? and_1398 : same_1_q;
      same_2_q <= and_418_s7_q ? and_1404 : same_2_q;
      same_3_q <= and_418_s7_q ? and_1410 : same_3_q;
      same_4_q <= and_418_s7_q ? and_1416 : same_4_q;
      same_5_q <= and_418_s7_q ? and_1422 : same_5_q;
      same_6_q <= and_418_s7_q ? and_1428 : same_6_q;
      same_7_q <= and_418_s7_q ? and_1434 : same_7_q;
      same_8_q <= and_418_s7_q ? and_1440 : same_8_q;
      same_9_q <= and_418_s7_q ? and_1446 : same_9_q;
      same_10_q <= and_418_s7_q ? and_1452 : same_10_q;
      same_11_q <= and_418_s7_q ? and_1458 : same_11_q;
      same_12_q <= and_418_s7_q ? and_1464 : same_12_q;
      same_13_q <= and_418_s7_q ? and_1470 : same_13_q;
      same_14_q <= and_418_s7_q ? and_1476 : same_14_q;
      same_15_q <= and_418_s7_q ? and_1482 : same_15_q;
      same_16_q <= and_418_s7_q ? and_1488 : same_16_q;
      same_17_q <= and_418_s7_q ? and_1494 : same_17_q;
      same_18_q <= and_418_s7_q ? and_1500 : same_18_q;
      same_19_q <= and_418_s7_q ? and_1506 : same_19_q;
      same_20_q <= and_418_s7_q ? and_1512 : same_20_q;
      same_21_q <= and_418_s7_q ? and_1518 : same_21_q;
      same_22_q <= and_418_s7_q ? and_1524 : same_22_q;
      same_23_q <= and_418_s7_q ? and_1530 : same_23_q;
      same_24_q <= and_418_s7_q ? and_1536 : same_24_q;
      same_25_q <= and_418_s7_q ? and_1542 : same_25_q;
      same_26_q <= and_418_s7_q ? and_1548 : same_26_q;
      same_27_q <= and_418_s7_q ? and_1554 : same_27_q;
      same_28_q <= and_418_s7_q ? and_1560 : same_28_q;
      same_29_q <= and_418_s7_q ? and_1566 : same_29_q;
      same_30_q <= and_418_s7_q ? and_1572 : same_30_q;
      same_31_q <= and_418_s7_q ? and_1578 : same_31_q;
      others_q <= select_1586;
      joined_q <= and_418_s7_q ? and_1590 : joined_q;
      other_q <= select_1593;
      second_q <= equal_452_s7_q ? frees : second_q;
      second_ends_q <= equal_452_s7_q ? closes : second_ends_q;
      overflow_q <= or_1663 | (~(and_264_s7_q | (~overflow_q)));
    end
  end

  logic [10:0] event_run_left_s8_q;
  logic [10:0] event_run_right_s8_q;
  logic [10:0] event_run_row_s8_q;
  logic not_265_s8_q;
  logic and_302_s8_q;
  logic [4:0] select_311_s8_q;
  logic [4:0] select_318_s8_q;
  logic or_324_s8_q;
  logic and_326_s8_q;
  logic not_362_s8_q;
  logic and_1681_s8_q;
  logic and_1689_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      event_run_left_s8_q <= event_run_left_s7_q;
      event_run_right_s8_q <= event_run_right_s7_q;
      event_run_row_s8_q <= event_run_row_s7_q;
      not_265_s8_q <= not_265_s7_q;
      and_302_s8_q <= and_302;
      select_311_s8_q <= select_304[2] ? select_307 : {4'h0, select_310};
      select_318_s8_q <= select_304[2] ? select_314 : select_317;
      or_324_s8_q <= and_302 | and_323;
      and_326_s8_q <= fresh_q & and_323;
      not_362_s8_q <= ~(and_302 ? second_ends_q : joined_q);
      and_1681_s8_q <= second_ends_q & and_302;
      and_1689_s8_q <= and_1689_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:379
  logic [4:0] label;
  assign label = and_302_s8_q ? select_311_s8_q : select_318_s8_q;
  // hls/stages/objects.hpp:393
  logic [10:0] pixels;
  assign pixels = (event_run_right_s8_q - event_run_left_s8_q) + 11'h1;

  // Memory objects, 32 x 129, DISTANCE 8, hls/stages/objects.hpp:457; read in stage 8, written in stage 12: 8 < 12 < 8 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [128:0] objects_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) objects_mem[i] = 129'h0;
`endif
  logic [4:0] objects_raddr;
  assign objects_raddr = label;
  logic objects_re;
  assign objects_re = s8_en & or_324_s8_q;
  logic [128:0] objects_rdata_q;
  always_ff @(posedge clk_i) begin
    if (objects_re) objects_rdata_q <= objects_mem[objects_raddr];
  end

  logic [10:0] event_run_left_s9_q;
  logic [10:0] event_run_right_s9_q;
  logic [10:0] event_run_row_s9_q;
  logic not_265_s9_q;
  logic and_302_s9_q;
  logic [4:0] label_s9_q;
  logic or_324_s9_q;
  logic and_326_s9_q;
  logic [10:0] pixels_s9_q;
  logic [11:0] sum_348_s9_q;
  logic not_362_s9_q;
  logic or_1667_s9_q;
  logic and_1681_s9_q;
  logic and_1689_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      event_run_left_s9_q <= event_run_left_s8_q;
      event_run_right_s9_q <= event_run_right_s8_q;
      event_run_row_s9_q <= event_run_row_s8_q;
      not_265_s9_q <= not_265_s8_q;
      and_302_s9_q <= and_302_s8_q;
      label_s9_q <= label;
      or_324_s9_q <= or_324_s8_q;
      and_326_s9_q <= and_326_s8_q;
      pixels_s9_q <= pixels;
      sum_348_s9_q <= {1'b0, event_run_left_s8_q} + {1'b0, event_run_right_s8_q};
      not_362_s9_q <= not_362_s8_q;
      or_1667_s9_q <= overflow_q;
      and_1681_s9_q <= and_1681_s8_q;
      and_1689_s9_q <= and_1689_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:398
  logic [22:0] product_349;
  assign product_349 = {12'h0, pixels_s9_q} * {11'h0, sum_348_s9_q};
  // hls/stages/objects.hpp:399
  logic [21:0] product_355;
  assign product_355 = {11'h0, event_run_row_s9_q} * {11'h0, pixels_s9_q};

  logic [10:0] event_run_left_s10_q;
  logic [10:0] event_run_right_s10_q;
  logic [10:0] event_run_row_s10_q;
  logic not_265_s10_q;
  logic and_302_s10_q;
  logic [4:0] label_s10_q;
  logic or_324_s10_q;
  logic [128:0] objects_rdata_s10_q;
  logic and_326_s10_q;
  logic [10:0] pixels_s10_q;
  logic [21:0] product_349_s10_q;
  logic [21:0] product_355_s10_q;
  logic not_362_s10_q;
  logic or_1667_s10_q;
  logic and_1681_s10_q;
  logic and_1689_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      event_run_left_s10_q <= event_run_left_s9_q;
      event_run_right_s10_q <= event_run_right_s9_q;
      event_run_row_s10_q <= event_run_row_s9_q;
      not_265_s10_q <= not_265_s9_q;
      and_302_s10_q <= and_302_s9_q;
      label_s10_q <= label_s9_q;
      or_324_s10_q <= or_324_s9_q;
      objects_rdata_s10_q <= objects_rdata_q;
      and_326_s10_q <= and_326_s9_q;
      pixels_s10_q <= pixels_s9_q;
      product_349_s10_q <= product_349[22:1];
      product_355_s10_q <= product_355;
      not_362_s10_q <= not_362_s9_q;
      or_1667_s10_q <= or_1667_s9_q;
      and_1681_s10_q <= and_1681_s9_q;
      and_1689_s10_q <= and_1689_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic [20:0] joining_pixels_q;
  logic [10:0] joining_left_q;
  logic [10:0] joining_right_q;
  logic [10:0] joining_top_q;
  logic [10:0] joining_bottom_q;
  logic [31:0] joining_columns_q;
  logic [31:0] joining_rows_q;
  // hls/stages/objects.hpp:404
  logic [20:0] sum_330;
  assign sum_330 = objects_rdata_s10_q[20:0] + (and_302_s10_q ? joining_pixels_q : {10'h0, pixels_s10_q});
  // hls/stages/objects.hpp:376
  logic [10:0] select_332;
  assign select_332 = and_302_s10_q ? joining_left_q : event_run_left_s10_q;
  logic [10:0] select_336;
  assign select_336 = and_302_s10_q ? joining_right_q : event_run_right_s10_q;
  logic [10:0] select_340;
  assign select_340 = and_302_s10_q ? joining_top_q : event_run_row_s10_q;
  logic [10:0] select_344;
  assign select_344 = and_302_s10_q ? joining_bottom_q : event_run_row_s10_q;
  logic [31:0] b;
  assign b = and_302_s10_q ? joining_columns_q : {10'h0, product_349_s10_q};
  // hls/stages/objects.hpp:416
  logic [16:0] low;
  assign low = {1'b0, objects_rdata_s10_q[80:65]} + {1'b0, b[15:0]};
  // hls/stages/objects.hpp:376
  logic [31:0] b_2;
  assign b_2 = and_302_s10_q ? joining_rows_q : {10'h0, product_355_s10_q};
  // hls/stages/objects.hpp:416
  logic [16:0] low_2;
  assign low_2 = {1'b0, objects_rdata_s10_q[112:97]} + {1'b0, b_2[15:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      joining_pixels_q <= 21'h0;
      joining_left_q <= 11'h0;
      joining_right_q <= 11'h0;
      joining_top_q <= 11'h0;
      joining_bottom_q <= 11'h0;
      joining_columns_q <= 32'h0;
      joining_rows_q <= 32'h0;
    end else if (s10_en) begin
      joining_pixels_q <= or_324_s10_q ? objects_rdata_s10_q[20:0] : joining_pixels_q;
      joining_left_q <= or_324_s10_q ? objects_rdata_s10_q[31:21] : joining_left_q;
      joining_right_q <= or_324_s10_q ? objects_rdata_s10_q[42:32] : joining_right_q;
      joining_top_q <= or_324_s10_q ? objects_rdata_s10_q[53:43] : joining_top_q;
      joining_bottom_q <= or_324_s10_q ? objects_rdata_s10_q[64:54] : joining_bottom_q;
      joining_columns_q <= or_324_s10_q ? objects_rdata_s10_q[96:65] : joining_columns_q;
      joining_rows_q <= or_324_s10_q ? objects_rdata_s10_q[128:97] : joining_rows_q;
    end
  end

  logic [10:0] event_run_left_s11_q;
  logic [10:0] event_run_right_s11_q;
  logic [10:0] event_run_row_s11_q;
  logic not_265_s11_q;
  logic [4:0] label_s11_q;
  logic or_324_s11_q;
  logic [43:0] objects_rdata_s11_q;
  logic and_326_s11_q;
  logic [10:0] pixels_s11_q;
  logic [20:0] sum_330_s11_q;
  logic [10:0] select_332_s11_q;
  logic less_333_s11_q;
  logic [10:0] select_336_s11_q;
  logic less_337_s11_q;
  logic [10:0] select_340_s11_q;
  logic less_341_s11_q;
  logic [10:0] select_344_s11_q;
  logic less_345_s11_q;
  logic [21:0] product_349_s11_q;
  logic [16:0] low_s11_q;
  logic [15:0] sum_352_s11_q;
  logic [21:0] product_355_s11_q;
  logic [16:0] low_2_s11_q;
  logic [15:0] sum_358_s11_q;
  logic not_362_s11_q;
  logic or_1667_s11_q;
  logic and_1681_s11_q;
  logic [20:0] select_1682_s11_q;
  logic [31:0] select_1687_s11_q;
  logic [31:0] select_1688_s11_q;
  logic and_1689_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      event_run_left_s11_q <= event_run_left_s10_q;
      event_run_right_s11_q <= event_run_right_s10_q;
      event_run_row_s11_q <= event_run_row_s10_q;
      not_265_s11_q <= not_265_s10_q;
      label_s11_q <= label_s10_q;
      or_324_s11_q <= or_324_s10_q;
      objects_rdata_s11_q <= objects_rdata_s10_q[64:21];
      and_326_s11_q <= and_326_s10_q;
      pixels_s11_q <= pixels_s10_q;
      sum_330_s11_q <= sum_330;
      select_332_s11_q <= select_332;
      less_333_s11_q <= select_332 < objects_rdata_s10_q[31:21];
      select_336_s11_q <= select_336;
      less_337_s11_q <= objects_rdata_s10_q[42:32] < select_336;
      select_340_s11_q <= select_340;
      less_341_s11_q <= select_340 < objects_rdata_s10_q[53:43];
      select_344_s11_q <= select_344;
      less_345_s11_q <= objects_rdata_s10_q[64:54] < select_344;
      product_349_s11_q <= product_349_s10_q;
      low_s11_q <= low;
      sum_352_s11_q <= objects_rdata_s10_q[96:81] + b[31:16];
      product_355_s11_q <= product_355_s10_q;
      low_2_s11_q <= low_2;
      sum_358_s11_q <= objects_rdata_s10_q[128:113] + b_2[31:16];
      not_362_s11_q <= not_362_s10_q;
      or_1667_s11_q <= or_1667_s10_q;
      and_1681_s11_q <= and_1681_s10_q;
      select_1682_s11_q <= or_324_s10_q ? objects_rdata_s10_q[20:0] : 21'h0;
      select_1687_s11_q <= or_324_s10_q ? objects_rdata_s10_q[96:65] : 32'h0;
      select_1688_s11_q <= or_324_s10_q ? objects_rdata_s10_q[128:97] : 32'h0;
      and_1689_s11_q <= and_1689_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:382
  logic [20:0] select_331;
  assign select_331 = and_326_s11_q ? {10'h0, pixels_s11_q} : sum_330_s11_q;
  logic [10:0] select_335;
  assign select_335 = and_326_s11_q ? event_run_left_s11_q : (less_333_s11_q ? select_332_s11_q : objects_rdata_s11_q[10:0]);
  logic [10:0] select_339;
  assign select_339 = and_326_s11_q ? event_run_right_s11_q : (less_337_s11_q ? select_336_s11_q : objects_rdata_s11_q[21:11]);
  logic [10:0] select_343;
  assign select_343 = and_326_s11_q ? event_run_row_s11_q : (less_341_s11_q ? select_340_s11_q : objects_rdata_s11_q[32:22]);
  logic [10:0] select_347;
  assign select_347 = and_326_s11_q ? event_run_row_s11_q : (less_345_s11_q ? select_344_s11_q : objects_rdata_s11_q[43:33]);
  // hls/stages/objects.hpp:418
  logic [15:0] sum_353;
  assign sum_353 = {15'h0, low_s11_q[16]} + sum_352_s11_q;
  // hls/stages/objects.hpp:382
  logic [31:0] select_354;
  assign select_354 = and_326_s11_q ? {10'h0, product_349_s11_q} : {sum_353, low_s11_q[15:0]};
  // hls/stages/objects.hpp:418
  logic [15:0] sum_359;
  assign sum_359 = {15'h0, low_2_s11_q[16]} + sum_358_s11_q;
  // hls/stages/objects.hpp:382
  logic [31:0] select_360;
  assign select_360 = and_326_s11_q ? {10'h0, product_355_s11_q} : {sum_359, low_2_s11_q[15:0]};
  // hls/stages/objects.hpp:87
  logic and_1678;
  assign and_1678 = or_324_s11_q & (not_362_s11_q & (~(select_331 < cfg_object_limit_i)));

  logic not_265_s12_q;
  logic [4:0] label_s12_q;
  logic [20:0] select_331_s12_q;
  logic [10:0] select_335_s12_q;
  logic [10:0] select_339_s12_q;
  logic [10:0] select_343_s12_q;
  logic [10:0] select_347_s12_q;
  logic [31:0] select_354_s12_q;
  logic [31:0] select_360_s12_q;
  logic and_363_s12_q;
  logic or_1667_s12_q;
  logic and_1678_s12_q;
  logic and_1681_s12_q;
  logic [20:0] select_1682_s12_q;
  logic [10:0] select_1683_s12_q;
  logic [10:0] select_1684_s12_q;
  logic [10:0] select_1685_s12_q;
  logic [10:0] select_1686_s12_q;
  logic [31:0] select_1687_s12_q;
  logic [31:0] select_1688_s12_q;
  logic and_1689_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      not_265_s12_q <= not_265_s11_q;
      label_s12_q <= label_s11_q;
      select_331_s12_q <= select_331;
      select_335_s12_q <= select_335;
      select_339_s12_q <= select_339;
      select_343_s12_q <= select_343;
      select_347_s12_q <= select_347;
      select_354_s12_q <= select_354;
      select_360_s12_q <= select_360;
      and_363_s12_q <= not_362_s11_q & or_324_s11_q;
      or_1667_s12_q <= or_1667_s11_q;
      and_1678_s12_q <= and_1678;
      and_1681_s12_q <= and_1681_s11_q;
      select_1682_s12_q <= select_1682_s11_q;
      select_1683_s12_q <= or_324_s11_q ? objects_rdata_s11_q[10:0] : 11'h0;
      select_1684_s12_q <= or_324_s11_q ? objects_rdata_s11_q[21:11] : 11'h0;
      select_1685_s12_q <= or_324_s11_q ? objects_rdata_s11_q[32:22] : 11'h0;
      select_1686_s12_q <= or_324_s11_q ? objects_rdata_s11_q[43:33] : 11'h0;
      select_1687_s12_q <= select_1687_s11_q;
      select_1688_s12_q <= select_1688_s11_q;
      and_1689_s12_q <= and_1689_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  logic alarm_q;

  // Memory objects, write
  logic [4:0] objects_waddr;
  assign objects_waddr = label_s12_q;
  logic objects_we;
  assign objects_we = s12_en & and_363_s12_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (objects_we) objects_mem[objects_waddr] <= {select_360_s12_q, select_354_s12_q, select_347_s12_q, select_343_s12_q, select_339_s12_q, select_335_s12_q, select_331_s12_q};
  end
`ifndef SYNTHESIS
  logic [4:0] objects_raddr_s9_sim;
  logic objects_re_s9_sim;
  logic [4:0] objects_raddr_s10_sim;
  logic objects_re_s10_sim;
  logic [4:0] objects_raddr_s11_sim;
  logic objects_re_s11_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      objects_re_s9_sim <= 1'b0;
      objects_re_s10_sim <= 1'b0;
      objects_re_s11_sim <= 1'b0;
    end else if (en_i) begin
      objects_re_s9_sim <= objects_re;
      objects_raddr_s9_sim <= objects_raddr;
      objects_re_s10_sim <= objects_re_s9_sim;
      objects_raddr_s10_sim <= objects_raddr_s9_sim;
      objects_re_s11_sim <= objects_re_s10_sim;
      objects_raddr_s11_sim <= objects_raddr_s10_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && objects_we) begin
      if (objects_re && objects_raddr == objects_waddr) begin
        $error("objects: address %0d is read less than DISTANCE steps after its write", objects_waddr);
      end
      if (objects_re_s9_sim && objects_raddr_s9_sim == objects_waddr) begin
        $error("objects: address %0d is read less than DISTANCE steps after its write", objects_waddr);
      end
      if (objects_re_s10_sim && objects_raddr_s10_sim == objects_waddr) begin
        $error("objects: address %0d is read less than DISTANCE steps after its write", objects_waddr);
      end
      if (objects_re_s11_sim && objects_raddr_s11_sim == objects_waddr) begin
        $error("objects: address %0d is read less than DISTANCE steps after its write", objects_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      alarm_q <= 1'b0;
    end else if (s12_en) begin
      alarm_q <= and_1678_s12_q | (alarm_q & not_265_s12_q);
    end
  end

  logic or_1667_s13_q;
  logic and_1681_s13_q;
  logic [20:0] select_1682_s13_q;
  logic [10:0] select_1683_s13_q;
  logic [10:0] select_1684_s13_q;
  logic [10:0] select_1685_s13_q;
  logic [10:0] select_1686_s13_q;
  logic [31:0] select_1687_s13_q;
  logic [31:0] select_1688_s13_q;
  logic and_1689_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
      or_1667_s13_q <= or_1667_s12_q;
      and_1681_s13_q <= and_1681_s12_q;
      select_1682_s13_q <= select_1682_s12_q;
      select_1683_s13_q <= select_1683_s12_q;
      select_1684_s13_q <= select_1684_s12_q;
      select_1685_s13_q <= select_1685_s12_q;
      select_1686_s13_q <= select_1686_s12_q;
      select_1687_s13_q <= select_1687_s12_q;
      select_1688_s13_q <= select_1688_s12_q;
      and_1689_s13_q <= and_1689_s12_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign ended_o = and_1681_s13_q;
  assign object_pixels_o = select_1682_s13_q;
  assign object_left_o = select_1683_s13_q;
  assign object_right_o = select_1684_s13_q;
  assign object_top_o = select_1685_s13_q;
  assign object_bottom_o = select_1686_s13_q;
  assign object_columns_o = select_1687_s13_q;
  assign object_rows_o = select_1688_s13_q;
  assign alarm_o = alarm_q;
  assign overflow_o = or_1667_s13_q;
  assign done_o = and_1689_s13_q;
  assign valid_o = valid_s13_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^product_349[0];

endmodule
