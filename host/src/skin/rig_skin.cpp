// SPDX-License-Identifier: Apache-2.0
#include "horopter/skin/rig_skin.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "horopter/base/angle.hpp"
#include "horopter/calib/vectorised.hpp"

namespace horopter {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Share of the distance from the right camera by which another part of the skin must be nearer to hide a point: above
/// the rounding of a search in single precision, below any thickness of a skin.
constexpr double kSamePoint = 1e-5;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Lines of sight at a time: what stays in the fastest cache.
constexpr std::size_t kChunk = 64;
using Lane = std::array<double, kChunk>;

/// Numbers of a chunk side by side, as a processor's vectors like them.
struct Chunk {
  Lane distance, normal_x, normal_y, normal_z;  // normal in world coordinates
  Lane x, y, over_z;                            // point in the right camera, normalised, and 1/z
  Lane facing;                                  // normal · direction
  Lane right_cosine, stretch;
  calib::PixelBatch pixels;
};

/// Where the lines of sight meet the skin, in the right camera.
[[gnu::always_inline]] inline void place_points(const Matrix3d& to_right, const Vector3d& between,
                                                const std::array<const double*, 9>& view, std::size_t count, Chunk& c) {
  const double r[9] = {to_right(0, 0), to_right(0, 1), to_right(0, 2), to_right(1, 0), to_right(1, 1),
                       to_right(1, 2), to_right(2, 0), to_right(2, 1), to_right(2, 2)};
  const double b[3] = {between.x(), between.y(), between.z()};
  for (std::size_t i = 0; i < count; ++i) {
    const double sight[3] = {view[0][i], view[3][i], view[6][i]};
    const double n[3] = {c.normal_x[i], c.normal_y[i], c.normal_z[i]};
    const double nx = r[0] * n[0] + r[1] * n[1] + r[2] * n[2];
    const double ny = r[3] * n[0] + r[4] * n[1] + r[5] * n[2];
    const double nz = r[6] * n[0] + r[7] * n[1] + r[8] * n[2];
    const double px = b[0] + c.distance[i] * sight[0];
    const double py = b[1] + c.distance[i] * sight[1];
    const double pz = b[2] + c.distance[i] * sight[2];
    c.normal_x[i] = nx;
    c.normal_y[i] = ny;
    c.normal_z[i] = nz;
    c.over_z[i] = pz > 0 && pz < kInfinity ? 1 / pz : std::numeric_limits<double>::quiet_NaN();
    c.x[i] = px * c.over_z[i];
    c.y[i] = py * c.over_z[i];
    c.facing[i] = nx * sight[0] + ny * sight[1] + nz * sight[2];
    c.right_cosine[i] = -(nx * px + ny * py + nz * pz) / std::sqrt(px * px + py * py + pz * pz);
  }
}

/// The map's derivatives are those of the skin's tangent plane: dP = t (dv − v (n·dv)/(n·v)).
[[gnu::always_inline]] inline void stretch_points(const std::array<const double*, 9>& view, int row_step,
                                                  std::size_t count, Chunk& c) {
  const double rows = row_step;
  const double over_rows = 1 / rows;  // exact: 1 or 2
  for (std::size_t i = 0; i < count; ++i) {
    const double over = 1 / c.facing[i];
    const double scale = c.distance[i] * c.over_z[i];
    double d[2][2];  // of the normalised point, by the left pixel
    for (int k = 0; k < 2; ++k) {
      const double dx = view[1 + k][i], dy = view[4 + k][i], dz = view[7 + k][i];
      const double tilt = (c.normal_x[i] * dx + c.normal_y[i] * dy + c.normal_z[i] * dz) * over;
      const double mx = dx - view[0][i] * tilt, my = dy - view[3][i] * tilt, mz = dz - view[6][i] * tilt;
      d[0][k] = scale * (mx - c.x[i] * mz);
      d[1][k] = scale * (my - c.y[i] * mz);
    }
    const auto& p = c.pixels;
    c.stretch[i] =
        largest_stretch({p.xx[i] * d[0][0] + p.xy[i] * d[1][0], (p.xx[i] * d[0][1] + p.xy[i] * d[1][1]) * rows,
                         (p.yx[i] * d[0][0] + p.yy[i] * d[1][0]) * over_rows, p.yx[i] * d[0][1] + p.yy[i] * d[1][1]});
  }
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Point kNowhere{kNan, kNan};
constexpr Look kNoLook{kNowhere, std::numeric_limits<float>::quiet_NaN(), Reason::no_source};

/// How far the left epipolar line of a pixel is off its row where it is `shift` columns further; NaN where it does not
/// get there. `sight` is the pixel's, z = 1, `baseline` the direction to the other camera: the line is what
/// sight + s·baseline is seen at.
double row_error_at(const calib::CameraModel& model, Point pixel, const Vector3d& sight, const Vector3d& baseline,
                    double shift) {
  constexpr int kMostSteps = 10;
  constexpr double kClose_px = 1e-3;
  double s = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vector3d point = sight + s * baseline;
    Matrix2d lens;
    if (!(point.z() > 0)) break;
    const Vector2d normalised = point.head<2>() / point.z();
    const auto seen = model.distort(normalised, &lens);
    if (!seen) break;
    const double missing = pixel.x + shift - seen->x();
    if (std::abs(missing) < kClose_px) return seen->y() - pixel.y;
    const Vector2d along = lens * (baseline.head<2>() - normalised * baseline.z()) / point.z();
    s += missing / along.x();
  }
  return std::nan("");
}

/// Least squares of the place along a line of sight that another camera sees, right camera: (between + t·sight) × seen = 0.
double distance_along(const Vector3d& sight, const Vector3d& between, const Vector3d& seen) {
  const Vector3d a = sight.cross(seen);
  return -a.dot(between.cross(seen)) / a.squaredNorm();
}

}  // namespace

