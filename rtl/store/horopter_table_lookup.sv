// SPDX-License-Identifier: Apache-2.0
// The table of a frame: what the raster generator reads it by, kept from one lookup to the next.
//
// take_i: the entry is that of the table asked for. ok_o: it was valid, and made for this width and height; 0 after reset.
module horopter_table_lookup #(
    parameter int unsigned ADDR_BITS = 14
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    input  logic                 take_i,
    input  logic                 valid_i,
    input  logic                 fits_i,  // its size is that of the images
    input  logic [ADDR_BITS-1:0] base_i,
    input  logic [          2:0] nx_i,
    input  logic [          2:0] ny_i,
    input  logic [         11:0] columns_i,
    input  logic                 spans_i,
    output logic                 ok_o,
    output logic [ADDR_BITS-1:0] base_o,
    output logic [          2:0] nx_o,
    output logic [          2:0] ny_o,
    output logic [         11:0] columns_o,
    output logic                 spans_o
);
  logic valid_q, fits_q;
  assign ok_o = valid_q && fits_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (take_i) valid_q <= valid_i;
    if (take_i) begin
      fits_q <= fits_i;
      base_o <= base_i;
      nx_o <= nx_i;
      ny_o <= ny_i;
      columns_o <= columns_i;
      spans_o <= spans_i;
    end
  end
endmodule
