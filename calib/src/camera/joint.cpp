// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/joint.hpp"

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "horopter/calib/error.hpp"

namespace horopter::calib {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector6 = Eigen::Matrix<double, 6, 1>;
constexpr int kCamera = CameraParameters::kCount;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// exp(ω + δ) ≈ exp(ω)·exp(J δ)
Matrix3d right_jacobian(const Vector3d& omega) {
  const double angle2 = omega.squaredNorm();
  const double angle = std::sqrt(angle2);
  const Matrix3d k = cross_matrix(omega);
  double a = 0.5, b = 1.0 / 6;
  if (angle > 1e-4) {
    a = (1 - std::cos(angle)) / angle2;
    b = (angle - std::sin(angle)) / (angle2 * angle);
  }
  return Matrix3d::Identity() - a * k + b * k * k;
}

LensCoefficients lens_of(const CameraParameters::Vector& camera) {
  std::array<double, LensCoefficients::kCount> values;
  for (int i = 0; i < LensCoefficients::kCount; ++i) values[i] = camera[CameraParameters::lens + i];
  return LensCoefficients::from(values);
}

class PointCost : public ceres::CostFunction {
 public:
  PointCost(const Intrinsics& like, const Vector3d& point, const Vector2d& pixel, bool has_rig)
      : like_(like), point_(point), pixel_(pixel), has_rig_(has_rig) {
    set_num_residuals(2);
    mutable_parameter_block_sizes()->push_back(kCamera);
    mutable_parameter_block_sizes()->push_back(6);
    if (has_rig) mutable_parameter_block_sizes()->push_back(6);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::Map<const CameraParameters::Vector> camera(parameters[0]);
    const Eigen::Map<const Vector6> view(parameters[1]);
    const Vector6 rig = has_rig_ ? Vector6(Eigen::Map<const Vector6>(parameters[2])) : Vector6(Vector6::Zero());
    Prediction prediction;
    if (!predict(like_, camera, rig, view, point_, pixel_, prediction)) return false;
    Eigen::Map<Vector2d>(residuals, 2) = prediction.pixel - pixel_;
    if (jacobians == nullptr) return true;
    using RowMajor6 = Eigen::Matrix<double, 2, 6, Eigen::RowMajor>;
    using RowMajorCamera = Eigen::Matrix<double, 2, kCamera, Eigen::RowMajor>;
    if (jacobians[0] != nullptr) Eigen::Map<RowMajorCamera>(jacobians[0], 2, kCamera) = prediction.by_camera;
    if (jacobians[1] != nullptr) Eigen::Map<RowMajor6>(jacobians[1], 2, 6) = prediction.by_view;
    if (has_rig_ && jacobians[2] != nullptr) Eigen::Map<RowMajor6>(jacobians[2], 2, 6) = prediction.by_rig_to_camera;
    return true;
  }

 private:
  const Intrinsics& like_;
  Vector3d point_;
  Vector2d pixel_;
  bool has_rig_;
};

/// While it lives, Ceres does not write to standard error: what it would say is in its summary.
class QuietCeres {
 public:
  QuietCeres() { FLAGS_minloglevel = google::GLOG_FATAL; }
  ~QuietCeres() { FLAGS_minloglevel = before_; }
  QuietCeres(const QuietCeres&) = delete;
  QuietCeres& operator=(const QuietCeres&) = delete;

 private:
  int before_ = FLAGS_minloglevel;
};

/// Holds what is not free.
template <std::size_t N>
void hold(ceres::Problem& problem, double* block, const std::array<bool, N>& free) {
  if (!problem.HasParameterBlock(block)) return;
  std::vector<int> held;
  for (std::size_t i = 0; i < N; ++i) {
    if (!free[i]) held.push_back(static_cast<int>(i));
  }
  if (held.size() == N) {
    problem.SetParameterBlockConstant(block);
  } else if (!held.empty()) {
    problem.SetManifold(block, new ceres::SubsetManifold(static_cast<int>(N), held));
  }
}

}  // namespace

Vector6 pose_vector(const Pose& pose) {
  Vector6 vector;
  vector << rotation_to_vector(pose.rotation), pose.translation_mm;
  return vector;
}

Pose pose_from_vector(const Vector6& vector) { return {rotation_from_vector(vector.head<3>()), vector.tail<3>()}; }

