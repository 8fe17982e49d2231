// SPDX-License-Identifier: Apache-2.0
// Pictures of mapping tables, and of how thick their skin is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "horopter/map/map.hpp"

namespace horopter {

/// Picture of a table, width × height of its scan: unsupervised pixels dark, control points as dots. Colour is where
/// the source lies, hue by direction and strength by length of the displacement, a line every 8 pixels. Interleaved
/// blue, green, red.
std::vector<std::uint8_t> draw_map(const MapTable& table, int weight_bits);

/// Red at the thinnest to blue at the thickest, a line every 2^(1/4) of it; dark where it is NaN.
struct ThicknessPicture {
  std::vector<std::uint8_t> bgr;
  double thinnest_mm = 0;  ///< NaN without a supervised pixel
  double thickest_mm = 0;
};
/// The thickness of each pixel, row by row.
ThicknessPicture draw_thickness(int width, int height, std::span<const double> thickness_mm);
/// The same for the pixels of a table's scan, with its control points.
ThicknessPicture draw_thickness(const MapTable& table, std::span<const double> thickness_mm);

}  // namespace horopter