CameraPair::CameraPair(calib::Camera left, calib::Camera right)
    : left_(std::move(left)),
      right_(std::move(right)),
      left_centre_(left_.world_to_camera.centre()),
      right_centre_(right_.world_to_camera.centre()),
      between_(right_.world_to_camera * left_centre_) {}

Rays CameraPair::rays(std::span<const Point> left, const ViewLimits& limits) const {
  Rays rays;
  rays.largest_shift_px = limits.largest_shift_px;
  const Vector3d baseline = (left_.world_to_camera.rotation * (right_centre_ - left_centre_)).normalized();
  rays.directions.reserve(left.size());
  for (auto& entry : rays.right_view) entry.reserve(left.size());
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
    rays.over_length.push_back(1 / view.col(0).norm());
    if (limits.largest_shift_px != 0) {
      const double shift = limits.largest_shift_px;
      const double ahead = row_error_at(left_.model, pixel, view.col(0), baseline, shift);
      const double behind = row_error_at(left_.model, pixel, view.col(0), baseline, -shift);
      rays.row_error.push_back(std::isnan(ahead) ? ahead : std::max(std::abs(behind), std::abs(ahead)));
    }
    view = to_right * view;
    for (int i = 0; i < 9; ++i) rays.right_view[static_cast<std::size_t>(i)].push_back(view(i / 3, i % 3));
  }
  return rays;
}

void CameraPair::look(const Surface& surface, const Rays& rays, int row_step, const ViewLimits& limits,
                      std::span<Look> looks, std::size_t first_ray) const {
  look_at<false>(surface, rays, row_step, limits, looks, first_ray);
}

void CameraPair::look_at_runs(const Surface& surface, const Rays& rays, int row_step, const ViewLimits& limits,
                              std::span<Look> looks, std::size_t first_ray) const {
  look_at<true>(surface, rays, row_step, limits, looks, first_ray);
}

