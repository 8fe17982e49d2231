// SPDX-License-Identifier: Apache-2.0
// Horizontal parts of the causal windows: delay lines, running sums, and the AND over a window.
//
// STRIDE is the number of images whose pixels alternate in one stream: neighbours of one image are STRIDE beats apart.
#pragma once

#include <array>
#include <bit>
#include <cstddef>

#include "horopter/hls/kept.hpp"
#include "horopter/hls/values.hpp"

namespace horopter::hls {

/// The last N beats. tap(i) is what was pushed i + 1 beats before; read taps before push. A shift register; the CPU
/// moves an index instead of the values where they are many.
template <class T, int N>
class DelayLine {
 public:
  [[nodiscard]] const T& tap(int index) const { return values_[place(static_cast<std::size_t>(index))]; }
  /// To change it: after push, at(0) is what was pushed in this beat.
  [[nodiscard]] T& at(int index) { return values_[place(static_cast<std::size_t>(index))]; }
  [[nodiscard]] const T& oldest() const { return tap(N - 1); }

#ifdef __HLSC__
  void push(const T& value) {
    for (std::size_t i = N - 1; i > 0; --i) values_[i] = values_[i - 1];
    values_[0] = value;
  }
#else
  void push(const T& value) {
    if constexpr (ring) {
      newest_ = (newest_ - 1) & (size - 1);
    } else {
      for (std::size_t i = N - 1; i > 0; --i) values_[i] = values_[i - 1];
    }
    values_[newest_] = value;
  }
#endif

  void fill(const T& value) {
    for (T& v : values_) v = value;
  }

 private:
#ifdef __HLSC__
  static constexpr std::size_t size = N;
  static constexpr std::size_t place(std::size_t index) { return index; }
#else
  static constexpr bool ring = N > 2;
  static constexpr std::size_t size = ring ? std::bit_ceil(static_cast<std::size_t>(N)) : static_cast<std::size_t>(N);
  [[nodiscard]] std::size_t place(std::size_t index) const { return ring ? (newest_ + index) & (size - 1) : index; }
  std::size_t newest_ = 0;
#endif
  std::array<T, size> values_{};
};

/// Sum of the last column values of a row: S(x) = S(x−1) + (C(x) − C(x−K)) (thesis 10.1.5). The difference is taken
/// apart from the sum, so the recurrence is one addition. Each row starts from 0. A value may hold several fields side
/// by side, each wide enough for its own sum: one adder for all.
template <int BITS, int STRIDE = 1, class V = Scalar>
class RowSum {
 public:
  using Sum = typename V::template u<BITS>;

  /// `leaving`: the column value that leaves the window; 0 if it lies before the row.
  Sum step(bool row_start, Sum entering, Sum leaving) {
    const Sum change(entering - leaving);
    if (row_start) [[unlikely]] {
      sums_->fill(Sum(0));
    }
    const Sum sum(sums_->oldest() + change);
    sums_->push(sum);
    return sum;
  }

 private:
  Kept<DelayLine<Sum, STRIDE>> sums_;
};

/// The same with the last K column values, of COLUMN_BITS, K·STRIDE beats wide, in registers.
template <int K, int BITS, int STRIDE = 1, class V = Scalar, int COLUMN_BITS = BITS>
class HorizontalSum {
 public:
  using Sum = typename V::template u<BITS>;
  using Column = typename V::template u<COLUMN_BITS>;

  /// `filled`: at least K columns of this row lie before this one.
  Sum step(bool row_start, bool filled, Column column) {
    const Sum leaving(filled ? columns_->oldest() : Column(0));
    columns_->push(column);
    return sum_.step(row_start, Sum(column), leaving);
  }
  /// The column value `back` columns before the one of the last step; of another row where that lies before the row.
  [[nodiscard]] Column column(int back) { return columns_->tap(back * STRIDE); }

 private:
  Kept<DelayLine<Column, K * STRIDE>> columns_;
  RowSum<BITS, STRIDE, V> sum_;
};

/// The bits of the K − 1 pixels above in a column, the nearest lowest: what WindowAnd keeps per column.
template <int K, class V = Scalar>
using ColumnBits = typename V::template u<K - 1>;

/// AND of a bit over K×K pixels that ends at the current one, false where the window leaves the row or frame.
template <int K, int STRIDE = 1, class V = Scalar>
class WindowAnd {
 public:
  using Bits = ColumnBits<K, V>;
  using Bit = typename V::bit;

  /// `above`: bits stored for this column, 0 in the frame's first row. `stored` becomes what to store.
  Bit step(bool row_start, Bit bit, Bits above, Bits& stored) {
    const auto column = cat(above, bit);
    stored = Bits(column);
    if (row_start) [[unlikely]] {
      columns_->fill(Bits(0));
    }
    const auto row = cat(columns_->oldest(), column == u<K>::max());
    columns_->push(Bits(row));
    return row == u<K>::max();
  }

 private:
  Kept<DelayLine<Bits, STRIDE>> columns_;  // whether the K − 1 columns to the left are all true, the nearest lowest
};

}  // namespace horopter::hls
