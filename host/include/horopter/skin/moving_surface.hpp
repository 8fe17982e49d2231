// SPDX-License-Identifier: Apache-2.0
// Surfaces that move with a robot: poses, or segments, over time.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "horopter/skin/surface.hpp"

namespace horopter {

/// D95 of Table 11.1: up to this disparity, either way, 95 % of an object's pixels are found. In pixels of the result.
inline constexpr double kD95_px = 0.7;

/// How a skin may move from one frame (or field) to the next, so that no object is missed.
struct MotionLimits {
  double images_per_s = 0;        ///< frames, or fields, a second
  double object_speed_m_s = 0;    ///< of the fastest object that is not to be missed
  double tolerance_px = kD95_px;  ///< disparity tolerance D of 11.1, in pixels of the result
  double late_s = 0;              ///< by which an image may come later after the one before

  double longest_s() const { return 1 / images_per_s + late_s; }  ///< from one frame to the next
};

/// Thickness times images a second (footnote to Table 11.1): a faster object can pass between two images.
double largest_speed_m_s(double thickness_mm, double images_per_s);

class MovingSurface {
 public:
  virtual ~MovingSurface() = default;
  /// Where it is at a time; before 0 as at 0, after the end as at the end.
  virtual SurfacePtr at(double time_s) const = 0;
  /// An upper bound of the way, mm, that matter of the surface has gone from one time to another, where it is at a
  /// point then.
  virtual double way_mm(double from_s, double to_s, const Eigen::Vector3d& point_mm) const = 0;
  virtual double end_s() const = 0;
};

using MovingSurfacePtr = std::shared_ptr<const MovingSurface>;

// These throw std::invalid_argument unless times rise from above 0. At time 0 the surface is as given.

/// Shift and turn against the surface as given, about a point that is shifted with it.
struct TimedPose {
  double time_s = 0;
  Eigen::Vector3d shift_mm = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};
/// Shifts are interpolated along straight lines, rotations about the axis between two.
MovingSurfacePtr make_moving(SurfacePtr surface, const Eigen::Vector3d& about_mm, std::vector<TimedPose> poses);

struct TimedCapsules {
  double time_s = 0;
  std::vector<Capsule> capsules;
};
/// Ends of the segments go along straight lines; as many capsules, of the same radii, at all times.
MovingSurfacePtr make_moving_capsules(std::vector<Capsule> capsules, std::vector<TimedCapsules> later);

/// Between which of the times, and how far from the first to the second: of rising times, clamped.
struct BetweenTimes {
  std::size_t before = 0;
  double share = 0;  ///< 0 … 1, of the one after it
};
BetweenTimes between_times(const std::vector<double>& times_s, double time_s);

}  // namespace horopter
