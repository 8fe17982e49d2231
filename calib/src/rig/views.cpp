// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/views.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "camera/parameter_list.hpp"
#include "horopter/calib/error.hpp"
#include "rig/judge.hpp"
#include "rig/view_steps.hpp"

namespace horopter::calib {

using Eigen::Vector2d;
using Eigen::Vector3d;
using P = CameraParameters;

std::vector<Vector3d> detail::Measured::points_in(std::size_t view) const {
  const double height_mm = raised() ? options.heights_mm[view] : 0;
  std::vector<Vector3d> points;
  points.reserve(points_mm.size());
  for (const Vector2d& point : points_mm) points.emplace_back(point.x(), point.y(), -height_mm);
  return points;
}

std::size_t detail::count_seen(const ViewCamera& camera) {
  return static_cast<std::size_t>(
      std::ranges::count_if(camera.views, [](const SeenTarget& view) { return !view.pixels.empty(); }));
}

namespace {

/// The target as a camera sees it. How it is turned about its normal is left out: that tells nothing of a camera.
struct TargetPlace {
  Vector3d normal, middle_mm;
  double lift_mm;  // known exactly: another one is another pose, however small the difference
};

/// The limits are beyond what a target moves in a burst, and beyond what noise does to the pose of a small one.
bool same_pose(const TargetPlace& a, const TargetPlace& b) {
  constexpr double kTurn_deg = 5, kShift = 0.05;
  return a.lift_mm == b.lift_mm && a.normal.dot(b.normal) > std::cos(kTurn_deg * M_PI / 180) &&
         (a.middle_mm - b.middle_mm).norm() < kShift * b.middle_mm.norm();
}

TargetPlace target_place(const JointProblem& problem, const JointObservation& observation) {
  const Pose pose = problem.cameras[static_cast<std::size_t>(observation.camera)].rig_to_camera *
                    problem.views[static_cast<std::size_t>(observation.view)].target_to_rig;
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& point : observation.points_mm) middle += point;
  middle /= static_cast<double>(observation.points_mm.size());
  return {pose.rotation.col(2), pose * middle, middle.z()};
}

}  // namespace

std::size_t detail::count_poses(const JointProblem& problem, const std::vector<int>& cameras) {
  const auto saw = [&](int camera, int view) {
    return std::ranges::any_of(problem.observations, [&](const JointObservation& other) {
      return other.used && other.camera == camera && other.view == view;
    });
  };
  std::vector<TargetPlace> places;
  for (const JointObservation& observation : problem.observations) {
    if (!observation.used || observation.camera != cameras.front()) continue;
    if (!std::ranges::all_of(cameras, [&](int camera) { return saw(camera, observation.view); })) continue;
    const TargetPlace place = target_place(problem, observation);
    const auto same = [&](const TargetPlace& other) { return same_pose(other, place); };
    if (std::ranges::none_of(places, same)) places.push_back(place);
  }
  return places.size();
}

