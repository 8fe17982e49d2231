// SPDX-License-Identifier: Apache-2.0
// dsad: sum of the direction differences over K×K (thesis 10.1.5, 10.4.5), for each hypothesis and the self difference.
//
// Out   sum[n], 0 … 15·K², exact. mask: all of the K×K exist. textured passes through, see texture.
// Running sums: per column C(y) = C(y−1) + (d(y) − d(y−K)), along the row S(x) = S(x−1) + (C(x) − C(x−K)). They start
// anew with each frame and row, so an upset bit of memory is gone with the frame. Offset: (K − 1) / 2 rows and columns.
// Memory: per column K rows of 4-bit differences and their sum for each n, and K − 1 bits of mask. DELAY_IN_RAM: the
// last column sums of the row, too, in place of K registers each.
#pragma once

#include "stages/texture.hpp"

namespace horopter::stages {

template <int BEATS, int HYPOTHESES, int K, class V = Scalar, bool DELAY_IN_RAM = false>
class DsadSum {
  static_assert(K >= 5 && K <= 13 && K % 2 == 1, "the window is 5×5 to 13×13");

 public:
  template <int N>
  using U = typename V::template u<N>;
  using Bit = typename V::bit;

  static constexpr int sum_bits = bits_for(15 * K * K);
  static constexpr std::size_t sums = HYPOTHESES + 1;

  struct In {
    std::array<U<4>, sums> difference{};
    Bit textured = false;
    Bit mask = false;
    Marks marks;
  };
  struct Out {
    std::array<U<sum_bits>, sums> sum{};
    Bit textured = false;
    Bit mask = false;
    Marks marks;
  };

  Out step(const In& in) {
    memory_.begin_step();
    const auto at = raster_.step(in.marks.first, in.marks.last);
    Column above = memory_.read(at.column);
    if (at.frame_start_row) [[unlikely]] {
      above.mask = ColumnBits<K, V>(0);
      above.sum.fill(U<column_bits>(0));
    }
    Column column;
    Out out;
    for (std::size_t n = 0; n < sums; ++n) {
      const U<4> leaving = at.rows == K ? above.difference[n][K - 1] : U<4>(0);
      column.sum[n] = U<column_bits>(above.sum[n] + (in.difference[n] - leaving));
      for (std::size_t i = K - 1; i > 0; --i) column.difference[n][i] = above.difference[n][i - 1];
      column.difference[n][0] = in.difference[n];
    }
    const auto leaving = columns_.step(column.sum);
    const bool filled = at.column >= K;  // else it lies before the row
    for (std::size_t n = 0; n < sums; ++n) {
      out.sum[n] =
          rows_[n].step(at.row_start, U<sum_bits>(column.sum[n]), filled ? U<sum_bits>(leaving[n]) : U<sum_bits>(0));
    }
    out.mask = mask_.step(at.row_start, in.mask, above.mask, column.mask);
    out.textured = in.textured;
    out.marks = in.marks;
    memory_.write(at.column, column);
    return out;
  }

 private:
  static constexpr int column_bits = bits_for(15 * K);

  struct Column {
    std::array<std::array<U<4>, K>, sums> difference{};
    std::array<U<column_bits>, sums> sum{};
    ColumnBits<K, V> mask;
  };

  using ColumnSums = std::array<U<column_bits>, sums>;

  /// The column sums of K beats before.
  class DelayRegisters {
   public:
    ColumnSums step(const ColumnSums& value) {
      const ColumnSums oldest = values_.oldest();
      values_.push(value);
      return oldest;
    }

   private:
    DelayLine<ColumnSums, K> values_;
  };
  class DelayRam {
   public:
    ColumnSums step(const ColumnSums& value) {
      values_.begin_step();
      const ColumnSums oldest = values_.read(u<4>(place_ - lit<K>()));
      values_.write(place_, value);
      place_ += lit<1>();
      return oldest;
    }

   private:
    static constexpr int words = 16;
    RAM<ColumnSums, words, (words - K < K ? words - K : K)> values_;
    u<4> place_{0};
  };

  ColumnMemory<Column, BEATS> memory_;
  Raster<BEATS, K> raster_;
  std::conditional_t<DELAY_IN_RAM, DelayRam, DelayRegisters> columns_;
  std::array<RowSum<sum_bits, 1, V>, sums> rows_{};
  WindowAnd<K, 1, V> mask_;
};

/// For small windows registers take less than a memory of so few bits.
template <Profile P, class V = Scalar>
using Dsad = DsadSum<P.result_width(), P.hypotheses, P.dsad_window, V, P.packed() && P.dsad_window >= 9>;

}  // namespace horopter::stages
