// SPDX-License-Identifier: Apache-2.0
#include "hlsc/frontend.hpp"

#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IRReader/IRReader.h>
#include <llvm/Support/SourceMgr.h>
#include <llvm/Transforms/Utils/Cloning.h>

#include <algorithm>

#include "hlsc/builder.hpp"
#include "hlsc/clang.hpp"
#include "hlsc/diagnostics.hpp"
#include "hlsc/draft.hpp"
#include "hlsc/memory.hpp"
#include "hlsc/passes.hpp"
#include "hlsc/ram_ports.hpp"
#include "hlsc/shrink.hpp"
#include "hlsc/symbolic.hpp"

namespace hlsc {

namespace {

/// The class that parameter `index` of the entry point points to.
const llvm::DIType* pointee(const llvm::Function& entry, unsigned index) {
  const llvm::DISubprogram* program = entry.getSubprogram();
  const llvm::DIType* type = program == nullptr ? nullptr : program->getType()->getTypeArray()[index + 1];
  while (const auto* derived = llvm::dyn_cast_or_null<llvm::DIDerivedType>(type)) {
    type = derived->getBaseType();
  }
  if (type == nullptr) throw CompileError({}, "the debug information lacks a type of the stage's interface");
  return type;
}

Object object_of(const std::string& name, const Layout& layout) {
  Object object;
  object.name = name;
  object.size_bits = layout.size_bits;
  object.arrays = layout.arrays;
  for (const Leaf& leaf : layout.leaves) object.cuts.insert({leaf.offset_bits, leaf.offset_bits + leaf.storage_bits});
  return object;
}

void place(Bits& storage, const Leaf& leaf, const Bits& value) {
  const Bits wide =
      leaf.is_signed ? Builder::sign_extend(value, leaf.storage_bits) : Builder::zero_extend(value, leaf.storage_bits);
  std::copy(wide.begin(), wide.end(), storage.begin() + static_cast<std::ptrdiff_t>(leaf.offset_bits));
}

/// Does an entry point still use `value`?
bool used_in_entry(const llvm::Value& value) {
  for (const llvm::User* const user : value.users()) {
    const auto* const instruction = llvm::dyn_cast<llvm::Instruction>(user);
    if (instruction == nullptr) {
      if (used_in_entry(*user)) return true;
      continue;
    }
    const llvm::StringRef name = instruction->getFunction()->getName();
    if (name == kStepFunction || name == kConstructFunction) return true;
  }
  return false;
}

class Frontend {
 public:
  Frontend(llvm::Module& module, const Options& options)
      : module_(module), options_(options), memory_(builder_, options, draft_.graph.roms) {}

  Stage compile() {
    const llvm::Function* step = module_.getFunction(kStepFunction);
    const llvm::Function* construct = module_.getFunction(kConstructFunction);
    if (step == nullptr || construct == nullptr) throw CompileError({}, "the bitcode has no entry points");
    const Layout stage = layout_of(pointee(*step, 0), "the stage");
    Stage result;
    result.in = layout_of(pointee(*step, 1), "In");
    result.config = layout_of(pointee(*step, 2), "Config");
    result.out = layout_of(pointee(*step, 3), "Out");
    check_size(stage);

    // Where none can be incomplete, LLVM need not know of it.
    if (out_may_be_incomplete(result.out)) mark_unset(module_);
    if (llvm::Function* const probe = module_.getFunction(kDefaultOutFunction)) probe->eraseFromParent();
    prepare(module_, options_);

    Graph& graph = draft_.graph;
    graph.top_name = options_.top_name;
    graph.source_file = options_.stage_header;
    const ObjectId stage_id = memory_.add_object(object_of("the stage", stage)),
                   in_id = memory_.add_object(object_of("In", result.in)),
                   config_id = memory_.add_object(object_of("Config", result.config)),
                   out_id = memory_.add_object(object_of("Out", result.out));
    StagePorts ports(builder_, memory_, stage_id, stage);
    Symbolic machine(builder_, memory_, ports, module_);

    Contents made;
    made.set(stage_id, undefined(stage, "member `", "` of the stage has no initial value"));
    if (const llvm::GlobalVariable* const open = module_.getNamedGlobal(kUnsetOut);
        open != nullptr && used_in_entry(*open)) {
      const ObjectId open_id = memory_.add_object(object_of("Out", result.out));
      machine.bind(*open, open_id);
      made.set(open_id, unset_out(result.out));
    }
    ports.start(made, graph);
    made = machine.run(*construct, {Memory::pointer(stage_id)}, made);
    const Bits initial = made.of(stage_id);

    Contents contents;
    for (const auto& [id, version] : made.versions()) contents.set(id, *version);
    contents.set(stage_id, states(stage, initial));
    contents.set(in_id, inputs(Op::kInput, result.in, graph.inputs));
    contents.set(config_id, inputs(Op::kConfig, result.config, graph.configs));
    contents.set(out_id, unset_out(result.out));
    const Contents after = machine.run(
        *step, {Memory::pointer(stage_id), Memory::pointer(in_id), Memory::pointer(config_id), Memory::pointer(out_id)},
        contents);

    next_states(stage, after.of(stage_id));
    ports.finish(after, graph);
    outputs(result.out, after.of(out_id));
    graph.nodes = std::move(builder_.nodes());
    result.graph = finish(std::move(draft_));
    return result;
  }

