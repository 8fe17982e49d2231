// SPDX-License-Identifier: Apache-2.0
#include "hlsc/rebuild.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace hlsc {

namespace {

bool any(const std::vector<bool>& bits) { return std::find(bits.begin(), bits.end(), true) != bits.end(); }

class LivenessSweep {
 public:
  explicit LivenessSweep(const Draft& draft) : graph_(draft.graph) {
    live_.resize(graph_.nodes.size());
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) live_[i].assign(graph_.nodes[i].width, false);
  }

  Liveness run() {
    for (const Port& port : graph_.outputs) mark(port.value);
    mark(graph_.output_valid);
    do {
      changed_ = false;
      for (std::size_t id = graph_.nodes.size(); id-- > 1;) {
        if (any(live_[id])) visit(static_cast<NodeId>(id));
      }
    } while (changed_);
    return std::move(live_);
  }

 private:
  void mark(Bit bit) {
    if (live_[bit.node][bit.index]) return;
    live_[bit.node][bit.index] = true;
    changed_ = true;
  }
  void mark(const Bits& bits) {
    for (const Bit bit : bits) mark(bit);
  }

  void visit(NodeId id) {
    const Node& node = graph_.nodes[id];
    const std::vector<bool> live = live_[id];
    switch (node.op) {
      case Op::kStateRead:
        for (std::size_t i = 0; i < live.size(); ++i) {
          if (live[i]) mark(graph_.states[node.port].next[i]);
        }
        return;
      case Op::kRamRead: {
        const Ram& ram = graph_.rams[node.port];
        mark(ram.read_address);
        mark(ram.read_enable);
        mark(ram.write_address);
        mark(ram.write_enable);
        for (std::size_t i = 0; i < live.size(); ++i) {
          if (live[i]) mark(ram.write_data[i]);
        }
        return;
      }
      case Op::kAnd:
      case Op::kOr:
      case Op::kXor:
      case Op::kNot:
        for (const Bits& operand : node.operands) {
          for (std::size_t i = 0; i < live.size(); ++i) {
            if (live[i]) mark(operand[i]);
          }
        }
        return;
      case Op::kMux:
        mark(node.operands[0]);
        for (std::size_t i = 0; i < live.size(); ++i) {
          if (!live[i]) continue;
          mark(node.operands[1][i]);
          mark(node.operands[2][i]);
        }
        return;
      case Op::kAdd:
      case Op::kSub:
      case Op::kMul:
      case Op::kMulSigned: {
        std::size_t top = live.size();
        while (!live[top - 1]) --top;
        for (const Bits& operand : node.operands) {
          for (std::size_t i = 0; i < std::min(top, operand.size()); ++i) mark(operand[i]);
        }
        return;
      }
      default:
        for (const Bits& operand : node.operands) mark(operand);
    }
  }

  const Graph& graph_;
  Liveness live_;
  bool changed_ = false;
};

}  // namespace

Liveness liveness(const Draft& draft) { return LivenessSweep(draft).run(); }

Assumptions::Assumptions(const Draft& draft) {
  for (const State& state : draft.graph.states) states.emplace_back(state.width);
  for (const Ram& ram : draft.graph.rams) rams.emplace_back(ram.width);
}

Rebuild::Rebuild(const Draft& from, const Liveness& live, const Assumptions& assumptions, Purpose purpose)
    : from_(from), live_(live), assumptions_(assumptions), purpose_(purpose) {
  bits_.resize(from.graph.nodes.size());
  sources_.resize(from.graph.nodes.size());
  dead_ = builder_.undefined(1, "a bit nobody uses (internal error)")[0];
  make_sources();
  substitute();
  for (NodeId id = 1; id < from.graph.nodes.size(); ++id) make(id);
}

void Rebuild::again() {
  const Graph& graph = from_.graph;
  const std::vector<Bits> before = bits_;
  substitute();
  std::vector<bool> changed(graph.nodes.size());
  for (NodeId id = 1; id < graph.nodes.size(); ++id) {
    const Node& node = graph.nodes[id];
    const bool anew = std::ranges::any_of(node.operands, [&](const Bits& operand) {
      return std::ranges::any_of(operand, [&](Bit bit) { return changed[bit.node]; });
    });
    if (anew) {
      bits_[id].clear();
      make(id);
    }
    changed[id] = bits_[id] != before[id];
  }
}

