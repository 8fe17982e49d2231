// SPDX-License-Identifier: Apache-2.0
// dim: the images as half of the light would show them, while the machine is taught what it cannot decide (`blind`). What
// is decided by a narrow margin in good light would become blind with the first cloud: it has to be taught, too.
//
// In    grey values, behind `agreement`, which judges the cameras by what they see.
// Out   pixel: with `dim` 64 + pixel / 2, rounded down: half the contrast, neither black nor white. The rest passes.
//       No state, offset none.
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

template <int LANES>
class HalfLight {
 public:
  using In = Grey<LANES>;
  using Out = Grey<LANES>;
  struct Config {
    u<1> dim;
  };

  static u<8> dimmed(u<8> pixel) { return u<8>(lit<64>() + shr<1>(pixel)); }

  Out step(const In& in, const Config& config) {
    Out out = in;
    for (std::size_t i = 0; i < LANES; ++i) out.pixel[i] = config.dim != 0 ? dimmed(in.pixel[i]) : in.pixel[i];
    return out;
  }
};

template <Profile P>
using Dim = HalfLight<P.stream_lanes()>;

}  // namespace horopter::stages
