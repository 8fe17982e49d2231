// SPDX-License-Identifier: Apache-2.0
#include "row_spans.hpp"

namespace horopter {

using hls::table::Span;

RowSpans::RowSpans(const CellGrid& grid, const Outline* outline)
    : grid_(grid),
      of_outline_(outline != nullptr),
      spans_(of_outline_ ? outline->spans
                         : std::vector<Span>(static_cast<std::size_t>(grid.scan.height), {0, grid.scan.width})) {
  cells_.reserve(static_cast<std::size_t>(grid.rows));
  for (int row = 0; row < grid.rows; ++row) {
    int first = grid.scan.width;
    int end = 0;
    for (int y = grid.top_of(row); y <= std::min((row + 1) << grid.ny, grid.scan.height - 1); ++y) {
      const Span& span = of_row(y);
      if (span.first == span.end) continue;
      first = std::min(first, span.first);
      end = std::max(end, span.end);
    }
    const int begin = std::max(0, (first >> grid.nx) - 1);
    cells_.emplace_back(begin, std::max(begin, (end + (1 << grid.nx) - 1) >> grid.nx));
  }
}

bool RowSpans::end_beside(int x, int y) const {
  const int across = 1 << grid_.sample_x_log2;
  const int down = 1 << grid_.sample_y_log2;
  for (const int row : {y - down, y, y + down}) {
    if (row < 0 || row >= grid_.scan.height) continue;
    const Span& span = of_row(row);
    const bool left = span.first == 0 || x - across >= span.first;
    const bool right = span.end == grid_.scan.width || x + across < span.end;
    if (span.end == 0 || !left || !right) return true;
  }
  return false;
}

std::pair<int, int> RowSpans::in_cell(int column, int y) const {
  const Span& span = of_row(y);
  return {std::max(grid_.left_of(column), span.first), std::min((column + 1) << grid_.nx, span.end)};
}

void RowSpans::shorten(int y, int left, int right) {
  Span& span = spans_[static_cast<std::size_t>(y)];
  span = left + right < span.end - span.first ? Span{span.first + left, span.end - right} : Span{};
}

}  // namespace horopter
