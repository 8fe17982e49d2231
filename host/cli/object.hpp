// SPDX-License-Identifier: Apache-2.0
// --object: how large an object on the skin must be to be an alarm.
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "horopter/base/profile.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/map/map.hpp"

namespace horopter::cli {

/// What was asked for: px, or mm of a body that is to be found wherever it is in the skin.
struct ObjectOption {
  double px = Settings().object_px;
  std::optional<double> mm;
  bool given = false;  ///< else the usual one: set_object() says which
};

void add_object(CLI::App& command, ObjectOption& option);

/// Sets settings.object_px and object_mm. A body of so many mm has the fewest px where the skin is farthest away. Where
/// nothing was asked for and the skin knows mm, it is 40 mm, or the smallest body that can be found. Returns what holds. Throws
/// FileError where mm were asked for, of a skin without a surface in a rig's world, of one that moves, or of a table
/// without a rig; UsageError for less than an object can be, or more than fits into the image.
[[nodiscard]] ObjectOption set_object(const ObjectOption& asked, const std::string& skin,
                                      const std::optional<calib::Rig>& rig, const MachineProfile& profile,
                                      int image_width, int image_height, Settings& settings);

/// What the rule can judge of a skin, in the table of which it can judge the least.
struct Judgeable {
  std::int64_t pixels = std::numeric_limits<std::int64_t>::max();  ///< of the result
  double mm2 = std::numeric_limits<double>::infinity();            ///< known where the limit is an area
};

/// Throws FileError where an object was asked for that takes more than the rule can judge: none would be an alarm. Where a
/// table knows no areas, settings.object_mm becomes 0: pixels are the limit. Says on standard error where over half of the
/// skin no object shows enough, in the worst table; of a motion of more than 32 tables so many are looked at, evenly from
/// the first to the last.
Judgeable check_object_limit(const ObjectOption& option, const std::string& skin,
                             const std::vector<const MapTable*>& tables, const MachineProfile& profile,
                             Settings& settings);

/// "72 px across, 2036 pixels of the result", with mm where they were asked for; and whether so many can be judged,
/// where a table says it.
std::string object_text(const ObjectOption& option, const Settings& settings, const MachineProfile& profile,
                        const Judgeable& judgeable = {});
/// The same for programs.
nlohmann::ordered_json object_json(const Settings& settings, const MachineProfile& profile, const Judgeable& judgeable);

}  // namespace horopter::cli
