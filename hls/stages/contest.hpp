// SPDX-License-Identifier: Apache-2.0
// contest: which plane is the best, and by how much: the pixel's vote for or against the skin. No state, offset none.
//
// The skin is what lies nearer to the planes −1, 0, 1 than to any other: z = min T(outside) − min T(−1, 0, 1).
// Sub-pixel boundary: where the best is +1, z = min(z, T(2) − T(1) − 3/4 · (T(0) − T(1))), mirrored for −1: the
// parabola through three planes has its minimum nearer to the skin than the boundary when this is positive. Ambiguity:
// a plane 3 px away or more within 1/16 of the best makes z the lowest: what repeats is not in the skin. Out   vote: z
// / 8, clipped to ±31, plus `bias` unless 0: a pixel that prefers nothing does not vote. 0 where not valid.
#pragma once

#include "stages/plane_paths.hpp"

namespace horopter::stages {

template <int BEATS, const auto& PLANES, int K, class V = Scalar>
class PlaneContest {
 public:
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;
  using Bit = typename V::bit;

  static constexpr std::size_t planes = PLANES.count;
  static constexpr int cost_bits = PlanePaths<BEATS, PLANES, K, V>::cost_bits;
  static constexpr int largest_vote = 31;

  using In = typename PlanePaths<BEATS, PLANES, K, V>::Out;
  struct Config {
    u<4> bias;
  };
  struct Out {
    S<7> vote;
    U<6> grey;
    Bit exists = false;
    Marks marks;
  };

  Out step(const In& in, const Config& config) {
    constexpr std::size_t zero = PLANES.zero;
    const auto& t = in.cost;
    const U<cost_bits> far = min(smallest(t, 0, zero - 2), smallest(t, zero + 3, planes));
    const U<cost_bits> outside = min(far, min(t[zero - 2], t[zero + 2]));
    const U<cost_bits> inside = min(t[zero], min(t[zero - 1], t[zero + 1]));
    using Z = S<cost_bits + 3>;
    Z z(outside - inside);
    z = select(t[zero + 1] < t[zero] && t[zero + 1] < t[zero - 1],
               least(z, boundary(t[zero], t[zero + 1], t[zero + 2])), z);
    z = select(t[zero - 1] < t[zero] && t[zero - 1] <= t[zero + 1],
               least(z, boundary(t[zero], t[zero - 1], t[zero - 2])), z);
    const Bit ambiguous = inside <= outside && far < inside + shr<4>(inside);

    const S<cost_bits> eighth = shr<3>(z);
    const S<6> lowest(S<6>(U<5>(0)) - lit<largest_vote>());
    S<6> clipped = select(eighth > lit<largest_vote>(), S<6>(U<5>(largest_vote)), S<6>(eighth));
    clipped = select(eighth < lit<-largest_vote>() || ambiguous, lowest, clipped);
    const Bit votes = in.valid && !(clipped == lit<0>());

    Out out;
    out.vote = select(votes, S<7>(clipped + config.bias), S<7>(U<5>(0)));
    out.grey = in.grey;
    out.exists = in.exists;
    out.marks = in.marks;
    return out;
  }

 private:
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
};

}  // namespace horopter::stages
