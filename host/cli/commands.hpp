// SPDX-License-Identifier: Apache-2.0
// The commands of the program. Each adds its options to the parser and leaves a callback that does the work and throws
// horopter::Error; main turns that into the exit status.
#pragma once

#include <CLI/CLI.hpp>

#include "horopter/base/error.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter::cli {

/// Set by the callback that ran.
struct Outcome {
  ExitStatus status = ExitStatus::done;
};

void add_run(CLI::App& app, Outcome& outcome);
void add_map(CLI::App& app, Outcome& outcome);
void add_evaluate(CLI::App& app, Outcome& outcome);
void add_calibrate(CLI::App& app, Outcome& outcome);
void add_pattern(CLI::App& app, Outcome& outcome);
void add_plan(CLI::App& app, Outcome& outcome);
void add_plan_rig(CLI::App& plan, Outcome& outcome);

/// True once the user has asked to stop (SIGINT, SIGTERM).
bool interrupted();

}  // namespace horopter::cli
