// SPDX-License-Identifier: Apache-2.0
// contest: which plane is the best, and by how much: the pixel's vote for or against the skin.
//
// The skin is what lies nearer to the planes −1, 0, 1 than to any other: z = min T(outside) − min T(−1, 0, 1).
//
// Sub-pixel boundary: where the best is +1, z = min(z, (n · b − (14 − n) · a) / 8) with b = T(2) − T(1), a = T(0) −
// T(1), mirrored for −1, n the setting `boundary`, 0 … 14: the parabola through three planes has its minimum nearer to
// the skin than 1/2 + n/14 px when this is positive. Both terms are rounded down.
//
// From the right: the same question asked by the right pixel, T(s) of the left pixels s columns further right. Where it
// prefers a plane outside, the left pixel sees what is hidden to the right camera, or is wrong: its vote is at most −8.
//
// Out   vote: z / 8, clipped to ±31, plus `bias`. 0, no vote: where not evident, where nothing is preferred (z / 8 =
//       0), and where something repeats (the skin is best, but a plane 3 px away or more within 1/16 of it).
// firm: it votes, is strong (plane_paths), and z ≤ −512: this alone is enough not to leave the pixel undecided.
// Marks are delayed with the pixel, by the reach of the planes. Offset: none. No memory.
#pragma once

#include <algorithm>

#include "stages/plane_paths.hpp"

namespace horopter::stages {

template <int BEATS, const auto& PLANES, int ROWS, int COLUMNS, bool PATHS, class V = Scalar>
class PlaneContest {
 public:
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;
  using Bit = typename V::bit;

  static constexpr std::size_t planes = PLANES.count;
  static constexpr int cost_bits = PlanePaths<BEATS, PLANES, ROWS, COLUMNS, PATHS, V>::cost_bits;
  static constexpr int largest_vote = 31;
  static constexpr int hidden_vote = 8;
  static constexpr int firm_z = -512;

  using In = typename PlanePaths<BEATS, PLANES, ROWS, COLUMNS, PATHS, V>::Out;
  struct Config {
    u<4> bias;
    u<4> boundary;  // 15 is as 14
  };
  static constexpr int delay = PLANES.reach();
  struct Out {
    S<7> vote;
    Bit firm = false;
    U<6> grey;
    Bit exists = false;
    Marks marks;
  };

  Out step(const In& in, const Config& config) {
    const bool row_start = in.marks.first || row_ended_;
    row_ended_ = in.marks.last;
    const Bit hidden = seen_from_right(in, row_start);
    const Vote vote = centres_.oldest();
    centres_.push(vote_of(in, config.boundary));

    const S<6> clipped = select(hidden && vote.clipped > lit<-hidden_vote>(), S<6>(-hidden_vote), vote.clipped);
    Out out;
    const Bit votes = vote.votes && !(clipped == lit<0>());
    out.vote = select(votes, S<7>(clipped + config.bias), S<7>(0));
    out.firm = votes && vote.firm;
    out.grey = vote.grey;
    out.exists = vote.exists;
    out.marks = vote.marks;
    return out;
  }

 private:
  using Cost = U<cost_bits>;
  using Costs = std::array<Cost, planes>;
  static constexpr std::size_t zero = PLANES.zero;

  struct Vote {
    S<6> clipped;
    Bit votes = false;
    Bit firm = false;
    U<6> grey;
    Bit exists = false;
    Marks marks;
  };
  struct Seen {
    Cost inside;
    Bit hidden = false;
  };

  /// What the pixel says by itself.
  static Vote vote_of(const In& in, u<4> at) {
    const auto& t = in.cost;
    const Cost far = min(PLANES.smallest(t, 0, zero - 2), PLANES.smallest(t, zero + 3, planes));
    const Cost outside = min(far, min(t[zero - 2], t[zero + 2]));
    const Cost beside = min(t[zero - 1], t[zero + 1]);
    const Cost inside = min(t[zero], beside);
    const Cost outer = select(t[zero + 1] < t[zero - 1], t[zero + 2], t[zero - 2]);
    using Z = S<cost_bits + 4>;
    Z z(outside - inside);
    z = select(beside < t[zero], least(z, boundary(t[zero], beside, outer, at)), z);
    const Bit repeats = inside <= outside && far < inside + shr<4>(inside);

    const S<cost_bits + 1> eighth = shr<3>(z);
    Vote vote;
    vote.clipped = select(eighth > lit<largest_vote>(), S<6>(largest_vote), S<6>(eighth));
    vote.clipped = select(eighth < lit<-largest_vote>(), S<6>(-largest_vote), vote.clipped);
    vote.votes = in.evident && !repeats;
    vote.firm = in.strong && z <= lit<firm_z>();
    vote.grey = in.grey;
    vote.exists = in.exists;
    vote.marks = in.marks;
    return vote;
  }

