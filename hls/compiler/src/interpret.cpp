// SPDX-License-Identifier: Apache-2.0
#include "hlsc/interpret.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hlsc {

namespace {

Value resized(Value value, std::size_t width, bool is_signed) {
  const bool fill = is_signed && !value.empty() && value.back();
  value.resize(width, fill);
  return value;
}

Value add(const Value& a, const Value& b, bool carry) {
  Value sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int total = a[i] + b[i] + carry;
    sum[i] = (total & 1) != 0;
    carry = total > 1;
  }
  return sum;
}

Value multiply(const Value& a, const Value& b) {
  Value product(a.size(), false);
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!b[i]) continue;
    Value shifted(a.size(), false);
    for (std::size_t k = i; k < a.size(); ++k) shifted[k] = a[k - i];
    product = add(product, shifted, false);
  }
  return product;
}

bool less(const Value& a, const Value& b) {
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return b[i];
  }
  return false;
}

std::size_t address_of(const Value& bits) {
  std::size_t address = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) address |= std::size_t{bits[i]} << i;
  return address;
}

}  // namespace

std::uint64_t to_integer(const Value& value) {
  std::uint64_t integer = 0;
  for (std::size_t i = 0; i < value.size() && i < 64; ++i) integer |= std::uint64_t{value[i]} << i;
  return integer;
}

Value to_value(std::uint64_t value, std::size_t width) {
  Value bits(width);
  for (std::size_t i = 0; i < width; ++i) bits[i] = i < 64 && ((value >> i) & 1) != 0;
  return bits;
}

Interpreter::Interpreter(const Graph& graph, bool check_distance) : graph_(graph), check_distance_(check_distance) {
  values_.resize(graph.nodes.size());
  values_[0] = {false, true};
  for (const State& state : graph.states) states_.push_back(state.initial);
  for (const Ram& ram : graph.rams) {
    memories_.emplace_back(ram.depth, Value(ram.width, false));
    last_write_.emplace_back(ram.depth, 0);
  }
  reset();
}

void Interpreter::reset() {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!graph_.states[i].kept) states_[i] = graph_.states[i].initial;
  }
  for (auto& last : last_write_) std::fill(last.begin(), last.end(), 0);
}

Value Interpreter::bits(const Bits& at) const {
  Value value;
  value.reserve(at.size());
  for (const Bit one : at) value.push_back(bit(one));
  return value;
}

