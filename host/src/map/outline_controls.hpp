// SPDX-License-Identifier: Apache-2.0
// Control points beyond an outline.
#pragma once

#include "cell_grid.hpp"
#include "control_points.hpp"
#include "cut_cells.hpp"
#include "horopter/map/look_lattice.hpp"
#include "row_spans.hpp"

namespace horopter {

/// They get places that continue the skin inside, so that the cells that the outline cuts are right up to it.
void continue_beyond_outline(const CellGrid& grid, const LookLattice& lattice, const RowSpans& spans,
                             const CutCells& cut, ControlPoints& controls);

}  // namespace horopter
