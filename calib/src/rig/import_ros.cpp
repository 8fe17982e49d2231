// SPDX-License-Identifier: Apache-2.0
// ROS camera_info: files of camera_calibration_parsers, or printed messages of ROS 1 (K) and ROS 2 (k).
#include <fmt/format.h>

#include <Eigen/LU>
#include <cctype>
#include <optional>

#include "horopter/calib/error.hpp"
#include "horopter/calib/yaml.hpp"
#include "rig/import.hpp"

namespace horopter::calib::import {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Info {
  Camera camera;
  Matrix3d rectification = Matrix3d::Identity();
  std::optional<Vector3d> translation_m;  ///< of the rectified camera
};

/// The numbers of a matrix, under its key in files or in messages; none where it is not there and need not be.
std::vector<double> matrix(const Source& source, const char* file_key, const std::string& message_key,
                           std::size_t count, bool required) {
  if (const YAML::Node node = source.root[file_key]; node.IsDefined()) {
    return yaml::numbers(source.file, yaml::member(source.file, node, "data", "rows, cols, data"),
                         std::string(file_key) + ".data", count);
  }
  for (const std::string& key : {message_key, std::string(1, static_cast<char>(std::tolower(message_key[0])))}) {
    if (const YAML::Node node = source.root[key]; node.IsDefined()) {
      return yaml::numbers(source.file, node, key, count);
    }
  }
  if (required) throw FileError(source.file, "", fmt::format("no {}", file_key), "a ROS camera_info");
  return {};
}

void read_size(const Source& source, Camera& camera) {
  const auto read = [&](const char* file_key, const char* message_key) {
    const YAML::Node node = source.root[file_key].IsDefined()
                                ? source.root[file_key]
                                : yaml::member(source.file, source.root, message_key, "pixels");
    return yaml::number(source.file, node, file_key);
  };
  set_size(camera, source.file, "image_width", read("image_width", "width"), read("image_height", "height"));
  for (const char* const key : {"binning_x", "binning_y"}) {
    if (source.root[key].IsDefined() && yaml::number(source.file, source.root[key], key) > 1) {
      yaml::fail(source.file, source.root[key], key, "a binned image", "a calibration of the full image");
    }
  }
}

LensCoefficients read_distortion(const Source& source) {
  const YAML::Node kind = source.root["distortion_model"];
  const std::string name = kind.IsDefined() && kind.IsScalar() ? kind.Scalar() : "plumb_bob";
  if (name != "plumb_bob" && name != "rational_polynomial" && !name.empty()) {
    yaml::fail(source.file, kind, "distortion_model", "'" + name + "'", "plumb_bob or rational_polynomial");
  }
  const auto distortion = matrix(source, "distortion_coefficients", "D", 0, true);
  if (distortion.size() > 5 && name == "plumb_bob") {
    throw FileError(source.file, "distortion_coefficients", fmt::format("{} coefficients", distortion.size()),
                    "5 for plumb_bob");
  }
  return opencv_distortion(source.file, "distortion_coefficients", distortion);
}

Info read_info(const Source& source, std::vector<std::string>& warnings) {
  Info info;
  read_size(source, info.camera);
  const LensCoefficients lens = read_distortion(source);
  info.camera.model = opencv_model(source.file, "camera_matrix", matrix3(matrix(source, "camera_matrix", "K", 9, true)),
                                   lens, warnings);
  if (const auto r = matrix(source, "rectification_matrix", "R", 9, false); !r.empty()) {
    info.rectification = rotation(source.file, "rectification_matrix", matrix3(r));
  }
  if (const auto p = matrix(source, "projection_matrix", "P", 12, false); !p.empty()) {
    if (!(p[0] > 0 && p[5] > 0)) throw FileError(source.file, "projection_matrix", "no focal length", "P of ROS");
    info.translation_m = Vector3d(p[3] / p[0], p[7] / p[5], 0);
  }
  return info;
}

/// The second camera's pose in the coordinates of the first.
Pose relative_pose(const std::vector<Source>& sources, const std::vector<Info>& infos) {
  const auto &first_m = infos[0].translation_m, &second_m = infos[1].translation_m;
  if (!first_m || !second_m) {
    throw FileError(sources[first_m ? 1 : 0].file, "", "no projection_matrix",
                    "the baseline in P[3] of the right camera");
  }
  const Vector3d between_m = *second_m - *first_m;
  if (!(between_m.norm() > 0)) {
    throw FileError(sources[1].file, "projection_matrix", "P[3] is 0",
                    "the baseline: a stereo calibration, the left camera first");
  }
  const Matrix3d back = infos[1].rectification.transpose();
  return {back * infos[0].rectification, 1000 * (back * between_m)};
}

}  // namespace

RigFile read_ros(const std::vector<Source>& sources) {
  if (sources.size() > 2) throw FileError(sources[2].file, "", "a third camera_info", "the files of one stereo pair");
  RigFile result;
  result.format = "ROS camera_info";
  std::vector<Info> infos;
  for (const Source& source : sources) infos.push_back(read_info(source, result.warnings));
  if (infos.size() == 2) infos[1].camera.world_to_camera = relative_pose(sources, infos);
  for (std::size_t i = 0; i < infos.size(); ++i) {
    infos[i].camera.name = camera_name(i, infos.size());
    result.rig.cameras.push_back(std::move(infos[i].camera));
  }
  result.rig.world = "camera " + result.rig.cameras.front().name;
  return result;
}

}  // namespace horopter::calib::import
