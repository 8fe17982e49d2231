// SPDX-License-Identifier: Apache-2.0
#include "alarm_frames.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "horopter/base/error.hpp"
#include "horopter/plan/plan.hpp"
#include "horopter/plan/tolerance.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "inputs.hpp"

namespace horopter::cli {
namespace {

/// D95, across the skin, where it is thinnest.
double thinnest_mm(const std::string& skin, const std::optional<calib::Rig>& rig, const MachineProfile& profile,
                   int image_width, int image_height, const Settings& settings) {
  if (is_table(skin)) {
    throw FileError(skin, "", "more than one frame for an alarm: a mapping table does not say how thick its skin is",
                    "the skin.yaml that it was made from, and its rig");
  }
  if (is_moving_skin(skin)) {
    throw FileError(skin, "motion", "more than one frame for an alarm: this skin moves towards what is in its way",
                    "a skin without motion, or an alarm by one frame");
  }
  const SkinFile file = load_skin_for(skin, rig, image_width, image_height);
  const auto* in_space = dynamic_cast<const RigSkin*>(file.skin.get());
  if (in_space == nullptr) {
    throw FileError(skin, "", fmt::format("more than one frame for an alarm: a {} knows no mm", file.skin->type()),
                    "a surface in the rig's world, or an alarm by one frame");
  }
  try {
    const ThicknessPlan plan = plan_thickness(in_space->cameras(), *in_space->surface(), profile,
                                              scans_of(profile, image_width, image_height).front(), d95_px(settings));
    if (plan.supervised == 0) throw FileError(skin, "", "nothing of the skin is supervised", "a larger skin");
    return plan.across.smallest;
  } catch (const std::invalid_argument& error) {
    throw FileError(skin, "", error.what(), "a skin in front of both cameras");
  }
}

}  // namespace

void add_alarm_frames(CLI::App& command, AlarmFrames& frames) {
  command
      .add_option_function<std::string>(
          "--alarm-frames",
          [&frames](const std::string& text) {
            try {
              frames = AlarmFrames::parse(text);
            } catch (const UsageError& error) {
              throw CLI::ValidationError("--alarm-frames", error.what());
            }
          },
          "Alarm only when N of the last M frames show it, one for each N/M. It must be certain that a hand at 1.6 m/s "
          "is seen so often: needs a rig, a skin that is thick enough, and --frame-rate")
      ->type_name("N/M")
      ->default_str("1/1");
}

void check_alarm_frames(const std::string& skin, const std::optional<calib::Rig>& rig, const MachineProfile& profile,
                        int image_width, int image_height, std::optional<double> results_per_s,
                        const Settings& settings, double longest_periods) {
  const AlarmFrames& frames = settings.alarm_frames;
  if (frames.needed <= 1) return;
  if (!results_per_s) {
    throw UsageError(fmt::format("an alarm by {} of {} frames: how often do frames come? Expected --frame-rate",
                                 frames.needed, frames.of));
  }
  const double mm = thinnest_mm(skin, rig, profile, image_width, image_height, settings);
  const Timing timing{.profile = profile,
                      .images_per_s = *results_per_s,
                      .exposure_s = {},
                      .monitor_s = {},
                      .longest_periods = longest_periods};
  const auto way_mm = [&](int seen) { return kHandSpeed_m_s * 1e3 * timing.longest_s(seen); };
  int seen = 0;
  while (seen < frames.needed && way_mm(seen + 1) <= mm) ++seen;
  if (seen < frames.needed) {
    throw UsageError(fmt::format(
        "an alarm by {} of {} frames: the skin is {:.1f} mm thick where it is thinnest (D95), and a hand at {} m/s moves "
        "{:.1f} mm from one frame to the next{}: it may be seen in {} frames only; expected a skin of {:.1f} mm, or {:.0f} "
        "frames a second, or 1/1",
        frames.needed, frames.of, mm, kHandSpeed_m_s, way_mm(1),
        longest_periods > 1
            ? fmt::format(", which may take {:g} periods without a fault", timing.longest_s() * *results_per_s)
            : "",
        seen, way_mm(frames.needed), std::ceil(*results_per_s * way_mm(frames.needed) / mm)));
  }
}

}  // namespace horopter::cli
