// SPDX-License-Identifier: Apache-2.0
#include "warnings.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace horopter::cli {
namespace {

std::vector<std::string>& said() {
  static std::vector<std::string> all;
  return all;
}

}  // namespace

void warn(const std::string& text) {
  if (std::ranges::find(said(), text) != said().end()) return;
  said().push_back(text);
  std::fprintf(stderr, "horopter: warning: %s\n", text.c_str());
}

void add_warnings(nlohmann::ordered_json& result) {
  if (!said().empty()) result["warnings"] = said();
}

}  // namespace horopter::cli
