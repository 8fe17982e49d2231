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

/// Where a leaf lies in its object, and what it holds there: an integer of `bytes` bytes, sign-extended if signed.
struct Leaf {
  std::size_t offset = 0;
  unsigned bytes = 0;
  unsigned width = 0;
  bool is_signed = false;
  bool has_port = true;  ///< false: the top-level member `valid` of Out
};

/// The bits of leaves that have ports, two's complement, nothing above the width.
void get_leaves(const void* object, const std::vector<Leaf>& leaves, std::vector<std::uint64_t>& values);
/// Writes them; bits above the width are ignored.
void set_leaves(void* object, const std::vector<Leaf>& leaves, const std::vector<std::uint64_t>& values);

namespace detail {

struct Anything {
  template <class T>
  operator T() const;
};

template <class T, std::size_t... I>
constexpr bool braces_with(std::index_sequence<I...>) {
  return requires { T{(static_cast<void>(I), Anything{})...}; };
}

/// The largest number of values in braces that T takes.
template <class T, std::size_t N = 1>
constexpr std::size_t field_count() {
  if constexpr (braces_with<T>(std::make_index_sequence<N>{})) {
    return field_count<T, N + 1>();
  } else {
    return N - 1;
  }
}

/// Finds the leaves of objects, from the address of an object of each kind.
struct LeafFinder {
  const char* base;
  std::vector<Leaf>& leaves;

  void operator()(const bool& leaf) { add(&leaf, 1, 1, false); }
  template <int N>
  void operator()(const hls::u<N>& leaf) {
    static_assert(sizeof(leaf) == sizeof(leaf.value()));
    add(&leaf, sizeof(leaf), N, false);
  }
  template <int N>
  void operator()(const hls::s<N>& leaf) {
    static_assert(sizeof(leaf) == sizeof(leaf.value()));
    add(&leaf, sizeof(leaf), N, true);
  }
  template <class T, std::size_t N>
  void operator()(const std::array<T, N>& array) {
    for (const T& element : array) (*this)(element);
  }
  template <class T>
  void operator()(const T& object) {
    if constexpr (!std::is_empty_v<T>) open(object, std::integral_constant<std::size_t, field_count<T>()>{});
  }
  template <class... M>
  void all(const M&... members) {
    ((*this)(members), ...);
  }

#define HOROPTER_TB_OPEN(count, ...)                                       \
  template <class T>                                                       \
  void open(const T& object, std::integral_constant<std::size_t, count>) { \
    const auto& [__VA_ARGS__] = object;                                    \
    all(__VA_ARGS__);                                                      \
  }
  HOROPTER_TB_OPEN(1, a)
  HOROPTER_TB_OPEN(2, a, b)
  HOROPTER_TB_OPEN(3, a, b, c)
  HOROPTER_TB_OPEN(4, a, b, c, d)
  HOROPTER_TB_OPEN(5, a, b, c, d, e)
  HOROPTER_TB_OPEN(6, a, b, c, d, e, f)
  HOROPTER_TB_OPEN(7, a, b, c, d, e, f, g)
  HOROPTER_TB_OPEN(8, a, b, c, d, e, f, g, h)
  HOROPTER_TB_OPEN(9, a, b, c, d, e, f, g, h, i)
  HOROPTER_TB_OPEN(10, a, b, c, d, e, f, g, h, i, j)
  HOROPTER_TB_OPEN(11, a, b, c, d, e, f, g, h, i, j, k)
  HOROPTER_TB_OPEN(12, a, b, c, d, e, f, g, h, i, j, k, l)
  HOROPTER_TB_OPEN(13, a, b, c, d, e, f, g, h, i, j, k, l, m)
  HOROPTER_TB_OPEN(14, a, b, c, d, e, f, g, h, i, j, k, l, m, n)
  HOROPTER_TB_OPEN(15, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o)
  HOROPTER_TB_OPEN(16, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)
  HOROPTER_TB_OPEN(17, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
  HOROPTER_TB_OPEN(18, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r)
  HOROPTER_TB_OPEN(19, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s)
  HOROPTER_TB_OPEN(20, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t)
  HOROPTER_TB_OPEN(21, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u)
  HOROPTER_TB_OPEN(22, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v)
  HOROPTER_TB_OPEN(23, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w)
  HOROPTER_TB_OPEN(24, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x)
  HOROPTER_TB_OPEN(25, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y)
#undef HOROPTER_TB_OPEN

  void add(const void* leaf, std::size_t bytes, int width, bool is_signed) {
    leaves.push_back({static_cast<std::size_t>(static_cast<const char*>(leaf) - base), static_cast<unsigned>(bytes),
                      static_cast<unsigned>(width), is_signed, true});
  }
};

}  // namespace detail

template <class T>
std::vector<Leaf> leaves_of() {
  static_assert(std::is_trivially_copyable_v<T>);
  const T value{};
  std::vector<Leaf> leaves;
  detail::LeafFinder{reinterpret_cast<const char*>(&value), leaves}(value);
  if constexpr (requires { value.valid; }) {
    const auto offset =
        static_cast<std::size_t>(reinterpret_cast<const char*>(&value.valid) - reinterpret_cast<const char*>(&value));
    for (Leaf& leaf : leaves) leaf.has_port = leaf.offset != offset;
  }
  return leaves;
}

}  // namespace horopter::tb
