// SPDX-License-Identifier: Apache-2.0
// Planes and piecewise planes (thesis 7.1.1).
#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "horopter/skin/surface.hpp"

namespace horopter {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class Plane : public Surface {
 public:
  Plane(const Vector3d& point, const Vector3d& normal) : normal_(normal.normalized()), offset_(normal_.dot(point)) {
    if (!point.allFinite() || !normal_.allFinite()) throw std::invalid_argument("a plane must be finite");
    if (!(normal.norm() > 0)) throw std::invalid_argument("the normal has no length");
  }

  /// n·(C + t·v) = d. Seen through two cameras this is the homography of 7.11.
  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    const double height = offset_ - normal_.dot(origin);
    const Vector3d facing = height < 0 ? normal_ : Vector3d(-normal_);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double distance = height / normal_.dot(directions[i]);
      hits[i] = distance > 0 && std::isfinite(distance) ? Hit{distance, facing} : Hit{};
    }
  }

  bool simple() const override { return true; }

  void check_cameras(const Vector3d& left, const Vector3d& right) const override {
    const double a = normal_.dot(left) - offset_;
    const double b = normal_.dot(right) - offset_;
    if (!(a * b > 0)) throw std::invalid_argument("the cameras do not stand on the same side of the plane");
  }

  void extend(Eigen::AlignedBox3d& box) const override {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(normal_[axis]) < 1 - 1e-12) continue;
      box.min()[axis] = std::min(box.min()[axis], offset_ / normal_[axis]);
      box.max()[axis] = std::max(box.max()[axis], offset_ / normal_[axis]);
    }
  }

  std::string description() const override {
    return fmt::format("plane {:.6g} X + {:.6g} Y + {:.6g} Z = {:.6g} mm", normal_.x(), normal_.y(), normal_.z(),
                       offset_);
  }

 private:
  Vector3d normal_;
  double offset_;
};

/// A polygon in the coordinates of its plane.
class Piece {
 public:
  explicit Piece(const Polygon& corners) {
    if (corners.size() < 3) throw std::invalid_argument("a piece of a plane has at least 3 corners");
    Vector3d area = Vector3d::Zero();  // twice the vector area
    double size = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector3d& next = corners[(i + 1) % corners.size()];
      if (!corners[i].allFinite()) throw std::invalid_argument("a corner is not finite");
      area += (corners[i] - corners[0]).cross(next - corners[0]);
      size = std::max(size, (next - corners[0]).norm());
    }
    if (!(area.norm() > 1e-9 * size * size)) throw std::invalid_argument("the corners of a piece lie on a line");
    normal_ = area.normalized();
    origin_ = corners[0];
    axis_x_ = (normal_.unitOrthogonal());
    axis_y_ = normal_.cross(axis_x_);
    for (const Vector3d& corner : corners) {
      if (std::abs(normal_.dot(corner - origin_)) > 1e-6 * size) {
        throw std::invalid_argument("the corners of a piece do not lie in one plane");
      }
      corners_.push_back(flat(corner));
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      for (std::size_t j = i + 2; j < corners_.size(); ++j) {
        if (i == 0 && j + 1 == corners_.size()) continue;  // neighbours
        if (cross_each_other(i, j)) throw std::invalid_argument("the border of a piece crosses itself");
      }
    }
  }

  void extend(Eigen::AlignedBox3d& box) const {
    for (const Vector2d& c : corners_) box.extend(Vector3d(origin_ + c.x() * axis_x_ + c.y() * axis_y_));
  }

  void intersect(const Vector3d& origin, const Vector3d& direction, Hit& nearest) const {
    const double slope = normal_.dot(direction);
    const double distance = normal_.dot(origin_ - origin) / slope;
    if (!(distance > 0 && distance < nearest.distance)) return;
    if (!contains(flat(origin + distance * direction))) return;
    nearest = {distance, slope < 0 ? normal_ : Vector3d(-normal_)};
  }

 private:
  Vector2d flat(const Vector3d& p) const { return {axis_x_.dot(p - origin_), axis_y_.dot(p - origin_)}; }
  const Vector2d& corner(std::size_t i) const { return corners_[i % corners_.size()]; }

  bool contains(const Vector2d& p) const {
    bool inside = false;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Vector2d& a = corner(i);
      const Vector2d& b = corner(i + 1);
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
  }

  bool cross_each_other(std::size_t i, std::size_t j) const {
    const auto side = [](const Vector2d& a, const Vector2d& b, const Vector2d& p) {
      return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
    };
    const Vector2d &a = corner(i), &b = corner(i + 1), &c = corner(j), &d = corner(j + 1);
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
  }

  Vector3d origin_, normal_, axis_x_, axis_y_;
  std::vector<Vector2d> corners_;
};

class Polygons : public Surface {
 public:
  explicit Polygons(const std::vector<Polygon>& polygons) {
    if (polygons.empty()) throw std::invalid_argument("no piece of a plane");
    for (const Polygon& polygon : polygons) pieces_.emplace_back(polygon);
  }

  void intersect(const Vector3d& origin, std::span<const Vector3d> directions, std::span<Hit> hits) const override {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      hits[i] = {};
      for (const Piece& piece : pieces_) piece.intersect(origin, directions[i], hits[i]);
    }
  }

  /// A piece seen from behind by one camera is hidden by itself: its normal then faces that camera only, and the
  /// other's line of sight lies beyond every angle.
  void check_cameras(const Vector3d& /*left*/, const Vector3d& /*right*/) const override {}

  void extend(Eigen::AlignedBox3d& box) const override {
    for (const Piece& piece : pieces_) piece.extend(box);
  }

  std::string description() const override { return fmt::format("{} pieces of planes", pieces_.size()); }

 private:
  std::vector<Piece> pieces_;
};

}  // namespace

SurfacePtr make_plane(const Vector3d& point_mm, const Vector3d& normal) {
  return std::make_shared<Plane>(point_mm, normal);
}

SurfacePtr make_polygons(std::vector<Polygon> polygons_mm) { return std::make_shared<Polygons>(polygons_mm); }

}  // namespace horopter
