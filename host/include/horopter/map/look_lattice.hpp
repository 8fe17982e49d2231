// SPDX-License-Identifier: Apache-2.0
// What left pixels of a lattice see of a skin.
#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "horopter/image/scan.hpp"
#include "horopter/skin/skin.hpp"

namespace horopter {

/// Never supervised, wherever the source lies.
constexpr bool is_excluded(Reason reason) { return reason != Reason::none && reason != Reason::outside; }

/// Left pixels that are looked at: every 2^x_log2-th of 2^y_log2-th rows, and as far beyond the image as control points
/// lie.
struct LatticeShape {
  int x_log2 = 0, y_log2 = 0;
  int columns = 0, rows = 0;
  friend auto operator<=>(const LatticeShape&, const LatticeShape&) = default;

  /// For control points that are 2^nx_log2 and 2^ny_log2 pixels apart.
  static LatticeShape of(const ScanGeometry& geometry, int x_log2, int y_log2, int nx_log2, int ny_log2);
  std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  /// Row by row, in frame coordinates.
  std::vector<Point> points(const ScanGeometry& geometry) const;
};

/// What they see, side by side: what is asked for most takes least memory.
struct LookLattice {
  LatticeShape shape;
  std::vector<Point> sources;  ///< in the scan's coordinates; NaN where there is none
  std::vector<float> margins;
  std::vector<Reason> reasons;

  void resize(const LatticeShape& to);
  /// Of a pixel of the lattice.
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y >> shape.y_log2) * static_cast<std::size_t>(shape.columns) +
           static_cast<std::size_t>(x >> shape.x_log2);
  }
  const Point* sources_of_row(int y) const { return &sources[index(0, y)]; }
  const Reason* reasons_of_row(int y) const { return &reasons[index(0, y)]; }
  /// Takes looks, from the `first` of the lattice on: sources to the scan's coordinates, and those outside the image by
  /// name.
  void take(std::span<const Look> looks, const ScanGeometry& geometry, std::size_t first);
  /// Gives to the grid what lies so near the limits of angle and scale that the space between the samples may cross them:
  /// between two samples a smooth margin falls below both by at most an eighth of its second difference.
  void keep_clear_of_limits();
};

}  // namespace horopter
