// SPDX-License-Identifier: Apache-2.0
#include "hlsc/passes.hpp"

#include <llvm/ADT/PostOrderIterator.h>
#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/OptimizationRemarkEmitter.h>
#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/Analysis/TargetTransformInfo.h>
#include <llvm/Demangle/Demangle.h>
#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Transforms/IPO/AlwaysInliner.h>
#include <llvm/Transforms/IPO/GlobalDCE.h>
#include <llvm/Transforms/InstCombine/InstCombine.h>
#include <llvm/Transforms/Scalar/ADCE.h>
#include <llvm/Transforms/Scalar/DeadStoreElimination.h>
#include <llvm/Transforms/Scalar/EarlyCSE.h>
#include <llvm/Transforms/Scalar/GVN.h>
#include <llvm/Transforms/Scalar/IndVarSimplify.h>
#include <llvm/Transforms/Scalar/LoopRotation.h>
#include <llvm/Transforms/Scalar/SCCP.h>
#include <llvm/Transforms/Scalar/SROA.h>
#include <llvm/Transforms/Scalar/SimplifyCFG.h>
#include <llvm/Transforms/Utils/LCSSA.h>
#include <llvm/Transforms/Utils/LoopSimplify.h>
#include <llvm/Transforms/Utils/LowerInvoke.h>
#include <llvm/Transforms/Utils/UnifyFunctionExitNodes.h>
#include <llvm/Transforms/Utils/UnrollLoop.h>

#include "hlsc/clang.hpp"
#include "hlsc/diagnostics.hpp"

namespace hlsc {

namespace {

bool is_library(llvm::StringRef file) {
  return file.starts_with("/usr/") || file.contains("horopter/hls/") || file.contains("hlsc_wrapper.cpp");
}

SourceLocation place(const llvm::DILocation* location) {
  return {tidy_path(location->getFilename().str()), location->getLine()};
}

bool is_hook(const llvm::Function& function) { return function.getName().starts_with("__hlsc_ram_"); }

/// What a call that is left after inlining means for the user.
std::string explain_call(const llvm::CallBase& call) {
  const llvm::Function* callee = call.getCalledFunction();
  if (callee == nullptr) {
    return call.isInlineAsm()
               ? "inline assembly has no hardware"
               : "call through a function pointer or of a virtual function: the callee must be known at compile time";
  }
  const std::string name = callee->getName().str(), readable = llvm::demangle(name);
  if (name.starts_with("__cxa_guard")) return "static local variable: state belongs into members of the stage";
  if (name.starts_with("_Znw") || name.starts_with("_Zna") || name == "malloc" || name == "calloc" ||
      name.starts_with("_Zdl") || name.starts_with("_Zda") || name == "free") {
    return "heap allocation (" + readable + ") has no hardware";
  }
  if (name.starts_with("__cxa_") || name.starts_with("_ZSt") || name == "_Unwind_Resume" ||
      name == "__clang_call_terminate") {
    if (name.starts_with("__cxa_") || name.find("throw") != std::string::npos ||
        name.find("terminate") != std::string::npos) {
      return "an exception can be thrown here (" + readable + "): hardware has none";
    }
  }
  if (name == "abort" || name == "__assert_fail" || name == "exit")
    return "the program can be aborted here (" + readable + ")";
  if (!callee->isDeclaration()) return "recursive call of " + readable;
  return "call of " + readable + ", whose source hlsc does not see";
}

void refuse_remaining_calls(llvm::Function& function) {
  for (llvm::Instruction& instruction : llvm::instructions(function)) {
    const auto* call = llvm::dyn_cast<llvm::CallBase>(&instruction);
    if (call == nullptr || llvm::isa<llvm::IntrinsicInst>(call)) continue;
    const llvm::Function* callee = call->getCalledFunction();
    if (callee != nullptr && is_hook(*callee)) continue;
    throw CompileError(location_of(instruction), explain_call(*call));
  }
}

class Pipeline {
 public:
  Pipeline(llvm::Module& module, const Options& options) : module_(module), options_(options) {
    llvm::PassBuilder builder;
    builder.registerModuleAnalyses(modules_);
    builder.registerCGSCCAnalyses(sccs_);
    builder.registerFunctionAnalyses(functions_);
    builder.registerLoopAnalyses(loops_);
    builder.crossRegisterProxies(loops_, functions_, sccs_, modules_);
  }

