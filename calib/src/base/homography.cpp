// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/homography.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace horopter::calib {

using Eigen::Matrix3d;
using Eigen::Vector2d;

std::optional<Matrix3d> normalisation(std::span<const Vector2d> points) {
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  double distance = 0;
  for (const Vector2d& p : points) distance += (p - mean).norm();
  distance /= static_cast<double>(points.size());
  if (!(distance > 1e-9)) return std::nullopt;
  const double scale = std::sqrt(2.0) / distance;
  Matrix3d matrix;
  matrix << scale, 0, -scale * mean.x(), 0, scale, -scale * mean.y(), 0, 0, 1;
  return matrix;
}

std::optional<Homography> solve_homography(std::span<const Vector2d> from, std::span<const Vector2d> to) {
  if (from.size() < 4 || from.size() != to.size()) return std::nullopt;
  const auto from_normal = normalisation(from), to_normal = normalisation(to);
  if (!from_normal || !to_normal) return std::nullopt;
  // Two equations a point. One more row, of zeros, makes the matrix of 4 points high enough for all 9 right vectors.
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(2 * from.size() + 1), 9);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Eigen::Vector3d p = *from_normal * from[i].homogeneous();
    const Eigen::Vector3d q = *to_normal * to[i].homogeneous();
    const auto row = static_cast<Eigen::Index>(2 * i);
    equations.row(row) << -p.transpose(), Eigen::RowVector3d::Zero(), q.x() * p.transpose();
    equations.row(row + 1) << Eigen::RowVector3d::Zero(), -p.transpose(), q.y() * p.transpose();
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(equations, Eigen::ComputeThinV);
  const Eigen::VectorXd solution = svd.matrixV().col(8);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> normalised(solution.data());
  return Homography{to_normal->inverse() * normalised * *from_normal,
                    svd.singularValues()[7] / svd.singularValues()[0]};
}

}  // namespace horopter::calib
