// SPDX-License-Identifier: Apache-2.0
#include "hlsc/symbolic.hpp"

#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/Demangle/Demangle.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/DebugInfo.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IR/Operator.h>

#include <algorithm>
#include <optional>
#include <set>

#include "hlsc/diagnostics.hpp"
#include "hlsc/intrinsics.hpp"
#include "hlsc/passes.hpp"

namespace hlsc {

namespace {

using llvm::BasicBlock;
using llvm::Instruction;

[[noreturn]] void refuse(const Instruction& instruction, const std::string& why) {
  throw CompileError(location_of(instruction), why);
}

std::string readable(const llvm::GlobalValue& value) { return llvm::demangle(value.getName().str()); }

Bits constant_of(const llvm::APInt& value) {
  Bits bits(value.getBitWidth());
  for (unsigned i = 0; i < value.getBitWidth(); ++i) bits[i] = value[i] ? kOne : kZero;
  return bits;
}

/// Arrays inside an LLVM type, to bound variable indices.
void collect_arrays(const llvm::Type* type, std::uint64_t offset, const llvm::DataLayout& layout, Object& object) {
  if (object.arrays.size() > 4096) return;
  if (const auto* array = llvm::dyn_cast<llvm::ArrayType>(type)) {
    const std::uint64_t stride = layout.getTypeAllocSizeInBits(array->getElementType());
    object.arrays.push_back({object.name, offset, stride, array->getNumElements()});
    if (!array->getElementType()->isAggregateType()) return;
    for (std::uint64_t i = 0; i < array->getNumElements(); ++i) {
      collect_arrays(array->getElementType(), offset + i * stride, layout, object);
    }
  } else if (auto* structure = llvm::dyn_cast<llvm::StructType>(const_cast<llvm::Type*>(type))) {
    const llvm::StructLayout* places = layout.getStructLayout(structure);
    for (unsigned i = 0; i < structure->getNumElements(); ++i) {
      collect_arrays(structure->getElementType(i), offset + places->getElementOffsetInBits(i), layout, object);
    }
  }
}

}  // namespace

/// One execution of one function.
class Symbolic::Run {
 public:
  Run(Symbolic& machine, const llvm::Function& function)
      : machine_(machine),
        builder_(machine.builder_),
        memory_(machine.memory_),
        function_(function),
        layout_(machine.module_.getDataLayout()),
        dominators_(const_cast<llvm::Function&>(function)) {
    find_returning();
  }

  Contents execute(const std::vector<Bits>& arguments, Contents contents) {
    for (unsigned i = 0; i < arguments.size(); ++i) values_[function_.getArg(i)] = arguments[i];
    for (const auto& [object, bits] : machine_.tables_) contents.set(object, bits);
    std::optional<Contents> result;
    const llvm::ReversePostOrderTraversal<const llvm::Function*> order(&function_);
    const BasicBlock* const entry = &function_.getEntryBlock();
    blocks_[entry].active = kOne;
    blocks_[entry].at_end = std::move(contents);
    for (const BasicBlock* block : order) {
      Block& state = blocks_[block];
      if (block != entry) enter(*block, state);
      if (state.active == kZero) continue;
      for (const Instruction& instruction : *block) {
        if (llvm::isa<llvm::PHINode>(instruction)) continue;
        builder_.where = location_of(instruction);
        step(instruction, state);
      }
      if (llvm::isa<llvm::ReturnInst>(block->getTerminator())) result = state.at_end;
    }
    if (!result) throw CompileError(where_of_function(), "no path through the step returns");
    return *result;
  }

 private:
  // ---- control flow ----

  SourceLocation where_of_function() const {
    const llvm::DISubprogram* program = function_.getSubprogram();
    return program == nullptr ? SourceLocation{}
                              : SourceLocation{tidy_path(program->getFilename().str()), program->getLine()};
  }

  void find_returning() {
    std::vector<const BasicBlock*> work;
    for (const BasicBlock& block : function_) {
      if (llvm::isa<llvm::ReturnInst>(block.getTerminator())) work.push_back(&block);
    }
    while (!work.empty()) {
      const BasicBlock* block = work.back();
      work.pop_back();
      if (!returning_.insert(block).second) continue;
      for (const BasicBlock* before : llvm::predecessors(block)) work.push_back(before);
    }
  }

