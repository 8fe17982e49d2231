// SPDX-License-Identifier: Apache-2.0
// One camera from its own views: focal lengths to try, the pose of the target in each view, and an optimisation that
// lets more and more parameters go.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "horopter/calib/error.hpp"
#include "horopter/calib/homography.hpp"
#include "horopter/calib/points.hpp"
#include "rig/view_steps.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using P = CameraParameters;

/// Median residual of the views, px, with which the search for a better start ends.
constexpr double kGoodPx = 0.5;

/// Pose of a plane from a homography between its points and undistorted directions.
std::optional<Pose> plane_pose(const CameraModel& model, const std::vector<Vector2d>& points,
                               const std::vector<Vector2d>& pixels) {
  std::vector<Vector2d> directions;
  for (const Vector2d& pixel : pixels) {
    const auto direction = model.undistort(pixel);
    if (!direction) return std::nullopt;
    directions.push_back(*direction);
  }
  const auto homography = solve_homography(points, directions);
  if (!homography) return std::nullopt;
  // The columns are r1, r2 and t, times a common factor, whose sign puts the plane in front of the camera.
  Matrix3d m = homography->matrix;
  const double scale = 0.5 * (m.col(0).norm() + m.col(1).norm());
  if (!(scale > 0)) return std::nullopt;
  m /= (m * points.front().homogeneous()).z() < 0 ? -scale : scale;
  Matrix3d rotation;
  rotation << m.col(0), m.col(1), m.col(0).cross(m.col(1));
  const Pose pose{nearest_rotation(rotation), m.col(2)};
  for (const Vector2d& point : points) {
    if (!((pose * Vector3d(point.x(), point.y(), 0)).z() > 0)) return std::nullopt;
  }
  return pose;
}

struct FocalGuess {
  double f_px = 0;
  double kappa1_per_px2 = 0;
};

/// A focal length by Tsai's method, and its weight, the square of f over its standard deviation.
struct KnownFocal {
  FocalGuess guess;
  double weight;
};

/// Nothing when these points do not determine f.
std::optional<KnownFocal> focal_by_tsai(const ViewCamera& camera, const std::vector<PointPair>& pairs) {
  const Sensor sensor{
      camera.width_px, camera.height_px, 1, 1, 0.5 * (camera.width_px - 1), 0.5 * (camera.height_px - 1), 1.0};
  try {
    const PointCalibration result = calibrate_points(pairs, sensor, PointMethod::tsai, {.centre = CentreSearch::given});
    const auto& intrinsics = std::get<TsaiIntrinsics>(result.camera.model.intrinsics());
    const double sd = std::ranges::find(result.parameters, "f_mm", &Parameter::name)->sd;
    return KnownFocal{{intrinsics.f_mm, intrinsics.kappa1}, std::pow(intrinsics.f_mm / std::max(sd, 1e-6), 2)};
  } catch (const CalibrationError&) {
    return std::nullopt;
  }
}

void append_pairs(std::vector<PointPair>& pairs, const std::vector<Vector3d>& points,
                  const std::vector<Vector2d>& pixels) {
  for (std::size_t i = 0; i < pixels.size(); ++i) pairs.push_back({points[i], pixels[i]});
}

/// By Tsai's method (6.5): on all heights at once where they are known, or else on every view.
std::vector<KnownFocal> known_focals(const ViewCamera& camera, const Measured& measured) {
  std::vector<KnownFocal> known;
  if (measured.raised()) {
    std::vector<PointPair> all;
    for (std::size_t view = 0; view < camera.views.size(); ++view) {
      append_pairs(all, measured.points_in(view), camera.views[view].pixels);
    }
    if (const auto focal = focal_by_tsai(camera, all)) known.push_back(*focal);
  }
  if (!known.empty()) return known;
  for (const SeenTarget& view : camera.views) {
    if (view.pixels.empty()) continue;
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
      const Vector2d& point = measured.points_mm[i];
      pairs.push_back({{point.x(), point.y(), 0}, view.pixels[i]});
    }
    if (const auto focal = focal_by_tsai(camera, pairs)) known.push_back(*focal);
  }
  return known;
}

/// Focal lengths to start from, the most likely first: the weighted median of those that Tsai's method knows, so that
/// the views that know f best decide; then guesses from a wide to a long lens, for views that know it only together.
std::vector<FocalGuess> focal_guesses(const ViewCamera& camera, const Measured& measured) {
  std::vector<KnownFocal> known = known_focals(camera, measured);
  std::ranges::sort(known, {}, [](const KnownFocal& k) { return k.guess.f_px; });
  double total = 0, below = 0;
  for (const KnownFocal& k : known) total += k.weight;
  std::vector<FocalGuess> guesses;
  for (const KnownFocal& k : known) {
    below += k.weight;
    if (2 * below >= total) {
      guesses.push_back(k.guess);
      break;
    }
  }
  for (const double factor : {1.0, 0.6, 1.7, 3.0}) guesses.push_back({factor * camera.width_px, 0});
  return guesses;
}

