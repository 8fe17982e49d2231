// SPDX-License-Identifier: Apache-2.0
// One grid: its control points, the cells that must be given up, and what is left.
#pragma once

#include <optional>

#include "cell_grid.hpp"
#include "control_points.hpp"
#include "cut_cells.hpp"
#include "expansion.hpp"
#include "grid_errors.hpp"
#include "horopter/map/look_lattice.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/outline_fit.hpp"
#include "kept_points.hpp"
#include "row_spans.hpp"

namespace horopter {

/// Of one spacing, fitted to what a lattice sees.
class GridFit {
 public:
  /// `smooth`: what lies between the lattice's samples follows from them. With an outline, the table has its spans. Lattice,
  /// limits and outline must live as long.
  GridFit(const CellGrid& grid, const LookLattice& lattice, int weight_bits, const MapLimits& limits, bool smooth,
          const Outline* outline);
  GridFit(const GridFit&) = delete;
  GridFit& operator=(const GridFit&) = delete;

  const MapReport& report() const { return report_; }
  /// The share that is wanted leaves out cells that the outline cuts, where the skin bends most. Whether there are any.
  bool leave_out_cut();
  CompiledMap take() const;

 private:
  void find_errors();
  void keep_precise();

  CellGrid grid_;
  const LookLattice& lattice_;
  const MapLimits& limits_;
  int weight_bits_;
  RowSpans spans_;
  ControlPoints controls_;
  std::optional<CutCells> cut_;  ///< with an outline
  GridErrors errors_;
  KeptPoints kept_;
  MapReport report_;
};

}  // namespace horopter
