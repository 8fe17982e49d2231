// SPDX-License-Identifier: Apache-2.0
// threshold: sums → two binary images (thesis 10.4.6). No state, offset none.
//
// Config  sum_limit: ⌊p · 15·K² / 100⌋ for a threshold of p %. self_limit: see below.
// Out     skin: the sum of hypothesis 0 is at most sum_limit.
//         decidable: textured, and the self sum exceeds self_limit, so that the direction varies in the window.
// self_limit is K² by default, one level (11.25°) per pixel: directions of one constant direction differ by about that
// much through noise alone (thesis 10.4.5: mean π/16).
#pragma once

#include "stages/dsad.hpp"

namespace horopter::stages {

template <int HYPOTHESES, int K, class V = Scalar>
class SumThreshold {
 public:
  template <int N>
  using U = typename V::template u<N>;
  using Bit = typename V::bit;

  static constexpr int sum_bits = bits_for(15 * K * K);

  struct In {
    std::array<U<sum_bits>, HYPOTHESES + 1> sum{};
    Bit textured = false;
    Bit mask = false;
    Marks marks;
  };
  struct Config {
    u<sum_bits> sum_limit;
    u<sum_bits> self_limit;
  };
  struct Out {
    Bit skin = false;
    Bit decidable = false;
    Bit mask = false;
    Marks marks;
  };

  Out step(const In& in, const Config& config) {
    Out out;
    out.skin = in.sum[0] <= config.sum_limit;
    out.decidable = in.textured && in.sum[HYPOTHESES] > config.self_limit;
    out.mask = in.mask;
    out.marks = in.marks;
    return out;
  }
};

template <Profile P, class V = Scalar>
using Threshold = SumThreshold<P.hypotheses, P.dsad_window, V>;

}  // namespace horopter::stages
