// SPDX-License-Identifier: Apache-2.0
#include "hlsc/schedule.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace hlsc {

namespace {

std::string place(const SourceLocation& where) {
  return where.file.empty() ? std::string("<unknown>") : where.file + ":" + std::to_string(where.line);
}

std::string format_ns(double ns) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f ns", ns);
  return text;
}

constexpr double kEpsilonNs = 1e-9;

}  // namespace

namespace {

/// Variables of the scheduling problem: one per node, two per RAM (address, write), one per synchronous ROM's address,
/// and the end of the pipeline (its stage is the latency).
class Scheduler {
 public:
  Scheduler(const Graph& graph, const ScheduleOptions& options) : g_(graph), o_(options) {}

  Schedule run() {
    find_live();
    find_static();
    build_items();
    build_edges();
    find_recurrences();
    check_single_operations();
    build_timing();
    as_soon_as_possible();
    if (o_.minimise_registers) minimise_registers();
    return result();
  }

 private:
  using Item = std::uint32_t;
  static constexpr Item kNone = ~0U;
  enum class EdgeKind { kData, kClose, kMemory, kDistance, kEnd, kTiming };
  struct Edge {
    Item from, to;
    int difference;
    EdgeKind kind;
  };

  // Preparation -------------------------------------------------------------------------------------------------------

  void find_live() {
    live_.assign(g_.nodes.size(), false);
    ram_live_.assign(g_.rams.size(), false);
    std::vector<NodeId> work;
    const auto mark = [&](Bit b) {
      if (b.node != 0 && !live_[b.node]) {
        live_[b.node] = true;
        work.push_back(b.node);
      }
    };
    const auto mark_all = [&](const Bits& bits) {
      for (Bit b : bits) mark(b);
    };
    for (const auto& out : g_.outputs) mark_all(out.value);
    mark(g_.output_valid);
    while (!work.empty()) {
      const Node& node = g_.nodes[work.back()];
      work.pop_back();
      for (const auto& operand : node.operands) mark_all(operand);
      if (node.op == Op::kStateRead) mark_all(g_.states[node.port].next);
      if (node.op == Op::kRamRead) {
        const Ram& ram = g_.rams[node.port];
        ram_live_[node.port] = true;
        mark_all(ram.read_address);
        mark(ram.read_enable);
        mark_all(ram.write_address);
        mark_all(ram.write_data);
        mark(ram.write_enable);
      }
    }
  }

  /// What depends on configuration alone. It is quasi-static: its paths have more than one clock, so only what follows
  /// counts against the clock.
  void find_static() {
    static_.assign(g_.nodes.size(), false);
    static_[0] = true;
    std::vector<double> settled(g_.nodes.size(), 0.0);
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      const Node& node = g_.nodes[n];
      settled[n] = o_.delays.launch_ns;
      if (node.op == Op::kConfig) static_[n] = true;
      if (node.operands.empty()) continue;
      bool all = true;
      for (const auto& operand : node.operands) {
        for (Bit b : operand) {
          all = all && static_[b.node];
          settled[n] = std::max(settled[n], settled[b.node]);
        }
      }
      static_[n] = all;
      settled[n] = all ? settled[n] + o_.delays.node_ns(g_, node) : o_.delays.launch_ns;
      if (all && live_[n] && settled[n] > 2 * limit()) {
        warnings_.push_back(place(node.where) + ": warning: an expression of configuration values needs " +
                            format_ns(settled[n]) + ", more than two clocks; compute it on the host");
      }
    }
  }

  bool scheduled(NodeId n) const { return n != 0 && live_[n] && !static_[n]; }

