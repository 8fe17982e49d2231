// SPDX-License-Identifier: Apache-2.0
#include "outline_controls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace horopter {
namespace {

/// Control points from what is seen between them: least squares.
class ControlFit {
 public:
  /// The control points that may move, of all `points`; those without a place are NaN, and what needs one of them does not
  /// count. `points` must live as long.
  ControlFit(std::vector<std::size_t> free, std::vector<Point>& points);
  /// Whether one of them may move.
  bool moves(const std::array<std::size_t, 4>& at) const;
  /// Of four control points, the upper two first, what must be seen between them, in parts of a cell right of and below
  /// the first; it counts as so many.
  void add(const std::array<std::size_t, 4>& at, double right, double below, Point source, double counts);
  /// Moves the points.
  void solve();
  const std::vector<std::size_t>& free() const { return free_; }

 private:
  struct Use {
    std::int32_t place;  ///< of the point among the free ones
    std::uint32_t equation;
    double weight, counted;  ///< and as it counts
  };
  std::vector<std::size_t> free_;
  std::vector<Point>& points_;
  std::vector<Point> from_;
  std::vector<std::int32_t> place_;  ///< of a point among the free ones, or -1
  std::vector<Use> uses_;
  std::vector<Point> rest_;  ///< what each equation lacks
};

ControlFit::ControlFit(std::vector<std::size_t> free, std::vector<Point>& points)
    : free_(std::move(free)), points_(points), from_(free_.size()) {
  place_.assign(points_.size(), -1);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    place_[free_[i]] = static_cast<std::int32_t>(i);
    from_[i] = points_[free_[i]];
  }
}

bool ControlFit::moves(const std::array<std::size_t, 4>& at) const {
  return std::ranges::any_of(at, [&](std::size_t point) { return place_[point] >= 0; });
}

void ControlFit::add(const std::array<std::size_t, 4>& at, double right, double below, Point source, double counts) {
  const std::array<double, 4> weights{(1 - right) * (1 - below), right * (1 - below), (1 - right) * below,
                                      right * below};
  bool moves = false;
  for (std::size_t k = 0; k < 4; ++k) {
    if (weights[k] == 0) continue;
    source.x -= weights[k] * points_[at[k]].x;
    source.y -= weights[k] * points_[at[k]].y;
    moves = moves || place_[at[k]] >= 0;
  }
  if (!moves || std::isnan(source.x)) return;
  for (std::size_t k = 0; k < 4; ++k) {
    if (weights[k] == 0 || place_[at[k]] < 0) continue;
    uses_.push_back({place_[at[k]], static_cast<std::uint32_t>(rest_.size()), weights[k], counts * weights[k]});
  }
  rest_.push_back(source);
}

void ControlFit::solve() {
  constexpr int kSweeps = 6;
  constexpr double kStay = 1e-3;  // how much the place from which a point comes counts
  // Point by point, each in the order of its equations.
  std::vector<std::size_t> begin(free_.size() + 1);
  for (const Use& use : uses_) ++begin[static_cast<std::size_t>(use.place) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Use> sorted(uses_.size());
  std::vector<double> squares(free_.size(), kStay);
  std::vector<std::size_t> next = begin;
  for (const Use& use : uses_) {
    const auto place = static_cast<std::size_t>(use.place);
    sorted[next[place]++] = use;
    squares[place] += use.counted * use.weight;
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < free_.size(); ++i) {
      Point& point = points_[free_[i]];
      const auto uses = std::span(sorted).subspan(begin[i], begin[i + 1] - begin[i]);
      Point by{kStay * (from_[i].x - point.x), kStay * (from_[i].y - point.y)};
      for (const Use& use : uses) {
        by.x += use.counted * rest_[use.equation].x;
        by.y += use.counted * rest_[use.equation].y;
      }
      by = {by.x / squares[i], by.y / squares[i]};
      point.x += by.x;
      point.y += by.y;
      for (const Use& use : uses) {
        rest_[use.equation].x -= use.weight * by.x;
        rest_[use.equation].y -= use.weight * by.y;
      }
    }
  }
}

/// Control points that must be given a place, and where these begin.
class Continuation {
 public:
  Continuation(const CellGrid& grid, const LookLattice& lattice, const RowSpans& spans, const ControlPoints& controls)
      : grid_(grid), lattice_(lattice), spans_(spans), controls_(controls), known_(grid.points(), Known::not_asked) {}

  /// Those of cut cells that are not on the skin by themselves, each once.
  std::vector<std::size_t> free_points(const CutCells& cut);
  /// Where a free control point would be if the skin went on straight from the two beside it on one side: the mean of all
  /// sides. Those that have none take it from others; what stays without one is no longer free.
  void go_on_straight(std::vector<std::size_t>& free, std::vector<Point>& places);