CameraParameters::Vector CameraParameters::from(const Intrinsics& intrinsics) {
  Vector vector;
  LensCoefficients coefficients;
  if (const auto* tsai = std::get_if<TsaiIntrinsics>(&intrinsics)) {
    vector.head<4>() << tsai->f_mm, tsai->sx, tsai->cx_px, tsai->cy_px;
    coefficients = tsai->lens();
  } else {
    const auto& brown = std::get<BrownConradyIntrinsics>(intrinsics);
    vector.head<4>() << brown.fy_px, brown.fx_px / brown.fy_px, brown.cx_px, brown.cy_px;
    coefficients = brown.lens;
  }
  const auto values = coefficients.array();
  for (int i = 0; i < LensCoefficients::kCount; ++i) vector[lens + i] = values[static_cast<std::size_t>(i)];
  return vector;
}

Intrinsics CameraParameters::to(const Vector& vector, const Intrinsics& like) {
  const LensCoefficients c = lens_of(vector);
  if (const auto* tsai = std::get_if<TsaiIntrinsics>(&like)) {
    return TsaiIntrinsics{vector[f], tsai->dx_mm, tsai->dy_mm, vector[scale], vector[cx], vector[cy], c.k1,
                          c.k2,      c.k3,        c.p2,        c.p1,          c.s1,       c.s3};
  }
  return BrownConradyIntrinsics{vector[f] * vector[scale], vector[f], vector[cx], vector[cy], c};
}

bool predict(const Intrinsics& like, const CameraParameters::Vector& camera, const Vector6& rig, const Vector6& view,
             const Vector3d& point, const Vector2d& near, Prediction& out) {
  const Matrix3d view_rotation = rotation_from_vector(view.head<3>());
  const Matrix3d rig_rotation = rotation_from_vector(rig.head<3>());
  const Vector3d in_rig = view_rotation * point + view.tail<3>();
  const Vector3d in_camera = rig_rotation * in_rig + rig.tail<3>();
  const double z = in_camera.z();
  if (!(z > 1e-9 * in_camera.norm())) return false;
  const Vector2d direction = in_camera.head<2>() / z;

  const double f = camera[CameraParameters::f], scale = camera[CameraParameters::scale];
  if (!(f > 0 && scale > 0)) return false;
  const LensCoefficients lens = lens_of(camera);
  Matrix2d by_direction;
  out.by_camera.setZero();
  Eigen::Matrix<double, 2, LensCoefficients::kCount> by_coefficients;
  Vector2d unit;  // pixels per unit of the lens map's plane
  Vector2d plane;
  if (const auto* tsai = std::get_if<TsaiIntrinsics>(&like)) {
    unit = {scale / tsai->dx_mm, 1 / tsai->dy_mm};
    const Vector2d centre(camera[CameraParameters::cx], camera[CameraParameters::cy]);
    const auto distorted = lens_inverse_near(lens, f * direction, (near - centre).cwiseQuotient(unit));
    if (!distorted) return false;
    plane = *distorted;
    Matrix2d jacobian;
    lens_forward(lens, plane, &jacobian, &by_coefficients);
    const Matrix2d inverse = jacobian.inverse();
    by_coefficients = -(inverse * by_coefficients).eval();
    by_direction = f * inverse;
    out.by_camera.col(CameraParameters::f) = unit.asDiagonal() * inverse * direction;
    out.by_camera(0, CameraParameters::scale) = plane.x() / tsai->dx_mm;
  } else {
    unit = {f * scale, f};
    plane = lens_forward(lens, direction, &by_direction, &by_coefficients);
    if (!(by_direction.determinant() > 0)) return false;  // the map has turned back
    out.by_camera.col(CameraParameters::f) = Vector2d(scale * plane.x(), plane.y());
    out.by_camera(0, CameraParameters::scale) = f * plane.x();
  }
  out.pixel = plane.cwiseProduct(unit) + Vector2d(camera[CameraParameters::cx], camera[CameraParameters::cy]);
  out.by_camera(0, CameraParameters::cx) = 1;
  out.by_camera(1, CameraParameters::cy) = 1;
  out.by_camera.rightCols<LensCoefficients::kCount>() = unit.asDiagonal() * by_coefficients;

  Eigen::Matrix<double, 2, 3> by_point;
  by_point << 1 / z, 0, -direction.x() / z, 0, 1 / z, -direction.y() / z;
  by_point = (unit.asDiagonal() * by_direction * by_point).eval();
  out.by_rig_to_camera.leftCols<3>() = -by_point * rig_rotation * cross_matrix(in_rig) * right_jacobian(rig.head<3>());
  out.by_rig_to_camera.rightCols<3>() = by_point;
  const Eigen::Matrix<double, 2, 3> by_rig_point = by_point * rig_rotation;
  out.by_view.leftCols<3>() = -by_rig_point * view_rotation * cross_matrix(point) * right_jacobian(view.head<3>());
  out.by_view.rightCols<3>() = by_rig_point;
  return out.pixel.allFinite();
}

