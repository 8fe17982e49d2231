// SPDX-License-Identifier: Apache-2.0
// The linear steps of Tsai's method (thesis 6.5): the pose from the radial alignment constraint, f and tz, and the
// image centre by which the constraint fits best.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "camera/point_steps.hpp"
#include "horopter/calib/error.hpp"

namespace horopter::calib {

using namespace detail;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Sensor coordinates x'_d, y_d of 6.17, mm. x is not yet divided by sx.
Vector2d on_sensor(const PointPair& point, const Sensor& sensor) {
  return {(point.pixel.x() - sensor.cx_px) * sensor.dx_mm, (point.pixel.y() - sensor.cy_px) * sensor.dy_mm};
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

LinearCamera detail::linear_camera(std::span<const PointPair> points, const Sensor& sensor, bool coplanar) {
  std::optional<LinearCamera> best;
  double best_error = std::numeric_limits<double>::infinity();
  bool behind = false;
  for (const RadialAlignment& alignment : radial_alignment(points, sensor, coplanar)) {
    const FocalLength focal = focal_length(points, sensor, alignment);
    LinearCamera start{.intrinsics = {.f_mm = focal.f_mm,
                                      .dx_mm = sensor.dx_mm,
                                      .dy_mm = sensor.dy_mm,
                                      .sx = alignment.sx,
                                      .cx_px = sensor.cx_px,
                                      .cy_px = sensor.cy_px},
                       .world_to_camera = alignment.world_to_camera};
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

}  // namespace horopter::calib
