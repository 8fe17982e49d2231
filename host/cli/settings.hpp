// SPDX-License-Identifier: Apache-2.0
// Options that several commands share: those that set up a machine, and how images are paired.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "horopter/machine/monitor.hpp"

namespace horopter::cli {

/// --engine: every engine there is.
CLI::Option* add_engine(CLI::App& command, std::string& engine);

/// The engine, for pictures of ours. Throws UsageError where it takes none, as well as what make_device throws.
std::unique_ptr<Device> make_picture_device(const std::string& engine, const MachineProfile& profile);

/// --pair-by-order, of the commands that take --left and --right.
CLI::Option* add_pair_by_order(CLI::App& command, bool& by_order);

/// --less-light, of the commands that teach.
CLI::Option* add_less_light(CLI::App& command, BlindSettings& blind);

/// Thresholds and limits.
void add_settings(CLI::App& command, Settings& settings);

}  // namespace horopter::cli
