// SPDX-License-Identifier: Apache-2.0
// What a record of the event log says, as JSON.
#pragma once

#include <string>

#include "status_json.hpp"

namespace horopter::monitor {

/// "The skin was touched; the left image was late", of the causes' texts.
std::string sentence_of(const Status& status);
/// Causes, objects, table, cameras.
Json stop_json(const Status& status, bool has_moment);

}  // namespace horopter::monitor
