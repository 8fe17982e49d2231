// SPDX-License-Identifier: Apache-2.0
// Takes away what a draft does not need, and checks what is left.
#pragma once

#include "hlsc/draft.hpp"
#include "hlsc/graph.hpp"

namespace hlsc {

/// State and memory bits that never change become constants, equal ones become one; what no output depends on goes;
/// operations narrow to the bits somebody uses. Ports stay. Then: throws CompileError if an undefined value is left, if
/// a state has no initial value, or if memories read each other in a circle; puts the nodes in topological order.
Graph finish(Draft draft);

}  // namespace hlsc
