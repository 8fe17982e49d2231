// SPDX-License-Identifier: Apache-2.0
// Options whose values are words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "horopter/base/profile.hpp"

namespace horopter::cli {

/// Each value of the option is one of these words: its help reads "one|other", and whoever writes another is told them.
CLI::Option* only(CLI::Option* option, const std::vector<std::string>& words);

/// --decision of the commands that run the machine.
CLI::Option* add_decision(CLI::App& command, Decision& decision);

}  // namespace horopter::cli
