// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/render.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace horopter::calib {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d RenderCamera::project(const Vector3d& world_mm) const {
  const Vector3d c = rotation * world_mm + translation_mm;
  const Vector2d undistorted(f_mm * c.x() / c.z(), f_mm * c.y() / c.z());
  const double ru = undistorted.norm();
  double rd = ru;
  for (int i = 0; i < 30; ++i) rd -= (rd + kappa1 * rd * rd * rd - ru) / (1 + 3 * kappa1 * rd * rd);
  const Vector2d distorted = ru > 0 ? Vector2d(undistorted * (rd / ru)) : undistorted;
  return {sx / dx_mm * distorted.x() + cx_px, distorted.y() / dy_mm + cy_px};
}

Vector3d RenderCamera::direction(const Vector2d& pixel) const {
  const Vector2d distorted(dx_mm / sx * (pixel.x() - cx_px), dy_mm * (pixel.y() - cy_px));
  const Vector2d undistorted = distorted * (1 + kappa1 * distorted.squaredNorm());
  return rotation.transpose() * Vector3d(undistorted.x(), undistorted.y(), f_mm);
}

std::vector<Vector3d> RenderTarget::world_mm() const {
  const double angle = turn_deg * std::numbers::pi / 180;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  std::vector<Vector3d> result;
  for (const Vector2d& p : spec.points_mm())
    result.emplace_back(c * p.x() - s * p.y() + shift_mm.x(), s * p.x() + c * p.y() + shift_mm.y(), z_mm);
  return result;
}

namespace {

/// How much of the foreground covers a spot of `size_mm` on the print.
class Print {
 public:
  explicit Print(const RenderTarget& target) : target_(target), points_(target.spec.points_mm()) {
    if (!target.print_error_mm.empty())
      for (std::size_t i = 0; i < points_.size(); ++i) points_[i] += target.print_error_mm[i];
    low_ = high_ = points_.front();
    for (const Vector2d& p : points_) {
      low_ = low_.cwiseMin(p);
      high_ = high_.cwiseMax(p);
    }
    if (target.spec.kind == TargetKind::chessboard) {
      low_.array() -= target.spec.pitch_mm;
      high_.array() += target.spec.pitch_mm;
    }
  }

  /// Distance inside the printed area, negative outside.
  double inside(const Vector2d& p) const {
    return std::min({p.x() - low_.x(), high_.x() - p.x(), p.y() - low_.y(), high_.y() - p.y()}) + target_.margin_mm;
  }

  double foreground(const Vector2d& p, double size_mm) const {
    const TargetSpec& spec = target_.spec;
    if (spec.kind == TargetKind::chessboard) return chessboard(p, size_mm);
    const double box = spec.box_mm();
    const int column =
        std::clamp(static_cast<int>(std::lround((p.x() - box / 2) / spec.pitch_mm)), 0, spec.columns - 1);
    const int row = std::clamp(static_cast<int>(std::lround((-p.y() - box / 2) / spec.pitch_mm)), 0, spec.rows - 1);
    const Vector2d* corners = &points_[(static_cast<std::size_t>(row) * spec.columns + column) * 4];
    double cover = 1;
    for (int i = 0; i < 4 && cover > 0; ++i) {
      const Vector2d side = corners[(i + 1) % 4] - corners[i];
      const Vector2d from = p - corners[i];
      cover *= std::clamp(0.5 + (side.x() * from.y() - side.y() * from.x()) / side.norm() / size_mm, 0.0, 1.0);
    }
    if (target_.hole && column == 0 && row == 0) {
      const double distance = (p - Vector2d(box / 2, -box / 2)).norm() - kHoleOverSide * spec.side_mm / 2;
      cover *= std::clamp(0.5 + distance / size_mm, 0.0, 1.0);
    }
    return cover;
  }

 private:
  /// Squares by the nearest corner: exact edges also when the print has errors, which move corners.
  double chessboard(const Vector2d& p, double size_mm) const {
    const TargetSpec& spec = target_.spec;
    const double x = p.x() / spec.pitch_mm;
    const double y = p.y() / spec.pitch_mm;
    if (x < -1.5 || y < -1.5 || x > spec.columns + 0.5 || y > spec.rows + 0.5) return 0;
    const int column = std::clamp(static_cast<int>(std::lround(x)), 0, spec.columns - 1);
    const int row = std::clamp(static_cast<int>(std::lround(y)), 0, spec.rows - 1);
    const Vector2d corner = points_[static_cast<std::size_t>(row) * spec.columns + column];
    const double ex = 2 * std::clamp(0.5 + (p.x() - corner.x()) / size_mm, 0.0, 1.0) - 1;
    const double ey = 2 * std::clamp(0.5 + (p.y() - corner.y()) / size_mm, 0.0, 1.0) - 1;
    double black = 0.5 + 0.5 * ((column + row) % 2 ? -1 : 1) * ex * ey;
    // The board ends one square beyond its outermost corners.
    black *= std::clamp(0.5 + (p.x() - (points_.front().x() - spec.pitch_mm)) / size_mm, 0.0, 1.0) *
             std::clamp(0.5 + (points_.back().x() + spec.pitch_mm - p.x()) / size_mm, 0.0, 1.0) *
             std::clamp(0.5 + (p.y() - (points_.front().y() - spec.pitch_mm)) / size_mm, 0.0, 1.0) *
             std::clamp(0.5 + (points_.back().y() + spec.pitch_mm - p.y()) / size_mm, 0.0, 1.0);
    return black;
  }

