// SPDX-License-Identifier: Apache-2.0
// Why it is not safe, in plain words, and what to do: for every fault of the machine and of the monitor.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "horopter/machine/faults.hpp"
#include "horopter/monitor/monitor_faults.hpp"
#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

/// Of a fault of the machine or the monitor, or of `alarm`. What the machine's faults mean is what registers.yaml says. A
/// name that nobody knows is its own text.
Cause cause_of(std::string_view name);

/// All of a moment: the alarm first, then the monitor's faults, then the machine's.
std::vector<Cause> causes_of(bool alarm, MonitorFaults own, const Faults& faults);

}  // namespace horopter::monitor