  /// The blocks on paths from `top` (included) to `join` (excluded).
  std::set<const BasicBlock*> region(const BasicBlock& top, const BasicBlock& join) const {
    std::set<const BasicBlock*> found;
    std::vector<const BasicBlock*> work(llvm::pred_begin(&join), llvm::pred_end(&join));
    while (!work.empty()) {
      const BasicBlock* block = work.back();
      work.pop_back();
      if (!found.insert(block).second || block == &top) continue;
      for (const BasicBlock* before : llvm::predecessors(block)) work.push_back(before);
    }
    return found;
  }

  using Incoming = std::function<std::optional<Bits>(const BasicBlock&)>;

  /// The value that arrives at `join` from its immediate dominator, chosen branch by branch.
  class Gate {
   public:
    Gate(Run& run, const BasicBlock& join, const std::set<const BasicBlock*>& region, Incoming incoming,
         std::optional<Bits> elsewhere)
        : run_(run), join_(join), region_(region), incoming_(std::move(incoming)), elsewhere_(std::move(elsewhere)) {}

    std::optional<Bits> from(const BasicBlock& block) {
      const auto found = known_.find(&block);
      if (found != known_.end()) return found->second;
      std::optional<Bits> value;
      if (run_.blocks_.at(&block).active != kZero) value = decide(block);
      known_[&block] = value;
      return value;
    }

   private:
    std::optional<Bits> along(const BasicBlock& block, const BasicBlock& next) {
      if (&next == &join_) return incoming_(block);
      if (region_.contains(&next)) return from(next);
      return run_.returning_.contains(&next) ? elsewhere_ : std::nullopt;
    }

    std::optional<Bits> choose(Bit condition, const std::function<std::optional<Bits>()>& yes,
                               const std::function<std::optional<Bits>()>& no) {
      if (condition == kOne) return yes();
      if (condition == kZero) return no();
      const std::optional<Bits> a = yes(), b = no();
      if (!a) return b;
      if (!b) return a;
      return run_.builder_.mux(condition, *a, *b);
    }

    std::optional<Bits> decide(const BasicBlock& block) {
      const Instruction* end = block.getTerminator();
      if (const auto* branch = llvm::dyn_cast<llvm::BranchInst>(end)) {
        if (branch->isUnconditional()) return along(block, *branch->getSuccessor(0));
        const Bit condition = run_.value(branch->getCondition())[0];
        return choose(
            condition, [&] { return along(block, *branch->getSuccessor(0)); },
            [&] { return along(block, *branch->getSuccessor(1)); });
      }
      if (const auto* choice = llvm::dyn_cast<llvm::SwitchInst>(end)) {
        const Bits selector = run_.value(choice->getCondition());
        std::map<const BasicBlock*, Bit> cases;
        std::vector<const BasicBlock*> order;
        for (const auto& item : choice->cases()) {
          const BasicBlock* next = item.getCaseSuccessor();
          const Bit hit = run_.builder_.eq(selector, constant_of(item.getCaseValue()->getValue()));
          const auto [found, added] = cases.try_emplace(next, hit);
          if (added) {
            order.push_back(next);
          } else {
            found->second = run_.builder_.bit_or(found->second, hit);
          }
        }
        std::optional<Bits> value = along(block, *choice->getDefaultDest());
        for (const BasicBlock* next : order) {
          const std::optional<Bits> before = value;
          value = choose(cases[next], [&] { return along(block, *next); }, [&] { return before; });
        }
        return value;
      }
      return std::nullopt;
    }

    Run& run_;
    const BasicBlock& join_;
    const std::set<const BasicBlock*>& region_;
    Incoming incoming_;
    std::optional<Bits> elsewhere_;
    std::map<const BasicBlock*, std::optional<Bits>> known_;
  };