 private:
  enum class Known : std::uint8_t { not_asked, no, yes };
  bool is_fixed(int column, int row) const;
  bool is_known(int column, int row);

  const CellGrid& grid_;
  const LookLattice& lattice_;
  const RowSpans& spans_;
  const ControlPoints& controls_;
  std::vector<Known> known_;
};

std::vector<std::size_t> Continuation::free_points(const CutCells& cut) {
  std::vector<std::size_t> free;
  std::vector<bool> is_free(grid_.points());
  for (const CutCells::Cell& cell : cut.cells()) {
    const auto [column, row] = cell;
    for (const auto& [c, r] : {std::pair{column, row}, {column + 1, row}, {column, row + 1}, {column + 1, row + 1}}) {
      const std::size_t at = grid_.point(c, r);
      if (is_free[at] || is_fixed(c, r)) continue;
      is_free[at] = true;
      free.push_back(at);
    }
  }
  return free;
}

/// Whether a control point is on the skin by itself.
bool Continuation::is_fixed(int column, int row) const {
  const int x = grid_.left_of(column);
  const int y = grid_.top_of(row);
  const Reason reason = lattice_.reasons[lattice_.index(x, y)];
  return controls_.is_mapped(grid_.point(column, row)) && (reason == Reason::grid || !is_excluded(reason)) &&
         spans_.hold(x, y);
}

bool Continuation::is_known(int column, int row) {
  Known& known = known_[grid_.point(column, row)];
  if (known == Known::not_asked) known = is_fixed(column, row) ? Known::yes : Known::no;
  return known == Known::yes;
}

void Continuation::go_on_straight(std::vector<std::size_t>& free, std::vector<Point>& places) {
  constexpr int kRounds = 3;
  std::vector<std::pair<std::size_t, Point>> found;
  for (int round = 0; round < kRounds; ++round) {
    found.clear();
    for (const std::size_t at : free) {
      if (known_[at] == Known::yes) continue;
      const auto column = static_cast<int>(at % grid_.point_columns());
      const auto row = static_cast<int>(at / grid_.point_columns());
      Point sum{0, 0};
      int count = 0;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}) {
        if (dx != 0 && dy != 0 && count > 0) break;  // across corners only where there is nothing else
        if (column + 2 * dx < 0 || column + 2 * dx > grid_.columns || row + 2 * dy < 0 || row + 2 * dy > grid_.rows)
          continue;
        if (!is_known(column + dx, row + dy) || !is_known(column + 2 * dx, row + 2 * dy)) continue;
        const Point& near = places[grid_.point(column + dx, row + dy)];
        const Point& far = places[grid_.point(column + 2 * dx, row + 2 * dy)];
        sum.x += 2 * near.x - far.x;
        sum.y += 2 * near.y - far.y;
        ++count;
      }
      if (count > 0) found.push_back({at, {sum.x / count, sum.y / count}});
    }
    for (const auto& [at, place] : found) {
      places[at] = place;
      known_[at] = Known::yes;
    }
  }
  std::erase_if(free, [&](std::size_t at) { return known_[at] != Known::yes; });
}

/// Pixels of a cell that the outline cuts, eight at most either way.
void add_equations(const CellGrid& grid, const CutCells& cut, const CutCells::Cell& cell, ControlFit& fit) {
  const auto at = grid.corners(cell.column, cell.row);
  if (!fit.moves(at)) return;
  const std::span<const Point> sources = cut.sources(cell);
  const int across_log2 = std::max(0, grid.nx - 3);
  const int down_log2 = std::max(0, grid.ny - 3);
  const double counts = std::ldexp(1.0, across_log2 + down_log2 - grid.nx - grid.ny);
  const double of_width = std::ldexp(1.0, -grid.nx);
  const double of_height = std::ldexp(1.0, -grid.ny);
  for (int y = 0; y < 1 << grid.ny; y += 1 << down_log2) {
    for (int x = 0; x < 1 << grid.nx; x += 1 << across_log2) {
      const Point& source = sources[static_cast<std::size_t>((y << grid.nx) + x)];
      if (std::isnan(source.x)) continue;
      fit.add(at, x * of_width, y * of_height, source, counts);
    }
  }
}

}  // namespace

void continue_beyond_outline(const CellGrid& grid, const LookLattice& lattice, const RowSpans& spans,
                             const CutCells& cut, ControlPoints& controls) {
  std::vector<Point> places(grid.points());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = controls.place(i);
  Continuation continuation(grid, lattice, spans, controls);
  std::vector<std::size_t> free = continuation.free_points(cut);
  continuation.go_on_straight(free, places);
  ControlFit fit(std::move(free), places);
  for (const CutCells::Cell& cell : cut.cells()) add_equations(grid, cut, cell, fit);
  fit.solve();
  for (const std::size_t at : fit.free()) controls.set(at, MapTable::encode(places[at]));
}

}  // namespace horopter
