// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Direction<horopter::hls::profiles::vga>, hls/stages/direction.hpp. Do not edit.
//
// Latency 2 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 0 bits, pipeline 112 bits, memories 0 bits.
module horopter_direction (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic signed [10:0] gx_0_i,
  input  logic signed [10:0] gx_1_i,
  input  logic signed [10:0] gy_0_i,
  input  logic signed [10:0] gy_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic marks_seen_i,
  input  logic marks_nearer_i,
  output logic valid_o,
  output logic [7:0] direction_0_o,
  output logic [7:0] direction_1_o,
  output logic [7:0] magnitude_0_o,
  output logic [7:0] magnitude_1_o,
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
  logic less_15;
  assign less_15 = x < y;
  logic [9:0] larger;
  assign larger = less_15 ? y : x;
  // hls/stages/direction.hpp:47
  logic [9:0] smaller;
  assign smaller = (y < x) ? y : x;
  // hls/stages/direction.hpp:43
  logic [9:0] x_2;
  assign x_2 = {9'h0, gx_1_i[10]} + (gx_1_i[9:0] ^ {10{gx_1_i[10]}});
  // hls/stages/direction.hpp:44
  logic [9:0] y_2;
  assign y_2 = {9'h0, gy_1_i[10]} + (gy_1_i[9:0] ^ {10{gy_1_i[10]}});
  // hls/stages/direction.hpp:46
  logic less_47;
  assign less_47 = x_2 < y_2;
  logic [9:0] larger_2;
  assign larger_2 = less_47 ? y_2 : x_2;
  // hls/stages/direction.hpp:47
  logic [9:0] smaller_2;
  assign smaller_2 = (y_2 < x_2) ? y_2 : x_2;
  // hls/stages/direction.hpp:49
  logic [10:0] sum_75;
  assign sum_75 = {1'b0, smaller} + {2'h0, smaller[9:1]};
  logic [10:0] sum_80;
  assign sum_80 = {1'b0, smaller_2} + {2'h0, smaller_2[9:1]};

  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic marks_seen_s1_q;
  logic marks_nearer_s1_q;
  logic less_15_s1_q;
  logic xor_18_s1_q;
  logic [9:0] larger_s1_q;
  logic [9:0] difference_22_s1_q;
  logic select_41_s1_q;
  logic less_47_s1_q;
  logic xor_50_s1_q;
  logic [9:0] larger_2_s1_q;
  logic [9:0] difference_54_s1_q;
  logic select_73_s1_q;
  logic [9:0] sum_75_s1_q;
  logic [9:0] sum_80_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      marks_seen_s1_q <= marks_seen_i;
      marks_nearer_s1_q <= marks_nearer_i;
      less_15_s1_q <= less_15;
      xor_18_s1_q <= less_15 ^ (~(gx_0_i[10] ^ gy_0_i[10]));
      larger_s1_q <= larger;
      difference_22_s1_q <= {1'b0, larger[9:1]} - smaller;
      select_41_s1_q <= less_15 ? gy_0_i[10] : gx_0_i[10];
      less_47_s1_q <= less_47;
      xor_50_s1_q <= less_47 ^ (~(gx_1_i[10] ^ gy_1_i[10]));
      larger_2_s1_q <= larger_2;
      difference_54_s1_q <= {1'b0, larger_2[9:1]} - smaller_2;
      select_73_s1_q <= less_47 ? gy_1_i[10] : gx_1_i[10];
      sum_75_s1_q <= sum_75[10:1];
      sum_80_s1_q <= sum_80[10:1];
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  // hls/stages/direction.hpp:62
  logic not_23;
  assign not_23 = ~difference_22_s1_q[9];
  logic [9:0] xor_24;
  assign xor_24 = larger_s1_q ^ {10{not_23}};
  logic [10:0] sum_25;
  assign sum_25 = {difference_22_s1_q[8:0], larger_s1_q[0], not_23} + {not_23, xor_24};
  logic not_26;
  assign not_26 = ~sum_25[10];
  logic [9:0] xor_27;
  assign xor_27 = larger_s1_q ^ {10{not_26}};
  logic [10:0] sum_28;
  assign sum_28 = {sum_25[9:0], not_26} + {not_26, xor_27};
  logic not_29;
  assign not_29 = ~sum_28[10];
  logic [9:0] xor_30;
  assign xor_30 = larger_s1_q ^ {10{not_29}};
  logic [10:0] sum_31;
  assign sum_31 = {sum_28[9:0], not_29} + {not_29, xor_30};
  logic not_32;
  assign not_32 = ~sum_31[10];
  logic [9:0] xor_33;
  assign xor_33 = larger_s1_q ^ {10{not_32}};
  logic [10:0] sum_34;
  assign sum_34 = {sum_31[9:0], not_32} + {not_32, xor_33};
  logic not_35;
  assign not_35 = ~sum_34[10];
  logic [9:0] xor_36;
  assign xor_36 = larger_s1_q ^ {10{not_35}};
  logic [10:0] sum_37;
  assign sum_37 = {sum_34[9:0], not_35} + {not_35, xor_36};
  logic [5:0] angle;  // table arctangent_table
  always_comb begin
    case ({difference_22_s1_q[9], sum_25[10], sum_28[10], sum_31[10], sum_34[10], sum_37[10]})
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
  logic [6:0] select_40;
  assign select_40 = xor_18_s1_q ? {1'b0, angle} : (7'h0 - {1'b0, angle});
  // hls/stages/direction.hpp:62
  logic not_55;
  assign not_55 = ~difference_54_s1_q[9];
  logic [9:0] xor_56;
  assign xor_56 = larger_2_s1_q ^ {10{not_55}};
  logic [10:0] sum_57;
  assign sum_57 = {difference_54_s1_q[8:0], larger_2_s1_q[0], not_55} + {not_55, xor_56};
  logic not_58;
  assign not_58 = ~sum_57[10];
  logic [9:0] xor_59;
  assign xor_59 = larger_2_s1_q ^ {10{not_58}};
  logic [10:0] sum_60;
  assign sum_60 = {sum_57[9:0], not_58} + {not_58, xor_59};
  logic not_61;
  assign not_61 = ~sum_60[10];
  logic [9:0] xor_62;
  assign xor_62 = larger_2_s1_q ^ {10{not_61}};
  logic [10:0] sum_63;
  assign sum_63 = {sum_60[9:0], not_61} + {not_61, xor_62};
  logic not_64;
  assign not_64 = ~sum_63[10];
  logic [9:0] xor_65;
  assign xor_65 = larger_2_s1_q ^ {10{not_64}};
  logic [10:0] sum_66;
  assign sum_66 = {sum_63[9:0], not_64} + {not_64, xor_65};
  logic not_67;
  assign not_67 = ~sum_66[10];
  logic [9:0] xor_68;
  assign xor_68 = larger_2_s1_q ^ {10{not_67}};
  logic [10:0] sum_69;
  assign sum_69 = {sum_66[9:0], not_67} + {not_67, xor_68};
  logic [5:0] angle_2;  // table arctangent_table
  always_comb begin
    case ({difference_54_s1_q[9], sum_57[10], sum_60[10], sum_63[10], sum_66[10], sum_69[10]})
      6'd1: angle_2 = 6'h1;
      6'd2: angle_2 = 6'h2;
      6'd3: angle_2 = 6'h2;
      6'd4: angle_2 = 6'h3;
      6'd5: angle_2 = 6'h3;
      6'd6: angle_2 = 6'h4;
      6'd7: angle_2 = 6'h5;
      6'd8: angle_2 = 6'h5;
      6'd9: angle_2 = 6'h6;
      6'd10: angle_2 = 6'h7;
      6'd11: angle_2 = 6'h7;
      6'd12: angle_2 = 6'h8;
      6'd13: angle_2 = 6'h8;
      6'd14: angle_2 = 6'h9;
      6'd15: angle_2 = 6'ha;
      6'd16: angle_2 = 6'ha;
      6'd17: angle_2 = 6'hb;
      6'd18: angle_2 = 6'hb;
      6'd19: angle_2 = 6'hc;
      6'd20: angle_2 = 6'hd;
      6'd21: angle_2 = 6'hd;
      6'd22: angle_2 = 6'he;
      6'd23: angle_2 = 6'he;
      6'd24: angle_2 = 6'hf;
      6'd25: angle_2 = 6'hf;
      6'd26: angle_2 = 6'h10;
      6'd27: angle_2 = 6'h11;
      6'd28: angle_2 = 6'h11;
      6'd29: angle_2 = 6'h12;
      6'd30: angle_2 = 6'h12;
      6'd31: angle_2 = 6'h13;
      6'd32: angle_2 = 6'h13;
      6'd33: angle_2 = 6'h14;
      6'd34: angle_2 = 6'h14;
      6'd35: angle_2 = 6'h15;
      6'd36: angle_2 = 6'h15;
      6'd37: angle_2 = 6'h16;
      6'd38: angle_2 = 6'h16;
      6'd39: angle_2 = 6'h17;
      6'd40: angle_2 = 6'h17;
      6'd41: angle_2 = 6'h17;
      6'd42: angle_2 = 6'h18;
      6'd43: angle_2 = 6'h18;
      6'd44: angle_2 = 6'h19;
      6'd45: angle_2 = 6'h19;
      6'd46: angle_2 = 6'h1a;
      6'd47: angle_2 = 6'h1a;
      6'd48: angle_2 = 6'h1a;
      6'd49: angle_2 = 6'h1b;
      6'd50: angle_2 = 6'h1b;
      6'd51: angle_2 = 6'h1c;
      6'd52: angle_2 = 6'h1c;
      6'd53: angle_2 = 6'h1c;
      6'd54: angle_2 = 6'h1d;
      6'd55: angle_2 = 6'h1d;
      6'd56: angle_2 = 6'h1d;
      6'd57: angle_2 = 6'h1e;
      6'd58: angle_2 = 6'h1e;
      6'd59: angle_2 = 6'h1f;
      6'd60: angle_2 = 6'h1f;
      6'd61: angle_2 = 6'h1f;
      6'd62: angle_2 = 6'h20;
      6'd63: angle_2 = 6'h20;
      default: angle_2 = 6'h0;
    endcase
  end
  // hls/stages/direction.hpp:69
  logic [6:0] select_72;
  assign select_72 = xor_50_s1_q ? {1'b0, angle_2} : (7'h0 - {1'b0, angle_2});
  // hls/stages/direction.hpp:49
  logic [9:0] sum_76;
  assign sum_76 = sum_75_s1_q + 10'h1;
  logic [10:0] sum_77;
  assign sum_77 = {1'b0, larger_s1_q} + {2'h0, sum_76[9:1]};
  logic [9:0] sum_81;
  assign sum_81 = sum_80_s1_q + 10'h1;
  logic [10:0] sum_82;
  assign sum_82 = {1'b0, larger_2_s1_q} + {2'h0, sum_81[9:1]};

  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic marks_seen_s2_q;
  logic marks_nearer_s2_q;
  logic [5:0] select_40_s2_q;
  logic [1:0] sum_42_s2_q;
  logic [5:0] select_72_s2_q;
  logic [1:0] sum_74_s2_q;
  logic [7:0] select_79_s2_q;
  logic [7:0] select_84_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      marks_seen_s2_q <= marks_seen_s1_q;
      marks_nearer_s2_q <= marks_nearer_s1_q;
      select_40_s2_q <= select_40[5:0];
      sum_42_s2_q <= {select_41_s1_q, less_15_s1_q} + {2{select_40[6]}};
      select_72_s2_q <= select_72[5:0];
      sum_74_s2_q <= {select_73_s1_q, less_47_s1_q} + {2{select_72[6]}};
      select_79_s2_q <= (sum_77[10:8] == 3'h0) ? sum_77[7:0] : 8'hff;
      select_84_s2_q <= (sum_82[10:8] == 3'h0) ? sum_82[7:0] : 8'hff;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign direction_0_o = {sum_42_s2_q, select_40_s2_q};
  assign direction_1_o = {sum_74_s2_q, select_72_s2_q};
  assign magnitude_0_o = select_79_s2_q;
  assign magnitude_1_o = select_84_s2_q;
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
  assign unused_bits = ^{sum_81[0], sum_80[0], sum_76[0], sum_75[0], sum_69[9:0], sum_37[9:0]};

endmodule
