// SPDX-License-Identifier: Apache-2.0
// Random programs against their native selves. HLSC_SEED and HLSC_PROGRAMS choose others and more.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>

#include "emit_check.hpp"
#include "hlsc/diagnostics.hpp"
#include "random_stage.hpp"
#include "twin.hpp"

using namespace hlsc::test;

namespace {

unsigned long number(const char* variable, unsigned long otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

/// A recurrence through a memory, which no schedule can have. Anything else that is refused is a defect of the scheduler.
bool rightly_refused(const std::string& message) {
  return message.find("passes through a synchronous memory") != std::string::npos ||
         (message.find("its write comes") != std::string::npos && message.find("DISTANCE = ") != std::string::npos);
}

}  // namespace

TEST_CASE("random programs do what their native twins do", "[random]") {
  const unsigned long first = number("HLSC_SEED", 1), count = number("HLSC_PROGRAMS", 6);
  for (unsigned long seed = first; seed < first + count; ++seed) {
    INFO("again: HLSC_SEED=" << seed << " HLSC_PROGRAMS=1 hlsc_tests \"[random]\"");
    const std::string header = write_header("random_" + std::to_string(seed) + ".hpp", random_stage(seed));
    if (std::getenv("HLSC_SHOW") != nullptr) std::cout << random_stage(seed);
    std::string result;
    try {
      result = compare_with_native(stage_options(header, "random_stage::Stage"),
                                   {.steps = 3000, .seed = seed, .check_distance = false});
    } catch (const std::exception& error) {
      result = error.what();
    }
    CHECK(result == "");
  }
}

TEST_CASE("random programs as SystemVerilog do what their graphs do", "[random][emit]") {
  const unsigned long first = number("HLSC_SEED", 1), count = number("HLSC_PROGRAMS", 2), most = 4 * count + 8;
  unsigned long checked = 0;
  for (unsigned long seed = first; checked < count && seed < first + most; ++seed) {
    INFO("again: HLSC_SEED=" << seed << " HLSC_PROGRAMS=1 hlsc_tests \"[random]\"");
    const std::string header = write_header("random_" + std::to_string(seed) + ".hpp", random_stage(seed, true));
    hlsc::ScheduleOptions options;
    options.clock_ns = 12;
    options.allow_slow = true;
    const hlsc::Graph graph =
        hlsc::lower_for_target(hlsc::compile_stage(stage_options(header, "random_stage::Stage")).graph, options);
    hlsc::Schedule schedule;
    try {
      schedule = hlsc::schedule(graph, options);
    } catch (const hlsc::ScheduleError& error) {
      if (!rightly_refused(error.message())) FAIL_CHECK(error.what());
      continue;
    }
    ++checked;
    CHECK(check_module(graph, schedule, 1000, static_cast<unsigned>(seed)) == "");
  }
  CHECK(checked == count);
}
