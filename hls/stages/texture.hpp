// SPDX-License-Identifier: Apache-2.0
// texture: is there enough gradient in the left image around a pixel to compare directions by (thesis 9, 10.1.6)?
//
// Out   textured: sum of the left magnitude over T×T ≥ texture_limit, that is a mean of at least the texture threshold
//       with texture_limit = threshold · T². Everything else passes through.
// T = 3, the thesis's low-pass of the magnitude against its variance (10.1.6).
// Offset: `textured` belongs to the pixel DELAY rows and columns up and left, the rest has none. With DELAY = (k − 1) /
// 2 it leaves dsad together with the sum around the same pixel. (What wraps around a border is masked there.) Memory:
// per column T rows of magnitudes, their sum, and DELAY − (T − 1) / 2 bits.
#pragma once

#include "stages/difference.hpp"

namespace horopter::stages {

inline constexpr int texture_window = 3;

template <int BEATS, int HYPOTHESES, int DELAY, int T = texture_window, class V = Scalar>
class TextureDetector {
  static_assert(T % 2 == 1 && DELAY >= (T - 1) / 2, "the texture window must fit into the delay");

 public:
  template <int N>
  using U = typename V::template u<N>;
  using Bit = typename V::bit;

  static constexpr int sum_bits = bits_for(T * T * 255);

  using In = typename DirectionDifference<HYPOTHESES, V>::Out;
  struct Config {
    u<sum_bits> texture_limit;
  };
  struct Out {
    std::array<U<4>, HYPOTHESES + 1> difference{};
    Bit textured = false;
    Bit mask = false;
    Marks marks;
  };

  Out step(const In& in, const Config& config) {
    memory_.begin_step();
    const auto at = raster_.step(in.marks.first, in.marks.last);
    Column above = memory_.read(at.column);
    if (at.frame_start_row) [[unlikely]] {
      above.sum = U<column_bits>(0);
      above.textured = U<stored_bits>(0);
    }
    Column column;

    // C(y) = C(y−1) + (d(y) − d(y−T)); both terms are 0 above the frame.
    const U<8> leaving = at.rows == T ? above.magnitude[T - 1] : U<8>(0);
    column.sum = U<column_bits>(above.sum + (in.magnitude - leaving));
    for (std::size_t i = T - 1; i > 0; --i) column.magnitude[i] = above.magnitude[i - 1];
    column.magnitude[0] = in.magnitude;

    const auto sum = row_.step(at.row_start, at.column >= T, U<sum_bits>(column.sum));
    const Bit textured = sum >= config.texture_limit;

    Out out;
    out.difference = in.difference;
    out.mask = in.mask;
    out.marks = in.marks;
    if constexpr (delay_lines > 0) {
      const Bit delayed = above.textured.bit(delay_lines - 1);
      column.textured = U<delay_lines>(cat(above.textured, textured));
      out.textured = columns_.oldest();
      columns_.push(delayed);
    } else {
      out.textured = textured;
    }
    memory_.write(at.column, column);
    return out;
  }

 private:
  static constexpr int column_bits = bits_for(T * 255);
  static constexpr int delay_lines = DELAY - (T - 1) / 2;
  static constexpr int stored_bits = delay_lines > 0 ? delay_lines : 1;

  struct Column {
    std::array<U<8>, T> magnitude{};
    U<column_bits> sum;
    U<stored_bits> textured;
  };

  ColumnMemory<Column, BEATS> memory_;
  Raster<BEATS, T> raster_;
  HorizontalSum<T, sum_bits, 1, V> row_;
  DelayLine<Bit, stored_bits> columns_;
};

template <Profile P, class V = Scalar>
using Texture = TextureDetector<P.result_width(), P.hypotheses, (P.dsad_window - 1) / 2, texture_window, V>;

}  // namespace horopter::stages
