// SPDX-License-Identifier: Apache-2.0
// The report of a calibration from views: the rig and its errors, what became of each view, and whether it is any good.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "camera/lens_limit.hpp"
#include "camera/parameter_list.hpp"
#include "horopter/calib/error.hpp"
#include "rig/judge.hpp"
#include "rig/view_steps.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using P = CameraParameters;

/// Share of the image, in tiles, over which targets should be.
constexpr double kCoverage = 0.5;
constexpr int kTilesAcross = 8, kTilesDown = 6;
/// Fewer poses of the target, or poses that both cameras saw, than this get a warning.
constexpr std::size_t kFewPoses = 4;
constexpr std::size_t kFewSharedPoses = 2;

/// A solved problem with what follows from it.
struct Solution {
  const Measured& measured;
  const Placed& placed;
  std::vector<std::vector<Vector2d>> residuals;
  JointCovariance sd;
  Pose world_to_rig;

  const JointProblem& problem() const { return placed.problem; }
  const ViewCamera& camera(std::size_t c) const { return measured.cameras[c]; }
};

/// From the coordinates of the printed plane, y down and z into the print, to those of a target on a table: y up, z out
/// of the print.
Pose target_to_world() {
  Pose pose;
  pose.rotation = Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

Camera camera_of(const Solution& solution, std::size_t c) {
  const JointCamera& joint = solution.problem().cameras[c];
  return {.name = solution.camera(c).name,
          .width_px = solution.camera(c).width_px,
          .height_px = solution.camera(c).height_px,
          .model = CameraModel(joint.intrinsics),
          .world_to_camera = joint.rig_to_camera * solution.world_to_rig};
}

/// Covariance of a camera's pose in the world. The world is the first camera, which has none then, or the target.
Matrix6 pose_covariance(const Solution& solution, std::size_t c) {
  if (c > 0) return solution.sd.rig_to_camera[c];
  return solution.measured.raised() ? solution.sd.views[0] : Matrix6(Matrix6::Zero());
}

std::vector<Parameter> list_parameters(const Solution& solution, std::size_t c, const Pose& world_to_camera) {
  const JointCamera& camera = solution.problem().cameras[c];
  const auto& brown = std::get<BrownConradyIntrinsics>(camera.intrinsics);
  const auto& covariance = solution.sd.cameras[c];
  const double pitch_mm = solution.measured.options.pitch_mm;
  const auto sd = [&](int i) { return std::sqrt(covariance(i, i)); };
  const double fx_sd = fx_deviation(brown.fy_px, brown.fx_px / brown.fy_px, covariance);
  std::vector<Parameter> list;
  if (pitch_mm > 0) list.push_back({"f_mm", brown.fy_px * pitch_mm, sd(P::f) * pitch_mm, camera.free[P::f]});
  list.push_back({"fx_px", brown.fx_px, fx_sd, camera.free[P::f]});
  list.push_back({"fy_px", brown.fy_px, sd(P::f), camera.free[P::f]});
  list.push_back({"cx_px", brown.cx_px, sd(P::cx), camera.free[P::cx]});
  list.push_back({"cy_px", brown.cy_px, sd(P::cy), camera.free[P::cy]});
  const auto values = brown.lens.array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool free = camera.free[P::lens + i];
    if (i < 5 || free) list.push_back({kLensTermNames[i], values[i], sd(static_cast<int>(P::lens + i)), free});
  }
  append_pose(list, world_to_camera, pose_covariance(solution, c), c > 0 || solution.measured.raised());
  return list;
}

/// Errors of a camera on one of its views.
PointErrors errors_of(const Solution& solution, const Camera& camera, const JointObservation& observation) {
  Camera from_target = camera;
  from_target.world_to_camera = solution.problem().cameras[static_cast<std::size_t>(observation.camera)].rig_to_camera *
                                solution.problem().views[static_cast<std::size_t>(observation.view)].target_to_rig;
  std::vector<PointPair> pairs;
  for (std::size_t k = 0; k < observation.pixels.size(); ++k) {
    pairs.push_back({observation.points_mm[k], observation.pixels[k]});
  }
  return evaluate(from_target, pairs);
}

