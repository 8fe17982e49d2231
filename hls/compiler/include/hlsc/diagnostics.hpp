// SPDX-License-Identifier: Apache-2.0
// What hlsc says when it refuses a stage. Everything unsupported is an error: nothing is ever compiled approximately.
#pragma once

#include <stdexcept>
#include <string>

#include "hlsc/graph.hpp"

namespace hlsc {

/// `file:line: error: message`, or `error: message` where no place is known.
std::string format_error(const SourceLocation& where, const std::string& message);

/// Without a leading `./`, which -I. puts there.
std::string tidy_path(std::string path);

class CompileError : public std::runtime_error {
 public:
  CompileError(const SourceLocation& where, const std::string& message)
      : std::runtime_error(format_error(where, message)), where_(where), message_(message) {}
  [[nodiscard]] const SourceLocation& where() const { return where_; }
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  SourceLocation where_;
  std::string message_;
};

}  // namespace hlsc
