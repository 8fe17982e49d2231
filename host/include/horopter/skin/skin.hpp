// SPDX-License-Identifier: Apache-2.0
// Skins: where in the right image the left camera's pixels would be seen if everything lay on the skin.
//
// Coordinates are pixels of full frames, before fields and sub-sampling; (0, 0) is the centre of the first pixel.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/image/scan.hpp"

namespace horopter {

struct Correspondence {
  Point left;
  Point right;
};

/// Why a left pixel is not supervised (T9), or that it is.
enum class Reason : std::uint8_t {
  none,       ///< it is supervised
  outside,    ///< the source lies outside the right image
  scale,      ///< reduced to less than 1/2: source pixels would be skipped (thesis 7.5)
  angle,      ///< a line of sight lies too far from the skin's normal (thesis 11.1, 11.2.2)
  no_source,  ///< the line of sight does not meet the skin
  hidden,     ///< a part of the skin stands between it and the right camera
  row,        ///< its epipolar line leaves the row within the shifts of the neighbours that compete
  grid,       ///< lost to the grid: a control point of its cell has no source
};
inline constexpr int kReasonCount = 8;
/// As in reports: a word for programs, and a phrase for people.
std::string_view reason_name(Reason reason);
std::string_view reason_text(Reason reason);

/// What makes a pixel unsupervised though it has a source.
struct ViewLimits {
  double smallest_scale = 0.5;    ///< left pixels per source pixel, in the direction of the strongest reduction
  double largest_angle_deg = 70;  ///< between a line of sight, of either camera, and the skin's normal
  /// Of the neighbours that compete with the skin, px along the row, either way; 0: there are none. They are the skin's
  /// image shifted, so they are parallel skins only where the left image's epipolar line stays within half a row. Needs
  /// a rig: skins without one are not looked at for it.
  int largest_shift_px = 0;
};
inline constexpr double kLargestRowError = 0.5;  ///< in rows of the scan

/// Of the left pixels with a source in the right image and within all other limits: at how many the epipolar line
/// leaves the row.
struct RowCount {
  std::int64_t leaving = 0;
  std::int64_t staying = 0;

  void add(Reason reason) {
    leaving += reason == Reason::row ? 1 : 0;
    staying += reason == Reason::none ? 1 : 0;
  }
  /// 0 of no pixels.
  double share() const {
    return static_cast<double>(leaving) / static_cast<double>(std::max<std::int64_t>(1, leaving + staying));
  }
};

/// What a left pixel sees of the skin.
struct Look {
  Point source;                       ///< in the right image; NaN where there is none
  float margin = 0;                   ///< smooth, negative beyond the limits of angle and scale; NaN without a source
  Reason reason = Reason::no_source;  ///< `outside` only where no pixel of an unlimited right image is the source
};

class Skin {
 public:
  virtual ~Skin() = default;
  /// What left pixels see. `row_step` is that of the scan, in which scale is judged.
  virtual void look(std::span<const Point> left, int row_step, const ViewLimits& limits,
                    std::span<Look> looks) const = 0;
  /// Sources of left pixels that are not supervised, for comparing what both cameras see around the skin: on the skin
  /// where the line of sight meets it, else on what continues it. NaN where there is none.
  virtual void look_around(std::span<const Point> left, std::span<Point> sources) const = 0;
  virtual std::string_view type() const = 0;
  /// One line for reports.
  virtual std::string description() const = 0;

  /// Source of one left pixel, whatever its angle and scale.
  std::optional<Point> source(Point left) const;
};

/// Largest singular value of the derivatives {∂x/∂left.x, ∂x/∂left.y, ∂y/∂left.x, ∂y/∂left.y} of a source: source
/// pixels per left pixel in the direction of the strongest reduction.
inline double largest_stretch(const std::array<double, 4>& derivatives) {
  const auto [a, b, c, d] = derivatives;
  const double sum = a * a + b * b + c * c + d * d;
  const double determinant = a * d - b * c;
  return std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4 * determinant * determinant))));
}

/// Row by row; left pixel → right pixel (thesis eq. 7.20).
using Matrix3 = std::array<double, 9>;

class HomographySkin : public Skin {
 public:
  /// `visible` is a left pixel that does see the skin: it decides which side of the horizon counts.
  /// Throws std::invalid_argument for a matrix that is singular or not finite.
  explicit HomographySkin(const Matrix3& matrix, Point visible = {}, std::string_view type = "homography");
  void look(std::span<const Point> left, int row_step, const ViewLimits& limits, std::span<Look> looks) const override;
  void look_around(std::span<const Point> left, std::span<Point> sources) const override;
  /// Nothing beyond the horizon.
  std::optional<Point> source(Point left) const;
  /// Partial derivatives of source: {∂x/∂left.x, ∂x/∂left.y, ∂y/∂left.x, ∂y/∂left.y}.
  std::array<double, 4> derivatives(Point left) const;
  std::string_view type() const override { return type_; }
  std::string description() const override;
  const Matrix3& matrix() const { return matrix_; }

 private:
  Matrix3 matrix_;  ///< scaled so that the denominator is positive on the visible side
  std::string_view type_;
};

struct HomographyFit {
  Matrix3 matrix{};
  double rms_px = 0;  ///< distance between mapped left points and right points
  double largest_px = 0;
  std::size_t worst = 0;  ///< the point of the largest distance
};

/// By calib::solve_homography, ≥ 4 points. Throws std::invalid_argument for too few points,
/// non-finite ones, or points that do not determine a homography (all but one on a line).
HomographyFit fit_homography(std::span<const Correspondence> points);
/// Standard deviation of the sources of left pixels, along x or y, whichever is larger, when that of each coordinate of the
/// right points is `point_px`; infinite where an error of that size leaves no source. For points that have a fit.
std::vector<double> fit_deviations_px(std::span<const Correspondence> points, std::span<const Point> left,
                                      double point_px);

}  // namespace horopter
