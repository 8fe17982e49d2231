// SPDX-License-Identifier: Apache-2.0
// The steps of the calibration from views of a flat target (views.hpp): each camera on its own, all cameras placed on
// one rig, all of it solved, and the report.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "horopter/calib/joint.hpp"
#include "horopter/calib/views.hpp"

namespace horopter::calib::detail {

/// What the caller gave.
struct Measured {
  const std::vector<ViewCamera>& cameras;
  const std::vector<Eigen::Vector2d>& points_mm;
  const ViewOptions& options;

  std::size_t view_count() const { return cameras.front().views.size(); }
  /// The target was lifted to known heights and not moved otherwise.
  bool raised() const { return !options.heights_mm.empty(); }
  /// The target's points in the coordinates of the target at height 0.
  std::vector<Eigen::Vector3d> points_in(std::size_t view) const;
};

std::size_t count_seen(const ViewCamera& camera);

/// Poses of the target that all of these cameras saw in what is used. What differs by less than a turn of 5 degrees and
/// 5 % of the distance is one: as many views of it as there may be tell less noise, but nothing new of the cameras.
std::size_t count_poses(const JointProblem& problem, const std::vector<int>& cameras);

/// One camera on its own: the start of the joint optimisation.
struct Single {
  JointProblem problem;
  std::vector<int> pose_of_view;                               ///< index in problem.views, −1: not seen
  double robust_px = std::numeric_limits<double>::infinity();  ///< median over the views of their rms
};

/// Throws CalibrationError when no camera explains any of the views.
Single calibrate_single(const ViewCamera& camera, const Measured& measured);

/// All cameras and views as one problem, whose observations remember where they come from.
struct Placed {
  struct Origin {
    std::size_t camera, view;
    bool operator==(const Origin&) const = default;
  };
  JointProblem problem;
  std::vector<Origin> origin;       ///< of each observation
  std::vector<std::string> reason;  ///< why an observation is left out; empty when the other of its pair is the reason
};

/// Where the cameras stand to each other, and the views to the rig. Throws CalibrationError when a camera shares no
/// view with the first.
Placed place(const Measured& measured, const std::vector<Single>& singles);

/// Rig, errors, views, warnings and problems of a solved problem.
Report report_of(const Measured& measured, const Placed& placed);

}  // namespace horopter::calib::detail
