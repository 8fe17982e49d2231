// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <optional>

#include "emit_check.hpp"
#include "hlsc/sidecar.hpp"

using namespace hlsc;
using namespace hlsc::test;

namespace {

ScheduleOptions at(double clock_ns, Target target = Target::kIce40Hx) {
  ScheduleOptions options;
  options.delays = make_delay_model(target);
  options.clock_ns = clock_ns;
  return options;
}

std::string error_of(const Graph& graph, const ScheduleOptions& options) {
  try {
    schedule(graph, options);
  } catch (const ScheduleError& error) {
    return error.what();
  }
  return "";
}

/// A counter that wraps at `limit`.
Bits counter(Builder& b, std::uint32_t width, std::uint64_t limit) {
  const Bits count = b.state("column", width);
  const Bits last = b.op(Op::kEq, 1, {count, constant(limit - 1, width)});
  b.set_next(count, b.mux(last, constant(0, width), b.op(Op::kAdd, width, {count, constant(1, width)})));
  return count;
}

/// 3x3 [1 2 1] over rows of `columns` pixels, columns first, as the low-pass of the pipeline.
Graph low_pass(std::uint32_t columns) {
  Builder b("low_pass");
  const Bits x = b.input("x", 8);
  const Bits column = counter(b, 9, columns);
  b.line = 20;
  const Bits rows = b.ram_read("rows", columns, 16, columns, column);  // {row -2, row -1}
  b.ram_write("rows", column, concat({slice(rows, 7, 0), x}), {kOne});
  b.line = 30;
  const auto weigh = [&](const Bits& a, const Bits& m, const Bits& c) {  // a + 2m + c
    return b.add(b.add(a, c), concat({m, constant(0, 1)}));
  };
  const Bits sum = slice(weigh(slice(rows, 15, 8), slice(rows, 7, 0), x), 9, 0);
  const Bits c1 = b.state("c1", 10), c0 = b.state("c0", 10);
  b.set_next(c1, sum);
  b.set_next(c0, c1);
  b.line = 40;
  b.output("y", slice(weigh(c0, c1, sum), 11, 4));
  return b.graph;
}

/// Running sum over the last k of a value: sum += new - old, old from a delay line of states.
Graph box_sum(unsigned k) {
  Builder b("box_sum");
  const Bits x = b.input("x", 4);
  std::vector<Bits> delay;
  for (unsigned i = 0; i < k; ++i) delay.push_back(b.state("delay" + std::to_string(i), 4));
  for (unsigned i = 0; i < k; ++i) b.set_next(delay[i], i == 0 ? x : delay[i - 1]);
  const Bits sum = b.state("sum", 8);
  const Bits change = b.sub(zero_extend(x, 8), zero_extend(delay[k - 1], 8), "change");
  const Bits next = b.op(Op::kAdd, 8, {sum, change}, "next");
  b.set_next(sum, next);
  b.output("sum", next);
  return b.graph;
}

/// Column sums in a RAM, a box sum over them: new column sum = old + x - x[k rows ago].
Graph column_sums(std::uint32_t columns, std::uint32_t distance) {
  Builder b("column_sums");
  const Bits x = b.input("x", 4);
  const Bits column = counter(b, 9, columns);
  const Bits word = b.ram_read("columns", columns, 20, distance, column);  // {sum, x-3, x-2, x-1}
  const Bits old = slice(word, 11, 8), sum = slice(word, 19, 12);
  const Bits next = b.op(Op::kAdd, 8, {sum, b.sub(zero_extend(x, 8), zero_extend(old, 8), "change")}, "column_sum");
  b.ram_write("columns", column, concat({next, slice(word, 7, 0), x}), {kOne});
  b.output("sum", next);
  return b.graph;
}

}  // namespace

TEST_CASE("a low-pass with line memory", "[schedule]") {
  for (const Target target : {Target::kIce40Hx, Target::kEcp5}) {
    for (const double clock_ns : {7.0, 8.0, 12.0, 40.0}) {
      const Graph g = low_pass(384);
      const auto s = schedule(g, at(clock_ns, target));
      CAPTURE(target_name(target), clock_ns, s.latency, emit(g, s, {}).state_bits, emit(g, s, {}).pipeline_bits);
      CHECK(check_module(g, s, 4000) == "");
      if (target == Target::kIce40Hx && clock_ns == 8.0) {
        CHECK(s.latency <= 4);
        CHECK(emit(g, s, {}).state_bits + emit(g, s, {}).pipeline_bits <= 85);
      }
    }
  }
}

