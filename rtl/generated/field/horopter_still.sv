// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Still<horopter::hls::profiles::field>, hls/stages/still.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 41 bits, pipeline 30 bits, memories 16384 bits.
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Of the configuration alone: not pipelined.
  logic equal_49;
  assign equal_49 = cfg_still_limit_i == 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] index_q;
  logic [4:0] place_q;
  // hls/stages/still.hpp:50
  logic and_16;
  assign and_16 = (place_q == 5'h10) & (~first_i);

  // Memory kept, 256 x 64, DISTANCE 17, hls/stages/still.hpp:115; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [63:0] kept_mem [0:255];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 256; i++) kept_mem[i] = 64'h0;
`endif
  logic [7:0] kept_raddr;
  assign kept_raddr = index_q;
`ifndef SYNTHESIS
  logic kept_re;
  assign kept_re = s0_en & and_16;
`endif
  logic [63:0] kept_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) kept_rdata_q <= kept_mem[kept_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      index_q <= 8'h0;
      place_q <= 5'h0;
    end else if (s0_en) begin
      index_q <= first_i ? 8'h0 : (index_q + {7'h0, and_16});
      place_q <= (first_i | and_16) ? 5'h0 : (place_q + 5'h1);
    end
  end

  logic [7:0] left_s1_q;
  logic [7:0] right_s1_q;
  logic first_s1_q;
  logic [7:0] index_s1_q;
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
  logic [3:0] before_v_q;
  logic [1:0] left_last_q;
  logic [1:0] left_older_q;
  logic [7:0] left_frames_q;
  logic [1:0] right_last_q;
  logic [1:0] right_older_q;
  logic [7:0] right_frames_q;
  // hls/stages/still.hpp:97
  logic not_24;
  assign not_24 = ~before_v_q[1];
  // hls/stages/still.hpp:57
  logic [7:0] select_25;
  assign select_25 = and_16_s1_q ? kept_rdata_q[23:16] : 8'h0;
  // hls/stages/still.hpp:86
  logic [8:0] difference_26;
  assign difference_26 = {1'b0, left_s1_q} - {1'b0, select_25};
  // hls/stages/still.hpp:87
  logic [6:0] sum_27;
  assign sum_27 = {difference_26[8], difference_26[8:3]} + 7'h7f;
  // hls/stages/still.hpp:94
  logic not_32;
  assign not_32 = ~(left_last_q == 2'h2);
  // hls/stages/still.hpp:101
  logic [1:0] select_35;
  assign select_35 = ((and_16_s1_q & (~(sum_27[6:1] == 6'h3f))) & not_32) ? (left_last_q + 2'h1) : left_last_q;
  // hls/stages/still.hpp:63
  logic [1:0] select_36;
  assign select_36 = first_s1_q ? {not_24, 1'b0} : select_35;
  // hls/stages/still.hpp:98
  logic not_37;
  assign not_37 = ~before_v_q[3];
  // hls/stages/still.hpp:57
  logic [7:0] select_38;
  assign select_38 = and_16_s1_q ? kept_rdata_q[55:48] : 8'h0;
  // hls/stages/still.hpp:86
  logic [8:0] difference_39;
  assign difference_39 = {1'b0, left_s1_q} - {1'b0, select_38};
  // hls/stages/still.hpp:87
  logic [6:0] sum_40;
  assign sum_40 = {difference_39[8], difference_39[8:3]} + 7'h7f;
  // hls/stages/still.hpp:94
  logic equal_44;
  assign equal_44 = left_older_q == 2'h2;
  // hls/stages/still.hpp:63
  logic [1:0] select_47;
  assign select_47 = (and_16_s1_q & (~(sum_40[6:1] == 6'h3f))) ? (equal_44 ? left_older_q : (left_older_q + 2'h1)) : left_older_q;
  logic [1:0] select_48;
  assign select_48 = first_s1_q ? {not_37, 1'b0} : select_47;
  // hls/stages/still.hpp:96
  logic [7:0] select_57;
  assign select_57 = (equal_49 | (~(not_32 | (~equal_44)))) ? 8'h0 : ((left_frames_q == 8'hff) ? 8'hff : (left_frames_q + 8'h1));
  // hls/stages/still.hpp:63
  logic [7:0] select_58;
  assign select_58 = first_s1_q ? select_57 : left_frames_q;
  // hls/stages/still.hpp:57
  logic [7:0] select_59;
  assign select_59 = and_16_s1_q ? kept_rdata_q[31:24] : 8'h0;
  // hls/stages/still.hpp:86
  logic [8:0] difference_60;
  assign difference_60 = {1'b0, right_s1_q} - {1'b0, select_59};
  // hls/stages/still.hpp:87
  logic [6:0] sum_61;
  assign sum_61 = {difference_60[8], difference_60[8:3]} + 7'h1;
  // hls/stages/still.hpp:94
  logic equal_65;
  assign equal_65 = right_last_q == 2'h2;
  // hls/stages/still.hpp:101
  logic [1:0] select_68;
  assign select_68 = (((sum_61[6:1] == 6'h0) | (~and_16_s1_q)) | equal_65) ? right_last_q : (right_last_q + 2'h1);
  // hls/stages/still.hpp:65
  logic [1:0] select_69;
  assign select_69 = first_s1_q ? {not_24, 1'b0} : select_68;
  // hls/stages/still.hpp:57
  logic [7:0] select_70;
  assign select_70 = and_16_s1_q ? kept_rdata_q[63:56] : 8'h0;
  // hls/stages/still.hpp:86
  logic [8:0] difference_71;
  assign difference_71 = {1'b0, right_s1_q} - {1'b0, select_70};
  // hls/stages/still.hpp:87
  logic [6:0] sum_72;
  assign sum_72 = {difference_71[8], difference_71[8:3]} + 7'h7f;
  // hls/stages/still.hpp:94
  logic equal_76;
  assign equal_76 = right_older_q == 2'h2;
  // hls/stages/still.hpp:65
  logic [1:0] select_79;
  assign select_79 = (and_16_s1_q & (~(sum_72[6:1] == 6'h3f))) ? (equal_76 ? right_older_q : (right_older_q + 2'h1)) : right_older_q;
  logic [1:0] select_80;
  assign select_80 = first_s1_q ? {not_37, 1'b0} : select_79;
  // hls/stages/still.hpp:96
  logic [7:0] select_86;
  assign select_86 = (equal_49 | (equal_65 & equal_76)) ? 8'h0 : ((right_frames_q == 8'hff) ? 8'hff : (right_frames_q + 8'h1));
  // hls/stages/still.hpp:65
  logic [7:0] select_87;
  assign select_87 = first_s1_q ? select_86 : right_frames_q;
  // hls/stages/still.hpp:69
  logic and_91;
  assign and_91 = (~equal_49) & (~(index_q[7:4] == 4'h0));
  // hls/stages/still.hpp:105
  logic not_97;
  assign not_97 = ~(({1'b0, select_58} + 9'h1) < {1'b0, cfg_still_limit_i});
  // hls/stages/still.hpp:72
  logic and_100;
  assign and_100 = and_91 & ((select_36 == 2'h2) ? ((~(select_48 == 2'h2)) & not_97) : not_97);
  // hls/stages/still.hpp:105
  logic not_106;
  assign not_106 = ~(({1'b0, select_87} + 9'h1) < {1'b0, cfg_still_limit_i});
  logic select_108;
  assign select_108 = (select_69 == 2'h2) ? ((~(select_80 == 2'h2)) & not_106) : not_106;

  // Memory kept, write
  logic [7:0] kept_waddr;
  assign kept_waddr = index_s1_q;
  logic kept_we;
  assign kept_we = s1_en & and_16_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (kept_we) kept_mem[kept_waddr] <= {kept_rdata_q[47:0], right_s1_q, left_s1_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && kept_we) begin
      if (kept_re && kept_raddr == kept_waddr) begin
        $error("kept: address %0d is read less than DISTANCE steps after its write", kept_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      before_v_q <= 4'h0;
      left_last_q <= 2'h2;
      left_older_q <= 2'h2;
      left_frames_q <= 8'h0;
      right_last_q <= 2'h2;
      right_older_q <= 2'h2;
      right_frames_q <= 8'h0;
    end else if (s1_en) begin
      before_v_q <= first_s1_q ? {before_v_q[2:0], 1'b1} : before_v_q;
      left_last_q <= select_36;
      left_older_q <= select_48;
      left_frames_q <= select_58;
      right_last_q <= select_69;
      right_older_q <= select_80;
      right_frames_q <= select_87;
    end
  end

  logic and_100_s2_q;
  logic and_109_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      and_100_s2_q <= and_100;
      and_109_s2_q <= and_91 & select_108;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_still_o = and_100_s2_q;
  assign right_still_o = and_109_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_72[0], difference_71[2:0], sum_61[0], difference_60[2:0], sum_40[0], difference_39[2:0], sum_27[0], difference_26[2:0]};

endmodule
