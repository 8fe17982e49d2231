// SPDX-License-Identifier: Apache-2.0
// The whole compile: stage header in, SystemVerilog and its sidecar out.
#pragma once

#include <string>
#include <vector>

#include "hlsc/emit.hpp"
#include "hlsc/frontend.hpp"
#include "hlsc/options.hpp"
#include "hlsc/schedule.hpp"

namespace hlsc {

struct DriverOptions {
  Options stage;
  ScheduleOptions schedule;
  EmitOptions emit;
};

struct Compiled {
  Stage stage;
  Schedule schedule;
  EmittedModule module;
  std::string sidecar;
};

/// Throws ClangError, CompileError or ScheduleError.
Compiled compile(const DriverOptions& options);

/// `<directory>/<top>.sv` and `.json`; files that would not change are left alone. Throws std::runtime_error.
void write(const Compiled& compiled, const std::string& directory);

}  // namespace hlsc