  void drop_unused() {
    llvm::ModulePassManager passes;
    passes.addPass(llvm::GlobalDCEPass());
    passes.run(module_, modules_);
  }

  void inline_everything() {
    for (llvm::Function& function : module_) {
      const bool entry = function.getName() == kStepFunction || function.getName() == kConstructFunction ||
                         function.getName() == kDefaultOutFunction;
      for (const auto attribute : {llvm::Attribute::NoInline, llvm::Attribute::OptimizeNone}) {
        function.removeFnAttr(attribute);
      }
      if (function.isDeclaration()) {
        if (is_hook(function)) {
          function.setDoesNotThrow();
          function.setWillReturn();
        }
        continue;
      }
      if (entry) continue;
      function.setLinkage(llvm::GlobalValue::InternalLinkage);
      function.setComdat(nullptr);
      function.addFnAttr(llvm::Attribute::AlwaysInline);
    }
    for (llvm::GlobalVariable& variable : module_.globals()) {
      if (variable.isDeclaration() || variable.getName().starts_with("llvm.")) continue;
      variable.setComdat(nullptr);
      variable.setLinkage(llvm::GlobalValue::InternalLinkage);
    }
    // Calls through pointers become direct once the pointer is known: inline and simplify until nothing changes.
    for (int round = 0; round < 8; ++round) {
      const unsigned before = calls();
      llvm::ModulePassManager inliner;
      inliner.addPass(llvm::AlwaysInlinerPass(/*InsertLifetime=*/false));
      inliner.run(module_, modules_);
      simplify();
      if (calls() == before && round > 0) break;
    }
  }

  void simplify() {
    llvm::FunctionPassManager passes;
    passes.addPass(llvm::SROAPass(llvm::SROAOptions::ModifyCFG));
    passes.addPass(llvm::EarlyCSEPass(/*UseMemorySSA=*/true));
    passes.addPass(llvm::SCCPPass());
    passes.addPass(llvm::SimplifyCFGPass());
    passes.addPass(llvm::InstCombinePass());
    passes.addPass(llvm::SimplifyCFGPass());
    run(passes);
  }

  void remove_loops() {
    for (;;) {
      llvm::FunctionPassManager passes;
      passes.addPass(llvm::LoopSimplifyPass());
      passes.addPass(llvm::LCSSAPass());
      passes.addPass(llvm::createFunctionToLoopPassAdaptor(llvm::LoopRotatePass(), /*UseMemorySSA=*/true));
      passes.addPass(llvm::InstCombinePass());
      passes.addPass(llvm::createFunctionToLoopPassAdaptor(llvm::IndVarSimplifyPass(/*WidenIndVars=*/false)));
      run(passes);
      bool any = false;
      for (llvm::Function* function : entries()) any |= unroll(*function);
      simplify();
      if (!any) break;
    }
    for (llvm::Function* function : entries()) refuse_remaining_loops(*function);
  }

  void finish() {
    llvm::FunctionPassManager passes;
    passes.addPass(llvm::GVNPass());
    passes.addPass(llvm::InstCombinePass());
    passes.addPass(llvm::DSEPass());
    passes.addPass(llvm::SimplifyCFGPass());
    passes.addPass(llvm::SROAPass(llvm::SROAOptions::ModifyCFG));
    passes.addPass(llvm::EarlyCSEPass(/*UseMemorySSA=*/true));
    passes.addPass(llvm::ADCEPass());
    passes.addPass(llvm::SimplifyCFGPass());
    passes.addPass(llvm::UnifyFunctionExitNodesPass());
    run(passes);
    for (llvm::Function* function : entries()) refuse_remaining_calls(*function);
  }

