// SPDX-License-Identifier: Apache-2.0
// rig.yaml, read and written.
#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <set>
#include <span>

#include "horopter/calib/error.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/calib/yaml.hpp"
#include "rig/import.hpp"

namespace horopter::calib {
namespace {

using Eigen::Vector3d;

constexpr int kVersion = 1;

/// A number of a model: its key in the file and its place in the structure `Of`.
template <class Of>
struct Number {
  const char* name;
  double Of::* member;
  bool required = false;
};
using Brown = BrownConradyIntrinsics;
using Tsai = TsaiIntrinsics;
using Lens = LensCoefficients;

constexpr Number<Brown> kBrownNumbers[] = {{"fx_px", &Brown::fx_px, true},
                                           {"fy_px", &Brown::fy_px, true},
                                           {"cx_px", &Brown::cx_px, true},
                                           {"cy_px", &Brown::cy_px, true}};
constexpr Number<Lens> kBrownTerms[] = {{"k1", &Lens::k1}, {"k2", &Lens::k2}, {"p1", &Lens::p1}, {"p2", &Lens::p2},
                                        {"k3", &Lens::k3}, {"k4", &Lens::k4}, {"k5", &Lens::k5}, {"k6", &Lens::k6},
                                        {"s1", &Lens::s1}, {"s2", &Lens::s2}, {"s3", &Lens::s3}, {"s4", &Lens::s4}};
constexpr Number<Tsai> kTsaiNumbers[] = {{"f_mm", &Tsai::f_mm, true},   {"dx_mm", &Tsai::dx_mm, true},
                                         {"dy_mm", &Tsai::dy_mm, true}, {"sx", &Tsai::sx},
                                         {"cx_px", &Tsai::cx_px, true}, {"cy_px", &Tsai::cy_px, true}};
constexpr Number<Tsai> kTsaiTerms[] = {{"kappa1", &Tsai::kappa1}, {"kappa2", &Tsai::kappa2}, {"kappa3", &Tsai::kappa3},
                                       {"p1", &Tsai::p1},         {"p2", &Tsai::p2},         {"s1", &Tsai::s1},
                                       {"s2", &Tsai::s2}};

void read_size(Camera& camera, const std::string& file, const YAML::Node& node, const std::string& where) {
  const auto values = yaml::numbers(file, node, where, 2);
  import::set_size(camera, file, yaml::place(node, where), values[0], values[1]);
}

/// The lens terms of a model: a map of some of their names to numbers.
template <class Terms, class Values>
void read_terms(const std::string& file, const YAML::Node& distortion, const std::string& what, const Terms& terms,
                Values& values) {
  if (!distortion.IsDefined()) return;
  std::set<std::string> names;
  for (const auto& term : terms) names.insert(term.name);
  yaml::check_keys(file, distortion, names, what + ": distortion");
  for (const auto& term : terms) {
    const YAML::Node value = distortion[term.name];
    if (!value.IsDefined()) continue;
    values.*term.member = yaml::number(file, value, what + ": " + term.name);
  }
}

/// The numbers a model needs, each under its own key of the camera; the keys are added to `known`.
template <class Numbers, class Values>
void read_numbers(const std::string& file, const YAML::Node& node, const std::string& what, const Numbers& numbers,
                  Values& values, std::set<std::string>& known) {
  for (const auto& [name, member, required] : numbers) {
    known.insert(name);
    const YAML::Node value = required ? yaml::member(file, node, name, "a number") : node[name];
    if (value.IsDefined()) values.*member = yaml::number(file, value, what + ": " + name);
  }
}

CameraModel read_model(const std::string& file, const YAML::Node& node, const std::string& what,
                       std::set<std::string>& known) {
  const YAML::Node kind = yaml::member(file, node, "model", "brown_conrady or tsai");
  const std::string name = kind.IsScalar() ? kind.Scalar() : "";
  if (name == "brown_conrady") {
    BrownConradyIntrinsics brown;
    read_numbers(file, node, what, kBrownNumbers, brown, known);
    read_terms(file, node["distortion"], what, kBrownTerms, brown.lens);
    return import::model(file, what, brown);
  }
  if (name == "tsai") {
    TsaiIntrinsics tsai;
    read_numbers(file, node, what, kTsaiNumbers, tsai, known);
    read_terms(file, node["distortion"], what, kTsaiTerms, tsai);
    return import::model(file, what, tsai);
  }
  yaml::fail(file, kind, what + ": model", "", "brown_conrady or tsai");
}

Camera read_camera(const std::string& file, const YAML::Node& node, std::size_t index) {
  const std::string what = fmt::format("camera {}", index + 1);
  Camera camera;
  const YAML::Node name = yaml::member(file, node, "name", "the camera's name");
  if (!name.IsScalar() || name.Scalar().empty()) yaml::fail(file, name, what + ": name", "not a text", "a name");
  camera.name = name.Scalar();
  if (const YAML::Node size = node["image_size"]; size.IsDefined())
    read_size(camera, file, size, what + ": image_size");
  std::set<std::string> known{"name", "image_size", "model", "distortion", "rotation", "translation_mm"};
  camera.model = read_model(file, node, what, known);
  yaml::check_keys(file, node, known, what);
  const YAML::Node rotation = yaml::member(file, node, "rotation", "three rows of three numbers");
  const auto r = yaml::numbers(file, rotation, what + ": rotation", 9);
  camera.world_to_camera.rotation = import::rotation(file, what + ": rotation", import::matrix3(r));
  const YAML::Node translation = yaml::member(file, node, "translation_mm", "three numbers");
  const auto t = yaml::numbers(file, translation, what + ": translation_mm", 3);
  camera.world_to_camera.translation_mm = Vector3d(t[0], t[1], t[2]);
  return camera;
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

template <class Numbers, class Values>
std::string numbers_text(const Numbers& numbers, const Values& values) {
  std::string text;
  for (const auto& number : numbers) text += fmt::format("    {}: {}\n", number.name, values.*number.member);
  return text;
}

/// Terms that are 0 are left out.
template <class Terms, class Values>
std::string distortion_text(const Terms& terms, const Values& values) {
  std::string text;
  for (const auto& term : terms) {
    const double value = values.*term.member;
    if (value != 0) text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", term.name, value);
  }
  return fmt::format("    distortion: {{{}}}\n", text);
}

std::string model_text(const Intrinsics& intrinsics) {
  if (const auto* tsai = std::get_if<TsaiIntrinsics>(&intrinsics)) {
    return "    model: tsai\n" + numbers_text(kTsaiNumbers, *tsai) + distortion_text(kTsaiTerms, *tsai);
  }
  const auto& brown = std::get<BrownConradyIntrinsics>(intrinsics);
  return "    model: brown_conrady\n" + numbers_text(kBrownNumbers, brown) + distortion_text(kBrownTerms, brown.lens);
}

std::string camera_text(const Camera& camera) {
  std::string text = fmt::format("  - name: {}\n", quoted(camera.name));
  if (camera.width_px > 0) text += fmt::format("    image_size: [{}, {}]\n", camera.width_px, camera.height_px);
  text += model_text(camera.model.intrinsics());
  const Pose& pose = camera.world_to_camera;
  return text + fmt::format("    rotation: [{}, {}, {}]\n    translation_mm: {}\n", row(pose.rotation.row(0)),
                            row(pose.rotation.row(1)), row(pose.rotation.row(2)), row(pose.translation_mm.transpose()));
}

}  // namespace

std::string to_yaml(const Rig& rig) {
  std::string text = fmt::format(
      "# A camera rig of Horopter. Lengths in mm, image coordinates in pixels, (0, 0) the centre of the first pixel.\n"
      "# x_camera = rotation * x_world + translation_mm; camera axes: x to the right, y down, z forward.\n"
      "horopter_rig: {}\nworld: {}\ncameras:\n",
      kVersion, quoted(rig.world));
  for (const Camera& camera : rig.cameras) text += camera_text(camera);
  return text;
}

RigFile import::read_rig(const std::string& file, const YAML::Node& root) {
  const double version = yaml::number(file, root["horopter_rig"], "horopter_rig");
  if (version != kVersion) {
    yaml::fail(file, root["horopter_rig"], "horopter_rig", fmt::format("version {:g}", version),
               fmt::format("version {}", kVersion));
  }
  yaml::check_keys(file, root, {"horopter_rig", "world", "cameras"}, "rig");
  RigFile result;
  result.format = "rig.yaml";
  if (const YAML::Node world = root["world"]; world.IsDefined() && world.IsScalar()) result.rig.world = world.Scalar();
  const YAML::Node cameras = yaml::member(file, root, "cameras", "a list of cameras");
  if (!cameras.IsSequence() || cameras.size() == 0)
    yaml::fail(file, cameras, "cameras", "no list", "a list of cameras");
  std::set<std::string> names;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    Camera camera = read_camera(file, cameras[i], i);
    if (!names.insert(camera.name).second) {
      yaml::fail(file, cameras[i], "cameras", "two cameras named '" + camera.name + "'", "different names");
    }
    result.rig.cameras.push_back(std::move(camera));
  }
  return result;
}

Rig rig_from_yaml(const std::string& text, const std::string& name) {
  const YAML::Node root = yaml::parse(name, text, "rig.yaml");
  if (!root.IsMap() || !root["horopter_rig"].IsDefined()) throw FileError(name, "", "no rig.yaml", "horopter_rig: 1");
  return import::read_rig(name, root).rig;
}

}  // namespace horopter::calib
