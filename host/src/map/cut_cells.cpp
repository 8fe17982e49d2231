// SPDX-License-Identifier: Apache-2.0
#include "cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace horopter {

using hls::table::Span;

CutCells::CutCells(const CellGrid& grid, const RowSpans& spans, const Outline& outline)
    : grid_(grid), first_(grid.cells(), -1) {
  mark(spans);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  sources_.assign(cells_.size() << (grid.nx + grid.ny), {kNan, kNan});
  for (const Cell& cell : cells_) see(cell, outline);
}

void CutCells::mark(const RowSpans& spans) {
  const int width = grid_.scan.width;
  for (int row = 0; row < grid_.rows; ++row) {
    int least_first = width;
    int largest_first = 0;
    int least_end = width;
    int largest_end = 0;
    for (int y = grid_.top_of(row); y < grid_.below(row); ++y) {
      const Span& span = spans.of_row(y);
      const int first = span.end == 0 ? width : span.first;
      least_first = std::min(least_first, first);
      largest_first = std::max(largest_first, first);
      least_end = std::min(least_end, span.end);
      largest_end = std::max(largest_end, span.end);
    }
    for (int column = least_first >> grid_.nx; grid_.left_of(column) < largest_end; ++column) {
      if (grid_.left_of(column) >= largest_first && grid_.right_of(column) <= least_end) continue;
      first_[grid_.cell(column, row)] = static_cast<std::int32_t>(cells_.size() << (grid_.nx + grid_.ny));
      cells_.push_back({column, row});
    }
  }
}

void CutCells::see(const Cell& cell, const Outline& outline) {
  for (int y = grid_.top_of(cell.row); y < grid_.below(cell.row); ++y) {
    const Span& whole = outline.span(y);
    const int first = std::max(grid_.left_of(cell.column), whole.first);
    const int end = std::min((cell.column + 1) << grid_.nx, whole.end);
    if (first >= end) continue;
    const auto at = static_cast<std::size_t>(index(first, y));
    outline.see(first, y, std::span(sources_).subspan(at, static_cast<std::size_t>(end - first)));
  }
}

void CutCells::find_errors(const ControlPoints& controls, const RowSpans& spans, const ReadPlaces& inside,
                           const MapLimits& limits, GridErrors& of_grid) {
  errors_.assign(sources_.size(), -1);
  for (const Cell& cell : cells_) {
    of_grid.add_cut(cell.column, cell.row, errors_of(cell, controls, spans, inside, limits.error_px));
  }
}

CutErrors CutCells::errors_of(const Cell& cell, const ControlPoints& controls, const RowSpans& spans,
                              const ReadPlaces& inside, double share_error_px) {
  CutErrors found;
  const auto corners = grid_.corners(cell.column, cell.row);
  for (int y = grid_.top_of(cell.row); y < grid_.below(cell.row); ++y) {
    const std::int32_t below = grid_.part_below(y);
    const auto is_there = [&](std::size_t side) {
      return controls.is_mapped(corners[side]) && (below == 0 || controls.is_mapped(corners[2 + side]));
    };
    if (!is_there(0)) continue;
    const bool whole = is_there(1);
    const auto down = [&](std::size_t side) {
      return between(controls.at(corners[side]), controls.at(corners[2 + side]), below);
    };
    const Expansion left = down(0);
    const Expansion next = down(1);
    const auto first = static_cast<std::size_t>(index(grid_.left_of(cell.column), y));
    const auto [begin, end] = spans.in_cell(cell.column, y);
    for (int x = begin; x < end; ++x) {
      const std::int32_t right = grid_.part_right(x);
      if (right != 0 && !whole) break;
      const Expansion here = between(left, next, right);
      if (!inside.hold(here)) continue;
      const std::size_t at = first + static_cast<std::size_t>(x - grid_.left_of(cell.column));
      const double exactly = length(error_of(here, sources_[at]));
      const float error = std::isnan(exactly) ? kNever : static_cast<float>(exactly);
      float& worst = found.worst[(right != 0 ? 1U : 0U) + (below != 0 ? 2U : 0U)];
      worst = std::max(worst, error);
      errors_[at] = error;
      ++found.pixels;
      found.beyond += error > share_error_px ? 1 : 0;
    }
  }
  return found;
}

bool CutCells::trim(double largest_error_px, RowSpans& spans) const {
  bool trimmed = false;
  for (int y = 0; y < grid_.scan.height; ++y) {
    const Span here = spans.of_row(y);
    // How many pixels to take from x on, in a direction.
    const auto taken = [&](int x, int direction) {
      int last = 0;
      for (int count = 1; here.holds(x); ++count, x += direction) {
        const std::ptrdiff_t at = index(x, y);
        if (at < 0) break;
        if (errors_[static_cast<std::size_t>(at)] > largest_error_px) last = count;
      }
      return last;
    };
    const int left = taken(here.first, 1);
    const int right = taken(here.end - 1, -1);
    if (left + right == 0) continue;
    trimmed = true;
    spans.shorten(y, left, right);
  }
  return trimmed;
}

}  // namespace horopter
