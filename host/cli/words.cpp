// SPDX-License-Identifier: Apache-2.0
#include "words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace horopter::cli {

CLI::Option* only(CLI::Option* option, const std::vector<std::string>& words) {
  const auto check = [words](const std::string& word) {
    if (std::ranges::find(words, word) != words.end()) return std::string();
    return fmt::format("'{}' is not one of {}", word, fmt::join(words, ", "));
  };
  const char* more = option->get_delimiter() == '\0' ? "" : ",…";
  return option->check(check, "")->type_name(fmt::format("{}{}", fmt::join(words, "|"), more));
}

}  // namespace horopter::cli
