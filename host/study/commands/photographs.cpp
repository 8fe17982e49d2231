// SPDX-License-Identifier: Apache-2.0
#include "photographs.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "horopter/base/error.hpp"
#include "horopter/map/row_check.hpp"

namespace horopter::cli {
namespace {

constexpr double kExposure = 0.8;
constexpr std::array kPhotographs{"aloeL.jpg",  "graf1.png",        "leuvenA.jpg",  "fruits.jpg",
                                  "baboon.jpg", "rubberwhale1.png", "building.jpg", "home.jpg"};

}  // namespace

MapSet plane_maps(const calib::Rig& rig, const MachineProfile& profile, Decision decision) {
  SkinFile file;
  file.skin = std::make_unique<RigSkin>(CameraPair(rig.cameras[0], rig.cameras[1]),
                                        make_plane({0, 0, kSkin_mm}, {0, 0, -1}), "plane");
  file.path = "the skin of the study";
  file.rig = calib::to_yaml(rig);
  return compile_maps(file, profile, kRig.width_px, kRig.height_px, view_limits(profile, decision));
}

std::vector<std::pair<std::string, Image>> load_photographs(const StudyScope& scope) {
  std::vector<std::pair<std::string, Image>> photographs;
  for (const char* name : kPhotographs) {
    if (scope.quick && photographs.size() == 1) break;
    Image photograph = load_image(std::filesystem::path(scope.data) / name);
    for (auto& pixel : photograph.pixels) pixel = static_cast<std::uint8_t>(std::lround(kExposure * pixel));
    photographs.emplace_back(name, std::move(photograph));
  }
  return photographs;
}

}  // namespace horopter::cli
