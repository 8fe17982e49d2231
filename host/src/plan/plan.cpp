// SPDX-License-Identifier: Apache-2.0
#include "horopter/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "horopter/base/angle.hpp"
#include "statistics.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

constexpr double kIsoNear_mm = 500;

double slope_deg(const Vector3d& normal, const Vector3d& axis) {
  return std::acos(std::min(1.0, std::abs(normal.dot(axis)))) / kDegree;
}

/// Largest singular value of the place on the skin's tangent plane by the pixel: dP = t (dv - v (n dv)/(n v)).
double largest_step_mm(const Rays& rays, std::size_t i, const Hit& hit, const Eigen::Matrix3d& to_right) {
  Eigen::Matrix3d view;  // direction and its derivatives, right camera
  for (int k = 0; k < 9; ++k) view(k / 3, k % 3) = rays.right_view[static_cast<std::size_t>(k)][i];
  const Vector3d normal = to_right * hit.normal;
  const auto step = [&](int column) -> Vector3d {
    return hit.distance * (view.col(column) - view.col(0) * normal.dot(view.col(column)) / normal.dot(view.col(0)));
  };
  const Vector3d x = step(1), y = step(2);
  const double sum = x.squaredNorm() + y.squaredNorm();
  const double determinant = x.cross(y).squaredNorm();
  return std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4 * determinant))));
}

}  // namespace

double coplanar_thickness_mm(double tolerance_px, double distance_mm, double baseline_mm, double f_px) {
  return 2 * tolerance_px * distance_mm * distance_mm / (baseline_mm * f_px);
}

double sloped_thickness_mm(double thickness_mm, double slope_deg) {
  return thickness_mm * std::cos(slope_deg * kDegree);
}

double face_width_mm(double thickness_mm, double slope_deg) {
  const double sine = std::sin(slope_deg * kDegree);
  if (sine == 0) return std::numeric_limits<double>::infinity();
  return sloped_thickness_mm(thickness_mm, slope_deg) / sine;
}

double face_share(double tilt_deg) { return tilt_deg <= 45 ? 1 : std::max(0.0, 1 / std::tan(tilt_deg * kDegree)); }

double Timing::longest_s(int frames) const {
  const int fields = profile.fields_per_image();
  const int images = (frames + fields - 1) / fields;
  // The longest begins at the last field of an image.
  const int fields_of_last = frames - (images - 1) * fields;
  return (images * fields * longest_periods - fields + fields_of_last) / images_per_s;
}

std::vector<ResponseItem> detection_items(const Timing& timing) {
  const MachineProfile& profile = timing.profile;
  const int fields = profile.fields_per_image();
  const double image_s = 1 / timing.images_per_s;
  // Lines without blanking are the longest that there can be.
  const auto lines_s = [&](int lines) { return lines * image_s / timing.rows; };
  const std::string hardware = "docs/hardware.md, How long it takes; tb/top/test_frames.cpp";
  const std::string apart =
      timing.longest_periods > 1
          ? fmt::format("; images{} may be {:g} periods apart without a fault (docs/monitor.md)",
                        fields > 1 ? fmt::format(" of {} fields", fields) : "", timing.longest_periods)
          : "";
  // A monitor gets all fields of an image at once.
  const bool waits_for_fields = timing.monitor_s && fields > 1;
  std::vector<ResponseItem> items{
      {"wait for the next image to begin", timing.longest_s(),
       "image rate: the object came when an image had just begun" + apart},
      {"exposure", timing.exposure_s.value_or(image_s),
       timing.exposure_s ? "--exposure-ms" : "no --exposure-ms: the longest that there is, from image to image"},
      {"transfer of the image", waits_for_fields ? fields * image_s : image_s,
       fmt::format("image rate: the longest that there is, without blanking{}",
                   waits_for_fields ? "; a monitor's image comes with its last field" : "")}};
  if (timing.alarm_frames > 1) {
    items.push_back({"further frames that must show it", timing.longest_s(timing.alarm_frames) - timing.longest_s(),
                     "--alarm-frames; rtl/store/horopter_alarm_filter.sv"});
  }
  if (timing.monitor_s) {
    items.push_back({"live monitor, to its client", *timing.monitor_s,
                     "--monitor-ms; docs/monitor.md, How long it takes; tests/benchmarks/monitor.cpp"});
    return items;
  }
  const std::vector<ResponseItem> machine{
      {"LOOKAHEAD, wait for right rows", lines_s(profile.largest_lookahead()),
       "largest of the profile (hls/include/horopter/hls/profiles.def); " + hardware},
      {"windows of the rule", lines_s(profile.flush_rows(timing.decision == Decision::compete)),
       "hls/include/horopter/hls/profiles.hpp flush_rows; " + hardware},
      {"pipeline", lines_s(1), "less than a line: docs/hardware.md, How long it takes"},
      {"what went blind, by blocks", lines_s(profile.cell() + 1),
       "docs/safety.md, Faults: a block is known with its last row; only for what is found by being blind"},
      {"coarse decision on both cameras", 0,
       "32 clocks (docs/safety.md, Faults); an object's alarm does not wait for it"},
      {"frames with the alarm", 0, "one, which is in the transfer; two good ones only raise safe_o"},
      {"output", 0, "3 clocks, rtl/formal/formal_safe.sv; contactors and robot are in the stopping time"}};
  items.insert(items.end(), machine.begin(), machine.end());
  return items;
}

