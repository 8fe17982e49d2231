// SPDX-License-Identifier: Apache-2.0
// census: what `agreement` compares. Both images in cells of CELL×CELL pixels: the mean of each cell, its census over
// 5×5 cells (the order of the neighbours' grey values, which neither gain nor offset of a camera changes: Zabih and
// Woodfill, ECCV 1994), whether there is texture, and how much fine detail each camera shows beside it.
//
// Cells are counted from the image's first pixel; what lies beyond the last whole one is left out. A cell exists where
// all its pixels do, in both images. A code stands two cells right of and below the cell it is of, where its window ends.
#pragma once

#include "stages/moments.hpp"
#include "stages/stream.hpp"

namespace horopter::stages {

/// Where a pixel stands in its cell, and the cell in the image. `live`: a pixel of the image, not of the rows after it.
template <int CELL, int COLUMNS, int ROWS>
struct CellPosition {
  u<bits_for(CELL - 1)> x, y;   // px in the cell
  u<bits_for(COLUMNS)> column;  // cells
  u<bits_for(ROWS + 1)> row;    // beyond the image it may wrap: not live
  bool first = false;           // of the frame
  bool row_starts = false;      // x and column are 0
  bool live = false;
};

/// Counts pixels and cells by the marks.
template <int CELL, int COLUMNS, int ROWS, int WIDTH, int HEIGHT>
class CellRaster {
 public:
  using Position = CellPosition<CELL, COLUMNS, ROWS>;

  Position step(bool first, bool last, u<bits_for(HEIGHT)> height) {
    const bool row_starts = first || row_ended_;
    if (first) {
      at_.x = 0;
      at_.column = 0;
      at_.y = 0;
      at_.row = 0;
      at_.live = true;
    }
#ifdef __HLSC__
    at_.first = first;
    at_.row_starts = row_starts;
    const Position here = at_;
#else  // the same; a CPU would wait for the bytes before it copies all of them
    Position here = at_;
    here.first = first;
    here.row_starts = row_starts;
#endif
    const bool final_row = final_row_;
    final_row_ = rows_left_ == 1;  // a beat early: rows are long
    rows_left_ = first ? height : u<bits_for(HEIGHT)>(rows_left_ - u<1>(last));
    at_.column += u<1>(at_.x == CELL - 1);
    at_.x = u<bits_for(CELL - 1)>(at_.x + lit<1>());
    if (last) {
      at_.x = 0;
      at_.column = 0;
      at_.row += u<1>(at_.y == CELL - 1);
      at_.y = u<bits_for(CELL - 1)>(at_.y + lit<1>());
      at_.live = at_.live && !final_row;
    }
    row_ended_ = last;
    return here;
  }

#ifndef __HLSC__
  /// Where the next pixel stands, if it is neither the first of a row nor of the frame.
  [[nodiscard]] const Position& next() const { return at_; }
  [[nodiscard]] bool begins_row() const { return row_ended_; }
  /// Leaves out pixels, none of them the last of a row.
  void skip(int pixels) {
    const int x = CELL * static_cast<int>(at_.column.value()) + static_cast<int>(at_.x.value()) + pixels;
    at_.column = x / CELL;
    at_.x = x % CELL;
  }
#endif

 private:
  Position at_;
  u<bits_for(HEIGHT)> rows_left_{0};
  bool row_ended_ = true;
  bool final_row_ = false;
};

/// Grey values of a cell and of its quarters, columns of CELL/4 px, in half grey levels.
inline constexpr int mean_bits = 9;
struct CellGrey {
  bool valid = false;
  std::array<u<mean_bits>, 2> mean{};  // left, right
  bool mask = false;
  bool of_skin = false;  // all of its pixels
  std::array<u<mean_bits + 5>, 2>
      detail{};  // sum of the second differences of the quarters: 0 on a ramp, large at an edge
};

/// Sums pixels to cells. Memory: a word for each quarter of a row of cells.
template <int CELL, int WIDTH>
class CellAverager {
  static_assert(CELL == 8 || CELL == 16);

