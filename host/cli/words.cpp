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

CLI::Option* add_decision(CLI::App& command, Decision& decision) {
  const std::string thesis(name_of(Decision::thesis)), compete(name_of(Decision::compete));
  CLI::Option* option = command.add_option_function<std::string>(
      "--decision",
      [&decision, compete](const std::string& name) {
        decision = name == compete ? Decision::compete : Decision::thesis;
      },
      "thesis: one skin, one threshold; compete: parallel skins compete, pixels that look alike vote");
  return only(option, {thesis, compete})->default_str(std::string(name_of(decision)));
}

}  // namespace horopter::cli
