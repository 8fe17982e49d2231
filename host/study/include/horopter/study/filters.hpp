// SPDX-License-Identifier: Apache-2.0
// Filters before and after the correlation (thesis 8.1, 8.4.3, 8.4.5). Results are not rounded. Beyond the image its
// last pixels go on; whoever measures leaves out what a filter reaches.
#pragma once

#include "horopter/image/image.hpp"
#include "horopter/study/raster.hpp"

namespace horopter::study {

Plane to_plane(const Image& image);

/// 3×3 [1 2 1]ᵀ[1 2 1] / 16 (eq. 10.2).
Plane lowpass(const Plane& image);
/// 3×3 zero-mean Laplacian (eq. 8.4).
Plane highpass(const Plane& image);
/// Median of 3×3.
Plane median(const Plane& image);

/// Gaussian of a standard deviation in px, as far as 4 of them.
Plane gaussian(const Plane& image, double deviation_px);

/// Half of the side of log_filter's window, for w of 1 px at least.
int log_reach(double w);
/// Laplacian of Gaussian (eq. 8.7): weights (1 − a)·e^(−a), a = 4(i² + j²) / w², less their mean over the window of
/// 2·log_reach(w) + 1 px; w is the diameter of its middle in px.
Plane log_filter(const Plane& image, double w);
/// +1 where the filter's result is at least 0, else −1 (8.1.4).
Plane log_sign(const Plane& image, double w);

/// The same of a difference of two Gaussians, of the narrower one less the wider one of 1.6 times its deviation: the
/// Laplacian of a Gaussian nearly, whose middle has the same diameter.
Plane dog_sign(const Plane& image, double w);
/// Half of the side of its window.
int dog_reach(double w);

/// +1 where Roberts' gradient (the sum of the absolute differences along both diagonals of 2×2 pixels) is above its mean
/// in 9×9 pixels, else −1.
Plane roberts_sign(const Plane& image);
constexpr int kRobertsReach = 5;  ///< of roberts_sign, px

/// Gradients by Sobel's operator (eq. 10.3), 8 per grey level and pixel.
struct Gradient {
  Plane x, y;
};
Gradient sobel(const Plane& image);

/// Direction of Sobel's gradient in turns, −½ … ½, 0 along +x; NaN where the gradient is 0.
Plane sobel_direction(const Plane& image);

/// Sum over size × size, by running sums; 0 where the window leaves the image.
Plane box_sum(const Plane& image, int size);

}  // namespace horopter::study
