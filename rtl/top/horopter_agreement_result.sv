// SPDX-License-Identifier: Apache-2.0
// What the stage `agreement` said of a frame, for the registers: the verdict as it came, the counts of the regions, and the
// pixels that were not clear because of it. A frame's verdict comes before the frame is published, its regions before that.
module horopter_agreement_result #(
    parameter int unsigned COUNT_BITS = 18
) (
    input  logic                  clk_i,
    input  logic                  prove_i,  // else nothing is said
    input  logic                  verdict_valid_i,
    input  logic [          15:0] supervised_i,
    input  logic [          15:0] textured_i,
    input  logic [          15:0] explained_i,
    input  logic [          15:0] nearer_i,
    input  logic [          15:0] unproven_i,
    input  logic [          15:0] regions_bad_i,
    input  logic [          79:0] across_i,
    input  logic [          47:0] measured_i,
    input  logic [          47:0] detail_i,    // left lowest
    input  logic [          47:0] contrast_i,
    input  logic                  region_valid_i,
    input  logic [           5:0] region_i,
    input  logic [           9:0] region_textured_i,
    input  logic [           9:0] region_explained_i,
    input  logic [           9:0] region_nearer_i,
    // pixels of the result
    input  logic                  state_valid_i,
    input  logic                  state_first_i,
    input  logic                  hidden_i,
    input  logic                  unproven_pixel_i,
    input  logic                  counts_valid_i,
    output logic [COUNT_BITS-1:0] unearned_o,  // with counts_valid_i: pixels that are not clear because of it
    // registers
    input  logic [           5:0] region_select_i,
    output horopter_csr_pkg::frame_agreement_t frame_agreement_o,
    output horopter_csr_pkg::frame_cells_t     frame_cells_o,
    output horopter_csr_pkg::frame_unproven_t  frame_unproven_o,
    output logic [         127:0] frame_across_o,
    output logic [          47:0] frame_detail_o,
    output logic [          47:0] frame_contrast_o,
    output logic [          23:0] frame_hidden_o,
    output logic [          23:0] frame_unproven_pixels_o,
    output horopter_csr_pkg::frame_region_t    frame_region_o
);
  logic [29:0] regions[64];
  logic [29:0] region_q;  // a block memory's data come late in the clock
  logic [COUNT_BITS-1:0] hidden_q, unproven_q;
  assign unearned_o = hidden_q + unproven_q;
  always_ff @(posedge clk_i) begin
    if (region_valid_i) regions[region_i] <= prove_i ? {region_nearer_i, region_explained_i, region_textured_i} : '0;
    region_q <= regions[region_select_i];
    {frame_region_o.nearer, frame_region_o.explained, frame_region_o.textured} <= region_q;
    if (verdict_valid_i) begin
      frame_agreement_o <= prove_i ? {explained_i, textured_i} : '0;
      frame_cells_o <= prove_i ? {nearer_i, supervised_i} : '0;
      frame_unproven_o <= prove_i ? {regions_bad_i, unproven_i} : '0;
      for (int unsigned i = 0; i < 4; i++) frame_across_o[32*i+:32] <= prove_i ? {measured_i[12*i+:12], across_i[20*i+:20]} : '0;
      frame_detail_o <= prove_i ? detail_i : '0;
      frame_contrast_o <= prove_i ? contrast_i : '0;
    end
    if (state_valid_i) begin
      hidden_q <= (state_first_i ? '0 : hidden_q) + COUNT_BITS'(hidden_i);
      unproven_q <= (state_first_i ? '0 : unproven_q) + COUNT_BITS'(unproven_pixel_i);
    end
    if (counts_valid_i) begin
      frame_hidden_o <= 24'(hidden_q);
      frame_unproven_pixels_o <= 24'(unproven_q);
    end
  end
endmodule
