// SPDX-License-Identifier: Apache-2.0
// `horopter study`, as main adds it to the program.
#pragma once

#include "cli/commands.hpp"

namespace horopter::cli {

void add_study(CLI::App& app, Outcome& outcome);

}  // namespace horopter::cli
