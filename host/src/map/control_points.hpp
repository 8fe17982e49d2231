// SPDX-License-Identifier: Apache-2.0
// The control points of a grid, before any is given up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cell_grid.hpp"
#include "expansion.hpp"
#include "horopter/map/map_compiler.hpp"

namespace horopter {

/// Between two rows of control points: what a row of pixels has at each column, and whether the control points are there.
struct Crossing {
  explicit Crossing(const CellGrid& grid)
      : x(grid.point_columns()), y(grid.point_columns()), there(grid.point_columns()) {}
  std::vector<std::int32_t> x, y;
  std::vector<std::uint8_t> there;

  /// Right of a column, 1/64 `part` of the way to the next. Of the last one there is no next.
  Expansion at(std::size_t column, std::int32_t part) const {
    return between({x[column], y[column]}, {x[column + 1], y[column + 1]}, part);
  }
};

/// As the table holds them, and as numbers. Those without a source are not mapped.
class ControlPoints {
 public:
  /// At what the lattice sees.
  ControlPoints(const CellGrid& grid, const LookLattice& lattice);

  /// Between exact control points a smooth map errs to one side, most in the middle of the cell; half of that error
  /// given to the control points leaves half of it. Where all cells around a control point agree on the side: the mean
  /// of the largest and the smallest. Cells whose middle is not supervised have no say. Where half is more than the share
  /// that is wanted may err, more is given: the middle, where the error changes least, comes back within that.
  void centre_errors(const LookLattice& lattice, const MapLimits& limits);

  void set(std::size_t at, std::uint32_t word);
  std::uint32_t word(std::size_t at) const { return words_[at]; }
  Expansion at(std::size_t at) const { return {x_[at], y_[at]}; }
  /// In the scan's coordinates; NaN where it is not mapped.
  Point place(std::size_t at) const;
  bool is_mapped(std::size_t at) const { return mapped_[at] != 0; }
  const std::vector<std::uint8_t>& mapped() const { return mapped_; }

  /// Of a row of pixels in a row of cells; `there` says which control points count.
  void cross(int row, int y, const std::vector<std::uint8_t>& there, Crossing& crossing) const;

 private:
  CellGrid grid_;
  std::vector<std::uint32_t> words_;
  std::vector<std::int32_t> x_, y_;
  std::vector<std::uint8_t> mapped_;
};

}  // namespace horopter
