// SPDX-License-Identifier: Apache-2.0
#include "record.hpp"

#include <algorithm>
#include <vector>

#include "horopter/map/map_json.hpp"

namespace horopter::monitor {
namespace {

/// The causes of now, and those that were latched and are over already.
std::vector<Cause> causes_of(const Status& status) {
  std::vector<Cause> causes = status.causes;
  for (const Cause& cause : status.latched) {
    if (std::find(causes.begin(), causes.end(), cause) == causes.end()) causes.push_back(cause);
  }
  return causes;
}

}  // namespace

std::string sentence_of(const Status& status) {
  std::string text;
  for (const Cause& cause : causes_of(status)) {
    if (!text.empty()) text += " ";
    text += cause.text.empty() ? cause.name : cause.text;
    if (!text.ends_with('.') && !text.ends_with('!')) text += ".";
  }
  return text.empty() ? "It is not safe any more; no cause was given." : text;
}

Json stop_json(const Status& status, bool has_moment) {
  return {{"causes", causes_json(causes_of(status))},
          {"alarm", status.alarm},
          {"objects", objects_json(status.objects)},
          {"frame", status.frame},
          {"pair", has_moment},
          {"table", status.table},
          {"table_crc", crc_text(status.table_crc)},
          {"skew_ms", optional_json(status.skew_ms)},
          {"explained", optional_json(status.explained)},
          {"decision_ms", status.decision_ms},
          {"cameras", cameras_json(status.cameras)}};
}

}  // namespace horopter::monitor
