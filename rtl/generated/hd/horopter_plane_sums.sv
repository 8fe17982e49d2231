// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::PlaneSums<horopter::hls::profiles::hd>, hls/stages/plane_sums.hpp. Do not edit.
//
// Latency 7 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2544 bits, pipeline 1144 bits, memories 449280 bits.
module horopter_plane_sums (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic signed [5:0] left_i,
  input  logic signed [5:0] right_i,
  input  logic mask_i,
  input  logic [7:0] grey_i,
  input  logic exists_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  output logic valid_o,
  output logic [10:0] sum_0_o,
  output logic [10:0] sum_1_o,
  output logic [10:0] sum_2_o,
  output logic [10:0] sum_3_o,
  output logic [10:0] sum_4_o,
  output logic [10:0] sum_5_o,
  output logic [10:0] sum_6_o,
  output logic [10:0] sum_7_o,
  output logic [10:0] sum_8_o,
  output logic [10:0] sum_9_o,
  output logic [10:0] sum_10_o,
  output logic [10:0] sum_11_o,
  output logic [10:0] sum_12_o,
  output logic [10:0] evidence_o,
  output logic [5:0] grey_o,
  output logic known_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
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

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] arriving_column_q;
  logic arriving_row_ended_q;
  logic [5:0] seen_values_0_grey_q;
  logic seen_values_0_exists_q;
  logic [5:0] seen_values_1_grey_q;
  logic seen_values_1_exists_q;
  logic [5:0] seen_values_2_grey_q;
  logic seen_values_2_exists_q;
  logic [5:0] seen_values_3_grey_q;
  logic seen_values_3_exists_q;
  logic [5:0] seen_values_4_grey_q;
  logic seen_values_4_exists_q;
  logic [5:0] seen_values_5_grey_q;
  logic seen_values_5_exists_q;
  logic [5:0] seen_values_6_grey_q;
  logic seen_values_6_exists_q;
  logic [5:0] seen_values_7_grey_q;
  logic seen_values_7_exists_q;
  logic [5:0] seen_values_8_grey_q;
  logic seen_values_8_exists_q;
  logic [5:0] seen_values_9_grey_q;
  logic seen_values_9_exists_q;
  logic [5:0] seen_values_10_grey_q;
  logic seen_values_10_exists_q;
  logic [5:0] seen_values_11_grey_q;
  logic seen_values_11_exists_q;
  logic [5:0] seen_values_12_grey_q;
  logic seen_values_12_exists_q;
  logic [5:0] seen_values_13_grey_q;
  logic seen_values_13_exists_q;
  logic [5:0] seen_values_14_grey_q;
  logic seen_values_14_exists_q;
  logic [5:0] seen_values_15_grey_q;
  logic seen_values_15_exists_q;
  logic [5:0] seen_values_16_grey_q;
  logic seen_values_16_exists_q;
  logic [5:0] seen_values_17_grey_q;
  logic seen_values_17_exists_q;
  logic [5:0] seen_values_18_grey_q;
  logic seen_values_18_exists_q;
  // hls/stages/plane_sums.hpp:63
  logic or_473;
  assign or_473 = marks_first_i | arriving_row_ended_q;
  logic [10:0] select_474;
  assign select_474 = or_473 ? 11'h0 : arriving_column_q;

  // Memory feature_memory, 1920 x 91, DISTANCE 16, hls/stages/plane_sums.hpp:166; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] feature_memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) feature_memory_mem[i] = 91'h0;
