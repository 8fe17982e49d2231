// SPDX-License-Identifier: Apache-2.0
// plane_sums: for each plane the sum over ROWS×COLUMNS of the cost of a pixel, 0 … 31.
//
// The cost of a pixel is the cyclic difference of the directions in steps of 11.25°, at most 8 (90°), times the larger
// of both magnitudes in quarters, full from 21/8 grey levels per pixel on: below 3/8 noise costs nothing, in any
// plane. A pixel whose own gradient is missing costs nothing in any plane; one whose partner of a shifted plane is
// missing (or in another row) costs 31 there: a plane that cannot be seen cannot win.
//
// In    directions, and the low-passed left grey level and mask of the same beat.
// Out   of the pixel, not of the beat: marks are delayed with it, so what follows needs no offset in columns.
//       sum[n] for planes.shift[n]. valid: the gradient exists, and the window lies in the row to the right.
//       grey: left, in 4 grey levels; exists: there is a pixel.
// Offset: (ROWS − 1) / 2 rows, and that of Sobel and low-pass before it; columns: none after it.
// Both directions of shift share one delayed stream: the left features wait for planes.reach() columns, the right ones
// pass by them. The features are kept for ROWS rows and the costs of the leaving row computed again: less memory than
// costs of every plane.
// Memory: per column ROWS rows of 17 bits, (ROWS + 1) / 2 rows of 8 bits, and a column sum for each plane.
#pragma once

#include "stages/direction.hpp"
#include "stages/planes.hpp"

namespace horopter::stages {

/// Columns by which low-pass and Sobel leave a pixel's gradient late.
inline constexpr int gradient_delay = 2;

template <int BEATS, const auto& PLANES, int ROWS, int COLUMNS, class V = Scalar>
class PlaneSummer {
  static_assert(ROWS >= 5 && ROWS <= 9 && ROWS % 2 == 1, "the window has 5, 7 or 9 rows");
  static_assert(COLUMNS >= 5 && COLUMNS <= 15 && COLUMNS % 2 == 1, "the window has 5 to 15 columns");

 public:
  template <int N>
  using U = typename V::template u<N>;
  using Bit = typename V::bit;

  static constexpr std::size_t planes = PLANES.count;
  static constexpr int largest_cost = 31;
  static constexpr int sum_bits = bits_for(largest_cost * ROWS * COLUMNS);
  /// Beats from a pixel's arrival at the low-pass to its sums, within the row.
  static constexpr int delay = PLANES.reach() + gradient_delay + (COLUMNS - 1) / 2;

  struct In {
    std::array<U<8>, 2> direction{};
    std::array<U<8>, 2> magnitude{};
    Bit saturated = false;
    Bit mask = false;
    U<8> grey;  // of `lowpass`, in this beat
    Bit exists = false;
    Marks marks;
  };
  struct Out {
    std::array<U<sum_bits>, planes> sum{};
    U<6> grey;
    Bit valid = false;
    Bit exists = false;
    Marks marks;
  };

  Out step(const In& in) {
    feature_memory_.begin_step();
    column_memory_.begin_step();

    // Features of this row and of the row that leaves the window, both for the incoming column.
    const auto arriving_at = arriving_.step(in.marks.first, in.marks.last);
    if (arriving_at.row_start) row_parity_ = !row_parity_;
    FeatureRows rows = feature_memory_.read(arriving_at.column);
    FeaturePair entering;
    for (std::size_t i = 0; i < 2; ++i) entering.image[i] = feature(in, i);
    entering.mask = in.mask;
    FeaturePair leaving = rows.row[ROWS - 1];
    leaving.mask = leaving.mask && Bit(arriving_at.rows == ROWS);
    for (std::size_t i = ROWS - 1; i > 0; --i) rows.row[i] = rows.row[i - 1];
    rows.row[0] = entering;
    feature_memory_.write(arriving_at.column, rows);
    entering_.push({entering, row_parity_});
    leaving_.push({leaving, row_parity_});

    // From here on in the column of the delayed left features.
    const Marks marks = marks_.oldest();
    marks_.push(in.marks);
    const auto at = delayed_.step(marks.first, marks.last);
    running_ = running_ || marks.first;
    Column column;
    if (running_) column = column_memory_.read(at.column);
    Out out;
    for (std::size_t n = 0; n < planes; ++n) {
      const U<column_bits> above = at.frame_start_row ? U<column_bits>(0) : column.sum[n];
      const U<5> plus = cost(entering_, PLANES.shift[n]);
      const U<5> minus = cost(leaving_, PLANES.shift[n]);
      column.sum[n] = U<column_bits>(above + (plus - minus));
      out.sum[n] = rows_[n].step(at.row_start, at.column >= COLUMNS, U<sum_bits>(column.sum[n]));
    }

    // Grey value and masks wait for the centre of the window; the low-pass is a row and a column ahead of the gradient.
    const Seen seen{U<6>(in.grey.template bits<7, 2>()), in.exists};
    const Seen here = seen_.oldest();
    seen_.push(seen);
    const Bit gradient = entering_.tap(PLANES.reach()).features.mask;
    const bool enough = at.rows >= half;
    const Centre centre{column.seen[half], column.gradient[half - 1] && Bit(enough)};
    for (std::size_t i = half; i > 0; --i) column.seen[i] = column.seen[i - 1];
    for (std::size_t i = half - 1; i > 0; --i) column.gradient[i] = column.gradient[i - 1];
    column.seen[0] = here;
    column.gradient[0] = gradient;
    if (running_) column_memory_.write(at.column, column);
    const Centre pixel = centres_.oldest();
    centres_.push(centre);
    out.grey = pixel.seen.grey;
    out.exists = pixel.seen.exists && Bit(rows_seen_.oldest());
    rows_seen_.push(at.rows > half);
    out.valid = pixel.gradient && centre.gradient && Bit(at.column >= (COLUMNS - 1) / 2);
    out.marks = centre_marks_.oldest();
    centre_marks_.push(marks);
    return out;
  }

