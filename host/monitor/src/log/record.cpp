// SPDX-License-Identifier: Apache-2.0
#include "record.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace horopter::monitor {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json optional_json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// The causes of now, and those that were latched and are over already.
std::vector<Cause> causes_of(const Status& status) {
  std::vector<Cause> causes = status.causes;
  for (const Cause& cause : status.latched) {
    if (std::find(causes.begin(), causes.end(), cause) == causes.end()) causes.push_back(cause);
  }
  return causes;
}

}  // namespace

std::string time_text(Time time) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  const auto seconds = static_cast<std::time_t>(ms >= 0 ? ms / 1000 : (ms - 999) / 1000);
  std::tm parts{};
  if (::gmtime_r(&seconds, &parts) == nullptr) return "unknown";
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", parts, ms - static_cast<std::int64_t>(seconds) * 1000);
}

std::string sentence_of(const Status& status) {
  std::string text;
  for (const Cause& cause : causes_of(status)) {
    if (!text.empty()) text += " ";
    text += cause.text.empty() ? cause.name : cause.text;
    if (!text.ends_with('.') && !text.ends_with('!')) text += ".";
  }
  return text.empty() ? "It is not safe any more; no cause was given." : text;
}

Json actor_json(const Actor& actor) { return {{"name", actor.name}, {"address", actor.address}}; }

Json stop_json(const Status& status, bool has_moment) {
  Json causes = Json::array();
  for (const Cause& cause : causes_of(status)) {
    causes.push_back({{"name", cause.name}, {"text", cause.text}, {"advice", cause.advice}});
  }
  Json objects = Json::array();
  for (const ObjectState& object : status.objects) {
    objects.push_back({{"id", object.id},
                       {"pixels", object.pixels},
                       {"blind_pixels", object.blind_pixels},
                       {"box", {object.x, object.y, object.width, object.height}},
                       {"age_frames", object.age_frames},
                       {"size_mm", optional_json(object.size_mm)},
                       {"distance_mm", optional_json(object.distance_mm)},
                       {"speed_mm_s", optional_json(object.speed_mm_s)}});
  }
  Json cameras = Json::array();
  for (const CameraState& camera : status.cameras) {
    cameras.push_back({{"name", camera.name},
                       {"source", camera.source},
                       {"connected", camera.connected},
                       {"frames", camera.frames},
                       {"dropped", camera.dropped},
                       {"lost_packets", camera.lost_packets},
                       {"repeated", camera.repeated},
                       {"frames_per_s", camera.frames_per_s},
                       {"exposure_us", optional_json(camera.exposure_us)},
                       {"sharpness", camera.sharpness}});
  }
  return {{"causes", std::move(causes)},
          {"alarm", status.alarm},
          {"objects", std::move(objects)},
          {"frame", status.frame},
          {"pair", has_moment},
          {"table", status.table},
          {"table_crc", fmt::format("{:08x}", status.table_crc)},
          {"skew_ms", optional_json(status.skew_ms)},
          {"explained", optional_json(status.explained)},
          {"decision_ms", status.decision_ms},
          {"cameras", std::move(cameras)}};
}

}  // namespace horopter::monitor
