// SPDX-License-Identifier: Apache-2.0
// Brings a stage's IR into the form the symbolic execution takes: each entry point one function without calls and
// loops. Our own pass list, because the stock pipelines vectorise, reassociate and do not inline reliably.
#pragma once

#include <llvm/IR/DebugLoc.h>
#include <llvm/IR/Module.h>

#include "hlsc/graph.hpp"
#include "hlsc/options.hpp"

namespace hlsc {

/// Throws CompileError for calls and loops that cannot be removed.
void prepare(llvm::Module& module, const Options& options);

/// The innermost place that is the user's: not in the standard library, not in horopter/hls.
SourceLocation location_of(const llvm::DebugLoc& location);
SourceLocation location_of(const llvm::Instruction& instruction);

}  // namespace hlsc
