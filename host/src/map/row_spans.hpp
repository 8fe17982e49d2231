// SPDX-License-Identifier: Apache-2.0
// The pixels that a table may supervise, row by row, and the cells that hold them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "cell_grid.hpp"
#include "horopter/hls/table_format.hpp"
#include "horopter/map/outline_fit.hpp"

namespace horopter {

/// The spans of an outline, or whole rows without one.
class RowSpans {
 public:
  RowSpans(const CellGrid& grid, const Outline* outline);

  bool are_of_an_outline() const { return of_outline_; }
  const std::vector<hls::table::Span>& all() const { return spans_; }
  const hls::table::Span& of_row(int y) const { return spans_[static_cast<std::size_t>(y)]; }
  /// Of a row of the lattice, which may lie below the image.
  const hls::table::Span& of_row_or_last(int y) const { return of_row(std::min(y, grid_.scan.height - 1)); }
  /// A pixel, or for one beyond the image the last of its row and column.
  bool hold(int x, int y) const { return of_row_or_last(y).holds(std::min(x, grid_.scan.width - 1)); }
  /// Of a pixel on the skin: whether it is beside the outline, which is followed there, so that nothing between the two can
  /// be missed. What is further away than the samples is not beside it.
  bool end_beside(int x, int y) const;
  /// The columns of a cell that are in a row's span.
  std::pair<int, int> in_cell(int column, int y) const;
  /// Takes pixels from the ends of a row's span; the cells stay.
  void shorten(int y, int left, int right);

  /// Of a row of cells those that may hold pixels of spans, or have some on their borders: nothing is supervised in others.
  /// From the first on, up to the second without it.
  std::pair<int, int> cells_of_row(int row) const { return cells_[static_cast<std::size_t>(row)]; }
  /// Visits them.
  template <class Visit>
  void for_cells(Visit visit) const {
    for (int row = 0; row < grid_.rows; ++row) {
      const auto [begin, end] = cells_of_row(row);
      for (int column = begin; column < end; ++column) visit(column, row);
    }
  }

 private:
  CellGrid grid_;
  bool of_outline_;
  std::vector<hls::table::Span> spans_;
  std::vector<std::pair<int, int>> cells_;
};

}  // namespace horopter
