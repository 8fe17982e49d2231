// SPDX-License-Identifier: Apache-2.0
// From a stage class to its graph.
#pragma once

#include "hlsc/graph.hpp"
#include "hlsc/layout.hpp"
#include "hlsc/options.hpp"

namespace hlsc {

struct Stage {
  Graph graph;  ///< finished: shrunk, in topological order
  /// Where the ports lie in the C++ objects, in the order of the graph's ports (`valid` of Out included in `out`).
  Layout in, config, out;
};

/// Throws CompileError (the stage is not synthesisable) or ClangError (it is not C++).
Stage compile_stage(const Options& options);

/// The same, from the wrapper's bitcode.
Stage compile_bitcode(const std::string& path, const Options& options);

}  // namespace hlsc