Bits Rebuild::map(const Bits& old) const {
  Bits bits;
  bits.reserve(old.size());
  for (const Bit bit : old) bits.push_back(map(bit));
  return bits;
}

void Rebuild::make_sources() {
  const Graph& graph = from_.graph;
  for (NodeId id = 1; id < graph.nodes.size(); ++id) {
    const Node& node = graph.nodes[id];
    builder_.where = node.where;
    if (node.op == Op::kInput && node.port == kUndefinedPort) {
      bits_[id] = any(live_[id]) ? builder_.undefined(node.width, node.name) : Bits(node.width, dead_);
    } else if (node.op == Op::kInput && node.port == kUnsetPort) {
      bits_[id] = any(live_[id]) ? builder_.unset(node.width, node.name) : Bits(node.width, dead_);
    } else if (node.op == Op::kInput || node.op == Op::kConfig) {
      bits_[id] = builder_.source(node.op, node.port, node.width, node.name);
    }
  }
  // A state or memory keeps the bits that are alive and, in a result, not taken for something else.
  const auto keep = [&](Op op, std::uint32_t port, NodeId read, const std::string& name,
                        const std::vector<Substitute>& substitutes, std::vector<std::uint32_t>& kept) {
    if (read == 0) return;
    for (std::uint32_t i = 0; i < substitutes.size(); ++i) {
      const bool itself = purpose_ == Purpose::kTrial || substitutes[i].kind == Substitute::Kind::kItself;
      if (live_[read][i] && itself) kept.push_back(i);
    }
    sources_[read].assign(substitutes.size(), dead_);
    builder_.where = graph.nodes[read].where;
    const Bits made = kept.empty() ? Bits{} : builder_.source(op, port, static_cast<std::uint32_t>(kept.size()), name);
    for (std::size_t i = 0; i < kept.size(); ++i) sources_[read][kept[i]] = made[i];
  };
  kept_states_.resize(graph.states.size());
  kept_rams_.resize(graph.rams.size());
  for (std::uint32_t i = 0; i < graph.states.size(); ++i) {
    keep(Op::kStateRead, i, graph.states[i].read, graph.states[i].name, assumptions_.states[i], kept_states_[i]);
  }
  for (std::uint32_t i = 0; i < graph.rams.size(); ++i) {
    keep(Op::kRamRead, i, graph.rams[i].read, graph.rams[i].name, assumptions_.rams[i], kept_rams_[i]);
  }
}

/// What states and memories are taken for.
void Rebuild::substitute() {
  const Graph& graph = from_.graph;
  const auto replace = [&](NodeId read, const std::vector<Substitute>& substitutes, const auto& read_of) {
    if (read == 0) return;
    bits_[read] = sources_[read];
    for (std::size_t i = 0; i < substitutes.size(); ++i) {
      const Substitute& as = substitutes[i];
      if (as.kind == Substitute::Kind::kZero) bits_[read][i] = kZero;
      if (as.kind == Substitute::Kind::kOne) bits_[read][i] = kOne;
      if (as.kind == Substitute::Kind::kSame) bits_[read][i] = sources_[read_of(as.state)][as.bit];
    }
  };
  for (std::uint32_t i = 0; i < graph.states.size(); ++i) {
    replace(graph.states[i].read, assumptions_.states[i],
            [&](std::uint32_t state) { return graph.states[state].read; });
  }
  for (std::uint32_t i = 0; i < graph.rams.size(); ++i) {
    replace(graph.rams[i].read, assumptions_.rams[i], [&](std::uint32_t) { return graph.rams[i].read; });
  }
}

