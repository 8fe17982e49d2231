// SPDX-License-Identifier: Apache-2.0
// Simulated edges (thesis 6.7.1): an ideal step, blurred by a Gaussian, integrated over the sensitive area of square
// pixels (6.34), in closed form for every direction of the edge.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "horopter/calib/grey_image.hpp"

namespace horopter::calib {

/// What a pixel sees of a step from 0 to 1: `t_px` is the pixel's distance from the edge, positive on the bright side,
/// `normal` the unit vector across the edge, `blur_px` the standard deviation of the blur (> 0), `fill_factor` the side
/// of the sensitive square, 0 to 1.
double edge_profile(double t_px, const Eigen::Vector2d& normal, double blur_px, double fill_factor);

struct Imaging {
  double blur_px = 0.5;
  double fill_factor = 0.85;
  double dark = 40;
  double bright = 200;
  double noise = 0;       ///< standard deviation, grey levels
  double jitter_px = 0;   ///< standard deviation of a line's start, independent in each line (thesis 6.7.2)
  bool quantise = false;  ///< rounded and limited to 0…255
};

/// An edge through `point_px`, bright where (p − point) · normal > 0.
GreyImage simulate_edge(int width, int height, const Eigen::Vector2d& point_px, const Eigen::Vector2d& normal,
                        const Imaging& imaging, std::uint64_t seed = 0);

/// A bright square turned by `angle_deg` (45: a diamond). Exact except within some blur of its corners, where the
/// product of both edge profiles stands for the integral of their product.
GreyImage simulate_square(int width, int height, const Eigen::Vector2d& centre_px, double side_px, double angle_deg,
                          const Imaging& imaging, std::uint64_t seed = 0);

/// Its corners: top left, top right, bottom right, bottom left before it was turned.
Eigen::Matrix<double, 2, 4> square_corners(const Eigen::Vector2d& centre_px, double side_px, double angle_deg);

/// Noise and rounding as of `imaging`, added to an image.
void add_noise(GreyImage& image, const Imaging& imaging, std::uint64_t seed);

}  // namespace horopter::calib
