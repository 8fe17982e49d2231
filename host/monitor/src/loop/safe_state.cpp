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
  if (safe && !young) missed_ = true;
  signal.safe = safe && young && !missed_ && !ended_;
  if (!young) signal.faults.monitor |= MonitorFaults(MonitorFault::decision_late).word();
  return signal;
}

}  // namespace horopter::monitor
