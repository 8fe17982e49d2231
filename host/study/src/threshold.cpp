// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/threshold.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace horopter::study {
namespace {

struct Row {
  double tolerance_px, percent;
};

constexpr auto table = std::to_array<Row>({
#define THRESHOLD(tolerance_px, percent) {tolerance_px, percent},
#include "threshold_table.def"
#undef THRESHOLD
});

}  // namespace

double smallest_tolerance_px() { return table.front().tolerance_px; }
double largest_tolerance_px() { return table.back().tolerance_px; }

double threshold_percent_for(double tolerance_px) {
  for (std::size_t i = 1; i < table.size(); ++i) {
    const Row& low = table[i - 1];
    const Row& high = table[i];
    if (!(tolerance_px >= low.tolerance_px && tolerance_px <= high.tolerance_px)) continue;  // a NaN is in none
    return low.percent +
           (high.percent - low.percent) * (tolerance_px - low.tolerance_px) / (high.tolerance_px - low.tolerance_px);
  }
  throw std::out_of_range(fmt::format("a tolerance of {} px: thresholds are known for {} to {} px", tolerance_px,
                                      smallest_tolerance_px(), largest_tolerance_px()));
}

}  // namespace horopter::study
