// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Still<horopter::hls::profiles::field>, hls/stages/still.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 39 bits, pipeline 30 bits, memories 8192 bits.
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
  logic equal_51;
  assign equal_51 = cfg_still_limit_i == 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] index_q;
  logic [4:0] place_q;
  // hls/stages/still.hpp:46
  logic and_17;
  assign and_17 = (place_q == 5'h10) & (~first_i);

  // Memory kept, 256 x 32, DISTANCE 17, hls/stages/still.hpp:107; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] kept_mem [0:255];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 256; i++) kept_mem[i] = 32'h0;
`endif
  logic [7:0] kept_raddr;
  assign kept_raddr = index_q;
`ifndef SYNTHESIS
  logic kept_re;
  assign kept_re = s0_en & and_17;
`endif
  logic [31:0] kept_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) kept_rdata_q <= kept_mem[kept_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      index_q <= 8'h0;
      place_q <= 5'h0;
    end else if (s0_en) begin
      index_q <= first_i ? 8'h0 : (index_q + {7'h0, and_17});
      place_q <= (first_i | and_17) ? 5'h0 : (place_q + 5'h1);
    end
  end

  logic [7:0] left_s1_q;
  logic [7:0] right_s1_q;
  logic first_s1_q;
  logic [7:0] index_s1_q;
  logic and_17_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      left_s1_q <= left_i;
      right_s1_q <= right_i;
      first_s1_q <= first_i;
      index_s1_q <= index_q;
      and_17_s1_q <= and_17;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic one_before_q;
  logic two_before_q;
  logic [1:0] left_last_q;
  logic [1:0] left_older_q;
  logic [7:0] left_frames_q;
  logic [1:0] right_last_q;
  logic [1:0] right_older_q;
  logic [7:0] right_frames_q;
  // hls/stages/still.hpp:89
  logic not_26;
  assign not_26 = ~one_before_q;
  // hls/stages/still.hpp:50
  logic [7:0] select_27;
  assign select_27 = and_17_s1_q ? kept_rdata_q[7:0] : 8'h0;
  // hls/stages/still.hpp:78
  logic [8:0] difference_28;
  assign difference_28 = {1'b0, left_s1_q} - {1'b0, select_27};
  // hls/stages/still.hpp:79
  logic [6:0] sum_29;
  assign sum_29 = {difference_28[8], difference_28[8:3]} + 7'h7f;
  // hls/stages/still.hpp:86
  logic not_34;
  assign not_34 = ~(left_last_q == 2'h2);
  // hls/stages/still.hpp:93
  logic [1:0] select_37;
  assign select_37 = ((and_17_s1_q & (~(sum_29[6:1] == 6'h3f))) & not_34) ? (left_last_q + 2'h1) : left_last_q;
  // hls/stages/still.hpp:53
  logic [1:0] select_38;
  assign select_38 = first_s1_q ? {not_26, 1'b0} : select_37;
  // hls/stages/still.hpp:90
  logic not_39;
  assign not_39 = ~two_before_q;
  // hls/stages/still.hpp:50
  logic [7:0] select_40;
  assign select_40 = and_17_s1_q ? kept_rdata_q[23:16] : 8'h0;
  // hls/stages/still.hpp:78
  logic [8:0] difference_41;
  assign difference_41 = {1'b0, left_s1_q} - {1'b0, select_40};
  // hls/stages/still.hpp:79
  logic [6:0] sum_42;
  assign sum_42 = {difference_41[8], difference_41[8:3]} + 7'h7f;
  // hls/stages/still.hpp:86
  logic equal_46;
  assign equal_46 = left_older_q == 2'h2;
  // hls/stages/still.hpp:53
  logic [1:0] select_49;
  assign select_49 = (and_17_s1_q & (~(sum_42[6:1] == 6'h3f))) ? (equal_46 ? left_older_q : (left_older_q + 2'h1)) : left_older_q;
  logic [1:0] select_50;
  assign select_50 = first_s1_q ? {not_39, 1'b0} : select_49;
  // hls/stages/still.hpp:88
  logic [7:0] select_59;
  assign select_59 = (equal_51 | (~(not_34 | (~equal_46)))) ? 8'h0 : ((left_frames_q == 8'hff) ? 8'hff : (left_frames_q + 8'h1));
  // hls/stages/still.hpp:53
  logic [7:0] select_60;
  assign select_60 = first_s1_q ? select_59 : left_frames_q;
  // hls/stages/still.hpp:50
  logic [7:0] select_61;
  assign select_61 = and_17_s1_q ? kept_rdata_q[15:8] : 8'h0;
  // hls/stages/still.hpp:78
  logic [8:0] difference_62;
  assign difference_62 = {1'b0, right_s1_q} - {1'b0, select_61};
  // hls/stages/still.hpp:79
  logic [6:0] sum_63;
  assign sum_63 = {difference_62[8], difference_62[8:3]} + 7'h1;
  // hls/stages/still.hpp:86
  logic equal_67;
  assign equal_67 = right_last_q == 2'h2;
  // hls/stages/still.hpp:93
  logic [1:0] select_70;
  assign select_70 = (((sum_63[6:1] == 6'h0) | (~and_17_s1_q)) | equal_67) ? right_last_q : (right_last_q + 2'h1);
  // hls/stages/still.hpp:55
  logic [1:0] select_71;
  assign select_71 = first_s1_q ? {not_26, 1'b0} : select_70;
  // hls/stages/still.hpp:50
  logic [7:0] select_72;
  assign select_72 = and_17_s1_q ? kept_rdata_q[31:24] : 8'h0;
  // hls/stages/still.hpp:78
  logic [8:0] difference_73;
  assign difference_73 = {1'b0, right_s1_q} - {1'b0, select_72};
  // hls/stages/still.hpp:79
  logic [6:0] sum_74;
  assign sum_74 = {difference_73[8], difference_73[8:3]} + 7'h7f;
  // hls/stages/still.hpp:86
  logic equal_78;
  assign equal_78 = right_older_q == 2'h2;
  // hls/stages/still.hpp:55
  logic [1:0] select_81;
  assign select_81 = (and_17_s1_q & (~(sum_74[6:1] == 6'h3f))) ? (equal_78 ? right_older_q : (right_older_q + 2'h1)) : right_older_q;
  logic [1:0] select_82;
  assign select_82 = first_s1_q ? {not_39, 1'b0} : select_81;
  // hls/stages/still.hpp:88
  logic [7:0] select_88;
  assign select_88 = (equal_51 | (equal_67 & equal_78)) ? 8'h0 : ((right_frames_q == 8'hff) ? 8'hff : (right_frames_q + 8'h1));
  // hls/stages/still.hpp:55
  logic [7:0] select_89;
  assign select_89 = first_s1_q ? select_88 : right_frames_q;
  // hls/stages/still.hpp:62
  logic and_93;
  assign and_93 = (~equal_51) & (~(index_q[7:4] == 4'h0));
  // hls/stages/still.hpp:97
  logic not_99;
  assign not_99 = ~(({1'b0, select_60} + 9'h1) < {1'b0, cfg_still_limit_i});
  // hls/stages/still.hpp:65
  logic and_102;
  assign and_102 = and_93 & ((select_38 == 2'h2) ? ((~(select_50 == 2'h2)) & not_99) : not_99);
  // hls/stages/still.hpp:97
  logic not_108;
  assign not_108 = ~(({1'b0, select_89} + 9'h1) < {1'b0, cfg_still_limit_i});
  logic select_110;
  assign select_110 = (select_71 == 2'h2) ? ((~(select_82 == 2'h2)) & not_108) : not_108;

  // Memory kept, write
  logic [7:0] kept_waddr;
  assign kept_waddr = index_s1_q;
  logic kept_we;
  assign kept_we = s1_en & and_17_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (kept_we) kept_mem[kept_waddr] <= {kept_rdata_q[15:0], right_s1_q, left_s1_q};
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
      one_before_q <= 1'b0;
      two_before_q <= 1'b0;
      left_last_q <= 2'h2;
      left_older_q <= 2'h2;
      left_frames_q <= 8'h0;
      right_last_q <= 2'h2;
      right_older_q <= 2'h2;
      right_frames_q <= 8'h0;
    end else if (s1_en) begin
      one_before_q <= first_s1_q | one_before_q;
      two_before_q <= first_s1_q ? one_before_q : two_before_q;
      left_last_q <= select_38;
      left_older_q <= select_50;
      left_frames_q <= select_60;
      right_last_q <= select_71;
      right_older_q <= select_82;
      right_frames_q <= select_89;
    end
  end

  logic and_102_s2_q;
  logic and_111_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      and_102_s2_q <= and_102;
      and_111_s2_q <= and_93 & select_110;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_still_o = and_102_s2_q;
  assign right_still_o = and_111_s2_q;
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
  assign unused_bits = ^{sum_74[0], difference_73[2:0], sum_63[0], difference_62[2:0], sum_42[0], difference_41[2:0], sum_29[0], difference_28[2:0]};

endmodule