  /// Of the pixel PLANES.reach() columns to the left, in whose row all that it saw has come by now: does it prefer a
  /// plane outside? The pixel at x is seen in plane s by the one at x − s: instead of the costs of all planes, the
  /// smallest so far travels along with the pixel that sees them: outside, until it has seen the planes −1, 0, 1, then
  /// of these.
  Bit seen_from_right(const In& in, bool row_start) {
    constexpr int reach = PLANES.reach();
    outside_.push(Cost::max());
    if (row_start) {  // what the row before showed to this row's pixels
      for (int i = 0; i <= reach; ++i) outside_.at(i) = Cost::max();
      inside_next_ = Cost::max();
      columns_ = u<bits_for(reach)>(0);
    }
    const auto cost = [&](std::size_t n) {
      return select(in.known && Bit(columns_ >= std::max(PLANES.shift[n], 0)), in.cost[n], Cost::max());
    };
    for (std::size_t n = 0; n + 1 < zero; ++n) {
      Cost& smallest = outside_.at(reach + PLANES.shift[n]);  // of x − s
      smallest = min(smallest, cost(n));
    }
    seen_.push({min(inside_here_, cost(zero + 1)), false});
    Seen& left = seen_.at(0);  // x − 1
    left.hidden = outside_.oldest() < left.inside;
    inside_here_ = min(inside_next_, cost(zero));
    inside_next_ = cost(zero - 1);
    for (std::size_t n = zero + 2; n < planes; ++n) {
      Seen& other = seen_.at(PLANES.shift[n] - 1);  // x − s
      other.hidden = other.hidden || cost(n) < other.inside;
    }
    columns_ += u<1>(columns_ != reach);
    return seen_.oldest().hidden;
  }

  template <class T>
  static T least(T a, T b) {
    return select(a < b, a, b);
  }

  /// (n · (T(outer) − T(best)) − (14 − n) · (T(centre) − T(best))) / 8, both terms rounded down.
  static S<cost_bits + 4> boundary(Cost centre, Cost best, Cost outer, u<4> n) {
    const u<4> rest = n == 15 ? u<4>(0) : u<4>(lit<14>() - n);
    return S<cost_bits + 4>(eighths(n, outer - best) + eighths(rest, best - centre));
  }

  /// ⌊factor · value / 8⌋, without a multiplier.
  static S<cost_bits + 3> eighths(u<4> factor, S<cost_bits + 1> value) {
    const auto part = [&](int bit) { return select(Bit(factor.bit(bit)), value, S<cost_bits + 1>(0)); };
    const auto low = part(0) + shl<1>(part(1));
    const auto high = part(2) + shl<1>(part(3));
    return S<cost_bits + 3>(shr<1>(shr<2>(low) + high));
  }

  bool row_ended_ = true;
  u<bits_for(PLANES.reach())> columns_{0};       // of this row to the left, at most the reach
  DelayLine<Cost, PLANES.reach() + 2> outside_;  // smallest of the planes outside, of the pixels x + reach … x − 1
  Cost inside_next_;                             // smallest of the planes −1, 0, 1, of x + 1,
  Cost inside_here_;                             // of x,
  DelayLine<Seen, PLANES.reach()> seen_;         // of x − 1 … x − reach
  DelayLine<Vote, PLANES.reach()> centres_;
};

template <Profile P, class V = Scalar>
using Contest = PlaneContest<P.result_width(), planes_of<P.planes>, P.sum_rows, P.sum_columns, P.paths, V>;

}  // namespace horopter::stages