/// Adds a camera to the report. Returns its errors on the views that were used.
PointErrors report_camera(const Solution& solution, std::size_t c, Report& report) {
  const Camera camera = camera_of(solution, c);
  CameraReport& own = report.cameras.emplace_back();
  own.name = camera.name;
  own.parameters = list_parameters(solution, c, camera.world_to_camera);
  std::vector<PointErrors> parts;
  const auto& observations = solution.problem().observations;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const JointObservation& observation = observations[i];
    if (observation.camera != static_cast<int>(c) || !observation.used) continue;
    own.pixels.insert(own.pixels.end(), observation.pixels.begin(), observation.pixels.end());
    own.residuals.insert(own.residuals.end(), solution.residuals[i].begin(), solution.residuals[i].end());
    try {
      parts.push_back(errors_of(solution, camera, observation));
    } catch (const CalibrationError& error) {
      const std::string& file = solution.camera(c).views[solution.placed.origin[i].view].file;
      report.problems.push_back(fmt::format("{}: {}", file, error.what()));
    }
  }
  const PointErrors merged = merge(parts);
  own.rms_px = merged.rms_px;
  if (const auto warning = lens_limit_warning(camera)) report.warnings.push_back(*warning);
  report.rig.cameras.push_back(camera);
  return merged;
}

ViewReport view_report(const Solution& solution, std::size_t c, std::size_t view) {
  const SeenTarget& seen = solution.camera(c).views[view];
  ViewReport entry;
  entry.camera = solution.camera(c).name;
  entry.file = seen.file;
  entry.view = static_cast<int>(view);
  entry.found = !seen.pixels.empty();
  if (!entry.found) {
    entry.problem = seen.problem.empty() ? "target not found" : seen.problem;
    return entry;
  }
  const auto& origin = solution.placed.origin;
  const auto at = std::ranges::find(origin, Placed::Origin{c, view});
  if (at == origin.end()) {
    entry.problem = "no pose of the target explains its points";
    return entry;
  }
  const auto i = static_cast<std::size_t>(at - origin.begin());
  const std::string& reason = solution.placed.reason[i];
  entry.used = solution.problem().observations[i].used;
  entry.rms_px = rms_of(solution.residuals[i]);
  if (!entry.used) entry.problem = reason.empty() ? "its pair disagrees with the others" : reason;
  return entry;
}

void report_views(const Solution& solution, Report& report) {
  for (std::size_t c = 0; c < solution.measured.cameras.size(); ++c) {
    for (std::size_t view = 0; view < solution.measured.view_count(); ++view) {
      const ViewReport& entry = report.views.emplace_back(view_report(solution, c, view));
      if (!entry.found) {
        report.warnings.push_back(fmt::format("target_not_found: {}: {}", entry.file, entry.problem));
      } else if (!entry.used) {
        report.warnings.push_back(fmt::format("outlier_view: {} is left out: {}", entry.file, entry.problem));
      }
    }
  }
}

/// Share of the image's tiles with points in them.
double covered(const std::vector<Vector2d>& pixels, const ViewCamera& camera) {
  std::array<bool, kTilesAcross * kTilesDown> tiles{};
  for (const Vector2d& pixel : pixels) {
    const int column =
        std::clamp(static_cast<int>((pixel.x() + 0.5) / camera.width_px * kTilesAcross), 0, kTilesAcross - 1);
    const int row = std::clamp(static_cast<int>((pixel.y() + 0.5) / camera.height_px * kTilesDown), 0, kTilesDown - 1);
    tiles[static_cast<std::size_t>(row * kTilesAcross + column)] = true;
  }
  return static_cast<double>(std::ranges::count(tiles, true)) / static_cast<double>(tiles.size());
}