void Rebuild::make(NodeId id) {
  const Node& node = from_.graph.nodes[id];
  if (!bits_[id].empty()) return;  // a source
  bits_[id].assign(node.width, dead_);
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < node.width; ++i) {
    if (live_[id][i]) wanted.push_back(i);
  }
  if (wanted.empty()) return;
  builder_.where = node.where;
  const auto pick = [&](const Bits& operand) {
    Bits bits;
    for (const std::size_t i : wanted) bits.push_back(map(operand[i]));
    return bits;
  };
  const auto set = [&](const Bits& made) {
    for (std::size_t i = 0; i < wanted.size(); ++i) bits_[id][wanted[i]] = made[i];
    if (!node.name.empty()) builder_.name(made, node.name);
  };
  const auto operand = [&](std::size_t i) { return map(node.operands[i]); };
  const auto narrow = [&](const auto& operation) {
    const std::size_t top = wanted.back() + 1;
    const auto fit = [&](std::size_t i) {
      Bits bits;
      for (std::size_t k = 0; k < std::min(top, node.operands[i].size()); ++k) bits.push_back(map(node.operands[i][k]));
      return node.op == Op::kMulSigned ? Builder::sign_extend(bits, top) : Builder::zero_extend(bits, top);
    };
    const Bits made = operation(fit(0), fit(1));
    Bits chosen;
    for (const std::size_t i : wanted) chosen.push_back(made[i]);
    set(chosen);
  };
  switch (node.op) {
    case Op::kConstant:
    case Op::kInput:
    case Op::kConfig:
    case Op::kStateRead:
    case Op::kRamRead:
      break;
    case Op::kRom:
      set(make_rom(node, wanted));
      break;
    case Op::kAnd:
      set(builder_.bit_and(pick(node.operands[0]), pick(node.operands[1])));
      break;
    case Op::kOr:
      set(builder_.bit_or(pick(node.operands[0]), pick(node.operands[1])));
      break;
    case Op::kXor:
      set(builder_.bit_xor(pick(node.operands[0]), pick(node.operands[1])));
      break;
    case Op::kNot:
      set(builder_.bit_not(pick(node.operands[0])));
      break;
    case Op::kMux:
      set(builder_.mux(map(node.operands[0][0]), pick(node.operands[1]), pick(node.operands[2])));
      break;
    case Op::kAdd:
      narrow([&](const Bits& a, const Bits& b) { return builder_.add(a, b); });
      break;
    case Op::kSub:
      narrow([&](const Bits& a, const Bits& b) { return builder_.sub(a, b); });
      break;
    case Op::kMul:
    case Op::kMulSigned:
      narrow([&](const Bits& a, const Bits& b) { return builder_.mul(a, b); });
      break;
    case Op::kShl:
    case Op::kLshr:
    case Op::kAshr: {
      const Bits a = operand(0), amount = operand(1);
      const Bits made = node.op == Op::kShl    ? builder_.shl(a, amount)
                        : node.op == Op::kLshr ? builder_.lshr(a, amount)
                                               : builder_.ashr(a, amount);
      Bits chosen;
      for (const std::size_t i : wanted) chosen.push_back(made[i]);
      set(chosen);
      break;
    }
    case Op::kEq:
      set({builder_.eq(operand(0), operand(1))});
      break;
    case Op::kUlt:
      set({builder_.ult(operand(0), operand(1))});
      break;
    case Op::kSlt:
      set({builder_.slt(operand(0), operand(1))});
      break;
    case Op::kReduceOr:
      set({builder_.reduce_or(operand(0))});
      break;
    case Op::kReduceAnd:
      set({builder_.reduce_and(operand(0))});
      break;
    case Op::kReduceXor:
      set({builder_.reduce_xor(operand(0))});
      break;
  }
}

