// SPDX-License-Identifier: Apache-2.0
#include "statements.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

namespace horopter::cli {

nlohmann::json evaluate(const std::string& section, const Statement& statement) {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  for (const Measured& one : statement.measured) {
    if (one.is_number) {
      arguments.push_back(one.number);
    } else {
      arguments.push_back(one.words);
    }
  }
  return {{"section", section},
          {"statement", statement.quote},
          {"figure", fmt::vformat(statement.figure, arguments)},
          {"verdict", statement.limits.confirmed.holds(statement.measured) ? "confirmed"
                      : statement.limits.partly.holds(statement.measured)  ? "partly"
                                                                           : "not confirmed"},
          {"rule", statement.rule},
          {"headline", statement.headline}};
}

}  // namespace horopter::cli
