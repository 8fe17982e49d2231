// SPDX-License-Identifier: Apache-2.0
// coarse: do both images show the same, and does each show anything? On the means of cells (stages/cells.hpp), before
// the transformation: noise has averaged out there, and what a scene shows has not.
//
// One camera twice. g and h are the steps of left and right mean from cell to cell of a row. Where the right image is
// a · left + b, h_i = a · g_i, so every determinant g_(i-1) h_i − h_(i-1) g_i is 0, whatever a and b are. An edge of height e
// that the right image shows shifted by d cells gives −a d e² instead, against a e² in Σ g_i h_i. So in segments of a row,
// 8 cells long, |Σ determinants| / Σ g h measures the shift, and independent noise has the mean 0 in both. Textured: Σ |g|
// is at least 64. Same: shifted by less than 3/32 cell. One camera: 4/5 of the textured segments are the same.
// The images of two cameras are somewhere shifted: docs/safety.md has the margins.
//
// Blind. A step from cell to cell of at least `blind_step` is one that the camera sees; noise, a fog, a ramp or a covered
// lens has none. A camera is blind when it sees one at a smaller share of the cells than blind_share / 256.
// Blind in a part: tape. An image is also taken in strips of 4 columns of cells, and in rows of cells. A strip or a row is
// blind where no step in all of it is at least 3/8 of blind_step. The camera is blind when a quarter of the strips or a
// quarter of the rows is. Fewer than 8 strips, or 16 rows, are not judged.
//
// In      left, right: means of the same cell; first: the frame's first; start: a row's first.
// Config  one_camera_segments: so many segments must be textured, 0 switches the check off; blind_step: grey levels;
//         blind_share: of 256, 0 switches the check off.
// Out     what the frame's cells so far say; the last cell's is the frame's.
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

template <int CELLS>
class CoarseCheck {
  static constexpr int segment_cells = 8;
  static constexpr int least_texture = 64;  // grey levels of a segment
  using Score = s<bits_for(CELLS / segment_cells) + 3>;
  using Step = s<9>;
  using Sum = s<21>;

 public:
  struct In {
    u<8> left;
    u<8> right;
    bool first = false;
    bool start = false;
  };
  struct Config {
    u<8> one_camera_segments;
    u<8> blind_step;
    u<8> blind_share;
  };
  struct Out {
    bool one_camera = false;
    bool left_blind = false;
    bool right_blind = false;
  };

  Out step(const In& in, const Config& config) {
    if (in.start) {
      column_ = u<3>(0);
      first_ = true;
      second_ = false;
    }
    const Step g = first_ ? Step(0) : Step(in.left - left_);
    const Step h = first_ ? Step(0) : Step(in.right - right_);
    left_steps_.add(in.first, abs(g) >= config.blind_step && !first_, config.blind_share);
    right_steps_.add(in.first, abs(h) >= config.blind_step && !first_, config.blind_share);
    places_.step(in.first, in.start);
    left_parts_.add(in.first, places_, abs(g) >= small_step_ && !first_);
    right_parts_.add(in.first, places_, abs(h) >= small_step_ && !first_);
    small_step_ = u<8>(shr<3>(config.blind_step + shl<1>(config.blind_step)));  // from a row's second cell on

    // Of the row's second cell there is no determinant.
    const bool counts = !first_ && !second_;
    determinants_ = Sum((ended_ ? Sum(0) : determinants_) + (counts ? Sum(g_ * h - h_ * g) : Sum(0)));
    products_ = Sum((ended_ ? Sum(0) : products_) + (counts ? Sum(g * h) : Sum(0)));
    if (counts) texture_ += abs(g);
    const bool complete = column_ == segment_cells - 1;
    const bool textured = complete && texture_ >= least_texture;
    const auto determinants = shl<5>(determinants_);
    const auto limit = shl<1>(products_) + products_;
    const bool same = determinants < limit && determinants + limit > 0;
    const s<3> change = !textured ? s<3>(0) : same ? s<3>(1) : s<3>(-4);
    segments_missing_ = in.first ? s<12>(config.one_camera_segments) : s<12>(segments_missing_ - u<1>(textured));
    score_ = in.first ? Score(0) : Score(score_ + change);
    ended_ = complete || in.start;
    if (ended_) texture_ = u<12>(0);

    second_ = first_;
    first_ = false;
    left_ = in.left;
    right_ = in.right;
    g_ = g;
    h_ = h;
    column_ += lit<1>();

    Out out;
    out.one_camera = config.one_camera_segments != 0 && segments_missing_ <= 0 && score_ >= 0;
    const bool judges_parts = config.blind_share != 0;
    out.left_blind = left_steps_.too_few() || (judges_parts && left_parts_.too_few(places_));
    out.right_blind = right_steps_.too_few() || (judges_parts && right_parts_.too_few(places_));
    return out;
  }