TEST_CASE("a box sum keeps its recurrence in one stage", "[schedule]") {
  const Graph g = box_sum(9);
  const auto s = schedule(g, at(6));
  CHECK(check_module(g, s) == "");
  const auto module = emit(g, s, {});
  CHECK(module.state_bits == 44);
  CHECK(sidecar(g, s, {}, module).find("\"latency\": " + std::to_string(s.latency)) != std::string::npos);
}

TEST_CASE("running column sums: a recurrence through a memory", "[schedule]") {
  for (const double clock_ns : {5.0, 8.0, 30.0}) {
    const Graph g = column_sums(384, 384);
    const auto s = schedule(g, at(clock_ns));
    CHECK(s.ram_read_stage[0] < s.ram_write_stage[0]);
    CHECK(check_module(g, s, 4000) == "");
  }
}

TEST_CASE("a write later than DISTANCE permits is refused by name and place", "[schedule]") {
  const Graph g = column_sums(384, 384);
  const auto s = schedule(g, at(5));
  const auto needed = static_cast<std::uint32_t>(s.ram_write_stage[0] - s.ram_read_stage[0]);
  REQUIRE(needed >= 2);
  CHECK(error_of(column_sums(384, needed + 1), at(5)) == "");
  const auto error = error_of(column_sums(384, needed), at(5));
  CHECK(error.find("test.hpp:1: error: RAM 'columns'") == 0);
  CHECK(error.find("DISTANCE = " + std::to_string(needed)) != std::string::npos);
  CHECK(error_of(column_sums(384, 1), at(40)).find("DISTANCE = 1") != std::string::npos);
}

TEST_CASE("a violation of DISTANCE trips the assertion of the emitted module", "[emit]") {
  const auto build = [](std::uint32_t address_bits) {
    Builder b("distance");
    const Bits x = b.input("x", 8), where = b.input("where", address_bits);
    const Bits old = b.ram_read("totals", 256, 8, 64, zero_extend(where, 8));
    const Bits next = b.op(Op::kAdd, 8, {old, x});
    b.ram_write("totals", zero_extend(where, 8), next, {kOne});
    b.output("total", next);
    return b.graph;
  };
  const Graph g = build(2);  // four addresses at random: far closer than 64 steps
  const auto result = check_module(g, schedule(g, at(8)));
  CHECK(result.find("is read less than DISTANCE steps after its write") != std::string::npos);
}

TEST_CASE("a recurrence that misses the clock is reported by name", "[schedule]") {
  Builder b("slow");
  const Bits x = b.input("x", 32);
  b.line = 7;
  const Bits total = b.state("total", 32);
  Bits next = b.op(Op::kAdd, 32, {total, x});
  next = b.mux({next[31]}, b.op(Op::kAdd, 32, {next, constant(12345, 32)}), next);
  b.set_next(total, next);
  b.output("y", next);
  const auto error = error_of(b.graph, at(8));
  CHECK(error.find("test.hpp:7: error: the recurrence of state 'total' needs") == 0);
  auto options = at(8);
  options.allow_slow = true;
  const auto s = schedule(b.graph, options);
  REQUIRE(s.warnings.size() == 1);
  CHECK(check_module(b.graph, s) == "");
}

TEST_CASE("states of one recurrence lie in one stage", "[schedule]") {
  Builder b("pair");
  const Bits x = b.input("x", 8);
  const Bits p = b.state("p", 8, 3), q = b.state("q", 8, 5);
  const Bits wide = b.op(Op::kMul, 8, {x, x});  // puts the recurrence into a later stage
  b.set_next(p, b.op(Op::kXor, 8, {q, wide}));
  b.set_next(q, b.op(Op::kAdd, 8, {p, constant(1, 8)}));
  b.output("y", b.op(Op::kAdd, 8, {p, q}));
  const auto options = at(8);
  const Graph g = lower_for_target(b.graph, options);
  const auto s = schedule(g, options);
  CHECK(s.stage[g.states[0].read] == s.stage[g.states[1].read]);
  CHECK(s.stage[g.states[0].read] > 0);
  CHECK(check_module(g, s) == "");
}

