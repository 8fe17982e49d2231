// SPDX-License-Identifier: Apache-2.0
// Every stage of the project, graph against class, on inputs without any order.
#include <catch2/catch.hpp>

#include "twin.hpp"

using namespace hlsc::test;

TEST_CASE("the project's stages do what their native twins do", "[stages]") {
  using Stage = std::pair<std::string, std::string>;
#define HOROPTER_STAGE(name, class_name) Stage{#name, #class_name},
  const std::vector<Stage> stages{
#include "stages/stage_list.def"
  };
#undef HOROPTER_STAGE
  const std::string profile = "field";
  for (const auto& [name, class_name] : stages) {
    CAPTURE(name, profile);
    const hlsc::Options options = stage_options(
        "stages/" + name + ".hpp", "horopter::stages::" + class_name + "<horopter::hls::profiles::" + profile + ">");
    CHECK(compare_with_native(options, {.steps = 4000, .seed = 3, .check_distance = false}) == "");
  }
}
