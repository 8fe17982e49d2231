// SPDX-License-Identifier: Apache-2.0
// registration: a part of `agreement`. Is the right image displaced across the rows against what the cameras' geometry
// says? Each explained cell says by how much it is, beyond the slope of its epipolar line times its shift along the row.
//
// A camera has moved where the median is a limit or more: of the whole image (knocked); of two halves of it, in opposite
// directions (rolled, enlarged); or, with a larger limit, of one half. A median needs no sorting: more than half of the
// cells beyond a limit is the median beyond it.
#pragma once

#include <array>

#include "stages/stream.hpp"

namespace horopter::stages {

/// Displacement across the rows in 1/32 cell, of scores at displacements of -N/2 … N/2 cells, `best` the best of them.
/// Bits that agree fall evenly to both sides, so the fraction is where two lines of equal and opposite slope meet
/// (Shimizu and Okutomi, ICCV 2001); a parabola says too little, down to half.
template <std::size_t N>
s<8> displacement_across(const std::array<u<8>, N>& score, std::size_t best) {
  const std::size_t near_best = best == 0 ? 1 : (best == N - 1 ? N - 2 : best);
  const u<8> above = score[near_best - 1];
  const u<8> below = score[near_best + 1];
  const s<9> rise(below - above);
  const u<9> size(abs(rise));
  const s<9> fall(score[near_best] - (rise.negative() ? below : above));
  const u<9> twice(fall.negative() ? u<9>(0) : u<9>(shl<1>(u<8>(fall))));
  const u<5> fraction = ratio<5>(size < twice ? size : twice, twice);
  const auto whole = shl<5>(s<4>(static_cast<int>(best) - static_cast<int>(N / 2)));
  if (best != near_best) return s<8>(whole);
  return rise.negative() ? s<8>(whole - fraction) : s<8>(whole + fraction);
}

class Registration {
 public:
  using Shift = s<6>;  // along the row, cells

  /// Sums of the displacement, 1/32 cell, and the cells they are of, by quarters of the image: top left, top right,
  /// bottom left, bottom right.
  [[nodiscard]] const std::array<s<20>, 4>& across() const { return counts_.across; }
  [[nodiscard]] const std::array<u<12>, 4>& measured() const { return counts_.measured; }

  /// First of all in every beat. `in_row`: it belongs to a cell of the row, the next beat to the next cell.
  template <class Config>
  void begin_beat(bool in_row, const Config& config) {
    change_ = Change{};
    slope_here_ = slope_;
    slope_ = in_row ? s<28>(slope_ + slope_change_) : slope_row_;
    ready_ = next_;
    next_.slope_row = s<28>(slope_row_ + shl<4>(config.epipolar_row));
    next_.slope_change = s<28>(slope_change_ + config.epipolar_both);
  }

  /// Slope of the epipolar lines at the row's first cell, and from column to column. `first`: of the image.
  template <class Config>
  void start_row(bool first, const Config& config) {
    slope_row_ = first ? s<28>(shl<9>(config.epipolar_slope)) : ready_.slope_row;
    slope_change_ = first ? s<28>(shl<4>(config.epipolar_column)) : ready_.slope_change;
  }

  /// This beat's cell is explained by a shift along the row, `across` off it in 1/32 cell.
  template <class Config>
  void measure(Shift shift, s<8> across, bool right_half, bool lower_half, const Config& config) {
    // Half-way to the place that was found: with lens distortion the lines are curved.
    const auto change = s<8>(sat_signed<8>(s<17>(shr<11>(slope_change_))));
    const auto half_way = shr<6>(product(change, shift));
    const auto slope = s<8>(sat_signed<8>(s<13>(shr<16>(slope_here_) + half_way)));
    const auto expected = shr<3>(product(slope, shift));  // 1/32 cell
    const auto residual = s<8>(sat_signed<8>(s<13>(across - expected)));
    const std::size_t quarter = (lower_half ? 2U : 0U) + (right_half ? 1U : 0U);
    for (std::size_t q = 0; q < 4; ++q) {
      if (q == quarter) {
        change_.across[q] = residual;
        change_.measured[q] = 1;
      }
    }
    const std::array<bool, 5> member{true, !right_half, right_half, !lower_half, lower_half};
    for (std::size_t n = 0; n < 5; ++n) {
      if (!member[n]) continue;
      change_.votes[n] = votes(residual, s<7>(config.moved_limit));
      if (n > 0) change_.half_votes[n - 1] = votes(residual, s<7>(config.moved_half_limit));
    }
  }

  /// Last of all in every beat.
  void end_beat(bool new_frame) {
    Counts c = counts_;
    for (std::size_t i = 0; i < 4; ++i) {
      c.across[i] += change_.across[i];
      c.measured[i] += change_.measured[i];
    }
    for (std::size_t i = 0; i < 5; ++i) c.votes[i].add(change_.votes[i]);
    for (std::size_t i = 0; i < 4; ++i) c.half_votes[i].add(change_.half_votes[i]);
    counts_ = new_frame ? Counts{} : c;
  }

  [[nodiscard]] bool moved() const {
    const auto& n = counts_.measured;
    const auto upper = n[0] + n[1], lower = n[2] + n[3], left = n[0] + n[2], right = n[1] + n[3];
    const std::array<bool, 4> enough{left >= least_half_votes, right >= least_half_votes, upper >= least_half_votes,
                                     lower >= least_half_votes};
    const auto& votes = counts_.votes;
    bool any = upper + lower >= least_votes && votes[0].any();
    for (std::size_t i = 0; i < 4; ++i) any = any || (enough[i] && counts_.half_votes[i].any());
    return any || (enough[0] && enough[1] && votes[1].against(votes[2])) ||
           (enough[2] && enough[3] && votes[3].against(votes[4]));
  }

 private:
  static constexpr int least_votes = 40, least_half_votes = 60;

  /// That a cell is displaced by a limit or more, down and up: 1; else -1.
  struct Vote {
    s<2> down, up;
  };
  /// Above 0: more than half of the cells are.
  struct Votes {
    s<15> down, up;
    [[nodiscard]] bool any() const { return down > 0 || up > 0; }
    void add(const Vote& vote) {
      down += vote.down;
      up += vote.up;
    }
    [[nodiscard]] bool against(const Votes& other) const {
      return (down > 0 && other.up > 0) || (up > 0 && other.down > 0);
    }
  };
  struct Counts {
    std::array<s<20>, 4> across{};
    std::array<u<12>, 4> measured{};
    std::array<Votes, 5> votes{};       // beyond moved_limit: all, left, right, upper, lower half
    std::array<Votes, 4> half_votes{};  // beyond moved_half_limit: the halves
  };
  /// What a beat adds to them.
  struct Change {
    std::array<s<8>, 4> across{};
    std::array<u<1>, 4> measured{};
    std::array<Vote, 5> votes{};
    std::array<Vote, 4> half_votes{};
  };
  struct Slopes {
    s<28> slope_row{0}, slope_change{0};
  };

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

  Counts counts_;
  Change change_;  // of this beat
  s<28> slope_row_{0}, slope_change_{0}, slope_{0}, slope_here_{0};
  Slopes next_, ready_;  // of the next row, of a beat before: the way from register to register is short
};

}  // namespace horopter::stages
