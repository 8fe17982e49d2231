// SPDX-License-Identifier: Apache-2.0
#include "conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <sstream>
#include <utility>

#include "cli/progress.hpp"
#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"

namespace horopter::cli {
namespace {

// kChapter8Fitted says by what.
constexpr double kSmallestLeaf_px = 1.5;
constexpr double kLargestLeaf_px = 24;
constexpr double kBlur_px = 0.68;
constexpr double kContrast_grey = 31;

}  // namespace

study::Conditions chapter8_conditions(const StudyScope& scope) {
  study::Conditions conditions;
  conditions.texture.kind = study::TextureKind::dead_leaves;
  conditions.texture.smallest_px = kSmallestLeaf_px;
  conditions.texture.largest_px = kLargestLeaf_px;
  if (!scope.picture.empty()) {
    conditions.texture.kind = study::TextureKind::picture;
    auto picture = std::make_shared<const Image>(load_image(scope.picture));
    const auto [low, high] = std::minmax_element(picture->pixels.begin(), picture->pixels.end());
    if (*low == *high) throw FileError(scope.picture, "", "an image of one grey value", "a picture with contrast");
    conditions.texture.picture = std::move(picture);
  } else if (!scope.texture.empty()) {
    conditions.texture.kind = study::texture_kind(scope.texture);
    if (conditions.texture.kind != study::TextureKind::dead_leaves) {
      const study::Texture usual;
      conditions.texture.smallest_px = usual.smallest_px;
      conditions.texture.largest_px = usual.largest_px;
    }
  }
  conditions.camera.blur_px = kBlur_px;
  conditions.lighting.deviation_grey = kContrast_grey;
  conditions.lighting.slope_x = 0.4;
  if (scope.quick) {
    conditions.camera.width = 240;
    conditions.camera.height = 180;
  }
  conditions.seed = scope.seed;
  return conditions;
}

std::vector<double> chapter8_disparities(const StudyScope& scope) {
  std::vector<double> result;
  const int steps = scope.quick ? 15 : 75;
  for (int i = 0; i <= steps; ++i) result.push_back(3.0 * i / steps);
  return result;
}

Image interpolated(const Image& source) {
  Image result(source.width, source.height);
  constexpr int kWeight = static_cast<int>(8 * kInterpolated_px);
  for (int y = 0; y < source.height; ++y)
    for (int x = 0; x < source.width; ++x) {
      const int next = x + 1 < source.width ? x + 1 : x;
      result.at(x, y) =
          static_cast<std::uint8_t>(((8 - kWeight) * source.at(x, y) + kWeight * source.at(next, y) + 4) / 8);
    }
  return result;
}

study::ImageSeries transformed(const study::Simulation& simulation, const std::vector<double>& disparities_px) {
  study::ImageSeries series = photographs(simulation, disparities_px);
  series.image = [&simulation, disparities_px](std::size_t i) {
    return interpolated(simulation.photograph(disparities_px[i] - kInterpolated_px, i + 1));
  };
  return series;
}

std::vector<study::Detection> detect(const char* what, const study::ImageSeries& series,
                                     const std::vector<study::Setting>& settings) {
  Progress progress(what);
  return study::detect(series, settings, [&](std::size_t done) { progress.show(done, series.disparities_px.size()); });
}

study::ImageSeries load_series(const std::string& path) {
  const std::vector<std::uint8_t> bytes = read_file(path, "a CSV file with the columns file,disparity_px");
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::string line;
  int number = 0;
  std::vector<Image> images;
  study::ImageSeries series;
  const auto fail = [&](const std::string& what, const std::string& expected) {
    throw FileError(path, fmt::format("line {}", number), what, expected);
  };
  while (std::getline(lines, line)) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (number == 1) {
      if (line != "file,disparity_px") fail("'" + line + "'", "the header file,disparity_px");
      continue;
    }
    if (line.empty()) continue;
    const auto comma = line.rfind(',');
    double disparity = 0;
    const char* const end = line.data() + line.size();
    if (comma == std::string::npos) fail("'" + line + "'", "a file and its disparity");
    const auto [rest, error] = std::from_chars(line.data() + comma + 1, end, disparity);
    if (error != std::errc() || rest != end || !std::isfinite(disparity))
      fail("'" + line.substr(comma + 1) + "'", "a disparity in px");
    Image image = load_image(std::filesystem::path(path).parent_path() / line.substr(0, comma));
    if (image.width < 64 || image.height < 64)
      fail(fmt::format("an image of {}×{}", image.width, image.height), "64×64 pixels or more");
    if (series.reference.empty()) {
      if (disparity != 0) fail(fmt::format("disparity {}", disparity), "0, the reference's own");
      series.reference = std::move(image);
      continue;
    }
    if (disparity < 0 || (!images.empty() && disparity <= series.disparities_px.back()))
      fail(fmt::format("disparity {}", disparity), "disparities that ascend from 0 or more");
    if (image.width != series.reference.width || image.height != series.reference.height)
      fail(fmt::format("an image of {}×{}", image.width, image.height),
           fmt::format("{}×{} as the reference", series.reference.width, series.reference.height));
    series.disparities_px.push_back(disparity);
    images.push_back(std::move(image));
  }
  if (images.size() < 3) fail(fmt::format("{} images after the reference", images.size()), "3 or more");
  auto shared = std::make_shared<const std::vector<Image>>(std::move(images));
  series.image = [shared](std::size_t i) { return (*shared)[i]; };
  return series;
}

}  // namespace horopter::cli
