// SPDX-License-Identifier: Apache-2.0
#include "grid_fit.hpp"

#include <algorithm>
#include <cmath>

#include "grid_report.hpp"
#include "outline_controls.hpp"

namespace horopter {

GridFit::GridFit(const CellGrid& grid, const LookLattice& lattice, int weight_bits, const MapLimits& limits,
                 bool smooth, const Outline* outline)
    : grid_(grid),
      lattice_(lattice),
      limits_(limits),
      weight_bits_(weight_bits),
      spans_(grid, outline),
      controls_(grid, lattice),
      errors_(grid, lattice, limits, smooth),
      kept_(grid, spans_, controls_, errors_) {
  controls_.centre_errors(lattice, limits);
  if (outline != nullptr) {
    cut_.emplace(grid, spans_, *outline);
    continue_beyond_outline(grid, lattice, spans_, *cut_, controls_);
  }
  find_errors();
  if (cut_ && cut_->trim(limits.largest_error_px, spans_)) find_errors();
  keep_precise();
}

/// With all control points that no error beyond the largest forbids.
void GridFit::find_errors() {
  const ReadPlaces inside = ReadPlaces::of(grid_.scan, weight_bits_);
  errors_.find(controls_, spans_, inside);
  if (cut_) cut_->find_errors(controls_, spans_, inside, limits_, errors_);
  kept_.keep_within(limits_.largest_error_px);
  if ((!kept_.precise(limits_.share) || cut_) && errors_.interpolate(controls_, spans_)) kept_.count();
}

/// The largest bound by which the share that is wanted stays within its own.
void GridFit::keep_precise() {
  constexpr int kBoundSteps = 6;
  double bound = limits_.largest_error_px;
  if (!kept_.precise(limits_.share)) {
    double low = std::min(limits_.error_px, bound);
    double high = bound;
    for (int step = 0; step < kBoundSteps; ++step) {
      bound = std::sqrt(low * high);
      kept_.keep_within(bound);
      (kept_.precise(limits_.share) ? low : high) = bound;
    }
    if (bound != low) kept_.keep_within(low);
  }
  report_ =
      report_of({grid_, lattice_, limits_, weight_bits_, spans_, controls_, cut_ ? &*cut_ : nullptr, errors_, kept_});
}

bool GridFit::leave_out_cut() {
  if (!cut_) return false;
  kept_.leave_out_cut();
  kept_.keep_within(limits_.largest_error_px);
  keep_precise();
  return true;
}

CompiledMap GridFit::take() const {
  MapTable table(grid_.scan, grid_.nx, grid_.ny);
  for (int row = 0; row <= grid_.rows; ++row) {
    for (int column = 0; column <= grid_.columns; ++column) {
      const std::size_t at = grid_.point(column, row);
      if (kept_.is_kept(at)) table.set_control(column, row, controls_.word(at));
    }
  }
  if (spans_.are_of_an_outline()) table.set_spans(spans_.all());
  return {std::move(table), report_};
}

}  // namespace horopter