namespace {

using namespace detail;

/// A view whose residual is `factor` times the median of all views, and at least `least_px`, disagrees with them.
struct OutlierLimit {
  double factor;
  double least_px;
};
constexpr OutlierLimit kOutlier{4, 0.7};
/// Before the cameras are optimised together.
constexpr OutlierLimit kGross{10, 3};
/// Rounds of leaving views out and solving again.
constexpr int kRounds = 4;

void check_camera(const ViewCamera& camera, const Measured& measured) {
  const ViewCamera& first = measured.cameras.front();
  const std::size_t heights = measured.options.heights_mm.size();
  if (camera.views.size() != first.views.size()) {
    throw CalibrationError(fmt::format("{} has {} images and {} has {}: they must come in pairs", first.name,
                                       first.views.size(), camera.name, camera.views.size()));
  }
  if (measured.raised() && heights != camera.views.size()) {
    throw CalibrationError(fmt::format("{} heights for {} images of {}", heights, camera.views.size(), camera.name));
  }
  if (camera.width_px < 2 || camera.height_px < 2) throw CalibrationError(camera.name + ": the image has no size");
}

void check_view(const SeenTarget& view, std::size_t points) {
  if (!view.pixels.empty() && view.pixels.size() != points) {
    throw CalibrationError(fmt::format("{}: {} points instead of {}", view.file, view.pixels.size(), points));
  }
  for (const Vector2d& pixel : view.pixels) {
    if (!pixel.allFinite()) throw CalibrationError(view.file + ": a point is not finite");
  }
}

void check_seen(const ViewCamera& camera) {
  if (count_seen(camera) > 0) return;
  std::string reason;
  const auto named = std::ranges::find_if(camera.views, [](const SeenTarget& view) { return !view.problem.empty(); });
  if (named != camera.views.end()) reason = fmt::format(" ({}: {})", named->file, named->problem);
  throw CalibrationError(
      fmt::format("the target is in none of the {} images of {}{}", camera.views.size(), camera.name, reason));
}

/// An image that counts twice makes the result look better than it is. Two photographs are never the same.
void check_repeats(const ViewCamera& camera) {
  constexpr double kSame_px = 1e-6;
  const auto same = [](const Vector2d& a, const Vector2d& b) { return (a - b).norm() < kSame_px; };
  for (std::size_t i = 0; i < camera.views.size(); ++i) {
    const SeenTarget& view = camera.views[i];
    if (view.pixels.empty()) continue;
    for (std::size_t k = 0; k < i; ++k) {
      if (!std::ranges::equal(camera.views[k].pixels, view.pixels, same)) continue;
      throw CalibrationError(fmt::format(
          "{} and {} are one image: the target is at exactly the same place in both; expected each image once",
          camera.views[k].file, view.file));
    }
  }
}

void check_input(const Measured& measured) {
  if (measured.cameras.empty()) throw CalibrationError("no camera");
  if (measured.points_mm.size() < 6) throw CalibrationError("a target needs at least 6 points");
  for (const ViewCamera& camera : measured.cameras) {
    check_camera(camera, measured);
    for (const SeenTarget& view : camera.views) check_view(view, measured.points_mm.size());
    check_seen(camera);
    check_repeats(camera);
  }
}

/// A camera whose f is not known has no certain place, and the other cameras then do not fit to it. Throws
/// CalibrationError that names such a camera, if there is one.
void blame_focal_length(const std::vector<Single>& singles, const Measured& measured) {
  for (std::size_t c = 0; c < singles.size(); ++c) {
    const JointCovariance alone = covariance(singles[c].problem);
    const std::string problem =
        focal_problem(measured.cameras[c].name, CameraModel(singles[c].problem.cameras[0].intrinsics).fy_px(),
                      std::sqrt(alone.cameras[0](P::f, P::f)));
    if (!problem.empty()) throw CalibrationError(problem);
  }
}

JointReport optimise_or_blame(JointProblem& problem, const JointOptions& how, const std::vector<Single>& singles,
                              const Measured& measured) {
  try {
    return optimise(problem, how);
  } catch (const CalibrationError&) {
    blame_focal_length(singles, measured);
    throw;
  }
}

/// Root mean square of the residuals of each observation, px.
std::vector<double> observation_rms(const JointProblem& problem) {
  std::vector<double> rms;
  for (const auto& residuals : residuals_px(problem)) rms.push_back(rms_of(residuals));
  return rms;
}

/// Leaves out the views that disagree with the others, in all cameras. False when there are none, or so many that no
/// majority is left for them to disagree with.
bool drop_outliers(Placed& placed, const OutlierLimit& limit) {
  std::vector<JointObservation>& observations = placed.problem.observations;
  const std::vector<double> rms = observation_rms(placed.problem);
  std::vector<double> used;
  for (std::size_t i = 0; i < rms.size(); ++i) {
    if (observations[i].used) used.push_back(rms[i]);
  }
  std::ranges::sort(used);
  const double median = used[(used.size() - 1) / 2];
  const double largest = std::max(limit.factor * median, limit.least_px);
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < rms.size(); ++i) {
    if (observations[i].used && !(rms[i] <= largest)) bad.push_back(i);  // a NaN is bad too
  }
  if (2 * bad.size() > used.size()) return false;
  for (const std::size_t i : bad) {
    placed.reason[i] = fmt::format("residual {:.2f} px, {:.1f} times the median of the views", rms[i], rms[i] / median);
    for (std::size_t k = 0; k < observations.size(); ++k) {
      if (placed.origin[k].view == placed.origin[i].view) observations[k].used = false;
    }
  }
  return !bad.empty();
}

/// All at once; views that disagree with the others are left out.
JointReport solve(Placed& placed, const std::vector<Single>& singles, const Measured& measured) {
  JointProblem& problem = placed.problem;
  const auto optimise_all = [&](const JointOptions& how) { return optimise_or_blame(problem, how, singles, measured); };
  if (problem.cameras.size() > 1 || measured.raised()) {
    // First the poses alone, with each camera as it was found by itself: a wrong pair would spoil the cameras.
    for (JointCamera& camera : problem.cameras) camera.free = {};
    optimise_all({.huber_px = 1});
    for (std::size_t c = 0; c < singles.size(); ++c) problem.cameras[c].free = singles[c].problem.cameras[0].free;
    drop_outliers(placed, kGross);
    optimise_all({.huber_px = 1});
  }
  JointReport report;
  for (int round = 0; round < kRounds; ++round) {
    if (!drop_outliers(placed, kOutlier) && round > 0) break;
    report = optimise_all({.max_iterations = 300});
  }
  return report;
}

}  // namespace

std::array<bool, LensCoefficients::kCount> distortion_terms(std::string_view text) {
  std::array<bool, LensCoefficients::kCount> terms{};
  if (text == "none") return terms;
  std::string_view rest = text;
  while (!rest.empty()) {
    const auto* const found = std::ranges::find(kLensTermNames, rest.substr(0, 2));
    const auto index = static_cast<std::size_t>(found - std::begin(kLensTermNames));
    if (index == terms.size() || terms[index]) {
      throw std::invalid_argument(fmt::format(
          "distortion '{}'; expected none or a row of k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4, each once, as k1k2p1p2",
          text));
    }
    terms[index] = true;
    rest.remove_prefix(2);
  }
  if (text.empty()) throw std::invalid_argument("no distortion terms; expected none, k1, k1k2, k1k2p1p2, …");
  return terms;
}

Report calibrate_views(const std::vector<ViewCamera>& cameras, const std::vector<Vector2d>& points,
                       const ViewOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Measured measured{cameras, points, options};
  check_input(measured);
  std::vector<Single> singles;
  for (const ViewCamera& camera : cameras) singles.push_back(calibrate_single(camera, measured));
  Placed placed = place(measured, singles);
  const JointReport solved = solve(placed, singles, measured);
  Report report = report_of(measured, placed);
  report.iterations = solved.iterations;
  if (!solved.converged) {
    report.warnings.insert(report.warnings.begin(), "not_converged: the optimisation stopped: " + solved.message);
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

}  // namespace horopter::calib
