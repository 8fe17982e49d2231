// SPDX-License-Identifier: Apache-2.0
// Waits for what comes of other threads and programs.
#pragma once

#include <chrono>
#include <thread>

namespace horopter::test {

/// False: not within a minute, which no slow computer takes.
template <class Condition>
bool eventually(const Condition& condition, std::chrono::milliseconds pause = std::chrono::milliseconds(20)) {
  const auto now = [] { return std::chrono::steady_clock::now(); };
  for (const auto give_up = now() + std::chrono::minutes(1); now() < give_up; std::this_thread::sleep_for(pause)) {
    if (condition()) return true;
  }
  return false;
}

}  // namespace horopter::test
