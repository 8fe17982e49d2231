// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hlsc/graph.hpp"

namespace hlsc {

/// The graph as text: one node a line, for people and for tests.
std::string dump(const Graph& graph);
const char* name_of(Op op);

}  // namespace hlsc
