// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::PlaneSums<horopter::hls::profiles::vga>, hls/stages/plane_sums.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 3508 bits, pipeline 35 bits, memories 180480 bits.
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
  logic valid_s1_q, valid_s2_q;
  logic s0_en, s1_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [9:0] arriving_column_q;
  logic arriving_row_ended_q;
  logic [9:0] delayed_column_q;
  logic delayed_row_ended_q;
  logic row_parity_q;
  logic running_q;
  logic [5:0] entering_values_0_features_left_q;
  logic [5:0] entering_values_0_features_right_q;
  logic entering_values_0_features_mask_q;
  logic [5:0] entering_values_1_features_left_q;
  logic [5:0] entering_values_1_features_right_q;
  logic entering_values_1_features_mask_q;
  logic entering_values_1_row_q;
  logic [5:0] entering_values_2_features_left_q;
  logic [5:0] entering_values_2_features_right_q;
  logic entering_values_2_features_mask_q;
  logic entering_values_2_row_q;
  logic [5:0] entering_values_3_features_left_q;
  logic [5:0] entering_values_3_features_right_q;
  logic entering_values_3_features_mask_q;
  logic entering_values_3_row_q;
  logic [5:0] entering_values_4_features_left_q;
  logic [5:0] entering_values_4_features_right_q;
  logic entering_values_4_features_mask_q;
  logic entering_values_4_row_q;
  logic [5:0] entering_values_5_features_left_q;
  logic [5:0] entering_values_5_features_right_q;
  logic entering_values_5_features_mask_q;
  logic entering_values_5_row_q;
  logic [5:0] entering_values_6_features_left_q;
  logic [5:0] entering_values_6_features_right_q;
  logic entering_values_6_features_mask_q;
  logic entering_values_6_row_q;
  logic [5:0] entering_values_7_features_left_q;
  logic [5:0] entering_values_7_features_right_q;
  logic entering_values_7_features_mask_q;
  logic entering_values_7_row_q;
  logic [5:0] entering_values_8_features_left_q;
  logic [5:0] entering_values_8_features_right_q;
  logic entering_values_8_features_mask_q;
  logic entering_values_8_row_q;
  logic [5:0] entering_values_9_features_left_q;
  logic [5:0] entering_values_9_features_right_q;
  logic entering_values_9_features_mask_q;
  logic entering_values_9_row_q;
  logic [5:0] entering_values_10_features_left_q;
  logic [5:0] entering_values_10_features_right_q;
  logic entering_values_10_features_mask_q;
  logic entering_values_10_row_q;
  logic [5:0] entering_values_11_features_left_q;
  logic [5:0] entering_values_11_features_right_q;
  logic entering_values_11_features_mask_q;
  logic entering_values_11_row_q;
  logic [5:0] entering_values_12_features_left_q;
  logic [5:0] entering_values_12_features_right_q;
  logic entering_values_12_features_mask_q;
  logic entering_values_12_row_q;
  logic [5:0] entering_values_13_features_left_q;
  logic [5:0] entering_values_13_features_right_q;
  logic entering_values_13_features_mask_q;
  logic entering_values_13_row_q;
  logic [5:0] entering_values_14_features_left_q;
  logic [5:0] entering_values_14_features_right_q;
  logic entering_values_14_features_mask_q;
  logic entering_values_14_row_q;
  logic [5:0] entering_values_15_features_left_q;
  logic [5:0] entering_values_15_features_right_q;
  logic entering_values_15_features_mask_q;
  logic entering_values_15_row_q;
  logic [5:0] entering_values_16_features_left_q;
  logic [5:0] entering_values_16_features_right_q;
  logic entering_values_16_features_mask_q;
  logic entering_values_16_row_q;
  logic [5:0] entering_values_17_features_left_q;
  logic [5:0] entering_values_17_features_right_q;
  logic entering_values_17_features_mask_q;
  logic entering_values_17_row_q;
  logic [5:0] entering_values_18_features_left_q;
  logic [5:0] entering_values_18_features_right_q;
  logic entering_values_18_features_mask_q;
  logic entering_values_18_row_q;
  logic [5:0] entering_values_19_features_left_q;
  logic [5:0] entering_values_19_features_right_q;
  logic entering_values_19_features_mask_q;
  logic entering_values_19_row_q;
  logic [5:0] entering_values_20_features_left_q;
  logic [5:0] entering_values_20_features_right_q;
  logic entering_values_20_features_mask_q;
  logic entering_values_20_row_q;
  logic [5:0] entering_values_21_features_left_q;
  logic [5:0] entering_values_21_features_right_q;
  logic entering_values_21_features_mask_q;
  logic entering_values_21_row_q;
  logic [5:0] entering_values_22_features_left_q;
  logic [5:0] entering_values_22_features_right_q;
  logic entering_values_22_features_mask_q;
  logic entering_values_22_row_q;
  logic [5:0] entering_values_23_features_left_q;
  logic [5:0] entering_values_23_features_right_q;
  logic entering_values_23_features_mask_q;
  logic entering_values_23_row_q;
  logic [5:0] entering_values_24_features_right_q;
  logic entering_values_24_features_mask_q;
  logic entering_values_24_row_q;
  logic [5:0] entering_values_25_features_right_q;
  logic entering_values_25_features_mask_q;
  logic entering_values_25_row_q;
  logic [5:0] entering_values_26_features_right_q;
  logic entering_values_26_features_mask_q;
  logic entering_values_26_row_q;
  logic [5:0] entering_values_27_features_right_q;
  logic entering_values_27_features_mask_q;
  logic entering_values_27_row_q;
  logic [5:0] entering_values_28_features_right_q;
  logic entering_values_28_features_mask_q;
  logic entering_values_28_row_q;
  logic [5:0] entering_values_29_features_right_q;
  logic entering_values_29_features_mask_q;
  logic entering_values_29_row_q;
  logic [5:0] entering_values_30_features_right_q;
  logic entering_values_30_features_mask_q;
  logic entering_values_30_row_q;
  logic [5:0] entering_values_31_features_right_q;
  logic entering_values_31_features_mask_q;
  logic entering_values_31_row_q;
  logic [5:0] entering_values_32_features_right_q;
  logic entering_values_32_features_mask_q;
  logic entering_values_32_row_q;
  logic [5:0] entering_values_33_features_right_q;
  logic entering_values_33_features_mask_q;
  logic entering_values_33_row_q;
  logic [5:0] entering_values_34_features_right_q;
  logic entering_values_34_features_mask_q;
  logic entering_values_34_row_q;
  logic [5:0] entering_values_35_features_right_q;
  logic entering_values_35_features_mask_q;
  logic entering_values_35_row_q;
  logic [5:0] entering_values_36_features_right_q;
  logic entering_values_36_features_mask_q;
  logic entering_values_36_row_q;
  logic [5:0] entering_values_37_features_right_q;
  logic entering_values_37_features_mask_q;
  logic entering_values_37_row_q;
  logic [5:0] entering_values_38_features_right_q;
  logic entering_values_38_features_mask_q;
  logic entering_values_38_row_q;
  logic [5:0] entering_values_39_features_right_q;
  logic entering_values_39_features_mask_q;
  logic entering_values_39_row_q;
  logic [5:0] entering_values_40_features_right_q;
  logic entering_values_40_features_mask_q;
  logic entering_values_40_row_q;
  logic [5:0] entering_values_41_features_right_q;
  logic entering_values_41_features_mask_q;
  logic entering_values_41_row_q;
  logic [5:0] entering_values_42_features_right_q;
  logic entering_values_42_features_mask_q;
  logic entering_values_42_row_q;
  logic [5:0] entering_values_43_features_right_q;
  logic entering_values_43_features_mask_q;
  logic entering_values_43_row_q;
  logic [5:0] entering_values_44_features_right_q;
  logic entering_values_44_features_mask_q;
  logic entering_values_44_row_q;
  logic [5:0] entering_values_45_features_right_q;
  logic entering_values_45_features_mask_q;
  logic entering_values_45_row_q;
  logic [5:0] entering_values_46_features_right_q;
  logic entering_values_46_features_mask_q;
  logic entering_values_46_row_q;
  logic [5:0] entering_values_47_features_right_q;
  logic entering_values_47_features_mask_q;
  logic entering_values_47_row_q;
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
  logic centre_marks_values_0_first_q;
  logic centre_marks_values_0_last_q;
  logic centre_marks_values_1_first_q;
  logic centre_marks_values_1_last_q;
  logic centre_marks_values_2_first_q;
  logic centre_marks_values_2_last_q;
  logic centre_marks_values_3_first_q;
  logic centre_marks_values_3_last_q;
  // hls/stages/plane_sums.hpp:63
  logic or_629;
  assign or_629 = marks_first_i | arriving_row_ended_q;
  logic [9:0] select_631;
  assign select_631 = or_629 ? 10'h0 : (arriving_column_q + 10'h1);
  // hls/stages/plane_sums.hpp:81
  logic or_633;
  assign or_633 = delayed_row_ended_q | marks_values_25_first_q;
  logic [9:0] select_635;
  assign select_635 = or_633 ? 10'h0 : (delayed_column_q + 10'h1);
  // hls/stages/plane_sums.hpp:82
  logic or_636;
  assign or_636 = running_q | marks_values_25_first_q;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_1039;
  assign difference_1039 = {entering_values_23_features_left_q[5], entering_values_23_features_left_q} - {entering_values_47_features_right_q[5], entering_values_47_features_right_q};
  logic [5:0] xor_1040;
  assign xor_1040 = difference_1039[5:0] ^ {6{difference_1039[6]}};
  logic [6:0] sum_1041;
  assign sum_1041 = {6'h0, difference_1039[6]} + {1'b0, xor_1040};
  // hls/stages/plane_sums.hpp:157
  logic not_1044;
  assign not_1044 = ~(entering_values_23_row_q ^ entering_values_47_row_q);
  // hls/stages/plane_sums.hpp:87
  logic [4:0] select_1047;
  assign select_1047 = entering_values_47_features_mask_q ? (((sum_1041[6:5] == 2'h0) & not_1044) ? sum_1041[4:0] : 5'h1f) : 5'h1f;

  // Memory feature_memory, 640 x 91, DISTANCE 16, hls/stages/plane_sums.hpp:166; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] feature_memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) feature_memory_mem[i] = 91'h0;
`endif
  logic [9:0] feature_memory_raddr;
  assign feature_memory_raddr = select_631;
  logic feature_memory_re;
  assign feature_memory_re = s0_en;
  logic [90:0] feature_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (feature_memory_re) feature_memory_rdata_q <= feature_memory_mem[feature_memory_raddr];
  end

  // Memory column_memory, 640 x 191, DISTANCE 16, hls/stages/plane_sums.hpp:167; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [190:0] column_memory_mem [0:639];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 640; i++) column_memory_mem[i] = 191'h0;
`endif
  logic [9:0] column_memory_raddr;
  assign column_memory_raddr = select_635;
  logic column_memory_re;
  assign column_memory_re = s0_en & or_636;
  logic [190:0] column_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (column_memory_re) column_memory_rdata_q <= column_memory_mem[column_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      arriving_column_q <= 10'h0;
      arriving_row_ended_q <= 1'b1;
      delayed_column_q <= 10'h0;
      delayed_row_ended_q <= 1'b1;
      row_parity_q <= 1'b0;
      running_q <= 1'b0;
      entering_values_0_features_left_q <= 6'h0;
      entering_values_0_features_right_q <= 6'h0;
      entering_values_0_features_mask_q <= 1'b0;
      entering_values_1_features_left_q <= 6'h0;
      entering_values_1_features_right_q <= 6'h0;
      entering_values_1_features_mask_q <= 1'b0;
      entering_values_1_row_q <= 1'b0;
      entering_values_2_features_left_q <= 6'h0;
      entering_values_2_features_right_q <= 6'h0;
      entering_values_2_features_mask_q <= 1'b0;
      entering_values_2_row_q <= 1'b0;
      entering_values_3_features_left_q <= 6'h0;
      entering_values_3_features_right_q <= 6'h0;
      entering_values_3_features_mask_q <= 1'b0;
      entering_values_3_row_q <= 1'b0;
      entering_values_4_features_left_q <= 6'h0;
      entering_values_4_features_right_q <= 6'h0;
      entering_values_4_features_mask_q <= 1'b0;
      entering_values_4_row_q <= 1'b0;
      entering_values_5_features_left_q <= 6'h0;
      entering_values_5_features_right_q <= 6'h0;
      entering_values_5_features_mask_q <= 1'b0;
      entering_values_5_row_q <= 1'b0;
      entering_values_6_features_left_q <= 6'h0;
      entering_values_6_features_right_q <= 6'h0;
      entering_values_6_features_mask_q <= 1'b0;
      entering_values_6_row_q <= 1'b0;
      entering_values_7_features_left_q <= 6'h0;
      entering_values_7_features_right_q <= 6'h0;
      entering_values_7_features_mask_q <= 1'b0;
      entering_values_7_row_q <= 1'b0;
      entering_values_8_features_left_q <= 6'h0;
      entering_values_8_features_right_q <= 6'h0;
      entering_values_8_features_mask_q <= 1'b0;
      entering_values_8_row_q <= 1'b0;
      entering_values_9_features_left_q <= 6'h0;
      entering_values_9_features_right_q <= 6'h0;
      entering_values_9_features_mask_q <= 1'b0;
      entering_values_9_row_q <= 1'b0;
      entering_values_10_features_left_q <= 6'h0;
      entering_values_10_features_right_q <= 6'h0;
      entering_values_10_features_mask_q <= 1'b0;
      entering_values_10_row_q <= 1'b0;
      entering_values_11_features_left_q <= 6'h0;
      entering_values_11_features_right_q <= 6'h0;
      entering_values_11_features_mask_q <= 1'b0;
      entering_values_11_row_q <= 1'b0;
      entering_values_12_features_left_q <= 6'h0;
      entering_values_12_features_right_q <= 6'h0;
      entering_values_12_features_mask_q <= 1'b0;
      entering_values_12_row_q <= 1'b0;
      entering_values_13_features_left_q <= 6'h0;
      entering_values_13_features_right_q <= 6'h0;
      entering_values_13_features_mask_q <= 1'b0;
      entering_values_13_row_q <= 1'b0;
      entering_values_14_features_left_q <= 6'h0;
      entering_values_14_features_right_q <= 6'h0;
      entering_values_14_features_mask_q <= 1'b0;
      entering_values_14_row_q <= 1'b0;
      entering_values_15_features_left_q <= 6'h0;
      entering_values_15_features_right_q <= 6'h0;
      entering_values_15_features_mask_q <= 1'b0;
      entering_values_15_row_q <= 1'b0;
      entering_values_16_features_left_q <= 6'h0;
      entering_values_16_features_right_q <= 6'h0;
      entering_values_16_features_mask_q <= 1'b0;
      entering_values_16_row_q <= 1'b0;
      entering_values_17_features_left_q <= 6'h0;
      entering_values_17_features_right_q <= 6'h0;
      entering_values_17_features_mask_q <= 1'b0;
      entering_values_17_row_q <= 1'b0;
      entering_values_18_features_left_q <= 6'h0;
      entering_values_18_features_right_q <= 6'h0;
      entering_values_18_features_mask_q <= 1'b0;
      entering_values_18_row_q <= 1'b0;
      entering_values_19_features_left_q <= 6'h0;
      entering_values_19_features_right_q <= 6'h0;
      entering_values_19_features_mask_q <= 1'b0;
      entering_values_19_row_q <= 1'b0;
      entering_values_20_features_left_q <= 6'h0;
      entering_values_20_features_right_q <= 6'h0;
      entering_values_20_features_mask_q <= 1'b0;
      entering_values_20_row_q <= 1'b0;
      entering_values_21_features_left_q <= 6'h0;
      entering_values_21_features_right_q <= 6'h0;
      entering_values_21_features_mask_q <= 1'b0;
      entering_values_21_row_q <= 1'b0;
      entering_values_22_features_left_q <= 6'h0;
      entering_values_22_features_right_q <= 6'h0;
      entering_values_22_features_mask_q <= 1'b0;
      entering_values_22_row_q <= 1'b0;
      entering_values_23_features_left_q <= 6'h0;
      entering_values_23_features_right_q <= 6'h0;
      entering_values_23_features_mask_q <= 1'b0;
      entering_values_23_row_q <= 1'b0;
      entering_values_24_features_right_q <= 6'h0;
      entering_values_24_features_mask_q <= 1'b0;
      entering_values_24_row_q <= 1'b0;
      entering_values_25_features_right_q <= 6'h0;
      entering_values_25_features_mask_q <= 1'b0;
      entering_values_25_row_q <= 1'b0;
      entering_values_26_features_right_q <= 6'h0;
      entering_values_26_features_mask_q <= 1'b0;
      entering_values_26_row_q <= 1'b0;
      entering_values_27_features_right_q <= 6'h0;
      entering_values_27_features_mask_q <= 1'b0;
      entering_values_27_row_q <= 1'b0;
      entering_values_28_features_right_q <= 6'h0;
      entering_values_28_features_mask_q <= 1'b0;
      entering_values_28_row_q <= 1'b0;
      entering_values_29_features_right_q <= 6'h0;
      entering_values_29_features_mask_q <= 1'b0;
      entering_values_29_row_q <= 1'b0;
      entering_values_30_features_right_q <= 6'h0;
      entering_values_30_features_mask_q <= 1'b0;
      entering_values_30_row_q <= 1'b0;
      entering_values_31_features_right_q <= 6'h0;
      entering_values_31_features_mask_q <= 1'b0;
      entering_values_31_row_q <= 1'b0;
      entering_values_32_features_right_q <= 6'h0;
      entering_values_32_features_mask_q <= 1'b0;
      entering_values_32_row_q <= 1'b0;
      entering_values_33_features_right_q <= 6'h0;
      entering_values_33_features_mask_q <= 1'b0;
      entering_values_33_row_q <= 1'b0;
      entering_values_34_features_right_q <= 6'h0;
      entering_values_34_features_mask_q <= 1'b0;
      entering_values_34_row_q <= 1'b0;
      entering_values_35_features_right_q <= 6'h0;
      entering_values_35_features_mask_q <= 1'b0;
      entering_values_35_row_q <= 1'b0;
      entering_values_36_features_right_q <= 6'h0;
      entering_values_36_features_mask_q <= 1'b0;
      entering_values_36_row_q <= 1'b0;
      entering_values_37_features_right_q <= 6'h0;
      entering_values_37_features_mask_q <= 1'b0;
      entering_values_37_row_q <= 1'b0;
      entering_values_38_features_right_q <= 6'h0;
      entering_values_38_features_mask_q <= 1'b0;
      entering_values_38_row_q <= 1'b0;
      entering_values_39_features_right_q <= 6'h0;
      entering_values_39_features_mask_q <= 1'b0;
      entering_values_39_row_q <= 1'b0;
      entering_values_40_features_right_q <= 6'h0;
      entering_values_40_features_mask_q <= 1'b0;
      entering_values_40_row_q <= 1'b0;
      entering_values_41_features_right_q <= 6'h0;
      entering_values_41_features_mask_q <= 1'b0;
      entering_values_41_row_q <= 1'b0;
      entering_values_42_features_right_q <= 6'h0;
      entering_values_42_features_mask_q <= 1'b0;
      entering_values_42_row_q <= 1'b0;
      entering_values_43_features_right_q <= 6'h0;
      entering_values_43_features_mask_q <= 1'b0;
      entering_values_43_row_q <= 1'b0;
      entering_values_44_features_right_q <= 6'h0;
      entering_values_44_features_mask_q <= 1'b0;
      entering_values_44_row_q <= 1'b0;
      entering_values_45_features_right_q <= 6'h0;
      entering_values_45_features_mask_q <= 1'b0;
      entering_values_45_row_q <= 1'b0;
      entering_values_46_features_right_q <= 6'h0;
      entering_values_46_features_mask_q <= 1'b0;
      entering_values_46_row_q <= 1'b0;
      entering_values_47_features_right_q <= 6'h0;
      entering_values_47_features_mask_q <= 1'b0;
      entering_values_47_row_q <= 1'b0;
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
      centre_marks_values_0_first_q <= 1'b0;
      centre_marks_values_0_last_q <= 1'b0;
      centre_marks_values_1_first_q <= 1'b0;
      centre_marks_values_1_last_q <= 1'b0;
      centre_marks_values_2_first_q <= 1'b0;
      centre_marks_values_2_last_q <= 1'b0;
      centre_marks_values_3_first_q <= 1'b0;
      centre_marks_values_3_last_q <= 1'b0;
    end else if (s0_en) begin
      arriving_column_q <= select_631;
      arriving_row_ended_q <= marks_last_i;
      delayed_column_q <= select_635;
      delayed_row_ended_q <= marks_values_25_last_q;
      row_parity_q <= row_parity_q ^ or_629;
      running_q <= or_636;
      entering_values_0_features_left_q <= $unsigned(left_i);
      entering_values_0_features_right_q <= $unsigned(right_i);
      entering_values_0_features_mask_q <= mask_i;
      entering_values_1_features_left_q <= entering_values_0_features_left_q;
      entering_values_1_features_right_q <= entering_values_0_features_right_q;
      entering_values_1_features_mask_q <= entering_values_0_features_mask_q;
      entering_values_1_row_q <= row_parity_q;
      entering_values_2_features_left_q <= entering_values_1_features_left_q;
      entering_values_2_features_right_q <= entering_values_1_features_right_q;
      entering_values_2_features_mask_q <= entering_values_1_features_mask_q;
      entering_values_2_row_q <= entering_values_1_row_q;
      entering_values_3_features_left_q <= entering_values_2_features_left_q;
      entering_values_3_features_right_q <= entering_values_2_features_right_q;
      entering_values_3_features_mask_q <= entering_values_2_features_mask_q;
      entering_values_3_row_q <= entering_values_2_row_q;
      entering_values_4_features_left_q <= entering_values_3_features_left_q;
      entering_values_4_features_right_q <= entering_values_3_features_right_q;
      entering_values_4_features_mask_q <= entering_values_3_features_mask_q;
      entering_values_4_row_q <= entering_values_3_row_q;
      entering_values_5_features_left_q <= entering_values_4_features_left_q;
      entering_values_5_features_right_q <= entering_values_4_features_right_q;
      entering_values_5_features_mask_q <= entering_values_4_features_mask_q;
      entering_values_5_row_q <= entering_values_4_row_q;
      entering_values_6_features_left_q <= entering_values_5_features_left_q;
      entering_values_6_features_right_q <= entering_values_5_features_right_q;
      entering_values_6_features_mask_q <= entering_values_5_features_mask_q;
      entering_values_6_row_q <= entering_values_5_row_q;
      entering_values_7_features_left_q <= entering_values_6_features_left_q;
      entering_values_7_features_right_q <= entering_values_6_features_right_q;
      entering_values_7_features_mask_q <= entering_values_6_features_mask_q;
      entering_values_7_row_q <= entering_values_6_row_q;
      entering_values_8_features_left_q <= entering_values_7_features_left_q;
      entering_values_8_features_right_q <= entering_values_7_features_right_q;
      entering_values_8_features_mask_q <= entering_values_7_features_mask_q;
      entering_values_8_row_q <= entering_values_7_row_q;
      entering_values_9_features_left_q <= entering_values_8_features_left_q;
      entering_values_9_features_right_q <= entering_values_8_features_right_q;
      entering_values_9_features_mask_q <= entering_values_8_features_mask_q;
      entering_values_9_row_q <= entering_values_8_row_q;
      entering_values_10_features_left_q <= entering_values_9_features_left_q;
      entering_values_10_features_right_q <= entering_values_9_features_right_q;
      entering_values_10_features_mask_q <= entering_values_9_features_mask_q;
      entering_values_10_row_q <= entering_values_9_row_q;
      entering_values_11_features_left_q <= entering_values_10_features_left_q;
      entering_values_11_features_right_q <= entering_values_10_features_right_q;
      entering_values_11_features_mask_q <= entering_values_10_features_mask_q;
      entering_values_11_row_q <= entering_values_10_row_q;
      entering_values_12_features_left_q <= entering_values_11_features_left_q;
      entering_values_12_features_right_q <= entering_values_11_features_right_q;
      entering_values_12_features_mask_q <= entering_values_11_features_mask_q;
      entering_values_12_row_q <= entering_values_11_row_q;
      entering_values_13_features_left_q <= entering_values_12_features_left_q;
      entering_values_13_features_right_q <= entering_values_12_features_right_q;
      entering_values_13_features_mask_q <= entering_values_12_features_mask_q;
      entering_values_13_row_q <= entering_values_12_row_q;
      entering_values_14_features_left_q <= entering_values_13_features_left_q;
      entering_values_14_features_right_q <= entering_values_13_features_right_q;
      entering_values_14_features_mask_q <= entering_values_13_features_mask_q;
      entering_values_14_row_q <= entering_values_13_row_q;
      entering_values_15_features_left_q <= entering_values_14_features_left_q;
      entering_values_15_features_right_q <= entering_values_14_features_right_q;
      entering_values_15_features_mask_q <= entering_values_14_features_mask_q;
      entering_values_15_row_q <= entering_values_14_row_q;
      entering_values_16_features_left_q <= entering_values_15_features_left_q;
      entering_values_16_features_right_q <= entering_values_15_features_right_q;
      entering_values_16_features_mask_q <= entering_values_15_features_mask_q;
      entering_values_16_row_q <= entering_values_15_row_q;
      entering_values_17_features_left_q <= entering_values_16_features_left_q;
      entering_values_17_features_right_q <= entering_values_16_features_right_q;
      entering_values_17_features_mask_q <= entering_values_16_features_mask_q;
      entering_values_17_row_q <= entering_values_16_row_q;
      entering_values_18_features_left_q <= entering_values_17_features_left_q;
      entering_values_18_features_right_q <= entering_values_17_features_right_q;
      entering_values_18_features_mask_q <= entering_values_17_features_mask_q;
      entering_values_18_row_q <= entering_values_17_row_q;
      entering_values_19_features_left_q <= entering_values_18_features_left_q;
      entering_values_19_features_right_q <= entering_values_18_features_right_q;
      entering_values_19_features_mask_q <= entering_values_18_features_mask_q;
      entering_values_19_row_q <= entering_values_18_row_q;
      entering_values_20_features_left_q <= entering_values_19_features_left_q;
      entering_values_20_features_right_q <= entering_values_19_features_right_q;
      entering_values_20_features_mask_q <= entering_values_19_features_mask_q;
      entering_values_20_row_q <= entering_values_19_row_q;
      entering_values_21_features_left_q <= entering_values_20_features_left_q;
      entering_values_21_features_right_q <= entering_values_20_features_right_q;
      entering_values_21_features_mask_q <= entering_values_20_features_mask_q;
      entering_values_21_row_q <= entering_values_20_row_q;
      entering_values_22_features_left_q <= entering_values_21_features_left_q;
      entering_values_22_features_right_q <= entering_values_21_features_right_q;
      entering_values_22_features_mask_q <= entering_values_21_features_mask_q;
      entering_values_22_row_q <= entering_values_21_row_q;
      entering_values_23_features_left_q <= entering_values_22_features_left_q;
      entering_values_23_features_right_q <= entering_values_22_features_right_q;
      entering_values_23_features_mask_q <= entering_values_22_features_mask_q;
      entering_values_23_row_q <= entering_values_22_row_q;
      entering_values_24_features_right_q <= entering_values_23_features_right_q;
      entering_values_24_features_mask_q <= entering_values_23_features_mask_q;
      entering_values_24_row_q <= entering_values_23_row_q;
      entering_values_25_features_right_q <= entering_values_24_features_right_q;
      entering_values_25_features_mask_q <= entering_values_24_features_mask_q;
      entering_values_25_row_q <= entering_values_24_row_q;
      entering_values_26_features_right_q <= entering_values_25_features_right_q;
      entering_values_26_features_mask_q <= entering_values_25_features_mask_q;
      entering_values_26_row_q <= entering_values_25_row_q;
      entering_values_27_features_right_q <= entering_values_26_features_right_q;
      entering_values_27_features_mask_q <= entering_values_26_features_mask_q;
      entering_values_27_row_q <= entering_values_26_row_q;
      entering_values_28_features_right_q <= entering_values_27_features_right_q;
      entering_values_28_features_mask_q <= entering_values_27_features_mask_q;
      entering_values_28_row_q <= entering_values_27_row_q;
      entering_values_29_features_right_q <= entering_values_28_features_right_q;
      entering_values_29_features_mask_q <= entering_values_28_features_mask_q;
      entering_values_29_row_q <= entering_values_28_row_q;
      entering_values_30_features_right_q <= entering_values_29_features_right_q;
      entering_values_30_features_mask_q <= entering_values_29_features_mask_q;
      entering_values_30_row_q <= entering_values_29_row_q;
      entering_values_31_features_right_q <= entering_values_30_features_right_q;
      entering_values_31_features_mask_q <= entering_values_30_features_mask_q;
      entering_values_31_row_q <= entering_values_30_row_q;
      entering_values_32_features_right_q <= entering_values_31_features_right_q;
      entering_values_32_features_mask_q <= entering_values_31_features_mask_q;
      entering_values_32_row_q <= entering_values_31_row_q;
      entering_values_33_features_right_q <= entering_values_32_features_right_q;
      entering_values_33_features_mask_q <= entering_values_32_features_mask_q;
      entering_values_33_row_q <= entering_values_32_row_q;
      entering_values_34_features_right_q <= entering_values_33_features_right_q;
      entering_values_34_features_mask_q <= entering_values_33_features_mask_q;
      entering_values_34_row_q <= entering_values_33_row_q;
      entering_values_35_features_right_q <= entering_values_34_features_right_q;
      entering_values_35_features_mask_q <= entering_values_34_features_mask_q;
      entering_values_35_row_q <= entering_values_34_row_q;
      entering_values_36_features_right_q <= entering_values_35_features_right_q;
      entering_values_36_features_mask_q <= entering_values_35_features_mask_q;
      entering_values_36_row_q <= entering_values_35_row_q;
      entering_values_37_features_right_q <= entering_values_36_features_right_q;
      entering_values_37_features_mask_q <= entering_values_36_features_mask_q;
      entering_values_37_row_q <= entering_values_36_row_q;
      entering_values_38_features_right_q <= entering_values_37_features_right_q;
      entering_values_38_features_mask_q <= entering_values_37_features_mask_q;
      entering_values_38_row_q <= entering_values_37_row_q;
      entering_values_39_features_right_q <= entering_values_38_features_right_q;
      entering_values_39_features_mask_q <= entering_values_38_features_mask_q;
      entering_values_39_row_q <= entering_values_38_row_q;
      entering_values_40_features_right_q <= entering_values_39_features_right_q;
      entering_values_40_features_mask_q <= entering_values_39_features_mask_q;
      entering_values_40_row_q <= entering_values_39_row_q;
      entering_values_41_features_right_q <= entering_values_40_features_right_q;
      entering_values_41_features_mask_q <= entering_values_40_features_mask_q;
      entering_values_41_row_q <= entering_values_40_row_q;
      entering_values_42_features_right_q <= entering_values_41_features_right_q;
      entering_values_42_features_mask_q <= entering_values_41_features_mask_q;
      entering_values_42_row_q <= entering_values_41_row_q;
      entering_values_43_features_right_q <= entering_values_42_features_right_q;
      entering_values_43_features_mask_q <= entering_values_42_features_mask_q;
      entering_values_43_row_q <= entering_values_42_row_q;
      entering_values_44_features_right_q <= entering_values_43_features_right_q;
      entering_values_44_features_mask_q <= entering_values_43_features_mask_q;
      entering_values_44_row_q <= entering_values_43_row_q;
      entering_values_45_features_right_q <= entering_values_44_features_right_q;
      entering_values_45_features_mask_q <= entering_values_44_features_mask_q;
      entering_values_45_row_q <= entering_values_44_row_q;
      entering_values_46_features_right_q <= entering_values_45_features_right_q;
      entering_values_46_features_mask_q <= entering_values_45_features_mask_q;
      entering_values_46_row_q <= entering_values_45_row_q;
      entering_values_47_features_right_q <= entering_values_46_features_right_q;
      entering_values_47_features_mask_q <= entering_values_46_features_mask_q;
      entering_values_47_row_q <= entering_values_46_row_q;
      marks_values_0_first_q <= marks_first_i;
      marks_values_0_last_q <= marks_last_i;
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
      centre_marks_values_0_first_q <= marks_values_25_first_q;
      centre_marks_values_0_last_q <= marks_values_25_last_q;
      centre_marks_values_1_first_q <= centre_marks_values_0_first_q;
      centre_marks_values_1_last_q <= centre_marks_values_0_last_q;
      centre_marks_values_2_first_q <= centre_marks_values_1_first_q;
      centre_marks_values_2_last_q <= centre_marks_values_1_last_q;
      centre_marks_values_3_first_q <= centre_marks_values_2_first_q;
      centre_marks_values_3_last_q <= centre_marks_values_2_last_q;
    end
  end

  logic [5:0] entering_values_23_features_left_s1_q;
  logic [5:0] seen_values_24_grey_s1_q;
  logic seen_values_24_exists_s1_q;
  logic centre_marks_values_3_first_s1_q;
  logic centre_marks_values_3_last_s1_q;
  logic or_633_s1_q;
  logic not_649_s1_q;
  logic not_1044_s1_q;
  logic [4:0] select_1048_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      entering_values_23_features_left_s1_q <= entering_values_23_features_left_q;
      seen_values_24_grey_s1_q <= seen_values_24_grey_q;
      seen_values_24_exists_s1_q <= seen_values_24_exists_q;
      centre_marks_values_3_first_s1_q <= centre_marks_values_3_first_q;
      centre_marks_values_3_last_s1_q <= centre_marks_values_3_last_q;
      or_633_s1_q <= or_633;
      not_649_s1_q <= ~(^{or_629, entering_values_23_row_q, row_parity_q});
      not_1044_s1_q <= not_1044;
      select_1048_s1_q <= entering_values_23_features_mask_q ? select_1047 : 5'h0;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [2:0] arriving_rows_q;
  logic [2:0] delayed_rows_q;
  logic [5:0] leaving_values_0_features_left_q;
  logic [5:0] leaving_values_0_features_right_q;
  logic leaving_values_0_features_mask_q;
  logic [5:0] leaving_values_1_features_left_q;
  logic [5:0] leaving_values_1_features_right_q;
  logic leaving_values_1_features_mask_q;
  logic [5:0] leaving_values_2_features_left_q;
  logic [5:0] leaving_values_2_features_right_q;
  logic leaving_values_2_features_mask_q;
  logic [5:0] leaving_values_3_features_left_q;
  logic [5:0] leaving_values_3_features_right_q;
  logic leaving_values_3_features_mask_q;
  logic [5:0] leaving_values_4_features_left_q;
  logic [5:0] leaving_values_4_features_right_q;
  logic leaving_values_4_features_mask_q;
  logic [5:0] leaving_values_5_features_left_q;
  logic [5:0] leaving_values_5_features_right_q;
  logic leaving_values_5_features_mask_q;
  logic [5:0] leaving_values_6_features_left_q;
  logic [5:0] leaving_values_6_features_right_q;
  logic leaving_values_6_features_mask_q;
  logic [5:0] leaving_values_7_features_left_q;
  logic [5:0] leaving_values_7_features_right_q;
  logic leaving_values_7_features_mask_q;
  logic [5:0] leaving_values_8_features_left_q;
  logic [5:0] leaving_values_8_features_right_q;
  logic leaving_values_8_features_mask_q;
  logic [5:0] leaving_values_9_features_left_q;
  logic [5:0] leaving_values_9_features_right_q;
  logic leaving_values_9_features_mask_q;
  logic [5:0] leaving_values_10_features_left_q;
  logic [5:0] leaving_values_10_features_right_q;
  logic leaving_values_10_features_mask_q;
  logic [5:0] leaving_values_11_features_left_q;
  logic [5:0] leaving_values_11_features_right_q;
  logic leaving_values_11_features_mask_q;
  logic [5:0] leaving_values_12_features_left_q;
  logic [5:0] leaving_values_12_features_right_q;
  logic leaving_values_12_features_mask_q;
  logic [5:0] leaving_values_13_features_left_q;
  logic [5:0] leaving_values_13_features_right_q;
  logic leaving_values_13_features_mask_q;
  logic [5:0] leaving_values_14_features_left_q;
  logic [5:0] leaving_values_14_features_right_q;
  logic leaving_values_14_features_mask_q;
  logic [5:0] leaving_values_15_features_left_q;
  logic [5:0] leaving_values_15_features_right_q;
  logic leaving_values_15_features_mask_q;
  logic [5:0] leaving_values_16_features_left_q;
  logic [5:0] leaving_values_16_features_right_q;
  logic leaving_values_16_features_mask_q;
  logic [5:0] leaving_values_17_features_left_q;
  logic [5:0] leaving_values_17_features_right_q;
  logic leaving_values_17_features_mask_q;
  logic [5:0] leaving_values_18_features_left_q;
  logic [5:0] leaving_values_18_features_right_q;
  logic leaving_values_18_features_mask_q;
  logic [5:0] leaving_values_19_features_left_q;
  logic [5:0] leaving_values_19_features_right_q;
  logic leaving_values_19_features_mask_q;
  logic [5:0] leaving_values_20_features_left_q;
  logic [5:0] leaving_values_20_features_right_q;
  logic leaving_values_20_features_mask_q;
  logic [5:0] leaving_values_21_features_left_q;
  logic [5:0] leaving_values_21_features_right_q;
  logic leaving_values_21_features_mask_q;
  logic [5:0] leaving_values_22_features_left_q;
  logic [5:0] leaving_values_22_features_right_q;
  logic leaving_values_22_features_mask_q;
  logic [5:0] leaving_values_23_features_left_q;
  logic [5:0] leaving_values_23_features_right_q;
  logic leaving_values_23_features_mask_q;
  logic [5:0] leaving_values_24_features_right_q;
  logic leaving_values_24_features_mask_q;
  logic [5:0] leaving_values_25_features_right_q;
  logic leaving_values_25_features_mask_q;
  logic [5:0] leaving_values_26_features_right_q;
  logic leaving_values_26_features_mask_q;
  logic [5:0] leaving_values_27_features_right_q;
  logic leaving_values_27_features_mask_q;
  logic [5:0] leaving_values_28_features_right_q;
  logic leaving_values_28_features_mask_q;
  logic [5:0] leaving_values_29_features_right_q;
  logic leaving_values_29_features_mask_q;
  logic [5:0] leaving_values_30_features_right_q;
  logic leaving_values_30_features_mask_q;
  logic [5:0] leaving_values_31_features_right_q;
  logic leaving_values_31_features_mask_q;
  logic [5:0] leaving_values_32_features_right_q;
  logic leaving_values_32_features_mask_q;
  logic [5:0] leaving_values_33_features_right_q;
  logic leaving_values_33_features_mask_q;
  logic [5:0] leaving_values_34_features_right_q;
  logic leaving_values_34_features_mask_q;
  logic [5:0] leaving_values_35_features_right_q;
  logic leaving_values_35_features_mask_q;
  logic [5:0] leaving_values_36_features_right_q;
  logic leaving_values_36_features_mask_q;
  logic [5:0] leaving_values_37_features_right_q;
  logic leaving_values_37_features_mask_q;
  logic [5:0] leaving_values_38_features_right_q;
  logic leaving_values_38_features_mask_q;
  logic [5:0] leaving_values_39_features_right_q;
  logic leaving_values_39_features_mask_q;
  logic [5:0] leaving_values_40_features_right_q;
  logic leaving_values_40_features_mask_q;
  logic [5:0] leaving_values_41_features_right_q;
  logic leaving_values_41_features_mask_q;
  logic [5:0] leaving_values_42_features_right_q;
  logic leaving_values_42_features_mask_q;
  logic [5:0] leaving_values_43_features_right_q;
  logic leaving_values_43_features_mask_q;
  logic [5:0] leaving_values_44_features_right_q;
  logic leaving_values_44_features_mask_q;
  logic [5:0] leaving_values_45_features_right_q;
  logic leaving_values_45_features_mask_q;
  logic [5:0] leaving_values_46_features_right_q;
  logic leaving_values_46_features_mask_q;
  logic [5:0] leaving_values_47_features_right_q;
  logic leaving_values_47_features_mask_q;
  logic [10:0] rows_0_columns_values_0_q;
  logic [10:0] rows_0_columns_values_1_q;
  logic [10:0] rows_0_columns_values_2_q;
  logic [10:0] rows_0_columns_values_3_q;
  logic [10:0] rows_0_columns_values_4_q;
  logic [10:0] rows_0_columns_values_5_q;
  logic [10:0] rows_0_columns_values_6_q;
  logic [10:0] rows_0_columns_values_7_q;
  logic [10:0] rows_0_columns_values_8_q;
  logic [10:0] rows_0_sum_sums_values_0_q;
  logic [10:0] rows_1_columns_values_0_q;
  logic [10:0] rows_1_columns_values_1_q;
  logic [10:0] rows_1_columns_values_2_q;
  logic [10:0] rows_1_columns_values_3_q;
  logic [10:0] rows_1_columns_values_4_q;
  logic [10:0] rows_1_columns_values_5_q;
  logic [10:0] rows_1_columns_values_6_q;
  logic [10:0] rows_1_columns_values_7_q;
  logic [10:0] rows_1_columns_values_8_q;
  logic [10:0] rows_1_sum_sums_values_0_q;
  logic [10:0] rows_2_columns_values_0_q;
  logic [10:0] rows_2_columns_values_1_q;
  logic [10:0] rows_2_columns_values_2_q;
  logic [10:0] rows_2_columns_values_3_q;
  logic [10:0] rows_2_columns_values_4_q;
  logic [10:0] rows_2_columns_values_5_q;
  logic [10:0] rows_2_columns_values_6_q;
  logic [10:0] rows_2_columns_values_7_q;
  logic [10:0] rows_2_columns_values_8_q;
  logic [10:0] rows_2_sum_sums_values_0_q;
  logic [10:0] rows_3_columns_values_0_q;
  logic [10:0] rows_3_columns_values_1_q;
  logic [10:0] rows_3_columns_values_2_q;
  logic [10:0] rows_3_columns_values_3_q;
  logic [10:0] rows_3_columns_values_4_q;
  logic [10:0] rows_3_columns_values_5_q;
  logic [10:0] rows_3_columns_values_6_q;
  logic [10:0] rows_3_columns_values_7_q;
  logic [10:0] rows_3_columns_values_8_q;
  logic [10:0] rows_3_sum_sums_values_0_q;
  logic [10:0] rows_4_columns_values_0_q;
  logic [10:0] rows_4_columns_values_1_q;
  logic [10:0] rows_4_columns_values_2_q;
  logic [10:0] rows_4_columns_values_3_q;
  logic [10:0] rows_4_columns_values_4_q;
  logic [10:0] rows_4_columns_values_5_q;
  logic [10:0] rows_4_columns_values_6_q;
  logic [10:0] rows_4_columns_values_7_q;
  logic [10:0] rows_4_columns_values_8_q;
  logic [10:0] rows_4_sum_sums_values_0_q;
  logic [10:0] rows_5_columns_values_0_q;
  logic [10:0] rows_5_columns_values_1_q;
  logic [10:0] rows_5_columns_values_2_q;
  logic [10:0] rows_5_columns_values_3_q;
  logic [10:0] rows_5_columns_values_4_q;
  logic [10:0] rows_5_columns_values_5_q;
  logic [10:0] rows_5_columns_values_6_q;
  logic [10:0] rows_5_columns_values_7_q;
  logic [10:0] rows_5_columns_values_8_q;
  logic [10:0] rows_5_sum_sums_values_0_q;
  logic [10:0] rows_6_columns_values_0_q;
  logic [10:0] rows_6_columns_values_1_q;
  logic [10:0] rows_6_columns_values_2_q;
  logic [10:0] rows_6_columns_values_3_q;
  logic [10:0] rows_6_columns_values_4_q;
  logic [10:0] rows_6_columns_values_5_q;
  logic [10:0] rows_6_columns_values_6_q;
  logic [10:0] rows_6_columns_values_7_q;
  logic [10:0] rows_6_columns_values_8_q;
  logic [10:0] rows_6_sum_sums_values_0_q;
  logic [10:0] rows_7_columns_values_0_q;
  logic [10:0] rows_7_columns_values_1_q;
  logic [10:0] rows_7_columns_values_2_q;
  logic [10:0] rows_7_columns_values_3_q;
  logic [10:0] rows_7_columns_values_4_q;
  logic [10:0] rows_7_columns_values_5_q;
  logic [10:0] rows_7_columns_values_6_q;
  logic [10:0] rows_7_columns_values_7_q;
  logic [10:0] rows_7_columns_values_8_q;
  logic [10:0] rows_7_sum_sums_values_0_q;
  logic [10:0] rows_8_columns_values_0_q;
  logic [10:0] rows_8_columns_values_1_q;
  logic [10:0] rows_8_columns_values_2_q;
  logic [10:0] rows_8_columns_values_3_q;
  logic [10:0] rows_8_columns_values_4_q;
  logic [10:0] rows_8_columns_values_5_q;
  logic [10:0] rows_8_columns_values_6_q;
  logic [10:0] rows_8_columns_values_7_q;
  logic [10:0] rows_8_columns_values_8_q;
  logic [10:0] rows_8_sum_sums_values_0_q;
  logic [10:0] rows_9_columns_values_0_q;
  logic [10:0] rows_9_columns_values_1_q;
  logic [10:0] rows_9_columns_values_2_q;
  logic [10:0] rows_9_columns_values_3_q;
  logic [10:0] rows_9_columns_values_4_q;
  logic [10:0] rows_9_columns_values_5_q;
  logic [10:0] rows_9_columns_values_6_q;
  logic [10:0] rows_9_columns_values_7_q;
  logic [10:0] rows_9_columns_values_8_q;
  logic [10:0] rows_9_sum_sums_values_0_q;
  logic [10:0] rows_10_columns_values_0_q;
  logic [10:0] rows_10_columns_values_1_q;
  logic [10:0] rows_10_columns_values_2_q;
  logic [10:0] rows_10_columns_values_3_q;
  logic [10:0] rows_10_columns_values_4_q;
  logic [10:0] rows_10_columns_values_5_q;
  logic [10:0] rows_10_columns_values_6_q;
  logic [10:0] rows_10_columns_values_7_q;
  logic [10:0] rows_10_columns_values_8_q;
  logic [10:0] rows_10_sum_sums_values_0_q;
  logic [10:0] rows_11_columns_values_0_q;
  logic [10:0] rows_11_columns_values_1_q;
  logic [10:0] rows_11_columns_values_2_q;
  logic [10:0] rows_11_columns_values_3_q;
  logic [10:0] rows_11_columns_values_4_q;
  logic [10:0] rows_11_columns_values_5_q;
  logic [10:0] rows_11_columns_values_6_q;
  logic [10:0] rows_11_columns_values_7_q;
  logic [10:0] rows_11_columns_values_8_q;
  logic [10:0] rows_11_sum_sums_values_0_q;
  logic [10:0] rows_12_columns_values_0_q;
  logic [10:0] rows_12_columns_values_1_q;
  logic [10:0] rows_12_columns_values_2_q;
  logic [10:0] rows_12_columns_values_3_q;
  logic [10:0] rows_12_columns_values_4_q;
  logic [10:0] rows_12_columns_values_5_q;
  logic [10:0] rows_12_columns_values_6_q;
  logic [10:0] rows_12_columns_values_7_q;
  logic [10:0] rows_12_columns_values_8_q;
  logic [10:0] rows_12_sum_sums_values_0_q;
  logic [10:0] rows_13_columns_values_0_q;
  logic [10:0] rows_13_columns_values_1_q;
  logic [10:0] rows_13_columns_values_2_q;
  logic [10:0] rows_13_columns_values_3_q;
  logic [10:0] rows_13_columns_values_4_q;
  logic [10:0] rows_13_columns_values_5_q;
  logic [10:0] rows_13_columns_values_6_q;
  logic [10:0] rows_13_columns_values_7_q;
  logic [10:0] rows_13_columns_values_8_q;
  logic [10:0] rows_13_sum_sums_values_0_q;
  logic [10:0] rows_14_columns_values_0_q;
  logic [10:0] rows_14_columns_values_1_q;
  logic [10:0] rows_14_columns_values_2_q;
  logic [10:0] rows_14_columns_values_3_q;
  logic [10:0] rows_14_columns_values_4_q;
  logic [10:0] rows_14_columns_values_5_q;
  logic [10:0] rows_14_columns_values_6_q;
  logic [10:0] rows_14_columns_values_7_q;
  logic [10:0] rows_14_columns_values_8_q;
  logic [10:0] rows_14_sum_sums_values_0_q;
  logic [10:0] rows_15_columns_values_0_q;
  logic [10:0] rows_15_columns_values_1_q;
  logic [10:0] rows_15_columns_values_2_q;
  logic [10:0] rows_15_columns_values_3_q;
  logic [10:0] rows_15_columns_values_4_q;
  logic [10:0] rows_15_columns_values_5_q;
  logic [10:0] rows_15_columns_values_6_q;
  logic [10:0] rows_15_columns_values_7_q;
  logic [10:0] rows_15_columns_values_8_q;
  logic [10:0] rows_15_sum_sums_values_0_q;
  logic [10:0] rows_16_columns_values_0_q;
  logic [10:0] rows_16_columns_values_1_q;
  logic [10:0] rows_16_columns_values_2_q;
  logic [10:0] rows_16_columns_values_3_q;
  logic [10:0] rows_16_columns_values_4_q;
  logic [10:0] rows_16_columns_values_5_q;
  logic [10:0] rows_16_columns_values_6_q;
  logic [10:0] rows_16_columns_values_7_q;
  logic [10:0] rows_16_columns_values_8_q;
  logic [10:0] rows_16_sum_sums_values_0_q;
  logic [10:0] rows_17_columns_values_0_q;
  logic [10:0] rows_17_columns_values_1_q;
  logic [10:0] rows_17_columns_values_2_q;
  logic [10:0] rows_17_columns_values_3_q;
  logic [10:0] rows_17_columns_values_4_q;
  logic [10:0] rows_17_columns_values_5_q;
  logic [10:0] rows_17_columns_values_6_q;
  logic [10:0] rows_17_columns_values_7_q;
  logic [10:0] rows_17_columns_values_8_q;
  logic [10:0] rows_17_sum_sums_values_0_q;
  logic [10:0] rows_18_columns_values_0_q;
  logic [10:0] rows_18_columns_values_1_q;
  logic [10:0] rows_18_columns_values_2_q;
  logic [10:0] rows_18_columns_values_3_q;
  logic [10:0] rows_18_columns_values_4_q;
  logic [10:0] rows_18_columns_values_5_q;
  logic [10:0] rows_18_columns_values_6_q;
  logic [10:0] rows_18_columns_values_7_q;
  logic [10:0] rows_18_columns_values_8_q;
  logic [10:0] rows_18_sum_sums_values_0_q;
  logic [10:0] rows_19_columns_values_0_q;
  logic [10:0] rows_19_columns_values_1_q;
  logic [10:0] rows_19_columns_values_2_q;
  logic [10:0] rows_19_columns_values_3_q;
  logic [10:0] rows_19_columns_values_4_q;
  logic [10:0] rows_19_columns_values_5_q;
  logic [10:0] rows_19_columns_values_6_q;
  logic [10:0] rows_19_columns_values_7_q;
  logic [10:0] rows_19_columns_values_8_q;
  logic [10:0] rows_19_sum_sums_values_0_q;
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
  logic [2:0] select_638;
  assign select_638 = centre_marks_values_0_first_q ? 3'h0 : delayed_rows_q;
  logic equal_639;
  assign equal_639 = select_638 == 3'h0;
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above;
  assign above = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[7:0] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_642;
  assign difference_642 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_0_features_right_q[5], entering_values_0_features_right_q};
  logic [5:0] xor_643;
  assign xor_643 = difference_642[5:0] ^ {6{difference_642[6]}};
  logic [6:0] sum_644;
  assign sum_644 = {6'h0, difference_642[6]} + {1'b0, xor_643};
  // hls/stages/plane_sums.hpp:158
  logic and_651;
  assign and_651 = (sum_644[6:5] == 2'h0) & (entering_values_0_features_mask_q & not_649_s1_q);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_653;
  assign select_653 = entering_values_24_features_mask_q ? (and_651 ? sum_644[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_654;
  assign difference_654 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {feature_memory_rdata_q[89], feature_memory_rdata_q[89:84]};
  logic [5:0] xor_655;
  assign xor_655 = difference_654[5:0] ^ {6{difference_654[6]}};
  logic [6:0] sum_656;
  assign sum_656 = {6'h0, difference_654[6]} + {1'b0, xor_655};
  // hls/stages/plane_sums.hpp:63
  logic [2:0] select_658;
  assign select_658 = marks_values_0_first_q ? 3'h0 : arriving_rows_q;
  logic equal_659;
  assign equal_659 = select_658 == 3'h7;
  // hls/stages/plane_sums.hpp:71
  logic and_660;
  assign and_660 = feature_memory_rdata_q[90] & equal_659;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_663;
  assign select_663 = ((sum_656[6:5] == 2'h0) & (and_660 & not_649_s1_q)) ? sum_656[4:0] : 5'h1f;
  logic [4:0] select_664;
  assign select_664 = leaving_values_23_features_mask_q ? select_663 : 5'h0;
  logic [5:0] difference_665;
  assign difference_665 = {1'b0, select_653} - {1'b0, select_664};
  logic [7:0] sum_666;
  assign sum_666 = above + {{2{difference_665[5]}}, difference_665};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_2;
  assign above_2 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[15:8] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_669;
  assign difference_669 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_6_features_right_q[5], entering_values_6_features_right_q};
  logic [5:0] xor_670;
  assign xor_670 = difference_669[5:0] ^ {6{difference_669[6]}};
  logic [6:0] sum_671;
  assign sum_671 = {6'h0, difference_669[6]} + {1'b0, xor_670};
  // hls/stages/plane_sums.hpp:157
  logic not_674;
  assign not_674 = ~(entering_values_6_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_676;
  assign and_676 = (sum_671[6:5] == 2'h0) & (entering_values_6_features_mask_q & not_674);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_678;
  assign select_678 = entering_values_24_features_mask_q ? (and_676 ? sum_671[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_679;
  assign difference_679 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_5_features_right_q[5], leaving_values_5_features_right_q};
  logic [5:0] xor_680;
  assign xor_680 = difference_679[5:0] ^ {6{difference_679[6]}};
  logic [6:0] sum_681;
  assign sum_681 = {6'h0, difference_679[6]} + {1'b0, xor_680};
  // hls/stages/plane_sums.hpp:158
  logic and_684;
  assign and_684 = (sum_681[6:5] == 2'h0) & (leaving_values_5_features_mask_q & not_674);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_686;
  assign select_686 = leaving_values_23_features_mask_q ? (and_684 ? sum_681[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_687;
  assign difference_687 = {1'b0, select_678} - {1'b0, select_686};
  logic [7:0] sum_688;
  assign sum_688 = above_2 + {{2{difference_687[5]}}, difference_687};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_3;
  assign above_3 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[23:16] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_691;
  assign difference_691 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_11_features_right_q[5], entering_values_11_features_right_q};
  logic [5:0] xor_692;
  assign xor_692 = difference_691[5:0] ^ {6{difference_691[6]}};
  logic [6:0] sum_693;
  assign sum_693 = {6'h0, difference_691[6]} + {1'b0, xor_692};
  // hls/stages/plane_sums.hpp:157
  logic not_696;
  assign not_696 = ~(entering_values_11_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_698;
  assign and_698 = (sum_693[6:5] == 2'h0) & (entering_values_11_features_mask_q & not_696);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_700;
  assign select_700 = entering_values_24_features_mask_q ? (and_698 ? sum_693[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_701;
  assign difference_701 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_10_features_right_q[5], leaving_values_10_features_right_q};
  logic [5:0] xor_702;
  assign xor_702 = difference_701[5:0] ^ {6{difference_701[6]}};
  logic [6:0] sum_703;
  assign sum_703 = {6'h0, difference_701[6]} + {1'b0, xor_702};
  // hls/stages/plane_sums.hpp:158
  logic and_706;
  assign and_706 = (sum_703[6:5] == 2'h0) & (leaving_values_10_features_mask_q & not_696);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_708;
  assign select_708 = leaving_values_23_features_mask_q ? (and_706 ? sum_703[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_709;
  assign difference_709 = {1'b0, select_700} - {1'b0, select_708};
  logic [7:0] sum_710;
  assign sum_710 = above_3 + {{2{difference_709[5]}}, difference_709};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_4;
  assign above_4 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[31:24] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_713;
  assign difference_713 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_15_features_right_q[5], entering_values_15_features_right_q};
  logic [5:0] xor_714;
  assign xor_714 = difference_713[5:0] ^ {6{difference_713[6]}};
  logic [6:0] sum_715;
  assign sum_715 = {6'h0, difference_713[6]} + {1'b0, xor_714};
  // hls/stages/plane_sums.hpp:157
  logic not_718;
  assign not_718 = ~(entering_values_15_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_720;
  assign and_720 = (sum_715[6:5] == 2'h0) & (entering_values_15_features_mask_q & not_718);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_722;
  assign select_722 = entering_values_24_features_mask_q ? (and_720 ? sum_715[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_723;
  assign difference_723 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_14_features_right_q[5], leaving_values_14_features_right_q};
  logic [5:0] xor_724;
  assign xor_724 = difference_723[5:0] ^ {6{difference_723[6]}};
  logic [6:0] sum_725;
  assign sum_725 = {6'h0, difference_723[6]} + {1'b0, xor_724};
  // hls/stages/plane_sums.hpp:158
  logic and_728;
  assign and_728 = (sum_725[6:5] == 2'h0) & (leaving_values_14_features_mask_q & not_718);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_730;
  assign select_730 = leaving_values_23_features_mask_q ? (and_728 ? sum_725[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_731;
  assign difference_731 = {1'b0, select_722} - {1'b0, select_730};
  logic [7:0] sum_732;
  assign sum_732 = above_4 + {{2{difference_731[5]}}, difference_731};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_5;
  assign above_5 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[39:32] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_735;
  assign difference_735 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_18_features_right_q[5], entering_values_18_features_right_q};
  logic [5:0] xor_736;
  assign xor_736 = difference_735[5:0] ^ {6{difference_735[6]}};
  logic [6:0] sum_737;
  assign sum_737 = {6'h0, difference_735[6]} + {1'b0, xor_736};
  // hls/stages/plane_sums.hpp:157
  logic not_740;
  assign not_740 = ~(entering_values_18_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_742;
  assign and_742 = (sum_737[6:5] == 2'h0) & (entering_values_18_features_mask_q & not_740);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_744;
  assign select_744 = entering_values_24_features_mask_q ? (and_742 ? sum_737[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_745;
  assign difference_745 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_17_features_right_q[5], leaving_values_17_features_right_q};
  logic [5:0] xor_746;
  assign xor_746 = difference_745[5:0] ^ {6{difference_745[6]}};
  logic [6:0] sum_747;
  assign sum_747 = {6'h0, difference_745[6]} + {1'b0, xor_746};
  // hls/stages/plane_sums.hpp:158
  logic and_750;
  assign and_750 = (sum_747[6:5] == 2'h0) & (leaving_values_17_features_mask_q & not_740);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_752;
  assign select_752 = leaving_values_23_features_mask_q ? (and_750 ? sum_747[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_753;
  assign difference_753 = {1'b0, select_744} - {1'b0, select_752};
  logic [7:0] sum_754;
  assign sum_754 = above_5 + {{2{difference_753[5]}}, difference_753};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_6;
  assign above_6 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[47:40] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_757;
  assign difference_757 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_20_features_right_q[5], entering_values_20_features_right_q};
  logic [5:0] xor_758;
  assign xor_758 = difference_757[5:0] ^ {6{difference_757[6]}};
  logic [6:0] sum_759;
  assign sum_759 = {6'h0, difference_757[6]} + {1'b0, xor_758};
  // hls/stages/plane_sums.hpp:157
  logic not_762;
  assign not_762 = ~(entering_values_20_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_764;
  assign and_764 = (sum_759[6:5] == 2'h0) & (entering_values_20_features_mask_q & not_762);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_766;
  assign select_766 = entering_values_24_features_mask_q ? (and_764 ? sum_759[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_767;
  assign difference_767 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_19_features_right_q[5], leaving_values_19_features_right_q};
  logic [5:0] xor_768;
  assign xor_768 = difference_767[5:0] ^ {6{difference_767[6]}};
  logic [6:0] sum_769;
  assign sum_769 = {6'h0, difference_767[6]} + {1'b0, xor_768};
  // hls/stages/plane_sums.hpp:158
  logic and_772;
  assign and_772 = (sum_769[6:5] == 2'h0) & (leaving_values_19_features_mask_q & not_762);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_774;
  assign select_774 = leaving_values_23_features_mask_q ? (and_772 ? sum_769[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_775;
  assign difference_775 = {1'b0, select_766} - {1'b0, select_774};
  logic [7:0] sum_776;
  assign sum_776 = above_6 + {{2{difference_775[5]}}, difference_775};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_7;
  assign above_7 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[55:48] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_779;
  assign difference_779 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_21_features_right_q[5], entering_values_21_features_right_q};
  logic [5:0] xor_780;
  assign xor_780 = difference_779[5:0] ^ {6{difference_779[6]}};
  logic [6:0] sum_781;
  assign sum_781 = {6'h0, difference_779[6]} + {1'b0, xor_780};
  // hls/stages/plane_sums.hpp:157
  logic not_784;
  assign not_784 = ~(entering_values_21_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_786;
  assign and_786 = (sum_781[6:5] == 2'h0) & (entering_values_21_features_mask_q & not_784);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_788;
  assign select_788 = entering_values_24_features_mask_q ? (and_786 ? sum_781[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_789;
  assign difference_789 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_20_features_right_q[5], leaving_values_20_features_right_q};
  logic [5:0] xor_790;
  assign xor_790 = difference_789[5:0] ^ {6{difference_789[6]}};
  logic [6:0] sum_791;
  assign sum_791 = {6'h0, difference_789[6]} + {1'b0, xor_790};
  // hls/stages/plane_sums.hpp:158
  logic and_794;
  assign and_794 = (sum_791[6:5] == 2'h0) & (leaving_values_20_features_mask_q & not_784);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_796;
  assign select_796 = leaving_values_23_features_mask_q ? (and_794 ? sum_791[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_797;
  assign difference_797 = {1'b0, select_788} - {1'b0, select_796};
  logic [7:0] sum_798;
  assign sum_798 = above_7 + {{2{difference_797[5]}}, difference_797};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_8;
  assign above_8 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[63:56] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_801;
  assign difference_801 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_22_features_right_q[5], entering_values_22_features_right_q};
  logic [5:0] xor_802;
  assign xor_802 = difference_801[5:0] ^ {6{difference_801[6]}};
  logic [6:0] sum_803;
  assign sum_803 = {6'h0, difference_801[6]} + {1'b0, xor_802};
  // hls/stages/plane_sums.hpp:157
  logic not_806;
  assign not_806 = ~(entering_values_22_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_808;
  assign and_808 = (sum_803[6:5] == 2'h0) & (entering_values_22_features_mask_q & not_806);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_810;
  assign select_810 = entering_values_24_features_mask_q ? (and_808 ? sum_803[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_811;
  assign difference_811 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_21_features_right_q[5], leaving_values_21_features_right_q};
  logic [5:0] xor_812;
  assign xor_812 = difference_811[5:0] ^ {6{difference_811[6]}};
  logic [6:0] sum_813;
  assign sum_813 = {6'h0, difference_811[6]} + {1'b0, xor_812};
  // hls/stages/plane_sums.hpp:158
  logic and_816;
  assign and_816 = (sum_813[6:5] == 2'h0) & (leaving_values_21_features_mask_q & not_806);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_818;
  assign select_818 = leaving_values_23_features_mask_q ? (and_816 ? sum_813[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_819;
  assign difference_819 = {1'b0, select_810} - {1'b0, select_818};
  logic [7:0] sum_820;
  assign sum_820 = above_8 + {{2{difference_819[5]}}, difference_819};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_9;
  assign above_9 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[71:64] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_823;
  assign difference_823 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_23_features_right_q[5], entering_values_23_features_right_q};
  logic [5:0] xor_824;
  assign xor_824 = difference_823[5:0] ^ {6{difference_823[6]}};
  logic [6:0] sum_825;
  assign sum_825 = {6'h0, difference_823[6]} + {1'b0, xor_824};
  // hls/stages/plane_sums.hpp:157
  logic not_828;
  assign not_828 = ~(entering_values_23_row_q ^ entering_values_24_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_830;
  assign and_830 = (sum_825[6:5] == 2'h0) & (entering_values_23_features_mask_q & not_828);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_832;
  assign select_832 = entering_values_24_features_mask_q ? (and_830 ? sum_825[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_833;
  assign difference_833 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_22_features_right_q[5], leaving_values_22_features_right_q};
  logic [5:0] xor_834;
  assign xor_834 = difference_833[5:0] ^ {6{difference_833[6]}};
  logic [6:0] sum_835;
  assign sum_835 = {6'h0, difference_833[6]} + {1'b0, xor_834};
  // hls/stages/plane_sums.hpp:158
  logic and_838;
  assign and_838 = (sum_835[6:5] == 2'h0) & (leaving_values_22_features_mask_q & not_828);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_840;
  assign select_840 = leaving_values_23_features_mask_q ? (and_838 ? sum_835[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_841;
  assign difference_841 = {1'b0, select_832} - {1'b0, select_840};
  logic [7:0] sum_842;
  assign sum_842 = above_9 + {{2{difference_841[5]}}, difference_841};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_10;
  assign above_10 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[79:72] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_845;
  assign difference_845 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_24_features_right_q[5], entering_values_24_features_right_q};
  logic [5:0] xor_846;
  assign xor_846 = difference_845[5:0] ^ {6{difference_845[6]}};
  logic [6:0] sum_847;
  assign sum_847 = {6'h0, difference_845[6]} + {1'b0, xor_846};
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_850;
  assign select_850 = (entering_values_24_features_mask_q & (sum_847[6:5] == 2'h0)) ? sum_847[4:0] : 5'h1f;
  logic [4:0] select_851;
  assign select_851 = entering_values_24_features_mask_q ? select_850 : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_852;
  assign difference_852 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_23_features_right_q[5], leaving_values_23_features_right_q};
  logic [5:0] xor_853;
  assign xor_853 = difference_852[5:0] ^ {6{difference_852[6]}};
  logic [6:0] sum_854;
  assign sum_854 = {6'h0, difference_852[6]} + {1'b0, xor_853};
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_857;
  assign select_857 = (leaving_values_23_features_mask_q & (sum_854[6:5] == 2'h0)) ? sum_854[4:0] : 5'h1f;
  logic [4:0] select_858;
  assign select_858 = leaving_values_23_features_mask_q ? select_857 : 5'h0;
  logic [5:0] difference_859;
  assign difference_859 = {1'b0, select_851} - {1'b0, select_858};
  logic [7:0] sum_860;
  assign sum_860 = above_10 + {{2{difference_859[5]}}, difference_859};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_11;
  assign above_11 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[87:80] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_863;
  assign difference_863 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_25_features_right_q[5], entering_values_25_features_right_q};
  logic [5:0] xor_864;
  assign xor_864 = difference_863[5:0] ^ {6{difference_863[6]}};
  logic [6:0] sum_865;
  assign sum_865 = {6'h0, difference_863[6]} + {1'b0, xor_864};
  // hls/stages/plane_sums.hpp:157
  logic not_868;
  assign not_868 = ~(entering_values_24_row_q ^ entering_values_25_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_870;
  assign and_870 = (sum_865[6:5] == 2'h0) & (entering_values_25_features_mask_q & not_868);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_872;
  assign select_872 = entering_values_24_features_mask_q ? (and_870 ? sum_865[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_873;
  assign difference_873 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_24_features_right_q[5], leaving_values_24_features_right_q};
  logic [5:0] xor_874;
  assign xor_874 = difference_873[5:0] ^ {6{difference_873[6]}};
  logic [6:0] sum_875;
  assign sum_875 = {6'h0, difference_873[6]} + {1'b0, xor_874};
  // hls/stages/plane_sums.hpp:158
  logic and_878;
  assign and_878 = (sum_875[6:5] == 2'h0) & (leaving_values_24_features_mask_q & not_868);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_880;
  assign select_880 = leaving_values_23_features_mask_q ? (and_878 ? sum_875[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_881;
  assign difference_881 = {1'b0, select_872} - {1'b0, select_880};
  logic [7:0] sum_882;
  assign sum_882 = above_11 + {{2{difference_881[5]}}, difference_881};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_12;
  assign above_12 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[95:88] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_885;
  assign difference_885 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_26_features_right_q[5], entering_values_26_features_right_q};
  logic [5:0] xor_886;
  assign xor_886 = difference_885[5:0] ^ {6{difference_885[6]}};
  logic [6:0] sum_887;
  assign sum_887 = {6'h0, difference_885[6]} + {1'b0, xor_886};
  // hls/stages/plane_sums.hpp:157
  logic not_890;
  assign not_890 = ~(entering_values_24_row_q ^ entering_values_26_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_892;
  assign and_892 = (sum_887[6:5] == 2'h0) & (entering_values_26_features_mask_q & not_890);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_894;
  assign select_894 = entering_values_24_features_mask_q ? (and_892 ? sum_887[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_895;
  assign difference_895 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_25_features_right_q[5], leaving_values_25_features_right_q};
  logic [5:0] xor_896;
  assign xor_896 = difference_895[5:0] ^ {6{difference_895[6]}};
  logic [6:0] sum_897;
  assign sum_897 = {6'h0, difference_895[6]} + {1'b0, xor_896};
  // hls/stages/plane_sums.hpp:158
  logic and_900;
  assign and_900 = (sum_897[6:5] == 2'h0) & (leaving_values_25_features_mask_q & not_890);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_902;
  assign select_902 = leaving_values_23_features_mask_q ? (and_900 ? sum_897[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_903;
  assign difference_903 = {1'b0, select_894} - {1'b0, select_902};
  logic [7:0] sum_904;
  assign sum_904 = above_12 + {{2{difference_903[5]}}, difference_903};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_13;
  assign above_13 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[103:96] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_907;
  assign difference_907 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_27_features_right_q[5], entering_values_27_features_right_q};
  logic [5:0] xor_908;
  assign xor_908 = difference_907[5:0] ^ {6{difference_907[6]}};
  logic [6:0] sum_909;
  assign sum_909 = {6'h0, difference_907[6]} + {1'b0, xor_908};
  // hls/stages/plane_sums.hpp:157
  logic not_912;
  assign not_912 = ~(entering_values_24_row_q ^ entering_values_27_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_914;
  assign and_914 = (sum_909[6:5] == 2'h0) & (entering_values_27_features_mask_q & not_912);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_916;
  assign select_916 = entering_values_24_features_mask_q ? (and_914 ? sum_909[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_917;
  assign difference_917 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_26_features_right_q[5], leaving_values_26_features_right_q};
  logic [5:0] xor_918;
  assign xor_918 = difference_917[5:0] ^ {6{difference_917[6]}};
  logic [6:0] sum_919;
  assign sum_919 = {6'h0, difference_917[6]} + {1'b0, xor_918};
  // hls/stages/plane_sums.hpp:158
  logic and_922;
  assign and_922 = (sum_919[6:5] == 2'h0) & (leaving_values_26_features_mask_q & not_912);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_924;
  assign select_924 = leaving_values_23_features_mask_q ? (and_922 ? sum_919[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_925;
  assign difference_925 = {1'b0, select_916} - {1'b0, select_924};
  logic [7:0] sum_926;
  assign sum_926 = above_13 + {{2{difference_925[5]}}, difference_925};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_14;
  assign above_14 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[111:104] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_929;
  assign difference_929 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_28_features_right_q[5], entering_values_28_features_right_q};
  logic [5:0] xor_930;
  assign xor_930 = difference_929[5:0] ^ {6{difference_929[6]}};
  logic [6:0] sum_931;
  assign sum_931 = {6'h0, difference_929[6]} + {1'b0, xor_930};
  // hls/stages/plane_sums.hpp:157
  logic not_934;
  assign not_934 = ~(entering_values_24_row_q ^ entering_values_28_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_936;
  assign and_936 = (sum_931[6:5] == 2'h0) & (entering_values_28_features_mask_q & not_934);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_938;
  assign select_938 = entering_values_24_features_mask_q ? (and_936 ? sum_931[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_939;
  assign difference_939 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_27_features_right_q[5], leaving_values_27_features_right_q};
  logic [5:0] xor_940;
  assign xor_940 = difference_939[5:0] ^ {6{difference_939[6]}};
  logic [6:0] sum_941;
  assign sum_941 = {6'h0, difference_939[6]} + {1'b0, xor_940};
  // hls/stages/plane_sums.hpp:158
  logic and_944;
  assign and_944 = (sum_941[6:5] == 2'h0) & (leaving_values_27_features_mask_q & not_934);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_946;
  assign select_946 = leaving_values_23_features_mask_q ? (and_944 ? sum_941[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_947;
  assign difference_947 = {1'b0, select_938} - {1'b0, select_946};
  logic [7:0] sum_948;
  assign sum_948 = above_14 + {{2{difference_947[5]}}, difference_947};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_15;
  assign above_15 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[119:112] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_951;
  assign difference_951 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_30_features_right_q[5], entering_values_30_features_right_q};
  logic [5:0] xor_952;
  assign xor_952 = difference_951[5:0] ^ {6{difference_951[6]}};
  logic [6:0] sum_953;
  assign sum_953 = {6'h0, difference_951[6]} + {1'b0, xor_952};
  // hls/stages/plane_sums.hpp:157
  logic not_956;
  assign not_956 = ~(entering_values_24_row_q ^ entering_values_30_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_958;
  assign and_958 = (sum_953[6:5] == 2'h0) & (entering_values_30_features_mask_q & not_956);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_960;
  assign select_960 = entering_values_24_features_mask_q ? (and_958 ? sum_953[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_961;
  assign difference_961 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_29_features_right_q[5], leaving_values_29_features_right_q};
  logic [5:0] xor_962;
  assign xor_962 = difference_961[5:0] ^ {6{difference_961[6]}};
  logic [6:0] sum_963;
  assign sum_963 = {6'h0, difference_961[6]} + {1'b0, xor_962};
  // hls/stages/plane_sums.hpp:158
  logic and_966;
  assign and_966 = (sum_963[6:5] == 2'h0) & (leaving_values_29_features_mask_q & not_956);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_968;
  assign select_968 = leaving_values_23_features_mask_q ? (and_966 ? sum_963[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_969;
  assign difference_969 = {1'b0, select_960} - {1'b0, select_968};
  logic [7:0] sum_970;
  assign sum_970 = above_15 + {{2{difference_969[5]}}, difference_969};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_16;
  assign above_16 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[127:120] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_973;
  assign difference_973 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_33_features_right_q[5], entering_values_33_features_right_q};
  logic [5:0] xor_974;
  assign xor_974 = difference_973[5:0] ^ {6{difference_973[6]}};
  logic [6:0] sum_975;
  assign sum_975 = {6'h0, difference_973[6]} + {1'b0, xor_974};
  // hls/stages/plane_sums.hpp:157
  logic not_978;
  assign not_978 = ~(entering_values_24_row_q ^ entering_values_33_row_q);
  // hls/stages/plane_sums.hpp:158
  logic and_980;
  assign and_980 = (sum_975[6:5] == 2'h0) & (entering_values_33_features_mask_q & not_978);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_982;
  assign select_982 = entering_values_24_features_mask_q ? (and_980 ? sum_975[4:0] : 5'h1f) : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_983;
  assign difference_983 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_32_features_right_q[5], leaving_values_32_features_right_q};
  logic [5:0] xor_984;
  assign xor_984 = difference_983[5:0] ^ {6{difference_983[6]}};
  logic [6:0] sum_985;
  assign sum_985 = {6'h0, difference_983[6]} + {1'b0, xor_984};
  // hls/stages/plane_sums.hpp:158
  logic and_988;
  assign and_988 = (sum_985[6:5] == 2'h0) & (leaving_values_32_features_mask_q & not_978);
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_990;
  assign select_990 = leaving_values_23_features_mask_q ? (and_988 ? sum_985[4:0] : 5'h1f) : 5'h0;
  logic [5:0] difference_991;
  assign difference_991 = {1'b0, select_982} - {1'b0, select_990};
  logic [7:0] sum_992;
  assign sum_992 = above_16 + {{2{difference_991[5]}}, difference_991};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_17;
  assign above_17 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[135:128] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_995;
  assign difference_995 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_37_features_right_q[5], entering_values_37_features_right_q};
  logic [5:0] xor_996;
  assign xor_996 = difference_995[5:0] ^ {6{difference_995[6]}};
  logic [6:0] sum_997;
  assign sum_997 = {6'h0, difference_995[6]} + {1'b0, xor_996};
  // hls/stages/plane_sums.hpp:157
  logic not_1000;
  assign not_1000 = ~(entering_values_24_row_q ^ entering_values_37_row_q);
  // hls/stages/plane_sums.hpp:87
  logic [4:0] select_1003;
  assign select_1003 = entering_values_37_features_mask_q ? (((sum_997[6:5] == 2'h0) & not_1000) ? sum_997[4:0] : 5'h1f) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1004;
  assign select_1004 = entering_values_24_features_mask_q ? select_1003 : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_1005;
  assign difference_1005 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_36_features_right_q[5], leaving_values_36_features_right_q};
  logic [5:0] xor_1006;
  assign xor_1006 = difference_1005[5:0] ^ {6{difference_1005[6]}};
  logic [6:0] sum_1007;
  assign sum_1007 = {6'h0, difference_1005[6]} + {1'b0, xor_1006};
  // hls/stages/plane_sums.hpp:88
  logic [4:0] select_1011;
  assign select_1011 = leaving_values_36_features_mask_q ? ((not_1000 & (sum_1007[6:5] == 2'h0)) ? sum_1007[4:0] : 5'h1f) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1012;
  assign select_1012 = leaving_values_23_features_mask_q ? select_1011 : 5'h0;
  logic [5:0] difference_1013;
  assign difference_1013 = {1'b0, select_1004} - {1'b0, select_1012};
  logic [7:0] sum_1014;
  assign sum_1014 = above_17 + {{2{difference_1013[5]}}, difference_1013};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_18;
  assign above_18 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[143:136] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_1017;
  assign difference_1017 = {entering_values_23_features_left_s1_q[5], entering_values_23_features_left_s1_q} - {entering_values_42_features_right_q[5], entering_values_42_features_right_q};
  logic [5:0] xor_1018;
  assign xor_1018 = difference_1017[5:0] ^ {6{difference_1017[6]}};
  logic [6:0] sum_1019;
  assign sum_1019 = {6'h0, difference_1017[6]} + {1'b0, xor_1018};
  // hls/stages/plane_sums.hpp:157
  logic not_1022;
  assign not_1022 = ~(entering_values_24_row_q ^ entering_values_42_row_q);
  // hls/stages/plane_sums.hpp:87
  logic [4:0] select_1025;
  assign select_1025 = entering_values_42_features_mask_q ? (((sum_1019[6:5] == 2'h0) & not_1022) ? sum_1019[4:0] : 5'h1f) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1026;
  assign select_1026 = entering_values_24_features_mask_q ? select_1025 : 5'h0;
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_1027;
  assign difference_1027 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_41_features_right_q[5], leaving_values_41_features_right_q};
  logic [5:0] xor_1028;
  assign xor_1028 = difference_1027[5:0] ^ {6{difference_1027[6]}};
  logic [6:0] sum_1029;
  assign sum_1029 = {6'h0, difference_1027[6]} + {1'b0, xor_1028};
  // hls/stages/plane_sums.hpp:88
  logic [4:0] select_1033;
  assign select_1033 = leaving_values_41_features_mask_q ? ((not_1022 & (sum_1029[6:5] == 2'h0)) ? sum_1029[4:0] : 5'h1f) : 5'h1f;
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1034;
  assign select_1034 = leaving_values_23_features_mask_q ? select_1033 : 5'h0;
  logic [5:0] difference_1035;
  assign difference_1035 = {1'b0, select_1026} - {1'b0, select_1034};
  logic [7:0] sum_1036;
  assign sum_1036 = above_18 + {{2{difference_1035[5]}}, difference_1035};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_19;
  assign above_19 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[151:144] : 8'h0);
  // hls/stages/plane_sums.hpp:156
  logic [6:0] difference_1049;
  assign difference_1049 = {leaving_values_23_features_left_q[5], leaving_values_23_features_left_q} - {leaving_values_47_features_right_q[5], leaving_values_47_features_right_q};
  logic [5:0] xor_1050;
  assign xor_1050 = difference_1049[5:0] ^ {6{difference_1049[6]}};
  logic [6:0] sum_1051;
  assign sum_1051 = {6'h0, difference_1049[6]} + {1'b0, xor_1050};
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1054;
  assign select_1054 = (not_1044_s1_q & (sum_1051[6:5] == 2'h0)) ? sum_1051[4:0] : 5'h1f;
  logic [4:0] select_1056;
  assign select_1056 = leaving_values_23_features_mask_q ? (leaving_values_47_features_mask_q ? select_1054 : 5'h1f) : 5'h0;
  logic [5:0] difference_1057;
  assign difference_1057 = {1'b0, select_1048_s1_q} - {1'b0, select_1056};
  logic [7:0] sum_1058;
  assign sum_1058 = above_19 + {{2{difference_1057[5]}}, difference_1057};
  // hls/stages/plane_sums.hpp:148
  logic [7:0] above_20;
  assign above_20 = equal_639 ? 8'h0 : (running_q ? column_memory_rdata_q[159:152] : 8'h0);
  // hls/stages/plane_sums.hpp:163
  logic [4:0] xor_1061;
  assign xor_1061 = entering_values_23_features_left_s1_q[4:0] ^ {5{entering_values_23_features_left_s1_q[5]}};
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1063;
  assign select_1063 = entering_values_24_features_mask_q ? ({4'h0, entering_values_23_features_left_s1_q[5]} + xor_1061) : 5'h0;
  // hls/stages/plane_sums.hpp:163
  logic [4:0] xor_1064;
  assign xor_1064 = leaving_values_23_features_left_q[4:0] ^ {5{leaving_values_23_features_left_q[5]}};
  // hls/stages/plane_sums.hpp:149
  logic [4:0] select_1066;
  assign select_1066 = leaving_values_23_features_mask_q ? ({4'h0, leaving_values_23_features_left_q[5]} + xor_1064) : 5'h0;
  logic [5:0] difference_1067;
  assign difference_1067 = {1'b0, select_1063} - {1'b0, select_1066};
  logic [7:0] sum_1068;
  assign sum_1068 = above_20 + {{2{difference_1067[5]}}, difference_1067};
  // hls/stages/plane_sums.hpp:50
  logic and_1069;
  assign and_1069 = column_memory_rdata_q[166] & running_q;
  logic and_1070;
  assign and_1070 = column_memory_rdata_q[173] & running_q;
  logic and_1071;
  assign and_1071 = column_memory_rdata_q[180] & running_q;
  logic and_1072;
  assign and_1072 = column_memory_rdata_q[188] & running_q;
  logic and_1073;
  assign and_1073 = column_memory_rdata_q[189] & running_q;
  // hls/stages/plane_sums.hpp:63
  logic not_1074;
  assign not_1074 = ~equal_659;
  logic [2:0] select_1076;
  assign select_1076 = arriving_row_ended_q ? (select_658 + {2'h0, not_1074}) : select_658;
  // hls/stages/plane_sums.hpp:81
  logic not_1078;
  assign not_1078 = ~(select_638 == 3'h7);
  logic [2:0] select_1080;
  assign select_1080 = delayed_row_ended_q ? (select_638 + {2'h0, not_1078}) : select_638;
  // hls/stages/plane_sums.hpp:150
  logic less_1081;
  assign less_1081 = 10'h8 < delayed_column_q;
  logic [10:0] difference_1083;
  assign difference_1083 = {3'h0, sum_666} - (less_1081 ? rows_0_columns_values_8_q : 11'h0);
  logic [10:0] sum_1085;
  assign sum_1085 = difference_1083 + (or_633_s1_q ? 11'h0 : rows_0_sum_sums_values_0_q);
  logic [10:0] difference_1087;
  assign difference_1087 = {3'h0, sum_688} - (less_1081 ? rows_1_columns_values_8_q : 11'h0);
  logic [10:0] sum_1089;
  assign sum_1089 = difference_1087 + (or_633_s1_q ? 11'h0 : rows_1_sum_sums_values_0_q);
  logic [10:0] difference_1091;
  assign difference_1091 = {3'h0, sum_710} - (less_1081 ? rows_2_columns_values_8_q : 11'h0);
  logic [10:0] sum_1093;
  assign sum_1093 = difference_1091 + (or_633_s1_q ? 11'h0 : rows_2_sum_sums_values_0_q);
  logic [10:0] difference_1095;
  assign difference_1095 = {3'h0, sum_732} - (less_1081 ? rows_3_columns_values_8_q : 11'h0);
  logic [10:0] sum_1097;
  assign sum_1097 = difference_1095 + (or_633_s1_q ? 11'h0 : rows_3_sum_sums_values_0_q);
  logic [10:0] difference_1099;
  assign difference_1099 = {3'h0, sum_754} - (less_1081 ? rows_4_columns_values_8_q : 11'h0);
  logic [10:0] sum_1101;
  assign sum_1101 = difference_1099 + (or_633_s1_q ? 11'h0 : rows_4_sum_sums_values_0_q);
  logic [10:0] difference_1103;
  assign difference_1103 = {3'h0, sum_776} - (less_1081 ? rows_5_columns_values_8_q : 11'h0);
  logic [10:0] sum_1105;
  assign sum_1105 = difference_1103 + (or_633_s1_q ? 11'h0 : rows_5_sum_sums_values_0_q);
  logic [10:0] difference_1107;
  assign difference_1107 = {3'h0, sum_798} - (less_1081 ? rows_6_columns_values_8_q : 11'h0);
  logic [10:0] sum_1109;
  assign sum_1109 = difference_1107 + (or_633_s1_q ? 11'h0 : rows_6_sum_sums_values_0_q);
  logic [10:0] difference_1111;
  assign difference_1111 = {3'h0, sum_820} - (less_1081 ? rows_7_columns_values_8_q : 11'h0);
  logic [10:0] sum_1113;
  assign sum_1113 = difference_1111 + (or_633_s1_q ? 11'h0 : rows_7_sum_sums_values_0_q);
  logic [10:0] difference_1115;
  assign difference_1115 = {3'h0, sum_842} - (less_1081 ? rows_8_columns_values_8_q : 11'h0);
  logic [10:0] sum_1117;
  assign sum_1117 = difference_1115 + (or_633_s1_q ? 11'h0 : rows_8_sum_sums_values_0_q);
  logic [10:0] difference_1119;
  assign difference_1119 = {3'h0, sum_860} - (less_1081 ? rows_9_columns_values_8_q : 11'h0);
  logic [10:0] sum_1121;
  assign sum_1121 = difference_1119 + (or_633_s1_q ? 11'h0 : rows_9_sum_sums_values_0_q);
  logic [10:0] difference_1123;
  assign difference_1123 = {3'h0, sum_882} - (less_1081 ? rows_10_columns_values_8_q : 11'h0);
  logic [10:0] sum_1125;
  assign sum_1125 = difference_1123 + (or_633_s1_q ? 11'h0 : rows_10_sum_sums_values_0_q);
  logic [10:0] difference_1127;
  assign difference_1127 = {3'h0, sum_904} - (less_1081 ? rows_11_columns_values_8_q : 11'h0);
  logic [10:0] sum_1129;
  assign sum_1129 = difference_1127 + (or_633_s1_q ? 11'h0 : rows_11_sum_sums_values_0_q);
  logic [10:0] difference_1131;
  assign difference_1131 = {3'h0, sum_926} - (less_1081 ? rows_12_columns_values_8_q : 11'h0);
  logic [10:0] sum_1133;
  assign sum_1133 = difference_1131 + (or_633_s1_q ? 11'h0 : rows_12_sum_sums_values_0_q);
  logic [10:0] difference_1135;
  assign difference_1135 = {3'h0, sum_948} - (less_1081 ? rows_13_columns_values_8_q : 11'h0);
  logic [10:0] sum_1137;
  assign sum_1137 = difference_1135 + (or_633_s1_q ? 11'h0 : rows_13_sum_sums_values_0_q);
  logic [10:0] difference_1139;
  assign difference_1139 = {3'h0, sum_970} - (less_1081 ? rows_14_columns_values_8_q : 11'h0);
  logic [10:0] sum_1141;
  assign sum_1141 = difference_1139 + (or_633_s1_q ? 11'h0 : rows_14_sum_sums_values_0_q);
  logic [10:0] difference_1143;
  assign difference_1143 = {3'h0, sum_992} - (less_1081 ? rows_15_columns_values_8_q : 11'h0);
  logic [10:0] sum_1145;
  assign sum_1145 = difference_1143 + (or_633_s1_q ? 11'h0 : rows_15_sum_sums_values_0_q);
  logic [10:0] difference_1147;
  assign difference_1147 = {3'h0, sum_1014} - (less_1081 ? rows_16_columns_values_8_q : 11'h0);
  logic [10:0] sum_1149;
  assign sum_1149 = difference_1147 + (or_633_s1_q ? 11'h0 : rows_16_sum_sums_values_0_q);
  logic [10:0] difference_1151;
  assign difference_1151 = {3'h0, sum_1036} - (less_1081 ? rows_17_columns_values_8_q : 11'h0);
  logic [10:0] sum_1153;
  assign sum_1153 = difference_1151 + (or_633_s1_q ? 11'h0 : rows_17_sum_sums_values_0_q);
  logic [10:0] difference_1155;
  assign difference_1155 = {3'h0, sum_1058} - (less_1081 ? rows_18_columns_values_8_q : 11'h0);
  logic [10:0] sum_1157;
  assign sum_1157 = difference_1155 + (or_633_s1_q ? 11'h0 : rows_18_sum_sums_values_0_q);
  logic [10:0] difference_1159;
  assign difference_1159 = {3'h0, sum_1068} - (less_1081 ? rows_19_columns_values_8_q : 11'h0);
  logic [10:0] sum_1161;
  assign sum_1161 = difference_1159 + (or_633_s1_q ? 11'h0 : rows_19_sum_sums_values_0_q);
  // hls/stages/plane_sums.hpp:99
  logic and_1166;
  assign and_1166 = (column_memory_rdata_q[190] & running_q) & (3'h2 < select_638);
  // hls/stages/plane_sums.hpp:110
  logic and_1170;
  assign and_1170 = (centres_values_3_gradient_q & and_1166) & (~(delayed_column_q[9:2] == 8'h0));

  // Memory feature_memory, write
  logic [9:0] feature_memory_waddr;
  assign feature_memory_waddr = arriving_column_q;
  logic feature_memory_we;
  assign feature_memory_we = s1_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (feature_memory_we) feature_memory_mem[feature_memory_waddr] <= {feature_memory_rdata_q[77:0], entering_values_0_features_mask_q, entering_values_0_features_right_q, entering_values_0_features_left_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && feature_memory_we) begin
      if (feature_memory_re && feature_memory_raddr == feature_memory_waddr) begin
        $error("feature_memory: address %0d is read less than DISTANCE steps after its write", feature_memory_waddr);
      end
      if (feature_memory_waddr >= 10'd640) $error("feature_memory: write outside, address %0d", feature_memory_waddr);
    end
    if (rst_ni && feature_memory_re && feature_memory_raddr >= 10'd640) $error("feature_memory: read outside, address %0d", feature_memory_raddr);
  end
`endif

  // Memory column_memory, write
  logic [9:0] column_memory_waddr;
  assign column_memory_waddr = delayed_column_q;
  logic column_memory_we;
  assign column_memory_we = s1_en & running_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (column_memory_we) column_memory_mem[column_memory_waddr] <= {and_1073, and_1072, entering_values_24_features_mask_q, and_1071, column_memory_rdata_q[179:174], and_1070, column_memory_rdata_q[172:167], and_1069, column_memory_rdata_q[165:160], seen_values_24_exists_s1_q, seen_values_24_grey_s1_q, sum_1068, sum_1058, sum_1036, sum_1014, sum_992, sum_970, sum_948, sum_926, sum_904, sum_882, sum_860, sum_842, sum_820, sum_798, sum_776, sum_754, sum_732, sum_710, sum_688, sum_666};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && column_memory_we) begin
      if (column_memory_re && column_memory_raddr == column_memory_waddr) begin
        $error("column_memory: address %0d is read less than DISTANCE steps after its write", column_memory_waddr);
      end
      if (column_memory_waddr >= 10'd640) $error("column_memory: write outside, address %0d", column_memory_waddr);
    end
    if (rst_ni && column_memory_re && column_memory_raddr >= 10'd640) $error("column_memory: read outside, address %0d", column_memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      arriving_rows_q <= 3'h0;
      delayed_rows_q <= 3'h0;
      leaving_values_0_features_left_q <= 6'h0;
      leaving_values_0_features_right_q <= 6'h0;
      leaving_values_0_features_mask_q <= 1'b0;
      leaving_values_1_features_left_q <= 6'h0;
      leaving_values_1_features_right_q <= 6'h0;
      leaving_values_1_features_mask_q <= 1'b0;
      leaving_values_2_features_left_q <= 6'h0;
      leaving_values_2_features_right_q <= 6'h0;
      leaving_values_2_features_mask_q <= 1'b0;
      leaving_values_3_features_left_q <= 6'h0;
      leaving_values_3_features_right_q <= 6'h0;
      leaving_values_3_features_mask_q <= 1'b0;
      leaving_values_4_features_left_q <= 6'h0;
      leaving_values_4_features_right_q <= 6'h0;
      leaving_values_4_features_mask_q <= 1'b0;
      leaving_values_5_features_left_q <= 6'h0;
      leaving_values_5_features_right_q <= 6'h0;
      leaving_values_5_features_mask_q <= 1'b0;
      leaving_values_6_features_left_q <= 6'h0;
      leaving_values_6_features_right_q <= 6'h0;
      leaving_values_6_features_mask_q <= 1'b0;
      leaving_values_7_features_left_q <= 6'h0;
      leaving_values_7_features_right_q <= 6'h0;
      leaving_values_7_features_mask_q <= 1'b0;
      leaving_values_8_features_left_q <= 6'h0;
      leaving_values_8_features_right_q <= 6'h0;
      leaving_values_8_features_mask_q <= 1'b0;
      leaving_values_9_features_left_q <= 6'h0;
      leaving_values_9_features_right_q <= 6'h0;
      leaving_values_9_features_mask_q <= 1'b0;
      leaving_values_10_features_left_q <= 6'h0;
      leaving_values_10_features_right_q <= 6'h0;
      leaving_values_10_features_mask_q <= 1'b0;
      leaving_values_11_features_left_q <= 6'h0;
      leaving_values_11_features_right_q <= 6'h0;
      leaving_values_11_features_mask_q <= 1'b0;
      leaving_values_12_features_left_q <= 6'h0;
      leaving_values_12_features_right_q <= 6'h0;
      leaving_values_12_features_mask_q <= 1'b0;
      leaving_values_13_features_left_q <= 6'h0;
      leaving_values_13_features_right_q <= 6'h0;
      leaving_values_13_features_mask_q <= 1'b0;
      leaving_values_14_features_left_q <= 6'h0;
      leaving_values_14_features_right_q <= 6'h0;
      leaving_values_14_features_mask_q <= 1'b0;
      leaving_values_15_features_left_q <= 6'h0;
      leaving_values_15_features_right_q <= 6'h0;
      leaving_values_15_features_mask_q <= 1'b0;
      leaving_values_16_features_left_q <= 6'h0;
      leaving_values_16_features_right_q <= 6'h0;
      leaving_values_16_features_mask_q <= 1'b0;
      leaving_values_17_features_left_q <= 6'h0;
      leaving_values_17_features_right_q <= 6'h0;
      leaving_values_17_features_mask_q <= 1'b0;
      leaving_values_18_features_left_q <= 6'h0;
      leaving_values_18_features_right_q <= 6'h0;
      leaving_values_18_features_mask_q <= 1'b0;
      leaving_values_19_features_left_q <= 6'h0;
      leaving_values_19_features_right_q <= 6'h0;
      leaving_values_19_features_mask_q <= 1'b0;
      leaving_values_20_features_left_q <= 6'h0;
      leaving_values_20_features_right_q <= 6'h0;
      leaving_values_20_features_mask_q <= 1'b0;
      leaving_values_21_features_left_q <= 6'h0;
      leaving_values_21_features_right_q <= 6'h0;
      leaving_values_21_features_mask_q <= 1'b0;
      leaving_values_22_features_left_q <= 6'h0;
      leaving_values_22_features_right_q <= 6'h0;
      leaving_values_22_features_mask_q <= 1'b0;
      leaving_values_23_features_left_q <= 6'h0;
      leaving_values_23_features_right_q <= 6'h0;
      leaving_values_23_features_mask_q <= 1'b0;
      leaving_values_24_features_right_q <= 6'h0;
      leaving_values_24_features_mask_q <= 1'b0;
      leaving_values_25_features_right_q <= 6'h0;
      leaving_values_25_features_mask_q <= 1'b0;
      leaving_values_26_features_right_q <= 6'h0;
      leaving_values_26_features_mask_q <= 1'b0;
      leaving_values_27_features_right_q <= 6'h0;
      leaving_values_27_features_mask_q <= 1'b0;
      leaving_values_28_features_right_q <= 6'h0;
      leaving_values_28_features_mask_q <= 1'b0;
      leaving_values_29_features_right_q <= 6'h0;
      leaving_values_29_features_mask_q <= 1'b0;
      leaving_values_30_features_right_q <= 6'h0;
      leaving_values_30_features_mask_q <= 1'b0;
      leaving_values_31_features_right_q <= 6'h0;
      leaving_values_31_features_mask_q <= 1'b0;
      leaving_values_32_features_right_q <= 6'h0;
      leaving_values_32_features_mask_q <= 1'b0;
      leaving_values_33_features_right_q <= 6'h0;
      leaving_values_33_features_mask_q <= 1'b0;
      leaving_values_34_features_right_q <= 6'h0;
      leaving_values_34_features_mask_q <= 1'b0;
      leaving_values_35_features_right_q <= 6'h0;
      leaving_values_35_features_mask_q <= 1'b0;
      leaving_values_36_features_right_q <= 6'h0;
      leaving_values_36_features_mask_q <= 1'b0;
      leaving_values_37_features_right_q <= 6'h0;
      leaving_values_37_features_mask_q <= 1'b0;
      leaving_values_38_features_right_q <= 6'h0;
      leaving_values_38_features_mask_q <= 1'b0;
      leaving_values_39_features_right_q <= 6'h0;
      leaving_values_39_features_mask_q <= 1'b0;
      leaving_values_40_features_right_q <= 6'h0;
      leaving_values_40_features_mask_q <= 1'b0;
      leaving_values_41_features_right_q <= 6'h0;
      leaving_values_41_features_mask_q <= 1'b0;
      leaving_values_42_features_right_q <= 6'h0;
      leaving_values_42_features_mask_q <= 1'b0;
      leaving_values_43_features_right_q <= 6'h0;
      leaving_values_43_features_mask_q <= 1'b0;
      leaving_values_44_features_right_q <= 6'h0;
      leaving_values_44_features_mask_q <= 1'b0;
      leaving_values_45_features_right_q <= 6'h0;
      leaving_values_45_features_mask_q <= 1'b0;
      leaving_values_46_features_right_q <= 6'h0;
      leaving_values_46_features_mask_q <= 1'b0;
      leaving_values_47_features_right_q <= 6'h0;
      leaving_values_47_features_mask_q <= 1'b0;
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
    end else if (s1_en) begin
      arriving_rows_q <= select_1076;
      delayed_rows_q <= select_1080;
      leaving_values_0_features_left_q <= feature_memory_rdata_q[83:78];
      leaving_values_0_features_right_q <= feature_memory_rdata_q[89:84];
      leaving_values_0_features_mask_q <= and_660;
      leaving_values_1_features_left_q <= leaving_values_0_features_left_q;
      leaving_values_1_features_right_q <= leaving_values_0_features_right_q;
      leaving_values_1_features_mask_q <= leaving_values_0_features_mask_q;
      leaving_values_2_features_left_q <= leaving_values_1_features_left_q;
      leaving_values_2_features_right_q <= leaving_values_1_features_right_q;
      leaving_values_2_features_mask_q <= leaving_values_1_features_mask_q;
      leaving_values_3_features_left_q <= leaving_values_2_features_left_q;
      leaving_values_3_features_right_q <= leaving_values_2_features_right_q;
      leaving_values_3_features_mask_q <= leaving_values_2_features_mask_q;
      leaving_values_4_features_left_q <= leaving_values_3_features_left_q;
      leaving_values_4_features_right_q <= leaving_values_3_features_right_q;
      leaving_values_4_features_mask_q <= leaving_values_3_features_mask_q;
      leaving_values_5_features_left_q <= leaving_values_4_features_left_q;
      leaving_values_5_features_right_q <= leaving_values_4_features_right_q;
      leaving_values_5_features_mask_q <= leaving_values_4_features_mask_q;
      leaving_values_6_features_left_q <= leaving_values_5_features_left_q;
      leaving_values_6_features_right_q <= leaving_values_5_features_right_q;
      leaving_values_6_features_mask_q <= leaving_values_5_features_mask_q;
      leaving_values_7_features_left_q <= leaving_values_6_features_left_q;
      leaving_values_7_features_right_q <= leaving_values_6_features_right_q;
      leaving_values_7_features_mask_q <= leaving_values_6_features_mask_q;
      leaving_values_8_features_left_q <= leaving_values_7_features_left_q;
      leaving_values_8_features_right_q <= leaving_values_7_features_right_q;
      leaving_values_8_features_mask_q <= leaving_values_7_features_mask_q;
      leaving_values_9_features_left_q <= leaving_values_8_features_left_q;
      leaving_values_9_features_right_q <= leaving_values_8_features_right_q;
      leaving_values_9_features_mask_q <= leaving_values_8_features_mask_q;
      leaving_values_10_features_left_q <= leaving_values_9_features_left_q;
      leaving_values_10_features_right_q <= leaving_values_9_features_right_q;
      leaving_values_10_features_mask_q <= leaving_values_9_features_mask_q;
      leaving_values_11_features_left_q <= leaving_values_10_features_left_q;
      leaving_values_11_features_right_q <= leaving_values_10_features_right_q;
      leaving_values_11_features_mask_q <= leaving_values_10_features_mask_q;
      leaving_values_12_features_left_q <= leaving_values_11_features_left_q;
      leaving_values_12_features_right_q <= leaving_values_11_features_right_q;
      leaving_values_12_features_mask_q <= leaving_values_11_features_mask_q;
      leaving_values_13_features_left_q <= leaving_values_12_features_left_q;
      leaving_values_13_features_right_q <= leaving_values_12_features_right_q;
      leaving_values_13_features_mask_q <= leaving_values_12_features_mask_q;
      leaving_values_14_features_left_q <= leaving_values_13_features_left_q;
      leaving_values_14_features_right_q <= leaving_values_13_features_right_q;
      leaving_values_14_features_mask_q <= leaving_values_13_features_mask_q;
      leaving_values_15_features_left_q <= leaving_values_14_features_left_q;
      leaving_values_15_features_right_q <= leaving_values_14_features_right_q;
      leaving_values_15_features_mask_q <= leaving_values_14_features_mask_q;
      leaving_values_16_features_left_q <= leaving_values_15_features_left_q;
      leaving_values_16_features_right_q <= leaving_values_15_features_right_q;
      leaving_values_16_features_mask_q <= leaving_values_15_features_mask_q;
      leaving_values_17_features_left_q <= leaving_values_16_features_left_q;
      leaving_values_17_features_right_q <= leaving_values_16_features_right_q;
      leaving_values_17_features_mask_q <= leaving_values_16_features_mask_q;
      leaving_values_18_features_left_q <= leaving_values_17_features_left_q;
      leaving_values_18_features_right_q <= leaving_values_17_features_right_q;
      leaving_values_18_features_mask_q <= leaving_values_17_features_mask_q;
      leaving_values_19_features_left_q <= leaving_values_18_features_left_q;
      leaving_values_19_features_right_q <= leaving_values_18_features_right_q;
      leaving_values_19_features_mask_q <= leaving_values_18_features_mask_q;
      leaving_values_20_features_left_q <= leaving_values_19_features_left_q;
      leaving_values_20_features_right_q <= leaving_values_19_features_right_q;
      leaving_values_20_features_mask_q <= leaving_values_19_features_mask_q;
      leaving_values_21_features_left_q <= leaving_values_20_features_left_q;
      leaving_values_21_features_right_q <= leaving_values_20_features_right_q;
      leaving_values_21_features_mask_q <= leaving_values_20_features_mask_q;
      leaving_values_22_features_left_q <= leaving_values_21_features_left_q;
      leaving_values_22_features_right_q <= leaving_values_21_features_right_q;
      leaving_values_22_features_mask_q <= leaving_values_21_features_mask_q;
      leaving_values_23_features_left_q <= leaving_values_22_features_left_q;
      leaving_values_23_features_right_q <= leaving_values_22_features_right_q;
      leaving_values_23_features_mask_q <= leaving_values_22_features_mask_q;
      leaving_values_24_features_right_q <= leaving_values_23_features_right_q;
      leaving_values_24_features_mask_q <= leaving_values_23_features_mask_q;
      leaving_values_25_features_right_q <= leaving_values_24_features_right_q;
      leaving_values_25_features_mask_q <= leaving_values_24_features_mask_q;
      leaving_values_26_features_right_q <= leaving_values_25_features_right_q;
      leaving_values_26_features_mask_q <= leaving_values_25_features_mask_q;
      leaving_values_27_features_right_q <= leaving_values_26_features_right_q;
      leaving_values_27_features_mask_q <= leaving_values_26_features_mask_q;
      leaving_values_28_features_right_q <= leaving_values_27_features_right_q;
      leaving_values_28_features_mask_q <= leaving_values_27_features_mask_q;
      leaving_values_29_features_right_q <= leaving_values_28_features_right_q;
      leaving_values_29_features_mask_q <= leaving_values_28_features_mask_q;
      leaving_values_30_features_right_q <= leaving_values_29_features_right_q;
      leaving_values_30_features_mask_q <= leaving_values_29_features_mask_q;
      leaving_values_31_features_right_q <= leaving_values_30_features_right_q;
      leaving_values_31_features_mask_q <= leaving_values_30_features_mask_q;
      leaving_values_32_features_right_q <= leaving_values_31_features_right_q;
      leaving_values_32_features_mask_q <= leaving_values_31_features_mask_q;
      leaving_values_33_features_right_q <= leaving_values_32_features_right_q;
      leaving_values_33_features_mask_q <= leaving_values_32_features_mask_q;
      leaving_values_34_features_right_q <= leaving_values_33_features_right_q;
      leaving_values_34_features_mask_q <= leaving_values_33_features_mask_q;
      leaving_values_35_features_right_q <= leaving_values_34_features_right_q;
      leaving_values_35_features_mask_q <= leaving_values_34_features_mask_q;
      leaving_values_36_features_right_q <= leaving_values_35_features_right_q;
      leaving_values_36_features_mask_q <= leaving_values_35_features_mask_q;
      leaving_values_37_features_right_q <= leaving_values_36_features_right_q;
      leaving_values_37_features_mask_q <= leaving_values_36_features_mask_q;
      leaving_values_38_features_right_q <= leaving_values_37_features_right_q;
      leaving_values_38_features_mask_q <= leaving_values_37_features_mask_q;
      leaving_values_39_features_right_q <= leaving_values_38_features_right_q;
      leaving_values_39_features_mask_q <= leaving_values_38_features_mask_q;
      leaving_values_40_features_right_q <= leaving_values_39_features_right_q;
      leaving_values_40_features_mask_q <= leaving_values_39_features_mask_q;
      leaving_values_41_features_right_q <= leaving_values_40_features_right_q;
      leaving_values_41_features_mask_q <= leaving_values_40_features_mask_q;
      leaving_values_42_features_right_q <= leaving_values_41_features_right_q;
      leaving_values_42_features_mask_q <= leaving_values_41_features_mask_q;
      leaving_values_43_features_right_q <= leaving_values_42_features_right_q;
      leaving_values_43_features_mask_q <= leaving_values_42_features_mask_q;
      leaving_values_44_features_right_q <= leaving_values_43_features_right_q;
      leaving_values_44_features_mask_q <= leaving_values_43_features_mask_q;
      leaving_values_45_features_right_q <= leaving_values_44_features_right_q;
      leaving_values_45_features_mask_q <= leaving_values_44_features_mask_q;
      leaving_values_46_features_right_q <= leaving_values_45_features_right_q;
      leaving_values_46_features_mask_q <= leaving_values_45_features_mask_q;
      leaving_values_47_features_right_q <= leaving_values_46_features_right_q;
      leaving_values_47_features_mask_q <= leaving_values_46_features_mask_q;
      centres_values_0_seen_grey_q <= running_q ? column_memory_rdata_q[186:181] : 6'h0;
      centres_values_0_seen_exists_q <= column_memory_rdata_q[187] & running_q;
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
      rows_seen_values_0_q <= select_638[2];
      rows_seen_values_1_q <= rows_seen_values_0_q;
      rows_seen_values_2_q <= rows_seen_values_1_q;
      rows_seen_values_3_q <= rows_seen_values_2_q;
    end
  end

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
    rows_0_sum_sums_values_0_q = 11'h0;
    rows_1_columns_values_0_q = 11'h0;
    rows_1_columns_values_1_q = 11'h0;
    rows_1_columns_values_2_q = 11'h0;
    rows_1_columns_values_3_q = 11'h0;
    rows_1_columns_values_4_q = 11'h0;
    rows_1_columns_values_5_q = 11'h0;
    rows_1_columns_values_6_q = 11'h0;
    rows_1_columns_values_7_q = 11'h0;
    rows_1_columns_values_8_q = 11'h0;
    rows_1_sum_sums_values_0_q = 11'h0;
    rows_2_columns_values_0_q = 11'h0;
    rows_2_columns_values_1_q = 11'h0;
    rows_2_columns_values_2_q = 11'h0;
    rows_2_columns_values_3_q = 11'h0;
    rows_2_columns_values_4_q = 11'h0;
    rows_2_columns_values_5_q = 11'h0;
    rows_2_columns_values_6_q = 11'h0;
    rows_2_columns_values_7_q = 11'h0;
    rows_2_columns_values_8_q = 11'h0;
    rows_2_sum_sums_values_0_q = 11'h0;
    rows_3_columns_values_0_q = 11'h0;
    rows_3_columns_values_1_q = 11'h0;
    rows_3_columns_values_2_q = 11'h0;
    rows_3_columns_values_3_q = 11'h0;
    rows_3_columns_values_4_q = 11'h0;
    rows_3_columns_values_5_q = 11'h0;
    rows_3_columns_values_6_q = 11'h0;
    rows_3_columns_values_7_q = 11'h0;
    rows_3_columns_values_8_q = 11'h0;
    rows_3_sum_sums_values_0_q = 11'h0;
    rows_4_columns_values_0_q = 11'h0;
    rows_4_columns_values_1_q = 11'h0;
    rows_4_columns_values_2_q = 11'h0;
    rows_4_columns_values_3_q = 11'h0;
    rows_4_columns_values_4_q = 11'h0;
    rows_4_columns_values_5_q = 11'h0;
    rows_4_columns_values_6_q = 11'h0;
    rows_4_columns_values_7_q = 11'h0;
    rows_4_columns_values_8_q = 11'h0;
    rows_4_sum_sums_values_0_q = 11'h0;
    rows_5_columns_values_0_q = 11'h0;
    rows_5_columns_values_1_q = 11'h0;
    rows_5_columns_values_2_q = 11'h0;
    rows_5_columns_values_3_q = 11'h0;
    rows_5_columns_values_4_q = 11'h0;
    rows_5_columns_values_5_q = 11'h0;
    rows_5_columns_values_6_q = 11'h0;
    rows_5_columns_values_7_q = 11'h0;
    rows_5_columns_values_8_q = 11'h0;
    rows_5_sum_sums_values_0_q = 11'h0;
    rows_6_columns_values_0_q = 11'h0;
    rows_6_columns_values_1_q = 11'h0;
    rows_6_columns_values_2_q = 11'h0;
    rows_6_columns_values_3_q = 11'h0;
    rows_6_columns_values_4_q = 11'h0;
    rows_6_columns_values_5_q = 11'h0;
    rows_6_columns_values_6_q = 11'h0;
    rows_6_columns_values_7_q = 11'h0;
    rows_6_columns_values_8_q = 11'h0;
    rows_6_sum_sums_values_0_q = 11'h0;
    rows_7_columns_values_0_q = 11'h0;
    rows_7_columns_values_1_q = 11'h0;
    rows_7_columns_values_2_q = 11'h0;
    rows_7_columns_values_3_q = 11'h0;
    rows_7_columns_values_4_q = 11'h0;
    rows_7_columns_values_5_q = 11'h0;
    rows_7_columns_values_6_q = 11'h0;
    rows_7_columns_values_7_q = 11'h0;
    rows_7_columns_values_8_q = 11'h0;
    rows_7_sum_sums_values_0_q = 11'h0;
    rows_8_columns_values_0_q = 11'h0;
    rows_8_columns_values_1_q = 11'h0;
    rows_8_columns_values_2_q = 11'h0;
    rows_8_columns_values_3_q = 11'h0;
    rows_8_columns_values_4_q = 11'h0;
    rows_8_columns_values_5_q = 11'h0;
    rows_8_columns_values_6_q = 11'h0;
    rows_8_columns_values_7_q = 11'h0;
    rows_8_columns_values_8_q = 11'h0;
    rows_8_sum_sums_values_0_q = 11'h0;
    rows_9_columns_values_0_q = 11'h0;
    rows_9_columns_values_1_q = 11'h0;
    rows_9_columns_values_2_q = 11'h0;
    rows_9_columns_values_3_q = 11'h0;
    rows_9_columns_values_4_q = 11'h0;
    rows_9_columns_values_5_q = 11'h0;
    rows_9_columns_values_6_q = 11'h0;
    rows_9_columns_values_7_q = 11'h0;
    rows_9_columns_values_8_q = 11'h0;
    rows_9_sum_sums_values_0_q = 11'h0;
    rows_10_columns_values_0_q = 11'h0;
    rows_10_columns_values_1_q = 11'h0;
    rows_10_columns_values_2_q = 11'h0;
    rows_10_columns_values_3_q = 11'h0;
    rows_10_columns_values_4_q = 11'h0;
    rows_10_columns_values_5_q = 11'h0;
    rows_10_columns_values_6_q = 11'h0;
    rows_10_columns_values_7_q = 11'h0;
    rows_10_columns_values_8_q = 11'h0;
    rows_10_sum_sums_values_0_q = 11'h0;
    rows_11_columns_values_0_q = 11'h0;
    rows_11_columns_values_1_q = 11'h0;
    rows_11_columns_values_2_q = 11'h0;
    rows_11_columns_values_3_q = 11'h0;
    rows_11_columns_values_4_q = 11'h0;
    rows_11_columns_values_5_q = 11'h0;
    rows_11_columns_values_6_q = 11'h0;
    rows_11_columns_values_7_q = 11'h0;
    rows_11_columns_values_8_q = 11'h0;
    rows_11_sum_sums_values_0_q = 11'h0;
    rows_12_columns_values_0_q = 11'h0;
    rows_12_columns_values_1_q = 11'h0;
    rows_12_columns_values_2_q = 11'h0;
    rows_12_columns_values_3_q = 11'h0;
    rows_12_columns_values_4_q = 11'h0;
    rows_12_columns_values_5_q = 11'h0;
    rows_12_columns_values_6_q = 11'h0;
    rows_12_columns_values_7_q = 11'h0;
    rows_12_columns_values_8_q = 11'h0;
    rows_12_sum_sums_values_0_q = 11'h0;
    rows_13_columns_values_0_q = 11'h0;
    rows_13_columns_values_1_q = 11'h0;
    rows_13_columns_values_2_q = 11'h0;
    rows_13_columns_values_3_q = 11'h0;
    rows_13_columns_values_4_q = 11'h0;
    rows_13_columns_values_5_q = 11'h0;
    rows_13_columns_values_6_q = 11'h0;
    rows_13_columns_values_7_q = 11'h0;
    rows_13_columns_values_8_q = 11'h0;
    rows_13_sum_sums_values_0_q = 11'h0;
    rows_14_columns_values_0_q = 11'h0;
    rows_14_columns_values_1_q = 11'h0;
    rows_14_columns_values_2_q = 11'h0;
    rows_14_columns_values_3_q = 11'h0;
    rows_14_columns_values_4_q = 11'h0;
    rows_14_columns_values_5_q = 11'h0;
    rows_14_columns_values_6_q = 11'h0;
    rows_14_columns_values_7_q = 11'h0;
    rows_14_columns_values_8_q = 11'h0;
    rows_14_sum_sums_values_0_q = 11'h0;
    rows_15_columns_values_0_q = 11'h0;
    rows_15_columns_values_1_q = 11'h0;
    rows_15_columns_values_2_q = 11'h0;
    rows_15_columns_values_3_q = 11'h0;
    rows_15_columns_values_4_q = 11'h0;
    rows_15_columns_values_5_q = 11'h0;
    rows_15_columns_values_6_q = 11'h0;
    rows_15_columns_values_7_q = 11'h0;
    rows_15_columns_values_8_q = 11'h0;
    rows_15_sum_sums_values_0_q = 11'h0;
    rows_16_columns_values_0_q = 11'h0;
    rows_16_columns_values_1_q = 11'h0;
    rows_16_columns_values_2_q = 11'h0;
    rows_16_columns_values_3_q = 11'h0;
    rows_16_columns_values_4_q = 11'h0;
    rows_16_columns_values_5_q = 11'h0;
    rows_16_columns_values_6_q = 11'h0;
    rows_16_columns_values_7_q = 11'h0;
    rows_16_columns_values_8_q = 11'h0;
    rows_16_sum_sums_values_0_q = 11'h0;
    rows_17_columns_values_0_q = 11'h0;
    rows_17_columns_values_1_q = 11'h0;
    rows_17_columns_values_2_q = 11'h0;
    rows_17_columns_values_3_q = 11'h0;
    rows_17_columns_values_4_q = 11'h0;
    rows_17_columns_values_5_q = 11'h0;
    rows_17_columns_values_6_q = 11'h0;
    rows_17_columns_values_7_q = 11'h0;
    rows_17_columns_values_8_q = 11'h0;
    rows_17_sum_sums_values_0_q = 11'h0;
    rows_18_columns_values_0_q = 11'h0;
    rows_18_columns_values_1_q = 11'h0;
    rows_18_columns_values_2_q = 11'h0;
    rows_18_columns_values_3_q = 11'h0;
    rows_18_columns_values_4_q = 11'h0;
    rows_18_columns_values_5_q = 11'h0;
    rows_18_columns_values_6_q = 11'h0;
    rows_18_columns_values_7_q = 11'h0;
    rows_18_columns_values_8_q = 11'h0;
    rows_18_sum_sums_values_0_q = 11'h0;
    rows_19_columns_values_0_q = 11'h0;
    rows_19_columns_values_1_q = 11'h0;
    rows_19_columns_values_2_q = 11'h0;
    rows_19_columns_values_3_q = 11'h0;
    rows_19_columns_values_4_q = 11'h0;
    rows_19_columns_values_5_q = 11'h0;
    rows_19_columns_values_6_q = 11'h0;
    rows_19_columns_values_7_q = 11'h0;
    rows_19_columns_values_8_q = 11'h0;
    rows_19_sum_sums_values_0_q = 11'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      rows_0_columns_values_0_q <= {3'h0, sum_666};
      rows_0_columns_values_1_q <= rows_0_columns_values_0_q;
      rows_0_columns_values_2_q <= rows_0_columns_values_1_q;
      rows_0_columns_values_3_q <= rows_0_columns_values_2_q;
      rows_0_columns_values_4_q <= rows_0_columns_values_3_q;
      rows_0_columns_values_5_q <= rows_0_columns_values_4_q;
      rows_0_columns_values_6_q <= rows_0_columns_values_5_q;
      rows_0_columns_values_7_q <= rows_0_columns_values_6_q;
      rows_0_columns_values_8_q <= rows_0_columns_values_7_q;
      rows_0_sum_sums_values_0_q <= sum_1085;
      rows_1_columns_values_0_q <= {3'h0, sum_688};
      rows_1_columns_values_1_q <= rows_1_columns_values_0_q;
      rows_1_columns_values_2_q <= rows_1_columns_values_1_q;
      rows_1_columns_values_3_q <= rows_1_columns_values_2_q;
      rows_1_columns_values_4_q <= rows_1_columns_values_3_q;
      rows_1_columns_values_5_q <= rows_1_columns_values_4_q;
      rows_1_columns_values_6_q <= rows_1_columns_values_5_q;
      rows_1_columns_values_7_q <= rows_1_columns_values_6_q;
      rows_1_columns_values_8_q <= rows_1_columns_values_7_q;
      rows_1_sum_sums_values_0_q <= sum_1089;
      rows_2_columns_values_0_q <= {3'h0, sum_710};
      rows_2_columns_values_1_q <= rows_2_columns_values_0_q;
      rows_2_columns_values_2_q <= rows_2_columns_values_1_q;
      rows_2_columns_values_3_q <= rows_2_columns_values_2_q;
      rows_2_columns_values_4_q <= rows_2_columns_values_3_q;
      rows_2_columns_values_5_q <= rows_2_columns_values_4_q;
      rows_2_columns_values_6_q <= rows_2_columns_values_5_q;
      rows_2_columns_values_7_q <= rows_2_columns_values_6_q;
      rows_2_columns_values_8_q <= rows_2_columns_values_7_q;
      rows_2_sum_sums_values_0_q <= sum_1093;
      rows_3_columns_values_0_q <= {3'h0, sum_732};
      rows_3_columns_values_1_q <= rows_3_columns_values_0_q;
      rows_3_columns_values_2_q <= rows_3_columns_values_1_q;
      rows_3_columns_values_3_q <= rows_3_columns_values_2_q;
      rows_3_columns_values_4_q <= rows_3_columns_values_3_q;
      rows_3_columns_values_5_q <= rows_3_columns_values_4_q;
      rows_3_columns_values_6_q <= rows_3_columns_values_5_q;
      rows_3_columns_values_7_q <= rows_3_columns_values_6_q;
      rows_3_columns_values_8_q <= rows_3_columns_values_7_q;
      rows_3_sum_sums_values_0_q <= sum_1097;
      rows_4_columns_values_0_q <= {3'h0, sum_754};
      rows_4_columns_values_1_q <= rows_4_columns_values_0_q;
      rows_4_columns_values_2_q <= rows_4_columns_values_1_q;
      rows_4_columns_values_3_q <= rows_4_columns_values_2_q;
      rows_4_columns_values_4_q <= rows_4_columns_values_3_q;
      rows_4_columns_values_5_q <= rows_4_columns_values_4_q;
      rows_4_columns_values_6_q <= rows_4_columns_values_5_q;
      rows_4_columns_values_7_q <= rows_4_columns_values_6_q;
      rows_4_columns_values_8_q <= rows_4_columns_values_7_q;
      rows_4_sum_sums_values_0_q <= sum_1101;
      rows_5_columns_values_0_q <= {3'h0, sum_776};
      rows_5_columns_values_1_q <= rows_5_columns_values_0_q;
      rows_5_columns_values_2_q <= rows_5_columns_values_1_q;
      rows_5_columns_values_3_q <= rows_5_columns_values_2_q;
      rows_5_columns_values_4_q <= rows_5_columns_values_3_q;
      rows_5_columns_values_5_q <= rows_5_columns_values_4_q;
      rows_5_columns_values_6_q <= rows_5_columns_values_5_q;
      rows_5_columns_values_7_q <= rows_5_columns_values_6_q;
      rows_5_columns_values_8_q <= rows_5_columns_values_7_q;
      rows_5_sum_sums_values_0_q <= sum_1105;
      rows_6_columns_values_0_q <= {3'h0, sum_798};
      rows_6_columns_values_1_q <= rows_6_columns_values_0_q;
      rows_6_columns_values_2_q <= rows_6_columns_values_1_q;
      rows_6_columns_values_3_q <= rows_6_columns_values_2_q;
      rows_6_columns_values_4_q <= rows_6_columns_values_3_q;
      rows_6_columns_values_5_q <= rows_6_columns_values_4_q;
      rows_6_columns_values_6_q <= rows_6_columns_values_5_q;
      rows_6_columns_values_7_q <= rows_6_columns_values_6_q;
      rows_6_columns_values_8_q <= rows_6_columns_values_7_q;
      rows_6_sum_sums_values_0_q <= sum_1109;
      rows_7_columns_values_0_q <= {3'h0, sum_820};
      rows_7_columns_values_1_q <= rows_7_columns_values_0_q;
      rows_7_columns_values_2_q <= rows_7_columns_values_1_q;
      rows_7_columns_values_3_q <= rows_7_columns_values_2_q;
      rows_7_columns_values_4_q <= rows_7_columns_values_3_q;
      rows_7_columns_values_5_q <= rows_7_columns_values_4_q;
      rows_7_columns_values_6_q <= rows_7_columns_values_5_q;
      rows_7_columns_values_7_q <= rows_7_columns_values_6_q;
      rows_7_columns_values_8_q <= rows_7_columns_values_7_q;
      rows_7_sum_sums_values_0_q <= sum_1113;
      rows_8_columns_values_0_q <= {3'h0, sum_842};
      rows_8_columns_values_1_q <= rows_8_columns_values_0_q;
      rows_8_columns_values_2_q <= rows_8_columns_values_1_q;
      rows_8_columns_values_3_q <= rows_8_columns_values_2_q;
      rows_8_columns_values_4_q <= rows_8_columns_values_3_q;
      rows_8_columns_values_5_q <= rows_8_columns_values_4_q;
      rows_8_columns_values_6_q <= rows_8_columns_values_5_q;
      rows_8_columns_values_7_q <= rows_8_columns_values_6_q;
      rows_8_columns_values_8_q <= rows_8_columns_values_7_q;
      rows_8_sum_sums_values_0_q <= sum_1117;
      rows_9_columns_values_0_q <= {3'h0, sum_860};
      rows_9_columns_values_1_q <= rows_9_columns_values_0_q;
      rows_9_columns_values_2_q <= rows_9_columns_values_1_q;
      rows_9_columns_values_3_q <= rows_9_columns_values_2_q;
      rows_9_columns_values_4_q <= rows_9_columns_values_3_q;
      rows_9_columns_values_5_q <= rows_9_columns_values_4_q;
      rows_9_columns_values_6_q <= rows_9_columns_values_5_q;
      rows_9_columns_values_7_q <= rows_9_columns_values_6_q;
      rows_9_columns_values_8_q <= rows_9_columns_values_7_q;
      rows_9_sum_sums_values_0_q <= sum_1121;
      rows_10_columns_values_0_q <= {3'h0, sum_882};
      rows_10_columns_values_1_q <= rows_10_columns_values_0_q;
      rows_10_columns_values_2_q <= rows_10_columns_values_1_q;
      rows_10_columns_values_3_q <= rows_10_columns_values_2_q;
      rows_10_columns_values_4_q <= rows_10_columns_values_3_q;
      rows_10_columns_values_5_q <= rows_10_columns_values_4_q;
      rows_10_columns_values_6_q <= rows_10_columns_values_5_q;
      rows_10_columns_values_7_q <= rows_10_columns_values_6_q;
      rows_10_columns_values_8_q <= rows_10_columns_values_7_q;
      rows_10_sum_sums_values_0_q <= sum_1125;
      rows_11_columns_values_0_q <= {3'h0, sum_904};
      rows_11_columns_values_1_q <= rows_11_columns_values_0_q;
      rows_11_columns_values_2_q <= rows_11_columns_values_1_q;
      rows_11_columns_values_3_q <= rows_11_columns_values_2_q;
      rows_11_columns_values_4_q <= rows_11_columns_values_3_q;
      rows_11_columns_values_5_q <= rows_11_columns_values_4_q;
      rows_11_columns_values_6_q <= rows_11_columns_values_5_q;
      rows_11_columns_values_7_q <= rows_11_columns_values_6_q;
      rows_11_columns_values_8_q <= rows_11_columns_values_7_q;
      rows_11_sum_sums_values_0_q <= sum_1129;
      rows_12_columns_values_0_q <= {3'h0, sum_926};
      rows_12_columns_values_1_q <= rows_12_columns_values_0_q;
      rows_12_columns_values_2_q <= rows_12_columns_values_1_q;
      rows_12_columns_values_3_q <= rows_12_columns_values_2_q;
      rows_12_columns_values_4_q <= rows_12_columns_values_3_q;
      rows_12_columns_values_5_q <= rows_12_columns_values_4_q;
      rows_12_columns_values_6_q <= rows_12_columns_values_5_q;
      rows_12_columns_values_7_q <= rows_12_columns_values_6_q;
      rows_12_columns_values_8_q <= rows_12_columns_values_7_q;
      rows_12_sum_sums_values_0_q <= sum_1133;
      rows_13_columns_values_0_q <= {3'h0, sum_948};
      rows_13_columns_values_1_q <= rows_13_columns_values_0_q;
      rows_13_columns_values_2_q <= rows_13_columns_values_1_q;
      rows_13_columns_values_3_q <= rows_13_columns_values_2_q;
      rows_13_columns_values_4_q <= rows_13_columns_values_3_q;
      rows_13_columns_values_5_q <= rows_13_columns_values_4_q;
      rows_13_columns_values_6_q <= rows_13_columns_values_5_q;
      rows_13_columns_values_7_q <= rows_13_columns_values_6_q;
      rows_13_columns_values_8_q <= rows_13_columns_values_7_q;
      rows_13_sum_sums_values_0_q <= sum_1137;
      rows_14_columns_values_0_q <= {3'h0, sum_970};
      rows_14_columns_values_1_q <= rows_14_columns_values_0_q;
      rows_14_columns_values_2_q <= rows_14_columns_values_1_q;
      rows_14_columns_values_3_q <= rows_14_columns_values_2_q;
      rows_14_columns_values_4_q <= rows_14_columns_values_3_q;
      rows_14_columns_values_5_q <= rows_14_columns_values_4_q;
      rows_14_columns_values_6_q <= rows_14_columns_values_5_q;
      rows_14_columns_values_7_q <= rows_14_columns_values_6_q;
      rows_14_columns_values_8_q <= rows_14_columns_values_7_q;
      rows_14_sum_sums_values_0_q <= sum_1141;
      rows_15_columns_values_0_q <= {3'h0, sum_992};
      rows_15_columns_values_1_q <= rows_15_columns_values_0_q;
      rows_15_columns_values_2_q <= rows_15_columns_values_1_q;
      rows_15_columns_values_3_q <= rows_15_columns_values_2_q;
      rows_15_columns_values_4_q <= rows_15_columns_values_3_q;
      rows_15_columns_values_5_q <= rows_15_columns_values_4_q;
      rows_15_columns_values_6_q <= rows_15_columns_values_5_q;
      rows_15_columns_values_7_q <= rows_15_columns_values_6_q;
      rows_15_columns_values_8_q <= rows_15_columns_values_7_q;
      rows_15_sum_sums_values_0_q <= sum_1145;
      rows_16_columns_values_0_q <= {3'h0, sum_1014};
      rows_16_columns_values_1_q <= rows_16_columns_values_0_q;
      rows_16_columns_values_2_q <= rows_16_columns_values_1_q;
      rows_16_columns_values_3_q <= rows_16_columns_values_2_q;
      rows_16_columns_values_4_q <= rows_16_columns_values_3_q;
      rows_16_columns_values_5_q <= rows_16_columns_values_4_q;
      rows_16_columns_values_6_q <= rows_16_columns_values_5_q;
      rows_16_columns_values_7_q <= rows_16_columns_values_6_q;
      rows_16_columns_values_8_q <= rows_16_columns_values_7_q;
      rows_16_sum_sums_values_0_q <= sum_1149;
      rows_17_columns_values_0_q <= {3'h0, sum_1036};
      rows_17_columns_values_1_q <= rows_17_columns_values_0_q;
      rows_17_columns_values_2_q <= rows_17_columns_values_1_q;
      rows_17_columns_values_3_q <= rows_17_columns_values_2_q;
      rows_17_columns_values_4_q <= rows_17_columns_values_3_q;
      rows_17_columns_values_5_q <= rows_17_columns_values_4_q;
      rows_17_columns_values_6_q <= rows_17_columns_values_5_q;
      rows_17_columns_values_7_q <= rows_17_columns_values_6_q;
      rows_17_columns_values_8_q <= rows_17_columns_values_7_q;
      rows_17_sum_sums_values_0_q <= sum_1153;
      rows_18_columns_values_0_q <= {3'h0, sum_1058};
      rows_18_columns_values_1_q <= rows_18_columns_values_0_q;
      rows_18_columns_values_2_q <= rows_18_columns_values_1_q;
      rows_18_columns_values_3_q <= rows_18_columns_values_2_q;
      rows_18_columns_values_4_q <= rows_18_columns_values_3_q;
      rows_18_columns_values_5_q <= rows_18_columns_values_4_q;
      rows_18_columns_values_6_q <= rows_18_columns_values_5_q;
      rows_18_columns_values_7_q <= rows_18_columns_values_6_q;
      rows_18_columns_values_8_q <= rows_18_columns_values_7_q;
      rows_18_sum_sums_values_0_q <= sum_1157;
      rows_19_columns_values_0_q <= {3'h0, sum_1068};
      rows_19_columns_values_1_q <= rows_19_columns_values_0_q;
      rows_19_columns_values_2_q <= rows_19_columns_values_1_q;
      rows_19_columns_values_3_q <= rows_19_columns_values_2_q;
      rows_19_columns_values_4_q <= rows_19_columns_values_3_q;
      rows_19_columns_values_5_q <= rows_19_columns_values_4_q;
      rows_19_columns_values_6_q <= rows_19_columns_values_5_q;
      rows_19_columns_values_7_q <= rows_19_columns_values_6_q;
      rows_19_columns_values_8_q <= rows_19_columns_values_7_q;
      rows_19_sum_sums_values_0_q <= sum_1161;
    end
  end

  logic [5:0] centres_values_3_seen_grey_s2_q;
  logic centre_marks_values_3_first_s2_q;
  logic centre_marks_values_3_last_s2_q;
  logic and_1170_s2_q;
  logic and_1171_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      centres_values_3_seen_grey_s2_q <= centres_values_3_seen_grey_q;
      centre_marks_values_3_first_s2_q <= centre_marks_values_3_first_s1_q;
      centre_marks_values_3_last_s2_q <= centre_marks_values_3_last_s1_q;
      and_1170_s2_q <= and_1170;
      and_1171_s2_q <= centres_values_3_seen_exists_q & rows_seen_values_3_q;
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
  assign grey_o = centres_values_3_seen_grey_s2_q;
  assign known_o = and_1170_s2_q;
  assign exists_o = and_1171_s2_q;
  assign marks_first_o = centre_marks_values_3_first_s2_q;
  assign marks_last_o = centre_marks_values_3_last_s2_q;
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
  assign unused_bits = ^grey_i[1:0];

endmodule
