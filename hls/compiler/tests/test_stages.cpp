// SPDX-License-Identifier: Apache-2.0
// Every stage of the project, graph against class, on inputs without any order.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "twin.hpp"

using namespace hlsc::test;

TEST_CASE("the project's stages do what their native twins do", "[stages]") {
  struct Stage {
    std::string name, class_name, rule;
  };
#define HOROPTER_STAGE(name, class_name, rule, place) Stage{#name, #class_name, #rule},
  const std::vector<Stage> stages{
#include "stages/stage_list.def"
  };
  // What this finds tb/stages finds, too, behind the schedule and the emitted text; here it is seen where it arises.
  const bool all = std::getenv("HOROPTER_LONG") != nullptr;
  for (const auto& [name, class_name, rule] : stages) {
    if (!all && name != "majority") continue;
    const std::string profile = rule == "compete" ? "vga" : "field";
    CAPTURE(name, profile);
    const hlsc::Options options = stage_options(
        "stages/" + name + ".hpp", "horopter::stages::" + class_name + "<horopter::hls::profiles::" + profile + ">");
    CHECK(compare_with_native(options, {.steps = 4000, .seed = 3, .check_distance = false}) == "");
  }
}
