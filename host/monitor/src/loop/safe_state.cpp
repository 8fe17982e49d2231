// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/safe_state.hpp"

#include <ctime>

#include "horopter/monitor/monitor_faults.hpp"

namespace horopter::monitor {
namespace {

/// Two readings of the time slept differ by less.
constexpr auto kShortestSleep = std::chrono::milliseconds(10);

Clock::duration since_boot() {
  timespec time{};
  ::clock_gettime(CLOCK_BOOTTIME, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

Clock::duration time_slept() {
  for (;;) {  // a thread that had to wait between the two clocks reads them again
    const auto before = Clock::now();
    const Clock::duration boot = since_boot();
    if (Clock::now() - before < kShortestSleep / 2) return boot - before.time_since_epoch();
  }
}

void SafeState::write(FaultWords faults) {
  cameras_ = faults.cameras;
  machine_ = faults.machine;
  monitor_ = faults.monitor;
}

// Whoever reads in between must not take the old word for safe: it goes first, and comes last.
void SafeState::decided(Clock::time_point seen, bool safe, bool alarm, FaultWords faults) {
  if (!safe) safe_ = false;
  alarm_ = alarm;
  write(faults);
  seen_ = seen.time_since_epoch().count();
  ++decisions_;
  if (safe) safe_ = true;
}

void SafeState::not_safe(FaultWords faults) {
  safe_ = false;
  write(faults);
}

void SafeState::end() {
  ended_ = true;
  safe_ = false;
}

void SafeState::catch_up() {
  slept_ = time_slept_().count();
  missed_ = false;
}

Signal SafeState::at(Clock::time_point now) const {
  Signal signal;
  bool safe = false;
  Clock::rep seen = 0;
  do {  // the word of one decision and the age of another are none
    signal.decisions = decisions_;
    safe = safe_;
    signal.alarm = alarm_;
    signal.faults = {cameras_, machine_, monitor_};
    seen = seen_;
    safe = safe && safe_;
  } while (decisions_ != signal.decisions);
  if (seen != 0) signal.age = now - Clock::time_point(Clock::duration(seen));
  const bool young = seen != 0 && signal.age <= limit_;
  // Also where it is not safe: what somebody saw before the computer slept is no ground for a restart.
  const bool slept = time_slept_() - Clock::duration(slept_) > kShortestSleep;
  if (slept || (safe && !young)) missed_ = true;
  signal.safe = safe && young && !missed_ && !ended_;
  if (slept || !young) signal.faults.monitor |= MonitorFaults(MonitorFault::decision_late).word();
  return signal;
}

}  // namespace horopter::monitor
