// SPDX-License-Identifier: Apache-2.0
// Standard deviations at a solution of the joint optimisation.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "camera/rotation.hpp"
#include "horopter/calib/joint.hpp"

namespace horopter::calib {

using detail::right_jacobian;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
constexpr int kCamera = CameraParameters::kCount;
constexpr double kUndetermined = std::numeric_limits<double>::infinity();

namespace {

/// Inverse of a positive semi-definite matrix, after scaling its diagonal to 1. Eigenvalues of at most 1e-13 count as
/// 0; variances in their directions become infinite, and `determined` false.
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
    if (unknown[i] > 1e-6 || scale[i] == 0) result(i, i) = kUndetermined;
  }
  return result;
}

/// Where the parameters that all views share stand in the normal equations; −1: not free.
struct SharedColumns {
  std::vector<std::array<int, kCamera>> camera;
  std::vector<int> rig;  ///< the first of six
  int count = 0;

  explicit SharedColumns(const JointProblem& problem) {
    const std::size_t cameras = problem.cameras.size();
    std::vector<bool> seen(cameras, false);
    for (const JointObservation& observation : problem.observations) {
      if (observation.used) seen[static_cast<std::size_t>(observation.camera)] = true;
    }
    camera.resize(cameras);
    rig.assign(cameras, -1);
    for (std::size_t c = 0; c < cameras; ++c) {
      for (std::size_t i = 0; i < kCamera; ++i) camera[c][i] = problem.cameras[c].free[i] && seen[c] ? count++ : -1;
      if (c == 0 || !seen[c]) continue;
      rig[c] = count;
      count += 6;
    }
  }
};

/// The normal equations at a solution: [a b; bᵀ d], where a belongs to the shared parameters and d, in blocks, to the
/// views.
struct NormalEquations {
  MatrixXd a;
  std::vector<MatrixXd> b;
  std::vector<Matrix6> d;
  double squares = 0;  ///< of the residuals, px²
  int rows = 0;

  NormalEquations(const JointProblem& problem, const SharedColumns& columns)
      : a(MatrixXd::Zero(columns.count, columns.count)),
        b(problem.views.size(), MatrixXd::Zero(columns.count, 6)),
        d(problem.views.size(), Matrix6::Zero()) {
    for (const JointObservation& observation : problem.observations) {
      if (observation.used) add(problem, columns, observation);
    }
  }

 private:
  void add(const JointProblem& problem, const SharedColumns& columns, const JointObservation& observation) {
    const auto c = static_cast<std::size_t>(observation.camera), v = static_cast<std::size_t>(observation.view);
    const JointCamera& camera = problem.cameras[c];
    const JointView& view = problem.views[v];
    const auto parameters = CameraParameters::from(camera.intrinsics);
    const Vector6 rig_vector = pose_vector(camera.rig_to_camera), view_vector = pose_vector(view.target_to_rig);
    const Matrix3d rig_inverse =
        right_jacobian(rig_vector.head<3>()).inverse() * camera.rig_to_camera.rotation.transpose();
    const Matrix3d view_inverse =
        right_jacobian(view_vector.head<3>()).inverse() * view.target_to_rig.rotation.transpose();
    for (std::size_t i = 0; i < observation.points_mm.size(); ++i) {
      Prediction prediction;
      if (!predict(camera.intrinsics, parameters, rig_vector, view_vector, observation.points_mm[i],
                   observation.pixels[i], prediction)) {
        continue;
      }
      squares += (observation.pixels[i] - prediction.pixel).squaredNorm();
      rows += 2;
      // From rotation vectors to small rotations about the axes of the camera or rig.
      prediction.by_rig_to_camera.leftCols<3>() *= rig_inverse;
      prediction.by_view.leftCols<3>() *= view_inverse;
      for (int p = 0; p < 6; ++p) {
        if (!view.free[static_cast<std::size_t>(p)]) prediction.by_view.col(p).setZero();
      }
      const MatrixXd by_shared = shared_derivatives(prediction, columns, c);
      a.noalias() += by_shared.transpose() * by_shared;
      b[v].noalias() += by_shared.transpose() * prediction.by_view;
      d[v].noalias() += prediction.by_view.transpose() * prediction.by_view;
    }
  }

