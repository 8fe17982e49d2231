// SPDX-License-Identifier: Apache-2.0
// The estimators of edges, one function for each, and what they share.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "horopter/calib/edge.hpp"

namespace horopter::calib::detail {

using Estimator = std::unique_ptr<EdgeEstimator>;

// On a profile along x or y, or over a circle, by moments.
Estimator make_tabatabai_1d(int window_px, bool two_windows);
Estimator make_tabatabai_2d(bool two_windows);
Estimator make_zernike(EdgeMethod method, int window_px, bool two_windows);

// By a curve through the pixels near the edge.
Estimator make_linear(int window_px);
Estimator make_polynomial(int window_px);
Estimator make_sigmoid(int window_px);
Estimator make_arctangent(int window_px);
Estimator make_spline(int window_px);
Estimator make_maximum_likelihood(int window_px, double blur_px, double fill_factor);
Estimator make_gaussian(int window_px, double sigma_px);

/// Less contrast than this is no edge: a window of camera noise (1 to 2 grey levels) must not look like one.
constexpr double kLeastContrast = 4;

/// An estimator that reads a profile along x or y, whichever is nearer to the normal.
class AxisEstimator : public EdgeEstimator {
 protected:
  using EdgeEstimator::EdgeEstimator;
  /// Position of the edge of a profile, dark to bright, in pixels from its middle sample.
  virtual std::optional<double> position(std::span<const double> profile, double& contrast) const = 0;

 private:
  std::optional<Local> local(const GreyImage& image, Centre centre, const Eigen::Vector2d& normal) const final;
};

}  // namespace horopter::calib::detail
