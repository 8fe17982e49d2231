// SPDX-License-Identifier: Apache-2.0
// A register or a memory of a Verilated model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace horopter::upset {

struct Signal {
  const char* name;    ///< instances and register, joined by dots
  const char* module;  ///< that assigns it
  unsigned bits;       ///< of a word
  unsigned words;
  void* at;
  std::size_t word_bytes;

  /// Small arrays are registers, too: a record for each of two frames, say.
  [[nodiscard]] bool is_memory() const { return words > 8; }
  [[nodiscard]] std::uint64_t all_bits() const { return std::uint64_t{bits} * words; }

  [[nodiscard]] bool get(std::uint64_t bit) const { return (byte(bit) >> shift(bit) & 1U) != 0; }
  void flip(std::uint64_t bit) const { byte(bit) ^= static_cast<std::uint8_t>(1U << shift(bit)); }

 private:
  // Verilator's words are the processor's, least significant byte first.
  [[nodiscard]] std::uint8_t& byte(std::uint64_t bit) const {
    return static_cast<std::uint8_t*>(at)[bit / bits * word_bytes + bit % bits / 8];
  }
  [[nodiscard]] unsigned shift(std::uint64_t bit) const { return static_cast<unsigned>(bit % bits % 8); }
};

}  // namespace horopter::upset
