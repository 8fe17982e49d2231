// SPDX-License-Identifier: Apache-2.0
// runs: transition coding (thesis 10.4.6). Every row is covered completely by runs of one state.
//
// In    the beats of align, the idle one too.
// Out   a beat per run, valid with the first beat after the run's last pixel:
//       row, start … end (columns, inclusive), state;
//       last: the frame's last run (given with the idle beat).
// Illegal use: a frame cut off by the next `first` leaves its last run unsaid.
#pragma once

#include "stages/align.hpp"

namespace horopter::stages {

template <int WIDTH, int HEIGHT>
class RunEncoder {
 public:
  struct In {
    u<2> state;
    bool first = false;
    bool last = false;
    bool idle = false;
  };
  struct Out {
    bool valid = false;
    u<bits_for(HEIGHT - 1)> row;
    u<bits_for(WIDTH - 1)> start;
    u<bits_for(WIDTH - 1)> end;
    u<2> state;
    bool last = false;
  };

  Out step(const In& in) {
    const bool row_start = in.first || row_ended_;
    const Column x = row_start ? Column(0) : next_;
    const bool begins = row_start || in.idle || in.state != state_;

    Out out;
    out.valid = open_ && begins && !in.first;
    out.row = row_;
    out.start = start_;
    out.end = end_;
    out.state = state_;
    out.last = in.idle;

    open_ = !in.idle;
    if (begins) {
      start_ = x;
      state_ = in.state;
    }
    if (in.first) {
      row_ = Row(0);
    } else if (row_start) {
      row_ = Row(row_ + lit<1>());
    }
    end_ = x;
    next_ = Column(x + lit<1>());
    row_ended_ = in.last;
    return out;
  }

 private:
  using Column = u<bits_for(WIDTH - 1)>;
  using Row = u<bits_for(HEIGHT - 1)>;

  bool open_ = false;  // a run has begun and not been emitted
  bool row_ended_ = true;
  Row row_{0};
  Column start_{0};
  Column end_{0};
  Column next_{0};
  u<2> state_{0};
};

template <Profile P>
using Runs = RunEncoder<P.result_width(), P.height>;

}  // namespace horopter::stages
