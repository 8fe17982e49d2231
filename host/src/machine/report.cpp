// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "horopter/map/map_json.hpp"

namespace horopter {
namespace {

/// Pixels of `mask`, of which those of `blind`, if that is not empty, are counted.
std::vector<Region> connected(const cv::Mat& mask, const cv::Mat& blind) {
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8);
  std::vector<std::int64_t> blind_pixels(static_cast<std::size_t>(count));
  if (!blind.empty()) {
    for (int y = 0; y < mask.rows; ++y) {
      for (int x = 0; x < mask.cols; ++x) {
        if (blind.at<std::uint8_t>(y, x) != 0) ++blind_pixels[static_cast<std::size_t>(labels.at<int>(y, x))];
      }
    }
  }
  std::vector<Region> regions;
  for (int i = 1; i < count; ++i) {
    const int* row = stats.ptr<int>(i);
    regions.push_back({row[cv::CC_STAT_LEFT], row[cv::CC_STAT_TOP], row[cv::CC_STAT_WIDTH], row[cv::CC_STAT_HEIGHT],
                       row[cv::CC_STAT_AREA], centroids.at<double>(i, 0), centroids.at<double>(i, 1),
                       blind_pixels[static_cast<std::size_t>(i)]});
  }
  std::ranges::sort(regions, {}, [](const Region& r) { return std::tuple(-r.pixels, r.y, r.x); });
  return regions;
}

cv::Mat in_skin(const Image& states) {
  const cv::Mat codes(states.height, states.width, CV_8UC1, const_cast<std::uint8_t*>(states.pixels.data()));
  return codes == static_cast<int>(State::skin);
}

}  // namespace

std::vector<Region> regions_of(const Image& states) { return connected(in_skin(states), {}); }

std::vector<Region> objects_of(const FrameResult& result) {
  if (result.blind.empty()) return regions_of(result.states);
  const cv::Mat blind(result.states.height, result.states.width, CV_8UC1,
                      const_cast<std::uint8_t*>(result.blind.data()));
  return connected(in_skin(result.states) | (blind != 0), blind);
}

Image state_picture(const Image& states) {
  constexpr std::array<std::uint8_t, 4> kLevels{0, 255, 128, 64};
  Image picture(states.width, states.height);
  std::ranges::transform(states.pixels, picture.pixels.begin(), [&](std::uint8_t code) { return kLevels[code & 3U]; });
  return picture;
}

namespace {

double rounded(double value) { return std::round(10 * value) / 10; }

/// Shares of the textured cells that are explained, of the frame and of each region (null: no texture), and what the
/// right image is displaced.
void add_agreement(nlohmann::ordered_json& json, const Agreement& agreement) {
  using Json = nlohmann::ordered_json;
  if (agreement.supervised == 0) return;
  const auto share = [](int explained, int textured) {
    return textured > 0 ? Json(std::round(1000.0 * explained / textured) / 1000) : Json();
  };
  Json regions = Json::array();
  for (const auto& region : agreement.regions) regions.push_back(share(region.explained, region.textured));
  json["agreement"] = {{"explained", share(agreement.explained, agreement.textured)},
                       {"textured_cells", agreement.textured},
                       {"nearer_cells", agreement.nearer},
                       {"unproven_cells", agreement.unproven},
                       {"regions", std::move(regions)}};
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  json["registration"] = {{"dx_px", nullptr},  // along the row: not to be told from a scene of unknown depth
                          {"dy_px", number(agreement.across_px)},
                          {"roll_deg", number(agreement.roll_deg)},
                          {"scale", number(agreement.scale)},
                          {"sharpness", agreement.sharpness}};
}

}  // namespace

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
                              {"blind_pixels", result.blind_pixels},
                              {"hidden_pixels", result.hidden_pixels},
                              {"unproven_pixels", result.unproven_pixels},
                              {"regions", nlohmann::ordered_json::array()},
                              {"faults", result.faults.names()}};
  for (const Region& region : regions_of(result.states)) {
    json["regions"].push_back({{"x", region.x},
                               {"y", region.y},
                               {"width", region.width},
                               {"height", region.height},
                               {"pixels", region.pixels}});
  }
  json["objects"] = nlohmann::ordered_json::array();
  for (const Region& region : objects_of(result)) {
    if (region.pixels < result.object_limit_pixels) break;
    json["objects"].push_back({{"area_px", region.pixels},
                               {"skin_pixels", region.pixels - region.blind_pixels},
                               {"blind_pixels", region.blind_pixels},
                               {"box", {region.x, region.y, region.width, region.height}},
                               {"centroid_px", {rounded(region.centroid_x), rounded(region.centroid_y)}}});
  }
  add_agreement(json, result.agreement);
  if (result.skin_time_s) json["skin_time_s"] = *result.skin_time_s;
  if (result.scan != Scan::progressive) json["field"] = scan_name(result.scan);
  if (with_cycles) json["cycles"] = result.cycles;
  return json;
}

nlohmann::ordered_json summary_json(std::string_view engine, std::string_view profile) {
  return {{"engine", engine}, {"profile", profile}, {"frames", nlohmann::ordered_json::array()}};
}

}  // namespace horopter