JointReport optimise(JointProblem& joint, const JointOptions& options) {
  const auto start = residuals_px(joint);
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (joint.observations[i].used && !std::ranges::all_of(start[i], [](const Vector2d& r) { return r.allFinite(); })) {
      throw CalibrationError(
          "the cameras to start from do not see all the points: some lie behind a camera or beyond "
          "the limit of its lens model");
    }
  }
  std::vector<CameraParameters::Vector> cameras;
  std::vector<Vector6> rigs, views;
  for (const JointCamera& camera : joint.cameras) {
    cameras.push_back(CameraParameters::from(camera.intrinsics));
    rigs.push_back(pose_vector(camera.rig_to_camera));
  }
  for (const JointView& view : joint.views) views.push_back(pose_vector(view.target_to_rig));

  const std::unique_ptr<ceres::LossFunction> loss(options.huber_px > 0 ? new ceres::HuberLoss(options.huber_px)
                                                                       : nullptr);
  ceres::Problem::Options problem_options;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problem_options);
  int points = 0;
  for (const JointObservation& observation : joint.observations) {
    if (!observation.used) continue;
    const auto camera = static_cast<std::size_t>(observation.camera);
    const auto view = static_cast<std::size_t>(observation.view);
    for (std::size_t i = 0; i < observation.points_mm.size(); ++i) {
      std::vector<double*> blocks{cameras[camera].data(), views[view].data()};
      if (camera > 0) blocks.push_back(rigs[camera].data());
      problem.AddResidualBlock(
          new PointCost(joint.cameras[camera].intrinsics, observation.points_mm[i], observation.pixels[i], camera > 0),
          loss.get(), blocks);
      ++points;
    }
  }
  if (points == 0) throw CalibrationError("no measured points");
  for (std::size_t i = 0; i < cameras.size(); ++i) hold(problem, cameras[i].data(), joint.cameras[i].free);
  for (std::size_t i = 0; i < views.size(); ++i) hold(problem, views[i].data(), joint.views[i].free);

  ceres::Solver::Options solver;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = 1e-13;
  solver.gradient_tolerance = 1e-13;
  solver.parameter_tolerance = 1e-12;
  solver.logging_type = ceres::SILENT;
  solver.num_threads = 1;  // the same digits every time
  solver.initial_trust_region_radius = 1e3;
  if (joint.views.size() == 1) {
    solver.linear_solver_type = ceres::DENSE_QR;  // one plane leaves a flat valley: no squared condition number
  } else {
    solver.linear_solver_type = ceres::DENSE_SCHUR;
    auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    for (Vector6& view : views) {
      if (problem.HasParameterBlock(view.data())) ordering->AddElementToGroup(view.data(), 0);
    }
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      if (problem.HasParameterBlock(cameras[i].data())) ordering->AddElementToGroup(cameras[i].data(), 1);
      if (problem.HasParameterBlock(rigs[i].data())) ordering->AddElementToGroup(rigs[i].data(), 1);
    }
    solver.linear_solver_ordering = ordering;
  }
  ceres::Solver::Summary summary;
  const QuietCeres quiet;
  ceres::Solve(solver, &problem, &summary);
  if (summary.termination_type == ceres::FAILURE) {
    throw CalibrationError("the optimisation cannot go on: " + summary.message);
  }

  for (std::size_t i = 0; i < cameras.size(); ++i) {
    joint.cameras[i].intrinsics = CameraParameters::to(cameras[i], joint.cameras[i].intrinsics);
    joint.cameras[i].rig_to_camera = pose_from_vector(rigs[i]);
  }
  for (std::size_t i = 0; i < views.size(); ++i) joint.views[i].target_to_rig = pose_from_vector(views[i]);

  JointReport report;
  report.converged = summary.termination_type == ceres::CONVERGENCE;
  report.iterations = static_cast<int>(summary.iterations.size());
  report.message = summary.message;
  double sum = 0;
  const auto residuals = residuals_px(joint);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!joint.observations[i].used) continue;
    for (const Vector2d& residual : residuals[i]) sum += residual.squaredNorm();
  }
  report.rms_px = std::sqrt(sum / points);
  return report;
}

