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
  input  logic occupied_i,
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
  // hls/stages/objects.hpp:199
  logic or_259;
  assign or_259 = first_i | raster_row_ended_q;
  logic [10:0] x;
  assign x = or_259 ? 11'h0 : raster_column_q;
  // hls/stages/objects.hpp:79
  logic not_261;
  assign not_261 = ~idle_i;
  // hls/stages/objects.hpp:199
  logic and_279;
  assign and_279 = raster_rows_q & (~first_i);

  // Memory above, 1920 x 1, DISTANCE 16, hls/stages/objects.hpp:423; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
      raster_rows_q <= idle_i ? raster_rows_q : (last_i | and_279);
      raster_row_ended_q <= idle_i ? raster_row_ended_q : last_i;
    end
  end

  logic occupied_s1_q;
  logic idle_s1_q;
  logic [10:0] x_s1_q;
  logic not_261_s1_q;
  logic and_263_s1_q;
  logic or_272_s1_q;
  logic and_279_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      occupied_s1_q <= occupied_i;
      idle_s1_q <= idle_i;
      x_s1_q <= x;
      not_261_s1_q <= not_261;
      and_263_s1_q <= first_i & not_261;
      or_272_s1_q <= idle_i | or_259;
      and_279_s1_q <= and_279;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  // Memory above, write
  logic [10:0] above_waddr;
  assign above_waddr = x_s1_q;
  logic above_we;
  assign above_we = s1_en & not_261_s1_q;
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
  logic [10:0] x_s2_q;
  logic not_261_s2_q;
  logic above_rdata_s2_q;
  logic and_263_s2_q;
  logic or_272_s2_q;
  logic and_279_s2_q;
  logic and_284_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      idle_s2_q <= idle_s1_q;
      x_s2_q <= x_s1_q;
      not_261_s2_q <= not_261_s1_q;
      above_rdata_s2_q <= above_rdata_q;
      and_263_s2_q <= and_263_s1_q;
      or_272_s2_q <= or_272_s1_q;
      and_279_s2_q <= and_279_s1_q;
      and_284_s2_q <= occupied_s1_q & not_261_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic before_v_q;
  logic over_before_q;
  logic ended_q;
  // hls/stages/objects.hpp:80
  logic not_264;
  assign not_264 = ~and_263_s2_q;
  // hls/stages/objects.hpp:211
  logic and_271;
  assign and_271 = ended_q & not_264;
  // hls/stages/objects.hpp:209
  logic not_273;
  assign not_273 = ~or_272_s2_q;
  // hls/stages/objects.hpp:211
  logic and_275;
  assign and_275 = before_v_q & not_264;
  logic and_277;
  assign and_277 = over_before_q & not_264;
  // hls/stages/objects.hpp:92
  logic and_281;
  assign and_281 = not_261_s2_q & (above_rdata_s2_q & and_279_s2_q);
  // hls/stages/objects.hpp:209
  logic and_282;
  assign and_282 = and_281 & not_273;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_v_q <= 1'b0;
      over_before_q <= 1'b0;
      ended_q <= 1'b0;
    end else if (s2_en) begin
      before_v_q <= and_284_s2_q;
      over_before_q <= and_281;
      ended_q <= not_273 & (and_275 & (~and_284_s2_q));
    end
  end

  logic idle_s3_q;
  logic [10:0] x_s3_q;
  logic not_261_s3_q;
  logic and_263_s3_q;
  logic not_264_s3_q;
  logic select_276_s3_q;
  logic or_283_s3_q;
  logic and_287_s3_q;
  logic and_295_s3_q;
  logic or_374_s3_q;
  logic or_379_s3_q;
  logic and_408_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      idle_s3_q <= idle_s2_q;
      x_s3_q <= x_s2_q;
      not_261_s3_q <= not_261_s2_q;
      and_263_s3_q <= and_263_s2_q;
      not_264_s3_q <= not_264;
      select_276_s3_q <= (and_271 | not_273) ? and_271 : and_275;
      or_283_s3_q <= and_277 | and_282;
      and_287_s3_q <= not_273 & (and_275 | (and_284_s2_q & not_273));
      and_295_s3_q <= and_277 & (~and_282);
      or_374_s3_q <= idle_s2_q | not_273;
      or_379_s3_q <= or_272_s2_q | (~and_275);
      and_408_s3_q <= (~before_v_q) & ((~over_before_q) & (~ended_q));
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
  // hls/stages/objects.hpp:306
  logic equal_265;
  assign equal_265 = phase_q == 4'h0;
  // hls/stages/objects.hpp:354
  logic equal_266;
  assign equal_266 = read_q == visible_q;
  logic not_267;
  assign not_267 = ~equal_266;
  // hls/stages/objects.hpp:92
  logic and_288;
  assign and_288 = or_283_s3_q & and_287_s3_q;
  // hls/stages/objects.hpp:216
  logic and_291;
  assign and_291 = (met_q & not_264_s3_q) & (~select_276_s3_q);
  // hls/stages/objects.hpp:217
  logic and_293;
  assign and_293 = and_288 & (~and_291);
  // hls/stages/objects.hpp:218
  logic or_297;
  assign or_297 = and_295_s3_q | (select_276_s3_q | and_293);
  // hls/stages/objects.hpp:226
  logic [5:0] select_388;
  assign select_388 = and_263_s3_q ? 6'h0 : (or_297 ? (little_room_q ? write_q : (write_q + 6'h1)) : write_q);
  // hls/stages/objects.hpp:91
  logic [5:0] select_392;
  assign select_392 = and_263_s3_q ? 6'h0 : (equal_265 ? (equal_266 ? read_q : (read_q + 6'h1)) : read_q);
  // hls/stages/objects.hpp:81
  logic [5:0] room;
  assign room = read_q - write_q;
  // hls/stages/objects.hpp:80
  logic little_room;
  assign little_room = not_264_s3_q & (({2'h0, room_q} + 8'hff) < 8'h7);
  // hls/stages/objects.hpp:307
  logic and_410;
  assign and_410 = (~(not_261_s3_q | not_267)) & ((write_q == read_q) & and_408_s3_q);

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
      met_q <= (and_288 | and_291) & (~and_295_s3_q);
      write_q <= select_388;
      read_q <= select_392;
      visible_q <= and_263_s3_q ? 6'h0 : (equal_265 ? write_q : visible_q);
      room_q <= and_263_s3_q ? 6'h0 : room;
      little_room_q <= little_room;
      phase_q <= phase_q + 4'h1;
    end
  end

  logic idle_s4_q;
  logic [5:0] write_s4_q;
  logic [5:0] read_s4_q;
  logic [3:0] phase_s4_q;
  logic [10:0] x_s4_q;
  logic and_263_s4_q;
  logic not_264_s4_q;
  logic equal_265_s4_q;
  logic equal_266_s4_q;
  logic not_267_s4_q;
  logic select_276_s4_q;
  logic and_284_s4_q;
  logic and_293_s4_q;
  logic and_295_s4_q;
  logic and_299_s4_q;
  logic or_374_s4_q;
  logic or_379_s4_q;
  logic and_410_s4_q;
  logic and_1661_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      idle_s4_q <= idle_s3_q;
      write_s4_q <= write_q;
      read_s4_q <= read_q;
      phase_s4_q <= phase_q;
      x_s4_q <= x_s3_q;
      and_263_s4_q <= and_263_s3_q;
      not_264_s4_q <= not_264_s3_q;
      equal_265_s4_q <= equal_265;
      equal_266_s4_q <= equal_266;
      not_267_s4_q <= not_267;
      select_276_s4_q <= select_276_s3_q;
      and_284_s4_q <= before_v_q;
      and_293_s4_q <= and_293;
      and_295_s4_q <= and_295_s3_q;
      and_299_s4_q <= or_297 & (~little_room_q);
      or_374_s4_q <= or_374_s3_q;
      or_379_s4_q <= or_379_s3_q;
      and_410_s4_q <= and_410;
      and_1661_s4_q <= little_room_q & or_297;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [10:0] row_q;

  // Memory queue, 64 x 36, DISTANCE 16, hls/stages/objects.hpp:430; read in stage 4, written in stage 5: 4 < 5 < 4 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] queue_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) queue_mem[i] = 36'h0;
`endif
  logic [5:0] queue_raddr;
  assign queue_raddr = read_s4_q;
  logic queue_re;
  assign queue_re = s4_en & (not_264_s4_q & (equal_265_s4_q & not_267_s4_q));
  logic [35:0] queue_rdata_q;
  always_ff @(posedge clk_i) begin
    if (queue_re) queue_rdata_q <= queue_mem[queue_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 11'h0;
    end else if (s4_en) begin
      row_q <= or_374_s4_q ? row_q : (and_263_s4_q ? 11'h0 : (row_q + 11'h1));
    end
  end

  logic idle_s5_q;
  logic [5:0] write_s5_q;
  logic [3:0] phase_s5_q;
  logic [10:0] x_s5_q;
  logic and_263_s5_q;
  logic not_264_s5_q;
  logic equal_265_s5_q;
  logic equal_266_s5_q;
  logic not_267_s5_q;
  logic select_276_s5_q;
  logic and_284_s5_q;
  logic and_293_s5_q;
  logic and_295_s5_q;
  logic and_299_s5_q;
  logic or_379_s5_q;
  logic and_410_s5_q;
  logic and_1661_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      idle_s5_q <= idle_s4_q;
      write_s5_q <= write_s4_q;
      phase_s5_q <= phase_s4_q;
      x_s5_q <= x_s4_q;
      and_263_s5_q <= and_263_s4_q;
      not_264_s5_q <= not_264_s4_q;
      equal_265_s5_q <= equal_265_s4_q;
      equal_266_s5_q <= equal_266_s4_q;
      not_267_s5_q <= not_267_s4_q;
      select_276_s5_q <= select_276_s4_q;
      and_284_s5_q <= and_284_s4_q;
      and_293_s5_q <= and_293_s4_q;
      and_295_s5_q <= and_295_s4_q;
      and_299_s5_q <= and_299_s4_q;
      or_379_s5_q <= or_379_s4_q;
      and_410_s5_q <= and_410_s4_q;
      and_1661_s5_q <= and_1661_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [10:0] last_run_left_q;
  logic [10:0] last_run_right_q;
  logic [10:0] last_run_row_q;
  // hls/stages/objects.hpp:92
  logic [10:0] x_2;
  assign x_2 = idle_s5_q ? last_run_right_q : x_s5_q;
  // hls/stages/objects.hpp:234
  logic [10:0] select_382;
  assign select_382 = and_284_s5_q ? (or_379_s5_q ? x_2 : last_run_left_q) : last_run_left_q;

  // Memory queue, write
  logic [5:0] queue_waddr;
  assign queue_waddr = write_s5_q;
  logic queue_we;
  assign queue_we = s5_en & and_299_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (queue_we) queue_mem[queue_waddr] <= {last_run_row_q, last_run_right_q, last_run_left_q, and_295_s5_q, and_293_s5_q, select_276_s5_q};
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
      last_run_left_q <= select_382;
      last_run_right_q <= and_284_s5_q ? x_2 : last_run_right_q;
      last_run_row_q <= and_284_s5_q ? row_q : last_run_row_q;
    end
  end

  logic idle_s6_q;
  logic and_263_s6_q;
  logic not_264_s6_q;
  logic equal_265_s6_q;
  logic equal_266_s6_q;
  logic not_267_s6_q;
  logic [35:0] queue_rdata_s6_q;
  logic equal_300_s6_q;
  logic equal_319_s6_q;
  logic and_410_s6_q;
  logic equal_416_s6_q;
  logic equal_440_s6_q;
  logic equal_451_s6_q;
  logic and_1661_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      idle_s6_q <= idle_s5_q;
      and_263_s6_q <= and_263_s5_q;
      not_264_s6_q <= not_264_s5_q;
      equal_265_s6_q <= equal_265_s5_q;
      equal_266_s6_q <= equal_266_s5_q;
      not_267_s6_q <= not_267_s5_q;
      queue_rdata_s6_q <= queue_rdata_q;
      equal_300_s6_q <= phase_s5_q == 4'hb;
      equal_319_s6_q <= phase_s5_q == 4'h3;
      and_410_s6_q <= and_410_s5_q;
      equal_416_s6_q <= phase_s5_q == 4'h2;
      equal_440_s6_q <= phase_s5_q == 4'h1;
      equal_451_s6_q <= phase_s5_q == 4'h4;
      and_1661_s6_q <= and_1661_s5_q;
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
  // hls/stages/objects.hpp:91
  logic and_413;
  assign and_413 = not_264_s6_q & (equal_265_s6_q ? (not_267_s6_q | and_410_s6_q) : busy_q);
  logic select_415;
  assign select_415 = and_263_s6_q ? draining_q : (equal_265_s6_q ? and_410_s6_q : draining_q);
  // hls/stages/objects.hpp:251
  logic and_417;
  assign and_417 = busy_q & equal_416_s6_q;
  // hls/stages/objects.hpp:91
  logic and_421;
  assign and_421 = not_264_s6_q & (and_417 ? (draining_q & (~front_there_q)) : done_q);
  logic select_423;
  assign select_423 = equal_265_s6_q ? (queue_rdata_s6_q[0] & not_267_s6_q) : event_ends_q;
  logic select_426;
  assign select_426 = equal_265_s6_q ? (queue_rdata_s6_q[1] & not_267_s6_q) : event_meets_q;
  logic select_429;
  assign select_429 = equal_265_s6_q ? (queue_rdata_s6_q[2] | equal_266_s6_q) : event_passes_q;
  logic [10:0] select_432;
  assign select_432 = equal_265_s6_q ? (equal_266_s6_q ? event_run_left_q : queue_rdata_s6_q[13:3]) : event_run_left_q;
  logic [10:0] select_435;
  assign select_435 = equal_265_s6_q ? (equal_266_s6_q ? event_run_right_q : queue_rdata_s6_q[24:14]) : event_run_right_q;
  logic [10:0] select_438;
  assign select_438 = equal_265_s6_q ? (equal_266_s6_q ? event_run_row_q : queue_rdata_s6_q[35:25]) : event_run_row_q;
  // hls/stages/objects.hpp:251
  logic and_441;
  assign and_441 = busy_q & equal_440_s6_q;
  // hls/stages/objects.hpp:255
  logic and_442;
  assign and_442 = event_ends_q & and_441;
  // hls/stages/objects.hpp:295
  logic and_443;
  assign and_443 = end_0_q & and_442;
  // hls/stages/objects.hpp:252
  logic and_452;
  assign and_452 = busy_q & equal_451_s6_q;
  // hls/stages/objects.hpp:281
  logic and_454;
  assign and_454 = front_there_q & (event_passes_q & and_452);
  // hls/stages/objects.hpp:297
  logic and_459;
  assign and_459 = not_264_s6_q & (and_443 | (entries_0_there_q & (~(begin_0_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_460;
  assign and_460 = end_1_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_469;
  assign and_469 = not_264_s6_q & (and_460 | (entries_1_there_q & (~(begin_1_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_470;
  assign and_470 = end_2_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_479;
  assign and_479 = not_264_s6_q & (and_470 | (entries_2_there_q & (~(begin_2_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_480;
  assign and_480 = end_3_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_489;
  assign and_489 = not_264_s6_q & (and_480 | (entries_3_there_q & (~(begin_3_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_490;
  assign and_490 = end_4_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_499;
  assign and_499 = not_264_s6_q & (and_490 | (entries_4_there_q & (~(begin_4_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_500;
  assign and_500 = end_5_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_509;
  assign and_509 = not_264_s6_q & (and_500 | (entries_5_there_q & (~(begin_5_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_510;
  assign and_510 = end_6_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_519;
  assign and_519 = not_264_s6_q & (and_510 | (entries_6_there_q & (~(begin_6_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_520;
  assign and_520 = end_7_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_529;
  assign and_529 = not_264_s6_q & (and_520 | (entries_7_there_q & (~(begin_7_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_530;
  assign and_530 = end_8_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_539;
  assign and_539 = not_264_s6_q & (and_530 | (entries_8_there_q & (~(begin_8_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_540;
  assign and_540 = end_9_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_549;
  assign and_549 = not_264_s6_q & (and_540 | (entries_9_there_q & (~(begin_9_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_550;
  assign and_550 = end_10_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_559;
  assign and_559 = not_264_s6_q & (and_550 | (entries_10_there_q & (~(begin_10_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_560;
  assign and_560 = end_11_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_569;
  assign and_569 = not_264_s6_q & (and_560 | (entries_11_there_q & (~(begin_11_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_570;
  assign and_570 = end_12_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_579;
  assign and_579 = not_264_s6_q & (and_570 | (entries_12_there_q & (~(begin_12_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_580;
  assign and_580 = end_13_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_589;
  assign and_589 = not_264_s6_q & (and_580 | (entries_13_there_q & (~(begin_13_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_590;
  assign and_590 = end_14_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_599;
  assign and_599 = not_264_s6_q & (and_590 | (entries_14_there_q & (~(begin_14_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_600;
  assign and_600 = end_15_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_609;
  assign and_609 = not_264_s6_q & (and_600 | (entries_15_there_q & (~(begin_15_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_610;
  assign and_610 = end_16_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_619;
  assign and_619 = not_264_s6_q & (and_610 | (entries_16_there_q & (~(begin_16_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_620;
  assign and_620 = end_17_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_629;
  assign and_629 = not_264_s6_q & (and_620 | (entries_17_there_q & (~(begin_17_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_630;
  assign and_630 = end_18_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_639;
  assign and_639 = not_264_s6_q & (and_630 | (entries_18_there_q & (~(begin_18_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_640;
  assign and_640 = end_19_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_649;
  assign and_649 = not_264_s6_q & (and_640 | (entries_19_there_q & (~(begin_19_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_650;
  assign and_650 = end_20_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_659;
  assign and_659 = not_264_s6_q & (and_650 | (entries_20_there_q & (~(begin_20_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_660;
  assign and_660 = end_21_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_669;
  assign and_669 = not_264_s6_q & (and_660 | (entries_21_there_q & (~(begin_21_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_670;
  assign and_670 = end_22_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_679;
  assign and_679 = not_264_s6_q & (and_670 | (entries_22_there_q & (~(begin_22_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_680;
  assign and_680 = end_23_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_689;
  assign and_689 = not_264_s6_q & (and_680 | (entries_23_there_q & (~(begin_23_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_690;
  assign and_690 = end_24_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_699;
  assign and_699 = not_264_s6_q & (and_690 | (entries_24_there_q & (~(begin_24_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_700;
  assign and_700 = end_25_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_709;
  assign and_709 = not_264_s6_q & (and_700 | (entries_25_there_q & (~(begin_25_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_710;
  assign and_710 = end_26_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_719;
  assign and_719 = not_264_s6_q & (and_710 | (entries_26_there_q & (~(begin_26_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_720;
  assign and_720 = end_27_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_729;
  assign and_729 = not_264_s6_q & (and_720 | (entries_27_there_q & (~(begin_27_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_730;
  assign and_730 = end_28_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_739;
  assign and_739 = not_264_s6_q & (and_730 | (entries_28_there_q & (~(begin_28_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_740;
  assign and_740 = end_29_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_749;
  assign and_749 = not_264_s6_q & (and_740 | (entries_29_there_q & (~(begin_29_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_750;
  assign and_750 = end_30_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_759;
  assign and_759 = not_264_s6_q & (and_750 | (entries_30_there_q & (~(begin_30_q & and_454))));
  // hls/stages/objects.hpp:295
  logic and_760;
  assign and_760 = end_31_q & and_442;
  // hls/stages/objects.hpp:297
  logic and_769;
  assign and_769 = not_264_s6_q & (and_760 | (entries_31_there_q & (~(begin_31_q & and_454))));
  // hls/stages/objects.hpp:301
  logic or_770;
  assign or_770 = and_263_s6_q | and_454;
  // hls/stages/objects.hpp:302
  logic or_835;
  assign or_835 = and_263_s6_q | and_442;
  // hls/stages/objects.hpp:168
  logic or_1323;
  assign or_1323 = (entries_0_there_q & begin_0_q) | (entries_1_there_q & begin_1_q);
  logic or_1326;
  assign or_1326 = (entries_2_there_q & begin_2_q) | (entries_3_there_q & begin_3_q);
  logic or_1330;
  assign or_1330 = (entries_4_there_q & begin_4_q) | (entries_5_there_q & begin_5_q);
  logic or_1333;
  assign or_1333 = (entries_6_there_q & begin_6_q) | (entries_7_there_q & begin_7_q);
  logic or_1338;
  assign or_1338 = (entries_8_there_q & begin_8_q) | (entries_9_there_q & begin_9_q);
  logic or_1341;
  assign or_1341 = (entries_10_there_q & begin_10_q) | (entries_11_there_q & begin_11_q);
  logic or_1345;
  assign or_1345 = (entries_12_there_q & begin_12_q) | (entries_13_there_q & begin_13_q);
  logic or_1348;
  assign or_1348 = (entries_14_there_q & begin_14_q) | (entries_15_there_q & begin_15_q);
  logic or_1351;
  assign or_1351 = ((or_1323 | or_1326) | (or_1330 | or_1333)) | ((or_1338 | or_1341) | (or_1345 | or_1348));
  logic or_1354;
  assign or_1354 = (entries_16_there_q & begin_16_q) | (entries_17_there_q & begin_17_q);
  logic or_1357;
  assign or_1357 = (entries_18_there_q & begin_18_q) | (entries_19_there_q & begin_19_q);
  logic or_1361;
  assign or_1361 = (entries_20_there_q & begin_20_q) | (entries_21_there_q & begin_21_q);
  logic or_1364;
  assign or_1364 = (entries_22_there_q & begin_22_q) | (entries_23_there_q & begin_23_q);
  logic or_1369;
  assign or_1369 = (entries_24_there_q & begin_24_q) | (entries_25_there_q & begin_25_q);
  logic or_1372;
  assign or_1372 = (entries_26_there_q & begin_26_q) | (entries_27_there_q & begin_27_q);
  logic or_1376;
  assign or_1376 = (entries_28_there_q & begin_28_q) | (entries_29_there_q & begin_29_q);
  logic or_1379;
  assign or_1379 = (entries_30_there_q & begin_30_q) | (entries_31_there_q & begin_31_q);
  logic or_1382;
  assign or_1382 = ((or_1354 | or_1357) | (or_1361 | or_1364)) | ((or_1369 | or_1372) | (or_1376 | or_1379));
  logic or_1601;
  assign or_1601 = ((entries_0_there_q & end_0_q) | (entries_1_there_q & end_1_q)) | ((entries_2_there_q & end_2_q) | (entries_3_there_q & end_3_q));
  logic or_1608;
  assign or_1608 = ((entries_4_there_q & end_4_q) | (entries_5_there_q & end_5_q)) | ((entries_6_there_q & end_6_q) | (entries_7_there_q & end_7_q));
  logic or_1615;
  assign or_1615 = (entries_10_there_q & end_10_q) | (entries_11_there_q & end_11_q);
  logic or_1616;
  assign or_1616 = ((entries_8_there_q & end_8_q) | (entries_9_there_q & end_9_q)) | or_1615;
  logic or_1619;
  assign or_1619 = (entries_12_there_q & end_12_q) | (entries_13_there_q & end_13_q);
  logic or_1622;
  assign or_1622 = (entries_14_there_q & end_14_q) | (entries_15_there_q & end_15_q);
  logic or_1628;
  assign or_1628 = (entries_16_there_q & end_16_q) | (entries_17_there_q & end_17_q);
  logic or_1631;
  assign or_1631 = (entries_18_there_q & end_18_q) | (entries_19_there_q & end_19_q);
  logic or_1635;
  assign or_1635 = (entries_20_there_q & end_20_q) | (entries_21_there_q & end_21_q);
  logic or_1638;
  assign or_1638 = (entries_22_there_q & end_22_q) | (entries_23_there_q & end_23_q);
  logic or_1643;
  assign or_1643 = (entries_24_there_q & end_24_q) | (entries_25_there_q & end_25_q);
  logic or_1646;
  assign or_1646 = (entries_26_there_q & end_26_q) | (entries_27_there_q & end_27_q);
  logic or_1650;
  assign or_1650 = (entries_28_there_q & end_28_q) | (entries_29_there_q & end_29_q);
  logic or_1653;
  assign or_1653 = (entries_30_there_q & end_30_q) | (entries_31_there_q & end_31_q);
  logic or_1656;
  assign or_1656 = ((or_1628 | or_1631) | (or_1635 | or_1638)) | ((or_1643 | or_1646) | (or_1650 | or_1653));
  logic or_1657;
  assign or_1657 = ((or_1601 | or_1608) | (or_1616 | (or_1619 | or_1622))) | or_1656;

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
      busy_q <= and_413;
      draining_q <= select_415;
      done_q <= and_421;
      event_ends_q <= and_263_s6_q ? event_ends_q : select_423;
      event_meets_q <= and_263_s6_q ? event_meets_q : select_426;
      event_passes_q <= and_263_s6_q ? event_passes_q : select_429;
      event_run_left_q <= and_263_s6_q ? event_run_left_q : select_432;
      event_run_right_q <= and_263_s6_q ? event_run_right_q : select_435;
      event_run_row_q <= and_263_s6_q ? event_run_row_q : select_438;
      entries_0_there_q <= and_459;
      entries_1_there_q <= and_469;
      entries_2_there_q <= and_479;
      entries_3_there_q <= and_489;
      entries_4_there_q <= and_499;
      entries_5_there_q <= and_509;
      entries_6_there_q <= and_519;
      entries_7_there_q <= and_529;
      entries_8_there_q <= and_539;
      entries_9_there_q <= and_549;
      entries_10_there_q <= and_559;
      entries_11_there_q <= and_569;
      entries_12_there_q <= and_579;
      entries_13_there_q <= and_589;
      entries_14_there_q <= and_599;
      entries_15_there_q <= and_609;
      entries_16_there_q <= and_619;
      entries_17_there_q <= and_629;
      entries_18_there_q <= and_639;
      entries_19_there_q <= and_649;
      entries_20_there_q <= and_659;
      entries_21_there_q <= and_669;
      entries_22_there_q <= and_679;
      entries_23_there_q <= and_689;
      entries_24_there_q <= and_699;
      entries_25_there_q <= and_709;
      entries_26_there_q <= and_719;
      entries_27_there_q <= and_729;
      entries_28_there_q <= and_739;
      entries_29_there_q <= and_749;
      entries_30_there_q <= and_759;
      entries_31_there_q <= and_769;
      begin_0_q <= or_770 ? (begin_31_q | and_263_s6_q) : begin_0_q;
      begin_1_q <= or_770 ? (begin_0_q & not_264_s6_q) : begin_1_q;
      begin_2_q <= or_770 ? (begin_1_q & not_264_s6_q) : begin_2_q;
      begin_3_q <= or_770 ? (begin_2_q & not_264_s6_q) : begin_3_q;
      begin_4_q <= or_770 ? (begin_3_q & not_264_s6_q) : begin_4_q;
      begin_5_q <= or_770 ? (begin_4_q & not_264_s6_q) : begin_5_q;
      begin_6_q <= or_770 ? (begin_5_q & not_264_s6_q) : begin_6_q;
      begin_7_q <= or_770 ? (begin_6_q & not_264_s6_q) : begin_7_q;
      begin_8_q <= or_770 ? (begin_7_q & not_264_s6_q) : begin_8_q;
      begin_9_q <= or_770 ? (begin_8_q & not_264_s6_q) : begin_9_q;
      begin_10_q <= or_770 ? (begin_9_q & not_264_s6_q) : begin_10_q;
      begin_11_q <= or_770 ? (begin_10_q & not_264_s6_q) : begin_11_q;
      begin_12_q <= or_770 ? (begin_11_q & not_264_s6_q) : begin_12_q;
      begin_13_q <= or_770 ? (begin_12_q & not_264_s6_q) : begin_13_q;
      begin_14_q <= or_770 ? (begin_13_q & not_264_s6_q) : begin_14_q;
      begin_15_q <= or_770 ? (begin_14_q & not_264_s6_q) : begin_15_q;
      begin_16_q <= or_770 ? (begin_15_q & not_264_s6_q) : begin_16_q;
      begin_17_q <= or_770 ? (begin_16_q & not_264_s6_q) : begin_17_q;
      begin_18_q <= or_770 ? (begin_17_q & not_264_s6_q) : begin_18_q;
      begin_19_q <= or_770 ? (begin_18_q & not_264_s6_q) : begin_19_q;
      begin_20_q <= or_770 ? (begin_19_q & not_264_s6_q) : begin_20_q;
      begin_21_q <= or_770 ? (begin_20_q & not_264_s6_q) : begin_21_q;
      begin_22_q <= or_770 ? (begin_21_q & not_264_s6_q) : begin_22_q;
      begin_23_q <= or_770 ? (begin_22_q & not_264_s6_q) : begin_23_q;
      begin_24_q <= or_770 ? (begin_23_q & not_264_s6_q) : begin_24_q;
      begin_25_q <= or_770 ? (begin_24_q & not_264_s6_q) : begin_25_q;
      begin_26_q <= or_770 ? (begin_25_q & not_264_s6_q) : begin_26_q;
      begin_27_q <= or_770 ? (begin_26_q & not_264_s6_q) : begin_27_q;
      begin_28_q <= or_770 ? (begin_27_q & not_264_s6_q) : begin_28_q;
      begin_29_q <= or_770 ? (begin_28_q & not_264_s6_q) : begin_29_q;
      begin_30_q <= or_770 ? (begin_29_q & not_264_s6_q) : begin_30_q;
      begin_31_q <= or_770 ? (begin_30_q & not_264_s6_q) : begin_31_q;
      end_0_q <= or_835 ? (end_31_q | and_263_s6_q) : end_0_q;
      end_1_q <= or_835 ? (end_0_q & not_264_s6_q) : end_1_q;
      end_2_q <= or_835 ? (end_1_q & not_264_s6_q) : end_2_q;
      end_3_q <= or_835 ? (end_2_q & not_264_s6_q) : end_3_q;
      end_4_q <= or_835 ? (end_3_q & not_264_s6_q) : end_4_q;
      end_5_q <= or_835 ? (end_4_q & not_264_s6_q) : end_5_q;
      end_6_q <= or_835 ? (end_5_q & not_264_s6_q) : end_6_q;
      end_7_q <= or_835 ? (end_6_q & not_264_s6_q) : end_7_q;
      end_8_q <= or_835 ? (end_7_q & not_264_s6_q) : end_8_q;
      end_9_q <= or_835 ? (end_8_q & not_264_s6_q) : end_9_q;
      end_10_q <= or_835 ? (end_9_q & not_264_s6_q) : end_10_q;
      end_11_q <= or_835 ? (end_10_q & not_264_s6_q) : end_11_q;
      end_12_q <= or_835 ? (end_11_q & not_264_s6_q) : end_12_q;
      end_13_q <= or_835 ? (end_12_q & not_264_s6_q) : end_13_q;
      end_14_q <= or_835 ? (end_13_q & not_264_s6_q) : end_14_q;
      end_15_q <= or_835 ? (end_14_q & not_264_s6_q) : end_15_q;
      end_16_q <= or_835 ? (end_15_q & not_264_s6_q) : end_16_q;
      end_17_q <= or_835 ? (end_16_q & not_264_s6_q) : end_17_q;
      end_18_q <= or_835 ? (end_17_q & not_264_s6_q) : end_18_q;
      end_19_q <= or_835 ? (end_18_q & not_264_s6_q) : end_19_q;
      end_20_q <= or_835 ? (end_19_q & not_264_s6_q) : end_20_q;
      end_21_q <= or_835 ? (end_20_q & not_264_s6_q) : end_21_q;
      end_22_q <= or_835 ? (end_21_q & not_264_s6_q) : end_22_q;
      end_23_q <= or_835 ? (end_22_q & not_264_s6_q) : end_23_q;
      end_24_q <= or_835 ? (end_23_q & not_264_s6_q) : end_24_q;
      end_25_q <= or_835 ? (end_24_q & not_264_s6_q) : end_25_q;
      end_26_q <= or_835 ? (end_25_q & not_264_s6_q) : end_26_q;
      end_27_q <= or_835 ? (end_26_q & not_264_s6_q) : end_27_q;
      end_28_q <= or_835 ? (end_27_q & not_264_s6_q) : end_28_q;
      end_29_q <= or_835 ? (end_28_q & not_264_s6_q) : end_29_q;
      end_30_q <= or_835 ? (end_29_q & not_264_s6_q) : end_30_q;
      end_31_q <= or_835 ? (end_30_q & not_264_s6_q) : end_31_q;
      front_there_q <= and_441 ? (or_1351 | or_1382) : front_there_q;
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
  logic and_263_s7_q;
  logic not_264_s7_q;
  logic equal_300_s7_q;
  logic and_320_s7_q;
  logic and_417_s7_q;
  logic and_441_s7_q;
  logic and_442_s7_q;
  logic and_443_s7_q;
  logic equal_451_s7_q;
  logic and_452_s7_q;
  logic and_454_s7_q;
  logic and_460_s7_q;
  logic and_470_s7_q;
  logic and_480_s7_q;
  logic and_490_s7_q;
  logic and_500_s7_q;
  logic and_510_s7_q;
  logic and_520_s7_q;
  logic and_530_s7_q;
  logic and_540_s7_q;
  logic and_550_s7_q;
  logic and_560_s7_q;
  logic and_570_s7_q;
  logic and_580_s7_q;
  logic and_590_s7_q;
  logic and_600_s7_q;
  logic and_610_s7_q;
  logic and_620_s7_q;
  logic and_630_s7_q;
  logic and_640_s7_q;
  logic and_650_s7_q;
  logic and_660_s7_q;
  logic and_670_s7_q;
  logic and_680_s7_q;
  logic and_690_s7_q;
  logic and_700_s7_q;
  logic and_710_s7_q;
  logic and_720_s7_q;
  logic and_730_s7_q;
  logic and_740_s7_q;
  logic and_750_s7_q;
  logic and_760_s7_q;
  logic and_1387_s7_q;
  logic and_1393_s7_q;
  logic and_1399_s7_q;
  logic and_1405_s7_q;
  logic and_1411_s7_q;
  logic and_1417_s7_q;
  logic and_1423_s7_q;
  logic and_1429_s7_q;
  logic and_1435_s7_q;
  logic and_1441_s7_q;
  logic and_1447_s7_q;
  logic and_1453_s7_q;
  logic and_1459_s7_q;
  logic and_1465_s7_q;
  logic and_1471_s7_q;
  logic and_1477_s7_q;
  logic and_1483_s7_q;
  logic and_1489_s7_q;
  logic and_1495_s7_q;
  logic and_1501_s7_q;
  logic and_1507_s7_q;
  logic and_1513_s7_q;
  logic and_1519_s7_q;
  logic and_1525_s7_q;
  logic and_1531_s7_q;
  logic and_1537_s7_q;
  logic and_1543_s7_q;
  logic and_1549_s7_q;
  logic and_1555_s7_q;
  logic and_1561_s7_q;
  logic and_1567_s7_q;
  logic and_1573_s7_q;
  logic or_1657_s7_q;
  logic and_1661_s7_q;
  logic and_1688_s7_q;
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
      and_263_s7_q <= and_263_s6_q;
      not_264_s7_q <= not_264_s6_q;
      equal_300_s7_q <= equal_300_s6_q;
      and_320_s7_q <= busy_q & equal_319_s6_q;
      and_417_s7_q <= and_417;
      and_441_s7_q <= and_441;
      and_442_s7_q <= and_442;
      and_443_s7_q <= and_443;
      equal_451_s7_q <= equal_451_s6_q;
      and_452_s7_q <= and_452;
      and_454_s7_q <= and_454;
      and_460_s7_q <= and_460;
      and_470_s7_q <= and_470;
      and_480_s7_q <= and_480;
      and_490_s7_q <= and_490;
      and_500_s7_q <= and_500;
      and_510_s7_q <= and_510;
      and_520_s7_q <= and_520;
      and_530_s7_q <= and_530;
      and_540_s7_q <= and_540;
      and_550_s7_q <= and_550;
      and_560_s7_q <= and_560;
      and_570_s7_q <= and_570;
      and_580_s7_q <= and_580;
      and_590_s7_q <= and_590;
      and_600_s7_q <= and_600;
      and_610_s7_q <= and_610;
      and_620_s7_q <= and_620;
      and_630_s7_q <= and_630;
      and_640_s7_q <= and_640;
      and_650_s7_q <= and_650;
      and_660_s7_q <= and_660;
      and_670_s7_q <= and_670;
      and_680_s7_q <= and_680;
      and_690_s7_q <= and_690;
      and_700_s7_q <= and_700;
      and_710_s7_q <= and_710;
      and_720_s7_q <= and_720;
      and_730_s7_q <= and_730;
      and_740_s7_q <= and_740;
      and_750_s7_q <= and_750;
      and_760_s7_q <= and_760;
      and_1387_s7_q <= entries_0_there_q & front_there_q;
      and_1393_s7_q <= entries_1_there_q & front_there_q;
      and_1399_s7_q <= entries_2_there_q & front_there_q;
      and_1405_s7_q <= entries_3_there_q & front_there_q;
      and_1411_s7_q <= entries_4_there_q & front_there_q;
      and_1417_s7_q <= entries_5_there_q & front_there_q;
      and_1423_s7_q <= entries_6_there_q & front_there_q;
      and_1429_s7_q <= entries_7_there_q & front_there_q;
      and_1435_s7_q <= entries_8_there_q & front_there_q;
      and_1441_s7_q <= entries_9_there_q & front_there_q;
      and_1447_s7_q <= entries_10_there_q & front_there_q;
      and_1453_s7_q <= entries_11_there_q & front_there_q;
      and_1459_s7_q <= entries_12_there_q & front_there_q;
      and_1465_s7_q <= entries_13_there_q & front_there_q;
      and_1471_s7_q <= entries_14_there_q & front_there_q;
      and_1477_s7_q <= entries_15_there_q & front_there_q;
      and_1483_s7_q <= entries_16_there_q & front_there_q;
      and_1489_s7_q <= entries_17_there_q & front_there_q;
      and_1495_s7_q <= entries_18_there_q & front_there_q;
      and_1501_s7_q <= entries_19_there_q & front_there_q;
      and_1507_s7_q <= entries_20_there_q & front_there_q;
      and_1513_s7_q <= entries_21_there_q & front_there_q;
      and_1519_s7_q <= entries_22_there_q & front_there_q;
      and_1525_s7_q <= entries_23_there_q & front_there_q;
      and_1531_s7_q <= entries_24_there_q & front_there_q;
      and_1537_s7_q <= entries_25_there_q & front_there_q;
      and_1543_s7_q <= entries_26_there_q & front_there_q;
      and_1549_s7_q <= entries_27_there_q & front_there_q;
      and_1555_s7_q <= entries_28_there_q & front_there_q;
      and_1561_s7_q <= entries_29_there_q & front_there_q;
      and_1567_s7_q <= entries_30_there_q & front_there_q;
      and_1573_s7_q <= entries_31_there_q & front_there_q;
      or_1657_s7_q <= or_1657;
      and_1661_s7_q <= and_1661_s6_q;
      and_1688_s7_q <= idle_s6_q & and_421;
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
  // hls/stages/objects.hpp:371
  logic and_301;
  assign and_301 = second_q & equal_300_s7_q;
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
  // hls/stages/objects.hpp:372
  logic and_322;
  assign and_322 = and_320_s7_q & (event_ends_s7_q | joined_q);
  // hls/stages/objects.hpp:275
  logic and_444;
  assign and_444 = joined_q & and_320_s7_q;
  // hls/stages/objects.hpp:256
  logic [4:0] ended;
  assign ended = run_there_q ? run_label_q : free_label_q;
  // hls/stages/objects.hpp:290
  logic [4:0] label_2;
  assign label_2 = and_442_s7_q ? ended : run_label_q;
  // hls/stages/objects.hpp:297
  logic [4:0] select_450;
  assign select_450 = (and_443_s7_q | (and_444 & (begin_0_s7_q | same_0_q))) ? label_2 : entries_0_label_q;
  logic [4:0] select_464;
  assign select_464 = (and_460_s7_q | (and_444 & (begin_1_s7_q | same_1_q))) ? label_2 : entries_1_label_q;
  logic [4:0] select_474;
  assign select_474 = (and_470_s7_q | (and_444 & (begin_2_s7_q | same_2_q))) ? label_2 : entries_2_label_q;
  logic [4:0] select_484;
  assign select_484 = (and_480_s7_q | (and_444 & (begin_3_s7_q | same_3_q))) ? label_2 : entries_3_label_q;
  logic [4:0] select_494;
  assign select_494 = (and_490_s7_q | (and_444 & (begin_4_s7_q | same_4_q))) ? label_2 : entries_4_label_q;
  logic [4:0] select_504;
  assign select_504 = (and_500_s7_q | (and_444 & (begin_5_s7_q | same_5_q))) ? label_2 : entries_5_label_q;
  logic [4:0] select_514;
  assign select_514 = (and_510_s7_q | (and_444 & (begin_6_s7_q | same_6_q))) ? label_2 : entries_6_label_q;
  logic [4:0] select_524;
  assign select_524 = (and_520_s7_q | (and_444 & (begin_7_s7_q | same_7_q))) ? label_2 : entries_7_label_q;
  logic [4:0] select_534;
  assign select_534 = (and_530_s7_q | (and_444 & (begin_8_s7_q | same_8_q))) ? label_2 : entries_8_label_q;
  logic [4:0] select_544;
  assign select_544 = (and_540_s7_q | (and_444 & (begin_9_s7_q | same_9_q))) ? label_2 : entries_9_label_q;
  logic [4:0] select_554;
  assign select_554 = (and_550_s7_q | (and_444 & (begin_10_s7_q | same_10_q))) ? label_2 : entries_10_label_q;
  logic [4:0] select_564;
  assign select_564 = (and_560_s7_q | (and_444 & (begin_11_s7_q | same_11_q))) ? label_2 : entries_11_label_q;
  logic [4:0] select_574;
  assign select_574 = (and_570_s7_q | (and_444 & (begin_12_s7_q | same_12_q))) ? label_2 : entries_12_label_q;
  logic [4:0] select_584;
  assign select_584 = (and_580_s7_q | (and_444 & (begin_13_s7_q | same_13_q))) ? label_2 : entries_13_label_q;
  logic [4:0] select_594;
  assign select_594 = (and_590_s7_q | (and_444 & (begin_14_s7_q | same_14_q))) ? label_2 : entries_14_label_q;
  logic [4:0] select_604;
  assign select_604 = (and_600_s7_q | (and_444 & (begin_15_s7_q | same_15_q))) ? label_2 : entries_15_label_q;
  logic [4:0] select_614;
  assign select_614 = (and_610_s7_q | (and_444 & (begin_16_s7_q | same_16_q))) ? label_2 : entries_16_label_q;
  logic [4:0] select_624;
  assign select_624 = (and_620_s7_q | (and_444 & (begin_17_s7_q | same_17_q))) ? label_2 : entries_17_label_q;
  logic [4:0] select_634;
  assign select_634 = (and_630_s7_q | (and_444 & (begin_18_s7_q | same_18_q))) ? label_2 : entries_18_label_q;
  logic [4:0] select_644;
  assign select_644 = (and_640_s7_q | (and_444 & (begin_19_s7_q | same_19_q))) ? label_2 : entries_19_label_q;
  logic [4:0] select_654;
  assign select_654 = (and_650_s7_q | (and_444 & (begin_20_s7_q | same_20_q))) ? label_2 : entries_20_label_q;
  logic [4:0] select_664;
  assign select_664 = (and_660_s7_q | (and_444 & (begin_21_s7_q | same_21_q))) ? label_2 : entries_21_label_q;
  logic [4:0] select_674;
  assign select_674 = (and_670_s7_q | (and_444 & (begin_22_s7_q | same_22_q))) ? label_2 : entries_22_label_q;
  logic [4:0] select_684;
  assign select_684 = (and_680_s7_q | (and_444 & (begin_23_s7_q | same_23_q))) ? label_2 : entries_23_label_q;
  logic [4:0] select_694;
  assign select_694 = (and_690_s7_q | (and_444 & (begin_24_s7_q | same_24_q))) ? label_2 : entries_24_label_q;
  logic [4:0] select_704;
  assign select_704 = (and_700_s7_q | (and_444 & (begin_25_s7_q | same_25_q))) ? label_2 : entries_25_label_q;
  logic [4:0] select_714;
  assign select_714 = (and_710_s7_q | (and_444 & (begin_26_s7_q | same_26_q))) ? label_2 : entries_26_label_q;
  logic [4:0] select_724;
  assign select_724 = (and_720_s7_q | (and_444 & (begin_27_s7_q | same_27_q))) ? label_2 : entries_27_label_q;
  logic [4:0] select_734;
  assign select_734 = (and_730_s7_q | (and_444 & (begin_28_s7_q | same_28_q))) ? label_2 : entries_28_label_q;
  logic [4:0] select_744;
  assign select_744 = (and_740_s7_q | (and_444 & (begin_29_s7_q | same_29_q))) ? label_2 : entries_29_label_q;
  logic [4:0] select_754;
  assign select_754 = (and_750_s7_q | (and_444 & (begin_30_s7_q | same_30_q))) ? label_2 : entries_30_label_q;
  logic [4:0] select_764;
  assign select_764 = (and_760_s7_q | (and_444 & (begin_31_s7_q | same_31_q))) ? label_2 : entries_31_label_q;
  // hls/stages/objects.hpp:255
  logic not_900;
  assign not_900 = ~run_there_q;
  // hls/stages/objects.hpp:266
  logic and_902;
  assign and_902 = not_900 & (event_meets_s7_q & and_417_s7_q);
  // hls/stages/objects.hpp:273
  logic and_908;
  assign and_908 = not_264_s7_q & ((run_there_q & (~and_442_s7_q)) | (front_there_s7_q & and_902));
  // hls/stages/objects.hpp:282
  logic closes;
  assign closes = (not_302 & and_454_s7_q) & (~others_q);
  logic frees;
  assign frees = closes | (joined_q & and_452_s7_q);
  // hls/stages/objects.hpp:298
  logic not_916;
  assign not_916 = ~frees;
  // hls/stages/objects.hpp:319
  logic and_919;
  assign and_919 = looked_there_q & not_264_s7_q;
  // hls/stages/objects.hpp:317
  logic equal_920;
  assign equal_920 = looked_q == 4'hf;
  // hls/stages/objects.hpp:320
  logic and_922;
  assign and_922 = and_919 & (~equal_920);
  // hls/stages/objects.hpp:316
  logic not_923;
  assign not_923 = ~looked_q[0];
  // hls/stages/objects.hpp:299
  logic or_926;
  assign or_926 = (used_0_q & ((~(front_label_q == 5'h0)) | not_916)) | (and_922 & (group_0_q & not_923));
  // hls/stages/objects.hpp:316
  logic equal_932;
  assign equal_932 = looked_q[1:0] == 2'h1;
  // hls/stages/objects.hpp:299
  logic or_935;
  assign or_935 = (used_1_q & (not_916 | (~(front_label_q == 5'h1)))) | (and_922 & (group_0_q & equal_932));
  // hls/stages/objects.hpp:316
  logic equal_941;
  assign equal_941 = looked_q[2:0] == 3'h3;
  // hls/stages/objects.hpp:299
  logic or_944;
  assign or_944 = (used_2_q & (not_916 | (~(front_label_q == 5'h2)))) | (and_922 & (group_0_q & equal_941));
  // hls/stages/objects.hpp:316
  logic equal_950;
  assign equal_950 = looked_q == 4'h7;
  // hls/stages/objects.hpp:299
  logic or_953;
  assign or_953 = (used_3_q & (not_916 | (~(front_label_q == 5'h3)))) | (and_922 & (group_0_q & equal_950));
  logic or_961;
  assign or_961 = (used_4_q & (not_916 | (~(front_label_q == 5'h4)))) | (and_922 & (group_1_q & not_923));
  logic or_969;
  assign or_969 = (used_5_q & (not_916 | (~(front_label_q == 5'h5)))) | (and_922 & (group_1_q & equal_932));
  logic or_977;
  assign or_977 = (used_6_q & (not_916 | (~(front_label_q == 5'h6)))) | (and_922 & (group_1_q & equal_941));
  logic or_985;
  assign or_985 = (used_7_q & (not_916 | (~(front_label_q == 5'h7)))) | (and_922 & (group_1_q & equal_950));
  logic or_993;
  assign or_993 = (used_8_q & (not_916 | (~(front_label_q == 5'h8)))) | (and_922 & (group_2_q & not_923));
  logic or_1001;
  assign or_1001 = (used_9_q & (not_916 | (~(front_label_q == 5'h9)))) | (and_922 & (group_2_q & equal_932));
  logic or_1009;
  assign or_1009 = (used_10_q & (not_916 | (~(front_label_q == 5'ha)))) | (and_922 & (group_2_q & equal_941));
  logic or_1017;
  assign or_1017 = (used_11_q & (not_916 | (~(front_label_q == 5'hb)))) | (and_922 & (group_2_q & equal_950));
  logic or_1025;
  assign or_1025 = (used_12_q & (not_916 | (~(front_label_q == 5'hc)))) | (and_922 & (group_3_q & not_923));
  logic or_1033;
  assign or_1033 = (used_13_q & (not_916 | (~(front_label_q == 5'hd)))) | (and_922 & (group_3_q & equal_932));
  logic or_1041;
  assign or_1041 = (used_14_q & (not_916 | (~(front_label_q == 5'he)))) | (and_922 & (group_3_q & equal_941));
  logic or_1049;
  assign or_1049 = (used_15_q & (not_916 | (~(front_label_q == 5'hf)))) | (and_922 & (group_3_q & equal_950));
  logic or_1057;
  assign or_1057 = (used_16_q & (not_916 | (~(front_label_q == 5'h10)))) | (and_922 & (group_4_q & not_923));
  logic or_1065;
  assign or_1065 = (used_17_q & (not_916 | (~(front_label_q == 5'h11)))) | (and_922 & (group_4_q & equal_932));
  logic or_1073;
  assign or_1073 = (used_18_q & (not_916 | (~(front_label_q == 5'h12)))) | (and_922 & (group_4_q & equal_941));
  logic or_1081;
  assign or_1081 = (used_19_q & (not_916 | (~(front_label_q == 5'h13)))) | (and_922 & (group_4_q & equal_950));
  logic or_1089;
  assign or_1089 = (used_20_q & (not_916 | (~(front_label_q == 5'h14)))) | (and_922 & (group_5_q & not_923));
  logic or_1097;
  assign or_1097 = (used_21_q & (not_916 | (~(front_label_q == 5'h15)))) | (and_922 & (group_5_q & equal_932));
  logic or_1105;
  assign or_1105 = (used_22_q & (not_916 | (~(front_label_q == 5'h16)))) | (and_922 & (group_5_q & equal_941));
  logic or_1113;
  assign or_1113 = (used_23_q & (not_916 | (~(front_label_q == 5'h17)))) | (and_922 & (group_5_q & equal_950));
  logic or_1121;
  assign or_1121 = (used_24_q & (not_916 | (~(front_label_q == 5'h18)))) | (and_922 & (group_6_q & not_923));
  logic or_1129;
  assign or_1129 = (used_25_q & (not_916 | (~(front_label_q == 5'h19)))) | (and_922 & (group_6_q & equal_932));
  logic or_1137;
  assign or_1137 = (used_26_q & (not_916 | (~(front_label_q == 5'h1a)))) | (and_922 & (group_6_q & equal_941));
  logic or_1145;
  assign or_1145 = (used_27_q & (not_916 | (~(front_label_q == 5'h1b)))) | (and_922 & (group_6_q & equal_950));
  logic or_1153;
  assign or_1153 = (used_28_q & (not_916 | (~(front_label_q == 5'h1c)))) | (and_922 & (group_7_q & not_923));
  logic or_1161;
  assign or_1161 = (used_29_q & (not_916 | (~(front_label_q == 5'h1d)))) | (and_922 & (group_7_q & equal_932));
  logic or_1169;
  assign or_1169 = (used_30_q & (not_916 | (~(front_label_q == 5'h1e)))) | (and_922 & (group_7_q & equal_941));
  logic or_1177;
  assign or_1177 = (used_31_q & (not_916 | (~(front_label_q == 5'h1f)))) | (and_922 & (group_7_q & equal_950));
  // hls/stages/objects.hpp:255
  logic and_1179;
  assign and_1179 = and_442_s7_q & not_900;
  // hls/stages/objects.hpp:262
  logic not_1180;
  assign not_1180 = ~free_there_q;
  // hls/stages/objects.hpp:322
  logic and_1182;
  assign and_1182 = found_there_q & (and_1179 | not_1180);
  // hls/stages/objects.hpp:325
  logic or_1188;
  assign or_1188 = equal_932 | equal_950;
  logic or_1189;
  assign or_1189 = equal_941 | equal_950;
  // hls/stages/objects.hpp:344
  logic and_1194;
  assign and_1194 = equal_920 & and_919;
  // hls/stages/objects.hpp:337
  logic and_1213;
  assign and_1213 = used_0_q & group_0_q;
  logic and_1214;
  assign and_1214 = used_1_q & group_0_q;
  logic and_1215;
  assign and_1215 = used_2_q & group_0_q;
  logic and_1216;
  assign and_1216 = used_3_q & group_0_q;
  logic and_1217;
  assign and_1217 = used_4_q & group_1_q;
  logic and_1218;
  assign and_1218 = used_5_q & group_1_q;
  logic and_1219;
  assign and_1219 = used_6_q & group_1_q;
  logic and_1220;
  assign and_1220 = used_7_q & group_1_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used;
  assign used = {and_1216, and_1215, and_1214, and_1213} | {and_1220, and_1219, and_1218, and_1217};
  // hls/stages/objects.hpp:337
  logic and_1222;
  assign and_1222 = used_8_q & group_2_q;
  logic and_1223;
  assign and_1223 = used_9_q & group_2_q;
  logic and_1224;
  assign and_1224 = used_10_q & group_2_q;
  logic and_1225;
  assign and_1225 = used_11_q & group_2_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_2;
  assign used_2 = used | {and_1225, and_1224, and_1223, and_1222};
  // hls/stages/objects.hpp:337
  logic and_1227;
  assign and_1227 = used_12_q & group_3_q;
  logic and_1228;
  assign and_1228 = used_13_q & group_3_q;
  logic and_1229;
  assign and_1229 = used_14_q & group_3_q;
  logic and_1230;
  assign and_1230 = used_15_q & group_3_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_3;
  assign used_3 = used_2 | {and_1230, and_1229, and_1228, and_1227};
  // hls/stages/objects.hpp:337
  logic and_1232;
  assign and_1232 = used_16_q & group_4_q;
  logic and_1233;
  assign and_1233 = used_17_q & group_4_q;
  logic and_1234;
  assign and_1234 = used_18_q & group_4_q;
  logic and_1235;
  assign and_1235 = used_19_q & group_4_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_4;
  assign used_4 = used_3 | {and_1235, and_1234, and_1233, and_1232};
  // hls/stages/objects.hpp:337
  logic and_1237;
  assign and_1237 = used_20_q & group_5_q;
  logic and_1238;
  assign and_1238 = used_21_q & group_5_q;
  logic and_1239;
  assign and_1239 = used_22_q & group_5_q;
  logic and_1240;
  assign and_1240 = used_23_q & group_5_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_5;
  assign used_5 = used_4 | {and_1240, and_1239, and_1238, and_1237};
  // hls/stages/objects.hpp:337
  logic and_1242;
  assign and_1242 = used_24_q & group_6_q;
  logic and_1243;
  assign and_1243 = used_25_q & group_6_q;
  logic and_1244;
  assign and_1244 = used_26_q & group_6_q;
  logic and_1245;
  assign and_1245 = used_27_q & group_6_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_6;
  assign used_6 = used_5 | {and_1245, and_1244, and_1243, and_1242};
  // hls/stages/objects.hpp:337
  logic and_1247;
  assign and_1247 = used_28_q & group_7_q;
  logic and_1248;
  assign and_1248 = used_29_q & group_7_q;
  logic and_1249;
  assign and_1249 = used_30_q & group_7_q;
  logic and_1250;
  assign and_1250 = used_31_q & group_7_q;
  // hls/stages/objects.hpp:338
  logic [3:0] used_7;
  assign used_7 = used_6 | {and_1250, and_1249, and_1248, and_1247};
  // hls/stages/objects.hpp:342
  logic and_1256;
  assign and_1256 = not_264_s7_q & ((~looked_there_q) & (and_1182 | (~found_there_q)));
  // hls/stages/objects.hpp:167
  logic [4:0] or_1259;
  assign or_1259 = (begin_0_s7_q ? entries_0_label_q : 5'h0) | (begin_1_s7_q ? entries_1_label_q : 5'h0);
  logic [4:0] or_1262;
  assign or_1262 = (begin_2_s7_q ? entries_2_label_q : 5'h0) | (begin_3_s7_q ? entries_3_label_q : 5'h0);
  logic [4:0] or_1266;
  assign or_1266 = (begin_4_s7_q ? entries_4_label_q : 5'h0) | (begin_5_s7_q ? entries_5_label_q : 5'h0);
  logic [4:0] or_1269;
  assign or_1269 = (begin_6_s7_q ? entries_6_label_q : 5'h0) | (begin_7_s7_q ? entries_7_label_q : 5'h0);
  logic [4:0] or_1274;
  assign or_1274 = (begin_8_s7_q ? entries_8_label_q : 5'h0) | (begin_9_s7_q ? entries_9_label_q : 5'h0);
  logic [4:0] or_1277;
  assign or_1277 = (begin_10_s7_q ? entries_10_label_q : 5'h0) | (begin_11_s7_q ? entries_11_label_q : 5'h0);
  logic [4:0] or_1281;
  assign or_1281 = (begin_12_s7_q ? entries_12_label_q : 5'h0) | (begin_13_s7_q ? entries_13_label_q : 5'h0);
  logic [4:0] or_1284;
  assign or_1284 = (begin_14_s7_q ? entries_14_label_q : 5'h0) | (begin_15_s7_q ? entries_15_label_q : 5'h0);
  logic [4:0] or_1287;
  assign or_1287 = ((or_1259 | or_1262) | (or_1266 | or_1269)) | ((or_1274 | or_1277) | (or_1281 | or_1284));
  logic [4:0] or_1290;
  assign or_1290 = (begin_16_s7_q ? entries_16_label_q : 5'h0) | (begin_17_s7_q ? entries_17_label_q : 5'h0);
  logic [4:0] or_1293;
  assign or_1293 = (begin_18_s7_q ? entries_18_label_q : 5'h0) | (begin_19_s7_q ? entries_19_label_q : 5'h0);
  logic [4:0] or_1297;
  assign or_1297 = (begin_20_s7_q ? entries_20_label_q : 5'h0) | (begin_21_s7_q ? entries_21_label_q : 5'h0);
  logic [4:0] or_1300;
  assign or_1300 = (begin_22_s7_q ? entries_22_label_q : 5'h0) | (begin_23_s7_q ? entries_23_label_q : 5'h0);
  logic [4:0] or_1305;
  assign or_1305 = (begin_24_s7_q ? entries_24_label_q : 5'h0) | (begin_25_s7_q ? entries_25_label_q : 5'h0);
  logic [4:0] or_1308;
  assign or_1308 = (begin_26_s7_q ? entries_26_label_q : 5'h0) | (begin_27_s7_q ? entries_27_label_q : 5'h0);
  logic [4:0] or_1312;
  assign or_1312 = (begin_28_s7_q ? entries_28_label_q : 5'h0) | (begin_29_s7_q ? entries_29_label_q : 5'h0);
  logic [4:0] or_1315;
  assign or_1315 = (begin_30_s7_q ? entries_30_label_q : 5'h0) | (begin_31_s7_q ? entries_31_label_q : 5'h0);
  logic [4:0] or_1318;
  assign or_1318 = ((or_1290 | or_1293) | (or_1297 | or_1300)) | ((or_1305 | or_1308) | (or_1312 | or_1315));
  // hls/stages/objects.hpp:270
  logic and_1391;
  assign and_1391 = (and_1387_s7_q & (entries_0_label_q == front_label_q)) & (~begin_0_s7_q);
  logic and_1397;
  assign and_1397 = (and_1393_s7_q & (entries_1_label_q == front_label_q)) & (~begin_1_s7_q);
  logic and_1403;
  assign and_1403 = (and_1399_s7_q & (entries_2_label_q == front_label_q)) & (~begin_2_s7_q);
  logic and_1409;
  assign and_1409 = (and_1405_s7_q & (entries_3_label_q == front_label_q)) & (~begin_3_s7_q);
  logic and_1415;
  assign and_1415 = (and_1411_s7_q & (entries_4_label_q == front_label_q)) & (~begin_4_s7_q);
  logic and_1421;
  assign and_1421 = (and_1417_s7_q & (entries_5_label_q == front_label_q)) & (~begin_5_s7_q);
  logic and_1427;
  assign and_1427 = (and_1423_s7_q & (entries_6_label_q == front_label_q)) & (~begin_6_s7_q);
  logic and_1433;
  assign and_1433 = (and_1429_s7_q & (entries_7_label_q == front_label_q)) & (~begin_7_s7_q);
  logic and_1439;
  assign and_1439 = (and_1435_s7_q & (entries_8_label_q == front_label_q)) & (~begin_8_s7_q);
  logic and_1445;
  assign and_1445 = (and_1441_s7_q & (entries_9_label_q == front_label_q)) & (~begin_9_s7_q);
  logic and_1451;
  assign and_1451 = (and_1447_s7_q & (entries_10_label_q == front_label_q)) & (~begin_10_s7_q);
  logic and_1457;
  assign and_1457 = (and_1453_s7_q & (entries_11_label_q == front_label_q)) & (~begin_11_s7_q);
  logic and_1463;
  assign and_1463 = (and_1459_s7_q & (entries_12_label_q == front_label_q)) & (~begin_12_s7_q);
  logic and_1469;
  assign and_1469 = (and_1465_s7_q & (entries_13_label_q == front_label_q)) & (~begin_13_s7_q);
  logic and_1475;
  assign and_1475 = (and_1471_s7_q & (entries_14_label_q == front_label_q)) & (~begin_14_s7_q);
  logic and_1481;
  assign and_1481 = (and_1477_s7_q & (entries_15_label_q == front_label_q)) & (~begin_15_s7_q);
  logic and_1487;
  assign and_1487 = (and_1483_s7_q & (entries_16_label_q == front_label_q)) & (~begin_16_s7_q);
  logic and_1493;
  assign and_1493 = (and_1489_s7_q & (entries_17_label_q == front_label_q)) & (~begin_17_s7_q);
  logic and_1499;
  assign and_1499 = (and_1495_s7_q & (entries_18_label_q == front_label_q)) & (~begin_18_s7_q);
  logic and_1505;
  assign and_1505 = (and_1501_s7_q & (entries_19_label_q == front_label_q)) & (~begin_19_s7_q);
  logic and_1511;
  assign and_1511 = (and_1507_s7_q & (entries_20_label_q == front_label_q)) & (~begin_20_s7_q);
  logic and_1517;
  assign and_1517 = (and_1513_s7_q & (entries_21_label_q == front_label_q)) & (~begin_21_s7_q);
  logic and_1523;
  assign and_1523 = (and_1519_s7_q & (entries_22_label_q == front_label_q)) & (~begin_22_s7_q);
  logic and_1529;
  assign and_1529 = (and_1525_s7_q & (entries_23_label_q == front_label_q)) & (~begin_23_s7_q);
  logic and_1535;
  assign and_1535 = (and_1531_s7_q & (entries_24_label_q == front_label_q)) & (~begin_24_s7_q);
  logic and_1541;
  assign and_1541 = (and_1537_s7_q & (entries_25_label_q == front_label_q)) & (~begin_25_s7_q);
  logic and_1547;
  assign and_1547 = (and_1543_s7_q & (entries_26_label_q == front_label_q)) & (~begin_26_s7_q);
  logic and_1553;
  assign and_1553 = (and_1549_s7_q & (entries_27_label_q == front_label_q)) & (~begin_27_s7_q);
  logic and_1559;
  assign and_1559 = (and_1555_s7_q & (entries_28_label_q == front_label_q)) & (~begin_28_s7_q);
  logic and_1565;
  assign and_1565 = (and_1561_s7_q & (entries_29_label_q == front_label_q)) & (~begin_29_s7_q);
  logic and_1571;
  assign and_1571 = (and_1567_s7_q & (entries_30_label_q == front_label_q)) & (~begin_30_s7_q);
  logic and_1577;
  assign and_1577 = (and_1573_s7_q & (entries_31_label_q == front_label_q)) & (~begin_31_s7_q);
  // hls/stages/objects.hpp:277
  logic equal_1579;
  assign equal_1579 = {same_31_q, same_30_q, same_29_q, same_28_q, same_27_q, same_26_q, same_25_q, same_24_q, same_23_q, same_22_q, same_21_q, same_20_q, same_19_q, same_18_q, same_17_q, same_16_q, same_15_q, same_14_q, same_13_q, same_12_q, same_11_q, same_10_q, same_9_q, same_8_q, same_7_q, same_6_q, same_5_q, same_4_q, same_3_q, same_2_q, same_1_q, same_0_q} == 32'h0;
  // hls/stages/objects.hpp:268
  logic equal_1581;
  assign equal_1581 = run_label_q == front_label_q;
  // hls/stages/objects.hpp:281
  logic select_1585;
  assign select_1585 = and_320_s7_q ? ((~equal_1579) | (equal_1581 & (run_there_q & front_there_s7_q))) : others_q;
  // hls/stages/objects.hpp:268
  logic and_1589;
  assign and_1589 = (front_there_s7_q & (event_meets_s7_q & run_there_q)) & (~equal_1581);
  // hls/stages/objects.hpp:281
  logic [4:0] select_1592;
  assign select_1592 = and_320_s7_q ? (joined_q ? run_label_q : front_label_q) : other_q;
  // hls/stages/objects.hpp:96
  logic or_1662;
  assign or_1662 = (and_442_s7_q & (or_1657_s7_q | (not_900 & not_1180))) | and_1661_s7_q;

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
      entries_0_label_q <= select_450;
      entries_1_label_q <= select_464;
      entries_2_label_q <= select_474;
      entries_3_label_q <= select_484;
      entries_4_label_q <= select_494;
      entries_5_label_q <= select_504;
      entries_6_label_q <= select_514;
      entries_7_label_q <= select_524;
      entries_8_label_q <= select_534;
      entries_9_label_q <= select_544;
      entries_10_label_q <= select_554;
      entries_11_label_q <= select_564;
      entries_12_label_q <= select_574;
      entries_13_label_q <= select_584;
      entries_14_label_q <= select_594;
      entries_15_label_q <= select_604;
      entries_16_label_q <= select_614;
      entries_17_label_q <= select_624;
      entries_18_label_q <= select_634;
      entries_19_label_q <= select_644;
      entries_20_label_q <= select_654;
      entries_21_label_q <= select_664;
      entries_22_label_q <= select_674;
      entries_23_label_q <= select_684;
      entries_24_label_q <= select_694;
      entries_25_label_q <= select_704;
      entries_26_label_q <= select_714;
      entries_27_label_q <= select_724;
      entries_28_label_q <= select_734;
      entries_29_label_q <= select_744;
      entries_30_label_q <= select_754;
      entries_31_label_q <= select_764;
      run_label_q <= and_902 ? front_label_q : run_label_q;
      run_there_q <= and_908;
      used_0_q <= not_264_s7_q & or_926;
      used_1_q <= not_264_s7_q & or_935;
      used_2_q <= not_264_s7_q & or_944;
      used_3_q <= not_264_s7_q & or_953;
      used_4_q <= not_264_s7_q & or_961;
      used_5_q <= not_264_s7_q & or_969;
      used_6_q <= not_264_s7_q & or_977;
      used_7_q <= not_264_s7_q & or_985;
      used_8_q <= not_264_s7_q & or_993;
      used_9_q <= not_264_s7_q & or_1001;
      used_10_q <= not_264_s7_q & or_1009;
      used_11_q <= not_264_s7_q & or_1017;
      used_12_q <= not_264_s7_q & or_1025;
      used_13_q <= not_264_s7_q & or_1033;
      used_14_q <= not_264_s7_q & or_1041;
      used_15_q <= not_264_s7_q & or_1049;
      used_16_q <= not_264_s7_q & or_1057;
      used_17_q <= not_264_s7_q & or_1065;
      used_18_q <= not_264_s7_q & or_1073;
      used_19_q <= not_264_s7_q & or_1081;
      used_20_q <= not_264_s7_q & or_1089;
      used_21_q <= not_264_s7_q & or_1097;
      used_22_q <= not_264_s7_q & or_1105;
      used_23_q <= not_264_s7_q & or_1113;
      used_24_q <= not_264_s7_q & or_1121;
      used_25_q <= not_264_s7_q & or_1129;
      used_26_q <= not_264_s7_q & or_1137;
      used_27_q <= not_264_s7_q & or_1145;
      used_28_q <= not_264_s7_q & or_1153;
      used_29_q <= not_264_s7_q & or_1161;
      used_30_q <= not_264_s7_q & or_1169;
      used_31_q <= not_264_s7_q & or_1177;
      free_label_q <= and_1182 ? found_label_q : free_label_q;
      free_there_q <= not_264_s7_q & (and_1182 | (free_there_q & (~and_1179)));
      found_label_q <= and_922 ? {at_group_q, or_1189, or_1188} : found_label_q;
      found_there_q <= not_264_s7_q & (and_922 | (found_there_q ^ and_1182));
      group_0_q <= and_263_s7_q | (and_1194 ? group_7_q : group_0_q);
      group_1_q <= not_264_s7_q & (and_1194 ? group_0_q : group_1_q);
      group_2_q <= not_264_s7_q & (and_1194 ? group_1_q : group_2_q);
      group_3_q <= not_264_s7_q & (and_1194 ? group_2_q : group_3_q);
      group_4_q <= not_264_s7_q & (and_1194 ? group_3_q : group_4_q);
      group_5_q <= not_264_s7_q & (and_1194 ? group_4_q : group_5_q);
      group_6_q <= not_264_s7_q & (and_1194 ? group_5_q : group_6_q);
      group_7_q <= not_264_s7_q & (and_1194 ? group_6_q : group_7_q);
      at_group_q <= and_263_s7_q ? 3'h0 : (at_group_q + {2'h0, and_1194});
      looked_q <= used_7;
      looked_there_q <= and_1256;
      front_label_q <= and_441_s7_q ? (or_1287 | or_1318) : front_label_q;
      label_q <= and_441_s7_q ? ended : label_q;
      fresh_q <= and_441_s7_q ? not_900 : fresh_q;
      same_0_q <= and_417_s7_q ? and_1391 : same_0_q;
      same_1_q <= and_417_s7_q ? and_1397 : same_1_q;
      same_2_q <= and_417_s7_q ? and_1403 : same_2_q;
      same_3_q <= and_417_s7_q ? and_1409 : same_3_q;
      same_4_q <= and_417_s7_q ? and_1415 : same_4_q;
      same_5_q <= and_417_s7_q ? and_1421 : same_5_q;
      same_6_q <= and_417_s7_q ? and_1427 : same_6_q;
      same_7_q <= and_417_s7_q ? and_1433 : same_7_q;
      same_8_q <= and_417_s7_q ? and_1439 : same_8_q;
      same_9_q <= and_417_s7_q ? and_1445 : same_9_q;
      same_10_q <= and_417_s7_q ? and_1451 : same_10_q;
      same_11_q <= and_417_s7_q ? and_1457 : same_11_q;
      same_12_q <= and_417_s7_q ? and_1463 : same_12_q;
      same_13_q <= and_417_s7_q ? and_1469 : same_13_q;
      same_14_q <= and_417_s7_q ? and_1475 : same_14_q;
      same_15_q <= and_417_s7_q ? and_1481 : same_15_q;
      same_16_q <= and_417_s7_q ? and_1487 : same_16_q;
      same_17_q <= and_417_s7_q ? and_1493 : same_17_q;
      same_18_q <= and_417_s7_q ? and_1499 : same_18_q;
      same_19_q <= and_417_s7_q ? and_1505 : same_19_q;
      same_20_q <= and_417_s7_q ? and_1511 : same_20_q;
      same_21_q <= and_417_s7_q ? and_1517 : same_21_q;
      same_22_q <= and_417_s7_q ? and_1523 : same_22_q;
      same_23_q <= and_417_s7_q ? and_1529 : same_23_q;
      same_24_q <= and_417_s7_q ? and_1535 : same_24_q;
      same_25_q <= and_417_s7_q ? and_1541 : same_25_q;
      same_26_q <= and_417_s7_q ? and_1547 : same_26_q;
      same_27_q <= and_417_s7_q ? and_1553 : same_27_q;
      same_28_q <= and_417_s7_q ? and_1559 : same_28_q;
      same_29_q <= and_417_s7_q ? and_1565 : same_29_q;
      same_30_q <= and_417_s7_q ? and_1571 : same_30_q;
      same_31_q <= and_417_s7_q ? and_1577 : same_31_q;
      others_q <= select_1585;
      joined_q <= and_417_s7_q ? and_1589 : joined_q;
      other_q <= select_1592;
      second_q <= equal_451_s7_q ? frees : second_q;
      second_ends_q <= equal_451_s7_q ? closes : second_ends_q;
      overflow_q <= or_1662 | (~(and_263_s7_q | (~overflow_q)));
    end
  end

  logic [10:0] event_run_left_s8_q;
  logic [10:0] event_run_right_s8_q;
  logic [10:0] event_run_row_s8_q;
  logic not_264_s8_q;
  logic and_301_s8_q;
  logic [4:0] select_310_s8_q;
  logic [4:0] select_317_s8_q;
  logic or_323_s8_q;
  logic and_325_s8_q;
  logic not_361_s8_q;
  logic and_1680_s8_q;
  logic and_1688_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      event_run_left_s8_q <= event_run_left_s7_q;
      event_run_right_s8_q <= event_run_right_s7_q;
      event_run_row_s8_q <= event_run_row_s7_q;
      not_264_s8_q <= not_264_s7_q;
      and_301_s8_q <= and_301;
      select_310_s8_q <= select_303[2] ? select_306 : {4'h0, select_309};
      select_317_s8_q <= select_303[2] ? select_313 : select_316;
      or_323_s8_q <= and_301 | and_322;
      and_325_s8_q <= fresh_q & and_322;
      not_361_s8_q <= ~(and_301 ? second_ends_q : joined_q);
      and_1680_s8_q <= second_ends_q & and_301;
      and_1688_s8_q <= and_1688_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:380
  logic [4:0] label;
  assign label = and_301_s8_q ? select_310_s8_q : select_317_s8_q;
  // hls/stages/objects.hpp:394
  logic [10:0] pixels;
  assign pixels = (event_run_right_s8_q - event_run_left_s8_q) + 11'h1;

  // Memory objects, 32 x 129, DISTANCE 8, hls/stages/objects.hpp:458; read in stage 8, written in stage 12: 8 < 12 < 8 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [128:0] objects_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) objects_mem[i] = 129'h0;
`endif
  logic [4:0] objects_raddr;
  assign objects_raddr = label;
  logic objects_re;
  assign objects_re = s8_en & or_323_s8_q;
  logic [128:0] objects_rdata_q;
  always_ff @(posedge clk_i) begin
    if (objects_re) objects_rdata_q <= objects_mem[objects_raddr];
  end

  logic [10:0] event_run_left_s9_q;
  logic [10:0] event_run_right_s9_q;
  logic [10:0] event_run_row_s9_q;
  logic not_264_s9_q;
  logic and_301_s9_q;
  logic [4:0] label_s9_q;
  logic or_323_s9_q;
  logic and_325_s9_q;
  logic [10:0] pixels_s9_q;
  logic [11:0] sum_347_s9_q;
  logic not_361_s9_q;
  logic or_1666_s9_q;
  logic and_1680_s9_q;
  logic and_1688_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      event_run_left_s9_q <= event_run_left_s8_q;
      event_run_right_s9_q <= event_run_right_s8_q;
      event_run_row_s9_q <= event_run_row_s8_q;
      not_264_s9_q <= not_264_s8_q;
      and_301_s9_q <= and_301_s8_q;
      label_s9_q <= label;
      or_323_s9_q <= or_323_s8_q;
      and_325_s9_q <= and_325_s8_q;
      pixels_s9_q <= pixels;
      sum_347_s9_q <= {1'b0, event_run_left_s8_q} + {1'b0, event_run_right_s8_q};
      not_361_s9_q <= not_361_s8_q;
      or_1666_s9_q <= overflow_q;
      and_1680_s9_q <= and_1680_s8_q;
      and_1688_s9_q <= and_1688_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:399
  logic [22:0] product_348;
  assign product_348 = {12'h0, pixels_s9_q} * {11'h0, sum_347_s9_q};
  // hls/stages/objects.hpp:400
  logic [21:0] product_354;
  assign product_354 = {11'h0, event_run_row_s9_q} * {11'h0, pixels_s9_q};

  logic [10:0] event_run_left_s10_q;
  logic [10:0] event_run_right_s10_q;
  logic [10:0] event_run_row_s10_q;
  logic not_264_s10_q;
  logic and_301_s10_q;
  logic [4:0] label_s10_q;
  logic or_323_s10_q;
  logic [128:0] objects_rdata_s10_q;
  logic and_325_s10_q;
  logic [10:0] pixels_s10_q;
  logic [21:0] product_348_s10_q;
  logic [21:0] product_354_s10_q;
  logic not_361_s10_q;
  logic or_1666_s10_q;
  logic and_1680_s10_q;
  logic and_1688_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      event_run_left_s10_q <= event_run_left_s9_q;
      event_run_right_s10_q <= event_run_right_s9_q;
      event_run_row_s10_q <= event_run_row_s9_q;
      not_264_s10_q <= not_264_s9_q;
      and_301_s10_q <= and_301_s9_q;
      label_s10_q <= label_s9_q;
      or_323_s10_q <= or_323_s9_q;
      objects_rdata_s10_q <= objects_rdata_q;
      and_325_s10_q <= and_325_s9_q;
      pixels_s10_q <= pixels_s9_q;
      product_348_s10_q <= product_348[22:1];
      product_354_s10_q <= product_354;
      not_361_s10_q <= not_361_s9_q;
      or_1666_s10_q <= or_1666_s9_q;
      and_1680_s10_q <= and_1680_s9_q;
      and_1688_s10_q <= and_1688_s9_q;
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
  // hls/stages/objects.hpp:405
  logic [20:0] sum_329;
  assign sum_329 = objects_rdata_s10_q[20:0] + (and_301_s10_q ? joining_pixels_q : {10'h0, pixels_s10_q});
  // hls/stages/objects.hpp:377
  logic [10:0] select_331;
  assign select_331 = and_301_s10_q ? joining_left_q : event_run_left_s10_q;
  logic [10:0] select_335;
  assign select_335 = and_301_s10_q ? joining_right_q : event_run_right_s10_q;
  logic [10:0] select_339;
  assign select_339 = and_301_s10_q ? joining_top_q : event_run_row_s10_q;
  logic [10:0] select_343;
  assign select_343 = and_301_s10_q ? joining_bottom_q : event_run_row_s10_q;
  logic [31:0] b;
  assign b = and_301_s10_q ? joining_columns_q : {10'h0, product_348_s10_q};
  // hls/stages/objects.hpp:417
  logic [16:0] low;
  assign low = {1'b0, objects_rdata_s10_q[80:65]} + {1'b0, b[15:0]};
  // hls/stages/objects.hpp:377
  logic [31:0] b_2;
  assign b_2 = and_301_s10_q ? joining_rows_q : {10'h0, product_354_s10_q};
  // hls/stages/objects.hpp:417
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
      joining_pixels_q <= or_323_s10_q ? objects_rdata_s10_q[20:0] : joining_pixels_q;
      joining_left_q <= or_323_s10_q ? objects_rdata_s10_q[31:21] : joining_left_q;
      joining_right_q <= or_323_s10_q ? objects_rdata_s10_q[42:32] : joining_right_q;
      joining_top_q <= or_323_s10_q ? objects_rdata_s10_q[53:43] : joining_top_q;
      joining_bottom_q <= or_323_s10_q ? objects_rdata_s10_q[64:54] : joining_bottom_q;
      joining_columns_q <= or_323_s10_q ? objects_rdata_s10_q[96:65] : joining_columns_q;
      joining_rows_q <= or_323_s10_q ? objects_rdata_s10_q[128:97] : joining_rows_q;
    end
  end

  logic [10:0] event_run_left_s11_q;
  logic [10:0] event_run_right_s11_q;
  logic [10:0] event_run_row_s11_q;
  logic not_264_s11_q;
  logic [4:0] label_s11_q;
  logic or_323_s11_q;
  logic [43:0] objects_rdata_s11_q;
  logic and_325_s11_q;
  logic [10:0] pixels_s11_q;
  logic [20:0] sum_329_s11_q;
  logic [10:0] select_331_s11_q;
  logic less_332_s11_q;
  logic [10:0] select_335_s11_q;
  logic less_336_s11_q;
  logic [10:0] select_339_s11_q;
  logic less_340_s11_q;
  logic [10:0] select_343_s11_q;
  logic less_344_s11_q;
  logic [21:0] product_348_s11_q;
  logic [16:0] low_s11_q;
  logic [15:0] sum_351_s11_q;
  logic [21:0] product_354_s11_q;
  logic [16:0] low_2_s11_q;
  logic [15:0] sum_357_s11_q;
  logic not_361_s11_q;
  logic or_1666_s11_q;
  logic and_1680_s11_q;
  logic [20:0] select_1681_s11_q;
  logic [31:0] select_1686_s11_q;
  logic [31:0] select_1687_s11_q;
  logic and_1688_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      event_run_left_s11_q <= event_run_left_s10_q;
      event_run_right_s11_q <= event_run_right_s10_q;
      event_run_row_s11_q <= event_run_row_s10_q;
      not_264_s11_q <= not_264_s10_q;
      label_s11_q <= label_s10_q;
      or_323_s11_q <= or_323_s10_q;
      objects_rdata_s11_q <= objects_rdata_s10_q[64:21];
      and_325_s11_q <= and_325_s10_q;
      pixels_s11_q <= pixels_s10_q;
      sum_329_s11_q <= sum_329;
      select_331_s11_q <= select_331;
      less_332_s11_q <= select_331 < objects_rdata_s10_q[31:21];
      select_335_s11_q <= select_335;
      less_336_s11_q <= objects_rdata_s10_q[42:32] < select_335;
      select_339_s11_q <= select_339;
      less_340_s11_q <= select_339 < objects_rdata_s10_q[53:43];
      select_343_s11_q <= select_343;
      less_344_s11_q <= objects_rdata_s10_q[64:54] < select_343;
      product_348_s11_q <= product_348_s10_q;
      low_s11_q <= low;
      sum_351_s11_q <= objects_rdata_s10_q[96:81] + b[31:16];
      product_354_s11_q <= product_354_s10_q;
      low_2_s11_q <= low_2;
      sum_357_s11_q <= objects_rdata_s10_q[128:113] + b_2[31:16];
      not_361_s11_q <= not_361_s10_q;
      or_1666_s11_q <= or_1666_s10_q;
      and_1680_s11_q <= and_1680_s10_q;
      select_1681_s11_q <= or_323_s10_q ? objects_rdata_s10_q[20:0] : 21'h0;
      select_1686_s11_q <= or_323_s10_q ? objects_rdata_s10_q[96:65] : 32'h0;
      select_1687_s11_q <= or_323_s10_q ? objects_rdata_s10_q[128:97] : 32'h0;
      and_1688_s11_q <= and_1688_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  // hls/stages/objects.hpp:383
  logic [20:0] select_330;
  assign select_330 = and_325_s11_q ? {10'h0, pixels_s11_q} : sum_329_s11_q;
  logic [10:0] select_334;
  assign select_334 = and_325_s11_q ? event_run_left_s11_q : (less_332_s11_q ? select_331_s11_q : objects_rdata_s11_q[10:0]);
  logic [10:0] select_338;
  assign select_338 = and_325_s11_q ? event_run_right_s11_q : (less_336_s11_q ? select_335_s11_q : objects_rdata_s11_q[21:11]);
  logic [10:0] select_342;
  assign select_342 = and_325_s11_q ? event_run_row_s11_q : (less_340_s11_q ? select_339_s11_q : objects_rdata_s11_q[32:22]);
  logic [10:0] select_346;
  assign select_346 = and_325_s11_q ? event_run_row_s11_q : (less_344_s11_q ? select_343_s11_q : objects_rdata_s11_q[43:33]);
  // hls/stages/objects.hpp:419
  logic [15:0] sum_352;
  assign sum_352 = {15'h0, low_s11_q[16]} + sum_351_s11_q;
  // hls/stages/objects.hpp:383
  logic [31:0] select_353;
  assign select_353 = and_325_s11_q ? {10'h0, product_348_s11_q} : {sum_352, low_s11_q[15:0]};
  // hls/stages/objects.hpp:419
  logic [15:0] sum_358;
  assign sum_358 = {15'h0, low_2_s11_q[16]} + sum_357_s11_q;
  // hls/stages/objects.hpp:383
  logic [31:0] select_359;
  assign select_359 = and_325_s11_q ? {10'h0, product_354_s11_q} : {sum_358, low_2_s11_q[15:0]};
  // hls/stages/objects.hpp:88
  logic and_1677;
  assign and_1677 = or_323_s11_q & (not_361_s11_q & (~(select_330 < cfg_object_limit_i)));

  logic not_264_s12_q;
  logic [4:0] label_s12_q;
  logic [20:0] select_330_s12_q;
  logic [10:0] select_334_s12_q;
  logic [10:0] select_338_s12_q;
  logic [10:0] select_342_s12_q;
  logic [10:0] select_346_s12_q;
  logic [31:0] select_353_s12_q;
  logic [31:0] select_359_s12_q;
  logic and_362_s12_q;
  logic or_1666_s12_q;
  logic and_1677_s12_q;
  logic and_1680_s12_q;
  logic [20:0] select_1681_s12_q;
  logic [10:0] select_1682_s12_q;
  logic [10:0] select_1683_s12_q;
  logic [10:0] select_1684_s12_q;
  logic [10:0] select_1685_s12_q;
  logic [31:0] select_1686_s12_q;
  logic [31:0] select_1687_s12_q;
  logic and_1688_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      not_264_s12_q <= not_264_s11_q;
      label_s12_q <= label_s11_q;
      select_330_s12_q <= select_330;
      select_334_s12_q <= select_334;
      select_338_s12_q <= select_338;
      select_342_s12_q <= select_342;
      select_346_s12_q <= select_346;
      select_353_s12_q <= select_353;
      select_359_s12_q <= select_359;
      and_362_s12_q <= not_361_s11_q & or_323_s11_q;
      or_1666_s12_q <= or_1666_s11_q;
      and_1677_s12_q <= and_1677;
      and_1680_s12_q <= and_1680_s11_q;
      select_1681_s12_q <= select_1681_s11_q;
      select_1682_s12_q <= or_323_s11_q ? objects_rdata_s11_q[10:0] : 11'h0;
      select_1683_s12_q <= or_323_s11_q ? objects_rdata_s11_q[21:11] : 11'h0;
      select_1684_s12_q <= or_323_s11_q ? objects_rdata_s11_q[32:22] : 11'h0;
      select_1685_s12_q <= or_323_s11_q ? objects_rdata_s11_q[43:33] : 11'h0;
      select_1686_s12_q <= select_1686_s11_q;
      select_1687_s12_q <= select_1687_s11_q;
      and_1688_s12_q <= and_1688_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  logic alarm_q;

  // Memory objects, write
  logic [4:0] objects_waddr;
  assign objects_waddr = label_s12_q;
  logic objects_we;
  assign objects_we = s12_en & and_362_s12_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (objects_we) objects_mem[objects_waddr] <= {select_359_s12_q, select_353_s12_q, select_346_s12_q, select_342_s12_q, select_338_s12_q, select_334_s12_q, select_330_s12_q};
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
      alarm_q <= and_1677_s12_q | (alarm_q & not_264_s12_q);
    end
  end

  logic or_1666_s13_q;
  logic and_1680_s13_q;
  logic [20:0] select_1681_s13_q;
  logic [10:0] select_1682_s13_q;
  logic [10:0] select_1683_s13_q;
  logic [10:0] select_1684_s13_q;
  logic [10:0] select_1685_s13_q;
  logic [31:0] select_1686_s13_q;
  logic [31:0] select_1687_s13_q;
  logic and_1688_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
      or_1666_s13_q <= or_1666_s12_q;
      and_1680_s13_q <= and_1680_s12_q;
      select_1681_s13_q <= select_1681_s12_q;
      select_1682_s13_q <= select_1682_s12_q;
      select_1683_s13_q <= select_1683_s12_q;
      select_1684_s13_q <= select_1684_s12_q;
      select_1685_s13_q <= select_1685_s12_q;
      select_1686_s13_q <= select_1686_s12_q;
      select_1687_s13_q <= select_1687_s12_q;
      and_1688_s13_q <= and_1688_s12_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign ended_o = and_1680_s13_q;
  assign object_pixels_o = select_1681_s13_q;
  assign object_left_o = select_1682_s13_q;
  assign object_right_o = select_1683_s13_q;
  assign object_top_o = select_1684_s13_q;
  assign object_bottom_o = select_1685_s13_q;
  assign object_columns_o = select_1686_s13_q;
  assign object_rows_o = select_1687_s13_q;
  assign alarm_o = alarm_q;
  assign overflow_o = or_1666_s13_q;
  assign done_o = and_1688_s13_q;
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
  assign unused_bits = ^product_348[0];

endmodule
