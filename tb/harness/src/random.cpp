// SPDX-License-Identifier: Apache-2.0
#include "horopter/tb/random.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace horopter::tb {

std::uint64_t session_seed() {
  static const std::uint64_t seed = [] {
    const char* text = std::getenv("HOROPTER_SEED");
    if (!text || !*text) return std::uint64_t{1};
    std::size_t used = 0;
    const std::uint64_t value = std::stoull(text, &used, 0);
    if (text[used]) throw std::invalid_argument{std::string{"HOROPTER_SEED: not a number: "} + text};
    return value;
  }();
  return seed;
}

}  // namespace horopter::tb
