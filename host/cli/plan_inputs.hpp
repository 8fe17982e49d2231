// SPDX-License-Identifier: Apache-2.0
// What the commands that plan an installation ask for alike.
#pragma once

#include <optional>
#include <string>

#include "commands.hpp"
#include "horopter/base/profile.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/plan/plan.hpp"

namespace horopter::cli {

/// The build that is named, else the smallest that holds the left camera's images. Throws FileError.
const MachineProfile& profile_for(const std::string& rig, const std::string& profile, const calib::Camera& left);

/// Throws FileError for a mapping table, and for a surface that moves: a skin's, a zone's, an obstacle's.
void refuse_what_has_no_place(const std::string& file);

/// How long things take.
struct TimingOptions {
  double images_per_s = 0;  ///< 0: as cameras of the thesis and of today have it
  std::optional<double> exposure_ms;
  std::optional<double> monitor_ms;
  double stopping_ms = 0;

  /// Throws UsageError where an exposure is longer than an image.
  Timing timing(const MachineProfile& profile, Decision decision, int rows) const;
};
/// --frame-rate, --exposure-ms, --monitor-ms and --stopping-ms.
void add_timing(CLI::App& command, TimingOptions& options);

}  // namespace horopter::cli
