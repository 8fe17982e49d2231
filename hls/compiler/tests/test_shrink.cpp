// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "hlsc/builder.hpp"
#include "hlsc/diagnostics.hpp"
#include "hlsc/shrink.hpp"

using namespace hlsc;

namespace {

/// A draft made by hand.
class Hand {
 public:
  Bits input(const std::string& name, std::uint32_t width) {
    Port port;
    port.name = name;
    port.width = width;
    const Bits bits = builder.source(Op::kInput, static_cast<std::uint32_t>(draft.graph.inputs.size()), width, name);
    port.node = bits[0].node;
    draft.graph.inputs.push_back(port);
    return bits;
  }
  Bits state(const std::string& name, std::uint32_t width, std::uint64_t initial, bool known = true) {
    State state;
    state.name = name;
    state.width = width;
    for (std::uint32_t i = 0; i < width; ++i) state.initial.push_back(((initial >> i) & 1) != 0);
    const Bits bits =
        builder.source(Op::kStateRead, static_cast<std::uint32_t>(draft.graph.states.size()), width, name);
    state.read = bits[0].node;
    state.next = bits;
    draft.graph.states.push_back(state);
    draft.uninitialised.emplace_back(width, !known);
    draft.state_where.push_back({"here.hpp", 7});
    return bits;
  }
  void next(std::size_t state, const Bits& bits) { draft.graph.states[state].next = bits; }
  Bits ram(std::uint32_t depth, std::uint32_t width) {
    Ram ram;
    ram.name = "ram";
    ram.depth = depth;
    ram.width = width;
    ram.distance = 4;
    const Bits bits = builder.source(Op::kRamRead, static_cast<std::uint32_t>(draft.graph.rams.size()), width, "ram");
    ram.read = bits[0].node;
    ram.read_enable = kOne;
    draft.graph.rams.push_back(ram);
    return bits;
  }
  void output(const std::string& name, const Bits& bits) {
    Port port;
    port.name = name;
    port.width = static_cast<std::uint32_t>(bits.size());
    port.value = bits;
    draft.graph.outputs.push_back(port);
    draft.output_where.push_back({"here.hpp", 9});
  }
  Graph finish() {
    draft.graph.nodes = builder.nodes();
    return hlsc::finish(std::move(draft));
  }
  Builder builder;
  Draft draft;
};

Bits wide(const Bits& bits) { return Builder::zero_extend(bits, 32); }

}  // namespace

TEST_CASE("state bits that never change are constants", "[shrink]") {
  Hand hand;
  const Bits x = hand.input("x", 8), state = hand.state("held", 32, 0);
  hand.next(0, wide(x));
  hand.output("y", state);
  const Graph graph = hand.finish();
  REQUIRE(graph.states.size() == 1);
  CHECK(graph.states[0].width == 8);
  CHECK(graph.outputs[0].value.size() == 32);
  CHECK(graph.outputs[0].value[8] == kZero);
}

TEST_CASE("states that are always equal become one", "[shrink]") {
  Hand hand;
  const Bits first = hand.state("first", 8, 3), second = hand.state("second", 8, 3), other = hand.state("other", 8, 4);
  const Bits one = Builder::constant(1, 8);
  hand.next(0, hand.builder.add(first, one));
  hand.next(1, hand.builder.add(second, one));
  hand.next(2, hand.builder.add(other, one));
  hand.output("difference", hand.builder.sub(first, second));
  hand.output("both", hand.builder.bit_xor(second, other));
  const Graph graph = hand.finish();
  CHECK(graph.states.size() == 2);
  CHECK(graph.outputs[0].value == Builder::constant(0, 8));
}

