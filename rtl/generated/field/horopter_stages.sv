// SPDX-License-Identifier: Apache-2.0
// Made by scripts/generate-profiles from hls/stages/stage_list.def: change that, not this.
// The stages of the profile `field` from the 2x2 source pixels to states, runs and counts. Ports: their modules.
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
  input  logic [8:0] cfg_width_i,
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
  input  logic [16:0] cfg_alarm_limit_i,
  input  logic [16:0] cfg_undecidable_limit_i,
  input  logic [16:0] cfg_unsupervised_limit_i,
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
  output logic [8:0] runs_start_o,
  output logic [8:0] runs_end_v_o,
  output logic [1:0] runs_state_o,
  output logic runs_last_o,
  output logic alarm_valid_o,
  output logic [16:0] alarm_skin_pixels_o,
  output logic [16:0] alarm_unsupervised_pixels_o,
  output logic alarm_alarm_o,
  output logic alarm_too_undecidable_o,
  output logic alarm_too_unsupervised_o
);
  if (!THESIS || COMPETE) begin : g_illegal
    $fatal(1, "horopter_stages: field has the rule thesis alone");
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
    .saturated_o(subsample_saturated_o),
    .mask_o(subsample_mask_o),
    .present_o(subsample_present_o),
    .marks_first_o(subsample_marks_first_o),
    .marks_last_o(subsample_marks_last_o)
  );

  logic agreement_valid_o;
  logic [7:0] agreement_pixel_0_o;
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
    .valid_o(agreement_valid_o),
    .pixel_0_o(agreement_pixel_0_o),
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
    .saturated_i(agreement_saturated_o),
    .mask_i(agreement_mask_o),
    .marks_first_i(agreement_marks_first_o),
    .marks_last_i(agreement_marks_last_o),
    .marks_seen_i(agreement_marks_seen_o),
    .marks_nearer_i(agreement_marks_nearer_o),
    .cfg_dim_i(cfg_dim_i),
    .valid_o(dim_valid_o),
    .pixel_0_o(dim_pixel_0_o),
    .saturated_o(dim_saturated_o),
    .mask_o(dim_mask_o),
    .marks_first_o(dim_marks_first_o),
    .marks_last_o(dim_marks_last_o),
    .marks_seen_o(dim_marks_seen_o),
    .marks_nearer_o(dim_marks_nearer_o)
  );

  logic lowpass_valid_o;
  logic [7:0] lowpass_pixel_0_o;
  logic lowpass_saturated_o;
  logic lowpass_mask_o;
  logic lowpass_marks_first_o;
  logic lowpass_marks_last_o;
  logic lowpass_marks_seen_o;
  logic lowpass_marks_nearer_o;
  horopter_lowpass u_lowpass (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(dim_valid_o),
    .pixel_0_i(dim_pixel_0_o),
    .saturated_i(dim_saturated_o),
    .mask_i(dim_mask_o),
    .marks_first_i(dim_marks_first_o),
    .marks_last_i(dim_marks_last_o),
    .marks_seen_i(dim_marks_seen_o),
    .marks_nearer_i(dim_marks_nearer_o),
    .valid_o(lowpass_valid_o),
    .pixel_0_o(lowpass_pixel_0_o),
    .saturated_o(lowpass_saturated_o),
    .mask_o(lowpass_mask_o),
    .marks_first_o(lowpass_marks_first_o),
    .marks_last_o(lowpass_marks_last_o),
    .marks_seen_o(lowpass_marks_seen_o),
    .marks_nearer_o(lowpass_marks_nearer_o)
  );

  logic sobel_valid_o;
  logic signed [10:0] sobel_gx_0_o;
  logic signed [10:0] sobel_gy_0_o;
  logic sobel_saturated_o;
  logic sobel_mask_o;
  logic sobel_marks_first_o;
  logic sobel_marks_last_o;
  logic sobel_marks_seen_o;
  logic sobel_marks_nearer_o;
  horopter_sobel u_sobel (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(lowpass_valid_o),
    .pixel_0_i(lowpass_pixel_0_o),
    .saturated_i(lowpass_saturated_o),
    .mask_i(lowpass_mask_o),
    .marks_first_i(lowpass_marks_first_o),
    .marks_last_i(lowpass_marks_last_o),
    .marks_seen_i(lowpass_marks_seen_o),
    .marks_nearer_i(lowpass_marks_nearer_o),
    .valid_o(sobel_valid_o),
    .gx_0_o(sobel_gx_0_o),
    .gy_0_o(sobel_gy_0_o),
    .saturated_o(sobel_saturated_o),
    .mask_o(sobel_mask_o),
    .marks_first_o(sobel_marks_first_o),
    .marks_last_o(sobel_marks_last_o),
    .marks_seen_o(sobel_marks_seen_o),
    .marks_nearer_o(sobel_marks_nearer_o)
  );

  logic direction_valid_o;
  logic [7:0] direction_direction_0_o;
  logic [7:0] direction_magnitude_0_o;
  logic direction_saturated_o;
  logic direction_mask_o;
  logic direction_marks_first_o;
  logic direction_marks_last_o;
  logic direction_marks_seen_o;
  logic direction_marks_nearer_o;
  horopter_direction u_direction (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(sobel_valid_o),
    .gx_0_i(sobel_gx_0_o),
    .gy_0_i(sobel_gy_0_o),
    .saturated_i(sobel_saturated_o),
    .mask_i(sobel_mask_o),
    .marks_first_i(sobel_marks_first_o),
    .marks_last_i(sobel_marks_last_o),
    .marks_seen_i(sobel_marks_seen_o),
    .marks_nearer_i(sobel_marks_nearer_o),
    .valid_o(direction_valid_o),
    .direction_0_o(direction_direction_0_o),
    .magnitude_0_o(direction_magnitude_0_o),
    .saturated_o(direction_saturated_o),
    .mask_o(direction_mask_o),
    .marks_first_o(direction_marks_first_o),
    .marks_last_o(direction_marks_last_o),
    .marks_seen_o(direction_marks_seen_o),
    .marks_nearer_o(direction_marks_nearer_o)
  );

  logic difference_valid_o;
  logic [3:0] difference_difference_0_o;
  logic [3:0] difference_difference_1_o;
  logic [7:0] difference_magnitude_o;
  logic difference_mask_o;
  logic difference_marks_first_o;
  logic difference_marks_last_o;
  logic difference_marks_seen_o;
  logic difference_marks_nearer_o;
  horopter_difference u_difference (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(direction_valid_o),
    .direction_0_i(direction_direction_0_o),
    .magnitude_0_i(direction_magnitude_0_o),
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

  logic texture_valid_o;
  logic [3:0] texture_difference_0_o;
  logic [3:0] texture_difference_1_o;
  logic texture_textured_o;
  logic texture_mask_o;
  logic texture_marks_first_o;
  logic texture_marks_last_o;
  logic texture_marks_seen_o;
  logic texture_marks_nearer_o;
  horopter_texture u_texture (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
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

  logic dsad_valid_o;
  logic [10:0] dsad_sum_0_o;
  logic [10:0] dsad_sum_1_o;
  logic dsad_textured_o;
  logic dsad_mask_o;
  logic dsad_marks_first_o;
  logic dsad_marks_last_o;
  logic dsad_marks_seen_o;
  logic dsad_marks_nearer_o;
  horopter_dsad u_dsad (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(texture_valid_o),
    .difference_0_i(texture_difference_0_o),
    .difference_1_i(texture_difference_1_o),
    .textured_i(texture_textured_o),
    .mask_i(texture_mask_o),
    .marks_first_i(texture_marks_first_o),
    .marks_last_i(texture_marks_last_o),
    .marks_seen_i(texture_marks_seen_o),
    .marks_nearer_i(texture_marks_nearer_o),
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

  logic threshold_valid_o;
  logic threshold_skin_o;
  logic threshold_decidable_o;
  logic threshold_mask_o;
  logic threshold_marks_first_o;
  logic threshold_marks_last_o;
  logic threshold_marks_seen_o;
  logic threshold_marks_nearer_o;
  horopter_threshold u_threshold (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
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

  logic majority_valid_o;
  logic [1:0] majority_state_o;
  logic majority_marks_first_o;
  logic majority_marks_last_o;
  logic majority_marks_seen_o;
  logic majority_marks_nearer_o;
  horopter_majority u_majority (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(threshold_valid_o),
    .skin_i(threshold_skin_o),
    .decidable_i(threshold_decidable_o),
    .mask_i(threshold_mask_o),
    .marks_first_i(threshold_marks_first_o),
    .marks_last_i(threshold_marks_last_o),
    .marks_seen_i(threshold_marks_seen_o),
    .marks_nearer_i(threshold_marks_nearer_o),
    .valid_o(majority_valid_o),
    .state_o(majority_state_o),
    .marks_first_o(majority_marks_first_o),
    .marks_last_o(majority_marks_last_o),
    .marks_seen_o(majority_marks_seen_o),
    .marks_nearer_o(majority_marks_nearer_o)
  );

  horopter_align u_align (
    .clk_i(clk_i),
    .rst_ni(rst_ni),
    .en_i(1'b1),
    .valid_i(majority_valid_o),
    .state_i(majority_state_o),
    .marks_first_i(majority_marks_first_o),
    .marks_last_i(majority_marks_last_o),
    .marks_seen_i(majority_marks_seen_o),
    .marks_nearer_i(majority_marks_nearer_o),
    .cfg_width_i(cfg_width_i),
    .cfg_height_i(cfg_height_i),
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

  // Of the rule that this profile does not have.
  logic unused_settings;
  assign unused_settings = ^{compete_settings_i};

  assign parity_error_o = 1'b0;
endmodule
