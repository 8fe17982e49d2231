// SPDX-License-Identifier: Apache-2.0
// count_bits: how many bits of a value are set.
#pragma once

#include <array>
#include <cstddef>

#include "stages/stream.hpp"

namespace horopter::stages {

/// In hardware by full adders of three bits: a tree of wider ones would be deeper, and larger.
template <std::size_t N>
u<bits_for(N)> count_bits(const std::array<bool, N>& bits) {
  if constexpr (N == 1) {
    return u<1>(bits[0]);
  } else {
    constexpr std::size_t full = (N - 1) / 2, half = (N - 1) % 2;
    std::array<bool, N + full + half> of_one{};  // waiting to be added
    for (std::size_t i = 0; i < N; ++i) of_one[i] = bits[i];
    std::array<bool, full + half> of_two{};
    for (std::size_t i = 0; i < full + half; ++i) {
      const bool a = of_one[3 * i], b = of_one[3 * i + 1], c = i < full && of_one[3 * i + 2];
      of_one[N + i] = (a != b) != c;
      of_two[i] = (a && b) || (c && (a || b));
    }
    return u<bits_for(N)>(cat(count_bits(of_two), u<1>(of_one.back())));
  }
}

template <int N>
u<bits_for(N)> count_bits(u<N> bits) {
#ifndef __HLSC__
  return popcount(bits);
#endif
  std::array<bool, N> single{};
  for (int i = 0; i < N; ++i) single[static_cast<std::size_t>(i)] = bits.bit(i);
  return count_bits(single);
}

}  // namespace horopter::stages
