// SPDX-License-Identifier: Apache-2.0
// Where cameras stand to each other, from the views that two of them share.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "horopter/calib/error.hpp"
#include "rig/view_steps.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Turns of the target by 90, 180, 270 degrees that map its points onto themselves, the identity first.
std::vector<Pose> symmetries(const std::vector<Vector2d>& points) {
  Vector2d centre = Vector2d::Zero();
  for (const Vector2d& point : points) centre += point / static_cast<double>(points.size());
  double extent = 0;
  for (const Vector2d& point : points) extent = std::max(extent, (point - centre).norm());
  std::vector<Pose> turns{Pose{}};
  for (const int quarter : {1, 2, 3}) {
    const double c = quarter == 2 ? -1 : 0, s = quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
    const auto turned = [&](const Vector2d& p) -> Vector2d {
      const Vector2d d = p - centre;
      return centre + Vector2d(c * d.x() - s * d.y(), s * d.x() + c * d.y());
    };
    const bool same = std::ranges::all_of(points, [&](const Vector2d& p) {
      const Vector2d q = turned(p);
      return std::ranges::any_of(points, [&](const Vector2d& other) { return (other - q).norm() < 1e-6 * extent; });
    });
    if (!same) continue;
    Pose pose;
    pose.rotation << c, -s, 0, s, c, 0, 0, 0, 1;
    pose.translation_mm << centre - Vector2d(c * centre.x() - s * centre.y(), s * centre.x() + c * centre.y()), 0;
    turns.push_back(pose);
  }
  return turns;
}

/// Where each target point goes when the target is turned.
std::vector<Vector2d> turned_pixels(const std::vector<Vector2d>& points, const std::vector<Vector2d>& pixels,
                                    const Pose& turn) {
  // The pose of the target, turned, puts point p where the point turn · p was measured.
  std::vector<Vector2d> result;
  for (const Vector2d& point : points) {
    const Vector2d at = (turn * Vector3d(point.x(), point.y(), 0)).head<2>();
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if ((points[i] - at).norm() < (points[nearest] - at).norm()) nearest = i;
    }
    result.push_back(pixels[nearest]);
  }
  return result;
}

double angle_between(const Matrix3d& a, const Matrix3d& b) { return rotation_to_vector(a * b.transpose()).norm(); }

/// The second pose relative to the first, turned by one of `turns` where that makes the rotation smaller by more than
/// 0.3 radians: cameras on one rig are turned against each other as little as possible. `turn` gets the turn.
Pose least_turned(const Pose& first, const Pose& second, const std::vector<Pose>& turns, Pose& turn) {
  Pose best = second * first.inverse();
  double smallest = rotation_to_vector(best.rotation).norm();
  for (const Pose& candidate : turns) {
    const Pose turned = second * candidate * first.inverse();
    const double angle = rotation_to_vector(turned.rotation).norm();
    if (angle < smallest - 0.3) {
      smallest = angle;
      best = turned;
      turn = candidate;
    }
  }
  return best;
}

/// The pose that agrees best with all others. Differences are radians plus shares of `distance_mm`, each limited, so
/// that wrong pairs do not vote.
Pose most_agreed(const std::vector<Pose>& candidates, double distance_mm) {
  const auto difference = [&](const Pose& a, const Pose& b) {
    return angle_between(a.rotation, b.rotation) + (a.translation_mm - b.translation_mm).norm() / distance_mm;
  };
  double least = std::numeric_limits<double>::infinity();
  Pose result;
  for (const Pose& candidate : candidates) {
    double total = 0;
    for (const Pose& other : candidates) total += std::min(difference(candidate, other), 0.1);
    if (total < least) {
      least = total;
      result = candidate;
    }
  }
  return result;
}

/// From the first camera's coordinates to those of camera `c`. Symmetric targets whose print does not say how they are
/// turned are turned on the way, each view by its `turn_of_view`.
Pose relative_pose(const Measured& measured, const std::vector<Single>& singles, std::size_t c,
                   const std::vector<Pose>& turns, std::vector<Pose>& turn_of_view) {
  const Single &first = singles[0], &second = singles[c];
  std::vector<Pose> candidates;
  double distance_mm = 0;
  for (std::size_t view = 0; view < measured.view_count(); ++view) {
    const int a = first.pose_of_view[view], b = second.pose_of_view[view];
    if (a < 0 || b < 0) continue;
    const Pose& pose_a = first.problem.views[static_cast<std::size_t>(a)].target_to_rig;
    const Pose& pose_b = second.problem.views[static_cast<std::size_t>(b)].target_to_rig;
    const bool oriented = measured.cameras[0].views[view].oriented && measured.cameras[c].views[view].oriented;
    candidates.push_back(oriented ? pose_b * pose_a.inverse()
                                  : least_turned(pose_a, pose_b, turns, turn_of_view[view]));
    distance_mm += pose_a.translation_mm.norm();
  }
  if (candidates.empty()) {
    throw CalibrationError(fmt::format("no view shows the target to both {} and {}: their relative pose is unknown",
                                       measured.cameras[0].name, measured.cameras[c].name));
  }
  return most_agreed(candidates, distance_mm / static_cast<double>(candidates.size()));
}

}  // namespace

Placed place(const Measured& measured, const std::vector<Single>& singles) {
  const std::size_t views = measured.view_count();
  const std::vector<Pose> turns = measured.raised() ? std::vector<Pose>{Pose{}} : symmetries(measured.points_mm);
  Placed placed;
  JointProblem& joint = placed.problem;
  std::vector<int> pose_of_view(views, -1);
  for (std::size_t c = 0; c < measured.cameras.size(); ++c) {
    const Single& single = singles[c];
    JointCamera camera = single.problem.cameras[0];
    std::vector<Pose> turn_of_view(views);
    if (c > 0) camera.rig_to_camera = relative_pose(measured, singles, c, turns, turn_of_view);
    for (std::size_t view = 0; view < views; ++view) {
      const int own = single.pose_of_view[view];
      if (own < 0) continue;
      if (pose_of_view[view] < 0 && measured.raised() && !joint.views.empty()) pose_of_view[view] = 0;
      if (pose_of_view[view] < 0) {
        pose_of_view[view] = static_cast<int>(joint.views.size());
        joint.views.push_back({.target_to_rig = camera.rig_to_camera.inverse() *
                                                single.problem.views[static_cast<std::size_t>(own)].target_to_rig *
                                                turn_of_view[view]});
      }
      const auto& pixels = measured.cameras[c].views[view].pixels;
      const bool turned = !turn_of_view[view].rotation.isIdentity();
      joint.observations.push_back(
          {.camera = static_cast<int>(c),
           .view = pose_of_view[view],
           .points_mm = measured.points_in(view),
           .pixels = turned ? turned_pixels(measured.points_mm, pixels, turn_of_view[view]) : pixels});
      placed.origin.push_back({c, view});
    }
    joint.cameras.push_back(std::move(camera));
  }
  placed.reason.resize(joint.observations.size());
  return placed;
}

}  // namespace horopter::calib::detail
