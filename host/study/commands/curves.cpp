// SPDX-License-Identifier: Apache-2.0
#include "curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace horopter::cli {

double departure_from_line(const Points& points) {
  const auto n = static_cast<double>(points.size());
  double sx = 0;
  double sy = 0;
  double sxx = 0;
  double sxy = 0;
  for (const auto& [x, y] : points) {
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  double furthest = 0;
  for (const auto& [x, y] : points) furthest = std::max(furthest, std::abs(y - sy / n - slope * (x - sx / n)));
  const double rise = std::abs(slope) * (points.back().first - points.front().first);
  return rise > 0 ? furthest / rise : INFINITY;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto ranks = [](const std::vector<double>& values) {
    std::vector<double> result;
    for (const double value : values)
      result.push_back(static_cast<double>(std::ranges::count_if(values, [&](double other) { return other < value; })));
    return result;
  };
  const std::vector<double> of_a = ranks(a);
  const std::vector<double> of_b = ranks(b);
  const auto n = static_cast<double>(a.size());
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (of_a[i] - of_b[i]) * (of_a[i] - of_b[i]);
  return 1 - 6 * squares / (n * (n * n - 1));
}

}  // namespace horopter::cli