 private:
  /// Cells with a step against their share of all.
  class Steps {
   public:
    void add(bool restart, bool step, u<8> share) {
      const s<10> change = step ? s<10>(lit<256>() - share) : s<10>(-share);
      balance_ = s<bits>((restart ? s<bits>(0) : balance_) + change);
    }
    [[nodiscard]] bool too_few() const { return balance_.negative(); }

   private:
    static constexpr int bits = bits_for(CELLS) + 9;
    s<bits> balance_{0};  // cells, in 1/256, beyond their share
  };

  static constexpr int strip_cells = 4;
  static constexpr int most_strips = 32;
  static constexpr int least_strips = 8, least_rows = 16;

  /// Where a cell stands, and how many strips and rows there are so far.
  struct Places {
    u<7> column{0};
    bool row_starts = false;
    bool strip_starts = false;  // the first cell of a strip, in the first row
    u<6> strips{0};
    u<5> rows{0};  // up to 16
    bool first_row = false;

    void step(bool first, bool start) {
      column = start ? u<7>(0) : u<7>(column + lit<1>());
      row_starts = start;
      first_row = first || (first_row && !start);
      strip_starts = first_row && column.template bits<1, 0>() == 0;
      strips = u<6>((first ? u<6>(0) : strips) + u<1>(strip_starts));
      const u<5> rows_before = first ? u<5>(0) : rows;
      rows = u<5>(rows_before + u<1>(start && !rows_before.bit(4)));
    }
    [[nodiscard]] u<5> strip() const { return column.template bits<6, 2>(); }
  };

  /// Strips and rows without a step against a quarter of all.
  class Parts {
   public:
    void add(bool restart, const Places& at, bool step) {
      const u<most_strips> here(u<most_strips>(1) << at.strip());
      const u<most_strips> seen = restart ? u<most_strips>(0) : strips_;
      const bool new_strip = step && (seen & here) == 0;
      const bool new_row = step && (at.row_starts || !row_seen_);
      row_seen_ = step || (row_seen_ && !at.row_starts);
      strips_ = step ? u<most_strips>(seen | here) : seen;
      blind_strips_ = balance(restart, blind_strips_, at.strip_starts, new_strip);
      blind_rows_ = balance(restart, blind_rows_, at.row_starts, new_row);
    }
    [[nodiscard]] bool too_few(const Places& at) const {
      return (at.strips >= least_strips && !blind_strips_.negative()) ||
             (at.rows >= least_rows && !blind_rows_.negative());
    }

   private:
    using Balance = s<10>;
    /// 3 for each blind one, -1 for each other.
    static Balance balance(bool restart, Balance before, bool one_more, bool seen) {
      return Balance((restart ? Balance(0) : before) + (one_more ? s<4>(3) : s<4>(0)) - (seen ? s<4>(4) : s<4>(0)));
    }
    u<most_strips> strips_{0};  // bit n: a step was seen in strip n
    bool row_seen_ = false;
    Balance blind_strips_{0}, blind_rows_{0};
  };

  u<8> left_{0};
  u<8> right_{0};
  u<8> small_step_{0};
  Step g_{0};
  Step h_{0};
  u<3> column_{0};
  bool first_ = false;   // the row's first cell
  bool second_ = false;  // its second
  bool ended_ = false;   // the cell before ended a segment
  Sum determinants_{0};
  Sum products_{0};
  u<12> texture_{0};
  s<12> segments_missing_{0};  // textured ones
  Score score_{0};             // 1 for each textured segment that is the same, -4 for each that is not
  Steps left_steps_;
  Steps right_steps_;
  Places places_;
  Parts left_parts_;
  Parts right_parts_;
};

template <Profile P>
using Coarse = CoarseCheck<(P.width / P.cell()) * (P.height / P.cell())>;

}  // namespace horopter::stages
