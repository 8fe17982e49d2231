// SPDX-License-Identifier: Apache-2.0
#include "hlsc/clang.hpp"

#include <llvm/ADT/SmallString.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/Program.h>
#include <llvm/Support/raw_ostream.h>

#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>

namespace hlsc {

std::string wrapper_source(const Options& options) {
  std::ostringstream text;
  text << "#include <new>\n#include <type_traits>\n";
  for (const std::string& header : options.extra_includes) text << "#include \"" << header << "\"\n";
  if (!options.stage_header.empty()) text << "#include \"" << options.stage_header << "\"\n";
  text
      << "namespace horopter::hls {}\nnamespace hlsc_wrapper {\n"
      << "using Stage = " << options.stage_class << ";\n"
      << R"(static_assert(requires { typename Stage::In; typename Stage::Out; }, "a stage has nested types In and Out");
static_assert(std::is_default_constructible_v<Stage>, "a stage is made without arguments");
struct NoConfig {};
template <class S> struct config_of { using type = NoConfig; };
template <class S> requires requires { typename S::Config; } struct config_of<S> { using type = typename S::Config; };
using In = Stage::In;
using Out = Stage::Out;
using Config = config_of<Stage>::type;
template <class S> inline Out call(S& stage, const In& in, const Config& config) {
  if constexpr (requires { stage.step(in, config); }) {
    return stage.step(in, config);
  } else {
    static_assert(requires { stage.step(in); }, "a stage has `Out step(const In&)` or `Out step(const In&, const Config&)`");
    return stage.step(in);
  }
}
}
extern "C" void __hlsc_construct(hlsc_wrapper::Stage* stage) { ::new (static_cast<void*>(stage)) hlsc_wrapper::Stage; }
extern "C" void __hlsc_step(hlsc_wrapper::Stage* stage, const hlsc_wrapper::In* in, const hlsc_wrapper::Config* config,
                            hlsc_wrapper::Out* out) {
  ::new (static_cast<void*>(out)) hlsc_wrapper::Out(hlsc_wrapper::call(*stage, *in, *config));
}
#ifdef __HLSC__
extern "C" hlsc_wrapper::Out __hlsc_unset_out;
extern "C" const void* __hlsc_unset() { return &__hlsc_unset_out; }
extern "C" void __hlsc_default_out(hlsc_wrapper::Out* out) {
  if constexpr (std::is_default_constructible_v<hlsc_wrapper::Out>) ::new (static_cast<void*>(out)) hlsc_wrapper::Out;
}
#else
// The native twin, for tests.
extern "C" unsigned long __hlsc_stage_size() { return sizeof(hlsc_wrapper::Stage); }
extern "C" void __hlsc_reset(hlsc_wrapper::Stage* stage) {
  if constexpr (requires { horopter::hls::reset(*stage); }) {
    horopter::hls::reset(*stage);
  } else {
    *stage = hlsc_wrapper::Stage{};
  }
}
#endif
)";
  return text.str();
}

TemporaryDirectory::TemporaryDirectory() {
  llvm::SmallString<128> path;
  if (const std::error_code error = llvm::sys::fs::createUniqueDirectory("hlsc", path)) {
    throw std::runtime_error("cannot make a temporary directory: " + error.message());
  }
  path_ = path.str().str();
}

TemporaryDirectory::~TemporaryDirectory() {
  if (const std::error_code error = llvm::sys::fs::remove_directories(path_)) {
    llvm::errs() << "hlsc: " << path_ << " is left behind: " << error.message() << '\n';
  }
}

std::string run_clang(const Options& options, const std::string& directory) {
  const llvm::ErrorOr<std::string> clang = llvm::sys::findProgramByName(options.clang);
  if (!clang) throw std::runtime_error("`" + options.clang + "` not found: install the package clang-19");
  const std::string source = directory + "/hlsc_wrapper.cpp", bitcode = directory + "/stage.bc",
                    messages = directory + "/messages";
  std::ofstream(source) << wrapper_source(options);
  std::vector<std::string> arguments{*clang,
                                     "-std=c++20",
                                     "-O2",
                                     "-Xclang",
                                     "-disable-llvm-passes",
                                     "-g",
                                     "-fstandalone-debug",
                                     "-emit-llvm",
                                     "-c",
                                     "-DNDEBUG",
                                     "-D__HLSC__=1",
                                     "-fno-strict-aliasing",
                                     "-Wfatal-errors",
                                     "-Wno-everything",
                                     "-Werror=uninitialized",
                                     "-Werror=sometimes-uninitialized",
                                     "-Werror=return-type",
                                     "-Werror=array-bounds",
                                     "-Werror=shift-count-overflow",
                                     "-Werror=division-by-zero"};
  for (const std::string& path : options.include_paths) arguments.push_back("-I" + path);
  for (const std::string& define : options.defines) arguments.push_back("-D" + define);
  arguments.insert(arguments.end(), {"-I.", source, "-o", bitcode});
  const std::vector<llvm::StringRef> views(arguments.begin(), arguments.end());
  const std::optional<llvm::StringRef> redirects[] = {llvm::StringRef(), std::nullopt, llvm::StringRef(messages)};
  std::string problem;
  const int status = llvm::sys::ExecuteAndWait(*clang, views, std::nullopt, redirects, 0, 0, &problem);
  if (status != 0) {
    std::ifstream file(messages);
    std::ostringstream text;
    text << file.rdbuf() << problem;
    throw ClangError(text.str());
  }
  return bitcode;
}

}  // namespace hlsc
