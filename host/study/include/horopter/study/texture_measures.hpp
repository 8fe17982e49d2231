// SPDX-License-Identifier: Apache-2.0
// Measures of how much texture there is at a pixel (thesis 9.1, Table 9.1), before any scale factor.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "horopter/study/raster.hpp"

namespace horopter::study {

/// Standard deviation in size × size pixels (9.1), size odd.
Plane deviation_in_window(const Plane& image, int size);

using Mask = std::array<double, 9>;  ///< row by row
/// Sum of mask times the pixels at its places around each pixel.
Plane correlate(const Plane& image, const Mask& mask);
/// Absolute values, added.
Plane sum_of_two(const Plane& image, const Mask& one, const Mask& two);
/// Largest of the mask's eight turns by 45°: a compass operator.
Plane compass(const Plane& image, const Mask& mask);

struct TextureMeasure {
  std::string name;
  Plane (*of)(const Plane& image);
};
/// The rows of Table 9.1.
const std::vector<TextureMeasure>& texture_measures();

}  // namespace horopter::study
