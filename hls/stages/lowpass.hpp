// SPDX-License-Identifier: Apache-2.0
// lowpass: 3×3 [1 2 1]ᵀ[1 2 1] / 16 against noise (thesis eq. 10.2, 10.8), columns first, then rows.
//
// In, Out   grey values; out is rounded half up, at most 1/2 grey level from the real value.
//           mask: all of the 3×3 exist. saturated: all of the 3×3 are, so nothing of what was there is left; a window
//           that is clipped in part still shows where the clipped part ends.
// Offset: 1 row and 1 column (the window ends at the current pixel).
// Memory: per column two rows of pixels, of mask and of saturated; rows of at most BEATS and at least min_row_beats
// beats.
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

template <int BEATS, int LANES = 2, int STRIDE = 1, class V = Scalar>
class LowpassFilter {
 public:
  template <int N>
  using U = typename V::template u<N>;

  using In = Grey<LANES, V>;
  using Out = Grey<LANES, V>;

  Out step(const In& in) {
    memory_.begin_step();
    const auto at = raster_.step(in.marks.first, in.marks.last);
    Column above = memory_.read(at.column);
    if (at.frame_start_row) [[unlikely]] {
      above.mask = above.saturated = ColumnBits<3, V>(0);
    }
    Column column;
    Out out;
    for (std::size_t i = 0; i < LANES; ++i) {
      const U<10> sum = U<10>(above.before_last[i] + shl<1>(above.last[i]) + in.pixel[i]);
      const U<10> left = columns_[i]->tap(STRIDE - 1);
      const U<10> left2 = columns_[i]->tap(2 * STRIDE - 1);
      out.pixel[i] = U<8>(shr<4>(left2 + shl<1>(left) + sum + lit<8>()));
      columns_[i]->push(sum);
      column.before_last[i] = above.last[i];
      column.last[i] = in.pixel[i];
    }
    out.mask = mask_.step(at.row_start, in.mask, above.mask, column.mask);
    out.saturated = saturated_.step(at.row_start, in.saturated, above.saturated, column.saturated);
    out.marks = in.marks;
    memory_.write(at.column, column);
    return out;
  }

 private:
  struct Column {
    std::array<U<8>, LANES> last{};
    std::array<U<8>, LANES> before_last{};
    ColumnBits<3, V> mask;
    ColumnBits<3, V> saturated;
  };

  ColumnMemory<Column, BEATS> memory_;
  Raster<BEATS, 1> raster_;
  std::array<Kept<DelayLine<U<10>, 2 * STRIDE>>, LANES> columns_{};
  WindowAnd<3, STRIDE, V> mask_;
  WindowAnd<3, STRIDE, V> saturated_;
};

template <Profile P, class V = Scalar>
using Lowpass = LowpassFilter<P.stream_beats(), P.stream_lanes(), P.stream_stride(), V>;

}  // namespace horopter::stages
