// SPDX-License-Identifier: Apache-2.0
#include "hlsc/diagnostics.hpp"

namespace hlsc {

std::string format_error(const SourceLocation& where, const std::string& message) {
  if (where.file.empty()) return "error: " + message;
  return where.file + ":" + std::to_string(where.line) + ": error: " + message;
}

}  // namespace hlsc
