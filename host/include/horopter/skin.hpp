// SPDX-License-Identifier: Apache-2.0
// Skins: where in the right image the left camera's pixels would be seen if everything lay on the skin.
//
// Coordinates are pixels of full frames, before fields and sub-sampling; (0, 0) is the centre of the first pixel.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace horopter {

struct Point {
  double x = 0;
  double y = 0;
};

struct Correspondence {
  Point left;
  Point right;
};

class Skin {
 public:
  virtual ~Skin() = default;
  /// Source of a left pixel in the right image; nothing where the skin has none (beyond the horizon).
  virtual std::optional<Point> source(Point left) const = 0;
  /// Partial derivatives of source: {∂x/∂left.x, ∂x/∂left.y, ∂y/∂left.x, ∂y/∂left.y}.
  virtual std::array<double, 4> derivatives(Point left) const = 0;
  virtual std::string_view type() const = 0;
  /// One line for reports.
  virtual std::string description() const = 0;
};

/// Row by row; left pixel → right pixel (thesis 7.20).
using Matrix3 = std::array<double, 9>;

class HomographySkin : public Skin {
 public:
  /// `visible` is a left pixel that does see the skin: it decides which side of the horizon counts.
  /// Throws std::invalid_argument for a matrix that is singular or not finite.
  explicit HomographySkin(const Matrix3& matrix, Point visible = {}, std::string_view type = "homography");
  std::optional<Point> source(Point left) const override;
  std::array<double, 4> derivatives(Point left) const override;
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
};

/// Least squares in coordinates normalised after Hartley, ≥ 4 points. Throws std::invalid_argument for too few points,
/// non-finite ones, or points that do not determine a homography (all but one on a line).
HomographyFit fit_homography(std::span<const Correspondence> points);

/// A skin as read from skin.yaml.
struct SkinFile {
  std::unique_ptr<Skin> skin;
  std::string path;
  std::vector<Correspondence> correspondences;  ///< those given in the file, if any
  std::optional<HomographyFit> fit;
};

/// Types today: homography (`matrix`, 3×3) and correspondences (`points`, a list of `{left: [x, y], right: [x, y]}`).
/// `centre` is the centre of the left image; a homography is used on that side of its horizon.
/// Throws FileError with the line.
SkinFile load_skin(const std::filesystem::path& path, Point centre);

}  // namespace horopter