 public:
  static constexpr int quarter = CELL / 4;  // columns, px

 private:
  static constexpr int quarter_bits = bits_for(quarter * CELL * 255);
  using Sum = u<quarter_bits>;

 public:
  /// In every beat, also where step() is left out.
  void begin_step() { memory_.begin_step(); }

  template <class Position>
  CellGrey step(const Position& at, std::array<u<8>, 2> pixel, bool mask, bool of_skin) {
    const bool starts = (at.x & u<2>(quarter - 1)) == 0;
    const bool ends = (at.x & u<2>(quarter - 1)) == quarter - 1;
    std::array<Sum, 2> sum{};
    for (std::size_t i = 0; i < 2; ++i) sum[i] = Sum((starts ? Sum(0) : *running_[i]) + pixel[i]);
    const bool whole = (starts || running_mask_) && mask;
    const bool all_of_skin = (starts || running_of_skin_) && of_skin;
    if (starts) {
      inside_ = at.row_starts || (inside_ && place_ != words - 1);
      place_ = at.row_starts ? Place(0) : Place(place_ + lit<1>());
    }
    const bool stores = at.live && ends && inside_;
    Quarter word;
    if (stores) {
      word = memory_.read(place_);
      if (at.y == 0) word = {{Sum(0), Sum(0)}, true, true};
      for (std::size_t i = 0; i < 2; ++i) word.sum[i] = Sum(word.sum[i] + sum[i]);
      word.mask = word.mask && whole;
      word.of_skin = word.of_skin && all_of_skin;
      memory_.write(place_, word);
    }
    CellGrey out = add_quarter(at.x == quarter - 1, stores && at.y == CELL - 1, word);
    out.valid = out.valid && at.x == CELL - 1;
    for (std::size_t i = 0; i < 2; ++i) *running_[i] = sum[i];
    running_mask_ = whole;
    running_of_skin_ = all_of_skin;
    return out;
  }

#ifndef __HLSC__
  /// Pixels of a row, one after the other.
  struct Pixels {
    const u<8>*left, *right;
    const bool *mask, *of_skin;
    Pixels& operator+=(int count) {
      left += count, right += count, mask += count, of_skin += count;
      return *this;
    }
  };
  /// What the calls of step() come to for the pixels of some quarters of a row, without the last row of a cell; `at`: the
  /// first of them.
  template <class Position>
  void pass_quarters(const Position& at, int count, Pixels pixels) {
    auto place = next_place(at);
    const unsigned last = place + static_cast<unsigned>(count) - 1;
    place_ = Place(last);
    inside_ = last < words;
    if (!at.live) return;
    for (; count > 0 && place < words; --count, ++place, pixels += quarter) sum_quarter(place, at.y == 0, pixels);
  }
  /// The same for one quarter, and any row.
  template <class Position>
  CellGrey pass_quarter(const Position& at, const Pixels& pixels) {
    const auto place = next_place(at);
    place_ = Place(place);
    inside_ = place < words;
    if (!at.live || !inside_) return {};
    CellGrey out = add_quarter(at.x == 0, at.y == CELL - 1, sum_quarter(place, at.y == 0, pixels));
    out.valid = out.valid && at.x == CELL - quarter;
    return out;
  }
#endif

 private:
  static constexpr std::size_t words = static_cast<std::size_t>(WIDTH / quarter);
  using Place = u<bits_for(words)>;
  struct Quarter {
    std::array<Sum, 2> sum{};
    bool mask = false;
    bool of_skin = false;
  };

#ifndef __HLSC__
  template <class Position>
  [[nodiscard]] unsigned next_place(const Position& at) const {
    if (at.column == 0 && at.x == 0) return 0;
    return inside_ ? static_cast<unsigned>(place_.value()) + 1 : static_cast<unsigned>(words);
  }

