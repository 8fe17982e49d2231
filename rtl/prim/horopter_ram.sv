// SPDX-License-Identifier: Apache-2.0
// Synchronous simple dual-port memory, one clock: one write port, one read port.
//
// Read latency 1 clock (OUTPUT_REGISTER = 0) or 2 (= 1: block memories are slow at their output). The read data holds
// while read_en_i is 0; with OUTPUT_REGISTER the further stages always follow the first.
// Reading an address in the clock in which it is written gives an undefined word, so that no bypass logic is needed.
// PARITY = 1 stores even parity beside each word (the ninth bit of block memories); parity_error_o comes with the data.
// Contents are zero at power-up (with correct parity) and survive reset: there is none.
// ODD = 1 without PARITY: the words bring their own parity, and parity_error_o tells of those with an odd number of ones.
// STEADY = 1 without FAST, for wide words: what is written stands a clock before it is, so that its parity comes from a
// register, and parity_error_o comes a clock behind the data.
// FAST = 1 with OUTPUT_REGISTER: read latency 5, writes a clock later. Registers take the ways to and from the blocks,
// which lie far apart. The parity is that of the word before the last of them. Banks are one block deep, each with its own
// output register, a multiplexer in two steps behind them. Deep memories are laid out as far as they fill it in banks of
// 16384 words of 1-bit blocks, which need no multiplexer, the rest in banks of 2048 words.
module horopter_ram #(
    parameter int unsigned WIDTH = 8,
    parameter int unsigned DEPTH = 1024,
    parameter bit PARITY = 1'b0,
    parameter bit ODD = 1'b0,
    parameter bit OUTPUT_REGISTER = 1'b0,
    parameter bit FAST = 1'b0,
    parameter bit STEADY = 1'b0,
    parameter int unsigned ADDR_BITS = DEPTH > 1 ? $clog2(DEPTH) : 1
) (
    input  logic                 clk_i,
    input  logic                 write_en_i,
    input  logic [ADDR_BITS-1:0] write_addr_i,
    input  logic [    WIDTH-1:0] write_data_i,
    input  logic                 read_en_i,
    input  logic [ADDR_BITS-1:0] read_addr_i,
    output logic [    WIDTH-1:0] read_data_o,
    output logic                 parity_error_o
);
  localparam int unsigned WORD_BITS = WIDTH + (PARITY ? 1 : 0);
  localparam int unsigned DEEP = 16384;
  localparam int unsigned SHALLOW = 2048;
  localparam int unsigned DEEP_BANKS = FAST && OUTPUT_REGISTER ? DEPTH / DEEP : 0;
  localparam int unsigned BANKS = FAST && OUTPUT_REGISTER ? DEEP_BANKS + (DEPTH - DEEP_BANKS * DEEP + SHALLOW - 1) / SHALLOW : 1;
  localparam int unsigned BANK_BITS = BANKS > 1 ? $clog2(BANKS) : 1;

  if (WIDTH == 0 || DEPTH < 2 || ADDR_BITS != $clog2(DEPTH) || (STEADY && FAST) || (ODD && (PARITY || STEADY))) begin : g_illegal
    $fatal(1, "horopter_ram: WIDTH must be positive, DEPTH at least 2, ADDR_BITS left alone, STEADY without FAST, ODD alone");
  end

  logic [WORD_BITS-1:0] write_word;
  logic odd;  // number of ones in the word read
  logic parity;
  if (STEADY) begin : g_parity
    always_ff @(posedge clk_i) parity <= ^write_data_i;
  end else begin : g_no_parity
    assign parity = ^write_data_i;
  end
  assign write_word = WORD_BITS'({parity, write_data_i});
  assign parity_error_o = (PARITY || ODD) && odd;

  if (!(FAST && OUTPUT_REGISTER)) begin : g_one
    logic [WORD_BITS-1:0] out_word;
    horopter_ram_bank #(
        .WIDTH(WORD_BITS),
        .DEPTH(DEPTH),
        .OUTPUT_REGISTER(OUTPUT_REGISTER)
    ) u_bank (
        .clk_i(clk_i),
        .write_en_i(write_en_i),
        .write_addr_i(write_addr_i),
        .write_data_i(write_word),
        .read_en_i(read_en_i),
        .read_addr_i(read_addr_i),
        .read_data_o(out_word)
    );
    assign read_data_o = out_word[WIDTH-1:0];
    if (STEADY) begin : g_odd
      localparam int unsigned PART_BITS = 16;
      localparam int unsigned PARTS = (WORD_BITS + PART_BITS - 1) / PART_BITS;
      logic [PARTS*PART_BITS-1:0] padded;
      logic [PARTS-1:0] odd_parts_q;
      assign padded = (PARTS * PART_BITS)'(out_word);
      always_ff @(posedge clk_i) begin
        for (int unsigned i = 0; i < PARTS; i++) odd_parts_q[i] <= ^padded[i*PART_BITS+:PART_BITS];
      end
      assign odd = ^odd_parts_q;
    end else begin : g_odd_at_once
      assign odd = ^out_word;
    end
  end else begin : g_banks
    // The deep banks come first, so a bank's number follows from the upper bits of the address.
    function automatic [BANK_BITS-1:0] bank_of(input [ADDR_BITS-1:0] addr);
      bank_of = BANK_BITS'(32'(addr) / DEEP);
      if (32'(addr) / DEEP == DEEP_BANKS) bank_of = BANK_BITS'(DEEP_BANKS + 32'(addr) % DEEP / SHALLOW);
    endfunction
    localparam int unsigned IN_BANK_BITS = DEEP_BANKS > 0 ? $clog2(DEEP) : $clog2(DEPTH < SHALLOW ? DEPTH : SHALLOW);
    logic read_en_q;
    logic [IN_BANK_BITS-1:0] write_addr_q;
    logic [ADDR_BITS-1:0] read_addr_q;
    logic [WORD_BITS-1:0] write_word_q;
    // Eight banks share a group.
    localparam int unsigned GROUPS = (BANKS + 7) / 8;
    localparam int unsigned GROUP_BANKS = GROUPS > 1 ? 8 : BANKS;
    localparam int unsigned LAST_BANKS = BANKS - (GROUPS - 1) * GROUP_BANKS;
    logic [BANK_BITS-1:0] read_bank_q, read_bank_q2;
    logic [BANKS*WORD_BITS-1:0] words;
    logic [GROUPS*WORD_BITS-1:0] group_words, group_words_q;
    logic [WORD_BITS-1:0] chosen_word;
    always_ff @(posedge clk_i) begin
      write_addr_q <= write_addr_i[IN_BANK_BITS-1:0];
      write_word_q <= write_word;
      read_en_q <= read_en_i;
      read_addr_q <= read_addr_i;
      if (read_en_q) read_bank_q <= bank_of(read_addr_q);
      read_bank_q2 <= read_bank_q;
      group_words_q <= group_words;
      read_data_o <= chosen_word[WIDTH-1:0];
      odd <= ^chosen_word;
    end
    for (genvar g = 0; g < GROUPS; g++) begin : g_group
      localparam int unsigned COUNT = g < GROUPS - 1 ? GROUP_BANKS : LAST_BANKS;
      horopter_mux #(
          .WIDTH(WORD_BITS),
          .COUNT(COUNT)
      ) u_mux (
          .select_i(read_bank_q2[(COUNT > 1 ? $clog2(COUNT) : 1)-1:0]),
          .words_i(words[g*GROUP_BANKS*WORD_BITS+:COUNT*WORD_BITS]),
          .word_o(group_words[g*WORD_BITS+:WORD_BITS])
      );
    end
    if (GROUPS == 1) begin : g_one_group
      assign chosen_word = group_words_q;
    end else begin : g_groups
      logic [BANK_BITS-4:0] read_group_q;
      always_ff @(posedge clk_i) read_group_q <= read_bank_q2[BANK_BITS-1:3];
      horopter_mux #(
          .WIDTH(WORD_BITS),
          .COUNT(GROUPS)
      ) u_mux (
          .select_i(read_group_q),
          .words_i(group_words_q),
          .word_o(chosen_word)
      );
    end
    for (genvar b = 0; b < BANKS; b++) begin : g_bank
      localparam int unsigned BANK_DEPTH = b < DEEP_BANKS ? DEEP : (DEPTH < SHALLOW ? DEPTH : SHALLOW);
      localparam int unsigned BANK_ADDR_BITS = $clog2(BANK_DEPTH);
`ifdef SYNTHESIS
      localparam int unsigned SLICE = b < DEEP_BANKS ? 1 : WORD_BITS;
`else
      localparam int unsigned SLICE = WORD_BITS;  // the same, in one array
`endif
      logic write_en_q;
      always_ff @(posedge clk_i) write_en_q <= write_en_i && bank_of(write_addr_i) == BANK_BITS'(b);
      for (genvar s = 0; s < WORD_BITS; s += SLICE) begin : g_slice
        horopter_ram_bank #(
            .WIDTH(SLICE),
            .DEPTH(BANK_DEPTH),
            .OUTPUT_REGISTER(1'b1)
        ) u_bank (
            .clk_i(clk_i),
            .write_en_i(write_en_q),
            .write_addr_i(write_addr_q[BANK_ADDR_BITS-1:0]),
            .write_data_i(write_word_q[s+:SLICE]),
            .read_en_i(read_en_q),
            .read_addr_i(read_addr_q[BANK_ADDR_BITS-1:0]),
            .read_data_o(words[b*WORD_BITS+s+:SLICE])
        );
      end
    end
  end
endmodule
