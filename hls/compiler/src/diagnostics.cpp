// SPDX-License-Identifier: Apache-2.0
#include "hlsc/diagnostics.hpp"

namespace hlsc {

std::string format_error(const SourceLocation& where, const std::string& message) {
  if (where.file.empty()) return "error: " + message;
  return where.file + ":" + std::to_string(where.line) + ": error: " + message;
}

std::string tidy_path(std::string path) { return path.starts_with("./") ? path.substr(2) : path; }

}  // namespace hlsc
