// SPDX-License-Identifier: Apache-2.0
// --alarm-frames: in how many frames of how many an alarm must be seen, where the skin is thick enough for that.
#pragma once

#include <optional>
#include <string>

#include "commands.hpp"
#include "horopter/base/profile.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter::cli {

void add_alarm_frames(CLI::App& command, AlarmFrames& frames);

/// Throws UsageError or FileError where a hand at 1.6 m/s could cross the skin where it is thinnest (D95 of the rule's
/// settings) without being seen in so many frames, or where nobody can tell: without a number of results a second, with
/// a table alone, with a skin that is no surface in a rig's world, or that moves. Images may be `longest_periods` apart.
void check_alarm_frames(const std::string& skin, const std::optional<calib::Rig>& rig, const MachineProfile& profile,
                        int image_width, int image_height, std::optional<double> results_per_s,
                        const Settings& settings, double longest_periods = 1);

}  // namespace horopter::cli