  static MatrixXd shared_derivatives(const Prediction& prediction, const SharedColumns& columns, std::size_t c) {
    MatrixXd by_shared = MatrixXd::Zero(2, columns.count);
    for (int p = 0; p < kCamera; ++p) {
      const int column = columns.camera[c][static_cast<std::size_t>(p)];
      if (column >= 0) by_shared.col(column) = prediction.by_camera.col(p);
    }
    if (columns.rig[c] >= 0) by_shared.middleCols<6>(columns.rig[c]) = prediction.by_rig_to_camera;
    return by_shared;
  }
};

/// Solves the views' blocks for the shared ones: the Schur complement is left in `equations.a`. Returns the inverses of
/// the blocks, empty for views that are not observed or held, and counts the free parameters of the others.
std::vector<MatrixXd> eliminate_views(const JointProblem& problem, NormalEquations& equations, int& unknowns,
                                      bool& determined) {
  std::vector<MatrixXd> inverses(problem.views.size());
  for (std::size_t v = 0; v < problem.views.size(); ++v) {
    Matrix6& d = equations.d[v];
    if (d.isZero(0)) continue;
    for (int p = 0; p < 6; ++p) {
      if (problem.views[v].free[static_cast<std::size_t>(p)]) {
        ++unknowns;
      } else {
        d(p, p) = 1;  // a held parameter: its row and column are 0 otherwise
      }
    }
    inverses[v] = inverse_psd(d, determined);
    equations.a.noalias() -= equations.b[v] * inverses[v] * equations.b[v].transpose();
  }
  return inverses;
}

Eigen::Matrix<double, kCamera, kCamera> camera_covariance(const MatrixXd& shared, const std::array<int, kCamera>& at) {
  Eigen::Matrix<double, kCamera, kCamera> camera = Eigen::Matrix<double, kCamera, kCamera>::Zero();
  for (int i = 0; i < kCamera; ++i) {
    for (int j = 0; j < kCamera; ++j) {
      const int row = at[static_cast<std::size_t>(i)], column = at[static_cast<std::size_t>(j)];
      if (row >= 0 && column >= 0) camera(i, j) = shared(row, column);
    }
  }
  return camera;
}

/// `gain` leads from the shared parameters to those of the view.
Matrix6 view_covariance(const FreePose& free, const MatrixXd& inverse, const MatrixXd& gain, const MatrixXd& shared,
                        double variance) {
  Matrix6 view = inverse * variance;
  if (shared.rows() > 0) view += gain * shared * gain.transpose();
  for (int p = 0; p < 6; ++p) {
    if (!free[static_cast<std::size_t>(p)]) {
      view.row(p).setZero();
      view.col(p).setZero();
    }
    if (std::isnan(view(p, p))) view(p, p) = kUndetermined;  // depends on something that is not determined
  }
  return view;
}

}  // namespace

JointCovariance covariance(const JointProblem& problem, double sigma_px, double least_sigma_px) {
  const SharedColumns columns(problem);
  NormalEquations equations(problem, columns);
  JointCovariance result;
  int unknowns = columns.count;
  const std::vector<MatrixXd> inverses = eliminate_views(problem, equations, unknowns, result.determined);
  result.degrees_of_freedom = equations.rows - unknowns;
  result.sigma_px =
      result.degrees_of_freedom > 0 ? std::sqrt(equations.squares / result.degrees_of_freedom) : kUndetermined;
  if (sigma_px > 0) result.sigma_px = sigma_px;
  result.sigma_px = std::max(result.sigma_px, least_sigma_px);
  const double variance = result.sigma_px * result.sigma_px;
  // The Schur complement is a difference: a diagonal that vanished by rounding is 0.
  const MatrixXd shared = inverse_psd(0.5 * (equations.a + equations.a.transpose()), result.determined) * variance;
  for (std::size_t c = 0; c < problem.cameras.size(); ++c) {
    result.cameras.push_back(camera_covariance(shared, columns.camera[c]));
    Matrix6& rig = result.rig_to_camera.emplace_back(Matrix6::Zero());
    if (columns.rig[c] >= 0) rig = shared.block<6, 6>(columns.rig[c], columns.rig[c]);
  }
  for (std::size_t v = 0; v < problem.views.size(); ++v) {
    Matrix6& view = result.views.emplace_back(Matrix6::Zero());
    if (inverses[v].size() == 0) continue;
    const MatrixXd gain = inverses[v] * equations.b[v].transpose();
    view = view_covariance(problem.views[v].free, inverses[v], gain, shared, variance);
    const int f_column = problem.cameras.empty() ? -1 : columns.camera[0][CameraParameters::f];
    if (v == 0 && f_column >= 0) result.f_tz = -(gain * shared.col(f_column))[5];
  }
  return result;
}

}  // namespace horopter::calib
