// SPDX-License-Identifier: Apache-2.0
#include "photographs.hpp"

#include <array>
#include <cmath>
#include <filesystem>

#include "horopter/base/error.hpp"

namespace horopter::cli {
namespace {

constexpr double kExposure = 0.8;
constexpr std::array kPhotographs{"aloeL.jpg",  "graf1.png",        "leuvenA.jpg",  "fruits.jpg",
                                  "baboon.jpg", "rubberwhale1.png", "building.jpg", "home.jpg"};

}  // namespace

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
