// SPDX-License-Identifier: Apache-2.0
// How small a body is found, at each place of a skin: IEC 61496's detection capability, by the sizes that machine, rig and
// skin have (M7).
//
// Cameras see the front half of a body, the side towards them. In the skin is what lies within the skin's thickness of it: a
// cap while the front is in the skin, a ring when the front has left it. Between two images the body moves on by speed /
// image rate. What a crossing is certain to show is the least, over all moments at which images may be taken, of the most
// that one of them shows.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "horopter/machine/monitor.hpp"
#include "horopter/plan/plan.hpp"

namespace horopter {

enum class Body {
  ball,  ///< a fist, a head, the end of an arm: it shows least of all bodies of a diameter
  rod,   ///< kRodLength_mm of an arm or leg that lies in the skin
};
std::string_view name_of(Body body);
inline constexpr double kRodLength_mm = 150;
/// A larger body is not asked for.
inline constexpr double kLargestBody_mm = 1000;

/// Least share of a textured disc on the skin that is one object, by its diameter in px of the result: measured, and
/// interpolated. 0 for what is not larger than the rule's windows.
double disc_share(Decision decision, double diameter_px);

/// What is asked of a place.
struct Crossing {
  Decision decision = Decision::thesis;
  Body body = Body::ball;
  double object_limit_px = 0;   ///< pixels of the result that are an alarm: object_limit()
  double step_mm = 0;           ///< that a body goes from image to image, in the mean of `images`; 0: it stands still
  int images = 1;               ///< that must show it
  double object_limit_mm2 = 0;  ///< where it is not 0: the area that is one, instead, whatever a table's codes are off
};

/// The smallest diameter, mm, from which on all bodies are found where the skin is so thick and a px of the result is so
/// many mm. Infinite where kLargestBody_mm is not.
double smallest_body_mm(const Crossing& crossing, double thickness_mm, double mm_per_px);

/// Over the supervised pixels of a frame, or of an even field.
struct CapabilityPlan {
  std::vector<double> body_mm;  ///< of each pixel, row by row; NaN: not supervised; infinite: none is found
  std::int64_t supervised = 0;
  double smallest_mm = 0;  ///< NaN, all three, of nothing; infinite where none is found
  double median_mm = 0;
  double largest_mm = 0;

  /// Of the supervised pixels: those where a body of so many mm is found.
  double share_found(double mm) const;
};
/// `plan`: with a thickness at which what lies in the skin is found (D95).
CapabilityPlan plan_capability(const ThicknessPlan& plan, const MachineProfile& profile, const Crossing& crossing);

/// What `horopter study walk` measured and wrote (walk_table.def; with many crossings, by `--hands`, hands_table.def).
struct Walked {
  Decision decision = Decision::thesis;
  bool taught = false;               ///< what went blind counted
  std::string_view what;             ///< coat of the rods, or disturbance
  std::int64_t object_limit_px = 0;  ///< pixels of the result that were an alarm
  std::int64_t of = 0;               ///< crossings, or frames
  std::int64_t hits = 0;             ///< crossings in which the rod was found in time, or false alarms

  constexpr auto conditions() const { return std::tuple(decision, taught, what, object_limit_px); }
};
/// What crossed there.
struct WalkSetup {
  double rod_mm = 0;
  double rod_px = 0;  ///< its width in px of the result
  double fastest_m_s = 0;
  double images_per_s = 0;
  double thickness_mm = 0;  ///< of the skin, D50
  int frames = 0;           ///< within which it was to be found
};
const WalkSetup& walk_setup();
/// Rods of each coat that crossed the skin; and without a body, disturbances of the light.
std::span<const Walked> walked_rods();
std::span<const Walked> walked_lights();
/// Of the limits that were walked, the one that a limit is nearest to.
std::int64_t nearest_walked_px(std::int64_t object_limit_px);

}  // namespace horopter
