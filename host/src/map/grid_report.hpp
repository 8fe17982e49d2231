// SPDX-License-Identifier: Apache-2.0
// What a table says of itself.
#pragma once

#include "cell_grid.hpp"
#include "control_points.hpp"
#include "cut_cells.hpp"
#include "grid_errors.hpp"
#include "horopter/map/look_lattice.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/map_compiler.hpp"
#include "kept_points.hpp"
#include "row_spans.hpp"

namespace horopter {

/// A grid, and what is known of it.
struct KnownGrid {
  const CellGrid& grid;
  const LookLattice& lattice;
  const MapLimits& limits;
  int weight_bits;
  const RowSpans& spans;
  const ControlPoints& controls;
  const CutCells* cut;  ///< or none
  const GridErrors& errors;
  const KeptPoints& kept;
};

/// All but what is known once the table is sealed.
MapReport report_of(const KnownGrid& known);

}  // namespace horopter
