// SPDX-License-Identifier: Apache-2.0
// contest: which plane is the best, and by how much: the pixel's vote for or against the skin.
//
// The skin is what lies nearer to the planes −1, 0, 1 than to any other: z = min T(outside) − min T(−1, 0, 1).
//
// Sub-pixel boundary: where the best is +1, z = min(z, T(2) − T(1) − 3/4 · (T(0) − T(1))), mirrored for −1: the
// parabola through three planes has its minimum nearer to the skin than the boundary when this is positive.
//
// From the right: the same question asked by the right pixel, T(s) of the left pixels s columns further right. Where it
// prefers a plane outside, the left pixel sees what is hidden to the right camera, or is wrong: its vote is at most −8.
//
// Out   vote: z / 8, clipped to ±31, plus `bias`. 0, no vote: where not evident, where nothing is preferred (z / 8 =
//       0), and where something repeats (the skin is best, but a plane 3 px away or more within 1/16 of it).
// firm: it votes, evidence is strong, and z ≤ −512: this alone is enough not to leave the pixel undecided.
// Marks are delayed with the pixel, by the reach of the planes. Offset: none. No memory.
#pragma once

#include "stages/plane_paths.hpp"

namespace horopter::stages {

template <int BEATS, const auto& PLANES, int ROWS, int COLUMNS, class V = Scalar>
class PlaneContest {
 public:
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;
  using Bit = typename V::bit;

  static constexpr std::size_t planes = PLANES.count;
  static constexpr int cost_bits = PlanePaths<BEATS, PLANES, ROWS, COLUMNS, V>::cost_bits;
  static constexpr int largest_vote = 31;
  static constexpr int hidden_vote = 8;
  static constexpr int firm_z = -512;

  using In = typename PlanePaths<BEATS, PLANES, ROWS, COLUMNS, V>::Out;
  struct Config {
    u<4> bias;
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
    constexpr std::size_t zero = PLANES.zero;
    const bool row_start = in.marks.first || row_ended_;
    row_ended_ = in.marks.last;
    if (row_start) row_parity_ = !row_parity_;
    line_.push({in, row_parity_});
    const Beat& centre = line_.tap(PLANES.reach());
    const auto& t = centre.left.cost;
    std::array<U<cost_bits>, planes> seen_from_right;
    for (std::size_t n = 0; n < planes; ++n) {
      const Beat& beat = line_.tap(PLANES.reach() - PLANES.shift[n]);
      seen_from_right[n] =
          select(beat.left.known && Bit(beat.row == centre.row), beat.left.cost[n], U<cost_bits>::max());
    }
    const Bit hidden = outside_of(seen_from_right) < inside_of(seen_from_right);
    const U<cost_bits> far = min(smallest(t, 0, zero - 2), smallest(t, zero + 3, planes));
    const U<cost_bits> outside = min(far, min(t[zero - 2], t[zero + 2]));
    const U<cost_bits> inside = inside_of(t);
    using Z = S<cost_bits + 3>;
    Z z(outside - inside);
    z = select(t[zero + 1] < t[zero] && t[zero + 1] < t[zero - 1],
               least(z, boundary(t[zero], t[zero + 1], t[zero + 2])), z);
    z = select(t[zero - 1] < t[zero] && t[zero - 1] <= t[zero + 1],
               least(z, boundary(t[zero], t[zero - 1], t[zero - 2])), z);
    const Bit repeats = inside <= outside && far < inside + shr<4>(inside);

    const S<cost_bits> eighth = shr<3>(z);
    const S<6> lowest(S<6>(U<5>(0)) - lit<largest_vote>());
    S<6> clipped = select(eighth > lit<largest_vote>(), S<6>(U<5>(largest_vote)), S<6>(eighth));
    clipped = select(eighth < lit<-largest_vote>(), lowest, clipped);
    clipped = select(hidden && clipped > lit<-hidden_vote>(), S<6>(S<6>(U<5>(0)) - lit<hidden_vote>()), clipped);
    const Bit votes = centre.left.evident && !repeats && !(clipped == lit<0>());

    Out out;
    out.vote = select(votes, S<7>(clipped + config.bias), S<7>(U<5>(0)));
    out.firm = votes && centre.left.strong && z <= lit<firm_z>();
    out.grey = centre.left.grey;
    out.exists = centre.left.exists;
    out.marks = centre.left.marks;
    return out;
  }

 private:
  using Costs = std::array<U<cost_bits>, planes>;
  struct Beat {
    In left;
    bool row = false;
  };

  static U<cost_bits> inside_of(const Costs& t) {
    return min(t[PLANES.zero], min(t[PLANES.zero - 1], t[PLANES.zero + 1]));
  }
  static U<cost_bits> outside_of(const Costs& t) {
    return min(smallest(t, 0, PLANES.zero - 1), smallest(t, PLANES.zero + 2, planes));
  }

  template <class T>
  static T least(T a, T b) {
    return select(a < b, a, b);
  }

  /// T(outer) − T(best) − 3/4 · (T(centre) − T(best)).
  static S<cost_bits + 3> boundary(U<cost_bits> centre, U<cost_bits> best, U<cost_bits> outer) {
    const S<cost_bits + 1> inner(centre - best);
    return S<cost_bits + 3>(outer - best - (inner - shr<2>(inner)));
  }

  static U<cost_bits> smallest(const std::array<U<cost_bits>, planes>& costs, std::size_t begin, std::size_t end) {
    std::array<U<cost_bits>, planes> best = costs;
    std::size_t n = end - begin;
    for (std::size_t i = 0; i < n; ++i) best[i] = costs[begin + i];
    for (; n > 1; n = (n + 1) / 2) {
      for (std::size_t i = 0; i < n / 2; ++i) best[i] = min(best[2 * i], best[2 * i + 1]);
      if (n % 2 == 1) best[n / 2] = best[n - 1];
    }
    return best[0];
  }

  DelayLine<Beat, 2 * PLANES.reach() + 1> line_;
  bool row_ended_ = true;
  bool row_parity_ = false;
};

}  // namespace horopter::stages
