// SPDX-License-Identifier: Apache-2.0
// The thesis's experimental system: cameras 152 mm apart, tilted by 4° towards each other, 10 mm lenses (Table 11.1).
#pragma once

#include <cmath>

#include "horopter/skin/rig_skin.hpp"

namespace horopter {

/// Not turned.
inline calib::Pose at(const Eigen::Vector3d& place_mm) {
  calib::Pose pose;
  pose.translation_mm = place_mm;
  return pose;
}

/// Images of width × height pixels on the sensor of 756 × 581 pixels of 8.5 µm (17 µm sub-sampled), distorted by κ1.
/// World: between the cameras, z along the axis of symmetry.
inline CameraPair table_11_1(int width, int height, double kappa1 = 1e-3) {
  const auto camera = [&](const char* name, double side) {
    calib::TsaiIntrinsics lens;
    lens.f_mm = 10;
    lens.dx_mm = 756 * 0.0085 / width;
    lens.dy_mm = 581 * 0.0085 / height;
    lens.cx_px = 0.5 * (width - 1);
    lens.cy_px = 0.5 * (height - 1);
    lens.kappa1 = kappa1;
    calib::Camera result{name, width, height, calib::CameraModel(lens), {}};
    // The camera at x = side·76 mm looks towards the axis of symmetry.
    result.world_to_camera.rotation = calib::rotation_from_vector({0, side * 4 * M_PI / 180, 0});
    result.world_to_camera.translation_mm = -(result.world_to_camera.rotation * Eigen::Vector3d(side * 76, 0, 0));
    return result;
  };
  return {camera("left", -1), camera("right", 1)};
}

}  // namespace horopter