  void enter(const BasicBlock& block, Block& state) {
    builder_.where = location_of(block.front());
    const BasicBlock& top = *dominators_.getNode(&block)->getIDom()->getBlock();
    if (blocks_.at(&top).active == kZero) return;
    const std::set<const BasicBlock*> between = region(top, block);
    const auto gate = [&](Incoming incoming, std::optional<Bits> elsewhere) {
      return Gate(*this, block, between, std::move(incoming), std::move(elsewhere)).from(top);
    };
    const auto reached = gate([](const BasicBlock&) { return Bits{kOne}; }, Bits{kZero});
    if (!reached || (*reached)[0] == kZero) return;
    state.active = builder_.bit_and(blocks_.at(&top).active, (*reached)[0]);
    if (state.active == kZero) return;
    if (builder_.is_undefined((*reached)[0]))
      throw CompileError(builder_.where, "a branch depends on an uninitialised value");

    for (const llvm::PHINode& phi : block.phis()) {
      builder_.where = location_of(phi);
      const auto chosen =
          gate([&](const BasicBlock& before) { return std::optional(value(phi.getIncomingValueForBlock(&before))); },
               std::nullopt);
      set(phi,
          chosen ? *chosen : builder_.undefined(static_cast<std::uint32_t>(machine_.width(phi.getType())), "a value"));
    }
    merge(block, state, between, top);
  }

  void merge(const BasicBlock& block, Block& state, const std::set<const BasicBlock*>& between, const BasicBlock& top) {
    std::vector<const BasicBlock*> before;
    for (const BasicBlock* predecessor : llvm::predecessors(&block)) {
      if (blocks_.at(predecessor).active != kZero) before.push_back(predecessor);
    }
    state.at_end = blocks_.at(before.front()).at_end;
    if (before.size() == 1) return;
    const auto versions = state.at_end.versions();
    for (const auto& [id, version] : versions) {
      bool same = true;
      for (const BasicBlock* predecessor : before) {
        const Contents& contents = blocks_.at(predecessor).at_end;
        same &= contents.has(id) && contents.versions().at(id) == version;
      }
      if (same) continue;
      const std::size_t size = version->size();
      Bits merged(size);
      const std::set<std::uint64_t>& cuts = memory_.object(id).cuts;
      for (std::size_t low = 0; low < size;) {
        const auto differs = [&](std::size_t i) {
          for (const BasicBlock* predecessor : before) {
            if (blocks_.at(predecessor).at_end.of(id)[i] != (*version)[i]) return true;
          }
          return false;
        };
        const bool different = differs(low);
        std::size_t high = low + 1;
        while (high < size && !cuts.contains(high) && differs(high) == different) ++high;
        if (!different) {
          std::copy(version->begin() + static_cast<std::ptrdiff_t>(low),
                    version->begin() + static_cast<std::ptrdiff_t>(high),
                    merged.begin() + static_cast<std::ptrdiff_t>(low));
        } else {
          const auto chosen = Gate(
                                  *this, block, between,
                                  [&](const BasicBlock& predecessor) -> std::optional<Bits> {
                                    if (blocks_.at(&predecessor).active == kZero) return std::nullopt;
                                    return Builder::slice(blocks_.at(&predecessor).at_end.of(id), low, high - low);
                                  },
                                  std::nullopt)
                                  .from(top);
          std::copy(chosen->begin(), chosen->end(), merged.begin() + static_cast<std::ptrdiff_t>(low));
        }
        low = high;
      }
      state.at_end.set(id, std::move(merged));
    }
  }

  // ---- values ----

  Bits value(const llvm::Value* from) {
    if (const auto* constant = llvm::dyn_cast<llvm::Constant>(from)) return machine_.value_of_constant(*constant);
    const auto found = values_.find(from);
    if (found == values_.end()) {
      throw CompileError(builder_.where, "hlsc lost a value (internal error)");
    }
    return found->second;
  }

  void set(const Instruction& instruction, Bits bits) {
    if (const std::string name = variable_of(instruction); !name.empty()) builder_.name(bits, name);
    values_[&instruction] = std::move(bits);
  }

  /// The C++ variable that debug information says holds this value; of the user's code only.
  static std::string variable_of(const Instruction& instruction) {
    llvm::SmallVector<llvm::DbgValueInst*, 2> intrinsics;
    llvm::SmallVector<llvm::DbgVariableRecord*, 2> records;
    llvm::findDbgValues(intrinsics, const_cast<Instruction*>(&instruction), &records);
    const auto usable = [](const llvm::DILocalVariable* variable, const llvm::DIExpression* expression) {
      const llvm::StringRef file = variable->getFilename();
      return expression->getNumElements() == 0 && !variable->isArtificial() && !file.starts_with("/usr/") &&
             !file.contains("horopter/hls/") && !file.contains("hlsc_wrapper");
    };
    for (const llvm::DbgVariableRecord* record : records) {
      if (usable(record->getVariable(), record->getExpression())) return record->getVariable()->getName().str();
    }
    for (const llvm::DbgValueInst* intrinsic : intrinsics) {
      if (usable(intrinsic->getVariable(), intrinsic->getExpression()))
        return intrinsic->getVariable()->getName().str();
    }
    return {};
  }

