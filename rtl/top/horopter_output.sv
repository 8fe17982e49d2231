// SPDX-License-Identifier: Apache-2.0
// States and runs on their way out: FIFOs that hold what is under way in the pipeline when the reader stalls.
//
// go_o: the raster may send another beat; what it has sent, at most IN_FLIGHT beats, still finds room. Formats of
// m_axis_state and m_axis_runs as in horopter_top. One clock each: state_first_o, state_end_o, runs_end_o: a frame's first
// state, its last one, its last run leave. overflow_o (states, runs): a beat was lost, which cannot be.
// rows_error_o, with runs_end_o: the runs do not cover as many rows as the result has, each to its end.
// core_rst_ni: of the streaming core; it drops what the FIFOs hold, but a beat that is offered stays until it is taken.
module horopter_output #(
    parameter int unsigned DEPTH = 256,
    parameter int unsigned IN_FLIGHT = 128,
    parameter bit FAST = 1'b0,
    parameter int unsigned ROW_BITS = 9,
    parameter int unsigned COLUMN_BITS = 9,
    parameter int unsigned WIDTH_BITS = 9,
    parameter int unsigned HEIGHT_BITS = 9
) (
    input  logic                   clk_i,
    input  logic                   rst_ni,
    input  logic                   core_rst_ni,
    input  logic [ WIDTH_BITS-1:0] result_width_i,
    input  logic [HEIGHT_BITS-1:0] result_height_i,
    output logic                   go_o,
    output logic [            1:0] overflow_o,
    // from the stages
    input  logic                   state_valid_i,
    input  logic [            1:0] state_i,
    input  logic                   state_first_i,
    input  logic                   state_last_i,
    input  logic                   state_end_i,
    input  logic                   run_valid_i,
    input  logic [COLUMN_BITS-1:0] run_end_i,
    input  logic [            1:0] run_state_i,
    input  logic                   run_last_i,
    // out
    output logic [            7:0] m_axis_state_tdata,
    output logic                   m_axis_state_tuser,
    output logic                   m_axis_state_tlast,
    output logic                   m_axis_state_tvalid,
    input  logic                   m_axis_state_tready,
    output logic                   state_first_o,
    output logic                   state_end_o,
    output logic [           63:0] m_axis_runs_tdata,
    output logic                   m_axis_runs_tlast,
    output logic                   m_axis_runs_tvalid,
    input  logic                   m_axis_runs_tready,
    output logic                   runs_end_o,
    output logic                   rows_error_o
);
  localparam int unsigned LEVEL = DEPTH - IN_FLIGHT - 8;

  // The core's reset comes a clock after rst_ni: what a FIFO holds must not be offered between them.
  logic fifo_rst_n;
  assign fifo_rst_n = rst_ni && core_rst_ni;
  logic state_almost_full, runs_almost_full, unused_state_ready, unused_runs_ready;
  logic out_state_valid, out_state_ready, out_first, out_last, out_end, out_run_valid, out_run_ready, out_run_last;
  logic [1:0] out_state;
  horopter_axis_fifo #(
      .WIDTH(5),
      .DEPTH(DEPTH),
      .ALMOST_FULL(LEVEL)
  ) u_state_fifo (
      .clk_i(clk_i),
      .rst_ni(fifo_rst_n),
      .s_valid_i(state_valid_i),
      .s_ready_o(unused_state_ready),
      .s_data_i({state_end_i, state_first_i, state_last_i, state_i}),
      .m_valid_o(out_state_valid),
      .m_ready_i(out_state_ready),
      .m_data_o({out_end, out_first, out_last, out_state}),
      .almost_full_o(state_almost_full),
      .overflow_o(overflow_o[0])
  );
  assign state_first_o = out_state_valid && out_state_ready && out_first;
  assign state_end_o = out_state_valid && out_state_ready && out_end;
  horopter_axis_hold #(
      .WIDTH(4)
  ) u_state_hold (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .drop_i(!core_rst_ni),
      .s_valid_i(out_state_valid),
      .s_ready_o(out_state_ready),
      .s_data_i({out_first, out_last, out_state}),
      .m_valid_o(m_axis_state_tvalid),
      .m_ready_i(m_axis_state_tready),
      .m_data_o({m_axis_state_tuser, m_axis_state_tlast, m_axis_state_tdata[1:0]})
  );
  assign m_axis_state_tdata[7:2] = 6'd0;

  // Runs cover their rows, so that the ends tell row and start of each.
  logic [ROW_BITS-1:0] out_row_q;
  logic [ROW_BITS-1:0] before_last_row_q;
  logic last_row_q;  // out_row_q is the result's last row, which is not its first
  logic [COLUMN_BITS-1:0] out_run_start_q, out_run_end, last_column_q;
  logic [1:0] out_run_state;
  logic out_row_ends;
  always_ff @(posedge clk_i) begin
    last_column_q <= COLUMN_BITS'(result_width_i - 1'b1);
    before_last_row_q <= ROW_BITS'(result_height_i - HEIGHT_BITS'(2));
    if (!core_rst_ni) begin
      out_row_q <= '0;
      last_row_q <= 1'b0;
      out_run_start_q <= '0;
    end else if (out_run_valid && out_run_ready) begin
      out_run_start_q <= out_row_ends ? '0 : out_run_end + 1'b1;
      if (out_run_last) out_row_q <= '0;
      else if (out_row_ends) out_row_q <= out_row_q + 1'b1;
      last_row_q <= !out_run_last && (out_row_ends ? out_row_q == before_last_row_q : last_row_q);
    end
  end
  logic written_run;
  logic [COLUMN_BITS+3:0] written_data;
  if (FAST) begin : g_written
    always_ff @(posedge clk_i) begin
      written_run <= core_rst_ni && run_valid_i;
      written_data <= {run_last_i, run_end_i == last_column_q, run_state_i, run_end_i};
    end
  end else begin : g_written
    assign written_run = run_valid_i;
    assign written_data = {run_last_i, run_end_i == last_column_q, run_state_i, run_end_i};
  end
  horopter_axis_fifo #(
      .WIDTH(1 + 1 + 2 + COLUMN_BITS),
      .DEPTH(DEPTH),
      .ALMOST_FULL(LEVEL)
  ) u_runs_fifo (
      .clk_i(clk_i),
      .rst_ni(fifo_rst_n),
      .s_valid_i(written_run),
      .s_ready_o(unused_runs_ready),
      .s_data_i(written_data),
      .m_valid_o(out_run_valid),
      .m_ready_i(out_run_ready),
      .m_data_o({out_run_last, out_row_ends, out_run_state, out_run_end}),
      .almost_full_o(runs_almost_full),
      .overflow_o(overflow_o[1])
  );
  assign runs_end_o = out_run_valid && out_run_ready && out_run_last;
  assign rows_error_o = runs_end_o && (!out_row_ends || !last_row_q);
  logic [ROW_BITS-1:0] sent_row;
  logic [COLUMN_BITS-1:0] sent_start, sent_end;
  logic [1:0] sent_state;
  horopter_axis_hold #(
      .WIDTH(1 + 2 + ROW_BITS + 2 * COLUMN_BITS)
  ) u_runs_hold (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .drop_i(!core_rst_ni),
      .s_valid_i(out_run_valid),
      .s_ready_o(out_run_ready),
      .s_data_i({out_run_last, out_run_state, out_row_q, out_run_start_q, out_run_end}),
      .m_valid_o(m_axis_runs_tvalid),
      .m_ready_i(m_axis_runs_tready),
      .m_data_o({m_axis_runs_tlast, sent_state, sent_row, sent_start, sent_end})
  );
  assign m_axis_runs_tdata = {sent_state, 14'd0, 16'(sent_row), 16'(sent_start), 16'(sent_end)};

  always_ff @(posedge clk_i) go_o <= core_rst_ni && !state_almost_full && !runs_almost_full;
endmodule
