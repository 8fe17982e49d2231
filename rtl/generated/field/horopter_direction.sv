// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Direction<horopter::hls::profiles::field>, hls/stages/direction.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 63 bits, memories 0 bits.
module horopter_direction (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic signed [10:0] gx_0_i,
  input  logic signed [10:0] gy_0_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [7:0] direction_0_o,
  output logic [7:0] magnitude_0_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q;
  logic s1_en;
  assign s1_en = en_i & valid_s1_q;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:43
  logic [9:0] x;
  assign x = {9'h0, gx_0_i[10]} + (gx_0_i[9:0] ^ {10{gx_0_i[10]}});
  // hls/stages/direction.hpp:44
  logic [9:0] y;
  assign y = {9'h0, gy_0_i[10]} + (gy_0_i[9:0] ^ {10{gy_0_i[10]}});
  // hls/stages/direction.hpp:46
  logic less_13;
  assign less_13 = x < y;
  logic [9:0] larger;
  assign larger = less_13 ? y : x;
  // hls/stages/direction.hpp:47
  logic [9:0] smaller;
  assign smaller = (y < x) ? y : x;
  // hls/stages/direction.hpp:49
  logic [10:0] sum_41;
  assign sum_41 = {1'b0, smaller} + {2'h0, smaller[9:1]};

  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic less_13_s1_q;
  logic xor_16_s1_q;
  logic [9:0] larger_s1_q;
  logic [9:0] difference_20_s1_q;
  logic select_39_s1_q;
  logic [9:0] sum_41_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      less_13_s1_q <= less_13;
      xor_16_s1_q <= less_13 ^ (~(gx_0_i[10] ^ gy_0_i[10]));
      larger_s1_q <= larger;
      difference_20_s1_q <= {1'b0, larger[9:1]} - smaller;
      select_39_s1_q <= less_13 ? gy_0_i[10] : gx_0_i[10];
      sum_41_s1_q <= sum_41[10:1];
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_21;
  assign not_21 = ~difference_20_s1_q[9];
  logic [9:0] xor_22;
  assign xor_22 = larger_s1_q ^ {10{not_21}};
  logic [10:0] sum_23;
  assign sum_23 = {difference_20_s1_q[8:0], larger_s1_q[0], not_21} + {not_21, xor_22};
  logic not_24;
  assign not_24 = ~sum_23[10];
  logic [9:0] xor_25;
  assign xor_25 = larger_s1_q ^ {10{not_24}};
  logic [10:0] sum_26;
  assign sum_26 = {sum_23[9:0], not_24} + {not_24, xor_25};
  logic not_27;
  assign not_27 = ~sum_26[10];
  logic [9:0] xor_28;
  assign xor_28 = larger_s1_q ^ {10{not_27}};
  logic [10:0] sum_29;
  assign sum_29 = {sum_26[9:0], not_27} + {not_27, xor_28};
  logic not_30;
  assign not_30 = ~sum_29[10];
  logic [9:0] xor_31;
  assign xor_31 = larger_s1_q ^ {10{not_30}};
  logic [10:0] sum_32;
  assign sum_32 = {sum_29[9:0], not_30} + {not_30, xor_31};
  logic not_33;
  assign not_33 = ~sum_32[10];
  logic [9:0] xor_34;
  assign xor_34 = larger_s1_q ^ {10{not_33}};
  logic [10:0] sum_35;
  assign sum_35 = {sum_32[9:0], not_33} + {not_33, xor_34};
  logic [5:0] angle;  // table arctangent_table
  always_comb begin
    case ({difference_20_s1_q[9], sum_23[10], sum_26[10], sum_29[10], sum_32[10], sum_35[10]})
      6'd1: angle = 6'h1;
      6'd2: angle = 6'h2;
      6'd3: angle = 6'h2;
      6'd4: angle = 6'h3;
      6'd5: angle = 6'h3;
      6'd6: angle = 6'h4;
      6'd7: angle = 6'h5;
      6'd8: angle = 6'h5;
      6'd9: angle = 6'h6;
      6'd10: angle = 6'h7;
      6'd11: angle = 6'h7;
      6'd12: angle = 6'h8;
      6'd13: angle = 6'h8;
      6'd14: angle = 6'h9;
      6'd15: angle = 6'ha;
      6'd16: angle = 6'ha;
      6'd17: angle = 6'hb;
      6'd18: angle = 6'hb;
      6'd19: angle = 6'hc;
      6'd20: angle = 6'hd;
      6'd21: angle = 6'hd;
      6'd22: angle = 6'he;
      6'd23: angle = 6'he;
      6'd24: angle = 6'hf;
      6'd25: angle = 6'hf;
      6'd26: angle = 6'h10;
      6'd27: angle = 6'h11;
      6'd28: angle = 6'h11;
      6'd29: angle = 6'h12;
      6'd30: angle = 6'h12;
      6'd31: angle = 6'h13;
      6'd32: angle = 6'h13;
      6'd33: angle = 6'h14;
      6'd34: angle = 6'h14;
      6'd35: angle = 6'h15;
      6'd36: angle = 6'h15;
      6'd37: angle = 6'h16;
      6'd38: angle = 6'h16;
      6'd39: angle = 6'h17;
      6'd40: angle = 6'h17;
      6'd41: angle = 6'h17;
      6'd42: angle = 6'h18;
      6'd43: angle = 6'h18;
      6'd44: angle = 6'h19;
      6'd45: angle = 6'h19;
      6'd46: angle = 6'h1a;
      6'd47: angle = 6'h1a;
      6'd48: angle = 6'h1a;
      6'd49: angle = 6'h1b;
      6'd50: angle = 6'h1b;
      6'd51: angle = 6'h1c;
      6'd52: angle = 6'h1c;
      6'd53: angle = 6'h1c;
      6'd54: angle = 6'h1d;
      6'd55: angle = 6'h1d;
      6'd56: angle = 6'h1d;
      6'd57: angle = 6'h1e;
      6'd58: angle = 6'h1e;
      6'd59: angle = 6'h1f;
      6'd60: angle = 6'h1f;
      6'd61: angle = 6'h1f;
      6'd62: angle = 6'h20;
      6'd63: angle = 6'h20;
      default: angle = 6'h0;
    endcase
  end
  // hls/stages/direction.hpp:69
  logic [6:0] select_38;
  assign select_38 = xor_16_s1_q ? {1'b0, angle} : (7'h0 - {1'b0, angle});
  // hls/stages/direction.hpp:49
  logic [9:0] sum_42;
  assign sum_42 = sum_41_s1_q + 10'h1;
  logic [10:0] sum_43;
  assign sum_43 = {1'b0, larger_s1_q} + {2'h0, sum_42[9:1]};

  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic [5:0] select_38_s2_q;
  logic [1:0] sum_40_s2_q;
  logic [7:0] select_45_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      select_38_s2_q <= select_38[5:0];
      sum_40_s2_q <= {select_39_s1_q, less_13_s1_q} + {2{select_38[6]}};
      select_45_s2_q <= (sum_43[10:8] == 3'h0) ? sum_43[7:0] : 8'hff;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign direction_0_o = {sum_40_s2_q, select_38_s2_q};
  assign magnitude_0_o = select_45_s2_q;
  assign saturated_o = saturated_s2_q;
  assign mask_o = mask_s2_q;
  assign marks_first_o = marks_first_s2_q;
  assign marks_last_o = marks_last_s2_q;
  assign marks_seen_o = marks_seen_s2_q;
  assign marks_nearer_o = marks_nearer_s2_q;
  assign valid_o = valid_s2_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{sum_42[0], sum_41[0], sum_35[9:0]};

endmodule