 private:
  std::vector<llvm::Function*> entries() {
    std::vector<llvm::Function*> found;
    for (const char* name : {kConstructFunction, kStepFunction, kDefaultOutFunction}) {
      llvm::Function* const function = module_.getFunction(name);
      if (function != nullptr && !function->isDeclaration()) found.push_back(function);
    }
    return found;
  }

  void run(llvm::FunctionPassManager& passes) {
    for (llvm::Function* function : entries()) {
      functions_.invalidate(*function, passes.run(*function, functions_));
    }
  }

  unsigned calls() {
    unsigned count = 0;
    for (llvm::Function* function : entries()) {
      for (llvm::Instruction& instruction : llvm::instructions(*function)) {
        if (llvm::isa<llvm::CallBase>(instruction) && !llvm::isa<llvm::IntrinsicInst>(instruction)) ++count;
      }
    }
    return count;
  }

  /// Unrolls every loop with a known (largest) number of iterations; inner loops first. True if anything changed.
  bool unroll(llvm::Function& function) {
    bool any = false;
    for (;;) {
      auto& info = functions_.getResult<llvm::LoopAnalysis>(function);
      auto& scev = functions_.getResult<llvm::ScalarEvolutionAnalysis>(function);
      auto& dominators = functions_.getResult<llvm::DominatorTreeAnalysis>(function);
      auto& assumptions = functions_.getResult<llvm::AssumptionAnalysis>(function);
      auto& target = functions_.getResult<llvm::TargetIRAnalysis>(function);
      auto& remarks = functions_.getResult<llvm::OptimizationRemarkEmitterAnalysis>(function);
      bool changed = false;
      llvm::SmallVector<llvm::Loop*, 8> loops = info.getLoopsInPreorder();
      // Innermost loops first; the others follow in the next round, when their inner loops are gone or need them to be.
      std::sort(loops.begin(), loops.end(),
                [](const llvm::Loop* a, const llvm::Loop* b) { return a->getLoopDepth() > b->getLoopDepth(); });
      for (llvm::Loop* loop : loops) {
        const unsigned count = scev.getSmallConstantMaxTripCount(loop);
        if (count == 0) continue;
        if (count > options_.largest_loop) {
          throw CompileError(location_of(loop->getStartLoc()),
                             "loop of " + std::to_string(count) + " iterations: at most " +
                                 std::to_string(options_.largest_loop) + " are unrolled (--max-loop)");
        }
        if (!loop->isLoopSimplifyForm() || loop->getLoopLatch() == nullptr) continue;
        llvm::UnrollLoopOptions unrolling{};
        unrolling.Count = count;
        unrolling.Force = true;
        unrolling.Runtime = false;
        unrolling.AllowExpensiveTripCount = false;
        unrolling.UnrollRemainder = false;
        unrolling.ForgetAllSCEV = true;
        unrolling.Heart = nullptr;
        const auto result =
            llvm::UnrollLoop(loop, unrolling, &info, &scev, &dominators, &assumptions, &target, &remarks,
                             /*PreserveLCSSA=*/true);
        if (result != llvm::LoopUnrollResult::Unmodified) {
          changed = any = true;
          break;
        }
      }
      if (!changed) return any;
      functions_.invalidate(function, llvm::PreservedAnalyses::none());
      llvm::FunctionPassManager passes;
      passes.addPass(llvm::SROAPass(llvm::SROAOptions::ModifyCFG));
      passes.addPass(llvm::EarlyCSEPass());
      passes.addPass(llvm::SimplifyCFGPass());
      passes.addPass(llvm::LoopSimplifyPass());
      passes.addPass(llvm::LCSSAPass());
      functions_.invalidate(function, passes.run(function, functions_));
    }
  }