FreeParameters free_parameters(const ViewOptions& options, bool one_pose) {
  FreeParameters free{};
  free[P::f] = true;
  free[P::scale] = free[P::cx] = free[P::cy] = !one_pose;
  for (std::size_t i = 0; i < LensCoefficients::kCount; ++i) {
    free[P::lens + i] = options.distortion[i] && (!one_pose || i == 0);
  }
  return free;
}

double median_view_rms(const JointProblem& problem) {
  std::vector<double> values;
  for (const auto& residuals : residuals_px(problem)) values.push_back(rms_of(residuals));
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// The camera of a guess, by which the poses of the views are found.
BrownConradyIntrinsics start_intrinsics(const ViewCamera& camera, const FocalGuess& guess, bool distorted) {
  BrownConradyIntrinsics intrinsics{.fx_px = guess.f_px,
                                    .fy_px = guess.f_px,
                                    .cx_px = 0.5 * (camera.width_px - 1),
                                    .cy_px = 0.5 * (camera.height_px - 1),
                                    .lens = {}};
  // To first order the two directions of the lens map differ in the sign.
  if (distorted) intrinsics.lens.k1 = std::clamp(-guess.kappa1_per_px2 * guess.f_px * guess.f_px, -0.5, 0.5);
  return intrinsics;
}

/// The views whose pose is found with these intrinsics, or without their distortion; nothing when there are none.
std::optional<Single> pose_views(const ViewCamera& camera, const Measured& measured,
                                 const BrownConradyIntrinsics& intrinsics) {
  const bool raised = measured.raised();
  const CameraModel distorted(intrinsics);
  BrownConradyIntrinsics straight = intrinsics;
  straight.lens = {};
  Single single;
  JointProblem& problem = single.problem;
  problem.cameras.push_back({.intrinsics = intrinsics, .free = {}, .rig_to_camera = {}});
  for (std::size_t view = 0; view < camera.views.size(); ++view) {
    single.pose_of_view.push_back(-1);
    const SeenTarget& seen = camera.views[view];
    if (seen.pixels.empty()) continue;
    auto pose = plane_pose(distorted, measured.points_mm, seen.pixels);
    if (!pose) {
      pose = plane_pose(CameraModel(straight), measured.points_mm, seen.pixels);
    }
    if (!pose) continue;
    if (!raised || problem.views.empty()) {
      if (raised) pose->translation_mm += pose->rotation * Vector3d(0, 0, measured.options.heights_mm[view]);
      problem.views.push_back({.target_to_rig = *pose});
    }
    single.pose_of_view.back() = static_cast<int>(problem.views.size()) - 1;
    problem.observations.push_back({.camera = 0,
                                    .view = single.pose_of_view.back(),
                                    .points_mm = measured.points_in(view),
                                    .pixels = seen.pixels});
  }
  if (problem.observations.empty()) return std::nullopt;
  return single;
}

std::optional<Single> try_single(const ViewCamera& camera, const Measured& measured, const FocalGuess& guess) {
  const ViewOptions& options = measured.options;
  auto single = pose_views(camera, measured, start_intrinsics(camera, guess, options.distortion[0]));
  if (!single) return std::nullopt;
  JointProblem& problem = single->problem;
  FreeParameters& free = problem.cameras[0].free;
  try {
    free = {};
    free[P::f] = true;
    optimise(problem, {.huber_px = 5, .max_iterations = 50});
    free[P::lens] = options.distortion[0];
    optimise(problem, {.huber_px = 2, .max_iterations = 50});
    // Two poses of a plane barely determine five numbers of a camera. One pose determines only its focal length.
    free = free_parameters(options, count_poses(problem, {0}) < 2);
    optimise(problem, {.huber_px = 1, .max_iterations = 100});
  } catch (const CalibrationError&) {
    return std::nullopt;
  }
  single->robust_px = median_view_rms(problem);
  if (!std::isfinite(single->robust_px)) return std::nullopt;
  return single;
}

}  // namespace

Single calibrate_single(const ViewCamera& camera, const Measured& measured) {
  std::optional<Single> best;
  for (const FocalGuess& guess : focal_guesses(camera, measured)) {
    auto attempt = try_single(camera, measured, guess);
    if (attempt && (!best || attempt->robust_px < best->robust_px)) best = std::move(attempt);
    if (best && best->robust_px < kGoodPx) break;
  }
  if (!best) {
    throw CalibrationError(fmt::format("{}: no camera explains any of the {} views", camera.name, count_seen(camera)));
  }
  return std::move(*best);
}

}  // namespace horopter::calib::detail
