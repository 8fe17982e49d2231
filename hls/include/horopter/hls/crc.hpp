// SPDX-License-Identifier: Apache-2.0
// CRC-32 of IEEE 802.3 (reflected, initial value and final inversion all ones), a byte at a time.
#pragma once

#include "horopter/hls/int.hpp"

namespace horopter::hls {

inline constexpr u<32> crc32_initial{0xFFFFFFFFU};

/// The register after one more byte. The CRC is the inverted register.
constexpr u<32> crc32_byte(u<32> crc, u<8> byte) {
  std::uint32_t value = crc.value() ^ byte.value();
  for (int i = 0; i < 8; ++i) value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
  return {value};
}

}  // namespace horopter::hls
