// SPDX-License-Identifier: Apache-2.0
// What may follow the threshold: the morphological operators of 5.2. Binary images hold 0 and 1. Beyond the image its
// last pixels go on.
#pragma once

#include <string>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/study/raster.hpp"

namespace horopter::study {

/// Largest and smallest of (2k+1)×(2k+1) grey values (eq. 5.1, 5.2).
Image dilation(const Image& image, int k);
Image erosion(const Image& image, int k);
/// Erosion before dilation: removes what is smaller than the window. And the other way round: fills it.
Image opening(const Image& image, int k);
Image closing(const Image& image, int k);

/// Clusterlet elimination (eq. 5.3): where all pixels of the border of (2e+1)×(2e+1) have a value (u0, 0 or 1), those
/// inside get it. Of a binary image; windows lie around its pixels.
Image eliminate_clusterlets(const Image& image, int e, int value);

/// 1 where more than half of (2k+1)×(2k+1) pixels are (eq. 5.4). Of a binary image.
Image majority(const Image& image, int k);

/// Binarisation with hysteresis: 1 where values are at least `high`, and where they are at least `low` and touch, over
/// others that are, a place of `high`. Neighbours are the 8 around a pixel. NaN is below everything.
Image hysteresis(const Plane& values, double low, double high);

/// One of them with its size, as the studies compare them.
struct Operator {
  std::string name;
  Image (*apply)(const Image& image, int size);
  int size;  ///< k or e
};
/// Of binary images, in the thesis's order, each in a few sizes.
const std::vector<Operator>& binary_operators();

}  // namespace horopter::study
