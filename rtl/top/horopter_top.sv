// SPDX-License-Identifier: Apache-2.0
// Horopter: two cameras in, the state of every pixel out.
//
// Sizes come from horopter_profile_pkg (one package per profile, in rtl/generated/<profile>); registers are described in
// rtl/csr/registers.md. One clock; rst_ni synchronous, active low.
//
// s_axis_left, s_axis_right  AXI4-Stream Video, 8-bit grey: tuser = first pixel of a frame, tlast = last of a line.
// s_axis_test                both images in one stream, {right, left}, taken instead of the cameras with MODE.test_input.
// m_axis_state               one beat a pixel of the result in raster order, tdata[1:0] = 0 clear, 1 skin,
//                            2 undecidable, 3 unsupervised; tuser, tlast as above.
// m_axis_runs                the rows as runs: {state[63:62], 14'b0, row[47:32], start[31:16], end[15:0]}, end included,
//                            every row covered completely; tlast = last run of a frame.
// safe_o, unsafe_o           complements, from separate registers; safe only while the last frame was complete, in time,
//                            free of faults and of alarm. Anything but safe_o = 1 and unsafe_o = 0 means not safe.
// heartbeat_o                toggles with every finished frame. frame_done_o: one clock, the FRAME registers are new.
module horopter_top (
    input  logic        clk_i,
    input  logic        rst_ni,
    // AXI4-Lite slave
    input  logic [11:0] s_axil_awaddr,
    input  logic [ 2:0] s_axil_awprot,
    input  logic        s_axil_awvalid,
    output logic        s_axil_awready,
    input  logic [31:0] s_axil_wdata,
    input  logic [ 3:0] s_axil_wstrb,
    input  logic        s_axil_wvalid,
    output logic        s_axil_wready,
    output logic [ 1:0] s_axil_bresp,
    output logic        s_axil_bvalid,
    input  logic        s_axil_bready,
    input  logic [11:0] s_axil_araddr,
    input  logic [ 2:0] s_axil_arprot,
    input  logic        s_axil_arvalid,
    output logic        s_axil_arready,
    output logic [31:0] s_axil_rdata,
    output logic [ 1:0] s_axil_rresp,
    output logic        s_axil_rvalid,
    input  logic        s_axil_rready,
    // left camera
    input  logic [ 7:0] s_axis_left_tdata,
    input  logic        s_axis_left_tuser,
    input  logic        s_axis_left_tlast,
    input  logic        s_axis_left_tvalid,
    output logic        s_axis_left_tready,
    // right camera
    input  logic [ 7:0] s_axis_right_tdata,
    input  logic        s_axis_right_tuser,
    input  logic        s_axis_right_tlast,
    input  logic        s_axis_right_tvalid,
    output logic        s_axis_right_tready,
    // test frames
    input  logic [15:0] s_axis_test_tdata,
    input  logic        s_axis_test_tuser,
    input  logic        s_axis_test_tlast,
    input  logic        s_axis_test_tvalid,
    output logic        s_axis_test_tready,
    // states
    output logic [ 7:0] m_axis_state_tdata,
    output logic        m_axis_state_tuser,
    output logic        m_axis_state_tlast,
    output logic        m_axis_state_tvalid,
    input  logic        m_axis_state_tready,
    // runs
    output logic [63:0] m_axis_runs_tdata,
    output logic        m_axis_runs_tlast,
    output logic        m_axis_runs_tvalid,
    input  logic        m_axis_runs_tready,
    // status
    output logic        safe_o,
    output logic        unsafe_o,
    output logic        heartbeat_o,
    output logic        frame_done_o,
    output logic        irq_o
);
endmodule
