// SPDX-License-Identifier: Apache-2.0
// Events on standard output, a line each: for people, or JSON for programs.
#pragma once

#include <unistd.h>

#include "horopter/monitor/part.hpp"
#include "log/status_json.hpp"

namespace horopter::monitor {

/// What events and states have in common: time, configuration, safe, causes.
Json status_json(const Status& status, const Cell& cell);
/// An event with what it is called, who did it where somebody did, and what.
Json event_json(const std::string& event, const Status& status, const Cell& cell, const Actor& actor,
                const std::string& what);

/// `file`: where they go. Whoever does not read them holds nobody up: 1000 lines wait, then they are lost, and that is its
/// trouble.
std::unique_ptr<Part> make_lines(const Cell& cell, Lines lines, int file = STDOUT_FILENO);

}  // namespace horopter::monitor
