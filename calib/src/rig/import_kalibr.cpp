// SPDX-License-Identifier: Apache-2.0
// Kalibr's camchain: cameras cam0, cam1, …, each with its pose in the coordinates of the one before.
#include <Eigen/Core>
#include <cmath>

#include "horopter/calib/yaml.hpp"
#include "rig/import.hpp"

namespace horopter::calib::import {
namespace {

using Eigen::Vector3d;

void check_pinhole(const std::string& file, const std::string& key, const YAML::Node& node) {
  const YAML::Node kind = yaml::member(file, node, "camera_model", "pinhole");
  if (!kind.IsScalar() || kind.Scalar() != "pinhole") {
    yaml::fail(file, kind, key + ": camera_model", "", "pinhole");
  }
}

LensCoefficients read_distortion(const std::string& file, const std::string& key, const YAML::Node& node) {
  const YAML::Node kind = yaml::member(file, node, "distortion_model", "radtan or none");
  const std::string name = kind.IsScalar() ? kind.Scalar() : "";
  if (name == "none") return {};
  if (name != "radtan") yaml::fail(file, kind, key + ": distortion_model", "", "radtan or none");
  const std::string what = key + ": distortion_coeffs";
  const YAML::Node terms = yaml::member(file, node, "distortion_coeffs", "[k1, k2, p1, p2]");
  return opencv_distortion(file, what, yaml::numbers(file, terms, what, 4));
}

/// From the coordinates of the camera before.
Pose read_step(const std::string& file, const std::string& key, const YAML::Node& node) {
  const std::string what = key + ": T_cn_cnm1";
  const YAML::Node t = yaml::member(file, node, "T_cn_cnm1", "4x4, from the camera before, in m");
  const auto m = yaml::numbers(file, t, what, 16);
  if (m[12] != 0 || m[13] != 0 || m[14] != 0 || std::abs(m[15] - 1) > 1e-9) {
    yaml::fail(file, t, what, "the last row is not 0 0 0 1", "a rigid transformation");
  }
  return {rotation(file, what, matrix3({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]})),
          1000 * Vector3d(m[3], m[7], m[11])};
}

}  // namespace

RigFile read_kalibr(const std::string& file, const YAML::Node& root) {
  RigFile result;
  result.format = "Kalibr camchain";
  std::size_t count = 0;
  while (root["cam" + std::to_string(count)].IsDefined()) ++count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string key = "cam" + std::to_string(i);
    const YAML::Node node = root[key];
    check_pinhole(file, key, node);
    const YAML::Node intrinsics = yaml::member(file, node, "intrinsics", "[fu, fv, pu, pv]");
    const auto k = yaml::numbers(file, intrinsics, key + ": intrinsics", 4);
    const LensCoefficients lens = read_distortion(file, key, node);
    Camera camera;
    camera.name = camera_name(i, count);
    camera.model = model(file, key + ": intrinsics", BrownConradyIntrinsics{k[0], k[1], k[2], k[3], lens});
    const YAML::Node resolution = yaml::member(file, node, "resolution", "[width, height]");
    const auto size = yaml::numbers(file, resolution, key + ": resolution", 2);
    set_size(camera, file, key + ": resolution", size[0], size[1]);
    if (i > 0) camera.world_to_camera = read_step(file, key, node) * result.rig.cameras.back().world_to_camera;
    result.rig.cameras.push_back(std::move(camera));
  }
  result.rig.world = "camera " + result.rig.cameras.front().name;
  return result;
}

}  // namespace horopter::calib::import
