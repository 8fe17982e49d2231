// SPDX-License-Identifier: Apache-2.0
// OpenCV's FileStorage: YAML, XML or JSON, under the names that OpenCV's samples and other programs use.
#include <fmt/format.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <string_view>

#include "horopter/calib/error.hpp"
#include "horopter/calib/yaml.hpp"
#include "rig/import.hpp"

namespace horopter::calib::import {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Storage {
  const Source* source;
  cv::FileStorage storage;
};

struct Entry {
  const Source* source;
  std::string key;
  cv::FileNode node;
};

/// The first of the keys that is there, in any of the files.
std::optional<Entry> find(const std::vector<Storage>& files, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    for (const Storage& file : files) {
      const cv::FileNode node = file.storage[key];
      if (!node.empty()) return Entry{file.source, key, node};
    }
  }
  return std::nullopt;
}

std::vector<double> values_of(const Entry& entry) {
  constexpr int kMostRows = 100;
  try {
    cv::Mat matrix;
    if (entry.node.isSeq()) {
      std::vector<double> list;
      for (const auto& item : entry.node) {
        if (!item.isInt() && !item.isReal()) throw FileError(entry.source->file, entry.key, "not numbers", "numbers");
        list.push_back(static_cast<double>(item));
      }
      return list;
    }
    const cv::FileNode rows = entry.node["rows"], columns = entry.node["cols"];
    // Judged before OpenCV takes the memory that they ask for.
    if (!entry.node.isMap() || !rows.isInt() || !columns.isInt() || static_cast<int>(rows) < 1 ||
        static_cast<int>(columns) < 1 || static_cast<int>(rows) > kMostRows || static_cast<int>(columns) > kMostRows) {
      throw FileError(entry.source->file, entry.key, "not a matrix", "a matrix of numbers");
    }
    entry.node >> matrix;
    matrix.convertTo(matrix, CV_64F);
    if (matrix.channels() != 1) throw FileError(entry.source->file, entry.key, "several channels", "a matrix");
    if (!matrix.isContinuous()) matrix = matrix.clone();
    const auto* const data = matrix.ptr<double>();
    return {data, data + matrix.total()};
  } catch (const cv::Exception&) {
    throw FileError(entry.source->file, entry.key, "not a matrix", "a matrix of numbers");
  }
}

Matrix3d matrix_of(const Entry& entry) {
  const auto values = values_of(entry);
  if (values.size() != 9) {
    throw FileError(entry.source->file, entry.key, fmt::format("{} numbers", values.size()), "a 3x3 matrix");
  }
  for (const double value : values) {
    if (!std::isfinite(value)) throw FileError(entry.source->file, entry.key, "not finite", "numbers");
  }
  return matrix3(values);
}

/// Keys of the second or first of two cameras, or of a single one (index 0).
std::vector<std::string> keys_of(const std::vector<std::string>& stems, int index) {
  std::vector<std::string> keys;
  for (const std::string& stem : stems) {
    if (index == 0) {
      keys.push_back(stem);
    } else {
      keys.push_back(stem + std::to_string(index));
      keys.push_back(stem + "_" + std::to_string(index));
      keys.push_back(stem + (index == 1 ? "_left" : "_right"));
      keys.push_back((index == 1 ? "left_" : "right_") + stem);
    }
  }
  return keys;
}

const std::vector<std::string> kMatrixKeys{"M", "K", "camera_matrix", "cameraMatrix", "CameraMatrix", "CM"};
const std::vector<std::string> kDistortionKeys{
    "D", "distortion_coefficients", "distCoeffs", "dist_coeffs", "DistCoeffs", "distortion"};

