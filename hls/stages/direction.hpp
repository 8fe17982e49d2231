// SPDX-License-Identifier: Apache-2.0
// direction: gradient → direction and magnitude (thesis eq. 10.9 as atan2(gy, gx), eq. 10.5, 10.4.5). No state, offset
// none.
//
// Out   direction in 1/256 turn, 0 along +x, 64 along +y (down); 0 for a zero gradient. For every gradient in
//       −1020 … 1020 the angle before rounding to 1/256 turn is less than 0.45° from the real one.
//       magnitude: max + 3/8 min, rounded, saturating at 255, in units of the unscaled Sobel magnitude (8 = 1 grey
//       level per pixel): −2.8 % … +6.8 % and 1/2 of √(gx² + gy²). It is 0 only for a zero gradient.
//
// Folded into one octant, the ratio of the smaller to the larger component is divided to 6 bits (a subtraction and a
// multiplexer each), and a table of 64 arctangents gives the angle. The thesis scales both gradients together to shrink
// its table; a quotient needs no scaling, loses nothing to it, and costs no shifters.
#pragma once

#include "horopter/hls/tables.hpp"
#include "stages/sobel.hpp"

namespace horopter::stages {

/// Directions and magnitudes of LANES images.
template <int LANES, class V = Scalar>
struct Directions {
  std::array<typename V::template u<8>, LANES> direction{};
  std::array<typename V::template u<8>, LANES> magnitude{};
  typename V::bit saturated = false;
  typename V::bit mask = false;
  Marks marks;
};

template <int LANES = 2, class V = Scalar>
class DirectionFinder {
 public:
  template <int N>
  using U = typename V::template u<N>;
  using Bit = typename V::bit;

  using In = Gradients<LANES, V>;
  using Out = Directions<LANES, V>;

  Out step(const In& in) {
    Out out;
    for (std::size_t i = 0; i < LANES; ++i) {
      const U<10> x = U<10>(abs(in.gx[i]));
      const U<10> y = U<10>(abs(in.gy[i]));
      const Bit steep = y > x;
      const U<10> larger = select(steep, y, x);
      const U<10> smaller = select(steep, x, y);
      out.direction[i] = unfold(octant_angle(smaller, larger), in.gx[i].negative(), in.gy[i].negative(), steep);
      out.magnitude[i] = sat<8>(larger + shr<3>(smaller + shl<1>(smaller) + lit<4>()));
    }
    out.saturated = in.saturated;
    out.mask = in.mask;
    out.marks = in.marks;
    return out;
  }

 private:
  static constexpr int quotient_bits = 6;

  /// arctan(smaller / larger) in 1/256 turn, 0 … 32.
  static U<6> octant_angle(U<10> smaller, U<10> larger) {
    return lookup(arctangent_table<quotient_bits>, ratio<quotient_bits>(smaller, larger));
  }

  /// Multiple of a quarter turn, plus or minus the angle from its axis.
  static U<8> unfold(U<6> angle, Bit left, Bit up, Bit steep) {
    const Bit backwards = left != (up != steep);
    const U<8> axis = shl<6>(cat(select(steep, U<1>(up), U<1>(left)), steep));
    return select(backwards, U<8>(axis - angle), U<8>(axis + angle));
  }
};

template <Profile P, class V = Scalar>
using Direction = DirectionFinder<P.stream_lanes(), V>;

}  // namespace horopter::stages
