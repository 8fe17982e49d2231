// SPDX-License-Identifier: Apache-2.0
#include "horopter/skin/skin.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "horopter/calib/homography.hpp"

namespace horopter {
namespace {

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Pixels per unit when the condition of a matrix is judged: the size of images, so that translations and
/// rotations have comparable entries.
constexpr double kPixelScale = 1000;
/// Ratio of the smallest to the largest singular value below which a homography flattens the image to a line.
constexpr double kSingular = 1e-9;
/// The least calib::Homography::determined of a fit: below it, points do not determine a homography.
constexpr double kDegenerate = 1e-4;

bool is_singular(const RowMajor3& matrix) {
  const Eigen::Vector3d scale(kPixelScale, kPixelScale, 1);
  const RowMajor3 scaled = scale.cwiseInverse().asDiagonal() * matrix * scale.asDiagonal();
  const Eigen::Vector3d singular = Eigen::JacobiSVD<RowMajor3>(scaled).singularValues();
  return !(singular[2] > kSingular * singular[0]);
}

Matrix3 to_array(const RowMajor3& matrix) {
  Matrix3 array;
  std::copy_n(matrix.data(), 9, array.begin());
  return array;
}

/// A word for programs and a phrase for people, by Reason.
constexpr std::pair<std::string_view, std::string_view> kReasons[kReasonCount] = {
    {"supervised", "supervised"},
    {"outside", "outside the right image"},
    {"scale", "reduced to less than 1/2 in the right image"},
    {"angle", "seen too far from the skin's normal"},
    {"no_source", "without a skin in their line of sight"},
    {"hidden", "hidden from the right camera by a part of the skin"},
    {"row", "with an epipolar line that leaves the row"},
    {"grid", "lost to the grid"},
};

}  // namespace

std::string_view reason_name(Reason reason) { return kReasons[static_cast<std::size_t>(reason)].first; }
std::string_view reason_text(Reason reason) { return kReasons[static_cast<std::size_t>(reason)].second; }

std::optional<Point> Skin::source(Point left) const {
  Look seen;
  look({&left, 1}, 1, {}, {&seen, 1});
  if (!std::isfinite(seen.source.x) || !std::isfinite(seen.source.y)) return std::nullopt;
  return seen.source;
}

void HomographySkin::look(std::span<const Point> left, int row_step, const ViewLimits& limits,
                          std::span<Look> looks) const {
  for (std::size_t i = 0; i < left.size(); ++i) {
    const auto right = source(left[i]);
    looks[i] = {{std::nan(""), std::nan("")}, std::nanf(""), Reason::no_source};
    if (!right) continue;
    const auto [a, b, c, d] = derivatives(left[i]);
    const double scaled = largest_stretch({a, b * row_step, c / row_step, d}) * limits.smallest_scale;
    looks[i] = {*right, static_cast<float>(1 - scaled), scaled <= 1 + 1e-9 ? Reason::none : Reason::scale};
  }
}

HomographySkin::HomographySkin(const Matrix3& matrix, Point visible, std::string_view type)
    : matrix_(matrix), type_(type) {
  for (const double entry : matrix) {
    if (!std::isfinite(entry)) throw std::invalid_argument("the matrix is not finite");
  }
  if (is_singular(Eigen::Map<const RowMajor3>(matrix.data()))) {
    throw std::invalid_argument("the matrix is singular: it maps the image to a line or a point");
  }
  const double denominator = matrix[6] * visible.x + matrix[7] * visible.y + matrix[8];
  if (denominator < 0) std::ranges::transform(matrix_, matrix_.begin(), std::negate<>());
}

std::optional<Point> HomographySkin::source(Point left) const {
  const auto& h = matrix_;
  const double s = h[6] * left.x + h[7] * left.y + h[8];
  if (!(s > 0)) return std::nullopt;
  const Point right{(h[0] * left.x + h[1] * left.y + h[2]) / s, (h[3] * left.x + h[4] * left.y + h[5]) / s};
  if (!std::isfinite(right.x) || !std::isfinite(right.y)) return std::nullopt;
  return right;
}

std::array<double, 4> HomographySkin::derivatives(Point left) const {
  const auto& h = matrix_;
  const double s = h[6] * left.x + h[7] * left.y + h[8];
  const double x = (h[0] * left.x + h[1] * left.y + h[2]) / s;
  const double y = (h[3] * left.x + h[4] * left.y + h[5]) / s;
  return {(h[0] - x * h[6]) / s, (h[1] - x * h[7]) / s, (h[3] - y * h[6]) / s, (h[4] - y * h[7]) / s};
}

std::string HomographySkin::description() const {
  const auto& h = matrix_;
  return fmt::format("{} [[{:.6g}, {:.6g}, {:.6g}], [{:.6g}, {:.6g}, {:.6g}], [{:.6g}, {:.6g}, {:.6g}]]", type_, h[0],
                     h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8]);
}

