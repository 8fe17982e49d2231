// SPDX-License-Identifier: Apache-2.0
// Random programs against their native selves. HLSC_SEED and HLSC_PROGRAMS choose others and more.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <iostream>

#include "hlsc/diagnostics.hpp"
#include "random_stage.hpp"
#include "twin.hpp"

using namespace hlsc::test;

TEST_CASE("random programs do what their native twins do", "[random]") {
  const char* const first_text = std::getenv("HLSC_SEED");
  const char* const count_text = std::getenv("HLSC_PROGRAMS");
  const unsigned long first = first_text == nullptr ? 1 : std::strtoul(first_text, nullptr, 10);
  const unsigned long count = count_text == nullptr ? 6 : std::strtoul(count_text, nullptr, 10);
  for (unsigned long seed = first; seed < first + count; ++seed) {
    INFO("again: HLSC_SEED=" << seed << " HLSC_PROGRAMS=1 hlsc_tests \"[random]\"");
    const std::string header = write_header("random_" + std::to_string(seed) + ".hpp", random_stage(seed));
    if (std::getenv("HLSC_SHOW") != nullptr) std::cout << random_stage(seed);
    std::string result;
    try {
      result = compare_with_native(stage_options(header, "random_stage::Stage"), {.steps = 3000, .seed = seed, .check_distance = false});
    } catch (const std::exception& error) {
      result = error.what();
    }
    CHECK(result == "");
  }
}
