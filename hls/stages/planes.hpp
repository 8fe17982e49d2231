// SPDX-License-Identifier: Apache-2.0
// The planes that compete in the rule `compete`: the skin and parallel skins beside it. The hypothesis shifted by s
// whole pixels in x is the hypothesis of the skin whose disparity is larger by s (thesis 12.2: several skins at once),
// so a plane costs one more difference and sum and no transformation.
//
// Everything from plane_sums on delays its marks with the pixel, so `align` has no offset in columns. All pixels whose
// low-pass exists are decided: at the image's border by those that vote. Where there is little but noise, the best of
// many planes outside beats the best of the three inside. So a pixel votes only where a plane explains what the left
// image shows (`evident`), and `clear` takes a larger majority than `skin`; what is left is undecidable.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace horopter::stages {

/// Shifts in px, ascending, symmetrical, 0 … ±3 all there: the boundary of the skin lies between the planes ±1 and ±2.
template <std::size_t COUNT>
struct PlaneSet {
  std::array<int, COUNT> shift{};

  static constexpr std::size_t count = COUNT;
  static constexpr std::size_t zero = COUNT / 2;
  [[nodiscard]] constexpr int reach() const { return shift[COUNT - 1]; }
  [[nodiscard]] constexpr bool valid() const {
    if (COUNT % 2 == 0 || COUNT < 7) return false;
    for (std::size_t i = 0; i <= zero; ++i) {
      if (shift[zero + i] != -shift[zero - i] || (i > 0 && shift[zero + i] <= shift[zero + i - 1])) return false;
    }
    return shift[zero + 3] == 3;
  }

  /// The smallest of what the planes begin … end − 1 have: a tree in hardware, on the CPU a chain, which copies nothing.
  template <class T>
  static constexpr T smallest(const std::array<T, COUNT>& costs, std::size_t begin = 0, std::size_t end = COUNT) {
#ifdef __HLSC__
    std::array<T, COUNT> least = costs;
    std::size_t n = end - begin;
    for (std::size_t i = 0; i < n; ++i) least[i] = costs[begin + i];
    for (; n > 1; n = (n + 1) / 2) {
      for (std::size_t i = 0; i < n / 2; ++i) least[i] = min(least[2 * i], least[2 * i + 1]);
      if (n % 2 == 1) least[n / 2] = least[n - 1];
    }
    return least[0];
#else
    T least = costs[begin];
    for (std::size_t n = begin + 1; n < end; ++n) least = min(least, costs[n]);
    return least;
#endif
  }
};

/// Near planes bound the skin; far ones keep what repeats or lies far away from looking like it.
inline constexpr PlaneSet<19> planes_19{{-24, -18, -13, -9, -6, -4, -3, -2, -1, 0, 1, 2, 3, 4, 6, 9, 13, 18, 24}};

static_assert(planes_19.valid());

/// The set of so many; 0 stands in profiles that do not have `compete`. Others are not there.
template <int COUNT>
inline constexpr std::nullptr_t planes_of = nullptr;
template <>
inline constexpr const auto& planes_of<19> = planes_19;
template <>
inline constexpr const auto& planes_of<0> = planes_19;

}  // namespace horopter::stages
