// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/views.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "camera/lens_limit.hpp"
#include "horopter/calib/error.hpp"
#include "horopter/calib/homography.hpp"
#include "horopter/calib/points.hpp"

namespace horopter::calib {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using P = CameraParameters;

/// A view whose residual is this many times the median of all views, and at least kOutlierPx, disagrees with them.
constexpr double kOutlierFactor = 4;
constexpr double kOutlierPx = 0.7;
/// The same before the cameras are optimised together.
constexpr double kGrossFactor = 10;
constexpr double kGrossPx = 3;
/// A rig that fits its views worse than this is none.
constexpr double kLargestRmsPx = 1.5;

/// Coordinates of a target that lies on a table, from those of the printed plane: y up, z out of the print.
Pose target_to_world() {
  Pose pose;
  pose.rotation = Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

std::vector<Vector3d> at_height(const std::vector<Vector2d>& points, double height_mm) {
  std::vector<Vector3d> raised;
  raised.reserve(points.size());
  for (const Vector2d& point : points) raised.emplace_back(point.x(), point.y(), -height_mm);
  return raised;
}

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

std::size_t count_seen(const ViewCamera& camera) {
  return static_cast<std::size_t>(
      std::ranges::count_if(camera.views, [](const SeenTarget& view) { return !view.pixels.empty(); }));
}

/// Focal lengths to start from, the most likely first: Tsai's method on every view (6.5), the views that know f best
/// deciding; then guesses from a wide to a long lens, for views that know it only together.
struct FocalGuess {
  double f_px = 0;
  double kappa1_per_px2 = 0;
};

std::vector<FocalGuess> focal_guesses(const ViewCamera& camera, const std::vector<Vector2d>& points,
                                      const std::vector<double>& heights) {
  const Sensor sensor{
      camera.width_px, camera.height_px, 1, 1, 0.5 * (camera.width_px - 1), 0.5 * (camera.height_px - 1), 1.0};
  struct Known {
    FocalGuess guess;
    double weight;
  };
  std::vector<Known> known;
  const auto tsai = [&](const std::vector<PointPair>& pairs) {
    try {
      const PointCalibration result =
          calibrate_points(pairs, sensor, PointMethod::tsai, {.centre = CentreSearch::given});
      const auto& intrinsics = std::get<TsaiIntrinsics>(result.camera.model.intrinsics());
      double sd = 0;
      for (const Parameter& parameter : result.parameters) {
        if (parameter.name == "f_mm") sd = parameter.sd;
      }
      known.push_back({{intrinsics.f_mm, intrinsics.kappa1}, std::pow(intrinsics.f_mm / std::max(sd, 1e-6), 2)});
    } catch (const CalibrationError&) {
      return;  // parallel to the image, or unfit: others tell f
    }
  };
  if (!heights.empty()) {
    std::vector<PointPair> all;
    for (std::size_t view = 0; view < camera.views.size(); ++view) {
      const auto raised = at_height(points, heights[view]);
      for (std::size_t i = 0; i < camera.views[view].pixels.size(); ++i) {
        all.push_back({raised[i], camera.views[view].pixels[i]});
      }
    }
    tsai(all);
  }
  if (known.empty()) {
    for (const SeenTarget& view : camera.views) {
      std::vector<PointPair> pairs;
      pairs.reserve(view.pixels.size());
      for (std::size_t i = 0; i < view.pixels.size(); ++i) {
        pairs.push_back({{points[i].x(), points[i].y(), 0}, view.pixels[i]});
      }
      if (!pairs.empty()) tsai(pairs);
    }
  }
  std::vector<FocalGuess> guesses;
  if (!known.empty()) {
    std::ranges::sort(known, {}, [](const Known& k) { return k.guess.f_px; });
    double total = 0, below = 0;
    for (const Known& k : known) total += k.weight;
    for (const Known& k : known) {
      below += k.weight;
      if (2 * below >= total) {
        guesses.push_back(k.guess);
        break;
      }
    }
  }
  for (const double factor : {1.0, 0.6, 1.7, 3.0}) guesses.push_back({factor * camera.width_px, 0});
  return guesses;
}

FreeParameters free_parameters(const ViewOptions& options, bool few_views) {
  FreeParameters free{};
  free[P::f] = true;
  free[P::scale] = free[P::cx] = free[P::cy] = !few_views;
  for (std::size_t i = 0; i < LensCoefficients::kCount; ++i) {
    free[P::lens + i] = options.distortion[i] && (!few_views || i == 0);
  }
  return free;
}

/// One camera on its own: the start of the joint optimisation.
struct Single {
  JointProblem problem;
  std::vector<int> pose_of_view;                               ///< index in problem.views, −1: not seen
  double robust_px = std::numeric_limits<double>::infinity();  ///< median over the views of their rms
};

double median_view_rms(const JointProblem& problem) {
  std::vector<double> values;
  for (const auto& residuals : residuals_px(problem)) values.push_back(rms_of(residuals));
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

std::optional<Single> try_single(const ViewCamera& camera, const std::vector<Vector2d>& points,
                                 const ViewOptions& options, const FocalGuess& guess) {
  BrownConradyIntrinsics intrinsics{.fx_px = guess.f_px,
                                    .fy_px = guess.f_px,
                                    .cx_px = 0.5 * (camera.width_px - 1),
                                    .cy_px = 0.5 * (camera.height_px - 1),
                                    .lens = {}};
  CameraModel model(intrinsics);
  if (options.distortion[0] && guess.kappa1_per_px2 != 0) {
    // To first order the two directions of the lens map differ in the sign.
    intrinsics.lens.k1 = std::clamp(-guess.kappa1_per_px2 * guess.f_px * guess.f_px, -0.5, 0.5);
    model = CameraModel(intrinsics);
  }
  const bool raised = !options.heights_mm.empty();
  Single single;
  single.problem.cameras.push_back({.intrinsics = intrinsics, .free = {}, .rig_to_camera = {}});
  for (std::size_t view = 0; view < camera.views.size(); ++view) {
    single.pose_of_view.push_back(-1);
    const SeenTarget& seen = camera.views[view];
    if (seen.pixels.empty()) continue;
    auto pose = plane_pose(model, points, seen.pixels);
    if (!pose) {
      intrinsics.lens.k1 = 0;
      pose = plane_pose(CameraModel(intrinsics), points, seen.pixels);
    }
    if (!pose) continue;
    if (!raised || single.problem.views.empty()) {
      if (raised) pose->translation_mm += pose->rotation * Vector3d(0, 0, options.heights_mm[view]);
      single.problem.views.push_back({.target_to_rig = *pose});
    }
    single.pose_of_view.back() = static_cast<int>(single.problem.views.size()) - 1;
    single.problem.observations.push_back({.camera = 0,
                                           .view = single.pose_of_view.back(),
                                           .points_mm = at_height(points, raised ? options.heights_mm[view] : 0),
                                           .pixels = seen.pixels});
  }
  if (single.problem.observations.empty()) return std::nullopt;
  try {
    FreeParameters& free = single.problem.cameras[0].free;
    free = {};
    free[P::f] = true;
    optimise(single.problem, {.huber_px = 5, .max_iterations = 50});
    free[P::lens] = options.distortion[0];
    optimise(single.problem, {.huber_px = 2, .max_iterations = 50});
    // Views of one plane: two views know five numbers of a camera barely, one view only its focal length.
    free = free_parameters(options, single.problem.observations.size() < 2);
    optimise(single.problem, {.huber_px = 1, .max_iterations = 100});
  } catch (const CalibrationError&) {
    return std::nullopt;
  }
  single.robust_px = median_view_rms(single.problem);
  if (!std::isfinite(single.robust_px)) return std::nullopt;
  return single;
}

Single calibrate_single(const ViewCamera& camera, const std::vector<Vector2d>& points, const ViewOptions& options) {
  std::optional<Single> best;
  for (const FocalGuess& guess : focal_guesses(camera, points, options.heights_mm)) {
    auto attempt = try_single(camera, points, options, guess);
    if (attempt && (!best || attempt->robust_px < best->robust_px)) best = std::move(attempt);
    if (best && best->robust_px < 0.5) break;
  }
  if (!best) {
    throw CalibrationError(fmt::format("{}: no camera explains any of the {} views", camera.name, count_seen(camera)));
  }
  return std::move(*best);
}

/// Why f cannot be told from the distance of the targets; empty when it can.
std::string focal_problem(const std::string& name, const Intrinsics& intrinsics, double f_sd_px) {
  const double f_px = std::get<BrownConradyIntrinsics>(intrinsics).fy_px;
  if (f_sd_px < 0.05 * f_px) return "";  // not >=: a NaN is a problem
  return fmt::format(
      "{}: f and the distance of the target cannot be told apart (f = {:.0f} ± {:.0f} px): its plane is too nearly "
      "parallel to the image in all views; tilt it by 30 degrees or so, in different directions",
      name, f_px, f_sd_px);
}

double angle_between(const Matrix3d& a, const Matrix3d& b) { return rotation_to_vector(a * b.transpose()).norm(); }

/// Pose of a second camera: the pair's own estimate that agrees best with all others. Turns of symmetric targets are
/// resolved on the way: cameras on one rig are turned against each other as little as possible.
Pose relative_pose(const Single& first, const Single& second, const ViewCamera& first_camera,
                   const ViewCamera& second_camera, const std::vector<Pose>& turns, std::vector<Pose>& turn_of_view) {
  std::vector<Pose> candidates;
  double distance = 0;
  for (std::size_t view = 0; view < first.pose_of_view.size(); ++view) {
    const int a = first.pose_of_view[view], b = second.pose_of_view[view];
    if (a < 0 || b < 0) continue;
    const Pose& pose_a = first.problem.views[static_cast<std::size_t>(a)].target_to_rig;
    const Pose& pose_b = second.problem.views[static_cast<std::size_t>(b)].target_to_rig;
    const bool ambiguous = !first_camera.views[view].oriented || !second_camera.views[view].oriented;
    Pose best = pose_b * pose_a.inverse();
    double smallest = rotation_to_vector(best.rotation).norm();
    for (std::size_t i = 1; ambiguous && i < turns.size(); ++i) {
      const Pose turned = pose_b * turns[i] * pose_a.inverse();
      const double angle = rotation_to_vector(turned.rotation).norm();
      if (angle < smallest - 0.3) {
        smallest = angle;
        best = turned;
        turn_of_view[view] = turns[i];
      }
    }
    candidates.push_back(best);
    distance += pose_a.translation_mm.norm();
  }
  if (candidates.empty()) {
    throw CalibrationError(fmt::format("no view shows the target to both {} and {}: their relative pose is unknown",
                                       first_camera.name, second_camera.name));
  }
  distance /= static_cast<double>(candidates.size());
  const auto difference = [&](const Pose& a, const Pose& b) {
    return angle_between(a.rotation, b.rotation) + (a.translation_mm - b.translation_mm).norm() / distance;
  };
  // The sum of distances, each limited, so that wrong pairs do not vote.
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

/// Where each target point goes when the target is turned.
std::vector<Vector2d> turned_pixels(const std::vector<Vector2d>& points, const std::vector<Vector2d>& pixels,
                                    const Pose& turn) {
  // The pose found with these pixels was pose_b; pose_b · turn puts target point p where turn·p was measured.
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

std::vector<Parameter> list_parameters(const JointCamera& camera, const Pose& world_to_camera,
                                       const Eigen::Matrix<double, P::kCount, P::kCount>& cov,
                                       const Eigen::Matrix<double, 6, 6>& pose_cov, bool pose_free, double pitch_mm) {
  const auto& brown = std::get<BrownConradyIntrinsics>(camera.intrinsics);
  const auto sd = [&](int i) { return std::sqrt(cov(i, i)); };
  const double scale = brown.fx_px / brown.fy_px;
  const double fx_sd =
      std::sqrt(std::max(0.0, cov(P::f, P::f) * scale * scale + cov(P::scale, P::scale) * brown.fy_px * brown.fy_px +
                                  2 * cov(P::f, P::scale) * brown.fy_px * scale));
  std::vector<Parameter> list;
  if (pitch_mm > 0) list.push_back({"f_mm", brown.fy_px * pitch_mm, sd(P::f) * pitch_mm, camera.free[P::f]});
  list.push_back({"fx_px", brown.fx_px, fx_sd, camera.free[P::f]});
  list.push_back({"fy_px", brown.fy_px, sd(P::f), camera.free[P::f]});
  list.push_back({"cx_px", brown.cx_px, sd(P::cx), camera.free[P::cx]});
  list.push_back({"cy_px", brown.cy_px, sd(P::cy), camera.free[P::cy]});
  static const char* const kTerms[] = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"};
  const auto values = brown.lens.array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool free = camera.free[P::lens + i];
    if (i < 5 || free) list.push_back({kTerms[i], values[i], sd(static_cast<int>(P::lens + i)), free});
  }
  const Vector3d euler = euler_from_rotation_deg(world_to_camera.rotation);
  static const char* const kAngles[] = {"rx_deg", "ry_deg", "rz_deg"};
  static const char* const kLengths[] = {"tx_mm", "ty_mm", "tz_mm"};
  for (int i = 0; i < 3; ++i) {
    list.push_back({kAngles[i], euler[i], std::sqrt(pose_cov(i, i)) * 180 / M_PI, pose_free});
  }
  for (int i = 0; i < 3; ++i) {
    list.push_back({kLengths[i], world_to_camera.translation_mm[i], std::sqrt(pose_cov(3 + i, 3 + i)), pose_free});
  }
  return list;
}

void check_input(const std::vector<ViewCamera>& cameras, const std::vector<Vector2d>& points,
                 const ViewOptions& options) {
  if (cameras.empty()) throw CalibrationError("no camera");
  if (points.size() < 6) throw CalibrationError("a target needs at least 6 points");
  for (const ViewCamera& camera : cameras) {
    if (camera.views.size() != cameras.front().views.size()) {
      throw CalibrationError(fmt::format("{} has {} images and {} has {}: they must come in pairs",
                                         cameras.front().name, cameras.front().views.size(), camera.name,
                                         camera.views.size()));
    }
    if (!options.heights_mm.empty() && options.heights_mm.size() != camera.views.size()) {
      throw CalibrationError(
          fmt::format("{} heights for {} images of {}", options.heights_mm.size(), camera.views.size(), camera.name));
    }
    if (camera.width_px < 2 || camera.height_px < 2) throw CalibrationError(camera.name + ": the image has no size");
    for (const SeenTarget& view : camera.views) {
      if (!view.pixels.empty() && view.pixels.size() != points.size()) {
        throw CalibrationError(
            fmt::format("{}: {} points instead of {}", view.file, view.pixels.size(), points.size()));
      }
      for (const Vector2d& pixel : view.pixels) {
        if (!pixel.allFinite()) throw CalibrationError(view.file + ": a point is not finite");
      }
    }
    if (count_seen(camera) == 0) {
      std::string reason;
      for (const SeenTarget& view : camera.views) {
        if (!view.problem.empty()) reason = fmt::format(" ({}: {})", view.file, view.problem);
        if (!reason.empty()) break;
      }
      throw CalibrationError(
          fmt::format("the target is in none of the {} images of {}{}", camera.views.size(), camera.name, reason));
    }
  }
}

}  // namespace

std::array<bool, LensCoefficients::kCount> distortion_terms(std::string_view text) {
  static const char* const kTerms[] = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"};
  std::array<bool, LensCoefficients::kCount> terms{};
  if (text == "none") return terms;
  std::string_view rest = text;
  while (!rest.empty()) {
    const auto* const found = std::ranges::find(kTerms, rest.substr(0, 2));
    const auto index = static_cast<std::size_t>(found - std::begin(kTerms));
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
  check_input(cameras, points, options);
  const bool raised = !options.heights_mm.empty();
  Report report;
  report.method = "joint";

  // Each camera on its own, then where the cameras stand to each other.
  std::vector<Single> singles;
  singles.reserve(cameras.size());
  for (const ViewCamera& camera : cameras) singles.push_back(calibrate_single(camera, points, options));
  JointProblem joint;
  const std::size_t views = cameras.front().views.size();
  std::vector<int> pose_of_view(views, -1);
  std::vector<std::vector<Vector2d>> pixels;                // per observation
  std::vector<std::pair<std::size_t, std::size_t>> source;  // camera and view of each observation
  const std::vector<Pose> turns = raised ? std::vector<Pose>{Pose{}} : symmetries(points);
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const Single& single = singles[c];
    JointCamera camera = single.problem.cameras[0];
    std::vector<Pose> turn_of_view(views);
    if (c > 0) {
      camera.rig_to_camera = relative_pose(singles[0], single, cameras[0], cameras[c], turns, turn_of_view);
    }
    for (std::size_t view = 0; view < views; ++view) {
      const int own = single.pose_of_view[view];
      if (own < 0) continue;
      if (pose_of_view[view] < 0) {
        if (raised && !joint.views.empty()) {
          pose_of_view[view] = 0;
        } else {
          pose_of_view[view] = static_cast<int>(joint.views.size());
          joint.views.push_back({.target_to_rig = camera.rig_to_camera.inverse() *
                                                  single.problem.views[static_cast<std::size_t>(own)].target_to_rig *
                                                  turn_of_view[view]});
        }
      }
      const auto& measured = cameras[c].views[view].pixels;
      const bool turned = !turn_of_view[view].rotation.isIdentity();
      joint.observations.push_back({.camera = static_cast<int>(c),
                                    .view = pose_of_view[view],
                                    .points_mm = at_height(points, raised ? options.heights_mm[view] : 0),
                                    .pixels = turned ? turned_pixels(points, measured, turn_of_view[view]) : measured});
      source.emplace_back(c, view);
    }
    joint.cameras.push_back(std::move(camera));
  }

  // All at once; views that disagree with the others are left out and named.
  const auto solve = [&](const JointOptions& how) {
    try {
      return optimise(joint, how);
    } catch (const CalibrationError&) {
      // A camera that does not know f stands anywhere, and the others then do not see what it sees.
      for (std::size_t c = 0; c < cameras.size(); ++c) {
        const JointCovariance alone = covariance(singles[c].problem);
        const std::string problem = focal_problem(cameras[c].name, singles[c].problem.cameras[0].intrinsics,
                                                  std::sqrt(alone.cameras[0](P::f, P::f)));
        if (!problem.empty()) throw CalibrationError(problem);
      }
      throw;
    }
  };
  std::vector<bool> dropped(views, false);
  std::vector<std::string> reason(joint.observations.size());
  // Leaves out the views whose residual is more than `factor` times the median and `least_px`. False: there are none.
  const auto drop_outliers = [&](double factor, double least_px) {
    const auto residuals = residuals_px(joint);
    std::vector<double> used;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      if (joint.observations[i].used) used.push_back(rms_of(residuals[i]));
    }
    std::ranges::sort(used);
    const double median = used[(used.size() - 1) / 2];
    const double limit = std::max(factor * median, least_px);
    std::vector<std::size_t> bad;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      // not <=: a NaN is bad too
      if (joint.observations[i].used && !(rms_of(residuals[i]) <= limit)) bad.push_back(i);
    }
    if (2 * bad.size() > used.size()) return false;  // no majority to disagree with
    for (const std::size_t i : bad) {
      reason[i] = fmt::format("residual {:.2f} px, {:.1f} times the median of the views", rms_of(residuals[i]),
                              rms_of(residuals[i]) / median);
      dropped[source[i].second] = true;
    }
    for (std::size_t i = 0; i < joint.observations.size(); ++i) {
      if (dropped[source[i].second]) joint.observations[i].used = false;
    }
    return !bad.empty();
  };
  if (cameras.size() > 1 || raised) {
    // First with the cameras as they were found alone: a pair that is no pair would bend them.
    for (JointCamera& camera : joint.cameras) camera.free = {};
    solve({.huber_px = 1});
    for (std::size_t c = 0; c < cameras.size(); ++c) joint.cameras[c].free = singles[c].problem.cameras[0].free;
    drop_outliers(kGrossFactor, kGrossPx);
    solve({.huber_px = 1});
  }
  JointReport optimised;
  for (int round = 0; round < 4; ++round) {
    if (!drop_outliers(kOutlierFactor, kOutlierPx) && round > 0) break;
    optimised = solve({.max_iterations = 300});
  }
  report.iterations = optimised.iterations;
  if (!optimised.converged) report.warnings.push_back("not_converged: the optimisation stopped: " + optimised.message);

  // The rig.
  const auto residuals = residuals_px(joint);
  JointCovariance sd = covariance(joint);
  const Pose world = raised ? target_to_world() : Pose{};
  report.rig.world = raised ? "the target: x right, y up the print, z out of it; height 0 is z = 0"
                            : fmt::format("camera {}", cameras.front().name);
  const Pose world_to_rig = raised ? joint.views[0].target_to_rig * world.inverse() : Pose{};
  std::vector<PointErrors> errors;
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    Camera camera{.name = cameras[c].name,
                  .width_px = cameras[c].width_px,
                  .height_px = cameras[c].height_px,
                  .model = CameraModel(joint.cameras[c].intrinsics),
                  .world_to_camera = joint.cameras[c].rig_to_camera * world_to_rig};
    CameraReport& own = report.cameras.emplace_back();
    own.name = camera.name;
    const Eigen::Matrix<double, 6, 6> pose_cov = c > 0 ? sd.rig_to_camera[c]
                                                 : raised
                                                     ? sd.views[0]
                                                     : Eigen::Matrix<double, 6, 6>(Eigen::Matrix<double, 6, 6>::Zero());
    own.parameters = list_parameters(joint.cameras[c], camera.world_to_camera, sd.cameras[c], pose_cov, c > 0 || raised,
                                     options.pitch_mm);
    std::vector<PointErrors> parts;
    for (std::size_t i = 0; i < joint.observations.size(); ++i) {
      const JointObservation& observation = joint.observations[i];
      if (observation.camera != static_cast<int>(c) || !observation.used) continue;
      Camera from_target = camera;
      from_target.world_to_camera =
          joint.cameras[c].rig_to_camera * joint.views[static_cast<std::size_t>(observation.view)].target_to_rig;
      std::vector<PointPair> pairs;
      for (std::size_t k = 0; k < observation.pixels.size(); ++k) {
        pairs.push_back({observation.points_mm[k], observation.pixels[k]});
        own.pixels.push_back(observation.pixels[k]);
      }
      try {
        parts.push_back(evaluate(from_target, pairs));
      } catch (const CalibrationError& error) {
        report.problems.push_back(fmt::format("{}: {}", cameras[c].views[source[i].second].file, error.what()));
      }
      own.residuals.insert(own.residuals.end(), residuals[i].begin(), residuals[i].end());
    }
    const PointErrors merged = merge(parts);
    own.rms_px = merged.rms_px;
    errors.push_back(merged);
    if (const auto warning = lens_limit_warning(camera)) report.warnings.push_back(*warning);
    report.rig.cameras.push_back(std::move(camera));
  }
  report.errors = merge(errors);

