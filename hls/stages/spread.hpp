// SPDX-License-Identifier: Apache-2.0
// spread: along the row, votes reach as far as the left grey level stays alike from pixel to pixel: what an edge of an
// object decides holds for the flat area beside it, up to its other edge.
//
// Out   vote: Σ over up to 15 px to either side of ρ^distance · vote, ρ = 15/16, ended where neighbours differ by more
//       than `smooth` · 4 grey levels; / 4, clipped to ±127. 0 where there is no pixel.
//       firm, grey and exists pass through.
// Sums of 2, 4, 8 and 16 pixels from two of half the length (as many additions as doublings), each only where all of the
// nearer half are alike. Marks are delayed with the pixel. Offset: none. No memory.
#pragma once

#include "stages/contest.hpp"

namespace horopter::stages {

template <class V = Scalar>
class VoteSpread {
 public:
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;
  using Bit = typename V::bit;

  struct In {
    S<7> vote;
    Bit firm = false;
    U<6> grey;
    Bit exists = false;
    Marks marks;
  };
  struct Config {
    u<3> smooth;  // 4 grey levels
  };
  struct Out {
    S<8> vote;
    Bit firm = false;
    U<6> grey;
    Bit exists = false;
    Marks marks;
  };

  static constexpr int doublings = 4;
  static constexpr int reach = (1 << doublings) - 1;
  static constexpr int delay = reach + 1;

  Out step(const In& in, const Config& config) {
    // A pixel is known to join its right neighbour one beat later.
    const bool row_start = in.marks.first || row_ended_;
    row_ended_ = in.marks.last;
    const U<7> difference = abs(S<7>(in.grey - last_.grey));
    const Bit joined = !row_start && in.exists && last_.exists && difference <= config.smooth;
    Arms arms{Sum(last_.vote), Sum(last_.vote), joined};
    last_ = in;

    arms = doubled<1>(arms, first_);
    arms = doubled<2>(arms, second_);
    arms = doubled<4>(arms, third_);
    arms = doubled<8>(arms, fourth_);

    const In centre = centres_.oldest();
    centres_.push(in);
    const S<12> sum(arms.left + arms.right - centre.vote);
    const S<10> quarter = shr<2>(sum);
    Out out;
    out.vote = select(quarter > lit<127>(), S<8>(127), select(quarter < lit<-127>(), S<8>(-127), S<8>(quarter)));
    out.vote = select(centre.exists, out.vote, S<8>(0));
    out.firm = centre.firm;
    out.grey = centre.grey;
    out.exists = centre.exists;
    out.marks = centre.marks;
    return out;
  }

 private:
  using Sum = S<11>;  // 34 · Σ ρ^i < 512, and floors

  struct Arms {
    Sum left, right;     // of the pixel itself and those to its left, to its right
    Bit joined = false;  // from the pixel to the first beyond its right arm, all are alike
  };

  /// value · ρ^DISTANCE, rounded to a shift and a subtraction.
  template <int DISTANCE>
  static Sum faded(Sum value) {
    if constexpr (DISTANCE == 1) return Sum(value - shr<4>(value));
    if constexpr (DISTANCE == 2) return Sum(value - shr<3>(value));
    if constexpr (DISTANCE == 4) return Sum(value - shr<2>(value));
    if constexpr (DISTANCE == 8) return Sum(value - shr<1>(value) + shr<3>(value));
    return Sum(shr<1>(value) - shr<3>(value));
  }

  /// Arms of DISTANCE pixels become arms of twice as many, DISTANCE beats later.
  template <int DISTANCE>
  static Arms doubled(const Arms& right, DelayLine<Arms, 2 * DISTANCE>& line) {
    const Arms centre = line.tap(DISTANCE - 1);
    const Arms left = line.oldest();
    line.push(right);
    Arms result = centre;
    result.left = select(left.joined, Sum(centre.left + faded<DISTANCE>(left.left)), centre.left);
    result.right = select(centre.joined, Sum(centre.right + faded<DISTANCE>(right.right)), centre.right);
    result.joined = centre.joined && right.joined;
    return result;
  }

  bool row_ended_ = true;
  In last_;
  DelayLine<Arms, 2> first_;
  DelayLine<Arms, 4> second_;
  DelayLine<Arms, 8> third_;
  DelayLine<Arms, 16> fourth_;
  DelayLine<In, delay> centres_;
};

template <Profile P, class V = Scalar>
using Spread = VoteSpread<V>;

}  // namespace horopter::stages
