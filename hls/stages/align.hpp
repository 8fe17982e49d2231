// SPDX-License-Identifier: Apache-2.0
// align: from beats to pixels of the result. The windows before it end at the current pixel, so the state of pixel
// (x, y) comes some rows and columns after it (no columns where the stages before delay the marks as well). With both
// rules there are two such offsets.
//
// Clear is earned: a pixel is clear only where `agreement` has shown that both cameras see its place, and nothing nearer
// than the skin there. Otherwise it is undecidable, and `unproven` or `hidden` says why.
//
// Config  width, height of the result in px, at most the template's; width > the offset and 2, height > 1. compete, where there are two
//         offsets: the second holds; it may change between frames.
// Out     one beat for each pixel of the result, in raster order from (0, 0): first, last (of a row), end (last of the
//         frame). The raster is shifted as a whole: the last pixels of a row, as many as the offset's columns, come
//         with the next row's first beats, which belong to the border and are unsupervised. After `end` follows one
//         beat with `idle` set, not a pixel, in which `runs` emits its last run.
// `first` starts a new frame at once, whatever has become of the last one. Illegal use: a frame
// without a row more than height and offset is cut off without `end`.
#pragma once

#include "stages/majority.hpp"

namespace horopter::stages {

struct ResultOffset {
  int rows = 0;
  int columns = 0;
  friend bool operator==(const ResultOffset&, const ResultOffset&) = default;
};

template <int WIDTH, int HEIGHT, ResultOffset OFFSET, ResultOffset COMPETE = OFFSET>
class Aligner {
  struct Size {
    u<bits_for(WIDTH)> width;
    u<bits_for(HEIGHT)> height;
  };
  struct SizeAndRule {
    u<bits_for(WIDTH)> width;
    u<bits_for(HEIGHT)> height;
    bool compete = false;
  };
  static constexpr bool two = OFFSET != COMPETE;

 public:
  struct In {
    u<2> state;
    Marks marks;
  };
  using Config = std::conditional_t<two, SizeAndRule, Size>;
  struct Out {
    bool valid = false;
    u<2> state;
    bool first = false;
    bool last = false;
    bool end = false;
    bool idle = false;
    bool hidden = false;    // undecidable because something nearer than the skin is seen there
    bool unproven = false;  // undecidable because nothing shows that both cameras see its place
  };

  Out step(const In& in, const Config& config) {
    Margin rows(OFFSET.rows);
    Margin columns(OFFSET.columns);
    if constexpr (two) {
      if (config.compete) rows = Margin(COMPETE.rows);
      if (config.compete) columns = Margin(COMPETE.columns);
    }
    if (in.marks.first) [[unlikely]] {
      rows_ = Margin(0);
      started_ = false;
      active_ = false;
      idle_ = false;
    }
    if (in.marks.first || row_ended_) [[unlikely]] {
      columns_ = Margin(0);
    }
    const bool start = !started_ && rows_ == rows && columns_ == columns;
    Out out;
    const bool clear = in.state == state::clear;
    out.hidden = clear && in.marks.nearer;
    out.unproven = clear && !in.marks.seen;
    out.state = out.hidden || out.unproven ? u<2>(state::undecidable) : in.state;
    out.idle = idle_;
    out.valid = idle_ || active_ || start;
    out.first = start;
    out.last = last_ && active_;
    out.end = out.last && final_row_;

    idle_ = out.end;
    started_ = started_ || start;
    active_ = (active_ || start) && !out.end;
    // The next beat's `last_` is known from the count before, so that the counter's loop holds one subtraction only.
    if (start) [[unlikely]] {
      final_row_ = last_ = false;
      columns_left_ = Column(config.width - lit<1>());
      rows_left_ = config.height;
    } else if (last_) [[unlikely]] {
      final_row_ = rows_left_ == 2;
      rows_left_ -= lit<1>();
      last_ = false;
      columns_left_ = config.width;
    } else {
      last_ = columns_left_ == 2;
      columns_left_ -= lit<1>();
    }
    row_ended_ = in.marks.last;
    columns_ += u<1>(columns_ != columns);
    if (in.marks.last) [[unlikely]] {
      rows_ += u<1>(rows_ != rows);
    }
    return out;
  }

 private:
  using Margin = u<bits_for(std::max({OFFSET.rows, OFFSET.columns, COMPETE.rows, COMPETE.columns}))>;
  using Column = u<bits_for(WIDTH)>;
  using Row = u<bits_for(HEIGHT)>;

  bool active_ = false;     // this beat is a pixel of the result
  bool idle_ = false;       // the beat after the last pixel
  bool last_ = false;       // this beat is the last of its row
  bool final_row_ = false;  // of the frame
  bool started_ = true;     // this frame's result has begun; true until the first frame
  bool row_ended_ = true;
  Margin rows_{0};          // rows of beats before this one, at most the offset's
  Margin columns_{0};       // beats of this row before this one, at most the offset's
  Column columns_left_{0};  // of the row, from this beat on
  Row rows_left_{0};        // of the result, from this one on
};

template <Profile P>
inline constexpr ResultOffset thesis_offset{P.offset(), P.offset()};
template <Profile P>
inline constexpr ResultOffset compete_offset{P.compete_offset(), 0};
template <Profile P>
using Align = Aligner<P.result_width(), P.height, P.has_thesis() ? thesis_offset<P> : compete_offset<P>,
                      P.has_compete() ? compete_offset<P> : thesis_offset<P>>;

}  // namespace horopter::stages
