// SPDX-License-Identifier: Apache-2.0
// Constant tables, computed by the compiler.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "horopter/hls/int.hpp"

namespace horopter::hls {

namespace detail {

/// arctan x for 0 ≤ x ≤ 1 by Euler's series; std::atan is not constexpr. Error below 1e-15.
constexpr double constexpr_atan(double x) {
  const double y = x * x / (1 + x * x);
  double term = x / (1 + x * x);
  double sum = term;
  for (int n = 1; n < 100; ++n) {
    term *= y * (2.0 * n) / (2.0 * n + 1);
    sum += term;
  }
  return sum;
}

}  // namespace detail

/// arctan((i + ½) / 2^INDEX_BITS) in 1/256 turn, rounded: 0 … 32.
template <int INDEX_BITS>
constexpr std::array<u<6>, (std::size_t{1} << INDEX_BITS)> make_arctangent_table() {
  std::array<u<6>, (std::size_t{1} << INDEX_BITS)> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double ratio = (static_cast<double>(i) + 0.5) / static_cast<double>(table.size());
    const double code = detail::constexpr_atan(ratio) * 128.0 / std::numbers::pi;
    table[i] = u<6>(static_cast<int>(code + 0.5));  // NOLINT(bugprone-incorrect-roundings): constexpr, code >= 0
  }
  return table;
}

template <int INDEX_BITS>
inline constexpr auto arctangent_table = make_arctangent_table<INDEX_BITS>();

}  // namespace horopter::hls
