// SPDX-License-Identifier: Apache-2.0
// rig.yaml, and recognising the formats of other programs.
#include "horopter/calib/rig.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <set>

#include "horopter/calib/error.hpp"
#include "rig/import.hpp"

namespace horopter::calib {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double Rig::baseline_mm() const {
  if (cameras.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (cameras[0].world_to_camera.centre() - cameras[1].world_to_camera.centre()).norm();
}

namespace import {

std::string place(const YAML::Node& node) {
  const YAML::Mark mark = node.Mark();
  return mark.is_null() ? "" : fmt::format("line {}", mark.line + 1);
}

void fail(const Source& source, const YAML::Node& node, const std::string& what, const std::string& found,
          const std::string& expected) {
  const std::string where = place(node);
  throw FileError(source.file, where.empty() ? what : where + ": " + what, found, expected);
}

YAML::Node member(const Source& source, const YAML::Node& map, const std::string& key, const std::string& expected) {
  if (!map.IsMap()) fail(source, map, key, "its parent is not a map", expected);
  const YAML::Node node = map[key];
  if (!node.IsDefined() || node.IsNull()) fail(source, map, key, "missing", expected);
  return node;
}

double number(const Source& source, const YAML::Node& node, const std::string& what) {
  double value = NAN;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    fail(source, node, what, node.IsScalar() ? "'" + node.Scalar() + "'" : "not a number", "a finite number");
  }
  return value;
}

std::vector<double> numbers(const Source& source, const YAML::Node& node, const std::string& what, std::size_t count) {
  std::vector<double> values;
  const auto add = [&](const auto& self, const YAML::Node& item) -> void {
    if (item.IsSequence()) {
      for (const YAML::Node& inner : item) self(self, inner);
    } else {
      values.push_back(number(source, item, what));
    }
  };
  if (!node.IsSequence()) fail(source, node, what, "not a list", fmt::format("{} numbers", count));
  add(add, node);
  if (count > 0 && values.size() != count) {
    fail(source, node, what, fmt::format("{} numbers", values.size()), fmt::format("{} numbers", count));
  }
  return values;
}

Matrix3d matrix3(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
}

Matrix3d rotation(const Source& source, const std::string& where, const Matrix3d& matrix) {
  const double error = (matrix.transpose() * matrix - Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < 1e-4) || !(matrix.determinant() > 0)) {
    throw FileError(source.file, where,
                    matrix.determinant() < 0 ? "a mirror" : fmt::format("R·Rᵀ differs from 1 by {:.2g}", error),
                    "a rotation matrix");
  }
  return error < 1e-14 ? matrix : nearest_rotation(matrix);
}

CameraModel model(const Source& source, const std::string& where, const Intrinsics& intrinsics) {
  try {
    return CameraModel(intrinsics);
  } catch (const std::invalid_argument& error) {
    throw FileError(source.file, where, error.what(), "");
  }
}

LensCoefficients opencv_distortion(const Source& source, const std::string& where, const std::vector<double>& values) {
  static const std::set<std::size_t> kLengths{0, 1, 2, 4, 5, 8, 12, 14};
  if (!kLengths.contains(values.size())) {
    throw FileError(source.file, where, fmt::format("{} coefficients", values.size()), "4, 5, 8, 12 or 14");
  }
  std::array<double, LensCoefficients::kCount> terms{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) throw FileError(source.file, where, "a coefficient is not finite", "numbers");
    if (i < terms.size()) {
      terms[i] = values[i];
    } else if (values[i] != 0) {
      throw FileError(source.file, where, "a tilted sensor (tauX, tauY)", "a model without tilt");
    }
  }
  return LensCoefficients::from(terms);
}

CameraModel opencv_model(const Source& source, const std::string& where, const Matrix3d& k,
                         const LensCoefficients& lens, std::vector<std::string>& warnings) {
  if (std::abs(k(2, 2) - 1) > 1e-9 || k(1, 0) != 0 || k(2, 0) != 0 || k(2, 1) != 0) {
    throw FileError(source.file, where, "not a camera matrix", "[fx 0 cx; 0 fy cy; 0 0 1]");
  }
  if (k(0, 1) != 0) {
    if (std::abs(k(0, 1)) > 1e-4 * k(0, 0)) {
      throw FileError(source.file, where, fmt::format("a skew of {:g}", k(0, 1)), "rectangular pixels");
    }
    warnings.push_back(fmt::format("skew_ignored: {}: {}: a skew of {:g}", source.file, where, k(0, 1)));
  }
  return model(source, where, BrownConradyIntrinsics{k(0, 0), k(1, 1), k(0, 2), k(1, 2), lens});
}

}  // namespace import

