// SPDX-License-Identifier: Apache-2.0
// The faults of a frame or of a machine: one value for the fault registers of both cameras and of the machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "horopter/machine/registers.hpp"

namespace horopter {

using registers::Fault;

/// A set of faults.
class Faults {
 public:
  constexpr Faults() = default;
  constexpr Faults(Fault fault) : bits_(std::uint64_t{1} << static_cast<unsigned>(fault)) {}  // NOLINT: one is a set
  /// From the words of two registers: FAULTS_CAMERAS and FAULTS_MACHINE, or FRAME_FAULTS_CAMERAS and
  /// FRAME_FAULTS_MACHINE.
  constexpr Faults(std::uint32_t cameras, std::uint32_t machine) : bits_(std::uint64_t{machine} << 32 | cameras) {}

  [[nodiscard]] constexpr std::uint32_t cameras() const { return static_cast<std::uint32_t>(bits_); }
  [[nodiscard]] constexpr std::uint32_t machine() const { return static_cast<std::uint32_t>(bits_ >> 32); }

  [[nodiscard]] constexpr bool any() const { return bits_ != 0; }
  [[nodiscard]] constexpr bool has(Fault fault) const { return (bits_ & Faults(fault).bits_) != 0; }

  constexpr Faults& operator|=(Faults others) {
    bits_ |= others.bits_;
    return *this;
  }
  constexpr void clear(Faults others) { bits_ &= ~others.bits_; }
  [[nodiscard]] constexpr Faults without(Faults others) const {
    others.bits_ = bits_ & ~others.bits_;
    return others;
  }
  friend constexpr Faults operator|(Faults a, Faults b) { return a |= b; }
  friend constexpr bool operator==(Faults, Faults) = default;

  /// As in registers.yaml, those of the left camera first, then the right one's, then the machine's.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& [fault, name] : registers::kFaults) {
      if (has(fault)) names.emplace_back(name);
    }
    return names;
  }

 private:
  std::uint64_t bits_ = 0;
};

}  // namespace horopter
