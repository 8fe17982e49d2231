// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/report.hpp"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "horopter/map/map_json.hpp"

namespace horopter {

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
                              {"faults", result.faults.names()}};
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
