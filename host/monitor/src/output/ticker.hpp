// SPDX-License-Identifier: Apache-2.0
// A thread of an output that looks, again and again, at what may be said now: whoever else hangs.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "horopter/monitor/safe_state.hpp"

namespace horopter::monitor {

class Ticker {
 public:
  /// `look` is called every kLongest, or eight times in the limit of the decision where that is sooner; and as soon as a
  /// safe one is too old.
  Ticker(const SafeState& state, std::function<void(const Signal&)> look)
      : state_(state), look_(std::move(look)), thread_([this] { run(); }) {}
  ~Ticker() { stop(); }
  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;

  /// Nothing is called afterwards.
  void stop() {
    {
      const std::lock_guard lock(mutex_);
      stopped_ = true;
    }
    wake_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

 private:
  static constexpr auto kLongest = std::chrono::milliseconds(20);

  void run() {
    constexpr int kLooks = 8;
    const Clock::duration longest = std::min<Clock::duration>(kLongest, state_.limit() / kLooks);
    auto next = Clock::now() + longest;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_until(lock, next, [this] { return stopped_; })) {
      const auto now = Clock::now();
      const Signal signal = state_.at(now);
      next = now + longest;
      if (signal.safe) next = std::min(next, now + (state_.limit() - signal.age) + Clock::duration(1));
      look_(signal);
    }
  }

  const SafeState& state_;
  std::function<void(const Signal&)> look_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopped_ = false;
  std::thread thread_;  // the last: it uses the others
};

}  // namespace horopter::monitor
