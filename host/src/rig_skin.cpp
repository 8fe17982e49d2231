// SPDX-License-Identifier: Apache-2.0
#include "horopter/rig_skin.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace horopter {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Share of the distance from the right camera by which another part of the skin must be nearer to hide a point: above
/// the rounding of a search in single precision, below any thickness of a skin.
constexpr double kSamePoint = 1e-5;
/// Lines of sight at a time: what stays in the fastest cache.
constexpr std::size_t kChunk = 128;

const Point kNowhere{std::nan(""), std::nan("")};

}  // namespace

CameraPair::CameraPair(calib::Camera left, calib::Camera right)
    : left_(std::move(left)),
      right_(std::move(right)),
      left_centre_(left_.world_to_camera.centre()),
      right_centre_(right_.world_to_camera.centre()),
      between_(right_.world_to_camera * left_centre_) {}

Rays CameraPair::rays(std::span<const Point> left) const {
  Rays rays;
  rays.directions.reserve(left.size());
  rays.right_view.reserve(left.size());
  rays.over_length.reserve(left.size());
  const Matrix3d to_world = left_.world_to_camera.rotation.transpose();
  const Matrix3d to_right = right_.world_to_camera.rotation * to_world;
  for (const Point& pixel : left) {
    Matrix2d slope;
    const auto undistorted = left_.model.undistort({pixel.x, pixel.y}, &slope);
    Matrix3d view = Matrix3d::Constant(std::nan(""));
    if (undistorted) {
      view.col(0) = undistorted->homogeneous();
      view.rightCols<2>() << slope, 0, 0;
    }
    rays.directions.emplace_back(to_world * view.col(0));
    rays.right_view.emplace_back(to_right * view);
    rays.over_length.push_back(1 / view.col(0).norm());
  }
  return rays;
}

void CameraPair::look(const Surface& surface, const Rays& rays, int row_step, const ViewLimits& limits,
                      std::span<Look> looks) const {
  std::array<Hit, kChunk> hits;
  std::array<Hit, kChunk> right_hits;
  std::array<Vector3d, kChunk> sights;  // from the right camera to the point on the skin
  const double smallest_cosine = std::cos(limits.largest_angle_deg * std::numbers::pi / 180);
  const double largest_stretch_allowed = 1 / limits.smallest_scale;
  const Matrix3d& to_right = right_.world_to_camera.rotation;
  const bool search_hidden = !surface.simple();
  calib::CameraModel::LensPlace lens_place;
  for (std::size_t first = 0; first < rays.size(); first += kChunk) {
    const std::size_t count = std::min(kChunk, rays.size() - first);
    const auto directions = std::span(rays.directions).subspan(first, count);
    surface.intersect(left_centre_, directions, std::span(hits).first(count));
    if (search_hidden) {
      for (std::size_t i = 0; i < count; ++i) {
        sights[i] = left_centre_ + hits[i].distance * directions[i] - right_centre_;
      }
      surface.intersect(right_centre_, std::span(sights).first(count), std::span(right_hits).first(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
      Look& look = looks[first + i];
      look = {kNowhere, std::nanf(""), Reason::no_source};
      const Hit& hit = hits[i];
      if (!std::isfinite(hit.distance)) continue;
      look.reason = Reason::outside;
      const Matrix3d& view = rays.right_view[first + i];
      const Vector3d sight = view.col(0);
      const Vector3d normal = to_right * hit.normal;
      const Vector3d point = between_ + hit.distance * sight;
      if (!(point.z() > 0)) continue;
      const double over_z = 1 / point.z();
      const Vector2d normalised = point.head<2>() * over_z;
      Matrix2d lens;
      const auto pixel = right_.model.distort_near(normalised, lens_place, &lens);
      if (!pixel) continue;
      look.source = {pixel->x(), pixel->y()};

      // The map's derivatives are those of the skin's tangent plane: dP = t (dv − v (n·dv)/(n·v)).
      const double facing = normal.dot(sight);
      const Eigen::RowVector2d tilt = normal.transpose() * view.rightCols<2>() / facing;
      const Eigen::Matrix<double, 3, 2> moved = hit.distance * (view.rightCols<2>() - sight * tilt);
      const Matrix2d d = lens * (moved.topRows<2>() - normalised * moved.row(2)) * over_z;
      const double stretch = largest_stretch({d(0, 0), d(0, 1) * row_step, d(1, 0) / row_step, d(1, 1)});
      const double left_cosine = -facing * rays.over_length[first + i];
      const double right_cosine = -normal.dot(point) / point.norm();
      const double cosine = std::min(left_cosine, right_cosine);
      look.margin = static_cast<float>(
          std::min(cosine - smallest_cosine, (largest_stretch_allowed - stretch) / largest_stretch_allowed));
      if (search_hidden && !(right_hits[i].distance >= 1 - kSamePoint)) {
        look.reason = Reason::hidden;
      } else if (!(cosine >= smallest_cosine)) {
        look.reason = Reason::angle;
      } else if (!(stretch <= largest_stretch_allowed * (1 + 1e-9))) {
        look.reason = Reason::scale;
      } else {
        look.reason = Reason::none;
      }
    }
  }
}

double CameraPair::thickness_mm(Point left, Point right, double tolerance_px) const {
  const auto from_left = left_.model.undistort({left.x, left.y});
  const auto from_right = right_.model.undistort({right.x, right.y});
  if (!from_left || !from_right) return std::nan("");
  const calib::Pose left_to_right = right_.world_to_camera * left_.world_to_camera.inverse();
  const Vector3d sight = left_to_right.rotation * from_left->homogeneous();
  // Least squares of the place along the left line of sight that the right pixel sees: (B + t·s) × q = 0.
  const Vector3d seen = from_right->homogeneous();
  const Vector3d a = sight.cross(seen);
  const double distance = -a.dot(between_.cross(seen)) / a.squaredNorm();
  const Vector3d point = between_ + distance * sight;
  Matrix2d lens;
  if (!(distance > 0) || !(point.z() > 0)) return std::nan("");
  const Vector2d normalised = point.head<2>() / point.z();
  if (!right_.model.distort(normalised, &lens)) return std::nan("");
  const Vector2d pixels_per_distance = lens * (sight.head<2>() - normalised * sight.z()) / point.z();
  return 2 * tolerance_px / pixels_per_distance.norm() * sight.norm();
}

RigSkin::RigSkin(CameraPair cameras, SurfacePtr surface, std::string_view type)
    : cameras_(std::move(cameras)), surface_(std::move(surface)), type_(type) {
  surface_->check_cameras(cameras_.left().world_to_camera.centre(), cameras_.right().world_to_camera.centre());
}

void RigSkin::look(std::span<const Point> left, int row_step, const ViewLimits& limits, std::span<Look> looks) const {
  cameras_.look(*surface_, cameras_.rays(left), row_step, limits, looks);
}

}  // namespace horopter
