// SPDX-License-Identifier: Apache-2.0
#include "hlsc/dump.hpp"

#include <sstream>

namespace hlsc {

const char* name_of(Op op) {
  switch (op) {
    case Op::kConstant:
      return "constant";
    case Op::kInput:
      return "input";
    case Op::kConfig:
      return "config";
    case Op::kStateRead:
      return "state";
    case Op::kRamRead:
      return "ram";
    case Op::kRom:
      return "rom";
    case Op::kAnd:
      return "and";
    case Op::kOr:
      return "or";
    case Op::kXor:
      return "xor";
    case Op::kNot:
      return "not";
    case Op::kAdd:
      return "add";
    case Op::kSub:
      return "sub";
    case Op::kMul:
      return "mul";
    case Op::kMulSigned:
      return "mul_signed";
    case Op::kShl:
      return "shl";
    case Op::kLshr:
      return "lshr";
    case Op::kAshr:
      return "ashr";
    case Op::kEq:
      return "eq";
    case Op::kUlt:
      return "ult";
    case Op::kSlt:
      return "slt";
    case Op::kMux:
      return "mux";
    case Op::kReduceOr:
      return "reduce_or";
    case Op::kReduceAnd:
      return "reduce_and";
    case Op::kReduceXor:
      return "reduce_xor";
  }
  return "?";
}

namespace {

/// Most significant first, as `{n7[3:0], 2'b00}`.
std::string text(const Bits& bits) {
  std::ostringstream out;
  out << '{';
  for (std::size_t high = bits.size(); high > 0;) {
    std::size_t low = high - 1;
    if (high != bits.size()) out << ", ";
    if (bits[low].node == 0) {
      std::string digits;
      while (true) {
        digits += bits[low] == kOne ? '1' : '0';
        if (low == 0 || bits[low - 1].node != 0) break;
        --low;
      }
      out << digits.size() << "'b" << digits;
    } else {
      while (low > 0 && bits[low - 1].node == bits[low].node && bits[low - 1].index + 1 == bits[low].index) --low;
      out << 'n' << bits[low].node << '[' << bits[high - 1].index;
      if (low + 1 != high) out << ':' << bits[low].index;
      out << ']';
    }
    high = low;
  }
  out << '}';
  return out.str();
}

}  // namespace

std::string dump(const Graph& graph) {
  std::ostringstream out;
  out << "graph " << graph.top_name << '\n';
  for (std::size_t id = 1; id < graph.nodes.size(); ++id) {
    const Node& node = graph.nodes[id];
    out << "  n" << id << ": " << name_of(node.op) << ' ' << node.width;
    if (node.op == Op::kRom) out << " #" << node.port;
    for (const Bits& operand : node.operands) out << ' ' << text(operand);
    if (!node.name.empty()) out << "  ; " << node.name;
    if (!node.where.file.empty())
      out << "  @" << node.where.file.substr(node.where.file.rfind('/') + 1) << ':' << node.where.line;
    out << '\n';
  }
  for (const State& state : graph.states) {
    out << "  state " << state.name << ' ' << state.width << " = ";
    for (std::size_t i = state.initial.size(); i-- > 0;) out << (state.initial[i] ? '1' : '0');
    out << ", next " << text(state.next) << '\n';
  }
  for (const Ram& ram : graph.rams) {
    out << "  ram " << ram.name << ' ' << ram.depth << " x " << ram.width << ", distance " << ram.distance
        << "\n    read " << text(ram.read_address) << " if " << text({ram.read_enable}) << "\n    write "
        << text(ram.write_address) << " <- " << text(ram.write_data) << " if " << text({ram.write_enable}) << '\n';
  }
  for (std::size_t i = 0; i < graph.roms.size(); ++i) {
    out << "  rom #" << i << ' ' << graph.roms[i].name << ' ' << graph.roms[i].words.size() << " x "
        << graph.roms[i].width << '\n';
  }
  for (const Port& port : graph.outputs) out << "  output " << port.name << " = " << text(port.value) << '\n';
  out << "  valid = " << text({graph.output_valid}) << '\n';
  return out.str();
}

}  // namespace hlsc
