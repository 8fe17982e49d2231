// SPDX-License-Identifier: Apache-2.0
#include "camera/point_steps.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>

#include "horopter/calib/error.hpp"

namespace horopter::calib::detail {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

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

VectorXd null_vector(const MatrixXd& matrix, const char* why) {
  const VectorXd scale = matrix.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  const Eigen::JacobiSVD<MatrixXd> svd(matrix * scale.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeFullV);
  const Eigen::Index n = matrix.cols();
  if (svd.singularValues().size() >= n - 1 && !(svd.singularValues()[n - 2] > 1e-7 * svd.singularValues()[0])) {
    throw CalibrationError(why);
  }
  return scale.asDiagonal() * svd.matrixV().col(n - 1);
}

}  // namespace horopter::calib::detail
