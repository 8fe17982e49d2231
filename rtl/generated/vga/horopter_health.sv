// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::vga>, hls/stages/health.hpp. Do not edit.
//
// Latency 3 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 177 bits, pipeline 21 bits, memories 1024 bits.
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
  input  logic [18:0] cfg_dark_limit_i,
  input  logic [18:0] cfg_bright_limit_i,
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
  logic valid_s1_q, valid_s2_q, valid_s3_q;
  logic s0_en, s1_en, s2_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_one_q;
  logic [7:0] left_two_q;
  logic [9:0] x_q;
  logic [1:0] rows_q;
  // hls/stages/health.hpp:100
  logic [9:0] x;
  assign x = first_i ? 10'h0 : x_q;
  // hls/stages/health.hpp:105
  logic equal_25;
  assign equal_25 = x[3:0] == 4'hf;
  // hls/stages/health.hpp:101
  logic [1:0] rows;
  assign rows = first_i ? 2'h0 : rows_q;
  // hls/stages/health.hpp:96
  logic [8:0] difference_76;
  assign difference_76 = {1'b0, pixel_i} - {1'b0, left_one_q};
  logic [7:0] xor_77;
  assign xor_77 = difference_76[7:0] ^ {8{difference_76[8]}};
  logic [8:0] sum_78;
  assign sum_78 = {8'h0, difference_76[8]} + {1'b0, xor_77};
  logic [8:0] difference_80;
  assign difference_80 = {1'b0, pixel_i} - {1'b0, left_two_q};
  logic [7:0] xor_81;
  assign xor_81 = difference_80[7:0] ^ {8{difference_80[8]}};
  logic [8:0] sum_82;
  assign sum_82 = {8'h0, difference_80[8]} + {1'b0, xor_81};
  // hls/stages/health.hpp:68
  logic along;
  assign along = rows[1] & ((sum_78 + 9'h1) < sum_82);
  // hls/stages/health.hpp:96
  logic less_86;
  assign less_86 = (sum_82 + 9'h1) < sum_78;
  // hls/stages/health.hpp:111
  logic or_87;
  assign or_87 = along | less_86;
  // hls/stages/health.hpp:68
  logic [1:0] along_2;
  assign along_2 = equal_25 ? (rows[1] ? {less_86, or_87} : {1'b0, along}) : 2'h0;

  // Memory above, 64 x 16, DISTANCE 16, hls/stages/health.hpp:127; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [15:0] above_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) above_mem[i] = 16'h0;
`endif
  logic [5:0] above_raddr;
  assign above_raddr = x[9:4];
  logic above_re;
  assign above_re = s0_en & equal_25;
  logic [15:0] above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (above_re) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_one_q <= 8'h0;
      left_two_q <= 8'h0;
      x_q <= 10'h0;
      rows_q <= 2'h0;
    end else if (s0_en) begin
      left_one_q <= pixel_i;
      left_two_q <= left_one_q;
      x_q <= last_i ? 10'h0 : (x + 10'h1);
      rows_q <= (last_i & (~rows[1])) ? (rows + 2'h1) : rows;
    end
  end

  logic first_s1_q;
  logic end_v_s1_q;
  logic [5:0] x_s1_q;
  logic equal_25_s1_q;
  logic rows_s1_q;
  logic [1:0] along_2_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      first_s1_q <= first_i;
      end_v_s1_q <= end_v_i;
      x_s1_q <= x[9:4];
      equal_25_s1_q <= equal_25;
      rows_s1_q <= rows[1];
      along_2_s1_q <= along_2;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [31:0] signature_q;
  logic [7:0] darkest_q;
  logic [7:0] brightest_q;
  logic [18:0] dark_q;
  logic [18:0] bright_q;
  logic [21:0] torn_q;
  // hls/stages/health.hpp:63
  logic [31:0] select_27;
  assign select_27 = first_s1_q ? 32'h0 : signature_q;
  logic [12:0] xor_28;
  assign xor_28 = {13{select_27[0]}} ^ {select_27[31:30], select_27[28:27], select_27[25:24], select_27[22:20], select_27[16], select_27[10:9], select_27[6]};
  logic [7:0] xor_29;
  assign xor_29 = left_one_q ^ {select_27[8:7], xor_28[0], select_27[5:1]};
  logic parity_30;
  assign parity_30 = ^{select_27[6], select_27[0], left_one_q[5]};
  // hls/stages/health.hpp:65
  logic [7:0] select_42;
  assign select_42 = first_s1_q ? left_one_q : ((left_one_q < darkest_q) ? left_one_q : darkest_q);
  // hls/stages/health.hpp:66
  logic [7:0] select_45;
  assign select_45 = first_s1_q ? left_one_q : ((brightest_q < left_one_q) ? left_one_q : brightest_q);
  logic not_47;
  assign not_47 = ~(cfg_dark_level_i < left_one_q);
  // hls/stages/health.hpp:67
  logic not_51;
  assign not_51 = ~(left_one_q < cfg_bright_level_i);
  // hls/stages/health.hpp:96
  logic [8:0] difference_62;
  assign difference_62 = {1'b0, left_one_q} - {1'b0, above_rdata_q[15:8]};
  logic [7:0] xor_63;
  assign xor_63 = difference_62[7:0] ^ {8{difference_62[8]}};
  logic [8:0] sum_64;
  assign sum_64 = {8'h0, difference_62[8]} + {1'b0, xor_63};
  logic [8:0] difference_66;
  assign difference_66 = {1'b0, left_one_q} - {1'b0, above_rdata_q[7:0]};
  logic [7:0] xor_67;
  assign xor_67 = difference_66[7:0] ^ {8{difference_66[8]}};
  logic [8:0] sum_68;
  assign sum_68 = {8'h0, difference_66[8]} + {1'b0, xor_67};
  logic less_69;
  assign less_69 = (sum_64 + 9'h1) < sum_68;
  // hls/stages/health.hpp:68
  logic down;
  assign down = rows_s1_q & ((sum_68 + 9'h1) < sum_64);
  // hls/stages/health.hpp:109
  logic [1:0] select_73;
  assign select_73 = less_69 ? 2'h1 : {2{down}};
  // hls/stages/health.hpp:68
  logic [2:0] down_2;
  assign down_2 = rows_s1_q ? {less_69, select_73} : {1'b0, {2{down}}};
  logic [2:0] down_3;
  assign down_3 = equal_25_s1_q ? down_2 : 3'h0;
  // hls/stages/health.hpp:113
  logic [7:0] sum_90;
  assign sum_90 = {{2{down_3[1]}}, down_3[2:1], 1'b0, {3{down_3[0]}}} + {{3{along_2_s1_q[1]}}, 1'b0, {4{along_2_s1_q[0]}}};

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = x_s1_q;
  logic above_we;
  assign above_we = s1_en & equal_25_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= {above_rdata_q[7:0], left_one_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && above_we) begin
      if (above_re && above_raddr == above_waddr) begin
        $error("above: address %0d is read less than DISTANCE steps after its write", above_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      signature_q <= 32'h0;
      darkest_q <= 8'h0;
      brightest_q <= 8'h0;
      dark_q <= 19'h0;
      bright_q <= 19'h0;
      torn_q <= 22'h0;
    end else if (s1_en) begin
      signature_q <= {select_27[0], xor_28[12:11], select_27[29], xor_28[10:9], select_27[26], xor_28[8:7], select_27[23], xor_28[6:4], select_27[19:17], xor_28[3], select_27[15:11], xor_28[2:1], xor_29[7:6], parity_30, xor_29[4:0]};
      darkest_q <= select_42;
      brightest_q <= select_45;
      dark_q <= {18'h0, not_47} + (first_s1_q ? 19'h0 : dark_q);
      bright_q <= {18'h0, not_51} + (first_s1_q ? 19'h0 : bright_q);
      torn_q <= (first_s1_q ? 22'h0 : torn_q) + {{14{sum_90[7]}}, sum_90};
    end
  end

  logic end_v_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      end_v_s2_q <= end_v_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [31:0] previous_signature_q;
  logic has_previous_q;
  logic [7:0] repeats_q;
  // hls/stages/health.hpp:74
  logic [7:0] select_37;
  assign select_37 = (previous_signature_q == signature_q) ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  logic [7:0] select_38;
  assign select_38 = has_previous_q ? select_37 : 8'h0;
  // hls/stages/health.hpp:77
  logic less_92;
  assign less_92 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:78
  logic less_93;
  assign less_93 = cfg_bright_limit_i < bright_q;
  // hls/stages/health.hpp:79
  logic or_97;
  assign or_97 = less_93 | (less_92 | (cfg_contrast_limit_i < (brightest_q - darkest_q)));
  logic not_98;
  assign not_98 = ~or_97;
  // hls/stages/health.hpp:80
  logic less_100;
  assign less_100 = (cfg_frozen_limit_i + 8'hff) < select_38;
  // hls/stages/health.hpp:81
  logic less_101;
  assign less_101 = $signed(22'h7d0) < $signed(torn_q);
  // hls/stages/health.hpp:84
  logic [4:0] select_102;
  assign select_102 = end_v_s2_q ? {less_101, less_100, not_98, less_93, less_92} : 5'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      previous_signature_q <= 32'h0;
      has_previous_q <= 1'b0;
      repeats_q <= 8'h0;
    end else if (s2_en) begin
      previous_signature_q <= end_v_s2_q ? signature_q : previous_signature_q;
      has_previous_q <= end_v_s2_q | has_previous_q;
      repeats_q <= end_v_s2_q ? select_38 : repeats_q;
    end
  end

  logic [4:0] select_102_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      select_102_s3_q <= select_102;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_102_s3_q[0];
  assign white_o = select_102_s3_q[1];
  assign constant_o = select_102_s3_q[2];
  assign frozen_o = select_102_s3_q[3];
  assign torn_o = select_102_s3_q[4];
  assign signature_o = previous_signature_q;
  assign valid_o = valid_s3_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q & end_v_s2_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^xor_29[5];

endmodule