TEST_CASE("a recurrence through a synchronous memory is refused", "[schedule]") {
  Builder b("walk");
  const Bits x = b.input("x", 4);
  const Bits position = b.state("position", 4);
  const Bits data = b.ram_read("links", 16, 4, 16, position);
  b.ram_write("links", x, x, {kZero});
  b.set_next(position, data);
  b.output("y", data);
  CHECK(error_of(b.graph, at(8)).find("synchronous memory") != std::string::npos);
}

TEST_CASE("every operation", "[emit]") {
  Builder b("operations");
  const Bits x = b.input("x", 9, true), y = b.input("y", 9, true), n = b.input("n", 4);
  const Bits level = b.config("level", 9);
  b.output("o_and", b.op(Op::kAnd, 9, {x, y}));
  b.output("o_or", b.op(Op::kOr, 9, {x, y}));
  b.output("o_xor", b.op(Op::kXor, 9, {x, level}));
  b.output("o_not", b.op(Op::kNot, 9, {x}));
  b.output("o_sub", b.sub(x, y), true);
  b.output("o_mul", b.op(Op::kMul, 20, {x, y}));
  b.output("o_mul_signed", b.op(Op::kMulSigned, 20, {x, y}), true);
  b.output("o_shl", b.op(Op::kShl, 9, {x, n}));
  b.output("o_lshr", b.op(Op::kLshr, 9, {x, n}));
  b.output("o_ashr", b.op(Op::kAshr, 9, {x, n}));
  b.output("o_eq", b.op(Op::kEq, 1, {slice(x, 2, 0), slice(y, 4, 2)}));
  b.output("o_ult", b.op(Op::kUlt, 1, {x, y}));
  b.output("o_slt", b.op(Op::kSlt, 1, {x, y}));
  b.output("o_mux", b.mux({x[3]}, x, y));
  b.output("o_any", b.op(Op::kReduceOr, 1, {slice(x, 8, 6)}));
  b.output("o_all", b.op(Op::kReduceAnd, 1, {slice(x, 8, 6)}));
  b.output("o_parity", b.op(Op::kReduceXor, 1, {x}));
  b.output("o_config", b.op(Op::kAdd, 9, {level, constant(3, 9)}));
  b.output("o_constant", constant(0x2a, 7));
  b.output("o_signs", sign_extend(slice(x, 4, 2), 12));
  b.output("o_small_table", b.rom("small", n, 5, {1, 2, 3, 31, 16, 8, 4, 2, 1, 0, 5}));
  std::vector<std::uint64_t> words;
  for (unsigned i = 0; i < 400; ++i) words.push_back((i * 37U) & 255U);
  b.output("o_large_table", b.rom("large", x, 8, words));
  b.graph.output_valid = x[8];
  for (const Target target : {Target::kIce40Hx, Target::kEcp5}) {
    for (const double clock_ns : {8.0, 20.0}) {
      const auto options = at(clock_ns, target);
      const Graph g = lower_for_target(b.graph, options);
      const auto s = schedule(g, options);
      CHECK(check_module(g, s) == "");
    }
  }
}

TEST_CASE("what depends on configuration alone may take more than a clock", "[schedule]") {
  Builder b("quasi_static");
  const Bits x = b.input("x", 9);
  const Bits level = b.config("level", 9);
  Bits sum = level;
  while (b.graph.nodes.size() < 6) sum = b.op(Op::kAdd, 9, {sum, level});
  b.output("y", b.op(Op::kAdd, 9, {x, sum}));
  const auto options = at(5);
  const Graph g = lower_for_target(b.graph, options);
  const auto s = schedule(g, options);
  CHECK(s.warnings.empty());
  CHECK(verify_schedule(g, s).empty());
  CHECK(check_module(g, s) == "");
}