namespace {

using import::fail;
using import::member;
using import::number;
using import::numbers;
using import::Source;

constexpr int kVersion = 1;

struct Term {
  const char* name;
  double LensCoefficients::* coefficient;
};
constexpr Term kBrownTerms[] = {
    {"k1", &LensCoefficients::k1}, {"k2", &LensCoefficients::k2}, {"p1", &LensCoefficients::p1},
    {"p2", &LensCoefficients::p2}, {"k3", &LensCoefficients::k3}, {"k4", &LensCoefficients::k4},
    {"k5", &LensCoefficients::k5}, {"k6", &LensCoefficients::k6}, {"s1", &LensCoefficients::s1},
    {"s2", &LensCoefficients::s2}, {"s3", &LensCoefficients::s3}, {"s4", &LensCoefficients::s4}};

struct TsaiTerm {
  const char* name;
  double TsaiIntrinsics::* member;
  bool required;
};
constexpr TsaiTerm kTsaiNumbers[] = {{"f_mm", &TsaiIntrinsics::f_mm, true},   {"dx_mm", &TsaiIntrinsics::dx_mm, true},
                                     {"dy_mm", &TsaiIntrinsics::dy_mm, true}, {"sx", &TsaiIntrinsics::sx, false},
                                     {"cx_px", &TsaiIntrinsics::cx_px, true}, {"cy_px", &TsaiIntrinsics::cy_px, true}};
constexpr TsaiTerm kTsaiTerms[] = {
    {"kappa1", &TsaiIntrinsics::kappa1, false}, {"kappa2", &TsaiIntrinsics::kappa2, false},
    {"kappa3", &TsaiIntrinsics::kappa3, false}, {"p1", &TsaiIntrinsics::p1, false},
    {"p2", &TsaiIntrinsics::p2, false},         {"s1", &TsaiIntrinsics::s1, false},
    {"s2", &TsaiIntrinsics::s2, false}};

/// A key that is not known must not be dropped: it would change the rig.
void check_keys(const Source& source, const YAML::Node& map, const std::set<std::string>& known,
                const std::string& what) {
  if (!map.IsMap()) fail(source, map, what, "not a map", "a map");
  std::set<std::string> seen;
  for (const auto& item : map) {
    const std::string key = item.first.IsScalar() ? item.first.Scalar() : "?";
    if (!seen.insert(key).second) fail(source, item.first, what, "'" + key + "' stands there twice", "each key once");
    if (known.contains(key)) continue;
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
    fail(source, item.first, what, "'" + key + "' is not known", names);
  }
}

Camera read_camera(const Source& source, const YAML::Node& node, std::size_t index) {
  const std::string what = fmt::format("camera {}", index + 1);
  Camera camera;
  const YAML::Node name = member(source, node, "name", "the camera's name");
  if (!name.IsScalar() || name.Scalar().empty()) fail(source, name, what + ": name", "not a text", "a name");
  camera.name = name.Scalar();
  if (const YAML::Node size = node["image_size"]; size.IsDefined()) {
    const auto values = numbers(source, size, what + ": image_size", 2);
    for (const double value : values) {
      if (value < 1 || value > 1e6 || value != std::floor(value)) {
        fail(source, size, what + ": image_size", fmt::format("{}", value), "[width, height] in pixels");
      }
    }
    camera.width_px = static_cast<int>(values[0]);
    camera.height_px = static_cast<int>(values[1]);
  }
  std::set<std::string> known{"name", "image_size", "model", "distortion", "rotation", "translation_mm"};
  const YAML::Node kind = member(source, node, "model", "brown_conrady or tsai");
  const YAML::Node distortion = node["distortion"];
  if (kind.IsScalar() && kind.Scalar() == "brown_conrady") {
    BrownConradyIntrinsics brown;
    const auto read = [&](const char* key) {
      known.insert(key);
      return number(source, member(source, node, key, "a number of pixels"), what + ": " + key);
    };
    brown.fx_px = read("fx_px");
    brown.fy_px = read("fy_px");
    brown.cx_px = read("cx_px");
    brown.cy_px = read("cy_px");
    if (distortion.IsDefined()) {
      std::set<std::string> terms;
      for (const Term& term : kBrownTerms) {
        terms.insert(term.name);
        if (const YAML::Node value = distortion.IsMap() ? distortion[term.name] : YAML::Node();
            value.IsDefined() && !value.IsNull()) {
          brown.lens.*term.coefficient = number(source, value, what + ": " + term.name);
        }
      }
      check_keys(source, distortion, terms, what + ": distortion");
    }
    camera.model = import::model(source, what, brown);
  } else if (kind.IsScalar() && kind.Scalar() == "tsai") {
    TsaiIntrinsics tsai;
    for (const TsaiTerm& term : kTsaiNumbers) {
      known.insert(term.name);
      const YAML::Node value = term.required ? member(source, node, term.name, "a number") : node[term.name];
      if (value.IsDefined()) tsai.*term.member = number(source, value, what + ": " + term.name);
    }
    if (distortion.IsDefined()) {
      std::set<std::string> terms;
      for (const TsaiTerm& term : kTsaiTerms) {
        terms.insert(term.name);
        if (const YAML::Node value = distortion.IsMap() ? distortion[term.name] : YAML::Node();
            value.IsDefined() && !value.IsNull()) {
          tsai.*term.member = number(source, value, what + ": " + term.name);
        }
      }
      check_keys(source, distortion, terms, what + ": distortion");
    }
    camera.model = import::model(source, what, tsai);
  } else {
    fail(source, kind, what + ": model", kind.IsScalar() ? "'" + kind.Scalar() + "'" : "not a text",
         "brown_conrady or tsai");
  }
  check_keys(source, node, known, what);
  const YAML::Node rotation = member(source, node, "rotation", "three rows of three numbers");
  camera.world_to_camera.rotation =
      import::rotation(source, what + ": rotation", import::matrix3(numbers(source, rotation, what + ": rotation", 9)));
  const auto t = numbers(source, member(source, node, "translation_mm", "three numbers"), what + ": translation_mm", 3);
  camera.world_to_camera.translation_mm = Vector3d(t[0], t[1], t[2]);
  return camera;
}

RigFile read_rig(const Source& source, const YAML::Node& root) {
  const double version = number(source, root["horopter_rig"], "horopter_rig");
  if (version != kVersion) {
    fail(source, root["horopter_rig"], "horopter_rig", fmt::format("version {:g}", version),
         fmt::format("version {}", kVersion));
  }
  check_keys(source, root, {"horopter_rig", "world", "cameras"}, "rig");
  RigFile file;
  file.format = "rig.yaml";
  if (const YAML::Node world = root["world"]; world.IsDefined() && world.IsScalar()) file.rig.world = world.Scalar();
  const YAML::Node cameras = member(source, root, "cameras", "a list of cameras");
  if (!cameras.IsSequence() || cameras.size() == 0) fail(source, cameras, "cameras", "no list", "a list of cameras");
  std::set<std::string> names;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    Camera camera = read_camera(source, cameras[i], i);
    if (!names.insert(camera.name).second) {
      fail(source, cameras[i], "cameras", "two cameras named '" + camera.name + "'", "different names");
    }
    file.rig.cameras.push_back(std::move(camera));
  }
  return file;
}

