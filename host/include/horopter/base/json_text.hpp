// SPDX-License-Identifier: Apache-2.0
// JSON as text for files and standard output.
#pragma once

#include <string>

namespace horopter {

/// Indented by 2. What is not UTF-8, as names of files may be, becomes U+FFFD instead of an error at the end of a run.
template <class Json>
std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

/// The same in one line.
template <class Json>
std::string json_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace horopter
