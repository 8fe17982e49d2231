// SPDX-License-Identifier: Apache-2.0
// The drawing of a planned rig: along and across the baseline.
#pragma once

#include <string>
#include <vector>

#include "horopter/plan/watch.hpp"

namespace horopter {

struct PlannedView {
  std::string name;    ///< of the skin
  const Watch* watch;  ///< its places, by what the cameras make of them
};

/// Two views to scale, SVG: along the axis of symmetry downwards, and the baseline or what is across both
/// to the right. `entries` may be null.
std::string draw_plan(const std::string& title, const CameraPair& cameras, const std::vector<PlannedView>& skins,
                      const EntryPlan* entries);

}  // namespace horopter
