// SPDX-License-Identifier: Apache-2.0
// alarm: pixels in the skin per frame against a limit (thesis 10.4.6), and the same for the pixels it could not judge.
//
// In      the beats of align; the idle one counts nothing.
// Config  limits in pixels.
// Out     one beat per frame, with the frame's last pixel: counts, and for each whether it exceeds its limit.
// Hidden and unproven pixels are not counted here. They have limits of their own (agreement.hpp), and all that is undecidable
// has one in rtl/top/horopter_agreement_result.sv.
// The counts start anew with `first`. Illegal use: more pixels than WIDTH·HEIGHT wrap a count.
#pragma once

#include "stages/align.hpp"

namespace horopter::stages {

template <int WIDTH, int HEIGHT>
class AlarmCounter {
 public:
  using Count = u<bits_for(WIDTH* HEIGHT)>;

  struct In {
    u<2> state;
    bool first = false;
    bool end = false;
    bool idle = false;
    bool hidden = false;
    bool unproven = false;
  };
  struct Config {
    Count alarm_limit;
    Count undecidable_limit;
    Count unsupervised_limit;
  };
  struct Out {
    bool valid = false;
    Count skin_pixels;
    Count unsupervised_pixels;
    bool alarm = false;
    bool too_undecidable = false;
    bool too_unsupervised = false;
  };

  Out step(const In& in, const Config& config) {
    count(skin_, in.first, !in.idle && in.state == state::skin);
    count(undecidable_, in.first, !in.idle && in.state == state::undecidable && !in.hidden && !in.unproven);
    count(unsupervised_, in.first, !in.idle && in.state == state::unsupervised);
    Out out;
    out.valid = in.end && !in.idle;
    out.skin_pixels = skin_;
    out.unsupervised_pixels = unsupervised_;
    out.alarm = skin_ > config.alarm_limit;
    out.too_undecidable = undecidable_ > config.undecidable_limit;
    out.too_unsupervised = unsupervised_ > config.unsupervised_limit;
    return out;
  }

 private:
  Count skin_{0};
  Count undecidable_{0};
  Count unsupervised_{0};
};

template <Profile P>
using Alarm = AlarmCounter<P.result_width(), P.height>;

}  // namespace horopter::stages
