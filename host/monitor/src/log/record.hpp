// SPDX-License-Identifier: Apache-2.0
// What a record of the event log says, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

/// UTC, with milliseconds: 2026-01-31T12:00:00.000Z.
std::string time_text(Time time);
/// "The skin was touched; the left image was late", of the causes' texts.
std::string sentence_of(const Status& status);
/// Causes, objects, table, cameras.
nlohmann::ordered_json stop_json(const Status& status, bool has_moment);
nlohmann::ordered_json actor_json(const Actor& actor);

}  // namespace horopter::monitor
