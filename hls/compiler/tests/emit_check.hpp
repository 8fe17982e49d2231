// SPDX-License-Identifier: Apache-2.0
// For tests of the backend: graphs built by hand, their meaning (an interpreter of one step), and a check of what is
// emitted: lint, yosys, and a simulation in iverilog against the interpreter with gaps and stalls.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "hlsc/emit.hpp"
#include "hlsc/graph.hpp"
#include "hlsc/schedule.hpp"

namespace hlsc::test {

class Builder {
 public:
  explicit Builder(std::string name);
  Bits input(const std::string& name, std::uint32_t width, bool is_signed = false);
  Bits config(const std::string& name, std::uint32_t width);
  /// The value before the step; give the next one with set_next.
  Bits state(const std::string& name, std::uint32_t width, std::uint64_t initial = 0);
  void set_next(const Bits& state, const Bits& next);
  void output(const std::string& name, const Bits& value, bool is_signed = false);
  Bits op(Op op, std::uint32_t width, std::vector<Bits> operands, const std::string& name = "");
  Bits add(const Bits& a, const Bits& b, const std::string& name = "");  ///< unsigned, one bit wider
  Bits sub(const Bits& a, const Bits& b, const std::string& name = "");  ///< of equal width, wraps
  Bits mux(const Bits& condition, const Bits& a, const Bits& b);
  Bits rom(const std::string& name, const Bits& address, std::uint32_t width, const std::vector<std::uint64_t>& words);
  /// Reads `address`; give the write with ram_write.
  Bits ram_read(const std::string& name, std::uint32_t depth, std::uint32_t width, std::uint32_t distance,
                const Bits& address);
  void ram_write(const std::string& name, const Bits& address, const Bits& data, const Bits& enable);

  unsigned line = 1;  ///< of what is made next
  Graph graph;

 private:
  NodeId node(Node n);
};

Bits constant(std::uint64_t value, std::uint32_t width);
Bits zero_extend(Bits bits, std::uint32_t width);
Bits sign_extend(Bits bits, std::uint32_t width);
Bits slice(const Bits& bits, std::uint32_t high, std::uint32_t low);
Bits concat(const std::vector<Bits>& most_significant_first);

/// Runs steps of a graph; values of up to 64 bits.
class Interpreter {
 public:
  explicit Interpreter(const Graph& graph);
  struct Result {
    std::vector<std::uint64_t> outputs;
    bool valid = true;
  };
  Result step(const std::vector<std::uint64_t>& inputs, const std::vector<std::uint64_t>& configs);
  void reset();

 private:
  bool bit(Bit b) const { return b.node == 0 ? b.index != 0 : ((value_[b.node] >> b.index) & 1U) != 0; }
  std::uint64_t gather(const Bits& bits) const;
  const Graph& g_;
  std::vector<std::uint64_t> value_, state_;
  std::vector<std::vector<std::uint64_t>> memory_;
};

/// Empty if the module lints clean, is read by yosys and behaves like the interpreter for `steps` random beats; with
/// options.ram_parity also if it finds a bit of each word of each RAM that changes after them, and none before.
/// Otherwise what is wrong. A missing tool is an error that names it.
std::string check_module(const Graph& graph, const Schedule& schedule, unsigned steps = 2000, unsigned seed = 1,
                         const EmitOptions& options = {});

/// Output of a shell command and whether it succeeded.
std::pair<std::string, bool> run_command(const std::string& command);

}  // namespace hlsc::test