 private:
  void check_size(const Layout& stage) const {
    std::uint64_t bits = 0;
    for (const Leaf& leaf : stage.leaves) bits += leaf.width;
    if (bits <= options_.largest_state_bits) return;
    throw CompileError(stage.leaves.back().where, "the stage has " + std::to_string(bits) +
                                                      " bits of registers, at most " +
                                                      std::to_string(options_.largest_state_bits) +
                                                      " are allowed: large arrays belong into horopter::hls::RAM");
  }

  /// Does an Out that is made without arguments lack the value of a member?
  bool out_may_be_incomplete(const Layout& out) const {
    if (module_.getFunction(kDefaultOutFunction) == nullptr) return false;
    const std::unique_ptr<llvm::Module> probe = llvm::CloneModule(module_);
    keep_only(*probe, options_, kDefaultOutFunction);
    prepare(*probe, options_);
    std::vector<Rom> roms;
    Builder builder;
    Memory memory(builder, options_, roms);
    const ObjectId out_id = memory.add_object(object_of("Out", out));
    const Layout no_memories;
    StagePorts ports(builder, memory, out_id, no_memories);
    Symbolic machine(builder, memory, ports, *probe);
    Contents contents;
    contents.set(out_id, builder.undefined(static_cast<std::uint32_t>(out.size_bits), "Out"));
    const Contents after =
        machine.run(*probe->getFunction(kDefaultOutFunction), {Memory::pointer(out_id)}, std::move(contents));
    const Bits& made = after.of(out_id);
    return std::ranges::any_of(out.leaves, [&](const Leaf& leaf) {
      return std::ranges::any_of(Builder::slice(made, leaf.offset_bits, leaf.width),
                                 [&](Bit bit) { return builder.is_undefined(bit); });
    });
  }

  Bits undefined(const Layout& layout, const std::string& before, const std::string& behind) {
    builder_.where = {};
    Bits storage = builder_.undefined(static_cast<std::uint32_t>(layout.size_bits), "padding");
    for (const Leaf& leaf : layout.leaves) {
      builder_.where = leaf.where;
      const Bits value = builder_.undefined(leaf.storage_bits, before + leaf.name + behind);
      std::copy(value.begin(), value.end(), storage.begin() + static_cast<std::ptrdiff_t>(leaf.offset_bits));
    }
    return storage;
  }

  Bits unset_out(const Layout& out) {
    builder_.where = {};
    Bits storage = builder_.undefined(static_cast<std::uint32_t>(out.size_bits), "padding");
    for (const Leaf& leaf : out.leaves) {
      builder_.where = leaf.where;
      const Bits value = builder_.unset(leaf.storage_bits, "member `" + leaf.name + "` of Out is not set");
      std::copy(value.begin(), value.end(), storage.begin() + static_cast<std::ptrdiff_t>(leaf.offset_bits));
    }
    return storage;
  }

