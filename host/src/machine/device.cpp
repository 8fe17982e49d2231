// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/device.hpp"

namespace horopter {

std::uint64_t encode_run(const Run& run) {
  return static_cast<std::uint64_t>(run.state) << 62 | (static_cast<std::uint64_t>(run.row) & 0xFFFFU) << 32 |
         (static_cast<std::uint64_t>(run.start) & 0xFFFFU) << 16 | (static_cast<std::uint64_t>(run.end) & 0xFFFFU);
}

Run decode_run(std::uint64_t beat) {
  return {static_cast<int>(beat >> 32 & 0xFFFFU), static_cast<int>(beat >> 16 & 0xFFFFU),
          static_cast<int>(beat & 0xFFFFU), static_cast<State>(beat >> 62)};
}

}  // namespace horopter
