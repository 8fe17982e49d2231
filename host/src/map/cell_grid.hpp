// SPDX-License-Identifier: Apache-2.0
// Where cells, their control points and the samples in them lie.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "horopter/image/scan.hpp"
#include "horopter/map/look_lattice.hpp"

namespace horopter {

/// The cells of a scan, a control point at each corner; the samples of a lattice are in them.
struct CellGrid {
  /// Cells of 2^nx and 2^ny pixels. The lattice holds every pixel, or at least the four samples of each cell.
  CellGrid(const ScanGeometry& scan_of, int nx_of, int ny_of, const LatticeShape& lattice)
      : scan(scan_of),
        nx(nx_of),
        ny(ny_of),
        columns(((scan.width - 1) >> nx) + 1),
        rows(((scan.height - 1) >> ny) + 1),
        sample_x_log2(lattice.x_log2),
        sample_y_log2(lattice.y_log2) {}

  ScanGeometry scan;
  int nx, ny;
  int columns, rows;  ///< of cells; there is one more of control points
  int sample_x_log2, sample_y_log2;

  std::size_t cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t points() const { return point_columns() * static_cast<std::size_t>(rows + 1); }
  std::size_t point_columns() const { return static_cast<std::size_t>(columns + 1); }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  std::size_t point(int column, int row) const {
    return static_cast<std::size_t>(row) * point_columns() + static_cast<std::size_t>(column);
  }
  /// Control points of a cell, the upper two first.
  std::array<std::size_t, 4> corners(int column, int row) const {
    const std::size_t top = point(column, row);
    const std::size_t bottom = point(column, row + 1);
    return {top, top + 1, bottom, bottom + 1};
  }

  /// The pixels of cells: of a column up to `right_of`, of a row up to `below`, both without it.
  int left_of(int column) const { return column << nx; }
  int right_of(int column) const { return std::min((column + 1) << nx, scan.width); }
  int top_of(int row) const { return row << ny; }
  int below(int row) const { return std::min((row + 1) << ny, scan.height); }
  /// How far right of or below the control point a pixel is, in 64ths of its cell.
  int part_right(int x) const { return (x & ((1 << nx) - 1)) << (6 - nx); }
  int part_below(int y) const { return (y & ((1 << ny) - 1)) << (6 - ny); }

  bool every_pixel() const { return sample_x_log2 == 0 && sample_y_log2 == 0; }
  /// How many samples a whole cell has, either way.
  int across_log2() const { return nx - sample_x_log2; }
  int down_log2() const { return ny - sample_y_log2; }
  /// Samples of a row that lie before a pixel of it.
  std::size_t samples_before(int x) const {
    return static_cast<std::size_t>((x + (1 << sample_x_log2) - 1) >> sample_x_log2);
  }
  /// Samples in the image, either way.
  int sample_columns() const { return ((scan.width - 1) >> sample_x_log2) + 1; }
  int sample_rows() const { return ((scan.height - 1) >> sample_y_log2) + 1; }
};

}  // namespace horopter
