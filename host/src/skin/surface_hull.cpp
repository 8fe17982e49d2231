// SPDX-License-Identifier: Apache-2.0
// Hulls of robots: boxes and chains of capsules.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "horopter/skin/surface.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

class Box : public Surface {
 public:
  Box(const calib::Pose& pose, const Vector3d& size) : pose_(pose), half_(size / 2) {
    if (!pose.rotation.isUnitary(1e-6)) throw std::invalid_argument("a box's rotation is none");
    if (!(size.minCoeff() > 0) || !size.allFinite() || !pose.translation_mm.allFinite()) {
      throw std::invalid_argument("a box has three sizes above 0");
    }
  }

  /// Enters the box where it has entered the last of the three pairs of faces.
  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    const Vector3d from = pose_.inverse() * origin;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      hits[i] = {};
      const Vector3d direction = pose_.rotation.transpose() * directions[i];
      if (!direction.allFinite()) continue;
      double enter = -INFINITY;
      double leave = INFINITY;
      int face = 0;
      for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
          if (std::abs(from[axis]) >= half_[axis]) leave = -INFINITY;
          continue;
        }
        const double side = direction[axis] > 0 ? 1 : -1;
        const double near = (-side * half_[axis] - from[axis]) / direction[axis];
        if (near > enter) {
          enter = near;
          face = axis;
        }
        leave = std::min(leave, (side * half_[axis] - from[axis]) / direction[axis]);
      }
      if (!(enter > 0 && enter < leave)) continue;
      hits[i] = {enter, pose_.rotation.col(face) * (direction[face] > 0 ? -1 : 1)};
    }
  }

  void check_cameras(const Vector3d& left, const Vector3d& right) const override {
    for (const Vector3d& camera : {left, right}) {
      if (!(((pose_.inverse() * camera).cwiseAbs() - half_).maxCoeff() > 0)) {
        throw std::invalid_argument("a camera stands inside the box");
      }
    }
  }

  void extend(Eigen::AlignedBox3d& box) const override {
    const Vector3d reach = pose_.rotation.cwiseAbs() * half_;
    box.extend(Vector3d(pose_.translation_mm - reach));
    box.extend(Vector3d(pose_.translation_mm + reach));
  }

  std::string description() const override {
    const Vector3d& c = pose_.translation_mm;
    return fmt::format("box around ({:.6g}, {:.6g}, {:.6g}) mm of {:.6g} x {:.6g} x {:.6g} mm", c.x(), c.y(), c.z(),
                       2 * half_.x(), 2 * half_.y(), 2 * half_.z());
  }

 private:
  calib::Pose pose_;
  Vector3d half_;
};

class Capsules : public Surface {
 public:
  explicit Capsules(std::vector<Capsule> capsules) : capsules_(std::move(capsules)) {
    if (capsules_.empty()) throw std::invalid_argument("no segment");
    for (const Capsule& c : capsules_) {
      if (!c.from_mm.allFinite() || !c.to_mm.allFinite() || !(c.radius_mm > 0 && std::isfinite(c.radius_mm))) {
        throw std::invalid_argument("a segment has two ends and a radius above 0");
      }
    }
  }

  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    std::ranges::fill(hits.first(directions.size()), Hit{});
    for (const Capsule& capsule : capsules_) {
      const Vector3d axis = capsule.to_mm - capsule.from_mm;
      const double length2 = axis.squaredNorm();
      const Vector3d from = origin - capsule.from_mm;
      const double along = from.dot(axis);
      // Distances from the axis (times its length) and from the ends.
      const double side = length2 * (from.squaredNorm() - capsule.radius_mm * capsule.radius_mm) - along * along;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vector3d& direction = directions[i];
        const double forward = direction.dot(axis);
        const double a = length2 * direction.squaredNorm() - forward * forward;
        const double b = length2 * direction.dot(from) - forward * along;
        const double discriminant = b * b - a * side;
        if (length2 > 0) {
          if (!(discriminant >= 0)) continue;  // the ends lie inside of the endless cylinder
          const double distance = (-b - std::sqrt(discriminant)) / a;
          const double place = (along + distance * forward) / length2;
          if (distance > 0 && distance < hits[i].distance && place >= 0 && place <= 1) {
            hits[i] = {distance, (from + distance * direction - place * axis) / capsule.radius_mm};
          }
        }
        meet_end(capsule.from_mm, capsule.radius_mm, origin, direction, hits[i]);
        meet_end(capsule.to_mm, capsule.radius_mm, origin, direction, hits[i]);
      }
    }
  }

  void check_cameras(const Vector3d& left, const Vector3d& right) const override {
    for (const Vector3d& camera : {left, right}) {
      for (const Capsule& c : capsules_) {
        const Vector3d axis = c.to_mm - c.from_mm;
        const double length2 = axis.squaredNorm();
        const double place = length2 > 0 ? std::clamp((camera - c.from_mm).dot(axis) / length2, 0.0, 1.0) : 0;
        if (!((camera - c.from_mm - place * axis).norm() > c.radius_mm)) {
          throw std::invalid_argument("a camera stands inside a segment's hull");
        }
      }
    }
  }

  void extend(Eigen::AlignedBox3d& box) const override {
    for (const Capsule& c : capsules_) {
      for (const Vector3d& end : {c.from_mm, c.to_mm}) {
        box.extend(Vector3d(end.array() - c.radius_mm));
        box.extend(Vector3d(end.array() + c.radius_mm));
      }
    }
  }

  std::string description() const override { return fmt::format("hull of {} segments", capsules_.size()); }

 private:
  static void meet_end(const Vector3d& centre, double radius, const Vector3d& origin, const Vector3d& direction,
                       Hit& nearest) {
    const Vector3d from = origin - centre;
    const double a = direction.squaredNorm();
    const double b = from.dot(direction);
    const double discriminant = b * b - a * (from.squaredNorm() - radius * radius);
    if (!(discriminant >= 0)) return;
    const double distance = (-b - std::sqrt(discriminant)) / a;
    if (!(distance > 0 && distance < nearest.distance)) return;
    nearest = {distance, (from + distance * direction) / radius};
  }

  std::vector<Capsule> capsules_;
};

}  // namespace

SurfacePtr make_box(const calib::Pose& pose, const Vector3d& size_mm) { return std::make_shared<Box>(pose, size_mm); }

SurfacePtr make_capsules(std::vector<Capsule> capsules) { return std::make_shared<Capsules>(std::move(capsules)); }

}  // namespace horopter
