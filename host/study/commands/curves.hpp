// SPDX-License-Identifier: Apache-2.0
// What statements say of curves and of orders, as numbers.
#pragma once

#include <utility>
#include <vector>

namespace horopter::cli {

/// Points (x, y) of some curve.
using Points = std::vector<std::pair<double, double>>;
/// Largest distance of the points from the straight line that fits them best, as a share of their rise.
double departure_from_line(const Points& points);
/// Spearman's: 1 for two lists in the same order, −1 for opposite ones.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace horopter::cli
