// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::hd>, hls/stages/health.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 166 bits, pipeline 219 bits, memories 1024 bits.
module horopter_health (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_i,
  input  logic first_i,
  input  logic end_v_i,
  input  logic last_i,
  input  logic [7:0] cfg_dark_level_i,
  input  logic [7:0] cfg_bright_level_i,
  input  logic [20:0] cfg_dark_limit_i,
  input  logic [20:0] cfg_bright_limit_i,
  input  logic [7:0] cfg_contrast_limit_i,
  input  logic [7:0] cfg_frozen_limit_i,
  output logic valid_o,
  output logic black_o,
  output logic white_o,
  output logic constant_o,
  output logic frozen_o,
  output logic torn_o,
  output logic [31:0] signature_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] x_q;
  logic [1:0] rows_q;
  // hls/stages/health.hpp:97
  logic [10:0] x;
  assign x = first_i ? 11'h0 : x_q;
  // hls/stages/health.hpp:119
  logic equal_23;
  assign equal_23 = x[4:0] == 5'h1f;
  // hls/stages/health.hpp:98
  logic [1:0] rows;
  assign rows = first_i ? 2'h0 : rows_q;

  // Memory above, 64 x 16, DISTANCE 16, hls/stages/health.hpp:131; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [15:0] above_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) above_mem[i] = 16'h0;
