// SPDX-License-Identifier: Apache-2.0
// Events on standard output, a line each: for people, or JSON for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "horopter/monitor/part.hpp"

namespace horopter::monitor {

/// What events and states have in common: time, configuration, safe, causes.
nlohmann::ordered_json status_json(const Status& status, const Cell& cell);
/// An event with what it is called, and who did it where somebody did.
nlohmann::ordered_json event_json(const std::string& event, const Status& status, const Cell& cell);

std::unique_ptr<Part> make_lines(const Cell& cell, Lines lines);

}  // namespace horopter::monitor
