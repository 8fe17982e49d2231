// SPDX-License-Identifier: Apache-2.0
#include "output/lines.hpp"

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
  static constexpr auto kTryAgain = std::chrono::milliseconds(500);
  static constexpr int kLastLooks = 10;  // at the end, for a reader that hangs

  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      const std::string line = std::move(waiting_.front()) + "\n";
      waiting_.pop_front();
      if (waiting_.empty()) lost_ = 0;
      // A line that was begun is gone on with: else the next one would stand behind half of it.
      for (std::size_t at = 0; at < line.size();) {
        lock.unlock();
        const int error = write(line, at);
        lock.lock();
        if (ending_ && error != 0) return;
        failure_ = error;
        if (error != 0) wake_.wait_for(lock, kTryAgain, [this] { return ending_; });
      }
    }
  }

  /// From `at` on, which goes with it. What a pipe takes at once, it takes without a wait. 0, or what is wrong.
  int write(const std::string& text, std::size_t& at) {
    int looks = 0;
    while (at < text.size()) {
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
  int failure_ = 0;         // of the last try
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
      writer_.say(json_line(event_json(event, status, cell_, actor, what)));
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
  return {{"time", time_text(status.time)},
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
          {"skew_ms", optional_json(status.skew_ms)},
          {"explained", optional_json(status.explained)},
          {"decision_ms", status.decision_ms},
          {"teaching", status.teaching},
          {"taught", status.taught},
          {"objects", objects_json(status.objects)},
          {"cameras", cameras_json(status.cameras)}};
}

Json event_json(const std::string& event, const Status& status, const Cell& cell, const Actor& actor,
                const std::string& what) {
  Json json{{"event", event}};
  json.update(status_json(status, cell));
  if (!actor.name.empty()) json["by"] = actor_json(actor);
  if (!what.empty()) json["what"] = what;
  return json;
}

std::unique_ptr<Part> make_lines(const Cell& cell, Lines lines, int file) {
  return std::make_unique<LinesPart>(cell, lines, file);
}

}  // namespace horopter::monitor
