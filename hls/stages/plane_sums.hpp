// SPDX-License-Identifier: Apache-2.0
// plane_sums: for each plane the sum over ROWS×COLUMNS of the cost of a pixel, 0 … 31.
//
// The cost of a pixel: the differences of both images' gradients, along the row and across, at most 31. A pixel whose own
// gradient is missing costs nothing in any plane; one whose partner of a shifted plane is missing (or in another row)
// costs 31 there: a plane that cannot be seen cannot win.
//
// evidence: the sum over the same window of the left gradients' size: the cost of a plane on which the right image is
// plain. A plane that costs no less explains nothing of what the left image shows. edges: the pixels of the window with
// an edge in the left image.
//
// In    of `contrast`.
// Out   of the pixel, not of the beat: marks are delayed with it, so what follows needs no offset in columns.
//       sum[n] for planes.shift[n]. known: the pixel exists, and the window lies in the row to the right.
//       grey: left, in 4 grey levels; exists: there is a pixel, and its gradient.
// Offset: (ROWS − 1) / 2 rows, and that of `slopes` before it; columns: none after it.
// Both directions of shift share one delayed stream: the left features wait for planes.reach() columns, the right ones
// pass by them. The features are kept for ROWS rows and the costs of the leaving row computed again: less memory than
// costs of every plane.
// Memory: per column ROWS rows of 24 bits, (ROWS − 1) / 2 rows of 7 bits, a column sum for each plane and the evidence,
// and a count of edges.
#pragma once

#include "stages/contrast.hpp"
#include "stages/planes.hpp"

namespace horopter::stages {

/// Columns by which `slopes` leaves a pixel's gradient late.
inline constexpr int gradient_delay = 1;

template <int BEATS, const auto& PLANES, int ROWS, int COLUMNS, class V = Scalar>
class PlaneSummer {
  static_assert(ROWS >= 5 && ROWS <= 9 && ROWS % 2 == 1, "the window has 5, 7 or 9 rows");
  static_assert(COLUMNS >= 5 && COLUMNS <= 15 && COLUMNS % 2 == 1, "the window has 5 to 15 columns");

 public:
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;
  using Bit = typename V::bit;

  static constexpr std::size_t planes = PLANES.count;
  static constexpr int largest_cost = 31;
  static constexpr int sum_bits = bits_for(largest_cost * ROWS * COLUMNS);
  /// Beats from a pixel's arrival at the low-pass to its sums, within the row.
  static constexpr int delay = PLANES.reach() + gradient_delay + (COLUMNS - 1) / 2;

  using In = Contrast<V>;
  struct Out {
    std::array<U<sum_bits>, planes> sum{};
    U<sum_bits> evidence;
    U<bits_for(ROWS* COLUMNS)> edges;
    U<6> grey;
    Bit known = false;
    Bit exists = false;
    Marks marks;
  };

  Out step(const In& in) {
    const Place place = take(in);
#ifndef __HLSC__
    if (running_) return sum(place, column_memory_.change(place.at.column));
#endif
    Column column;
    if (running_) column = column_memory_.read(place.at.column);
    const Out out = sum(place, column);
    if (running_) column_memory_.write(place.at.column, column);
    return out;
  }

#ifndef __HLSC__
  /// For an engine that needs no sums of a row's first beats: `skip` stands for step() in these, then comes begin(), then
  /// step(). What that puts out is as ever from the COLUMNS-th beat on, but for the marks.
  void skip(const In& in) { take(in); }
  void begin() { rows_ = {}; }
#endif

 private:
  static constexpr std::size_t half = (ROWS - 1) / 2;  // rows
  static constexpr int column_bits = bits_for(largest_cost * ROWS);

  struct Seen {
    U<6> grey;
    Bit exists = false;
  };
  struct Column {
    std::array<U<column_bits>, planes + 1> sum{};
    U<bits_for(ROWS)> edges;
    std::array<Seen, half> seen{};
  };
  /// Where the delayed left features stand.
  struct Place {
    RasterPosition<BEATS, ROWS> at;
    Marks marks;
    Seen seen;
  };

  Out sum(const Place& place, Column& column) {
    const auto& at = place.at;
    Out out;
    for (std::size_t n = 0; n < planes; ++n) {
      const U<5> plus = cost(entering_, PLANES.shift[n]);
      const U<5> minus = cost(leaving_, PLANES.shift[n]);
      out.sum[n] = window_sum(n, column, at, plus, minus);
    }
    out.evidence = window_sum(planes, column, at, size(entering_), size(leaving_));

    const U<bits_for(ROWS)> edges_above = at.frame_start_row ? U<bits_for(ROWS)>(0) : column.edges;
    column.edges = U<bits_for(ROWS)>(edges_above + (edge(entering_) - edge(leaving_)));
    out.edges = edges_.step(at.row_start, at.column >= COLUMNS, U<bits_for(ROWS * COLUMNS)>(column.edges));

    // Grey value and mask wait for the centre of the window.
    const Seen centre{column.seen[half - 1].grey, column.seen[half - 1].exists && Bit(at.rows >= half)};
    for (std::size_t i = half - 1; i > 0; --i) column.seen[i] = column.seen[i - 1];
    column.seen[0] = place.seen;
    const Seen pixel = centres_.oldest();
    centres_.push(centre);
    out.grey = pixel.grey;
    out.exists = pixel.exists;
    out.known = pixel.exists && centre.exists && Bit(at.column >= (COLUMNS - 1) / 2);
    out.marks = centre_marks_.oldest();
    centre_marks_.push(place.marks);
    return out;
  }

