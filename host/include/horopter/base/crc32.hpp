// SPDX-License-Identifier: Apache-2.0
// CRC-32 of IEEE 802.3: reflected polynomial 0xEDB88320, initial value and final exclusive-or all ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace horopter {

class Crc32 {
 public:
  constexpr void add(std::uint8_t byte) { state_ = kTables[0][(state_ ^ byte) & 0xFF] ^ (state_ >> 8); }
  constexpr void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) add(byte);
  }
  /// The word as four bytes, least significant first.
  constexpr void add_word(std::uint32_t word) {
    state_ ^= word;
    state_ = kTables[3][state_ & 0xFF] ^ kTables[2][state_ >> 8 & 0xFF] ^ kTables[1][state_ >> 16 & 0xFF] ^
             kTables[0][state_ >> 24];
  }
  constexpr std::uint32_t value() const { return ~state_; }

 private:
  /// What a byte makes of the register, and what it makes with one, two and three bytes of 0 after it.
  static constexpr std::array<std::array<std::uint32_t, 256>, 4> kTables = [] {
    std::array<std::array<std::uint32_t, 256>, 4> tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t crc = i;
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
      tables[0][i] = crc;
    }
    for (std::size_t more = 1; more < tables.size(); ++more) {
      for (std::size_t i = 0; i < 256; ++i) {
        const std::uint32_t crc = tables[more - 1][i];
        tables[more][i] = tables[0][crc & 0xFF] ^ (crc >> 8);
      }
    }
    return tables;
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
