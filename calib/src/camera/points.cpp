// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/points.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "camera/lens_limit.hpp"
#include "horopter/calib/error.hpp"

namespace horopter::calib {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Thickness over extent below which points count as lying in a plane.
constexpr double kFlat = 0.01;
/// Width over extent below which they count as lying on a line.
constexpr double kThin = 1e-3;
/// Standard deviation of f, as a part of f, beyond which one plane does not tell f from Tz.
constexpr double kFocalUnknown = 0.1;
/// The least noise that is believed of measured points, px.
constexpr double kLeastNoisePx = 0.02;

/// World coordinates in which the points' mean is the origin and their plane of least squares z = 0.
struct Frame {
  Pose world_to_frame;
  Vector3d extent_mm;  ///< root mean square along x, y, z
};

Frame frame_of(std::span<const PointPair> points) {
  Vector3d mean = Vector3d::Zero();
  for (const PointPair& point : points) mean += point.world_mm;
  mean /= static_cast<double>(points.size());
  Matrix3d scatter = Matrix3d::Zero();
  for (const PointPair& point : points) {
    const Vector3d d = point.world_mm - mean;
    scatter += d * d.transpose() / static_cast<double>(points.size());
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(scatter);
  Matrix3d rotation;  // rows: the widest axis first
  for (int i = 0; i < 3; ++i) rotation.row(i) = solver.eigenvectors().col(2 - i).transpose();
  if (rotation.determinant() < 0) rotation.row(2) *= -1;
  Frame frame;
  frame.extent_mm = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
  if (rotation.row(2).cwiseAbs().maxCoeff() > 1 - 1e-9 && std::abs(rotation(2, 2)) > 0.5) {
    rotation.setIdentity();  // the usual plane z = constant keeps its axes
  }
  frame.world_to_frame = {rotation, -(rotation * mean)};
  return frame;
}

std::vector<PointPair> in_frame(std::span<const PointPair> points, const Pose& world_to_frame) {
  std::vector<PointPair> moved(points.begin(), points.end());
  for (PointPair& point : moved) point.world_mm = world_to_frame * point.world_mm;
  return moved;
}

void check_finite(std::span<const PointPair> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].world_mm.allFinite() || !points[i].pixel.allFinite()) {
      throw CalibrationError(fmt::format("point {} has a coordinate that is not a finite number", i + 1));
    }
  }
}

void check_count(std::size_t count, std::size_t least, std::string_view why) {
  if (count < least) {
    throw CalibrationError(fmt::format("too few points: {}; {} needs at least {}", count, why, least));
  }
}

/// Sensor coordinates x'_d, y_d of 6.17, mm. x is not yet divided by sx.
Vector2d on_sensor(const PointPair& point, const Sensor& sensor) {
  return {(point.pixel.x() - sensor.cx_px) * sensor.dx_mm, (point.pixel.y() - sensor.cy_px) * sensor.dy_mm};
}

/// The last right singular vector, after scaling the columns; throws when the last but one is as good.
VectorXd null_vector(const MatrixXd& matrix, const char* why) {
  const VectorXd scale = matrix.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  const Eigen::JacobiSVD<MatrixXd> svd(matrix * scale.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeFullV);
  const Eigen::Index n = matrix.cols();
  if (svd.singularValues().size() >= n - 1 && !(svd.singularValues()[n - 2] > 1e-7 * svd.singularValues()[0])) {
    throw CalibrationError(why);
  }
  return scale.asDiagonal() * svd.matrixV().col(n - 1);
}

/// Distance of the measured points from the radial lines that a pose predicts (6.17), mm.
VectorXd radial_residuals(std::span<const PointPair> points, const Sensor& sensor, const RadialAlignment& solution) {
  VectorXd residuals(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector2d measured = on_sensor(points[i], sensor);
    measured.x() /= solution.sx;
    const Vector3d predicted = solution.world_to_camera * points[i].world_mm;
    const double radius = std::max(predicted.head<2>().norm(), 1e-12);
    residuals[static_cast<Eigen::Index>(i)] = (measured.x() * predicted.y() - measured.y() * predicted.x()) / radius;
  }
  return residuals;
}