  Bits inputs(Op op, const Layout& layout, std::vector<Port>& ports) {
    builder_.where = {};
    Bits storage = builder_.undefined(static_cast<std::uint32_t>(layout.size_bits), "padding of an input");
    for (const Leaf& leaf : layout.leaves) {
      builder_.where = leaf.where;
      const Bits value = builder_.source(op, static_cast<std::uint32_t>(ports.size()), leaf.width, leaf.name);
      Port port;
      port.name = leaf.name;
      port.width = leaf.width;
      port.is_signed = leaf.is_signed;
      port.node = value[0].node;
      ports.push_back(port);
      place(storage, leaf, value);
    }
    return storage;
  }

  Bits states(const Layout& layout, const Bits& initial) {
    Graph& graph = draft_.graph;
    builder_.where = {};
    Bits storage = builder_.undefined(static_cast<std::uint32_t>(layout.size_bits), "padding of the stage");
    for (const Leaf& leaf : layout.leaves) {
      builder_.where = leaf.where;
      State state;
      state.name = leaf.name;
      state.width = leaf.width;
      state.kept = leaf.kept;
      std::vector<bool> uninitialised;
      for (std::uint32_t i = 0; i < leaf.width; ++i) {
        const Bit bit = initial[leaf.offset_bits + i];
        if (bit.node != 0 && !builder_.is_undefined(bit)) {
          throw CompileError(leaf.where,
                             "the initial value of member `" + leaf.name + "` is not known at compile time");
        }
        if (leaf.kept && bit == kOne) {
          throw CompileError(leaf.where, "member `" + leaf.name +
                                             "` is Kept and not zero when made without arguments: it is zero at "
                                             "power-up");
        }
        state.initial.push_back(bit == kOne);
        uninitialised.push_back(bit.node != 0);
      }
      const Bits value =
          builder_.source(Op::kStateRead, static_cast<std::uint32_t>(graph.states.size()), leaf.width, leaf.name);
      state.read = value[0].node;
      // A pointer that the constructor sets is that constant; next_states() refuses a step that changes it.
      place(storage, leaf, leaf.is_pointer ? Builder::slice(initial, leaf.offset_bits, leaf.width) : value);
      graph.states.push_back(std::move(state));
      draft_.uninitialised.push_back(std::move(uninitialised));
      draft_.state_where.push_back(leaf.where);
    }
    return storage;
  }

  void next_states(const Layout& layout, const Bits& storage) {
    for (std::size_t i = 0; i < layout.leaves.size(); ++i) {
      const Leaf& leaf = layout.leaves[i];
      State& state = draft_.graph.states[i];
      state.next = Builder::slice(storage, leaf.offset_bits, leaf.width);
      if (!leaf.is_pointer) continue;
      if (state.next != Builder::constant(state.initial)) {
        throw CompileError(leaf.where,
                           "pointer `" + leaf.name + "` of the stage changes: pointers must be known at compile time");
      }
    }
  }

  void outputs(const Layout& layout, const Bits& storage) {
    for (const Leaf& leaf : layout.leaves) {
      const Bits value = Builder::slice(storage, leaf.offset_bits, leaf.width);
      if (leaf.name == "valid") {
        if (leaf.width != 1) throw CompileError(leaf.where, "member `valid` of Out must be bool");
        draft_.graph.output_valid = value[0];
        continue;
      }
      Port port;
      port.name = leaf.name;
      port.width = leaf.width;
      port.is_signed = leaf.is_signed;
      port.value = value;
      draft_.graph.outputs.push_back(std::move(port));
      draft_.output_where.push_back(leaf.where);
    }
  }

  llvm::Module& module_;
  const Options& options_;
  Draft draft_;
  Builder builder_;
  Memory memory_;
};

}  // namespace

Stage compile_bitcode(const std::string& path, const Options& options) {
  llvm::LLVMContext context;
  llvm::SMDiagnostic problem;
  const std::unique_ptr<llvm::Module> module = llvm::parseIRFile(path, problem, context);
  if (module == nullptr) throw std::runtime_error("cannot read " + path + ": " + problem.getMessage().str());
  return Frontend(*module, options).compile();
}

Stage compile_stage(const Options& options) {
  const TemporaryDirectory directory;
  return compile_bitcode(run_clang(options, directory.path()), options);
}

}  // namespace hlsc
