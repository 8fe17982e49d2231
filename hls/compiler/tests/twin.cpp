// SPDX-License-Identifier: Apache-2.0
#include "twin.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <random>
#include <sstream>
#include <stdexcept>

#include "hlsc/clang.hpp"
#include "hlsc/diagnostics.hpp"
#include "hlsc/interpret.hpp"

namespace hlsc::test {

namespace {

struct Library {
  explicit Library(const std::string& path) : handle(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle == nullptr) throw std::runtime_error(dlerror());
  }
  ~Library() { dlclose(handle); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  template <typename F>
  F* function(const char* name) const {
    return reinterpret_cast<F*>(dlsym(handle, name));
  }
  void* handle;
};

using Storage = std::unique_ptr<unsigned char, decltype(&std::free)>;

Storage storage(std::size_t size, int fill) {
  const std::size_t rounded = (size + 127) / 64 * 64;
  Storage memory(static_cast<unsigned char*>(std::aligned_alloc(64, rounded)), &std::free);
  std::memset(memory.get(), fill, rounded);
  return memory;
}

/// Zero- or sign-extends a leaf into its storage.
void store(unsigned char* object, const Leaf& leaf, std::uint64_t value) {
  if (leaf.is_signed && leaf.width < 64 && ((value >> (leaf.width - 1)) & 1) != 0)
    value |= ~std::uint64_t{0} << leaf.width;
  for (std::uint32_t i = 0; i < leaf.storage_bits; ++i) {
    const std::uint64_t at = leaf.offset_bits + i;
    const auto mask = static_cast<unsigned char>(1U << (at % 8));
    object[at / 8] = static_cast<unsigned char>((i < 64 && ((value >> i) & 1) != 0) ? object[at / 8] | mask
                                                                                    : object[at / 8] & ~mask);
  }
}

std::uint64_t load(const unsigned char* object, const Leaf& leaf) {
  std::uint64_t value = 0;
  for (std::uint32_t i = 0; i < leaf.width; ++i) {
    const std::uint64_t at = leaf.offset_bits + i;
    value |= static_cast<std::uint64_t>((object[at / 8] >> (at % 8)) & 1) << i;
  }
  return value;
}

/// Small, large, all ones and anything.
std::uint64_t random_value(std::mt19937_64& random, std::uint32_t width) {
  const std::uint64_t mask = width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
  switch (random() % 8) {
    case 0:
      return 0;
    case 1:
      return mask;
    case 2:
      return random() & 3 & mask;
    case 3:
      return (mask >> 1) + (random() & 1);
    default:
      return random() & mask;
  }
}

/// What hlsc calls as its compiler: clang with the headers that every stage includes compiled once for all tests.
const std::string& clang_with_prelude() {
  static const TemporaryDirectory directory;
  static const std::string path = [] {
    const std::string program = directory.path() + "/clang";
    std::ofstream(program) << "#!/bin/sh\nexec " HLSC_TEST_HLS_DIR "/compiler/tests/clang-with-prelude "
                           << directory.path() << " " << Options{}.clang << " \"$@\"\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return program;
  }();
  return path;
}

}  // namespace

Options stage_options(const std::string& header, const std::string& stage_class) {
  Options options;
  options.stage_header = header;
  options.stage_class = stage_class;
  options.include_paths = {HLSC_TEST_HLS_DIR "/include", HLSC_TEST_HLS_DIR, HLSC_TEST_HLS_DIR "/compiler/tests"};
  options.top_name = "test_stage";
  options.clang = clang_with_prelude();
  return options;
}

std::string write_header(const std::string& name, const std::string& text) {
  static const TemporaryDirectory directory;
  const std::string path = directory.path() + "/" + name;
  std::ofstream(path) << text;
  return path;
}

std::string compare_with_native(const Options& options, const TwinOptions& twin) {
  const Stage stage = compile_stage(options);
  const TemporaryDirectory directory;
  const std::string source = directory.path() + "/native.cpp", library_path = directory.path() + "/native.so";
  std::ofstream(source) << "#include <horopter/hls/ram.hpp>\n" << wrapper_source(options);
  std::string command = Options{}.clang + " -std=c++20 -O1 -w -DNDEBUG -shared -fPIC";
  if (!twin.check_distance) command += " -DHOROPTER_HLS_UNCHECKED";
  for (const std::string& path : options.include_paths) command += " -I" + path;
  command += " " + source + " -o " + library_path;
  if (std::system(command.c_str()) != 0) throw std::runtime_error("the native twin does not compile");
  const Library library(library_path);
  auto* construct = library.function<void(void*)>(kConstructFunction);
  auto* step = library.function<void(void*, const void*, const void*, void*)>(kStepFunction);
  auto* reset = library.function<void(void*)>("__hlsc_reset");
  const Storage native = storage(library.function<unsigned long()>("__hlsc_stage_size")(), 0xA5);
  const Storage in = storage(stage.in.size_bits / 8, 0), config = storage(stage.config.size_bits / 8, 0),
                out = storage(stage.out.size_bits / 8, 0);
  construct(native.get());

  Interpreter interpreter(stage.graph, twin.check_distance);
  std::mt19937_64 random(twin.seed);
  std::vector<Value> config_values(stage.graph.configs.size());
  for (int n = 0; n < twin.steps; ++n) {
    if (twin.reset_every != 0 && n % twin.reset_every == twin.reset_every - 1) {
      reset(native.get());
      interpreter.reset();
    }
    std::vector<Value> inputs;
    for (const Leaf& leaf : stage.in.leaves) {
      const std::uint64_t value = random_value(random, leaf.width);
      store(in.get(), leaf, value);
      inputs.push_back(to_value(value, leaf.width));
    }
    for (std::size_t i = 0; i < stage.config.leaves.size() && n % 16 == 0; ++i) {
      const Leaf& leaf = stage.config.leaves[i];
      const std::uint64_t value = random_value(random, leaf.width);
      store(config.get(), leaf, value);
      config_values[i] = to_value(value, leaf.width);
    }
    step(native.get(), in.get(), config.get(), out.get());
    const Interpreter::Result result = interpreter.step(inputs, config_values);
    std::size_t port = 0;
    bool valid = true;
    for (const Leaf& leaf : stage.out.leaves) {
      if (leaf.name == "valid") valid = load(out.get(), leaf) != 0;
    }
    std::ostringstream difference;
    if (valid != result.valid) difference << " valid " << result.valid << " instead of " << valid;
    for (const Leaf& leaf : stage.out.leaves) {
      if (leaf.name == "valid") continue;
      const std::uint64_t expected = load(out.get(), leaf), got = to_integer(result.outputs[port++]);
      if (valid && expected != got) difference << ' ' << leaf.name << " = " << got << " instead of " << expected;
    }
    if (!difference.str().empty()) {
      return "step " + std::to_string(n) + ", seed " + std::to_string(twin.seed) + ":" + difference.str();
    }
  }
  return {};
}

std::string error_of(const Options& options) {
  try {
    compile_stage(options);
  } catch (const CompileError& error) {
    SourceLocation where = error.where();
    where.file = where.file.substr(where.file.rfind('/') + 1);
    return format_error(where, error.message());
  } catch (const ClangError& error) {
    return std::string("clang: ") + error.what();
  }
  return {};
}

}  // namespace hlsc::test
