// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Health<horopter::hls::profiles::field>, hls/stages/health.hpp. Do not edit.
//
// Latency 1 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 125 bits, pipeline 5 bits, memories 0 bits.
module horopter_health (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_i,
  input  logic first_i,
  input  logic end_v_i,
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
  output logic [31:0] signature_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q;
  logic s0_en;
  assign s0_en = en_i & valid_i;

  // Of the configuration alone: not pipelined.

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [31:0] signature_q;
  logic [31:0] previous_signature_q;
  logic has_previous_q;
  logic [7:0] repeats_q;
  logic [7:0] darkest_q;
  logic [7:0] brightest_q;
  logic [17:0] dark_q;
  logic [17:0] bright_q;
  // hls/stages/health.hpp:50
  logic [31:0] select_18;
  assign select_18 = first_i ? 32'h0 : signature_q;
  logic [12:0] xor_19;
  assign xor_19 = {13{select_18[0]}} ^ {select_18[31:30], select_18[28:27], select_18[25:24], select_18[22:20], select_18[16], select_18[10:9], select_18[6]};
  logic [7:0] xor_20;
  assign xor_20 = pixel_i ^ {select_18[8:7], xor_19[0], select_18[5:1]};
  logic parity_21;
  assign parity_21 = ^{select_18[6], select_18[0], pixel_i[5]};
  // hls/stages/health.hpp:68
  logic [31:0] select_22;
  assign select_22 = end_v_i ? {select_18[0], xor_19[12:11], select_18[29], xor_19[10:9], select_18[26], xor_19[8:7], select_18[23], xor_19[6:4], select_18[19:17], xor_19[3], select_18[15:11], xor_19[2:1], xor_20[7:6], parity_21, xor_20[4:0]} : previous_signature_q;
  // hls/stages/health.hpp:59
  logic equal_24;
  assign equal_24 = previous_signature_q == {select_18[0], xor_19[12:11], select_18[29], xor_19[10:9], select_18[26], xor_19[8:7], select_18[23], xor_19[6:4], select_18[19:17], xor_19[3], select_18[15:11], xor_19[2:1], xor_20[7:6], parity_21, xor_20[4:0]};
  // hls/stages/health.hpp:60
  logic [7:0] select_28;
  assign select_28 = equal_24 ? ((repeats_q == 8'hff) ? 8'hff : (repeats_q + 8'h1)) : 8'h0;
  logic [7:0] select_29;
  assign select_29 = has_previous_q ? select_28 : 8'h0;
  // hls/stages/health.hpp:52
  logic [7:0] select_33;
  assign select_33 = first_i ? pixel_i : ((pixel_i < darkest_q) ? pixel_i : darkest_q);
  // hls/stages/health.hpp:53
  logic [7:0] select_36;
  assign select_36 = first_i ? pixel_i : ((brightest_q < pixel_i) ? pixel_i : brightest_q);
  logic not_38;
  assign not_38 = ~(cfg_dark_level_i < pixel_i);
  // hls/stages/stream.hpp:54
  logic [17:0] sum_40;
  assign sum_40 = {17'h0, not_38} + (first_i ? 18'h0 : dark_q);
  // hls/stages/health.hpp:54
  logic not_42;
  assign not_42 = ~(pixel_i < cfg_bright_level_i);
  // hls/stages/stream.hpp:54
  logic [17:0] sum_44;
  assign sum_44 = {17'h0, not_42} + (first_i ? 18'h0 : bright_q);
  // hls/stages/health.hpp:63
  logic less_45;
  assign less_45 = cfg_dark_limit_i < sum_40;
  // hls/stages/health.hpp:64
  logic less_46;
  assign less_46 = cfg_bright_limit_i < sum_44;
  // hls/stages/health.hpp:65
  logic or_50;
  assign or_50 = less_46 | (less_45 | (cfg_contrast_limit_i < (select_36 - select_33)));
  logic not_51;
  assign not_51 = ~or_50;
  // hls/stages/health.hpp:66
  logic less_53;
  assign less_53 = (cfg_frozen_limit_i + 8'hff) < select_29;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      signature_q <= 32'h0;
      previous_signature_q <= 32'h0;
      has_previous_q <= 1'b0;
      repeats_q <= 8'h0;
      darkest_q <= 8'h0;
      brightest_q <= 8'h0;
      dark_q <= 18'h0;
      bright_q <= 18'h0;
    end else if (s0_en) begin
      signature_q <= {select_18[0], xor_19[12:11], select_18[29], xor_19[10:9], select_18[26], xor_19[8:7], select_18[23], xor_19[6:4], select_18[19:17], xor_19[3], select_18[15:11], xor_19[2:1], xor_20[7:6], parity_21, xor_20[4:0]};
      previous_signature_q <= select_22;
      has_previous_q <= end_v_i | has_previous_q;
      repeats_q <= end_v_i ? select_29 : repeats_q;
      darkest_q <= select_33;
      brightest_q <= select_36;
      dark_q <= sum_40;
      bright_q <= sum_44;
    end
  end

  logic [3:0] select_54_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      select_54_s1_q <= end_v_i ? {less_53, not_51, less_46, less_45} : 4'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign black_o = select_54_s1_q[0];
  assign white_o = select_54_s1_q[1];
  assign constant_o = select_54_s1_q[2];
  assign frozen_o = select_54_s1_q[3];
  assign signature_o = previous_signature_q;
  assign valid_o = valid_s1_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i & end_v_i;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^xor_20[5];

endmodule
