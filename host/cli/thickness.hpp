// SPDX-License-Identifier: Apache-2.0
// --tolerance and --thickness: how thick the skin is to be, instead of a rule's own setting.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "commands.hpp"
#include "horopter/base/profile.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/image/scan.hpp"
#include "horopter/plan/plan.hpp"
#include "horopter/skin/rig_skin.hpp"

namespace horopter::cli {

struct ThicknessOption {
  std::optional<double> tolerance_px;
  std::optional<double> thickness_mm;
};

/// Both options, which exclude each other.
void add_thickness(CLI::App& command, ThicknessOption& option);

/// {"smallest", "mean", "largest"}.
nlohmann::ordered_json range_json(const Summary& summary);

/// The thickness that a rule was set to.
struct ChosenThickness {
  double tolerance_px = 0;  ///< D50
  Summary across_mm;        ///< of the skin over the image; NaN where it has no place in space
  std::string text(const Settings& settings) const;
  nlohmann::ordered_json json() const;
};

/// Sets the rule; nothing where neither is given. Of a skin that moves: where its motion begins. Throws UsageError for
/// what the rule cannot be set to, and a thickness of a skin without a surface in a rig's world.
std::optional<ChosenThickness> set_thickness(const ThicknessOption& option, const std::string& skin,
                                             const std::optional<calib::Rig>& rig, const MachineProfile& profile,
                                             int image_width, int image_height, Settings& settings);
/// The same for one skin in space.
std::optional<ChosenThickness> set_thickness(const ThicknessOption& option, const RigSkin& skin,
                                             const MachineProfile& profile, const ScanGeometry& geometry,
                                             Settings& settings);

}  // namespace horopter::cli