TEST_CASE("along chains of states a bit that varies is followed to the end, and bits that differ", "[shrink]") {
  Hand hand;
  const Bits x = hand.input("x", 1), z = hand.input("z", 1), hold = hand.input("hold", 1), on = hand.input("on", 1);
  constexpr int kLength = 40;
  const auto chain = [&](const std::string& name, Bits before) {
    for (int i = 0; i < kLength; ++i) {
      const std::size_t number = hand.draft.graph.states.size();
      const Bits link = hand.state(name + std::to_string(i), 1, 0);
      hand.next(number, hand.builder.bit_xor(hand.builder.bit_and(hand.builder.mux(hold[0], link, before), on), link));
      before = link;
    }
    hand.output(name, before);
  };
  chain("first", x);
  chain("again", x);
  chain("other", z);
  chain("none", {kZero});
  const Graph graph = hand.finish();
  CHECK(graph.states.size() == 2 * kLength);
  CHECK(graph.outputs[0].value == graph.outputs[1].value);
  CHECK(graph.outputs[0].value != graph.outputs[2].value);
  CHECK(graph.outputs[3].value == Bits{kZero});
}

TEST_CASE("what no output depends on is gone, ports stay", "[shrink]") {
  Hand hand;
  const Bits x = hand.input("x", 8), unused = hand.input("unused", 4), state = hand.state("dead", 8, 0),
             low = hand.state("sum", 8, 0);
  hand.next(0, hand.builder.add(state, x));
  hand.next(1, hand.builder.add(low, x));
  hand.output("y", Builder::slice(low, 0, 3));
  const Graph graph = hand.finish();
  REQUIRE(graph.states.size() == 1);
  CHECK(graph.states[0].name == "sum");
  CHECK(graph.states[0].width == 3);
  CHECK(graph.inputs.size() == 2);
  for (const Node& node : graph.nodes) {
    if (node.op == Op::kAdd) CHECK(node.width == 3);
  }
}

TEST_CASE("memory bits: constant, equal, unread ones", "[shrink]") {
  Hand hand;
  const Bits x = hand.input("x", 4), data = hand.ram(16, 16);
  Ram& ram = hand.draft.graph.rams[0];
  ram.read_address = ram.write_address = x;
  ram.write_enable = kOne;
  ram.write_data = x;
  ram.write_data.insert(ram.write_data.end(), x.begin(), x.end());              // 4..7 as 0..3
  for (int i = 0; i < 4; ++i) ram.write_data.push_back(kZero);                  // 8..11 zero
  ram.write_data.insert(ram.write_data.end(), data.begin(), data.begin() + 4);  // 12..15 not read
  hand.output("y", Builder::slice(data, 0, 12));
  const Graph graph = hand.finish();
  REQUIRE(graph.rams.size() == 1);
  CHECK(graph.rams[0].width == 4);
  CHECK(graph.outputs[0].value[4] == graph.outputs[0].value[0]);
  CHECK(graph.outputs[0].value[8] == kZero);
}

TEST_CASE("undefined values that matter are refused", "[shrink]") {
  Hand hand;
  hand.builder.where = {"here.hpp", 5};
  const Bits x = hand.input("x", 8), u = hand.builder.undefined(8, "local variable n");
  SECTION("unused") {
    hand.output("y", x);
    CHECK_NOTHROW(hand.finish());
  }
  SECTION("masked") {
    hand.output("y", hand.builder.bit_and(u, Builder::constant(0, 8)));
    CHECK_NOTHROW(hand.finish());
  }
  SECTION("used") {
    hand.output("y", hand.builder.add(x, u));
    CHECK_THROWS_WITH(hand.finish(), "here.hpp:5: error: local variable n is used before it is set");
  }
  SECTION("a state without an initial value") {
    const Bits state = hand.state("count", 8, 0, false);
    hand.next(0, hand.builder.add(state, x));
    hand.output("y", state);
    CHECK_THROWS_WITH(hand.finish(), "here.hpp:7: error: member `count` of the stage has no initial value");
  }
}

TEST_CASE("memories that read each other in a circle are refused", "[shrink]") {
  Hand hand;
  const Bits x = hand.input("x", 4), a = hand.ram(16, 4), b = hand.ram(16, 4);
  hand.draft.graph.rams[0].read_address = b;
  hand.draft.graph.rams[1].read_address = a;
  for (Ram& ram : hand.draft.graph.rams) {
    ram.write_address = ram.write_data = x;
    ram.write_enable = kOne;
  }
  hand.output("y", a);
  CHECK_THROWS_AS(hand.finish(), CompileError);
}
