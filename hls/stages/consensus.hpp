// SPDX-License-Identifier: Apache-2.0
// consensus: the state of a pixel is what more than half of the pixels that exist in its M×M say, up to the image's
// border.
//
// Out   state: unsupervised if there is no pixel; skin, or clear, if more than half say so; else undecidable.
// Unlike `majority` it asks no more of the window than the pixel: each voter has its own support. Marks are delayed
// with the pixel. Offset: (M − 1) / 2 rows. Memory: per column M − 1 rows of three bits. The window may leave the row:
// `sums_` restarts with each row, and for the last (M − 1) / 2 pixels of a row, which come with the first beats of the
// next one, `rest_` goes on without it.
#pragma once

#include "stages/ballot.hpp"

namespace horopter::stages {

template <int BEATS, int M, class V = Scalar>
class ConsensusVote {
  static_assert(M >= 3 && M <= 9 && M % 2 == 1, "the window is 3×3 to 9×9");

 public:
  template <int N>
  using U = typename V::template u<N>;
  using Bit = typename V::bit;

  struct In {
    Bit skin = false;
    Bit clear = false;
    Bit exists = false;
    Marks marks;
  };
  struct Out {
    U<2> state;
    Marks marks;
  };

  static constexpr int delay = (M - 1) / 2;

  Out step(const In& in) {
    memory_.begin_step();
    const auto at = raster_.step(in.marks.first, in.marks.last);
    running_ = running_ || in.marks.first;
    Column above;
    if (running_) above = memory_.read(at.column);
    if (at.frame_start_row) [[unlikely]] {
      above = Column{};
    }
    const U<M> exists_column = cat(above.exists, in.exists);
    const U<M> clear_column = cat(above.clear, in.exists && in.clear);
    const U<M> skin_column = cat(above.skin, in.exists && in.skin);
    Column column;
    column.exists = U<M - 1>(exists_column);
    column.clear = U<M - 1>(clear_column);
    column.skin = U<M - 1>(skin_column);
    if (running_) memory_.write(at.column, column);

    const Counts counts{popcount(exists_column), popcount(clear_column), popcount(skin_column)};
    const Counts leaving = columns_.oldest();
    columns_.push(counts);
    const bool early = at.column < delay;  // the centre is still in the row before
    if (at.row_start) rest_ = sums_;
    if (at.row_start) sums_ = Totals{};
    const bool filled = at.column >= M;
    advance(sums_.exists, counts.exists, leaving.exists, filled);
    advance(sums_.clear, counts.clear, leaving.clear, filled);
    advance(sums_.skin, counts.skin, leaving.skin, filled);
    rest_.exists -= leaving.exists;
    rest_.clear -= leaving.clear;
    rest_.skin -= leaving.skin;
    const Totals& total = early ? rest_ : sums_;

    const Centre centre = centres_.oldest();
    centres_.push({exists_column.bit(delay), in.marks});
    Out out;
    out.marks = centre.marks;
    const Bit skin = shl<1>(total.skin) > total.exists;
    const Bit clear = shl<1>(total.clear) > total.exists;
    const U<2> other = select(clear, U<2>(state::clear), U<2>(state::undecidable));
    out.state = select(!centre.exists, U<2>(state::unsupervised), select(skin, U<2>(state::skin), other));
    return out;
  }

 private:
  using Count = U<bits_for(M)>;
  using Total = U<bits_for(M* M)>;

  struct Counts {
    Count exists, clear, skin;
  };
  struct Totals {
    Total exists, clear, skin;
  };
  struct Centre {
    Bit exists = false;
    Marks marks;
  };
  struct Column {
    U<M - 1> exists, clear, skin;
  };

  static void advance(Total& total, Count entering, Count leaving, bool filled) {
    total += entering - (filled ? leaving : Count(0));
  }

  ColumnMemory<Column, BEATS> memory_;
  Raster<BEATS, 1> raster_;
  bool running_ = false;
  DelayLine<Counts, M> columns_;
  Totals sums_;
  Totals rest_;
  DelayLine<Centre, (M - 1) / 2> centres_;
};

template <Profile P, class V = Scalar>
using Consensus = ConsensusVote<P.result_width(), P.majority_window, V>;

}  // namespace horopter::stages
