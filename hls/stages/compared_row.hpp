// SPDX-License-Identifier: Apache-2.0
// compared_row: what `agreement` compares in a row of cells, all of it at once, in the lanes of the CPU's vectors. The
// hardware takes a beat for each pair of columns; the best of them are the same.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace horopter::stages {

/// COLUMNS: most cells of a row. HALF: columns of a window beside its middle one. ROWS: of cells, of a window. ACROSS:
/// displacements across the rows, an odd number. Codes have at most 12 bits.
template <std::size_t COLUMNS, std::size_t HALF, std::size_t ROWS, std::size_t ACROSS>
class ComparedRow {
  static_assert(ROWS == 3, "three codes are added at once");
  static_assert(ACROSS == 5, "places() says which counts first where scores are equal");

 public:
  static constexpr std::uint16_t code_mask = 0xFFF;
  /// Of an image, so many rows of cells; `there` is code_mask where the cell has a code, else 0.
  template <std::size_t N>
  struct Codes {
    std::array<std::array<std::uint16_t, COLUMNS>, N> code, there;
  };
  /// By column of the left image, or of the right one. Nothing fits where a score is 0.
  struct BestLeft {
    std::array<std::uint16_t, COLUMNS> score, place, above, below, near_score;
    std::array<std::int16_t, COLUMNS> shift, near_shift;
    std::array<std::uint16_t, COLUMNS> before, behind;  // best scores at shifts -1 and 1
  };
  struct BestRight {
    std::array<std::uint16_t, COLUMNS> score, x, near_score, near_x;
  };

  Codes<ROWS> left;                // the newest row first
  Codes<ROWS + ACROSS - 1> right;  // displacement d compares left row i with right row i + ACROSS - 1 - d
  BestLeft best_left;
  BestRight best_right;

  /// Of `count` columns at shifts from `lowest` to `highest`, cells.
  void compare(int count, int lowest, int highest) {
    best_left = BestLeft{};
    best_right = BestRight{};
    for (int shift = lowest; shift <= highest; ++shift) {
      const int first = std::max(0, -shift);
      const int columns = count - std::max(shift, 0) - first;
      if (columns > 0) compare_at(shift, static_cast<std::size_t>(first), static_cast<std::size_t>(columns));
    }
  }

 private:
  using Row = std::array<std::uint16_t, COLUMNS>;

  /// Bits that agree in a column of three cells. Lanes of 16 bits: a full adder over the three, then the bits of both sums.
  static std::uint16_t alike(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    const unsigned ones = a ^ b ^ c;
    const unsigned twos = (a & b) | (c & (a ^ b));
    const auto pairs = [](unsigned v) { return (v & 0x5555U) + (v >> 1 & 0x5555U); };
    const auto fours = [](unsigned v) { return (v & 0x3333U) + (v >> 2 & 0x3333U); };
    const unsigned nibbles = fours(pairs(ones)) + 2 * fours(pairs(twos));  // at most 12 each
    const unsigned bytes = (nibbles & 0x0F0FU) + (nibbles >> 4 & 0x0F0FU);
    return static_cast<std::uint16_t>((bytes + (bytes >> 8)) & 0xFFU);
  }

  void compare_at(int shift, std::size_t first, std::size_t columns) {
    const auto partner = static_cast<std::size_t>(static_cast<int>(first) + shift);
    for (std::size_t d = 0; d < ACROSS; ++d) score_displaced(d, first, partner, columns);
    // First those that count where scores are equal.
    static constexpr std::array<std::uint16_t, ACROSS> kPlaces{2, 1, 3, 0, 4};
    for (std::size_t i = 0; i < columns; ++i) {
      std::uint16_t best = 0, place = 0, near = 0;
      for (std::size_t n = 0; n < ACROSS; ++n) {
        const std::uint16_t p = kPlaces[n];
        const bool better = n == 0 || score_[p][i] > best;
        best = better ? score_[p][i] : best;
        place = better ? p : place;
        near = std::max(near, near_[p][i]);
      }
      best_[i] = best;
      place_[i] = place;
      best_near_[i] = near;
    }
    const auto here = static_cast<std::int16_t>(shift);
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t x = first + i;
      const bool better = best_[i] > best_left.score[x];
      const bool upper = place_[i] == 1, middle = place_[i] == 2;
      const std::uint16_t above = upper ? score_[0][i] : middle ? score_[1][i] : score_[2][i];
      const std::uint16_t below = upper ? score_[2][i] : middle ? score_[3][i] : score_[4][i];
      best_left.score[x] = better ? best_[i] : best_left.score[x];
      best_left.place[x] = better ? place_[i] : best_left.place[x];
      best_left.above[x] = better ? above : best_left.above[x];
      best_left.below[x] = better ? below : best_left.below[x];
      best_left.shift[x] = better ? here : best_left.shift[x];
      const bool nearer = best_near_[i] > best_left.near_score[x];
      best_left.near_score[x] = nearer ? best_near_[i] : best_left.near_score[x];
      best_left.near_shift[x] = nearer ? here : best_left.near_shift[x];
    }
    if (shift == -1 || shift == 1) {
      auto& beside = shift < 0 ? best_left.before : best_left.behind;
      std::copy_n(best_.begin(), columns, beside.begin() + static_cast<std::ptrdiff_t>(first));
    }
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t x = partner + i;
      const auto from = static_cast<std::uint16_t>(first + i);
      const bool better = best_[i] > best_right.score[x];
      best_right.score[x] = better ? best_[i] : best_right.score[x];
      best_right.x[x] = better ? from : best_right.x[x];
      const bool nearer = best_near_[i] > best_right.near_score[x];
      best_right.near_score[x] = nearer ? best_near_[i] : best_right.near_score[x];
      best_right.near_x[x] = nearer ? from : best_right.near_x[x];
    }
  }

  /// Windows of 2·HALF + 1 columns, and of 3; columns that one of the images does not have count nothing.
  void score_displaced(std::size_t d, std::size_t first, std::size_t partner, std::size_t columns) {
    std::array<std::uint16_t, COLUMNS + 2 * HALF> alike_columns;
    std::fill_n(alike_columns.begin(), HALF, std::uint16_t{0});
    for (std::size_t i = 0; i < columns; ++i) {
      std::array<std::uint16_t, ROWS> same;
      for (std::size_t r = 0; r < ROWS; ++r) {
        const std::size_t o = r + ACROSS - 1 - d;
        same[r] = static_cast<std::uint16_t>(~(left.code[r][first + i] ^ right.code[o][partner + i]) &
                                             left.there[r][first + i] & right.there[o][partner + i]);
      }
      alike_columns[HALF + i] = alike(same[0], same[1], same[2]);
    }
    std::fill_n(alike_columns.begin() + static_cast<std::ptrdiff_t>(HALF + columns), HALF, std::uint16_t{0});
    for (std::size_t i = 0; i < columns; ++i) {
      const std::uint16_t* const column = &alike_columns[i];
      const auto near = static_cast<std::uint16_t>(column[HALF - 1] + column[HALF] + column[HALF + 1]);
      std::uint16_t sum = near;
      for (std::size_t k = 2; k <= HALF; ++k)
        sum = static_cast<std::uint16_t>(sum + column[HALF - k] + column[HALF + k]);
      near_[d][i] = near;
      score_[d][i] = sum;
    }
  }

  std::array<Row, ACROSS> score_, near_;
  Row best_, place_, best_near_;
};

}  // namespace horopter::stages
