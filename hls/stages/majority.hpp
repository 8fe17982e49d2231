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

template <int BEATS, int M>
class MajorityVote {
  static_assert(M >= 3 && M <= 9 && M % 2 == 1, "the window is 3×3 to 9×9");

 public:
  struct In {
    bool skin = false;
    bool decidable = false;
    bool mask = false;
    Marks marks;
  };
  struct Out {
    u<2> state;
    Marks marks;
  };

  Out step(const In& in) {
    memory_.begin_step();
    const auto at = raster_.step(in.marks.first, in.marks.last);
    Column above = memory_.read(at.column);
    if (at.frame_start_row) [[unlikely]] {
      above.mask = ColumnBits<M>(0);
    }
    Column column;
    const u<M> decidable = cat(above.decidable, in.decidable);
    const u<M> skin = cat(above.skin, in.decidable && in.skin);
    column.decidable = u<M - 1>(decidable);
    column.skin = u<M - 1>(skin);
    const u<2 * sum_bits> sums =
        sums_.step(at.row_start, at.column >= M, cat(u<sum_bits>(popcount(decidable)), u<sum_bits>(popcount(skin))));
    const auto decidable_sum = sums.template bits<2 * sum_bits - 1, sum_bits>();
    const auto skin_sum = sums.template bits<sum_bits - 1, 0>();
    const bool mask = mask_.step(at.row_start, in.mask, above.mask, column.mask);
    memory_.write(at.column, column);

    Out out;
    out.marks = in.marks;
    if (!mask) {
      out.state = state::unsupervised;
    } else if (decidable_sum <= lit<M * M / 2>()) {
      out.state = state::undecidable;
    } else {
      out.state = shl<1>(skin_sum) > decidable_sum ? state::skin : state::clear;
    }
    return out;
  }

 private:
  static constexpr int sum_bits = bits_for(M * M);

  struct Column {
    u<M - 1> decidable;
    u<M - 1> skin;
    ColumnBits<M> mask;
  };

  ColumnMemory<Column, BEATS> memory_;
  Raster<BEATS, 1> raster_;
  HorizontalSum<M, 2 * sum_bits> sums_;  // of decidable, of skin
  WindowAnd<M> mask_;
};

template <Profile P>
using Majority = MajorityVote<P.result_width(), P.majority_window>;

}  // namespace horopter::stages
