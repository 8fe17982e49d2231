// SPDX-License-Identifier: Apache-2.0
// Horizontal parts of the causal windows: delay lines, running sums, and the AND over a window.
//
// STRIDE is the number of images whose pixels alternate in one stream: neighbours of one image are STRIDE beats apart.
#pragma once

#include <array>

#include "horopter/hls/int.hpp"

namespace horopter::hls {

/// The last N beats. tap(i) is what was pushed i + 1 beats before; read taps before push.
template <class T, int N>
class DelayLine {
 public:
  [[nodiscard]] const T& tap(int index) const { return values_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const T& oldest() const { return values_[N - 1]; }

  void push(const T& value) {
    for (int i = N - 1; i > 0; --i) values_[static_cast<std::size_t>(i)] = values_[static_cast<std::size_t>(i - 1)];
    values_[0] = value;
  }

  void fill(const T& value) {
    for (T& v : values_) v = value;
  }

 private:
  std::array<T, static_cast<std::size_t>(N)> values_{};
};

/// Sum of the last K column values (each at most COLUMN_MAX) of a row, K·STRIDE beats wide: S(x) = S(x−1) + (C(x) −
/// C(x−K)) (thesis 10.1.5). The difference is taken apart from the sum, so the recurrence is one addition. Each row
/// starts from 0; columns before the row count as 0.
template <int K, int COLUMN_MAX, int STRIDE = 1>
class HorizontalSum {
 public:
  static constexpr int column_bits = bits_for(COLUMN_MAX);
  static constexpr int sum_bits = bits_for(K * COLUMN_MAX);

  /// `filled`: at least K columns of this row lie before this one.
  u<sum_bits> step(bool row_start, bool filled, u<column_bits> column_sum) {
    const u<column_bits> leaving = filled ? columns_.oldest() : u<column_bits>(0);
    columns_.push(column_sum);
    const s<column_bits + 1> change = column_sum - leaving;
    if (row_start) sums_.fill(u<sum_bits>(0));
    const u<sum_bits> sum(sums_.oldest() + change);
    sums_.push(sum);
    return sum;
  }

 private:
  DelayLine<u<column_bits>, K * STRIDE> columns_;
  DelayLine<u<sum_bits>, STRIDE> sums_;
};

/// Run length of true bits up the column, at most K: what WindowAnd keeps per column.
template <int K>
using ColumnRun = u<bits_for(K - 1)>;

/// AND of a bit over K×K pixels that ends at the current one, false where the window leaves the row or frame. Counts
/// runs instead of keeping K rows of bits.
template <int K, int STRIDE = 1>
class WindowAnd {
 public:
  /// `above`: run length stored for this column, 0 in the frame's first row. `stored` becomes what to store.
  bool step(bool row_start, bool bit, ColumnRun<K> above, ColumnRun<K>& stored) {
    const bool column_full = bit && above == K - 1;
    stored = !bit ? ColumnRun<K>(0) : above == K - 1 ? above : ColumnRun<K>(above + lit<1>());
    if (row_start) runs_.fill(ColumnRun<K>(0));
    const ColumnRun<K> left = runs_.oldest();
    runs_.push(!column_full ? ColumnRun<K>(0) : left == K - 1 ? left : ColumnRun<K>(left + lit<1>()));
    return column_full && left == K - 1;
  }

 private:
  DelayLine<ColumnRun<K>, STRIDE> runs_;
};

}  // namespace horopter::hls
