// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/systemd.hpp"

#include <systemd/sd-daemon.h>

namespace horopter::monitor {
namespace {

constexpr auto kBetween = std::chrono::milliseconds(100);

}  // namespace

void SystemdNotice::turn(Clock::time_point now) {
  if (ready_ && now - told_ < kBetween) return;
  sd_notify(0, ready_ ? "WATCHDOG=1" : "READY=1\nWATCHDOG=1");
  ready_ = true;
  told_ = now;
}

void SystemdNotice::stopping() { sd_notify(0, "STOPPING=1"); }

}  // namespace horopter::monitor