  void build_items() {
    const auto nodes = static_cast<Item>(g_.nodes.size());
    Item next = nodes;
    ram_address_.assign(g_.rams.size(), kNone);
    ram_write_.assign(g_.rams.size(), kNone);
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (!ram_live_[r]) continue;
      ram_address_[r] = next++;
      if (g_.rams[r].write_enable != kZero) ram_write_[r] = next++;
    }
    rom_address_.assign(nodes, kNone);
    for (NodeId n = 1; n < nodes; ++n) {
      if (g_.nodes[n].op != Op::kRom || !scheduled(n)) continue;
      const Rom& rom = g_.roms[g_.nodes[n].port];
      const auto bits = static_cast<std::uint64_t>(rom.words.size()) * g_.nodes[n].width;
      if (bits >= o_.delays.synchronous_rom_bits) rom_address_[n] = next++;
    }
    // A table inside a recurrence cannot spend a clock: found by looking for a path from its data back to its address.
    for (NodeId n = 1; n < nodes; ++n) {
      if (rom_address_[n] != kNone && feeds_itself(n)) rom_address_[n] = kNone;
    }
    end_ = next++;
    items_ = next;
    delay_.assign(items_, 0.0);
    start_.assign(items_, o_.delays.launch_ns);
    for (NodeId n = 1; n < nodes; ++n) {
      if (!scheduled(n)) continue;
      const Node& node = g_.nodes[n];
      delay_[n] =
          rom_address_[n] != kNone ? o_.delays.memory_read_ns - o_.delays.launch_ns : o_.delays.node_ns(g_, node);
      if (rom_address_[n] == kNone) start_[n] += longest_route_ns(node);
    }
    for (const NodeId n : inputs()) start_[n] = std::max(o_.delays.launch_ns, o_.input_ns);
    // What a clock has left after output_ns is for what the outputs go to.
    if (!registered_outputs(o_)) delay_[end_] = std::max(0.0, limit() - o_.output_ns);
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (!ram_live_[r]) continue;
      delay_[ram_address_[r]] = o_.delays.read_address_ns(g_.rams[r]);
      if (ram_write_[r] != kNone) delay_[ram_write_[r]] = o_.delays.memory_setup_ns;
    }
    for (Item a : rom_address_) {
      if (a != kNone) delay_[a] = o_.delays.memory_setup_ns;
    }
  }

  /// To a node, from the registers of its operands.
  double longest_route_ns(const Node& node) const {
    double longest = 0;
    for (const Bits& operand : node.operands) {
      for (Bit b : operand) {
        if (b.node == 0) continue;
        longest =
            std::max(longest, static_[b.node] ? o_.delays.config_route_ns
                                              : o_.delays.route_ns(g_.nodes[b.node], rom_address_[b.node] != kNone));
      }
    }
    return longest;
  }

  std::vector<NodeId> inputs() const {
    std::vector<NodeId> found;
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      if (g_.nodes[n].op == Op::kInput) found.push_back(n);
    }
    return found;
  }

  bool feeds_itself(NodeId rom) const {
    std::vector<bool> reached(g_.nodes.size(), false);
    std::vector<NodeId> work{rom};
    // Backwards from the address, through states, to the table itself.
    while (!work.empty()) {
      const NodeId n = work.back();
      work.pop_back();
      const auto visit = [&](const Bits& bits) {
        for (Bit b : bits) {
          if (b.node != 0 && !reached[b.node]) {
            reached[b.node] = true;
            work.push_back(b.node);
          }
        }
      };
      for (const auto& operand : g_.nodes[n].operands) visit(operand);
      if (g_.nodes[n].op == Op::kStateRead) visit(g_.states[g_.nodes[n].port].next);
    }
    return reached[rom];
  }

  void edge(Item from, Item to, int difference, EdgeKind kind) { edges_.push_back({from, to, difference, kind}); }

  void build_edges() {
    std::set<std::pair<Item, Item>> seen;
    const int behind = registered_outputs(o_) ? 1 : 0;  // stages that the outputs come after what makes them
    const auto data = [&](const Bits& bits, Item to) {
      for (Bit b : bits) {
        if (scheduled(b.node) && seen.emplace(b.node, to).second) edge(b.node, to, 0, EdgeKind::kData);
      }
    };
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      if (!scheduled(n)) continue;
      const Item consumer = rom_address_[n] != kNone ? rom_address_[n] : n;
      for (const auto& operand : g_.nodes[n].operands) data(operand, consumer);
      if (rom_address_[n] != kNone) {
        edge(rom_address_[n], n, 1, EdgeKind::kMemory);
        edge(n, rom_address_[n], -1, EdgeKind::kMemory);
      }
    }
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (!ram_live_[r]) continue;
      const Ram& ram = g_.rams[r];
      data(ram.read_address, ram_address_[r]);
      data({ram.read_enable}, ram_address_[r]);
      edge(ram_address_[r], ram.read, 1, EdgeKind::kMemory);
      edge(ram.read, ram_address_[r], -1, EdgeKind::kMemory);
      if (ram_write_[r] == kNone) continue;
      data(ram.write_address, ram_write_[r]);
      data(ram.write_data, ram_write_[r]);
      data({ram.write_enable}, ram_write_[r]);
      edge(ram_address_[r], ram_write_[r], 1, EdgeKind::kMemory);
      edge(ram_write_[r], end_, behind, EdgeKind::kEnd);
      edge(ram_write_[r], ram_address_[r], 1 - static_cast<int>(ram.distance), EdgeKind::kDistance);
    }
    for (const State& state : g_.states) {
      if (!scheduled(state.read)) continue;
      std::set<Item> sources;
      for (Bit b : state.next) {
        if (scheduled(b.node) && b.node != state.read) sources.insert(b.node);
      }
      for (Item source : sources) edge(source, state.read, 0, EdgeKind::kClose);
    }
    const auto output = [&](Bit b) {
      if (!scheduled(b.node) || !seen.emplace(b.node, end_).second) return;
      edge(b.node, end_, behind, behind == 0 ? EdgeKind::kData : EdgeKind::kEnd);
    };
    for (const auto& out : g_.outputs) std::ranges::for_each(out.value, output);
    output(g_.output_valid);
  }

  // Timing ------------------------------------------------------------------------------------------------------------

  /// Strongly connected components of data, memory and closing edges (Tarjan, iterative).
  void find_recurrences() {
    successors_.assign(items_, {});
    std::vector<std::vector<Item>> all(items_);
    for (const Edge& e : edges_) {
      if (e.kind == EdgeKind::kData) successors_[e.from].push_back(e.to);
      if (e.kind == EdgeKind::kData || e.kind == EdgeKind::kClose) all[e.from].push_back(e.to);
    }
    component_.assign(items_, 0);
    std::vector<std::uint32_t> index(items_, 0), low(items_, 0);
    std::vector<bool> on_stack(items_, false);
    std::vector<Item> stack;
    std::uint32_t counter = 0, components = 0;
    for (Item root = 0; root < items_; ++root) {
      if (index[root] != 0) continue;
      std::vector<std::pair<Item, std::size_t>> calls{{root, 0}};
      index[root] = low[root] = ++counter;
      stack.push_back(root);
      on_stack[root] = true;
      while (!calls.empty()) {
        const Item v = calls.back().first;
        if (calls.back().second < all[v].size()) {
          const Item w = all[v][calls.back().second++];
          if (index[w] == 0) {
            index[w] = low[w] = ++counter;
            stack.push_back(w);
            on_stack[w] = true;
            calls.emplace_back(w, 0);
          } else if (on_stack[w]) {
            low[v] = std::min(low[v], index[w]);
          }
          continue;
        }
        calls.pop_back();
        if (!calls.empty()) low[calls.back().first] = std::min(low[calls.back().first], low[v]);
        if (low[v] == index[v]) {
          ++components;
          in_recurrence_.resize(components + 1, false);
          in_recurrence_[components] = stack.back() != v;
          for (;;) {
            const Item w = stack.back();
            stack.pop_back();
            on_stack[w] = false;
            component_[w] = components;
            if (w == v) break;
          }
        }
      }
    }
  }

  void slow(const SourceLocation& where, const std::string& message) {
    if (!o_.allow_slow) throw ScheduleError(where, message);
    const std::string text = place(where) + ": warning: " + message;
    if (std::ranges::find(warnings_, text) == warnings_.end()) warnings_.push_back(text);
  }

  SourceLocation where_of(Item item) const {
    if (item < g_.nodes.size()) return g_.nodes[item].where;
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (item == ram_address_[r] || item == ram_write_[r]) return g_.rams[r].where;
    }
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      if (rom_address_[n] == item) return g_.nodes[n].where;
    }
    return {g_.source_file, 0};
  }

  std::string name_of(Item item) const {
    if (item < g_.nodes.size()) {
      const Node& node = g_.nodes[item];
      if (node.op == Op::kStateRead) return "state '" + g_.states[node.port].name + "'";
      if (node.op == Op::kRamRead) return "RAM '" + g_.rams[node.port].name + "'";
      if (node.op == Op::kInput) return "input '" + g_.inputs[node.port].name + "'";
      return node.name.empty() ? "operation at " + place(node.where) : "'" + node.name + "'";
    }
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (item == ram_address_[r]) return "read address of RAM '" + g_.rams[r].name + "'";
      if (item == ram_write_[r]) return "write of RAM '" + g_.rams[r].name + "'";
    }
    return item == end_ ? "output" : "table address";
  }

  double limit() const { return o_.clock_ns - o_.delays.setup_ns + kEpsilonNs; }

  void check_single_operations() {
    for (Item i = 0; i < items_; ++i) {
      if (i < g_.nodes.size() && !scheduled(i)) continue;
      if (i == end_ || start_[i] + delay_[i] <= limit()) continue;
      if (in_recurrence_[component_[i]] && start_[i] + delay_[i] <= limit() * o_.recurrence_overrun) continue;
      slow(where_of(i), name_of(i) + " needs " + format_ns(start_[i] + delay_[i] + o_.delays.setup_ns) +
                            " by itself, the clock is " + format_ns(o_.clock_ns));
    }
  }

  /// For each item the first items that a path of combinational logic from it reaches too late: these must lie in a
  /// later stage. Items beyond them follow by precedence.
  void build_timing() {
    // The numbering is a topological order of the data edges: nodes are sorted, other items have no data successors.
    std::vector<double> arrival(items_, -1.0);
    std::vector<std::vector<Item>> frontier(items_);
    std::vector<Item> touched;
    for (Item u = static_cast<Item>(g_.nodes.size()); u-- > 1;) {
      if (!scheduled(u)) continue;
      touched.clear();
      std::set<Item> work{u};
      arrival[u] = start_[u] + delay_[u];
      touched.push_back(u);
      while (!work.empty()) {
        const Item v = *work.begin();
        work.erase(work.begin());
        if (v != u && arrival[v] > limit()) {
          if (component_[u] != component_[v]) {
            frontier[u].push_back(v);
            continue;
          }
          report_recurrence(u);  // tolerated, or only warned about: what follows it outside must still be cut off
        }
        for (Item w : successors_[v]) {
          const double at = arrival[v] + delay_[w];
          if (arrival[w] < 0) touched.push_back(w);
          if (at > arrival[w]) {
            arrival[w] = at;
            work.insert(w);
          }
        }
      }
      for (Item t : touched) arrival[t] = -1.0;
      for (Item v : frontier[u]) {
        const bool implied = std::ranges::any_of(successors_[u], [&](Item s) {
          return s < g_.nodes.size() && s != v && std::ranges::binary_search(frontier[s], v);
        });
        if (!implied) edge(u, v, 1, EdgeKind::kTiming);
      }
      std::ranges::sort(frontier[u]);
    }
  }

  /// A path between two items of one component misses the clock. No schedule can cut it.
  void report_recurrence(Item u) {
    // The longest path within the component, from a register to a register.
    const std::uint32_t component = component_[u];
    if (!reported_.insert(component).second) return;
    std::vector<double> arrival(items_, 0.0);
    std::vector<Item> before(items_, kNone);
    Item worst = u;
    std::string names;
    for (Item i = 1; i < g_.nodes.size(); ++i) {
      if (component_[i] != component || !scheduled(i)) continue;
      if (start_[i] + delay_[i] > arrival[i]) {
        arrival[i] = start_[i] + delay_[i];
        before[i] = kNone;
      }
      if (arrival[i] > arrival[worst]) worst = i;
      if (g_.nodes[i].op == Op::kStateRead) {
        names += (names.empty() ? "'" : ", '") + g_.states[g_.nodes[i].port].name + "'";
      }
      for (Item w : successors_[i]) {
        if (component_[w] == component && arrival[i] + delay_[w] > arrival[w]) {
          arrival[w] = arrival[i] + delay_[w];
          before[w] = i;
        }
      }
    }
    std::string path;
    for (Item i = worst; i != kNone; i = before[i]) {
      if (i < g_.nodes.size() && (before[i] == kNone || !g_.nodes[i].name.empty())) {
        path = name_of(i) + (path.empty() ? "" : " -> " + path);
      }
    }
    if (arrival[worst] <= limit() * o_.recurrence_overrun) return;
    SourceLocation where = where_of(worst);
    for (Item i = 1; i < g_.nodes.size() && where.line == 0; ++i) {
      if (component_[i] == component && scheduled(i)) where = g_.nodes[i].where;
    }
    slow(where, "the recurrence of state " + names + " needs " + format_ns(arrival[worst] + o_.delays.setup_ns) +
                    ", the clock is " + format_ns(o_.clock_ns) + " (longest path: " + path + ")");
  }

  // Solving -----------------------------------------------------------------------------------------------------------

  void as_soon_as_possible() {
    s_.assign(items_, 0);
    s_[end_] = registered_outputs(o_) ? 1 : 0;
    std::vector<std::uint32_t> cause(items_, ~0U);
    // Edges in order of their source make most sweeps single.
    std::vector<std::uint32_t> order(edges_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(edges_[i].from, i); });
    for (;;) {
      bool changed = false;
      for (std::uint32_t i : order) {
        const Edge& e = edges_[i];
        if (s_[e.from] + e.difference > s_[e.to]) {
          s_[e.to] = s_[e.from] + e.difference;
          cause[e.to] = i;
          changed = true;
          if (s_[e.to] > static_cast<int>(items_)) refuse_cycle(e.to, cause);
        }
      }
      if (!changed) return;
    }
  }

  /// Constraints that raise each other for ever contradict each other; the edges that last raised their targets hold a
  /// cycle.
  [[noreturn]] void refuse_cycle(Item start, const std::vector<std::uint32_t>& cause) {
    // Walk back until an item repeats, then once around.
    std::vector<bool> seen(items_, false);
    Item v = start;
    while (!seen[v]) {
      seen[v] = true;
      if (cause[v] == ~0U) throw ScheduleError(where_of(start), "no schedule exists (internal: no cycle found)");
      v = edges_[cause[v]].from;
    }
    std::vector<Edge> cycle;
    for (Item w = v;;) {
      const Edge& e = edges_[cause[w]];
      cycle.push_back(e);
      w = e.from;
      if (w == v) break;
    }
    std::ranges::reverse(cycle);
    std::string through;
    int needed = 0;
    const Edge* distance = nullptr;
    const Edge* memory = nullptr;
    Item state = kNone;
    for (const Edge& e : cycle) {
      if (e.kind == EdgeKind::kDistance) {
        distance = &e;
      } else {
        needed += e.difference;
      }
      if (e.kind == EdgeKind::kMemory) memory = &e;
      if (e.kind == EdgeKind::kClose && state == kNone) state = e.to;
      const bool named = e.from >= g_.nodes.size() || !g_.nodes[e.from].name.empty() ||
                         g_.nodes[e.from].op == Op::kStateRead || g_.nodes[e.from].op == Op::kRamRead;
      if (named) through += (through.empty() ? "" : " -> ") + name_of(e.from);
    }
    if (distance != nullptr) {
      for (std::size_t r = 0; r < g_.rams.size(); ++r) {
        if (ram_write_[r] != distance->from) continue;
        throw ScheduleError(g_.rams[r].where,
                            "RAM '" + g_.rams[r].name + "': its write comes " + std::to_string(needed) +
                                " clocks after its read at " + format_ns(o_.clock_ns) +
                                ", but DISTANCE = " + std::to_string(g_.rams[r].distance) + " allows at most " +
                                std::to_string(static_cast<int>(g_.rams[r].distance) - 1) + " (through " + through +
                                ")");
      }
    }
    if (memory != nullptr && state != kNone) {
      throw ScheduleError(where_of(state), "the recurrence of " + name_of(state) +
                                               " passes through a synchronous memory, which takes a clock (through " +
                                               through + ")");
    }
    throw ScheduleError(where_of(v), "the recurrence through " + through + " needs " + std::to_string(needed) +
                                         " clocks more than it may take");
  }

  /// Each bit of a value needs a register for every stage between its own and its last consumer's. A state whose next
  /// value it is saves one of them.
  void minimise_registers() {
    struct Key {
      std::vector<Item> consumers;
      bool shared;
      auto operator<=>(const Key&) const = default;
    };
    std::map<Bit, std::pair<std::set<Item>, std::set<Item>>> uses;  // consumers, states
    const auto use = [&](const Bits& bits, Item consumer) {
      for (Bit b : bits) {
        if (scheduled(b.node)) uses[b].first.insert(consumer);
      }
    };
    for (NodeId n = 1; n < g_.nodes.size(); ++n) {
      if (!scheduled(n)) continue;
      for (const auto& operand : g_.nodes[n].operands) use(operand, rom_address_[n] != kNone ? rom_address_[n] : n);
    }
    for (std::size_t r = 0; r < g_.rams.size(); ++r) {
      if (!ram_live_[r]) continue;
      use(g_.rams[r].read_address, ram_address_[r]);
      use({g_.rams[r].read_enable}, ram_address_[r]);
      if (ram_write_[r] == kNone) continue;
      use(g_.rams[r].write_address, ram_write_[r]);
      use(g_.rams[r].write_data, ram_write_[r]);
      use({g_.rams[r].write_enable}, ram_write_[r]);
    }
    for (const State& state : g_.states) {
      if (!scheduled(state.read)) continue;
      for (Bit b : state.next) {
        if (scheduled(b.node) && b.node != state.read) uses[b].second.insert(state.read);
      }
    }
    for (const auto& out : g_.outputs) use(out.value, end_);
    if (scheduled(g_.output_valid.node)) uses[g_.output_valid].first.insert(end_);

    std::vector<detail::DifferenceConstraint> constraints;
    for (const Edge& e : edges_) constraints.push_back({e.from, e.to, e.difference});
    std::vector<long> weight(items_, 0);
    std::vector<int> s = s_;
    std::map<std::pair<NodeId, std::pair<std::set<Item>, std::set<Item>>>, long> groups;
    for (const auto& [bit, consumers] : uses) ++groups[{bit.node, consumers}];
    Item next = items_;
    for (const auto& [key, bits] : groups) {
      const auto& [node, sets] = key;
      const Item last = next++;
      int least = s[node] + (sets.second.empty() ? 0 : 1);
      constraints.push_back({node, last, sets.second.empty() ? 0 : 1});
      for (Item c : sets.first) {
        constraints.push_back({c, last, 0});
        least = std::max(least, s[c]);
      }
      for (Item c : sets.second) {
        constraints.push_back({c, last, 1});
        least = std::max(least, s[c] + 1);
      }
      s.push_back(least);
      weight.push_back(bits);
      weight[node] -= bits;
    }
    std::vector<bool> pinned(next, false);
    pinned[end_] = true;
    for (const NodeId n : inputs()) pinned[n] = true;
    detail::minimise_linear(constraints, weight, pinned, s);
    std::copy_n(s.begin(), items_, s_.begin());
  }

  Schedule result() {
    Schedule r;
    r.options = o_;
    r.latency = s_[end_];
    r.stage.assign(g_.nodes.size(), kDead);
    r.arrival_ns.assign(g_.nodes.size(), 0.0);
    r.synchronous_rom.assign(g_.nodes.size(), false);
    r.ram_read_stage.assign(g_.rams.size(), kDead);
    r.ram_write_stage.assign(g_.rams.size(), kDead);
    const int stages = r.latency + (registered_outputs(o_) ? 0 : 1);
    r.stage_delay_ns.assign(static_cast<std::size_t>(stages), o_.delays.launch_ns + o_.delays.setup_ns);
    std::vector<double> arrival(items_, 0.0);
    for (Item i = 0; i < items_; ++i) arrival[i] = start_[i];
    std::vector<std::vector<Item>> predecessors(items_);
    for (const Edge& e : edges_) {
      if (e.kind == EdgeKind::kData) predecessors[e.to].push_back(e.from);
    }
    const auto settle = [&](Item i) {
      for (Item p : predecessors[i]) {
        if (s_[p] == s_[i]) arrival[i] = std::max(arrival[i], arrival[p]);
      }
      arrival[i] += delay_[i];
      auto& worst = r.stage_delay_ns[static_cast<std::size_t>(s_[i])];
      worst = std::max(worst, arrival[i] + o_.delays.setup_ns);
    };
    for (NodeId n = 0; n < g_.nodes.size(); ++n) {
      if (n == 0 || (static_[n] && live_[n])) {
        r.stage[n] = kEveryStage;
        r.arrival_ns[n] = o_.delays.launch_ns;
      }
      if (!scheduled(n)) continue;
      settle(n);
      r.stage[n] = s_[n];
      r.arrival_ns[n] = arrival[n];
      r.synchronous_rom[n] = rom_address_[n] != kNone;
    }
    for (Item i = static_cast<Item>(g_.nodes.size()); i < items_; ++i) {
      if (i != end_) settle(i);
    }
    for (std::size_t k = 0; k < g_.rams.size(); ++k) {
      if (!ram_live_[k]) continue;
      r.ram_read_stage[k] = s_[ram_address_[k]];
      if (ram_write_[k] != kNone) r.ram_write_stage[k] = s_[ram_write_[k]];
    }
    r.warnings = warnings_;
    return r;
  }

  const Graph& g_;
  const ScheduleOptions& o_;
  std::vector<bool> live_, static_, ram_live_;
  std::vector<double> delay_, start_;
  std::vector<Item> ram_address_, ram_write_, rom_address_;
  Item end_ = 0, items_ = 0;
  std::vector<Edge> edges_;
  std::vector<std::vector<Item>> successors_;
  std::vector<std::uint32_t> component_;
  std::vector<bool> in_recurrence_;  ///< of components: of more than one item
  std::set<std::uint32_t> reported_;
  std::vector<int> s_;
  std::vector<std::string> warnings_;
};

}  // namespace

Schedule schedule(const Graph& graph, const ScheduleOptions& options) {
  Schedule result = Scheduler(graph, options).run();
  if (const auto problems = verify_schedule(graph, result); !problems.empty()) {
    std::string text = "internal: the schedule failed its verification:";
    for (const auto& problem : problems) text += "\n  " + problem;
    throw ScheduleError({graph.source_file, 0}, text);
  }
  return result;
}

}  // namespace hlsc
