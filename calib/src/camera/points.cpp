// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/points.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "camera/lens_limit.hpp"
#include "camera/parameter_list.hpp"
#include "camera/point_steps.hpp"
#include "horopter/calib/error.hpp"

namespace horopter::calib {
namespace {

using namespace detail;
using Eigen::Vector2d;
using Eigen::Vector3d;
using P = CameraParameters;

/// Standard deviation of f, as a part of f, beyond which one plane does not tell f from Tz.
constexpr double kFocalUnknown = 0.1;
/// The same, beyond which a report says that f and Tz are known together only.
constexpr double kFlatValley = 0.02;
/// The least noise that is believed of measured points, px.
constexpr double kLeastNoisePx = 0.02;
/// Steps of the last optimisation.
constexpr int kMaxIterations = 500;

JointProblem problem_of(std::span<const PointPair> points, const Intrinsics& intrinsics, const Pose& pose) {
  JointProblem problem;
  problem.cameras.push_back({.intrinsics = intrinsics, .free = {}, .rig_to_camera = {}});
  problem.views.push_back({.target_to_rig = pose});
  JointObservation& observation = problem.observations.emplace_back();
  for (const PointPair& point : points) {
    observation.points_mm.push_back(point.world_mm);
    observation.pixels.push_back(point.pixel);
  }
  return problem;
}

/// The second step of Tsai's method: f, tz and κ1 (6.20, 6.21).
JointReport three_parameters(JointProblem& problem) {
  problem.cameras[0].free = {};
  problem.cameras[0].free[P::f] = problem.cameras[0].free[P::lens] = true;
  problem.views[0].free = {false, false, false, false, false, true};
  JointReport report = optimise(problem);
  problem.views[0].free = kWholePose;
  return report;
}

FreeParameters full_parameters(bool coplanar, const PointOptions& options) {
  FreeParameters free{};
  free[P::f] = free[P::cx] = free[P::cy] = free[P::lens] = true;
  free[P::scale] = !coplanar;
  // κ2 κ3 are k2 k3, the thesis's p1 p2 are p2 p1, s1 s2 are s1 s3 of the lens map.
  if (options.kappa2) free[P::lens + 1] = true;
  if (options.kappa3) free[P::lens + 4] = true;
  if (options.decentring) free[P::lens + 2] = free[P::lens + 3] = true;
  if (options.thin_prism) free[P::lens + 8] = free[P::lens + 10] = true;
  return free;
}

double relative_sd_of_f(const JointProblem& problem) {
  JointProblem copy = problem;
  copy.cameras[0].free = {};
  copy.cameras[0].free[P::f] = true;
  const JointCovariance result = covariance(copy, 0, kLeastNoisePx);
  return std::sqrt(result.cameras[0](P::f, P::f)) / CameraParameters::from(copy.cameras[0].intrinsics)[P::f];
}

std::vector<Parameter> list_parameters(const JointProblem& problem, const JointCovariance& sd, bool pose_free) {
  const auto& tsai = std::get<TsaiIntrinsics>(problem.cameras[0].intrinsics);
  const auto& cov = sd.cameras[0];
  const auto& free = problem.cameras[0].free;
  const auto deviation = [&](int i) { return std::sqrt(cov(i, i)); };
  const double fx_sd = fx_deviation(tsai.f_mm, tsai.sx, cov) / tsai.dx_mm;
  std::vector<Parameter> list{
      {"f_mm", tsai.f_mm, deviation(P::f), free[P::f]},
      {"fx_px", tsai.fx_px(), fx_sd, free[P::f]},
      {"fy_px", tsai.fy_px(), deviation(P::f) / tsai.dy_mm, free[P::f]},
      {"cx_px", tsai.cx_px, deviation(P::cx), free[P::cx]},
      {"cy_px", tsai.cy_px, deviation(P::cy), free[P::cy]},
      {"sx", tsai.sx, deviation(P::scale), free[P::scale]},
      {"dx_mm", tsai.dx_mm, 0, false},
      {"dy_mm", tsai.dy_mm, 0, false},
  };
  const std::pair<const char*, std::size_t> lens[] = {
      {"kappa1_per_mm2", 0}, {"kappa2_per_mm4", 1}, {"kappa3_per_mm6", 4}, {"p1_per_mm", 3},
      {"p2_per_mm", 2},      {"s1_per_mm", 8},      {"s2_per_mm", 10}};
  const auto values = tsai.lens().array();
  for (const auto& [name, index] : lens) {
    list.push_back({name, values[index], deviation(P::lens + static_cast<int>(index)),
                    free[static_cast<std::size_t>(P::lens) + index]});
  }
  append_pose(list, problem.views[0].target_to_rig, sd.views[0], pose_free);
  return list;
}

void warn_sensor(PointCalibration& result, const Sensor& sensor, std::span<const PointPair> points) {
  const CameraModel& model = result.camera.model;
  const auto outside = std::ranges::count_if(points, [&](const PointPair& p) {
    return p.pixel.x() < -0.5 || p.pixel.y() < -0.5 || p.pixel.x() > sensor.width_px - 0.5 ||
           p.pixel.y() > sensor.height_px - 0.5;
  });
  if (outside > 0) {
    result.warnings.push_back(fmt::format("points_outside_sensor: {} of {} image points lie outside {}x{} pixels",
                                          outside, points.size(), sensor.width_px, sensor.height_px));
  }
  const auto& tsai = std::get<TsaiIntrinsics>(model.intrinsics());
  if (tsai.sx < 0.8 || tsai.sx > 1.25) {
    result.warnings.push_back(
        fmt::format("unlikely_sx: sx = {:.4f}; is dx_mm the pitch of frame grabber pixels?", tsai.sx));
  }
  if (model.cx_px() < 0 || model.cy_px() < 0 || model.cx_px() > sensor.width_px || model.cy_px() > sensor.height_px) {
    result.warnings.push_back(fmt::format("centre_outside_sensor: the image centre is found at ({:.1f}, {:.1f})",
                                          model.cx_px(), model.cy_px()));
  }
  if (const auto warning = lens_limit_warning(result.camera)) result.warnings.push_back(*warning);
}

void warn_outliers(PointCalibration& result) {
  const auto& residuals = result.errors.residuals_px;
  std::vector<double> sizes;
  sizes.reserve(residuals.size());
  for (const Vector2d& residual : residuals) sizes.push_back(residual.norm());
  std::vector<double> sorted = sizes;
  std::ranges::sort(sorted);
  const double limit = std::max(6 * sorted[sorted.size() / 2], 0.1);
  std::string names;
  int count = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] <= limit) continue;
    if (++count <= 8) names += fmt::format("{}{} ({:.2f} px)", names.empty() ? "" : ", ", i + 1, sizes[i]);
  }
  if (count > 0) {
    result.warnings.push_back(fmt::format("outlier_points: {} of {} points lie more than {:.2f} px off: number {}{}",
                                          count, sizes.size(), limit, names, count > 8 ? ", …" : ""));
  }
}