template <bool kRuns>
void CameraPair::look_at(const Surface& surface, const Rays& rays, int row_step, const ViewLimits& limits,
                         std::span<Look> looks, std::size_t first_ray) const {
  constexpr std::size_t kRun = kRuns ? calib::PixelBatch::kRun : kChunk;  // what is looked at by itself
  if (limits.largest_shift_px > rays.largest_shift_px) {
    throw std::invalid_argument("lines of sight that were not followed as far as the neighbours are shifted");
  }
  std::array<Hit, kChunk> all_hits;
  std::array<Hit, kChunk> right_hits;
  std::array<Vector3d, kChunk> sights;  // from the right camera to the point on the skin
  Chunk c;
  const double smallest_cosine = std::cos(limits.largest_angle_deg * kDegree);
  const double largest_stretch_allowed = 1 / limits.smallest_scale;
  const double largest_row_error = kLargestRowError * row_step;
  const bool search_hidden = !surface.simple();
  for (std::size_t chunk = 0; chunk < looks.size(); chunk += kChunk) {
    const std::size_t size = std::min(kChunk, looks.size() - chunk);
    surface.intersect(left_centre_, std::span(rays.directions).subspan(first_ray + chunk, size),
                      std::span(all_hits).first(size));
    // From the first to the last that meets it.
    std::size_t begin = 0;
    std::size_t end = size;
    while (begin < end && !std::isfinite(all_hits[begin].distance)) ++begin;
    while (begin < end && !std::isfinite(all_hits[end - 1].distance)) --end;
    if (kRuns && begin < end) {
      begin = begin / kRun * kRun;
      end = (end + kRun - 1) / kRun * kRun;
    }
    std::ranges::fill(looks.subspan(chunk, begin), kNoLook);
    std::ranges::fill(looks.subspan(chunk + end, size - end), kNoLook);
    const std::size_t count = end - begin;
    if (count == 0) continue;
    const std::size_t first = first_ray + chunk + begin;
    const auto seen = looks.subspan(chunk + begin, count);
    const auto directions = std::span(rays.directions).subspan(first, count);
    const auto hits = std::span(all_hits).subspan(begin, count);
    if (search_hidden) {
      for (std::size_t i = 0; i < count; ++i) {
        sights[i] = left_centre_ + hits[i].distance * directions[i] - right_centre_;
      }
      for (std::size_t run = 0; run < count; run += kRun) {
        const auto last = std::min(run + kRun, count);
        std::size_t from = run;
        std::size_t to = last;
        while (from < to && !std::isfinite(hits[from].distance)) ++from;
        while (from < to && !std::isfinite(hits[to - 1].distance)) --to;
        surface.intersect(right_centre_, std::span(sights).subspan(from, to - from),
                          std::span(right_hits).subspan(from, to - from));
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      c.distance[i] = hits[i].distance;
      c.normal_x[i] = hits[i].normal.x();
      c.normal_y[i] = hits[i].normal.y();
      c.normal_z[i] = hits[i].normal.z();
    }
    std::array<const double*, 9> view;
    for (std::size_t i = 0; i < 9; ++i) view[i] = rays.right_view[i].data() + first;
    calib::vectorised<place_points>(right_.world_to_camera.rotation, between_, view, count, c);
    const auto x = std::span(c.x).first(count);
    const auto y = std::span(c.y).first(count);
    kRuns ? right_.model.distort_runs(x, y, c.pixels) : right_.model.distort(x, y, c.pixels);
    calib::vectorised<stretch_points>(view, row_step, count, c);
    for (std::size_t i = 0; i < count; ++i) {
      Look& look = seen[i];
      if (!std::isfinite(c.distance[i])) {
        look = kNoLook;
        continue;
      }
      if (std::isnan(c.pixels.x[i])) {
        look = {kNowhere, kNoLook.margin, Reason::outside};
        continue;
      }
      look.source = {c.pixels.x[i], c.pixels.y[i]};
      const double cosine = std::min(-c.facing[i] * rays.over_length[first + i], c.right_cosine[i]);
      const double stretch = c.stretch[i];
      look.margin = static_cast<float>(
          std::min(cosine - smallest_cosine, (largest_stretch_allowed - stretch) * limits.smallest_scale));
      if (search_hidden && !(right_hits[i].distance >= 1 - kSamePoint)) {
        look.reason = Reason::hidden;
      } else if (!(cosine >= smallest_cosine)) {
        look.reason = Reason::angle;
      } else if (!(stretch <= largest_stretch_allowed * (1 + 1e-9))) {
        look.reason = Reason::scale;
      } else {
        look.reason = Reason::none;
      }
      if (limits.largest_shift_px == 0) continue;
      const double row_error = rays.row_error[first + i];
      const bool stays = row_error <= largest_row_error;
      look.margin =
          std::min(look.margin, std::isnan(row_error) ? -1.0F : static_cast<float>(1 - row_error / largest_row_error));
      if (!stays && look.reason == Reason::none) look.reason = Reason::row;
    }
  }
}

void CameraPair::look_around(const Surface& surface, const Rays& rays, std::span<Point> sources,
                             std::span<const std::uint8_t> wanted) const {
  std::array<Hit, kChunk> hits;
  std::vector<double> distances(rays.size());
  for (std::size_t first = 0; first < rays.size(); first += kChunk) {
    const std::size_t count = std::min(kChunk, rays.size() - first);
    surface.intersect(left_centre_, std::span(rays.directions).subspan(first, count), std::span(hits).first(count));
    for (std::size_t i = 0; i < count; ++i) distances[first + i] = hits[i].distance;
  }
  // A plane's 1/z is linear in the normalised image. The directions have z = 1, so that a distance is z.
  std::array<double, 6> squares{};
  Vector3d right_side = Vector3d::Zero();
  double least = kInfinity;
  double most = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!std::isfinite(distances[i])) continue;
    const Vector3d& sight = rays.directions[i];
    const double over_z = 1 / distances[i];
    squares[0] += sight.x() * sight.x();
    squares[1] += sight.x() * sight.y();
    squares[2] += sight.x() * sight.z();
    squares[3] += sight.y() * sight.y();
    squares[4] += sight.y() * sight.z();
    squares[5] += sight.z() * sight.z();
    right_side += sight * over_z;
    least = std::min(least, over_z);
    most = std::max(most, over_z);
  }
  Matrix3d normal;
  normal << squares[0], squares[1], squares[2], squares[1], squares[3], squares[4], squares[2], squares[4], squares[5];
  const Vector3d plane = normal.completeOrthogonalDecomposition().solve(right_side);
  std::ranges::fill(sources, kNowhere);
  std::array<std::size_t, kChunk> which;
  std::array<double, kChunk> x, y;
  calib::PixelBatch pixels;
  std::size_t count = 0;
  const auto distort = [&] {
    right_.model.distort(std::span(x).first(count), std::span(y).first(count), pixels);
    for (std::size_t i = 0; i < count; ++i) sources[which[i]] = {pixels.x[i], pixels.y[i]};
    count = 0;
  };
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!wanted.empty() && wanted[i] == 0) continue;
    double distance = distances[i];
    if (!std::isfinite(distance)) {
      if (most == 0 || !rays.directions[i].allFinite()) continue;
      distance = 1 / std::clamp(plane.dot(rays.directions[i]), least, most);
    }
    const double z = between_.z() + distance * rays.right_view[6][i];
    if (!(z > 0)) continue;
    which[count] = i;
    x[count] = (between_.x() + distance * rays.right_view[0][i]) / z;
    y[count] = (between_.y() + distance * rays.right_view[3][i]) / z;
    if (++count == kChunk) distort();
  }
  distort();
}

