// SPDX-License-Identifier: Apache-2.0
// The runs of one frame, kept for a slow reader: start_i, then the next whole frame from s_axis_runs is written, a word a
// run: {state[31:30], row[23:12], end[11:0]}. As runs cover their rows, the one before tells where one starts.
//
// busy_o: waits for the frame, or writes it. count_o: runs of it, those that found no room included; they are lost.
// read_data_o is that of read_addr_i, a clock later.
module horopter_runs_memory #(
    parameter int unsigned RUNS = 4096,
    parameter int unsigned ADDR_BITS = $clog2(RUNS)
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    input  logic                 start_i,
    output logic                 busy_o,
    output logic [         23:0] count_o,
    input  logic [         63:0] s_axis_runs_tdata,
    input  logic                 s_axis_runs_tlast,
    input  logic                 s_axis_runs_tvalid,
    input  logic [ADDR_BITS-1:0] read_addr_i,
    output logic [         31:0] read_data_o
);
  logic waiting_q, writing_q, first, write, unused;
  logic [ADDR_BITS-1:0] addr;
  assign unused = ^{s_axis_runs_tdata[61:44], s_axis_runs_tdata[15:12]};
  assign first = s_axis_runs_tdata[47:16] == 32'd0;  // of a frame; where another one was cut off, it begins again
  assign write = s_axis_runs_tvalid && (writing_q || waiting_q && first);
  assign addr = first ? '0 : count_o[ADDR_BITS-1:0];
  assign busy_o = waiting_q || writing_q;
  always_ff @(posedge clk_i) begin
    if (write) begin
      waiting_q <= 1'b0;
      writing_q <= !s_axis_runs_tlast;
      count_o <= first ? 24'd1 : count_o + 24'd1;
    end
    if (start_i && !busy_o) begin
      waiting_q <= 1'b1;
      count_o <= 24'd0;
    end
    if (!rst_ni) begin
      waiting_q <= 1'b0;
      writing_q <= 1'b0;
      count_o <= 24'd0;
    end
  end

  logic [31:0] memory[RUNS];
  always_ff @(posedge clk_i) begin
    if (write && (first || 32'(count_o) < RUNS)) begin
      memory[addr] <= {s_axis_runs_tdata[63:62], 6'd0, s_axis_runs_tdata[43:32], s_axis_runs_tdata[11:0]};
    end
    read_data_o <= memory[read_addr_i];
  end
endmodule
