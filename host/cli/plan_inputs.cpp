// SPDX-License-Identifier: Apache-2.0
#include "plan_inputs.hpp"

#include <fmt/format.h>

#include "horopter/base/error.hpp"
#include "horopter/monitor/pairing.hpp"
#include "inputs.hpp"
#include "numbers.hpp"

namespace horopter::cli {

const MachineProfile& profile_for(const std::string& rig, const std::string& profile, const calib::Camera& left) {
  const int width = left.width_px;
  const int height = left.height_px;
  if (width == 0 || height == 0) {
    throw FileError(rig, "cameras", "camera " + left.name + " has no image size", "image_size: [width, height]");
  }
  return choose_profile(profile, rig, "cameras", width, height);
}

void refuse_what_has_no_place(const std::string& file) {
  if (is_table(file)) {
    throw FileError(file, "", "a mapping table does not say where its skin is in space",
                    "the skin.yaml that it was made from, and its rig");
  }
  if (is_moving_skin(file)) {
    throw FileError(file, "motion", "what is planned for a surface that moves changes with its motion",
                    "a surface without motion: where it begins, where it ends");
  }
}

Timing TimingOptions::timing(const MachineProfile& profile, Decision decision, int rows) const {
  const double rate = images_per_s > 0 ? images_per_s : profile.takes_fields() ? 50 : 60;
  std::optional<double> exposure_s;
  if (exposure_ms) exposure_s = *exposure_ms * 1e-3;
  if (exposure_s && *exposure_s * rate > 1 + 1e-9) {
    throw UsageError(fmt::format("an exposure of {:g} ms; at {:g} images a second there are {:.2f} ms for one",
                                 *exposure_ms, rate, 1e3 / rate));
  }
  std::optional<double> monitor_s;
  if (monitor_ms) monitor_s = *monitor_ms * 1e-3;
  Timing timing{profile, decision, rows, rate, exposure_s, monitor_s};
  if (monitor_s) timing.longest_periods = monitor::kLongestPeriods;
  return timing;
}

void add_timing(CLI::App& command, TimingOptions& options) {
  command
      .add_option("--frame-rate,--fps", options.images_per_s,
                  "Results a second: frames, or fields of profile field (default: 50 fields, 60 frames)")
      ->check(within(0.1, 10'000, "a second"))
      ->type_name("HZ");
  command
      .add_option("--exposure-ms", options.exposure_ms,
                  "Longest exposure of an image, ms (default: from image to image, the longest that there is)")
      ->check(within(0, 10'000, "ms"))
      ->type_name("MS");
  command
      .add_option("--monitor-ms", options.monitor_ms,
                  "Of a live monitor in place of the hardware: from an image's arrival until its client knows, ms\n"
                  "(docs/monitor.md, How long it takes). In profile field an image comes with its second field")
      ->check(within(0, 60'000, "ms"))
      ->type_name("MS");
  command.add_option("--stopping-ms", options.stopping_ms, "Time that the robot takes to stop after the alarm, ms")
      ->check(within(0, 60'000, "ms"))
      ->capture_default_str()
      ->type_name("MS");
}

}  // namespace horopter::cli
