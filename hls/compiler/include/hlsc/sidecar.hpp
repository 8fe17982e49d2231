// SPDX-License-Identifier: Apache-2.0
// The JSON file beside each emitted module: what other tools need to know without reading SystemVerilog.
#pragma once

#include "hlsc/emit.hpp"

namespace hlsc {

std::string sidecar(const Graph& graph, const Schedule& schedule, const EmitOptions& options,
                    const EmittedModule& module);

}  // namespace hlsc
