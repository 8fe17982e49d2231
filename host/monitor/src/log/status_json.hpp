// SPDX-License-Identifier: Apache-2.0
// What the log, the page and the outputs say alike of a state, as JSON; and how JSON is read that may be anything.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

using Json = nlohmann::ordered_json;

/// UTC, with milliseconds: 2026-01-31T12:00:00.000Z.
std::string time_text(Time time);
const char* restart_text(Restart restart);
Json causes_json(const std::vector<Cause>& causes);
Json objects_json(const std::vector<ObjectState>& objects);
Json cameras_json(const std::vector<CameraState>& cameras);
Json actor_json(const Actor& actor);

template <class Value>
Json optional_json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// Empty, or 0, where there is none.
std::string text_in(const Json& json, const char* key);
std::int64_t number_in(const Json& json, const char* key);

}  // namespace horopter::monitor
