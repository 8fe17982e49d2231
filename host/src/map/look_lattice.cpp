// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/look_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "horopter/calib/vectorised.hpp"

namespace horopter {
namespace {

/// As far beyond the image as the control points of a spacing lie.
int lattice_count(int size, int log2, int spacing_log2) {
  return ((((size - 1) >> spacing_log2) + 1) << (spacing_log2 - log2)) + 1;
}

/// Of samples of a row, of which `inner` is the row, or at the lattice's border the one beside it.
[[gnu::always_inline]] inline void mark_near_limits(const float* margins, const float* inner, std::size_t columns,
                                                    Reason* reasons) {
  const auto bend = [](const float* margin, std::size_t step) __attribute__((always_inline)) {
    const float value = std::abs(*(margin - step) - 2 * *margin + *(margin + step));
    return std::isnan(value) ? 0.0F : value;  // the border of what is seen: the margin is negative there
  };
  const auto mark = [&](std::size_t column, std::size_t beside) __attribute__((always_inline)) {
    // Twice what a quadratic needs.
    const bool near = margins[column] < 0.25F * (bend(margins + beside, 1) + bend(inner + column, columns));
    reasons[column] = static_cast<bool>(near & !is_excluded(reasons[column])) ? Reason::grid : reasons[column];
  };
  mark(0, 1);
  for (std::size_t column = 1; column + 1 < columns; ++column) mark(column, column);
  mark(columns - 1, columns - 2);
}

}  // namespace

LatticeShape LatticeShape::of(const ScanGeometry& geometry, int x_log2, int y_log2, int nx_log2, int ny_log2) {
  return {x_log2, y_log2, lattice_count(geometry.width, x_log2, nx_log2),
          lattice_count(geometry.height, y_log2, ny_log2)};
}

std::vector<Point> LatticeShape::points(const ScanGeometry& geometry) const {
  std::vector<Point> points;
  points.reserve(count());
  for (int row = 0; row < rows; ++row) {
    const double y = row << y_log2;
    for (int column = 0; column < columns; ++column) {
      points.push_back(geometry.to_frame({static_cast<double>(column << x_log2), y}));
    }
  }
  return points;
}

void LookLattice::resize(const LatticeShape& to) {
  shape = to;
  const std::size_t count = to.count();
  sources.resize(count);
  margins.resize(count);
  reasons.resize(count);
}

void LookLattice::take(std::span<const Look> looks, const ScanGeometry& geometry, std::size_t first) {
  Point* const to_sources = &sources[first];
  float* const to_margins = &margins[first];
  Reason* const to_reasons = &reasons[first];
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Look& look = looks[i];
    to_margins[i] = look.margin;
    to_reasons[i] = look.reason;
    to_sources[i] = look.source;
    if (look.reason == Reason::no_source) continue;
    const Point source = geometry.from_frame(look.source);
    to_sources[i] = source;
    if (look.reason == Reason::none && !geometry.holds(source)) to_reasons[i] = Reason::outside;
  }
}

void LookLattice::keep_clear_of_limits() {
  const auto columns = static_cast<std::size_t>(shape.columns);
  const auto rows = static_cast<std::size_t>(shape.rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const float* const of_row = &margins[row * columns];
    const float* const inner = &margins[std::clamp<std::size_t>(row, 1, rows - 2) * columns];
    calib::vectorised<mark_near_limits>(of_row, inner, columns, &reasons[row * columns]);
  }
}

}  // namespace horopter
