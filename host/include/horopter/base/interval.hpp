// SPDX-License-Identifier: Apache-2.0
// What a count of hits says about the share behind it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace horopter {

struct Interval {
  double low = 0;
  double high = 1;
};

/// Wilson's, 95 %.
inline Interval wilson(std::int64_t hits, std::int64_t of) {
  if (of <= 0) return {};
  constexpr double kQuantile = 1.959964;
  const auto n = static_cast<double>(of), h = static_cast<double>(hits);
  const double middle = h / n + kQuantile * kQuantile / (2 * n);
  const double spread = kQuantile * std::sqrt(h * (n - h) / (n * n * n) + kQuantile * kQuantile / (4 * n * n));
  const double scale = 1 + kQuantile * kQuantile / n;
  return {std::max(0.0, (middle - spread) / scale), std::min(1.0, (middle + spread) / scale)};
}

enum class Goal : std::uint8_t { missed, too_few, reached };

/// Whether a share reaches a goal: the share itself falls short, or so few were counted that it may, or neither.
inline Goal goal_of(std::int64_t hits, std::int64_t of, double goal) {
  if (static_cast<double>(hits) < goal * static_cast<double>(of)) return Goal::missed;
  return wilson(hits, of).low < goal ? Goal::too_few : Goal::reached;
}

}  // namespace horopter
