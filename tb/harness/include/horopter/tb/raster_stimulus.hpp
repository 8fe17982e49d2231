// SPDX-License-Identifier: Apache-2.0
// Stimulus of pixel streams: data at random, frame marks as the raster generator makes them, or damaged, or (where no
// memory depends on them) at random too. Marks are found by the names of the members of In, whatever stage it is.
#pragma once

#include <algorithm>
#include <cstdint>

#include "horopter/tb/stage_bench.hpp"

namespace horopter::tb {

template <class Stage>
class RasterStimulus {
 public:
  /// Rows of min_row … max_row beats. `any_marks`: the stage keeps no memory, so marks may come in any order.
  RasterStimulus(Rng rng, unsigned min_row, unsigned max_row, bool any_marks)
      : rng_{rng}, leaves_{Rng{rng_.next()}}, min_row_{min_row}, max_row_{max_row}, any_marks_{any_marks} {
    choose();
  }

  void restart() {
    kind_ = next_kind_;
    start_frame();
  }

  ConfigOf<Stage> config() {
    auto config = leaves_.template value<ConfigOf<Stage>>();
    choose();
    if constexpr (requires { config.width, config.height; }) {
      // Usually the geometry that comes.
      if (!rng_.chance(4)) {
        config.width = decltype(config.width)(width_);
        config.height = decltype(config.height)(height_ > kFlushRows ? height_ - kFlushRows : height_);
        fixed_geometry_ = true;
      }
    }
    if constexpr (requires { config.spacing_x_log2; })
      spacing_x_log2_ = std::min<unsigned>(6, config.spacing_x_log2.value());
    return config;
  }

  InOf<Stage> next() {
    InOf<Stage> in = leaves_.template value<InOf<Stage>>();
    if (kind_ == Kind::any) {
      if (--any_beats_ == 0) start_frame();
      return in;
    }
    mark(in);
    return in;
  }

 private:
  static constexpr unsigned kFlushRows = 10;  ///< more or fewer do not matter to a bench
  enum class Kind { frames, ragged, any };

  /// A geometry for the next frames.
  void choose() {
    width_ =
        static_cast<unsigned>(rng_.chance(6) ? max_row_ : rng_.between(min_row_, std::min(max_row_, 4 * min_row_)));
    height_ = static_cast<unsigned>(rng_.between(1, 40));
    fixed_geometry_ = false;
    next_kind_ = rng_.chance(4) ? (any_marks_ && rng_.chance(2) ? Kind::any : Kind::ragged) : Kind::frames;
    if (x_ != 0 && kind_ != Kind::any) {
      // Not in the middle of a row: memories have a shortest one.
      row_ = std::max(x_ + 1, min_row_);
      cut_off_ = true;
    } else {
      restart();
    }
  }

  void start_frame() {
    x_ = y_ = 0;
    cut_off_ = false;
    idle_next_ = false;
    primed_ = false;
    row_ = kind_ == Kind::ragged ? ragged_row() : width_;
    any_beats_ = 2'000;
  }
  unsigned ragged_row() { return static_cast<unsigned>(rng_.between(min_row_, std::min(max_row_, 3 * min_row_))); }

  template <class In>
  void mark(In& in) {
    const bool live = y_ < height_ - std::min(height_ - 1, kFlushRows);
    bool first = x_ == 0 && y_ == 0;
    bool last = x_ + 1 == row_;
    if (kind_ == Kind::ragged && rng_.chance(8) && last) last = false, first = false;  // a mark is lost
    if constexpr (requires { in.prime, in.load; }) {
      // One beat before the row, then a new column every 2^spacing pixels.
      in.prime = !primed_;
      in.load = primed_ && x_ % (1U << spacing_x_log2_) == 0;
      if (!primed_) {
        primed_ = true;
        set_marks(in.marks, false, false, false);
        return;
      }
      if (x_ + 1 == row_) primed_ = false;
    }
    if constexpr (requires { in.marks; }) set_marks(in.marks, first, last, live);
    if constexpr (requires { in.first; }) in.first = first && !idle_next_;
    if constexpr (requires { in.last; }) in.last = last && !idle_next_;
    if constexpr (requires { in.end; }) in.end = last && y_ + 1 == height_ && !idle_next_;
    if constexpr (requires { in.idle; }) {
      in.idle = idle_next_;
      if (idle_next_) {
        idle_next_ = false;
        return;
      }
      idle_next_ = x_ + 1 == row_ && y_ + 1 == height_;
    }
    advance();
  }

  template <class Marks>
  static void set_marks(Marks& marks, bool first, bool last, bool live) {
    marks.first = first;
    marks.last = last;
    if constexpr (requires { marks.live; }) marks.live = live;
  }

  void advance() {
    if (++x_ < row_) return;
    x_ = 0;
    if (cut_off_) return restart();
    if (kind_ == Kind::ragged) row_ = ragged_row();
    if (++y_ < height_ && !(kind_ == Kind::ragged && rng_.chance(20))) return;
    y_ = 0;
    if (!fixed_geometry_ && rng_.chance(4)) {
      const bool idle = idle_next_;
      choose();
      idle_next_ = idle;
    }
  }

  Rng rng_;
  RandomLeaves leaves_;
  unsigned min_row_, max_row_;
  bool any_marks_;
  Kind kind_ = Kind::frames, next_kind_ = Kind::frames;
  unsigned width_ = 0, height_ = 0, row_ = 0, x_ = 0, y_ = 0, any_beats_ = 0, spacing_x_log2_ = 0;
  bool fixed_geometry_ = false, idle_next_ = false, primed_ = false, cut_off_ = false;
};

}  // namespace horopter::tb
