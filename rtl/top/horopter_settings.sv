// SPDX-License-Identifier: Apache-2.0
// What a frame is made with: the settings, sampled for each frame, so that a change never falls into the middle of one.
// A limit that is more than can be counted is the largest that can. Of a rule that is not built nothing is kept.
// changed_o: what was sampled is not what it was (horopter_guard). rst_ni: of the streaming core.
module horopter_settings #(
    parameter bit THESIS = horopter_profile_pkg::THESIS,
    parameter bit COMPETE = horopter_profile_pkg::COMPETE,
    parameter int unsigned PIXEL_BITS = 18,  // of a number of incoming pixels
    parameter int unsigned SUM_BITS = 11,
    parameter int unsigned TEXTURE_BITS = 12,
    parameter int unsigned COUNT_BITS = 18,  // of a number of pixels of the result
    parameter int unsigned WIDTH_BITS = 9,
    parameter int unsigned HEIGHT_BITS = 9
) (
    input  logic                       clk_i,
    input  logic                       rst_ni,
    // the registers
    input  logic [7:0]                 black_level_i,
    input  logic [7:0]                 white_level_i,
    input  logic [7:0]                 constant_limit_i,
    input  logic [7:0]                 frozen_limit_i,
    input  logic [23:0]                black_limit_i,
    input  logic [23:0]                white_limit_i,
    input  logic [15:0]                sum_limit_i,
    input  logic [15:0]                self_limit_i,
    input  logic [15:0]                texture_limit_i,
    input  logic [23:0]                alarm_limit_i,
    input  logic [23:0]                object_limit_i,
    input  logic [31:0]                object_area_limit_i,
    input  horopter_csr_pkg::blocks_t  blocks_i,
    input  logic [23:0]                unsupervised_limit_i,
    input  horopter_csr_pkg::agreement_t agreement_i,
    input  horopter_csr_pkg::agreement_limits_t agreement_limits_i,
    input  logic [7:0]                 hidden_frames_i,
    input  horopter_csr_pkg::registration_t registration_i,
    input  horopter_csr_pkg::epipolar_t epipolar_i,
    input  horopter_csr_pkg::epipolar_change_t epipolar_change_i,
    input  logic                       decision_compete_i,
    input  horopter_csr_pkg::compete_t compete_i,
    input  logic [11:0]                width_i,
    input  logic [HEIGHT_BITS-1:0]     height_i,
    // for the images of a frame, from its opening on
    input  logic                       open_i,
    output logic [7:0]                 black_level_o,
    output logic [7:0]                 white_level_o,
    output logic [7:0]                 constant_limit_o,
    output logic [7:0]                 frozen_limit_o,
    output logic [PIXEL_BITS-1:0]      black_limit_o,
    output logic [PIXEL_BITS-1:0]      white_limit_o,
    // for its output, from its begin on
    input  logic                       begin_i,
    output logic [SUM_BITS-1:0]        sum_limit_o,
    output logic [SUM_BITS-1:0]        self_limit_o,
    output logic [TEXTURE_BITS-1:0]    texture_limit_o,
    output logic [COUNT_BITS-1:0]      alarm_limit_o,
    output logic [COUNT_BITS-1:0]      object_limit_o,
    output logic [31:0]                object_area_limit_o,
    output horopter_csr_pkg::blocks_t  blocks_o,
    output logic                       dim_o,  // it teaches, as half of the light would show it
    output horopter_csr_pkg::agreement_t agreement_o,
    output horopter_csr_pkg::agreement_limits_t agreement_limits_o,
    output logic [7:0]                 hidden_frames_o,
    output horopter_csr_pkg::registration_t registration_o,
    output horopter_csr_pkg::epipolar_t epipolar_o,
    output horopter_csr_pkg::epipolar_change_t epipolar_change_o,
    output logic                       decision_compete_o,
    output horopter_csr_pkg::compete_t compete_o,
    output logic [WIDTH_BITS-1:0]      result_width_o,  // after sub-sampling
    output logic [HEIGHT_BITS-1:0]     result_height_o,
    output logic                       changed_o,
    // of its table, which is looked up at its begin and stays until the next
    input  logic [23:0]                undecidable_limit_i,
    input  logic                       table_ok_i,
    input  logic [47:0]                unsupervised_i,  // pixels that thesis (low half), compete cannot judge
    output logic [COUNT_BITS-1:0]      undecidable_limit_o,  // a clock later
    output logic [COUNT_BITS-1:0]      unsupervised_limit_o  // of the register and what a table that is ok itself expects the smaller
);
  logic [COUNT_BITS-1:0] unsupervised_set, expected_q;
  logic expects_q, is_less_q;  // expected_q is less, as of the clock before
  logic [23:0] expected;
  assign expected = decision_compete_o ? unsupervised_i[47:24] : unsupervised_i[23:0];
  always_ff @(posedge clk_i) begin
    if (!rst_ni) dim_o <= 1'b0;
    else if (begin_i) dim_o <= blocks_i.teach && blocks_i.dim && !dim_o;
    if (open_i) begin
      black_level_o <= black_level_i;
      white_level_o <= white_level_i;
      constant_limit_o <= constant_limit_i;
      frozen_limit_o <= frozen_limit_i;
      black_limit_o <= 32'(black_limit_i) >> PIXEL_BITS != 0 ? '1 : PIXEL_BITS'(black_limit_i);
      white_limit_o <= 32'(white_limit_i) >> PIXEL_BITS != 0 ? '1 : PIXEL_BITS'(white_limit_i);
    end
    if (begin_i) begin
      sum_limit_o <= 32'(sum_limit_i) >> SUM_BITS != 0 ? '1 : SUM_BITS'(sum_limit_i);
      self_limit_o <= 32'(self_limit_i) >> SUM_BITS != 0 ? '1 : SUM_BITS'(self_limit_i);
      texture_limit_o <= 32'(texture_limit_i) >> TEXTURE_BITS != 0 ? '1 : TEXTURE_BITS'(texture_limit_i);
      alarm_limit_o <= 32'(alarm_limit_i) >> COUNT_BITS != 0 ? '1 : COUNT_BITS'(alarm_limit_i);
      object_limit_o <= 32'(object_limit_i) >> COUNT_BITS != 0 ? '1 : COUNT_BITS'(object_limit_i);
      object_area_limit_o <= object_area_limit_i;
      blocks_o <= blocks_i;
      unsupervised_set <= 32'(unsupervised_limit_i) >> COUNT_BITS != 0 ? '1 : COUNT_BITS'(unsupervised_limit_i);
      agreement_o <= agreement_i;
      agreement_limits_o <= agreement_limits_i;
      hidden_frames_o <= hidden_frames_i;
      registration_o <= registration_i;
      epipolar_o <= epipolar_i;
      epipolar_change_o <= epipolar_change_i;
      result_width_o <= WIDTH_BITS'(32'(width_i) / horopter_profile_pkg::SUBSAMPLE);
      result_height_o <= height_i;
    end
    undecidable_limit_o <= dim_o || 32'(undecidable_limit_i) >> COUNT_BITS != 0 ? '1 : COUNT_BITS'(undecidable_limit_i);
    expected_q <= 32'(expected) >> COUNT_BITS != 0 ? '1 : COUNT_BITS'(expected);
    expects_q <= table_ok_i;
    is_less_q <= expects_q && expected_q < unsupervised_set;
    unsupervised_limit_o <= is_less_q ? expected_q : unsupervised_set;
  end

  // Both groups are guarded, in words.
  localparam int unsigned OPEN_BITS = 32 + 2 * PIXEL_BITS;
  localparam int unsigned BEGIN_BITS = 2 * SUM_BITS + TEXTURE_BITS + 3 * COUNT_BITS + $bits(agreement_o)
      + $bits(agreement_limits_o) + $bits(blocks_o) + 8 + $bits(registration_o)
      + $bits(epipolar_o) + $bits(epipolar_change_o) + WIDTH_BITS + HEIGHT_BITS
      + 1 + $bits(compete_o) + 32 + 1;
  localparam int unsigned OPEN_WORDS = (OPEN_BITS + 31) / 32;
  localparam int unsigned BEGIN_WORDS = (BEGIN_BITS + 31) / 32;
  logic [32*OPEN_WORDS-1:0] opened;
  logic [32*BEGIN_WORDS-1:0] begun;
  logic [OPEN_WORDS-1:0] open_error;
  logic [BEGIN_WORDS-1:0] begin_error;
  assign opened = (32 * OPEN_WORDS)'({
      black_level_o, white_level_o, constant_limit_o, frozen_limit_o, black_limit_o, white_limit_o});
  assign begun = (32 * BEGIN_WORDS)'({
      sum_limit_o, self_limit_o, texture_limit_o, alarm_limit_o, object_limit_o, object_area_limit_o, blocks_o, unsupervised_set, agreement_o,
      agreement_limits_o, hidden_frames_o, registration_o, epipolar_o, epipolar_change_o, result_width_o, result_height_o, decision_compete_o,
      compete_o, dim_o});
  for (genvar w = 0; w < OPEN_WORDS; w++) begin : g_opened
    horopter_guard #(
        .WIDTH(32)
    ) u_guard (
        .clk_i(clk_i),
        .write_i(open_i || !rst_ni),
        .value_i(opened[32*w+:32]),
        .error_o(open_error[w])
    );
  end
  for (genvar w = 0; w < BEGIN_WORDS; w++) begin : g_begun
    horopter_guard #(
        .WIDTH(32)
    ) u_guard (
        .clk_i(clk_i),
        .write_i(begin_i || !rst_ni),
        .value_i(begun[32*w+:32]),
        .error_o(begin_error[w])
    );
  end
  always_ff @(posedge clk_i) begin
    changed_o <= rst_ni && (open_error != '0 || begin_error != '0);
  end

  if (COMPETE) begin : g_compete
    logic compete_q;
    horopter_csr_pkg::compete_t settings_q;
    always_ff @(posedge clk_i) begin
      if (begin_i) begin
        compete_q <= decision_compete_i;
        settings_q <= compete_i;
      end
    end
    assign decision_compete_o = THESIS ? compete_q : 1'b1;
    assign compete_o = settings_q;
  end else begin : g_thesis
    logic unused_settings;
    assign unused_settings = ^{decision_compete_i, compete_i};
    assign decision_compete_o = 1'b0;
    assign compete_o = '0;
  end
endmodule