/// Gives a solution of the homogeneous system its sign: points lie on the side of the centre where they are seen.
bool points_seen(std::span<const PointPair> points, const Sensor& sensor, const Eigen::RowVector3d& r1, double tx,
                 const Eigen::RowVector3d& r2, double ty) {
  double agreement = 0;
  for (const PointPair& point : points) {
    const Vector2d measured = on_sensor(point, sensor);
    agreement += measured.x() * (r1 * point.world_mm + tx) + measured.y() * (r2 * point.world_mm + ty);
  }
  return agreement >= 0;
}

/// f and tz by (6.19), with both coordinates instead of y alone, so that no direction of tilt is special.
struct FocalLength {
  double f_mm = 0;
  double tz_mm = 0;
};

FocalLength focal_length(std::span<const PointPair> points, const Sensor& sensor, const RadialAlignment& solution) {
  const auto rows = static_cast<Eigen::Index>(2 * points.size());
  Eigen::MatrixX2d a(rows, 2);
  VectorXd b(rows);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(2 * i);
    Vector2d measured = on_sensor(points[i], sensor);
    measured.x() /= solution.sx;
    const Vector3d p = solution.world_to_camera * points[i].world_mm;  // z without tz
    a.row(row) << p.x(), -measured.x();
    a.row(row + 1) << p.y(), -measured.y();
    b.segment<2>(row) = measured * p.z();
  }
  const Eigen::Vector2d scale = a.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  const Eigen::Vector2d x =
      scale.asDiagonal() * Eigen::ColPivHouseholderQR<Eigen::MatrixX2d>(a * scale.asDiagonal()).solve(b);
  return {x[0], x[1]};
}

const char* const kMirrored =
    "the points fit a mirrored camera only: their order is mirrored in the world or in the image (world axes must be "
    "right-handed, u to the right, v down)";
const char* const kDegenerate =
    "the points do not determine the camera: too many of them lie on a line, or all on lines through the image centre";
const char* const kParallel =
    "the points lie in a plane parallel to the image, or nearly so: f and Tz cannot be told apart; tilt the plane "
    "against the image (30 degrees or so) or add points at other heights";

struct Start {
  TsaiIntrinsics intrinsics;
  Pose world_to_camera;
  RadialAlignment alignment;
};

/// The linear steps: radial alignment, then f and tz; the pose that puts the points in front.
Start linear_start(std::span<const PointPair> points, const Sensor& sensor, bool coplanar) {
  std::optional<Start> best;
  double best_error = std::numeric_limits<double>::infinity();
  bool behind = false;
  for (const RadialAlignment& alignment : radial_alignment(points, sensor, coplanar)) {
    const FocalLength focal = focal_length(points, sensor, alignment);
    Start start{.intrinsics = {.f_mm = focal.f_mm,
                               .dx_mm = sensor.dx_mm,
                               .dy_mm = sensor.dy_mm,
                               .sx = alignment.sx,
                               .cx_px = sensor.cx_px,
                               .cy_px = sensor.cy_px},
                .world_to_camera = alignment.world_to_camera,
                .alignment = alignment};
    start.world_to_camera.translation_mm.z() = focal.tz_mm;
    if (!(focal.f_mm > 0) || !std::isfinite(focal.f_mm)) {
      behind = true;
      continue;
    }
    double error = 0;
    for (const PointPair& point : points) {
      const Vector3d p = start.world_to_camera * point.world_mm;
      if (!(p.z() > 0)) {
        error = std::numeric_limits<double>::infinity();
        break;
      }
      Vector2d measured = on_sensor(point, sensor);
      measured.x() /= alignment.sx;
      error += (measured - focal.f_mm * p.head<2>() / p.z()).squaredNorm();
    }
    if (error < best_error) {
      best_error = error;
      best = start;
    }
  }
  if (!best) throw CalibrationError(coplanar ? kParallel : behind ? kMirrored : kDegenerate);
  return *best;
}

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
  using P = CameraParameters;
  problem.cameras[0].free = {};
  problem.cameras[0].free[P::f] = problem.cameras[0].free[P::lens] = true;
  problem.views[0].free = {false, false, false, false, false, true};
  JointReport report = optimise(problem);
  problem.views[0].free = kWholePose;
  return report;
}

