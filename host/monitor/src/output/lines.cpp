// SPDX-License-Identifier: Apache-2.0
#include "output/lines.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "horopter/base/json_text.hpp"
#include "horopter/map/map_json.hpp"

namespace horopter::monitor {
namespace {

using Json = nlohmann::ordered_json;

std::string time_text(Time time) {
  const auto since = time.time_since_epoch();
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(since).count() % 1000;
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(time)), ms);
}

const char* restart_text(Restart restart) {
  switch (restart) {
    case Restart::not_needed:
      return "not_needed";
    case Restart::needed:
      return "needed";
    case Restart::possible:
      break;
  }
  return "possible";
}

Json causes_json(const std::vector<Cause>& causes) {
  Json list = Json::array();
  for (const Cause& cause : causes) {
    list.push_back({{"name", cause.name}, {"text", cause.text}, {"advice", cause.advice}});
  }
  return list;
}

template <class Value>
Json json_of(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

std::vector<std::string> names_of(const std::vector<Cause>& causes) {
  std::vector<std::string> names;
  for (const Cause& cause : causes) names.push_back(cause.name);
  return names;
}

class LinesPart : public Part {
 public:
  LinesPart(const Cell& cell, Lines lines) : cell_(cell), lines_(lines) {}

  void judged(const MomentPtr& moment) override {
    const Status& status = moment->status;
    if (status.safe) {
      told_.clear();
      may_restart_ = false;
      return;
    }
    const bool may_restart = status.restart == Restart::possible;
    const auto names = names_of(status.causes);
    if ((names.empty() || names == told_) && may_restart == may_restart_) return;
    if (moment->arrived - told_at_ < kBetweenCauses) return;
    told_at_ = moment->arrived;
    told_ = names;
    may_restart_ = may_restart;
    say(may_restart ? "restart_possible" : "causes", status);
  }
  void stopped(const Status& status, const MomentPtr& moment) override {
    told_ = names_of(status.causes);
    may_restart_ = false;
    if (moment) told_at_ = moment->arrived;
    say("stopped", status);
  }
  void released(const Status& status, const Actor& by) override { say("released", status, by); }
  void noted(const Status& status, const Actor& actor, const std::string& what) override {
    say("noted", status, actor, what);
  }

 private:
  void say(const std::string& event, const Status& status, const Actor& actor = {}, const std::string& what = {}) {
    if (lines_ == Lines::json) {
      Json json = event_json(event, status, cell_);
      if (!actor.name.empty()) json["by"] = {{"name", actor.name}, {"address", actor.address}};
      if (!what.empty()) json["what"] = what;
      std::puts(json_line(json).c_str());
    } else {
      std::string line = fmt::format("{}  pair {}  {}: {}", time_text(status.time), status.frame, event,
                                     status.safe ? "SAFE" : "not safe");
      if (!what.empty()) line += "; " + what;
      if (!actor.name.empty()) line += fmt::format("; by {}", actor.name);
      for (const Cause& cause : status.causes) line += fmt::format("; {}: {} {}", cause.name, cause.text, cause.advice);
      std::puts(line.c_str());
    }
    std::fflush(stdout);
  }

  const Cell& cell_;
  Lines lines_;
  bool may_restart_ = false;
  std::vector<std::string> told_;
  Clock::time_point told_at_{};
};

}  // namespace

Json status_json(const Status& status, const Cell& cell) {
  Json json{{"time", time_text(status.time)},
            {"cell", cell.name},
            {"configuration", crc_text(cell.crc)},
            {"frame", status.frame},
            {"safe", status.safe},
            {"alarm", status.alarm},
            {"restart", restart_text(status.restart)},
            {"restart_by_itself", status.restart_by_itself},
            {"causes", causes_json(status.causes)},
            {"latched", causes_json(status.latched)},
            {"table_crc", crc_text(status.table_crc)},
            {"skew_ms", json_of(status.skew_ms)},
            {"explained", json_of(status.explained)},
            {"decision_ms", status.decision_ms},
            {"teaching", status.teaching},
            {"taught", status.taught}};
  json["objects"] = Json::array();
  for (const ObjectState& object : status.objects) {
    json["objects"].push_back({{"id", object.id},
                               {"pixels", object.pixels},
                               {"blind_pixels", object.blind_pixels},
                               {"box", {object.x, object.y, object.width, object.height}},
                               {"age_frames", object.age_frames},
                               {"size_mm", json_of(object.size_mm)},
                               {"distance_mm", json_of(object.distance_mm)},
                               {"speed_mm_s", json_of(object.speed_mm_s)}});
  }
  json["cameras"] = Json::array();
  for (const CameraState& camera : status.cameras) {
    json["cameras"].push_back({{"name", camera.name},
                               {"source", camera.source},
                               {"connected", camera.connected},
                               {"frames", camera.frames},
                               {"dropped", camera.dropped},
                               {"lost_packets", camera.lost_packets},
                               {"repeated", camera.repeated},
                               {"frames_per_s", camera.frames_per_s},
                               {"exposure_us", json_of(camera.exposure_us)},
                               {"sharpness", camera.sharpness}});
  }
  return json;
}

Json event_json(const std::string& event, const Status& status, const Cell& cell) {
  Json json{{"event", event}};
  json.update(status_json(status, cell));
  return json;
}

std::unique_ptr<Part> make_lines(const Cell& cell, Lines lines) { return std::make_unique<LinesPart>(cell, lines); }

}  // namespace horopter::monitor