  Place take(const In& in) {
    feature_memory_.begin_step();
    column_memory_.begin_step();

    // Features of this row and of the row that leaves the window, both for the incoming column.
    const auto arriving_at = arriving_.step(in.marks.first, in.marks.last);
    if (arriving_at.row_start) row_parity_ = !row_parity_;
#ifdef __HLSC__
    FeatureRows rows = feature_memory_.read(arriving_at.column);
#else
    FeatureRows& rows = feature_memory_.change(arriving_at.column);
#endif
    FeaturePair entering;
    entering.left = in.left;
    entering.right = in.right;
    entering.left_y = in.left_y;
    entering.right_y = in.right_y;
    entering.edge = in.edge;
    entering.mask = in.mask;
    FeaturePair leaving = rows.row[ROWS - 1];
    leaving.mask = leaving.mask && Bit(arriving_at.rows == ROWS);
    for (std::size_t i = ROWS - 1; i > 0; --i) rows.row[i] = rows.row[i - 1];
    rows.row[0] = entering;
#ifdef __HLSC__
    feature_memory_.write(arriving_at.column, rows);
#endif
    entering_.push({entering, row_parity_});
    leaving_.push({leaving, row_parity_});

    // From here on in the column of the delayed left features.
    const Marks marks = marks_.oldest();
    marks_.push(in.marks);
    const auto at = delayed_.step(marks.first, marks.last);
    running_ = running_ || marks.first;
    const Seen seen{U<6>(in.grey.template bits<7, 2>()), in.mask};
    const Seen here = seen_.oldest();
    seen_.push(seen);
    return {at, marks, here};
  }

  struct FeaturePair {
    S<6> left, right;
    S<5> left_y, right_y;
    Bit edge = false;
    Bit mask = false;
  };
  struct FeatureRows {
    std::array<FeaturePair, ROWS> row{};
  };
  struct Tap {
    FeaturePair features;
    bool row = false;
  };
  using Taps = DelayLine<Tap, 2 * PLANES.reach() + 1>;

  template <class At>
  U<sum_bits> window_sum(std::size_t n, Column& column, const At& at, U<5> plus, U<5> minus) {
    const U<column_bits> above = at.frame_start_row ? U<column_bits>(0) : column.sum[n];
    column.sum[n] = U<column_bits>(above + (plus - minus));
    return rows_[n].step(at.row_start, at.column >= COLUMNS, U<sum_bits>(column.sum[n]));
  }

  static U<5> cost(const Taps& taps, int shift) {
    const Tap& left = taps.tap(PLANES.reach());
    const Tap& right = taps.tap(PLANES.reach() + shift);
    const auto across = abs(S<6>(left.features.left_y - right.features.right_y));
    const U<5> difference = sat<5>(U<7>(abs(S<7>(left.features.left - right.features.right)) + across));
    const Bit partner = right.features.mask && Bit(left.row == right.row);
    return select(left.features.mask, select(partner, difference, U<5>(largest_cost)), U<5>(0));
  }

  static U<5> size(const Taps& taps) {
    const FeaturePair& features = taps.tap(PLANES.reach()).features;
    return select(features.mask, sat<5>(U<6>(U<5>(abs(features.left)) + U<4>(abs(features.left_y)))), U<5>(0));
  }
  static U<1> edge(const Taps& taps) {
    const FeaturePair& features = taps.tap(PLANES.reach()).features;
    return select(features.mask && features.edge, U<1>(1), U<1>(0));
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
  DelayLine<Seen, PLANES.reach()> seen_;
  std::array<HorizontalSum<COLUMNS, sum_bits, 1, V>, planes + 1> rows_{};
  HorizontalSum<COLUMNS, bits_for(ROWS* COLUMNS), 1, V> edges_;
  DelayLine<Seen, (COLUMNS - 1) / 2> centres_;
  DelayLine<Marks, (COLUMNS - 1) / 2> centre_marks_;
};

template <Profile P, class V = Scalar>
using PlaneSums = PlaneSummer<P.result_width(), planes_of<P.planes>, P.sum_rows, P.sum_columns, V>;

}  // namespace horopter::stages
