// SPDX-License-Identifier: Apache-2.0
// The skin's thickness as a user wants it, for both rules: from detection rates that `horopter study detection`
// measures and writes as threshold_table.def and boundary_table.def (thesis 8.4, 11.2.1).
//
// A tolerance is half the skin's thickness as disparity: displaced by so many pixels of the result before or behind the
// skin, half of the pixels are taken for the skin (D50 of 8.4).
#pragma once

#include "horopter/machine/monitor.hpp"
#include "horopter/plan/plan.hpp"

namespace horopter {

struct ToleranceRange {
  double smallest_px = 0;
  double largest_px = 0;
};
/// What a rule can be set to.
ToleranceRange tolerance_range(Decision decision);

/// `thesis`: the threshold in % of T_max = 15·9², linear between the rows of its table. Throws UsageError, naming the
/// range, beyond it.
double threshold_percent_for(double tolerance_px);

/// `compete`: the setting `boundary` whose tolerance is nearest.
struct Boundary {
  int setting = 0;
  double tolerance_px = 0;  ///< what it has
};
/// Throws UsageError, naming the range, beyond its table by more than half a step.
Boundary boundary_for(double tolerance_px);

/// Sets the rule of the settings to a tolerance; gives the one it then has. Throws UsageError.
double set_tolerance(Settings& settings, double tolerance_px);

/// The tolerance with which half of the supervised pixels have a thickness across the skin of at least so many mm, by
/// the camera model. Throws std::invalid_argument where the cameras cannot watch the surface, or nothing is supervised.
double tolerance_for_mm(double thickness_mm, const CameraPair& cameras, const Surface& surface,
                        const MachineProfile& profile, const ScanGeometry& geometry);

/// D95 of the settings: displaced by so many pixels of the result, 95 % of the pixels are still taken for the skin. The
/// steps of a moving skin are planned for it. `thesis`: Table 11.2 for the threshold, linear between its rows, above
/// them that of the last. `compete`: kD95_px, from the default boundary on. Throws UsageError below both, where nobody
/// has measured it.
double d95_px(const Settings& settings);

}  // namespace horopter
