// SPDX-License-Identifier: Apache-2.0
// The leaves of a stage's In, Out or Config in the order of the emitted module's ports, found without a list of names:
// aggregates and std::array are opened, bool, u<N> and s<N> are leaves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "horopter/hls/int.hpp"

namespace horopter::tb {

namespace detail {

struct Anything {
  template <class T>
  operator T() const;
};

template <class T, std::size_t... I>
constexpr bool braces_with(std::index_sequence<I...>) {
  return requires { T{(static_cast<void>(I), Anything{})...}; };
}

template <class T, std::size_t N = 32>
constexpr std::size_t field_count() {
  if constexpr (braces_with<T>(std::make_index_sequence<N>{})) {
    return N;
  } else {
    static_assert(N > 0, "not an aggregate");
    return field_count<T, N - 1>();
  }
}

template <class T>
struct LeafOf : std::false_type {};
template <>
struct LeafOf<bool> : std::true_type {
  static constexpr unsigned width = 1;
  static constexpr bool is_signed = false;
};
template <int N>
struct LeafOf<hls::u<N>> : std::true_type {
  static constexpr unsigned width = N;
  static constexpr bool is_signed = false;
};
template <int N>
struct LeafOf<hls::s<N>> : std::true_type {
  static constexpr unsigned width = N;
  static constexpr bool is_signed = true;
};

template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};

}  // namespace detail

/// Calls f(field) for each direct member of an aggregate.
template <class T, class F>
void for_each_field(T& value, F&& f) {
  constexpr std::size_t n = detail::field_count<std::remove_const_t<T>>();
  static_assert(n <= 24, "more members than for_each_field can bind");
#define HOROPTER_TB_BIND(count, ...)                                            \
  if constexpr (n == count) {                                                   \
    auto& [__VA_ARGS__] = value;                                                \
    [&](auto&... member) { (static_cast<void>(f(member)), ...); }(__VA_ARGS__); \
  }
  HOROPTER_TB_BIND(1, a)
  HOROPTER_TB_BIND(2, a, b)
  HOROPTER_TB_BIND(3, a, b, c)
  HOROPTER_TB_BIND(4, a, b, c, d)
  HOROPTER_TB_BIND(5, a, b, c, d, e)
  HOROPTER_TB_BIND(6, a, b, c, d, e, g)
  HOROPTER_TB_BIND(7, a, b, c, d, e, g, h)
  HOROPTER_TB_BIND(8, a, b, c, d, e, g, h, i)
  HOROPTER_TB_BIND(9, a, b, c, d, e, g, h, i, j)
  HOROPTER_TB_BIND(10, a, b, c, d, e, g, h, i, j, k)
  HOROPTER_TB_BIND(11, a, b, c, d, e, g, h, i, j, k, l)
  HOROPTER_TB_BIND(12, a, b, c, d, e, g, h, i, j, k, l, m)
  HOROPTER_TB_BIND(13, a, b, c, d, e, g, h, i, j, k, l, m, o)
  HOROPTER_TB_BIND(14, a, b, c, d, e, g, h, i, j, k, l, m, o, p)
  HOROPTER_TB_BIND(15, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q)
  HOROPTER_TB_BIND(16, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r)
  HOROPTER_TB_BIND(17, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s)
  HOROPTER_TB_BIND(18, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t)
  HOROPTER_TB_BIND(19, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, v)
  HOROPTER_TB_BIND(20, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, v, w)
  HOROPTER_TB_BIND(21, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, v, w, x)
  HOROPTER_TB_BIND(22, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, v, w, x, y)
  HOROPTER_TB_BIND(23, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, v, w, x, y, z)
  HOROPTER_TB_BIND(24, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, v, w, x, y, z, a1)
#undef HOROPTER_TB_BIND
}

/// Calls f(leaf) for each leaf of `value`, in port order.
template <class T, class F>
void for_each_leaf(T& value, F&& f) {
  using Plain = std::remove_const_t<T>;
  if constexpr (detail::LeafOf<Plain>::value) {
    f(value);
  } else if constexpr (detail::IsArray<Plain>::value) {
    for (auto& element : value) for_each_leaf(element, f);
  } else if constexpr (!std::is_empty_v<Plain>) {
    for_each_field(value, [&](auto& member) { for_each_leaf(member, f); });
  }
}

template <class T>
inline constexpr unsigned leaf_width = detail::LeafOf<std::remove_cvref_t<T>>::width;
template <class T>
inline constexpr bool leaf_signed = detail::LeafOf<std::remove_cvref_t<T>>::is_signed;

/// The bits of a leaf as they are on a port: two's complement, nothing above the width.
template <class T>
std::uint64_t leaf_bits(const T& leaf) {
  constexpr unsigned width = leaf_width<T>;
  std::uint64_t bits = 0;
  if constexpr (std::is_same_v<T, bool>) {
    bits = leaf;
  } else {
    bits = static_cast<std::uint64_t>(leaf.value());
  }
  return width == 64 ? bits : bits & ((std::uint64_t{1} << (width % 64)) - 1);
}

/// A leaf from port bits; bits above the width are ignored.
template <class T>
T leaf_from_bits(std::uint64_t bits) {
  if constexpr (std::is_same_v<T, bool>) {
    return (bits & 1) != 0;
  } else {
    return T(bits);
  }
}

struct LeafShape {
  unsigned width = 0;
  bool is_signed = false;
  friend bool operator==(const LeafShape&, const LeafShape&) = default;
};

/// Widths and signs of all leaves but a top-level member `valid` (which has no port of its own) when `skip_valid`.
template <class T>
std::vector<LeafShape> leaf_shapes(bool skip_valid) {
  std::vector<LeafShape> shapes;
  T value{};
  const void* valid = nullptr;
  if constexpr (requires { value.valid; }) valid = skip_valid ? &value.valid : nullptr;
  for_each_leaf(value, [&](auto& leaf) {
    if (static_cast<const void*>(&leaf) == valid) return;
    shapes.push_back({leaf_width<decltype(leaf)>, leaf_signed<decltype(leaf)>});
  });
  return shapes;
}

/// All leaves, packed least significant first in port order into 32-bit words. `skip_valid` as above.
template <class T>
void pack(const T& value, bool skip_valid, std::vector<std::uint32_t>& words) {
  const void* valid = nullptr;
  if constexpr (requires { value.valid; }) valid = skip_valid ? &value.valid : nullptr;
  words.clear();
  std::uint64_t pending = 0;  // of which `filled` < 32 bits are used
  unsigned filled = 0;
  const auto append = [&](std::uint64_t bits, unsigned width) {
    pending |= bits << filled;
    for (filled += width; filled >= 32; filled -= 32) {
      words.push_back(static_cast<std::uint32_t>(pending));
      pending >>= 32;
    }
  };
  for_each_leaf(value, [&](auto& leaf) {
    if (static_cast<const void*>(&leaf) == valid) return;
    constexpr unsigned width = leaf_width<decltype(leaf)>;
    const std::uint64_t bits = leaf_bits(leaf);
    append(bits & 0xffffffffu, width < 32 ? width : 32);
    if constexpr (width > 32) append(bits >> 32, width - 32);
  });
  if (filled) words.push_back(static_cast<std::uint32_t>(pending));
}

}  // namespace horopter::tb
