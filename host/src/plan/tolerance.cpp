// SPDX-License-Identifier: Apache-2.0
#include "horopter/plan/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "horopter/base/error.hpp"

namespace horopter {
namespace {

struct Threshold {
  double tolerance_px, percent;
};

constexpr auto kThresholds = std::to_array<Threshold>({
#define THRESHOLD(tolerance_px, percent) {tolerance_px, percent},
#include "threshold_table.def"
#undef THRESHOLD
});

constexpr auto kBoundaries = std::to_array<Boundary>({
#define BOUNDARY(setting, tolerance_px) {setting, tolerance_px},
#include "boundary_table.def"
#undef BOUNDARY
});

[[noreturn]] void refuse(Decision decision, double tolerance_px) {
  const auto [smallest_px, largest_px] = tolerance_range(decision);
  throw UsageError(fmt::format("a tolerance of {:g} px; the rule {} can be set to {:g} to {:g} px", tolerance_px,
                               name_of(decision), smallest_px, largest_px));
}

/// Of the pixels that have one; NaN where none has.
double median(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

ToleranceRange tolerance_range(Decision decision) {
  if (decision == Decision::thesis) return {kThresholds.front().tolerance_px, kThresholds.back().tolerance_px};
  return {kBoundaries.front().tolerance_px, kBoundaries.back().tolerance_px};
}

double threshold_percent_for(double tolerance_px) {
  for (std::size_t i = 1; i < kThresholds.size(); ++i) {
    const Threshold& low = kThresholds[i - 1];
    const Threshold& high = kThresholds[i];
    if (!(tolerance_px >= low.tolerance_px && tolerance_px <= high.tolerance_px)) continue;  // a NaN is in none
    return low.percent +
           (high.percent - low.percent) * (tolerance_px - low.tolerance_px) / (high.tolerance_px - low.tolerance_px);
  }
  refuse(Decision::thesis, tolerance_px);
}

Boundary boundary_for(double tolerance_px) {
  const auto [smallest_px, largest_px] = tolerance_range(Decision::compete);
  const double half_step_px = (largest_px - smallest_px) / (2 * (kBoundaries.size() - 1));
  if (!(tolerance_px >= smallest_px - half_step_px && tolerance_px <= largest_px + half_step_px)) {
    refuse(Decision::compete, tolerance_px);
  }
  return *std::ranges::min_element(
      kBoundaries, {}, [&](const Boundary& boundary) { return std::abs(boundary.tolerance_px - tolerance_px); });
}

double set_tolerance(Settings& settings, double tolerance_px) {
  if (settings.decision == Decision::thesis) {
    settings.threshold_percent = threshold_percent_for(tolerance_px);
    return tolerance_px;
  }
  const Boundary boundary = boundary_for(tolerance_px);
  settings.competition.boundary = boundary.setting;
  return boundary.tolerance_px;
}

double tolerance_for_mm(double thickness_mm, const CameraPair& cameras, const Surface& surface,
                        const MachineProfile& profile, const ScanGeometry& geometry) {
  // Thickness is proportional to the tolerance but for its square over that of the disparity.
  double tolerance_px = kD95_px;
  for (int step = 0; step < 2; ++step) {
    const double found_mm = median(plan_thickness(cameras, surface, profile, geometry, tolerance_px).across_mm);
    if (std::isnan(found_mm)) throw std::invalid_argument("nothing of the skin is supervised");
    tolerance_px *= thickness_mm / found_mm;
    if (tolerance_px > 4 * tolerance_range(Decision::thesis).largest_px) break;  // refused anyway
  }
  return tolerance_px;
}

double d95_px(const Settings& settings) {
  if (settings.decision == Decision::compete) {
    const int least = Settings{}.competition.boundary;
    if (settings.competition.boundary >= least) return kD95_px;
    throw UsageError(fmt::format(
        "a boundary of {}: it is not known up to which disparity it finds 95 % of an object (D95), which "
        "moving skins and `plan capability` are planned for; expected {} or more, a tolerance of {:g} px (D50)",
        settings.competition.boundary, least, kBoundaries[static_cast<std::size_t>(least)].tolerance_px));
  }
  struct Row {
    double threshold_percent, d95_px;
  };
  static constexpr Row kTable[] = {{11.3, 0.4}, {15.0, 0.6}, {18.4, 0.7}, {21.9, 0.9}, {25.1, 1.0}, {28.4, 1.1}};
  const double percent = settings.threshold_percent;
  if (!(percent >= kTable[0].threshold_percent)) {
    throw UsageError(
        fmt::format("a threshold of {:g} %: it is not known up to which disparity it finds 95 % of an object (D95), "
                    "which moving skins and `plan capability` are planned for; expected {:g} % or more (Table 11.2)",
                    percent, kTable[0].threshold_percent));
  }
  for (std::size_t i = 1; i < std::size(kTable); ++i) {
    const auto& [low, low_px] = kTable[i - 1];
    const auto& [high, high_px] = kTable[i];
    if (percent <= high) return low_px + (high_px - low_px) * (percent - low) / (high - low);
  }
  return kTable[std::size(kTable) - 1].d95_px;
}

}  // namespace horopter
