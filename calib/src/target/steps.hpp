// SPDX-License-Identifier: Apache-2.0
// Steps of target localisation, not part of the interface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "horopter/calib/target.hpp"

namespace horopter::calib::detail {

/// "9x6".
inline std::string size_text(int columns, int rows) { return std::to_string(columns) + "x" + std::to_string(rows); }

/// A convex quadrilateral that stands out from what surrounds it.
struct Quad {
  std::array<Eigen::Vector2d, 4> corners;  ///< clockwise in the image (y down)
  Eigen::Vector2d centre;
  double side_px = 0;           ///< mean side
  double contrast = 0;          ///< inside minus outside, grey levels
  bool touches_border = false;  ///< cut off by the image border, so that one of its sides is not seen
};
std::vector<Quad> find_quads(const cv::Mat& grey);

/// Quads that are neighbours at the pitch of the spec, with their place in a common grid.
struct GridCell {
  int quad = -1;     ///< index into the quads
  int x = 0, y = 0;  ///< place; x and y turn clockwise in the image like its axes
  int first = 0;     ///< which of the quad's corners is the first of the spec's fiducial (squares: top left)
};
/// The largest such group. Dark and bright quads never mix.
std::vector<GridCell> link_grid(const std::vector<Quad>& quads, TargetKind kind, double pitch_over_side);

/// `Homography::determined` at and below which points lie on a line.
inline constexpr double kOnALine = 1e-8;

/// A plane seen by a pinhole with one radial term: homography from the plane to undistorted pixels, then
/// u = c + (d − c) / (1 + λ |d − c|² / R²), the division model, with c the middle of the image and R half its diagonal.
struct PlaneView {
  Eigen::Matrix3d homography = Eigen::Matrix3d::Identity();
  double lambda = 0;
  Eigen::Vector2d middle{0, 0};
  double radius = 1;

  Eigen::Vector2d project(const Eigen::Vector2d& plane) const { return distort(undistorted(plane)); }
  Eigen::Vector2d undistorted(const Eigen::Vector2d& plane) const;
  Eigen::Vector2d distort(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d undistort(const Eigen::Vector2d& pixel) const;
  /// Pixels per unit of the plane, in x and y of the plane.
  Eigen::Matrix2d jacobian(const Eigen::Vector2d& plane) const;
};
/// How a corner moves when each edge at it moves outwards by nᵀ S n, where n is the edge's outward normal in the image
/// and S a symmetric matrix: px per unit of Sxx, Sxy and Syy, a column each.
using Spread = Eigen::Matrix<double, 2, 3>;
struct PlaneFit {
  PlaneView view;
  Eigen::Vector3d spread{0, 0, 0};  ///< xx, xy, yy, px
  double rms_px = 0;
  std::vector<double> residual_px;
};
/// Nothing for fewer than 4 points or points on a line. λ is fitted when there are 12 points or more. With `spreads`,
/// one for each point, λ and the displacement of the edges are fitted.
std::optional<PlaneFit> fit_plane(std::span<const Eigen::Vector2d> plane, std::span<const Eigen::Vector2d> pixels,
                                  int width, int height, std::span<const Spread> spreads = {});

TargetView detect_chessboard(const cv::Mat& grey, const TargetSpec& spec);

/// A corner of a chessboard: the product of two blurred edges, fitted to the pixels within `half_px` of the guess.
struct Saddle {
  Eigen::Vector2d position_px;
  /// Half of white minus black. Positive when the quadrant between the directions x and y is white.
  double amplitude;
  double rms;  ///< of the fit, grey levels
};
std::optional<Saddle> fit_saddle(const GreyImage& image, const Eigen::Vector2d& guess_px,
                                 const Eigen::Vector2d& along_x, const Eigen::Vector2d& along_y, double half_px);

}  // namespace horopter::calib::detail