  // ---- instructions ----

  void step(const Instruction& instruction, Block& state) {
    if (instruction.isTerminator()) {
      if (!llvm::isa<llvm::BranchInst, llvm::SwitchInst, llvm::ReturnInst, llvm::UnreachableInst>(instruction)) {
        refuse(instruction, std::string("control flow by `") + instruction.getOpcodeName() + "` has no hardware");
      }
      return;
    }
    if (instruction.getType()->isVectorTy()) refuse(instruction, "vector operations are not supported");
    for (const llvm::Value* operand : instruction.operand_values()) {
      if (operand->getType()->isFPOrFPVectorTy())
        refuse(instruction, "floating point has no hardware: use fixed point");
    }
    if (instruction.getType()->isFPOrFPVectorTy())
      refuse(instruction, "floating point has no hardware: use fixed point");
    if (instruction.isAtomic()) refuse(instruction, "atomic access has no hardware");
    if (instruction.isVolatile()) refuse(instruction, "volatile access has no hardware");

    if (const auto* binary = llvm::dyn_cast<llvm::BinaryOperator>(&instruction)) {
      set(instruction, arithmetic(*binary));
    } else if (const auto* compare = llvm::dyn_cast<llvm::ICmpInst>(&instruction)) {
      set(instruction, {comparison(builder_, compare->getPredicate(), value(compare->getOperand(0)),
                                   value(compare->getOperand(1)))});
    } else if (const auto* select = llvm::dyn_cast<llvm::SelectInst>(&instruction)) {
      const Bits condition = value(select->getCondition());
      set(instruction, builder_.mux(condition[0], value(select->getTrueValue()), value(select->getFalseValue())));
    } else if (const auto* cast = llvm::dyn_cast<llvm::CastInst>(&instruction)) {
      set(instruction, conversion(*cast));
    } else if (const auto* freeze = llvm::dyn_cast<llvm::FreezeInst>(&instruction)) {
      // Any value will do for what is undefined, but always the same one.
      Bits bits = value(freeze->getOperand(0));
      for (Bit& bit : bits) {
        if (builder_.is_undefined(bit)) bit = kZero;
      }
      set(instruction, std::move(bits));
    } else if (const auto* alloca = llvm::dyn_cast<llvm::AllocaInst>(&instruction)) {
      allocate(*alloca, state);
    } else if (const auto* load = llvm::dyn_cast<llvm::LoadInst>(&instruction)) {
      const std::uint64_t bits = machine_.width(load->getType());
      if (load->getType()->isAggregateType() && bits != layout_.getTypeStoreSizeInBits(load->getType())) {
        refuse(instruction, "a whole structure with padding is loaded at once: not supported");
      }
      const Bits stored =
          memory_.load(state.at_end, value(load->getPointerOperand()), layout_.getTypeStoreSizeInBits(load->getType()));
      set(instruction, Builder::slice(stored, 0, bits));
    } else if (const auto* store = llvm::dyn_cast<llvm::StoreInst>(&instruction)) {
      const llvm::Type* type = store->getValueOperand()->getType();
      if (type->isAggregateType() &&
          machine_.width(type) != layout_.getTypeStoreSizeInBits(const_cast<llvm::Type*>(type))) {
        refuse(instruction, "a whole structure with padding is stored at once: not supported");
      }
      memory_.store(state.at_end, value(store->getPointerOperand()),
                    Builder::zero_extend(value(store->getValueOperand()),
                                         layout_.getTypeStoreSizeInBits(const_cast<llvm::Type*>(type))));
    } else if (const auto* address = llvm::dyn_cast<llvm::GEPOperator>(&instruction)) {
      values_[&instruction] = element(*address);
    } else if (const auto* extract = llvm::dyn_cast<llvm::ExtractValueInst>(&instruction)) {
      const auto [low, bits] = place_in(extract->getAggregateOperand()->getType(), extract->getIndices());
      set(instruction, Builder::slice(value(extract->getAggregateOperand()), low, bits));
    } else if (const auto* insert = llvm::dyn_cast<llvm::InsertValueInst>(&instruction)) {
      const auto [low, bits] = place_in(insert->getAggregateOperand()->getType(), insert->getIndices());
      Bits whole = value(insert->getAggregateOperand());
      const Bits part = value(insert->getInsertedValueOperand());
      std::copy(part.begin(), part.end(), whole.begin() + static_cast<std::ptrdiff_t>(low));
      values_[&instruction] = std::move(whole);
    } else if (const auto* call = llvm::dyn_cast<llvm::CallInst>(&instruction)) {
      this->call(*call, state);
    } else {
      refuse(instruction, std::string("`") + instruction.getOpcodeName() + "` is not supported");
    }
  }

