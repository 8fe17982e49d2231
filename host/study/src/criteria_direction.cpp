// SPDX-License-Identifier: Apache-2.0
// Criteria of the gradient's direction (thesis eq. 8.5, 8.6), in degrees and square degrees, in floating point.
#include <cmath>

#include "horopter/study/filters.hpp"
#include "window_sums.hpp"

namespace horopter::study {
namespace {

/// Where one of two gradients is 0 the difference is the mean over all directions, 90°; where both are, the default
/// threshold's share, 45°: as in the hardware (hls/stages/difference.hpp).
double degrees_between(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b) ? 45 : 90;
  const double turn = std::abs(a - b);
  return 360 * std::min(turn, 1 - turn);
}

template <bool kSquared>
class DirectionCriterion final : public Criterion {
 public:
  std::string name() const override { return kSquared ? "DSSD" : "DSAD"; }
  Feature feature() const override { return Feature::direction; }
  bool similarity() const override { return false; }
  double worst(int kernel) const override { return (kSquared ? 180.0 * 180.0 : 180.0) * kernel * kernel; }
  Plane compare(Pair& pair) const override {
    const Plane& difference = pair.shared("degrees", [&] {
      Plane result(pair.r().width, pair.r().height);
      for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = degrees_between(pair.r().values[i], pair.s().values[i]);
      return result;
    });
    if constexpr (!kSquared) return box_sum(difference, pair.kernel());
    const Plane& squares = pair.shared("degrees²", [&] {
      Plane result = difference;
      for (double& value : result.values) value *= value;
      return result;
    });
    return box_sum(squares, pair.kernel());
  }
};

}  // namespace

std::vector<std::unique_ptr<Criterion>> direction_criteria() {
  std::vector<std::unique_ptr<Criterion>> result;
  result.push_back(std::make_unique<DirectionCriterion<false>>());
  result.push_back(std::make_unique<DirectionCriterion<true>>());
  return result;
}

}  // namespace horopter::study