 private:
  static constexpr std::size_t half = (ROWS - 1) / 2;  // rows
  static constexpr int column_bits = bits_for(largest_cost * ROWS);

  struct Feature {
    U<5> direction;  // 11.25°
    U<3> level;      // of magnitude, 0 … 4
  };
  struct FeaturePair {
    std::array<Feature, 2> image{};
    Bit mask = false;
  };
  struct FeatureRows {
    std::array<FeaturePair, ROWS> row{};
  };
  struct Tap {
    FeaturePair features;
    bool row = false;
  };
  struct Seen {
    U<6> grey;
    Bit exists = false;
  };
  struct Centre {
    Seen seen;
    Bit gradient = false;
  };
  struct Column {
    std::array<U<column_bits>, planes> sum{};
    std::array<Seen, half + 1> seen{};
    std::array<Bit, half> gradient{};
  };
  using Taps = DelayLine<Tap, 2 * PLANES.reach() + 1>;

  static Feature feature(const In& in, std::size_t image) {
    Feature result;
    result.direction = U<5>(shr<3>(in.direction[image] + lit<4>()));
    const U<8> m = in.magnitude[image];
    const U<3> level(U<1>(m >= lit<3>()) + U<1>(m >= lit<9>()) + (U<1>(m >= lit<15>()) + U<1>(m >= lit<21>())));
    result.level = select(in.saturated, U<3>(0), level);
    return result;
  }

  static U<5> cost(const Taps& taps, int shift) {
    const Tap& left = taps.tap(PLANES.reach());
    const Tap& right = taps.tap(PLANES.reach() + shift);
    const Feature& l = left.features.image[0];
    const Feature& r = right.features.image[1];
    const U<5> turn = abs(typename V::template s<5>(l.direction - r.direction));
    const U<4> steps = select(turn > lit<8>(), U<4>(8), U<4>(turn));
    const U<3> level = max(l.level, r.level);
    const U<4> once = select(level.bit(0), steps, U<4>(0));
    const U<5> twice = select(level.bit(1), shl<1>(steps), U<5>(0));
    const U<6> four = select(level.bit(2), shl<2>(steps), U<6>(0));
    const U<5> seen = sat<5>(once + twice + four);
    const Bit partner = right.features.mask && Bit(left.row == right.row);
    return select(left.features.mask, select(partner, seen, U<5>(largest_cost)), U<5>(0));
  }

  ColumnMemory<FeatureRows, BEATS> feature_memory_;
  ColumnMemory<Column, BEATS> column_memory_;
  Raster<BEATS, ROWS> arriving_;
  Raster<BEATS, ROWS> delayed_;
  bool row_parity_ = false;
  bool running_ = false;  // a frame's first delayed beat has come: columns count from it
  Taps entering_;
  Taps leaving_;
  DelayLine<Marks, PLANES.reach() + gradient_delay> marks_;
  DelayLine<Seen, PLANES.reach() + 1> seen_;
  std::array<HorizontalSum<COLUMNS, sum_bits, 1, V>, planes> rows_{};
  DelayLine<Centre, (COLUMNS - 1) / 2> centres_;
  DelayLine<bool, (COLUMNS - 1) / 2> rows_seen_;
  DelayLine<Marks, (COLUMNS - 1) / 2> centre_marks_;
};

}  // namespace horopter::stages
