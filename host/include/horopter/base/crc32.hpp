// SPDX-License-Identifier: Apache-2.0
// CRC-32 of IEEE 802.3: reflected polynomial 0xEDB88320, initial value and final exclusive-or all ones.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace horopter {

class Crc32 {
 public:
  constexpr void add(std::uint8_t byte) { state_ = kTable[(state_ ^ byte) & 0xFF] ^ (state_ >> 8); }
  constexpr void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) add(byte);
  }
  /// The word as four bytes, least significant first.
  constexpr void add_word(std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) add(static_cast<std::uint8_t>(word >> shift));
  }
  constexpr std::uint32_t value() const { return ~state_; }

 private:
  static constexpr std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t crc = i;
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
      table[i] = crc;
    }
    return table;
  }();
  std::uint32_t state_ = 0xFFFFFFFFU;
};

constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

constexpr std::uint32_t crc32_words(std::span<const std::uint32_t> words) {
  Crc32 crc;
  for (const std::uint32_t word : words) crc.add_word(word);
  return crc.value();
}

}  // namespace horopter
