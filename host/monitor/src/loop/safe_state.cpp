// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/safe_state.hpp"

#include "horopter/monitor/monitor_faults.hpp"

namespace horopter::monitor {

void SafeState::write(FaultWords faults) {
  cameras_ = faults.cameras;
  machine_ = faults.machine;
  monitor_ = faults.monitor;
}

// Whoever reads in between must not take the old word for safe: it goes first, and comes last.
void SafeState::decided(Clock::time_point arrived, bool safe, bool alarm, FaultWords faults) {
  if (!safe) safe_ = false;
  alarm_ = alarm;
  write(faults);
  arrived_ = arrived.time_since_epoch().count();
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

Signal SafeState::at(Clock::time_point now) const {
  Signal signal;
  const bool safe = safe_;
  signal.alarm = alarm_;
  signal.faults = {cameras_, machine_, monitor_};
  signal.decisions = decisions_;
  const Clock::rep arrived = arrived_;
  if (arrived != 0) signal.age = now - Clock::time_point(Clock::duration(arrived));
  const bool young = arrived != 0 && signal.age <= limit_;
  if (safe && !young) missed_ = true;
  signal.safe = safe && young && !missed_ && !ended_;
  if (!young) signal.faults.monitor |= MonitorFaults(MonitorFault::decision_late).word();
  return signal;
}

}  // namespace horopter::monitor