`endif
  logic [5:0] above_raddr;
  assign above_raddr = x[10:5];
  logic above_re;
  assign above_re = s0_en & equal_23;
  logic [15:0] above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (above_re) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 11'h0;
      rows_q <= 2'h0;
    end else if (s0_en) begin
      x_q <= last_i ? 11'h0 : (x + 11'h1);
      rows_q <= (last_i & (~rows[1])) ? (rows + 2'h1) : rows;
    end
  end

  logic [7:0] pixel_s1_q;
  logic first_s1_q;
  logic end_v_s1_q;
  logic [5:0] x_s1_q;
  logic equal_23_s1_q;
  logic rows_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_s1_q <= pixel_i;
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      x_s1_q <= x[10:5];
      equal_23_s1_q <= equal_23;
      rows_s1_q <= rows[1];
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [7:0] pixel_s2_q;
  logic first_s2_q;
  logic end_v_s2_q;
  logic [5:0] x_s2_q;
  logic equal_23_s2_q;
  logic [15:0] above_rdata_s2_q;
  logic rows_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_s2_q <= pixel_s1_q;
      first_s2_q <= first_s1_q;
      end_v_s2_q <= end_v_s1_q;
      x_s2_q <= x_s1_q;
      equal_23_s2_q <= equal_23_s1_q;
      above_rdata_s2_q <= above_rdata_q;
      rows_s2_q <= rows_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/health.hpp:106
  logic [8:0] difference_59;
  assign difference_59 = {1'b0, pixel_s2_q} - {1'b0, above_rdata_s2_q[15:8]};
  // hls/stages/health.hpp:105
  logic [8:0] difference_63;
  assign difference_63 = {1'b0, pixel_s2_q} - {1'b0, above_rdata_s2_q[7:0]};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = x_s2_q;
  logic above_we;
  assign above_we = s2_en & equal_23_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= {above_rdata_s2_q[7:0], pixel_s2_q};
  end
`ifndef SYNTHESIS
  logic [5:0] above_raddr_s1_sim;
  logic above_re_s1_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      above_re_s1_sim <= 1'b0;
    end else if (en_i) begin
      above_re_s1_sim <= above_re;
      above_raddr_s1_sim <= above_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && above_we) begin
      if (above_re && above_raddr == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
      if (above_re_s1_sim && above_raddr_s1_sim == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
    end
  end
`endif

  logic [7:0] pixel_s3_q;
  logic first_s3_q;
  logic end_v_s3_q;
  logic equal_23_s3_q;
  logic rows_s3_q;
  logic difference_59_s3_q;
  logic [7:0] xor_60_s3_q;
  logic difference_63_s3_q;
  logic [7:0] xor_64_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_s3_q <= pixel_s2_q;
      first_s3_q <= first_s2_q;
      end_v_s3_q <= end_v_s2_q;
      equal_23_s3_q <= equal_23_s2_q;
      rows_s3_q <= rows_s2_q;
      difference_59_s3_q <= difference_59[8];
      xor_60_s3_q <= difference_59[7:0] ^ {8{difference_59[8]}};
      difference_63_s3_q <= difference_63[8];
      xor_64_s3_q <= difference_63[7:0] ^ {8{difference_63[8]}};
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [31:0] signature_q;
  logic [7:0] darkest_q;
  logic [7:0] brightest_q;
  logic [20:0] dark_q;
  logic [20:0] bright_q;
  // hls/stages/health.hpp:63
  logic [31:0] select_25;
  assign select_25 = first_s3_q ? 32'h0 : signature_q;
  logic [12:0] xor_26;
  assign xor_26 = {13{select_25[0]}} ^ {select_25[31:30], select_25[28:27], select_25[25:24], select_25[22:20], select_25[16], select_25[10:9], select_25[6]};
  logic [7:0] xor_27;
  assign xor_27 = pixel_s3_q ^ {select_25[8:7], xor_26[0], select_25[5:1]};
  logic parity_28;
  assign parity_28 = ^{select_25[6], select_25[0], pixel_s3_q[5]};
  // hls/stages/health.hpp:65
  logic [7:0] select_40;
  assign select_40 = first_s3_q ? pixel_s3_q : ((pixel_s3_q < darkest_q) ? pixel_s3_q : darkest_q);
  // hls/stages/health.hpp:66
  logic [7:0] select_43;
  assign select_43 = first_s3_q ? pixel_s3_q : ((brightest_q < pixel_s3_q) ? pixel_s3_q : brightest_q);
  logic not_45;
  assign not_45 = ~(cfg_dark_level_i < pixel_s3_q);
  // hls/stages/health.hpp:67
  logic not_49;
  assign not_49 = ~(pixel_s3_q < cfg_bright_level_i);
  // hls/stages/health.hpp:106
  logic [8:0] to_two;
  assign to_two = {8'h0, difference_59_s3_q} + {1'b0, xor_60_s3_q};
  // hls/stages/health.hpp:105
  logic [8:0] to_one;
  assign to_one = {8'h0, difference_63_s3_q} + {1'b0, xor_64_s3_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      signature_q <= 32'h0;
      darkest_q <= 8'h0;
      brightest_q <= 8'h0;
      dark_q <= 21'h0;
      bright_q <= 21'h0;
    end else if (s3_en) begin
      signature_q <= {select_25[0], xor_26[12:11], select_25[29], xor_26[10:9], select_25[26], xor_26[8:7], select_25[23], xor_26[6:4], select_25[19:17], xor_26[3], select_25[15:11], xor_26[2:1], xor_27[7:6], parity_28, xor_27[4:0]};
      darkest_q <= select_40;
      brightest_q <= select_43;
      dark_q <= {20'h0, not_45} + (first_s3_q ? 21'h0 : dark_q);
      bright_q <= {20'h0, not_49} + (first_s3_q ? 21'h0 : bright_q);
    end
  end

  logic first_s4_q;
  logic end_v_s4_q;
  logic equal_23_s4_q;
  logic rows_s4_q;
  logic [8:0] to_two_s4_q;
  logic [8:0] sum_62_s4_q;
  logic [8:0] to_one_s4_q;
  logic [8:0] sum_68_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      first_s4_q <= first_s3_q;
      end_v_s4_q <= end_v_s3_q;
      equal_23_s4_q <= equal_23_s3_q;
      rows_s4_q <= rows_s3_q;
      to_two_s4_q <= to_two;
      sum_62_s4_q <= to_two + 9'h1;
      to_one_s4_q <= to_one;
      sum_68_s4_q <= to_one + 9'h1;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [31:0] previous_signature_q;
  // hls/stages/health.hpp:107
  logic change;
  assign change = rows_s4_q & (sum_62_s4_q < to_one_s4_q);
  // hls/stages/health.hpp:108
  logic less_69;
  assign less_69 = sum_68_s4_q < to_two_s4_q;
  logic or_70;
  assign or_70 = change | less_69;
  // hls/stages/health.hpp:77
  logic less_75;
  assign less_75 = cfg_dark_limit_i < dark_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      previous_signature_q <= 32'h0;
    end else if (s4_en) begin
      previous_signature_q <= end_v_s4_q ? signature_q : previous_signature_q;
    end
  end

  logic first_s5_q;
  logic end_v_s5_q;
  logic equal_23_s5_q;
  logic equal_31_s5_q;
  logic [1:0] select_71_s5_q;
  logic less_75_s5_q;
  logic less_76_s5_q;
  logic or_79_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      first_s5_q <= first_s4_q;
      end_v_s5_q <= end_v_s4_q;
      equal_23_s5_q <= equal_23_s4_q;
      equal_31_s5_q <= previous_signature_q == signature_q;
      select_71_s5_q <= rows_s4_q ? {less_69, or_70} : {1'b0, change};
      less_75_s5_q <= less_75;
      less_76_s5_q <= cfg_bright_limit_i < bright_q;
      or_79_s5_q <= less_75 | (cfg_contrast_limit_i < (brightest_q - darkest_q));
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic has_previous_q;
  logic [7:0] repeats_q;
  logic [21:0] torn_q;
  // hls/stages/health.hpp:74
  logic [7:0] select_35;
  assign select_35 = equal_31_s5_q ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  logic [7:0] select_36;
  assign select_36 = has_previous_q ? select_35 : 8'h0;
  // hls/stages/health.hpp:68
  logic [1:0] change_2;
  assign change_2 = equal_23_s5_q ? select_71_s5_q : 2'h0;
  // hls/stages/health.hpp:110
  logic [21:0] sum_74;
  assign sum_74 = {{17{change_2[1]}}, 1'b0, {4{change_2[0]}}} + (first_s5_q ? 22'h0 : torn_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      has_previous_q <= 1'b0;
      repeats_q <= 8'h0;
      torn_q <= 22'h0;
    end else if (s5_en) begin
      has_previous_q <= end_v_s5_q | has_previous_q;
      repeats_q <= end_v_s5_q ? select_36 : repeats_q;
      torn_q <= sum_74;
    end
  end

  logic end_v_s6_q;
  logic [31:0] select_29_s6_q;
  logic [7:0] select_36_s6_q;
  logic less_75_s6_q;
  logic less_76_s6_q;
  logic not_81_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      end_v_s6_q <= end_v_s5_q;
      select_29_s6_q <= previous_signature_q;
      select_36_s6_q <= select_36;
      less_75_s6_q <= less_75_s5_q;
      less_76_s6_q <= less_76_s5_q;
      not_81_s6_q <= ~(less_76_s5_q | or_79_s5_q);
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/health.hpp:80
  logic less_83;
  assign less_83 = (cfg_frozen_limit_i + 8'hff) < select_36_s6_q;
  // hls/stages/health.hpp:81
  logic less_84;
  assign less_84 = $signed(22'h300) < $signed(torn_q);
  // hls/stages/health.hpp:84
  logic [4:0] select_85;
  assign select_85 = end_v_s6_q ? {less_84, less_83, not_81_s6_q, less_76_s6_q, less_75_s6_q} : 5'h0;

  logic [31:0] select_29_s7_q;
  logic [4:0] select_85_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      select_29_s7_q <= select_29_s6_q;
      select_85_s7_q <= select_85;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_85_s7_q[0];
  assign white_o = select_85_s7_q[1];
  assign constant_o = select_85_s7_q[2];
  assign frozen_o = select_85_s7_q[3];
  assign torn_o = select_85_s7_q[4];
  assign signature_o = select_29_s7_q;
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
      valid_s7_q <= valid_s6_q & end_v_s6_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^xor_27[5];

endmodule
