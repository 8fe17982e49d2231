// SPDX-License-Identifier: Apache-2.0
// Which control points are kept, and what of the image that leaves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "cell_grid.hpp"
#include "control_points.hpp"
#include "grid_errors.hpp"
#include "pixel_kinds.hpp"
#include "row_spans.hpp"

namespace horopter {

/// All, but for those that pixels need which must not be supervised. What it is made of must live as long.
class KeptPoints {
 public:
  struct Tally {
    double supervised = 0;  ///< pixels, samples standing for those around them
    double outside = 0;     ///< of them just outside without the grid
    double ranked = 0;      ///< samples
    double beyond = 0;      ///< of them further off than the share that is wanted may be
  };
  KeptPoints(const CellGrid& grid, const RowSpans& spans, const ControlPoints& controls, const GridErrors& errors);

  /// Keeps the control points without which nothing is off by more than `bound`.
  void keep_within(double bound);
  /// Once more, when errors are known better.
  void count();
  /// Samples of cells that the outline cuts stand for no pixels from now on.
  void leave_out_cut() { leaves_out_cut_ = true; }

  const Tally& tally() const { return tally_; }
  /// Whether this share of the samples lies within the bound of the share that is wanted.
  bool precise(double share) const { return tally_.beyond <= (1 - share) * tally_.ranked; }
  const std::vector<std::uint8_t>& points() const { return kept_; }
  bool is_kept(std::size_t at) const { return kept_[at] != 0; }
  /// Which kinds of a cell's pixels have all their control points.
  ByKind<bool> kinds(int column, int row) const;
  /// Samples that stand for pixels when errors are ranked: all of them, or those of cells that are whole. The others
  /// stand for parts of edges. Those of cells that the outline cuts may be left out.
  bool ranked(const CellErrors& cell, const ByKind<bool>& kept) const;
  const SampleWeights& weights() const { return weights_; }

 private:
  using Place = std::pair<int, int>;  ///< column and row
  bool is_whole(int column, int row) const;
  int carried(int column, int row) const;
  void break_up(std::initializer_list<Place> points);

  CellGrid grid_;
  const RowSpans& spans_;
  const ControlPoints& controls_;
  const GridErrors& errors_;
  SampleWeights weights_;
  bool leaves_out_cut_ = false;
  std::vector<std::uint8_t> kept_;
  std::vector<std::uint8_t> bad_;  ///< cells with something that must not be supervised
  Tally tally_;
};

}  // namespace horopter
