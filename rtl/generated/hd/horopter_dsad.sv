// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Dsad<horopter::hls::profiles::hd>, hls/stages/dsad.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 190 bits, pipeline 394 bits, memories 184320 bits.
module horopter_dsad (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [3:0] difference_0_i,
  input  logic [3:0] difference_1_i,
  input  logic textured_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [10:0] sum_0_o,
  output logic [10:0] sum_1_o,
  output logic textured_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [10:0] raster_column_q;
  logic raster_row_ended_q;
  // hls/stages/dsad.hpp:42
  logic or_33;
  assign or_33 = marks_first_i | raster_row_ended_q;
  logic [10:0] select_34;
  assign select_34 = or_33 ? 11'h0 : raster_column_q;

  // Memory memory, 1920 x 96, DISTANCE 16, hls/stages/dsad.hpp:108; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [95:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 96'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_34;
`ifndef SYNTHESIS
  logic memory_re;
  assign memory_re = s0_en;
`endif
  logic [95:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_34 + 11'h1;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic [3:0] difference_0_s1_q;
  logic [3:0] difference_1_s1_q;
  logic textured_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic or_33_s1_q;
  logic [10:0] select_34_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s1_q <= difference_0_i;
      difference_1_s1_q <= difference_1_i;
      textured_s1_q <= textured_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      or_33_s1_q <= or_33;
      select_34_s1_q <= select_34;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [3:0] difference_0_s2_q;
  logic [3:0] difference_1_s2_q;
  logic textured_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic or_33_s2_q;
  logic [10:0] select_34_s2_q;
  logic [95:0] memory_rdata_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s2_q <= difference_0_s1_q;
      difference_1_s2_q <= difference_1_s1_q;
      textured_s2_q <= textured_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      or_33_s2_q <= or_33_s1_q;
      select_34_s2_q <= select_34_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_rows_q;
  logic [7:0] mask_columns_values_0_q;
  // hls/stages/dsad.hpp:42
  logic [3:0] select_36;
  assign select_36 = marks_first_s2_q ? 4'h0 : raster_rows_q;
  logic equal_37;
  assign equal_37 = select_36 == 4'h0;
  logic equal_39;
  assign equal_39 = select_36 == 4'h9;
  // hls/stages/dsad.hpp:51
  logic [3:0] leaving;
  assign leaving = equal_39 ? memory_rdata_s2_q[35:32] : 4'h0;
  logic [3:0] leaving_2;
  assign leaving_2 = equal_39 ? memory_rdata_s2_q[71:68] : 4'h0;
  // hls/stages/dsad.hpp:52
  logic [7:0] select_47;
  assign select_47 = equal_37 ? 8'h0 : memory_rdata_s2_q[95:88];
  // hls/stages/dsad.hpp:42
  logic not_49;
  assign not_49 = ~equal_39;
  // hls/stages/dsad.hpp:62
  logic equal_61;
  assign equal_61 = {select_47, mask_s2_q} == 9'h1ff;
  logic [7:0] select_62;
  assign select_62 = or_33_s2_q ? 8'h0 : mask_columns_values_0_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 4'h0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q ? (select_36 + {3'h0, not_49}) : select_36;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    mask_columns_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      mask_columns_values_0_q <= {select_62[6:0], equal_61};
    end
  end

  logic [3:0] difference_0_s3_q;
  logic [3:0] difference_1_s3_q;
  logic textured_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic or_33_s3_q;
  logic [10:0] select_34_s3_q;
  logic [63:0] memory_rdata_s3_q;
  logic [7:0] select_38_s3_q;
  logic [3:0] leaving_s3_q;
  logic [7:0] select_43_s3_q;
  logic [3:0] leaving_2_s3_q;
  logic [6:0] select_47_s3_q;
  logic select_62_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s3_q <= difference_0_s2_q;
      difference_1_s3_q <= difference_1_s2_q;
      textured_s3_q <= textured_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      or_33_s3_q <= or_33_s2_q;
      select_34_s3_q <= select_34_s2_q;
      memory_rdata_s3_q <= {memory_rdata_s2_q[67:36], memory_rdata_s2_q[31:0]};
      select_38_s3_q <= equal_37 ? 8'h0 : memory_rdata_s2_q[79:72];
      leaving_s3_q <= leaving;
      select_43_s3_q <= equal_37 ? 8'h0 : memory_rdata_s2_q[87:80];
      leaving_2_s3_q <= leaving_2;
      select_47_s3_q <= select_47[6:0];
      select_62_s3_q <= select_62[7];
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] columns_values_values_0_0_q;
  logic [7:0] columns_values_values_0_1_q;
  logic [7:0] columns_values_values_1_0_q;
  logic [7:0] columns_values_values_1_1_q;
  logic [7:0] columns_values_values_2_0_q;
  logic [7:0] columns_values_values_2_1_q;
  logic [7:0] columns_values_values_3_0_q;
  logic [7:0] columns_values_values_3_1_q;
  logic [7:0] columns_values_values_4_0_q;
  logic [7:0] columns_values_values_4_1_q;
  logic [7:0] columns_values_values_5_0_q;
  logic [7:0] columns_values_values_5_1_q;
  logic [7:0] columns_values_values_6_0_q;
  logic [7:0] columns_values_values_6_1_q;
  logic [7:0] columns_values_values_7_0_q;
  logic [7:0] columns_values_values_7_1_q;
  logic [7:0] columns_values_values_8_0_q;
  logic [7:0] columns_values_values_8_1_q;
  // hls/stages/dsad.hpp:52
  logic [4:0] difference_41;
  assign difference_41 = {1'b0, difference_0_s3_q} - {1'b0, leaving_s3_q};
  logic [4:0] difference_45;
  assign difference_45 = {1'b0, difference_1_s3_q} - {1'b0, leaving_2_s3_q};
  // hls/stages/dsad.hpp:57
  logic less_52;
  assign less_52 = 11'h8 < select_34_s3_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      columns_values_values_0_0_q <= 8'h0;
      columns_values_values_0_1_q <= 8'h0;
      columns_values_values_1_0_q <= 8'h0;
      columns_values_values_1_1_q <= 8'h0;
      columns_values_values_2_0_q <= 8'h0;
      columns_values_values_2_1_q <= 8'h0;
      columns_values_values_3_0_q <= 8'h0;
      columns_values_values_3_1_q <= 8'h0;
      columns_values_values_4_0_q <= 8'h0;
      columns_values_values_4_1_q <= 8'h0;
      columns_values_values_5_0_q <= 8'h0;
      columns_values_values_5_1_q <= 8'h0;
      columns_values_values_6_0_q <= 8'h0;
      columns_values_values_6_1_q <= 8'h0;
      columns_values_values_7_0_q <= 8'h0;
      columns_values_values_7_1_q <= 8'h0;
      columns_values_values_8_0_q <= 8'h0;
      columns_values_values_8_1_q <= 8'h0;
    end else if (s3_en) begin
      columns_values_values_0_0_q <= select_38_s3_q + {{3{difference_41[4]}}, difference_41};
      columns_values_values_0_1_q <= select_43_s3_q + {{3{difference_45[4]}}, difference_45};
      columns_values_values_1_0_q <= columns_values_values_0_0_q;
      columns_values_values_1_1_q <= columns_values_values_0_1_q;
      columns_values_values_2_0_q <= columns_values_values_1_0_q;
      columns_values_values_2_1_q <= columns_values_values_1_1_q;
      columns_values_values_3_0_q <= columns_values_values_2_0_q;
      columns_values_values_3_1_q <= columns_values_values_2_1_q;
      columns_values_values_4_0_q <= columns_values_values_3_0_q;
      columns_values_values_4_1_q <= columns_values_values_3_1_q;
      columns_values_values_5_0_q <= columns_values_values_4_0_q;
      columns_values_values_5_1_q <= columns_values_values_4_1_q;
      columns_values_values_6_0_q <= columns_values_values_5_0_q;
      columns_values_values_6_1_q <= columns_values_values_5_1_q;
      columns_values_values_7_0_q <= columns_values_values_6_0_q;
      columns_values_values_7_1_q <= columns_values_values_6_1_q;
      columns_values_values_8_0_q <= columns_values_values_7_0_q;
      columns_values_values_8_1_q <= columns_values_values_7_1_q;
    end
  end

  logic [3:0] difference_0_s4_q;
  logic [3:0] difference_1_s4_q;
  logic textured_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic or_33_s4_q;
  logic [10:0] select_34_s4_q;
  logic [63:0] memory_rdata_s4_q;
  logic [6:0] select_47_s4_q;
  logic [7:0] select_53_s4_q;
  logic [7:0] select_57_s4_q;
  logic equal_63_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      difference_0_s4_q <= difference_0_s3_q;
      difference_1_s4_q <= difference_1_s3_q;
      textured_s4_q <= textured_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      or_33_s4_q <= or_33_s3_q;
      select_34_s4_q <= select_34_s3_q;
      memory_rdata_s4_q <= memory_rdata_s3_q;
      select_47_s4_q <= select_47_s3_q;
      select_53_s4_q <= less_52 ? columns_values_values_8_0_q : 8'h0;
      select_57_s4_q <= less_52 ? columns_values_values_8_1_q : 8'h0;
      equal_63_s4_q <= {select_62_s3_q, mask_columns_values_0_q} == 9'h1ff;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [10:0] rows_0_sums_values_0_q;
  logic [10:0] rows_1_sums_values_0_q;
  // hls/stages/dsad.hpp:60
  logic [8:0] difference_54;
  assign difference_54 = {1'b0, columns_values_values_0_0_q} - {1'b0, select_53_s4_q};
  logic [10:0] sum_56;
  assign sum_56 = {{2{difference_54[8]}}, difference_54} + (or_33_s4_q ? 11'h0 : rows_0_sums_values_0_q);
  logic [8:0] difference_58;
  assign difference_58 = {1'b0, columns_values_values_0_1_q} - {1'b0, select_57_s4_q};
  logic [10:0] sum_60;
  assign sum_60 = {{2{difference_58[8]}}, difference_58} + (or_33_s4_q ? 11'h0 : rows_1_sums_values_0_q);

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_34_s4_q;
  logic memory_we;
  assign memory_we = s4_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_47_s4_q, mask_s4_q, columns_values_values_0_1_q, columns_values_values_0_0_q, memory_rdata_s4_q[63:32], difference_1_s4_q, memory_rdata_s4_q[31:0], difference_0_s4_q};
  end
`ifndef SYNTHESIS
  logic [10:0] memory_raddr_s1_sim;
  logic memory_re_s1_sim;
  logic [10:0] memory_raddr_s2_sim;
  logic memory_re_s2_sim;
  logic [10:0] memory_raddr_s3_sim;
  logic memory_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      memory_re_s1_sim <= 1'b0;
      memory_re_s2_sim <= 1'b0;
      memory_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      memory_re_s1_sim <= memory_re;
      memory_raddr_s1_sim <= memory_raddr;
      memory_re_s2_sim <= memory_re_s1_sim;
      memory_raddr_s2_sim <= memory_raddr_s1_sim;
      memory_re_s3_sim <= memory_re_s2_sim;
      memory_raddr_s3_sim <= memory_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && memory_we) begin
      if (memory_re && memory_raddr == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s1_sim && memory_raddr_s1_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s2_sim && memory_raddr_s2_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_re_s3_sim && memory_raddr_s3_sim == memory_waddr) begin
        $error("memory: address %0d is read less than DISTANCE steps after its write", memory_waddr);
      end
      if (memory_waddr >= 11'd1920) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 11'd1920) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    rows_0_sums_values_0_q = 11'h0;
    rows_1_sums_values_0_q = 11'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s4_en) begin
      rows_0_sums_values_0_q <= sum_56;
      rows_1_sums_values_0_q <= sum_60;
    end
  end

  logic textured_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic equal_63_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      textured_s5_q <= textured_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      equal_63_s5_q <= equal_63_s4_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign sum_0_o = rows_0_sums_values_0_q;
  assign sum_1_o = rows_1_sums_values_0_q;
  assign textured_o = textured_s5_q;
  assign mask_o = equal_63_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = marks_seen_s5_q;
  assign marks_nearer_o = marks_nearer_s5_q;
  assign valid_o = valid_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
    end
  end

endmodule