  std::pair<std::uint64_t, std::uint64_t> place_in(const llvm::Type* type, llvm::ArrayRef<unsigned> indices) const {
    std::uint64_t low = 0;
    for (const unsigned index : indices) {
      for (unsigned i = 0; i < index; ++i) low += machine_.width(type->getContainedType(type->isArrayTy() ? 0 : i));
      type = type->getContainedType(type->isArrayTy() ? 0 : index);
    }
    return {low, machine_.width(type)};
  }

  Bits arithmetic(const llvm::BinaryOperator& binary) {
    const Bits a = value(binary.getOperand(0)), b = value(binary.getOperand(1));
    const std::size_t n = a.size();
    const auto power = [&]() -> std::optional<unsigned> {
      const auto* divisor = llvm::dyn_cast<llvm::ConstantInt>(binary.getOperand(1));
      if (divisor == nullptr) return std::nullopt;
      const llvm::APInt& by = divisor->getValue();
      if (by.isPowerOf2()) return by.logBase2();
      // InstCombine writes a subtracted quotient as an added one of the negated divisor.
      const bool is_signed = binary.getOpcode() == Instruction::SDiv || binary.getOpcode() == Instruction::SRem;
      if (is_signed && by.isNegatedPowerOf2()) return (-by).logBase2();
      return std::nullopt;
    };
    switch (binary.getOpcode()) {
      case Instruction::Add:
        return builder_.add(a, b);
      case Instruction::Sub:
        return builder_.sub(a, b);
      case Instruction::Mul:
        return builder_.mul(a, b);
      case Instruction::And:
        return builder_.bit_and(a, b);
      case Instruction::Or:
        return builder_.bit_or(a, b);
      case Instruction::Xor:
        return builder_.bit_xor(a, b);
      case Instruction::Shl:
        return builder_.shl(a, b);
      case Instruction::LShr:
        return builder_.lshr(a, b);
      case Instruction::AShr:
        return builder_.ashr(a, b);
      case Instruction::UDiv:
      case Instruction::URem: {
        const auto k = power();
        if (!k) break;
        if (binary.getOpcode() == Instruction::URem) return Builder::zero_extend(Builder::slice(a, 0, *k), n);
        return Builder::zero_extend(Builder::slice(a, *k, n - *k), n);
      }
      case Instruction::SDiv:
      case Instruction::SRem: {
        const auto k = power();
        if (!k || *k + 1 >= n) break;
        // Rounds towards zero: a negative dividend is first raised by 2^k - 1.
        const Bits bias = Builder::zero_extend(Bits(*k, a.back()), n), raised = builder_.add(a, bias);
        const Bits quotient = Builder::sign_extend(Builder::slice(raised, *k, n - *k), n);
        if (binary.getOpcode() == Instruction::SDiv) {
          const bool negate = llvm::cast<llvm::ConstantInt>(binary.getOperand(1))->isNegative();
          return negate ? builder_.sub(Builder::constant(0, n), quotient) : quotient;
        }
        Bits multiple = raised;
        std::fill_n(multiple.begin(), *k, kZero);
        return builder_.sub(a, multiple);
      }
      default:
        refuse(binary, std::string("operation `") + binary.getOpcodeName() + "` is not supported");
    }
    const bool remainder = binary.getOpcode() == Instruction::URem || binary.getOpcode() == Instruction::SRem;
    refuse(binary, std::string(remainder ? "remainder of a division" : "division") +
                       (llvm::isa<llvm::Constant>(binary.getOperand(1))
                            ? " by a constant that is no power of two: multiply by a reciprocal and shift"
                            : " by a variable has no hardware: use a table of reciprocals"));
  }

