// SPDX-License-Identifier: Apache-2.0
#include "horopter/plan/capability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace horopter {
namespace {

struct DiscShare {
  double diameter_px, thesis, compete;
};
constexpr auto kDiscs = std::to_array<DiscShare>({
#define DISC(diameter_px, thesis, compete) {diameter_px, thesis, compete},
#include "horopter/machine/disc_table.def"
#undef DISC
});

constexpr WalkSetup kSetup{
#define SETUP(...) __VA_ARGS__
#define WALK(...)
#define LIGHT(...)
#include "walk_table.def"
#undef SETUP
#undef WALK
};
constexpr auto kRods = [] {
  auto rods = std::to_array<Walked>({
#define SETUP(...)
#define WALK(rule, taught, what, limit_px, of, hits) {Decision::rule, taught, what, limit_px, of, hits},
#include "walk_table.def"
#undef LIGHT
  });
  constexpr auto kHands = std::to_array<Walked>({
#include "hands_table.def"
#undef WALK
  });
  // Of the same conditions, the measurement with more crossings.
  for (Walked& rod : rods) {
    for (const Walked& hands : kHands) {
      if (rod.conditions() == hands.conditions() && hands.of > rod.of) rod = hands;
    }
  }
  return rods;
}();
constexpr auto kLights = std::to_array<Walked>({
#define WALK(...)
#define LIGHT(rule, taught, what, limit_px, of, hits) {Decision::rule, taught, what, limit_px, of, hits},
#include "walk_table.def"
#undef SETUP
#undef WALK
#undef LIGHT
});

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What of a body's surface is in the skin.
struct Part {
  double area_mm2 = 0;
  double width_mm = 0;  ///< the windows leave as little of it as of a disc that is so wide
};

/// The front of a body is `front_mm` behind the front of the skin.
Part part_in_skin(Body body, double radius_mm, double front_mm, double thickness_mm) {
  const auto half_width_mm = [&](double behind_front_mm) {
    const double h = std::clamp(behind_front_mm, 0.0, radius_mm);
    return std::sqrt(2 * radius_mm * h - h * h);
  };
  const double outer = half_width_mm(front_mm);
  const double inner = half_width_mm(front_mm - thickness_mm);
  const bool cap = inner == 0;
  const double width = cap ? 2 * outer : outer - inner;
  // The two sides of a rod may be two objects.
  return {body == Body::ball ? std::numbers::pi * (outer * outer - inner * inner) : kRodLength_mm * width, width};
}

/// Whether every crossing shows the limit.
bool is_found(const Crossing& crossing, double diameter_mm, double thickness_mm, double mm_per_px) {
  constexpr int kPlaces = 160;
  const double radius_mm = diameter_mm / 2;
  const double way_mm = radius_mm + thickness_mm;  // from the first of the surface to the last
  // Within so much of the way there are so many images, whenever they are taken.
  const double needed = crossing.images * crossing.step_mm / way_mm * kPlaces;
  if (!(needed < kPlaces)) return false;
  const int length = static_cast<int>(std::ceil(needed)) + 1;
  const double px_mm2 = mm_per_px * mm_per_px;
  const double limit_px = crossing.object_limit_mm2 > 0 ? crossing.object_limit_mm2 / px_mm2 : crossing.object_limit_px;
  int good = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    const Part part = part_in_skin(crossing.body, radius_mm, way_mm * i / kPlaces, thickness_mm);
    const double pixels = part.area_mm2 / px_mm2;
    good = pixels * disc_share(crossing.decision, part.width_mm / mm_per_px) >= limit_px ? good + 1 : 0;
    if (good >= length) return true;
  }
  return false;
}

/// Down (or up) to a step of 1 %, so that places with nearly the same figures are one.
constexpr double kStep = 1.01;
int step_of(double value, bool up) {
  const double steps = std::log(value) / std::log(kStep);
  return static_cast<int>(up ? std::ceil(steps) : std::floor(steps));
}

}  // namespace

std::string_view name_of(Body body) { return body == Body::ball ? "ball" : "rod"; }

double disc_share(Decision decision, double diameter_px) {
  const auto share = [&](const DiscShare& disc) { return decision == Decision::compete ? disc.compete : disc.thesis; };
  if (!(diameter_px > kDiscs.front().diameter_px)) return 0;
  for (std::size_t i = 1; i < kDiscs.size(); ++i) {
    const DiscShare &low = kDiscs[i - 1], &high = kDiscs[i];
    if (diameter_px > high.diameter_px) continue;
    return share(low) +
           (share(high) - share(low)) * (diameter_px - low.diameter_px) / (high.diameter_px - low.diameter_px);
  }
  return share(kDiscs.back());
}

double smallest_body_mm(const Crossing& crossing, double thickness_mm, double mm_per_px) {
  // From the largest on: what is found must be found in all larger sizes, too.
  double smallest = kInfinity;
  for (double mm = kLargestBody_mm; mm >= 1 && is_found(crossing, mm, thickness_mm, mm_per_px); mm /= kStep)
    smallest = mm;
  return smallest;
}

double CapabilityPlan::share_found(double mm) const {
  if (supervised == 0) return 0;
  const auto found = std::ranges::count_if(body_mm, [&](double smallest) { return smallest <= mm; });
  return static_cast<double>(found) / static_cast<double>(supervised);
}

CapabilityPlan plan_capability(const ThicknessPlan& plan, const MachineProfile& profile, const Crossing& crossing) {
  CapabilityPlan result;
  result.body_mm.assign(plan.across_mm.size(), std::nan(""));
  const double px_of_image = std::sqrt(profile.subsample * profile.fields_per_image());  // along a pixel of the result
  std::map<std::pair<int, int>, double> known;
  std::vector<double> all;
  for (std::size_t i = 0; i < plan.across_mm.size(); ++i) {
    if (std::isnan(plan.across_mm[i])) continue;
    const std::pair steps(step_of(plan.across_mm[i], false), step_of(plan.mm_per_px[i] * px_of_image, true));
    auto found = known.find(steps);
    if (found == known.end()) {
      const double mm = smallest_body_mm(crossing, std::pow(kStep, steps.first), std::pow(kStep, steps.second));
      found = known.emplace(steps, mm).first;
    }
    result.body_mm[i] = found->second;
    all.push_back(found->second);
  }
  result.supervised = static_cast<std::int64_t>(all.size());
  if (all.empty()) {
    result.smallest_mm = result.median_mm = result.largest_mm = std::nan("");
    return result;
  }
  std::ranges::sort(all);
  result.smallest_mm = all.front();
  result.median_mm = all[all.size() / 2];
  result.largest_mm = all.back();
  return result;
}

const WalkSetup& walk_setup() { return kSetup; }
std::span<const Walked> walked_rods() { return kRods; }
std::span<const Walked> walked_lights() { return kLights; }

std::int64_t nearest_walked_px(std::int64_t object_limit_px) {
  const auto away = [&](const Walked& row) {
    return std::abs(std::log(static_cast<double>(row.object_limit_px) / static_cast<double>(object_limit_px)));
  };
  return std::ranges::min_element(kRods, {}, away)->object_limit_px;
}

}  // namespace horopter
