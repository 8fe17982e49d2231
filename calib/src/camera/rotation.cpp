// SPDX-License-Identifier: Apache-2.0
#include "camera/rotation.hpp"

#include <cmath>

namespace horopter::calib::detail {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

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

}  // namespace horopter::calib::detail
