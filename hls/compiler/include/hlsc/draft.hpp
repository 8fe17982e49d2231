// SPDX-License-Identifier: Apache-2.0
// A graph as the symbolic execution leaves it: correct, but full of what C++ storage drags along.
#pragma once

#include <vector>

#include "hlsc/graph.hpp"

namespace hlsc {

/// Nodes that are kInput with port kUndefinedPort or kUnsetPort stand for values nobody has set: finish() refuses those
/// that matter.
struct Draft {
  Graph graph;
  std::vector<std::vector<bool>> uninitialised;  ///< per state, per bit: the constructor leaves it open
  std::vector<SourceLocation> state_where;
  std::vector<SourceLocation> output_where;
};

}  // namespace hlsc
