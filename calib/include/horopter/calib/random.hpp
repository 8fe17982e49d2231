// SPDX-License-Identifier: Apache-2.0
// Random numbers that are the same with every compiler and library, on any number of threads: a counter, mixed.
#pragma once

#include <array>
#include <cstdint>

namespace horopter::calib {

/// splitmix64's mixing function.
constexpr std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31);
}

class Random {
 public:
  /// A stream of its own for each seed and purpose or number.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(mix(mix(seed + 0x9E3779B97F4A7C15U) ^ (stream * 0xD1342543DE82EF95U + 1))) {}

  std::uint64_t next() { return mix(state_ += 0x9E3779B97F4A7C15U); }
  /// 0 ≤ x < 1.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// Deviation 1, mean 0: quantiles at the middles of 65536 equal parts, so none beyond 4.32.
  float gaussian();

 private:
  std::uint64_t state_;
  std::uint64_t reserve_ = 0;  ///< 16 bits each
  int left_ = 0;
};

}  // namespace horopter::calib