  [[gnu::always_inline]] Quarter sum_quarter(unsigned place, bool first_row, const Pixels& pixels) {
    unsigned left = 0, right = 0;
    bool whole = true, all_of_skin = true;
    for (int i = 0; i < quarter; ++i) {
      left += pixels.left[i].value();
      right += pixels.right[i].value();
      whole &= pixels.mask[i];
      all_of_skin &= pixels.of_skin[i];
    }
    Quarter word{{Sum(0), Sum(0)}, true, true};
    if (!first_row) word = memory_.read(place);
    word = {{Sum(word.sum[0].value() + left), Sum(word.sum[1].value() + right)},
            word.mask && whole,
            word.of_skin && all_of_skin};
    memory_.write(place, word);
    return word;
  }
#endif

  /// `first` of the cell. Without `counts` nothing changes.
  CellGrey add_quarter(bool first, bool counts, const Quarter& word) {
    CellGrey out;
#ifndef __HLSC__
    if (!counts) return out;
#endif
    for (std::size_t i = 0; i < 2; ++i) {
      const auto grey = u<mean_bits>(shr<quarter_bits - mean_bits>(word.sum[i]));
      const u<mean_bits + 2> total((first ? u<mean_bits + 2>(0) : *total_[i]) + grey);
      const auto curve = resize<mean_bits + 2>((grey + *quarter_2_[i]) - shl<1>(*quarter_1_[i]));
      const auto size = u<mean_bits + 2>(abs(s<mean_bits + 3>(curve)));
      const u<mean_bits + 5> detail((first ? u<mean_bits + 5>(0) : *detail_[i]) + size);
      *quarter_2_[i] = counts ? *quarter_1_[i] : *quarter_2_[i];
      *quarter_1_[i] = counts ? grey : *quarter_1_[i];
      *total_[i] = counts ? total : *total_[i];
      *detail_[i] = counts ? detail : *detail_[i];
      out.mean[i] = u<mean_bits>(shr<2>(total));
      out.detail[i] = detail;
    }
    out.mask = (first || mask_) && word.mask;
    out.of_skin = (first || of_skin_) && word.of_skin;
    mask_ = counts ? out.mask : mask_;
    of_skin_ = counts ? out.of_skin : of_skin_;
    out.valid = counts;
    return out;
  }

  RAM<Quarter, words, min_row_beats> memory_;
  std::array<Kept<Sum>, 2> running_{};
  std::array<Kept<u<mean_bits>>, 2> quarter_1_{}, quarter_2_{};  // the last one, and the one before
  std::array<Kept<u<mean_bits + 2>>, 2> total_{};
  std::array<Kept<u<mean_bits + 5>>, 2> detail_{};
  Place place_{0};
  bool inside_ = true;  // the place is in the memory; kept, as comparing it would take long
  bool running_mask_ = false, running_of_skin_ = false;
  bool mask_ = false, of_skin_ = false;
};

/// What is known of a cell of both images.
inline constexpr int census_bits = 12;
struct CellCodes {
  u<census_bits> left, right;
  bool left_valid = false;   // all of its window lies in the image
  bool right_valid = false;  // and exists
  bool supervised = false;   // the cell exists
  bool textured = false;     // grey values vary along the row, in the left image
  bool of_skin = false;      // not only around it
  Step left_step, right_step;
};

/// Census codes and texture of a cell from the means that come row by row. Memory: four rows of means.
/// The code compares the cell with the 12 of its 24 neighbours that stand as the black squares of a chessboard do.
template <int COLUMNS>
class CellCensus {
 public:
  /// Mean difference from cell to cell of a textured window: 4 grey levels, over 5 rows of 4 differences.
  static constexpr int texture_limit = 4 * 2 * 20;

  void begin_step() { memory_.begin_step(); }

