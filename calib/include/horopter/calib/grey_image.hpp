// SPDX-License-Identifier: Apache-2.0
// The image that sub-pixel estimators read: one float per pixel, (0, 0) the centre of the first pixel. Grey levels
// keep the scale of the 8-bit image they come from (0 to 255); simulated ones need not be whole numbers.
#pragma once

#include <cstddef>
#include <vector>

namespace horopter::calib {

struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;  ///< row by row, no padding

  GreyImage() = default;
  GreyImage(int columns, int rows, float value = 0)
      : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * rows, value) {}
  float& operator()(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  float operator()(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

}  // namespace horopter::calib
