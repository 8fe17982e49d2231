// SPDX-License-Identifier: Apache-2.0
// horopter_map_store's switch, by induction: a table in use stays as it was uploaded.
//
// One arbitrary (constant, unknown) slot is followed, with the region that its last successful upload filled. While it
// is valid, nothing writes into that region or, while it is in use, its limit; while it is valid and in use, it stays
// valid. What is looked up is in use and was valid. The error changes only while the store is busy. Taken for granted: the
// directory's memory reads what was written (as horopter_ram does).
module formal_map_store (
    input logic        clk_i,
    input logic        rst_ni,
    input logic        running,
    input logic [11:0] width,
    input logic [11:0] height,
    input logic [ 3:0] selected_slot,
    input logic [ 3:0] active_slot,
    input logic [ 3:0] slot,
    input logic [15:0] base,
    input logic        start_valid,
    input logic        data_valid,
    input logic [31:0] data,
    input logic        lookup,
    input logic [23:0] limit
);
  logic start_ready, data_ready, busy, bad_upload, refused, table_ok;
  logic [2:0] error;
  logic [14:0] valid;
  horopter_map_store #(
      .POOL_BYTES(128),
      .PARITY(1'b0)
  ) dut (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .running_i(running),
      .width_i(width),
      .height_i(height),
      .selected_slot_i(selected_slot),
      .active_slot_i(active_slot),
      .slot_i(slot),
      .base_i(base),
      .undecidable_limit_i(limit),
      .start_valid_i(start_valid),
      .start_ready_o(start_ready),
      .data_valid_i(data_valid),
      .data_ready_o(data_ready),
      .data_i(data),
      .busy_o(busy),
      .error_o(error),
      .valid_o(valid),
      .slot_crc_o(),
      .slot_extent_o(),
      .bad_upload_o(bad_upload),
      .refused_o(refused),
      .lookup_i(lookup),
      .lookup_slot_i(selected_slot),
      .table_ok_o(table_ok),
      .table_base_o(),
      .table_areas_o(),
      .table_nx_o(),
      .table_ny_o(),
      .table_columns_o(),
      .table_spans_o(),
      .table_crc_o(),
      .table_undecidable_limit_o(),
      .table_unsupervised_o(),
      .read_en_i(1'b0),
      .even_addr_i('0),
      .odd_addr_i('0),
      .even_data_o(),
      .odd_data_o(),
      .parity_error_o()
  );
  // Registers of the device, joined when the hierarchy is flattened (yosys: hierconn).
  (* hierconn *) wire [3:0] \dut.state_q ;
  (* hierconn *) wire [3:0] \dut.slot_q ;
  (* hierconn *) wire [15:0] \dut.base_q ;
  (* hierconn *) wire \dut.spans_q ;
  (* hierconn *) wire [11:0] \dut.areas_q ;
  (* hierconn *) wire [11:0] \dut.facts_q ;
  (* hierconn *) wire \dut.area_next_q ;
  (* hierconn *) wire [11:0] \dut.height_q ;
  (* hierconn *) wire [23:0] \dut.size_q ;
  (* hierconn *) wire [23:0] \dut.end_q ;
  (* hierconn *) wire [11:0] \dut.areas64_q ;
  (* hierconn *) wire [11:0] \dut.spans64_q ;
  (* hierconn *) wire \dut.complete_q ;
  (* hierconn *) wire [4:0] \dut.write_addr_q ;
  (* hierconn *) wire \dut.odd_q ;
  (* hierconn *) wire [6:0] \dut.step_q ;
  (* hierconn *) wire \dut.adds_areas_q ;
  (* hierconn *) wire \dut.adds_spans_q ;
  (* hierconn *) wire \dut.adds_size_q ;
  (* hierconn *) wire [23:0] \dut.growth_q ;
  (* hierconn *) wire \dut.sized_q ;
  (* hierconn *) wire \dut.writes_q ;
  (* hierconn *) wire \dut.running_q ;
  (* hierconn *) wire \dut.last_fact_q ;
  (* hierconn *) wire \dut.begins_before_q ;
  (* hierconn *) wire \dut.ends_behind_q ;
  (* hierconn *) wire \dut.overlaps_q ;
  (* hierconn *) wire \dut.bad_size_q ;
  (* hierconn *) wire \dut.too_large_q ;
  (* hierconn *) wire [15:0] \dut.overlap_q ;
  (* hierconn *) wire \dut.start_q ;
  (* hierconn *) wire [4:0] \dut.checks_q ;
  (* hierconn *) wire \dut.confirms ;
  (* hierconn *) wire [3:0] \dut.not_slot_q ;
  (* hierconn *) wire [14:0] \dut.invalid_q ;
  (* hierconn *) wire [15:0] \dut.upload_mask2_q ;
  (* hierconn *) wire \dut.waiting_q ;
  (* hierconn *) wire \dut.take ;
  (* hierconn *) wire [31:0] \dut.data ;
  (* hierconn *) wire [15:0] \dut.start_mask_q ;
  (* hierconn *) wire \dut.no_slot_q ;
  (* hierconn *) wire [15:0] \dut.upload_mask_q ;
  (* hierconn *) wire [3:0] \dut.selected_q ;
  (* hierconn *) wire [3:0] \dut.active_q ;
  (* hierconn *) wire \dut.replaces_q ;
  (* hierconn *) wire \dut.look_q ;
  (* hierconn *) wire \dut.lookup_q ;
  (* hierconn *) wire [3:0] \dut.look_slot_q ;
  (* hierconn *) wire [3:0] \dut.lookup_slot_q ;
  (* hierconn *) wire [8:0] \dut.extent ;
  (* hierconn *) wire \dut.store_entry ;
  (* hierconn *) wire \dut.store_limit ;
  (* hierconn *) wire \dut.write_even ;
  (* hierconn *) wire \dut.write_odd ;
  localparam logic [3:0] IDLE = 4'd0, HEAD3 = 4'd4, SIZE = 4'd5, WALK = 4'd6, FACTS = 4'd7, DATA = 4'd8, CHECK = 4'd9;

  (* anyconst *) logic [3:0] watched;
  logic [3:0] first;  // region of the watched table
  logic [4:0] behind;
  logic past_valid = 1'b0, past_in_use = 1'b0, past_lookup_valid = 1'b0;
  logic [3:0] past_slot, past_selected, past_active;
  logic [31:0] past_data;
  logic past_take = 1'b0, past_stored = 1'b0;  // of the watched slot
  logic past_idle = 1'b0;
  logic [2:0] past_error;
  // A clock ago, which is what the device works with; two clocks ago.
  logic past_running = 1'b0, before_running = 1'b0;
  logic [3:0] before_selected;
  (* hierconn *) wire \dut.u_lookup.valid_i ;
  logic looked_up_valid;
  assign looked_up_valid = \dut.u_lookup.valid_i ;
  logic stays;  // valid, and not about to be replaced
  assign stays = valid[watched] && !(\dut.replaces_q && \dut.overlap_q [watched]);
  logic in_use;
  assign in_use = past_running && stays && (watched == past_selected || watched == past_active);

  always @(posedge clk_i) begin
    past_valid <= 1'b1;
    past_slot <= slot;
    past_data <= \dut.data ;
    past_stored <= rst_ni && \dut.store_entry && \dut.slot_q == watched;
    past_take <= rst_ni && \dut.take ;
    past_idle <= rst_ni && !busy;
    past_error <= error;
    past_selected <= selected_slot;
    past_active <= active_slot;
    past_running <= running;
    before_running <= past_running;
    before_selected <= past_selected;
    past_in_use <= rst_ni && in_use;
    if (\dut.confirms && \dut.slot_q == watched) begin
      first <= \dut.base_q [3:0];
      behind <= \dut.end_q [4:0];
    end
  end

  logic [23:0] spans_words, behind_spans;  // where the upload's control points begin
  assign spans_words = \dut.spans_q ? 24'(\dut.height_q [11:1]) + 24'(\dut.height_q [0]) : 24'd0;
  assign behind_spans = 24'(\dut.base_q ) + (24'(\dut.areas_q ) + 24'd1) / 2 + spans_words;
  logic [11:0] areas_written;
  assign areas_written = \dut.area_next_q ? \dut.areas_q - \dut.facts_q : 12'd0;
  logic apart;  // the upload's region and the watched table's
  assign apart = 24'(behind) <= 24'(\dut.base_q ) || 24'(first) >= \dut.end_q ;

  always @(*) begin
    if (!past_valid) assume (!rst_ni);
    assume (watched != 4'd15);
    // The directory's memory.
    if (\dut.state_q == WALK && \dut.step_q [1:0] != 2'd0 && \dut.step_q [5:2] == watched && valid[watched])
      assume (\dut.extent == {behind, first});
    // The bus: a start's slot and the selection were there before it counts; a begin makes the selected slot the active one.
    if (\dut.start_q )
      assume (slot == past_slot && selected_slot == past_selected && past_selected == before_selected && running == past_running && past_running == before_running);
    assume (active_slot == past_active || active_slot == past_selected || (active_slot == 4'd15 && !past_running));

    if (past_valid) begin
      // --- invariants that lead to the properties ---
      if (valid[watched]) assert (5'(first) < behind && behind <= 5'd16);
      if (\dut.look_q ) assert (\dut.look_slot_q == past_selected);
      assert (\dut.selected_q == past_selected && \dut.active_q == past_active);
      if (\dut.start_q ) assert (\dut.start_mask_q == 16'd1 << slot && \dut.no_slot_q == (slot == 4'd15));
      if (\dut.state_q != IDLE) assert (\dut.not_slot_q == ~\dut.slot_q );
      assert (\dut.invalid_q == ~valid);
      if (\dut.checks_q [4]) assert (\dut.upload_mask_q == 16'd1 << \dut.slot_q && \dut.upload_mask2_q == \dut.upload_mask_q );
      assert (\dut.running_q == past_running);
      assert (!(\dut.waiting_q && \dut.take ));
      if (\dut.take ) assert (\dut.writes_q == (\dut.state_q == DATA || (\dut.state_q == FACTS && \dut.area_next_q )));
      if (\dut.state_q == SIZE || \dut.state_q == WALK) assert (!\dut.waiting_q && !\dut.take );
      if (data_ready)
        assert (\dut.state_q != SIZE && \dut.state_q != WALK && !\dut.start_q && !\dut.waiting_q && !\dut.take && \dut.checks_q == 5'd0);
      if (\dut.checks_q [0]) assert (past_take);
      if (past_take) assert (\dut.data == past_data && !data_ready && !\dut.waiting_q );
      assert ((\dut.checks_q & (\dut.checks_q - 5'd1)) == 5'd0);
      if (\dut.checks_q != 5'd0) assert (\dut.state_q == CHECK && !\dut.waiting_q && !\dut.take );
      if (\dut.state_q == SIZE) begin
        assert (\dut.step_q <= 7'd14);
        assert (\dut.adds_areas_q == (\dut.step_q == 7'd1) && \dut.adds_spans_q == (\dut.step_q == 7'd2) && \dut.adds_size_q == (\dut.step_q == 7'd11));
        if (\dut.step_q < 7'd12) assert (32'(\dut.size_q ) + 32'd4095 <= 32'd4095 << \dut.step_q );
        if (\dut.step_q < 7'd13)
          assert (\dut.end_q == (\dut.step_q <= 7'd2 ? 24'(\dut.base_q ) : \dut.step_q == 7'd3 ? behind_spans - spans_words : behind_spans));
        case (\dut.step_q )
          7'd2: assert (\dut.growth_q == (24'(\dut.areas_q ) + 24'd1) / 2);
          7'd3: assert (\dut.growth_q == spans_words);
          7'd12: assert (\dut.growth_q == \dut.size_q );
          default: assert (\dut.growth_q == 24'd0);
        endcase
      end
      if (\dut.state_q == SIZE && \dut.step_q == 7'd14) assert (\dut.too_large_q == (\dut.end_q > 24'd16) && (\dut.bad_size_q || \dut.size_q != 24'd0));
      if (\dut.state_q == SIZE && \dut.step_q >= 7'd13 || \dut.state_q == WALK || \dut.state_q == FACTS)
        assert (\dut.end_q == \dut.size_q + behind_spans);
      if (\dut.state_q == SIZE && \dut.step_q >= 7'd12 || \dut.state_q == WALK || \dut.state_q == FACTS) assert (\dut.size_q < 24'd8388608);
      if (\dut.state_q == WALK || \dut.state_q == FACTS) assert (\dut.size_q != 24'd0);
      if (\dut.state_q == WALK) assert (\dut.step_q <= 7'd64);
      assert (\dut.state_q <= CHECK);
      if (\dut.state_q >= WALK)
        assert (\dut.end_q <= 24'd16 && 24'(\dut.base_q ) < \dut.end_q );
      if (\dut.state_q != IDLE) assert (\dut.slot_q != 4'd15 && !valid[\dut.slot_q ]);
      if (\dut.state_q == WALK && valid[watched]) begin
        assert (\dut.overlap_q [watched] == (\dut.step_q > {1'b0, watched, 2'b11} && !apart));
        if (\dut.step_q == {1'b0, watched, 2'b10}) assert ((\dut.begins_before_q && \dut.ends_behind_q ) == !apart);
        if (\dut.step_q == {1'b0, watched, 2'b11}) assert (\dut.overlaps_q == !apart);
      end
      if (\dut.state_q == DATA) begin
        assert (24'(\dut.write_addr_q ) <= \dut.end_q && 16'(\dut.write_addr_q ) >= \dut.base_q );
        if (24'(\dut.write_addr_q ) == \dut.end_q )
          assert (!\dut.odd_q && !\dut.take && !\dut.waiting_q && (\dut.complete_q || !data_ready));
        else assert (!\dut.complete_q );
      end
      if (\dut.state_q == WALK && \dut.step_q >= 7'd1) assert (16'(\dut.write_addr_q ) == \dut.base_q );
      if (\dut.state_q == WALK && \dut.step_q >= 7'd2) assert (!\dut.complete_q );
      if (\dut.state_q == HEAD3 && \dut.sized_q ) assert (!\dut.waiting_q && !\dut.take && !data_ready);
      if (\dut.state_q == HEAD3 && !\dut.sized_q ) assert (\dut.end_q == 24'(\dut.base_q ) && \dut.size_q == 24'd0);
      if (\dut.state_q == HEAD3) assert (\dut.step_q == 7'd0);
      if ((\dut.state_q == HEAD3 && !\dut.sized_q ) || \dut.state_q == SIZE) assert (24'(\dut.spans64_q ) == spans_words);
      if (\dut.state_q == SIZE && \dut.step_q != 7'd0) assert (24'(\dut.areas64_q ) == (24'(\dut.areas_q ) + 24'd1) / 2);
      if (\dut.state_q >= SIZE) assert (\dut.areas_q <= 12'd4090);
      if (\dut.state_q == SIZE || \dut.state_q == WALK) assert (!\dut.area_next_q && \dut.facts_q == \dut.areas_q + 12'd5);
      if (\dut.state_q == FACTS) begin
        assert (\dut.facts_q >= 12'd1 && \dut.facts_q <= \dut.areas_q + 12'd5);
        assert (\dut.area_next_q == (\dut.facts_q <= \dut.areas_q ));
        assert (16'(\dut.write_addr_q ) == \dut.base_q + 16'(areas_written[11:1]) && \dut.odd_q == areas_written[0]);
        assert (!\dut.complete_q );
        if (\dut.take ) assert (\dut.last_fact_q == (\dut.facts_q == 12'd1));
      end
      if (\dut.state_q == WALK && \dut.step_q >= 7'd1) assert (!\dut.odd_q );
      if (\dut.state_q > WALK && stays) assert (apart);
      if (\dut.replaces_q ) assert (\dut.state_q == FACTS || \dut.state_q == DATA || \dut.start_q );

      // --- properties ---
      if (\dut.store_entry ) assert (\dut.data == past_data);  // u_entry: STEADY
      if ((\dut.write_even || \dut.write_odd ) && stays)
        assert (\dut.write_addr_q < 5'(first) || \dut.write_addr_q >= behind);
      if (past_in_use) assert (stays || !rst_ni);
      if (past_in_use && \dut.store_limit ) assert (slot != watched);
      if (past_idle) assert (error == past_error);
      // An entry is not read while it is written.
      if (\dut.lookup_q && looked_up_valid && \dut.lookup_slot_q == watched) assert (!past_stored);
      if (before_running && \dut.lookup_q && looked_up_valid && \dut.lookup_slot_q == watched) assert (stays);
      cover (\dut.state_q == SIZE);
      cover (error == 3'd2);
    end
  end
endmodule
