// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/support.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace horopter {
namespace {

/// `thesis` judges where all windows are whole, `compete` where its 3×3 low-pass is (stages/planes.hpp).
int reach_of(const MachineProfile& profile, Decision decision) {
  return decision == Decision::compete ? 1 : profile.offset();
}

}  // namespace

std::int64_t supported_pixels(const MapTable& table, const MachineProfile& profile, Decision decision) {
  const Image supervised = table.supervised(profile.weight_bits);
  const int width = supervised.width / profile.subsample;
  const int side = 2 * reach_of(profile, decision) + 1;
  std::vector<int> above(static_cast<std::size_t>(width));  // supervised pixels in a column, up to this row
  std::int64_t count = 0;
  for (int y = 0; y < supervised.height; ++y) {
    const std::uint8_t* row = supervised.row(y).data();
    int before = 0;  // columns in a row that are supervised over `side` rows, up to this one
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* pair = row + std::ptrdiff_t{x} * profile.subsample;
      int& column = above[static_cast<std::size_t>(x)];
      column = pair[0] != 0 && pair[profile.subsample - 1] != 0 ? column + 1 : 0;
      before = column >= side ? before + 1 : 0;
      count += before >= side ? 1 : 0;
    }
  }
  return count;
}

std::uint32_t limit_of(double percent, double of) {
  return static_cast<std::uint32_t>(std::max(0.0, std::floor(percent * of / 100 + 1e-9)));
}

}  // namespace horopter
