// SPDX-License-Identifier: Apache-2.0
// The cells that an outline cuts: near it the skin may bend more than samples show, so every pixel is looked at.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cell_grid.hpp"
#include "control_points.hpp"
#include "expansion.hpp"
#include "grid_errors.hpp"
#include "horopter/map/outline_fit.hpp"
#include "row_spans.hpp"

namespace horopter {

/// Which hold pixels of spans and others, what their pixels see, and how far off these are.
class CutCells {
 public:
  struct Cell {
    int column, row;
  };
  CutCells(const CellGrid& grid, const RowSpans& spans, const Outline& outline);

  /// Row by row.
  const std::vector<Cell>& cells() const { return cells_; }
  /// Of one of them, what its pixels see, row by row as if it was whole; NaN outside of the outline.
  std::span<const Point> sources(const Cell& cell) const { return of_cell(std::span(sources_), cell); }
  /// Of the same pixels; -1 outside of spans, or without all control points.
  std::span<const float> errors(const Cell& cell) const { return of_cell(std::span(errors_), cell); }

  /// Tells them to the errors of all cells.
  void find_errors(const ControlPoints& controls, const RowSpans& spans, const ReadPlaces& inside,
                   const MapLimits& limits, GridErrors& of_grid);
  /// Takes from the ends of spans, in these cells, what is off by more than the largest error: a few pixels in place of the
  /// whole cell. Whether there was such a thing.
  bool trim(double largest_error_px, RowSpans& spans) const;

 private:
  template <class Value>
  std::span<const Value> of_cell(std::span<const Value> all, const Cell& cell) const {
    const auto first = static_cast<std::size_t>(first_[grid_.cell(cell.column, cell.row)]);
    return all.subspan(first, std::size_t{1} << (grid_.nx + grid_.ny));
  }
  /// Where a pixel of one of them is in what is kept of their pixels; -1 of other cells.
  std::ptrdiff_t index(int x, int y) const {
    const std::int32_t first = first_[grid_.cell(x >> grid_.nx, y >> grid_.ny)];
    if (first < 0) return -1;
    const int in_cell = ((y & ((1 << grid_.ny) - 1)) << grid_.nx) + (x & ((1 << grid_.nx) - 1));
    return std::ptrdiff_t{first} + in_cell;
  }
  void mark(const RowSpans& spans);
  void see(const Cell& cell, const Outline& outline);
  CutErrors errors_of(const Cell& cell, const ControlPoints& controls, const RowSpans& spans, const ReadPlaces& inside,
                      double share_error_px);

  CellGrid grid_;
  std::vector<Cell> cells_;
  std::vector<std::int32_t> first_;  ///< of each cell of the grid, where its pixels begin in what follows; -1 of others
  std::vector<Point> sources_;
  std::vector<float> errors_;
};

}  // namespace horopter
