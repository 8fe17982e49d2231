// SPDX-License-Identifier: Apache-2.0
#include "hlsc/shrink.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include "hlsc/diagnostics.hpp"
#include "hlsc/rebuild.hpp"

namespace hlsc {

namespace {

using Kind = Substitute::Kind;

std::size_t size_of(const Draft& draft) {
  std::size_t size = 0;
  for (const Node& node : draft.graph.nodes) size += 1 + node.width;
  return size;
}

Draft clean(const Draft& draft) {
  const Liveness live = liveness(draft);
  const Assumptions assumptions(draft);
  return Rebuild(draft, live, assumptions).take();
}

Draft clean_fully(Draft draft) {
  for (;;) {
    const std::size_t before = size_of(draft);
    draft = clean(draft);
    if (size_of(draft) >= before) return draft;
  }
}

/// All bits that nothing contradicts are constant: assume all, give up those that change, until nothing contradicts.
Assumptions constant_bits(const Draft& draft, const Liveness& live) {
  const Graph& graph = draft.graph;
  Assumptions assumptions(draft);
  for (std::size_t i = 0; i < graph.states.size(); ++i) {
    for (std::uint32_t bit = 0; bit < graph.states[i].width; ++bit) {
      if (draft.uninitialised[i][bit] || graph.states[i].kept) continue;
      assumptions.states[i][bit].kind = graph.states[i].initial[bit] ? Kind::kOne : Kind::kZero;
    }
  }
  for (auto& bits : assumptions.rams) {
    for (Substitute& bit : bits) bit.kind = Kind::kZero;
  }
  Rebuild rebuilt(draft, live, assumptions, Rebuild::Purpose::kTrial);
  for (bool changed = true; changed; rebuilt.again()) {
    changed = false;
    const auto check = [&](Substitute& as, Bit next) {
      if (as.kind == Kind::kItself || rebuilt.map(next) == (as.kind == Kind::kOne ? kOne : kZero)) return;
      as.kind = Kind::kItself;
      changed = true;
    };
    for (std::size_t i = 0; i < graph.states.size(); ++i) {
      for (std::uint32_t bit = 0; bit < graph.states[i].width; ++bit) {
        if (live[graph.states[i].read][bit]) check(assumptions.states[i][bit], graph.states[i].next[bit]);
      }
    }
    for (std::size_t i = 0; i < graph.rams.size(); ++i) {
      const Ram& ram = graph.rams[i];
      if (ram.read == 0 || rebuilt.map(ram.write_enable) == kZero) continue;
      for (std::uint32_t bit = 0; bit < ram.width; ++bit) {
        if (live[ram.read][bit]) check(assumptions.rams[i][bit], ram.write_data[bit]);
      }
    }
  }
  return assumptions;
}

/// Bits that are equal after every number of steps: assume all with the same initial value are, split by their next
/// values.
Assumptions equal_bits(const Draft& draft, const Liveness& live) {
  const Graph& graph = draft.graph;
  using Member = std::pair<std::uint32_t, std::uint32_t>;  // state or memory, bit
  std::vector<std::vector<Member>> state_classes(2), ram_classes;
  for (std::uint32_t i = 0; i < graph.states.size(); ++i) {
    for (std::uint32_t bit = 0; bit < graph.states[i].width; ++bit) {
      if (!live[graph.states[i].read][bit] || draft.uninitialised[i][bit] || graph.states[i].kept) continue;
      state_classes[graph.states[i].initial[bit] ? 1 : 0].emplace_back(i, bit);
    }
  }
  for (std::uint32_t i = 0; i < graph.rams.size(); ++i) {
    ram_classes.emplace_back();
    for (std::uint32_t bit = 0; bit < graph.rams[i].width; ++bit) {
      if (graph.rams[i].read != 0 && live[graph.rams[i].read][bit]) ram_classes.back().emplace_back(i, bit);
    }
  }
  Assumptions assumptions(draft);
  const auto assume = [&] {
    assumptions = Assumptions(draft);
    for (const auto& members : state_classes) {
      for (std::size_t k = 1; k < members.size(); ++k) {
        assumptions.states[members[k].first][members[k].second] = {Kind::kSame, members[0].first, members[0].second};
      }
    }
    for (const auto& members : ram_classes) {
      for (std::size_t k = 1; k < members.size(); ++k) {
        assumptions.rams[members[k].first][members[k].second] = {Kind::kSame, members[0].first, members[0].second};
      }
    }
  };
  assume();
  Rebuild rebuilt(draft, live, assumptions, Rebuild::Purpose::kTrial);
  for (;;) {
    bool changed = false;
    const auto split = [&](std::vector<std::vector<Member>>& classes,
                           const std::function<Bit(const Member&)>& next_of) {
      std::vector<std::vector<Member>> refined;
      for (const auto& members : classes) {
        std::map<Bit, std::size_t> by_next;
        for (const Member& member : members) {
          const auto [found, added] = by_next.try_emplace(rebuilt.map(next_of(member)), refined.size());
          if (added) refined.emplace_back();
          refined[found->second].push_back(member);
        }
        changed |= by_next.size() > 1;
      }
      classes = std::move(refined);
    };
    split(state_classes, [&](const Member& member) { return graph.states[member.first].next[member.second]; });
    split(ram_classes, [&](const Member& member) { return graph.rams[member.first].write_data[member.second]; });
    if (!changed) return assumptions;
    assume();
    rebuilt.again();
  }
}

void check(const Draft& draft) {
  const Graph& graph = draft.graph;
  const Liveness live = liveness(draft);
  for (std::size_t id = 1; id < graph.nodes.size(); ++id) {
    const Node& node = graph.nodes[id];
    if (node.op != Op::kInput || (node.port != kUndefinedPort && node.port != kUnsetPort)) continue;
    if (std::find(live[id].begin(), live[id].end(), true) == live[id].end()) continue;
    const bool sentence =
        node.name.find(" is not set") != std::string::npos || node.name.find(" has no ") != std::string::npos;
    throw CompileError(node.where, sentence ? node.name + " on some path" : node.name + " is used before it is set");
  }
  for (std::size_t i = 0; i < graph.states.size(); ++i) {
    const auto& open = draft.uninitialised[i];
    if (std::find(open.begin(), open.end(), true) == open.end()) continue;
    throw CompileError(draft.state_where[i], "member `" + graph.states[i].name + "` of the stage has no initial value");
  }
}

/// Live nodes only, each after everything it depends on; a memory's data also after its address and enable.
Graph ordered(Draft draft) {
  Graph graph = std::move(draft.graph);
  std::vector<NodeId> number(graph.nodes.size(), 0);
  std::vector<char> mark(graph.nodes.size(), 0);  // 1 being visited, 2 done
  std::vector<Node> nodes{graph.nodes[0]};
  mark[0] = 2;
  const std::function<void(NodeId)> visit = [&](NodeId id) {
    if (mark[id] == 2) return;
    const Node& node = graph.nodes[id];
    if (mark[id] == 1) {
      throw CompileError(node.where, "memory `" + node.name +
                                         "` is read at an address that depends, in the same step, on its own data");
    }
    mark[id] = 1;
    const auto visit_bits = [&](const Bits& bits) {
      for (const Bit bit : bits) visit(bit.node);
    };
    for (const Bits& operand : node.operands) visit_bits(operand);
    if (node.op == Op::kRamRead) {
      visit_bits(graph.rams[node.port].read_address);
      visit(graph.rams[node.port].read_enable.node);
    }
    mark[id] = 2;
    number[id] = static_cast<NodeId>(nodes.size());
    nodes.push_back(node);
  };
  const auto visit_bits = [&](const Bits& bits) {
    for (const Bit bit : bits) visit(bit.node);
  };
  for (const Port& port : graph.inputs) visit(port.node);
  for (const Port& port : graph.configs) visit(port.node);
  for (const State& state : graph.states) visit(state.read);
  for (const Ram& ram : graph.rams) {
    visit(ram.read);
    visit_bits(ram.write_address);
    visit_bits(ram.write_data);
    visit(ram.write_enable.node);
  }
  for (const State& state : graph.states) visit_bits(state.next);
  for (const Port& port : graph.outputs) visit_bits(port.value);
  visit(graph.output_valid.node);

  const auto renumber = [&](Bits& bits) {
    for (Bit& bit : bits) bit.node = number[bit.node];
  };
  for (Node& node : nodes) {
    for (Bits& operand : node.operands) renumber(operand);
  }
  for (Port& port : graph.inputs) port.node = number[port.node];
  for (Port& port : graph.configs) port.node = number[port.node];
  for (Port& port : graph.outputs) renumber(port.value);
  for (State& state : graph.states) {
    state.read = number[state.read];
    renumber(state.next);
  }
  for (Ram& ram : graph.rams) {
    ram.read = number[ram.read];
    renumber(ram.read_address);
    renumber(ram.write_address);
    renumber(ram.write_data);
    ram.read_enable.node = number[ram.read_enable.node];
    ram.write_enable.node = number[ram.write_enable.node];
  }
  graph.output_valid.node = number[graph.output_valid.node];
  graph.nodes = std::move(nodes);
  return graph;
}

}  // namespace

Graph finish(Draft draft) {
  draft = clean_fully(std::move(draft));
  for (;;) {
    const std::size_t before = size_of(draft);
    {
      const Liveness live = liveness(draft);
      draft = Rebuild(draft, live, constant_bits(draft, live)).take();
    }
    draft = clean_fully(std::move(draft));
    {
      const Liveness live = liveness(draft);
      draft = Rebuild(draft, live, equal_bits(draft, live)).take();
    }
    draft = clean_fully(std::move(draft));
    if (size_of(draft) >= before) break;
  }
  check(draft);
  return ordered(std::move(draft));
}

}  // namespace hlsc
