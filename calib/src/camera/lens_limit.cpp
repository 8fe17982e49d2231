// SPDX-License-Identifier: Apache-2.0
#include "camera/lens_limit.hpp"

#include <fmt/format.h>

#include <cmath>

namespace horopter::calib {

std::optional<std::string> lens_limit_warning(const Camera& camera) {
  if (camera.width_px < 2 || camera.height_px < 2) return std::nullopt;
  const CameraModel& model = camera.model;
  std::size_t blind = 0, all = 0;
  for (int row = 0; row <= 16; ++row) {
    for (int column = 0; column <= 16; ++column) {
      ++all;
      const Eigen::Vector2d pixel((camera.width_px - 1) * column / 16.0, (camera.height_px - 1) * row / 16.0);
      if (!model.undistort(pixel)) ++blind;
    }
  }
  if (blind == 0) return std::nullopt;
  return fmt::format(
      "lens_limit_inside_image: {}: {:.0f} % of the image lie beyond the radius where the distortion found turns back; "
      "no direction belongs to them (another term, as k2, or targets nearer to the corners may mend it)",
      camera.name, std::ceil(100.0 * static_cast<double>(blind) / static_cast<double>(all)));
}

}  // namespace horopter::calib