Eigen::Matrix<double, 2, 3> CameraPair::left_px_per_mm(const Vector3d& point_mm) const {
  const Vector3d seen = left_.world_to_camera * point_mm;
  const Vector2d normalised = seen.head<2>() / seen.z();
  Matrix2d lens;
  if (!(seen.z() > 0) || !((right_.world_to_camera * point_mm).z() > 0) || !left_.model.distort(normalised, &lens)) {
    return Eigen::Matrix<double, 2, 3>::Constant(std::nan(""));
  }
  Eigen::Matrix<double, 2, 3> by_place;
  by_place << Matrix2d::Identity(), -normalised;
  return lens * (by_place / seen.z()) * left_.world_to_camera.rotation;
}

// The transformed right image shows a thing that is w beside a point of the skin where the right line of sight to it meets
// the skin: at w - r (n w) / (n r), with r from the right camera to the point, n normal to the skin.
double CameraPair::thickness_mm(const Vector3d& point_mm, const Vector3d& normal, double tolerance_px) const {
  const Vector3d sight = point_mm - left_centre_;
  const Vector3d right_sight = point_mm - right_centre_;
  // Along the left line of sight w itself is no disparity.
  const double px_per_length =
      (left_px_per_mm(point_mm) * right_sight).norm() * std::abs(normal.dot(sight)) / std::abs(normal.dot(right_sight));
  return 2 * tolerance_px / px_per_length * sight.norm();
}

double CameraPair::least_way_mm(const Vector3d& point_mm, const Vector3d& normal) const {
  const Eigen::Matrix<double, 2, 3> left_px = left_px_per_mm(point_mm);
  const Vector3d right_sight = point_mm - right_centre_;
  const Eigen::Matrix<double, 2, 3> shown_px =
      left_px - left_px * right_sight * normal.transpose() / normal.dot(right_sight);
  const Matrix2d square = shown_px * shown_px.transpose();
  const double half_trace = square.trace() / 2;
  return 1 / std::sqrt(half_trace + std::sqrt(std::max(0.0, half_trace * half_trace - square.determinant())));
}

std::optional<Vector3d> CameraPair::place_mm(Point left, Point right) const {
  const auto from_left = left_.model.undistort({left.x, left.y});
  const auto from_right = right_.model.undistort({right.x, right.y});
  if (!from_left || !from_right) return {};
  const Vector3d in_world = left_.world_to_camera.rotation.transpose() * from_left->homogeneous();
  const Vector3d sight = right_.world_to_camera.rotation * in_world;
  const double distance = distance_along(sight, between_, from_right->homogeneous());
  const Vector3d place = left_centre_ + distance * in_world;
  if (!(distance > 0) || !place.allFinite() || !((right_.world_to_camera * place).z() > 0)) return {};
  return place;
}

RigSkin::RigSkin(CameraPair cameras, SurfacePtr surface, std::string_view type)
    : cameras_(std::move(cameras)), surface_(std::move(surface)), type_(type) {
  surface_->check_cameras(cameras_.left().world_to_camera.centre(), cameras_.right().world_to_camera.centre());
}

void RigSkin::look(std::span<const Point> left, int row_step, const ViewLimits& limits, std::span<Look> looks) const {
  cameras_.look(*surface_, cameras_.rays(left, limits), row_step, limits, looks);
}

void RigSkin::look_around(std::span<const Point> left, std::span<Point> sources) const {
  cameras_.look_around(*surface_, cameras_.rays(left), sources);
}

}  // namespace horopter
