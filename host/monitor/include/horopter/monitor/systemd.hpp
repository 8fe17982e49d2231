// SPDX-License-Identifier: Apache-2.0
// systemd's notice that the service is ready, and its watchdog. Without systemd nothing happens.
#pragma once

#include <chrono>

#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

class SystemdNotice {
 public:
  /// Called with every turn of the decision: ready with the first, alive with each, at most so often.
  void turn(Clock::time_point now);
  /// It ends.
  static void stopping();

 private:
  bool ready_ = false;
  Clock::time_point told_{};
};

}  // namespace horopter::monitor