void warn_flat_valley(PointCalibration& result, double f_mm, double f_sd_mm) {
  if (!(f_sd_mm > kFlatValley * f_mm)) return;
  result.warnings.push_back(
      fmt::format("flat_valley: f = {:.3f} ± {:.3f} mm and Tz are known together only; Tz/f = {:.4f} ± {:.4f}", f_mm,
                  f_sd_mm, result.tz_over_f, result.tz_over_f_sd));
}

void warn_one_plane(PointCalibration& result, const Frame& frame, double sx) {
  const Vector3d camera = frame.world_to_frame * result.camera.world_to_camera.centre();
  const Vector3d normal = frame.world_to_frame.rotation.transpose() * Vector3d(0, 0, camera.z());
  result.warnings.push_back(fmt::format(
      "one_plane: sx = {:g} is taken as given, and one plane cannot show a mirrored order of its points; by these "
      "points the camera stands {:.0f} mm away on the {} side of the plane",
      sx, std::abs(camera.z()), normal.z() > 0 ? "+z" : "-z"));
}

void check_sensor(const Sensor& sensor) {
  if (!(sensor.dx_mm > 0 && sensor.dy_mm > 0) || sensor.width_px < 2 || sensor.height_px < 2 ||
      !(sensor.sx.value_or(1) > 0)) {
    throw CalibrationError("a sensor needs a width and height, and positive pitches and sx");
  }
}

