// SPDX-License-Identifier: Apache-2.0
#include "control_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "horopter/calib/vectorised.hpp"

namespace horopter {
namespace {

/// Between two rows of control points, 1/64 `part` of the way down.
[[gnu::always_inline]] inline void between_rows(const std::int32_t* above, const std::int32_t* below, std::int32_t part,
                                                std::size_t count, std::int32_t* at) {
  for (std::size_t i = 0; i < count; ++i) at[i] = above[i] * 64 + (below[i] - above[i]) * part;
}

/// Of the cells at both sides of each column, in the rows above and below, the mean of the least and the largest error; 0
/// of none, or of different signs.
[[gnu::always_inline]] inline void agree(const double* low, const double* low_above, const double* high,
                                         const double* high_above, std::size_t columns, double* errors) {
  for (std::size_t c = 0; c < columns; ++c) {
    const double least = std::min(std::min(low[c], low[c + 1]), std::min(low_above[c], low_above[c + 1]));
    const double most = std::max(std::max(high[c], high[c + 1]), std::max(high_above[c], high_above[c + 1]));
    const double mean = 0.5 * (least + most);
    errors[c] = static_cast<bool>((least <= most) & ((least > 0) | (most < 0))) ? mean : 0;
  }
}

/// Of a row of cells, with nothing at both ends: the errors of those that have one, for a minimum and a maximum.
struct Middles {
  explicit Middles(std::size_t cells) : low_x(cells + 2), high_x(cells + 2), low_y(cells + 2), high_y(cells + 2) {
    clear();
  }
  std::vector<double> low_x, high_x, low_y, high_y;

  void clear() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (auto* low : {&low_x, &low_y}) std::ranges::fill(*low, kInfinity);
    for (auto* high : {&high_x, &high_y}) std::ranges::fill(*high, -kInfinity);
  }
  void set(std::size_t cell, Point error) {
    low_x[cell + 1] = high_x[cell + 1] = error.x;
    low_y[cell + 1] = high_y[cell + 1] = error.y;
  }
};

/// Of the error in the middle, to the control points; never so much that these come near the largest error.
double part_given(double error_px, const MapLimits& limits) {
  constexpr double kMost = 0.8;
  const double wanted = std::min(error_px - limits.error_px, kMost * limits.largest_error_px);
  return std::max(0.5, wanted / error_px);
}

double place_of(std::int32_t control) {
  return static_cast<double>(control) / hls::table::control_scale - hls::table::control_offset_px;
}

}  // namespace

ControlPoints::ControlPoints(const CellGrid& grid, const LookLattice& lattice)
    : grid_(grid),
      words_(grid.points(), MapTable::kUnmapped),
      x_(grid.points()),
      y_(grid.points()),
      mapped_(grid.points()) {
  for (int row = 0; row <= grid.rows; ++row) {
    const Point* sources = lattice.sources_of_row(grid.top_of(row));
    for (int column = 0; column <= grid.columns; ++column) {
      const Point source = sources[column << grid.across_log2()];
      if (!std::isnan(source.x)) set(grid.point(column, row), MapTable::encode(source));
    }
  }
}

void ControlPoints::set(std::size_t at, std::uint32_t word) {
  words_[at] = word;
  x_[at] = static_cast<std::int32_t>(word & 0xFFFFU);
  y_[at] = static_cast<std::int32_t>(word >> 16);
  mapped_[at] = word != MapTable::kUnmapped ? 1 : 0;
}

Point ControlPoints::place(std::size_t at) const {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  return is_mapped(at) ? Point{place_of(x_[at]), place_of(y_[at])} : Point{kNan, kNan};
}

void ControlPoints::cross(int row, int y, const std::vector<std::uint8_t>& there, Crossing& crossing) const {
  const std::int32_t below = grid_.part_below(y);
  const std::size_t top = grid_.point(0, row);
  const std::size_t bottom = below != 0 ? grid_.point(0, row + 1) : top;
  const std::size_t columns = grid_.point_columns();
  calib::vectorised<between_rows>(&x_[top], &x_[bottom], below, columns, crossing.x.data());
  calib::vectorised<between_rows>(&y_[top], &y_[bottom], below, columns, crossing.y.data());
  for (std::size_t c = 0; c < columns; ++c) crossing.there[c] = there[top + c] & there[bottom + c];
}

void ControlPoints::centre_errors(const LookLattice& lattice, const MapLimits& limits) {
  if (grid_.nx == 0 && grid_.ny == 0) return;
  const std::int32_t half = grid_.nx == 0 ? 0 : 32;
  const std::size_t middle_x = std::size_t{1} << grid_.nx >> 1;
  const int middle_y = 1 << grid_.ny >> 1;
  const std::size_t columns = grid_.point_columns();
  Crossing crossing(grid_);
  Middles above(columns - 1);
  Middles here(columns - 1);
  std::vector<double> errors_x(columns);
  std::vector<double> errors_y(columns);
  for (int row = 0; row <= grid_.rows; ++row) {
    here.clear();
    if (row < grid_.rows) {
      const int y = grid_.top_of(row) + middle_y;
      cross(row, y, mapped_, crossing);
      const Point* sources = lattice.sources_of_row(y);
      const Reason* reasons = lattice.reasons_of_row(y);
      const std::uint8_t* top = &mapped_[grid_.point(0, row)];
      const std::uint8_t* bottom = &mapped_[grid_.point(0, row + 1)];
      for (std::size_t c = 0; c + 1 < columns; ++c) {
        if ((top[c] & top[c + 1] & bottom[c] & bottom[c + 1]) == 0) continue;
        const std::size_t middle = ((c << grid_.nx) + middle_x) >> grid_.sample_x_log2;
        if (is_excluded(reasons[middle])) continue;  // it will not be supervised
        const Point error = error_of(crossing.at(c, half), sources[middle]);
        // What is too far off to be mended by half is a crease, or no part of the skin.
        const bool smooth = length(error) <= 2 * limits.largest_error_px;
        here.set(c, smooth ? error : Point{0, 0});
      }
    }
    calib::vectorised<agree>(here.low_x.data(), above.low_x.data(), here.high_x.data(), above.high_x.data(), columns,
                             errors_x.data());
    calib::vectorised<agree>(here.low_y.data(), above.low_y.data(), here.high_y.data(), above.high_y.data(), columns,
                             errors_y.data());
    const Point* sources = lattice.sources_of_row(grid_.top_of(row));
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t at = grid_.point(0, row) + c;
      if (!is_mapped(at) || (errors_x[c] == 0 && errors_y[c] == 0)) continue;
      const Point exact = sources[c << grid_.across_log2()];
      const double part = part_given(length({errors_x[c], errors_y[c]}), limits);
      const auto word = MapTable::encode({exact.x - part * errors_x[c], exact.y - part * errors_y[c]});
      if (word != MapTable::kUnmapped) set(at, word);
    }
    std::swap(above, here);
  }
}

}  // namespace horopter
