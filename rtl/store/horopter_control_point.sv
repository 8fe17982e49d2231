// SPDX-License-Identifier: Apache-2.0
// A control point of a mapping table (horopter/hls/table_format.hpp) for map_expand: the source, (px + 64) * 32, and whether
// there is one and it belongs to the skin. Of a point around the skin the table has half of y, behind those of the skin.
module horopter_control_point (
    input  logic [31:0] word_i,
    output logic [15:0] x_o,
    output logic [15:0] y_o,
    output logic        exists_o,
    output logic        of_skin_o
);
  localparam logic [15:0] AROUND = 16'(horopter_table_pkg::AROUND_SKIN);
  localparam logic [31:0] UNMAPPED = 32'(horopter_table_pkg::UNMAPPED);

  logic [15:0] y;
  logic [14:0] behind;
  assign y = word_i[31:16];
  assign behind = y[14:0] - AROUND[14:0];
  assign x_o = word_i[15:0];
  assign of_skin_o = y < AROUND;
  assign y_o = of_skin_o ? y : {behind, 1'b0};
  assign exists_o = word_i != UNMAPPED;
endmodule
