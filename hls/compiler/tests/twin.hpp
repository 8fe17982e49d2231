// SPDX-License-Identifier: Apache-2.0
// A stage twice: compiled by hlsc and interpreted, and compiled by clang and loaded as a library. Both get the same
// random inputs and must give the same outputs.
#pragma once

#include <cstdint>
#include <string>

#include "hlsc/frontend.hpp"

namespace hlsc::test {

struct TwinOptions {
  int steps = 2000;
  std::uint64_t seed = 1;
  bool check_distance = true;  ///< false: random inputs may break a stage's rules on memory accesses
  int reset_every = 700;       ///< steps; 0: never
};

/// Options with the project's include paths and these tests' folder.
Options stage_options(const std::string& header, const std::string& stage_class);

/// The header's text, written to a file of its own; removed at exit.
std::string write_header(const std::string& name, const std::string& text);

/// Empty if all steps agree, else what differs, with step and seed.
std::string compare_with_native(const Options& options, const TwinOptions& twin = {});

/// The first line of the error that compiling gives, file without its folder; empty if it compiles.
std::string error_of(const Options& options);

}  // namespace hlsc::test
