// SPDX-License-Identifier: Apache-2.0
// The monitor's numbers as text for Prometheus.
#pragma once

#include <string>

#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

/// In the text format 0.0.4, served by the page as /metrics.
std::string metrics(const Status& status);

}  // namespace horopter::monitor
