// SPDX-License-Identifier: Apache-2.0
// still: does a camera repeat its frames, but for fresh noise? On the means of cells (stages/cells.hpp), one of every 17,
// which lie on slanted lines over the image; each is kept of the two frames before. Of two FIELDS in turn a frame is
// looked at beside those of its own rows: two and four frames before.
//
// A cell has not changed while its mean differs by -8 to 7 grey levels: by noise of sigma 10 means of 8×8 px hardly ever
// differ by more. A frame repeats an earlier one when fewer than 2 of these cells have changed. The frame before is looked
// at, and the one before that: two old frames in turn repeat that one. A camera before a scene that does not move gives the
// same, so a scene that may stand still must be declared: `still_limit` 0.
//
// In      left, right: means of the same cell; first: the frame's first.
// Config  still_limit: so many repeating frames one after another are a fault; 0 switches the check off,
//          and what was counted is forgotten.
// Out     of each camera, what the frame's cells so far say; the last cell's is the frame's.
// Memory: the cells kept. In frames with fewer than 16 of them, that is than 272 cells, nothing is said.
#pragma once

#include <array>
#include <cstddef>

#include "horopter/hls/ram.hpp"
#include "stages/stream.hpp"

namespace horopter::stages {

template <int CELLS, int FIELDS = 1>
class StillCheck {
  static constexpr int every = 17;
  static constexpr int least_cells = 16;
  static constexpr int index_bits = bits_for(CELLS / every);

 public:
  struct In {
    u<8> left;
    u<8> right;
    bool first = false;
  };
  struct Config {
    u<8> still_limit;
  };
  struct Out {
    bool left_still = false;
    bool right_still = false;
  };

  Out step(const In& in, const Config& config) {
    const bool looks = place_ == every - 1 && !in.first;
    Kept kept;
    kept_.begin_step();
    if (looks) {
      kept = kept_.read(index_);
      Kept now;
      now.cell[0] = {in.left, in.right};
      for (std::size_t i = 1; i < 2 * FIELDS; ++i) now.cell[i] = kept.cell[i - 1];
      kept_.write(index_, now);
    }
    const bool counts = config.still_limit != 0;
    const Cell& last = kept.cell[FIELDS - 1];
    const Cell& older = kept.cell[2 * FIELDS - 1];
    const bool one_before = before_.bit(FIELDS - 1), two_before = before_.bit(2 * FIELDS - 1);
    left_.step(in.first, counts, one_before, two_before, looks && changed(in.left, last.left),
               looks && changed(in.left, older.left));
    right_.step(in.first, counts, one_before, two_before, looks && changed(in.right, last.right),
                looks && changed(in.right, older.right));
    index_ = in.first ? u<index_bits>(0) : u<index_bits>(index_ + u<1>(looks));
    place_ = in.first || looks ? u<5>(0) : u<5>(place_ + lit<1>());
    if (in.first) before_ = u<2 * FIELDS>(cat(before_, true));

    const bool checked = config.still_limit != 0 && index_ >= least_cells;
    Out out;
    out.left_still = checked && left_.reach(config.still_limit);
    out.right_still = checked && right_.reach(config.still_limit);
    return out;
  }

 private:
  struct Cell {
    u<8> left;
    u<8> right;
  };
  struct Kept {
    std::array<Cell, 2 * FIELDS> cell{};  // of the last frame first
  };

  static bool changed(u<8> now, u<8> then) {
    const s<6> coarse = shr<3>(now - then);
    return coarse != 0 && coarse != -1;
  }

  /// Of one camera.
  class Repeats {
   public:
    void step(bool first, bool counts, bool one_before, bool two_before, bool since_last, bool since_older) {
      const bool repeats = last_ != enough || older_ != enough;
      if (first) {
        frames_ = !repeats || !counts ? u<8>(0) : frames_ == 255 ? frames_ : u<8>(frames_ + lit<1>());
        last_ = one_before ? u<2>(0) : u<2>(enough);
        older_ = two_before ? u<2>(0) : u<2>(enough);
      } else {
        if (since_last && last_ != enough) last_ += lit<1>();
        if (since_older && older_ != enough) older_ += lit<1>();
      }
    }
    [[nodiscard]] bool reach(u<8> limit) const {
      return (last_ != enough || older_ != enough) && frames_ + lit<1>() >= limit;
    }

   private:
    static constexpr int enough = 2;
    u<2> last_{enough};   // cells that have changed since the frame before
    u<2> older_{enough};  // since the one before that
    u<8> frames_{0};      // that repeated one of the two, one after another, before this one
  };

  RAM<Kept, 1 << index_bits, every> kept_;
  u<index_bits> index_{0};  // of the next cell kept
  u<5> place_{0};
  u<2 * FIELDS> before_{0};  // bit n: when the frame began, more than n had come
  Repeats left_;
  Repeats right_;
};

template <Profile P>
using Still = StillCheck<(P.width / P.cell()) * (P.height / P.cell()), P.fields_per_image()>;

}  // namespace horopter::stages
