// SPDX-License-Identifier: Apache-2.0
// From a stage's header to LLVM IR: a generated translation unit with two entry points, compiled by clang.
#pragma once

#include <stdexcept>
#include <string>

#include "hlsc/options.hpp"

namespace hlsc {

/// void __hlsc_construct(Stage*): a stage as its constructor leaves it.
inline constexpr char kConstructFunction[] = "__hlsc_construct";
/// void __hlsc_step(Stage*, const In*, const Config*, Out*).
inline constexpr char kStepFunction[] = "__hlsc_step";
inline constexpr char kDefaultOutFunction[] = "__hlsc_default_out";
/// A global Out without contents: what a local one holds before it is set.
inline constexpr char kUnsetOut[] = "__hlsc_unset_out";

/// The stage does not compile as C++; `what()` is clang's own text.
class ClangError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The translation unit, for tests and --keep.
std::string wrapper_source(const Options& options);

/// A directory that is removed with the object.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Compiles to unoptimised bitcode in `directory`; returns its path.
std::string run_clang(const Options& options, const std::string& directory);

}  // namespace hlsc