  Bits conversion(const llvm::CastInst& cast) {
    const Bits from = value(cast.getOperand(0));
    const std::uint64_t to = machine_.width(cast.getType());
    switch (cast.getOpcode()) {
      case Instruction::Trunc:
        return Builder::slice(from, 0, to);
      case Instruction::ZExt:
        return Builder::zero_extend(from, to);
      case Instruction::SExt:
        return Builder::sign_extend(from, to);
      case Instruction::BitCast:
        if (from.size() == to) return from;
        break;
      case Instruction::PtrToInt:
      case Instruction::IntToPtr:
        return Builder::slice(Builder::zero_extend(from, std::max<std::size_t>(to, from.size())), 0, to);
      default:
        break;
    }
    refuse(cast, std::string("conversion `") + cast.getOpcodeName() + "` is not supported");
  }

  void allocate(const llvm::AllocaInst& alloca, Block& state) {
    const auto size = alloca.getAllocationSizeInBits(layout_);
    if (!size || size->isScalable() || !alloca.isStaticAlloca())
      refuse(alloca, "an array of variable size has no hardware");
    Object object;
    object.name = alloca.getName().empty() ? "a local variable" : "local variable " + alloca.getName().str();
    object.size_bits = size->getFixedValue();
    collect_arrays(alloca.getAllocatedType(), 0, layout_, object);
    const auto bits = static_cast<std::uint32_t>(object.size_bits);
    const std::string name = object.name;
    const ObjectId id = memory_.add_object(std::move(object));
    state.at_end.set(id, builder_.undefined(bits, name));
    values_[&alloca] = Memory::pointer(id);
  }

  Bits element(const llvm::GEPOperator& address) {
    if (address.getType()->isVectorTy()) throw CompileError(builder_.where, "vector operations are not supported");
    AddressForm form;
    const llvm::Type* inside = nullptr;  // the type that the next index selects in; none for the first
    for (auto step = llvm::gep_type_begin(address), end = llvm::gep_type_end(address); step != end; ++step) {
      const llvm::Value* index = step.getOperand();
      const llvm::Type* container = inside;
      inside = step.getIndexedType();
      if (llvm::StructType* structure = step.getStructTypeOrNull()) {
        const auto field = llvm::cast<llvm::ConstantInt>(index)->getZExtValue();
        form.base += static_cast<std::int64_t>(
            layout_.getStructLayout(structure)->getElementOffset(static_cast<unsigned>(field)).getFixedValue());
        continue;
      }
      const auto stride = static_cast<std::int64_t>(step.getSequentialElementStride(layout_).getFixedValue());
      Bits bits = value(index);
      bits = bits.size() > 64 ? Builder::slice(bits, 0, 64) : Builder::sign_extend(bits, 64);
      if (Builder::is_constant(bits)) {
        form.base += static_cast<std::int64_t>(Builder::value_of(bits)) * stride;
        continue;
      }
      if (stride == 0) continue;
      AddressForm::Term term{bits, stride, std::nullopt};
      if (address.isInBounds() && container != nullptr && container->isArrayTy()) {
        term.bounds = {0, static_cast<std::int64_t>(container->getArrayNumElements()) - 1};
      }
      if (form.terms.empty()) form.start = form.base;
      form.terms.push_back(term);
    }
    return memory_.move(value(address.getPointerOperand()), form);
  }

  void call(const llvm::CallInst& call, Block& state) {
    const llvm::Function* callee = call.getCalledFunction();
    if (const auto* intrinsic = llvm::dyn_cast<llvm::IntrinsicInst>(&call)) {
      this->intrinsic(*intrinsic, state);
      return;
    }
    const llvm::StringRef name = callee == nullptr ? "" : callee->getName();
    const auto argument = [&](unsigned i) { return value(call.getArgOperand(i)); };
    const auto bytes = [&](unsigned i) {
      const Bits size = argument(i);
      if (!Builder::is_constant(size)) refuse(call, "a RAM word of variable size");
      return Builder::value_of(size);
    };
    if (name == "__hlsc_ram_init") {
      machine_.rams_.init(state.at_end, argument(0), memory_.load(state.at_end, argument(1), bytes(2) * 8));
    } else if (name == "__hlsc_ram_read") {
      const Bits data = machine_.rams_.read(state.at_end, argument(0), argument(1), bytes(3), state.active);
      memory_.store(state.at_end, argument(2), data);
    } else if (name == "__hlsc_ram_write") {
      machine_.rams_.write(state.at_end, argument(0), argument(1),
                           memory_.load(state.at_end, argument(2), bytes(3) * 8), state.active);
    } else {
      refuse(call, "call of " + (callee == nullptr ? std::string("an unknown function") : readable(*callee)));
    }
  }

