// SPDX-License-Identifier: Apache-2.0
// rtl/prim/horopter_mux.sv for up to 8 words in cells of the ECP5: a look-up table takes two words, PFUMX joins two of
// them, L6MUX21 two of those, so that 8 words take 4 look-up tables a bit. Number select_i beyond the last: word 0 of its
// pair, or 0.
module horopter_mux #(
    parameter int unsigned WIDTH = 2,
    parameter int unsigned COUNT = 8,
    parameter int unsigned SELECT_BITS = COUNT > 1 ? $clog2(COUNT) : 1
) (
    input  logic [  SELECT_BITS-1:0] select_i,
    input  logic [COUNT*WIDTH-1:0] words_i,
    output logic [      WIDTH-1:0] word_o
);
  if (COUNT > 8) begin : g_illegal
    $fatal(1, "horopter_mux: COUNT must be at most 8");
  end
  localparam int unsigned FOURS = COUNT > 4 ? 2 : 1;
  logic [2:0] select;
  assign select = 3'(select_i);
  for (genvar b = 0; b < WIDTH; b++) begin : g_bit
    logic [7:0] words;
    logic [1:0] fours;
    for (genvar i = 0; i < 8; i++) begin : g_word
      if (i < COUNT) assign words[i] = words_i[i*WIDTH+b];
      else assign words[i] = 1'b0;
    end
    for (genvar f = 0; f < FOURS; f++) begin : g_four
      logic low;
      LUT4 #(
          .INIT(16'hCACA)
      ) u_low (
          .A(words[4*f]),
          .B(words[4*f+1]),
          .C(select[0]),
          .D(1'b0),
          .Z(low)
      );
      if (COUNT > 4 * f + 2) begin : g_high
        logic high;
        LUT4 #(
            .INIT(16'hCACA)
        ) u_high (
            .A(words[4*f+2]),
            .B(words[4*f+3]),
            .C(select[0]),
            .D(1'b0),
            .Z(high)
        );
        PFUMX u_four (
            .ALUT(high),
            .BLUT(low),
            .C0(select[1]),
            .Z(fours[f])
        );
      end else begin : g_no_high
        assign fours[f] = low;
      end
    end
    if (FOURS == 2) begin : g_eight
      if (COUNT > 6) begin : g_both
        L6MUX21 u_eight (
            .D0(fours[0]),
            .D1(fours[1]),
            .SD(select[2]),
            .Z(word_o[b])
        );
      end else begin : g_one
        assign word_o[b] = select[2] ? fours[1] : fours[0];
      end
    end else begin : g_one_four
      assign word_o[b] = fours[0];
      assign fours[1] = 1'b0;
    end
  end
endmodule
