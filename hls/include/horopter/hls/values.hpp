// SPDX-License-Identifier: Apache-2.0
// What a pixel's values are made of. Stages take it as a template argument: Scalar is one pixel a step, the hardware;
// Lanes (lanes.hpp) is several places of the image at once, for the CPU's vector unit. Only values that belong to a
// pixel are of these types; positions, marks and settings are the same in all lanes and stay scalar.
#pragma once

#include "horopter/hls/int.hpp"

namespace horopter::hls {

struct Scalar {
  template <int N>
  using u = hls::u<N>;
  template <int N>
  using s = hls::s<N>;
  using bit = bool;
};

/// condition ? a : b, for every lane.
template <class T>
constexpr T select(bool condition, const T& a, const T& b) {
  return condition ? a : b;
}

/// table[index], for every lane.
template <class T, std::size_t SIZE, int N>
constexpr T lookup(const std::array<T, SIZE>& table, u<N> index) {
  static_assert(SIZE >> N == 1, "the table must have an entry for every index");
  return table[index.value()];
}

}  // namespace horopter::hls
