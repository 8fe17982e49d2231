// SPDX-License-Identifier: Apache-2.0
// Reading a rig in any format: recognised by its content.
#include "horopter/calib/rig.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "horopter/calib/error.hpp"
#include "horopter/calib/text_file.hpp"
#include "horopter/calib/yaml.hpp"
#include "rig/import.hpp"

namespace horopter::calib {
namespace {

using import::Source;

constexpr const char* kRigForms =
    "rig.yaml, OpenCV's FileStorage (YAML, XML or JSON), ROS camera_info or Kalibr's camchain";

bool is_opencv(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return text.find("opencv-matrix") != std::string::npos || text.find("<opencv_storage") != std::string::npos ||
         text.compare(0, 6, "%YAML:") == 0 || (first != std::string::npos && text[first] == '{');
}

RigFile read_yaml(std::vector<Source>& sources) {
  for (Source& source : sources) {
    source.root = yaml::parse(source.file, source.text, kRigForms);
    if (!source.root.IsMap()) throw FileError(source.file, "", "not a map", kRigForms);
  }
  const auto& [file, text, root] = sources.front();
  const bool own = root["horopter_rig"].IsDefined(), kalibr = root["cam0"].IsDefined();
  if (own || kalibr) {
    if (sources.size() > 1) throw FileError(sources[1].file, "", "a second file", "one file of this format");
    return kalibr ? import::read_kalibr(file, root) : import::read_rig(file, root);
  }
  const bool ros = root["camera_matrix"].IsDefined() || root["K"].IsDefined() || root["k"].IsDefined();
  if (!ros) throw FileError(file, "", "no rig that is known", kRigForms);
  return import::read_ros(sources);
}

RigFile read(std::vector<Source>& sources, const ImportOptions& options) {
  if (!is_opencv(sources.front().text)) return read_yaml(sources);
  for (const Source& source : sources) {
    if (!is_opencv(source.text)) throw FileError(source.file, "", "not a file of OpenCV's FileStorage", "as the first");
  }
  return import::read_opencv(sources, options);
}

/// The image sizes that the caller knows, where the files do not say them.
void complete_sizes(RigFile& result, const std::string& file, const ImportOptions& options) {
  for (Camera& camera : result.rig.cameras) {
    if (camera.width_px > 0) continue;
    if (options.width_px > 0) {
      camera.width_px = options.width_px;
      camera.height_px = options.height_px;
    } else {
      result.warnings.push_back(
          fmt::format("image_size_unknown: {}: camera {}: the file does not say the image size", file, camera.name));
    }
  }
}

}  // namespace

double Rig::baseline_mm() const {
  if (cameras.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (cameras[0].world_to_camera.centre() - cameras[1].world_to_camera.centre()).norm();
}

std::string baseline_problem(const Rig& rig) {
  const double baseline = rig.baseline_mm();
  if (!(baseline < kSmallestBaseline_mm || baseline > kLargestBaseline_mm)) return "";
  return fmt::format("the cameras are {:.4g} mm apart; expected {:g} to {:g} mm: is the unit millimetres?", baseline,
                     kSmallestBaseline_mm, kLargestBaseline_mm);
}

bool are_exchanged(const Camera& first, const Camera& second) {
  constexpr double kMostly = 0.7;
  const Eigen::Vector3d shift = (second.world_to_camera * first.world_to_camera.inverse()).translation_mm;
  return shift.x() > kMostly * shift.norm();
}

RigFile load_rig(const std::filesystem::path& file, const ImportOptions& options) {
  return load_rig(std::span(&file, 1), options);
}

RigFile load_rig(std::span<const std::filesystem::path> files, const ImportOptions& options) {
  if (files.empty()) throw std::invalid_argument("load_rig: no files");
  std::vector<Source> sources;
  for (const auto& path : files) {
    sources.push_back({path.string(), read_text(path, kRigForms)});
    if (sources.back().text.empty()) throw FileError(path.string(), "", "the file is empty", kRigForms);
  }
  RigFile result = read(sources, options);
  complete_sizes(result, sources.front().file, options);
  // Metres taken for millimetres, or the other way round: everything that follows would be wrong by a factor of 1000.
  if (const std::string problem = baseline_problem(result.rig); !problem.empty()) {
    throw FileError(sources.front().file, "", problem, "");
  }
  const auto& cameras = result.rig.cameras;
  if (cameras.size() > 1 && are_exchanged(cameras[0], cameras[1])) {
    result.warnings.push_back(fmt::format("left_right_exchanged: {}: {} stands to the left of {}", sources.front().file,
                                          cameras[1].name, cameras[0].name));
  }
  return result;
}

}  // namespace horopter::calib
