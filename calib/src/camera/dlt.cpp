// SPDX-License-Identifier: Apache-2.0
// The linear method (thesis 6.4.1): the 3×4 matrix of a pinhole camera, and the physical parameters in it.
#include <Eigen/Dense>
#include <cmath>

#include "camera/point_steps.hpp"
#include "horopter/calib/error.hpp"

namespace horopter::calib {

using namespace detail;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

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

}  // namespace horopter::calib
