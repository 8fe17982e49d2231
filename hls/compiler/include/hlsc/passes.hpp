// SPDX-License-Identifier: Apache-2.0
// Brings a stage's IR into the form the symbolic execution takes: each entry point one function without calls and
// loops. Our own pass list, because the stock pipelines vectorise, reassociate and do not inline reliably.
#pragma once

#include <llvm/IR/DebugLoc.h>
#include <llvm/IR/Module.h>

#include "hlsc/graph.hpp"
#include "hlsc/options.hpp"

namespace hlsc {

/// Fills every local Out with kUnsetOut: LLVM takes a value that is set on one path only for one that is set on all.
void mark_unset(llvm::Module& module);

/// Of the entry points only this one remains, with what it needs.
void keep_only(llvm::Module& module, const Options& options, const char* function);

/// Throws CompileError for calls and loops that cannot be removed.
void prepare(llvm::Module& module, const Options& options);

/// The innermost place that is the user's: not in the standard library, not in horopter/hls.
SourceLocation location_of(const llvm::DebugLoc& location);
SourceLocation location_of(const llvm::Instruction& instruction);

}  // namespace hlsc