  const RenderTarget& target_;
  std::vector<Vector2d> points_;
  Vector2d low_, high_;
};

}  // namespace

GreyImage render_target(const RenderCamera& camera, const RenderTarget& target, const Imaging& imaging,
                        std::uint64_t seed, int supersampling) {
  const int k = supersampling;
  // The kernel, blur and pixel area together, falls to nothing within `reach` pixels.
  const int reach = static_cast<int>(std::ceil(imaging.fill_factor / 2 + 4 * imaging.blur_px + 0.5));
  const int taps = (2 * reach + 1) * k;
  std::vector<double> kernel(taps);
  double sum = 0;
  for (int i = 0; i < taps; ++i) {
    const double t = (i + 0.5) / k - (reach + 0.5);
    const Vector2d axis(1, 0);
    kernel[i] = edge_profile(t + 0.5 / k, axis, imaging.blur_px, imaging.fill_factor) -
                edge_profile(t - 0.5 / k, axis, imaging.blur_px, imaging.fill_factor);
    sum += kernel[i];
  }
  for (double& weight : kernel) weight /= sum;

  const Print print(target);
  const double paper = target.bright ? imaging.dark : imaging.bright;
  const double ink = target.bright ? imaging.bright : imaging.dark;
  const double angle = target.turn_deg * std::numbers::pi / 180;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Vector3d centre = camera.centre_mm();
  const int columns = (camera.width_px + 2 * reach) * k;
  const int rows = (camera.height_px + 2 * reach) * k;
  const double cell_mm_over_z = camera.dx_mm / camera.f_mm / k;

  // Row by row: filtered along x at once, along y into the rows of pixels that the row of places belongs to.
  GreyImage image(camera.width_px, camera.height_px);
  std::vector<double> places(columns);
  std::vector<double> filtered(camera.width_px);
  std::vector<double> result(image.pixels.size(), 0.0);
  for (int row = 0; row < rows; ++row) {
    const double v = (row + 0.5) / k - reach - 0.5;
    for (int column = 0; column < columns; ++column) {
      const double u = (column + 0.5) / k - reach - 0.5;
      const Vector3d direction = camera.direction({u, v});
      const double t = (target.z_mm - centre.z()) / direction.z();
      double value = target.outside;
      if (t > 0 && std::isfinite(t)) {
        const Vector3d hit = centre + t * direction;
        const Vector2d moved = hit.head<2>() - target.shift_mm;
        const Vector2d p(c * moved.x() + s * moved.y(), -s * moved.x() + c * moved.y());
        const double size = cell_mm_over_z * t * camera.f_mm;
        const double on_print = std::clamp(0.5 + print.inside(p) / size, 0.0, 1.0);
        if (on_print > 0) {
          const double cover = print.foreground(p, size);
          value = (1 - on_print) * target.outside + on_print * (paper + (ink - paper) * cover);
        }
      }
      places[column] = value;
    }
    for (int x = 0; x < camera.width_px; ++x) {
      double total = 0;
      const double* at = &places[static_cast<std::size_t>(x) * k];
      for (int i = 0; i < taps; ++i) total += kernel[i] * at[i];
      filtered[x] = total;
    }
    const int first = std::max(0, (row - taps + k) / k);
    for (int y = first; y < camera.height_px && y * k <= row; ++y) {
      const int tap = row - y * k;
      if (tap >= taps) continue;
      double* line = &result[static_cast<std::size_t>(y) * camera.width_px];
      for (int x = 0; x < camera.width_px; ++x) line[x] += kernel[tap] * filtered[x];
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) image.pixels[i] = static_cast<float>(result[i]);
  add_noise(image, imaging, seed);
  return image;
}

cv::Mat to_mat(const GreyImage& image) {
  cv::Mat result(image.height, image.width, CV_8U);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      result.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(std::clamp(std::lround(image(x, y)), 0L, 255L));
  return result;
}

TargetSpec thesis_target(TargetKind kind) {
  // 360 mm x 480 mm, six by eight: 60 mm from one to the next.
  return {kind, 8, 6, 33, 60};
}

RenderCamera thesis_camera(double kappa1) {
  RenderCamera camera;
  camera.kappa1 = kappa1;
  const double tilt_x = 9 * std::numbers::pi / 180;
  const double tilt_y = -7 * std::numbers::pi / 180;
  const double roll = 2.5 * std::numbers::pi / 180;
  camera.rotation = (Eigen::AngleAxisd(roll, Vector3d::UnitZ()) * Eigen::AngleAxisd(tilt_y, Vector3d::UnitY()) *
                     Eigen::AngleAxisd(tilt_x, Vector3d::UnitX()))
                        .toRotationMatrix();
  // The middle of the pattern, at the middle height of 50 mm, is 1 m away, a little off the axis.
  const TargetSpec spec = thesis_target(TargetKind::squares);
  const Vector3d middle(3.5 * spec.pitch_mm + spec.box_mm() / 2, -(2.5 * spec.pitch_mm + spec.box_mm() / 2), -50);
  camera.translation_mm = Vector3d(4, -6, 1000) - camera.rotation * middle;
  return camera;
}

}  // namespace horopter::calib
