// SPDX-License-Identifier: Apache-2.0
// What outputs may say at a moment. It is read without waiting for anybody, and says unsafe by itself when the decision is
// too old: whoever hangs.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <utility>

#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

/// The words of all faults, as registers.yaml and monitor_faults.hpp number them.
struct FaultWords {
  std::uint32_t cameras = 0;
  std::uint32_t machine = 0;
  std::uint32_t monitor = 0;
};

struct Signal {
  bool safe = false;
  bool alarm = false;
  FaultWords faults;
  std::uint32_t decisions = 0;                   ///< so many were made; it counts on with each
  Clock::duration age = Clock::duration::max();  ///< of the last one
};

/// How long this computer has slept (suspend) since it was switched on: Clock stands still then.
Clock::duration time_slept();

/// Written by the decision, read by any thread.
class SafeState {
 public:
  using TimeSlept = std::function<Clock::duration()>;
  explicit SafeState(Clock::duration limit, TimeSlept time_slept = monitor::time_slept)
      : limit_(limit), time_slept_(std::move(time_slept)), slept_(time_slept_().count()) {}
  [[nodiscard]] Clock::duration limit() const { return limit_; }

  /// A pair was judged that shows nothing later than this (ImagePair::seen).
  void decided(Clock::time_point seen, bool safe, bool alarm, FaultWords faults);
  /// Not safe, from now until the next decision that is.
  void not_safe(FaultWords faults);
  /// Not safe any more, whatever is decided: the monitor ends.
  void end();
  /// Once somebody was told that the decision is too old, or that the computer has slept, it is never safe again, until
  /// catch_up().
  [[nodiscard]] Signal at(Clock::time_point now) const;
  [[nodiscard]] bool missed() const { return missed_; }
  /// The machine's interlock has been told of it: only a restart makes it safe.
  void catch_up();

 private:
  void write(FaultWords faults);

  Clock::duration limit_;
  TimeSlept time_slept_;
  std::atomic<Clock::rep> slept_;  ///< that the machine's interlock knows of
  mutable std::atomic<bool> missed_ = false;
  std::atomic<bool> ended_ = false;
  std::atomic<bool> safe_ = false;
  std::atomic<bool> alarm_ = false;
  std::atomic<std::uint32_t> cameras_ = 0, machine_ = 0, monitor_ = 0;
  std::atomic<std::uint32_t> decisions_ = 0;
  std::atomic<Clock::rep> seen_ = 0;  ///< of the last decision's pair; 0 = there was none
};

}  // namespace horopter::monitor
