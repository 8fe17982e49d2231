// SPDX-License-Identifier: Apache-2.0
// Map store: a pool of spans and control points in two banks, a directory of the tables in it, and the parser of uploads.
//
// Pool: word64 w = control points of an even (bank 0) and of the odd control row below (bank 1) at one column; the
// banks have their own addresses, so that any two rows above each other are read in one clock. Data comes 2 clocks
// after the address, 5 with FAST. Before a table's control points lie its spans, if it has them: those of an even row of
// pixels and of the odd one below in a word64. Before these lie the words of areas, if it has them, two in a word64; with an
// odd number the last odd bank's word is not used.
//
// Upload: start, then the words of hls/include/horopter/hls/table_format.hpp: header, facts, spans, control points, CRC-32. The
// facts go through the CRC; of them the areas are kept, and the pixels that no rule can judge. A slot becomes invalid when an upload into it starts and valid when its CRC
// is right. A table that the new one overlaps becomes invalid. An upload into a slot or a region in use is refused and
// changes nothing. In use: valid, and selected or made the current output frame, while running.
// With each slot stays the limit of undecidable pixels that was given at its start.
// An upset while an upload is under way makes no table wrong that is valid. Each word of the pool has the slot for which it was
// written, and the parity of its bytes as the CRC saw them: what is read must be of the slot that was looked up. What the
// directory gets is watched, or stored twice, and an entry that was written counts four clocks later, if none of it has changed.
//
// Directory: lookup_i for one clock asks for lookup_slot_i; from three clocks later on the table_* outputs tell,
// until the next lookup. table_ok_o: it was valid, and made for this width and height. table_error_o: what they tell is
// not what was stored (parity). parity_error_o: a word that was read is not as it was uploaded, or of another slot.
// data_ready_o falls for 7 clocks after each word, in which its bytes go through the CRC, and for some 80 after the
// fourth. busy_o: an upload or a word of one is under way, error_o may still change. Reset: all slots invalid.
module horopter_map_store #(
    parameter int unsigned POOL_BYTES = 81920,
    parameter bit PARITY = 1'b1,
    parameter bit FAST = 1'b0,  // see horopter_ram
    parameter int unsigned WORDS = POOL_BYTES / 8,
    parameter int unsigned ADDR_BITS = $clog2(WORDS)
) (
    input  logic                 clk_i,
    input  logic                 rst_ni,
    input  logic                 running_i,
    input  logic [         11:0] width_i,
    input  logic [         11:0] height_i,
    input  logic [          3:0] selected_slot_i,
    input  logic [          3:0] active_slot_i,
    // upload
    input  logic [          3:0] slot_i,
    input  logic [         15:0] base_i,
    input  logic [         23:0] undecidable_limit_i,
    input  logic                 start_valid_i,
    output logic                 start_ready_o,
    input  logic                 data_valid_i,
    output logic                 data_ready_o,
    input  logic [         31:0] data_i,
    output logic                 busy_o,
    output logic [          2:0] error_o,
    output logic [         14:0] valid_o,
    output logic [         31:0] slot_crc_o,  // of slot_i, two clocks later, three at a lookup or the end of an upload
    output logic [         31:0] slot_extent_o,  // of slot_i: {end, base}, as soon as its CRC; not in the walk
    output logic                 bad_upload_o,  // one clock
    output logic                 refused_o,  // one clock
    // directory
    input  logic                 lookup_i,
    input  logic [          3:0] lookup_slot_i,
    output logic                 table_ok_o,
    output logic                 table_error_o,
    output logic [ADDR_BITS-1:0] table_base_o,  // behind its areas
    output logic [         11:0] table_areas_o,  // words of them
    output logic [          2:0] table_nx_o,
    output logic [          2:0] table_ny_o,
    output logic [         11:0] table_columns_o,
    output logic                 table_spans_o,
    output logic [         31:0] table_crc_o,
    output logic [         23:0] table_undecidable_limit_o,
    output logic [         47:0] table_unsupervised_o,  // pixels that thesis (low half), compete cannot judge: words 6, 7
    // pool
    input  logic                 read_en_i,
    input  logic [ADDR_BITS-1:0] even_addr_i,
    input  logic [ADDR_BITS-1:0] odd_addr_i,
    output logic [         31:0] even_data_o,
    output logic [         31:0] odd_data_o,
    output logic                 parity_error_o  // with the data
);
  if (POOL_BYTES < 64 || POOL_BYTES % 8 != 0 || WORDS > 65536 || WORDS != POOL_BYTES / 8) begin : g_illegal
    $fatal(1, "horopter_map_store: POOL_BYTES must be a multiple of 8 from 64 to 512 KiB");
  end

  // A clock late, all of them alike: they come from far away.
  logic running_q, look_q;
  logic [3:0] selected_q, active_q, look_slot_q, lookup_slot_q;
  always_ff @(posedge clk_i) begin
    running_q <= running_i;
    selected_q <= selected_slot_i;
    active_q <= active_slot_i;
    look_q <= rst_ni && lookup_i;
    look_slot_q <= lookup_slot_i;
  end

  localparam logic [2:0] NO_ERROR = 3'd0;
  localparam logic [2:0] IN_USE = 3'd1;
  localparam logic [2:0] BAD_HEADER = 3'd2;
  localparam logic [2:0] TOO_LARGE = 3'd3;
  localparam logic [2:0] WRONG_CRC = 3'd4;
  localparam logic [2:0] NO_SLOT = 3'd5;
  localparam logic [2:0] NOT_STARTED = 3'd6;

  typedef enum logic [3:0] {
    IDLE,
    HEAD0,
    HEAD1,
    HEAD2,
    HEAD3,
    SIZE,  // row pairs × columns, behind areas and spans, and whether the header agrees with itself
    WALK,  // which tables it would overlap
    FACTS,
    DATA,  // spans and control points
    CHECK
  } state_e;
  state_e state_q;

  localparam logic [23:0] FIRST_WORD = {16'(horopter_table_pkg::MAGIC), 8'(horopter_table_pkg::VERSION)};
  localparam logic [2:0] LARGEST_SPACING = 3'(horopter_table_pkg::LARGEST_SPACING_LOG2);
  localparam logic [3:0] NONE = 4'(horopter_table_pkg::SLOTS);  // no slot
  localparam logic [11:0] FEWEST_FACTS = 12'(horopter_table_pkg::FACT_WORDS);

  // CRC-32, reflected, of one more byte, least significant bit first. After a word that is the CRC of all before it, the
  // register holds CRC_RIGHT.
  localparam logic [31:0] CRC_RIGHT = 32'hDEBB20E3;
  function automatic [31:0] crc_byte(input [31:0] crc, input [7:0] data);
    crc_byte = crc ^ {24'd0, data};
    for (int i = 0; i < 8; i++) crc_byte = crc_byte[0] ? (crc_byte >> 1) ^ 32'hEDB88320 : crc_byte >> 1;
  endfunction

  logic [3:0] slot_q;
  logic [2:0] nx_q, ny_q;
  logic spans_q;
  logic [11:0] columns_q, width_q, height_q;
  logic [10:0] pairs_q;
  logic [15:0] base_q;
  logic [31:0] crc_q;
  logic [11:0] facts_q;  // words of facts that are still to come
  logic last_fact_q;  // one is; as of the clock before
  logic [11:0] areas_q;  // words of areas among them at first
  logic area_next_q;  // the next word of facts is one of these
  logic area_follows_q;  // the one after it
  logic [11:0] areas64_q, spans64_q;  // words64 of them, of spans, a clock later
  logic [ADDR_BITS-1:0] spans_base_q;  // behind them, from WALK on
  logic writes_q;  // words go into the pool; as of the clock before: the state changes more than two clocks before the next word
  logic [3:0] fact_q;  // one-hot: which of the first four is next
  logic [47:0] unsupervised_q;
  // By slot; the last one is none: never valid, whatever an upset does, as a power of two needs no bounds.
  logic [14:0] valid_q;
  logic [15:0] valid, invalid, overlap_q;
  logic [14:0] invalid_q;  // the same, said the other way round and stored again
  assign valid = {1'b0, valid_q};
  assign invalid = {1'b1, invalid_q};
  logic [6:0] step_q;
  logic [23:0] size_q, end_q;  // words of control points; address after the last, before that after areas and spans
  logic [ADDR_BITS:0] end_addr;  // the same, once it is known to be in the pool
  logic [ADDR_BITS:0] write_addr_q;
  logic odd_q, complete_q;  // areas and data: the odd bank's is next; all is there
  assign end_addr = end_q[ADDR_BITS:0];
  logic consistent_q, differs_q, bad_size_q, too_large_q;
  logic [11:0] cells_x_q, cells_y_q, expected_columns_q, expected_pairs_q;

  // A word turns once through the CRC, byte by byte, then it is taken.
  logic [31:0] data;
  logic [4:0] byte_q;  // one-hot: bytes that are through; after the fourth the word waits a clock, and is compared
  logic start_q, waiting_q, take, slot_in_use_q, store_entry;  // a start counts a clock later
  // One-hot, clocks since the last word was taken. In the first the directory gets its entry, in the last that counts: until
  // then a change of what was stored would have shown.
  logic [4:0] checks_q;
  logic right_q;  // as of the clock before: that word was the CRC, and nothing has changed that the entry is made of
  logic confirms;  // the entry counts
  logic check_q;  // parity of the word's bytes as they went through the CRC, and of the slot
  logic [3:0] not_slot_q;  // slot_q once more
  logic same_slot_q;
  logic [1:0] changed;  // a register of the header, of its end
  logic overlap_in_use, overlaps_selected_q, overlaps_active_q, in_use_q;  // what the walk found
  logic walked_q;  // as of the clock before, like these
  logic in_use_stays_q;  // that it was decided for
  logic first_bad_q, count_bad_q;  // as the first word, as that with the number of facts it is not possible
  logic data_ready_q;  // of the clock before: later than need be, never too early
  assign data_ready_o = data_ready_q;
  assign start_ready_o = 1'b1;
  always_ff @(posedge clk_i) begin
    data_ready_q <= rst_ni && state_q != SIZE && state_q != WALK && !start_valid_i && !start_q && !(data_valid_i && data_ready_q)
        && !waiting_q && !take && checks_q == 5'd0;
    start_q <= rst_ni && start_valid_i;
    checks_q <= rst_ni && !start_q ? {checks_q[3:0], state_q == CHECK && take} : 5'd0;
    same_slot_q <= slot_q == ~not_slot_q;
    right_q <= crc_q == CRC_RIGHT && same_slot_q && changed == 2'b00;
    if (!waiting_q) check_q <= ^slot_q;
    else if (!byte_q[4]) check_q <= check_q ^ ^data[7:0];
    take <= 1'b0;
    if (!rst_ni || start_q) begin
      waiting_q <= 1'b0;
    end else if (waiting_q) begin
      waiting_q <= !byte_q[4];
      take <= byte_q[4];
    end else begin
      waiting_q <= data_valid_i && data_ready_o;
    end
    byte_q <= waiting_q ? {byte_q[3:0], 1'b0} : 5'd1;
    if (waiting_q && !byte_q[4]) data <= {data[7:0], data[31:8]};
    else if (data_valid_i && data_ready_o) data <= data_i;
    if (start_q) crc_q <= 32'hFFFFFFFF;
    else if (waiting_q && !byte_q[4]) crc_q <= crc_byte(crc_q, data[7:0]);
    first_bad_q <= data[31:8] != FIRST_WORD || data[3] || data[6:4] > LARGEST_SPACING || data[2:0] > LARGEST_SPACING;
    count_bad_q <= data[11:0] < FEWEST_FACTS || (data[11:0] != FEWEST_FACTS) != data[16];
  end
  // As of the clock of a start: slot_i and the selection do not change then nor in the next, and the active slot can only
  // become the selected one.
  always_ff @(posedge clk_i)
    slot_in_use_q <= running_q && (slot_i == selected_q || slot_i == active_q)
        && slot_i != NONE && (valid[slot_i] || confirms);

  logic store_limit;
  assign store_entry = checks_q[0] && right_q;
  assign confirms = checks_q[4] && right_q;

  // One-hot: the slots of a start and of an upload; that a start has none. As of the clock before: a start's is there then.
  logic [15:0] start_mask_q, upload_mask_q, upload_mask2_q;
  logic no_slot_q;
  logic replaces, replaces_q;  // the walk ends, and what overlaps goes, a clock later
  always_ff @(posedge clk_i) begin
    start_mask_q <= 16'd1 << slot_i;
    no_slot_q <= slot_i == NONE;
    upload_mask_q <= 16'd1 << slot_q;
    upload_mask2_q <= 16'd1 << ~not_slot_q;
  end
  assign store_limit = start_q && !no_slot_q && !slot_in_use_q;
  assign replaces = !start_q && state_q == WALK && walked_q && in_use_stays_q && !overlap_in_use;
  always_ff @(posedge clk_i) begin
    replaces_q <= rst_ni && !start_q && (replaces || state_q == FACTS);  // as long as the facts come, should an upset take it back
    for (int unsigned i = 0; i < 15; i++) begin
      valid_q[i] <= rst_ni && ((valid_q[i] && !(replaces_q && overlap_q[i]) && !(start_q && !slot_in_use_q && start_mask_q[i]))
          || (confirms && !start_q && upload_mask_q[i]));
      invalid_q[i] <= !rst_ni
          || ((invalid_q[i] || (replaces_q && overlap_q[i]) || (start_q && !slot_in_use_q && start_mask_q[i]))
          && !(confirms && !start_q && upload_mask2_q[i]));
    end
  end

  // Extent of each table, for the walk, else of slot_i.
  logic [2*ADDR_BITS:0] extent;
  logic [3:0] walk_slot;
  logic extent_error, entry_error, limit_error, unsupervised_error;
  horopter_ram #(
      .WIDTH(2 * ADDR_BITS + 1),
      .DEPTH(16),
      .PARITY(PARITY),
      .STEADY(1'b1)
  ) u_extent (
      .clk_i(clk_i),
      .write_en_i(store_entry),
      .write_addr_i(slot_q),
      .write_data_i({end_addr, base_q[ADDR_BITS-1:0]}),
      .read_en_i(!store_entry),
      .read_addr_i(state_q == WALK ? walk_slot : slot_i),
      .read_data_o(extent),
      .parity_error_o(extent_error)
  );
  logic begins_before_q, ends_behind_q, overlaps_q, slot_valid_q;
  assign slot_extent_o = slot_valid_q ? {16'(extent[2*ADDR_BITS:ADDR_BITS]), 16'(extent[ADDR_BITS-1:0])} : 32'd0;
  assign walk_slot = step_q[5:2];
  always_ff @(posedge clk_i) begin
    begins_before_q <= {1'b0, extent[ADDR_BITS-1:0]} < end_addr;
    ends_behind_q <= extent[2*ADDR_BITS:ADDR_BITS] > {1'b0, base_q[ADDR_BITS-1:0]};
    overlaps_q <= valid[walk_slot] && (extent_error || (begins_before_q && ends_behind_q));
  end

  // Decided when the walk is over, for what is in use then: the selection may change during it.
  always_ff @(posedge clk_i) begin
    in_use_stays_q <= {running_i, selected_slot_i, active_slot_i} == {running_q, selected_q, active_q};
    in_use_q <= running_q;
    overlaps_selected_q <= overlap_q[selected_q];
    overlaps_active_q <= overlap_q[active_q];
    walked_q <= state_q == WALK && step_q[6];
  end
  assign overlap_in_use = in_use_q && (overlaps_selected_q || overlaps_active_q);

  // The error follows a clock behind the state: which one it would be, and whether it is.
  logic decided_q;
  logic [2:0] decision_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) error_o <= NO_ERROR;
    else if (decided_q) error_o <= decision_q;
    case (state_q)
      HEAD0, HEAD3: decision_q <= BAD_HEADER;
      SIZE: decision_q <= bad_size_q ? BAD_HEADER : TOO_LARGE;
      WALK: decision_q <= IN_USE;
      CHECK: decision_q <= WRONG_CRC;
      default: decision_q <= NOT_STARTED;
    endcase
    if (start_q) decision_q <= no_slot_q ? NO_SLOT : slot_in_use_q ? IN_USE : NO_ERROR;
  end
  always_ff @(posedge clk_i) begin
    bad_upload_o <= 1'b0;
    refused_o <= 1'b0;
    decided_q <= 1'b0;
    if (!rst_ni) begin
      state_q <= IDLE;
    end else if (start_q) begin
      decided_q <= 1'b1;
      if (no_slot_q) begin
        state_q <= IDLE;
        bad_upload_o <= 1'b1;
      end else if (slot_in_use_q) begin
        state_q <= IDLE;
        refused_o <= 1'b1;
      end else begin
        state_q <= HEAD0;
      end
    end else begin
      case (state_q)
        HEAD0:
        if (take) begin
          if (first_bad_q) begin
            state_q <= IDLE;
            decided_q <= 1'b1;
            bad_upload_o <= 1'b1;
          end else begin
            state_q <= HEAD1;
          end
        end

        HEAD1: if (take) state_q <= HEAD2;

        HEAD2: if (take) state_q <= HEAD3;

        HEAD3:
        if (take) begin
          if (count_bad_q) begin
            state_q <= IDLE;
            decided_q <= 1'b1;
            bad_upload_o <= 1'b1;
          end else begin
            state_q <= SIZE;
          end
        end

        SIZE:
        if (step_q == 7'd14) begin
          if (bad_size_q || too_large_q) begin
            state_q <= IDLE;
            decided_q <= 1'b1;
            bad_upload_o <= 1'b1;
          end else begin
            state_q <= WALK;
          end
        end

        WALK:
        if (walked_q && in_use_stays_q) begin
          if (overlap_in_use) begin
            state_q <= IDLE;
            decided_q <= 1'b1;
            refused_o <= 1'b1;
          end else begin
            state_q <= FACTS;
          end
        end

        FACTS: if (take && last_fact_q) state_q <= DATA;

        DATA: if (complete_q) state_q <= CHECK;  // words are more than two clocks apart

        CHECK:
        if (checks_q[4]) begin
          state_q <= IDLE;
          if (!right_q) begin
            decided_q <= 1'b1;
            bad_upload_o <= 1'b1;
          end
        end

        default:  // IDLE
        if (take) decided_q <= error_o == NO_ERROR;
      endcase
    end
  end

  // What the states work with; none of it needs a reset, a start sets the state that sets it.
  logic [6:0] halves_x_q, halves_y_q;  // bit 0: this step halves; one bit for each halving
  logic adds_areas_q, adds_spans_q, adds_size_q;  // what the end grows by, in the clock after the next
  logic [23:0] growth_q;
  logic sized_q;  // the image's size came in the clock before
  always_ff @(posedge clk_i) begin
    if (start_q) begin
      slot_q <= slot_i;
      not_slot_q <= ~slot_i;
      base_q <= base_i;
    end
    halves_x_q <= state_q == SIZE ? halves_x_q >> 1 : ~(7'h7F << nx_q);
    halves_y_q <= state_q == SIZE ? halves_y_q >> 1 : ~(7'h7F << ny_q);
    adds_areas_q <= state_q == SIZE && step_q == 7'd0;
    adds_spans_q <= state_q == SIZE && step_q == 7'd1;
    adds_size_q <= state_q == SIZE && step_q == 7'd10;
    growth_q <= adds_areas_q ? 24'(areas64_q) : adds_spans_q ? 24'(spans64_q) : adds_size_q ? size_q : 24'd0;
    // With c = (size - 1) >> n there are c + 1 cells, c + 2 control points; in pairs c / 2 + 1, and one more if c is odd.
    expected_columns_q <= cells_x_q + 12'd2;
    expected_pairs_q <= 12'(cells_y_q[11:1]) + 12'd1 + 12'(cells_y_q[0]);
    differs_q <= columns_q != expected_columns_q || 12'(pairs_q) != expected_pairs_q;
    bad_size_q <= !consistent_q || differs_q || size_q == 24'd0;
    too_large_q <= 32'(end_q) > WORDS;
    areas64_q <= 12'((13'(areas_q) + 13'd1) >> 1);
    spans_base_q <= base_q[ADDR_BITS-1:0] + ADDR_BITS'(areas64_q);
    complete_q <= write_addr_q == end_addr;
    last_fact_q <= facts_q == 12'd1;
    area_follows_q <= facts_q == areas_q + 12'd1;
    case (state_q)
      HEAD0:
      if (take) begin
        nx_q <= data[6:4];
        ny_q <= data[2:0];
        spans_q <= data[7];
      end

      HEAD1:
      if (take) begin
        columns_q <= data[11:0];
        pairs_q <= data[26:16];
        consistent_q <= data[15:12] == 4'd0 && data[31:27] == 5'd0;
      end

      HEAD2:
      if (take) begin
        width_q <= data[11:0];
        height_q <= data[27:16];
        if (data[15:12] != 4'd0 || data[31:28] != 4'd0) consistent_q <= 1'b0;
        step_q <= 7'd0;
      end

      HEAD3:
      if (take) begin
        facts_q <= data[11:0];
        fact_q <= 4'd1;
        areas_q <= data[11:0] - FEWEST_FACTS;
        area_next_q <= 1'b0;
      end

      // One bit of the product and one place of the shifts a clock.
      SIZE: begin
        step_q <= step_q == 7'd14 ? 7'd0 : step_q + 7'd1;
        overlap_q <= 16'd0;
        if (step_q < 7'd11) begin
          pairs_q <= {pairs_q[9:0], pairs_q[10]};  // back in place after all 11
          size_q <= {size_q[22:0], 1'b0} + (pairs_q[10] ? 24'(columns_q) : 24'd0);
        end
        if (halves_x_q[0]) cells_x_q <= {1'b0, cells_x_q[11:1]};
        if (halves_y_q[0]) cells_y_q <= {1'b0, cells_y_q[11:1]};
        end_q <= end_q + growth_q;
      end

      // Four clocks a slot: read, compare, judge, note.
      WALK: begin
        if (!step_q[6]) step_q <= step_q + 7'd1;
        if (step_q[1:0] == 2'd3 && overlaps_q) overlap_q <= overlap_q | 16'd1 << walk_slot;
        write_addr_q <= {1'b0, base_q[ADDR_BITS-1:0]};
        odd_q <= 1'b0;
      end

      FACTS:
      if (take) begin
        facts_q <= facts_q - 12'd1;
        fact_q <= {fact_q[2:0], 1'b0};
        area_next_q <= area_next_q || area_follows_q;
        if (fact_q[2]) unsupervised_q[23:0] <= data[23:0];
        if (fact_q[3]) unsupervised_q[47:24] <= data[23:0];
      end

      default: ;
    endcase
    if (take && writes_q) begin
      odd_q <= !odd_q && !last_fact_q;
      if (odd_q || last_fact_q) write_addr_q <= write_addr_q + 1'b1;
    end
    // Words are more than two clocks apart.
    sized_q <= state_q == HEAD2 && take;
    if (sized_q) begin
      if (width_q == 12'd0 || height_q == 12'd0) consistent_q <= 1'b0;
      cells_x_q <= width_q - 12'd1;
      cells_y_q <= height_q - 12'd1;
      size_q <= 24'd0;
      spans64_q <= spans_q ? 12'(height_q[11:1]) + 12'(height_q[0]) : 12'd0;
      end_q <= 24'(base_q);
    end
  end
  horopter_guard #(
      .WIDTH(59)
  ) u_header_guard (
      .clk_i(clk_i),
      .write_i(state_q == HEAD0 || state_q == HEAD1 || state_q == HEAD2),
      .value_i({base_q, nx_q, ny_q, spans_q, columns_q, width_q, height_q}),
      .error_o(changed[0])
  );
  horopter_guard #(
      .WIDTH(ADDR_BITS + 13)
  ) u_end_guard (
      .clk_i(clk_i),
      .write_i(state_q == HEAD3 || state_q == SIZE),
      .value_i({end_addr, areas_q}),
      .error_o(changed[1])
  );
  assign busy_o = state_q != IDLE || start_q || waiting_q || take || decided_q;
  assign valid_o = valid_q;

  // --- directory: read by a lookup, else of slot_i, what its CRC is ---
  localparam int unsigned ENTRY_BITS = 32 + 12 + 1 + 12 + 12 + 12 + 3 + 3 + ADDR_BITS;
  logic [ENTRY_BITS-1:0] entry;
  logic [31:0] entry_crc;
  logic [11:0] entry_width, entry_height, entry_columns, entry_areas;
  logic [2:0] entry_ny, entry_nx;
  logic [ADDR_BITS-1:0] entry_base;
  logic entry_spans, lookup_q, looked_up_q, lookup_valid_q, slot_read_q;
  horopter_ram #(
      .WIDTH(ENTRY_BITS),
      .DEPTH(16),
      .PARITY(PARITY),
      .STEADY(1'b1)
  ) u_entry (
      .clk_i(clk_i),
      .write_en_i(store_entry),
      .write_addr_i(slot_q),
      .write_data_i({data, areas_q, spans_q, height_q, width_q, columns_q, ny_q, nx_q, spans_base_q}),
      .read_en_i(look_q || !store_entry),
      .read_addr_i(look_q ? look_slot_q : slot_i),
      .read_data_o(entry),
      .parity_error_o(entry_error)
  );
  assign {entry_crc, entry_areas, entry_spans, entry_height, entry_width, entry_columns, entry_ny, entry_nx, entry_base} = entry;
  always_ff @(posedge clk_i) begin
    lookup_q <= rst_ni && look_q;
    lookup_slot_q <= look_slot_q;
    lookup_valid_q <= valid[look_slot_q];
    if (lookup_q) table_crc_o <= entry_crc;
    if (lookup_q) table_areas_o <= entry_areas;
    slot_read_q <= !look_q && !store_entry;
    slot_valid_q <= valid[slot_i];
    if (slot_read_q && !slot_valid_q) slot_crc_o <= 32'd0;
    else if (slot_read_q) slot_crc_o <= entry_crc;
  end

  horopter_table_lookup #(
      .ADDR_BITS(ADDR_BITS)
  ) u_lookup (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .take_i(lookup_q),
      // Before: what is stored in the clock of the lookup counts from the next one on. Still: what is replaced goes a clock
      // after that was decided. Each asks a copy of its own.
      .valid_i(lookup_valid_q && !invalid[lookup_slot_q]),
      .fits_i(entry_width == width_i && entry_height == height_i),
      .base_i(entry_base),
      .nx_i(entry_nx),
      .ny_i(entry_ny),
      .columns_i(entry_columns),
      .spans_i(entry_spans),
      .ok_o(table_ok_o),
      .base_o(table_base_o),
      .nx_o(table_nx_o),
      .ny_o(table_ny_o),
      .columns_o(table_columns_o),
      .spans_o(table_spans_o)
  );

  // Kept from the start on, while the slot is invalid; between lookups the output stays.
  horopter_ram #(
      .WIDTH(24),
      .DEPTH(16),
      .PARITY(PARITY)
  ) u_limit (
      .clk_i(clk_i),
      .write_en_i(store_limit),
      .write_addr_i(slot_i),
      .write_data_i(undecidable_limit_i),
      .read_en_i(look_q),
      .read_addr_i(look_slot_q),
      .read_data_o(table_undecidable_limit_o),
      .parity_error_o(limit_error)
  );
  horopter_ram #(
      .WIDTH(48),
      .DEPTH(16),
      .PARITY(PARITY),
      .STEADY(1'b1)
  ) u_unsupervised (
      .clk_i(clk_i),
      .write_en_i(store_entry),
      .write_addr_i(slot_q),
      .write_data_i(unsupervised_q),
      .read_en_i(look_q),
      .read_addr_i(look_slot_q),
      .read_data_o(table_unsupervised_o),
      .parity_error_o(unsupervised_error)
  );

  // From the directory into the outputs, and as long as they stay.
  logic entry_error_q;
  logic [1:0] guard_error;
  always_ff @(posedge clk_i) begin
    looked_up_q <= lookup_q;
    if (looked_up_q) entry_error_q <= entry_error;
    table_error_o <= rst_ni && table_ok_o && !looked_up_q && (entry_error_q || limit_error || unsupervised_error || guard_error != 2'b00);
  end
  horopter_guard #(
      .WIDTH(32)
  ) u_crc_guard (
      .clk_i(clk_i),
      .write_i(lookup_q),
      .value_i(table_crc_o),
      .error_o(guard_error[0])
  );
  horopter_guard #(
      .WIDTH(ADDR_BITS + 31)
  ) u_geometry_guard (
      .clk_i(clk_i),
      .write_i(lookup_q),
      .value_i({table_base_o, table_nx_o, table_ny_o, table_columns_o, table_spans_o, table_areas_o}),
      .error_o(guard_error[1])
  );

  // --- pool ---
  localparam int unsigned WORD_BITS = PARITY ? 36 : 32;
  logic write, write_even, write_odd, even_odd, odd_odd;
  logic [WORD_BITS-1:0] word, even_word, odd_word;
  logic [3:0] read_slot_q;  // of the last lookup
  always_ff @(posedge clk_i) if (lookup_q) read_slot_q <= lookup_slot_q;
  // Three bits of the slot stand beside the data; all of the word has odd parity if the fourth is 1.
  assign word = WORD_BITS'({slot_q[2:0], check_q, data});
  assign {odd_data_o, even_data_o} = {odd_word[31:0], even_word[31:0]};
  if (PARITY) begin : g_foreign
    assign parity_error_o = even_word[35:33] != read_slot_q[2:0] || odd_word[35:33] != read_slot_q[2:0] || even_odd != read_slot_q[3]
        || odd_odd != read_slot_q[3];
    logic unused_checks;  // counted in even_odd and odd_odd
    assign unused_checks = ^{even_word[32], odd_word[32]};
  end else begin : g_not_foreign
    logic unused_foreign;
    assign unused_foreign = ^{check_q, read_slot_q, even_odd, odd_odd};
    assign parity_error_o = 1'b0;
  end
  always_ff @(posedge clk_i) writes_q <= state_q == DATA || (state_q == FACTS && area_next_q);
  assign write = take && writes_q;
  assign write_even = write && !odd_q;
  assign write_odd = write && (odd_q || last_fact_q);  // what is read beside a last word of areas, too
  horopter_ram #(
      .WIDTH(WORD_BITS),
      .DEPTH(WORDS),
      .ODD(PARITY),
      .OUTPUT_REGISTER(1'b1),
      .FAST(FAST)
  ) u_even (
      .clk_i(clk_i),
      .write_en_i(write_even),
      .write_addr_i(write_addr_q[ADDR_BITS-1:0]),
      .write_data_i(word),
      .read_en_i(read_en_i),
      .read_addr_i(even_addr_i),
      .read_data_o(even_word),
      .parity_error_o(even_odd)
  );
  horopter_ram #(
      .WIDTH(WORD_BITS),
      .DEPTH(WORDS),
      .ODD(PARITY),
      .OUTPUT_REGISTER(1'b1),
      .FAST(FAST)
  ) u_odd (
      .clk_i(clk_i),
      .write_en_i(write_odd),
      .write_addr_i(write_addr_q[ADDR_BITS-1:0]),
      .write_data_i(word),
      .read_en_i(read_en_i),
      .read_addr_i(odd_addr_i),
      .read_data_o(odd_word),
      .parity_error_o(odd_odd)
  );
endmodule