std::string row(const Eigen::RowVector3d& v) { return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]); }

/// YAML text in double quotes.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result + '"';
}

}  // namespace

std::string to_yaml(const Rig& rig) {
  std::string text = fmt::format(
      "# A camera rig of Horopter. Lengths in mm, image coordinates in pixels, (0, 0) the centre of the first pixel.\n"
      "# x_camera = rotation * x_world + translation_mm; camera axes: x to the right, y down, z forward.\n"
      "horopter_rig: {}\nworld: {}\ncameras:\n",
      kVersion, quoted(rig.world));
  for (const Camera& camera : rig.cameras) {
    text += fmt::format("  - name: {}\n", quoted(camera.name));
    if (camera.width_px > 0) text += fmt::format("    image_size: [{}, {}]\n", camera.width_px, camera.height_px);
    std::string terms;
    const auto add = [&](const char* name, double value) {
      if (value != 0) terms += fmt::format("{}{}: {}", terms.empty() ? "" : ", ", name, value);
    };
    if (const auto* tsai = std::get_if<TsaiIntrinsics>(&camera.model.intrinsics())) {
      text += "    model: tsai\n";
      for (const TsaiTerm& term : kTsaiNumbers) text += fmt::format("    {}: {}\n", term.name, tsai->*term.member);
      for (const TsaiTerm& term : kTsaiTerms) add(term.name, tsai->*term.member);
    } else {
      const auto& brown = std::get<BrownConradyIntrinsics>(camera.model.intrinsics());
      text += fmt::format("    model: brown_conrady\n    fx_px: {}\n    fy_px: {}\n    cx_px: {}\n    cy_px: {}\n",
                          brown.fx_px, brown.fy_px, brown.cx_px, brown.cy_px);
      for (const Term& term : kBrownTerms) add(term.name, brown.lens.*term.coefficient);
    }
    const Pose& pose = camera.world_to_camera;
    text += fmt::format("    distortion: {{{}}}\n    rotation: [{}, {}, {}]\n    translation_mm: {}\n", terms,
                        row(pose.rotation.row(0)), row(pose.rotation.row(1)), row(pose.rotation.row(2)),
                        row(pose.translation_mm.transpose()));
  }
  return text;
}

