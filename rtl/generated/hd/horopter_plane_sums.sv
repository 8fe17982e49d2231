// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::PlaneSums<horopter::hls::profiles::hd>, hls/stages/plane_sums.hpp. Do not edit.
//
// Latency 6 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 3510 bits, pipeline 1354 bits, memories 541440 bits.
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
  output logic [10:0] sum_13_o,
  output logic [10:0] sum_14_o,
  output logic [10:0] sum_15_o,
  output logic [10:0] sum_16_o,
  output logic [10:0] sum_17_o,
  output logic [10:0] sum_18_o,
  output logic [10:0] evidence_o,
  output logic [5:0] grey_o,
  output logic known_o,
  output logic exists_o,
  output logic marks_first_o,
  output logic marks_last_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;

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
  logic [5:0] seen_values_19_grey_q;
  logic seen_values_19_exists_q;
  logic [5:0] seen_values_20_grey_q;
  logic seen_values_20_exists_q;
  logic [5:0] seen_values_21_grey_q;
  logic seen_values_21_exists_q;
  logic [5:0] seen_values_22_grey_q;
  logic seen_values_22_exists_q;
  logic [5:0] seen_values_23_grey_q;
  logic seen_values_23_exists_q;
  logic [5:0] seen_values_24_grey_q;
  logic seen_values_24_exists_q;
  // hls/stages/plane_sums.hpp:63
  logic or_629;
  assign or_629 = marks_first_i | arriving_row_ended_q;
  logic [10:0] select_630;
  assign select_630 = or_629 ? 11'h0 : arriving_column_q;

  // Memory feature_memory, 1920 x 91, DISTANCE 16, hls/stages/plane_sums.hpp:166; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] feature_memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) feature_memory_mem[i] = 91'h0;
