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

#include "camera/rotation.hpp"
#include "horopter/calib/error.hpp"

namespace horopter::calib {
namespace {

using detail::cross_matrix;
using detail::right_jacobian;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
constexpr int kCamera = CameraParameters::kCount;

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

namespace {

/// Throws CalibrationError when a start puts a point behind its camera or beyond the lens's limit.
void check_start(const JointProblem& joint) {
  const auto start = residuals_px(joint);
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (joint.observations[i].used && !std::ranges::all_of(start[i], [](const Vector2d& r) { return r.allFinite(); })) {
      throw CalibrationError(
          "the cameras to start from do not see all the points: some lie behind a camera or beyond "
          "the limit of its lens model");
    }
  }
}

/// The parameters as the solver moves them.
struct Blocks {
  std::vector<CameraParameters::Vector> cameras;
  std::vector<Vector6> rigs, views;

  explicit Blocks(const JointProblem& joint) {
    for (const JointCamera& camera : joint.cameras) {
      cameras.push_back(CameraParameters::from(camera.intrinsics));
      rigs.push_back(pose_vector(camera.rig_to_camera));
    }
    for (const JointView& view : joint.views) views.push_back(pose_vector(view.target_to_rig));
  }

  void store(JointProblem& joint) const {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      joint.cameras[i].intrinsics = CameraParameters::to(cameras[i], joint.cameras[i].intrinsics);
      joint.cameras[i].rig_to_camera = pose_from_vector(rigs[i]);
    }
    for (std::size_t i = 0; i < views.size(); ++i) joint.views[i].target_to_rig = pose_from_vector(views[i]);
  }
};

/// Adds a residual for every point of the observations used, and holds what is not free.
void build(ceres::Problem& problem, const JointProblem& joint, Blocks& blocks, ceres::LossFunction* loss) {
  for (const JointObservation& observation : joint.observations) {
    if (!observation.used) continue;
    const auto c = static_cast<std::size_t>(observation.camera);
    std::vector<double*> parameters{blocks.cameras[c].data(),
                                    blocks.views[static_cast<std::size_t>(observation.view)].data()};
    if (c > 0) parameters.push_back(blocks.rigs[c].data());
    for (std::size_t i = 0; i < observation.points_mm.size(); ++i) {
      problem.AddResidualBlock(
          new PointCost(joint.cameras[c].intrinsics, observation.points_mm[i], observation.pixels[i], c > 0), loss,
          parameters);
    }
  }
  for (std::size_t i = 0; i < blocks.cameras.size(); ++i) {
    hold(problem, blocks.cameras[i].data(), joint.cameras[i].free);
  }
  for (std::size_t i = 0; i < blocks.views.size(); ++i) hold(problem, blocks.views[i].data(), joint.views[i].free);
}

/// The poses of the views are eliminated first, then the cameras solved.
std::shared_ptr<ceres::ParameterBlockOrdering> views_first(const ceres::Problem& problem, Blocks& blocks) {
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  const auto add = [&](double* block, int group) {
    if (problem.HasParameterBlock(block)) ordering->AddElementToGroup(block, group);
  };
  for (Vector6& view : blocks.views) add(view.data(), 0);
  for (std::size_t i = 0; i < blocks.cameras.size(); ++i) {
    add(blocks.cameras[i].data(), 1);
    add(blocks.rigs[i].data(), 1);
  }
  return ordering;
}

ceres::Solver::Options solver_options(const ceres::Problem& problem, Blocks& blocks, int max_iterations) {
  ceres::Solver::Options solver;
  solver.max_num_iterations = max_iterations;
  solver.function_tolerance = 1e-13;
  solver.gradient_tolerance = 1e-13;
  solver.parameter_tolerance = 1e-12;
  solver.logging_type = ceres::SILENT;
  solver.num_threads = 1;  // the same digits every time
  solver.initial_trust_region_radius = 1e3;
  // One plane leaves a flat valley: its condition number must not be squared.
  const bool one_view = blocks.views.size() == 1;
  solver.linear_solver_type = one_view ? ceres::DENSE_QR : ceres::DENSE_SCHUR;
  if (!one_view) solver.linear_solver_ordering = views_first(problem, blocks);
  return solver;
}

/// Root of the mean squared distance over the observations used.
double rms_used(const JointProblem& joint) {
  double sum = 0;
  std::size_t points = 0;
  const auto residuals = residuals_px(joint);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!joint.observations[i].used) continue;
    for (const Vector2d& residual : residuals[i]) sum += residual.squaredNorm();
    points += residuals[i].size();
  }
  return std::sqrt(sum / static_cast<double>(points));
}

}  // namespace

JointReport optimise(JointProblem& joint, const JointOptions& options) {
  check_start(joint);
  const std::unique_ptr<ceres::LossFunction> loss(options.huber_px > 0 ? new ceres::HuberLoss(options.huber_px)
                                                                       : nullptr);
  ceres::Problem::Options problem_options;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problem_options);
  Blocks blocks(joint);
  build(problem, joint, blocks, loss.get());
  if (problem.NumResidualBlocks() == 0) throw CalibrationError("no measured points");
  ceres::Solver::Summary summary;
  const QuietCeres quiet;
  ceres::Solve(solver_options(problem, blocks, options.max_iterations), &problem, &summary);
  if (summary.termination_type == ceres::FAILURE) {
    throw CalibrationError("the optimisation cannot go on: " + summary.message);
  }
  blocks.store(joint);
  return {.converged = summary.termination_type == ceres::CONVERGENCE,
          .iterations = static_cast<int>(summary.iterations.size()),
          .rms_px = rms_used(joint),
          .message = summary.message};
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

}  // namespace horopter::calib
