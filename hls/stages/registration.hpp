// SPDX-License-Identifier: Apache-2.0
// registration: a part of `agreement`. Is the right image displaced across the rows against what the cameras' geometry
// says? Each explained cell says by how much it is, beyond the slope of its epipolar line times its shift along the row.
//
// A camera has moved where the median is a limit or more: of the whole image (knocked); of two halves of it, in opposite
// directions (rolled, enlarged); or, with a larger limit, of one half. A median needs no sorting: more than half of the
// cells beyond a limit is the median beyond it.
//
// A cell takes `slots` beats: one adder a beat does what several would do at once. What cells say is summed over half a
// row, and then added to sums in a memory, of each quarter of the image. Behind the frame moved() reads these, one a beat.
#pragma once

#include <array>
#include <cstddef>

#include "stages/stream.hpp"

namespace horopter::stages {

/// Displacement across the rows in 1/32 cell, of scores at displacements of -2 … 2 cells. Bits that agree fall evenly to
/// both sides, so the fraction is where two lines of equal and opposite slope meet (Shimizu and Okutomi, ICCV 2001); a
/// parabola says too little, down to half. The fraction comes a bit a beat (ratio() says how), behind begin().
class Displacement {
 public:
  /// The best score, and those of the displacements beside it.
  struct Peak {
    u<3> place;  // 2: no displacement. 0 and 4 have one neighbour, and no fraction
    u<8> score, above, below;
  };

  /// `begins`: with the same peak as in the five beats that follow. With the last of them across() is its displacement.
  void step(bool begins, const Peak& peak) {
    const s<9> rise(peak.below - peak.above);
    const u<9> size(abs(rise));
    const s<9> fall(peak.score - (rise.negative() ? peak.below : peak.above));
    const u<9> twice(fall.negative() ? u<9>(0) : u<9>(shl<1>(u<8>(fall))));
    const bool fits = over_.bit(9);
    const u<10> wide(twice);
    const u<10> left = begins ? wide : u<10>(cat(u<9>(over_), u<1>(!fits)));
    const u<10> taken = begins ? u<10>(~u<10>(shl<1>(size < twice ? size : twice))) : (fits ? wide : u<10>(~wide));
    fraction_ = u<5>(cat(fraction_, fits));
    over_ = u<10>(shr<1>(cat(left, u<1>(1)) + cat(taken, u<1>(begins))));  // the carry in one addition
  }
  [[nodiscard]] s<8> across(const Peak& peak) const {
    const auto whole = shl<5>(s<4>(s<4>(peak.place) - lit<2>()));
    if (peak.place == 0 || peak.place == 4) return s<8>(whole);
    return peak.below < peak.above ? s<8>(whole - fraction_) : s<8>(whole + fraction_);
  }

 private:
  u<10> over_{0};  // the divisor less twice the rest, negative where the divisor fits
  u<5> fraction_{0};
};

/// COLUMNS, ROWS: of cells. DISTANCE: of its memory. SHARES: a clock is long enough for a product that one adds to the next.
template <int COLUMNS, int ROWS, std::size_t DISTANCE, bool SHARES>
class Registration {
 public:
  using Shift = s<6>;  // along the row, cells
  static constexpr int slots = 8;
  static constexpr int moved_steps = 41;

  /// Sum of the displacement, 1/32 cell, and the cells it is of, in a quarter of the image; or votes, down and up.
  struct Sums {
    s<20> low;
    s<12> high;
  };

  void begin_step() {
    moving_ = Moving{};
    change_ = Change{};
    sums_.begin_step();
  }

  /// A beat of a cell in a row; before step_cell().
  void step_peak(u<3> slot, const Displacement::Peak& peak) { displacement_.step(slot < 3, peak); }

  /// A beat of a cell in a row. `inside` the row; behind it, slots go on. `right`, `lower`: half of the image, `right` not
  /// behind the row. `counts`: the cell is explained; looked at in the last slot.
  template <class Config>
  void step_cell(u<3> slot, bool inside, bool right, bool lower, bool counts, Shift shift,
                 const Displacement::Peak& peak, const Config& config) {
    const bool last = slot == slots - 1;
    // Half-way to the place that was found: with lens distortion the lines are curved.
    const auto change = s<8>(sat_signed<8>(s<17>(shr<11>(slope_change_))));
    s<14> along;  // times the shift
    s<14> along_change;
    if constexpr (SHARES) {
      along = along_change = product(last ? slope_here_ : change, shift);
    } else {
      along = product(slope_here_, shift);
      along_change = product(change, shift);
    }
    const bool half_ends = inside ? (right && !of_right_) : was_inside_;
    if (!last) {
      slope_here_ = s<8>(sat_signed<8>(s<13>(shr<16>(slope_) + shr<6>(along_change))));
    } else {
      was_inside_ = inside;
      expected_ = s<11>(shr<3>(along));
      if (counts) {
        const auto expected = shr<3>(along);
        const auto residual = s<8>(sat_signed<8>(s<13>(displacement_.across(peak) - expected)));
        change_ = {false, residual, 1, votes(residual, s<7>(config.moved_limit)),
                   votes(residual, s<7>(config.moved_half_limit))};
      }
    }
    if (half_ends && slot >= 1 && slot <= 3) add_half(u<2>(slot - lit<1>()), u<2>(cat(lower, of_right_)));
    if (slot == 4) {
      change_.clears = half_ends;
      of_right_ = right;
    }
  }

