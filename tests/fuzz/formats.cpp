// SPDX-License-Identifier: Apache-2.0
// A fuzzer for each format that the program reads. Whatever a file holds, a reader may say one thing only: what is
// wrong in which file (FileError), or, where a file is good and others do not fit it, wrong usage.
//
//   fuzz-formats --format=rig [libFuzzer's options] CORPUS…
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/stereo_pairs.hpp"
#include "horopter/base/crc32.hpp"
#include "horopter/base/error.hpp"
#include "horopter/calib/points.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/calib/target.hpp"
#include "horopter/calib/text_file.hpp"
#include "horopter/image/disparity.hpp"
#include "horopter/image/image.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/map_json.hpp"
#include "horopter/map/support.hpp"
#include "horopter/skin/skin_file.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {
namespace {

namespace fs = std::filesystem;

/// What the readers find instead of files: the system's cost a hundred times more than what is tried.
std::map<std::string, std::string>& files() {
  static std::map<std::string, std::string> all;
  return all;
}

fs::path write(const std::string& name, std::string_view bytes) {
  files()[name] = bytes;
  return name;
}

/// Two cameras of 64×48 pixels, 50 mm apart.
const calib::Rig& rig() {
  static const calib::Rig two = [] {
    calib::Rig rig{"left", {}};
    for (const auto& [name, x_mm] : {std::pair{"left", 0.0}, {"right", -50.0}}) {
      calib::Camera camera{name, 64, 48, calib::CameraModel(calib::BrownConradyIntrinsics{60, 60, 31.5, 23.5, {}}), {}};
      camera.world_to_camera.translation_mm.x() = x_mm;
      rig.cameras.push_back(camera);
    }
    return rig;
  }();
  return two;
}

/// One file, or several with a line of `====` between them.
void read_rig_files(std::string_view bytes) {
  constexpr std::string_view kBetween = "\n====\n";
  std::vector<fs::path> parts;
  for (;;) {
    const auto end = bytes.find(kBetween);
    parts.push_back(write(fmt::format("rig-{}.yaml", parts.size()), bytes.substr(0, end)));
    if (end == bytes.npos || parts.size() == 3) break;
    bytes.remove_prefix(end + kBetween.size());
  }
  const calib::RigFile read = calib::load_rig(parts, {.opencv_unit_mm = 1});
  const calib::Rig again = calib::rig_from_yaml(calib::to_yaml(read.rig), "again");
  if (again.cameras.size() != read.rig.cameras.size()) std::abort();
}

void look_at(const Skin& skin) {
  std::vector<Point> pixels;
  for (int y = 0; y < 48; y += 7) {
    for (int x = 0; x < 64; x += 7) pixels.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  std::vector<Look> looks(pixels.size());
  skin.look(pixels, 1, {}, looks);
}

void read_skin(std::string_view bytes) {
  const fs::path file = write("skin.yaml", bytes);
  has_motion(file);
  const SkinFile skin = load_skin(file, {31.5, 23.5}, &rig());
  look_at(*skin.skin);
  if (skin.motion == nullptr) {
    compile_maps(skin, find_profile("vga"), 64, 48);
    return;
  }
  for (const double share : {0.0, 0.3, 1.0}) skin.motion->at(share * skin.motion->end_s());
}

/// The words of an .hmap with its length and CRCs mended: what is behind them is what is tried.
void read_map(std::string_view bytes) {
  std::vector<std::uint32_t> words(bytes.size() / 4 + 4);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  words[0] = 0x50414D48;
  words[1] = 3;
  words[2] = static_cast<std::uint32_t>(words.size());
  for (std::size_t first = 8; first + 4 < words.size(); ++first) {
    // A table's own CRC, where one begins.
    if (!hls::table::is_first_word(words[first]) || words[first - 1] < 8 || words[first - 1] > words.size() - first - 1)
      continue;
    const std::size_t last = first + words[first - 1] - 1;
    words[last] = crc32_words(std::span(words).subspan(first, last - first));
  }
  words.back() = crc32_words(std::span(words).first(words.size() - 1));
  const MapSet maps = load_maps(write("map.hmap", {reinterpret_cast<const char*>(words.data()), words.size() * 4}));
  to_json(maps);
  for (const CompiledMap& map : maps.maps) supported_pixels(map.table, Decision::thesis);
}

void read_mesh_file(const char* name, std::string_view bytes) {
  const fs::path file = write(name, bytes);
  try {
    const SurfacePtr surface = make_mesh(read_mesh(file, 1));
    const Eigen::Vector3d direction(0, 0, 1);
    Hit hit;
    surface->intersect({0, 0, 0}, {&direction, 1}, {&hit, 1});
  } catch (const std::invalid_argument& error) {  // as skin_file.cpp does
    throw FileError(file.string(), "", error.what(), "");
  }
}

calib::Sensor read_sensor(std::string_view bytes) { return calib::read_sensor(write("sensor.yaml", bytes)); }

/// What follows from points; that they determine no camera is an answer.
void calibrate(const std::vector<calib::PointPair>& points, const calib::Sensor& sensor) {
  for (const auto method : {calib::PointMethod::dlt, calib::PointMethod::tsai}) {
    try {
      calib::calibrate_points(points, sensor, method);
    } catch (const calib::CalibrationError&) {
    }
  }
}

std::vector<calib::PointPair> cube() {
  std::vector<calib::PointPair> points;
  for (int i = 0; i < 64; ++i) {
    const Eigen::Vector3d at(40.0 * (i % 4) - 60, 40.0 * (i / 4 % 4) - 60, 30.0 * (i / 16));
    points.push_back({at, {320 + 600 * at.x() / (600 - at.z()), 240 - 600 * at.y() / (600 - at.z() + 0.1 * at.x())}});
  }
  return points;
}

const std::map<std::string, std::function<void(std::string_view)>>& formats() {
  static const std::map<std::string, std::function<void(std::string_view)>> all{
      {"rig", read_rig_files},
      {"skin", read_skin},
      {"map", read_map},
      {"ply", [](std::string_view bytes) { read_mesh_file("mesh.ply", bytes); }},
      {"stl", [](std::string_view bytes) { read_mesh_file("mesh.stl", bytes); }},
      {"obj", [](std::string_view bytes) { read_mesh_file("mesh.obj", bytes); }},
      {"image",
       [](std::string_view bytes) {
         decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, "image");
       }},
      {"disparity", [](std::string_view bytes) { load_disparity(write("disparity", bytes), 4); }},
      {"pairs", [](std::string_view bytes) { cli::read_pair_list(write("pairs.txt", bytes).string()); }},
      {"points",
       [](std::string_view bytes) {
         calibrate(calib::read_points(write("points.txt", bytes)), {640, 480, 0.01, 0.01, 320, 240, {}});
       }},
      {"sensor", [](std::string_view bytes) { calibrate(cube(), read_sensor(bytes)); }},
      {"target",
       [](std::string_view bytes) {
         try {
           calib::TargetSpec::parse(bytes).points_mm();
         } catch (const std::invalid_argument&) {  // an option: wrong usage
         }
       }},
  };
  return all;
}

const std::function<void(std::string_view)>* chosen = nullptr;

}  // namespace