FreeParameters full_parameters(bool coplanar, const PointOptions& options) {
  using P = CameraParameters;
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
  using P = CameraParameters;
  JointProblem copy = problem;
  copy.cameras[0].free = {};
  copy.cameras[0].free[P::f] = true;
  const JointCovariance result = covariance(copy, 0, kLeastNoisePx);
  return std::sqrt(result.cameras[0](P::f, P::f)) / CameraParameters::from(copy.cameras[0].intrinsics)[P::f];
}

std::vector<Parameter> list_parameters(const JointProblem& problem, const JointCovariance& sd, bool pose_free) {
  using P = CameraParameters;
  const auto& tsai = std::get<TsaiIntrinsics>(problem.cameras[0].intrinsics);
  const auto& cov = sd.cameras[0];
  const auto& free = problem.cameras[0].free;
  const Pose& pose = problem.views[0].target_to_rig;
  const Vector3d euler = euler_from_rotation_deg(pose.rotation);
  const auto deviation = [&](int i) { return std::sqrt(cov(i, i)); };
  const double fx_sd =
      std::sqrt(std::max(0.0, cov(P::f, P::f) * tsai.sx * tsai.sx + cov(P::scale, P::scale) * tsai.f_mm * tsai.f_mm +
                                  2 * cov(P::f, P::scale) * tsai.f_mm * tsai.sx)) /
      tsai.dx_mm;
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
  const char* const angles[] = {"rx_deg", "ry_deg", "rz_deg"};
  const char* const lengths[] = {"tx_mm", "ty_mm", "tz_mm"};
  for (int i = 0; i < 3; ++i) {
    list.push_back({angles[i], euler[i], std::sqrt(sd.views[0](i, i)) * 180 / M_PI, pose_free});
  }
  for (int i = 0; i < 3; ++i) {
    list.push_back({lengths[i], pose.translation_mm[i], std::sqrt(sd.views[0](3 + i, 3 + i)), pose_free});
  }
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

/// For the MINPACK port: distances from the radial lines as a function of the image centre.
struct CentreResidual {
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  std::span<const PointPair> points;
  Sensor sensor;
  bool coplanar;

  int inputs() const { return 2; }
  int values() const { return static_cast<int>(points.size()); }
  int operator()(const VectorXd& centre, VectorXd& residuals) const {
    Sensor moved = sensor;
    moved.cx_px = centre[0];
    moved.cy_px = centre[1];
    try {
      residuals = radial_residuals(points, moved, radial_alignment(points, moved, coplanar).front());
    } catch (const CalibrationError&) {
      return -1;
    }
    return 0;
  }
};

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

Eigen::Matrix<double, 3, 4> direct_linear_transform(std::span<const PointPair> points) {
  check_finite(points);
  check_count(points.size(), 6, "the linear method");
  const Frame frame = frame_of(points);
  if (!(frame.extent_mm[1] > kThin * frame.extent_mm[0])) throw CalibrationError(kDegenerate);
  if (!(frame.extent_mm[2] > kFlat * frame.extent_mm[0])) {
    throw CalibrationError(
        "the points lie in a plane: the linear method needs points at several heights (method tsai or full takes one "
        "plane)");
  }
  Vector3d mean = Vector3d::Zero();
  Vector2d centre = Vector2d::Zero();
  for (const PointPair& point : points) {
    mean += point.world_mm / static_cast<double>(points.size());
    centre += point.pixel / static_cast<double>(points.size());
  }
  double world_scale = 0, image_scale = 0;
  for (const PointPair& point : points) {
    world_scale += (point.world_mm - mean).norm();
    image_scale += (point.pixel - centre).norm();
  }
  if (!(image_scale > 0)) throw CalibrationError("all image points are the same point");
  world_scale = std::sqrt(3.0) * static_cast<double>(points.size()) / world_scale;
  image_scale = std::sqrt(2.0) * static_cast<double>(points.size()) / image_scale;

  MatrixXd a(static_cast<Eigen::Index>(2 * points.size()), 12);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::RowVector4d p;
    p << (points[i].world_mm - mean).transpose() * world_scale, 1;
    const Vector2d q = (points[i].pixel - centre) * image_scale;
    const auto row = static_cast<Eigen::Index>(2 * i);
    a.row(row) << p, Eigen::RowVector4d::Zero(), -q.x() * p;
    a.row(row + 1) << Eigen::RowVector4d::Zero(), p, -q.y() * p;
  }
  const VectorXd solution = null_vector(a, kDegenerate);
  Eigen::Matrix<double, 3, 4> m;
  for (Eigen::Index row = 0; row < 3; ++row) m.row(row) = solution.segment<4>(4 * row).transpose();
  Matrix3d image = Matrix3d::Identity();
  image.topLeftCorner<2, 2>() /= image_scale;
  image.topRightCorner<2, 1>() = centre;
  Eigen::Matrix4d world = Eigen::Matrix4d::Identity();
  world.topLeftCorner<3, 3>() *= world_scale;
  world.topRightCorner<3, 1>() = -world_scale * mean;
  m = (image * m * world).eval();
  const double norm = m.block<1, 3>(2, 0).norm();
  if (!(norm > 0)) throw CalibrationError(kDegenerate);
  m /= norm;
  int front = 0;
  for (const PointPair& point : points) front += m.row(2).dot(point.world_mm.homogeneous()) > 0 ? 1 : -1;
  if (front < 0) m = -m;
  return m;
}