TEST_CASE("multiplications become adders that mean the same", "[schedule]") {
  const auto widths = GENERATE(std::pair{8U, 8U}, std::pair{12U, 3U}, std::pair{5U, 11U}, std::pair{1U, 7U});
  const bool with_sign = GENERATE(false, true);
  Builder b("multiply");
  const Bits x = b.input("x", widths.first), y = b.input("y", widths.second);
  const Op op = with_sign ? Op::kMulSigned : Op::kMul;
  b.output("full", b.op(op, widths.first + widths.second, {x, y}));
  b.output("low", b.op(op, 6, {zero_extend(x, 6), zero_extend(y, 6)}));
  for (const std::uint64_t c : {0U, 1U, 3U, 7U, 85U, 119U, 213U, 255U}) {
    b.output("by" + std::to_string(c), b.op(op, widths.first + 8, {x, constant(c, 8)}));
  }
  const auto options = at(8);
  const Graph lowered = lower_for_target(b.graph, options);
  Interpreter before(b.graph), after(lowered);
  std::mt19937_64 random(7);
  for (int i = 0; i < 3000; ++i) {
    const std::vector<std::uint64_t> in{random() & ((1ULL << widths.first) - 1),
                                        random() & ((1ULL << widths.second) - 1)};
    REQUIRE(before.step(in, {}).outputs == after.step(in, {}).outputs);
  }
}

TEST_CASE("the sign of a factor may be constant", "[schedule]") {
  Builder b("negative");
  const Bits x = b.input("x", 12), y = b.input("y", 4);
  // -8 + y[2:0], sign-extended: the row of negative weight is not gated by a variable bit.
  b.output("negative", b.op(Op::kMulSigned, 12, {x, concat({constant(1, 1), slice(y, 2, 0)})}));
  b.output("extended", b.op(Op::kMul, 12, {x, concat({constant(511, 9), slice(y, 2, 0)})}));
  for (const Target target : {Target::kIce40Hx, Target::kEcp5}) {
    const Graph lowered = lower_for_target(b.graph, at(8, target));
    Interpreter before(b.graph), after(lowered);
    for (std::uint64_t i = 0; i < 1U << 16U; i += 7) {
      const std::vector<std::uint64_t> in{i & 0xFFFU, i >> 12U};
      REQUIRE(before.step(in, {}).outputs == after.step(in, {}).outputs);
    }
  }
}

TEST_CASE("what lies far away leaves less of the clock", "[schedule]") {
  const auto longer_by = [](const Graph& graph, double DelayModel::* route_ns) {
    auto options = at(5.4, Target::kEcp5);
    REQUIRE(options.delays.*route_ns > 0);
    const Schedule far = schedule(graph, options);
    CHECK(verify_schedule(graph, far).empty());
    options.delays.*route_ns = 0;
    Schedule near = schedule(graph, options);
    CHECK(verify_schedule(graph, near).empty());
    near.options = far.options;
    CHECK_FALSE(verify_schedule(graph, near).empty());
    return far.latency - near.latency;
  };
  SECTION("a hard multiplier") {
    Builder b("scaled");
    const Bits x = b.input("x", 8), y = b.input("y", 8), z = b.input("z", 16);
    const Bits difference = b.op(Op::kSub, 16, {b.op(Op::kMul, 16, {x, y}), z});
    b.output("less", b.op(Op::kUlt, 1, {difference, z}));
    CHECK(longer_by(b.graph, &DelayModel::multiplier_route_ns) == 1);
  }
  SECTION("configuration") {
    Builder b("compared");
    const Bits x = b.input("x", 16), level = b.config("level", 16);
    b.output("less", b.op(Op::kUlt, 1, {b.op(Op::kAdd, 16, {x, level}), x}));
    CHECK(longer_by(b.graph, &DelayModel::config_route_ns) == 1);
  }
}

