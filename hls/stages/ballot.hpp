// SPDX-License-Identifier: Apache-2.0
// ballot: along the column, the votes of pixels whose left grey level is like the pixel's own.
//
// sum = Σ vote over the pixels up to R rows above and below whose grey level differs by at most `similar` · 4 levels.
// Config dim: half the light (dim.hpp) makes half of the votes, and camera noise more of them wrong: clear takes half as
//       much again.
// Out   skin: sum ≥ `quorum`. clear: −sum ≥ 8 · `clear_quorum` where 19 rows vote, in proportion where fewer do; or sum < 0
//       and the pixel is firm: that nothing is there takes more than a doubt. Without paths (plane_paths) two thirds of
//       that do: noise does not hand its errors from row to row then, and is left undecided as often. Neither where
//       (nearly) nobody votes. exists: there is a pixel.
// Offset: R rows. Memory: per column 2R rows of 15 bits and R bits.
#pragma once

#include <bit>

#include "stages/spread.hpp"

namespace horopter::stages {

template <int BEATS, int R, bool PATHS, class V = Scalar>
class ColumnBallot {
  static_assert(R >= 2 && R <= 12);

 public:
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;
  using Bit = typename V::bit;

  static constexpr int quorum_rows = 19;

  using In = typename VoteSpread<V>::Out;
  struct Config {
    u<4> similar;       // 4 grey levels
    u<8> quorum;        // votes; at least 1
    u<8> clear_quorum;  // 8 votes of 19 rows; at least 1
    u<1> dim;
  };
  struct Out {
    Bit skin = false;
    Bit clear = false;
    Bit exists = false;
    Marks marks;
  };

  Out step(const In& in, const Config& config) {
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
      above = Column{};
    }
    const Ballot own{in.vote, in.grey, in.exists};
    const Ballot centre = above.ballot[R - 1];
    std::array<Sum, 2 * R + 1> votes{};
    for (std::size_t i = 0; i <= 2 * R; ++i) {
      const Ballot& other = i == 2 * R ? own : above.ballot[i];
      const U<7> difference = abs(S<7>(other.grey - centre.grey));
      votes[i] = select(difference <= config.similar, Sum(other.vote), Sum(0));
    }
    for (std::size_t n = 2 * R + 1; n > 1; n = (n + 1) / 2) {
      for (std::size_t i = 0; i < n / 2; ++i) votes[i] = Sum(votes[2 * i] + votes[2 * i + 1]);
      if (n % 2 == 1) votes[n / 2] = votes[n - 1];
    }
    const Bit firm = above.firm.bit(R - 1);
#ifdef __HLSC__
    Column column;
#else
    Column& column = above;
#endif
    for (std::size_t i = 2 * R - 1; i > 0; --i) column.ballot[i] = above.ballot[i - 1];
    column.ballot[0] = own;
    column.firm = U<R>(cat(above.firm, in.firm));
#ifdef __HLSC__
    if (running_) memory_.write(at.column, column);
#endif

    Out out;
    out.skin = votes[0] >= config.quorum;
    out.clear = votes[0] < lit<0>() && (-votes[0] >= needed(config) || firm);
    out.exists = centre.exists;
    out.marks = in.marks;
    return out;
  }

 private:
  using Sum = S<13>;  // 25 · 127 and its sign

  /// What clear takes of so many rows.
  static u<13> needed(const Config& config) {
    constexpr unsigned halves = (16 * (2 * R + 1) * (PATHS ? 3 : 2) / 3 + quorum_rows / 2) / quorum_rows;
    return u<13>(shr<2>(product<2 * halves, 3 * halves>(config.clear_quorum, config.dim != 0)));
  }
  /// `quorum` times one of the two: an addition for each of a factor's bits but the first.
  template <unsigned BRIGHT, unsigned DIM>
  static u<15> product(u<8> quorum, bool dim) {
    if constexpr (BRIGHT == 0 && DIM == 0) return u<15>(0);
    constexpr unsigned bright = std::bit_floor(BRIGHT), dimmed = std::bit_floor(DIM);
    return u<15>((dim ? times<dimmed>(quorum) : times<bright>(quorum)) +
                 product<BRIGHT - bright, DIM - dimmed>(quorum, dim));
  }
  template <unsigned POWER>
  static u<15> times(u<8> quorum) {
    if constexpr (POWER == 0) return u<15>(0);
    return u<15>(shl<std::countr_zero(POWER)>(quorum));
  }

  struct Ballot {
    S<8> vote;
    U<6> grey;
    Bit exists = false;
  };
  struct Column {
    std::array<Ballot, 2 * R> ballot{};  // the nearest row first
    U<R> firm;                           // the nearest row lowest
  };

  ColumnMemory<Column, BEATS> memory_;
  Raster<BEATS, 1> raster_;
  bool running_ = false;
#ifndef __HLSC__
  Column nowhere_;  // before the first frame
#endif
};

template <Profile P, class V = Scalar>
using Ballot = ColumnBallot<P.result_width(), P.ballot_reach, P.paths, V>;

}  // namespace horopter::stages