`endif
  logic [10:0] feature_memory_raddr;
  assign feature_memory_raddr = select_474;
  logic feature_memory_re;
  assign feature_memory_re = s0_en;
  logic [90:0] feature_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (feature_memory_re) feature_memory_rdata_q <= feature_memory_mem[feature_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      arriving_column_q <= 11'h0;
      arriving_row_ended_q <= 1'b1;
      seen_values_0_grey_q <= 6'h0;
      seen_values_0_exists_q <= 1'b0;
      seen_values_1_grey_q <= 6'h0;
      seen_values_1_exists_q <= 1'b0;
      seen_values_2_grey_q <= 6'h0;
      seen_values_2_exists_q <= 1'b0;
      seen_values_3_grey_q <= 6'h0;
      seen_values_3_exists_q <= 1'b0;
      seen_values_4_grey_q <= 6'h0;
      seen_values_4_exists_q <= 1'b0;
      seen_values_5_grey_q <= 6'h0;
      seen_values_5_exists_q <= 1'b0;
      seen_values_6_grey_q <= 6'h0;
      seen_values_6_exists_q <= 1'b0;
      seen_values_7_grey_q <= 6'h0;
      seen_values_7_exists_q <= 1'b0;
      seen_values_8_grey_q <= 6'h0;
      seen_values_8_exists_q <= 1'b0;
      seen_values_9_grey_q <= 6'h0;
      seen_values_9_exists_q <= 1'b0;
      seen_values_10_grey_q <= 6'h0;
      seen_values_10_exists_q <= 1'b0;
      seen_values_11_grey_q <= 6'h0;
      seen_values_11_exists_q <= 1'b0;
      seen_values_12_grey_q <= 6'h0;
      seen_values_12_exists_q <= 1'b0;
      seen_values_13_grey_q <= 6'h0;
      seen_values_13_exists_q <= 1'b0;
      seen_values_14_grey_q <= 6'h0;
      seen_values_14_exists_q <= 1'b0;
      seen_values_15_grey_q <= 6'h0;
      seen_values_15_exists_q <= 1'b0;
      seen_values_16_grey_q <= 6'h0;
      seen_values_16_exists_q <= 1'b0;
      seen_values_17_grey_q <= 6'h0;
      seen_values_17_exists_q <= 1'b0;
      seen_values_18_grey_q <= 6'h0;
      seen_values_18_exists_q <= 1'b0;
    end else if (s0_en) begin
      arriving_column_q <= select_474 + 11'h1;
      arriving_row_ended_q <= marks_last_i;
      seen_values_0_grey_q <= grey_i[7:2];
      seen_values_0_exists_q <= exists_i;
      seen_values_1_grey_q <= seen_values_0_grey_q;
      seen_values_1_exists_q <= seen_values_0_exists_q;
      seen_values_2_grey_q <= seen_values_1_grey_q;
      seen_values_2_exists_q <= seen_values_1_exists_q;
      seen_values_3_grey_q <= seen_values_2_grey_q;
      seen_values_3_exists_q <= seen_values_2_exists_q;
      seen_values_4_grey_q <= seen_values_3_grey_q;
      seen_values_4_exists_q <= seen_values_3_exists_q;
      seen_values_5_grey_q <= seen_values_4_grey_q;
      seen_values_5_exists_q <= seen_values_4_exists_q;
      seen_values_6_grey_q <= seen_values_5_grey_q;
      seen_values_6_exists_q <= seen_values_5_exists_q;
      seen_values_7_grey_q <= seen_values_6_grey_q;
      seen_values_7_exists_q <= seen_values_6_exists_q;
      seen_values_8_grey_q <= seen_values_7_grey_q;
      seen_values_8_exists_q <= seen_values_7_exists_q;
      seen_values_9_grey_q <= seen_values_8_grey_q;
      seen_values_9_exists_q <= seen_values_8_exists_q;
      seen_values_10_grey_q <= seen_values_9_grey_q;
      seen_values_10_exists_q <= seen_values_9_exists_q;
      seen_values_11_grey_q <= seen_values_10_grey_q;
      seen_values_11_exists_q <= seen_values_10_exists_q;
      seen_values_12_grey_q <= seen_values_11_grey_q;
      seen_values_12_exists_q <= seen_values_11_exists_q;
      seen_values_13_grey_q <= seen_values_12_grey_q;
      seen_values_13_exists_q <= seen_values_12_exists_q;
      seen_values_14_grey_q <= seen_values_13_grey_q;
      seen_values_14_exists_q <= seen_values_13_exists_q;
      seen_values_15_grey_q <= seen_values_14_grey_q;
      seen_values_15_exists_q <= seen_values_14_exists_q;
      seen_values_16_grey_q <= seen_values_15_grey_q;
      seen_values_16_exists_q <= seen_values_15_exists_q;
      seen_values_17_grey_q <= seen_values_16_grey_q;
      seen_values_17_exists_q <= seen_values_16_exists_q;
      seen_values_18_grey_q <= seen_values_17_grey_q;
      seen_values_18_exists_q <= seen_values_17_exists_q;
    end
  end

  logic [5:0] left_s1_q;
  logic [5:0] right_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic [5:0] seen_values_18_grey_s1_q;
  logic seen_values_18_exists_s1_q;
  logic or_473_s1_q;
  logic [10:0] select_474_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      left_s1_q <= $unsigned(left_i);
      right_s1_q <= $unsigned(right_i);
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      seen_values_18_grey_s1_q <= seen_values_18_grey_q;
      seen_values_18_exists_s1_q <= seen_values_18_exists_q;
      or_473_s1_q <= or_473;
      select_474_s1_q <= select_474;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] entering_values_0_features_left_q;
  logic [5:0] entering_values_0_features_right_q;
  logic [5:0] entering_values_1_features_left_q;
  logic [5:0] entering_values_1_features_right_q;
  logic [5:0] entering_values_2_features_left_q;
  logic [5:0] entering_values_2_features_right_q;
  logic [5:0] entering_values_3_features_left_q;
  logic [5:0] entering_values_3_features_right_q;
  logic [5:0] entering_values_4_features_left_q;
  logic [5:0] entering_values_4_features_right_q;
  logic [5:0] entering_values_5_features_left_q;
  logic [5:0] entering_values_5_features_right_q;
  logic [5:0] entering_values_6_features_left_q;
  logic [5:0] entering_values_6_features_right_q;
  logic [5:0] entering_values_7_features_left_q;
  logic [5:0] entering_values_7_features_right_q;
  logic [5:0] entering_values_8_features_left_q;
  logic [5:0] entering_values_8_features_right_q;
  logic [5:0] entering_values_9_features_left_q;
  logic [5:0] entering_values_9_features_right_q;
  logic [5:0] entering_values_10_features_left_q;
  logic [5:0] entering_values_10_features_right_q;
  logic [5:0] entering_values_11_features_left_q;
  logic [5:0] entering_values_11_features_right_q;
  logic [5:0] entering_values_12_features_left_q;
  logic [5:0] entering_values_12_features_right_q;
  logic [5:0] entering_values_13_features_left_q;
  logic [5:0] entering_values_13_features_right_q;
  logic [5:0] entering_values_14_features_left_q;
  logic [5:0] entering_values_14_features_right_q;
  logic [5:0] entering_values_15_features_left_q;
  logic [5:0] entering_values_15_features_right_q;
  logic [5:0] entering_values_16_features_left_q;
  logic [5:0] entering_values_16_features_right_q;
  logic [5:0] entering_values_17_features_left_q;
  logic [5:0] entering_values_17_features_right_q;
  logic [5:0] entering_values_18_features_right_q;
  logic [5:0] entering_values_19_features_right_q;
  logic [5:0] entering_values_20_features_right_q;
  logic [5:0] entering_values_21_features_right_q;
  logic [5:0] entering_values_22_features_right_q;
  logic [5:0] entering_values_23_features_right_q;
  logic [5:0] entering_values_24_features_right_q;
  logic [5:0] entering_values_25_features_right_q;
  logic [5:0] entering_values_26_features_right_q;
  logic [5:0] entering_values_27_features_right_q;
  logic [5:0] entering_values_28_features_right_q;
  logic [5:0] entering_values_29_features_right_q;
  logic [5:0] entering_values_30_features_right_q;
  logic [5:0] entering_values_31_features_right_q;
  logic [5:0] entering_values_32_features_right_q;
  logic [5:0] entering_values_33_features_right_q;
  logic [5:0] entering_values_34_features_right_q;
  logic [5:0] entering_values_35_features_right_q;
  logic [5:0] leaving_values_0_features_left_q;
  logic [5:0] leaving_values_0_features_right_q;
  logic [5:0] leaving_values_1_features_left_q;
  logic [5:0] leaving_values_1_features_right_q;
  logic [5:0] leaving_values_2_features_left_q;
  logic [5:0] leaving_values_2_features_right_q;
  logic [5:0] leaving_values_3_features_left_q;
  logic [5:0] leaving_values_3_features_right_q;
  logic [5:0] leaving_values_4_features_left_q;
  logic [5:0] leaving_values_4_features_right_q;
  logic [5:0] leaving_values_5_features_left_q;
  logic [5:0] leaving_values_5_features_right_q;
  logic [5:0] leaving_values_6_features_left_q;
  logic [5:0] leaving_values_6_features_right_q;
  logic [5:0] leaving_values_7_features_left_q;
  logic [5:0] leaving_values_7_features_right_q;
  logic [5:0] leaving_values_8_features_left_q;
  logic [5:0] leaving_values_8_features_right_q;
  logic [5:0] leaving_values_9_features_left_q;
  logic [5:0] leaving_values_9_features_right_q;
  logic [5:0] leaving_values_10_features_left_q;
  logic [5:0] leaving_values_10_features_right_q;
  logic [5:0] leaving_values_11_features_left_q;
  logic [5:0] leaving_values_11_features_right_q;
  logic [5:0] leaving_values_12_features_left_q;
  logic [5:0] leaving_values_12_features_right_q;
  logic [5:0] leaving_values_13_features_left_q;
  logic [5:0] leaving_values_13_features_right_q;
  logic [5:0] leaving_values_14_features_left_q;
  logic [5:0] leaving_values_14_features_right_q;
  logic [5:0] leaving_values_15_features_left_q;
  logic [5:0] leaving_values_15_features_right_q;
  logic [5:0] leaving_values_16_features_left_q;
  logic [5:0] leaving_values_16_features_right_q;
  logic [5:0] leaving_values_17_features_left_q;
  logic [5:0] leaving_values_17_features_right_q;
  logic [5:0] leaving_values_18_features_right_q;
  logic [5:0] leaving_values_19_features_right_q;
  logic [5:0] leaving_values_20_features_right_q;
  logic [5:0] leaving_values_21_features_right_q;
  logic [5:0] leaving_values_22_features_right_q;
  logic [5:0] leaving_values_23_features_right_q;
  logic [5:0] leaving_values_24_features_right_q;
  logic [5:0] leaving_values_25_features_right_q;
  logic [5:0] leaving_values_26_features_right_q;
  logic [5:0] leaving_values_27_features_right_q;
  logic [5:0] leaving_values_28_features_right_q;
  logic [5:0] leaving_values_29_features_right_q;
  logic [5:0] leaving_values_30_features_right_q;
  logic [5:0] leaving_values_31_features_right_q;
  logic [5:0] leaving_values_32_features_right_q;
  logic [5:0] leaving_values_33_features_right_q;
  logic [5:0] leaving_values_34_features_right_q;
  logic [5:0] leaving_values_35_features_right_q;
  logic marks_values_0_first_q;
  logic marks_values_0_last_q;
  logic marks_values_1_first_q;
  logic marks_values_1_last_q;
  logic marks_values_2_first_q;
  logic marks_values_2_last_q;
  logic marks_values_3_first_q;
  logic marks_values_3_last_q;
  logic marks_values_4_first_q;
  logic marks_values_4_last_q;
  logic marks_values_5_first_q;
  logic marks_values_5_last_q;
  logic marks_values_6_first_q;
  logic marks_values_6_last_q;
  logic marks_values_7_first_q;
  logic marks_values_7_last_q;
  logic marks_values_8_first_q;
  logic marks_values_8_last_q;
  logic marks_values_9_first_q;
  logic marks_values_9_last_q;
  logic marks_values_10_first_q;
  logic marks_values_10_last_q;
  logic marks_values_11_first_q;
  logic marks_values_11_last_q;
  logic marks_values_12_first_q;
  logic marks_values_12_last_q;
  logic marks_values_13_first_q;
  logic marks_values_13_last_q;
  logic marks_values_14_first_q;
  logic marks_values_14_last_q;
  logic marks_values_15_first_q;
  logic marks_values_15_last_q;
  logic marks_values_16_first_q;
  logic marks_values_16_last_q;
  logic marks_values_17_first_q;
  logic marks_values_17_last_q;
  logic marks_values_18_first_q;
  logic marks_values_18_last_q;
  logic marks_values_19_first_q;
  logic marks_values_19_last_q;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_746;
  assign difference_746 = {entering_values_17_features_left_q[5], entering_values_17_features_left_q} - {entering_values_35_features_right_q[5], entering_values_35_features_right_q};
  logic [6:0] difference_754;
  assign difference_754 = {leaving_values_17_features_left_q[5], leaving_values_17_features_left_q} - {leaving_values_35_features_right_q[5], leaving_values_35_features_right_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      entering_values_0_features_left_q <= 6'h0;
      entering_values_0_features_right_q <= 6'h0;
      entering_values_1_features_left_q <= 6'h0;
      entering_values_1_features_right_q <= 6'h0;
      entering_values_2_features_left_q <= 6'h0;
      entering_values_2_features_right_q <= 6'h0;
      entering_values_3_features_left_q <= 6'h0;
      entering_values_3_features_right_q <= 6'h0;
      entering_values_4_features_left_q <= 6'h0;
      entering_values_4_features_right_q <= 6'h0;
      entering_values_5_features_left_q <= 6'h0;
      entering_values_5_features_right_q <= 6'h0;
      entering_values_6_features_left_q <= 6'h0;
      entering_values_6_features_right_q <= 6'h0;
      entering_values_7_features_left_q <= 6'h0;
      entering_values_7_features_right_q <= 6'h0;
      entering_values_8_features_left_q <= 6'h0;
      entering_values_8_features_right_q <= 6'h0;
      entering_values_9_features_left_q <= 6'h0;
      entering_values_9_features_right_q <= 6'h0;
      entering_values_10_features_left_q <= 6'h0;
      entering_values_10_features_right_q <= 6'h0;
      entering_values_11_features_left_q <= 6'h0;
      entering_values_11_features_right_q <= 6'h0;
      entering_values_12_features_left_q <= 6'h0;
      entering_values_12_features_right_q <= 6'h0;
      entering_values_13_features_left_q <= 6'h0;
      entering_values_13_features_right_q <= 6'h0;
      entering_values_14_features_left_q <= 6'h0;
      entering_values_14_features_right_q <= 6'h0;
      entering_values_15_features_left_q <= 6'h0;
      entering_values_15_features_right_q <= 6'h0;
      entering_values_16_features_left_q <= 6'h0;
      entering_values_16_features_right_q <= 6'h0;
      entering_values_17_features_left_q <= 6'h0;
      entering_values_17_features_right_q <= 6'h0;
      entering_values_18_features_right_q <= 6'h0;
      entering_values_19_features_right_q <= 6'h0;
      entering_values_20_features_right_q <= 6'h0;
      entering_values_21_features_right_q <= 6'h0;
      entering_values_22_features_right_q <= 6'h0;
      entering_values_23_features_right_q <= 6'h0;
      entering_values_24_features_right_q <= 6'h0;
      entering_values_25_features_right_q <= 6'h0;
      entering_values_26_features_right_q <= 6'h0;
      entering_values_27_features_right_q <= 6'h0;
      entering_values_28_features_right_q <= 6'h0;
      entering_values_29_features_right_q <= 6'h0;
      entering_values_30_features_right_q <= 6'h0;
      entering_values_31_features_right_q <= 6'h0;
      entering_values_32_features_right_q <= 6'h0;
      entering_values_33_features_right_q <= 6'h0;
      entering_values_34_features_right_q <= 6'h0;
      entering_values_35_features_right_q <= 6'h0;
      leaving_values_0_features_left_q <= 6'h0;
      leaving_values_0_features_right_q <= 6'h0;
      leaving_values_1_features_left_q <= 6'h0;
      leaving_values_1_features_right_q <= 6'h0;
      leaving_values_2_features_left_q <= 6'h0;
      leaving_values_2_features_right_q <= 6'h0;
      leaving_values_3_features_left_q <= 6'h0;
      leaving_values_3_features_right_q <= 6'h0;
      leaving_values_4_features_left_q <= 6'h0;
      leaving_values_4_features_right_q <= 6'h0;
      leaving_values_5_features_left_q <= 6'h0;
      leaving_values_5_features_right_q <= 6'h0;
      leaving_values_6_features_left_q <= 6'h0;
      leaving_values_6_features_right_q <= 6'h0;
      leaving_values_7_features_left_q <= 6'h0;
      leaving_values_7_features_right_q <= 6'h0;
      leaving_values_8_features_left_q <= 6'h0;
      leaving_values_8_features_right_q <= 6'h0;
      leaving_values_9_features_left_q <= 6'h0;
      leaving_values_9_features_right_q <= 6'h0;
      leaving_values_10_features_left_q <= 6'h0;
      leaving_values_10_features_right_q <= 6'h0;
      leaving_values_11_features_left_q <= 6'h0;
      leaving_values_11_features_right_q <= 6'h0;
      leaving_values_12_features_left_q <= 6'h0;
      leaving_values_12_features_right_q <= 6'h0;
      leaving_values_13_features_left_q <= 6'h0;
      leaving_values_13_features_right_q <= 6'h0;
      leaving_values_14_features_left_q <= 6'h0;
      leaving_values_14_features_right_q <= 6'h0;
      leaving_values_15_features_left_q <= 6'h0;
      leaving_values_15_features_right_q <= 6'h0;
      leaving_values_16_features_left_q <= 6'h0;
      leaving_values_16_features_right_q <= 6'h0;
      leaving_values_17_features_left_q <= 6'h0;
      leaving_values_17_features_right_q <= 6'h0;
      leaving_values_18_features_right_q <= 6'h0;
      leaving_values_19_features_right_q <= 6'h0;
      leaving_values_20_features_right_q <= 6'h0;
      leaving_values_21_features_right_q <= 6'h0;
      leaving_values_22_features_right_q <= 6'h0;
      leaving_values_23_features_right_q <= 6'h0;
      leaving_values_24_features_right_q <= 6'h0;
      leaving_values_25_features_right_q <= 6'h0;
      leaving_values_26_features_right_q <= 6'h0;
      leaving_values_27_features_right_q <= 6'h0;
      leaving_values_28_features_right_q <= 6'h0;
      leaving_values_29_features_right_q <= 6'h0;
      leaving_values_30_features_right_q <= 6'h0;
      leaving_values_31_features_right_q <= 6'h0;
      leaving_values_32_features_right_q <= 6'h0;
      leaving_values_33_features_right_q <= 6'h0;
      leaving_values_34_features_right_q <= 6'h0;
      leaving_values_35_features_right_q <= 6'h0;
      marks_values_0_first_q <= 1'b0;
      marks_values_0_last_q <= 1'b0;
      marks_values_1_first_q <= 1'b0;
      marks_values_1_last_q <= 1'b0;
      marks_values_2_first_q <= 1'b0;
      marks_values_2_last_q <= 1'b0;
      marks_values_3_first_q <= 1'b0;
      marks_values_3_last_q <= 1'b0;
      marks_values_4_first_q <= 1'b0;
      marks_values_4_last_q <= 1'b0;
      marks_values_5_first_q <= 1'b0;
      marks_values_5_last_q <= 1'b0;
      marks_values_6_first_q <= 1'b0;
      marks_values_6_last_q <= 1'b0;
      marks_values_7_first_q <= 1'b0;
      marks_values_7_last_q <= 1'b0;
      marks_values_8_first_q <= 1'b0;
      marks_values_8_last_q <= 1'b0;
      marks_values_9_first_q <= 1'b0;
      marks_values_9_last_q <= 1'b0;
      marks_values_10_first_q <= 1'b0;
      marks_values_10_last_q <= 1'b0;
      marks_values_11_first_q <= 1'b0;
      marks_values_11_last_q <= 1'b0;
      marks_values_12_first_q <= 1'b0;
      marks_values_12_last_q <= 1'b0;
      marks_values_13_first_q <= 1'b0;
      marks_values_13_last_q <= 1'b0;
      marks_values_14_first_q <= 1'b0;
      marks_values_14_last_q <= 1'b0;
      marks_values_15_first_q <= 1'b0;
      marks_values_15_last_q <= 1'b0;
      marks_values_16_first_q <= 1'b0;
      marks_values_16_last_q <= 1'b0;
      marks_values_17_first_q <= 1'b0;
      marks_values_17_last_q <= 1'b0;
      marks_values_18_first_q <= 1'b0;
      marks_values_18_last_q <= 1'b0;
      marks_values_19_first_q <= 1'b0;
      marks_values_19_last_q <= 1'b0;
    end else if (s1_en) begin
      entering_values_0_features_left_q <= left_s1_q;
      entering_values_0_features_right_q <= right_s1_q;
      entering_values_1_features_left_q <= entering_values_0_features_left_q;
      entering_values_1_features_right_q <= entering_values_0_features_right_q;
      entering_values_2_features_left_q <= entering_values_1_features_left_q;
      entering_values_2_features_right_q <= entering_values_1_features_right_q;
      entering_values_3_features_left_q <= entering_values_2_features_left_q;
      entering_values_3_features_right_q <= entering_values_2_features_right_q;
      entering_values_4_features_left_q <= entering_values_3_features_left_q;
      entering_values_4_features_right_q <= entering_values_3_features_right_q;
      entering_values_5_features_left_q <= entering_values_4_features_left_q;
      entering_values_5_features_right_q <= entering_values_4_features_right_q;
      entering_values_6_features_left_q <= entering_values_5_features_left_q;
      entering_values_6_features_right_q <= entering_values_5_features_right_q;
      entering_values_7_features_left_q <= entering_values_6_features_left_q;
      entering_values_7_features_right_q <= entering_values_6_features_right_q;
      entering_values_8_features_left_q <= entering_values_7_features_left_q;
      entering_values_8_features_right_q <= entering_values_7_features_right_q;
      entering_values_9_features_left_q <= entering_values_8_features_left_q;
      entering_values_9_features_right_q <= entering_values_8_features_right_q;
      entering_values_10_features_left_q <= entering_values_9_features_left_q;
      entering_values_10_features_right_q <= entering_values_9_features_right_q;
      entering_values_11_features_left_q <= entering_values_10_features_left_q;
      entering_values_11_features_right_q <= entering_values_10_features_right_q;
      entering_values_12_features_left_q <= entering_values_11_features_left_q;
      entering_values_12_features_right_q <= entering_values_11_features_right_q;
      entering_values_13_features_left_q <= entering_values_12_features_left_q;
      entering_values_13_features_right_q <= entering_values_12_features_right_q;
      entering_values_14_features_left_q <= entering_values_13_features_left_q;
      entering_values_14_features_right_q <= entering_values_13_features_right_q;
      entering_values_15_features_left_q <= entering_values_14_features_left_q;
      entering_values_15_features_right_q <= entering_values_14_features_right_q;
      entering_values_16_features_left_q <= entering_values_15_features_left_q;
      entering_values_16_features_right_q <= entering_values_15_features_right_q;
      entering_values_17_features_left_q <= entering_values_16_features_left_q;
      entering_values_17_features_right_q <= entering_values_16_features_right_q;
      entering_values_18_features_right_q <= entering_values_17_features_right_q;
      entering_values_19_features_right_q <= entering_values_18_features_right_q;
      entering_values_20_features_right_q <= entering_values_19_features_right_q;
      entering_values_21_features_right_q <= entering_values_20_features_right_q;
      entering_values_22_features_right_q <= entering_values_21_features_right_q;
      entering_values_23_features_right_q <= entering_values_22_features_right_q;
      entering_values_24_features_right_q <= entering_values_23_features_right_q;
      entering_values_25_features_right_q <= entering_values_24_features_right_q;
      entering_values_26_features_right_q <= entering_values_25_features_right_q;
      entering_values_27_features_right_q <= entering_values_26_features_right_q;
      entering_values_28_features_right_q <= entering_values_27_features_right_q;
      entering_values_29_features_right_q <= entering_values_28_features_right_q;
      entering_values_30_features_right_q <= entering_values_29_features_right_q;
      entering_values_31_features_right_q <= entering_values_30_features_right_q;
      entering_values_32_features_right_q <= entering_values_31_features_right_q;
      entering_values_33_features_right_q <= entering_values_32_features_right_q;
      entering_values_34_features_right_q <= entering_values_33_features_right_q;
      entering_values_35_features_right_q <= entering_values_34_features_right_q;
      leaving_values_0_features_left_q <= feature_memory_rdata_q[83:78];
      leaving_values_0_features_right_q <= feature_memory_rdata_q[89:84];
      leaving_values_1_features_left_q <= leaving_values_0_features_left_q;
      leaving_values_1_features_right_q <= leaving_values_0_features_right_q;
      leaving_values_2_features_left_q <= leaving_values_1_features_left_q;
      leaving_values_2_features_right_q <= leaving_values_1_features_right_q;
      leaving_values_3_features_left_q <= leaving_values_2_features_left_q;
      leaving_values_3_features_right_q <= leaving_values_2_features_right_q;
      leaving_values_4_features_left_q <= leaving_values_3_features_left_q;
      leaving_values_4_features_right_q <= leaving_values_3_features_right_q;
      leaving_values_5_features_left_q <= leaving_values_4_features_left_q;
      leaving_values_5_features_right_q <= leaving_values_4_features_right_q;
      leaving_values_6_features_left_q <= leaving_values_5_features_left_q;
      leaving_values_6_features_right_q <= leaving_values_5_features_right_q;
      leaving_values_7_features_left_q <= leaving_values_6_features_left_q;
      leaving_values_7_features_right_q <= leaving_values_6_features_right_q;
      leaving_values_8_features_left_q <= leaving_values_7_features_left_q;
      leaving_values_8_features_right_q <= leaving_values_7_features_right_q;
      leaving_values_9_features_left_q <= leaving_values_8_features_left_q;
      leaving_values_9_features_right_q <= leaving_values_8_features_right_q;
      leaving_values_10_features_left_q <= leaving_values_9_features_left_q;
      leaving_values_10_features_right_q <= leaving_values_9_features_right_q;
      leaving_values_11_features_left_q <= leaving_values_10_features_left_q;
      leaving_values_11_features_right_q <= leaving_values_10_features_right_q;
      leaving_values_12_features_left_q <= leaving_values_11_features_left_q;
      leaving_values_12_features_right_q <= leaving_values_11_features_right_q;
      leaving_values_13_features_left_q <= leaving_values_12_features_left_q;
      leaving_values_13_features_right_q <= leaving_values_12_features_right_q;
      leaving_values_14_features_left_q <= leaving_values_13_features_left_q;
      leaving_values_14_features_right_q <= leaving_values_13_features_right_q;
      leaving_values_15_features_left_q <= leaving_values_14_features_left_q;
      leaving_values_15_features_right_q <= leaving_values_14_features_right_q;
      leaving_values_16_features_left_q <= leaving_values_15_features_left_q;
      leaving_values_16_features_right_q <= leaving_values_15_features_right_q;
      leaving_values_17_features_left_q <= leaving_values_16_features_left_q;
      leaving_values_17_features_right_q <= leaving_values_16_features_right_q;
      leaving_values_18_features_right_q <= leaving_values_17_features_right_q;
      leaving_values_19_features_right_q <= leaving_values_18_features_right_q;
      leaving_values_20_features_right_q <= leaving_values_19_features_right_q;
      leaving_values_21_features_right_q <= leaving_values_20_features_right_q;
      leaving_values_22_features_right_q <= leaving_values_21_features_right_q;
      leaving_values_23_features_right_q <= leaving_values_22_features_right_q;
      leaving_values_24_features_right_q <= leaving_values_23_features_right_q;
      leaving_values_25_features_right_q <= leaving_values_24_features_right_q;
      leaving_values_26_features_right_q <= leaving_values_25_features_right_q;
      leaving_values_27_features_right_q <= leaving_values_26_features_right_q;
      leaving_values_28_features_right_q <= leaving_values_27_features_right_q;
      leaving_values_29_features_right_q <= leaving_values_28_features_right_q;
      leaving_values_30_features_right_q <= leaving_values_29_features_right_q;
      leaving_values_31_features_right_q <= leaving_values_30_features_right_q;
      leaving_values_32_features_right_q <= leaving_values_31_features_right_q;
      leaving_values_33_features_right_q <= leaving_values_32_features_right_q;
      leaving_values_34_features_right_q <= leaving_values_33_features_right_q;
      leaving_values_35_features_right_q <= leaving_values_34_features_right_q;
      marks_values_0_first_q <= marks_first_s1_q;
      marks_values_0_last_q <= arriving_row_ended_q;
      marks_values_1_first_q <= marks_values_0_first_q;
      marks_values_1_last_q <= marks_values_0_last_q;
      marks_values_2_first_q <= marks_values_1_first_q;
      marks_values_2_last_q <= marks_values_1_last_q;
      marks_values_3_first_q <= marks_values_2_first_q;
      marks_values_3_last_q <= marks_values_2_last_q;
      marks_values_4_first_q <= marks_values_3_first_q;
      marks_values_4_last_q <= marks_values_3_last_q;
      marks_values_5_first_q <= marks_values_4_first_q;
      marks_values_5_last_q <= marks_values_4_last_q;
      marks_values_6_first_q <= marks_values_5_first_q;
      marks_values_6_last_q <= marks_values_5_last_q;
      marks_values_7_first_q <= marks_values_6_first_q;
      marks_values_7_last_q <= marks_values_6_last_q;
      marks_values_8_first_q <= marks_values_7_first_q;
      marks_values_8_last_q <= marks_values_7_last_q;
      marks_values_9_first_q <= marks_values_8_first_q;
      marks_values_9_last_q <= marks_values_8_last_q;
      marks_values_10_first_q <= marks_values_9_first_q;
      marks_values_10_last_q <= marks_values_9_last_q;
      marks_values_11_first_q <= marks_values_10_first_q;
      marks_values_11_last_q <= marks_values_10_last_q;
      marks_values_12_first_q <= marks_values_11_first_q;
      marks_values_12_last_q <= marks_values_11_last_q;
      marks_values_13_first_q <= marks_values_12_first_q;
      marks_values_13_last_q <= marks_values_12_last_q;
      marks_values_14_first_q <= marks_values_13_first_q;
      marks_values_14_last_q <= marks_values_13_last_q;
      marks_values_15_first_q <= marks_values_14_first_q;
      marks_values_15_last_q <= marks_values_14_last_q;
      marks_values_16_first_q <= marks_values_15_first_q;
      marks_values_16_last_q <= marks_values_15_last_q;
      marks_values_17_first_q <= marks_values_16_first_q;
      marks_values_17_last_q <= marks_values_16_last_q;
      marks_values_18_first_q <= marks_values_17_first_q;
      marks_values_18_last_q <= marks_values_17_last_q;
      marks_values_19_first_q <= marks_values_18_first_q;
      marks_values_19_last_q <= marks_values_18_last_q;
    end
  end

  logic mask_s2_q;
  logic [5:0] entering_values_17_features_left_s2_q;
  logic [5:0] leaving_values_17_features_left_s2_q;
  logic marks_values_19_first_s2_q;
  logic marks_values_19_last_s2_q;
  logic [5:0] seen_values_18_grey_s2_q;
  logic seen_values_18_exists_s2_q;
  logic or_473_s2_q;
  logic [10:0] select_474_s2_q;
  logic [78:0] feature_memory_rdata_s2_q;
  logic [6:0] difference_746_s2_q;
  logic [6:0] difference_754_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      mask_s2_q <= mask_s1_q;
      entering_values_17_features_left_s2_q <= entering_values_17_features_left_q;
      leaving_values_17_features_left_s2_q <= leaving_values_17_features_left_q;
      marks_values_19_first_s2_q <= marks_values_19_first_q;
      marks_values_19_last_s2_q <= marks_values_19_last_q;
      seen_values_18_grey_s2_q <= seen_values_18_grey_s1_q;
      seen_values_18_exists_s2_q <= seen_values_18_exists_s1_q;
      or_473_s2_q <= or_473_s1_q;
      select_474_s2_q <= select_474_s1_q;
      feature_memory_rdata_s2_q <= {feature_memory_rdata_q[90], feature_memory_rdata_q[77:0]};
      difference_746_s2_q <= difference_746;
      difference_754_s2_q <= difference_754;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [2:0] arriving_rows_q;
  logic [10:0] delayed_column_q;
  logic delayed_row_ended_q;
  logic running_q;
  // hls/stages/plane_sums.hpp:81
  logic or_476;
  assign or_476 = delayed_row_ended_q | marks_values_19_first_s2_q;
  logic [10:0] select_477;
  assign select_477 = or_476 ? 11'h0 : delayed_column_q;
  // hls/stages/plane_sums.hpp:82
  logic or_478;
  assign or_478 = running_q | marks_values_19_first_s2_q;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_489;
  assign difference_489 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_0_features_right_q[5], entering_values_0_features_right_q};
  // hls/stages/plane_sums.hpp:63
  logic [2:0] select_496;
  assign select_496 = marks_values_0_first_q ? 3'h0 : arriving_rows_q;
  logic equal_497;
  assign equal_497 = select_496 == 3'h7;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_500;
  assign difference_500 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_0_features_right_q[5], leaving_values_0_features_right_q};
  logic [6:0] difference_514;
  assign difference_514 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_8_features_right_q[5], entering_values_8_features_right_q};
  logic [6:0] difference_522;
  assign difference_522 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_8_features_right_q[5], leaving_values_8_features_right_q};
  logic [6:0] difference_536;
  assign difference_536 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_12_features_right_q[5], entering_values_12_features_right_q};
  logic [6:0] difference_544;
  assign difference_544 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_12_features_right_q[5], leaving_values_12_features_right_q};
  logic [6:0] difference_558;
  assign difference_558 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_15_features_right_q[5], entering_values_15_features_right_q};
  logic [6:0] difference_566;
  assign difference_566 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_15_features_right_q[5], leaving_values_15_features_right_q};
  logic [6:0] difference_580;
  assign difference_580 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_16_features_right_q[5], entering_values_16_features_right_q};
  logic [6:0] difference_588;
  assign difference_588 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_16_features_right_q[5], leaving_values_16_features_right_q};
  logic [6:0] difference_602;
  assign difference_602 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_17_features_right_q[5], entering_values_17_features_right_q};
  logic [6:0] difference_610;
  assign difference_610 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_17_features_right_q[5], leaving_values_17_features_right_q};
  logic [6:0] difference_621;
  assign difference_621 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_18_features_right_q[5], entering_values_18_features_right_q};
  logic [6:0] difference_627;
  assign difference_627 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_18_features_right_q[5], leaving_values_18_features_right_q};
  logic [6:0] difference_640;
  assign difference_640 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_19_features_right_q[5], entering_values_19_features_right_q};
  logic [6:0] difference_648;
  assign difference_648 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_19_features_right_q[5], leaving_values_19_features_right_q};
  logic [6:0] difference_662;
  assign difference_662 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_20_features_right_q[5], entering_values_20_features_right_q};
  logic [6:0] difference_670;
  assign difference_670 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_20_features_right_q[5], leaving_values_20_features_right_q};
  logic [6:0] difference_684;
  assign difference_684 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_21_features_right_q[5], entering_values_21_features_right_q};
  logic [6:0] difference_692;
  assign difference_692 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_21_features_right_q[5], leaving_values_21_features_right_q};
  logic [6:0] difference_704;
  assign difference_704 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_24_features_right_q[5], entering_values_24_features_right_q};
  logic [6:0] difference_712;
  assign difference_712 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_24_features_right_q[5], leaving_values_24_features_right_q};
  logic [6:0] difference_725;
  assign difference_725 = {entering_values_17_features_left_s2_q[5], entering_values_17_features_left_s2_q} - {entering_values_28_features_right_q[5], entering_values_28_features_right_q};
  logic [6:0] difference_733;
  assign difference_733 = {leaving_values_17_features_left_s2_q[5], leaving_values_17_features_left_s2_q} - {leaving_values_28_features_right_q[5], leaving_values_28_features_right_q};
  logic [7:0] select_748;
  assign select_748 = difference_746_s2_q[6] ? (8'h0 - {difference_746_s2_q[6], difference_746_s2_q}) : {2'h0, difference_746_s2_q[5:0]};
  logic [4:0] difference_25;
  assign difference_25 = (select_748[7:5] == 3'h0) ? select_748[4:0] : 5'h1f;
  logic [7:0] select_756;
  assign select_756 = difference_754_s2_q[6] ? (8'h0 - {difference_754_s2_q[6], difference_754_s2_q}) : {2'h0, difference_754_s2_q[5:0]};
  logic [4:0] difference_26;
  assign difference_26 = (select_756[7:5] == 3'h0) ? select_756[4:0] : 5'h1f;
  // hls/stages/plane_sums.hpp:163
  logic [4:0] select_767;
  assign select_767 = entering_values_17_features_left_s2_q[5] ? (5'h0 - entering_values_17_features_left_s2_q[4:0]) : entering_values_17_features_left_s2_q[4:0];
  logic [4:0] select_770;
  assign select_770 = leaving_values_17_features_left_s2_q[5] ? (5'h0 - leaving_values_17_features_left_s2_q[4:0]) : leaving_values_17_features_left_s2_q[4:0];
  // hls/stages/plane_sums.hpp:63
  logic not_780;
  assign not_780 = ~equal_497;
  logic [2:0] select_782;
  assign select_782 = marks_values_0_last_q ? (select_496 + {2'h0, not_780}) : select_496;

  // Memory column_memory, 1920 x 143, DISTANCE 16, hls/stages/plane_sums.hpp:167; read in stage 2, written in stage 6: 2 < 6 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [142:0] column_memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) column_memory_mem[i] = 143'h0;
`endif
  logic [10:0] column_memory_raddr;
  assign column_memory_raddr = select_477;
  logic column_memory_re;
  assign column_memory_re = s2_en & or_478;
  logic [142:0] column_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (column_memory_re) column_memory_rdata_q <= column_memory_mem[column_memory_raddr];
  end

  // Memory feature_memory, write
  logic [10:0] feature_memory_waddr;
  assign feature_memory_waddr = select_474_s2_q;
  logic feature_memory_we;
  assign feature_memory_we = s2_en;
  always_ff @(posedge clk_i) begin
    if (feature_memory_we) feature_memory_mem[feature_memory_waddr] <= {feature_memory_rdata_s2_q[77:0], mask_s2_q, entering_values_0_features_right_q, entering_values_0_features_left_q};
  end
