// SPDX-License-Identifier: Apache-2.0
// plane_paths: the sums of a pixel, helped by those of the pixel above: neighbours lie on the same plane or the next,
// seldom elsewhere (dynamic programming along one path, as in semi-global matching).
//
// T(n) = S(n) + 4·min(A(n), A(n±1) + step · px between the planes), A(n) = 3/4 · min((T(n) − min T) / 4, 63) of the
// pixel above: 0 for its best plane, 63 the price of any jump. A pixel without sums, and the row above the frame, have
// no opinion: 0. A fades by a quarter a row: flat areas learn from above, but not for ever.
//
// Out   cost[n] = T(n). evident: known, and min S < 13/16 · evidence: some plane explains what the left image shows.
//       Or strong: more edges than noise makes: then what no plane explains is hidden or far from them all, not in
//       the skin.
// The rest passes through. Offset: none. Memory: per column 6 bits for each plane.
// Without PATHS, T = S and there is no memory.
#pragma once

#include <type_traits>

#include "stages/plane_sums.hpp"

namespace horopter::stages {

template <int BEATS, const auto& PLANES, int ROWS, int COLUMNS, bool PATHS, class V = Scalar>
class PlanePaths {
 public:
  template <int N>
  using U = typename V::template u<N>;
  using Bit = typename V::bit;

  static constexpr std::size_t planes = PLANES.count;
  static constexpr int sum_bits = PlaneSummer<BEATS, PLANES, ROWS, COLUMNS, V>::sum_bits;
  static constexpr int largest_opinion = PATHS ? 63 : 0;
  static constexpr int cost_bits =
      bits_for(PlaneSummer<BEATS, PLANES, ROWS, COLUMNS, V>::largest_cost * ROWS * COLUMNS + 4 * largest_opinion);
  /// A quarter of the price of a step of 1 px between planes: about 5/2 of a pixel's cost per pixel of the window's
  /// sum.
  static constexpr int step_price = 5 * ROWS * COLUMNS / 8;

  /// Pixels of a window with an edge: more of them than noise makes.
  static constexpr int strong_edges = 8;

  using In = typename PlaneSummer<BEATS, PLANES, ROWS, COLUMNS, V>::Out;
  struct Out {
    std::array<U<cost_bits>, planes> cost{};
    U<6> grey;
    Bit known = false;
    Bit evident = false;
    Bit strong = false;
    Bit exists = false;
    Marks marks;
  };

  Out step(const In& in) {
    Out out;
    if constexpr (PATHS) {
      help(in, out.cost);
    } else {
      out.cost = in.sum;
    }
    out.grey = in.grey;
    out.known = in.known;
    const U<sum_bits + 4> needed(shl<3>(in.evidence) + shl<2>(in.evidence) + in.evidence);
    const Bit explained = shl<4>(PLANES.smallest(in.sum)) < needed;
    out.strong = in.edges >= lit<strong_edges>();
    out.evident = in.known && (explained || out.strong);
    out.exists = in.exists;
    out.marks = in.marks;
    return out;
  }

 private:
  struct Column {
    std::array<U<6>, planes> opinion{};
  };
  struct Nothing {};
  using Costs = std::array<U<cost_bits>, planes>;

  void help(const In& in, Costs& costs) {
    memory_.begin_step();
    const auto at = raster_.step(in.marks.first, in.marks.last);
    running_ = running_ || in.marks.first;
#ifdef __HLSC__
    Column above;
    if (running_) above = memory_.read(at.column);
#else
    if (!running_) [[unlikely]]
      nowhere_ = Column{};
    Column& above = running_ ? memory_.change(at.column) : nowhere_;
#endif
    if (at.frame_start_row) [[unlikely]] {
      above.opinion.fill(U<6>(0));
    }
    for (std::size_t n = 0; n < planes; ++n) {
      U<6> price = above.opinion[n];
      if (n > 0) price = min(price, stepped(above.opinion[n - 1], PLANES.shift[n] - PLANES.shift[n - 1]));
      if (n + 1 < planes) price = min(price, stepped(above.opinion[n + 1], PLANES.shift[n + 1] - PLANES.shift[n]));
      costs[n] = U<cost_bits>(in.sum[n] + shl<2>(price));
    }
    const U<cost_bits> best = PLANES.smallest(costs);
#ifdef __HLSC__
    Column column;
#else
    Column& column = above;
#endif
    for (std::size_t n = 0; n < planes; ++n) {
      const U<6> opinion = sat<6>(shr<2>(U<cost_bits>(costs[n] - best)));
      column.opinion[n] = select(in.known, U<6>(opinion - shr<2>(opinion + lit<3>())), U<6>(0));
    }
#ifdef __HLSC__
    if (running_) memory_.write(at.column, column);
#endif
  }

  static U<6> stepped(U<6> opinion, int px) {
    if (step_price * px >= largest_opinion) return U<6>(largest_opinion);
    return sat<6>(opinion + U<6>(step_price * px));
  }

  std::conditional_t<PATHS, ColumnMemory<Column, BEATS>, Nothing> memory_;
  std::conditional_t<PATHS, Raster<BEATS, 1>, Nothing> raster_;
  bool running_ = false;
#ifndef __HLSC__
  Column nowhere_;  // before the first frame
#endif
};

template <Profile P, class V = Scalar>
using Paths = PlanePaths<P.result_width(), planes_of<P.planes>, P.sum_rows, P.sum_columns, P.paths, V>;

}  // namespace horopter::stages
