// SPDX-License-Identifier: Apache-2.0
// Stages from end to end: the graph must do what the class does.
#include <catch2/catch.hpp>

#include "hlsc/dump.hpp"
#include "hlsc/schedule.hpp"
#include "twin.hpp"

using namespace hlsc::test;

namespace {

hlsc::Options kernel(const std::string& name) { return stage_options("kernels/kernels.hpp", "kernels::" + name); }

}  // namespace

TEST_CASE("kernels do what their native twins do") {
  const std::string name = GENERATE("Lowpass3x3<37>", "CyclicDifference", "BoxSum<29, 9>", "Majority5x5<100>",
                                    "Bilinear", "Cordic", "TableDirection");
  CAPTURE(name);
  CHECK(compare_with_native(kernel(name), {.steps = 4000, .seed = 7}) == "");
}

TEST_CASE("adder and accumulator") {
  CHECK(compare_with_native(stage_options("kernels/adder.hpp", "kernels::Adder")) == "");
  CHECK(compare_with_native(stage_options("kernels/adder.hpp", "kernels::Accumulator")) == "");
}

TEST_CASE("reset leaves Kept registers as they are") {
  const hlsc::Options options = stage_options("kernels/adder.hpp", "kernels::Kept");
  CHECK(compare_with_native(options, {.steps = 4000, .reset_every = 50}) == "");
  const hlsc::Graph graph = hlsc::compile_stage(options).graph;
  REQUIRE(graph.states.size() == 2);
  for (const hlsc::State& state : graph.states) CHECK(state.kept == (state.name == "total"));
}

TEST_CASE("indices and pointers") {
  const std::string name =
      GENERATE("OneIndex", "ChosenPointer", "LoadsAroundBegin", "StoresAroundBegin", "Tables", "PaddedTable");
  CAPTURE(name);
  CHECK(compare_with_native(stage_options("kernels/pointers.hpp", "kernels::" + name), {.steps = 6000}) == "");
}

TEST_CASE("a load through a pointer depends on what it may point to only") {
  const hlsc::Options options = stage_options("kernels/pointers.hpp", "kernels::ChosenObject");
  CHECK(compare_with_native(options, {.check_distance = false}) == "");
  // Were total_ a part of the address, a recurrence would pass through the memory.
  CHECK_NOTHROW(hlsc::schedule(hlsc::compile_stage(options).graph, {}));
}

TEST_CASE("the example of hls/README.md") {
  CHECK(compare_with_native(stage_options("kernels/vertical.hpp", "Vertical"), {.steps = 3000, .reset_every = 0}) ==
        "");
}

TEST_CASE("C++ storage leaves no trace in widths") {
  const hlsc::Graph graph = hlsc::compile_stage(kernel("Lowpass3x3<37>")).graph;
  REQUIRE(graph.rams.size() == 1);
  CHECK(graph.rams[0].width == 16);
  CHECK(graph.rams[0].depth == 37);
  CHECK(graph.rams[0].distance == 37);
  CHECK(graph.rams[0].read_address.size() == 6);
  unsigned bits = 0;
  for (const hlsc::State& state : graph.states) bits += state.width;
  CHECK(bits == 32 + 10 + 10);  // `int` members take the bits that change; that x_ stays below 37 no bit shows
}

TEST_CASE("a table read at a variable index becomes a ROM of its significant bits") {
  const hlsc::Graph graph = hlsc::compile_stage(kernel("TableDirection")).graph;
  REQUIRE(graph.roms.size() == 2);
  CHECK(graph.roms[0].words.size() <= 64);
  CHECK(graph.roms[0].width <= 12);
}

TEST_CASE("the same source gives the same graph, wherever it is compiled") {
  const hlsc::Options options = kernel("BoxSum<29, 9>");
  const std::string text = hlsc::dump(hlsc::compile_stage(options).graph);
  CHECK(hlsc::dump(hlsc::compile_stage(options).graph) == text);
  CHECK(text.find("hlsc_wrapper") == std::string::npos);
}
