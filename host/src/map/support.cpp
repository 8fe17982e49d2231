// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/support.hpp"

#include <algorithm>
#include <cmath>

namespace horopter {

std::int64_t supported_pixels(const MapTable& table, Decision decision) {
  const hls::table::Facts& facts = table.facts();
  return decision == Decision::compete ? facts.judgeable_by_compete : facts.judgeable_by_thesis;
}

double compared_share(const MapTable& table, const MachineProfile& profile, int lookahead) {
  constexpr int kStep_px = 4;
  std::int64_t compared = 0;
  std::int64_t pixels = 0;
  for (int y = 0; y < table.geometry().height; y += kStep_px) {
    for (int x = 0; x < table.geometry().width; x += kStep_px) {
      ++pixels;
      const auto expanded = table.expand_around(x, y);
      if (!expanded || !table.round(*expanded, profile.weight_bits)) continue;
      const auto row = static_cast<int>(expanded->y >> MapTable::kFractionBits);
      compared += row >= y - profile.rows_behind() && row < y + lookahead ? 1 : 0;
    }
  }
  return static_cast<double>(compared) / static_cast<double>(pixels);
}

std::uint32_t limit_of(double percent, double of) {
  return static_cast<std::uint32_t>(std::max(0.0, std::floor(percent * of / 100 + 1e-9)));
}

}  // namespace horopter