double detection_time_s(const Timing& timing) {
  double sum_s = 0;
  for (const ResponseItem& item : detection_items(timing)) sum_s += item.seconds;
  return sum_s;
}

double safety_distance_mm(double response_s, double speed_m_s) { return response_s * speed_m_s * 1e3; }

double iso_13855_distance_mm(double response_s) {
  const double near = safety_distance_mm(response_s, kIsoHandSpeed_m_s);
  if (near <= kIsoNear_mm) return near;
  return std::max(kIsoNear_mm, safety_distance_mm(response_s, kHandSpeed_m_s));
}

std::optional<IsoDistance> iso_13855_distance(double response_s, double fast_mm, double slow_mm) {
  constexpr double kLeast_mm = 100, kHandSupplement = 8, kFinger_mm = 14, kArmSupplement_mm = 850;
  const auto hand_mm = [&](double capability_mm) {
    return std::max(0.0, kHandSupplement * (capability_mm - kFinger_mm));
  };
  if (fast_mm > 0 && fast_mm <= kIsoHand_mm) {
    const double near_mm = safety_distance_mm(response_s, kIsoHandSpeed_m_s) + hand_mm(fast_mm);
    if (near_mm <= kIsoNear_mm)
      return IsoDistance{kIsoHandSpeed_m_s, hand_mm(fast_mm), std::max(kLeast_mm, near_mm), fast_mm};
  }
  if (!(slow_mm > 0 && slow_mm <= kIsoArm_mm)) return std::nullopt;
  const double way_mm = safety_distance_mm(response_s, kHandSpeed_m_s);
  if (slow_mm > kIsoHand_mm) return IsoDistance{kHandSpeed_m_s, kArmSupplement_mm, way_mm + kArmSupplement_mm, slow_mm};
  return IsoDistance{kHandSpeed_m_s, hand_mm(slow_mm), std::max(kIsoNear_mm, way_mm + hand_mm(slow_mm)), slow_mm};
}

StereoAxis::StereoAxis(const CameraPair& cameras) {
  const Vector3d left = cameras.left().world_to_camera.centre();
  const Vector3d right = cameras.right().world_to_camera.centre();
  const Vector3d left_axis = cameras.left().world_to_camera.rotation.row(2).transpose();
  const Vector3d right_axis = cameras.right().world_to_camera.rotation.row(2).transpose();
  middle_mm = 0.5 * (left + right);
  direction = (left_axis + right_axis).normalized();
  baseline_mm = (right - left).norm();
  tilt_deg = 0.5 * std::acos(std::clamp(left_axis.dot(right_axis), -1.0, 1.0)) / kDegree;
  f_px = cameras.right().model.fx_px();
}

