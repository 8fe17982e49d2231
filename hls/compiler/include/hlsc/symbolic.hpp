// SPDX-License-Identifier: Apache-2.0
// Executes a function without loops and calls on bit vectors of graph nodes, all paths at once.
//
// Where paths meet, values are chosen by multiplexers along the branches between the meeting point and its immediate
// dominator; conditions further up do not appear, because the value is not used unless they hold.
#pragma once

#include <llvm/IR/Module.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hlsc/builder.hpp"
#include "hlsc/memory.hpp"

namespace hlsc {

/// Calls of __hlsc_ram_*; `pointer` is the memory's `this`, `active` the absolute condition of the call.
class RamPorts {
 public:
  virtual ~RamPorts() = default;
  virtual void init(Contents& contents, const Bits& pointer, const Bits& initial) = 0;
  virtual Bits read(Contents& contents, const Bits& pointer, const Bits& address, std::uint64_t bytes, Bit active) = 0;
  virtual void write(Contents& contents, const Bits& pointer, const Bits& address, const Bits& data, Bit active) = 0;
};

class Symbolic {
 public:
  Symbolic(Builder& builder, Memory& memory, RamPorts& rams, const llvm::Module& module);

  /// What `variable` is, which hlsc's own code declares.
  void bind(const llvm::GlobalVariable& variable, ObjectId object) { globals_[&variable] = object; }
  /// Contents after `function` with these pointer arguments.
  Contents run(const llvm::Function& function, const std::vector<Bits>& arguments, Contents contents);

 private:
  struct Block {
    Contents at_end;
    Bit active = kZero;  ///< absolute condition
  };
  class Run;

  Bits value_of_constant(const llvm::Constant& constant);
  void fill(Bits& bits, std::uint64_t offset_bits, const llvm::Constant& constant);
  ObjectId object_of(const llvm::GlobalVariable& variable);
  std::uint64_t width(const llvm::Type* type) const;

  Builder& builder_;
  Memory& memory_;
  RamPorts& rams_;
  const llvm::Module& module_;
  std::map<const llvm::GlobalVariable*, ObjectId> globals_;
  std::map<ObjectId, Bits> tables_;  ///< contents of constant globals
};

}  // namespace hlsc