std::vector<std::vector<Vector2d>> residuals_px(const JointProblem& problem) {
  std::vector<std::vector<Vector2d>> all;
  for (const JointObservation& observation : problem.observations) {
    const JointCamera& camera = problem.cameras[static_cast<std::size_t>(observation.camera)];
    const auto parameters = CameraParameters::from(camera.intrinsics);
    const Vector6 rig = pose_vector(camera.rig_to_camera);
    const Vector6 view = pose_vector(problem.views[static_cast<std::size_t>(observation.view)].target_to_rig);
    std::vector<Vector2d>& residuals = all.emplace_back();
    for (std::size_t i = 0; i < observation.points_mm.size(); ++i) {
      Prediction prediction;
      const bool seen = predict(camera.intrinsics, parameters, rig, view, observation.points_mm[i],
                                observation.pixels[i], prediction);
      residuals.push_back(seen ? Vector2d(observation.pixels[i] - prediction.pixel)
                               : Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()));
    }
  }
  return all;
}

double rms_of(const std::vector<Vector2d>& residuals) {
  double sum = 0;
  for (const Vector2d& residual : residuals) sum += residual.squaredNorm();
  return residuals.empty() ? 0 : std::sqrt(sum / static_cast<double>(residuals.size()));
}

namespace {

/// Inverse of a positive semi-definite matrix after scaling its diagonal to 1. `floor` is what counts as 0 among the
/// eigenvalues; variances in such directions become infinite.
MatrixXd inverse_psd(const MatrixXd& matrix, bool& determined) {
  const Eigen::Index n = matrix.rows();
  if (n == 0) return matrix;
  VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    scale[i] = matrix(i, i) > 0 ? 1 / std::sqrt(matrix(i, i)) : 0;
    if (scale[i] == 0) determined = false;
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scale.asDiagonal() * matrix * scale.asDiagonal());
  VectorXd inverse = solver.eigenvalues();
  VectorXd unknown = VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (inverse[i] > 1e-13) {
      inverse[i] = 1 / inverse[i];
    } else {
      inverse[i] = 0;
      unknown += solver.eigenvectors().col(i).cwiseAbs2();
      determined = false;
    }
  }
  MatrixXd result = scale.asDiagonal() * solver.eigenvectors() * inverse.asDiagonal() *
                    solver.eigenvectors().transpose() * scale.asDiagonal();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (unknown[i] > 1e-6 || scale[i] == 0) result(i, i) = kInfinity;
  }
  return result;
}

}  // namespace

