// SPDX-License-Identifier: Apache-2.0
// A client of an MQTT broker: the state as a retained message, events as they come. If the client is gone the broker says
// that it is not safe.
#pragma once

#include <memory>

#include "horopter/monitor/part.hpp"

namespace horopter::monitor {

/// Throws FileError for files that cannot be used. A broker that is not there is tried again, and is trouble.
std::unique_ptr<Part> make_mqtt(const MqttCell& mqtt, const Cell& cell, const SafeState& state, const Control& control);

}  // namespace horopter::monitor
