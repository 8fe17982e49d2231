// SPDX-License-Identifier: Apache-2.0
// A thread of an output that looks, again and again, at what may be said now: whoever else hangs.
#pragma once

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
  /// `look` is called so often that a decision which grows too old is seen within an eighth of its limit.
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
  void run() {
    constexpr int kLooks = 8;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, state_.limit() / kLooks, [this] { return stopped_; })) look_(state_.at(Clock::now()));
  }

  const SafeState& state_;
  std::function<void(const Signal&)> look_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopped_ = false;
  std::thread thread_;  // the last: it uses the others
};

}  // namespace horopter::monitor