  for (std::size_t c = 0; c < cameras.size(); ++c) {
    for (std::size_t view = 0; view < views; ++view) {
      const SeenTarget& seen = cameras[c].views[view];
      ViewReport& entry = report.views.emplace_back();
      entry.camera = cameras[c].name;
      entry.file = seen.file;
      entry.view = static_cast<int>(view);
      entry.found = !seen.pixels.empty();
      entry.problem = entry.found ? "" : seen.problem.empty() ? "target not found" : seen.problem;
      bool in_problem = false;
      for (std::size_t i = 0; i < source.size(); ++i) {
        if (source[i] != std::pair(c, view)) continue;
        in_problem = true;
        entry.used = joint.observations[i].used;
        entry.rms_px = rms_of(residuals[i]);
        if (!entry.used) entry.problem = reason[i].empty() ? "its pair disagrees with the others" : reason[i];
      }
      if (entry.found && !in_problem) entry.problem = "no pose of the target explains its points";
      if (!entry.found) {
        report.warnings.push_back(fmt::format("target_not_found: {}: {}", entry.file, entry.problem));
      } else if (!entry.used) {
        report.warnings.push_back(fmt::format("outlier_view: {} is left out: {}", entry.file, entry.problem));
      }
    }
  }

  // Is it any good?
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const std::string focal =
        focal_problem(cameras[c].name, joint.cameras[c].intrinsics, std::sqrt(sd.cameras[c](P::f, P::f)));
    const double centre_sd = std::sqrt(std::max(sd.cameras[c](P::cx, P::cx), sd.cameras[c](P::cy, P::cy)));
    const std::string& name = cameras[c].name;
    if (!focal.empty()) {
      report.problems.push_back(focal);
    } else if (!(centre_sd < 0.05 * cameras[c].width_px)) {
      report.problems.push_back(
          fmt::format("{}: the image centre is known to {:.0f} px only: more views, tilted in different directions",
                      name, centre_sd));
    }
    const auto seen = static_cast<std::size_t>(std::ranges::count_if(
        joint.observations, [&](const auto& o) { return o.used && o.camera == static_cast<int>(c); }));
    if (seen == 1) {
      report.warnings.push_back(fmt::format(
          "one_view: {}: one view of a plane knows f and k1 only; square pixels and the middle of the image are taken "
          "for granted",
          name));
    } else if (seen < 4) {
      report.warnings.push_back(
          fmt::format("few_views: {}: {} views; ten, tilted in different directions, are usual", name, seen));
    }
    Vector2d low = Vector2d::Constant(1e9), high = Vector2d::Constant(-1e9);
    for (const Vector2d& pixel : report.cameras[c].pixels) {
      low = low.cwiseMin(pixel);
      high = high.cwiseMax(pixel);
    }
    const Vector2d share = (high - low).cwiseQuotient(Vector2d(cameras[c].width_px, cameras[c].height_px));
    if (share.minCoeff() < 0.5) {
      report.warnings.push_back(fmt::format(
          "coverage: {}: the targets reach over {:.0f} % of the width and {:.0f} % of the height of the image; beyond "
          "them the lens model is extrapolated",
          name, 100 * share.x(), 100 * share.y()));
    }
  }
  if (cameras.size() > 1) {
    const Pose relative = report.rig.between(0, 1);
    report.baseline_mm = relative.translation_mm.norm();
    const Vector3d direction = relative.translation_mm / std::max(*report.baseline_mm, 1e-12);
    report.baseline_sd_mm = std::sqrt(direction.dot(sd.rig_to_camera[1].bottomRightCorner<3, 3>() * direction));
    const Vector3d euler = euler_from_rotation_deg(relative.rotation);
    static const char* const kNames[] = {"rx_deg", "ry_deg", "rz_deg", "tx_mm", "ty_mm", "tz_mm"};
    for (int i = 0; i < 6; ++i) {
      const double deviation = std::sqrt(sd.rig_to_camera[1](i, i));
      report.relative.push_back({kNames[i], i < 3 ? euler[i] : relative.translation_mm[i - 3],
                                 i < 3 ? deviation * 180 / M_PI : deviation, true});
    }
    double distance = 0;
    for (const JointView& view : joint.views) {
      distance += view.target_to_rig.translation_mm.norm() / static_cast<double>(joint.views.size());
    }
    if (!(*report.baseline_mm > std::max(5 * report.baseline_sd_mm, 1e-3 * distance))) {
      report.problems.push_back(fmt::format(
          "the cameras stand at one place (baseline {:.3f} ± {:.3f} mm): are both sets of images from one camera?",
          *report.baseline_mm, report.baseline_sd_mm));
    } else if (direction.x() > 0.7) {
      report.warnings.push_back(
          fmt::format("left_right_exchanged: {} stands {:.1f} mm to the left of {}; are the images exchanged?",
                      cameras[1].name, relative.translation_mm.x(), cameras[0].name));
    }
    const auto pairs = static_cast<std::size_t>(
        std::ranges::count_if(joint.observations, [](const auto& o) { return o.used && o.camera == 1; }));
    if (pairs < 2 && !raised) {
      report.warnings.push_back(
          "one_pair: the relative pose rests on a single pair of images, and the ± of the report is several times too "
          "small: take ten");
    }
  }
  const double largest = std::max(kLargestRmsPx, 0.002 * cameras.front().width_px);
  if (!(report.errors.rms_px < largest)) {
    report.problems.push_back(fmt::format(
        "the views do not fit one rig: RMS {:.2f} px; are the images of a pair taken at one time, and is the target "
        "flat and as described?",
        report.errors.rms_px));
  }
  report.usable = report.problems.empty();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

}  // namespace horopter::calib
