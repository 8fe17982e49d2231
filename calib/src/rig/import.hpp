// SPDX-License-Identifier: Apache-2.0
// Readers of rig files, one per format. All of them throw FileError, which names the file and the place in it.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "horopter/calib/rig.hpp"

namespace horopter::calib::import {

struct Source {
  std::string file;
  std::string text;
  YAML::Node root = {};  ///< of the text, where its format is YAML
};

RigFile read_rig(const std::string& file, const YAML::Node& root);
RigFile read_opencv(const std::vector<Source>& sources, const ImportOptions& options);
RigFile read_ros(const std::vector<Source>& sources);
RigFile read_kalibr(const std::string& file, const YAML::Node& root);

// What the readers share.

/// A name by place, whatever the file calls the camera: what reads a rig looks for left and right.
std::string camera_name(std::size_t index, std::size_t count);
void set_size(Camera& camera, const std::string& file, const std::string& where, double width, double height);
/// Of 9 numbers, row by row.
Eigen::Matrix3d matrix3(const std::vector<double>& values);
/// `matrix`, when it is a rotation.
Eigen::Matrix3d rotation(const std::string& file, const std::string& where, const Eigen::Matrix3d& matrix);
CameraModel model(const std::string& file, const std::string& where, const Intrinsics& intrinsics);
LensCoefficients opencv_distortion(const std::string& file, const std::string& where,
                                   const std::vector<double>& values);
/// `k` is the camera matrix [fx 0 cx; 0 fy cy; 0 0 1]. A small skew is left out, with a warning.
CameraModel opencv_model(const std::string& file, const std::string& where, const Eigen::Matrix3d& k,
                         const LensCoefficients& lens, std::vector<std::string>& warnings);

}  // namespace horopter::calib::import
