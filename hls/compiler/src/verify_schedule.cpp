// SPDX-License-Identifier: Apache-2.0
// The check of a schedule, written from the rules in schedule.hpp alone.
#include <algorithm>
#include <cmath>

#include "hlsc/schedule.hpp"

namespace hlsc {

namespace {

/// Nodes on a path from a state's value back to its next value, states of other recurrences passed through.
std::vector<bool> recurrent_nodes(const Graph& graph) {
  const std::size_t count = graph.nodes.size();
  std::vector<std::vector<NodeId>> sources(count), users(count);
  const auto connect = [&](const Bits& bits, NodeId to) {
    for (Bit b : bits) {
      if (b.node == 0 || (!sources[to].empty() && sources[to].back() == b.node)) continue;
      sources[to].push_back(b.node);
      users[b.node].push_back(to);
    }
  };
  for (NodeId n = 1; n < count; ++n) {
    for (const Bits& operand : graph.nodes[n].operands) connect(operand, n);
  }
  for (const State& state : graph.states) connect(state.next, state.read);
  const auto reach = [&](NodeId from, const std::vector<std::vector<NodeId>>& edges) {
    std::vector<bool> reached(count, false);
    std::vector<NodeId> work{from};
    while (!work.empty()) {
      const NodeId n = work.back();
      work.pop_back();
      for (NodeId next : edges[n]) {
        if (reached[next]) continue;
        reached[next] = true;
        work.push_back(next);
      }
    }
    return reached;
  };
  std::vector<bool> recurrent(count, false);
  for (const State& state : graph.states) {
    if (recurrent[state.read]) continue;
    const auto after = reach(state.read, users), before = reach(state.read, sources);
    for (NodeId n = 1; n < count; ++n) recurrent[n] = recurrent[n] || (after[n] && before[n]);
  }
  return recurrent;
}

}  // namespace

std::vector<std::string> verify_schedule(const Graph& graph, const Schedule& result) {
  std::vector<std::string> problems;
  const auto& delays = result.options.delays;
  const std::vector<bool> recurrent = recurrent_nodes(graph);
  const double limit = result.options.clock_ns - delays.setup_ns + 1e-6;
  const auto problem = [&](const std::string& text) { problems.push_back(text); };
  const auto describe = [&](NodeId n) {
    const Node& node = graph.nodes[n];
    return "node " + std::to_string(n) + (node.name.empty() ? "" : " '" + node.name + "'") + " (" + node.where.file +
           ":" + std::to_string(node.where.line) + ")";
  };
  const bool registered = registered_outputs(result.options);
  if (result.latency < (registered ? 1 : 0)) problem("latency below 1");
  const int last = registered ? result.latency - 1 : result.latency;  // stage
  if (result.stage.size() != graph.nodes.size()) return {"a stage for each node is missing"};

  // A bit is usable in `stage` if it is made there or earlier.
  const auto usable = [&](Bit b, int stage) {
    if (b.node == 0) return true;
    const int made = result.stage[b.node];
    return made == kEveryStage || (made >= 0 && made <= stage);
  };
  const auto all_usable = [&](const Bits& bits, int stage) {
    return std::ranges::all_of(bits, [&](Bit b) { return usable(b, stage); });
  };

  std::vector<double> arrival(graph.nodes.size(), 0.0);
  const auto latest = [&](const Bits& bits, int stage) {
    double at = 0;
    for (Bit b : bits) {
      if (b.node == 0) continue;
      const int made = result.stage[b.node];
      const double route = made == kEveryStage ? delays.config_route_ns
                                               : delays.route_ns(graph.nodes[b.node], result.synchronous_rom[b.node]);
      const double launch = delays.launch_ns + route;
      at = std::max(at, made == stage ? arrival[b.node] : launch);
    }
    return at;
  };
  const auto in_time = [&](double ns, const std::string& what, bool may_overrun) {
    const double allowed = may_overrun ? limit * result.options.recurrence_overrun : limit;
    if (ns > allowed && !result.options.allow_slow) {
      problem(what + " is late: " + std::to_string(ns) + " ns of " + std::to_string(allowed));
    }
  };

  for (NodeId n = 1; n < graph.nodes.size(); ++n) {
    const Node& node = graph.nodes[n];
    const int stage = result.stage[n];
    if (stage == kDead) continue;
    if (stage > last) problem(describe(n) + " lies beyond the last stage");
    double at = delays.launch_ns;
    switch (node.op) {
      case Op::kInput:
        at = std::max(at, result.options.input_ns);
        if (stage != 0) problem(describe(n) + ": an input outside stage 0");
        break;
      case Op::kConfig:
        if (stage != kEveryStage) problem(describe(n) + ": configuration in a pipeline stage");
        break;
      case Op::kStateRead: {
        if (stage < 0) problem(describe(n) + ": a state without a stage");
        const State& state = graph.states[node.port];
        if (!all_usable(state.next, stage)) problem("state '" + state.name + "' closes after it was read");
        break;
      }
      case Op::kRamRead: {
        const Ram& ram = graph.rams[node.port];
        const int read = result.ram_read_stage[node.port], write = result.ram_write_stage[node.port];
        if (read < 0 || stage != read + 1) problem("RAM '" + ram.name + "': data not one stage after the address");
        if (!all_usable(ram.read_address, read) || !usable(ram.read_enable, read)) {
          problem("RAM '" + ram.name + "': read address too late");
        }
        in_time(latest(ram.read_address, read) + delays.read_address_ns(ram), "read address of RAM '" + ram.name + "'",
                false);
        if (write == kDead) {
          if (ram.write_enable != kZero) problem("RAM '" + ram.name + "': its write is missing");
        } else {
          if (!(read < write && write < read + static_cast<int>(ram.distance))) {
            problem("RAM '" + ram.name + "': read in stage " + std::to_string(read) + ", write in stage " +
                    std::to_string(write) + ", DISTANCE " + std::to_string(ram.distance));
          }
          if (write > last) problem("RAM '" + ram.name + "': write beyond the last stage");
          if (!all_usable(ram.write_address, write) || !all_usable(ram.write_data, write) ||
              !usable(ram.write_enable, write)) {
            problem("RAM '" + ram.name + "': write too early");
          }
          const double write_ns = std::max(
              {latest(ram.write_address, write), latest(ram.write_data, write), latest({ram.write_enable}, write)});
          in_time(write_ns + delays.memory_setup_ns, "write of RAM '" + ram.name + "'", false);
        }
        at = delays.memory_read_ns;
        break;
      }
      default: {
        const bool table = result.synchronous_rom[n];
        const int needed = table ? stage - 1 : stage;
        if (table && stage < 1) problem(describe(n) + ": a synchronous table in stage 0");
        for (const Bits& operand : node.operands) {
          for (Bit b : operand) {
            if (b.node >= n) problem(describe(n) + ": the graph is not in topological order");
          }
          if (stage == kEveryStage) {
            for (Bit b : operand) {
              if (b.node != 0 && result.stage[b.node] != kEveryStage) problem(describe(n) + " is not constant");
            }
          } else if (!all_usable(operand, needed)) {
            problem(describe(n) + " comes before its operand");
          }
          if (!table) at = std::max(at, latest(operand, stage));
        }
        if (table) {
          in_time(latest(node.operands[0], needed) + delays.memory_setup_ns, "table address of " + describe(n), false);
          at = delays.memory_read_ns;
        } else {
          at += delays.node_ns(graph, node);
        }
        break;
      }
    }
    arrival[n] = at;
    if (stage != kEveryStage) in_time(at, describe(n), recurrent[n]);  // what is quasi-static has more than one clock
  }

  for (const Port& out : graph.outputs) {
    if (!all_usable(out.value, last)) problem("output '" + out.name + "' comes after the last stage");
    if (!registered && latest(out.value, last) > std::max(result.options.output_ns, delays.launch_ns) + 1e-6) {
      problem("output '" + out.name + "' is late: " + std::to_string(latest(out.value, last)) + " ns");
    }
  }
  if (!usable(graph.output_valid, last)) problem("the valid output comes after the last stage");
  return problems;
}

}  // namespace hlsc