PhysicalCamera physical_camera(const Eigen::Matrix<double, 3, 4>& m) {
  const Matrix3d left = m.leftCols<3>() / m.block<1, 3>(2, 0).norm();
  if (!(left.determinant() > 0)) throw CalibrationError(kMirrored);
  // RQ by Gram-Schmidt from the last row up; the signs make K's diagonal positive.
  Matrix3d k = Matrix3d::Zero();
  Matrix3d rotation;
  rotation.row(2) = left.row(2);
  k(2, 2) = 1;
  k(1, 2) = left.row(1).dot(rotation.row(2));
  const Eigen::RowVector3d second = left.row(1) - k(1, 2) * rotation.row(2);
  k(1, 1) = second.norm();
  rotation.row(1) = second / k(1, 1);
  k(0, 2) = left.row(0).dot(rotation.row(2));
  k(0, 1) = left.row(0).dot(rotation.row(1));
  const Eigen::RowVector3d first = left.row(0) - k(0, 2) * rotation.row(2) - k(0, 1) * rotation.row(1);
  k(0, 0) = first.norm();
  rotation.row(0) = first / k(0, 0);
  PhysicalCamera camera{k(0, 0), k(1, 1), k(0, 1), k(0, 2), k(1, 2), {}};
  camera.world_to_camera.rotation = nearest_rotation(rotation);
  camera.world_to_camera.translation_mm = k.inverse() * m.col(3) / m.block<1, 3>(2, 0).norm();
  return camera;
}

