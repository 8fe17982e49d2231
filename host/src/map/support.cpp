// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/support.hpp"

#include <algorithm>
#include <cmath>

namespace horopter {

std::int64_t supported_pixels(const MapTable& table, Decision decision) {
  const hls::table::Facts& facts = table.facts();
  return decision == Decision::compete ? facts.judgeable_by_compete : facts.judgeable_by_thesis;
}

std::uint32_t limit_of(double percent, double of) {
  return static_cast<std::uint32_t>(std::max(0.0, std::floor(percent * of / 100 + 1e-9)));
}

}  // namespace horopter
