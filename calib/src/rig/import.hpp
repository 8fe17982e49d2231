// SPDX-License-Identifier: Apache-2.0
// Readers of rig files.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "horopter/calib/rig.hpp"

namespace horopter::calib::import {

struct Source {
  std::string file;
  std::string text;
};

std::string read_text(const std::filesystem::path& file, const std::string& expected);

// Errors are FileError and name file, line and key.
[[noreturn]] void fail(const Source& source, const YAML::Node& node, const std::string& what, const std::string& found,
                       const std::string& expected);
YAML::Node member(const Source& source, const YAML::Node& map, const std::string& key, const std::string& expected);
double number(const Source& source, const YAML::Node& node, const std::string& what);
/// Of nested lists, in order. `count` 0: any number.
std::vector<double> numbers(const Source& source, const YAML::Node& node, const std::string& what, std::size_t count);
Eigen::Matrix3d matrix3(const std::vector<double>& values);
Eigen::Matrix3d rotation(const Source& source, const std::string& where, const Eigen::Matrix3d& matrix);
CameraModel model(const Source& source, const std::string& where, const Intrinsics& intrinsics);
LensCoefficients opencv_distortion(const Source& source, const std::string& where, const std::vector<double>& values);
CameraModel opencv_model(const Source& source, const std::string& where, const Eigen::Matrix3d& k,
                         const LensCoefficients& lens, std::vector<std::string>& warnings);

RigFile read_opencv(const std::vector<Source>& sources, const ImportOptions& options);
RigFile read_ros(const std::vector<Source>& sources, const std::vector<YAML::Node>& roots);
RigFile read_kalibr(const Source& source, const YAML::Node& root);

}  // namespace horopter::calib::import
