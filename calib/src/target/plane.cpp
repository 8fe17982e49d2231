// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/least_squares.hpp"
#include "horopter/calib/homography.hpp"
#include "target/steps.hpp"

namespace horopter::calib::detail {

using Eigen::Matrix3d;
using Eigen::Vector2d;

namespace {

/// The division model solved for d: the factor from u − c to d − c, where |u − c|² / R² is `squared_radius`. Beyond the
/// turning point of the model its edge is used: a fit in progress must not meet a NaN.
template <class T>
T distortion_factor(const T& lambda, const T& squared_radius) {
  using std::sqrt;
  const T square = 1.0 - 4.0 * lambda * squared_radius;
  return 2.0 / (1.0 + (square > 0.0 ? T(sqrt(square)) : T(0.0)));
}

}  // namespace

Vector2d PlaneView::undistorted(const Vector2d& plane) const {
  const Eigen::Vector3d p = homography * Eigen::Vector3d(plane.x(), plane.y(), 1);
  return p.head<2>() / p.z();
}

Vector2d PlaneView::distort(const Vector2d& pixel) const {
  const Vector2d d = (pixel - middle) / radius;
  return middle + (pixel - middle) * distortion_factor(lambda, d.squaredNorm());
}

Vector2d PlaneView::undistort(const Vector2d& pixel) const {
  const Vector2d d = (pixel - middle) / radius;
  return middle + (pixel - middle) / (1 + lambda * d.squaredNorm());
}

Eigen::Matrix2d PlaneView::jacobian(const Vector2d& plane) const {
  const double h = 1e-3 * std::max(1.0, plane.cwiseAbs().maxCoeff());
  Eigen::Matrix2d result;
  result.col(0) = (project(plane + Vector2d(h, 0)) - project(plane - Vector2d(h, 0))) / (2 * h);
  result.col(1) = (project(plane + Vector2d(0, h)) - project(plane - Vector2d(0, h))) / (2 * h);
  return result;
}

namespace {

/// Limits of λ. Up to 0.24 the model has an inverse in the whole image.
constexpr double kLeastLambda = -1;
constexpr double kGreatestLambda = 0.24;
/// With fewer points than this, λ is 0.
constexpr std::size_t kPointsForLambda = 12;

/// Distances between predicted and measured corners, px. Parameters: the homography between normalised coordinates,
/// whose last element is 1; λ; the displacement of the edges (Sxx, Sxy, Syy).
struct CornerResiduals {
  static constexpr int kParameters = 12, kLambda = 8, kSpread = 9;

  const PlaneView& frame;  ///< gives the middle and the radius of the image
  Matrix3d to_plane;       ///< normalises the points of the plane
  Matrix3d from_image;     ///< from normalised coordinates to pixels
  std::span<const Vector2d> plane, pixels;
  std::span<const Spread> spreads;  ///< none: edges stay where they are
  double pull = 0;                  ///< of the displacement towards 0

  int NumResiduals() const { return 2 * static_cast<int>(plane.size()) + 3; }

  template <class T>
  bool operator()(const T* p, T* residuals) const {
    using Vector = Eigen::Matrix<T, 2, 1>;
    Eigen::Matrix<T, 3, 3> homography;
    homography << p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], T(1.0);
    homography = (from_image.cast<T>() * homography * to_plane.cast<T>()).eval();
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> spread(p + kSpread);
    for (std::size_t i = 0; i < plane.size(); ++i) {
      const Vector from_middle =
          (homography * plane[i].homogeneous().cast<T>()).eval().hnormalized() - frame.middle.cast<T>();
      const T squared_radius = from_middle.squaredNorm() / (frame.radius * frame.radius);
      Vector residual =
          frame.middle.cast<T>() + from_middle * distortion_factor(p[kLambda], squared_radius) - pixels[i].cast<T>();
      if (!spreads.empty()) residual += spreads[i].cast<T>() * spread;
      residuals[2 * i] = residual.x();
      residuals[2 * i + 1] = residual.y();
    }
    for (int i = 0; i < 3; ++i) residuals[2 * plane.size() + i] = pull * p[kSpread + i];
    return true;
  }
};

}  // namespace

std::optional<PlaneFit> fit_plane(std::span<const Vector2d> plane, std::span<const Vector2d> pixels, int width,
                                  int height, std::span<const Spread> spreads) {
  const auto start = solve_homography(plane, pixels);
  if (!start || !(start->determined > kOnALine)) return std::nullopt;
  const std::size_t n = plane.size();
  PlaneFit fit;
  fit.view.middle = Vector2d((width - 1) / 2.0, (height - 1) / 2.0);
  fit.view.radius = std::hypot(width, height) / 2;

  CornerResiduals corners{fit.view, *normalisation(plane), normalisation(pixels)->inverse(), plane, pixels, spreads};
  // The corners of diamonds tell only the sum of Sxx and Syy. A weak pull towards 0 decides the rest.
  if (!spreads.empty()) corners.pull = 0.02 * std::sqrt(static_cast<double>(n));
  Matrix3d h = corners.from_image.inverse() * start->matrix * corners.to_plane.inverse();
  if (std::abs(h(2, 2)) < 1e-12 * h.norm()) return std::nullopt;
  h /= h(2, 2);
  Eigen::Matrix<double, CornerResiduals::kParameters, 1> p;
  p << h(0, 0), h(0, 1), h(0, 2), h(1, 0), h(1, 1), h(1, 2), h(2, 0), h(2, 1), 0, 0, 0, 0;
  const bool lambda_free = n >= kPointsForLambda || !spreads.empty();
  const double low = lambda_free ? kLeastLambda : 0, high = lambda_free ? kGreatestLambda : 0;
  minimise(corners, {CornerResiduals::kLambda, low, high}, p);

  Eigen::VectorXd residuals(corners.NumResiduals());
  corners(p.data(), residuals.data());
  if (!residuals.allFinite()) return std::nullopt;
  h << p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], 1;
  fit.view.homography = corners.from_image * h * corners.to_plane;
  fit.view.lambda = p[CornerResiduals::kLambda];
  fit.spread = p.tail<3>();
  fit.rms_px = std::sqrt(residuals.head(2 * n).squaredNorm() / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) fit.residual_px.push_back(residuals.segment<2>(2 * i).norm());
  return fit;
}

}  // namespace horopter::calib::detail