Camera opencv_camera(const std::vector<Storage>& files, int index, std::vector<std::string>& warnings) {
  const auto matrix = find(files, keys_of(kMatrixKeys, index));
  const auto distortion = find(files, keys_of(kDistortionKeys, index));
  Camera camera;
  if (!matrix) {
    throw FileError(files.front().source->file, "", fmt::format("no camera matrix M{0} (K{0}, cameraMatrix{0})", index),
                    "the matrices of both cameras");
  }
  LensCoefficients lens;
  if (distortion) {
    lens = opencv_distortion(distortion->source->file, distortion->key, values_of(*distortion));
  } else {
    warnings.push_back(
        fmt::format("no_distortion: {}: no distortion coefficients beside {}", matrix->source->file, matrix->key));
  }
  camera.model = opencv_model(matrix->source->file, matrix->key, matrix_of(*matrix), lens, warnings);
  return camera;
}

constexpr const char* kStorage = "a complete file of OpenCV's FileStorage";

/// OpenCV's parser of XML reads beyond the end where it looks for what follows an attribute's `=`. Throws FileError.
void check_xml(const Source& source) {
  const std::string_view text = source.text;
  const auto fail = [&](const std::string& found) { throw FileError(source.file, "", found, kStorage); };
  if (text.find('\0') != std::string_view::npos) fail("a byte 0");
  if (!text.substr(0, text.find_last_not_of(" \t\r\n") + 1).ends_with("</opencv_storage>")) {
    fail("no </opencv_storage> at its end");
  }
  const auto comment = text.rfind("<!--");
  if (comment != std::string_view::npos && text.find("-->", comment) == std::string_view::npos) {
    fail("a comment without an end");
  }
}

/// OpenCV's parser does not end on some of what is no YAML or JSON. Throws FileError.
void check_text(const Source& source) {
  std::string text = source.text;
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] == '<') return check_xml(source);
  if (text.starts_with("%YAML")) text.erase(0, text.find('\n'));  // as OpenCV writes it, it is not YAML's
  if (!yaml::parse(source.file, text, kStorage).IsMap()) {
    throw FileError(source.file, "", "OpenCV cannot read it (not a map)", kStorage);
  }
}

std::vector<Storage> open_all(const std::vector<Source>& sources) {
  std::vector<Storage> files;
  for (const Source& source : sources) {
    check_text(source);
    std::string text = source.text;
    if (text.find("!!opencv-matrix") != std::string::npos && text.compare(0, 5, "%YAML") != 0) {
      text.insert(0, "%YAML:1.0\n---\n");
    }
    try {
      files.push_back({&source, cv::FileStorage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY)});
    } catch (const cv::Exception& error) {
      throw FileError(source.file, "", "OpenCV cannot read it (" + std::string(error.err) + ")", kStorage);
    }
    if (!files.back().storage.isOpened()) {
      throw FileError(source.file, "", "OpenCV cannot read it", kStorage);
    }
  }
  return files;
}

/// The unit of T: that of `length_unit` (export.cpp), or the caller's.
double unit_mm(const std::vector<Storage>& files, const Entry& t, const std::optional<double>& given_mm) {
  const auto entry = find(files, {"length_unit"});
  if (!entry) {
    if (given_mm) return *given_mm;
    throw FileError(t.source->file, t.key, "a translation without a unit",
                    "to be told: `horopter calibrate --import FILE --unit mm|cm|m -o rig.yaml`");
  }
  const std::string name = entry->node.isString() ? entry->node.string() : "";
  if (name != "mm") throw FileError(entry->source->file, entry->key, "'" + name + "'", "mm");
  if (given_mm && *given_mm != 1) throw FileError(entry->source->file, entry->key, "mm", "the unit that --unit names");
  return 1;
}

/// A rotation by its vector. Beyond half a turn, and what it may be rounded to, it is of another unit.
Matrix3d rotation_of(const Entry& entry, const Vector3d& vector_rad) {
  constexpr double kLongest_rad = M_PI + 1e-3;
  if (!(vector_rad.norm() <= kLongest_rad)) {
    throw FileError(entry.source->file, entry.key, fmt::format("a rotation by {:g} radians", vector_rad.norm()),
                    "a rotation vector in radians, not degrees, of at most half a turn (3.1416)");
  }
  return rotation_from_vector(vector_rad);
}

