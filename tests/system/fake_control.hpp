// SPDX-License-Identifier: Apache-2.0
// A monitor that does what a test says.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "horopter/monitor/state.hpp"

namespace horopter::test {

/// Shows the moments that it is given; a restart makes it safe where the last moment was good.
class FakeControl : public monitor::Control {
 public:
  struct Asked {
    std::string what;
    std::string by;
  };

  void add(monitor::Listener& listener) { listeners_.push_back(&listener); }

  /// A pair was judged, as now.
  void judge(monitor::Moment moment) {
    const std::lock_guard order(order_);
    bool stops = false;
    {
      const std::lock_guard lock(mutex_);
      const bool good = !moment.result.alarm && moment.status.causes.empty();
      stops = safe_ && !good;
      if (stops) latched_ = moment.status.causes;
      if ((safe_ || good_) && !good) ++stops_;
      safe_ = safe_ && good;
      good_ = good;
      moment.arrived = monitor::Clock::now();
      moment.status.time = std::chrono::system_clock::now();
      moment.status.safe = safe_;
      moment.status.restart = safe_   ? monitor::Restart::not_needed
                              : good_ ? monitor::Restart::possible
                                      : monitor::Restart::needed;
      moment.status.latched = latched_;
      moment.status.stops = stops_;
      moment.status.teaching = teaching_ > 0;
      if (teaching_ > 0) --teaching_;
      latest_ = std::make_shared<const monitor::Moment>(std::move(moment));
    }
    for (auto* listener : listeners_) listener->judged(latest_);
    if (!stops) return;
    for (auto* listener : listeners_) listener->stopped(latest_->status, latest_);
  }

  [[nodiscard]] monitor::Status status() const override {
    const std::lock_guard lock(mutex_);
    monitor::Status status = latest_ ? latest_->status : monitor::Status();
    status.safe = safe_ && latest_;
    if (safe_) {
      status.restart = monitor::Restart::not_needed;
      status.latched.clear();
    }
    return status;
  }
  [[nodiscard]] monitor::MomentPtr latest() const override {
    const std::lock_guard lock(mutex_);
    return latest_;
  }
  bool restart(const monitor::Actor& actor, std::uint64_t stops, std::string& why) override {
    const std::lock_guard order(order_);
    monitor::Status now;
    {
      const std::lock_guard lock(mutex_);
      asked_.push_back({"restart", actor.name});
      if (stops != stops_) {
        why = kLookAgain;
        return false;
      }
      if (!good_) {
        why = "The last pictures were not good.";
        return false;
      }
      safe_ = true;
      latched_.clear();
      now = latest_->status;
    }
    for (auto* listener : listeners_) listener->released(now, actor);
    return true;
  }
  bool teach(int frames, const monitor::Actor& actor, std::uint64_t stops, std::string& why) override {
    if (frames < 1) {
      why = std::to_string(frames) + " frames are too few.";
      return false;
    }
    const std::lock_guard order(order_);
    monitor::Status now;
    {
      const std::lock_guard lock(mutex_);
      if (stops != stops_) {
        why = kLookAgain;
        return false;
      }
      asked_.push_back({"teach " + std::to_string(frames), actor.name});
      teaching_ = frames;
      if (latest_) now = latest_->status;
    }
    now.time = std::chrono::system_clock::now();
    for (auto* listener : listeners_) listener->noted(now, actor, "Teaching began.");
    return true;
  }

  [[nodiscard]] std::vector<Asked> asked() const {
    const std::lock_guard lock(mutex_);
    return asked_;
  }
  [[nodiscard]] bool safe() const {
    const std::lock_guard lock(mutex_);
    return safe_;
  }

 private:
  static constexpr const char* kLookAgain = "Something has stopped it since you looked. Look again.";

  std::vector<monitor::Listener*> listeners_;
  std::mutex order_;  ///< of what listeners are told
  mutable std::mutex mutex_;
  monitor::MomentPtr latest_;
  std::vector<monitor::Cause> latched_;
  std::vector<Asked> asked_;
  std::uint64_t stops_ = 0;
  int teaching_ = 0;
  bool safe_ = false;
  bool good_ = false;
};

}  // namespace horopter::test