TEST_CASE("a CRC bit by bit becomes parities and meets the clock", "[schedule]") {
  Builder b("crc");
  const Bits x = b.input("x", 8), first = b.input("first", 1);
  const Bits crc = b.state("crc", 32);
  Bits value = b.mux(first, constant(0xFFFFFFFF, 32), crc);
  value = b.op(Op::kXor, 32, {value, zero_extend(x, 32)});
  for (int i = 0; i < 8; ++i) {
    Bits mask;
    for (std::uint32_t k = 0; k < 32; ++k) mask.push_back(((0xEDB88320U >> k) & 1U) != 0 ? value[0] : kZero);
    value = b.op(Op::kXor, 32, {zero_extend(slice(value, 31, 1), 32), mask});
  }
  b.set_next(crc, value);
  b.output("crc", value);
  const auto options = at(8);
  const Graph g = lower_for_target(b.graph, options);
  const auto s = schedule(g, options);
  CHECK(s.stage_delay_ns[0] < 6.0);
  CHECK(check_module(g, s) == "");
  Interpreter before(b.graph), after(g);
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<std::uint64_t> in{random() & 255U, static_cast<std::uint64_t>(random() % 16 == 0)};
    REQUIRE(before.step(in, {}).outputs == after.step(in, {}).outputs);
  }
}

TEST_CASE("the fewest register bits, against exhaustive search", "[schedule]") {
  std::mt19937 random(GENERATE(range(1, 30)));
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  constexpr int kVariables = 6, kLatest = 3;
  std::vector<detail::DifferenceConstraint> constraints;
  std::vector<long> weight(kVariables, 0);
  for (int i = 0; i < 9; ++i) {
    const auto a = static_cast<std::uint32_t>(pick(kVariables - 1));
    const auto to = a + 1 + static_cast<std::uint32_t>(pick(kVariables - 1 - static_cast<int>(a)));
    constraints.push_back({a, to, pick(2)});
    const long bits = pick(9);
    weight[to] += bits;
    weight[a] -= bits;
  }
  constraints.push_back({kVariables - 1, 0, -kLatest});
  for (std::uint32_t i = 0; i + 1 < kVariables; ++i) constraints.push_back({i, kVariables - 1, 0});
  std::vector<bool> pinned(kVariables, false);
  pinned[kVariables - 1] = true;
  const auto feasible = [&](const std::vector<int>& s) {
    for (const auto& c : constraints) {
      if (s[c.to] - s[c.from] < c.difference) return false;
    }
    return true;
  };
  const auto cost = [&](const std::vector<int>& s) {
    long sum = 0;
    for (std::size_t i = 0; i < s.size(); ++i) sum += weight[i] * s[i];
    return sum;
  };
  std::optional<long> best;
  std::vector<int> least;
  std::vector<int> s(kVariables, 0);
  s.back() = kLatest;
  for (int code = 0; code < 1024; ++code) {
    for (int i = 0, rest = code; i + 1 < kVariables; ++i, rest /= 4) s[static_cast<std::size_t>(i)] = rest % 4;
    if (!feasible(s)) continue;
    best = best ? std::min(*best, cost(s)) : cost(s);
    if (least.empty()) least = s;
    for (std::size_t i = 0; i < s.size(); ++i) least[i] = std::min(least[i], s[i]);
  }
  if (!best) return;
  detail::minimise_linear(constraints, weight, pinned, least);
  CHECK(feasible(least));
  CHECK(cost(least) == *best);
}

TEST_CASE("the verifier finds what is wrong with a schedule", "[schedule]") {
  const Graph g = low_pass(384);
  const auto good = schedule(g, at(8));
  REQUIRE(verify_schedule(g, good).empty());
  SECTION("a state read after its next value's stage") {
    for (const State& state : g.states) {
      auto bad = good;
      bad.stage[state.read] = state.name == "c0" ? 0 : bad.stage[state.read] - 1;
      if (bad.stage[state.read] == good.stage[state.read] || bad.stage[state.read] < 0) continue;
      CHECK_FALSE(verify_schedule(g, bad).empty());
    }
  }
  SECTION("a write in the stage of the read") {
    auto bad = good;
    bad.ram_write_stage[0] = bad.ram_read_stage[0];
    CHECK_FALSE(verify_schedule(g, bad).empty());
  }
  SECTION("too much in one stage") {
    auto bad = good;
    for (auto& stage : bad.stage) stage = std::min(stage, 1);
    CHECK_FALSE(verify_schedule(g, bad).empty());
  }
}
