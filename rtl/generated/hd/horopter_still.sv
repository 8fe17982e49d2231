// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Still<horopter::hls::profiles::hd>, hls/stages/still.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 40 bits, pipeline 137 bits, memories 16384 bits.
module horopter_still (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] left_i,
  input  logic [7:0] right_i,
  input  logic first_i,
  input  logic [7:0] cfg_still_limit_i,
  output logic valid_o,
  output logic left_still_o,
  output logic right_still_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q;
  logic s0_en, s2_en, s4_en, s6_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s4_en = en_i & valid_s4_q;
  assign s6_en = en_i & valid_s6_q;

  // Of the configuration alone: not pipelined.
  logic equal_49;
  assign equal_49 = cfg_still_limit_i == 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [8:0] index_q;
  logic [4:0] place_q;
  // hls/stages/still.hpp:50
  logic and_16;
  assign and_16 = (place_q == 5'h10) & (~first_i);

  // Memory kept, 512 x 32, DISTANCE 17, hls/stages/still.hpp:115; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] kept_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) kept_mem[i] = 32'h0;
`endif
  logic [8:0] kept_raddr;
  assign kept_raddr = index_q;
`ifndef SYNTHESIS
  logic kept_re;
  assign kept_re = s0_en & and_16;
`endif
  logic [31:0] kept_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) kept_rdata_q <= kept_mem[kept_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      index_q <= 9'h0;
      place_q <= 5'h0;
    end else if (s0_en) begin
      index_q <= first_i ? 9'h0 : (index_q + {8'h0, and_16});
      place_q <= (first_i | and_16) ? 5'h0 : (place_q + 5'h1);
    end
  end

  logic [7:0] left_s1_q;
  logic [7:0] right_s1_q;
  logic first_s1_q;
  logic [8:0] index_s1_q;
  logic and_16_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      left_s1_q <= left_i;
      right_s1_q <= right_i;
      first_s1_q <= first_i;
      index_s1_q <= index_q;
      and_16_s1_q <= and_16;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [7:0] left_s2_q;
  logic [7:0] right_s2_q;
  logic first_s2_q;
  logic [8:0] index_s2_q;
  logic and_16_s2_q;
  logic [31:0] kept_rdata_s2_q;
  logic and_91_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      left_s2_q <= left_s1_q;
      right_s2_q <= right_s1_q;
      first_s2_q <= first_s1_q;
      index_s2_q <= index_s1_q;
      and_16_s2_q <= and_16_s1_q;
      kept_rdata_s2_q <= kept_rdata_q;
      and_91_s2_q <= (~equal_49) & (~(index_q[8:4] == 5'h0));
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/still.hpp:57
  logic [7:0] select_25;
  assign select_25 = and_16_s2_q ? kept_rdata_s2_q[7:0] : 8'h0;
  // hls/stages/still.hpp:86
  logic [8:0] difference_26;
  assign difference_26 = {1'b0, left_s2_q} - {1'b0, select_25};
  // hls/stages/still.hpp:57
  logic [7:0] select_38;
  assign select_38 = and_16_s2_q ? kept_rdata_s2_q[23:16] : 8'h0;
  // hls/stages/still.hpp:86
  logic [8:0] difference_39;
  assign difference_39 = {1'b0, left_s2_q} - {1'b0, select_38};
  // hls/stages/still.hpp:57
  logic [7:0] select_59;
  assign select_59 = and_16_s2_q ? kept_rdata_s2_q[15:8] : 8'h0;
  // hls/stages/still.hpp:86
  logic [8:0] difference_60;
  assign difference_60 = {1'b0, right_s2_q} - {1'b0, select_59};
  // hls/stages/still.hpp:57
  logic [7:0] select_70;
  assign select_70 = and_16_s2_q ? kept_rdata_s2_q[31:24] : 8'h0;
  // hls/stages/still.hpp:86
  logic [8:0] difference_71;
  assign difference_71 = {1'b0, right_s2_q} - {1'b0, select_70};

  // Memory kept, write
  logic [8:0] kept_waddr;
  assign kept_waddr = index_s2_q;
  logic kept_we;
  assign kept_we = s2_en & and_16_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (kept_we) kept_mem[kept_waddr] <= {kept_rdata_s2_q[15:0], right_s2_q, left_s2_q};
  end
`ifndef SYNTHESIS
  logic [8:0] kept_raddr_s1_sim;
  logic kept_re_s1_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      kept_re_s1_sim <= 1'b0;
    end else if (en_i) begin
      kept_re_s1_sim <= kept_re;
      kept_raddr_s1_sim <= kept_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && kept_we) begin
      if (kept_re && kept_raddr == kept_waddr) begin
        $error("kept: address %0d is read less than DISTANCE steps after its write", kept_waddr);
      end
      if (kept_re_s1_sim && kept_raddr_s1_sim == kept_waddr) begin
        $error("kept: address %0d is read less than DISTANCE steps after its write", kept_waddr);
      end
    end
  end
