// SPDX-License-Identifier: Apache-2.0
#include "output/lines.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

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

/// Writes lines by a thread of its own, which waits for the reader.
class LineWriter {
 public:
  explicit LineWriter(int file) : file_(file), thread_([this] { run(); }) {}
  /// What waits is written if it is read.
  ~LineWriter() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  LineWriter(const LineWriter&) = delete;
  LineWriter& operator=(const LineWriter&) = delete;

  void say(std::string line) {
    {
      const std::lock_guard lock(mutex_);
      if (waiting_.size() >= kMostWaiting) {
        ++lost_;
        return;
      }
      waiting_.push_back(std::move(line));
    }
    wake_.notify_all();
  }
  [[nodiscard]] std::string trouble() const {
    const std::lock_guard lock(mutex_);
    if (failure_ != 0) return fmt::format("standard output: {}", std::strerror(failure_));
    return lost_ == 0 ? "" : fmt::format("standard output is not read, {} lines were lost", lost_);
  }

 private:
  static constexpr std::size_t kMostWaiting = 1000;
  static constexpr int kLook_ms = 50;
  static constexpr int kLastLooks = 10;  // at the end, for a reader that hangs

  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      const std::string line = std::move(waiting_.front());
      waiting_.pop_front();
      if (waiting_.empty()) lost_ = 0;
      lock.unlock();
      const int error = write(line + "\n");
      lock.lock();
      if (ending_ && error != 0) return;
      failure_ = error;
    }
  }

  /// What a pipe takes at once, it takes without a wait. 0, or what is wrong.
  int write(const std::string& text) {
    int looks = 0;
    for (std::size_t at = 0; at < text.size();) {
      pollfd ready{file_, POLLOUT, 0};
      const int found = ::poll(&ready, 1, kLook_ms);
      if (found == 0 && is_ending() && ++looks >= kLastLooks) return ETIMEDOUT;
      if (found <= 0) continue;
      const ssize_t written = ::write(file_, text.data() + at, std::min<std::size_t>(PIPE_BUF, text.size() - at));
      if (written < 0 && errno != EINTR && errno != EAGAIN) return errno;
      if (written > 0) at += static_cast<std::size_t>(written);
    }
    return 0;
  }
  bool is_ending() const {
    const std::lock_guard lock(mutex_);
    return ending_;
  }

  int file_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::string> waiting_;
  std::uint64_t lost_ = 0;  // since nothing waited
  int failure_ = 0;         // of the last line
  bool ending_ = false;
  std::thread thread_;  // the last: it uses the others
};

class LinesPart : public Part {
 public:
  LinesPart(const Cell& cell, Lines lines, int file) : cell_(cell), lines_(lines), writer_(file) {}

  [[nodiscard]] std::string trouble() const override { return writer_.trouble(); }

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
      writer_.say(json_line(json));
    } else {
      std::string line = fmt::format("{}  pair {}  {}: {}", time_text(status.time), status.frame, event,
                                     status.safe ? "SAFE" : "not safe");
      if (!what.empty()) line += "; " + what;
      if (!actor.name.empty()) line += fmt::format("; by {}", actor.name);
      for (const Cause& cause : status.causes) line += fmt::format("; {}: {} {}", cause.name, cause.text, cause.advice);
      writer_.say(std::move(line));
    }
  }

  const Cell& cell_;
  Lines lines_;
  bool may_restart_ = false;
  std::vector<std::string> told_;
  Clock::time_point told_at_{};
  LineWriter writer_;
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

std::unique_ptr<Part> make_lines(const Cell& cell, Lines lines, int file) {
  return std::make_unique<LinesPart>(cell, lines, file);
}

}  // namespace horopter::monitor