Bits Rebuild::make_rom(const Node& node, const std::vector<std::size_t>& columns) {
  const Rom& rom = from_.graph.roms[node.port];
  const Bits address = map(node.operands[0]);
  // Constant address bits select a part of the table.
  Bits varying;
  std::vector<std::size_t> weight;
  std::size_t base = 0;
  for (std::size_t i = 0; i < address.size(); ++i) {
    if (address[i] == kOne) {
      base |= std::size_t{1} << i;
    } else if (address[i] != kZero) {
      const auto known = std::find(varying.begin(), varying.end(), address[i]);
      if (known != varying.end()) {
        weight[static_cast<std::size_t>(known - varying.begin())] |= std::size_t{1} << i;
      } else {
        varying.push_back(address[i]);
        weight.push_back(std::size_t{1} << i);
      }
    }
  }
  std::vector<std::size_t> rows;  // of the old table, in the order of the new one
  for (std::size_t word = 0; word < (std::size_t{1} << varying.size()); ++word) {
    std::size_t row = base;
    for (std::size_t i = 0; i < varying.size(); ++i) row |= ((word >> i) & 1) != 0 ? weight[i] : 0;
    rows.push_back(row);
  }
  Bits result(columns.size());
  std::map<std::vector<bool>, std::size_t> distinct;
  std::vector<std::size_t> place(columns.size(), 0);
  Rom made;
  made.name = rom.name;
  std::vector<std::vector<bool>> contents;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::vector<bool> column;
    bool constant = true;
    std::optional<bool> first;
    for (const std::size_t row : rows) {
      const bool inside = row < rom.words.size(), bit = inside && rom.words[row][columns[i]];
      column.push_back(bit);
      if (!inside) continue;  // never read
      if (!first) first = bit;
      constant &= bit == *first;
    }
    if (constant) {
      result[i] = first.value_or(false) ? kOne : kZero;
      continue;
    }
    const auto [found, added] = distinct.try_emplace(column, contents.size());
    if (added) contents.push_back(column);
    place[i] = found->second + 1;
  }
  if (contents.empty()) return result;
  made.width = static_cast<std::uint32_t>(contents.size());
  std::size_t used = 0;
  for (std::size_t word = 0; word < rows.size(); ++word) {
    std::vector<bool> bits;
    for (const std::vector<bool>& column : contents) bits.push_back(column[word]);
    made.words.push_back(bits);
    if (rows[word] < rom.words.size()) used = word + 1;
  }
  made.words.resize(used);
  std::uint32_t port = 0;
  while (port < roms_.size() && (roms_[port].words != made.words || roms_[port].name != made.name)) ++port;
  if (port == roms_.size()) roms_.push_back(std::move(made));
  const Bits data = builder_.rom(port, varying, static_cast<std::uint32_t>(contents.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (place[i] != 0) result[i] = data[place[i] - 1];
  }
  return result;
}

Draft Rebuild::take() {
  Draft result;
  const Graph& old = from_.graph;
  Graph& graph = result.graph;
  graph.top_name = old.top_name;
  graph.source_file = old.source_file;
  graph.inputs = old.inputs;
  graph.configs = old.configs;
  graph.outputs = old.outputs;
  for (Port& port : graph.inputs) port.node = bits_[port.node].at(0).node;
  for (Port& port : graph.configs) port.node = bits_[port.node].at(0).node;
  for (Port& port : graph.outputs) port.value = map(port.value);
  graph.output_valid = map(old.output_valid);
  result.output_where = from_.output_where;

  std::map<std::uint32_t, std::uint32_t> state_number, ram_number;
  for (std::uint32_t i = 0; i < old.states.size(); ++i) {
    if (kept_states_[i].empty()) continue;
    const State& from = old.states[i];
    State state;
    state.name = from.name;
    state.kept = from.kept;
    state.width = static_cast<std::uint32_t>(kept_states_[i].size());
    state.read = bits_[from.read][kept_states_[i][0]].node;
    std::vector<bool> uninitialised;
    for (const std::uint32_t bit : kept_states_[i]) {
      state.initial.push_back(from.initial[bit]);
      state.next.push_back(map(from.next[bit]));
      uninitialised.push_back(from_.uninitialised[i][bit]);
    }
    state_number[i] = static_cast<std::uint32_t>(graph.states.size());
    graph.states.push_back(std::move(state));
    result.uninitialised.push_back(std::move(uninitialised));
    result.state_where.push_back(from_.state_where[i]);
  }
  for (std::uint32_t i = 0; i < old.rams.size(); ++i) {
    if (kept_rams_[i].empty()) continue;
    const Ram& from = old.rams[i];
    Ram ram = from;
    ram.width = static_cast<std::uint32_t>(kept_rams_[i].size());
    ram.read = bits_[from.read][kept_rams_[i][0]].node;
    ram.read_address = map(from.read_address);
    ram.read_enable = map(from.read_enable);
    ram.write_address = map(from.write_address);
    ram.write_enable = map(from.write_enable);
    ram.write_data.clear();
    for (const std::uint32_t bit : kept_rams_[i]) ram.write_data.push_back(map(from.write_data[bit]));
    ram_number[i] = static_cast<std::uint32_t>(graph.rams.size());
    graph.rams.push_back(std::move(ram));
  }
  graph.roms = std::move(roms_);
  graph.nodes = std::move(builder_.nodes());
  for (Node& node : graph.nodes) {
    if (node.op == Op::kStateRead) node.port = state_number.at(node.port);
    if (node.op == Op::kRamRead) node.port = ram_number.at(node.port);
  }
  return result;
}

}  // namespace hlsc
