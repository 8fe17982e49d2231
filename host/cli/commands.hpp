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
void add_upload(CLI::App& app, Outcome& outcome);
void add_status(CLI::App& app, Outcome& outcome);
void add_restart(CLI::App& app, Outcome& outcome);
void add_teach(CLI::App& app, Outcome& outcome);
void add_plan_capability(CLI::App& plan, Outcome& outcome);
void add_monitor(CLI::App& app, Outcome& outcome);
void add_log(CLI::App& app, Outcome& outcome);
void add_monitor_user(CLI::App& app, Outcome& outcome);
void add_plan_rig(CLI::App& plan, Outcome& outcome);

/// For a command that ends by itself, done, when it is asked to stop (SIGINT, SIGTERM): true then. Whoever has not
/// called it is ended at once, with the exit status 128 + signal, as everybody is at the second request.
bool asked_to_stop();

}  // namespace horopter::cli
