// SPDX-License-Identifier: Apache-2.0
#include "hlsc/delay.hpp"

#include <algorithm>
#include <cmath>

namespace hlsc {

std::string_view target_name(Target target) { return target == Target::kEcp5 ? "ecp5" : "ice40hx"; }

std::optional<Target> target_from_name(std::string_view name) {
  if (name == "ecp5") return Target::kEcp5;
  if (name == "ice40hx") return Target::kIce40Hx;
  return std::nullopt;
}

DelayModel make_delay_model(Target target) {
  DelayModel m;
  m.target = target;
  switch (target) {
    case Target::kIce40Hx:
      m.launch_ns = 0.54;
      m.setup_ns = 0.10;
      m.level_ns = 1.40;
      m.carry_base_ns = 1.75;
      m.carry_bit_ns = 0.14;
      m.memory_read_ns = 2.15;
      m.memory_setup_ns = 1.30;
      break;
    case Target::kEcp5:  // speed grade 6
      m.launch_ns = 0.53;
      m.config_route_ns = 1.00;
      m.setup_ns = 0.05;
      m.level_ns = 1.12;
      m.carry_base_ns = 1.75;
      m.carry_bit_ns = 0.04;
      m.memory_read_ns = 5.30;   // 5.7 without its output register, less the margin it does not need (delay.hpp)
      m.memory_route_ns = 1.80;  // block RAMs lie in few rows; of hd's, routed, half are further away than this
      m.memory_setup_ns = 2.80;
      m.banks_ns = 0.40;
      m.bank_ns = 0.35;
      m.multiplier_ns = 4.60;
      m.multiplier_route_ns = 1.30;  // they lie in few rows
      m.multiplier_bits = 18;
      break;
  }
  return m;
}

namespace {

/// Levels of LUT4 for a function of so many inputs that splits into a tree.
double tree_levels(double inputs) { return inputs <= 4 ? 1.0 : 1.0 + std::log(inputs / 4.0) / std::log(4.0); }

std::uint32_t variable_bits(const Bits& bits) {
  return static_cast<std::uint32_t>(std::ranges::count_if(bits, [](Bit b) { return b.node != 0; }));
}

}  // namespace

bool is_distributed(const Ram& ram) {
  constexpr std::size_t kFewWords = 64, kFewBits = 256;
  return ram.depth <= kFewWords || std::size_t{ram.depth} * ram.width <= kFewBits;
}

double DelayModel::read_address_ns(const Ram& ram) const {
  constexpr double kBankWords = 16;
  return memory_setup_ns +
         (is_distributed(ram) && ram.depth > kBankWords ? banks_ns + bank_ns * std::log2(ram.depth / kBankWords) : 0);
}

bool DelayModel::is_hard_product(const Node& node) const {
  return (node.op == Op::kMul || node.op == Op::kMulSigned) && multiplier_bits != 0 &&
         std::max(variable_bits(node.operands[0]), variable_bits(node.operands[1])) <= multiplier_bits;
}

double DelayModel::route_ns(const Node& node, bool synchronous_rom) const {
  if (node.op == Op::kRamRead || synchronous_rom) return memory_route_ns;
  return is_hard_product(node) ? multiplier_route_ns : 0;
}

double DelayModel::node_ns(const Graph& graph, const Node& node) const {
  const auto variable = [&](std::size_t i) { return variable_bits(node.operands[i]); };
  switch (node.op) {
    case Op::kConstant:
    case Op::kInput:
    case Op::kConfig:
    case Op::kStateRead:
    case Op::kNot:  // part of the next look-up table
      return 0;
    case Op::kRamRead:
      return memory_read_ns - launch_ns;
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:  // two or three of these share a look-up table
      return 0.55 * level_ns;
    case Op::kMux:
      // A multiplexer with a constant leg is a gate.
      return (variable(1) == 0 || variable(2) == 0 ? 0.55 : 0.85) * level_ns;
    case Op::kReduceOr:
    case Op::kReduceAnd:
    case Op::kReduceXor:
      return tree_levels(variable(0)) * level_ns;
    case Op::kEq:
      return tree_levels(variable(0) + variable(1)) * level_ns;
    case Op::kAdd:
    case Op::kSub:
      if (node.width <= 2) return level_ns;
      return carry_base_ns + carry_bit_ns * node.width;
    case Op::kUlt:
    case Op::kSlt: {
      const auto bits = static_cast<double>(node.operands[0].size());
      if (variable(0) + variable(1) <= 4) return level_ns;
      return carry_base_ns + carry_bit_ns * bits;
    }
    case Op::kShl:
    case Op::kLshr:
    case Op::kAshr: {
      // One LUT4 holds one 2:1 multiplexer, two levels a 4:1.
      const double steps = std::min<double>(variable(1), std::ceil(std::log2(std::max(2U, node.width))));
      return std::max(1.0, steps) * 0.95 * level_ns;
    }
    case Op::kMul:
    case Op::kMulSigned: {
      if (is_hard_product(node)) return multiplier_ns;
      const double rows = std::max(1U, std::min(variable(0), variable(1)));
      return level_ns + std::ceil(std::log2(rows + 1)) * (carry_base_ns + carry_bit_ns * node.width);
    }
    case Op::kRom: {
      const double address = std::max(1U, variable(0));
      (void)graph;
      // A 4:1 multiplexer is two LUT4, but tables compress: about one level per address bit beyond four.
      return address <= 4 ? level_ns : level_ns * (1.0 + 0.8 * (address - 4));
    }
  }
  return 0;
}

}  // namespace hlsc