  CellCodes step(u<bits_for(COLUMNS)> column, bool frame_start, bool four_rows_above, const CellGrey& cell) {
    const Above above = memory_.read(column);
    Column now;
    now.cell[0] = {cell.mean[0], cell.mean[1], cell.mask, cell.of_skin};
    for (std::size_t i = 1; i < 5; ++i) now.cell[i] = above.cell[i - 1];
    Above kept;
    for (std::size_t i = 0; i < 4; ++i) kept.cell[i] = now.cell[i];
    memory_.write(column, kept);

    const bool row_start = column == 0;
    const Column& before = columns_->tap(0);
    Change change;
    for (std::size_t i = 0; i < 5; ++i) {
      change.left = typename Change::Sum(change.left + abs(s<mean_bits + 1>(now.cell[i].left - before.cell[i].left)));
      change.right =
          typename Change::Sum(change.right + abs(s<mean_bits + 1>(now.cell[i].right - before.cell[i].right)));
    }
    changes_->push(change);
    columns_->push(now);
    filled_ = row_start ? u<5>(1) : u<5>(cat(filled_, true));

    CellCodes out;
    u<mean_bits + 5> texture(0), texture_right(0);
    for (int x = 0; x < 4; ++x) {
      texture = u<mean_bits + 5>(texture + changes_->tap(x).left);
      texture_right = u<mean_bits + 5>(texture_right + changes_->tap(x).right);
    }
    bool whole = true;
    for (int x = 0; x < 5; ++x) {
      for (std::size_t y = 0; y < 5; ++y) whole = whole && columns_->tap(x).cell[y].mask;
    }
    const Cell centre = columns_->tap(2).cell[2];
    int bit = 0;
    for (int x = 0; x < 5; ++x) {
      for (std::size_t y = 0; y < 5; ++y) {
        if ((static_cast<std::size_t>(x) + y) % 2 == 0) continue;
        const Cell& other = columns_->tap(x).cell[y];
        out.left = out.left | u<census_bits>(u<census_bits>(u<1>(other.left < centre.left)) << bit_of(bit));
        out.right = out.right | u<census_bits>(u<census_bits>(u<1>(other.right < centre.right)) << bit_of(bit));
        ++bit;
      }
    }
    out.left_valid = filled_.bit(4) && four_rows_above;
    out.right_valid = out.left_valid && whole;
    out.supervised = out.left_valid && centre.mask;
    out.of_skin = centre.of_skin;
    out.textured = out.left_valid && texture >= texture_limit;
    const Cell& next = columns_->tap(1).cell[2];
    const bool both_there = out.left_valid && centre.mask && next.mask;
    out.left_step = step_of(both_there, s<mean_bits + 1>(next.left - centre.left));
    out.right_step = step_of(both_there && out.right_valid, s<mean_bits + 1>(next.right - centre.right));

    const s<5> left_misses(s<5>(out.right_valid && texture_right >= texture_limit ? 5 : 0) -
                           s<5>(out.right_valid && texture >= texture_limit ? 8 : 0));
    left_misses_ = frame_start ? Misses(0) : Misses(left_misses_ + left_misses);
    return out;
  }
  /// Of the frame's cells with texture in the right image less than 5/8 as many have it in the left one.
  [[nodiscard]] bool left_sees_less() const { return left_misses_ > 0; }

 private:
  static constexpr u<4> bit_of(int bit) { return {static_cast<unsigned>(bit)}; }

  struct Cell {
    u<mean_bits> left, right;
    bool mask = false;
    bool of_skin = false;
  };
  struct Column {
    std::array<Cell, 5> cell{};  // the newest first
  };

  struct Above {
    std::array<Cell, 4> cell{};
  };
  struct Change {  // from the column before
    using Sum = u<mean_bits + 3>;
    Sum left, right;
  };
  using Misses = s<20>;

  RAM<Above, static_cast<std::size_t>(COLUMNS), min_row_beats> memory_;
  Kept<DelayLine<Column, 5>> columns_;
  Kept<DelayLine<Change, 4>> changes_;
  Misses left_misses_{0};  // 5 for each cell with texture in the right image, -8 in the left one
  u<5> filled_{0};         // bit n: n columns lie to the left
};

/// Sharpness of both cameras over a frame: fine detail beside the contrast of cells, where that is strong. An edge's
/// contrast from cell to cell does not depend on how sharp it is; its second differences do.
class Sharpness {
 public:
  static constexpr int contrast_limit = 12;  // half grey levels from cell to cell
  struct Sums {
    std::array<u<24>, 2> detail{};    // in units of 4 half grey levels
    std::array<u<24>, 2> contrast{};  // in half grey levels
  };

