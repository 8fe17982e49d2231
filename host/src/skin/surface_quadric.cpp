// SPDX-License-Identifier: Apache-2.0
// Ellipsoids (thesis 7.1.2).
#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "horopter/skin/surface.hpp"

namespace horopter {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class Ellipsoid : public Surface {
 public:
  Ellipsoid(const calib::Pose& pose, const Vector3d& half_axes)
      : centre_(pose.translation_mm),
        half_axes_(half_axes),
        to_sphere_(half_axes.cwiseInverse().asDiagonal() * pose.rotation.transpose()),
        sphere_to_normal_(to_sphere_.transpose()) {
    if (!pose.rotation.isUnitary(1e-6)) throw std::invalid_argument("an ellipsoid's rotation is none");
    if (!(half_axes.minCoeff() > 0) || !to_sphere_.allFinite() || !centre_.allFinite()) {
      throw std::invalid_argument("an ellipsoid has three half axes above 0");
    }
  }

  /// 7.12 with 7.14 put in, in coordinates in which the ellipsoid is the unit sphere: a t² + 2 b t + c = 0. The smaller
  /// t is the intersection that faces the camera; b < 0 < c, so it is c/(−b + √…) without cancellation.
  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    const Vector3d from = to_sphere_ * (origin - centre_);
    const double c = from.squaredNorm() - 1;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      hits[i] = {};
      const Vector3d direction = to_sphere_ * directions[i];
      const double a = direction.squaredNorm();
      const double b = from.dot(direction);
      const double discriminant = b * b - a * c;
      if (!(discriminant >= 0) || !(b < 0) || !(c > 0)) continue;
      const double distance = c / (std::sqrt(discriminant) - b);
      hits[i] = {distance, (sphere_to_normal_ * (from + distance * direction)).normalized()};
    }
  }

  bool simple() const override { return true; }

  void check_cameras(const Vector3d& left, const Vector3d& right) const override {
    for (const Vector3d& camera : {left, right}) {
      if (!((to_sphere_ * (camera - centre_)).squaredNorm() > 1)) {
        throw std::invalid_argument("a camera stands inside the ellipsoid");
      }
    }
  }

  void extend(Eigen::AlignedBox3d& box) const override {
    // The columns of to_sphere_'s inverse are the half axes; the ellipsoid reaches their root sum square.
    const Vector3d reach = to_sphere_.inverse().rowwise().norm();
    box.extend(Vector3d(centre_ - reach));
    box.extend(Vector3d(centre_ + reach));
  }

  std::string description() const override {
    return fmt::format("ellipsoid around ({:.6g}, {:.6g}, {:.6g}) mm, half axes {:.6g}, {:.6g}, {:.6g} mm", centre_.x(),
                       centre_.y(), centre_.z(), half_axes_.x(), half_axes_.y(), half_axes_.z());
  }

 private:
  Vector3d centre_, half_axes_;
  Matrix3d to_sphere_, sphere_to_normal_;
};

}  // namespace

SurfacePtr make_ellipsoid(const calib::Pose& pose, const Vector3d& half_axes_mm) {
  return std::make_shared<Ellipsoid>(pose, half_axes_mm);
}

}  // namespace horopter
