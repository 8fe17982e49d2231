// SPDX-License-Identifier: Apache-2.0
// Ground truth of rectified pairs: the left pixel (x, y) is seen at the right (x − d, y).
#pragma once

#include <filesystem>
#include <vector>

namespace horopter {

struct DisparityMap {
  int width = 0;
  int height = 0;
  std::vector<float> px;  ///< of the left pixels, row by row; NaN = unknown

  float at(int x, int y) const { return px[static_cast<std::size_t>(y) * width + x]; }
};

/// Reads a PNG or PGM of 8 or 16 bits (0 = unknown), or a PFM (not finite or not positive = unknown). A value is
/// `scale` · d px. Throws FileError, also for a truncated file or one without any known pixel.
DisparityMap load_disparity(const std::filesystem::path& path, double scale);

/// For images made smaller or larger by `factor`, to width × height: the nearest value, times the factor.
DisparityMap resized(const DisparityMap& map, double factor, int width, int height);

}  // namespace horopter