JointCovariance covariance(const JointProblem& problem, double sigma_px, double least_sigma_px) {
  const std::size_t cameras = problem.cameras.size(), views = problem.views.size();
  // Columns of the parameters that all views share; −1: not free.
  std::vector<std::array<int, kCamera>> camera_column(cameras);
  std::vector<int> rig_column(cameras, -1);
  int shared = 0;
  std::vector<bool> seen(cameras, false);
  for (const JointObservation& observation : problem.observations) {
    if (observation.used) seen[static_cast<std::size_t>(observation.camera)] = true;
  }
  for (std::size_t c = 0; c < cameras; ++c) {
    for (int i = 0; i < kCamera; ++i) {
      camera_column[c][static_cast<std::size_t>(i)] =
          problem.cameras[c].free[static_cast<std::size_t>(i)] && seen[c] ? shared++ : -1;
    }
    if (c > 0 && seen[c]) {
      rig_column[c] = shared;
      shared += 6;
    }
  }
  MatrixXd a = MatrixXd::Zero(shared, shared);
  std::vector<MatrixXd> b(views, MatrixXd::Zero(shared, 6));
  std::vector<Eigen::Matrix<double, 6, 6>> d(views, Eigen::Matrix<double, 6, 6>::Zero());
  std::vector<int> free_in_view(views, 0);
  double sum = 0;
  int rows = 0;
  for (const JointObservation& observation : problem.observations) {
    if (!observation.used) continue;
    const auto c = static_cast<std::size_t>(observation.camera), v = static_cast<std::size_t>(observation.view);
    const JointCamera& camera = problem.cameras[c];
    const auto parameters = CameraParameters::from(camera.intrinsics);
    const Vector6 rig = pose_vector(camera.rig_to_camera), view = pose_vector(problem.views[v].target_to_rig);
    const Matrix3d rig_inverse = right_jacobian(rig.head<3>()).inverse() * camera.rig_to_camera.rotation.transpose();
    const Matrix3d view_inverse =
        right_jacobian(view.head<3>()).inverse() * problem.views[v].target_to_rig.rotation.transpose();
    for (std::size_t i = 0; i < observation.points_mm.size(); ++i) {
      Prediction prediction;
      if (!predict(camera.intrinsics, parameters, rig, view, observation.points_mm[i], observation.pixels[i],
                   prediction)) {
        continue;
      }
      sum += (observation.pixels[i] - prediction.pixel).squaredNorm();
      rows += 2;
      // From rotation vectors to small rotations about the axes of the camera or rig.
      prediction.by_rig_to_camera.leftCols<3>() *= rig_inverse;
      prediction.by_view.leftCols<3>() *= view_inverse;
      MatrixXd by_shared = MatrixXd::Zero(2, shared);
      for (int p = 0; p < kCamera; ++p) {
        const int column = camera_column[c][static_cast<std::size_t>(p)];
        if (column >= 0) by_shared.col(column) = prediction.by_camera.col(p);
      }
      if (rig_column[c] >= 0) by_shared.middleCols<6>(rig_column[c]) = prediction.by_rig_to_camera;
      for (int p = 0; p < 6; ++p) {
        if (!problem.views[v].free[static_cast<std::size_t>(p)]) prediction.by_view.col(p).setZero();
      }
      a.noalias() += by_shared.transpose() * by_shared;
      b[v].noalias() += by_shared.transpose() * prediction.by_view;
      d[v].noalias() += prediction.by_view.transpose() * prediction.by_view;
    }
  }
  JointCovariance result;
  int unknowns = shared;
  std::vector<MatrixXd> d_inverse(views);
  for (std::size_t v = 0; v < views; ++v) {
    if (d[v].isZero(0)) continue;  // not observed, or held
    for (int p = 0; p < 6; ++p) {
      if (problem.views[v].free[static_cast<std::size_t>(p)]) {
        ++unknowns;
      } else {
        d[v](p, p) = 1;  // a held parameter: its row and column are 0 otherwise
      }
    }
    d_inverse[v] = inverse_psd(d[v], result.determined);
    a.noalias() -= b[v] * d_inverse[v] * b[v].transpose();
  }
  result.degrees_of_freedom = rows - unknowns;
  result.sigma_px = result.degrees_of_freedom > 0 ? std::sqrt(sum / result.degrees_of_freedom) : kInfinity;
  if (sigma_px > 0) result.sigma_px = sigma_px;
  result.sigma_px = std::max(result.sigma_px, least_sigma_px);
  const double variance = result.sigma_px * result.sigma_px;
  // The Schur complement is a difference: a diagonal that vanished by rounding is 0.
  const MatrixXd shared_covariance = inverse_psd(0.5 * (a + a.transpose()), result.determined) * variance;
  for (std::size_t c = 0; c < cameras; ++c) {
    auto& camera = result.cameras.emplace_back();
    camera.setZero();
    for (int i = 0; i < kCamera; ++i) {
      for (int j = 0; j < kCamera; ++j) {
        const int row = camera_column[c][static_cast<std::size_t>(i)];
        const int column = camera_column[c][static_cast<std::size_t>(j)];
        if (row >= 0 && column >= 0) camera(i, j) = shared_covariance(row, column);
      }
    }
    auto& rig = result.rig_to_camera.emplace_back();
    rig.setZero();
    if (rig_column[c] >= 0) rig = shared_covariance.block<6, 6>(rig_column[c], rig_column[c]);
  }
  for (std::size_t v = 0; v < views; ++v) {
    auto& view = result.views.emplace_back();
    view.setZero();
    if (d_inverse[v].size() == 0) continue;
    const MatrixXd gain = d_inverse[v] * b[v].transpose();
    view = d_inverse[v] * variance;
    if (shared > 0) view += gain * shared_covariance * gain.transpose();
    for (int p = 0; p < 6; ++p) {
      if (!problem.views[v].free[static_cast<std::size_t>(p)]) {
        view.row(p).setZero();
        view.col(p).setZero();
      }
      if (std::isnan(view(p, p))) view(p, p) = kInfinity;  // depends on something that is not determined
    }
    if (v == 0 && cameras > 0 && camera_column[0][CameraParameters::f] >= 0) {
      result.f_tz = -(gain * shared_covariance.col(camera_column[0][CameraParameters::f]))[5];
    }
  }
  return result;
}

}  // namespace horopter::calib