/// The frame of points that are enough, and not all on a line.
Frame checked_frame(std::span<const PointPair> points) {
  check_count(points.size(), 6, "any method");
  const Frame frame = frame_of(points);
  if (!(frame.extent_mm[0] > 0)) throw CalibrationError("all points are the same point");
  if (!(frame.extent_mm[1] > kThin * frame.extent_mm[0])) {
    throw CalibrationError("the points lie on one line: they do not determine a camera");
  }
  return frame;
}

/// Root of the mean squared distance of the points from where the matrix puts them, px.
double matrix_rms(const Eigen::Matrix<double, 3, 4>& m, std::span<const PointPair> points) {
  double sum = 0;
  for (const PointPair& point : points) {
    sum += ((m * point.world_mm.homogeneous()).hnormalized() - point.pixel).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// What follows from points need not be a camera.
CameraModel found_model(const Intrinsics& intrinsics) {
  try {
    return CameraModel(intrinsics);
  } catch (const std::invalid_argument& error) {
    throw CalibrationError(fmt::format("the points determine no camera: {}", error.what()));
  }
}

/// The linear method: `result` gets the physical camera in the matrix of (6.6).
void calibrate_linearly(std::span<const PointPair> points, const Sensor& sensor, PointCalibration& result) {
  const Eigen::Matrix<double, 3, 4> m = direct_linear_transform(points);
  const PhysicalCamera physical = physical_camera(m);
  TsaiIntrinsics tsai{.f_mm = physical.fy_px * sensor.dy_mm, .dx_mm = sensor.dx_mm, .dy_mm = sensor.dy_mm};
  tsai.sx = physical.fx_px * sensor.dx_mm / tsai.f_mm;
  tsai.cx_px = physical.cx_px;
  tsai.cy_px = physical.cy_px;
  result.matrix_rms_px = matrix_rms(m, points);
  result.camera.model = found_model(tsai);
  result.camera.world_to_camera = physical.world_to_camera;
  JointProblem problem = problem_of(points, tsai, physical.world_to_camera);
  FreeParameters& free = problem.cameras[0].free;
  free[P::f] = free[P::scale] = free[P::cx] = free[P::cy] = true;
  const JointCovariance sd = covariance(problem);
  result.parameters = list_parameters(problem, sd, true);
  result.pose_covariance = sd.views[0];
  result.parameters.push_back({"skew_px", physical.skew_px, 0, false});
  result.parameters.push_back({"matrix_rms_px", *result.matrix_rms_px, 0, false});
  result.tz_over_f = physical.world_to_camera.translation_mm.z() / tsai.f_mm;
}

/// A camera found by Tsai's two steps.
struct TwoSteps {
  JointProblem problem;
  JointReport report;
};

TwoSteps two_steps(std::span<const PointPair> points, const Sensor& sensor, bool coplanar) {
  const LinearCamera start = linear_camera(points, sensor, coplanar);
  TwoSteps result{problem_of(points, start.intrinsics, start.world_to_camera), {}};
  result.report = three_parameters(result.problem);
  return result;
}

/// Tsai's two steps with the image centre given, searched, or whichever of the two predicts the points better.
TwoSteps two_steps(std::span<const PointPair> points, const Sensor& sensor, CentreSearch centre,
                   PointCalibration& result) {
  std::optional<TwoSteps> best;
  std::string failure;
  if (centre != CentreSearch::searched) {
    try {
      best = two_steps(points, sensor, result.coplanar);
    } catch (const CalibrationError& error) {
      failure = error.what();
    }
  }
  if (centre == CentreSearch::searched || (centre == CentreSearch::automatic && !result.coplanar)) {
    try {
      const auto found = search_centre(points, sensor, result.coplanar);
      if (!found) throw CalibrationError("the search for the image centre leaves the sensor; give a centre");
      Sensor used = sensor;
      used.cx_px = found->x();
      used.cy_px = found->y();
      TwoSteps searched = two_steps(points, used, result.coplanar);
      if (!best || searched.report.rms_px < best->report.rms_px) best = std::move(searched);
    } catch (const CalibrationError& error) {
      if (failure.empty()) failure = error.what();
    }
  }
  if (!best) throw CalibrationError(failure);
  return std::move(*best);
}

/// The problem without the points near the image centre, whose radial direction is all noise (6.5). `near_centre` is
/// a part of the distance of the farthest point.
JointProblem without_centre(const JointProblem& problem, double near_centre) {
  const auto& tsai = std::get<TsaiIntrinsics>(problem.cameras[0].intrinsics);
  const Vector2d centre(tsai.cx_px, tsai.cy_px);
  const JointObservation& all = problem.observations[0];
  double farthest = 0;
  for (const Vector2d& pixel : all.pixels) farthest = std::max(farthest, (pixel - centre).norm());
  JointProblem outer = problem;
  JointObservation& observation = outer.observations[0];
  observation.points_mm.clear();
  observation.pixels.clear();
  for (std::size_t i = 0; i < all.pixels.size(); ++i) {
    if ((all.pixels[i] - centre).norm() < near_centre * farthest) continue;
    observation.points_mm.push_back(all.points_mm[i]);
    observation.pixels.push_back(all.pixels[i]);
  }
  return outer;
}

/// Everything at once, from Tsai's solution, in the two passes of 6.5.
void optimise_everything(JointProblem& problem, const PointOptions& options, PointCalibration& result) {
  const std::size_t coordinates = 2 * problem.observations[0].pixels.size();
  problem.cameras[0].free = full_parameters(result.coplanar, options);
  const auto unknowns = static_cast<std::size_t>(std::ranges::count(problem.cameras[0].free, true)) + 6;
  check_count(coordinates, unknowns + 2, "coordinates are given, and these parameters");
  JointProblem outer = without_centre(problem, options.near_centre);
  if (2 * outer.observations[0].pixels.size() >= unknowns + 2) {
    try {
      result.iterations += optimise(outer).iterations;
      problem.cameras[0].intrinsics = outer.cameras[0].intrinsics;
      problem.views[0] = outer.views[0];
    } catch (const CalibrationError&) {
      // The points left do not hold it: the second pass starts from Tsai's solution.
    }
  }
  const JointReport report = optimise(problem, {.max_iterations = kMaxIterations});
  result.iterations += report.iterations;
  if (!report.converged) {
    result.warnings.push_back(
        fmt::format("not_converged: the optimisation stopped after {} steps; see the deviations", kMaxIterations));
  }
}

void check_focal_length(const JointProblem& problem, bool coplanar) {
  if (coplanar && !(relative_sd_of_f(problem) < kFocalUnknown)) throw CalibrationError(kParallel);
}

/// Takes camera, parameters and deviations from the solved problem. Only tz of the pose was free if not `pose_free`.
void take_solution(JointProblem problem, bool pose_free, PointCalibration& result) {
  result.camera.model = found_model(problem.cameras[0].intrinsics);
  result.camera.world_to_camera = problem.views[0].target_to_rig;
  if (!pose_free) problem.views[0].free = {false, false, false, false, false, true};
  const JointCovariance sd = covariance(problem);
  result.parameters = list_parameters(problem, sd, pose_free);
  result.pose_covariance = sd.views[0];
  if (!pose_free) result.pose_covariance.setConstant(std::numeric_limits<double>::infinity());  // the linear step's
  for (Parameter& parameter : result.parameters) {
    if (parameter.name == "tz_mm") parameter.free = true;
  }
  const auto& tsai = std::get<TsaiIntrinsics>(result.camera.model.intrinsics());
  const double f = tsai.f_mm, tz = result.camera.world_to_camera.translation_mm.z();
  const double f_variance = sd.cameras[0](P::f, P::f), tz_variance = sd.views[0](5, 5);
  result.tz_over_f = tz / f;
  result.tz_over_f_sd = std::sqrt(
      std::max(0.0, tz_variance / (f * f) + f_variance * tz * tz / std::pow(f, 4) - 2 * sd.f_tz * tz / std::pow(f, 3)));
}

double f_sd_mm(const PointCalibration& result) {
  return std::ranges::find(result.parameters, "f_mm", &Parameter::name)->sd;
}

/// Tsai's two steps, and what `full` adds to them.
void calibrate_by_tsai(std::span<const PointPair> points, const Sensor& sensor, const PointOptions& options,
                       PointCalibration& result) {
  check_count(points.size(), result.coplanar ? 6 : 8, result.coplanar ? "one plane" : "Tsai's method");
  TwoSteps solved = two_steps(points, sensor, options.centre, result);
  result.iterations = solved.report.iterations;
  check_focal_length(solved.problem, result.coplanar);
  const bool full = result.method == PointMethod::full;
  if (full) {
    optimise_everything(solved.problem, options, result);
    check_focal_length(solved.problem, result.coplanar);
  }
  take_solution(std::move(solved.problem), full, result);
}

}  // namespace

std::string_view point_method_name(PointMethod method) {
  switch (method) {
    case PointMethod::dlt:
      return "dlt";
    case PointMethod::tsai:
      return "tsai";
    case PointMethod::full:
      return "full";
  }
  return "";
}

PointMethod point_method(std::string_view name) {
  for (const PointMethod method : {PointMethod::dlt, PointMethod::tsai, PointMethod::full}) {
    if (name == point_method_name(method)) return method;
  }
  throw std::invalid_argument(fmt::format("no method '{}'; expected dlt, tsai or full", name));
}

PointErrors evaluate(const Camera& camera, std::span<const PointPair> points) {
  PointErrors errors;
  errors.count = points.size();
  double sum = 0, sum_squares = 0, sum_nce = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d p = camera.world_to_camera * points[i].world_mm;
    const auto predicted = camera.model.project(p);
    const auto direction = camera.model.undistort(points[i].pixel);
    if (!predicted || !direction) {
      throw CalibrationError(fmt::format("point {} ({:g}, {:g}, {:g}) is {}", i + 1, points[i].world_mm.x(),
                                         points[i].world_mm.y(), points[i].world_mm.z(),
                                         p.z() > 0 ? "beyond the limit of the lens model" : "behind the camera"));
    }
    const Vector2d residual = points[i].pixel - *predicted;
    errors.residuals_px.push_back(residual);
    const double distance = residual.norm();
    sum += distance;
    sum_squares += distance * distance;
    errors.max_px = std::max(errors.max_px, distance);
    // (6.35) with the lateral digitisation noise of one pixel (6.36), both divided by z.
    const double noise2 = (std::pow(camera.model.fx_px(), -2) + std::pow(camera.model.fy_px(), -2)) / 12;
    sum_nce += std::sqrt((*direction - p.head<2>() / p.z()).squaredNorm() / noise2);
  }
  const double n = static_cast<double>(points.size());
  if (points.empty()) return errors;
  errors.mean_px = sum / n;
  errors.rms_px = std::sqrt(sum_squares / n);
  errors.sd_px = points.size() > 1 ? std::sqrt(std::max(0.0, (sum_squares - sum * sum / n) / (n - 1))) : 0;
  errors.nce = sum_nce / n;
  errors.nce_thesis = errors.nce / 0.2;
  return errors;
}

PointCalibration calibrate_points(std::span<const PointPair> points, const Sensor& sensor, PointMethod method,
                                  const PointOptions& options) {
  check_finite(points);
  check_sensor(sensor);
  const Frame frame = checked_frame(points);
  PointCalibration result;
  result.method = method;
  result.coplanar = !(frame.extent_mm[2] > kFlat * frame.extent_mm[0]);
  result.camera.name = "camera";
  result.camera.width_px = sensor.width_px;
  result.camera.height_px = sensor.height_px;
  for (const PointPair& point : points) result.pixels.push_back(point.pixel);
  if (method == PointMethod::dlt) {
    calibrate_linearly(points, sensor, result);
  } else {
    calibrate_by_tsai(points, sensor, options, result);
  }
  result.errors = evaluate(result.camera, points);
  warn_sensor(result, sensor, points);
  warn_outliers(result);
  if (method == PointMethod::dlt) return result;
  const auto& tsai = std::get<TsaiIntrinsics>(result.camera.model.intrinsics());
  warn_flat_valley(result, tsai.f_mm, f_sd_mm(result));
  if (result.coplanar) warn_one_plane(result, frame, tsai.sx);
  return result;
}

}  // namespace horopter::calib
