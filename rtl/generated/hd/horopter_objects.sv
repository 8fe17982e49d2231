// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Objects<horopter::hls::profiles::hd>, hls/stages/objects.hpp. Do not edit.
//
// Latency 14 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 772 bits, pipeline 2266 bits, memories 12736 bits.
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
  input  logic [20:0] cfg_object_limit_i,
  input  logic [31:0] cfg_object_area_limit_i,
  output logic valid_o,
  output logic ended_o,
  output logic [20:0] object_pixels_o,
  output logic [20:0] object_blind_o,
  output logic [31:0] object_area_o,
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s10_en, s11_en, s12_en, s13_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;
  assign s10_en = en_i & valid_s10_q;
  assign s11_en = en_i & valid_s11_q;
  assign s12_en = en_i & valid_s12_q;
  assign s13_en = en_i & valid_s13_q;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_rows_q;
  logic raster_row_ended_q;
  // hls/stages/objects.hpp:213
  logic or_268;
  assign or_268 = first_i | raster_row_ended_q;
  logic [10:0] x;
  assign x = or_268 ? 11'h0 : raster_column_q;
  // hls/stages/objects.hpp:87
  logic not_270;
  assign not_270 = ~idle_i;
  // hls/stages/objects.hpp:213
  logic and_288;
  assign and_288 = raster_rows_q & (~first_i);

  // Memory above, 1920 x 1, DISTANCE 16, hls/stages/objects.hpp:448; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic above_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) above_mem[i] = 1'b0;
`endif
  logic [10:0] above_raddr;
  assign above_raddr = x;
`ifndef SYNTHESIS
  logic above_re;
  assign above_re = s0_en & not_270;
`endif
  logic above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_rows_q <= 1'b0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= idle_i ? raster_column_q : (x + 11'h1);
      raster_rows_q <= idle_i ? raster_rows_q : (last_i | and_288);
      raster_row_ended_q <= idle_i ? raster_row_ended_q : last_i;
    end
  end

  logic occupied_s1_q;
  logic idle_s1_q;
  logic [7:0] area_s1_q;
  logic blind_s1_q;
  logic [10:0] x_s1_q;
  logic not_270_s1_q;
  logic and_272_s1_q;
  logic or_281_s1_q;
  logic and_288_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      occupied_s1_q <= occupied_i;
      idle_s1_q <= idle_i;
      area_s1_q <= area_i;
      blind_s1_q <= blind_i;
      x_s1_q <= x;
      not_270_s1_q <= not_270;
      and_272_s1_q <= first_i & not_270;
      or_281_s1_q <= idle_i | or_268;
      and_288_s1_q <= and_288;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  // Memory above, write
  logic [10:0] above_waddr;
  assign above_waddr = x_s1_q;
  logic above_we;
  assign above_we = s1_en & not_270_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= occupied_s1_q;
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
  logic [7:0] area_s2_q;
  logic blind_s2_q;
  logic [10:0] x_s2_q;
  logic not_270_s2_q;
  logic above_rdata_s2_q;
  logic and_272_s2_q;
  logic or_281_s2_q;
  logic and_288_s2_q;
  logic and_293_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      idle_s2_q <= idle_s1_q;
      area_s2_q <= area_s1_q;
      blind_s2_q <= blind_s1_q;
      x_s2_q <= x_s1_q;
      not_270_s2_q <= not_270_s1_q;
      above_rdata_s2_q <= above_rdata_q;
      and_272_s2_q <= and_272_s1_q;
      or_281_s2_q <= or_281_s1_q;
      and_288_s2_q <= and_288_s1_q;
      and_293_s2_q <= occupied_s1_q & not_270_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic before_v_q;
  logic over_before_q;
  logic ended_q;
  // hls/stages/objects.hpp:88
  logic not_273;
  assign not_273 = ~and_272_s2_q;
  // hls/stages/objects.hpp:225
  logic and_280;
  assign and_280 = ended_q & not_273;
  // hls/stages/objects.hpp:223
  logic not_282;
  assign not_282 = ~or_281_s2_q;
  // hls/stages/objects.hpp:225
  logic and_284;
  assign and_284 = before_v_q & not_273;
  logic and_286;
  assign and_286 = over_before_q & not_273;
  // hls/stages/objects.hpp:100
  logic and_290;
  assign and_290 = not_270_s2_q & (above_rdata_s2_q & and_288_s2_q);
  // hls/stages/objects.hpp:223
  logic and_291;
  assign and_291 = and_290 & not_282;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_v_q <= 1'b0;
      over_before_q <= 1'b0;
      ended_q <= 1'b0;
    end else if (s2_en) begin
      before_v_q <= and_293_s2_q;
      over_before_q <= and_290;
      ended_q <= not_282 & (and_284 & (~and_293_s2_q));
    end
  end

  logic idle_s3_q;
  logic [7:0] area_s3_q;
  logic blind_s3_q;
  logic [10:0] x_s3_q;
  logic not_270_s3_q;
  logic and_272_s3_q;
  logic not_273_s3_q;
  logic select_285_s3_q;
  logic or_292_s3_q;
  logic and_296_s3_q;
  logic and_304_s3_q;
  logic or_380_s3_q;
  logic or_385_s3_q;
  logic and_430_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      idle_s3_q <= idle_s2_q;
      area_s3_q <= area_s2_q;
      blind_s3_q <= blind_s2_q;
      x_s3_q <= x_s2_q;
      not_270_s3_q <= not_270_s2_q;
      and_272_s3_q <= and_272_s2_q;
      not_273_s3_q <= not_273;
      select_285_s3_q <= (and_280 | not_282) ? and_280 : and_284;
      or_292_s3_q <= and_286 | and_291;
      and_296_s3_q <= not_282 & (and_284 | (and_293_s2_q & not_282));
      and_304_s3_q <= and_286 & (~and_291);
      or_380_s3_q <= idle_s2_q | not_282;
      or_385_s3_q <= or_281_s2_q | (~and_284);
      and_430_s3_q <= (~before_v_q) & ((~over_before_q) & (~ended_q));
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
  // hls/stages/objects.hpp:326
  logic equal_274;
  assign equal_274 = phase_q == 4'h0;
  // hls/stages/objects.hpp:374
  logic equal_275;
  assign equal_275 = read_q == visible_q;
  logic not_276;
  assign not_276 = ~equal_275;
  // hls/stages/objects.hpp:100
  logic and_297;
  assign and_297 = or_292_s3_q & and_296_s3_q;
  // hls/stages/objects.hpp:230
  logic and_300;
  assign and_300 = (met_q & not_273_s3_q) & (~select_285_s3_q);
  // hls/stages/objects.hpp:231
  logic and_302;
  assign and_302 = and_297 & (~and_300);
  // hls/stages/objects.hpp:232
  logic or_306;
  assign or_306 = and_304_s3_q | (select_285_s3_q | and_302);
  // hls/stages/objects.hpp:249
  logic [3:0] select_393;
  assign select_393 = area_s3_q[3] ? {area_s3_q[2:0], 1'b0} : {1'b1, area_s3_q[2:0]};
  logic [6:0] select_394;
  assign select_394 = area_s3_q[4] ? {area_s3_q[3], select_393, 2'h0} : {2'h0, area_s3_q[3], select_393};
  logic [10:0] select_395;
  assign select_395 = area_s3_q[5] ? {select_394, 4'h0} : {4'h0, select_394};
  // hls/stages/objects.hpp:240
  logic [5:0] select_410;
  assign select_410 = and_272_s3_q ? 6'h0 : (or_306 ? (little_room_q ? write_q : (write_q + 6'h1)) : write_q);
  // hls/stages/objects.hpp:99
  logic [5:0] select_414;
  assign select_414 = and_272_s3_q ? 6'h0 : (equal_274 ? (equal_275 ? read_q : (read_q + 6'h1)) : read_q);
  // hls/stages/objects.hpp:89
  logic [5:0] room;
  assign room = read_q - write_q;
  // hls/stages/objects.hpp:88
  logic little_room;
  assign little_room = not_273_s3_q & (({2'h0, room_q} + 8'hff) < 8'h7);
  // hls/stages/objects.hpp:327
  logic and_432;
  assign and_432 = (~(not_270_s3_q | not_276)) & ((write_q == read_q) & and_430_s3_q);

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
      met_q <= (and_297 | and_300) & (~and_304_s3_q);
      write_q <= select_410;
      read_q <= select_414;
      visible_q <= and_272_s3_q ? 6'h0 : (equal_274 ? write_q : visible_q);
      room_q <= and_272_s3_q ? 6'h0 : room;
      little_room_q <= little_room;
      phase_q <= phase_q + 4'h1;
    end
  end

  logic idle_s4_q;
  logic area_s4_q;
  logic blind_s4_q;
  logic [5:0] write_s4_q;
  logic [5:0] read_s4_q;
  logic [3:0] phase_s4_q;
  logic [10:0] x_s4_q;
  logic and_272_s4_q;
  logic not_273_s4_q;
  logic equal_274_s4_q;
  logic equal_275_s4_q;
  logic not_276_s4_q;
  logic and_278_s4_q;
  logic select_285_s4_q;
  logic and_293_s4_q;
  logic and_302_s4_q;
  logic and_304_s4_q;
  logic and_308_s4_q;
  logic or_380_s4_q;
  logic or_385_s4_q;
  logic less_392_s4_q;
  logic [18:0] select_396_s4_q;
  logic and_432_s4_q;
  logic and_1689_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      idle_s4_q <= idle_s3_q;
      area_s4_q <= area_s3_q[7];
      blind_s4_q <= blind_s3_q;
      write_s4_q <= write_q;
      read_s4_q <= read_q;
      phase_s4_q <= phase_q;
      x_s4_q <= x_s3_q;
      and_272_s4_q <= and_272_s3_q;
      not_273_s4_q <= not_273_s3_q;
      equal_274_s4_q <= equal_274;
      equal_275_s4_q <= equal_275;
      not_276_s4_q <= not_276;
      and_278_s4_q <= not_273_s3_q & (equal_274 & not_276);
      select_285_s4_q <= select_285_s3_q;
      and_293_s4_q <= before_v_q;
      and_302_s4_q <= and_302;
      and_304_s4_q <= and_304_s3_q;
      and_308_s4_q <= or_306 & (~little_room_q);
      or_380_s4_q <= or_380_s3_q;
      or_385_s4_q <= or_385_s3_q;
      less_392_s4_q <= 4'ha < area_s3_q[7:4];
      select_396_s4_q <= area_s3_q[6] ? {select_395, 8'h0} : {8'h0, select_395};
      and_432_s4_q <= and_432;
      and_1689_s4_q <= little_room_q & or_306;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [10:0] row_q;
  // hls/stages/objects.hpp:249
  logic [24:0] select_397;
  assign select_397 = area_s4_q ? {select_396_s4_q[8:0], 16'h0} : {6'h0, select_396_s4_q};
  logic not_399;
  assign not_399 = ~(select_397[4:0] == 5'h0);
  logic [3:0] sum_400;
  assign sum_400 = select_397[8:5] + {3'h0, not_399};

  // Memory queue, 64 x 78, DISTANCE 16, hls/stages/objects.hpp:455; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [77:0] queue_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) queue_mem[i] = 78'h0;
`endif
  logic [5:0] queue_raddr;
  assign queue_raddr = read_s4_q;