void Interpreter::evaluate(const Node& node, Value& value) {
  const auto operand = [&](std::size_t i) { return bits(node.operands[i]); };
  const auto wide = [&](std::size_t i, bool is_signed) { return resized(operand(i), node.width, is_signed); };
  const auto bitwise = [&](auto operation) {
    const Value a = operand(0), b = operand(1);
    value.resize(node.width);
    for (std::size_t i = 0; i < node.width; ++i) value[i] = operation(a[i], b[i]);
  };
  const auto shift = [&](bool left, bool fill) {
    const Value a = operand(0);
    const Value amount_bits = operand(1);
    const std::size_t amount = std::min<std::size_t>(address_of(amount_bits), node.width);
    value.assign(node.width, fill);
    for (std::size_t i = 0; i + amount < node.width; ++i) {
      if (left) {
        value[i + amount] = a[i];
      } else {
        value[i] = a[i + amount];
      }
    }
    if (left) std::fill_n(value.begin(), static_cast<std::ptrdiff_t>(amount), false);
  };
  switch (node.op) {
    case Op::kConstant:
    case Op::kInput:
    case Op::kConfig:
      return;
    case Op::kStateRead:
      value = states_[node.port];
      return;
    case Op::kRamRead: {
      const Ram& ram = graph_.rams[node.port];
      if (bit(ram.read_enable)) {
        const std::size_t address = address_of(bits(ram.read_address));
        if (address >= ram.depth) throw std::logic_error("memory " + ram.name + ": read beyond its end");
        value = memories_[node.port][address];
        return;
      }
      value.resize(node.width);
      for (std::size_t i = 0; i < node.width; ++i) {
        garbage_ ^= garbage_ << 13;
        garbage_ ^= garbage_ >> 7;
        garbage_ ^= garbage_ << 17;
        value[i] = (garbage_ & 1) != 0;
      }
      return;
    }
    case Op::kRom: {
      const Rom& rom = graph_.roms[node.port];
      const std::size_t address = address_of(operand(0));
      value = address < rom.words.size() ? rom.words[address] : Value(node.width, false);
      return;
    }
    case Op::kAnd:
      bitwise([](bool a, bool b) { return a && b; });
      return;
    case Op::kOr:
      bitwise([](bool a, bool b) { return a || b; });
      return;
    case Op::kXor:
      bitwise([](bool a, bool b) { return a != b; });
      return;
    case Op::kNot:
      value = operand(0);
      value.flip();
      return;
    case Op::kAdd:
      value = add(operand(0), operand(1), false);
      return;
    case Op::kSub: {
      Value inverted = operand(1);
      inverted.flip();
      value = add(operand(0), inverted, true);
      return;
    }
    case Op::kMul:
      value = multiply(wide(0, false), wide(1, false));
      return;
    case Op::kMulSigned:
      value = multiply(wide(0, true), wide(1, true));
      return;
    case Op::kShl:
      shift(true, false);
      return;
    case Op::kLshr:
      shift(false, false);
      return;
    case Op::kAshr:
      shift(false, bit(node.operands[0].back()));
      return;
    case Op::kEq:
      value = {operand(0) == operand(1)};
      return;
    case Op::kUlt:
      value = {less(operand(0), operand(1))};
      return;
    case Op::kSlt: {
      Value a = operand(0), b = operand(1);
      a.back() = !a.back();
      b.back() = !b.back();
      value = {less(a, b)};
      return;
    }
    case Op::kMux:
      value = operand(bit(node.operands[0][0]) ? 1 : 2);
      return;
    case Op::kReduceOr:
    case Op::kReduceAnd:
    case Op::kReduceXor: {
      const Value a = operand(0);
      const auto ones = std::count(a.begin(), a.end(), true);
      value = {node.op == Op::kReduceOr    ? ones != 0
               : node.op == Op::kReduceAnd ? ones == static_cast<std::ptrdiff_t>(a.size())
                                           : ones % 2 != 0};
      return;
    }
  }
}

Interpreter::Result Interpreter::step(const std::vector<Value>& inputs, const std::vector<Value>& configs) {
  for (std::size_t i = 0; i < graph_.inputs.size(); ++i) values_[graph_.inputs[i].node] = inputs.at(i);
  for (std::size_t i = 0; i < graph_.configs.size(); ++i) values_[graph_.configs[i].node] = configs.at(i);
  for (std::size_t i = 1; i < graph_.nodes.size(); ++i) {
    evaluate(graph_.nodes[i], values_[i]);
    if (values_[i].size() != graph_.nodes[i].width)
      throw std::logic_error("node " + std::to_string(i) + " has the wrong width");
  }
  Result result;
  result.valid = bit(graph_.output_valid);
  for (const Port& port : graph_.outputs) result.outputs.push_back(bits(port.value));
  std::vector<Value> next;
  for (const State& state : graph_.states) next.push_back(bits(state.next));
  ++step_;
  for (std::size_t i = 0; i < graph_.rams.size(); ++i) {
    const Ram& ram = graph_.rams[i];
    const auto access = [&](const Bits& at) {
      const std::size_t address = address_of(bits(at));
      if (address >= ram.depth) throw std::logic_error("memory " + ram.name + ": access beyond its end");
      return address;
    };
    if (bit(ram.read_enable)) {
      const std::uint64_t last = last_write_[i][access(ram.read_address)];
      if (check_distance_ && last != 0 && last != step_ && step_ - last < ram.distance) {
        throw std::logic_error("memory " + ram.name + ": a read closer to a write than its DISTANCE");
      }
    }
    if (bit(ram.write_enable)) {
      const std::size_t address = access(ram.write_address);
      memories_[i][address] = bits(ram.write_data);
      last_write_[i][address] = step_;
    }
  }
  states_ = std::move(next);
  return result;
}

}  // namespace hlsc
