// SPDX-License-Identifier: Apache-2.0
// How far the grid of all control points is off, measured once: what is given up is decided by cells then, for one bound of
// the error after another.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "cell_grid.hpp"
#include "control_points.hpp"
#include "expansion.hpp"
#include "horopter/map/look_lattice.hpp"
#include "horopter/map/map_compiler.hpp"
#include "pixel_kinds.hpp"
#include "row_spans.hpp"

namespace horopter {

inline constexpr float kNever = std::numeric_limits<float>::infinity();  ///< error of what must not be supervised

/// The samples whose source would be read inside the image, were all control points there.
struct CellErrors {
  ByKind<float> worst{-1, -1, -1, -1};  ///< largest error
  ByKind<std::uint16_t> inside{};
  ByKind<std::uint16_t> beyond{};   ///< of them further off than the share that is wanted may be
  ByKind<std::uint16_t> outside{};  ///< of them just outside without the grid
  float beyond_share = -1;          ///< of all pixels, where it is known better than by counting samples
  int cut_pixels = -1;              ///< of a cell that the outline cuts, those that have an error; -1 of others

  bool is_cut() const { return cut_pixels >= 0; }
  float largest() const { return std::max(std::max(worst[0], worst[1]), std::max(worst[2], worst[3])); }
};

/// Of all pixels of a cell that the outline cuts.
struct CutErrors {
  ByKind<float> worst{-1, -1, -1, -1};
  int pixels = 0;  ///< that have an error
  int beyond = 0;  ///< of them further off than the share that is wanted may be
};

/// Of a cell at 8 × 8 places, from its corner on, row by row.
inline constexpr std::size_t kPlacesWithin = 64;
using ErrorsWithin = std::array<float, kPlacesWithin>;

/// Of the samples of a lattice, and cell by cell.
class GridErrors {
 public:
  /// `smooth`: what lies between samples follows from them. Lattice and limits must live as long.
  GridErrors(const CellGrid& grid, const LookLattice& lattice, const MapLimits& limits, bool smooth);

  void find(const ControlPoints& controls, const RowSpans& spans, const ReadPlaces& inside);
  void add_cut(int column, int row, const CutErrors& found);
  /// Of cells with samples further off than the share that is wanted may be: the share of their pixels that are. The
  /// samples are the extremes of a cell, so to count them would be to count too many. Whether there are such cells.
  bool interpolate(const ControlPoints& controls, const RowSpans& spans);

  const CellErrors& of_cell(int column, int row) const { return cells_[grid_.cell(column, row)]; }
  /// Of a pixel of the lattice; NaN where none would be read inside the image.
  float of_sample(int x, int y) const { return samples_[lattice_.index(x, y)]; }
  /// The biquadratic through a cell's four samples and those of the cells around that lie on its border.
  ErrorsWithin within(const ControlPoints& controls, int column, int row) const;
  /// In a whole cell, or, of one that the outline cuts, as many as its pixels would be.
  double samples_in(const CellErrors& cell) const;

 private:
  void find_at_samples(const ControlPoints& controls, const RowSpans& spans, const ReadPlaces& inside);
  /// Between samples a cell has what the ones around it say, of which the last may lie beyond the cell and the image.
  void look_between_samples(const ControlPoints& controls, const RowSpans& spans);
  /// A sample in its row's span that must not be supervised.
  bool is_excluded_at(std::size_t sample, int x, int y, const RowSpans& spans) const {
    const Reason reason = lattice_.reasons[sample];
    return is_excluded(reason) && !(reason == Reason::grid && spans.end_beside(x, y));
  }

  CellGrid grid_;
  const LookLattice& lattice_;
  const MapLimits& limits_;
  bool smooth_;
  std::vector<CellErrors> cells_;
  std::vector<float> samples_;
};

}  // namespace horopter
