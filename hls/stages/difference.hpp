// SPDX-License-Identifier: Apache-2.0
// difference: cyclic difference of directions, 4 bit (thesis eq. 10.4, 10.4.5), for N hypotheses and for the left image
// against itself.
//
// Out   difference[n], n < N: left against right shifted by n px,
//       min(|Δ|, 256 − |Δ|, 127) >> 3, that is 0 … 15 of 11.25°.
//       difference[N]: left against left `self_shift` px further left. Summed over the window it tells whether a
//       displacement along x could be noticed at all: where the direction does not vary, as on a ramp of brightness or
//       along a horizontal edge, every hypothesis fits (thesis 9.1, 11.2.3).
//       magnitude: of the left gradient for the texture: 0 where saturated (see lowpass, sobel), for a gradient
//       measured wholly on clipped pixels is no texture, in whichever image.
// A zero gradient has no direction, and atan2's 0 for it would take a flat area for a match of every edge that runs
// from dark to bright in +x. Against a real direction it counts 8, the mean over all directions: an edge differs from a
// flat area even without noise. Two of them say nothing: 4 in a hypothesis, the default threshold's share (25 % of 15)
// of a pixel, so that the others decide; 0 in the self difference, as flat is not varied. A pixel before the start of
// the row or outside the mask counts 15 in a shifted hypothesis and 0 in the self difference: neither may make it look
// better. Offset: none.
#pragma once

#include <type_traits>

#include "stages/direction.hpp"

namespace horopter::stages {

/// Half of the default 9×9 window, and about the support of one gradient (5 px), so that the two are nearly
/// independent.
inline constexpr int self_shift = 4;

template <int HYPOTHESES, class V = Scalar>
class DirectionDifference {
  static_assert(HYPOTHESES >= 1 && HYPOTHESES <= 64);

 public:
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;
  using Bit = typename V::bit;

  using In = Directions<2, V>;
  struct Out {
    std::array<U<4>, HYPOTHESES + 1> difference{};
    U<8> magnitude;
    Bit mask = false;
    Marks marks;
  };

  Out step(const In& in) { return step(in, true); }

  /// Not `taken`: nothing is remembered, and the result means nothing.
  Out step(const In& in, bool taken) {
    const bool row_start = in.marks.first || row_ended_;
    if (taken && row_start) {
      for (int i = 0; i < self_shift; ++i) (*left_)[i].exists = false;
      for (int i = 0; i < HYPOTHESES; ++i) (*right_)[i].exists = false;
    }
    const Gradient left{in.direction[0], in.magnitude[0] != 0, in.mask};
    const Gradient right{in.direction[1], in.magnitude[1] != 0, in.mask};

    Out out;
    out.difference[0] = between(left, right, U<4>(4));
    for (int n = 1; n < HYPOTHESES; ++n) {
      const Gradient& shifted = (*right_)[n - 1];
      out.difference[static_cast<std::size_t>(n)] = select(shifted.exists, between(left, shifted, U<4>(4)), U<4>(15));
    }
    const Gradient& before = (*left_)[self_shift - 1];
    out.difference[HYPOTHESES] = select(before.exists, between(left, before, U<4>(0)), U<4>(0));
    out.magnitude = select(in.saturated, U<8>(0), in.magnitude[0]);
    out.mask = in.mask;
    out.marks = in.marks;

    if (taken) {
      row_ended_ = in.marks.last;
      for (int i = self_shift - 1; i > 0; --i) (*left_)[i] = (*left_)[i - 1];
      (*left_)[0] = left;
      if constexpr (HYPOTHESES > 1) {
        for (int i = HYPOTHESES - 1; i > 0; --i) (*right_)[i] = (*right_)[i - 1];
        (*right_)[0] = right;
      }
    }
    return out;
  }

 private:
  struct Gradient {
    U<8> direction;
    Bit has_direction = false;
    Bit exists = false;
  };

  static U<4> between(const Gradient& a, const Gradient& b, U<4> neither) {
    // Modulo 256; the sign bit tells which way round is shorter. −128 stays 128 and is clipped to 127.
    const S<8> turn(a.direction - b.direction);
    const U<8> shortest = abs(turn);
    const U<4> level = select(shortest.bit(7), U<4>(15), shortest.template bits<6, 3>());
    const U<4> without = select(a.has_direction || b.has_direction, U<4>(8), neither);
    return select(a.has_direction && b.has_direction, level, without);
  }

  bool row_ended_ = true;
  Kept<std::array<Gradient, self_shift>> left_;
  Kept<std::array<Gradient, HYPOTHESES>> right_;
};

/// The same behind a packed stream: the pair is complete with the right image's beat.
template <int HYPOTHESES>
class UnpackingDifference {
 public:
  using In = Directions<1>;
  struct Out {
    bool valid = false;
    std::array<u<4>, HYPOTHESES + 1> difference{};
    u<8> magnitude;
    bool mask = false;
    Marks marks;
  };

  Out step(const In& in) {
    const bool second = second_ && !in.marks.first;
    Directions<2> pair;
    pair.direction = {left_->direction[0], in.direction[0]};
    pair.magnitude = {left_->magnitude[0], in.magnitude[0]};
    pair.saturated = in.saturated;  // of both images, in both beats
    pair.mask = in.mask;
    pair.marks = in.marks;
    pair.marks.first = left_->marks.first;
    const auto result = difference_.step(pair, second);
    if (!second) *left_ = in;
    second_ = !second;
    return {second, result.difference, result.magnitude, result.mask, result.marks};
  }

 private:
  DirectionDifference<HYPOTHESES> difference_;
  Kept<Directions<1>> left_;
  bool second_ = false;  // the next beat is the right image's
};

template <Profile P, class V = Scalar>
using Difference =
    std::conditional_t<P.packed(), UnpackingDifference<P.hypotheses>, DirectionDifference<P.hypotheses, V>>;

}  // namespace horopter::stages
