// SPDX-License-Identifier: Apache-2.0
// The kinds of pixels that a cell has, by the control points that have a weight there.
#pragma once

#include <array>

#include "cell_grid.hpp"

namespace horopter {

/// The corner of a cell needs one control point, the rest of its upper and of its left edge two, all others four. Bit 0: right
/// of the cell's left edge, bit 1: below its upper edge.
inline constexpr int kKinds = 4;
template <class Value>
using ByKind = std::array<Value, kKinds>;

/// How many pixels a sample stands for. It depends on whether the image's right and lower borders cut the cell.
class SampleWeights {
 public:
  explicit SampleWeights(const CellGrid& grid);
  const ByKind<double>& of_cell(int column, int row) const {
    return weights_[(column == last_column_ ? 1 : 0) + (row == last_row_ ? 2 : 0)];
  }

 private:
  int last_column_, last_row_;
  std::array<ByKind<double>, 4> weights_;
};

}  // namespace horopter
