// SPDX-License-Identifier: Apache-2.0
// A colour picture.
#pragma once

#include <cstdint>
#include <vector>

namespace horopter {

/// Interleaved blue, green, red, row by row.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bgr;
};

}  // namespace horopter
