// SPDX-License-Identifier: Apache-2.0
// LLVM's comparisons and pure integer intrinsics as graph nodes.
#pragma once

#include <llvm/IR/InstrTypes.h>
#include <llvm/IR/Intrinsics.h>

#include <optional>
#include <vector>

#include "hlsc/builder.hpp"

namespace hlsc {

/// Debug information, lifetimes, assumptions: nothing happens.
bool is_ignored_intrinsic(llvm::Intrinsic::ID id);

/// nullopt: not supported. `width`: of the result, with the parts of a structure one after another.
std::optional<Bits> evaluate_intrinsic(Builder& builder, llvm::Intrinsic::ID id, const std::vector<Bits>& arguments,
                                       std::uint64_t width);

Bit comparison(Builder& builder, llvm::CmpInst::Predicate predicate, const Bits& a, const Bits& b);

}  // namespace hlsc
