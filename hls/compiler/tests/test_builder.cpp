// SPDX-License-Identifier: Apache-2.0
// Every operation of the builder, with all its simplifications, against plain arithmetic on random operands: bits of
// inputs, constants, repeated bits, results of earlier operations. What is lowered for a target must mean the same.
#include <catch2/catch.hpp>
#include <random>

#include "hlsc/builder.hpp"
#include "hlsc/interpret.hpp"
#include "hlsc/schedule.hpp"

using namespace hlsc;

namespace {

class Bench {
 public:
  explicit Bench(std::uint64_t seed) : random(seed) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      inputs.push_back(builder.source(Op::kInput, i, 7, "x" + std::to_string(i)));
      pool.push_back(inputs.back());
    }
  }

  /// Zero- or sign-extended, shifted or partly constant pieces of what there is.
  Bits operand(std::size_t width) {
    Bits bits;
    while (bits.size() < width) {
      const Bits& from = pool[random() % pool.size()];
      const std::size_t low = random() % from.size(), count = 1 + random() % (from.size() - low);
      switch (random() % 6) {
        case 0:
          bits.push_back(kZero);
          break;
        case 1:
          bits.push_back(kOne);
          break;
        case 2:
          bits.resize(width, kZero);
          break;
        case 3:
          if (!bits.empty()) bits.resize(width, bits.back());
          break;
        default:
          bits.insert(bits.end(), from.begin() + static_cast<std::ptrdiff_t>(low),
                      from.begin() + static_cast<std::ptrdiff_t>(low + count));
      }
    }
    bits.resize(width);
    return bits;
  }

  Graph graph_of(const std::vector<Bits>& outputs) {
    Graph graph;
    graph.nodes = builder.nodes();
    for (const Bits& input : inputs) {
      Port port;
      port.width = 7;
      port.node = input[0].node;
      graph.inputs.push_back(port);
    }
    for (const Bits& bits : outputs) {
      Port port;
      port.value = bits;
      graph.outputs.push_back(port);
    }
    return graph;
  }

  std::uint64_t evaluate(const Bits& bits, const std::vector<Value>& values) {
    return to_integer(Interpreter(graph_of({bits})).step(values, {}).outputs[0]);
  }

  std::mt19937_64 random;
  Builder builder;
  std::vector<Bits> inputs, pool;
};

std::int64_t extended(std::uint64_t value, std::size_t width) {
  return static_cast<std::int64_t>(value << (64 - width)) >> (64 - width);
}

}  // namespace

