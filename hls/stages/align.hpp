// SPDX-License-Identifier: Apache-2.0
// align: from beats to pixels of the result. The windows before it end at the current pixel, so the state of pixel
// (x, y) comes OFFSET rows and COLUMNS columns after it (as many, unless a stage before delays the marks as well).
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

template <int WIDTH, int HEIGHT, int OFFSET, int COLUMNS = OFFSET>
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
    if (in.marks.first) [[unlikely]] {
      rows_ = Margin(0);
      started_ = false;
      active_ = false;
      idle_ = false;
    }
    if (in.marks.first || row_ended_) [[unlikely]] {
      columns_ = Margin(0);
    }
    const bool start = !started_ && rows_ == OFFSET && columns_ == COLUMNS;
    if (start) [[unlikely]] {
      started_ = true;
      active_ = true;
      last_ = false;
      final_row_ = config.height == 1;
      columns_left_ = Column(config.width - lit<1>());
      rows_left_ = Row(config.height - lit<1>());
    }
    Out out;
    out.state = in.state;
    out.idle = idle_;
    out.valid = idle_ || active_;
    out.first = start;
    out.last = last_ && active_;
    out.end = out.last && final_row_;

    idle_ = out.end;
    active_ = active_ && !out.end;
    // The next beat's `last_` is known from the count before, so that the counter's loop holds one subtraction only.
    if (last_) [[unlikely]] {
      final_row_ = rows_left_ == 1;
      rows_left_ -= lit<1>();
      last_ = false;
      columns_left_ = Column(config.width - lit<1>());
    } else {
      last_ = columns_left_ == 1;
      columns_left_ -= lit<1>();
    }
    row_ended_ = in.marks.last;
    columns_ += u<1>(columns_ != COLUMNS);
    if (in.marks.last) [[unlikely]] {
      rows_ += u<1>(rows_ != OFFSET);
    }
    return out;
  }

 private:
  using Margin = u<bits_for(OFFSET)>;
  using Column = u<bits_for(WIDTH)>;
  using Row = u<bits_for(HEIGHT)>;

  bool active_ = false;     // this beat is a pixel of the result
  bool idle_ = false;       // the beat after the last pixel
  bool last_ = false;       // this beat is the last of its row
  bool final_row_ = false;  // of the frame
  bool started_ = true;     // this frame's result has begun; true until the first frame
  bool row_ended_ = true;
  Margin rows_{0};          // rows of beats before this one, at most OFFSET
  Margin columns_{0};       // beats of this row before this one, at most OFFSET
  Column columns_left_{0};  // of the row, after this one
  Row rows_left_{0};        // of the result, after this one
};

template <Profile P>
using Align = Aligner<P.result_width(), P.height, P.offset()>;

}  // namespace horopter::stages