std::vector<RadialAlignment> radial_alignment(std::span<const PointPair> world_points, const Sensor& sensor,
                                              bool coplanar) {
  const Frame frame = frame_of(world_points);
  const std::vector<PointPair> points = in_frame(world_points, frame.world_to_frame);
  const auto rows = static_cast<Eigen::Index>(points.size());
  const double given_sx = sensor.sx.value_or(1);
  MatrixXd a(rows, coplanar ? 6 : 8);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector2d d = on_sensor(points[i], sensor);
    if (coplanar) d.x() /= given_sx;
    const Vector3d& p = points[i].world_mm;
    const auto row = static_cast<Eigen::Index>(i);
    if (coplanar) {
      a.row(row) << d.y() * p.x(), d.y() * p.y(), d.y(), -d.x() * p.x(), -d.x() * p.y(), -d.x();
    } else {
      a.row(row) << d.y() * p.transpose(), d.y(), -d.x() * p.transpose(), -d.x();
    }
  }
  const VectorXd v = null_vector(a, kDegenerate);
  std::vector<RadialAlignment> solutions;
  const auto add = [&](Eigen::RowVector3d r1, double tx, Eigen::RowVector3d r2, double ty, double sx) {
    if (!points_seen(points, sensor, r1, tx, r2, ty)) {
      r1 = -r1;
      r2 = -r2;
      tx = -tx;
      ty = -ty;
    }
    Matrix3d rotation;
    rotation << r1, r2, r1.cross(r2);
    RadialAlignment solution;
    solution.sx = sx;
    solution.world_to_camera = Pose{nearest_rotation(rotation), Vector3d(tx, ty, 0)};
    solution.rms_mm = std::sqrt(radial_residuals(points, sensor, solution).squaredNorm() / static_cast<double>(rows));
    solution.world_to_camera = solution.world_to_camera * frame.world_to_frame;
    solutions.push_back(solution);
  };
  if (!coplanar) {
    const double r1_norm = v.head<3>().norm(), r2_norm = v.segment<3>(4).norm();
    if (!(r1_norm > 0 && r2_norm > 0)) throw CalibrationError(kDegenerate);
    const double sx = r1_norm / r2_norm;
    add(v.head<3>().transpose() / r1_norm, v[3] / r1_norm, v.segment<3>(4).transpose() / r2_norm, v[7] / r2_norm, sx);
    return solutions;
  }
  // λ(r11, r12) = a, λ(r21, r22) = b. |r1| = |r2| = 1 and r1 · r2 = 0 leave λ⁴ − (|a|² + |b|²)λ² + det(a, b)² = 0; the
  // larger root is the one with λ ≥ |a|, |b|.
  const Vector2d first = v.head<2>(), second = v.segment<2>(3);
  const double s = first.squaredNorm() + second.squaredNorm();
  const double determinant = first.x() * second.y() - first.y() * second.x();
  const double lambda = std::sqrt(0.5 * (s + std::sqrt(std::max(0.0, s * s - 4 * determinant * determinant))));
  if (!(lambda > 0)) throw CalibrationError(kDegenerate);
  const Vector2d r1 = first / lambda, r2 = second / lambda;
  const double r13 = std::sqrt(std::max(0.0, 1 - r1.squaredNorm()));
  const double r23 = std::copysign(std::sqrt(std::max(0.0, 1 - r2.squaredNorm())), -r1.dot(r2));
  for (const double sign : {1.0, -1.0}) {
    add({r1.x(), r1.y(), sign * r13}, v[2] / lambda, {r2.x(), r2.y(), sign * r23}, v[5] / lambda, given_sx);
  }
  return solutions;
}

std::optional<Vector2d> search_centre(std::span<const PointPair> points, const Sensor& sensor, bool coplanar) {
  Eigen::NumericalDiff<CentreResidual, Eigen::Central> residual(CentreResidual{points, sensor, coplanar}, 1e-8);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<CentreResidual, Eigen::Central>> solver(residual);
  solver.parameters.maxfev = 200;
  solver.parameters.xtol = 1e-7;
  VectorXd centre(2);
  centre << sensor.cx_px, sensor.cy_px;
  const auto status = solver.minimize(centre);
  if (status <= 0 || !centre.allFinite()) return std::nullopt;
  if (centre[0] < 0 || centre[1] < 0 || centre[0] > sensor.width_px - 1 || centre[1] > sensor.height_px - 1) {
    return std::nullopt;
  }
  return Vector2d(centre);
}