/// Are the views enough, and do they reach over the image?
void judge_views(const Solution& solution, std::size_t c, Report& report) {
  const ViewCamera& camera = solution.camera(c);
  const std::size_t poses = count_poses(solution.problem(), {static_cast<int>(c)});
  if (poses == 1) {
    report.warnings.push_back(fmt::format(
        "one_view: {}: one pose of a plane, in however many views, knows f and k1 only; square pixels and the middle of "
        "the image are taken for granted",
        camera.name));
  } else if (poses < kFewPoses) {
    report.warnings.push_back(
        fmt::format("few_views: {}: {} different poses of the target; ten, tilted in different directions, are usual",
                    camera.name, poses));
  }
  const double seen = covered(report.cameras[c].pixels, camera);
  if (seen < kCoverage) {
    report.warnings.push_back(
        fmt::format("coverage: {}: the targets were in {:.0f} % of the image; elsewhere the lens model is extrapolated",
                    camera.name, 100 * seen));
  }
}

/// Mean distance of the targets from the rig, mm.
double target_distance(const JointProblem& problem) {
  double distance = 0;
  for (const JointView& view : problem.views) {
    distance += view.target_to_rig.translation_mm.norm() / static_cast<double>(problem.views.size());
  }
  return distance;
}

/// The pose of the second camera: reported, and judged.
void report_baseline(const Solution& solution, Report& report) {
  const Pose relative = report.rig.between(0, 1);
  const Matrix6& covariance = solution.sd.rig_to_camera[1];
  const double baseline_mm = relative.translation_mm.norm();
  const Vector3d direction = relative.translation_mm / std::max(baseline_mm, 1e-12);
  report.baseline_mm = baseline_mm;
  report.baseline_sd_mm = std::sqrt(direction.dot(covariance.bottomRightCorner<3, 3>() * direction));
  append_pose(report.relative, relative, covariance, true);
  if (!(baseline_mm > std::max(5 * report.baseline_sd_mm, 1e-3 * target_distance(solution.problem())))) {
    report.problems.push_back(fmt::format(
        "the cameras stand at one place (baseline {:.3f} ± {:.3f} mm): are both sets of images from one camera?",
        baseline_mm, report.baseline_sd_mm));
  } else if (direction.x() > 0.7) {
    report.warnings.push_back(
        fmt::format("left_right_exchanged: {} stands {:.1f} mm to the left of {}; are the images exchanged?",
                    solution.camera(1).name, relative.translation_mm.x(), solution.camera(0).name));
  }
  if (!solution.measured.raised() && count_poses(solution.problem(), {0, 1}) < kFewSharedPoses) {
    report.warnings.push_back(
        "one_pair: the relative pose rests on a single pose of the target, and the ± of the report is several times too "
        "small: take pairs of ten poses");
  }
}

}  // namespace

Report report_of(const Measured& measured, const Placed& placed) {
  const bool raised = measured.raised();
  const JointProblem& problem = placed.problem;
  Solution solution{measured, placed, residuals_px(problem), covariance(problem), Pose{}};
  if (raised) solution.world_to_rig = problem.views[0].target_to_rig * target_to_world().inverse();
  Report report;
  report.method = "joint";
  report.rig.world = raised ? "the target: x right, y up the print, z out of it; height 0 is z = 0"
                            : fmt::format("camera {}", measured.cameras.front().name);
  std::vector<PointErrors> errors;
  for (std::size_t c = 0; c < measured.cameras.size(); ++c) errors.push_back(report_camera(solution, c, report));
  report.errors = merge(errors);
  report_views(solution, report);
  for (std::size_t c = 0; c < measured.cameras.size(); ++c) {
    const auto& sd = solution.sd.cameras[c];
    judge_intrinsics(report.rig.cameras[c], std::sqrt(sd(P::f, P::f)),
                     std::sqrt(std::max(sd(P::cx, P::cx), sd(P::cy, P::cy))), report);
    judge_views(solution, c, report);
  }
  if (measured.cameras.size() > 1) report_baseline(solution, report);
  judge_fit("the views", report.errors.rms_px, measured.cameras.front().width_px,
            "are the images of a pair taken at one time, and is the target flat and as described?", report);
  report.usable = report.problems.empty();
  return report;
}

}  // namespace horopter::calib::detail