  void intrinsic(const llvm::IntrinsicInst& call, Block& state) {
    const llvm::Intrinsic::ID id = call.getIntrinsicID();
    if (is_ignored_intrinsic(id)) return;
    const auto argument = [&](unsigned i) { return value(call.getArgOperand(i)); };
    switch (id) {
      case llvm::Intrinsic::memcpy:
      case llvm::Intrinsic::memcpy_inline:
      case llvm::Intrinsic::memmove:
      case llvm::Intrinsic::memset:
      case llvm::Intrinsic::memset_inline: {
        const Bits size = argument(2);
        if (!Builder::is_constant(size)) refuse(call, "a block of variable size is copied or filled");
        const std::uint64_t bytes = Builder::value_of(size);
        if (bytes == 0) return;
        if (call.getArgOperand(1)->getType()->isPointerTy()) {
          const Bits from = argument(1), to = argument(0);
          memory_.store(state.at_end, to, memory_.load(state.at_end, from, bytes * 8));
          memory_.copy_cuts(to, from, bytes);
        } else {
          const Bits byte = argument(1);
          Bits block;
          for (std::uint64_t i = 0; i < bytes; ++i) block.insert(block.end(), byte.begin(), byte.end());
          memory_.store(state.at_end, argument(0), block);
        }
        return;
      }
      case llvm::Intrinsic::is_constant:
        set(call, {kZero});
        return;
      case llvm::Intrinsic::trap:
      case llvm::Intrinsic::ubsantrap:
      case llvm::Intrinsic::debugtrap:
        refuse(call, "the program can be stopped here (trap)");
      default:
        break;
    }
    if (call.getType()->isVoidTy())
      refuse(call, "`" + call.getCalledFunction()->getName().str() + "` is not supported");
    std::vector<Bits> arguments;
    for (unsigned i = 0; i < call.arg_size(); ++i) {
      const llvm::Type* type = call.getArgOperand(i)->getType();
      arguments.push_back(type->isMetadataTy() ? Bits{} : argument(i));
    }
    const auto result = evaluate_intrinsic(builder_, id, arguments, machine_.width(call.getType()));
    if (!result) refuse(call, "`" + call.getCalledFunction()->getName().str() + "` is not supported");
    set(call, *result);
  }