PointCalibration calibrate_points(std::span<const PointPair> points, const Sensor& sensor, PointMethod method,
                                  const PointOptions& options) {
  check_finite(points);
  PointCalibration result;
  for (const PointPair& point : points) result.pixels.push_back(point.pixel);
  if (!(sensor.dx_mm > 0 && sensor.dy_mm > 0) || sensor.width_px < 2 || sensor.height_px < 2 ||
      !(sensor.sx.value_or(1) > 0)) {
    throw CalibrationError("a sensor needs a width and height, and positive pitches and sx");
  }
  check_count(points.size(), 6, "any method");
  const Frame frame = frame_of(points);
  if (!(frame.extent_mm[0] > 0)) throw CalibrationError("all points are the same point");
  if (!(frame.extent_mm[1] > kThin * frame.extent_mm[0])) {
    throw CalibrationError("the points lie on one line: they do not determine a camera");
  }
  result.method = method;
  result.coplanar = !(frame.extent_mm[2] > kFlat * frame.extent_mm[0]);
  result.camera.name = "camera";
  result.camera.width_px = sensor.width_px;
  result.camera.height_px = sensor.height_px;

  if (method == PointMethod::dlt) {
    const Eigen::Matrix<double, 3, 4> m = direct_linear_transform(points);
    const PhysicalCamera physical = physical_camera(m);
    TsaiIntrinsics tsai{.f_mm = physical.fy_px * sensor.dy_mm, .dx_mm = sensor.dx_mm, .dy_mm = sensor.dy_mm};
    tsai.sx = physical.fx_px * sensor.dx_mm / tsai.f_mm;
    tsai.cx_px = physical.cx_px;
    tsai.cy_px = physical.cy_px;
    double sum = 0;
    for (const PointPair& point : points) {
      sum += ((m * point.world_mm.homogeneous()).hnormalized() - point.pixel).squaredNorm();
    }
    result.matrix_rms_px = std::sqrt(sum / static_cast<double>(points.size()));
    result.camera.model = CameraModel(tsai);
    result.camera.world_to_camera = physical.world_to_camera;
    JointProblem problem = problem_of(points, tsai, physical.world_to_camera);
    using P = CameraParameters;
    problem.cameras[0].free[P::f] = problem.cameras[0].free[P::scale] = problem.cameras[0].free[P::cx] =
        problem.cameras[0].free[P::cy] = true;
    const JointCovariance sd = covariance(problem);
    result.parameters = list_parameters(problem, sd, true);
    result.parameters.push_back({"skew_px", physical.skew_px, 0, false});
    result.parameters.push_back({"matrix_rms_px", *result.matrix_rms_px, 0, false});
    result.tz_over_f = physical.world_to_camera.translation_mm.z() / tsai.f_mm;
    result.errors = evaluate(result.camera, points);
    warn_sensor(result, sensor, points);
    warn_outliers(result);
    return result;
  }

  check_count(points.size(), result.coplanar ? 6 : 8, result.coplanar ? "one plane" : "Tsai's method");
  Sensor used = sensor;
  const auto attempt = [&](const Sensor& from) {
    const Start start = linear_start(points, from, result.coplanar);
    JointProblem problem = problem_of(points, start.intrinsics, start.world_to_camera);
    const JointReport report = three_parameters(problem);
    return std::pair(std::move(problem), report);
  };
  std::optional<std::pair<JointProblem, JointReport>> tsai;
  std::string failure;
  const bool search =
      options.centre == CentreSearch::searched || (options.centre == CentreSearch::automatic && !result.coplanar);
  if (options.centre != CentreSearch::searched) {
    try {
      tsai = attempt(sensor);
    } catch (const CalibrationError& error) {
      failure = error.what();
    }
  }
  if (search) {
    if (const auto centre = search_centre(points, sensor, result.coplanar)) {
      used.cx_px = centre->x();
      used.cy_px = centre->y();
      try {
        auto searched = attempt(used);
        if (!tsai || searched.second.rms_px < tsai->second.rms_px) {
          tsai = std::move(searched);
          result.centre_searched = true;
        }
      } catch (const CalibrationError& error) {
        if (failure.empty()) failure = error.what();
      }
    } else if (!tsai && failure.empty()) {
      failure = "the search for the image centre leaves the sensor; give a centre";
    }
  }
  if (!tsai) throw CalibrationError(failure);
  JointProblem problem = std::move(tsai->first);
  result.iterations = tsai->second.iterations;

  if (result.coplanar && !(relative_sd_of_f(problem) < kFocalUnknown)) throw CalibrationError(kParallel);

  bool pose_free = false;
  if (method == PointMethod::full) {
    pose_free = true;
    const FreeParameters free = full_parameters(result.coplanar, options);
    const auto unknowns = static_cast<std::size_t>(std::ranges::count(free, true)) + 6;
    check_count(2 * points.size(), unknowns + 2, "coordinates are given, and these parameters");
    problem.cameras[0].free = free;
    // First pass: without the points near the centre, whose radial direction is all noise (6.5).
    JointProblem outer = problem;
    JointObservation& observation = outer.observations[0];
    const auto centre = std::get<TsaiIntrinsics>(problem.cameras[0].intrinsics);
    double farthest = 0;
    for (const PointPair& point : points) {
      farthest = std::max(farthest, (point.pixel - Vector2d(centre.cx_px, centre.cy_px)).norm());
    }
    observation.points_mm.clear();
    observation.pixels.clear();
    for (const PointPair& point : points) {
      if ((point.pixel - Vector2d(centre.cx_px, centre.cy_px)).norm() < options.near_centre * farthest) continue;
      observation.points_mm.push_back(point.world_mm);
      observation.pixels.push_back(point.pixel);
    }
    if (2 * observation.points_mm.size() >= unknowns + 2) {
      try {
        result.iterations += optimise(outer).iterations;
      } catch (const CalibrationError&) {
        outer = problem;  // the points left do not hold it; the second pass starts from Tsai's solution
      }
      problem.cameras[0].intrinsics = outer.cameras[0].intrinsics;
      problem.views[0] = outer.views[0];
    }
    const JointReport report = optimise(problem, {.max_iterations = 500});
    result.iterations += report.iterations;
    if (!report.converged) {
      result.warnings.push_back("not_converged: the optimisation stopped after 500 steps; see the deviations");
    }
    if (result.coplanar && !(relative_sd_of_f(problem) < kFocalUnknown)) throw CalibrationError(kParallel);
  }

  result.camera.model = CameraModel(problem.cameras[0].intrinsics);
  result.camera.world_to_camera = problem.views[0].target_to_rig;
  if (!pose_free) problem.views[0].free = {false, false, false, false, false, true};
  const JointCovariance sd = covariance(problem);
  result.parameters = list_parameters(problem, sd, pose_free);
  for (Parameter& parameter : result.parameters) {
    if (parameter.name == "tz_mm") parameter.free = true;
  }
  const auto& tsai_camera = std::get<TsaiIntrinsics>(result.camera.model.intrinsics());
  const double f = tsai_camera.f_mm, tz = result.camera.world_to_camera.translation_mm.z();
  result.tz_over_f = tz / f;
  const double f_variance = sd.cameras[0](CameraParameters::f, CameraParameters::f), tz_variance = sd.views[0](5, 5);
  result.tz_over_f_sd = std::sqrt(
      std::max(0.0, tz_variance / (f * f) + f_variance * tz * tz / std::pow(f, 4) - 2 * sd.f_tz * tz / std::pow(f, 3)));
  result.errors = evaluate(result.camera, points);
  warn_sensor(result, sensor, points);
  warn_outliers(result);
  if (std::sqrt(f_variance) > 0.02 * f) {
    result.warnings.push_back(
        fmt::format("flat_valley: f = {:.3f} ± {:.3f} mm and Tz are known together only; Tz/f = {:.4f} ± {:.4f}", f,
                    std::sqrt(f_variance), result.tz_over_f, result.tz_over_f_sd));
  }
  if (result.coplanar) {
    const Vector3d camera = frame.world_to_frame * result.camera.world_to_camera.centre();
    result.warnings.push_back(fmt::format(
        "one_plane: sx = {:g} is taken as given, and one plane cannot show a mirrored order of its points; by these "
        "points the camera stands {:.0f} mm away on the {} side of the plane",
        tsai_camera.sx, std::abs(camera.z()),
        (frame.world_to_frame.rotation.transpose() * Vector3d(0, 0, camera.z())).z() > 0 ? "+z" : "-z"));
  }
  return result;
}

}  // namespace horopter::calib