`ifndef SYNTHESIS
  logic [10:0] feature_memory_raddr_s1_sim;
  logic feature_memory_re_s1_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      feature_memory_re_s1_sim <= 1'b0;
    end else if (en_i) begin
      feature_memory_re_s1_sim <= feature_memory_re;
      feature_memory_raddr_s1_sim <= feature_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && feature_memory_we) begin
      if (feature_memory_re && feature_memory_raddr == feature_memory_waddr) begin
        $error("feature_memory: address %0d is read less than DISTANCE steps after its write", feature_memory_waddr);
      end
      if (feature_memory_re_s1_sim && feature_memory_raddr_s1_sim == feature_memory_waddr) begin
        $error("feature_memory: address %0d is read less than DISTANCE steps after its write", feature_memory_waddr);
      end
      if (feature_memory_waddr >= 11'd1920) $error("feature_memory: write outside, address %0d", feature_memory_waddr);
    end
    if (rst_ni && feature_memory_re && feature_memory_raddr >= 11'd1920) $error("feature_memory: read outside, address %0d", feature_memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      arriving_rows_q <= 3'h0;
      delayed_column_q <= 11'h0;
      delayed_row_ended_q <= 1'b1;
      running_q <= 1'b0;
    end else if (s2_en) begin
      arriving_rows_q <= select_782;
      delayed_column_q <= select_477 + 11'h1;
      delayed_row_ended_q <= marks_values_19_last_s2_q;
      running_q <= or_478;
    end
  end

  logic mask_s3_q;
  logic marks_values_19_first_s3_q;
  logic [5:0] seen_values_18_grey_s3_q;
  logic seen_values_18_exists_s3_q;
  logic or_473_s3_q;
  logic or_476_s3_q;
  logic [10:0] select_477_s3_q;
  logic [6:0] difference_489_s3_q;
  logic and_498_s3_q;
  logic [6:0] difference_500_s3_q;
  logic [6:0] difference_514_s3_q;
  logic [6:0] difference_522_s3_q;
  logic [6:0] difference_536_s3_q;
  logic [6:0] difference_544_s3_q;
  logic [6:0] difference_558_s3_q;
  logic [6:0] difference_566_s3_q;
  logic [6:0] difference_580_s3_q;
  logic [6:0] difference_588_s3_q;
  logic [6:0] difference_602_s3_q;
  logic [6:0] difference_610_s3_q;
  logic [6:0] difference_621_s3_q;
  logic [6:0] difference_627_s3_q;
  logic [6:0] difference_640_s3_q;
  logic [6:0] difference_648_s3_q;
  logic [6:0] difference_662_s3_q;
  logic [6:0] difference_670_s3_q;
  logic [6:0] difference_684_s3_q;
  logic [6:0] difference_692_s3_q;
  logic [6:0] difference_704_s3_q;
  logic [6:0] difference_712_s3_q;
  logic [6:0] difference_725_s3_q;
  logic [6:0] difference_733_s3_q;
  logic [4:0] difference_25_s3_q;
  logic [4:0] difference_26_s3_q;
  logic [4:0] select_767_s3_q;
  logic [4:0] select_770_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      mask_s3_q <= mask_s2_q;
      marks_values_19_first_s3_q <= marks_values_19_first_s2_q;
      seen_values_18_grey_s3_q <= seen_values_18_grey_s2_q;
      seen_values_18_exists_s3_q <= seen_values_18_exists_s2_q;
      or_473_s3_q <= or_473_s2_q;
      or_476_s3_q <= or_476;
      select_477_s3_q <= select_477;
      difference_489_s3_q <= difference_489;
      and_498_s3_q <= feature_memory_rdata_s2_q[78] & equal_497;
      difference_500_s3_q <= difference_500;
      difference_514_s3_q <= difference_514;
      difference_522_s3_q <= difference_522;
      difference_536_s3_q <= difference_536;
      difference_544_s3_q <= difference_544;
      difference_558_s3_q <= difference_558;
      difference_566_s3_q <= difference_566;
      difference_580_s3_q <= difference_580;
      difference_588_s3_q <= difference_588;
      difference_602_s3_q <= difference_602;
      difference_610_s3_q <= difference_610;
      difference_621_s3_q <= difference_621;
      difference_627_s3_q <= difference_627;
      difference_640_s3_q <= difference_640;
      difference_648_s3_q <= difference_648;
      difference_662_s3_q <= difference_662;
      difference_670_s3_q <= difference_670;
      difference_684_s3_q <= difference_684;
      difference_692_s3_q <= difference_692;
      difference_704_s3_q <= difference_704;
      difference_712_s3_q <= difference_712;
      difference_725_s3_q <= difference_725;
      difference_733_s3_q <= difference_733;
      difference_25_s3_q <= difference_25;
      difference_26_s3_q <= difference_26;
      select_767_s3_q <= select_767;
      select_770_s3_q <= select_770;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic row_parity_q;
  logic entering_values_0_features_mask_q;
  logic entering_values_1_features_mask_q;
  logic entering_values_1_row_q;
  logic entering_values_2_features_mask_q;
  logic entering_values_2_row_q;
  logic entering_values_3_features_mask_q;
  logic entering_values_3_row_q;
  logic entering_values_4_features_mask_q;
  logic entering_values_4_row_q;
  logic entering_values_5_features_mask_q;
  logic entering_values_5_row_q;
  logic entering_values_6_features_mask_q;
  logic entering_values_6_row_q;
  logic entering_values_7_features_mask_q;
  logic entering_values_7_row_q;
  logic entering_values_8_features_mask_q;
  logic entering_values_8_row_q;
  logic entering_values_9_features_mask_q;
  logic entering_values_9_row_q;
  logic entering_values_10_features_mask_q;
  logic entering_values_10_row_q;
  logic entering_values_11_features_mask_q;
  logic entering_values_11_row_q;
  logic entering_values_12_features_mask_q;
  logic entering_values_12_row_q;
  logic entering_values_13_features_mask_q;
  logic entering_values_13_row_q;
  logic entering_values_14_features_mask_q;
  logic entering_values_14_row_q;
  logic entering_values_15_features_mask_q;
  logic entering_values_15_row_q;
  logic entering_values_16_features_mask_q;
  logic entering_values_16_row_q;
  logic entering_values_17_features_mask_q;
  logic entering_values_17_row_q;
  logic entering_values_18_features_mask_q;
  logic entering_values_18_row_q;
  logic entering_values_19_features_mask_q;
  logic entering_values_19_row_q;
  logic entering_values_20_features_mask_q;
  logic entering_values_20_row_q;
  logic entering_values_21_features_mask_q;
  logic entering_values_21_row_q;
  logic entering_values_22_features_mask_q;
  logic entering_values_22_row_q;
  logic entering_values_23_features_mask_q;
  logic entering_values_23_row_q;
  logic entering_values_24_features_mask_q;
  logic entering_values_24_row_q;
  logic entering_values_25_features_mask_q;
  logic entering_values_25_row_q;
  logic entering_values_26_features_mask_q;
  logic entering_values_26_row_q;
  logic entering_values_27_features_mask_q;
  logic entering_values_27_row_q;
  logic entering_values_28_features_mask_q;
  logic entering_values_28_row_q;
  logic entering_values_29_features_mask_q;
  logic entering_values_29_row_q;
  logic entering_values_30_features_mask_q;
  logic entering_values_30_row_q;
  logic entering_values_31_features_mask_q;
  logic entering_values_31_row_q;
  logic entering_values_32_features_mask_q;
  logic entering_values_32_row_q;
  logic entering_values_33_features_mask_q;
  logic entering_values_33_row_q;
  logic entering_values_34_features_mask_q;
  logic entering_values_34_row_q;
  logic entering_values_35_features_mask_q;
  logic entering_values_35_row_q;
  logic leaving_values_0_features_mask_q;
  logic leaving_values_1_features_mask_q;
  logic leaving_values_2_features_mask_q;
  logic leaving_values_3_features_mask_q;
  logic leaving_values_4_features_mask_q;
  logic leaving_values_5_features_mask_q;
  logic leaving_values_6_features_mask_q;
  logic leaving_values_7_features_mask_q;
  logic leaving_values_8_features_mask_q;
  logic leaving_values_9_features_mask_q;
  logic leaving_values_10_features_mask_q;
  logic leaving_values_11_features_mask_q;
  logic leaving_values_12_features_mask_q;
  logic leaving_values_13_features_mask_q;
  logic leaving_values_14_features_mask_q;
  logic leaving_values_15_features_mask_q;
  logic leaving_values_16_features_mask_q;
  logic leaving_values_17_features_mask_q;
  logic leaving_values_18_features_mask_q;
  logic leaving_values_19_features_mask_q;
  logic leaving_values_20_features_mask_q;
  logic leaving_values_21_features_mask_q;
  logic leaving_values_22_features_mask_q;
  logic leaving_values_23_features_mask_q;
  logic leaving_values_24_features_mask_q;
  logic leaving_values_25_features_mask_q;
  logic leaving_values_26_features_mask_q;
  logic leaving_values_27_features_mask_q;
  logic leaving_values_28_features_mask_q;
  logic leaving_values_29_features_mask_q;
  logic leaving_values_30_features_mask_q;
  logic leaving_values_31_features_mask_q;
  logic leaving_values_32_features_mask_q;
  logic leaving_values_33_features_mask_q;
  logic leaving_values_34_features_mask_q;
  logic leaving_values_35_features_mask_q;
  logic centre_marks_values_0_first_q;
  logic centre_marks_values_0_last_q;
  logic centre_marks_values_1_first_q;
  logic centre_marks_values_1_last_q;
  logic centre_marks_values_2_first_q;
  logic centre_marks_values_2_last_q;
  logic centre_marks_values_3_first_q;
  logic centre_marks_values_3_last_q;
  // hls/stages/plane_sums.hpp:156
  logic [7:0] select_491;
  assign select_491 = difference_489_s3_q[6] ? (8'h0 - {difference_489_s3_q[6], difference_489_s3_q}) : {2'h0, difference_489_s3_q[5:0]};
  logic [4:0] difference;
  assign difference = (select_491[7:5] == 3'h0) ? select_491[4:0] : 5'h1f;
  logic [7:0] select_502;
  assign select_502 = difference_500_s3_q[6] ? (8'h0 - {difference_500_s3_q[6], difference_500_s3_q}) : {2'h0, difference_500_s3_q[5:0]};
  logic [4:0] difference_2;
  assign difference_2 = (select_502[7:5] == 3'h0) ? select_502[4:0] : 5'h1f;
  logic [7:0] select_516;
  assign select_516 = difference_514_s3_q[6] ? (8'h0 - {difference_514_s3_q[6], difference_514_s3_q}) : {2'h0, difference_514_s3_q[5:0]};
  logic [4:0] difference_3;
  assign difference_3 = (select_516[7:5] == 3'h0) ? select_516[4:0] : 5'h1f;
  logic [7:0] select_524;
  assign select_524 = difference_522_s3_q[6] ? (8'h0 - {difference_522_s3_q[6], difference_522_s3_q}) : {2'h0, difference_522_s3_q[5:0]};
  logic [4:0] difference_4;
  assign difference_4 = (select_524[7:5] == 3'h0) ? select_524[4:0] : 5'h1f;
  logic [7:0] select_538;
  assign select_538 = difference_536_s3_q[6] ? (8'h0 - {difference_536_s3_q[6], difference_536_s3_q}) : {2'h0, difference_536_s3_q[5:0]};
  logic [4:0] difference_5;
  assign difference_5 = (select_538[7:5] == 3'h0) ? select_538[4:0] : 5'h1f;
  logic [7:0] select_546;
  assign select_546 = difference_544_s3_q[6] ? (8'h0 - {difference_544_s3_q[6], difference_544_s3_q}) : {2'h0, difference_544_s3_q[5:0]};
  logic [4:0] difference_6;
  assign difference_6 = (select_546[7:5] == 3'h0) ? select_546[4:0] : 5'h1f;
  logic [7:0] select_560;
  assign select_560 = difference_558_s3_q[6] ? (8'h0 - {difference_558_s3_q[6], difference_558_s3_q}) : {2'h0, difference_558_s3_q[5:0]};
  logic [4:0] difference_7;
  assign difference_7 = (select_560[7:5] == 3'h0) ? select_560[4:0] : 5'h1f;
  logic [7:0] select_568;
  assign select_568 = difference_566_s3_q[6] ? (8'h0 - {difference_566_s3_q[6], difference_566_s3_q}) : {2'h0, difference_566_s3_q[5:0]};
  logic [4:0] difference_8;
  assign difference_8 = (select_568[7:5] == 3'h0) ? select_568[4:0] : 5'h1f;
  logic [7:0] select_582;
  assign select_582 = difference_580_s3_q[6] ? (8'h0 - {difference_580_s3_q[6], difference_580_s3_q}) : {2'h0, difference_580_s3_q[5:0]};
  logic [4:0] difference_9;
  assign difference_9 = (select_582[7:5] == 3'h0) ? select_582[4:0] : 5'h1f;
  logic [7:0] select_590;
  assign select_590 = difference_588_s3_q[6] ? (8'h0 - {difference_588_s3_q[6], difference_588_s3_q}) : {2'h0, difference_588_s3_q[5:0]};
  logic [4:0] difference_10;
  assign difference_10 = (select_590[7:5] == 3'h0) ? select_590[4:0] : 5'h1f;
  logic [7:0] select_604;
  assign select_604 = difference_602_s3_q[6] ? (8'h0 - {difference_602_s3_q[6], difference_602_s3_q}) : {2'h0, difference_602_s3_q[5:0]};
  logic [4:0] difference_11;
  assign difference_11 = (select_604[7:5] == 3'h0) ? select_604[4:0] : 5'h1f;
  logic [7:0] select_612;
  assign select_612 = difference_610_s3_q[6] ? (8'h0 - {difference_610_s3_q[6], difference_610_s3_q}) : {2'h0, difference_610_s3_q[5:0]};
  logic [4:0] difference_12;
  assign difference_12 = (select_612[7:5] == 3'h0) ? select_612[4:0] : 5'h1f;
  logic [7:0] select_623;
  assign select_623 = difference_621_s3_q[6] ? (8'h0 - {difference_621_s3_q[6], difference_621_s3_q}) : {2'h0, difference_621_s3_q[5:0]};
  logic [4:0] difference_13;
  assign difference_13 = (select_623[7:5] == 3'h0) ? select_623[4:0] : 5'h1f;
  logic [7:0] select_629;
  assign select_629 = difference_627_s3_q[6] ? (8'h0 - {difference_627_s3_q[6], difference_627_s3_q}) : {2'h0, difference_627_s3_q[5:0]};
  logic [4:0] difference_14;
  assign difference_14 = (select_629[7:5] == 3'h0) ? select_629[4:0] : 5'h1f;
  logic [7:0] select_642;
  assign select_642 = difference_640_s3_q[6] ? (8'h0 - {difference_640_s3_q[6], difference_640_s3_q}) : {2'h0, difference_640_s3_q[5:0]};
  logic [4:0] difference_15;
  assign difference_15 = (select_642[7:5] == 3'h0) ? select_642[4:0] : 5'h1f;
  logic [7:0] select_650;
  assign select_650 = difference_648_s3_q[6] ? (8'h0 - {difference_648_s3_q[6], difference_648_s3_q}) : {2'h0, difference_648_s3_q[5:0]};
  logic [4:0] difference_16;
  assign difference_16 = (select_650[7:5] == 3'h0) ? select_650[4:0] : 5'h1f;
  logic [7:0] select_664;
  assign select_664 = difference_662_s3_q[6] ? (8'h0 - {difference_662_s3_q[6], difference_662_s3_q}) : {2'h0, difference_662_s3_q[5:0]};
  logic [4:0] difference_17;
  assign difference_17 = (select_664[7:5] == 3'h0) ? select_664[4:0] : 5'h1f;
  logic [7:0] select_672;
  assign select_672 = difference_670_s3_q[6] ? (8'h0 - {difference_670_s3_q[6], difference_670_s3_q}) : {2'h0, difference_670_s3_q[5:0]};
  logic [4:0] difference_18;
  assign difference_18 = (select_672[7:5] == 3'h0) ? select_672[4:0] : 5'h1f;
  logic [7:0] select_686;
  assign select_686 = difference_684_s3_q[6] ? (8'h0 - {difference_684_s3_q[6], difference_684_s3_q}) : {2'h0, difference_684_s3_q[5:0]};
  logic [4:0] difference_19;
  assign difference_19 = (select_686[7:5] == 3'h0) ? select_686[4:0] : 5'h1f;
  logic [7:0] select_694;
  assign select_694 = difference_692_s3_q[6] ? (8'h0 - {difference_692_s3_q[6], difference_692_s3_q}) : {2'h0, difference_692_s3_q[5:0]};
  logic [4:0] difference_20;
  assign difference_20 = (select_694[7:5] == 3'h0) ? select_694[4:0] : 5'h1f;
  logic [7:0] select_706;
  assign select_706 = difference_704_s3_q[6] ? (8'h0 - {difference_704_s3_q[6], difference_704_s3_q}) : {2'h0, difference_704_s3_q[5:0]};
  logic [4:0] difference_21;
  assign difference_21 = (select_706[7:5] == 3'h0) ? select_706[4:0] : 5'h1f;
  logic [7:0] select_714;
  assign select_714 = difference_712_s3_q[6] ? (8'h0 - {difference_712_s3_q[6], difference_712_s3_q}) : {2'h0, difference_712_s3_q[5:0]};
  logic [4:0] difference_22;
  assign difference_22 = (select_714[7:5] == 3'h0) ? select_714[4:0] : 5'h1f;
  logic [7:0] select_727;
  assign select_727 = difference_725_s3_q[6] ? (8'h0 - {difference_725_s3_q[6], difference_725_s3_q}) : {2'h0, difference_725_s3_q[5:0]};
  logic [4:0] difference_23;
  assign difference_23 = (select_727[7:5] == 3'h0) ? select_727[4:0] : 5'h1f;
  logic [7:0] select_735;
  assign select_735 = difference_733_s3_q[6] ? (8'h0 - {difference_733_s3_q[6], difference_733_s3_q}) : {2'h0, difference_733_s3_q[5:0]};
  logic [4:0] difference_24;
  assign difference_24 = (select_735[7:5] == 3'h0) ? select_735[4:0] : 5'h1f;
  // hls/stages/plane_sums.hpp:157
  logic xor_745;
  assign xor_745 = entering_values_17_row_q ^ entering_values_35_row_q;
  // hls/stages/plane_sums.hpp:87
  logic [4:0] select_752;
  assign select_752 = entering_values_35_features_mask_q ? (xor_745 ? 5'h1f : difference_25_s3_q) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_753;
  assign select_753 = entering_values_17_features_mask_q ? select_752 : 5'h0;
  // hls/stages/plane_sums.hpp:88
  logic [4:0] select_760;
  assign select_760 = leaving_values_35_features_mask_q ? (xor_745 ? 5'h1f : difference_26_s3_q) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_761;
  assign select_761 = leaving_values_17_features_mask_q ? select_760 : 5'h0;
  logic [4:0] select_768;
  assign select_768 = entering_values_17_features_mask_q ? select_767_s3_q : 5'h0;
  logic [4:0] select_771;
  assign select_771 = leaving_values_17_features_mask_q ? select_770_s3_q : 5'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_parity_q <= 1'b0;
      entering_values_0_features_mask_q <= 1'b0;
      entering_values_1_features_mask_q <= 1'b0;
      entering_values_1_row_q <= 1'b0;
      entering_values_2_features_mask_q <= 1'b0;
      entering_values_2_row_q <= 1'b0;
      entering_values_3_features_mask_q <= 1'b0;
      entering_values_3_row_q <= 1'b0;
      entering_values_4_features_mask_q <= 1'b0;
      entering_values_4_row_q <= 1'b0;
      entering_values_5_features_mask_q <= 1'b0;
      entering_values_5_row_q <= 1'b0;
      entering_values_6_features_mask_q <= 1'b0;
      entering_values_6_row_q <= 1'b0;
      entering_values_7_features_mask_q <= 1'b0;
      entering_values_7_row_q <= 1'b0;
      entering_values_8_features_mask_q <= 1'b0;
      entering_values_8_row_q <= 1'b0;
      entering_values_9_features_mask_q <= 1'b0;
      entering_values_9_row_q <= 1'b0;
      entering_values_10_features_mask_q <= 1'b0;
      entering_values_10_row_q <= 1'b0;
      entering_values_11_features_mask_q <= 1'b0;
      entering_values_11_row_q <= 1'b0;
      entering_values_12_features_mask_q <= 1'b0;
      entering_values_12_row_q <= 1'b0;
      entering_values_13_features_mask_q <= 1'b0;
      entering_values_13_row_q <= 1'b0;
      entering_values_14_features_mask_q <= 1'b0;
      entering_values_14_row_q <= 1'b0;
      entering_values_15_features_mask_q <= 1'b0;
      entering_values_15_row_q <= 1'b0;
      entering_values_16_features_mask_q <= 1'b0;
      entering_values_16_row_q <= 1'b0;
      entering_values_17_features_mask_q <= 1'b0;
      entering_values_17_row_q <= 1'b0;
      entering_values_18_features_mask_q <= 1'b0;
      entering_values_18_row_q <= 1'b0;
      entering_values_19_features_mask_q <= 1'b0;
      entering_values_19_row_q <= 1'b0;
      entering_values_20_features_mask_q <= 1'b0;
      entering_values_20_row_q <= 1'b0;
      entering_values_21_features_mask_q <= 1'b0;
      entering_values_21_row_q <= 1'b0;
      entering_values_22_features_mask_q <= 1'b0;
      entering_values_22_row_q <= 1'b0;
      entering_values_23_features_mask_q <= 1'b0;
      entering_values_23_row_q <= 1'b0;
      entering_values_24_features_mask_q <= 1'b0;
      entering_values_24_row_q <= 1'b0;
      entering_values_25_features_mask_q <= 1'b0;
      entering_values_25_row_q <= 1'b0;
      entering_values_26_features_mask_q <= 1'b0;
      entering_values_26_row_q <= 1'b0;
      entering_values_27_features_mask_q <= 1'b0;
      entering_values_27_row_q <= 1'b0;
      entering_values_28_features_mask_q <= 1'b0;
      entering_values_28_row_q <= 1'b0;
      entering_values_29_features_mask_q <= 1'b0;
      entering_values_29_row_q <= 1'b0;
      entering_values_30_features_mask_q <= 1'b0;
      entering_values_30_row_q <= 1'b0;
      entering_values_31_features_mask_q <= 1'b0;
      entering_values_31_row_q <= 1'b0;
      entering_values_32_features_mask_q <= 1'b0;
      entering_values_32_row_q <= 1'b0;
      entering_values_33_features_mask_q <= 1'b0;
      entering_values_33_row_q <= 1'b0;
      entering_values_34_features_mask_q <= 1'b0;
      entering_values_34_row_q <= 1'b0;
      entering_values_35_features_mask_q <= 1'b0;
      entering_values_35_row_q <= 1'b0;
      leaving_values_0_features_mask_q <= 1'b0;
      leaving_values_1_features_mask_q <= 1'b0;
      leaving_values_2_features_mask_q <= 1'b0;
      leaving_values_3_features_mask_q <= 1'b0;
      leaving_values_4_features_mask_q <= 1'b0;
      leaving_values_5_features_mask_q <= 1'b0;
      leaving_values_6_features_mask_q <= 1'b0;
      leaving_values_7_features_mask_q <= 1'b0;
      leaving_values_8_features_mask_q <= 1'b0;
      leaving_values_9_features_mask_q <= 1'b0;
      leaving_values_10_features_mask_q <= 1'b0;
      leaving_values_11_features_mask_q <= 1'b0;
      leaving_values_12_features_mask_q <= 1'b0;
      leaving_values_13_features_mask_q <= 1'b0;
      leaving_values_14_features_mask_q <= 1'b0;
      leaving_values_15_features_mask_q <= 1'b0;
      leaving_values_16_features_mask_q <= 1'b0;
      leaving_values_17_features_mask_q <= 1'b0;
      leaving_values_18_features_mask_q <= 1'b0;
      leaving_values_19_features_mask_q <= 1'b0;
      leaving_values_20_features_mask_q <= 1'b0;
      leaving_values_21_features_mask_q <= 1'b0;
      leaving_values_22_features_mask_q <= 1'b0;
      leaving_values_23_features_mask_q <= 1'b0;
      leaving_values_24_features_mask_q <= 1'b0;
      leaving_values_25_features_mask_q <= 1'b0;
      leaving_values_26_features_mask_q <= 1'b0;
      leaving_values_27_features_mask_q <= 1'b0;
      leaving_values_28_features_mask_q <= 1'b0;
      leaving_values_29_features_mask_q <= 1'b0;
      leaving_values_30_features_mask_q <= 1'b0;
      leaving_values_31_features_mask_q <= 1'b0;
      leaving_values_32_features_mask_q <= 1'b0;
      leaving_values_33_features_mask_q <= 1'b0;
      leaving_values_34_features_mask_q <= 1'b0;
      leaving_values_35_features_mask_q <= 1'b0;
      centre_marks_values_0_first_q <= 1'b0;
      centre_marks_values_0_last_q <= 1'b0;
      centre_marks_values_1_first_q <= 1'b0;
      centre_marks_values_1_last_q <= 1'b0;
      centre_marks_values_2_first_q <= 1'b0;
      centre_marks_values_2_last_q <= 1'b0;
      centre_marks_values_3_first_q <= 1'b0;
      centre_marks_values_3_last_q <= 1'b0;
    end else if (s3_en) begin
      row_parity_q <= row_parity_q ^ or_473_s3_q;
      entering_values_0_features_mask_q <= mask_s3_q;
      entering_values_1_features_mask_q <= entering_values_0_features_mask_q;
      entering_values_1_row_q <= row_parity_q;
      entering_values_2_features_mask_q <= entering_values_1_features_mask_q;
      entering_values_2_row_q <= entering_values_1_row_q;
      entering_values_3_features_mask_q <= entering_values_2_features_mask_q;
      entering_values_3_row_q <= entering_values_2_row_q;
      entering_values_4_features_mask_q <= entering_values_3_features_mask_q;
      entering_values_4_row_q <= entering_values_3_row_q;
      entering_values_5_features_mask_q <= entering_values_4_features_mask_q;
      entering_values_5_row_q <= entering_values_4_row_q;
      entering_values_6_features_mask_q <= entering_values_5_features_mask_q;
      entering_values_6_row_q <= entering_values_5_row_q;
      entering_values_7_features_mask_q <= entering_values_6_features_mask_q;
      entering_values_7_row_q <= entering_values_6_row_q;
      entering_values_8_features_mask_q <= entering_values_7_features_mask_q;
      entering_values_8_row_q <= entering_values_7_row_q;
      entering_values_9_features_mask_q <= entering_values_8_features_mask_q;
      entering_values_9_row_q <= entering_values_8_row_q;
      entering_values_10_features_mask_q <= entering_values_9_features_mask_q;
      entering_values_10_row_q <= entering_values_9_row_q;
      entering_values_11_features_mask_q <= entering_values_10_features_mask_q;
      entering_values_11_row_q <= entering_values_10_row_q;
      entering_values_12_features_mask_q <= entering_values_11_features_mask_q;
      entering_values_12_row_q <= entering_values_11_row_q;
      entering_values_13_features_mask_q <= entering_values_12_features_mask_q;
      entering_values_13_row_q <= entering_values_12_row_q;
      entering_values_14_features_mask_q <= entering_values_13_features_mask_q;
      entering_values_14_row_q <= entering_values_13_row_q;
      entering_values_15_features_mask_q <= entering_values_14_features_mask_q;
      entering_values_15_row_q <= entering_values_14_row_q;
      entering_values_16_features_mask_q <= entering_values_15_features_mask_q;
      entering_values_16_row_q <= entering_values_15_row_q;
      entering_values_17_features_mask_q <= entering_values_16_features_mask_q;
      entering_values_17_row_q <= entering_values_16_row_q;
      entering_values_18_features_mask_q <= entering_values_17_features_mask_q;
      entering_values_18_row_q <= entering_values_17_row_q;
      entering_values_19_features_mask_q <= entering_values_18_features_mask_q;
      entering_values_19_row_q <= entering_values_18_row_q;
      entering_values_20_features_mask_q <= entering_values_19_features_mask_q;
      entering_values_20_row_q <= entering_values_19_row_q;
      entering_values_21_features_mask_q <= entering_values_20_features_mask_q;
      entering_values_21_row_q <= entering_values_20_row_q;
      entering_values_22_features_mask_q <= entering_values_21_features_mask_q;
      entering_values_22_row_q <= entering_values_21_row_q;
      entering_values_23_features_mask_q <= entering_values_22_features_mask_q;
      entering_values_23_row_q <= entering_values_22_row_q;
      entering_values_24_features_mask_q <= entering_values_23_features_mask_q;
      entering_values_24_row_q <= entering_values_23_row_q;
      entering_values_25_features_mask_q <= entering_values_24_features_mask_q;
      entering_values_25_row_q <= entering_values_24_row_q;
      entering_values_26_features_mask_q <= entering_values_25_features_mask_q;
      entering_values_26_row_q <= entering_values_25_row_q;
      entering_values_27_features_mask_q <= entering_values_26_features_mask_q;
      entering_values_27_row_q <= entering_values_26_row_q;
      entering_values_28_features_mask_q <= entering_values_27_features_mask_q;
      entering_values_28_row_q <= entering_values_27_row_q;
      entering_values_29_features_mask_q <= entering_values_28_features_mask_q;
      entering_values_29_row_q <= entering_values_28_row_q;
      entering_values_30_features_mask_q <= entering_values_29_features_mask_q;
      entering_values_30_row_q <= entering_values_29_row_q;
      entering_values_31_features_mask_q <= entering_values_30_features_mask_q;
      entering_values_31_row_q <= entering_values_30_row_q;
      entering_values_32_features_mask_q <= entering_values_31_features_mask_q;
      entering_values_32_row_q <= entering_values_31_row_q;
      entering_values_33_features_mask_q <= entering_values_32_features_mask_q;
      entering_values_33_row_q <= entering_values_32_row_q;
      entering_values_34_features_mask_q <= entering_values_33_features_mask_q;
      entering_values_34_row_q <= entering_values_33_row_q;
      entering_values_35_features_mask_q <= entering_values_34_features_mask_q;
      entering_values_35_row_q <= entering_values_34_row_q;
      leaving_values_0_features_mask_q <= and_498_s3_q;
      leaving_values_1_features_mask_q <= leaving_values_0_features_mask_q;
      leaving_values_2_features_mask_q <= leaving_values_1_features_mask_q;
      leaving_values_3_features_mask_q <= leaving_values_2_features_mask_q;
      leaving_values_4_features_mask_q <= leaving_values_3_features_mask_q;
      leaving_values_5_features_mask_q <= leaving_values_4_features_mask_q;
      leaving_values_6_features_mask_q <= leaving_values_5_features_mask_q;
      leaving_values_7_features_mask_q <= leaving_values_6_features_mask_q;
      leaving_values_8_features_mask_q <= leaving_values_7_features_mask_q;
      leaving_values_9_features_mask_q <= leaving_values_8_features_mask_q;
      leaving_values_10_features_mask_q <= leaving_values_9_features_mask_q;
      leaving_values_11_features_mask_q <= leaving_values_10_features_mask_q;
      leaving_values_12_features_mask_q <= leaving_values_11_features_mask_q;
      leaving_values_13_features_mask_q <= leaving_values_12_features_mask_q;
      leaving_values_14_features_mask_q <= leaving_values_13_features_mask_q;
      leaving_values_15_features_mask_q <= leaving_values_14_features_mask_q;
      leaving_values_16_features_mask_q <= leaving_values_15_features_mask_q;
      leaving_values_17_features_mask_q <= leaving_values_16_features_mask_q;
      leaving_values_18_features_mask_q <= leaving_values_17_features_mask_q;
      leaving_values_19_features_mask_q <= leaving_values_18_features_mask_q;
      leaving_values_20_features_mask_q <= leaving_values_19_features_mask_q;
      leaving_values_21_features_mask_q <= leaving_values_20_features_mask_q;
      leaving_values_22_features_mask_q <= leaving_values_21_features_mask_q;
      leaving_values_23_features_mask_q <= leaving_values_22_features_mask_q;
      leaving_values_24_features_mask_q <= leaving_values_23_features_mask_q;
      leaving_values_25_features_mask_q <= leaving_values_24_features_mask_q;
      leaving_values_26_features_mask_q <= leaving_values_25_features_mask_q;
      leaving_values_27_features_mask_q <= leaving_values_26_features_mask_q;
      leaving_values_28_features_mask_q <= leaving_values_27_features_mask_q;
      leaving_values_29_features_mask_q <= leaving_values_28_features_mask_q;
      leaving_values_30_features_mask_q <= leaving_values_29_features_mask_q;
      leaving_values_31_features_mask_q <= leaving_values_30_features_mask_q;
      leaving_values_32_features_mask_q <= leaving_values_31_features_mask_q;
      leaving_values_33_features_mask_q <= leaving_values_32_features_mask_q;
      leaving_values_34_features_mask_q <= leaving_values_33_features_mask_q;
      leaving_values_35_features_mask_q <= leaving_values_34_features_mask_q;
      centre_marks_values_0_first_q <= marks_values_19_first_s3_q;
      centre_marks_values_0_last_q <= delayed_row_ended_q;
      centre_marks_values_1_first_q <= centre_marks_values_0_first_q;
      centre_marks_values_1_last_q <= centre_marks_values_0_last_q;
      centre_marks_values_2_first_q <= centre_marks_values_1_first_q;
      centre_marks_values_2_last_q <= centre_marks_values_1_last_q;
      centre_marks_values_3_first_q <= centre_marks_values_2_first_q;
      centre_marks_values_3_last_q <= centre_marks_values_2_last_q;
    end
  end

  logic [5:0] seen_values_18_grey_s4_q;
  logic seen_values_18_exists_s4_q;
  logic centre_marks_values_3_first_s4_q;
  logic centre_marks_values_3_last_s4_q;
  logic or_476_s4_q;
  logic [10:0] select_477_s4_q;
  logic or_478_s4_q;
  logic [142:0] column_memory_rdata_s4_q;
  logic not_487_s4_q;
  logic [4:0] difference_s4_q;
  logic [4:0] difference_2_s4_q;
  logic [4:0] difference_3_s4_q;
  logic [4:0] difference_4_s4_q;
  logic [4:0] difference_5_s4_q;
  logic [4:0] difference_6_s4_q;
  logic [4:0] difference_7_s4_q;
  logic [4:0] difference_8_s4_q;
  logic [4:0] difference_9_s4_q;
  logic [4:0] difference_10_s4_q;
  logic [4:0] difference_11_s4_q;
  logic [4:0] difference_12_s4_q;
  logic [4:0] difference_13_s4_q;
  logic [4:0] difference_14_s4_q;
  logic [4:0] difference_15_s4_q;
  logic [4:0] difference_16_s4_q;
  logic [4:0] difference_17_s4_q;
  logic [4:0] difference_18_s4_q;
  logic [4:0] difference_19_s4_q;
  logic [4:0] difference_20_s4_q;
  logic [4:0] difference_21_s4_q;
  logic [4:0] difference_22_s4_q;
  logic [4:0] difference_23_s4_q;
  logic [4:0] difference_24_s4_q;
  logic [5:0] difference_762_s4_q;
  logic [5:0] difference_772_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      seen_values_18_grey_s4_q <= seen_values_18_grey_s3_q;
      seen_values_18_exists_s4_q <= seen_values_18_exists_s3_q;
      centre_marks_values_3_first_s4_q <= centre_marks_values_3_first_q;
      centre_marks_values_3_last_s4_q <= centre_marks_values_3_last_q;
      or_476_s4_q <= or_476_s3_q;
      select_477_s4_q <= select_477_s3_q;
      or_478_s4_q <= running_q;
      column_memory_rdata_s4_q <= column_memory_rdata_q;
      not_487_s4_q <= ~(^{or_473_s3_q, entering_values_17_row_q, row_parity_q});
      difference_s4_q <= difference;
      difference_2_s4_q <= difference_2;
      difference_3_s4_q <= difference_3;
      difference_4_s4_q <= difference_4;
      difference_5_s4_q <= difference_5;
      difference_6_s4_q <= difference_6;
      difference_7_s4_q <= difference_7;
      difference_8_s4_q <= difference_8;
      difference_9_s4_q <= difference_9;
      difference_10_s4_q <= difference_10;
      difference_11_s4_q <= difference_11;
      difference_12_s4_q <= difference_12;
      difference_13_s4_q <= difference_13;
      difference_14_s4_q <= difference_14;
      difference_15_s4_q <= difference_15;
      difference_16_s4_q <= difference_16;
      difference_17_s4_q <= difference_17;
      difference_18_s4_q <= difference_18;
      difference_19_s4_q <= difference_19;
      difference_20_s4_q <= difference_20;
      difference_21_s4_q <= difference_21;
      difference_22_s4_q <= difference_22;
      difference_23_s4_q <= difference_23;
      difference_24_s4_q <= difference_24;
      difference_762_s4_q <= {1'b0, select_753} - {1'b0, select_761};
      difference_772_s4_q <= {1'b0, select_768} - {1'b0, select_771};
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [2:0] delayed_rows_q;
  logic [5:0] centres_values_0_seen_grey_q;
  logic centres_values_0_seen_exists_q;
  logic centres_values_0_gradient_q;
  logic [5:0] centres_values_1_seen_grey_q;
  logic centres_values_1_seen_exists_q;
  logic centres_values_1_gradient_q;
  logic [5:0] centres_values_2_seen_grey_q;
  logic centres_values_2_seen_exists_q;
  logic centres_values_2_gradient_q;
  logic [5:0] centres_values_3_seen_grey_q;
  logic centres_values_3_seen_exists_q;
  logic centres_values_3_gradient_q;
  logic rows_seen_values_0_q;
  logic rows_seen_values_1_q;
  logic rows_seen_values_2_q;
  logic rows_seen_values_3_q;
  // hls/stages/plane_sums.hpp:81
  logic [2:0] select_480;
  assign select_480 = centre_marks_values_0_first_q ? 3'h0 : delayed_rows_q;
  logic equal_481;
  assign equal_481 = select_480 == 3'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above;
  assign above = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[7:0] : 8'h0);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_494;
  assign select_494 = (entering_values_0_features_mask_q & not_487_s4_q) ? difference_s4_q : 5'h1f;
  logic [4:0] select_495;
  assign select_495 = entering_values_18_features_mask_q ? select_494 : 5'h0;
  logic [4:0] select_505;
  assign select_505 = (leaving_values_0_features_mask_q & not_487_s4_q) ? difference_2_s4_q : 5'h1f;
  logic [4:0] select_506;
  assign select_506 = leaving_values_18_features_mask_q ? select_505 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_2;
  assign above_2 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[15:8] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_512;
  assign not_512 = ~(entering_values_8_row_q ^ entering_values_18_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_519;
  assign select_519 = (entering_values_8_features_mask_q & not_512) ? difference_3_s4_q : 5'h1f;
  logic [4:0] select_520;
  assign select_520 = entering_values_18_features_mask_q ? select_519 : 5'h0;
  logic [4:0] select_527;
  assign select_527 = (leaving_values_8_features_mask_q & not_512) ? difference_4_s4_q : 5'h1f;
  logic [4:0] select_528;
  assign select_528 = leaving_values_18_features_mask_q ? select_527 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_3;
  assign above_3 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[23:16] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_534;
  assign not_534 = ~(entering_values_12_row_q ^ entering_values_18_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_541;
  assign select_541 = (entering_values_12_features_mask_q & not_534) ? difference_5_s4_q : 5'h1f;
  logic [4:0] select_542;
  assign select_542 = entering_values_18_features_mask_q ? select_541 : 5'h0;
  logic [4:0] select_549;
  assign select_549 = (leaving_values_12_features_mask_q & not_534) ? difference_6_s4_q : 5'h1f;
  logic [4:0] select_550;
  assign select_550 = leaving_values_18_features_mask_q ? select_549 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_4;
  assign above_4 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[31:24] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_556;
  assign not_556 = ~(entering_values_15_row_q ^ entering_values_18_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_563;
  assign select_563 = (entering_values_15_features_mask_q & not_556) ? difference_7_s4_q : 5'h1f;
  logic [4:0] select_564;
  assign select_564 = entering_values_18_features_mask_q ? select_563 : 5'h0;
  logic [4:0] select_571;
  assign select_571 = (leaving_values_15_features_mask_q & not_556) ? difference_8_s4_q : 5'h1f;
  logic [4:0] select_572;
  assign select_572 = leaving_values_18_features_mask_q ? select_571 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_5;
  assign above_5 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[39:32] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_578;
  assign not_578 = ~(entering_values_16_row_q ^ entering_values_18_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_585;
  assign select_585 = (entering_values_16_features_mask_q & not_578) ? difference_9_s4_q : 5'h1f;
  logic [4:0] select_586;
  assign select_586 = entering_values_18_features_mask_q ? select_585 : 5'h0;
  logic [4:0] select_593;
  assign select_593 = (leaving_values_16_features_mask_q & not_578) ? difference_10_s4_q : 5'h1f;
  logic [4:0] select_594;
  assign select_594 = leaving_values_18_features_mask_q ? select_593 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_6;
  assign above_6 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[47:40] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_600;
  assign not_600 = ~(entering_values_17_row_q ^ entering_values_18_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_607;
  assign select_607 = (entering_values_17_features_mask_q & not_600) ? difference_11_s4_q : 5'h1f;
  logic [4:0] select_608;
  assign select_608 = entering_values_18_features_mask_q ? select_607 : 5'h0;
  logic [4:0] select_615;
  assign select_615 = (leaving_values_17_features_mask_q & not_600) ? difference_12_s4_q : 5'h1f;
  logic [4:0] select_616;
  assign select_616 = leaving_values_18_features_mask_q ? select_615 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_7;
  assign above_7 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[55:48] : 8'h0);
  // hls/stages/plane_sums.hpp:158
  logic [4:0] select_626;
  assign select_626 = entering_values_18_features_mask_q ? difference_13_s4_q : 5'h0;
  logic [4:0] select_632;
  assign select_632 = leaving_values_18_features_mask_q ? difference_14_s4_q : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_8;
  assign above_8 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[63:56] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_638;
  assign not_638 = ~(entering_values_18_row_q ^ entering_values_19_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_645;
  assign select_645 = (entering_values_19_features_mask_q & not_638) ? difference_15_s4_q : 5'h1f;
  logic [4:0] select_646;
  assign select_646 = entering_values_18_features_mask_q ? select_645 : 5'h0;
  logic [4:0] select_653;
  assign select_653 = (leaving_values_19_features_mask_q & not_638) ? difference_16_s4_q : 5'h1f;
  logic [4:0] select_654;
  assign select_654 = leaving_values_18_features_mask_q ? select_653 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_9;
  assign above_9 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[71:64] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_660;
  assign not_660 = ~(entering_values_18_row_q ^ entering_values_20_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_667;
  assign select_667 = (entering_values_20_features_mask_q & not_660) ? difference_17_s4_q : 5'h1f;
  logic [4:0] select_668;
  assign select_668 = entering_values_18_features_mask_q ? select_667 : 5'h0;
  logic [4:0] select_675;
  assign select_675 = (leaving_values_20_features_mask_q & not_660) ? difference_18_s4_q : 5'h1f;
  logic [4:0] select_676;
  assign select_676 = leaving_values_18_features_mask_q ? select_675 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_10;
  assign above_10 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[79:72] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_682;
  assign not_682 = ~(entering_values_18_row_q ^ entering_values_21_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_689;
  assign select_689 = (entering_values_21_features_mask_q & not_682) ? difference_19_s4_q : 5'h1f;
  logic [4:0] select_690;
  assign select_690 = entering_values_18_features_mask_q ? select_689 : 5'h0;
  logic [4:0] select_697;
  assign select_697 = (leaving_values_21_features_mask_q & not_682) ? difference_20_s4_q : 5'h1f;
  logic [4:0] select_698;
  assign select_698 = leaving_values_18_features_mask_q ? select_697 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_11;
  assign above_11 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[87:80] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic xor_703;
  assign xor_703 = entering_values_18_row_q ^ entering_values_24_row_q;
  // hls/stages/plane_sums.hpp:87
  logic [4:0] select_710;
  assign select_710 = entering_values_24_features_mask_q ? (xor_703 ? 5'h1f : difference_21_s4_q) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_711;
  assign select_711 = entering_values_18_features_mask_q ? select_710 : 5'h0;
  // hls/stages/plane_sums.hpp:88
  logic [4:0] select_718;
  assign select_718 = leaving_values_24_features_mask_q ? (xor_703 ? 5'h1f : difference_22_s4_q) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_719;
  assign select_719 = leaving_values_18_features_mask_q ? select_718 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_12;
  assign above_12 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[95:88] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic xor_724;
  assign xor_724 = entering_values_18_row_q ^ entering_values_28_row_q;
  // hls/stages/plane_sums.hpp:87
  logic [4:0] select_731;
  assign select_731 = entering_values_28_features_mask_q ? (xor_724 ? 5'h1f : difference_23_s4_q) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_732;
  assign select_732 = entering_values_18_features_mask_q ? select_731 : 5'h0;
  // hls/stages/plane_sums.hpp:88
  logic [4:0] select_739;
  assign select_739 = leaving_values_28_features_mask_q ? (xor_724 ? 5'h1f : difference_24_s4_q) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_740;
  assign select_740 = leaving_values_18_features_mask_q ? select_739 : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_13;
  assign above_13 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[103:96] : 8'h0);
  logic [7:0] above_14;
  assign above_14 = equal_481 ? 8'h0 : (or_478_s4_q ? column_memory_rdata_s4_q[111:104] : 8'h0);
  // hls/stages/plane_sums.hpp:81
  logic not_785;
  assign not_785 = ~(select_480 == 3'h7);
  logic [2:0] select_787;
  assign select_787 = centre_marks_values_0_last_q ? (select_480 + {2'h0, not_785}) : select_480;
  // hls/stages/plane_sums.hpp:99
  logic and_849;
  assign and_849 = (column_memory_rdata_s4_q[142] & or_478_s4_q) & (3'h2 < select_480);
  // hls/stages/plane_sums.hpp:110
  logic and_853;
  assign and_853 = (centres_values_3_gradient_q & and_849) & (~(select_477_s4_q[10:2] == 9'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      delayed_rows_q <= 3'h0;
      centres_values_0_seen_grey_q <= 6'h0;
      centres_values_0_seen_exists_q <= 1'b0;
      centres_values_0_gradient_q <= 1'b0;
      centres_values_1_seen_grey_q <= 6'h0;
      centres_values_1_seen_exists_q <= 1'b0;
      centres_values_1_gradient_q <= 1'b0;
      centres_values_2_seen_grey_q <= 6'h0;
      centres_values_2_seen_exists_q <= 1'b0;
      centres_values_2_gradient_q <= 1'b0;
      centres_values_3_seen_grey_q <= 6'h0;
      centres_values_3_seen_exists_q <= 1'b0;
      centres_values_3_gradient_q <= 1'b0;
      rows_seen_values_0_q <= 1'b0;
      rows_seen_values_1_q <= 1'b0;
      rows_seen_values_2_q <= 1'b0;
      rows_seen_values_3_q <= 1'b0;
    end else if (s4_en) begin
      delayed_rows_q <= select_787;
      centres_values_0_seen_grey_q <= or_478_s4_q ? column_memory_rdata_s4_q[138:133] : 6'h0;
      centres_values_0_seen_exists_q <= column_memory_rdata_s4_q[139] & or_478_s4_q;
      centres_values_0_gradient_q <= and_849;
      centres_values_1_seen_grey_q <= centres_values_0_seen_grey_q;
      centres_values_1_seen_exists_q <= centres_values_0_seen_exists_q;
      centres_values_1_gradient_q <= centres_values_0_gradient_q;
      centres_values_2_seen_grey_q <= centres_values_1_seen_grey_q;
      centres_values_2_seen_exists_q <= centres_values_1_seen_exists_q;
      centres_values_2_gradient_q <= centres_values_1_gradient_q;
      centres_values_3_seen_grey_q <= centres_values_2_seen_grey_q;
      centres_values_3_seen_exists_q <= centres_values_2_seen_exists_q;
      centres_values_3_gradient_q <= centres_values_2_gradient_q;
      rows_seen_values_0_q <= select_480[2];
      rows_seen_values_1_q <= rows_seen_values_0_q;
      rows_seen_values_2_q <= rows_seen_values_1_q;
      rows_seen_values_3_q <= rows_seen_values_2_q;
    end
  end

  logic entering_values_17_features_mask_s5_q;
  logic [5:0] seen_values_18_grey_s5_q;
  logic seen_values_18_exists_s5_q;
  logic [5:0] centres_values_3_seen_grey_s5_q;
  logic centre_marks_values_3_first_s5_q;
  logic centre_marks_values_3_last_s5_q;
  logic or_476_s5_q;
  logic [10:0] select_477_s5_q;
  logic or_478_s5_q;
  logic [17:0] column_memory_rdata_s5_q;
  logic [7:0] above_s5_q;
  logic [5:0] difference_507_s5_q;
  logic [7:0] above_2_s5_q;
  logic [5:0] difference_529_s5_q;
  logic [7:0] above_3_s5_q;
  logic [5:0] difference_551_s5_q;
  logic [7:0] above_4_s5_q;
  logic [5:0] difference_573_s5_q;
  logic [7:0] above_5_s5_q;
  logic [5:0] difference_595_s5_q;
  logic [7:0] above_6_s5_q;
  logic [5:0] difference_617_s5_q;
  logic [7:0] above_7_s5_q;
  logic [5:0] difference_633_s5_q;
  logic [7:0] above_8_s5_q;
  logic [5:0] difference_655_s5_q;
  logic [7:0] above_9_s5_q;
  logic [5:0] difference_677_s5_q;
  logic [7:0] above_10_s5_q;
  logic [5:0] difference_699_s5_q;
  logic [7:0] above_11_s5_q;
  logic [5:0] difference_720_s5_q;
  logic [7:0] above_12_s5_q;
  logic [5:0] difference_741_s5_q;
  logic [7:0] above_13_s5_q;
  logic [5:0] difference_762_s5_q;
  logic [7:0] above_14_s5_q;
  logic [5:0] difference_772_s5_q;
  logic and_774_s5_q;
  logic and_775_s5_q;
  logic and_776_s5_q;
  logic and_777_s5_q;
  logic and_778_s5_q;
  logic and_853_s5_q;
  logic and_854_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      entering_values_17_features_mask_s5_q <= entering_values_18_features_mask_q;
      seen_values_18_grey_s5_q <= seen_values_18_grey_s4_q;
      seen_values_18_exists_s5_q <= seen_values_18_exists_s4_q;
      centres_values_3_seen_grey_s5_q <= centres_values_3_seen_grey_q;
      centre_marks_values_3_first_s5_q <= centre_marks_values_3_first_s4_q;
      centre_marks_values_3_last_s5_q <= centre_marks_values_3_last_s4_q;
      or_476_s5_q <= or_476_s4_q;
      select_477_s5_q <= select_477_s4_q;
      or_478_s5_q <= or_478_s4_q;
      column_memory_rdata_s5_q <= {column_memory_rdata_s4_q[131:126], column_memory_rdata_s4_q[124:119], column_memory_rdata_s4_q[117:112]};
      above_s5_q <= above;
      difference_507_s5_q <= {1'b0, select_495} - {1'b0, select_506};
      above_2_s5_q <= above_2;
      difference_529_s5_q <= {1'b0, select_520} - {1'b0, select_528};
      above_3_s5_q <= above_3;
      difference_551_s5_q <= {1'b0, select_542} - {1'b0, select_550};
      above_4_s5_q <= above_4;
      difference_573_s5_q <= {1'b0, select_564} - {1'b0, select_572};
      above_5_s5_q <= above_5;
      difference_595_s5_q <= {1'b0, select_586} - {1'b0, select_594};
      above_6_s5_q <= above_6;
      difference_617_s5_q <= {1'b0, select_608} - {1'b0, select_616};
      above_7_s5_q <= above_7;
      difference_633_s5_q <= {1'b0, select_626} - {1'b0, select_632};
      above_8_s5_q <= above_8;
      difference_655_s5_q <= {1'b0, select_646} - {1'b0, select_654};
      above_9_s5_q <= above_9;
      difference_677_s5_q <= {1'b0, select_668} - {1'b0, select_676};
      above_10_s5_q <= above_10;
      difference_699_s5_q <= {1'b0, select_690} - {1'b0, select_698};
      above_11_s5_q <= above_11;
      difference_720_s5_q <= {1'b0, select_711} - {1'b0, select_719};
      above_12_s5_q <= above_12;
      difference_741_s5_q <= {1'b0, select_732} - {1'b0, select_740};
      above_13_s5_q <= above_13;
      difference_762_s5_q <= difference_762_s4_q;
      above_14_s5_q <= above_14;
      difference_772_s5_q <= difference_772_s4_q;
      and_774_s5_q <= column_memory_rdata_s4_q[118] & or_478_s4_q;
      and_775_s5_q <= column_memory_rdata_s4_q[125] & or_478_s4_q;
      and_776_s5_q <= column_memory_rdata_s4_q[132] & or_478_s4_q;
      and_777_s5_q <= column_memory_rdata_s4_q[140] & or_478_s4_q;
      and_778_s5_q <= column_memory_rdata_s4_q[141] & or_478_s4_q;
      and_853_s5_q <= and_853;
      and_854_s5_q <= centres_values_3_seen_exists_q & rows_seen_values_3_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [10:0] rows_0_columns_values_0_q;
  logic [10:0] rows_0_columns_values_1_q;
  logic [10:0] rows_0_columns_values_2_q;
  logic [10:0] rows_0_columns_values_3_q;
  logic [10:0] rows_0_columns_values_4_q;
  logic [10:0] rows_0_columns_values_5_q;
  logic [10:0] rows_0_columns_values_6_q;
  logic [10:0] rows_0_columns_values_7_q;
  logic [10:0] rows_0_columns_values_8_q;
  logic [10:0] rows_1_columns_values_0_q;
  logic [10:0] rows_1_columns_values_1_q;
  logic [10:0] rows_1_columns_values_2_q;
  logic [10:0] rows_1_columns_values_3_q;
  logic [10:0] rows_1_columns_values_4_q;
  logic [10:0] rows_1_columns_values_5_q;
  logic [10:0] rows_1_columns_values_6_q;
  logic [10:0] rows_1_columns_values_7_q;
  logic [10:0] rows_1_columns_values_8_q;
  logic [10:0] rows_2_columns_values_0_q;
  logic [10:0] rows_2_columns_values_1_q;
  logic [10:0] rows_2_columns_values_2_q;
  logic [10:0] rows_2_columns_values_3_q;
  logic [10:0] rows_2_columns_values_4_q;
  logic [10:0] rows_2_columns_values_5_q;
  logic [10:0] rows_2_columns_values_6_q;
  logic [10:0] rows_2_columns_values_7_q;
  logic [10:0] rows_2_columns_values_8_q;
  logic [10:0] rows_3_columns_values_0_q;
  logic [10:0] rows_3_columns_values_1_q;
  logic [10:0] rows_3_columns_values_2_q;
  logic [10:0] rows_3_columns_values_3_q;
  logic [10:0] rows_3_columns_values_4_q;
  logic [10:0] rows_3_columns_values_5_q;
  logic [10:0] rows_3_columns_values_6_q;
  logic [10:0] rows_3_columns_values_7_q;
  logic [10:0] rows_3_columns_values_8_q;
  logic [10:0] rows_4_columns_values_0_q;
  logic [10:0] rows_4_columns_values_1_q;
  logic [10:0] rows_4_columns_values_2_q;
  logic [10:0] rows_4_columns_values_3_q;
  logic [10:0] rows_4_columns_values_4_q;
  logic [10:0] rows_4_columns_values_5_q;
  logic [10:0] rows_4_columns_values_6_q;
  logic [10:0] rows_4_columns_values_7_q;
  logic [10:0] rows_4_columns_values_8_q;
  logic [10:0] rows_5_columns_values_0_q;
  logic [10:0] rows_5_columns_values_1_q;
  logic [10:0] rows_5_columns_values_2_q;
  logic [10:0] rows_5_columns_values_3_q;
  logic [10:0] rows_5_columns_values_4_q;
  logic [10:0] rows_5_columns_values_5_q;
  logic [10:0] rows_5_columns_values_6_q;
  logic [10:0] rows_5_columns_values_7_q;
  logic [10:0] rows_5_columns_values_8_q;
  logic [10:0] rows_6_columns_values_0_q;
  logic [10:0] rows_6_columns_values_1_q;
  logic [10:0] rows_6_columns_values_2_q;
  logic [10:0] rows_6_columns_values_3_q;
  logic [10:0] rows_6_columns_values_4_q;
  logic [10:0] rows_6_columns_values_5_q;
  logic [10:0] rows_6_columns_values_6_q;
  logic [10:0] rows_6_columns_values_7_q;
  logic [10:0] rows_6_columns_values_8_q;
  logic [10:0] rows_7_columns_values_0_q;
  logic [10:0] rows_7_columns_values_1_q;
  logic [10:0] rows_7_columns_values_2_q;
  logic [10:0] rows_7_columns_values_3_q;
  logic [10:0] rows_7_columns_values_4_q;
  logic [10:0] rows_7_columns_values_5_q;
  logic [10:0] rows_7_columns_values_6_q;
  logic [10:0] rows_7_columns_values_7_q;
  logic [10:0] rows_7_columns_values_8_q;
  logic [10:0] rows_8_columns_values_0_q;
  logic [10:0] rows_8_columns_values_1_q;
  logic [10:0] rows_8_columns_values_2_q;
  logic [10:0] rows_8_columns_values_3_q;
  logic [10:0] rows_8_columns_values_4_q;
  logic [10:0] rows_8_columns_values_5_q;
  logic [10:0] rows_8_columns_values_6_q;
  logic [10:0] rows_8_columns_values_7_q;
  logic [10:0] rows_8_columns_values_8_q;
  logic [10:0] rows_9_columns_values_0_q;
  logic [10:0] rows_9_columns_values_1_q;
  logic [10:0] rows_9_columns_values_2_q;
  logic [10:0] rows_9_columns_values_3_q;
  logic [10:0] rows_9_columns_values_4_q;
  logic [10:0] rows_9_columns_values_5_q;
  logic [10:0] rows_9_columns_values_6_q;
  logic [10:0] rows_9_columns_values_7_q;
  logic [10:0] rows_9_columns_values_8_q;
  logic [10:0] rows_10_columns_values_0_q;
  logic [10:0] rows_10_columns_values_1_q;
  logic [10:0] rows_10_columns_values_2_q;
  logic [10:0] rows_10_columns_values_3_q;
  logic [10:0] rows_10_columns_values_4_q;
  logic [10:0] rows_10_columns_values_5_q;
  logic [10:0] rows_10_columns_values_6_q;
  logic [10:0] rows_10_columns_values_7_q;
  logic [10:0] rows_10_columns_values_8_q;
  logic [10:0] rows_11_columns_values_0_q;
  logic [10:0] rows_11_columns_values_1_q;
  logic [10:0] rows_11_columns_values_2_q;
  logic [10:0] rows_11_columns_values_3_q;
  logic [10:0] rows_11_columns_values_4_q;
  logic [10:0] rows_11_columns_values_5_q;
  logic [10:0] rows_11_columns_values_6_q;
  logic [10:0] rows_11_columns_values_7_q;
  logic [10:0] rows_11_columns_values_8_q;
  logic [10:0] rows_12_columns_values_0_q;
  logic [10:0] rows_12_columns_values_1_q;
  logic [10:0] rows_12_columns_values_2_q;
  logic [10:0] rows_12_columns_values_3_q;
  logic [10:0] rows_12_columns_values_4_q;
  logic [10:0] rows_12_columns_values_5_q;
  logic [10:0] rows_12_columns_values_6_q;
  logic [10:0] rows_12_columns_values_7_q;
  logic [10:0] rows_12_columns_values_8_q;
  logic [10:0] rows_13_columns_values_0_q;
  logic [10:0] rows_13_columns_values_1_q;
  logic [10:0] rows_13_columns_values_2_q;
  logic [10:0] rows_13_columns_values_3_q;
  logic [10:0] rows_13_columns_values_4_q;
  logic [10:0] rows_13_columns_values_5_q;
  logic [10:0] rows_13_columns_values_6_q;
  logic [10:0] rows_13_columns_values_7_q;
  logic [10:0] rows_13_columns_values_8_q;
  // hls/stages/plane_sums.hpp:149
  logic [7:0] sum_508;
  assign sum_508 = above_s5_q + {{2{difference_507_s5_q[5]}}, difference_507_s5_q};
  logic [7:0] sum_530;
  assign sum_530 = above_2_s5_q + {{2{difference_529_s5_q[5]}}, difference_529_s5_q};
  logic [7:0] sum_552;
  assign sum_552 = above_3_s5_q + {{2{difference_551_s5_q[5]}}, difference_551_s5_q};
  logic [7:0] sum_574;
  assign sum_574 = above_4_s5_q + {{2{difference_573_s5_q[5]}}, difference_573_s5_q};
  logic [7:0] sum_596;
  assign sum_596 = above_5_s5_q + {{2{difference_595_s5_q[5]}}, difference_595_s5_q};
  logic [7:0] sum_618;
  assign sum_618 = above_6_s5_q + {{2{difference_617_s5_q[5]}}, difference_617_s5_q};
  logic [7:0] sum_634;
  assign sum_634 = above_7_s5_q + {{2{difference_633_s5_q[5]}}, difference_633_s5_q};
  logic [7:0] sum_656;
  assign sum_656 = above_8_s5_q + {{2{difference_655_s5_q[5]}}, difference_655_s5_q};
  logic [7:0] sum_678;
  assign sum_678 = above_9_s5_q + {{2{difference_677_s5_q[5]}}, difference_677_s5_q};
  logic [7:0] sum_700;
  assign sum_700 = above_10_s5_q + {{2{difference_699_s5_q[5]}}, difference_699_s5_q};
  logic [7:0] sum_721;
  assign sum_721 = above_11_s5_q + {{2{difference_720_s5_q[5]}}, difference_720_s5_q};
  logic [7:0] sum_742;
  assign sum_742 = above_12_s5_q + {{2{difference_741_s5_q[5]}}, difference_741_s5_q};
  logic [7:0] sum_763;
  assign sum_763 = above_13_s5_q + {{2{difference_762_s5_q[5]}}, difference_762_s5_q};
  logic [7:0] sum_773;
  assign sum_773 = above_14_s5_q + {{2{difference_772_s5_q[5]}}, difference_772_s5_q};
  // hls/stages/plane_sums.hpp:150
  logic less_788;
  assign less_788 = 11'h8 < select_477_s5_q;

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    rows_0_columns_values_0_q = 11'h0;
    rows_0_columns_values_1_q = 11'h0;
    rows_0_columns_values_2_q = 11'h0;
    rows_0_columns_values_3_q = 11'h0;
    rows_0_columns_values_4_q = 11'h0;
    rows_0_columns_values_5_q = 11'h0;
    rows_0_columns_values_6_q = 11'h0;
    rows_0_columns_values_7_q = 11'h0;
    rows_0_columns_values_8_q = 11'h0;
    rows_1_columns_values_0_q = 11'h0;
    rows_1_columns_values_1_q = 11'h0;
    rows_1_columns_values_2_q = 11'h0;
    rows_1_columns_values_3_q = 11'h0;
    rows_1_columns_values_4_q = 11'h0;
    rows_1_columns_values_5_q = 11'h0;
    rows_1_columns_values_6_q = 11'h0;
    rows_1_columns_values_7_q = 11'h0;
    rows_1_columns_values_8_q = 11'h0;
    rows_2_columns_values_0_q = 11'h0;
    rows_2_columns_values_1_q = 11'h0;
    rows_2_columns_values_2_q = 11'h0;
    rows_2_columns_values_3_q = 11'h0;
    rows_2_columns_values_4_q = 11'h0;
    rows_2_columns_values_5_q = 11'h0;
    rows_2_columns_values_6_q = 11'h0;
    rows_2_columns_values_7_q = 11'h0;
    rows_2_columns_values_8_q = 11'h0;
    rows_3_columns_values_0_q = 11'h0;
    rows_3_columns_values_1_q = 11'h0;
    rows_3_columns_values_2_q = 11'h0;
    rows_3_columns_values_3_q = 11'h0;
    rows_3_columns_values_4_q = 11'h0;
    rows_3_columns_values_5_q = 11'h0;
    rows_3_columns_values_6_q = 11'h0;
    rows_3_columns_values_7_q = 11'h0;
    rows_3_columns_values_8_q = 11'h0;
    rows_4_columns_values_0_q = 11'h0;
    rows_4_columns_values_1_q = 11'h0;
    rows_4_columns_values_2_q = 11'h0;
    rows_4_columns_values_3_q = 11'h0;
    rows_4_columns_values_4_q = 11'h0;
    rows_4_columns_values_5_q = 11'h0;
    rows_4_columns_values_6_q = 11'h0;
    rows_4_columns_values_7_q = 11'h0;
    rows_4_columns_values_8_q = 11'h0;
    rows_5_columns_values_0_q = 11'h0;
    rows_5_columns_values_1_q = 11'h0;
    rows_5_columns_values_2_q = 11'h0;
    rows_5_columns_values_3_q = 11'h0;
    rows_5_columns_values_4_q = 11'h0;
    rows_5_columns_values_5_q = 11'h0;
    rows_5_columns_values_6_q = 11'h0;
    rows_5_columns_values_7_q = 11'h0;
    rows_5_columns_values_8_q = 11'h0;
    rows_6_columns_values_0_q = 11'h0;
    rows_6_columns_values_1_q = 11'h0;
    rows_6_columns_values_2_q = 11'h0;
    rows_6_columns_values_3_q = 11'h0;
    rows_6_columns_values_4_q = 11'h0;
    rows_6_columns_values_5_q = 11'h0;
    rows_6_columns_values_6_q = 11'h0;
    rows_6_columns_values_7_q = 11'h0;
    rows_6_columns_values_8_q = 11'h0;
    rows_7_columns_values_0_q = 11'h0;
    rows_7_columns_values_1_q = 11'h0;
    rows_7_columns_values_2_q = 11'h0;
    rows_7_columns_values_3_q = 11'h0;
    rows_7_columns_values_4_q = 11'h0;
    rows_7_columns_values_5_q = 11'h0;
    rows_7_columns_values_6_q = 11'h0;
    rows_7_columns_values_7_q = 11'h0;
    rows_7_columns_values_8_q = 11'h0;
    rows_8_columns_values_0_q = 11'h0;
    rows_8_columns_values_1_q = 11'h0;
    rows_8_columns_values_2_q = 11'h0;
    rows_8_columns_values_3_q = 11'h0;
    rows_8_columns_values_4_q = 11'h0;
    rows_8_columns_values_5_q = 11'h0;
    rows_8_columns_values_6_q = 11'h0;
    rows_8_columns_values_7_q = 11'h0;
    rows_8_columns_values_8_q = 11'h0;
    rows_9_columns_values_0_q = 11'h0;
    rows_9_columns_values_1_q = 11'h0;
    rows_9_columns_values_2_q = 11'h0;
    rows_9_columns_values_3_q = 11'h0;
    rows_9_columns_values_4_q = 11'h0;
    rows_9_columns_values_5_q = 11'h0;
    rows_9_columns_values_6_q = 11'h0;
    rows_9_columns_values_7_q = 11'h0;
    rows_9_columns_values_8_q = 11'h0;
    rows_10_columns_values_0_q = 11'h0;
    rows_10_columns_values_1_q = 11'h0;
    rows_10_columns_values_2_q = 11'h0;
    rows_10_columns_values_3_q = 11'h0;
    rows_10_columns_values_4_q = 11'h0;
    rows_10_columns_values_5_q = 11'h0;
    rows_10_columns_values_6_q = 11'h0;
    rows_10_columns_values_7_q = 11'h0;
    rows_10_columns_values_8_q = 11'h0;
    rows_11_columns_values_0_q = 11'h0;
    rows_11_columns_values_1_q = 11'h0;
    rows_11_columns_values_2_q = 11'h0;
    rows_11_columns_values_3_q = 11'h0;
    rows_11_columns_values_4_q = 11'h0;
    rows_11_columns_values_5_q = 11'h0;
    rows_11_columns_values_6_q = 11'h0;
    rows_11_columns_values_7_q = 11'h0;
    rows_11_columns_values_8_q = 11'h0;
    rows_12_columns_values_0_q = 11'h0;
    rows_12_columns_values_1_q = 11'h0;
    rows_12_columns_values_2_q = 11'h0;
    rows_12_columns_values_3_q = 11'h0;
    rows_12_columns_values_4_q = 11'h0;
    rows_12_columns_values_5_q = 11'h0;
    rows_12_columns_values_6_q = 11'h0;
    rows_12_columns_values_7_q = 11'h0;
    rows_12_columns_values_8_q = 11'h0;
    rows_13_columns_values_0_q = 11'h0;
    rows_13_columns_values_1_q = 11'h0;
    rows_13_columns_values_2_q = 11'h0;
    rows_13_columns_values_3_q = 11'h0;
    rows_13_columns_values_4_q = 11'h0;
    rows_13_columns_values_5_q = 11'h0;
    rows_13_columns_values_6_q = 11'h0;
    rows_13_columns_values_7_q = 11'h0;
    rows_13_columns_values_8_q = 11'h0;
  end
`endif
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      rows_0_columns_values_0_q <= {3'h0, sum_508};
      rows_0_columns_values_1_q <= rows_0_columns_values_0_q;
      rows_0_columns_values_2_q <= rows_0_columns_values_1_q;
      rows_0_columns_values_3_q <= rows_0_columns_values_2_q;
      rows_0_columns_values_4_q <= rows_0_columns_values_3_q;
      rows_0_columns_values_5_q <= rows_0_columns_values_4_q;
      rows_0_columns_values_6_q <= rows_0_columns_values_5_q;
      rows_0_columns_values_7_q <= rows_0_columns_values_6_q;
      rows_0_columns_values_8_q <= rows_0_columns_values_7_q;
      rows_1_columns_values_0_q <= {3'h0, sum_530};
      rows_1_columns_values_1_q <= rows_1_columns_values_0_q;
      rows_1_columns_values_2_q <= rows_1_columns_values_1_q;
      rows_1_columns_values_3_q <= rows_1_columns_values_2_q;
      rows_1_columns_values_4_q <= rows_1_columns_values_3_q;
      rows_1_columns_values_5_q <= rows_1_columns_values_4_q;
      rows_1_columns_values_6_q <= rows_1_columns_values_5_q;
      rows_1_columns_values_7_q <= rows_1_columns_values_6_q;
      rows_1_columns_values_8_q <= rows_1_columns_values_7_q;
      rows_2_columns_values_0_q <= {3'h0, sum_552};
      rows_2_columns_values_1_q <= rows_2_columns_values_0_q;
      rows_2_columns_values_2_q <= rows_2_columns_values_1_q;
      rows_2_columns_values_3_q <= rows_2_columns_values_2_q;
      rows_2_columns_values_4_q <= rows_2_columns_values_3_q;
      rows_2_columns_values_5_q <= rows_2_columns_values_4_q;
      rows_2_columns_values_6_q <= rows_2_columns_values_5_q;
      rows_2_columns_values_7_q <= rows_2_columns_values_6_q;
      rows_2_columns_values_8_q <= rows_2_columns_values_7_q;
      rows_3_columns_values_0_q <= {3'h0, sum_574};
      rows_3_columns_values_1_q <= rows_3_columns_values_0_q;
      rows_3_columns_values_2_q <= rows_3_columns_values_1_q;
      rows_3_columns_values_3_q <= rows_3_columns_values_2_q;
      rows_3_columns_values_4_q <= rows_3_columns_values_3_q;
      rows_3_columns_values_5_q <= rows_3_columns_values_4_q;
      rows_3_columns_values_6_q <= rows_3_columns_values_5_q;
      rows_3_columns_values_7_q <= rows_3_columns_values_6_q;
      rows_3_columns_values_8_q <= rows_3_columns_values_7_q;
      rows_4_columns_values_0_q <= {3'h0, sum_596};
      rows_4_columns_values_1_q <= rows_4_columns_values_0_q;
      rows_4_columns_values_2_q <= rows_4_columns_values_1_q;
      rows_4_columns_values_3_q <= rows_4_columns_values_2_q;
      rows_4_columns_values_4_q <= rows_4_columns_values_3_q;
      rows_4_columns_values_5_q <= rows_4_columns_values_4_q;
      rows_4_columns_values_6_q <= rows_4_columns_values_5_q;
      rows_4_columns_values_7_q <= rows_4_columns_values_6_q;
      rows_4_columns_values_8_q <= rows_4_columns_values_7_q;
      rows_5_columns_values_0_q <= {3'h0, sum_618};
      rows_5_columns_values_1_q <= rows_5_columns_values_0_q;
      rows_5_columns_values_2_q <= rows_5_columns_values_1_q;
      rows_5_columns_values_3_q <= rows_5_columns_values_2_q;
      rows_5_columns_values_4_q <= rows_5_columns_values_3_q;
      rows_5_columns_values_5_q <= rows_5_columns_values_4_q;
      rows_5_columns_values_6_q <= rows_5_columns_values_5_q;
      rows_5_columns_values_7_q <= rows_5_columns_values_6_q;
      rows_5_columns_values_8_q <= rows_5_columns_values_7_q;
      rows_6_columns_values_0_q <= {3'h0, sum_634};
      rows_6_columns_values_1_q <= rows_6_columns_values_0_q;
      rows_6_columns_values_2_q <= rows_6_columns_values_1_q;
      rows_6_columns_values_3_q <= rows_6_columns_values_2_q;
      rows_6_columns_values_4_q <= rows_6_columns_values_3_q;
      rows_6_columns_values_5_q <= rows_6_columns_values_4_q;
      rows_6_columns_values_6_q <= rows_6_columns_values_5_q;
      rows_6_columns_values_7_q <= rows_6_columns_values_6_q;
      rows_6_columns_values_8_q <= rows_6_columns_values_7_q;
      rows_7_columns_values_0_q <= {3'h0, sum_656};
      rows_7_columns_values_1_q <= rows_7_columns_values_0_q;
      rows_7_columns_values_2_q <= rows_7_columns_values_1_q;
      rows_7_columns_values_3_q <= rows_7_columns_values_2_q;
      rows_7_columns_values_4_q <= rows_7_columns_values_3_q;
      rows_7_columns_values_5_q <= rows_7_columns_values_4_q;
      rows_7_columns_values_6_q <= rows_7_columns_values_5_q;
      rows_7_columns_values_7_q <= rows_7_columns_values_6_q;
      rows_7_columns_values_8_q <= rows_7_columns_values_7_q;
      rows_8_columns_values_0_q <= {3'h0, sum_678};
      rows_8_columns_values_1_q <= rows_8_columns_values_0_q;
      rows_8_columns_values_2_q <= rows_8_columns_values_1_q;
      rows_8_columns_values_3_q <= rows_8_columns_values_2_q;
      rows_8_columns_values_4_q <= rows_8_columns_values_3_q;
      rows_8_columns_values_5_q <= rows_8_columns_values_4_q;
      rows_8_columns_values_6_q <= rows_8_columns_values_5_q;
      rows_8_columns_values_7_q <= rows_8_columns_values_6_q;
      rows_8_columns_values_8_q <= rows_8_columns_values_7_q;
      rows_9_columns_values_0_q <= {3'h0, sum_700};
      rows_9_columns_values_1_q <= rows_9_columns_values_0_q;
      rows_9_columns_values_2_q <= rows_9_columns_values_1_q;
      rows_9_columns_values_3_q <= rows_9_columns_values_2_q;
      rows_9_columns_values_4_q <= rows_9_columns_values_3_q;
      rows_9_columns_values_5_q <= rows_9_columns_values_4_q;
      rows_9_columns_values_6_q <= rows_9_columns_values_5_q;
      rows_9_columns_values_7_q <= rows_9_columns_values_6_q;
      rows_9_columns_values_8_q <= rows_9_columns_values_7_q;
      rows_10_columns_values_0_q <= {3'h0, sum_721};
      rows_10_columns_values_1_q <= rows_10_columns_values_0_q;
      rows_10_columns_values_2_q <= rows_10_columns_values_1_q;
      rows_10_columns_values_3_q <= rows_10_columns_values_2_q;
      rows_10_columns_values_4_q <= rows_10_columns_values_3_q;
      rows_10_columns_values_5_q <= rows_10_columns_values_4_q;
      rows_10_columns_values_6_q <= rows_10_columns_values_5_q;
      rows_10_columns_values_7_q <= rows_10_columns_values_6_q;
      rows_10_columns_values_8_q <= rows_10_columns_values_7_q;
      rows_11_columns_values_0_q <= {3'h0, sum_742};
      rows_11_columns_values_1_q <= rows_11_columns_values_0_q;
      rows_11_columns_values_2_q <= rows_11_columns_values_1_q;
      rows_11_columns_values_3_q <= rows_11_columns_values_2_q;
      rows_11_columns_values_4_q <= rows_11_columns_values_3_q;
      rows_11_columns_values_5_q <= rows_11_columns_values_4_q;
      rows_11_columns_values_6_q <= rows_11_columns_values_5_q;
      rows_11_columns_values_7_q <= rows_11_columns_values_6_q;
      rows_11_columns_values_8_q <= rows_11_columns_values_7_q;
      rows_12_columns_values_0_q <= {3'h0, sum_763};
      rows_12_columns_values_1_q <= rows_12_columns_values_0_q;
      rows_12_columns_values_2_q <= rows_12_columns_values_1_q;
      rows_12_columns_values_3_q <= rows_12_columns_values_2_q;
      rows_12_columns_values_4_q <= rows_12_columns_values_3_q;
      rows_12_columns_values_5_q <= rows_12_columns_values_4_q;
      rows_12_columns_values_6_q <= rows_12_columns_values_5_q;
      rows_12_columns_values_7_q <= rows_12_columns_values_6_q;
      rows_12_columns_values_8_q <= rows_12_columns_values_7_q;
      rows_13_columns_values_0_q <= {3'h0, sum_773};
      rows_13_columns_values_1_q <= rows_13_columns_values_0_q;
      rows_13_columns_values_2_q <= rows_13_columns_values_1_q;
      rows_13_columns_values_3_q <= rows_13_columns_values_2_q;
      rows_13_columns_values_4_q <= rows_13_columns_values_3_q;
      rows_13_columns_values_5_q <= rows_13_columns_values_4_q;
      rows_13_columns_values_6_q <= rows_13_columns_values_5_q;
      rows_13_columns_values_7_q <= rows_13_columns_values_6_q;
      rows_13_columns_values_8_q <= rows_13_columns_values_7_q;
    end
  end

  logic entering_values_17_features_mask_s6_q;
  logic [5:0] seen_values_18_grey_s6_q;
  logic seen_values_18_exists_s6_q;
  logic [5:0] centres_values_3_seen_grey_s6_q;
  logic centre_marks_values_3_first_s6_q;
  logic centre_marks_values_3_last_s6_q;
  logic or_476_s6_q;
  logic [10:0] select_477_s6_q;
  logic or_478_s6_q;
  logic [17:0] column_memory_rdata_s6_q;
  logic and_774_s6_q;
  logic and_775_s6_q;
  logic and_776_s6_q;
  logic and_777_s6_q;
  logic and_778_s6_q;
  logic [10:0] select_789_s6_q;
  logic [10:0] select_793_s6_q;
  logic [10:0] select_797_s6_q;
  logic [10:0] select_801_s6_q;
  logic [10:0] select_805_s6_q;
  logic [10:0] select_809_s6_q;
  logic [10:0] select_813_s6_q;
  logic [10:0] select_817_s6_q;
  logic [10:0] select_821_s6_q;
  logic [10:0] select_825_s6_q;
  logic [10:0] select_829_s6_q;
  logic [10:0] select_833_s6_q;
  logic [10:0] select_837_s6_q;
  logic [10:0] select_841_s6_q;
  logic and_853_s6_q;
  logic and_854_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      entering_values_17_features_mask_s6_q <= entering_values_17_features_mask_s5_q;
      seen_values_18_grey_s6_q <= seen_values_18_grey_s5_q;
      seen_values_18_exists_s6_q <= seen_values_18_exists_s5_q;
      centres_values_3_seen_grey_s6_q <= centres_values_3_seen_grey_s5_q;
      centre_marks_values_3_first_s6_q <= centre_marks_values_3_first_s5_q;
      centre_marks_values_3_last_s6_q <= centre_marks_values_3_last_s5_q;
      or_476_s6_q <= or_476_s5_q;
      select_477_s6_q <= select_477_s5_q;
      or_478_s6_q <= or_478_s5_q;
      column_memory_rdata_s6_q <= column_memory_rdata_s5_q;
      and_774_s6_q <= and_774_s5_q;
      and_775_s6_q <= and_775_s5_q;
      and_776_s6_q <= and_776_s5_q;
      and_777_s6_q <= and_777_s5_q;
      and_778_s6_q <= and_778_s5_q;
      select_789_s6_q <= less_788 ? rows_0_columns_values_8_q : 11'h0;
      select_793_s6_q <= less_788 ? rows_1_columns_values_8_q : 11'h0;
      select_797_s6_q <= less_788 ? rows_2_columns_values_8_q : 11'h0;
      select_801_s6_q <= less_788 ? rows_3_columns_values_8_q : 11'h0;
      select_805_s6_q <= less_788 ? rows_4_columns_values_8_q : 11'h0;
      select_809_s6_q <= less_788 ? rows_5_columns_values_8_q : 11'h0;
      select_813_s6_q <= less_788 ? rows_6_columns_values_8_q : 11'h0;
      select_817_s6_q <= less_788 ? rows_7_columns_values_8_q : 11'h0;
      select_821_s6_q <= less_788 ? rows_8_columns_values_8_q : 11'h0;
      select_825_s6_q <= less_788 ? rows_9_columns_values_8_q : 11'h0;
      select_829_s6_q <= less_788 ? rows_10_columns_values_8_q : 11'h0;
      select_833_s6_q <= less_788 ? rows_11_columns_values_8_q : 11'h0;
      select_837_s6_q <= less_788 ? rows_12_columns_values_8_q : 11'h0;
      select_841_s6_q <= less_788 ? rows_13_columns_values_8_q : 11'h0;
      and_853_s6_q <= and_853_s5_q;
      and_854_s6_q <= and_854_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [10:0] rows_0_sum_sums_values_0_q;
  logic [10:0] rows_1_sum_sums_values_0_q;
  logic [10:0] rows_2_sum_sums_values_0_q;
  logic [10:0] rows_3_sum_sums_values_0_q;
  logic [10:0] rows_4_sum_sums_values_0_q;
  logic [10:0] rows_5_sum_sums_values_0_q;
  logic [10:0] rows_6_sum_sums_values_0_q;
  logic [10:0] rows_7_sum_sums_values_0_q;
  logic [10:0] rows_8_sum_sums_values_0_q;
  logic [10:0] rows_9_sum_sums_values_0_q;
  logic [10:0] rows_10_sum_sums_values_0_q;
  logic [10:0] rows_11_sum_sums_values_0_q;
  logic [10:0] rows_12_sum_sums_values_0_q;
  logic [10:0] rows_13_sum_sums_values_0_q;
  // hls/stages/plane_sums.hpp:150
  logic [10:0] sum_792;
  assign sum_792 = ({3'h0, rows_0_columns_values_0_q[7:0]} - select_789_s6_q) + (or_476_s6_q ? 11'h0 : rows_0_sum_sums_values_0_q);
  logic [10:0] sum_796;
  assign sum_796 = ({3'h0, rows_1_columns_values_0_q[7:0]} - select_793_s6_q) + (or_476_s6_q ? 11'h0 : rows_1_sum_sums_values_0_q);
  logic [10:0] sum_800;
  assign sum_800 = ({3'h0, rows_2_columns_values_0_q[7:0]} - select_797_s6_q) + (or_476_s6_q ? 11'h0 : rows_2_sum_sums_values_0_q);
  logic [10:0] sum_804;
  assign sum_804 = ({3'h0, rows_3_columns_values_0_q[7:0]} - select_801_s6_q) + (or_476_s6_q ? 11'h0 : rows_3_sum_sums_values_0_q);
  logic [10:0] sum_808;
  assign sum_808 = ({3'h0, rows_4_columns_values_0_q[7:0]} - select_805_s6_q) + (or_476_s6_q ? 11'h0 : rows_4_sum_sums_values_0_q);
  logic [10:0] sum_812;
  assign sum_812 = ({3'h0, rows_5_columns_values_0_q[7:0]} - select_809_s6_q) + (or_476_s6_q ? 11'h0 : rows_5_sum_sums_values_0_q);
  logic [10:0] sum_816;
  assign sum_816 = ({3'h0, rows_6_columns_values_0_q[7:0]} - select_813_s6_q) + (or_476_s6_q ? 11'h0 : rows_6_sum_sums_values_0_q);
  logic [10:0] sum_820;
  assign sum_820 = ({3'h0, rows_7_columns_values_0_q[7:0]} - select_817_s6_q) + (or_476_s6_q ? 11'h0 : rows_7_sum_sums_values_0_q);
  logic [10:0] sum_824;
  assign sum_824 = ({3'h0, rows_8_columns_values_0_q[7:0]} - select_821_s6_q) + (or_476_s6_q ? 11'h0 : rows_8_sum_sums_values_0_q);
  logic [10:0] sum_828;
  assign sum_828 = ({3'h0, rows_9_columns_values_0_q[7:0]} - select_825_s6_q) + (or_476_s6_q ? 11'h0 : rows_9_sum_sums_values_0_q);
  logic [10:0] sum_832;
  assign sum_832 = ({3'h0, rows_10_columns_values_0_q[7:0]} - select_829_s6_q) + (or_476_s6_q ? 11'h0 : rows_10_sum_sums_values_0_q);
  logic [10:0] sum_836;
  assign sum_836 = ({3'h0, rows_11_columns_values_0_q[7:0]} - select_833_s6_q) + (or_476_s6_q ? 11'h0 : rows_11_sum_sums_values_0_q);
  logic [10:0] sum_840;
  assign sum_840 = ({3'h0, rows_12_columns_values_0_q[7:0]} - select_837_s6_q) + (or_476_s6_q ? 11'h0 : rows_12_sum_sums_values_0_q);
  logic [10:0] sum_844;
  assign sum_844 = ({3'h0, rows_13_columns_values_0_q[7:0]} - select_841_s6_q) + (or_476_s6_q ? 11'h0 : rows_13_sum_sums_values_0_q);

  // Memory column_memory, write
  logic [10:0] column_memory_waddr;
  assign column_memory_waddr = select_477_s6_q;
  logic column_memory_we;
  assign column_memory_we = s6_en & or_478_s6_q;
  always_ff @(posedge clk_i) begin
    if (column_memory_we) column_memory_mem[column_memory_waddr] <= {and_778_s6_q, and_777_s6_q, entering_values_17_features_mask_s6_q, and_776_s6_q, column_memory_rdata_s6_q[17:12], and_775_s6_q, column_memory_rdata_s6_q[11:6], and_774_s6_q, column_memory_rdata_s6_q[5:0], seen_values_18_exists_s6_q, seen_values_18_grey_s6_q, rows_13_columns_values_0_q[7:0], rows_12_columns_values_0_q[7:0], rows_11_columns_values_0_q[7:0], rows_10_columns_values_0_q[7:0], rows_9_columns_values_0_q[7:0], rows_8_columns_values_0_q[7:0], rows_7_columns_values_0_q[7:0], rows_6_columns_values_0_q[7:0], rows_5_columns_values_0_q[7:0], rows_4_columns_values_0_q[7:0], rows_3_columns_values_0_q[7:0], rows_2_columns_values_0_q[7:0], rows_1_columns_values_0_q[7:0], rows_0_columns_values_0_q[7:0]};
  end
`ifndef SYNTHESIS
  logic [10:0] column_memory_raddr_s3_sim;
  logic column_memory_re_s3_sim;
  logic [10:0] column_memory_raddr_s4_sim;
  logic column_memory_re_s4_sim;
  logic [10:0] column_memory_raddr_s5_sim;
  logic column_memory_re_s5_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      column_memory_re_s3_sim <= 1'b0;
      column_memory_re_s4_sim <= 1'b0;
      column_memory_re_s5_sim <= 1'b0;
    end else if (en_i) begin
      column_memory_re_s3_sim <= column_memory_re;
      column_memory_raddr_s3_sim <= column_memory_raddr;
      column_memory_re_s4_sim <= column_memory_re_s3_sim;
      column_memory_raddr_s4_sim <= column_memory_raddr_s3_sim;
      column_memory_re_s5_sim <= column_memory_re_s4_sim;
      column_memory_raddr_s5_sim <= column_memory_raddr_s4_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && column_memory_we) begin
      if (column_memory_re && column_memory_raddr == column_memory_waddr) begin
        $error("column_memory: address %0d is read less than DISTANCE steps after its write", column_memory_waddr);
      end
      if (column_memory_re_s3_sim && column_memory_raddr_s3_sim == column_memory_waddr) begin
        $error("column_memory: address %0d is read less than DISTANCE steps after its write", column_memory_waddr);
      end
      if (column_memory_re_s4_sim && column_memory_raddr_s4_sim == column_memory_waddr) begin
        $error("column_memory: address %0d is read less than DISTANCE steps after its write", column_memory_waddr);
      end
      if (column_memory_re_s5_sim && column_memory_raddr_s5_sim == column_memory_waddr) begin
        $error("column_memory: address %0d is read less than DISTANCE steps after its write", column_memory_waddr);
      end
      if (column_memory_waddr >= 11'd1920) $error("column_memory: write outside, address %0d", column_memory_waddr);
    end
    if (rst_ni && column_memory_re && column_memory_raddr >= 11'd1920) $error("column_memory: read outside, address %0d", column_memory_raddr);
  end
`endif

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    rows_0_sum_sums_values_0_q = 11'h0;
    rows_1_sum_sums_values_0_q = 11'h0;
    rows_2_sum_sums_values_0_q = 11'h0;
    rows_3_sum_sums_values_0_q = 11'h0;
    rows_4_sum_sums_values_0_q = 11'h0;
    rows_5_sum_sums_values_0_q = 11'h0;
    rows_6_sum_sums_values_0_q = 11'h0;
    rows_7_sum_sums_values_0_q = 11'h0;
    rows_8_sum_sums_values_0_q = 11'h0;
    rows_9_sum_sums_values_0_q = 11'h0;
    rows_10_sum_sums_values_0_q = 11'h0;
    rows_11_sum_sums_values_0_q = 11'h0;
    rows_12_sum_sums_values_0_q = 11'h0;
    rows_13_sum_sums_values_0_q = 11'h0;
  end
`endif
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      rows_0_sum_sums_values_0_q <= sum_792;
      rows_1_sum_sums_values_0_q <= sum_796;
      rows_2_sum_sums_values_0_q <= sum_800;
      rows_3_sum_sums_values_0_q <= sum_804;
      rows_4_sum_sums_values_0_q <= sum_808;
      rows_5_sum_sums_values_0_q <= sum_812;
      rows_6_sum_sums_values_0_q <= sum_816;
      rows_7_sum_sums_values_0_q <= sum_820;
      rows_8_sum_sums_values_0_q <= sum_824;
      rows_9_sum_sums_values_0_q <= sum_828;
      rows_10_sum_sums_values_0_q <= sum_832;
      rows_11_sum_sums_values_0_q <= sum_836;
      rows_12_sum_sums_values_0_q <= sum_840;
      rows_13_sum_sums_values_0_q <= sum_844;
    end
  end

  logic [5:0] centres_values_3_seen_grey_s7_q;
  logic centre_marks_values_3_first_s7_q;
  logic centre_marks_values_3_last_s7_q;
  logic and_853_s7_q;
  logic and_854_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      centres_values_3_seen_grey_s7_q <= centres_values_3_seen_grey_s6_q;
      centre_marks_values_3_first_s7_q <= centre_marks_values_3_first_s6_q;
      centre_marks_values_3_last_s7_q <= centre_marks_values_3_last_s6_q;
      and_853_s7_q <= and_853_s6_q;
      and_854_s7_q <= and_854_s6_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign sum_0_o = rows_0_sum_sums_values_0_q;
  assign sum_1_o = rows_1_sum_sums_values_0_q;
  assign sum_2_o = rows_2_sum_sums_values_0_q;
  assign sum_3_o = rows_3_sum_sums_values_0_q;
  assign sum_4_o = rows_4_sum_sums_values_0_q;
  assign sum_5_o = rows_5_sum_sums_values_0_q;
  assign sum_6_o = rows_6_sum_sums_values_0_q;
  assign sum_7_o = rows_7_sum_sums_values_0_q;
  assign sum_8_o = rows_8_sum_sums_values_0_q;
  assign sum_9_o = rows_9_sum_sums_values_0_q;
  assign sum_10_o = rows_10_sum_sums_values_0_q;
  assign sum_11_o = rows_11_sum_sums_values_0_q;
  assign sum_12_o = rows_12_sum_sums_values_0_q;
  assign evidence_o = rows_13_sum_sums_values_0_q;
  assign grey_o = centres_values_3_seen_grey_s7_q;
  assign known_o = and_853_s7_q;
  assign exists_o = and_854_s7_q;
  assign marks_first_o = centre_marks_values_3_first_s7_q;
  assign marks_last_o = centre_marks_values_3_last_s7_q;
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
  assign unused_bits = ^grey_i[1:0];

endmodule
