// SPDX-License-Identifier: Apache-2.0
// CRC-32 (reflected, polynomial EDB88320) of one more byte, least significant bit first. It begins with all ones; after
// data and the CRC of it, inverted, low byte first, it is DEBB20E3.
module horopter_crc32 (
    input  logic [31:0] crc_i,
    input  logic [ 7:0] byte_i,
    output logic [31:0] crc_o
);
  always_comb begin
    crc_o = crc_i ^ {24'd0, byte_i};
    for (int i = 0; i < 8; i++) crc_o = crc_o[0] ? (crc_o >> 1) ^ 32'hEDB88320 : crc_o >> 1;
  end
endmodule
