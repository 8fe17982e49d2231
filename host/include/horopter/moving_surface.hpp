// SPDX-License-Identifier: Apache-2.0
// Surfaces that move with a robot: poses, or segments, over time.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "horopter/surface.hpp"

namespace horopter {

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
