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

}  // namespace horopter