TEST_CASE("operations and their simplifications", "[builder]") {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Bench bench(seed);
    Builder& b = bench.builder;
    struct Check {
      std::string name;
      Bits result, x, y, z;
      int operation;
    };
    std::vector<Check> checks;
    for (int i = 0; i < 12; ++i) {
      const std::size_t width = 1 + bench.random() % 12;
      const int operation = static_cast<int>(bench.random() % 16);
      const Bits x = bench.operand(width), c = bench.operand(1), amount = bench.operand(4);
      const Bits y = operation == 15 ? Builder::constant(bench.random(), width) : bench.operand(width);
      Bits result;
      switch (operation) {
        case 0:
          result = b.add(x, y);
          break;
        case 1:
          result = b.sub(x, y);
          break;
        case 2:
        case 15:
          result = b.mul(x, y);
          break;
        case 3:
          result = b.bit_and(x, y);
          break;
        case 4:
          result = b.bit_or(x, y);
          break;
        case 5:
          result = b.bit_xor(x, y);
          break;
        case 6:
          result = b.bit_not(x);
          break;
        case 7:
          result = {b.eq(x, y)};
          break;
        case 8:
          result = {b.ult(x, y)};
          break;
        case 9:
          result = {b.slt(x, y)};
          break;
        case 10:
          result = b.mux(c[0], x, y);
          break;
        case 11:
          result = b.shl(x, amount);
          break;
        case 12:
          result = b.lshr(x, amount);
          break;
        case 13:
          result = b.ashr(x, amount);
          break;
        default:
          result = {b.reduce_or(x), b.reduce_and(x), b.reduce_xor(x)};
          break;
      }
      checks.push_back({"operation " + std::to_string(operation), result, x,
                        operation >= 11 && operation <= 13 ? amount : y, c, operation});
      bench.pool.push_back(result);
    }
    const std::vector<Bits> results(bench.pool.begin() + static_cast<std::ptrdiff_t>(bench.inputs.size()),
                                    bench.pool.end());
    const Graph plain = bench.graph_of(results);
    std::vector<Graph> lowered;
    for (const Target target : {Target::kIce40Hx, Target::kEcp5}) {
      ScheduleOptions options;
      options.delays = make_delay_model(target);
      lowered.push_back(lower_for_target(plain, options));
    }
    for (int round = 0; round < 10; ++round) {
      std::vector<Value> values;
      values.reserve(bench.inputs.size());
      for (std::size_t i = 0; i < bench.inputs.size(); ++i) values.push_back(to_value(bench.random(), 7));
      for (const Check& check : checks) {
        const std::size_t width = check.x.size();
        const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
        const std::uint64_t x = bench.evaluate(check.x, values), y = bench.evaluate(check.y, values),
                            z = bench.evaluate(check.z, values);
        std::uint64_t expected = 0;
        switch (check.operation) {
          case 0:
            expected = x + y;
            break;
          case 1:
            expected = x - y;
            break;
          case 2:
          case 15:
            expected = x * y;
            break;
          case 3:
            expected = x & y;
            break;
          case 4:
            expected = x | y;
            break;
          case 5:
            expected = x ^ y;
            break;
          case 6:
            expected = ~x;
            break;
          case 7:
            expected = x == y ? 1 : 0;
            break;
          case 8:
            expected = x < y ? 1 : 0;
            break;
          case 9:
            expected = extended(x, width) < extended(y, width) ? 1 : 0;
            break;
          case 10:
            expected = z != 0 ? x : y;
            break;
          case 14:
            expected = (x != 0 ? 1U : 0U) | (x == mask ? 2U : 0U) | (static_cast<unsigned>(__builtin_parityll(x)) << 2);
            break;
          default:
            if (y >= width) continue;  // undefined in C++
            expected = check.operation == 11   ? x << y
                       : check.operation == 12 ? x >> y
                                               : static_cast<std::uint64_t>(extended(x, width) >> y);
        }
        const std::uint64_t result_mask = (std::uint64_t{1} << check.result.size()) - 1;
        const std::uint64_t got = bench.evaluate(check.result, values);
        if (got != (expected & result_mask)) {
          FAIL(check.name << ", seed " << seed << ", width " << width << ": " << x << ", " << y << ", " << z << " gave "
                          << got << " instead of " << (expected & result_mask));
        }
      }
      const std::vector<Value> outputs = Interpreter(plain).step(values, {}).outputs;
      for (const Graph& graph : lowered) {
        INFO("lowered, seed " << seed);
        REQUIRE(Interpreter(graph).step(values, {}).outputs == outputs);
      }
    }
  }
  SUCCEED();
}

TEST_CASE("equal nodes are made once", "[builder]") {
  Builder b;
  const Bits x = b.source(Op::kInput, 0, 8, "x"), y = b.source(Op::kInput, 1, 8, "y");
  CHECK(b.add(x, y) == b.add(y, x));
  CHECK(b.bit_and(x, y) == b.bit_and(y, x));
  CHECK(b.eq(x, y) == b.eq(y, x));
  CHECK(b.bit_not(b.bit_not(x)) == x);
  const std::size_t before = b.nodes().size();
  b.add(x, y);
  CHECK(b.nodes().size() == before);
}

TEST_CASE("a bit and its complement are one condition", "[builder]") {
  Builder b;
  const Bit c = b.source(Op::kInput, 0, 1, "c")[0];
  CHECK(b.eq({c, b.bit_not(c)}, {kZero, kOne}) == b.bit_not(c));
  CHECK(b.eq({b.bit_not(c), c}, {kZero, kOne}) == c);
  CHECK(b.eq({c, b.bit_not(c)}, {kOne, kOne}) == kZero);
}

TEST_CASE("a sum is as wide as its largest value", "[builder]") {
  Builder b;
  Bits sum = Builder::constant(0, 32);
  for (std::uint32_t i = 0; i < 9; ++i) sum = b.add(sum, Builder::zero_extend(b.source(Op::kInput, i, 4, "x"), 32));
  std::size_t width = sum.size();
  while (sum[width - 1] == kZero) --width;
  CHECK(width == 8);  // 9 · 15 = 135, not 4 + 8 bits
  CHECK(b.ult(sum, Builder::constant(136, 32)) == kOne);
  CHECK(b.ult(sum, Builder::constant(135, 32)) != kOne);
}

TEST_CASE("an undefined side of a multiplexer is the other side", "[builder]") {
  Builder b;
  const Bits c = b.source(Op::kInput, 0, 1, "c"), x = b.source(Op::kInput, 1, 8, "x"), u = b.undefined(8, "nobody's");
  CHECK(b.mux(c[0], x, u) == x);
  CHECK(b.mux(c[0], u, x) == x);
  CHECK(b.mux(c[0], b.mux(c[0], x, Builder::constant(3, 8)), Builder::constant(5, 8)) ==
        b.mux(c[0], x, Builder::constant(5, 8)));
  CHECK(b.mux(b.bit_not(c[0]), x, Builder::constant(1, 8)) == b.mux(c[0], Builder::constant(1, 8), x));
}
