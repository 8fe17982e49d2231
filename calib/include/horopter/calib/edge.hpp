// SPDX-License-Identifier: Apache-2.0
// Sub-pixel positions of straight edges (thesis 6.6): every estimator behind one interface, lines through several
// points of an edge, and corners where two lines meet.
//
// All estimators work on a window around the pixel nearest to the guess, and move the window once more when the edge
// turns out to lie nearer to another pixel. They are invariant to offset and contrast. The ones that assume an ideal
// step (Tabatabai-Mitchell, Zernike) pull a blurred edge towards the centre of their window; `two_windows` removes
// that.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/calib/grey_image.hpp"

namespace horopter::calib {

enum class EdgeMethod {
  linear,              ///< 6.6.1, crossing of the mean level on a profile along x or y
  tabatabai_1d,        ///< 6.26, three grey-level moments of a profile along x or y
  tabatabai_2d,        ///< 6.28, the same over the 69 pixels of a circle
  zernike_9,           ///< 6.30, window 9x9
  zernike_13,          ///< 6.30, window 13x13
  gaussian,            ///< 6.6.3, centre of mass of the derivative of the reconstructed profile
  polynomial,          ///< 6.22, degree 3
  sigmoid,             ///< 6.23
  arctangent,          ///< 6.24, with an offset
  spline,              ///< cubic smoothing spline
  maximum_likelihood,  ///< 6.33, edge of known blur
};

/// All of them, in the order above.
std::span<const EdgeMethod> all_edge_methods();
/// "linear", "tabatabai-1d", … as the command line and the tables call them.
std::string_view edge_method_name(EdgeMethod method);

struct EdgeOptions {
  int window_px = 0;          ///< width of the window, odd; 0: 9 for tabatabai-2d and zernike-9, else 13
  double sigma_px = 0.7;      ///< of the Gaussian reconstruction function (6.25)
  double blur_px = 0.5;       ///< standard deviation of the blur that maximum likelihood takes as known
  double fill_factor = 0.85;  ///< side of a pixel's sensitive area, likewise
  /// Moment methods only: a second window one pixel beyond the edge; what the two agree on has no bias towards the
  /// centre of a window, to first order. The noise grows by less than a tenth.
  bool two_windows = false;
};

struct EdgePoint {
  Eigen::Vector2d position_px;  ///< a point on the edge
  Eigen::Vector2d normal;       ///< unit vector towards the brighter side, as estimated or (1-D, fits) as given
  double contrast = 0;          ///< bright minus dark level, as the method sees it; > 0
};

class EdgeEstimator {
 public:
  virtual ~EdgeEstimator() = default;

  /// The point of the edge near `guess_px` (within about a quarter of the window). `normal`: unit vector across the
  /// edge towards the brighter side; within about 20° for the methods that estimate it, 2° for those that do not.
  /// Nothing when the window leaves the image, or what is in it is no such edge.
  std::optional<EdgePoint> estimate(const GreyImage& image, const Eigen::Vector2d& guess_px,
                                    const Eigen::Vector2d& normal) const;

  EdgeMethod method() const { return method_; }
  /// Pixels farther than this from the guess have no influence.
  double reach_px() const { return window_px_ / 2.0 + 1.5; }
  int window_px() const { return window_px_; }

 protected:
  EdgeEstimator(EdgeMethod method, int window_px, bool two_windows)
      : method_(method), window_px_(window_px), two_windows_(two_windows) {}

  struct Centre {
    int x, y;
  };
  /// `offset_px` is a point on the edge relative to the centre pixel.
  struct Local {
    Eigen::Vector2d offset_px, normal;
    double contrast;
  };
  /// The window lies inside the image.
  virtual std::optional<Local> local(const GreyImage& image, Centre centre, const Eigen::Vector2d& normal) const = 0;

 private:
  EdgeMethod method_;
  int window_px_;
  bool two_windows_;
};

/// Throws std::invalid_argument for a window that is even or below 5 pixels (Tabatabai-Mitchell 2-D: other than 9).
std::unique_ptr<EdgeEstimator> make_edge_estimator(EdgeMethod method, const EdgeOptions& options = {});

/// A line as the points p with normal · p = distance.
struct Line {
  Eigen::Vector2d normal{1, 0};  ///< unit vector
  double distance_px = 0;
  double rms_px = 0;  ///< of the points it was fitted to
  int points = 0;
};

/// Least squares of the distances across the line; points farther than 3 robust deviations (and 0.1 px) are dropped.
/// Nothing for less than two different points.
std::optional<Line> fit_line(std::span<const Eigen::Vector2d> points_px);
/// Nothing when the lines are within half a degree of parallel.
std::optional<Eigen::Vector2d> intersect(const Line& a, const Line& b);

/// Estimates at `count` equally spaced places of the segment from a to b, leaving out `margin_px` at both ends, so that
/// the corners have no influence. Places where the estimator finds no edge are missing from the result.
std::vector<EdgePoint> edge_points(const GreyImage& image, const EdgeEstimator& estimator, const Eigen::Vector2d& a_px,
                                   const Eigen::Vector2d& b_px, const Eigen::Vector2d& normal, int count,
                                   double margin_px);

}  // namespace horopter::calib
