// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "horopter/map/map_json.hpp"

namespace horopter {
Image state_picture(const Image& states) {
  constexpr std::array<std::uint8_t, 4> kLevels{0, 255, 128, 64};
  Image picture(states.width, states.height);
  std::ranges::transform(states.pixels, picture.pixels.begin(), [&](std::uint8_t code) { return kLevels[code & 3U]; });
  return picture;
}

namespace {

/// Never −0.
double rounded(double value) { return std::round(10 * value) / 10 + 0.0; }

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
                          {"patches", agreement.patches},
                          {"patches_dy_px", number(agreement.patches_across_px)},
                          {"sharpness", agreement.sharpness}};
}

}  // namespace

nlohmann::ordered_json object_json(const TrackedObject& object) {
  using Json = nlohmann::ordered_json;
  const Region& region = object.region;
  const auto vector = [](const auto& v) {
    Json numbers = Json::array();
    for (const double number : v) numbers.push_back(rounded(number));
    return numbers;
  };
  Json json{{"id", object.id}, {"area_px", region.pixels}};
  if (object.in_space) json["area_mm2"] = rounded(object.in_space->area_mm2);
  json["skin_pixels"] = region.pixels - region.blind_pixels;
  json["blind_pixels"] = region.blind_pixels;
  json["box"] = {region.x, region.y, region.width, region.height};
  if (object.in_space) json["size_mm"] = {rounded(object.in_space->length_mm), rounded(object.in_space->width_mm)};
  json["centroid_px"] = {rounded(region.centroid_x), rounded(region.centroid_y)};
  if (object.in_space) json["centroid_mm"] = vector(object.in_space->centroid_mm);
  json["age_frames"] = object.age_frames;
  if (!object.motion) return json;
  const ObjectMotion& motion = *object.motion;
  if (const auto mm_s = motion.mm_s()) {
    json["velocity_mm_s"] = vector(*mm_s);
  } else if (motion.mm_frame) {
    json["velocity_mm_frame"] = vector(*motion.mm_frame);
  } else if (const auto px_s = motion.px_s()) {
    json["velocity_px_s"] = vector(*px_s);
  } else {
    json["velocity_px_frame"] = vector(motion.px_frame);
  }
  return json;
}

nlohmann::ordered_json frame_json(int frame, const std::string& left, const std::string& right,
                                  const FrameResult& result, const std::vector<TrackedObject>& objects,
                                  bool with_cycles) {
  nlohmann::ordered_json json{{"frame", frame},
                              {"left", left},
                              {"right", right},
                              {"table", result.table},
                              {"table_crc", crc_text(result.table_crc)},
                              {"alarm", result.alarm},
                              {"alarm_seen", result.seen},
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
  for (const TrackedObject& object : objects) json["objects"].push_back(object_json(object));
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