`ifndef SYNTHESIS
  logic queue_re;
  assign queue_re = s4_en & and_278_s4_q;
`endif
  logic [77:0] queue_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) queue_rdata_q <= queue_mem[queue_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 11'h0;
    end else if (s4_en) begin
      row_q <= or_380_s4_q ? row_q : (and_272_s4_q ? 11'h0 : (row_q + 11'h1));
    end
  end

  logic idle_s5_q;
  logic blind_s5_q;
  logic [5:0] write_s5_q;
  logic [3:0] phase_s5_q;
  logic [10:0] x_s5_q;
  logic and_272_s5_q;
  logic not_273_s5_q;
  logic equal_274_s5_q;
  logic equal_275_s5_q;
  logic not_276_s5_q;
  logic select_285_s5_q;
  logic and_293_s5_q;
  logic and_302_s5_q;
  logic and_304_s5_q;
  logic and_308_s5_q;
  logic or_385_s5_q;
  logic [19:0] select_401_s5_q;
  logic and_432_s5_q;
  logic and_1689_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      idle_s5_q <= idle_s4_q;
      blind_s5_q <= blind_s4_q;
      write_s5_q <= write_s4_q;
      phase_s5_q <= phase_s4_q;
      x_s5_q <= x_s4_q;
      and_272_s5_q <= and_272_s4_q;
      not_273_s5_q <= not_273_s4_q;
      equal_274_s5_q <= equal_274_s4_q;
      equal_275_s5_q <= equal_275_s4_q;
      not_276_s5_q <= not_276_s4_q;
      select_285_s5_q <= select_285_s4_q;
      and_293_s5_q <= and_293_s4_q;
      and_302_s5_q <= and_302_s4_q;
      and_304_s5_q <= and_304_s4_q;
      and_308_s5_q <= and_308_s4_q;
      or_385_s5_q <= or_385_s4_q;
      select_401_s5_q <= less_392_s4_q ? 20'hfffff : {select_397[24:9], sum_400};
      and_432_s5_q <= and_432_s4_q;
      and_1689_s5_q <= and_1689_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [10:0] last_run_left_q;
  logic [10:0] last_run_right_q;
  logic [10:0] last_run_row_q;
  logic [30:0] last_run_area_q;
  logic [10:0] last_run_blind_q;
  // hls/stages/objects.hpp:100
  logic [10:0] x_2;
  assign x_2 = idle_s5_q ? last_run_right_q : x_s5_q;
  // hls/stages/objects.hpp:254
  logic [10:0] select_388;
  assign select_388 = and_293_s5_q ? (or_385_s5_q ? x_2 : last_run_left_q) : last_run_left_q;
  // hls/stages/objects.hpp:249
  logic [30:0] sum_402;
  assign sum_402 = (or_385_s5_q ? 31'h0 : last_run_area_q) + {11'h0, select_401_s5_q};
  // hls/stages/objects.hpp:254
  logic [10:0] select_406;
  assign select_406 = and_293_s5_q ? ({10'h0, blind_s5_q} + (or_385_s5_q ? 11'h0 : last_run_blind_q)) : last_run_blind_q;

  // Memory queue, write
  logic [5:0] queue_waddr;
  assign queue_waddr = write_s5_q;
  logic queue_we;
  assign queue_we = s5_en & and_308_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (queue_we) queue_mem[queue_waddr] <= {last_run_blind_q, last_run_area_q, last_run_row_q, last_run_right_q, last_run_left_q, and_304_s5_q, and_302_s5_q, select_285_s5_q};
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
      last_run_area_q <= 31'h0;
      last_run_blind_q <= 11'h0;
    end else if (s5_en) begin
      last_run_left_q <= select_388;
      last_run_right_q <= and_293_s5_q ? x_2 : last_run_right_q;
      last_run_row_q <= and_293_s5_q ? row_q : last_run_row_q;
      last_run_area_q <= and_293_s5_q ? sum_402 : last_run_area_q;
      last_run_blind_q <= select_406;
    end
  end

  logic idle_s6_q;
  logic and_272_s6_q;
  logic not_273_s6_q;
  logic equal_274_s6_q;
  logic equal_275_s6_q;
  logic not_276_s6_q;
  logic [77:0] queue_rdata_s6_q;
  logic equal_309_s6_q;
  logic equal_316_s6_q;
  logic and_432_s6_q;
  logic equal_438_s6_q;
  logic equal_468_s6_q;
  logic equal_479_s6_q;
  logic and_1689_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      idle_s6_q <= idle_s5_q;
      and_272_s6_q <= and_272_s5_q;
      not_273_s6_q <= not_273_s5_q;
      equal_274_s6_q <= equal_274_s5_q;
      equal_275_s6_q <= equal_275_s5_q;
      not_276_s6_q <= not_276_s5_q;
      queue_rdata_s6_q <= queue_rdata_q;
      equal_309_s6_q <= phase_s5_q == 4'hb;
      equal_316_s6_q <= phase_s5_q == 4'h3;
      and_432_s6_q <= and_432_s5_q;
      equal_438_s6_q <= phase_s5_q == 4'h2;
      equal_468_s6_q <= phase_s5_q == 4'h1;
      equal_479_s6_q <= phase_s5_q == 4'h4;
      and_1689_s6_q <= and_1689_s5_q;
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
  logic [30:0] event_run_area_q;
  logic [10:0] event_run_blind_q;
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
  // hls/stages/objects.hpp:99
  logic and_435;
  assign and_435 = not_273_s6_q & (equal_274_s6_q ? (not_276_s6_q | and_432_s6_q) : busy_q);
  logic select_437;
  assign select_437 = and_272_s6_q ? draining_q : (equal_274_s6_q ? and_432_s6_q : draining_q);
  // hls/stages/objects.hpp:271
  logic and_439;
  assign and_439 = busy_q & equal_438_s6_q;
  // hls/stages/objects.hpp:99
  logic and_443;
  assign and_443 = not_273_s6_q & (and_439 ? (draining_q & (~front_there_q)) : done_q);
  logic select_445;
  assign select_445 = equal_274_s6_q ? (queue_rdata_s6_q[0] & not_276_s6_q) : event_ends_q;
  logic select_448;
  assign select_448 = equal_274_s6_q ? (queue_rdata_s6_q[1] & not_276_s6_q) : event_meets_q;
  logic select_451;
  assign select_451 = equal_274_s6_q ? (queue_rdata_s6_q[2] | equal_275_s6_q) : event_passes_q;
  logic [10:0] select_454;
  assign select_454 = equal_274_s6_q ? (equal_275_s6_q ? event_run_left_q : queue_rdata_s6_q[13:3]) : event_run_left_q;
  logic [10:0] select_457;
  assign select_457 = equal_274_s6_q ? (equal_275_s6_q ? event_run_right_q : queue_rdata_s6_q[24:14]) : event_run_right_q;
  logic [10:0] select_460;
  assign select_460 = equal_274_s6_q ? (equal_275_s6_q ? event_run_row_q : queue_rdata_s6_q[35:25]) : event_run_row_q;
  logic [30:0] select_463;
  assign select_463 = equal_274_s6_q ? (equal_275_s6_q ? event_run_area_q : queue_rdata_s6_q[66:36]) : event_run_area_q;
  logic [10:0] select_466;
  assign select_466 = equal_274_s6_q ? (equal_275_s6_q ? event_run_blind_q : queue_rdata_s6_q[77:67]) : event_run_blind_q;
  // hls/stages/objects.hpp:271
  logic and_469;
  assign and_469 = busy_q & equal_468_s6_q;
  // hls/stages/objects.hpp:275
  logic and_470;
  assign and_470 = event_ends_q & and_469;
  // hls/stages/objects.hpp:315
  logic and_471;
  assign and_471 = end_0_q & and_470;
  // hls/stages/objects.hpp:272
  logic and_480;
  assign and_480 = busy_q & equal_479_s6_q;
  // hls/stages/objects.hpp:301
  logic and_482;
  assign and_482 = front_there_q & (event_passes_q & and_480);
  // hls/stages/objects.hpp:317
  logic and_487;
  assign and_487 = not_273_s6_q & (and_471 | (entries_0_there_q & (~(begin_0_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_488;
  assign and_488 = end_1_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_497;
  assign and_497 = not_273_s6_q & (and_488 | (entries_1_there_q & (~(begin_1_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_498;
  assign and_498 = end_2_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_507;
  assign and_507 = not_273_s6_q & (and_498 | (entries_2_there_q & (~(begin_2_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_508;
  assign and_508 = end_3_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_517;
  assign and_517 = not_273_s6_q & (and_508 | (entries_3_there_q & (~(begin_3_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_518;
  assign and_518 = end_4_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_527;
  assign and_527 = not_273_s6_q & (and_518 | (entries_4_there_q & (~(begin_4_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_528;
  assign and_528 = end_5_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_537;
  assign and_537 = not_273_s6_q & (and_528 | (entries_5_there_q & (~(begin_5_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_538;
  assign and_538 = end_6_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_547;
  assign and_547 = not_273_s6_q & (and_538 | (entries_6_there_q & (~(begin_6_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_548;
  assign and_548 = end_7_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_557;
  assign and_557 = not_273_s6_q & (and_548 | (entries_7_there_q & (~(begin_7_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_558;
  assign and_558 = end_8_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_567;
  assign and_567 = not_273_s6_q & (and_558 | (entries_8_there_q & (~(begin_8_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_568;
  assign and_568 = end_9_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_577;
  assign and_577 = not_273_s6_q & (and_568 | (entries_9_there_q & (~(begin_9_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_578;
  assign and_578 = end_10_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_587;
  assign and_587 = not_273_s6_q & (and_578 | (entries_10_there_q & (~(begin_10_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_588;
  assign and_588 = end_11_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_597;
  assign and_597 = not_273_s6_q & (and_588 | (entries_11_there_q & (~(begin_11_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_598;
  assign and_598 = end_12_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_607;
  assign and_607 = not_273_s6_q & (and_598 | (entries_12_there_q & (~(begin_12_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_608;
  assign and_608 = end_13_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_617;
  assign and_617 = not_273_s6_q & (and_608 | (entries_13_there_q & (~(begin_13_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_618;
  assign and_618 = end_14_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_627;
  assign and_627 = not_273_s6_q & (and_618 | (entries_14_there_q & (~(begin_14_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_628;
  assign and_628 = end_15_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_637;
  assign and_637 = not_273_s6_q & (and_628 | (entries_15_there_q & (~(begin_15_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_638;
  assign and_638 = end_16_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_647;
  assign and_647 = not_273_s6_q & (and_638 | (entries_16_there_q & (~(begin_16_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_648;
  assign and_648 = end_17_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_657;
  assign and_657 = not_273_s6_q & (and_648 | (entries_17_there_q & (~(begin_17_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_658;
  assign and_658 = end_18_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_667;
  assign and_667 = not_273_s6_q & (and_658 | (entries_18_there_q & (~(begin_18_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_668;
  assign and_668 = end_19_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_677;
  assign and_677 = not_273_s6_q & (and_668 | (entries_19_there_q & (~(begin_19_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_678;
  assign and_678 = end_20_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_687;
  assign and_687 = not_273_s6_q & (and_678 | (entries_20_there_q & (~(begin_20_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_688;
  assign and_688 = end_21_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_697;
  assign and_697 = not_273_s6_q & (and_688 | (entries_21_there_q & (~(begin_21_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_698;
  assign and_698 = end_22_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_707;
  assign and_707 = not_273_s6_q & (and_698 | (entries_22_there_q & (~(begin_22_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_708;
  assign and_708 = end_23_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_717;
  assign and_717 = not_273_s6_q & (and_708 | (entries_23_there_q & (~(begin_23_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_718;
  assign and_718 = end_24_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_727;
  assign and_727 = not_273_s6_q & (and_718 | (entries_24_there_q & (~(begin_24_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_728;
  assign and_728 = end_25_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_737;
  assign and_737 = not_273_s6_q & (and_728 | (entries_25_there_q & (~(begin_25_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_738;
  assign and_738 = end_26_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_747;
  assign and_747 = not_273_s6_q & (and_738 | (entries_26_there_q & (~(begin_26_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_748;
  assign and_748 = end_27_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_757;
  assign and_757 = not_273_s6_q & (and_748 | (entries_27_there_q & (~(begin_27_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_758;
  assign and_758 = end_28_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_767;
  assign and_767 = not_273_s6_q & (and_758 | (entries_28_there_q & (~(begin_28_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_768;
  assign and_768 = end_29_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_777;
  assign and_777 = not_273_s6_q & (and_768 | (entries_29_there_q & (~(begin_29_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_778;
  assign and_778 = end_30_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_787;
  assign and_787 = not_273_s6_q & (and_778 | (entries_30_there_q & (~(begin_30_q & and_482))));
  // hls/stages/objects.hpp:315
  logic and_788;
  assign and_788 = end_31_q & and_470;
  // hls/stages/objects.hpp:317
  logic and_797;
  assign and_797 = not_273_s6_q & (and_788 | (entries_31_there_q & (~(begin_31_q & and_482))));
  // hls/stages/objects.hpp:321
  logic or_798;
  assign or_798 = and_272_s6_q | and_482;
  // hls/stages/objects.hpp:322
  logic or_863;
  assign or_863 = and_272_s6_q | and_470;
  // hls/stages/objects.hpp:180
  logic or_1351;
  assign or_1351 = (entries_0_there_q & begin_0_q) | (entries_1_there_q & begin_1_q);
  logic or_1354;
  assign or_1354 = (entries_2_there_q & begin_2_q) | (entries_3_there_q & begin_3_q);
  logic or_1358;
  assign or_1358 = (entries_4_there_q & begin_4_q) | (entries_5_there_q & begin_5_q);
  logic or_1361;
  assign or_1361 = (entries_6_there_q & begin_6_q) | (entries_7_there_q & begin_7_q);
  logic or_1366;
  assign or_1366 = (entries_8_there_q & begin_8_q) | (entries_9_there_q & begin_9_q);
  logic or_1369;
  assign or_1369 = (entries_10_there_q & begin_10_q) | (entries_11_there_q & begin_11_q);
  logic or_1373;
  assign or_1373 = (entries_12_there_q & begin_12_q) | (entries_13_there_q & begin_13_q);
  logic or_1376;
  assign or_1376 = (entries_14_there_q & begin_14_q) | (entries_15_there_q & begin_15_q);
  logic or_1379;
  assign or_1379 = ((or_1351 | or_1354) | (or_1358 | or_1361)) | ((or_1366 | or_1369) | (or_1373 | or_1376));
  logic or_1382;
  assign or_1382 = (entries_16_there_q & begin_16_q) | (entries_17_there_q & begin_17_q);
  logic or_1385;
  assign or_1385 = (entries_18_there_q & begin_18_q) | (entries_19_there_q & begin_19_q);
  logic or_1389;
  assign or_1389 = (entries_20_there_q & begin_20_q) | (entries_21_there_q & begin_21_q);
  logic or_1392;
  assign or_1392 = (entries_22_there_q & begin_22_q) | (entries_23_there_q & begin_23_q);
  logic or_1397;
  assign or_1397 = (entries_24_there_q & begin_24_q) | (entries_25_there_q & begin_25_q);
  logic or_1400;
  assign or_1400 = (entries_26_there_q & begin_26_q) | (entries_27_there_q & begin_27_q);
  logic or_1404;
  assign or_1404 = (entries_28_there_q & begin_28_q) | (entries_29_there_q & begin_29_q);
  logic or_1407;
  assign or_1407 = (entries_30_there_q & begin_30_q) | (entries_31_there_q & begin_31_q);
  logic or_1410;
  assign or_1410 = ((or_1382 | or_1385) | (or_1389 | or_1392)) | ((or_1397 | or_1400) | (or_1404 | or_1407));
  logic or_1629;
  assign or_1629 = ((entries_0_there_q & end_0_q) | (entries_1_there_q & end_1_q)) | ((entries_2_there_q & end_2_q) | (entries_3_there_q & end_3_q));
  logic or_1636;
  assign or_1636 = ((entries_4_there_q & end_4_q) | (entries_5_there_q & end_5_q)) | ((entries_6_there_q & end_6_q) | (entries_7_there_q & end_7_q));
  logic or_1643;
  assign or_1643 = (entries_10_there_q & end_10_q) | (entries_11_there_q & end_11_q);
  logic or_1644;
  assign or_1644 = ((entries_8_there_q & end_8_q) | (entries_9_there_q & end_9_q)) | or_1643;
  logic or_1647;
  assign or_1647 = (entries_12_there_q & end_12_q) | (entries_13_there_q & end_13_q);
  logic or_1650;
  assign or_1650 = (entries_14_there_q & end_14_q) | (entries_15_there_q & end_15_q);
  logic or_1656;
  assign or_1656 = (entries_16_there_q & end_16_q) | (entries_17_there_q & end_17_q);
  logic or_1659;
  assign or_1659 = (entries_18_there_q & end_18_q) | (entries_19_there_q & end_19_q);
  logic or_1663;
  assign or_1663 = (entries_20_there_q & end_20_q) | (entries_21_there_q & end_21_q);
  logic or_1666;
  assign or_1666 = (entries_22_there_q & end_22_q) | (entries_23_there_q & end_23_q);
  logic or_1671;
  assign or_1671 = (entries_24_there_q & end_24_q) | (entries_25_there_q & end_25_q);
  logic or_1674;
  assign or_1674 = (entries_26_there_q & end_26_q) | (entries_27_there_q & end_27_q);
  logic or_1678;
  assign or_1678 = (entries_28_there_q & end_28_q) | (entries_29_there_q & end_29_q);
  logic or_1681;
  assign or_1681 = (entries_30_there_q & end_30_q) | (entries_31_there_q & end_31_q);
  logic or_1684;
  assign or_1684 = ((or_1656 | or_1659) | (or_1663 | or_1666)) | ((or_1671 | or_1674) | (or_1678 | or_1681));
  logic or_1685;
  assign or_1685 = ((or_1629 | or_1636) | (or_1644 | (or_1647 | or_1650))) | or_1684;

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
      event_run_area_q <= 31'h0;
      event_run_blind_q <= 11'h0;
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
      busy_q <= and_435;
      draining_q <= select_437;
      done_q <= and_443;
      event_ends_q <= and_272_s6_q ? event_ends_q : select_445;
      event_meets_q <= and_272_s6_q ? event_meets_q : select_448;
      event_passes_q <= and_272_s6_q ? event_passes_q : select_451;
      event_run_left_q <= and_272_s6_q ? event_run_left_q : select_454;
      event_run_right_q <= and_272_s6_q ? event_run_right_q : select_457;
      event_run_row_q <= and_272_s6_q ? event_run_row_q : select_460;
      event_run_area_q <= and_272_s6_q ? event_run_area_q : select_463;
      event_run_blind_q <= and_272_s6_q ? event_run_blind_q : select_466;
      entries_0_there_q <= and_487;
      entries_1_there_q <= and_497;
      entries_2_there_q <= and_507;
      entries_3_there_q <= and_517;
      entries_4_there_q <= and_527;
      entries_5_there_q <= and_537;
      entries_6_there_q <= and_547;
      entries_7_there_q <= and_557;
      entries_8_there_q <= and_567;
      entries_9_there_q <= and_577;
      entries_10_there_q <= and_587;
      entries_11_there_q <= and_597;
      entries_12_there_q <= and_607;
      entries_13_there_q <= and_617;
      entries_14_there_q <= and_627;
      entries_15_there_q <= and_637;
      entries_16_there_q <= and_647;
      entries_17_there_q <= and_657;
      entries_18_there_q <= and_667;
      entries_19_there_q <= and_677;
      entries_20_there_q <= and_687;
      entries_21_there_q <= and_697;
      entries_22_there_q <= and_707;
      entries_23_there_q <= and_717;
      entries_24_there_q <= and_727;
      entries_25_there_q <= and_737;
      entries_26_there_q <= and_747;
      entries_27_there_q <= and_757;
      entries_28_there_q <= and_767;
      entries_29_there_q <= and_777;
      entries_30_there_q <= and_787;
      entries_31_there_q <= and_797;
      begin_0_q <= or_798 ? (begin_31_q | and_272_s6_q) : begin_0_q;
      begin_1_q <= or_798 ? (begin_0_q & not_273_s6_q) : begin_1_q;
      begin_2_q <= or_798 ? (begin_1_q & not_273_s6_q) : begin_2_q;
      begin_3_q <= or_798 ? (begin_2_q & not_273_s6_q) : begin_3_q;
      begin_4_q <= or_798 ? (begin_3_q & not_273_s6_q) : begin_4_q;
      begin_5_q <= or_798 ? (begin_4_q & not_273_s6_q) : begin_5_q;
      begin_6_q <= or_798 ? (begin_5_q & not_273_s6_q) : begin_6_q;
      begin_7_q <= or_798 ? (begin_6_q & not_273_s6_q) : begin_7_q;
      begin_8_q <= or_798 ? (begin_7_q & not_273_s6_q) : begin_8_q;
      begin_9_q <= or_798 ? (begin_8_q & not_273_s6_q) : begin_9_q;
      begin_10_q <= or_798 ? (begin_9_q & not_273_s6_q) : begin_10_q;
      begin_11_q <= or_798 ? (begin_10_q & not_273_s6_q) : begin_11_q;
      begin_12_q <= or_798 ? (begin_11_q & not_273_s6_q) : begin_12_q;
      begin_13_q <= or_798 ? (begin_12_q & not_273_s6_q) : begin_13_q;
      begin_14_q <= or_798 ? (begin_13_q & not_273_s6_q) : begin_14_q;
      begin_15_q <= or_798 ? (begin_14_q & not_273_s6_q) : begin_15_q;
      begin_16_q <= or_798 ? (begin_15_q & not_273_s6_q) : begin_16_q;
      begin_17_q <= or_798 ? (begin_16_q & not_273_s6_q) : begin_17_q;
      begin_18_q <= or_798 ? (begin_17_q & not_273_s6_q) : begin_18_q;
      begin_19_q <= or_798 ? (begin_18_q & not_273_s6_q) : begin_19_q;
      begin_20_q <= or_798 ? (begin_19_q & not_273_s6_q) : begin_20_q;
      begin_21_q <= or_798 ? (begin_20_q & not_273_s6_q) : begin_21_q;
      begin_22_q <= or_798 ? (begin_21_q & not_273_s6_q) : begin_22_q;
      begin_23_q <= or_798 ? (begin_22_q & not_273_s6_q) : begin_23_q;
      begin_24_q <= or_798 ? (begin_23_q & not_273_s6_q) : begin_24_q;
      begin_25_q <= or_798 ? (begin_24_q & not_273_s6_q) : begin_25_q;
      begin_26_q <= or_798 ? (begin_25_q & not_273_s6_q) : begin_26_q;
      begin_27_q <= or_798 ? (begin_26_q & not_273_s6_q) : begin_27_q;
      begin_28_q <= or_798 ? (begin_27_q & not_273_s6_q) : begin_28_q;
      begin_29_q <= or_798 ? (begin_28_q & not_273_s6_q) : begin_29_q;
      begin_30_q <= or_798 ? (begin_29_q & not_273_s6_q) : begin_30_q;
      begin_31_q <= or_798 ? (begin_30_q & not_273_s6_q) : begin_31_q;
      end_0_q <= or_863 ? (end_31_q | and_272_s6_q) : end_0_q;
      end_1_q <= or_863 ? (end_0_q & not_273_s6_q) : end_1_q;
      end_2_q <= or_863 ? (end_1_q & not_273_s6_q) : end_2_q;
      end_3_q <= or_863 ? (end_2_q & not_273_s6_q) : end_3_q;
      end_4_q <= or_863 ? (end_3_q & not_273_s6_q) : end_4_q;
      end_5_q <= or_863 ? (end_4_q & not_273_s6_q) : end_5_q;
      end_6_q <= or_863 ? (end_5_q & not_273_s6_q) : end_6_q;
      end_7_q <= or_863 ? (end_6_q & not_273_s6_q) : end_7_q;
      end_8_q <= or_863 ? (end_7_q & not_273_s6_q) : end_8_q;
      end_9_q <= or_863 ? (end_8_q & not_273_s6_q) : end_9_q;
      end_10_q <= or_863 ? (end_9_q & not_273_s6_q) : end_10_q;
      end_11_q <= or_863 ? (end_10_q & not_273_s6_q) : end_11_q;
      end_12_q <= or_863 ? (end_11_q & not_273_s6_q) : end_12_q;
      end_13_q <= or_863 ? (end_12_q & not_273_s6_q) : end_13_q;
      end_14_q <= or_863 ? (end_13_q & not_273_s6_q) : end_14_q;
      end_15_q <= or_863 ? (end_14_q & not_273_s6_q) : end_15_q;
      end_16_q <= or_863 ? (end_15_q & not_273_s6_q) : end_16_q;
      end_17_q <= or_863 ? (end_16_q & not_273_s6_q) : end_17_q;
      end_18_q <= or_863 ? (end_17_q & not_273_s6_q) : end_18_q;
      end_19_q <= or_863 ? (end_18_q & not_273_s6_q) : end_19_q;
      end_20_q <= or_863 ? (end_19_q & not_273_s6_q) : end_20_q;
      end_21_q <= or_863 ? (end_20_q & not_273_s6_q) : end_21_q;
      end_22_q <= or_863 ? (end_21_q & not_273_s6_q) : end_22_q;
      end_23_q <= or_863 ? (end_22_q & not_273_s6_q) : end_23_q;
      end_24_q <= or_863 ? (end_23_q & not_273_s6_q) : end_24_q;
      end_25_q <= or_863 ? (end_24_q & not_273_s6_q) : end_25_q;
      end_26_q <= or_863 ? (end_25_q & not_273_s6_q) : end_26_q;
      end_27_q <= or_863 ? (end_26_q & not_273_s6_q) : end_27_q;
      end_28_q <= or_863 ? (end_27_q & not_273_s6_q) : end_28_q;
      end_29_q <= or_863 ? (end_28_q & not_273_s6_q) : end_29_q;
      end_30_q <= or_863 ? (end_29_q & not_273_s6_q) : end_30_q;
      end_31_q <= or_863 ? (end_30_q & not_273_s6_q) : end_31_q;
      front_there_q <= and_469 ? (or_1379 | or_1410) : front_there_q;
    end
  end

  logic event_ends_s7_q;
  logic event_meets_s7_q;
  logic [10:0] event_run_left_s7_q;
  logic [10:0] event_run_right_s7_q;
  logic [10:0] event_run_row_s7_q;
  logic [30:0] event_run_area_s7_q;
  logic [10:0] event_run_blind_s7_q;
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
  logic and_272_s7_q;
  logic not_273_s7_q;
  logic equal_309_s7_q;
  logic and_317_s7_q;
  logic and_439_s7_q;
  logic and_469_s7_q;
  logic and_470_s7_q;
  logic and_471_s7_q;
  logic equal_479_s7_q;
  logic and_480_s7_q;
  logic and_482_s7_q;
  logic and_488_s7_q;
  logic and_498_s7_q;
  logic and_508_s7_q;
  logic and_518_s7_q;
  logic and_528_s7_q;
  logic and_538_s7_q;
  logic and_548_s7_q;
  logic and_558_s7_q;
  logic and_568_s7_q;
  logic and_578_s7_q;
  logic and_588_s7_q;
  logic and_598_s7_q;
  logic and_608_s7_q;
  logic and_618_s7_q;
  logic and_628_s7_q;
  logic and_638_s7_q;
  logic and_648_s7_q;
  logic and_658_s7_q;
  logic and_668_s7_q;
  logic and_678_s7_q;
  logic and_688_s7_q;
  logic and_698_s7_q;
  logic and_708_s7_q;
  logic and_718_s7_q;
  logic and_728_s7_q;
  logic and_738_s7_q;
  logic and_748_s7_q;
  logic and_758_s7_q;
  logic and_768_s7_q;
  logic and_778_s7_q;
  logic and_788_s7_q;
  logic and_1415_s7_q;
  logic and_1421_s7_q;
  logic and_1427_s7_q;
  logic and_1433_s7_q;
  logic and_1439_s7_q;
  logic and_1445_s7_q;
  logic and_1451_s7_q;
  logic and_1457_s7_q;
  logic and_1463_s7_q;
  logic and_1469_s7_q;
  logic and_1475_s7_q;
  logic and_1481_s7_q;
  logic and_1487_s7_q;
  logic and_1493_s7_q;
  logic and_1499_s7_q;
  logic and_1505_s7_q;
  logic and_1511_s7_q;
  logic and_1517_s7_q;
  logic and_1523_s7_q;
  logic and_1529_s7_q;
  logic and_1535_s7_q;
  logic and_1541_s7_q;
  logic and_1547_s7_q;
  logic and_1553_s7_q;
  logic and_1559_s7_q;
  logic and_1565_s7_q;
  logic and_1571_s7_q;
  logic and_1577_s7_q;
  logic and_1583_s7_q;
  logic and_1589_s7_q;
  logic and_1595_s7_q;
  logic and_1601_s7_q;
  logic or_1685_s7_q;
  logic and_1689_s7_q;
  logic and_1726_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      event_ends_s7_q <= event_ends_q;
      event_meets_s7_q <= event_meets_q;
      event_run_left_s7_q <= event_run_left_q;
      event_run_right_s7_q <= event_run_right_q;
      event_run_row_s7_q <= event_run_row_q;
      event_run_area_s7_q <= event_run_area_q;
      event_run_blind_s7_q <= event_run_blind_q;
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
      and_272_s7_q <= and_272_s6_q;
      not_273_s7_q <= not_273_s6_q;
      equal_309_s7_q <= equal_309_s6_q;
      and_317_s7_q <= busy_q & equal_316_s6_q;
      and_439_s7_q <= and_439;
      and_469_s7_q <= and_469;
      and_470_s7_q <= and_470;
      and_471_s7_q <= and_471;
      equal_479_s7_q <= equal_479_s6_q;
      and_480_s7_q <= and_480;
      and_482_s7_q <= and_482;
      and_488_s7_q <= and_488;
      and_498_s7_q <= and_498;
      and_508_s7_q <= and_508;
      and_518_s7_q <= and_518;
      and_528_s7_q <= and_528;
      and_538_s7_q <= and_538;
      and_548_s7_q <= and_548;
      and_558_s7_q <= and_558;
      and_568_s7_q <= and_568;
      and_578_s7_q <= and_578;
      and_588_s7_q <= and_588;
      and_598_s7_q <= and_598;
      and_608_s7_q <= and_608;
      and_618_s7_q <= and_618;
      and_628_s7_q <= and_628;
      and_638_s7_q <= and_638;
      and_648_s7_q <= and_648;
      and_658_s7_q <= and_658;
      and_668_s7_q <= and_668;
      and_678_s7_q <= and_678;
      and_688_s7_q <= and_688;
      and_698_s7_q <= and_698;
      and_708_s7_q <= and_708;
      and_718_s7_q <= and_718;
      and_728_s7_q <= and_728;
      and_738_s7_q <= and_738;
      and_748_s7_q <= and_748;
      and_758_s7_q <= and_758;
      and_768_s7_q <= and_768;
      and_778_s7_q <= and_778;
      and_788_s7_q <= and_788;
      and_1415_s7_q <= entries_0_there_q & front_there_q;
      and_1421_s7_q <= entries_1_there_q & front_there_q;
      and_1427_s7_q <= entries_2_there_q & front_there_q;
      and_1433_s7_q <= entries_3_there_q & front_there_q;
      and_1439_s7_q <= entries_4_there_q & front_there_q;
      and_1445_s7_q <= entries_5_there_q & front_there_q;
      and_1451_s7_q <= entries_6_there_q & front_there_q;
      and_1457_s7_q <= entries_7_there_q & front_there_q;
      and_1463_s7_q <= entries_8_there_q & front_there_q;
      and_1469_s7_q <= entries_9_there_q & front_there_q;
      and_1475_s7_q <= entries_10_there_q & front_there_q;
      and_1481_s7_q <= entries_11_there_q & front_there_q;
      and_1487_s7_q <= entries_12_there_q & front_there_q;
      and_1493_s7_q <= entries_13_there_q & front_there_q;
      and_1499_s7_q <= entries_14_there_q & front_there_q;
      and_1505_s7_q <= entries_15_there_q & front_there_q;
      and_1511_s7_q <= entries_16_there_q & front_there_q;
      and_1517_s7_q <= entries_17_there_q & front_there_q;
      and_1523_s7_q <= entries_18_there_q & front_there_q;
      and_1529_s7_q <= entries_19_there_q & front_there_q;
      and_1535_s7_q <= entries_20_there_q & front_there_q;
      and_1541_s7_q <= entries_21_there_q & front_there_q;
      and_1547_s7_q <= entries_22_there_q & front_there_q;
      and_1553_s7_q <= entries_23_there_q & front_there_q;
      and_1559_s7_q <= entries_24_there_q & front_there_q;
      and_1565_s7_q <= entries_25_there_q & front_there_q;
      and_1571_s7_q <= entries_26_there_q & front_there_q;
      and_1577_s7_q <= entries_27_there_q & front_there_q;
      and_1583_s7_q <= entries_28_there_q & front_there_q;
      and_1589_s7_q <= entries_29_there_q & front_there_q;
      and_1595_s7_q <= entries_30_there_q & front_there_q;
      and_1601_s7_q <= entries_31_there_q & front_there_q;
      or_1685_s7_q <= or_1685;
      and_1689_s7_q <= and_1689_s6_q;
      and_1726_s7_q <= idle_s6_q & and_443;
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
  // hls/stages/objects.hpp:391
  logic and_310;
  assign and_310 = second_q & equal_309_s7_q;
  // hls/stages/objects.hpp:400
  logic not_311;
  assign not_311 = ~joined_q;
  logic or_312;
  assign or_312 = and_310 | not_311;
  logic [4:0] label;
  assign label = and_310 ? (or_312 ? other_q : {4'h0, others_q}) : (or_312 ? label_q : front_label_q);
  // hls/stages/objects.hpp:392
  logic and_319;
  assign and_319 = and_317_s7_q & (event_ends_s7_q | joined_q);
  // hls/stages/objects.hpp:295
  logic and_472;
  assign and_472 = joined_q & and_317_s7_q;
  // hls/stages/objects.hpp:276
  logic [4:0] ended;
  assign ended = run_there_q ? run_label_q : free_label_q;
  // hls/stages/objects.hpp:310
  logic [4:0] label_2;
  assign label_2 = and_470_s7_q ? ended : run_label_q;
  // hls/stages/objects.hpp:317
  logic [4:0] select_478;
  assign select_478 = (and_471_s7_q | (and_472 & (begin_0_s7_q | same_0_q))) ? label_2 : entries_0_label_q;
  logic [4:0] select_492;
  assign select_492 = (and_488_s7_q | (and_472 & (begin_1_s7_q | same_1_q))) ? label_2 : entries_1_label_q;
  logic [4:0] select_502;
  assign select_502 = (and_498_s7_q | (and_472 & (begin_2_s7_q | same_2_q))) ? label_2 : entries_2_label_q;
  logic [4:0] select_512;
  assign select_512 = (and_508_s7_q | (and_472 & (begin_3_s7_q | same_3_q))) ? label_2 : entries_3_label_q;
  logic [4:0] select_522;
  assign select_522 = (and_518_s7_q | (and_472 & (begin_4_s7_q | same_4_q))) ? label_2 : entries_4_label_q;
  logic [4:0] select_532;
  assign select_532 = (and_528_s7_q | (and_472 & (begin_5_s7_q | same_5_q))) ? label_2 : entries_5_label_q;
  logic [4:0] select_542;
  assign select_542 = (and_538_s7_q | (and_472 & (begin_6_s7_q | same_6_q))) ? label_2 : entries_6_label_q;
  logic [4:0] select_552;
  assign select_552 = (and_548_s7_q | (and_472 & (begin_7_s7_q | same_7_q))) ? label_2 : entries_7_label_q;
  logic [4:0] select_562;
  assign select_562 = (and_558_s7_q | (and_472 & (begin_8_s7_q | same_8_q))) ? label_2 : entries_8_label_q;
  logic [4:0] select_572;
  assign select_572 = (and_568_s7_q | (and_472 & (begin_9_s7_q | same_9_q))) ? label_2 : entries_9_label_q;
  logic [4:0] select_582;
  assign select_582 = (and_578_s7_q | (and_472 & (begin_10_s7_q | same_10_q))) ? label_2 : entries_10_label_q;
  logic [4:0] select_592;
  assign select_592 = (and_588_s7_q | (and_472 & (begin_11_s7_q | same_11_q))) ? label_2 : entries_11_label_q;
  logic [4:0] select_602;
  assign select_602 = (and_598_s7_q | (and_472 & (begin_12_s7_q | same_12_q))) ? label_2 : entries_12_label_q;
  logic [4:0] select_612;
  assign select_612 = (and_608_s7_q | (and_472 & (begin_13_s7_q | same_13_q))) ? label_2 : entries_13_label_q;
  logic [4:0] select_622;
  assign select_622 = (and_618_s7_q | (and_472 & (begin_14_s7_q | same_14_q))) ? label_2 : entries_14_label_q;
  logic [4:0] select_632;
  assign select_632 = (and_628_s7_q | (and_472 & (begin_15_s7_q | same_15_q))) ? label_2 : entries_15_label_q;
  logic [4:0] select_642;
  assign select_642 = (and_638_s7_q | (and_472 & (begin_16_s7_q | same_16_q))) ? label_2 : entries_16_label_q;
  logic [4:0] select_652;
  assign select_652 = (and_648_s7_q | (and_472 & (begin_17_s7_q | same_17_q))) ? label_2 : entries_17_label_q;
  logic [4:0] select_662;
  assign select_662 = (and_658_s7_q | (and_472 & (begin_18_s7_q | same_18_q))) ? label_2 : entries_18_label_q;
  logic [4:0] select_672;
  assign select_672 = (and_668_s7_q | (and_472 & (begin_19_s7_q | same_19_q))) ? label_2 : entries_19_label_q;
  logic [4:0] select_682;
  assign select_682 = (and_678_s7_q | (and_472 & (begin_20_s7_q | same_20_q))) ? label_2 : entries_20_label_q;
  logic [4:0] select_692;
  assign select_692 = (and_688_s7_q | (and_472 & (begin_21_s7_q | same_21_q))) ? label_2 : entries_21_label_q;
  logic [4:0] select_702;
  assign select_702 = (and_698_s7_q | (and_472 & (begin_22_s7_q | same_22_q))) ? label_2 : entries_22_label_q;
  logic [4:0] select_712;
  assign select_712 = (and_708_s7_q | (and_472 & (begin_23_s7_q | same_23_q))) ? label_2 : entries_23_label_q;
  logic [4:0] select_722;
  assign select_722 = (and_718_s7_q | (and_472 & (begin_24_s7_q | same_24_q))) ? label_2 : entries_24_label_q;
  logic [4:0] select_732;
  assign select_732 = (and_728_s7_q | (and_472 & (begin_25_s7_q | same_25_q))) ? label_2 : entries_25_label_q;
  logic [4:0] select_742;
  assign select_742 = (and_738_s7_q | (and_472 & (begin_26_s7_q | same_26_q))) ? label_2 : entries_26_label_q;
  logic [4:0] select_752;
  assign select_752 = (and_748_s7_q | (and_472 & (begin_27_s7_q | same_27_q))) ? label_2 : entries_27_label_q;
  logic [4:0] select_762;
  assign select_762 = (and_758_s7_q | (and_472 & (begin_28_s7_q | same_28_q))) ? label_2 : entries_28_label_q;
  logic [4:0] select_772;
  assign select_772 = (and_768_s7_q | (and_472 & (begin_29_s7_q | same_29_q))) ? label_2 : entries_29_label_q;
  logic [4:0] select_782;
  assign select_782 = (and_778_s7_q | (and_472 & (begin_30_s7_q | same_30_q))) ? label_2 : entries_30_label_q;
  logic [4:0] select_792;
  assign select_792 = (and_788_s7_q | (and_472 & (begin_31_s7_q | same_31_q))) ? label_2 : entries_31_label_q;
  // hls/stages/objects.hpp:275
  logic not_928;
  assign not_928 = ~run_there_q;
  // hls/stages/objects.hpp:286
  logic and_930;
  assign and_930 = not_928 & (event_meets_s7_q & and_439_s7_q);
  // hls/stages/objects.hpp:293
  logic and_936;
  assign and_936 = not_273_s7_q & ((run_there_q & (~and_470_s7_q)) | (front_there_s7_q & and_930));
  // hls/stages/objects.hpp:302
  logic closes;
  assign closes = (not_311 & and_482_s7_q) & (~others_q);
  logic frees;
  assign frees = closes | (joined_q & and_480_s7_q);
  // hls/stages/objects.hpp:318
  logic not_944;
  assign not_944 = ~frees;
  // hls/stages/objects.hpp:339
  logic and_947;
  assign and_947 = looked_there_q & not_273_s7_q;
  // hls/stages/objects.hpp:337
  logic equal_948;
  assign equal_948 = looked_q == 4'hf;
  // hls/stages/objects.hpp:340
  logic and_950;
  assign and_950 = and_947 & (~equal_948);
  // hls/stages/objects.hpp:336
  logic not_951;
  assign not_951 = ~looked_q[0];
  // hls/stages/objects.hpp:319
  logic or_954;
  assign or_954 = (used_0_q & ((~(front_label_q == 5'h0)) | not_944)) | (and_950 & (group_0_q & not_951));
  // hls/stages/objects.hpp:336
  logic equal_960;
  assign equal_960 = looked_q[1:0] == 2'h1;
  // hls/stages/objects.hpp:319
  logic or_963;
  assign or_963 = (used_1_q & (not_944 | (~(front_label_q == 5'h1)))) | (and_950 & (group_0_q & equal_960));
  // hls/stages/objects.hpp:336
  logic equal_969;
  assign equal_969 = looked_q[2:0] == 3'h3;
  // hls/stages/objects.hpp:319
  logic or_972;
  assign or_972 = (used_2_q & (not_944 | (~(front_label_q == 5'h2)))) | (and_950 & (group_0_q & equal_969));
  // hls/stages/objects.hpp:336
  logic equal_978;
  assign equal_978 = looked_q == 4'h7;
  // hls/stages/objects.hpp:319
  logic or_981;
  assign or_981 = (used_3_q & (not_944 | (~(front_label_q == 5'h3)))) | (and_950 & (group_0_q & equal_978));
  logic or_989;
  assign or_989 = (used_4_q & (not_944 | (~(front_label_q == 5'h4)))) | (and_950 & (group_1_q & not_951));
  logic or_997;
  assign or_997 = (used_5_q & (not_944 | (~(front_label_q == 5'h5)))) | (and_950 & (group_1_q & equal_960));
  logic or_1005;
  assign or_1005 = (used_6_q & (not_944 | (~(front_label_q == 5'h6)))) | (and_950 & (group_1_q & equal_969));
  logic or_1013;
  assign or_1013 = (used_7_q & (not_944 | (~(front_label_q == 5'h7)))) | (and_950 & (group_1_q & equal_978));
  logic or_1021;
  assign or_1021 = (used_8_q & (not_944 | (~(front_label_q == 5'h8)))) | (and_950 & (group_2_q & not_951));
  logic or_1029;
  assign or_1029 = (used_9_q & (not_944 | (~(front_label_q == 5'h9)))) | (and_950 & (group_2_q & equal_960));
  logic or_1037;
  assign or_1037 = (used_10_q & (not_944 | (~(front_label_q == 5'ha)))) | (and_950 & (group_2_q & equal_969));
  logic or_1045;
  assign or_1045 = (used_11_q & (not_944 | (~(front_label_q == 5'hb)))) | (and_950 & (group_2_q & equal_978));
  logic or_1053;
  assign or_1053 = (used_12_q & (not_944 | (~(front_label_q == 5'hc)))) | (and_950 & (group_3_q & not_951));
  logic or_1061;
  assign or_1061 = (used_13_q & (not_944 | (~(front_label_q == 5'hd)))) | (and_950 & (group_3_q & equal_960));
  logic or_1069;
  assign or_1069 = (used_14_q & (not_944 | (~(front_label_q == 5'he)))) | (and_950 & (group_3_q & equal_969));
  logic or_1077;
  assign or_1077 = (used_15_q & (not_944 | (~(front_label_q == 5'hf)))) | (and_950 & (group_3_q & equal_978));
  logic or_1085;
  assign or_1085 = (used_16_q & (not_944 | (~(front_label_q == 5'h10)))) | (and_950 & (group_4_q & not_951));
  logic or_1093;
  assign or_1093 = (used_17_q & (not_944 | (~(front_label_q == 5'h11)))) | (and_950 & (group_4_q & equal_960));
  logic or_1101;
  assign or_1101 = (used_18_q & (not_944 | (~(front_label_q == 5'h12)))) | (and_950 & (group_4_q & equal_969));
  logic or_1109;
  assign or_1109 = (used_19_q & (not_944 | (~(front_label_q == 5'h13)))) | (and_950 & (group_4_q & equal_978));
  logic or_1117;
  assign or_1117 = (used_20_q & (not_944 | (~(front_label_q == 5'h14)))) | (and_950 & (group_5_q & not_951));
  logic or_1125;
  assign or_1125 = (used_21_q & (not_944 | (~(front_label_q == 5'h15)))) | (and_950 & (group_5_q & equal_960));
  logic or_1133;
  assign or_1133 = (used_22_q & (not_944 | (~(front_label_q == 5'h16)))) | (and_950 & (group_5_q & equal_969));
  logic or_1141;
  assign or_1141 = (used_23_q & (not_944 | (~(front_label_q == 5'h17)))) | (and_950 & (group_5_q & equal_978));
  logic or_1149;
  assign or_1149 = (used_24_q & (not_944 | (~(front_label_q == 5'h18)))) | (and_950 & (group_6_q & not_951));
  logic or_1157;
  assign or_1157 = (used_25_q & (not_944 | (~(front_label_q == 5'h19)))) | (and_950 & (group_6_q & equal_960));
  logic or_1165;
  assign or_1165 = (used_26_q & (not_944 | (~(front_label_q == 5'h1a)))) | (and_950 & (group_6_q & equal_969));
  logic or_1173;
  assign or_1173 = (used_27_q & (not_944 | (~(front_label_q == 5'h1b)))) | (and_950 & (group_6_q & equal_978));
  logic or_1181;
  assign or_1181 = (used_28_q & (not_944 | (~(front_label_q == 5'h1c)))) | (and_950 & (group_7_q & not_951));
  logic or_1189;
  assign or_1189 = (used_29_q & (not_944 | (~(front_label_q == 5'h1d)))) | (and_950 & (group_7_q & equal_960));
  logic or_1197;
  assign or_1197 = (used_30_q & (not_944 | (~(front_label_q == 5'h1e)))) | (and_950 & (group_7_q & equal_969));
  logic or_1205;
  assign or_1205 = (used_31_q & (not_944 | (~(front_label_q == 5'h1f)))) | (and_950 & (group_7_q & equal_978));
  // hls/stages/objects.hpp:275
  logic and_1207;
  assign and_1207 = and_470_s7_q & not_928;
  // hls/stages/objects.hpp:282
  logic not_1208;
  assign not_1208 = ~free_there_q;
  // hls/stages/objects.hpp:342
  logic and_1210;
  assign and_1210 = found_there_q & (and_1207 | not_1208);
  // hls/stages/objects.hpp:345
  logic or_1216;
  assign or_1216 = equal_960 | equal_978;
  logic or_1217;
  assign or_1217 = equal_969 | equal_978;
  // hls/stages/objects.hpp:364
  logic and_1222;
  assign and_1222 = equal_948 & and_947;
  // hls/stages/objects.hpp:357
  logic and_1241;
  assign and_1241 = used_0_q & group_0_q;
  logic and_1242;
  assign and_1242 = used_1_q & group_0_q;
  logic and_1243;
  assign and_1243 = used_2_q & group_0_q;
  logic and_1244;
  assign and_1244 = used_3_q & group_0_q;
  logic and_1245;
  assign and_1245 = used_4_q & group_1_q;
  logic and_1246;
  assign and_1246 = used_5_q & group_1_q;
  logic and_1247;
  assign and_1247 = used_6_q & group_1_q;
  logic and_1248;
  assign and_1248 = used_7_q & group_1_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used;
  assign used = {and_1244, and_1243, and_1242, and_1241} | {and_1248, and_1247, and_1246, and_1245};
  // hls/stages/objects.hpp:357
  logic and_1250;
  assign and_1250 = used_8_q & group_2_q;
  logic and_1251;
  assign and_1251 = used_9_q & group_2_q;
  logic and_1252;
  assign and_1252 = used_10_q & group_2_q;
  logic and_1253;
  assign and_1253 = used_11_q & group_2_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_2;
  assign used_2 = used | {and_1253, and_1252, and_1251, and_1250};
  // hls/stages/objects.hpp:357
  logic and_1255;
  assign and_1255 = used_12_q & group_3_q;
  logic and_1256;
  assign and_1256 = used_13_q & group_3_q;
  logic and_1257;
  assign and_1257 = used_14_q & group_3_q;
  logic and_1258;
  assign and_1258 = used_15_q & group_3_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_3;
  assign used_3 = used_2 | {and_1258, and_1257, and_1256, and_1255};
  // hls/stages/objects.hpp:357
  logic and_1260;
  assign and_1260 = used_16_q & group_4_q;
  logic and_1261;
  assign and_1261 = used_17_q & group_4_q;
  logic and_1262;
  assign and_1262 = used_18_q & group_4_q;
  logic and_1263;
  assign and_1263 = used_19_q & group_4_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_4;
  assign used_4 = used_3 | {and_1263, and_1262, and_1261, and_1260};
  // hls/stages/objects.hpp:357
  logic and_1265;
  assign and_1265 = used_20_q & group_5_q;
  logic and_1266;
  assign and_1266 = used_21_q & group_5_q;
  logic and_1267;
  assign and_1267 = used_22_q & group_5_q;
  logic and_1268;
  assign and_1268 = used_23_q & group_5_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_5;
  assign used_5 = used_4 | {and_1268, and_1267, and_1266, and_1265};
  // hls/stages/objects.hpp:357
  logic and_1270;
  assign and_1270 = used_24_q & group_6_q;
  logic and_1271;
  assign and_1271 = used_25_q & group_6_q;
  logic and_1272;
  assign and_1272 = used_26_q & group_6_q;
  logic and_1273;
  assign and_1273 = used_27_q & group_6_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_6;
  assign used_6 = used_5 | {and_1273, and_1272, and_1271, and_1270};
  // hls/stages/objects.hpp:357
  logic and_1275;
  assign and_1275 = used_28_q & group_7_q;
  logic and_1276;
  assign and_1276 = used_29_q & group_7_q;
  logic and_1277;
  assign and_1277 = used_30_q & group_7_q;
  logic and_1278;
  assign and_1278 = used_31_q & group_7_q;
  // hls/stages/objects.hpp:358
  logic [3:0] used_7;
  assign used_7 = used_6 | {and_1278, and_1277, and_1276, and_1275};
  // hls/stages/objects.hpp:362
  logic and_1284;
  assign and_1284 = not_273_s7_q & ((~looked_there_q) & (and_1210 | (~found_there_q)));
  // hls/stages/objects.hpp:179
  logic [4:0] or_1287;
  assign or_1287 = (begin_0_s7_q ? entries_0_label_q : 5'h0) | (begin_1_s7_q ? entries_1_label_q : 5'h0);
  logic [4:0] or_1290;
  assign or_1290 = (begin_2_s7_q ? entries_2_label_q : 5'h0) | (begin_3_s7_q ? entries_3_label_q : 5'h0);
  logic [4:0] or_1294;
  assign or_1294 = (begin_4_s7_q ? entries_4_label_q : 5'h0) | (begin_5_s7_q ? entries_5_label_q : 5'h0);
  logic [4:0] or_1297;
  assign or_1297 = (begin_6_s7_q ? entries_6_label_q : 5'h0) | (begin_7_s7_q ? entries_7_label_q : 5'h0);
  logic [4:0] or_1302;
  assign or_1302 = (begin_8_s7_q ? entries_8_label_q : 5'h0) | (begin_9_s7_q ? entries_9_label_q : 5'h0);
  logic [4:0] or_1305;
  assign or_1305 = (begin_10_s7_q ? entries_10_label_q : 5'h0) | (begin_11_s7_q ? entries_11_label_q : 5'h0);
  logic [4:0] or_1309;
  assign or_1309 = (begin_12_s7_q ? entries_12_label_q : 5'h0) | (begin_13_s7_q ? entries_13_label_q : 5'h0);
  logic [4:0] or_1312;
  assign or_1312 = (begin_14_s7_q ? entries_14_label_q : 5'h0) | (begin_15_s7_q ? entries_15_label_q : 5'h0);
  logic [4:0] or_1315;
  assign or_1315 = ((or_1287 | or_1290) | (or_1294 | or_1297)) | ((or_1302 | or_1305) | (or_1309 | or_1312));
  logic [4:0] or_1318;
  assign or_1318 = (begin_16_s7_q ? entries_16_label_q : 5'h0) | (begin_17_s7_q ? entries_17_label_q : 5'h0);
  logic [4:0] or_1321;
  assign or_1321 = (begin_18_s7_q ? entries_18_label_q : 5'h0) | (begin_19_s7_q ? entries_19_label_q : 5'h0);
  logic [4:0] or_1325;
  assign or_1325 = (begin_20_s7_q ? entries_20_label_q : 5'h0) | (begin_21_s7_q ? entries_21_label_q : 5'h0);
  logic [4:0] or_1328;
  assign or_1328 = (begin_22_s7_q ? entries_22_label_q : 5'h0) | (begin_23_s7_q ? entries_23_label_q : 5'h0);
  logic [4:0] or_1333;
  assign or_1333 = (begin_24_s7_q ? entries_24_label_q : 5'h0) | (begin_25_s7_q ? entries_25_label_q : 5'h0);
  logic [4:0] or_1336;
  assign or_1336 = (begin_26_s7_q ? entries_26_label_q : 5'h0) | (begin_27_s7_q ? entries_27_label_q : 5'h0);
  logic [4:0] or_1340;
  assign or_1340 = (begin_28_s7_q ? entries_28_label_q : 5'h0) | (begin_29_s7_q ? entries_29_label_q : 5'h0);
  logic [4:0] or_1343;
  assign or_1343 = (begin_30_s7_q ? entries_30_label_q : 5'h0) | (begin_31_s7_q ? entries_31_label_q : 5'h0);
  logic [4:0] or_1346;
  assign or_1346 = ((or_1318 | or_1321) | (or_1325 | or_1328)) | ((or_1333 | or_1336) | (or_1340 | or_1343));
  // hls/stages/objects.hpp:290
  logic and_1419;
  assign and_1419 = (and_1415_s7_q & (entries_0_label_q == front_label_q)) & (~begin_0_s7_q);
  logic and_1425;
  assign and_1425 = (and_1421_s7_q & (entries_1_label_q == front_label_q)) & (~begin_1_s7_q);
  logic and_1431;
  assign and_1431 = (and_1427_s7_q & (entries_2_label_q == front_label_q)) & (~begin_2_s7_q);
  logic and_1437;
  assign and_1437 = (and_1433_s7_q & (entries_3_label_q == front_label_q)) & (~begin_3_s7_q);
  logic and_1443;
  assign and_1443 = (and_1439_s7_q & (entries_4_label_q == front_label_q)) & (~begin_4_s7_q);
  logic and_1449;
  assign and_1449 = (and_1445_s7_q & (entries_5_label_q == front_label_q)) & (~begin_5_s7_q);
  logic and_1455;
  assign and_1455 = (and_1451_s7_q & (entries_6_label_q == front_label_q)) & (~begin_6_s7_q);
  logic and_1461;
  assign and_1461 = (and_1457_s7_q & (entries_7_label_q == front_label_q)) & (~begin_7_s7_q);
  logic and_1467;
  assign and_1467 = (and_1463_s7_q & (entries_8_label_q == front_label_q)) & (~begin_8_s7_q);
  logic and_1473;
  assign and_1473 = (and_1469_s7_q & (entries_9_label_q == front_label_q)) & (~begin_9_s7_q);
  logic and_1479;
  assign and_1479 = (and_1475_s7_q & (entries_10_label_q == front_label_q)) & (~begin_10_s7_q);
  logic and_1485;
  assign and_1485 = (and_1481_s7_q & (entries_11_label_q == front_label_q)) & (~begin_11_s7_q);
  logic and_1491;
  assign and_1491 = (and_1487_s7_q & (entries_12_label_q == front_label_q)) & (~begin_12_s7_q);
  logic and_1497;
  assign and_1497 = (and_1493_s7_q & (entries_13_label_q == front_label_q)) & (~begin_13_s7_q);
  logic and_1503;
  assign and_1503 = (and_1499_s7_q & (entries_14_label_q == front_label_q)) & (~begin_14_s7_q);
  logic and_1509;
  assign and_1509 = (and_1505_s7_q & (entries_15_label_q == front_label_q)) & (~begin_15_s7_q);
  logic and_1515;
  assign and_1515 = (and_1511_s7_q & (entries_16_label_q == front_label_q)) & (~begin_16_s7_q);
  logic and_1521;
  assign and_1521 = (and_1517_s7_q & (entries_17_label_q == front_label_q)) & (~begin_17_s7_q);
  logic and_1527;
  assign and_1527 = (and_1523_s7_q & (entries_18_label_q == front_label_q)) & (~begin_18_s7_q);
  logic and_1533;
  assign and_1533 = (and_1529_s7_q & (entries_19_label_q == front_label_q)) & (~begin_19_s7_q);
  logic and_1539;
  assign and_1539 = (and_1535_s7_q & (entries_20_label_q == front_label_q)) & (~begin_20_s7_q);
  logic and_1545;
  assign and_1545 = (and_1541_s7_q & (entries_21_label_q == front_label_q)) & (~begin_21_s7_q);
  logic and_1551;
  assign and_1551 = (and_1547_s7_q & (entries_22_label_q == front_label_q)) & (~begin_22_s7_q);
  logic and_1557;
  assign and_1557 = (and_1553_s7_q & (entries_23_label_q == front_label_q)) & (~begin_23_s7_q);
  logic and_1563;
  assign and_1563 = (and_1559_s7_q & (entries_24_label_q == front_label_q)) & (~begin_24_s7_q);
  logic and_1569;
  assign and_1569 = (and_1565_s7_q & (entries_25_label_q == front_label_q)) & (~begin_25_s7_q);
  logic and_1575;
  assign and_1575 = (and_1571_s7_q & (entries_26_label_q == front_label_q)) & (~begin_26_s7_q);
  logic and_1581;
  assign and_1581 = (and_1577_s7_q & (entries_27_label_q == front_label_q)) & (~begin_27_s7_q);
  logic and_1587;
  assign and_1587 = (and_1583_s7_q & (entries_28_label_q == front_label_q)) & (~begin_28_s7_q);
  logic and_1593;
  assign and_1593 = (and_1589_s7_q & (entries_29_label_q == front_label_q)) & (~begin_29_s7_q);
  logic and_1599;
  assign and_1599 = (and_1595_s7_q & (entries_30_label_q == front_label_q)) & (~begin_30_s7_q);
  logic and_1605;
  assign and_1605 = (and_1601_s7_q & (entries_31_label_q == front_label_q)) & (~begin_31_s7_q);
  // hls/stages/objects.hpp:297
  logic equal_1607;
  assign equal_1607 = {same_31_q, same_30_q, same_29_q, same_28_q, same_27_q, same_26_q, same_25_q, same_24_q, same_23_q, same_22_q, same_21_q, same_20_q, same_19_q, same_18_q, same_17_q, same_16_q, same_15_q, same_14_q, same_13_q, same_12_q, same_11_q, same_10_q, same_9_q, same_8_q, same_7_q, same_6_q, same_5_q, same_4_q, same_3_q, same_2_q, same_1_q, same_0_q} == 32'h0;
  // hls/stages/objects.hpp:288
  logic equal_1609;
  assign equal_1609 = run_label_q == front_label_q;
  // hls/stages/objects.hpp:301
  logic select_1613;
  assign select_1613 = and_317_s7_q ? ((~equal_1607) | (equal_1609 & (run_there_q & front_there_s7_q))) : others_q;
  // hls/stages/objects.hpp:288
  logic and_1617;
  assign and_1617 = (front_there_s7_q & (event_meets_s7_q & run_there_q)) & (~equal_1609);
  // hls/stages/objects.hpp:301
  logic [4:0] select_1620;
  assign select_1620 = and_317_s7_q ? (joined_q ? run_label_q : front_label_q) : other_q;
  // hls/stages/objects.hpp:104
  logic or_1690;
  assign or_1690 = (and_470_s7_q & (or_1685_s7_q | (not_928 & not_1208))) | and_1689_s7_q;

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
      entries_0_label_q <= select_478;
      entries_1_label_q <= select_492;
      entries_2_label_q <= select_502;
      entries_3_label_q <= select_512;
      entries_4_label_q <= select_522;
      entries_5_label_q <= select_532;
      entries_6_label_q <= select_542;
      entries_7_label_q <= select_552;
      entries_8_label_q <= select_562;
      entries_9_label_q <= select_572;
      entries_10_label_q <= select_582;
      entries_11_label_q <= select_592;
      entries_12_label_q <= select_602;
      entries_13_label_q <= select_612;
      entries_14_label_q <= select_622;
      entries_15_label_q <= select_632;
      entries_16_label_q <= select_642;
      entries_17_label_q <= select_652;
      entries_18_label_q <= select_662;
      entries_19_label_q <= select_672;
      entries_20_label_q <= select_682;
      entries_21_label_q <= select_692;
      entries_22_label_q <= select_702;
      entries_23_label_q <= select_712;
      entries_24_label_q <= select_722;
      entries_25_label_q <= select_732;
      entries_26_label_q <= select_742;
      entries_27_label_q <= select_752;
      entries_28_label_q <= select_762;
      entries_29_label_q <= select_772;
      entries_30_label_q <= select_782;
      entries_31_label_q <= select_792;
      run_label_q <= and_930 ? front_label_q : run_label_q;
      run_there_q <= and_936;
      used_0_q <= not_273_s7_q & or_954;
      used_1_q <= not_273_s7_q & or_963;
      used_2_q <= not_273_s7_q & or_972;
      used_3_q <= not_273_s7_q & or_981;
      used_4_q <= not_273_s7_q & or_989;
      used_5_q <= not_273_s7_q & or_997;
      used_6_q <= not_273_s7_q & or_1005;
      used_7_q <= not_273_s7_q & or_1013;
      used_8_q <= not_273_s7_q & or_1021;
      used_9_q <= not_273_s7_q & or_1029;
      used_10_q <= not_273_s7_q & or_1037;
      used_11_q <= not_273_s7_q & or_1045;
      used_12_q <= not_273_s7_q & or_1053;
      used_13_q <= not_273_s7_q & or_1061;
      used_14_q <= not_273_s7_q & or_1069;
      used_15_q <= not_273_s7_q & or_1077;
      used_16_q <= not_273_s7_q & or_1085;
      used_17_q <= not_273_s7_q & or_1093;
      used_18_q <= not_273_s7_q & or_1101;
      used_19_q <= not_273_s7_q & or_1109;
      used_20_q <= not_273_s7_q & or_1117;
      used_21_q <= not_273_s7_q & or_1125;
      used_22_q <= not_273_s7_q & or_1133;
      used_23_q <= not_273_s7_q & or_1141;
      used_24_q <= not_273_s7_q & or_1149;
      used_25_q <= not_273_s7_q & or_1157;
      used_26_q <= not_273_s7_q & or_1165;
      used_27_q <= not_273_s7_q & or_1173;
      used_28_q <= not_273_s7_q & or_1181;
      used_29_q <= not_273_s7_q & or_1189;
      used_30_q <= not_273_s7_q & or_1197;
      used_31_q <= not_273_s7_q & or_1205;
      free_label_q <= and_1210 ? found_label_q : free_label_q;
      free_there_q <= not_273_s7_q & (and_1210 | (free_there_q & (~and_1207)));
      found_label_q <= and_950 ? {at_group_q, or_1217, or_1216} : found_label_q;
      found_there_q <= not_273_s7_q & (and_950 | (found_there_q ^ and_1210));
      group_0_q <= and_272_s7_q | (and_1222 ? group_7_q : group_0_q);
      group_1_q <= not_273_s7_q & (and_1222 ? group_0_q : group_1_q);
      group_2_q <= not_273_s7_q & (and_1222 ? group_1_q : group_2_q);
      group_3_q <= not_273_s7_q & (and_1222 ? group_2_q : group_3_q);
      group_4_q <= not_273_s7_q & (and_1222 ? group_3_q : group_4_q);
      group_5_q <= not_273_s7_q & (and_1222 ? group_4_q : group_5_q);
      group_6_q <= not_273_s7_q & (and_1222 ? group_5_q : group_6_q);
      group_7_q <= not_273_s7_q & (and_1222 ? group_6_q : group_7_q);
      at_group_q <= and_272_s7_q ? 3'h0 : (at_group_q + {2'h0, and_1222});
      looked_q <= used_7;
      looked_there_q <= and_1284;
      front_label_q <= and_469_s7_q ? (or_1315 | or_1346) : front_label_q;
      label_q <= and_469_s7_q ? ended : label_q;
      fresh_q <= and_469_s7_q ? not_928 : fresh_q;
      same_0_q <= and_439_s7_q ? and_1419 : same_0_q;
      same_1_q <= and_439_s7_q ? and_1425 : same_1_q;
      same_2_q <= and_439_s7_q ? and_1431 : same_2_q;
      same_3_q <= and_439_s7_q ? and_1437 : same_3_q;
      same_4_q <= and_439_s7_q ? and_1443 : same_4_q;
      same_5_q <= and_439_s7_q ? and_1449 : same_5_q;
      same_6_q <= and_439_s7_q ? and_1455 : same_6_q;
      same_7_q <= and_439_s7_q ? and_1461 : same_7_q;
      same_8_q <= and_439_s7_q ? and_1467 : same_8_q;
      same_9_q <= and_439_s7_q ? and_1473 : same_9_q;
      same_10_q <= and_439_s7_q ? and_1479 : same_10_q;
      same_11_q <= and_439_s7_q ? and_1485 : same_11_q;
      same_12_q <= and_439_s7_q ? and_1491 : same_12_q;
      same_13_q <= and_439_s7_q ? and_1497 : same_13_q;
      same_14_q <= and_439_s7_q ? and_1503 : same_14_q;
      same_15_q <= and_439_s7_q ? and_1509 : same_15_q;
      same_16_q <= and_439_s7_q ? and_1515 : same_16_q;
      same_17_q <= and_439_s7_q ? and_1521 : same_17_q;
      same_18_q <= and_439_s7_q ? and_1527 : same_18_q;
      same_19_q <= and_439_s7_q ? and_1533 : same_19_q;
      same_20_q <= and_439_s7_q ? and_1539 : same_20_q;
      same_21_q <= and_439_s7_q ? and_1545 : same_21_q;
      same_22_q <= and_439_s7_q ? and_1551 : same_22_q;
      same_23_q <= and_439_s7_q ? and_1557 : same_23_q;
      same_24_q <= and_439_s7_q ? and_1563 : same_24_q;
      same_25_q <= and_439_s7_q ? and_1569 : same_25_q;
      same_26_q <= and_439_s7_q ? and_1575 : same_26_q;
      same_27_q <= and_439_s7_q ? and_1581 : same_27_q;
      same_28_q <= and_439_s7_q ? and_1587 : same_28_q;
      same_29_q <= and_439_s7_q ? and_1593 : same_29_q;
      same_30_q <= and_439_s7_q ? and_1599 : same_30_q;
      same_31_q <= and_439_s7_q ? and_1605 : same_31_q;
      others_q <= select_1613;
      joined_q <= and_439_s7_q ? and_1617 : joined_q;
      other_q <= select_1620;
      second_q <= equal_479_s7_q ? frees : second_q;
      second_ends_q <= equal_479_s7_q ? closes : second_ends_q;
      overflow_q <= or_1690 | (~(and_272_s7_q | (~overflow_q)));
    end
  end

  logic [10:0] event_run_left_s8_q;
  logic [10:0] event_run_right_s8_q;
  logic [10:0] event_run_row_s8_q;
  logic [30:0] event_run_area_s8_q;
  logic [10:0] event_run_blind_s8_q;
  logic not_273_s8_q;
  logic and_310_s8_q;
  logic [4:0] label_s8_q;
  logic or_320_s8_q;
  logic and_322_s8_q;
  logic not_367_s8_q;
  logic and_1716_s8_q;
  logic and_1726_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      event_run_left_s8_q <= event_run_left_s7_q;
      event_run_right_s8_q <= event_run_right_s7_q;
      event_run_row_s8_q <= event_run_row_s7_q;
      event_run_area_s8_q <= event_run_area_s7_q;
      event_run_blind_s8_q <= event_run_blind_s7_q;
      not_273_s8_q <= not_273_s7_q;
      and_310_s8_q <= and_310;
      label_s8_q <= label;
      or_320_s8_q <= and_310 | and_319;
      and_322_s8_q <= fresh_q & and_319;
      not_367_s8_q <= ~(and_310 ? second_ends_q : joined_q);
      and_1716_s8_q <= second_ends_q & and_310;
      and_1726_s8_q <= and_1726_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:415
  logic [10:0] pixels;
  assign pixels = (event_run_right_s8_q - event_run_left_s8_q) + 11'h1;

  // Memory objects, 32 x 182, DISTANCE 8, hls/stages/objects.hpp:483; read in stage 8, written in stage 12: 8 < 12 < 8 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [181:0] objects_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) objects_mem[i] = 182'h0;
`endif
  logic [4:0] objects_raddr;
  assign objects_raddr = label_s8_q;
`ifndef SYNTHESIS
  logic objects_re;
  assign objects_re = s8_en & or_320_s8_q;
`endif
  logic [181:0] objects_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) objects_rdata_q <= objects_mem[objects_raddr];
  end

  logic [10:0] event_run_left_s9_q;
  logic [10:0] event_run_right_s9_q;
  logic [10:0] event_run_row_s9_q;
  logic [30:0] event_run_area_s9_q;
  logic [10:0] event_run_blind_s9_q;
  logic not_273_s9_q;
  logic and_310_s9_q;
  logic [4:0] label_s9_q;
  logic or_320_s9_q;
  logic and_322_s9_q;
  logic [10:0] pixels_s9_q;
  logic [11:0] sum_353_s9_q;
  logic not_367_s9_q;
  logic or_1694_s9_q;
  logic and_1716_s9_q;
  logic and_1726_s9_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      event_run_left_s9_q <= event_run_left_s8_q;
      event_run_right_s9_q <= event_run_right_s8_q;
      event_run_row_s9_q <= event_run_row_s8_q;
      event_run_area_s9_q <= event_run_area_s8_q;
      event_run_blind_s9_q <= event_run_blind_s8_q;
      not_273_s9_q <= not_273_s8_q;
      and_310_s9_q <= and_310_s8_q;
      label_s9_q <= label_s8_q;
      or_320_s9_q <= or_320_s8_q;
      and_322_s9_q <= and_322_s8_q;
      pixels_s9_q <= pixels;
      sum_353_s9_q <= {1'b0, event_run_left_s8_q} + {1'b0, event_run_right_s8_q};
      not_367_s9_q <= not_367_s8_q;
      or_1694_s9_q <= overflow_q;
      and_1716_s9_q <= and_1716_s8_q;
      and_1726_s9_q <= and_1726_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:422
  logic [22:0] product_354;
  assign product_354 = {12'h0, pixels_s9_q} * {11'h0, sum_353_s9_q};
  // hls/stages/objects.hpp:423
  logic [21:0] product_360;
  assign product_360 = {11'h0, event_run_row_s9_q} * {11'h0, pixels_s9_q};

  logic [10:0] event_run_left_s10_q;
  logic [10:0] event_run_right_s10_q;
  logic [10:0] event_run_row_s10_q;
  logic [30:0] event_run_area_s10_q;
  logic [10:0] event_run_blind_s10_q;
  logic not_273_s10_q;
  logic and_310_s10_q;
  logic [4:0] label_s10_q;
  logic or_320_s10_q;
  logic [181:0] objects_rdata_s10_q;
  logic and_322_s10_q;
  logic [10:0] pixels_s10_q;
  logic [21:0] product_354_s10_q;
  logic [21:0] product_360_s10_q;
  logic not_367_s10_q;
  logic or_1694_s10_q;
  logic and_1716_s10_q;
  logic and_1726_s10_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      event_run_left_s10_q <= event_run_left_s9_q;
      event_run_right_s10_q <= event_run_right_s9_q;
      event_run_row_s10_q <= event_run_row_s9_q;
      event_run_area_s10_q <= event_run_area_s9_q;
      event_run_blind_s10_q <= event_run_blind_s9_q;
      not_273_s10_q <= not_273_s9_q;
      and_310_s10_q <= and_310_s9_q;
      label_s10_q <= label_s9_q;
      or_320_s10_q <= or_320_s9_q;
      objects_rdata_s10_q <= objects_rdata_q;
      and_322_s10_q <= and_322_s9_q;
      pixels_s10_q <= pixels_s9_q;
      product_354_s10_q <= product_354[22:1];
      product_360_s10_q <= product_360;
      not_367_s10_q <= not_367_s9_q;
      or_1694_s10_q <= or_1694_s9_q;
      and_1716_s10_q <= and_1716_s9_q;
      and_1726_s10_q <= and_1726_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic [31:0] joining_area_q;
  logic [10:0] joining_left_q;
  logic [10:0] joining_right_q;
  logic [10:0] joining_top_q;
  logic [10:0] joining_bottom_q;
  logic [31:0] joining_columns_q;
  logic [31:0] joining_rows_q;
  // hls/stages/objects.hpp:397
  logic [31:0] select_331;
  assign select_331 = and_310_s10_q ? joining_area_q : {1'b0, event_run_area_s10_q};
  logic [10:0] select_337;
  assign select_337 = and_310_s10_q ? joining_left_q : event_run_left_s10_q;
  logic [10:0] select_341;
  assign select_341 = and_310_s10_q ? joining_right_q : event_run_right_s10_q;
  logic [10:0] select_345;
  assign select_345 = and_310_s10_q ? joining_top_q : event_run_row_s10_q;
  logic [10:0] select_349;
  assign select_349 = and_310_s10_q ? joining_bottom_q : event_run_row_s10_q;
  logic [31:0] b;
  assign b = and_310_s10_q ? joining_columns_q : {10'h0, product_354_s10_q};
  // hls/stages/objects.hpp:442
  logic [16:0] low;
  assign low = {1'b0, objects_rdata_s10_q[133:118]} + {1'b0, b[15:0]};
  // hls/stages/objects.hpp:397
  logic [31:0] b_2;
  assign b_2 = and_310_s10_q ? joining_rows_q : {10'h0, product_360_s10_q};
  // hls/stages/objects.hpp:442
  logic [16:0] low_2;
  assign low_2 = {1'b0, objects_rdata_s10_q[165:150]} + {1'b0, b_2[15:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      joining_area_q <= 32'h0;
      joining_left_q <= 11'h0;
      joining_right_q <= 11'h0;
      joining_top_q <= 11'h0;
      joining_bottom_q <= 11'h0;
      joining_columns_q <= 32'h0;
      joining_rows_q <= 32'h0;
    end else if (s10_en) begin
      joining_area_q <= or_320_s10_q ? objects_rdata_s10_q[73:42] : joining_area_q;
      joining_left_q <= or_320_s10_q ? objects_rdata_s10_q[84:74] : joining_left_q;
      joining_right_q <= or_320_s10_q ? objects_rdata_s10_q[95:85] : joining_right_q;
      joining_top_q <= or_320_s10_q ? objects_rdata_s10_q[106:96] : joining_top_q;
      joining_bottom_q <= or_320_s10_q ? objects_rdata_s10_q[117:107] : joining_bottom_q;
      joining_columns_q <= or_320_s10_q ? objects_rdata_s10_q[149:118] : joining_columns_q;
      joining_rows_q <= or_320_s10_q ? objects_rdata_s10_q[181:150] : joining_rows_q;
    end
  end

  logic [10:0] event_run_left_s11_q;
  logic [10:0] event_run_right_s11_q;
  logic [10:0] event_run_row_s11_q;
  logic [30:0] event_run_area_s11_q;
  logic [10:0] event_run_blind_s11_q;
  logic not_273_s11_q;
  logic and_310_s11_q;
  logic [4:0] label_s11_q;
  logic or_320_s11_q;
  logic [85:0] objects_rdata_s11_q;
  logic and_322_s11_q;
  logic [10:0] pixels_s11_q;
  logic [16:0] sum_332_s11_q;
  logic [16:0] sum_333_s11_q;
  logic [10:0] select_337_s11_q;
  logic less_338_s11_q;
  logic [10:0] select_341_s11_q;
  logic less_342_s11_q;
  logic [10:0] select_345_s11_q;
  logic less_346_s11_q;
  logic [10:0] select_349_s11_q;
  logic less_350_s11_q;
  logic [21:0] product_354_s11_q;
  logic [16:0] low_s11_q;
  logic [15:0] sum_357_s11_q;
  logic [21:0] product_360_s11_q;
  logic [16:0] low_2_s11_q;
  logic [15:0] sum_363_s11_q;
  logic not_367_s11_q;
  logic or_1694_s11_q;
  logic and_1716_s11_q;
  logic [31:0] select_1719_s11_q;
  logic [31:0] select_1724_s11_q;
  logic [31:0] select_1725_s11_q;
  logic and_1726_s11_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      event_run_left_s11_q <= event_run_left_s10_q;
      event_run_right_s11_q <= event_run_right_s10_q;
      event_run_row_s11_q <= event_run_row_s10_q;
      event_run_area_s11_q <= event_run_area_s10_q;
      event_run_blind_s11_q <= event_run_blind_s10_q;
      not_273_s11_q <= not_273_s10_q;
      and_310_s11_q <= and_310_s10_q;
      label_s11_q <= label_s10_q;
      or_320_s11_q <= or_320_s10_q;
      objects_rdata_s11_q <= {objects_rdata_s10_q[117:74], objects_rdata_s10_q[41:0]};
      and_322_s11_q <= and_322_s10_q;
      pixels_s11_q <= pixels_s10_q;
      sum_332_s11_q <= {1'b0, objects_rdata_s10_q[57:42]} + {1'b0, select_331[15:0]};
      sum_333_s11_q <= {1'b0, objects_rdata_s10_q[73:58]} + {1'b0, select_331[31:16]};
      select_337_s11_q <= select_337;
      less_338_s11_q <= select_337 < objects_rdata_s10_q[84:74];
      select_341_s11_q <= select_341;
      less_342_s11_q <= objects_rdata_s10_q[95:85] < select_341;
      select_345_s11_q <= select_345;
      less_346_s11_q <= select_345 < objects_rdata_s10_q[106:96];
      select_349_s11_q <= select_349;
      less_350_s11_q <= objects_rdata_s10_q[117:107] < select_349;
      product_354_s11_q <= product_354_s10_q;
      low_s11_q <= low;
      sum_357_s11_q <= objects_rdata_s10_q[149:134] + b[31:16];
      product_360_s11_q <= product_360_s10_q;
      low_2_s11_q <= low_2;
      sum_363_s11_q <= objects_rdata_s10_q[181:166] + b_2[31:16];
      not_367_s11_q <= not_367_s10_q;
      or_1694_s11_q <= or_1694_s10_q;
      and_1716_s11_q <= and_1716_s10_q;
      select_1719_s11_q <= or_320_s10_q ? objects_rdata_s10_q[73:42] : 32'h0;
      select_1724_s11_q <= or_320_s10_q ? objects_rdata_s10_q[149:118] : 32'h0;
      select_1725_s11_q <= or_320_s10_q ? objects_rdata_s10_q[181:150] : 32'h0;
      and_1726_s11_q <= and_1726_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  logic [20:0] joining_pixels_q;
  logic [20:0] joining_blind_q;
  // hls/stages/objects.hpp:428
  logic [20:0] sum_326;
  assign sum_326 = objects_rdata_s11_q[20:0] + (and_310_s11_q ? joining_pixels_q : {10'h0, pixels_s11_q});
  // hls/stages/objects.hpp:429
  logic [20:0] sum_329;
  assign sum_329 = objects_rdata_s11_q[41:21] + (and_310_s11_q ? joining_blind_q : {10'h0, event_run_blind_s11_q});
  // hls/stages/objects.hpp:430
  logic [16:0] sum_334;
  assign sum_334 = {16'h0, sum_332_s11_q[16]} + sum_333_s11_q;
  logic [31:0] select_335;
  assign select_335 = sum_334[16] ? 32'hffffffff : {sum_334[15:0], sum_332_s11_q[15:0]};
  // hls/stages/objects.hpp:403
  logic [10:0] select_340;
  assign select_340 = and_322_s11_q ? event_run_left_s11_q : (less_338_s11_q ? select_337_s11_q : objects_rdata_s11_q[52:42]);
  logic [10:0] select_344;
  assign select_344 = and_322_s11_q ? event_run_right_s11_q : (less_342_s11_q ? select_341_s11_q : objects_rdata_s11_q[63:53]);
  logic [10:0] select_348;
  assign select_348 = and_322_s11_q ? event_run_row_s11_q : (less_346_s11_q ? select_345_s11_q : objects_rdata_s11_q[74:64]);
  logic [10:0] select_352;
  assign select_352 = and_322_s11_q ? event_run_row_s11_q : (less_350_s11_q ? select_349_s11_q : objects_rdata_s11_q[85:75]);
  // hls/stages/objects.hpp:444
  logic [15:0] sum_358;
  assign sum_358 = {15'h0, low_s11_q[16]} + sum_357_s11_q;
  // hls/stages/objects.hpp:403
  logic [31:0] select_359;
  assign select_359 = and_322_s11_q ? {10'h0, product_354_s11_q} : {sum_358, low_s11_q[15:0]};
  // hls/stages/objects.hpp:444
  logic [15:0] sum_364;
  assign sum_364 = {15'h0, low_2_s11_q[16]} + sum_363_s11_q;
  // hls/stages/objects.hpp:403
  logic [31:0] select_365;
  assign select_365 = and_322_s11_q ? {10'h0, product_360_s11_q} : {sum_364, low_2_s11_q[15:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      joining_pixels_q <= 21'h0;
      joining_blind_q <= 21'h0;
    end else if (s11_en) begin
      joining_pixels_q <= or_320_s11_q ? objects_rdata_s11_q[20:0] : joining_pixels_q;
      joining_blind_q <= or_320_s11_q ? objects_rdata_s11_q[41:21] : joining_blind_q;
    end
  end

  logic [10:0] event_run_blind_s12_q;
  logic not_273_s12_q;
  logic [4:0] label_s12_q;
  logic or_320_s12_q;
  logic and_322_s12_q;
  logic [10:0] pixels_s12_q;
  logic [20:0] sum_326_s12_q;
  logic [20:0] sum_329_s12_q;
  logic [31:0] select_336_s12_q;
  logic [10:0] select_340_s12_q;
  logic [10:0] select_344_s12_q;
  logic [10:0] select_348_s12_q;
  logic [10:0] select_352_s12_q;
  logic [31:0] select_359_s12_q;
  logic [31:0] select_365_s12_q;
  logic not_367_s12_q;
  logic or_1694_s12_q;
  logic and_1716_s12_q;
  logic [20:0] select_1717_s12_q;
  logic [20:0] select_1718_s12_q;
  logic [31:0] select_1719_s12_q;
  logic [10:0] select_1720_s12_q;
  logic [10:0] select_1721_s12_q;
  logic [10:0] select_1722_s12_q;
  logic [10:0] select_1723_s12_q;
  logic [31:0] select_1724_s12_q;
  logic [31:0] select_1725_s12_q;
  logic and_1726_s12_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      event_run_blind_s12_q <= event_run_blind_s11_q;
      not_273_s12_q <= not_273_s11_q;
      label_s12_q <= label_s11_q;
      or_320_s12_q <= or_320_s11_q;
      and_322_s12_q <= and_322_s11_q;
      pixels_s12_q <= pixels_s11_q;
      sum_326_s12_q <= sum_326;
      sum_329_s12_q <= sum_329;
      select_336_s12_q <= and_322_s11_q ? {1'b0, event_run_area_s11_q} : select_335;
      select_340_s12_q <= select_340;
      select_344_s12_q <= select_344;
      select_348_s12_q <= select_348;
      select_352_s12_q <= select_352;
      select_359_s12_q <= select_359;
      select_365_s12_q <= select_365;
      not_367_s12_q <= not_367_s11_q;
      or_1694_s12_q <= or_1694_s11_q;
      and_1716_s12_q <= and_1716_s11_q;
      select_1717_s12_q <= or_320_s11_q ? objects_rdata_s11_q[20:0] : 21'h0;
      select_1718_s12_q <= or_320_s11_q ? objects_rdata_s11_q[41:21] : 21'h0;
      select_1719_s12_q <= select_1719_s11_q;
      select_1720_s12_q <= or_320_s11_q ? objects_rdata_s11_q[52:42] : 11'h0;
      select_1721_s12_q <= or_320_s11_q ? objects_rdata_s11_q[63:53] : 11'h0;
      select_1722_s12_q <= or_320_s11_q ? objects_rdata_s11_q[74:64] : 11'h0;
      select_1723_s12_q <= or_320_s11_q ? objects_rdata_s11_q[85:75] : 11'h0;
      select_1724_s12_q <= select_1724_s11_q;
      select_1725_s12_q <= select_1725_s11_q;
      and_1726_s12_q <= and_1726_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:403
  logic [20:0] select_327;
  assign select_327 = and_322_s12_q ? {10'h0, pixels_s12_q} : sum_326_s12_q;
  logic [20:0] select_330;
  assign select_330 = and_322_s12_q ? {10'h0, event_run_blind_s12_q} : sum_329_s12_q;
  // hls/stages/objects.hpp:406
  logic and_1708;
  assign and_1708 = (~(select_336_s12_q < cfg_object_area_limit_i)) & (~(cfg_object_area_limit_i == 32'hffffffff));

  // Memory objects, write
  logic [4:0] objects_waddr;
  assign objects_waddr = label_s12_q;
  logic objects_we;
  assign objects_we = s12_en & (not_367_s12_q & or_320_s12_q);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (objects_we) objects_mem[objects_waddr] <= {select_365_s12_q, select_359_s12_q, select_352_s12_q, select_348_s12_q, select_344_s12_q, select_340_s12_q, select_336_s12_q, select_330, select_327};
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

  logic not_273_s13_q;
  logic or_320_s13_q;
  logic not_367_s13_q;
  logic or_1694_s13_q;
  logic and_1708_s13_q;
  logic not_1710_s13_q;
  logic and_1716_s13_q;
  logic [20:0] select_1717_s13_q;
  logic [20:0] select_1718_s13_q;
  logic [31:0] select_1719_s13_q;
  logic [10:0] select_1720_s13_q;
  logic [10:0] select_1721_s13_q;
  logic [10:0] select_1722_s13_q;
  logic [10:0] select_1723_s13_q;
  logic [31:0] select_1724_s13_q;
  logic [31:0] select_1725_s13_q;
  logic and_1726_s13_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      not_273_s13_q <= not_273_s12_q;
      or_320_s13_q <= or_320_s12_q;
      not_367_s13_q <= not_367_s12_q;
      or_1694_s13_q <= or_1694_s12_q;
      and_1708_s13_q <= and_1708;
      not_1710_s13_q <= ~(select_327 < cfg_object_limit_i);
      and_1716_s13_q <= and_1716_s12_q;
      select_1717_s13_q <= select_1717_s12_q;
      select_1718_s13_q <= select_1718_s12_q;
      select_1719_s13_q <= select_1719_s12_q;
      select_1720_s13_q <= select_1720_s12_q;
      select_1721_s13_q <= select_1721_s12_q;
      select_1722_s13_q <= select_1722_s12_q;
      select_1723_s13_q <= select_1723_s12_q;
      select_1724_s13_q <= select_1724_s12_q;
      select_1725_s13_q <= select_1725_s12_q;
      and_1726_s13_q <= and_1726_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic alarm_q;
  // hls/stages/objects.hpp:96
  logic and_1713;
  assign and_1713 = or_320_s13_q & (not_367_s13_q & (and_1708_s13_q | not_1710_s13_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      alarm_q <= 1'b0;
    end else if (s13_en) begin
      alarm_q <= and_1713 | (alarm_q & not_273_s13_q);
    end
  end

  logic or_1694_s14_q;
  logic and_1716_s14_q;
  logic [20:0] select_1717_s14_q;
  logic [20:0] select_1718_s14_q;
  logic [31:0] select_1719_s14_q;
  logic [10:0] select_1720_s14_q;
  logic [10:0] select_1721_s14_q;
  logic [10:0] select_1722_s14_q;
  logic [10:0] select_1723_s14_q;
  logic [31:0] select_1724_s14_q;
  logic [31:0] select_1725_s14_q;
  logic and_1726_s14_q;
  always_ff @(posedge clk_i) begin
    if (s13_en) begin
      or_1694_s14_q <= or_1694_s13_q;
      and_1716_s14_q <= and_1716_s13_q;
      select_1717_s14_q <= select_1717_s13_q;
      select_1718_s14_q <= select_1718_s13_q;
      select_1719_s14_q <= select_1719_s13_q;
      select_1720_s14_q <= select_1720_s13_q;
      select_1721_s14_q <= select_1721_s13_q;
      select_1722_s14_q <= select_1722_s13_q;
      select_1723_s14_q <= select_1723_s13_q;
      select_1724_s14_q <= select_1724_s13_q;
      select_1725_s14_q <= select_1725_s13_q;
      and_1726_s14_q <= and_1726_s13_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign ended_o = and_1716_s14_q;
  assign object_pixels_o = select_1717_s14_q;
  assign object_blind_o = select_1718_s14_q;
  assign object_area_o = select_1719_s14_q;
  assign object_left_o = select_1720_s14_q;
  assign object_right_o = select_1721_s14_q;
  assign object_top_o = select_1722_s14_q;
  assign object_bottom_o = select_1723_s14_q;
  assign object_columns_o = select_1724_s14_q;
  assign object_rows_o = select_1725_s14_q;
  assign alarm_o = alarm_q;
  assign overflow_o = or_1694_s14_q;
  assign done_o = and_1726_s14_q;
  assign valid_o = valid_s14_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^product_354[0];

endmodule
