// SPDX-License-Identifier: Apache-2.0
// majority: M×M vote over both binary images → state of the pixel (thesis 5.2, eq. 5.4; 10.4.6).
//
// Out   state: unsupervised if a pixel of the M×M is missing (with all stages before: any pixel of the support);
//       else undecidable unless more than half of the M×M are decidable;
//       else skin if more than half of the decidable ones are in the skin, else clear.
// Only decidable pixels vote: the sum of an undecidable one is noise, and would outvote the edge it stands beside.
// Where all are decidable this is the thesis's "more than M²/2". Offset: (M − 1) / 2 rows and columns. Memory: per
// column M − 1 rows of three bits.
#pragma once

#include "stages/threshold.hpp"

namespace horopter::stages {

template <int BEATS, int M, class V = Scalar>
class MajorityVote {
  static_assert(M >= 3 && M <= 9 && M % 2 == 1, "the window is 3×3 to 9×9");

 public:
  template <int N>
  using U = typename V::template u<N>;
  using Bit = typename V::bit;

  struct In {
    Bit skin = false;
    Bit decidable = false;
    Bit mask = false;
    Marks marks;
  };
  struct Out {
    U<2> state;
    Marks marks;
  };

  Out step(const In& in) {
    memory_.begin_step();
    const auto at = raster_.step(in.marks.first, in.marks.last);
    Column above = memory_.read(at.column);
    if (at.frame_start_row) [[unlikely]] {
      above.mask = ColumnBits<M, V>(0);
    }
    Column column;
    const U<M> decidable = cat(above.decidable, in.decidable);
    const U<M> skin = cat(above.skin, in.decidable && in.skin);
    column.decidable = U<M - 1>(decidable);
    column.skin = U<M - 1>(skin);
    const U<2 * sum_bits> sums =
        sums_.step(at.row_start, at.column >= M, cat(U<sum_bits>(popcount(decidable)), U<sum_bits>(popcount(skin))));
    const auto decidable_sum = sums.template bits<2 * sum_bits - 1, sum_bits>();
    const auto skin_sum = sums.template bits<sum_bits - 1, 0>();
    const Bit mask = mask_.step(at.row_start, in.mask, above.mask, column.mask);
    memory_.write(at.column, column);

    Out out;
    out.marks = in.marks;
    const Bit decided = decidable_sum > lit<M * M / 2>();
    const U<2> vote = select(shl<1>(skin_sum) > decidable_sum, U<2>(state::skin), U<2>(state::clear));
    out.state = select(mask, select(decided, vote, U<2>(state::undecidable)), U<2>(state::unsupervised));
    return out;
  }

 private:
  static constexpr int sum_bits = bits_for(M * M);

  struct Column {
    U<M - 1> decidable;
    U<M - 1> skin;
    ColumnBits<M, V> mask;
  };

  ColumnMemory<Column, BEATS> memory_;
  Raster<BEATS, 1> raster_;
  HorizontalSum<M, 2 * sum_bits, 1, V> sums_;  // of decidable, of skin
  WindowAnd<M, 1, V> mask_;
};

template <Profile P, class V = Scalar>
using Majority = MajorityVote<P.result_width(), P.majority_window, V>;

}  // namespace horopter::stages
