// SPDX-License-Identifier: Apache-2.0
// What is done all the same, and may be wrong: said on standard error, and in results that programs read.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace horopter::cli {

/// Says it, once in a run of the program.
void warn(const std::string& text);
/// Adds `warnings`, all that was said, where something was.
void add_warnings(nlohmann::ordered_json& result);

}  // namespace horopter::cli