`endif

  logic first_s3_q;
  logic and_16_s3_q;
  logic [5:0] difference_26_s3_q;
  logic [5:0] difference_39_s3_q;
  logic [5:0] difference_60_s3_q;
  logic [5:0] difference_71_s3_q;
  logic and_91_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s3_q <= first_s2_q;
      and_16_s3_q <= and_16_s2_q;
      difference_26_s3_q <= difference_26[8:3];
      difference_39_s3_q <= difference_39[8:3];
      difference_60_s3_q <= difference_60[8:3];
      difference_71_s3_q <= difference_71[8:3];
      and_91_s3_q <= and_91_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/still.hpp:87
  logic [6:0] sum_27;
  assign sum_27 = {difference_26_s3_q[5], difference_26_s3_q} + 7'h7f;
  logic [6:0] sum_40;
  assign sum_40 = {difference_39_s3_q[5], difference_39_s3_q} + 7'h7f;
  logic [6:0] sum_61;
  assign sum_61 = {difference_60_s3_q[5], difference_60_s3_q} + 7'h1;
  logic [6:0] sum_72;
  assign sum_72 = {difference_71_s3_q[5], difference_71_s3_q} + 7'h7f;

  logic first_s4_q;
  logic and_30_s4_q;
  logic and_43_s4_q;
  logic or_64_s4_q;
  logic and_75_s4_q;
  logic and_91_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s4_q <= first_s3_q;
      and_30_s4_q <= and_16_s3_q & (~(sum_27[6:1] == 6'h3f));
      and_43_s4_q <= and_16_s3_q & (~(sum_40[6:1] == 6'h3f));
      or_64_s4_q <= (sum_61[6:1] == 6'h0) | (~and_16_s3_q);
      and_75_s4_q <= and_16_s3_q & (~(sum_72[6:1] == 6'h3f));
      and_91_s4_q <= and_91_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [1:0] before_v_q;
  logic [1:0] left_last_q;
  logic [1:0] left_older_q;
  logic [7:0] left_frames_q;
  logic [1:0] right_last_q;
  logic [1:0] right_older_q;
  logic [7:0] right_frames_q;
  // hls/stages/still.hpp:97
  logic not_24;
  assign not_24 = ~before_v_q[0];
  // hls/stages/still.hpp:94
  logic not_32;
  assign not_32 = ~(left_last_q == 2'h2);
  // hls/stages/still.hpp:63
  logic [1:0] select_36;
  assign select_36 = first_s4_q ? {not_24, 1'b0} : ((and_30_s4_q & not_32) ? (left_last_q + 2'h1) : left_last_q);
  // hls/stages/still.hpp:98
  logic not_37;
  assign not_37 = ~before_v_q[1];
  // hls/stages/still.hpp:94
  logic equal_44;
  assign equal_44 = left_older_q == 2'h2;
  // hls/stages/still.hpp:63
  logic [1:0] select_47;
  assign select_47 = and_43_s4_q ? (equal_44 ? left_older_q : (left_older_q + 2'h1)) : left_older_q;
  // hls/stages/still.hpp:96
  logic [7:0] select_57;
  assign select_57 = (equal_49 | (~(not_32 | (~equal_44)))) ? 8'h0 : ((left_frames_q == 8'hff) ? 8'hff : (left_frames_q + 8'h1));
  // hls/stages/still.hpp:94
  logic equal_65;
  assign equal_65 = right_last_q == 2'h2;
  // hls/stages/still.hpp:65
  logic [1:0] select_69;
  assign select_69 = first_s4_q ? {not_24, 1'b0} : ((or_64_s4_q | equal_65) ? right_last_q : (right_last_q + 2'h1));
  // hls/stages/still.hpp:94
  logic equal_76;
  assign equal_76 = right_older_q == 2'h2;
  // hls/stages/still.hpp:65
  logic [1:0] select_79;
  assign select_79 = and_75_s4_q ? (equal_76 ? right_older_q : (right_older_q + 2'h1)) : right_older_q;
  // hls/stages/still.hpp:96
  logic [7:0] select_86;
  assign select_86 = (equal_49 | (equal_65 & equal_76)) ? 8'h0 : ((right_frames_q == 8'hff) ? 8'hff : (right_frames_q + 8'h1));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_v_q <= 2'h0;
      left_last_q <= 2'h2;
      left_older_q <= 2'h2;
      left_frames_q <= 8'h0;
      right_last_q <= 2'h2;
      right_older_q <= 2'h2;
      right_frames_q <= 8'h0;
    end else if (s4_en) begin
      before_v_q <= first_s4_q ? {before_v_q[0], 1'b1} : before_v_q;
      left_last_q <= select_36;
      left_older_q <= first_s4_q ? {not_37, 1'b0} : select_47;
      left_frames_q <= first_s4_q ? select_57 : left_frames_q;
      right_last_q <= select_69;
      right_older_q <= first_s4_q ? {not_37, 1'b0} : select_79;
      right_frames_q <= first_s4_q ? select_86 : right_frames_q;
    end
  end

  logic and_91_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      and_91_s5_q <= and_91_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------

  logic and_91_s6_q;
  logic equal_92_s6_q;
  logic not_94_s6_q;
  logic not_97_s6_q;
  logic equal_101_s6_q;
  logic not_103_s6_q;
  logic not_106_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      and_91_s6_q <= and_91_s5_q;
      equal_92_s6_q <= left_last_q == 2'h2;
      not_94_s6_q <= ~(left_older_q == 2'h2);
      not_97_s6_q <= ~(({1'b0, left_frames_q} + 9'h1) < {1'b0, cfg_still_limit_i});
      equal_101_s6_q <= right_last_q == 2'h2;
      not_103_s6_q <= ~(right_older_q == 2'h2);
      not_106_s6_q <= ~(({1'b0, right_frames_q} + 9'h1) < {1'b0, cfg_still_limit_i});
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/still.hpp:72
  logic and_100;
  assign and_100 = and_91_s6_q & (equal_92_s6_q ? (not_94_s6_q & not_97_s6_q) : not_97_s6_q);
  logic and_109;
  assign and_109 = and_91_s6_q & (equal_101_s6_q ? (not_103_s6_q & not_106_s6_q) : not_106_s6_q);

  logic and_100_s7_q;
  logic and_109_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      and_100_s7_q <= and_100;
      and_109_s7_q <= and_109;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_still_o = and_100_s7_q;
  assign right_still_o = and_109_s7_q;
  assign valid_o = valid_s7_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
      valid_s7_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_72[0], difference_71[2:0], sum_61[0], difference_60[2:0], sum_40[0], difference_39[2:0], sum_27[0], difference_26[2:0]};

endmodule
