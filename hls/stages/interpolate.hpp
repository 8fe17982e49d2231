// SPDX-License-Identifier: Apache-2.0
// interpolate: 2×2 source pixels and weights → the pixel the left camera would see on the skin
// (thesis eq. 10.1, 10.4.2).
//
// In    p00 p01 / p10 p11: p<row><column> of the 2×2 right pixels;
//       wx, wy: weights of the right and lower ones in 1/2^W;
//       left: the left pixel of the same place; mask: the source exists; present: it does, of the skin or around it. A
//       pixel of weight 0 may be anything.
//       swapped_x, swapped_y: the right column comes before the left one, the lower row before the upper one.
// Out   pixel[0] = left, pixel[1] = (((2^W−wx) p00 + wx p01) (2^W−wy) + ((2^W−wx) p10 + wx p11) wy) / 2^2W,
//       rounded half up: at most 1/2 grey level from the real value.
//       saturated: the left pixel or a right one that has weight is at 0 or 255.
//       No state, offset none. No multiplier: (2^W−w)·a + w·b = a + Σ 2^i (w_i ? b : a).
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

template <int WEIGHT_BITS>
class Interpolator {
 public:
  struct In {
    u<8> p00;
    u<8> p01;
    u<8> p10;
    u<8> p11;
    u<WEIGHT_BITS> wx;
    u<WEIGHT_BITS> wy;
    bool swapped_x = false;
    bool swapped_y = false;
    u<8> left;
    bool mask = false;
    bool present = false;
    FrameMarks marks;
  };
  using Out = GreyPair;

  Out step(const In& in) {
    const u<8 + WEIGHT_BITS> upper = between(in.p00, in.p01, in.wx, in.swapped_x);
    const u<8 + WEIGHT_BITS> lower = between(in.p10, in.p11, in.wx, in.swapped_x);
    const u<8 + 2 * WEIGHT_BITS> sum = between(upper, lower, in.wy, in.swapped_y);
    Out out;
    out.pixel[0] = in.left;
    // Half a grey level at most takes 255 to 255.5, so nothing overflows.
    out.pixel[1] = u<8>(shr<2 * WEIGHT_BITS>(sum + lit<std::int64_t{1} << (2 * WEIGHT_BITS - 1)>()));
    const bool x0 = in.wx != 0 || !in.swapped_x;  // this column has weight
    const bool x1 = in.wx != 0 || in.swapped_x;
    const bool y0 = in.wy != 0 || !in.swapped_y;
    const bool y1 = in.wy != 0 || in.swapped_y;
    out.saturated = at_limit(in.left) || (x0 && y0 && at_limit(in.p00)) || (x1 && y0 && at_limit(in.p01)) ||
                    (x0 && y1 && at_limit(in.p10)) || (x1 && y1 && at_limit(in.p11));
    out.mask = in.mask;
    out.present = in.present;
    out.marks = in.marks;
    return out;
  }

 private:
  static bool at_limit(u<8> pixel) { return pixel == 0 || pixel == 255; }

  template <int N>
  static u<N + WEIGHT_BITS> between(u<N> a, u<N> b, u<WEIGHT_BITS> weight, bool swapped) {
    u<N + WEIGHT_BITS> sum = swapped ? b : a;
    for (int i = 0; i < WEIGHT_BITS; ++i) {
      const u<N> chosen = weight.bit(i) != swapped ? b : a;
      sum = u<N + WEIGHT_BITS>(sum + (u<N + WEIGHT_BITS>(chosen) << u<3>(i)));
    }
    return sum;
  }
};

template <Profile P>
using Interpolate = Interpolator<P.weight_bits>;

}  // namespace horopter::stages
