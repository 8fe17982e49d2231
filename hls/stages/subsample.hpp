// SPDX-License-Identifier: Apache-2.0
// subsample: the mean of pixel pairs in x, so that a field's pixels are square (thesis 10.4.3); factor 1 passes
// through.
//
// In, Out   grey values of both images. Out has one beat per pair, at its second pixel: (a + b + 1) >> 1, at most 1/2
// grey
//           level above the real mean; saturated if one of the two is, mask if both are. first belongs to the pair that
//           holds the frame's first pixel. Pixel x of the result is centred on 2x + 1/2 of the input. Offset: none.
// Illegal use: a row with an odd number of beats ends with a pixel of its own, mask 0.
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

template <int FACTOR>
class Subsampler {
  static_assert(FACTOR == 1 || FACTOR == 2, "sub-sampling by 1 or 2");

 public:
  using In = GreyPair;
  struct Out {
    bool valid = false;
    std::array<u<8>, 2> pixel{};
    bool saturated = false;
    bool mask = false;
    Marks marks;
  };

  Out step(const In& in) {
    Out out;
    out.marks = in.marks;
    if constexpr (FACTOR == 1) {
      out.valid = true;
      out.pixel = in.pixel;
      out.saturated = in.saturated;
      out.mask = in.mask;
    } else {
      const bool second = second_ && !in.marks.first;
      out.valid = second || in.marks.last;
      for (std::size_t i = 0; i < 2; ++i) {
        out.pixel[i] = u<8>(shr<1>(in.pixel[i] + even_.pixel[i] + lit<1>()));
      }
      out.saturated = in.saturated || even_.saturated;
      out.mask = second && in.mask && even_.mask;
      out.marks.first = second ? even_.marks.first : in.marks.first;
      if (!second) even_ = in;
      second_ = !second && !in.marks.last;
    }
    return out;
  }

 private:
  bool second_ = false;  // the next beat is the second of its pair
  GreyPair even_;
};

template <Profile P>
using Subsample = Subsampler<P.subsample>;

}  // namespace horopter::stages
