// SPDX-License-Identifier: Apache-2.0
#include "status_json.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

namespace horopter::monitor {

std::string time_text(Time time) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  const auto seconds = static_cast<std::time_t>(ms >= 0 ? ms / 1000 : (ms - 999) / 1000);
  std::tm parts{};
  if (::gmtime_r(&seconds, &parts) == nullptr) return "unknown";
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", parts, ms - static_cast<std::int64_t>(seconds) * 1000);
}

const char* restart_text(Restart restart) {
  switch (restart) {
    case Restart::not_needed:
      return "not_needed";
    case Restart::possible:
      return "possible";
    case Restart::needed:
      break;
  }
  return "needed";
}

Json causes_json(const std::vector<Cause>& causes) {
  Json list = Json::array();
  for (const Cause& cause : causes) {
    list.push_back({{"name", cause.name}, {"text", cause.text}, {"advice", cause.advice}});
  }
  return list;
}

Json objects_json(const std::vector<ObjectState>& objects) {
  Json list = Json::array();
  for (const ObjectState& object : objects) {
    list.push_back({{"id", object.id},
                    {"pixels", object.pixels},
                    {"blind_pixels", object.blind_pixels},
                    {"box", {object.x, object.y, object.width, object.height}},
                    {"age_frames", object.age_frames},
                    {"size_mm", optional_json(object.size_mm)},
                    {"distance_mm", optional_json(object.distance_mm)},
                    {"speed_mm_s", optional_json(object.speed_mm_s)}});
  }
  return list;
}

Json cameras_json(const std::vector<CameraState>& cameras) {
  Json list = Json::array();
  for (const CameraState& camera : cameras) {
    list.push_back({{"name", camera.name},
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
  return list;
}

Json actor_json(const Actor& actor) { return {{"name", actor.name}, {"address", actor.address}}; }

std::string text_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::int64_t number_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

}  // namespace horopter::monitor
