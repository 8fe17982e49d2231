// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "emit_check.hpp"

using namespace hlsc;
using namespace hlsc::test;

namespace {

ScheduleOptions at(double clock_ns, Target target = Target::kIce40Hx) {
  ScheduleOptions options;
  options.delays = make_delay_model(target);
  options.clock_ns = clock_ns;
  return options;
}

EmitOptions with_parity() {
  EmitOptions options;
  options.ram_parity = true;
  return options;
}

}  // namespace

TEST_CASE("an adder", "[emit]") {
  Builder b("adder");
  const Bits x = b.input("a", 8), y = b.input("b_1", 8);
  b.output("sum", b.add(x, y, "sum"));
  const auto s = schedule(b.graph, at(8));
  CHECK(s.latency == 1);
  CHECK(check_module(b.graph, s) == "");
}

TEST_CASE("a RAM with parity tells of each word that is not as it was written", "[emit]") {
  Builder b("sums");
  const Bits x = b.input("x", 7);
  const Bits place = b.state("place", 4);
  b.set_next(place, slice(b.add(place, constant(1, 4)), 3, 0));
  const Bits word = b.ram_read("line", 16, 9, 16, place);
  const Bits sum = slice(b.add(word, x), 8, 0);
  b.ram_write("line", place, sum, constant(1, 1));
  b.output("sum", sum);
  const auto s = schedule(b.graph, at(8));
  CHECK(check_module(b.graph, s) == "");
  CHECK(check_module(b.graph, s, 2000, 1, with_parity()) == "");
  CHECK_FALSE(emit(b.graph, s, {}).parity_error);
  CHECK(emit(b.graph, s, with_parity()).memories.at(0).width == 10);
}

TEST_CASE("without a RAM there is no parity", "[emit]") {
  Builder b("wire");
  b.output("y", b.add(b.input("x", 4), constant(1, 1)));
  CHECK_FALSE(emit(b.graph, schedule(b.graph, at(8)), with_parity()).parity_error);
}

TEST_CASE("an accumulator closes in one stage", "[emit]") {
  Builder b("accumulator");
  const Bits x = b.input("x", 8), clear = b.input("clear", 1);
  const Bits total = b.state("total", 16, 0x1234);
  const Bits sum = b.op(Op::kAdd, 16, {total, zero_extend(x, 16)}, "sum");
  const Bits next = b.mux(clear, constant(0, 16), sum);
  b.set_next(total, next);
  b.output("total", next);
  const auto s = schedule(b.graph, at(8));
  CHECK(check_module(b.graph, s) == "");
  // The state doubles as the output register.
  CHECK(emit(b.graph, s, {}).pipeline_bits == static_cast<unsigned long>(s.latency));
  CHECK(emit(b.graph, s, {}).text == emit(b.graph, s, {}).text);
}
