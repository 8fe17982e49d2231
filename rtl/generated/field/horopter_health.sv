// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::field>, hls/stages/health.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 157 bits, pipeline 25 bits, memories 1024 bits.
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
  input  logic [17:0] cfg_dark_limit_i,
  input  logic [17:0] cfg_bright_limit_i,
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [31:0] signature_q;
  logic [7:0] darkest_q;
  logic [7:0] brightest_q;
  logic [17:0] dark_q;
  logic [17:0] bright_q;
  logic [9:0] x_q;
  logic [1:0] rows_q;
  // hls/stages/health.hpp:97
  logic [9:0] x;
  assign x = first_i ? 10'h0 : x_q;
  // hls/stages/health.hpp:119
  logic equal_23;
  assign equal_23 = x[3:0] == 4'hf;
  // hls/stages/health.hpp:63
  logic [31:0] select_25;
  assign select_25 = first_i ? 32'h0 : signature_q;
  logic [12:0] xor_26;
  assign xor_26 = {13{select_25[0]}} ^ {select_25[31:30], select_25[28:27], select_25[25:24], select_25[22:20], select_25[16], select_25[10:9], select_25[6]};
  logic [7:0] xor_27;
  assign xor_27 = pixel_i ^ {select_25[8:7], xor_26[0], select_25[5:1]};
  logic parity_28;
  assign parity_28 = ^{select_25[6], select_25[0], pixel_i[5]};
  // hls/stages/health.hpp:65
  logic [7:0] select_40;
  assign select_40 = first_i ? pixel_i : ((pixel_i < darkest_q) ? pixel_i : darkest_q);
  // hls/stages/health.hpp:66
  logic [7:0] select_43;
  assign select_43 = first_i ? pixel_i : ((brightest_q < pixel_i) ? pixel_i : brightest_q);
  logic not_45;
  assign not_45 = ~(cfg_dark_level_i < pixel_i);
  // hls/stages/health.hpp:67
  logic not_49;
  assign not_49 = ~(pixel_i < cfg_bright_level_i);
  // hls/stages/health.hpp:98
  logic [1:0] rows;
  assign rows = first_i ? 2'h0 : rows_q;

  // Memory above, 64 x 16, DISTANCE 16, hls/stages/health.hpp:131; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign above_re = s0_en & equal_23;
  logic [15:0] above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (above_re) above_rdata_q <= above_mem[above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      signature_q <= 32'h0;
      darkest_q <= 8'h0;
      brightest_q <= 8'h0;
      dark_q <= 18'h0;
      bright_q <= 18'h0;
      x_q <= 10'h0;
      rows_q <= 2'h0;
    end else if (s0_en) begin
      signature_q <= {select_25[0], xor_26[12:11], select_25[29], xor_26[10:9], select_25[26], xor_26[8:7], select_25[23], xor_26[6:4], select_25[19:17], xor_26[3], select_25[15:11], xor_26[2:1], xor_27[7:6], parity_28, xor_27[4:0]};
      darkest_q <= select_40;
      brightest_q <= select_43;
      dark_q <= {17'h0, not_45} + (first_i ? 18'h0 : dark_q);
      bright_q <= {17'h0, not_49} + (first_i ? 18'h0 : bright_q);
      x_q <= last_i ? 10'h0 : (x + 10'h1);
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
      x_s1_q <= x[9:4];
      equal_23_s1_q <= equal_23;
      rows_s1_q <= rows[1];
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [31:0] previous_signature_q;
  logic has_previous_q;
  logic [7:0] repeats_q;
  logic [19:0] torn_q;
  // hls/stages/health.hpp:74
  logic [7:0] select_35;
  assign select_35 = (previous_signature_q == signature_q) ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  logic [7:0] select_36;
  assign select_36 = has_previous_q ? select_35 : 8'h0;
  // hls/stages/health.hpp:106
  logic [8:0] difference_59;
  assign difference_59 = {1'b0, pixel_s1_q} - {1'b0, above_rdata_q[15:8]};
  logic [7:0] xor_60;
  assign xor_60 = difference_59[7:0] ^ {8{difference_59[8]}};
  logic [8:0] to_two;
  assign to_two = {8'h0, difference_59[8]} + {1'b0, xor_60};
  // hls/stages/health.hpp:105
  logic [8:0] difference_63;
  assign difference_63 = {1'b0, pixel_s1_q} - {1'b0, above_rdata_q[7:0]};
  logic [7:0] xor_64;
  assign xor_64 = difference_63[7:0] ^ {8{difference_63[8]}};
  logic [8:0] to_one;
  assign to_one = {8'h0, difference_63[8]} + {1'b0, xor_64};
  // hls/stages/health.hpp:107
  logic change;
  assign change = rows_s1_q & ((to_two + 9'h1) < to_one);
  // hls/stages/health.hpp:108
  logic less_69;
  assign less_69 = (to_one + 9'h1) < to_two;
  logic or_70;
  assign or_70 = change | less_69;
  // hls/stages/health.hpp:68
  logic [1:0] change_2;
  assign change_2 = equal_23_s1_q ? (rows_s1_q ? {less_69, or_70} : {1'b0, change}) : 2'h0;
  // hls/stages/health.hpp:110
  logic [19:0] sum_74;
  assign sum_74 = {{15{change_2[1]}}, 1'b0, {4{change_2[0]}}} + (first_s1_q ? 20'h0 : torn_q);
  // hls/stages/health.hpp:77
  logic less_75;
  assign less_75 = cfg_dark_limit_i < dark_q;
  // hls/stages/health.hpp:78
  logic less_76;
  assign less_76 = cfg_bright_limit_i < bright_q;
  // hls/stages/health.hpp:79
  logic or_80;
  assign or_80 = less_76 | (less_75 | (cfg_contrast_limit_i < (brightest_q - darkest_q)));
  logic not_81;
  assign not_81 = ~or_80;
  // hls/stages/health.hpp:80
  logic less_83;
  assign less_83 = (cfg_frozen_limit_i + 8'hff) < select_36;
  // hls/stages/health.hpp:81
  logic less_84;
  assign less_84 = $signed(20'h300) < $signed(sum_74);

  // Memory above, write
  logic [5:0] above_waddr;
  assign above_waddr = x_s1_q;
  logic above_we;
  assign above_we = s1_en & equal_23_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (above_we) above_mem[above_waddr] <= {above_rdata_q[7:0], pixel_s1_q};
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
      previous_signature_q <= 32'h0;
      has_previous_q <= 1'b0;
      repeats_q <= 8'h0;
      torn_q <= 20'h0;
    end else if (s1_en) begin
      previous_signature_q <= end_v_s1_q ? signature_q : previous_signature_q;
      has_previous_q <= end_v_s1_q | has_previous_q;
      repeats_q <= end_v_s1_q ? select_36 : repeats_q;
      torn_q <= sum_74;
    end
  end

  logic [4:0] select_85_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      select_85_s2_q <= end_v_s1_q ? {less_84, less_83, not_81, less_76, less_75} : 5'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_85_s2_q[0];
  assign white_o = select_85_s2_q[1];
  assign constant_o = select_85_s2_q[2];
  assign frozen_o = select_85_s2_q[3];
  assign torn_o = select_85_s2_q[4];
  assign signature_o = previous_signature_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q & end_v_s1_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^xor_27[5];

endmodule