  void step(bool frame_start, bool row_start, const CellGrey& cell) {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto contrast = u<mean_bits>(abs(s<mean_bits + 1>(cell.mean[i] - last_->mean[i])));
      const auto detail = u<mean_bits + 4>(shr<2>(cell.detail[i] + last_->detail[i]));
      const bool counts = !row_start && cell.mask && last_->mask && before_last_mask_ && contrast >= contrast_limit;
      sums_.detail[i] = u<24>((frame_start ? u<24>(0) : sums_.detail[i]) + (counts ? detail : u<mean_bits + 4>(0)));
      sums_.contrast[i] = u<24>((frame_start ? u<24>(0) : sums_.contrast[i]) + (counts ? contrast : u<mean_bits>(0)));
    }
    before_last_mask_ = last_->mask;
    *last_ = cell;
  }
  [[nodiscard]] const Sums& sums() const { return sums_; }

  /// Compares the sums of a frame, whose cells have all come: compare(0) … compare(compare_steps - 1), a beat each, and on
  /// until the next frame; less() is known. What is left of one comparison is 0 before the next. The products of each camera's detail with the other's contrast come a bit a beat, the lowest first,
  /// and so do the comparisons.
  static constexpr int compare_steps = 46;
  void compare(u<6> step) {
    const bool begins = step == 0;
    const bool multiplies = step >= 24 - factor_bits;
    Comparing& c = comparing_;
    const std::array<bool, 2> contrast{contrast_bit(0, step), contrast_bit(1, step)};
    std::array<bool, 2> product{};
    for (std::size_t i = 0; i < 2; ++i) {
      // The lowest bits of the sums are left out.
      const Factor detail = shr<24 - factor_bits>(sums_.detail[i]);
      const auto sum = c.rest[i] + (contrast[1 - i] && multiplies ? detail : Factor(0));
      product[i] = sum.bit(0);
      c.rest[i] = multiplies ? Factor(shr<1>(sum)) : Factor(0);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      // 8 times the one against 5 times the other; 4 times the one against the other.
      const auto five_times = u<1>(product[1 - i]) + u<1>(c.product[1 - i].bit(1)) + u<1>(c.carry[i]);
      c.carry[i] = five_times.bit(1);
      c.less_detail[i] = c.product[i].bit(2) == five_times.bit(0) ? !begins && c.less_detail[i] : five_times.bit(0);
      c.less_contrast[i] = c.contrast[i].bit(1) == contrast[1 - i] ? !begins && c.less_contrast[i] : contrast[1 - i];
    }
    for (std::size_t i = 0; i < 2; ++i) {
      c.product[i] = u<3>(cat(c.product[i], product[i]));
      c.contrast[i] = u<2>(cat(c.contrast[i], contrast[i]));
    }
  }
  /// A camera's detail in proportion to its contrast is below 5/8 of the other's, or its contrast below a quarter.
  [[nodiscard]] bool less(std::size_t camera) const {
    return comparing_.less_detail[camera] || comparing_.less_contrast[camera];
  }

 private:
  static constexpr int factor_bits = 18;
  using Factor = u<factor_bits>;
  struct Comparing {
    std::array<Factor, 2> rest{};    // of the products: the bits to come
    std::array<u<3>, 2> product{};   // their last bits
    std::array<u<2>, 2> contrast{};  // of the contrasts
    std::array<bool, 2> carry{};     // of five times the other's product
    std::array<bool, 2> less_detail{}, less_contrast{};
  };
  [[nodiscard]] bool contrast_bit(std::size_t camera, u<6> step) const {
    return step < 24 && sums_.contrast[camera].bit(static_cast<int>(step.value()));
  }

  Kept<CellGrey> last_;
  bool before_last_mask_ = false;  // the first second difference of `last_` reaches into the cell before it
  Sums sums_;
  Comparing comparing_;
};

}  // namespace horopter::stages
