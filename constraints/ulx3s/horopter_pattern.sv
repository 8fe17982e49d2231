// SPDX-License-Identifier: Apache-2.0
// Two cameras that see a textured scene: blocks of 4x4 px of pseudo-random grey that move by 1 px a frame, for a still
// image is a fault. The right image is the left one shifted by shift_i px, sampled at the start of a frame, and brighter
// by one grey level, for identical images are a fault, too: with the identity as mapping table, everything is in the skin
// at 0 and nothing at more than a few px. One pixel a clock where both streams are taken, then BLANK idle clocks a row.
// Its size is width_i x height_i, sampled all the time.
module horopter_pattern #(
    parameter int unsigned BLANK = 64
) (
    input  logic        clk_i,
    input  logic        rst_ni,
    input  logic [11:0] width_i,
    input  logic [11:0] height_i,
    input  logic [ 4:0] shift_i,
    output logic [ 7:0] m_axis_left_tdata,
    output logic [ 7:0] m_axis_right_tdata,
    output logic        m_axis_tuser,
    output logic        m_axis_tlast,
    output logic        m_axis_left_tvalid,
    output logic        m_axis_right_tvalid,
    input  logic        m_axis_left_tready,
    input  logic        m_axis_right_tready
);
  if (BLANK == 0 || BLANK > 4095) begin : g_illegal
    $fatal(1, "horopter_pattern: BLANK must be 1 to 4095");
  end

  // Grey of a block: its place, multiplied by odd numbers and mixed by exclusive or. 32 to 223, so never saturated.
  function automatic [7:0] grey(input [9:0] bx, input [9:0] by);
    logic [15:0] h;
    h = {bx, 6'd0} ^ {6'd0, by} ^ 16'h9E37;
    h = h + {h[10:0], 5'd0};
    h = h ^ {5'd0, h[15:5]} ^ {3'd0, by, 3'd0};
    h = h + {h[12:0], 3'd0};
    h = h ^ {7'd0, h[15:7]};
    grey = 8'd32 + {1'b0, h[6:0]} + {2'b00, h[12:7]};
  endfunction

  logic [11:0] x_q, y_q, blank_q, origin_q;
  logic [4:0] shift_q;
  logic left_taken_q, right_taken_q, pixel, next, last_row;
  assign pixel = blank_q == 12'd0;
  assign m_axis_left_tdata = grey(10'((x_q + origin_q) >> 2), y_q[11:2]);
  assign m_axis_right_tdata = grey(10'((x_q + origin_q - 12'(shift_q)) >> 2), y_q[11:2]) + 8'd1;
  assign m_axis_tuser = x_q == 12'd0 && y_q == 12'd0;
  assign m_axis_tlast = x_q + 12'd1 >= width_i;
  assign last_row = y_q + 12'd1 >= height_i;
  assign m_axis_left_tvalid = pixel && !left_taken_q;
  assign m_axis_right_tvalid = pixel && !right_taken_q;
  assign next = pixel && (left_taken_q || m_axis_left_tready) && (right_taken_q || m_axis_right_tready);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q <= 12'd0;
      y_q <= 12'd0;
      blank_q <= 12'(BLANK);
      origin_q <= 12'd32;
      left_taken_q <= 1'b0;
      right_taken_q <= 1'b0;
      shift_q <= shift_i;
    end else if (!pixel) begin
      blank_q <= blank_q - 12'd1;
      if (x_q == 12'd0 && y_q == 12'd0) shift_q <= shift_i;
    end else if (next) begin
      left_taken_q <= 1'b0;
      right_taken_q <= 1'b0;
      x_q <= m_axis_tlast ? 12'd0 : x_q + 12'd1;
      if (m_axis_tlast) begin
        y_q <= last_row ? 12'd0 : y_q + 12'd1;
        blank_q <= 12'(BLANK);
        if (last_row) origin_q <= origin_q + 12'd1;
      end
    end else begin
      left_taken_q <= left_taken_q || m_axis_left_tready;
      right_taken_q <= right_taken_q || m_axis_right_tready;
    end
  end
endmodule