  /// Last of all in every beat. `row_starts`: the next row's slopes are wanted, of the image's first rows if `first`;
  /// `in_row`: this beat and the next belong to cells of a row, and the next cell's slope is wanted if `next_cell`.
  template <class Config>
  void end_beat(bool new_frame, bool row_starts, bool first, bool in_row, bool next_cell, const Config& config) {
#ifndef __HLSC__
    if (!in_row && !row_starts && !change_.clears && change_.measured == 0) {  // nothing else changes
      slope_ = slope_row_;
      weigh();
      return;
    }
#endif
    const s<28> column(slope_ + (next_cell ? slope_change_ : s<28>(0)));
    slope_ = in_row ? column : slope_row_;
    const bool next_row = row_starts && !first;
    const bool begins = row_starts && first;
    const s<28> row(slope_row_ + (next_row ? s<20>(shl<4>(config.epipolar_row)) : s<20>(0)));
    const s<28> both(slope_change_ + (next_row ? config.epipolar_both : s<16>(0)));
    slope_row_ = begins ? s<28>(shl<9>(config.epipolar_slope)) : row;
    slope_change_ = begins ? s<28>(shl<4>(config.epipolar_column)) : both;
    half_.across = s<14>(change_.clears ? s<15>(0) : half_.across + change_.across);
    half_.measured = u<6>(change_.clears ? u<7>(0) : half_.measured + change_.measured);
    half_.votes.add(change_.votes, change_.clears);
    half_.half_votes.add(change_.half_votes, change_.clears);
    if (new_frame) fresh_ = u<4>::max();
    weigh();
  }

  /// Behind the frame, steps 0 … moved_steps - 1; then moved() is known.
  void step_moved(u<6> step) {
    // Eight steps for each half of the image, left, right, upper, lower: two quarters' cells, votes and half votes. Then
    // four for the cells and four for the votes of all quarters.
    const u<3> half = step.template bits<5, 3>();
    const u<3> at = step.template bits<2, 0>();
    const bool all = half == 4;
    const auto kind = all ? u<2>(at.bit(2)) : at.template bits<2, 1>();
    const u<2> quarter = all ? at.template bits<1, 0>()
                             : (half.bit(1) ? u<2>(cat(half.bit(0), at.bit(0))) : u<2>(cat(at.bit(0), half.bit(0))));
    moving_.is = true;
    moving_.first = step == 0;
    moving_.begins = all ? at.template bits<1, 0>() == 0 : !at.bit(0);
    moving_.cells = all ? at == 4 : at == 2;
    moving_.all = all;
    moving_.votes = at == 4;
    moving_.half_votes = half.bit(2) ? half.bit(0) : at == 6;  // or the votes of all
    moving_.second = at == 6 && half.bit(0) && !half.bit(2);
    moving_.ends = at == 7;
    moving_.word = kind == 3 || half == 5 ? Sums{} : read(kind, quarter);
  }
  [[nodiscard]] bool moved() const { return moved_; }
  /// Rows down a column to the right where the cell of step_cell() was found, 1/256. In its last slot.
  [[nodiscard]] s<8> slope_here() const { return slope_here_; }
  /// Rows down that its shift makes of that, 1/32 cell. In its last slot.
  [[nodiscard]] s<11> expected() const { return expected_; }

  /// Displacement and cells of a quarter: top left, top right, bottom left, bottom right. Not with step_moved().
  Sums quarter(u<2> quarter) { return read(u<2>(0), quarter); }

 private:
  static constexpr int least_votes = 40, least_half_votes = 60;
  static constexpr int half_columns = COLUMNS / 2 + 2;
  static_assert(half_columns < 64 && half_columns * (ROWS / 2 - 4) < 2048);

