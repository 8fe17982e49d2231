// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Lowpass<horopter::hls::profiles::hd>, hls/stages/lowpass.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 57 bits, pipeline 233 bits, memories 69120 bits.
module horopter_lowpass (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic [7:0] pixel_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [7:0] pixel_0_o,
  output logic [7:0] pixel_1_o,
  output logic saturated_o,
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
  // hls/stages/lowpass.hpp:27
  logic or_18;
  assign or_18 = marks_first_i | raster_row_ended_q;
  logic [10:0] select_19;
  assign select_19 = or_18 ? 11'h0 : raster_column_q;

  // Memory memory, 1920 x 36, DISTANCE 16, hls/stages/lowpass.hpp:58; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] memory_mem [0:1919];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1920; i++) memory_mem[i] = 36'h0;
`endif
  logic [10:0] memory_raddr;
  assign memory_raddr = select_19;
`ifndef SYNTHESIS
  logic memory_re;
  assign memory_re = s0_en;
`endif
  logic [35:0] memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) memory_rdata_q <= memory_mem[memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_column_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      raster_column_q <= select_19 + 11'h1;
      raster_row_ended_q <= marks_last_i;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic or_18_s1_q;
  logic [10:0] select_19_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      or_18_s1_q <= or_18;
      select_19_s1_q <= select_19;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic or_18_s2_q;
  logic [10:0] select_19_s2_q;
  logic [35:0] memory_rdata_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      or_18_s2_q <= or_18_s1_q;
      select_19_s2_q <= select_19_s1_q;
      memory_rdata_s2_q <= memory_rdata_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic raster_rows_q;
  logic [1:0] mask_columns_values_0_q;
  logic [1:0] saturated_columns_values_0_q;
  // hls/stages/lowpass.hpp:27
  logic and_22;
  assign and_22 = raster_rows_q & (~marks_first_s2_q);
  // hls/stages/lowpass.hpp:43
  logic [1:0] select_23;
  assign select_23 = and_22 ? memory_rdata_s2_q[33:32] : 2'h0;
  // hls/stages/lowpass.hpp:44
  logic [1:0] select_24;
  assign select_24 = and_22 ? memory_rdata_s2_q[35:34] : 2'h0;
  // hls/stages/lowpass.hpp:35
  logic [8:0] sum_27;
  assign sum_27 = {1'b0, memory_rdata_s2_q[7:0]} + {2'h0, memory_rdata_s2_q[23:17]};
  logic [8:0] sum_29;
  assign sum_29 = {1'b0, memory_rdata_s2_q[15:8]} + {2'h0, memory_rdata_s2_q[31:25]};
  // hls/stages/lowpass.hpp:43
  logic equal_31;
  assign equal_31 = {select_23, mask_s2_q} == 3'h7;
  logic [1:0] select_32;
  assign select_32 = or_18_s2_q ? 2'h0 : mask_columns_values_0_q;
  // hls/stages/lowpass.hpp:44
  logic equal_33;
  assign equal_33 = {select_24, saturated_s2_q} == 3'h7;
  logic [1:0] select_34;
  assign select_34 = or_18_s2_q ? 2'h0 : saturated_columns_values_0_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_rows_q <= 1'b0;
    end else if (s2_en) begin
      raster_rows_q <= marks_last_s2_q | and_22;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    mask_columns_values_0_q = 2'h0;
    saturated_columns_values_0_q = 2'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      mask_columns_values_0_q <= {select_32[0], equal_31};
      saturated_columns_values_0_q <= {select_34[0], equal_33};
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic marks_seen_s3_q;
  logic marks_nearer_s3_q;
  logic [10:0] select_19_s3_q;
  logic [17:0] memory_rdata_s3_q;
  logic select_23_s3_q;
  logic select_24_s3_q;
  logic [8:0] sum_27_s3_q;
  logic [8:0] sum_29_s3_q;
  logic equal_41_s3_q;
  logic equal_42_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      marks_seen_s3_q <= marks_seen_s2_q;
      marks_nearer_s3_q <= marks_nearer_s2_q;
      select_19_s3_q <= select_19_s2_q;
      memory_rdata_s3_q <= {memory_rdata_s2_q[24], memory_rdata_s2_q[16:0]};
      select_23_s3_q <= select_23[0];
      select_24_s3_q <= select_24[0];
      sum_27_s3_q <= sum_27;
      sum_29_s3_q <= sum_29;
      equal_41_s3_q <= {select_34, equal_33} == 3'h7;
      equal_42_s3_q <= {select_32, equal_31} == 3'h7;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [9:0] columns_0_values_0_q;
  logic [9:0] columns_0_values_1_q;
  logic [9:0] columns_1_values_0_q;
  logic [9:0] columns_1_values_1_q;
  // hls/stages/lowpass.hpp:35
  logic [9:0] sum;
  assign sum = {2'h0, pixel_0_s3_q} + {sum_27_s3_q, memory_rdata_s3_q[16]};
  logic [9:0] sum_2;
  assign sum_2 = {2'h0, pixel_1_s3_q} + {sum_29_s3_q, memory_rdata_s3_q[17]};

  // Memory memory, write
  logic [10:0] memory_waddr;
  assign memory_waddr = select_19_s3_q;
  logic memory_we;
  assign memory_we = s3_en;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (memory_we) memory_mem[memory_waddr] <= {select_24_s3_q, saturated_s3_q, select_23_s3_q, mask_s3_q, memory_rdata_s3_q[15:0], pixel_1_s3_q, pixel_0_s3_q};
  end
`ifndef SYNTHESIS
  logic [10:0] memory_raddr_s1_sim;
  logic memory_re_s1_sim;
  logic [10:0] memory_raddr_s2_sim;
  logic memory_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      memory_re_s1_sim <= 1'b0;
      memory_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      memory_re_s1_sim <= memory_re;
      memory_raddr_s1_sim <= memory_raddr;
      memory_re_s2_sim <= memory_re_s1_sim;
      memory_raddr_s2_sim <= memory_raddr_s1_sim;
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
      if (memory_waddr >= 11'd1920) $error("memory: write outside, address %0d", memory_waddr);
    end
    if (rst_ni && memory_re && memory_raddr >= 11'd1920) $error("memory: read outside, address %0d", memory_raddr);
  end
`endif

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    columns_0_values_0_q = 10'h0;
    columns_0_values_1_q = 10'h0;
    columns_1_values_0_q = 10'h0;
    columns_1_values_1_q = 10'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      columns_0_values_0_q <= sum;
      columns_0_values_1_q <= columns_0_values_0_q;
      columns_1_values_0_q <= sum_2;
      columns_1_values_1_q <= columns_1_values_0_q;
    end
  end

  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic marks_seen_s4_q;
  logic marks_nearer_s4_q;
  logic columns_0_values_1_s4_q;
  logic columns_1_values_1_s4_q;
  logic [10:0] sum_35_s4_q;
  logic [10:0] sum_38_s4_q;
  logic equal_41_s4_q;
  logic equal_42_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      marks_seen_s4_q <= marks_seen_s3_q;
      marks_nearer_s4_q <= marks_nearer_s3_q;
      columns_0_values_1_s4_q <= columns_0_values_1_q[0];
      columns_1_values_1_s4_q <= columns_1_values_1_q[0];
      sum_35_s4_q <= {1'b0, columns_0_values_0_q} + {2'h0, columns_0_values_1_q[9:1]};
      sum_38_s4_q <= {1'b0, columns_1_values_0_q} + {2'h0, columns_1_values_1_q[9:1]};
      equal_41_s4_q <= equal_41_s3_q;
      equal_42_s4_q <= equal_42_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  // hls/stages/lowpass.hpp:38
  logic [11:0] sum_36;
  assign sum_36 = {sum_35_s4_q, columns_0_values_1_s4_q} + {2'h0, columns_0_values_0_q};
  logic [8:0] sum_37;
  assign sum_37 = sum_36[11:3] + 9'h1;
  logic [11:0] sum_39;
  assign sum_39 = {sum_38_s4_q, columns_1_values_1_s4_q} + {2'h0, columns_1_values_0_q};
  // hls/stages/lowpass.hpp:48
  logic [8:0] sum_40;
  assign sum_40 = sum_39[11:3] + 9'h1;

  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic marks_seen_s5_q;
  logic marks_nearer_s5_q;
  logic [7:0] sum_37_s5_q;
  logic [7:0] sum_40_s5_q;
  logic equal_41_s5_q;
  logic equal_42_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      marks_seen_s5_q <= marks_seen_s4_q;
      marks_nearer_s5_q <= marks_nearer_s4_q;
      sum_37_s5_q <= sum_37[8:1];
      sum_40_s5_q <= sum_40[8:1];
      equal_41_s5_q <= equal_41_s4_q;
      equal_42_s5_q <= equal_42_s4_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = sum_37_s5_q;
  assign pixel_1_o = sum_40_s5_q;
  assign saturated_o = equal_41_s5_q;
  assign mask_o = equal_42_s5_q;
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

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_40[0], sum_39[2:0], sum_37[0], sum_36[2:0]};

endmodule
