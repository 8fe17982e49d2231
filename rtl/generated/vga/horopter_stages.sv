// SPDX-License-Identifier: Apache-2.0
// Made by scripts/generate-profiles from hls/stages/stage_list.def: change that, not this.
// The stages of the profile `vga` from the 2x2 source pixels to states, runs and counts. Ports: their modules.
// THESIS, COMPETE: the rules that are built, of those that the profile has.
module horopter_stages #(
  parameter bit THESIS = horopter_profile_pkg::THESIS,
  parameter bit COMPETE = horopter_profile_pkg::COMPETE
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic valid_i,
  input  logic [7:0] p00_i,
  input  logic [7:0] p01_i,
  input  logic [7:0] p10_i,
  input  logic [7:0] p11_i,
  input  logic [2:0] wx_i,
  input  logic [2:0] wy_i,
  input  logic swapped_x_i,
  input  logic swapped_y_i,
  input  logic [7:0] left_i,
  input  logic mask_i,
  input  logic present_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [9:0] cfg_width_i,
  input  logic [8:0] cfg_height_i,
  input  logic cfg_compete_i,
  input  logic cfg_prove_i,
  input  logic signed [5:0] cfg_shift_lowest_i,
  input  logic signed [5:0] cfg_shift_highest_i,
  input  logic cfg_nearer_below_i,
  input  logic cfg_nearer_above_i,
  input  logic [7:0] cfg_explained_limit_i,
  input  logic [7:0] cfg_regions_limit_i,
  input  logic [7:0] cfg_unproven_limit_i,
  input  logic [7:0] cfg_unproven_skin_limit_i,
  input  logic [7:0] cfg_hidden_limit_i,
  input  logic [7:0] cfg_hidden_frames_i,
  input  logic [5:0] cfg_moved_limit_i,
  input  logic [5:0] cfg_moved_half_limit_i,
  input  logic [5:0] cfg_patch_limit_i,
  input  logic [4:0] cfg_on_skin_limit_i,
  input  logic [7:0] cfg_on_skin_cells_i,
  input  logic cfg_alarm_before_i,
  input  logic cfg_same_table_i,
  input  logic signed [15:0] cfg_epipolar_slope_i,
  input  logic signed [15:0] cfg_epipolar_column_i,
  input  logic signed [15:0] cfg_epipolar_row_i,
  input  logic signed [15:0] cfg_epipolar_both_i,
  input  logic cfg_dim_i,
  input  logic [11:0] cfg_texture_limit_i,
  input  logic [10:0] cfg_sum_limit_i,
  input  logic [10:0] cfg_self_limit_i,
  input  logic [18:0] cfg_alarm_limit_i,
  input  logic [18:0] cfg_undecidable_limit_i,
  input  logic [18:0] cfg_unsupervised_limit_i,
  input  logic [30:0] compete_settings_i,
  output logic parity_error_o,
  output logic agreement_verdict_valid_o,
  output logic agreement_verdict_unproven_yet_o,
  output logic agreement_verdict_untextured_o,
  output logic agreement_verdict_disagree_o,
  output logic agreement_verdict_moved_o,
  output logic agreement_verdict_unsharp_left_o,
  output logic agreement_verdict_unsharp_right_o,
  output logic agreement_verdict_hidden_o,
  output logic agreement_verdict_overlooked_o,
  output logic agreement_verdict_out_of_step_o,
  output logic agreement_frame_valid_o,
  output logic [5:0] agreement_frame_index_o,
  output logic [31:0] agreement_frame_word_o,
  output logic align_valid_o,
  output logic [1:0] align_state_o,
  output logic align_first_o,
  output logic align_last_o,
  output logic align_end_v_o,
  output logic align_idle_o,
  output logic align_hidden_o,
  output logic align_unproven_o,
  output logic runs_valid_o,
  output logic [8:0] runs_row_o,
  output logic [9:0] runs_start_o,
  output logic [9:0] runs_end_v_o,
  output logic [1:0] runs_state_o,
  output logic runs_last_o,
  output logic alarm_valid_o,
  output logic [18:0] alarm_skin_pixels_o,
  output logic [18:0] alarm_unsupervised_pixels_o,
  output logic alarm_alarm_o,
  output logic alarm_too_undecidable_o,
  output logic alarm_too_unsupervised_o
);
  if (!THESIS && !COMPETE) begin : g_illegal
    $fatal(1, "horopter_stages: neither THESIS nor COMPETE");
  end

  logic interpolate_valid_o;
  logic [7:0] interpolate_pixel_0_o;
  logic [7:0] interpolate_pixel_1_o;
  logic interpolate_saturated_o;
  logic interpolate_mask_o;
  logic interpolate_present_o;
  logic interpolate_marks_first_o;
  logic interpolate_marks_last_o;
  horopter_interpolate u_interpolate (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(valid_i),
    .p00_i(p00_i),
    .p01_i(p01_i),
    .p10_i(p10_i),
    .p11_i(p11_i),
    .wx_i(wx_i),
    .wy_i(wy_i),
    .swapped_x_i(swapped_x_i),
    .swapped_y_i(swapped_y_i),
    .left_i(left_i),
    .mask_i(mask_i),
    .present_i(present_i),
    .marks_first_i(marks_first_i),
    .marks_last_i(marks_last_i),
    .valid_o(interpolate_valid_o),
    .pixel_0_o(interpolate_pixel_0_o),
    .pixel_1_o(interpolate_pixel_1_o),
    .saturated_o(interpolate_saturated_o),
    .mask_o(interpolate_mask_o),
    .present_o(interpolate_present_o),
    .marks_first_o(interpolate_marks_first_o),
    .marks_last_o(interpolate_marks_last_o)
  );

  logic subsample_valid_o;
  logic [7:0] subsample_pixel_0_o;
  logic [7:0] subsample_pixel_1_o;
  logic subsample_saturated_o;
  logic subsample_mask_o;
  logic subsample_present_o;
  logic subsample_marks_first_o;
  logic subsample_marks_last_o;
  horopter_subsample u_subsample (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(interpolate_valid_o),
    .pixel_0_i(interpolate_pixel_0_o),
    .pixel_1_i(interpolate_pixel_1_o),
    .saturated_i(interpolate_saturated_o),
    .mask_i(interpolate_mask_o),
    .present_i(interpolate_present_o),
    .marks_first_i(interpolate_marks_first_o),
    .marks_last_i(interpolate_marks_last_o),
    .valid_o(subsample_valid_o),
    .pixel_0_o(subsample_pixel_0_o),
    .pixel_1_o(subsample_pixel_1_o),
    .saturated_o(subsample_saturated_o),
    .mask_o(subsample_mask_o),
    .present_o(subsample_present_o),
    .marks_first_o(subsample_marks_first_o),
    .marks_last_o(subsample_marks_last_o)
  );

  logic agreement_parity_error_o;
  logic agreement_valid_o;
  logic [7:0] agreement_pixel_0_o;
  logic [7:0] agreement_pixel_1_o;
  logic agreement_saturated_o;
  logic agreement_mask_o;
  logic agreement_marks_first_o;
  logic agreement_marks_last_o;
  logic agreement_marks_seen_o;
  logic agreement_marks_nearer_o;
  logic agreement_verdict_valid;
  assign agreement_verdict_valid_o = agreement_valid_o && agreement_verdict_valid;
  logic agreement_frame_valid;
  assign agreement_frame_valid_o = agreement_valid_o && agreement_frame_valid;
  horopter_agreement u_agreement (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(subsample_valid_o),
    .pixel_0_i(subsample_pixel_0_o),
    .pixel_1_i(subsample_pixel_1_o),
    .saturated_i(subsample_saturated_o),
    .mask_i(subsample_mask_o),
    .present_i(subsample_present_o),
    .marks_first_i(subsample_marks_first_o),
    .marks_last_i(subsample_marks_last_o),
    .cfg_width_i(cfg_width_i),
    .cfg_height_i(cfg_height_i),
    .cfg_compete_i(cfg_compete_i),
    .cfg_prove_i(cfg_prove_i),
    .cfg_shift_lowest_i(cfg_shift_lowest_i),
    .cfg_shift_highest_i(cfg_shift_highest_i),
    .cfg_nearer_below_i(cfg_nearer_below_i),
    .cfg_nearer_above_i(cfg_nearer_above_i),
    .cfg_explained_limit_i(cfg_explained_limit_i),
    .cfg_regions_limit_i(cfg_regions_limit_i),
    .cfg_unproven_limit_i(cfg_unproven_limit_i),
    .cfg_unproven_skin_limit_i(cfg_unproven_skin_limit_i),
    .cfg_hidden_limit_i(cfg_hidden_limit_i),
    .cfg_hidden_frames_i(cfg_hidden_frames_i),
    .cfg_moved_limit_i(cfg_moved_limit_i),
    .cfg_moved_half_limit_i(cfg_moved_half_limit_i),
    .cfg_patch_limit_i(cfg_patch_limit_i),
    .cfg_on_skin_limit_i(cfg_on_skin_limit_i),
    .cfg_on_skin_cells_i(cfg_on_skin_cells_i),
    .cfg_alarm_before_i(cfg_alarm_before_i),
    .cfg_same_table_i(cfg_same_table_i),
    .cfg_epipolar_slope_i(cfg_epipolar_slope_i),
    .cfg_epipolar_column_i(cfg_epipolar_column_i),
    .cfg_epipolar_row_i(cfg_epipolar_row_i),
    .cfg_epipolar_both_i(cfg_epipolar_both_i),
    .parity_error_o(agreement_parity_error_o),
    .valid_o(agreement_valid_o),
    .pixel_0_o(agreement_pixel_0_o),
    .pixel_1_o(agreement_pixel_1_o),
    .saturated_o(agreement_saturated_o),
    .mask_o(agreement_mask_o),
    .marks_first_o(agreement_marks_first_o),
    .marks_last_o(agreement_marks_last_o),
    .marks_seen_o(agreement_marks_seen_o),
    .marks_nearer_o(agreement_marks_nearer_o),
    .verdict_valid_o(agreement_verdict_valid),
    .verdict_unproven_yet_o(agreement_verdict_unproven_yet_o),
    .verdict_untextured_o(agreement_verdict_untextured_o),
    .verdict_disagree_o(agreement_verdict_disagree_o),
    .verdict_moved_o(agreement_verdict_moved_o),
    .verdict_unsharp_left_o(agreement_verdict_unsharp_left_o),
    .verdict_unsharp_right_o(agreement_verdict_unsharp_right_o),
    .verdict_hidden_o(agreement_verdict_hidden_o),
    .verdict_overlooked_o(agreement_verdict_overlooked_o),
    .verdict_out_of_step_o(agreement_verdict_out_of_step_o),
    .frame_valid_o(agreement_frame_valid),
    .frame_index_o(agreement_frame_index_o),
    .frame_word_o(agreement_frame_word_o)
  );

  logic dim_valid_o;
  logic [7:0] dim_pixel_0_o;
  logic [7:0] dim_pixel_1_o;
  logic dim_saturated_o;
  logic dim_mask_o;
  logic dim_marks_first_o;
  logic dim_marks_last_o;
  logic dim_marks_seen_o;
  logic dim_marks_nearer_o;
  horopter_dim u_dim (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(agreement_valid_o),
    .pixel_0_i(agreement_pixel_0_o),
    .pixel_1_i(agreement_pixel_1_o),
    .saturated_i(agreement_saturated_o),
    .mask_i(agreement_mask_o),
    .marks_first_i(agreement_marks_first_o),
    .marks_last_i(agreement_marks_last_o),
    .marks_seen_i(agreement_marks_seen_o),
    .marks_nearer_i(agreement_marks_nearer_o),
    .cfg_dim_i(cfg_dim_i),
    .valid_o(dim_valid_o),
    .pixel_0_o(dim_pixel_0_o),
    .pixel_1_o(dim_pixel_1_o),
    .saturated_o(dim_saturated_o),
    .mask_o(dim_mask_o),
    .marks_first_o(dim_marks_first_o),
    .marks_last_o(dim_marks_last_o),
    .marks_seen_o(dim_marks_seen_o),
    .marks_nearer_o(dim_marks_nearer_o)
  );

  // The rule of the frame that passes, taken with its first beat before the last stage that both rules share; the
  // clocks between two frames are more than that stage's latency. The other rule's stages wait for a frame of theirs.
  logic thesis_runs, compete_runs, thesis_clk, compete_clk;
  if (THESIS && COMPETE) begin : g_rules
    logic compete_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) compete_q <= 1'b0;
      else if (agreement_valid_o && agreement_marks_first_o) compete_q <= cfg_compete_i;
    end
    assign {thesis_runs, compete_runs} = {!compete_q, compete_q};
    horopter_clock_gate u_thesis (.clk_i(clk_i), .en_i(thesis_runs || !rst_ni), .clk_o(thesis_clk));
    horopter_clock_gate u_compete (.clk_i(clk_i), .en_i(compete_runs || !rst_ni), .clk_o(compete_clk));
  end else begin : g_rule
    assign {thesis_runs, compete_runs, thesis_clk, compete_clk} = {THESIS, COMPETE, clk_i, clk_i};
  end

  logic lowpass_parity_error_o;
  logic lowpass_valid_o;
  logic [7:0] lowpass_pixel_0_o;
  logic [7:0] lowpass_pixel_1_o;
  logic lowpass_saturated_o;
  logic lowpass_mask_o;
  logic lowpass_marks_first_o;
  logic lowpass_marks_last_o;
  logic lowpass_marks_seen_o;
  logic lowpass_marks_nearer_o;
  if (THESIS) begin : g_lowpass
    horopter_lowpass u_lowpass (
      .clk_i(thesis_clk),
      .rst_ni(rst_ni),
      .en_i(thesis_runs),
      .valid_i(dim_valid_o),
      .pixel_0_i(dim_pixel_0_o),
      .pixel_1_i(dim_pixel_1_o),
      .saturated_i(dim_saturated_o),
      .mask_i(dim_mask_o),
      .marks_first_i(dim_marks_first_o),
      .marks_last_i(dim_marks_last_o),
      .marks_seen_i(dim_marks_seen_o),
      .marks_nearer_i(dim_marks_nearer_o),
      .parity_error_o(lowpass_parity_error_o),
      .valid_o(lowpass_valid_o),
      .pixel_0_o(lowpass_pixel_0_o),
      .pixel_1_o(lowpass_pixel_1_o),
      .saturated_o(lowpass_saturated_o),
      .mask_o(lowpass_mask_o),
      .marks_first_o(lowpass_marks_first_o),
      .marks_last_o(lowpass_marks_last_o),
      .marks_seen_o(lowpass_marks_seen_o),
      .marks_nearer_o(lowpass_marks_nearer_o)
    );
  end else begin : g_no_lowpass
    logic unused;
    assign unused = ^{thesis_clk, thesis_runs, dim_valid_o, dim_pixel_0_o, dim_pixel_1_o, dim_saturated_o, dim_mask_o, dim_marks_first_o, dim_marks_last_o, dim_marks_seen_o, dim_marks_nearer_o};
    assign lowpass_parity_error_o = '0;
    assign lowpass_valid_o = '0;
    assign lowpass_pixel_0_o = '0;
    assign lowpass_pixel_1_o = '0;
    assign lowpass_saturated_o = '0;
    assign lowpass_mask_o = '0;
    assign lowpass_marks_first_o = '0;
    assign lowpass_marks_last_o = '0;
    assign lowpass_marks_seen_o = '0;
    assign lowpass_marks_nearer_o = '0;
  end

  logic sobel_parity_error_o;
  logic sobel_valid_o;
  logic signed [10:0] sobel_gx_0_o;
  logic signed [10:0] sobel_gx_1_o;
  logic signed [10:0] sobel_gy_0_o;
  logic signed [10:0] sobel_gy_1_o;
  logic sobel_saturated_o;
  logic sobel_mask_o;
  logic sobel_marks_first_o;
  logic sobel_marks_last_o;
  logic sobel_marks_seen_o;
  logic sobel_marks_nearer_o;
  if (THESIS) begin : g_sobel
    horopter_sobel u_sobel (
      .clk_i(thesis_clk),
      .rst_ni(rst_ni),
      .en_i(thesis_runs),
      .valid_i(lowpass_valid_o),
      .pixel_0_i(lowpass_pixel_0_o),
      .pixel_1_i(lowpass_pixel_1_o),
      .saturated_i(lowpass_saturated_o),
      .mask_i(lowpass_mask_o),
      .marks_first_i(lowpass_marks_first_o),
      .marks_last_i(lowpass_marks_last_o),
      .marks_seen_i(lowpass_marks_seen_o),
      .marks_nearer_i(lowpass_marks_nearer_o),
      .parity_error_o(sobel_parity_error_o),
      .valid_o(sobel_valid_o),
      .gx_0_o(sobel_gx_0_o),
      .gx_1_o(sobel_gx_1_o),
      .gy_0_o(sobel_gy_0_o),
      .gy_1_o(sobel_gy_1_o),
      .saturated_o(sobel_saturated_o),
      .mask_o(sobel_mask_o),
      .marks_first_o(sobel_marks_first_o),
      .marks_last_o(sobel_marks_last_o),
      .marks_seen_o(sobel_marks_seen_o),
      .marks_nearer_o(sobel_marks_nearer_o)
    );
  end else begin : g_no_sobel
    logic unused;
    assign unused = ^{thesis_clk, thesis_runs, lowpass_valid_o, lowpass_pixel_0_o, lowpass_pixel_1_o, lowpass_saturated_o, lowpass_mask_o, lowpass_marks_first_o, lowpass_marks_last_o, lowpass_marks_seen_o, lowpass_marks_nearer_o};
    assign sobel_parity_error_o = '0;
    assign sobel_valid_o = '0;
    assign sobel_gx_0_o = '0;
    assign sobel_gx_1_o = '0;
    assign sobel_gy_0_o = '0;
    assign sobel_gy_1_o = '0;
    assign sobel_saturated_o = '0;
    assign sobel_mask_o = '0;
    assign sobel_marks_first_o = '0;
    assign sobel_marks_last_o = '0;
    assign sobel_marks_seen_o = '0;
    assign sobel_marks_nearer_o = '0;
  end

  logic direction_valid_o;
  logic [7:0] direction_direction_0_o;
  logic [7:0] direction_direction_1_o;
  logic [7:0] direction_magnitude_0_o;
  logic [7:0] direction_magnitude_1_o;
  logic direction_saturated_o;
  logic direction_mask_o;
  logic direction_marks_first_o;
  logic direction_marks_last_o;
  logic direction_marks_seen_o;
  logic direction_marks_nearer_o;
  if (THESIS) begin : g_direction
    horopter_direction u_direction (
      .clk_i(thesis_clk),
      .rst_ni(rst_ni),
      .en_i(thesis_runs),
      .valid_i(sobel_valid_o),
      .gx_0_i(sobel_gx_0_o),
      .gx_1_i(sobel_gx_1_o),
      .gy_0_i(sobel_gy_0_o),
      .gy_1_i(sobel_gy_1_o),
      .saturated_i(sobel_saturated_o),
      .mask_i(sobel_mask_o),
      .marks_first_i(sobel_marks_first_o),
      .marks_last_i(sobel_marks_last_o),
      .marks_seen_i(sobel_marks_seen_o),
      .marks_nearer_i(sobel_marks_nearer_o),
      .valid_o(direction_valid_o),
      .direction_0_o(direction_direction_0_o),
      .direction_1_o(direction_direction_1_o),
      .magnitude_0_o(direction_magnitude_0_o),
      .magnitude_1_o(direction_magnitude_1_o),
      .saturated_o(direction_saturated_o),
      .mask_o(direction_mask_o),
      .marks_first_o(direction_marks_first_o),
      .marks_last_o(direction_marks_last_o),
      .marks_seen_o(direction_marks_seen_o),
      .marks_nearer_o(direction_marks_nearer_o)
    );
  end else begin : g_no_direction
    logic unused;
    assign unused = ^{thesis_clk, thesis_runs, sobel_valid_o, sobel_gx_0_o, sobel_gx_1_o, sobel_gy_0_o, sobel_gy_1_o, sobel_saturated_o, sobel_mask_o, sobel_marks_first_o, sobel_marks_last_o, sobel_marks_seen_o, sobel_marks_nearer_o};
    assign direction_valid_o = '0;
    assign direction_direction_0_o = '0;
    assign direction_direction_1_o = '0;
    assign direction_magnitude_0_o = '0;
    assign direction_magnitude_1_o = '0;
    assign direction_saturated_o = '0;
    assign direction_mask_o = '0;
    assign direction_marks_first_o = '0;
    assign direction_marks_last_o = '0;
    assign direction_marks_seen_o = '0;
    assign direction_marks_nearer_o = '0;
  end

  logic difference_valid_o;
  logic [3:0] difference_difference_0_o;
  logic [3:0] difference_difference_1_o;
  logic [7:0] difference_magnitude_o;
  logic difference_mask_o;
  logic difference_marks_first_o;
  logic difference_marks_last_o;
  logic difference_marks_seen_o;
  logic difference_marks_nearer_o;
  if (THESIS) begin : g_difference
    horopter_difference u_difference (
      .clk_i(thesis_clk),
      .rst_ni(rst_ni),
      .en_i(thesis_runs),
      .valid_i(direction_valid_o),
      .direction_0_i(direction_direction_0_o),
      .direction_1_i(direction_direction_1_o),
      .magnitude_0_i(direction_magnitude_0_o),
      .magnitude_1_i(direction_magnitude_1_o),
      .saturated_i(direction_saturated_o),
      .mask_i(direction_mask_o),
      .marks_first_i(direction_marks_first_o),
      .marks_last_i(direction_marks_last_o),
      .marks_seen_i(direction_marks_seen_o),
      .marks_nearer_i(direction_marks_nearer_o),
      .valid_o(difference_valid_o),
      .difference_0_o(difference_difference_0_o),
      .difference_1_o(difference_difference_1_o),
      .magnitude_o(difference_magnitude_o),
      .mask_o(difference_mask_o),
      .marks_first_o(difference_marks_first_o),
      .marks_last_o(difference_marks_last_o),
      .marks_seen_o(difference_marks_seen_o),
      .marks_nearer_o(difference_marks_nearer_o)
    );
  end else begin : g_no_difference
    logic unused;
    assign unused = ^{thesis_clk, thesis_runs, direction_valid_o, direction_direction_0_o, direction_direction_1_o, direction_magnitude_0_o, direction_magnitude_1_o, direction_saturated_o, direction_mask_o, direction_marks_first_o, direction_marks_last_o, direction_marks_seen_o, direction_marks_nearer_o};
    assign difference_valid_o = '0;
    assign difference_difference_0_o = '0;
    assign difference_difference_1_o = '0;
    assign difference_magnitude_o = '0;
    assign difference_mask_o = '0;
    assign difference_marks_first_o = '0;
    assign difference_marks_last_o = '0;
    assign difference_marks_seen_o = '0;
    assign difference_marks_nearer_o = '0;
  end

  logic texture_parity_error_o;
  logic texture_valid_o;
  logic [3:0] texture_difference_0_o;
  logic [3:0] texture_difference_1_o;
  logic texture_textured_o;
  logic texture_mask_o;
  logic texture_marks_first_o;
  logic texture_marks_last_o;
  logic texture_marks_seen_o;
  logic texture_marks_nearer_o;
  if (THESIS) begin : g_texture
    horopter_texture u_texture (
      .clk_i(thesis_clk),
      .rst_ni(rst_ni),
      .en_i(thesis_runs),
      .valid_i(difference_valid_o),
      .difference_0_i(difference_difference_0_o),
      .difference_1_i(difference_difference_1_o),
      .magnitude_i(difference_magnitude_o),
      .mask_i(difference_mask_o),
      .marks_first_i(difference_marks_first_o),
      .marks_last_i(difference_marks_last_o),
      .marks_seen_i(difference_marks_seen_o),
      .marks_nearer_i(difference_marks_nearer_o),
      .cfg_texture_limit_i(cfg_texture_limit_i),
      .parity_error_o(texture_parity_error_o),
      .valid_o(texture_valid_o),
      .difference_0_o(texture_difference_0_o),
      .difference_1_o(texture_difference_1_o),
      .textured_o(texture_textured_o),
      .mask_o(texture_mask_o),
      .marks_first_o(texture_marks_first_o),
      .marks_last_o(texture_marks_last_o),
      .marks_seen_o(texture_marks_seen_o),
      .marks_nearer_o(texture_marks_nearer_o)
    );
  end else begin : g_no_texture
    logic unused;
    assign unused = ^{thesis_clk, thesis_runs, difference_valid_o, difference_difference_0_o, difference_difference_1_o, difference_magnitude_o, difference_mask_o, difference_marks_first_o, difference_marks_last_o, difference_marks_seen_o, difference_marks_nearer_o, cfg_texture_limit_i};
    assign texture_parity_error_o = '0;
    assign texture_valid_o = '0;
    assign texture_difference_0_o = '0;
    assign texture_difference_1_o = '0;
    assign texture_textured_o = '0;
    assign texture_mask_o = '0;
    assign texture_marks_first_o = '0;
    assign texture_marks_last_o = '0;
    assign texture_marks_seen_o = '0;
    assign texture_marks_nearer_o = '0;
  end

  logic dsad_parity_error_o;
  logic dsad_valid_o;
  logic [10:0] dsad_sum_0_o;
  logic [10:0] dsad_sum_1_o;
  logic dsad_textured_o;
  logic dsad_mask_o;
  logic dsad_marks_first_o;
  logic dsad_marks_last_o;
  logic dsad_marks_seen_o;
  logic dsad_marks_nearer_o;
  if (THESIS) begin : g_dsad
    horopter_dsad u_dsad (
      .clk_i(thesis_clk),
      .rst_ni(rst_ni),
      .en_i(thesis_runs),
      .valid_i(texture_valid_o),
      .difference_0_i(texture_difference_0_o),
      .difference_1_i(texture_difference_1_o),
      .textured_i(texture_textured_o),
      .mask_i(texture_mask_o),
      .marks_first_i(texture_marks_first_o),
      .marks_last_i(texture_marks_last_o),
      .marks_seen_i(texture_marks_seen_o),
      .marks_nearer_i(texture_marks_nearer_o),
      .parity_error_o(dsad_parity_error_o),
      .valid_o(dsad_valid_o),
      .sum_0_o(dsad_sum_0_o),
      .sum_1_o(dsad_sum_1_o),
      .textured_o(dsad_textured_o),
      .mask_o(dsad_mask_o),
      .marks_first_o(dsad_marks_first_o),
      .marks_last_o(dsad_marks_last_o),
      .marks_seen_o(dsad_marks_seen_o),
      .marks_nearer_o(dsad_marks_nearer_o)
    );
  end else begin : g_no_dsad
    logic unused;
    assign unused = ^{thesis_clk, thesis_runs, texture_valid_o, texture_difference_0_o, texture_difference_1_o, texture_textured_o, texture_mask_o, texture_marks_first_o, texture_marks_last_o, texture_marks_seen_o, texture_marks_nearer_o};
    assign dsad_parity_error_o = '0;
    assign dsad_valid_o = '0;
    assign dsad_sum_0_o = '0;
    assign dsad_sum_1_o = '0;
    assign dsad_textured_o = '0;
    assign dsad_mask_o = '0;
    assign dsad_marks_first_o = '0;
    assign dsad_marks_last_o = '0;
    assign dsad_marks_seen_o = '0;
    assign dsad_marks_nearer_o = '0;
  end

  logic threshold_valid_o;
  logic threshold_skin_o;
  logic threshold_decidable_o;
  logic threshold_mask_o;
  logic threshold_marks_first_o;
  logic threshold_marks_last_o;
  logic threshold_marks_seen_o;
  logic threshold_marks_nearer_o;
  if (THESIS) begin : g_threshold
    horopter_threshold u_threshold (
      .clk_i(thesis_clk),
      .rst_ni(rst_ni),
      .en_i(thesis_runs),
      .valid_i(dsad_valid_o),
      .sum_0_i(dsad_sum_0_o),
      .sum_1_i(dsad_sum_1_o),
      .textured_i(dsad_textured_o),
      .mask_i(dsad_mask_o),
      .marks_first_i(dsad_marks_first_o),
      .marks_last_i(dsad_marks_last_o),
      .marks_seen_i(dsad_marks_seen_o),
      .marks_nearer_i(dsad_marks_nearer_o),
      .cfg_sum_limit_i(cfg_sum_limit_i),
      .cfg_self_limit_i(cfg_self_limit_i),
      .valid_o(threshold_valid_o),
      .skin_o(threshold_skin_o),
      .decidable_o(threshold_decidable_o),
      .mask_o(threshold_mask_o),
      .marks_first_o(threshold_marks_first_o),
      .marks_last_o(threshold_marks_last_o),
      .marks_seen_o(threshold_marks_seen_o),
      .marks_nearer_o(threshold_marks_nearer_o)
    );
  end else begin : g_no_threshold
    logic unused;
    assign unused = ^{thesis_clk, thesis_runs, dsad_valid_o, dsad_sum_0_o, dsad_sum_1_o, dsad_textured_o, dsad_mask_o, dsad_marks_first_o, dsad_marks_last_o, dsad_marks_seen_o, dsad_marks_nearer_o, cfg_sum_limit_i, cfg_self_limit_i};
    assign threshold_valid_o = '0;
    assign threshold_skin_o = '0;
    assign threshold_decidable_o = '0;
    assign threshold_mask_o = '0;
    assign threshold_marks_first_o = '0;
    assign threshold_marks_last_o = '0;
    assign threshold_marks_seen_o = '0;
    assign threshold_marks_nearer_o = '0;
  end

  logic majority_parity_error_o;
  logic majority_valid_o;
  logic [1:0] majority_state_o;
  logic majority_marks_first_o;
  logic majority_marks_last_o;
  logic majority_marks_seen_o;
  logic majority_marks_nearer_o;
  if (THESIS) begin : g_majority
    horopter_majority u_majority (
      .clk_i(thesis_clk),
      .rst_ni(rst_ni),
      .en_i(thesis_runs),
      .valid_i(threshold_valid_o),
      .skin_i(threshold_skin_o),
      .decidable_i(threshold_decidable_o),
      .mask_i(threshold_mask_o),
      .marks_first_i(threshold_marks_first_o),
      .marks_last_i(threshold_marks_last_o),
      .marks_seen_i(threshold_marks_seen_o),
      .marks_nearer_i(threshold_marks_nearer_o),
      .parity_error_o(majority_parity_error_o),
      .valid_o(majority_valid_o),
      .state_o(majority_state_o),
      .marks_first_o(majority_marks_first_o),
      .marks_last_o(majority_marks_last_o),
      .marks_seen_o(majority_marks_seen_o),
      .marks_nearer_o(majority_marks_nearer_o)
    );
  end else begin : g_no_majority
    logic unused;
    assign unused = ^{thesis_clk, thesis_runs, threshold_valid_o, threshold_skin_o, threshold_decidable_o, threshold_mask_o, threshold_marks_first_o, threshold_marks_last_o, threshold_marks_seen_o, threshold_marks_nearer_o};
    assign majority_parity_error_o = '0;
    assign majority_valid_o = '0;
    assign majority_state_o = '0;
    assign majority_marks_first_o = '0;
    assign majority_marks_last_o = '0;
    assign majority_marks_seen_o = '0;
    assign majority_marks_nearer_o = '0;
  end

  logic slopes_parity_error_o;
  logic slopes_valid_o;
  logic signed [10:0] slopes_gx_0_o;
  logic signed [10:0] slopes_gx_1_o;
  logic signed [10:0] slopes_gy_0_o;
  logic signed [10:0] slopes_gy_1_o;
  logic [7:0] slopes_grey_o;
  logic slopes_saturated_o;
  logic slopes_mask_o;
  logic slopes_marks_first_o;
  logic slopes_marks_last_o;
  logic slopes_marks_seen_o;
  logic slopes_marks_nearer_o;
  if (COMPETE) begin : g_slopes
    horopter_slopes u_slopes (
      .clk_i(compete_clk),
      .rst_ni(rst_ni),
      .en_i(compete_runs),
      .valid_i(dim_valid_o),
      .pixel_0_i(dim_pixel_0_o),
      .pixel_1_i(dim_pixel_1_o),
      .saturated_i(dim_saturated_o),
      .mask_i(dim_mask_o),
      .marks_first_i(dim_marks_first_o),
      .marks_last_i(dim_marks_last_o),
      .marks_seen_i(dim_marks_seen_o),
      .marks_nearer_i(dim_marks_nearer_o),
      .parity_error_o(slopes_parity_error_o),
      .valid_o(slopes_valid_o),
      .gx_0_o(slopes_gx_0_o),
      .gx_1_o(slopes_gx_1_o),
      .gy_0_o(slopes_gy_0_o),
      .gy_1_o(slopes_gy_1_o),
      .grey_o(slopes_grey_o),
      .saturated_o(slopes_saturated_o),
      .mask_o(slopes_mask_o),
      .marks_first_o(slopes_marks_first_o),
      .marks_last_o(slopes_marks_last_o),
      .marks_seen_o(slopes_marks_seen_o),
      .marks_nearer_o(slopes_marks_nearer_o)
    );
  end else begin : g_no_slopes
    logic unused;
    assign unused = ^{compete_clk, compete_runs, dim_valid_o, dim_pixel_0_o, dim_pixel_1_o, dim_saturated_o, dim_mask_o, dim_marks_first_o, dim_marks_last_o, dim_marks_seen_o, dim_marks_nearer_o};
    assign slopes_parity_error_o = '0;
    assign slopes_valid_o = '0;
    assign slopes_gx_0_o = '0;
    assign slopes_gx_1_o = '0;
    assign slopes_gy_0_o = '0;
    assign slopes_gy_1_o = '0;
    assign slopes_grey_o = '0;
    assign slopes_saturated_o = '0;
    assign slopes_mask_o = '0;
    assign slopes_marks_first_o = '0;
    assign slopes_marks_last_o = '0;
    assign slopes_marks_seen_o = '0;
    assign slopes_marks_nearer_o = '0;
  end

  logic contrast_valid_o;
  logic signed [5:0] contrast_left_o;
  logic signed [5:0] contrast_right_o;
  logic signed [4:0] contrast_left_y_o;
  logic signed [4:0] contrast_right_y_o;
  logic contrast_edge_v_o;
  logic contrast_mask_o;
  logic [7:0] contrast_grey_o;
  logic contrast_marks_first_o;
  logic contrast_marks_last_o;
  logic contrast_marks_seen_o;
  logic contrast_marks_nearer_o;
  if (COMPETE) begin : g_contrast
    horopter_contrast u_contrast (
      .clk_i(compete_clk),
      .rst_ni(rst_ni),
      .en_i(compete_runs),
      .valid_i(slopes_valid_o),
      .gx_0_i(slopes_gx_0_o),
      .gx_1_i(slopes_gx_1_o),
      .gy_0_i(slopes_gy_0_o),
      .gy_1_i(slopes_gy_1_o),
      .grey_i(slopes_grey_o),
      .saturated_i(slopes_saturated_o),
      .mask_i(slopes_mask_o),
      .marks_first_i(slopes_marks_first_o),
      .marks_last_i(slopes_marks_last_o),
      .marks_seen_i(slopes_marks_seen_o),
      .marks_nearer_i(slopes_marks_nearer_o),
      .valid_o(contrast_valid_o),
      .left_o(contrast_left_o),
      .right_o(contrast_right_o),
      .left_y_o(contrast_left_y_o),
      .right_y_o(contrast_right_y_o),
      .edge_v_o(contrast_edge_v_o),
      .mask_o(contrast_mask_o),
      .grey_o(contrast_grey_o),
      .marks_first_o(contrast_marks_first_o),
      .marks_last_o(contrast_marks_last_o),
      .marks_seen_o(contrast_marks_seen_o),
      .marks_nearer_o(contrast_marks_nearer_o)
    );
  end else begin : g_no_contrast
    logic unused;
    assign unused = ^{compete_clk, compete_runs, slopes_valid_o, slopes_gx_0_o, slopes_gx_1_o, slopes_gy_0_o, slopes_gy_1_o, slopes_grey_o, slopes_saturated_o, slopes_mask_o, slopes_marks_first_o, slopes_marks_last_o, slopes_marks_seen_o, slopes_marks_nearer_o};
    assign contrast_valid_o = '0;
    assign contrast_left_o = '0;
    assign contrast_right_o = '0;
    assign contrast_left_y_o = '0;
    assign contrast_right_y_o = '0;
    assign contrast_edge_v_o = '0;
    assign contrast_mask_o = '0;
    assign contrast_grey_o = '0;
    assign contrast_marks_first_o = '0;
    assign contrast_marks_last_o = '0;
    assign contrast_marks_seen_o = '0;
    assign contrast_marks_nearer_o = '0;
  end

  logic plane_sums_parity_error_o;
  logic plane_sums_valid_o;
  logic [10:0] plane_sums_sum_0_o;
  logic [10:0] plane_sums_sum_1_o;
  logic [10:0] plane_sums_sum_2_o;
  logic [10:0] plane_sums_sum_3_o;
  logic [10:0] plane_sums_sum_4_o;
  logic [10:0] plane_sums_sum_5_o;
  logic [10:0] plane_sums_sum_6_o;
  logic [10:0] plane_sums_sum_7_o;
  logic [10:0] plane_sums_sum_8_o;
  logic [10:0] plane_sums_sum_9_o;
  logic [10:0] plane_sums_sum_10_o;
  logic [10:0] plane_sums_sum_11_o;
  logic [10:0] plane_sums_sum_12_o;
  logic [10:0] plane_sums_sum_13_o;
  logic [10:0] plane_sums_sum_14_o;
  logic [10:0] plane_sums_sum_15_o;
  logic [10:0] plane_sums_sum_16_o;
  logic [10:0] plane_sums_sum_17_o;
  logic [10:0] plane_sums_sum_18_o;
  logic [10:0] plane_sums_evidence_o;
  logic [5:0] plane_sums_edges_o;
  logic [5:0] plane_sums_grey_o;
  logic plane_sums_known_o;
  logic plane_sums_exists_o;
  logic plane_sums_marks_first_o;
  logic plane_sums_marks_last_o;
  logic plane_sums_marks_seen_o;
  logic plane_sums_marks_nearer_o;
  if (COMPETE) begin : g_plane_sums
    horopter_plane_sums u_plane_sums (
      .clk_i(compete_clk),
      .rst_ni(rst_ni),
      .en_i(compete_runs),
      .valid_i(contrast_valid_o),
      .left_i(contrast_left_o),
      .right_i(contrast_right_o),
      .left_y_i(contrast_left_y_o),
      .right_y_i(contrast_right_y_o),
      .edge_v_i(contrast_edge_v_o),
      .mask_i(contrast_mask_o),
      .grey_i(contrast_grey_o),
      .marks_first_i(contrast_marks_first_o),
      .marks_last_i(contrast_marks_last_o),
      .marks_seen_i(contrast_marks_seen_o),
      .marks_nearer_i(contrast_marks_nearer_o),
      .parity_error_o(plane_sums_parity_error_o),
      .valid_o(plane_sums_valid_o),
      .sum_0_o(plane_sums_sum_0_o),
      .sum_1_o(plane_sums_sum_1_o),
      .sum_2_o(plane_sums_sum_2_o),
      .sum_3_o(plane_sums_sum_3_o),
      .sum_4_o(plane_sums_sum_4_o),
      .sum_5_o(plane_sums_sum_5_o),
      .sum_6_o(plane_sums_sum_6_o),
      .sum_7_o(plane_sums_sum_7_o),
      .sum_8_o(plane_sums_sum_8_o),
      .sum_9_o(plane_sums_sum_9_o),
      .sum_10_o(plane_sums_sum_10_o),
      .sum_11_o(plane_sums_sum_11_o),
      .sum_12_o(plane_sums_sum_12_o),
      .sum_13_o(plane_sums_sum_13_o),
      .sum_14_o(plane_sums_sum_14_o),
      .sum_15_o(plane_sums_sum_15_o),
      .sum_16_o(plane_sums_sum_16_o),
      .sum_17_o(plane_sums_sum_17_o),
      .sum_18_o(plane_sums_sum_18_o),
      .evidence_o(plane_sums_evidence_o),
      .edges_o(plane_sums_edges_o),
      .grey_o(plane_sums_grey_o),
      .known_o(plane_sums_known_o),
      .exists_o(plane_sums_exists_o),
      .marks_first_o(plane_sums_marks_first_o),
      .marks_last_o(plane_sums_marks_last_o),
      .marks_seen_o(plane_sums_marks_seen_o),
      .marks_nearer_o(plane_sums_marks_nearer_o)
    );
  end else begin : g_no_plane_sums
    logic unused;
    assign unused = ^{compete_clk, compete_runs, contrast_valid_o, contrast_left_o, contrast_right_o, contrast_left_y_o, contrast_right_y_o, contrast_edge_v_o, contrast_mask_o, contrast_grey_o, contrast_marks_first_o, contrast_marks_last_o, contrast_marks_seen_o, contrast_marks_nearer_o};
    assign plane_sums_parity_error_o = '0;
    assign plane_sums_valid_o = '0;
    assign plane_sums_sum_0_o = '0;
    assign plane_sums_sum_1_o = '0;
    assign plane_sums_sum_2_o = '0;
    assign plane_sums_sum_3_o = '0;
    assign plane_sums_sum_4_o = '0;
    assign plane_sums_sum_5_o = '0;
    assign plane_sums_sum_6_o = '0;
    assign plane_sums_sum_7_o = '0;
    assign plane_sums_sum_8_o = '0;
    assign plane_sums_sum_9_o = '0;
    assign plane_sums_sum_10_o = '0;
    assign plane_sums_sum_11_o = '0;
    assign plane_sums_sum_12_o = '0;
    assign plane_sums_sum_13_o = '0;
    assign plane_sums_sum_14_o = '0;
    assign plane_sums_sum_15_o = '0;
    assign plane_sums_sum_16_o = '0;
    assign plane_sums_sum_17_o = '0;
    assign plane_sums_sum_18_o = '0;
    assign plane_sums_evidence_o = '0;
    assign plane_sums_edges_o = '0;
    assign plane_sums_grey_o = '0;
    assign plane_sums_known_o = '0;
    assign plane_sums_exists_o = '0;
    assign plane_sums_marks_first_o = '0;
    assign plane_sums_marks_last_o = '0;
    assign plane_sums_marks_seen_o = '0;
    assign plane_sums_marks_nearer_o = '0;
  end

  logic plane_paths_parity_error_o;
  logic plane_paths_valid_o;
  logic [11:0] plane_paths_cost_0_o;
  logic [11:0] plane_paths_cost_1_o;
  logic [11:0] plane_paths_cost_2_o;
  logic [11:0] plane_paths_cost_3_o;
  logic [11:0] plane_paths_cost_4_o;
  logic [11:0] plane_paths_cost_5_o;
  logic [11:0] plane_paths_cost_6_o;
  logic [11:0] plane_paths_cost_7_o;
  logic [11:0] plane_paths_cost_8_o;
  logic [11:0] plane_paths_cost_9_o;
  logic [11:0] plane_paths_cost_10_o;
  logic [11:0] plane_paths_cost_11_o;
  logic [11:0] plane_paths_cost_12_o;
  logic [11:0] plane_paths_cost_13_o;
  logic [11:0] plane_paths_cost_14_o;
  logic [11:0] plane_paths_cost_15_o;
  logic [11:0] plane_paths_cost_16_o;
  logic [11:0] plane_paths_cost_17_o;
  logic [11:0] plane_paths_cost_18_o;
  logic [5:0] plane_paths_grey_o;
  logic plane_paths_known_o;
  logic plane_paths_evident_o;
  logic plane_paths_strong_v_o;
  logic plane_paths_exists_o;
  logic plane_paths_marks_first_o;
  logic plane_paths_marks_last_o;
  logic plane_paths_marks_seen_o;
  logic plane_paths_marks_nearer_o;
  if (COMPETE) begin : g_plane_paths
    horopter_plane_paths u_plane_paths (
      .clk_i(compete_clk),
      .rst_ni(rst_ni),
      .en_i(compete_runs),
      .valid_i(plane_sums_valid_o),
      .sum_0_i(plane_sums_sum_0_o),
      .sum_1_i(plane_sums_sum_1_o),
      .sum_2_i(plane_sums_sum_2_o),
      .sum_3_i(plane_sums_sum_3_o),
      .sum_4_i(plane_sums_sum_4_o),
      .sum_5_i(plane_sums_sum_5_o),
      .sum_6_i(plane_sums_sum_6_o),
      .sum_7_i(plane_sums_sum_7_o),
      .sum_8_i(plane_sums_sum_8_o),
      .sum_9_i(plane_sums_sum_9_o),
      .sum_10_i(plane_sums_sum_10_o),
      .sum_11_i(plane_sums_sum_11_o),
      .sum_12_i(plane_sums_sum_12_o),
      .sum_13_i(plane_sums_sum_13_o),
      .sum_14_i(plane_sums_sum_14_o),
      .sum_15_i(plane_sums_sum_15_o),
      .sum_16_i(plane_sums_sum_16_o),
      .sum_17_i(plane_sums_sum_17_o),
      .sum_18_i(plane_sums_sum_18_o),
      .evidence_i(plane_sums_evidence_o),
      .edges_i(plane_sums_edges_o),
      .grey_i(plane_sums_grey_o),
      .known_i(plane_sums_known_o),
      .exists_i(plane_sums_exists_o),
      .marks_first_i(plane_sums_marks_first_o),
      .marks_last_i(plane_sums_marks_last_o),
      .marks_seen_i(plane_sums_marks_seen_o),
      .marks_nearer_i(plane_sums_marks_nearer_o),
      .parity_error_o(plane_paths_parity_error_o),
      .valid_o(plane_paths_valid_o),
      .cost_0_o(plane_paths_cost_0_o),
      .cost_1_o(plane_paths_cost_1_o),
      .cost_2_o(plane_paths_cost_2_o),
      .cost_3_o(plane_paths_cost_3_o),
      .cost_4_o(plane_paths_cost_4_o),
      .cost_5_o(plane_paths_cost_5_o),
      .cost_6_o(plane_paths_cost_6_o),
      .cost_7_o(plane_paths_cost_7_o),
      .cost_8_o(plane_paths_cost_8_o),
      .cost_9_o(plane_paths_cost_9_o),
      .cost_10_o(plane_paths_cost_10_o),
      .cost_11_o(plane_paths_cost_11_o),
      .cost_12_o(plane_paths_cost_12_o),
      .cost_13_o(plane_paths_cost_13_o),
      .cost_14_o(plane_paths_cost_14_o),
      .cost_15_o(plane_paths_cost_15_o),
      .cost_16_o(plane_paths_cost_16_o),
      .cost_17_o(plane_paths_cost_17_o),
      .cost_18_o(plane_paths_cost_18_o),
      .grey_o(plane_paths_grey_o),
      .known_o(plane_paths_known_o),
      .evident_o(plane_paths_evident_o),
      .strong_v_o(plane_paths_strong_v_o),
      .exists_o(plane_paths_exists_o),
      .marks_first_o(plane_paths_marks_first_o),
      .marks_last_o(plane_paths_marks_last_o),
      .marks_seen_o(plane_paths_marks_seen_o),
      .marks_nearer_o(plane_paths_marks_nearer_o)
    );
  end else begin : g_no_plane_paths
    logic unused;
    assign unused = ^{compete_clk, compete_runs, plane_sums_valid_o, plane_sums_sum_0_o, plane_sums_sum_1_o, plane_sums_sum_2_o, plane_sums_sum_3_o, plane_sums_sum_4_o, plane_sums_sum_5_o, plane_sums_sum_6_o, plane_sums_sum_7_o, plane_sums_sum_8_o, plane_sums_sum_9_o, plane_sums_sum_10_o, plane_sums_sum_11_o, plane_sums_sum_12_o, plane_sums_sum_13_o, plane_sums_sum_14_o, plane_sums_sum_15_o, plane_sums_sum_16_o, plane_sums_sum_17_o, plane_sums_sum_18_o, plane_sums_evidence_o, plane_sums_edges_o, plane_sums_grey_o, plane_sums_known_o, plane_sums_exists_o, plane_sums_marks_first_o, plane_sums_marks_last_o, plane_sums_marks_seen_o, plane_sums_marks_nearer_o};
    assign plane_paths_parity_error_o = '0;
    assign plane_paths_valid_o = '0;
    assign plane_paths_cost_0_o = '0;
    assign plane_paths_cost_1_o = '0;
    assign plane_paths_cost_2_o = '0;
    assign plane_paths_cost_3_o = '0;
    assign plane_paths_cost_4_o = '0;
    assign plane_paths_cost_5_o = '0;
    assign plane_paths_cost_6_o = '0;
    assign plane_paths_cost_7_o = '0;
    assign plane_paths_cost_8_o = '0;
    assign plane_paths_cost_9_o = '0;
    assign plane_paths_cost_10_o = '0;
    assign plane_paths_cost_11_o = '0;
    assign plane_paths_cost_12_o = '0;
    assign plane_paths_cost_13_o = '0;
    assign plane_paths_cost_14_o = '0;
    assign plane_paths_cost_15_o = '0;
    assign plane_paths_cost_16_o = '0;
    assign plane_paths_cost_17_o = '0;
    assign plane_paths_cost_18_o = '0;
    assign plane_paths_grey_o = '0;
    assign plane_paths_known_o = '0;
    assign plane_paths_evident_o = '0;
    assign plane_paths_strong_v_o = '0;
    assign plane_paths_exists_o = '0;
    assign plane_paths_marks_first_o = '0;
    assign plane_paths_marks_last_o = '0;
    assign plane_paths_marks_seen_o = '0;
    assign plane_paths_marks_nearer_o = '0;
  end

  logic contest_valid_o;
  logic signed [6:0] contest_vote_o;
  logic contest_firm_o;
  logic [5:0] contest_grey_o;
  logic contest_exists_o;
  logic contest_marks_first_o;
  logic contest_marks_last_o;
  logic contest_marks_seen_o;
  logic contest_marks_nearer_o;
  if (COMPETE) begin : g_contest
    horopter_contest u_contest (
      .clk_i(compete_clk),
      .rst_ni(rst_ni),
      .en_i(compete_runs),
      .valid_i(plane_paths_valid_o),
      .cost_0_i(plane_paths_cost_0_o),
      .cost_1_i(plane_paths_cost_1_o),
      .cost_2_i(plane_paths_cost_2_o),
      .cost_3_i(plane_paths_cost_3_o),
      .cost_4_i(plane_paths_cost_4_o),
      .cost_5_i(plane_paths_cost_5_o),
      .cost_6_i(plane_paths_cost_6_o),
      .cost_7_i(plane_paths_cost_7_o),
      .cost_8_i(plane_paths_cost_8_o),
      .cost_9_i(plane_paths_cost_9_o),
      .cost_10_i(plane_paths_cost_10_o),
      .cost_11_i(plane_paths_cost_11_o),
      .cost_12_i(plane_paths_cost_12_o),
      .cost_13_i(plane_paths_cost_13_o),
      .cost_14_i(plane_paths_cost_14_o),
      .cost_15_i(plane_paths_cost_15_o),
      .cost_16_i(plane_paths_cost_16_o),
      .cost_17_i(plane_paths_cost_17_o),
      .cost_18_i(plane_paths_cost_18_o),
      .grey_i(plane_paths_grey_o),
      .known_i(plane_paths_known_o),
      .evident_i(plane_paths_evident_o),
      .strong_v_i(plane_paths_strong_v_o),
      .exists_i(plane_paths_exists_o),
      .marks_first_i(plane_paths_marks_first_o),
      .marks_last_i(plane_paths_marks_last_o),
      .marks_seen_i(plane_paths_marks_seen_o),
      .marks_nearer_i(plane_paths_marks_nearer_o),
      .cfg_bias_i(compete_settings_i[3:0]),
      .cfg_boundary_i(compete_settings_i[30:27]),
      .valid_o(contest_valid_o),
      .vote_o(contest_vote_o),
      .firm_o(contest_firm_o),
      .grey_o(contest_grey_o),
      .exists_o(contest_exists_o),
      .marks_first_o(contest_marks_first_o),
      .marks_last_o(contest_marks_last_o),
      .marks_seen_o(contest_marks_seen_o),
      .marks_nearer_o(contest_marks_nearer_o)
    );
  end else begin : g_no_contest
    logic unused;
    assign unused = ^{compete_clk, compete_runs, plane_paths_valid_o, plane_paths_cost_0_o, plane_paths_cost_1_o, plane_paths_cost_2_o, plane_paths_cost_3_o, plane_paths_cost_4_o, plane_paths_cost_5_o, plane_paths_cost_6_o, plane_paths_cost_7_o, plane_paths_cost_8_o, plane_paths_cost_9_o, plane_paths_cost_10_o, plane_paths_cost_11_o, plane_paths_cost_12_o, plane_paths_cost_13_o, plane_paths_cost_14_o, plane_paths_cost_15_o, plane_paths_cost_16_o, plane_paths_cost_17_o, plane_paths_cost_18_o, plane_paths_grey_o, plane_paths_known_o, plane_paths_evident_o, plane_paths_strong_v_o, plane_paths_exists_o, plane_paths_marks_first_o, plane_paths_marks_last_o, plane_paths_marks_seen_o, plane_paths_marks_nearer_o, compete_settings_i[3:0], compete_settings_i[30:27]};
    assign contest_valid_o = '0;
    assign contest_vote_o = '0;
    assign contest_firm_o = '0;
    assign contest_grey_o = '0;
    assign contest_exists_o = '0;
    assign contest_marks_first_o = '0;
    assign contest_marks_last_o = '0;
    assign contest_marks_seen_o = '0;
    assign contest_marks_nearer_o = '0;
  end

  logic spread_valid_o;
  logic signed [7:0] spread_vote_o;
  logic spread_firm_o;
  logic [5:0] spread_grey_o;
  logic spread_exists_o;
  logic spread_marks_first_o;
  logic spread_marks_last_o;
  logic spread_marks_seen_o;
  logic spread_marks_nearer_o;
  if (COMPETE) begin : g_spread
    horopter_spread u_spread (
      .clk_i(compete_clk),
      .rst_ni(rst_ni),
      .en_i(compete_runs),
      .valid_i(contest_valid_o),
      .vote_i(contest_vote_o),
      .firm_i(contest_firm_o),
      .grey_i(contest_grey_o),
      .exists_i(contest_exists_o),
      .marks_first_i(contest_marks_first_o),
      .marks_last_i(contest_marks_last_o),
      .marks_seen_i(contest_marks_seen_o),
      .marks_nearer_i(contest_marks_nearer_o),
      .cfg_smooth_i(compete_settings_i[6:4]),
      .valid_o(spread_valid_o),
      .vote_o(spread_vote_o),
      .firm_o(spread_firm_o),
      .grey_o(spread_grey_o),
      .exists_o(spread_exists_o),
      .marks_first_o(spread_marks_first_o),
      .marks_last_o(spread_marks_last_o),
      .marks_seen_o(spread_marks_seen_o),
      .marks_nearer_o(spread_marks_nearer_o)
    );
  end else begin : g_no_spread
    logic unused;
    assign unused = ^{compete_clk, compete_runs, contest_valid_o, contest_vote_o, contest_firm_o, contest_grey_o, contest_exists_o, contest_marks_first_o, contest_marks_last_o, contest_marks_seen_o, contest_marks_nearer_o, compete_settings_i[6:4]};
    assign spread_valid_o = '0;
    assign spread_vote_o = '0;
    assign spread_firm_o = '0;
    assign spread_grey_o = '0;
    assign spread_exists_o = '0;
    assign spread_marks_first_o = '0;
    assign spread_marks_last_o = '0;
    assign spread_marks_seen_o = '0;
    assign spread_marks_nearer_o = '0;
  end

  logic ballot_parity_error_o;
  logic ballot_valid_o;
  logic ballot_skin_o;
  logic ballot_clear_o;
  logic ballot_exists_o;
  logic ballot_marks_first_o;
  logic ballot_marks_last_o;
  logic ballot_marks_seen_o;
  logic ballot_marks_nearer_o;
  if (COMPETE) begin : g_ballot
    horopter_ballot u_ballot (
      .clk_i(compete_clk),
      .rst_ni(rst_ni),
      .en_i(compete_runs),
      .valid_i(spread_valid_o),
      .vote_i(spread_vote_o),
      .firm_i(spread_firm_o),
      .grey_i(spread_grey_o),
      .exists_i(spread_exists_o),
      .marks_first_i(spread_marks_first_o),
      .marks_last_i(spread_marks_last_o),
      .marks_seen_i(spread_marks_seen_o),
      .marks_nearer_i(spread_marks_nearer_o),
      .cfg_similar_i(compete_settings_i[10:7]),
      .cfg_quorum_i(compete_settings_i[18:11]),
      .cfg_clear_quorum_i(compete_settings_i[26:19]),
      .cfg_dim_i(cfg_dim_i),
      .parity_error_o(ballot_parity_error_o),
      .valid_o(ballot_valid_o),
      .skin_o(ballot_skin_o),
      .clear_o(ballot_clear_o),
      .exists_o(ballot_exists_o),
      .marks_first_o(ballot_marks_first_o),
      .marks_last_o(ballot_marks_last_o),
      .marks_seen_o(ballot_marks_seen_o),
      .marks_nearer_o(ballot_marks_nearer_o)
    );
  end else begin : g_no_ballot
    logic unused;
    assign unused = ^{compete_clk, compete_runs, spread_valid_o, spread_vote_o, spread_firm_o, spread_grey_o, spread_exists_o, spread_marks_first_o, spread_marks_last_o, spread_marks_seen_o, spread_marks_nearer_o, compete_settings_i[10:7], compete_settings_i[18:11], compete_settings_i[26:19], cfg_dim_i};
    assign ballot_parity_error_o = '0;
    assign ballot_valid_o = '0;
    assign ballot_skin_o = '0;
    assign ballot_clear_o = '0;
    assign ballot_exists_o = '0;
    assign ballot_marks_first_o = '0;
    assign ballot_marks_last_o = '0;
    assign ballot_marks_seen_o = '0;
    assign ballot_marks_nearer_o = '0;
  end

  logic consensus_parity_error_o;
  logic consensus_valid_o;
  logic [1:0] consensus_state_o;
  logic consensus_marks_first_o;
  logic consensus_marks_last_o;
  logic consensus_marks_seen_o;
  logic consensus_marks_nearer_o;
  if (COMPETE) begin : g_consensus
    horopter_consensus u_consensus (
      .clk_i(compete_clk),
      .rst_ni(rst_ni),
      .en_i(compete_runs),
      .valid_i(ballot_valid_o),
      .skin_i(ballot_skin_o),
      .clear_i(ballot_clear_o),
      .exists_i(ballot_exists_o),
      .marks_first_i(ballot_marks_first_o),
      .marks_last_i(ballot_marks_last_o),
      .marks_seen_i(ballot_marks_seen_o),
      .marks_nearer_i(ballot_marks_nearer_o),
      .parity_error_o(consensus_parity_error_o),
      .valid_o(consensus_valid_o),
      .state_o(consensus_state_o),
      .marks_first_o(consensus_marks_first_o),
      .marks_last_o(consensus_marks_last_o),
      .marks_seen_o(consensus_marks_seen_o),
      .marks_nearer_o(consensus_marks_nearer_o)
    );
  end else begin : g_no_consensus
    logic unused;
    assign unused = ^{compete_clk, compete_runs, ballot_valid_o, ballot_skin_o, ballot_clear_o, ballot_exists_o, ballot_marks_first_o, ballot_marks_last_o, ballot_marks_seen_o, ballot_marks_nearer_o};
    assign consensus_parity_error_o = '0;
    assign consensus_valid_o = '0;
    assign consensus_state_o = '0;
    assign consensus_marks_first_o = '0;
    assign consensus_marks_last_o = '0;
    assign consensus_marks_seen_o = '0;
    assign consensus_marks_nearer_o = '0;
  end

  logic align_valid_i;
  assign align_valid_i = compete_runs ? consensus_valid_o : majority_valid_o;
  logic [1:0] align_state_i;
  assign align_state_i = compete_runs ? consensus_state_o : majority_state_o;
  logic align_marks_first_i;
  assign align_marks_first_i = compete_runs ? consensus_marks_first_o : majority_marks_first_o;
  logic align_marks_last_i;
  assign align_marks_last_i = compete_runs ? consensus_marks_last_o : majority_marks_last_o;
  logic align_marks_seen_i;
  assign align_marks_seen_i = compete_runs ? consensus_marks_seen_o : majority_marks_seen_o;
  logic align_marks_nearer_i;
  assign align_marks_nearer_i = compete_runs ? consensus_marks_nearer_o : majority_marks_nearer_o;
  horopter_align u_align (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(align_valid_i),
    .state_i(align_state_i),
    .marks_first_i(align_marks_first_i),
    .marks_last_i(align_marks_last_i),
    .marks_seen_i(align_marks_seen_i),
    .marks_nearer_i(align_marks_nearer_i),
    .cfg_width_i(cfg_width_i),
    .cfg_height_i(cfg_height_i),
    .cfg_compete_i(cfg_compete_i),
    .valid_o(align_valid_o),
    .state_o(align_state_o),
    .first_o(align_first_o),
    .last_o(align_last_o),
    .end_v_o(align_end_v_o),
    .idle_o(align_idle_o),
    .hidden_o(align_hidden_o),
    .unproven_o(align_unproven_o)
  );

  horopter_runs u_runs (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(align_valid_o),
    .state_i(align_state_o),
    .first_i(align_first_o),
    .last_i(align_last_o),
    .idle_i(align_idle_o),
    .valid_o(runs_valid_o),
    .row_o(runs_row_o),
    .start_o(runs_start_o),
    .end_v_o(runs_end_v_o),
    .state_o(runs_state_o),
    .last_o(runs_last_o)
  );

  horopter_alarm u_alarm (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(align_valid_o),
    .state_i(align_state_o),
    .first_i(align_first_o),
    .end_v_i(align_end_v_o),
    .idle_i(align_idle_o),
    .hidden_i(align_hidden_o),
    .unproven_i(align_unproven_o),
    .cfg_alarm_limit_i(cfg_alarm_limit_i),
    .cfg_undecidable_limit_i(cfg_undecidable_limit_i),
    .cfg_unsupervised_limit_i(cfg_unsupervised_limit_i),
    .valid_o(alarm_valid_o),
    .skin_pixels_o(alarm_skin_pixels_o),
    .unsupervised_pixels_o(alarm_unsupervised_pixels_o),
    .alarm_o(alarm_alarm_o),
    .too_undecidable_o(alarm_too_undecidable_o),
    .too_unsupervised_o(alarm_too_unsupervised_o)
  );

  assign parity_error_o = agreement_parity_error_o | lowpass_parity_error_o | sobel_parity_error_o | texture_parity_error_o | dsad_parity_error_o | majority_parity_error_o | slopes_parity_error_o | plane_sums_parity_error_o | plane_paths_parity_error_o | ballot_parity_error_o | consensus_parity_error_o;
endmodule