/// R and T: the second camera's pose in the coordinates of the first.
Pose relative_pose(const std::vector<Storage>& files, const std::optional<double>& given_unit_mm) {
  const auto r = find(files, {"R", "Rotation", "rotation", "rotation_matrix"});
  const auto t = find(files, {"T", "Translation", "translation", "translation_vector"});
  if (!r || !t) {
    throw FileError(files.front().source->file, "", r ? "no T" : "no R",
                    "R and T from the first camera to the second (often in a second file, extrinsics.yml)");
  }
  const auto turn = values_of(*r);
  const auto shift = values_of(*t);
  if (shift.size() != 3) {
    throw FileError(t->source->file, t->key, fmt::format("{} numbers", shift.size()), "three numbers");
  }
  Pose pose;
  pose.rotation = turn.size() == 3 ? rotation_of(*r, {turn[0], turn[1], turn[2]})
                                   : rotation(r->source->file, r->key, matrix_of(*r));
  pose.translation_mm = unit_mm(files, *t, given_unit_mm) * Vector3d(shift[0], shift[1], shift[2]);
  if (!pose.translation_mm.allFinite() || !pose.rotation.allFinite()) {
    throw FileError(t->source->file, t->key, "not finite", "numbers");
  }
  return pose;
}

/// The image size, where one of the files says it, for all cameras.
void read_size(const std::vector<Storage>& files, std::vector<Camera>& cameras) {
  const auto w = find(files, {"image_width", "image_Width", "imageWidth", "width"});
  const auto h = find(files, {"image_height", "image_Height", "imageHeight", "height"});
  if (w && h) {
    for (Camera& camera : cameras) {
      set_size(camera, w->source->file, w->key, static_cast<double>(w->node), static_cast<double>(h->node));
    }
  } else if (const auto size = find(files, {"image_size", "imageSize", "size"})) {
    const auto values = values_of(*size);
    if (values.size() != 2) throw FileError(size->source->file, size->key, "not two numbers", "width, height");
    for (Camera& camera : cameras) set_size(camera, size->source->file, size->key, values[0], values[1]);
  }
}

}  // namespace

RigFile read_opencv(const std::vector<Source>& sources, const ImportOptions& options) try {
  const std::vector<Storage> files = open_all(sources);
  if (const auto fisheye = find(files, {"fisheye_model"}); fisheye && static_cast<int>(fisheye->node) != 0) {
    throw FileError(fisheye->source->file, "fisheye_model", "a fisheye lens", "OpenCV's usual lens model");
  }
  RigFile result;
  result.format = "OpenCV";
  std::vector<Camera>& cameras = result.rig.cameras;
  if (find(files, keys_of(kMatrixKeys, 1)) || find(files, keys_of(kMatrixKeys, 2))) {
    cameras = {opencv_camera(files, 1, result.warnings), opencv_camera(files, 2, result.warnings)};
    cameras[1].world_to_camera = relative_pose(files, options.opencv_unit_mm);
  } else {
    if (sources.size() > 1) {
      throw FileError(sources[1].file, "", "no camera matrices M1, M2", "the files of one stereo calibration");
    }
    cameras = {opencv_camera(files, 0, result.warnings)};
  }
  read_size(files, cameras);
  for (std::size_t i = 0; i < cameras.size(); ++i) cameras[i].name = camera_name(i, cameras.size());
  result.rig.world = "camera " + cameras.front().name;
  return result;
} catch (const FileError&) {
  throw;
} catch (const std::exception&) {  // OpenCV's own, and those of what it is made of
  throw FileError(sources.front().file, "", "OpenCV cannot read it", kStorage);
}

}  // namespace horopter::calib::import
