// SPDX-License-Identifier: Apache-2.0
// CRC-32 of IEEE 802.3 (reflected, initial value and final inversion all ones), a byte at a time.
#pragma once

#include <array>

#include "horopter/hls/int.hpp"

namespace horopter::hls {

inline constexpr u<32> crc32_initial{0xFFFFFFFFU};

/// The register after one more byte. The CRC is the inverted register.
constexpr u<32> crc32_byte(u<32> crc, u<8> byte);

namespace detail {

constexpr std::uint32_t crc32_shift8(std::uint32_t value) {
  for (int i = 0; i < 8; ++i) value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
  return value;
}

constexpr std::array<std::uint32_t, 256> make_crc32_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) table[i] = crc32_shift8(i);
  return table;
}

inline constexpr auto crc32_table = make_crc32_table();

}  // namespace detail

constexpr u<32> crc32_byte(u<32> crc, u<8> byte) {
#ifdef __HLSC__
  return {detail::crc32_shift8(crc.value() ^ byte.value())};  // a tree of exclusive ors
#else
  return {(crc.value() >> 8) ^ detail::crc32_table[(crc.value() ^ byte.value()) & 0xFFU]};
#endif
}

}  // namespace horopter::hls
