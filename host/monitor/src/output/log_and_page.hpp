// SPDX-License-Identifier: Apache-2.0
// The event log of a cell, and the page that shows it: either without the other, too.
#pragma once

#include <memory>

#include "horopter/monitor/part.hpp"

namespace horopter::monitor {

/// For a cell that has `log` or `web`. Throws FileError for the log's directory, users, certificate and key; UsageError for a
/// page that would not be safe, or cannot listen.
std::unique_ptr<Part> make_log_and_page(const Cell& cell, Control& control);

}  // namespace horopter::monitor