  /// That a cell is displaced by a limit or more, down and up: 1; else -1.
  struct Vote {
    s<2> down, up;
  };
  /// Above 0: more than half of the cells are.
  struct Votes {
    s<7> down, up;
    void add(const Vote& vote, bool clears) {
      down = s<7>(clears ? s<8>(0) : down + vote.down);
      up = s<7>(clears ? s<8>(0) : up + vote.up);
    }
  };
  /// Of half a row.
  struct Half {
    s<14> across;
    u<6> measured;
    Votes votes;       // beyond moved_limit
    Votes half_votes;  // beyond moved_half_limit
  };
  /// What a beat does to them.
  struct Change {
    bool clears = false;
    s<8> across;
    u<1> measured;
    Vote votes, half_votes;
  };
  using Total = s<14>;

  static Vote votes(s<8> residual, s<7> limit) {
    return {residual >= limit ? s<2>(1) : s<2>(-1), -residual >= limit ? s<2>(1) : s<2>(-1)};
  }

  /// By additions, one after the other: a clock each where the clock is fast.
  static s<14> product(s<8> a, Shift b) {
    const auto term = [&](int bit) { return b.bit(bit) ? a : s<8>(0); };
    const auto low = term(0) + shl<1>(term(1));
    const auto middle_bits = shl<2>(term(2)) + shl<3>(term(3));
    const auto high = shl<4>(term(4)) - shl<5>(term(5));
    return s<14>((low + middle_bits) + high);
  }
  template <int N, int M>
  static constexpr s<N> sat_signed(s<M> value) {
    if (value > s<N>::max()) return s<N>::max();
    if (value < s<N>::min()) return s<N>::min();
    return s<N>(value);
  }

  /// What step_moved() asks for in this beat.
  struct Moving {
    bool is = false;
    bool first = false;
    bool begins = false;      // a sum
    bool cells = false;       // are summed
    bool all = false;         // quarters
    bool votes = false;       // of a half are summed
    bool half_votes = false;  // are summed, or the votes of all
    bool second = false;      // of two halves that may lie against each other
    bool ends = false;        // the half
    Sums word;
  };
  /// Flat, so that the way from register to register is short.
  void weigh() {
#ifndef __HLSC__
    if (!moving_.is) return;  // nothing changes
#endif
    const Moving& m = moving_;
    const bool any = up_ > 0 || down_ > 0;
    const bool against = (votes_down_ && other_up_) || (votes_up_ && other_down_);
    const bool finds = enough_ && ((m.half_votes && any) || (m.second && other_enough_ && against));
    moved_ = !m.first && (moved_ || finds);
    enough_ = m.cells ? (m.all ? up_ >= least_votes : up_ >= least_half_votes) : enough_;
    other_enough_ = m.ends ? enough_ : other_enough_;
    other_down_ = m.ends ? votes_down_ : other_down_;
    other_up_ = m.ends ? votes_up_ : other_up_;
    votes_down_ = m.votes ? down_ > 0 : votes_down_;
    votes_up_ = m.votes ? up_ > 0 : votes_up_;
    down_ = m.is ? Total((m.begins ? Total(0) : down_) + s<12>(m.word.low)) : down_;
    up_ = m.is ? Total((m.begins ? Total(0) : up_) + m.word.high) : up_;
  }

  Sums read(u<2> kind, u<2> quarter) {
    const Sums word = sums_.read(cat(kind, quarter));
    return fresh_.bit(static_cast<int>(quarter.value())) ? Sums{} : word;
  }

  void add_half(u<2> kind, u<2> quarter) {
    Sums word = read(kind, quarter);
    const s<7> down = kind.bit(0) ? half_.votes.down : half_.half_votes.down;
    const s<7> up = kind.bit(0) ? half_.votes.up : half_.half_votes.up;
    word.low += kind == 0 ? half_.across : s<14>(down);
    word.high += kind == 0 ? s<7>(half_.measured) : up;
    sums_.write(cat(kind, quarter), word);
    if (kind == 2) fresh_ = u<4>(fresh_ & ~u<4>(u<4>(1) << quarter));
  }

  Displacement displacement_;
  s<8> slope_here_{0};
  s<11> expected_{0};
  Half half_;
  bool of_right_ = false;    // `half_` is of the image's right half
  bool was_inside_ = false;  // the cell before
  RAM<Sums, 12, DISTANCE> sums_;
  u<4> fresh_{15};  // quarters whose sums are those of another frame
  s<28> slope_row_{0}, slope_change_{0}, slope_{0};
  Total down_{0}, up_{0};
  bool enough_ = false, votes_down_ = false, votes_up_ = false;
  bool other_enough_ = false, other_down_ = false, other_up_ = false;
  bool moved_ = false;
  Moving moving_;  // of this beat
  Change change_;
};

}  // namespace horopter::stages
