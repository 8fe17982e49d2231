// SPDX-License-Identifier: Apache-2.0
// Of every co-simulation test: a failing test case prints the command that repeats it.
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>
#include <filesystem>
#include <iostream>

#include "horopter/tb/random.hpp"

namespace {

struct RepeatCommand : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;
  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    if (stats.totals.assertions.failed == 0) return;
    std::error_code ignored;
    std::cout << "repeat: HOROPTER_SEED=" << horopter::tb::session_seed() << ' '
              << std::filesystem::read_symlink("/proc/self/exe", ignored).string() << " \"" << stats.testInfo.name
              << "\"\n";
  }
};
CATCH_REGISTER_LISTENER(RepeatCommand)

}  // namespace
