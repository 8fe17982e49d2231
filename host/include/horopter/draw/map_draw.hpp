// SPDX-License-Identifier: Apache-2.0
// Pictures of mapping tables, and of how thick their skin is.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "horopter/draw/picture.hpp"
#include "horopter/map/map.hpp"

namespace horopter {

// Each of these has its title above, axes in pixels of the scan, and below the picture what its colours mean.

/// A table: unsupervised pixels dark, control points as dots. Colour is where the source lies, hue by direction and
/// strength by length of the displacement, a line every 8 pixels.
Picture draw_map(const MapTable& table, int weight_bits, const std::string& title);

/// Red at the thinnest to blue at the thickest by the logarithm, with lines at round values; dark where it is NaN. The
/// scale below is in mm.
struct ThicknessPicture {
  Picture picture;
  double thinnest_mm = 0;  ///< NaN without a supervised pixel
  double thickest_mm = 0;
};
/// The thickness of each pixel, row by row.
ThicknessPicture draw_thickness(int width, int height, std::span<const double> thickness_mm, const std::string& title);
/// The same for the pixels of a table's scan, with its control points.
ThicknessPicture draw_thickness(const MapTable& table, std::span<const double> thickness_mm, const std::string& title);

/// The smallest body that is found at each pixel (plan/capability.hpp), in the same colours; grey where it is infinite.
ThicknessPicture draw_bodies(int width, int height, std::span<const double> body_mm, const std::string& title);

/// Pictures of one width. Throws std::invalid_argument where they are not.
Picture one_below_other(const std::vector<Picture>& pictures);

}  // namespace horopter
