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
  logic equal_51;
  assign equal_51 = cfg_still_limit_i == 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [8:0] index_q;
  logic [4:0] place_q;
  // hls/stages/still.hpp:46
  logic and_17;
  assign and_17 = (place_q == 5'h10) & (~first_i);

  // Memory kept, 512 x 32, DISTANCE 17, hls/stages/still.hpp:107; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
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
  assign kept_re = s0_en & and_17;
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
      index_q <= first_i ? 9'h0 : (index_q + {8'h0, and_17});
      place_q <= (first_i | and_17) ? 5'h0 : (place_q + 5'h1);
    end
  end

  logic [7:0] left_s1_q;
  logic [7:0] right_s1_q;
  logic first_s1_q;
  logic [8:0] index_s1_q;
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

  logic [7:0] left_s2_q;
  logic [7:0] right_s2_q;
  logic first_s2_q;
  logic [8:0] index_s2_q;
  logic and_17_s2_q;
  logic [31:0] kept_rdata_s2_q;
  logic and_93_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      left_s2_q <= left_s1_q;
      right_s2_q <= right_s1_q;
      first_s2_q <= first_s1_q;
      index_s2_q <= index_s1_q;
      and_17_s2_q <= and_17_s1_q;
      kept_rdata_s2_q <= kept_rdata_q;
      and_93_s2_q <= (~equal_51) & (~(index_q[8:4] == 5'h0));
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/still.hpp:50
  logic [7:0] select_27;
  assign select_27 = and_17_s2_q ? kept_rdata_s2_q[7:0] : 8'h0;
  // hls/stages/still.hpp:78
  logic [8:0] difference_28;
  assign difference_28 = {1'b0, left_s2_q} - {1'b0, select_27};
  // hls/stages/still.hpp:50
  logic [7:0] select_40;
  assign select_40 = and_17_s2_q ? kept_rdata_s2_q[23:16] : 8'h0;
  // hls/stages/still.hpp:78
  logic [8:0] difference_41;
  assign difference_41 = {1'b0, left_s2_q} - {1'b0, select_40};
  // hls/stages/still.hpp:50
  logic [7:0] select_61;
  assign select_61 = and_17_s2_q ? kept_rdata_s2_q[15:8] : 8'h0;
  // hls/stages/still.hpp:78
  logic [8:0] difference_62;
  assign difference_62 = {1'b0, right_s2_q} - {1'b0, select_61};
  // hls/stages/still.hpp:50
  logic [7:0] select_72;
  assign select_72 = and_17_s2_q ? kept_rdata_s2_q[31:24] : 8'h0;
  // hls/stages/still.hpp:78
  logic [8:0] difference_73;
  assign difference_73 = {1'b0, right_s2_q} - {1'b0, select_72};

  // Memory kept, write
  logic [8:0] kept_waddr;
  assign kept_waddr = index_s2_q;
  logic kept_we;
  assign kept_we = s2_en & and_17_s2_q;
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
  logic and_17_s3_q;
  logic [5:0] difference_28_s3_q;
  logic [5:0] difference_41_s3_q;
  logic [5:0] difference_62_s3_q;
  logic [5:0] difference_73_s3_q;
  logic and_93_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s3_q <= first_s2_q;
      and_17_s3_q <= and_17_s2_q;
      difference_28_s3_q <= difference_28[8:3];
      difference_41_s3_q <= difference_41[8:3];
      difference_62_s3_q <= difference_62[8:3];
      difference_73_s3_q <= difference_73[8:3];
      and_93_s3_q <= and_93_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/still.hpp:79
  logic [6:0] sum_29;
  assign sum_29 = {difference_28_s3_q[5], difference_28_s3_q} + 7'h7f;
  logic [6:0] sum_42;
  assign sum_42 = {difference_41_s3_q[5], difference_41_s3_q} + 7'h7f;
  logic [6:0] sum_63;
  assign sum_63 = {difference_62_s3_q[5], difference_62_s3_q} + 7'h1;
  logic [6:0] sum_74;
  assign sum_74 = {difference_73_s3_q[5], difference_73_s3_q} + 7'h7f;

  logic first_s4_q;
  logic and_32_s4_q;
  logic and_45_s4_q;
  logic or_66_s4_q;
  logic and_77_s4_q;
  logic and_93_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      first_s4_q <= first_s3_q;
      and_32_s4_q <= and_17_s3_q & (~(sum_29[6:1] == 6'h3f));
      and_45_s4_q <= and_17_s3_q & (~(sum_42[6:1] == 6'h3f));
      or_66_s4_q <= (sum_63[6:1] == 6'h0) | (~and_17_s3_q);
      and_77_s4_q <= and_17_s3_q & (~(sum_74[6:1] == 6'h3f));
      and_93_s4_q <= and_93_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/still.hpp:86
  logic not_34;
  assign not_34 = ~(left_last_q == 2'h2);
  // hls/stages/still.hpp:53
  logic [1:0] select_38;
  assign select_38 = first_s4_q ? {not_26, 1'b0} : ((and_32_s4_q & not_34) ? (left_last_q + 2'h1) : left_last_q);
  // hls/stages/still.hpp:90
  logic not_39;
  assign not_39 = ~two_before_q;
  // hls/stages/still.hpp:86
  logic equal_46;
  assign equal_46 = left_older_q == 2'h2;
  // hls/stages/still.hpp:53
  logic [1:0] select_49;
  assign select_49 = and_45_s4_q ? (equal_46 ? left_older_q : (left_older_q + 2'h1)) : left_older_q;
  // hls/stages/still.hpp:88
  logic [7:0] select_59;
  assign select_59 = (equal_51 | (~(not_34 | (~equal_46)))) ? 8'h0 : ((left_frames_q == 8'hff) ? 8'hff : (left_frames_q + 8'h1));
  // hls/stages/still.hpp:86
  logic equal_67;
  assign equal_67 = right_last_q == 2'h2;
  // hls/stages/still.hpp:55
  logic [1:0] select_71;
  assign select_71 = first_s4_q ? {not_26, 1'b0} : ((or_66_s4_q | equal_67) ? right_last_q : (right_last_q + 2'h1));
  // hls/stages/still.hpp:86
  logic equal_78;
  assign equal_78 = right_older_q == 2'h2;
  // hls/stages/still.hpp:55
  logic [1:0] select_81;
  assign select_81 = and_77_s4_q ? (equal_78 ? right_older_q : (right_older_q + 2'h1)) : right_older_q;
  // hls/stages/still.hpp:88
  logic [7:0] select_88;
  assign select_88 = (equal_51 | (equal_67 & equal_78)) ? 8'h0 : ((right_frames_q == 8'hff) ? 8'hff : (right_frames_q + 8'h1));

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
    end else if (s4_en) begin
      one_before_q <= first_s4_q | one_before_q;
      two_before_q <= first_s4_q ? one_before_q : two_before_q;
      left_last_q <= select_38;
      left_older_q <= first_s4_q ? {not_39, 1'b0} : select_49;
      left_frames_q <= first_s4_q ? select_59 : left_frames_q;
      right_last_q <= select_71;
      right_older_q <= first_s4_q ? {not_39, 1'b0} : select_81;
      right_frames_q <= first_s4_q ? select_88 : right_frames_q;
    end
  end

  logic and_93_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      and_93_s5_q <= and_93_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------

  logic and_93_s6_q;
  logic equal_94_s6_q;
  logic not_96_s6_q;
  logic not_99_s6_q;
  logic equal_103_s6_q;
  logic not_105_s6_q;
  logic not_108_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      and_93_s6_q <= and_93_s5_q;
      equal_94_s6_q <= left_last_q == 2'h2;
      not_96_s6_q <= ~(left_older_q == 2'h2);
      not_99_s6_q <= ~(({1'b0, left_frames_q} + 9'h1) < {1'b0, cfg_still_limit_i});
      equal_103_s6_q <= right_last_q == 2'h2;
      not_105_s6_q <= ~(right_older_q == 2'h2);
      not_108_s6_q <= ~(({1'b0, right_frames_q} + 9'h1) < {1'b0, cfg_still_limit_i});
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/still.hpp:65
  logic and_102;
  assign and_102 = and_93_s6_q & (equal_94_s6_q ? (not_96_s6_q & not_99_s6_q) : not_99_s6_q);
  logic and_111;
  assign and_111 = and_93_s6_q & (equal_103_s6_q ? (not_105_s6_q & not_108_s6_q) : not_108_s6_q);

  logic and_102_s7_q;
  logic and_111_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      and_102_s7_q <= and_102;
      and_111_s7_q <= and_111;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign left_still_o = and_102_s7_q;
  assign right_still_o = and_111_s7_q;
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
  assign unused_bits = ^{sum_74[0], difference_73[2:0], sum_63[0], difference_62[2:0], sum_42[0], difference_41[2:0], sum_29[0], difference_28[2:0]};

endmodule
