// SPDX-License-Identifier: Apache-2.0
#include "horopter/plan/plan_rig.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "horopter/base/angle.hpp"
#include "statistics.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

}  // namespace

calib::Rig make_rig(const RigDesign& design) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (!positive(design.f_mm) || !positive(design.pitch_um) || design.width_px <= 0 || design.height_px <= 0 ||
      !positive(design.baseline_mm) || !(std::abs(design.tilt_deg) < 90)) {
    throw std::invalid_argument("a rig has positive lengths and sizes and a tilt of less than 90 degrees");
  }
  calib::TsaiIntrinsics lens;
  lens.f_mm = design.f_mm;
  lens.dx_mm = lens.dy_mm = design.pitch_um * 1e-3;
  lens.cx_px = 0.5 * (design.width_px - 1);
  lens.cy_px = 0.5 * (design.height_px - 1);
  calib::Rig rig{kDesignedWorld, {}};
  for (const double side : {-1.0, 1.0}) {
    calib::Camera& camera = rig.cameras.emplace_back();
    camera.name = side < 0 ? "left" : "right";
    camera.width_px = design.width_px;
    camera.height_px = design.height_px;
    camera.model = calib::CameraModel(lens);
    const Vector3d place(side * design.baseline_mm / 2, 0, 0);
    camera.world_to_camera.rotation = calib::rotation_from_vector({0, side * design.tilt_deg * kDegree, 0});
    camera.world_to_camera.translation_mm = -(camera.world_to_camera.rotation * place);
  }
  return rig;
}

double converging_tilt_deg(double baseline_mm, double distance_mm) {
  return std::atan(baseline_mm / 2 / distance_mm) / kDegree;
}

double baseline_for_mm(double thickness_mm, double tolerance_px, double distance_mm, double f_px) {
  return coplanar_thickness_mm(tolerance_px, distance_mm, 1, f_px) / thickness_mm;
}

std::optional<DepthRange> depth_range(const CameraPair& cameras) {
  const StereoAxis axis(cameras);
  const auto seen = [&](double distance) {
    const Vector3d place = axis.middle_mm + distance * axis.direction;
    for (const calib::Camera* camera : {&cameras.left(), &cameras.right()}) {
      const auto pixel = camera->project(place);
      const ScanGeometry frame{camera->width_px, camera->height_px, Scan::progressive};
      if (!pixel || !frame.holds({pixel->x(), pixel->y()})) return false;
    }
    return true;
  };
  constexpr int kSteps = 2000;
  constexpr double kNearest = 1e-3;  // baselines
  constexpr double kFarthest = 1e3;
  const auto distance = [&](int step) {
    return axis.baseline_mm * kNearest * std::pow(kFarthest / kNearest, static_cast<double>(step) / kSteps);
  };
  // Between a place that is seen and one that is not.
  const auto end = [&](double in, double out) {
    for (int i = 0; i < 60; ++i) (seen(0.5 * (in + out)) ? in : out) = 0.5 * (in + out);
    return in;
  };
  int first = 0;
  while (first <= kSteps && !seen(distance(first))) ++first;
  if (first > kSteps) return {};
  int last = first;
  while (last < kSteps && seen(distance(last + 1))) ++last;
  return DepthRange{first == 0 ? 0 : end(distance(first), distance(first - 1)),
                    last == kSteps ? std::numeric_limits<double>::infinity() : end(distance(last), distance(last + 1))};
}

CommonField common_field(const CameraPair& cameras, const Surface& surface, const ScanGeometry& geometry,
                         const ViewLimits& limits) {
  const Vector3d left_mm = cameras.left().world_to_camera.centre();
  const Vector3d right_mm = cameras.right().world_to_camera.centre();
  surface.check_cameras(left_mm, right_mm);
  const StereoAxis axis(cameras);
  const Vector3d y = axis.direction.cross(right_mm - left_mm).normalized();
  const Vector3d x = y.cross(axis.direction);
  CommonField field;
  Eigen::AlignedBox2d extent;
  Statistics left_angle;
  Statistics right_angle;
  const auto width = static_cast<std::size_t>(geometry.width);
  std::vector<Point> points(width);
  std::vector<Hit> hits(width);
  std::vector<Look> looks(width);
  for (int row = 0; row < geometry.height; ++row) {
    for (std::size_t i = 0; i < width; ++i) {
      points[i] = geometry.to_frame({static_cast<double>(i), static_cast<double>(row)});
    }
    const Rays rays = cameras.rays(points, limits);
    surface.intersect(left_mm, rays.directions, hits);
    cameras.look(surface, rays, geometry.row_step(), limits, looks);
    for (std::size_t i = 0; i < width; ++i) {
      if (!std::isfinite(hits[i].distance)) continue;
      const Vector3d& direction = rays.directions[i];
      // What a pixel sees at distance 1, as a parallelepiped: its direction and the derivatives of it.
      Eigen::Matrix3d view;
      for (int k = 0; k < 9; ++k) view(k / 3, k % 3) = rays.right_view[static_cast<std::size_t>(k)][i];
      const double parallelepiped = std::abs(view.determinant()) * geometry.row_step();
      const double facing = std::abs(hits[i].normal.dot(direction));
      const double m2 = hits[i].distance * hits[i].distance * parallelepiped / facing * 1e-6;
      if (!std::isfinite(m2)) continue;
      field.left_m2 += m2;
      if (!geometry.holds(geometry.from_frame(looks[i].source)) || looks[i].reason == Reason::hidden) continue;
      field.common_m2 += m2;
      if (looks[i].reason == Reason::none) field.supervised_m2 += m2;
      const Vector3d place = left_mm + hits[i].distance * direction;
      extent.extend(Eigen::Vector2d(x.dot(place), y.dot(place)));
      const auto angle = [&](const Vector3d& sight) {
        return std::acos(std::min(1.0, std::abs(hits[i].normal.dot(sight)) / sight.norm())) / kDegree;
      };
      left_angle.add(angle(direction));
      right_angle.add(angle(place - right_mm));
    }
  }
  field.width_mm = extent.isEmpty() ? std::nan("") : extent.sizes().x();
  field.height_mm = extent.isEmpty() ? std::nan("") : extent.sizes().y();
  field.left_angle_deg = left_angle.summary();
  field.right_angle_deg = right_angle.summary();
  return field;
}

}  // namespace horopter
