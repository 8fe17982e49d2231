// SPDX-License-Identifier: Apache-2.0
// Least register bits under difference constraints. The dual is a minimum cost flow; this solves the primal by steepest
// ascent: from the least feasible point, raise by one the set of variables that lowers the objective most. Such a set
// is a minimum weight closure under the tight constraints, found by one maximum flow. The objective is L-natural
// convex, so when no set lowers it, it is the minimum (Murota, Discrete Convex Analysis, ch. 10).
#include <algorithm>
#include <limits>
#include <queue>

#include "hlsc/schedule.hpp"

namespace hlsc::detail {

namespace {

class MaximumFlow {  // Dinic
 public:
  explicit MaximumFlow(std::size_t vertices) : head_(vertices, kEnd) {}

  void arc(std::uint32_t from, std::uint32_t to, long capacity) {
    arcs_.push_back({to, head_[from], capacity});
    head_[from] = static_cast<std::uint32_t>(arcs_.size() - 1);
    arcs_.push_back({from, head_[to], 0});
    head_[to] = static_cast<std::uint32_t>(arcs_.size() - 1);
  }

  void run(std::uint32_t source, std::uint32_t sink) {
    while (levels(source, sink)) {
      next_ = head_;
      while (push(source, sink, std::numeric_limits<long>::max()) > 0) {
      }
    }
  }

  /// After run(): on the source's side of the minimum cut nearest to the source.
  bool on_source_side(std::uint32_t vertex) const { return level_[vertex] >= 0; }

 private:
  static constexpr std::uint32_t kEnd = ~0U;
  struct Arc {
    std::uint32_t to, next;
    long capacity;
  };

  bool levels(std::uint32_t source, std::uint32_t sink) {
    level_.assign(head_.size(), -1);
    level_[source] = 0;
    std::queue<std::uint32_t> queue;
    queue.push(source);
    while (!queue.empty()) {
      const auto v = queue.front();
      queue.pop();
      for (auto a = head_[v]; a != kEnd; a = arcs_[a].next) {
        if (arcs_[a].capacity > 0 && level_[arcs_[a].to] < 0) {
          level_[arcs_[a].to] = level_[v] + 1;
          queue.push(arcs_[a].to);
        }
      }
    }
    return level_[sink] >= 0;
  }

  long push(std::uint32_t v, std::uint32_t sink, long limit) {
    if (v == sink) return limit;
    for (auto& a = next_[v]; a != kEnd; a = arcs_[a].next) {
      const auto to = arcs_[a].to;
      if (arcs_[a].capacity <= 0 || level_[to] != level_[v] + 1) continue;
      const long pushed = push(to, sink, std::min(limit, arcs_[a].capacity));
      if (pushed > 0) {
        arcs_[a].capacity -= pushed;
        arcs_[a ^ 1U].capacity += pushed;
        return pushed;
      }
    }
    return 0;
  }

  std::vector<Arc> arcs_;
  std::vector<std::uint32_t> head_, next_;
  std::vector<int> level_;
};

}  // namespace

void minimise_linear(const std::vector<DifferenceConstraint>& constraints, const std::vector<long>& weight,
                     const std::vector<bool>& pinned, std::vector<int>& s) {
  constexpr long kInfinite = std::numeric_limits<long>::max() / 4;
  const auto n = static_cast<std::uint32_t>(s.size());
  for (;;) {
    MaximumFlow flow(n + 2);
    const std::uint32_t source = n, sink = n + 1;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (weight[i] < 0) flow.arc(source, i, -weight[i]);
      if (pinned[i]) {
        flow.arc(i, sink, kInfinite);
      } else if (weight[i] > 0) {
        flow.arc(i, sink, weight[i]);
      }
    }
    for (const auto& c : constraints) {
      if (s[c.to] - s[c.from] == c.difference) flow.arc(c.from, c.to, kInfinite);
    }
    flow.run(source, sink);
    long gain = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (flow.on_source_side(i)) gain -= weight[i];
    }
    if (gain <= 0) return;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (flow.on_source_side(i)) ++s[i];
    }
  }
}

}  // namespace hlsc::detail
