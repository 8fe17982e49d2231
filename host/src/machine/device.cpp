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

void Device::write_all(std::uint32_t address, std::span<const std::uint32_t> values) {
  for (const std::uint32_t value : values) write(address, value);
}

std::vector<std::uint32_t> Device::read_all(std::uint32_t address, std::size_t registers) {
  std::vector<std::uint32_t> values(registers);
  for (std::size_t i = 0; i < registers; ++i) values[i] = read(address + static_cast<std::uint32_t>(4 * i));
  return values;
}

}  // namespace horopter
