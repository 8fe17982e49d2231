// SPDX-License-Identifier: Apache-2.0
// The example of hls/README.md.
#pragma once

#include <horopter/hls/int.hpp>
#include <horopter/hls/ram.hpp>

using horopter::hls::RAM;
using horopter::hls::u;

/// Mean of a pixel and the one above it, in rows of 640.
class Vertical {
 public:
  struct In {
    u<8> pixel;
  };
  struct Config {
    bool round;
  };  // optional: read where needed, never pipelined
  struct Out {
    bool valid;
    u<8> mean;
  };  // `valid`, if there is one, drops this beat

  Out step(const In& in, const Config& config) {
    const u<8> above = row_.read(x_);
    row_.write(x_, in.pixel);
    x_ = x_ == 639 ? u<10>(0) : u<10>(x_.value() + 1);
    if (!second_row_ && x_ == 0) second_row_ = true;
    return {second_row_, u<8>((above + in.pixel + u<1>(config.round)).value() >> 1)};
  }

 private:
  RAM<u<8>, 640, 640> row_;  // a memory
  u<10> x_;                  // a register, 0 after reset
  bool second_row_ = false;
};
