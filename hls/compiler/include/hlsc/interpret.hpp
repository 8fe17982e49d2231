// SPDX-License-Identifier: Apache-2.0
// Executes a graph, one step at a time, as the hardware would without its pipeline: the model that compiled stages are
// tested with. What the graph leaves open (data of a memory that is not enabled) is filled with changing garbage.
#pragma once

#include <cstdint>
#include <vector>

#include "hlsc/graph.hpp"

namespace hlsc {

/// Bits of a value, least significant first.
using Value = std::vector<bool>;

class Interpreter {
 public:
  explicit Interpreter(const Graph& graph, bool check_distance = true);

  struct Result {
    bool valid = false;
    std::vector<Value> outputs;  ///< in the order of the graph's outputs
  };
  /// Inputs and configs in the order of the graph's ports. Throws std::logic_error where memories break their contract.
  Result step(const std::vector<Value>& inputs, const std::vector<Value>& configs);

  /// What rst_ni does: states to their initial values, memories kept.
  void reset();

 private:
  void evaluate(const Node& node, Value& value);
  [[nodiscard]] bool bit(Bit at) const { return values_[at.node][at.index]; }
  [[nodiscard]] Value bits(const Bits& at) const;

  const Graph& graph_;
  bool check_distance_;
  std::vector<Value> values_;  ///< by node
  std::vector<Value> states_;
  std::vector<std::vector<Value>> memories_;
  std::vector<std::vector<std::uint64_t>> last_write_;  ///< step + 1
  std::uint64_t step_ = 0;
  std::uint64_t garbage_ = 0x9E3779B97F4A7C15ULL;
};

std::uint64_t to_integer(const Value& value);
Value to_value(std::uint64_t value, std::size_t width);

}  // namespace hlsc
