// SPDX-License-Identifier: Apache-2.0
// Rows: whether the cameras serve the neighbours that compete, along whose rows the skin's image is shifted.
#pragma once

#include <stdexcept>
#include <string>

#include "horopter/base/profile.hpp"
#include "horopter/map/look_lattice.hpp"
#include "horopter/map/map.hpp"
#include "horopter/skin/skin.hpp"

namespace horopter {

/// What a rule asks of the view. Throws UsageError where the profile does not have the rule.
ViewLimits view_limits(const MachineProfile& profile, Decision decision);

/// The cameras do not serve the neighbours that compete: at more than this share of the pixels that could be supervised
/// otherwise the epipolar line leaves the row.
class RowError : public std::runtime_error {
 public:
  static constexpr double kLargestShare = 0.9;
  using std::runtime_error::runtime_error;
  /// What to do about it, as the end of a message "…; expected …".
  static std::string expected();
};
/// Throws RowError.
void check_rows(const RowCount& rows, const ViewLimits& view);

/// The same of what a lattice sees.
void check_rows(const LookLattice& lattice, const ScanGeometry& geometry, const ViewLimits& view);

/// Share of the supervised pixels whose epipolar line leaves the row: 0 of tables that were made within these limits.
/// For tables with a rig.
double share_beyond_rows(const MapSet& maps, const MachineProfile& profile, const ViewLimits& view);

}  // namespace horopter
