// SPDX-License-Identifier: Apache-2.0
#include "kept_points.hpp"

#include <algorithm>

namespace horopter {

KeptPoints::KeptPoints(const CellGrid& grid, const RowSpans& spans, const ControlPoints& controls,
                       const GridErrors& errors)
    : grid_(grid), spans_(spans), controls_(controls), errors_(errors), weights_(grid) {}

bool KeptPoints::is_whole(int column, int row) const {
  return std::ranges::all_of(grid_.corners(column, row), [&](std::size_t at) { return is_kept(at); });
}

/// Cells without anything bad that a control point carries.
int KeptPoints::carried(int column, int row) const {
  int count = 0;
  for (int r = std::max(0, row - 1); r <= std::min(row, grid_.rows - 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(column, grid_.columns - 1); ++c) {
      if (bad_[grid_.cell(c, r)] == 0 && is_whole(c, r)) ++count;
    }
  }
  return count;
}

/// Unmaps, of control points that are all mapped, the one that carries least.
void KeptPoints::break_up(std::initializer_list<Place> points) {
  if (!std::ranges::all_of(points, [&](const Place& p) { return is_kept(grid_.point(p.first, p.second)); })) return;
  const auto least = std::ranges::min_element(points, {}, [&](const Place& p) { return carried(p.first, p.second); });
  kept_[grid_.point(least->first, least->second)] = 0;
}

void KeptPoints::keep_within(double bound) {
  kept_ = controls_.mapped();
  bad_.assign(grid_.cells(), 0);
  std::vector<Place> bad;
  spans_.for_cells([&](int column, int row) {
    if (!(errors_.of_cell(column, row).largest() > bound)) return;
    bad.emplace_back(column, row);
    bad_[grid_.cell(column, row)] = 1;
  });
  const auto is_bad = [&](int column, int row, int kind) { return errors_.of_cell(column, row).worst[kind] > bound; };
  // What leaves least choice first.
  for (const auto& [column, row] : bad) {
    if (is_bad(column, row, 0)) kept_[grid_.point(column, row)] = 0;
  }
  for (const auto& [column, row] : bad) {
    if (is_bad(column, row, 2)) break_up({{column, row}, {column, row + 1}});
    if (is_bad(column, row, 1)) break_up({{column, row}, {column + 1, row}});
  }
  for (const auto& [column, row] : bad) {
    break_up({{column, row}, {column + 1, row}, {column, row + 1}, {column + 1, row + 1}});
  }
  count();
}

ByKind<bool> KeptPoints::kinds(int column, int row) const {
  const auto at = grid_.corners(column, row);
  const bool corner = is_kept(at[0]);
  const bool upper = corner && is_kept(at[1]);
  const bool left = corner && is_kept(at[2]);
  return {corner, upper, left, upper && left && is_kept(at[3])};
}

bool KeptPoints::ranked(const CellErrors& cell, const ByKind<bool>& kept) const {
  if (cell.is_cut() && leaves_out_cut_) return false;
  return grid_.every_pixel() ? kept[0] : kept[(grid_.nx > 0 ? 1 : 0) + (grid_.ny > 0 ? 2 : 0)];
}

void KeptPoints::count() {
  tally_ = {};
  spans_.for_cells([&](int column, int row) {
    if (!is_kept(grid_.point(column, row))) return;
    const auto kept = kinds(column, row);
    const CellErrors& cell = errors_.of_cell(column, row);
    const ByKind<double>& weight = weights_.of_cell(column, row);
    const bool counts = ranked(cell, kept);
    for (int kind = 0; kind < kKinds; ++kind) {
      if (!kept[kind]) continue;
      tally_.supervised += weight[kind] * cell.inside[kind];
      tally_.outside += weight[kind] * cell.outside[kind];
      if (!counts || cell.beyond_share >= 0) continue;
      tally_.ranked += cell.inside[kind];
      tally_.beyond += cell.beyond[kind];
    }
    if (!counts || cell.beyond_share < 0) return;
    tally_.ranked += errors_.samples_in(cell);
    tally_.beyond += cell.beyond_share * errors_.samples_in(cell);
  });
}

}  // namespace horopter
