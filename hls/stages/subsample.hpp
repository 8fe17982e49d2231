// SPDX-License-Identifier: Apache-2.0
// subsample: the mean of pixel pairs in x, so that a field's pixels are square (thesis 10.4.3); factor 1 passes
// through.
//
// In, Out   grey values of both images; the left image's come as means of the pair, from the store.
//           Out has one beat per pair, at its second pixel: left as it came, right (a + b + 1) >> 1, at most 1/2 grey
//           level above the real mean; saturated if one of the two beats is, mask and present if both are.
//           first belongs to the pair that holds the frame's first pixel.
//           Pixel x of the result is centred on 2x + 1/2 of the input. Offset: none.
// Illegal use: a row with an odd number of beats ends with a pixel of its own, mask and present 0.
#pragma once

#include <type_traits>

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
    bool present = false;
    FrameMarks marks;
  };

  Out step(const In& in) {
    Out out;
    out.marks = in.marks;
    if constexpr (FACTOR == 1) {
      out.valid = true;
      out.pixel = in.pixel;
      out.saturated = in.saturated;
      out.mask = in.mask;
      out.present = in.present;
    } else {
      const bool second = second_ && !in.marks.first;
      out.valid = second || in.marks.last;
      out.pixel[0] = in.pixel[0];
      out.pixel[1] = u<8>(shr<1>(in.pixel[1] + even_->pixel[1] + lit<1>()));
      out.saturated = in.saturated || even_->saturated;
      out.mask = second && in.mask && even_->mask;
      out.present = second && in.present && even_->present;
      out.marks.first = second ? even_->marks.first : in.marks.first;
      if (!second) *even_ = in;
      second_ = !second && !in.marks.last;
    }
    return out;
  }

 private:
  bool second_ = false;  // the next beat is the second of its pair
  Kept<GreyPair> even_;
};

/// The same means, packed: the left image's leaves with the pair's second pixel, the right image's with the beat after
/// it. Illegal use: a row with an odd number of beats loses its last pixel.
class PackingSubsampler {
 public:
  using In = GreyPair;
  struct Out {
    bool valid = false;
    std::array<u<8>, 1> pixel{};
    bool saturated = false;
    bool mask = false;
    bool present = false;
    FrameMarks marks;
  };

  Out step(const In& in) {
    const bool second = second_ && !in.marks.first;
    const bool saturated = in.saturated || kept_->saturated;
    const bool mask = in.mask && kept_->mask;
    const bool present = in.present && kept_->present;
    Out out;
    out.valid = second || right_waits_;
    out.pixel[0] = second ? in.pixel[0] : kept_->pixel[1];
    out.saturated = second ? saturated : kept_->saturated;
    out.mask = second ? mask : kept_->mask;
    out.present = second ? present : kept_->present;
    out.marks.first = second && kept_->marks.first;
    out.marks.last = !second && (kept_->marks.last || in.marks.last);

    const u<8> right = second ? u<8>(shr<1>(in.pixel[1] + kept_->pixel[1] + lit<1>())) : in.pixel[1];
    *kept_ = in;
    kept_->pixel[1] = right;
    if (second) {
      kept_->saturated = saturated;
      kept_->mask = mask;
      kept_->present = present;
    }
    right_waits_ = second;
    second_ = !second && !in.marks.last;
    return out;
  }

 private:
  bool second_ = false;       // the next beat is the second of its pair
  bool right_waits_ = false;  // kept_ holds the right image's mean, not the first beat of a pair
  Kept<GreyPair> kept_;
};

template <Profile P>
using Subsample = std::conditional_t<P.packed(), PackingSubsampler, Subsampler<P.subsample>>;

}  // namespace horopter::stages