  Symbolic& machine_;
  Builder& builder_;
  Memory& memory_;
  const llvm::Function& function_;
  const llvm::DataLayout& layout_;
  llvm::DominatorTree dominators_;
  std::set<const BasicBlock*> returning_;
  std::map<const BasicBlock*, Block> blocks_;
  std::map<const llvm::Value*, Bits> values_;
};

Symbolic::Symbolic(Builder& builder, Memory& memory, RamPorts& rams, const llvm::Module& module)
    : builder_(builder), memory_(memory), rams_(rams), module_(module) {
  // All tables exist from the start, so that every version of the memory has them.
  for (const llvm::GlobalVariable& variable : module.globals()) {
    if (!variable.isConstant() || !variable.hasInitializer() || variable.getName().starts_with("llvm.")) continue;
    if (variable.getValueType()->isSized()) object_of(variable);
  }
}

Contents Symbolic::run(const llvm::Function& function, const std::vector<Bits>& arguments, Contents contents) {
  return Run(*this, function).execute(arguments, std::move(contents));
}

std::uint64_t Symbolic::width(const llvm::Type* type) const {
  if (type->isIntegerTy()) return type->getIntegerBitWidth();
  if (type->isPointerTy()) return kPointerBits;
  if (const auto* structure = llvm::dyn_cast<llvm::StructType>(type)) {
    std::uint64_t total = 0;
    for (const llvm::Type* element : structure->elements()) total += width(element);
    return total;
  }
  if (const auto* array = llvm::dyn_cast<llvm::ArrayType>(type))
    return array->getNumElements() * width(array->getElementType());
  if (type->isFPOrFPVectorTy()) throw CompileError(builder_.where, "floating point has no hardware: use fixed point");
  throw CompileError(builder_.where, "a value of a type that has no hardware");
}

ObjectId Symbolic::object_of(const llvm::GlobalVariable& variable) {
  if (const auto found = globals_.find(&variable); found != globals_.end()) return found->second;
  if (!variable.isConstant() || !variable.hasInitializer()) {
    throw CompileError(
        builder_.where,
        "`" + readable(variable) +
            "` is a static or global variable: state belongs into members of the stage, tables must be constexpr");
  }
  const llvm::DataLayout& layout = module_.getDataLayout();
  Object object;
  object.name = readable(variable);
  llvm::SmallVector<llvm::DIGlobalVariableExpression*, 1> debug;
  variable.getDebugInfo(debug);
  if (!debug.empty()) object.name = debug.front()->getVariable()->getName().str();
  object.size_bits = layout.getTypeAllocSizeInBits(variable.getValueType());
  object.constant = true;
  collect_arrays(variable.getValueType(), 0, layout, object);
  Bits bits = Builder::constant(0, object.size_bits);
  const ObjectId id = memory_.add_object(std::move(object));
  globals_[&variable] = id;
  // A table that is never used may hold anything (type information, strings): only plain ones are filled.
  try {
    fill(bits, 0, *variable.getInitializer());
  } catch (const CompileError&) {
    bits = builder_.undefined(static_cast<std::uint32_t>(bits.size()), "a constant of a type that has no hardware");
  }
  tables_[id] = std::move(bits);
  return id;
}

void Symbolic::fill(Bits& bits, std::uint64_t offset, const llvm::Constant& constant) {
  const llvm::DataLayout& layout = module_.getDataLayout();
  const llvm::Type* type = constant.getType();
  // What is undefined in a table is padding: any value will do, and a Rom needs one.
  if (llvm::isa<llvm::ConstantAggregateZero, llvm::UndefValue>(constant)) return;
  if (type->isArrayTy()) {
    const std::uint64_t stride = layout.getTypeAllocSizeInBits(type->getArrayElementType());
    for (unsigned i = 0; i < type->getArrayNumElements(); ++i)
      fill(bits, offset + i * stride, *constant.getAggregateElement(i));
    return;
  }
  if (auto* structure = llvm::dyn_cast<llvm::StructType>(constant.getType())) {
    const llvm::StructLayout* places = layout.getStructLayout(structure);
    for (unsigned i = 0; i < structure->getNumElements(); ++i) {
      fill(bits, offset + places->getElementOffsetInBits(i), *constant.getAggregateElement(i));
    }
    return;
  }
  const Bits value = value_of_constant(constant);
  std::copy(value.begin(), value.end(), bits.begin() + static_cast<std::ptrdiff_t>(offset));
}

Bits Symbolic::value_of_constant(const llvm::Constant& constant) {
  if (const auto* integer = llvm::dyn_cast<llvm::ConstantInt>(&constant)) return constant_of(integer->getValue());
  if (llvm::isa<llvm::ConstantPointerNull, llvm::ConstantAggregateZero>(constant))
    return Builder::constant(0, width(constant.getType()));
  if (llvm::isa<llvm::UndefValue>(constant)) {
    return builder_.undefined(static_cast<std::uint32_t>(width(constant.getType())), "a value");
  }
  if (const auto* variable = llvm::dyn_cast<llvm::GlobalVariable>(&constant))
    return Memory::pointer(object_of(*variable));
  if (llvm::isa<llvm::ConstantAggregate>(constant)) {
    Bits bits;
    for (const llvm::Use& element : constant.operands()) {
      const Bits part = value_of_constant(*llvm::cast<llvm::Constant>(element.get()));
      bits.insert(bits.end(), part.begin(), part.end());
    }
    return bits;
  }
  if (const auto* address = llvm::dyn_cast<llvm::GEPOperator>(&constant)) {
    llvm::APInt offset(64, 0);
    if (address->accumulateConstantOffset(module_.getDataLayout(), offset)) {
      AddressForm form;
      form.base = offset.getSExtValue();
      return memory_.move(value_of_constant(*llvm::cast<llvm::Constant>(address->getPointerOperand())), form);
    }
  }
  if (llvm::isa<llvm::Function>(constant)) {
    throw CompileError(builder_.where,
                       "the address of a function is used as a value: function pointers have no hardware");
  }
  if (constant.getType()->isFPOrFPVectorTy())
    throw CompileError(builder_.where, "floating point has no hardware: use fixed point");
  throw CompileError(builder_.where, "a constant of a form that is not supported");
}

}  // namespace hlsc
