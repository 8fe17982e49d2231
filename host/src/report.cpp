// SPDX-License-Identifier: Apache-2.0
#include "horopter/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "horopter/map_json.hpp"

namespace horopter {
namespace {

/// The left image at the result's resolution: pairs of a row averaged for profiles that sub-sample.
cv::Mat left_at_result_size(const Image& left, int width, int height) {
  const cv::Mat grey(left.height, left.width, CV_8UC1, const_cast<std::uint8_t*>(left.pixels.data()));
  if (left.width == width && left.height == height) return grey.clone();
  cv::Mat small;
  cv::resize(grey, small, {width, height}, 0, 0, cv::INTER_AREA);
  return small;
}

}  // namespace

std::vector<Region> regions_of(const Image& states) {
  const cv::Mat codes(states.height, states.width, CV_8UC1, const_cast<std::uint8_t*>(states.pixels.data()));
  const cv::Mat skin = codes == static_cast<int>(State::skin);
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(skin, labels, stats, centroids, 8);
  std::vector<Region> regions;
  for (int i = 1; i < count; ++i) {
    const int* row = stats.ptr<int>(i);
    regions.push_back({row[cv::CC_STAT_LEFT], row[cv::CC_STAT_TOP], row[cv::CC_STAT_WIDTH], row[cv::CC_STAT_HEIGHT],
                       row[cv::CC_STAT_AREA]});
  }
  std::ranges::sort(regions, {}, [](const Region& r) { return std::tuple(-r.pixels, r.y, r.x); });
  return regions;
}

Image state_picture(const Image& states) {
  constexpr std::array<std::uint8_t, 4> kLevels{0, 255, 128, 64};
  Image picture(states.width, states.height);
  std::ranges::transform(states.pixels, picture.pixels.begin(), [&](std::uint8_t code) { return kLevels[code & 3U]; });
  return picture;
}

Picture draw_overlay(const Image& left, const FrameResult& result) {
  const Image& states = result.states;
  const cv::Mat grey = left_at_result_size(left, states.width, states.height);
  cv::Mat small(states.height, states.width, CV_8UC3);
  for (int y = 0; y < states.height; ++y) {
    for (int x = 0; x < states.width; ++x) {
      const int g = grey.at<std::uint8_t>(y, x);
      cv::Vec3b& pixel = small.at<cv::Vec3b>(y, x);
      const auto mix = [&](int blue, int green, int red, int percent) {
        const auto part = [&](int colour) {
          return static_cast<std::uint8_t>((g * (100 - percent) + colour * percent) / 100);
        };
        pixel = {part(blue), part(green), part(red)};
      };
      switch (static_cast<State>(states.at(x, y))) {
        case State::clear:
          mix(g, std::min(255, g + 30), g, 100);
          break;
        case State::skin:
          mix(30, 40, 255, 55);
          break;
        case State::undecidable:
          mix(60, 30, 20, 30);
          break;
        case State::unsupervised:
          (x + y) % 8 == 0 ? mix(20, 20, 20, 85) : mix(20, 20, 20, 65);
          break;
      }
    }
  }
  const int factor = std::max(1, (599 + states.width) / states.width);
  cv::Mat picture;
  cv::resize(small, picture, {}, factor, factor, cv::INTER_NEAREST);

  const auto smallest = std::max<std::int64_t>(16, static_cast<std::int64_t>(states.pixels.size()) / 2000);
  const cv::Scalar yellow(0, 220, 255);
  for (const Region& region : regions_of(states)) {
    if (region.pixels < smallest) continue;
    cv::rectangle(picture, {region.x * factor, region.y * factor},
                  {(region.x + region.width) * factor - 1, (region.y + region.height) * factor - 1}, yellow, 2);
  }

  std::string text = result.alarm ? "ALARM" : result.safe ? "safe" : "not safe";
  const double percent = 100.0 * static_cast<double>(result.skin_pixels) / static_cast<double>(states.pixels.size());
  text += fmt::format("   {:.1f} % in the skin", percent);
  for (const std::string& fault : result.fault_names()) text += "   " + fault;
  const cv::Scalar colour = result.faults != 0 ? cv::Scalar(0, 140, 255)
                            : result.alarm     ? cv::Scalar(40, 40, 230)
                                               : cv::Scalar(80, 170, 60);
  constexpr int kBar = 26;
  cv::copyMakeBorder(picture, picture, kBar, 0, 0, 0, cv::BORDER_CONSTANT, colour);
  cv::putText(picture, text, {8, 18}, cv::FONT_HERSHEY_SIMPLEX, 0.5, {255, 255, 255}, 1, cv::LINE_AA);
  return {picture.cols, picture.rows, {picture.datastart, picture.dataend}};
}

nlohmann::ordered_json frame_json(int frame, const std::string& left, const std::string& right,
                                  const FrameResult& result, bool with_cycles) {
  nlohmann::ordered_json json{{"frame", frame},
                              {"left", left},
                              {"right", right},
                              {"table", result.table},
                              {"table_crc", crc_text(result.table_crc)},
                              {"alarm", result.alarm},
                              {"safe", result.safe},
                              {"skin_pixels", result.skin_pixels},
                              {"undecidable_pixels", result.undecidable_pixels},
                              {"unsupervised_pixels", result.unsupervised_pixels},
                              {"regions", nlohmann::ordered_json::array()},
                              {"faults", result.fault_names()}};
  for (const Region& region : regions_of(result.states)) {
    json["regions"].push_back({{"x", region.x},
                               {"y", region.y},
                               {"width", region.width},
                               {"height", region.height},
                               {"pixels", region.pixels}});
  }
  if (result.skin_time_s) json["skin_time_s"] = *result.skin_time_s;
  if (result.scan != Scan::progressive) json["field"] = scan_name(result.scan);
  if (with_cycles) json["cycles"] = result.cycles;
  return json;
}

nlohmann::ordered_json summary_json(std::string_view engine, std::string_view profile) {
  return {{"engine", engine}, {"profile", profile}, {"frames", nlohmann::ordered_json::array()}};
}

}  // namespace horopter