void HomographySkin::look_around(std::span<const Point> left, std::span<Point> sources) const {
  std::ranges::transform(left, sources.begin(), [this](const Point& pixel) {
    return source(pixel).value_or(Point{std::nan(""), std::nan("")});
  });
}

HomographyFit fit_homography(std::span<const Correspondence> points) {
  if (points.size() < 4) {
    throw std::invalid_argument(fmt::format("{} points; a homography takes at least 4", points.size()));
  }
  std::vector<Eigen::Vector2d> left;
  std::vector<Eigen::Vector2d> right;
  for (const Correspondence& c : points) {
    for (const double value : {c.left.x, c.left.y, c.right.x, c.right.y}) {
      if (!std::isfinite(value)) throw std::invalid_argument("a point is not finite");
    }
    left.emplace_back(c.left.x, c.left.y);
    right.emplace_back(c.right.x, c.right.y);
  }
  const auto solved = calib::solve_homography(left, right);
  if (!solved) throw std::invalid_argument("all points are the same point");
  if (!(solved->determined > kDegenerate)) {
    throw std::invalid_argument("the points do not determine a homography: too many of them lie on one line");
  }
  RowMajor3 matrix = solved->matrix;
  matrix /= matrix.norm();
  if (std::abs(matrix(2, 2)) > 1e-9) matrix /= matrix(2, 2);
  if (is_singular(matrix)) throw std::invalid_argument("the points lie on a line in one of the images");

  HomographyFit fit;
  fit.matrix = to_array(matrix);
  const HomographySkin skin(fit.matrix, points.front().left);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Correspondence& c = points[i];
    const auto mapped = skin.source(c.left);
    if (!mapped) throw std::invalid_argument("the horizon of the fitted plane runs between the points");
    const double distance = std::hypot(mapped->x - c.right.x, mapped->y - c.right.y);
    sum += distance * distance;
    if (distance <= fit.largest_px) continue;
    fit.largest_px = distance;
    fit.worst = i;
  }
  fit.rms_px = std::sqrt(sum / static_cast<double>(points.size()));
  return fit;
}

std::vector<double> fit_deviations_px(std::span<const Correspondence> points, std::span<const Point> left,
                                      double point_px) {
  std::vector<Correspondence> moved(points.begin(), points.end());
  const auto sources = [&] {
    std::vector<Point> all(left.size(), {std::nan(""), std::nan("")});
    try {
      HomographySkin(fit_homography(moved).matrix, points.front().left).look_around(left, all);
    } catch (const std::invalid_argument&) {
      // Its points determine nothing any more.
    }
    return all;
  };
  const std::vector<Point> unmoved = sources();
  std::vector<Eigen::Array2d> squares(left.size(), Eigen::Array2d::Zero());
  for (Correspondence& c : moved) {
    for (double* coordinate : {&c.right.x, &c.right.y}) {
      const double before = std::exchange(*coordinate, *coordinate + point_px);
      const std::vector<Point> all = sources();
      *coordinate = before;
      for (std::size_t i = 0; i < left.size(); ++i) {
        squares[i] += Eigen::Array2d(all[i].x - unmoved[i].x, all[i].y - unmoved[i].y).square();
      }
    }
  }
  std::vector<double> deviations;
  for (const Eigen::Array2d& square : squares) {
    deviations.push_back(square.isNaN().any() ? std::numeric_limits<double>::infinity() : std::sqrt(square.maxCoeff()));
  }
  return deviations;
}

}  // namespace horopter