ThicknessPlan plan_thickness(const CameraPair& cameras, const Surface& surface, const MachineProfile& profile,
                             const ScanGeometry& geometry, double tolerance_px, const ViewLimits& limits) {
  const Vector3d left_mm = cameras.left().world_to_camera.centre();
  surface.check_cameras(left_mm, cameras.right().world_to_camera.centre());
  const StereoAxis axis(cameras);
  // In pixels of the frame, whose rows hold `subsample` of them for each of the result's.
  const double tolerance_frame_px = tolerance_px * profile.subsample;
  const auto formula_mm = [&](const Vector3d& point, double slope) {
    const double z = (point - axis.middle_mm).dot(axis.direction);
    return sloped_thickness_mm(coplanar_thickness_mm(tolerance_frame_px, z, axis.baseline_mm, axis.f_px), slope);
  };

  ThicknessPlan plan;
  plan.pixels = std::int64_t{geometry.width} * geometry.height;
  plan.across_mm.assign(static_cast<std::size_t>(plan.pixels), std::nan(""));
  plan.mm_per_px = plan.across_mm;
  const Eigen::Matrix3d to_right = cameras.right().world_to_camera.rotation;
  plan.face_width = plan.least_way_mm = std::numeric_limits<double>::infinity();
  Statistics distance;
  Statistics slope;
  Statistics sight;
  Statistics across;
  Statistics formula;
  const auto width = static_cast<std::size_t>(geometry.width);
  std::vector<Point> points(width);
  std::vector<Hit> hits(width);
  std::vector<Look> looks(width);
  for (int y = 0; y < geometry.height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      points[x] = geometry.to_frame({static_cast<double>(x), static_cast<double>(y)});
    }
    const Rays rays = cameras.rays(points, limits);
    surface.intersect(left_mm, rays.directions, hits);
    cameras.look(surface, rays, geometry.row_step(), limits, looks);
    for (std::size_t x = 0; x < width; ++x) {
      const Look& look = looks[x];
      if (std::isfinite(hits[x].distance)) ++plan.left_sees;
      if (!geometry.holds(geometry.from_frame(look.source)) || look.reason == Reason::hidden) continue;
      ++plan.shared;
      plan.rows.add(look.reason);
      const Vector3d& direction = rays.directions[x];
      const Vector3d point = left_mm + hits[x].distance * direction;
      const double along = cameras.thickness_mm(point, hits[x].normal, tolerance_frame_px);
      if (look.reason != Reason::none || !std::isfinite(along)) continue;
      ++plan.supervised;
      plan.least_way_mm = std::min(plan.least_way_mm, cameras.least_way_mm(point, hits[x].normal));
      const double angle = slope_deg(hits[x].normal, axis.direction);
      const double thickness = along * std::abs(hits[x].normal.dot(direction)) / direction.norm();
      distance.add((point - axis.middle_mm).dot(axis.direction));
      slope.add(angle);
      sight.add(along);
      across.add(thickness);
      formula.add(formula_mm(point, angle));
      // Along the axis the skin is thicker than across, by 11.2.
      plan.face_width = std::min(plan.face_width, face_width_mm(thickness / std::cos(angle * kDegree), angle));
      plan.across_mm[static_cast<std::size_t>(y) * width + x] = thickness;
      plan.mm_per_px[static_cast<std::size_t>(y) * width + x] = largest_step_mm(rays, x, hits[x], to_right);
    }
  }
  if (plan.supervised == 0) plan.face_width = plan.least_way_mm = std::nan("");
  plan.distance = distance.summary();
  plan.slope_deg = slope.summary();
  plan.sight = sight.summary();
  plan.across = across.summary();
  plan.formula = formula.summary();

  plan.on_axis = plan.on_axis_formula = std::nan("");
  Hit hit;
  surface.intersect(axis.middle_mm, std::span(&axis.direction, 1), std::span(&hit, 1));
  if (!std::isfinite(hit.distance)) return plan;
  const Vector3d point = axis.middle_mm + hit.distance * axis.direction;
  if (!cameras.left().project(point) || !cameras.right().project(point)) return plan;
  const double along = cameras.thickness_mm(point, hit.normal, tolerance_frame_px);
  plan.on_axis = along * std::abs(hit.normal.dot((point - left_mm).normalized()));
  plan.on_axis_formula = formula_mm(point, slope_deg(hit.normal, axis.direction));
  return plan;
}

}  // namespace horopter
