// SPDX-License-Identifier: Apache-2.0
// align: from beats to pixels of the result. The windows before it end at the current pixel, so the state of pixel
// (x, y) comes OFFSET rows and OFFSET columns after it.
//
// Config  width, height of the result in px, at most the template's; width > OFFSET.
// Out     one beat for each pixel of the result, in raster order from (0, 0): first, last (of a row), end (last of the
//         frame). The raster is shifted as a whole: the last OFFSET pixels of a row come with the next row's first
//         beats, which belong to the border and are unsupervised. After `end` follows one beat with `idle` set, not a
//         pixel, in which `runs` emits its last run.
// `first` starts a new frame at once, whatever has become of the last one. Illegal use: fewer than height + OFFSET + 1
// rows in a frame cut it off without `end`.
#pragma once

#include "stages/majority.hpp"

namespace horopter::stages {

template <int WIDTH, int HEIGHT, int OFFSET>
class Aligner {
 public:
  struct In {
    u<2> state;
    Marks marks;
  };
  struct Config {
    u<bits_for(WIDTH)> width;
    u<bits_for(HEIGHT)> height;
  };
  struct Out {
    bool valid = false;
    u<2> state;
    bool first = false;
    bool last = false;
    bool end = false;
    bool idle = false;
  };

  Out step(const In& in, const Config& config) {
    const bool row_start = in.marks.first || row_ended_;
    const Margin rows = in.marks.first ? Margin(0) : rows_;
    const Margin columns = row_start ? Margin(0) : columns_;
    const bool start = rows == OFFSET && columns == OFFSET && !started_;
    const bool restart = in.marks.first;

    const Phase phase = restart ? waiting : start ? pixels : phase_;
    const Column x = start ? Column(0) : x_;
    const Row y = start ? Row(0) : y_;
    Out out;
    out.state = in.state;
    out.first = start;
    out.last = x + lit<1>() == config.width;
    out.end = out.last && y + lit<1>() == config.height;
    out.idle = phase == idling;
    out.valid = phase == pixels || out.idle;
    if (out.idle) out.first = out.last = out.end = false;

    x_ = out.last ? Column(0) : Column(x + lit<1>());
    y_ = out.last ? Row(y + lit<1>()) : y;
    phase_ = out.idle ? waiting : phase == pixels && out.end ? idling : phase;
    started_ = !restart && (started_ || start);
    row_ended_ = in.marks.last;
    columns_ = columns == OFFSET ? columns : Margin(columns + lit<1>());
    rows_ = in.marks.last && rows != OFFSET ? Margin(rows + lit<1>()) : rows;
    return out;
  }

 private:
  using Margin = u<bits_for(OFFSET)>;
  using Column = u<bits_for(WIDTH)>;
  using Row = u<bits_for(HEIGHT)>;
  using Phase = u<2>;
  static constexpr int waiting = 0;  // for the first pixel of the result
  static constexpr int pixels = 1;
  static constexpr int idling = 2;  // the beat after the last pixel

  Phase phase_{waiting};
  bool started_ = true;  // this frame's result has begun; true until the first frame
  bool row_ended_ = true;
  Margin rows_{0};     // rows of beats before this one, at most OFFSET
  Margin columns_{0};  // beats of this row before this one, at most OFFSET
  Column x_{0};
  Row y_{0};
};

template <Profile P>
using Align = Aligner<P.result_width(), P.height, P.offset()>;

}  // namespace horopter::stages