  void refuse_remaining_loops(llvm::Function& function) {
    auto& info = functions_.getResult<llvm::LoopAnalysis>(function);
    for (const llvm::Loop* loop : info.getLoopsInPreorder()) {
      throw CompileError(location_of(loop->getStartLoc()),
                         "the number of iterations of this loop depends on data: it cannot be unrolled");
    }
  }

  llvm::Module& module_;
  const Options& options_;
  llvm::LoopAnalysisManager loops_;
  llvm::FunctionAnalysisManager functions_;
  llvm::CGSCCAnalysisManager sccs_;
  llvm::ModuleAnalysisManager modules_;
};

}  // namespace

SourceLocation location_of(const llvm::DebugLoc& location) {
  if (!location) return {};
  const llvm::DILocation* library = nullptr;
  for (const llvm::DILocation* at = location.get(); at != nullptr; at = at->getInlinedAt()) {
    // The generated translation unit is in a directory with a random name: it must not show.
    if (at->getLine() == 0 || at->getFilename().contains("hlsc_wrapper.cpp")) continue;
    if (!is_library(at->getFilename())) return place(at);
    if (library == nullptr) library = at;
  }
  return library == nullptr ? SourceLocation{} : place(library);
}

SourceLocation location_of(const llvm::Instruction& instruction) {
  const auto usable = [](const SourceLocation& where) { return !where.file.empty(); };
  if (SourceLocation where = location_of(instruction.getDebugLoc()); usable(where)) return where;
  // Optimised code may have lost its line: the nearest instruction that has one.
  for (const llvm::Instruction* near = instruction.getPrevNode(); near != nullptr; near = near->getPrevNode()) {
    if (SourceLocation where = location_of(near->getDebugLoc()); usable(where)) return where;
  }
  for (const llvm::Instruction* near = instruction.getNextNode(); near != nullptr; near = near->getNextNode()) {
    if (SourceLocation where = location_of(near->getDebugLoc()); usable(where)) return where;
  }
  return {};
}

void mark_unset(llvm::Module& module) {
  llvm::GlobalVariable* const unset = module.getNamedGlobal(kUnsetOut);
  if (unset == nullptr) return;
  const std::uint64_t bytes = module.getDataLayout().getTypeAllocSize(unset->getValueType()).getFixedValue();
  for (llvm::Function& function : module) {
    std::vector<llvm::AllocaInst*> locals;
    for (llvm::Instruction& instruction : llvm::instructions(function)) {
      auto* const local = llvm::dyn_cast<llvm::AllocaInst>(&instruction);
      if (local != nullptr && local->getAllocatedType() == unset->getValueType()) locals.push_back(local);
    }
    for (llvm::AllocaInst* const local : locals) {
      std::vector<llvm::Instruction*> before;
      for (llvm::User* const user : local->users()) {
        auto* const call = llvm::dyn_cast<llvm::IntrinsicInst>(user);
        if (call != nullptr && call->getIntrinsicID() == llvm::Intrinsic::lifetime_start) {
          before.push_back(call->getNextNode());
        }
      }
      if (before.empty()) before.push_back(&*local->getParent()->getFirstNonPHIOrDbgOrAlloca());
      for (llvm::Instruction* const place : before) {
        llvm::IRBuilder<>(place).CreateMemCpy(local, local->getAlign(), unset, local->getAlign(), bytes);
      }
    }
  }
}

void keep_only(llvm::Module& module, const Options& options, const char* function) {
  for (const char* other : {kConstructFunction, kStepFunction, kDefaultOutFunction}) {
    llvm::Function* const unwanted = module.getFunction(other);
    if (unwanted != nullptr && llvm::StringRef(other) != function) unwanted->deleteBody();
  }
  Pipeline(module, options).drop_unused();
}

void prepare(llvm::Module& module, const Options& options) {
  Pipeline pipeline(module, options);
  pipeline.inline_everything();
  pipeline.remove_loops();
  pipeline.finish();
}

}  // namespace hlsc