/// In place of the library's (text_file.cpp), by which it reads all its files.
std::string calib::read_text(const fs::path& file, const std::string& expected) {
  const auto found = files().find(file.string());
  if (found == files().end()) throw FileError(file.string(), "", "there is no such file", expected);
  return found->second;
}

}  // namespace horopter

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  constexpr std::string_view kOption = "--format=";
  for (int i = 1; i < *count; ++i) {
    const std::string_view argument = (*arguments)[i];
    if (!argument.starts_with(kOption)) continue;
    const auto found = horopter::formats().find(std::string(argument.substr(kOption.size())));
    if (found != horopter::formats().end()) horopter::chosen = &found->second;
  }
  if (horopter::chosen == nullptr) {
    std::fputs("--format= is one of:", stderr);
    for (const auto& [name, read] : horopter::formats()) std::fprintf(stderr, " %s", name.c_str());
    std::fputs("\n", stderr);
    std::exit(2);
  }
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::setNumThreads(1);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    (*horopter::chosen)({reinterpret_cast<const char*>(data), size});
  } catch (const horopter::FileError& error) {
    if (error.file().empty() || !std::string_view(error.what()).starts_with(error.file())) std::abort();
  } catch (const horopter::Error& error) {
    if (error.status() != horopter::ExitStatus::usage) throw;
  }
  return 0;
}
