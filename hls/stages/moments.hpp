// SPDX-License-Identifier: Apache-2.0
// moments: a part of `agreement`. Do both cameras show the same moment? If one is a frame late, what moves is at another
// place in its image. Along the row that looks like another distance; but when a motion begins, or ends, cells change in
// one image alone.
//
// A cell *turns* where the step from its mean to the next one's in the row was strong in the frame before, and now is 0
// or the other way round. Neither gain nor offset of a camera, nor noise, turns it. Compared are explained cells with their
// partners, where both had a strong step and the left one was explained in the frame before, too: what comes into one view
// before the other has no partner, and what it uncovers in one view had none. The cameras are out of step where so many
// turn in the one image, and not a quarter as many in the other; and from then on, until many turn in both at once, of
// whom hardly any had turned in the frame before: a motion begins, and both see it.
//
// The frame before of a field is the one of the same rows: with FIELDS of an image in turn, that many frames before. Each
// field is in step or not by itself. After a field that was lost two frames are compared with one of the other rows.
//
// Memory: the step of each cell, 2 bits of each camera, for each field.
#pragma once

#include <array>

#include "stages/stream.hpp"

namespace horopter::stages {

/// From the mean of a cell to the next one's in the row.
struct Step {
  bool strong = false;
  bool rises = false;
};
template <int BITS>
Step step_of(bool there, s<BITS> half_grey_levels) {
  constexpr int strong = 16;
  return {there && (half_grey_levels >= strong || half_grey_levels <= -strong), half_grey_levels > 0};
}

/// Of a cell, since the frame before.
struct Turn {
  bool strong = false;  // there was a strong step
  bool turned = false;
};

/// CELLS: of a frame. FIELDS: that take turns, 1 or 2.
template <int CELLS, int FIELDS>
class Moments {
  static constexpr int least = 12;  // cells
  static_assert(FIELDS == 1 || FIELDS == 2);

 public:
  using Turns = std::array<Turn, 2>;
  using Count = u<14>;

  void begin_step() {
    memory_.begin_step();
    // Every beat, from registers: the way from beat to beat is short.
    const bool out_of_step = begins_alone_ || (out_of_step_ && !ends_);
    if constexpr (FIELDS == 1) {
      out_of_step_ = out_of_step;
    } else {
      out_of_step_ = ended_ ? other_field_.out_of_step : out_of_step;
      if (ended_) other_field_.out_of_step = out_of_step;
      ended_ = false;
    }
    begins_alone_ = ends_ = false;
    for (std::size_t i = 0; i < 2; ++i) {
      turned_[i] = Count((starts_ ? Count(0) : turned_[i]) + u<1>(turns_[i]));
      turns_[i] = false;
    }
    place_ = starts_ ? Place(1) : Place(place_ + u<1>(taken_));
    starts_ = taken_ = false;
  }

  /// Of the left and the right cell at the same place, in the order of the rows. `explained`: the left one is.
  Turns take(bool first, bool explained, const Step& left, const Step& right) {
    const Place place = select(first, Place(0), place_);
    starts_ = first;
    taken_ = true;
    Turns turns;
    if (place >= CELLS) return turns;
    const Address address = address_of(place);
    const Steps before = memory_.read(address);
    Steps now;
    now.step[0] = left;
    now.step[1] = right;
    for (std::size_t i = 0; i < 2; ++i) {
      turns[i].strong = has_before_ && before.step[i].strong;
      turns[i].turned = turns[i].strong && before.step[i].rises != now.step[i].rises;
      turns_[i] = turns[i].turned;
    }
    now.step[0].strong = left.strong && explained;
    memory_.write(address, now);
    return turns;
  }

  /// All cells of a frame have come. `pairs`: so many of the explained cells, and of their partners, turned where both were
  /// strong. Two beats later the frame may end.
  void look(const std::array<Count, 2>& pairs) {
    left_ = change(pairs[0], turned_[1], before_[1]);
    right_ = change(pairs[1], turned_[0], before_[0]);
    most_before_ = select(before_[0] > before_[1], before_[0], before_[1]);
  }
  /// A beat later out_of_step() is known. After a change of the mapping table the right image is another one: nothing is
  /// said.
  void end_frame(bool watched, bool same_table) {
    const bool alone =
        (left_.alone && (left_.begins || left_.other_stops)) || (right_.alone && (right_.begins || right_.other_stops));
    begins_alone_ = watched && same_table && alone;
    ends_ = !watched || (same_table && left_.begins && right_.begins);
    if constexpr (FIELDS == 1) {
      before_ = turned_;
      has_before_ = true;
    } else {
      before_ = other_field_.before;
      has_before_ = other_field_.has_before;
      other_field_.before = turned_;
      other_field_.has_before = true;
      other_field_.second = !other_field_.second;
      ended_ = true;
    }
  }
  [[nodiscard]] bool out_of_step() const {
    if constexpr (FIELDS == 1) {
      return out_of_step_;
    } else {
      return out_of_step_ || other_field_.out_of_step;
    }
  }

 private:
  using Place = u<bits_for(CELLS) + 1>;
  struct Steps {
    std::array<Step, 2> step{};
  };

  /// Of one camera, in this frame.
  struct Change {
    bool begins = false;  // to move
    bool alone = false;
    bool other_stops = false;
  };
  Change change(const Count& pairs, const Count& other, const Count& other_before) const {
    return {many(pairs, most_before_), many(pairs, other), many(other_before, other)};
  }

  using Address = u<bits_for(FIELDS* CELLS) + 1>;
  Address address_of(const Place& place) const {
    if constexpr (FIELDS == 1) {
      return place;
    } else {
      return select(other_field_.second, Address(place + lit<CELLS>()), Address(place));
    }
  }

  static bool many(const Count& these, const Count& those) { return these >= shl<2>(those) + lit<least>(); }

  RAM<Steps, FIELDS * CELLS, min_row_beats> memory_;
  Place place_{0};                 // of the next cell
  std::array<Count, 2> turned_{};  // in this frame, of all cells
  std::array<Count, 2> before_{};  // in the frame before of this field
  bool has_before_ = false;        // there is one
  Count most_before_{0};
  Change left_, right_;
  bool out_of_step_ = false;
  // Of the beat before: it took a cell, the first of a frame.
  bool taken_ = false, starts_ = false;
  std::array<bool, 2> turns_{};               // the cell of the beat before
  bool begins_alone_ = false, ends_ = false;  // with the next beat
  // Of two fields: what the other one is to be compared with.
  struct OtherField {
    std::array<Count, 2> before{};
    bool has_before = false;
    bool out_of_step = false;
    bool second = false;  // this field's steps are in the second half of the memory
  };
  OtherField other_field_;
  bool ended_ = false;  // a frame, in the beat before
};

}  // namespace horopter::stages