Rig rig_from_yaml(const std::string& text, const std::string& name) {
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap() || !root["horopter_rig"].IsDefined()) throw FileError(name, "", "no rig.yaml", "horopter_rig: 1");
    return read_rig({name, text}, root).rig;
  } catch (const YAML::Exception& error) {
    throw FileError(name, fmt::format("line {}", error.mark.line + 1), "not YAML (" + error.msg + ")", "rig.yaml");
  }
}

RigFile load_rig(const std::filesystem::path& file, const ImportOptions& options) {
  return load_rig(std::span(&file, 1), options);
}

RigFile load_rig(std::span<const std::filesystem::path> files, const ImportOptions& options) {
  const std::string expected =
      "rig.yaml, OpenCV's FileStorage (YAML, XML or JSON), ROS camera_info or Kalibr's camchain";
  if (files.empty()) throw std::invalid_argument("load_rig: no files");
  std::vector<Source> sources;
  for (const auto& path : files) sources.push_back({path.string(), import::read_text(path, expected)});
  RigFile result;
  const auto is_opencv = [](const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return text.find("opencv-matrix") != std::string::npos || text.find("<opencv_storage") != std::string::npos ||
           text.compare(0, 6, "%YAML:") == 0 || (first != std::string::npos && text[first] == '{');
  };
  if (is_opencv(sources.front().text)) {
    for (const Source& source : sources) {
      if (!is_opencv(source.text))
        throw FileError(source.file, "", "not a file of OpenCV's FileStorage", "as the first");
    }
    result = import::read_opencv(sources, options);
  } else {
    std::vector<YAML::Node> roots;
    for (const Source& source : sources) {
      try {
        roots.push_back(YAML::Load(source.text));
      } catch (const YAML::Exception& error) {
        throw FileError(source.file, fmt::format("line {}", error.mark.line + 1), "not YAML (" + error.msg + ")",
                        expected);
      }
      if (!roots.back().IsMap()) throw FileError(source.file, "", "not a map", expected);
    }
    const YAML::Node& root = roots.front();
    if (root["horopter_rig"].IsDefined() || root["cam0"].IsDefined()) {
      if (sources.size() > 1) throw FileError(sources[1].file, "", "a second file", "one file of this format");
      result = root["cam0"].IsDefined() ? import::read_kalibr(sources.front(), root) : read_rig(sources.front(), root);
    } else if (root["camera_matrix"].IsDefined() || root["K"].IsDefined() || root["k"].IsDefined()) {
      result = import::read_ros(sources, roots);
    } else {
      throw FileError(sources.front().file, "", "no rig that is known", expected);
    }
  }
  for (Camera& camera : result.rig.cameras) {
    if (camera.width_px > 0) continue;
    if (options.width_px > 0) {
      camera.width_px = options.width_px;
      camera.height_px = options.height_px;
    } else {
      result.warnings.push_back(fmt::format("image_size_unknown: {}: camera {}: the file does not say the image size",
                                            sources.front().file, camera.name));
    }
  }
  if (const double baseline = result.rig.baseline_mm(); baseline < 1 || baseline > 1e5) {
    result.warnings.push_back(fmt::format("unlikely_baseline: {}: the cameras are {:.4g} mm apart; is the unit right?",
                                          sources.front().file, baseline));
  }
  return result;
}

}  // namespace horopter::calib
