// SPDX-License-Identifier: Apache-2.0
// Options whose values are words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace horopter::cli {

/// Each value of the option is one of these words: its help reads "one|other", and whoever writes another is told them.
CLI::Option* only(CLI::Option* option, const std::vector<std::string>& words);

}  // namespace horopter::cli
