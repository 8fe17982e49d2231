// SPDX-License-Identifier: Apache-2.0
// health: can this camera's image be an image (thesis 2.3)? One instance per camera, on the pixels as they arrive.
//
// In      pixel; first, end: the frame's first and last pixel.
// Config  dark_level, bright_level: grey levels at or below (at or above) which a pixel is black (white);
//         dark_limit, bright_limit: pixels; contrast_limit: grey levels; frozen_limit: repetitions, 0 switches it off.
// Out     one beat per frame, with its last pixel:
//         black, white: more than the limit of pixels are; constant: the frame's grey levels span at most
//         contrast_limit, and it is neither black nor white; frozen: its signature has equalled that of the frame
//         before, for at least frozen_limit frames in a row; signature: the frame's. The signature is that of a
//         multiple-input shift register (MISR; Williams, Daehn, Gruetzner, Starke, IEEE Trans. CAD 7(2), 1988) with the
//         polynomial of CRC-32: equal frames have equal ones, and two noisy frames by chance once in 2^32.
// Illegal use: a frame without `end` is not judged; the next `first` starts anew.
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

template <int WIDTH, int HEIGHT>
class CameraHealth {
 public:
  using Count = u<bits_for(WIDTH* HEIGHT)>;

  struct In {
    u<8> pixel;
    bool first = false;
    bool end = false;
  };
  struct Config {
    u<8> dark_level;
    u<8> bright_level;
    Count dark_limit;
    Count bright_limit;
    u<8> contrast_limit;
    u<8> frozen_limit;
  };
  struct Out {
    bool valid = false;
    bool black = false;
    bool white = false;
    bool constant = false;
    bool frozen = false;
    u<32> signature;
  };

  Out step(const In& in, const Config& config) {
    if (in.first) [[unlikely]]
      signature_ = u<32>(0);
    signature_ = shr<1>(signature_) ^ (signature_.bit(0) ? u<32>(0xEDB88320U) : u<32>(0)) ^ in.pixel;
    if (in.first || in.pixel < darkest_) darkest_ = in.pixel;
    if (in.first || in.pixel > brightest_) brightest_ = in.pixel;
    count(dark_, in.first, in.pixel <= config.dark_level);
    count(bright_, in.first, in.pixel >= config.bright_level);

    Out out;
    out.valid = in.end;
    if (in.end) [[unlikely]] {
      const bool same = has_previous_ && signature_ == previous_signature_;
      repeats_ = !same ? u<8>(0) : repeats_ == 255 ? repeats_ : u<8>(repeats_ + lit<1>());
      previous_signature_ = signature_;
      has_previous_ = true;
      out.black = dark_ > config.dark_limit;
      out.white = bright_ > config.bright_limit;
      out.constant = u<8>(brightest_ - darkest_) <= config.contrast_limit && !out.black && !out.white;
      out.frozen = config.frozen_limit != 0 && repeats_ >= config.frozen_limit;
    }
    out.signature = previous_signature_;
    return out;
  }

 private:
  u<32> signature_{0};
  u<32> previous_signature_{0};
  bool has_previous_ = false;
  u<8> repeats_{0};
  u<8> darkest_{0};
  u<8> brightest_{0};
  Count dark_{0};
  Count bright_{0};
};

template <Profile P>
using Health = CameraHealth<P.width, P.height>;

}  // namespace horopter::stages