`endif
  logic [10:0] feature_memory_raddr;
  assign feature_memory_raddr = select_630;
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
      seen_values_19_grey_q <= 6'h0;
      seen_values_19_exists_q <= 1'b0;
      seen_values_20_grey_q <= 6'h0;
      seen_values_20_exists_q <= 1'b0;
      seen_values_21_grey_q <= 6'h0;
      seen_values_21_exists_q <= 1'b0;
      seen_values_22_grey_q <= 6'h0;
      seen_values_22_exists_q <= 1'b0;
      seen_values_23_grey_q <= 6'h0;
      seen_values_23_exists_q <= 1'b0;
      seen_values_24_grey_q <= 6'h0;
      seen_values_24_exists_q <= 1'b0;
    end else if (s0_en) begin
      arriving_column_q <= select_630 + 11'h1;
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
      seen_values_19_grey_q <= seen_values_18_grey_q;
      seen_values_19_exists_q <= seen_values_18_exists_q;
      seen_values_20_grey_q <= seen_values_19_grey_q;
      seen_values_20_exists_q <= seen_values_19_exists_q;
      seen_values_21_grey_q <= seen_values_20_grey_q;
      seen_values_21_exists_q <= seen_values_20_exists_q;
      seen_values_22_grey_q <= seen_values_21_grey_q;
      seen_values_22_exists_q <= seen_values_21_exists_q;
      seen_values_23_grey_q <= seen_values_22_grey_q;
      seen_values_23_exists_q <= seen_values_22_exists_q;
      seen_values_24_grey_q <= seen_values_23_grey_q;
      seen_values_24_exists_q <= seen_values_23_exists_q;
    end
  end

  logic [5:0] left_s1_q;
  logic [5:0] right_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic [5:0] seen_values_24_grey_s1_q;
  logic seen_values_24_exists_s1_q;
  logic or_629_s1_q;
  logic [10:0] select_630_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      left_s1_q <= $unsigned(left_i);
      right_s1_q <= $unsigned(right_i);
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      seen_values_24_grey_s1_q <= seen_values_24_grey_q;
      seen_values_24_exists_s1_q <= seen_values_24_exists_q;
      or_629_s1_q <= or_629;
      select_630_s1_q <= select_630;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [10:0] delayed_column_q;
  logic delayed_row_ended_q;
  logic running_q;
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
  logic [5:0] entering_values_18_features_left_q;
  logic [5:0] entering_values_18_features_right_q;
  logic [5:0] entering_values_19_features_left_q;
  logic [5:0] entering_values_19_features_right_q;
  logic [5:0] entering_values_20_features_left_q;
  logic [5:0] entering_values_20_features_right_q;
  logic [5:0] entering_values_21_features_left_q;
  logic [5:0] entering_values_21_features_right_q;
  logic [5:0] entering_values_22_features_left_q;
  logic [5:0] entering_values_22_features_right_q;
  logic [5:0] entering_values_23_features_left_q;
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
  logic [5:0] entering_values_36_features_right_q;
  logic [5:0] entering_values_37_features_right_q;
  logic [5:0] entering_values_38_features_right_q;
  logic [5:0] entering_values_39_features_right_q;
  logic [5:0] entering_values_40_features_right_q;
  logic [5:0] entering_values_41_features_right_q;
  logic [5:0] entering_values_42_features_right_q;
  logic [5:0] entering_values_43_features_right_q;
  logic [5:0] entering_values_44_features_right_q;
  logic [5:0] entering_values_45_features_right_q;
  logic [5:0] entering_values_46_features_right_q;
  logic [5:0] entering_values_47_features_right_q;
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
  logic [5:0] leaving_values_18_features_left_q;
  logic [5:0] leaving_values_18_features_right_q;
  logic [5:0] leaving_values_19_features_left_q;
  logic [5:0] leaving_values_19_features_right_q;
  logic [5:0] leaving_values_20_features_left_q;
  logic [5:0] leaving_values_20_features_right_q;
  logic [5:0] leaving_values_21_features_left_q;
  logic [5:0] leaving_values_21_features_right_q;
  logic [5:0] leaving_values_22_features_left_q;
  logic [5:0] leaving_values_22_features_right_q;
  logic [5:0] leaving_values_23_features_left_q;
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
  logic [5:0] leaving_values_36_features_right_q;
  logic [5:0] leaving_values_37_features_right_q;
  logic [5:0] leaving_values_38_features_right_q;
  logic [5:0] leaving_values_39_features_right_q;
  logic [5:0] leaving_values_40_features_right_q;
  logic [5:0] leaving_values_41_features_right_q;
  logic [5:0] leaving_values_42_features_right_q;
  logic [5:0] leaving_values_43_features_right_q;
  logic [5:0] leaving_values_44_features_right_q;
  logic [5:0] leaving_values_45_features_right_q;
  logic [5:0] leaving_values_46_features_right_q;
  logic [5:0] leaving_values_47_features_right_q;
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
  logic marks_values_20_first_q;
  logic marks_values_20_last_q;
  logic marks_values_21_first_q;
  logic marks_values_21_last_q;
  logic marks_values_22_first_q;
  logic marks_values_22_last_q;
  logic marks_values_23_first_q;
  logic marks_values_23_last_q;
  logic marks_values_24_first_q;
  logic marks_values_24_last_q;
  logic marks_values_25_first_q;
  logic marks_values_25_last_q;
  // hls/stages/plane_sums.hpp:81
  logic or_632;
  assign or_632 = delayed_row_ended_q | marks_values_25_first_q;
  logic [10:0] select_633;
  assign select_633 = or_632 ? 11'h0 : delayed_column_q;
  // hls/stages/plane_sums.hpp:82
  logic or_634;
  assign or_634 = running_q | marks_values_25_first_q;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_1037;
  assign difference_1037 = {entering_values_23_features_left_q[5], entering_values_23_features_left_q} - {entering_values_47_features_right_q[5], entering_values_47_features_right_q};
  logic [5:0] xor_1038;
  assign xor_1038 = difference_1037[5:0] ^ {6{difference_1037[6]}};
  logic [6:0] difference_1047;
  assign difference_1047 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_47_features_right_q[5], leaving_values_47_features_right_q};
  logic [5:0] xor_1048;
  assign xor_1048 = difference_1047[5:0] ^ {6{difference_1047[6]}};

  // Memory column_memory, 1920 x 191, DISTANCE 16, hls/stages/plane_sums.hpp:167; read in stage 1, written in stage 5: 1 < 5 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [190:0] column_memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) column_memory_mem[i] = 191'h0;
`endif
  logic [10:0] column_memory_raddr;
  assign column_memory_raddr = select_633;
  logic column_memory_re;
  assign column_memory_re = s1_en & or_634;
  logic [190:0] column_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (column_memory_re) column_memory_rdata_q <= column_memory_mem[column_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      delayed_column_q <= 11'h0;
      delayed_row_ended_q <= 1'b1;
      running_q <= 1'b0;
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
      entering_values_18_features_left_q <= 6'h0;
      entering_values_18_features_right_q <= 6'h0;
      entering_values_19_features_left_q <= 6'h0;
      entering_values_19_features_right_q <= 6'h0;
      entering_values_20_features_left_q <= 6'h0;
      entering_values_20_features_right_q <= 6'h0;
      entering_values_21_features_left_q <= 6'h0;
      entering_values_21_features_right_q <= 6'h0;
      entering_values_22_features_left_q <= 6'h0;
      entering_values_22_features_right_q <= 6'h0;
      entering_values_23_features_left_q <= 6'h0;
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
      entering_values_36_features_right_q <= 6'h0;
      entering_values_37_features_right_q <= 6'h0;
      entering_values_38_features_right_q <= 6'h0;
      entering_values_39_features_right_q <= 6'h0;
      entering_values_40_features_right_q <= 6'h0;
      entering_values_41_features_right_q <= 6'h0;
      entering_values_42_features_right_q <= 6'h0;
      entering_values_43_features_right_q <= 6'h0;
      entering_values_44_features_right_q <= 6'h0;
      entering_values_45_features_right_q <= 6'h0;
      entering_values_46_features_right_q <= 6'h0;
      entering_values_47_features_right_q <= 6'h0;
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
      leaving_values_18_features_left_q <= 6'h0;
      leaving_values_18_features_right_q <= 6'h0;
      leaving_values_19_features_left_q <= 6'h0;
      leaving_values_19_features_right_q <= 6'h0;
      leaving_values_20_features_left_q <= 6'h0;
      leaving_values_20_features_right_q <= 6'h0;
      leaving_values_21_features_left_q <= 6'h0;
      leaving_values_21_features_right_q <= 6'h0;
      leaving_values_22_features_left_q <= 6'h0;
      leaving_values_22_features_right_q <= 6'h0;
      leaving_values_23_features_left_q <= 6'h0;
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
      leaving_values_36_features_right_q <= 6'h0;
      leaving_values_37_features_right_q <= 6'h0;
      leaving_values_38_features_right_q <= 6'h0;
      leaving_values_39_features_right_q <= 6'h0;
      leaving_values_40_features_right_q <= 6'h0;
      leaving_values_41_features_right_q <= 6'h0;
      leaving_values_42_features_right_q <= 6'h0;
      leaving_values_43_features_right_q <= 6'h0;
      leaving_values_44_features_right_q <= 6'h0;
      leaving_values_45_features_right_q <= 6'h0;
      leaving_values_46_features_right_q <= 6'h0;
      leaving_values_47_features_right_q <= 6'h0;
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
      marks_values_20_first_q <= 1'b0;
      marks_values_20_last_q <= 1'b0;
      marks_values_21_first_q <= 1'b0;
      marks_values_21_last_q <= 1'b0;
      marks_values_22_first_q <= 1'b0;
      marks_values_22_last_q <= 1'b0;
      marks_values_23_first_q <= 1'b0;
      marks_values_23_last_q <= 1'b0;
      marks_values_24_first_q <= 1'b0;
      marks_values_24_last_q <= 1'b0;
      marks_values_25_first_q <= 1'b0;
      marks_values_25_last_q <= 1'b0;
    end else if (s1_en) begin
      delayed_column_q <= select_633 + 11'h1;
      delayed_row_ended_q <= marks_values_25_last_q;
      running_q <= or_634;
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
      entering_values_18_features_left_q <= entering_values_17_features_left_q;
      entering_values_18_features_right_q <= entering_values_17_features_right_q;
      entering_values_19_features_left_q <= entering_values_18_features_left_q;
      entering_values_19_features_right_q <= entering_values_18_features_right_q;
      entering_values_20_features_left_q <= entering_values_19_features_left_q;
      entering_values_20_features_right_q <= entering_values_19_features_right_q;
      entering_values_21_features_left_q <= entering_values_20_features_left_q;
      entering_values_21_features_right_q <= entering_values_20_features_right_q;
      entering_values_22_features_left_q <= entering_values_21_features_left_q;
      entering_values_22_features_right_q <= entering_values_21_features_right_q;
      entering_values_23_features_left_q <= entering_values_22_features_left_q;
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
      entering_values_36_features_right_q <= entering_values_35_features_right_q;
      entering_values_37_features_right_q <= entering_values_36_features_right_q;
      entering_values_38_features_right_q <= entering_values_37_features_right_q;
      entering_values_39_features_right_q <= entering_values_38_features_right_q;
      entering_values_40_features_right_q <= entering_values_39_features_right_q;
      entering_values_41_features_right_q <= entering_values_40_features_right_q;
      entering_values_42_features_right_q <= entering_values_41_features_right_q;
      entering_values_43_features_right_q <= entering_values_42_features_right_q;
      entering_values_44_features_right_q <= entering_values_43_features_right_q;
      entering_values_45_features_right_q <= entering_values_44_features_right_q;
      entering_values_46_features_right_q <= entering_values_45_features_right_q;
      entering_values_47_features_right_q <= entering_values_46_features_right_q;
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
      leaving_values_18_features_left_q <= leaving_values_17_features_left_q;
      leaving_values_18_features_right_q <= leaving_values_17_features_right_q;
      leaving_values_19_features_left_q <= leaving_values_18_features_left_q;
      leaving_values_19_features_right_q <= leaving_values_18_features_right_q;
      leaving_values_20_features_left_q <= leaving_values_19_features_left_q;
      leaving_values_20_features_right_q <= leaving_values_19_features_right_q;
      leaving_values_21_features_left_q <= leaving_values_20_features_left_q;
      leaving_values_21_features_right_q <= leaving_values_20_features_right_q;
      leaving_values_22_features_left_q <= leaving_values_21_features_left_q;
      leaving_values_22_features_right_q <= leaving_values_21_features_right_q;
      leaving_values_23_features_left_q <= leaving_values_22_features_left_q;
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
      leaving_values_36_features_right_q <= leaving_values_35_features_right_q;
      leaving_values_37_features_right_q <= leaving_values_36_features_right_q;
      leaving_values_38_features_right_q <= leaving_values_37_features_right_q;
      leaving_values_39_features_right_q <= leaving_values_38_features_right_q;
      leaving_values_40_features_right_q <= leaving_values_39_features_right_q;
      leaving_values_41_features_right_q <= leaving_values_40_features_right_q;
      leaving_values_42_features_right_q <= leaving_values_41_features_right_q;
      leaving_values_43_features_right_q <= leaving_values_42_features_right_q;
      leaving_values_44_features_right_q <= leaving_values_43_features_right_q;
      leaving_values_45_features_right_q <= leaving_values_44_features_right_q;
      leaving_values_46_features_right_q <= leaving_values_45_features_right_q;
      leaving_values_47_features_right_q <= leaving_values_46_features_right_q;
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
      marks_values_20_first_q <= marks_values_19_first_q;
      marks_values_20_last_q <= marks_values_19_last_q;
      marks_values_21_first_q <= marks_values_20_first_q;
      marks_values_21_last_q <= marks_values_20_last_q;
      marks_values_22_first_q <= marks_values_21_first_q;
      marks_values_22_last_q <= marks_values_21_last_q;
      marks_values_23_first_q <= marks_values_22_first_q;
      marks_values_23_last_q <= marks_values_22_last_q;
      marks_values_24_first_q <= marks_values_23_first_q;
      marks_values_24_last_q <= marks_values_23_last_q;
      marks_values_25_first_q <= marks_values_24_first_q;
      marks_values_25_last_q <= marks_values_24_last_q;
    end
  end

  logic mask_s2_q;
  logic [5:0] entering_values_23_features_left_s2_q;
  logic [5:0] leaving_values_23_features_left_s2_q;
  logic marks_values_25_first_s2_q;
  logic [5:0] seen_values_24_grey_s2_q;
  logic seen_values_24_exists_s2_q;
  logic or_629_s2_q;
  logic [10:0] select_630_s2_q;
  logic [78:0] feature_memory_rdata_s2_q;
  logic or_632_s2_q;
  logic [10:0] select_633_s2_q;
  logic [6:0] sum_1039_s2_q;
  logic [6:0] sum_1049_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      mask_s2_q <= mask_s1_q;
      entering_values_23_features_left_s2_q <= entering_values_23_features_left_q;
      leaving_values_23_features_left_s2_q <= leaving_values_23_features_left_q;
      marks_values_25_first_s2_q <= marks_values_25_first_q;
      seen_values_24_grey_s2_q <= seen_values_24_grey_s1_q;
      seen_values_24_exists_s2_q <= seen_values_24_exists_s1_q;
      or_629_s2_q <= or_629_s1_q;
      select_630_s2_q <= select_630_s1_q;
      feature_memory_rdata_s2_q <= {feature_memory_rdata_q[90], feature_memory_rdata_q[77:0]};
      or_632_s2_q <= or_632;
      select_633_s2_q <= select_633;
      sum_1039_s2_q <= {6'h0, difference_1037[6]} + {1'b0, xor_1038};
      sum_1049_s2_q <= {6'h0, difference_1047[6]} + {1'b0, xor_1048};
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [2:0] arriving_rows_q;
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
  logic entering_values_36_features_mask_q;
  logic entering_values_36_row_q;
  logic entering_values_37_features_mask_q;
  logic entering_values_37_row_q;
  logic entering_values_38_features_mask_q;
  logic entering_values_38_row_q;
  logic entering_values_39_features_mask_q;
  logic entering_values_39_row_q;
  logic entering_values_40_features_mask_q;
  logic entering_values_40_row_q;
  logic entering_values_41_features_mask_q;
  logic entering_values_41_row_q;
  logic entering_values_42_features_mask_q;
  logic entering_values_42_row_q;
  logic entering_values_43_features_mask_q;
  logic entering_values_43_row_q;
  logic entering_values_44_features_mask_q;
  logic entering_values_44_row_q;
  logic entering_values_45_features_mask_q;
  logic entering_values_45_row_q;
  logic entering_values_46_features_mask_q;
  logic entering_values_46_row_q;
  logic entering_values_47_features_mask_q;
  logic entering_values_47_row_q;
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
  logic leaving_values_36_features_mask_q;
  logic leaving_values_37_features_mask_q;
  logic leaving_values_38_features_mask_q;
  logic leaving_values_39_features_mask_q;
  logic leaving_values_40_features_mask_q;
  logic leaving_values_41_features_mask_q;
  logic leaving_values_42_features_mask_q;
  logic leaving_values_43_features_mask_q;
  logic leaving_values_44_features_mask_q;
  logic leaving_values_45_features_mask_q;
  logic leaving_values_46_features_mask_q;
  logic leaving_values_47_features_mask_q;
  logic centre_marks_values_0_first_q;
  logic centre_marks_values_0_last_q;
  logic centre_marks_values_1_first_q;
  logic centre_marks_values_1_last_q;
  logic centre_marks_values_2_first_q;
  logic centre_marks_values_2_last_q;
  logic centre_marks_values_3_first_q;
  logic centre_marks_values_3_last_q;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_640;
  assign difference_640 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_0_features_right_q[5], entering_values_0_features_right_q};
  logic [5:0] xor_641;
  assign xor_641 = difference_640[5:0] ^ {6{difference_640[6]}};
  logic [6:0] difference_652;
  assign difference_652 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_0_features_right_q[5], leaving_values_0_features_right_q};
  // hls/stages/plane_sums.hpp:63
  logic [2:0] select_656;
  assign select_656 = marks_values_0_first_q ? 3'h0 : arriving_rows_q;
  logic equal_657;
  assign equal_657 = select_656 == 3'h7;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_667;
  assign difference_667 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_6_features_right_q[5], entering_values_6_features_right_q};
  logic [5:0] xor_668;
  assign xor_668 = difference_667[5:0] ^ {6{difference_667[6]}};
  logic [6:0] difference_677;
  assign difference_677 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_6_features_right_q[5], leaving_values_6_features_right_q};
  logic [5:0] xor_678;
  assign xor_678 = difference_677[5:0] ^ {6{difference_677[6]}};
  logic [6:0] difference_689;
  assign difference_689 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_11_features_right_q[5], entering_values_11_features_right_q};
  logic [5:0] xor_690;
  assign xor_690 = difference_689[5:0] ^ {6{difference_689[6]}};
  logic [6:0] difference_699;
  assign difference_699 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_11_features_right_q[5], leaving_values_11_features_right_q};
  logic [5:0] xor_700;
  assign xor_700 = difference_699[5:0] ^ {6{difference_699[6]}};
  logic [6:0] difference_711;
  assign difference_711 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_15_features_right_q[5], entering_values_15_features_right_q};
  logic [5:0] xor_712;
  assign xor_712 = difference_711[5:0] ^ {6{difference_711[6]}};
  logic [6:0] difference_721;
  assign difference_721 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_15_features_right_q[5], leaving_values_15_features_right_q};
  logic [5:0] xor_722;
  assign xor_722 = difference_721[5:0] ^ {6{difference_721[6]}};
  logic [6:0] difference_733;
  assign difference_733 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_18_features_right_q[5], entering_values_18_features_right_q};
  logic [5:0] xor_734;
  assign xor_734 = difference_733[5:0] ^ {6{difference_733[6]}};
  logic [6:0] difference_743;
  assign difference_743 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_18_features_right_q[5], leaving_values_18_features_right_q};
  logic [5:0] xor_744;
  assign xor_744 = difference_743[5:0] ^ {6{difference_743[6]}};
  logic [6:0] difference_755;
  assign difference_755 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_20_features_right_q[5], entering_values_20_features_right_q};
  logic [5:0] xor_756;
  assign xor_756 = difference_755[5:0] ^ {6{difference_755[6]}};
  logic [6:0] difference_765;
  assign difference_765 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_20_features_right_q[5], leaving_values_20_features_right_q};
  logic [5:0] xor_766;
  assign xor_766 = difference_765[5:0] ^ {6{difference_765[6]}};
  logic [6:0] difference_777;
  assign difference_777 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_21_features_right_q[5], entering_values_21_features_right_q};
  logic [5:0] xor_778;
  assign xor_778 = difference_777[5:0] ^ {6{difference_777[6]}};
  logic [6:0] difference_787;
  assign difference_787 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_21_features_right_q[5], leaving_values_21_features_right_q};
  logic [5:0] xor_788;
  assign xor_788 = difference_787[5:0] ^ {6{difference_787[6]}};
  logic [6:0] difference_799;
  assign difference_799 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_22_features_right_q[5], entering_values_22_features_right_q};
  logic [5:0] xor_800;
  assign xor_800 = difference_799[5:0] ^ {6{difference_799[6]}};
  logic [6:0] difference_809;
  assign difference_809 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_22_features_right_q[5], leaving_values_22_features_right_q};
  logic [5:0] xor_810;
  assign xor_810 = difference_809[5:0] ^ {6{difference_809[6]}};
  logic [6:0] difference_821;
  assign difference_821 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_23_features_right_q[5], entering_values_23_features_right_q};
  logic [5:0] xor_822;
  assign xor_822 = difference_821[5:0] ^ {6{difference_821[6]}};
  logic [6:0] difference_831;
  assign difference_831 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_23_features_right_q[5], leaving_values_23_features_right_q};
  logic [5:0] xor_832;
  assign xor_832 = difference_831[5:0] ^ {6{difference_831[6]}};
  logic [6:0] difference_843;
  assign difference_843 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_24_features_right_q[5], entering_values_24_features_right_q};
  logic [5:0] xor_844;
  assign xor_844 = difference_843[5:0] ^ {6{difference_843[6]}};
  logic [6:0] difference_850;
  assign difference_850 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_24_features_right_q[5], leaving_values_24_features_right_q};
  logic [5:0] xor_851;
  assign xor_851 = difference_850[5:0] ^ {6{difference_850[6]}};
  logic [6:0] difference_861;
  assign difference_861 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_25_features_right_q[5], entering_values_25_features_right_q};
  logic [5:0] xor_862;
  assign xor_862 = difference_861[5:0] ^ {6{difference_861[6]}};
  logic [6:0] difference_871;
  assign difference_871 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_25_features_right_q[5], leaving_values_25_features_right_q};
  logic [5:0] xor_872;
  assign xor_872 = difference_871[5:0] ^ {6{difference_871[6]}};
  logic [6:0] difference_883;
  assign difference_883 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_26_features_right_q[5], entering_values_26_features_right_q};
  logic [5:0] xor_884;
  assign xor_884 = difference_883[5:0] ^ {6{difference_883[6]}};
  logic [6:0] difference_893;
  assign difference_893 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_26_features_right_q[5], leaving_values_26_features_right_q};
  logic [5:0] xor_894;
  assign xor_894 = difference_893[5:0] ^ {6{difference_893[6]}};
  logic [6:0] difference_905;
  assign difference_905 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_27_features_right_q[5], entering_values_27_features_right_q};
  logic [5:0] xor_906;
  assign xor_906 = difference_905[5:0] ^ {6{difference_905[6]}};
  logic [6:0] difference_915;
  assign difference_915 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_27_features_right_q[5], leaving_values_27_features_right_q};
  logic [5:0] xor_916;
  assign xor_916 = difference_915[5:0] ^ {6{difference_915[6]}};
  logic [6:0] difference_927;
  assign difference_927 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_28_features_right_q[5], entering_values_28_features_right_q};
  logic [5:0] xor_928;
  assign xor_928 = difference_927[5:0] ^ {6{difference_927[6]}};
  logic [6:0] difference_937;
  assign difference_937 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_28_features_right_q[5], leaving_values_28_features_right_q};
  logic [5:0] xor_938;
  assign xor_938 = difference_937[5:0] ^ {6{difference_937[6]}};
  logic [6:0] difference_949;
  assign difference_949 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_30_features_right_q[5], entering_values_30_features_right_q};
  logic [5:0] xor_950;
  assign xor_950 = difference_949[5:0] ^ {6{difference_949[6]}};
  logic [6:0] difference_959;
  assign difference_959 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_30_features_right_q[5], leaving_values_30_features_right_q};
  logic [5:0] xor_960;
  assign xor_960 = difference_959[5:0] ^ {6{difference_959[6]}};
  logic [6:0] difference_971;
  assign difference_971 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_33_features_right_q[5], entering_values_33_features_right_q};
  logic [5:0] xor_972;
  assign xor_972 = difference_971[5:0] ^ {6{difference_971[6]}};
  logic [6:0] difference_981;
  assign difference_981 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_33_features_right_q[5], leaving_values_33_features_right_q};
  logic [5:0] xor_982;
  assign xor_982 = difference_981[5:0] ^ {6{difference_981[6]}};
  logic [6:0] difference_993;
  assign difference_993 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_37_features_right_q[5], entering_values_37_features_right_q};
  logic [5:0] xor_994;
  assign xor_994 = difference_993[5:0] ^ {6{difference_993[6]}};
  logic [6:0] difference_1003;
  assign difference_1003 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_37_features_right_q[5], leaving_values_37_features_right_q};
  logic [5:0] xor_1004;
  assign xor_1004 = difference_1003[5:0] ^ {6{difference_1003[6]}};
  logic [6:0] difference_1015;
  assign difference_1015 = {entering_values_23_features_left_s2_q[5], entering_values_23_features_left_s2_q} - {entering_values_42_features_right_q[5], entering_values_42_features_right_q};
  logic [5:0] xor_1016;
  assign xor_1016 = difference_1015[5:0] ^ {6{difference_1015[6]}};
  logic [6:0] difference_1025;
  assign difference_1025 = {leaving_values_23_features_left_s2_q[5], leaving_values_23_features_left_s2_q} - {leaving_values_42_features_right_q[5], leaving_values_42_features_right_q};
  logic [5:0] xor_1026;
  assign xor_1026 = difference_1025[5:0] ^ {6{difference_1025[6]}};
  // hls/stages/plane_sums.hpp:157
  logic not_1042;
  assign not_1042 = ~(entering_values_23_row_q ^ entering_values_47_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1044;
  assign select_1044 = ((sum_1039_s2_q[6:5] == 2'h0) & not_1042) ? sum_1039_s2_q[4:0] : 5'h1f;
  logic [4:0] select_1046;
  assign select_1046 = entering_values_23_features_mask_q ? (entering_values_47_features_mask_q ? select_1044 : 5'h1f) : 5'h0;
  logic [4:0] select_1052;
  assign select_1052 = (not_1042 & (sum_1049_s2_q[6:5] == 2'h0)) ? sum_1049_s2_q[4:0] : 5'h1f;
  logic [4:0] select_1054;
  assign select_1054 = leaving_values_23_features_mask_q ? (leaving_values_47_features_mask_q ? select_1052 : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:163
  logic [4:0] xor_1059;
  assign xor_1059 = entering_values_23_features_left_s2_q[4:0] ^ {5{entering_values_23_features_left_s2_q[5]}};
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1061;
  assign select_1061 = entering_values_23_features_mask_q ? ({4'h0, entering_values_23_features_left_s2_q[5]} + xor_1059) : 5'h0;
  // hls/stages/plane_sums.hpp:163
  logic [4:0] xor_1062;
  assign xor_1062 = leaving_values_23_features_left_s2_q[4:0] ^ {5{leaving_values_23_features_left_s2_q[5]}};
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1064;
  assign select_1064 = leaving_values_23_features_mask_q ? ({4'h0, leaving_values_23_features_left_s2_q[5]} + xor_1062) : 5'h0;
  // hls/stages/plane_sums.hpp:63
  logic not_1073;
  assign not_1073 = ~equal_657;
  logic [2:0] select_1075;
  assign select_1075 = marks_values_0_last_q ? (select_656 + {2'h0, not_1073}) : select_656;

  // Memory feature_memory, write
  logic [10:0] feature_memory_waddr;
  assign feature_memory_waddr = select_630_s2_q;
  logic feature_memory_we;
  assign feature_memory_we = s2_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
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
      entering_values_36_features_mask_q <= 1'b0;
      entering_values_36_row_q <= 1'b0;
      entering_values_37_features_mask_q <= 1'b0;
      entering_values_37_row_q <= 1'b0;
      entering_values_38_features_mask_q <= 1'b0;
      entering_values_38_row_q <= 1'b0;
      entering_values_39_features_mask_q <= 1'b0;
      entering_values_39_row_q <= 1'b0;
      entering_values_40_features_mask_q <= 1'b0;
      entering_values_40_row_q <= 1'b0;
      entering_values_41_features_mask_q <= 1'b0;
      entering_values_41_row_q <= 1'b0;
      entering_values_42_features_mask_q <= 1'b0;
      entering_values_42_row_q <= 1'b0;
      entering_values_43_features_mask_q <= 1'b0;
      entering_values_43_row_q <= 1'b0;
      entering_values_44_features_mask_q <= 1'b0;
      entering_values_44_row_q <= 1'b0;
      entering_values_45_features_mask_q <= 1'b0;
      entering_values_45_row_q <= 1'b0;
      entering_values_46_features_mask_q <= 1'b0;
      entering_values_46_row_q <= 1'b0;
      entering_values_47_features_mask_q <= 1'b0;
      entering_values_47_row_q <= 1'b0;
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
      leaving_values_36_features_mask_q <= 1'b0;
      leaving_values_37_features_mask_q <= 1'b0;
      leaving_values_38_features_mask_q <= 1'b0;
      leaving_values_39_features_mask_q <= 1'b0;
      leaving_values_40_features_mask_q <= 1'b0;
      leaving_values_41_features_mask_q <= 1'b0;
      leaving_values_42_features_mask_q <= 1'b0;
      leaving_values_43_features_mask_q <= 1'b0;
      leaving_values_44_features_mask_q <= 1'b0;
      leaving_values_45_features_mask_q <= 1'b0;
      leaving_values_46_features_mask_q <= 1'b0;
      leaving_values_47_features_mask_q <= 1'b0;
      centre_marks_values_0_first_q <= 1'b0;
      centre_marks_values_0_last_q <= 1'b0;
      centre_marks_values_1_first_q <= 1'b0;
      centre_marks_values_1_last_q <= 1'b0;
      centre_marks_values_2_first_q <= 1'b0;
      centre_marks_values_2_last_q <= 1'b0;
      centre_marks_values_3_first_q <= 1'b0;
      centre_marks_values_3_last_q <= 1'b0;
    end else if (s2_en) begin
      arriving_rows_q <= select_1075;
      row_parity_q <= row_parity_q ^ or_629_s2_q;
      entering_values_0_features_mask_q <= mask_s2_q;
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
      entering_values_36_features_mask_q <= entering_values_35_features_mask_q;
      entering_values_36_row_q <= entering_values_35_row_q;
      entering_values_37_features_mask_q <= entering_values_36_features_mask_q;
      entering_values_37_row_q <= entering_values_36_row_q;
      entering_values_38_features_mask_q <= entering_values_37_features_mask_q;
      entering_values_38_row_q <= entering_values_37_row_q;
      entering_values_39_features_mask_q <= entering_values_38_features_mask_q;
      entering_values_39_row_q <= entering_values_38_row_q;
      entering_values_40_features_mask_q <= entering_values_39_features_mask_q;
      entering_values_40_row_q <= entering_values_39_row_q;
      entering_values_41_features_mask_q <= entering_values_40_features_mask_q;
      entering_values_41_row_q <= entering_values_40_row_q;
      entering_values_42_features_mask_q <= entering_values_41_features_mask_q;
      entering_values_42_row_q <= entering_values_41_row_q;
      entering_values_43_features_mask_q <= entering_values_42_features_mask_q;
      entering_values_43_row_q <= entering_values_42_row_q;
      entering_values_44_features_mask_q <= entering_values_43_features_mask_q;
      entering_values_44_row_q <= entering_values_43_row_q;
      entering_values_45_features_mask_q <= entering_values_44_features_mask_q;
      entering_values_45_row_q <= entering_values_44_row_q;
      entering_values_46_features_mask_q <= entering_values_45_features_mask_q;
      entering_values_46_row_q <= entering_values_45_row_q;
      entering_values_47_features_mask_q <= entering_values_46_features_mask_q;
      entering_values_47_row_q <= entering_values_46_row_q;
      leaving_values_0_features_mask_q <= feature_memory_rdata_s2_q[78] & equal_657;
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
      leaving_values_36_features_mask_q <= leaving_values_35_features_mask_q;
      leaving_values_37_features_mask_q <= leaving_values_36_features_mask_q;
      leaving_values_38_features_mask_q <= leaving_values_37_features_mask_q;
      leaving_values_39_features_mask_q <= leaving_values_38_features_mask_q;
      leaving_values_40_features_mask_q <= leaving_values_39_features_mask_q;
      leaving_values_41_features_mask_q <= leaving_values_40_features_mask_q;
      leaving_values_42_features_mask_q <= leaving_values_41_features_mask_q;
      leaving_values_43_features_mask_q <= leaving_values_42_features_mask_q;
      leaving_values_44_features_mask_q <= leaving_values_43_features_mask_q;
      leaving_values_45_features_mask_q <= leaving_values_44_features_mask_q;
      leaving_values_46_features_mask_q <= leaving_values_45_features_mask_q;
      leaving_values_47_features_mask_q <= leaving_values_46_features_mask_q;
      centre_marks_values_0_first_q <= marks_values_25_first_s2_q;
      centre_marks_values_0_last_q <= delayed_row_ended_q;
      centre_marks_values_1_first_q <= centre_marks_values_0_first_q;
      centre_marks_values_1_last_q <= centre_marks_values_0_last_q;
      centre_marks_values_2_first_q <= centre_marks_values_1_first_q;
      centre_marks_values_2_last_q <= centre_marks_values_1_last_q;
      centre_marks_values_3_first_q <= centre_marks_values_2_first_q;
      centre_marks_values_3_last_q <= centre_marks_values_2_last_q;
    end
  end

  logic [5:0] seen_values_24_grey_s3_q;
  logic seen_values_24_exists_s3_q;
  logic centre_marks_values_3_first_s3_q;
  logic centre_marks_values_3_last_s3_q;
  logic or_632_s3_q;
  logic [10:0] select_633_s3_q;
  logic or_634_s3_q;
  logic [190:0] column_memory_rdata_s3_q;
  logic [6:0] sum_642_s3_q;
  logic not_647_s3_q;
  logic difference_652_s3_q;
  logic [5:0] xor_653_s3_q;
  logic [6:0] sum_669_s3_q;
  logic [6:0] sum_679_s3_q;
  logic [6:0] sum_691_s3_q;
  logic [6:0] sum_701_s3_q;
  logic [6:0] sum_713_s3_q;
  logic [6:0] sum_723_s3_q;
  logic [6:0] sum_735_s3_q;
  logic [6:0] sum_745_s3_q;
  logic [6:0] sum_757_s3_q;
  logic [6:0] sum_767_s3_q;
  logic [6:0] sum_779_s3_q;
  logic [6:0] sum_789_s3_q;
  logic [6:0] sum_801_s3_q;
  logic [6:0] sum_811_s3_q;
  logic [6:0] sum_823_s3_q;
  logic [6:0] sum_833_s3_q;
  logic [6:0] sum_845_s3_q;
  logic [6:0] sum_852_s3_q;
  logic [6:0] sum_863_s3_q;
  logic [6:0] sum_873_s3_q;
  logic [6:0] sum_885_s3_q;
  logic [6:0] sum_895_s3_q;
  logic [6:0] sum_907_s3_q;
  logic [6:0] sum_917_s3_q;
  logic [6:0] sum_929_s3_q;
  logic [6:0] sum_939_s3_q;
  logic [6:0] sum_951_s3_q;
  logic [6:0] sum_961_s3_q;
  logic [6:0] sum_973_s3_q;
  logic [6:0] sum_983_s3_q;
  logic [6:0] sum_995_s3_q;
  logic [6:0] sum_1005_s3_q;
  logic [6:0] sum_1017_s3_q;
  logic [6:0] sum_1027_s3_q;
  logic [4:0] select_1046_s3_q;
  logic [4:0] select_1054_s3_q;
  logic [4:0] select_1061_s3_q;
  logic [4:0] select_1064_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      seen_values_24_grey_s3_q <= seen_values_24_grey_s2_q;
      seen_values_24_exists_s3_q <= seen_values_24_exists_s2_q;
      centre_marks_values_3_first_s3_q <= centre_marks_values_3_first_q;
      centre_marks_values_3_last_s3_q <= centre_marks_values_3_last_q;
      or_632_s3_q <= or_632_s2_q;
      select_633_s3_q <= select_633_s2_q;
      or_634_s3_q <= running_q;
      column_memory_rdata_s3_q <= column_memory_rdata_q;
      sum_642_s3_q <= {6'h0, difference_640[6]} + {1'b0, xor_641};
      not_647_s3_q <= ~(^{or_629_s2_q, entering_values_23_row_q, row_parity_q});
      difference_652_s3_q <= difference_652[6];
      xor_653_s3_q <= difference_652[5:0] ^ {6{difference_652[6]}};
      sum_669_s3_q <= {6'h0, difference_667[6]} + {1'b0, xor_668};
      sum_679_s3_q <= {6'h0, difference_677[6]} + {1'b0, xor_678};
      sum_691_s3_q <= {6'h0, difference_689[6]} + {1'b0, xor_690};
      sum_701_s3_q <= {6'h0, difference_699[6]} + {1'b0, xor_700};
      sum_713_s3_q <= {6'h0, difference_711[6]} + {1'b0, xor_712};
      sum_723_s3_q <= {6'h0, difference_721[6]} + {1'b0, xor_722};
      sum_735_s3_q <= {6'h0, difference_733[6]} + {1'b0, xor_734};
      sum_745_s3_q <= {6'h0, difference_743[6]} + {1'b0, xor_744};
      sum_757_s3_q <= {6'h0, difference_755[6]} + {1'b0, xor_756};
      sum_767_s3_q <= {6'h0, difference_765[6]} + {1'b0, xor_766};
      sum_779_s3_q <= {6'h0, difference_777[6]} + {1'b0, xor_778};
      sum_789_s3_q <= {6'h0, difference_787[6]} + {1'b0, xor_788};
      sum_801_s3_q <= {6'h0, difference_799[6]} + {1'b0, xor_800};
      sum_811_s3_q <= {6'h0, difference_809[6]} + {1'b0, xor_810};
      sum_823_s3_q <= {6'h0, difference_821[6]} + {1'b0, xor_822};
      sum_833_s3_q <= {6'h0, difference_831[6]} + {1'b0, xor_832};
      sum_845_s3_q <= {6'h0, difference_843[6]} + {1'b0, xor_844};
      sum_852_s3_q <= {6'h0, difference_850[6]} + {1'b0, xor_851};
      sum_863_s3_q <= {6'h0, difference_861[6]} + {1'b0, xor_862};
      sum_873_s3_q <= {6'h0, difference_871[6]} + {1'b0, xor_872};
      sum_885_s3_q <= {6'h0, difference_883[6]} + {1'b0, xor_884};
      sum_895_s3_q <= {6'h0, difference_893[6]} + {1'b0, xor_894};
      sum_907_s3_q <= {6'h0, difference_905[6]} + {1'b0, xor_906};
      sum_917_s3_q <= {6'h0, difference_915[6]} + {1'b0, xor_916};
      sum_929_s3_q <= {6'h0, difference_927[6]} + {1'b0, xor_928};
      sum_939_s3_q <= {6'h0, difference_937[6]} + {1'b0, xor_938};
      sum_951_s3_q <= {6'h0, difference_949[6]} + {1'b0, xor_950};
      sum_961_s3_q <= {6'h0, difference_959[6]} + {1'b0, xor_960};
      sum_973_s3_q <= {6'h0, difference_971[6]} + {1'b0, xor_972};
      sum_983_s3_q <= {6'h0, difference_981[6]} + {1'b0, xor_982};
      sum_995_s3_q <= {6'h0, difference_993[6]} + {1'b0, xor_994};
      sum_1005_s3_q <= {6'h0, difference_1003[6]} + {1'b0, xor_1004};
      sum_1017_s3_q <= {6'h0, difference_1015[6]} + {1'b0, xor_1016};
      sum_1027_s3_q <= {6'h0, difference_1025[6]} + {1'b0, xor_1026};
      select_1046_s3_q <= select_1046;
      select_1054_s3_q <= select_1054;
      select_1061_s3_q <= select_1061;
      select_1064_s3_q <= select_1064;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
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
  logic [2:0] select_636;
  assign select_636 = centre_marks_values_0_first_q ? 3'h0 : delayed_rows_q;
  logic equal_637;
  assign equal_637 = select_636 == 3'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above;
  assign above = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[7:0] : 8'h0);
  // hls/stages/plane_sums.hpp:158
  logic and_649;
  assign and_649 = (sum_642_s3_q[6:5] == 2'h0) & (entering_values_0_features_mask_q & not_647_s3_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_651;
  assign select_651 = entering_values_24_features_mask_q ? (and_649 ? sum_642_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] sum_654;
  assign sum_654 = {6'h0, difference_652_s3_q} + {1'b0, xor_653_s3_q};
  // hls/stages/plane_sums.hpp:158
  logic and_660;
  assign and_660 = (sum_654[6:5] == 2'h0) & (leaving_values_0_features_mask_q & not_647_s3_q);
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_2;
  assign above_2 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[15:8] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_672;
  assign not_672 = ~(entering_values_6_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_674;
  assign and_674 = (sum_669_s3_q[6:5] == 2'h0) & (entering_values_6_features_mask_q & not_672);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_676;
  assign select_676 = entering_values_24_features_mask_q ? (and_674 ? sum_669_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_682;
  assign and_682 = (sum_679_s3_q[6:5] == 2'h0) & (leaving_values_6_features_mask_q & not_672);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_684;
  assign select_684 = leaving_values_24_features_mask_q ? (and_682 ? sum_679_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_3;
  assign above_3 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[23:16] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_694;
  assign not_694 = ~(entering_values_11_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_696;
  assign and_696 = (sum_691_s3_q[6:5] == 2'h0) & (entering_values_11_features_mask_q & not_694);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_698;
  assign select_698 = entering_values_24_features_mask_q ? (and_696 ? sum_691_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_704;
  assign and_704 = (sum_701_s3_q[6:5] == 2'h0) & (leaving_values_11_features_mask_q & not_694);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_706;
  assign select_706 = leaving_values_24_features_mask_q ? (and_704 ? sum_701_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_4;
  assign above_4 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[31:24] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_716;
  assign not_716 = ~(entering_values_15_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_718;
  assign and_718 = (sum_713_s3_q[6:5] == 2'h0) & (entering_values_15_features_mask_q & not_716);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_720;
  assign select_720 = entering_values_24_features_mask_q ? (and_718 ? sum_713_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_726;
  assign and_726 = (sum_723_s3_q[6:5] == 2'h0) & (leaving_values_15_features_mask_q & not_716);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_728;
  assign select_728 = leaving_values_24_features_mask_q ? (and_726 ? sum_723_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_5;
  assign above_5 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[39:32] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_738;
  assign not_738 = ~(entering_values_18_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_740;
  assign and_740 = (sum_735_s3_q[6:5] == 2'h0) & (entering_values_18_features_mask_q & not_738);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_742;
  assign select_742 = entering_values_24_features_mask_q ? (and_740 ? sum_735_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_748;
  assign and_748 = (sum_745_s3_q[6:5] == 2'h0) & (leaving_values_18_features_mask_q & not_738);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_750;
  assign select_750 = leaving_values_24_features_mask_q ? (and_748 ? sum_745_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_6;
  assign above_6 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[47:40] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_760;
  assign not_760 = ~(entering_values_20_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_762;
  assign and_762 = (sum_757_s3_q[6:5] == 2'h0) & (entering_values_20_features_mask_q & not_760);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_764;
  assign select_764 = entering_values_24_features_mask_q ? (and_762 ? sum_757_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_770;
  assign and_770 = (sum_767_s3_q[6:5] == 2'h0) & (leaving_values_20_features_mask_q & not_760);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_772;
  assign select_772 = leaving_values_24_features_mask_q ? (and_770 ? sum_767_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_7;
  assign above_7 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[55:48] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_782;
  assign not_782 = ~(entering_values_21_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_784;
  assign and_784 = (sum_779_s3_q[6:5] == 2'h0) & (entering_values_21_features_mask_q & not_782);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_786;
  assign select_786 = entering_values_24_features_mask_q ? (and_784 ? sum_779_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_792;
  assign and_792 = (sum_789_s3_q[6:5] == 2'h0) & (leaving_values_21_features_mask_q & not_782);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_794;
  assign select_794 = leaving_values_24_features_mask_q ? (and_792 ? sum_789_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_8;
  assign above_8 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[63:56] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_804;
  assign not_804 = ~(entering_values_22_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_806;
  assign and_806 = (sum_801_s3_q[6:5] == 2'h0) & (entering_values_22_features_mask_q & not_804);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_808;
  assign select_808 = entering_values_24_features_mask_q ? (and_806 ? sum_801_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_814;
  assign and_814 = (sum_811_s3_q[6:5] == 2'h0) & (leaving_values_22_features_mask_q & not_804);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_816;
  assign select_816 = leaving_values_24_features_mask_q ? (and_814 ? sum_811_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_9;
  assign above_9 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[71:64] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_826;
  assign not_826 = ~(entering_values_23_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_828;
  assign and_828 = (sum_823_s3_q[6:5] == 2'h0) & (entering_values_23_features_mask_q & not_826);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_830;
  assign select_830 = entering_values_24_features_mask_q ? (and_828 ? sum_823_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_836;
  assign and_836 = (sum_833_s3_q[6:5] == 2'h0) & (leaving_values_23_features_mask_q & not_826);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_838;
  assign select_838 = leaving_values_24_features_mask_q ? (and_836 ? sum_833_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_10;
  assign above_10 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[79:72] : 8'h0);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_848;
  assign select_848 = (entering_values_24_features_mask_q & (sum_845_s3_q[6:5] == 2'h0)) ? sum_845_s3_q[4:0] : 5'h1f;
  logic [4:0] select_855;
  assign select_855 = (leaving_values_24_features_mask_q & (sum_852_s3_q[6:5] == 2'h0)) ? sum_852_s3_q[4:0] : 5'h1f;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_11;
  assign above_11 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[87:80] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_866;
  assign not_866 = ~(entering_values_24_row_q ^ entering_values_25_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_868;
  assign and_868 = (sum_863_s3_q[6:5] == 2'h0) & (entering_values_25_features_mask_q & not_866);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_870;
  assign select_870 = entering_values_24_features_mask_q ? (and_868 ? sum_863_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_876;
  assign and_876 = (sum_873_s3_q[6:5] == 2'h0) & (leaving_values_25_features_mask_q & not_866);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_878;
  assign select_878 = leaving_values_24_features_mask_q ? (and_876 ? sum_873_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_12;
  assign above_12 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[95:88] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_888;
  assign not_888 = ~(entering_values_24_row_q ^ entering_values_26_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_890;
  assign and_890 = (sum_885_s3_q[6:5] == 2'h0) & (entering_values_26_features_mask_q & not_888);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_892;
  assign select_892 = entering_values_24_features_mask_q ? (and_890 ? sum_885_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_898;
  assign and_898 = (sum_895_s3_q[6:5] == 2'h0) & (leaving_values_26_features_mask_q & not_888);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_900;
  assign select_900 = leaving_values_24_features_mask_q ? (and_898 ? sum_895_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_13;
  assign above_13 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[103:96] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_910;
  assign not_910 = ~(entering_values_24_row_q ^ entering_values_27_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_912;
  assign and_912 = (sum_907_s3_q[6:5] == 2'h0) & (entering_values_27_features_mask_q & not_910);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_914;
  assign select_914 = entering_values_24_features_mask_q ? (and_912 ? sum_907_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_920;
  assign and_920 = (sum_917_s3_q[6:5] == 2'h0) & (leaving_values_27_features_mask_q & not_910);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_922;
  assign select_922 = leaving_values_24_features_mask_q ? (and_920 ? sum_917_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_14;
  assign above_14 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[111:104] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_932;
  assign not_932 = ~(entering_values_24_row_q ^ entering_values_28_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_934;
  assign and_934 = (sum_929_s3_q[6:5] == 2'h0) & (entering_values_28_features_mask_q & not_932);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_936;
  assign select_936 = entering_values_24_features_mask_q ? (and_934 ? sum_929_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_942;
  assign and_942 = (sum_939_s3_q[6:5] == 2'h0) & (leaving_values_28_features_mask_q & not_932);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_944;
  assign select_944 = leaving_values_24_features_mask_q ? (and_942 ? sum_939_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_15;
  assign above_15 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[119:112] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_954;
  assign not_954 = ~(entering_values_24_row_q ^ entering_values_30_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_956;
  assign and_956 = (sum_951_s3_q[6:5] == 2'h0) & (entering_values_30_features_mask_q & not_954);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_958;
  assign select_958 = entering_values_24_features_mask_q ? (and_956 ? sum_951_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_964;
  assign and_964 = (sum_961_s3_q[6:5] == 2'h0) & (leaving_values_30_features_mask_q & not_954);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_966;
  assign select_966 = leaving_values_24_features_mask_q ? (and_964 ? sum_961_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_16;
  assign above_16 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[127:120] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_976;
  assign not_976 = ~(entering_values_24_row_q ^ entering_values_33_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_978;
  assign and_978 = (sum_973_s3_q[6:5] == 2'h0) & (entering_values_33_features_mask_q & not_976);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_980;
  assign select_980 = entering_values_24_features_mask_q ? (and_978 ? sum_973_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:158
  logic and_986;
  assign and_986 = (sum_983_s3_q[6:5] == 2'h0) & (leaving_values_33_features_mask_q & not_976);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_988;
  assign select_988 = leaving_values_24_features_mask_q ? (and_986 ? sum_983_s3_q[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_17;
  assign above_17 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[135:128] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_998;
  assign not_998 = ~(entering_values_24_row_q ^ entering_values_37_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1000;
  assign select_1000 = ((sum_995_s3_q[6:5] == 2'h0) & not_998) ? sum_995_s3_q[4:0] : 5'h1f;
  logic [4:0] select_1002;
  assign select_1002 = entering_values_24_features_mask_q ? (entering_values_37_features_mask_q ? select_1000 : 5'h1f) : 5'h0;
  logic [4:0] select_1008;
  assign select_1008 = (not_998 & (sum_1005_s3_q[6:5] == 2'h0)) ? sum_1005_s3_q[4:0] : 5'h1f;
  logic [4:0] select_1010;
  assign select_1010 = leaving_values_24_features_mask_q ? (leaving_values_37_features_mask_q ? select_1008 : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_18;
  assign above_18 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[143:136] : 8'h0);
  // hls/stages/plane_sums.hpp:157
  logic not_1020;
  assign not_1020 = ~(entering_values_24_row_q ^ entering_values_42_row_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1022;
  assign select_1022 = ((sum_1017_s3_q[6:5] == 2'h0) & not_1020) ? sum_1017_s3_q[4:0] : 5'h1f;
  logic [4:0] select_1024;
  assign select_1024 = entering_values_24_features_mask_q ? (entering_values_42_features_mask_q ? select_1022 : 5'h1f) : 5'h0;
  logic [4:0] select_1030;
  assign select_1030 = (not_1020 & (sum_1027_s3_q[6:5] == 2'h0)) ? sum_1027_s3_q[4:0] : 5'h1f;
  logic [4:0] select_1032;
  assign select_1032 = leaving_values_24_features_mask_q ? (leaving_values_42_features_mask_q ? select_1030 : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_19;
  assign above_19 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[151:144] : 8'h0);
  logic [7:0] above_20;
  assign above_20 = equal_637 ? 8'h0 : (or_634_s3_q ? column_memory_rdata_s3_q[159:152] : 8'h0);
  // hls/stages/plane_sums.hpp:81
  logic not_1078;
  assign not_1078 = ~(select_636 == 3'h7);
  logic [2:0] select_1080;
  assign select_1080 = centre_marks_values_0_last_q ? (select_636 + {2'h0, not_1078}) : select_636;
  // hls/stages/plane_sums.hpp:99
  logic and_1166;
  assign and_1166 = (column_memory_rdata_s3_q[190] & or_634_s3_q) & (3'h2 < select_636);
  // hls/stages/plane_sums.hpp:110
  logic and_1170;
  assign and_1170 = (centres_values_3_gradient_q & and_1166) & (~(select_633_s3_q[10:2] == 9'h0));

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
    end else if (s3_en) begin
      delayed_rows_q <= select_1080;
      centres_values_0_seen_grey_q <= or_634_s3_q ? column_memory_rdata_s3_q[186:181] : 6'h0;
      centres_values_0_seen_exists_q <= column_memory_rdata_s3_q[187] & or_634_s3_q;
      centres_values_0_gradient_q <= and_1166;
      centres_values_1_seen_grey_q <= centres_values_0_seen_grey_q;
      centres_values_1_seen_exists_q <= centres_values_0_seen_exists_q;
      centres_values_1_gradient_q <= centres_values_0_gradient_q;
      centres_values_2_seen_grey_q <= centres_values_1_seen_grey_q;
      centres_values_2_seen_exists_q <= centres_values_1_seen_exists_q;
      centres_values_2_gradient_q <= centres_values_1_gradient_q;
      centres_values_3_seen_grey_q <= centres_values_2_seen_grey_q;
      centres_values_3_seen_exists_q <= centres_values_2_seen_exists_q;
      centres_values_3_gradient_q <= centres_values_2_gradient_q;
      rows_seen_values_0_q <= select_636[2];
      rows_seen_values_1_q <= rows_seen_values_0_q;
      rows_seen_values_2_q <= rows_seen_values_1_q;
      rows_seen_values_3_q <= rows_seen_values_2_q;
    end
  end

  logic entering_values_23_features_mask_s4_q;
  logic leaving_values_23_features_mask_s4_q;
  logic [5:0] seen_values_24_grey_s4_q;
  logic seen_values_24_exists_s4_q;
  logic [5:0] centres_values_3_seen_grey_s4_q;
  logic centre_marks_values_3_first_s4_q;
  logic centre_marks_values_3_last_s4_q;
  logic or_632_s4_q;
  logic [10:0] select_633_s4_q;
  logic or_634_s4_q;
  logic [17:0] column_memory_rdata_s4_q;
  logic [7:0] above_s4_q;
  logic [4:0] select_651_s4_q;
  logic [4:0] select_661_s4_q;
  logic [7:0] above_2_s4_q;
  logic [4:0] select_676_s4_q;
  logic [4:0] select_684_s4_q;
  logic [7:0] above_3_s4_q;
  logic [4:0] select_698_s4_q;
  logic [4:0] select_706_s4_q;
  logic [7:0] above_4_s4_q;
  logic [4:0] select_720_s4_q;
  logic [4:0] select_728_s4_q;
  logic [7:0] above_5_s4_q;
  logic [4:0] select_742_s4_q;
  logic [4:0] select_750_s4_q;
  logic [7:0] above_6_s4_q;
  logic [4:0] select_764_s4_q;
  logic [4:0] select_772_s4_q;
  logic [7:0] above_7_s4_q;
  logic [4:0] select_786_s4_q;
  logic [4:0] select_794_s4_q;
  logic [7:0] above_8_s4_q;
  logic [4:0] select_808_s4_q;
  logic [4:0] select_816_s4_q;
  logic [7:0] above_9_s4_q;
  logic [4:0] select_830_s4_q;
  logic [4:0] select_838_s4_q;
  logic [7:0] above_10_s4_q;
  logic [4:0] select_849_s4_q;
  logic [4:0] select_856_s4_q;
  logic [7:0] above_11_s4_q;
  logic [4:0] select_870_s4_q;
  logic [4:0] select_878_s4_q;
  logic [7:0] above_12_s4_q;
  logic [4:0] select_892_s4_q;
  logic [4:0] select_900_s4_q;
  logic [7:0] above_13_s4_q;
  logic [4:0] select_914_s4_q;
  logic [4:0] select_922_s4_q;
  logic [7:0] above_14_s4_q;
  logic [4:0] select_936_s4_q;
  logic [4:0] select_944_s4_q;
  logic [7:0] above_15_s4_q;
  logic [4:0] select_958_s4_q;
  logic [4:0] select_966_s4_q;
  logic [7:0] above_16_s4_q;
  logic [4:0] select_980_s4_q;
  logic [4:0] select_988_s4_q;
  logic [7:0] above_17_s4_q;
  logic [4:0] select_1002_s4_q;
  logic [4:0] select_1010_s4_q;
  logic [7:0] above_18_s4_q;
  logic [4:0] select_1024_s4_q;
  logic [4:0] select_1032_s4_q;
  logic [7:0] above_19_s4_q;
  logic [5:0] difference_1055_s4_q;
  logic [7:0] above_20_s4_q;
  logic [5:0] difference_1065_s4_q;
  logic and_1067_s4_q;
  logic and_1068_s4_q;
  logic and_1069_s4_q;
  logic and_1070_s4_q;
  logic and_1071_s4_q;
  logic and_1170_s4_q;
  logic and_1171_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      entering_values_23_features_mask_s4_q <= entering_values_24_features_mask_q;
      leaving_values_23_features_mask_s4_q <= leaving_values_24_features_mask_q;
      seen_values_24_grey_s4_q <= seen_values_24_grey_s3_q;
      seen_values_24_exists_s4_q <= seen_values_24_exists_s3_q;
      centres_values_3_seen_grey_s4_q <= centres_values_3_seen_grey_q;
      centre_marks_values_3_first_s4_q <= centre_marks_values_3_first_s3_q;
      centre_marks_values_3_last_s4_q <= centre_marks_values_3_last_s3_q;
      or_632_s4_q <= or_632_s3_q;
      select_633_s4_q <= select_633_s3_q;
      or_634_s4_q <= or_634_s3_q;
      column_memory_rdata_s4_q <= {column_memory_rdata_s3_q[179:174], column_memory_rdata_s3_q[172:167], column_memory_rdata_s3_q[165:160]};
      above_s4_q <= above;
      select_651_s4_q <= select_651;
      select_661_s4_q <= and_660 ? sum_654[4:0] : 5'h1f;
      above_2_s4_q <= above_2;
      select_676_s4_q <= select_676;
      select_684_s4_q <= select_684;
      above_3_s4_q <= above_3;
      select_698_s4_q <= select_698;
      select_706_s4_q <= select_706;
      above_4_s4_q <= above_4;
      select_720_s4_q <= select_720;
      select_728_s4_q <= select_728;
      above_5_s4_q <= above_5;
      select_742_s4_q <= select_742;
      select_750_s4_q <= select_750;
      above_6_s4_q <= above_6;
      select_764_s4_q <= select_764;
      select_772_s4_q <= select_772;
      above_7_s4_q <= above_7;
      select_786_s4_q <= select_786;
      select_794_s4_q <= select_794;
      above_8_s4_q <= above_8;
      select_808_s4_q <= select_808;
      select_816_s4_q <= select_816;
      above_9_s4_q <= above_9;
      select_830_s4_q <= select_830;
      select_838_s4_q <= select_838;
      above_10_s4_q <= above_10;
      select_849_s4_q <= entering_values_24_features_mask_q ? select_848 : 5'h0;
      select_856_s4_q <= leaving_values_24_features_mask_q ? select_855 : 5'h0;
      above_11_s4_q <= above_11;
      select_870_s4_q <= select_870;
      select_878_s4_q <= select_878;
      above_12_s4_q <= above_12;
      select_892_s4_q <= select_892;
      select_900_s4_q <= select_900;
      above_13_s4_q <= above_13;
      select_914_s4_q <= select_914;
      select_922_s4_q <= select_922;
      above_14_s4_q <= above_14;
      select_936_s4_q <= select_936;
      select_944_s4_q <= select_944;
      above_15_s4_q <= above_15;
      select_958_s4_q <= select_958;
      select_966_s4_q <= select_966;
      above_16_s4_q <= above_16;
      select_980_s4_q <= select_980;
      select_988_s4_q <= select_988;
      above_17_s4_q <= above_17;
      select_1002_s4_q <= select_1002;
      select_1010_s4_q <= select_1010;
      above_18_s4_q <= above_18;
      select_1024_s4_q <= select_1024;
      select_1032_s4_q <= select_1032;
      above_19_s4_q <= above_19;
      difference_1055_s4_q <= {1'b0, select_1046_s3_q} - {1'b0, select_1054_s3_q};
      above_20_s4_q <= above_20;
      difference_1065_s4_q <= {1'b0, select_1061_s3_q} - {1'b0, select_1064_s3_q};
      and_1067_s4_q <= column_memory_rdata_s3_q[166] & or_634_s3_q;
      and_1068_s4_q <= column_memory_rdata_s3_q[173] & or_634_s3_q;
      and_1069_s4_q <= column_memory_rdata_s3_q[180] & or_634_s3_q;
      and_1070_s4_q <= column_memory_rdata_s3_q[188] & or_634_s3_q;
      and_1071_s4_q <= column_memory_rdata_s3_q[189] & or_634_s3_q;
      and_1170_s4_q <= and_1170;
      and_1171_s4_q <= centres_values_3_seen_exists_q & rows_seen_values_3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
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
  logic [10:0] rows_14_columns_values_0_q;
  logic [10:0] rows_14_columns_values_1_q;
  logic [10:0] rows_14_columns_values_2_q;
  logic [10:0] rows_14_columns_values_3_q;
  logic [10:0] rows_14_columns_values_4_q;
  logic [10:0] rows_14_columns_values_5_q;
  logic [10:0] rows_14_columns_values_6_q;
  logic [10:0] rows_14_columns_values_7_q;
  logic [10:0] rows_14_columns_values_8_q;
  logic [10:0] rows_15_columns_values_0_q;
  logic [10:0] rows_15_columns_values_1_q;
  logic [10:0] rows_15_columns_values_2_q;
  logic [10:0] rows_15_columns_values_3_q;
  logic [10:0] rows_15_columns_values_4_q;
  logic [10:0] rows_15_columns_values_5_q;
  logic [10:0] rows_15_columns_values_6_q;
  logic [10:0] rows_15_columns_values_7_q;
  logic [10:0] rows_15_columns_values_8_q;
  logic [10:0] rows_16_columns_values_0_q;
  logic [10:0] rows_16_columns_values_1_q;
  logic [10:0] rows_16_columns_values_2_q;
  logic [10:0] rows_16_columns_values_3_q;
  logic [10:0] rows_16_columns_values_4_q;
  logic [10:0] rows_16_columns_values_5_q;
  logic [10:0] rows_16_columns_values_6_q;
  logic [10:0] rows_16_columns_values_7_q;
  logic [10:0] rows_16_columns_values_8_q;
  logic [10:0] rows_17_columns_values_0_q;
  logic [10:0] rows_17_columns_values_1_q;
  logic [10:0] rows_17_columns_values_2_q;
  logic [10:0] rows_17_columns_values_3_q;
  logic [10:0] rows_17_columns_values_4_q;
  logic [10:0] rows_17_columns_values_5_q;
  logic [10:0] rows_17_columns_values_6_q;
  logic [10:0] rows_17_columns_values_7_q;
  logic [10:0] rows_17_columns_values_8_q;
  logic [10:0] rows_18_columns_values_0_q;
  logic [10:0] rows_18_columns_values_1_q;
  logic [10:0] rows_18_columns_values_2_q;
  logic [10:0] rows_18_columns_values_3_q;
  logic [10:0] rows_18_columns_values_4_q;
  logic [10:0] rows_18_columns_values_5_q;
  logic [10:0] rows_18_columns_values_6_q;
  logic [10:0] rows_18_columns_values_7_q;
  logic [10:0] rows_18_columns_values_8_q;
  logic [10:0] rows_19_columns_values_0_q;
  logic [10:0] rows_19_columns_values_1_q;
  logic [10:0] rows_19_columns_values_2_q;
  logic [10:0] rows_19_columns_values_3_q;
  logic [10:0] rows_19_columns_values_4_q;
  logic [10:0] rows_19_columns_values_5_q;
  logic [10:0] rows_19_columns_values_6_q;
  logic [10:0] rows_19_columns_values_7_q;
  logic [10:0] rows_19_columns_values_8_q;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_662;
  assign select_662 = leaving_values_23_features_mask_s4_q ? select_661_s4_q : 5'h0;
  logic [5:0] difference_663;
  assign difference_663 = {1'b0, select_651_s4_q} - {1'b0, select_662};
  logic [7:0] sum_664;
  assign sum_664 = above_s4_q + {{2{difference_663[5]}}, difference_663};
  logic [5:0] difference_685;
  assign difference_685 = {1'b0, select_676_s4_q} - {1'b0, select_684_s4_q};
  logic [7:0] sum_686;
  assign sum_686 = above_2_s4_q + {{2{difference_685[5]}}, difference_685};
  logic [5:0] difference_707;
  assign difference_707 = {1'b0, select_698_s4_q} - {1'b0, select_706_s4_q};
  logic [7:0] sum_708;
  assign sum_708 = above_3_s4_q + {{2{difference_707[5]}}, difference_707};
  logic [5:0] difference_729;
  assign difference_729 = {1'b0, select_720_s4_q} - {1'b0, select_728_s4_q};
  logic [7:0] sum_730;
  assign sum_730 = above_4_s4_q + {{2{difference_729[5]}}, difference_729};
  logic [5:0] difference_751;
  assign difference_751 = {1'b0, select_742_s4_q} - {1'b0, select_750_s4_q};
  logic [7:0] sum_752;
  assign sum_752 = above_5_s4_q + {{2{difference_751[5]}}, difference_751};
  logic [5:0] difference_773;
  assign difference_773 = {1'b0, select_764_s4_q} - {1'b0, select_772_s4_q};
  logic [7:0] sum_774;
  assign sum_774 = above_6_s4_q + {{2{difference_773[5]}}, difference_773};
  logic [5:0] difference_795;
  assign difference_795 = {1'b0, select_786_s4_q} - {1'b0, select_794_s4_q};
  logic [7:0] sum_796;
  assign sum_796 = above_7_s4_q + {{2{difference_795[5]}}, difference_795};
  logic [5:0] difference_817;
  assign difference_817 = {1'b0, select_808_s4_q} - {1'b0, select_816_s4_q};
  logic [7:0] sum_818;
  assign sum_818 = above_8_s4_q + {{2{difference_817[5]}}, difference_817};
  logic [5:0] difference_839;
  assign difference_839 = {1'b0, select_830_s4_q} - {1'b0, select_838_s4_q};
  logic [7:0] sum_840;
  assign sum_840 = above_9_s4_q + {{2{difference_839[5]}}, difference_839};
  logic [5:0] difference_857;
  assign difference_857 = {1'b0, select_849_s4_q} - {1'b0, select_856_s4_q};
  logic [7:0] sum_858;
  assign sum_858 = above_10_s4_q + {{2{difference_857[5]}}, difference_857};
  logic [5:0] difference_879;
  assign difference_879 = {1'b0, select_870_s4_q} - {1'b0, select_878_s4_q};
  logic [7:0] sum_880;
  assign sum_880 = above_11_s4_q + {{2{difference_879[5]}}, difference_879};
  logic [5:0] difference_901;
  assign difference_901 = {1'b0, select_892_s4_q} - {1'b0, select_900_s4_q};
  logic [7:0] sum_902;
  assign sum_902 = above_12_s4_q + {{2{difference_901[5]}}, difference_901};
  logic [5:0] difference_923;
  assign difference_923 = {1'b0, select_914_s4_q} - {1'b0, select_922_s4_q};
  logic [7:0] sum_924;
  assign sum_924 = above_13_s4_q + {{2{difference_923[5]}}, difference_923};
  logic [5:0] difference_945;
  assign difference_945 = {1'b0, select_936_s4_q} - {1'b0, select_944_s4_q};
  logic [7:0] sum_946;
  assign sum_946 = above_14_s4_q + {{2{difference_945[5]}}, difference_945};
  logic [5:0] difference_967;
  assign difference_967 = {1'b0, select_958_s4_q} - {1'b0, select_966_s4_q};
  logic [7:0] sum_968;
  assign sum_968 = above_15_s4_q + {{2{difference_967[5]}}, difference_967};
  logic [5:0] difference_989;
  assign difference_989 = {1'b0, select_980_s4_q} - {1'b0, select_988_s4_q};
  logic [7:0] sum_990;
  assign sum_990 = above_16_s4_q + {{2{difference_989[5]}}, difference_989};
  logic [5:0] difference_1011;
  assign difference_1011 = {1'b0, select_1002_s4_q} - {1'b0, select_1010_s4_q};
  logic [7:0] sum_1012;
  assign sum_1012 = above_17_s4_q + {{2{difference_1011[5]}}, difference_1011};
  logic [5:0] difference_1033;
  assign difference_1033 = {1'b0, select_1024_s4_q} - {1'b0, select_1032_s4_q};
  logic [7:0] sum_1034;
  assign sum_1034 = above_18_s4_q + {{2{difference_1033[5]}}, difference_1033};
  logic [7:0] sum_1056;
  assign sum_1056 = above_19_s4_q + {{2{difference_1055_s4_q[5]}}, difference_1055_s4_q};
  logic [7:0] sum_1066;
  assign sum_1066 = above_20_s4_q + {{2{difference_1065_s4_q[5]}}, difference_1065_s4_q};
  // hls/stages/plane_sums.hpp:150
  logic less_1081;
  assign less_1081 = 11'h8 < select_633_s4_q;

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
    rows_14_columns_values_0_q = 11'h0;
    rows_14_columns_values_1_q = 11'h0;
    rows_14_columns_values_2_q = 11'h0;
    rows_14_columns_values_3_q = 11'h0;
    rows_14_columns_values_4_q = 11'h0;
    rows_14_columns_values_5_q = 11'h0;
    rows_14_columns_values_6_q = 11'h0;
    rows_14_columns_values_7_q = 11'h0;
    rows_14_columns_values_8_q = 11'h0;
    rows_15_columns_values_0_q = 11'h0;
    rows_15_columns_values_1_q = 11'h0;
    rows_15_columns_values_2_q = 11'h0;
    rows_15_columns_values_3_q = 11'h0;
    rows_15_columns_values_4_q = 11'h0;
    rows_15_columns_values_5_q = 11'h0;
    rows_15_columns_values_6_q = 11'h0;
    rows_15_columns_values_7_q = 11'h0;
    rows_15_columns_values_8_q = 11'h0;
    rows_16_columns_values_0_q = 11'h0;
    rows_16_columns_values_1_q = 11'h0;
    rows_16_columns_values_2_q = 11'h0;
    rows_16_columns_values_3_q = 11'h0;
    rows_16_columns_values_4_q = 11'h0;
    rows_16_columns_values_5_q = 11'h0;
    rows_16_columns_values_6_q = 11'h0;
    rows_16_columns_values_7_q = 11'h0;
    rows_16_columns_values_8_q = 11'h0;
    rows_17_columns_values_0_q = 11'h0;
    rows_17_columns_values_1_q = 11'h0;
    rows_17_columns_values_2_q = 11'h0;
    rows_17_columns_values_3_q = 11'h0;
    rows_17_columns_values_4_q = 11'h0;
    rows_17_columns_values_5_q = 11'h0;
    rows_17_columns_values_6_q = 11'h0;
    rows_17_columns_values_7_q = 11'h0;
    rows_17_columns_values_8_q = 11'h0;
    rows_18_columns_values_0_q = 11'h0;
    rows_18_columns_values_1_q = 11'h0;
    rows_18_columns_values_2_q = 11'h0;
    rows_18_columns_values_3_q = 11'h0;
    rows_18_columns_values_4_q = 11'h0;
    rows_18_columns_values_5_q = 11'h0;
    rows_18_columns_values_6_q = 11'h0;
    rows_18_columns_values_7_q = 11'h0;
    rows_18_columns_values_8_q = 11'h0;
    rows_19_columns_values_0_q = 11'h0;
    rows_19_columns_values_1_q = 11'h0;
    rows_19_columns_values_2_q = 11'h0;
    rows_19_columns_values_3_q = 11'h0;
    rows_19_columns_values_4_q = 11'h0;
    rows_19_columns_values_5_q = 11'h0;
    rows_19_columns_values_6_q = 11'h0;
    rows_19_columns_values_7_q = 11'h0;
    rows_19_columns_values_8_q = 11'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s4_en) begin
      rows_0_columns_values_0_q <= {3'h0, sum_664};
      rows_0_columns_values_1_q <= rows_0_columns_values_0_q;
      rows_0_columns_values_2_q <= rows_0_columns_values_1_q;
      rows_0_columns_values_3_q <= rows_0_columns_values_2_q;
      rows_0_columns_values_4_q <= rows_0_columns_values_3_q;
      rows_0_columns_values_5_q <= rows_0_columns_values_4_q;
      rows_0_columns_values_6_q <= rows_0_columns_values_5_q;
      rows_0_columns_values_7_q <= rows_0_columns_values_6_q;
      rows_0_columns_values_8_q <= rows_0_columns_values_7_q;
      rows_1_columns_values_0_q <= {3'h0, sum_686};
      rows_1_columns_values_1_q <= rows_1_columns_values_0_q;
      rows_1_columns_values_2_q <= rows_1_columns_values_1_q;
      rows_1_columns_values_3_q <= rows_1_columns_values_2_q;
      rows_1_columns_values_4_q <= rows_1_columns_values_3_q;
      rows_1_columns_values_5_q <= rows_1_columns_values_4_q;
      rows_1_columns_values_6_q <= rows_1_columns_values_5_q;
      rows_1_columns_values_7_q <= rows_1_columns_values_6_q;
      rows_1_columns_values_8_q <= rows_1_columns_values_7_q;
      rows_2_columns_values_0_q <= {3'h0, sum_708};
      rows_2_columns_values_1_q <= rows_2_columns_values_0_q;
      rows_2_columns_values_2_q <= rows_2_columns_values_1_q;
      rows_2_columns_values_3_q <= rows_2_columns_values_2_q;
      rows_2_columns_values_4_q <= rows_2_columns_values_3_q;
      rows_2_columns_values_5_q <= rows_2_columns_values_4_q;
      rows_2_columns_values_6_q <= rows_2_columns_values_5_q;
      rows_2_columns_values_7_q <= rows_2_columns_values_6_q;
      rows_2_columns_values_8_q <= rows_2_columns_values_7_q;
      rows_3_columns_values_0_q <= {3'h0, sum_730};
      rows_3_columns_values_1_q <= rows_3_columns_values_0_q;
      rows_3_columns_values_2_q <= rows_3_columns_values_1_q;
      rows_3_columns_values_3_q <= rows_3_columns_values_2_q;
      rows_3_columns_values_4_q <= rows_3_columns_values_3_q;
      rows_3_columns_values_5_q <= rows_3_columns_values_4_q;
      rows_3_columns_values_6_q <= rows_3_columns_values_5_q;
      rows_3_columns_values_7_q <= rows_3_columns_values_6_q;
      rows_3_columns_values_8_q <= rows_3_columns_values_7_q;
      rows_4_columns_values_0_q <= {3'h0, sum_752};
      rows_4_columns_values_1_q <= rows_4_columns_values_0_q;
      rows_4_columns_values_2_q <= rows_4_columns_values_1_q;
      rows_4_columns_values_3_q <= rows_4_columns_values_2_q;
      rows_4_columns_values_4_q <= rows_4_columns_values_3_q;
      rows_4_columns_values_5_q <= rows_4_columns_values_4_q;
      rows_4_columns_values_6_q <= rows_4_columns_values_5_q;
      rows_4_columns_values_7_q <= rows_4_columns_values_6_q;
      rows_4_columns_values_8_q <= rows_4_columns_values_7_q;
      rows_5_columns_values_0_q <= {3'h0, sum_774};
      rows_5_columns_values_1_q <= rows_5_columns_values_0_q;
      rows_5_columns_values_2_q <= rows_5_columns_values_1_q;
      rows_5_columns_values_3_q <= rows_5_columns_values_2_q;
      rows_5_columns_values_4_q <= rows_5_columns_values_3_q;
      rows_5_columns_values_5_q <= rows_5_columns_values_4_q;
      rows_5_columns_values_6_q <= rows_5_columns_values_5_q;
      rows_5_columns_values_7_q <= rows_5_columns_values_6_q;
      rows_5_columns_values_8_q <= rows_5_columns_values_7_q;
      rows_6_columns_values_0_q <= {3'h0, sum_796};
      rows_6_columns_values_1_q <= rows_6_columns_values_0_q;
      rows_6_columns_values_2_q <= rows_6_columns_values_1_q;
      rows_6_columns_values_3_q <= rows_6_columns_values_2_q;
      rows_6_columns_values_4_q <= rows_6_columns_values_3_q;
      rows_6_columns_values_5_q <= rows_6_columns_values_4_q;
      rows_6_columns_values_6_q <= rows_6_columns_values_5_q;
      rows_6_columns_values_7_q <= rows_6_columns_values_6_q;
      rows_6_columns_values_8_q <= rows_6_columns_values_7_q;
      rows_7_columns_values_0_q <= {3'h0, sum_818};
      rows_7_columns_values_1_q <= rows_7_columns_values_0_q;
      rows_7_columns_values_2_q <= rows_7_columns_values_1_q;
      rows_7_columns_values_3_q <= rows_7_columns_values_2_q;
      rows_7_columns_values_4_q <= rows_7_columns_values_3_q;
      rows_7_columns_values_5_q <= rows_7_columns_values_4_q;
      rows_7_columns_values_6_q <= rows_7_columns_values_5_q;
      rows_7_columns_values_7_q <= rows_7_columns_values_6_q;
      rows_7_columns_values_8_q <= rows_7_columns_values_7_q;
      rows_8_columns_values_0_q <= {3'h0, sum_840};
      rows_8_columns_values_1_q <= rows_8_columns_values_0_q;
      rows_8_columns_values_2_q <= rows_8_columns_values_1_q;
      rows_8_columns_values_3_q <= rows_8_columns_values_2_q;
      rows_8_columns_values_4_q <= rows_8_columns_values_3_q;
      rows_8_columns_values_5_q <= rows_8_columns_values_4_q;
      rows_8_columns_values_6_q <= rows_8_columns_values_5_q;
      rows_8_columns_values_7_q <= rows_8_columns_values_6_q;
      rows_8_columns_values_8_q <= rows_8_columns_values_7_q;
      rows_9_columns_values_0_q <= {3'h0, sum_858};
      rows_9_columns_values_1_q <= rows_9_columns_values_0_q;
      rows_9_columns_values_2_q <= rows_9_columns_values_1_q;
      rows_9_columns_values_3_q <= rows_9_columns_values_2_q;
      rows_9_columns_values_4_q <= rows_9_columns_values_3_q;
      rows_9_columns_values_5_q <= rows_9_columns_values_4_q;
      rows_9_columns_values_6_q <= rows_9_columns_values_5_q;
      rows_9_columns_values_7_q <= rows_9_columns_values_6_q;
      rows_9_columns_values_8_q <= rows_9_columns_values_7_q;
      rows_10_columns_values_0_q <= {3'h0, sum_880};
      rows_10_columns_values_1_q <= rows_10_columns_values_0_q;
      rows_10_columns_values_2_q <= rows_10_columns_values_1_q;
      rows_10_columns_values_3_q <= rows_10_columns_values_2_q;
      rows_10_columns_values_4_q <= rows_10_columns_values_3_q;
      rows_10_columns_values_5_q <= rows_10_columns_values_4_q;
      rows_10_columns_values_6_q <= rows_10_columns_values_5_q;
      rows_10_columns_values_7_q <= rows_10_columns_values_6_q;
      rows_10_columns_values_8_q <= rows_10_columns_values_7_q;
      rows_11_columns_values_0_q <= {3'h0, sum_902};
      rows_11_columns_values_1_q <= rows_11_columns_values_0_q;
      rows_11_columns_values_2_q <= rows_11_columns_values_1_q;
      rows_11_columns_values_3_q <= rows_11_columns_values_2_q;
      rows_11_columns_values_4_q <= rows_11_columns_values_3_q;
      rows_11_columns_values_5_q <= rows_11_columns_values_4_q;
      rows_11_columns_values_6_q <= rows_11_columns_values_5_q;
      rows_11_columns_values_7_q <= rows_11_columns_values_6_q;
      rows_11_columns_values_8_q <= rows_11_columns_values_7_q;
      rows_12_columns_values_0_q <= {3'h0, sum_924};
      rows_12_columns_values_1_q <= rows_12_columns_values_0_q;
      rows_12_columns_values_2_q <= rows_12_columns_values_1_q;
      rows_12_columns_values_3_q <= rows_12_columns_values_2_q;
      rows_12_columns_values_4_q <= rows_12_columns_values_3_q;
      rows_12_columns_values_5_q <= rows_12_columns_values_4_q;
      rows_12_columns_values_6_q <= rows_12_columns_values_5_q;
      rows_12_columns_values_7_q <= rows_12_columns_values_6_q;
      rows_12_columns_values_8_q <= rows_12_columns_values_7_q;
      rows_13_columns_values_0_q <= {3'h0, sum_946};
      rows_13_columns_values_1_q <= rows_13_columns_values_0_q;
      rows_13_columns_values_2_q <= rows_13_columns_values_1_q;
      rows_13_columns_values_3_q <= rows_13_columns_values_2_q;
      rows_13_columns_values_4_q <= rows_13_columns_values_3_q;
      rows_13_columns_values_5_q <= rows_13_columns_values_4_q;
      rows_13_columns_values_6_q <= rows_13_columns_values_5_q;
      rows_13_columns_values_7_q <= rows_13_columns_values_6_q;
      rows_13_columns_values_8_q <= rows_13_columns_values_7_q;
      rows_14_columns_values_0_q <= {3'h0, sum_968};
      rows_14_columns_values_1_q <= rows_14_columns_values_0_q;
      rows_14_columns_values_2_q <= rows_14_columns_values_1_q;
      rows_14_columns_values_3_q <= rows_14_columns_values_2_q;
      rows_14_columns_values_4_q <= rows_14_columns_values_3_q;
      rows_14_columns_values_5_q <= rows_14_columns_values_4_q;
      rows_14_columns_values_6_q <= rows_14_columns_values_5_q;
      rows_14_columns_values_7_q <= rows_14_columns_values_6_q;
      rows_14_columns_values_8_q <= rows_14_columns_values_7_q;
      rows_15_columns_values_0_q <= {3'h0, sum_990};
      rows_15_columns_values_1_q <= rows_15_columns_values_0_q;
      rows_15_columns_values_2_q <= rows_15_columns_values_1_q;
      rows_15_columns_values_3_q <= rows_15_columns_values_2_q;
      rows_15_columns_values_4_q <= rows_15_columns_values_3_q;
      rows_15_columns_values_5_q <= rows_15_columns_values_4_q;
      rows_15_columns_values_6_q <= rows_15_columns_values_5_q;
      rows_15_columns_values_7_q <= rows_15_columns_values_6_q;
      rows_15_columns_values_8_q <= rows_15_columns_values_7_q;
      rows_16_columns_values_0_q <= {3'h0, sum_1012};
      rows_16_columns_values_1_q <= rows_16_columns_values_0_q;
      rows_16_columns_values_2_q <= rows_16_columns_values_1_q;
      rows_16_columns_values_3_q <= rows_16_columns_values_2_q;
      rows_16_columns_values_4_q <= rows_16_columns_values_3_q;
      rows_16_columns_values_5_q <= rows_16_columns_values_4_q;
      rows_16_columns_values_6_q <= rows_16_columns_values_5_q;
      rows_16_columns_values_7_q <= rows_16_columns_values_6_q;
      rows_16_columns_values_8_q <= rows_16_columns_values_7_q;
      rows_17_columns_values_0_q <= {3'h0, sum_1034};
      rows_17_columns_values_1_q <= rows_17_columns_values_0_q;
      rows_17_columns_values_2_q <= rows_17_columns_values_1_q;
      rows_17_columns_values_3_q <= rows_17_columns_values_2_q;
      rows_17_columns_values_4_q <= rows_17_columns_values_3_q;
      rows_17_columns_values_5_q <= rows_17_columns_values_4_q;
      rows_17_columns_values_6_q <= rows_17_columns_values_5_q;
      rows_17_columns_values_7_q <= rows_17_columns_values_6_q;
      rows_17_columns_values_8_q <= rows_17_columns_values_7_q;
      rows_18_columns_values_0_q <= {3'h0, sum_1056};
      rows_18_columns_values_1_q <= rows_18_columns_values_0_q;
      rows_18_columns_values_2_q <= rows_18_columns_values_1_q;
      rows_18_columns_values_3_q <= rows_18_columns_values_2_q;
      rows_18_columns_values_4_q <= rows_18_columns_values_3_q;
      rows_18_columns_values_5_q <= rows_18_columns_values_4_q;
      rows_18_columns_values_6_q <= rows_18_columns_values_5_q;
      rows_18_columns_values_7_q <= rows_18_columns_values_6_q;
      rows_18_columns_values_8_q <= rows_18_columns_values_7_q;
      rows_19_columns_values_0_q <= {3'h0, sum_1066};
      rows_19_columns_values_1_q <= rows_19_columns_values_0_q;
      rows_19_columns_values_2_q <= rows_19_columns_values_1_q;
      rows_19_columns_values_3_q <= rows_19_columns_values_2_q;
      rows_19_columns_values_4_q <= rows_19_columns_values_3_q;
      rows_19_columns_values_5_q <= rows_19_columns_values_4_q;
      rows_19_columns_values_6_q <= rows_19_columns_values_5_q;
      rows_19_columns_values_7_q <= rows_19_columns_values_6_q;
      rows_19_columns_values_8_q <= rows_19_columns_values_7_q;
    end
  end

  logic entering_values_23_features_mask_s5_q;
  logic [5:0] seen_values_24_grey_s5_q;
  logic seen_values_24_exists_s5_q;
  logic [5:0] centres_values_3_seen_grey_s5_q;
  logic centre_marks_values_3_first_s5_q;
  logic centre_marks_values_3_last_s5_q;
  logic or_632_s5_q;
  logic [10:0] select_633_s5_q;
  logic or_634_s5_q;
  logic [17:0] column_memory_rdata_s5_q;
  logic and_1067_s5_q;
  logic and_1068_s5_q;
  logic and_1069_s5_q;
  logic and_1070_s5_q;
  logic and_1071_s5_q;
  logic [10:0] select_1082_s5_q;
  logic [10:0] select_1086_s5_q;
  logic [10:0] select_1090_s5_q;
  logic [10:0] select_1094_s5_q;
  logic [10:0] select_1098_s5_q;
  logic [10:0] select_1102_s5_q;
  logic [10:0] select_1106_s5_q;
  logic [10:0] select_1110_s5_q;
  logic [10:0] select_1114_s5_q;
  logic [10:0] select_1118_s5_q;
  logic [10:0] select_1122_s5_q;
  logic [10:0] select_1126_s5_q;
  logic [10:0] select_1130_s5_q;
  logic [10:0] select_1134_s5_q;
  logic [10:0] select_1138_s5_q;
  logic [10:0] select_1142_s5_q;
  logic [10:0] select_1146_s5_q;
  logic [10:0] select_1150_s5_q;
  logic [10:0] select_1154_s5_q;
  logic [10:0] select_1158_s5_q;
  logic and_1170_s5_q;
  logic and_1171_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      entering_values_23_features_mask_s5_q <= entering_values_23_features_mask_s4_q;
      seen_values_24_grey_s5_q <= seen_values_24_grey_s4_q;
      seen_values_24_exists_s5_q <= seen_values_24_exists_s4_q;
      centres_values_3_seen_grey_s5_q <= centres_values_3_seen_grey_s4_q;
      centre_marks_values_3_first_s5_q <= centre_marks_values_3_first_s4_q;
      centre_marks_values_3_last_s5_q <= centre_marks_values_3_last_s4_q;
      or_632_s5_q <= or_632_s4_q;
      select_633_s5_q <= select_633_s4_q;
      or_634_s5_q <= or_634_s4_q;
      column_memory_rdata_s5_q <= column_memory_rdata_s4_q;
      and_1067_s5_q <= and_1067_s4_q;
      and_1068_s5_q <= and_1068_s4_q;
      and_1069_s5_q <= and_1069_s4_q;
      and_1070_s5_q <= and_1070_s4_q;
      and_1071_s5_q <= and_1071_s4_q;
      select_1082_s5_q <= less_1081 ? rows_0_columns_values_8_q : 11'h0;
      select_1086_s5_q <= less_1081 ? rows_1_columns_values_8_q : 11'h0;
      select_1090_s5_q <= less_1081 ? rows_2_columns_values_8_q : 11'h0;
      select_1094_s5_q <= less_1081 ? rows_3_columns_values_8_q : 11'h0;
      select_1098_s5_q <= less_1081 ? rows_4_columns_values_8_q : 11'h0;
      select_1102_s5_q <= less_1081 ? rows_5_columns_values_8_q : 11'h0;
      select_1106_s5_q <= less_1081 ? rows_6_columns_values_8_q : 11'h0;
      select_1110_s5_q <= less_1081 ? rows_7_columns_values_8_q : 11'h0;
      select_1114_s5_q <= less_1081 ? rows_8_columns_values_8_q : 11'h0;
      select_1118_s5_q <= less_1081 ? rows_9_columns_values_8_q : 11'h0;
      select_1122_s5_q <= less_1081 ? rows_10_columns_values_8_q : 11'h0;
      select_1126_s5_q <= less_1081 ? rows_11_columns_values_8_q : 11'h0;
      select_1130_s5_q <= less_1081 ? rows_12_columns_values_8_q : 11'h0;
      select_1134_s5_q <= less_1081 ? rows_13_columns_values_8_q : 11'h0;
      select_1138_s5_q <= less_1081 ? rows_14_columns_values_8_q : 11'h0;
      select_1142_s5_q <= less_1081 ? rows_15_columns_values_8_q : 11'h0;
      select_1146_s5_q <= less_1081 ? rows_16_columns_values_8_q : 11'h0;
      select_1150_s5_q <= less_1081 ? rows_17_columns_values_8_q : 11'h0;
      select_1154_s5_q <= less_1081 ? rows_18_columns_values_8_q : 11'h0;
      select_1158_s5_q <= less_1081 ? rows_19_columns_values_8_q : 11'h0;
      and_1170_s5_q <= and_1170_s4_q;
      and_1171_s5_q <= and_1171_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
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
  logic [10:0] rows_14_sum_sums_values_0_q;
  logic [10:0] rows_15_sum_sums_values_0_q;
  logic [10:0] rows_16_sum_sums_values_0_q;
  logic [10:0] rows_17_sum_sums_values_0_q;
  logic [10:0] rows_18_sum_sums_values_0_q;
  logic [10:0] rows_19_sum_sums_values_0_q;
  // hls/stages/plane_sums.hpp:150
  logic [10:0] sum_1085;
  assign sum_1085 = ({3'h0, rows_0_columns_values_0_q[7:0]} - select_1082_s5_q) + (or_632_s5_q ? 11'h0 : rows_0_sum_sums_values_0_q);
  logic [10:0] sum_1089;
  assign sum_1089 = ({3'h0, rows_1_columns_values_0_q[7:0]} - select_1086_s5_q) + (or_632_s5_q ? 11'h0 : rows_1_sum_sums_values_0_q);
  logic [10:0] sum_1093;
  assign sum_1093 = ({3'h0, rows_2_columns_values_0_q[7:0]} - select_1090_s5_q) + (or_632_s5_q ? 11'h0 : rows_2_sum_sums_values_0_q);
  logic [10:0] sum_1097;
  assign sum_1097 = ({3'h0, rows_3_columns_values_0_q[7:0]} - select_1094_s5_q) + (or_632_s5_q ? 11'h0 : rows_3_sum_sums_values_0_q);
  logic [10:0] sum_1101;
  assign sum_1101 = ({3'h0, rows_4_columns_values_0_q[7:0]} - select_1098_s5_q) + (or_632_s5_q ? 11'h0 : rows_4_sum_sums_values_0_q);
  logic [10:0] sum_1105;
  assign sum_1105 = ({3'h0, rows_5_columns_values_0_q[7:0]} - select_1102_s5_q) + (or_632_s5_q ? 11'h0 : rows_5_sum_sums_values_0_q);
  logic [10:0] sum_1109;
  assign sum_1109 = ({3'h0, rows_6_columns_values_0_q[7:0]} - select_1106_s5_q) + (or_632_s5_q ? 11'h0 : rows_6_sum_sums_values_0_q);
  logic [10:0] sum_1113;
  assign sum_1113 = ({3'h0, rows_7_columns_values_0_q[7:0]} - select_1110_s5_q) + (or_632_s5_q ? 11'h0 : rows_7_sum_sums_values_0_q);
  logic [10:0] sum_1117;
  assign sum_1117 = ({3'h0, rows_8_columns_values_0_q[7:0]} - select_1114_s5_q) + (or_632_s5_q ? 11'h0 : rows_8_sum_sums_values_0_q);
  logic [10:0] sum_1121;
  assign sum_1121 = ({3'h0, rows_9_columns_values_0_q[7:0]} - select_1118_s5_q) + (or_632_s5_q ? 11'h0 : rows_9_sum_sums_values_0_q);
  logic [10:0] sum_1125;
  assign sum_1125 = ({3'h0, rows_10_columns_values_0_q[7:0]} - select_1122_s5_q) + (or_632_s5_q ? 11'h0 : rows_10_sum_sums_values_0_q);
  logic [10:0] sum_1129;
  assign sum_1129 = ({3'h0, rows_11_columns_values_0_q[7:0]} - select_1126_s5_q) + (or_632_s5_q ? 11'h0 : rows_11_sum_sums_values_0_q);
  logic [10:0] sum_1133;
  assign sum_1133 = ({3'h0, rows_12_columns_values_0_q[7:0]} - select_1130_s5_q) + (or_632_s5_q ? 11'h0 : rows_12_sum_sums_values_0_q);
  logic [10:0] sum_1137;
  assign sum_1137 = ({3'h0, rows_13_columns_values_0_q[7:0]} - select_1134_s5_q) + (or_632_s5_q ? 11'h0 : rows_13_sum_sums_values_0_q);
  logic [10:0] sum_1141;
  assign sum_1141 = ({3'h0, rows_14_columns_values_0_q[7:0]} - select_1138_s5_q) + (or_632_s5_q ? 11'h0 : rows_14_sum_sums_values_0_q);
  logic [10:0] sum_1145;
  assign sum_1145 = ({3'h0, rows_15_columns_values_0_q[7:0]} - select_1142_s5_q) + (or_632_s5_q ? 11'h0 : rows_15_sum_sums_values_0_q);
  logic [10:0] sum_1149;
  assign sum_1149 = ({3'h0, rows_16_columns_values_0_q[7:0]} - select_1146_s5_q) + (or_632_s5_q ? 11'h0 : rows_16_sum_sums_values_0_q);
  logic [10:0] sum_1153;
  assign sum_1153 = ({3'h0, rows_17_columns_values_0_q[7:0]} - select_1150_s5_q) + (or_632_s5_q ? 11'h0 : rows_17_sum_sums_values_0_q);
  logic [10:0] sum_1157;
  assign sum_1157 = ({3'h0, rows_18_columns_values_0_q[7:0]} - select_1154_s5_q) + (or_632_s5_q ? 11'h0 : rows_18_sum_sums_values_0_q);
  logic [10:0] sum_1161;
  assign sum_1161 = ({3'h0, rows_19_columns_values_0_q[7:0]} - select_1158_s5_q) + (or_632_s5_q ? 11'h0 : rows_19_sum_sums_values_0_q);

  // Memory column_memory, write
  logic [10:0] column_memory_waddr;
  assign column_memory_waddr = select_633_s5_q;
  logic column_memory_we;
  assign column_memory_we = s5_en & or_634_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (column_memory_we) column_memory_mem[column_memory_waddr] <= {and_1071_s5_q, and_1070_s5_q, entering_values_23_features_mask_s5_q, and_1069_s5_q, column_memory_rdata_s5_q[17:12], and_1068_s5_q, column_memory_rdata_s5_q[11:6], and_1067_s5_q, column_memory_rdata_s5_q[5:0], seen_values_24_exists_s5_q, seen_values_24_grey_s5_q, rows_19_columns_values_0_q[7:0], rows_18_columns_values_0_q[7:0], rows_17_columns_values_0_q[7:0], rows_16_columns_values_0_q[7:0], rows_15_columns_values_0_q[7:0], rows_14_columns_values_0_q[7:0], rows_13_columns_values_0_q[7:0], rows_12_columns_values_0_q[7:0], rows_11_columns_values_0_q[7:0], rows_10_columns_values_0_q[7:0], rows_9_columns_values_0_q[7:0], rows_8_columns_values_0_q[7:0], rows_7_columns_values_0_q[7:0], rows_6_columns_values_0_q[7:0], rows_5_columns_values_0_q[7:0], rows_4_columns_values_0_q[7:0], rows_3_columns_values_0_q[7:0], rows_2_columns_values_0_q[7:0], rows_1_columns_values_0_q[7:0], rows_0_columns_values_0_q[7:0]};
  end
`ifndef SYNTHESIS
  logic [10:0] column_memory_raddr_s2_sim;
  logic column_memory_re_s2_sim;
  logic [10:0] column_memory_raddr_s3_sim;
  logic column_memory_re_s3_sim;
  logic [10:0] column_memory_raddr_s4_sim;
  logic column_memory_re_s4_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      column_memory_re_s2_sim <= 1'b0;
      column_memory_re_s3_sim <= 1'b0;
      column_memory_re_s4_sim <= 1'b0;
    end else if (en_i) begin
      column_memory_re_s2_sim <= column_memory_re;
      column_memory_raddr_s2_sim <= column_memory_raddr;
      column_memory_re_s3_sim <= column_memory_re_s2_sim;
      column_memory_raddr_s3_sim <= column_memory_raddr_s2_sim;
      column_memory_re_s4_sim <= column_memory_re_s3_sim;
      column_memory_raddr_s4_sim <= column_memory_raddr_s3_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && column_memory_we) begin
      if (column_memory_re && column_memory_raddr == column_memory_waddr) begin
        $error("column_memory: address %0d is read less than DISTANCE steps after its write", column_memory_waddr);
      end
      if (column_memory_re_s2_sim && column_memory_raddr_s2_sim == column_memory_waddr) begin
        $error("column_memory: address %0d is read less than DISTANCE steps after its write", column_memory_waddr);
      end
      if (column_memory_re_s3_sim && column_memory_raddr_s3_sim == column_memory_waddr) begin
        $error("column_memory: address %0d is read less than DISTANCE steps after its write", column_memory_waddr);
      end
      if (column_memory_re_s4_sim && column_memory_raddr_s4_sim == column_memory_waddr) begin
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
    rows_14_sum_sums_values_0_q = 11'h0;
    rows_15_sum_sums_values_0_q = 11'h0;
    rows_16_sum_sums_values_0_q = 11'h0;
    rows_17_sum_sums_values_0_q = 11'h0;
    rows_18_sum_sums_values_0_q = 11'h0;
    rows_19_sum_sums_values_0_q = 11'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s5_en) begin
      rows_0_sum_sums_values_0_q <= sum_1085;
      rows_1_sum_sums_values_0_q <= sum_1089;
      rows_2_sum_sums_values_0_q <= sum_1093;
      rows_3_sum_sums_values_0_q <= sum_1097;
      rows_4_sum_sums_values_0_q <= sum_1101;
      rows_5_sum_sums_values_0_q <= sum_1105;
      rows_6_sum_sums_values_0_q <= sum_1109;
      rows_7_sum_sums_values_0_q <= sum_1113;
      rows_8_sum_sums_values_0_q <= sum_1117;
      rows_9_sum_sums_values_0_q <= sum_1121;
      rows_10_sum_sums_values_0_q <= sum_1125;
      rows_11_sum_sums_values_0_q <= sum_1129;
      rows_12_sum_sums_values_0_q <= sum_1133;
      rows_13_sum_sums_values_0_q <= sum_1137;
      rows_14_sum_sums_values_0_q <= sum_1141;
      rows_15_sum_sums_values_0_q <= sum_1145;
      rows_16_sum_sums_values_0_q <= sum_1149;
      rows_17_sum_sums_values_0_q <= sum_1153;
      rows_18_sum_sums_values_0_q <= sum_1157;
      rows_19_sum_sums_values_0_q <= sum_1161;
    end
  end

  logic [5:0] centres_values_3_seen_grey_s6_q;
  logic centre_marks_values_3_first_s6_q;
  logic centre_marks_values_3_last_s6_q;
  logic and_1170_s6_q;
  logic and_1171_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      centres_values_3_seen_grey_s6_q <= centres_values_3_seen_grey_s5_q;
      centre_marks_values_3_first_s6_q <= centre_marks_values_3_first_s5_q;
      centre_marks_values_3_last_s6_q <= centre_marks_values_3_last_s5_q;
      and_1170_s6_q <= and_1170_s5_q;
      and_1171_s6_q <= and_1171_s5_q;
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
  assign sum_13_o = rows_13_sum_sums_values_0_q;
  assign sum_14_o = rows_14_sum_sums_values_0_q;
  assign sum_15_o = rows_15_sum_sums_values_0_q;
  assign sum_16_o = rows_16_sum_sums_values_0_q;
  assign sum_17_o = rows_17_sum_sums_values_0_q;
  assign sum_18_o = rows_18_sum_sums_values_0_q;
  assign evidence_o = rows_19_sum_sums_values_0_q;
  assign grey_o = centres_values_3_seen_grey_s6_q;
  assign known_o = and_1170_s6_q;
  assign exists_o = and_1171_s6_q;
  assign marks_first_o = centre_marks_values_3_first_s6_q;
  assign marks_last_o = centre_marks_values_3_last_s6_q;
  assign valid_o = valid_s6_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^grey_i[1:0];

endmodule
