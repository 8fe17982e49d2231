// SPDX-License-Identifier: Apache-2.0
// dsad: sum of the direction differences over K×K (thesis 10.1.5, 10.4.5), for each hypothesis and the self difference.
//
// Out   sum[n], 0 … 15·K², exact. mask: all of the K×K exist. textured passes through, see texture.
// Running sums: per column C(y) = C(y−1) + (d(y) − d(y−K)), along the row S(x) = S(x−1) + (C(x) − C(x−K)). They start
// anew with each frame and row, so an upset bit of memory is gone with the frame. Offset: (K − 1) / 2 rows and columns.
// Memory: per column K rows of 4-bit differences and their sum for each n, and K − 1 bits of mask.
#pragma once

#include "stages/texture.hpp"

namespace horopter::stages {

template <int BEATS, int HYPOTHESES, int K>
class DsadSum {
  static_assert(K >= 5 && K <= 13 && K % 2 == 1, "the window is 5×5 to 13×13");

 public:
  static constexpr int sum_bits = bits_for(15 * K * K);
  static constexpr std::size_t sums = HYPOTHESES + 1;

  struct In {
    std::array<u<4>, sums> difference{};
    bool textured = false;
    bool mask = false;
    Marks marks;
  };
  struct Out {
    std::array<u<sum_bits>, sums> sum{};
    bool textured = false;
    bool mask = false;
    Marks marks;
  };

  Out step(const In& in) {
    memory_.begin_step();
    const auto at = raster_.step(in.marks.first, in.marks.last);
    Column above = memory_.read(at.column);
    if (at.frame_start_row) [[unlikely]] {
      above.mask = ColumnBits<K>(0);
      for (auto& sum : above.sum) sum = u<2 * column_bits>(0);
    }
    Column column;
    Out out;
    for (std::size_t w = 0; w < words; ++w) {
      const std::size_t low = 2 * w;
      const std::size_t high = low + 1 < sums ? low + 1 : low;  // an odd number of sums: the last stands twice
      const u<8> arriving = cat(in.difference[high], in.difference[low]);
      const u<8> leaving = at.rows == K ? above.difference[w][K - 1] : u<8>(0);
      column.sum[w] = u<2 * column_bits>(above.sum[w] + (spread<column_bits>(arriving) - spread<column_bits>(leaving)));
      for (std::size_t i = K - 1; i > 0; --i) column.difference[w][i] = above.difference[w][i - 1];
      column.difference[w][0] = arriving;
      const u<2 * sum_bits> sum = rows_[w].step(at.row_start, at.column >= K, spread<sum_bits>(column.sum[w]));
      out.sum[low] = sum.template bits<sum_bits - 1, 0>();
      out.sum[high] = sum.template bits<2 * sum_bits - 1, sum_bits>();
    }
    out.mask = mask_.step(at.row_start, in.mask, above.mask, column.mask);
    out.textured = in.textured;
    out.marks = in.marks;
    memory_.write(at.column, column);
    return out;
  }

 private:
  static constexpr int column_bits = bits_for(15 * K);
  static constexpr std::size_t words = (sums + 1) / 2;  // two sums side by side share an adder

  /// Two fields of half the bits each, moved apart to fields of BITS.
  template <int BITS, int N>
  static u<2 * BITS> spread(u<N> pair) {
    return cat(u<BITS>(pair.template bits<N - 1, N / 2>()), u<BITS>(pair.template bits<N / 2 - 1, 0>()));
  }

  struct Column {
    std::array<std::array<u<8>, K>, words> difference{};
    std::array<u<2 * column_bits>, words> sum{};
    ColumnBits<K> mask;
  };

  ColumnMemory<Column, BEATS> memory_;
  Raster<BEATS, K> raster_;
  std::array<HorizontalSum<K, 2 * sum_bits>, words> rows_{};
  WindowAnd<K> mask_;
};

template <Profile P>
using Dsad = DsadSum<P.result_width(), P.hypotheses, P.dsad_window>;

}  // namespace horopter::stages
