// SPDX-License-Identifier: Apache-2.0
// sobel: gradients of both images (thesis eq. 10.3): gx = right − left, gy = below − above, each smoothed [1 2 1]
// across.
//
// In    grey values.   Out  gx, gy: −1020 … 1020, 8 per grey level and pixel, exact.
// mask: all of the 3×3 exist. saturated: all of the 3×3 are (with the low-pass: all of 5×5 camera pixels).
// Offset: 1 row and 1 column. With GREY also the left grey value, low-passed as by `lowpass`: from the same three rows.
// Memory: per column two rows of pixels, of mask and of saturated; rows of at most BEATS and at least min_row_beats
// beats.
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

/// Gradients of LANES images.
template <int LANES, class V = Scalar>
struct Gradients {
  std::array<typename V::template s<11>, LANES> gx{};
  std::array<typename V::template s<11>, LANES> gy{};
  typename V::bit saturated = false;
  typename V::bit mask = false;
  Marks marks;
};

/// The same of both images, and the left one's grey value.
template <class V = Scalar>
struct GradientsAndGrey {
  std::array<typename V::template s<11>, 2> gx{};
  std::array<typename V::template s<11>, 2> gy{};
  typename V::template u<8> grey;
  typename V::bit saturated = false;
  typename V::bit mask = false;
  Marks marks;
};

template <int BEATS, int LANES = 2, int STRIDE = 1, class V = Scalar, bool GREY = false>
class SobelFilter {
 public:
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;

  using In = Grey<LANES, V>;
  using Out = std::conditional_t<GREY, GradientsAndGrey<V>, Gradients<LANES, V>>;

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
      const U<10> smooth = U<10>(above.before_last[i] + shl<1>(above.last[i]) + in.pixel[i]);
      const S<9> slope = in.pixel[i] - above.before_last[i];
      out.gx[i] = S<11>(smooth - smooth_[i]->tap(2 * STRIDE - 1));
      out.gy[i] = S<11>(slope + shl<1>(slope_[i]->tap(STRIDE - 1)) + slope_[i]->tap(2 * STRIDE - 1));
      if constexpr (GREY) {
        if (i == 0) {
          out.grey = U<8>(shr<4>(smooth_[i]->tap(1) + shl<1>(smooth_[i]->tap(0)) + smooth + lit<8>()));
        }
      }
      smooth_[i]->push(smooth);
      slope_[i]->push(slope);
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
  std::array<Kept<DelayLine<U<10>, 2 * STRIDE>>, LANES> smooth_{};
  std::array<Kept<DelayLine<S<9>, 2 * STRIDE>>, LANES> slope_{};
  WindowAnd<3, STRIDE, V> mask_;
  WindowAnd<3, STRIDE, V> saturated_;
};

template <Profile P, class V = Scalar>
using Sobel = SobelFilter<P.stream_beats(), P.stream_lanes(), P.stream_stride(), V>;

}  // namespace horopter::stages
