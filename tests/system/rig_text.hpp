// SPDX-License-Identifier: Apache-2.0
// rig.yaml of two cameras that look the same way, as a user may write it.
#pragma once

#include <array>
#include <string>

namespace horopter::test {

/// The left one is the world. `right_mm`: the right one's translation, "-100, 0, 0" for a camera 100 mm to the right.
inline std::string two_cameras(int width, int height, int f_px, const std::string& right_mm,
                               const std::array<std::string, 2>& distortions = {"{}", "{}"}) {
  const auto middle = [](int pixels) { return std::to_string((pixels - 1) / 2) + ((pixels - 1) % 2 == 0 ? "" : ".5"); };
  const std::string f = std::to_string(f_px);
  const auto camera = [&](const std::string& name, const std::string& distortion, const std::string& translation_mm) {
    return "  - name: " + name + "\n    image_size: [" + std::to_string(width) + ", " + std::to_string(height) +
           "]\n    model: brown_conrady\n    fx_px: " + f + "\n    fy_px: " + f + "\n    cx_px: " + middle(width) +
           "\n    cy_px: " + middle(height) + "\n    distortion: " + distortion +
           "\n    rotation: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n    translation_mm: [" + translation_mm + "]\n";
  };
  return "horopter_rig: 1\nworld: left\ncameras:\n" + camera("left", distortions[0], "0, 0, 0") +
         camera("right", distortions[1], right_mm);
}

}  // namespace horopter::test
