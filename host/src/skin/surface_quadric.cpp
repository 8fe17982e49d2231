// SPDX-License-Identifier: Apache-2.0
// Ellipsoids (thesis 7.1.2).
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "horopter/calib/vectorised.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Lines of sight at a time, side by side.
constexpr std::size_t kSphereLanes = 128;
struct SphereLanes {
  using Lane = std::array<double, kSphereLanes>;
  Lane x, y, z;  ///< the direction, then the place on the sphere, then the normal
  Lane distance;
};

/// 7.12 with 7.14 put in, in coordinates in which the ellipsoid is the unit sphere: a t² + 2 b t + c = 0. The smaller
/// t is the intersection that faces the camera; b < 0 < c, so it is c/(−b + √…) without cancellation.
[[gnu::always_inline]] inline void meet_sphere(const Matrix3d& to_sphere, const Vector3d& from, std::size_t count,
                                               SphereLanes& k, std::int64_t& meetings) {
  const double m[9] = {to_sphere(0, 0), to_sphere(0, 1), to_sphere(0, 2), to_sphere(1, 0), to_sphere(1, 1),
                       to_sphere(1, 2), to_sphere(2, 0), to_sphere(2, 1), to_sphere(2, 2)};
  const double f[3] = {from.x(), from.y(), from.z()};
  const double c = from.squaredNorm() - 1;
  std::int64_t met = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = m[0] * k.x[i] + m[1] * k.y[i] + m[2] * k.z[i];
    const double y = m[3] * k.x[i] + m[4] * k.y[i] + m[5] * k.z[i];
    const double z = m[6] * k.x[i] + m[7] * k.y[i] + m[8] * k.z[i];
    const double a = x * x + y * y + z * z;
    const double b = f[0] * x + f[1] * y + f[2] * z;
    const double discriminant = b * b - a * c;
    // Not where the line of sight passes it by, or is none.
    const double distance = c / (std::sqrt(discriminant) - b);
    const bool meets = static_cast<bool>((b < 0) & (discriminant >= 0));
    met += meets ? 1 : 0;
    k.distance[i] = meets ? distance : std::numeric_limits<double>::quiet_NaN();
    k.x[i] = f[0] + distance * x;
    k.y[i] = f[1] + distance * y;
    k.z[i] = f[2] + distance * z;
  }
  meetings = met;
}

[[gnu::always_inline]] inline void normals(const Matrix3d& sphere_to_normal, std::size_t count, SphereLanes& k) {
  const double m[9] = {sphere_to_normal(0, 0), sphere_to_normal(0, 1), sphere_to_normal(0, 2),
                       sphere_to_normal(1, 0), sphere_to_normal(1, 1), sphere_to_normal(1, 2),
                       sphere_to_normal(2, 0), sphere_to_normal(2, 1), sphere_to_normal(2, 2)};
  for (std::size_t i = 0; i < count; ++i) {
    const double x = m[0] * k.x[i] + m[1] * k.y[i] + m[2] * k.z[i];
    const double y = m[3] * k.x[i] + m[4] * k.y[i] + m[5] * k.z[i];
    const double z = m[6] * k.x[i] + m[7] * k.y[i] + m[8] * k.z[i];
    const double over = 1 / std::sqrt(x * x + y * y + z * z);
    const bool none = std::isnan(k.distance[i]);
    k.distance[i] = none ? std::numeric_limits<double>::infinity() : k.distance[i];
    k.x[i] = none ? 0 : x * over;
    k.y[i] = none ? 0 : y * over;
    k.z[i] = none ? 0 : z * over;
  }
}

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

  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    const Vector3d from = to_sphere_ * (origin - centre_);
    const bool outside = from.squaredNorm() > 1;
    SphereLanes chunk;
    for (std::size_t first = 0; first < directions.size(); first += kSphereLanes) {
      const std::size_t count = std::min(kSphereLanes, directions.size() - first);
      const auto of_chunk = hits.subspan(first, count);
      for (std::size_t i = 0; i < count; ++i) {
        const Vector3d& direction = directions[first + i];
        chunk.x[i] = direction.x();
        chunk.y[i] = direction.y();
        chunk.z[i] = direction.z();
      }
      std::int64_t meetings = 0;
      calib::vectorised<meet_sphere>(to_sphere_, from, count, chunk, meetings);
      if (meetings == 0 || !outside) {
        std::ranges::fill(of_chunk, Hit{});
        continue;
      }
      calib::vectorised<normals>(sphere_to_normal_, count, chunk);
      for (std::size_t i = 0; i < count; ++i) {
        of_chunk[i] = {chunk.distance[i], {chunk.x[i], chunk.y[i], chunk.z[i]}};
      }
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
